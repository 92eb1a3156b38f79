// Contact planes and friction of cloth, in the order of a substep: search, activation before the chains, friction and
// push-out after them, velocities, and particles that have left their balls (cloth_contacts.h).
#include "solver/cloth/cloth_contacts.h"

#include "solver/cloth/cloth_targets.h"
#include "solver/cloth/contact_cache.h"
#include "solver/cloth/contact_search.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"

namespace gphys {
namespace {

/// Adds the impulse of a particle to the model that it was last in contact with.
void flush_impulse(Neighbour& n, Body& body, const CollisionContext& around) {
    if (n.impulse_model == 0) return;
    const double mass = body.cloth.average_mass * body.cloth.acceleration[4 * size_t{n.particle} + 3];
    add_impulse(body, around, n.impulse_model, body.cloth.origin, n.given * mass, n.turning * mass);
    n.impulse_model = 0;
    n.given = n.turning = {};
}

/// Moves the contact planes of moving models to their places at the end of the substep.
void carry_planes(ClothContacts& contacts) {
    if (contacts.moving_colliders.empty()) return;
    for (Neighbour& n : contacts.neighbours) {
        for (uint32_t i = 0; i < n.plane_count; ++i) {
            ContactPlane& plane = n.planes[i];
            if (plane.moving_collider == ContactPlane::unmoved) continue;
            const RigidMotion& rigid_motion = contacts.moving_colliders[plane.moving_collider].carry;
            plane.normal = rigid_motion.rotation * plane.normal;
            plane.offset += dot(plane.normal, rigid_motion.shift);
        }
    }
}

/// The position of the particle if it sticks to its place on its active contact plane.
inline Vec3 place_on_plane(const Neighbour& n, const ClothContacts& contacts, Vec3 start) {
    const uint32_t moving_collider = n.planes[n.active_plane].moving_collider;
    if (moving_collider == ContactPlane::unmoved) return start;
    float rounded[3];
    put(rounded, contacts.moving_colliders[moving_collider].carry.apply(start));
    return get(rounded);
}

bool is_pushed(const Neighbour& n) {
    return n.active_plane >= 0 && n.planes[n.active_plane].moving_collider != ContactPlane::unmoved;
}

/// The contact plane that the position is deepest behind, or nearest to.
uint32_t deepest(const Neighbour& n, Vec3 at, double& depth) {
    uint32_t best = 0;
    depth = -infinity;
    for (uint32_t i = 0; i < n.plane_count; ++i) {
        const double d = n.planes[i].offset - dot(n.planes[i].normal, at);
        if (d > depth) depth = d, best = i;
    }
    return best;
}

/// Squared distance from the centre of its ball.
float squared_from_ball(const Body& body, uint32_t p) {
    const float *ball = &body.cloth.contacts.balls[4 * size_t{p}], *at = &body.cloth.at[4 * size_t{p}];
    const float x = at[0] - ball[0], y = at[1] - ball[1], z = at[2] - ball[2];
    return x * x + y * y + z * z;
}

/// Lists in `escaped` the free particles with is(p); returns how many.
template <class Is>
uint32_t list_moving(Body& body, Is&& is) {
    uint32_t count = 0;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (is(p) && !body.particles.pinned(p)) body.cloth.contacts.escaped[count++] = p;
    }
    return count;
}

/// Projects out of all contact planes, and notes the active ones. Returns the first of them, or -1.
int32_t push_out(Neighbour& n, float* at) {
    // Projecting out of one plane may lead into another. For two planes whose normals are at most a right angle apart,
    // one pass suffices; the narrower the crease between them, the less each pass achieves.
    constexpr int most_passes = 8;
    int32_t first = -1;
    for (int pass = 0; pass < most_passes; ++pass) {
        bool moved = false;
        for (uint32_t i = 0; i < n.plane_count; ++i) {
            const double depth = n.planes[i].offset - dot(n.planes[i].normal, get(at));
            if (depth <= 0) continue;
            put(at, get(at) + n.planes[i].normal * depth);
            n.pressed += depth;
            n.active_planes |= 1u << i;
            if (first < 0) first = static_cast<int32_t>(i);
            moved = true;
        }
        if (!moved || n.plane_count == 1) break;
    }
    return first;
}

}  // namespace

void reserve_cloth_contacts(Body& body) {
    ClothContacts& contacts = body.cloth.contacts;
    contacts.neighbours.reserve(body.particles.size());
    contacts.active.reserve(body.particles.size());
    contacts.escaped.resize(body.particles.size());
    contacts.place.resize(body.particles.size());
    body.cloth.search_balls.reserve(4 * size_t{body.particles.size()});
    for (Vector<float>* values : {&contacts.balls, &contacts.normals, &contacts.pulls}) {
        values->resize(body.cloth.at.size());
    }
}

void search_cloth_contacts(Body& body, const CollisionContext& around, Vec3 gravity) {
    ClothContacts& contacts = body.cloth.contacts;
    std::fill(contacts.normals.begin(), contacts.normals.end(), 0.0f);
    contacts.sunk = false;
    find_moving_colliders(body, around);
    ContactSearch search(around, body, gravity, around.step_time);
    const Reuse kept = reuse_contacts(body, around);
    if (kept == Reuse::planes) {
        for (Neighbour& n : contacts.neighbours) n.rest();
    } else {
        contacts.neighbours.clear();
        std::fill(contacts.place.begin(), contacts.place.end(), ClothContacts::nowhere);
        std::fill(contacts.balls.begin(), contacts.balls.end(), 0.0f);
        const auto has_ball = [&](uint32_t p) { return body.cloth.search_balls[4 * size_t{p} + 3] >= 0; };
        if (kept == Reuse::balls) search.repeat(contacts.escaped.data(), list_moving(body, has_ball));
    }
    const double fall = around.step_time / 2 * length(gravity);
    search.run(contacts.escaped.data(), list_moving(body, [&](uint32_t p) {
                   const double way = around.step_time * (length(get(&body.cloth.velocity[4 * size_t{p}])) + fall);
                   return std::sqrt(double{squared_from_ball(body, p)}) + way >=
                          std::sqrt(double{contacts.balls[4 * size_t{p} + 3]});
               }));
}

void search_ahead(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    const ClothContacts& contacts = body.cloth.contacts;
    const double fall = h * length(gravity);
    const uint32_t count = list_moving(body, [&](uint32_t p) {
        const double way = h * (length(get(&body.cloth.velocity[4 * size_t{p}])) + fall);
        return std::sqrt(double{squared_from_ball(body, p)}) + way >=
               std::sqrt(double{contacts.balls[4 * size_t{p} + 3]});
    });
    ContactSearch(around, body, gravity, around.step_time * (1 - around.begin)).run(contacts.escaped.data(), count);
}

namespace {

/// The speed at which the particle hits its contact plane. It began the substep at `place`, relative to the plane, and
/// would arrive at the end with `predicted`. Counts the speed gained by falling up to the plane, but not behind it. 0
/// if it is too slow to bounce.
double impact_speed(const Neighbour& n, const Cloth& cloth, Vec3 place, double predicted, double quiet) {
    const ContactPlane& plane = n.planes[n.active_plane];
    const size_t i = 4 * size_t{n.particle};
    const double drop = std::max(0.0, dot(plane.normal, place) - plane.offset);
    const double of_plane = dot(place - get(&cloth.start[i]), plane.normal);
    if (predicted <= quiet) return 0;
    if (of_plane != 0) return predicted;
    const double speed = -dot(get(&cloth.velocity[i]), plane.normal);
    const double pull = -dot(get(&cloth.acceleration[i]), plane.normal);
    return speed > 0 ? std::sqrt(std::max(0.0, speed * speed + 2 * pull * drop)) : predicted;
}

}  // namespace

void find_active_planes(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme) {
    Cloth& cloth = body.cloth;
    const BodySettings& settings = body.settings;
    const double h = scheme.h, rate = 1 / h, drag = scheme.drag(body.settings.damping);
    ClothContacts& contacts = body.cloth.contacts;
    contacts.active.clear();
    contacts.pushed = false;
    advance_moving_colliders(body, around);
    carry_planes(contacts);
    // The displacement by gravity in a substep is near enough to be active.
    const double near = length(gravity) * h * h;
    for (uint32_t number = 0; number < contacts.neighbours.size(); ++number) {
        Neighbour& n = contacts.neighbours[number];
        const size_t i = 4 * size_t{n.particle};
        float* at = &cloth.at[i];
        const bool was_active = n.active_plane >= 0;
        n.active_plane = -1;
        double depth;
        const uint32_t plane = deepest(n, get(at), depth);
        if (depth < -near) continue;
        const double pressed_before = was_active ? n.total : 0;
        const Vec3 start = get(&cloth.start[i]);
        contacts.active.push_back(number);
        n.pressed = 0;
        n.total = 0;
        n.predicted_velocity = (scheme.from_history(get(&cloth.velocity[i]), get(&cloth.velocity_before[i])) +
                                get(&cloth.acceleration[i]) * h) *
                               drag;
        n.active_plane = static_cast<int32_t>(plane);
        n.active_planes |= 1u << plane;
        contacts.pushed = contacts.pushed || is_pushed(n);
        const Vec3 normal = n.planes[plane].normal;
        const Vec3 place = place_on_plane(n, contacts, start), moved = get(at) - place;  // relative to the moving plane
        const double away = dot(moved, normal);
        n.approach = impact_speed(n, cloth, place, -away * rate, quiet_speed(gravity, h));
        const Vec3 along = moved - normal * away;
        n.crept = -1;
        if (settings.sticks()) {
            const Vec3 sliding = get(&cloth.velocity[i]) - (place - start) * rate;
            if (rests(body, n.particle, sliding, gravity)) n.crept = length(sliding) * h;
        }
        put(&contacts.pulls[i], {});
        put(&contacts.normals[i], normal);
        // The pull of links against the plane is known from the last substep.
        const double squared = length_squared(along), hold = settings.friction * std::max(pressed_before, depth);
        if (squared > hold * hold) {
            n.slowed = hold;
            if (hold > 0) put(at, get(at) - along * (hold / std::sqrt(squared)));
        } else {
            n.slowed = std::sqrt(squared);
            put(at, get(at) - along);
        }
        push_out(n, at);
        contacts.normals[i + 3] = static_cast<float>(n.pressed / at[3]);
    }
}

namespace {

/// Friction: moves the particle back towards its place on the contact plane as far as Coulomb's law allows.
void slow_down(Neighbour& n, const ClothContacts& contacts, const BodySettings& settings, Vec3 place, float* at) {
    const Vec3 normal = n.planes[n.active_plane].normal, moved = get(at) - place;
    n.total = std::max(0.0, n.pressed - dot(get(&contacts.pulls[4 * size_t{n.particle}]), normal) * at[3]);
    const Vec3 along = moved - normal * dot(moved, normal);
    const double squared = length_squared(along), hold = settings.friction * n.total - n.slowed;
    const auto within = [&](double most) { return most >= 0 && squared <= most * most; };
    n.held = within(hold) || (n.crept >= 0 && within(n.crept + settings.static_friction * n.total - n.slowed));
    if (n.held) {
        // A bouncing particle is held tangentially only.
        put(at, settings.restitution * n.approach > 0 ? get(at) - along : place);
    } else if (hold > 0) {
        put(at, get(at) - along * (hold / std::sqrt(squared)));
    }
}

}  // namespace

void note_places(Body& body) {
    ClothContacts& contacts = body.cloth.contacts;
    for (const uint32_t number : contacts.active) {
        Neighbour& n = contacts.neighbours[number];
        n.chained = get(&body.cloth.at[4 * size_t{n.particle}]);
    }
}

void leave_planes(Body& body) {
    Cloth& cloth = body.cloth;
    ClothContacts& contacts = body.cloth.contacts;
    contacts.active.clear();
    for (uint32_t number = 0; number < contacts.neighbours.size(); ++number) {
        Neighbour& n = contacts.neighbours[number];
        const size_t i = 4 * size_t{n.particle};
        float* at = &cloth.at[i];
        const bool before = n.active_plane >= 0;
        const Vec3 limited = get(at);
        if (!before) {
            double depth;
            deepest(n, limited, depth);
            if (depth <= 0) continue;
            n.pressed = n.approach = 0;
            put(&contacts.pulls[i], {});
        }
        contacts.active.push_back(number);
        const int32_t pushing = push_out(n, at);
        if (!before) n.active_plane = pushing;
        slow_down(n, contacts, body.settings, place_on_plane(n, contacts, get(&cloth.start[i])), at);
        // Moving back may lead into another contact plane.
        if (n.plane_count > 1) push_out(n, at);
        put(&contacts.normals[i], {});
        contacts.pushed = contacts.pushed || is_pushed(n);
        // In metres: the displacement by chains and limits, or by contact planes.
        n.moved = before ? get(&contacts.pulls[i]) * at[3] + (limited - n.chained) : limited - get(at);
        n.active_before_chains = before;
    }
}

namespace {

/// Adds the velocity that the particle has lost to the impulse on its model.
void add_lost_velocity(Neighbour& n, Body& body, const CollisionContext& around, Vec3 velocity) {
    const ContactPlane& plane = n.planes[n.active_plane];
    if (n.impulse_model != plane.model) {
        flush_impulse(n, body, around);
        n.impulse_model = plane.model;
    }
    const size_t i = 4 * size_t{n.particle};
    const Vec3 turning = cross(get(&body.cloth.at[i]) - plane.normal * body.particles.radius[n.particle], velocity);
    n.given += velocity;
    n.turning += turning;
    body.cloth.contacts.given += velocity * body.cloth.acceleration[i + 3];
    body.cloth.contacts.turning += turning * body.cloth.acceleration[i + 3];
}

}  // namespace

/// Links, limits and contact planes have changed the predicted velocity. The share of the contact planes goes to their
/// models.
void count_contacts(Body& body, const CollisionContext& around, double rate) {
    for (const uint32_t number : body.cloth.contacts.active) {
        Neighbour& n = body.cloth.contacts.neighbours[number];
        const Vec3 velocity = get(&body.cloth.velocity[4 * size_t{n.particle}]);
        const Vec3 pulled = n.moved * rate;
        add_lost_velocity(n, body, around, n.active_before_chains ? n.predicted_velocity + pulled - velocity : pulled);
    }
}

void turn_velocities(Body& body, const CollisionContext& around, double h) {
    Cloth& cloth = body.cloth;
    const double rate = 1 / h;
    for (const uint32_t number : body.cloth.contacts.active) {
        Neighbour& n = body.cloth.contacts.neighbours[number];
        const size_t i = 4 * size_t{n.particle};
        float* velocity = &cloth.velocity[i];
        const Vec3 start = get(&cloth.start[i]), place = place_on_plane(n, body.cloth.contacts, start);
        const Vec3 of_plane = (place - start) * rate;
        if (get(&cloth.at[i]) == place && body.settings.restitution * n.approach == 0) {
            add_lost_velocity(n, body, around, get(velocity) - of_plane);
            put(velocity, of_plane);
            continue;
        }
        const Vec3 normal = n.planes[n.active_plane].normal;
        const double away = dot(get(velocity) - of_plane, normal);
        const double wanted = body.settings.restitution * n.approach;
        if (away >= wanted) continue;
        add_lost_velocity(n, body, around, normal * (away - wanted));
        put(velocity, get(velocity) + normal * (wanted - away));
    }
}

void stop_taken_back(Body& body, const CollisionContext& around, double h) {
    Cloth& cloth = body.cloth;
    for (const uint32_t number : body.cloth.contacts.active) {
        Neighbour& n = body.cloth.contacts.neighbours[number];
        const size_t i = 4 * size_t{n.particle};
        const Vec3 back = get(&cloth.at[i]) - n.chained, start = get(&cloth.start[i]);
        const Vec3 velocity = get(&cloth.velocity[i]);
        const double square = length_squared(back);
        const double against = dot((place_on_plane(n, body.cloth.contacts, start) - start) / h - velocity, back);
        if (against <= 0 || square == 0) continue;
        const Vec3 slowed = velocity + back * std::min(1 / h, against / square);
        add_lost_velocity(n, body, around, velocity - slowed);
        put(&cloth.velocity[i], slowed);
    }
}

bool is_held(const Body& body, uint32_t particle) {
    const uint32_t place = body.cloth.contacts.place[particle];
    if (place == ClothContacts::nowhere || body.cloth.contacts.sunk) return false;
    const Neighbour& n = body.cloth.contacts.neighbours[place];
    return n.active_plane >= 0 && n.held && !is_pushed(n);
}

void shift(Body& body, uint32_t particle, Vec3 way, bool collides) {
    float* const at = &body.cloth.at[4 * size_t{particle}];
    put(at, get(at) + way);
    stay_near_target(body, particle);
    if (collides) stay_outside(body, particle);
}

void ease_links(Body& body) {
    // Relative to the length: smaller errors are invisible and are left alone.
    constexpr double slack = 5e-3;
    Cloth& cloth = body.cloth;
    ClothContacts& contacts = body.cloth.contacts;
    const auto is_active = [&](uint32_t p) {
        const uint32_t place = contacts.place[p];
        return place != ClothContacts::nowhere && contacts.neighbours[place].active_plane >= 0;
    };
    for (uint32_t slot = 0; slot < body.constraints.ids.slots(); ++slot) {
        const DistanceConstraint& link = body.constraints.by_slot[slot];
        if (!body.constraints.ids.live(slot) || link.compliance > 0 || !is_active(link.a) || !is_active(link.b))
            continue;
        const float *a = &cloth.at[4 * size_t{link.a}], *b = &cloth.at[4 * size_t{link.b}];
        const Vec3 along = get(b) - get(a);
        const double length = gphys::length(along), error = length - link.rest, mobility = double{a[3]} + b[3];
        if (std::fabs(error) <= slack * link.rest || length == 0 || mobility == 0) continue;
        if (link.limit && error < 0) continue;
        const Vec3 correction = along * (error / (length * mobility));
        shift(body, link.a, correction * a[3], true);
        shift(body, link.b, correction * -b[3], true);
    }
}

void catch_escaped(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    Cloth& cloth = body.cloth;
    ClothContacts& contacts = body.cloth.contacts;
    contacts.sunk = false;
    const uint32_t count =
        list_moving(body, [&](uint32_t p) { return squared_from_ball(body, p) >= contacts.balls[4 * size_t{p} + 3]; });
    if (count == 0) return;
    Aabb all{body.particles.position[contacts.escaped[0]], body.particles.position[contacts.escaped[0]]};
    double longest = 0, radius = 0;
    all = {Vec3{infinity, infinity, infinity}, Vec3{-infinity, -infinity, -infinity}};
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t p = contacts.escaped[k];
        const size_t i = 4 * size_t{p};
        body.history.start[p] = cloth.origin + get(&cloth.start[i]);
        body.particles.position[p] = cloth.origin + get(&cloth.at[i]);
        body.particles.velocity[p] = get(&cloth.velocity[i]);
        all.min = min(all.min, min(body.history.start[p], body.particles.position[p]));
        all.max = max(all.max, max(body.history.start[p], body.particles.position[p]));
        longest = std::max(longest, length_squared(body.particles.position[p] - body.history.start[p]));
        radius = std::max(radius, body.particles.radius[p]);
    }
    const double room = 2 * radius + std::sqrt(longest);
    const Collider collider(around, body,
                            bounds(Aabb{all.min - Vec3{room, room, room}, all.max + Vec3{room, room, room}}));
    for (uint32_t k = 0; k < count && !collider.idle(); ++k) {
        const uint32_t p = contacts.escaped[k];
        const size_t i = 4 * size_t{p};
        body.contacts.held[p] = 0;
        const Vec3 at = body.particles.position[p];
        collider.slide(body, p, body.history.start[p], at - body.history.start[p], around.begin,
                       quiet_speed(gravity, h));
        if (body.contacts.held[p]) {
            put(&cloth.at[i], body.particles.position[p] - cloth.origin);
            put(&cloth.velocity[i], body.particles.velocity[p]);
        }
    }
    ContactSearch(around, body, gravity, around.step_time * (1 - around.end) + h).run(contacts.escaped.data(), count);
}

void stay_outside(Body& body, uint32_t particle) {
    const uint32_t place = body.cloth.contacts.place[particle];
    if (place != ClothContacts::nowhere) {
        push_out(body.cloth.contacts.neighbours[place], &body.cloth.at[4 * size_t{particle}]);
    }
}

void finish_neighbour(Neighbour& n, Body& body, const CollisionContext& around) {
    flush_impulse(n, body, around);
    const Vec3 at = body.cloth.origin + get(&body.cloth.at[4 * size_t{n.particle}]);
    for (uint32_t i = 0; i < n.plane_count; ++i) {
        const ContactPlane& plane = n.planes[i];
        if (n.active_planes >> i & 1) {
            record_contact_point(body, n.particle, *around.scene, plane.model,
                                 at - plane.normal * body.particles.radius[n.particle], plane.normal);
        }
    }
}

void record_contact_points(Body& body, const CollisionContext& around) {
    for (const uint32_t place : body.cloth.contacts.place) {
        if (place != ClothContacts::nowhere) finish_neighbour(body.cloth.contacts.neighbours[place], body, around);
    }
}

}  // namespace gphys
