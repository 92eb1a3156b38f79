// The contacts of a substep as the chains of cloth take them: the active contact plane of each particle, from models
// and animation targets, and the sums of the pulls of links. See ClothSurfaces.
#pragma once

#include "foundation/memory.h"

namespace gphys {

struct ChainContacts {
    explicit ChainContacts(std::pmr::memory_resource* memory) : normals(memory), pulls(memory) {}

    Vector<float> normals, pulls;  // four floats for each particle

    /// Throws std::bad_alloc.
    void reserve(size_t floats) {
        normals.resize(floats);
        pulls.resize(floats);
    }
};

}  // namespace gphys
