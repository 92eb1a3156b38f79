// Contacts between particles, of one body or of several; off by default.
//
// Candidate pairs come from a list (Verlet 1967): pairs closer than their radii plus a margin for each, found by
// spatial hashing (Teschner et al. 2003). The list holds until a particle has moved farther than its margin. The faster
// a particle is, the larger its margin in the next list. After each substep, the pairs whose paths came into contact
// become contacts, with the normal at the time of impact, so that none passes through another at any speed.
// Gauss-Seidel sweeps over the contacts correct positions, with friction. The velocities follow from the positions;
// further sweeps apply restitution to them. The models that a particle touches take part in the sweeps
// (supports.h).
//
// The pairs of a large island are in groups, by the cell of a coarse grid that one of their particles is in. A cell has
// one of eight colours, by the parity of its coordinates, and two cells of one colour are so far apart that no particle
// is in pairs of both (graph colouring of a grid). So the groups of a colour are solved side by side by a team. Groups
// depend on positions only, and results do not depend on the number of workers.
//
// Where many pairs overlap deeply, such as particles at one point, each particle takes a bounded number of pairs, and
// the correction changes positions only. So a pile spreads at low speed.
//
// The arrays are enlarged before the step, never during it. Each island has its own ranges of them.
#pragma once

#include <numeric>

#include "foundation/math.h"
#include "foundation/team.h"
#include "solver/body_table.h"
#include "solver/contact/body_contacts.h"
#include "solver/contact/rigid_contacts.h"
#include "solver/contact/supports.h"
#include "solver/islands.h"

namespace gphys {

inline bool collides_with_others(const Body& body) {
    return body.settings.self_collision || body.settings.body_layers != 0;
}
inline bool moves_freely(const Body& body) { return body.plan.method == GPHYS_SOLVE_FREE && !body.plan.joined; }
/// Of a particle, during a step.
Vec3 place_of(const Body& body, uint32_t p);

struct Joined;

class ParticleContacts {
public:
    explicit ParticleContacts(std::pmr::memory_resource* memory)
        : particles_(memory),
          pairs_(memory),
          contacts_(memory),
          buckets_(memory),
          sorted_(memory),
          keys_(memory),
          supports_(memory),
          order_(memory),
          groups_(memory),
          clusters_(memory),
          rigid_pairs_(memory),
          rigid_groups_(memory),
          rows_(memory),
          listed_(memory) {}

    /// Call before a step, for all islands. Sets their ranges. Throws std::bad_alloc.
    void reserve(const BodyTable& bodies, Vector<Island>& islands, const Vector<uint32_t>& island_bodies);
    /// Call when nothing can fail any more, and after the step.
    void begin_step(const IdTable& ids, const BodyTable& bodies, const Vector<Island>& islands) noexcept;
    void end_step(const Vector<Island>& islands) { listed_.end_step(islands); }

    /// Whether a team can share the work on the contacts of so many particles.
    static bool has_groups(uint32_t particles) { return group_count(particles) > 1; }

    /// Contacts between different bodies in the last step.
    const BodyContacts& listed() const { return listed_; }
    /// Call when the state is replaced.
    void clear_list() { listed_.clear(); }

    // For one island; the data of others are not accessed.
    void begin(const Island& island, const IdTable& ids, const BodyTable& bodies, const uint32_t* slots);
    /// Call when all bodies are predicted: separates pairs in contact, with friction. h: seconds of the substep.
    /// `planes` have what free particles have found around them, one for each member of the team of the island; null if
    /// there are no models.
    /// `joined`: those of the bodies that are. Contacts of their clusters are left to the systems of joints, as
    /// impulses in Clusters::responses.
    void solve_positions(const Island& island, BodyTable& bodies, const uint32_t* slots, const Joined& joined,
                         const CollisionContext& around, Vec3 gravity, double h, FlightPlanes* planes);
    /// Call when the links are solved: moves what presses on ropes and is heavy (rope_loads.h).
    void move_loads_of_ropes(const Island& island, BodyTable& bodies, const uint32_t* slots,
                             const CollisionContext& around, Vec3 gravity, double h, FlightPlanes* planes);
    /// The same of cloth (cloth/contact_loads.h).
    void move_loads(const Island& island, BodyTable& bodies, const uint32_t* slots, const Joined& joined,
                    const CollisionContext& around, Vec3 gravity, double h, FlightPlanes* planes);
    /// Call at the end of the substep: restitution and friction of pairs in contact.
    void solve_velocities(const Island& island, BodyTable& bodies, const uint32_t* slots, const Joined& joined,
                          const CollisionContext& around, Vec3 gravity, double h);
    /// Call after the last substep, that of `around`: separates pairs that constraints have made overlap.
    void solve_final_positions(const Island& island, BodyTable& bodies, const uint32_t* slots,
                               const CollisionContext& around, Vec3 gravity, double h);

private:
    /// The first cache line is what most corrections of positions need, the second what the others need.
    struct alignas(64) Particle {
        Vec3 at, before;  // before: at the beginning of the substep
        double inverse_mass;
        Supports* supports;                                // null if it has touched no model in this step
        Vec3 velocity, uncorrected, uncorrected_velocity;  // uncorrected: at the end of the substep, without contacts
        double radius, margin;
        Vec3 list_position;  // position at which the list was made
        uint32_t body, number;
        gphys_body_id id;
        ContactCluster* cluster;  // that it is a member of and that contacts move as a whole, or null
        bool paired;              // whether it is in any pair of the list
        bool on_other;            // of ropes: whether it touches one of another rope
        // Of the first one of a load: in how many contacts it presses on ropes, and on cloth.
        uint32_t rope_shares, cloth_shares;

        double reach() const { return radius + margin; }
    };
    /// A particle in the order of the cells of the grid.
    struct Near {
        Vec3 at;
        double reach;
        uint64_t key;  // of its cell
        uint32_t particle;
    };
    struct Pair {
        uint32_t a, b;
        uint32_t listed = IslandContacts::none;  // its index in the list
    };
    struct Contact {
        uint32_t a, b;
        bool both_free;               // whether both are of bodies without links
        bool rigid;                   // whether it is solved together with others (ClusterContacts)
        Vec3 normal;                  // unit, from a to b
        double radii;                 // the distance at which they touch: their sum, or less if they overlap
        double overlap;               // metres: how much of that this substep removes
        double part_of_a, part_of_b;  // of a correction, by their inverse masses
        double friction;
        double target_speed;           // m/s: separating speed by restitution
        double separation;             // metres: accumulated correction along the normal in this substep
        double more_separation;        // metres: accumulated correction that models have made necessary besides
        double friction_displacement;  // metres: accumulated correction along the tangent
        double most_separation;        // metres
        double normal_change;          // m/s: accumulated change of the relative velocity along the normal
        double more_change;            // m/s: what models have made necessary besides
        double friction_change;        // m/s: the same along the tangent

        // What the impulse between the particles would have done without models.
        double all_separation() const { return separation + more_separation; }
        double all_change() const { return normal_change + more_change; }
    };
    /// A contact of a free cluster, in a list that has an end.
    struct RigidPair {
        uint64_t clusters;  // that are in contact
        uint32_t contact;

        static constexpr uint64_t end = ~uint64_t{0};
        bool operator<(const RigidPair& other) const {
            return clusters != other.clusters ? clusters < other.clusters : contact < other.contact;
        }
    };
    /// Items of a group, in the array of the island.
    struct Items {
        uint32_t begin, count;
    };
    /// Pairs that are found by some particles, and their contacts.
    struct Group {
        uint32_t first, size;  // of the particles, in `order`
        Items pairs, contacts;
        uint32_t deep;     // pairs, or contacts, that overlap deeply
        bool overlapping;  // whether any contact has an overlap
        bool sinking;      // whether one of two free particles has
    };
    /// The ranges of an island in the arrays.
    struct Range {
        Particle* particles;
        uint32_t count;
        Pair* pairs;
        Contact* contacts;
        uint32_t* buckets;  // table_size + 1
        uint32_t table_size;
        Near* sorted;
        uint64_t* keys;
        Supports* supports;  // by particle
        uint32_t* order;     // of the particles, by group
        Group* groups;
        uint32_t group_count;  // colour by colour, as many of each
        Team* team;            // of all workers, or null
        IslandContacts listed;
        ContactCluster* clusters;
        uint32_t cluster_count;
        RigidPair* rigid_pairs;
        uint32_t rigid_pair_count;  // room for them and for the end
        RigidContacts::Room rigid_rows;
        bool unequal;  // see Island
        const JointSurroundings* beside_joints;

        uint32_t most_pairs() const { return count * pairs_per_particle; }
    };
    struct Found {
        bool any, overlapping;  // whether there are contacts, and any with an overlap
        bool deep;              // whether many pairs overlap deeply
    };
    class PairSearch;
    class ClusterContacts;

    // Capacity of the list and of the contacts, for each particle. In the densest packing of equal spheres each touches
    // 12 others and has 18 within 1.4 diameters; a pair counts once. Contacts beyond the capacity are dropped, those of
    // the highest indices in their group first.
    static constexpr uint32_t pairs_per_particle = 12;
    static constexpr uint32_t contacts_per_particle = 6;
    // Groups of an island of at least `least_grouped` particles. In a smaller one, synchronisation takes most of the
    // gain.
    static constexpr uint32_t colours = 8, groups_per_colour = 64, least_grouped = 2048;

    static uint32_t group_count(uint32_t particles) {
        return particles < least_grouped ? 1 : colours * groups_per_colour;
    }
    Range range(const Island& island);
    template <class Visit>
    void each_body(const Island& island, BodyTable& bodies, const uint32_t* slots, Visit&& visit);
    template <class Visit>
    static void share_particles(const Range& range, Visit&& visit);
    template <class Emit>
    static bool fill_groups(const Range& range, Items Group::*items, uint32_t per_particle, Emit&& emit);
    template <class Solve>
    static void sweep(const Range& range, int times, Solve&& solve);
    void gather(const Range& range, const BodyTable& bodies, double h) const;
    void find_supports(const Range& range, const BodyTable& bodies, const CollisionContext& around) const;
    bool list_is_valid(const Range& range) const;
    void find_pairs(const Range& range, const BodyTable& bodies) const;
    /// `final`: corrections give no speed at all.
    bool find_contacts(const Range& range, const BodyTable& bodies, bool final, Vec3 gravity, double h) const;
    template <class Visit>
    static bool any_contact(const Range& range, Visit&& visit);
    /// unequal_balls.cpp
    static bool has_unequal_balls(const BodyTable& bodies, const uint32_t* first, const uint32_t* end);
    static bool couple_unequal(const Range& range);
    static void uncouple_unequal(const Range& range);
    static bool have_thrown(const Range& range, Vec3 Particle::*value, Vec3 Particle::*uncorrected,
                            Vec3 Particle::*before);
    void solve_coupled_positions(const Range& range, const BodyTable& bodies, const Joined* joined,
                                 const CollisionContext& around, int times, Vec3 gravity, double h);
    template <class Visit>
    static void each_between_bodies(const Range& range, Visit&& visit);
    static void add_to_list(const Range& range, Pair& pair, Vec3 normal, double impulse);
    class HeavyBodies;
    class ClothLoads;
    class RopeLoads;
    void add_impulses(const Range& range, double (Contact::*change)() const, double rate) const;
    void add_support_impulses(const Island& island, BodyTable& bodies, const uint32_t* slots,
                              const CollisionContext& around, double rate);
    void separate_overlapping(const Island& island, BodyTable& bodies, const uint32_t* slots,
                              const CollisionContext& around, double bounce_threshold, FlightPlanes* planes);
    /// `joined`: null at the end of a step.
    Found solve_contacts(const Island& island, const BodyTable& bodies, const Joined* joined,
                         const CollisionContext& around, Vec3 gravity, double h);

    Vector<Particle> particles_;
    Vector<Pair> pairs_;
    Vector<Contact> contacts_;
    Vector<uint32_t> buckets_;
    Vector<Near> sorted_;
    Vector<uint64_t> keys_;
    Vector<Supports> supports_;
    Vector<uint32_t> order_;
    Vector<Group> groups_;
    Vector<ContactCluster> clusters_;
    Vector<RigidPair> rigid_pairs_;
    Vector<ContactGroup> rigid_groups_;
    Vector<ContactRow> rows_;
    BodyContacts listed_;
};

/// Calls visit(first, end) for ranges of particles, on all members of the team.
template <class Visit>
void ParticleContacts::share_particles(const Range& range, Visit&& visit) {
    constexpr uint32_t together = 512;
    share(range.team, (range.count + together - 1) / together,
          [&](uint32_t i, uint32_t) { visit(i * together, std::min(range.count, (i + 1) * together)); });
}

/// Calls visit(body, first, end) for the bodies of an island that collide with others, and their particles.
template <class Visit>
void ParticleContacts::each_body(const Island& island, BodyTable& bodies, const uint32_t* slots, Visit&& visit) {
    Particle* first = range(island).particles;
    for (uint32_t i = 0; i < island.body_count; ++i) {
        Body& body = bodies[slots[i]];
        if (!collides_with_others(body)) continue;
        visit(body, first, first + body.particles.size());
        first += body.particles.size();
    }
}

/// Calls visit(contact) for all until it returns true; returns whether it has.
template <class Visit>
bool ParticleContacts::any_contact(const Range& range, Visit&& visit) {
    return std::any_of(range.groups, range.groups + range.group_count, [&](const Group& group) {
        Contact* const first = range.contacts + group.contacts.begin;
        return std::any_of(first, first + group.contacts.count, visit);
    });
}

/// Calls visit(pair, contact) for the contacts between different bodies.
template <class Visit>
void ParticleContacts::each_between_bodies(const Range& range, Visit&& visit) {
    for (const Group* group = range.groups; group != range.groups + range.group_count; ++group) {
        Pair* pair = range.pairs + group->pairs.begin;
        for (uint32_t i = 0; i < group->contacts.count; ++i) {
            const Contact& contact = range.contacts[group->contacts.begin + i];
            // Contacts are in the order of the pairs.
            while (pair->a != contact.a || pair->b != contact.b) ++pair;
            if (range.particles[contact.a].body != range.particles[contact.b].body) visit(*pair, contact);
        }
    }
}

/// Fills the items of all groups. emit(group, first item, room for items) returns how many there are, of which it has
/// written as many as there is room for. Returns whether there was room for all.
template <class Emit>
bool ParticleContacts::fill_groups(const Range& range, Items Group::*items, uint32_t per_particle, Emit&& emit) {
    const auto room = [&](const Group& group) { return per_particle * group.size; };
    share(range.team, range.group_count, [&](uint32_t i, uint32_t) {
        Group& group = range.groups[i];
        const uint32_t begin = per_particle * group.first;
        group.*items = {begin, group.size == 0 ? 0 : emit(group, begin, room(group))};
    });
    Group *const first = range.groups, *const end = first + range.group_count;
    if (std::all_of(first, end, [&](const Group& group) { return (group.*items).count <= room(group); })) return true;
    const uint64_t all = std::accumulate(first, end, uint64_t{0},
                                         [&](uint64_t sum, const Group& group) { return sum + (group.*items).count; });
    if (all > uint64_t{per_particle} * range.count) {
        for (Group* group = first; group != end; ++group)
            (group->*items).count = std::min((group->*items).count, room(*group));
        return false;
    }
    // Groups with many get the room of those with few.
    uint32_t next = 0;
    for (Group* group = first; group != end; ++group) {
        (group->*items).begin = next;
        next += (group->*items).count;
    }
    share(range.team, range.group_count, [&](uint32_t i, uint32_t) {
        Group& group = range.groups[i];
        const Items kept = group.*items;
        if (group.size > 0) emit(group, kept.begin, kept.count);
    });
    return true;
}

/// So many Gauss-Seidel sweeps: solve(contact, its particles), colour after colour. A processor overlaps the work on
/// the contacts of two groups, while those of one group mostly wait for each other.
template <class Solve>
void ParticleContacts::sweep(const Range& range, int times, Solve&& solve) {
    const uint32_t in_colour = std::min(range.group_count, groups_per_colour), together = std::min(in_colour, 2u);
    const auto solve_one = [&](uint32_t i) {
        Contact& contact = range.contacts[i];
        solve(contact, range.particles[contact.a], range.particles[contact.b]);
    };
    for (int sweep = 0; sweep < times; ++sweep) {
        for (uint32_t first = 0; first < range.group_count; first += in_colour) {
            share(range.team, in_colour / together, [&](uint32_t k, uint32_t) {
                const Group* const group = &range.groups[first + together * k];
                const Items one = group->contacts, other = together > 1 ? group[1].contacts : Items{};
                const uint32_t both = std::min(one.count, other.count);
                for (uint32_t i = 0; i < both; ++i) {
                    solve_one(one.begin + i);
                    solve_one(other.begin + i);
                }
                for (uint32_t i = both; i < one.count; ++i) solve_one(one.begin + i);
                for (uint32_t i = both; i < other.count; ++i) solve_one(other.begin + i);
            });
        }
    }
}

/// Finds which particles of a body are linked directly, and where they are at rest; for bodies that collide with
/// themselves. Throws std::bad_alloc.
void list_linked(Body& body);

}  // namespace gphys
