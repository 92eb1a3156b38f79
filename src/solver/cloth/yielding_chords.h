// Collapsed cloth, such as a curtain that was pulled in its middle beyond its reach and then let go.
//
// A chord is a rigid link that two shorter links span as well: a diagonal of a cell, or a link against bending. Where
// cells are turned inside out, or crumpled, chords push the wrong way, and hold the sheet in that state and above its
// pins for good. Without chords, or with springs in their place, cloth always unfolds. So when a chord of a body
// has been much too short for a while, all its chords are springs, as in woven cloth, until none is short any more.
//
// Sweeps over such cells leave large errors. While the body is in this state these do not become motion: the time
// scheme starts anew in each substep, and energy beyond the work of forces is taken from the particles that gained it.
// If all were slowed instead, a few tangled cells would hold up a sheet that falls.
//
// Cloth in its ordinary states is not in this one, nor is cloth that bears loads much heavier than itself
// (contact_loads.h). These unfold it, and its diagonals carry a part of them: if they were springs, the sack in which a
// ball is lifted would hang down to twice its depth.
#pragma once

namespace gphys {

struct Cloth;

struct YieldingChords {
    static constexpr double loaded = -1;

    bool any = false;  // in the last substep: then all of them yield. In snapshots
    // Seconds for which some have been much too short; `loaded` if the cloth bore loads in the last substep. In
    // snapshots
    double collapsed_time = 0;
    bool current = false;         // whether this step has tested the cloth
    bool end_under_load = false;  // whether they are rigid again in this substep because a load has come
};

/// Tests the cloth at the beginning of a step, and in each substep while chords yield. Call in each substep after
/// soften_links. `near`: whether models may be in contact. In joined cloth none yield: those beside its joints carry
/// it.
void find_yielding_chords(Cloth& cloth, bool joined, bool near, double step_time);

}  // namespace gphys
