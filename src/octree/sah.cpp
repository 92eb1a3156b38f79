// Binned surface area heuristic (Wald, "On fast Construction of SAH-based Bounding Volume
// Hierarchies", 2007).
#include "octree/sah.h"

namespace gphys {

namespace {

constexpr int bin_count = 16;

/// Twice the centre: a sum needs no rounding of its own to be monotone.
float centre(const Box& box, int axis) { return box.min[axis] + box.max[axis]; }

/// Expected tests in a part: a leaf tests eight boxes at the price of one.
double blocks(size_t count) { return static_cast<double>((count + leaf_size - 1) / leaf_size); }

/// Items counted by the position of their centres along one axis.
class Bins {
public:
    Bins() = default;
    Bins(float low, float high, int axis) : axis_(axis), low_(low) {
        // Below this the scale would leave the range of float; the items are as good as equal.
        const float extent = high - low;
        if (extent > 1e-30f) scale_ = bin_count * (1 - 0x1p-20f) / extent;
    }

    int index(const Box& box) const { return static_cast<int>((centre(box, axis_) - low_) * scale_); }

    void add(const Box& box) {
        const int i = index(box);
        boxes_[i].include(box);
        ++counts_[i];
    }

    /// Lower `least` if a cut between two bins costs less.
    void best(double& least, int& axis, int& cut, int k) const {
        if (scale_ == 0) return;
        double cost_above[bin_count];  // of all bins from i on
        Box box;
        size_t count = 0;
        for (int i = bin_count - 1; i > 0; --i) {
            box.include(boxes_[i]);
            count += counts_[i];
            cost_above[i] = count == 0 ? -1 : half_area(box) * blocks(count);
        }
        box = Box();
        count = 0;
        for (int i = 1; i < bin_count; ++i) {
            box.include(boxes_[i - 1]);
            count += counts_[i - 1];
            if (count == 0 || cost_above[i] < 0) continue;
            const double cost = half_area(box) * blocks(count) + cost_above[i];
            if (cost < least) {
                least = cost;
                axis = k;
                cut = i;
            }
        }
    }

private:
    int axis_ = 0;
    float low_ = 0, scale_ = 0;
    Box boxes_[bin_count];
    size_t counts_[bin_count] = {};
};

Box centres_of(const BoxedItem* first, const BoxedItem* last) {
    Box centres;
    for (const BoxedItem* item = first; item != last; ++item) {
        for (int k = 0; k < 3; ++k) {
            centres.min[k] = std::min(centres.min[k], centre(item->box, k));
            centres.max[k] = std::max(centres.max[k], centre(item->box, k));
        }
    }
    return centres;
}

BoxedItem* halve(BoxedItem* first, BoxedItem* last, const Box& centres) {
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
        if (centres.max[k] - centres.min[k] > centres.max[axis] - centres.min[axis]) axis = k;
    }
    BoxedItem* middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [axis](const BoxedItem& a, const BoxedItem& b) {
        const float ca = centre(a.box, axis), cb = centre(b.box, axis);
        return ca < cb || (ca == cb && a.item < b.item);
    });
    return middle;
}

}  // namespace

double half_area(const Box& box) {
    if (box.min[0] > box.max[0]) return 0;
    const double x = double{box.max[0]} - box.min[0], y = double{box.max[1]} - box.min[1],
                 z = double{box.max[2]} - box.min[2];
    return x * y + y * z + z * x;
}

Box union_of(const BoxedItem* first, const BoxedItem* last) {
    Box box;
    for (const BoxedItem* item = first; item != last; ++item) box.include(item->box);
    return box;
}

BoxedItem* split_by_cost(BoxedItem* first, BoxedItem* last) {
    const Box centres = centres_of(first, last);
    Bins bins[3];
    for (int k = 0; k < 3; ++k) bins[k] = Bins(centres.min[k], centres.max[k], k);
    for (const BoxedItem* item = first; item != last; ++item) {
        for (Bins& b : bins) b.add(item->box);
    }
    double least = infinity;
    int axis = 0, cut = 0;
    for (int k = 0; k < 3; ++k) bins[k].best(least, axis, cut, k);
    if (cut == 0) return halve(first, last, centres);
    const Bins& chosen = bins[axis];
    return std::partition(first, last, [&](const BoxedItem& item) { return chosen.index(item.box) < cut; });
}

BoxedItem* split_by_count(BoxedItem* first, BoxedItem* last) { return halve(first, last, centres_of(first, last)); }

}  // namespace gphys
