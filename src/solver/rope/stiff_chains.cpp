// Elimination along chains that resist bending. Their particles are coupled with the second next ones too (bending.h),
// so the matrix of rope_direct.cpp is no longer block tridiagonal, but it still is a band. The unknowns of particle i
// and of the link that arrives at it are rows 4 i to 4 i + 3, hence no entry is more than eight rows below the
// diagonal: the one between x_i and x_(i-2), which is bending alone. Bending adds a semidefinite matrix, so the whole
// stays quasi-definite, and L D L^T without pivoting exists (Vanderbei 1995).
//
// Why rows and not blocks: the band of scalars takes 60 multiplications a row and has no fill that is not used. Blocks
// of two particles, which would be block tridiagonal, are 8 x 8, and take twice as many.
#include "solver/rope/stiff_chains.h"

#include "foundation/compiler.h"
#include "solver/rope/rope_contacts.h"

namespace gphys {
namespace {

constexpr int band = stiff_band;

/// The entries of a row in the making: at[band] is the diagonal, at[band - k] the entry k columns before it.
struct Row {
    double at[band + 1] = {};
    double value = 0;
};

/// Eliminates row r and writes its factor. Unrolled, it takes two thirds of the time.
void eliminate(const Row& row, StiffRow* rows, uint32_t r) {
    StiffRow& out = rows[r];
    const StiffRow* const column = rows + r - band;  // by k: the row of the entry's column
    double scaled[band];                             // L D
    double pivot = row.at[band], value = row.value;
    GPHYS_UNROLLED
    for (int k = 0; k < band; ++k) {
        double sum = row.at[k];
        GPHYS_UNROLLED
        for (int j = 0; j < k; ++j) sum -= scaled[j] * column[k].lower[j + band - k];
        scaled[k] = sum;
        const double entry = sum * column[k].inverse_pivot;
        pivot -= sum * entry;
        value -= entry * column[k].value;
        out.lower[k] = entry;
    }
    out.inverse_pivot = pivot != 0 ? 1 / pivot : 0;  // 0 if the row depends linearly on earlier ones
    out.value = value;
}

void substitute(StiffRow* rows, uint32_t count) {
    std::fill_n(rows + count, band, StiffRow{});  // so that all rows have as many after them, too
    for (uint32_t r = count; r-- > 0;) {
        double sum = rows[r].value * rows[r].inverse_pivot;
        // The row that has just become known comes last, so that the sum need not wait for it.
        GPHYS_UNROLLED
        for (uint32_t k = band; k > 0; --k) sum -= rows[r + k].lower[band - k] * rows[r + k].value;
        rows[r].value = sum;
    }
}

/// The bends of a chain, times the square of the step.
struct ChainBends {
    const ChainView& view;
    const Bending& bending;
    double step_squared;

    Bend bend(uint32_t i) const {
        return i > 0 && i < view.chain.link_count ? bending.bends[view.chain.first_link + i] : Bend{};
    }
    /// Where the bend is measured from: a straight line, or the predicted shape.
    Vec3 place(uint32_t i) const {
        const uint32_t p = view.particle(i);
        const Vec3 at = view.body.particles.position[p];
        return bending.keeps_shape ? at - view.body.history.predicted[p] : at;
    }
    /// kg m: the strain of the bend, times factor.
    Vec3 pull(uint32_t i, const Bend& bend, double factor) const {
        if (!bend.resists()) return {};
        return bend.strain(place(i - 1), place(i), place(i + 1)) * (factor * step_squared);
    }
};

/// K of a link, see rope_direct.cpp.
struct Geometric {
    double at[3][3] = {};

    Geometric() = default;
    explicit Geometric(const Link& link) {
        for (int r = 0; r < 3; ++r) {
            const double along = link.stiffness * link.direction[r];
            for (int c = 0; c < 3; ++c) at[r][c] = (r == c ? link.stiffness : 0) - along * link.direction[c];
        }
    }
};

}  // namespace

void solve_stiff(const ChainView& view, StiffRow* stiff, DirectRow* rows, RopeContacts* contacts) {
    const Body& body = view.body;
    const ChainBends bends{view, body.rope.bending, 1 / view.inverse_step_squared};
    stiff += band;  // those before the first are 0, so that all rows have as many before them
    Link arriving;  // none arrives at the first particle
    Geometric arriving_stiffness;
    const auto is_free = [&](uint32_t i) { return !body.particles.pinned(view.particle(i)); };
    for (uint32_t i = 0; i <= view.chain.link_count; ++i) {
        const uint32_t p = view.particle(i);
        const Link leaving = i < view.chain.link_count ? view.link(i) : Link{};
        const Geometric leaving_stiffness(leaving);
        const bool free = is_free(i), next_to_free = i > 0 && is_free(i - 1);
        Row x[3];
        if (free) {
            const Bend before = i > 0 ? bends.bend(i - 1) : Bend{}, here = bends.bend(i), after = bends.bend(i + 1);
            const double both = here.before + here.after;
            const double lateral =
                (before.after * before.after + both * both + after.before * after.before) * bends.step_squared;
            const double m = body.particles.mass[p];
            Vec3 force = (body.history.predicted[p] - body.particles.position[p]) * m;
            force += bends.pull(i, here, both);
            if (i > 0) force -= bends.pull(i - 1, before, before.after);
            force -= bends.pull(i + 1, after, after.before);
            ContactTerm term;
            if (contacts && contacts->has_contacts(p)) {
                term = contacts->term(body, p, m + arriving.stiffness + leaving.stiffness + lateral);
                force += term.force;
            }
            if (body.rope.loads.any()) {
                term.force = {};
                term.add_loads(body, p);
                force += term.force;
            }
            const double of_contacts[3][3] = {
                {term.xx, term.xy, term.xz}, {term.xy, term.yy, term.yz}, {term.xz, term.yz, term.zz}};
            const double to_previous =
                -(both * here.before + (before.before + before.after) * before.after) * bends.step_squared;
            const double to_second = before.before * before.after * bends.step_squared;
            const bool second_free = i > 1 && is_free(i - 2);
            for (int r = 0; r < 3; ++r) {
                for (int c = 0; c <= r; ++c)
                    x[r].at[band - (r - c)] =
                        arriving_stiffness.at[r][c] + leaving_stiffness.at[r][c] + of_contacts[r][c];
                x[r].at[band] += m + lateral;
                x[r].value = force[r];
                if (next_to_free) {
                    for (int c = 0; c < 3; ++c) x[r].at[band - (4 + r - c)] = -arriving_stiffness.at[r][c];
                    x[r].at[band - 4] += to_previous;
                }
                if (second_free) x[r].at[band - 8] = to_second;
            }
        } else {
            for (Row& row : x) row.at[band] = 1;
        }
        Row tension;
        tension.at[band] = -arriving.softness;
        if (arriving.active) {
            tension.value = -arriving.error;
            for (int c = 0; c < 3; ++c) {
                if (free) tension.at[band - (3 - c)] = arriving.direction[c];
                if (next_to_free) tension.at[band - (7 - c)] = -arriving.direction[c];
            }
        }
        for (uint32_t r = 0; r < 3; ++r) eliminate(x[r], stiff, 4 * i + r);
        eliminate(tension, stiff, 4 * i + 3);
        arriving = leaving;
        arriving_stiffness = leaving_stiffness;
    }
    substitute(stiff, 4 * (view.chain.link_count + 1));
    for (uint32_t i = 0; i <= view.chain.link_count; ++i) {
        for (uint32_t r = 0; r < 4; ++r) rows[i].value[r] = stiff[4 * i + r].value;
    }
}

}  // namespace gphys
