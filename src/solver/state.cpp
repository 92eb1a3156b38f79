// The particles and constraints of one body, as the caller changes them. Values have been checked. What can fail
// checks and makes room first, and wakes the body then.
#include "foundation/strided.h"
#include "solver/solver.h"

namespace gphys {

void interrupt(Body& body) {
    body.earlier_step = 0;
    body.touched = false;
}

namespace {

bool before(const Attachment& attachment, uint32_t particle) { return attachment.particle < particle; }

void hold(Body& body, uint32_t particle) {
    body.inverse_mass[particle] = 0;
    body.velocity[particle] = {};
}

void change_links(Body& body, uint32_t slot, int by) {
    for (const uint32_t p : {body.constraints[slot].a, body.constraints[slot].b}) {
        body.links[p].degree += static_cast<uint32_t>(by);
        body.links[p].slots ^= slot;
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
    for (uint32_t i = 0; i < count; ++i) body.position[first + i] = widen(from[i]);
    interrupt(body);
}

/// A pinned particle has no speed.
void set_velocities(Body& body, uint32_t first, uint32_t count, const gphys_vec3* velocities, uint32_t stride) {
    const Strided<gphys_vec3> from(velocities, stride);
    for (uint32_t i = 0; i < count; ++i) {
        if (!body.pinned(first + i)) body.velocity[first + i] = widen(from[i]);
        if (!body.stuck.empty()) body.stuck[first + i] = 0;
    }
    interrupt(body);
}

void set_masses(Body& body, uint32_t first, uint32_t count, const float* masses, uint32_t stride) {
    const Strided<float> from(masses, stride);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t p = first + i;
        body.mass[p] = from[i];
        if (!body.pinned(p)) body.inverse_mass[p] = 1 / body.mass[p];
    }
}

void set_radii(Body& body, uint32_t first, uint32_t count, const float* radii, uint32_t stride) {
    const Strided<float> from(radii, stride);
    for (uint32_t i = 0; i < count; ++i) body.radius[first + i] = from[i];
    body.largest_radius = -1;
}

void set_forces(Body& body, uint32_t first, uint32_t count, const gphys_vec3* forces, uint32_t stride) {
    const Strided<gphys_vec3> from(forces, stride);
    bool any = false;
    for (uint32_t i = 0; i < count; ++i) {
        body.force[first + i] = widen(from[i]);
        any = any || body.force[first + i] != Vec3{};
    }
    body.forced = any || (body.forced && count < body.size());
}

void set_pinned(Body& body, uint32_t first, uint32_t count, bool pinned) {
    for (uint32_t p = first; p < first + count; ++p) {
        if (pinned) {
            hold(body, p);
        } else {
            body.inverse_mass[p] = 1 / body.mass[p];
        }
    }
    const auto begin = std::lower_bound(body.attachments.begin(), body.attachments.end(), first, before);
    const auto end = std::lower_bound(begin, body.attachments.end(), first + count, before);
    body.attachments.erase(begin, end);
    body.plan.reach_current = false;
    interrupt(body);
}

bool is_attached(const Body& body, uint32_t particle) { return find_attachment(body, particle) != nullptr; }

void attach(Body& body, uint32_t particle, gphys_model_id model, Vec3 local) {
    reserve_more(body.attachments, 1);
    wake(body);
    const auto at = std::lower_bound(body.attachments.begin(), body.attachments.end(), particle, before);
    const Attachment attachment{particle, model, local, {}, {}};
    if (at != body.attachments.end() && at->particle == particle) {
        *at = attachment;
    } else {
        body.attachments.insert(at, attachment);
    }
    hold(body, particle);
    body.plan.reach_current = false;
    interrupt(body);
}

bool Solver::set_origin(Vec3 origin) {
    const Vec3 shift = state_.origin - origin;
    for (const Body& b : state_.bodies) {
        for (const Vec3 p : b.position) {
            if (max_component(abs(p + shift)) > GPHYS_MAX_COORDINATE) return false;
        }
    }
    for (Body& b : state_.bodies) {
        for (Vector<Vec3>* places : {&b.position, &b.predicted, &b.start, &b.earlier}) {
            for (Vec3& p : *places) p += shift;
        }
        wake(b);
        for (Touch& touch : b.touches) {
            if (touch.model != 0) touch.point = narrow(widen(touch.point) + shift);
        }
        for (Attachment& attachment : b.attachments) attachment.begin += shift, attachment.end += shift;
    }
    for (PlacedModel& seen : state_.seen) seen.world.position = narrow(widen(seen.world.position) + shift);
    state_.origin = origin;
    return true;
}

gphys_status add_constraint(Body& body, const DistanceConstraint& constraint, gphys_constraint_id& out) {
    if (!body.constraint_ids.reserve(1)) {
        return fail(GPHYS_ERROR_CAPACITY, "a body has at most 2^24 - 1 constraints");
    }
    reserve_more(body.constraints, 1);
    wake(body);
    out = body.constraint_ids.add();
    const uint32_t slot = IdTable::slot_of(out);
    if (slot == body.constraints.size()) body.constraints.emplace_back();
    DistanceConstraint& added = body.constraints[slot];
    added = constraint;
    if (added.rest < 0) added.rest = distance(body.position[added.a], body.position[added.b]);
    change_constraints(body, slot, 1);
    return GPHYS_OK;
}

gphys_status check_constraint(const Body& body, gphys_constraint_id id) {
    if (body.constraint_ids.has(id)) return GPHYS_OK;
    return fail(GPHYS_ERROR_INVALID_ID, "constraint: no such constraint, or no longer");
}

gphys_status set_damping(Body& body, gphys_constraint_id id, double damping) {
    const gphys_status status = check_constraint(body, id);
    if (status != GPHYS_OK) return status;
    wake(body);
    body.constraints[IdTable::slot_of(id)].damping = damping;
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
    body.constraint_ids.remove(id);
    body.rest_position.clear();
    return GPHYS_OK;
}

gphys_status set_volume(Body& body, double rest, double compliance) {
    if (!body.volume.held && !encloses_volume(body)) {
        return fail(GPHYS_ERROR_UNSUPPORTED, "body: its triangles do not close, or are not all turned the same way");
    }
    const double now = volume_of(body);
    if (rest < 0 && !(now > 0)) return fail(GPHYS_ERROR_UNSUPPORTED, "body: it is turned inside out");
    wake(body);
    if (!body.volume.held) body.plan.chains_current = false;
    body.volume.held = true;
    body.volume.rest = rest < 0 ? now : rest;
    body.volume.compliance = compliance;
    interrupt(body);
    return GPHYS_OK;
}

void release_volume(Body& body) {
    wake(body);
    body.volume.held = false;
    body.volume.pressure = 0;
    body.plan.chains_current = false;
    interrupt(body);
}

void list_constraints(const Body& body, Smallest<gphys_constraint_info, ConstraintOrder>& out) {
    for (uint32_t slot = 0; slot < body.constraint_ids.slots(); ++slot) {
        if (!body.constraint_ids.live(slot)) continue;
        const DistanceConstraint& c = body.constraints[slot];
        out.add({body.constraint_ids.id(slot), c.a, c.b, static_cast<float>(c.rest), static_cast<float>(c.compliance)});
    }
}

}  // namespace gphys
