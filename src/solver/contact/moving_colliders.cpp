// Moving models near a body: their bounds in a step, and their rigid motion (moving_colliders.h).
#include "solver/contact/moving_colliders.h"

#include "solver/contact/collision.h"

namespace gphys {
namespace {

RigidMotion rigid_motion(const Transform& from, const Transform& to, Vec3 origin) {
    return {to.rotation * transposed(from.rotation), to.apply(from.inverse_apply(origin)) - origin};
}

}  // namespace

bool NearColliders::find(const Vector<MovingCollider>& moving_colliders, const Box& box) {
    bool all = true;
    count = 0;
    for (uint32_t i = 0; i < moving_colliders.size(); ++i) {
        if (moving_colliders[i].bounded && !overlaps(moving_colliders[i].swept_bounds, box)) continue;
        if (count == most || !moving_colliders[i].is_rigid) {
            all = false;
        } else {
            indices[count++] = i;
        }
    }
    return all;
}

void find_moving_colliders(Vector<MovingCollider>& moving_colliders, Vec3 origin, const Box& box, uint32_t layers,
                           const CollisionContext& around) {
    // Half a radian: search ranges are then less than three times those for a model that does not rotate.
    constexpr double most_turn = 0.5;
    moving_colliders.clear();
    for (const MovedModel& before : *around.moved) {
        if (!(around.scene->layers(before.model) & layers)) continue;
        if (before.bounded && !overlaps(before.swept, box)) continue;
        const gphys_transform& after = around.scene->world(before.model);
        MovingCollider moving_collider{};
        moving_collider.model = before.model;
        moving_collider.before = before.world;
        moving_collider.bounded = before.bounded;
        moving_collider.swept_bounds = before.swept;
        const Vec3 way = widen(after.position) - widen(before.world.position);
        moving_collider.jump = way / around.way_time() - widen(before.velocity);
        // For unit quaternions, up to rounding: |q - p| = 2 sin(angle / 4), and their dot product is the cosine of half
        // the angle.
        const Quat p = normalized(widen(before.world.rotation)), q = normalized(widen(after.rotation));
        const double cosine = std::min(1.0, std::fabs(p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w));
        moving_collider.turn = 2 * std::sqrt(1 - cosine * cosine) + 1e-6;  // plus the rounding of an angle near 0
        // 1 - cos(angle / 2) towards the centre of the circle, and less than that along the chord, because the arc is
        // not traversed at constant speed.
        moving_collider.bulge = 2 * (1 - cosine);
        moving_collider.is_rigid = before.world.scale == after.scale && moving_collider.turn < most_turn;
        moving_colliders.push_back(moving_collider);
    }
    advance_moving_colliders(moving_colliders, origin, around);
}

void advance_moving_colliders(Vector<MovingCollider>& moving_colliders, Vec3 origin, const CollisionContext& around) {
    for (MovingCollider& moving_collider : moving_colliders) {
        if (!moving_collider.is_rigid) continue;
        const gphys_transform& after = around.scene->world(moving_collider.model);
        const Transform begin = interpolate(moving_collider.before, after, around.way(around.begin));
        const Transform end = interpolate(moving_collider.before, after, around.way(around.end));
        moving_collider.substep_motion = rigid_motion(begin, end, origin);
        moving_collider.from_end = rigid_motion(widen(after), end, origin);
        moving_collider.middle = end.position - origin;
        moving_collider.lag = lag_in_substep(moving_collider.jump, around);
    }
}

/// It starts with the mean of the velocities of this step and the one before, so it is the same at the end of one step
/// and at the beginning of the next if the model speeds up steadily.
Vec3 lag_in_substep(Vec3 jump, const CollisionContext& around) {
    const auto at = [&](double t) { return t * (t - 1) / 2; };
    return jump * (around.step_time * (at(around.end) - at(around.begin)));
}

RigidMotion motion_in_step(const MovingCollider& moving_collider, Vec3 origin, const CollisionContext& around) {
    const gphys_transform& after = around.scene->world(moving_collider.model);
    return rigid_motion(widen(moving_collider.before), interpolate(moving_collider.before, after, around.way(1)),
                        origin);
}

}  // namespace gphys
