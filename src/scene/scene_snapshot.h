// The snapshot of a scene: 32-bit words, in the machine's byte order:
//
//   header     snapshot_header.h
//   sizes      of the meshes, the BVH and the embedded meshes
//   meshes     in the order of the lowest model that uses each: hash and sizes of its contents, words if embedded
//   state      origin, ids, and the models by slot: the input of the scene's hash
//   BVH        its layout (bvh_layout.h); items are slots
//   embedded   snapshots of meshes, each with its own header and checksum
//
// World transforms, boxes and lists of children are not stored but derived again. So any words either give a consistent
// scene or are rejected.
//
// The BVH is stored, since a build takes several times as long as a restore of its layout. A bad layout costs only
// time.
//
// Releases of one major version read all formats of earlier ones.
#pragma once

#include <cstdint>

#include "foundation/snapshot_header.h"

namespace gphys {

struct SceneSnapshotSizes {
    uint32_t meshes;
    uint32_t nodes, items;  // of the BVH
    uint32_t embedded_words;
    uint32_t parts;  // optional parts of models: has_places, has_scales
};
constexpr uint32_t has_places = 1;  // places in the world (set_origin)
constexpr uint32_t has_scales = 2;  // scales per axis; else all are one

constexpr uint32_t scene_snapshot_format = 1;

/// Of the words between the header and the embedded meshes.
uint64_t scene_snapshot_checksum(const uint32_t* words, uint32_t count);

}  // namespace gphys
