// A mesh and its tree as an array of 32-bit words, in the machine's byte order:
//
//   header     snapshot_header.h
//   sizes      of vertices, indices and nodes; degenerate triangles, the first of them, open edges
//   indices    three for each triangle
//   vertices   three floats each
//   order      the triangles as the packets hold them; the last of each packet has last_of_packet
//   nodes      the layout of the tree (bvh_layout.h), whose items are the packets
//   kind       of a hull, and of a mesh in the form of a body: its MeshKind, and of links the radii, as MeshArrays has
//              them
//
// Whatever follows from other data (corners of packets, boxes) is computed again when a snapshot is read. So queries
// rely on nothing unchecked: indices, order and nodes are validated, and the boxes are right whatever the words are.
// For a hull, the hull of the vertices must have these triangles.
//
// Releases of one major version read all formats of earlier ones.
#pragma once

#include "bvh/bvh_layout.h"
#include "foundation/snapshot_header.h"
#include "foundation/word_hash.h"
#include "mesh/mesh_report.h"

namespace gphys {

/// The contents of a mesh whose tree is known.
struct MeshParts {
    static constexpr uint32_t last_of_packet = 0x80000000u;

    MeshArrays arrays;
    gphys_mesh_report report;
    WordHash index_hash;
    uint64_t hash;  // of all contents
    const uint32_t* order;
    BvhLayout tree;
};

struct MeshSnapshotSizes {
    uint32_t vertices, indices, nodes;
    uint32_t degenerate, first_degenerate, open_edges;
};
constexpr uint32_t mesh_snapshot_format = 1;
/// Size of the header and the sizes.
constexpr uint32_t mesh_snapshot_begin = snapshot_header_words + sizeof(MeshSnapshotSizes) / 4;

/// Hash of indices, vertices and radii, and of the kind.
inline uint64_t mesh_hash(const WordHash& contents, MeshKind kind) {
    return contents.value() + static_cast<uint64_t>(kind) * WordHash::golden;
}

/// Of the words after the sizes, and then of the sizes: it starts as the hash of a mesh does. `count` is at least
/// mesh_snapshot_begin.
uint64_t mesh_snapshot_checksum(const uint32_t* words, uint32_t count);

/// Reads the parts, which point into the words. Returns what is wrong with them, or nullptr. Throws std::bad_alloc.
const char* read_mesh_snapshot(const uint32_t* words, uint32_t count, std::pmr::memory_resource* memory,
                               MeshParts& parts);

}  // namespace gphys
