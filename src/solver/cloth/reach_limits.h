// Long-range attachments: how far particles may be from pinned ones (reach_limits.cpp).
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "foundation/team.h"
#include "solver/cloth/pin_paths.h"

namespace gphys {

struct ClothSheet;
struct ClothState;
struct Particles;
struct RigidLinks;

/// The largest distance of a particle from a pinned one.
struct ReachLimit {
    uint32_t particle, anchor;
    double distance;
};

/// The paths from pins, the limits that follow from them, and these in the layout of the kernels.
struct ReachLimits {
    explicit ReachLimits(std::pmr::memory_resource* source) : memory(source) {}

    std::pmr::memory_resource* memory;
    Vector<PinPath> paths{memory};  // ascending; empty if they are not known
    Vector<ReachLimit> limits{memory};
    Vector<uint32_t> limited{memory}, anchors{memory};  // particles
    Vector<uint32_t> ranks{memory};  // in them: the first of each rank, and the end; a rank has no particle twice
    Vector<float> distances{memory};
    Vector<float> stretched{memory};  // distances of taut cloth (taut_spans.h); empty if no row is between pins
};

/// The plan must be current. Throws std::bad_alloc.
void plan_reach_limits(ReachLimits& reach, const RigidLinks& rigid, const Particles& particles,
                       const ClothSheet& sheet);
void pack_reach_limits(ReachLimits& reach, uint32_t particles);

/// Moves particles that are too far from their anchors. `pulls` adds up the pulls on anchors, see ClothSurfaces.
void apply_reach_limits(const ReachLimits& reach, ClothState& state, Team* team);
void apply_reach_limits(const ReachLimits& reach, ClothState& state, float* pulls);

}  // namespace gphys
