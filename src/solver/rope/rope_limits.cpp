// Ropes with links that only pull (unilateral constraints). A particle whose links are all slack flies exactly, by the
// closed form of flight.h. When a rigid link becomes taut within a substep, its ends lose the speed at which they
// separate: an inelastic impact. It is solved for all taut links of the chain together, by elimination along the chain
// (Thomas's algorithm), and takes only the velocity along the links.
#include "solver/rope/rope_limits.h"
#include "solver/contact/collision.h"
#include "solver/particles/flight.h"
#include "solver/time_scheme.h"

namespace gphys {
namespace {

// A link is slack if it is shorter by this fraction of its length: ten times the error of a solved one.
constexpr double slack = 1e-8;

bool is_slack(const Plan& plan, const Vector<Vec3>& position, uint32_t a, uint32_t b, uint32_t link) {
    return plan.limit[link] && distance(position[a], position[b]) < plan.rest[link] * (1 - slack);
}

/// The links of a chain that are rigid at the end of the substep.
struct TautLinks {
    Body& body;
    const CollisionContext& around;
    const TimeScheme& scheme;
    const Chain& chain;

    uint32_t particle(uint32_t i) const { return body.plan.particles[chain.first_particle + i]; }
    bool taut(uint32_t i) const {
        const uint32_t link = chain.first_link + i;
        return body.plan.compliance[link] == 0 && (!body.plan.limit[link] || body.rope.tension[link] > 0) &&
               body.particles.inverse_mass[particle(i)] + body.particles.inverse_mass[particle(i + 1)] > 0;
    }
    bool becomes_taut() const {
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            if (taut(i) && is_slack(body.plan, body.history.start, particle(i), particle(i + 1), chain.first_link + i))
                return true;
        }
        return false;
    }
    Vec3 direction(uint32_t i) const { return link_direction(body.particles, particle(i), particle(i + 1)); }

    /// Applies the impulses p_j along the links after which no taut link changes its length:
    ///   -c_j p_(j-1) + (w_j + w_(j+1)) p_j - c_(j+1) p_(j+1) = rate_j,   c_j = w_j (n_(j-1) . n_j)
    void stop() const {
        // Keeps the pivot of a straight chain between two pins from zero.
        constexpr double regularisation = 1e-10;
        struct Row {
            double inverse_pivot, value, coupling;
        };
        const auto row_of = [&](uint32_t i) -> double(&)[4] { return body.rope.rows[i].value; };
        Vec3 before;
        Row last{0, 0, 0};
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const uint32_t a = particle(i), b = particle(i + 1);
            Row row{0, 0, 0};
            const Vec3 n = taut(i) ? direction(i) : Vec3{};
            if (taut(i)) {
                const double mobility = body.particles.inverse_mass[a] + body.particles.inverse_mass[b];
                row.coupling = body.particles.inverse_mass[a] * dot(before, n);
                row.inverse_pivot =
                    1 / (mobility * (1 + regularisation) - row.coupling * row.coupling * last.inverse_pivot);
                row.value =
                    (dot(n, body.particles.velocity[b] - body.particles.velocity[a]) + row.coupling * last.value) *
                    row.inverse_pivot;
            }
            double(&stored)[4] = row_of(i);
            stored[0] = row.inverse_pivot, stored[1] = row.value, stored[2] = row.coupling;
            before = n;
            last = row;
        }
        double impulse = 0, coupling = 0;
        for (uint32_t i = chain.link_count; i-- > 0;) {
            const double(&row)[4] = row_of(i);
            impulse = row[1] + coupling * row[0] * impulse;
            coupling = row[2];
            if (!taut(i)) continue;
            const uint32_t a = particle(i), b = particle(i + 1);
            const Vec3 pull = direction(i) * impulse;
            body.particles.velocity[a] += pull * body.particles.inverse_mass[a];
            body.particles.velocity[b] -= pull * body.particles.inverse_mass[b];
            // The anchors got the whole force of the link, but drag has left only this fraction of it.
            const double part = scheme.drag(body.settings.damping);
            if (body.breaking.possible()) body.breaking.impulse[chain.first_link + i] += impulse;
            const Vec3 impulse_on_a = pull - link_impulse(body, a, b, chain.first_link + i, scheme) * (1 - part);
            if (body.particles.pinned(a)) add_anchor_impulse(body, around, a, impulse_on_a);
            if (body.particles.pinned(b)) add_anchor_impulse(body, around, b, -impulse_on_a);
        }
    }
};

}  // namespace

void predict_slack_particles(Body& body, Vec3 gravity, double h) {
    // Where links are slack, bending still acts.
    std::fill(body.rope.slack.begin(), body.rope.slack.end(), uint8_t{!body.rope.bending.resists()});
    each_link(body.plan, [&](uint32_t link, uint32_t a, uint32_t b) {
        if (!is_slack(body.plan, body.history.start, a, b, link)) body.rope.slack[a] = body.rope.slack[b] = 0;
    });
    const FlightTime time(body.settings.damping, h);
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) body.rope.slack[p] = 0;
        if (!body.rope.slack[p]) continue;
        const Flight flight{gravity + body.particles.force[p] * body.particles.inverse_mass[p], body.settings.damping};
        body.particles.position[p] = body.history.start[p] + flight.displacement(body.history.start_velocity[p], time);
        body.particles.velocity[p] = flight.velocity(body.history.start_velocity[p], time);
        keep_in_range(body.particles.position[p], body.particles.velocity[p]);
    }
}

bool apply_limit_impacts(Body& body, const CollisionContext& around, const TimeScheme& scheme) {
    bool any = false;
    for (const Chain& chain : body.plan.chains) {
        const TautLinks links{body, around, scheme, chain};
        if (!links.becomes_taut()) continue;
        links.stop();
        any = true;
    }
    return any;
}

}  // namespace gphys
