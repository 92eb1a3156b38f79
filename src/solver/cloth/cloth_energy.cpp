// The energy balance of a substep of cloth (cloth_energy.h).
#include "solver/body.h"
#include "solver/cloth/cloth_chains.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"

namespace gphys {
namespace {

/// Removes energy from the motion relative to a drift.
void slow_by(ClothState& state, ClothShares& shares, Vec3 drift, double energy) {
    const double inner = inner_energy_of_cloth(state, shares, drift);
    slow_cloth(state, shares.team, drift, energy < inner ? std::sqrt(1 - energy / inner) : 0);
}

}  // namespace

double stored_energy(Cloth& cloth) {
    const double compressed =
        cloth.volume.held ? stored_in_volume(cloth.volume, cloth_volume(cloth.sheet, cloth.state)) : 0;
    return add_stored_in_links(compressed / cloth.state.average_mass, cloth.batches, cloth.state, cloth.shares);
}

bool is_accounted_for(const Body& body, bool collides) {
    const ClothContacts& contacts = body.cloth.contacts;
    if (!body.cloth.state.held.empty() || body.plan.joined || body.contacts.near) return false;
    if (body.targets.act()) return false;
    if (body.air.blows()) return false;  // the wind's force depends on the velocity that would be restored
    if (!collides || !(contacts.any_active() || contacts.penetrating)) return true;
    return body.cloth.volume.held && !contacts.penetrating && !contacts.has_moving_model;
}

void limit_energy_in_solid(ClothState& state, ClothShares& shares, double gain) {
    const double allowed = state.average_mass * state.particles * leaving_speed * leaving_speed / 2;
    const double excess = std::min(gain, inner_energy_of_cloth(state, shares, {}) - allowed);
    if (excess > 0) slow_by(state, shares, {}, excess);
}

void remove_own_gains(ClothState& state, double gain) {
    const auto gain_of = [&](size_t i) {
        const Vec3 after = get(&state.velocity[i]), before = get(&state.velocity_before[i]);
        const Vec3 way = get(&state.at[i]) - get(&state.start[i]);
        return state.acceleration[i + 3] *
               ((length_squared(after) - length_squared(before)) / 2 - dot(get(&state.acceleration[i]), way));
    };
    const size_t floats = 4 * size_t{state.particles};
    double gained = 0;
    for (size_t i = 0; i < floats; i += 4) gained += std::max(0.0, gain_of(i));
    if (gained == 0) return;
    const double part = std::min(1.0, gain / (gained * state.average_mass));
    for (size_t i = 0; i < floats; i += 4) {
        const double lost = 2 * part * gain_of(i);
        if (lost <= 0) continue;
        const Vec3 velocity = get(&state.velocity[i]);
        const double square = length_squared(velocity) * state.acceleration[i + 3];
        put(&state.velocity[i], velocity * (lost < square ? std::sqrt(1 - lost / square) : 0));
    }
}

void remove_energy(ClothState& state, ClothShares& shares, double gain) {
    Vec3 drift;
    if (state.held.empty()) {
        const Motion motion = motion_of_cloth(state);
        drift = motion.momentum / motion.mass;
    }
    slow_by(state, shares, drift, gain);
}

}  // namespace gphys
