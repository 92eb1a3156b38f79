// Sums of impulses by model (impulses.h).
#include "solver/contact/impulses.h"

#include "solver/contact/collision.h"

namespace gphys {
namespace {

bool before(const ModelImpulse& a, gphys_model_id model) { return a.model < model; }

/// The sum for a model, a new one if it has none; null if there is no room.
ModelImpulse* sum_for(Vector<ModelImpulse>& sums, gphys_model_id model, uint32_t tag) {
    const auto sum = std::lower_bound(sums.begin(), sums.end(), model, before);
    if (sum != sums.end() && sum->model == model) return &*sum;
    if (sums.size() == sums.capacity()) return nullptr;
    return &*sums.insert(sum, {model, tag, {}, {}});
}

Vec3 place_of(const CollisionContext& around, gphys_model_id model) {
    const gphys_transform& now = around.scene->world(model);
    const MovedModel* const moved = find_moved(around, model);
    if (!moved) return widen(now.position);
    const double way = around.way(around.end);
    return widen(moved->world.position) * (1 - way) + widen(now.position) * way;
}

}  // namespace

void reserve_impulses(Body& body, size_t models_near) {
    const size_t wanted = models_near + body.constraints.attachments.size() + spare_impulses;
    // Twice as many, so that one more model nearby does not make a step allocate.
    const auto reserve = [&](Vector<ModelImpulse>& sums) {
        if (sums.capacity() < wanted) sums.reserve(2 * wanted);
    };
    reserve(body.contacts.impulses);
    for (FlightPart& part : body.contacts.parts) reserve(part.impulses);
}

void add_parts(Body& body) {
    for (FlightPart& part : body.contacts.parts) {
        body.contacts.has_contact = body.contacts.has_contact || part.has_contact;
        for (const ModelImpulse& partial : part.impulses) {
            ModelImpulse* const sum = sum_for(body.contacts.impulses, partial.model, partial.tag);
            if (!sum) continue;
            sum->linear += partial.linear;
            sum->angular += partial.angular;
        }
        part.impulses.clear();
        part.has_contact = false;
    }
}

void add_impulse(Vector<ModelImpulse>& sums, const CollisionContext& around, gphys_model_id model, Vec3 point,
                 Vec3 impulse, Vec3 moment) {
    if (model == 0) return;  // of a pin that the caller moves
    ModelImpulse* const sum = sum_for(sums, model, around.scene->tag(model));
    if (!sum) return;
    sum->linear += impulse;
    sum->angular += cross(point - place_of(around, model), impulse) + moment;
}

void add_impulse(Body& body, const CollisionContext& around, gphys_model_id model, Vec3 point, Vec3 impulse,
                 Vec3 moment) {
    add_impulse(body.contacts.impulses, around, model, point, impulse, moment);
}

void add_anchor_impulse(Body& body, const CollisionContext& around, uint32_t particle, Vec3 impulse) {
    if (!around.scene) return;
    if (const Attachment* attachment = find_attachment(body.constraints, particle)) {
        add_impulse(body, around, attachment->model, body.particles.position[particle], impulse);
    }
}

void add_attached_impulses(Body& body, const CollisionContext& around, double sign, Vec3 gravity, double seconds) {
    if (!around.scene) return;
    for (const Attachment& attachment : body.constraints.attachments) {
        const uint32_t p = attachment.particle;
        const Vec3 momentum = body.particles.velocity[p] * body.particles.mass[p];
        const Vec3 applied = (gravity * body.particles.mass[p] + body.particles.force[p]) * seconds;
        add_impulse(body, around, attachment.model, body.particles.position[p], momentum * sign + applied);
    }
}

}  // namespace gphys
