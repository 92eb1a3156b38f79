// Finds the loads of cloth among the contacts, and moves them with it (cloth_loads.h).
#include "solver/contact/cloth_loads.h"

#include "solver/cloth/second_moments.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"
#include "solver/state_range.h"

namespace gphys {
namespace {

/// The centre of a cluster, relative to the origin of its body, and its mass, relative to the average of that.
struct Centre {
    Vec3 at;
    double mass = 0;

    Centre(const ClothState& state, ClusterRange members) {
        for (const ClusterMember& member : members) {
            const size_t i = 4 * size_t{member.particle};
            at += get(&state.at[i]) * state.acceleration[i + 3];
            mass += state.acceleration[i + 3];
        }
        at = at / mass;
    }
};

/// The motion of a cluster with the velocities of its particles: velocity(first float of a particle)
template <class Velocity>
LoadMotion motion_of_cluster(const ClothState& state, ClusterRange members, const Centre& centre, Velocity&& velocity) {
    LoadMotion motion;
    for (const ClusterMember& member : members) {
        const size_t i = 4 * size_t{member.particle};
        const Vec3 momentum = velocity(i) * double{state.acceleration[i + 3]};
        motion.velocity += momentum / centre.mass;
        motion.spin += cross(get(&state.at[i]) - centre.at, momentum);
    }
    return motion;
}

}  // namespace

/// The first particle of what moves as one with a particle that presses; none if it is no load, or pins hold it.
uint32_t ParticleContacts::ClothLoads::first_of(uint32_t by) const {
    const Particle& particle = range_.particles[by];
    const Body& body = bodies_[particle.body];
    if (!(particle.inverse_mass > 0) || !may_press(body)) return none;
    if (!is_graph(body)) return by;
    if (!body.cloth.clusters.has(particle.number)) return none;
    const ClusterRange members = cluster_with(body.cloth.clusters, particle.number);
    const Particle* const of_body = &particle - particle.number;
    const bool free = std::all_of(members.begin(), members.end(), [&](const ClusterMember& member) {
        return of_body[member.particle].inverse_mass > 0;
    });
    return free ? by - particle.number + members.first->particle : none;
}

double ParticleContacts::ClothLoads::inverse_mass_of(uint32_t of) const {
    const Particle& particle = range_.particles[of];
    const Body& body = bodies_[particle.body];
    if (!is_graph(body)) return particle.inverse_mass;
    double mass = 0;
    for (const ClusterMember& member : cluster_with(body.cloth.clusters, particle.number))
        mass += body.particles.mass[member.particle];
    return 1 / mass;
}

void ParticleContacts::ClothLoads::add(const Pair& pair, uint32_t on, uint32_t by, Vec3 normal) {
    // A load is at least as many times heavier: what is lighter gives way by itself.
    constexpr double heavy = 4;
    const Particle& particle = range_.particles[on];
    Body& body = bodies_[particle.body];
    if (!may_be_loaded(body) || !may_press(bodies_[range_.particles[by].body])) return;
    if (body.cloth.loads.is_loaded[particle.number]) return;
    const uint32_t of = first_of(by);
    if (of == none || particle.inverse_mass < heavy * inverse_mass_of(of)) return;
    body.cloth.loads.is_loaded[particle.number] = 1;
    body.cloth.loads.all.push_back({of, by, particle.number, static_cast<uint32_t>(&pair - range_.pairs), normal});
}

HeavyBody ParticleContacts::ClothLoads::heavy_particle(uint32_t of, const Body& cloth, Vec3 gravity, double h) const {
    const Particle& particle = range_.particles[of];
    const Body& body = bodies_[particle.body];
    const Particles& others = body.particles;
    HeavyBody heavy{};
    heavy.of = of;
    heavy.mass = 1 / (particle.inverse_mass * cloth.cloth.state.average_mass);
    heavy.inverse_inertia = {{}, {}, {}};
    Vec3 place = others.position[particle.number], velocity = others.velocity[particle.number];
    if (!moves_freely(body)) {
        // Links and contacts of a rope give their velocities at the end of the substep.
        const Vec3 before = body.history.start[particle.number];
        velocity = (place - before) / h;
        keep_in_range(place, velocity, before);
    }
    heavy.place = place - cloth.cloth.state.origin;
    heavy.motion.velocity = velocity;
    heavy.acceleration = gravity + others.force[particle.number] * particle.inverse_mass;
    return heavy;
}

HeavyBody ParticleContacts::ClothLoads::heavy_cluster(uint32_t of, const Body& cloth, double h) const {
    const Particle& particle = range_.particles[of];
    const Body& body = bodies_[particle.body];
    const ClothState& state = body.cloth.state;
    const ClusterRange members = cluster_with(body.cloth.clusters, particle.number);
    const Centre centre(state, members);
    const double scale = state.average_mass / cloth.cloth.state.average_mass;
    HeavyBody heavy{};
    heavy.of = of;
    heavy.mass = centre.mass * scale;
    heavy.place = centre.at + state.origin - cloth.cloth.state.origin;
    // The prediction has moved each of its particles; the shape will keep their momentum.
    heavy.motion = motion_of_cluster(state, members, centre,
                                     [&](size_t i) { return (get(&state.at[i]) - get(&state.start[i])) / h; });
    heavy.motion.spin *= scale;
    SecondMoments moments;
    for (const ClusterMember& member : members) {
        const size_t i = 4 * size_t{member.particle};
        heavy.acceleration += get(&state.acceleration[i]) * (state.acceleration[i + 3] / centre.mass);
        moments.add(get(&state.at[i]) - centre.at, state.acceleration[i + 3] * scale);
    }
    // Contacts have moved single particles out of the shape, and it turns before the loads do.
    constexpr double thinnest = 0.01;
    moments.thicken(thinnest);
    heavy.inverse_inertia = moments.inverse_inertia();
    return heavy;
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
        if (is_rope(share)) loads.is_loaded[share.particle] = 0;
    }
    loads.all.erase(std::remove_if(loads.all.begin(), loads.all.end(), is_rope), loads.all.end());
}

void ParticleContacts::ClothLoads::find(Vec3 gravity, double h) {
    const auto any_body = [&](bool (*is)(const Body&)) {
        return std::any_of(first_, end_, [&](uint32_t slot) { return is(bodies_[slot]); });
    };
    if (!any_body(may_press) || !any_body(may_be_loaded)) return;
    // Contacts with a small gap count, too: where a heavy particle has given cloth its own velocity, contacts open and
    // close from substep to substep.
    each_between_bodies(range_, [&](const Pair& pair, const Contact& contact) {
        add(pair, contact.a, contact.b, contact.normal);
        add(pair, contact.b, contact.a, -contact.normal);
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
                const bool alone = !is_graph(bodies_[range_.particles[share.of].body]);
                loads.heavy.push_back(alone ? heavy_particle(share.of, body, gravity, h)
                                            : heavy_cluster(share.of, body, h));
            }
            HeavyBody& heavy = loads.heavy.back();
            heavy.end = k + 1;
            const Particle& by = range_.particles[share.by];
            if (is_graph(bodies_[by.body]))
                share.arm = place_of(bodies_[by.body], by.number) - body.cloth.state.origin - heavy.place;
        }
        begin_loads(body, h);
    }
}

bool ParticleContacts::ClothLoads::any() const {
    return std::any_of(first_, end_, [&](uint32_t slot) { return bodies_[slot].cloth.loads.any(); });
}

/// As it is now: it may press on several bodies, one of which has moved it.
LoadMotion ParticleContacts::ClothLoads::motion_of(const HeavyBody& heavy, const Body& cloth) const {
    const Particle& particle = range_.particles[heavy.of];
    const Body& body = bodies_[particle.body];
    if (!is_graph(body)) return {body.particles.velocity[particle.number], {}};
    const ClothState& state = body.cloth.state;
    const ClusterRange members = cluster_with(body.cloth.clusters, particle.number);
    LoadMotion motion =
        motion_of_cluster(state, members, Centre(state, members), [&](size_t i) { return get(&state.velocity[i]); });
    motion.spin *= state.average_mass / cloth.cloth.state.average_mass;
    return motion;
}

void ParticleContacts::ClothLoads::move_cluster(const HeavyBody& heavy) {
    Particle& first = range_.particles[heavy.of];
    Particle* const of_body = &first - first.number;
    Body& body = bodies_[first.body];
    ClothState& state = body.cloth.state;
    const ClusterRange members = cluster_with(body.cloth.clusters, first.number);
    const Vec3 centre = Centre(state, members).at, half = heavy.turned / 2;
    const Mat3 rotation = rotation_matrix(Quat{half.x, half.y, half.z, 1});
    const Vec3 faster = heavy.motion.velocity - heavy.before.velocity;
    const Vec3 turning = heavy.inverse_inertia * (heavy.motion.spin - heavy.before.spin);
    for (const ClusterMember& member : members) {
        float* const velocity = &state.velocity[4 * size_t{member.particle}];
        const Vec3 arm = get(&state.at[4 * size_t{member.particle}]) - centre;
        of_body[member.particle].at += heavy.moved + rotation * arm - arm;
        put(velocity, get(velocity) + faster + cross(turning, arm));
    }
}

void ParticleContacts::ClothLoads::move(const CollisionContext& around) {
    for (const uint32_t* slot = first_; slot != end_; ++slot) {
        Body& body = bodies_[*slot];
        ContactLoads& loads = body.cloth.loads;
        if (!loads.any()) continue;
        for (HeavyBody& heavy : loads.heavy) {
            const LoadMotion before = std::exchange(heavy.motion, motion_of(heavy, body));
            // What its own links have done to a particle of a rope is no work of the cloth.
            if (bodies_[range_.particles[heavy.of].body].plan.method != GPHYS_SOLVE_DIRECT) continue;
            loads.energy +=
                heavy.mass *
                (length_squared(heavy.motion.velocity - loads.frame) - length_squared(before.velocity - loads.frame)) /
                2;
        }
        accelerate_loads(body, around);
        for (const HeavyBody& heavy : loads.heavy) {
            Particle& of = range_.particles[heavy.of];
            Body& other = bodies_[of.body];
            // Cloth that has left the range of floats moves nothing else.
            if (!is_finite(heavy.moved) || !is_finite(heavy.motion.velocity)) continue;
            if (is_graph(other)) {
                move_cluster(heavy);
                continue;
            }
            of.at += heavy.moved;
            other.particles.velocity[of.number] = heavy.motion.velocity;
        }
        for (const ContactLoad& share : loads.all) {
            Pair& pair = range_.pairs[share.pair];
            const double impulse = share.impulse * body.cloth.state.average_mass;
            if (impulse > 0) add_to_list(range_, pair, pair.b == share.by ? share.normal : -share.normal, impulse);
        }
        clear_loads(loads);
    }
}

}  // namespace gphys
