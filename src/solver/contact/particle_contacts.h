// Contacts between particles, of one body or of several; off by default.
//
// Candidate pairs come from a list (Verlet 1967): pairs closer than their radii plus a margin for each, found by
// spatial hashing (Teschner et al. 2003). The list holds until a particle has moved farther than its margin. The faster
// a particle is, the larger its margin in the next list. After each substep, the pairs whose paths came into contact
// become contacts, with the normal at the time of impact, so that none passes through another at any speed.
// Gauss-Seidel sweeps over the contacts correct positions, with friction. The velocities follow from the positions;
// further sweeps apply restitution to them.
//
// Where many pairs overlap deeply, such as particles at one point, each particle takes a bounded number of pairs, and
// the correction changes positions only. So a pile spreads at low speed.
//
// The arrays are enlarged before the step, never during it. Each island has its own ranges of them.
#pragma once

#include "foundation/math.h"
#include "solver/body.h"
#include "solver/contact/body_contacts.h"
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
          keys_(memory),
          listed_(memory) {}

    /// Call before a step, for all islands. Sets their ranges. Throws std::bad_alloc.
    void reserve(const Vector<Body>& bodies, Vector<Island>& islands, const Vector<uint32_t>& island_bodies);
    /// Call when nothing can fail any more, and after the step.
    void begin_step(const IdTable& ids, const Vector<Body>& bodies, const Vector<Island>& islands) noexcept;
    void end_step(const Vector<Island>& islands) { listed_.end_step(islands); }

    /// Contacts between different bodies in the last step.
    const BodyContacts& listed() const { return listed_; }
    /// Call when the state is replaced.
    void clear_list() { listed_.clear(); }

    // For one island; the data of others are not accessed.
    void begin(const Island& island, const IdTable& ids, const Vector<Body>& bodies, const uint32_t* slots);
    /// Call when all bodies are predicted: separates pairs in contact, with friction. h: seconds of the substep.
    void solve_positions(const Island& island, Vector<Body>& bodies, const uint32_t* slots,
                         const CollisionContext& around, Vec3 gravity, double h);
    /// Call at the end of the substep: restitution and friction of pairs in contact.
    void solve_velocities(const Island& island, Vector<Body>& bodies, const uint32_t* slots);
    /// Call after the last substep: separates pairs that constraints have made overlap.
    void solve_final_positions(const Island& island, Vector<Body>& bodies, const uint32_t* slots,
                               const CollisionContext& around, Vec3 gravity, double h);

private:
    struct Particle {
        uint32_t body, number;
        gphys_body_id id;
        double radius, inverse_mass, margin;
        Vec3 list_position;        // position at which the list was made
        Vec3 before, uncorrected;  // at the beginning of the substep, and at its end without contacts
        Vec3 at, velocity;
        Vec3 uncorrected_velocity;
        const ContactPoint* contact_points;  // contact_points_per_particle of this step, or null

        double reach() const { return radius + margin; }
    };
    struct Pair {
        uint32_t a, b;
        uint32_t listed = IslandContacts::none;  // its index in the list
    };
    struct Contact {
        uint32_t a, b;
        Vec3 normal;  // unit, from a to b
        double friction;
        double target_speed;           // m/s: separating speed by restitution
        double separation;             // metres: accumulated correction along the normal in this substep
        double friction_displacement;  // metres: accumulated correction along the tangent
        double most_separation;        // metres
        double normal_change;          // m/s: accumulated change of the relative velocity along the normal
        double friction_change;        // m/s: the same along the tangent
    };
    /// The ranges of an island in the arrays.
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
        IslandContacts listed;
    };
    struct Found {
        bool any, deep;  // whether there are contacts; whether many pairs overlap deeply
    };
    Range range(const Island& island);
    template <class Visit>
    void each_body(const Island& island, Vector<Body>& bodies, const uint32_t* slots, Visit&& visit);
    void gather(const Range& range, const Vector<Body>& bodies) const;
    bool list_is_valid(const Range& range) const;
    void find_pairs(const Range& range, const Vector<Body>& bodies) const;
    bool find_contacts(const Range& range, const Vector<Body>& bodies, double bounce_threshold, double h) const;
    void add_impulses(const Range& range, double Contact::*change, double rate) const;
    Found solve_contacts(const Island& island, const Vector<Body>& bodies, double bounce_threshold, double h);

    Vector<Particle> particles_;
    Vector<Pair> pairs_;
    Vector<Contact> contacts_;
    Vector<uint32_t> buckets_, sorted_, pair_counts_, contact_counts_;
    Vector<uint64_t> keys_;
    BodyContacts listed_;
};

/// Finds which particles of a body are linked directly, and where they are at rest; for bodies that collide with
/// themselves. Throws std::bad_alloc.
void list_linked(Body& body);

}  // namespace gphys
