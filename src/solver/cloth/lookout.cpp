#include "solver/cloth/lookout.h"

#include "solver/quads.h"

namespace gphys {
namespace {

/// How far cloth stays off: as `skin`, and 2^-21 of its coordinates, which is 4 times the rounding of
/// float32.
double clearance(const Body& body, uint32_t p, Vec3 at) {
    return skin(body.radius[p], body.cloth.origin + at) + 0x1p-21 * max_component(abs(at));
}

/// As it is at the end of the step, taken back to the time of the ride.
void take_back(NearPart& part, const Ride& ride, Vec3 origin) {
    const auto moved = [&](Vec3 p) { return origin + ride.apply(p - origin); };
    part.closest = moved(part.closest);
    part.normal = ride.rotation * part.normal;
    part.triangle = {moved(part.triangle.a), moved(part.triangle.b), moved(part.triangle.c)};
}

}  // namespace

void Lookout::look(uint32_t p, Vec3 gravity) {
    ClothContacts& contacts = body_.cloth_contacts;
    float* const at = &body_.cloth.at[4 * size_t{p}];
    const Vec3 velocity = get(&body_.cloth.velocity[4 * size_t{p}]);
    const double radius = body_.radius[p];
    // As far as it comes by itself and with what may push it, and half as far again; but no further than to its
    // neighbours, which a step seldom takes it, so that few parts are near.
    const double farthest = std::max(body_.cloth.link_length, radius);
    find_movers_near(get(at), radius + farthest);
    double pushed = 0;
    for (uint32_t i = 0; i < mover_count_; ++i) {
        pushed = std::max(pushed, contacts.movers[near_movers_[i]].travel(get(at)));
    }
    double reach = std::min(1.5 * (time_ * (length(velocity) + time_ * length(gravity)) + pushed), farthest);
    Neighbour found{};
    found.particle = p;
    uint32_t count = 0;
    for (int halvings = 0; halvings < 4; ++halvings, reach /= 2) {
        count = collect(get(at), radius + reach);
        if (count <= most_parts) break;
    }
    if (count > most_parts) count = most_parts, reach = 0;  // on a mesh much finer than the particle
    if (!follows_all_) reach = 0;                           // without a ball it is swept in each substep
    choose_walls(p, get(at), count, reach, found);
    for (uint32_t i = 0; i < found.wall_count; ++i) {
        const double depth = found.walls[i].offset - dot(found.walls[i].normal, get(at));
        if (depth > 0) put(at, get(at) + found.walls[i].normal * depth);
    }
    float* const ball = &contacts.balls[4 * size_t{p}];
    put(ball, get(at));
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

void Lookout::find_movers_near(Vec3 at, double reach) {
    mover_count_ = 0;
    follows_all_ = true;
    const Vector<Mover>& movers = body_.cloth_contacts.movers;
    const Box around = bounds(Sphere{body_.cloth.origin + at, reach});
    for (uint32_t i = 0; i < movers.size(); ++i) {
        if (movers[i].bounded && !touch(movers[i].way, around)) continue;
        if (mover_count_ == most_movers || !movers[i].is_rigid) {
            follows_all_ = false;
        } else {
            near_movers_[mover_count_++] = i;
        }
    }
}

/// Parts within reach, and those of models that move if they may come as near in the rest of the step.
uint32_t Lookout::collect(Vec3 at, double reach) {
    const Vec3 origin = body_.cloth.origin;
    uint32_t count = 0;
    const auto add = [&](gphys_model_id model, uint32_t mover, Vec3 from, double range) {
        const uint32_t first = std::min(count, most_parts), room = most_parts - first;
        const uint32_t more = around_.scene->parts_near(model, from, range, parts_ + first, room);
        std::fill_n(models_ + first, std::min(more, room), model);
        std::fill_n(movers_ + first, std::min(more, room), mover);
        count += more;
    };
    around_.scene->for_each_in_box(bounds(Sphere{origin + at, reach}), body_.settings.layers,
                                   [&](gphys_model_id model) {
                                       if (!has_moved(around_, model)) add(model, Wall::unmoved, origin + at, reach);
                                   });
    for (uint32_t i = 0; i < mover_count_; ++i) {
        const Mover& mover = body_.cloth_contacts.movers[near_movers_[i]];
        const uint32_t first = std::min(count, most_parts);
        add(mover.model, near_movers_[i], origin + mover.from_end.inverse_apply(at), mover.range(reach, at));
        for (uint32_t k = first; k < std::min(count, most_parts); ++k) take_back(parts_[k], mover.from_end, origin);
    }
    return count;
}

/// Nearest first. Leaves parts out that are behind the wall of a nearer one; those for which there
/// is no room limit the reach.
void Lookout::choose_walls(uint32_t p, Vec3 at, uint32_t count, double& reach, Neighbour& found) {
    for (uint32_t i = 0; i < count; ++i) order_[i] = i;
    std::sort(order_, order_ + count, [&](uint32_t a, uint32_t b) {
        const double da = parts_[a].signed_distance, db = parts_[b].signed_distance;
        return da != db ? da < db : a < b;
    });
    const double off = body_.radius[p] + clearance(body_, p, at);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t k = order_[i];
        const NearPart& part = parts_[k];
        if (is_behind(k, off, found)) continue;
        if (found.wall_count == Neighbour::most_walls) {
            reach = std::max(0.0, std::min(reach, nearest_in_step(k, at) - off));
            continue;
        }
        Wall& wall = found.walls[found.wall_count++];
        wall.normal = part.normal;
        wall.offset = dot(part.normal, part.closest - body_.cloth.origin) + off;
        wall.model = models_[k];
        wall.mover = movers_[k];
    }
}

/// How near the part comes to the place until the end of the step, at least.
double Lookout::nearest_in_step(uint32_t part, Vec3 at) const {
    const double away = parts_[part].signed_distance;
    if (movers_[part] == Wall::unmoved) return away;
    const Mover& mover = body_.cloth_contacts.movers[movers_[part]];
    return away - mover.travel(at) - (mover.turn + mover.bulge) * std::fabs(away);
}

bool Lookout::is_behind(uint32_t k, double off, const Neighbour& found) const {
    const NearPart& part = parts_[k];
    if (!part.is_triangle) return false;
    for (uint32_t i = 0; i < found.wall_count; ++i) {
        const Wall& wall = found.walls[i];
        if (wall.mover != movers_[k]) continue;  // it will not stay behind
        // Coplanar triangles share a wall: half of the clearance, or of the radius and it, is room
        // for their rounding.
        const double height = wall.offset - off + (off - body_.radius[found.particle]) / 2;
        const auto below = [&](Vec3 corner) { return dot(wall.normal, corner - body_.cloth.origin) <= height; };
        if (below(part.triangle.a) && below(part.triangle.b) && below(part.triangle.c)) return true;
    }
    return false;
}

}  // namespace gphys
