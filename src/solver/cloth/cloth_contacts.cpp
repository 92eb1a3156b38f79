// Contact planes and friction of cloth, in the order of a substep: search; active planes before the chains; friction
// and projection after them; velocities; particles that have left their balls (cloth_contacts.h).
#include "solver/cloth/cloth_contacts.h"

#include "solver/cloth/cloth_targets.h"
#include "solver/cloth/clusters.h"
#include "solver/cloth/contact_cache.h"
#include "solver/cloth/contact_search.h"
#include "solver/contact/collision_memory.h"
#include "solver/contact/friction.h"
#include "solver/quads.h"

namespace gphys {
namespace {

/// Adds up the impulses of particles on models: the velocity that a contact takes from a particle, times its mass.
class LostVelocity {
public:
    LostVelocity(Body& body, const CollisionContext& around)
        : state_(body.cloth.state),
          radius_(body.particles.radius),
          contacts_(body.cloth.contacts),
          impulses_(body.contacts.impulses),
          around_(around) {}

    void add(ClothContact& n, Vec3 velocity) {
        const ContactPlane& plane = n.planes[n.active_plane];
        if (n.impulse_model != plane.model) {
            flush(n);
            n.impulse_model = plane.model;
        }
        const size_t i = 4 * size_t{n.particle};
        const Vec3 moment = cross(get(&state_.at[i]) - plane.normal * radius_[n.particle], velocity);
        n.impulse += velocity;
        n.moment += moment;
        contacts_.impulse += velocity * state_.acceleration[i + 3];
        contacts_.moment += moment * state_.acceleration[i + 3];
    }
    /// Adds the impulse of a particle to the model that it was last in contact with.
    void flush(ClothContact& n) {
        if (n.impulse_model == 0) return;
        const double mass = state_.average_mass * state_.acceleration[4 * size_t{n.particle} + 3];
        add_impulse(impulses_, around_, n.impulse_model, state_.origin, n.impulse * mass, n.moment * mass);
        n.impulse_model = 0;
        n.impulse = n.moment = {};
    }

private:
    const ClothState& state_;
    const Vector<double>& radius_;
    ClothContacts& contacts_;
    Vector<ModelImpulse>& impulses_;
    const CollisionContext& around_;
};

/// Moves the contact planes of moving models to their places at the end of the substep.
void move_planes(ClothContacts& contacts, const ClothState& state, const Vector<MovingCollider>& moving_colliders) {
    if (moving_colliders.empty()) return;
    for (ClothContact& n : contacts.candidates) {
        bool moved = false;
        for (uint32_t i = 0; i < n.plane_count; ++i) {
            ContactPlane& plane = n.planes[i];
            if (plane.moving_collider == ContactPlane::unmoved) continue;
            const RigidMotion& rigid_motion = moving_colliders[plane.moving_collider].substep_motion;
            plane.normal = rigid_motion.rotation * plane.normal;
            plane.offset += dot(plane.normal, rigid_motion.shift);
            moved = true;
        }
        if (moved && n.plane_count > 1) make_room(n, get(&state.at[4 * size_t{n.particle}]));
    }
}

bool is_on_moving_model(const ClothContact& n) {
    return n.active_plane >= 0 && n.planes[n.active_plane].moving_collider != ContactPlane::unmoved;
}

/// Lists in `escaped` the particles that may leave their balls within h seconds; returns how many. `fall`: the speed
/// that gravity adds meanwhile.
uint32_t list_leaving(ClothContacts& contacts, const ClothState& state, double h, double fall) {
    return cloth_kernels(chosen_isa())
        .list_leaving(state.at.data(), state.velocity.data(), contacts.balls.data(), state.particles,
                      static_cast<float>(h), static_cast<float>(fall), contacts.escaped.data());
}

/// Projects the particle out of its contact planes, and marks the active ones. Returns the first of them, or -1.
int32_t push_out(ClothContact& n, float* at) {
    // Projecting out of one plane may lead into another. For two planes whose normals are at most a right angle apart,
    // one pass suffices. In a narrower crease the projections converge slowly.
    constexpr int most_passes = 8;
    int32_t first = -1;
    for (int pass = 0; pass < most_passes; ++pass) {
        bool moved = false;
        for (uint32_t i = 0; i < n.plane_count; ++i) {
            const double depth = n.planes[i].offset - dot(n.planes[i].normal, get(at));
            if (depth <= 0) continue;
            put(at, get(at) + n.planes[i].normal * depth);
            n.normal_displacement += depth;
            n.active_planes |= 1u << i;
            if (first < 0) first = static_cast<int32_t>(i);
            moved = true;
        }
        if (!moved || n.plane_count == 1) break;
    }
    return first;
}

}  // namespace

uint32_t deepest_plane(const ClothContact& n, Vec3 at, double& depth) {
    uint32_t best = 0;
    depth = -infinity;
    for (uint32_t i = 0; i < n.plane_count; ++i) {
        const double d = n.planes[i].offset - dot(n.planes[i].normal, at);
        if (d > depth) depth = d, best = i;
    }
    return best;
}

void make_room(ClothContact& n, Vec3 at) {
    // `at` may be a predicted position, behind planes that approach: what closes faster takes more of the thickness.
    // Planes that face each other within 60 degrees: in a wider wedge a few projections push a particle out.
    constexpr double facing = -1.0 / 2;
    for (uint32_t i = 0; i < n.plane_count; ++i) {
        for (uint32_t k = i + 1; k < n.plane_count; ++k) {
            ContactPlane &a = n.planes[i], &b = n.planes[k];
            if (a.model == b.model || dot(a.normal, b.normal) > facing) continue;
            const double missing = a.offset - dot(a.normal, at) + b.offset - dot(b.normal, at);
            if (missing <= 0) continue;
            const double from_b = std::min(b.thickness, missing - std::min(a.thickness, missing / 2)),
                         from_a = std::min(a.thickness, missing - from_b);
            a.offset -= from_a;
            b.offset -= from_b;
            a.thickness -= from_a;
            b.thickness -= from_b;
        }
    }
}

Vec3 place_on_plane(const ClothContact& n, const Vector<MovingCollider>& moving_colliders, Vec3 start) {
    const uint32_t moving_collider = n.planes[n.active_plane].moving_collider;
    if (moving_collider == ContactPlane::unmoved) return start;
    Vec3 place = moving_colliders[moving_collider].substep_motion.apply(start);
    if (n.is_even) {
        const Vec3 normal = n.planes[n.active_plane].normal, lag = moving_colliders[moving_collider].lag;
        place += lag - normal * dot(lag, normal);
    }
    float rounded[3];
    put(rounded, place);
    return get(rounded);
}

bool follows_evenly(const Body& body, uint32_t particle, const ContactPlane& plane, const CollisionContext& around,
                    Vec3 gravity) {
    if (plane.moving_collider == ContactPlane::unmoved || !body.cloth.clusters.has(particle)) return false;
    const Vec3 jump = body.cloth.moving_colliders[plane.moving_collider].jump;
    const Vec3 along = jump - plane.normal * dot(jump, plane.normal);
    return length(along) <= friction_coefficients(body, particle).kinetic * length(gravity) * around.step_time;
}

void ClothContacts::reserve(uint32_t particles, size_t floats) {
    candidates.reserve(particles);
    active.reserve(particles);
    escaped.resize(particles);
    candidate_of.resize(particles);
    balls.resize(floats);
    saved.resize(floats);
}

namespace {

/// Leaves the candidates as if the searches of all particles that have a ball were repeated now, as they are after a
/// snapshot: sums over candidates depend on their order.
void put_in_order(ClothContacts& contacts, const Vector<float>& search_balls) {
    Vector<ClothContact>& all = contacts.candidates;
    Vector<uint32_t>& candidate_of = contacts.candidate_of;
    const auto is_found_anew = [&](const ClothContact& n) {
        return n.plane_count == 0 || search_balls[4 * size_t{n.particle} + 3] < 0;
    };
    all.erase(std::remove_if(all.begin(), all.end(), is_found_anew), all.end());
    std::fill(candidate_of.begin(), candidate_of.end(), ClothContacts::none);
    for (uint32_t i = 0; i < all.size(); ++i) candidate_of[all[i].particle] = i;
    uint32_t next = 0;
    for (uint32_t& place : candidate_of) {
        if (place == ClothContacts::none) continue;
        if (place != next) {
            std::swap(all[place], all[next]);
            candidate_of[all[place].particle] = place;
            place = next;
        }
        ++next;
    }
}

}  // namespace

void search_cloth_contacts(Body& body, const CollisionContext& around, Vec3 gravity) {
    const Particles& particles = body.particles;
    const ClothState& state = body.cloth.state;
    ClothContacts& contacts = body.cloth.contacts;
    Vector<float>& search_balls = body.cloth.cache.search_balls;
    std::fill(body.cloth.in_chains.normals.begin(), body.cloth.in_chains.normals.end(), 0.0f);
    contacts.penetrating = false;
    find_moving_colliders(body.cloth.moving_colliders, state.origin, body.steady.search_box, body.settings.layers,
                          around);
    ContactSearch& search = around.memory->search.emplace(around, body, gravity, around.step_time);
    const Reuse reuse = reusable_contacts(body, around);
    if (reuse == Reuse::nothing) search_balls.assign(4 * size_t{particles.size()}, ContactCache::no_ball);
    if (reuse == Reuse::planes) {
        for (ClothContact& n : contacts.candidates) n.rest();
        put_in_order(contacts, search_balls);
    } else {
        contacts.candidates.clear();
        std::fill(contacts.candidate_of.begin(), contacts.candidate_of.end(), ClothContacts::none);
        std::fill(contacts.balls.begin(), contacts.balls.end(), 0.0f);
        uint32_t count = 0;
        for (uint32_t p = 0; p < particles.size() && reuse == Reuse::balls; ++p) {
            if (search_balls[4 * size_t{p} + 3] >= 0 && !particles.pinned(p)) contacts.escaped[count++] = p;
        }
        search.repeat(contacts.escaped.data(), count);
    }
    const double fall = around.step_time / 2 * length(gravity);
    const uint32_t count = list_leaving(contacts, state, around.step_time, fall);
    search.run(contacts.escaped.data(), count);
    push_out_clusters(body);
}

void search_ahead(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    ClothContacts& contacts = body.cloth.contacts;
    const uint32_t count = list_leaving(contacts, body.cloth.state, h, h * length(gravity));
    if (count == 0) return;
    around.memory->search.emplace(around, body, gravity, around.step_time * (1 - around.begin))
        .run(contacts.escaped.data(), count);
}

namespace {

/// The speed of approach at the time of impact; 0 if it is too low to bounce. `place`: the start of the particle,
/// carried along by the plane. `predicted`: its speed of approach in this substep. Gravity adds speed up to the plane,
/// not behind it.
double impact_speed(const ClothContact& n, const ClothState& state, Vec3 place, double predicted,
                    double bounce_threshold) {
    const ContactPlane& plane = n.planes[n.active_plane];
    const size_t i = 4 * size_t{n.particle};
    const double drop = std::max(0.0, dot(plane.normal, place) - plane.offset);
    const double of_plane = dot(place - get(&state.start[i]), plane.normal);
    if (predicted <= bounce_threshold) return 0;
    if (of_plane != 0) return predicted;
    const double speed = -dot(get(&state.velocity[i]), plane.normal);
    const double pull = -dot(get(&state.acceleration[i]), plane.normal);
    return speed > 0 ? std::sqrt(std::max(0.0, speed * speed + 2 * pull * drop)) : predicted;
}

/// Of the end of the substep, without constraints.
Vec3 predicted_velocity(const ClothState& state, size_t i, const TimeScheme& scheme, double drag) {
    return (scheme.from_history(get(&state.velocity[i]), get(&state.velocity_before[i])) +
            get(&state.acceleration[i]) * scheme.h) *
           drag;
}

}  // namespace

void find_active_planes(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme) {
    ClothState& state = body.cloth.state;
    const double h = scheme.h, rate = 1 / h, drag = scheme.drag(body.settings.damping);
    ClothContacts& contacts = body.cloth.contacts;
    ChainContacts& in_chains = body.cloth.in_chains;
    Vector<MovingCollider>& moving_colliders = body.cloth.moving_colliders;
    contacts.active.clear();
    contacts.has_moving_model = false;
    advance_moving_colliders(moving_colliders, state.origin, around);
    move_planes(contacts, state, moving_colliders);
    // A particle is active if gravity moves it to its plane within the substep.
    const double near = length(gravity) * h * h;
    for (uint32_t number = 0; number < contacts.candidates.size(); ++number) {
        ClothContact& n = contacts.candidates[number];
        const size_t i = 4 * size_t{n.particle};
        float* at = &state.at[i];
        const bool was_active = n.active_plane >= 0;
        const Vec3 corrected = n.corrected;
        const double pressed = n.pressed, pressed_friction = n.pressed_friction;
        n.corrected = {};
        n.pressed = n.pressed_friction = 0;
        n.active_plane = -1;
        n.is_even = false;
        double depth;
        const uint32_t plane = deepest_plane(n, get(at), depth);
        if (depth < -near) continue;
        const double normal_before = was_active ? n.normal_total : 0;
        const Vec3 start = get(&state.start[i]);
        contacts.active.push_back(number);
        n.normal_displacement = 0;
        n.normal_total = 0;
        n.cluster_impulse = 0;
        n.pressed = pressed;
        n.predicted_velocity = predicted_velocity(state, i, scheme, drag) + corrected * (scheme.next * rate);
        n.active_plane = static_cast<int32_t>(plane);
        n.active_planes |= 1u << plane;
        contacts.has_moving_model = contacts.has_moving_model || is_on_moving_model(n);
        const Vec3 normal = n.planes[plane].normal;
        n.is_even = follows_evenly(body, n.particle, n.planes[plane], around, gravity);
        const Vec3 place = place_on_plane(n, moving_colliders, start),
                   moved = get(at) - place;  // relative to the moving plane
        const double away = dot(moved, normal);
        n.approach = impact_speed(n, state, place, -away * rate, find_bounce_threshold(gravity, h));
        const Vec3 along = moved - normal * away;
        const Friction friction = friction_coefficients(body, n.particle);
        n.rest_slip = -1;
        if (friction.sticks()) {
            const Vec3 sliding = get(&state.velocity[i]) - (place - start) * rate;
            if (rests(body, n.particle, sliding, gravity)) n.rest_slip = length(sliding) * h;
        }
        put(&in_chains.pulls[i], {});
        put(&in_chains.normals[i], normal);
        // The pull of links against the plane is known from the last substep.
        // A cluster finds the normal force and the friction of its particles together.
        const double most = friction.kinetic * (std::max(normal_before, depth) + pressed),
                     squared = length_squared(along),
                     hold = body.cloth.clusters.has(n.particle) ? 0 : std::max(0.0, most - pressed_friction);
        if (squared > hold * hold) {
            n.friction_before = pressed_friction + hold;
            if (hold > 0) put(at, get(at) - along * (hold / std::sqrt(squared)));
        } else {
            n.friction_before = pressed_friction + std::sqrt(squared);
            put(at, get(at) - along);
        }
        push_out(n, at);
        in_chains.normals[i + 3] = static_cast<float>(n.normal_displacement / at[3]);
    }
}

void activate_plane(Body& body, ClothContact& n, int32_t plane, const TimeScheme& scheme) {
    const size_t i = 4 * size_t{n.particle};
    n.active_plane = plane;
    n.active_planes |= 1u << plane;
    n.normal_displacement = n.normal_total = n.friction_before = n.cluster_impulse = n.approach = 0;
    n.pressed = n.pressed_friction = 0;
    n.rest_slip = -1;
    n.predicted_velocity = predicted_velocity(body.cloth.state, i, scheme, scheme.drag(body.settings.damping));
    put(&body.cloth.in_chains.pulls[i], {});
}

namespace {

/// Friction: moves the particle back towards its place on the contact plane as far as Coulomb's law allows.
void apply_friction(ClothContact& n, Vec3 pull, const Friction& friction, double restitution, Vec3 place, float* at) {
    const Vec3 normal = n.planes[n.active_plane].normal, moved = get(at) - place;
    n.normal_total = std::max(0.0, n.normal_displacement - dot(pull, normal) * at[3]);
    const Vec3 along = moved - normal * dot(moved, normal);
    const double pressing = n.normal_total + n.pressed;
    const double squared = length_squared(along), hold = friction.kinetic * pressing - n.friction_before;
    const auto within = [&](double most) { return most >= 0 && squared <= most * most; };
    n.held =
        within(hold) || (n.rest_slip >= 0 && within(n.rest_slip + friction.at_rest * pressing - n.friction_before));
    if (n.held) {
        // Of a particle that bounces, friction holds the tangential motion only.
        put(at, restitution * n.approach > 0 ? get(at) - along : place);
    } else if (hold > 0) {
        put(at, get(at) - along * (hold / std::sqrt(squared)));
    }
}

}  // namespace

void save_positions(ClothContacts& contacts, const ClothState& state) {
    std::copy(state.at.begin(), state.at.end(), contacts.saved.begin());
}

namespace {

/// Notes that a model has displaced a particle, if it is one of a cluster and that is more than rounding.
void note_pushed(Body& body, uint32_t particle, Vec3 displacement) {
    if (!body.cloth.clusters.has(particle)) return;
    const double margin = skin(body.particles.radius[particle], {});
    if (length_squared(displacement) > margin * margin) body.cloth.contacts.clusters_pushed = true;
}

}  // namespace

void resolve_contacts(Body& body) {
    ClothState& state = body.cloth.state;
    ClothContacts& contacts = body.cloth.contacts;
    ChainContacts& in_chains = body.cloth.in_chains;
    contacts.active.clear();
    for (uint32_t number = 0; number < contacts.candidates.size(); ++number) {
        ClothContact& n = contacts.candidates[number];
        const size_t i = 4 * size_t{n.particle};
        float* at = &state.at[i];
        const bool before = n.active_plane >= 0;
        const Vec3 limited = get(at);
        if (!before) {
            double depth;
            deepest_plane(n, limited, depth);
            if (depth <= 0) continue;
            n.normal_displacement = n.pressed = n.approach = 0;
            put(&in_chains.pulls[i], {});
        }
        contacts.active.push_back(number);
        const int32_t pushing = push_out(n, at);
        if (!before) n.active_plane = pushing;
        apply_friction(n, get(&in_chains.pulls[i]), friction_coefficients(body, n.particle), body.settings.restitution,
                       place_on_plane(n, body.cloth.moving_colliders, get(&state.start[i])), at);
        n.pressed = 0;
        // Moving back may lead into another contact plane.
        if (n.plane_count > 1) push_out(n, at);
        note_pushed(body, n.particle, get(at) - limited);
        put(&in_chains.normals[i], {});
        contacts.has_moving_model = contacts.has_moving_model || is_on_moving_model(n);
        // In metres: the displacement by chains and limits, or by contact planes.
        n.moved = before ? get(&in_chains.pulls[i]) * at[3] + (limited - get(&contacts.saved[i])) : limited - get(at);
        n.active_before_chains = before;
    }
}

/// Links, limits and contact planes have changed the predicted velocity. The part of the contact planes is an impulse
/// on their models.
void add_contact_impulses(Body& body, const CollisionContext& around, double rate) {
    const ClothState& state = body.cloth.state;
    ClothContacts& contacts = body.cloth.contacts;
    LostVelocity lost(body, around);
    for (const uint32_t number : contacts.active) {
        ClothContact& n = contacts.candidates[number];
        const Vec3 velocity = get(&state.velocity[4 * size_t{n.particle}]);
        const Vec3 pulled = n.moved * rate;
        lost.add(n, n.active_before_chains ? n.predicted_velocity + pulled - velocity : pulled);
    }
}

void solve_contact_velocities(Body& body, const CollisionContext& around, double h) {
    ClothState& state = body.cloth.state;
    ClothContacts& contacts = body.cloth.contacts;
    LostVelocity lost(body, around);
    const double rate = 1 / h, restitution = body.settings.restitution;
    for (const uint32_t number : contacts.active) {
        ClothContact& n = contacts.candidates[number];
        const size_t i = 4 * size_t{n.particle};
        float* velocity = &state.velocity[i];
        const Vec3 start = get(&state.start[i]), place = place_on_plane(n, body.cloth.moving_colliders, start);
        const Vec3 of_plane = (place - start) * rate, normal = n.planes[n.active_plane].normal;
        const double wanted = restitution * n.approach;
        if ((restitution > 0 || n.approach > 0) && bounces_as_whole(body, n.particle)) {
            ClusterImpact impact;
            impact.particle = n.particle;
            impact.model = n.planes[n.active_plane].model;
            impact.hits = n.approach > 0;
            impact.normal = normal;
            impact.target = dot(of_plane, normal) + wanted;
            impact.surface_velocity = of_plane;
            impact.friction = friction_coefficients(body, n.particle).kinetic;
            body.cloth.clusters.impacts.push_back(impact);
            if (n.approach > 0) continue;
        }
        if (get(&state.at[i]) == place && wanted == 0) {
            lost.add(n, get(velocity) - of_plane);
            put(velocity, of_plane);
            continue;
        }
        const double away = dot(get(velocity) - of_plane, normal);
        if (away >= wanted) continue;
        lost.add(n, normal * (away - wanted));
        put(velocity, get(velocity) + normal * (wanted - away));
    }
}

void stop_undone_motion(Body& body, const CollisionContext& around, double h) {
    ClothState& state = body.cloth.state;
    ClothContacts& contacts = body.cloth.contacts;
    LostVelocity lost(body, around);
    for (const uint32_t number : contacts.active) {
        ClothContact& n = contacts.candidates[number];
        const size_t i = 4 * size_t{n.particle};
        const Vec3 back = get(&state.at[i]) - get(&contacts.saved[i]), start = get(&state.start[i]);
        const Vec3 velocity = get(&state.velocity[i]);
        const double square = length_squared(back);
        const Vec3 of_plane = (place_on_plane(n, body.cloth.moving_colliders, start) - start) / h;
        const double against = dot(of_plane - velocity, back);
        if (against <= 0 || square == 0) continue;
        const Vec3 slowed = velocity + back * std::min(1 / h, against / square);
        lost.add(n, velocity - slowed);
        put(&state.velocity[i], slowed);
    }
}

bool is_held(const ClothContacts& contacts, uint32_t particle) {
    const uint32_t number = contacts.candidate_of[particle];
    if (number == ClothContacts::none || contacts.penetrating) return false;
    const ClothContact& n = contacts.candidates[number];
    return n.active_plane >= 0 && n.held && !is_on_moving_model(n);
}

void displace(ClothState& state, ClothContacts& contacts, const AnimationTargets& targets, uint32_t particle,
              Vec3 displacement, bool collides) {
    float* const at = &state.at[4 * size_t{particle}];
    put(at, get(at) + displacement);
    if (!targets.empty()) stay_near_target(targets, state, particle);
    if (collides) push_out_of_planes(contacts, state, particle);
}

void relax_links_in_contact(Body& body) {
    // Relative to the length: smaller errors are invisible and are left alone.
    constexpr double slack = 5e-3;
    ClothState& state = body.cloth.state;
    ClothContacts& contacts = body.cloth.contacts;
    const auto is_active = [&](uint32_t p) {
        const uint32_t place = contacts.candidate_of[p];
        return place != ClothContacts::none && contacts.candidates[place].active_plane >= 0;
    };
    for (const uint32_t slot : body.constraints.ids) {
        const DistanceConstraint& link = body.constraints.by_slot[slot];
        if (link.compliance > 0 || !is_active(link.a) || !is_active(link.b)) continue;
        const float *a = &state.at[4 * size_t{link.a}], *b = &state.at[4 * size_t{link.b}];
        const Vec3 along = get(b) - get(a);
        const double length = gphys::length(along), error = length - link.rest, mobility = double{a[3]} + b[3];
        if (std::fabs(error) <= slack * link.rest || length == 0 || mobility == 0) continue;
        if (link.limit && error < 0) continue;
        const Vec3 correction = along * (error / (length * mobility));
        displace(state, contacts, body.targets, link.a, correction * a[3], true);
        displace(state, contacts, body.targets, link.b, correction * -b[3], true);
    }
}

namespace {

/// Of a particle that has hit the model of this contact point, and would have got its velocity alone. `before`: its
/// velocity before that.
ClusterImpact impact_of_escaped(const Body& body, uint32_t particle, uint32_t contact_point, Vec3 before) {
    const ContactPoint& point = body.contacts.points[size_t{particle} * contact_points_per_particle + contact_point];
    const Vec3 after = body.particles.velocity[particle];
    ClusterImpact impact;
    impact.particle = particle;
    impact.model = point.model;
    impact.hits = true;
    impact.normal = widen(point.normal);
    impact.target = dot(after, impact.normal);
    impact.surface_velocity = after;
    impact.friction = friction_coefficients(body, particle).kinetic;
    impact.counted = after - before;
    return impact;
}

}  // namespace

void sweep_escaped(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    ClothState& state = body.cloth.state;
    ClothContacts& contacts = body.cloth.contacts;
    contacts.penetrating = false;
    const uint32_t count =
        cloth_kernels(chosen_isa())
            .list_outside(state.at.data(), contacts.balls.data(), state.particles, contacts.escaped.data());
    if (count == 0) return;
    Aabb all{body.particles.position[contacts.escaped[0]], body.particles.position[contacts.escaped[0]]};
    double longest = 0, radius = 0;
    all = {Vec3{infinity, infinity, infinity}, Vec3{-infinity, -infinity, -infinity}};
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t p = contacts.escaped[k];
        const size_t i = 4 * size_t{p};
        body.history.start[p] = state.origin + get(&state.start[i]);
        body.particles.position[p] = state.origin + get(&state.at[i]);
        body.particles.velocity[p] = get(&state.velocity[i]);
        all.min = min(all.min, min(body.history.start[p], body.particles.position[p]));
        all.max = max(all.max, max(body.history.start[p], body.particles.position[p]));
        longest = std::max(longest, length_squared(body.particles.position[p] - body.history.start[p]));
        radius = std::max(radius, body.particles.radius[p]);
    }
    const double room = 2 * radius + std::sqrt(longest);
    const Collider& collider = around.memory->collider.emplace(
        around, body, bounds(Aabb{all.min - Vec3{room, room, room}, all.max + Vec3{room, room, room}}));
    for (uint32_t k = 0; k < count && !collider.idle(); ++k) {
        const uint32_t p = contacts.escaped[k];
        const size_t i = 4 * size_t{p};
        body.contacts.held[p] = 0;
        const Vec3 at = body.particles.position[p];
        collider.slide(body, p, body.history.start[p], at - body.history.start[p], around.begin,
                       find_bounce_threshold(gravity, h));
        if (const uint32_t held = body.contacts.held[p]) {
            const Vec3 before = get(&state.velocity[i]);
            if (body.particles.velocity[p] != before && bounces_as_whole(body, p)) {
                body.cloth.clusters.impacts.push_back(impact_of_escaped(body, p, held - 1, before));
                body.particles.velocity[p] = before;
            }
            contacts.clusters_pushed = contacts.clusters_pushed || body.cloth.clusters.has(p);
            put(&state.at[i], body.particles.position[p] - state.origin);
            put(&state.velocity[i], body.particles.velocity[p]);
        }
    }
    around.memory->search.emplace(around, body, gravity, around.step_time * (1 - around.end) + h)
        .run(contacts.escaped.data(), count);
}

bool push_out_of_planes(ClothContacts& contacts, ClothState& state, uint32_t particle) {
    const uint32_t number = contacts.candidate_of[particle];
    return number != ClothContacts::none && push_out(contacts.candidates[number], &state.at[4 * size_t{particle}]) >= 0;
}

void note_correction(ClothContacts& contacts, uint32_t particle, Vec3 displacement, Vec3 push, Vec3 friction) {
    const uint32_t number = contacts.candidate_of[particle];
    if (number == ClothContacts::none) return;
    ClothContact& n = contacts.candidates[number];
    n.corrected = displacement;
    n.pressed = length(push);
    n.pressed_friction = length(friction);
}

void finish_contact(ClothContact& n, Body& body, const CollisionContext& around) {
    LostVelocity(body, around).flush(n);
    const Vec3 at = body.cloth.state.origin + get(&body.cloth.state.at[4 * size_t{n.particle}]);
    for (uint32_t i = 0; i < n.plane_count; ++i) {
        const ContactPlane& plane = n.planes[i];
        if (n.active_planes >> i & 1) {
            record_contact_point(body, n.particle, *around.scene, plane.model,
                                 at - plane.normal * body.particles.radius[n.particle], plane.normal);
        }
    }
}

void record_contact_points(Body& body, const CollisionContext& around) {
    ClothContacts& contacts = body.cloth.contacts;
    for (const uint32_t number : contacts.candidate_of) {
        if (number != ClothContacts::none) finish_contact(contacts.candidates[number], body, around);
    }
}

}  // namespace gphys
