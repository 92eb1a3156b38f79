#include <algorithm>
#include <deque>
#include <set>

#include "foundation/ids.h"
#include "test.h"

using namespace gphys;

namespace {

/// Let so many slots come free that the next to be taken is one that was used.
void fill_queue(IdTable& ids) {
    std::vector<uint32_t> added(IdTable::least_free);
    for (uint32_t& id : added) id = ids.add();
    for (const uint32_t id : added) ids.remove(id);
}

/// The words of a table, to be changed.
struct Words {
    std::vector<uint32_t> entries, values;
    size_t next = 0;

    struct Reader {
        Words& words;

        void array(const LargeArray<uint32_t>& from) { words.entries.assign(from.begin(), from.end()); }
        void value(uint32_t from) { words.values.push_back(from); }
    };
    struct Writer {
        Words& words;

        void array(LargeArray<uint32_t>& to) {
            to.resize(words.entries.size());
            std::copy(words.entries.begin(), words.entries.end(), to.begin());
        }
        void value(uint32_t& to) { to = words.values[words.next++]; }
    };

    explicit Words(const IdTable& ids) {
        Reader reader{*this};
        IdTable::visit(reader, ids);
    }
    bool make_sound_table() {
        Memory memory(nullptr);
        IdTable ids(&memory);
        Writer writer{*this};
        next = 0;
        IdTable::visit(writer, ids);
        return ids.defect() == nullptr;
    }
};

}  // namespace

TEST_CASE("a freed slot is used again after all that were freed before, under another generation") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    const uint32_t a = ids.add(), b = ids.add(), c = ids.add();
    ids.remove(b);
    ids.remove(a);
    fill_queue(ids);
    CHECK_FALSE(ids.has(a));
    CHECK_FALSE(ids.has(b));
    CHECK(ids.has(c));
    const uint32_t b2 = ids.add(), a2 = ids.add();
    CHECK(IdTable::slot_of(b2) == IdTable::slot_of(b));
    CHECK(IdTable::slot_of(a2) == IdTable::slot_of(a));
    CHECK_FALSE(ids.has(a));
    CHECK_FALSE(ids.has(b));
    CHECK(ids.size() == 3);
    CHECK(ids.defect() == nullptr);
}

TEST_CASE("one that comes and goes takes 1024 slots in turn, and its id comes back after 261 120 additions") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    for (int i = 0; i < 100; ++i) ids.add();
    const uint32_t first = ids.add();
    ids.remove(first);
    bool found = false, is_zero = false;
    uint32_t id = 0;
    long additions = 0;
    while (id != first && additions < 1000000) {
        found |= ids.has(first);
        id = ids.add();
        ++additions;
        is_zero |= id >> 24 == 0;
        if (id != first) ids.remove(id);
    }
    CHECK(additions == 255 * 1024);
    CHECK_FALSE(found);
    CHECK_FALSE(is_zero);
    CHECK_FALSE(ids.has(0));
    CHECK(ids.slots() == 100 + 1024);
    CHECK(ids.defect() == nullptr);
}

TEST_CASE("the first id of a long queue comes back after 254 times 1024 additions and one") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    std::vector<uint32_t> live(2000);
    for (uint32_t& id : live) id = ids.add();
    const uint32_t first = live[0];
    for (uint32_t i = 0; i < IdTable::least_free; ++i) ids.remove(live[i]);
    long additions = 0;
    for (uint32_t id = 0; id != first && additions < 1000000; ++additions) {
        id = ids.add();
        if (id != first) ids.remove(id);
    }
    CHECK(additions == 254 * 1024 + 1);
}

TEST_CASE("slots are at most 1023 more than were ever in use at a time") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    test::Random random(7);
    std::vector<uint32_t> live;
    uint32_t most = 0;
    bool bounded = true;
    for (int round = 0; round < 300; ++round) {
        for (uint32_t i = random.index(700); i > 0; --i) live.push_back(ids.add());
        most = std::max(most, ids.size());
        bounded &= ids.slots() <= IdTable::slots_for(most);
        for (uint32_t i = random.index(700); i > 0 && !live.empty(); --i) {
            const uint32_t k = random.index(static_cast<uint32_t>(live.size()));
            ids.remove(live[k]);
            live[k] = live.back();
            live.pop_back();
        }
    }
    CHECK(bounded);
    CHECK(most < 40000);
    CHECK(ids.slots() > most);
    CHECK(ids.defect() == nullptr);
}

TEST_CASE("the slots of the next additions are known before, and room for them is enough") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    test::Random random(8);
    std::vector<uint32_t> live;
    bool agree = true, moved = false;
    for (int round = 0; round < 400; ++round) {
        const uint32_t count = random.index(40) == 0 ? 3000 : random.index(300);
        std::vector<uint32_t> slots(count);
        REQUIRE(ids.reserve(count));
        ids.next_slots(count, slots.data());
        const uint32_t* const place = ids.ids();
        for (uint32_t i = 0; i < count; ++i) {
            live.push_back(ids.add());
            agree &= IdTable::slot_of(live.back()) == slots[i];
        }
        moved |= ids.ids() != place;
        const bool all = random.index(4) == 0;
        while (!live.empty() && (all || random.index(300) != 0)) {
            ids.remove(live.back());
            live.pop_back();
        }
    }
    CHECK(agree);
    CHECK_FALSE(moved);
    CHECK(ids.defect() == nullptr);
}

TEST_CASE("a full table uses slots again at once") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    REQUIRE(ids.reserve(IdTable::capacity));
    for (uint32_t i = 0; i < IdTable::capacity - 3; ++i) ids.add();
    const uint32_t gone[2] = {5, 3};
    for (const uint32_t slot : gone) ids.remove(ids.id(slot));
    // Three new ones, then the two in the queue.
    REQUIRE(ids.reserve(5));
    CHECK_FALSE(ids.reserve(6));
    uint32_t slots[5];
    ids.next_slots(5, slots);
    const uint32_t last = IdTable::capacity - 1, expected[5] = {last - 2, last - 1, last, 5, 3};
    for (int i = 0; i < 5; ++i) {
        CHECK(slots[i] == expected[i]);
        CHECK(IdTable::slot_of(ids.add()) == expected[i]);
    }
    CHECK(ids.size() == IdTable::capacity);
    CHECK(ids.slots() == IdTable::capacity);
    CHECK_FALSE(ids.reserve(1));
    const uint32_t id = ids.id(77);
    ids.remove(id);
    REQUIRE(ids.reserve(1));
    const uint32_t again = ids.add();
    CHECK(IdTable::slot_of(again) == 77);
    CHECK(again != id);
    CHECK(ids.defect() == nullptr);
}

TEST_CASE("a table whose queue of free slots is damaged is recognised") {
    Memory memory(nullptr);
    IdTable ids(&memory);
    std::vector<uint32_t> added(10);
    for (uint32_t& id : added) id = ids.add();
    for (const uint32_t slot : {2u, 4u, 6u, 8u}) ids.remove(added[slot]);
    REQUIRE(Words(ids).make_sound_table());
    constexpr uint32_t generation = 2u << 24;
    {
        Words circle(ids);  // 2, 4, 2, 4: the right number of steps, and it ends where it should
        circle.entries[4] = generation | 2;
        circle.values[3] = 4;
        CHECK_FALSE(circle.make_sound_table());
    }
    {
        Words early(ids);
        early.values[3] = 6;
        CHECK_FALSE(early.make_sound_table());
    }
    {
        Words live(ids);
        live.entries[4] = generation | 5;
        CHECK_FALSE(live.make_sound_table());
    }
    {
        Words beyond(ids);
        beyond.entries[4] = generation | 10;
        CHECK_FALSE(beyond.make_sound_table());
    }
    {
        Words count(ids);
        ++count.values[0];
        CHECK_FALSE(count.make_sound_table());
    }
}

TEST_CASE("a table of more slots than ids can name is recognised") {
    // All free, in a queue through the last slot that has a name; the one beyond is counted, too.
    Memory memory(nullptr);
    Words words{IdTable(&memory)};
    constexpr uint32_t slots = IdTable::capacity + 1, generation = 1u << 24;
    for (uint32_t slot = 0; slot < slots; ++slot) words.entries.push_back(generation | ((slot + 1) & 0xffffff));
    words.values = {0, slots, 0, IdTable::capacity};
    CHECK_FALSE(words.make_sound_table());
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
    for (int step = 0; step < 60000; ++step) {
        if (live.empty() || random.uniform(0, 1) < 0.52) {
            const uint32_t id = ids.add();
            if (free_slots.size() < IdTable::least_free) {
                REQUIRE(IdTable::slot_of(id) == live.size() + free_slots.size());
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
