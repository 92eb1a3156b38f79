// The inner loops of the search for straight lines of links (plan_colours.cpp), eight links side by side.
#pragma once

#include <cstddef>
#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

/// Links at one particle. There must be room for a multiple of eight.
struct LinksAround {
    const double *x, *y, *z;          // unit vectors from the particle
    const double *rest, *compliance;  // of the links
    uint32_t count;
};

/// Two links with a common particle that may continue each other.
struct StraightPair {
    double cosine;           // of the angle between them: -1 is straight on
    uint32_t first, second;  // ascending

    /// The straightest first.
    bool operator<(const StraightPair& other) const {
        if (cosine != other.cosine) return cosine < other.cosine;
        return first != other.first ? first < other.first : second < other.second;
    }
};

struct StraightKernels {
    /// Makes unit vectors of `count` vectors, a multiple of eight. Zero vectors stay.
    void (*normalize)(double* x, double* y, double* z, size_t count);
    /// Lists the pairs of links `begin` <= first < `end` with a second one behind it that continues it, and returns how
    /// many. There must be room for (end - begin) * (count - 1 - begin) pairs.
    uint32_t (*list_pairs)(const LinksAround& around, uint32_t begin, uint32_t end, StraightPair* pairs);
};

GPHYS_DECLARE_KERNELS(StraightKernels, straight_kernels)

}  // namespace gphys
