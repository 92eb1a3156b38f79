// Triangles are cut by expected cost like the items of the octree above them (sah.h). The last few
// cuts are made where they leave full packets: a packet costs the same however many triangles it
// holds, and a mesh takes as many bytes as it has packets.
#include "mesh/triangle_packet.h"
#include "octree/sah.h"

namespace gphys {

namespace {

constexpr int lanes = 8;
/// From here down all cuts fill packets. More would make packets fuller yet, and wider: at 64, seven
/// of eight lanes are in use.
constexpr int few = 64;
/// Below this level cuts by cost have gone wrong (sizes in a geometric series), and halving bounds
/// both the time and the depth.
constexpr int cost_levels = 48;

Box bounds_of(const gphys_vec3& a, const gphys_vec3& b, const gphys_vec3& c) {
    return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
            {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
}

/// Where each of a few values stands among them; equal ones stay in order. To compare all with all
/// takes no unpredictable branch.
void rank_all(const float* values, int count, int* rank) {
    for (int i = 0; i < count; ++i) {
        int below = 0;
        for (int k = 0; k < i; ++k) below += values[k] <= values[i];
        for (int k = i + 1; k < count; ++k) below += values[k] < values[i];
        rank[i] = below;
    }
}

/// Of all cuts with a full packet's multiple on one side, the one of least expected cost.
BoxedItem* split_into_full_packets(BoxedItem* first, BoxedItem* last) {
    const int count = static_cast<int>(last - first);
    int order[3][few];
    double least = infinity;
    int best_axis = 0, best_cut = 0;
    for (int axis = 0; axis < 3; ++axis) {
        float centres[few];
        int rank[few];
        for (int i = 0; i < count; ++i) centres[i] = first[i].box.min[axis] + first[i].box.max[axis];
        rank_all(centres, count, rank);
        int* places = order[axis];
        for (int i = 0; i < count; ++i) places[rank[i]] = i;
        const auto fills = [&](int cut) { return cut % lanes == 0 || (count - cut) % lanes == 0; };
        const auto packets = [](int n) { return (n + lanes - 1) / lanes; };
        double cost_above[few];
        Box box;
        for (int cut = count; cut-- > 1;) {
            box.include(first[places[cut]].box);
            if (fills(cut)) cost_above[cut] = half_area(box) * packets(count - cut);
        }
        box = Box();
        for (int cut = 1; cut < count; ++cut) {
            box.include(first[places[cut - 1]].box);
            if (!fills(cut)) continue;
            const double cost = half_area(box) * packets(cut) + cost_above[cut];
            if (cost < least) {
                least = cost;
                best_axis = axis;
                best_cut = cut;
            }
        }
    }
    BoxedItem sorted[few];
    for (int i = 0; i < count; ++i) sorted[i] = first[order[best_axis][i]];
    std::copy(sorted, sorted + count, first);
    return first + best_cut;
}

/// Put the items in order and note where each packet ends.
void cut_into_packets(BoxedItem* first, BoxedItem* last, int level, BoxedItem* scratch, Vector<BoxedItem*>& ends) {
    while (last - first > lanes) {
        ++level;
        BoxedItem* middle = last - first <= few   ? split_into_full_packets(first, last)
                            : level < cost_levels ? split_by_cost(first, last, scratch)
                                                  : split_by_count(first, last);
        cut_into_packets(first, middle, level, scratch, ends);
        first = middle;
    }
    ends.push_back(last);
}

TrianglePacket packet_of(const MeshArrays& arrays, const BoxedItem* first, const BoxedItem* last) {
    TrianglePacket packet;
    for (int lane = 0; lane < lanes; ++lane) {
        const bool used = lane < last - first;
        const uint32_t triangle = first[used ? lane : 0].item;
        packet.index[lane] = used ? triangle : TrianglePacket::none;
        for (int c = 0; c < 3; ++c) {
            const gphys_vec3 v = arrays.vertex(arrays.indices[size_t{3} * triangle + static_cast<size_t>(c)]);
            packet.corner[c][0][lane] = v.x;
            packet.corner[c][1][lane] = v.y;
            packet.corner[c][2][lane] = v.z;
        }
    }
    return packet;
}

}  // namespace

void pack_triangles(const MeshArrays& arrays, Vector<TrianglePacket>& packets, Vector<Box>& boxes) {
    const uint32_t count = arrays.index_count / 3;
    if (count == 0) return;
    Vector<BoxedItem> items(boxes.get_allocator());
    items.reserve(count);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t* corner = arrays.indices + size_t{3} * i;
        items.push_back({bounds_of(arrays.vertex(corner[0]), arrays.vertex(corner[1]), arrays.vertex(corner[2])), i});
    }
    Vector<BoxedItem*> ends(boxes.get_allocator());
    Vector<BoxedItem> scratch(count, boxes.get_allocator());
    cut_into_packets(items.data(), items.data() + count, 0, scratch.data(), ends);

    packets.reserve(ends.size());
    boxes.reserve(ends.size());
    const BoxedItem* first = items.data();
    for (const BoxedItem* last : ends) {
        packets.push_back(packet_of(arrays, first, last));
        boxes.push_back(union_of(first, last));
        first = last;
    }
}

}  // namespace gphys
