// Partitions triangles into packets by the surface area heuristic, like the BVH above them (sah.h). The last splits are
// placed to fill packets, because a packet takes the same time and memory for any number of triangles.
#include "bvh/sah.h"
#include "mesh/triangle_packet.h"

namespace gphys {
namespace {

constexpr int lanes = 8;
/// Ranges of up to this size are split so that packets are full. Then seven of eight lanes are in use. Starting at
/// larger ranges would fill more lanes, but make packets wider.
constexpr int few = split_few_size;
/// Below this level, splits by cost have degenerated (triangle sizes in a geometric series). Splitting at the median
/// bounds time and depth.
constexpr int cost_levels = 48;

Box bounds_of(const gphys_vec3& a, const gphys_vec3& b, const gphys_vec3& c) {
    return without_negative_zeros({{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                                   {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}});
}

/// Of all splits that leave a multiple of a full packet on one side, the one of least expected cost.
BoxedItem* split_into_full_packets(BoxedItem* first, BoxedItem* last) {
    const int count = static_cast<int>(last - first);
    uint64_t cuts = 0;
    for (int cut = 1; cut < count; ++cut) {
        if (cut % lanes == 0 || (count - cut) % lanes == 0) cuts |= uint64_t{1} << cut;
    }
    return split_few(first, last, cuts, lanes);
}

/// Sorts the items into packets and notes the end of each packet.
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

/// Uninitialised scratch space: pages that are never written cost nothing.
union Place {
    Place() {}
    BoxedItem item;
};

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
    Vector<Place> scratch(count, boxes.get_allocator());
    cut_into_packets(items.data(), items.data() + count, 0, &scratch[0].item, ends);

    packets.reserve(ends.size());
    boxes.reserve(ends.size());
    const BoxedItem* first = items.data();
    for (const BoxedItem* last : ends) {
        packets.push_back(packet_of(arrays, first, last));
        boxes.push_back(union_of(first, last));
        first = last;
    }
}

void pack_triangles(const MeshParts& parts, Vector<TrianglePacket>& packets, Vector<Box>& boxes) {
    packets.reserve(parts.tree.item_count);
    boxes.reserve(parts.tree.item_count);
    const uint32_t* next = parts.order;
    for (uint32_t packet = 0; packet < parts.tree.item_count; ++packet) {
        BoxedItem items[lanes];
        uint32_t count = 0;
        for (bool last = false; !last; ++next) {
            last = (*next & MeshParts::last_of_packet) != 0;
            items[count++].item = *next & ~MeshParts::last_of_packet;
        }
        packets.push_back(packet_of(parts.arrays, items, items + count));
        boxes.push_back(packets.back().box());
    }
}

}  // namespace gphys
