// Conservation of the momentum of cloth on which only forces and contacts act.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct ClothContacts;
struct ClothState;

/// Call at the end of a substep of h seconds, for cloth on which only forces and contacts have acted. Sets its momentum
/// and angular momentum to those that follow from the initial ones and these forces. If no energy comes from outside,
/// the energy that it has gained, including `stored` per average mass in elastic links, is taken from the motion
/// relative to the rigid one. `closed`: whether none does.
void keep_momentum(ClothState& state, const ClothContacts& contacts, bool closed, double damping, double h,
                   double stored);

}  // namespace gphys
