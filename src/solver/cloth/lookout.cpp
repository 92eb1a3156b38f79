#include "solver/cloth/lookout.h"

namespace gphys {
namespace {

/// How far cloth stays off: as `skin`, and 2^-21 of its coordinates, which is 4 times the rounding of
/// float32.
double clearance(const Body& body, uint32_t p, Vec3 at) {
    return skin(body.radius[p], body.cloth.origin + at) + 0x1p-21 * max_component(abs(at));
}

Box around(const Aabb& places, double room, Vec3 origin) {
    const Vec3 r{room, room, room};
    return bounds(Aabb{origin + places.min - r, origin + places.max + r});
}

}  // namespace

void Lookout::look(const uint32_t* particles, uint32_t count) {
    again_ = false;
    for (uint32_t i = 0; i < count; ++i) {
        const size_t at = 4 * size_t{particles[i]};
        put(&body_.cloth.looked[at], get(&body_.cloth.at[at]));
    }
    look_from_looked(particles, count);
}

void Lookout::look_again(const uint32_t* particles, uint32_t count) {
    again_ = true;
    look_from_looked(particles, count);
}

void Lookout::look_from_looked(const uint32_t* particles, uint32_t count) {
    for (uint32_t first = 0, together; first < count; first += together) {
        together = count_together(particles + first, count - first);
        if (look_together(particles + first, together)) continue;
        for (uint32_t i = 0; i < together; ++i) look_alone(particles[first + i]);
    }
}

/// A particle looks no further than to its neighbours, which a step seldom takes it, so that few parts are near.
double Lookout::farthest(uint32_t p) const { return std::max(body_.plan.batches.link_length, body_.radius[p]); }

/// Those that follow the first one within a box of eight times the size of what it may see.
uint32_t Lookout::count_together(const uint32_t* particles, uint32_t count) const {
    const double size = 16 * (body_.radius[particles[0]] + farthest(particles[0]));
    Aabb places{place_of(particles[0]), place_of(particles[0])};
    uint32_t together = 1;
    for (; together < std::min(count, most_points); ++together) {
        const Vec3 at = place_of(particles[together]);
        places = {min(places.min, at), max(places.max, at)};
        if (max_component(places.max - places.min) > size) break;
    }
    return together;
}

/// False, and nothing is done, if there is too much around.
bool Lookout::look_together(const uint32_t* particles, uint32_t count) {
    Aabb places{place_of(particles[0]), place_of(particles[0])};
    double range = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t p = particles[i];
        places = {min(places.min, place_of(p)), max(places.max, place_of(p))};
        range = std::max(range, body_.radius[p] + farthest(p));
    }
    if (!find_movers_near(places, range)) return false;
    for (uint32_t i = 0; i < count; ++i) reach_[i] = reach(particles[i]);
    if (!collect(particles, count)) return false;
    for (uint32_t i = 0; i < count; ++i) settle(particles[i], i);
    return true;
}

/// Among too much it sees less far, and at last as far as is swept in each substep anyway.
void Lookout::look_alone(uint32_t p) {
    const Vec3 at = place_of(p);
    const bool follows_all = find_movers_near({at, at}, body_.radius[p] + farthest(p));
    reach_[0] = reach(p);
    bool complete = collect(&p, 1);
    for (int halvings = 0; !complete && halvings < 3; ++halvings) {
        reach_[0] /= 2;
        complete = collect(&p, 1);
    }
    if (!complete || !follows_all) reach_[0] = 0;
    settle(p, 0);
}

/// False if there are too many, or some turn too fast to follow.
bool Lookout::find_movers_near(const Aabb& places, double range) {
    mover_count_ = 0;
    bool all = true;
    const Vector<Mover>& movers = body_.cloth_contacts.movers;
    if (movers.empty()) return true;
    const Box box = around(places, range, body_.cloth.origin);
    for (uint32_t i = 0; i < movers.size(); ++i) {
        if (movers[i].bounded && !overlaps(movers[i].way, box)) continue;
        if (mover_count_ == most_movers || !movers[i].is_rigid) {
            all = false;
        } else {
            near_movers_[mover_count_++] = i;
        }
    }
    return all;
}

/// As far as it comes by itself and with what may push it, and half as far again.
double Lookout::wanted_reach(uint32_t p) const {
    const Vec3 at = place_of(p), velocity = get(&body_.cloth.velocity[4 * size_t{p}]);
    double pushed = 0;
    for (uint32_t i = 0; i < mover_count_; ++i) {
        pushed = std::max(pushed, body_.cloth_contacts.movers[near_movers_[i]].travel(at));
    }
    return std::min(1.5 * (time_ * (length(velocity) + time_ * length(gravity_)) + pushed), farthest(p));
}

double Lookout::reach(uint32_t p) {
    float& far = body_.cloth.looked[4 * size_t{p} + 3];
    if (!again_) far = static_cast<float>(wanted_reach(p));
    return far;
}

/// What it reaches; of models that move, if they may come as near in the rest of the step.
void Lookout::place_balls(uint32_t p, uint32_t point) {
    const Vec3 origin = body_.cloth.origin, at = place_of(p);
    const double range = body_.radius[p] + reach_[point];
    balls_[point] = {origin + at, range};
    for (uint32_t m = 0; m < mover_count_; ++m) {
        const Mover& mover = body_.cloth_contacts.movers[near_movers_[m]];
        moving_balls_[m][point] = {origin + mover.from_end.inverse_apply(at), mover.range(range, at)};
    }
}

/// Models that the balls touch. False if there is too much.
bool Lookout::collect(const uint32_t* particles, uint32_t count) {
    const Vec3 origin = body_.cloth.origin;
    const Vector<Mover>& movers = body_.cloth_contacts.movers;
    parts_.clear(count);
    Aabb places{place_of(particles[0]), place_of(particles[0])};
    double farthest = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const Vec3 at = place_of(particles[i]);
        place_balls(particles[i], i);
        places = {min(places.min, at), max(places.max, at)};
        farthest = std::max(farthest, balls_[i].radius);
    }
    bool complete = true;
    around_.scene->for_each_in_box(around(places, farthest, origin), body_.settings.layers, [&](gphys_model_id model) {
        if (!has_moved(around_, model)) complete &= parts_.add(*around_.scene, model, Wall::unmoved, balls_);
    });
    for (uint32_t m = 0; m < mover_count_; ++m) {
        const uint32_t number = near_movers_[m];
        complete &= parts_.add(*around_.scene, movers[number].model, number, moving_balls_[m]);
    }
    return complete;
}

/// The ball and the walls of a particle from what was collected around it.
void Lookout::settle(uint32_t p, uint32_t point) {
    ClothContacts& contacts = body_.cloth_contacts;
    Neighbour found{};
    found.particle = p;
    found.touching = -1;
    for (int halvings = 0; parts_.look_from(point) > most_parts && halvings < 3; ++halvings) {
        reach_[point] /= 2;
        place_balls(p, point);
    }
    double reach = reach_[point];
    choose_walls(p, place_of(p), reach, found);
    float* const ball = &contacts.balls[4 * size_t{p}];
    put(ball, place_of(p));
    if (push_out(ball, found) > 0) {
        // It looks around again after each substep.
        reach = 0;
        contacts.sunk = true;
        body_.cloth.looked[4 * size_t{p} + 3] = ClothState::not_looked;
    }
    if (!again_) put(&body_.cloth.at[4 * size_t{p}], get(ball));
    ball[3] = static_cast<float>(reach * reach);
    uint32_t& place = contacts.place[p];
    if (found.wall_count == 0 && place == ClothContacts::nowhere) return;
    if (place == ClothContacts::nowhere) {
        place = static_cast<uint32_t>(contacts.neighbours.size());
        contacts.neighbours.push_back(found);
    } else {
        finish_neighbour(contacts.neighbours[place], body_, around_);
        contacts.neighbours[place] = found;
    }
}

/// Of its walls, as far as that is done at once. Others are moved to where the particle is. Returns by how much it is
/// behind the true ones.
double Lookout::push_out(float* ball, Neighbour& found) const {
    for (uint32_t i = 0; i < found.wall_count; ++i) {
        Wall& wall = found.walls[i];
        const double depth = wall.offset - dot(wall.normal, get(ball));
        if (depth > most_push_) {
            found.sunk_walls |= 1u << i;
            if (depth > found.depth) found.depth = depth, found.sunk_most = i;
        } else if (depth > 0) {
            put(ball, get(ball) + wall.normal * depth);
        }
    }
    if (found.sunk_walls == 0) return 0;
    for (uint32_t i = 0; i < found.wall_count; ++i) {
        Wall& wall = found.walls[i];
        if (found.sunk_walls >> i & 1) wall.offset = std::min(wall.offset, dot(wall.normal, get(ball)));
    }
    return found.depth;
}

/// Nearest first. Leaves parts out that are behind the wall of a nearer one; those for which there
/// is no room limit the reach.
void Lookout::choose_walls(uint32_t p, Vec3 at, double& reach, Neighbour& found) {
    const Vec3 origin = body_.cloth.origin;
    const double off = body_.radius[p] + clearance(body_, p, at);
    for (NearPart part; found.wall_count < Neighbour::most_walls && parts_.take_nearest(part);) {
        // Coplanar triangles share a wall: half of the clearance, or of the radius and it, is room for their
        // rounding. What moves in another way will not stay behind.
        const double height = dot(part.normal, part.closest) + (off - body_.radius[p]) / 2;
        parts_.leave_out_behind(part.normal, height, part.tag);
        if (part.tag != Wall::unmoved) {
            // From the end of the step back to the time of the ride.
            const Ride& ride = body_.cloth_contacts.movers[part.tag].from_end;
            part.closest = origin + ride.apply(part.closest - origin);
            part.normal = ride.rotation * part.normal;
        }
        Wall& wall = found.walls[found.wall_count++];
        wall.normal = part.normal;
        wall.offset = dot(part.normal, part.closest - origin) + off;
        wall.model = part.model;
        wall.mover = part.tag;
    }
    if (found.wall_count < Neighbour::most_walls) return;
    parts_.for_each_left([&](uint32_t mover, double distance) {
        reach = std::max(0.0, std::min(reach, nearest_in_step(mover, distance, at) - off));
    });
}

/// How near a part so far away now comes to the place until the end of the step, at least.
double Lookout::nearest_in_step(uint32_t mover, double distance, Vec3 at) const {
    if (mover == Wall::unmoved) return distance;
    const Mover& moving = body_.cloth_contacts.movers[mover];
    return distance - moving.travel(at) - (moving.turn + moving.bulge) * std::fabs(distance);
}

}  // namespace gphys
