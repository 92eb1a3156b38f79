// Vectors, rotations and transforms in double precision. Results are computed in double and rounded to float32 once,
// at the C interface.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "foundation/floating_point.h"
#include "foundation/rotation.h"
#include "gamephys_c.h"

namespace gphys {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979323846;

using Vec3 = Vec<double>;

/// The axis of the largest component, the first of equal ones.
inline int longest_axis(Vec3 a) {
    const Vec3 size = abs(a);
    const int of_x_and_y = size.y > size.x, is_z = size.z > std::max(size.x, size.y);
    return of_x_and_y + is_z * (2 - of_x_and_y);  // a branch would be unpredictable
}

/// A unit vector perpendicular to the unit vector n (Duff et al. 2017).
inline Vec3 perpendicular(Vec3 n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    return {1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

using Quat = Quaternion<double>;

constexpr Quat operator*(Quat a, Quat b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
constexpr Quat conjugate(Quat q) { return {-q.x, -q.y, -q.z, q.w}; }
inline Quat normalized(Quat q) {
    const double s = 1.0 / std::sqrt(norm_squared(q));
    return {q.x * s, q.y * s, q.z * s, q.w * s};
}

using Mat3 = Matrix<double>;

/// The rotation of an orthonormal right-handed matrix (Shepperd 1978).
Quat quaternion(const Mat3& rotation);

/// x -> position + rotation (scale x).
struct Transform {
    Vec3 position;
    Mat3 rotation;
    double scale = 1;

    Vec3 apply(Vec3 p) const { return position + rotation * (p * scale); }
    Vec3 apply_to_vector(Vec3 v) const { return rotation * (v * scale); }
    Vec3 inverse_apply(Vec3 p) const { return transpose_times(rotation, p - position) / scale; }
    Vec3 inverse_apply_to_vector(Vec3 v) const { return transpose_times(rotation, v) / scale; }
};

constexpr Vec3 widen(gphys_vec3 v) { return {v.x, v.y, v.z}; }
constexpr Quat widen(gphys_quat q) { return {q.x, q.y, q.z, q.w}; }
inline Transform widen(const gphys_transform& t) {
    return {widen(t.position), rotation_matrix(widen(t.rotation)), t.scale};
}
/// The world transform of `local` below `parent`: computed in double, each number rounded once.
gphys_transform composed(const gphys_transform& parent, const gphys_transform& local);
/// The local transform below `parent` that gives `world`, up to that rounding.
gphys_transform relative(const gphys_transform& parent, const gphys_transform& world);

/// Clamped to -limit .. limit, because converting a larger double raises an exception.
inline float to_float(double value, double limit = std::numeric_limits<float>::max()) {
    return static_cast<float>(std::clamp(value, -limit, limit));
}
constexpr gphys_vec3 narrow(Vec3 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
constexpr gphys_quat narrow(Quat q) {
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)};
}

/// The exact world position behind a float position relative to a movable origin (floating origin). Moving the origin
/// derives the new float position from it, so that rounding does not accumulate. A float position that has been set
/// since replaces it.
class WorldPlace {
public:
    /// The position from the new origin.
    Vec3 move_origin(Vec3 origin, Vec3 new_origin, gphys_vec3 position) {
        if (widen(narrow(world_ - origin)) != widen(position)) world_ = origin + widen(position);
        return world_ - new_origin;
    }
    /// The new position, from the same origin, after a displacement by `by`.
    Vec3 move(Vec3 origin, gphys_vec3 position, Vec3 by) {
        move_origin(origin, origin, position);
        world_ += by;
        return world_ - origin;
    }
    Vec3 world() const { return world_; }

private:
    Vec3 world_;
};

/// The float before f if `whether`, else f. Without a branch, which would be unpredictable where doubles are rounded
/// down.
inline float float_before(float f, bool whether) {
    // Floats of one sign are ordered as their bits are. The float before both zeros is the smallest negative denormal.
    int32_t bits;
    std::memcpy(&bits, &f, sizeof bits);
    const int32_t down = bits > 0 ? -1 : 1;
    const bool zero = f == 0;
    bits = whether && zero ? std::numeric_limits<int32_t>::min() + 1 : bits + down * (whether && !zero);
    std::memcpy(&f, &bits, sizeof f);
    return f;
}

/// Largest float <= v + rest, and smallest float >= v + rest, where |rest| is at most half an ulp of v. Clamped to the
/// finite floats, because converting a larger double raises an exception.
inline float round_down(double v, double rest = 0) {
    constexpr double last = std::numeric_limits<float>::max();
    const float f = to_float(v);
    return float_before(f, ((f > v) | ((f == v) & (rest < 0))) & (v > -last));
}
inline float round_up(double v, double rest = 0) { return -round_down(-v, -rest); }

}  // namespace gphys
