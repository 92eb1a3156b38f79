// What the list of pairs of particles and their contacts share.
#pragma once

#include <cstdint>

namespace gphys {

// Pairs that overlap by more than this at the beginning of a substep, in sums of their radii, overlap deeply: they were
// placed so, because impacts do not penetrate so far.
constexpr double deep = 0.5;
// Pairs beyond the capacity are dropped, those of the particles with the highest indices first. n particles at one
// place have n^2 / 2 pairs. So if the capacity is exceeded and more than one in this many listed pairs overlaps deeply,
// each particle takes at most a fixed number of pairs, from a fixed number of particles in each cell around it. Then
// the cost is O(n), and the particles are separated over several substeps.
constexpr uint32_t one_deep_of = 8;

/// A hash of another number and those before.
inline uint64_t mixed(uint64_t key, int64_t next) {
    key = (key ^ static_cast<uint64_t>(next)) * 0x9e3779b97f4a7c15;  // 2^64 / golden ratio
    return key ^ key >> 32;
}

}  // namespace gphys
