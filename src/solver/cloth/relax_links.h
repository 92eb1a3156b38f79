// Relaxation of links of cloth that chains have left strained.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;

/// Call after a substep of h seconds. Relaxes links that are strained beyond the target. Returns the energy that forces
/// have lost by it, per average mass.
double relax_links(Body& body, bool collides, double h);

}  // namespace gphys
