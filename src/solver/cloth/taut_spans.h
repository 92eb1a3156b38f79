// Rows of cloth between two pins that are farther apart than the row is long.
//
// Their links cannot have their lengths. Elimination along such a row would leave the error to its regularisation, and
// throw particles aside; limits of reach and relaxation would pull against each other without end. So the links of the
// row share the unavoidable stretch in proportion to their lengths, and limits of reach grow with the most stretched
// row.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

struct Cloth;
struct Particles;
struct Plan;

/// Rigid links of a chain from one pinned particle to the next, with others between them.
struct PinnedSpan {
    uint32_t a, b;          // the pins
    uint32_t first, count;  // the place of its first link in ClothBatches::rest, and its links, eight places apart
};

struct TautSpans {
    explicit TautSpans(std::pmr::memory_resource* memory) : spans(memory) {}

    Vector<PinnedSpan> spans;
    double stretch = 1;  // of the most stretched
};

/// Call after pack_cloth_chains and pack_reach_limits, when pins have changed. Throws std::bad_alloc.
void list_pinned_spans(Cloth& cloth, const Plan& plan, const Particles& particles);
/// Call in each substep when pins have moved. Sets the lengths that links aim at.
void stretch_taut_spans(Cloth& cloth);

}  // namespace gphys
