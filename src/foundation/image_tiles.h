// The order in which a batch is taken. Items that come row by row, as the pixels of an image or the beams of a lidar,
// are taken by tiles, as neighbours above and below have as much in common as those of a row.
#pragma once

#include "foundation/floating_point.h"
#include "foundation/strided.h"

namespace gphys {

class ImageTiles {
public:
    static constexpr uint32_t most = 64;  // items of a tile

    /// Items are near one another where so many floats are that they begin with. Those of the first row are looked at,
    /// and a few others; a wrong guess costs nothing but time. Without rows, a tile is the next in order.
    ImageTiles(const Strided<float>& items, uint32_t floats, uint32_t count);

    /// How many tiles there are.
    uint32_t count() const;
    /// The items of a tile; returns how many there are, maybe none.
    uint32_t items(uint32_t tile, uint32_t* out) const;
    /// visit(items, size) for tiles begin .. end - 1. Each time those of the tile after that are fetched before, by
    /// fetch(item): memory that is read in several places comes late.
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
    uint32_t in_band_ = 1;  // tiles beside one another
};

}  // namespace gphys
