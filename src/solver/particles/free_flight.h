// Bodies without constraints: exact flight and impacts.
#pragma once

#include "solver/contact/impulses.h"
#include "solver/particles/particles.h"

namespace gphys {

struct Body;
struct CollisionContext;
class FlightPlanes;
class Team;

/// Moves and collides a body without constraints in one substep, between which others may push its particles. `planes`
/// are those of the members of the team, or of the caller if team is null; null to sweep every path. A team shares the
/// work if the body has parts.
void fly(Body& body, const CollisionContext& around, Vec3 gravity, double h, FlightPlanes* planes, Team* team);
/// The same for some particles and all substeps of a step. Impulses and contacts go to the accumulator. Several threads
/// may work on one body, each on its own particles.
/// Returns the extent of the particles.
Extent fly_through(Body& body, uint32_t first, uint32_t end, const ImpulseAccumulator& accumulator,
                   const CollisionContext& step, Vec3 gravity, uint32_t substeps, FlightPlanes* planes);
/// The extent of some particles.
Extent extent_of(Body& body, uint32_t first, uint32_t end);

}  // namespace gphys
