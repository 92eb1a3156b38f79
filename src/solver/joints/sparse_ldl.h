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
    /// For one or two threes. `way`: if not null, keeps what the two functions below need.
    template <int threes>
    void inverse_block(const uint32_t (&first)[threes], double (&block)[3 * threes][3 * threes], double* way = nullptr);

    // A right-hand side to which six entries are added at a time, three from each of `first` on, and six unknowns of
    // its solution, in turn: faster than whole solutions. `way` is six numbers for each of the rows.
    /// Appends the rows of the way. Returns their number. Throws std::bad_alloc.
    uint32_t list_way(const uint32_t (&first)[2], Vector<uint32_t>& rows) const;
    void clear_sum();
    void add_to_sum(const double (&values)[6], const uint32_t* rows, uint32_t count, const double* way);
    void solve_sum(double (&x)[6], const uint32_t* rows, uint32_t count, const double* way) const;

private:
    template <int threes, class Visit>
    void each_ancestor(const uint32_t (&first)[threes], Visit&& visit) const;

    static constexpr uint32_t none = 0xffffffff, most_units = 6;

    std::pmr::memory_resource* memory_;
    Vector<uint32_t> column_begin_{memory_}, rows_{memory_};
    Vector<uint32_t> parent_{memory_};                               // the elimination tree
    Vector<uint32_t> factor_begin_{memory_}, factor_rows_{memory_};  // L by column
    Vector<uint32_t> filled_{memory_}, mark_{memory_}, pattern_{memory_};
    Vector<double> factor_{memory_}, inverse_pivot_{memory_};
    Vector<double> sum_{memory_}, units_{memory_};  // zero between calls; units_: `most_units` for each row
    Vector<double> substituted_{memory_};           // the right-hand side of add_to_sum, with L D substituted
};

}  // namespace gphys
