// Finds the loads of ropes among the contacts, and moves them with the ropes (rope_loads.h).
#include "solver/contact/rope_loads.h"

#include <algorithm>

#include "solver/contact/collision.h"
#include "solver/time_scheme.h"

namespace gphys {
namespace {

/// Joules, of elastic links.
double elastic_energy(const Body& rope) {
    double energy = 0;
    each_link(rope.plan, [&](uint32_t link, uint32_t, uint32_t) {
        energy += rope.plan.compliance[link] * rope.rope.tension[link] * rope.rope.tension[link] / 2;
    });
    return energy;
}

double kinetic_energy(const Body& rope, uint32_t p, Vec3 velocity) {
    return rope.particles.pinned(p) ? 0 : rope.particles.mass[p] * length_squared(velocity) / 2;
}

double kinetic_energy(const Body& rope) {
    double energy = 0;
    for (uint32_t p = 0; p < rope.particles.size(); ++p) energy += kinetic_energy(rope, p, rope.particles.velocity[p]);
    return energy;
}

/// The velocity at the end of a substep in which links and contacts have no effect.
Vec3 predicted_velocity(const History& history, uint32_t p, Vec3 place, const TimeScheme& scheme) {
    const Vec3 before = scheme.from_history(history.start[p], history.earlier[p], history.start_velocity[p]);
    return (place * scheme.next - before) / scheme.h;
}

/// Whether something outside may do work on a rope: pins and models that move, targets; and bends, whose energy is not
/// counted.
bool works(const Body& rope, const CollisionContext& around) {
    if (!rope.targets.empty() || rope.rope.bending.resists() || !rope.constraints.length_changes.empty()) return true;
    for (uint32_t p = 0; p < rope.particles.size(); ++p) {
        if (rope.particles.pinned(p) && rope.particles.velocity[p] != Vec3{}) return true;
    }
    const Vector<ModelImpulse>& impulses = rope.contacts.impulses;
    return std::any_of(impulses.begin(), impulses.end(),
                       [&](const ModelImpulse& impulse) { return has_moved(around, impulse.model); });
}

/// Whether pins or models hold a rope.
bool is_held(const Body& rope) {
    for (uint32_t p = 0; p < rope.particles.size(); ++p) {
        if (rope.particles.pinned(p)) return true;
    }
    return !rope.contacts.impulses.empty();
}

}  // namespace

/// A particle that a model or another rope carries is no load's: the contacts press on that, too, and between a load
/// and that the links would throw the rope.
void ParticleContacts::RopeLoads::add(const Pair& pair, const Contact& contact, uint32_t on, uint32_t by, Vec3 normal) {
    // Of a lighter load the rope hardly feels the weight.
    constexpr double heavy = 4;
    const Particle& particle = range_.particles[on];
    Body& rope = bodies_[particle.body];
    if (!is_rope(rope) || rope.plan.joined || particle.supports || particle.on_other ||
        !may_press(bodies_[range_.particles[by].body]))
        return;
    const uint32_t of = heavy_.first_of(by);
    if (of == HeavyBodies::none || particle.inverse_mass < heavy * heavy_.inverse_mass_of(of)) return;
    Vector<RopeLoad>& all = rope.rope.loads.all;
    if (all.size() == all.capacity()) return;
    all.push_back({of, by, particle.number, static_cast<uint32_t>(&pair - range_.pairs), normal, contact.friction > 0});
    ++range_.particles[of].rope_shares;
}

void ParticleContacts::RopeLoads::divide_loads(Body& rope, Vec3 gravity, double h) {
    rope.rope.loads.rate = TimeScheme(h, rope.history.earlier_step).next / h;
    Vector<RopeLoad>& all = rope.rope.loads.all;
    Vector<HeavyBody>& heavy = rope.rope.loads.heavy;
    std::sort(all.begin(), all.end(), [](const RopeLoad& a, const RopeLoad& b) {
        if (a.of != b.of) return a.of < b.of;
        return a.particle != b.particle ? a.particle < b.particle : a.by < b.by;
    });
    for (uint32_t k = 0; k < all.size(); ++k) {
        RopeLoad& load = all[k];
        if (heavy.empty() || heavy.back().of != load.of) {
            if (heavy.size() == heavy.capacity()) {
                all.erase(all.begin() + k, all.end());
                return;
            }
            heavy.push_back(heavy_.find(load.of, units, gravity, h));
            const Vec3 faster = heavy_.pushed(heavy.back()) / h;
            heavy.back().lost = heavy.back().mass * dot(faster / 2 - heavy.back().motion.velocity, faster);
        }
        HeavyBody& of = heavy.back();
        of.end = k + 1;
        const Particle& by = range_.particles[load.by];
        load.arm = place_of(bodies_[by.body], by.number) - of.place;
        const Vec3 torque = cross(load.arm, load.normal);
        const double inverse_mass = 1 / of.mass + dot(torque, of.inverse_inertia * torque);
        load.along = 1 / (inverse_mass * range_.particles[load.of].rope_shares);
        load.across = load.sticks ? load.along : 0;
        load.place = rope.particles.position[load.particle];
    }
}

void ParticleContacts::RopeLoads::find(Vec3 gravity, double h) {
    const auto any_body = [&](bool (*is)(const Body&)) {
        return std::any_of(first_, end_, [&](uint32_t slot) { return is(bodies_[slot]); });
    };
    if (!any_body(is_rope) || !any_body(may_press)) return;
    for (Particle* p = range_.particles; p != range_.particles + range_.count; ++p)
        p->on_other = false, p->rope_shares = 0;
    each_between_bodies(range_, [&](const Pair&, const Contact& contact) {
        Particle &a = range_.particles[contact.a], &b = range_.particles[contact.b];
        if (is_rope(bodies_[a.body]) && is_rope(bodies_[b.body])) a.on_other = b.on_other = true;
    });
    each_between_bodies(range_, [&](const Pair& pair, const Contact& contact) {
        if (!(contact.all_separation() > 0)) return;
        add(pair, contact, contact.a, contact.b, contact.normal);
        add(pair, contact, contact.b, contact.a, -contact.normal);
    });
    for (const uint32_t* slot = first_; slot != end_; ++slot) {
        Body& body = bodies_[*slot];
        if (!is_rope(body)) continue;
        body.rope.loads.energy = elastic_energy(body);
    }
    // Without the pushes of contacts: a rope that gives way gets energy that no load has lost.
    for (const Particle* p = range_.particles; p != range_.particles + range_.count; ++p) {
        Body& body = bodies_[p->body];
        if (!is_rope(body)) continue;
        const TimeScheme scheme(h, body.history.earlier_step);
        body.rope.loads.energy +=
            kinetic_energy(body, p->number, predicted_velocity(body.history, p->number, p->uncorrected, scheme));
    }
    for (const uint32_t* slot = first_; slot != end_; ++slot) divide_loads(bodies_[*slot], gravity, h);
}

bool ParticleContacts::RopeLoads::any() const {
    return std::any_of(first_, end_, [&](uint32_t slot) { return bodies_[slot].rope.loads.any(); });
}

/// Moves the loads of a rope, and gives them the speed of that motion.
void ParticleContacts::RopeLoads::move_by(Body& rope) {
    const double rate = rope.rope.loads.rate;
    const Vector<RopeLoad>& all = rope.rope.loads.all;
    const RopeLoad* load = all.data();
    for (HeavyBody& of : rope.rope.loads.heavy) {
        Vec3 momentum, spin;  // divided by the rate
        for (; load != all.data() + of.end; ++load) {
            const Vec3 taken = load->momentum(rope.particles.position[load->particle] - load->place);
            momentum += taken;
            spin += cross(load->arm, taken);
            const double impulse = dot(taken, load->normal) * rate;
            Pair& pair = range_.pairs[load->pair];
            if (impulse > 0) add_to_list(range_, pair, pair.b == load->by ? load->normal : -load->normal, impulse);
        }
        uint32_t& shares = range_.particles[of.of].rope_shares;
        of.first = shares > 0;
        shares = 0;
        of.moved = momentum / of.mass;
        of.turned = of.inverse_inertia * spin;
        of.before = of.motion = heavy_.motion_of(of, units);
        of.motion.velocity += of.moved * rate;
        of.motion.spin += spin * rate;
        heavy_.move(of);
    }
}

/// Calls visit(load) once for each that has been moved, with the motion before and after.
template <class Visit>
void ParticleContacts::RopeLoads::each_load(Visit&& visit) {
    for (const uint32_t* slot = first_; slot != end_; ++slot) {
        for (HeavyBody& heavy : bodies_[*slot].rope.loads.heavy) {
            if (!heavy.first) continue;
            heavy.motion = heavy_.motion_of(heavy, units);
            visit(heavy);
        }
    }
}

void ParticleContacts::RopeLoads::bound_energy(const CollisionContext& around) {
    double available = 0;  // joules: what the ropes have lost
    bool held = false;
    for (const uint32_t* slot = first_; slot != end_; ++slot) {
        const Body& body = bodies_[*slot];
        if (!is_rope(body)) continue;
        if (works(body, around)) return;
        held = held || is_held(body);
        available += body.rope.loads.energy - kinetic_energy(body) - elastic_energy(body);
    }
    if (!held) return;
    // With a part s of the change of their motion, the loads have s (linear + s square) more.
    double linear = 0, square = 0;
    each_load([&](const HeavyBody& heavy) {
        available += std::max(heavy.lost, 0.0);
        const Vec3 faster = heavy.motion.velocity - heavy.before.velocity;
        const Vec3 spin = heavy.motion.spin - heavy.before.spin, turning = heavy.inverse_inertia * spin;
        linear += heavy.mass * dot(heavy.before.velocity, faster) + dot(heavy.before.spin, turning);
        square += (heavy.mass * length_squared(faster) + dot(spin, turning)) / 2;
    });
    if (!(linear + square > available) || !(square > 0)) return;
    // The largest part with that energy, or else that with the least.
    const double root = linear * linear + 4 * square * available;
    const double part = std::clamp((std::sqrt(std::max(root, 0.0)) - linear) / (2 * square), 0.0, 1.0);
    each_load([&](HeavyBody& heavy) {
        const LoadMotion whole = heavy.motion;
        heavy.moved = heavy.turned = {};
        heavy.motion.velocity = heavy.before.velocity + (whole.velocity - heavy.before.velocity) * part;
        heavy.motion.spin = heavy.before.spin + (whole.spin - heavy.before.spin) * part;
        heavy.before = whole;
        heavy_.move(heavy);
    });
}

void ParticleContacts::RopeLoads::move(const CollisionContext& around) {
    for (const uint32_t* slot = first_; slot != end_; ++slot) move_by(bodies_[*slot]);
    bound_energy(around);
    for (const uint32_t* slot = first_; slot != end_; ++slot) bodies_[*slot].rope.loads.clear();
}

}  // namespace gphys
