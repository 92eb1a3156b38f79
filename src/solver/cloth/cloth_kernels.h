// The inner loops of cloth, for eight chains or particles at a time. Positions are float32, relative to a point near
// the body. A particle is x, y, z and its inverse mass, relative to the body's average.
#pragma once

#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

/// Up to eight chains side by side. Missing links of shorter chains have an enormous softness.
struct ChainBatch {
    uint32_t first_particle, first_link;  // in the arrays below, in units of eight
    uint32_t link_count;
    uint32_t limit = 0;     // 1: single links that can only pull
    uint32_t attached = 0;  // 1: some particle is held, of a body that is attached to models
    uint32_t elastic = 0;   // 1: some link stores energy
    uint32_t kept = 0;      // which kinds of its links are in KeptLinks
    static constexpr uint32_t threads = 1, braces = 2, chords = 4;
};

struct ClothChains {
    const uint32_t* particles;  // by place in the batch and chain
    const float* rest;          // metres, by link and chain
    const float* softness;      // compliance / step^2 * average mass
    const float* stiffness;     // 1 / (compliance * average mass); 0: stores no energy
};

/// Limits: eight particles at most this far from eight anchors.
struct ClothLimits {
    const uint32_t *particles, *anchors;
    const float* distances;
};

/// The coefficients of one substep, from TimeScheme.
struct ClothStep {
    float h, h_before, ratio;  // h_before / h; both 0 if there was no substep before
    float next, earlier;
    float damping, drag;
};

/// Arrays of four floats for each particle. The fourth is the inverse mass in positions, the mass in accelerations,
/// both relative to the averages, and else 0.
struct ClothMotion {
    uint32_t floats;            // four times the number of particles, padded to a multiple of eight
    float* at;                  // metres
    float* start;               // position at the start of the substep
    float* moved;               // displacement in the previous substep
    float* velocity;            // m/s
    float* velocity_before;     // one substep earlier; `finish` writes the new velocities here
    const float* acceleration;  // by gravity and forces, and mass; 0 for particles that do not move freely
};

/// Arrays of four floats for each particle; the fourth of pulls is unused.
struct ClothSurfaces {
    const float* normals;  // unit normal of the contact plane and the normal force, in units of pulls; 0: none
    float* pulls;          // sums of the pulls of links: metres that they would move an average particle
};

/// The same with joined bodies: inverse masses are relative * (diagonal, off), where diagonal holds xx, yy, zz and off
/// holds yz, zx, xy of a symmetric matrix.
struct ClothTethers {
    const float *diagonal, *off;
    ClothSurfaces surfaces;  // pulls of all particles are added up
    bool has_contact;        // whether any particle is in contact
};

struct ClothKernels {
    void (*predict)(const ClothMotion& motion, const ClothStep& step);
    /// `rows` must have room for 6 vectors per link.
    void (*solve)(float* at, const ClothChains& chains, const ChainBatch& batch, float* rows);
    /// The same if particles in contact may move along the plane or off it, but not into it. A particle moves off by
    /// the excess of the pulls of all chains, since `pulls` was 0, over the normal force.
    void (*solve_with_contacts)(float* at, const ClothSurfaces& surfaces, const ClothChains& chains,
                                const ChainBatch& batch, float* rows);
    /// As `solve`, adding up the pulls as `solve_with_contacts` does.
    void (*solve_pulling)(float* at, float* pulls, const ClothChains& chains, const ChainBatch& batch, float* rows);
    void (*solve_joined)(float* at, const ClothTethers& tethers, const ClothChains& chains, const ChainBatch& batch,
                         float* rows);
    /// Replaces the rows that one of these left in `rows` by the tensions of the links, in units of pulls: the first
    /// eight floats of the row of link j are those of its eight chains.
    void (*find_tensions)(float* rows, uint32_t link_count);
    /// Writes the indices in chains.rest of rigid links that are too long or, unless they only pull, too short by at
    /// least this fraction of their length. Returns how many.
    uint32_t (*list_strained)(const float* at, const ClothChains& chains, const ChainBatch& batch, float part,
                              uint32_t* places);
    /// Writes the indices of particles that may leave their balls within h seconds, or that are outside, except those
    /// that are pinned. `balls`: centre and squared radius of each particle. `fall`: the speed that gravity adds
    /// meanwhile. Returns how many.
    uint32_t (*list_leaving)(const float* at, const float* velocity, const float* balls, uint32_t particles, float h,
                             float fall, uint32_t* leaving);
    uint32_t (*list_outside)(const float* at, const float* balls, uint32_t particles, uint32_t* outside);
    /// The energy of elastic links, per average mass.
    double (*stored)(const float* at, const ClothChains& chains, const ChainBatch& batch);
    void (*limit)(float* at, const ClothLimits& limits, uint32_t count);
    /// The same, adding up the pulls on the anchors.
    void (*limit_pulling)(float* at, const ClothLimits& limits, uint32_t count, const float* acceleration,
                          float* pulls);
    /// Returns the kinetic energy gained beyond the work of forces, per average mass.
    double (*finish)(const ClothMotion& motion, const ClothStep& step);
    /// The same for a finished substep: from velocity_before to velocity, and from start to at.
    double (*gain)(const ClothMotion& motion);
    /// The kinetic energy relative to a drift, per average mass; and scaling of the velocities relative to it.
    double (*kinetic)(const ClothMotion& motion, const float (&drift)[3]);
    void (*slow)(const ClothMotion& motion, const float (&drift)[3], float kept);
    /// Keeps parts of the velocities and of the displacements since the start of the substep.
    void (*settle)(const ClothMotion& motion, float kept_speed, float kept_way);
};

constexpr uint32_t cloth_row_floats = 6 * 8;

GPHYS_DECLARE_KERNELS(ClothKernels, cloth_kernels)

}  // namespace gphys
