// Chains, solved directly: Newton's method on positions and tensions together, with geometric stiffness (Tournier et
// al. 2015, "Stable constrained dynamics"; Deul et al. 2018, "Direct position-based solver for stiff rods"). The linear
// systems are block tridiagonal, and each is solved by elimination along the chain.
//
// A substep ends where, for each particle i and each link j from particle j to j + 1,
//
//     m_i (x_i - predicted_i) - t_i n_i + t_(i-1) n_(i-1) = 0      n_j the direction of link j
//     |x_(j+1) - x_j| - rest_j - compliance_j / step^2 * t_j = 0   t_j its tension * step^2
//
// Linearised, with k_j = max(t_j, 0) / length_j and K_j = k_j (1 - n_j n_j^T), the block of particle
// i and of the link that arrives at it is
//
//     [ m_i + K_(i-1) + K_i    n_(i-1) ]         coupled to the     [ -K_i   -n_i ]
//     [ n_(i-1)^T              -r      ]         next block by      [  0       0  ]
//
// where r is compliance_j / step^2 plus a regularisation. K, the geometric stiffness, keeps a taut rope straight while
// it swings. Without it the step overshoots sideways once the load is a thousand times a link's mass. The matrix is
// symmetric and quasi-definite, so elimination without pivoting succeeds (Vanderbei 1995).
//
// A link that only pulls has t_j >= 0, and may be shorter than its rest length if t_j = 0. In each iteration it is
// active if t_j + error_j / (w_a + w_b) > 0, and absent otherwise (primal-dual active set; Hintermueller, Ito, Kunisch
// 2002).
//
// Why not the kernels alone. rope_kernels.cpp solves the same equations for one or eight ropes, with blocks of 3 x 3,
// which is less work: a step of a free rope of 30 links takes 1.1 million instructions here, 0.26 there with one lane,
// 0.08 with eight. This file is for what those kernels do not support: links that only pull or are damped, several
// chains, animation targets, and ropes pulled around something between two pins. It also repeats what Newton's method
// has not solved there. Its sums
// differ, so to replace one file by the other would change the last bits.
#include "solver/body.h"
#include "solver/rope/rope.h"
#include "solver/rope/rope_contacts.h"
#include "solver/rope/stiff_chains.h"
#include "solver/rope/stretched_ropes.h"
#include "solver/state_range.h"

namespace gphys {
namespace {

// Newton's method squares the error in each iteration: two iterations do for a swinging rope, four for a whip.
constexpr int most_iterations = 4;
// With links that only pull, the iterations also determine which are active. One may change in each.
constexpr int most_limited_iterations = 16;
// With contacts, they also determine which contacts are active and which of them stick. A load that falls onto a taut
// rope bends it, and then each iteration halves the error, since a straight rope is where it has its minimum.
constexpr int most_contact_iterations = 16;
// Newton's method has converged when each link is wrong by at most this fraction of its length. Smaller errors do not
// show in float32.
constexpr double tolerance = 1e-9;

/// A symmetric 4x4 matrix as L D L^T.
struct Factors {
    double lower[4][4];
    double inverse_pivot[4];

    explicit Factors(const double (&m)[4][4]) {
        double pivot[4];
        for (int j = 0; j < 4; ++j) {
            pivot[j] = m[j][j];
            for (int k = 0; k < j; ++k) pivot[j] -= lower[j][k] * lower[j][k] * pivot[k];
            inverse_pivot[j] = pivot[j] != 0 ? 1 / pivot[j] : 0;  // 0 if the row depends linearly on earlier ones
            for (int i = j + 1; i < 4; ++i) {
                double sum = m[i][j];
                for (int k = 0; k < j; ++k) sum -= lower[i][k] * lower[j][k] * pivot[k];
                lower[i][j] = sum * inverse_pivot[j];
            }
        }
    }

    void solve(double& x0, double& x1, double& x2, double& x3) const {
        x1 -= lower[1][0] * x0;
        x2 -= lower[2][0] * x0 + lower[2][1] * x1;
        x3 -= lower[3][0] * x0 + lower[3][1] * x1 + lower[3][2] * x2;
        x3 *= inverse_pivot[3];
        x2 = x2 * inverse_pivot[2] - lower[3][2] * x3;
        x1 = x1 * inverse_pivot[1] - lower[2][1] * x2 - lower[3][1] * x3;
        x0 = x0 * inverse_pivot[0] - lower[1][0] * x1 - lower[2][0] * x2 - lower[3][0] * x3;
    }
};

Vec3 column(const DirectRow& row, int c) { return {row.next[0][c], row.next[1][c], row.next[2][c]}; }

/// Eliminates from the first particle to the last. Writes one row per particle.
void eliminate(const ChainView& view, DirectRow* rows, RopeContacts* contacts) {
    const Body& body = view.body;
    Link arriving;         // none arrives at the first particle
    bool coupled = false;  // whether the previous particle is free, so that its row is coupled to this one
    for (uint32_t i = 0; i <= view.chain.link_count; ++i) {
        const uint32_t p = view.particle(i);
        const Link leaving = i < view.chain.link_count ? view.link(i) : Link{};
        const bool free = !body.particles.pinned(p);
        DirectRow& row = rows[i];

        // The rows of this particle and of the link that arrives at it.
        const Vec3 n = free && arriving.active ? arriving.direction : Vec3{};
        Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
        Vec3 force;
        if (free) {
            const double m = body.particles.mass[p];
            x = x * m + arriving.geometric(x) + leaving.geometric(x);
            y = y * m + arriving.geometric(y) + leaving.geometric(y);
            z = z * m + arriving.geometric(z) + leaving.geometric(z);
            force = (body.history.predicted[p] - body.particles.position[p]) * m;
            if ((contacts && contacts->has_contacts(p)) || body.rope.loads.any()) {
                const double mass = m + arriving.stiffness + leaving.stiffness;
                ContactTerm term =
                    contacts && contacts->has_contacts(p) ? contacts->term(body, p, mass) : ContactTerm{};
                term.add_loads(body, p);
                x += Vec3{term.xx, term.xy, term.xz};
                y += Vec3{term.xy, term.yy, term.yz};
                z += Vec3{term.xz, term.yz, term.zz};
                force += term.force;
            }
        }
        double softness = -arriving.softness;
        double violation = arriving.active ? -arriving.error : 0;
        Vec3 nx = n;
        if (coupled && arriving.active) {
            // The Schur complement: subtract the coupling times the row of the previous particle.
            const DirectRow& before = rows[i - 1];
            const Vec3 d = arriving.direction;
            const Vec3 value{before.value[0], before.value[1], before.value[2]};
            const Vec3 link_column = column(before, 3);
            if (free) {
                x += arriving.geometric(column(before, 0));
                y += arriving.geometric(column(before, 1));
                z += arriving.geometric(column(before, 2));
                nx += arriving.geometric(link_column);
                force += arriving.geometric(value);
            }
            softness += dot(d, link_column);
            violation += dot(d, value);
        }
        const double matrix[4][4] = {
            {x.x, x.y, x.z, nx.x}, {x.y, y.y, y.z, nx.y}, {x.z, y.z, z.z, nx.z}, {nx.x, nx.y, nx.z, softness}};
        const Factors factors(matrix);

        row.value[0] = force.x, row.value[1] = force.y, row.value[2] = force.z, row.value[3] = violation;
        factors.solve(row.value[0], row.value[1], row.value[2], row.value[3]);
        const bool next_free = i < view.chain.link_count && !body.particles.pinned(view.particle(i + 1));
        for (int c = 0; c < 4; ++c) {
            Vec3 coupling;
            if (free && leaving.active) {
                if (c == 3)
                    coupling = -leaving.direction;
                else if (next_free)
                    coupling = -leaving.geometric({c == 0 ? 1.0 : 0.0, c == 1 ? 1.0 : 0.0, c == 2 ? 1.0 : 0.0});
            }
            row.next[0][c] = coupling.x, row.next[1][c] = coupling.y, row.next[2][c] = coupling.z, row.next[3][c] = 0;
            factors.solve(row.next[0][c], row.next[1][c], row.next[2][c], row.next[3][c]);
        }
        coupled = free;
        arriving = leaving;
    }
}

/// Substitutes from the last particle to the first; rows[i].value becomes the solution.
void substitute(const Chain& chain, DirectRow* rows) {
    for (uint32_t i = chain.link_count; i-- > 0;) {
        for (int r = 0; r < 4; ++r) {
            for (int c = 0; c < 4; ++c) rows[i].value[r] -= rows[i].next[r][c] * rows[i + 1].value[c];
        }
    }
}

/// The fraction of the solution to apply: no iteration moves a particle by more than the length of the chain, as placed
/// and at rest together. No valid correction is larger. That of an infeasible system may be, after regularisation.
double step_fraction(const ChainView& view, const DirectRow* rows) {
    double total_length = 0, longest = 0;
    for (uint32_t i = 0; i <= view.chain.link_count; ++i) {
        if (i < view.chain.link_count) {
            total_length += distance(view.body.particles.position[view.particle(i)],
                                     view.body.particles.position[view.particle(i + 1)]) +
                            view.body.rope.target[view.chain.first_link + i];
        }
        const double* value = rows[i].value;
        longest = std::max({longest, std::fabs(value[0]), std::fabs(value[1]), std::fabs(value[2])});
    }
    return longest > total_length ? total_length / longest : 1;
}

/// By how many metres a link is longer than its tension implies.
double residual(const ChainView& view, uint32_t i) {
    const Link link = view.link(i);
    return link.active ? std::fabs(link.error - link.softness * view.body.rope.tension[view.chain.first_link + i]) : 0;
}

bool is_converged(const ChainView& view) {
    for (uint32_t i = 0; i < view.chain.link_count; ++i) {
        const uint32_t index = view.chain.first_link + i;
        if (!view.link(i).active && view.body.rope.tension[index] != 0) return false;
        if (residual(view, i) > tolerance * view.body.rope.target[index]) return false;
    }
    return true;
}

/// Whether the lengths of all links are close enough to those that their tensions imply. A link of zero length has no
/// relative error.
bool is_solved(const ChainView& view) {
    for (uint32_t i = 0; i < view.chain.link_count; ++i) {
        const double target = view.body.rope.target[view.chain.first_link + i];
        if (target > 0 && residual(view, i) > rope_failure * target) return false;
    }
    return true;
}

/// Returns whether the chain is solved.
bool solve_chain(Body& body, const Chain& chain, double step, RopeContacts* contacts) {
    const ChainView view{body, chain, 1 / (step * step)};
    DirectRow* rows = body.rope.rows.data();
    set_targets(body, chain);
    const int iterations = body.plan.limited                   ? most_limited_iterations
                           : contacts || body.rope.loads.any() ? most_contact_iterations
                                                               : most_iterations;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        if (body.rope.bending.resists()) {
            solve_stiff(view, body.rope.stiff_rows.data(), rows, contacts);
        } else {
            eliminate(view, rows, contacts);
            substitute(chain, rows);
        }
        const double fraction = step_fraction(view, rows);
        for (uint32_t i = 0; i <= chain.link_count; ++i) {
            const double* value = rows[i].value;
            const uint32_t p = view.particle(i);
            if (!body.particles.pinned(p)) body.particles.position[p] += Vec3{value[0], value[1], value[2]} * fraction;
            if (i > 0) body.rope.tension[chain.first_link + i - 1] = value[3];
        }
        const bool contacts_converged = !contacts || contacts->update(body, iteration);
        if (iteration > 0 && contacts_converged && is_converged(view)) return true;
    }
    return is_solved(view);
}

}  // namespace

bool solve_directly(Body& body, double step) { return solve_with_contacts(body, step, nullptr); }

bool solve_with_contacts(Body& body, double step, RopeContacts* contacts) {
    // Tensions are stored in newtons, so that they are a good initial guess whatever the next step is. The equations
    // have tensions times step^2.
    for (double& tension : body.rope.tension) tension *= step * step;
    bool solved = true;
    for (const Chain& chain : body.plan.chains) solved = solve_chain(body, chain, step, contacts) && solved;
    for (double& tension : body.rope.tension) {
        tension /= step * step;
        if (!is_finite(tension)) tension = 0;  // the initial guess of the next solution must be finite
    }
    return solved;
}

}  // namespace gphys
