// Animation targets: positions given to particles frame by frame, and how far from there they may be.
//
// A target moves evenly from its last position to the new one, so that a fast character does not pull its clothes by
// the displacement of a whole frame at once. A target with a maximum distance of 0 carries its particle, which has
// infinite mass during the step, as an attached one. Any other target bounds its particle: by a ball around the target,
// and by a plane behind it, the backstop. A particle outside is projected onto the nearest allowed position, and gets
// the target's velocity normal to the bounds. As after a contact, the time scheme starts again.
//
// Bounds act at the end of a substep, after the links and before models, so contacts take precedence. In ropes and
// cloth that are moved alone they also act on the links, so that particles linked to one at its bound are carried: in
// ropes as contacts (rope_contacts.h), in cloth as contact planes (cloth_kernels.cpp). In free particles, and with
// joints or other bodies, they move single particles.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"

namespace gphys {

struct Body;
struct CollisionContext;

struct AnimationTarget {
    Vec3 from, to;                                        // at the beginning and at the end of the next step
    Vec3 from_normal, to_normal;                          // of any length except 0; unused without a backstop
    double max_distance = infinity, backstop = infinity;  // metres; infinity: none
    uint32_t fresh = 1;                                   // 1: the next step begins at its end position
    uint32_t carries = 0;                                 // in the step under way: one of the values below

    static constexpr uint32_t pinned = 1, free = 2;  // state of its particle between steps

    bool bounds() const { return max_distance < infinity || backstop < infinity; }
};

/// The half-space dot(normal, x) >= offset, moving along the normal at that speed.
struct TargetBound {
    Vec3 normal;
    double offset, speed;
};

/// The bounds that a particle was outside of, and is on now.
struct TargetBounds {
    uint32_t particle = 0, count = 0;
    TargetBound bound[2];

    /// The velocity with the normal components of the bounds, so that it leads neither out nor back. Otherwise the time
    /// scheme, which uses the history, would let a particle rebound.
    Vec3 turned(Vec3 velocity) const;
};

struct AnimationTargets {
    explicit AnimationTargets(std::pmr::memory_resource* memory) : all(memory), pressing(memory), reached(memory) {}

    bool empty() const { return all.empty(); }
    /// Whether any bound is active in the substep.
    bool act() const { return !pressing.empty() || !reached.empty(); }

    Vector<AnimationTarget> all;  // by particle, or empty
    // Of the step under way:
    bool moves = false;             // whether any target that carries a particle moves
    double fraction = 1, time = 1;  // of the substep: its end as a fraction of the step; seconds of the step
    Vector<TargetBounds> pressing;  // for cloth: active before the chains
    Vector<TargetBounds> reached;   // particles at their bounds at the end of the substep
};

void set_animation_targets(Body& body, uint32_t first, uint32_t count, const gphys_animation_target* targets,
                           uint32_t stride);
gphys_animation_target animation_target(const Body& body, uint32_t particle);
/// For particles that the caller has moved: their targets forget their last positions.
void restart_targets(Body& body, uint32_t first, uint32_t count);

/// A bound in metres for how far targets may move a particle in the next step, beyond its own motion.
double way_to_targets(const Body& body);
/// Allocates memory. Throws std::bad_alloc.
void reserve_targets(Body& body);
/// Call before and after all substeps of a step.
void begin_targets(Body& body) noexcept;
/// `way`: the fraction of the way to the targets that the step has covered.
void end_targets(Body& body, double way);

/// The position of a target at a fraction of the step.
inline Vec3 place_of(const AnimationTarget& target, double fraction) {
    return target.from + (target.to - target.from) * fraction;
}
/// The normal of its backstop then, of any length except 0.
inline Vec3 normal_of(const AnimationTarget& target, double fraction) {
    const Vec3 between = target.from_normal + (target.to_normal - target.from_normal) * fraction;
    return between == Vec3{} ? target.to_normal : between;
}
/// Whether a position is that far behind the backstop, at this height above the target along the normal. Takes no root.
inline bool is_behind(const AnimationTarget& target, double height, Vec3 normal) {
    return height < 0 && height * height > target.backstop * target.backstop * length_squared(normal);
}
/// Whether allowed_place leaves a position where it is, as that of most particles in most substeps.
inline bool is_allowed(const AnimationTarget& target, double fraction, Vec3 at) {
    const Vec3 off = at - place_of(target, fraction);
    if (length_squared(off) > target.max_distance * target.max_distance) return false;
    if (target.backstop == infinity) return true;
    const Vec3 normal = normal_of(target, fraction);
    return !is_behind(target, dot(off, normal), normal);
}
/// The backstop, and the tangent plane of the ball nearest to `at`: the bounds of a particle outside. The offset is
/// -infinity if there is none.
TargetBound backstop_of(const AnimationTarget& target, double fraction, double time, Vec3 at);
TargetBound ball_of(const AnimationTarget& target, double fraction, double time, Vec3 at);
/// The allowed position nearest to `at`, at a fraction of a step of `time` seconds. `out_of`: the bounds that `at` is
/// outside of, at the result.
Vec3 allowed_place(const AnimationTarget& target, double fraction, double time, Vec3 at, TargetBounds& out_of);

/// Call before a substep.
void aim_targets(Body& body, const CollisionContext& around);
/// For bodies that are not cloth: projects all particles onto their bounds; those that were outside are listed in
/// `reached`.
void keep_to_targets(Body& body);
/// Call after the velocities have been computed: for the particles in `reached`.
void stop_at_targets(Body& body);

}  // namespace gphys
