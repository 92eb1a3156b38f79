// Cloth that carries what is much heavier: effective masses, and the energy of cloth and loads (contact_loads.h).
#include "solver/cloth/contact_loads.h"

#include "solver/body.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"
#include "solver/time_scheme.h"

namespace gphys {
namespace {

LoadMotion operator-(const LoadMotion& a, const LoadMotion& b) { return {a.velocity - b.velocity, a.spin - b.spin}; }
LoadMotion operator+(const LoadMotion& a, const LoadMotion& b) { return {a.velocity + b.velocity, a.spin + b.spin}; }
LoadMotion operator*(const LoadMotion& a, double s) { return {a.velocity * s, a.spin * s}; }

/// The product of two motions by the inertia: of one with itself, twice its energy.
double product(const HeavyBody& heavy, const LoadMotion& a, const LoadMotion& b) {
    return heavy.mass * dot(a.velocity, b.velocity) + dot(a.spin, heavy.inverse_inertia * b.spin);
}

double potential_energy_of(const HeavyBody& heavy) { return -heavy.mass * dot(heavy.acceleration, heavy.place); }

/// In a frame that moves.
double energy_of(const HeavyBody& heavy, Vec3 frame) {
    const LoadMotion own = heavy.motion - LoadMotion{frame, {}};
    return product(heavy, own, own) / 2 + potential_energy_of(heavy);
}

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

/// The masses that the shares of a load add to their particles.
void divide(const HeavyBody& heavy, ContactLoad* first, const ContactLoad* end, const ClothState& state) {
    // Across the normal a particle takes at most as many times its own mass. With none, chains between heavy particles
    // would correct their lengths by moving these aside. With all, cloth would not slide under its load.
    constexpr double most_across = 100;
    const double shares = heavy.shares;
    for (ContactLoad* load = first; load != end; ++load) {
        const auto turning = [&](Vec3 direction) {
            const Vec3 lever = cross(load->arm, direction);
            return dot(lever, heavy.inverse_inertia * lever);
        };
        const double along = turning(load->normal);
        const double across = std::max(0.0, turning({1, 0, 0}) + turning({0, 1, 0}) + turning({0, 0, 1}) - along);
        load->along = heavy.mass / ((1 + heavy.mass * along) * shares);
        load->across = std::min({load->along, heavy.mass / ((1 + heavy.mass * across) * shares),
                                 most_across * state.acceleration[4 * size_t{load->particle} + 3]});
    }
}

/// Pins that move within 60 degrees of a normal lift loads off what is under them.
bool are_lifted(const ContactLoads& loads, Vec3 normal) {
    return loads.pins_move && dot(loads.frame, normal) > length(loads.frame) / 2;
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

/// Finds the velocity of the models that the cloth touches; returns false if they have several, or pins hold the cloth.
bool find_frame(Cloth& cloth) {
    // Relative: the rounding of displacements.
    constexpr double rounding = 0.01;
    const ClothContacts& contacts = cloth.contacts;
    const auto way_of = [&](uint32_t number) {
        const ClothContact& n = contacts.candidates[number];
        const Vec3 start = get(&cloth.state.start[4 * size_t{n.particle}]);
        return place_on_plane(n, cloth.moving_colliders, start) - start;
    };
    Vec3 mean;
    for (const uint32_t number : contacts.active) mean += way_of(number) / static_cast<double>(contacts.active.size());
    cloth.loads.frame = mean / cloth.loads.seconds;
    return cloth.state.held.empty() &&
           std::all_of(contacts.active.begin(), contacts.active.end(), [&](uint32_t number) {
               return length_squared(way_of(number) - mean) <= rounding * rounding * length_squared(mean);
           });
}

/// The mean velocity of pins.
Vec3 frame_of_pins(const Cloth& cloth) {
    const ClothState& state = cloth.state;
    Vec3 sum;
    for (const uint32_t p : state.held) sum += get(&state.at[4 * size_t{p}]) - get(&state.start[4 * size_t{p}]);
    return sum / (static_cast<double>(state.held.size()) * cloth.loads.seconds);
}

/// Per average mass. The prediction has moved the cloth without its links, so their energy is that at the start of the
/// substep, and the motion is that to the predicted places, where contacts have pushed. That of loads does not count
/// where the cloth ceases to yield: its chords get back to their lengths at once, which is no motion, and would throw
/// the loads up.
double energy_before_links(Cloth& cloth) {
    ClothState& state = cloth.state;
    const double h = cloth.loads.seconds;
    const Vec3 frame = cloth.loads.frame;
    double sum =
        energy_of_cloth(state, [&](size_t i) { return (get(&state.at[i]) - get(&state.start[i])) / h - frame; });
    for (const HeavyBody& heavy : cloth.loads.heavy) {
        sum += cloth.yielding.end_under_load ? potential_energy_of(heavy) : energy_of(heavy, frame);
    }
    state.at.swap(state.start);
    sum += stored_energy(cloth);
    state.at.swap(state.start);
    return sum;
}

/// Mass * square of the way in the substep, of cloth and loads.
double motion_before_links(const Cloth& cloth) {
    const ClothState& state = cloth.state;
    const double h = cloth.loads.seconds;
    double sum = 0;
    for (size_t i = 0; i < 4 * size_t{state.particles}; i += 4)
        sum += state.acceleration[i + 3] * length_squared(get(&state.at[i]) - get(&state.start[i]));
    for (const HeavyBody& heavy : cloth.loads.heavy) sum += product(heavy, heavy.motion, heavy.motion) * h * h;
    return sum;
}

/// Takes up to `energy`, per average mass, from what the links have added to the motion of loads that models carry.
/// Returns which part of that stays.
double take_from_carried(ContactLoads& loads, double& energy) {
    // With the part p, the energy of these loads is a p^2 + b p and a constant.
    double a = 0, b = 0;
    for (const HeavyBody& heavy : loads.heavy) {
        if (!heavy.carried) continue;
        const LoadMotion added = heavy.motion - heavy.before;
        a += product(heavy, added, added) / 2;
        b += product(heavy, heavy.before - LoadMotion{loads.frame, {}}, added);
    }
    if (!(2 * a + b > 0)) return 1;  // the links have slowed them
    const double least = std::max(0.0, -b / (2 * a)), most_taken = (a * (1 + least) + b) * (1 - least);
    const double part =
        energy >= most_taken ? least : (std::sqrt(std::max(0.0, b * b + 4 * a * (a + b - energy))) - b) / (2 * a);
    energy -= std::min(energy, most_taken);
    for (HeavyBody& heavy : loads.heavy) {
        if (heavy.carried) heavy.motion = heavy.before + (heavy.motion - heavy.before) * part;
    }
    return part;
}

/// Takes energy, per average mass, from the motion of cloth and loads that no model carries, relative to their drift.
/// What pins or models hold has only that of the models: their forces change the momentum, and what sweeps add to it is
/// not motion that must stay.
void slow_by(Cloth& cloth, double energy) {
    ClothState& state = cloth.state;
    Vec3 drift = cloth.loads.frame;
    if (state.held.empty() && !cloth.contacts.any_active()) {
        Motion whole = motion_of_cloth(state);
        for (const HeavyBody& heavy : cloth.loads.heavy)
            whole.add(heavy.mass * state.average_mass, heavy.motion.velocity);
        drift = whole.momentum / whole.mass;
    }
    const LoadMotion of_drift{drift, {}};
    double inner = inner_energy_of_cloth(state, cloth.shares, drift) / state.average_mass;
    for (const HeavyBody& heavy : cloth.loads.heavy) {
        const LoadMotion own = heavy.motion - of_drift;
        if (!heavy.carried) inner += product(heavy, own, own) / 2;
    }
    const double kept = energy < inner ? std::sqrt(1 - energy / inner) : 0;
    slow_cloth(state, cloth.shares.team, drift, kept);
    for (HeavyBody& heavy : cloth.loads.heavy) {
        if (!heavy.carried) heavy.motion = of_drift + (heavy.motion - of_drift) * kept;
    }
}

/// Of what carried loads have pushed back, the models get back the part that did not stay.
void give_back(Body& body, const CollisionContext& around, double part) {
    const ClothState& state = body.cloth.state;
    uint32_t i = 0;
    for (const HeavyBody& heavy : body.cloth.loads.heavy) {
        for (; i < heavy.end; ++i) {
            const ContactLoad& load = body.cloth.loads.all[i];
            const uint32_t number = body.cloth.contacts.candidate_of[load.particle];
            if (!heavy.carried || number == ClothContacts::none) continue;
            const ClothContact& n = body.cloth.contacts.candidates[number];
            if (n.active_plane < 0 || !n.active_before_chains) continue;
            const ContactPlane& plane = n.planes[n.active_plane];
            const Vec3 place =
                get(&state.at[4 * size_t{load.particle}]) - plane.normal * body.particles.radius[load.particle];
            add_impulse(body, around, plane.model, state.origin + place,
                        load.taken * (part * state.average_mass * body.cloth.loads.rate));
        }
    }
}

}  // namespace

double energy_after_links(Cloth& cloth) {
    const ClothState& state = cloth.state;
    const Vec3 frame = cloth.loads.frame;
    double sum =
        stored_energy(cloth) + energy_of_cloth(state, [&](size_t i) { return get(&state.velocity[i]) - frame; });
    for (const HeavyBody& heavy : cloth.loads.heavy) sum += energy_of(heavy, frame);
    return sum;
}

bool is_energy_known(const Body& body) {
    const ContactLoads& loads = body.cloth.loads;
    return loads.closed && loads.on_moving == body.cloth.contacts.has_moving_model && !body.targets.act();
}

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
    uint32_t first = 0;
    for (const HeavyBody& heavy : cloth.loads.heavy) {
        divide(heavy, &cloth.loads.all[first], cloth.loads.all.data() + heavy.end, cloth.state);
        first = heavy.end;
    }
    for (const ContactLoad& load : cloth.loads.all) {
        cloth.loads.is_loaded[load.particle] = 1;
        set_inertia(cloth.tethers, load, cloth.state.at[4 * size_t{load.particle} + 3]);
    }
    cloth.yielding.collapsed_time = YieldingChords::loaded;
    cloth.loads.seconds = h;
    cloth.loads.rate = TimeScheme(h, body.history.earlier_step).next / h;
}

void note_energy(Cloth& cloth, double h) {
    ContactLoads& loads = cloth.loads;
    loads.seconds = h;
    loads.on_moving = cloth.contacts.has_moving_model;
    loads.frame = {};
    if (loads.on_moving) {
        loads.closed = loads.closed && find_frame(cloth);
    } else if (loads.pins_move) {
        loads.frame = frame_of_pins(cloth);
    }
    loads.energy = energy_before_links(cloth);
}

void note_motion(Cloth& cloth) {
    ContactLoads& loads = cloth.loads;
    note_places(loads, cloth.state);
    loads.predicted = cloth.state.at;
    note_energy(cloth, loads.seconds);
    loads.motion = motion_before_links(cloth);
    uint32_t i = 0;
    for (HeavyBody& heavy : loads.heavy) {
        for (; i < heavy.end; ++i) {
            const Vec3 normal = get(&cloth.in_chains.normals[4 * size_t{loads.all[i].particle}]);
            heavy.carried = heavy.carried || (length_squared(normal) > 0 && !are_lifted(loads, normal));
        }
    }
}

void add_inertia_of_tension(Cloth& cloth) {
    // Of the taut chain to the load: links pull at it with its force divided by this, on both sides.
    constexpr double slope = 1.0 / 3;
    const double farthest = slope * cloth.batches.link_length;
    const ClothState& state = cloth.state;
    const ContactLoads& loads = cloth.loads;
    const bool is_held = !state.held.empty() || cloth.contacts.any_active();
    const auto is_carried = [](const HeavyBody& heavy) { return heavy.carried; };
    if (cloth.batches.softness.empty() || !is_held || !loads.closed ||
        std::all_of(loads.heavy.begin(), loads.heavy.end(), is_carried))
        return;
    const Motion whole = motion_of_cloth(state);
    const Vec3 drift = whole.momentum / whole.mass;
    const Vector<float>& softness = cloth.batches.softness;
    const float least_softness = *std::min_element(softness.begin(), softness.end());
    double mass = 1;
    for (const HeavyBody& heavy : loads.heavy) {
        const double share = heavy.mass / heavy.shares;
        // Links that are more elastic stretch before they stop it.
        if (is_carried(heavy) || share * least_softness > 1) continue;
        const double way = length(heavy.motion.velocity - drift) * loads.seconds;
        mass = std::max(mass, way < farthest ? share * (way / farthest) : share);
    }
    if (!(mass > 1)) return;
    const float part = static_cast<float>(1 / mass);
    for (uint32_t p = 0; p < state.particles; ++p) {
        float* const diagonal = &cloth.tethers.diagonal[4 * size_t{p}];
        if (!loads.is_loaded[p]) std::fill(diagonal, diagonal + 3, part);
    }
}

void note_places(ContactLoads& loads, const ClothState& state) {
    for (ContactLoad& load : loads.all) load.place = get(&state.at[4 * size_t{load.particle}]);
}

void move_loads(ContactLoads& loads, const ClothState& state) {
    uint32_t i = 0;
    for (HeavyBody& heavy : loads.heavy) {
        Vec3 impulse, moment;
        for (; i < heavy.end; ++i) {
            ContactLoad& load = loads.all[i];
            const Vec3 displacement = get(&state.at[4 * size_t{load.particle}]) - load.place;
            const double off = dot(displacement, load.normal);
            const Vec3 taken = load.normal * (load.along * off) + (displacement - load.normal * off) * load.across;
            impulse += taken;
            moment += cross(load.arm, taken);
            load.taken += taken;
            load.impulse += load.along * off;
        }
        heavy.moved += impulse / heavy.mass;
        heavy.turned += heavy.inverse_inertia * moment;
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

        void add(double mass_moved, Vec3 displacement) {
            square += mass_moved * length_squared(displacement);
            mass += mass_moved;
        }
    };
    Moved cloth_alone, moved[2];  // loads in the air, and on models
    const auto displacement = [&](uint32_t p) {
        return get(&state.at[4 * size_t{p}]) - get(&loads.predicted[4 * size_t{p}]);
    };
    for (uint32_t p = 0; p < state.particles; ++p) {
        if (!loads.is_loaded[p]) cloth_alone.add(state.acceleration[4 * size_t{p} + 3], displacement(p));
    }
    uint32_t i = 0;
    for (const HeavyBody& heavy : loads.heavy) {
        for (; i < heavy.end; ++i) {
            const ContactLoad& load = loads.all[i];
            const double mass = state.acceleration[4 * size_t{load.particle} + 3] + load.along;
            moved[heavy.carried].add(mass, displacement(load.particle));
        }
    }
    // All may have to follow the pins.
    double way = 0;
    for (const uint32_t p : state.held)
        way = std::max(way, distance(get(&state.at[4 * size_t{p}]), get(&state.start[4 * size_t{p}])));
    const auto is_thrown = [&](const Moved& part, double error) {
        const double strained = error * cloth.batches.link_length + way;
        return !(part.square <= farthest * farthest * loads.motion + part.mass * strained * strained);
    };
    const double longest = static_cast<double>(cloth.batches.longest);
    return is_thrown(cloth_alone, longest) || is_thrown(moved[0], longest) || is_thrown(moved[1], error_on_model);
}

void undo_loads(Cloth& cloth) {
    ContactLoads& loads = cloth.loads;
    cloth.state.at = loads.predicted;
    cloth.tethers.clear();
    for (ContactLoad& load : loads.all) {
        load.along = load.across = load.impulse = 0;
        load.taken = {};
    }
    for (HeavyBody& heavy : loads.heavy) heavy.moved = heavy.turned = {};
    note_places(loads, cloth.state);
}

void limit_friction_of_loads(Cloth& cloth) {
    ContactLoads& loads = cloth.loads;
    const ClothContacts& contacts = cloth.contacts;
    if (!contacts.any_active()) return;
    uint32_t first = 0;
    for (HeavyBody& heavy : loads.heavy) {
        Vec3 normals, of_models, taken;
        double friction = 0;
        const uint32_t begin = std::exchange(first, heavy.end);
        for (uint32_t i = begin; i < heavy.end; ++i) {
            const ContactLoad& load = loads.all[i];
            normals += load.normal;
            taken += load.taken;
            friction = std::max(friction, load.friction);
            const uint32_t number = contacts.candidate_of[load.particle];
            if (number == ClothContacts::none) continue;
            const ClothContact& n = contacts.candidates[number];
            for (uint32_t k = 0; k < n.plane_count; ++k) of_models += n.planes[k].normal;
        }
        if (!(length_squared(of_models) > 0) || !(length_squared(normals) > 0)) continue;
        if (are_lifted(loads, of_models / length(of_models))) continue;
        const Vec3 normal = normals / length(normals);
        const auto across = [&](Vec3 v) { return v - normal * dot(v, normal); };
        // Contacts with cloth open and close from substep to substep, and their impulses vary: the weight is their
        // mean.
        const double weight = heavy.mass * std::max(0.0, -dot(heavy.acceleration, normal));
        const double most = friction * (weight * loads.seconds * loads.seconds + std::max(0.0, dot(taken, normal)));
        // |by contacts + kept * by links| = most
        const Vec3 by_links = across(taken), by_contacts = across(heavy.pushed);
        const double a = length_squared(by_links), b = dot(by_links, by_contacts),
                     c = length_squared(by_contacts) - most * most;
        if (!(a > 0) || !(a + 2 * b + c > 0)) continue;
        const double kept = std::max(0.0, (std::sqrt(std::max(0.0, b * b - a * c)) - b) / a);
        if (!(kept < 1)) continue;
        const Vec3 beyond = by_links * (1 - kept), of_share = beyond / (heavy.end - begin);
        Vec3 moment;
        for (uint32_t i = begin; i < heavy.end; ++i) {
            loads.all[i].taken -= of_share;
            moment += cross(loads.all[i].arm, of_share);
        }
        heavy.moved -= beyond / heavy.mass;
        heavy.turned -= heavy.inverse_inertia * moment;
    }
}

void take_pulls_of_loads(const ContactLoads& loads, ChainContacts& in_chains) {
    for (const ContactLoad& load : loads.all) {
        float* const pull = &in_chains.pulls[4 * size_t{load.particle}];
        put(pull, get(pull) - load.taken);
    }
}

void accelerate_loads(Body& body, const CollisionContext& around) {
    Cloth& cloth = body.cloth;
    ContactLoads& loads = cloth.loads;
    for (HeavyBody& heavy : loads.heavy) {
        heavy.place += heavy.moved;
        heavy.before = heavy.motion;
    }
    uint32_t i = 0;
    for (HeavyBody& heavy : loads.heavy) {
        Vec3 moment;
        for (; i < heavy.end; ++i) moment += cross(loads.all[i].arm, loads.all[i].taken);
        heavy.motion = heavy.motion + LoadMotion{heavy.moved, moment} * loads.rate;
    }
    if (!body.plan.joined && is_energy_known(body)) {
        double gain = energy_after_links(cloth) - loads.energy;
        if (gain > 0) {
            const double kept = take_from_carried(loads, gain);
            if (kept < 1) give_back(body, around, 1 - kept);
            if (gain > 0) slow_by(cloth, gain);
        }
    }
    i = 0;
    for (const HeavyBody& heavy : loads.heavy) {
        const uint32_t first = i;
        Vec3 sum;
        for (; i < heavy.end; ++i) sum += loads.all[i].normal * loads.all[i].impulse;
        const double square = length_squared(sum);
        const double part =
            square > 0 ? dot(heavy.motion.velocity - heavy.before.velocity, sum) * heavy.mass / square : 0;
        for (uint32_t k = first; k < i; ++k) loads.all[k].impulse *= part;
    }
}

void clear_loads(ContactLoads& loads) {
    for (const ContactLoad& load : loads.all) loads.is_loaded[load.particle] = 0;
    loads.all.clear();
    loads.heavy.clear();
}

}  // namespace gphys
