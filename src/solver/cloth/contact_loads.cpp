// Cloth that carries heavy particles: effective masses, and the energy of cloth and loads (contact_loads.h).
#include "solver/cloth/contact_loads.h"

#include "solver/body.h"
#include "solver/quads.h"

namespace gphys {
namespace {

/// The inverse mass matrix of a loaded particle, relative to its own inverse mass.
void set_inertia(TetherInertia& tethers, const ContactLoad& load, double inverse_mass) {
    const double along = 1 / (1 + load.along * inverse_mass), across = 1 / (1 + load.across * inverse_mass);
    float* const diagonal = &tethers.diagonal[4 * size_t{load.particle}];
    float* const off = &tethers.off[4 * size_t{load.particle}];
    for (int k = 0; k < 3; ++k) {
        diagonal[k] = static_cast<float>(across + (along - across) * load.normal[k] * load.normal[k]);
        off[k] = static_cast<float>((along - across) * load.normal[(k + 1) % 3] * load.normal[(k + 2) % 3]);
    }
}

/// Kinetic energy, and potential energy of forces, per average mass. velocity(first float of a particle)
template <class Velocity>
double energy_of_cloth(const ClothState& state, Velocity&& velocity) {
    double sum = 0;
    for (size_t i = 0; i < 4 * size_t{state.particles}; i += 4) {
        const double mass = state.acceleration[i + 3];
        if (mass > 0)
            sum += mass * (length_squared(velocity(i)) / 2 - dot(get(&state.acceleration[i]), get(&state.at[i])));
    }
    return sum;
}

double energy_of(const HeavyParticle& heavy) {
    return heavy.mass * (length_squared(heavy.velocity) / 2 - dot(heavy.acceleration, heavy.place));
}

/// Per average mass. The prediction has moved the cloth without its links, so their energy is that at the start of the
/// substep, and the motion is that to the predicted places, where contacts have pushed.
double energy_before_links(Cloth& cloth, double h) {
    ClothState& state = cloth.state;
    double sum = energy_of_cloth(state, [&](size_t i) { return (get(&state.at[i]) - get(&state.start[i])) / h; });
    for (const HeavyParticle& heavy : cloth.loads.heavy) sum += energy_of(heavy);
    state.at.swap(state.start);
    sum += stored_energy(cloth);
    state.at.swap(state.start);
    return sum;
}

/// Mass * square of the way in the substep, of cloth and loads.
double motion_before_links(const Cloth& cloth, double h) {
    const ClothState& state = cloth.state;
    double sum = 0;
    for (size_t i = 0; i < 4 * size_t{state.particles}; i += 4)
        sum += state.acceleration[i + 3] * length_squared(get(&state.at[i]) - get(&state.start[i]));
    for (const HeavyParticle& heavy : cloth.loads.heavy) sum += heavy.mass * length_squared(heavy.velocity * h);
    return sum;
}

double energy_after_links(Cloth& cloth) {
    const ClothState& state = cloth.state;
    double sum = stored_energy(cloth) + energy_of_cloth(state, [&](size_t i) { return get(&state.velocity[i]); });
    for (const HeavyParticle& heavy : cloth.loads.heavy) sum += energy_of(heavy);
    return sum;
}

/// Removes energy, per average mass, from the motion of cloth and loads relative to their drift. What pins or models
/// hold has none: their forces change the momentum, and what sweeps add to it is not motion that must stay.
void slow_by(Cloth& cloth, double energy) {
    ClothState& state = cloth.state;
    Vec3 drift;
    if (!state.held && !cloth.contacts.any_active()) {
        Motion whole = motion_of_cloth(state);
        for (const HeavyParticle& heavy : cloth.loads.heavy) whole.add(heavy.mass * state.average_mass, heavy.velocity);
        drift = whole.momentum / whole.mass;
    }
    double inner = inner_energy_of_cloth(state, cloth.shares, drift) / state.average_mass;
    for (const HeavyParticle& heavy : cloth.loads.heavy)
        inner += heavy.mass * length_squared(heavy.velocity - drift) / 2;
    const double kept = energy < inner ? std::sqrt(1 - energy / inner) : 0;
    slow_cloth(state, cloth.shares.team, drift, kept);
    for (HeavyParticle& heavy : cloth.loads.heavy) heavy.velocity = drift + (heavy.velocity - drift) * kept;
}

}  // namespace

void reserve_loads(ContactLoads& loads, uint32_t particles, size_t floats) {
    loads.all.reserve(particles);
    loads.heavy.reserve(particles);
    loads.is_loaded.resize(particles);
    loads.predicted.reserve(floats);
}

void begin_loads(Body& body, double h) {
    Cloth& cloth = body.cloth;
    cloth.tethers.clear();
    std::fill(cloth.in_chains.pulls.begin(), cloth.in_chains.pulls.end(), 0.0f);
    for (const ContactLoad& load : cloth.loads.all) {
        cloth.loads.is_loaded[load.particle] = 1;
        set_inertia(cloth.tethers, load, cloth.state.at[4 * size_t{load.particle} + 3]);
    }
    cloth.loads.motion = motion_before_links(cloth, h);
    cloth.loads.energy = energy_before_links(cloth, h);
}

void note_places(ContactLoads& loads, const ClothState& state) {
    for (ContactLoad& load : loads.all) load.place = get(&state.at[4 * size_t{load.particle}]);
}

void move_loads(ContactLoads& loads, const ClothState& state) {
    uint32_t i = 0;
    for (HeavyParticle& heavy : loads.heavy) {
        Vec3 sum;
        for (; i < heavy.end; ++i) {
            ContactLoad& load = loads.all[i];
            const Vec3 displacement = get(&state.at[4 * size_t{load.particle}]) - load.place;
            const double off = dot(displacement, load.normal);
            sum += load.normal * (load.along * off) + (displacement - load.normal * off) * load.across;
            load.impulse += load.along * off;
        }
        heavy.moved += sum / heavy.mass;
    }
    note_places(loads, state);
}

bool links_threw_loads(const Cloth& cloth) {
    // Corrections are a projection: with the masses as weights, they are no longer than the way that the prediction
    // went off the constraints, and those of sweeps at most twice as long.
    constexpr double farthest = 2;
    // Links that earlier substeps have left strained also get their lengths back. Under a load that a model carries
    // they are hardly strained: this part of a link. A net may be strained along whole chains by what falls into it.
    constexpr double error_on_model = 0.05;
    const ClothState& state = cloth.state;
    const ContactLoads& loads = cloth.loads;
    struct Moved {
        double square = 0, mass = 0;
    };
    Moved moved[2];  // in the air, and on models
    uint32_t i = 0;
    for (const HeavyParticle& heavy : loads.heavy) {
        Moved of_shares;
        bool carried = false;
        for (; i < heavy.end; ++i) {
            const size_t at = 4 * size_t{loads.all[i].particle};
            const double mass = state.acceleration[at + 3] + loads.all[i].along;
            of_shares.square += mass * length_squared(get(&state.at[at]) - get(&loads.predicted[at]));
            of_shares.mass += mass;
            carried = carried || length_squared(get(&cloth.in_chains.normals[at])) > 0;
        }
        moved[carried].square += of_shares.square;
        moved[carried].mass += of_shares.mass;
    }
    const double links[2] = {static_cast<double>(cloth.batches.longest), error_on_model};
    const auto is_thrown = [&](int carried) {
        const double strained = links[carried] * cloth.batches.link_length;
        const double most = farthest * farthest * loads.motion + moved[carried].mass * strained * strained;
        return !(moved[carried].square <= most);
    };
    return is_thrown(0) || is_thrown(1);
}

void undo_loads(Cloth& cloth) {
    ContactLoads& loads = cloth.loads;
    cloth.state.at = loads.predicted;
    cloth.tethers.clear();
    for (ContactLoad& load : loads.all) load.along = load.across = load.impulse = 0;
    for (HeavyParticle& heavy : loads.heavy) heavy.moved = {};
    note_places(loads, cloth.state);
}

void restore_places(const ContactLoads& loads, ClothState& state) {
    for (const ContactLoad& load : loads.all) put(&state.at[4 * size_t{load.particle}], load.place);
}

void accelerate_loads(Body& body, double h) {
    Cloth& cloth = body.cloth;
    ContactLoads& loads = cloth.loads;
    for (HeavyParticle& heavy : loads.heavy) {
        heavy.place += heavy.moved;
        heavy.before = heavy.velocity;
        heavy.velocity += heavy.moved / h;
    }
    if (loads.closed && !cloth.contacts.has_moving_model && !body.targets.act()) {
        const double gain = energy_after_links(cloth) - loads.energy;
        if (gain > 0) slow_by(cloth, gain);
    }
    uint32_t i = 0;
    for (const HeavyParticle& heavy : loads.heavy) {
        const uint32_t first = i;
        Vec3 sum;
        for (; i < heavy.end; ++i) sum += loads.all[i].normal * loads.all[i].impulse;
        const double square = length_squared(sum);
        const double part = square > 0 ? dot(heavy.velocity - heavy.before, sum) * heavy.mass / square : 0;
        for (uint32_t k = first; k < i; ++k) loads.all[k].impulse *= part;
    }
}

void clear_loads(ContactLoads& loads) {
    for (const ContactLoad& load : loads.all) loads.is_loaded[load.particle] = 0;
    loads.all.clear();
    loads.heavy.clear();
}

}  // namespace gphys
