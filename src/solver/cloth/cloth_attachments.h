// Particles of cloth that are attached to models: where they go, and the impulses that their models get.
#pragma once

#include "foundation/memory.h"
#include "solver/cloth/chain_contacts.h"
#include "solver/cloth/cloth_batches.h"
#include "solver/cloth/cloth_state.h"

namespace gphys {

struct Body;
struct ClothContacts;
struct CollisionContext;
struct Constraints;
struct ModelImpulse;
struct Momentum;
struct TimeScheme;

/// Call before the chains: moves attached particles with their models, and clears the pulls on them and on pins.
void follow_models(const Constraints& constraints, const CollisionContext& around, ClothState& state,
                   ChainContacts& contacts);
/// Call after the chains and limits: adds their pulls on attached particles, the force of a whole substep of h seconds,
/// and to `contacts` these and those on pins.
void add_pull_impulses(const Constraints& constraints, const CollisionContext& around, const ClothState& state,
                       const ChainContacts& in_chains, ClothContacts& contacts, Vector<ModelImpulse>& impulses,
                       double step, double h);
/// Call at the end of a substep. Links within the body cannot change its momentum: what is missing has gone to pins and
/// models, by the relaxation of links, by limits of the energy, or while it settles. It is spread over attached
/// particles and pins, or over those in contact if there are none, as a rigid body that is held there would press them.
void add_missing_impulses(const Body& body, const CollisionContext& around, const Momentum& missing,
                          Vector<ModelImpulse>& impulses);

/// Call at the end of a step, after publish_state: particles that have reached their places on the models are there
/// exactly. Rounded to float32 they would seem to move in the next step, and do work.
void place_attached(const Constraints& constraints, const ClothState& state, Vector<Vec3>& positions);

/// The inelastic impacts of limits that have become taut. Call after add_pull_impulses, which has counted their pulls.
class TautLimits {
public:
    TautLimits(const Constraints& constraints, const CollisionContext& around, ChainContacts& in_chains,
               ClothContacts& contacts, Vector<ModelImpulse>& impulses, const TimeScheme& scheme, double damping);

    /// Makes the ends of limits that have become taut stop separating. Returns whether there were any; then the time
    /// scheme restarts. Adds their impulses, in N s, to `loads`, by link, unless that is empty.
    bool apply_impacts(const Vector<LimitInCloth>& limits, ClothState& state, Vector<double>& loads);

private:
    void add_to_model(const ClothState& state, uint32_t particle, Vec3 impulse);

    const Constraints& constraints_;
    const CollisionContext& around_;
    ChainContacts& in_chains_;
    ClothContacts& contacts_;
    Vector<ModelImpulse>& impulses_;
    const double counted_;
};

}  // namespace gphys
