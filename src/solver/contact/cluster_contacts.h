// The contacts of rigid clusters in an island (rigid_contacts.h).
#pragma once

#include "solver/body.h"
#include "solver/contact/particle_contacts.h"

namespace gphys {

class ParticleContacts::ClusterContacts {
public:
    /// `part`: of the step, how long the substep is.
    ClusterContacts(const Range& range, const BodyTable& bodies, double part)
        : range_(range), bodies_(bodies), contacts_(range.rigid_rows), part_(part) {}

    /// The accuracy of gaps, metres: of what gravity moves in a substep.
    double tolerance(Vec3 gravity, double h) const { return (has_clusters() ? 1e-3 : 3e-3) * length(gravity) * h * h; }

    /// Calls visit(members) for the clusters of a body that contacts move as a whole: none of their particles is in
    /// another one, and any moves freely.
    template <class Visit>
    static void each_moving(const Body& body, Visit&& visit) {
        if (!is_graph(body) || body.cloth.clusters.empty() || body.cloth.clusters.overlap) return;
        if (!collides_with_others(body)) return;
        each_cluster(body.cloth.clusters, [&](ClusterRange members) {
            const auto moves = [&](const ClusterMember& m) { return body.particles.inverse_mass[m.particle] > 0; };
            if (std::any_of(members.begin(), members.end(), moves)) visit(members);
        });
    }
    /// Counts them, and the room for their contacts. Call before a step. `slots`: of the bodies of the island.
    static void count(Island& island, const BodyTable& bodies, const uint32_t* slots);
    /// Notes those of a body. Call at its beginning. `of_body`: the first particle of the body. `next`: the first one
    /// that is not taken yet.
    static void list(const Body& body, const Range& range, Particle* of_body, ContactCluster*& next);

    /// `joined`: null if joints are not solved afterwards.
    void begin_positions(const Joined* joined, const CollisionContext& around, Vec3 gravity, double h);
    void end_positions() const;
    /// `tolerance`: m/s, the accuracy of speeds. `joined`: null if they are given no responses.
    void begin_velocities(const Joined* joined, double tolerance);
    /// Those of joined clusters are left to change_joined_velocities.
    void end_velocities() const;
    /// Adds what clusters press on the models that hold them, after the end of places or of velocities. `rate`: by
    /// which the impulses of contacts are impulses in N s.
    void press_models_by_places(BodyTable& bodies, const CollisionContext& around, double rate) const {
        press_models(bodies, around, places, rate);
    }
    void press_models_by_velocities(BodyTable& bodies, const CollisionContext& around) const {
        press_models(bodies, around, velocities, 1);
    }
    /// So many sweeps over all contacts. solve_other(contact, a, b) is called for all of them and leaves out those of
    /// clusters.
    template <class Solve>
    void solve(int sweeps, double tolerance, Solve&& solve_other) {
        if (others_ == 0) {
            contacts_.solve(sweeps * iterations(), tolerance);
            return;
        }
        for (int i = 0; i < sweeps; ++i) {
            sweep(range_, 1, solve_other);
            contacts_.restart();
            contacts_.solve(iterations(), tolerance);
        }
    }

private:
    bool has_clusters() const { return range_.cluster_count > 0; }
    /// In each of the sweeps over all contacts, at most: more in long substeps. Friction turns crates, and the normal
    /// forces turn them back; with ten in long ones, stacks topple on a truck. Links and free particles follow after
    /// these contacts, so what presses on their particles gains nothing from more. Limbs that joints hold deep in each
    /// other gain energy with some larger numbers. Balls do not turn.
    int iterations() const {
        if (!has_clusters()) return 5;
        return is_with_particle(range_.rigid_pairs->clusters) || any_joined() ? 10 : 12 + static_cast<int>(20 * part_);
    }
    /// Whether one of the two of a pair moves alone. Such pairs come first.
    static bool is_with_particle(uint64_t clusters) { return clusters >> 32 == 0; }

    /// What contacts of particles change: their places or their velocities. still: null for zero.
    struct Values {
        Vec3 Particle::*value, Particle::*uncorrected, Particle::*still;
    };
    static constexpr Values places{&Particle::at, &Particle::uncorrected, &Particle::before};
    static constexpr Values velocities{&Particle::velocity, &Particle::uncorrected_velocity, nullptr};

    template <class Visit>
    void each_particle(const ContactCluster& cluster, Visit&& visit) const {
        for (const ClusterMember& member : cluster.members) visit(range_.particles[cluster.first + member.particle]);
    }
    template <class Visit>
    void each_active(Visit&& visit) const {
        for (uint32_t i = 0; i < range_.cluster_count; ++i) {
            if (range_.clusters[i].active) visit(range_.clusters[i]);
        }
    }
    static ContactPartner partner_of(Particle& particle, const Values& values);
    void list_pairs();
    void count_others();
    /// Calls visit(pair, contact, a, b) for the contacts of clusters.
    template <class Visit>
    void each_rigid(Visit&& visit) const {
        for (const RigidPair* pair = range_.rigid_pairs; pair->clusters != RigidPair::end; ++pair) {
            Contact& contact = range_.contacts[pair->contact];
            visit(*pair, contact, range_.particles[contact.a], range_.particles[contact.b]);
        }
    }
    template <class Fill>
    void add_contacts(const Values& values, Fill&& fill);
    void press_models(BodyTable& bodies, const CollisionContext& around, const Values& values, double rate) const;
    void find_inertia(ContactCluster& cluster) const;
    template <class Displacement>
    Vec3 rotation_by(const ContactCluster& cluster, Displacement&& displacement) const;
    double reach_of_contact(const Particle& from, const Particle& to) const;
    void find_responses(const Joined& joined);
    bool any_joined() const;
    void place_joined(const Joined& joined, double h);
    template <class Slip>
    void add_supports(Slip&& slip_of);

    const Range& range_;
    const BodyTable& bodies_;
    RigidContacts contacts_;
    const double part_;
    uint32_t others_ = 0;  // contacts without clusters
};

}  // namespace gphys
