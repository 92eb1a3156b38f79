// The momentum of cloth that nothing but forces and contacts has pushed.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;

/// At the end of a substep of h seconds of cloth that nothing but forces and contacts has pushed, its
/// momentum and angular momentum to what these make of those that it began with. If no energy comes from outside, what
/// it gained, of which `stored` per average mass by elastic links, is taken from motion beside that as a rigid body.
void keep_momentum(Body& body, double h, double stored);

}  // namespace gphys
