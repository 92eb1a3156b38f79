// The shortest paths from pinned particles along rigid links, from which reach limits follow (pin_paths.cpp). Each
// particle has one from each of its nearest four pins.
#pragma once

#include "foundation/memory.h"
#include "solver/cloth/rigid_links.h"

namespace gphys {

struct Particles;

// A pinned edge would give each particle dozens of limits. More than the nearest few hardly reduce the stretch.
constexpr uint32_t most_anchors = 4;

/// A path of known length from a pinned particle, along rigid links.
struct PinPath {
    double length;
    uint32_t particle, anchor;

    /// The shortest first; equal ones in an order that is always the same.
    bool operator<(const PinPath& other) const {
        if (length != other.length) return length < other.length;
        return particle != other.particle ? particle < other.particle : anchor < other.anchor;
    }
};

/// Updates ascending paths after particles were pinned or released; finds all if there are none. While there are at
/// most four pins, one that comes needs only its own search. Throws std::bad_alloc.
void update_pin_paths(Vector<PinPath>& paths, const RigidLinks& rigid, const Particles& particles);

/// Updates them after the edits of links, which the lists must have. Clears them if all have to be found again. Takes
/// O(links), mostly to copy the paths; where an edit changes the length of many, O(log n) for each of these. Throws
/// std::bad_alloc.
void repair_pin_paths(Vector<PinPath>& paths, const RigidLinks& rigid, const RigidLinks::Edit* first,
                      const RigidLinks::Edit* last);

}  // namespace gphys
