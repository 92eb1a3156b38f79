// A scene as a row of 32-bit words, in the machine's byte order:
//
//   header     snapshot_header.h
//   sizes      of the meshes, the BVH and the embedded meshes
//   meshes     by the lowest model that uses each: what it holds, and how many words it has if it is embedded
//   state      origin, ids, and by slot the models: what the scene's hash is of
//   BVH     its layout (bvh_layout.h); items are slots
//   embedded   snapshots of meshes, each with a header and checksum of its own
//
// World transforms, boxes and lists of children follow from the rest and are made again. So whatever the words were,
// the scene that they give is sound, or they are refused.
//
// The BVH is not built again: to build it takes several times as long as to lay it out, and a bad one costs
// nothing but time.
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
    uint32_t parts;  // that models have besides: has_places, has_scales
};
constexpr uint32_t has_places = 1;  // in the world (set_origin)
constexpr uint32_t has_scales = 2;  // per axis; else all are one

constexpr uint32_t scene_snapshot_magic = 0x67706873;
constexpr uint32_t scene_snapshot_format = 1;

/// Of all between the header and the embedded meshes.
uint64_t scene_snapshot_checksum(const uint32_t* words, uint32_t count);

}  // namespace gphys
