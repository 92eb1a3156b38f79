// The inner loops of cloth, eight chains or particles at a time. Positions are float32, relative to
// a point near the body; a particle is x, y, z and its inverse mass, relative to the body's average.
#pragma once

#include <cstddef>
#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

/// Up to eight chains side by side. Links that a shorter chain lacks are soft beyond all measure.
struct ChainBatch {
    uint32_t first_particle, first_link;  // in the arrays below, in units of eight
    uint32_t link_count;
    uint32_t limit = 0;     // 1: a single link each, which pulls and never pushes
    uint32_t attached = 0;  // 1: a particle is attached to a model
    uint32_t kept = 0;      // of which kinds links are among the KeptLinks
    static constexpr uint32_t threads = 1, braces = 2;
};

struct ClothChains {
    const uint32_t* particles;  // by place in the batch and chain
    const float* rest;          // metres, by link and chain
    const float* softness;      // compliance / step^2 * average mass
    const float* stiffness;     // 1 / (compliance * average mass); 0: holds no energy
};

/// Eight particles at most this far from eight anchors.
struct ClothLimits {
    const uint32_t *particles, *anchors;
    const float* distances;
};

/// Of one substep: what TimeScheme consists of.
struct ClothStep {
    float h, h_before, ratio;  // h_before / h; both 0 if there was no substep before
    float next, earlier;
    float damping, drag;
};

/// Quantities of all particles, four floats each; the fourth is the inverse mass in positions, the mass in
/// accelerations, relative to the averages, and else 0.
struct ClothMotion {
    uint32_t floats;            // four times the particles, padded to a multiple of eight
    float* at;                  // metres
    float* start;               // of the substep
    float* moved;               // in the substep before
    float* velocity;            // m/s
    float* velocity_before;     // a substep before; where `finish` leaves the new velocities
    const float* acceleration;  // of gravity and forces, and mass; 0 of those that do not move freely
};

/// Of all particles, four floats each; the fourth of pulls is unused.
struct ClothSurfaces {
    const float* normals;  // unit, of what the particle touches, and what presses it there, as pulls; 0 if nothing
    float* pulls;          // of the links: what they add would move an average particle, in metres
};

/// The same with what is joined to the particles: inverse masses are relative * (diagonal, off), where
/// diagonal holds xx, yy, zz and off holds yz, zx, xy of a symmetric matrix.
struct ClothTethers {
    const float *diagonal, *off;
    ClothSurfaces surfaces;  // pulls of all particles are added up
    bool has_contact;        // whether any does
};

struct ClothKernels {
    void (*predict)(const ClothMotion& motion, const ClothStep& step);
    /// Room for 6 vectors a link in `rows`.
    void (*solve)(float* at, const ClothChains& chains, const ChainBatch& batch, float* rows);
    /// The same while particles that touch something move along it or off, and not into it. They are off by what all
    /// chains since `pulls` was 0 pull them off with beyond what presses.
    void (*solve_with_contacts)(float* at, const ClothSurfaces& surfaces, const ClothChains& chains,
                                const ChainBatch& batch, float* rows);
    /// As `solve`, with the pulls as `solve_with_contacts` adds them up.
    void (*solve_pulling)(float* at, float* pulls, const ClothChains& chains, const ChainBatch& batch, float* rows);
    void (*solve_joined)(float* at, const ClothTethers& tethers, const ClothChains& chains, const ChainBatch& batch,
                         float* rows);
    /// Places, in chains.rest, of rigid links longer or, unless they only pull, shorter than they should be by this
    /// part of their length or more. Returns how many.
    uint32_t (*list_strained)(const float* at, const ClothChains& chains, const ChainBatch& batch, float part,
                              uint32_t* places);
    /// What elastic links hold, per average mass.
    double (*stored)(const float* at, const ClothChains& chains, const ChainBatch& batch);
    void (*limit)(float* at, const ClothLimits& limits, uint32_t count);
    /// The same with the pulls on the anchors.
    void (*limit_pulling)(float* at, const ClothLimits& limits, uint32_t count, const float* acceleration,
                          float* pulls);
    /// Returns the kinetic energy gained beyond what forces gave, per average mass.
    double (*finish)(const ClothMotion& motion, const ClothStep& step);
    /// The same of a substep that has ended: from velocity_before to velocity, and from start to at.
    double (*gain)(const ClothMotion& motion);
    /// Kinetic energy, per average mass, beside a motion of all, and this part of velocities kept beside it.
    double (*kinetic)(const ClothMotion& motion, const float (&drift)[3]);
    void (*slow)(const ClothMotion& motion, const float (&drift)[3], float kept);
};

constexpr uint32_t cloth_row_floats = 6 * 8;

GPHYS_DECLARE_KERNELS(ClothKernels, cloth_kernels)

}  // namespace gphys
