// The kernel of slot_set_kernels.h.
#include "scene/slot_set_kernels.h"

#include "bvh/compress_store.h"

namespace gphys::GPHYS_ISA {
namespace {

uint32_t list(const uint32_t* words, uint32_t word_count, const uint32_t* entries, uint32_t*& out,
              const uint32_t* end) {
    uint32_t* to = out;
    uint32_t word = 0;
    for (; word < word_count && end - to >= 32; ++word, entries += 32) {
        const uint32_t set = words[word];
        if (set == 0) continue;
        for (uint32_t first = 0; first < 32; first += 8) to += compress_store(to, entries + first, set >> first & 0xff);
    }
    out = to;
    return word;
}

}  // namespace

extern const SlotSetKernels slot_set_kernels{list};

}  // namespace gphys::GPHYS_ISA
