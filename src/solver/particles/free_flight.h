// Bodies without constraints: exact flight and impacts.
#pragma once

#include "solver/contact/impulses.h"
#include "solver/particles/particles.h"

namespace gphys {

struct Body;
struct CollisionContext;
class FlightPlanes;

/// A body without constraints, moved and collided, in one substep.
void fly(Body& body, const CollisionContext& around, Vec3 gravity, double h);
/// The same in all substeps of a step, of some of its particles: what they touch and give is the tally's. Several
/// may be at work on one body, each on its own particles. `planes` are those of the worker; null: every path is swept.
/// Returns where they are.
Extent fly_through(Body& body, uint32_t first, uint32_t end, const ImpulseAccumulator& accumulator,
                   const CollisionContext& step, Vec3 gravity, uint32_t substeps, FlightPlanes* planes);
/// Of some particles.
Extent extent_of(Body& body, uint32_t first, uint32_t end);

}  // namespace gphys
