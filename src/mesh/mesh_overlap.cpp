// Overlaps of a mesh: with a shape, triangle by triangle, and with another mesh. The BVH is traversed with the box of
// the shape, or with a frustum, or by an exact test of each box; then the triangles get the exact test.
#include "mesh/mesh.h"

namespace gphys {

bool Mesh::find_overlaps(const Shape& shape, const OverlapVisitor& to, const AxisScale& axes) const {
    const bool finds_all = to.visit != nullptr, are_plain = axes.is_one() && !is_links();
    bool found = false;
    // Returns whether to go on.
    const auto take = [&](const TrianglePacket& packet, uint32_t lanes) {
        if (lanes == 0) return true;
        found = true;
        if (!finds_all) return false;
        if (lanes == 0xff) {
            to.visit(to.context, packet.index, 8);
            return true;
        }
        uint32_t triangles[8], count = 0;
        for (; lanes != 0; lanes &= lanes - 1) triangles[count++] = packet.index[lowest_bit(lanes)];
        to.visit(to.context, triangles, count);
        return true;
    };
    const auto find = [&](const auto& each) {
        using Query = std::decay_t<decltype(each)>;
        const auto test = [&](const TrianglePacket& packet, uint32_t lanes) {
            const auto overlaps_query = [&](const auto& item) { return overlaps_item(each, item); };
            const bool plain = are_plain, all = finds_all;
            uint32_t overlapped = 0;
            for (uint32_t rest = lanes; rest != 0 && (all || overlapped == 0); rest &= rest - 1) {
                const int lane = lowest_bit(rest);
                const bool is_one =
                    plain ? overlaps_query(packet.triangle(lane)) : with_item(packet, lane, axes, overlaps_query);
                overlapped |= uint32_t{is_one} << lane;
            }
            return take(packet, overlapped);
        };
        if constexpr (std::is_same_v<Query, Frustum>) {
            if (axes.is_one()) {
                bvh_.frustum(each, all_of_space, [&](uint32_t number, bool wholly_inside) {
                    const TrianglePacket& packet = packets_[number];
                    return wholly_inside ? take(packet, lanes_of(packet)) : test(packet, lanes_of(packet));
                });
                return;
            }
        }
        if constexpr (std::is_same_v<Query, Plane> || std::is_same_v<Query, Frustum>) {
            // Slower than the kernels.
            const auto overlaps_box = [&](const Box& box) { return gphys::overlaps(axes(box), each); };
            bvh_.overlap(overlaps_box,
                         [&](uint32_t number) { return test(packets_[number], lanes_of(packets_[number])); });
        } else {
            const Box box = axes.inverse(gphys::bounds(each));
            bvh_.overlap_box(box, [&](uint32_t number, bool) {
                return test(packets_[number], lanes_in_box(packets_[number], box));
            });
        }
    };
    std::visit(find, shape);
    return found;
}

void Mesh::list_overlaps(const Shape& shape, Smallest<uint32_t>& out) const {
    const auto add_all = [](void* context, const uint32_t* triangles, uint32_t count) {
        static_cast<Smallest<uint32_t>*>(context)->add_all(triangles, count);
    };
    find_overlaps(shape, {add_all, &out}, {});
}

bool Mesh::overlaps(const Shape& shape, const AxisScale& axes) const {
    return (is_hull() && contains_point_of(shape, axes)) || find_overlaps(shape, {}, axes);
}

bool Mesh::overlaps(const Mesh& other) const {
    if (contains_part_of(other) || other.contains_part_of(*this)) return true;
    return !bvh_.overlap_pairs(other.bvh_, [&](uint32_t mine, uint32_t theirs) {
        const TrianglePacket &a = packets_[mine], &b = other.packets_[theirs];
        return for_each_lane(lanes_in_box(a, other.bvh_.box(theirs)), [&](int lane) {
            return with_item(a, lane, {}, [&](const auto& item) {
                return for_each_lane(other.lanes_in_box(b, gphys::bounds(item)), [&](int other_lane) {
                    return other.with_item(b, other_lane, {},
                                           [&](const auto& other_item) { return !gphys::overlaps(item, other_item); });
                });
            });
        });
    });
}

}  // namespace gphys
