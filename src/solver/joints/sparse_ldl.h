// Sparse symmetric matrices factorised as L D L^T: up-looking, row by row along the elimination tree (Davis 2005,
// "Algorithm 849: A concise sparse Cholesky factorization package"). There is no pivoting, so the matrix must be
// definite or quasi-definite (Vanderbei 1995).
#pragma once

#include <cstdint>

#include "foundation/floating_point.h"
#include "foundation/memory.h"

namespace gphys {

class SparseLdl {
public:
    explicit SparseLdl(std::pmr::memory_resource* source) : memory_(source) {}

    /// The pattern of the upper triangle without the diagonal, column by column, in any order within a column. Entries
    /// at the same place are added. Throws std::bad_alloc.
    void analyse(const Vector<uint32_t>& column_begin, const Vector<uint32_t>& rows);
    uint32_t size() const { return static_cast<uint32_t>(parent_.size()); }
    /// Number of entries of L without its diagonal.
    size_t fill() const { return factor_rows_.size(); }
    /// The first entry of a column.
    uint32_t column_begin(uint32_t column) const { return column_begin_[column]; }

    /// Values of the entries, in the order of `rows`, and of the diagonal.
    void factor(const double* entries, const double* diagonal);
    /// Replaces the right-hand side by the solution.
    void solve(double* x) const;
    /// Rows of the inverse, three from each of `first` on, and the same columns. The pattern must couple each three.
    /// For one or two threes.
    template <int threes>
    void inverse_block(const uint32_t (&first)[threes], double (&block)[3 * threes][3 * threes]);

private:
    static constexpr uint32_t none = 0xffffffff, most_units = 6;

    std::pmr::memory_resource* memory_;
    Vector<uint32_t> column_begin_{memory_}, rows_{memory_};
    Vector<uint32_t> parent_{memory_};                               // the elimination tree
    Vector<uint32_t> factor_begin_{memory_}, factor_rows_{memory_};  // L by column
    Vector<uint32_t> filled_{memory_}, mark_{memory_}, pattern_{memory_};
    Vector<double> factor_{memory_}, inverse_pivot_{memory_};
    Vector<double> sum_{memory_}, units_{memory_};  // zero between calls; units_: `most_units` for each row
};

}  // namespace gphys
