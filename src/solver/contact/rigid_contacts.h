// Contacts of rigid clusters with other particles and with models, solved with the mass and the inertia of the whole
// cluster.
//
// Contacts of particles alone would move one particle of a crate, of which the shape keeps its share of the mass, and a
// stack of crates would sink into itself. So a free cluster is a rigid body here: contacts displace it, or change its
// velocity and spin, and all its particles follow.
//
// Projected Gauss-Seidel on the impulses goes from pair to pair of clusters. The contacts of one pair are solved at
// once, and share its masses (mass splitting; Tonge, Benevolenski & Voroshilov 2012): one after the other, the first
// would take the load, and crates would lean. Nonlinear conjugate gradients accelerate it (Silcowitz-Hansen, Niebe &
// Erleben 2010, "A nonsmooth nonlinear conjugate gradient method for interactive contact force problems"): loads and
// torques pass through a stack in a few iterations, where Gauss-Seidel needs as many as the square of its height.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/cloth/clusters.h"
#include "solver/contact/supports.h"

namespace gphys {

/// A free rigid cluster while contacts are solved.
struct ContactCluster {
    uint32_t first;  // particle of its body, in the island
    ClusterRange members;
    bool active;  // whether any of its particles is in a pair
    Vec3 centre;
    double inverse_mass;
    Mat3 inverse_inertia;
    Vec3 shift, turn;  // by contacts: displacement and rotation vector, or velocity and spin
};

/// One of the two that a contact pushes: a cluster, or a particle that moves alone.
struct ContactSide {
    ContactCluster* cluster = nullptr;
    Vec3 arm;                           // from its centre
    Vec3* value = nullptr;              // of a particle: its place or velocity,
    const Vec3* uncorrected = nullptr;  // this at the beginning,
    const Vec3* still = nullptr;        // and what it would be if the particle had not moved
    Supports* supports = nullptr;
    double inverse_mass = 0;
};

/// Impulses are newton seconds, or kilograms times metres while places are solved.
struct ContactRow {
    ContactSide a, b;  // a is neither for a model
    Vec3 normal;       // from a to b
    double gap;        // metres, or m/s, at the beginning
    Vec3 slip;         // of b relative to a, at the beginning; its part along the normal has no meaning
    double friction;
    // Where the result belongs, and what makes it one of a particle:
    double* separation = nullptr;
    Support* support = nullptr;
    double scale = 1;

    uint64_t group = 0;              // the same for rows between two clusters, or of a cluster with models
    uint32_t number = 0, count = 0;  // count: of the rows of the group, of its first
    bool carried = false;            // whether models carry any of the two, a particle
    // What a unit impulse along the normal moves b by, relative to a; of that along the normal; along the surface at
    // most. Particles that models carry are left out.
    Vec3 pushed;
    double inverse_mass = 0, inverse_mass_along = 0;
    double normal_impulse = 0;
    Vec3 friction_impulse;
    // What the last sweep has changed, and the direction of the search:
    double normal_change = 0, normal_way = 0;
    Vec3 friction_change, friction_way;
};

/// The rows of an island.
class RigidContacts {
public:
    RigidContacts(ContactRow* rows, uint32_t room) : rows_(rows), room_(room) {}

    /// Those for which there is no room are left out.
    void add(const ContactRow& row);
    /// Call when all are added.
    void arrange(const ContactCluster* clusters);
    bool empty() const { return count_ == 0; }
    /// At most so many iterations, until none changes a gap by more than `tolerance`.
    void solve(int most, double tolerance);
    /// Call when others have moved particles meanwhile.
    void restart() { square_before_ = 0; }
    /// Writes the impulses where they belong.
    void end() const;

private:
    double sweep();
    void accelerate();

    ContactRow* const rows_;
    const uint32_t room_;
    uint32_t count_ = 0;
    double square_ = 0, square_before_ = 0;  // of the last sweeps' changes
};

}  // namespace gphys
