#include "program.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "check.h"

namespace fuzz {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Roundings that a caller's own arithmetic leaves behind: sines and cosines of multiples of 15 degrees, tenths,
// thirds, and what is left where 0 was meant.
constexpr float leftovers[] = {
    0.0f,        -0.0f,       1.0f,         -1.0f,       0.5f,           -0.5f,           0.1f,           0.2f,
    0.3f,        0.7f,        1.0f / 3,     2.0f / 3,    0.70710677f,    -0.70710677f,    0.8660254f,     0.25881904f,
    0.9659f,     6.1232e-17f, -6.1232e-17f, 1.2246e-16f, -8.7422777e-8f, -4.371139e-8f,   1.1920929e-7f,  0.99999994f,
    1.00000012f, 1e-30f,      16777216.0f,  16777215.0f, 3.1415927f,     -2.2250739e-38f, 1.4012985e-45f, 1e7f};

constexpr float hostile_values[] = {std::numeric_limits<float>::quiet_NaN(),
                                    std::numeric_limits<float>::signaling_NaN(),
                                    infinity,
                                    -infinity,
                                    GPHYS_MAX_COORDINATE,
                                    -GPHYS_MAX_COORDINATE,
                                    1.0000001e15f,
                                    std::numeric_limits<float>::max(),
                                    std::numeric_limits<float>::lowest(),
                                    std::numeric_limits<float>::denorm_min(),
                                    -std::numeric_limits<float>::denorm_min(),
                                    std::numeric_limits<float>::min(),
                                    0.0f,
                                    -0.0f,
                                    -1.0f,
                                    1e-20f};

/// Returns what it prints.
template <class Public>
const Public& shown(const char* what, const Public& value, size_t size = sizeof(Public)) {
    if (!session().print) return value;
    std::printf("  %s {", what);
    for (size_t i = 0; i < size / 4; ++i) {
        float number;
        std::memcpy(&number, reinterpret_cast<const char*>(&value) + 4 * i, 4);
        std::printf(" %a", static_cast<double>(number));
    }
    std::printf(" }\n");
    return value;
}

bool in_range(float v) { return std::fabs(v) <= GPHYS_MAX_COORDINATE; }
bool is_size(float v) { return v >= 0 && v <= GPHYS_MAX_COORDINATE; }
bool is_zero(const gphys_vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }
/// A unit normal may have been rounded to floats.
bool is_plane(const gphys_plane& plane) {
    const double x = plane.normal.x, y = plane.normal.y, z = plane.normal.z;
    return is_valid(plane.normal) && in_range(plane.distance) && !is_zero(plane.normal) &&
           std::fabs(static_cast<double>(plane.distance)) <=
               double{GPHYS_MAX_COORDINATE} * (1 + 0x1p-22) * std::sqrt(x * x + y * y + z * z);
}

}  // namespace

Program::Program(const uint8_t* bytes, size_t size) : next_(bytes), end_(bytes + size) {
    style_ = static_cast<Style>(below(8));
}

uint32_t Program::word() {
    uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | byte();
    return value;
}

uint32_t Program::below(uint32_t count) {
    if (count <= 1) return 0;
    return count <= 256 ? byte() * count >> 8 : (byte() << 8 | byte()) * count >> 16;
}

float Program::number(Style style) {
    switch (style) {
        case Style::grid:
            return static_cast<float>(static_cast<int>(below(9)) - 4);
        case Style::quarters: {
            const uint32_t choice = byte();
            const float value = (static_cast<float>(choice & 31) - 16) / 4;
            if (choice < 192) return value;
            return std::nextafter(value, choice & 32 ? infinity : -infinity);
        }
        case Style::continuous: {
            const uint32_t high = byte(), middle = byte(), low = byte();
            return (static_cast<float>(high << 16 | middle << 8 | low) - 8388608.0f) / 1048576;
        }
        case Style::rounded: {
            const uint32_t choice = byte();
            return leftovers[choice & 31] * (choice & 32 ? -1.0f : 1.0f) * (choice & 64 ? 0.1f : 1.0f);
        }
        case Style::far:
            return 1048576.0f + number(Style::quarters);
        case Style::tiny:
            return number(Style::grid) * std::numeric_limits<float>::denorm_min() * (byte() & 1 ? 1.0f : 1024.0f);
        case Style::huge:
            return (static_cast<float>(byte()) - 128) / 128 * GPHYS_MAX_COORDINATE;
        case Style::mixed:
            break;
    }
    return number(static_cast<Style>(below(7)));
}

float Program::number() { return number(style_); }

float Program::size() {
    const float value = std::fabs(number());
    return style_ == Style::far && value > 1000 ? value - 1048570 : value;
}

float Program::hostile() {
    const uint32_t choice = byte();
    if (choice < 128) return hostile_values[choice & 15];
    const uint32_t bits = word();
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

gphys_vec3 Program::point() {
    const uint32_t choice = byte();
    if (drawn_count_ > 0 && choice >= 170) {
        const uint32_t known = drawn_count_ < 16 ? drawn_count_ : 16;
        gphys_vec3 point = drawn_[choice % known];
        if (choice < 190) (&point.x)[choice % 3] = number();
        return shown("point", point);
    }
    const gphys_vec3 point{number(), number(), number()};
    drawn_[drawn_count_++ & 15] = point;
    return shown("point", point);
}

gphys_vec3 Program::direction() {
    gphys_vec3 d{0, 0, 0};
    const uint32_t choice = byte();
    if (choice < 64) {
        (&d.x)[choice % 3] = choice & 1 ? 1.0f : -2.0f;
    } else if (choice < 160 && drawn_count_ >= 2) {
        const uint32_t known = drawn_count_ < 16 ? drawn_count_ : 16;
        const gphys_vec3 &a = drawn_[choice % known], &b = drawn_[byte() % known];
        d = {b.x - a.x, b.y - a.y, b.z - a.z};
        if (!is_valid(d)) d = {0, 0, 0};
    } else {
        d = {number(), number(), number()};
    }
    if (is_zero(d)) d.y = 1;
    return shown("direction", d);
}

gphys_quat Program::rotation() {
    const uint32_t choice = byte();
    if (style_ == Style::grid || choice < 64) return {0, 0, 0, 1};
    constexpr float half = 0.70710677f;
    switch (choice & 7) {
        case 0:
            return {half, 0, 0, half};
        case 1:
            return {0, -half, 0, half};
        case 2:
            return {0.5f, 0.5f, 0.5f, 0.5f};
        case 3:
            return {0, 0, 1, 0};
        case 4:
            return {0, 0.25881904f, 0, 0.9659258f};
        default:
            break;
    }
    double q[4], square = 0;
    for (double& part : q) {
        part = static_cast<double>(byte()) - 127.5;
        square += part * part;
    }
    const double scale = 1 / std::sqrt(square);
    return {static_cast<float>(q[0] * scale), static_cast<float>(q[1] * scale), static_cast<float>(q[2] * scale),
            static_cast<float>(q[3] * scale)};
}

gphys_transform Program::transform() {
    constexpr float scales[] = {1, 1, 1, 2, 0.5f, 3, 0.1f, 1.7f};
    return {point(), rotation(), style_ == Style::grid ? 1.0f : scales[below(8)]};
}

gphys_ray Program::ray() {
    gphys_ray ray;
    ray.origin = point();
    ray.direction = direction();
    const uint32_t choice = byte();
    ray.t_max = choice < 128 ? infinity : choice < 200 ? static_cast<float>(choice - 128) / 16 : std::fabs(number());
    return shown("ray", ray);
}

gphys_segment Program::segment() { return {point(), point()}; }

gphys_frustum Program::frustum() {
    gphys_frustum f;
    f.origin = point();
    const uint32_t choice = byte();
    if (choice < 40) {  // planes at random: often empty, sometimes unbounded
        for (gphys_plane& plane : f.planes) plane = {direction(), number()};
        return f;
    }
    const float slope = choice & 1 ? 0.0f : choice & 2 ? 0.5f : 1.0f;
    const float width = size() + 1, depth = size() + 2;
    f.planes[GPHYS_FRUSTUM_NEAR] = {{0, 0, 1}, static_cast<float>(choice >> 6)};
    f.planes[GPHYS_FRUSTUM_FAR] = choice & 4 ? gphys_plane{{0, 0, -1}, -depth} : gphys_plane{{0, 0, 0}, -1};
    f.planes[GPHYS_FRUSTUM_LEFT] = {{1, 0, slope}, -width};
    f.planes[GPHYS_FRUSTUM_RIGHT] = {{-1, 0, slope}, -width};
    f.planes[GPHYS_FRUSTUM_BOTTOM] = {{0, 1, slope}, -width};
    f.planes[GPHYS_FRUSTUM_TOP] = {{0, -1, slope}, -width};
    return f;
}

gphys_shape_type Program::shape_type(bool with_frustum) {
    return static_cast<gphys_shape_type>(GPHYS_SHAPE_SPHERE + below(with_frustum ? 7 : 6));
}

AnyShape Program::shape(gphys_shape_type type) {
    const AnyShape any = draw_shape(type);
    if (session().print) {
        constexpr const char* names[] = {"", "sphere", "capsule", "aabb", "obb", "plane", "triangle", "frustum"};
        shown(type < 8 ? names[type] : "line", any.bytes, any.size);
    }
    return any;
}

AnyShape Program::draw_shape(gphys_shape_type type) {
    switch (type) {
        case GPHYS_SHAPE_SPHERE:
            return AnyShape::of(type, gphys_sphere{point(), size()});
        case GPHYS_SHAPE_CAPSULE:
            return AnyShape::of(type, gphys_capsule{point(), point(), size()});
        case GPHYS_SHAPE_AABB: {
            const gphys_vec3 a = point(), b = point();
            return AnyShape::of(type, gphys_aabb{{std::fmin(a.x, b.x), std::fmin(a.y, b.y), std::fmin(a.z, b.z)},
                                                 {std::fmax(a.x, b.x), std::fmax(a.y, b.y), std::fmax(a.z, b.z)}});
        }
        case GPHYS_SHAPE_OBB:
            return AnyShape::of(type, gphys_obb{point(), {size(), size(), size()}, rotation()});
        case GPHYS_SHAPE_PLANE: {
            const gphys_plane plane{direction(), number()};
            const AnyShape any = AnyShape::of(type, plane);
            return is_valid(any) ? any : AnyShape::of(type, gphys_plane{plane.normal, 0});
        }
        case GPHYS_SHAPE_TRIANGLE:
            return AnyShape::of(type, gphys_triangle{point(), point(), point()});
        case GPHYS_SHAPE_FRUSTUM: {
            const AnyShape any = AnyShape::of(type, frustum());
            return is_valid(any) ? any
                                 : AnyShape::of(type, gphys_frustum{{0, 0, 0},
                                                                    {{{0, 0, 1}, 0},
                                                                     {{0, 0, 0}, -1},
                                                                     {{1, 0, 1}, 0},
                                                                     {{-1, 0, 1}, 0},
                                                                     {{0, 1, 1}, 0},
                                                                     {{0, -1, 1}, 0}}});
        }
        case GPHYS_SHAPE_RAY:
            return AnyShape::of(type, ray());
        default:
            return AnyShape::of(GPHYS_SHAPE_SEGMENT, segment());
    }
}

void Program::spoil(AnyShape& shape, uint32_t one_time_in) {
    if (shape.size == 0 || !one_in(one_time_in)) return;
    const float bad = hostile();
    std::memcpy(shape.bytes + 4 * below(shape.size / 4), &bad, 4);
    shown("spoiled", shape.bytes, shape.size);
}

bool is_valid(const gphys_vec3& point) { return in_range(point.x) && in_range(point.y) && in_range(point.z); }
bool is_valid(const gphys_ray& ray) {
    return is_valid(ray.origin) && is_valid(ray.direction) && !is_zero(ray.direction) && ray.t_max >= 0;
}
bool is_valid(const gphys_segment& segment) { return is_valid(segment.a) && is_valid(segment.b); }
bool is_valid(const gphys_quat& q) {
    const double x = q.x, y = q.y, z = q.z, w = q.w, length = std::sqrt(x * x + y * y + z * z + w * w);
    return length >= 0.999 && length <= 1.001;
}
bool is_valid(const gphys_transform& t) {
    return is_valid(t.position) && is_valid(t.rotation) && t.scale > 0 && t.scale <= GPHYS_MAX_COORDINATE;
}

bool is_valid(const AnyShape& shape) {
    switch (shape.type) {
        case GPHYS_SHAPE_SPHERE: {
            const auto s = shape.as<gphys_sphere>();
            return is_valid(s.center) && is_size(s.radius);
        }
        case GPHYS_SHAPE_CAPSULE: {
            const auto c = shape.as<gphys_capsule>();
            return is_valid(c.a) && is_valid(c.b) && is_size(c.radius);
        }
        case GPHYS_SHAPE_AABB: {
            const auto b = shape.as<gphys_aabb>();
            return is_valid(b.min) && is_valid(b.max) && b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z;
        }
        case GPHYS_SHAPE_OBB: {
            const auto b = shape.as<gphys_obb>();
            return is_valid(b.center) && is_size(b.half_extents.x) && is_size(b.half_extents.y) &&
                   is_size(b.half_extents.z) && is_valid(b.rotation);
        }
        case GPHYS_SHAPE_PLANE:
            return is_plane(shape.as<gphys_plane>());
        case GPHYS_SHAPE_TRIANGLE: {
            const auto t = shape.as<gphys_triangle>();
            return is_valid(t.a) && is_valid(t.b) && is_valid(t.c);
        }
        case GPHYS_SHAPE_FRUSTUM: {
            const auto f = shape.as<gphys_frustum>();
            if (!is_valid(f.origin)) return false;
            for (int i = 0; i < 6; ++i) {
                const gphys_plane& plane = f.planes[i];
                const bool no_far_plane = i == GPHYS_FRUSTUM_FAR && is_zero(plane.normal) && plane.distance == -1;
                if (!no_far_plane && !is_plane(plane)) return false;
            }
            return true;
        }
        case GPHYS_SHAPE_RAY:
            return is_valid(shape.as<gphys_ray>());
        case GPHYS_SHAPE_SEGMENT:
            return is_valid(shape.as<gphys_segment>());
        default:
            return false;
    }
}

}  // namespace fuzz
