// Contacts of all clusters of a system with models at once, by projected Gauss-Seidel. What an impulse on one of them
// moves, by their joints, moves the contacts of the others. Each cluster has solved its contacts alone, to first order,
// with the inertia of what is joined to it (clusters.cpp). Where the others have moved it since, this goes on from its
// impulses, adding to them or taking back. What is not linear is left to the next round.
//
// Else contact planes would push out its particles one by one, off its shape, and with velocities that do not belong
// together. What still gets there, the system removes at the end of the substep: Newton's method closes the joints from
// where the particles are, with impulses of contact planes, and velocities change by what that moves particles.
#include "solver/body_table.h"
#include "solver/contact/collision.h"
#include "solver/contact/friction.h"
#include "solver/joints/joints.h"
#include "solver/quads.h"
#include "solver/time_scheme.h"

namespace gphys {
namespace {

// Each solves a linear problem, and squares the error.
constexpr int most_rounds = 8;
// Relative to the sizes of clusters.
constexpr double rounding = 1e-7;
// Of the motion of a substep: what particles that were behind planes before need.
constexpr double most_gain = 1.1;

double mass_of(const ClothState& state, uint32_t particle) { return state.acceleration[4 * size_t{particle} + 3]; }

}  // namespace

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

/// Lists the members that have contact planes. `acting`: whether their contacts act in this substep, with friction and
/// from their impulses on. Returns how far the deepest is behind its plane, relative to the size of its cluster.
double JointSystem::list_contacts(const BodyTable& bodies, const CollisionContext& around, bool acting) {
    double deepest = 0;
    contacts_.clear();
    for (uint32_t i = 0; i < clusters_.size(); ++i) {
        const JoinedCluster& cluster = clusters_[i];
        const Body& body = bodies[cluster.body];
        if (!cluster.free || !collides(body, around)) continue;
        const ClothState& state = body.cloth.state;
        const Vec3 centre = nodes_[cluster.centre].position - state.origin;
        for (const ClusterMember& member : members_of(body.cloth.clusters, cluster.cluster)) {
            const uint32_t number = body.cloth.contacts.candidate_of[member.particle];
            const double mass = mass_of(state, member.particle);
            if (number == ClothContacts::none || mass == 0) continue;
            const ClothContact& n = body.cloth.contacts.candidates[number];
            if (n.plane_count == 0) continue;
            MemberContact contact{};
            contact.cluster = i;
            contact.candidate = number;
            contact.arm = cluster.rotation * (member.rest - cluster.rest);
            const Vec3 at = centre + contact.arm;
            double depth;
            contact.plane = static_cast<int32_t>(deepest_plane(n, at, depth));
            contact.normal = n.planes[contact.plane].normal;
            contact.gap = -depth;
            deepest = std::max(deepest, depth / cluster.size);
            const bool active = acting && n.active_plane >= 0;
            if (!active || n.active_plane != contact.plane) contacts_.push_back(contact);
            if (!active) continue;
            contact.plane = n.active_plane;
            contact.normal = n.planes[contact.plane].normal;
            contact.gap = dot(contact.normal, at) - n.planes[contact.plane].offset;
            contact.impulse_before = n.cluster_impulse;
            const Vec3 start = get(&state.start[4 * size_t{member.particle}]);
            contact.slip = at - place_on_plane(n, body.cloth.moving_colliders, start);
            const Friction friction = friction_coefficients(body, member.particle);
            contact.friction = n.rest_slip >= 0 ? friction.at_rest : friction.kinetic;
            contact.friction_room = contact.friction * contact.impulse_before - n.friction_before * mass;
            contacts_.push_back(contact);
        }
    }
    return deepest;
}

/// Returns the largest displacement of a member by its normal impulse, relative to the size of its cluster.
double JointSystem::sweep_contacts(BodyTable& bodies) {
    double largest = 0;
    MemberContact* const end = contacts_.data() + contacts_.size();
    for (MemberContact* contact = contacts_.data(); contact != end;) {
        const JoinedCluster& cluster = clusters_[contact->cluster];
        ClusterResponse& response = *response_of(bodies[cluster.body].cloth.clusters, cluster.cluster);
        Vec3 shift, turn, impulse, angular_impulse;
        const auto move = [&](Vec3 by, Vec3 torque) {
            shift += response.shift_by_force * by + response.shift_by_torque * torque;
            turn += transpose_times(response.shift_by_torque, by) + response.turn_by_torque * torque;
        };
        const auto apply = [&](Vec3 by, Vec3 arm) {
            const Vec3 torque = cross(arm, by);
            move(by, torque);
            impulse += by;
            angular_impulse += torque;
        };
        const auto inverse_mass = [&](Vec3 direction, Vec3 arm) {
            const Vec3 lever = cross(arm, direction);
            return dot(direction, response.shift_by_force * direction + response.shift_by_torque * lever * 2) +
                   dot(lever, response.turn_by_torque * lever);
        };
        if (couples_clusters()) {
            displacement(response, shift, turn);
        } else {
            move(response.impulse, response.angular_impulse);
        }
        for (const uint32_t number = contact->cluster; contact != end && contact->cluster == number; ++contact) {
            MemberContact& c = *contact;
            if (c.inverse_mass == 0) c.inverse_mass = inverse_mass(c.normal, c.arm);
            if (!(c.inverse_mass > 0)) continue;
            const double gap = c.gap + dot(c.normal, shift + cross(turn, c.arm)),
                         accumulated = std::max(-c.impulse_before, c.impulse - gap / c.inverse_mass),
                         change = accumulated - c.impulse;
            c.impulse = accumulated;
            apply(c.normal * change, c.arm);
            largest = std::max(largest, std::fabs(change) * c.inverse_mass / cluster.size);
            if (!(c.friction > 0)) continue;
            Vec3 slip = c.slip + shift + cross(turn, c.arm);
            slip -= c.normal * dot(c.normal, slip);
            const double size = length(slip), most = std::max(0.0, c.friction_room + c.friction * c.impulse);
            Vec3 friction = c.friction_impulse;
            if (size > 0) {
                const double along = inverse_mass(slip / size, c.arm);
                if (along > 0) friction -= slip / along;
            }
            const double magnitude = length(friction);
            if (magnitude > most) friction *= most / magnitude;
            apply(friction - c.friction_impulse, c.arm);
            c.friction_impulse = friction;
        }
        response.impulse += impulse;
        response.angular_impulse += angular_impulse;
        if (couples_clusters()) add_impulse(response, impulse, angular_impulse);
    }
    return largest;
}

/// Applies impulses to the clusters after which no member is behind its plane, to first order.
void JointSystem::solve_contacts(BodyTable& bodies, uint32_t system) {
    constexpr int most_sweeps = 32;
    constexpr double tolerance = 1e-8;
    for (const JoinedCluster& cluster : clusters_) bodies[cluster.body].cloth.clusters.responses.clear();
    for (size_t i = 0; i < contacts_.size(); ++i) {
        if (i > 0 && contacts_[i].cluster == contacts_[i - 1].cluster) continue;
        const JoinedCluster& cluster = clusters_[contacts_[i].cluster];
        Body& body = bodies[cluster.body];
        add_cluster_response(body, cluster.body, cluster.cluster, system, body.cloth.clusters.responses);
    }
    if (couples_clusters()) begin_impulses();
    for (int sweep = 0; sweep < most_sweeps && sweep_contacts(bodies) > tolerance; ++sweep) {
    }
    for (const JoinedCluster& cluster : clusters_) {
        Vector<ClusterResponse>& responses = bodies[cluster.body].cloth.clusters.responses;
        apply_contact_impulses(cluster.body, responses);
        responses.clear();
    }
}

/// For the friction of single particles, and for what models get.
void JointSystem::note_contact_impulses(BodyTable& bodies, double h) const {
    for (const MemberContact& contact : contacts_) {
        Body& body = bodies[clusters_[contact.cluster].body];
        ClothContact& n = body.cloth.contacts.candidates[contact.candidate];
        const bool active = n.active_plane == contact.plane;
        if (active && contact.impulse_before + contact.impulse <= 0) {
            n.active_plane = -1;  // as in clusters.cpp
            n.pressed = 0;
            continue;
        }
        if (contact.impulse == 0 && contact.friction_impulse == Vec3{}) continue;
        if (n.active_plane < 0) activate_plane(body, n, contact.plane, TimeScheme(h, body.history.earlier_step));
        float* const pull = &body.cloth.in_chains.pulls[4 * size_t{n.particle}];
        put(pull, get(pull) - contact.normal * contact.impulse - contact.friction_impulse);
        n.friction_before += length(contact.friction_impulse) / mass_of(body.cloth.state, n.particle);
        n.cluster_impulse += contact.impulse;
    }
}

void JointSystem::solve_cluster_contacts(BodyTable& bodies, const CollisionContext& around, double h, uint32_t system) {
    const auto depth_of_listed = [&] {
        double deepest = 0;
        const ClusterMember* member = nullptr;
        for (size_t i = 0; i < contacts_.size(); ++i) {
            const JoinedCluster& cluster = clusters_[contacts_[i].cluster];
            const Cloth& cloth = bodies[cluster.body].cloth;
            if (i == 0 || contacts_[i].cluster != contacts_[i - 1].cluster)
                member = members_of(cloth.clusters, cluster.cluster).first;
            const ClothContact& n = cloth.contacts.candidates[contacts_[i].candidate];
            while (member->particle != n.particle) ++member;
            const Vec3 centre = nodes_[cluster.centre].position - cloth.state.origin;
            double depth;
            deepest_plane(n, centre + cluster.rotation * (member->rest - cluster.rest), depth);
            deepest = std::max(deepest, depth / cluster.size);
        }
        return deepest;
    };
    // Kinetic energy of the displacements of all members, relative, and whether only contacts at rest act on them.
    const auto motion = [&](bool& at_rest) {
        double sum = 0;
        for (const JoinedCluster& cluster : clusters_) {
            if (!cluster.free) continue;
            const Cloth& cloth = bodies[cluster.body].cloth;
            at_rest = at_rest && cloth.moving_colliders.empty();
            const Vec3 centre = nodes_[cluster.centre].position - cloth.state.origin;
            for (const ClusterMember& member : members_of(cloth.clusters, cluster.cluster)) {
                const Vec3 at = centre + cluster.rotation * (member.rest - cluster.rest);
                sum += length_squared(at - get(&cloth.state.start[4 * size_t{member.particle}])) *
                       mass_of(cloth.state, member.particle) * bodies[cluster.body].cloth.state.average_mass;
            }
        }
        return sum;
    };
    const auto take_back = [&] {
        for (const MemberContact& contact : contacts_) {
            const JoinedCluster& cluster = clusters_[contact.cluster];
            const Vec3 impulse = contact.normal * contact.impulse + contact.friction_impulse;
            apply_force(cluster.centre, impulse * -cluster.scale);
            apply_force(cluster.turn, cross(contact.arm, impulse) * -cluster.scale);
        }
        for (Node& node : nodes_) node.position = node.start;
        place_clusters();
        solve();
    };
    double deepest = list_contacts(bodies, around, true);
    for (int round = 0; round < most_rounds && deepest > rounding; ++round) {
        bool at_rest = true;
        const double before = motion(at_rest);
        solve_contacts(bodies, system);
        solve();
        // Where a limb is stretched or jams, the response is not linear, and impulses would throw it about. What rests
        // only takes energy.
        if (depth_of_listed() > deepest / 2 || (at_rest && motion(at_rest) > most_gain * before)) {
            take_back();
            break;
        }
        note_contact_impulses(bodies, h);
        scatter(bodies);
        deepest = list_contacts(bodies, around, true);
    }
}

void JointSystem::push_out_clusters(BodyTable& bodies, const Vector<Joint>& joints, const CollisionContext& around,
                                    double h, uint32_t system) {
    // Of what particles are off their shapes: a jammed limb would have to be thrown aside, and stays as it is.
    constexpr double most_moved = 4;
    if (clusters_.empty()) return;
    const auto farthest = [&] {
        double most = 0;
        for (const JoinedCluster& cluster : clusters_) {
            if (!cluster.free) continue;
            const Cloth& cloth = bodies[cluster.body].cloth;
            const Vec3 centre = nodes_[cluster.centre].position - cloth.state.origin;
            for (const ClusterMember& member : members_of(cloth.clusters, cluster.cluster)) {
                const Vec3 place = centre + cluster.rotation * (member.rest - cluster.rest);
                most = std::max(most, distance(place, get(&cloth.state.at[4 * size_t{member.particle}])));
            }
        }
        return most;
    };
    gather_placed(bodies, joints, h);
    const double off = farthest();
    bool solved = solve();
    double deepest = list_contacts(bodies, around, false);
    for (int round = 0; round < most_rounds && solved && deepest > rounding; ++round) {
        solve_contacts(bodies, system);
        solved = solve();
        const double before = deepest;
        deepest = list_contacts(bodies, around, false);
        solved = solved && deepest < std::max(before / 2, rounding);
    }
    if (!solved || farthest() > most_moved * off) return;
    // Else pushed particles would keep the speed of a push that has been taken back.
    for (const JoinedCluster& cluster : clusters_) {
        if (!cluster.free) continue;
        Cloth& cloth = bodies[cluster.body].cloth;
        const Vec3 centre = nodes_[cluster.centre].position - cloth.state.origin;
        for (const ClusterMember& member : members_of(cloth.clusters, cluster.cluster)) {
            const size_t i = 4 * size_t{member.particle};
            if (mass_of(cloth.state, member.particle) == 0) continue;
            const Vec3 place = centre + cluster.rotation * (member.rest - cluster.rest);
            put(&cloth.state.velocity[i], get(&cloth.state.velocity[i]) + (place - get(&cloth.state.at[i])) / h);
        }
    }
    scatter(bodies);
}

}  // namespace gphys
