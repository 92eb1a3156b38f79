// Restitution of rigid clusters that hit models. A cluster lands by single particles, which its other particles would
// stop again. So what restitution asks of the particles that have hit is given to the cluster as a whole: impulses at
// these particles after which each of them leaves its model with its part of the speed of approach (Newton's law),
// found by projected Gauss-Seidel. Friction of these impulses is bounded by Coulomb's law.
#include <tuple>

#include "solver/body.h"
#include "solver/cloth/cluster_pivot.h"
#include "solver/cloth/clusters.h"
#include "solver/contact/impulses.h"
#include "solver/quads.h"

namespace gphys {
namespace {

/// How a cluster that no particle holds moves. Relative masses.
class RigidVelocity {
public:
    /// velocity_of(i): of the particle whose floats begin at i.
    template <class Velocity>
    RigidVelocity(ClusterRange members, const ClothState& state, Velocity&& velocity_of) {
        ClusterPivot pivot;
        const auto index = [](const ClusterMember& member) { return 4 * size_t{member.particle}; };
        for (const ClusterMember& member : members)
            pivot.add(get(&state.at[index(member)]), {}, state.acceleration[index(member) + 3]);
        centre_ = pivot.at();
        inverse_mass_ = pivot.inverse_mass();
        SecondMoments moments;
        Vec3 angular;
        for (const ClusterMember& member : members) {
            const size_t i = index(member);
            const double mass = state.acceleration[i + 3];
            const Vec3 arm = get(&state.at[i]) - centre_, velocity = velocity_of(i);
            moments.add(arm, mass);
            momentum_ += velocity * mass;
            angular += cross(arm, velocity) * mass;
        }
        inverse_inertia_ = moments.inverse_inertia();
        linear_ = momentum_ * inverse_mass_;
        spin_ = inverse_inertia_ * angular;
        energy_ = (dot(momentum_, linear_) + dot(angular, spin_)) / 2;
    }

    Vec3 arm(Vec3 at) const { return at - centre_; }
    Vec3 place(Vec3 arm) const { return centre_ + arm; }
    Vec3 at(Vec3 arm) const { return linear_ + cross(spin_, arm); }
    /// At the beginning.
    Vec3 momentum() const { return momentum_; }
    double energy() const { return energy_; }
    double inverse_effective_mass(Vec3 arm, Vec3 direction) const {
        const Vec3 lever = cross(arm, direction);
        return inverse_mass_ + dot(lever, inverse_inertia_ * lever);
    }
    void push(Vec3 arm, Vec3 impulse) {
        linear_ += impulse * inverse_mass_;
        spin_ += inverse_inertia_ * cross(arm, impulse);
    }

private:
    Vec3 centre_, momentum_, linear_, spin_;
    double inverse_mass_ = 0, energy_ = 0;
    Mat3 inverse_inertia_;
};

/// Returns by how much it has changed the speed.
double solve_normal(RigidVelocity& velocity, ClusterImpact& impact) {
    const double missing = impact.target - dot(impact.normal, velocity.at(impact.arm));
    const double accumulated = std::max(0.0, impact.impulse + missing / impact.inverse_effective_mass);
    const double change = accumulated - impact.impulse;
    impact.impulse = accumulated;
    velocity.push(impact.arm, impact.normal * change);
    return std::fabs(change) * impact.inverse_effective_mass;
}

void solve_friction(RigidVelocity& velocity, ClusterImpact& impact) {
    Vec3 slip = velocity.at(impact.arm) - impact.surface_velocity;
    slip -= impact.normal * dot(impact.normal, slip);
    const double speed = length(slip), most = impact.friction * impact.impulse;
    Vec3 accumulated = impact.friction_impulse;
    if (speed > 0) accumulated -= slip / velocity.inverse_effective_mass(impact.arm, slip / speed);
    const double magnitude = length(accumulated);
    if (magnitude > most) accumulated *= most / magnitude;
    velocity.push(impact.arm, accumulated - impact.friction_impulse);
    impact.friction_impulse = accumulated;
}

void solve_impacts(RigidVelocity& velocity, ClusterImpact* first, ClusterImpact* end) {
    constexpr int most_sweeps = 64;
    constexpr double tolerance = 1e-6;  // relative to the fastest impact
    double fastest = 0;
    for (ClusterImpact* impact = first; impact != end; ++impact) {
        fastest = std::max(fastest, std::fabs(impact->target));
        impact->inverse_effective_mass = velocity.inverse_effective_mass(impact->arm, impact->normal);
    }
    double largest = infinity;
    for (int sweep = 0; sweep < most_sweeps && largest > tolerance * fastest; ++sweep) {
        largest = 0;
        for (ClusterImpact* impact = first; impact != end; ++impact) {
            largest = std::max(largest, solve_normal(velocity, *impact));
            if (impact->friction > 0) solve_friction(velocity, *impact);
        }
    }
}

/// The part of what impacts have changed that gives the cluster no energy. Newton's law may give some: gravity has
/// moved it for a whole substep, and impacts at several places are not simultaneous.
double part_without_gain(const ClothState& state, ClusterRange members, const RigidVelocity& before,
                         const RigidVelocity& after) {
    double squares = 0, products = 0, gain = 0;
    for (const ClusterMember& member : members) {
        const size_t i = 4 * size_t{member.particle};
        const double mass = state.acceleration[i + 3];
        const Vec3 arm = before.arm(get(&state.at[i])), velocity = before.at(arm), change = after.at(arm) - velocity;
        squares += length_squared(change) * mass;
        products += dot(velocity, change) * mass;
        gain += mass * (length_squared(velocity) - length_squared(get(&state.velocity_before[i])) -
                        2 * dot(get(&state.acceleration[i]), get(&state.at[i]) - get(&state.start[i])));
    }
    // squares s^2 + 2 products s + gain = 0
    if (!(squares > 0) || squares + 2 * products + gain <= 0) return 1;
    const double root = std::sqrt(std::max(0.0, products * products - squares * gain));
    return std::clamp((root - products) / squares, 0.0, 1.0);
}

void bounce_cluster(Body& body, const CollisionContext& around, ClusterRange members, ClusterImpact* first,
                    ClusterImpact* end, double h) {
    ClothState& state = body.cloth.state;
    const RigidVelocity computed(members, state, [&](size_t i) { return get(&state.velocity[i]); });
    const RigidVelocity by_way(members, state,
                               [&](size_t i) { return (get(&state.at[i]) - get(&state.start[i])) / h; });
    // The scheme derives velocities from the last two substeps. After an impact the first of these would count as a
    // motion back, by which what does not bounce would rise again.
    const RigidVelocity& before = by_way.energy() < computed.energy() ? by_way : computed;
    RigidVelocity velocity = before;
    const Vec3 stopped = (computed.momentum() - before.momentum()) / static_cast<double>(end - first);
    for (ClusterImpact* impact = first; impact != end; ++impact) {
        const Vec3 at = get(&state.at[4 * size_t{impact->particle}]);
        impact->arm = velocity.arm(at - impact->normal * body.particles.radius[impact->particle]);
    }
    solve_impacts(velocity, first, end);
    // Moving models do work.
    const double part = body.cloth.moving_colliders.empty() ? part_without_gain(state, members, before, velocity) : 1;
    for (const ClusterMember& member : members) {
        const size_t i = 4 * size_t{member.particle};
        const Vec3 arm = before.arm(get(&state.at[i])), unchanged = before.at(arm);
        put(&state.velocity[i], unchanged + (velocity.at(arm) - unchanged) * part);
    }
    for (const ClusterImpact* impact = first; impact != end; ++impact) {
        const Vec3 given = (impact->normal * impact->impulse + impact->friction_impulse) * part - stopped;
        add_impulse(
            body.contacts.impulses, around, impact->model, state.origin + velocity.place(impact->arm),
            (impact->counted * state.acceleration[4 * size_t{impact->particle} + 3] - given) * state.average_mass);
    }
}

}  // namespace

bool bounces_as_whole(const Body& body, uint32_t particle) {
    const Clusters& clusters = body.cloth.clusters;
    if (!clusters.has(particle) || clusters.overlap || body.plan.joined) return false;
    const ClusterRange members = cluster_with(clusters, particle);
    return std::all_of(members.begin(), members.end(), [&](const ClusterMember& member) {
        return body.cloth.state.acceleration[4 * size_t{member.particle} + 3] > 0;
    });
}

void bounce_clusters(Body& body, const CollisionContext& around, double h) {
    Clusters& clusters = body.cloth.clusters;
    Vector<ClusterImpact>& impacts = clusters.impacts;
    const auto first_member = [&](const ClusterImpact& impact) { return clusters.first_member[impact.particle]; };
    const auto order = [&](const ClusterImpact& impact) {
        return std::tuple(first_member(impact), impact.particle, impact.counted != Vec3{});
    };
    std::sort(impacts.begin(), impacts.end(),
              [&](const ClusterImpact& a, const ClusterImpact& b) { return order(a) < order(b); });
    ClusterImpact *first = impacts.data(), *const all_end = first + impacts.size();
    while (first != all_end) {
        ClusterImpact* end = first;
        bool hits = false;
        for (; end != all_end && first_member(*end) == first_member(*first); ++end) hits = hits || end->hits;
        if (hits) bounce_cluster(body, around, cluster_with(clusters, first->particle), first, end, h);
        first = end;
    }
    impacts.clear();
}

}  // namespace gphys
