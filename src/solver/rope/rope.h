// Ropes: their state, and the functions that those that are solved one by one (rope_direct.cpp) have in common with
// those that are solved side by side (rope_lanes.cpp) or with other bodies (joints/).
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/contact/heavy_body.h"
#include "solver/rope/bending.h"

namespace gphys {

struct Body;
struct Contacts;
struct History;
struct Particles;
struct Plan;
struct CollisionContext;
struct TimeScheme;
struct Chain;
class RopeContacts;

/// A block row of the eliminated system, for back substitution: the unknowns of a particle and of the link that arrives
/// at it are value - next * those of the next particle. After substitution, value is the solution.
struct DirectRow {
    double next[4][4];
    double value[4];
};

constexpr int stiff_band = 8;

/// A row of the factor of a chain that resists bending. lower[8 - k] is the entry k columns before the diagonal. After
/// substitution, value is the solution.
struct StiffRow {
    double lower[stiff_band];
    double inverse_pivot, value;
};

/// The share of a load that presses on a particle in the substep under way (contact/rope_loads.h).
struct RopeLoad {
    uint32_t of;        // the load: the first particle of what moves as one, among the island's contacts
    uint32_t by;        // the particle of it that presses
    uint32_t particle;  // of the rope
    uint32_t pair;      // of the contact, in the list of the island
    Vec3 normal;        // unit, from the particle to the load
    bool sticks;        // whether there is any friction
    Vec3 arm{};         // from the centre of the load to the particle that presses
    // The mass that the particle has as well while the links are solved, along the normal and across it, kg:
    double along = 0, across = 0;
    Vec3 place{};  // of the particle, before the links are solved

    /// Of a displacement of the particle: what it takes of the load, kg m.
    Vec3 momentum(Vec3 displacement) const {
        return displacement * across + normal * (dot(normal, displacement) * (along - across));
    }
};

/// What a rope carries while its links are solved (contact/rope_loads.h finds it).
struct CarriedLoads {
    explicit CarriedLoads(std::pmr::memory_resource* memory) : all(memory), heavy(memory) {}

    Vector<RopeLoad> all;  // those of a load together
    Vector<HeavyBody> heavy;
    double energy = 0;  // of the rope before the links are solved, joules
    double rate = 0;    // 1/s: by which a displacement by links changes the velocity

    bool any() const { return !all.empty(); }
    void clear() {
        all.clear();
        heavy.clear();
    }
};

/// State of chains that are solved directly.
struct Rope {
    explicit Rope(std::pmr::memory_resource* source) : memory(source) {}

    std::pmr::memory_resource* memory;
    // By link of the plan:
    Vector<double> damped_rest{memory}, damped_compliance{memory};  // m, m/N, of the substep under way, see damping.h
    Vector<double> target{memory};                                  // metres, the length to reach (set_targets)
    Vector<double> tension{memory};                                 // newtons, of the last substep
    Vector<double> earlier_tension{memory};                         // of the substep before
    bool misplaced = false;  // whether rigid links had wrong lengths when the substep began (rope_start.h)
    bool yields = false;     // whether links between pins share a stretch that they cannot correct in this substep

    Bending bending{memory};

    Vector<DirectRow> rows{memory};       // for the longest chain
    Vector<StiffRow> stiff_rows{memory};  // if the body resists bending: four for each particle, between eight of zeros
    // By particle:
    Vector<Vec3> solved{memory};    // positions solved with the links alone, before contacts
    Vector<uint8_t> slack{memory};  // if there are limits: whether all its links were slack at the start of the substep

    CarriedLoads loads{memory};  // empty between substeps
};

/// Whether the time scheme restarts after an interruption that is no contact: the first substep is made in parts.
bool restarts(const History& history, const Contacts& contacts);

/// The same as solve_directly, together with contacts unless they are null.
bool solve_with_contacts(Body& body, double step, RopeContacts* contacts);

// The parts of a substep for chains (rope_substep.cpp):
/// Predicts: free particles move as without constraints, attached ones with their models.
void begin_chains(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme);
/// Restores the state before begin_chains, if nothing else has been done since.
void roll_back_chains(Particles& particles, History& history, Rope& rope);
/// Moves the solved positions to where targets and contacts (or null) allow them, and computes the velocities of the
/// time scheme from them.
void finish_chains(Body& body, const TimeScheme& scheme, const RopeContacts* contacts = nullptr);
/// Adds the tensions of links at attached particles to the impulses of their models.
void add_tension_impulses(Body& body, const CollisionContext& around, const TimeScheme& scheme);

/// Decides whether the next substep continues the time scheme or restarts it, and adds up the loads of the links.
void end_substep(Body& body, bool has_limit_impact, const TimeScheme& scheme);

/// A whole substep of a rope without RopeContacts, and what follows begin_chains in it.
void move_rope(Body& body, const CollisionContext& around, Vec3 gravity, double h);
void end_rope(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme);
/// At the end of a substep in which something has moved particles from History::start: gives links their lengths back,
/// without speed. Models stop what moves. `step`: as in solve_directly.
void restore_lengths(Body& body, const CollisionContext& around, double step);

/// Between the two, the particles in contact count as pinned.
void pin_contacts(Particles& particles, const Contacts& contacts);
void unpin_contacts(Particles& particles, const Contacts& contacts);

/// Moves the positions so that the constraints hold. `step`: seconds, the effective time step of the scheme; a force f
/// moves a particle by f / m * step^2. Returns whether Newton's method has converged.
bool solve_directly(Body& body, double step);

}  // namespace gphys
