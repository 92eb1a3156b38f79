// Whether the distance of two rounded solids is at most a given reach, by a certificate that is cheap to check. The
// algorithm of Gilbert, Johnson and Keerthi in double precision selects corners. CGAL's interval arithmetic then proves
// that their hulls have points within that distance, or that a plane separates the solids by more. Cases that the
// intervals leave undecided are decided by slower references.
#pragma once

#include "oracle.h"

namespace test {

/// A corner of the Minkowski difference a - b, as the corners of a and b that it is the difference of.
struct CornerPair {
    int a, b;
};

/// Up to four corners of a - b whose hull has the point of a - b nearest to the origin, up to rounding: the algorithm
/// of Gilbert, Johnson and Keerthi (1988), in doubles.
class NearestCorners {
public:
    NearestCorners(const Rounded<double>& a, const Rounded<double>& b) : a_(a), b_(b) {
        add({0, 0});
        // The distance decreases, so no set of corners recurs. The limit ends cycles that rounding may cause.
        for (int i = 0; i < 40; ++i) {
            const double square = dot(nearest_, nearest_);
            if (square <= 1e-32 || count_ == 4) return;
            const CornerPair next = furthest(-nearest_);
            if (square - dot(nearest_, corner(next)) <= 1e-14 * square || has(next)) return;
            add(next);
        }
    }
    int count() const { return count_; }
    const CornerPair& operator[](int i) const { return pairs_[i]; }
    /// The barycentric coordinates of the nearest point: not negative, of sum 1.
    double weight(int i) const { return weights_[i]; }
    const VectorOf<double>& nearest() const { return nearest_; }

private:
    VectorOf<double> corner(CornerPair p) const { return a_.corners[p.a] - b_.corners[p.b]; }
    void add(CornerPair pair) {
        pairs_[count_] = pair;
        corners_[count_++] = corner(pair);
        shrink();
    }
    bool has(CornerPair pair) const {
        return std::any_of(pairs_, pairs_ + count_, [&](CornerPair p) { return p.a == pair.a && p.b == pair.b; });
    }
    static int furthest(const Rounded<double>& solid, const VectorOf<double>& along) {
        int best = 0;
        double most = -INFINITY;
        for (int i = 0; i < static_cast<int>(solid.corners.size()); ++i) {
            const double height = dot(solid.corners[i], along);
            if (height > most) most = height, best = i;
        }
        return best;
    }
    CornerPair furthest(const VectorOf<double>& along) const { return {furthest(a_, along), furthest(b_, -along)}; }

    /// The barycentric coordinates of the point nearest to the origin in the affine hull of `size` corners. Returns
    /// false if it is outside of their convex hull.
    static bool weigh(const VectorOf<double>* const* m, int size, double (&weight)[4]) {
        switch (size) {
            case 1:
                weight[0] = 1;
                return true;
            case 2: {
                const VectorOf<double> edge = *m[1] - *m[0];
                weight[0] = dot(*m[1], edge), weight[1] = -dot(*m[0], edge);
                break;
            }
            case 3: {
                const VectorOf<double> normal = cross(*m[1] - *m[0], *m[2] - *m[0]);
                for (int i = 0; i < 3; ++i) weight[i] = dot(normal, cross(*m[(i + 1) % 3], *m[(i + 2) % 3]));
                break;
            }
            default: {
                for (int i = 0; i < 4; ++i) {
                    const double volume = dot(*m[(i + 1) % 4], cross(*m[(i + 2) % 4], *m[(i + 3) % 4]));
                    weight[i] = i % 2 ? -volume : volume;
                }
                if (weight[0] < 0) {
                    for (double& w : weight) w = -w;
                }
            }
        }
        double sum = 0;
        for (int i = 0; i < size; ++i) {
            if (!(weight[i] >= 0)) return false;
            sum += weight[i];
        }
        for (int i = 0; i < size; ++i) weight[i] /= sum;
        return sum > 0;
    }

    /// Keeps the smallest set of corners whose hull has the nearest point.
    void shrink() {
        double least = INFINITY;
        uint32_t kept = 0;
        for (const uint32_t set : {1, 2, 4, 8, 3, 5, 6, 9, 10, 12, 7, 11, 13, 14, 15}) {
            if (set >> count_) continue;
            const VectorOf<double>* m[4];
            int size = 0;
            for (int i = 0; i < count_; ++i) {
                if (set >> i & 1) m[size++] = &corners_[i];
            }
            double weight[4];
            if (!weigh(m, size, weight)) continue;
            VectorOf<double> point{0, 0, 0};
            for (int i = 0; i < size; ++i) point = point + *m[i] * weight[i];
            const double square = dot(point, point);
            if (kept != 0 && square >= least * (1 - 1e-12)) continue;
            least = square, nearest_ = point, kept = set;
            std::copy(weight, weight + size, weights_);
        }
        int size = 0;
        for (int i = 0; i < count_; ++i) {
            if (kept >> i & 1) pairs_[size] = pairs_[i], corners_[size++] = corners_[i];
        }
        count_ = size;
    }

    const Rounded<double>&a_, &b_;
    CornerPair pairs_[4];
    VectorOf<double> corners_[4], nearest_{0, 0, 0};
    double weights_[4];
    int count_ = 0;
};

/// Checks a certificate. Scalar is exact or an interval; predicates return false if intervals leave them undecided.
template <class Scalar>
class PairProof {
public:
    using Vec = VectorOf<Scalar>;

    PairProof(const Rounded<Scalar>& a, const Rounded<Scalar>& b, const NearestCorners& by)
        : a_(a), b_(b), by_(by), zero_(0) {
        for (int i = 0; i < by.count(); ++i) m_[i] = a.corners[by[i].a] - b.corners[by[i].b];
    }

    /// Whether some point of a - b is within `reach` of the origin.
    bool within(const Scalar& reach) const {
        const Scalar square = reach * reach;
        return CGAL::certainly(reach >= zero_) && (weighed_is_within(square) || hull_is_within(square));
    }
    /// Whether all of a - b is beyond a plane at a distance of more than `reach` from the origin.
    bool beyond(const Scalar& reach) const {
        return is_beyond(reach, Vec(by_.nearest().x, by_.nearest().y, by_.nearest().z)) ||
               (by_.count() < 4 && is_beyond(reach, normal()));
    }
    bool is_beyond(const Scalar& reach, const Vec& normal) const {
        const Scalar low = lowest(a_, normal) + lowest(b_, -normal);
        return CGAL::certainly(low > zero_) &&
               (CGAL::certainly(reach <= zero_) || CGAL::certainly(low * low > reach * reach * dot(normal, normal)));
    }
    /// The normal of the plane through three corners. For fewer corners: of the plane through them that is
    /// perpendicular to the direction to the origin.
    Vec normal() const {
        if (by_.count() == 1) return m_[0];
        if (by_.count() == 2) return cross(m_[1] - m_[0], cross(m_[0], m_[1]));
        const Vec up = cross(m_[1] - m_[0], m_[2] - m_[0]);
        return CGAL::certainly(dot(up, m_[0]) < zero_) ? -up : up;
    }
    static Scalar lowest(const Rounded<Scalar>& solid, const Vec& normal) {
        Scalar low = dot(normal, solid.corners[0]);
        for (const Vec& corner : solid.corners) low = CGAL::min(low, dot(normal, corner));
        return low;
    }

private:
    /// Tests the point with the barycentric coordinates computed in double.
    bool weighed_is_within(const Scalar& square) const {
        Vec point(zero_, zero_, zero_);
        Scalar sum = zero_;
        for (int i = 0; i < by_.count(); ++i) {
            const Scalar weight(by_.weight(i));
            point = point + m_[i] * weight;
            sum += weight;
        }
        return CGAL::certainly(sum > zero_) && CGAL::certainly(dot(point, point) <= square * sum * sum);
    }
    /// Tests the nearest point of the hull of the corners, if it is in the hull's interior.
    bool hull_is_within(const Scalar& square) const {
        switch (by_.count()) {
            case 1:
                return CGAL::certainly(dot(m_[0], m_[0]) <= square);
            case 2: {
                const Vec turn = cross(m_[0], m_[1]), edge = m_[1] - m_[0];
                return CGAL::certainly(dot(m_[0], edge) <= zero_) && CGAL::certainly(dot(m_[1], edge) >= zero_) &&
                       CGAL::certainly(dot(turn, turn) <= square * dot(edge, edge));
            }
            case 3: {
                const Vec up = cross(m_[1] - m_[0], m_[2] - m_[0]);
                const Scalar size = dot(up, up), height = dot(up, m_[0]);
                for (int i = 0; i < 3; ++i) {
                    if (!CGAL::certainly(dot(up, cross(m_[i], m_[(i + 1) % 3])) >= zero_)) return false;
                }
                return CGAL::certainly(size > zero_) && CGAL::certainly(height * height <= square * size);
            }
            case 4:
                return holds_origin();
            default:
                return false;
        }
    }
    bool holds_origin() const {
        bool all_up = true, all_down = true, some = false;
        for (int i = 0; i < 4; ++i) {
            const Scalar volume =
                dot(m_[(i + 1) % 4], cross(m_[(i + 2) % 4], m_[(i + 3) % 4])) * Scalar(i % 2 ? -1 : 1);
            all_up = all_up && CGAL::certainly(volume >= zero_);
            all_down = all_down && CGAL::certainly(volume <= zero_);
            some = some || CGAL::certainly(volume != zero_);
        }
        return some && (all_up || all_down);
    }

    const Rounded<Scalar>&a_, &b_;
    const NearestCorners& by_;
    const Scalar zero_;
    Vec m_[4];
};

/// Whether an answer is proven. `overlap`: the distance of the cores is at most the sum of the radii plus `band`.
/// Otherwise: it is more than that sum minus `band`.
template <class Scalar>
bool is_proven(bool overlap, const Rounded<Scalar>& a, const Rounded<Scalar>& b, const NearestCorners& by,
               double band) {
    const PairProof<Scalar> proof(a, b, by);
    const Scalar radii = a.radius + b.radius;
    return overlap ? proof.within(radii + Scalar(band)) : proof.beyond(radii - Scalar(band));
}

/// The first point of a shape; the struct of each shape begins with one.
template <class Shape>
gphys_vec3 anchor(const Shape& shape) {
    gphys_vec3 point;
    std::memcpy(&point, &shape, sizeof point);
    return point;
}

template <class Scalar>
double largest_corner(const Rounded<Scalar>& solid) {
    double size = 0;
    for (const auto& v : solid.corners) {
        size =
            std::max(size, largest(VectorOf<double>(CGAL::to_double(v.x), CGAL::to_double(v.y), CGAL::to_double(v.z))));
    }
    return size;
}
/// Multiplies the solid by a power of two, so that products stay in the range of doubles. Returns it in doubles.
inline Rounded<double> scale(Rounded<Range>& solid, double factor) {
    solid.radius *= factor;
    Rounded<double> middle({}, {}, CGAL::to_double(solid.radius));
    for (auto& v : solid.corners) {
        v = v * Range(factor);
        middle.corners.emplace_back(CGAL::to_double(v.x), CGAL::to_double(v.y), CGAL::to_double(v.z));
    }
    return middle;
}

/// Whether the answer is certainly right, up to a band of this fraction of the pair's size.
template <class A, class B>
bool is_certain(bool overlap, const A& a, const B& b, double relative_band) {
    const Upward upward;
    Rounded<Range> p = rounded_of<Range>(a, anchor(a)), q = rounded_of<Range>(b, anchor(a));
    // The anchor is at 0.
    const double size = std::max(largest_corner(p) + p.radius.sup(), largest_corner(q) + q.radius.sup());
    if (size == 0) return overlap;
    const double factor = std::ldexp(1.0, -std::ilogb(size));
    const Rounded<double> rough_p = scale(p, factor), rough_q = scale(q, factor);
    const NearestCorners by(rough_p, rough_q);
    // A lower bound of the size, which is between 1 and 2 here.
    return is_proven(overlap, p, q, by, relative_band * 0.999);
}

/// The same in exact arithmetic and without a band, for shapes whose corners are floats.
template <class A, class B>
bool is_exactly(bool overlap, const A& a, const B& b) {
    const auto of = [](const auto& shape, gphys_vec3 from) { return rounded_of<Binary>(shape, from); };
    const Rounded<Binary> p = of(a, anchor(a)), q = of(b, anchor(a));
    return is_proven(overlap, p, q, NearestCorners(rounded_of<double>(a, anchor(a)), rounded_of<double>(b, anchor(a))),
                     0);
}

}  // namespace test
