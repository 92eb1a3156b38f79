// Memory for work that is spread over many calls, none of which may wait for the system: large blocks have small pages
// at first (pages::HugePages), and are unmapped a part at a time.
#pragma once

#include "foundation/memory.h"
#include "foundation/pages.h"

namespace gphys {

class GradualMemory final : public std::pmr::memory_resource {
public:
    /// Blocks below pages::least are of `memory`; without may_map, or pages of the system, all are.
    GradualMemory(std::pmr::memory_resource* memory, bool may_map)
        : memory_(memory), may_map_(may_map && pages::exist) {}
    GradualMemory(const GradualMemory&) = delete;
    GradualMemory& operator=(const GradualMemory&) = delete;
    ~GradualMemory() override {
        while (unmap_part()) {
        }
    }

    /// Takes over a mapping that is not used any more.
    void discard(void* mapped, std::size_t size) noexcept;
    /// Unmaps a part of what was freed or discarded, in some 25 microseconds. False: nothing is left.
    bool unmap_part() noexcept;

private:
    struct Mapping {
        void* memory;
        std::size_t size;
    };

    bool is_mapped(std::size_t size) const { return may_map_ && size >= pages::least; }
    void* do_allocate(std::size_t size, std::size_t alignment) override;
    void do_deallocate(void* memory, std::size_t size, std::size_t alignment) override;
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    std::pmr::memory_resource* memory_;
    bool may_map_;
    Mapping unused_[8];
    std::size_t unused_count_ = 0;
};

}  // namespace gphys
