// Contacts of rigid clusters with other particles and with models, solved with the mass and the inertia of the whole
// cluster.
//
// Contacts of particles alone would move one particle of a crate, of which the shape keeps its share of the mass, and a
// stack of crates would sink into itself. So a cluster is a rigid body here: contacts displace it, or change its
// velocity and spin, and all its particles follow. One with particles that do not move freely turns about these.
//
// Projected Gauss-Seidel on the impulses goes from pair to pair of clusters. The contacts of one pair are solved at
// once, and share its masses (mass splitting; Tonge, Benevolenski & Voroshilov 2012): one after the other, the first
// would take the load, and crates would lean. So a pair needs the relative motion of its clusters once for all its
// contacts, and pushes them with the sum of their impulses. Nonlinear conjugate gradients accelerate it
// (Silcowitz-Hansen, Niebe & Erleben 2010, "A nonsmooth nonlinear conjugate gradient method for interactive contact
// force problems"): loads and torques pass through a stack in a few iterations, where Gauss-Seidel needs as many as the
// square of its height.
//
// An impulse on a joined cluster moves all clusters of its system of joints, and each pair starts from where the
// impulses so far have moved both (JointSystem::displacement). If each cluster counted its own impulses alone, all
// limbs of a ragdoll would together stop its sliding several times over, and it would tremble where it lies.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/cloth/clusters.h"
#include "solver/contact/supports.h"
#include "solver/joints/joints.h"

namespace gphys {

/// A rigid cluster while contacts are solved.
struct ContactCluster {
    uint32_t first;  // particle of its body, in the island
    ClusterRange members;
    bool active;  // whether any of its particles is in a pair
    bool held;    // whether any does not move freely; then `centre` is the pivot (cluster_pivot.h)
    Vec3 centre;
    double inverse_mass;
    Mat3 inverse_inertia;
    double size;                          // metres: root mean square distance of its particles from the centre
    Vec3 turned;                          // rotation vector in the substep before contacts, or spin
    Vec3 impulse, moment;                 // of contacts, about the centre, if it is held
    Vec3 shift, turn;                     // by contacts: displacement and rotation vector, or velocity and spin
    ClusterResponse* response = nullptr;  // of a joined one, in place of inverse mass and inertia
    JointSystem* system = nullptr;        // then: that moves with it; null if that is too large
    double mass_unit = 1;                 // kg, of the response

    /// The displacement of a place on it by an impulse there, or by an impulse and its moment.
    Vec3 displacement(Vec3 arm, Vec3 impulse) const {
        Vec3 by_shift, by_turn;
        displace(impulse, cross(arm, impulse), by_shift, by_turn);
        return by_shift + cross(by_turn, arm);
    }
    void displace(Vec3 impulse, Vec3 moment, Vec3& by_shift, Vec3& by_turn) const {
        const Vec3 j = impulse / mass_unit, m = moment / mass_unit;
        by_shift += response->shift_by_force * j + response->shift_by_torque * m;
        by_turn += transpose_times(response->shift_by_torque, j) + response->turn_by_torque * m;
    }
};

/// One of the two that touch: a cluster, a particle that moves alone, or neither, for models.
struct ContactPartner {
    ContactCluster* cluster = nullptr;
    Vec3* value = nullptr;              // of a particle: its place or velocity,
    const Vec3* uncorrected = nullptr;  // this at the beginning,
    const Vec3* still = nullptr;        // and what it would be if the particle had not moved
    Supports* supports = nullptr;       // null if no model carries it
    double inverse_mass = 0;
};

/// Impulses on b, their sum, and their moments about the centres of a and b. Those on a are the opposite.
struct ContactImpulse {
    Vec3 impulse, about_a, about_b;
};

/// The contacts of two, which are solved at once.
struct ContactGroup {
    ContactPartner a, b;
    uint32_t first, count;
    double among;                // of so many rows each has its share of the masses; 0: not known yet
    ContactImpulse change, way;  // the sums of those of the rows
};

/// Impulses are newton seconds, or kilograms times metres while places are solved.
struct ContactRow {
    Vec3 arm_a, arm_b;  // from the centre of each to the contact
    Vec3 normal;        // from a to b
    double gap;         // metres, or m/s, at the beginning
    Vec3 slip;          // of b relative to a, at the beginning; its part along the normal has no meaning
    double friction;
    // Where the result belongs, and what makes it one of a particle:
    double* separation = nullptr;
    Support* support = nullptr;
    double scale = 1;

    // What a unit impulse moves b by relative to a: one along the normal, and one along the surface at most. A particle
    // that models carry is left out.
    double inverse_mass = 0, inverse_mass_along = 0;
    // Of what the joints of both do not let apart: as inverse_mass, times the impulse a part of the gap that stays.
    double softness = 0;
    double normal_impulse = 0;
    Vec3 friction_impulse;
    // What the last sweep has changed, and the direction of the search:
    double normal_change = 0, normal_way = 0;
    Vec3 friction_change, friction_way;
};

/// The rows of an island.
class RigidContacts {
public:
    struct Room {
        ContactRow* rows;
        uint32_t row_count;
        ContactGroup* groups;
        uint32_t group_count;
    };

    explicit RigidContacts(const Room& room) : room_(room), rows_(room.rows), groups_(room.groups) {}

    /// Rows that are added now are between these. Groups and rows for which there is no room are left out.
    void begin_group(const ContactPartner& a, const ContactPartner& b);
    void add(const ContactRow& row);
    /// At most so many iterations, until none changes a gap by more than `tolerance`.
    void solve(int most, double tolerance);
    /// Call when others have moved particles meanwhile.
    void restart() { square_before_ = 0; }
    /// Writes the impulses where they belong.
    void end() const;

private:
    double sweep();
    void accelerate();

    const Room room_;
    ContactRow* const rows_;
    ContactGroup* const groups_;
    uint32_t count_ = 0, group_count_ = 0;
    bool is_full_ = false;                   // whether there is no room for the group of the next rows
    double square_ = 0, square_before_ = 0;  // of the last sweeps' changes
};

}  // namespace gphys
