// Links of ropes that only pull.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;
struct CollisionContext;
struct TimeScheme;

/// Call after the prediction: particles whose links are all slack fly exactly.
void predict_slack_particles(Body& body, Vec3 gravity, double h);
/// Call after the new velocities: inelastic impacts of links that have become taut. Returns whether there is one.
bool apply_limit_impacts(Body& body, const CollisionContext& around, const TimeScheme& scheme);

}  // namespace gphys
