// Intersections of half-spaces, decided exactly: overlaps of a frustum (bounded or not) with boxes, planes, triangles
// and other frusta.
//
// Helly's theorem: finitely many half-spaces of 3-space have a common point if every four of them have one, and
// half-planes if every three have one. Four half-spaces n_i.x + h_i >= 0 have none if and only if some weights w_i >= 0
// give sum w_i n_i = 0 and sum w_i h_i < 0 (Farkas' lemma). If the normals span space, those weights are, up to a
// factor, the minors of the matrix of normals. So every decision is the sign of a determinant. No corners are computed,
// and unbounded sets are no special case.
#pragma once

#include "shapes/nearest_common_point.h"

namespace gphys {

/// The points x with dot(normal, x - origin) >= distance.
struct Halfspace {
    Vec3 normal, origin;
    double distance;
};

class Halfspaces {
public:
    void add(const Aabb& box);
    void add(const Obb& box);
    void add(const Frustum& frustum);
    /// The half-space of a plane: the points on it and in front of it.
    void add(const Plane& plane);

    bool have_common_point() const;
    bool intersect(const Triangle& triangle) const;

private:
    /// The exact decision, by Helly's theorem.
    bool every_four_intersect() const;
    template <int most>
    bool every_four_of_few_intersect() const;
    bool contain(Vec3 point) const;
    /// A common point, or none, computed in double. Relative to the origin of the first half-space.
    CommonPoint likely_common_point() const;

    friend bool bounds(const Frustum& frustum, Box& out);
    template <int most>
    struct Minors;
    static bool bounds_of_nonempty(const Halfspaces& set, Vec3 origin, Box& out);

    static constexpr int capacity = 12, frustum_planes = 6;
    int count_ = 0;
    Halfspace halfspace_[capacity];
};

bool is_empty(const Frustum& frustum);

/// The smallest float box around a frustum; an empty Box for an empty frustum. Returns false if it is infinite.
bool bounds(const Frustum& frustum, Box& out);
/// The same box, or one hardly larger, for a body of six sides of which 0 and 1, 2 and 3, 4 and 5 are opposite, such as
/// the view of a camera. Takes a hundredth of the time. Returns false where the result is not certain.
bool bounds_of_six_sided(const Frustum& frustum, Box& out);

}  // namespace gphys
