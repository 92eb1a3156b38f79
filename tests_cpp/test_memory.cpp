#include "foundation/memory.h"

#include <cstring>

#include "resources.h"
#include "test.h"

using namespace gphys;

namespace {

/// From one block, one after the other without a gap, as a heap may.
class Adjoining final : public std::pmr::memory_resource {
public:
    size_t given_back = 0;

private:
    void* do_allocate(size_t size, size_t alignment) override {
        used_ = (used_ + alignment - 1) / alignment * alignment;
        void* place = block_ + used_;
        used_ += size;
        REQUIRE(used_ <= sizeof block_);
        return place;
    }
    void do_deallocate(void* memory, size_t size, size_t) override {
        REQUIRE(memory >= block_);
        std::memset(memory, 0, size);
        given_back += size;
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    alignas(4096) std::byte block_[1 << 16];
    size_t used_ = 0;
};

}  // namespace

TEST_CASE("rooms of threads share no page, and begin with a line") {
    Adjoining heap;
    ThreadArena memory(&heap);
    constexpr size_t page = 4096;
    size_t taken = 0;
    uintptr_t end_before = 0;
    for (const size_t size : {1000, 24, 5000, 8}) {
        void* room = memory.allocate(size, 8);
        std::memset(room, 1, size);
        const uintptr_t first = reinterpret_cast<uintptr_t>(room);
        CHECK(first % 64 == 0);
        if (end_before != 0) CHECK(first / page > (end_before - 1) / page);
        end_before = first + size;
        memory.deallocate(room, size, 8);
        taken += size + 2 * ThreadArena::margin;
    }
    CHECK(heap.given_back == taken);
}

TEST_CASE("what one object has allocated another cannot give back") {
    const Memory memory(nullptr), other(nullptr);
    CHECK(memory.is_equal(memory));
    CHECK_FALSE(memory.is_equal(other));
    test::WatchedMemory heap;
    const ThreadArena rooms(&heap), more_rooms(&heap);
    CHECK(rooms.is_equal(rooms));
    CHECK_FALSE(rooms.is_equal(more_rooms));
}

TEST_CASE("a room that cannot be had is refused") {
    test::WatchedMemory heap;
    ThreadArena memory(&heap);
    heap.fail_at = 0;
    CHECK_THROWS_AS(memory.allocate(100, 8), std::bad_alloc);
    CHECK(heap.bytes_in_use == 0);
}
