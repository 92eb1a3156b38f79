// The models that particles touch while contacts between particles are solved (supports.h).
#include "solver/contact/supports.h"

#include "solver/contact/friction.h"

namespace gphys {
namespace {

/// The displacement of a point of a model in the substep at whose end it is there.
Vec3 carried_by(const CollisionContext& around, gphys_model_id model, Vec3 point) {
    const MovedModel* const moved = find_moved(around, model);
    if (!moved) return {};
    const gphys_transform& after = around.scene->world(model);
    const Vec3 on_model = interpolate(moved->world, after, around.way(around.end)).inverse_apply(point);
    return point - interpolate(moved->world, after, around.way(around.begin)).apply(on_model);
}

/// A particle that is farther off, in radii, has left the model in this step. What is nearer is the rounding of the
/// contact point.
double room(double gap, double radius) {
    constexpr double left = 0.01;
    return gap > left * radius ? gap : 0;
}

}  // namespace

void Supports::add(gphys_model_id model, Vec3 normal, Vec3 carried, double room) {
    Support& support = of_[count_++];
    support = {};
    support.model = model;
    support.normal = normal;
    support.carried = carried;
    support.room = room;
}

bool Supports::find_for_positions(const Body& body, uint32_t particle, Vec3& at, const CollisionContext& around) {
    return find(body, particle, at, around, {}, false, false);
}

bool Supports::find_in_shape(const Body& body, uint32_t particle, Vec3 at, const CollisionContext& around,
                             Vec3 gravity) {
    return find(body, particle, at, around, gravity, true, false);
}

bool Supports::find(const Body& body, uint32_t particle, Vec3& at, const CollisionContext& around, Vec3 gravity,
                    bool in_shape, bool ended) {
    const double radius = body.particles.radius[particle];
    count_ = 0;
    if (is_graph(body)) {
        const ClothContacts& contacts = body.cloth.contacts;
        const uint32_t number = collides(body, around) ? contacts.candidate_of[particle] : ClothContacts::none;
        if (number == ClothContacts::none) return false;
        const ClothContact& n = contacts.candidates[number];
        const auto gap_to = [&](const ContactPlane& plane, Vec3 carried) {
            const Vec3 place = at - body.cloth.state.origin;
            return dot(plane.normal, ended ? place : place - carried) - plane.offset;
        };
        for (uint32_t i = 0; i < n.plane_count && count_ < most; ++i) {
            const ContactPlane& plane = n.planes[i];
            Vec3 carried;
            // As place_on_plane: by its centre.
            if (plane.moving_collider != ContactPlane::unmoved) carried = carried_by(around, plane.model, at);
            if (follows_evenly(body, particle, plane, around, gravity)) {
                const Vec3 lag = lag_in_substep(body.cloth.moving_colliders[plane.moving_collider].jump, around);
                carried += lag - plane.normal * dot(lag, plane.normal);
            }
            if (!in_shape) at += plane.normal * std::max(0.0, -gap_to(plane, carried));
            const double gap = gap_to(plane, carried);
            add(plane.model, plane.normal, carried, in_shape ? gap : room(gap, radius));
        }
    } else {
        if (body.contacts.points.empty()) return false;
        const ContactPoint* const points = &body.contacts.points[size_t{particle} * contact_points_per_particle];
        static_assert(most <= contact_points_per_particle);
        while (count_ < most && points[count_].model != 0) {
            const ContactPoint& point = points[count_];
            const Vec3 normal = widen(point.normal);
            add(point.model, normal, carried_by(around, point.model, at - normal * radius),
                room(dot(at - widen(point.point), normal) - radius, radius));
        }
    }
    if (count_ == 0) return false;
    friction_ = friction_of(body, particle);
    return true;
}

bool Supports::find_for_velocities(const Body& body, uint32_t particle, Vec3 at, Vec3 velocity,
                                   const CollisionContext& around, Vec3 gravity) {
    const double seconds = around.step_time * (around.end - around.begin);
    if (!find(body, particle, at, around, gravity, false, true)) return false;
    for (uint32_t i = 0; i < count_; ++i) {
        Support& support = of_[i];
        support.carried *= 1 / seconds;
        // A model does not stop a particle that it does not touch.
        support.room = support.room > 0 ? infinity : std::max(0.0, dot(velocity - support.carried, support.normal));
    }
    return true;
}

Vec3 Supports::push() const {
    Vec3 sum;
    for (uint32_t i = 0; i < count_; ++i) sum += of_[i].normal * of_[i].push;
    return sum;
}

Vec3 Supports::friction() const {
    Vec3 sum;
    for (uint32_t i = 0; i < count_; ++i) sum += of_[i].friction;
    return sum;
}

void SupportImpulses::add(uint32_t particle, Vec3 at, const Supports& supports) {
    for (uint32_t i = 0; i < supports.count(); ++i) {
        const Support& support = supports[i];
        const Vec3 change = support.normal * support.push + support.friction;
        if (change == Vec3{}) continue;
        const Vec3 point = at - support.normal * body_.particles.radius[particle];
        if (support.model != model_) {
            end();
            model_ = support.model;
            middle_ = point;
        }
        const Vec3 impulse = change * (-rate_ * body_.particles.mass[particle]);
        linear_ += impulse;
        angular_ += cross(point - middle_, impulse);
    }
}

void SupportImpulses::end() {
    if (model_ == 0) return;
    add_impulse(body_, around_, model_, middle_, linear_, angular_);
    model_ = 0;
    linear_ = angular_ = {};
}

}  // namespace gphys
