// The search for the planes near a block of particles, and sweeps against them (flight_planes.h).
#include "solver/particles/flight_planes.h"

namespace gphys {
namespace {

/// The box of particles with their centres in another one, enlarged by more than the rounding of positions.
Box around(const Aabb& centers, double radius) {
    const double by = radius + skin(radius, max(abs(centers.min), abs(centers.max)));
    return bounds(Aabb{centers.min - Vec3{by, by, by}, centers.max + Vec3{by, by, by}});
}

}  // namespace

void FlightPlanes::select(const Body& body, const CollisionContext& step, uint32_t first, uint32_t count) {
    scene_ = step.scene;
    moved_ = step.moved;
    first_ = first;
    count_ = count;
    layers_ = body.settings.layers;
    share_ = step.share;
}

/// Particles at the place of the last search, among the same models, keep their balls.
void FlightPlanes::reset_balls(const Body& body, bool keep) {
    for (uint32_t i = 0; i < count_; ++i) {
        const Vec3 at = body.particles.position[first_ + i];
        balls_[i].in_use = false;
        if (keep && balls_[i].center == at) continue;
        balls_[i].center = at;
        balls_[i].sight = Sight::not_searched;
    }
}

/// Lists the models that move and may come near the particles, which go as far as `way` in the rest of the step, and
/// near their balls.
void FlightPlanes::find_still(const Body& body, double way) {
    std::fill_n(still_, count_, scene_ != nullptr);
    moving_count_ = 0;
    if (!scene_ || moved_->empty()) return;
    Aabb all{body.particles.position[first_], body.particles.position[first_]};
    for (uint32_t p = first_; p < first_ + count_; ++p) {
        all = {min(all.min, body.particles.position[p]), max(all.max, body.particles.position[p])};
    }
    // Slow particles move by at most their radius, and their surface reaches as far again, twice.
    constexpr double ball_reach = 3;
    const Box near_balls = around(all, ball_reach * body.particles.largest_radius);
    const Box near_ways = around(all, body.particles.largest_radius + way);
    uint32_t near_count = 0;
    for (uint32_t i = 0; i < moved_->size(); ++i) {
        const MovedModel& before = (*moved_)[i];
        if (!(scene_->layers(before.model) & layers_)) continue;
        if (!before.bounded || overlaps(before.swept, near_balls)) {
            if (near_count < most_near) near_[near_count] = i;
            ++near_count;
        }
        if (before.bounded && !overlaps(before.swept, near_ways)) continue;
        if (moving_count_ < most_moving) moving_[moving_count_] = i;
        ++moving_count_;
    }
    if (near_count == 0) return;
    for (uint32_t i = 0; i < count_; ++i) {
        const Vec3 at = body.particles.position[first_ + i];
        const Box near_ball = around({at, at}, ball_reach * body.particles.radius[first_ + i]);
        still_[i] = near_count <= most_near && std::none_of(near_, near_ + near_count, [&](uint32_t k) {
                        const MovedModel& model = (*moved_)[k];
                        return !model.bounded || overlaps(model.swept, near_ball);
                    });
    }
}

void FlightPlanes::begin(Body& body, const CollisionContext& step, Vec3 gravity, uint32_t first, uint32_t count) {
    select(body, step, first, count);
    pushed_ = false;
    resting_ = 0;
    std::fill_n(ways_, count, Sight::not_searched);
    std::fill_n(rests_, count, false);
    std::fill_n(moving_of_, count, gphys_model_id{0});
    const bool kept = !body.flight.all.empty();
    balls_ = kept ? &body.flight.all[first] : own_balls_;
    reset_balls(body, kept && body.flight.current());
    double fastest = 0;
    for (uint32_t p = first; p < first + count; ++p)
        fastest = std::max(fastest, length_squared(body.particles.velocity[p]));
    find_still(body, step.step_time * (std::sqrt(fastest) + step.step_time * length(gravity)));
}

void FlightPlanes::select_pushed(Body& body, const CollisionContext& substep, uint32_t first, uint32_t count) {
    select(body, substep, first, count);
    pushed_ = true;
    balls_ = &body.flight.all[first];
}

void FlightPlanes::begin_pushed(Body& body, const CollisionContext& substep, uint32_t first, uint32_t count) {
    select_pushed(body, substep, first, count);
    if (substep.begin == 0) reset_balls(body, body.flight.current());
    find_still(body, 0);
}

bool FlightPlanes::is_moved(gphys_model_id model) const { return find_moved(*moved_, model) != nullptr; }

Sight FlightPlanes::search_way(double radius, const FlightWay& way) const {
    if (!scene_ || moving_count_ > most_moving) return Sight::blocked;
    const Box box = around(way.box, radius);
    bool clear = true;
    // Models that move are in the scene at their present places.
    for (uint32_t i = 0; i < moving_count_; ++i) {
        if (crosses((*moved_)[moving_[i]], radius, way)) return Sight::blocked;
    }
    scene_->for_each_in_box(box, layers_, [&](gphys_model_id model) {
        clear = clear && (is_moved(model) || !scene_->overlaps_box(model, box));
    });
    return clear ? Sight::clear : Sight::blocked;
}

/// Relative to a model that turns, a path is curved. In units of the rest of the step its second derivative is at most
/// |x - c| (w^2 + w') + 2 |x' - c'| w + |x''|, with the angular velocity w and the place c of the model; it is no
/// farther from its chord than an eighth of that.
bool FlightPlanes::crosses(const MovedModel& before, double radius, const FlightWay& way) const {
    if (before.bounded && !overlaps(before.swept, around(way.box, radius))) return false;
    const gphys_transform& after = scene_->world(before.model);
    if (before.world.scale != after.scale) return true;
    const Transform now = widen(after), then = interpolate(before.world, after, share_ * way.begin);
    const Transform end = share_ < 1 ? interpolate(before.world, after, share_) : now;
    const double tangent = quarter_tangent(then.rotation, end.rotation);
    const double turn = 4 * tangent, change = 16 * tangent * tangent * tangent;
    const double relative = way.speed * way.seconds + distance(then.position, end.position);
    const double away = distance(way.from, then.position) + relative;
    const double bulge =
        (away * (turn * turn + change) + 2 * relative * turn + way.curvature * way.seconds * way.seconds) / 8;
    const Vec3 from = now.apply(then.inverse_apply(way.from));
    const Vec3 to = share_ < 1 ? now.apply(end.inverse_apply(way.to)) : way.to;
    return scene_->overlaps_box(before.model, around({min(from, to), max(from, to)}, radius + bulge));
}

/// Searches together with the particles that follow in memory and are nearby.
void FlightPlanes::search(const Body& body, uint32_t particle) {
    Aabb places{ball(particle).center, ball(particle).center};
    uint32_t together = 1;
    for (; together < ClosestFeatures::most_points && particle + together < first_ + count_; ++together) {
        const FlightBall& next = ball(particle + together);
        places = {min(places.min, next.center), max(places.max, next.center)};
        const double size = 16 * body.particles.largest_radius;
        if (next.sight != Sight::not_searched || max_component(places.max - places.min) > size) break;
    }
    if (search_together(body, particle, together)) return;
    for (uint32_t p = particle; p < particle + together; ++p) {
        if (!search_together(body, p, 1)) ball(p).sight = Sight::blocked;
    }
}

/// Returns false, without result, if too many models or parts are near.
bool FlightPlanes::search_together(const Body& body, uint32_t particle, uint32_t count) {
    Aabb places{ball(particle).center, ball(particle).center};
    double farthest = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const Vec3 at = ball(particle + i).center;
        probes_[i] = {at, 2 * body.particles.radius[particle + i]};
        places = {min(places.min, at), max(places.max, at)};
        farthest = std::max(farthest, probes_[i].radius);
    }
    const Vec3 room{farthest, farthest, farthest};
    parts_.clear(count);
    bool complete = true;
    scene_->for_each_in_box(bounds(Aabb{places.min - room, places.max + room}), layers_, [&](gphys_model_id model) {
        if (!is_moved(model)) complete = parts_.add(*scene_, model, 0, probes_) && complete;
    });
    for (uint32_t i = 0; i < count && complete; ++i) settle(body.particles.radius[particle + i], i, ball(particle + i));
    return complete;
}

void FlightPlanes::settle(double radius, uint32_t point, FlightBall& ball) {
    const double gap = skin(radius, ball.center);
    ball.count = 0;
    ball.sight = Sight::clear;
    parts_.select_point(point);
    for (ClosestFeature part; parts_.pop_nearest(part); ++ball.count) {
        // Too many parts; or the particle overlaps one, and has to be pushed out.
        if (ball.count == FlightBall::most_planes || part.distance <= radius) {
            ball.sight = Sight::blocked;
            return;
        }
        const double height = dot(part.normal, part.closest) + radius;
        ball.planes[ball.count] = {part.normal, height, part.model};
        // Coplanar triangles share a plane.
        if (part.is_triangle) parts_.cull_behind(part.normal, height - radius + gap / 2, 0);
    }
}

bool FlightBall::sweep(Vec3 from, Vec3 displacement, double radius, const Plane*& first, double& t) const {
    first = nullptr;
    t = infinity;
    if (sight != Sight::clear || !contains(from, radius) || !contains(from + displacement, radius)) return false;
    for (const Plane* plane = planes; plane != planes + count; ++plane) {
        const double gap = dot(plane->normal, from) - plane->height, approach = -dot(plane->normal, displacement);
        if (gap < 0) return false;
        if (approach <= gap) continue;
        const double there = gap / approach;
        if (there < t || (there == t && plane->model < first->model)) t = there, first = plane;
    }
    return true;
}

const FlightBall::Plane* FlightBall::find_contact(Vec3 from, Vec3 displacement, double radius, double gap) const {
    const Plane* found;
    double t;
    if (!sweep(from, displacement, radius, found, t)) return nullptr;
    if (found) return found;
    for (const Plane* plane = planes; plane != planes + count; ++plane) {
        const double distance = dot(plane->normal, from) - plane->height;
        if (distance <= gap) found = plane, gap = distance;
    }
    return found;
}

bool FlightBall::clear_of_others(const Plane& plane, Vec3 at, double radius) const {
    if (!contains(at, radius)) return false;
    return std::all_of(planes, planes + count,
                       [&](const Plane& other) { return &other == &plane || dot(other.normal, at) >= other.height; });
}

bool FlightPlanes::sweep(const Body& body, uint32_t p, Vec3 from, Vec3 displacement, double reach, Impact& impact) {
    if (!scene_ || reach > body.particles.radius[p]) return false;
    if (ball(p).sight == Sight::not_searched) search(body, p);
    ball(p).in_use = true;
    return sweep_known(body, p, from, displacement, impact);
}

bool FlightPlanes::sweep_known(const Body& body, uint32_t p, Vec3 from, Vec3 displacement, Impact& impact) const {
    if (!ball(p).in_use) return false;
    const double radius = body.particles.radius[p];
    const FlightBall::Plane* plane;
    double t;
    if (!ball(p).sweep(from, displacement, radius, plane, t)) return false;
    impact = {};
    if (!plane) return true;
    impact.t = t;
    impact.model = plane->model;
    impact.center = from + displacement * t;
    impact.point = impact.center - plane->normal * radius;
    impact.normal = plane->normal;
    return true;
}

const FlightBall* FlightPlanes::moving_ball(const Body& body, uint32_t p, gphys_model_id model, Vec3 from,
                                            Vec3 displacement) {
    if (pushed_) return nullptr;
    const double radius = body.particles.radius[p];
    FlightBall& ball = moving_balls_[p - first_];
    gphys_model_id& of = moving_of_[p - first_];
    if (of != model || !ball.contains(from, radius) || !ball.contains(from + displacement, radius)) {
        // A search takes as long as the sweeps of a few substeps.
        if ((of != 0 && of != model) || 4 * length(displacement) > radius) return nullptr;
        of = model;
        ball.center = from;
        ball.sight = Sight::blocked;
        probes_[0] = {from, 2 * radius};
        parts_.clear(1);
        if (parts_.add(*scene_, model, 0, probes_)) settle(radius, 0, ball);
    }
    return ball.sight == Sight::clear ? &ball : nullptr;
}

TriState FlightPlanes::sweep_moving(const Body& body, uint32_t p, gphys_model_id model, Vec3 from, Vec3 displacement,
                                    Hit& hit) {
    const double radius = body.particles.radius[p];
    const FlightBall* const ball = moving_ball(body, p, model, from, displacement);
    const FlightBall::Plane* plane;
    double t;
    if (!ball || !ball->sweep(from, displacement, radius, plane, t)) return TriState::undecided;
    if (!plane) return TriState::no;
    hit.t = t;
    hit.normal = plane->normal;
    hit.point = from + displacement * t - plane->normal * radius;
    hit.flags = 0;
    return TriState::yes;
}

}  // namespace gphys
