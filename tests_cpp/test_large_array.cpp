#include "foundation/large_array.h"

#include <algorithm>

#include "resources.h"
#include "test.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

using namespace gphys;

namespace {

#if defined(__linux__)

/// Whether the page of this byte is in memory.
bool is_resident(unsigned char* byte) {
    constexpr size_t page = 4096;  // of every system that has huge pages of 2 MiB
    unsigned char resident = 0;
    const auto misplaced = reinterpret_cast<std::uintptr_t>(byte) % page;
    return mincore(byte - misplaced, page, &resident) == 0 && (resident & 1) != 0;
}

#endif

struct Record {
    uint64_t words[8];
};

Record record(uint64_t i) { return {{i, i + 1, i + 2, i + 3, i + 4, i + 5, i + 6, i + 7}}; }

/// The number of the first that is not what was added.
template <class Array>
size_t first_wrong(const Array& array) {
    for (size_t i = 0; i < array.size(); ++i) {
        for (uint64_t k = 0; k < 8; ++k) {
            if (array[i].words[k] != i + k) return i;
        }
    }
    return array.size();
}

}  // namespace

TEST_CASE("a large array keeps its records while it grows from nothing to many pages, with hooks and without") {
    Memory own(nullptr);
    test::WatchedMemory watched;
    const auto fill = [](auto* memory) {
        LargeArray<Record> array(memory);
        CHECK(array.empty());
        constexpr size_t count = 200000;
        static_assert(count * sizeof(Record) > 4 * pages::huge_page);
        size_t moved = 0;
        for (size_t i = 0; i < count; ++i) {
            const Record* const before = array.data();
            array.push_back(record(i));
            moved += array.data() != before;
            if ((i & (i - 1)) == 0) CHECK(first_wrong(array) == i + 1);
        }
        CHECK(first_wrong(array) == count);
        CHECK(array.capacity() <= count + count / 8);
        CHECK(moved < 100);
        return moved;
    };
    fill(&own);
    fill(&watched);
    CHECK(watched.bytes_in_use == 0);
}

TEST_CASE("a large array is resized, exchanged, moved and copied") {
    Memory memory(nullptr);
    LargeArray<uint32_t> array(&memory), empty = array.alike();
    for (const size_t count : {size_t{3}, size_t{1} << 20, size_t{100}}) {
        array.resize(count, 7);
        CHECK(array.size() == count);
        CHECK(std::all_of(array.begin(), array.end(), [](uint32_t n) { return n == 7; }));
    }
    CHECK(array.capacity() == size_t{1} << 20);
    array.push_back(array[0]);
    CHECK(array[100] == 7);
    array.swap(empty);
    CHECK(array.empty());
    CHECK(empty.size() == 101);
    LargeArray<uint32_t> moved(std::move(empty));
    CHECK(moved.size() == 101);
    array = std::move(moved);
    CHECK(array.size() == 101);
    CHECK(array[100] == 7);
    LargeArray<uint32_t> copy(array);
    array.clear();
    CHECK(array.empty());
    CHECK(copy.size() == 101);
    array = copy;
    CHECK(array.size() == 101);
    CHECK(array[99] == 7);
    CHECK(array.data() != copy.data());
}

TEST_CASE("a large array that cannot grow is as it was") {
    test::WatchedMemory memory;
    LargeArray<Record> array(&memory);
    for (size_t i = 0; i < 10000; ++i) array.push_back(record(i));
    const size_t capacity = array.capacity();
    memory.fail_at = memory.allocations;
    CHECK_THROWS_AS(array.reserve(capacity + 1), std::bad_alloc);
    CHECK_THROWS_AS(reserve_more(array, capacity), std::bad_alloc);
    CHECK_THROWS_AS(array.reserve(static_cast<size_t>(-1) / 4), std::bad_alloc);
    CHECK(array.capacity() == capacity);
    CHECK(first_wrong(array) == 10000);
}

#if defined(__linux__)

TEST_CASE("pages move with what is in them, also where they become huge ones, and new ones are zero") {
    const auto huge = GENERATE(pages::HugePages::at_once, pages::HugePages::later);
    size_t size = pages::least;
    auto* memory = static_cast<unsigned char*>(pages::map(size, huge));
    REQUIRE(memory != nullptr);
    std::fill(memory, memory + size, static_cast<unsigned char>(1));
    while (size < 5 * pages::huge_page) {
        const size_t larger = size + size / 3;
        memory = static_cast<unsigned char*>(pages::grow(memory, size, larger, huge));
        REQUIRE(memory != nullptr);
        CHECK(std::all_of(memory, memory + size, [](unsigned char byte) { return byte == 1; }));
        CHECK(std::all_of(memory + size, memory + larger, [](unsigned char byte) { return byte == 0; }));
        std::fill(memory + size, memory + larger, static_cast<unsigned char>(1));
        size = larger;
    }
    // More than there are addresses.
    CHECK(pages::grow(memory, size, size_t{1} << 50, huge) == nullptr);
    CHECK(pages::map(size_t{1} << 50, huge) == nullptr);
    CHECK(std::all_of(memory, memory + size, [](unsigned char byte) { return byte == 1; }));
    pages::unmap(memory, size);
}

TEST_CASE("an access to memory that is to have huge pages later waits for a small one only") {
    constexpr size_t size = 4 * pages::huge_page, middle = pages::huge_page / 2, distance = size_t{1} << 17;
    // Pages around an access may become present with it: up to 64 KiB, and all of a huge one.
    const auto brings_huge_page = [](unsigned char* memory, size_t at) {
        memory[at + middle] = 1;
        return is_resident(memory + at + middle + distance);
    };
    auto* memory = static_cast<unsigned char*>(pages::map(size, pages::HugePages::later));
    REQUIRE(memory != nullptr);
    for (size_t at = 0; at < size; at += pages::huge_page) CHECK(!brings_huge_page(memory, at));
    memory = static_cast<unsigned char*>(pages::grow(memory, size, 2 * size, pages::HugePages::later));
    REQUIRE(memory != nullptr);
    for (size_t at = size; at < 2 * size; at += pages::huge_page) CHECK(!brings_huge_page(memory, at));
    pages::unmap(memory, 2 * size);
}

TEST_CASE("gradual memory gives large blocks back in parts, and what it discards with them") {
    Memory own(nullptr);
    GradualMemory memory(&own, true);
    CHECK(!memory.unmap_part());
    LargeArray<Record> array(&own);
    for (size_t i = 0; i < 100000; ++i) array.push_back(record(i));
    Record* const records = array.data();
    array.discard_to(memory);
    CHECK(array.empty());
    CHECK(array.capacity() == 0);
    {
        Vector<Record> vector(100000, record(1), &memory);
        CHECK(vector.back().words[7] == 8);
    }
    CHECK(is_resident(reinterpret_cast<unsigned char*>(records)));
    size_t parts = 0;
    while (memory.unmap_part()) ++parts;
    CHECK(parts >= 20);
    CHECK(!is_resident(reinterpret_cast<unsigned char*>(records)));
    // Small ones, and all where the caller has set hooks, are of the other memory.
    test::WatchedMemory watched;
    GradualMemory hooked(&watched, false);
    for (const size_t count : {size_t{10}, size_t{100000}}) {
        { Vector<Record> vector(count, record(1), &hooked); }
        CHECK(watched.bytes_in_use == 0);
        CHECK(!hooked.unmap_part());
    }
    array.push_back(record(0));
    array.discard_to(memory);
    CHECK(!memory.unmap_part());
}

TEST_CASE("pages that cannot move stay as they are, and leave no addresses taken") {
    constexpr size_t size = 4 * pages::least;
    auto* memory = static_cast<unsigned char*>(pages::map(size, pages::HugePages::at_once));
    REQUIRE(memory != nullptr);
    std::fill(memory, memory + size, static_cast<unsigned char>(1));
    // mremap moves no range of pages with different protections.
    REQUIRE(mprotect(memory + size / 2, size / 2, PROT_READ) == 0);
    // A thousand times the larger size is more than there are addresses, 2^47.
    constexpr size_t larger = size_t{1} << 38;
    for (int i = 0; i < 1000; ++i) REQUIRE(pages::grow(memory, size, larger, pages::HugePages::later) == nullptr);
    void* const left = mmap(nullptr, larger, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    REQUIRE(left != MAP_FAILED);
    munmap(left, larger);
    CHECK(std::all_of(memory, memory + size, [](unsigned char byte) { return byte == 1; }));
    pages::unmap(memory, size);
}

#endif
