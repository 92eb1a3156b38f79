// Signs of exact arithmetic: of points that lie on the plane of three others, or beside it by less
// than double arithmetic could tell. Exit status 0 if all are right.
#include <cstdint>
#include <cstdio>

#include "foundation/exact.h"

using namespace gphys;

int main() {
    uint64_t state = 1;
    auto random = [&](uint32_t below) {  // Knuth's MMIX generator
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<int32_t>((state >> 33) % below);
    };
    auto point = [&] {
        auto coordinate = [&] { return (random(2000001) - 1000000) / 8192.0; };
        const double x = coordinate(), y = coordinate(), z = coordinate();
        return Vec3{x, y, z};
    };
    int wrong = 0;
    const int count = 100000;
    for (int i = 0; i < count; ++i) {
        const Vec3 a = point(), b = point(), c = point();
        // Coordinates are multiples of 2^-13 below 2^7, so nothing is rounded here.
        const Vec3 on_plane = a + (b - a) * (random(5) - 2) + (c - a) * (random(5) - 2);
        const double slope = cross(b - a, c - a).x;
        const Vec3 above{on_plane.x + std::copysign(0x1p-30, slope), on_plane.y, on_plane.z};
        if (orientation(a, b, c, on_plane) != 0) ++wrong;
        if (slope != 0 && orientation(a, b, c, above) != 1) ++wrong;
    }
    std::printf("%d of %d signs are wrong\n", wrong, 2 * count);
    return wrong != 0;
}
