// Sweeps of particles against models that move during a step (collision.h).
//
// A sweep uses the motion of the particle relative to the model, with a common time. A path starts at the place and at
// the time at which the previous path ended. So the relative paths have no gaps, and no particle passes through a
// model.
#include "solver/contact/collision.h"

namespace gphys {

const PlacedModel* find_moved(const CollisionContext& around, gphys_model_id model) {
    const auto at = std::lower_bound(around.moved->begin(), around.moved->end(), PlacedModel{model, {}});
    return at != around.moved->end() && at->model == model ? &*at : nullptr;
}

Transform interpolate(const gphys_transform& from, const gphys_transform& to, double fraction) {
    const double rest = 1 - fraction;
    const Quat a = widen(from.rotation), b = widen(to.rotation);
    const double sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0 ? -1 : 1;
    const Quat q{a.x * rest + sign * b.x * fraction, a.y * rest + sign * b.y * fraction,
                 a.z * rest + sign * b.z * fraction, a.w * rest + sign * b.w * fraction};
    return {widen(from.position) * rest + widen(to.position) * fraction, rotation_matrix(q),
            from.scale * rest + to.scale * fraction};
}

bool swept_bounds(const Scene& scene, const PlacedModel& before, Box& out) {
    Box now;
    if (!scene.bounds(before.model, now)) return false;
    // No part of the model was farther from its position than now, except for the change of scale.
    const gphys_transform& after = scene.world(before.model);
    const Vec3 at = widen(after.position), was = widen(before.world.position);
    double reach = 0;
    for (int k = 0; k < 3; ++k) reach += std::max(now.max[k] - at[k], at[k] - now.min[k]);
    reach *= std::max(1.0, static_cast<double>(before.world.scale) / after.scale);
    const Vec3 room{reach, reach, reach};
    out = bounds(Aabb{min(at, was) - room, max(at, was) + room});
    return true;
}

template <class Visit>
void Collider::for_each_moving(Visit&& visit) const {
    if (moving_count_ <= most_listed) {
        for (uint32_t i = 0; i < moving_count_; ++i) visit((*around_.moved)[moving_[i]]);
        return;
    }
    for (const PlacedModel& before : *around_.moved) {
        if (around_.scene->layers(before.model) & body_.settings.layers) visit(before);
    }
}

/// A model pushes a particle that it hits at most as far as it moves, and a bounce adds at most the same distance.
Box Collider::bounds_of_pushed(const Box& paths) const {
    const Aabb all = widen(paths);
    double furthest = 0;
    for_each_moving([&](const PlacedModel& before) {
        const gphys_transform& after = around_.scene->world(before.model);
        const Transform begin = interpolate(before.world, after, around_.begin);
        for (const double part : {0.5, 1.0}) {
            const Transform then =
                interpolate(before.world, after, around_.begin + (around_.end - around_.begin) * part);
            for (int corner = 0; corner < 8; ++corner) {  // corners move farther than the points between them
                const Vec3 at{corner & 1 ? all.min.x : all.max.x, corner & 2 ? all.min.y : all.max.y,
                              corner & 4 ? all.min.z : all.max.z};
                furthest = std::max(furthest, distance(at, then.apply(begin.inverse_apply(at))));
            }
        }
    });
    const Vec3 room = Vec3{1, 1, 1} * (2 * furthest);
    return bounds(Aabb{all.min - room, all.max + room});
}

void Collider::list_moving(const Box& box) {
    moving_count_ = 0;
    for (uint32_t i = 0; i < around_.moved->size(); ++i) {
        const PlacedModel& before = (*around_.moved)[i];
        Box swept;
        if (!(around_.scene->layers(before.model) & body_.settings.layers)) continue;
        if (swept_bounds(*around_.scene, before, swept) && !overlaps(swept, box)) continue;
        if (moving_count_ < most_listed) moving_[moving_count_] = i;
        ++moving_count_;
    }
}

namespace {

/// The number of parts into which to divide a path, so that each is almost straight relative to a model that rotates or
/// grows. Relative to it the path is y = R^T (x - c) / s with a second derivative of at most (|x - c| (w^2 + w' + 2 w
/// s' / s + 2 (s' / s)^2) + 2 |x' - c'| (w + s' / s)) / s. Of n parts, none is farther from its chord than that over 8
/// n^2. A quarter of the radius is small enough: what the centre passes through, the sphere hits on the chord.
uint32_t parts_of_path(const Transform& begin, const Transform& end, Vec3 from, Vec3 displacement, double tangent,
                       double radius, double& bulge) {
    constexpr uint32_t most = 64;  // for points, which have no radius
    const Vec3 relative = displacement - (end.position - begin.position);
    const double least = std::min(begin.scale, end.scale), growth = std::fabs(end.scale - begin.scale) / least;
    const double away = length(from - begin.position) + length(relative);
    const double speed = 4 * tangent, change = 16 * tangent * tangent * tangent;
    bulge = (away * (speed * speed + change + 2 * speed * growth + 2 * growth * growth) +
             2 * length(relative) * (speed + growth)) /
            (8 * least);
    const double most_bulge = radius / (4 * std::max(begin.scale, end.scale));
    if (bulge <= most_bulge) return 1;
    return bulge < most * most * most_bulge ? static_cast<uint32_t>(std::sqrt(bulge / most_bulge)) + 1 : most;
}

/// tan(angle / 4) of the angle between two rotations: sin(angle / 2) / (1 + cos(angle / 2)).
double quarter_tangent(const Mat3& a, const Mat3& b) {
    // a.x - b.x|^2 + ... = 4 (1 - cos). Added to 1, the rounding of equal rotations vanishes.
    const double square = length_squared(a.x - b.x) + length_squared(a.y - b.y) + length_squared(a.z - b.z);
    const double cosine = std::max(-1.0, 1 - square / 4);
    return std::sqrt((1 - cosine) / 2) / (1 + std::sqrt((1 + cosine) / 2));
}

}  // namespace

Transform Collider::place_of(gphys_model_id moved, double time) const {
    const auto before = std::lower_bound(around_.moved->begin(), around_.moved->end(), PlacedModel{moved, {}});
    return interpolate(before->world, around_.scene->world(moved), time);
}

/// Relative to the model, which also moves during the substep: the points of the path are transformed into the model's
/// coordinates, each at its own time, and from there to the model's present place in the scene.
void Collider::sweep_moved(const PlacedModel& before, const Sphere& moving, Vec3 displacement, double time,
                           Impact& first) const {
    const gphys_transform& after = around_.scene->world(before.model);
    const Transform now = widen(after);
    const Transform at_begin = interpolate(before.world, after, time);
    const Transform at_end = interpolate(before.world, after, around_.end);
    const Vec3 last = now.apply(at_end.inverse_apply(moving.center + displacement));
    Vec3 from = now.apply(at_begin.inverse_apply(moving.center));
    double bulge = 0;
    const uint32_t parts = parts_of_path(at_begin, at_end, moving.center, displacement,
                                         quarter_tangent(at_begin.rotation, at_end.rotation), moving.radius, bulge);
    Box box;
    const bool bounded = around_.scene->bounds(before.model, box);
    const Sphere widest{from, moving.radius + bulge * now.scale};
    if (bounded && !overlaps(box, path_box(widest, last - from))) return;
    for (uint32_t i = 1; i <= parts; ++i) {
        const double part = static_cast<double>(i) / parts;
        const Transform then = interpolate(before.world, after, time + (around_.end - time) * part);
        const Vec3 to = i == parts ? last : now.apply(then.inverse_apply(moving.center + displacement * part));
        const Sphere relative{from, moving.radius};
        const Vec3 path = to - from;
        Hit hit;
        if ((!bounded || overlaps(box, path_box(relative, path))) &&
            around_.scene->sweep_model(before.model, relative, path, hit)) {
            hit.t = (i - 1 + hit.t) / parts;
            const double when = time + (around_.end - time) * hit.t;
            const Transform there = interpolate(before.world, after, when);
            const auto placed = [&](Vec3 p) { return there.apply(now.inverse_apply(p)); };
            const Vec3 on_model = now.inverse_apply(hit.point);
            const Vec3 moved_by =
                at_end.apply(on_model) - interpolate(before.world, after, around_.begin).apply(on_model);
            const double seconds = around_.step_time * (around_.end - around_.begin);
            keep_first(first, {hit.t, before.model, i == 1 && (hit.flags & GPHYS_HIT_INSIDE) != 0, true, when,
                               placed(from + path * (hit.t * parts - (i - 1))), placed(hit.point),
                               there.rotation * transpose_times(now.rotation, hit.normal), moved_by / seconds});
            return;
        }
        from = to;
    }
}

Impact Collider::at_substep_end(const Impact& impact) const {
    const Transform then = place_of(impact.model, impact.time), end = place_of(impact.model, around_.end);
    Impact later = impact;
    later.time = around_.end;
    later.center = end.apply(then.inverse_apply(impact.center));
    later.point = end.apply(then.inverse_apply(impact.point));
    later.normal = end.rotation * transpose_times(then.rotation, impact.normal);
    return later;
}

void Collider::sweep_moving(const Sphere& moving, Vec3 displacement, double time, gphys_model_id ignored,
                            Impact& first) const {
    for_each_moving([&](const PlacedModel& before) {
        if (before.model != ignored) sweep_moved(before, moving, displacement, time, first);
    });
}

Vec3 Collider::place_off_model(const Body& body, uint32_t particle, Vec3 at, const Impact& impact) const {
    Vec3 displacement = impact.center + impact.normal * skin(body.particles.radius[particle], at) - at;
    for (int contact = 0; contact < 3; ++contact) {  // a corner has three
        Impact stopped;
        sweep_unmoved(particle, at, displacement, 0, stopped);
        if (stopped.model == 0) return at + displacement;
        const double t = stopped.inside ? 0 : stop_short(body, particle, at, displacement, stopped);
        at += displacement * t;
        displacement *= 1 - t;
        displacement += stopped.normal * std::max(0.0, -dot(displacement, stopped.normal));
    }
    return at;
}

}  // namespace gphys
