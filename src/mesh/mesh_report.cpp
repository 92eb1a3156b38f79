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

}  // namespace

gphys_mesh_report examine(const MeshArrays& arrays, std::pmr::memory_resource* memory) {
    gphys_mesh_report report{};
    report.triangle_count = arrays.index_count / 3;
    report.first_degenerate = report.first_out_of_range = report.first_bad_vertex = nothing;

    for (uint32_t i = 0; i < arrays.vertex_count; ++i) {
        if (defect(arrays.vertex(i))) count(i, report.bad_vertex_count, report.first_bad_vertex);
    }

    // Each triangle gives its three edges, as (lower index, higher index).
    Vector<uint64_t> edges(memory);
    edges.reserve(arrays.index_count);
    for (uint32_t triangle = 0; triangle < report.triangle_count; ++triangle) {
        const uint32_t* corner = arrays.indices + size_t{3} * triangle;
        if (std::max({corner[0], corner[1], corner[2]}) >= arrays.vertex_count) {
            count(triangle, report.out_of_range_count, report.first_out_of_range);
            continue;
        }
        const gphys_vec3 a = arrays.vertex(corner[0]), b = arrays.vertex(corner[1]), c = arrays.vertex(corner[2]);
        const bool valid = !defect(a) && !defect(b) && !defect(c);
        if (valid && turning_axis(widen(a), widen(b), widen(c)) < 0) {
            count(triangle, report.degenerate_count, report.first_degenerate);
        }
        // One that uses a vertex twice is no surface and joins nothing.
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
        for (int k = 0; k < 3; ++k) {
            const uint32_t from = corner[k], to = corner[(k + 1) % 3];
            edges.push_back(uint64_t{std::min(from, to)} << 32 | std::max(from, to));
        }
    }
    std::sort(edges.begin(), edges.end());
    for (auto edge = edges.begin(); edge != edges.end();) {
        const auto next = std::upper_bound(edge, edges.end(), *edge);
        if (next - edge != 2) ++report.open_edge_count;
        edge = next;
    }
    return report;
}

}  // namespace gphys
