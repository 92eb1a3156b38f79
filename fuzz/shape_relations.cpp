#include "shape_relations.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "check.h"

namespace fuzz {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// x -> cycle of the axes (scale * x) + offset.
struct Motion {
    int cycle;
    float scale;
    gphys_vec3 offset;
    bool exact = true;  // so far

    float scaled(float value) {
        const float result = value * scale;
        exact = exact && result / scale == value && std::fabs(result) <= GPHYS_MAX_COORDINATE;
        return result;
    }
    gphys_vec3 vector(const gphys_vec3& v) {
        const float* from = &v.x;
        return {scaled(from[(3 - cycle) % 3]), scaled(from[(4 - cycle) % 3]), scaled(from[(5 - cycle) % 3])};
    }
    float moved(float value, float by) {
        const float result = value + by;
        exact = exact && adds_exactly(value, by) && std::fabs(result) <= GPHYS_MAX_COORDINATE;
        return result;
    }
    gphys_vec3 point(const gphys_vec3& v) {
        const gphys_vec3 turned = vector(v);
        return {moved(turned.x, offset.x), moved(turned.y, offset.y), moved(turned.z, offset.z)};
    }
    /// A direction: turned, not scaled.
    gphys_vec3 direction(const gphys_vec3& v) {
        const float* from = &v.x;
        return {from[(3 - cycle) % 3], from[(4 - cycle) % 3], from[(5 - cycle) % 3]};
    }
    gphys_quat rotation(const gphys_quat& q) {
        const gphys_vec3 axis = direction({q.x, q.y, q.z});
        return {axis.x, axis.y, axis.z, q.w};
    }
    /// Distances of a frustum's planes count from its origin.
    gphys_plane plane_from_origin(const gphys_plane& plane) {
        const bool none = plane.normal.x == 0 && plane.normal.y == 0 && plane.normal.z == 0;
        return {direction(plane.normal), none ? plane.distance : scaled(plane.distance)};
    }

    AnyShape shape(const AnyShape& any) {
        switch (any.type) {
            case GPHYS_SHAPE_SPHERE: {
                const auto s = any.as<gphys_sphere>();
                return AnyShape::of(any.type, gphys_sphere{point(s.center), scaled(s.radius)});
            }
            case GPHYS_SHAPE_CAPSULE: {
                const auto c = any.as<gphys_capsule>();
                return AnyShape::of(any.type, gphys_capsule{point(c.a), point(c.b), scaled(c.radius)});
            }
            case GPHYS_SHAPE_AABB: {
                const auto b = any.as<gphys_aabb>();
                return AnyShape::of(any.type, gphys_aabb{point(b.min), point(b.max)});
            }
            case GPHYS_SHAPE_OBB: {
                const auto b = any.as<gphys_obb>();
                return AnyShape::of(any.type, gphys_obb{point(b.center), vector(b.half_extents), rotation(b.rotation)});
            }
            case GPHYS_SHAPE_PLANE: {
                const auto plane = any.as<gphys_plane>();
                exact = exact && offset.x == 0 && offset.y == 0 && offset.z == 0;
                return AnyShape::of(any.type, plane_from_origin(plane));
            }
            case GPHYS_SHAPE_TRIANGLE: {
                const auto t = any.as<gphys_triangle>();
                return AnyShape::of(any.type, gphys_triangle{point(t.a), point(t.b), point(t.c)});
            }
            default: {
                auto f = any.as<gphys_frustum>();
                f.origin = point(f.origin);
                for (gphys_plane& plane : f.planes) plane = plane_from_origin(plane);
                return AnyShape::of(any.type, f);
            }
        }
    }
};

Motion motion(Program& p) {
    constexpr float scales[] = {1, 1, 1, 2, 0.5f, 1024, 0x1p-20f, 0x1p60f};
    Motion m{static_cast<int>(p.below(3)), scales[p.below(8)], {0, 0, 0}};
    if (p.one_in(2)) m.offset = {p.number(), p.number(), p.number()};
    return m;
}

void include(double& low, double& high, float value, double size) {
    low = std::min(low, value - size);
    high = std::max(high, value + size);
}

/// The largest extent along an axis of points, each with a size around it.
class Extent {
public:
    void add(const gphys_vec3& at, double size = 0) {
        for (int k = 0; k < 3; ++k) include(low_[k], high_[k], (&at.x)[k], size);
    }
    void add(const AnyShape& any);
    double value() const {
        double most = 0;
        for (int k = 0; k < 3; ++k) most = std::max(most, high_[k] - low_[k]);
        return most + 2 * beyond_;
    }

private:
    double low_[3] = {1e300, 1e300, 1e300}, high_[3] = {-1e300, -1e300, -1e300};
    double beyond_ = 0;  // distances of planes
};

void Extent::add(const AnyShape& any) {
    const auto distance = [](const gphys_plane& plane) {
        const double x = plane.normal.x, y = plane.normal.y, z = plane.normal.z, l = std::sqrt(x * x + y * y + z * z);
        return l > 0 ? std::fabs(plane.distance) / l : 0.0;
    };
    switch (any.type) {
        case GPHYS_SHAPE_SPHERE: {
            const auto s = any.as<gphys_sphere>();
            return add(s.center, s.radius);
        }
        case GPHYS_SHAPE_CAPSULE: {
            const auto c = any.as<gphys_capsule>();
            add(c.a, c.radius);
            return add(c.b, c.radius);
        }
        case GPHYS_SHAPE_AABB: {
            const auto b = any.as<gphys_aabb>();
            add(b.min);
            return add(b.max);
        }
        case GPHYS_SHAPE_OBB: {
            const auto b = any.as<gphys_obb>();
            return add(b.center, double{b.half_extents.x} + b.half_extents.y + b.half_extents.z);
        }
        case GPHYS_SHAPE_PLANE: {
            const auto plane = any.as<gphys_plane>();
            add(gphys_vec3{0, 0, 0});
            beyond_ += distance(plane);
            return;
        }
        case GPHYS_SHAPE_TRIANGLE: {
            const auto t = any.as<gphys_triangle>();
            add(t.a);
            add(t.b);
            return add(t.c);
        }
        case GPHYS_SHAPE_FRUSTUM: {
            const auto f = any.as<gphys_frustum>();
            add(f.origin);
            for (const gphys_plane& plane : f.planes) beyond_ += distance(plane);
            return;
        }
        case GPHYS_SHAPE_RAY: {
            const auto r = any.as<gphys_ray>();
            return add(r.origin);
        }
        default: {
            const auto s = any.as<gphys_segment>();
            add(s.a);
            return add(s.b);
        }
    }
}

/// A round shape or a turned box, larger (sign 1) or smaller (-1) by at least so much; others as they are.
AnyShape grown(const AnyShape& any, int sign, double by) {
    const auto other = [&](float size) {
        const float next = std::nextafter(size, sign > 0 ? infinity : -infinity);
        const float moved = static_cast<float>(size + sign * by);
        return std::max(0.0f, sign > 0 ? std::max(next, moved) : std::min(next, moved));
    };
    switch (any.type) {
        case GPHYS_SHAPE_SPHERE: {
            auto s = any.as<gphys_sphere>();
            s.radius = other(s.radius);
            return AnyShape::of(any.type, s);
        }
        case GPHYS_SHAPE_CAPSULE: {
            auto c = any.as<gphys_capsule>();
            c.radius = other(c.radius);
            return AnyShape::of(any.type, c);
        }
        case GPHYS_SHAPE_OBB: {
            auto b = any.as<gphys_obb>();
            for (int k = 0; k < 3; ++k) (&b.half_extents.x)[k] = other((&b.half_extents.x)[k]);
            return AnyShape::of(any.type, b);
        }
        default:
            return any;
    }
}

/// Whether `grown` can make a shape smaller by so much.
bool can_shrink(const AnyShape& any, double by) {
    switch (any.type) {
        case GPHYS_SHAPE_SPHERE:
            return any.as<gphys_sphere>().radius > by;
        case GPHYS_SHAPE_CAPSULE:
            return any.as<gphys_capsule>().radius > by;
        case GPHYS_SHAPE_OBB: {
            const auto half = any.as<gphys_obb>().half_extents;
            return half.x > by && half.y > by && half.z > by;
        }
        default:
            return false;
    }
}

/// How many floats lie between two.
uint64_t ulps(float a, float b) {
    if (a == b) return 0;  // both zeros
    int32_t x, y;
    std::memcpy(&x, &a, 4);
    std::memcpy(&y, &b, 4);
    return static_cast<uint64_t>(std::abs(int64_t{x} - y));
}

}  // namespace

bool is_exact(gphys_shape_type type) {
    return type == GPHYS_SHAPE_AABB || type == GPHYS_SHAPE_PLANE || type == GPHYS_SHAPE_TRIANGLE ||
           type == GPHYS_SHAPE_FRUSTUM;
}

bool has_exact_rays(gphys_shape_type type) {
    return type == GPHYS_SHAPE_SPHERE || type == GPHYS_SHAPE_AABB || type == GPHYS_SHAPE_PLANE ||
           type == GPHYS_SHAPE_TRIANGLE;
}

bool overlap(const AnyShape& a, const AnyShape& b) {
    int32_t overlaps = -1;
    FUZZ_CHECK(call(gphys_shape_overlaps, a.type, a.bytes, b.type, b.bytes, &overlaps) == GPHYS_OK,
               "overlaps takes all valid shapes");
    note(overlaps);
    return overlaps != 0;
}

bool adds_exactly(float a, float b) {
    const float sum = a + b, of_b = sum - a;
    return (a - (sum - of_b)) + (b - of_b) == 0;
}

double reach(const AnyShape& shape, const gphys_vec3& point) {
    Extent e;
    e.add(shape);
    e.add(point);
    e.add(gphys_vec3{0, 0, 0});
    return e.value();
}

double extent(const AnyShape& shape, const gphys_vec3& point) {
    Extent e;
    e.add(shape);
    e.add(point);
    return e.value();
}

bool is_clear(const AnyShape& a, const AnyShape& b) {
    if (is_exact(a.type) && is_exact(b.type)) return true;
    Extent e;
    e.add(a);
    e.add(b);
    const double by = 0x1p-37 * e.value();
    const AnyShape larger_a = grown(a, 1, by), larger_b = grown(b, 1, by);
    if (!is_valid(larger_a) || !is_valid(larger_b)) return false;
    if (!overlap(larger_a, larger_b)) return true;
    if (!can_shrink(a, by) && !can_shrink(b, by)) return false;
    return overlap(can_shrink(a, by) ? grown(a, -1, by) : a, can_shrink(b, by) ? grown(b, -1, by) : b);
}

void check_moved_overlap(Program& p, const AnyShape& a, const AnyShape& b, bool overlaps) {
    Motion m = motion(p);
    const AnyShape there_a = m.shape(a), there_b = m.shape(b);
    if (!m.exact || !is_valid(there_a) || !is_valid(there_b)) return;
    FUZZ_CHECK(overlap(there_a, there_b) == overlaps || !is_clear(a, b), "overlaps is the same after a motion");
}

void check_moved_ray(Program& p, const AnyShape& shape, const gphys_ray& ray, const gphys_hit* hit) {
    if (!has_exact_rays(shape.type)) return;
    Motion m = motion(p);
    const AnyShape there = m.shape(shape);
    const gphys_ray moved{m.point(ray.origin), m.vector(ray.direction), ray.t_max};
    if (!m.exact || !is_valid(there) || !is_valid(moved)) return;
    gphys_hit found{};
    const gphys_status status = call(gphys_shape_raycast, there.type, there.bytes, &moved, &found);
    FUZZ_CHECK((status == GPHYS_OK) == (hit != nullptr), "a ray hits or misses the same after a motion");
    if (hit) {
        FUZZ_CHECK(ulps(found.t, hit->t) <= 2, "t is the same after a motion");
        FUZZ_CHECK(found.flags == hit->flags, "a hit's flags are the same after a motion");
    }
}

}  // namespace fuzz
