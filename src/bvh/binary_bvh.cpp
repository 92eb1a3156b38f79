// Splitting and joining of binary_bvh.h: recursively on one thread, or level by level with workers.
#include "bvh/binary_bvh.h"

#include "foundation/workers.h"

namespace gphys {
namespace {

/// A range of fewer items takes less time than waking a thread.
constexpr uint32_t parallel_size = 4096;
/// The ranges of these levels are split in parallel. The 64 subtrees under them keep up to a dozen threads about
/// equally busy.
constexpr int parallel_levels = 6;

/// Levels of inner nodes that halving needs.
uint32_t height_of_halves(uint32_t count) {
    uint32_t height = 0;
    for (; count > leaf_size; count -= count / 2) ++height;
    return height;
}

}  // namespace

BinaryBvh::BinaryBvh(Vector<BoxedItem>& items, uint32_t max_height, const Workers* workers)
    : items_(items.data()), slots_(items.size(), items.get_allocator()) {
    const Range whole{0, static_cast<uint32_t>(items.size()), max_height};
    const bool parallel = workers && workers->count() > 1 && whole.size() >= 2 * parallel_size;
    root_ = (parallel ? build_parallel(whole, *workers) : build_range(whole)).split_at;
}

/// Whether halving would keep max_height below any split.
bool BinaryBvh::may_split_by_cost(Range range) { return height_of_halves(range.size()) < range.max_height; }

/// Returns the first item of the second part.
uint32_t BinaryBvh::split(Range range) {
    BoxedItem *first = items_ + range.first, *last = items_ + range.last;
    BoxedItem* middle =
        may_split_by_cost(range) ? split_by_cost(first, last, &slots_[range.first].item) : split_by_count(first, last);
    return static_cast<uint32_t>(middle - items_);
}

BinaryBvh::Subtree BinaryBvh::leaf(const Box& box) {
    Subtree part{none, box, {}};
    std::fill(std::begin(part.cost), std::end(part.cost), half_area(box));
    return part;
}

/// Writes an inner node. Its slot is no longer used as scratch memory.
BinaryBvh::Subtree BinaryBvh::join(uint32_t split_at, const Subtree& low, const Subtree& high) {
    Subtree whole{split_at, low.box, {}};
    whole.box.include(high.box);
    Split& inner = slots_[split_at].split;
    inner = {{low.split_at, high.split_at}, 1 + std::max(height(low.split_at), height(high.split_at)), 0};
    // The cheapest distribution of so many wide nodes over the two children.
    const auto distribute = [&](uint32_t nodes, uint32_t& left_share) {
        double least = infinity;
        for (uint32_t first = 1; first < nodes; ++first) {
            const double cost = low.cost[first - 1] + high.cost[nodes - first - 1];
            if (cost < least) {
                least = cost;
                left_share = first;
            }
        }
        return least;
    };
    uint32_t left_share = 1;
    whole.cost[0] = half_area(whole.box) + distribute(8, left_share);
    inner.left_shares = left_share << 24;
    for (uint32_t nodes = 2; nodes < 8; ++nodes) {
        const double cost = distribute(nodes, left_share);
        if (!(cost < whole.cost[0])) left_share = 0;
        whole.cost[nodes - 1] = std::min(cost, whole.cost[0]);
        inner.left_shares |= left_share << (4 * (nodes - 2));
    }
    return whole;
}

BinaryBvh::Subtree BinaryBvh::build_range(Range range) {
    if (range.size() <= leaf_size) return leaf(union_of(items_ + range.first, items_ + range.last));
    const uint32_t split_at = split(range);
    const Subtree low = build_range({range.first, split_at, range.max_height - 1});
    const Subtree high = build_range({split_at, range.last, range.max_height - 1});
    return join(split_at, low, high);
}

BinaryBvh::Subtree BinaryBvh::build_parallel(Range whole, const Workers& workers) {
    // In the order of a binary heap: the children of i are 2 i and 2 i + 1. Ranges too small to split here have empty
    // ranges as children.
    constexpr uint32_t inner = 1u << parallel_levels;
    Range ranges[2 * inner];
    Subtree parts[2 * inner];
    ranges[1] = whole;
    const auto is_split_here = [&](uint32_t i) { return i < inner && ranges[i].size() >= parallel_size; };
    for (uint32_t level = 1; level < inner; level *= 2) {
        workers.run(level, [&](uint32_t index) {
            const uint32_t i = level + index;
            if (!is_split_here(i)) return;
            const uint32_t split_at = parts[i].split_at = split(ranges[i]);
            ranges[2 * i] = {ranges[i].first, split_at, ranges[i].max_height - 1};
            ranges[2 * i + 1] = {split_at, ranges[i].last, ranges[i].max_height - 1};
        });
    }
    workers.run(2 * inner - 1, [&](uint32_t index) {
        const uint32_t i = 1 + index;
        if (!is_split_here(i)) parts[i] = build_range(ranges[i]);
    });
    for (uint32_t i = inner; --i > 0;) {
        if (is_split_here(i)) parts[i] = join(parts[i].split_at, parts[2 * i], parts[2 * i + 1]);
    }
    return parts[1];
}

}  // namespace gphys
