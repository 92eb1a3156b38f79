// The particles and constraints of one body, as the caller changes them. Values have been checked. What can fail
// checks and makes room first, and wakes the body then.
#include "foundation/strided.h"
#include "solver/solver.h"

namespace gphys {

void interrupt(Body& body) {
    body.history.earlier_step = 0;
    body.contacts.touched = false;
}

namespace {

bool before(const Attachment& attachment, uint32_t particle) { return attachment.particle < particle; }

void hold(Body& body, uint32_t particle) {
    body.particles.inverse_mass[particle] = 0;
    body.particles.velocity[particle] = {};
}

void change_links(Body& body, uint32_t slot, int by) {
    for (const uint32_t p : {body.constraints.by_slot[slot].a, body.constraints.by_slot[slot].b}) {
        body.constraints.links[p].degree += static_cast<uint32_t>(by);
        body.constraints.links[p].slots ^= slot;
    }
}

void change_constraints(Body& body, uint32_t slot, int by) {
    change_links(body, slot, by);
    body.plan.chains_current = false;
    interrupt(body);
}

}  // namespace

void join_links(Body& body, uint32_t slot) { change_links(body, slot, 1); }

void set_positions(Body& body, uint32_t first, uint32_t count, const gphys_vec3* positions, uint32_t stride) {
    const Strided<gphys_vec3> from(positions, stride);
    for (uint32_t i = 0; i < count; ++i) body.particles.position[first + i] = widen(from[i]);
    interrupt(body);
}

/// A pinned particle has no speed.
void set_velocities(Body& body, uint32_t first, uint32_t count, const gphys_vec3* velocities, uint32_t stride) {
    const Strided<gphys_vec3> from(velocities, stride);
    for (uint32_t i = 0; i < count; ++i) {
        if (!body.particles.pinned(first + i)) body.particles.velocity[first + i] = widen(from[i]);
        if (!body.contacts.stuck.empty()) body.contacts.stuck[first + i] = 0;
    }
    interrupt(body);
}

void set_masses(Body& body, uint32_t first, uint32_t count, const float* masses, uint32_t stride) {
    const Strided<float> from(masses, stride);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t p = first + i;
        body.particles.mass[p] = from[i];
        if (!body.particles.pinned(p)) body.particles.inverse_mass[p] = 1 / body.particles.mass[p];
    }
}

void set_radii(Body& body, uint32_t first, uint32_t count, const float* radii, uint32_t stride) {
    const Strided<float> from(radii, stride);
    for (uint32_t i = 0; i < count; ++i) body.particles.radius[first + i] = from[i];
    body.particles.largest_radius = -1;
}

void set_forces(Body& body, uint32_t first, uint32_t count, const gphys_vec3* forces, uint32_t stride) {
    const Strided<gphys_vec3> from(forces, stride);
    bool any = false;
    for (uint32_t i = 0; i < count; ++i) {
        body.particles.force[first + i] = widen(from[i]);
        any = any || body.particles.force[first + i] != Vec3{};
    }
    body.particles.forced = any || (body.particles.forced && count < body.particles.size());
}

void set_pinned(Body& body, uint32_t first, uint32_t count, bool pinned) {
    for (uint32_t p = first; p < first + count; ++p) {
        if (pinned) {
            hold(body, p);
        } else {
            body.particles.inverse_mass[p] = 1 / body.particles.mass[p];
        }
    }
    const auto begin =
        std::lower_bound(body.constraints.attachments.begin(), body.constraints.attachments.end(), first, before);
    const auto end = std::lower_bound(begin, body.constraints.attachments.end(), first + count, before);
    body.constraints.attachments.erase(begin, end);
    body.plan.reach_current = false;
    interrupt(body);
}

bool is_attached(const Body& body, uint32_t particle) { return find_attachment(body.constraints, particle) != nullptr; }

void attach(Body& body, uint32_t particle, gphys_model_id model, Vec3 local) {
    reserve_more(body.constraints.attachments, 1);
    wake(body);
    const auto at =
        std::lower_bound(body.constraints.attachments.begin(), body.constraints.attachments.end(), particle, before);
    const Attachment attachment{particle, model, local, {}, {}};
    if (at != body.constraints.attachments.end() && at->particle == particle) {
        *at = attachment;
    } else {
        body.constraints.attachments.insert(at, attachment);
    }
    hold(body, particle);
    body.plan.reach_current = false;
    interrupt(body);
}

bool Solver::set_origin(Vec3 origin) {
    const Vec3 shift = state_.origin - origin;
    for (const Body& b : state_.bodies) {
        for (const Vec3 p : b.particles.position) {
            if (max_component(abs(p + shift)) > GPHYS_MAX_COORDINATE) return false;
        }
    }
    for (Body& b : state_.bodies) {
        for (Vector<Vec3>* places :
             {&b.particles.position, &b.history.predicted, &b.history.start, &b.history.earlier}) {
            for (Vec3& p : *places) p += shift;
        }
        wake(b);
        for (Touch& touch : b.contacts.touches) {
            if (touch.model != 0) touch.point = narrow(widen(touch.point) + shift);
        }
        for (Attachment& attachment : b.constraints.attachments) attachment.begin += shift, attachment.end += shift;
    }
    for (PlacedModel& seen : state_.seen) seen.world.position = narrow(widen(seen.world.position) + shift);
    state_.origin = origin;
    show_all(shift);
    return true;
}

gphys_status add_constraint(Body& body, const DistanceConstraint& constraint, gphys_constraint_id& out) {
    if (!body.constraints.ids.reserve(1)) {
        return fail(GPHYS_ERROR_CAPACITY, "a body has at most 2^24 - 1 constraints");
    }
    reserve_more(body.constraints.by_slot, 1);
    wake(body);
    out = body.constraints.ids.add();
    const uint32_t slot = IdTable::slot_of(out);
    if (slot == body.constraints.by_slot.size()) body.constraints.by_slot.emplace_back();
    DistanceConstraint& added = body.constraints.by_slot[slot];
    added = constraint;
    if (added.rest < 0) added.rest = distance(body.particles.position[added.a], body.particles.position[added.b]);
    change_constraints(body, slot, 1);
    return GPHYS_OK;
}

gphys_status check_constraint(const Body& body, gphys_constraint_id id) {
    if (body.constraints.ids.has(id)) return GPHYS_OK;
    return fail(GPHYS_ERROR_INVALID_ID, "constraint: no such constraint, or no longer");
}

gphys_status set_damping(Body& body, gphys_constraint_id id, double damping) {
    const gphys_status status = check_constraint(body, id);
    if (status != GPHYS_OK) return status;
    wake(body);
    body.constraints.by_slot[IdTable::slot_of(id)].damping = damping;
    body.plan.described = false;
    return GPHYS_OK;
}

gphys_status remove_constraint(Body& body, gphys_constraint_id id) {
    const gphys_status status = check_constraint(body, id);
    if (status != GPHYS_OK) return status;
    wake(body);
    const uint32_t slot = IdTable::slot_of(id);
    change_constraints(body, slot, -1);
    forget_length_change(body, slot);
    body.constraints.ids.remove(id);
    body.cloth.rest_position.clear();
    return GPHYS_OK;
}

gphys_status set_volume(Body& body, double rest, double compliance) {
    if (!body.cloth.volume.held && !encloses_volume(body)) {
        return fail(GPHYS_ERROR_UNSUPPORTED, "body: its triangles do not close, or are not all turned the same way");
    }
    const double now = volume_of(body);
    if (rest < 0 && !(now > 0)) return fail(GPHYS_ERROR_UNSUPPORTED, "body: it is turned inside out");
    wake(body);
    if (!body.cloth.volume.held) body.plan.chains_current = false;
    body.cloth.volume.held = true;
    body.cloth.volume.rest = rest < 0 ? now : rest;
    body.cloth.volume.compliance = compliance;
    interrupt(body);
    return GPHYS_OK;
}

void release_volume(Body& body) {
    wake(body);
    body.cloth.volume.held = false;
    body.cloth.volume.pressure = 0;
    body.plan.chains_current = false;
    interrupt(body);
}

void list_constraints(const Body& body, Smallest<gphys_constraint_info, ConstraintOrder>& out) {
    for (uint32_t slot = 0; slot < body.constraints.ids.slots(); ++slot) {
        if (!body.constraints.ids.live(slot)) continue;
        const DistanceConstraint& c = body.constraints.by_slot[slot];
        out.add(
            {body.constraints.ids.id(slot), c.a, c.b, static_cast<float>(c.rest), static_cast<float>(c.compliance)});
    }
}

}  // namespace gphys
