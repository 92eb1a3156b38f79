// The bounding box of a frustum with eight corners, in double with error bounds (halfspaces.h). Cramer's rule gives the
// corners.
#include "shapes/halfspaces.h"

namespace gphys {
namespace {

/// The number of triples of planes that form corners: one of each pair of opposite planes.
constexpr int corner_count = 8;
constexpr int plane_of(int corner, int pair) { return 2 * pair + (corner >> pair & 1); }

/// The common point of three planes, and its error bound on each axis. Let a, b, c, x be the largest components of the
/// normals and of the point, u = 2^-53 and h = |d_a| b c + |d_b| a c + |d_c| a b. The sum of the three products of a
/// distance and a cross product has an error below 14 u h, the determinant one below 40 u a b c. So the error of their
/// quotient is below 2^-47 (h + x a b c) / |determinant|. The bound is eight times that.
struct Corner {
    Vec3 point;
    double error;

    Corner(const Plane& a, const Plane& b, const Plane& c) {
        const Vec3 bc = cross(b.normal, c.normal), ca = cross(c.normal, a.normal), ab = cross(a.normal, b.normal);
        const double determinant = dot(a.normal, bc);
        const double size[3] = {max_component(abs(a.normal)), max_component(abs(b.normal)),
                                max_component(abs(c.normal))};
        const double product = size[0] * size[1] * size[2];
        // Negated, so that NaN is rejected, too.
        if (!(std::fabs(determinant) > 0x1p-30 * product)) {
            error = infinity;
            return;
        }
        const double inverse = 1 / determinant;
        point = (bc * a.distance + ca * b.distance + ab * c.distance) * inverse;
        const double heights = std::fabs(a.distance) * size[1] * size[2] + std::fabs(b.distance) * size[0] * size[2] +
                               std::fabs(c.distance) * size[0] * size[1];
        error = 0x1p-44 * (heights + max_component(abs(point)) * product) * std::fabs(inverse);
    }

    bool is_certainly_above(const Plane& plane) const {
        const double size = max_component(abs(plane.normal));
        const double rounding = 0x1p-48 * (size * max_component(abs(point)) + std::fabs(plane.distance));
        return dot(plane.normal, point) - plane.distance > 4 * size * error + rounding;
    }
};

}  // namespace

// If the corner of every choice of one plane from each pair lies above the other three planes, it is a corner of the
// body in which exactly three edges end. Each of these edges runs along two planes to the corner with the opposite of
// the third plane. So the edges from these eight corners lead to no others and not to infinity. As the edges of a
// convex body are connected, there are no other corners.
bool bounds_of_six_sided(const Frustum& frustum, Box& out) {
    Box box;
    for (int i = 0; i < corner_count; ++i) {
        const Corner corner(frustum.planes[plane_of(i, 0)], frustum.planes[plane_of(i, 1)],
                            frustum.planes[plane_of(i, 2)]);
        if (!(corner.error < infinity)) return false;
        for (int pair = 0; pair < 3; ++pair) {
            if (!corner.is_certainly_above(frustum.planes[plane_of(corner_count - 1 - i, pair)])) return false;
        }
        const Vec3 place = frustum.origin + corner.point;
        for (int axis = 0; axis < 3; ++axis) {
            const double slack = corner.error + std::fabs(place[axis]) * 0x1p-52;
            box.min[axis] = std::min(box.min[axis], round_down(place[axis] - slack));
            box.max[axis] = std::max(box.max[axis], round_up(place[axis] + slack));
        }
    }
    out = box;
    return true;
}

}  // namespace gphys
