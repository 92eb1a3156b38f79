// The order in which to eliminate the nodes of a graph, for little fill: the node with the fewest neighbours first
// (Tinney & Walker 1967).
#pragma once

#include <cstdint>

#include "foundation/memory.h"

namespace gphys {

struct Edge {
    uint32_t a, b;
};

/// Of nodes with equally many neighbours, the lowest index comes first; nodes with very many neighbours come last.
/// Edges may occur twice. Throws std::bad_alloc.
void order_by_degree(uint32_t nodes, const Vector<Edge>& edges, Vector<uint32_t>& order);

}  // namespace gphys
