// Rigid clusters in the systems of joints: each is a rigid body with six unknowns, the displacement of its centre of
// mass and its rotation (Newton's method on the pose; the rotation is updated by composition, Simo & Vu-Quoc 1986).
// Ties keep the joined particles at their places in it. So a joint acts on the mass and the inertia of the whole
// cluster at once. If it acted on the mass of one particle, a light plank under a heavy load would leave its joints in
// long substeps.
//
// A cluster with pinned particles turns about these (cluster_pivot.h), so its centre does not move. Clusters of bodies
// with attached particles, if they have pinned or attached ones, and clusters that share particles, are left to shape
// matching.
#include "solver/body_table.h"
#include "solver/cloth/best_rotation.h"
#include "solver/cloth/cluster_pivot.h"
#include "solver/contact/corrections.h"
#include "solver/joints/joints.h"
#include "solver/quads.h"
#include "solver/time_scheme.h"

namespace gphys {
namespace {

// Of the mass of a joined particle, in the pose of its cluster.
constexpr double share_of_pose = 0.5;
// Of lengths, as of links.
constexpr double tolerance = 1e-9;
// Metres: a smaller cluster is a point, and no force turns it.
constexpr double smallest = 1e-9;
// Of the sum of squares, added to the moments of inertia: see SecondMoments.
constexpr double inertia_regularisation = 1e-9;

Quat rotation_since(Vec3 gibbs) { return normalized({gibbs.x / 2, gibbs.y / 2, gibbs.z / 2, 1}); }

Mat3 scaled(const Mat3& m, double factor) { return {m.x * factor, m.y * factor, m.z * factor}; }

Mat3 sum(const Mat3& a, const Mat3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// Sylvester's criterion.
bool is_definite(const Mat3& m) {
    return m.x.x > 0 && m.x.x * m.y.y - m.x.y * m.y.x > 0 && dot(m.x, cross(m.y, m.z)) > 0;
}

double mass_of(const ClothState& state, uint32_t particle) { return state.acceleration[4 * size_t{particle} + 3]; }

double step_of(const Body& body, double h) {
    return TimeScheme(h, body.history.earlier_step).step(body.settings.damping);
}

}  // namespace

void JointSystem::add_cluster(uint32_t body, ClusterRange members) {
    JoinedCluster cluster{};
    cluster.body = body;
    cluster.cluster = members.first->cluster;
    cluster.first_member = static_cast<uint32_t>(predicted_.size());
    cluster.count = members.size();
    cluster.first_tie = static_cast<uint32_t>(ties_.size());
    for (uint32_t i = 0; i < members.size(); ++i) {
        const uint32_t particle = members.first[i].particle, node = find_node(body, particle);
        const bool joined = node < node_count() && nodes_[node].body == body && nodes_[node].particle == particle;
        cluster.extent = std::max(cluster.extent, distance(members.first[i].rest, members.first->rest));
        predicted_.push_back({});
        shares_.push_back(joined ? share_of_pose : 1);
        if (joined) ties_.push_back({node, static_cast<uint32_t>(clusters_.size()), i});
    }
    cluster.tie_count = static_cast<uint32_t>(ties_.size()) - cluster.first_tie;
    clusters_.push_back(cluster);
}

void JointSystem::plan_ways() {
    contacts_.reserve(2 * predicted_.size());
    // In a chain of clusters they grow with the square of its length, and so does the time: one of 16 has about 2000.
    constexpr size_t most_rows = 1 << 11;
    way_rows_.clear();
    ways_.clear();
    for (JoinedCluster& cluster : clusters_) {
        cluster.first_way = static_cast<uint32_t>(way_rows_.size());
        cluster.way_count = matrix_.list_way({nodes_[cluster.centre].scalar, nodes_[cluster.turn].scalar}, way_rows_);
        if (way_rows_.size() > most_rows) return;
    }
    ways_.resize(6 * way_rows_.size());
}

/// Adds rows to a column of a pose: the tie forces that are eliminated before it.
void JointSystem::list_ties_of_pose(uint32_t node, uint32_t axis, Vector<uint32_t>& rows) {
    const auto cluster = std::find_if(clusters_.begin(), clusters_.end(),
                                      [&](const JoinedCluster& c) { return c.centre == node || c.turn == node; });
    uint32_t entry = 0;
    for (uint32_t t = cluster->first_tie; t < cluster->first_tie + cluster->tie_count; ++t) {
        ClusterTie& tie = ties_[t];
        if (cluster->centre == node && tie.before_centre) {
            tie.centre_entry = entry++;
            rows.push_back(tie.scalar + axis);
        } else if (cluster->turn == node && tie.before_turn) {
            tie.turn_entry = entry;
            entry += 2;
            rows.insert(rows.end(), {tie.scalar + (axis + 1) % 3, tie.scalar + (axis + 2) % 3});
        }
    }
}

/// The columns of the forces of a tie: rows of its node, and of the pose if that is eliminated before.
void JointSystem::list_columns(ClusterTie& tie, uint32_t& scalar, Vector<uint32_t>& column_begin,
                               Vector<uint32_t>& rows) const {
    const JoinedCluster& cluster = clusters_[tie.cluster];
    const uint32_t node = nodes_[tie.node].scalar, centre = nodes_[cluster.centre].scalar,
                   turn = nodes_[cluster.turn].scalar;
    tie.scalar = scalar;
    for (uint32_t k = 0; k < 3; ++k, ++scalar) {
        rows.push_back(node + k);
        if (!tie.before_centre) rows.push_back(centre + k);
        if (!tie.before_turn) rows.insert(rows.end(), {turn + (k + 1) % 3, turn + (k + 2) % 3});
        column_begin.push_back(static_cast<uint32_t>(rows.size()));
    }
}

/// Fits the poses to the predicted positions. Call before gather_nodes.
void JointSystem::gather_clusters(const BodyTable& bodies, double h) {
    for (JoinedCluster& cluster : clusters_) {
        const Body& body = bodies[cluster.body];
        const ClothState& state = body.cloth.state;
        const ClusterRange members = members_of(body.cloth.clusters, cluster.cluster);
        const double* const share = &shares_[cluster.first_member];
        Vec3* const predicted = &predicted_[cluster.first_member];
        ClusterPivot pivot;
        for (uint32_t i = 0; i < cluster.count; ++i) {
            const ClusterMember& member = members.first[i];
            predicted[i] = get(&state.at[4 * size_t{member.particle}]);
            pivot.add(predicted[i], member.rest, mass_of(state, member.particle) * share[i]);
        }
        const bool held = pivot.held_count() > 0;
        cluster.free = pivot.moves() && (!held || body.constraints.attachments.empty());
        Node &centre = nodes_[cluster.centre], &turn = nodes_[cluster.turn];
        centre.free = cluster.free && !held;
        turn.free = cluster.free;
        centre.position = turn.position = {};
        centre.weight = turn.weight = 1;
        for (uint32_t t = cluster.first_tie; t < cluster.first_tie + cluster.tie_count; ++t)
            nodes_[ties_[t].node].share = cluster.free ? 1 - share_of_pose : 1;
        if (cluster.free) {
            cluster.rest = pivot.rest();
            Covariance covariance, of_held;
            SecondMoments moments, held_moments;
            for (uint32_t i = 0; i < cluster.count; ++i) {
                const double m = mass_of(state, members.first[i].particle) * share[i], weight = m > 0 ? m : 1;
                const Vec3 local = members.first[i].rest - cluster.rest;
                (m > 0 ? covariance : of_held).add(predicted[i] - pivot.at(), local, weight);
                (m > 0 ? moments : held_moments).add(local, weight);
            }
            const double weight = weight_of_held(moments.sum(), held_moments.sum(), pivot.mass());
            const double step = step_of(body, h), scale = state.average_mass / (step * step);
            cluster.scale = scale;
            covariance.add(of_held, weight);
            cluster.predicted = best_rotation(covariance.matrix);
            cluster.size = std::sqrt(moments.sum() / pivot.mass());
            const Mat3& r = cluster.predicted;
            centre.position = state.origin + pivot.at();
            centre.weight = pivot.mass() * scale;
            if (cluster.size > smallest) {
                turn.weight = 0;
                turn.loaded = true;
                const Mat3 inertia =
                    sum(moments.inertia(inertia_regularisation), scaled(held_moments.inertia(0), weight));
                turn.load = scaled(r * inertia * transposed(r), scale);
            }
        }
        for (Node* const node : {&centre, &turn}) node->before = node->predicted = node->position;
        for (uint32_t t = cluster.first_tie; t < cluster.first_tie + cluster.tie_count; ++t) {
            ties_[t].rest = members.first[ties_[t].member].rest - cluster.rest;
            ties_[t].force = {};
        }
    }
    place_clusters();
}

/// Finds the rotations and the arms of ties from the nodes.
void JointSystem::place_clusters() {
    for (JoinedCluster& cluster : clusters_) {
        cluster.rotation = rotation_matrix(rotation_since(nodes_[cluster.turn].position)) * cluster.predicted;
    }
    for (ClusterTie& tie : ties_) tie.arm = clusters_[tie.cluster].rotation * tie.rest;
}

/// Composes the rotations with the part of the solution that advance() has added to them.
void JointSystem::turn_clusters(double fraction) {
    // Radians in one iteration, and the tangent of half of the angle in a substep.
    constexpr double most_turn = 1, most_tangent = 10;
    for (const JoinedCluster& cluster : clusters_) {
        Node& turn = nodes_[cluster.turn];
        const double* const x = &solution_[turn.scalar];
        Vec3 by = Vec3{x[0], x[1], x[2]} * fraction;
        const Quat before = rotation_since(turn.position - by);
        const double angle = length(by);
        if (angle > most_turn) by *= most_turn / angle;
        const Quat q = rotation_since(by) * before;
        const Vec3 axis{q.x, q.y, q.z};
        turn.position = axis * (2 / std::max(q.w, length(axis) / most_tangent));
    }
    place_clusters();
}

Vec3 JointSystem::error(const ClusterTie& tie) const {
    return nodes_[tie.node].position - nodes_[clusters_[tie.cluster].centre].position - tie.arm;
}

bool JointSystem::is_active(const ClusterTie& tie) const {
    return clusters_[tie.cluster].free && nodes_[tie.node].free;
}

bool JointSystem::ties_are_converged() const {
    return std::all_of(ties_.begin(), ties_.end(), [&](const ClusterTie& tie) {
        const JoinedCluster& cluster = clusters_[tie.cluster];
        return !is_active(tie) || cluster.size <= smallest || length(error(tie)) <= tolerance * cluster.size;
    });
}

/// Adds the equations of ties, and the change of the torques of their forces with the rotation (geometric stiffness).
void JointSystem::assemble_ties() {
    for (const ClusterTie& tie : ties_) {
        const JoinedCluster& cluster = clusters_[tie.cluster];
        const uint32_t centre = nodes_[cluster.centre].scalar, turn = nodes_[cluster.turn].scalar;
        const bool active = is_active(tie);
        const double one = active ? 1 : 0, of_centre = active && nodes_[cluster.centre].free ? 1 : 0;
        const Vec3 error = this->error(tie), arm = tie.arm * one;
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t next = (k + 1) % 3, last = (k + 2) % 3;
            double* at = entries_.data() + matrix_.column_begin(tie.scalar + k);
            diagonal_[tie.scalar + k] = active ? 0 : -1;
            solution_[tie.scalar + k] = -error[static_cast<int>(k)] * one;
            *at++ = one;
            if (!tie.before_centre) *at++ = -of_centre;
            if (!tie.before_turn) at[0] = -arm[static_cast<int>(last)], at[1] = arm[static_cast<int>(next)];
            if (tie.before_centre) entries_[matrix_.column_begin(centre + k) + tie.centre_entry] = -of_centre;
            if (tie.before_turn) {
                double* const of_turn = entries_.data() + matrix_.column_begin(turn + k) + tie.turn_entry;
                of_turn[0] = arm[static_cast<int>(last)], of_turn[1] = -arm[static_cast<int>(next)];
            }
        }
    }
    for (const JoinedCluster& cluster : clusters_) {
        if (!cluster.free) continue;
        Mat3 stiffness{{}, {}, {}};
        for (uint32_t t = cluster.first_tie; t < cluster.first_tie + cluster.tie_count; ++t) {
            const Vec3 f = ties_[t].force, a = ties_[t].arm;
            const double along = dot(f, a);
            stiffness = sum(stiffness,
                            {Vec3{along, 0, 0} - (f * a.x + a * f.x) / 2, Vec3{0, along, 0} - (f * a.y + a * f.y) / 2,
                             Vec3{0, 0, along} - (f * a.z + a * f.z) / 2});
        }
        const Node& turn = nodes_[cluster.turn];
        if (!is_definite(sum(turn.load, stiffness))) continue;  // forces that turn it over, faster than it can move
        const Vec3 columns[3] = {stiffness.x, stiffness.y, stiffness.z};
        for (uint32_t k = 0; k < 3; ++k) {
            double* const above = entries_.data() + matrix_.column_begin(turn.scalar + k + 1) - k;
            diagonal_[turn.scalar + k] += columns[k][static_cast<int>(k)];
            for (uint32_t row = 0; row < k; ++row) above[row] += columns[k][static_cast<int>(row)];
        }
    }
}

/// From the solution: the forces, or with `add` their change.
void JointSystem::take_tie_forces(bool add) {
    for (ClusterTie& tie : ties_) {
        const double* const x = &solution_[tie.scalar];
        tie.force = (add ? tie.force : Vec3{}) + Vec3{x[0], x[1], x[2]};
    }
}

void JointSystem::scatter_clusters(BodyTable& bodies) const {
    for (const JoinedCluster& cluster : clusters_) {
        if (!cluster.free) continue;
        Body& body = bodies[cluster.body];
        const Vec3 centre = nodes_[cluster.centre].position - body.cloth.state.origin;
        for (const ClusterMember& member : members_of(body.cloth.clusters, cluster.cluster)) {
            if (body.particles.pinned(member.particle)) continue;
            put(&body.cloth.state.at[4 * size_t{member.particle}],
                centre + cluster.rotation * (member.rest - cluster.rest), farthest_in_cloth);
        }
    }
}

bool JointSystem::has_clusters_of(uint32_t body) const {
    return std::any_of(clusters_.begin(), clusters_.end(),
                       [&](const JoinedCluster& cluster) { return cluster.free && cluster.body == body; });
}

void JointSystem::apply_link_pulls(Body& body, uint32_t slot) {
    const ClothState& state = body.cloth.state;
    const ClothContacts& contacts = body.cloth.contacts;
    const bool in_contact = contacts.any_active();
    for (const JoinedCluster& cluster : clusters_) {
        if (!cluster.free || cluster.body != slot) continue;
        const ClusterRange members = members_of(body.cloth.clusters, cluster.cluster);
        const Vec3 centre = nodes_[cluster.centre].position - state.origin;
        Vec3 impulse, angular_impulse;
        for (uint32_t i = 0; i < cluster.count; ++i) {
            if (shares_[cluster.first_member + i] < 1) continue;
            const size_t at = 4 * size_t{members.first[i].particle};
            const Vec3 arm = cluster.rotation * (members.first[i].rest - cluster.rest);
            Vec3 pull = (get(&state.at[at]) - centre - arm) * mass_of(state, members.first[i].particle);
            if (in_contact && contacts.is_active(members.first[i].particle)) {  // contact planes have moved it, too
                pull = get(&body.cloth.in_chains.pulls[at]);
                put(&body.cloth.in_chains.pulls[at], {});
            }
            impulse += pull;
            angular_impulse += cross(arm, pull);
        }
        apply_force(cluster.centre, impulse * cluster.scale);
        apply_force(cluster.turn, angular_impulse * cluster.scale);
    }
}

/// Null if it has none. They were added in this order.
const JointSystem::JoinedCluster* JointSystem::find_cluster(uint32_t body, uint32_t cluster) const {
    const auto found = std::lower_bound(clusters_.begin(), clusters_.end(), std::pair(body, cluster),
                                        [](const JoinedCluster& of, const std::pair<uint32_t, uint32_t>& wanted) {
                                            return std::pair(of.body, of.cluster) < wanted;
                                        });
    return found != clusters_.end() && found->body == body && found->cluster == cluster ? &*found : nullptr;
}

void JointSystem::add_cluster_response(const Body& body, uint32_t slot, uint32_t number, uint32_t system,
                                       Vector<ClusterResponse>& out) {
    const JoinedCluster* const cluster = find_cluster(slot, number);
    if (!cluster || !cluster->free) return;
    const double scale = cluster->scale;
    double inverse[6][6];
    double* const way = couples_clusters() ? &ways_[6 * size_t{cluster->first_way}] : nullptr;
    matrix_.inverse_block<2>({nodes_[cluster->centre].scalar, nodes_[cluster->turn].scalar}, inverse, way);
    const auto block = [&](int row, int column) {
        const auto at = [&](int k) {
            return Vec3{inverse[row][column + k], inverse[row + 1][column + k], inverse[row + 2][column + k]} * scale;
        };
        return Mat3{at(0), at(1), at(2)};
    };
    const bool moves = nodes_[cluster->centre].free;
    const Mat3 none{{}, {}, {}};
    out.push_back({number,
                   nodes_[cluster->centre].position - body.cloth.state.origin,
                   cluster->rest,
                   cluster->rotation,
                   moves ? block(0, 0) : none,
                   moves ? block(0, 3) : none,
                   block(3, 3),
                   {},
                   {},
                   system,
                   static_cast<uint32_t>(cluster - clusters_.data())});
}

void JointSystem::add_impulse(const ClusterResponse& of, Vec3 impulse, Vec3 angular_impulse) {
    const JoinedCluster& cluster = clusters_[of.in_system];
    const Vec3 f = nodes_[cluster.centre].free ? impulse * cluster.scale : Vec3{}, t = angular_impulse * cluster.scale;
    matrix_.add_to_sum({f.x, f.y, f.z, t.x, t.y, t.z}, &way_rows_[cluster.first_way], cluster.way_count,
                       &ways_[6 * size_t{cluster.first_way}]);
}

void JointSystem::displacement(const ClusterResponse& of, Vec3& shift, Vec3& turn) const {
    const JoinedCluster& cluster = clusters_[of.in_system];
    double x[6];
    matrix_.solve_sum(x, &way_rows_[cluster.first_way], cluster.way_count, &ways_[6 * size_t{cluster.first_way}]);
    shift = nodes_[cluster.centre].free ? Vec3{x[0], x[1], x[2]} : Vec3{};
    turn = {x[3], x[4], x[5]};
}

void JointSystem::apply_contact_impulses(uint32_t slot, const Vector<ClusterResponse>& responses) {
    for (const ClusterResponse& response : responses) {
        const JoinedCluster* const cluster = find_cluster(slot, response.cluster);
        if (!cluster || !cluster->free) continue;
        apply_force(cluster->centre, response.impulse * cluster->scale);
        apply_force(cluster->turn, response.angular_impulse * cluster->scale);
    }
}

template <class Visit>
void JointSystem::each_displaced(BodyTable& bodies, Visit&& visit) {
    if (!substitute()) return;
    const auto of = [&](uint32_t node) {
        const double* const x = &solution_[nodes_[node].scalar];
        return nodes_[node].free ? Vec3{x[0], x[1], x[2]} : Vec3{};
    };
    for (uint32_t i = 0; i < node_count(); ++i) {
        const Node& node = nodes_[i];
        if (node.free && node.particle != of_pose) visit(bodies[node.body], node.particle, of(i));
    }
    for (const JoinedCluster& cluster : clusters_) {
        if (!cluster.free) continue;
        Body& body = bodies[cluster.body];
        const Vec3 shift = of(cluster.centre), turn = of(cluster.turn);
        const ClusterRange members = members_of(body.cloth.clusters, cluster.cluster);
        for (uint32_t i = 0; i < cluster.count; ++i) {
            const ClusterMember& member = members.first[i];
            if (shares_[cluster.first_member + i] < 1 || body.particles.pinned(member.particle)) continue;
            visit(body, member.particle, shift + cross(turn, cluster.rotation * (member.rest - cluster.rest)));
        }
    }
}

void JointSystem::displace_histories(BodyTable& bodies, double h) {
    each_displaced(bodies, [h](Body& body, uint32_t particle, Vec3 displacement) {
        displace_history(body, particle, displacement, h);
    });
}

void JointSystem::change_velocities(BodyTable& bodies) {
    each_displaced(bodies, [](Body& body, uint32_t particle, Vec3 faster) {
        if (is_graph(body)) {
            float* const velocity = &body.cloth.state.velocity[4 * size_t{particle}];
            put(velocity, get(velocity) + faster);
        } else {
            body.particles.velocity[particle] += faster;
        }
    });
}

void JointSystem::save_cluster_places(Body& body, uint32_t slot) const {
    ClothContacts& contacts = body.cloth.contacts;
    for (const JoinedCluster& cluster : clusters_) {
        if (!cluster.free || cluster.body != slot) continue;
        const ClusterRange members = members_of(body.cloth.clusters, cluster.cluster);
        const Vec3 centre = nodes_[cluster.centre].position - body.cloth.state.origin;
        for (uint32_t i = 0; i < cluster.count; ++i) {
            const ClusterMember& member = members.first[i];
            float* const saved = &contacts.saved[4 * size_t{member.particle}];
            const Vec3 place = centre + cluster.rotation * (member.rest - cluster.rest);
            put(saved, get(saved) - (place - predicted_[cluster.first_member + i]));
        }
    }
}

}  // namespace gphys
