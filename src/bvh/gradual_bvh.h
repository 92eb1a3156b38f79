// A binary BVH that is built in several calls, each of bounded cost: it splits depth first, with a stack of its own.
#pragma once

#include <optional>

#include "bvh/binary_bvh.h"
#include "bvh/gradual_split.h"

namespace gphys {

class BinaryBvh::Gradual {
public:
    /// As BinaryBvh. Sorts the items, which must stay where they are.
    Gradual(Vector<BoxedItem>& items, uint32_t max_height) : bvh_(items) {
        open_[0].range = {0, static_cast<uint32_t>(items.size()), max_height};
        open_count_ = items.empty() ? 0 : 1;
    }

    /// Works until `work`, in units of GradualSplit, is used up. True: the BVH is complete.
    bool advance(uint32_t& work);
    const BinaryBvh& bvh() const { return bvh_; }

private:
    /// A range that is to be split, or whose parts are.
    struct OpenRange {
        Range range;
        uint32_t split_at = none;
        bool has_low = false;
        Subtree low;
    };
    static constexpr uint32_t max_open = 96;

    void close(Subtree subtree);

    BinaryBvh bvh_;
    OpenRange open_[max_open];
    uint32_t open_count_;
    std::optional<GradualSplit> split_;  // of the last open range
};

}  // namespace gphys
