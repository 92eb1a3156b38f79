// Animation targets: interpolation, and the projection of particles onto their bounds (animation_targets.h).
#include "solver/animation_targets.h"
#include "foundation/strided.h"
#include "solver/body.h"
#include "solver/contact/collision.h"
#include "solver/state.h"

namespace gphys {
namespace {

Vec3 unit(Vec3 v) {
    const double scale = max_component(abs(v));
    if (scale == 0) return {0, 1, 0};
    v = v / scale;
    return v / length(v);
}

bool is_same(const AnimationTarget& target, const gphys_animation_target& given) {
    return target.to == widen(given.position) && target.max_distance == given.max_distance &&
           target.backstop == given.backstop &&
           (target.backstop == infinity || target.to_normal == widen(given.normal));
}

}  // namespace

void set_animation_targets(Body& body, uint32_t first, uint32_t count, const gphys_animation_target* targets,
                           uint32_t stride) {
    Vector<AnimationTarget>& all = body.targets.all;
    const Strided<gphys_animation_target> from(targets, stride);
    const auto bounds = [](const gphys_animation_target& given) {
        return given.max_distance < INFINITY || given.backstop < INFINITY;
    };
    if (all.empty()) {
        bool any = false;
        for (uint32_t i = 0; i < count && !any; ++i) any = bounds(from[i]);
        if (!any) return;
        all.resize(body.particles.size());
    }
    bool changed = false;
    for (uint32_t i = 0; i < count; ++i) {
        AnimationTarget& target = all[first + i];
        if (!target.bounds() && !bounds(from[i])) continue;
        if (target.bounds() && is_same(target, from[i])) continue;
        changed = true;
        if (target.max_distance == 0 && from[i].max_distance > 0 && body.particles.pinned(first + i) &&
            !is_attached(body.constraints, first + i)) {
            // It is at rest again.
            body.particles.velocity[first + i] = {};
            interrupt(body);
        }
        if (!target.bounds() || !bounds(from[i])) target = {};
        if (!bounds(from[i])) continue;
        const bool had_backstop = target.backstop < infinity;
        target.to = widen(from[i].position);
        target.max_distance = from[i].max_distance;
        target.backstop = from[i].backstop;
        target.to_normal = target.backstop < infinity ? widen(from[i].normal) : Vec3{};
        if (!had_backstop || target.backstop == infinity) target.from_normal = target.to_normal;
    }
    if (!changed) return;
    if (body.sleep.asleep) wake(body);
    body.sleep.rest_time = 0;
    const auto bounding = [](const AnimationTarget& target) { return target.bounds(); };
    if (std::none_of(all.begin(), all.end(), bounding)) all.clear();
}

gphys_animation_target animation_target(const Body& body, uint32_t particle) {
    const AnimationTarget target = body.targets.empty() ? AnimationTarget{} : body.targets.all[particle];
    return {narrow(target.to), narrow(target.to_normal), static_cast<float>(target.max_distance),
            static_cast<float>(target.backstop)};
}

void restart_targets(Body& body, uint32_t first, uint32_t count) {
    if (body.targets.empty()) return;
    for (uint32_t i = 0; i < count; ++i) body.targets.all[first + i].fresh = 1;
}

double way_to_targets(const Body& body) {
    double longest = 0;
    for (uint32_t p = 0; p < body.targets.all.size(); ++p) {
        const AnimationTarget& target = body.targets.all[p];
        if (!target.bounds()) continue;
        const Vec3 off = body.particles.position[p] - target.to;
        double way = target.fresh ? 0 : distance(target.from, target.to);
        if (target.max_distance < infinity) way += std::max(0.0, length(off) - target.max_distance);
        if (target.backstop < infinity) way += std::max(0.0, -target.backstop - dot(off, unit(target.to_normal)));
        longest = std::max(longest, way);
    }
    return longest;
}

void reserve_targets(Body& body) {
    if (body.targets.empty()) return;
    body.targets.pressing.reserve(body.particles.size());
    body.targets.reached.reserve(body.particles.size());
}

void begin_targets(Body& body) noexcept {
    body.targets.moves = false;
    for (uint32_t p = 0; p < body.targets.all.size(); ++p) {
        AnimationTarget& target = body.targets.all[p];
        if (target.fresh) target.from = target.to, target.from_normal = target.to_normal;
        if (target.max_distance > 0 || is_attached(body.constraints, p)) continue;
        target.carries = body.particles.pinned(p) ? AnimationTarget::pinned : AnimationTarget::free;
        body.particles.inverse_mass[p] = 0;
        body.targets.moves = body.targets.moves || body.particles.position[p] != target.to;
    }
}

void end_targets(Body& body, double way) {
    for (uint32_t p = 0; p < body.targets.all.size(); ++p) {
        AnimationTarget& target = body.targets.all[p];
        target.from_normal = way < 1 ? normal_of(target, way) : target.to_normal;
        target.from = way < 1 ? place_of(target, way) : target.to;
        target.fresh = 0;
        if (target.carries == AnimationTarget::free) body.particles.inverse_mass[p] = 1 / body.particles.mass[p];
        target.carries = 0;
    }
}

Vec3 TargetBounds::turned(Vec3 velocity) const {
    // Planes closer to parallel than this count as one.
    constexpr double least = 1e-6;
    const Vec3 a = bound[0].normal, b = bound[1].normal;
    const double lacks_a = bound[0].speed - dot(velocity, a);
    const double both = count > 1 ? dot(a, b) : 0, apart = 1 - both * both;
    if (count < 2 || apart < least) return velocity + a * lacks_a;
    const double lacks_b = bound[1].speed - dot(velocity, b);
    return velocity + (a * (lacks_a - both * lacks_b) + b * (lacks_b - both * lacks_a)) / apart;
}

TargetBound backstop_of(const AnimationTarget& target, double fraction, double time, Vec3 at) {
    if (target.backstop == infinity) return {{0, 1, 0}, -infinity, 0};
    const Vec3 center = place_of(target, fraction), off = at - center;
    const Vec3 across = normal_of(target, fraction), turning = target.to_normal - target.from_normal;
    const double size = length(across);
    const Vec3 normal = across / size;
    // As the normal rotates, the plane moves with it.
    const double turned = (dot(off, turning) - dot(off, normal) * dot(normal, turning)) / size;
    return {normal, dot(normal, center) - target.backstop, (dot(normal, target.to - target.from) - turned) / time};
}

TargetBound ball_of(const AnimationTarget& target, double fraction, double time, Vec3 at) {
    const Vec3 center = place_of(target, fraction), normal = unit(center - at);
    return {normal, dot(normal, center) - target.max_distance, dot(normal, target.to - target.from) / time};
}

Vec3 allowed_place(const AnimationTarget& target, double fraction, double time, Vec3 at, TargetBounds& out_of) {
    out_of.count = 0;
    const Vec3 center = place_of(target, fraction);
    Vec3 off = at - center;
    Vec3 normal;
    bool behind = false;
    if (target.backstop < infinity) {
        normal = normal_of(target, fraction);
        const double height = dot(off, normal);
        behind = is_behind(target, height, normal);
        if (behind) {
            const double size = length(normal);
            normal = normal / size;
            off += normal * (-target.backstop - height / size);
        }
    }
    const double most = target.max_distance, square = length_squared(off);
    const bool beyond = square > most * most;
    if (beyond && behind && target.backstop < most) {
        // Along the plane, to the circle in which it intersects the ball.
        const Vec3 along = off - normal * dot(off, normal);
        const double radius = std::sqrt((most - target.backstop) * (most + target.backstop));
        off = normal * -target.backstop + along * (radius / length(along));
    } else if (beyond) {
        off *= most / std::sqrt(square);
        behind = false;
    }
    if (!behind && !beyond) return at;
    const Vec3 place = center + off;
    if (behind) out_of.bound[out_of.count++] = backstop_of(target, fraction, time, place);
    if (beyond) out_of.bound[out_of.count++] = ball_of(target, fraction, time, place);
    return place;
}

void aim_targets(Body& body, const CollisionContext& around) {
    body.targets.fraction = around.way(around.end);
    body.targets.time = around.way_time();
    body.targets.pressing.clear();
    body.targets.reached.clear();
}

void keep_to_targets(Body& body) {
    AnimationTargets& targets = body.targets;
    targets.reached.clear();
    for (uint32_t p = 0; p < targets.all.size(); ++p) {
        if (body.particles.pinned(p) || is_allowed(targets.all[p], targets.fraction, body.particles.position[p]))
            continue;
        TargetBounds out_of;
        body.particles.position[p] =
            allowed_place(targets.all[p], targets.fraction, targets.time, body.particles.position[p], out_of);
        out_of.particle = p;
        if (out_of.count > 0) targets.reached.push_back(out_of);
    }
}

void stop_at_targets(Body& body) {
    for (const TargetBounds& reached : body.targets.reached) {
        Vec3& velocity = body.particles.velocity[reached.particle];
        velocity = reached.turned(velocity);
    }
}

}  // namespace gphys
