// What ropes have in common that are solved one by one (rope_direct.cpp) and side by side (rope_lanes.cpp).
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

struct Body;
struct CollisionContext;
struct TimeScheme;
struct Chain;
class RopeContacts;

/// What elimination along a rope leaves for substitution, per particle.
struct DirectRow {
    double next[4][4];  // times the unknowns of the next particle and link
    double value[4];
};

/// Of chains that are solved directly.
struct Rope {
    explicit Rope(std::pmr::memory_resource* memory)
        : damped_rest(memory),
          damped_compliance(memory),
          target(memory),
          tension(memory),
          earlier_tension(memory),
          rows(memory),
          solved(memory),
          flying(memory) {}

    // By link of the plan:
    Vector<double> damped_rest, damped_compliance;  // in the substep under way, see damping.h
    Vector<double> target;                          // the length it shall have
    Vector<double> tension;                         // newtons, of the last substep
    Vector<double> earlier_tension;                 // of the one before

    Vector<DirectRow> rows;  // room for the longest chain
    Vector<Vec3> solved;     // the positions that the links had found when they met models
    Vector<uint8_t> flying;  // by particle, if there are limits: whether none of its links was taut at the start
};

/// Whether its first substep is made in parts, after an interruption.
bool starts_again(const Body& body);

/// The lengths that links shall have. Between two pins that are further apart than the rigid links between them are
/// long together, no link can keep its length; the stretch that cannot be avoided is shared in proportion.
void set_targets(Body& body, const Chain& chain);

/// solve_directly together with contacts, or without if there are none (null).
bool solve_with_contacts(Body& body, double step, RopeContacts* contacts);

/// The part of its length that a rigid link may lack before a substep and count as in shape. Those that are put right
/// by it do so at a speed that grows as it gets shorter.
constexpr double in_shape = 0.05;

/// The parts of a substep for chains (rope_substep.cpp): free particles to where they would go without constraints,
/// attached ones after their models; the velocities that the time scheme gives for the solved positions, once these are
/// where targets and contacts (or null) allow them to be; and tensions to the models that ropes hang from.
void begin_chains(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme);
/// As it was before begin_chains, before anything else has been done.
void roll_back_chains(Body& body);
void finish_chains(Body& body, const TimeScheme& scheme, const RopeContacts* contacts = nullptr);
void add_tension_impulses(Body& body, const CollisionContext& around, const TimeScheme& scheme);

/// All of them for a rope alone; and what follows begin_chains.
void move_rope(Body& body, const CollisionContext& around, Vec3 gravity, double h, RopeContacts* contacts);
void end_rope(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme);

/// Particles that touch something count as pinned in between.
void pin_contacts(Body& body);
void unpin_contacts(Body& body);

/// Positions are moved so that the constraints hold; `step` is the effective time step of the scheme:
/// a force f moves a particle by f / m * step^2. Returns whether they do.
bool solve_directly(Body& body, double step);

}  // namespace gphys
