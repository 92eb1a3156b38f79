// Lengths of ropes that are stretched when a substep begins (stretched_ropes.h).
#include "solver/rope/stretched_ropes.h"

#include "solver/contact/collision.h"
#include "solver/rope/rope.h"
#include "solver/rope/rope_contacts.h"

namespace gphys {
namespace {

// The strain that Newton's method distributes along a rope between two pins.
constexpr double kept_strain = 0.01;

/// If a pin has moved far, its link is much longer than the others. Then the targets are approached in several
/// substeps, as slowly as Newton's method converges with friction. `start`: where the particles are.
void approach_targets(double* target, uint32_t count, const Vector<Vec3>& start, const uint32_t* particles) {
    constexpr double most_change = 0.03;  // of a link's length in a substep
    double farthest = 0;
    const auto length = [&](uint32_t i) { return distance(start[particles[i]], start[particles[i + 1]]); };
    for (uint32_t i = 0; i < count; ++i) {
        if (target[i] > 0) farthest = std::max(farthest, std::fabs(target[i] - length(i)) / target[i]);
    }
    const double part = most_change / std::max(farthest, most_change);
    for (uint32_t i = 0; i < count && part < 1; ++i) target[i] = length(i) + (target[i] - length(i)) * part;
}

void set_all_targets(Body& body) {
    for (const Chain& chain : body.plan.chains) set_targets(body, chain);
}

/// Whether there are links between two pins.
bool is_held_twice(const Body& body) {
    for (const Chain& chain : body.plan.chains) {
        int pins = 0;
        for (uint32_t i = 0; i <= chain.link_count; ++i)
            pins += body.particles.pinned(body.plan.particles[chain.first_particle + i]);
        if (pins > 1) return true;
    }
    return false;
}

/// Whether links could not have their lengths in the substep before: then their tensions are such that they would move
/// a particle by many times the length of a link.
bool was_taut(const Body& body, double step) {
    constexpr double many = 1e4;
    for (const Chain& chain : body.plan.chains) {
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const uint32_t link = chain.first_link + i;
            const double mass = body.particles.mass[body.plan.particles[chain.first_particle + i]];
            if (body.rope.tension[link] * step * step > many * mass * body.rope.target[link]) return true;
        }
    }
    return false;
}

/// Whether no particle passes through a model on the straight way from its start to its position. Tested with half of
/// its radius, because a particle that slides along a curved surface goes through it in a straight line.
bool is_way_free(const Body& body, const Scene& scene) {
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        const Sphere core{body.history.start[p], body.particles.radius[p] / 2};
        gphys_hit hit;
        if (scene.sweep(core, body.particles.position[p] - core.center, body.settings.layers, hit) == GPHYS_OK)
            return false;
    }
    return true;
}

/// Moves the start of the substep. `held`: whether links are between two pins. Returns false, without effect, if these
/// cannot get their lengths, or if a model is in the way.
bool restore_lengths(Body& body, RopeContacts& contacts, const CollisionContext& around, double step, bool held) {
    body.rope.solved = body.history.predicted;
    body.history.predicted = body.particles.position = body.history.start;
    constexpr int most_solutions = 8;
    body.rope.bending.keeps_shape = true;
    for (int i = 0; i < most_solutions && !solve_with_contacts(body, step, &contacts); ++i) {
    }
    body.rope.bending.keeps_shape = false;
    contacts.push_out(body.particles);
    std::fill(body.rope.tension.begin(), body.rope.tension.end(), 0.0);
    contacts.search_again();
    const auto is_correct = [&] {
        return largest_strain(body, body.particles.position) <= most_initial_strain &&
               (!contacts.near_models() || is_way_free(body, *around.scene));
    };
    if (held && !is_correct()) {
        body.history.predicted = body.particles.position = body.rope.solved;
        return false;
    }
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        const Vec3 correction = body.particles.position[p] - body.history.start[p];
        body.history.start[p] += correction;
        body.history.earlier[p] += correction;
        body.particles.position[p] = body.history.predicted[p] = body.rope.solved[p] + correction;
    }
    return true;
}

}  // namespace

double largest_strain(const Body& body, const Vector<Vec3>& positions) {
    const Plan& plan = body.plan;
    double largest = 0;
    for (const Chain& chain : plan.chains) {
        const uint32_t* const particle = &plan.particles[chain.first_particle];
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const uint32_t link = chain.first_link + i;
            if (plan.compliance[link] > 0) continue;
            const double target = body.rope.target[link];
            const double excess = distance(positions[particle[i]], positions[particle[i + 1]]) - target;
            const double error = plan.limit[link] ? excess : std::fabs(excess);
            if (error <= largest * target) continue;
            if (target == 0) return infinity;
            largest = error / target;
        }
    }
    return largest;
}

void set_targets(Body& body, const Chain& chain) {
    const Plan& plan = body.plan;
    const Vector<Vec3>&position = body.particles.position, &start = body.history.start;
    const uint32_t* const particle = &plan.particles[chain.first_particle];
    const double* const rest = body.rope.damped_rest.data() + chain.first_link;
    double* const target = body.rope.target.data() + chain.first_link;
    uint32_t pin = chain.link_count + 1;  // the last pin; none yet
    double total = 0, stretched = 0;      // metres: the rest lengths since then, and the lengths at the start
    bool rigid = true;                    // whether all these links are rigid
    for (uint32_t i = 0; i <= chain.link_count; ++i) {
        if (i > 0) {
            target[i - 1] = rest[i - 1];
            total += rest[i - 1];
            rigid = rigid && plan.compliance[chain.first_link + i - 1] == 0;
            if (body.rope.yields) stretched += distance(start[particle[i - 1]], start[particle[i]]);
        }
        if (!body.particles.pinned(particle[i])) continue;
        if (pin < i && rigid) {
            const double span =
                std::max(distance(position[particle[pin]], position[particle[i]]), (1 - kept_strain) * stretched);
            for (uint32_t j = pin; j < i && span > total; ++j) {
                target[j] = total > 0 ? rest[j] * (span / total) : span / (i - pin);
            }
            if (body.rope.yields) approach_targets(target + pin, i - pin, start, particle + pin);
        }
        pin = i;
        total = stretched = 0;
        rigid = true;
    }
}

bool begin_stretched(Body& body, RopeContacts* contacts, const CollisionContext& around, const TimeScheme& scheme) {
    const double strain = largest_strain(body, body.history.start), step = scheme.step(body.settings.damping);
    if (strain <= kept_strain) return false;
    const bool held = is_held_twice(body);
    const bool is_placed = !held || (restarts(body.history, body.contacts) && !was_taut(body, step));
    const bool may_restore = contacts && is_placed && strain > most_initial_strain;
    if (may_restore && restore_lengths(body, *contacts, around, step, held)) return true;
    if (held) {
        body.rope.yields = true;
        set_all_targets(body);
    }
    return false;
}

bool stay_if_torn(Body& body) {
    if (!body.rope.yields || largest_strain(body, body.particles.position) <= most_initial_strain) return false;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (!body.particles.pinned(p)) body.particles.position[p] = body.history.start[p];
    }
    body.rope.tension = body.rope.earlier_tension;
    return true;
}

void stop_yielding(Body& body) {
    if (!body.rope.yields) return;
    body.rope.yields = false;
    set_all_targets(body);
}

}  // namespace gphys
