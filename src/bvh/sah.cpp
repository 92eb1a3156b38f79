// Binned surface area heuristic (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007), with the
// three axes in the lanes of one register. Exact sorting instead of bins is used only for few items (split_few).
#include "bvh/sah.h"

#include "bvh/gradual_split.h"

namespace gphys {
namespace {

using sah::Box4, sah::centre, sah::centres_of, sah::load, sah::narrow;

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
    GradualSplit split(first, last, scratch);
    for (uint32_t work = 0; !split.advance(work);) work = std::numeric_limits<uint32_t>::max();
    return split.middle() ? split.middle() : split_by_count(first, last);
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
