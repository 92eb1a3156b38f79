// Memory for an object that is made later, or not at all. std::optional is for small ones: compilers clear its memory
// first, which for some kilobytes takes longer than what is then done.
#pragma once

#include <new>
#include <utility>

namespace gphys {

template <class T>
class MadeLater {
public:
    MadeLater() {}  // not constexpr, which would clear the memory
    MadeLater(const MadeLater&) = delete;
    MadeLater& operator=(const MadeLater&) = delete;
    ~MadeLater() { reset(); }

    template <class... Args>
    T& emplace(Args&&... args) {
        reset();
        new (&value_) T(std::forward<Args>(args)...);
        made_ = true;
        return value_;
    }
    void reset() {
        if (made_) value_.~T();
        made_ = false;
    }

    explicit operator bool() const { return made_; }
    T& operator*() { return value_; }
    T* operator->() { return &value_; }

private:
    union {
        T value_;
    };
    bool made_ = false;
};

}  // namespace gphys
