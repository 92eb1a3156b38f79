// The first substep of a rope that was placed with links of wrong lengths.
//
// A rigid link has its length at the end of a substep. One that is wrong when a rope is added, or when the caller has
// moved its particles, is corrected in the first substep. Velocities derived from that displacement would be of
// hundreds of metres per second, but it is no motion: no rigid link has stored energy that it could give. So in that
// substep the links move the particles, and their velocities are those of free fall.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;

// Of a link's length. Rounded to float32, links of a centimetre have as much a hundred metres from the origin.
constexpr double least_misplacement = 1e-3;

/// Whether the next substep is the first one after an interruption that was no contact, and rigid links have wrong
/// lengths. Not of bodies with links that store energy.
bool starts_misplaced(const Body& body);
/// Call at the end of the substep of h seconds. The next one is a first one, too, and the links bring the velocities
/// into line with each other in it.
void keep_velocities(Body& body, Vec3 gravity, double h);

}  // namespace gphys
