// Tests of a packet of rays against eight boxes, for kernels. Interval arithmetic tests all rays at once, or a group of
// eight rays at once (Reshetov, Soupikov, Hurley, "Multi-level ray tracing algorithm", 2005); it is conservative. For
// each ray of a group, rays() gives the result of RayTest. All rays have the same signs of direction, so each axis has
// one near face.
#pragma once

#include "bvh/box8_tests.h"

namespace gphys::GPHYS_ISA {

class PacketTest {
public:
    static constexpr uint32_t max_groups = RayPackets::max_rays / 8;

    /// probe_of(i), i < count. `limits` must outlive this; it fills the last group of eight, and is negative where
    /// there is no ray.
    template <class ProbeOf>
    PacketTest(const ProbeOf& probe_of, const float* limits, uint32_t count)
        : groups_((count + 7) / 8), limits_(limits) {
        for (int k = 0; k < 3; ++k) {
            near_face_[k] = probe_of(0).near_face[k];
            far_face_[k] = probe_of(0).far_face[k];
        }
        uint32_t group = 0;
        do {  // not a while loop: gcc would warn of uninitialised bounds
            const auto probe = [&](int i) -> const RayProbe& {
                const uint32_t ray = 8 * group + static_cast<uint32_t>(i);
                return probe_of(ray < count ? ray : 0);
            };
            const auto load_axes = [&](const auto& of, Float8(&to)[3]) {
                const Quads8 quads = load_quads([&](int i) { return of(probe(i)); });
                to[0] = quads.x, to[1] = quads.y, to[2] = quads.z;
            };
            Group& of = each_[group];
            load_axes([](const RayProbe& ray) { return ray.near_origin; }, of.near_origin);
            load_axes([](const RayProbe& ray) { return ray.far_origin; }, of.far_origin);
            load_axes([](const RayProbe& ray) { return ray.minus_inverse; }, of.minus_inverse);
            for (uint32_t k = 0; k < 3; ++k) {
                // The earliest entry and the latest exit of the group.
                const bool forward = near_face_[k] == 8 * k;
                const Float8 near_origin = of.near_origin[k], far_origin = of.far_origin[k];
                Bounds& bounds = group_bounds_[group];
                bounds.near_origin[k] = forward ? greatest_lane(near_origin) : least_lane(near_origin);
                bounds.far_origin[k] = forward ? least_lane(far_origin) : greatest_lane(far_origin);
                bounds.inverse_low[k] = least_lane(of.minus_inverse[k]);
                bounds.inverse_high[k] = greatest_lane(of.minus_inverse[k]);
            }
        } while (++group < groups_);
        bounds_ = group_bounds_[0];
        for (group = 1; group < groups_; ++group) widen(bounds_, group_bounds_[group]);
        set_limits();
    }

    /// The greatest limit of all rays.
    float limit() const { return first_lane(limit_); }
    /// Call after changes of the limits.
    void set_limits() {
        limit_ = splat(-1);
        for (uint32_t group = 0; group < groups_; ++group) {
            group_limits_[group] = greatest_lane(load(limits_ + 8 * group));
            limit_ = max(limit_, group_limits_[group]);
        }
    }

    /// Lanes that some ray may hit.
    uint32_t hits(const Box8& boxes, Float8& entry) const { return hits(bounds_, limit_, boxes, entry); }
    /// The same for each group: byte i holds the lanes of group i.
    uint64_t hits_of_groups(const Box8& boxes) const {
        uint64_t of_groups = 0;
        for (uint32_t group = 0; group < groups_; ++group) {
            Float8 entry;
            of_groups |= uint64_t{hits(group_bounds_[group], group_limits_[group], boxes, entry)} << (8 * group);
        }
        return of_groups;
    }
    /// The rays of a group that hit the box of one lane.
    uint32_t rays(uint32_t group, const Box8& boxes, uint32_t lane) const {
        const Group& of = each_[group];
        const auto enters = [&](int k) {
            return (of.near_origin[k] - splat(boxes.row_from(near_face_[k])[lane])) * of.minus_inverse[k];
        };
        const auto leaves = [&](int k) {
            return (of.far_origin[k] - splat(boxes.row_from(far_face_[k])[lane])) * of.minus_inverse[k];
        };
        return SlabInterval(enters, leaves, load(limits_ + 8 * group)).hits();
    }

private:
    struct Group {
        Float8 near_origin[3], far_origin[3], minus_inverse[3];
    };
    /// Intervals that contain the numbers of several rays; the same in all lanes.
    struct Bounds {
        Float8 near_origin[3], far_origin[3], inverse_low[3], inverse_high[3];
    };

    void widen(Bounds& bounds, const Bounds& other) const {
        for (uint32_t k = 0; k < 3; ++k) {
            const bool forward = near_face_[k] == 8 * k;
            const auto most = [&](Float8 a, Float8 b) { return forward ? max(a, b) : min(a, b); };
            const auto least = [&](Float8 a, Float8 b) { return forward ? min(a, b) : max(a, b); };
            bounds.near_origin[k] = most(bounds.near_origin[k], other.near_origin[k]);
            bounds.far_origin[k] = least(bounds.far_origin[k], other.far_origin[k]);
            bounds.inverse_low[k] = min(bounds.inverse_low[k], other.inverse_low[k]);
            bounds.inverse_high[k] = max(bounds.inverse_high[k], other.inverse_high[k]);
        }
    }

    /// A product lies between those with the least and the greatest inverse, whatever its sign, and rounding keeps
    /// their order. So each ray's entry and exit, as rays() computes them, lie within the interval computed here.
    uint32_t hits(const Bounds& bounds, Float8 limit, const Box8& boxes, Float8& entry) const {
        const auto enters = [&](int k) {
            const Float8 x = bounds.near_origin[k] - load_aligned(boxes.row_from(near_face_[k]));
            return min(x * bounds.inverse_low[k], x * bounds.inverse_high[k]);
        };
        const auto leaves = [&](int k) {
            const Float8 x = bounds.far_origin[k] - load_aligned(boxes.row_from(far_face_[k]));
            return max(x * bounds.inverse_low[k], x * bounds.inverse_high[k]);
        };
        const SlabInterval within(enters, leaves, limit);
        entry = within.entry;
        return within.hits();
    }

    uint32_t groups_;
    uint32_t near_face_[3], far_face_[3];
    const float* limits_;
    Float8 limit_, group_limits_[max_groups];
    Bounds bounds_, group_bounds_[max_groups];
    Group each_[max_groups];
};

}  // namespace gphys::GPHYS_ISA
