// Validation of triangle arrays: bad vertices, indices out of range, degenerate triangles, open edges (mesh_report.h).
#include "mesh/mesh_report.h"

#include <algorithm>

#include "foundation/exact.h"
#include "shapes/shapes.h"

namespace gphys {
namespace {

constexpr uint32_t nothing = 0xffffffffu;

void count(uint32_t index, uint32_t& counter, uint32_t& first) {
    if (counter++ == 0) first = index;
}

/// Visits the edges of the triangles that have three different vertices in range: visit(low, high). A triangle that
/// uses a vertex twice has no area, so its edges do not count.
template <class Visit>
void for_each_edge(const MeshArrays& arrays, Visit&& visit) {
    for (uint32_t triangle = 0; triangle < arrays.index_count / 3; ++triangle) {
        const uint32_t* corner = arrays.indices + size_t{3} * triangle;
        const uint32_t a = corner[0], b = corner[1], c = corner[2];
        if (std::max({a, b, c}) >= arrays.vertex_count || a == b || b == c || c == a) continue;
        visit(std::min(a, b), std::max(a, b));
        visit(std::min(b, c), std::max(b, c));
        visit(std::min(c, a), std::max(c, a));
    }
}

/// The number of edges that do not join exactly two triangles.
uint32_t count_open_edges(const MeshArrays& arrays, std::pmr::memory_resource* memory) {
    // Counting sort by the lower vertex. Each vertex then has a few edges, which are counted by the higher vertex.
    Vector<uint32_t> end(size_t{arrays.vertex_count} + 1, 0, memory);
    for_each_edge(arrays, [&](uint32_t low, uint32_t) { ++end[low + 1]; });
    for (uint32_t i = 0; i < arrays.vertex_count; ++i) end[i + 1] += end[i];
    Vector<uint32_t> high_ends(end.back(), 0, memory);
    for_each_edge(arrays, [&](uint32_t low, uint32_t high) { high_ends[end[low]++] = high; });

    uint32_t open = 0;
    Vector<uint32_t> joined(arrays.vertex_count, 0, memory);  // by vertex: triangles at the edge from `low` to it
    auto first = high_ends.begin();
    for (uint32_t low = 0; low < arrays.vertex_count; ++low) {
        const auto last = high_ends.begin() + end[low];
        for (auto high = first; high != last; ++high) ++joined[*high];
        for (; first != last; ++first) {
            uint32_t& triangles = joined[*first];
            open += (triangles != 0) & (triangles != 2);
            triangles = 0;
        }
    }
    return open;
}

}  // namespace

void count_degenerate(const MeshArrays& arrays, gphys_mesh_report& report) {
    report.degenerate_count = 0;
    report.first_degenerate = nothing;
    for (uint32_t triangle = 0; triangle < report.triangle_count; ++triangle) {
        const uint32_t* corner = arrays.indices + size_t{3} * triangle;
        const Vec3 a = widen(arrays.vertex(corner[0])), b = widen(arrays.vertex(corner[1]));
        if (turning_axis(a, b, widen(arrays.vertex(corner[2]))) < 0) {
            count(triangle, report.degenerate_count, report.first_degenerate);
        }
    }
}

gphys_mesh_report examine(const MeshArrays& arrays, std::pmr::memory_resource* memory) {
    gphys_mesh_report report{};
    report.triangle_count = arrays.index_count / 3;
    report.first_degenerate = report.first_out_of_range = report.first_bad_vertex = nothing;

    for (uint32_t i = 0; i < arrays.vertex_count; ++i) {
        if (defect(arrays.vertex(i))) count(i, report.bad_vertex_count, report.first_bad_vertex);
    }
    for (uint32_t triangle = 0; triangle < report.triangle_count; ++triangle) {
        const uint32_t* corner = arrays.indices + size_t{3} * triangle;
        if (std::max({corner[0], corner[1], corner[2]}) >= arrays.vertex_count) {
            count(triangle, report.out_of_range_count, report.first_out_of_range);
            continue;
        }
        const gphys_vec3 a = arrays.vertex(corner[0]), b = arrays.vertex(corner[1]), c = arrays.vertex(corner[2]);
        const bool valid = report.bad_vertex_count == 0 || (!defect(a) && !defect(b) && !defect(c));
        if (valid && turning_axis(widen(a), widen(b), widen(c)) < 0) {
            count(triangle, report.degenerate_count, report.first_degenerate);
        }
    }
    report.open_edge_count = count_open_edges(arrays, memory);
    return report;
}

}  // namespace gphys
