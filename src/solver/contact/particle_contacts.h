// Particles against particles, of one body or of several: off unless bodies ask for it.
//
// Pairs that may touch come from a list (Verlet 1967): those nearer than their radii and a margin for each,
// found by a spatial hash. The list holds until a particle has gone further than its margin; the faster it
// is, the wider its margin is the next time. After each substep the pairs whose paths came within touch of
// each other become contacts, with the direction that they met in, so that none passes through another
// whatever its speed. Some sweeps over the contacts part them and let friction act; the velocities follow,
// and are turned as the restitution says.
//
// Where many pairs overlap deeply, such as particles at one place, each particle takes a bounded number of pairs, and
// parting changes positions only, so that a pile spreads without being shot apart.
//
// Everything lies in arrays that are made large enough before the step and kept. An island has its own range
// of each.
#pragma once

#include "foundation/math.h"
#include "solver/body.h"
#include "solver/islands.h"

namespace gphys {

struct CollisionContext;

class ParticleContacts {
public:
    explicit ParticleContacts(std::pmr::memory_resource* memory)
        : particles_(memory),
          pairs_(memory),
          contacts_(memory),
          buckets_(memory),
          sorted_(memory),
          pair_counts_(memory),
          contact_counts_(memory),
          keys_(memory) {}

    /// Before a step, for all islands, whose ranges are set. Throws std::bad_alloc.
    void reserve(const Vector<Body>& bodies, Vector<Island>& islands, const Vector<uint32_t>& island_bodies);

    // For one island; what another does is not touched.
    void begin(const Island& island, const Vector<Body>& bodies, const uint32_t* slots);
    /// Once all bodies are predicted: part those that meet. h: seconds of the substep.
    void part(const Island& island, Vector<Body>& bodies, const uint32_t* slots, const CollisionContext& around,
              Vec3 gravity, double h);
    /// Once they have moved: turn the velocities of those that met.
    void turn(const Island& island, Vector<Body>& bodies, const uint32_t* slots);
    /// After the last substep: part what constraints have pressed into each other.
    void settle(const Island& island, Vector<Body>& bodies, const uint32_t* slots, const CollisionContext& around,
                Vec3 gravity, double h);

private:
    struct Particle {
        uint32_t body, number;
        double radius, inverse_mass, margin;
        Vec3 found_at;         // when the list was made
        Vec3 before, arrived;  // at the beginning of the substep, and at its end before contacts
        Vec3 at, velocity;
        Vec3 arrived_velocity;
        const ContactPoint*
            contact_points;  // contact_points_per_particle models that it has touched in this step, or null

        double reach() const { return radius + margin; }
    };
    struct Pair {
        uint32_t a, b;
    };
    struct Contact {
        uint32_t a, b;
        Vec3 normal;  // unit, from a to b
        double friction;
        double wanted;  // speed of parting, m/s
        double parted;  // metres, by how much the pair has been parted along the normal in this substep
        double rubbed;  // metres, by how much friction has held it back
        double most;    // metres, by how much it may be parted at most
        double pushed;  // m/s, by how much its speed of parting has been changed
        double braked;  // m/s, by how much friction has held its speed back
    };
    /// Of an island: its parts of the arrays.
    struct Range {
        Particle* particles;
        uint32_t count;
        Pair* pairs;
        uint32_t most_pairs;
        uint32_t *pair_count, *contact_count;
        Contact* contacts;
        uint32_t most_contacts;
        uint32_t* buckets;  // table_size + 1
        uint32_t table_size;
        uint32_t* sorted;
        uint64_t* keys;
    };
    struct Found {
        bool any, deep;  // contacts; many that overlap deeply
    };
    Range range(const Island& island);
    template <class Visit>
    void each_body(const Island& island, Vector<Body>& bodies, const uint32_t* slots, Visit&& visit);
    void gather(const Range& range, const Vector<Body>& bodies) const;
    bool list_holds(const Range& range) const;
    void find_pairs(const Range& range, const Vector<Body>& bodies) const;
    bool find_contacts(const Range& range, const Vector<Body>& bodies, double quiet, double h) const;
    Found part_contacts(const Island& island, const Vector<Body>& bodies, double quiet, double h);

    Vector<Particle> particles_;
    Vector<Pair> pairs_;
    Vector<Contact> contacts_;
    Vector<uint32_t> buckets_, sorted_, pair_counts_, contact_counts_;
    Vector<uint64_t> keys_;
};

/// Which particles of a body are linked directly, and where they are at rest; for bodies that collide with
/// themselves. Throws std::bad_alloc.
void list_linked(Body& body);

}  // namespace gphys
