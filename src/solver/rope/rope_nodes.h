// Common parts of the rope kernels.
#pragma once

#include "foundation/simd_double.h"
#include "foundation/vec.h"
#include "solver/rope/rope_kernels.h"

namespace gphys::GPHYS_ISA {

template <int lanes>
Vec<Doubles<lanes>> load3(const double (&from)[3][lanes]) {
    return {load(from[0]), load(from[1]), load(from[2])};
}
template <int lanes, class Value>
void store3(double (&to)[3][lanes], const Vec<Value>& v) {
    store(to[0], v.x), store(to[1], v.y), store(to[2], v.z);
}

// Defined in rope_layout_kernels.cpp and stages_kernels.cpp; documented in RopeKernelsOf.
template <int lanes>
void gather_ropes(RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes], const double (&gravity)[3]);
template <int lanes>
void scatter_ropes(const RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes],
                   const bool (&wanted)[lanes]);
template <int lanes>
void find_largest_frequency(const RopeNode<lanes>* nodes, uint32_t count, double (&frequency_squared)[lanes]);

}  // namespace gphys::GPHYS_ISA
