// One ray against one triangle in double, for kernels, with the formulas of raycast_triangle.cpp (Woop, Benthin, Wald
// 2013) and the same bits. Where registers hold four doubles, its corners are in the lanes of one. What needs exact
// arithmetic, and special cases, are left to that file; on other sets everything is.
#pragma once

#include "foundation/compiler.h"
#include "foundation/numbers.h"
#include "foundation/simd_axes.h"
#include "foundation/tri_state.h"
#include "geometry/intersect.h"
#include "geometry/shear.h"
#include "mesh/triangle_packet.h"

namespace gphys::GPHYS_ISA {

#if GPHYS_HAS_AVX2

class SingleCrossing {
public:
    GPHYS_INLINE SingleCrossing(const SingleShear<Axes>& shear, const Axes& origin, double t_max)
        : shear_(shear), t_max_(t_max) {
        shear.turn(origin, from_);
    }

    GPHYS_INLINE TriState operator()(const TrianglePacket& packet, uint32_t lane, TriangleCrossing& crossing) const {
        const auto corners = [&](int axis) -> Axes {
            const auto corner = [&](int c) { return packet.corner[c][axis][lane]; };
            return _mm256_cvtps_pd(_mm_setr_ps(corner(0), corner(1), corner(2), corner(0)));
        };
        const Axes z = minus(corners(shear_.kz), from_[2]);
        const Axes x = minus(corners(shear_.kx), from_[0]) - z * shear_.sx;
        const Axes y = minus(corners(shear_.ky), from_[1]) - z * shear_.sy;
        // Of the edges opposite to a, b and c.
        const Axes volumes = by_component(permuted<2, 0, 1, 2>(x), permuted<1, 2, 0, 1>(y)) -
                             by_component(permuted<2, 0, 1, 2>(y), permuted<1, 2, 0, 1>(x));
        const double r = max_component(max(abs(x), abs(y))), reach_z = max_component(abs(z));
        const double coordinate_error = 5 * 0x1p-53 * (r + 2 * reach_z);
        const double volume_error = 8 * coordinate_error * (r + coordinate_error);
        const double lowest = min_component(volumes), highest = max_component(volumes);
        if ((lowest < -volume_error) & (volume_error < highest)) return TriState::no;

        double volume[4], weight[4], along[4];
        store(volume, volumes);
        store(along, z);
        const double total = volume[0] + volume[1] + volume[2], size = gphys::absolute(total);
        const double weight_error = 4.5 * volume_error;
        const bool through = (volume_error < lowest) | (highest < -volume_error);
        if (!(shear_.moves & through & (weight_error <= 0x1p-26 * size))) return TriState::undecided;
        store(weight, quotients(volumes, Axes(total, total, total)));
        const double ab = along[1] - along[0], ac = along[2] - along[0];
        const double way = along[0] + weight[1] * ab + weight[2] * ac;
        const double spread = gphys::largest(gphys::absolute(ab), gphys::absolute(ac));
        const double way_error = 2 * weight_error / size * spread + 0x1p-50 * reach_z;
        const double t = way / shear_.speed;
        const bool clear = 0x1p-40 * gphys::absolute(t) < gphys::absolute(t - t_max_);
        if (!((way_error <= 0x1p-30 * gphys::absolute(way)) & ((t < 0) | clear))) return TriState::undecided;
        if ((t < 0) | (t_max_ < t)) return TriState::no;
        crossing = {t, weight[1], weight[2], lowest < 0 ? 1 : -1};
        return TriState::yes;
    }

private:
    const SingleShear<Axes>& shear_;
    double from_[3], t_max_;
};

#else

class SingleCrossing {
public:
    SingleCrossing(const SingleShear<Axes>&, const Axes&, double) {}
    TriState operator()(const TrianglePacket&, uint32_t, TriangleCrossing&) const { return TriState::undecided; }
};

#endif

}  // namespace gphys::GPHYS_ISA
