// The state of cloth and of other graphs of constraints.
#pragma once

#include "foundation/team.h"
#include "solver/cloth/cloth_batches.h"
#include "solver/cloth/cloth_contacts.h"
#include "solver/cloth/volume.h"

namespace gphys {

struct Body;
struct CollisionContext;

/// Of a substep of cloth.
struct ClothBalance {
    bool closed = false;   // no energy comes from outside
    double gain = 0;       // joules beyond those that forces gave
    double lost = 0;       // and those that what it is joined to has lost with it; of a whole system in the first cloth
    double stored = 0;     // by elastic links, per average mass
    bool current = false;  // whether none has moved since
};

/// Of some of its particles.
struct ClothExtent {
    Aabb box;
    double mass;
};

/// How far particles went in a step, square metres.
struct ClothWay {
    double sum = 0, longest = 0;

    void add(double square) { sum += square, longest = std::max(longest, square); }
};

/// The state of cloth during a step, as cloth_kernels.h takes it: four floats for each particle, and
/// for a few more that do not move.
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
          reach_limits(memory),
          batches(memory),
          contacts(memory) {}

    Vec3 origin;              // of the positions
    double average_mass = 1;  // of the particles
    uint32_t particles = 0;   // that are the body's
    Team* team = nullptr;     // who shares the work of the step under way; null: nobody
    bool pulled = false;      // the caller may have done work on it since the last step
    bool held = false;        // whether any particle does not move freely
    Vector<float> at, start, moved, velocity, velocity_before, acceleration;
    /// Four floats a particle: where it searched for contacts last, relative to the origin, and how far. Empty if the
    /// next step has to begin anew.
    Vector<float> search_balls;
    static constexpr float no_ball = -1;  // how far
    Vector<double> sums;                  // of energy, by block of particles
    Vector<double> stored;                // energy, by batch of chains
    Vector<ClothExtent> extents;          // by share of particles
    Vector<ClothWay> ways;                // the same, of the step that has ended
    ClothBalance balance;
    Vector<float> tether_diagonal, tether_off;  // as ClothTethers takes them; only of joined cloth
    // Of cloth that is relaxed (relax_links.cpp):
    double most_strain = 0;              // of its rigid links; 0: it is not relaxed
    bool braces_yield = false;           // these are not relaxed
    double wanted_substep = 0;           // seconds: the longest that would have done, in the worst substep of this step
    Vector<uint32_t> strained, waiting;  // room for all links
    Vector<uint8_t> listed;              // by KeptLinks::links: whether it is waiting

    Volume volume;
    /// Where the particles of a flat sheet stand at rest: the distance of two of them is then the
    /// furthest they can ever be apart. Empty for other bodies and for torn sheets.
    Vector<Vec3> rest_position;
    Vector<uint32_t> triangles;  // for drawing
    Vector<ReachLimit> reach_limits;
    ClothBatches batches;  // chains and limits as the kernels take them
    ClothContacts contacts;
};

/// A step begins and ends with its own functions.
/// Makes room, but for what a snapshot holds: `moved` and `velocity_before`, so many floats each.
size_t cloth_floats(const Body& body);
void reserve_cloth(Body& body);
void begin_cloth(Body& body, const CollisionContext& around, Vec3 gravity);
void move_cloth(Body& body, const CollisionContext& around, Vec3 gravity, double h);
/// The three parts of it, for cloth that is joined to other bodies.
void predict_cloth(Body& body, const CollisionContext& around, double h);
void solve_cloth(Body& body);
void finish_cloth(Body& body, const CollisionContext& around, Vec3 gravity, double h);
/// A sweep over the chains and limits, whatever the particles touch.
void project_cloth(Body& body);
void end_cloth_substep(Body& body, const CollisionContext& around, Vec3 gravity,
                       double h);  // what follows predict_cloth
void end_cloth(Body& body, const CollisionContext& around);

/// Mass and momentum.
struct Motion {
    double mass = 0;
    Vec3 momentum;

    void add(double mass_, Vec3 velocity) { mass += mass_, momentum += velocity * mass_; }
    void add(const Motion& other) { mass += other.mass, momentum += other.momentum; }
};
/// Between substeps: of all particles; their energy beside a motion of all, in joules; and this part of it kept.
Motion motion_of_cloth(const Body& body);
double inner_energy_of_cloth(Body& body, Vec3 drift);
void slow_cloth(Body& body, Vec3 drift, double kept);

}  // namespace gphys
