// The convex hull of points by quickhull with exact predicates (convex_hull.h).
#include "mesh/convex_hull.h"

#include <algorithm>

#include "foundation/exact.h"

namespace gphys {
namespace {

/// A convex polyhedron with that many faces has at most this many vertices (Euler's formula).
constexpr uint32_t most_vertices = 2 * most_hull_faces - 4;

bool before(Vec3 a, Vec3 b) {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

struct Facet {
    uint32_t corner[3];
    bool gone = false;
};

/// A directed edge of a facet, as the undirected edge that it shares with the facet beside it.
struct Side {
    uint32_t low, high, facet;

    bool operator<(const Side& other) const {
        if (low != other.low) return low < other.low;
        return high != other.high ? high < other.high : facet < other.facet;
    }
};

class HullBuilder {
public:
    HullBuilder(const MeshArrays& arrays, std::pmr::memory_resource* memory)
        : points_(memory), heights_(memory), facets_(memory), visible_(memory), horizon_(memory) {
        points_.reserve(arrays.vertex_count);
        for (uint32_t i = 0; i < arrays.vertex_count; ++i) points_.push_back(widen(arrays.vertex(i)));
        heights_.resize(points_.size());
    }

    HullDefect build() {
        if (points_.empty() || !begin()) return HullDefect::flat;
        uint32_t vertices = 4;
        // A facet without points above it is final. So each facet is tested once.
        for (uint32_t i = 0; i < facets_.size(); ++i) {
            if (facets_[i].gone) continue;
            const uint32_t top = highest_above(facets_[i]);
            if (side(facets_[i], top) <= 0) continue;
            if (++vertices > most_vertices) return HullDefect::too_many_faces;
            add(top, i);
        }
        return HullDefect::none;
    }

    HullDefect write(HullSurface& out) {
        const uint32_t last = static_cast<uint32_t>(facets_.size());
        uint32_t live = 0;
        for (uint32_t i = 0; i < last; ++i) {
            if (!facets_[i].gone) facets_[live++] = facets_[i];
        }
        facets_.resize(live);
        Vector<uint32_t> face(live, none, heights_.get_allocator());
        const uint32_t faces = number_faces(face);
        if (faces > most_hull_faces) return HullDefect::too_many_faces;

        Vector<uint32_t> vertex(points_.size(), none, heights_.get_allocator());
        for (const Facet& facet : facets_) {
            for (const uint32_t corner : facet.corner) vertex[corner] = 0;
        }
        for (uint32_t i = 0; i < vertex.size(); ++i) {
            if (vertex[i] == none) continue;
            vertex[i] = static_cast<uint32_t>(out.vertices.size());
            out.vertices.push_back(narrow(points_[i]));
        }
        for (uint32_t number = 0; number < faces; ++number) {
            for (uint32_t i = 0; i < live; ++i) {
                if (face[i] != number) continue;
                for (const uint32_t corner : facets_[i].corner) out.indices.push_back(vertex[corner]);
            }
        }
        return HullDefect::none;
    }

private:
    static constexpr uint32_t none = 0xffffffffu;

    /// > 0: the point is above the facet, that is, outside.
    int side(const Facet& facet, uint32_t point) const {
        return orientation(points_[facet.corner[0]], points_[facet.corner[1]], points_[facet.corner[2]],
                           points_[point]);
    }

    /// The index of the greatest point by less(one, other); of equal points the first.
    template <class Less>
    uint32_t greatest(const Less& less) const {
        uint32_t best = 0;
        for (uint32_t i = 1; i < points_.size(); ++i) {
            if (less(points_[best], points_[i])) best = i;
        }
        return best;
    }

    /// The first tetrahedron, of four vertices of the hull. False if all points lie in one plane.
    bool begin() {
        const uint32_t a = greatest([](Vec3 p, Vec3 q) { return before(q, p); }), b = greatest(before);
        const Vec3 from = points_[a], to = points_[b];
        // In a projection along an axis: the point farthest from the line on one side, or, if there is none, on the
        // other.
        uint32_t c = a;
        const auto is_beside = [&](int axis, int sign) {
            c = greatest([&](Vec3 p, Vec3 q) {
                const int further = sign * turn(from, to, p, q, axis);
                return further != 0 ? further > 0 : before(p, q);
            });
            return orientation(from, to, points_[c], axis) != 0;
        };
        bool found = false;
        for (int axis = 0; axis < 3 && !found; ++axis) found = is_beside(axis, 1) || is_beside(axis, -1);
        if (!found) return false;
        Facet base{{a, b, c}};
        uint32_t d = highest_above(base);
        if (side(base, d) <= 0) {
            std::swap(base.corner[1], base.corner[2]);
            d = highest_above(base);
        }
        if (side(base, d) <= 0) return false;
        const uint32_t* const corner = base.corner;
        // `corner` faces d, so the base is turned over to face outward.
        facets_ = {{{corner[0], corner[2], corner[1]}},
                   {{corner[0], corner[1], d}},
                   {{corner[1], corner[2], d}},
                   {{corner[2], corner[0], d}}};
        return true;
    }

    /// Sign of component `axis` of cross(b - a, q - p).
    static int turn(Vec3 a, Vec3 b, Vec3 p, Vec3 q, int axis) {
        const int i = (axis + 1) % 3, k = (axis + 2) % 3;
        return sign_of([&](auto number) {
            using N = decltype(number);
            return (N(b[i]) - N(a[i])) * (N(q[k]) - N(p[k])) - (N(b[k]) - N(a[k])) * (N(q[i]) - N(p[i]));
        });
    }

    /// The point farthest along the normal of the facet. Of several such points the last by coordinates, which is a
    /// vertex of the hull of those points.
    uint32_t highest_above(const Facet& facet) {
        const Vec3 a = points_[facet.corner[0]], b = points_[facet.corner[1]], c = points_[facet.corner[2]];
        const Vec3 ab = b - a, ac = c - a, normal = cross(ab, ac);
        double highest = -infinity;
        Vec3 reach;
        for (size_t i = 0; i < points_.size(); ++i) {
            const Vec3 from = points_[i] - a;
            reach = max(reach, abs(from));
            heights_[i] = dot(normal, from);
            highest = std::max(highest, heights_[i]);
        }
        // A height has fewer than ten roundings of 2^-53 of these products.
        const Vec3 permanent{std::fabs(ab.y * ac.z) + std::fabs(ab.z * ac.y),
                             std::fabs(ab.z * ac.x) + std::fabs(ab.x * ac.z),
                             std::fabs(ab.x * ac.y) + std::fabs(ab.y * ac.x)};
        const double least = highest - 0x1p-48 * dot(permanent, reach);
        uint32_t best = none;
        for (uint32_t i = 0; i < points_.size(); ++i) {
            if (heights_[i] < least || (best != none && points_[i] == points_[best])) continue;
            if (best == none || is_further(a, b, c, points_[best], points_[i])) best = i;
        }
        return best;
    }

    static bool is_further(Vec3 a, Vec3 b, Vec3 c, Vec3 p, Vec3 q) {
        const int further = sign_of([&](auto number) {
            using V = Vec<decltype(number)>;
            return dot(cross(V::difference(b, a), V::difference(c, a)), V::difference(q, p));
        });
        return further != 0 ? further > 0 : before(p, q);
    }

    /// Adds a point: removes the facets that it is above, and joins it to the edges of the horizon around them. No
    /// facet before `first` is below the point. A facet whose plane holds the point stays, and gets a coplanar
    /// neighbour. No new facet has zero area: a point on the line of an edge is in the planes of both facets at the
    /// edge.
    void add(uint32_t point, uint32_t first) {
        visible_.clear();
        horizon_.clear();
        for (uint32_t i = first; i < facets_.size(); ++i) {
            if (facets_[i].gone || side(facets_[i], point) <= 0) continue;
            facets_[i].gone = true;
            visible_.push_back(i);
        }
        for (const uint32_t i : visible_) add_sides(i, horizon_);
        std::sort(horizon_.begin(), horizon_.end());
        for (size_t i = 0; i < horizon_.size(); ++i) {
            const Side& here = horizon_[i];
            if (i + 1 < horizon_.size() && horizon_[i + 1].low == here.low && horizon_[i + 1].high == here.high) {
                ++i;
                continue;
            }
            const bool upward = has_directed(facets_[here.facet], here.low, here.high);
            facets_.push_back({{upward ? here.low : here.high, upward ? here.high : here.low, point}});
        }
    }

    void add_sides(uint32_t facet, Vector<Side>& sides) const {
        for (int k = 0; k < 3; ++k) {
            const uint32_t a = facets_[facet].corner[k], b = facets_[facet].corner[(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), facet});
        }
    }
    static bool has_directed(const Facet& facet, uint32_t from, uint32_t to) {
        for (int k = 0; k < 3; ++k) {
            if (facet.corner[k] == from && facet.corner[(k + 1) % 3] == to) return true;
        }
        return false;
    }

    /// Numbers the faces: adjacent coplanar facets belong to one face. Returns the number of faces.
    uint32_t number_faces(Vector<uint32_t>& face) {
        horizon_.clear();
        for (uint32_t i = 0; i < facets_.size(); ++i) add_sides(i, horizon_);
        std::sort(horizon_.begin(), horizon_.end());
        uint32_t faces = 0;
        for (uint32_t i = 0; i < facets_.size(); ++i) {
            if (face[i] != none) continue;
            face[i] = faces;
            for (bool grows = true; grows;) {
                grows = false;
                for (size_t s = 0; s + 1 < horizon_.size(); s += 2) {  // both sides of each edge
                    const uint32_t one = horizon_[s].facet, other = horizon_[s + 1].facet;
                    if ((face[one] == faces) == (face[other] == faces) || !are_coplanar(facets_[i], one, other)) {
                        continue;
                    }
                    face[one] = face[other] = faces;
                    grows = true;
                }
            }
            ++faces;
        }
        return faces;
    }
    bool are_coplanar(const Facet& plane, uint32_t one, uint32_t other) const {
        const auto in_plane = [&](uint32_t corner) { return side(plane, corner) == 0; };
        const Facet &a = facets_[one], &b = facets_[other];
        return std::all_of(a.corner, a.corner + 3, in_plane) && std::all_of(b.corner, b.corner + 3, in_plane);
    }

    Vector<Vec3> points_;
    Vector<double> heights_;
    Vector<Facet> facets_;
    Vector<uint32_t> visible_;
    Vector<Side> horizon_;
};

}  // namespace

HullDefect make_hull(const MeshArrays& points, HullSurface& out) {
    HullBuilder builder(points, out.vertices.get_allocator().resource());
    const HullDefect defect = builder.build();
    return defect == HullDefect::none ? builder.write(out) : defect;
}

}  // namespace gphys
