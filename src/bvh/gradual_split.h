// A split of items by the surface area heuristic that can be made in several calls, each of bounded cost: a scene of a
// million models must not wait for one pass over all of them.
#pragma once

#include <optional>

#include "bvh/sah_bins.h"

namespace gphys {

class GradualSplit {
public:
    /// `scratch` has room for all but one of the items; the order within each part stays.
    GradualSplit(BoxedItem* first, BoxedItem* last, BoxedItem* scratch)
        : first_(first), last_(last), scratch_(scratch), next_(first) {}

    /// Go on for as many items, and take those done from `work`. True: the cut is made. Each item is passed up to
    /// four times.
    bool advance(uint32_t& work) {
        while (stage_ != Stage::done && work > 0) {
            const auto count = std::min(work, static_cast<uint32_t>(source_end() - next_));
            work -= count;
            BoxedItem* const end = next_ + count;
            pass_to(end);
            if (next_ == source_end()) enter_next_stage();
        }
        return stage_ == Stage::done;
    }
    /// Where the second part begins; null: all centres are one point.
    BoxedItem* middle() const { return kept_; }

private:
    enum class Stage { centres, bins, partition, copy, done };

    BoxedItem* source_end() const { return stage_ == Stage::copy ? above_ : last_; }

    void pass_to(BoxedItem* end) {
        switch (stage_) {
            case Stage::centres:
                centres_.include(sah::centres_of(next_, end));
                next_ = end;
                break;
            case Stage::bins:
                for (; next_ != end; ++next_) bins_->add(sah::load(*next_));
                break;
            case Stage::partition:
                partition_to(end);
                break;
            case Stage::copy:
                copied_ = std::copy(next_, end, copied_);
                next_ = end;
                break;
            case Stage::done:
                break;
        }
    }

    /// Every item is written to both places, and one of them is kept: no unpredictable branch.
    void partition_to(BoxedItem* end) {
        const sah::Bins& bins = *bins_;
        BoxedItem *kept = kept_, *above = above_;
        for (BoxedItem* item = next_; item != end; ++item) {
            const bool below = bins.below(item->box);
            // In registers: member by member it would wait for its own stores.
            Float4 moving[2];
            static_assert(sizeof(BoxedItem) == sizeof moving);
            std::memcpy(moving, item, sizeof moving);
            std::memcpy(kept, moving, sizeof moving);
            std::memcpy(above, moving, sizeof moving);
            kept += below;
            above += !below;
        }
        next_ = end;
        kept_ = kept;
        above_ = above;
    }

    void enter_next_stage() {
        next_ = first_;
        switch (stage_) {
            case Stage::centres:
                bins_.emplace(centres_);
                stage_ = Stage::bins;
                break;
            case Stage::bins:
                if (!bins_->choose()) {
                    stage_ = Stage::done;
                    break;
                }
                kept_ = first_;
                above_ = scratch_;
                stage_ = Stage::partition;
                break;
            case Stage::partition:
                copied_ = kept_;
                next_ = scratch_;
                stage_ = Stage::copy;
                break;
            default:
                stage_ = Stage::done;
                break;
        }
    }

    BoxedItem *first_, *last_, *scratch_, *next_;
    BoxedItem *kept_ = nullptr, *above_ = nullptr, *copied_ = nullptr;
    Stage stage_ = Stage::centres;
    sah::Box4 centres_;
    std::optional<sah::Bins> bins_;
};

}  // namespace gphys
