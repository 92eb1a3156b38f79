// The particles of cloth during a step, in the layout of cloth_kernels.h: four floats for each particle, and for a few
// more that do not move.
//
// The state is float32, relative to the middle of the body at the start of the step, with separate displacements and
// velocities. So positions of a sheet of two metres have a rounding error of 6e-8 m, wherever it is.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/cloth/cloth_kernels.h"
#include "solver/cloth/cloth_shares.h"

namespace gphys {

struct Particles;

struct ClothState {
    explicit ClothState(std::pmr::memory_resource* memory)
        : held(memory),
          at(memory),
          start(memory),
          moved(memory),
          velocity(memory),
          velocity_before(memory),
          acceleration(memory) {}

    Vec3 origin;              // of the positions
    double average_mass = 1;  // of the particles
    uint32_t particles = 0;   // number of the body's particles
    Vector<uint32_t> held;    // those that do not move freely: pins, attached particles, those that targets carry
    Vector<float> at, start, moved, velocity, velocity_before, acceleration;  // see ClothMotion
};

/// Mass and momentum.
struct Motion {
    double mass = 0;
    Vec3 momentum;

    void add(double mass_, Vec3 velocity) { mass += mass_, momentum += velocity * mass_; }
    void add(const Motion& other) { mass += other.mass, momentum += other.momentum; }
};

/// The length of each array, for so many particles and some more that do not move.
size_t cloth_floats(uint32_t particles, uint32_t spare);
/// Allocates the arrays, except those that a snapshot holds: `moved` and `velocity_before`. Throws std::bad_alloc.
void reserve_state(ClothState& state, size_t floats);

/// At the beginning of a step: bounds and mass of the particles, and the state of these particles.
ClothExtent extent_of(const Particles& particles, ClothShares& shares);
void load_state(ClothState& state, const Particles& particles, uint32_t spare, Vec3 gravity, Team* team);
/// At its end: positions and velocities of the particles.
void publish_state(const ClothState& state, Particles& particles, ClothShares& shares);

/// Between substeps: the motion of all particles; their energy relative to a drift, in joules; scaling of the
/// velocities relative to a drift.
Motion motion_of_cloth(const ClothState& state);
double inner_energy_of_cloth(ClothState& state, ClothShares& shares, Vec3 drift);
void slow_cloth(ClothState& state, Team* team, Vec3 drift, double kept);
/// Gives all particles the velocities before a substep of h seconds, and what forces have added: its displacements
/// were no motion (rope/rope_start.h).
void keep_velocities(ClothState& state, double h);

/// Some particles of the state as the kernels take them.
inline ClothMotion part_of(ClothState& state, uint32_t first, uint32_t most_floats) {
    return {std::min(most_floats, static_cast<uint32_t>(state.at.size()) - first),
            state.at.data() + first,
            state.start.data() + first,
            state.moved.data() + first,
            state.velocity.data() + first,
            state.velocity_before.data() + first,
            state.acceleration.data() + first};
}

/// Calls part(motion of some of the particles, index of their first float).
template <class Part>
void share_motion(ClothState& state, Team* team, Part&& part) {
    const uint32_t floats = static_cast<uint32_t>(state.at.size());
    share(team, (floats + share_floats - 1) / share_floats,
          [&](uint32_t i, uint32_t) { part(part_of(state, i * share_floats, share_floats), i * share_floats); });
}

/// The sum over blocks of particles of kernel(motion).
template <class Kernel>
double sum_of_blocks(ClothState& state, ClothShares& shares, Kernel&& kernel) {
    share_motion(state, shares.team, [&](const ClothMotion& share, uint32_t first) {
        for (uint32_t i = 0; i < share.floats; i += block_floats) {
            const ClothMotion block = part_of(state, first + i, std::min(block_floats, share.floats - i));
            shares.block_sums[(first + i) / block_floats] = kernel(block);
        }
    });
    double sum = 0;
    for (const double of_block : shares.block_sums) sum += of_block;
    return sum;
}

}  // namespace gphys
