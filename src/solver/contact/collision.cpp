// Continuous collision of particles with models: sweeps, sliding with friction, bounces, and the contact points that a
// step records (collision.h).
#include "solver/contact/collision.h"

#include "solver/contact/collision_memory.h"
#include "solver/contact/friction.h"
#include "solver/particles/flight_planes.h"

namespace gphys {
namespace {

// A particle slides along this many models in one substep; a corner has three.
constexpr int most_contacts = 6;

}  // namespace

Collider::Collider(const CollisionContext& around, const Body& body, const Box& paths,
                   const ImpulseAccumulator& accumulator, FlightPlanes* planes)
    : around_(around),
      body_(body),
      accumulator_(accumulator),
      most_push_(body.plan.method == GPHYS_SOLVE_FREE && !body.plan.joined
                     ? infinity
                     : leaving_speed * around.step_time * (around.end - around.begin)),
      planes_(planes) {
    Box box = paths;
    list_moving(box);
    if (moving_count_ > 0) {
        box = bounds_of_pushed(paths);
        list_moving(box);
    }
    around.scene->for_each_in_box(box, body.settings.layers, [&](gphys_model_id model) {
        if (has_moved(around_, model)) return;
        if (count_ == most_listed) {
            listed_ = false;
            any_boxed_ = true;
            return;
        }
        Near& near = near_[count_++];
        near.model = model;
        near.bounded = around.scene->bounds(model, near.box);
        near.is_flat = near.flat.prepare(*around.scene, model);
        any_boxed_ = any_boxed_ || (near.bounded && !near.is_flat);
    });
}

void Collider::sweep_model(gphys_model_id model, const Sphere& moving, Vec3 displacement, Impact& first) const {
    Hit hit;
    if (!around_.scene->sweep_model(model, moving, displacement, hit)) return;
    keep_first(first, {hit.t,
                       model,
                       (hit.flags & GPHYS_HIT_INSIDE) != 0,
                       false,
                       0,
                       {},
                       moving.center + displacement * hit.t,
                       hit.point,
                       hit.normal,
                       Vec3{}});
}

void Collider::sweep_listed(const Near& near, const Sphere& moving, Vec3 displacement, const Box& path,
                            Impact& first) const {
    if (near.is_flat) {
        Hit hit;
        const TriState result = near.flat.sweep(moving, displacement, hit);
        if (result == TriState::no) return;
        if (result == TriState::yes) {
            keep_first(first, {hit.t,
                               near.model,
                               false,
                               false,
                               0,
                               {},
                               moving.center + displacement * hit.t,
                               hit.point,
                               hit.normal,
                               Vec3{}});
            return;
        }
    } else if (near.bounded && !overlaps(near.box, path)) {
        return;
    }
    sweep_model(near.model, moving, displacement, first);
}

void Collider::sweep_unmoved(uint32_t particle, Vec3 from, Vec3 displacement, gphys_model_id ignored,
                             Impact& first) const {
    first = {};
    if (planes_ && ignored == 0 && planes_->sweep_known(body_, particle, from, displacement, first)) return;
    const Sphere moving{from, body_.particles.radius[particle]};
    if (listed_ && count_ == 0) return;
    // Its rounding takes longer than a sweep against a flat model.
    const Box path = any_boxed_ ? path_box(moving, displacement) : Box{};
    if (listed_) {
        for (uint32_t i = 0; i < count_; ++i) {
            if (near_[i].model != ignored) sweep_listed(near_[i], moving, displacement, path, first);
        }
    } else {
        around_.scene->for_each_in_box(path, body_.settings.layers, [&](gphys_model_id model) {
            if (model != ignored && !has_moved(around_, model)) {
                sweep_model(model, moving, displacement, first);
            }
        });
    }
}

bool Collider::sweep_others(uint32_t particle, Vec3 from, Vec3 displacement, double time, gphys_model_id ignored,
                            Impact& first) const {
    sweep_unmoved(particle, from, displacement, ignored, first);
    sweep_moving(particle, from, displacement, time, ignored, first);
    return first.model != 0;
}

bool Collider::sweep(uint32_t particle, Vec3 from, Vec3 displacement, double time, Impact& first) const {
    return sweep_others(particle, from, displacement, time, 0, first);
}

Vec3 Collider::minimum_translation(const Body& body, uint32_t particle, gphys_model_id model) const {
    Impact impact;
    impact.model = model;
    impact.moves = has_moved(around_, model);
    impact.time = around_.end;
    if (impact.moves) impact.place = place_at_end(model);
    return minimum_translation(body, particle, body.particles.position[particle], impact);
}

Vec3 Collider::minimum_translation(const Body& body, uint32_t particle, Vec3 at, const Impact& impact) const {
    // For the scene, a moving model is at its place at the end of the step.
    const Transform now = widen(around_.scene->world(impact.model));
    const Transform then = impact.moves ? impact.place : now;
    const Vec3 relative = impact.moves ? now.apply(then.inverse_apply(at)) : at;
    Vec3 point, normal;
    double distance = 0;
    if (!around_.scene->closest_point_model(impact.model, relative, point, normal, distance)) return {};
    const Vec3 out =
        normal * std::max(0.0, body.particles.radius[particle] - distance + skin(body.particles.radius[particle], at));
    return impact.moves ? then.rotation * transpose_times(now.rotation, out) : out;
}

double Collider::stop_short(const Body& body, uint32_t particle, Vec3 from, Vec3 displacement,
                            const Impact& impact) const {
    const double approach = -dot(displacement, impact.normal);
    const double room = skin(body.particles.radius[particle], from);
    return approach * impact.t > largest_gap(room) ? impact.t - room / approach : 0;
}

// During a step point_count holds two counts: in the upper half of the byte that of the step before. Old points are
// cleared at the end of the step, because a particle at rest records the same points again.
namespace {

constexpr uint32_t count_bits = 4, count_mask = (1 << count_bits) - 1;
static_assert(contact_points_per_particle <= count_mask);

uint32_t contact_point_count(const Body& body, uint32_t particle) {
    return body.contacts.point_count[particle] & count_mask;
}

}  // namespace

void begin_contact_points(Body& body, uint32_t first, uint32_t end) {
    if (body.contacts.point_count.empty()) return;
    uint8_t* const counts = body.contacts.point_count.data();  // hoisted: byte stores may alias
    for (uint32_t p = first; p < end; ++p) counts[p] = static_cast<uint8_t>(counts[p] << count_bits);
}

void end_contact_points(Body& body, uint32_t first, uint32_t end) {
    if (body.contacts.point_count.empty()) return;
    uint8_t* const counts = body.contacts.point_count.data();
    ContactPoint* const points = body.contacts.points.data();
    for (uint32_t p = first; p < end; ++p) {
        const uint32_t now = counts[p] & count_mask, before = counts[p] >> count_bits;
        for (uint32_t i = now; i < before; ++i) points[size_t{p} * contact_points_per_particle + i] = {};
        counts[p] = static_cast<uint8_t>(now);
    }
}

void clear_contact_points(Body& body) {
    begin_contact_points(body);
    end_contact_points(body);
}

uint32_t record_contact_point(Body& body, uint32_t particle, const Scene& scene, gphys_model_id model, Vec3 point,
                              Vec3 normal) {
    ContactPoint* const points = &body.contacts.points[size_t{particle} * contact_points_per_particle];
    const uint32_t count = contact_point_count(body, particle);
    uint32_t place = 0;
    while (place < count && points[place].model != model) ++place;
    if (place == contact_points_per_particle) return contact_points_per_particle - 1;
    if (place == count) ++body.contacts.point_count[particle];
    points[place] = {model, scene.tag(model), narrow(point), narrow(normal)};
    return place;
}

void Collider::record(Body& body, uint32_t particle, gphys_model_id model, Vec3 point, Vec3 normal) const {
    accumulator_.has_contact = true;
    const uint32_t place = record_contact_point(body, particle, *around_.scene, model, point, normal);
    body.contacts.held[particle] = static_cast<uint8_t>(place + 1);
}

void Collider::record(Body& body, uint32_t particle, const Impact& impact) const {
    const Impact there = impact.moves ? at_substep_end(impact) : impact;
    record(body, particle, impact.model, there.point, there.normal);
}

Vec3 after_impact(Vec3 velocity, const Impact& impact, double restitution, double friction) {
    const Vec3 relative = velocity - impact.surface_velocity;
    const double approach = -dot(relative, impact.normal);
    if (approach <= 0) return velocity;
    const double normal_change = (1 + restitution) * approach;
    const Vec3 tangential = relative + impact.normal * approach;
    const double speed = length(tangential), friction_change = friction * normal_change;
    if (speed <= friction_change) return impact.surface_velocity + impact.normal * (restitution * approach);
    return velocity + impact.normal * normal_change - tangential * (friction_change / speed);
}

namespace {

/// The friction coefficient of an impact. Also decides whether the particle sticks: it starts to slide when the impulse
/// that holds it would exceed static friction, and it sticks when kinetic friction stops it.
double choose_friction(Body& body, uint32_t particle, const Impact& impact, double restitution) {
    const Friction friction = friction_coefficients(body, particle);
    if (!body.settings.sticks()) return friction.kinetic;
    const Vec3 relative = body.particles.velocity[particle] - impact.surface_velocity;
    const double approach = -dot(relative, impact.normal), normal_change = (1 + restitution) * approach;
    if (approach <= 0) return friction.kinetic;  // no impulse
    const double sliding = length(relative + impact.normal * approach);
    const double chosen = body.contacts.stuck[particle] && sliding <= friction.at_rest * normal_change
                              ? friction.at_rest
                              : friction.kinetic;
    body.contacts.stuck[particle] = sliding <= chosen * normal_change;
    return chosen;
}

}  // namespace

bool rests(const Body& body, uint32_t p, Vec3 velocity, Vec3 gravity) {
    const double acceleration = length(gravity + body.particles.force[p] * body.particles.inverse_mass[p]);
    return length_squared(velocity) <= 8 * acceleration * skin(body.particles.radius[p], body.particles.position[p]);
}

void begin_friction(Body& body, Vec3 gravity, uint32_t first, uint32_t end) {
    if (!body.settings.sticks() || body.contacts.stuck.empty()) return;
    std::fill(body.contacts.held.begin() + first, body.contacts.held.begin() + end, uint8_t{0});
    for (uint32_t p = first; p < end; ++p) {
        if (rests(body, p, body.particles.velocity[p], gravity)) body.contacts.stuck[p] = 1;
    }
}

void end_friction(Body& body, uint32_t first, uint32_t end) {
    if (!body.settings.sticks() || body.contacts.stuck.empty()) return;
    for (uint32_t p = first; p < end; ++p) body.contacts.stuck[p] = body.contacts.stuck[p] && body.contacts.held[p];
}

void Collider::bounce(Body& body, uint32_t particle, const Impact& impact, double restitution) const {
    const double friction = choose_friction(body, particle, impact, restitution);
    Vec3& velocity = body.particles.velocity[particle];
    const Vec3 before = velocity;
    velocity = after_impact(velocity, impact, restitution, friction);
    const Impact there = impact.moves ? at_substep_end(impact) : impact;
    add_impulse(accumulator_.impulses, around_, impact.model,
                there.center - there.normal * body.particles.radius[particle],
                (before - velocity) * body.particles.mass[particle]);
}

bool Collider::try_hold(Body& body, uint32_t particle, uint32_t obstacle, Vec3 displacement, Vec3 velocity) const {
    if (obstacle >= count_ || !near_[obstacle].is_flat) return false;
    const Near& near = near_[obstacle];
    const Sphere moving{body.particles.position[particle], body.particles.radius[particle]};
    Hit hit;
    if (near.flat.sweep(moving, displacement, hit) != TriState::yes) return false;
    const Impact impact{hit.t, near.model, false, false, 0, {}, {}, hit.point, hit.normal, {}};
    return try_hold(body, particle, impact, displacement, velocity);
}

bool Collider::try_hold(Body& body, uint32_t particle, const Impact& impact, Vec3 displacement, Vec3 velocity) const {
    const double into = -dot(displacement, impact.normal);
    const double gap = largest_gap(skin(body.particles.radius[particle], body.particles.position[particle]));
    if (into * impact.t > gap) return false;
    const double hold = friction_of(body, particle) * into;
    if (length_squared(displacement + impact.normal * into) > hold * hold) return false;
    record(body, particle, impact.model, impact.point, impact.normal);
    if (body.settings.sticks()) body.contacts.stuck[particle] = 1;
    add_impulse(accumulator_.impulses, around_, impact.model, impact.point, velocity * body.particles.mass[particle]);
    return true;
}

void Collider::hold(Body& body, uint32_t first, uint32_t count, uint32_t obstacle, Vec3 displacement,
                    Vec3 velocity) const {
    const Near& near = near_[obstacle];
    const ContactFace face = near.flat.contact_face(displacement);
    double mass = 0;
    Vec3 middle;
    for (uint32_t p = first; p < first + count; ++p) {
        const Vec3 point = face.point({body.particles.position[p], body.particles.radius[p]}, displacement);
        record(body, p, near.model, point, face.normal);
        if (body.settings.sticks()) body.contacts.stuck[p] = 1;
        mass += body.particles.mass[p];
        middle += point * body.particles.mass[p];
    }
    add_impulse(accumulator_.impulses, around_, near.model, middle / mass, velocity * mass);
}

bool Collider::push(const Body& body, uint32_t particle, Vec3& at, Vec3 out, gphys_model_id of, Impact& wall) const {
    sweep_unmoved(particle, at, out, of, wall);
    const bool free = wall.model == 0 || wall.inside;
    at += free ? out : out * stop_short(body, particle, at, out, wall);
    return free;
}

void Collider::slide(Body& body, uint32_t particle, Vec3 from, Vec3 displacement, double time,
                     double bounce_threshold) const {
    Impact impact;
    if (sweep(particle, from, displacement, time, impact)) {
        record(body, particle, impact);
        slide(body, particle, from, displacement, time, bounce_threshold, impact);
    } else {
        body.particles.position[particle] = from + displacement;
    }
}

void Collider::slide(Body& body, uint32_t particle, Vec3 from, Vec3 displacement, double time, double bounce_threshold,
                     Impact impact) const {
    Vec3 at = from;
    const Vec3& velocity = body.particles.velocity[particle];
    for (int contact = 1;; ++contact) {
        gphys_model_id ignored = 0;  // the model that the particle leaves at a limited speed
        if (impact.inside) {
            const Vec3 out = minimum_translation(body, particle, at, impact);
            const double depth = length(out);
            if (depth <= most_push_) {
                // Not through another model: a mesh has no inside from which the particle would come back. It is pushed
                // along that one instead, and its velocity may take it out.
                Impact wall;
                if (!push(body, particle, at, out, impact.model, wall)) {
                    const Vec3 along = out + wall.normal * std::max(0.0, -dot(out, wall.normal));
                    push(body, particle, at, along, impact.model, wall);
                    ignored = impact.model;
                }
            } else {
                ignored = impact.model;
                body.contacts.penetrating = true;
                impact.normal = out / depth;
                impact.point = at + out - impact.normal * body.particles.radius[particle];
                record(body, particle, impact);
            }
        } else if (impact.moves && time < around_.end) {
            // Move with the model to the end of the substep; the remaining displacement is relative to it.
            const Vec3 hit = at + displacement * impact.t;
            impact = at_substep_end(impact);
            at = place_off_model(body, particle, hit, impact);
            displacement = displacement * (1 - impact.t) - (at - hit);
            time = around_.end;
        } else {
            const double t = stop_short(body, particle, at, displacement, impact);
            at += displacement * t;
            displacement *= 1 - t;
            time += (around_.end - time) * t;
        }
        const double approach = -dot(velocity - impact.surface_velocity, impact.normal);
        const bool was_stuck = body.settings.sticks() && body.contacts.stuck[particle];
        bounce(body, particle, impact, approach > bounce_threshold ? body.settings.restitution : 0);
        const bool stays = was_stuck && body.contacts.stuck[particle];
        // The remaining displacement goes along the surface, shortened by friction.
        const double into = -dot(displacement, impact.normal);
        if (into > 0) {
            const Vec3 along = displacement + impact.normal * into;
            const double sliding = length(along);
            const Friction friction = friction_coefficients(body, particle);
            const double hold = (stays ? friction.at_rest : friction.kinetic) * into;
            displacement = sliding <= hold ? Vec3{} : along * (1 - hold / sliding);
        }
        if (contact > most_contacts) break;
        if (contact == most_contacts) displacement = {};
        // A moving model may still hit a particle that stays where it is.
        if (displacement == Vec3{} && (moving_count_ == 0 || time == around_.end)) break;
        impact = {};
        if (!sweep_others(particle, at, displacement, time, ignored, impact)) {
            at += displacement;
            break;
        }
        record(body, particle, impact);
    }
    body.particles.position[particle] = at;
    keep_in_range(body.particles.position[particle], body.particles.velocity[particle]);
}

Box swept_box(const Body& body, const Vector<Vec3>& from, const Vector<Vec3>& to, double margin) {
    Aabb all{from[0], from[0]};
    double longest = 0;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        all.min = min(all.min, min(from[p], to[p]));
        all.max = max(all.max, max(from[p], to[p]));
        longest = std::max(longest, length_squared(to[p] - from[p]));
    }
    const double room = 2 * body.particles.largest_radius + std::sqrt(longest) + margin;
    return bounds(Aabb{all.min - Vec3{room, room, room}, all.max + Vec3{room, room, room}});
}

void Collider::slide_along_contacts(Body& body, uint32_t particle, Vec3 displacement) const {
    const ContactPoint* point = &body.contacts.points[size_t{particle} * contact_points_per_particle];
    for (uint32_t i = 0; i < contact_point_count(body, particle); ++i) {
        const Vec3 normal = widen(point[i].normal);
        displacement += normal * std::max(0.0, -dot(displacement, normal));
    }
    Vec3& at = body.particles.position[particle];
    Impact impact;
    const bool free = !sweep(particle, at, displacement, around_.end, impact);
    if (!impact.inside) at += free ? displacement : displacement * stop_short(body, particle, at, displacement, impact);
}

namespace {

double longest_link(const Body& body) {
    double longest = 0;
    for (uint32_t slot = 0; slot < body.constraints.ids.slots(); ++slot) {
        if (!body.constraints.ids.live(slot)) continue;
        const DistanceConstraint& link = body.constraints.by_slot[slot];
        longest =
            std::max({longest, link.rest, distance(body.particles.position[link.a], body.particles.position[link.b])});
    }
    return longest;
}

uint32_t most_links_of_a_particle(const Body& body) {
    uint32_t most = 0;
    for (const Links& links : body.constraints.links) most = std::max(most, links.degree);
    return most;
}

/// Contacts at both ends of a link may change its length, and friction would keep it so. Restores the length by
/// displacements along the surfaces.
void relax_links_between_contacts(const Collider& collider, Body& body) {
    // Below this strain, which is invisible, resting particles are left alone.
    constexpr double slack = 1e-4;
    for (uint32_t slot = 0; slot < body.constraints.ids.slots(); ++slot) {
        const DistanceConstraint& link = body.constraints.by_slot[slot];
        if (!body.contacts.held[link.a] || !body.contacts.held[link.b] || !body.constraints.ids.live(slot)) continue;
        const Vec3 along = body.particles.position[link.b] - body.particles.position[link.a];
        const double length = gphys::length(along), error = excess(body.particles, link);
        const double wa = body.particles.inverse_mass[link.a], wb = body.particles.inverse_mass[link.b];
        if (link.compliance > 0 || std::fabs(error) <= slack * link.rest || length == 0 || wa + wb == 0) continue;
        const Vec3 correction = along * (error / (length * (wa + wb)));
        collider.slide_along_contacts(body, link.a, correction * wa);
        collider.slide_along_contacts(body, link.b, correction * -wb);
    }
}

/// The pulls of links on a particle that friction holds are impulses on the model. Pulls from before the second
/// solution are in its velocity, and are transferred from there.
void add_impulses_through_held(Body& body, const CollisionContext& around, const SolvedAgain& again) {
    const auto add_to_holder = [&](uint32_t p, Vec3 impulse) {
        if (body.contacts.held[p] && !body.particles.pinned(p)) add_holder_impulse(body, around, p, impulse);
    };
    const double to_impulse = again.to_impulse();
    for (const Chain& chain : body.plan.chains) {
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const uint32_t a = body.plan.particles[chain.first_particle + i];
            const uint32_t b = body.plan.particles[chain.first_particle + i + 1];
            if (!body.contacts.held[a] && !body.contacts.held[b]) continue;
            const Vec3 pull =
                link_direction(body.particles, a, b) * (body.rope.tension[chain.first_link + i] * to_impulse);
            add_to_holder(a, pull);
            add_to_holder(b, -pull);
        }
    }
    each_bending_force(body.rope.bending, body.plan, body.particles.position,
                       [&](uint32_t p, Vec3 force) { add_to_holder(p, force * to_impulse); });
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        add_to_holder(p, (body.history.predicted[p] - body.rope.solved[p]) * (body.particles.mass[p] * again.rate));
    }
}

}  // namespace

void add_holder_impulse(Body& body, const CollisionContext& around, uint32_t particle, Vec3 impulse) {
    const ContactPoint& point =
        body.contacts.points[size_t{particle} * contact_points_per_particle + body.contacts.held[particle] - 1];
    add_impulse(body, around, point.model,
                body.particles.position[particle] - widen(point.normal) * body.particles.radius[particle], impulse);
}

void collide(Body& body, const CollisionContext& around, double bounce_threshold) {
    body.contacts.has_contact = body.contacts.penetrating = false;
    if (!around.scene || body.settings.layers == 0) return;
    const Collider& collider =
        around.memory->collider.emplace(around, body, swept_box(body, body.history.start, body.particles.position, 0));
    if (collider.idle()) return;
    std::fill(body.contacts.held.begin(), body.contacts.held.end(), uint8_t{0});
    body.rope.solved = body.particles.position;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (!body.particles.pinned(p))
            collider.slide(body, p, body.history.start[p], body.particles.position[p] - body.history.start[p],
                           around.begin, bounce_threshold);
    }
}

void relax_contacts(Body& body, const CollisionContext& around) {
    // Each link of a particle moves it by less than the longest link.
    const double margin = most_links_of_a_particle(body) * longest_link(body);
    const Collider& collider = around.memory->collider.emplace(
        around, body, swept_box(body, body.particles.position, body.particles.position, margin));
    relax_links_between_contacts(collider, body);
    body.history.start = body.particles.position;
}

void collide_again(Body& body, const CollisionContext& around, double bounce_threshold, const SolvedAgain& again) {
    add_impulses_through_held(body, around, again);
    const Collider& collider =
        around.memory->collider.emplace(around, body, swept_box(body, body.history.start, body.particles.position, 0));
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p) || body.contacts.held[p]) continue;
        const Vec3 displacement = body.particles.position[p] - body.history.start[p];
        body.particles.velocity[p] += displacement * again.rate;
        collider.slide(body, p, body.history.start[p], displacement, around.end, bounce_threshold);
    }
}

}  // namespace gphys
