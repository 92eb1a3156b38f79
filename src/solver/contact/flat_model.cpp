// Exact sweeps of spheres against a plane or a box in the cases that one face decides (flat_model.h).
#include "solver/contact/flat_model.h"

#include "scene/placed.h"

namespace gphys {
namespace {

void put(double (&to)[3], Vec3 v) {
    for (int k = 0; k < 3; ++k) to[k] = v[k];
}
Vec3 get(const double (&from)[3]) { return {from[0], from[1], from[2]}; }

}  // namespace

void FlatModel::place(const Aabb& box) {
    rotated_ = false;
    put(low_, box.min);
    put(high_, box.max);
}

void FlatModel::place(const Obb& box) {
    rotated_ = true;
    put(low_, -box.half);
    put(high_, box.half);
    put(center_, box.center);
    put(axes_[0], box.axes.x);
    put(axes_[1], box.axes.y);
    put(axes_[2], box.axes.z);
}

void FlatModel::place(const Plane& plane) {
    const Vec3 normal = normalized(plane.normal);
    const double distance = plane.distance / length(plane.normal);
    const int axis = longest_axis(normal);
    rotated_ = std::fabs(normal[axis]) != 1;
    for (int k = 0; k < 3; ++k) low_[k] = -infinity, high_[k] = infinity;
    if (!rotated_) {
        low_[axis] = high_[axis] = distance * normal[axis];
        return;
    }
    low_[0] = high_[0] = 0;
    put(center_, normal * distance);
    put(axes_[0], normal);
    put(axes_[1], perpendicular(normal));
    put(axes_[2], cross(normal, perpendicular(normal)));
}

bool FlatModel::prepare(const Scene& scene, gphys_model_id model) {
    const auto place_as = [&](auto stored) {
        scene.copy_shape(model, &stored);
        with_placed(stored, scene.world(model), [&](const auto& shape) { place(shape); });
        return true;
    };
    switch (scene.type(model)) {
        case GPHYS_SHAPE_PLANE:
            return place_as(gphys_plane());
        case GPHYS_SHAPE_AABB:
            return place_as(gphys_aabb());
        case GPHYS_SHAPE_OBB:
            return place_as(gphys_obb());
        default:
            return false;
    }
}

/// The Minkowski sum of box and sphere has flat faces where the box has faces, and is rounded elsewhere. The path
/// starts in front of some faces. It enters the sharp enlarged box at the last of their planes that it crosses. If that
/// point is on a flat face, it is also where the path enters the rounded box, which is inside the sharp one.
TriState FlatModel::sweep(const Sphere& moving, Vec3 displacement, Hit& hit) const {
    Vec3 from = moving.center, local = displacement;
    if (rotated_) {
        const Mat3 axes{get(axes_[0]), get(axes_[1]), get(axes_[2])};
        from = transpose_times(axes, moving.center - get(center_));
        local = transpose_times(axes, displacement);
    }
    const double at[] = {from.x, from.y, from.z}, along[] = {local.x, local.y, local.z};
    int axis = -1;
    bool above = false;
    double t = -1;
    for (int k = 0; k < 3; ++k) {
        const double over = at[k] - high_[k], under = low_[k] - at[k];
        const bool side = over > under;
        const double gap = (side ? over : under) - moving.radius, approach = side ? -along[k] : along[k];
        if (gap <= 0) continue;
        if (approach < gap) return TriState::no;
        const double through = gap / approach;
        if (through > t) t = through, axis = k, above = side;
    }
    if (axis < 0) return TriState::undecided;
    for (int k = 0; k < 3; ++k) {
        const double there = at[k] + along[k] * t;
        if (k != axis && (there < low_[k] || there > high_[k])) return TriState::undecided;
    }
    const Vec3 out{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
    const Vec3 normal = rotated_ ? get(axes_[axis]) : out;
    hit.t = t;
    hit.normal = above ? normal : -normal;
    hit.point = moving.center + displacement * t - hit.normal * moving.radius;
    hit.flags = 0;
    return TriState::yes;
}

ContactFace FlatModel::contact_face(Vec3 displacement) const {
    const int axis = longest_axis(displacement);
    const bool above = displacement[axis] < 0;
    ContactFace face{{}, above ? high_[axis] : -low_[axis], std::fabs(displacement[axis])};
    face.normal[axis] = above ? 1 : -1;
    return face;
}

Aabb FlatModel::resting_region(double radius, double gap, Vec3 displacement, double friction) const {
    constexpr Aabb nowhere{{1, 1, 1}, {-1, -1, -1}};
    if (rotated_ || displacement == Vec3{}) return nowhere;
    const ContactFace face = contact_face(displacement);
    const Vec3 along = displacement + face.normal * face.into;
    if (length(along) > friction * face.into) return nowhere;
    Aabb place;
    for (int k = 0; k < 3; ++k) {
        // The region excludes the border of the face, so that a sliding particle stays on it.
        const double room = std::fabs(along[k]), off = radius + gap, least = radius + gap / 2;
        place.min[k] = face.normal[k] > 0   ? face.place + least
                       : face.normal[k] < 0 ? -face.place - off
                                            : low_[k] + room;
        place.max[k] = face.normal[k] > 0   ? face.place + off
                       : face.normal[k] < 0 ? -face.place - least
                                            : high_[k] - room;
    }
    return place;
}

/// Solves n.x = d for each component of x, with the other components at their extremes.
Aabb FlatModel::part_of_plane(const Aabb& region) const {
    Aabb part = region;
    if (!rotated_) {
        for (int k = 0; k < 3; ++k) {
            part.min[k] = std::max(part.min[k], low_[k]);
            part.max[k] = std::min(part.max[k], high_[k]);
        }
        return part;
    }
    const Vec3 normal = get(axes_[0]), middle = (region.min + region.max) / 2 - get(center_);
    const Vec3 half = (region.max - region.min) / 2;
    const double distance = dot(normal, middle), reach = dot(abs(normal), half);
    for (int k = 0; k < 3; ++k) {
        const double slope = std::fabs(normal[k]);
        if (slope < 1e-3) continue;  // almost parallel to the axis: keeps the whole region
        const double at = (region.min[k] + region.max[k]) / 2 - distance / normal[k];
        const double room = (reach - slope * half[k]) / slope;
        part.min[k] = std::max(part.min[k], at - room);
        part.max[k] = std::min(part.max[k], at + room);
    }
    return part;
}

}  // namespace gphys
