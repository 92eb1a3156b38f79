// contains: by exact signs if the tolerance is 0. closest_point: in double, relative to the query point or to a corner
// of the shape, so that no digits are lost far from the origin. The formulas are those of Ericson, Real-Time Collision
// Detection (2005), chapter 5; the closest point of a frustum is found by enumeration of its features.
#include "foundation/exact.h"
#include "geometry/heights.h"
#include "geometry/intersect.h"
#include "shapes/halfspaces.h"
#include "shapes/nearest_common_point.h"

namespace gphys {
namespace {

bool within(Vec3 a, Vec3 b, double tolerance) { return length_squared(a - b) <= tolerance * tolerance; }

/// Whether |point - center|^2 <= radius^2, exactly.
bool in_ball(Vec3 center, double radius, Vec3 point) {
    return sign_of([&](auto number) {
               using N = decltype(number);
               const Vec<N> offset = Vec<N>::difference(point, center);
               return dot(offset, offset) - N(radius) * N(radius);
           }) <= 0;
}

}  // namespace

bool contains(const Segment& segment, Vec3 point, double tolerance) {
    return contains(Capsule{segment.a, segment.b, tolerance}, point, 0);
}

bool contains(const Ray& ray, Vec3 point, double tolerance) {
    if (tolerance > 0) return within(closest_point(ray, point), point, tolerance);
    const Vec3 d = ray.direction;
    const auto crossed = [&](int i, int k) {
        return sign_of([&](auto number) {
            using N = decltype(number);
            return N(d[i]) * (N(point[k]) - N(ray.origin[k])) - N(d[k]) * (N(point[i]) - N(ray.origin[i]));
        });
    };
    if (crossed(0, 1) != 0 || crossed(1, 2) != 0 || crossed(2, 0) != 0) return false;
    // On the line of the ray: any coordinate that changes along it gives t.
    const int k = d.x != 0 ? 0 : d.y != 0 ? 1 : 2;
    if ((point[k] - ray.origin[k]) * (d[k] > 0 ? 1 : -1) < 0) return false;
    if (ray.t_max == infinity) return true;
    return sign_of([&](auto number) {
               using N = decltype(number);
               return abs(N(point[k]) - N(ray.origin[k])) - N(ray.t_max) * abs(N(d[k]));
           }) <= 0;
}

bool contains(const Sphere& sphere, Vec3 point, double tolerance) {
    return in_ball(sphere.center, sphere.radius + tolerance, point);
}

bool contains(const Capsule& capsule, Vec3 point, double tolerance) {
    const double radius = capsule.radius + tolerance;
    // On which side of the plane through `from`, perpendicular to the axis, the point is: sign of (to - from).(point -
    // from).
    const auto along = [&](Vec3 from, Vec3 to) {
        return sign_of([&](auto number) {
            using V = Vec<decltype(number)>;
            return dot(V::difference(to, from), V::difference(point, from));
        });
    };
    if (along(capsule.a, capsule.b) <= 0) return in_ball(capsule.a, radius, point);
    if (along(capsule.b, capsule.a) <= 0) return in_ball(capsule.b, radius, point);
    return sign_of([&](auto number) {
               using N = decltype(number);
               const Vec<N> axis = Vec<N>::difference(capsule.b, capsule.a);
               const Vec<N> moment = cross(axis, Vec<N>::difference(point, capsule.a));
               return dot(moment, moment) - N(radius) * N(radius) * dot(axis, axis);
           }) <= 0;
}

bool contains(const Aabb& box, Vec3 point, double tolerance) {
    return within(closest_point(box, point), point, tolerance);
}

bool contains(const Obb& box, Vec3 point, double tolerance) {
    if (tolerance > 0) {
        const Vec3 local = transpose_times(box.axes, point - box.center);
        return contains(Aabb{-box.half, box.half}, local, tolerance);
    }
    const auto beyond = [&](Vec3 axis, double half) {
        return sign_of([&](auto number) {
                   using N = decltype(number);
                   return abs(dot(Vec<N>::of(axis), Vec<N>::difference(point, box.center))) - N(half);
               }) > 0;
    };
    return !beyond(box.axes.x, box.half.x) && !beyond(box.axes.y, box.half.y) && !beyond(box.axes.z, box.half.z);
}

bool contains(const Plane& plane, Vec3 point, double tolerance) {
    // |n.p - d| <= tolerance |n|, squared.
    return sign_of([&](auto number) {
               using N = decltype(number);
               const Vec<N> n = Vec<N>::of(plane.normal);
               const N height = dot(n, Vec<N>::of(point)) - N(plane.distance);
               return height * height - N(tolerance) * N(tolerance) * dot(n, n);
           }) <= 0;
}

bool contains(const Triangle& triangle, Vec3 point, double tolerance) {
    const auto& [a, b, c] = triangle;
    if (tolerance > 0) return within(closest_point(Triangle{a - point, b - point, c - point}, {}), {}, tolerance);
    const int axis = turning_axis(a, b, c);
    if (axis < 0) {
        return contains(Segment{a, b}, point, 0) || contains(Segment{b, c}, point, 0) ||
               contains(Segment{c, a}, point, 0);
    }
    if (orientation(a, b, c, point) != 0) return false;
    const int turn = orientation(a, b, c, axis);
    return orientation(a, b, point, axis) != -turn && orientation(b, c, point, axis) != -turn &&
           orientation(c, a, point, axis) != -turn;
}

bool contains(const Frustum& frustum, Vec3 point, double tolerance) {
    bool inside = true;
    for (int i = 0; i < 6; ++i) {
        const PlaneAt plane = plane_at(frustum, i);
        const double height = value_of([&](auto number) { return height_above<decltype(number)>(plane, point); });
        if (height >= 0) continue;
        // Early out: beyond one plane by more than the tolerance and the rounding error of this product.
        if (-height > tolerance * length(plane.normal) * (1 + 0x1p-40)) return false;
        inside = false;
    }
    if (inside) return true;
    Frustum around = frustum;
    around.origin -= point;
    Vec3 nearest;
    return closest_point(around, {}, nearest) && within(nearest, {}, tolerance);
}

Vec3 closest_point(const Segment& segment, Vec3 point) {
    const Vec3 along = segment.b - segment.a;
    const double t = dot(point - segment.a, along);
    const double square = length_squared(along);
    if (t <= 0) return segment.a;  // also if a == b
    if (t >= square) return segment.b;
    return segment.a + along * (t / square);
}

Vec3 closest_point(const Ray& ray, Vec3 point) {
    const double t = dot(point - ray.origin, ray.direction);
    if (t <= 0) return ray.origin;
    return ray.origin + ray.direction * std::min(t / length_squared(ray.direction), ray.t_max);
}

Vec3 closest_point(const Sphere& sphere, Vec3 point) {
    if (contains(sphere, point, 0)) return point;
    const Vec3 outward = point - sphere.center;
    return sphere.center + outward * (sphere.radius / length(outward));
}

Vec3 closest_point(const Capsule& capsule, Vec3 point) {
    if (contains(capsule, point, 0)) return point;
    const Vec3 core = closest_point(Segment{capsule.a, capsule.b}, point);
    const Vec3 outward = point - core;
    return core + outward * (capsule.radius / length(outward));
}

Vec3 closest_point(const Aabb& box, Vec3 point) { return min(max(point, box.min), box.max); }

Vec3 closest_point(const Obb& box, Vec3 point) {
    const Vec3 local = transpose_times(box.axes, point - box.center);
    const Vec3 clamped = min(max(local, -box.half), box.half);
    return clamped == local ? point : box.center + box.axes * clamped;
}

Vec3 closest_point(const Plane& plane, Vec3 point) {
    const double height = dot(plane.normal, point) - plane.distance;
    return point - plane.normal * (height / length_squared(plane.normal));
}

namespace {

double sum(Vec3 v) { return v.x + v.y + v.z; }

/// Whether a point, projected along the triangle's normal, is on the inner side of an edge, exactly.
bool is_beside_edge(const Triangle& triangle, Vec3 from, Vec3 to, Vec3 point) {
    return sign_of([&](auto number) {
               using V = Vec<decltype(number)>;
               const V normal = cross(V::difference(triangle.b, triangle.a), V::difference(triangle.c, triangle.a));
               return dot(cross(normal, V::difference(to, from)), V::difference(point, from));
           }) >= 0;
}

/// Whether a point, projected along the normal, is inside all edges. True is exact, because the projection of a point
/// outside a sliver may be far away. False may be wrong by rounding, but then an edge is as near as the face.
bool is_above(const Triangle& triangle, Vec3 normal, Vec3 point) {
    const auto& [a, b, c] = triangle;
    const auto side = [&](Vec3 from, Vec3 to) { return dot(cross(normal, to - from), point - from); };
    if (!(side(a, b) >= 0 && side(b, c) >= 0 && side(c, a) >= 0)) return false;
    // The six products of a side have the error 2^-44 of the normal and fewer than 16 roundings of 2^-53 of their
    // factors. No edge is longer than the other two together, and no corner is farther away than a and these.
    const double edges = sum(abs(b - a)) + sum(abs(c - a));
    const double error = 0x1p-43 * sum(abs(normal)) * edges * (sum(abs(point - a)) + edges);
    const auto is_certain = [&](Vec3 from, Vec3 to) {
        return side(from, to) > error || is_beside_edge(triangle, from, to, point);
    };
    return is_certain(a, b) && is_certain(b, c) && is_certain(c, a);
}

}  // namespace

Vec3 closest_point(const Triangle& triangle, Vec3 point) {
    const auto& [a, b, c] = triangle;
    // accurate_cross, because for a sliver cross(b - a, c - a) is mostly rounding error.
    const Vec3 normal = accurate_cross(a, b, a, c);
    if (normal != Vec3{} && is_above(triangle, normal, point)) {
        return point - normal * (dot(normal, point - a) / length_squared(normal));
    }
    Vec3 best = closest_point(Segment{a, b}, point);
    for (const Segment& edge : {Segment{b, c}, Segment{c, a}}) {
        const Vec3 candidate = closest_point(edge, point);
        if (length_squared(candidate - point) < length_squared(best - point)) best = candidate;
    }
    return best;
}

namespace {

/// A face, an edge or a corner: one to three planes.
struct Feature {
    int count;
    int plane[3];

    bool has(int i) const { return std::find(plane, plane + count, i) != plane + count; }
};

/// The closest point of a frustum by enumeration: the nearest of the projections of the point on a face, on an edge
/// (the line of two planes) or on a corner (of three planes) that lie in the frustum. Whether they do is exact, because
/// where planes meet at a small angle, a projection that is hardly outside of one is far from the frustum.
class NearestFoot {
public:
    NearestFoot(const Plane (&planes)[6], Vec3 point) : point_(point) {
        for (int i = 0; i < 6; ++i) {
            planes_[i] = scaled_to_one(planes[i]);
            size_[i] = length(planes_[i].normal);
            if (size_[i] > 0) bounding_[bounding_count_++] = i;
        }
    }

    /// The projection on the planes that the active-set search of nearest_common_point found. False if it is not in the
    /// frustum, or not certainly the nearest.
    bool try_likely() {
        Plane from_point[6];
        for (int i = 0; i < bounding_count_; ++i) from_point[i] = seen_from_point(bounding_[i]);
        const CommonPoint likely = nearest_common_point(from_point, bounding_count_);
        if (likely.outcome != CommonPoint::Outcome::found || likely.plane_count == 0) return false;
        Feature feature{likely.plane_count, {}};
        for (int k = 0; k < feature.count; ++k) feature.plane[k] = bounding_[likely.planes[k]];
        if (!try_feature(feature) || !is_surely_nearest(feature)) square_ = infinity;
        return found();
    }
    void try_all() {
        for (int i = 0; i < bounding_count_; ++i) {
            try_feature({1, {bounding_[i]}});
            for (int j = i + 1; j < bounding_count_; ++j) {
                try_feature({2, {bounding_[i], bounding_[j]}});
                for (int k = j + 1; k < bounding_count_; ++k) {
                    try_feature({3, {bounding_[i], bounding_[j], bounding_[k]}});
                }
            }
        }
    }

    /// False after try_all only if the frustum is empty.
    bool found() const { return square_ < infinity; }
    Vec3 foot() const { return foot_; }

private:
    Plane seen_from_point(int i) const {
        return {planes_[i].normal, planes_[i].distance - dot(planes_[i].normal, point_)};
    }
    const Plane& plane(const Feature& feature, int k) const { return planes_[feature.plane[k]]; }

    /// Keeps the projection if it is in the frustum and nearer than the one that is kept.
    bool try_feature(const Feature& feature) {
        Vec3 foot;
        if (!project(feature, foot)) return false;
        const double square = length_squared(foot - point_);
        if (!(square < square_) || !is_inside(foot, feature)) return false;
        foot_ = foot;
        square_ = square;
        return true;
    }
    bool project(const Feature& feature, Vec3& foot) const {
        const Plane& a = plane(feature, 0);
        if (feature.count == 1) {
            foot = point_ + foot_on(seen_from_point(feature.plane[0]));
            return true;
        }
        const Plane& b = plane(feature, 1);
        if (feature.count == 3) return common_point(a, b, plane(feature, 2), foot);
        // The common point of two planes and of the plane through the point perpendicular to their line: accurate at
        // any angle.
        const Vec3 line = accurate_cross({}, a.normal, {}, b.normal);
        return common_point(a, b, {line, dot(line, point_)}, foot);
    }

    bool is_inside(Vec3 foot, const Feature& feature) const {
        const double reach = length(foot) + length(point_);
        for (int i = 0; i < 6; ++i) {
            // Coordinates of a projection have an error of about 2^-42 of themselves.
            const double slack = 0x1p-40 * size_[i] * reach;
            const double height = dot(planes_[i].normal, foot) - planes_[i].distance;
            if (height < -slack) return false;
            if (height <= slack && !feature.has(i) && !is_in_front(planes_[i], feature)) return false;
        }
        return true;
    }

    /// Whether the exact projection is in front of another plane, or on it.
    bool is_in_front(const Plane& other, const Feature& feature) const {
        if (feature.count == 3) return corner_is_in_front(other, feature);
        return sign_of([&](auto number) {
                   using N = decltype(number);
                   const Vec3 n = other.normal, a = plane(feature, 0).normal;
                   const N height = dot_of<N>(n, point_) - N(other.distance);
                   const N behind_a = N(plane(feature, 0).distance) - dot_of<N>(a, point_), aa = dot_of<N>(a, a);
                   if (feature.count == 1) return height * aa + dot_of<N>(n, a) * behind_a;
                   const Vec3 b = plane(feature, 1).normal;
                   const N behind_b = N(plane(feature, 1).distance) - dot_of<N>(b, point_);
                   const N bb = dot_of<N>(b, b), ab = dot_of<N>(a, b);
                   // As in foot_on of two planes. A statement for each term, which takes less stack than one sum.
                   N sum = height * (aa * bb - ab * ab);
                   sum = sum + dot_of<N>(n, a) * (behind_a * bb - behind_b * ab);
                   return sum + dot_of<N>(n, b) * (behind_b * aa - behind_a * ab);
               }) >= 0;
    }
    bool corner_is_in_front(const Plane& other, const Feature& feature) const {
        const Plane &a = plane(feature, 0), &b = plane(feature, 1), &c = plane(feature, 2);
        const int volume =
            sign_of([&](auto number) { return determinant_of<decltype(number)>(a.normal, b.normal, c.normal); });
        return volume * sign_of([&](auto number) {
                   using N = decltype(number);
                   return a.distance * determinant_of<N>(other.normal, b.normal, c.normal) +
                          b.distance * determinant_of<N>(other.normal, c.normal, a.normal) +
                          c.distance * determinant_of<N>(other.normal, a.normal, b.normal) -
                          other.distance * determinant_of<N>(a.normal, b.normal, c.normal);
               }) >=
               0;
    }

    /// The conditions of Karush, Kuhn and Tucker: the way from the point to its projection is a sum of the normals with
    /// positive multipliers. In double, with a margin for rounding.
    bool is_surely_nearest(const Feature& feature) const {
        const Vec3 way = foot_ - point_, a = plane(feature, 0).normal;
        const double error = 0x1p-40 * (length(foot_) + length(point_));
        if (feature.count == 1) return true;  // the search started from a plane that the point is behind
        const Vec3 b = plane(feature, 1).normal;
        if (feature.count == 2) {
            const double aa = length_squared(a), bb = length_squared(b), ab = dot(a, b);
            const double along_a = dot(way, a), along_b = dot(way, b);
            return along_a * bb - along_b * ab > error * bb && along_b * aa - along_a * ab > error * aa;
        }
        const Vec3 c = plane(feature, 2).normal;
        const Vec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
        const double volume = dot(a, bc), turn = volume < 0 ? -1 : 1;
        return std::fabs(volume) > 0x1p-40 && turn * dot(way, bc) > error && turn * dot(way, ca) > error &&
               turn * dot(way, ab) > error;
    }

    Plane planes_[6];
    double size_[6];  // of the normals
    int bounding_[6], bounding_count_ = 0;
    Vec3 point_, foot_;
    double square_ = infinity;
};

}  // namespace

bool closest_point(const Frustum& frustum, Vec3 point, Vec3& out) {
    if (contains(frustum, point, 0)) {
        out = point;
        return true;
    }
    NearestFoot nearest(frustum.planes, point - frustum.origin);
    if (!nearest.try_likely()) nearest.try_all();
    if (!nearest.found()) return false;
    out = frustum.origin + nearest.foot();
    return true;
}

void closest_points(const Segment& a, const Segment& b, Vec3& out_a, Vec3& out_b) {
    const Vec3 along_a = a.b - a.a, along_b = b.b - b.a, between = b.a - a.a;
    const double aa = length_squared(along_a), bb = length_squared(along_b);
    // Ericson's denominator aa bb - ab^2 is the squared length of this normal, which does not cancel.
    const Vec3 normal = accurate_cross(a.a, a.b, b.a, b.b);
    double s = 0;
    if (normal != Vec3{}) {
        s = std::clamp(dot(cross(between, along_b), normal) / length_squared(normal), 0.0, 1.0);
    } else if (aa > 0 && bb > 0) {
        // Parallel: the first point of a whose projection is on b.
        const double start = dot(between, along_a) / aa, end = dot(b.b - a.a, along_a) / aa;
        s = std::clamp(std::min(start, end), 0.0, 1.0);
    }
    // Project that point on the line of b. If the projection is beyond an end of b, project that end on a.
    const double t = bb > 0 ? (dot(along_a, along_b) * s - dot(between, along_b)) / bb : 0;
    out_b = t <= 0 ? b.a : t >= 1 ? b.b : b.a + along_b * t;
    if (t > 0 && t < 1) {
        out_a = s == 1 ? a.b : a.a + along_a * s;
    } else {
        out_a = closest_point(a, out_b);
    }
}

}  // namespace gphys
