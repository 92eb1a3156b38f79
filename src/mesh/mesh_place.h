// A scale for each axis of a mesh, and the place of a scaled mesh.
//
// One mesh serves models of many scales without copies. Queries use one of two frames:
//
// - Raycasts are transformed into the frame of the unscaled mesh. The map is affine, so t stays the same, and so do
//   the signs that decide: each product of three coordinates, one for each axis, grows by the same factor. Tree,
//   packets and kernels need not know the scale. Normals are divided by it.
// - Queries that measure distances (closest points, overlaps, sweeps, penetrations) use the frame of the scaled mesh.
//   Triangles are scaled when they are read, which is exact: the product of two floats is a double. The tree stays
//   that of the unscaled mesh. Its axis-parallel boxes are scaled when they are measured, or the query is divided by
//   the scale.
//
// A copy of the mesh for each scale would give the same answers, at a cost of 100 bytes per triangle and of building
// its tree at each change.
#pragma once

#include "shapes/shapes.h"

namespace gphys {

struct AxisScale {
    AxisScale() = default;
    explicit AxisScale(Vec3 scale) : by(scale), is_one_(scale == Vec3{1, 1, 1}) {}

    Vec3 by{1, 1, 1};

    bool is_one() const { return is_one_; }
    double largest() const { return max_component(by); }
    double least() const { return std::min(by.x, std::min(by.y, by.z)); }

    // Exact for floats.
    Vec3 operator()(Vec3 point) const { return by_component(point, by); }
    Triangle operator()(const Triangle& t) const {
        return is_one_ ? t : Triangle{(*this)(t.a), (*this)(t.b), (*this)(t.c)};
    }
    Aabb operator()(const Box& box) const {
        return {(*this)(Vec3{box.min[0], box.min[1], box.min[2]}), (*this)(Vec3{box.max[0], box.max[1], box.max[2]})};
    }

    Vec3 inverse(Vec3 v) const { return quotients(v, by); }
    /// A box of the scaled mesh in the frame of the unscaled one, rounded outward.
    Box inverse(const Box& box) const {
        if (is_one()) return box;
        Box result;
        for (int k = 0; k < 3; ++k) {
            const double low = box.min[k] / by[k], high = box.max[k] / by[k];
            result.min[k] = round_down(low - 0x1p-52 * std::fabs(low));
            result.max[k] = round_up(high + 0x1p-52 * std::fabs(high));
        }
        return result;
    }
    /// The scaled mesh's unit normal for a unit normal of the unscaled mesh: the inverse transpose, with the same
    /// relative error in each component.
    Vec3 normal(Vec3 unit) const { return is_one() || unit == Vec3{} ? unit : normalized(inverse(unit)); }

private:
    bool is_one_ = true;
};

/// x -> position + rotation (scale (axes x)).
struct MeshPlace {
    const Transform& world;
    const AxisScale& axes;
    Vec3 scale = axes.by * world.scale;  // both scales; the product is exact

    Vec3 apply(Vec3 p) const { return world.position + world.rotation * by_component(p, scale); }
    Vec3 inverse_apply(Vec3 p) const { return quotients(transpose_times(world.rotation, p - world.position), scale); }
    Vec3 inverse_apply_to_vector(Vec3 v) const { return quotients(transpose_times(world.rotation, v), scale); }
};

}  // namespace gphys
