// Particles of cloth that are attached to models: where they go, and the impulses that their models get.
#pragma once

#include "foundation/memory.h"
#include "solver/cloth/chain_contacts.h"
#include "solver/cloth/cloth_batches.h"
#include "solver/cloth/cloth_state.h"

namespace gphys {

struct CollisionContext;
struct Constraints;
struct ModelImpulse;
struct TimeScheme;

/// Call before the chains: moves attached particles with their models, and clears the pulls on them.
void follow_models(const Constraints& constraints, const CollisionContext& around, ClothState& state,
                   ChainContacts& contacts);
/// Call after the chains and limits: adds their pulls on attached particles, the force of a whole substep of h seconds.
void add_pull_impulses(const Constraints& constraints, const CollisionContext& around, const ClothState& state,
                       const ChainContacts& contacts, Vector<ModelImpulse>& impulses, double step, double h);

/// The inelastic impacts of limits that have become taut. Call after add_pull_impulses, which has counted their pulls.
class TautLimits {
public:
    TautLimits(const Constraints& constraints, const CollisionContext& around, ChainContacts& contacts,
               Vector<ModelImpulse>& impulses, const TimeScheme& scheme, double damping);

    /// Makes the ends of limits that have become taut stop separating. Returns whether there were any; then the time
    /// scheme restarts. Adds their impulses, in N s, to `loads`, by link, unless that is empty.
    bool apply_impacts(const Vector<LimitInCloth>& limits, ClothState& state, Vector<double>& loads);

private:
    void add_to_model(const ClothState& state, uint32_t particle, Vec3 impulse);

    const Constraints& constraints_;
    const CollisionContext& around_;
    ChainContacts& contacts_;
    Vector<ModelImpulse>& impulses_;
    const double counted_;
};

}  // namespace gphys
