// Animation targets: places that particles are given frame by frame, and how far from there they may be.
//
// A target goes evenly from where the last step left it to where the caller wants it, so that a fast character does not
// pull its clothes by a whole frame's way at once. One with a maximum distance of 0 carries its particle, which has
// infinite mass during the step, as an attached one has. Every other bounds its particle: by a ball around the target,
// and by a plane behind it, the backstop. A particle out of these is put on the nearest place that they leave it, and
// has the target's velocity across them; as after a contact, the time scheme begins again.
//
// Bounds act at the end of a substep, after the links and before models: contacts win. Where a rope or cloth is moved
// alone they act on the links as well, so that what hangs from a particle at its bound is carried: in ropes as contacts
// do (rope_contacts.h), in cloth as surfaces that the chains go along (cloth_kernels.cpp). In free particles, and
// beside joints and other bodies, they move the particle alone.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"

namespace gphys {

struct Body;
struct CollisionContext;

struct AnimationTarget {
    Vec3 from, to;                                        // at the beginning and at the end of the next step
    Vec3 from_normal, to_normal;                          // of any length but 0; not in use without a backstop
    double max_distance = infinity, backstop = infinity;  // metres; infinity: none
    uint32_t fresh = 1;                                   // 1: the next step begins where it ends
    uint32_t carries = 0;                                 // in the step under way: one of the below

    static constexpr uint32_t pinned = 1, free = 2;  // what its particle is between steps

    bool bounds() const { return max_distance < infinity || backstop < infinity; }
};

/// Where dot(normal, x) >= offset, moving along the normal at that speed.
struct TargetBound {
    Vec3 normal;
    double offset, speed;
};

/// The bounds that a particle was out of, and lies on now.
struct TargetBounds {
    uint32_t particle = 0, count = 0;
    TargetBound bound[2];

    /// The velocity beside them. Neither out of them nor back: the time scheme, which looks back to before, would let a
    /// particle rebound from what it meets.
    Vec3 turned(Vec3 velocity) const;
};

struct AnimationTargets {
    explicit AnimationTargets(std::pmr::memory_resource* memory) : all(memory), pressing(memory), reached(memory) {}

    bool empty() const { return all.empty(); }
    /// In the substep.
    bool act() const { return !pressing.empty() || !reached.empty(); }

    Vector<AnimationTarget> all;  // by particle, or empty
    // Of the step under way:
    bool moves = false;             // whether any that carries does
    double fraction = 1, time = 1;  // of the substep: its end, as a part of the step; seconds of the step
    Vector<TargetBounds> pressing;  // of cloth: before the chains
    Vector<TargetBounds> reached;   // and what is at its bounds at the end of the substep
};

void set_animation_targets(Body& body, uint32_t first, uint32_t count, const gphys_animation_target* targets,
                           uint32_t stride);
gphys_animation_target animation_target(const Body& body, uint32_t particle);
/// Particles that the caller has moved: their targets do not come from where they were.
void restart_targets(Body& body, uint32_t first, uint32_t count);

/// Metres that targets may take a particle in the next step beyond its own motion.
double way_to_targets(const Body& body);
/// Makes room; throws std::bad_alloc.
void reserve_targets(Body& body);
/// Around all substeps of a step.
void begin_targets(Body& body) noexcept;
void end_targets(Body& body);

/// Where one is at a fraction of the step.
inline Vec3 place_of(const AnimationTarget& target, double fraction) {
    return target.from + (target.to - target.from) * fraction;
}
/// The plane behind it, and the plane that touches its ball nearest to `at`: what acts there if the particle is out of
/// it. The offset is -infinity if there is none.
TargetBound backstop_of(const AnimationTarget& target, double fraction, double time, Vec3 at);
TargetBound ball_of(const AnimationTarget& target, double fraction, double time, Vec3 at);
/// The nearest place to `at` that a target leaves its particle at a fraction of a step of so many seconds; and the
/// bounds that `at` is out of: of the place if it is another.
Vec3 allowed_place(const AnimationTarget& target, double fraction, double time, Vec3 at, TargetBounds& out_of);

/// Before a substep.
void aim_targets(Body& body, const CollisionContext& around);
/// Of the substep: all particles to what their targets allow; those that were out are listed in `reached`. Of what is
/// no cloth.
void keep_to_targets(Body& body);
/// Once there are velocities: of those listed.
void stop_at_targets(Body& body);

}  // namespace gphys
