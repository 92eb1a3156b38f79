// One double or eight in SIMD registers, for kernels (isa.h) that are written once for both. A lane computes the same
// bits whatever the other lanes are and however many there are.
#pragma once

#include <cmath>

#include "foundation/simd.h"

namespace gphys::GPHYS_ISA {

constexpr int double_register_count = 8 / double_register_lanes;

struct Double8 {
    DoubleRegister part[double_register_count];

    Double8() = default;
    GPHYS_INLINE Double8(double all) {
        for (DoubleRegister& p : part) p = DoubleRegister(all);
    }
};
struct DoubleMask8 {
    DoubleMaskRegister part[double_register_count];
};

template <int lanes>
struct DoublesOf;
template <>
struct DoublesOf<1> {
    using Value = double;
    using Mask = bool;
};
template <>
struct DoublesOf<8> {
    using Value = Double8;
    using Mask = DoubleMask8;
};
template <int lanes>
using Doubles = typename DoublesOf<lanes>::Value;

GPHYS_INLINE double load(const double (&from)[1]) { return from[0]; }
GPHYS_INLINE void store(double (&to)[1], double value) { to[0] = value; }
GPHYS_INLINE double square_root(double a) { return ::sqrt(a); }
GPHYS_INLINE double select(bool mask, double a, double b) { return mask ? a : b; }
GPHYS_INLINE bool any(bool mask) { return mask; }

GPHYS_BY_REGISTER(Double8, load_doubles(const double* from), load_register(from + double_register_lanes * i))
GPHYS_INLINE void store_doubles(double* to, Double8 v) {
    for (int i = 0; i < double_register_count; ++i) store_register(to + double_register_lanes * i, v.part[i]);
}
GPHYS_INLINE Double8 load(const double (&from)[8]) { return load_doubles(from); }
GPHYS_INLINE void store(double (&to)[8], Double8 v) { store_doubles(to, v); }
template <int lanes>
GPHYS_INLINE Doubles<lanes> all_of(double value) {
    return Doubles<lanes>(value);
}

GPHYS_BY_REGISTER(Double8, operator+(Double8 a, Double8 b), a.part[i] + b.part[i])
GPHYS_BY_REGISTER(Double8, operator-(Double8 a, Double8 b), a.part[i] - b.part[i])
GPHYS_BY_REGISTER(Double8, operator*(Double8 a, Double8 b), a.part[i] * b.part[i])
GPHYS_BY_REGISTER(Double8, operator/(Double8 a, Double8 b), a.part[i] / b.part[i])
GPHYS_BY_REGISTER(Double8, operator-(Double8 a), -a.part[i])
GPHYS_BY_REGISTER(Double8, square_root(Double8 a), square_root(a.part[i]))

/// fabs and copysign.
GPHYS_BY_REGISTER(Double8, absolute(Double8 a), absolute(a.part[i]))
GPHYS_BY_REGISTER(Double8, with_sign(Double8 a, Double8 sign), with_sign(a.part[i], sign.part[i]))

GPHYS_BY_REGISTER(DoubleMask8, operator<(Double8 a, Double8 b), a.part[i] < b.part[i])
GPHYS_BY_REGISTER(DoubleMask8, operator<=(Double8 a, Double8 b), a.part[i] <= b.part[i])
GPHYS_BY_REGISTER(DoubleMask8, operator|(DoubleMask8 a, DoubleMask8 b), a.part[i] | b.part[i])
GPHYS_BY_REGISTER(DoubleMask8, operator&(DoubleMask8 a, DoubleMask8 b), a.part[i] & b.part[i])
GPHYS_BY_REGISTER(DoubleMask8, operator!(DoubleMask8 a), !a.part[i])
GPHYS_BY_REGISTER(Double8, select(DoubleMask8 mask, Double8 a, Double8 b), select(mask.part[i], a.part[i], b.part[i]))
/// Movemask: bit i is lane i.
GPHYS_INLINE uint32_t bits(DoubleMask8 mask) {
    uint32_t result = 0;
    for (int i = 0; i < double_register_count; ++i) result |= bits(mask.part[i]) << (double_register_lanes * i);
    return result;
}
GPHYS_INLINE bool any(DoubleMask8 mask) {
    DoubleMaskRegister all = mask.part[0];
    for (int i = 1; i < double_register_count; ++i) all = all | mask.part[i];
    return bits(all) != 0;
}

/// a < b ? a : b, and a < b ? b : a.
GPHYS_INLINE double least(double a, double b) { return a < b ? a : b; }
GPHYS_INLINE double largest(double a, double b) { return a < b ? b : a; }
GPHYS_BY_REGISTER(Double8, least(Double8 a, Double8 b), least(a.part[i], b.part[i]))
GPHYS_BY_REGISTER(Double8, largest(Double8 a, Double8 b), largest(a.part[i], b.part[i]))

/// Rounded to floats; floats unchanged.
GPHYS_INLINE Float8 narrowed(Double8 a) {
    constexpr int of_each = double_register_count / register_count;
    Float8 narrow;
    for (int i = 0; i < register_count; ++i) {
        DoubleRegister wide[of_each];
        for (int k = 0; k < of_each; ++k) wide[k] = a.part[of_each * i + k];
        narrow.part[i] = narrowed(wide);
    }
    return narrow;
}
GPHYS_INLINE Double8 widened(Float8 a) {
    constexpr int of_each = double_register_count / register_count;
    Double8 wide;
    for (int i = 0; i < register_count; ++i) {
        DoubleRegister part[of_each];
        widen_to(part, a.part[i]);
        for (int k = 0; k < of_each; ++k) wide.part[of_each * i + k] = part[k];
    }
    return wide;
}

GPHYS_INLINE Double8 rounded_to_float(Double8 a) { return widened(narrowed(a)); }

#if !GPHYS_HAS_AVX2
template <class At>
GPHYS_INLINE DoubleRegister load_doubles_from(const At& at, int first) {
    return {*at(first), *at(first + 1)};
}
#endif

/// Four floats from each of eight addresses, widened to doubles.
struct Four8 {
    Double8 x, y, z, w;

    template <class At>
    GPHYS_INLINE explicit Four8(const At& at) {
        const Quads8 quads = load_quads(at);
        x = widened(quads.x), y = widened(quads.y), z = widened(quads.z), w = widened(quads.w);
    }
};

/// `count` consecutive doubles from each of eight addresses at(i), as one register for each component.
template <int count, class At>
GPHYS_INLINE void load_components(const At& at, Double8 (&to)[count]) {
    for (int k = 0; k < count; ++k) {
        const auto component = [&](int i) GPHYS_INLINE_LAMBDA { return at(i) + k; };
        for (int i = 0; i < double_register_count; ++i) {
            to[k].part[i] = load_doubles_from(component, double_register_lanes * i);
        }
    }
}
template <int count, class At>
GPHYS_INLINE void store_components(const At& at, const Double8 (&from)[count]) {
    for (int i = 0; i < 8; ++i) {
        for (int k = 0; k < count; ++k) at(i)[k] = from[k].part[i / double_register_lanes][i % double_register_lanes];
    }
}
/// The same for one address.
template <int count, class At>
GPHYS_INLINE void load_components(const At& at, double (&to)[count]) {
    for (int k = 0; k < count; ++k) to[k] = at(0)[k];
}
template <int count, class At>
GPHYS_INLINE void store_components(const At& at, const double (&from)[count]) {
    for (int k = 0; k < count; ++k) at(0)[k] = from[k];
}

#if GPHYS_HAS_AVX2
/// 8x4 transposition: eight rows of four doubles, row(i), as four registers of eight.
template <class Row>
GPHYS_INLINE void columns_of(const Row& row, Double8 (&to)[4]) {
    for (int part = 0; part < double_register_count; ++part) {
        DoubleRegister v[4];
        for (int i = 0; i < 4; ++i) v[i] = join_rows(row, 4 * part + i);
        transpose(v);
        for (int k = 0; k < 4; ++k) to[k].part[part] = v[k];
    }
}
/// The inverse: put(i, row).
template <class Put>
GPHYS_INLINE void scatter_rows_of(const Double8 (&from)[4], const Put& put) {
    for (int part = 0; part < double_register_count; ++part) {
        DoubleRegister v[4];
        for (int k = 0; k < 4; ++k) v[k] = from[k].part[part];
        transpose(v);
        for (int i = 0; i < 4; ++i) scatter_rows(v[i], put, 4 * part + i);
    }
}

template <class At>
GPHYS_INLINE void load_components(const At& at, Double8 (&to)[4]) {
    columns_of([&](int i) GPHYS_INLINE_LAMBDA { return load_four(at(i)); }, to);
}
template <class At>
GPHYS_INLINE void store_components(const At& at, const Double8 (&from)[4]) {
    scatter_rows_of(from, [&](int i, const auto& row) GPHYS_INLINE_LAMBDA { store_four(at(i), row); });
}
/// Reads no memory behind the third double.
template <class At>
GPHYS_INLINE void load_components(const At& at, Double8 (&to)[3]) {
    Double8 all[4];
    columns_of([&](int i) GPHYS_INLINE_LAMBDA { return load_three(at(i)); }, all);
    for (int k = 0; k < 3; ++k) to[k] = all[k];
}
template <class At>
GPHYS_INLINE void store_components(const At& at, const Double8 (&from)[3]) {
    const Double8 all[4] = {from[0], from[1], from[2], from[2]};
    scatter_rows_of(all, [&](int i, const auto& row) GPHYS_INLINE_LAMBDA { store_three(at(i), row); });
}
#endif

}  // namespace gphys::GPHYS_ISA
