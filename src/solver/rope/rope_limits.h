// Links of ropes that only pull.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;
struct CollisionContext;
struct TimeScheme;

/// predict_flying: call after the prediction; capture: after the new velocities. capture returns whether a link has
/// become taut.
void predict_flying(Body& body, Vec3 gravity, double h);
bool capture(Body& body, const CollisionContext& around, const TimeScheme& scheme);

}  // namespace gphys
