// The search of ropes for contacts: the balls of particles, the features of models in them, and their contact planes
// (rope_contacts.h). Particles near each other search together.
#include "solver/rope/rope_contacts.h"

namespace gphys {
namespace {

// The ball of a particle near more features than this is halved, at most three times.
constexpr uint32_t many_features = 64;

}  // namespace

bool RopeContacts::is_followed(gphys_model_id model) const {
    return std::any_of(moving_colliders_.begin(), moving_colliders_.end(),
                       [&](const MovingCollider& moving) { return moving.model == model; });
}

/// Places the query balls; for moving models, balls that cover their approach in the rest of the step.
void RopeContacts::place_probes(double particle_radius, Vec3 at, double ball_radius, uint32_t point) {
    probes_[point] = {at, clearance(particle_radius, at) + ball_radius};
    for (uint32_t m = 0; m < near_.count; ++m) {
        const MovingCollider& moving = moving_colliders_[near_.indices[m]];
        moving_probes_[m][point] = {origin_ + moving.from_end.inverse_apply(at - origin_),
                                    moving.range(probes_[point].radius, at - origin_)};
    }
}

/// Finds the features of models in the balls of some particles, and makes their contacts. Returns false if there are
/// too many.
bool RopeContacts::find_features(const Body& body, uint32_t first, uint32_t count) {
    Aabb places{body.history.start[first], body.history.start[first]};
    double farthest = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t p = first + i;
        place_probes(body.particles.radius[p], body.history.start[p], balls_[p].radius, i);
        places = {min(places.min, body.history.start[p]), max(places.max, body.history.start[p])};
        farthest = std::max(farthest, probes_[i].radius);
    }
    const Vec3 margin{farthest, farthest, farthest};
    features_->clear(count);
    bool complete = true, any = false;
    scene_->for_each_in_box(bounds(Aabb{places.min - margin, places.max + margin}), body.settings.layers,
                            [&](gphys_model_id model) {
                                if (is_followed(model)) return;
                                any = true;
                                complete &= features_->add(*scene_, model, MovingCollider::unmoved, probes_);
                            });
    for (uint32_t m = 0; m < near_.count; ++m) {
        const uint32_t number = near_.indices[m];
        any = true;
        complete &= features_->add(*scene_, moving_colliders_[number].model, number, moving_probes_[m]);
    }
    if (complete && !any) {
        for (uint32_t i = 0; i < count; ++i) begin_particle(first + i);
        return true;
    }
    for (uint32_t i = 0; i < count && complete; ++i) {
        const uint32_t p = first + i;
        make_contacts(p, body.history.start[p], body.particles.radius[p], i);
    }
    return complete;
}

/// Sets the ball and the contacts of a particle from the features around it.
void RopeContacts::make_contacts(uint32_t p, Vec3 at, double particle_radius, uint32_t point) {
    begin_particle(p);
    const double off = clearance(particle_radius, at);
    double& radius = balls_[p].radius;
    for (int halvings = 0; features_->select_point(point) > many_features && halvings < 3; ++halvings) {
        radius /= 2;
        place_probes(particle_radius, at, radius, point);
    }
    uint32_t count = 0;
    for (ClosestFeature feature; count < most_planes && features_->pop_nearest(feature); ++count) {
        RopeContact contact{};
        contact.model = feature.model;
        contact.normal = feature.normal;
        contact.outside = dot(feature.normal, feature.closest) + off;
        contact.is_fixed = feature.is_triangle || scene_->type(feature.model) == GPHYS_SHAPE_PLANE;
        contact.moving_collider = feature.tag;
        contact.placed_at = at;
        // Coplanar triangles share a plane.
        if (feature.is_triangle) {
            features_->cull_behind(feature.normal, contact.outside - particle_radius - skin(particle_radius, at) / 2,
                                   feature.tag);
        }
        if (feature.tag != MovingCollider::unmoved) {
            // From the end of the step back to the present time.
            const RigidMotion& back = moving_colliders_[feature.tag].from_end;
            contact.normal = back.rotation * feature.normal;
            contact.outside = dot(contact.normal, origin_ + back.apply(feature.closest - origin_)) + off;
        }
        contacts_.push_back(contact);
    }
    if (count < most_planes) return;
    features_->for_each_remaining([&](uint32_t tag, double distance) {
        const double nearest =
            tag == MovingCollider::unmoved ? distance : moving_colliders_[tag].nearest_in_step(distance, at - origin_);
        radius = std::max(0.0, std::min(radius, nearest - off));
    });
}

/// Sets the balls of some particles, and finds the moving models near them. A ball's radius is 1.5 times the distance
/// that its particle can move in the rest of the step by its velocity, gravity and moving models. Returns false if not
/// all models can be followed.
bool RopeContacts::choose_balls(const Body& body, uint32_t first, uint32_t count, double rest, double fall) {
    Aabb places{body.history.start[first], body.history.start[first]};
    double range = 0, most_pushed = 0;
    for (uint32_t p = first; p < first + count; ++p) {
        const Vec3 at = body.history.start[p];
        balls_[p] = {at, 1.5 * rest * (length(body.history.start_velocity[p]) + fall)};
        places = {min(places.min, at), max(places.max, at)};
        range = std::max(range, clearance(body.particles.radius[p], at) + balls_[p].radius);
    }
    near_.count = 0;
    if (moving_colliders_.empty()) return true;
    const auto find = [&](double room) {
        const Vec3 margin{room, room, room};
        return near_.find(moving_colliders_, bounds(Aabb{places.min - margin, places.max + margin}));
    };
    const bool follows_all = find(range);
    if (near_.count == 0) return follows_all;
    for (uint32_t p = first; p < first + count; ++p) {
        double pushed = 0;
        for (uint32_t m = 0; m < near_.count; ++m) {
            pushed = std::max(pushed, moving_colliders_[near_.indices[m]].travel(balls_[p].center - origin_));
        }
        balls_[p].radius += 1.5 * pushed;
        most_pushed = std::max(most_pushed, pushed);
    }
    return find(range + 1.5 * most_pushed);
}

/// Makes balls and contacts of all particles, from the start of the substep. Returns false if a model near one cannot
/// be followed.
bool RopeContacts::search(const Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    contacts_.clear();
    scene_ = around.scene;
    planes_at_ = around.begin;
    move_planes(around, around.begin);
    const double rest = std::max(h, around.step_time * (1 - around.begin)), fall = rest * length(gravity);
    for (uint32_t first = 0, count; first < body.particles.size(); first += count) {
        Aabb places{body.history.start[first], body.history.start[first]};
        choose_balls(body, first, 1, rest, fall);
        const double size =
            8 * (clearance(body.particles.radius[first], body.history.start[first]) + balls_[first].radius);
        for (count = 1; count < ClosestFeatures::most_points && first + count < body.particles.size(); ++count) {
            const Vec3 at = body.history.start[first + count];
            places = {min(places.min, at), max(places.max, at)};
            if (max_component(places.max - places.min) > size) break;
        }
        const size_t before = contacts_.size();
        if (choose_balls(body, first, count, rest, fall) && find_features(body, first, count)) continue;
        for (uint32_t p = first; p < first + count; ++p) {
            contacts_.resize(p == first ? before : contacts_.size());
            const size_t of_this = contacts_.size();
            if (!choose_balls(body, p, 1, rest, fall)) return false;
            bool complete = find_features(body, p, 1);
            for (int halvings = 0; !complete && halvings < 3; ++halvings) {
                balls_[p].radius /= 2;
                contacts_.resize(of_this);
                complete = find_features(body, p, 1);
            }
            if (complete) continue;
            // The path of this particle is swept instead.
            contacts_.resize(of_this);
            begin_particle(p);
            balls_[p].radius = 0;
        }
    }
    first_[body.particles.size()] = static_cast<uint32_t>(contacts_.size());
    return true;
}

}  // namespace gphys
