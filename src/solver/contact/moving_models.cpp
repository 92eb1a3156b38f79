// Particles and models that move during a step (collision.h): the bounds of such a motion, sweeps, and contact that
// lasts, with friction.
//
// A sweep uses the motion of the particle relative to the model, with a common time. A path starts at the place and at
// the time at which the previous path ended. So the relative paths have no gaps, and no particle passes through a
// model.
#include "solver/contact/collision.h"
#include "solver/contact/friction.h"
#include "solver/particles/flight_planes.h"

namespace gphys {

const MovedModel* find_moved(const Vector<MovedModel>& moved, gphys_model_id model) {
    const auto at = std::lower_bound(moved.begin(), moved.end(), model,
                                     [](const MovedModel& one, gphys_model_id id) { return one.model < id; });
    return at != moved.end() && at->model == model ? &*at : nullptr;
}

namespace {

/// Of any length, along the shorter arc.
Quat between(const gphys_quat& from, const gphys_quat& to, double fraction) {
    const double rest = 1 - fraction;
    const Quat a = widen(from), b = widen(to);
    const double sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0 ? -1 : 1;
    return {a.x * rest + sign * b.x * fraction, a.y * rest + sign * b.y * fraction, a.z * rest + sign * b.z * fraction,
            a.w * rest + sign * b.w * fraction};
}

}  // namespace

Transform interpolate(const gphys_transform& from, const gphys_transform& to, double fraction) {
    const double rest = 1 - fraction;
    return {widen(from.position) * rest + widen(to.position) * fraction,
            rotation_matrix(between(from.rotation, to.rotation, fraction)), from.scale * rest + to.scale * fraction};
}

gphys_transform narrow_interpolate(const gphys_transform& from, const gphys_transform& to, double fraction) {
    const Transform place = interpolate(from, to, fraction);
    return {narrow(place.position), narrow(normalized(between(from.rotation, to.rotation, fraction))),
            static_cast<float>(place.scale)};
}

/// A point of the model is at c + k R q, where q is its place relative to that of the model in the scene. The position
/// c goes along a segment, R q along an arc, which is no farther from its chord than 1 - cos(angle / 2) times |q|, and
/// the factor k goes to 1.
MovedModel::MovedModel(const Scene& scene, const PlacedModel& before) : PlacedModel(before) {
    Box now;
    bounded = scene.bounds(model, now);
    if (!bounded) return;
    const Transform from = widen(world), to = widen(scene.world(model));
    const double factor = from.scale / to.scale;
    const Vec3 low = widen(now).min - to.position, high = widen(now).max - to.position;
    const Mat3 turn = from.rotation * transposed(to.rotation);
    const Vec3 middle = turn * ((low + high) / 2), extents = (high - low) / 2;
    const Vec3 half = abs(turn) * extents;
    const Vec3 least = min(low, middle - half), most = max(high, middle + half);
    const double tangent = quarter_tangent(from.rotation, to.rotation), squared = tangent * tangent;
    const double reach = length(max(abs(low), abs(high))) * std::max(1.0, factor);
    // The rounding of all this is some 1e-15 of the coordinates.
    const double rounding = 1e-12 * (reach + max_component(max(abs(from.position), abs(to.position))));
    const double room = 2 * squared / (1 + squared) * reach + rounding;
    swept = bounds(Aabb{min(from.position, to.position) + min(least, least * factor) - Vec3{room, room, room},
                        max(from.position, to.position) + max(most, most * factor) + Vec3{room, room, room}});
}

Collider::Moving Collider::moving(const PlacedModel& before) const {
    const gphys_transform& after = around_.scene->world(before.model);
    const Transform begin = interpolate(before.world, after, around_.way(around_.begin));
    const Transform end = interpolate(before.world, after, around_.way(around_.end)), now = widen(after);
    const Mat3 turn = end.rotation * transposed(begin.rotation);
    const Vec3 axial{turn.y.z - turn.z.y, turn.z.x - turn.x.z, turn.x.y - turn.y.x};
    Moving result{before.model,
                  begin,
                  end,
                  now,
                  {begin, now},
                  {end, now},
                  before.world,
                  axial / (2 * around_.step_time * (around_.end - around_.begin)),
                  0,
                  false,
                  {}};
    result.tangent = quarter_tangent(result.begin.rotation, result.end.rotation);
    result.bounded = around_.scene->bounds(before.model, result.box);
    return result;
}

/// At a fraction of the step.
Transform Collider::Moving::at(double time, const CollisionContext& around) const {
    if (time == around.begin) return begin;
    return time == around.end ? end : interpolate(before, around.scene->world(model), around.way(time));
}

template <class Visit>
void Collider::for_each_moving(const Box& box, Visit&& visit) const {
    const auto may_meet = [&](const MovedModel& model) { return !model.bounded || overlaps(model.swept, box); };
    if (moving_count_ <= most_listed) {
        for (uint32_t i = 0; i < moving_count_; ++i) {
            const MovedModel& model = (*around_.moved)[moving_[i]];
            if (may_meet(model)) i < most_placed ? visit(placed_[i]) : visit(moving(model));
        }
        return;
    }
    for (const MovedModel& model : *around_.moved) {
        if (may_meet(model) && (around_.scene->layers(model.model) & body_.settings.layers)) visit(moving(model));
    }
}

/// A model pushes a particle that it hits at most as far as it moves, and a bounce adds at most the same distance.
Box Collider::bounds_of_pushed(const Box& paths) const {
    const Aabb all = widen(paths);
    double furthest = 0;
    for_each_moving(paths, [&](const Moving& moving) {
        for (const double part : {0.5, 1.0}) {
            const Transform then = moving.at(around_.begin + (around_.end - around_.begin) * part, around_);
            for (int corner = 0; corner < 8; ++corner) {  // corners move farther than the points between them
                const Vec3 at{corner & 1 ? all.min.x : all.max.x, corner & 2 ? all.min.y : all.max.y,
                              corner & 4 ? all.min.z : all.max.z};
                furthest = std::max(furthest, distance(at, then.apply(moving.begin.inverse_apply(at))));
            }
        }
    });
    const Vec3 room = Vec3{1, 1, 1} * (2 * furthest);
    return bounds(Aabb{all.min - room, all.max + room});
}

void Collider::list_moving(const Box& box) {
    moving_count_ = 0;
    for (uint32_t i = 0; i < around_.moved->size(); ++i) {
        const MovedModel& before = (*around_.moved)[i];
        if (!(around_.scene->layers(before.model) & body_.settings.layers)) continue;
        if (before.bounded && !overlaps(before.swept, box)) continue;
        if (moving_count_ < most_placed) placed_[moving_count_] = moving(before);
        if (moving_count_ < most_listed) moving_[moving_count_] = i;
        ++moving_count_;
    }
}

namespace {

/// The number of parts into which to divide a path, so that each is almost straight relative to a model that rotates or
/// grows. Relative to it the path is y = R^T (x - c) / s with a second derivative of at most (|x - c| (w^2 + w' + 2 w
/// s' / s + 2 (s' / s)^2) + 2 |x' - c'| (w + s' / s)) / s. Of n parts, none is farther from its chord than that over 8
/// n^2. A quarter of the radius is small enough: what the centre passes through, the sphere hits on the chord.
uint32_t parts_of_path(const Transform& begin, const Transform& end, Vec3 from, Vec3 displacement, double tangent,
                       double radius, double& bulge) {
    constexpr uint32_t most = 64;  // for points, which have no radius
    const Vec3 relative = displacement - (end.position - begin.position);
    const double least = std::min(begin.scale, end.scale), growth = std::fabs(end.scale - begin.scale) / least;
    const double away = length(from - begin.position) + length(relative);
    const double speed = 4 * tangent, change = 16 * tangent * tangent * tangent;
    bulge = (away * (speed * speed + change + 2 * speed * growth + 2 * growth * growth) +
             2 * length(relative) * (speed + growth)) /
            (8 * least);
    const double most_bulge = radius / (4 * std::max(begin.scale, end.scale));
    if (bulge <= most_bulge) return 1;
    return bulge < most * most * most_bulge ? static_cast<uint32_t>(std::sqrt(bulge / most_bulge)) + 1 : most;
}

}  // namespace

/// sin(angle / 2) / (1 + cos(angle / 2)).
double quarter_tangent(const Mat3& a, const Mat3& b) {
    // a.x - b.x|^2 + ... = 4 (1 - cos). Added to 1, the rounding of equal rotations vanishes.
    const double square = length_squared(a.x - b.x) + length_squared(a.y - b.y) + length_squared(a.z - b.z);
    const double cosine = std::max(-1.0, 1 - square / 4);
    return std::sqrt((1 - cosine) / 2) / (1 + std::sqrt((1 + cosine) / 2));
}

Transform Collider::place_at_end(gphys_model_id moved) const {
    const Moving *const listed = placed_, *const end = listed + std::min(moving_count_, most_placed);
    const Moving* const found = std::find_if(listed, end, [&](const Moving& m) { return m.model == moved; });
    if (found != end) return found->end;
    return interpolate(find_moved(around_, moved)->world, around_.scene->world(moved), around_.way(around_.end));
}

/// Relative to the model, which also moves during the substep: the points of the path are transformed into the model's
/// coordinates, each at its own time, and from there to the model's present place in the scene.
void Collider::sweep_moved(const Moving& model, uint32_t particle, const Sphere& moving, Vec3 displacement, double time,
                           Impact& first) const {
    const Transform& now = model.now;
    const Transform at_begin = model.at(time, around_);
    const Vec3 last = now.apply(model.end.inverse_apply(moving.center + displacement));
    Vec3 from = now.apply(at_begin.inverse_apply(moving.center));
    double bulge = 0;
    const double tangent =
        time == around_.begin ? model.tangent : quarter_tangent(at_begin.rotation, model.end.rotation);
    const uint32_t parts =
        parts_of_path(at_begin, model.end, moving.center, displacement, tangent, moving.radius, bulge);
    const auto may_hit = [&](const Sphere& relative, Vec3 path) {
        return !model.bounded || overlaps(model.box, path_box(relative, path));
    };
    const bool searched = planes_ && planes_->has_searched(particle, model.model);
    if (!searched && !may_hit({from, moving.radius + bulge * now.scale}, last - from)) return;
    const auto hits = [&](const Sphere& relative, Vec3 path, Hit& hit) {
        if (planes_) {
            const TriState known = planes_->sweep_moving(body_, particle, model.model, relative.center, path, hit);
            if (known != TriState::undecided) return known == TriState::yes;
        }
        return may_hit(relative, path) && around_.scene->sweep_model(model.model, relative, path, hit);
    };
    for (uint32_t i = 1; i <= parts; ++i) {
        const double part = static_cast<double>(i) / parts;
        const Vec3 to = i == parts ? last
                                   : now.apply(model.at(time + (around_.end - time) * part, around_)
                                                   .inverse_apply(moving.center + displacement * part));
        const Vec3 path = to - from;
        Hit hit;
        if (hits({from, moving.radius}, path, hit)) {
            hit.t = (i - 1 + hit.t) / parts;
            const double when = time + (around_.end - time) * hit.t;
            const Transform there = model.at(when, around_);
            const auto placed = [&](Vec3 p) { return there.apply(now.inverse_apply(p)); };
            const Vec3 on_model = now.inverse_apply(hit.point);
            const Vec3 moved_by = model.end.apply(on_model) - model.begin.apply(on_model);
            const double seconds = around_.step_time * (around_.end - around_.begin);
            keep_first(first, {hit.t, model.model, i == 1 && (hit.flags & GPHYS_HIT_INSIDE) != 0, true, when, there,
                               placed(from + path * (hit.t * parts - (i - 1))), placed(hit.point),
                               there.rotation * transpose_times(now.rotation, hit.normal), moved_by / seconds});
            return;
        }
        from = to;
    }
}

Impact Collider::at_substep_end(const Impact& impact) const {
    if (impact.time == around_.end) return impact;
    const Transform& then = impact.place;
    const Transform end = place_at_end(impact.model);
    Impact later = impact;
    later.time = around_.end;
    later.place = end;
    later.center = end.apply(then.inverse_apply(impact.center));
    later.point = end.apply(then.inverse_apply(impact.point));
    later.normal = end.rotation * transpose_times(then.rotation, impact.normal);
    return later;
}

void Collider::sweep_moving(uint32_t particle, Vec3 from, Vec3 displacement, double time, gphys_model_id ignored,
                            Impact& first) const {
    const Sphere moving{from, body_.particles.radius[particle]};
    for_each_moving(path_box(moving, displacement), [&](const Moving& model) {
        if (model.model != ignored) sweep_moved(model, particle, moving, displacement, time, first);
    });
}

bool Collider::try_slide_on_moving(Body& body, uint32_t particle, Vec3 displacement, Vec3 velocity) const {
    if (!planes_) return false;
    const double radius = body.particles.radius[particle];
    const Vec3 at = body.particles.position[particle];
    bool slides = false;
    for_each_moving(path_box({at, radius + largest_gap(skin(radius, at))}, displacement), [&](const Moving& model) {
        slides = slides || try_slide_on(model, body, particle, displacement, velocity);
    });
    return slides;
}

/// Coulomb's law in terms of impulses (Moreau's time stepping), relative to the place that the particle has on the
/// model. A model that speeds up has one speed in each step, so it starts each with a jump. What friction can give to a
/// particle in contact is therefore that of the rest of the step: it follows the model as one that speeds up evenly.
bool Collider::try_slide_on(const Moving& model, Body& body, uint32_t particle, Vec3 displacement,
                            Vec3 velocity) const {
    if (model.begin.scale != model.end.scale) return false;
    const Vec3 at = body.particles.position[particle], velocity_before = body.particles.velocity[particle];
    const double radius = body.particles.radius[particle], room = skin(radius, at);
    const double seconds = around_.step_time * (around_.end - around_.begin);
    const Vec3 from = model.from_begin.apply(at), path = model.from_end.apply(at + displacement) - from;
    if (!planes_->has_searched(particle, model.model) && model.bounded &&
        !overlaps(model.box, path_box({from, radius + room}, path))) {
        return false;
    }
    const FlightBall* const ball = planes_->moving_ball(body, particle, model.model, from, path);
    const FlightBall::Plane* const plane = ball ? ball->find_contact(from, path, radius, largest_gap(room)) : nullptr;
    if (!plane) return false;
    const double gap = dot(plane->normal, from) - plane->height;
    const bool touches = gap <= largest_gap(room);
    const Vec3 normal = model.from_end.inverse_turn(plane->normal), carried = model.from_end.inverse_apply(from);
    const Vec3 surface_velocity = (carried - at) * (1 / seconds);

    // The change of velocity that keeps the particle at its place, in this substep and in the rest of the step.
    const Vec3 gained = velocity - velocity_before, change = surface_velocity - velocity;
    const double later = touches ? around_.step_time * (1 - around_.end) : 0;
    const Vec3 centripetal = cross(model.spin, cross(model.spin, at - model.begin.position));
    const Vec3 whole_change = change + centripetal * later - gained * (later / seconds);
    const double pressing = dot(change, normal), whole_pressing = dot(whole_change, normal);
    const double approach = dot(surface_velocity - velocity_before, normal);
    // One that arrives at speed, or bounces, is moved from one impact to the next.
    if (body.settings.restitution * approach > std::max(0.0, whole_pressing - approach)) return false;
    if (!touches && gap > pressing * seconds) return false;

    const bool stays = whole_pressing >= 0 &&
                       length(whole_change - normal * whole_pressing) <= friction_of(body, particle) * whole_pressing;
    Vec3 end = carried + normal * (room - gap), end_velocity = surface_velocity;
    if (!stays) {
        if (pressing < 0) return false;
        const double friction = friction_coefficients(body, particle).kinetic;
        const Vec3 way = at + displacement - carried, tangential = change - normal * pressing;
        const double into = -dot(way, normal), sliding = length(tangential);
        const Vec3 along = way + normal * into;
        const double longest = length(along);
        if (longest > friction * into) end += along * (1 - friction * into / longest);
        if (sliding > friction * pressing) end_velocity -= tangential * (1 - friction * pressing / sliding);
    }
    if (!ball->clear_of_others(*plane, model.from_end.apply(end), radius)) return false;
    Impact other;
    sweep_unmoved(particle, at, end - at, 0, other);
    sweep_moving(particle, at, end - at, around_.begin, model.model, other);
    if (other.model != 0) return false;

    const Vec3 point = end - normal * radius;
    record(body, particle, model.model, point, normal);
    if (body.settings.sticks()) body.contacts.stuck[particle] = stays;
    add_impulse(accumulator_.impulses, around_, model.model, point,
                (velocity - end_velocity) * body.particles.mass[particle]);
    body.particles.position[particle] = end;
    body.particles.velocity[particle] = end_velocity;
    return true;
}

Vec3 Collider::place_off_model(const Body& body, uint32_t particle, Vec3 at, const Impact& impact) const {
    Vec3 displacement = impact.center + impact.normal * skin(body.particles.radius[particle], at) - at;
    for (int contact = 0; contact < 3; ++contact) {  // a corner has three
        Impact stopped;
        sweep_unmoved(particle, at, displacement, 0, stopped);
        if (stopped.model == 0) return at + displacement;
        const double t = stopped.inside ? 0 : stop_short(body, particle, at, displacement, stopped);
        at += displacement * t;
        displacement *= 1 - t;
        displacement += stopped.normal * std::max(0.0, -dot(displacement, stopped.normal));
    }
    return at;
}

}  // namespace gphys
