// The exact flight of a particle: motion under a constant acceleration and linear drag, by exponential integrators (phi
// functions; Hochbruck, Ostermann 2010).
#pragma once

#include "foundation/elementary.h"
#include "foundation/math.h"

namespace gphys {

// The phi functions, the integrals of exp(-z t) of which the solution consists. `lost` is 1 - exp(-z).

/// (1 - exp(-z)) / z
inline double phi1(double z, double lost) { return z > 0 ? lost / z : 1; }
/// (z - 1 + exp(-z)) / z^2. For small z, where that cancels, its series up to z^5; the next term is below 1e-15.
inline double phi2(double z, double lost) {
    constexpr double small_drag = 0.01;
    if (z < small_drag) return (1 - z / 3 * (1 - z / 4 * (1 - z / 5 * (1 - z / 6 * (1 - z / 7))))) / 2;
    return (z - lost) / (z * z);
}

/// The factors of a time interval, for all particles with the same drag.
struct FlightTime {
    double kept = 1;             // fraction of the velocity that remains
    double reach = 0, fall = 0;  // s, s^2: factors of the velocity and of the acceleration in the displacement

    FlightTime() = default;
    FlightTime(double damping, double seconds) {
        const double z = damping * seconds;
        const Decay whole = decay(z);
        kept = whole.kept;
        reach = seconds * phi1(z, whole.lost);
        fall = seconds * seconds * phi2(z, whole.lost);
    }
};

/// dv/dt = acceleration - damping v.
struct Flight {
    Vec3 acceleration;
    double damping;

    Vec3 displacement(Vec3 v0, const FlightTime& time) const { return v0 * time.reach + acceleration * time.fall; }
    Vec3 velocity(Vec3 v0, const FlightTime& time) const { return v0 * time.kept + acceleration * time.reach; }

    /// The time at which the flight has gone `distance` >= 0 along `direction`. It must have by `latest`.
    double time_to(Vec3 v0, Vec3 direction, double distance, double latest) const {
        const double v = dot(v0, direction), a = dot(acceleration, direction);
        const double square = v * v + 2 * a * distance;
        double s = latest;
        if (square >= 0) {  // without drag: of the two forms of the root, the one that does not cancel
            const double end = std::sqrt(square);
            if (v > 0) {
                s = 2 * distance / (v + end);
            } else if (a > 0) {
                s = (end - v) / a;
            }
        }
        if (damping == 0) return std::min(s, latest);
        // Drag makes it later. Newton's method from there, with bisection if a step leaves the bracket. A step below
        // the rounding of the time changes nothing; 60 halvings exhaust a double.
        double low = 0, high = latest;
        s = std::min(s, latest);
        for (int i = 0; i < 60; ++i) {
            const FlightTime at(damping, s);
            const double ahead = v * at.reach + a * at.fall - distance, rate = v * at.kept + a * at.reach;
            (ahead < 0 ? low : high) = s;
            double next = rate > 0 ? s - ahead / rate : low;
            if (!(next > low && next < high)) next = low + (high - low) / 2;
            if (std::fabs(next - s) <= 0x1p-52 * latest) break;
            s = next;
        }
        return s;
    }
};

}  // namespace gphys
