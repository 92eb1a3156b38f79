// Contact planes push out particles of a joined cluster one by one, where its contacts have not brought it in front of
// them: other clusters of its system have moved it since, or their response was not linear. At the end of a substep the
// system moves all its clusters as wholes instead, without speed: Newton's method closes the joints from where the
// particles are, and impulses of the contact planes, found by projected Gauss-Seidel, act on all clusters together. What
// is not linear in that is left to the next round.
#include "solver/body_table.h"
#include "solver/contact/collision.h"
#include "solver/joints/joints.h"
#include "solver/quads.h"

namespace gphys {

/// As gather, but everything is predicted where it is, and elastic links and bends keep the lengths and the shapes that
/// they have.
void JointSystem::gather_placed(const BodyTable& bodies, const Vector<Joint>& joints, double h) {
    gather(bodies, joints, h);
    for (Node& node : nodes_) {
        if (node.particle != of_pose) node.predicted = node.before = node.position;
    }
    for (Link& link : links_) {
        link.tension = 0;
        if (link.compliance == 0) continue;
        const Vec3 between = nodes_[link.b].position - nodes_[link.a].position;
        const double present = link.axis == along ? length(between) : between[link.axis];
        link.rest = link.limit ? std::max(link.rest, present) : present;
    }
    for (NodeBend& bend : bends_) bend.keeps_shape = true;
}

/// Returns whether any member is behind its plane.
bool JointSystem::list_pushes(const BodyTable& bodies, const CollisionContext& around) {
    constexpr double rounding = 1e-7;  // relative to the size of the cluster
    bool behind = false;
    pushes_.clear();
    for (uint32_t i = 0; i < clusters_.size(); ++i) {
        const JoinedCluster& cluster = clusters_[i];
        const Body& body = bodies[cluster.body];
        if (!cluster.free || !collides(body, around)) continue;
        const ClothContacts& contacts = body.cloth.contacts;
        const Vec3 centre = nodes_[cluster.centre].position - body.cloth.state.origin;
        for (const ClusterMember& member : members_of(body.cloth.clusters, cluster.cluster)) {
            const uint32_t number = contacts.candidate_of[member.particle];
            if (number == ClothContacts::none || body.particles.pinned(member.particle)) continue;
            const ClothContact& n = contacts.candidates[number];
            if (n.plane_count == 0) continue;
            PlanePush push{};
            push.cluster = i;
            push.arm = cluster.rotation * (member.rest - cluster.rest);
            double depth;
            push.normal = n.planes[deepest_plane(n, centre + push.arm, depth)].normal;
            push.gap = -depth;
            pushes_.push_back(push);
            behind = behind || depth > rounding * cluster.size;
        }
    }
    return behind;
}

/// Returns the largest displacement of a member relative to the size of its cluster.
double JointSystem::sweep_pushes(BodyTable& bodies) {
    double largest = 0;
    PlanePush* const end = pushes_.data() + pushes_.size();
    for (PlanePush* push = pushes_.data(); push != end;) {
        const JoinedCluster& cluster = clusters_[push->cluster];
        ClusterResponse& response = *response_of(bodies[cluster.body].cloth.clusters, cluster.cluster);
        Vec3 shift, turn, impulse, angular_impulse;
        const auto move = [&](Vec3 by, Vec3 torque) {
            shift += response.shift_by_force * by + response.shift_by_torque * torque;
            turn += transpose_times(response.shift_by_torque, by) + response.turn_by_torque * torque;
        };
        if (couples_clusters()) {
            displacement(response, shift, turn);
        } else {
            move(response.impulse, response.angular_impulse);
        }
        for (const uint32_t number = push->cluster; push != end && push->cluster == number; ++push) {
            const Vec3 lever = cross(push->arm, push->normal);
            if (push->inverse_mass == 0) {
                push->inverse_mass = dot(push->normal, response.shift_by_force * push->normal +
                                                           response.shift_by_torque * lever * 2) +
                                     dot(lever, response.turn_by_torque * lever);
            }
            if (!(push->inverse_mass > 0)) continue;
            const double gap = push->gap + dot(push->normal, shift + cross(turn, push->arm)),
                         accumulated = std::max(0.0, push->impulse - gap / push->inverse_mass),
                         change = accumulated - push->impulse;
            push->impulse = accumulated;
            move(push->normal * change, lever * change);
            impulse += push->normal * change;
            angular_impulse += lever * change;
            largest = std::max(largest, std::fabs(change) * push->inverse_mass / cluster.size);
        }
        response.impulse += impulse;
        response.angular_impulse += angular_impulse;
        if (couples_clusters()) add_impulse(response, impulse, angular_impulse);
    }
    return largest;
}

/// Applies impulses to the clusters after which no member is behind its plane, to first order.
void JointSystem::solve_pushes(BodyTable& bodies, uint32_t system) {
    constexpr int most_sweeps = 32;
    constexpr double tolerance = 1e-8;
    for (const JoinedCluster& cluster : clusters_) bodies[cluster.body].cloth.clusters.responses.clear();
    for (size_t i = 0; i < pushes_.size(); ++i) {
        if (i > 0 && pushes_[i].cluster == pushes_[i - 1].cluster) continue;
        const JoinedCluster& cluster = clusters_[pushes_[i].cluster];
        Body& body = bodies[cluster.body];
        add_cluster_response(body, cluster.body, cluster.cluster, system, body.cloth.clusters.responses);
    }
    if (couples_clusters()) begin_impulses();
    for (int sweep = 0; sweep < most_sweeps && sweep_pushes(bodies) > tolerance; ++sweep) {}
    for (const JoinedCluster& cluster : clusters_) {
        Vector<ClusterResponse>& responses = bodies[cluster.body].cloth.clusters.responses;
        apply_contact_impulses(cluster.body, responses);
        responses.clear();
    }
}

void JointSystem::push_out_clusters(BodyTable& bodies, const Vector<Joint>& joints, const CollisionContext& around,
                                    double h, uint32_t system) {
    // Each is linear, and squares the error.
    constexpr int most_rounds = 8;
    if (clusters_.empty()) return;
    gather_placed(bodies, joints, h);
    bool solved = solve();
    for (int round = 0; round < most_rounds && solved && list_pushes(bodies, around); ++round) {
        solve_pushes(bodies, system);
        solved = solve();
    }
    if (solved) scatter(bodies);
}

}  // namespace gphys
