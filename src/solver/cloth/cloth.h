// Cloth and other graphs of constraints: the parts of their state, each with its own header, and a substep.
#pragma once

#include "solver/cloth/chain_contacts.h"
#include "solver/cloth/cloth_batches.h"
#include "solver/cloth/cloth_contacts.h"
#include "solver/cloth/cloth_energy.h"
#include "solver/cloth/cloth_shares.h"
#include "solver/cloth/cloth_sheet.h"
#include "solver/cloth/cloth_state.h"
#include "solver/cloth/clusters.h"
#include "solver/cloth/contact_cache.h"
#include "solver/cloth/contact_loads.h"
#include "solver/cloth/reach_limits.h"
#include "solver/cloth/relax_links.h"
#include "solver/cloth/rigid_links.h"
#include "solver/cloth/settling.h"
#include "solver/cloth/taut_spans.h"
#include "solver/cloth/volume.h"
#include "solver/cloth/yielding_chords.h"
#include "solver/contact/moving_colliders.h"
#include "solver/joints/tether_inertia.h"

namespace gphys {

struct Body;
struct CollisionContext;

struct Cloth {
    explicit Cloth(std::pmr::memory_resource* source) : memory(source) {}

    std::pmr::memory_resource* memory;
    // What follows from the constraints and pins:
    ClothSheet sheet{memory};
    RigidLinks rigid{memory};  // of the plan, whatever is pinned
    ReachLimits reach{memory};
    ClothBatches batches{memory};
    TautSpans taut{memory};
    // Of the step under way:
    ClothState state{memory};
    ClothShares shares{memory};
    ClothBalance balance;
    bool misplaced = false;  // the next substep is the first one, and links have wrong lengths
    TetherInertia tethers{memory};
    ContactLoads loads{memory};
    ChainContacts in_chains{memory};
    Relaxation relaxation{memory};
    YieldingChords yielding;
    Volume volume{memory};
    Clusters clusters{memory};
    ClothContacts contacts{memory};
    Vector<MovingCollider> moving_colliders{memory};
    ContactCache cache{memory};
    Settling settling;
};

/// Allocates what a step needs of cloth; with `collides` also for contacts. Throws std::bad_alloc.
void reserve_cloth(Body& body, bool collides);
/// Call at the beginning and at the end of a step.
void begin_cloth(Body& body, const CollisionContext& around, Vec3 gravity);
void end_cloth(Body& body, const CollisionContext& around);

void move_cloth(Body& body, const CollisionContext& around, Vec3 gravity, double h);
/// The parts of move_cloth, for cloth that is joined to other bodies: prediction, chains, and what follows from them.
void predict_cloth(Body& body, const CollisionContext& around, double h);
void solve_cloth(Body& body);
/// How often the links of cloth without loads are swept: bodies with hubs there and back (hubs.cpp).
int least_sweeps_of(const Body& body);
/// The parts of solve_cloth. Sweeps over the links: from number `first` of the substep to before `end`.
void begin_links(Body& body);
void sweep_links(Body& body, int first, int end);
void end_links(Body& body);
void finish_cloth(Body& body, const CollisionContext& around, Vec3 gravity, double h);
/// All after the prediction.
void end_cloth_substep(Body& body, const CollisionContext& around, Vec3 gravity, double h);

}  // namespace gphys
