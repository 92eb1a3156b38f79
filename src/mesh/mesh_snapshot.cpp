// Writing and validating snapshots of meshes (mesh_snapshot.h).
#include "mesh/mesh_snapshot.h"

#include "foundation/status.h"
#include "mesh/convex_hull.h"
#include "mesh/mesh.h"

namespace gphys {
namespace {

using Sizes = MeshSnapshotSizes;
constexpr uint32_t size_words = sizeof(Sizes) / 4;
constexpr uint32_t words_of_vertex = sizeof(gphys_vec3) / 4;

uint64_t words_of(const Sizes& sizes) {
    return mesh_snapshot_begin + uint64_t{words_of_vertex} * sizes.vertices + sizes.indices + sizes.indices / 3 +
           sizes.nodes;
}

/// Words of the last section, which a surface does not have.
uint64_t words_of_kind(MeshKind kind, const Sizes& sizes) {
    return kind == MeshKind::surface ? 0 : kind == MeshKind::body_links ? 1 + sizes.indices / 3 : 1;
}

bool report_fits(const Sizes& sizes) {
    const uint32_t triangles = sizes.indices / 3;
    return sizes.degenerate <= triangles && sizes.open_edges <= sizes.indices &&
           (sizes.degenerate == 0 ? sizes.first_degenerate == GPHYS_NO_TRIANGLE : sizes.first_degenerate < triangles);
}

/// Compares bit patterns: those of infinity and NaN are above all finite ones.
bool are_coordinates(const uint32_t* values, uint64_t count) {
    constexpr float last = GPHYS_MAX_COORDINATE;
    uint32_t last_bits;
    std::memcpy(&last_bits, &last, sizeof last);
    bool fine = true;
    for (uint64_t i = 0; i < count; ++i) fine &= (values[i] & 0x7fffffff) <= last_bits;
    return fine;
}

bool are_below(uint32_t limit, const uint32_t* values, uint32_t count) {
    bool fine = true;
    for (uint32_t i = 0; i < count; ++i) fine &= values[i] < limit;
    return fine;
}

/// The number of packets, if `order` lists each triangle once in packets of one to eight; else 0.
uint32_t count_packets(const uint32_t* order, uint32_t triangles, std::pmr::memory_resource* memory) {
    Vector<uint64_t> seen(size_t{triangles} / 64 + 1, 0, memory);
    uint32_t packets = 0, size = 0;
    for (uint32_t i = 0; i < triangles; ++i) {
        const uint32_t triangle = order[i] & ~MeshParts::last_of_packet;
        if (triangle >= triangles || ++size > 8) return 0;
        uint64_t& set = seen[triangle / 64];
        const uint64_t bit = uint64_t{1} << triangle % 64;
        if ((set & bit) != 0) return 0;
        set |= bit;
        if (triangle == order[i]) continue;
        ++packets;
        size = 0;
    }
    return size == 0 ? packets : 0;
}

/// Whether make_hull returns the same vertices and triangles.
bool is_hull_of_itself(const MeshArrays& arrays, std::pmr::memory_resource* memory) {
    if (arrays.vertex_count > 2 * most_hull_faces) return false;  // rejected early: make_hull would take long
    HullSurface hull(memory);
    if (make_hull(arrays, hull) != HullDefect::none) return false;
    return hull.vertices.size() == arrays.vertex_count && hull.indices.size() == arrays.index_count &&
           std::equal(hull.indices.begin(), hull.indices.end(), arrays.indices);
}

}  // namespace

uint64_t mesh_snapshot_checksum(const uint32_t* words, uint32_t count) {
    WordHash hash;
    hash.put(words + mesh_snapshot_begin, count - mesh_snapshot_begin);
    hash.put(words + snapshot_header_words, size_words);
    return hash.value();
}

const char* read_mesh_snapshot(const uint32_t* words, uint32_t count, std::pmr::memory_resource* memory,
                               MeshParts& parts) {
    SnapshotHeader header;
    if (const char* wrong = read_header(words, count, mesh_snapshot_magic, 1, mesh_snapshot_format, header))
        return wrong;
    constexpr const char* wrong_lengths = "words: the lengths in it do not add up to count";
    if (count < mesh_snapshot_begin) return wrong_lengths;
    Sizes sizes;
    std::memcpy(&sizes, words + snapshot_header_words, sizeof sizes);
    if (sizes.indices % 3 != 0 || words_of(sizes) > count) return wrong_lengths;
    MeshKind kind = MeshKind::surface;
    const uint32_t* const last = words + words_of(sizes);
    if (words_of(sizes) < count) {
        if (*last == static_cast<uint32_t>(MeshKind::surface) || *last > static_cast<uint32_t>(MeshKind::hull)) {
            return wrong_lengths;
        }
        kind = static_cast<MeshKind>(*last);
    }
    if (words_of(sizes) + words_of_kind(kind, sizes) != count) return wrong_lengths;

    const uint32_t* const indices = words + mesh_snapshot_begin;
    const uint32_t* const vertices = indices + sizes.indices;
    const uint32_t* const order = vertices + size_t{words_of_vertex} * sizes.vertices;
    const uint32_t* const radii = last + 1;
    const uint32_t radius_count = kind == MeshKind::body_links ? sizes.indices / 3 : 0;
    const uint32_t triangles = sizes.indices / 3;
    WordHash hash;
    hash.put(indices, sizes.indices);
    parts.index_hash = hash;
    hash.put(vertices, static_cast<size_t>(order - vertices));
    WordHash contents = hash;
    contents.put(radii, radius_count);
    parts.hash = mesh_hash(contents, kind);
    hash.put(order, static_cast<size_t>(words + count - order));
    hash.put(words + snapshot_header_words, size_words);
    if (!header.has_checksum(hash.value())) return "words: the checksum is not that of the contents";

    if (!report_fits(sizes)) return "words: the numbers in the report of the mesh contradict each other";
    if (!are_coordinates(vertices, uint64_t{words_of_vertex} * sizes.vertices)) {
        return "words: a vertex is out of range";
    }
    if (!are_coordinates(radii, radius_count)) return "words: a radius is out of range";
    if (!are_below(sizes.vertices, indices, sizes.indices)) return "words: an index is out of range";
    const uint32_t packets = count_packets(order, triangles, memory);
    if (triangles > 0 && packets == 0) return "words: the order of the triangles is not a permutation";
    parts.arrays = {reinterpret_cast<const float*>(vertices),
                    sizeof(gphys_vec3),
                    sizes.vertices,
                    indices,
                    sizes.indices,
                    kind,
                    radius_count > 0 ? reinterpret_cast<const float*>(radii) : nullptr};
    parts.report = {};
    parts.report.triangle_count = triangles;
    parts.report.degenerate_count = sizes.degenerate;
    parts.report.first_degenerate = sizes.first_degenerate;
    parts.report.first_out_of_range = parts.report.first_bad_vertex = GPHYS_NO_TRIANGLE;
    parts.report.open_edge_count = sizes.open_edges;
    parts.order = order;
    parts.tree = {order + triangles, sizes.nodes, nullptr, packets};
    if (parts.tree.defect()) return "words: the octree of the mesh is not valid";
    return kind != MeshKind::hull || is_hull_of_itself(parts.arrays, memory)
               ? nullptr
               : "words: the triangles are not the hull of their vertices";
}

gphys_status Mesh::snapshot(uint32_t* out, uint32_t capacity, uint32_t& total) const {
    const gphys_mesh_report now = report();
    const Sizes sizes{static_cast<uint32_t>(vertices_.size()),
                      static_cast<uint32_t>(indices_.size()),
                      bvh_.node_count(),
                      now.degenerate_count,
                      now.first_degenerate,
                      now.open_edge_count};
    const uint64_t words = words_of(sizes) + words_of_kind(kind_, sizes);
    GPHYS_TRY(fit_snapshot(words, capacity, total));
    uint32_t* to = out + snapshot_header_words;
    const auto copy = [&](const void* from, size_t size) {
        if (size > 0) std::memcpy(to, from, 4 * size);  // if size is 0, `from` may be null
        to += size;
    };
    copy(&sizes, size_words);
    copy(indices_.data(), indices_.size());
    copy(vertices_.data(), words_of_vertex * vertices_.size());
    uint32_t *order = to, *node = to + triangle_count();
    bvh_.visit_layout([&](uint32_t word) { *node++ = word; },
                      [&](uint32_t number) {
                          const TrianglePacket& packet = packets_[number];
                          order = std::copy_n(packet.index, packet.count(), order);
                          order[-1] |= MeshParts::last_of_packet;
                      });
    if (kind_ != MeshKind::surface) {
        to = node;
        copy(&kind_, 1);
        copy(radii_.data(), radii_.size());
    }
    write_header(out, mesh_snapshot_magic, mesh_snapshot_format, total, mesh_snapshot_checksum(out, total));
    return GPHYS_OK;
}

}  // namespace gphys
