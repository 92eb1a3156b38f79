// Symbolic and numerical up-looking L D L^T factorisation (sparse_ldl.h).
#include "solver/joints/sparse_ldl.h"

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
        for (uint32_t p = factor_begin_[k]; p < factor_begin_[k + 1]; ++p) x[factor_rows_[p]] -= factor_[p] * x[k];
    }
    for (uint32_t k = n; k-- > 0;) {
        double value = x[k] * inverse_pivot_[k];
        for (uint32_t p = factor_begin_[k]; p < factor_begin_[k + 1]; ++p) value -= factor_[p] * x[factor_rows_[p]];
        x[k] = value;
    }
}

}  // namespace gphys
