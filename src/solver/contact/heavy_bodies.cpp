// Finds the mass, inertia and motion of loads, and moves them (heavy_bodies.h).
#include "solver/contact/heavy_bodies.h"

#include <algorithm>

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

uint32_t ParticleContacts::HeavyBodies::first_of(uint32_t by) const {
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

double ParticleContacts::HeavyBodies::inverse_mass_of(uint32_t of) const {
    const Particle& particle = range_.particles[of];
    const Body& body = bodies_[particle.body];
    if (!is_graph(body)) return particle.inverse_mass;
    double mass = 0;
    for (const ClusterMember& member : cluster_with(body.cloth.clusters, particle.number))
        mass += body.particles.mass[member.particle];
    return 1 / mass;
}

HeavyBody ParticleContacts::HeavyBodies::particle(uint32_t of, const LoadUnits& units, Vec3 gravity, double h) const {
    const Particle& particle = range_.particles[of];
    const Body& body = bodies_[particle.body];
    const Particles& others = body.particles;
    HeavyBody heavy{};
    heavy.of = of;
    heavy.mass = 1 / (particle.inverse_mass * units.mass);
    heavy.inverse_inertia = {{}, {}, {}};
    Vec3 place = others.position[particle.number], velocity = others.velocity[particle.number];
    if (!moves_freely(body)) {
        // Links and contacts of a rope give their velocities at the end of the substep.
        const Vec3 before = body.history.start[particle.number];
        velocity = (place - before) / h;
        keep_in_range(place, velocity, before);
    }
    heavy.place = place - units.origin;
    heavy.motion.velocity = velocity;
    heavy.acceleration = gravity + others.force[particle.number] * particle.inverse_mass;
    return heavy;
}

HeavyBody ParticleContacts::HeavyBodies::cluster(uint32_t of, const LoadUnits& units, double h) const {
    const Particle& particle = range_.particles[of];
    const Body& body = bodies_[particle.body];
    const ClothState& state = body.cloth.state;
    const ClusterRange members = cluster_with(body.cloth.clusters, particle.number);
    const Centre centre(state, members);
    const double scale = state.average_mass / units.mass;
    HeavyBody heavy{};
    heavy.of = of;
    heavy.mass = centre.mass * scale;
    heavy.place = centre.at + state.origin - units.origin;
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

HeavyBody ParticleContacts::HeavyBodies::find(uint32_t of, const LoadUnits& units, Vec3 gravity, double h) const {
    const bool alone = !is_graph(bodies_[range_.particles[of].body]);
    return alone ? particle(of, units, gravity, h) : cluster(of, units, h);
}

LoadMotion ParticleContacts::HeavyBodies::motion_of(const HeavyBody& heavy, const LoadUnits& units) const {
    const Particle& particle = range_.particles[heavy.of];
    const Body& body = bodies_[particle.body];
    if (!is_graph(body)) return {body.particles.velocity[particle.number], {}};
    const ClothState& state = body.cloth.state;
    const ClusterRange members = cluster_with(body.cloth.clusters, particle.number);
    LoadMotion motion =
        motion_of_cluster(state, members, Centre(state, members), [&](size_t i) { return get(&state.velocity[i]); });
    motion.spin *= state.average_mass / units.mass;
    return motion;
}

void ParticleContacts::HeavyBodies::move_cluster(const HeavyBody& heavy) {
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

Vec3 ParticleContacts::HeavyBodies::pushed(const HeavyBody& heavy) const {
    const Particle& first = range_.particles[heavy.of];
    const Body& body = bodies_[first.body];
    if (!is_graph(body)) return first.at - first.uncorrected;
    const Particle* const of_body = &first - first.number;
    Vec3 sum;
    double mass = 0;
    for (const ClusterMember& member : cluster_with(body.cloth.clusters, first.number)) {
        const Particle& p = of_body[member.particle];
        sum += (p.at - p.uncorrected) / p.inverse_mass;
        mass += 1 / p.inverse_mass;
    }
    return sum / mass;
}

void ParticleContacts::HeavyBodies::move(const HeavyBody& heavy) {
    Particle& of = range_.particles[heavy.of];
    Body& body = bodies_[of.body];
    // What has left the range of floats moves nothing else.
    if (!is_finite(heavy.moved) || !is_finite(heavy.motion.velocity)) return;
    if (is_graph(body)) {
        move_cluster(heavy);
        return;
    }
    of.at += heavy.moved;
    body.particles.velocity[of.number] = heavy.motion.velocity;
}

}  // namespace gphys
