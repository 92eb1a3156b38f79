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

}  // namespace

void Supports::find_for_positions(const Body& body, uint32_t particle, Vec3 at, const ContactPoint* points,
                                  const CollisionContext& around) {
    // A particle that is farther off, in radii, has left the model in this step. What is nearer is the rounding of the
    // contact point.
    constexpr double left = 0.01;
    const double radius = body.particles.radius[particle];
    friction_ = friction_of(body, particle);
    for (count_ = 0; count_ < most && points[count_].model != 0; ++count_) {
        const ContactPoint& point = points[count_];
        Support& support = of_[count_];
        support = {};
        support.normal = widen(point.normal);
        const double gap = dot(at - widen(point.point), support.normal) - radius;
        support.room = gap > left * radius ? gap : 0;
        support.carried = carried_by(around, point.model, at - support.normal * radius);
    }
}

void Supports::find_for_velocities(const Body& body, uint32_t particle, Vec3 at, Vec3 velocity,
                                   const ContactPoint* points, const CollisionContext& around) {
    const double seconds = around.step_time * (around.end - around.begin);
    find_for_positions(body, particle, at, points, around);
    for (uint32_t i = 0; i < count_; ++i) {
        Support& support = of_[i];
        support.carried *= 1 / seconds;
        // A model does not stop a particle that it does not touch.
        support.room = support.room > 0 ? infinity : std::max(0.0, dot(velocity - support.carried, support.normal));
    }
}

void SupportImpulses::add(uint32_t particle, Vec3 at, const ContactPoint* points, const Supports& supports) {
    for (uint32_t i = 0; i < supports.count(); ++i) {
        const Support& support = supports[i];
        const Vec3 change = support.normal * support.push + support.friction;
        if (change == Vec3{}) continue;
        const Vec3 point = at - support.normal * body_.particles.radius[particle];
        if (points[i].model != model_) {
            end();
            model_ = points[i].model;
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
