// To which pins particles of cloth are limited, against all pins one by one.
#include <cmath>

#include "solver/body.h"
#include "test.h"

using namespace gphys;

TEST_CASE("particles of a flat sheet are limited to the pins that are nearest in it") {
    std::mt19937 random(1);
    const auto below = [&](uint32_t n) { return std::uniform_int_distribution<uint32_t>(0, n - 1)(random); };
    for (int round = 0; round < 40; ++round) {
        constexpr uint32_t columns = 17, rows = 13;
        Body body(std::pmr::get_default_resource());
        const Vec3 u{0.1, 0.03, 0}, v{0, 0.02, -0.1};
        for (uint32_t p = 0; p < columns * rows; ++p) {
            body.rest_position.push_back(u * (p % columns) + v * (p / columns));
        }
        body.position = body.rest_position;
        body.inverse_mass.assign(columns * rows, 1.0);
        // None, some anywhere, or an edge.
        for (uint32_t i = 0; i < static_cast<uint32_t>(round) % 20; ++i) body.inverse_mass[below(columns * rows)] = 0;
        if (round % 7 == 3) std::fill_n(body.inverse_mass.begin(), columns, 0.0);
        plan_reach_limits(body);
        size_t next = 0;
        for (uint32_t p = 0; p < columns * rows; ++p) {
            if (body.pinned(p)) continue;
            std::vector<std::pair<double, uint32_t>> pins;
            for (uint32_t q = 0; q < columns * rows; ++q) {
                if (body.pinned(q)) pins.push_back({length_squared(body.rest_position[q] - body.rest_position[p]), q});
            }
            std::sort(pins.begin(), pins.end());
            for (size_t i = 0; i < std::min<size_t>(4, pins.size()); ++i, ++next) {
                REQUIRE(next < body.plan.reach_limits.size());
                const ReachLimit& limit = body.plan.reach_limits[next];
                CHECK(limit.particle == p);
                CHECK(limit.anchor == pins[i].second);
                // A slack of a millionth.
                CHECK(std::fabs(limit.distance / std::sqrt(pins[i].first) - 1) < 1.1e-6);
            }
        }
        CHECK(next == body.plan.reach_limits.size());
    }
}
