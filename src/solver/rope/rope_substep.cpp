// One substep of a single rope, or of any other body that is solved directly: prediction, links (rope_direct.cpp),
// velocities, contacts, and the links again together with the contacts.
//
// Time scheme. Constrained bodies use the backward differentiation formula of second order (BDF2) for unequal steps,
// with constraint forces at the end of the substep. It is stable for any stiffness of the constraints (A- and
// L-stable), and its damping is of third order in the step, where backward Euler takes 9 % of the energy of a pendulum
// in a second. Ropes whose links turn little in a substep use the trapezoid rule in the first part of each substep
// (TR-BDF2; stages_kernels.cpp): a seventh of the error for twice the work.
//
// Interruptions. After a contact, or a change by the caller, the history does not belong to the motion that follows. So
// one step of backward Euler restarts the scheme.
#include <iterator>

#include "solver/contact/collision.h"
#include "solver/contact/leave_solids.h"
#include "solver/motion.h"
#include "solver/rope/damping.h"
#include "solver/rope/rope.h"
#include "solver/rope/rope_contacts.h"
#include "solver/rope/rope_limits.h"
#include "solver/rope/rope_start.h"
#include "solver/rope/rope_stepper.h"
#include "solver/rope/stretched_ropes.h"

namespace gphys {
namespace {

/// By particle: the sum of the forces of its links, newtons.
void sum_tensions(const Rope& rope, const Plan& plan, const Particles& particles, Vector<Vec3>& forces) {
    forces.assign(particles.size(), Vec3{});
    each_link(plan, [&](uint32_t link, uint32_t a, uint32_t b) {
        const Vec3 pull = link_direction(particles, a, b) * rope.tension[link];
        forces[a] += pull;
        forces[b] += -pull;
    });
}

void predict_chains(Body& body, const TimeScheme& scheme, Vec3 gravity) {
    std::swap(body.history.earlier, body.history.start);
    std::swap(body.history.earlier_velocity, body.history.start_velocity);
    body.history.start = body.particles.position;
    body.history.start_velocity = body.particles.velocity;
    const double damping = body.settings.damping, drag = scheme.drag(damping);
    Vector<Vec3>& link_forces = body.history.predicted;  // which is not in use yet
    if (scheme.explicit_h > 0) {
        sum_tensions(body.rope, body.plan, body.particles, link_forces);
        each_bending_force(body.rope.bending, body.plan, body.particles.position,
                           [&](uint32_t p, Vec3 force) { link_forces[p] += force; });
    }
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        const Vec3 velocity = body.particles.velocity[p],
                   acceleration = gravity + body.particles.force[p] * body.particles.inverse_mass[p];
        const Vec3 rate = scheme.explicit_h > 0
                              ? acceleration + link_forces[p] * body.particles.inverse_mass[p] - velocity * damping
                              : Vec3{};
        body.particles.velocity[p] =
            (scheme.from_history(velocity, body.history.earlier_velocity[p], rate) + acceleration * scheme.h) * drag;
        body.particles.position[p] =
            (scheme.from_history(body.particles.position[p], body.history.earlier[p], velocity) +
             body.particles.velocity[p] * scheme.h) *
            (1 / scheme.next);
        keep_in_range(body.particles.position[p], body.particles.velocity[p]);
    }
    if (body.plan.limited) predict_slack_particles(body, gravity, scheme.advance);
    body.history.predicted = body.particles.position;
}

/// The rate of a link's length at the beginning of the substep, m/s.
double length_rate(const History& history, uint32_t a, uint32_t b) {
    const Vec3 along = history.start[b] - history.start[a];
    const double length = gphys::length(along);
    return length > 0 ? dot(along, history.start_velocity[b] - history.start_velocity[a]) / length : 0;
}

/// Sets the parameters of damped links for the substep.
void damp_chains(Rope& rope, const Plan& plan, const History& history, const TimeScheme& scheme) {
    each_link(plan, [&](uint32_t link, uint32_t a, uint32_t b) {
        if (plan.damping[link] == 0 || plan.compliance[link] == 0) return;
        const DampedLink now = damped(plan.rest[link], plan.compliance[link], plan.damping[link], scheme,
                                      distance(history.start[a], history.start[b]),
                                      distance(history.earlier[a], history.earlier[b]), length_rate(history, a, b));
        rope.damped_rest[link] = now.rest;
        rope.damped_compliance[link] = now.compliance;
    });
}

}  // namespace

void begin_chains(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme) {
    body.rope.misplaced = starts_misplaced(body);
    body.rope.earlier_tension = body.rope.tension;
    if (!body.constraints.length_changes.empty()) change_lengths(body, around.end);
    aim_targets(body, around);
    find_bends(body.rope.bending, body.plan, body.constraints, body.particles);
    predict_chains(body, scheme, gravity);
    follow_models(body, around, scheme.advance, 0, body.particles.size());
    if (body.plan.damped) damp_chains(body.rope, body.plan, body.history, scheme);
}

void roll_back_chains(Particles& particles, History& history, Rope& rope) {
    particles.position = history.start;
    particles.velocity = history.start_velocity;
    std::swap(history.earlier, history.start);
    std::swap(history.earlier_velocity, history.start_velocity);
    rope.tension = rope.earlier_tension;
}

void finish_chains(Body& body, const TimeScheme& scheme, const RopeContacts* contacts) {
    keep_to_targets(body);
    if (contacts) contacts->push_out(body.particles);
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        Vec3 &position = body.particles.position[p], &velocity = body.particles.velocity[p];
        keep_in_range(position, velocity, body.history.start[p]);
        if (body.plan.limited && body.rope.slack[p]) {
            velocity += (position - body.history.predicted[p]) * (scheme.next / scheme.h);
        } else {
            const Vec3 history =
                scheme.from_history(body.history.start[p], body.history.earlier[p], body.history.start_velocity[p]);
            velocity = (position * scheme.next - history) / scheme.h;
        }
        keep_in_range(position, velocity);
    }
    stop_at_targets(body);
}

void pin_contacts(Particles& particles, const Contacts& contacts) {
    for (uint32_t p = 0; p < particles.size(); ++p) {
        if (contacts.held[p]) particles.inverse_mass[p] = 0;
    }
}

void unpin_contacts(Particles& particles, const Contacts& contacts) {
    for (uint32_t p = 0; p < particles.size(); ++p) {
        if (contacts.held[p]) particles.inverse_mass[p] = 1 / particles.mass[p];
    }
}

void add_tension_impulses(Body& body, const CollisionContext& around, const TimeScheme& scheme) {
    each_link(body.plan, [&](uint32_t link, uint32_t a, uint32_t b) {
        if (!body.particles.pinned(a) && !body.particles.pinned(b)) return;
        const Vec3 impulse = link_impulse(body, a, b, link, scheme);
        if (body.particles.pinned(a)) add_anchor_impulse(body, around, a, impulse);
        if (body.particles.pinned(b)) add_anchor_impulse(body, around, b, -impulse);
    });
    add_bending_impulses(body, around, scheme);
}

void restore_lengths(Body& body, const CollisionContext& around, double step) {
    body.rope.earlier_tension = body.rope.tension;  // they belong to the motion, so they are kept
    std::fill(body.rope.tension.begin(), body.rope.tension.end(), 0.0);
    body.history.predicted = body.particles.position;
    body.rope.bending.keeps_shape = true;
    const bool solved = solve_directly(body, step);
    body.rope.bending.keeps_shape = false;
    body.rope.tension = body.rope.earlier_tension;
    end_leaving(body, around, solved);
}

namespace {

/// Moves the rope out of models that it is in.
void leave_solids(Body& body, const CollisionContext& around, double step) {
    if (body.contacts.penetrating && begin_leaving(body, around)) restore_lengths(body, around, step);
}

/// Collides the particles with models. If there are contacts, solves the links again, with the particles in contact
/// pinned. `limits`: the bounds of animation targets, or null.
void collide_with_models(Body& body, RopeContacts* limits, const CollisionContext& around, Vec3 gravity,
                         const TimeScheme& scheme) {
    const double step = scheme.step(body.settings.damping),
                 bounce_threshold = find_bounce_threshold(gravity, scheme.advance);
    collide(body, around, bounce_threshold);
    if (body.contacts.has_contact) {
        relax_contacts(body, around);
        pin_contacts(body.particles, body.contacts);
        solve_with_contacts(body, step, limits);
        unpin_contacts(body.particles, body.contacts);
        // Particles pushed out by a shape at the border, and others linked to them, may have left the range.
        for (uint32_t p = 0; p < body.particles.size(); ++p)
            keep_in_range(body.particles.position[p], body.particles.velocity[p], body.history.start[p]);
        collide_again(body, around, bounce_threshold, {step, scheme.next / scheme.h});
    }
}

/// The substep after the links are solved. `contacts`: those that were solved together with them, or null.
void end_chains(Body& body, RopeContacts* contacts, const CollisionContext& around, Vec3 gravity,
                const TimeScheme& scheme) {
    finish_chains(body, scheme, contacts);
    const bool has_limit_impact = body.plan.limited && apply_limit_impacts(body, around, scheme);
    const bool with_models = contacts && contacts->near_models();
    if (with_models) {
        contacts->finish(body, around, find_bounce_threshold(gravity, scheme.advance), scheme);
    } else {
        collide_with_models(body, contacts, around, gravity, scheme);
    }
    if (!body.constraints.attachments.empty()) add_tension_impulses(body, around, scheme);
    if (!with_models) leave_solids(body, around, scheme.step(body.settings.damping));
    end_substep(body, has_limit_impact, scheme);
    if (body.rope.misplaced) keep_velocities(body, gravity, scheme.advance);
}

}  // namespace

void end_substep(Body& body, bool has_limit_impact, const TimeScheme& scheme) {
    body.contacts.has_contact = body.contacts.has_contact || !body.targets.reached.empty();
    body.history.earlier_step = body.contacts.has_contact || has_limit_impact ? 0 : scheme.advance;
    if (body.breaking.possible()) add_chain_loads(body, scheme);
}

bool restarts(const History& history, const Contacts& contacts) {
    return history.earlier_step == 0 && !contacts.has_contact;
}

void RopeMotion::begin(const CollisionContext& around, double h) {
    scheme = by_trapezoid ? TimeScheme::trapezoid(h) : TimeScheme(h, body.history.earlier_step);
    begin_chains(body, around, gravity, scheme);
    const auto begin_contacts = [&] { return contacts && contacts->begin(body, around, gravity, scheme); };
    with_contacts = begin_contacts();
    stop_yielding(body);
    if (contacts && begin_stretched(body, with_contacts ? contacts : nullptr, around, scheme)) {
        with_contacts = begin_contacts();
    }
}

bool RopeMotion::solve() {
    return solve_with_contacts(body, scheme.step(body.settings.damping), with_contacts ? contacts : nullptr);
}

bool RopeMotion::began_feasible() const { return largest_strain(body, body.history.start) <= most_initial_strain; }

void RopeMotion::finish(const CollisionContext& around, double) {
    if (stay_if_torn(body) && with_contacts) {
        contacts->search_again();
        with_contacts = contacts->begin(body, around, gravity, scheme);
    }
    end_chains(body, with_contacts ? contacts : nullptr, around, gravity, scheme);
    stop_yielding(body);
}

void RopeMotion::roll_back() {
    roll_back_chains(body.particles, body.history, body.rope);
    by_trapezoid = false;
}

void RopeStepper::begin_substep() {
    Body& body = motion_.body;
    substep_ = part_of_step(step_, begun_++, substeps_);
    begin_friction(body, motion_.gravity);
    // After an interruption, choose_stages decides again before the next step.
    if (body.history.earlier_step == 0) body.history.in_stages = false;
    static constexpr double whole[] = {1};
    if (restarts(body.history, body.contacts)) {
        parts_ = starting_parts, part_count_ = std::size(starting_parts);
    } else if (body.history.in_stages) {
        parts_ = stages, part_count_ = std::size(stages);
    } else {
        parts_ = whole, part_count_ = 1;
    }
    part_ = 0;
    fraction_done_ = 0;
}

bool RopeStepper::begin_part() {
    if (part_ == part_count_) {
        if (begun_ > 0) end_friction(motion_.body);
        if (begun_ == substeps_) return false;
        begin_substep();
    }
    const double length = substep_.end - substep_.begin;
    part_context_ = substep_;
    part_context_.begin = substep_.begin + length * fraction_done_;
    fraction_done_ += parts_[part_];
    if (part_count_ > 1) part_context_.end = substep_.begin + length * fraction_done_;
    motion_.by_trapezoid = parts_ == stages && part_ == 0;
    motion_.begin(part_context_, part_length());
    return true;
}

void RopeStepper::end_part(bool solved) {
    end_in_halves(motion_, part_context_, part_length(), solved);
    ++part_;
}

void move_rope(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    RopeStepper rope(body, nullptr, around, gravity, 1, h);
    while (rope.begin_part()) rope.end_part(rope.solve());
}

void end_rope(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme) {
    const double step = scheme.step(body.settings.damping);
    if (!solve_directly(body, step) && body.rope.loads.any()) {
        // The links would give the loads speed. In this substep they carry nothing.
        body.rope.loads.clear();
        body.particles.position = body.history.predicted;
        body.rope.tension = body.rope.earlier_tension;
        solve_directly(body, step);
    }
    end_chains(body, nullptr, around, gravity, scheme);
}

}  // namespace gphys
