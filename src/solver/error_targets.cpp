// The number of substeps of a body in a step: the set number, or with error targets as many as its own motion needs.
// The strain after a step and the local error of the time scheme both grow with the square of the substep. So the
// length that would have satisfied the targets follows from the measurement of the last one.
//
// Cloth that moves alone satisfies its strain target in each substep, by relaxation (relax_links.cpp). There the work
// of the relaxation is the measure. If it was too much, the rest of the step is divided again.
#include "solver/quads.h"
#include "solver/solver.h"
#include "solver/time_scheme.h"

namespace gphys {
namespace {

/// Over rigid constraints.
double largest_strain(const Body& body) {
    double largest = 0;
    for (const uint32_t slot : body.constraints.ids) {
        const DistanceConstraint& c = body.constraints.by_slot[slot];
        if (c.compliance > 0 || c.rest == 0) continue;
        const double strain = distance(body.particles.position[c.a], body.particles.position[c.b]) / c.rest - 1;
        largest = std::max(largest, c.limit ? strain : std::fabs(strain));
    }
    return largest;
}

/// The motion of a particle in the last substep, of h seconds.
struct Advance {
    Vec3 way, velocity_earlier, velocity_before, velocity;
};

/// For a body with constraints: calls visit(advance) for each free particle.
template <class Visit>
void for_each_advance(const Body& body, Visit&& visit) {
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        if (is_graph(body)) {
            const size_t i = 4 * size_t{p};
            visit({get(&body.cloth.state.moved[i]),
                   {},
                   get(&body.cloth.state.velocity_before[i]),
                   body.particles.velocity[p]});
        } else {
            visit({body.particles.position[p] - body.history.start[p], body.history.earlier_velocity[p],
                   body.history.start_velocity[p], body.particles.velocity[p]});
        }
    }
}

/// The local error of the last substep, in metres, of the particle with the largest one. By Milne's device (1926), from
/// the difference to another formula. Let x be the numerical positions, with velocities x' - h^2/3 x''' by the
/// second-order backward formula. The error of the trapezoid rule between them is h^3/4 x''', that of the formula
/// itself 2/9 h^3 x'''. After an interruption the substep was one of backward Euler, where both errors are h^2/2 x''.
double error_of_one_stage(const Body& body, double h) {
    const bool interrupted = body.history.earlier_step == 0;
    double largest = 0;
    for_each_advance(body, [&](const Advance& a) {
        const Vec3 way = interrupted ? a.velocity * h : a.way;
        largest = std::max(largest, length_squared(way - (a.velocity_before + a.velocity) * (h / 2)));
    });
    return std::sqrt(largest) * (interrupted ? 1 : 8.0 / 9);
}

/// The same for a substep of two stages, the first of which is the fraction s. The trapezoid rule gives the mean
/// acceleration of its stage, which is that in its middle, and the backward formula the one at the end. Their
/// difference over the time between is x'''. The error is h^3 x''' (3 s^2 - 4 s + 2) / (12 (2 - s)) (Hosea & Shampine
/// 1996).
double error_of_two_stages(const Body& body, double h) {
    constexpr double s = first_stage, constant = (3 * s * s - 4 * s + 2) / (12 * (2 - s));
    const TimeScheme scheme((1 - s) * h, s * h);
    double largest = 0;
    for_each_advance(body, [&](const Advance& a) {
        const Vec3 mean = (a.velocity_before - a.velocity_earlier) / (s * h);
        const Vec3 history = scheme.from_history(a.velocity_before, a.velocity_earlier);
        const Vec3 end = (a.velocity * scheme.next - history) / scheme.h;
        largest = std::max(largest, length_squared(end - mean));
    });
    return std::sqrt(largest) / (1 - s / 2) * constant * h * h;
}

/// Metres a second.
double error_rate(const Body& body, double h) {
    if (body.history.earlier_step == 0) return error_of_one_stage(body, h) / h;
    // The last substep of a step may be a part of one.
    if (!body.history.in_stages) return error_of_one_stage(body, body.history.earlier_step) / body.history.earlier_step;
    const double whole = body.history.earlier_step / (1 - first_stage);
    return error_of_two_stages(body, whole) / whole;
}

/// NaN counts as the most.
uint32_t count_of(double count, uint32_t most) { return count < most ? static_cast<uint32_t>(count) : most; }

}  // namespace

uint32_t least_substeps(const Body& body, double dt) {
    // One sweep over a graph leaves an error that grows with the square of the substep. Beyond 25 ms, in which a sheet
    // falls by less than the length of its links, it would throw the sheet about.
    constexpr double longest = 0.025;
    return is_graph(body) ? static_cast<uint32_t>(std::ceil(dt / longest)) : 1;
}

uint32_t substeps_of(const Body& body, const SolverSettings& settings, double dt) {
    const bool targeted = settings.max_strain > 0 || settings.tolerance > 0;
    double count = settings.substeps;
    if (targeted && body.substeps.wanted > 0) count = std::ceil(dt / body.substeps.wanted);
    if (targeted) count = std::min<double>(count, settings.max_substeps);
    return std::max(static_cast<uint32_t>(count), least_substeps(body, dt));
}

uint32_t substeps_near_models(const Cloth& cloth, const SolverSettings& settings, double fastest, double dt) {
    // A particle that lands on a model stops, and bends the cloth behind it. If no particle goes farther than this
    // fraction of a link's length in a substep, the links can be relaxed; at twice the distance some end 4 % too long.
    constexpr double longest_way = 0.5;
    if (settings.max_strain == 0 || cloth.relaxation.most_strain == 0 || cloth.batches.link_length == 0) return 0;
    const double count = std::ceil(dt * fastest / (longest_way * cloth.batches.link_length));
    return count_of(count, settings.max_substeps);
}

uint32_t substeps_of_rest(const Body& body, const SolverSettings& settings, double dt, double done, uint32_t made) {
    if (settings.max_strain == 0 || body.cloth.relaxation.most_strain == 0 || made >= settings.max_substeps) return 0;
    const double wanted = std::max(body.cloth.relaxation.wanted_substep, dt / settings.max_substeps);
    const double count = std::ceil(dt * (1 - done) / wanted);
    return count_of(count, settings.max_substeps - made);
}

void adapt_substep(Body& body, const SolverSettings& settings, double dt, uint32_t substeps) {
    // The largest of thousands of strains may triple within steps, so a third of the target is aimed at. Growth is
    // slow, because a body that has stopped may soon be fast again. It is less slow where a step that turns out too
    // long is divided again.
    constexpr double aim = 1.0 / 3, most_growth = 1.0625, most_growth_relaxed = 1.125, most_shrinking = 0.25;
    body.substeps.made = substeps;
    if (settings.max_strain == 0 && settings.tolerance == 0) return;
    const double h = dt / substeps;
    double part = 0;  // of the target: the measured error relative to the allowed one
    const bool relaxed = body.cloth.relaxation.most_strain > 0;
    if (body.plan.method != GPHYS_SOLVE_FREE) {
        if (settings.max_strain > 0 && !relaxed) part = std::max(part, largest_strain(body) / settings.max_strain);
        if (settings.tolerance > 0) part = std::max(part, error_rate(body, h) / settings.tolerance);
    }
    const double factor = part > 0 ? std::sqrt(aim / part) : infinity;
    // Growth by less than one substep fewer must accumulate.
    const double last = body.substeps.wanted > 0 ? body.substeps.wanted : h;
    double wanted =
        std::min(h * std::max(factor, most_shrinking), last * (relaxed ? most_growth_relaxed : most_growth));
    if (relaxed) wanted = std::min(wanted, body.cloth.relaxation.wanted_substep);
    // What no number of substeps cures takes the set number in the end.
    if (relaxed && body.cloth.relaxation.given_up) wanted = std::min(wanted, std::max(last, dt / settings.substeps));
    body.substeps.wanted = std::min(std::max(wanted, dt / settings.max_substeps), dt);
}

}  // namespace gphys
