// The impulses that a step has given to models: the sums over all bodies by model, in the order of the bodies. A body
// can be taken out again, for the time of the impulses on its models.
#pragma once

#include "solver/contact/impulses.h"

namespace gphys {

class ImpulseSums {
public:
    explicit ImpulseSums(std::pmr::memory_resource* memory) : parts_(memory), sums_(memory) {}

    /// Memory for this many impulses of bodies on models. Throws std::bad_alloc.
    void reserve(size_t count) {
        parts_.reserve(count);
        sums_.reserve(count);
    }
    // Anew, in reserved memory: clear, add each body in the order of slots, sum.
    void clear() {
        parts_.clear();
        sums_.clear();
    }
    void add(uint32_t slot, const Vector<ModelImpulse>& impulses) {
        for (const ModelImpulse& impulse : impulses) parts_.push_back({slot, impulse});
    }
    void sum();

    /// Takes out a body with the impulses that were added of it. The sums get the bits that they would have without it.
    void remove(uint32_t slot, const Vector<ModelImpulse>& impulses);

    /// visit(const ModelImpulse&)
    template <class Visit>
    void each(Visit&& visit) const {
        for (const Sum& sum : sums_) {
            if (sum.parts > 0) visit(sum.total);
        }
    }

private:
    /// The impulse of one body on one model.
    struct Part {
        uint32_t slot;
        ModelImpulse impulse;

        bool operator<(const Part& other) const {
            return impulse.model != other.impulse.model ? impulse.model < other.impulse.model : slot < other.slot;
        }
    };
    struct Sum {
        ModelImpulse total;
        uint32_t first, end;  // of its parts, also of those taken out
        uint32_t parts;       // left
    };
    static constexpr uint32_t taken_out = 0xffffffff;  // as a slot

    void sum_parts(Sum& sum) const;

    Vector<Part> parts_;  // by model and body
    Vector<Sum> sums_;    // by model
};

}  // namespace gphys
