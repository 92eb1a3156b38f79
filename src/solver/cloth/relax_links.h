// Links of cloth that chains have left strained.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;

/// After a substep of h seconds, links that it has left strained beyond the target. Returns the energy
/// that forces have lost by it, per average mass.
double relax_links(Body& body, bool collides, double h);

}  // namespace gphys
