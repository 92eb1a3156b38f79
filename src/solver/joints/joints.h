// Joints between bodies, and the systems of equations that they form.
//
// Joined ropes and particles are one system: Newton's method on all their positions and tensions together, with the
// equations of rope_direct.cpp, but a sparse elimination (sparse_ldl.h) instead of one along a chain. A joint with a
// length is one more link, a joint without one is three links along the axes. A body whose chains branch is a system
// without joints.
//
// Cloth is not part of a system; only its joined particles are. The coupling is by effective mass. The system computes
// the response of such a particle to a force, a matrix, which replaces its inverse mass in the chains of the cloth. The
// forces of the chains then act on the system. So a weight on a rope loads a corner of cloth with its whole mass along
// the rope and with almost none across it. Momentum between cloth and rope is conserved to the last bit of float32.
//
// A rigid cluster of which a particle is joined is part of the system as a rigid body (joined_clusters.cpp).
#pragma once

#include "foundation/math.h"
#include "solver/cloth/clusters.h"
#include "solver/joints/sparse_ldl.h"
#include "solver/rope/bending.h"

namespace gphys {

class BodyTable;
struct CollisionContext;

/// |position of b - position of a| = rest + compliance * tension. The ends are in different bodies.
struct Joint {
    uint32_t body_a, particle_a, body_b, particle_b;  // bodies by slot
    double rest, compliance;                          // m, m/N
    Vec3 tension;                                     // newtons, of the last substep; all in x if rest > 0
};

/// A system of equations: the particles (nodes) and links of a set of bodies that are joined.
class JointSystem {
public:
    explicit JointSystem(std::pmr::memory_resource* source) : memory_(source) {}

    /// A particle of the system. Nodes are stored in the order of elimination.
    struct Node {
        uint32_t body, particle;  // particle: or `of_pose`
        uint32_t scalar = 0;      // index of the first of its three unknowns
        bool of_graph = false;    // whether it belongs to cloth
        bool free = true;
        double share = 1;   // part of its mass that is not in the pose of a cluster
        double weight = 0;  // N/m, share of the mass / step^2: the force that moves it by a metre
        bool loaded = false;
        Mat3 load{{}, {}, {}};  // if loaded: of the rotation of a cluster, its inertia / step^2; symmetric
        Vec3 before{};          // before the substep
        Vec3 predicted{};       // without constraints
        Vec3 start{};           // the initial guess of the solution under way
        Vec3 position{};        // the present iterate
    };
    /// A constraint between two nodes: a link of a chain, a joint with a length, or one axis of a joint without one.
    struct Link {
        uint32_t a, b;                // nodes
        uint32_t owner, index;        // slot of the body and link in its plan; or `of_joint` and the slot of the joint
        int axis = along;             // or an axis, for a joint of zero length
        uint32_t scalar = 0;          // index of its tension among the unknowns
        uint32_t coupling_index = 0;  // among the links from the later end to earlier nodes
        bool after_earlier =
            false;                 // whether its tension is eliminated right after the earlier end, not the later one;
        uint32_t tension_row = 0;  // then its entry in the columns of the later end
        double rest = 0, compliance = 0, tension = 0;  // m, m/N, N
        bool limit = false;                            // whether it only pulls

        uint32_t earlier() const { return std::min(a, b); }
        uint32_t later() const { return std::max(a, b); }
    };
    /// A node between two others of a chain that resists bending.
    struct NodeBend {
        uint32_t nodes[3];         // along the chain
        uint32_t body, index;      // slot of the body, and the bend in it
        uint32_t entries[3] = {};  // of nodes 0 and 1, 1 and 2, 0 and 2: place in the columns of the later one
        Bend bend = {};            // of the substep under way
        bool keeps_shape = false;  // see Bending

        /// By node: the factors of their places in the strain.
        void factors(double (&out)[3]) const {
            out[0] = bend.before, out[1] = -(bend.before + bend.after), out[2] = bend.after;
        }
    };
    /// A rigid cluster of which particles are joined. Its pivot and its rotation are nodes without particles.
    /// Each of its particles that is joined has half of its mass as a node, so that no node is without mass.
    struct JoinedCluster {
        uint32_t body, cluster;         // slots
        uint32_t first_member, count;   // in predicted_ and shares_
        uint32_t first_tie, tie_count;  // in ties_
        uint32_t centre = 0, turn = 0;  // nodes; the position of `turn` is the Gibbs vector, times 2, of the rotation
                                        // since the prediction, and its load is the inertia
        uint32_t first_way = 0, way_count = 0;  // in way_rows_
        bool free = false;                      // whether the system moves it in this substep
        Vec3 rest = {};                         // of the pivot, in the shape
        Mat3 predicted = {}, rotation = {};
        double size = 0;    // metres: root mean square distance of the members from the pivot
        double extent = 0;  // metres: largest distance of a member from the first one
        double scale = 0;   // 1 / s^2, times the mass unit: a relative mass becomes a weight
    };
    /// The contact of a member while the contacts of the system are solved. Impulses are relative masses times metres.
    struct MemberContact {
        uint32_t cluster;    // index in clusters_
        uint32_t candidate;  // in ClothContacts
        int32_t plane;
        Vec3 arm;  // from the centre
        Vec3 normal;
        double gap;             // metres in front of the plane
        double inverse_mass;    // along the normal
        double impulse_before;  // along the normal, of this substep
        double impulse;         // accumulated
        Vec3 slip;              // metres along the plane since the start of the substep
        double friction;        // coefficient
        double friction_room;   // what friction may add to `friction` times the impulse accumulated here
        Vec3 friction_impulse;  // accumulated
    };
    /// position of the node = centre + rotation * rest
    struct ClusterTie {
        uint32_t node, cluster;                           // cluster: index in clusters_
        uint32_t member;                                  // of the cluster
        uint32_t scalar = 0;                              // of the force along x; eliminated right after the node
        bool before_centre = false, before_turn = false;  // whether the node is eliminated before these
        uint32_t centre_entry = 0, turn_entry = 0;        // if it is, places in their columns
        Vec3 rest = {}, arm = {};                         // from the centre, in the shape and in space
        Vec3 force = {};                                  // N, of the particle on the cluster
    };
    static constexpr int along = -1;
    static constexpr uint32_t of_joint = 0xffffffff, of_pose = 0xffffffff;

    // To build a system: add all nodes, by body and particle, then the links and bends between them, and the clusters,
    // then call plan().
    void add_node(uint32_t body, uint32_t particle, bool of_graph) { nodes_.push_back({body, particle, 0, of_graph}); }
    uint32_t find_node(uint32_t body, uint32_t particle) const;
    void add_link(const Link& link) { links_.push_back(link); }
    void add_bend(const NodeBend& bend) { bends_.push_back(bend); }
    /// `members`: of a cluster that shares no particle with another one, some of which are nodes.
    void add_cluster(uint32_t body, ClusterRange members);
    /// Orders the nodes and computes the fill of the elimination (symbolic factorisation). Throws std::bad_alloc.
    void plan();
    /// Number of entries of the factor below the diagonal. Call after plan().
    size_t fill() const { return matrix_.fill(); }

    uint32_t node_count() const { return static_cast<uint32_t>(nodes_.size()); }
    const Node& node(uint32_t i) const { return nodes_[i]; }

    /// Copies the predicted state of a substep from the bodies, and the solved one back.
    void gather(const BodyTable& bodies, const Vector<Joint>& joints, double h);
    /// The same once more in a substep, when contacts hold particles: the forces of cloth go on acting on its nodes.
    void gather_again(const BodyTable& bodies, double h) { gather_nodes(bodies, h, false); }
    void scatter(BodyTable& bodies) const;
    /// Applies to the clusters of a body the pulls of links on their members since scatter(), but for nodes.
    void apply_link_pulls(Body& body, uint32_t slot);
    /// Adds the response of a cluster to `out`, if it is one of the system that moves freely. `system`: its number.
    void add_cluster_response(const Body& body, uint32_t slot, uint32_t cluster, uint32_t system,
                              Vector<ClusterResponse>& out);
    /// Applies the impulses of contacts on the clusters of a body.
    void apply_contact_impulses(uint32_t slot, const Vector<ClusterResponse>& responses);
    // While contacts are solved: what the impulses on all clusters since begin_impulses() move each of them by, to
    // first order. Only of those that have a response.
    /// Whether the system is not too large for that.
    bool couples_clusters() const { return !ways_.empty(); }
    void begin_impulses() { matrix_.clear_sum(); }
    void add_impulse(const ClusterResponse& of, Vec3 impulse, Vec3 angular_impulse);
    void displacement(const ClusterResponse& of, Vec3& shift, Vec3& turn) const;
    /// Call after that, before the next gather(): changes the histories of the bodies so that what the impulses
    /// displace changes velocities as in other bodies (contact/corrections.h).
    void displace_histories(BodyTable& bodies, double h);
    /// The same for impulses at the end of a substep, which change the velocities of all that is joined.
    void change_velocities(BodyTable& bodies);
    /// In a substep of h seconds, once links and joints are solved: the contact impulses that clusters lack where the
    /// joints have moved them behind contact planes since their own contacts were solved, or that they have too much.
    /// `system`: its number.
    void solve_cluster_contacts(BodyTable& bodies, const CollisionContext& around, double h, uint32_t system);
    /// For clusters of which models have pushed out particles, one by one, at the end of a substep: moves them as
    /// wholes instead, in front of their contact planes, and what is joined to them. Velocities follow.
    void push_out_clusters(BodyTable& bodies, const Vector<Joint>& joints, const CollisionContext& around, double h,
                           uint32_t system);
    /// Adds to the saved positions of members in contact by how much scatter() has moved them before contacts did.
    void save_cluster_places(Body& body, uint32_t slot) const;
    void scatter_tensions(BodyTable& bodies, Vector<Joint>& joints) const;
    /// Adds the tensions of joints at particles that are attached, or that friction holds, to the impulses of their
    /// models.
    void add_anchor_impulses(BodyTable& bodies, const CollisionContext& around, double h) const;
    /// Applies a force, newtons, to a node during the substep under way. One that does not move freely resists it.
    void apply_force(uint32_t node, Vec3 force);
    /// Moves the nodes by what the forces since the last solution do to first order: one substitution in place of
    /// Newton's method. Returns false, and moves nothing, if there were none. Call solve() in the end.
    bool respond();
    /// Whether a force was applied since the last solve().
    bool is_outdated() const { return outdated_; }
    /// Returns whether Newton's method has converged.
    bool solve();
    /// Whether all rigid links had their lengths before the substep, nearly. Not for cloth.
    bool began_feasible() const;
    /// Whether no link or joint stores energy. Not for cloth.
    bool is_rigid() const;
    /// Between substeps: whether nothing stores energy, and a joint or link has a wrong length (rope/rope_start.h).
    bool is_misplaced(const BodyTable& bodies, const Vector<Joint>& joints) const;
    /// Joules, in elastic links and in bends: now, and before the substep.
    double elastic_energy() const;
    double elastic_energy_before() const { return elastic_energy_before_; }
    /// Whether it has the rigid clusters of a body.
    bool has_clusters_of(uint32_t body) const;
    /// The compliance matrix of a node, m/N: its displacement by a unit force along each axis, as three columns.
    void response(uint32_t node, Vec3 (&columns)[3]);

private:
    /// As Link in rope_direct.cpp, with forces in newtons.
    struct LinkEquation {
        Vec3 direction;
        double error, stiffness, softness;  // m, N/m, m/N
        bool active;
    };
    void gather_placed(const BodyTable& bodies, const Vector<Joint>& joints, double h);
    double list_contacts(const BodyTable& bodies, const CollisionContext& around, bool acting);
    double sweep_contacts(BodyTable& bodies);
    void solve_contacts(BodyTable& bodies, uint32_t system);
    void note_contact_impulses(BodyTable& bodies, double h) const;
    /// `predicts_cloth`: the nodes of cloth are where they are predicted, before any force of its chains.
    void gather_nodes(const BodyTable& bodies, double h, bool predicts_cloth);
    LinkEquation linearise(const Link& link) const;
    Vec3 strain(const NodeBend& bend) const;
    void list_ties_of_pose(uint32_t node, uint32_t axis, Vector<uint32_t>& rows);
    void list_columns(ClusterTie& tie, uint32_t& scalar, Vector<uint32_t>& column_begin, Vector<uint32_t>& rows) const;
    void gather_clusters(const BodyTable& bodies, double h);
    void scatter_clusters(BodyTable& bodies) const;
    void assemble();
    void assemble_bends();
    void assemble_ties();
    void take_tie_forces(bool add);
    void turn_clusters(double fraction);
    void plan_ways();
    void place_clusters();
    /// Whether both move freely: the node, and the cluster at least about its pivot.
    bool is_active(const ClusterTie& tie) const;
    bool ties_are_converged() const;
    /// Calls visit(body, particle, displacement) with what the forces that were applied since the last solution do to
    /// first order, and takes these back.
    template <class Visit>
    void each_displaced(BodyTable& bodies, Visit&& visit);
    bool substitute();
    const JoinedCluster* find_cluster(uint32_t body, uint32_t cluster) const;
    Vec3 error(const ClusterTie& tie) const;
    double most_displacement() const;
    bool is_converged() const;
    bool is_solved() const;
    bool is_feasible() const;
    double advance();

    std::pmr::memory_resource* memory_;
    Vector<Node> nodes_{memory_};
    Vector<Link> links_{memory_};
    Vector<NodeBend> bends_{memory_};
    Vector<JoinedCluster> clusters_{memory_};
    Vector<ClusterTie> ties_{memory_};
    Vector<Vec3> predicted_{memory_};          // by member of a cluster, relative to the cloth's origin
    Vector<double> shares_{memory_};           // by member of a cluster: part of its mass that is in the pose
    Vector<MemberContact> contacts_{memory_};  // capacity for two of each member
    Vector<uint32_t> way_rows_{memory_};       // of clusters: see SparseLdl::list_way
    Vector<double> ways_{memory_};             // six for each of these rows; none if there are too many
    Vector<double> entries_{memory_}, diagonal_{memory_}, solution_{memory_};
    Vector<double> applied_{memory_};  // newtons, by unknown: the forces that respond() takes
    SparseLdl matrix_{memory_};
    bool outdated_ = false, has_applied_ = false;
    double elastic_energy_before_ = 0;
    double regularisation_ = 0;  // compliance that every link has, relative to the inverse masses at its ends
};

/// A particle of cloth that is a node of a system.
struct Tether {
    uint32_t body, particle, system, node;

    bool operator<(const Tether& other) const {
        return body != other.body ? body < other.body : particle < other.particle;
    }
};

}  // namespace gphys
