#include "solver/particles/flight_walls.h"

namespace gphys {

void FlightWalls::begin(const Body& body, const Surroundings& step, uint32_t first, uint32_t count) {
    scene_ = step.scene;
    first_ = first;
    count_ = count;
    wall_count_ = 0;
    usable_ = scene_ != nullptr;
    Aabb all{body.position[first], body.position[first]};
    for (uint32_t i = 0; i < count; ++i) {
        balls_[i].reach = -1;
        all = {min(all.min, body.position[first + i]), max(all.max, body.position[first + i])};
    }
    // Those that look around come no further than their radius, and touch what is as near again.
    const double room = 3 * body.largest_radius;
    const Box box = bounds(Aabb{all.min - Vec3{room, room, room}, all.max + Vec3{room, room, room}});
    for (const PlacedModel& before : *step.moved) {
        Box way;
        if (!scene_ || !(scene_->layers(before.model) & body.settings.layers)) continue;
        if (!way_of(*scene_, before, way) || overlaps(way, box)) usable_ = false;
    }
}

/// Together with those that follow it and lie beside it.
void FlightWalls::look(const Body& body, uint32_t particle, double reach) {
    const Vec3 at = body.position[particle];
    const double size = 8 * (body.radius[particle] + reach);
    uint32_t together = 0;
    Aabb places{at, at};
    double farthest = 0;
    while (together < NearParts::most_points && particle + together < first_ + count_) {
        const uint32_t p = particle + together;
        const Vec3 place = body.position[p];
        const Aabb wider{min(places.min, place), max(places.max, place)};
        if (ball(p).reach >= 0 || max_component(wider.max - wider.min) > size) break;
        places = wider;
        ball(p).center = place;
        ball(p).reach = static_cast<float>(std::min(reach, body.radius[p]));
        probes_[together++] = {place, body.radius[p] + ball(p).reach};
        farthest = std::max(farthest, probes_[together - 1].radius);
    }
    const Vec3 room{farthest, farthest, farthest};
    parts_.clear(together);
    bool complete = true;
    scene_->for_each_in_box(
        bounds(Aabb{places.min - room, places.max + room}), body.settings.layers,
        [&](gphys_model_id model) { complete = parts_.add(*scene_, model, 0, probes_) && complete; });
    for (uint32_t i = 0; i < together; ++i) {
        if (complete) {
            settle(body, particle + i, i);
        } else {
            ball(particle + i).reach = 0;
        }
    }
}

void FlightWalls::settle(const Body& body, uint32_t p, uint32_t point) {
    Ball& ball = this->ball(p);
    ball.first = static_cast<uint16_t>(wall_count_);
    ball.count = 0;
    const double radius = body.radius[p], gap = skin(radius, ball.center);
    parts_.look_from(point);
    for (NearPart part; parts_.take_nearest(part); ++ball.count) {
        const double height = dot(part.normal, part.closest) + radius;
        // Too many; or in something, from which it has to come out.
        if (ball.count == most_of_a_particle || wall_count_ == most_walls || part.distance <= radius) {
            ball.reach = 0;
            return;
        }
        walls_[wall_count_++] = {part.normal, height, part.model};
        // Coplanar triangles share a wall.
        if (part.is_triangle) parts_.leave_out_behind(part.normal, height - radius + gap / 2, 0);
    }
}

bool FlightWalls::sweep(const Body& body, uint32_t p, Vec3 from, Vec3 displacement, double reach, Impact& impact) {
    if (!usable_ || reach > body.radius[p]) return false;
    if (ball(p).reach < 0) look(body, p, reach);
    const Ball& ball = this->ball(p);
    const double squared = double{ball.reach} * ball.reach;
    if (length_squared(from - ball.center) >= squared || length_squared(from + displacement - ball.center) >= squared) {
        return false;
    }
    impact = {};
    for (uint32_t i = ball.first; i < uint32_t{ball.first} + ball.count; ++i) {
        const Wall& wall = walls_[i];
        const double gap = dot(wall.normal, from) - wall.height, approach = -dot(wall.normal, displacement);
        if (gap < 0) return false;
        if (approach <= gap) continue;
        const double t = gap / approach;
        const Vec3 center = from + displacement * t;
        keep_first(impact, {t, wall.model, false, false, 0, center, center - wall.normal * body.radius[p], wall.normal,
                            Vec3{}});
    }
    return true;
}

}  // namespace gphys
