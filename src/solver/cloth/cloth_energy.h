// The energy balance of a substep of cloth.
//
// In long steps the errors that sweeps over a graph leave can do work. Energy that the body has gained beyond the work
// of forces is taken from the motion within it.
#pragma once

#include "solver/cloth/cloth_state.h"

namespace gphys {

struct Body;
struct Cloth;

struct ClothBalance {
    bool closed = false;   // no energy comes from outside
    double gain = 0;       // joules gained beyond the work of forces
    double lost = 0;       // joules lost together with joined bodies; the first cloth of a system holds this for all
    double stored = 0;     // in elastic links and by the volume, per average mass
    bool current = false;  // whether `stored` is valid: nothing has moved since
};

/// The energy of elastic links and of the compressed volume, per average mass.
double stored_energy(Cloth& cloth);
/// Whether all external forces in this substep are known: none, or those of models in contact with a closed body. An
/// open body on models may rotate as a whole by the errors that its sweeps leave.
bool is_accounted_for(const Body& body, bool collides);
/// A solid holds cloth in it while the links get their lengths back. That must not make the cloth faster on average
/// than its speed of leaving. `gain`: joules beyond the work of forces in the substep.
void limit_energy_in_solid(ClothState& state, ClothShares& shares, double gain);
/// Slows the relative motion within the body so that the substep gains no energy; the motion of a free body as a whole
/// stays.
void remove_energy(ClothState& state, ClothShares& shares, double gain);
/// The same, from the particles that gained it, each in proportion to its gain.
void remove_own_gains(ClothState& state, double gain);

}  // namespace gphys
