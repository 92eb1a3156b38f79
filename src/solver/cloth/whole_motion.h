// Conservation of the momentum of cloth.
#pragma once

#include "solver/cloth/whole_motion_kernels.h"

namespace gphys {

struct ClothContacts;
struct ClothState;

/// Call at the end of a substep of h seconds, for cloth on which only forces and contacts have acted. Sets its momentum
/// and angular momentum to those that follow from the initial ones and these forces. `closed`: no energy comes from
/// outside; then the energy that the cloth has gained is taken from its motion relative to the rigid one. `stored`: the
/// gain in elastic links, per average mass.
void keep_momentum(ClothState& state, const ClothContacts& contacts, bool closed, double damping, double h,
                   double stored);

/// Call at the end of a substep of h seconds: what should be left, in N s, after forces, drag and contacts.impulse,
/// less what there is.
Momentum missing_momentum(ClothState& state, const ClothContacts& contacts, double damping, double h);

}  // namespace gphys
