// Contacts of ropes as springs of an active set in Newton's iterations (rope_contacts.h).
#include "solver/rope/rope_contacts.h"

namespace gphys {
namespace {

// The ratio of a contact's stiffness to that of the particle and its links. A force that would move the particle into
// the model moves it by only this fraction: a hundredth of a skin. A ratio of 2^27 would cost the other directions half
// of the digits of a double.
constexpr double stiffness = 1 << 17;
// Planes follow the model's surface in the first iterations. Then they stay, so that the iterations converge.
constexpr int most_turns = 6;
// The iterations in which each contact switches between sliding and sticking. If they do not settle, friction becomes a
// spring everywhere, as soft as Coulomb's law requires. That always converges, but slowly at the border between the
// two.
constexpr int most_tries = 4;
// Relative tolerance of the normal forces, from which friction follows.
constexpr double pressure_settled = 1e-2;
// Near more parts than this, a particle's ball is smaller.
constexpr uint32_t many_parts = 64;

double friction_of(const Body& body, uint32_t p) {
    const BodySettings& settings = body.settings;
    return settings.sticks() && body.contacts.stuck[p] ? settings.static_friction : settings.friction;
}

/// The displacement along a plane, from the start of the substep.
Vec3 slid(const RopeContact& contact, const Body& body, uint32_t p) {
    const Vec3 way = body.particles.position[p] - body.history.start[p];
    return way - contact.normal * dot(way, contact.normal);
}

double clearance(const Body& body, uint32_t p, Vec3 at) {
    return body.particles.radius[p] + skin(body.particles.radius[p], at);
}

/// Whether the plane at a place is that of the contact. The surface on which particles touch a convex part bends at
/// most like a ball of their radius.
bool is_placed_for(const RopeContact& contact, Vec3 at, double radius) {
    constexpr double turned = 1e-4;  // radians
    return length_squared(at - contact.placed) < turned * turned * radius * radius;
}

}  // namespace

void RopeContacts::reserve(uint32_t particles) {
    contacts_.reserve(size_t{most_parts + bounds_per_particle} * particles);
    if (first_.size() < particles + 1) first_.resize(particles + 1);
    if (balls_.size() < particles) balls_.resize(particles);
}

void RopeContacts::begin_step(const Body& body, bool beside_models, ClosestFeatures& parts) {
    parts_ = &parts;
    beside_models_ = beside_models;
    searched_ = !beside_models;
    bounded_ = !body.targets.empty();
    if (beside_models) return;
    contacts_.clear();
    for (uint32_t p = 0; p < body.particles.size(); ++p) begin_particle(p);
    first_[body.particles.size()] = static_cast<uint32_t>(contacts_.size());
}

void RopeContacts::begin_particle(uint32_t p) {
    first_[p] = static_cast<uint32_t>(contacts_.size());
    if (bounded_) contacts_.resize(contacts_.size() + bounds_per_particle);
}

/// Finds the models that the balls around some particles overlap. Returns false if there are too many.
bool RopeContacts::collect(const Body& body, uint32_t first, uint32_t count) {
    Aabb places{body.history.start[first], body.history.start[first]};
    double farthest = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t p = first + i;
        probes_[i] = {body.history.start[p], clearance(body, p, body.history.start[p]) + balls_[p].reach};
        places = {min(places.min, body.history.start[p]), max(places.max, body.history.start[p])};
        farthest = std::max(farthest, probes_[i].radius);
    }
    const Vec3 room{farthest, farthest, farthest};
    parts_->clear(count);
    bool complete = true, any = false;
    scene_->for_each_in_box(bounds(Aabb{places.min - room, places.max + room}), body.settings.layers,
                            [&](gphys_model_id model) {
                                any = true;
                                complete &= parts_->add(*scene_, model, 0, probes_);
                            });
    if (complete && !any) {
        for (uint32_t i = 0; i < count; ++i) begin_particle(first + i);
        return true;
    }
    for (uint32_t i = 0; i < count && complete; ++i) settle(body, first + i, i);
    return complete;
}

/// Sets the ball and the contacts of a particle from the parts that were collected around it.
void RopeContacts::settle(const Body& body, uint32_t p, uint32_t point) {
    begin_particle(p);
    const Vec3 at = body.history.start[p];
    const double off = clearance(body, p, at);
    double& reach = balls_[p].reach;
    for (int halvings = 0; parts_->select_point(point) > many_parts && halvings < 3; ++halvings) {
        reach /= 2;
        probes_[point].radius = off + reach;
    }
    uint32_t count = 0;
    for (ClosestFeature part; count < most_parts && parts_->pop_nearest(part); ++count) {
        RopeContact contact{};
        contact.model = part.model;
        contact.normal = part.normal;
        contact.outside = dot(part.normal, part.closest) + off;
        contact.is_fixed = part.is_triangle || scene_->type(part.model) == GPHYS_SHAPE_PLANE;
        contacts_.push_back(contact);
        // Coplanar triangles share a plane.
        if (part.is_triangle) {
            parts_->cull_behind(part.normal,
                                contact.outside - body.particles.radius[p] - skin(body.particles.radius[p], at) / 2, 0);
        }
    }
    if (count < most_parts) return;
    parts_->for_each_remaining(
        [&](uint32_t, double distance) { reach = std::max(0.0, std::min(reach, distance - off)); });
}

/// The reach is the distance that particles can go in the rest of the step, and half as much again.
void RopeContacts::search(const Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    contacts_.clear();
    scene_ = around.scene;
    const double rest = std::max(h, around.step_time * (1 - around.begin)), fall = rest * length(gravity);
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        balls_[p] = {body.history.start[p], 1.5 * rest * (length(body.history.start_velocity[p]) + fall)};
    }
    for (uint32_t first = 0, count; first < body.particles.size(); first += count) {
        Aabb places{body.history.start[first], body.history.start[first]};
        const double size = 8 * (clearance(body, first, body.history.start[first]) + balls_[first].reach);
        for (count = 1; count < ClosestFeatures::most_points && first + count < body.particles.size(); ++count) {
            const Vec3 at = body.history.start[first + count];
            places = {min(places.min, at), max(places.max, at)};
            if (max_component(places.max - places.min) > size) break;
        }
        const size_t before = contacts_.size();
        if (collect(body, first, count)) continue;
        for (uint32_t p = first; p < first + count; ++p) {
            contacts_.resize(p == first ? before : contacts_.size());
            const size_t of_this = contacts_.size();
            bool complete = collect(body, p, 1);
            for (int halvings = 0; !complete && halvings < 3; ++halvings) {
                balls_[p].reach /= 2;
                contacts_.resize(of_this);
                complete = collect(body, p, 1);
            }
            if (complete) continue;
            // This particle is swept instead.
            contacts_.resize(of_this);
            begin_particle(p);
            balls_[p].reach = 0;
        }
    }
    first_[body.particles.size()] = static_cast<uint32_t>(contacts_.size());
    searched_ = true;
}

void RopeContacts::place_plane(RopeContact& contact, const Body& body, uint32_t p, Vec3 at) const {
    Vec3 closest, normal;
    double distance;
    contact.placed = at;
    if (!scene_->closest_point_model(contact.model, at, closest, normal, distance)) return;
    contact.normal = normal;
    contact.outside = dot(normal, closest) + clearance(body, p, at);
}

void RopeContacts::allow_within_skin(RopeContact& contact, const Body& body, uint32_t p) const {
    const double missing = contact.outside - dot(contact.normal, body.history.start[p]);
    const double allowed = std::clamp(missing, 0.0, skin(body.particles.radius[p], body.history.start[p]));
    contact.offset = contact.outside - allowed;
    contact.depth = missing - allowed;
}

void RopeContacts::place_ball(RopeContact& contact, const Body& body, uint32_t p, Vec3 at) const {
    const AnimationTargets& targets = body.targets;
    const TargetBound ball = ball_of(targets.all[p], targets.fraction, targets.time, at);
    contact.normal = ball.normal;
    contact.outside = ball.offset;
}

/// Places the bounds of all targets, for the predicted positions.
void RopeContacts::place_bounds(const Body& body) {
    const AnimationTargets& targets = body.targets;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        RopeContact &ball = contacts_[first_[p]], &backstop = contacts_[first_[p] + 1];
        const Vec3 at = body.particles.position[p];
        const TargetBound behind = backstop_of(targets.all[p], targets.fraction, targets.time, at);
        place_ball(ball, body, p, at);
        ball.offset = ball.outside;
        backstop.normal = behind.normal;
        backstop.outside = backstop.offset = behind.offset;
        backstop.is_fixed = true;
        ball.iterations = backstop.iterations = 0;
        ball.force = backstop.force = {};
    }
}

/// Places the plane for the beginning of the substep.
void RopeContacts::begin_contact(RopeContact& contact, const Body& body, uint32_t p) const {
    if (!contact.is_fixed) place_plane(contact, body, p, body.history.start[p]);
    allow_within_skin(contact, body, p);
    contact.approach = -dot(contact.normal, body.particles.velocity[p]);
    contact.is_placed = true;
}

bool RopeContacts::begin(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    const auto stays = [&] {
        if (!beside_models_) return true;
        for (uint32_t p = 0; p < body.particles.size(); ++p) {
            if (!body.particles.pinned(p) && !in_ball(body, p)) return false;
        }
        return true;
    };
    if (!searched_ || !stays()) search(body, around, gravity, h);
    active_ = !contacts_.empty();
    if (bounded_) place_bounds(body);
    const double most_push = leaving_speed * around.step_time * (around.end - around.begin);
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        bool sunk = false;
        each_of_models(p, [&](RopeContact& contact) {
            // An earlier plane separates the particle from the model, too, as long as it is in front of it.
            const bool in_front = dot(contact.normal, body.history.start[p]) >= contact.outside;
            contact.is_placed = contact.is_fixed || contact.state != RopeContact::apart || !in_front;
            contact.iterations = 0;
            contact.force = {};
            contact.offset = contact.outside;
            contact.depth = 0;
            if (contact.is_placed) begin_contact(contact, body, p);
            sunk = sunk || contact.depth > most_push;
        });
        if (!sunk) continue;
        searched_ = false;
        return false;
    }
    return true;
}

ContactTerm RopeContacts::term(const Body& body, uint32_t p, double mass) {
    ContactTerm term;
    each(p, [&](RopeContact& contact) {
        contact.force = {};
        if (contact.state == RopeContact::apart) return;
        const double k = contact.stiffness = stiffness * mass;
        const Vec3 n = contact.normal;
        term.force += n * (k * (contact.offset - dot(n, body.particles.position[p])));
        const double hold = contact.model != 0 ? friction_of(body, p) * contact.pressed : 0;
        if (hold == 0) return term.add_stiffness(n, k, 0);
        const Vec3 way = slid(contact, body, p);
        const double length = gphys::length(way);
        // The stiffness perpendicular to the sliding direction, because the friction force turns with that direction.
        const double turning = length * k > hold ? hold / length : k;
        if (contact.iterations >= most_tries || contact.state == RopeContact::sticks) {
            contact.drag = contact.iterations >= most_tries ? turning : k;
            term.add_stiffness(n, k - contact.drag, contact.drag);
            term.force -= way * contact.drag;
        } else {
            contact.drag = 0;
            term.add_stiffness(n, k - turning, turning);
            term.add_stiffness(contact.way, -turning, 0);
            contact.force = contact.way * -hold;
            term.force += contact.force;
        }
    });
    return term;
}

bool RopeContacts::update(RopeContact& contact, const Body& body, uint32_t p, int iteration) const {
    const Vec3 at = body.particles.position[p];
    double gap = dot(contact.normal, at) - contact.offset;
    if (contact.state == RopeContact::apart && gap >= 0) return true;
    if (gap < 0 && !contact.is_placed && contact.model != 0) {
        begin_contact(contact, body, p);
        gap = dot(contact.normal, at) - contact.offset;
    }
    const double friction = contact.model != 0 ? friction_of(body, p) : 0;
    bool settled = true;
    if (contact.state == RopeContact::apart) {
        if (gap >= 0) return true;
        // Without friction at first, because it is not known yet.
        contact.state = RopeContact::sticks;
        contact.pressed = 0;
        settled = false;
    } else {
        const double pressed = -contact.stiffness * gap, before = contact.pressed;
        const Vec3 way = slid(contact, body, p);
        const double length = gphys::length(way), hold = friction * before;
        contact.pressed = std::max(0.0, pressed);
        contact.force += contact.normal * contact.pressed - way * (hold > 0 ? contact.drag : 0);
        if (pressed < 0) {
            contact.state = RopeContact::apart;
            settled = false;
        } else if (before == 0) {
            // Fast particles slide: stopping them would take a larger normal force than there is.
            const Vec3 speed = body.history.start_velocity[p];
            const Vec3 along = speed - contact.normal * dot(speed, contact.normal);
            const bool slow = length_squared(along) <= 4 * length_squared(body.particles.velocity[p] - speed);
            contact.state = slow || length == 0 ? RopeContact::sticks : RopeContact::slides;
            if (!slow && length > 0) contact.way = way / length;
        } else if (hold > 0 && contact.iterations < most_tries) {
            const bool sticks =
                contact.state == RopeContact::sticks ? length * contact.stiffness <= hold : dot(way, contact.way) <= 0;
            if (sticks != (contact.state == RopeContact::sticks)) settled = false;
            contact.state = sticks ? RopeContact::sticks : RopeContact::slides;
            if (!sticks) contact.way = way / length;
        }
        ++contact.iterations;
        if (friction > 0 && std::fabs(pressed - before) > pressure_settled * pressed) settled = false;
    }
    const double room = skin(body.particles.radius[p], at);
    // From behind a plane, the closest point of a model may be on its far side.
    if (contact.is_fixed || iteration >= most_turns || (gap < -room && contact.model != 0)) return settled;
    if (contact.model != 0 && is_placed_for(contact, at, body.particles.radius[p])) return settled;
    RopeContact turned = contact;
    if (contact.model == 0) {
        place_ball(turned, body, p, at);
    } else {
        place_plane(turned, body, p, at);
    }
    turned.offset = turned.outside - (contact.outside - contact.offset);
    const double moved = dot(turned.normal, at) - turned.offset - gap;
    if (contact.state != RopeContact::apart && std::fabs(moved) > 0.01 * room) settled = false;
    contact.placed = turned.placed;
    contact.normal = turned.normal;
    contact.outside = turned.outside;
    contact.offset = turned.offset;
    contact.way -= contact.normal * dot(contact.way, contact.normal);
    return settled;
}

bool RopeContacts::update(const Body& body, int iteration) {
    bool settled = true;
    for (uint32_t p = 0; p < body.particles.size() && active_; ++p) {
        if (body.particles.pinned(p)) continue;
        each(p, [&](RopeContact& contact) { settled = update(contact, body, p, iteration) && settled; });
    }
    return settled;
}

void RopeContacts::keep_out(Body& body) const {
    constexpr int most_passes = 8;
    for (uint32_t p = 0; p < body.particles.size() && active_; ++p) {
        if (body.particles.pinned(p)) continue;
        const double room = skin(body.particles.radius[p], body.particles.position[p]) / 8;
        bool out = false;
        for (int pass = 0; pass < most_passes && !out; ++pass) {
            out = true;
            for (uint32_t i = first_[p]; i < first_[p + 1]; ++i) {
                const RopeContact& contact = contacts_[i];
                const double depth = contact.offset - dot(contact.normal, body.particles.position[p]);
                if (depth <= room) continue;
                body.particles.position[p] += contact.normal * depth;
                out = false;
            }
        }
    }
}

void RopeContacts::sweep_escaped(Body& body, const CollisionContext& around, double quiet) {
    const auto escaped = [&](uint32_t p) { return !body.particles.pinned(p) && !in_ball(body, p); };
    bool any = false;
    for (uint32_t p = 0; p < body.particles.size(); ++p) any = any || escaped(p);
    if (!any) return;
    searched_ = false;
    const Collider collider(around, body, swept_box(body, body.history.start, body.particles.position, 0));
    if (collider.idle()) return;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (escaped(p)) {
            collider.slide(body, p, body.history.start[p], body.particles.position[p] - body.history.start[p],
                           around.begin, quiet);
        }
    }
}

namespace {

/// By particle: what has moved it from its predicted position besides its links, in kg m. Summed over all particles
/// this is exactly their change of momentum, however far the iterations have converged.
void find_pushes(Body& body, double step) {
    const Plan& plan = body.plan;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        body.rope.solved[p] = (body.particles.position[p] - body.history.predicted[p]) * body.particles.mass[p];
    }
    for (const Chain& chain : plan.chains) {
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const uint32_t a = plan.particles[chain.first_particle + i],
                           b = plan.particles[chain.first_particle + i + 1];
            const Vec3 pull =
                link_direction(body.particles, a, b) * (body.rope.tension[chain.first_link + i] * step * step);
            body.rope.solved[a] -= pull;
            body.rope.solved[b] += pull;
        }
    }
}

}  // namespace

void RopeContacts::finish(Body& body, const CollisionContext& around, double quiet, const TimeScheme& scheme) {
    body.contacts.has_contact = body.contacts.sunk = false;
    std::fill(body.contacts.held.begin(), body.contacts.held.end(), uint8_t{0});
    const BodySettings& settings = body.settings;
    const double rate = scheme.next / scheme.h;  // ratio of the velocity change to a correction of the position
    if (active_) find_pushes(body, scheme.step(settings.damping));
    for (uint32_t p = 0; p < body.particles.size() && active_; ++p) {
        if (body.particles.pinned(p)) continue;
        bool sticks = false;
        const RopeContact* most = nullptr;
        Vec3 rest = body.rope.solved[p];
        each(p, [&](RopeContact& contact) {
            // The iterations have left this contact out, but keep_out has moved the particle out of it.
            const double gap = dot(contact.normal, body.particles.position[p]) - contact.offset;
            if (contact.force == Vec3{} && gap <= skin(body.particles.radius[p], body.particles.position[p]) / 8) {
                contact.force = contact.normal * std::max(0.0, dot(contact.normal, rest));
            }
            rest -= contact.force;
            if (!most || length_squared(contact.force) > length_squared(most->force)) most = &contact;
        });
        each_of_models(p, [&](RopeContact& contact) {
            if (contact.force == Vec3{}) return;
            Vec3& velocity = body.particles.velocity[p];
            const Vec3 before = velocity;
            // Moving out of a model adds no velocity, and the remaining approach speed ends here.
            velocity -= contact.normal * (std::max(0.0, contact.depth) * rate);
            const double wanted = contact.approach > quiet ? settings.restitution * contact.approach : 0;
            const double given = wanted - dot(velocity, contact.normal);
            if (given > 0) {
                velocity += contact.normal * given;
                const Vec3 along = velocity - contact.normal * dot(velocity, contact.normal);
                const double speed = length(along), taken = friction_of(body, p) * given;
                velocity -= speed > taken ? along * (taken / speed) : along;
            }
            const Vec3 point = body.particles.position[p] - contact.normal * body.particles.radius[p];
            add_impulse(body, around, contact.model, point,
                        (contact.force + (&contact == most ? rest : Vec3{})) * -rate -
                            (velocity - before) * body.particles.mass[p]);
            body.contacts.has_contact = true;
            body.contacts.held[p] = static_cast<uint8_t>(
                record_contact_point(body, p, *around.scene, contact.model, point, contact.normal) + 1);
            sticks = sticks || contact.state == RopeContact::sticks;
        });
        if (settings.sticks()) body.contacts.stuck[p] = sticks;
    }
    sweep_escaped(body, around, quiet);
}

}  // namespace gphys
