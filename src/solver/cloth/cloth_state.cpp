// The state of cloth during a step: from the particles of the body, and back; and its motion as a whole
// (cloth_state.h).
#include "solver/cloth/cloth_state.h"
#include "solver/particles/particles.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// Masses are clamped to this ratio to the average: beyond it float32 shows no difference.
constexpr double most_mass_ratio = 1e6;
// Products of accelerations with other factors must not overflow float32.
constexpr double most_acceleration = 1e12;

}  // namespace

size_t cloth_floats(uint32_t particles, uint32_t spare) { return (4 * (size_t{particles} + spare) + 7) / 8 * 8; }

void reserve_state(ClothState& state, size_t floats) {
    for (Vector<float>* values : {&state.at, &state.start, &state.velocity, &state.acceleration}) {
        values->resize(floats);
    }
    state.held.reserve(floats / 4);
}

ClothExtent extent_of(const Particles& particles, ClothShares& shares) {
    Vector<ClothExtent>& parts = shares.extents;
    share_particles(shares.team, particles.size(), [&](uint32_t i, uint32_t first, uint32_t end) {
        ClothExtent extent{{particles.position[first], particles.position[first]}, 0};
        for (uint32_t p = first; p < end; ++p) {
            extent.box = {min(extent.box.min, particles.position[p]), max(extent.box.max, particles.position[p])};
            extent.mass += particles.mass[p];
        }
        parts[i] = extent;
    });
    ClothExtent all = parts[0];
    for (size_t i = 1; i < parts.size(); ++i) {
        all.box = {min(all.box.min, parts[i].box.min), max(all.box.max, parts[i].box.max)};
        all.mass += parts[i].mass;
    }
    return all;
}

void load_state(ClothState& state, const Particles& particles, uint32_t spare, Vec3 gravity, Team* team) {
    state.particles = particles.size();
    state.held.clear();
    for (uint32_t p = 0; p < particles.size(); ++p) {
        if (particles.pinned(p)) state.held.push_back(p);
    }
    share_particles(team, particles.size(), [&](uint32_t, uint32_t first, uint32_t end) {
        for (uint32_t p = first; p < end; ++p) {
            const size_t i = 4 * size_t{p};
            put(&state.at[i], particles.position[p] - state.origin, farthest_in_cloth);
            put(&state.velocity[i], particles.velocity[p], fastest_in_cloth);
            const bool free = !particles.pinned(p);
            const double relative =
                std::clamp(particles.mass[p] / state.average_mass, 1 / most_mass_ratio, most_mass_ratio);
            state.at[i + 3] = free ? static_cast<float>(1 / relative) : 0;
            put(&state.acceleration[i], free ? gravity + particles.force[p] * particles.inverse_mass[p] : Vec3{},
                most_acceleration);
            state.acceleration[i + 3] = free ? static_cast<float>(relative) : 0;
        }
    });
    // Particles that do not move are in pairs a metre apart again, because limits on the first of a pair shift it
    // minimally.
    for (Vector<float>* values : {&state.at, &state.moved, &state.velocity, &state.velocity_before}) {
        std::fill(values->begin() + 4 * static_cast<std::ptrdiff_t>(particles.size()), values->end(), 0.0f);
    }
    for (uint32_t p = 1; p < spare; p += 2) state.at[4 * (size_t{particles.size()} + p)] = 1;
}

void publish_state(const ClothState& state, Particles& particles, ClothShares& shares) {
    share_particles(shares.team, particles.size(), [&](uint32_t i, uint32_t first, uint32_t end) {
        ClothTravel travel;
        for (uint32_t p = first; p < end; ++p) {
            const Vec3 before = particles.position[p];
            particles.position[p] = state.origin + get(&state.at[4 * size_t{p}]);
            particles.velocity[p] = get(&state.velocity[4 * size_t{p}]);
            keep_in_range(particles.position[p], particles.velocity[p], before);
            travel.add(particles.position[p] - before);
        }
        shares.travels[i] = travel;
    });
}

Motion motion_of_cloth(const ClothState& state) {
    Motion sum;
    for (size_t i = 0; i < 4 * size_t{state.particles}; i += 4) {
        sum.add(state.acceleration[i + 3] * state.average_mass, get(&state.velocity[i]));
    }
    return sum;
}

double inner_energy_of_cloth(ClothState& state, ClothShares& shares, Vec3 drift) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    float common[3];
    put(common, drift, fastest_in_cloth);
    return state.average_mass *
           sum_of_blocks(state, shares, [&](const ClothMotion& block) { return kernels.kinetic(block, common); });
}

void slow_cloth(ClothState& state, Team* team, Vec3 drift, double kept) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    float common[3];
    put(common, drift, fastest_in_cloth);
    share_motion(state, team,
                 [&](const ClothMotion& motion, uint32_t) { kernels.slow(motion, common, static_cast<float>(kept)); });
}

void keep_velocities(ClothState& state, double h) {
    for (size_t i = 0; i < 4 * size_t{state.particles}; i += 4) {
        if (state.at[i + 3] == 0) continue;
        put(&state.velocity[i], get(&state.velocity_before[i]) + get(&state.acceleration[i]) * h);
    }
}

}  // namespace gphys
