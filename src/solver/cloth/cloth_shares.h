// How the work on one cloth is divided, and what each share of it has found (fork-join).
//
// Shares have a fixed size and their results are added in a fixed order. So sums do not depend on the number of
// workers.
#pragma once

#include <algorithm>

#include "foundation/math.h"
#include "foundation/memory.h"
#include "foundation/team.h"
#include "shapes/shapes.h"

namespace gphys {

/// Units of work of a team's members, in floats: 1000 particles, a few microseconds. A block is the unit of summation
/// in the kernels.
constexpr uint32_t share_floats = 4096, share_limits = 1024, block_floats = 256;

/// Bounds and mass of some particles.
struct ClothExtent {
    Aabb box;
    double mass;
};

/// How far particles moved in a step: squared distances, and the sum of all displacements.
struct ClothTravel {
    double sum = 0, longest = 0;
    Vec3 together;

    void add(Vec3 way) {
        const double square = length_squared(way);
        sum += square, longest = std::max(longest, square), together += way;
    }
    void add(const ClothTravel& other) {
        sum += other.sum, longest = std::max(longest, other.longest), together += other.together;
    }
};

/// Whether workers take less time together than one of them alone: what they have to transfer between their caches
/// takes 50 ns on some machines and 300 on others, and on virtual ones that changes from minute to minute. So both are
/// measured from time to time, by turns, because what a step takes changes as well. The choice changes no result.
class SharingTrial {
public:
    /// What the next step shall do.
    bool is_shared() const { return place() < steps_of_trial ? place() % 2 == 0 : pays_; }
    /// What a substep took, in seconds.
    void add(bool shared, double seconds) {
        if (place() < steps_of_trial) taken_[shared ? 1 : 0] += seconds;
        if (++steps_ % period == steps_of_trial) {
            pays_ = taken_[1] <= taken_[0];
            taken_[0] = taken_[1] = 0;
        }
    }

private:
    static constexpr uint32_t period = 64, steps_of_trial = 4;

    uint32_t place() const { return steps_ % period; }

    double taken_[2] = {0, 0};     // alone, and shared, in the trial under way
    uint32_t steps_ = period - 1;  // the first step is in no trial, because it touches new memory
    bool pays_ = true;
};

struct ClothShares {
    explicit ClothShares(std::pmr::memory_resource* memory)
        : block_sums(memory), batch_sums(memory), extents(memory), travels(memory) {}

    Team* team = nullptr;         // shares the work of the step under way; null: nobody
    bool on_trial = false;        // whether a team could share it
    SharingTrial trial;           // then
    Vector<double> block_sums;    // of energy, by block of particles
    Vector<double> batch_sums;    // of energy, by batch of chains
    Vector<ClothExtent> extents;  // by share of particles
    Vector<ClothTravel> travels;  // the same, for the last step

    /// `floats`: the length of the arrays of the state. Throws std::bad_alloc.
    void reserve(uint32_t particles, size_t floats, size_t batches) {
        block_sums.resize((floats + block_floats - 1) / block_floats);
        batch_sums.resize(batches);
        extents.resize((4 * size_t{particles} + share_floats - 1) / share_floats);
        travels.resize(extents.size());
    }
};

inline ClothTravel total_travel(const ClothShares& shares) {
    ClothTravel all;
    for (const ClothTravel& part : shares.travels) all.add(part);
    return all;
}

/// Calls part(its index, first particle, end) in any order.
template <class Part>
void share_particles(Team* team, uint32_t particles, Part&& part) {
    constexpr uint32_t together = share_floats / 4;
    share(team, (particles + together - 1) / together,
          [&](uint32_t i, uint32_t) { part(i, i * together, std::min(particles, (i + 1) * together)); });
}

}  // namespace gphys
