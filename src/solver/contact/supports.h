// The models that a particle touches while contacts between particles are solved. Other particles press it onto them:
// it does not go into a model, friction holds it there, and the model gets the opposite impulse.
//
// A model is one more contact in the Gauss-Seidel sweeps. Its push is accumulated and is never negative, so what a
// correction that was too large has caused is undone with it. Friction is at most Coulomb's bound of the push. The push
// of the particle's own weight, and its friction, are those of its flight and not part of this.
#pragma once

#include "solver/contact/collision.h"

namespace gphys {

struct Support {
    gphys_model_id model;
    Vec3 normal;      // unit, from the model to the particle
    Vec3 carried;     // displacement of the model's surface in the substep, or its velocity
    double room;      // how much nearer the particle may come: metres, or m/s
    double push = 0;  // accumulated correction along the normal
    Vec3 friction;    // accumulated correction along the surface
};

/// Of one particle. Corrections are displacements in a substep, or changes of velocity.
class Supports {
public:
    static constexpr uint32_t most = 3;  // in a corner

    /// Those of a particle: the models that it has touched in this step, and of cloth the contact planes that it has.
    /// Returns whether there are any. `at`: predicted; of cloth it becomes the place in front of the planes, to which
    /// they push a particle that nothing else presses on them.
    bool find_for_positions(const Body& body, uint32_t particle, Vec3& at, const CollisionContext& around);
    /// The same for one that keeps its place in a rigid cluster. Its room is negative behind a contact plane.
    bool find_in_shape(const Body& body, uint32_t particle, Vec3 at, const CollisionContext& around, Vec3 gravity);
    bool find_for_velocities(const Body& body, uint32_t particle, Vec3 at, Vec3 velocity,
                             const CollisionContext& around, Vec3 gravity);

    /// The value without motion into the models. It was `uncorrected` before the sweeps.
    Vec3 stop(Vec3 value, Vec3 uncorrected) {
        for (uint32_t i = 0; i < count_; ++i) {
            Support& support = of_[i];
            const double out = -support.room - dot(value - uncorrected, support.normal);
            const double change = std::max(out, -support.push);
            support.push += change;
            value += support.normal * change;
        }
        return value;
    }
    /// A direction without its parts along the normals of the models that push, and without what friction holds of it.
    Vec3 yielding(Vec3 direction) const {
        for (uint32_t i = 0; i < count_; ++i) {
            if (!(of_[i].push > 0)) continue;
            const double off = dot(direction, of_[i].normal);
            direction -= of_[i].normal * off;
            if (off >= 0 || friction_ == 0) continue;
            const double along = length(direction), held = friction_ * -off;
            direction *= along > held ? 1 - held / along : 0;
        }
        return direction;
    }
    /// The value with friction. It would be `still` if the particle had not moved, on models that do not move.
    Vec3 hold(Vec3 value, Vec3 still) {
        for (uint32_t i = 0; i < count_; ++i) {
            Support& support = of_[i];
            if (support.push <= 0 && support.friction == Vec3{}) continue;
            const Vec3 slip = value - still - support.carried;
            Vec3 wanted = support.friction - (slip - support.normal * dot(slip, support.normal));
            const double most = friction_ * support.push, square = length_squared(wanted);
            if (square > most * most) wanted *= most / std::sqrt(square);
            value += wanted - support.friction;
            support.friction = wanted;
        }
        return value;
    }
    /// The sum of the pushes of models, and that of their friction.
    Vec3 push() const;
    Vec3 friction() const;
    uint32_t count() const { return count_; }
    const Support& operator[](uint32_t i) const { return of_[i]; }
    Support& operator[](uint32_t i) { return of_[i]; }
    double friction_coefficient() const { return friction_; }

private:
    /// `ended`: whether contact planes have been moved to the end of the substep.
    bool find(const Body& body, uint32_t particle, Vec3& at, const CollisionContext& around, Vec3 gravity,
              bool in_shape, bool ended);
    void add(gphys_model_id model, Vec3 normal, Vec3 carried, double room);

    uint32_t count_ = 0;
    double friction_ = 0;
    Support of_[most];
};

/// Adds the impulses of the particles of a body on their models, in order. Neighbours mostly touch the same model.
class SupportImpulses {
public:
    /// rate: by which corrections become changes of velocity.
    SupportImpulses(Body& body, const CollisionContext& around, double rate)
        : body_(body), around_(around), rate_(rate) {}

    void add(uint32_t particle, Vec3 at, const Supports& supports);
    void end();

private:
    Body& body_;
    const CollisionContext& around_;
    const double rate_;
    gphys_model_id model_ = 0;
    Vec3 middle_, linear_, angular_;  // angular: about `middle`
};

}  // namespace gphys
