// Newton's method on a system of joined chains and particles. The equations, with geometric stiffness and
// regularisation, are those of rope_direct.cpp. Forces are in newtons here, because damping may give bodies different
// effective time steps. Each linear system is factorised as L D L^T, in an order of little fill (elimination_order.h).
//
// Why chains have an elimination of their own: a step of a free rope of 30 links takes 1.1 million instructions in
// rope_direct.cpp, and 2.0 million here with one more link as a branch.
//
// Why not block elimination over a forest with loop closures: for trees it would come close to rope_direct.cpp. But
// joints that close loops would need an additional dense system, where SparseLdl includes them in its order. It would
// also change the bits of all trees.
#include "solver/body_table.h"
#include "solver/contact/collision.h"
#include "solver/contact/impulses.h"
#include "solver/joints/elimination_order.h"
#include "solver/joints/joints.h"
#include "solver/rope/rope.h"
#include "solver/rope/rope_kernels.h"
#include "solver/rope/rope_start.h"
#include "solver/rope/stretched_ropes.h"
#include "solver/state_range.h"
#include "solver/time_scheme.h"

namespace gphys {
namespace {

// Newton's method squares the error in each iteration, and mostly needs three. But a load that is jerked up by a rope
// bends it first, as one that falls onto a rope does (rope_direct.cpp). Iterations also determine the active limits.
constexpr int most_iterations = 16;
constexpr double tolerance = 1e-9;  // of lengths
// The links of eight joints of zero length. Up to this number, the tensions that end at a node couple by a few hundred
// entries at most.
constexpr uint32_t most_late_links = 24;
// Between pins too far apart only the regularisation bounds the tensions, and geometric stiffness with such tensions
// throws particles aside. A tension that would move a particle by more than 10^4 lengths of its link in a substep is
// infeasible. Then all links get a compliance of 10^-4 of the inverse masses, and share the stretch.
constexpr double infeasible = 1e4;
constexpr double soft_regularisation = 1e-4;
// To stretch links from rest to twice their lengths takes this many once, and a few in later substeps.
constexpr int most_soft_iterations = 300;

constexpr Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

constexpr int bend_pairs[3][2] = {{0, 1}, {1, 2}, {0, 2}};

Vec3 cloth_position(const ClothState& state, uint32_t particle) {
    const float* at = &state.at[4 * size_t{particle}];
    return state.origin + Vec3{at[0], at[1], at[2]};
}

}  // namespace

uint32_t JointSystem::find_node(uint32_t body, uint32_t particle) const {
    const auto before = [](const Node& node, const Node& wanted) {
        return node.body != wanted.body ? node.body < wanted.body : node.particle < wanted.particle;
    };
    const auto at = std::lower_bound(nodes_.begin(), nodes_.end(), Node{body, particle}, before);
    return static_cast<uint32_t>(at - nodes_.begin());
}

void JointSystem::plan() {
    std::pmr::memory_resource* memory = nodes_.get_allocator().resource();
    for (JoinedCluster& cluster : clusters_) {
        for (uint32_t* const node : {&cluster.centre, &cluster.turn}) {
            *node = node_count();
            add_node(cluster.body, of_pose, false);
        }
    }
    const uint32_t count = node_count();
    Vector<Edge> edges(memory);
    for (const Link& link : links_) edges.push_back({link.a, link.b});
    for (const NodeBend& bend : bends_) edges.push_back({bend.nodes[0], bend.nodes[2]});
    for (const ClusterTie& tie : ties_) {
        edges.push_back({tie.node, clusters_[tie.cluster].centre});
        edges.push_back({tie.node, clusters_[tie.cluster].turn});
    }
    Vector<uint32_t> order(memory), place(count, memory);
    order_by_degree(count, edges, order);
    for (uint32_t i = 0; i < count; ++i) place[order[i]] = i;
    Vector<Node> ordered(memory);
    for (const uint32_t node : order) ordered.push_back(nodes_[node]);
    nodes_.swap(ordered);
    for (Link& link : links_) link.a = place[link.a], link.b = place[link.b];
    for (NodeBend& bend : bends_) {
        for (uint32_t& node : bend.nodes) node = place[node];
    }
    for (JoinedCluster& cluster : clusters_) cluster.centre = place[cluster.centre], cluster.turn = place[cluster.turn];
    for (ClusterTie& tie : ties_) {
        tie.node = place[tie.node];
        tie.before_centre = tie.node < clusters_[tie.cluster].centre;
        tie.before_turn = tie.node < clusters_[tie.cluster].turn;
    }

    // The tension of a link is eliminated right after the later of its ends, whose mass keeps its pivot from zero. But
    // to eliminate a node couples all tensions that come after it: with n links to a hub, n^2 entries. The tensions of
    // a hub's links are therefore eliminated right after the earlier ends. If such an end does not move, the pivot is
    // the regularisation alone, a stiff spring. That loses digits, which Newton's next iteration recovers.
    Vector<uint32_t> ending(count, 0u, memory);
    for (const Link& link : links_) ++ending[link.later()];
    for (Link& link : links_) link.after_earlier = ending[link.later()] > most_late_links;
    const auto after = [](const Link& link) { return link.after_earlier ? link.earlier() : link.later(); };
    std::stable_sort(links_.begin(), links_.end(), [&](const Link& a, const Link& b) { return after(a) < after(b); });
    Vector<uint32_t> by_end(memory);  // links, sorted by their later end
    for (uint32_t l = 0; l < links_.size(); ++l) by_end.push_back(l);
    std::stable_sort(by_end.begin(), by_end.end(),
                     [&](uint32_t a, uint32_t b) { return links_[a].later() < links_[b].later(); });

    struct BendCoupling {
        uint32_t later, earlier;
        uint32_t* entry;  // of the bend
    };
    Vector<BendCoupling> by_later(memory);
    for (NodeBend& bend : bends_) {
        for (int pair = 0; pair < 3; ++pair) {
            const uint32_t a = bend.nodes[bend_pairs[pair][0]], b = bend.nodes[bend_pairs[pair][1]];
            by_later.push_back({std::max(a, b), std::min(a, b), &bend.entries[pair]});
        }
    }
    std::stable_sort(by_later.begin(), by_later.end(),
                     [](const BendCoupling& a, const BendCoupling& b) { return a.later < b.later; });

    Vector<uint32_t> by_node(memory);  // ties
    for (uint32_t t = 0; t < ties_.size(); ++t) by_node.push_back(t);
    std::stable_sort(by_node.begin(), by_node.end(),
                     [&](uint32_t a, uint32_t b) { return ties_[a].node < ties_[b].node; });

    Vector<uint32_t> column_begin(1, 0, memory), rows(memory);
    uint32_t scalar = 0;
    size_t next_end = 0, next_link = 0, next_bend = 0, next_tie = 0;
    for (uint32_t i = 0; i < count; ++i) {
        nodes_[i].scalar = scalar;
        const size_t first_end = next_end;
        while (next_end < by_end.size() && links_[by_end[next_end]].later() == i) ++next_end;
        const size_t first_bend = next_bend;
        while (next_bend < by_later.size() && by_later[next_bend].later == i) ++next_bend;
        // The rows of each column of the node: the nodes to which it is coupled, tensions eliminated before it, nodes
        // to which bends couple it, then the entries above its diagonal.
        uint32_t couplings = 0, tensions = 0;
        for (size_t e = first_end; e < next_end; ++e) {
            Link& link = links_[by_end[e]];
            if (link.axis == along) link.coupling_index = couplings++;
        }
        for (size_t e = first_end; e < next_end; ++e) {
            Link& link = links_[by_end[e]];
            if (link.after_earlier) link.tension_row = 3 * couplings + tensions++;
        }
        for (size_t e = first_bend; e < next_bend; ++e)
            *by_later[e].entry = 3 * couplings + tensions + static_cast<uint32_t>(e - first_bend);
        for (uint32_t k = 0; k < 3; ++k, ++scalar) {
            for (size_t e = first_end; e < next_end; ++e) {
                const Link& link = links_[by_end[e]];
                if (link.axis != along) continue;
                const uint32_t before = nodes_[link.earlier()].scalar;
                rows.insert(rows.end(), {before, before + 1, before + 2});
            }
            for (size_t e = first_end; e < next_end; ++e) {
                const Link& link = links_[by_end[e]];
                if (link.after_earlier) rows.push_back(link.scalar);
            }
            for (size_t e = first_bend; e < next_bend; ++e) rows.push_back(nodes_[by_later[e].earlier].scalar + k);
            if (nodes_[i].particle == of_pose) list_ties_of_pose(i, k, rows);
            for (uint32_t above = 0; above < k; ++above) rows.push_back(nodes_[i].scalar + above);
            column_begin.push_back(static_cast<uint32_t>(rows.size()));
        }
        for (; next_link < links_.size() && after(links_[next_link]) == i; ++next_link, ++scalar) {
            Link& link = links_[next_link];
            link.scalar = scalar;
            for (const uint32_t node : {link.a, link.b}) {
                if (link.after_earlier && node != i) continue;
                for (uint32_t k = 0; k < 3; ++k) rows.push_back(nodes_[node].scalar + k);
            }
            column_begin.push_back(static_cast<uint32_t>(rows.size()));
        }
        for (; next_tie < by_node.size() && ties_[by_node[next_tie]].node == i; ++next_tie)
            list_columns(ties_[by_node[next_tie]], scalar, column_begin, rows);
    }
    matrix_.analyse(column_begin, rows);
    plan_ways();
    entries_.resize(rows.size());
    diagonal_.resize(scalar);
    solution_.resize(scalar);
    applied_.assign(scalar, 0.0);
}

void JointSystem::gather_nodes(const BodyTable& bodies, double h, bool predicts_cloth) {
    for (Node& node : nodes_) {
        if (node.particle == of_pose) continue;
        const Body& body = bodies[node.body];
        const double step = TimeScheme(h, body.history.earlier_step).step(body.settings.damping);
        node.free = !body.particles.pinned(node.particle);
        node.weight = node.share * body.particles.mass[node.particle] / (step * step);
        if (node.of_graph) {
            if (predicts_cloth)
                node.position = node.predicted = node.before = cloth_position(body.cloth.state, node.particle);
        } else {
            node.position = body.particles.position[node.particle];
            node.predicted = body.history.predicted[node.particle];
            node.before = body.history.start[node.particle];
        }
    }
}

void JointSystem::apply_force(uint32_t node, Vec3 force) {
    Node& of = nodes_[node];
    if (!of.free) return;
    for (uint32_t k = 0; k < 3; ++k) applied_[of.scalar + k] += force[static_cast<int>(k)];
    outdated_ = has_applied_ = true;
    if (!of.loaded) {
        of.predicted += force / of.weight;
        return;
    }
    const Vec3 x = of.load.x + axes[0] * of.weight, y = of.load.y + axes[1] * of.weight,
               z = of.load.z + axes[2] * of.weight;
    const Vec3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
    of.predicted += Vec3{dot(yz, force), dot(zx, force), dot(xy, force)} / dot(x, yz);
}

void JointSystem::gather(const BodyTable& bodies, const Vector<Joint>& joints, double h) {
    for (Node& node : nodes_) node.loaded = false, node.load = {{}, {}, {}};
    gather_clusters(bodies, h);
    gather_nodes(bodies, h, true);
    for (Link& link : links_) {
        if (link.owner == of_joint) {
            const Joint& joint = joints[link.index];
            link.rest = joint.rest;
            link.compliance = joint.compliance;
            link.tension = link.axis == along ? joint.tension.x : joint.tension[link.axis];
        } else {
            const Body& body = bodies[link.owner];
            link.rest = body.rope.damped_rest[link.index];
            link.compliance = body.rope.damped_compliance[link.index];
            link.limit = body.plan.limit[link.index] != 0;
            link.tension = body.rope.tension[link.index];
        }
    }
    for (NodeBend& bend : bends_) {
        const Bending& bending = bodies[bend.body].rope.bending;
        bend.bend = bending.bends[bend.index];
        bend.keeps_shape = bending.keeps_shape;
    }
    elastic_energy_before_ = elastic_energy();
}

double JointSystem::elastic_energy() const {
    double sum = 0;
    for (const Link& link : links_) sum += link.compliance * link.tension * link.tension / 2;
    for (const NodeBend& bend : bends_) sum += length_squared(strain(bend)) / 2;
    return sum;
}

Vec3 JointSystem::strain(const NodeBend& bend) const {
    const auto place = [&](int i) {
        const Node& node = nodes_[bend.nodes[i]];
        return bend.keeps_shape ? node.position - node.predicted : node.position;
    };
    return bend.bend.strain(place(0), place(1), place(2));
}

void JointSystem::scatter(BodyTable& bodies) const {
    for (const Node& node : nodes_) {
        if (!node.free || node.particle == of_pose) continue;
        Body& body = bodies[node.body];
        if (node.of_graph) {
            const Vec3 at = node.position - body.cloth.state.origin;
            for (int k = 0; k < 3; ++k) {
                body.cloth.state.at[4 * size_t{node.particle} + k] =
                    static_cast<float>(std::clamp(at[k], -far_range, far_range));
            }
        } else {
            body.particles.position[node.particle] = node.position;
        }
    }
    scatter_clusters(bodies);
}

void JointSystem::scatter_tensions(BodyTable& bodies, Vector<Joint>& joints) const {
    for (const Link& link : links_) {
        // The initial guess of the next solution must be finite.
        const double tension = is_finite(link.tension) ? link.tension : 0;
        if (link.owner != of_joint) {
            bodies[link.owner].rope.tension[link.index] = tension;
        } else {
            Vec3& joint_tension = joints[link.index].tension;
            (link.axis == along ? joint_tension.x : joint_tension[link.axis]) = tension;
        }
    }
}

void JointSystem::add_anchor_impulses(BodyTable& bodies, const CollisionContext& around, double h) const {
    const auto add_to_model = [&](const Node& node, Vec3 force) {
        if (node.free) return;
        Body& body = bodies[node.body];
        if (body.particles.pinned(node.particle)) {
            add_anchor_impulse(body, around, node.particle, force * h);
        } else {
            const TimeScheme scheme(h, body.history.earlier_step);
            const SolvedAgain again{scheme.step(body.settings.damping), scheme.next / h};
            add_holder_impulse(body, around, node.particle, force * again.to_impulse());
        }
    };
    for (const Link& link : links_) {
        if (link.owner != of_joint) continue;  // chains add their own
        const Node &a = nodes_[link.a], &b = nodes_[link.b];
        if (a.free && b.free) continue;
        const Vec3 pull = linearise(link).direction * link.tension;
        add_to_model(a, pull);
        add_to_model(b, -pull);
    }
}

JointSystem::LinkEquation JointSystem::linearise(const Link& link) const {
    const Node &a = nodes_[link.a], &b = nodes_[link.b];
    LinkEquation out{};
    out.active = a.free || b.free;
    const Vec3 between = b.position - a.position;
    const double mobility = (a.free ? 1 / a.weight : 0) + (b.free ? 1 / b.weight : 0);
    out.softness = link.compliance + regularisation_ * mobility;
    if (link.axis != along) {
        out.direction = axes[link.axis];
        out.error = between[link.axis] - link.rest;
        return out;
    }
    const double length = gphys::length(between), scale = std::max({length, link.rest, rope_shortest});
    out.direction = length > 0 ? between / length : axes[0];
    out.error = length - link.rest;
    if (link.tension > 0) out.stiffness = link.tension / scale;
    // As in rope_direct.cpp: a limit is active while its tension is positive.
    if (link.limit && link.tension * mobility + out.error <= 0) return LinkEquation{};
    return out;
}

void JointSystem::assemble() {
    std::fill(entries_.begin(), entries_.end(), 0.0);
    const auto column_begin = [&](uint32_t column) { return entries_.data() + matrix_.column_begin(column); };
    // The entries above the diagonal of a node, which follow its couplings.
    const auto own = [&](const Node& node, uint32_t column) {
        return entries_.data() + matrix_.column_begin(node.scalar + column + 1) - column;
    };
    for (const Node& node : nodes_) {
        const Vec3 way = node.free ? node.predicted - node.position : Vec3{},
                   force = way * node.weight + node.load * way;
        for (uint32_t k = 0; k < 3; ++k) {
            const Vec3 column = node.load * axes[k];
            diagonal_[node.scalar + k] = node.weight + column[static_cast<int>(k)];
            solution_[node.scalar + k] = force[static_cast<int>(k)];
            for (uint32_t row = 0; row < k; ++row) own(node, k)[row] = column[static_cast<int>(row)];
        }
    }
    for (const Link& link : links_) {
        const LinkEquation s = linearise(link);
        const Node &a = nodes_[link.a], &b = nodes_[link.b];
        diagonal_[link.scalar] = s.active ? -s.softness : -1;
        solution_[link.scalar] = s.active ? -s.error : 0;
        const Node& later = nodes_[link.later()];
        double* const ends = column_begin(link.scalar);
        for (uint32_t k = 0; k < 3; ++k) {
            const double of_a = a.free ? -s.direction[static_cast<int>(k)] : 0;
            const double of_b = b.free ? s.direction[static_cast<int>(k)] : 0;
            if (link.after_earlier) {
                const bool a_first = link.a < link.b;
                ends[k] = a_first ? of_a : of_b;
                column_begin(later.scalar + k)[link.tension_row] = a_first ? of_b : of_a;
            } else {
                ends[k] = of_a;
                ends[3 + k] = of_b;
            }
        }
        if (s.stiffness == 0) continue;
        for (uint32_t column = 0; column < 3; ++column) {
            const Vec3 axis = axes[column];
            const Vec3 k = (axis - s.direction * s.direction[static_cast<int>(column)]) * s.stiffness;
            for (const Node* node : {&a, &b}) {
                diagonal_[node->scalar + column] += k[static_cast<int>(column)];
                for (uint32_t row = 0; row < column; ++row) own(*node, column)[row] += k[static_cast<int>(row)];
            }
            if (!a.free || !b.free) continue;
            double* const coupling = column_begin(later.scalar + column) + 3 * size_t{link.coupling_index};
            for (int row = 0; row < 3; ++row) coupling[row] = -k[row];
        }
    }
}

/// Adds the forces and the stiffness of bends.
void JointSystem::assemble_bends() {
    for (const NodeBend& bend : bends_) {
        double factors[3];
        bend.factors(factors);
        const Vec3 strain = this->strain(bend);
        for (int i = 0; i < 3; ++i) {
            const Node& node = nodes_[bend.nodes[i]];
            if (!node.free) continue;
            const Vec3 force = strain * -factors[i];
            for (uint32_t k = 0; k < 3; ++k) {
                diagonal_[node.scalar + k] += factors[i] * factors[i];
                solution_[node.scalar + k] += force[static_cast<int>(k)];
            }
        }
        for (int pair = 0; pair < 3; ++pair) {
            const int first = bend_pairs[pair][0], second = bend_pairs[pair][1];
            const uint32_t a = bend.nodes[first], b = bend.nodes[second];
            if (!nodes_[a].free || !nodes_[b].free) continue;
            const Node& later = nodes_[std::max(a, b)];
            for (uint32_t k = 0; k < 3; ++k)
                entries_[matrix_.column_begin(later.scalar + k) + bend.entries[pair]] =
                    factors[first] * factors[second];
        }
    }
}

/// A bound of corrections, metres: the sum of all link lengths, as placed and at rest, and of the distances to the
/// predicted positions.
double JointSystem::most_displacement() const {
    double sum = 0;
    for (const Node& node : nodes_) sum += distance(node.position, node.predicted);
    for (const Link& link : links_) sum += distance(nodes_[link.a].position, nodes_[link.b].position) + link.rest;
    return sum;
}

bool JointSystem::is_converged() const {
    return ties_are_converged() && std::all_of(links_.begin(), links_.end(), [&](const Link& link) {
               // The equations of joints with zero length are linear.
               if (link.axis != along) return true;
               const LinkEquation s = linearise(link);
               return !s.active || std::fabs(s.error - s.softness * link.tension) <= tolerance * link.rest;
           });
}

bool JointSystem::is_solved() const {
    return regularisation_ != soft_regularisation && std::all_of(links_.begin(), links_.end(), [&](const Link& link) {
               if (link.axis != along || link.rest == 0) return true;
               const LinkEquation s = linearise(link);
               return !s.active || std::fabs(s.error - s.softness * link.tension) <= rope_failure * link.rest;
           });
}

bool JointSystem::began_feasible() const {
    double longest = 0;
    for (const Link& link : links_) longest = std::max(longest, link.rest);
    return std::all_of(links_.begin(), links_.end(), [&](const Link& link) {
        if (link.compliance > 0) return true;
        const Node &a = nodes_[link.a], &b = nodes_[link.b];
        const double excess = distance(a.before, b.before) - link.rest;
        return (link.limit ? excess : std::fabs(excess)) <= most_initial_strain * (link.rest > 0 ? link.rest : longest);
    });
}

bool JointSystem::is_rigid() const {
    return bends_.empty() && std::none_of(links_.begin(), links_.end(),
                                          [](const Link& link) { return link.limit || link.compliance > 0; });
}

bool JointSystem::is_misplaced(const BodyTable& bodies, const Vector<Joint>& joints) const {
    const auto plan_of = [&](const Link& link) -> const Plan& { return bodies[link.owner].plan; };
    const auto rest_of = [&](const Link& link) {
        return link.owner == of_joint ? joints[link.index].rest : plan_of(link).rest[link.index];
    };
    const auto stores_energy = [&](const Link& link) {
        if (link.owner == of_joint) return joints[link.index].compliance > 0;
        return plan_of(link).damped || plan_of(link).limited || plan_of(link).compliance[link.index] > 0;
    };
    const auto place_of = [&](uint32_t node) {
        const Body& body = bodies[nodes_[node].body];
        const uint32_t particle = nodes_[node].particle;
        return nodes_[node].of_graph ? cloth_position(body.cloth.state, particle) : body.particles.position[particle];
    };
    if (!bends_.empty() || std::any_of(links_.begin(), links_.end(), stores_energy)) return false;
    double size = 0;  // what joints of zero length are compared with
    for (const Link& link : links_) size = std::max(size, rest_of(link));
    for (const JoinedCluster& cluster : clusters_) size = std::max(size, cluster.extent);
    return std::any_of(links_.begin(), links_.end(), [&](const Link& link) {
        const double rest = rest_of(link), error = distance(place_of(link.a), place_of(link.b)) - rest;
        return std::fabs(error) > least_misplacement * (rest > 0 ? rest : size);
    });
}

bool JointSystem::is_feasible() const {
    return std::all_of(links_.begin(), links_.end(), [&](const Link& link) {
        const Node &a = nodes_[link.a], &b = nodes_[link.b];
        if (link.axis != along || (!a.free && !b.free)) return true;
        const double weight = std::max(a.free ? a.weight : 0, b.free ? b.weight : 0);
        return std::fabs(link.tension) <= infeasible * weight * std::max(link.rest, distance(a.position, b.position));
    });
}

bool JointSystem::solve() {
    if (has_applied_) std::fill(applied_.begin(), applied_.end(), 0.0);
    outdated_ = has_applied_ = false;
    for (Node& node : nodes_) node.start = node.position;
    regularisation_ = rope_regularisation;
    int iterations = most_iterations;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        assemble();
        assemble_bends();
        assemble_ties();
        matrix_.factor(entries_.data(), diagonal_.data());
        matrix_.solve(solution_.data());
        for (Link& link : links_) link.tension = solution_[link.scalar];
        take_tie_forces(false);
        if (regularisation_ != soft_regularisation && !is_feasible()) {
            regularisation_ = soft_regularisation;
            iterations = most_soft_iterations;
            // Where only the regularisation bounds the tensions, they are inversely proportional to it.
            for (Link& link : links_) link.tension *= rope_regularisation / soft_regularisation;
            for (Node& node : nodes_) node.position = node.start;
            place_clusters();
            iteration = -1;
            continue;
        }
        const double fraction = advance();
        if (iteration > 0 && fraction == 1 && is_converged()) return true;
    }
    return is_solved();
}

/// Moves the nodes by the solution, or by a fraction of it that bounds the displacement; returns the fraction. A
/// solution that is not finite moves nothing.
double JointSystem::advance() {
    double longest = 0;
    for (const Node& node : nodes_) {
        const double* x = &solution_[node.scalar];
        if (!is_finite(Vec3{x[0], x[1], x[2]})) return 0;
        if (node.weight == 0) continue;  // a rotation
        longest = std::max({longest, std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])});
    }
    const double most = most_displacement(), fraction = longest > most ? most / longest : 1;
    for (Node& node : nodes_) {
        const double* x = &solution_[node.scalar];
        node.position += Vec3{x[0], x[1], x[2]} * fraction;  // pins are coupled to nothing, so theirs is 0
    }
    turn_clusters(fraction);
    return fraction;
}

/// Solves for the forces that were applied. Returns false if there are none.
bool JointSystem::substitute() {
    if (!has_applied_) return false;
    has_applied_ = false;
    solution_.swap(applied_);
    std::fill(applied_.begin(), applied_.end(), 0.0);
    matrix_.solve(solution_.data());
    return true;
}

bool JointSystem::respond() {
    if (!substitute()) return false;
    for (Link& link : links_) link.tension += solution_[link.scalar];
    take_tie_forces(true);
    advance();
    return true;
}

void JointSystem::response(uint32_t node, Vec3 (&columns)[3]) {
    for (Vec3& column : columns) column = {};
    if (!nodes_[node].free) return;
    double block[3][3];
    matrix_.inverse_block<1>({nodes_[node].scalar}, block);
    for (int k = 0; k < 3; ++k) columns[k] = {block[0][k], block[1][k], block[2][k]};
}

}  // namespace gphys
