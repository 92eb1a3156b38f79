// Test of eight triangles against rays of one origin, as those of a camera or to a point light, for kernels. What does
// not depend on the direction, the planes through the origin and the edges, is computed once for all rays; then a ray
// takes three dot products (as the volumes of Plücker coordinates: Platis and Theoharis, "Fast ray-tetrahedron
// intersection using Plücker coordinates", 2003). It is as conservative as TriangleTest.
//
// With corners p, q relative to the origin, the volume of an edge is V = direction . (p x (q - p)): the edge is a
// difference of the given corners, so it keeps its digits however far away the origin is. Divided by the component of
// the direction along its longest axis z, the direction is (sx, sy, 1). Ray and triangle miss if two volumes differ in
// sign.
//
// Let u = 2^-24, P the largest coordinate of corners relative to the origin, E that of edges, both as computed, and o
// the error of the float origin. A corner has an error of u P + o, an edge of u E. A component of the product has, with
// its own three roundings, at most 8 u P E + 2 o E, and is at most 2 P E. In V, three such errors are added, and the
// roundings of slopes (4 u P E), products (4) and sums (10):
//     |error of V| <= 42 u P E + 6 o E
// 45 and 6.4 cover the terms in u^2 and the rounding of P. Numbers flushed to zero are errors of 2^-126: of corners,
// edges and their products, in all less than 2^-121 (1 + P + E).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "foundation/compiler.h"
#include "mesh/mesh_ray.h"
#include "mesh/triangle_test.h"

namespace gphys::GPHYS_ISA {

/// What the rays of a packet have in common, if they have one origin.
class SharedOrigin {
public:
    /// The rays of a packet, which have the same signs of direction. Some of them reach the bounds of the mesh.
    SharedOrigin(const PreparedRay* rays, uint32_t count) : first_(first_to_reach(rays, count)) {
        is_shared_ = first_.along.may_reject() && first_.sheared.speed != 0 && is_near();
        if (!is_shared_) return;
        const auto words_of = [](const PreparedRay& ray) {
            std::array<uint64_t, 3> words;
            std::memcpy(&words, &ray.sheared.origin, sizeof words);
            return words;
        };
        const std::array<uint64_t, 3> origin = words_of(first_);
        const int axis = first_.sheared.kz;
        uint64_t differ = 0;
        for (uint32_t i = 0; i < count; ++i) {
            const PreparedRay& ray = rays[i];
            slope_x[i] = ray.triangles.across.slope[0];
            slope_y[i] = ray.triangles.across.slope[1];
            const std::array<uint64_t, 3> words = words_of(ray);
            differ |= (words[0] ^ origin[0]) | (words[1] ^ origin[1]) | (words[2] ^ origin[2]) |
                      static_cast<uint64_t>(ray.sheared.kz ^ axis);
        }
        is_shared_ = differ == 0;
    }

    explicit operator bool() const { return is_shared_; }
    const PreparedRay& first() const { return first_; }

    float slope_x[RayPackets::max_rays], slope_y[RayPackets::max_rays];

private:
    /// The numbers of other rays are not for the mesh (RaySetup).
    static const PreparedRay& first_to_reach(const PreparedRay* rays, uint32_t count) {
        return *std::find_if(rays, rays + count - 1, [](const PreparedRay& ray) { return ray.limit >= 0; });
    }

    /// Far from the mesh, the distance of the origin dominates the error, and triangles are kept that are missed. So
    /// the error of TriangleTest, which moves the origin to the mesh, must not be much smaller: it grows with the size
    /// of the mesh, and this allows distances of some three to nine times that.
    bool is_near() const {
        const float* error = first_.triangles.across.error_slope;
        return first_.along.path.start * 0x1p-22 <= double{error[0]} + double{error[1]};
    }

    const PreparedRay& first_;
    bool is_shared_;
};

/// Eight triangles as seen from the origin.
class TrianglesFromOrigin {
public:
    TrianglesFromOrigin() {}  // of no triangles; not constexpr, which would clear the memory

    /// Call before hits().
    GPHYS_INLINE void see(const PreparedRay& ray, const TrianglePacket& packet) {
        const auto& axis = ray.triangles.axis;
        Float8 corner[3][3], from[3][3], edge[3][3];
        float off = 0;
        for (int k = 0; k < 3; ++k) {
            const double origin = ray.sheared.from[k];
            const auto rounded = static_cast<float>(origin);
            off = std::max(off, std::fabs(static_cast<float>(origin - rounded)));
            for (int c = 0; c < 3; ++c) {
                corner[c][k] = load_aligned(packet.corner[c][axis[k]]);
                from[c][k] = corner[c][k] - splat(rounded);
            }
        }
        Float8 reach = splat(0), length = splat(0);
        for (int c = 0; c < 3; ++c) {
            const int next = c == 2 ? 0 : c + 1;
            for (int k = 0; k < 3; ++k) {
                edge[c][k] = corner[next][k] - corner[c][k];
                length = max(length, abs(edge[c][k]));
            }
        }
        for (int k = 0; k < 3; ++k) reach = max(reach, abs(from[0][k]));
        reach = reach + length;
        for (int c = 0; c < 3; ++c) {
            for (int k = 0; k < 3; ++k) {
                const int y = (k + 1) % 3, z = (k + 2) % 3;
                normal_[c][k] = from[c][y] * edge[c][z] - from[c][z] * edge[c][y];
            }
        }
        constexpr float u = 0x1p-24f, flushed = 0x1p-120f;
        off = off * (1 + 2 * u) + static_cast<float>(ray.along.path.slack) * (1 + 2 * u);
        error_ = length * (reach * splat(45 * u) + splat(6.4f * off)) + (reach * splat(2 * flushed) + splat(flushed));

        // Along the longest axis everything is as in TriangleTest.
        const auto& rest = ray.triangles.rest;
        const Float8 start = splat(ray.triangles.origin[2]);
        Float8 z[3];
        for (int c = 0; c < 3; ++c) z[c] = corner[c][2] - start;
        const Float8 lowest = min(min(z[0], z[1]), z[2]), highest = max(max(z[0], z[1]), z[2]);
        margin_ = rest.margin;
        const bool ahead = rest.ahead != 0;
        nearest_ = ahead ? lowest : splat(0) - highest;
        const Float8 farthest = ahead ? highest : splat(0) - lowest;
        candidates_ = bits(splat(-margin_) <= farthest) & used_lanes(packet);
    }

    /// Lanes that a ray with these slopes may hit no later than at `limit`.
    GPHYS_INLINE uint32_t hits(float slope_x, float slope_y, float limit) const {
        const Float8 x = splat(slope_x), y = splat(slope_y);
        const auto volume = [&](int c) { return normal_[c][2] + x * normal_[c][0] + y * normal_[c][1]; };
        const Float8 a = volume(0), b = volume(1), c = volume(2);
        const Float8 lowest = min(min(a, b), c), highest = max(max(a, b), c);
        const Mask8 around = (splat(0) - error_ <= lowest) | (highest <= error_);
        return bits(around & (nearest_ <= splat(limit + margin_))) & candidates_;
    }

private:
    Float8 normal_[3][3];  // of the planes through the origin and an edge
    Float8 error_, nearest_;
    float margin_;
    uint32_t candidates_;
};

}  // namespace gphys::GPHYS_ISA
