#include "bvh/gradual_bvh.h"

namespace gphys {

namespace {

/// A smaller range is built at once, in some ten microseconds, which is so much work for each item.
constexpr uint32_t items_at_once = 256, work_per_item = 40;

}  // namespace

bool BinaryBvh::Gradual::advance(uint32_t& work) {
    while (open_count_ > 0 && work > 0) {
        OpenRange& open = open_[open_count_ - 1];
        const Range range = open.range;
        if (range.size() <= items_at_once) {
            work -= std::min(work, range.size() * work_per_item);
            close(bvh_.build_range(range));
            continue;
        }
        open.split_at = range.first + range.size() / 2;
        if (may_split_by_cost(range)) {
            BoxedItem* const items = bvh_.items_;
            if (!split_) split_.emplace(items + range.first, items + range.last, &bvh_.slots_[range.first].item);
            if (!split_->advance(work)) return false;
            // If all centres are one point, halves in any order are as good as others.
            if (split_->middle()) open.split_at = static_cast<uint32_t>(split_->middle() - items);
            split_.reset();
        }
        open_[open_count_] = {};
        open_[open_count_++].range = {range.first, open.split_at, range.max_height - 1};
    }
    return open_count_ == 0;
}

/// The last open range has become `subtree`. Closes the ranges that it completes, and opens the next.
void BinaryBvh::Gradual::close(Subtree subtree) {
    for (--open_count_; open_count_ > 0; --open_count_) {
        OpenRange& above = open_[open_count_ - 1];
        if (!above.has_low) {
            above.has_low = true;
            above.low = subtree;
            open_[open_count_] = {};
            open_[open_count_++].range = {above.split_at, above.range.last, above.range.max_height - 1};
            return;
        }
        subtree = bvh_.join(above.split_at, above.low, subtree);
    }
    bvh_.root_ = subtree.split_at;
}

}  // namespace gphys
