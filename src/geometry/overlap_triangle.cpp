// Triangles against triangles (Guigue, Devillers 2003) and boxes (Akenine-Moeller 2001). Exact orientation signs decide
// alone, so no answer depends on scale, and contact counts as overlap. Degenerate triangles are treated as segments or
// points.
#include "foundation/exact.h"
#include "geometry/intersect.h"
#include "geometry/overlap_boxes.h"

namespace gphys {
namespace {

/// A convex set of one to three points: a point, a segment or a proper triangle.
struct Simplex {
    Vec3 corner[3];
    int count;
};

bool before(Vec3 a, Vec3 b) {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
}

Simplex simplex(const Triangle& t) {
    if (turning_axis(t.a, t.b, t.c) >= 0) return {{t.a, t.b, t.c}, 3};
    // Collinear points are sorted along their line by their coordinates.
    const Vec3 first = std::min({t.a, t.b, t.c}, before), last = std::max({t.a, t.b, t.c}, before);
    return {{first, last, last}, first == last ? 1 : 2};
}

bool boxes_apart(const Simplex& a, const Simplex& b) {
    Vec3 a_min = a.corner[0], a_max = a_min, b_min = b.corner[0], b_max = b_min;
    for (int i = 1; i < a.count; ++i) a_min = min(a_min, a.corner[i]), a_max = max(a_max, a.corner[i]);
    for (int i = 1; i < b.count; ++i) b_min = min(b_min, b.corner[i]), b_max = max(b_max, b.corner[i]);
    return !boxes_overlap(a_min, a_max, b_min, b_max);
}

/// Whether, in the projection along the axis, the line of an edge of `a` has `a` on one side and `b` strictly on the
/// other.
bool edge_separates(const Simplex& a, const Simplex& b, int axis) {
    for (int i = 0; i < a.count; ++i) {
        const Vec3 from = a.corner[i], to = a.corner[(i + 1) % a.count];
        const int own = a.count == 3 ? orientation(from, to, a.corner[(i + 2) % 3], axis) : 0;
        for (int side : {-1, 1}) {
            if (own == side) continue;
            bool apart = true;
            for (int k = 0; k < b.count && apart; ++k) apart = orientation(from, to, b.corner[k], axis) == side;
            if (apart) return true;
        }
    }
    return false;
}

/// For sets in one plane that is not parallel to the axis, with overlapping AABBs. The edges of the Minkowski
/// difference of convex polygons are parallel to those of the polygons, so if any line separates them, that of an edge
/// does. For collinear sets the AABBs have decided already.
bool coplanar_overlap(const Simplex& a, const Simplex& b, int axis) {
    return !edge_separates(a, b, axis) && !edge_separates(b, a, axis);
}

bool segments_overlap(const Simplex& a, const Simplex& b) {
    const Vec3 p = a.corner[0], q = a.corner[a.count - 1], r = b.corner[0], s = b.corner[b.count - 1];
    if (orientation(p, q, r, s) != 0) return false;
    for (const Triangle& t : {Triangle{p, q, r}, Triangle{p, q, s}, Triangle{p, r, s}}) {
        const int axis = turning_axis(t.a, t.b, t.c);
        if (axis >= 0) return coplanar_overlap(a, b, axis);
    }
    return true;  // all points are collinear
}

bool segment_overlaps_triangle(const Simplex& segment, const Simplex& triangle) {
    const auto& [p, q, r] = triangle.corner;
    const Vec3 a = segment.corner[0], b = segment.corner[segment.count - 1];
    const int side_a = orientation(p, q, r, a), side_b = orientation(p, q, r, b);
    if (side_a * side_b > 0) return false;
    if (side_a == 0 && side_b == 0) return coplanar_overlap(segment, triangle, turning_axis(p, q, r));
    // The line intersects the triangle if it has the three edges on the same side.
    const int pq = orientation(a, b, p, q), qr = orientation(a, b, q, r), rp = orientation(a, b, r, p);
    return (pq >= 0 && qr >= 0 && rp >= 0) || (pq <= 0 && qr <= 0 && rp <= 0);
}

/// The corner that is alone on its side of the other triangle's plane, and whether that plane must be flipped for the
/// corner to be in front. Corners on the plane count for either side. The signs are not all equal.
struct Alone {
    int corner;
    bool behind;
};
Alone alone(const int (&side)[3]) {
    for (int i = 0; i < 3; ++i) {
        const int own = side[i], next = side[(i + 1) % 3], last = side[(i + 2) % 3];
        if (own != 0 && own * next <= 0 && own * last <= 0) return {i, own < 0};
    }
    // One corner is on the plane, the others are on one side of it.
    const int on_plane = side[0] == 0 ? 0 : side[1] == 0 ? 1 : 2;
    return {on_plane, side[(on_plane + 1) % 3] > 0};
}

/// Guigue and Devillers 2003. Both triangles intersect the line of their planes in an interval. If the lone corners p
/// are in front, the intervals run from edge p1 q1 to p1 r1 and from p2 r2 to p2 q2. Two orientations decide whether
/// either interval ends before the other begins.
bool triangles_overlap(const Simplex& t1, const Simplex& t2) {
    int side1[3], side2[3];
    for (int i = 0; i < 3; ++i) side1[i] = orientation(t2.corner[0], t2.corner[1], t2.corner[2], t1.corner[i]);
    if (side1[0] == side1[1] && side1[1] == side1[2]) {
        return side1[0] == 0 && coplanar_overlap(t1, t2, turning_axis(t1.corner[0], t1.corner[1], t1.corner[2]));
    }
    for (int i = 0; i < 3; ++i) side2[i] = orientation(t1.corner[0], t1.corner[1], t1.corner[2], t2.corner[i]);
    if (side2[0] == side2[1] && side2[1] == side2[2]) return false;

    const Alone first = alone(side1), second = alone(side2);
    const Vec3 p1 = t1.corner[first.corner], p2 = t2.corner[second.corner];
    Vec3 q1 = t1.corner[(first.corner + 1) % 3], r1 = t1.corner[(first.corner + 2) % 3];
    Vec3 q2 = t2.corner[(second.corner + 1) % 3], r2 = t2.corner[(second.corner + 2) % 3];
    if (first.behind) std::swap(q2, r2);
    if (second.behind) std::swap(q1, r1);
    return orientation(p1, q1, p2, q2) <= 0 && orientation(p1, r1, p2, r2) >= 0;
}

}  // namespace

bool overlaps(const Triangle& a, const Triangle& b) {
    const Simplex s = simplex(a), t = simplex(b);
    if (boxes_apart(s, t)) return false;
    if (s.count == 3) return t.count == 3 ? triangles_overlap(s, t) : segment_overlaps_triangle(t, s);
    return t.count == 3 ? segment_overlaps_triangle(s, t) : segments_overlap(s, t);
}

bool overlaps(const Aabb& box, const Triangle& triangle) {
    // The separating axes of a box and a triangle (Akenine-Moeller 2001): the normals of the box, ...
    const Vec3 low = min(min(triangle.a, triangle.b), triangle.c), high = max(max(triangle.a, triangle.b), triangle.c);
    // Axis by axis: boxes_overlap, which always compares all axes, makes overlaps of a box and a mesh take 5 % longer.
    if (low.x > box.max.x || low.y > box.max.y || low.z > box.max.z || high.x < box.min.x || high.y < box.min.y ||
        high.z < box.min.z) {
        return false;
    }
    // ... the normal of the triangle, along which two opposite corners of the box are extreme, ...
    const auto& [a, b, c] = triangle;
    const Vec3 normal = accurate_cross(a, b, a, c);
    Vec3 lowest, highest;
    for (int k = 0; k < 3; ++k) {
        lowest[k] = normal[k] > 0 ? box.min[k] : box.max[k];
        highest[k] = normal[k] > 0 ? box.max[k] : box.min[k];
    }
    if (orientation(a, b, c, lowest) > 0 || orientation(a, b, c, highest) < 0) return false;
    // ... and the cross products of box axes and edges: in the projection along the box axis, the line of the edge has
    // the third corner on one side and the rectangle strictly on the other.
    const Vec3 corner[3] = {a, b, c};
    for (int axis = 0; axis < 3; ++axis) {
        const int i = (axis + 1) % 3, k = (axis + 2) % 3;
        for (int edge = 0; edge < 3; ++edge) {
            const Vec3 from = corner[edge], to = corner[(edge + 1) % 3];
            const bool i_grows = to[i] > from[i], k_grows = to[k] > from[k];
            lowest[k] = i_grows ? box.min[k] : box.max[k];
            highest[k] = i_grows ? box.max[k] : box.min[k];
            lowest[i] = k_grows ? box.max[i] : box.min[i];
            highest[i] = k_grows ? box.min[i] : box.max[i];
            const int above = orientation(from, to, lowest, axis), below = orientation(from, to, highest, axis);
            if (above <= 0 && below >= 0) continue;
            const int third = orientation(from, to, corner[(edge + 2) % 3], axis);
            if ((above > 0 && third <= 0) || (below < 0 && third >= 0)) return false;
        }
    }
    return true;
}

}  // namespace gphys
