// The energy of clusters that pins hold (hinged_clusters.h).
#include "solver/cloth/hinged_clusters.h"

#include "foundation/elementary.h"
#include "solver/body.h"
#include "solver/quads.h"

namespace gphys {
namespace {

bool is_known(const Body& body, bool collides) {
    const Cloth& cloth = body.cloth;
    if (cloth.clusters.empty() || cloth.clusters.overlap || cloth.state.held.empty() || !cloth.balance.closed)
        return false;
    // Of velocities that a contact or the caller has given single particles, the shape keeps what is rigid.
    if (body.history.earlier_step == 0) return false;
    if (!body.plan.rest.empty() || body.plan.joined || body.contacts.near || body.air.blows()) return false;
    return !collides || !(cloth.contacts.any_active() || cloth.contacts.penetrating);
}

/// `kept`: the part of kinetic energy that damping leaves.
void keep_energy(ClusterRange members, ClothState& state, double kept) {
    // Where the motion turns back there is hardly any energy to scale. What is missed there is a rounding error.
    constexpr double most_change = 0.1;
    double before = 0, after = 0, work = 0;
    bool held = false;
    for (const ClusterMember& member : members) {
        const size_t i = 4 * size_t{member.particle};
        const double mass = state.acceleration[i + 3];  // relative; 0 if it does not move freely
        held = held || mass == 0;
        before += length_squared(get(&state.velocity_before[i])) * mass / 2;
        after += length_squared(get(&state.velocity[i])) * mass / 2;
        work += dot(get(&state.acceleration[i]), get(&state.at[i]) - get(&state.start[i])) * mass;
    }
    // Of the work of a substep, damping takes half as much as of what was there before.
    const double wanted = before * kept + work * std::sqrt(kept);
    if (!held || std::fabs(wanted - after) > most_change * after) return;
    const double factor = after > 0 ? std::sqrt(wanted / after) : 1;
    for (const ClusterMember& member : members) {
        float* const velocity = &state.velocity[4 * size_t{member.particle}];
        put(velocity, get(velocity) * factor);
    }
}

}  // namespace

void keep_hinged_energy(Body& body, bool collides, double h) {
    if (!is_known(body, collides)) return;
    const double kept = decay(2 * body.settings.damping * h).kept;
    each_cluster(body.cloth.clusters, [&](ClusterRange members) { keep_energy(members, body.cloth.state, kept); });
}

}  // namespace gphys
