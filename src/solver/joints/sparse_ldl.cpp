// Symbolic and numerical up-looking L D L^T factorisation (sparse_ldl.h).
#include "solver/joints/sparse_ldl.h"

#include <algorithm>

namespace gphys {

void SparseLdl::analyse(const Vector<uint32_t>& column_begin, const Vector<uint32_t>& rows) {
    const uint32_t n = static_cast<uint32_t>(column_begin.size()) - 1;
    column_begin_ = column_begin;
    rows_ = rows;
    parent_.assign(n, none);
    mark_.resize(n);
    filled_.assign(n, 0);
    for (uint32_t k = 0; k < n; ++k) {
        mark_[k] = k;
        for (uint32_t e = column_begin[k]; e < column_begin[k + 1]; ++e) {
            for (uint32_t i = rows[e]; mark_[i] != k; i = parent_[i]) {
                if (parent_[i] == none) parent_[i] = k;
                ++filled_[i];
                mark_[i] = k;
            }
        }
    }
    factor_begin_.assign(n + 1, 0);
    for (uint32_t k = 0; k < n; ++k) factor_begin_[k + 1] = factor_begin_[k] + filled_[k];
    factor_rows_.resize(factor_begin_[n]);
    factor_.resize(factor_begin_[n]);
    pattern_.resize(n);
    inverse_pivot_.resize(n);
    sum_.assign(n, 0.0);
    units_.assign(most_units * size_t{n}, 0.0);
    substituted_.assign(n, 0.0);
}

void SparseLdl::factor(const double* entries, const double* diagonal) {
    const uint32_t n = size();
    for (uint32_t k = 0; k < n; ++k) {
        // The pattern of row k of L, in topological order, from the end of the array.
        uint32_t top = n;
        mark_[k] = k;
        for (uint32_t e = column_begin_[k]; e < column_begin_[k + 1]; ++e) {
            sum_[rows_[e]] += entries[e];
            uint32_t length = 0;
            for (uint32_t i = rows_[e]; mark_[i] != k; i = parent_[i]) {
                pattern_[length++] = i;
                mark_[i] = k;
            }
            while (length > 0) pattern_[--top] = pattern_[--length];
        }
        double pivot = diagonal[k];
        for (; top < n; ++top) {
            const uint32_t i = pattern_[top];
            const double value = sum_[i];
            sum_[i] = 0;
            const uint32_t begin = factor_begin_[i], end = begin + filled_[i];
            for (uint32_t p = begin; p < end; ++p) sum_[factor_rows_[p]] -= factor_[p] * value;
            const double entry = value * inverse_pivot_[i];
            pivot -= entry * value;
            factor_rows_[end] = k;
            factor_[end] = entry;
            ++filled_[i];
        }
        // 0 if the row depends linearly on earlier ones: then its unknown is 0.
        inverse_pivot_[k] = pivot != 0 ? 1 / pivot : 0;
        filled_[k] = 0;
    }
}

void SparseLdl::solve(double* x) const {
    const uint32_t n = size();
    for (uint32_t k = 0; k < n; ++k) {
        if (x[k] == 0) continue;  // most of a force at one place
        for (uint32_t p = factor_begin_[k]; p < factor_begin_[k + 1]; ++p) x[factor_rows_[p]] -= factor_[p] * x[k];
    }
    for (uint32_t k = n; k-- > 0;) {
        double value = x[k] * inverse_pivot_[k];
        for (uint32_t p = factor_begin_[k]; p < factor_begin_[k + 1]; ++p) value -= factor_[p] * x[factor_rows_[p]];
        x[k] = value;
    }
}

/// Visits the rows of some threes and their ancestors, in ascending order.
template <int threes, class Visit>
void SparseLdl::each_ancestor(const uint32_t (&first)[threes], Visit&& visit) const {
    uint32_t next[threes];  // on the way up from each
    std::copy(first, first + threes, next);
    // The ways end at a common ancestor, or at the roots of two trees.
    for (uint32_t i; (i = *std::min_element(next, next + threes)) != none;) {
        visit(i);
        for (uint32_t& from : next) {
            if (from == i) from = parent_[i];
        }
    }
}

// With L y_a = e_a for the unit vector of row a, the inverse has the sum of y_a y_b / pivot in row a and column b. Such
// a y is 0 except at the ancestors of its row in the elimination tree (Davis 2006, "Direct methods for sparse linear
// systems", section 3.2), so a whole solution is not needed.
template <int threes>
void SparseLdl::inverse_block(const uint32_t (&first)[threes], double (&block)[3 * threes][3 * threes], double* way) {
    constexpr int units = 3 * threes;
    for (int three = 0; three < threes; ++three) {
        for (int k = 3 * three; k < 3 * three + 3; ++k) {
            for (double& entry : block[k]) entry = 0;
            units_[most_units * size_t{first[three] + static_cast<uint32_t>(k) % 3} + static_cast<uint32_t>(k)] = 1;
        }
    }
    each_ancestor(first, [&](uint32_t i) {
        double* const unit = &units_[most_units * size_t{i}];
        double y[units];
        for (int a = 0; a < units; ++a) {
            y[a] = unit[a];
            unit[a] = 0;
            for (int b = 0; b <= a; ++b) block[a][b] += y[a] * y[b] * inverse_pivot_[i];
        }
        if (way) way = std::copy(y, y + units, way);
        for (uint32_t p = factor_begin_[i]; p < factor_begin_[i + 1]; ++p) {
            double* const below = &units_[most_units * size_t{factor_rows_[p]}];
            for (int a = 0; a < units; ++a) below[a] -= factor_[p] * y[a];
        }
    });
    for (int a = 0; a < units; ++a) {
        for (int b = a + 1; b < units; ++b) block[a][b] = block[b][a];
    }
}

uint32_t SparseLdl::list_way(const uint32_t (&first)[2], Vector<uint32_t>& rows) const {
    uint32_t count = 0;
    each_ancestor(first, [&](uint32_t i) {
        rows.push_back(i);
        ++count;
    });
    return count;
}

void SparseLdl::clear_sum() { std::fill(substituted_.begin(), substituted_.end(), 0.0); }

void SparseLdl::add_to_sum(const double (&values)[6], const uint32_t* rows, uint32_t count, const double* way) {
    for (const uint32_t* row = rows; row != rows + count; ++row, way += 6) {
        double sum = 0;
        for (int k = 0; k < 6; ++k) sum += way[k] * values[k];
        substituted_[*row] += sum * inverse_pivot_[*row];
    }
}

void SparseLdl::solve_sum(double (&x)[6], const uint32_t* rows, uint32_t count, const double* way) const {
    for (double& unknown : x) unknown = 0;
    for (const uint32_t* row = rows; row != rows + count; ++row, way += 6) {
        for (int k = 0; k < 6; ++k) x[k] += way[k] * substituted_[*row];
    }
}

template void SparseLdl::inverse_block<1>(const uint32_t (&first)[1], double (&block)[3][3], double*);
template void SparseLdl::inverse_block<2>(const uint32_t (&first)[2], double (&block)[6][6], double*);

}  // namespace gphys
