// The search for the planes near a block of particles, and sweeps against them (flight_planes.h).
#include "solver/particles/flight_planes.h"

namespace gphys {

void FlightPlanes::begin(const Body& body, const CollisionContext& step, uint32_t first, uint32_t count) {
    scene_ = step.scene;
    first_ = first;
    count_ = count;
    usable_ = scene_ != nullptr;
    Aabb all{body.particles.position[first], body.particles.position[first]};
    for (uint32_t i = 0; i < count; ++i) {
        balls_[i] = {body.particles.position[first + i], not_searched, 0};
        all = {min(all.min, body.particles.position[first + i]), max(all.max, body.particles.position[first + i])};
    }
    // Particles that search move by at most their radius, and their surface reaches as far again, twice.
    const double room = 3 * body.particles.largest_radius;
    const Box box = bounds(Aabb{all.min - Vec3{room, room, room}, all.max + Vec3{room, room, room}});
    for (const PlacedModel& before : *step.moved) {
        Box way;
        if (!scene_ || !(scene_->layers(before.model) & body.settings.layers)) continue;
        if (!swept_bounds(*scene_, before, way) || overlaps(way, box)) usable_ = false;
    }
}

/// Searches together with the particles that follow in memory and are nearby.
void FlightPlanes::search(const Body& body, uint32_t particle) {
    Aabb places{ball(particle).center, ball(particle).center};
    uint32_t together = 1;
    for (; together < ClosestFeatures::most_points && particle + together < first_ + count_; ++together) {
        const Ball& next = ball(particle + together);
        places = {min(places.min, next.center), max(places.max, next.center)};
        const double size = 16 * body.particles.largest_radius;
        if (next.sight != not_searched || max_component(places.max - places.min) > size) break;
    }
    if (search_together(body, particle, together)) return;
    for (uint32_t p = particle; p < particle + together; ++p) {
        if (!search_together(body, p, 1)) ball(p).sight = blocked;
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
    scene_->for_each_in_box(
        bounds(Aabb{places.min - room, places.max + room}), body.settings.layers,
        [&](gphys_model_id model) { complete = parts_.add(*scene_, model, 0, probes_) && complete; });
    for (uint32_t i = 0; i < count && complete; ++i) settle(body, particle + i, i);
    return complete;
}

void FlightPlanes::settle(const Body& body, uint32_t p, uint32_t point) {
    Ball& ball = this->ball(p);
    const double radius = body.particles.radius[p], gap = skin(radius, ball.center);
    ball.count = 0;
    ball.sight = clear;
    parts_.select_point(point);
    for (ClosestFeature part; parts_.pop_nearest(part); ++ball.count) {
        // Too many parts; or the particle overlaps one, and has to be pushed out.
        if (ball.count == most_planes || part.distance <= radius) {
            ball.sight = blocked;
            return;
        }
        const double height = dot(part.normal, part.closest) + radius;
        planes_[p - first_][ball.count] = {part.normal, height, part.model};
        // Coplanar triangles share a plane.
        if (part.is_triangle) parts_.cull_behind(part.normal, height - radius + gap / 2, 0);
    }
}

bool FlightPlanes::sweep(const Body& body, uint32_t p, Vec3 from, Vec3 displacement, double reach, Impact& impact) {
    if (!usable_ || reach > body.particles.radius[p]) return false;
    if (ball(p).sight == not_searched) search(body, p);
    const Ball& ball = this->ball(p);
    const auto in_ball = [&](Vec3 at) {
        return length_squared(at - ball.center) < body.particles.radius[p] * body.particles.radius[p];
    };
    if (ball.sight == blocked || !in_ball(from) || !in_ball(from + displacement)) return false;
    impact = {};
    for (uint32_t i = 0; i < ball.count; ++i) {
        const Plane& plane = planes_[p - first_][i];
        const double gap = dot(plane.normal, from) - plane.height, approach = -dot(plane.normal, displacement);
        if (gap < 0) return false;
        if (approach <= gap) continue;
        const double t = gap / approach;
        const Vec3 center = from + displacement * t;
        keep_first(impact, {t, plane.model, false, false, 0, center, center - plane.normal * body.particles.radius[p],
                            plane.normal, Vec3{}});
    }
    return true;
}

}  // namespace gphys
