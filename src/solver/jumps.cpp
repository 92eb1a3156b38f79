#include "solver/jumps.h"

#include "solver/contact/moving_colliders.h"
#include "solver/state.h"
#include "solver/state_range.h"

namespace gphys {

const PlacedModel* find_placed(const Vector<PlacedModel>& models, gphys_model_id model) {
    const auto at = std::lower_bound(models.begin(), models.end(), model,
                                     [](const PlacedModel& one, gphys_model_id id) { return one.model < id; });
    return at != models.end() && at->model == model ? &*at : nullptr;
}

bool has_jumped(const Scene& scene, const PlacedModel& before, double time) {
    const gphys_transform& now = scene.world(before.model);
    const Vec3 velocity = (widen(now.position) - widen(before.world.position)) / time;
    if (length(velocity) > fastest_model && distance(velocity, widen(before.velocity)) > fastest_model) return true;
    const Quat p = normalized(widen(before.world.rotation)), q = normalized(widen(now.rotation));
    constexpr double cosine_of_half_right_angle = 0.7072;  // and some rounding of float32
    if (std::fabs(p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w) < cosine_of_half_right_angle) return true;
    Box box;
    if (now.scale == before.world.scale || !scene.bounds(before.model, box)) return false;
    const Vec3 middle = widen(now.position), low = widen(box).min - middle, high = widen(box).max - middle;
    const double growth = std::fabs(1 - double{before.world.scale} / now.scale);
    return growth * length(max(abs(low), abs(high))) > fastest_model * time;
}

std::optional<RigidMotion> motion_of_jump(const Body& body, const Scene& scene, const Vector<PlacedModel>& before,
                                          double time) {
    const Vector<Attachment>& attachments = body.constraints.attachments;
    if (attachments.empty() || body.plan.joined) return std::nullopt;
    if (body.plan.method == GPHYS_SOLVE_FREE) return std::nullopt;  // no links to what is attached
    const PlacedModel* jumped = nullptr;
    for (size_t i = 0; i < attachments.size() && !jumped; ++i) {
        const gphys_model_id model = attachments[i].model;
        if (model == 0 || (i > 0 && model == attachments[i - 1].model)) continue;
        const PlacedModel* const placed = find_placed(before, model);
        if (placed && has_jumped(scene, *placed, time)) jumped = placed;
    }
    if (!jumped) return std::nullopt;
    const Transform from = widen(jumped->world), to = scene.world_transform(jumped->model);
    const Mat3 turn = to.rotation * transposed(from.rotation);
    const RigidMotion motion{turn, to.position - turn * from.position};
    for (const Attachment& attachment : attachments) {
        if (attachment.model == 0) return std::nullopt;
        const Vec3 end = scene.world_transform(attachment.model).apply(attachment.local);
        const Vec3 moved = motion.apply(body.particles.position[attachment.particle]);
        if (!(distance(moved, end) <= fastest_model * time)) return std::nullopt;
    }
    const auto is_pinned = [](double inverse_mass) { return inverse_mass == 0; };
    const auto pinned =
        std::count_if(body.particles.inverse_mass.begin(), body.particles.inverse_mass.end(), is_pinned);
    if (static_cast<size_t>(pinned) != attachments.size()) return std::nullopt;
    return motion;
}

void move_rigidly(Body& body, const RigidMotion& motion) {
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        Vec3 &position = body.particles.position[p], &velocity = body.particles.velocity[p];
        position = motion.apply(position);
        velocity = motion.rotation * velocity;
        keep_in_range(position, velocity);
    }
    restart_targets(body, 0, body.particles.size());
    interrupt(body);
}

}  // namespace gphys
