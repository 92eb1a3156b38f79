// A substep of rigid clusters: the fit of their shapes and their contacts (clusters.h).
#include "solver/cloth/clusters.h"

#include "solver/body.h"
#include "solver/cloth/best_rotation.h"
#include "solver/cloth/cluster_pivot.h"
#include "solver/contact/friction.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// Clusters that share particles are solved one after the other, in several passes (Gauss-Seidel).
constexpr int passes_of_overlapping = 8;

/// Relative; 0 if it does not move freely.
double mass_of(const ClothState& state, const ClusterMember& member) {
    return state.acceleration[4 * size_t{member.particle} + 3];
}
Vec3 place_of(const ClothState& state, const ClusterMember& member) {
    return get(&state.at[4 * size_t{member.particle}]);
}

/// The pose of a cluster while it is solved.
class MovingCluster {
public:
    MovingCluster(ClusterRange members, const ClothState& state, ClusterResponse* response = nullptr)
        : members_(members), state_(state), response_(response) {}

    /// Finds where the shape is nearest to the particles. Returns false if none of them moves freely.
    bool fit();
    /// Applies contact impulses until no particle in contact is behind its plane. Call after fit.
    void solve_contacts(Body& body);
    /// Moves in front of contact planes, without friction. Call after fit.
    void leave_planes(const ClothContacts& planes, Clusters& clusters);
    /// The position of a member in the shape.
    Vec3 place(const ClusterMember& member) const { return at_ + rotation_ * (member.rest - rest_); }
    /// Adds up the pulls of the cluster on its particles, when these are moved to their places in the shape.
    void add_pulls(ChainContacts& in_chains, const Vector<ClusterContact>& contacts) const;

private:
    /// The same before its contacts were solved.
    Vec3 place_before(const ClusterMember& member) const {
        if (!response_) return place_of(state_, member);
        return response_->centre + response_->rotation * (member.rest - response_->rest);
    }
    void take_pose();
    void find_inertia();
    void apply_impulse(Vec3 impulse, Vec3 arm) {
        const Vec3 torque = cross(arm, impulse);
        if (!response_) {
            shift_ += impulse * inverse_mass_;
            turn_ += inverse_inertia_ * torque;
            return;
        }
        response_->impulse += impulse;
        response_->angular_impulse += torque;
        shift_ += response_->shift_by_force * impulse + response_->shift_by_torque * torque;
        turn_ += transpose_times(response_->shift_by_torque, impulse) + response_->turn_by_torque * torque;
    }
    double inverse_effective_mass(Vec3 direction, Vec3 arm) const {
        const Vec3 lever = cross(arm, direction);
        if (!response_) return inverse_mass_ + dot(lever, inverse_inertia_ * lever);
        return dot(direction, response_->shift_by_force * direction + response_->shift_by_torque * lever * 2) +
               dot(lever, response_->turn_by_torque * lever);
    }
    Vec3 displacement(Vec3 arm) const { return shift_ + cross(turn_, arm); }
    void list_contacts(Body& body);
    void sweep_contacts(Clusters& clusters);
    double solve_normal(ClusterContact& contact);
    void solve_friction(ClusterContact& contact);
    void apply_displacement();

    const ClusterRange members_;
    const ClothState& state_;
    uint32_t held_ = 0;  // number of members that do not move freely
    Vec3 at_, rest_;     // the point that it turns about, and this point in the shape
    Mat3 rotation_;
    double inverse_mass_ = 0;  // 1 / mass
    double weight_ = 0;        // of members that do not move freely, in the inertia
    double size_ = 0;          // metres: root mean square distance of the particles from that point
    Mat3 inverse_inertia_;
    ClusterResponse* const response_;  // in place of inverse mass and inertia, if it is joined
    Vec3 shift_, turn_;                // by contacts: displacement, and rotation vector
};

/// Where the joints have moved it.
void MovingCluster::take_pose() {
    double mass = 0, moment = 0;
    for (const ClusterMember& member : members_) {
        mass += mass_of(state_, member);
        moment += mass_of(state_, member) * length_squared(member.rest - response_->rest);
    }
    at_ = response_->centre;
    rest_ = response_->rest;
    rotation_ = response_->rotation;
    size_ = std::sqrt(moment / mass);
}

bool MovingCluster::fit() {
    if (response_) return take_pose(), true;
    ClusterPivot pivot;
    for (const ClusterMember& member : members_)
        pivot.add(place_of(state_, member), member.rest, mass_of(state_, member));
    if (!pivot.moves()) return false;
    held_ = pivot.held_count();
    at_ = pivot.at();
    rest_ = pivot.rest();
    inverse_mass_ = pivot.inverse_mass();

    Covariance free, held;
    double free_size = 0, held_size = 0;
    for (const ClusterMember& member : members_) {
        const double m = mass_of(state_, member);
        const Vec3 local = member.rest - rest_;
        (m > 0 ? free : held).add(place_of(state_, member) - at_, local, m > 0 ? m : 1);
        (m > 0 ? free_size : held_size) += length_squared(local) * (m > 0 ? m : 1);
    }
    size_ = std::sqrt(free_size / pivot.mass());
    weight_ = weight_of_held(free_size, held_size, pivot.mass());
    free.add(held, weight_);
    rotation_ = best_rotation(free.matrix);
    return true;
}

void MovingCluster::find_inertia() {
    if (response_) return;
    SecondMoments moments;
    for (const ClusterMember& member : members_) {
        const double m = mass_of(state_, member);
        moments.add(rotation_ * (member.rest - rest_), m > 0 ? m : weight_);
    }
    inverse_inertia_ = moments.inverse_inertia();
}

/// Lists the particles in contact before the chains. Other particles are projected one by one, after the chains.
void MovingCluster::list_contacts(Body& body) {
    const ClothContacts& cloth_contacts = body.cloth.contacts;
    Vector<ClusterContact>& contacts = body.cloth.clusters.contacts;
    contacts.clear();
    for (const ClusterMember& member : members_) {
        const uint32_t number = cloth_contacts.candidate_of[member.particle];
        if (number == ClothContacts::none || mass_of(state_, member) == 0) continue;
        const ClothContact& n = cloth_contacts.candidates[number];
        if (n.active_plane < 0) continue;
        const ContactPlane& plane = n.planes[n.active_plane];
        const Friction friction = friction_coefficients(body, member.particle);
        const double m = mass_of(state_, member);
        const Vec3 start = get(&state_.start[4 * size_t{member.particle}]);
        const Vec3 pull = get(&body.cloth.in_chains.pulls[4 * size_t{member.particle}]);
        ClusterContact contact;
        contact.member = static_cast<uint32_t>(&member - members_.first);
        contact.arm = rotation_ * (member.rest - rest_);
        contact.normal = plane.normal;
        contact.gap = dot(plane.normal, at_ + contact.arm) - plane.offset;
        contact.slip = at_ + contact.arm - place_on_plane(n, body.cloth.moving_colliders, start);
        contact.friction = n.rest_slip >= 0 ? friction.at_rest : friction.kinetic;
        contact.friction_before = n.friction_before * m;
        contact.normal_before = contact.normal_impulse =
            std::max(0.0, (n.normal_displacement + n.pressed) * m - dot(pull, plane.normal));
        contacts.push_back(contact);
    }
}

/// Corrects the normal impulse so that the particle is on its contact plane; the accumulated impulse stays positive.
/// Returns the displacement of the particle, in metres.
double MovingCluster::solve_normal(ClusterContact& contact) {
    if (contact.inverse_effective_mass == 0) return 0;
    const double gap = contact.gap + dot(contact.normal, displacement(contact.arm));
    const double accumulated = std::max(0.0, contact.normal_impulse - gap / contact.inverse_effective_mass);
    const double change = accumulated - contact.normal_impulse;
    contact.normal_impulse = accumulated;
    apply_impulse(contact.normal * change, contact.arm);
    return std::fabs(change) * contact.inverse_effective_mass;
}

/// Corrects the friction impulse so that it cancels the slip; Coulomb's law bounds the accumulated impulse.
void MovingCluster::solve_friction(ClusterContact& contact) {
    Vec3 slip = contact.slip + displacement(contact.arm);
    slip -= contact.normal * dot(contact.normal, slip);
    const double size = length(slip),
                 most = std::max(0.0, contact.friction * contact.normal_impulse - contact.friction_before);
    Vec3 accumulated = contact.friction_impulse;
    if (size > 0) {
        const double inverse_mass = inverse_effective_mass(slip / size, contact.arm);
        if (inverse_mass > 0) accumulated -= slip / inverse_mass;
    }
    const double magnitude = length(accumulated);
    if (magnitude > most) accumulated *= most / magnitude;
    apply_impulse(accumulated - contact.friction_impulse, contact.arm);
    contact.friction_impulse = accumulated;
}

/// Projected Gauss-Seidel on the impulses of all contacts, linear in the small displacement of the shape.
void MovingCluster::sweep_contacts(Clusters& clusters) {
    // Each pass over clusters that share particles starts with the impulses of the last one, and their neighbours
    // change what they found. So the sweeps of one cluster are spread over the passes.
    constexpr int sweeps_alone = 32, sweeps_in_pass = sweeps_alone / passes_of_overlapping;
    constexpr double rounding = 1e-8;  // relative to the size of the cluster, below that of float32 positions
    // Sweeps that change so little, and hardly less than the ones before, go around in a circle: where contacts cannot
    // all hold, as those of a face with friction, each undoes what the last one did.
    constexpr double little = 1e-6, hardly_less = 0.97;
    for (ClusterContact& contact : clusters.contacts)
        contact.inverse_effective_mass = inverse_effective_mass(contact.normal, contact.arm);
    const int most_sweeps = clusters.overlap && !response_ ? sweeps_in_pass : sweeps_alone;
    double largest = infinity, before = infinity;
    const auto circles = [&] { return largest < little * size_ && largest > hardly_less * before; };
    for (int sweep = 0; sweep < most_sweeps && largest > rounding * size_ && !circles(); ++sweep) {
        before = largest;
        largest = 0;
        for (ClusterContact& contact : clusters.contacts) {
            largest = std::max(largest, solve_normal(contact));
            if (contact.friction > 0) solve_friction(contact);
        }
    }
    apply_displacement();
}

void MovingCluster::solve_contacts(Body& body) {
    Vector<ClusterContact>& contacts = body.cloth.clusters.contacts;
    list_contacts(body);
    if (contacts.empty()) return;
    find_inertia();
    if (response_) {  // else the fit has shared it out
        for (const ClusterContact& contact : contacts)
            apply_impulse(contact.normal * contact.normal_before, contact.arm);
    }
    sweep_contacts(body.cloth.clusters);
    for (const ClusterContact& contact : contacts) {
        const uint32_t particle = members_.first[contact.member].particle;
        ClothContact& n = body.cloth.contacts.candidates[body.cloth.contacts.candidate_of[particle]];
        n.friction_before += length(contact.friction_impulse) * state_.at[4 * size_t{particle} + 3];
        n.cluster_impulse = contact.normal_impulse;
        // A particle without a normal impulse is not in contact. Friction must not hold it, or planks would stick to
        // what they tilt off.
        if (contact.normal_impulse == 0) {
            n.active_plane = -1;
            n.pressed = 0;
            put(&body.cloth.in_chains.normals[4 * size_t{particle}], {});
        }
    }
}

void MovingCluster::leave_planes(const ClothContacts& planes, Clusters& clusters) {
    clusters.contacts.clear();
    for (const ClusterMember& member : members_) {
        const uint32_t number = planes.candidate_of[member.particle];
        if (number == ClothContacts::none || mass_of(state_, member) == 0) continue;
        const ClothContact& n = planes.candidates[number];
        if (n.plane_count == 0) continue;
        ClusterContact contact{};
        contact.arm = rotation_ * (member.rest - rest_);
        double depth;
        contact.normal = n.planes[deepest_plane(n, at_ + contact.arm, depth)].normal;
        contact.gap = -depth;
        clusters.contacts.push_back(contact);
    }
    find_inertia();
    sweep_contacts(clusters);
}

void MovingCluster::apply_displacement() {
    at_ += shift_;
    const Vec3 half = turn_ / 2;
    rotation_ = rotation_matrix(Quat{half.x, half.y, half.z, 1}) * rotation_;
}

/// The displacement of a free particle is the sum of its pull and its contact impulses. The pulls on particles that do
/// not move freely balance the force and the torque of the others.
void MovingCluster::add_pulls(ChainContacts& in_chains, const Vector<ClusterContact>& contacts) const {
    const auto pull_on = [&](const ClusterMember& member) { return &in_chains.pulls[4 * size_t{member.particle}]; };
    Vec3 force, torque;
    auto contact = contacts.begin();
    for (uint32_t i = 0; i < members_.size(); ++i) {
        const ClusterMember& member = members_.first[i];
        const double m = mass_of(state_, member);
        if (m == 0) continue;
        Vec3 pull = (place(member) - place_before(member)) * m;
        if (contact != contacts.end() && contact->member == i) {
            const double before = response_ ? 0 : contact->normal_before;  // in place_before
            pull -= contact->normal * (contact->normal_impulse - before) + contact->friction_impulse;
            ++contact;
        }
        put(pull_on(member), get(pull_on(member)) + pull);
        force += pull;
        torque += cross(place(member) - at_, pull);
    }
    if (held_ == 0) return;
    SecondMoments moments;
    for (const ClusterMember& member : members_) {
        if (mass_of(state_, member) == 0) moments.add(place_of(state_, member) - at_, 1);
    }
    const LeastForces shares(force, torque, held_, moments);
    for (const ClusterMember& member : members_) {
        if (mass_of(state_, member) > 0) continue;
        put(pull_on(member), get(pull_on(member)) - shares.at(place_of(state_, member) - at_));
    }
}

void put_on_shape(const MovingCluster& cluster, ClusterRange members, ClothState& state) {
    for (const ClusterMember& member : members) {
        if (mass_of(state, member) > 0)
            put(&state.at[4 * size_t{member.particle}], cluster.place(member), farthest_in_cloth);
    }
}

/// visit(members, number of the pass)
template <class Visit>
void sweep_clusters(const Clusters& clusters, Visit&& visit) {
    for (int pass = 0; pass < (clusters.overlap ? passes_of_overlapping : 1); ++pass)
        each_cluster(clusters, [&](ClusterRange members) { visit(members, pass); });
}

}  // namespace

void reserve_clusters(Clusters& clusters, uint32_t particles) {
    clusters.first_member.assign(particles, Clusters::none);
    clusters.overlap = false;
    uint32_t largest = 0;
    each_cluster(clusters, [&](ClusterRange members) { largest = std::max(largest, members.size()); });
    clusters.contacts.reserve(largest);
    clusters.impacts.clear();
    clusters.impacts.reserve(2 * clusters.members.size());
    clusters.responses.clear();
    clusters.responses.reserve(clusters.ids.size());
    each_cluster(clusters, [&](ClusterRange members) {
        for (const ClusterMember& member : members) {
            uint32_t& first = clusters.first_member[member.particle];
            clusters.overlap = clusters.overlap || first != Clusters::none;
            if (first == Clusters::none) first = static_cast<uint32_t>(members.first - clusters.members.data());
        }
    });
}

ClusterResponse* response_of(Clusters& clusters, uint32_t cluster) {
    const auto end = clusters.responses.end();
    const auto response =
        std::lower_bound(clusters.responses.begin(), end, cluster,
                         [](const ClusterResponse& of, uint32_t wanted) { return of.cluster < wanted; });
    return response != end && response->cluster == cluster ? &*response : nullptr;
}

ClusterRange cluster_with(const Clusters& clusters, uint32_t particle) {
    const ClusterMember *const first = &clusters.members[clusters.first_member[particle]], *const end =
                                                                                               clusters.members.data() +
                                                                                               clusters.members.size();
    const auto is_other = [&](const ClusterMember& member) { return member.cluster != first->cluster; };
    return {first, std::find_if(first, end, is_other)};
}

void solve_clusters(Body& body, bool pulls_count) {
    Clusters& clusters = body.cloth.clusters;
    ClothState& state = body.cloth.state;
    const bool in_contact = body.cloth.contacts.any_active();
    clusters.contacts.clear();
    sweep_clusters(clusters, [&](ClusterRange members, int pass) {
        ClusterResponse* const response = response_of(clusters, members.first->cluster);
        if (response && pass > 0) return;  // it shares no particles
        MovingCluster cluster(members, state, response);
        if (!cluster.fit()) return;
        if (in_contact) cluster.solve_contacts(body);
        if (pulls_count) cluster.add_pulls(body.cloth.in_chains, clusters.contacts);
        put_on_shape(cluster, members, state);
    });
}

void push_out_clusters(Body& body) {
    Cloth& cloth = body.cloth;
    ClothState& state = cloth.state;
    // It would open joints, whose systems move them (joints/joined_contacts.cpp).
    if (body.plan.joined || !std::exchange(cloth.contacts.clusters_pushed, false)) return;
    sweep_clusters(cloth.clusters, [&](ClusterRange members, int) {
        MovingCluster cluster(members, state);
        if (!cluster.fit()) return;
        cluster.leave_planes(cloth.contacts, cloth.clusters);
        put_on_shape(cluster, members, state);
    });
}

void project_clusters(const Clusters& clusters, ClothState& state) {
    sweep_clusters(clusters, [&](ClusterRange members, int) {
        MovingCluster cluster(members, state);
        if (cluster.fit()) put_on_shape(cluster, members, state);
    });
}

}  // namespace gphys
