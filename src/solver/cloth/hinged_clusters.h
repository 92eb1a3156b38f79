// The energy of clusters that pins hold.
//
// Pins at rest do no work. So a wheel on an axle, a door or a pendulum keeps its energy, less what damping takes. The
// time scheme would take some from fast ones, and the rounding of positions from slow ones, the more the shorter the
// substeps are. Free clusters need no such correction, because cloth keeps its momentum (whole_motion.h).
#pragma once

namespace gphys {

struct Body;

/// Call at the end of a substep of h seconds. Restores the energy of held clusters if only given forces and resting
/// pins have acted on them: no links, contacts, air, or other clusters.
void keep_hinged_energy(Body& body, bool collides, double h);

}  // namespace gphys
