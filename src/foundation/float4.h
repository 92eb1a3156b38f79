// Four floats in a SIMD register for code outside of kernels: x, y, z and one more lane. Uses only instructions that
// every processor of the target has, and plain IEEE arithmetic, so the bits are the same everywhere.
#pragma once

#include <cstdint>
#include <cstring>

#include "foundation/math.h"

#if defined(__SSE2__) || defined(_M_X64)
#include "foundation/simd_sse2.h"
namespace gphys {
namespace simd4 = simd_sse2;
}
#elif defined(__aarch64__) || defined(_M_ARM64)
#include "foundation/simd_neon.h"
namespace gphys {
namespace simd4 = simd_neon;
}
#elif defined(__wasm_simd128__)
#include "foundation/simd_wasm.h"
namespace gphys {
namespace simd4 = simd_wasm;
}
#else
#include "foundation/simd_plain.h"
namespace gphys {
namespace simd4 = simd_plain;
}
#endif

namespace gphys {

using Float4 = simd4::FloatRegister;
/// The result of a comparison has all bits of a lane set or none. Other masks have arbitrary bits.
using Mask4 = simd4::MaskRegister;
inline Mask4 mask4(int32_t a, int32_t b, int32_t c, int32_t d) { return simd4::set_mask(a, b, c, d); }

inline Float4 splat4(float value) { return Float4(value); }
inline Float4 narrow4(Vec3 v) {
    return Float4(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0);
}
inline Float4 narrow4(Quat q) {
    return Float4(static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w));
}
inline Float4 load4(const gphys_vec3& p) { return Float4(p.x, p.y, p.z, 0); }
inline Float4 load4(const gphys_quat& q) {
    Float4 v;
    std::memcpy(&v, &q, sizeof v);
    return v;
}
inline Float4& operator+=(Float4& a, Float4 b) { return a = a + b; }
inline Float4& operator-=(Float4& a, Float4 b) { return a = a - b; }
inline Float4& operator*=(Float4& a, Float4 b) { return a = a * b; }
/// Flips all signs, also those of zeros.
inline Float4 operator-(Float4 v) { return as_floats(as_mask(v) ^ mask4(INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN)); }
inline Float4 abs(Float4 v) { return as_floats(as_mask(v) & mask4(INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX)); }
inline Mask4 operator>(Float4 a, Float4 b) { return b < a; }
/// v where it is positive, else 0.
inline Float4 positive(Float4 v) { return as_floats(as_mask(v) & (Float4(0.0f) < v)); }

/// y, z, x; and z, x, y. The fourth stays.
inline Float4 yzx(Float4 v) { return simd4::shuffle<1, 2, 0, 3>(v, v); }
inline Float4 zxy(Float4 v) { return simd4::shuffle<2, 0, 1, 3>(v, v); }

/// The sum of the four lanes, in all lanes.
inline Float4 sum(Float4 v) {
    v += simd4::shuffle<1, 0, 3, 2>(v, v);
    return v + simd4::shuffle<2, 3, 0, 1>(v, v);
}

// The interface of vec.h. Products are component by component; a sum is in all lanes.
inline Float4 by_component(Float4 a, Float4 b) { return a * b; }
inline Float4 splat_as(Float4, float value) { return splat4(value); }
inline Float4 plus(Float4 a, Float4 b) { return a + b; }
inline Float4 minus(Float4 a, Float4 b) { return a - b; }
inline Float4 against(Float4 a, Float4 direction) { return simd4::choose(direction < Float4{}, a, -a); }
inline Float4 dot(Float4 a, Float4 b) { return sum(a * b); }
inline Float4 cross(Float4 a, Float4 b) { return yzx(a * yzx(b) - yzx(a) * b); }

inline bool any(Mask4 mask) {
    int64_t halves[2];
    std::memcpy(halves, &mask, sizeof halves);
    return (halves[0] | halves[1]) != 0;
}

/// Lane by lane; and whether it holds in the first three lanes.
inline Mask4 at_most(Float4 a, Float4 b) { return a <= b; }
inline bool all_axes(Mask4 mask) { return !any((mask ^ mask4(-1, -1, -1, -1)) & mask4(-1, -1, -1, 0)); }

}  // namespace gphys
