// Cloth and other graphs: chains of constraints, each solved as a whole, one family after the
// other. Within a chain the corrections of all links are found together by elimination on their
// tridiagonal system (Thomas), so tension crosses the cloth in one sweep where a constraint at a
// time needs as many sweeps as there are links. One pass per substep and always the same order:
// going forward and backward by turns was seen to pump energy.
#include "solver/body.h"

namespace gphys {
namespace {

// The compliance that every link has, relative to the inverse masses at its ends: it keeps the pivots
// of a straight chain between two pins away from zero. It leaves a millionth of the error, and bounds
// the sideways correction of a chain straight within an angle d: error * d / (d^2 + this) is at most
// error / (2 sqrt(this)), 500 times the error of pins too far apart.
constexpr double regularisation = 1e-6;

void solve_line(Body& body, const Chain& chain, double inverse_step_squared) {
    const Plan& plan = body.plan;
    const uint32_t* particles = &plan.particles[chain.first_particle];
    LineRow* rows = body.plan.line_rows.data();

    // Elimination. With w the inverse masses and c_j = w_j (n_(j-1) . n_j), the tensions t solve
    //   -c_j t_(j-1) + (w_j + w_(j+1) + compliance / step^2) t_j - c_(j+1) t_(j+1) = error_j
    Vec3 direction_before;
    double inverse_pivot_before = 0, value_before = 0;
    Vec3 a = body.position[particles[0]];
    double wa = body.inverse_mass[particles[0]];
    for (uint32_t j = 0; j < chain.link_count; ++j) {
        const Vec3 b = body.position[particles[j + 1]];
        const double wb = body.inverse_mass[particles[j + 1]];
        LineRow& row = rows[j];
        row = {};
        if (wa + wb > 0) {
            const double length = distance(a, b);
            row.direction = length > 0 ? (b - a) / length : Vec3{1, 0, 0};
            row.coupling = wa * dot(direction_before, row.direction);
            const double diagonal =
                (wa + wb) * (1 + regularisation) + plan.compliance[chain.first_link + j] * inverse_step_squared;
            row.inverse_pivot = 1 / (diagonal - row.coupling * row.coupling * inverse_pivot_before);
            row.value = (length - plan.rest[chain.first_link + j] + row.coupling * value_before) * row.inverse_pivot;
        }
        direction_before = row.direction;
        inverse_pivot_before = row.inverse_pivot;
        value_before = row.value;
        a = b;
        wa = wb;
    }

    // Substitution, from the last link to the first, moving each particle once both links are known.
    Vec3 pull;  // of the link after the particle
    double tension = 0, coupling = 0;
    for (uint32_t j = chain.link_count; j-- > 0;) {
        const LineRow& row = rows[j];
        tension = row.value + coupling * row.inverse_pivot * tension;
        coupling = row.coupling;
        const Vec3 own = row.direction * tension;
        body.position[particles[j + 1]] += (pull - own) * body.inverse_mass[particles[j + 1]];
        pull = own;
    }
    body.position[particles[0]] += pull * body.inverse_mass[particles[0]];
}

}  // namespace

void solve_chain_families(Body& body, double step) {
    const double inverse_step_squared = 1 / (step * step);
    for (const Chain& chain : body.plan.chains) solve_line(body, chain, inverse_step_squared);
}

}  // namespace gphys
