// Whether the substeps of a rope are made in two stages, by the trapezoid rule and the backward formula
// (TimeScheme). The rule damps nothing: where a link turns by more than half a radian in a substep, or begins to,
// or would swing by more than one if its ends were pushed aside, it adds energy; and a stiff spring that would swing
// by more, as one that a string becomes when it is taut, goes on swinging.
#include "solver/rope/rope.h"

#include "solver/body.h"

namespace gphys {

namespace {

// Of a substep, radians: turning, and what swinging, sideways or along, and turning faster count beside it.
constexpr double most_turn = 0.5, swing_weight = 0.25;
// The square of how much longer a substep is than its last part, in which a link has begun to turn faster.
constexpr double faster_weight = 6;

/// Square of the turn per second.
double agility_of(const Body& body, uint32_t a, uint32_t b, uint32_t link, double weight) {
    const double rest = body.plan.rest[link];
    const Vec3 apart = body.velocity[b] - body.velocity[a];
    const Vec3 faster = apart - (body.start_velocity[b] - body.start_velocity[a]);
    const double turning = std::max(length_squared(apart), faster_weight * length_squared(faster));
    const double pull = std::max(std::fabs(body.plan.tension[link]), weight);
    const double mobility = body.inverse_mass[a] + body.inverse_mass[b], compliance = body.plan.compliance[link];
    const double most = std::max(turning, swing_weight * pull * mobility * rest);
    const double stretching = compliance > 0 ? swing_weight * mobility / compliance : 0;
    return std::max(most > 0 ? most / (rest * rest) : 0, stretching);
}

}  // namespace

bool starts_again(const Body& body) { return body.earlier_step == 0 && !body.touched; }

bool may_go_in_stages(const Body& body, Vec3 gravity, double h) {
    if (body.plan.method != GPHYS_SOLVE_DIRECT || body.earlier_step == 0) return false;
    const double falling = length(gravity);
    // What hangs from a link that is slack for a moment may pull at it before the step is over.
    const auto weight = [&](uint32_t p) {
        if (body.pinned(p)) return 0.0;
        return body.forced ? length(gravity * body.mass[p] + body.force[p]) : falling * body.mass[p];
    };
    double agility = 0;
    for (const Chain& chain : body.plan.chains) {
        const uint32_t* const particle = &body.plan.particles[chain.first_particle];
        double before = weight(particle[0]);
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const double after = weight(particle[i + 1]);
            agility = std::max(
                agility, agility_of(body, particle[i], particle[i + 1], chain.first_link + i, std::max(before, after)));
            before = after;
        }
    }
    return agility * h * h <= most_turn * most_turn;
}

}  // namespace gphys
