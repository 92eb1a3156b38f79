// The point of a Minkowski difference that is closest to the origin: GJK (Gilbert, Johnson, Keerthi 1988) with a check
// of its result, and the test of all features (convex.h).
#include <algorithm>

#include "geometry/convex.h"
#include "geometry/intersect.h"

namespace gphys {
namespace {

// Relative to the size of a polytope. A dot product of an offset and a corner has a dozen roundings of 2^-53 of it.
constexpr double unproved = 0x1p-45, exact = 0x1p-51, rounded = 0x1p-48;
// If the ratio of volume to product of edges is smaller, the orientation of a tetrahedron is not certain.
constexpr double flat = 0x1p-44;

}  // namespace

/// The simplex of GJK: up to four corners, and the barycentric weights of its closest point.
class ConvexDifference::Simplex {
public:
    /// Returns false if the corner is in the simplex already.
    bool add(const Corner& corner) {
        for (int i = 0; i < count_; ++i) {
            if (corners_[i].difference == corner.difference) return false;
        }
        corners_[count_++] = corner;
        return true;
    }

    /// Reduces to the smallest sub-simplex that contains the closest point. Four corners remain if the origin is
    /// inside.
    void reduce() {
        Part best = nearest();
        Corner kept[4];
        for (int i = 0; i < best.count; ++i) {
            kept[i] = corners_[best.corner[i]];
            weights_[i] = best.weight[i];
        }
        std::copy_n(kept, best.count, corners_);
        count_ = best.count;
    }

    bool is_full() const { return count_ == 4; }
    NearestDifference point() const {
        NearestDifference result;
        for (int i = 0; i < count_; ++i) {
            result.offset += corners_[i].difference * weights_[i];
            result.on_other += corners_[i].on_other * weights_[i];
        }
        return result;
    }

private:
    /// A sub-simplex with the weights of its closest point.
    struct Part {
        int count, corner[4];
        double weight[4];
    };

    Vec3 at(int i) const { return corners_[i].difference; }
    double squared(const Part& part) const {
        Vec3 point;
        for (int i = 0; i < part.count; ++i) point += at(part.corner[i]) * part.weight[i];
        return length_squared(point);
    }

    Part nearest() const {
        switch (count_) {
            case 1:
                return {1, {0}, {1}};
            case 2:
                return on_edge(0, 1);
            case 3:
                return on_face(0, 1, 2);
            default:
                return in_tetrahedron();
        }
    }
    Part on_edge(int a, int b) const {
        const Vec3 along = at(b) - at(a);
        const double t = -dot(at(a), along), square = length_squared(along);
        if (t <= 0) return {1, {a}, {1}};
        if (t >= square) return {1, {b}, {1}};
        return {2, {a, b}, {1 - t / square, t / square}};
    }
    /// By the Voronoi region of the origin's projection (Ericson 2005, 5.1.5).
    Part on_face(int a, int b, int c) const {
        const Vec3 ab = at(b) - at(a), ac = at(c) - at(a);
        const double ab_a = -dot(ab, at(a)), ac_a = -dot(ac, at(a)), ab_b = -dot(ab, at(b)), ac_b = -dot(ac, at(b)),
                     ab_c = -dot(ab, at(c)), ac_c = -dot(ac, at(c));
        const double wc = ab_a * ac_b - ab_b * ac_a, wb = ab_c * ac_a - ab_a * ac_c, wa = ab_b * ac_c - ab_c * ac_b;
        const double whole = wa + wb + wc;
        if (wa > 0 && wb > 0 && wc > 0) return {3, {a, b, c}, {wa / whole, wb / whole, wc / whole}};
        return nearer(nearer(on_edge(a, b), on_edge(a, c)), on_edge(b, c));
    }
    Part in_tetrahedron() const {
        const Vec3 from = at(3);
        const Vec3 edge[3] = {at(0) - from, at(1) - from, at(2) - from};
        const double volume = dot(cross(edge[0], edge[1]), edge[2]);
        const double product = length(edge[0]) * length(edge[1]) * length(edge[2]);
        const bool is_flat = std::fabs(volume) <= flat * product;
        Part best{0, {}, {}};
        bool inside = true;
        const int faces[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
        for (const auto& [a, b, c, opposite] : faces) {
            const Vec3 normal = cross(at(b) - at(a), at(c) - at(a));
            const double here = -dot(normal, at(a)), there = dot(normal, at(opposite) - at(a));
            if (!is_flat && ((here > 0 && there > 0) || (here < 0 && there < 0))) continue;
            const Part face = on_face(a, b, c);
            best = inside ? face : nearer(best, face);
            inside = false;
        }
        return inside ? Part{4, {0, 1, 2, 3}, {}} : best;
    }
    Part nearer(const Part& a, const Part& b) const { return squared(b) < squared(a) ? b : a; }

    Corner corners_[4];
    double weights_[4] = {1};
    int count_ = 0;
};

/// Keeps the candidate that violates the optimality condition least. Distances would not do: they may differ by less
/// than rounding where directions differ by its square root.
class ConvexDifference::BestProved {
public:
    explicit BestProved(double size) : size_(size) {}

    /// `beyond`: distance of the candidate from its supporting plane, that is, the violation.
    bool offer(const NearestDifference& candidate, double beyond) {
        if (!(beyond < beyond_)) return false;
        best_ = candidate;
        beyond_ = beyond;
        return true;
    }
    bool is_proved() const { return beyond_ <= unproved * size_; }
    bool is_exact() const { return beyond_ <= exact * size_; }
    const NearestDifference& best() const { return best_; }

private:
    NearestDifference best_;
    double size_, beyond_ = infinity;
};

NearestDifference ConvexDifference::nearest() const {
    Simplex simplex;
    simplex.add(furthest(-center_));
    BestProved found(size());
    int worse = 0;  // iterations in a row without improvement
    // A dozen iterations are many for a polytope with at most six axes. The limits bound the cycling that rounding may
    // cause.
    for (int round = 0; round < 64 && worse < 8; ++round) {
        const NearestDifference candidate = simplex.point();
        const double distance = length(candidate.offset);
        if (distance == 0) return {{}, candidate.on_other};
        const Corner corner = furthest(-candidate.offset);
        const double beyond = dot(candidate.offset, candidate.offset - corner.difference) / distance;
        worse = found.offer(candidate, beyond) ? 0 : worse + 1;
        if (found.is_exact() || !simplex.add(corner)) break;
        simplex.reduce();
        if (simplex.is_full()) return {{}, candidate.on_other};
    }
    return found.is_proved() ? found.best() : nearest_by_features();
}

/// The features of one core: at most those of a hexahedron, with two triangles for each face.
struct ConvexDifference::Features {
    Vec3 corners[8];
    Segment edges[12];
    Triangle faces[12];
    int corner_count = 0, edge_count = 0, face_count = 0;

    void extend(Vec3 center, const Vec3* axes, const double* half, int axis_count) {
        Vec3 way[3] = {};
        for (int k = 0; k < axis_count; ++k) way[k] = axes[k] * half[k];
        for (int i = 0; i < 1 << axis_count; ++i) {
            Vec3 corner = center;
            for (int k = 0; k < axis_count; ++k) corner += i >> k & 1 ? way[k] : -way[k];
            corners[corner_count++] = corner;
        }
        connect(axis_count);
    }
    /// The edges and faces between corners that are numbered as those of a box (Hexahedron).
    void connect(int axis_count) {
        for (int k = 0; k < axis_count; ++k) {
            for (int i = 0; i < corner_count; ++i) {
                if (i >> k & 1) edges[edge_count++] = {corners[i - (1 << k)], corners[i]};
            }
        }
        for (int k = 0; k < axis_count && axis_count == 3; ++k) {
            const int u = 1 << (k + 1) % 3, v = 1 << (k + 2) % 3;
            for (const int first : {0, 1 << k}) {
                faces[face_count++] = {corners[first], corners[first + u], corners[first + v]};
                faces[face_count++] = {corners[first + u], corners[first + v], corners[first + u + v]};
            }
        }
    }
};

ConvexDifference::Features ConvexDifference::features_of_other() const {
    Features result;
    if (corner_count_ == 1) {
        result.extend(other_center_, axes_, half_, other_axis_count_);
        return result;
    }
    for (int k = 0; k < corner_count_; ++k) result.corners[result.corner_count++] = other_center_ + corners()[k];
    if (hexahedron_) {
        result.connect(3);
        return result;
    }
    const auto& c = result.corners;
    for (int k = 0; k < 3; ++k) result.edges[result.edge_count++] = {c[k], c[(k + 1) % 3]};
    result.faces[result.face_count++] = {c[0], c[1], c[2]};
    return result;
}

ConvexDifference::Features ConvexDifference::features_of_moving() const {
    Features result;
    result.extend(other_center_ - center_, axes_ + other_axis_count_, half_ + other_axis_count_,
                  axis_count_ - other_axis_count_);
    return result;
}

NearestDifference ConvexDifference::nearest_by_features() const {
    const Features other = features_of_other(), moving = features_of_moving();
    BestProved found(size());
    const double equal = rounded * size();
    double shortest = infinity;
    const auto consider = [&](Vec3 on_other, Vec3 on_moving) {
        const Vec3 offset = on_other - on_moving;
        const double distance = length(offset);
        if (distance > shortest + equal) return;
        if (distance < shortest - equal) found = BestProved(size());
        shortest = std::min(shortest, distance);
        found.offer({offset, on_other}, distance > 0 ? distance - gap(offset / -distance) : 0);
    };
    for (int i = 0; i < other.corner_count; ++i) {
        const Vec3 corner = other.corners[i];
        for (int k = 0; k < moving.corner_count; ++k) consider(corner, moving.corners[k]);
        for (int k = 0; k < moving.edge_count; ++k) consider(corner, closest_point(moving.edges[k], corner));
        for (int k = 0; k < moving.face_count; ++k) consider(corner, closest_point(moving.faces[k], corner));
    }
    for (int i = 0; i < moving.corner_count; ++i) {
        const Vec3 corner = moving.corners[i];
        for (int k = 0; k < other.edge_count; ++k) consider(closest_point(other.edges[k], corner), corner);
        for (int k = 0; k < other.face_count; ++k) consider(closest_point(other.faces[k], corner), corner);
    }
    for (int i = 0; i < other.edge_count; ++i) {
        for (int k = 0; k < moving.edge_count; ++k) {
            Vec3 on_other, on_moving;
            closest_points(other.edges[i], moving.edges[k], on_other, on_moving);
            consider(on_other, on_moving);
        }
    }
    return found.best();
}

}  // namespace gphys
