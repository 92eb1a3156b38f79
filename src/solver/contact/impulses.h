// What bodies give to models: whatever a contact or an attachment does to the momentum of a particle is
// done to the model the other way round. Each body keeps its sums by model, so that workers share
// nothing; the solver adds those of all bodies in a fixed order when the step is over.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"

namespace gphys {

struct Body;
struct CollisionContext;

/// Sums of a step.
struct ModelImpulse {
    gphys_model_id model;
    uint32_t tag;  // the model's
    Vec3 linear;   // N s
    Vec3 angular;  // N m s, about the model's position
};

/// In a step models are met that were not near when it began only if something has made particles many times
/// faster; there is room for this many of them, and what further ones were given is not reported.
constexpr uint32_t spare_impulses = 64;

/// What contacts do, apart from moving particles: sums by model, and whether there were any. Of a body, or of a part
/// of it that one of several workers moves.
struct ImpulseAccumulator {
    Vector<ModelImpulse>& impulses;
    bool& has_contact;
};

/// Makes room, for the parts of a body as well; throws std::bad_alloc.
void reserve_impulses(Body& body, size_t models_near);
/// What the parts of a body have given, in their order.
void add_parts(Body& body);

/// At a point and with a moment about it, at the end of what `around` covers. Never allocates.
void add_impulse(Vector<ModelImpulse>& sums, const CollisionContext& around, gphys_model_id model, Vec3 point,
                 Vec3 impulse, Vec3 moment = {});
void add_impulse(Body& body, const CollisionContext& around, gphys_model_id model, Vec3 point, Vec3 impulse,
                 Vec3 moment = {});
/// By a particle that is held: to its model if it is attached to one, or else to nobody.
void add_anchor_impulse(Body& body, const CollisionContext& around, uint32_t particle, Vec3 impulse);
/// The momentum that attached particles have, times `sign`, and what gravity and forces press them with in
/// `seconds`.
void add_attached_impulses(Body& body, const CollisionContext& around, double sign, Vec3 gravity, double seconds);

}  // namespace gphys
