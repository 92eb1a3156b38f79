// The first substep of a rope that was placed with links of wrong lengths.
//
// A rigid link has its length at the end of a substep. One that is wrong when a rope is added, or when the caller has
// moved its particles, is corrected in the first substep, and velocities derived from that displacement would be of
// hundreds of metres per second: a rope of 60 links, added with links a tenth longer than its points are apart, flew
// off at 800 m/s. But no rigid link has stored energy that it could give. So in that substep the links may move the
// rope as far as its lengths need, and it has no more energy afterwards than before.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;

/// Whether the next substep is the first one after an interruption that was no contact, and rigid links have wrong
/// lengths. Not of bodies with links that store energy.
bool starts_misplaced(const Body& body);
/// Call at the end of the substep: slows the body, relative to its centre of mass unless pins hold it. The next substep
/// is a first one, too, since the displacement is no motion.
void bound_starting_energy(Body& body, Vec3 gravity);

}  // namespace gphys
