// Changes of the particles of one body by the caller. Values have been checked. Functions that can fail check and
// allocate first, and then wake the body.
#include "solver/state.h"
#include "foundation/strided.h"
#include "solver/quads.h"
#include "solver/solver.h"

namespace gphys {

void interrupt(Body& body) {
    body.history.earlier_step = 0;
    body.contacts.has_contact = false;
}

namespace {

void remove_moved_pins(Constraints& constraints) {
    Vector<Attachment>& all = constraints.attachments;
    all.erase(std::remove_if(all.begin(), all.end(), [](const Attachment& each) { return each.model == 0; }),
              all.end());
}

/// Unless the pin follows a model. Memory was reserved before.
void move_pin(Body& body, uint32_t particle, Vec3 to) {
    Vector<Attachment>& all = body.constraints.attachments;
    const auto at = attachments_from(all, particle);
    if (at == all.end() || at->particle != particle) {
        all.insert(at, {particle, 0, {}, body.particles.position[particle], to});
    } else if (at->model == 0) {
        at->end = to;
    }
}

void hold(Particles& particles, uint32_t particle) {
    particles.inverse_mass[particle] = 0;
    particles.velocity[particle] = {};
}

}  // namespace

void set_positions(Body& body, uint32_t first, uint32_t count, const gphys_vec3* positions, uint32_t stride) {
    const Strided<gphys_vec3> from(positions, stride);
    bool placed = body.history.placed;
    for (uint32_t p = first; p < first + count && !placed; ++p) placed = !body.particles.pinned(p);
    if (placed) {
        remove_moved_pins(body.constraints);
        body.history.placed = true;
        interrupt(body);
    } else {
        reserve_more(body.constraints.attachments, count);
        wake(body);
    }
    for (uint32_t i = 0; i < count; ++i) {
        const Vec3 to = widen(from[i]);
        if (!placed) move_pin(body, first + i, to);
        body.particles.position[first + i] = to;
    }
    restart_targets(body, first, count);
}

void end_moved_pins(Body& body, double way) {
    body.history.placed = false;
    for (Attachment& attachment : body.constraints.attachments) {
        if (attachment.model != 0) continue;
        attachment.begin = body.particles.position[attachment.particle];
        body.particles.velocity[attachment.particle] = {};
        for (Vector<float>* motion : {&body.cloth.state.moved, &body.cloth.state.velocity_before}) {
            if (!motion->empty()) put(&(*motion)[4 * size_t{attachment.particle}], {}, 0);
        }
    }
    if (way == 1) remove_moved_pins(body.constraints);
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

void set_friction_factors(Body& body, uint32_t first, uint32_t count, const float* factors, uint32_t stride) {
    const Strided<float> from(factors, stride);
    Vector<double>& all = body.contacts.friction_factor;
    bool any = !all.empty();
    for (uint32_t i = 0; i < count && !any; ++i) any = from[i] != 1;
    if (all.empty() && any) all.assign(body.particles.size(), 1);
    wake(body);
    if (!any) return;
    for (uint32_t i = 0; i < count; ++i) {
        double& factor = all[first + i];
        // What friction holds now was held by another friction.
        if (factor != from[i] && !body.contacts.stuck.empty()) body.contacts.stuck[first + i] = 0;
        factor = from[i];
    }
    if (std::all_of(all.begin(), all.end(), [](double factor) { return factor == 1; })) all.clear();
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
            hold(body.particles, p);
        } else {
            body.particles.inverse_mass[p] = 1 / body.particles.mass[p];
        }
    }
    Vector<Attachment>& all = body.constraints.attachments;
    all.erase(attachments_from(all, first), attachments_from(all, first + count));
    body.plan.reach_current = false;
    interrupt(body);
}

bool is_attached(const Constraints& constraints, uint32_t particle) {
    const Attachment* const attachment = find_attachment(constraints, particle);
    return attachment && attachment->model != 0;
}

void attach(Body& body, uint32_t particle, gphys_model_id model, Vec3 local) {
    reserve_more(body.constraints.attachments, 1);
    wake(body);
    Vector<Attachment>& all = body.constraints.attachments;
    const Attachment attachment{particle, model, local, {}, {}};
    const auto at = attachments_from(all, particle);
    if (at != all.end() && at->particle == particle) {
        *at = attachment;
    } else {
        all.insert(at, attachment);
    }
    hold(body.particles, particle);
    body.plan.reach_current = false;
    interrupt(body);
}

bool Solver::set_origin(Vec3 origin) {
    const Vec3 shift = state_.origin - origin;
    const auto leaves = [&](Vec3 place) { return max_component(abs(place + shift)) > GPHYS_MAX_COORDINATE; };
    for (const Body& b : state_.bodies) {
        const Vector<Vec3>& places = b.particles.position;
        const Vector<AnimationTarget>& targets = b.targets.all;
        if (std::any_of(places.begin(), places.end(), leaves)) return false;
        if (std::any_of(targets.begin(), targets.end(),
                        [&](const AnimationTarget& target) { return target.bounds() && leaves(target.to); })) {
            return false;
        }
    }
    for (Body& b : state_.bodies) {
        for (Vector<Vec3>* places :
             {&b.particles.position, &b.history.predicted, &b.history.start, &b.history.earlier}) {
            for (Vec3& p : *places) p += shift;
        }
        wake(b);
        for (ContactPoint& point : b.contacts.points) {
            if (point.model != 0) point.point = narrow(widen(point.point) + shift);
        }
        for (Attachment& attachment : b.constraints.attachments) attachment.begin += shift, attachment.end += shift;
        for (AnimationTarget& target : b.targets.all) target.from += shift, target.to += shift;
    }
    for (PlacedModel& model : state_.near_models) model.world.position = narrow(widen(model.world.position) + shift);
    state_.origin = origin;
    update_meshes(shift);
    return true;
}

}  // namespace gphys
