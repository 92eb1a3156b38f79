// Common parts of ropes that are solved one by one (rope_direct.cpp) and side by side (rope_lanes.cpp).
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

struct Body;
struct CollisionContext;
struct TimeScheme;
struct Chain;
class RopeContacts;

/// A row of the factorised system, left by elimination for substitution; one for each particle.
struct DirectRow {
    double next[4][4];  // factor of the unknowns of the next particle and link
    double value[4];
};

/// State of chains that are solved directly.
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
    Vector<double> damped_rest, damped_compliance;  // of the substep under way, see damping.h
    Vector<double> target;                          // the length to reach
    Vector<double> tension;                         // newtons, of the last substep
    Vector<double> earlier_tension;                 // of the substep before

    Vector<DirectRow> rows;  // room for the longest chain
    Vector<Vec3> solved;     // the positions found with the links alone, before contacts
    Vector<uint8_t> flying;  // by particle, if there are limits: whether all its links were slack at the start
};

/// Whether its first substep is made in parts, after an interruption.
bool starts_again(const Body& body);

/// Sets the target lengths of links. If two pins are farther apart than the total length of the rigid links between
/// them, the unavoidable stretch is shared in proportion to the lengths.
void set_targets(Body& body, const Chain& chain);

/// solve_directly, together with contacts unless they are null.
bool solve_with_contacts(Body& body, double step, RopeContacts* contacts);

/// A rigid link may be wrong by this fraction of its length before a substep and still count as in shape. A larger
/// error would be corrected in the substep, at a speed that grows as the substep gets shorter.
constexpr double in_shape = 0.05;

/// The parts of a substep for chains (rope_substep.cpp). begin_chains predicts: free particles move as without
/// constraints, attached ones with their models. finish_chains computes the velocities of the time scheme from the
/// solved positions, after moving these to where targets and contacts (or null) allow them. add_tension_impulses adds
/// tensions to the impulses of models that ropes hang from.
void begin_chains(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme);
/// Restores the state before begin_chains, if nothing else has been done since.
void roll_back_chains(Body& body);
void finish_chains(Body& body, const TimeScheme& scheme, const RopeContacts* contacts = nullptr);
void add_tension_impulses(Body& body, const CollisionContext& around, const TimeScheme& scheme);

/// All of them for a single rope that has no RopeContacts; and the part after begin_chains.
void move_rope(Body& body, const CollisionContext& around, Vec3 gravity, double h);
void end_rope(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme);

/// Particles that friction holds count as pinned in between.
void pin_contacts(Body& body);
void unpin_contacts(Body& body);

/// Moves the positions so that the constraints hold. `step` is the effective time step of the scheme: a force f moves a
/// particle by f / m * step^2. Returns whether the constraints hold.
bool solve_directly(Body& body, double step);

}  // namespace gphys
