// Makes rows of the contacts of free rigid clusters, and moves their particles (cluster_contacts.h).
#include "solver/contact/cluster_contacts.h"

#include "solver/cloth/second_moments.h"

namespace gphys {

void ParticleContacts::ClusterContacts::count(Island& island, const BodyTable& bodies, const uint32_t* slots) {
    // A member may touch many small particles. Between two members a contact counts once.
    constexpr uint32_t of_member = 64;
    uint32_t members = 0;
    island.cluster_count = 0;
    for (uint32_t i = 0; i < island.body_count; ++i) {
        each_free(bodies[slots[i]], [&](ClusterRange cluster) {
            ++island.cluster_count;
            members += cluster.size();
        });
    }
    const uint32_t pairs = std::min(contacts_per_particle * island.colliding_count, of_member * members);
    island.row_count = pairs + Supports::most * members;
}

void ParticleContacts::ClusterContacts::list(const Body& body, const Range& range, Particle* of_body,
                                             ContactCluster*& next) {
    each_free(body, [&](ClusterRange members) {
        *next = {};
        for (const ClusterMember& member : members) of_body[member.particle].cluster = next;
        next->first = static_cast<uint32_t>(of_body - range.particles);
        next->members = members;
        ++next;
    });
}

/// As the prediction has left its particles.
void ParticleContacts::ClusterContacts::find_inertia(ContactCluster& cluster) const {
    // Links have moved single particles out of the shape.
    constexpr double thinnest = 1e-3;
    double mass = 0;
    Vec3 at;
    each_particle(cluster, [&](const Particle& p) {
        mass += 1 / p.inverse_mass;
        at += p.at / p.inverse_mass;
    });
    cluster.centre = at / mass;
    cluster.inverse_mass = 1 / mass;
    SecondMoments moments;
    each_particle(cluster, [&](const Particle& p) { moments.add(p.at - cluster.centre, 1 / p.inverse_mass); });
    moments.thicken(thinnest);
    cluster.inverse_inertia = moments.inverse_inertia();
}

ContactSide ParticleContacts::ClusterContacts::side(Particle& particle, Vec3 Particle::*value,
                                                    Vec3 Particle::*uncorrected, const Vec3& still) const {
    ContactSide side;
    side.inverse_mass = particle.inverse_mass;
    if (particle.cluster) {
        side.cluster = particle.cluster;
        side.arm = particle.at - particle.cluster->centre;
        return side;
    }
    side.value = &(particle.*value);
    side.uncorrected = &(particle.*uncorrected);
    side.still = &still;
    side.supports = particle.supports;
    return side;
}

/// slip_of(particle, support)
template <class Slip>
void ParticleContacts::ClusterContacts::add_supports(Slip&& slip_of) {
    each_active([&](ContactCluster& cluster) {
        each_particle(cluster, [&](Particle& p) {
            if (!p.supports) return;
            for (uint32_t i = 0; i < p.supports->count(); ++i) {
                Support& support = (*p.supports)[i];
                ContactRow row;
                row.b.cluster = &cluster;
                row.b.arm = p.at - cluster.centre;
                row.normal = support.normal;
                row.gap = support.room;
                row.slip = slip_of(p, support);
                row.friction = p.supports->friction_coefficient();
                row.support = &support;
                row.scale = p.inverse_mass;
                contacts_.add(row);
            }
        });
    });
}

void ParticleContacts::ClusterContacts::begin_positions(const CollisionContext& around) {
    for (uint32_t i = 0; i < range_.cluster_count; ++i) {
        ContactCluster& cluster = range_.clusters[i];
        cluster.active = false;
        each_particle(cluster, [&](const Particle& p) { cluster.active = cluster.active || p.paired; });
        if (!cluster.active) continue;
        cluster.shift = cluster.turn = {};
        find_inertia(cluster);
        each_particle(cluster, [&](Particle& p) {
            Supports& supports = range_.supports[&p - range_.particles];
            p.supports = supports.find_in_shape(bodies_[p.body], p.number, p.at, around) ? &supports : nullptr;
        });
    }
    add_supports([](const Particle& p, const Support& support) { return p.at - p.before - support.carried; });
    others_ = each_rigid([&](Contact& contact, Particle& a, Particle& b) {
        ContactRow row;
        row.a = side(a, &Particle::at, &Particle::uncorrected, a.before);
        row.b = side(b, &Particle::at, &Particle::uncorrected, b.before);
        row.normal = contact.normal;
        row.gap = std::max(dot(b.at - a.at, contact.normal) - contact.radii, -contact.most_separation);
        row.slip = (b.at - b.before) - (a.at - a.before);
        row.friction = contact.friction;
        row.separation = &contact.separation;
        row.scale = a.inverse_mass + b.inverse_mass;
        contacts_.add(row);
    });
    contacts_.arrange(range_.clusters);
}

void ParticleContacts::ClusterContacts::begin_velocities(double tolerance) {
    static constexpr Vec3 zero;
    each_active([](ContactCluster& cluster) { cluster.shift = cluster.turn = {}; });
    const auto approach = [](const Contact& contact, const Particle& a, const Particle& b) {
        return contact.target_speed - dot(b.velocity - a.velocity, contact.normal);
    };
    bool any = false;
    others_ = each_rigid([&](const Contact& contact, const Particle& a, const Particle& b) {
        any = any || (contact.all_separation() > 0 && approach(contact, a, b) > tolerance);
    });
    if (!any) return;
    add_supports([](const Particle& p, const Support& support) { return p.velocity - support.carried; });
    each_rigid([&](Contact& contact, Particle& a, Particle& b) {
        if (!(contact.all_separation() > 0)) return;
        ContactRow row;
        row.a = side(a, &Particle::velocity, &Particle::uncorrected_velocity, zero);
        row.b = side(b, &Particle::velocity, &Particle::uncorrected_velocity, zero);
        row.normal = contact.normal;
        row.gap = -approach(contact, a, b);
        row.slip = b.velocity - a.velocity;
        row.friction = contact.friction;
        row.separation = &contact.normal_change;
        row.scale = a.inverse_mass + b.inverse_mass;
        contacts_.add(row);
    });
    contacts_.arrange(range_.clusters);
}

void ParticleContacts::ClusterContacts::end_positions() const {
    contacts_.end();
    each_active([&](ContactCluster& cluster) {
        if (cluster.shift == Vec3{} && cluster.turn == Vec3{}) return;
        const Vec3 half = cluster.turn / 2;
        const Mat3 rotation = rotation_matrix(Quat{half.x, half.y, half.z, 1});
        each_particle(cluster, [&](Particle& p) {
            const Vec3 arm = p.at - cluster.centre;
            p.at += cluster.shift + rotation * arm - arm;
        });
        cluster.centre += cluster.shift;
    });
}

void ParticleContacts::ClusterContacts::end_velocities() const {
    contacts_.end();
    each_active([&](const ContactCluster& cluster) {
        if (cluster.shift == Vec3{} && cluster.turn == Vec3{}) return;
        each_particle(cluster,
                      [&](Particle& p) { p.velocity += cluster.shift + cross(cluster.turn, p.at - cluster.centre); });
    });
}

}  // namespace gphys
