// The state of cloth and of other graphs of constraints.
#pragma once

#include "foundation/team.h"
#include "solver/cloth/cloth_batches.h"
#include "solver/cloth/cloth_contacts.h"
#include "solver/cloth/rigid_links.h"
#include "solver/cloth/volume.h"

namespace gphys {

struct Body;
struct CollisionContext;

/// The energy balance of a substep of cloth.
struct ClothBalance {
    bool closed = false;   // no energy comes from outside
    double gain = 0;       // joules gained beyond the work of forces
    double lost = 0;       // joules lost together with joined bodies; the first cloth of a system holds this for all
    double stored = 0;     // in elastic links, per average mass
    bool current = false;  // whether `stored` is valid: nothing has moved since
};

/// Bounds and mass of some particles.
struct ClothExtent {
    Aabb box;
    double mass;
};

/// Squared distances that particles moved in a step, square metres.
struct ClothWay {
    double sum = 0, longest = 0;

    void add(double square) { sum += square, longest = std::max(longest, square); }
};

/// The state of cloth during a step, in the layout of cloth_kernels.h: four floats for each particle, and for a few
/// more that do not move.
struct Cloth {
    explicit Cloth(std::pmr::memory_resource* memory)
        : at(memory),
          start(memory),
          moved(memory),
          velocity(memory),
          velocity_before(memory),
          acceleration(memory),
          search_balls(memory),
          sums(memory),
          stored(memory),
          extents(memory),
          ways(memory),
          tether_diagonal(memory),
          tether_off(memory),
          strained(memory),
          waiting(memory),
          listed(memory),
          volume(memory),
          rest_position(memory),
          triangles(memory),
          rigid(memory),
          pin_ways(memory),
          reach_limits(memory),
          batches(memory),
          contacts(memory) {}

    Vec3 origin;              // of the positions
    double average_mass = 1;  // of the particles
    uint32_t particles = 0;   // number of the body's particles
    Team* team = nullptr;     // shares the work of the step under way; null: nobody
    bool pulled = false;      // the caller may have done work on it since the last step
    bool held = false;        // whether any particle does not move freely
    Vector<float> at, start, moved, velocity, velocity_before, acceleration;
    /// Four floats for each particle: where it searched for contacts last, relative to the origin, and how far. Empty
    /// if the next step must search anew.
    Vector<float> search_balls;
    static constexpr float no_ball = -1;  // as the distance
    Vector<double> sums;                  // of energy, by block of particles
    Vector<double> stored;                // energy, by batch of chains
    Vector<ClothExtent> extents;          // by share of particles
    Vector<ClothWay> ways;                // the same, for the last step
    ClothBalance balance;
    Vector<float> tether_diagonal, tether_off;  // see ClothTethers; only for joined cloth
    // For cloth that is relaxed (relax_links.cpp):
    double most_strain = 0;     // of its rigid links; 0: it is not relaxed
    bool braces_yield = false;  // braces are not relaxed
    double wanted_substep = 0;  // seconds: the longest that would have sufficed, in the worst substep of this step
    Vector<uint32_t> strained, waiting;  // capacity for all links
    Vector<uint8_t> listed;              // by KeptLinks::links: whether it is waiting

    Volume volume;
    /// The rest positions of the particles of a flat sheet: the distance of two of them is the largest possible one.
    /// Empty for other bodies and for torn sheets.
    Vector<Vec3> rest_position;
    Vector<uint32_t> triangles;  // for drawing
    RigidLinks rigid;            // of the plan, whatever is pinned
    Vector<ReachWay> pin_ways;   // along them, in order: what the limits are made of. Empty: not known
    Vector<ReachLimit> reach_limits;
    ClothBatches batches;  // chains and limits in the layout of the kernels
    ClothContacts contacts;
};

/// A step has functions for its beginning and its end. cloth_floats: the length of each array of the state.
/// reserve_cloth allocates these arrays, except those that a snapshot holds: `moved` and `velocity_before`.
size_t cloth_floats(const Body& body);
void reserve_cloth(Body& body);
void begin_cloth(Body& body, const CollisionContext& around, Vec3 gravity);
void move_cloth(Body& body, const CollisionContext& around, Vec3 gravity, double h);
/// The three parts of move_cloth, for cloth that is joined to other bodies.
void predict_cloth(Body& body, const CollisionContext& around, double h);
void solve_cloth(Body& body);
void finish_cloth(Body& body, const CollisionContext& around, Vec3 gravity, double h);
/// One sweep over the chains and limits, without contacts.
void project_cloth(Body& body);
void end_cloth_substep(Body& body, const CollisionContext& around, Vec3 gravity,
                       double h);  // the part after predict_cloth
void end_cloth(Body& body, const CollisionContext& around);

/// Mass and momentum.
struct Motion {
    double mass = 0;
    Vec3 momentum;

    void add(double mass_, Vec3 velocity) { mass += mass_, momentum += velocity * mass_; }
    void add(const Motion& other) { mass += other.mass, momentum += other.momentum; }
};
/// Between substeps: the motion of all particles; their energy relative to a drift, in joules; scaling of the
/// velocities relative to a drift.
Motion motion_of_cloth(const Body& body);
double inner_energy_of_cloth(Body& body, Vec3 drift);
void slow_cloth(Body& body, Vec3 drift, double kept);

}  // namespace gphys
