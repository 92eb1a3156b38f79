// Corrections of two particles in contact, one step of a Gauss-Seidel sweep: they are separated, with friction, and the
// models that they touch stop and hold them (supports.h). For the particles and contacts of ParticleContacts.
#pragma once

#include <optional>

#include "foundation/math.h"
#include "solver/contact/supports.h"

namespace gphys {

template <class Particle>
Vec3 stopped(Particle& p, Vec3 value, Vec3 uncorrected) {
    return p.supports ? p.supports->stop(value, uncorrected) : value;
}

/// The fraction of a correction that a particle can make although models stop and hold it.
template <class Particle>
double yielding(const Particle& p, Vec3 correction) {
    if (!p.supports) return 1;
    return std::max(0.0, dot(p.supports->yielding(correction), correction) / length_squared(correction));
}

/// Adds a correction to the relative position or velocity of two particles, in proportion to their inverse masses.
template <class Particle, class Contact>
GPHYS_INLINE void apply_correction(const Contact& contact, Particle& a, Particle& b, Vec3 correction,
                                   Vec3 Particle::*value, Vec3 Particle::*uncorrected) {
    a.*value = stopped(a, a.*value - correction * contact.part_of_a, a.*uncorrected);
    b.*value = stopped(b, b.*value + correction * contact.part_of_b, b.*uncorrected);
}

/// What a correction of two particles has changed.
template <class Particle>
class MovedPair {
public:
    MovedPair(const Particle& a, const Particle& b, Vec3 Particle::*value) : a_(a, value), b_(b, value) {}
    void restore(Particle& a, Particle& b, Vec3 Particle::*value) const {
        a_.restore(a, value);
        b_.restore(b, value);
    }

private:
    struct Moved {
        Vec3 value;
        std::optional<Supports> supports;

        Moved(const Particle& p, Vec3 Particle::*value) : value(p.*value) {
            if (p.supports) supports = *p.supports;
        }
        void restore(Particle& p, Vec3 Particle::*member) const {
            p.*member = value;
            if (supports) *p.supports = *supports;
        }
    };
    Moved a_, b_;
};

/// The same for one that must be made in full although models may stop a particle. What these take from it is made up
/// for by a further one, which the inverse masses do not share as such, but as far as the models let the particles
/// move. Returns that as a fraction of the correction; it is at most `most_more`.
template <class Particle, class Contact>
GPHYS_NOINLINE double apply_in_full(const Contact& contact, Particle& a, Particle& b, Vec3 correction, double most_more,
                                    Vec3 Particle::*value, Vec3 Particle::*uncorrected) {
    // A particle is not moved by more corrections. One that is pressed onto a model almost along its normal would be
    // squeezed out as far as only straight motion along the model would take it.
    constexpr double farthest = 4;
    const Vec3 before = b.*value - a.*value;
    apply_correction(contact, a, b, correction, value, uncorrected);
    const Vec3 lost = correction - (b.*value - a.*value - before);
    const double square = length_squared(correction), part = dot(lost, correction) / square;
    // Less is the rounding of the sums above.
    if (!(part > 1e-9)) return 0;
    const double of_a = yielding(a, -correction), of_b = yielding(b, correction);
    const double yields = contact.part_of_a * of_a + contact.part_of_b * of_b;
    const double way = std::max(contact.part_of_a * std::sqrt(of_a), contact.part_of_b * std::sqrt(of_b));
    if (!(way > 0)) return 0;  // wedged between models
    // Models that have pushed a particle let go of it on the way, and then it goes farther than its yielding tells.
    // Beyond the full correction the sweeps over a deep heap would gain energy, so less is tried: a chord of the way,
    // which is convex there.
    double more = std::min({part / yields, farthest / way, most_more});
    const MovedPair<Particle> moved(a, b, value);
    for (int tries = 0; tries < 4; ++tries) {
        apply_correction(contact, a, b, correction * more, value, uncorrected);
        const double gained = dot(b.*value - a.*value - before, correction) / square;
        if (gained <= 1 + 1e-9 || !contact.both_free) return more;
        moved.restore(a, b, value);
        more *= part / (part + gained - 1);
    }
    return 0;
}

/// Changes the relative position or velocity along the normal of a contact. At most undoes what has been accumulated:
/// particles never attract each other. Returns whether it has done anything.
template <class Particle, class Contact>
GPHYS_INLINE bool separate(const Contact& contact, Particle& a, Particle& b, double correction, double& accumulated,
                           double& more, Vec3 Particle::*value, Vec3 Particle::*uncorrected) {
    if (correction == 0) return false;
    accumulated += correction;
    if (a.supports || b.supports) {
        const double left = accumulated + more, most_more = correction < 0 ? left / -correction : infinity;
        more += correction * apply_in_full(contact, a, b, contact.normal * correction, most_more, value, uncorrected);
    } else {
        a.*value -= contact.normal * (correction * contact.part_of_a);
        b.*value += contact.normal * (correction * contact.part_of_b);
    }
    return true;
}

/// Friction: takes the sliding of two particles in contact, at most `most` of it. Returns how much.
template <class Particle, class Contact>
GPHYS_INLINE double take_sliding(const Contact& contact, Particle& a, Particle& b, Vec3 relative, double most,
                                 Vec3 Particle::*value, Vec3 Particle::*uncorrected) {
    const Vec3 tangential = relative - contact.normal * dot(relative, contact.normal);
    const double sliding = length(tangential);
    if (sliding == 0 || most <= 0) return 0;
    const double held = std::min(sliding, most);
    apply_correction(contact, a, b, tangential * (-held / sliding), value, uncorrected);
    return held;
}

template <class Particle, class Contact>
void solve_position(Contact& contact, Particle& a, Particle& b) {
    const double overlap = contact.radii - dot(b.at - a.at, contact.normal);
    // The accumulated separation is clamped, so a correction that was too large is undone.
    const double correction =
        std::min(std::max(overlap, -contact.all_separation()), contact.most_separation - contact.separation);
    const bool separated = separate(contact, a, b, correction, contact.separation, contact.more_separation,
                                    &Particle::at, &Particle::uncorrected);
    const double held = take_sliding(contact, a, b, (b.at - b.before) - (a.at - a.before),
                                     contact.friction * contact.all_separation() - contact.friction_displacement,
                                     &Particle::at, &Particle::uncorrected);
    contact.friction_displacement += held;
    if (!separated && held == 0) return;
    if (a.supports) a.at = a.supports->hold(a.at, a.before);
    if (b.supports) b.at = b.supports->hold(b.at, b.before);
}

template <class Particle, class Contact>
void solve_velocity(Contact& contact, Particle& a, Particle& b) {
    if (contact.all_separation() <= 0) return;
    const double normal_speed = dot(b.velocity - a.velocity, contact.normal);
    const double change = std::max(contact.target_speed - normal_speed, -contact.all_change());
    const bool changed = separate(contact, a, b, change, contact.normal_change, contact.more_change,
                                  &Particle::velocity, &Particle::uncorrected_velocity);
    // Coulomb's law for the change of velocity alone: friction has acted on the correction of positions already.
    const double held = take_sliding(contact, a, b, b.velocity - a.velocity,
                                     contact.friction * contact.all_change() - contact.friction_change,
                                     &Particle::velocity, &Particle::uncorrected_velocity);
    contact.friction_change += held;
    if (!changed && held == 0) return;
    if (a.supports) a.velocity = a.supports->hold(a.velocity, {});
    if (b.supports) b.velocity = b.supports->hold(b.velocity, {});
}

}  // namespace gphys
