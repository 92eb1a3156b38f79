// Bodies without constraints: each particle flies on its own, and the exact solution of its flight
// is known, so that neither the length nor the number of the steps matters.
#include "solver/contact/collision.h"
#include "solver/particles/flight.h"

namespace gphys {
namespace {

// Bounces of one particle in one substep; those beyond are so small that it lies still.
constexpr int most_bounces = 8;

void fly_among(const Collider& collider, Body& body, uint32_t p, const Flight& flight, double h) {
    Vec3& at = body.position[p];
    Vec3& velocity = body.velocity[p];
    double time = h;
    for (int bounce = 0; bounce < most_bounces; ++bounce) {
        const Vec3 displacement = flight.displacement(velocity, time);
        Impact impact;
        if (!collider.sweep(p, at, displacement, impact)) {
            at += displacement;
            velocity = flight.velocity(velocity, time);
            return;
        }
        if (impact.inside) break;
        const Vec3 towards = -impact.normal;
        const double t = collider.stop_short(body, p, at, displacement, impact);
        // Within the skin already: it has arrived.
        const double s = t > 0 ? flight.time_to(velocity, towards, dot(displacement, towards) * impact.t, time) : 0;
        const Vec3 arrival = flight.velocity(velocity, s);
        // A bounce that is over within two substeps is none: the particle has come to rest.
        const double approach = dot(arrival - impact.surface_velocity, towards);
        const double pressing = dot(flight.acceleration, towards) * h;
        const bool bounces = body.settings.restitution * approach > std::max(0.0, pressing);
        collider.record(body, p, impact);
        at += displacement * t;
        velocity = arrival;
        collider.bounce(body, p, impact, bounces ? body.settings.restitution : 0);
        time -= s;
        if (!bounces) break;
    }
    const Vec3 displacement = flight.displacement(velocity, time);
    velocity = flight.velocity(velocity, time);
    collider.slide(body, p, at, displacement, length(flight.acceleration) * 2 * h);
}

}  // namespace

void fly(Body& body, const Surroundings& around, Vec3 gravity, double h) {
    const auto flight_of = [&](uint32_t p) {
        return Flight{gravity + body.force[p] * body.inverse_mass[p], body.settings.damping};
    };
    double fastest = 0;
    for (uint32_t p = 0; p < body.size(); ++p) {
        body.start[p] = body.position[p];
        body.predicted[p] = body.position[p];
        if (body.pinned(p)) continue;
        body.predicted[p] += flight_of(p).displacement(body.velocity[p], h);
        keep_in_range(body.predicted[p], body.velocity[p]);
        fastest = std::max(fastest, length_squared(body.velocity[p]));
    }
    if (around.scene && body.settings.layers != 0) {
        const double margin = std::sqrt(fastest) * h;  // a bounce turns back up to this far
        const Collider collider(around, body, swept_box(body, body.start, body.predicted, margin));
        if (!collider.idle()) {
            for (uint32_t p = 0; p < body.size(); ++p) {
                if (!body.pinned(p)) fly_among(collider, body, p, flight_of(p), h);
            }
            return;
        }
    }
    for (uint32_t p = 0; p < body.size(); ++p) {
        if (body.pinned(p)) continue;
        body.velocity[p] = flight_of(p).velocity(body.velocity[p], h);
        body.position[p] = body.predicted[p];
    }
}

}  // namespace gphys
