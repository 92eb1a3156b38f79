#include "solver/snapshot/snapshot_check.h"

namespace gphys {
namespace {

bool in_range(double value) { return std::fabs(value) <= GPHYS_MAX_COORDINATE; }
bool in_range(Vec3 value) { return in_range(value.x) && in_range(value.y) && in_range(value.z); }
bool is_amount(double value) { return value >= 0 && value <= GPHYS_MAX_COORDINATE; }
/// Between places in range, or the volume among them.
bool is_finite_amount(double value) { return value >= 0 && std::isfinite(value); }
bool finite(double value) { return std::isfinite(value); }
bool finite(Vec3 value) { return finite(value.x) && finite(value.y) && finite(value.z); }
// Crossing all coordinates in the shortest substep, 2e15 m in 1e-9 s, takes 2e24 m/s; beyond this,
// squares of speeds would soon leave the doubles.
bool is_speed(Vec3 value) { return max_component(abs(value)) <= 1e30; }

template <class T, class Is>
bool all(const Vector<T>& values, Is&& is) {
    return std::all_of(values.begin(), values.end(), is);
}

bool sizes_agree(const Body& body) {
    const size_t n = body.position.size();
    const auto none_or = [](size_t size, size_t wanted) { return size == 0 || size == wanted; };
    return n >= 1 && n <= IdTable::capacity && body.velocity.size() == n && body.force.size() == n &&
           body.mass.size() == n && body.inverse_mass.size() == n && body.radius.size() == n &&
           body.constraints.size() == body.constraint_ids.slots() && none_or(body.rest_position.size(), n) &&
           body.settings.self_collision <= 1 && body.placed.size() == (body.settings.self_collision ? n : 0) &&
           none_or(body.start.size(), n) && none_or(body.start_velocity.size(), n) &&
           none_or(body.touches.size(), n * touches_per_particle) && none_or(body.stuck.size(), n) &&
           none_or(body.cloth.looked.size(), 4 * n) && body.triangles.size() % 3 == 0;
}

/// Empty, or of finite floats.
bool fine_box(const Box& box) {
    return std::all_of(box.min, box.min + 3, [](float v) { return std::isfinite(v); }) &&
           std::all_of(box.max, box.max + 3, [](float v) { return std::isfinite(v); });
}

bool particles_fine(const Body& body) {
    for (uint32_t p = 0; p < body.size(); ++p) {
        const double mass = body.mass[p], inverse = body.inverse_mass[p];
        if (!(mass > 0 && mass <= GPHYS_MAX_COORDINATE && (inverse == 0 || inverse == 1 / mass))) return false;
    }
    const auto vector_finite = [](Vec3 value) { return finite(value); };
    const auto float_finite = [](float value) { return std::isfinite(value); };
    return all(body.position, [](Vec3 at) { return in_range(at); }) && all(body.velocity, is_speed) &&
           all(body.force, [](Vec3 force) { return in_range(force); }) && all(body.radius, is_amount) &&
           all(body.rest_position, vector_finite) && all(body.placed, vector_finite) &&
           all(body.start, vector_finite) && all(body.start_velocity, is_speed) &&
           all(body.cloth.moved, float_finite) && all(body.cloth.velocity_before, float_finite) &&
           all(body.cloth.looked, float_finite) && in_range(body.cloth.origin) && is_amount(body.earlier_step) &&
           is_amount(body.cloth.balance.lost) && is_amount(body.sleep.calm) && fine_box(body.sleep.box);
}

bool impulses_fine(const Body& body) {
    const auto finite_one = [](const ModelImpulse& given) { return finite(given.linear) && finite(given.angular); };
    const auto out_of_order = [](const ModelImpulse& a, const ModelImpulse& b) { return a.model >= b.model; };
    return all(body.impulses, finite_one) &&
           std::adjacent_find(body.impulses.begin(), body.impulses.end(), out_of_order) == body.impulses.end();
}

bool attachments_fine(const Body& body) {
    for (size_t i = 0; i < body.attachments.size(); ++i) {
        const Attachment& a = body.attachments[i];
        if (a.particle >= body.size() || !body.pinned(a.particle) || !finite(a.local)) return false;
        if (i > 0 && a.particle <= body.attachments[i - 1].particle) return false;
    }
    return true;
}

bool constraints_fine(const Body& body) {
    if (body.constraint_ids.defect()) return false;
    for (uint32_t slot = 0; slot < body.constraint_ids.slots(); ++slot) {
        if (!body.constraint_ids.live(slot)) continue;
        const DistanceConstraint& c = body.constraints[slot];
        if (c.a >= body.size() || c.b >= body.size() || c.a == c.b) return false;
        if (!(c.rest >= 0 && finite(c.rest) && is_amount(c.compliance) && is_amount(c.damping) && c.limit <= 1))
            return false;
    }
    return true;
}

/// Every index lies within its array; what a chain leads along need not be what the constraints say.
bool plan_fine(const Body& body) {
    const Plan& plan = body.plan;
    const auto is_particle = [&](uint32_t p) { return p < body.size(); };
    const auto in_arrays = [&](const Chain& chain) {
        return uint64_t{chain.first_particle} + chain.link_count < plan.particles.size() &&
               uint64_t{chain.first_link} + chain.link_count <= plan.rest.size();
    };
    const auto fine_limit = [&](const ReachLimit& limit) {
        return is_particle(limit.particle) && is_particle(limit.anchor) && limit.distance >= 0 &&
               finite(limit.distance);
    };
    const bool direct = plan.method == GPHYS_SOLVE_DIRECT, graph = plan.method == GPHYS_SOLVE_GRAPH;
    return (plan.method == GPHYS_SOLVE_FREE || direct || graph) && plan.compliance.size() == plan.rest.size() &&
           plan.damping.size() == plan.rest.size() && plan.limit.size() == plan.rest.size() &&
           (!direct || plan.tension.size() == plan.rest.size()) && all(plan.particles, is_particle) &&
           all(plan.chains, in_arrays) && all(plan.rest, is_finite_amount) && all(plan.compliance, is_amount) &&
           all(plan.damping, is_amount) && all(plan.limit, [](uint32_t limit) { return limit <= 1; }) &&
           all(plan.tension, [](double tension) { return finite(tension); }) && all(plan.reach_limits, fine_limit) &&
           std::is_sorted(plan.families.begin(), plan.families.end()) &&
           all(plan.families, [&](uint32_t first) { return first <= plan.chains.size(); });
}

}  // namespace

const char* defect_of_globals(const SolverState& state) {
    const SolverSettings& settings = state.settings;
    if (!in_range(settings.gravity) || !in_range(state.origin) || !is_amount(state.owed)) {
        return "words: a setting is out of range";
    }
    if (!is_amount(settings.sleep_speed) || !is_amount(settings.sleep_strain) || !is_amount(settings.sleep_time) ||
        !is_amount(settings.max_strain) || !is_amount(settings.tolerance)) {
        return "words: a setting is out of range";
    }
    const auto is_substeps = [](uint32_t count) { return count >= 1 && count <= most_substeps; };
    if (!is_substeps(settings.substeps) || !is_substeps(settings.max_substeps) || settings.max_steps < 1 ||
        !(settings.fixed_step >= shortest_step && settings.fixed_step <= longest_step)) {
        return "words: a setting is out of range";
    }
    if (state.ids.defect()) return "words: the ids of the bodies contradict each other";
    if (!std::is_sorted(state.seen.begin(), state.seen.end())) return "words: models are out of order";
    return nullptr;
}

const char* defect_of_joints(const SolverState& state) {
    if (state.joint_ids.defect() || state.joints.size() != state.joint_ids.slots()) {
        return "words: the ids of the joints contradict each other";
    }
    const auto is_end = [&](uint32_t body, uint32_t particle) {
        return body < state.ids.slots() && state.ids.live(body) && particle < state.bodies[body].size();
    };
    for (uint32_t slot = 0; slot < state.joint_ids.slots(); ++slot) {
        if (!state.joint_ids.live(slot)) continue;
        const Joint& j = state.joints[slot];
        if (!is_end(j.body_a, j.particle_a) || !is_end(j.body_b, j.particle_b) || j.body_a == j.body_b ||
            !(j.rest >= 0 && finite(j.rest)) || !is_amount(j.compliance) || !finite(j.tension)) {
            return "words: a joint is none";
        }
    }
    return nullptr;
}

const char* defect(const Body& body) {
    if (!sizes_agree(body)) return "words: the arrays of a body have different lengths";
    const BodySettings& settings = body.settings;
    if (body.kind < GPHYS_BODY_PARTICLES || body.kind > GPHYS_BODY_CLOTH || !is_amount(settings.damping) ||
        !is_amount(settings.friction) || !is_amount(settings.static_friction) ||
        !(settings.restitution >= 0 && settings.restitution <= 1) || !is_amount(body.wanted_substep)) {
        return "words: a setting of a body is out of range";
    }
    if (!particles_fine(body)) return "words: a particle's state is out of range";
    const Volume& volume = body.volume;
    if (!is_finite_amount(volume.rest) || !is_amount(volume.compliance) || !finite(volume.pressure)) {
        return "words: a volume is none";
    }
    if (!impulses_fine(body)) return "words: an impulse is none";
    if (!attachments_fine(body)) return "words: an attachment is none";
    if (!constraints_fine(body)) return "words: a constraint is none";
    if (!all(body.triangles, [&](uint32_t p) { return p < body.size(); })) return "words: a triangle is none";
    if (!plan_fine(body)) return "words: the plan of a body is none";
    return nullptr;
}

}  // namespace gphys
