// Queries of a mesh that is a convex hull. It is a solid: where a query does not meet the surface, it is wholly inside,
// wholly outside or around it, and one point tells which.
#include "mesh/hull.h"

#include "geometry/convex_pairs.h"
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

bool Mesh::holds_point_of(const Shape& shape, const AxisScale& axes) const {
    return std::visit(
        [&](const auto& each) {
            using S = std::decay_t<decltype(each)>;
            if constexpr (std::is_same_v<S, Plane>) {
                return false;  // which has points outside, too, and so meets the surface
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

bool Mesh::holds_part_of(const Mesh& other) const {
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

// As for the separation of two convex shapes, relative to their size (convex_separation.cpp).
constexpr double certain = 0x1p-44;

/// The largest gap of a hull and the core of a solid among the directions that can be normals of faces of their
/// difference: normals of either, and of edges of both where the faces at an edge of the hull lie on different sides
/// of the direction of the other edge, so that the normal is between theirs (Gauss map: Gregorius 2013).
class HullAndCore {
public:
    /// The scaled hull; both relative to `from`.
    HullAndCore(const Hull& hull, const AxisScale& axes, const Core& core, Vec3 from)
        : hull_(hull), axes_(axes), core_(core), from_(from) {
        for (const Hull::Face& face : hull.faces()) {
            const Vec3 normal = axes.normal(face.normal);
            offer(normal, height(normal, face.triangle.a));
        }
        for (int k = 0; core.axis_count == 3 && k < 3; ++k) {
            offer(core.axes[k], highest(core.axes[k]));
            offer(-core.axes[k], highest(-core.axes[k]));
        }
        for (const Hull::Edge& edge : hull.edges()) {
            const Vec3 one = axes.normal(hull.faces()[edge.face[0]].normal);
            const Vec3 other = axes.normal(hull.faces()[edge.face[1]].normal);
            for (int k = 0; k < core.axis_count; ++k) {
                if (!(dot(one, core.axes[k]) * dot(other, core.axes[k]) < 0)) continue;
                Vec3 unit = unit_across({}, core.axes[k], axes(edge.a), axes(edge.b));
                if (dot(unit, one + other) < 0) unit = -unit;
                if (unit != Vec3{}) offer(unit, height(unit, edge.a));
            }
        }
    }

    double gap() const { return gap_; }
    Vec3 normal() const { return normal_; }

private:
    void offer(Vec3 unit, double hull_height) {
        double low = dot(unit, core_.center);
        for (int k = 0; k < core_.axis_count; ++k) low -= core_.half[k] * std::fabs(dot(unit, core_.axes[k]));
        if (low - hull_height > gap_) gap_ = low - hull_height, normal_ = unit;
    }
    double height(Vec3 unit, Vec3 point) const { return dot(unit, axes_(point) - from_); }
    double highest(Vec3 unit) const {
        double highest = -infinity;
        for (const Hull::Edge& edge : hull_.edges()) {
            highest = std::max(highest, std::max(height(unit, edge.a), height(unit, edge.b)));
        }
        return highest;
    }

    const Hull& hull_;
    const AxisScale& axes_;
    const Core& core_;
    Vec3 from_, normal_;
    double gap_ = -infinity;
};

}  // namespace

Penetration Mesh::way_out_of_hull(const Shape& moving, const AxisScale& axes) const {
    return with_solid(moving, [&](const auto& solid) {
        const Vec3 from = reference_point(solid);
        const Core core = core_of(relative_to(from, solid));
        const HullAndCore separation(hull_, axes, core, from);
        double size = 0;
        const auto difference = [&](uint32_t triangle) {
            return ConvexDifference(relative_to(from, axes(this->triangle(triangle))), core);
        };
        for (uint32_t i = 0; i < triangle_count(); ++i) size = std::max(size, difference(i).size());

        double distance = separation.gap();
        Vec3 normal = separation.normal(), point;
        double nearest = infinity;
        if (distance > certain * size) {
            // Apart, the nearest points may be on edges and corners. What is rounded overlaps a triangle there.
            const auto find_nearest = [&](uint32_t triangle) {
                const NearestDifference near = difference(triangle).nearest();
                const double length = gphys::length(near.offset);
                if (length > 0 && length < nearest) {
                    nearest = distance = length;
                    normal = near.offset / -length;
                    point = near.on_other;
                }
                return true;
            };
            for_each_overlap(moving, find_nearest, axes);
        }
        if (nearest == infinity) {
            // As contact_on_other: further apart, where of the triangles of the hull those that are highest are
            // nearest.
            const Vec3 apart = normal * (size * 0.5 - distance);
            double highest = -infinity;
            const auto height = [&](uint32_t i) {
                const Triangle corners = relative_to(from, axes(this->triangle(i)));
                return std::max({dot(normal, corners.a), dot(normal, corners.b), dot(normal, corners.c)});
            };
            for (uint32_t i = 0; i < triangle_count(); ++i) highest = std::max(highest, height(i));
            for (uint32_t i = 0; i < triangle_count(); ++i) {
                if (height(i) < highest - certain * size) continue;
                const NearestDifference near = difference(i).after(apart).nearest();
                const double length = gphys::length(near.offset);
                if (length < nearest) nearest = length, point = near.on_other;
            }
        }
        return Penetration{std::max(0.0, core.radius - distance), normal, from + point};
    });
}

void Mesh::start_in_hull(const Shape& moving, Hit& hit, const AxisScale& axes) const {
    const Penetration way = way_out_of_hull(moving, axes);
    hit = Hit{};
    hit.t = 0;
    hit.point = way.point;
    hit.normal = way.normal;
    hit.flags = GPHYS_HIT_INSIDE;
}

/// As at other solids (sweep.cpp): away from the nearest point, and against the motion from within.
void Mesh::start_in_hull(const Sphere& moving, Vec3 displacement, Hit& hit, const AxisScale& axes) const {
    hit = Hit{};
    hit.t = 0;
    hit.flags = GPHYS_HIT_INSIDE;
    uint32_t triangle;
    closest_point(moving.center, infinity, hit.point, triangle, axes);
    const Vec3 out = moving.center != hit.point ? moving.center - hit.point : -displacement;
    if (out != Vec3{}) hit.normal = normalized(out);
}

}  // namespace gphys
