// Impulses on models: the opposite of the momentum that a contact or an attachment gives to particles. Each body has
// its own sums by model, so that workers share nothing. After the step the solver adds those of all bodies in a fixed
// order.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"

namespace gphys {

struct Body;
struct CollisionContext;

/// Sums over a step.
struct ModelImpulse {
    gphys_model_id model;
    uint32_t tag;  // the model's
    Vec3 linear;   // N s
    Vec3 angular;  // N m s, about the model's position
};

/// Room for models that were not near at the beginning of a step. A particle can hit one only if it became many times
/// faster during the step. Impulses on more models are not reported.
constexpr uint32_t spare_impulses = 64;

/// The output of contacts besides the motion of particles: sums by model, and whether there were any. For a body, or
/// for the part of it that one of several workers moves.
struct ImpulseAccumulator {
    Vector<ModelImpulse>& impulses;
    bool& has_contact;
};

/// Allocates memory, also for the parts of a body. Throws std::bad_alloc.
void reserve_impulses(Body& body, size_t models_near);
/// Adds the sums of the parts of a body, in their order.
void add_parts(Body& body);

/// Adds an impulse at a point and a moment about it, at the end of the substep of `around`. Never allocates.
void add_impulse(Vector<ModelImpulse>& sums, const CollisionContext& around, gphys_model_id model, Vec3 point,
                 Vec3 impulse, Vec3 moment = {});
void add_impulse(Body& body, const CollisionContext& around, gphys_model_id model, Vec3 point, Vec3 impulse,
                 Vec3 moment = {});
/// Impulse of a pinned particle: to its model if it is attached to one, otherwise it is dropped.
void add_anchor_impulse(Body& body, const CollisionContext& around, uint32_t particle, Vec3 impulse);
/// The momentum of attached particles, times `sign`, and the impulse of gravity and forces on them in `seconds`.
void add_attached_impulses(Body& body, const CollisionContext& around, double sign, Vec3 gravity, double seconds);

}  // namespace gphys
