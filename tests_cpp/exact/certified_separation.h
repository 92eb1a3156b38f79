// Certified bounds of the separation of two convex solids: their distance, or minus their penetration depth. A pair of
// points bounds it from above, the gap along a normal from below. The penetration depth is that of the origin in the
// Minkowski difference. The normals of its faces are face normals of either solid, or cross products of an edge of
// each. Interval arithmetic decides nearly all cases, CGAL's exact numbers the rest.
#pragma once

#include <optional>

#include "certified_pairs.h"

namespace test {

/// A rounded polytope with the directions of its edges and the normals of its faces. Further vectors do no harm.
template <class T>
struct Convex {
    Rounded<T> core;
    std::vector<VectorOf<T>> edges, normals;

    /// Replaces the polytope by the volume that it sweeps between two displacements.
    void sweep(const VectorOf<T>& from, const VectorOf<T>& to) {
        const size_t count = core.corners.size();
        for (size_t i = 0; i < count; ++i) {
            core.corners.push_back(core.corners[i] + to);
            core.corners[i] = core.corners[i] + from;
        }
        const VectorOf<T> way = to - from;
        for (const VectorOf<T>& edge : edges) normals.push_back(cross(edge, way));
        edges.push_back(way);
    }
};

/// The core of a shape relative to a point, multiplied by a power of two.
template <class T, class Shape>
Rounded<T> core_of(const Shape& shape, gphys_vec3 from, double factor) {
    Rounded<T> core = rounded_of<T>(shape, from);
    core.radius *= T(factor);
    for (VectorOf<T>& corner : core.corners) corner = corner * T(factor);
    return core;
}
template <class T>
Convex<T> convex_of(const gphys_sphere& sphere, gphys_vec3 from, double factor) {
    return {core_of<T>(sphere, from, factor), {}, {}};
}
template <class T>
Convex<T> convex_of(const gphys_capsule& capsule, gphys_vec3 from, double factor) {
    Convex<T> result{core_of<T>(capsule, from, factor), {}, {}};
    result.edges.push_back(result.core.corners[1] - result.core.corners[0]);
    return result;
}
template <class T>
Convex<T> convex_of(const gphys_aabb& box, gphys_vec3 from, double factor) {
    const T one(1), zero(0);
    const std::vector<VectorOf<T>> axes{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
    return {core_of<T>(box, from, factor), axes, axes};
}
template <class T>
Convex<T> convex_of(const gphys_obb& box, gphys_vec3 from, double factor) {
    const Axes<T> rotation(box.rotation);
    const std::vector<VectorOf<T>> axes(rotation.axis, rotation.axis + 3);
    return {core_of<T>(box, from, factor), axes, axes};
}
template <class T>
Convex<T> convex_of(const gphys_triangle& triangle, gphys_vec3 from, double factor) {
    Convex<T> result{core_of<T>(triangle, from, factor), {}, {}};
    const auto& c = result.core.corners;
    for (size_t i = 0; i < 3; ++i) result.edges.push_back(c[(i + 1) % 3] - c[i]);
    result.normals.push_back(cross(result.edges[0], result.edges[1]));
    return result;
}

/// Proofs about the separation of two cores; below 0 it is a penetration depth. T is exact or an interval; functions
/// return false if intervals leave them undecided.
template <class T>
class SeparationProof {
public:
    using Vec = VectorOf<T>;

    SeparationProof(const Convex<T>& a, const Convex<T>& b, const NearestCorners& by)
        : a_(a), b_(b), near_(a.core, b.core, by), zero_(0) {}

    bool at_most(const T& reach) const {
        if (CGAL::certainly(reach >= zero_)) return near_.within(reach) || is_deep(zero_);
        return CGAL::certainly(reach < zero_) && is_deep(reach);
    }
    /// Whether the projections on all normals overlap by at least -reach; reach <= 0.
    bool is_deep(const T& reach) const {
        bool some = false;
        const bool all = for_each_normal([&](const Vec& normal) {
            if (is_zero(normal)) return true;
            some = true;
            const T square = reach * reach * dot(normal, normal), low = gap(normal), other = gap(-normal);
            return CGAL::certainly(low < zero_) && CGAL::certainly(low * low >= square) &&
                   CGAL::certainly(other < zero_) && CGAL::certainly(other * other >= square);
        });
        return some && all;
    }
    bool at_least(const T& reach, const Vec& n) const {
        const T low = gap(n), size = dot(n, n), square = reach * reach * size;
        if (!CGAL::certainly(size > zero_)) return false;
        if (CGAL::certainly(reach > zero_)) return CGAL::certainly(low > zero_) && CGAL::certainly(low * low >= square);
        if (CGAL::certainly(low >= zero_)) return CGAL::certainly(reach <= zero_);
        return CGAL::certainly(reach < zero_) && CGAL::certainly(low * low <= square);
    }
    /// The same with the normal between the nearest corners.
    bool at_least_by_corners(const T& reach) const { return at_least(reach, near_.normal()); }
    /// Whether some normal proves it.
    bool at_least_by_any(const T& reach) const {
        return !for_each_normal([&](const Vec& n) { return !at_least(reach, n) && !at_least(reach, -n); });
    }
    /// The normal with the largest gap. Also tries cross products of edges with the axes, for flat differences, which
    /// have too few normals.
    Vec widest() const {
        T most(-INFINITY);
        Vec best(zero_, zero_, zero_);
        const auto offer = [&](const Vec& normal) {
            const T size = dot(normal, normal);
            if (!(size > 0)) return true;
            for (const Vec& n : {normal, -normal}) {
                const T low = gap(n) / std::sqrt(size);
                if (low > most) most = low, best = n;
            }
            return true;
        };
        for_each_normal(offer);
        const T one(1);
        for (const Vec& axis : {Vec{one, zero_, zero_}, Vec{zero_, one, zero_}, Vec{zero_, zero_, one}}) {
            offer(axis);
            for (const Convex<T>* solid : {&a_, &b_}) {
                for (const Vec& edge : solid->edges) offer(cross(edge, axis));
            }
        }
        return best;
    }

private:
    /// visit(normal) returns whether to go on.
    template <class Visit>
    bool for_each_normal(const Visit& visit) const {
        for (const Convex<T>* solid : {&a_, &b_}) {
            for (const Vec& normal : solid->normals) {
                if (!visit(normal)) return false;
            }
        }
        for (const Vec& p : a_.edges) {
            for (const Vec& q : b_.edges) {
                if (!visit(cross(p, q))) return false;
            }
        }
        return true;
    }
    /// The gap along a vector: the least height of a minus the greatest height of b.
    T gap(const Vec& n) const { return near_.lowest(a_.core, n) + near_.lowest(b_.core, -n); }
    bool is_zero(const Vec& n) const {
        return CGAL::certainly(n.x == zero_) && CGAL::certainly(n.y == zero_) && CGAL::certainly(n.z == zero_);
    }

    const Convex<T>&a_, &b_;
    const PairProof<T> near_;
    const T zero_;
};

/// The separation of two rounded solids. build(T()) returns them as a pair of Convex in numbers of type T, with
/// coordinates of up to about 2.
template <class Build>
class Separation {
public:
    explicit Separation(const Build& build) : build_(build), rough_(build(0.0)) {
        by_.emplace(rough_.first.core, rough_.second.core);
        const Upward upward;
        ranges_.emplace(build(Range()));
    }

    /// Whether it is proved that the separation is at most `reach`.
    bool at_most(double reach) const {
        {
            const Upward upward;
            const auto& [a, b] = *ranges_;
            if (SeparationProof<Range>(a, b, *by_).at_most(with_radii(a, b, reach))) return true;
        }
        const auto [a, b] = build_(Number());
        const Number all = with_radii(a, b, reach);
        return SeparationProof<Number>(a, b, *by_).at_most(all) || (all >= 0 && is_within(rounded(all) - rounding));
    }
    bool at_least(double reach) const {
        const VectorOf<double> way = by_->nearest();
        VectorOf<double> widest;
        {
            const Upward upward;
            const auto& [a, b] = *ranges_;
            const Range all = with_radii(a, b, reach);
            const SeparationProof<Range> proof(a, b, *by_);
            if (proof.at_least(all, in<Range>(way))) return true;
            if (by_->count() < 4 && proof.at_least_by_corners(all)) return true;
            widest = SeparationProof<double>(rough_.first, rough_.second, *by_).widest();
            if (proof.at_least(all, in<Range>(widest))) return true;
        }
        const auto [a, b] = build_(Number());
        const Number all = with_radii(a, b, reach);
        const SeparationProof<Number> proof(a, b, *by_);
        return proof.at_least(all, in<Number>(way)) || (by_->count() < 4 && proof.at_least_by_corners(all)) ||
               proof.at_least_by_any(all) || (all > 0 && !is_within(rounded(all) + rounding));
    }

private:
    /// Bound of the rounding errors of corners in doubles.
    static constexpr double rounding = 0x1p-48;

    template <class T>
    static VectorOf<T> in(const VectorOf<double>& v) {
        return {T(v.x), T(v.y), T(v.z)};
    }
    template <class T>
    static T with_radii(const Convex<T>& a, const Convex<T>& b, double reach) {
        return a.core.radius + b.core.radius + T(reach);
    }
    bool is_within(double reach) const {
        if (reach < 0) return false;
        const CGAL::Quotient<Binary> square = squared_distance(rough_.first.core, rough_.second.core);
        return square.numerator() <= square.denominator() * Binary(reach) * Binary(reach);
    }

    const Build& build_;
    const std::pair<Convex<double>, Convex<double>> rough_;
    std::optional<NearestCorners> by_;
    std::optional<std::pair<Convex<Range>, Convex<Range>>> ranges_;
};

}  // namespace test
