// The exact flight of a particle: motion under a constant acceleration and linear drag.
#pragma once

#include "foundation/math.h"

namespace gphys {

// The integrals of exp(-z t) that the solution is made of, by their series where the closed form
// would cancel: to z^5, after which the next term is below 1e-15.
constexpr double small_drag = 0.01;

/// (1 - exp(-z)) / z
inline double phi1(double z) {
    if (z < small_drag) return 1 - z / 2 * (1 - z / 3 * (1 - z / 4 * (1 - z / 5 * (1 - z / 6))));
    return -std::expm1(-z) / z;
}
/// (z - 1 + exp(-z)) / z^2
inline double phi2(double z) {
    if (z < small_drag) return (1 - z / 3 * (1 - z / 4 * (1 - z / 5 * (1 - z / 6 * (1 - z / 7))))) / 2;
    return (z + std::expm1(-z)) / (z * z);
}

/// dv/dt = acceleration - damping v.
struct Flight {
    Vec3 acceleration;
    double damping;

    Vec3 displacement(Vec3 v0, double s) const {
        return v0 * (s * phi1(damping * s)) + acceleration * (s * s * phi2(damping * s));
    }
    Vec3 velocity(Vec3 v0, double s) const {
        return v0 * std::exp(-damping * s) + acceleration * (s * phi1(damping * s));
    }
    /// When the flight has gone `distance` along `direction` for the first time: it has by `latest`.
    double time_to(Vec3 v0, Vec3 direction, double distance, double latest) const {
        double low = 0, high = latest;
        // Each halving adds a bit, so 60 exhaust the 53 of a double.
        for (int i = 0; i < 60; ++i) {
            const double middle = low + (high - low) / 2;
            (dot(displacement(v0, middle), direction) < distance ? low : high) = middle;
        }
        return high;
    }
};

}  // namespace gphys
