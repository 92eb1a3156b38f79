// The effective inverse mass of cloth's particles that are joined to other bodies: the response of their systems, in
// place of the inverse mass in the chains of the cloth.
#pragma once

#include <algorithm>

#include "foundation/memory.h"

namespace gphys {

struct TetherInertia {
    explicit TetherInertia(std::pmr::memory_resource* memory) : diagonal(memory), off(memory) {}

    Vector<float> diagonal, off;  // symmetric matrices, see ClothTethers; empty unless the cloth is joined

    /// Throws std::bad_alloc.
    void reserve(size_t floats) {
        diagonal.resize(floats);
        off.resize(floats);
    }
    /// Whether a particle is not joined.
    bool is_unit(uint32_t particle) const {
        const float* const i = &diagonal[4 * size_t{particle}];
        return i[0] == 1 && i[1] == 1 && i[2] == 1;
    }
    /// Unit matrices: no particle is joined.
    void clear() {
        std::fill(diagonal.begin(), diagonal.end(), 1.0f);
        std::fill(off.begin(), off.end(), 0.0f);
    }
};

}  // namespace gphys
