// Four floats side by side, in the vectors that every target of the compilers has: for x, y, z and one
// to spare. Plain IEEE arithmetic, so the bits are the same everywhere.
#pragma once

#include <cstdint>

#include "foundation/math.h"

namespace gphys {

using Float4 = float __attribute__((vector_size(16)));
/// All bits of a lane are set or none.
using Mask4 = int32_t __attribute__((vector_size(16)));

inline Float4 splat4(float value) { return Float4{value, value, value, value}; }
inline Float4 narrow4(Vec3 v) {
    return Float4{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0};
}
inline Float4 narrow4(Quat q) {
    return Float4{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)};
}
inline Float4 load4(const gphys_vec3& p) { return Float4{p.x, p.y, p.z, 0}; }
inline Float4 load4(const gphys_quat& q) {
    Float4 v;
    std::memcpy(&v, &q, sizeof v);
    return v;
}
inline Float4 abs(Float4 v) {
    return reinterpret_cast<Float4>(reinterpret_cast<Mask4>(v) & Mask4{INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX});
}
/// v where it is positive, else 0.
inline Float4 positive(Float4 v) { return reinterpret_cast<Float4>(reinterpret_cast<Mask4>(v) & (v > Float4{})); }

/// y, z, x; and z, x, y. The fourth stays.
inline Float4 yzx(Float4 v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); }
inline Float4 zxy(Float4 v) { return __builtin_shufflevector(v, v, 2, 0, 1, 3); }

/// The sum of all four, in each.
inline Float4 sum(Float4 v) {
    v += __builtin_shufflevector(v, v, 1, 0, 3, 2);
    return v + __builtin_shufflevector(v, v, 2, 3, 0, 1);
}
inline bool any(Mask4 mask) {
    using Halves = int64_t __attribute__((vector_size(16)));
    const Halves halves = reinterpret_cast<Halves>(mask);
    return (halves[0] | halves[1]) != 0;
}

}  // namespace gphys
