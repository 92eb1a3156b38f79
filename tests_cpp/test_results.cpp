#include "foundation/results.h"

#include <vector>

#include "meshes.h"
#include "scene/slot_set.h"
#include "test.h"

using namespace gphys;

TEST_CASE("Smallest keeps the smallest values in ascending order, whatever the order of arrival") {
    test::Random random(1);
    for (uint32_t count = 0; count < 40; ++count) {
        for (uint32_t capacity = 0; capacity < 45; ++capacity) {
            std::vector<uint32_t> values(count);
            uint32_t next = 0;
            for (uint32_t& value : values) value = 0x8888888u * random.index(30) + next++;  // from 0 to almost 2^32
            std::vector<uint32_t> out(capacity + 1, 12345);
            Smallest<uint32_t> smallest(capacity ? out.data() : nullptr, capacity);
            for (uint32_t value : values) smallest.add(value);
            REQUIRE(smallest.full() == (capacity > 0 && count >= capacity));
            std::sort(values.begin(), values.end());
            const uint32_t kept = std::min(count, capacity);
            if (smallest.full()) REQUIRE(smallest.largest() == values[kept - 1]);
            REQUIRE(smallest.finish() == count);
            REQUIRE(std::equal(out.begin(), out.begin() + kept, values.begin()));
            REQUIRE(out[kept] == 12345);
        }
    }
}

TEST_CASE("Smallest leaves out what it is told not to add") {
    test::Random random(2);
    for (uint32_t count = 0; count < 60; ++count) {
        for (uint32_t capacity : {0u, 1u, 7u, 31u, 32u, 33u, 70u}) {
            std::vector<uint32_t> added, out(capacity + 1, 12345);
            Smallest<uint32_t> smallest(capacity ? out.data() : nullptr, capacity);
            for (uint32_t i = 0; i < count; ++i) {
                const uint32_t value = random.index(50) << 8 | i;
                const bool is_one = random.index(3) > 0;
                smallest.add_if(is_one, value);
                if (is_one) added.push_back(value);
            }
            std::sort(added.begin(), added.end());
            REQUIRE(smallest.finish() == added.size());
            const size_t kept = std::min<size_t>(added.size(), capacity);
            REQUIRE(std::equal(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(kept), added.begin()));
            REQUIRE(std::count(out.begin() + static_cast<std::ptrdiff_t>(kept), out.end(), 12345) ==
                    static_cast<std::ptrdiff_t>(capacity + 1 - kept));
        }
    }
}

TEST_CASE("Smallest takes any order") {
    int out[3];
    Smallest<int, std::greater<int>> largest(out, 3);
    for (int value : {4, 9, -2, 7, 1, 9}) largest.add(value);
    REQUIRE(largest.finish() == 6);
    REQUIRE((out[0] == 9 && out[1] == 9 && out[2] == 7));
}

TEST_CASE("distinct values are sorted, whatever their number and range") {
    test::Random random(6);
    for (const uint32_t count : {0u, 1u, 2u, 31u, 33u, 100u, 1000u, 200000u}) {
        for (const uint32_t bits : {1u, 7u, 16u, 17u, 18u, 21u, 26u, 32u}) {
            for (const uint32_t common : {0u, 0x01000000u, 0xffff0000u}) {
                INFO(count << " of " << bits << " bits");
                const uint32_t mask = bits == 32 ? ~0u : (1u << bits) - 1;
                std::vector<uint32_t> values(count);
                for (uint32_t& value : values) value = (random.index(~0u) & mask) | common;
                for (uint32_t i = 0; i < count / 2; ++i) values[i] = (i & mask) | common;
                std::sort(values.begin(), values.end());
                values.erase(std::unique(values.begin(), values.end()), values.end());
                std::vector<uint32_t> mixed;
                for (const uint32_t value : values) {
                    mixed.push_back(value);
                    std::swap(mixed.back(), mixed[random.index(static_cast<uint32_t>(mixed.size()))]);
                }
                for (const size_t more : {0, 1, 2000, 5000}) {
                    std::vector<uint32_t> sorted(mixed);
                    sorted.resize(mixed.size() + more);
                    sorted.push_back(12345);
                    sort_distinct(sorted.data(), static_cast<uint32_t>(mixed.size()),
                                  static_cast<uint32_t>(mixed.size() + more));
                    REQUIRE(sorted.back() == 12345);
                    sorted.resize(mixed.size());
                    REQUIRE(sorted == values);
                }
            }
        }
    }
}

TEST_CASE("a set of slots whose words are in the list's place lists all entries, or says that it cannot") {
    test::Random random(9);
    int listed = 0, refused = 0;
    for (int round = 0; round < 2000; ++round) {
        const uint32_t slots = 100 + random.index(3000), words = SlotSet::words_for(slots);
        const double first = random.uniform(0, 0.1), second = random.uniform(0, 0.1);
        std::vector<uint32_t> entries(slots), expected;
        for (uint32_t& entry : entries) entry = random.index(0xffffffff);
        std::vector<uint32_t> added;
        for (uint32_t slot = 0; slot < slots; ++slot) {
            if (random.uniform(0, 1) < (slot < slots / 2 ? first : second)) added.push_back(slot);
        }
        for (const uint32_t slot : added) expected.push_back(entries[slot]);
        const uint32_t room = random.index(static_cast<uint32_t>(added.size()) + 1);
        if (room + words < added.size()) continue;
        std::vector<uint32_t> out(room + words);
        SlotSet set(out.data() + room, slots);
        for (const uint32_t slot : added) set.add(slot);
        if (set.list_over_words(entries.data(), out.data())) {
            REQUIRE(std::equal(expected.begin(), expected.end(), out.begin()));
            ++listed;
        } else {
            ++refused;
        }
    }
    CHECK(listed > 500);
    CHECK(refused > 100);
}

TEST_CASE("a set of slots lists their entries by ascending slots, on any instruction set, and spares what is behind") {
    test::Random random(5);
    for (int round = 0; round < 300; ++round) {
        const uint32_t slots = random.index(200), untouched = 0xabcdef01;
        const double share = random.uniform(0, 1);
        std::vector<uint32_t> entries(slots), added, expected;
        for (uint32_t& entry : entries) entry = random.index(0xffffffff);
        for (uint32_t slot = 0; slot < slots; ++slot) {
            if (random.uniform(0, 1) > share) continue;
            added.insert(added.begin() + random.index(static_cast<uint32_t>(added.size()) + 1), slot);
            expected.push_back(entries[slot]);
        }
        for (const Isa isa : test::isas()) {
            std::vector<uint32_t> words(SlotSet::words_for(slots), ~0u);
            SlotSet set(words.data(), slots);
            for (const uint32_t slot : added) set.add(slot);
            for (const size_t more : {0, 1, 40}) {
                std::vector<uint32_t> out(added.size() + more + 1, untouched);
                const auto room = static_cast<uint32_t>(added.size() + more);
                const uint32_t* const end = set.list(slot_set_kernels(isa), entries.data(), out.data(), room);
                REQUIRE(end == out.data() + added.size());
                REQUIRE(std::equal(expected.begin(), expected.end(), out.begin()));
                REQUIRE(out.back() == untouched);
            }
        }
    }
}
