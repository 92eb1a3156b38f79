#include "foundation/pool.h"

#include <map>

#include "test.h"

using namespace gphys;

TEST_CASE("a pool keeps its records in place and uses freed places again") {
    Memory memory(nullptr);
    Pool<gphys_aabb> pool(&memory);
    test::Random random(34);
    std::map<uint32_t, float> expected;
    size_t most = 0;
    for (int step = 0; step < 5000; ++step) {
        if (expected.empty() || random.index(100) < 52) {
            const float value = random.uniform_float(0, 1);
            const uint32_t index = pool.add({{value, 0, 0}, {0, 0, value}});
            REQUIRE(expected.count(index) == 0);
            expected[index] = value;
            most = std::max(most, expected.size());
            REQUIRE(index < most);
        } else {
            const auto victim = std::next(expected.begin(), random.index(static_cast<uint32_t>(expected.size())));
            pool.remove(victim->first);
            expected.erase(victim);
        }
        REQUIRE(pool.size() == expected.size());
    }
    for (const auto& [index, value] : expected) {
        REQUIRE(pool[index].min.x == value);
        REQUIRE(pool[index].max.z == value);
    }
    pool.clear();
    CHECK(pool.size() == 0);
    CHECK(pool.add({}) == 0);
}
