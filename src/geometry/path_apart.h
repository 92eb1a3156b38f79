// A conservative test of the path of a ball, that is of a capsule, and a triangle: whether an axis certainly separates
// the two. Most pairs whose boxes overlap are rejected by it, without exact arithmetic.
#pragma once

#include <algorithm>

#include "geometry/intersect.h"

namespace gphys {

/// Coordinates are relative to the start of the path; none of the triangle is larger than `size`.
class PathAndTriangle {
public:
    /// `margin`: relative to the largest coordinate.
    PathAndTriangle(Vec3 way, double radius, const Triangle& around, double size, double margin)
        : way_(way), radius_(radius), around_(around), margin_(margin * (size + max_component(abs(way)) + radius)) {}

    /// By the axis of the face, which separates a ball that slides along it.
    bool are_apart_by_face() const {
        const Vec3 face = cross(around_.b - around_.a, around_.c - around_.a);
        return separates(dot(face, around_.a) > 0 ? -face : face);
    }
    /// By the axis to the edge or corner that is nearest to a point of the path.
    bool are_apart_beside(Vec3 point) const {
        return separates(from_edges({around_.a - point, around_.b - point, around_.c - point}));
    }
    /// By the axis to the edge or corner that is nearest to the line of the path. Of a short path the others will do.
    bool are_apart_along_path() const {
        const double square = length_squared(way_);
        if (!(square > radius_ * radius_)) return false;
        const auto seen = [&](Vec3 v) { return v - way_ * (dot(v, way_) / square); };
        return separates(from_edges({seen(around_.a), seen(around_.b), seen(around_.c)}));
    }

private:
    /// A height has less than eight roundings of 2^-53 of its products. 2^-1000 covers products that underflow.
    bool separates(Vec3 axis) const {
        const double triangle = std::max({dot(axis, around_.a), dot(axis, around_.b), dot(axis, around_.c)});
        const double path = std::min(0.0, dot(axis, way_));
        return path - triangle > radius_ * length(axis) + margin_ * max_component(abs(axis)) + 0x1p-1000;
    }
    /// From the nearest point of the edges to the origin.
    static Vec3 from_edges(const Triangle& triangle) {
        Vec3 best = closest_point(Segment{triangle.a, triangle.b}, Vec3{});
        for (const Segment& edge : {Segment{triangle.b, triangle.c}, Segment{triangle.c, triangle.a}}) {
            const Vec3 candidate = closest_point(edge, Vec3{});
            if (length_squared(candidate) < length_squared(best)) best = candidate;
        }
        return -best;
    }

    Vec3 way_;
    double radius_;
    const Triangle& around_;
    double margin_;
};

}  // namespace gphys
