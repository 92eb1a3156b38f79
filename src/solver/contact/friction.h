// Friction coefficients of particles: those of the body, times a factor that each particle may have.
#pragma once

#include "solver/body.h"

namespace gphys {

/// Coulomb coefficients.
struct Friction {
    double kinetic, at_rest;

    /// Whether static friction is stronger than kinetic friction.
    bool sticks() const { return at_rest > kinetic; }
};

inline double friction_factor(const Body& body, uint32_t particle) {
    const Vector<double>& factors = body.contacts.friction_factor;
    return factors.empty() ? 1 : factors[particle];
}
/// The smallest factor of some particles.
inline double least_friction_factor(const Body& body, uint32_t first, uint32_t count) {
    const Vector<double>& factors = body.contacts.friction_factor;
    return factors.empty() ? 1 : *std::min_element(factors.begin() + first, factors.begin() + first + count);
}

inline Friction friction_coefficients(const Body& body, uint32_t particle) {
    const double factor = friction_factor(body, particle);
    return {body.settings.friction * factor, body.settings.static_friction * factor};
}
/// The coefficient in effect: the static one while the particle sticks.
inline double friction_of(const Body& body, uint32_t particle) {
    const Friction friction = friction_coefficients(body, particle);
    return body.settings.sticks() && body.contacts.stuck[particle] ? friction.at_rest : friction.kinetic;
}

}  // namespace gphys
