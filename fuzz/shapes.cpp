// Questions about shapes, without a scene. Of each question all that must hold without knowing the answer: both
// argument orders, a batch against single calls, and what the answers of different questions say about each other.
// What holds between a question and the same one moved, turned or scaled is in shape_relations.cpp.
#include <cmath>
#include <limits>
#include <vector>

#include "check.h"
#include "program.h"
#include "shape_relations.h"

namespace fuzz {

const char* const target_name = "shapes";

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

bool is_finite(const gphys_vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// A hit as the header describes it.
/// A sweep that starts touching has the normal of the place where it touches. Other sweeps have one that is not along
/// the motion at all, rays one that its rounding to floats may have moved.
void check_hit(const gphys_hit& hit, float t_max, gphys_vec3 direction, bool sweep = false) {
    FUZZ_CHECK(hit.t >= 0 && hit.t <= t_max, "0 <= t <= t_max");
    FUZZ_CHECK((hit.flags & ~(GPHYS_HIT_INSIDE | GPHYS_HIT_BACK)) == 0, "a hit's flags are of the header");
    FUZZ_CHECK(!(hit.flags & GPHYS_HIT_INSIDE) || hit.t == 0, "what starts inside hits at 0");
    FUZZ_CHECK(is_finite(hit.point) && is_finite(hit.normal), "a hit's point and normal are finite");
    const double x = hit.normal.x, y = hit.normal.y, z = hit.normal.z, square = x * x + y * y + z * z;
    const double length = std::sqrt(double{direction.x} * direction.x + double{direction.y} * direction.y +
                                    double{direction.z} * direction.z);
    FUZZ_CHECK(std::fabs(square - 1) < 1e-5 || (square == 0 && length == 0), "a hit's normal is a unit vector");
    if (sweep && (hit.flags & GPHYS_HIT_INSIDE)) return;
    FUZZ_CHECK(x * direction.x + y * direction.y + z * direction.z <= (sweep ? 0 : 1e-6 * length),
               "a normal is against the motion");
}

/// A type and a shape of it, which may be spoiled, and what a call must answer if it is.
struct Asked {
    AnyShape shape;
    bool valid;
    explicit Asked(Program& p, bool lines = false) {
        const gphys_shape_type types[] = {GPHYS_SHAPE_RAY, GPHYS_SHAPE_SEGMENT};
        shape = p.shape(lines && p.one_in(8) ? types[p.below(2)] : p.shape_type(true));
        p.spoil(shape, 24);
        valid = is_valid(shape);
    }
};

void validation(Program& p) {
    const Asked a(p, true);
    const gphys_status status = call(gphys_shape_validate, a.shape.type, a.shape.bytes);
    FUZZ_CHECK(status == (a.valid ? GPHYS_OK : GPHYS_ERROR_INVALID_ARGUMENT), "validate follows the header's ranges");
    const int32_t type = static_cast<int32_t>(p.below(20));
    const bool known = (type >= GPHYS_SHAPE_SPHERE && type <= GPHYS_SHAPE_MESH) || type >= GPHYS_SHAPE_RAY;
    const bool exists = known && type <= GPHYS_SHAPE_SEGMENT;
    const gphys_status null_status = call(gphys_shape_validate, type, nullptr);
    FUZZ_CHECK(null_status == GPHYS_ERROR_INVALID_ARGUMENT || !exists, "a null shape is refused");
    if (!exists) FUZZ_CHECK(null_status < 0, "an unknown type is refused");
}

void bounds(Program& p) {
    const Asked a(p, true);
    Output<gphys_aabb> box;
    const gphys_status status = call(gphys_shape_bounds, a.shape.type, a.shape.bytes, &box.value);
    box.after(status);
    FUZZ_CHECK(a.valid == (status >= 0), "bounds of valid shapes only");
    if (status != GPHYS_OK) {
        FUZZ_CHECK(box.untouched(), "without bounds the output is untouched");
        return;
    }
    FUZZ_CHECK(
        box.value.min.x <= box.value.max.x && box.value.min.y <= box.value.max.y && box.value.min.z <= box.value.max.z,
        "bounds are a box");
    // The closest point to anything lies in the bounds, but for its own rounding.
    Output<gphys_nearest> near;
    const gphys_vec3 from = p.point();
    if (call(gphys_shape_closest_point, a.shape.type, a.shape.bytes, &from, &near.value) != GPHYS_OK) return;
    const double slack = 0x1p-22 * reach(a.shape, from) + 0x1p-148;
    const auto between = [&](float low, float value, float high) {
        return low - slack <= value && value <= high + slack;
    };
    const gphys_vec3 &at = near.value.point, &low = box.value.min, &high = box.value.max;
    FUZZ_CHECK(a.shape.type == GPHYS_SHAPE_FRUSTUM ||
                   (between(low.x, at.x, high.x) && between(low.y, at.y, high.y) && between(low.z, at.z, high.z)),
               "the closest point lies in the bounds");
}

void transformation(Program& p) {
    const Asked a(p, true);
    gphys_transform transform = p.transform();
    p.spoil(transform, 24);
    Output<AnyShape> moved;
    const gphys_status status = call(gphys_shape_transform, a.shape.type, a.shape.bytes, &transform, moved.value.bytes);
    if (status < 0) {
        FUZZ_CHECK(moved.untouched(), "an error leaves outputs untouched");
        return;
    }
    FUZZ_CHECK(a.valid && is_valid(transform), "only valid shapes are moved");
    moved.value.type = a.shape.type == GPHYS_SHAPE_AABB ? GPHYS_SHAPE_OBB : a.shape.type;
    moved.value.size = moved.value.type == GPHYS_SHAPE_OBB ? sizeof(gphys_obb) : a.shape.size;
    note_bytes(moved.value.bytes, moved.value.size);
    FUZZ_CHECK(is_valid(moved.value), "a moved shape is valid");
    if (a.shape.type == GPHYS_SHAPE_AABB) return;
    AnyShape in_place = a.shape;
    const gphys_status again = call(gphys_shape_transform, a.shape.type, in_place.bytes, &transform, in_place.bytes);
    FUZZ_CHECK(again == status && std::memcmp(in_place.bytes, moved.value.bytes, a.shape.size) == 0,
               "a shape may be moved in place");
}

void containment(Program& p) {
    const Asked a(p, true);
    gphys_vec3 point = p.point();
    p.spoil(point, 40);
    float tolerance = p.one_in(2) ? 0.0f : p.size();
    if (p.one_in(40)) tolerance = p.hostile();
    Output<int32_t> contains;
    const gphys_status status =
        call(gphys_shape_contains, a.shape.type, a.shape.bytes, &point, tolerance, &contains.value);
    contains.after(status);
    const bool valid = a.valid && is_valid(point) && tolerance >= 0 && tolerance <= GPHYS_MAX_COORDINATE;
    FUZZ_CHECK((status == GPHYS_OK) == valid, "contains takes valid input only");
    if (!valid) return;
    FUZZ_CHECK(contains.value == 0 || contains.value == 1, "contains is 0 or 1");
    Output<gphys_nearest> near;
    const gphys_status found = call(gphys_shape_closest_point, a.shape.type, a.shape.bytes, &point, &near.value);
    near.after(found);
    FUZZ_CHECK(found == GPHYS_OK || (found == GPHYS_NO_HIT && a.shape.type == GPHYS_SHAPE_FRUSTUM),
               "only an empty frustum has no closest point");
    if (found == GPHYS_NO_HIT) {
        FUZZ_CHECK(!contains.value, "what is empty contains nothing");
        return;
    }
    const double band = 0x1p-38 * extent(a.shape, point) + 0x1p-140;
    const double above = static_cast<double>(near.value.distance) - tolerance;
    const double ulp = 0x1p-23 * static_cast<double>(near.value.distance);
    FUZZ_CHECK(!contains.value || above <= band + ulp, "what is contained is as near as the tolerance");
    FUZZ_CHECK(contains.value || above >= -band - ulp, "what is nearer than the tolerance is contained");
    if (tolerance != 0 || !is_exact(a.shape.type)) return;
    const AnyShape as_box = AnyShape::of(GPHYS_SHAPE_AABB, gphys_aabb{point, point});
    const AnyShape as_triangle = AnyShape::of(GPHYS_SHAPE_TRIANGLE, gphys_triangle{point, point, point});
    FUZZ_CHECK(overlap(a.shape, as_box) == (contains.value != 0), "contains agrees with a box that is a point");
    FUZZ_CHECK(overlap(a.shape, as_triangle) == (contains.value != 0),
               "contains agrees with a triangle that is a point");
}

void overlapping(Program& p) {
    const Asked a(p), b(p);
    Output<int32_t> found;
    const gphys_status status =
        call(gphys_shape_overlaps, a.shape.type, a.shape.bytes, b.shape.type, b.shape.bytes, &found.value);
    found.after(status);
    FUZZ_CHECK((status == GPHYS_OK) == (a.valid && b.valid), "overlaps takes valid input only");
    if (status != GPHYS_OK) return;
    FUZZ_CHECK(found.value == 0 || found.value == 1, "overlaps is 0 or 1");
    FUZZ_CHECK(overlap(b.shape, a.shape) == (found.value != 0) || !is_clear(a.shape, b.shape),
               "overlaps is the same in either order");
    check_moved_overlap(p, a.shape, b.shape, found.value != 0);
    Output<gphys_aabb> box_a, box_b;
    if (is_exact(a.shape.type) && is_exact(b.shape.type) && found.value &&
        call(gphys_shape_bounds, a.shape.type, a.shape.bytes, &box_a.value) == GPHYS_OK &&
        call(gphys_shape_bounds, b.shape.type, b.shape.bytes, &box_b.value) == GPHYS_OK) {
        const AnyShape as_a = AnyShape::of(GPHYS_SHAPE_AABB, box_a.value);
        const AnyShape as_b = AnyShape::of(GPHYS_SHAPE_AABB, box_b.value);
        if (!is_valid(as_a) || !is_valid(as_b)) return;  // those of frusta may be out of range
        FUZZ_CHECK(overlap(as_a, as_b), "what overlaps has bounds that overlap");
    }
}

void classification(Program& p) {
    const Asked a(p);
    AnyShape plane = p.shape(GPHYS_SHAPE_PLANE), frustum = p.shape(GPHYS_SHAPE_FRUSTUM);
    p.spoil(plane, 40);
    p.spoil(frustum, 40);
    const bool supported = a.shape.type != GPHYS_SHAPE_PLANE && a.shape.type != GPHYS_SHAPE_FRUSTUM;
    const gphys_plane as_plane = plane.as<gphys_plane>();
    const gphys_frustum as_frustum = frustum.as<gphys_frustum>();
    Output<gphys_side> side, beside;
    Output<float> distance;
    gphys_status status =
        call(gphys_shape_classify_plane, a.shape.type, a.shape.bytes, &as_plane, &side.value, &distance.value);
    side.after(status);
    distance.after(status);
    FUZZ_CHECK((status == GPHYS_OK) == (supported && a.valid && is_valid(plane)), "classify takes valid input only");
    if (status == GPHYS_OK) {
        const bool exact = is_exact(a.shape.type);
        FUZZ_CHECK(!exact || overlap(a.shape, plane) == (side.value == GPHYS_SIDE_CROSSING),
                   "what crosses a plane overlaps it");
        FUZZ_CHECK(side.value == GPHYS_SIDE_CROSSING ? distance.value == 0
                                                     : distance.value * static_cast<float>(side.value) >= 0,
                   "a signed distance is of the side");
        const gphys_plane turned{{-as_plane.normal.x, -as_plane.normal.y, -as_plane.normal.z}, -as_plane.distance};
        call(gphys_shape_classify_plane, a.shape.type, a.shape.bytes, &turned, &beside.value, nullptr);
        FUZZ_CHECK(beside.value == -side.value, "a plane that is turned has the sides exchanged");
    }
    Output<gphys_side> in;
    status = call(gphys_shape_classify_frustum, a.shape.type, a.shape.bytes, &as_frustum, &in.value);
    in.after(status);
    FUZZ_CHECK((status == GPHYS_OK) == (supported && a.valid && is_valid(frustum)), "classify takes valid input only");
    if (status != GPHYS_OK) return;
    if (is_exact(a.shape.type)) {
        FUZZ_CHECK(overlap(a.shape, frustum) == (in.value != GPHYS_SIDE_OUTSIDE), "what is outside does not overlap");
    }
    if (a.shape.type == GPHYS_SHAPE_TRIANGLE) {
        const auto t = a.shape.as<gphys_triangle>();
        bool contains_all = true;
        for (const gphys_vec3& corner : {t.a, t.b, t.c}) {
            int32_t contains = 0;
            call(gphys_shape_contains, frustum.type, frustum.bytes, &corner, 0.0f, &contains);
            contains_all = contains_all && contains;
        }
        FUZZ_CHECK((in.value == GPHYS_SIDE_INSIDE) == contains_all,
                   "a triangle is inside a frustum that contains its corners");
    }
}

void rays(Program& p) {
    const Asked a(p);
    gphys_ray ray = p.ray();
    p.spoil(ray, 40);
    Output<gphys_hit> hit;
    const gphys_status status = call(gphys_shape_raycast, a.shape.type, a.shape.bytes, &ray, &hit.value);
    hit.after(status);
    FUZZ_CHECK((status >= 0) == (a.valid && is_valid(ray)), "raycast takes valid input only");
    if (status < 0) return;
    FUZZ_CHECK(status == GPHYS_OK || hit.untouched(), "a miss leaves the output untouched");
    if (status == GPHYS_OK) {
        check_hit(hit.value, ray.t_max, ray.direction);
        FUZZ_CHECK(hit.value.model == 0 && hit.value.tag == 0, "a hit without a scene has no model");
    }
    check_moved_ray(p, a.shape, ray, status == GPHYS_OK ? &hit.value : nullptr);
    const bool exact_start = a.shape.type == GPHYS_SHAPE_SPHERE || a.shape.type == GPHYS_SHAPE_AABB;
    if (!exact_start) return;
    int32_t starts_inside = 0;
    call(gphys_shape_contains, a.shape.type, a.shape.bytes, &ray.origin, 0.0f, &starts_inside);
    const bool says_inside = status == GPHYS_OK && (hit.value.flags & GPHYS_HIT_INSIDE);
    FUZZ_CHECK(says_inside == (starts_inside != 0), "a ray that starts inside a solid says so");
}

void segments(Program& p) {
    const Asked a(p);
    gphys_segment segment = p.segment();
    p.spoil(segment, 40);
    Output<gphys_hit> hit, back;
    const gphys_status status = call(gphys_shape_segment_test, a.shape.type, a.shape.bytes, &segment, &hit.value);
    hit.after(status);
    FUZZ_CHECK((status >= 0) == (a.valid && is_valid(segment)), "segment_test takes valid input only");
    if (status < 0) return;
    const gphys_vec3 along{segment.b.x - segment.a.x, segment.b.y - segment.a.y, segment.b.z - segment.a.z};
    if (status == GPHYS_OK) check_hit(hit.value, 1, is_finite(along) ? along : gphys_vec3{0, 0, 0});
    const gphys_segment reversed{segment.b, segment.a};
    const gphys_status status_back =
        call(gphys_shape_segment_test, a.shape.type, a.shape.bytes, &reversed, &back.value);
    back.after(status_back);
    if (has_exact_rays(a.shape.type)) {
        FUZZ_CHECK(status == status_back, "a segment and its reverse agree");
        for (const gphys_vec3& end : {segment.a, segment.b}) {
            int32_t contains = 0;
            call(gphys_shape_contains, a.shape.type, a.shape.bytes, &end, 0.0f, &contains);
            FUZZ_CHECK(!contains || status == GPHYS_OK, "a segment contains both of its ends");
        }
    }
    // Where b - a is a float, the segment is a ray.
    if (adds_exactly(segment.b.x, -segment.a.x) && adds_exactly(segment.b.y, -segment.a.y) &&
        adds_exactly(segment.b.z, -segment.a.z) && (along.x != 0 || along.y != 0 || along.z != 0)) {
        const gphys_ray ray{segment.a, along, 1};
        Output<gphys_hit> by_ray;
        if (!is_valid(ray)) return;
        const gphys_status ray_status = call(gphys_shape_raycast, a.shape.type, a.shape.bytes, &ray, &by_ray.value);
        FUZZ_CHECK(ray_status == status, "a segment is the ray along it");
        FUZZ_CHECK(status != GPHYS_OK || same_bits(by_ray.value, hit.value), "a segment is the ray along it");
    }
}

void sweeps(Program& p) {
    const Asked a(p);
    gphys_sphere sphere{p.point(), p.size()};
    gphys_vec3 displacement = p.one_in(8) ? gphys_vec3{0, 0, 0} : p.direction();
    p.spoil(sphere, 40);
    p.spoil(displacement, 40);
    Output<gphys_hit> hit;
    const gphys_status status =
        call(gphys_shape_sweep_sphere, a.shape.type, a.shape.bytes, &sphere, &displacement, &hit.value);
    hit.after(status);
    const AnyShape ball = AnyShape::of(GPHYS_SHAPE_SPHERE, sphere);
    FUZZ_CHECK((status >= 0) == (a.valid && is_valid(ball) && is_valid(displacement)), "sweep takes valid input only");
    if (status < 0) return;
    if (status == GPHYS_OK) check_hit(hit.value, 1, displacement, true);
    const bool says_touching = status == GPHYS_OK && (hit.value.flags & GPHYS_HIT_INSIDE);
    FUZZ_CHECK(says_touching == overlap(ball, a.shape) || !is_clear(ball, a.shape),
               "a sweep starts inside where the sphere overlaps");
}

constexpr gphys_shape_type solids[] = {GPHYS_SHAPE_SPHERE, GPHYS_SHAPE_CAPSULE, GPHYS_SHAPE_AABB, GPHYS_SHAPE_OBB};

/// Whether solids meet the shape. A frustum that is no hull of eight corners, and so surely one that is empty or
/// unbounded, is refused; `status` is that of the call.
bool is_met(const AnyShape& shape, gphys_status status) {
    if (shape.type != GPHYS_SHAPE_FRUSTUM) return true;
    if (status == GPHYS_ERROR_UNSUPPORTED) return false;
    const auto frustum = shape.as<gphys_frustum>();
    gphys_vec3 corners[8];
    gphys_aabb box;
    FUZZ_CHECK(call(gphys_frustum_corners, &frustum, corners) == GPHYS_OK &&
                   call(gphys_shape_bounds, shape.type, shape.bytes, &box) == GPHYS_OK,
               "a frustum that solids meet has corners and bounds");
    return true;
}

void solid_sweeps(Program& p) {
    const Asked a(p);
    AnyShape moving = p.shape(solids[p.below(4)]);
    gphys_vec3 displacement = p.one_in(8) ? gphys_vec3{0, 0, 0} : p.direction();
    p.spoil(moving, 40);
    p.spoil(displacement, 40);
    Output<gphys_hit> hit;
    const gphys_status status =
        call(gphys_shape_sweep, a.shape.type, a.shape.bytes, moving.type, moving.bytes, &displacement, &hit.value);
    hit.after(status);
    const bool valid = a.valid && is_valid(moving) && is_valid(displacement);
    const bool supported = !valid || moving.type == GPHYS_SHAPE_SPHERE || is_met(a.shape, status);
    FUZZ_CHECK((status >= 0) == (valid && supported), "sweep takes valid input only");
    gphys_hit batch[2];
    const gphys_status all = call(gphys_shape_sweep_batch, a.shape.type, a.shape.bytes, 0u, moving.type, moving.bytes,
                                  0u, &displacement, 0u, 2u, batch, uint32_t{sizeof(gphys_hit)});
    FUZZ_CHECK(all == std::min(status, GPHYS_OK + 0), "a batch takes what a single call takes");
    if (status < 0) return;
    FUZZ_CHECK(same_bits(batch[0], batch[1]) && (status == GPHYS_OK ? same_bits(batch[0], hit.value)
                                                                    : batch[0].t > std::numeric_limits<float>::max()),
               "sweep_batch gives the bits of sweep");
    if (status == GPHYS_OK) check_hit(hit.value, 1, displacement, true);
    const bool says_touching = status == GPHYS_OK && (hit.value.flags & GPHYS_HIT_INSIDE);
    // The corners of a frustum are rounded, and an AABB says nothing of how clear the answer is.
    const bool is_open = a.shape.type == GPHYS_SHAPE_FRUSTUM && moving.type == GPHYS_SHAPE_AABB;
    FUZZ_CHECK(says_touching == overlap(moving, a.shape) || is_open || !is_clear(moving, a.shape),
               "a sweep starts inside where the solid overlaps");
}

void ways_out(Program& p) {
    const Asked a(p);
    AnyShape moving = p.shape(solids[p.below(4)]);
    p.spoil(moving, 40);
    Output<gphys_penetration> out;
    const gphys_status status =
        call(gphys_shape_penetration, a.shape.type, a.shape.bytes, moving.type, moving.bytes, &out.value);
    out.after(status);
    const bool valid = a.valid && is_valid(moving);
    const bool supported = !valid || is_met(a.shape, status);
    FUZZ_CHECK((status >= 0) == (valid && supported), "penetration takes valid input only");
    gphys_penetration batch[2];
    const gphys_status all = call(gphys_shape_penetration_batch, a.shape.type, a.shape.bytes, 0u, moving.type,
                                  moving.bytes, 0u, 2u, batch, uint32_t{sizeof(gphys_penetration)});
    FUZZ_CHECK(all == std::min(status, GPHYS_OK + 0), "a batch takes what a single call takes");
    if (status < 0) return;
    FUZZ_CHECK(status != GPHYS_OK ? batch[0].depth < 0 && same_bits(batch[0], batch[1])
                                  : same_bits(batch[0], out.value) && same_bits(batch[1], out.value),
               "penetration_batch gives the bits of penetration");
    FUZZ_CHECK((status == GPHYS_OK) == overlap(a.shape, moving), "there is a way out of what is overlapped");
    if (status != GPHYS_OK) return;
    const gphys_vec3& n = out.value.normal;
    const double square = double{n.x} * n.x + double{n.y} * n.y + double{n.z} * n.z;
    FUZZ_CHECK(is_finite(out.value.point) && std::fabs(square - 1) < 1e-5 && out.value.depth >= 0,
               "a way out has a point, a direction and a length");
}

void closest_of_segments(Program& p) {
    gphys_segment a = p.segment(), b = p.segment();
    p.spoil(a, 40);
    p.spoil(b, 40);
    Output<gphys_vec3> on_a, on_b;
    Output<float> distance, back;
    const gphys_status status = call(gphys_segment_closest_points, &a, &b, &on_a.value, &on_b.value, &distance.value);
    on_a.after(status);
    on_b.after(status);
    distance.after(status);
    FUZZ_CHECK((status == GPHYS_OK) == (is_valid(a) && is_valid(b)), "segments must be valid");
    if (status != GPHYS_OK) return;
    call(gphys_segment_closest_points, &b, &a, nullptr, nullptr, &back.value);
    const double band = 0x1p-22 * (static_cast<double>(distance.value)) +
                        0x1p-30 * extent(AnyShape::of(GPHYS_SHAPE_SEGMENT, a), b.a) +
                        0x1p-30 * extent(AnyShape::of(GPHYS_SHAPE_SEGMENT, b), a.a) + 0x1p-140;
    FUZZ_CHECK(std::fabs(static_cast<double>(distance.value) - back.value) <= band,
               "two segments are as far apart in either order");
    for (const gphys_vec3& end : {b.a, b.b}) {
        Output<gphys_nearest> near;
        call(gphys_shape_closest_point, gphys_shape_type{GPHYS_SHAPE_SEGMENT}, &a, &end, &near.value);
        FUZZ_CHECK(near.value.distance >= distance.value - band, "no end is nearer than the closest points");
    }
}

void frusta(Program& p) {
    AnyShape any = p.shape(GPHYS_SHAPE_FRUSTUM);
    p.spoil(any, 20);
    const gphys_frustum frustum = any.as<gphys_frustum>();
    struct Corners {
        gphys_vec3 corner[8];
    };
    Output<Corners> corners;
    const gphys_status status = call(gphys_frustum_corners, &frustum, corners.value.corner);
    corners.after(status);
    FUZZ_CHECK((status >= 0) == is_valid(any), "corners of valid frusta only");
    if (status == GPHYS_OK) {
        for (const gphys_vec3& corner : corners.value.corner) FUZZ_CHECK(is_finite(corner), "corners are finite");
    }
    gphys_plane planes[3] = {frustum.planes[0], frustum.planes[2], frustum.planes[4]};
    Output<gphys_vec3> point;
    const gphys_status met = call(gphys_planes_intersection, &planes[0], &planes[1], &planes[2], &point.value);
    point.after(met);
    FUZZ_CHECK(met != GPHYS_OK || is_valid(point.value), "planes meet in range");
    gphys_vec3 swapped{INFINITY, INFINITY, INFINITY};
    const gphys_status again =
        call(gphys_planes_intersection_batch, &planes[2], 0u, &planes[0], 0u, &planes[1], 0u, 1u, &swapped, 12u);
    FUZZ_CHECK((met < 0) == (again < 0) && (met == GPHYS_OK) == is_finite(swapped), "planes meet whatever their order");
    gphys_mat4 matrix{};
    for (float& element : matrix.m) element = p.one_in(3) ? p.number() : 0;
    if (p.one_in(3)) matrix.m[0] = matrix.m[5] = 1, matrix.m[10] = 1.5f, matrix.m[11] = 1, matrix.m[14] = -1;
    p.spoil(matrix, 30);
    Output<float> deviation;
    const gphys_status told = call(gphys_mat4_orthonormality, &matrix, &deviation.value);
    deviation.after(told);
    FUZZ_CHECK(told != GPHYS_OK || (deviation.value >= 0 && std::isfinite(deviation.value)),
               "a matrix is some way from orthonormal");
    Output<gphys_frustum> from_matrix;
    const int32_t range = static_cast<int32_t>(p.below(3)), reverse = static_cast<int32_t>(p.below(2));
    const gphys_status made = call(gphys_frustum_from_matrix, &matrix, range, reverse, &from_matrix.value);
    from_matrix.after(made);
    if (made == GPHYS_OK) {
        FUZZ_CHECK(is_valid(AnyShape::of(GPHYS_SHAPE_FRUSTUM, from_matrix.value)), "a matrix gives a valid frustum");
    }
}

/// Batches, with strides, against single calls.
void batches(Program& p) {
    constexpr uint32_t most = 24;
    const uint32_t count = p.below(most + 1), gap = p.below(3);
    const AnyShape shape = p.shape(p.shape_type(true));
    struct Spaced {
        gphys_ray ray;
        uint32_t gap[2];
    };
    std::vector<Spaced> rays(count + 1);
    for (Spaced& each : rays) each.ray = p.ray();
    const uint32_t ray_stride = p.one_in(6) ? 0 : static_cast<uint32_t>(sizeof(Spaced));
    std::vector<unsigned char> out((sizeof(gphys_hit) + 8) * (count + 1), 0xa5);
    const uint32_t hit_stride = static_cast<uint32_t>(sizeof(gphys_hit)) + 4 * gap;
    gphys_status status = call(gphys_shape_raycast_batch, shape.type, shape.bytes, &rays[0].ray, ray_stride, count,
                               reinterpret_cast<gphys_hit*>(out.data()), hit_stride);
    bool all_valid = is_valid(shape);
    for (uint32_t i = 0; i < (ray_stride ? count : count ? 1 : 0); ++i) all_valid = all_valid && is_valid(rays[i].ray);
    FUZZ_CHECK((status == GPHYS_OK) == all_valid, "a batch takes valid input only");
    for (uint32_t i = 0; status == GPHYS_OK && i < count; ++i) {
        gphys_hit single{0, 0, infinity, {}, {}, GPHYS_NO_TRIANGLE, 0, 0, 0}, hit;
        std::memcpy(&hit, &out[i * hit_stride], sizeof hit);
        note(hit);
        call(gphys_shape_raycast, shape.type, shape.bytes, &rays[ray_stride ? i : 0].ray, &single);
        FUZZ_CHECK(same_bits(hit, single), "raycast_batch gives the bits of raycast");
    }
    std::vector<gphys_vec3> points(count + 1);
    for (gphys_vec3& point : points) point = p.point();
    std::vector<gphys_nearest> near(count + 1);
    std::vector<int32_t> flags(count + 1);
    status = call(gphys_shape_closest_point_batch, shape.type, shape.bytes, points.data(), 12u, count, near.data(),
                  static_cast<uint32_t>(sizeof(gphys_nearest)));
    for (uint32_t i = 0; status == GPHYS_OK && i < count; ++i) {
        gphys_nearest single{0, 0, {}, infinity, GPHYS_NO_TRIANGLE};
        call(gphys_shape_closest_point, shape.type, shape.bytes, &points[i], &single);
        FUZZ_CHECK(same_bits(near[i], single), "closest_point_batch gives the bits of closest_point");
    }
    const float tolerance = p.one_in(2) ? 0.0f : p.size();
    status = call(gphys_shape_contains_batch, shape.type, shape.bytes, points.data(), 12u, count, tolerance,
                  flags.data(), 4u);
    for (uint32_t i = 0; status == GPHYS_OK && i < count; ++i) {
        int32_t single = -1;
        call(gphys_shape_contains, shape.type, shape.bytes, &points[i], tolerance, &single);
        FUZZ_CHECK(flags[i] == single, "contains_batch gives the answers of contains");
    }
    const gphys_shape_type type = p.shape_type(true);
    std::vector<AnyShape> others(count + 1);
    for (AnyShape& other : others) other = p.shape(type);
    status = call(gphys_shape_overlaps_batch, shape.type, shape.bytes, 0u, type, others[0].bytes,
                  static_cast<uint32_t>(sizeof(AnyShape)), count, flags.data(), 4u);
    for (uint32_t i = 0; status == GPHYS_OK && i < count; ++i) {
        FUZZ_CHECK(overlap(shape, others[i]) == (flags[i] != 0), "overlaps_batch gives the answers of overlaps");
    }
}

/// Null pointers, strides that are none, types that are none: refused, each time, by a status.
void misuse(Program& p) {
    const AnyShape shape = p.shape(p.shape_type(true));
    const gphys_vec3 point = p.point();
    const gphys_ray ray = p.ray();
    const gphys_segment segment = p.segment();
    const gphys_sphere sphere{point, 1};
    const uint32_t bad_stride = 1 + p.below(3);
    gphys_hit hit;
    gphys_nearest near;
    gphys_penetration way;
    int32_t flag = 0;
    const int32_t bad_type = p.one_in(2) ? static_cast<int32_t>(p.word()) | 64 : 9;
    const gphys_status refused[] = {
        call(gphys_shape_bounds, shape.type, shape.bytes, nullptr),
        call(gphys_shape_bounds, bad_type, shape.bytes, nullptr),
        call(gphys_shape_transform, shape.type, shape.bytes, nullptr, &hit),
        call(gphys_shape_contains, shape.type, shape.bytes, nullptr, 0.0f, &flag),
        call(gphys_shape_contains, shape.type, nullptr, &point, 0.0f, &flag),
        call(gphys_shape_contains_batch, shape.type, shape.bytes, &point, bad_stride, 1u, 0.0f, &flag, 4u),
        call(gphys_shape_contains_batch, shape.type, shape.bytes, &point, 12u, 1u, 0.0f, &flag, bad_stride),
        call(gphys_shape_closest_point, bad_type, shape.bytes, &point, &near),
        call(gphys_shape_closest_point_batch, shape.type, shape.bytes, &point, 8u, 1u, &near, 28u),
        call(gphys_segment_closest_points, nullptr, &segment, nullptr, nullptr, nullptr),
        call(gphys_shape_overlaps, shape.type, shape.bytes, bad_type, shape.bytes, &flag),
        call(gphys_shape_overlaps, shape.type, shape.bytes, shape.type, nullptr, &flag),
        call(gphys_shape_overlaps, shape.type, shape.bytes, gphys_shape_type{GPHYS_SHAPE_RAY}, &ray, &flag),
        call(gphys_shape_overlaps_batch, shape.type, shape.bytes, 4u, shape.type, shape.bytes, 0u, 1u, &flag, 4u),
        call(gphys_shape_raycast, shape.type, shape.bytes, nullptr, &hit),
        call(gphys_shape_raycast, bad_type, shape.bytes, &ray, &hit),
        call(gphys_shape_raycast_batch, shape.type, shape.bytes, &ray, bad_stride, 1u, &hit, 56u),
        call(gphys_shape_segment_test, shape.type, shape.bytes, &segment, nullptr),
        call(gphys_shape_sweep_sphere, shape.type, shape.bytes, &sphere, nullptr, &hit),
        call(gphys_shape_sweep, shape.type, shape.bytes, gphys_shape_type{GPHYS_SHAPE_SPHERE}, &sphere, nullptr, &hit),
        call(gphys_shape_sweep, shape.type, shape.bytes, bad_type, &sphere, &point, &hit),
        call(gphys_shape_penetration, shape.type, shape.bytes, gphys_shape_type{GPHYS_SHAPE_SPHERE}, &sphere, nullptr),
        call(gphys_shape_penetration, shape.type, nullptr, gphys_shape_type{GPHYS_SHAPE_SPHERE}, &sphere, &way),
        call(gphys_shape_sweep_batch, shape.type, shape.bytes, 0u, gphys_shape_type{GPHYS_SHAPE_SPHERE}, &sphere, 0u,
             &point, bad_stride, 1u, &hit, 56u),
        call(gphys_shape_penetration_batch, shape.type, shape.bytes, 0u, gphys_shape_type{GPHYS_SHAPE_SPHERE}, nullptr,
             0u, 1u, &way, 40u),
        call(gphys_frustum_corners, nullptr, nullptr),
        call(gphys_frustum_from_matrix, nullptr, 0, 0, nullptr),
        call(gphys_shape_classify_plane, shape.type, shape.bytes, nullptr, &flag, nullptr),
        call(gphys_shape_classify_frustum, shape.type, shape.bytes, nullptr, &flag)};
    for (const gphys_status status : refused) FUZZ_CHECK(status < 0, "a call that makes no sense is refused");
    ++session().operations;
    FUZZ_CHECK(gphys_status_name(static_cast<gphys_status>(p.word()))[0] != '\0', "every status has a name");
    FUZZ_CHECK(gphys_version() != 0, "there is a version");
}

}  // namespace

void run(Program& p) {
    constexpr void (*questions[])(Program&) = {
        validation,  bounds,  transformation, containment,  containment,    overlapping, overlapping,
        overlapping, rays,    rays,           rays,         segments,       segments,    sweeps,
        frusta,      batches, misuse,         rays,         classification, overlapping, closest_of_segments,
        segments,    sweeps,  containment,    solid_sweeps, solid_sweeps,   ways_out,    ways_out};
    for (int i = 0; i < 64 && !p.done(); ++i) questions[p.below(std::size(questions))](p);
}

}  // namespace fuzz
