// Makes rows of the contacts of rigid clusters, and moves their particles (cluster_contacts.h).
#include "solver/contact/cluster_contacts.h"

#include "solver/cloth/cluster_pivot.h"
#include "solver/joints/joined_motion.h"

namespace gphys {

void ParticleContacts::ClusterContacts::count(Island& island, const BodyTable& bodies, const uint32_t* slots) {
    // A member may touch many small particles. Between two members a contact counts once.
    constexpr uint32_t of_member = 64;
    uint32_t members = 0;
    island.cluster_count = 0;
    for (uint32_t i = 0; i < island.body_count; ++i) {
        each_moving(bodies[slots[i]], [&](ClusterRange cluster) {
            ++island.cluster_count;
            members += cluster.size();
        });
    }
    const uint32_t pairs = std::min(contacts_per_particle * island.colliding_count, of_member * members);
    island.rigid_pair_count = island.cluster_count > 0 ? pairs + 1 : 0;  // and the end of the list
    island.row_count = pairs + Supports::most * members;
}

void ParticleContacts::ClusterContacts::list(const Body& body, const Range& range, Particle* of_body,
                                             ContactCluster*& next) {
    each_moving(body, [&](ClusterRange members) {
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
    ClusterPivot pivot;
    const auto mass_of = [](const Particle& p) { return p.inverse_mass > 0 ? 1 / p.inverse_mass : 0; };
    each_particle(cluster, [&](const Particle& p) { pivot.add(p.at, {}, mass_of(p)); });
    cluster.held = pivot.held_count() > 0;
    cluster.centre = pivot.at();
    cluster.inverse_mass = pivot.inverse_mass();
    SecondMoments moments, held;
    each_particle(cluster, [&](const Particle& p) {
        const double mass = mass_of(p);
        (mass > 0 ? moments : held).add(p.at - cluster.centre, mass > 0 ? mass : 1);
    });
    cluster.size = std::sqrt(moments.sum() / pivot.mass());
    const double weight = weight_of_held(moments.sum(), held.sum(), pivot.mass());
    moments.thicken(thinnest);
    moments.add(held, weight);
    cluster.inverse_inertia = moments.inverse_inertia();
}

/// The rotation that is nearest to the displacements of its particles. For velocities, the spin.
template <class Displacement>
Vec3 ParticleContacts::ClusterContacts::rotation_by(const ContactCluster& cluster, Displacement&& displacement) const {
    constexpr double thinnest = 1e-3;
    Vec3 middle;
    each_particle(cluster, [&](const Particle& p) { middle += p.at / cluster.members.size(); });
    SecondMoments moments;
    Vec3 sum;
    each_particle(cluster, [&](const Particle& p) {
        moments.add(p.at - middle, 1);
        sum += cross(p.at - middle, displacement(p));
    });
    moments.thicken(thinnest);
    return moments.inverse_inertia() * sum;
}

/// Metres from a particle of a cluster to where it touches another one. What turns together does not slide there, while
/// the centres of its particles do. Particles of ropes and cloth are carried along by their centres. A cluster that is
/// much smaller than its particles has no inertia against friction so far out.
double ParticleContacts::ClusterContacts::reach_of_contact(const Particle& from, const Particle& to) const {
    constexpr double most = 4;
    if (!from.cluster) return 0;
    const double reach = to.cluster || moves_freely(bodies_[to.body]) ? from.radius : from.radius + to.radius;
    return std::min(reach, most * from.cluster->size);
}

namespace {

/// 0 for a particle that moves alone.
uint64_t number_of(const ContactCluster* cluster, const ContactCluster* first) {
    return cluster ? static_cast<uint64_t>(cluster - first) + 1 : 0;
}

}  // namespace

/// Sorts the contacts by pair of clusters, those with particles that move alone first.
void ParticleContacts::ClusterContacts::list_pairs() {
    RigidPair *const first = range_.rigid_pairs, *const last = first + range_.rigid_pair_count - 1, *end = first;
    for (const Group* group = range_.groups; group != range_.groups + range_.group_count; ++group) {
        for (uint32_t i = group->contacts.begin; i < group->contacts.begin + group->contacts.count; ++i) {
            const Contact& contact = range_.contacts[i];
            if (!contact.rigid || end == last) continue;
            const uint64_t a = number_of(range_.particles[contact.a].cluster, range_.clusters),
                           b = number_of(range_.particles[contact.b].cluster, range_.clusters);
            *end++ = {std::min(a, b) << 32 | std::max(a, b), i};
        }
    }
    std::sort(first, end);
    *end = {RigidPair::end, 0};
}

void ParticleContacts::ClusterContacts::count_others() {
    others_ = 0;
    for (const Group* group = range_.groups; group != range_.groups + range_.group_count; ++group)
        others_ += group->contacts.count;
    each_rigid([&](const RigidPair&, const Contact&, const Particle&, const Particle&) { --others_; });
}

ContactPartner ParticleContacts::ClusterContacts::partner_of(Particle& particle, const Values& values) {
    static constexpr Vec3 zero;
    ContactPartner partner;
    partner.cluster = particle.cluster;
    if (particle.cluster) return partner;
    partner.value = &(particle.*values.value);
    partner.uncorrected = &(particle.*values.uncorrected);
    partner.still = values.still ? &(particle.*values.still) : &zero;
    partner.supports = particle.supports;
    partner.inverse_mass = particle.inverse_mass;
    return partner;
}

/// fill(row, contact, a, b) fills in the gap, the slip of b relative to a, and where the result belongs; it returns
/// whether there is such a row.
template <class Fill>
void ParticleContacts::ClusterContacts::add_contacts(const Values& values, Fill&& fill) {
    uint64_t group = RigidPair::end;
    each_rigid([&](const RigidPair& pair, Contact& contact, Particle& a, Particle& b) {
        ContactRow row;
        if (!fill(row, contact, a, b)) return;
        row.normal = contact.normal;
        row.friction = contact.friction;
        row.scale = a.inverse_mass + b.inverse_mass;
        const bool swapped = number_of(a.cluster, range_.clusters) > number_of(b.cluster, range_.clusters);
        if (swapped) {
            row.normal = -row.normal;
            row.slip = -row.slip;
        }
        Particle &first = swapped ? b : a, &second = swapped ? a : b;
        if (pair.clusters != group || !first.cluster) {
            contacts_.begin_group(partner_of(first, values), partner_of(second, values));
            group = pair.clusters;
        }
        const Vec3 on_first = row.normal * reach_of_contact(first, second),
                   on_second = row.normal * -reach_of_contact(second, first);
        if (first.cluster) {
            row.arm_a = first.at + on_first - first.cluster->centre;
            row.slip -= cross(first.cluster->turned, on_first);
        }
        if (second.cluster) {
            row.arm_b = second.at + on_second - second.cluster->centre;
            row.slip += cross(second.cluster->turned, on_second);
        }
        contacts_.add(row);
    });
}

/// slip_of(particle, support)
template <class Slip>
void ParticleContacts::ClusterContacts::add_supports(Slip&& slip_of) {
    each_active([&](ContactCluster& cluster) {
        ContactPartner partner;
        partner.cluster = &cluster;
        contacts_.begin_group({}, partner);
        each_particle(cluster, [&](Particle& p) {
            if (!p.supports) return;
            for (uint32_t i = 0; i < p.supports->count(); ++i) {
                Support& support = (*p.supports)[i];
                ContactRow row;
                row.arm_b = p.at - cluster.centre;
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

bool ParticleContacts::ClusterContacts::any_joined() const {
    bool any = false;
    each_active(
        [&](const ContactCluster& cluster) { any = any || bodies_[range_.particles[cluster.first].body].plan.joined; });
    return any;
}

/// How clusters that joints hold move, to the systems as they were solved last.
void ParticleContacts::ClusterContacts::find_responses(const Joined& joined) {
    const auto body_of = [&](const ContactCluster& cluster) { return range_.particles[cluster.first].body; };
    each_active(
        [&](const ContactCluster& cluster) { joined.bodies[body_of(cluster)].cloth.clusters.responses.clear(); });
    each_active([&](const ContactCluster& cluster) {
        add_cluster_response(joined, body_of(cluster), cluster.members.first->cluster);
    });
    each_active([&](ContactCluster& cluster) {
        Body& body = joined.bodies[body_of(cluster)];
        cluster.response = response_of(body.cloth.clusters, cluster.members.first->cluster);
        cluster.mass_unit = body.cloth.state.average_mass;
        cluster.system = nullptr;
        if (!cluster.response || !joined.all_systems[cluster.response->system].couples_clusters()) return;
        cluster.system = &joined.all_systems[cluster.response->system];
        cluster.system->begin_impulses();
    });
}

/// Puts clusters that joints hold where they would be without contacts.
void ParticleContacts::ClusterContacts::place_joined(const Joined& joined, double h) {
    solve_without_contacts(joined, h);
    find_responses(joined);
    each_active([&](ContactCluster& cluster) {
        if (!cluster.response) return;
        const ClusterResponse& response = *cluster.response;
        cluster.centre = bodies_[range_.particles[cluster.first].body].cloth.state.origin + response.centre;
        for (const ClusterMember& member : cluster.members) {
            Particle& p = range_.particles[cluster.first + member.particle];
            if (p.inverse_mass > 0) p.at = cluster.centre + response.rotation * (member.rest - response.rest);
        }
    });
}

void ParticleContacts::ClusterContacts::begin_positions(const Joined* joined, const CollisionContext& around,
                                                        Vec3 gravity, double h) {
    for (uint32_t i = 0; i < range_.cluster_count; ++i) {
        ContactCluster& cluster = range_.clusters[i];
        cluster.active = false;
        each_particle(cluster, [&](const Particle& p) { cluster.active = cluster.active || p.paired; });
        if (!cluster.active) continue;
        cluster.shift = cluster.turn = cluster.impulse = cluster.moment = {};
        cluster.response = nullptr;
        find_inertia(cluster);
        // Nothing would close the joints of what is joined again, so that stays.
        if (!joined && bodies_[range_.particles[cluster.first].body].plan.joined) {
            cluster.inverse_mass = 0;
            cluster.inverse_inertia = {{}, {}, {}};
        }
    }
    if (joined && any_joined()) place_joined(*joined, h);
    each_active([&](ContactCluster& cluster) {
        cluster.turned = rotation_by(cluster, [](const Particle& p) { return p.at - p.before; });
    });
    each_active([&](ContactCluster& cluster) {
        each_particle(cluster, [&](Particle& p) {
            Supports& supports = range_.supports[&p - range_.particles];
            p.supports = supports.find_in_shape(bodies_[p.body], p.number, p.at, around, gravity) ? &supports : nullptr;
        });
    });
    const auto slip_of = [](const Particle& p, const Support& support) { return p.at - p.before - support.carried; };
    // What it was in a model before the substep is removed afterwards, without speed. Here it would push others.
    const double most_removed = joined ? length(gravity) * h * h : infinity;
    each_active([&](ContactCluster& cluster) {
        each_particle(cluster, [&](Particle& p) {
            for (uint32_t i = 0; p.supports && i < p.supports->count(); ++i) {
                Support& support = (*p.supports)[i];
                const double closing = -dot(slip_of(p, support), support.normal);
                support.room = std::max(support.room, -std::max(0.0, closing + most_removed));
            }
        });
    });
    add_supports(slip_of);
    list_pairs();
    count_others();
    add_contacts(places, [](ContactRow& row, Contact& contact, const Particle& a, const Particle& b) {
        row.gap = std::max(dot(b.at - a.at, contact.normal) - contact.radii, -contact.most_separation);
        row.slip = (b.at - b.before) - (a.at - a.before);
        row.separation = &contact.separation;
        return true;
    });
}

void ParticleContacts::ClusterContacts::begin_velocities(const Joined* joined, double tolerance) {
    const auto approach = [](const Contact& contact, const Particle& a, const Particle& b) {
        return contact.target_speed - dot(b.velocity - a.velocity, contact.normal);
    };
    each_active([](ContactCluster& cluster) { cluster.shift = cluster.turn = cluster.impulse = cluster.moment = {}; });
    bool any = false;
    each_rigid([&](const RigidPair&, const Contact& contact, const Particle& a, const Particle& b) {
        any = any || (contact.all_separation() > 0 && approach(contact, a, b) > tolerance);
    });
    count_others();
    if (!any) return;
    if (joined && any_joined()) find_responses(*joined);
    each_active([&](ContactCluster& cluster) {
        cluster.turned = rotation_by(cluster, [](const Particle& p) { return p.velocity; });
    });
    add_supports([](const Particle& p, const Support& support) { return p.velocity - support.carried; });
    add_contacts(velocities, [&](ContactRow& row, Contact& contact, const Particle& a, const Particle& b) {
        if (!(contact.all_separation() > 0)) return false;
        row.gap = -approach(contact, a, b);
        row.slip = b.velocity - a.velocity;
        row.separation = &contact.normal_change;
        return true;
    });
}

void ParticleContacts::ClusterContacts::end_positions() const {
    contacts_.end();
    each_active([&](ContactCluster& cluster) {
        if (cluster.response) {
            each_particle(cluster, [](Particle& p) { p.at = p.uncorrected; });
            cluster.response = nullptr;
            find_inertia(cluster);
            return;
        }
        if (cluster.shift == Vec3{} && cluster.turn == Vec3{}) return;
        const Vec3 half = cluster.turn / 2;
        const Mat3 rotation = rotation_matrix(Quat{half.x, half.y, half.z, 1});
        each_particle(cluster, [&](Particle& p) {
            if (p.inverse_mass == 0) return;
            const Vec3 arm = p.at - cluster.centre;
            p.at += cluster.shift + rotation * arm - arm;
        });
        cluster.centre += cluster.shift;
    });
}

void ParticleContacts::ClusterContacts::end_velocities() const {
    contacts_.end();
    each_active([&](ContactCluster& cluster) {
        if (std::exchange(cluster.response, nullptr)) return;
        if (cluster.shift == Vec3{} && cluster.turn == Vec3{}) return;
        each_particle(cluster, [&](Particle& p) {
            if (p.inverse_mass > 0) p.velocity += cluster.shift + cross(cluster.turn, p.at - cluster.centre);
        });
    });
}

/// Contacts press held clusters against the models to which their particles are attached, except for what moves them.
void ParticleContacts::ClusterContacts::press_models(BodyTable& bodies, const CollisionContext& around,
                                                     const Values& values, double rate) const {
    if (!around.scene) return;
    each_active([&](const ContactCluster& cluster) {
        Body& body = bodies[range_.particles[cluster.first].body];
        if (!cluster.held || body.constraints.attachments.empty()) return;
        Vec3 impulse = cluster.impulse, moment = cluster.moment;
        SecondMoments held;
        double count = 0;
        each_particle(cluster, [&](const Particle& p) {
            const Vec3 arm = p.at - cluster.centre;
            if (p.inverse_mass == 0) return held.add(arm, 1), void(++count);
            const Vec3 taken = (p.*values.value - p.*values.uncorrected) / p.inverse_mass;
            impulse -= taken;
            moment -= cross(arm, taken);
        });
        const LeastForces shares(impulse, moment, count, held);
        each_particle(cluster, [&](const Particle& p) {
            if (p.inverse_mass == 0)
                add_anchor_impulse(body, around, p.number, shares.at(p.at - cluster.centre) * rate);
        });
    });
}

}  // namespace gphys
