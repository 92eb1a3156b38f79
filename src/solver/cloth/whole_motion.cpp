// Conservation of the momentum and angular momentum of cloth, by a rigid correction.
//
// Constraints act between particles, so they change neither. Sweeps over them do: each link is corrected along the
// direction that it had before later links moved its ends, and limiting the energy slows all motion. If all external
// forces on a body are known, it gets back the missing momentum and angular momentum at the end of a substep, as a
// rigid motion. Energy is then only taken from the motion relative to that.
#include "solver/cloth/whole_motion.h"
#include "foundation/elementary.h"
#include "solver/cloth/cloth_contacts.h"
#include "solver/cloth/cloth_state.h"
#include "solver/quads.h"

namespace gphys {
namespace {

/// Moments of some particles, about the origin of the cloth, per average mass.
struct Moments {
    double mass = 0, energy = 0;
    Vec3 first_moment, momentum, angular_momentum;
    Vec3 squares, products;  // of coordinates: xx, yy, zz and yz, zx, xy

    void add(double m, Vec3 at, Vec3 velocity) {
        mass += m;
        first_moment += at * m;
        momentum += velocity * m;
        angular_momentum += cross(at, velocity) * m;
        squares += Vec3{at.x * at.x, at.y * at.y, at.z * at.z} * m;
        products += Vec3{at.y * at.z, at.z * at.x, at.x * at.y} * m;
        energy += length_squared(velocity) * m / 2;
    }
    Vec3 centre() const { return first_moment / mass; }
    /// About the centre of mass.
    Vec3 central_angular_momentum() const { return angular_momentum - cross(centre(), momentum); }
};

/// The angular velocity of a body with these moments and that angular momentum. 0 about an axis through all particles,
/// because the inertia about it is a rounding error.
Vec3 angular_velocity_of(const Moments& body, Vec3 angular_momentum) {
    constexpr double regularisation = 1e-9;
    const Vec3 c = body.centre();
    const Vec3 s = body.squares - Vec3{c.x * c.x, c.y * c.y, c.z * c.z} * body.mass;
    const Vec3 p = body.products - Vec3{c.y * c.z, c.z * c.x, c.x * c.y} * body.mass;
    const double least = regularisation * (s.x + s.y + s.z);
    const Vec3 x{s.y + s.z + least, -p.z, -p.y}, y{-p.z, s.z + s.x + least, -p.x}, z{-p.y, -p.x, s.x + s.y + least};
    const Vec3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
    const double determinant = dot(x, yz);
    if (!(determinant > 0)) return {};
    return Vec3{dot(yz, angular_momentum), dot(zx, angular_momentum), dot(xy, angular_momentum)} / determinant;
}

/// A rigid motion: the velocity at the origin, and the angular velocity.
struct Rigid {
    Vec3 velocity, angular_velocity;

    Vec3 at(Vec3 place) const { return velocity + cross(angular_velocity, place); }
};
Rigid rigid_motion_of(const Moments& body) {
    const Vec3 angular_velocity = angular_velocity_of(body, body.central_angular_momentum());
    return {body.momentum / body.mass - cross(angular_velocity, body.centre()), angular_velocity};
}
/// The energy of the motion relative to the rigid one.
double energy_relative_to_rigid(const Moments& body) {
    const Vec3 angular_momentum = body.central_angular_momentum();
    return body.energy - length_squared(body.momentum) / (2 * body.mass) - dot(angular_momentum, angular_velocity_of(body, angular_momentum)) / 2;
}

/// Calls visit(index of the first float, relative mass) for each particle, in order.
template <class Visit>
void each_particle(const ClothState& state, Visit&& visit) {
    for (size_t i = 0; i < 4 * size_t{state.particles}; i += 4) visit(i, double{state.acceleration[i + 3]});
}

/// Scales the motion relative to the rigid one.
void scale_relative_motion(ClothState& state, const Rigid& rigid, double kept) {
    each_particle(state, [&](size_t i, double) {
        const Vec3 common = rigid.at(get(&state.at[i]));
        put(&state.velocity[i], common + (get(&state.velocity[i]) - common) * kept);
    });
}

/// The factor for velocities that removes an energy from `of`.
double scale_without(double energy, double of) { return energy < of ? std::sqrt(1 - energy / of) : 0; }

}  // namespace

void keep_momentum(ClothState& state, const ClothContacts& contacts, bool closed, double damping, double h,
                   double stored) {
    Moments before, after;
    Vec3 force, torque_before, torque_after;
    double work = 0;
    each_particle(state, [&](size_t i, double m) {
        const Vec3 start = get(&state.start[i]), at = get(&state.at[i]), load = get(&state.acceleration[i]) * m;
        before.add(m, start, get(&state.velocity_before[i]));
        after.add(m, at, get(&state.velocity[i]));
        force += load;
        torque_before += cross(start, load);
        torque_after += cross(at, load);
        work += dot(load, at - start);
    });
    torque_before -= cross(before.centre(), force);
    torque_after -= cross(after.centre(), force);
    const double z = damping * h;
    const Decay decay = gphys::decay(z);
    const double acting = z > 0 ? h * (decay.lost / z) : h;  // seconds
    const Vec3 momentum = before.momentum * decay.kept + force * acting - contacts.impulse;
    const Vec3 angular_momentum = before.central_angular_momentum() * decay.kept + (torque_before + torque_after) * (acting / 2) -
                      (contacts.moment - cross(after.centre(), contacts.impulse));

    const Vec3 linear_change = momentum - after.momentum, angular_change = angular_momentum - after.central_angular_momentum();
    const Vec3 angular_velocity = angular_velocity_of(after, angular_change);
    const Rigid correction{linear_change / after.mass - cross(angular_velocity, after.centre()), angular_velocity};
    each_particle(state, [&](size_t i, double) {
        put(&state.velocity[i], get(&state.velocity[i]) + correction.at(get(&state.at[i])));
    });
    after.energy += dot(after.momentum, linear_change) / after.mass + dot(after.central_angular_momentum(), angular_velocity) +
                    length_squared(linear_change) / (2 * after.mass) + dot(angular_velocity, angular_change) / 2;
    after.angular_momentum += angular_change + cross(after.centre(), linear_change);
    after.momentum = momentum;

    const double gain = after.energy - before.energy - work + stored;
    if (closed && gain > 0) {
        scale_relative_motion(state, rigid_motion_of(after), scale_without(gain, energy_relative_to_rigid(after)));
    }
}

}  // namespace gphys
