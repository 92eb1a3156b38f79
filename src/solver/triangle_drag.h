// The force of the air on a triangle of cloth (gphys_solver_set_wind), over the type of its numbers: doubles, or eight
// floats for eight triangles.
#pragma once

#include "foundation/numbers.h"
#include "foundation/vec.h"

namespace gphys {

template <class N>
struct TriangleDrag {
    Vec<N> force;  // on each corner; its unit is a twelfth of the density of the air, so kg/m^3 make it newtons
    N growth;      // by how much the force grows at most if all velocities grow by 1 m/s
};

/// `twice`: twice the area, along the normal, m^2. `u`: the mean velocity of the corners relative to the air, m/s.
/// `least`: a smaller `twice` or speed has no direction, and no force.
template <class N>
GPHYS_INLINE TriangleDrag<N> triangle_drag(const Vec<N>& twice, const Vec<N>& u, const N& drag, const N& lift,
                                           const N& least) {
    const N zero = splat_as(least, 0), one = splat_as(least, 1);
    const N area = square_root(dot(twice, twice)), speed = square_root(dot(u, u));
    const Vec<N> n = twice * (one / largest(area, least));
    const N across = dot(u, n), cosine = absolute(across) * (one / largest(speed, least));
    const N pressure = area * speed, along = largest((drag - lift * cosine) * cosine, zero);
    return {(u * along + n * (across * lift)) * (zero - pressure), pressure * (along + lift)};
}

}  // namespace gphys
