// The loops of the air's forces on cloth, eight particles or triangles side by side (wind.cpp). In float32, like the
// state of cloth: forces count in units of AirOnCloth::unit, in which none overflows.
#pragma once

#include <cstddef>
#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

/// Arrays of four floats for each particle, as those of ClothMotion.
struct AirOnCloth {
    uint32_t floats;               // four times the number of particles, padded to a multiple of eight
    const float* at;               // metres, and relative inverse mass
    const float* velocity;         // m/s
    const float* velocity_before;  // one substep earlier
    const float* steady;           // accelerations without air, m/s^2, and mass
    float* relative;               // velocities relative to the air, m/s
    float* forces;                 // units, and by how many they grow at most if all velocities grow by 1 m/s
    float* acceleration;

    const uint32_t* triangles;  // three particles each
    size_t triangle_count;

    float wind[8];     // m/s, twice: x, y, z, 0
    bool by_particle;  // `relative` has the velocities of the air before, instead of `wind`
    float before;      // the part of the difference to velocity_before that the time scheme adds to the velocity
    float drag, lift;  // the coefficients, divided by the larger one
    float unit;        // m/s^2 that a unit of force gives to an average particle
    float most_rate;   // 1/s, of the forces on a particle
};

struct WindKernels {
    /// Sets `relative`: the velocities that the time scheme would give without other forces, less those of the air.
    void (*find_relative)(const AirOnCloth& air);
    /// Sets `forces`.
    void (*add_forces)(const AirOnCloth& air);
    /// Sets `acceleration`. Forces are limited to those that would end the motion relative to the air at `most_rate`.
    void (*accelerate)(const AirOnCloth& air);
};

GPHYS_DECLARE_KERNELS(WindKernels, wind_kernels)

}  // namespace gphys
