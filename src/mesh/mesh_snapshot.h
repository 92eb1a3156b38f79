// A mesh and its tree as a row of 32-bit words, in the machine's byte order:
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
// What follows from others (corners of packets, boxes) is made again. So nothing that a query relies on is taken on
// trust: indices, order and nodes are checked, and the boxes are right whatever the words were. Of a hull the vertices
// are to have those triangles as their hull.
//
// Releases of one major version read all formats of earlier ones.
#pragma once

#include "bvh/bvh_layout.h"
#include "foundation/snapshot_header.h"
#include "foundation/word_hash.h"
#include "mesh/mesh_report.h"

namespace gphys {

/// What a mesh is made of whose tree is known.
struct MeshParts {
    static constexpr uint32_t last_of_packet = 0x80000000u;

    MeshArrays arrays;
    gphys_mesh_report report;
    WordHash index_hash;
    uint64_t hash;  // of all that it holds
    const uint32_t* order;
    BvhLayout tree;
};

struct MeshSnapshotSizes {
    uint32_t vertices, indices, nodes;
    uint32_t degenerate, first_degenerate, open_edges;
};
constexpr uint32_t mesh_snapshot_magic = 0x6770686d;
constexpr uint32_t mesh_snapshot_format = 1;
/// The header and the sizes.
constexpr uint32_t mesh_snapshot_begin = snapshot_header_words + sizeof(MeshSnapshotSizes) / 4;

/// Of indices, vertices and radii, and of the kind.
inline uint64_t mesh_hash(const WordHash& contents, MeshKind kind) {
    return contents.value() + static_cast<uint64_t>(kind) * WordHash::golden;
}

/// Of what follows the sizes, and then of these: it begins as the hash of a mesh does. `count` is mesh_snapshot_begin
/// at least.
uint64_t mesh_snapshot_checksum(const uint32_t* words, uint32_t count);

/// The parts, which point into the words; returns what is wrong with them, or nullptr. Throws std::bad_alloc.
const char* read_mesh_snapshot(const uint32_t* words, uint32_t count, std::pmr::memory_resource* memory,
                               MeshParts& parts);

}  // namespace gphys
