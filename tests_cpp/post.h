// A rope over a post, for the tests of posts that stand still and that move.
#pragma once

#include <cmath>
#include <vector>

#include "gamephys_c.h"

namespace test {

/// The particles of a rope with its middle on top of a post along z at the origin, and its ends hanging down. `bend`:
/// the radius of the arc on the post.
inline std::vector<gphys_vec3> points_over_post(uint32_t links, float link, double bend) {
    const double half = 3.14159265358979323846 * bend / 2;
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i <= links; ++i) {
        const double way = (i - links / 2.0) * double{link};
        const bool on = std::fabs(way) < half;
        points.push_back({static_cast<float>(on ? bend * std::sin(way / bend) : std::copysign(bend, way)),
                          static_cast<float>(on ? bend * std::cos(way / bend) : half - std::fabs(way)), 0});
    }
    return points;
}

}  // namespace test
