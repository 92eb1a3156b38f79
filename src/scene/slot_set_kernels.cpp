// The kernel of slot_set_kernels.h.
#include "scene/slot_set_kernels.h"

#include "bvh/compress_store.h"

namespace gphys::GPHYS_ISA {

namespace {

uint32_t* list(const uint32_t* words, uint32_t word_count, const uint32_t* entries, uint32_t* out) {
    for (uint32_t word = 0; word < word_count; ++word, entries += 32) {
        const uint32_t set = words[word];
        if (set == 0) continue;
        for (uint32_t first = 0; first < 32; first += 8)
            out += compress_store(out, entries + first, set >> first & 0xff);
    }
    return out;
}

}  // namespace

extern const SlotSetKernels slot_set_kernels{list};

}  // namespace gphys::GPHYS_ISA
