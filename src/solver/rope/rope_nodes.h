// What the kernels of ropes have in common.
#pragma once

#include "foundation/simd_double.h"
#include "solver/rope/rope_kernels.h"

namespace gphys::GPHYS_ISA {

template <class Value>
struct Vector3 {
    Value x, y, z;
};
template <class Value>
Vector3<Value> operator+(const Vector3<Value>& a, const Vector3<Value>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Value>
Vector3<Value> operator-(const Vector3<Value>& a, const Vector3<Value>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Value>
Vector3<Value> operator*(const Vector3<Value>& a, const Value& s) {
    return {a.x * s, a.y * s, a.z * s};
}
template <class Value>
Value dot(const Vector3<Value>& a, const Vector3<Value>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Value, class Mask>
Vector3<Value> select3(const Mask& mask, const Vector3<Value>& a, const Vector3<Value>& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}
template <int lanes>
Vector3<Doubles<lanes>> load3(const double (&from)[3][lanes]) {
    return {load(from[0]), load(from[1]), load(from[2])};
}
template <int lanes, class Value>
void store3(double (&to)[3][lanes], const Vector3<Value>& v) {
    store(to[0], v.x), store(to[1], v.y), store(to[2], v.z);
}

// rope_layout_kernels.cpp and stages_kernels.cpp, as RopeKernelsOf has them.
template <int lanes>
void put_ropes(RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes], const double (&gravity)[3]);
template <int lanes>
void take_ropes(const RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes],
                const bool (&wanted)[lanes]);
template <int lanes>
void find_agility(const RopeNode<lanes>* nodes, uint32_t count, double (&agility)[lanes]);

}  // namespace gphys::GPHYS_ISA
