// Finds the loads of cloth among the contacts, and moves them with it (cloth_loads.h).
#include "solver/contact/cloth_loads.h"

#include "solver/contact/collision.h"
#include "solver/joints/joined_motion.h"

namespace gphys {

void ParticleContacts::ClothLoads::add(const Pair& pair, const Contact& contact, uint32_t on, uint32_t by,
                                       Vec3 normal) {
    // A load is at least as many times heavier: what is lighter gives way by itself.
    constexpr double heavy = 4;
    const Particle& particle = range_.particles[on];
    Body& body = bodies_[particle.body];
    if (!may_be_loaded(body) || !HeavyBodies::may_press(bodies_[range_.particles[by].body])) return;
    if (body.cloth.loads.is_loaded[particle.number]) return;
    const uint32_t of = heavy_.first_of(by);
    if (of == HeavyBodies::none || particle.inverse_mass < heavy * heavy_.inverse_mass_of(of)) return;
    body.cloth.loads.is_loaded[particle.number] = 1;
    ++range_.particles[of].cloth_shares;
    body.cloth.loads.all.push_back(
        {of, by, particle.number, static_cast<uint32_t>(&pair - range_.pairs), normal, contact.friction});
}

/// A rope that lies on cloth near a model is carried by that. Between the links of both it would not rest, so then its
/// particles are no loads.
void ParticleContacts::ClothLoads::leave_out_carried_ropes(ContactLoads& loads) const {
    const auto is_rope = [&](const ContactLoad& share) {
        return !is_graph(body_of(share)) && !moves_freely(body_of(share));
    };
    const auto is_carried = [&](const ContactLoad& share) {
        const Pair& pair = range_.pairs[share.pair];
        return is_rope(share) && range_.particles[pair.a == share.by ? pair.b : pair.a].supports != nullptr;
    };
    if (std::none_of(loads.all.begin(), loads.all.end(), is_carried)) return;
    for (const ContactLoad& share : loads.all) {
        if (!is_rope(share)) continue;
        loads.is_loaded[share.particle] = 0;
        --range_.particles[share.of].cloth_shares;
    }
    loads.all.erase(std::remove_if(loads.all.begin(), loads.all.end(), is_rope), loads.all.end());
}

void ParticleContacts::ClothLoads::find(Vec3 gravity, double h) {
    const auto any_body = [&](bool (*is)(const Body&)) {
        return std::any_of(first_, end_, [&](uint32_t slot) { return is(bodies_[slot]); });
    };
    if (!any_body(HeavyBodies::may_press) || !any_body(may_be_loaded)) return;
    for (Particle* p = range_.particles; p != range_.particles + range_.count; ++p) p->cloth_shares = 0;
    // Contacts with a small gap count, too: where a heavy particle has given cloth its own velocity, contacts open and
    // close from substep to substep.
    each_between_bodies(range_, [&](const Pair& pair, const Contact& contact) {
        add(pair, contact, contact.a, contact.b, contact.normal);
        add(pair, contact, contact.b, contact.a, -contact.normal);
    });
    for (const uint32_t* slot = first_; slot != end_; ++slot) {
        Body& body = bodies_[*slot];
        ContactLoads& loads = body.cloth.loads;
        leave_out_carried_ropes(loads);
        if (!loads.any()) continue;
        std::sort(loads.all.begin(), loads.all.end(), [](const ContactLoad& a, const ContactLoad& b) {
            return a.of != b.of ? a.of < b.of : a.particle < b.particle;
        });
        for (uint32_t k = 0; k < loads.all.size(); ++k) {
            ContactLoad& share = loads.all[k];
            if (k == 0 || loads.heavy.back().of != share.of) {
                loads.heavy.push_back(heavy_.find(share.of, units_of(body), gravity, h));
                loads.heavy.back().pushed = heavy_.pushed(loads.heavy.back()) * loads.heavy.back().mass;
            }
            HeavyBody& heavy = loads.heavy.back();
            heavy.shares = range_.particles[share.of].cloth_shares;
            heavy.end = k + 1;
            const Particle& by = range_.particles[share.by];
            if (is_graph(bodies_[by.body]))
                share.arm = place_of(bodies_[by.body], by.number) - body.cloth.state.origin - heavy.place;
        }
        begin_loads(body, h);
    }
}

/// Slows joined bodies and their loads so that links and joints have not added energy.
void ParticleContacts::ClothLoads::bound_joined_energy(const Joined& joined, Vec3 gravity) {
    const auto each_load = [&](auto&& visit) {
        gphys::each_body(joined, [&](Body& body, uint32_t) {
            for (HeavyBody& heavy : body.cloth.loads.heavy) visit(heavy, units_of(body));
        });
    };
    each_load([&](HeavyBody& heavy, const LoadUnits& units) { heavy.motion = heavy_.motion_of(heavy, units); });
    const double kept = slow_joined(joined, gravity);
    if (kept == 1) return;
    each_load([&](HeavyBody& heavy, const LoadUnits& units) {
        uint32_t& shares = range_.particles[heavy.of].cloth_shares;
        if (shares == 0) return;  // done, for another cloth
        shares = 0;
        heavy.moved = heavy.turned = {};
        heavy.before = heavy_.motion_of(heavy, units);
        heavy.motion = {heavy.before.velocity * kept, heavy.before.spin * kept};
        heavy_.move(heavy);
    });
}

bool ParticleContacts::ClothLoads::any() const {
    return std::any_of(first_, end_, [&](uint32_t slot) { return bodies_[slot].cloth.loads.any(); });
}

void ParticleContacts::ClothLoads::move(const Joined& joined, const CollisionContext& around, Vec3 gravity) {
    for (const uint32_t* slot = first_; slot != end_; ++slot) {
        Body& body = bodies_[*slot];
        ContactLoads& loads = body.cloth.loads;
        if (!loads.any()) continue;
        for (HeavyBody& heavy : loads.heavy) {
            const LoadMotion before = std::exchange(heavy.motion, heavy_.motion_of(heavy, units_of(body)));
            // What its own links have done to a particle of a rope is no work of the cloth.
            if (bodies_[range_.particles[heavy.of].body].plan.method != GPHYS_SOLVE_DIRECT) continue;
            loads.energy +=
                heavy.mass *
                (length_squared(heavy.motion.velocity - loads.frame) - length_squared(before.velocity - loads.frame)) /
                2;
        }
        accelerate_loads(body, around);
        for (const HeavyBody& heavy : loads.heavy) heavy_.move(heavy);
    }
    bound_joined_energy(joined, gravity);
    for (const uint32_t* slot = first_; slot != end_; ++slot) {
        Body& body = bodies_[*slot];
        ContactLoads& loads = body.cloth.loads;
        if (!loads.any()) continue;
        for (const ContactLoad& share : loads.all) {
            Pair& pair = range_.pairs[share.pair];
            const double impulse = share.impulse * body.cloth.state.average_mass;
            if (impulse > 0) add_to_list(range_, pair, pair.b == share.by ? share.normal : -share.normal, impulse);
        }
        clear_loads(loads);
        if (body.plan.joined) body.cloth.tethers.clear();
    }
}

}  // namespace gphys
