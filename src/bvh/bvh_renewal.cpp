// The stages of a renewal, and when the tree begins and ends one.
#include "bvh/bvh_renewal.h"

#include <limits>

#include "foundation/compiler.h"

namespace gphys {

namespace {

/// The nodes of so many items are written at once.
constexpr uint32_t items_at_once = 256;
constexpr uint32_t work_per_written_item = 16, work_per_collected_item = 24, work_per_unmapping = 8192;

}  // namespace

Bvh8::Renewal::Renewal(const Bvh8& tree, pages::HugePages huge)
    : next(tree, Replacement()),
      memory_(tree.nodes_.memory(), tree.nodes_.may_map()),
      limit_(static_cast<uint32_t>(tree.item_lane_.size())),
      items_(&memory_),
      marked_(&memory_),
      changed_(&memory_) {
    items_.reserve(tree.size_);
    // Room that was reserved is kept.
    next.nodes_.reserve(tree.nodes_.capacity(), huge);
    next.item_lane_.reserve(tree.item_lane_.capacity(), huge);
    marked_.reserve(tree.item_lane_.capacity());
}

bool Bvh8::Renewal::mark(uint32_t item) {
    if (is_discarded() || is_marked(item)) return false;
    if (item >= marked_.size()) {
        reserve_more(marked_, item + size_t{1} - marked_.size());
        marked_.resize(size_t{item} + 1, 0);
    }
    reserve_more(changed_, 1);
    changed_.push_back(item);
    marked_[item] = 1;
    return true;
}

bool Bvh8::Renewal::advance(const Bvh8& tree, uint32_t& work) {
    while (work > 0 && stage_ != Stage::done) {
        switch (stage_) {
            case Stage::collect:
                collect(tree, work);
                break;
            case Stage::split:
                if (!binary_) binary_.emplace(items_, 3 * (max_built_levels - 1));
                if (binary_->advance(work)) stage_ = Stage::write;
                break;
            case Stage::write:
                write(work);
                break;
            case Stage::replay:
                replay(tree, work);
                break;
            default:
                break;
        }
    }
    return stage_ == Stage::done;
}

void Bvh8::Renewal::discard() noexcept {
    stage_ = Stage::discarded;
    next.nodes_.discard_to(memory_);
    next.item_lane_.discard_to(memory_);
    Vector<uint8_t>(&memory_).swap(marked_);
    Vector<uint32_t>(&memory_).swap(changed_);
}

bool Bvh8::Renewal::release(uint32_t& work) noexcept {
    while (memory_.unmap_part()) {
        if (work <= work_per_unmapping) {
            work = 0;
            return false;
        }
        work -= work_per_unmapping;
    }
    return true;
}

/// By number, because the tree changes between the calls. Marked items are left to the replay, so there are at most as
/// many as at first.
void Bvh8::Renewal::collect(const Bvh8& tree, uint32_t& work) {
    constexpr uint32_t block = 64;
    while (work > 0 && collected_ < limit_) {
        const uint32_t end = std::min(limit_, collected_ + block);
        for (uint32_t item = collected_; item < end; ++item) {
            if (tree.contains(item)) prefetch(&tree.node_of(item).boxes.row[0][tree.item_lane_[item] % 8]);
        }
        for (uint32_t item = collected_; item < end; ++item) {
            if (!tree.contains(item) || is_marked(item)) continue;
            items_.push_back({tree.box(item), item});
            bounds_.include(items_.back().box);
        }
        work -= std::min(work, (end - collected_) * work_per_collected_item);
        collected_ = end;
        next.item_lane_.resize(end, none);
    }
    if (collected_ == limit_) stage_ = items_.empty() ? Stage::replay : Stage::split;
}

/// Writes the nodes in depth-first order.
void Bvh8::Renewal::write(uint32_t& work) {
    if (open_count_ == 0) {
        const Builder::Range whole = Builder(items_, binary_->bvh()).all();
        if (whole.size() <= items_at_once) return finish_writing(write_at_once(whole, max_built_levels));
        open(whole);
    }
    while (work > 0) {
        Open& node = open_[open_count_ - 1];
        if (node.child < node.count) {
            const Builder::Range& range = node.ranges[node.child];
            if (range.size() > items_at_once) {
                open(range);
                continue;
            }
            work -= std::min(work, range.size() * work_per_written_item);
            Builder::set_child(next.nodes_.data(), node.index, node.child++,
                               write_at_once(range, max_built_levels - open_count_), node.built);
            continue;
        }
        const Builder::BuiltSubtree built = node.built;
        if (--open_count_ == 0) return finish_writing(built);
        Open& above = open_[open_count_ - 1];
        Builder::set_child(next.nodes_.data(), above.index, above.child++, built, above.built);
    }
}

Bvh8::Builder::BuiltSubtree Bvh8::Renewal::write_at_once(const Builder::Range& range, uint32_t levels) {
    const Builder builder(items_, binary_->bvh());
    reserve_more(next.nodes_, builder.count_nodes(range, levels));
    return builder.write(range, levels, next.nodes_.data(), next.item_lane_.data(), half_area(bounds_),
                         [&] { return index_of(next.allocate_node(false)); });
}

void Bvh8::Renewal::open(const Builder::Range& range) {
    const Builder builder(items_, binary_->bvh());
    reserve_more(next.nodes_, 1);
    Open& node = open_[open_count_++];
    node.index = next.allocate_node(false);
    node.count = next.nodes_[node.index].count = builder.divide(range, max_built_levels - open_count_, node.ranges);
    node.child = 0;
    node.built = {};
    node.built.ref = node.index;
}

void Bvh8::Renewal::finish_writing(const Builder::BuiltSubtree& built) {
    next.nodes_[index_of(built.ref)].parent = none;
    next.root_ = built.ref;
    next.size_ = static_cast<uint32_t>(items_.size());
    next.bounds_ = built.box;
    next.built_root_area_ = half_area(built.box);
    next.built_area_ = next.built_root_area_ + built.area;
    binary_.reset();
    Vector<BoxedItem>(items_.get_allocator()).swap(items_);
    stage_ = Stage::replay;
}

void Bvh8::Renewal::replay(const Bvh8& tree, uint32_t& work) {
    while (!changed_.empty() && work > 0) {
        work -= std::min(work, work_per_replay);
        const uint32_t item = changed_.back();
        const bool was = next.contains(item), is = tree.contains(item);
        if (is && !was) next.insert(item, tree.box(item));
        if (is && was) next.update(item, tree.box(item));
        if (!is && was) next.remove(item);
        changed_.pop_back();
        marked_[item] = 0;
    }
    if (changed_.empty()) stage_ = Stage::done;
}

/// After a change of an item, does the part of a renewal that this change pays for.
void Bvh8::renew_gradually(uint32_t item, Change change) noexcept {
    // Additions and removals of a quarter of the items pay for a renewal. A move pays for its replay and little more:
    // moves are cheap and frequent.
    constexpr uint32_t work_per_addition = 4 * Renewal::work_per_item, work_per_move = 16;
    // Some ten microseconds: less would spend its time on cache misses.
    constexpr uint32_t least_work = 4096;
    try {
        if (!renewal_) {
            if (is_worn(items_per_addition)) begin_renewal(pages::HugePages::later);
            return;
        }
        const bool is_new = renewal_->mark(item);
        paid_work_ += change == Change::move ? work_per_move : work_per_addition;
        if (is_new) paid_work_ += Renewal::work_per_replay;
        if (paid_work_ < least_work) return;
        uint32_t work = paid_work_;
        paid_work_ = 0;
        advance_renewal(work);
    } catch (const std::bad_alloc&) {
        // The tree is valid without the renewal. The next one begins as if this one had been completed.
        cancel_renewal();
        added_ = 0;
    }
}

bool Bvh8::maintain(uint32_t items) {
    // One that began while items were still inserted leaves the last of them to the next.
    constexpr uint32_t items_per_leftover = 64;
    try {
        for (uint64_t left = uint64_t{items} * Renewal::work_per_item;;) {
            if (!renewal_) {
                if (!is_worn(items_per_leftover)) return true;
                begin_renewal(pages::HugePages::at_once);
            }
            if (left == 0) return false;
            const auto share = static_cast<uint32_t>(std::min<uint64_t>(left, std::numeric_limits<uint32_t>::max()));
            uint32_t work = share;
            advance_renewal(work);
            left -= share - work;
        }
    } catch (...) {
        cancel_renewal();
        throw;
    }
}

void Bvh8::begin_renewal(pages::HugePages huge) {
    std::pmr::polymorphic_allocator<Renewal> memory(nodes_.memory());
    Renewal* const renewal = memory.allocate(1);
    try {
        renewal_ = new (renewal) Renewal(*this, huge);
    } catch (...) {
        memory.deallocate(renewal, 1);
        throw;
    }
    paid_work_ = 0;
}

void Bvh8::advance_renewal(uint32_t& work) {
    if (!renewal_->is_discarded() && renewal_->advance(*this, work)) finish_renewal();
    if (renewal_->is_discarded() && renewal_->release(work)) cancel_renewal();
}

void Bvh8::cancel_renewal() noexcept {
    if (!renewal_) return;
    renewal_->~Renewal();
    std::pmr::polymorphic_allocator<Renewal>(nodes_.memory()).deallocate(renewal_, 1);
    renewal_ = nullptr;
}

void Bvh8::finish_renewal() noexcept {
    Bvh8& next = renewal_->next;
    nodes_.swap(next.nodes_);
    item_lane_.swap(next.item_lane_);
    root_ = next.root_;
    bounds_ = next.bounds_;
    size_ = next.size_;
    first_free_ = next.first_free_;
    free_count_ = next.free_count_;
    added_ = next.added_;
    built_area_ = next.built_area_;
    built_root_area_ = next.built_root_area_;
    renewal_->discard();
}

}  // namespace gphys
