#include <deque>
#include <set>

#include "foundation/ids.h"
#include "test.h"

using namespace gphys;

TEST_CASE("a freed slot is reused last and under another generation") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    const uint32_t a = ids.add(), b = ids.add(), c = ids.add();
    ids.remove(b);
    ids.remove(a);
    CHECK_FALSE(ids.has(a));
    CHECK_FALSE(ids.has(b));
    CHECK(ids.has(c));
    const uint32_t b2 = ids.add(), a2 = ids.add(), d = ids.add();
    CHECK(IdTable::slot_of(b2) == IdTable::slot_of(b));
    CHECK(IdTable::slot_of(a2) == IdTable::slot_of(a));
    CHECK(IdTable::slot_of(d) == 3);
    CHECK_FALSE(ids.has(a));
    CHECK_FALSE(ids.has(b));
    CHECK(ids.size() == 4);
    CHECK(ids.defect() == nullptr);
}

TEST_CASE("an id comes back only after its slot was reused 255 times and is never 0") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    const uint32_t first = ids.add();
    uint32_t id = first;
    for (int reuse = 1; reuse < 255; ++reuse) {
        ids.remove(id);
        CHECK_FALSE(ids.has(first));
        id = ids.add();
        REQUIRE(id >> 24 != 0);
        REQUIRE(id != first);
    }
    ids.remove(id);
    CHECK(ids.add() == first);
    CHECK_FALSE(ids.has(0));
}

TEST_CASE("guessed ids of free and unknown slots are not found") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    const uint32_t a = ids.add(), b = ids.add();
    ids.remove(a);
    ids.remove(b);
    for (uint32_t generation = 0; generation < 256; ++generation) {
        CHECK_FALSE(ids.has(generation << 24));
        CHECK_FALSE(ids.has(generation << 24 | 1));
        CHECK_FALSE(ids.has(generation << 24 | 2));
        CHECK_FALSE(ids.has(generation << 24 | IdTable::capacity));
    }
}

TEST_CASE("ids agree with a queue of free slots kept beside them") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    test::Random random(3);
    std::vector<uint32_t> live;
    std::set<uint32_t> stale;
    std::deque<uint32_t> free_slots;
    for (int step = 0; step < 20000; ++step) {
        if (live.empty() || random.uniform(0, 1) < 0.52) {
            const uint32_t id = ids.add();
            if (free_slots.empty()) {
                REQUIRE(IdTable::slot_of(id) == live.size());
            } else {
                REQUIRE(IdTable::slot_of(id) == free_slots.front());
                free_slots.pop_front();
            }
            stale.erase(id);
            live.push_back(id);
        } else {
            const uint32_t k = random.index(static_cast<uint32_t>(live.size()));
            ids.remove(live[k]);
            free_slots.push_back(IdTable::slot_of(live[k]));
            stale.insert(live[k]);
            live.erase(live.begin() + k);
        }
    }
    REQUIRE(ids.defect() == nullptr);
    for (uint32_t id : live) REQUIRE(ids.has(id));
    for (uint32_t id : stale) REQUIRE_FALSE(ids.has(id));
}

TEST_CASE("ids are refused beyond 2^24 - 1, not wrapped") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    CHECK(ids.reserve(IdTable::capacity));
    CHECK_FALSE(ids.reserve(IdTable::capacity + 1));
    ids.add();
    CHECK_FALSE(ids.reserve(IdTable::capacity));
}
