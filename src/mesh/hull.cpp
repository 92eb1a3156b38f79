// Queries of a mesh that is a convex hull, and therefore solid. If a query shape does not intersect the surface, it is
// wholly inside, wholly outside, or contains the hull; one point decides which.
//
// Separation of a hull and a box or capsule: the separating axis test over face normals and over the pairs of edges
// that form a face of the Minkowski difference (Gauss map: Gregorius 2013).
#include "mesh/hull.h"

#include "geometry/convex_pairs.h"
#include "geometry/slab_clip.h"
#include "mesh/mesh.h"

namespace gphys {

void Hull::make(const Vector<gphys_vec3>& vertices, const Vector<uint32_t>& indices) {
    struct Side {
        uint32_t low, high, face;
    };
    Vector<Side> sides(faces_.get_allocator());
    const auto corner = [&](size_t index) { return widen(vertices[indices[index]]); };
    const auto in_last_plane = [&](Vec3 point) {
        const Triangle& first = faces_.back().triangle;
        return orientation(first.a, first.b, first.c, point) == 0;
    };
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
        const Triangle triangle{corner(i), corner(i + 1), corner(i + 2)};
        const bool goes_on =
            !faces_.empty() && in_last_plane(triangle.a) && in_last_plane(triangle.b) && in_last_plane(triangle.c);
        if (!goes_on) {
            const Vec3 normal = accurate_cross(triangle.a, triangle.b, triangle.a, triangle.c);
            faces_.push_back({triangle, normalized(normal)});
        }
        const auto face = static_cast<uint32_t>(faces_.size() - 1);
        face_of_.push_back(face);
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t a = indices[i + k], b = indices[i + (k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), face});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        if (a.low != b.low) return a.low < b.low;
        return a.high != b.high ? a.high < b.high : a.face < b.face;
    });
    for (size_t i = 0; i + 1 < sides.size(); i += 2) {
        const Side &one = sides[i], &other = sides[i + 1];
        if (one.face == other.face) continue;
        edges_.push_back({widen(vertices[one.low]), widen(vertices[one.high]), {one.face, other.face}});
    }
}

bool Hull::contains(Vec3 point, const AxisScale& axes) const {
    return !faces_.empty() && std::all_of(faces_.begin(), faces_.end(), [&](const Face& face) {
        const Triangle t = axes(face.triangle);
        return orientation(t.a, t.b, t.c, point) <= 0;
    });
}

double Hull::depth(Vec3 point, Vec3& normal, const AxisScale& axes) const {
    double highest = -infinity;
    for (const Face& face : faces_) {
        const Vec3 unit = axes.normal(face.normal);
        const double height = dot(unit, point - axes(face.triangle.a));
        if (height > highest) highest = height, normal = unit;
    }
    return std::max(0.0, -highest);
}

bool Mesh::contains(Vec3 point, const AxisScale& axes) const {
    if (!is_hull()) return false;
    const Aabb box = axes(bounds());
    for (int k = 0; k < 3; ++k) {
        if (point[k] < box.min[k] || point[k] > box.max[k]) return false;
    }
    return hull_.contains(point, axes);
}

bool Mesh::contains_point_of(const Shape& shape, const AxisScale& axes) const {
    return std::visit(
        [&](const auto& each) {
            using S = std::decay_t<decltype(each)>;
            if constexpr (std::is_same_v<S, Plane>) {
                return false;  // a plane is unbounded, so if it overlaps the hull it intersects the surface
            } else if constexpr (std::is_same_v<S, Triangle>) {
                return contains(each.a, axes);
            } else if constexpr (std::is_same_v<S, Frustum>) {
                Vec3 point;
                return gphys::closest_point(each, axes(center_), point) && contains(point, axes);
            } else {
                return contains(reference_point(each), axes);
            }
        },
        shape);
}

bool Mesh::contains_part_of(const Mesh& other) const {
    if (!is_hull()) return false;
    bool held = false;
    other.bvh_.overlap_box(bounds(), [&](uint32_t number, bool) {
        const TrianglePacket& packet = other.packets_[number];
        return for_each_lane(other.lanes_of(packet), [&](int lane) {
            held = contains(packet.triangle(lane).a);
            return !held;
        });
    });
    return held;
}

namespace {

// Relative to the size of the shapes, as for the separation of two convex shapes (convex_separation.cpp).
constexpr double certain = 0x1p-44;
// Squared length of the sum of the unit normals of two faces that nearly coincide, back to back.
constexpr double blade = 0x1p-20;
// Squared sine of the angle between an edge and an axis that are nearly parallel.
constexpr double along = 0x1p-80;
// Relative to the size: a smaller radius changes results by less than their documented accuracy.
constexpr double sharp = 0x1p-43;
// As for the separation: a shorter offset has no direction.
constexpr double is_direction = least_offset / 4;

/// The core of a sphere, capsule or box, relative to a point of it.
Core relative_core(const Shape& moving, Vec3& from) {
    return with_solid(moving, [&](const auto& solid) {
        from = reference_point(solid);
        return core_of(relative_to(from, solid));
    });
}

double lowest(const Core& core, Vec3 unit) {
    double low = dot(unit, core.center);
    for (int k = 0; k < core.axis_count; ++k) low -= core.half[k] * std::fabs(dot(unit, core.axes[k]));
    return low;
}

/// Calls visit(unit, gap) for every direction that can be the normal of a face of the Minkowski difference of the
/// scaled hull and the core of a solid. `gap` is their distance along it, both relative to `from`. The directions are
/// the face normals of either, and the cross products of an edge of each where the arcs of the two edges cross on the
/// Gauss map: where the two faces at the hull's edge lie on different sides of the direction of the other edge. Stops
/// when visit returns false, and returns false then.
template <class Visit>
bool for_each_gap(const Hull& hull, const AxisScale& axes, const Core& core, Vec3 from, const Visit& visit) {
    const auto height = [&](Vec3 unit, Vec3 point) { return dot(unit, axes(point) - from); };
    const auto visit_above = [&](Vec3 unit, double hull_height) {
        return visit(unit, lowest(core, unit) - hull_height);
    };
    for (const Hull::Face& face : hull.faces()) {
        const Vec3 normal = axes.normal(face.normal);
        if (!visit_above(normal, height(normal, face.triangle.a))) return false;
    }
    const auto visit_both = [&](Vec3 unit) {
        double low = infinity, high = -infinity;
        for (const Hull::Edge& edge : hull.edges()) {
            const double a = height(unit, edge.a), b = height(unit, edge.b);
            low = std::min(low, std::min(a, b));
            high = std::max(high, std::max(a, b));
        }
        return visit_above(unit, high) && visit_above(-unit, -low);
    };
    for (int k = 0; core.axis_count == 3 && k < 3; ++k) {
        if (!visit_both(core.axes[k])) return false;
    }
    double parallel[3];
    for (int k = 0; k < core.axis_count; ++k) parallel[k] = along * length_squared(core.axes[k]);
    for (const Hull::Edge& edge : hull.edges()) {
        const Vec3 one = axes.normal(hull.faces()[edge.face[0]].normal);
        const Vec3 other = axes.normal(hull.faces()[edge.face[1]].normal);
        const bool is_blade = length_squared(one + other) < blade;
        for (int k = 0; k < core.axis_count; ++k) {
            const double rise = dot(one, core.axes[k]), fall = dot(other, core.axes[k]);
            const double turn = rise * fall;
            // At a sharp edge, or at an edge along the axis, the side of the edge would depend on rounding.
            const bool is_open = is_blade || (std::fabs(turn) < parallel[k] &&
                                              std::max(std::fabs(rise), std::fabs(fall)) < std::sqrt(parallel[k]));
            if (!is_open && turn >= 0) continue;
            Vec3 unit = unit_across({}, core.axes[k], axes(edge.a), axes(edge.b));
            if (unit == Vec3{}) continue;
            if (dot(unit, one + other) < 0) unit = -unit;
            if (!(is_open ? visit_both(unit) : visit_above(unit, height(unit, edge.a)))) return false;
        }
    }
    return true;
}

/// The largest of the gaps of for_each_gap.
struct WidestGap {
    WidestGap(const Hull& hull, const AxisScale& axes, const Core& core, Vec3 from) {
        for_each_gap(hull, axes, core, from, [&](Vec3 unit, double height) {
            if (height > gap) gap = height, normal = unit;
            return true;
        });
    }

    double gap = -infinity;
    Vec3 normal;
};

}  // namespace

double Mesh::hull_size(const Core& core, Vec3 from, const AxisScale& axes) const {
    const Aabb box = axes(bounds());
    Vec3 reach = abs(core.center);
    for (int k = 0; k < 3; ++k) reach[k] += std::max(std::fabs(box.min[k] - from[k]), std::fabs(box.max[k] - from[k]));
    for (int k = 0; k < core.axis_count; ++k) reach += abs(core.axes[k]) * core.half[k];
    return max_component(reach) + core.radius;
}

Vec3 Mesh::contact_on_hull(const Core& core, Vec3 from, Vec3 normal, double distance, double size,
                           uint32_t& nearest_triangle, const AxisScale& axes) const {
    // As contact_on_other: with the shapes moved further apart, the nearest of the highest triangles of the hull.
    const Vec3 apart = normal * (size * 0.5 - distance);
    const auto height = [&](uint32_t i) {
        const Triangle corners = relative_to(from, axes(triangle(i)));
        return std::max({dot(normal, corners.a), dot(normal, corners.b), dot(normal, corners.c)});
    };
    double highest = -infinity, nearest = infinity;
    for (uint32_t i = 0; i < triangle_count(); ++i) highest = std::max(highest, height(i));
    Vec3 point;
    for (uint32_t i = 0; i < triangle_count(); ++i) {
        if (height(i) < highest - certain * size) continue;
        const NearestDifference near =
            ConvexDifference(relative_to(from, axes(triangle(i))), core).after(apart).nearest();
        const double length = gphys::length(near.offset);
        if (length < nearest) nearest = length, point = near.on_other, nearest_triangle = i;
    }
    return point;
}

Penetration Mesh::penetration_of_hull(const Shape& moving, const AxisScale& axes) const {
    Vec3 from;
    const Core core = relative_core(moving, from);
    const WidestGap widest(hull_, axes, core, from);
    const double size = hull_size(core, from, axes);

    double distance = widest.gap;
    Vec3 normal = widest.normal, point;
    double nearest = infinity;
    NearestDifference between;
    if (distance > -certain * size) {
        // If they are apart, or beside a sharp edge, the nearest points may be on edges and corners. A solid that
        // overlaps the hull by rounding alone overlaps a triangle there.
        const auto find_nearest = [&](uint32_t triangle) {
            const NearestDifference near =
                ConvexDifference(relative_to(from, axes(this->triangle(triangle))), core).nearest();
            const double length = gphys::length(near.offset);
            if (length < nearest) nearest = length, between = near;
        };
        for_each_overlap(moving, find_nearest, axes);
    }
    const auto is_between = [&] {  // and not rounding
        return nearest >= is_direction * size || gap_along(between.offset / -nearest, core, from, axes) >= distance;
    };
    const bool is_apart = nearest < infinity && nearest > certain * size && is_between();
    if (is_apart) {
        distance = nearest;
        normal = between.offset / -nearest;
        point = between.on_other;
    }
    uint32_t triangle;
    if (!is_apart) point = contact_on_hull(core, from, normal, distance, size, triangle, axes);
    return {std::max(0.0, core.radius - distance), normal, from + point};
}

bool Mesh::is_sharp(const Shape& moving, Vec3 displacement, const AxisScale& axes) const {
    Vec3 from;
    const Core core = relative_core(moving, from);
    return core.radius <= sharp * (hull_size(core, from, axes) + max_component(abs(displacement)));
}

std::optional<bool> Mesh::sweep_sharp_at_hull(const Shape& moving, Vec3 displacement, Hit& hit,
                                              const AxisScale& axes) const {
    Vec3 from;
    Core core = relative_core(moving, from);
    if (core.axis_count == 0) return sweep_point_at_hull({from + core.center, displacement, 1}, hit, axes);
    const double size = hull_size(core, from, axes);
    const double resolution = contact_tolerance * (size + max_component(abs(displacement)));
    SlabClip clip(resolution);
    const auto cut = [&](SlabClip& by, double grown_by) {
        return for_each_gap(hull_, axes, core, from, [&](Vec3 unit, double gap) {
            return by.cut(gap - grown_by, -dot(unit, displacement), unit);
        });
    };
    if (!cut(clip, 0) || clip.is_empty()) return false;
    if (clip.is_open()) {
        SlabClip grown(resolution);
        cut(grown, resolution);
        if (!clip.is_in(grown)) return false;
    }
    hit = Hit{std::min(clip.begin(), 1.0), {}, clip.normal()};
    if (hit.normal == Vec3{}) {
        // In contact within rounding, but not overlapping.
        hit.normal = clip.widest_normal();
        if (!(dot(hit.normal, displacement) < 0)) return false;
    }
    core.center += displacement * hit.t;
    core.radius = 0;
    hit.normal = normal_at_hull(core, from, displacement, hit.normal, size, axes);
    hit.point = from + contact_on_hull(core, from, hit.normal, 0, size, hit.triangle, axes);
    const Triangle hit_triangle = axes(triangle(hit.triangle));
    // Beyond a sharp edge the core may be within rounding of both planes and yet far from the hull.
    const ConvexDifference there(relative_to(from, hit_triangle), core);
    if (length(there.nearest().offset) > sharp * (size + max_component(abs(displacement)))) return {};
    barycentric(hit_triangle, hit.point, hit.u, hit.v);
    return true;
}

double Mesh::gap_along(Vec3 unit, const Core& core, Vec3 from, const AxisScale& axes) const {
    double high = -infinity;
    for (const gphys_vec3& vertex : vertices_) high = std::max(high, dot(unit, axes(widen(vertex)) - from));
    return lowest(core, unit) - high;
}

Vec3 Mesh::normal_at_hull(const Core& core, Vec3 from, Vec3 displacement, Vec3 normal, double size,
                          const AxisScale& axes) const {
    double widest = gap_along(normal, core, from, axes);
    if (widest >= core.radius - normal_rounding * (size + max_component(abs(displacement)))) return normal;
    const auto offer = [&](Vec3 unit) {
        if (dot(unit, displacement) > 0x1p-48 * length(displacement)) return;
        const double gap = gap_along(unit, core, from, axes);
        if (gap > widest) widest = gap, normal = unit;
    };
    for_each_gap(hull_, axes, core, from, [&](Vec3 unit, double) {
        offer(unit);
        return true;
    });
    for (uint32_t i = 0; core.radius > 0 && i < triangle_count(); ++i) {
        const Vec3 offset = ConvexDifference(relative_to(from, axes(triangle(i))), core).nearest().offset;
        if (offset != Vec3{}) offer(normalized(offset * -1.0));
    }
    return normal;
}

void Mesh::use_hull_normal(const Shape& moving, Vec3 displacement, Hit& hit, const AxisScale& axes) const {
    if (hit.flags & GPHYS_HIT_INSIDE) return;
    Vec3 from;
    Core core = relative_core(moving, from);
    core.center += displacement * hit.t;
    const double size = hull_size(core, from, axes);
    const Vec3 normal = normal_at_hull(core, from, displacement, hit.normal, size, axes);
    if (normal == hit.normal) return;
    hit.normal = normal;
    hit.point = from + contact_on_hull(core, from, normal, core.radius, size, hit.triangle, axes);
    barycentric(axes(triangle(hit.triangle)), hit.point, hit.u, hit.v);
}

void Mesh::start_in_hull(const Shape& moving, Hit& hit, const AxisScale& axes) const {
    const Penetration way = penetration_of_hull(moving, axes);
    hit = Hit{0, way.point, way.normal};
    hit.flags = GPHYS_HIT_INSIDE;
}

/// As for other solids (sweep.cpp): the normal points away from the nearest point or, from within, against the motion.
void Mesh::start_in_hull(const Sphere& moving, Vec3 displacement, Hit& hit, const AxisScale& axes) const {
    hit = Hit{0, {}, {}};
    hit.flags = GPHYS_HIT_INSIDE;
    uint32_t triangle;
    closest_point(moving.center, infinity, hit.point, triangle, axes);
    const Vec3 out = moving.center != hit.point ? moving.center - hit.point : -displacement;
    if (out != Vec3{}) hit.normal = normalized(out);
}

}  // namespace gphys
