// Conservation of the momentum and angular momentum of cloth, by a rigid correction.
//
// Constraints act between particles, so they change neither. Sweeps over them do: each link is corrected along the
// direction that it had before later links moved its ends, and limiting the energy slows all motion. If all external
// forces on a body are known, it gets back the missing momentum and angular momentum at the end of a substep, as a
// rigid motion. Energy is then only taken from the motion relative to that. If pins or models hold it, they have got
// what is missing.
#include "solver/cloth/whole_motion.h"
#include "foundation/elementary.h"
#include "solver/cloth/cloth_contacts.h"
#include "solver/cloth/cloth_state.h"
#include "solver/cloth/second_moments.h"
#include "solver/cloth/whole_motion_kernels.h"

namespace gphys {
namespace {

using Moments = ClothMoments<double>;

/// The motion of particles as a whole, about their centre of mass.
struct WholeMotion {
    Vec3 centre, momentum, angular_momentum;

    WholeMotion(const Moments::Motion& sums, double mass)
        : centre(sums.first_moment / mass),
          momentum(sums.momentum),
          angular_momentum(sums.angular_momentum - cross(centre, sums.momentum)) {}
};

/// The angular velocity of particles with these moments, this centre of mass and that angular momentum. 0 about an axis
/// through all particles, because the inertia about it is a rounding error.
Vec3 angular_velocity_of(const Moments& sums, Vec3 c, Vec3 angular_momentum) {
    const SecondMoments about_centre{sums.squares - Vec3{c.x * c.x, c.y * c.y, c.z * c.z} * sums.mass,
                                     sums.products - Vec3{c.y * c.z, c.z * c.x, c.x * c.y} * sums.mass};
    double determinant;
    const Mat3 inverse = about_centre.inverse(1e-9, determinant);
    return determinant > 0 ? transpose_times(inverse, angular_momentum) / determinant : Vec3{};
}

/// A rigid motion: the velocity at the origin, and the angular velocity.
struct Rigid {
    Vec3 velocity, angular_velocity;
};
/// That of a body whose centre of mass has a velocity.
Rigid rigid_motion(Vec3 centre, Vec3 velocity, Vec3 angular_velocity) {
    return {velocity - cross(angular_velocity, centre), angular_velocity};
}
Rigid operator+(const Rigid& a, const Rigid& b) {
    return {a.velocity + b.velocity, a.angular_velocity + b.angular_velocity};
}
Rigid operator*(const Rigid& a, double s) { return {a.velocity * s, a.angular_velocity * s}; }

/// The factor for velocities that removes an energy from `of`.
double scale_without(double energy, double of) { return energy < of ? std::sqrt(1 - energy / of) : 0; }

}  // namespace

void keep_momentum(ClothState& state, const ClothContacts& contacts, bool closed, double damping, double h,
                   double stored) {
    const WholeMotionKernels& kernels = whole_motion_kernels(chosen_isa());
    const ClothMotion particles = part_of(state, 0, 4 * state.particles);
    const Moments sums = kernels.moments(particles);
    const WholeMotion before(sums.before, sums.mass), after(sums.after, sums.mass);
    const Vec3 torque = sums.torque - cross(before.centre + after.centre, sums.force);
    const double z = damping * h;
    const Decay decay = gphys::decay(z);
    const double acting = z > 0 ? h * (decay.lost / z) : h;  // seconds
    const Vec3 momentum = before.momentum * decay.kept + sums.force * acting - contacts.impulse;
    const Vec3 angular_momentum = before.angular_momentum * decay.kept + torque * (acting / 2) -
                                  (contacts.moment - cross(after.centre, contacts.impulse));

    const Vec3 linear_change = (momentum - after.momentum) / sums.mass;
    const Vec3 angular_change = angular_momentum - after.angular_momentum;
    const Vec3 turn = angular_velocity_of(sums, after.centre, angular_change);
    Rigid added = rigid_motion(after.centre, linear_change, turn);
    const double gain_by_change =
        dot(after.momentum + momentum, linear_change) / 2 + dot(after.angular_momentum + angular_change * 0.5, turn);
    double kept = 1;
    const double gain = sums.gain + gain_by_change + stored;
    if (closed && gain > 0) {
        const Vec3 angular_velocity = angular_velocity_of(sums, after.centre, angular_momentum);
        const double of_whole =
            length_squared(momentum) / (2 * sums.mass) + dot(angular_momentum, angular_velocity) / 2;
        kept = scale_without(gain, sums.energy / 2 + gain_by_change - of_whole);
        added = added * kept + rigid_motion(after.centre, momentum / sums.mass, angular_velocity) * (1 - kept);
    }
    kernels.move(particles, kept, added.velocity, added.angular_velocity);
}

Momentum missing_momentum(ClothState& state, const ClothContacts& contacts, double damping, double h) {
    const Momentum lost = whole_motion_kernels(chosen_isa()).lost(part_of(state, 0, 4 * state.particles), damping, h);
    return {(lost.linear - contacts.impulse) * state.average_mass,
            (lost.angular - contacts.moment) * state.average_mass};
}

}  // namespace gphys
