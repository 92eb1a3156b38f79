// Replaces a tree by a new one of the same items, which is built aside while the old one is in use and changes. Each
// call does a bounded part of the work, so no change of a scene waits for a build of all (global rebuilding: Overmars,
// "The Design of Dynamic Data Structures", 1983, chapter 5). Items are collected by number, split and written as by a
// build of all. Items that change meanwhile are marked, and brought up to date in the new tree at the end (replay).
// After the exchange the memory of the old tree and of the renewal is given back, a part in each call.
//
// Rebuilding in place instead would keep the upper levels as insertion made them: treelets of nodes, put together by
// the SAH, made trees two to three times as costly, because leaves exchange no items.
#pragma once

#include <optional>

#include "bvh/bvh_builder.h"
#include "bvh/gradual_bvh.h"

namespace gphys {

class Bvh8::Renewal {
public:
    // In units of GradualSplit: an item read in sequence, some 3 ns.
    static constexpr uint32_t work_per_item = 128;    // of a whole renewal
    static constexpr uint32_t work_per_replay = 256;  // of a changed item

    Renewal(const Bvh8& tree, pages::HugePages huge);

    /// Call when an item of the tree was inserted, removed or got another box. False: it was marked already.
    bool mark(uint32_t item);
    /// Works until `work` is used up. True: `next` is complete.
    bool advance(const Bvh8& tree, uint32_t& work);
    /// Call when `next` has been exchanged for the tree's own nodes. From then on release() frees all memory.
    void discard() noexcept;
    bool is_discarded() const { return stage_ == Stage::discarded; }
    /// True: all memory is free.
    bool release(uint32_t& work) noexcept;

    Bvh8 next;

private:
    enum class Stage { collect, split, write, replay, done, discarded };

    /// A node whose children are not all written, and their ranges.
    struct Open {
        Builder::Range ranges[8];
        uint32_t count, child, index;
        Builder::BuiltSubtree built;
    };

    bool is_marked(uint32_t item) const { return item < marked_.size() && marked_[item] != 0; }
    void collect(const Bvh8& tree, uint32_t& work);
    void write(uint32_t& work);
    Builder::BuiltSubtree write_at_once(const Builder::Range& range, uint32_t levels);
    void open(const Builder::Range& range);
    void finish_writing(const Builder::BuiltSubtree& built);
    void replay(const Bvh8& tree, uint32_t& work);

    GradualMemory memory_;  // of what follows

    Stage stage_ = Stage::collect;
    uint32_t collected_ = 0, limit_;  // numbers of items
    Vector<BoxedItem> items_;
    std::optional<BinaryBvh::Gradual> binary_;
    Box bounds_;
    Open open_[max_built_levels];
    uint32_t open_count_ = 0;
    Vector<uint8_t> marked_;  // by item
    Vector<uint32_t> changed_;
};

}  // namespace gphys
