// The contact search of cloth: candidates for groups of neighbouring particles, and the choice of contact planes
// (contact_search.h).
#include "solver/cloth/contact_search.h"

#include "solver/contact/neighbourhood.h"

namespace gphys {
namespace {

Box around(const Aabb& places, double room, Vec3 origin) {
    const Vec3 r{room, room, room};
    return bounds(Aabb{origin + places.min - r, origin + places.max + r});
}

}  // namespace

/// The contact margin of cloth: `skin` plus 2^-21 of its coordinates, which is 4 times the rounding of float32.
double ContactSearch::clearance(uint32_t p, Vec3 at) const {
    return skin(particles_.radius[p], state_.origin + at) + 0x1p-21 * max_component(abs(at));
}

void ContactSearch::run(const uint32_t* particles, uint32_t count) {
    repeats_ = false;
    for (uint32_t i = 0; i < count; ++i) {
        const size_t at = 4 * size_t{particles[i]};
        put(&search_balls_[at], get(&state_.at[at]));
    }
    search_from_balls(particles, count);
}

void ContactSearch::repeat(const uint32_t* particles, uint32_t count) {
    repeats_ = true;
    search_from_balls(particles, count);
}

void ContactSearch::search_from_balls(const uint32_t* particles, uint32_t count) {
    constexpr uint32_t most_free = 64;
    for (uint32_t first = 0; first < count; first += most_free) {
        const uint32_t end = std::min(count, first + most_free);
        if (set_free(particles + first, end - first)) continue;
        for (uint32_t i = first, together; i < end; i += together) {
            together = count_together(particles + i, end - i);
            if (search_together(particles + i, together)) continue;
            for (uint32_t k = 0; k < together; ++k) search_alone(particles[i + k]);
        }
    }
}

/// Particles without models as near as they search at most get balls of that size. Returns false, without effect, if
/// models are near.
bool ContactSearch::set_free(const uint32_t* particles, uint32_t count) {
    double range;
    const Aabb places = places_of(particles, count, range);
    if (!find_colliders_near(places, range) || near_.count > 0) return false;
    bool free = true;
    each_near_model(*around_.scene, around(places, range, state_.origin), body_.settings.layers,
                    [&](gphys_model_id) { free = false; });
    if (!free) return false;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t p = particles[i];
        float* const search_ball = &search_balls_[4 * size_t{p}];
        search_ball[3] = farthest_or_known(p);
        float* const ball = &contacts_.balls[4 * size_t{p}];
        put(ball, place_of(p));
        ball[3] = search_ball[3] * search_ball[3];
        const uint32_t place = contacts_.candidate_of[p];
        if (place == ClothContacts::none) continue;
        finish_contact(contacts_.candidates[place], body_, around_);
        contacts_.candidates[place] = ClothContact{};
        contacts_.candidates[place].particle = p;
        contacts_.candidates[place].active_plane = -1;
    }
    return true;
}

/// A particle searches no farther than to its neighbours. That keeps the parts few, and a step seldom moves it farther.
double ContactSearch::farthest(uint32_t p) const { return std::max(link_length_, particles_.radius[p]); }

/// In a search that is repeated, as far as it searched before.
float ContactSearch::farthest_or_known(uint32_t p) const {
    return repeats_ ? search_balls_[4 * size_t{p} + 3] : static_cast<float>(farthest(p));
}

/// The box around some particles, and how far they search at most.
Aabb ContactSearch::places_of(const uint32_t* particles, uint32_t count, double& range) const {
    Aabb places{place_of(particles[0]), place_of(particles[0])};
    range = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t p = particles[i];
        places = {min(places.min, place_of(p)), max(places.max, place_of(p))};
        range = std::max(range, particles_.radius[p] + farthest_or_known(p));
    }
    return places;
}

/// The number of particles from the first one on that are within a box of eight times the size of its search range.
uint32_t ContactSearch::count_together(const uint32_t* particles, uint32_t count) const {
    const double size = 16 * (particles_.radius[particles[0]] + farthest(particles[0]));
    Aabb places{place_of(particles[0]), place_of(particles[0])};
    uint32_t together = 1;
    for (; together < std::min(count, most_points); ++together) {
        const Vec3 at = place_of(particles[together]);
        places = {min(places.min, at), max(places.max, at)};
        if (max_component(places.max - places.min) > size) break;
    }
    return together;
}

/// Returns false, without effect, if too much is near.
bool ContactSearch::search_together(const uint32_t* particles, uint32_t count) {
    double range;
    const Aabb places = places_of(particles, count, range);
    if (!find_colliders_near(places, range)) return false;
    for (uint32_t i = 0; i < count; ++i) reach_[i] = reach(particles[i]);
    if (!collect(particles, count)) return false;
    for (uint32_t i = 0; i < count; ++i) set_contacts(particles[i], i);
    return true;
}

/// If too much is near, the radius is halved, and finally 0: then the particle is swept in each substep.
void ContactSearch::search_alone(uint32_t p) {
    const Vec3 at = place_of(p);
    const bool follows_all = find_colliders_near({at, at}, particles_.radius[p] + farthest(p));
    reach_[0] = reach(p);
    bool complete = collect(&p, 1);
    for (int halvings = 0; !complete && halvings < 3; ++halvings) {
        reach_[0] /= 2;
        complete = collect(&p, 1);
    }
    if (!complete || !follows_all) reach_[0] = 0;
    set_contacts(p, 0);
}

/// As NearColliders::find.
bool ContactSearch::find_colliders_near(const Aabb& places, double range) {
    return near_.find(moving_colliders_, around(places, range, state_.origin));
}

/// 1.5 times the distance that the particle may move until the next search, by its velocity, gravity and moving models.
double ContactSearch::wanted_reach(uint32_t p) const {
    const Vec3 at = place_of(p), velocity = get(&state_.velocity[4 * size_t{p}]);
    double pushed = 0;
    for (uint32_t i = 0; i < near_.count; ++i) {
        pushed = std::max(pushed, moving_colliders_[near_.indices[i]].travel(at));
    }
    return std::min(1.5 * (time_ * (length(velocity) + time_ * length(gravity_)) + pushed), farthest(p));
}

double ContactSearch::reach(uint32_t p) {
    float& far = search_balls_[4 * size_t{p} + 3];
    if (!repeats_) far = static_cast<float>(wanted_reach(p));
    return far;
}

/// Places the query balls; for moving models, balls that cover their approach in the rest of the step.
void ContactSearch::place_balls(uint32_t p, uint32_t point) {
    const Vec3 origin = state_.origin, at = place_of(p);
    const double range = particles_.radius[p] + reach_[point];
    balls_[point] = {origin + at, range};
    for (uint32_t m = 0; m < near_.count; ++m) {
        const MovingCollider& moving_collider = moving_colliders_[near_.indices[m]];
        moving_balls_[m][point] = {origin + moving_collider.from_end.inverse_apply(at),
                                   moving_collider.range(range, at)};
    }
}

/// Collects the parts of models that the balls overlap. Returns false if there are too many.
bool ContactSearch::collect(const uint32_t* particles, uint32_t count) {
    const Vec3 origin = state_.origin;
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
        if (!has_moved(around_, model)) complete &= parts_.add(*around_.scene, model, ContactPlane::unmoved, balls_);
    });
    for (uint32_t m = 0; m < near_.count; ++m) {
        const uint32_t number = near_.indices[m];
        complete &= parts_.add(*around_.scene, moving_colliders_[number].model, number, moving_balls_[m]);
    }
    return complete;
}

/// Sets the ball and the contact planes of a particle from the collected parts.
void ContactSearch::set_contacts(uint32_t p, uint32_t point) {
    ClothContact found{};
    found.particle = p;
    found.active_plane = -1;
    for (int halvings = 0; parts_.select_point(point) > most_parts && halvings < 3; ++halvings) {
        reach_[point] /= 2;
        place_balls(p, point);
    }
    double reach = reach_[point];
    choose_planes(p, place_of(p), reach, found);
    if (found.plane_count > 1) make_room(found, place_of(p));
    float* const ball = &contacts_.balls[4 * size_t{p}];
    put(ball, place_of(p));
    if (push_out(ball, found) > 0) {
        // It searches again after each substep.
        reach = 0;
        contacts_.penetrating = true;
        search_balls_[4 * size_t{p} + 3] = ContactCache::no_ball;
    }
    float* const at = &state_.at[4 * size_t{p}];
    if (!repeats_ && get(at) != get(ball)) {
        put(at, get(ball));
        contacts_.clusters_pushed = contacts_.clusters_pushed || body_.cloth.clusters.has(p);
    }
    ball[3] = static_cast<float>(reach * reach);
    uint32_t& place = contacts_.candidate_of[p];
    if (found.plane_count == 0 && place == ClothContacts::none) return;
    if (place == ClothContacts::none) {
        place = static_cast<uint32_t>(contacts_.candidates.size());
        contacts_.candidates.push_back(found);
    } else {
        finish_contact(contacts_.candidates[place], body_, around_);
        contacts_.candidates[place] = found;
    }
}

/// Projects out of contact planes up to the distance that is left at once. Deeper planes are moved to the particle.
/// Returns the depth behind the true planes.
double ContactSearch::push_out(float* ball, ClothContact& found) const {
    for (uint32_t i = 0; i < found.plane_count; ++i) {
        ContactPlane& plane = found.planes[i];
        const double depth = plane.offset - dot(plane.normal, get(ball));
        if (depth > most_push) {
            found.penetrated_planes |= 1u << i;
            if (depth > found.depth) found.depth = depth, found.deepest_plane = i;
        } else if (depth > 0) {
            put(ball, get(ball) + plane.normal * depth);
        }
    }
    if (found.penetrated_planes == 0) return 0;
    for (uint32_t i = 0; i < found.plane_count; ++i) {
        ContactPlane& plane = found.planes[i];
        if (found.penetrated_planes >> i & 1) plane.offset = std::min(plane.offset, dot(plane.normal, get(ball)));
    }
    return found.depth;
}

/// Chooses the nearest parts first. Culls parts behind the contact plane of a nearer one. Parts for which there is no
/// room limit the reach.
void ContactSearch::choose_planes(uint32_t p, Vec3 at, double& reach, ClothContact& found) {
    const Vec3 origin = state_.origin;
    const double off = particles_.radius[p] + clearance(p, at);
    for (ClosestFeature part; found.plane_count < ClothContact::most_planes && parts_.pop_nearest(part);) {
        // Coplanar triangles share a contact plane. Half of the margin, or of radius plus margin, covers their
        // rounding. Parts with another motion are not culled, because they may come to the front.
        const double height = dot(part.normal, part.closest) + (off - particles_.radius[p]) / 2;
        parts_.cull_behind(part.normal, height, part.tag);
        if (part.tag != ContactPlane::unmoved) {
            // From the end of the step back to the present time.
            const RigidMotion& rigid_motion = moving_colliders_[part.tag].from_end;
            part.closest = origin + rigid_motion.apply(part.closest - origin);
            part.normal = rigid_motion.rotation * part.normal;
        }
        ContactPlane& plane = found.planes[found.plane_count++];
        plane.normal = part.normal;
        plane.offset = dot(part.normal, part.closest - origin) + off;
        plane.thickness = particles_.radius[p];
        plane.model = part.model;
        plane.moving_collider = part.tag;
    }
    if (found.plane_count < ClothContact::most_planes) return;
    parts_.for_each_remaining([&](uint32_t tag, double distance) {
        const double nearest =
            tag == ContactPlane::unmoved ? distance : moving_colliders_[tag].nearest_in_step(distance, at);
        reach = std::max(0.0, std::min(reach, nearest - off));
    });
}

}  // namespace gphys
