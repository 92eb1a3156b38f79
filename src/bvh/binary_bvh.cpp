#include "bvh/binary_bvh.h"

#include "foundation/workers.h"

namespace gphys {

namespace {

/// Ranges of fewer items are not worth a thread's way to them.
constexpr uint32_t shared_size = 4096;
/// Levels of cuts whose ranges are shared one by one: 64 parts below them keep up to a dozen threads
/// about equally busy to the end.
constexpr int shared_levels = 6;

/// Levels that halving takes down to leaves.
uint32_t height_of_halves(uint32_t count) {
    uint32_t height = 0;
    for (; count > leaf_size; count -= count / 2) ++height;
    return height;
}

}  // namespace

BinaryBvh::BinaryBvh(Vector<BoxedItem>& items, uint32_t max_height, const Workers* workers)
    : items_(items.data()), slots_(items.size(), items.get_allocator()) {
    const Range whole{0, static_cast<uint32_t>(items.size()), max_height};
    const bool share = workers && workers->count() > 1 && whole.size() >= 2 * shared_size;
    root_ = (share ? cut_shared(whole, *workers) : cut_all(whole)).cut;
}

/// Where the second part begins. By cost as long as halves would still fit below.
uint32_t BinaryBvh::split(Range range) {
    BoxedItem *first = items_ + range.first, *last = items_ + range.last;
    const bool by_cost = height_of_halves(range.size()) < range.max_height;
    BoxedItem* middle = by_cost ? split_by_cost(first, last, &slots_[range.first].item) : split_by_count(first, last);
    return static_cast<uint32_t>(middle - items_);
}

BinaryBvh::Part BinaryBvh::leaf(const Box& box) {
    Part part{none, box, {}};
    std::fill(std::begin(part.cost), std::end(part.cost), half_area(box));
    return part;
}

/// Note a cut, when nobody below needs its slot any more.
BinaryBvh::Part BinaryBvh::join(uint32_t cut, const Part& low, const Part& high) {
    Part whole{cut, low.box, {}};
    whole.box.include(high.box);
    Cut& noted = slots_[cut].cut;
    noted = {{low.cut, high.cut}, 1 + std::max(height(low.cut), height(high.cut)), 0};
    // The cheapest way to share so many nodes among the halves.
    const auto divide = [&](uint32_t nodes, uint32_t& share) {
        double least = infinity;
        for (uint32_t first = 1; first < nodes; ++first) {
            const double cost = low.cost[first - 1] + high.cost[nodes - first - 1];
            if (cost < least) {
                least = cost;
                share = first;
            }
        }
        return least;
    };
    uint32_t share = 1;
    whole.cost[0] = half_area(whole.box) + divide(8, share);
    noted.shares = share << 24;
    for (uint32_t nodes = 2; nodes < 8; ++nodes) {
        const double cost = divide(nodes, share);
        if (!(cost < whole.cost[0])) share = 0;
        whole.cost[nodes - 1] = std::min(cost, whole.cost[0]);
        noted.shares |= share << (4 * (nodes - 2));
    }
    return whole;
}

BinaryBvh::Part BinaryBvh::cut_all(Range range) {
    if (range.size() <= leaf_size) return leaf(union_of(items_ + range.first, items_ + range.last));
    const uint32_t cut = split(range);
    const Part low = cut_all({range.first, cut, range.max_height - 1});
    const Part high = cut_all({cut, range.last, range.max_height - 1});
    return join(cut, low, high);
}

BinaryBvh::Part BinaryBvh::cut_shared(Range whole, const Workers& workers) {
    // As in a heap, the parts of i are 2 i and 2 i + 1. What is not cut here has empty ranges below.
    constexpr uint32_t inner = 1u << shared_levels;
    Range ranges[2 * inner];
    Part parts[2 * inner];
    ranges[1] = whole;
    const auto cut_here = [&](uint32_t i) { return i < inner && ranges[i].size() >= shared_size; };
    for (uint32_t level = 1; level < inner; level *= 2) {
        workers.run(level, [&](uint32_t index) {
            const uint32_t i = level + index;
            if (!cut_here(i)) return;
            const uint32_t cut = parts[i].cut = split(ranges[i]);
            ranges[2 * i] = {ranges[i].first, cut, ranges[i].max_height - 1};
            ranges[2 * i + 1] = {cut, ranges[i].last, ranges[i].max_height - 1};
        });
    }
    workers.run(2 * inner - 1, [&](uint32_t index) {
        const uint32_t i = 1 + index;
        if (!cut_here(i)) parts[i] = cut_all(ranges[i]);
    });
    for (uint32_t i = inner; --i > 0;) {
        if (cut_here(i)) parts[i] = join(parts[i].cut, parts[2 * i], parts[2 * i + 1]);
    }
    return parts[1];
}

}  // namespace gphys
