// Eight vectors side by side, in doubles, for kernels: as in math.h, term by term.
#pragma once

#include "foundation/simd_double.h"

// Calls would hand eight lanes over in memory.
#define GPHYS_INLINE [[gnu::always_inline]] inline

namespace gphys::GPHYS_ISA {

struct Vector8 {
    Double8 x, y, z;
};
GPHYS_INLINE Vector8 operator+(const Vector8& a, const Vector8& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
GPHYS_INLINE Vector8 operator-(const Vector8& a, const Vector8& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
GPHYS_INLINE Vector8 operator-(const Vector8& a) { return {-a.x, -a.y, -a.z}; }
GPHYS_INLINE Vector8 operator*(const Vector8& a, Double8 s) { return {a.x * s, a.y * s, a.z * s}; }
GPHYS_INLINE Vector8 operator/(const Vector8& a, Double8 s) { return {a.x / s, a.y / s, a.z / s}; }
GPHYS_INLINE Vector8 absolute(const Vector8& a) { return {absolute(a.x), absolute(a.y), absolute(a.z)}; }
GPHYS_INLINE Double8 dot(const Vector8& a, const Vector8& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
GPHYS_INLINE Vector8 cross(const Vector8& a, const Vector8& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
GPHYS_INLINE Double8 sum(const Vector8& a) { return a.x + a.y + a.z; }
GPHYS_INLINE Double8 max_component(const Vector8& a) { return largest(a.x, largest(a.y, a.z)); }
GPHYS_INLINE Vector8 select(DoubleMask8 mask, const Vector8& a, const Vector8& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}
/// Of vectors that are not zero.
GPHYS_INLINE Vector8 normalized(const Vector8& a) {
    const Vector8 scaled = a / max_component(absolute(a));
    return scaled / square_root(dot(scaled, scaled));
}

/// Four floats of each of eight places.
struct Four8 {
    Double8 x, y, z, w;

    template <class At>
    GPHYS_INLINE explicit Four8(const At& at) {
        const Quads8 quads = load_quads(at);
        x = widened(quads.x), y = widened(quads.y), z = widened(quads.z), w = widened(quads.w);
    }
};

}  // namespace gphys::GPHYS_ISA
