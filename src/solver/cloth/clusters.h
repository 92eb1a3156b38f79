// Rigid clusters by shape matching: particles that keep the shape they had when the cluster was made (Mueller,
// Heidelberger, Teschner & Gross 2005, "Meshless deformations based on shape matching").
//
//   clusters.cpp         a substep
//   cluster_impacts.cpp  restitution
//   cluster_edits.cpp    adding, removing, listing
//   best_rotation.cpp    the rotation of a cluster
//
// The shape is moved to where it is nearest to the particles, by the sum of mass times squared distance, and the
// particles are put on it. That changes neither their momentum nor their angular momentum. Particles that do not move
// freely have infinite mass: with one the cluster turns about it, with two about the line through them, and with three
// it does not move.
//
// Contacts act on the cluster as a whole. Each has a normal impulse and a friction impulse at its particle, found by
// projected Gauss-Seidel.
#pragma once

#include "foundation/ids.h"
#include "foundation/math.h"
#include "foundation/memory.h"
#include "foundation/results.h"
#include "gamephys_c.h"

namespace gphys {

struct Body;
struct ClothState;
struct CollisionContext;

struct ClusterMember {
    Vec3 rest;  // in the shape, relative to the first member
    uint32_t particle;
    uint32_t cluster;  // slot
};

/// The contact of a particle while its cluster is solved. Impulses are relative masses times metres.
struct ClusterContact {
    uint32_t member;
    Vec3 arm;                       // from the point that the cluster turns about
    Vec3 normal;                    // of the contact plane
    double gap;                     // metres in front of it
    double inverse_effective_mass;  // along the normal
    Vec3 slip;                      // metres along the plane since the start of the substep
    double friction;                // coefficient
    double friction_before;         // friction impulse before the cluster was solved
    double normal_before;           // normal impulse before the cluster was solved
    double normal_impulse;          // accumulated
    Vec3 friction_impulse;          // accumulated
};

/// A cluster that is part of a system of joints: its pose, and how it moves if a force, and a torque about its centre,
/// act on it. What it is joined to resists, too. Relative inverse masses.
struct ClusterResponse {
    uint32_t cluster;  // slot
    Vec3 centre;       // relative to the cloth's origin
    Vec3 rest;         // the same point in the shape
    Mat3 rotation;
    Mat3 shift_by_force, shift_by_torque, turn_by_torque;  // of the centre; the first and the last are symmetric
    Vec3 impulse, angular_impulse;                         // of contacts, relative masses times metres
    uint32_t system, in_system;                            // of joints, and which of its clusters this is
};

/// Of a particle of a cluster with a model, in the substep under way.
struct ClusterImpact {
    uint32_t particle = 0;
    gphys_model_id model = 0;
    bool hits = false;      // whether it approaches fast enough to bounce
    Vec3 normal;            // of the model
    double target = 0;      // m/s along the normal: the velocity that it shall have at least
    Vec3 surface_velocity;  // m/s
    double friction = 0;    // coefficient
    Vec3 counted;           // m/s: change of its velocity whose impulse the model has got already
    // While the cluster is solved. Relative masses:
    Vec3 arm;                           // from the centre of mass to the point of contact
    double inverse_effective_mass = 0;  // along the normal
    double impulse = 0;                 // accumulated
    Vec3 friction_impulse;              // accumulated
};

struct Clusters {
    explicit Clusters(std::pmr::memory_resource* memory)
        : ids(memory), members(memory), first_member(memory), contacts(memory), impacts(memory), responses(memory) {}

    static constexpr uint32_t none = 0xffffffff;

    bool empty() const { return members.empty(); }
    /// Whether a particle is in any cluster. Call in a step.
    bool has(uint32_t particle) const { return !empty() && first_member[particle] != none; }

    IdTable ids;
    bool changed = false;           // since joints were planned
    Vector<ClusterMember> members;  // cluster by cluster, in the order of slots; of each as they were given
    // Of the step under way:
    bool overlap = false;               // whether any particle is in several
    Vector<uint32_t> first_member;      // by particle: the index of the first member of its first cluster, or none
    Vector<ClusterContact> contacts;    // of the cluster being solved; capacity for the largest
    Vector<ClusterImpact> impacts;      // of all; capacity for two of each member
    Vector<ClusterResponse> responses;  // of those that joint systems move, by slot; capacity for all
};

/// Allocates what a step needs of clusters. Throws std::bad_alloc.
void reserve_clusters(Clusters& clusters, uint32_t particles);
/// For cloth during a substep: puts the particles on their shapes, and on the right side of their contact planes.
/// `pulls_count`: whether pulls are added up.
void solve_clusters(Body& body, bool pulls_count);
/// The same, without contacts and pulls.
void project_clusters(const Clusters& clusters, ClothState& state);
/// For clusters of which models have pushed out particles, one by one: moves them as wholes instead, in front of their
/// contact planes. Velocities stay. Not those of joined bodies.
void push_out_clusters(Body& body);

// cluster_impacts.cpp
/// Whether the impacts of a particle are those of its cluster. Not where that shares particles, is held or is joined.
bool bounces_as_whole(const Body& body, uint32_t particle);
/// Call at the end of a substep: gives clusters the velocities after their impacts.
void bounce_clusters(Body& body, const CollisionContext& around, double h);

// cluster_edits.cpp. Values have been checked. A function that fails, by status or std::bad_alloc, changes nothing;
// else it wakes the body.
gphys_status add_cluster(Body& body, const uint32_t* particles, uint32_t count, gphys_cluster_id& out);
/// GPHYS_OK, or the failure that names a stale id.
gphys_status check_cluster(const Clusters& clusters, gphys_cluster_id id);
gphys_status remove_cluster(Body& body, gphys_cluster_id id);
void list_clusters(const Clusters& clusters, Smallest<gphys_cluster_id>& out);

/// The members of a cluster.
struct ClusterRange {
    const ClusterMember *first, *last;

    const ClusterMember* begin() const { return first; }
    const ClusterMember* end() const { return last; }
    uint32_t size() const { return static_cast<uint32_t>(last - first); }
};
/// Of that with this slot; and, in a step, of the first that a particle is in.
ClusterRange members_of(const Clusters& clusters, uint32_t slot);
ClusterRange cluster_with(const Clusters& clusters, uint32_t particle);
/// Null if it has none.
ClusterResponse* response_of(Clusters& clusters, uint32_t cluster);
/// Calls visit(members) for each cluster.
template <class Visit>
void each_cluster(const Clusters& clusters, Visit&& visit) {
    const ClusterMember *first = clusters.members.data(), *const end = first + clusters.members.size();
    while (first != end) {
        const uint32_t cluster = first->cluster;
        const ClusterMember* last = first;
        while (last != end && last->cluster == cluster) ++last;
        visit(ClusterRange{first, last});
        first = last;
    }
}

}  // namespace gphys
