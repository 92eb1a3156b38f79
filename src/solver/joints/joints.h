// Joints between bodies, and the systems of equations that they make of them.
//
// Joined ropes and particles are one system: Newton's method on the positions and tensions of all of them
// together, as rope_direct.cpp does it for one chain, with a sparse elimination instead of one along the
// chain. A joint at a distance is one more link of it, a joint at none three links along the axes. A body whose
// chains branch is a system without joints.
//
// Cloth is not part of a system, only its joined particles are. Cloth in turn sees what hangs on such a
// particle: the system gives the particle's response to a force, a matrix, which stands for its inverse mass
// in the chains of the cloth; what the chains pull it with then acts on the system. So a weight on a rope
// weighs on a corner of cloth with all its mass along the rope and with hardly any across it, and what the
// cloth gives the rope takes, to the last bit of momentum that float32 holds.
#pragma once

#include "foundation/math.h"
#include "solver/joints/sparse_ldl.h"

namespace gphys {

struct Body;
struct CollisionContext;

/// |position of b - position of a| = rest + compliance * tension; both ends of different bodies.
struct Joint {
    uint32_t body_a, particle_a, body_b, particle_b;  // bodies by slot
    double rest, compliance;
    Vec3 tension;  // newtons, of the last substep; beyond rest 0 it is all in x
};

class JointSystem {
public:
    explicit JointSystem(std::pmr::memory_resource* memory)
        : nodes_(memory), links_(memory), entries_(memory), diagonal_(memory), solution_(memory), matrix_(memory) {}

    /// A particle of the system, in the order of elimination.
    struct Node {
        uint32_t body, particle;
        uint32_t scalar = 0;  // its first unknown of three
        bool of_graph = false;
        bool free = true;
        double weight = 0;                                // mass / step^2: newtons that move it by a metre
        Vec3 before{}, predicted{}, start{}, position{};  // before the substep, and while it is solved
    };
    /// What holds two nodes at a distance: a link of a chain, or a joint or an axis of one.
    struct Link {
        uint32_t a, b;
        uint32_t source_body, source;  // slot and link in its plan; `of_joint` and the joint's slot
        int axis = along;              // of a joint at no distance
        uint32_t scalar = 0;           // its tension
        uint32_t rank = 0;             // among the links from the later end to nodes before
        bool early = false;            // its tension comes right after the earlier end, not the later one,
        uint32_t pull = 0;             // and is there in the columns of the later one
        double rest = 0, compliance = 0, tension = 0;
        bool limit = false;  // it pulls and never pushes

        uint32_t earlier() const { return std::min(a, b); }
        uint32_t later() const { return std::max(a, b); }
    };
    static constexpr int along = -1;
    static constexpr uint32_t of_joint = 0xffffffff;

    // Of a system to be planned: all nodes by body and particle, then the links between them.
    void add_node(uint32_t body, uint32_t particle, bool of_graph) { nodes_.push_back({body, particle, 0, of_graph}); }
    uint32_t find_node(uint32_t body, uint32_t particle) const;
    void add_link(const Link& link) { links_.push_back(link); }
    /// Order the nodes and find out what elimination will fill. Throws std::bad_alloc.
    void plan();
    /// Entries of the factor below the diagonal, once it is planned.
    size_t fill() const { return matrix_.fill(); }

    uint32_t node_count() const { return static_cast<uint32_t>(nodes_.size()); }
    const Node& node(uint32_t i) const { return nodes_[i]; }

    /// Take the predicted state of a substep from the bodies, or give the solved one back to them.
    void gather(const Vector<Body>& bodies, const Vector<Joint>& joints, double h);
    void scatter(Vector<Body>& bodies) const;
    void scatter_tensions(Vector<Body>& bodies, Vector<Joint>& joints) const;
    /// What joints pull attached particles with goes to their models.
    void add_anchor_impulses(Vector<Body>& bodies, const CollisionContext& around, double h) const;
    /// A force in newtons on a node, for the substep under way.
    void push(uint32_t node, Vec3 force) {
        nodes_[node].predicted += force / nodes_[node].weight;
        pushed_ = true;
    }
    /// Since it was solved.
    bool is_pushed() const { return pushed_; }
    /// Whether the lengths of all links have been found.
    bool solve();
    /// Whether rigid links had them before the substep; not to be asked of cloth.
    bool began_in_shape() const;
    /// Joules in links that yield, as they are and before the substep.
    double stored() const;
    double stored_before() const { return stored_before_; }
    /// By how many metres the node would move by a newton along each axis; three columns.
    void response(uint32_t node, Vec3 (&columns)[3]);

private:
    struct Stretch {
        Vec3 direction;
        double error, stiffness, softness;
        bool acts;
    };
    Stretch stretch(const Link& link) const;
    void assemble();
    double reach() const;
    bool is_settled() const;
    bool is_found() const;
    bool is_feasible() const;
    double advance();

    Vector<Node> nodes_;
    Vector<Link> links_;
    Vector<double> entries_, diagonal_, solution_;
    SparseLdl matrix_;
    bool pushed_ = false;
    double stored_before_ = 0;
    double regularisation_ = 0;  // the compliance that all links have beside their own, relative to inverse masses
};

/// A particle of cloth that is a node of a system.
struct Tether {
    uint32_t body, particle, system, node;

    bool operator<(const Tether& other) const {
        return body != other.body ? body < other.body : particle < other.particle;
    }
};

}  // namespace gphys
