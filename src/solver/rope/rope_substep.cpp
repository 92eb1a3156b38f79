// One substep of a rope, or of any other body that is solved as a whole, on its own: where its particles would go,
// the links (rope_direct.cpp), velocities, contacts, and the links again beside those.
//
// Time scheme of constrained bodies: the backward differentiation formula of second order for
// unequal steps, with constraint forces at the end of the substep. Unlike a position difference
// alone (backward Euler), which takes 9 % of the energy of a pendulum in a second, its damping is of
// third order in the step, and it is stable however stiff the constraints are (A- and L-stable).
// Ropes that move calmly go by the trapezoid rule in the first part of each substep (stages_kernels.cpp), which
// leaves a seventh of the error for twice the work.
// After an interruption - a contact, a change by the caller - one step of backward Euler restarts it.
#include "solver/motion.h"
#include "solver/rope/damping.h"
#include "solver/rope/rope.h"

namespace gphys {

namespace {

/// By particle, the force of its links in newtons.
void sum_tensions(const Body& body, Vector<Vec3>& forces) {
    forces.assign(body.size(), Vec3{});
    for (const Chain& chain : body.plan.chains) {
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const uint32_t a = body.plan.particles[chain.first_particle + i];
            const uint32_t b = body.plan.particles[chain.first_particle + i + 1];
            const Vec3 pull = link_direction(body, a, b) * body.plan.tension[chain.first_link + i];
            forces[a] += pull;
            forces[b] += -pull;
        }
    }
}

void predict_chains(Body& body, const TimeScheme& scheme, Vec3 gravity) {
    std::swap(body.earlier, body.start);
    std::swap(body.earlier_velocity, body.start_velocity);
    body.start = body.position;
    body.start_velocity = body.velocity;
    const double damping = body.settings.damping, drag = scheme.drag(damping);
    Vector<Vec3>& pulls = body.predicted;  // not yet in use
    if (scheme.lean > 0) sum_tensions(body, pulls);
    for (uint32_t p = 0; p < body.size(); ++p) {
        if (body.pinned(p)) continue;
        const Vec3 velocity = body.velocity[p], falling = gravity + body.force[p] * body.inverse_mass[p];
        const Vec3 rate = scheme.lean > 0 ? falling + pulls[p] * body.inverse_mass[p] - velocity * damping : Vec3{};
        body.velocity[p] = (scheme.from_history(velocity, body.earlier_velocity[p], rate) + falling * scheme.h) * drag;
        body.position[p] =
            (scheme.from_history(body.position[p], body.earlier[p], velocity) + body.velocity[p] * scheme.h) *
            (1 / scheme.next);
        keep_in_range(body.position[p], body.velocity[p]);
    }
    if (body.plan.limited) predict_flying(body, gravity, scheme.advance);
    body.predicted = body.position;
}

/// At the beginning of the substep.
double parting_speed(const Body& body, uint32_t a, uint32_t b) {
    const Vec3 along = body.start[b] - body.start[a];
    const double length = gphys::length(along);
    return length > 0 ? dot(along, body.start_velocity[b] - body.start_velocity[a]) / length : 0;
}

void damp_chains(Body& body, const TimeScheme& scheme) {
    Plan& plan = body.plan;
    for (const Chain& chain : plan.chains) {
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const uint32_t link = chain.first_link + i;
            if (plan.damping[link] == 0 || plan.compliance[link] == 0) continue;
            const uint32_t a = plan.particles[chain.first_particle + i],
                           b = plan.particles[chain.first_particle + i + 1];
            const DampedLink now = damped(plan.rest[link], plan.compliance[link], plan.damping[link], scheme,
                                          distance(body.start[a], body.start[b]),
                                          distance(body.earlier[a], body.earlier[b]), parting_speed(body, a, b));
            plan.damped_rest[link] = now.rest;
            plan.damped_compliance[link] = now.compliance;
        }
    }
}

}  // namespace

void begin_chains(Body& body, const Surroundings& around, Vec3 gravity, const TimeScheme& scheme) {
    predict_chains(body, scheme, gravity);
    follow_models(body, around.end, scheme.advance, 0, body.size());
    if (body.plan.damped) damp_chains(body, scheme);
}

void finish_chains(Body& body, const TimeScheme& scheme) {
    for (uint32_t p = 0; p < body.size(); ++p) {
        if (body.pinned(p)) continue;
        keep_in_range(body.position[p], body.velocity[p]);
        if (body.plan.limited && body.flying[p]) {
            body.velocity[p] += (body.position[p] - body.predicted[p]) * (scheme.next / scheme.h);
            continue;
        }
        const Vec3 history = scheme.from_history(body.start[p], body.earlier[p], body.start_velocity[p]);
        body.velocity[p] = (body.position[p] * scheme.next - history) / scheme.h;
    }
}

void hold_touching(Body& body) {
    for (uint32_t p = 0; p < body.size(); ++p) {
        if (body.held[p]) body.inverse_mass[p] = 0;
    }
}

void let_go_touching(Body& body) {
    for (uint32_t p = 0; p < body.size(); ++p) {
        if (body.held[p]) body.inverse_mass[p] = 1 / body.mass[p];
    }
}

void give_tensions(Body& body, const Surroundings& around, const TimeScheme& scheme) {
    for (const Chain& chain : body.plan.chains) {
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const uint32_t a = body.plan.particles[chain.first_particle + i];
            const uint32_t b = body.plan.particles[chain.first_particle + i + 1];
            if (!body.pinned(a) && !body.pinned(b)) continue;
            const Vec3 impulse = link_impulse(body, a, b, chain.first_link + i, scheme);
            if (body.pinned(a)) give_anchor(body, around, a, impulse);
            if (body.pinned(b)) give_anchor(body, around, b, -impulse);
        }
    }
}

namespace {

bool solve_predicted(Body& body, const TimeScheme& scheme) {
    return solve_directly(body, scheme.step(body.settings.damping));
}

/// Once they are solved.
void end_chains(Body& body, const Surroundings& around, Vec3 gravity, const TimeScheme& scheme) {
    const double step = scheme.step(body.settings.damping);
    finish_chains(body, scheme);
    const bool captured = body.plan.limited && capture(body, around, scheme);
    const double quiet = quiet_speed(gravity, scheme.advance);
    collide(body, around, quiet);
    if (body.touched) {
        ease_contacts(body, around);
        hold_touching(body);
        solve_directly(body, step);
        let_go_touching(body);
        collide_again(body, around, quiet, {step, scheme.next / scheme.h});
    }
    if (!body.attachments.empty()) give_tensions(body, around, scheme);
    body.earlier_step = body.touched || captured ? 0 : scheme.advance;
}

/// As it was before begin_chains.
void take_back(Body& body) {
    body.position = body.start;
    body.velocity = body.start_velocity;
    std::swap(body.earlier, body.start);
    std::swap(body.earlier_velocity, body.start_velocity);
    body.plan.tension = body.plan.earlier_tension;
}

/// Whether rigid links had their lengths before the substep. Those that are put right by it do so at a speed that
/// grows as it gets shorter.
bool began_in_shape(const Body& body) {
    constexpr double most_strain = 0.05;
    const Plan& plan = body.plan;
    for (const Chain& chain : plan.chains) {
        const uint32_t* const particle = &plan.particles[chain.first_particle];
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const uint32_t link = chain.first_link + i;
            if (plan.compliance[link] > 0) continue;
            const double excess = distance(body.start[particle[i]], body.start[particle[i + 1]]) - plan.target[link];
            if ((plan.limit[link] ? excess : std::fabs(excess)) > most_strain * plan.target[link]) return false;
        }
    }
    return true;
}

// Half a second becomes parts of 4 ms, in which a link of 1 mm that gravity swings turns by 0.4 radians.
constexpr int most_halvings = 7;
constexpr double halves[] = {0.5, 0.5};
// Where links turn by a radian Newton's method may go about for a while before it converges.
constexpr int most_solutions = 8;

/// A substep too long for Newton's method is made in halves. What is not found in the shortest ones either is not
/// looked for any longer. Returns whether all was found.
bool move_chains(Body& body, const Surroundings& around, Vec3 gravity, const TimeScheme& scheme,
                 int halvings = most_halvings) {
    body.plan.earlier_tension = body.plan.tension;
    begin_chains(body, around, gravity, scheme);
    bool found = solve_predicted(body, scheme);
    const bool may_be_found = found || began_in_shape(body);
    for (int i = 1; may_be_found && !found && i < most_solutions; ++i) found = solve_predicted(body, scheme);
    if (found || !may_be_found || halvings == 0) {
        end_chains(body, around, gravity, scheme);
        return found;
    }
    take_back(body);
    found = true;
    move_in_parts(halves, around, scheme.advance, [&](const Surroundings& within, double part) {
        const TimeScheme backward(part, body.earlier_step);
        found = move_chains(body, within, gravity, backward, found ? halvings - 1 : 0) && found;
    });
    return found;
}

}  // namespace

bool starts_again(const Body& body) { return body.earlier_step == 0 && !body.touched; }

void move_rope(Body& body, const Surroundings& around, Vec3 gravity, double h) {
    const auto move_part = [&](const Surroundings& within, double part) {
        move_chains(body, within, gravity, TimeScheme(part, body.earlier_step));
    };
    // How calm it is after an interruption shows in the next step.
    if (body.earlier_step == 0) body.in_stages = false;
    if (starts_again(body)) {
        start_slowly(around, h, move_part);
    } else if (body.in_stages) {
        bool leans = true;
        move_in_parts(stages, around, h, [&](const Surroundings& within, double part) {
            if (leans) {
                move_chains(body, within, gravity, TimeScheme::trapezoid(part));
            } else {
                move_part(within, part);
            }
            leans = false;
        });
    } else {
        move_part(around, h);
    }
}

void end_rope(Body& body, const Surroundings& around, Vec3 gravity, const TimeScheme& scheme) {
    solve_predicted(body, scheme);
    end_chains(body, around, gravity, scheme);
}

}  // namespace gphys
