// The hit of one ray at its nearest crossing, rounded, for kernels: with the formulas of make_hit (intersect.h) and
// to_hit, and the same bits.
#pragma once

#include <cstddef>
#include <limits>

#include "foundation/compiler.h"
#include "foundation/numbers.h"
#include "foundation/simd_axes.h"
#include "mesh/mesh_ray.h"

namespace gphys::GPHYS_ISA {

#if GPHYS_HAS_AVX2

/// Returns whether the hit was written. It is not without a crossing, and where the normal needs exact arithmetic or is
/// that of a degenerate triangle. place(point, normal) transforms both into the world.
template <class Place>
GPHYS_INLINE bool write_hit(const NearestCrossing& nearest, const Axes& direction, const Place& place, gphys_hit& hit) {
    if (nearest.triangle == GPHYS_NO_TRIANGLE) return false;
    const auto corner = [&](int c) -> Axes {
        const auto on_axis = [&](int axis) { return nearest.packet->corner[c][axis][nearest.lane]; };
        return _mm256_cvtps_pd(_mm_setr_ps(on_axis(0), on_axis(1), on_axis(2), on_axis(0)));
    };
    const Axes a = corner(0), ab = corner(1) - a, ac = corner(2) - a;
    // Scalar form: accurate_cross.
    const Axes first = by_component(permuted<1, 2, 0, 1>(ab), permuted<2, 0, 1, 2>(ac));
    const Axes second = by_component(permuted<2, 0, 1, 2>(ab), permuted<1, 2, 0, 1>(ac));
    const Axes turn = first - second, size = abs(turn);
    const Axes error = (abs(first) + abs(second)) * (5 * 0x1p-53), most_error = size * 0x1p-45;
    const double longest = max_component(size);
    const bool accurate = _mm256_movemask_pd(_mm256_cmp_pd(error.v, most_error.v, _CMP_LE_OQ)) == 0xf;
    if (!(accurate & (0 < longest) & (0 < max_component(abs(direction))))) return false;

    const Axes scaled = turn / longest;
    Axes normal = (scaled / gphys::square_root(dot(scaled, scaled))) * (nearest.crossing.facing > 0 ? -1.0 : 1.0);
    const auto clamped = [](double weight, double most) {
        return (weight < 0 ? 0.0 : most < weight ? most : weight) + 0.0;
    };
    const double u = clamped(nearest.crossing.u, 1.0), v = clamped(nearest.crossing.v, 1.0 - u);
    Axes point = a + ab * u + ac * v;
    place(point, normal);

    constexpr double last = std::numeric_limits<float>::max();
    const Axes lasts(last, last, last);
    const __m128 at = _mm256_cvtpd_ps(min(lasts, max(-lasts, point)).v), facing = _mm256_cvtpd_ps(normal.v);
    const __m128 triangle = _mm_castsi128_ps(_mm_cvtsi32_si128(static_cast<int>(nearest.triangle)));
    static_assert(offsetof(gphys_hit, t) == 8 && offsetof(gphys_hit, normal) == 24 && offsetof(gphys_hit, u) == 40);
    hit.model = 0;
    hit.tag = 0;
    // Written as they are copied: two stores cannot be forwarded to one wider load.
    _mm_storeu_ps(&hit.t, _mm_move_ss(_mm_permute_ps(at, 0x90), _mm_set_ss(nearest.t)));
    _mm_storeu_ps(&hit.normal.x, _mm_insert_ps(facing, triangle, 0x30));
    hit.u = static_cast<float>(u);
    hit.v = static_cast<float>(v);
    hit.flags = (nearest.crossing.t == 0 ? GPHYS_HIT_INSIDE : 0) | (nearest.crossing.facing > 0 ? GPHYS_HIT_BACK : 0);
    return true;
}

#else

template <class Place>
bool write_hit(const NearestCrossing&, const Axes&, const Place&, gphys_hit&) {
    return false;
}

#endif

}  // namespace gphys::GPHYS_ISA
