// The order in which the items of a batch are processed. If they come row by row, such as the pixels of an image or
// the beams of a lidar, they are grouped into square tiles: neighbours above and below are as coherent as those in a
// row. The row length is detected from the distances between items.
#pragma once

#include "foundation/floating_point.h"
#include "foundation/strided.h"

namespace gphys {

class ImageTiles {
public:
    static constexpr uint32_t most = 64;  // largest number of items of a tile

    /// The first `floats` floats of an item are its coordinates. Reads the items of the first row and a few others; a
    /// wrong guess costs time only. Without rows, a tile is a run of consecutive items.
    ImageTiles(const Strided<float>& items, uint32_t floats, uint32_t count);

    /// The number of tiles.
    uint32_t count() const;
    /// The items of a tile. Returns their number, which may be 0.
    uint32_t items(uint32_t tile, uint32_t* out) const;
    /// visit(items, size) for tiles begin .. end - 1, with fetch(item) before it for the items of the next tile: tiles
    /// read several streams, which the hardware prefetcher follows late.
    template <class Fetch, class Visit>
    void for_each(uint32_t begin, uint32_t end, const Fetch& fetch, const Visit& visit) const {
        if (begin == end) return;
        uint32_t lists[2][most], size = items(begin, lists[begin % 2]);
        for (uint32_t tile = begin; tile < end; ++tile) {
            uint32_t* const next = lists[(tile + 1) % 2];
            const uint32_t next_size = tile + 1 < count() ? items(tile + 1, next) : 0;
            for (uint32_t k = 0; k < next_size; ++k) fetch(next[k]);
            visit(lists[tile % 2], size);
            size = next_size;
        }
    }

private:
    uint32_t height() const { return most / width_; }

    uint32_t count_;  // of items
    uint32_t row_ = most, width_ = most;
    uint32_t in_band_ = 1;  // tiles side by side
};

}  // namespace gphys
