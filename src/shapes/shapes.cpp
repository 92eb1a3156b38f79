// Validation, bounds and transforms of the primitives (shapes.h).
#include "shapes/shapes.h"

#include <limits>

#include "foundation/exact.h"
#include "foundation/float4.h"

namespace gphys {
namespace {

// Comparisons by name (std::islessequal, ...) are false for NaN without raising FE_INVALID, which a
// host may trap.
bool in_range(float v) { return std::islessequal(std::fabs(v), GPHYS_MAX_COORDINATE); }
bool is_size(float v) { return in_range(v) && v >= 0; }
bool is_zero(const gphys_vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }
double square_of(const gphys_quat& q) {
    const Quat d = widen(q);
    return d.x * d.x + d.y * d.y + d.z * d.z + d.w * d.w;
}
bool is_rotation(const gphys_quat& q) {
    const double square = square_of(q);
    return std::isgreaterequal(square, 0.999 * 0.999) && square <= 1.001 * 1.001;
}
/// The lanes whose magnitude is above a limit, or NaN. Compares the bits as integers, which raises no exception.
Mask4 beyond(Float4 v, Float4 limit) { return greater_bits(abs(v), limit); }
/// A fast test that accepts almost all valid transforms.
bool is_surely_valid(const gphys_transform& transform) {
    static_assert(sizeof transform == 2 * sizeof(Float4));
    constexpr float above_one = 1.0019f;  // of the square: five roundings stay below 1.001^2
    const Float4 position_and_x(GPHYS_MAX_COORDINATE, GPHYS_MAX_COORDINATE, GPHYS_MAX_COORDINATE, 2);
    const Float4 yzw_and_scale(2, 2, 2, GPHYS_MAX_COORDINATE);
    Float4 parts[2];
    std::memcpy(parts, &transform, sizeof parts);
    if (any(beyond(parts[0], position_and_x) | beyond(parts[1], yzw_and_scale))) return false;
    const Float4 q = load4(transform.rotation);
    const float square = sum(q * q)[0];
    return square < above_one && square > 2 - above_one && transform.scale > 0;
}

bool is_surely_valid(const gphys_ray& ray) {
    static_assert(sizeof ray == 7 * sizeof(float));
    constexpr float max = GPHYS_MAX_COORDINATE, least = std::numeric_limits<float>::min();
    const Float4 origin_and_x(max, max, max, max);
    const Float4 direction_and_t(max, max, max, std::numeric_limits<float>::infinity());
    const Float4 some_direction(least, least, least, std::numeric_limits<float>::infinity());
    Float4 first, last;
    std::memcpy(&first, &ray, sizeof first);
    std::memcpy(&last, &ray.direction, sizeof last);
    const Mask4 negative_t = as_mask(last) & mask4(0, 0, 0, INT32_MIN);
    return !any(beyond(first, origin_and_x) | beyond(last, direction_and_t) | negative_t) &&
           any(beyond(last, some_direction));
}

/// Whether the plane is too far from the origin for its short normal: results could exceed the largest float. The
/// tolerance accepts unit normals that rounding to float has made shorter by about 2^-24.
bool is_far(const gphys_plane& plane) {
    constexpr double furthest = double{GPHYS_MAX_COORDINATE} * (1 + 0x1p-22);
    return std::fabs(static_cast<double>(plane.distance)) > furthest * length(widen(plane.normal));
}

constexpr char coordinate[] = "from -1e15 to 1e15";
constexpr char size[] = "from 0 to 1e15";
constexpr char unit_length[] = "from 0.999 to 1.001";

Defect defect(const char* field, const gphys_vec3& v) {
    if (!in_range(v.x)) return {field, 'x', v.x, coordinate};
    if (!in_range(v.y)) return {field, 'y', v.y, coordinate};
    if (!in_range(v.z)) return {field, 'z', v.z, coordinate};
    return {};
}

Defect defect(const char* field, const gphys_quat& q) {
    return is_rotation(q) ? Defect{} : Defect{field, 0, std::sqrt(square_of(q)), unit_length};
}

Defect defect_of_size(const char* field, char axis, float value) {
    return is_size(value) ? Defect{} : Defect{field, axis, value, size};
}

}  // namespace

Defect defect(const gphys_vec3& point) { return defect("", point); }

Defect defect(const gphys_quat& rotation) { return defect(": length", rotation); }

Defect defect(const gphys_transform& transform) {
    if (is_surely_valid(transform)) return {};
    if (const Defect d = defect(".position", transform.position)) return d;
    if (const Defect d = defect(".rotation: length", transform.rotation)) return d;
    if (!(is_size(transform.scale) && transform.scale > 0)) {
        return {".scale", 0, transform.scale, "above 0 and at most 1e15"};
    }
    return {};
}

Defect defect(const gphys_ray& ray) {
    if (is_surely_valid(ray)) return {};
    if (const Defect d = defect(".origin", ray.origin)) return d;
    if (const Defect d = defect(".direction", ray.direction)) return d;
    if (is_zero(ray.direction)) return {".direction: length", 0, 0, "above 0"};
    if (!std::isgreaterequal(ray.t_max, 0.0f)) return {".t_max", 0, ray.t_max, "0 or more"};
    return {};
}

Defect defect(const gphys_segment& segment) {
    if (const Defect d = defect(".a", segment.a)) return d;
    return defect(".b", segment.b);
}

Defect defect(const gphys_sphere& sphere) {
    if (const Defect d = defect(".center", sphere.center)) return d;
    return defect_of_size(".radius", 0, sphere.radius);
}

Defect defect(const gphys_capsule& capsule) {
    if (const Defect d = defect(".a", capsule.a)) return d;
    if (const Defect d = defect(".b", capsule.b)) return d;
    return defect_of_size(".radius", 0, capsule.radius);
}

Defect defect(const gphys_aabb& box) {
    if (const Defect d = defect(".min", box.min)) return d;
    if (const Defect d = defect(".max", box.max)) return d;
    if (box.min.x > box.max.x) return {".min", 'x', box.min.x, "at most max.x"};
    if (box.min.y > box.max.y) return {".min", 'y', box.min.y, "at most max.y"};
    if (box.min.z > box.max.z) return {".min", 'z', box.min.z, "at most max.z"};
    return {};
}

Defect defect(const gphys_obb& box) {
    if (const Defect d = defect(".center", box.center)) return d;
    if (const Defect d = defect_of_size(".half_extents", 'x', box.half_extents.x)) return d;
    if (const Defect d = defect_of_size(".half_extents", 'y', box.half_extents.y)) return d;
    if (const Defect d = defect_of_size(".half_extents", 'z', box.half_extents.z)) return d;
    return defect(".rotation: length", box.rotation);
}

Defect defect(const gphys_plane& plane) {
    if (const Defect d = defect(".normal", plane.normal)) return d;
    if (is_zero(plane.normal)) return {".normal: length", 0, 0, "above 0"};
    if (!in_range(plane.distance)) return {".distance", 0, plane.distance, coordinate};
    if (is_far(plane)) return {".distance / |normal|", 0, plane.distance / length(widen(plane.normal)), coordinate};
    return {};
}

Defect defect(const gphys_triangle& triangle) {
    if (const Defect d = defect(".a", triangle.a)) return d;
    if (const Defect d = defect(".b", triangle.b)) return d;
    return defect(".c", triangle.c);
}

Defect defect(const gphys_frustum& frustum) {
    static constexpr const char* normals[] = {".planes[0].normal", ".planes[1].normal", ".planes[2].normal",
                                              ".planes[3].normal", ".planes[4].normal", ".planes[5].normal"};
    static constexpr const char* lengths[] = {".planes[0].normal: length", ".planes[1].normal: length",
                                              ".planes[2].normal: length", ".planes[3].normal: length",
                                              ".planes[4].normal: length", ".planes[5].normal: length"};
    static constexpr const char* distances[] = {".planes[0].distance", ".planes[1].distance", ".planes[2].distance",
                                                ".planes[3].distance", ".planes[4].distance", ".planes[5].distance"};
    static constexpr const char* quotients[] = {".planes[0].distance / |normal|", ".planes[1].distance / |normal|",
                                                ".planes[2].distance / |normal|", ".planes[3].distance / |normal|",
                                                ".planes[4].distance / |normal|", ".planes[5].distance / |normal|"};
    if (const Defect d = defect(".origin", frustum.origin)) return d;
    for (int i = 0; i < 6; ++i) {
        const gphys_plane& plane = frustum.planes[i];
        if (const Defect d = defect(normals[i], plane.normal)) return d;
        if (!in_range(plane.distance)) return {distances[i], 0, plane.distance, coordinate};
        if (is_zero(plane.normal)) {
            if (i == GPHYS_FRUSTUM_FAR && plane.distance == -1) continue;
            return {lengths[i], 0, 0, "above 0 (an infinite far plane has distance -1)"};
        }
        if (is_far(plane)) return {quotients[i], 0, plane.distance / length(widen(plane.normal)), coordinate};
    }
    return {};
}

namespace {

/// The largest float <= base - reach. The difference is rounded; the error term of Knuth's two-sum decides on which
/// side of it the exact value is.
float lower_bound(double base, double reach) {
    const double difference = base - reach;
    const double reach_part = base - difference;
    const double base_part = difference + reach_part;
    return round_down(difference, (base - base_part) - (reach - reach_part));
}
float upper_bound(double base, double reach) { return -lower_bound(-base, reach); }

/// The box of the points low - reach .. high + reach.
Box box_around(Vec3 low, Vec3 high, Vec3 reach) {
    Box box;
    for (int k = 0; k < 3; ++k) {
        box.min[k] = lower_bound(low[k], reach[k]);
        box.max[k] = upper_bound(high[k], reach[k]);
    }
    return box;
}

}  // namespace

Box bounds(const Segment& segment) { return box_around(min(segment.a, segment.b), max(segment.a, segment.b), {}); }

Box bounds(const Sphere& sphere) {
    return box_around(sphere.center, sphere.center, {sphere.radius, sphere.radius, sphere.radius});
}

Box bounds(const Capsule& capsule) {
    return box_around(min(capsule.a, capsule.b), max(capsule.a, capsule.b),
                      {capsule.radius, capsule.radius, capsule.radius});
}

Box bounds(const Aabb& box) { return box_around(box.min, box.max, {}); }

Box bounds(const Obb& box) {
    // The error of a matrix element is at most 6 roundings of 2^-53, and a sum of three products adds 3: 2^-49 of the
    // half diagonal covers them. If every axis is exactly parallel to a world axis, nothing was rounded.
    const Vec3 reach = abs(box.axes) * box.half;
    const double slack = axis_parallel(box.axes) ? 0 : 0x1p-49 * (box.half.x + box.half.y + box.half.z);
    return box_around(box.center, box.center, reach + Vec3{slack, slack, slack});
}

Box bounds(const Triangle& triangle) {
    return box_around(min(min(triangle.a, triangle.b), triangle.c), max(max(triangle.a, triangle.b), triangle.c), {});
}

bool bounds(const Ray& ray, Box& out) {
    Box box;
    for (int k = 0; k < 3; ++k) {
        if (std::fabs(ray.direction[k]) > 0 && ray.t_max > std::numeric_limits<float>::max()) return false;
        // A product of two floats is exact.
        const double reach = ray.direction[k] == 0 ? 0 : ray.direction[k] * ray.t_max;
        if (std::fabs(ray.origin[k] + reach) > std::numeric_limits<float>::max()) return false;
        box.min[k] = lower_bound(ray.origin[k], std::max(-reach, 0.0));
        box.max[k] = upper_bound(ray.origin[k], std::max(reach, 0.0));
    }
    out = box;
    return true;
}

namespace {

// A transform and its inverse, applied to the parts of shapes.

struct Forward {
    const Transform& t;
    Vec3 point(Vec3 p) const { return t.apply(p); }
    Vec3 rotate(Vec3 v) const { return t.rotation * v; }
    Mat3 axes() const { return t.rotation; }
    double size(double s) const { return s * t.scale; }
    // n.x = d and x' = p + s R x give (R n).x' = s d + (R n).p
    Plane plane(const Plane& plane) const {
        const Vec3 normal = rotate(plane.normal);
        return {normal, plane.distance * t.scale + dot(normal, t.position)};
    }
};

struct Backward {
    const Transform& t;
    Vec3 point(Vec3 p) const { return t.inverse_apply(p); }
    Vec3 rotate(Vec3 v) const { return transpose_times(t.rotation, v); }
    Mat3 axes() const { return {rotate({1, 0, 0}), rotate({0, 1, 0}), rotate({0, 0, 1})}; }
    double size(double s) const { return s / t.scale; }
    Plane plane(const Plane& plane) const {
        return {rotate(plane.normal), (plane.distance - dot(plane.normal, t.position)) / t.scale};
    }
};

bool turns(const Mat3& rotation) {
    const Mat3 none;
    return !(rotation.x == none.x && rotation.y == none.y && rotation.z == none.z);
}

template <class Map>
Sphere moved(const Sphere& sphere, const Map& map) {
    return {map.point(sphere.center), map.size(sphere.radius)};
}
template <class Map>
Capsule moved(const Capsule& capsule, const Map& map) {
    return {map.point(capsule.a), map.point(capsule.b), map.size(capsule.radius)};
}
template <class Map>
Obb moved(const Obb& box, const Map& map) {
    return {map.point(box.center),
            {map.size(box.half.x), map.size(box.half.y), map.size(box.half.z)},
            {map.rotate(box.axes.x), map.rotate(box.axes.y), map.rotate(box.axes.z)}};
}
template <class Map>
Obb moved(const Aabb& aabb, const Map& map) {
    const Obb box = as_obb(aabb);
    return {map.point(box.center), {map.size(box.half.x), map.size(box.half.y), map.size(box.half.z)}, map.axes()};
}
template <class Map>
Plane moved(const Plane& plane, const Map& map) {
    return map.plane(plane);
}
template <class Map>
Triangle moved(const Triangle& triangle, const Map& map) {
    return {map.point(triangle.a), map.point(triangle.b), map.point(triangle.c)};
}
template <class Map>
Frustum moved(const Frustum& frustum, const Map& map) {
    Frustum result{map.point(frustum.origin), {}};
    for (int i = 0; i < 6; ++i) {
        const Plane& plane = frustum.planes[i];
        // An infinite far plane stays one.
        result.planes[i] = plane.normal == Vec3{} ? plane : Plane{map.rotate(plane.normal), map.size(plane.distance)};
    }
    return result;
}

}  // namespace

Vec3 end_of(const Ray& segment) {
    // If the sum of origin and direction cancels, it and the following sums are exact. Otherwise the error of the
    // second is below 2^-103 of the end, which is a double.
    Vec3 error;
    const Vec3 sum = difference(segment.origin, -segment.direction, error);
    return sum + (error + segment.rest);
}

Ray transformed(const Ray& ray, const Transform& t) {
    return {t.apply(ray.origin), t.apply_to_vector(ray.direction), ray.t_max};
}
Segment transformed(const Segment& segment, const Transform& t) { return {t.apply(segment.a), t.apply(segment.b)}; }
Sphere transformed(const Sphere& sphere, const Transform& t) { return moved(sphere, Forward{t}); }
Capsule transformed(const Capsule& capsule, const Transform& t) { return moved(capsule, Forward{t}); }
Obb transformed(const Aabb& box, const Transform& t) { return moved(box, Forward{t}); }
Obb transformed(const Obb& box, const Transform& t) { return moved(box, Forward{t}); }
Plane transformed(const Plane& plane, const Transform& t) { return moved(plane, Forward{t}); }
Triangle transformed(const Triangle& triangle, const Transform& t) { return moved(triangle, Forward{t}); }
Frustum transformed(const Frustum& frustum, const Transform& t) { return moved(frustum, Forward{t}); }

Shape inverse_transformed(const Shape& shape, const Transform& t) {
    // A box along the axes stays one where it can: its tests are exact, and quicker.
    const Aabb* const box = std::get_if<Aabb>(&shape);
    if (box && !turns(t.rotation)) return Aabb{t.inverse_apply(box->min), t.inverse_apply(box->max)};
    return std::visit([&](const auto& s) { return Shape(moved(s, Backward{t})); }, shape);
}

Sphere relative_to(Vec3 point, const Sphere& s) { return {s.center - point, s.radius}; }
Capsule relative_to(Vec3 point, const Capsule& c) { return {c.a - point, c.b - point, c.radius}; }
Aabb relative_to(Vec3 point, const Aabb& b) { return {b.min - point, b.max - point}; }
Obb relative_to(Vec3 point, const Obb& b) { return {b.center - point, b.half, b.axes}; }
Plane relative_to(Vec3 point, const Plane& p) {
    const double height = value_of([&](auto number) {
        using V = Vec<decltype(number)>;
        return dot(V::of(p.normal), V::of(point)) - decltype(number)(p.distance);
    });
    return {p.normal, -height};
}
Triangle relative_to(Vec3 point, const Triangle& t) { return {t.a - point, t.b - point, t.c - point}; }
Segment relative_to(Vec3 point, const Segment& s) { return {s.a - point, s.b - point}; }
Ray relative_to(Vec3 point, const Ray& r) { return {r.origin - point, r.direction, r.t_max}; }
Frustum relative_to(Vec3 point, const Frustum& f) {
    Frustum result = f;
    result.origin = f.origin - point;
    return result;
}

Obb as_obb(const Aabb& box) { return {(box.min + box.max) * 0.5, (box.max - box.min) * 0.5, {}}; }

bool axis_parallel(const Mat3& axes) {
    const auto along_one_axis = [](Vec3 v) { return (v.x != 0) + (v.y != 0) + (v.z != 0) == 1; };
    return along_one_axis(axes.x) && along_one_axis(axes.y) && along_one_axis(axes.z);
}

namespace {

/// Number k of the planes that meet in corner i of a frustum; the opposite of each is the other one of its pair.
int plane_at_corner(int i, int k) {
    constexpr int depth[2] = {GPHYS_FRUSTUM_NEAR, GPHYS_FRUSTUM_FAR};
    constexpr int around[4][2] = {{GPHYS_FRUSTUM_LEFT, GPHYS_FRUSTUM_BOTTOM},
                                  {GPHYS_FRUSTUM_RIGHT, GPHYS_FRUSTUM_BOTTOM},
                                  {GPHYS_FRUSTUM_RIGHT, GPHYS_FRUSTUM_TOP},
                                  {GPHYS_FRUSTUM_LEFT, GPHYS_FRUSTUM_TOP}};
    return k == 0 ? depth[i / 4] : around[i % 4][k - 1];
}

}  // namespace

bool corners(const Frustum& frustum, Vec3 out[8]) {
    constexpr double largest = std::numeric_limits<float>::max();
    Vec3 found[8];
    for (int i = 0; i < 8; ++i) {
        const auto plane = [&](int k) { return frustum.planes[plane_at_corner(i, k)]; };
        Vec3 from_origin;
        if (!common_point(plane(0), plane(1), plane(2), from_origin)) return false;
        found[i] = frustum.origin + from_origin;
        // Almost parallel planes may intersect beyond the largest float.
        if (!(max_component(abs(found[i])) <= largest)) return false;
    }
    std::copy(found, found + 8, out);
    return true;
}

bool is_hexahedron(const Frustum& frustum) {
    Vec3 corner[8];
    if (!corners(relative_to(frustum.origin, frustum), corner)) return false;
    for (int i = 0; i < 8; ++i) {
        if (!(max_component(abs(frustum.origin + corner[i])) <= GPHYS_MAX_COORDINATE)) return false;
        for (int k = 0; k < 3; ++k) {
            const Plane& opposite = frustum.planes[plane_at_corner(i, k) ^ 1];
            // Coordinates of a corner have an error of 2^-42 of themselves.
            const double size = dot(abs(opposite.normal), abs(corner[i])) + std::fabs(opposite.distance);
            if (!(dot(opposite.normal, corner[i]) - opposite.distance > 0x1p-41 * size)) return false;
        }
    }
    return true;
}

Plane scaled_to_one(const Plane& plane) {
    const double largest = max_component(abs(plane.normal));
    if (largest == 0) return plane;
    const double scale = std::scalbn(1.0, -std::ilogb(largest));
    return {plane.normal * scale, plane.distance * scale};
}

bool common_point(const Plane& a, const Plane& b, const Plane& c, Vec3& out) {
    const auto determinant = [](Vec3 x, Vec3 y, Vec3 z) {
        return value_of([&](auto number) { return determinant_of<decltype(number)>(x, y, z); });
    };
    const double volume = determinant(a.normal, b.normal, c.normal);
    if (volume == 0) return false;
    // Cramer's rule: the column of an axis is replaced by the distances.
    const Vec3 d{a.distance, b.distance, c.distance};
    const Vec3 x{a.normal.x, b.normal.x, c.normal.x};
    const Vec3 y{a.normal.y, b.normal.y, c.normal.y};
    const Vec3 z{a.normal.z, b.normal.z, c.normal.z};
    out = Vec3{determinant(d, y, z), determinant(x, d, z), determinant(x, y, d)} / volume;
    return true;
}

}  // namespace gphys
