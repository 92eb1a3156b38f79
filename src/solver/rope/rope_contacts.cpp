// Contacts of ropes as springs of an active set in Newton's iterations (rope_contacts.h).
#include "solver/rope/rope_contacts.h"

#include "solver/contact/collision_memory.h"
#include "solver/contact/friction.h"

namespace gphys {
namespace {

// The ratio of a contact's stiffness to that of the particle and its links. A force that would move the particle into
// the model moves it by only this fraction: a hundredth of a skin. A ratio of 2^27 would cost the other directions half
// of the digits of a double.
constexpr double stiffness_ratio = 1 << 17;
// Planes follow the model's surface in this many iterations. Then they stay, so that the iterations converge.
constexpr int most_plane_updates = 6;
// The iterations in which a contact may switch between stick and slip. After that friction is a spring, as soft as
// Coulomb's law requires. That always converges, but slowly at the border between the two.
constexpr int most_switches = 4;
// Relative tolerance of normal forces, from which friction follows.
constexpr double normal_force_tolerance = 1e-2;

/// The displacement of a particle along the plane, relative to the model, since the start of the substep.
Vec3 slip_of(const RopeContact& contact, const Body& body, uint32_t p) {
    const Vec3 displacement = body.particles.position[p] - body.history.start[p] - contact.carried;
    return displacement - contact.normal * dot(displacement, contact.normal);
}

/// The greatest friction force. A model that speeds up has one speed in each step, so it starts each with a jump. A
/// particle that sticks gets what it needs for the jump at once, as far as its friction in the rest of the step would
/// have sufficed: it follows the model as one that speeds up evenly.
double most_friction(const RopeContact& contact, double coefficient) {
    const double by_law = coefficient * contact.normal_force;
    return by_law > 0 && contact.state == RopeContact::stick ? by_law + contact.ahead : by_law;
}

/// Whether the plane for a place is still that of the contact. Along the normal the closest point stays the same. Along
/// the surface at which particles touch a convex feature it turns at most as on a ball of their radius.
bool is_current_plane(const RopeContact& contact, Vec3 at, double radius) {
    constexpr double most_angle = 1e-4;  // radians
    const Vec3 moved = at - contact.placed_at;
    const double along = dot(contact.normal, moved);
    return length_squared(moved) - along * along < most_angle * most_angle * radius * radius;
}

/// A particle that is within the skin already may stay there.
void allow_within_skin(RopeContact& contact, double radius, Vec3 start) {
    const double missing = contact.outside - dot(contact.normal, start);
    const double allowed = std::clamp(missing, 0.0, skin(radius, start));
    contact.offset = contact.outside - allowed;
    contact.depth = missing - allowed;
}

/// Places the plane of a target's maximum distance, for the position of its particle.
void place_ball(RopeContact& contact, const AnimationTargets& targets, uint32_t p, Vec3 at) {
    const TargetBound ball = ball_of(targets.all[p], targets.fraction, targets.time, at);
    contact.normal = ball.normal;
    contact.outside = ball.offset;
}

/// By particle, into Rope::solved: the force that has moved it from its predicted position besides those of its links
/// and bends, times the square of the step, kg m. Summed over all particles this is exactly their change of momentum,
/// however far the iterations have converged.
void find_contact_forces(Body& body, double step, const Vector<Vec3>& at) {
    const Plan& plan = body.plan;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        body.rope.solved[p] = (at[p] - body.history.predicted[p]) * body.particles.mass[p];
    }
    each_link(plan, [&](uint32_t link, uint32_t a, uint32_t b) {
        const Vec3 pull = direction(at[a], at[b]) * (body.rope.tension[link] * step * step);
        body.rope.solved[a] -= pull;
        body.rope.solved[b] += pull;
    });
    each_bending_force(body.rope.bending, plan, at,
                       [&](uint32_t p, Vec3 force) { body.rope.solved[p] -= force * (step * step); });
}

}  // namespace

void RopeContacts::reserve(uint32_t particles, size_t moving_models) {
    moving_colliders_.reserve(moving_models);
    contacts_.reserve(size_t{most_planes + bounds_per_particle} * particles);
    if (first_.size() < particles + 1) first_.resize(particles + 1);
    if (balls_.size() < particles) balls_.resize(particles);
}

void RopeContacts::begin_step(const Body& body, const CollisionContext& around, bool near_models, bool moving_models,
                              ClosestFeatures& features) {
    features_ = &features;
    near_models_ = near_models;
    searched_ = !near_models;
    has_targets_ = !body.targets.empty();
    moving_colliders_.clear();
    if (moving_models) {
        origin_ = body.particles.position[0];
        find_moving_colliders(moving_colliders_, origin_, body.steady.search_box, body.settings.layers, around);
    }
    if (near_models) return;
    contacts_.clear();
    for (uint32_t p = 0; p < body.particles.size(); ++p) begin_particle(p);
    first_[body.particles.size()] = static_cast<uint32_t>(contacts_.size());
}

void RopeContacts::begin_particle(uint32_t p) {
    first_[p] = static_cast<uint32_t>(contacts_.size());
    if (has_targets_) contacts_.resize(contacts_.size() + bounds_per_particle);
}

/// Moves the planes of moving models to their places at a time, a fraction of the step.
void RopeContacts::move_planes(const CollisionContext& around, double to) {
    if (moving_colliders_.empty()) return;
    CollisionContext motion = around;
    motion.begin = planes_at_;
    motion.end = planes_at_ = to;
    advance_moving_colliders(moving_colliders_, origin_, motion);
    for (RopeContact& contact : contacts_) {
        if (contact.moving_collider == MovingCollider::unmoved) continue;
        const RigidMotion& step = moving_colliders_[contact.moving_collider].substep_motion;
        const double height = contact.outside - dot(contact.normal, origin_);
        contact.normal = step.rotation * contact.normal;
        contact.outside = height + dot(contact.normal, step.shift) + dot(contact.normal, origin_);
        contact.placed_at = origin_ + step.apply(contact.placed_at - origin_);
        contact.slip_direction = step.rotation * contact.slip_direction;
    }
}

void RopeContacts::place_plane(RopeContact& contact, double radius, Vec3 at) const {
    Vec3 closest, normal;
    double distance;
    contact.placed_at = at;
    if (contact.moving_collider == MovingCollider::unmoved) {
        if (!scene_->closest_point_model(contact.model, at, closest, normal, distance)) return;
    } else {
        const RigidMotion& back = moving_colliders_[contact.moving_collider].from_end;
        const Vec3 in_scene = origin_ + back.inverse_apply(at - origin_);
        if (!scene_->closest_point_model(contact.model, in_scene, closest, normal, distance)) return;
        closest = origin_ + back.apply(closest - origin_);
        normal = back.rotation * normal;
    }
    contact.normal = normal;
    contact.outside = dot(normal, closest) + clearance(radius, at);
}

void RopeContacts::place_bounds(const AnimationTargets& targets, const Vector<Vec3>& positions) {
    for (uint32_t p = 0; p < positions.size(); ++p) {
        RopeContact &ball = contacts_[first_[p]], &backstop = contacts_[first_[p] + 1];
        const Vec3 at = positions[p];
        const TargetBound behind = backstop_of(targets.all[p], targets.fraction, targets.time, at);
        place_ball(ball, targets, p, at);
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
    const Vec3 start = body.history.start[p] + contact.carried;
    const double radius = body.particles.radius[p];
    if (!contact.is_fixed && !is_current_plane(contact, start, radius)) place_plane(contact, radius, start);
    allow_within_skin(contact, radius, start);
    contact.approach = -dot(contact.normal, body.particles.velocity[p] - surface_velocity(contact));
    contact.is_updated = true;
}

/// Whether friction may stop the particle: to stop a fast one would take a larger normal force than there is.
bool RopeContacts::is_slow(const RopeContact& contact, const Body& body, uint32_t p) const {
    const Vec3 velocity = body.history.start_velocity[p], relative = velocity - surface_velocity(contact);
    const double slowest = 2 * distance(body.particles.velocity[p], velocity) + contact.jump;
    return length_squared(relative - contact.normal * dot(relative, contact.normal)) <= slowest * slowest;
}

/// Guesses the normal forces of contacts that have just been found, from the tensions of the last substep: those that
/// would keep their particles where they are on the model.
void RopeContacts::guess_forces(Body& body, double step) {
    find_contact_forces(body, step, body.history.start);
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        each_of_models(p, [&](RopeContact& contact) {
            const Vec3 start = body.history.start[p];
            if (dot(contact.normal, start + contact.carried) >= contact.outside) return;
            if (!is_slow(contact, body, p)) return;
            const Vec3 held = body.rope.solved[p] + contact.carried * body.particles.mass[p];
            const double normal_force = dot(contact.normal, held);
            if (normal_force <= 0) return;
            contact.normal_force = normal_force;
            const Vec3 friction = held - contact.normal * normal_force;
            const double length = gphys::length(friction);
            contact.state = RopeContact::stick;
            if (length <= most_friction(contact, friction_of(body, p))) return;
            contact.state = RopeContact::slip;
            contact.slip_direction = friction / -length;
        });
    }
}

bool RopeContacts::begin(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme) {
    const double h = scheme.advance;
    const auto stays = [&] {
        if (!near_models_) return true;
        for (uint32_t p = 0; p < body.particles.size(); ++p) {
            if (!body.particles.pinned(p) && !in_ball(p, body.particles.position[p])) return false;
        }
        return true;
    };
    seconds_ = h;
    const bool searches = !searched_ || !stays();
    if (searches) searched_ = search(body, around, gravity, h);
    if (!searched_) return false;
    if (planes_at_ != around.begin) move_planes(around, around.begin);  // after a substep that was taken back
    move_planes(around, around.end);
    active_ = !contacts_.empty();
    if (has_targets_) place_bounds(body.targets, body.particles.position);
    const double most_push = leaving_speed * around.step_time * (around.end - around.begin);
    const double step = scheme.step(body.settings.damping), rest = std::max(h, around.step_time * (1 - around.begin));
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        each_of_models(p, [&](RopeContact& contact) {
            if (contact.moving_collider == MovingCollider::unmoved) return;
            const MovingCollider& moving = moving_colliders_[contact.moving_collider];
            const Vec3 start = body.history.start[p] - origin_;
            contact.carried = moving.substep_motion.apply(start) - start;
            contact.jump = around.begin == 0 ? length(moving.jump) : 0;
            contact.ahead = body.particles.mass[p] * contact.jump * step * step * (1 / h - 1 / rest);
        });
    }
    if (searches && active_ && near_models_) guess_forces(body, step);
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        bool penetrating = false;
        each_of_models(p, [&](RopeContact& contact) {
            // As long as the particle is in front of an earlier plane, that separates it from the model, too.
            const bool in_front = dot(contact.normal, body.history.start[p] + contact.carried) >= contact.outside;
            contact.is_updated = contact.is_fixed || contact.state != RopeContact::open || !in_front;
            contact.iterations = 0;
            contact.force = {};
            contact.offset = contact.outside;
            contact.depth = 0;
            if (contact.is_updated) begin_contact(contact, body, p);
            penetrating = penetrating || contact.depth > most_push;
        });
        if (!penetrating) continue;
        searched_ = false;
        return false;
    }
    return true;
}

ContactTerm RopeContacts::term(const Body& body, uint32_t p, double mass) {
    ContactTerm term;
    each(p, [&](RopeContact& contact) {
        contact.force = {};
        if (contact.state == RopeContact::open) return;
        const double k = contact.stiffness = stiffness_ratio * mass;
        const Vec3 n = contact.normal;
        term.force += n * (k * (contact.offset - dot(n, body.particles.position[p])));
        const double friction_limit = contact.model != 0 ? most_friction(contact, friction_of(body, p)) : 0;
        if (friction_limit == 0) return term.add_stiffness(n, k, 0);
        const Vec3 slip = slip_of(contact, body, p);
        const double length = gphys::length(slip);
        // Perpendicular to the direction of slip, because the friction force turns with it.
        const double lateral_stiffness = length * k > friction_limit ? friction_limit / length : k;
        if (contact.iterations >= most_switches || contact.state == RopeContact::stick) {
            contact.friction_stiffness = contact.iterations >= most_switches ? lateral_stiffness : k;
            term.add_stiffness(n, k - contact.friction_stiffness, contact.friction_stiffness);
            term.force -= slip * contact.friction_stiffness;
        } else {
            contact.friction_stiffness = 0;
            term.add_stiffness(n, k - lateral_stiffness, lateral_stiffness);
            term.add_stiffness(contact.slip_direction, -lateral_stiffness, 0);
            contact.force = contact.slip_direction * -friction_limit;
            term.force += contact.force;
        }
    });
    return term;
}

bool RopeContacts::update(RopeContact& contact, const Body& body, uint32_t p, int iteration) const {
    const Vec3 at = body.particles.position[p];
    double gap = dot(contact.normal, at) - contact.offset;
    if (contact.state == RopeContact::open && gap >= 0) return true;
    if (gap < 0 && !contact.is_updated && contact.model != 0) {
        begin_contact(contact, body, p);
        gap = dot(contact.normal, at) - contact.offset;
    }
    const double friction = contact.model != 0 ? friction_of(body, p) : 0;
    bool converged = true;
    if (contact.state == RopeContact::open) {
        if (gap >= 0) return true;
        // Without friction in the first iteration, because the normal force is not known yet.
        contact.state = RopeContact::stick;
        contact.normal_force = 0;
        converged = false;
    } else {
        const double normal_force = -contact.stiffness * gap, before = contact.normal_force;
        const Vec3 slip = slip_of(contact, body, p);
        const double length = gphys::length(slip), friction_limit = most_friction(contact, friction);
        contact.normal_force = std::max(0.0, normal_force);
        contact.force +=
            contact.normal * contact.normal_force - slip * (friction_limit > 0 ? contact.friction_stiffness : 0);
        if (normal_force < 0) {
            contact.state = RopeContact::open;
            converged = false;
        } else if (before == 0) {
            const bool slow = is_slow(contact, body, p);
            contact.state = slow || length == 0 ? RopeContact::stick : RopeContact::slip;
            if (!slow && length > 0) contact.slip_direction = slip / length;
        } else if (friction_limit > 0 && contact.iterations < most_switches) {
            const bool sticks = contact.state == RopeContact::stick ? length * contact.stiffness <= friction_limit
                                                                    : dot(slip, contact.slip_direction) <= 0;
            if (sticks != (contact.state == RopeContact::stick)) converged = false;
            contact.state = sticks ? RopeContact::stick : RopeContact::slip;
            if (!sticks) contact.slip_direction = slip / length;
        }
        ++contact.iterations;
        if (friction > 0 && std::fabs(normal_force - before) > normal_force_tolerance * normal_force) converged = false;
    }
    const double skin = gphys::skin(body.particles.radius[p], at);
    // From behind a plane, the closest point of a model may be on its far side.
    if (contact.is_fixed || iteration >= most_plane_updates || (gap < -skin && contact.model != 0)) return converged;
    if (contact.model != 0 && is_current_plane(contact, at, body.particles.radius[p])) return converged;
    RopeContact turned = contact;
    if (contact.model == 0) {
        place_ball(turned, body.targets, p, at);
    } else {
        place_plane(turned, body.particles.radius[p], at);
    }
    turned.offset = turned.outside - (contact.outside - contact.offset);
    const double moved = dot(turned.normal, at) - turned.offset - gap;
    if (contact.state != RopeContact::open && std::fabs(moved) > 0.01 * skin) converged = false;
    contact.placed_at = turned.placed_at;
    contact.normal = turned.normal;
    contact.outside = turned.outside;
    contact.offset = turned.offset;
    contact.slip_direction -= contact.normal * dot(contact.slip_direction, contact.normal);
    return converged;
}

bool RopeContacts::update(const Body& body, int iteration) {
    bool converged = true;
    for (uint32_t p = 0; p < body.particles.size() && active_; ++p) {
        if (body.particles.pinned(p)) continue;
        each(p, [&](RopeContact& contact) { converged = update(contact, body, p, iteration) && converged; });
    }
    return converged;
}

void RopeContacts::push_out(Particles& particles) const {
    constexpr int most_passes = 8;
    for (uint32_t p = 0; p < particles.size() && active_; ++p) {
        if (particles.pinned(p)) continue;
        const double tolerance = skin(particles.radius[p], particles.position[p]) / 8;
        bool out = false;
        for (int pass = 0; pass < most_passes && !out; ++pass) {
            out = true;
            for (uint32_t i = first_[p]; i < first_[p + 1]; ++i) {
                const RopeContact& contact = contacts_[i];
                const double depth = contact.offset - dot(contact.normal, particles.position[p]);
                if (depth <= tolerance) continue;
                particles.position[p] += contact.normal * depth;
                out = false;
            }
        }
    }
}

void RopeContacts::sweep_escaped(Body& body, const CollisionContext& around, double bounce_threshold) {
    const auto escaped = [&](uint32_t p) {
        return !body.particles.pinned(p) && !in_ball(p, body.particles.position[p]);
    };
    bool any = false;
    for (uint32_t p = 0; p < body.particles.size(); ++p) any = any || escaped(p);
    if (!any) return;
    searched_ = false;
    const Collider& collider =
        around.memory->collider.emplace(around, body, swept_box(body, body.history.start, body.particles.position, 0));
    if (collider.idle()) return;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (escaped(p)) {
            collider.slide(body, p, body.history.start[p], body.particles.position[p] - body.history.start[p],
                           around.begin, bounce_threshold);
        }
    }
}

void RopeContacts::finish(Body& body, const CollisionContext& around, double bounce_threshold,
                          const TimeScheme& scheme) {
    body.contacts.has_contact = body.contacts.penetrating = false;
    std::fill(body.contacts.held.begin(), body.contacts.held.end(), uint8_t{0});
    const BodySettings& settings = body.settings;
    const double rate = scheme.next / scheme.h;  // 1/s: a correction of the position changes the velocity by this
    if (active_) find_contact_forces(body, scheme.step(settings.damping), body.particles.position);
    for (uint32_t p = 0; p < body.particles.size() && active_; ++p) {
        if (body.particles.pinned(p)) continue;
        bool sticks = false;
        const RopeContact* strongest = nullptr;
        Vec3 unassigned = body.rope.solved[p];  // the force that no contact has accounted for yet
        each(p, [&](RopeContact& contact) {
            // In the last iteration this contact was open, but push_out has moved the particle out of it.
            const double gap = dot(contact.normal, body.particles.position[p]) - contact.offset;
            if (contact.force == Vec3{} && gap <= skin(body.particles.radius[p], body.particles.position[p]) / 8) {
                contact.force = contact.normal * std::max(0.0, dot(contact.normal, unassigned));
            }
            unassigned -= contact.force;
            if (!strongest || length_squared(contact.force) > length_squared(strongest->force)) strongest = &contact;
        });
        each_of_models(p, [&](RopeContact& contact) {
            if (contact.force == Vec3{}) return;
            Vec3& velocity = body.particles.velocity[p];
            const Vec3 before = velocity;
            // Moving out of a model adds no velocity, and the remaining approach speed ends here.
            velocity -= contact.normal * (std::max(0.0, contact.depth) * rate);
            const double wanted = contact.approach > bounce_threshold ? settings.restitution * contact.approach : 0;
            const Vec3 of_surface = surface_velocity(contact);
            const double added = wanted - dot(velocity - of_surface, contact.normal);
            if (added > 0) {
                velocity += contact.normal * added;
                const Vec3 relative = velocity - of_surface;
                const Vec3 tangential_velocity = relative - contact.normal * dot(relative, contact.normal);
                const double speed = length(tangential_velocity), most_taken = friction_of(body, p) * added;
                velocity -= speed > most_taken ? tangential_velocity * (most_taken / speed) : tangential_velocity;
            }
            const Vec3 point = body.particles.position[p] - contact.normal * body.particles.radius[p];
            // The force acts on the particle's centre, so its moment is that about this point.
            add_impulse(body, around, contact.model, body.particles.position[p],
                        (contact.force + (&contact == strongest ? unassigned : Vec3{})) * -rate -
                            (velocity - before) * body.particles.mass[p]);
            body.contacts.has_contact = true;
            body.contacts.held[p] = static_cast<uint8_t>(
                record_contact_point(body, p, *around.scene, contact.model, point, contact.normal) + 1);
            sticks = sticks || contact.state == RopeContact::stick;
        });
        if (settings.sticks()) body.contacts.stuck[p] = sticks;
    }
    sweep_escaped(body, around, bounce_threshold);
}

}  // namespace gphys
