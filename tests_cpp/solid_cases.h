// Random and adversarial pairs of a solid that moves and a shape, for penetration and sweeps: on a grid, where faces,
// edges and corners meet exactly, and off it; flat and thin ones; far from the origin.
#pragma once

#include "convex_hull.h"
#include "ray_cases.h"

namespace test {

struct SolidPair {
    gphys::Shape other, moving;
    gphys::Vec3 way;  // of the solid, most often to the other shape or through it
    double size;      // no difference of coordinates is larger
};

class SolidCases {
public:
    explicit SolidCases(uint64_t seed) : random(seed) {}

    /// Shapes whose middles are up to `reach` from each other.
    SolidPair next(int reach) {
        grid_ = random.index(3) == 0;
        const double far = random.index(4) == 0 ? std::pow(10, random.uniform(1, 6)) : 0;
        offset_ = grid_ ? gphys::Vec3{} : on_lattice(random_point(random, far));
        const gphys::Vec3 at = point(reach);
        SolidPair pair{other(), moving(at + offset_), (point(3) - at) * (random.index(2) + 1.0), 0};
        if (random.index(16) == 0) pair.way = {};
        pair.size = 16.0 + 2 * reach + length(pair.way) + length(offset_) * 0x1p-10;
        return pair;
    }
    Random random;

private:
    gphys::Vec3 point(int extent) {
        return grid_ ? grid_point(random, extent) : on_lattice(random_point(random, extent));
    }
    double radius() {
        if (grid_) return random.index(3);
        return random.index(8) == 0 ? 0 : on_lattice(std::pow(10, random.uniform(-2, 0.3)));
    }
    /// Some axis parallel, some nearly so.
    gphys::Mat3 axes() {
        const uint32_t kind = grid_ ? random.index(2) : random.index(6);
        if (kind == 0) return {};
        if (grid_) return gphys::rotation_matrix(gphys::Quat{0, 0, 0.6, 0.8});
        gphys_quat q = random.rotation();
        if (kind == 1) {
            const float small = static_cast<float>(std::pow(10, random.uniform(-9, -3)));
            q = {q.x * small, q.y * small, q.z * small, 1};
        }
        return gphys::rotation_matrix(gphys::widen(q));
    }
    gphys::Vec3 half() {
        gphys::Vec3 half = abs(point(2));
        if (random.index(6) == 0) half[static_cast<int>(random.index(3))] *= grid_ ? 0 : 0x1p-12;
        return half;
    }
    gphys::Shape moving(gphys::Vec3 at) {
        switch (random.index(4)) {
            case 0:
                return gphys::Sphere{at, radius()};
            case 1:
                return gphys::Capsule{at, random.index(8) == 0 ? at : at + point(2), radius()};
            case 2: {
                const gphys::Vec3 reaches = half();
                return gphys::Aabb{at - reaches, at + reaches};
            }
            default:
                return gphys::Obb{at, half(), axes()};
        }
    }
    gphys::Shape other() {
        const gphys::Vec3 at = point(2) + offset_;
        switch (random.index(7)) {
            case 0:
                return gphys::Sphere{at, radius()};
            case 1:
                return gphys::Capsule{at, random.index(8) == 0 ? at : at + point(2), radius()};
            case 2: {
                const gphys::Vec3 reaches = half();
                return gphys::Aabb{at - reaches, at + reaches};
            }
            case 3:
                return gphys::Obb{at, half(), axes()};
            case 4: {
                const gphys::Vec3 normal = grid_ ? grid_direction(random, 2) : on_lattice(random.direction());
                return gphys::Plane{normal, dot(normal, at)};
            }
            case 5:
                return frustum(at);
            default:
                return triangle(at);
        }
    }
    /// What a camera sees: some long and thin, some wide.
    gphys::Frustum frustum(gphys::Vec3 at) {
        const auto some = [&](double low, double high) {
            return grid_ ? 0.5 * (1 + random.index(4)) : std::pow(10, random.uniform(low, high));
        };
        const double width = some(-3, 2), height = some(-3, 2), near = some(-4, 0) / std::max({1.0, width, height});
        const double longer = grid_ ? 1 + random.index(3) : std::pow(10, random.uniform(0.01, 4));
        const double far = std::min(near * (1 + longer), 4 / std::max({1.0, width, height}));
        return view(at, axes(), width, height, near, std::max(far, 1.01 * near), false).frustum;
    }
    gphys::Triangle triangle(gphys::Vec3 at) {
        const gphys::Vec3 b = at + point(3);
        switch (random.index(8)) {
            case 0:  // a segment, or a sliver
                return {at, b, on_lattice(at + (b - at) * random.uniform(0, 1))};
            case 1:
                return {at, b, on_lattice(at + (b - at) * random.uniform(0, 1)) + gphys::Vec3{0x1p-16, 0, 0}};
            case 2:
                return {at, at, at};
            default:
                return {at, b, at + point(3)};
        }
    }

    bool grid_ = false;
    gphys::Vec3 offset_;
};

inline gphys::Shape moved(const gphys::Shape& shape, gphys::Vec3 by) {
    return std::visit(
        [&](const auto& each) -> gphys::Shape {
            auto result = each;
            if constexpr (std::is_same_v<decltype(result), gphys::Capsule>) {
                result.a += by, result.b += by;
            } else if constexpr (std::is_same_v<decltype(result), gphys::Aabb>) {
                result.min += by, result.max += by;
            } else if constexpr (std::is_same_v<decltype(result), gphys::Sphere> ||
                                 std::is_same_v<decltype(result), gphys::Obb>) {
                result.center += by;
            }
            return result;
        },
        shape);
}

/// Whether nothing of a solid is thinner than that.
inline bool has_thickness(const gphys::Shape& shape, double of) {
    if (const auto* sphere = std::get_if<gphys::Sphere>(&shape)) return sphere->radius > of;
    if (const auto* capsule = std::get_if<gphys::Capsule>(&shape)) return capsule->radius > of;
    const gphys::Obb box =
        std::holds_alternative<gphys::Aabb>(shape) ? as_obb(std::get<gphys::Aabb>(shape)) : std::get<gphys::Obb>(shape);
    return box.half.x > of && box.half.y > of && box.half.z > of;
}

/// The solid grown by so much on all sides, or shrunk.
inline gphys::Shape grown(const gphys::Shape& shape, double by) {
    const gphys::Vec3 all{by, by, by};
    return std::visit(
        [&](const auto& each) -> gphys::Shape {
            auto result = each;
            if constexpr (std::is_same_v<decltype(result), gphys::Capsule> ||
                          std::is_same_v<decltype(result), gphys::Sphere>) {
                result.radius = std::max(result.radius + by, 0.0);
            } else if constexpr (std::is_same_v<decltype(result), gphys::Aabb>) {
                result.min = result.min - all, result.max += all;
            } else if constexpr (std::is_same_v<decltype(result), gphys::Obb>) {
                result.half = max(result.half + all, {});
            }
            return result;
        },
        shape);
}

/// The slow twin of a shape that has one; without corners for a plane.
inline Hull twin_of(const gphys::Shape& shape) {
    return std::visit(
        [](const auto& each) {
            using S = std::decay_t<decltype(each)>;
            Hull twin;
            if constexpr (!std::is_same_v<S, gphys::Plane>) twin = hull(each);
            return twin;
        },
        shape);
}

/// How far two shapes get beyond the plane of their contact, which is between them.
inline double beyond_plane(const Hull& shape, const Hull& solid, gphys::Vec3 point, gphys::Vec3 normal) {
    double beyond = 0;
    for (const gphys::Vec3& corner : shape.corners)
        beyond = std::max(beyond, dot(normal, corner - point) + shape.radius);
    for (const gphys::Vec3& corner : solid.corners)
        beyond = std::max(beyond, dot(normal, point - corner) + solid.radius);
    return beyond;
}

}  // namespace test
