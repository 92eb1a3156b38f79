// The conversion to_hit (intersect.h) for eight hits at a time, for kernels.
#pragma once

#include <limits>

#include "foundation/compiler.h"
#include "foundation/simd_double.h"
#include "foundation/vec.h"

namespace gphys::GPHYS_ISA {

GPHYS_INLINE Float8 rounded_distance(Double8 t) {
    constexpr double last = std::numeric_limits<float>::max();
    return narrowed(least(last, t));
}
/// t and point, in the order of gphys_hit.
GPHYS_INLINE Quads8 rounded_place(Double8 t, const Vec<Double8>& point) {
    constexpr double last = std::numeric_limits<float>::max();
    const auto clamped = [](Double8 v) { return narrowed(least(last, largest(v, -last))); };
    return {rounded_distance(t), clamped(point.x), clamped(point.y), clamped(point.z)};
}
/// A normal, which needs no clamping, and the member after it.
GPHYS_INLINE Quads8 rounded_normal(const Vec<Double8>& normal, Float8 next) {
    return {narrowed(normal.x), narrowed(normal.y), narrowed(normal.z), next};
}

}  // namespace gphys::GPHYS_ISA
