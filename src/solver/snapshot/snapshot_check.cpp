// The checks of a state read from a snapshot (snapshot_check.h).
#include "solver/snapshot/snapshot_check.h"

#include "solver/state_range.h"

namespace gphys {
namespace {

constexpr double range = GPHYS_MAX_COORDINATE;
// The smallest float, shared by as many particles as a body may have.
constexpr double least_mass = 0x1p-149 * 0x1p-24;
// In the coordinates of a model: the whole range divided by its scale, which is at least 1e-15.
constexpr double farthest_in_model = 1e32;

bool is_finite_amount(double value) { return value >= 0 && is_finite(value); }
/// Seconds of a step or a part of one; 0: none.
bool is_time(double value) { return value >= 0 && value <= longest_step; }
bool is_collapsed_time(double value) { return is_amount(value) || value == YieldingChords::loaded; }
/// Between two particles, wherever they are.
bool is_length(double value) { return value >= 0 && value <= far_range; }

template <class T, class Is>
bool all(const Vector<T>& values, Is&& is) {
    return std::all_of(values.begin(), values.end(), is);
}

bool sizes_agree(const Body& body) {
    const size_t n = body.particles.position.size();
    const auto none_or = [](size_t size, size_t wanted) { return size == 0 || size == wanted; };
    return n >= 1 && n <= IdTable::capacity && body.particles.velocity.size() == n &&
           body.particles.force.size() == n && body.particles.mass.size() == n &&
           body.particles.inverse_mass.size() == n && body.particles.radius.size() == n &&
           body.constraints.by_slot.size() == body.constraints.ids.slots() &&
           none_or(body.cloth.sheet.rest_position.size(), n) && body.settings.self_collision <= 1 &&
           body.contacts.self.placed.size() == (body.settings.self_collision ? n : 0) &&
           none_or(body.air.velocity.size(), n) && none_or(body.history.start.size(), n) &&
           none_or(body.history.start_velocity.size(), n) &&
           none_or(body.contacts.points.size(), n * contact_points_per_particle) &&
           none_or(body.contacts.stuck.size(), n) && none_or(body.cloth.cache.search_balls.size(), 4 * n) &&
           body.cloth.sheet.triangles.size() % 3 == 0;
}

bool settings_fine(const Body& body) {
    const BodySettings& settings = body.settings;
    return body.kind >= GPHYS_BODY_PARTICLES && body.kind <= GPHYS_BODY_CLOTH && is_amount(settings.damping) &&
           is_amount(settings.friction) && is_amount(settings.static_friction) && settings.restitution >= 0 &&
           settings.restitution <= 1 && is_time(body.substeps.wanted);
}

/// Empty, or of finite floats.
bool fine_box(const Box& box) {
    return std::all_of(box.min, box.min + 3, [](float v) { return std::isfinite(v); }) &&
           std::all_of(box.max, box.max + 3, [](float v) { return std::isfinite(v); });
}

bool is_contact_point(const ContactPoint& point) {
    constexpr double unit = 1 + 0x1p-20;
    return is_finite(widen(point.point)) && is_within(unit, widen(point.normal));
}

bool are_search_balls_valid(const Vector<float>& search_balls) {
    for (size_t i = 0; i < search_balls.size(); i += 4) {
        const float reach = search_balls[i + 3];
        if (!is_within(far_range, {search_balls[i], search_balls[i + 1], search_balls[i + 2]})) return false;
        if (reach != ContactCache::no_ball && !(reach >= 0 && reach <= far_range)) return false;
    }
    return true;
}

bool particles_fine(const Body& body) {
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        const double mass = body.particles.mass[p], inverse = body.particles.inverse_mass[p];
        if (!(mass >= least_mass && mass <= range && (inverse == 0 || inverse == 1 / mass))) return false;
    }
    const auto is_force = [](Vec3 force) { return is_within(range, force); };
    const auto is_number = [](float value) { return is_finite(value); };
    return all(body.particles.position, is_place) && all(body.particles.velocity, is_speed) &&
           all(body.particles.force, is_force) && all(body.particles.radius, is_amount) &&
           all(body.cloth.sheet.rest_position, is_place) && all(body.contacts.self.placed, is_place) &&
           all(body.history.start, is_earlier_place) && all(body.history.start_velocity, is_speed) &&
           is_time(body.history.earlier_step) && all(body.contacts.points, is_contact_point) &&
           all(body.contacts.stuck, [](uint32_t stuck) { return stuck <= 1; }) &&
           all(body.cloth.state.moved, is_number) && all(body.cloth.state.velocity_before, is_number) &&
           are_search_balls_valid(body.cloth.cache.search_balls) && is_place(body.cloth.state.origin) &&
           is_finite_amount(body.cloth.balance.lost) && is_collapsed_time(body.cloth.yielding.collapsed_time) &&
           is_amount(body.sleep.rest_time) && is_finite_amount(body.sleep.settling) &&
           is_within(range, body.sleep.drift) && fine_box(body.sleep.box);
}

bool air_fine(const Air& air) {
    const gphys_wind& wind = air.wind;
    return is_within(range, widen(wind.velocity)) && is_amount(wind.density) && is_amount(wind.drag) &&
           is_amount(wind.lift) && all(air.velocity, [](Vec3 velocity) { return is_within(range, velocity); });
}

bool impulses_fine(const Contacts& contacts) {
    const auto finite_one = [](const ModelImpulse& given) {
        return is_finite(given.linear) && is_finite(given.angular);
    };
    const auto out_of_order = [](const ModelImpulse& a, const ModelImpulse& b) { return a.model >= b.model; };
    return all(contacts.impulses, finite_one) && std::adjacent_find(contacts.impulses.begin(), contacts.impulses.end(),
                                                                    out_of_order) == contacts.impulses.end();
}

bool attachments_fine(const Body& body) {
    for (size_t i = 0; i < body.constraints.attachments.size(); ++i) {
        const Attachment& a = body.constraints.attachments[i];
        if (a.particle >= body.particles.size() || !body.particles.pinned(a.particle) ||
            !is_within(farthest_in_model, a.local) || !is_earlier_place(a.begin) || !is_earlier_place(a.end)) {
            return false;
        }
        if (i > 0 && a.particle <= body.constraints.attachments[i - 1].particle) return false;
    }
    return true;
}

bool constraints_fine(const Body& body) {
    if (body.constraints.ids.defect()) return false;
    for (const uint32_t slot : body.constraints.ids) {
        const DistanceConstraint& c = body.constraints.by_slot[slot];
        if (c.a >= body.particles.size() || c.b >= body.particles.size() || c.a == c.b) return false;
        if (!is_length(c.rest) || !is_amount(c.compliance) || !is_amount(c.damping) || c.limit > 1) return false;
    }
    return true;
}

/// Each of a constraint, in their order.
bool length_changes_fine(const Constraints& constraints) {
    for (size_t i = 0; i < constraints.length_changes.size(); ++i) {
        const LengthChange& change = constraints.length_changes[i];
        if (change.slot >= constraints.ids.slots() || !is_length(change.from) ||
            !constraints.ids.live(static_cast<uint32_t>(change.slot))) {
            return false;
        }
        if (i > 0 && change.slot <= constraints.length_changes[i - 1].slot) return false;
    }
    return true;
}

/// Contiguous from the beginning to the end of the arrays; those of a colour sorted by length, longest first.
bool chains_fit(const Plan& plan) {
    uint64_t particles = 0, links = 0;
    for (const Chain& chain : plan.chains) {
        if (chain.first_particle != particles || chain.first_link != links || chain.link_count == 0) return false;
        particles += uint64_t{chain.link_count} + 1;
        links += chain.link_count;
        if (particles > plan.particles.size() || links > plan.slots.size()) return false;
    }
    return particles == plan.particles.size() && links == plan.slots.size();
}

bool colours_fit(const Plan& plan) {
    if (plan.colours.empty() || plan.colours.front() != 0 || plan.colours.back() != plan.chains.size() ||
        !std::is_sorted(plan.colours.begin(), plan.colours.end())) {
        return false;
    }
    const auto longer = [](const Chain& a, const Chain& b) { return a.link_count > b.link_count; };
    for (size_t colour = 0; colour + 1 < plan.colours.size(); ++colour) {
        const auto first = plan.chains.begin() + plan.colours[colour];
        if (!std::is_sorted(first, plan.chains.begin() + plan.colours[colour + 1], longer)) return false;
    }
    return true;
}

/// Each constraint is in exactly one chain, between the particles that it joins.
bool chains_lead_along_constraints(const Body& body) {
    const Plan& plan = body.plan;
    if (plan.slots.size() != body.constraints.ids.size()) return false;
    Vector<uint8_t> used(body.constraints.ids.slots(), 0, plan.slots.get_allocator());
    for (const Chain& chain : plan.chains) {
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const uint32_t slot = plan.slots[chain.first_link + i];
            if (slot >= body.constraints.ids.slots() || !body.constraints.ids.live(slot) || used[slot]) return false;
            used[slot] = 1;
            const uint32_t from = plan.particles[chain.first_particle + i];
            const uint32_t to = plan.particles[chain.first_particle + i + 1];
            const DistanceConstraint& c = body.constraints.by_slot[slot];
            if (!(c.a == from && c.b == to) && !(c.b == from && c.a == to)) return false;
        }
    }
    return true;
}

/// Chains that are solved together have no particle in common, and are of one kind.
bool colours_are_independent(const Body& body) {
    const Plan& plan = body.plan;
    Vector<uint32_t> colour_of(body.particles.size(), 0, plan.slots.get_allocator());  // the last colour, from 1 on
    for (uint32_t colour = 1; colour < plan.colours.size(); ++colour) {
        const uint32_t begin = plan.colours[colour - 1], end = plan.colours[colour];
        for (uint32_t i = begin; i < end; ++i) {
            const Chain& chain = plan.chains[i];
            const uint64_t kind = body.constraints.by_slot[plan.slots[plan.chains[begin].first_link]].limit;
            for (uint32_t j = 0; j <= chain.link_count; ++j) {
                uint32_t& last = colour_of[plan.particles[chain.first_particle + j]];
                if (last == colour) return false;
                last = colour;
                if (j < chain.link_count && body.constraints.by_slot[plan.slots[chain.first_link + j]].limit != kind)
                    return false;
            }
        }
    }
    return true;
}

bool is_reach_limit(const Particles& particles, const ReachLimit& limit) {
    return limit.particle < particles.size() && limit.anchor < particles.size() && !particles.pinned(limit.particle) &&
           particles.pinned(limit.anchor) && limit.distance >= 0 && limit.distance <= far_range * IdTable::capacity;
}

bool is_placed(const PlacedModel& model) {
    gphys_transform world = model.world;
    world.position = {0, 0, 0};
    return is_earlier_place(widen(model.world.position)) && is_speed(widen(model.velocity)) && !defect(world);
}

}  // namespace

const char* defect_of_globals(const SolverState& state) {
    const SolverSettings& settings = state.settings;
    const auto is_substeps = [](uint32_t count) { return count >= 1 && count <= most_substeps; };
    if (!is_within(range, settings.gravity) || !is_within(range, state.origin) || !is_amount(settings.sleep_speed) ||
        !is_amount(settings.sleep_strain) || !is_amount(settings.sleep_time) || !is_amount(settings.max_strain) ||
        !is_amount(settings.tolerance) || !is_substeps(settings.substeps) || !is_substeps(settings.max_substeps) ||
        settings.max_steps < 1 || !(settings.fixed_step >= shortest_step && settings.fixed_step <= longest_step) ||
        !(state.accumulator >= 0 && state.accumulator <= settings.fixed_step)) {
        return "words: a setting is out of range";
    }
    if (state.ids.defect()) return "words: the ids of the bodies contradict each other";
    const auto out_of_order = [](const PlacedModel& a, const PlacedModel& b) { return !(a < b); };
    if (std::adjacent_find(state.near_models.begin(), state.near_models.end(), out_of_order) !=
            state.near_models.end() ||
        !all(state.near_models, is_placed)) {
        return "words: the models near the bodies are out of order or out of range";
    }
    return nullptr;
}

const char* defect_of_joints(const SolverState& state) {
    if (state.joint_ids.defect() || state.joints.size() != state.joint_ids.slots()) {
        return "words: the ids of the joints contradict each other";
    }
    const auto is_end = [&](uint32_t body, uint32_t particle) {
        return body < state.ids.slots() && state.ids.live(body) && particle < state.bodies[body].particles.size();
    };
    for (const uint32_t slot : state.joint_ids) {
        const Joint& j = state.joints[slot];
        if (!is_end(j.body_a, j.particle_a) || !is_end(j.body_b, j.particle_b) || j.body_a == j.body_b ||
            !is_length(j.rest) || !is_amount(j.compliance) || !is_finite(j.tension)) {
            return "words: a joint is out of range";
        }
    }
    return nullptr;
}

const char* defect(const Body& body) {
    if (!sizes_agree(body)) return "words: the arrays of a body have different lengths";
    if (!settings_fine(body)) return "words: a setting of a body is out of range";
    if (!particles_fine(body)) return "words: a particle of a body is out of range";
    const Volume& volume = body.cloth.volume;
    if (!is_finite_amount(volume.rest) || !is_amount(volume.compliance) || !is_finite(volume.pressure)) {
        return "words: the volume of a body is out of range";
    }
    if (!air_fine(body.air)) return "words: the wind of a body is out of range";
    if (!impulses_fine(body.contacts)) return "words: an impulse is out of range";
    if (!attachments_fine(body)) return "words: an attachment is out of range";
    if (!constraints_fine(body) || !length_changes_fine(body.constraints)) return "words: a constraint is out of range";
    if (!all(body.cloth.sheet.triangles, [&](uint32_t p) { return p < body.particles.size(); }))
        return "words: a triangle of a body is out of range";
    return nullptr;
}

const char* defect_of_targets(const Body& body) {
    const auto is_distance = [](double value) { return is_amount(value) || value == infinity; };
    const auto is_normal = [](Vec3 normal) { return is_within(range, normal) && normal != Vec3{}; };
    const auto is_target = [&](const AnimationTarget& target) {
        return is_earlier_place(target.from) && is_earlier_place(target.to) && is_distance(target.max_distance) &&
               is_distance(target.backstop) && target.fresh <= 1 && target.carries == 0 &&
               (target.backstop == infinity || (is_normal(target.from_normal) && is_normal(target.to_normal)));
    };
    const bool fine = body.targets.all.size() == body.particles.size() && all(body.targets.all, is_target);
    return fine ? nullptr : "words: an animation target is out of range";
}

const char* defect_of_friction_factors(const Body& body) {
    const Vector<double>& factors = body.contacts.friction_factor;
    const bool fine = factors.size() == body.particles.size() && all(factors, is_amount);
    return fine ? nullptr : "words: a friction factor is out of range";
}

const char* defect_of_breaking_forces(const Body& body) {
    const Vector<double>& forces = body.breaking.force;
    const auto is_force = [](double force) { return force > 0 && (is_amount(force) || force == infinity); };
    const bool fine = forces.size() == body.constraints.by_slot.size() && all(forces, is_force);
    return fine ? nullptr : "words: a breaking force is out of range";
}

const char* defect_of_bending(const Body& body) {
    const double stiffness = body.rope.bending.stiffness;
    return stiffness > 0 && is_amount(stiffness) ? nullptr : "words: a bending stiffness is out of range";
}

const char* defect_of_clusters(const Body& body) {
    constexpr const char* wrong = "words: a cluster is out of range";
    const Clusters& clusters = body.cloth.clusters;
    if (clusters.ids.defect() || clusters.members.size() > IdTable::capacity) return wrong;
    constexpr uint32_t none = 0xffffffff;
    Vector<uint32_t> last_of(body.particles.size(), none,
                             clusters.members.get_allocator());  // by particle: its cluster
    uint32_t found = 0;
    for (size_t i = 0; i < clusters.members.size(); ++i) {
        const ClusterMember& member = clusters.members[i];
        if (member.cluster >= clusters.ids.slots() || !clusters.ids.live(member.cluster) ||
            member.particle >= body.particles.size() || !is_within(far_range, member.rest)) {
            return wrong;
        }
        const bool first = i == 0 || clusters.members[i - 1].cluster != member.cluster;
        if (i > 0 && clusters.members[i - 1].cluster > member.cluster) return wrong;
        const bool last = i + 1 == clusters.members.size() || clusters.members[i + 1].cluster != member.cluster;
        if (last_of[member.particle] == member.cluster || (first && last)) return wrong;
        last_of[member.particle] = member.cluster;
        found += first;
    }
    return found == clusters.ids.size() ? nullptr : wrong;
}

const char* defect_of_plan(const Body& body) {
    constexpr const char* wrong = "words: the plan of a body does not follow from its constraints";
    const Plan& plan = body.plan;
    if (!plan.chains_current) return nullptr;
    if (plan.edits > Plan::most_edits || plan.method != method_of(body)) return wrong;
    if (plan.method == GPHYS_SOLVE_DIRECT) {
        const bool fine = body.rope.tension.size() == body.constraints.ids.size() &&
                          all(body.rope.tension, [](double tension) { return is_finite(tension); });
        return fine ? nullptr : wrong;
    }
    if (plan.method == GPHYS_SOLVE_FREE) return nullptr;
    const bool fine =
        all(plan.particles, [&](uint32_t p) { return p < body.particles.size(); }) && chains_fit(plan) &&
        colours_fit(plan) && chains_lead_along_constraints(body) && colours_are_independent(body) &&
        all(body.cloth.reach.limits, [&](const ReachLimit& limit) { return is_reach_limit(body.particles, limit); });
    return fine ? nullptr : wrong;
}

}  // namespace gphys
