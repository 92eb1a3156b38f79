// The bins of the binned surface area heuristic (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies",
// 2007), with the three axes in the lanes of one register.
#pragma once

#include <algorithm>
#include <cstring>
#include <limits>

#include "bvh/sah.h"
#include "foundation/float4.h"

namespace gphys::sah {

// Lanes are the three axes; the fourth is unused and finite.
using Int4 = Mask4;

struct Box4 {
    // Empty: beyond all boxes, but with differences far from overflow.
    Float4 min = 0x1p60f;
    Float4 max = -0x1p60f;

    void include(const Box4& other) {
        min = minimum(min, other.min);
        max = maximum(max, other.max);
    }
};

inline Box4 load(const BoxedItem& item) {
    Box4 box;
    static_assert(sizeof(Box) == 6 * sizeof(float));
    std::memcpy(&box.min, item.box.min, sizeof box.min);
    // Loaded from one float earlier, since no float follows the box: (min z, max x, y, z) -> (max x, y, z, min z).
    std::memcpy(&box.max, &item.box.min[2], sizeof box.max);
    box.max = simd4::shuffle<1, 2, 3, 0>(box.max, box.max);
    return box;
}

inline Box narrow(const Box4& box) {
    return {{box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]}};
}

/// Twice the centre: the sum alone is enough for comparisons.
inline Float4 centre(const Box4& box) { return box.min + box.max; }
inline float centre(const Box& box, int axis) { return box.min[axis] + box.max[axis]; }

inline Box4 centres_of(const BoxedItem* first, const BoxedItem* last) {
    Box4 centres;
    for (const BoxedItem* item = first; item != last; ++item) {
        const Float4 c = centre(load(*item));
        centres.include({c, c});
    }
    return centres;
}

constexpr int bin_count = 16;

/// Counts and boxes of the items, by the position of their centres along each axis.
class Bins {
public:
    explicit Bins(const Box4& centres) : low_(centres.min) {
        const Float4 extent = centres.max - centres.min;
        float scale[4] = {};
        for (int k = 0; k < 3; ++k) {
            // Smaller extents would overflow the scale; the items count as equal on this axis.
            if (extent[k] > 1e-30f) scale[k] = bin_count * (1 - 0x1p-20f) / extent[k];
        }
        scale_ = simd4::load_register(scale);
    }

    void add(const Box4& box) {
        const Float4 places = integer_bits((centre(box) - low_) * scale_);
        int32_t place[4];
        std::memcpy(place, &places, sizeof place);
        for (int k = 0; k < 3; ++k) {
            boxes_[place[k]][k].include(box);
            ++counts_[place[k]][k];
        }
    }

    /// Finds the cheapest split between two bins. False if all centres are one point. On an axis with extent, the first
    /// and the last bin have items, so no part is empty.
    bool choose() {
        const Float4 unit = unit_of_size();
        const Int4 none = mask4(0, 0, 0, 0);
        Float4 cost_above[bin_count];  // of the bins from i on
        Box4 part[3];
        Int4 count = none;
        const auto add_bin = [&](int i) {
            for (int k = 0; k < 3; ++k) part[k].include(boxes_[i][k]);
            Int4 added;
            std::memcpy(&added, counts_[i], sizeof added);
            count = add_integers(count, added);
        };
        for (int i = bin_count; --i > 0;) {
            add_bin(i);
            cost_above[i] = cost(part, count, unit);
        }
        for (Box4& box : part) box = Box4();
        count = none;
        Float4 least = std::numeric_limits<float>::max(), split_at = 0.0f;
        for (int i = 1; i < bin_count; ++i) {
            add_bin(i - 1);
            const Float4 both = cost(part, count, unit) + cost_above[i];
            const Mask4 better = both < least;
            least = simd4::choose(better, both, least);
            split_at = simd4::choose(better, static_cast<float>(i), split_at);
        }
        axis_ = -1;
        for (int k = 0; k < 3; ++k) {
            if (scale_[k] != 0 && (axis_ < 0 || least[k] < least[axis_])) axis_ = k;
        }
        if (axis_ < 0) return false;
        split_at_ = split_at[axis_];
        return true;
    }

    /// Whether an item is in the first part. The same arithmetic as in add.
    bool below(const Box& box) const { return (centre(box, axis_) - low_[axis_]) * scale_[axis_] < split_at_; }

private:
    /// 1 / the largest extent of all items: scaled by it, no area overflows or vanishes.
    Float4 unit_of_size() const {
        Box4 whole;
        for (const auto& box : boxes_) whole.include(box[0]);
        const Float4 extent = whole.max - whole.min;
        const float largest = std::max({extent[0], extent[1], extent[2]});
        return largest > 1e-30f ? 1 / largest : 0.0f;
    }

    /// For each axis, in its lane: half area of the part, times its number of leaves.
    ///     cost[axis] = half_area(part[axis]) * ((count[axis] + 7) / 8)
    static Float4 cost(const Box4 part[3], Mask4 count, Float4 unit) {
        Float4 extent[3];
        // An empty part has negative extents.
        for (int k = 0; k < 3; ++k) extent[k] = maximum(part[k].max - part[k].min, Float4{}) * unit;
        // From one register per axis to one register per coordinate.
        Float4 v[4] = {extent[0], extent[1], extent[2], extent[2]};
        transpose(v);
        const Float4 x = v[0], y = v[1], z = v[2];
        constexpr int less = static_cast<int>(leaf_size) - 1;
        static_assert(leaf_size == 1u << 3);
        const Int4 blocks = simd4::shift_right<3>(add_integers(count, mask4(less, less, less, less)));
        return (x * y + y * z + z * x) * to_floats(blocks);
    }

    Float4 low_, scale_;
    int axis_ = -1;
    float split_at_ = 0;
    Box4 boxes_[bin_count][3];
    int32_t counts_[bin_count][4] = {};
};

}  // namespace gphys::sah
