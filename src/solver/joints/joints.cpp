// Adding and removing joints, and partitioning bodies and joints into systems of equations.
#include "solver/joints/joints.h"

#include "solver/solver.h"
#include "solver/state.h"

namespace gphys {

gphys_status Solver::join(gphys_body_id body_a, uint32_t particle_a, gphys_body_id body_b, uint32_t particle_b,
                          double rest, double compliance, gphys_joint_id& out) {
    if (!state_.joint_ids.reserve(1))
        return fail(GPHYS_ERROR_CAPACITY, "the solver would have more than 2^24 - 1 joints");
    reserve_more(state_.joints, 1);
    Body &a = edit(body_a), &b = edit(body_b);
    interrupt(a);
    interrupt(b);
    if (rest < 0) rest = distance(a.particles.position[particle_a], b.particles.position[particle_b]);
    out = state_.joint_ids.add();
    const uint32_t slot = IdTable::slot_of(out);
    if (slot == state_.joints.size()) state_.joints.emplace_back();
    state_.joints[slot] = {IdTable::slot_of(body_a),
                           particle_a,
                           IdTable::slot_of(body_b),
                           particle_b,
                           counted_length(rest),
                           compliance,
                           {}};
    joints_current_ = false;
    return GPHYS_OK;
}

void Solver::remove_joint(uint32_t slot) {
    for (const uint32_t body : {state_.joints[slot].body_a, state_.joints[slot].body_b}) {
        wake(state_.bodies[body]);
        interrupt(state_.bodies[body]);
    }
    state_.joint_ids.remove(state_.joint_ids.id(slot));
    joints_current_ = false;
}

gphys_status Solver::unjoin(gphys_joint_id joint) {
    if (!state_.joint_ids.has(joint)) {
        return fail(GPHYS_ERROR_INVALID_ID, "joint", joint, "the id of a joint of the solver");
    }
    remove_joint(IdTable::slot_of(joint));
    return GPHYS_OK;
}

void Solver::remove_joints_of(uint32_t body) {
    for (const uint32_t slot : state_.joint_ids) {
        const Joint& joint = state_.joints[slot];
        if (joint.body_a == body || joint.body_b == body) remove_joint(slot);
    }
}

void Solver::list_joints(gphys_body_id of, Smallest<gphys_joint_info, JointOrder>& out) const {
    for (const uint32_t slot : state_.joint_ids) {
        const Joint& joint = state_.joints[slot];
        const gphys_body_id a = state_.ids.id(joint.body_a), b = state_.ids.id(joint.body_b);
        if (of != 0 && of != a && of != b) continue;
        const double force = joint.rest > 0 ? joint.tension.x : length(joint.tension);
        out.add({state_.joint_ids.id(slot), a, joint.particle_a, b, joint.particle_b, static_cast<float>(joint.rest),
                 static_cast<float>(joint.compliance), to_float(force)});
    }
}

namespace {

/// An element of the partition: a whole body of chains or particles, or a joined particle of cloth.
struct Part {
    uint32_t body, particle;  // `whole` stands for all particles

    static constexpr uint32_t whole = 0xffffffff;
    bool operator<(const Part& other) const {
        return body != other.body ? body < other.body : particle < other.particle;
    }
    bool operator==(const Part& other) const { return body == other.body && particle == other.particle; }
};

/// Union-find over the parts that joints and branches unite.
struct Partition {
    const BodyTable& bodies;
    Vector<Part> parts;       // sorted
    Vector<uint32_t> parent;  // of DisjointSets

    Part part_of(uint32_t body, uint32_t particle) const {
        return {body, bodies[body].plan.method == GPHYS_SOLVE_GRAPH ? particle : Part::whole};
    }
    uint32_t index(Part part) const {
        return static_cast<uint32_t>(std::lower_bound(parts.begin(), parts.end(), part) - parts.begin());
    }
};

void add_chain_nodes(const Body& body, uint32_t slot, Vector<Part>& nodes) {
    for (const Chain& chain : body.plan.chains) {
        for (uint32_t i = 0; i <= chain.link_count; ++i) {
            nodes.push_back({slot, body.plan.particles[chain.first_particle + i]});
        }
    }
}

void add_chain_links(const Body& body, uint32_t slot, JointSystem& system) {
    const Plan& plan = body.plan;
    for (const Chain& chain : plan.chains) {
        const uint32_t* particle = &plan.particles[chain.first_particle];
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            JointSystem::Link link;
            link.a = system.find_node(slot, particle[i]);
            link.b = system.find_node(slot, particle[i + 1]);
            link.owner = slot;
            link.index = chain.first_link + i;
            system.add_link(link);
            if (i == 0 || !body.rope.bending.resists()) continue;
            system.add_bend({{system.find_node(slot, particle[i - 1]), link.a, link.b}, slot, link.index});
        }
    }
}

/// visit(members) for the clusters of cloth that share no particle with another one.
template <class Visit>
void each_cluster_of_its_own(const Body& body, Visit&& visit) {
    const Clusters& clusters = body.cloth.clusters;
    if (body.plan.method != GPHYS_SOLVE_GRAPH || clusters.empty()) return;
    Vector<uint8_t> uses(body.particles.size(), 0, clusters.members.get_allocator());
    for (const ClusterMember& member : clusters.members) uses[member.particle] += uses[member.particle] < 2;
    each_cluster(clusters, [&](ClusterRange members) {
        if (std::all_of(members.begin(), members.end(), [&](const ClusterMember& m) { return uses[m.particle] == 1; }))
            visit(members);
    });
}

void add_joint(const Joint& joint, uint32_t slot, JointSystem& system) {
    JointSystem::Link link;
    link.a = system.find_node(joint.body_a, joint.particle_a);
    link.b = system.find_node(joint.body_b, joint.particle_b);
    link.owner = JointSystem::of_joint;
    link.index = slot;
    if (joint.rest > 0) {
        system.add_link(link);
        return;
    }
    for (link.axis = 0; link.axis < 3; ++link.axis) system.add_link(link);
}

}  // namespace

/// Partitions bodies and joints, and builds a system of each set: nodes, links, order of elimination. If it throws
/// std::bad_alloc, it must be called again.
void Solver::plan_joints() {
    systems_.clear();
    tethers_.clear();
    Partition partition{state_.bodies, Vector<Part>(&memory), Vector<uint32_t>(&memory)};
    const auto each_joint = [&](auto&& visit) {
        for (const uint32_t slot : state_.joint_ids) visit(state_.joints[slot], slot);
    };
    Vector<Part>& parts = partition.parts;
    for (const uint32_t slot : state_.ids) {
        if (state_.bodies[slot].plan.branched) parts.push_back({slot, Part::whole});
    }
    each_joint([&](const Joint& joint, uint32_t) {
        parts.push_back(partition.part_of(joint.body_a, joint.particle_a));
        parts.push_back(partition.part_of(joint.body_b, joint.particle_b));
    });
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    DisjointSets sets(partition.parent, static_cast<uint32_t>(parts.size()));
    const auto part_a = [&](const Joint& joint) {
        return partition.index(partition.part_of(joint.body_a, joint.particle_a));
    };
    each_joint([&](const Joint& joint, uint32_t) {
        sets.unite(part_a(joint), partition.index(partition.part_of(joint.body_b, joint.particle_b)));
    });

    Vector<ClusterRange> clusters(&memory);  // of which a particle is joined
    Vector<uint32_t> part_of_cluster(&memory);
    for (const uint32_t slot : state_.ids) {
        const uint32_t none = static_cast<uint32_t>(parts.size()), first_of_body = partition.index({slot, 0});
        if (first_of_body == none || parts[first_of_body].body != slot) continue;
        each_cluster_of_its_own(state_.bodies[slot], [&](ClusterRange members) {
            uint32_t first = none;
            for (const ClusterMember& member : members) {
                const uint32_t part = partition.index({slot, member.particle});
                if (part == none || !(parts[part] == Part{slot, member.particle})) continue;
                first = std::min(first, part);
                sets.unite(first, part);
            }
            if (first == none) return;
            clusters.push_back(members);
            part_of_cluster.push_back(first);
        });
    }

    // Systems are ordered by their first parts.
    Vector<uint32_t> system_of(parts.size(), 0, &memory);
    for (uint32_t i = 0; i < parts.size(); ++i) {
        const uint32_t root = sets.root(i);
        if (root == i) {
            system_of[i] = static_cast<uint32_t>(systems_.size());
            systems_.emplace_back(&memory);
        } else {
            system_of[i] = system_of[root];
        }
    }
    Vector<Vector<Part>> nodes(systems_.size(), &memory);
    for (uint32_t i = 0; i < parts.size(); ++i) {
        if (parts[i].particle == Part::whole) {
            add_chain_nodes(state_.bodies[parts[i].body], parts[i].body, nodes[system_of[i]]);
        }
    }
    each_joint([&](const Joint& joint, uint32_t) {
        Vector<Part>& list = nodes[system_of[part_a(joint)]];
        list.push_back({joint.body_a, joint.particle_a});
        list.push_back({joint.body_b, joint.particle_b});
    });
    for (size_t s = 0; s < systems_.size(); ++s) {
        std::sort(nodes[s].begin(), nodes[s].end());
        nodes[s].erase(std::unique(nodes[s].begin(), nodes[s].end()), nodes[s].end());
        for (const Part& node : nodes[s]) {
            systems_[s].add_node(node.body, node.particle, state_.bodies[node.body].plan.method == GPHYS_SOLVE_GRAPH);
        }
    }
    for (uint32_t i = 0; i < parts.size(); ++i) {
        if (parts[i].particle == Part::whole) {
            add_chain_links(state_.bodies[parts[i].body], parts[i].body, systems_[system_of[i]]);
        }
    }
    each_joint([&](const Joint& joint, uint32_t slot) { add_joint(joint, slot, systems_[system_of[part_a(joint)]]); });
    for (size_t i = 0; i < clusters.size(); ++i)
        systems_[system_of[part_of_cluster[i]]].add_cluster(parts[part_of_cluster[i]].body, clusters[i]);
    for (uint32_t s = 0; s < systems_.size(); ++s) {
        systems_[s].plan();
        for (uint32_t i = 0; i < systems_[s].node_count(); ++i) {
            const JointSystem::Node& node = systems_[s].node(i);
            if (node.of_graph) tethers_.push_back({node.body, node.particle, s, i});
        }
    }
    std::sort(tethers_.begin(), tethers_.end());
    beside_joints_.find(state_.bodies, state_.joints, state_.joint_ids);
    joints_current_ = true;
}

}  // namespace gphys
