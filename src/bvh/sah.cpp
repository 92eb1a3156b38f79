// Binned surface area heuristic (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007), with the
// three axes in the lanes of one register. Exact sorting instead of bins is used only for few items (split_few).
#include "bvh/sah.h"

#include <cstring>
#include <limits>

#include "foundation/float4.h"

namespace gphys {

namespace {

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

Box4 load(const BoxedItem& item) {
    Box4 box;
    static_assert(sizeof(Box) == 6 * sizeof(float));
    std::memcpy(&box.min, item.box.min, sizeof box.min);
    // Loaded from one float earlier, since no float follows the box: (min z, max x, y, z) -> (max x, y, z, min z).
    std::memcpy(&box.max, &item.box.min[2], sizeof box.max);
    box.max = simd4::shuffle<1, 2, 3, 0>(box.max, box.max);
    return box;
}

Box narrow(const Box4& box) { return {{box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]}}; }

/// Twice the centre: the sum alone is enough for comparisons.
Float4 centre(const Box4& box) { return box.min + box.max; }
float centre(const Box& box, int axis) { return box.min[axis] + box.max[axis]; }

Box4 centres_of(const BoxedItem* first, const BoxedItem* last) {
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

/// rank[i]: the position of values[i] in ascending order; stable. All are compared with all, without unpredictable
/// branches.
void rank_all(const float* values, int count, int* rank) {
    for (int i = 0; i < count; ++i) {
        int below = 0;
        for (int k = 0; k < i; ++k) below += values[k] <= values[i];
        for (int k = i + 1; k < count; ++k) below += values[k] < values[i];
        rank[i] = below;
    }
}

}  // namespace

Box union_of(const BoxedItem* first, const BoxedItem* last) {
    Box4 box;
    for (const BoxedItem* item = first; item != last; ++item) box.include(load(*item));
    return narrow(box);
}

BoxedItem* split_by_cost(BoxedItem* first, BoxedItem* last, BoxedItem* scratch) {
    Bins bins(centres_of(first, last));
    for (const BoxedItem* item = first; item != last; ++item) bins.add(load(*item));
    if (!bins.choose()) return split_by_count(first, last);
    // Each item is written to both parts, and one of the two ends advances: no unpredictable branch.
    BoxedItem *kept = first, *above = scratch;
    for (const BoxedItem* item = first; item != last; ++item) {
        const bool below = bins.below(item->box);
        // Moved by registers: single members would stall on store forwarding.
        Float4 moving[2];
        static_assert(sizeof(BoxedItem) == sizeof moving);
        std::memcpy(moving, item, sizeof moving);
        std::memcpy(kept, moving, sizeof moving);
        std::memcpy(above, moving, sizeof moving);
        kept += below;
        above += !below;
    }
    std::copy(scratch, above, kept);
    return kept;
}

BoxedItem* split_few(BoxedItem* first, BoxedItem* last, uint64_t splits, int block) {
    const int count = static_cast<int>(last - first);
    int order[3][split_few_size];
    double least = infinity;
    int best_axis = 0, best_split = 0;
    const auto allowed = [splits](int split_at) { return (splits >> split_at & 1) != 0; };
    const auto blocks = [block](int n) { return (n + block - 1) / block; };
    for (int axis = 0; axis < 3; ++axis) {
        float centres[split_few_size];
        int rank[split_few_size];
        for (int i = 0; i < count; ++i) centres[i] = centre(first[i].box, axis);
        rank_all(centres, count, rank);
        int* places = order[axis];
        for (int i = 0; i < count; ++i) places[rank[i]] = i;
        double cost_above[split_few_size];
        Box4 box;
        for (int split_at = count; split_at-- > 1;) {
            box.include(load(first[places[split_at]]));
            if (allowed(split_at)) cost_above[split_at] = half_area(narrow(box)) * blocks(count - split_at);
        }
        box = Box4();
        for (int split_at = 1; split_at < count; ++split_at) {
            box.include(load(first[places[split_at - 1]]));
            if (!allowed(split_at)) continue;
            const double cost = half_area(narrow(box)) * blocks(split_at) + cost_above[split_at];
            if (cost < least) {
                least = cost;
                best_axis = axis;
                best_split = split_at;
            }
        }
    }
    BoxedItem sorted[split_few_size];
    for (int i = 0; i < count; ++i) sorted[i] = first[order[best_axis][i]];
    std::copy(sorted, sorted + count, first);
    return first + best_split;
}

BoxedItem* split_by_count(BoxedItem* first, BoxedItem* last) {
    const Box4 centres = centres_of(first, last);
    const Float4 extent = centres.max - centres.min;
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
        if (extent[k] > extent[axis]) axis = k;
    }
    BoxedItem* middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [axis](const BoxedItem& a, const BoxedItem& b) {
        const float ca = centre(a.box, axis), cb = centre(b.box, axis);
        return ca < cb || (ca == cb && a.item < b.item);
    });
    return middle;
}

}  // namespace gphys
