// classify: on which side of a plane or frustum is a shape? By the interval of its signed heights (heights.h), whose
// signs are exact.
#include "geometry/heights.h"
#include "geometry/intersect.h"

namespace gphys {
namespace {

double height(Vec3 point, const PlaneAt& plane) {
    return value_of([&](auto number) { return height_above<decltype(number)>(plane, point); });
}

/// height - reach, reach R = r |n| of the sphere. Where the two cancel, the root in |n| would round the sign, so
/// (h - R) = (h^2 - R^2) / (h + R) with an exact difference of squares.
double lowered(const Sphere& sphere, const PlaneAt& plane) {
    const double reach = sphere.radius * length(plane.normal);
    const double h = height(sphere.center, plane);
    if (h <= 0) return h - reach;
    const double squares = value_of([&](auto number) {
        using N = decltype(number);
        const N exact_height = height_above<N>(plane, sphere.center);
        const Vec<N> normal = Vec<N>::of(plane.normal);
        return exact_height * exact_height - N(sphere.radius) * N(sphere.radius) * dot(normal, normal);
    });
    return squares / (h + reach);
}

PlaneAt flipped(const PlaneAt& plane) { return {-plane.normal, plane.origin, -plane.distance}; }

}  // namespace

Heights heights(const Sphere& sphere, const PlaneAt& plane) {
    return {lowered(sphere, plane), -lowered(sphere, flipped(plane))};
}

Heights heights(const Capsule& capsule, const PlaneAt& plane) {
    const Heights a = heights(Sphere{capsule.a, capsule.radius}, plane);
    const Heights b = heights(Sphere{capsule.b, capsule.radius}, plane);
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

Heights heights(const Aabb& box, const PlaneAt& plane) {
    Vec3 lowest, highest;
    for (int k = 0; k < 3; ++k) {
        lowest[k] = plane.normal[k] > 0 ? box.min[k] : box.max[k];
        highest[k] = plane.normal[k] > 0 ? box.max[k] : box.min[k];
    }
    return {height(lowest, plane), height(highest, plane)};
}

Heights heights(const Obb& box, const PlaneAt& plane) {
    const auto extreme = [&](double way) {
        return value_of([&](auto number) {
            using N = decltype(number);
            const auto reach_along = [&](Vec3 axis, double half) { return half * abs(dot_of<N>(plane.normal, axis)); };
            // A statement for each term, which takes less stack than one sum.
            N reach = reach_along(box.axes.x, box.half.x);
            reach = reach + reach_along(box.axes.y, box.half.y);
            reach = reach + reach_along(box.axes.z, box.half.z);
            return height_above<N>(plane, box.center) + way * reach;
        });
    };
    return {extreme(-1), extreme(1)};
}

Heights heights(const Triangle& triangle, const PlaneAt& plane) {
    const double a = height(triangle.a, plane), b = height(triangle.b, plane), c = height(triangle.c, plane);
    return {std::min({a, b, c}), std::max({a, b, c})};
}

Side classify(const Shape& shape, const Plane& plane, double& signed_distance) {
    const Heights range = std::visit(
        [&](const auto& s) {
            using S = std::decay_t<decltype(s)>;
            if constexpr (std::is_same_v<S, Plane> || std::is_same_v<S, Frustum>) {
                return Heights{};
            } else {
                return heights(s, plane_at(plane));
            }
        },
        shape);
    if (range.low > 0) {
        signed_distance = range.low / length(plane.normal);
        return Side::inside;
    }
    if (range.high < 0) {
        signed_distance = range.high / length(plane.normal);
        return Side::outside;
    }
    signed_distance = 0;
    return Side::crossing;
}

Side classify(const Shape& shape, const Frustum& frustum) {
    const bool inside = std::visit(
        [&](const auto& s) {
            using S = std::decay_t<decltype(s)>;
            if constexpr (std::is_same_v<S, Plane> || std::is_same_v<S, Frustum>) {
                return false;
            } else {
                for (int i = 0; i < 6; ++i) {
                    if (heights(s, plane_at(frustum, i)).low < 0) return false;
                }
                return true;
            }
        },
        shape);
    if (inside) return Side::inside;
    return overlaps(shape, Shape(frustum)) ? Side::crossing : Side::outside;
}

}  // namespace gphys
