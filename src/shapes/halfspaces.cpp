// Intersections of half-spaces by Helly's theorem and Farkas' lemma on exact determinants (halfspaces.h), and the
// bounding box of a frustum by enumeration of its corners.
#include "shapes/halfspaces.h"

#include "foundation/compiler.h"
#include "foundation/exact.h"

namespace gphys {

void Halfspaces::add(const Aabb& box) {
    for (int k = 0; k < 3; ++k) {
        Vec3 axis;
        axis[k] = 1;
        halfspace_[count_++] = {axis, box.min, 0};
        halfspace_[count_++] = {-axis, box.max, 0};
    }
}

void Halfspaces::add(const Obb& box) {
    const Vec3 axes[3] = {box.axes.x, box.axes.y, box.axes.z};
    for (int k = 0; k < 3; ++k) {
        halfspace_[count_++] = {axes[k], box.center, -box.half[k]};
        halfspace_[count_++] = {-axes[k], box.center, -box.half[k]};
    }
}

void Halfspaces::add(const Frustum& frustum) {
    for (const Plane& plane : frustum.planes) {
        if (plane.normal == Vec3{}) continue;  // infinite far plane
        halfspace_[count_++] = {plane.normal, frustum.origin, plane.distance};
    }
}

void Halfspaces::add(const Plane& plane) { halfspace_[count_++] = {plane.normal, {}, plane.distance}; }

namespace {

template <class N>
N height_over(const Halfspace& halfspace, Vec3 point) {
    return height_of<N>(halfspace.normal, point, halfspace.origin) - N(halfspace.distance);
}

/// The common sign of weights that are all >= 0 or all <= 0, and not all 0; else 0.
int common_sign(const int* signs, int count) {
    int sign = 0;
    for (int i = 0; i < count; ++i) {
        if (signs[i] * sign < 0) return 0;
        if (signs[i] != 0) sign = signs[i];
    }
    return sign;
}

}  // namespace

/// The determinants of all triples of normals, with exact signs. most: of half-spaces.
template <int most>
struct Halfspaces::Minors {
    explicit Minors(const Halfspaces& set) : count(set.count_) {
        std::copy(set.halfspace_, set.halfspace_ + count, halfspaces);
        compute();
        if (spans || count == 0) return;
        // All normals lie in a plane. Three more directions make them span space; a proof of emptiness must give these
        // the weight 0.
        for (Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) halfspaces[count++] = {axis, {}, 0};
        compute();
        spans = false;
    }

    /// Number of i < j < k among all such triples.
    static int triple(int i, int j, int k) { return k * (k - 1) * (k - 2) / 6 + j * (j - 1) / 2 + i; }

    /// Signs of the weights of halfspaces i < j < k < l: minors of the other three, alternating.
    void weights(int i, int j, int k, int l, int out[4]) const {
        out[0] = sign[triple(j, k, l)];
        out[1] = -sign[triple(i, k, l)];
        out[2] = sign[triple(i, j, l)];
        out[3] = -sign[triple(i, j, k)];
    }

    /// Sign of the sum of weights times heights.
    int weighted_height(int i, int j, int k, int l) const {
        const Bounded rounded = value[triple(j, k, l)] * height[i] - value[triple(i, k, l)] * height[j] +
                                value[triple(i, j, l)] * height[k] - value[triple(i, j, k)] * height[l];
        if (rounded.certain()) return rounded.sign();
        const Halfspace &a = halfspaces[i], &b = halfspaces[j], &c = halfspaces[k], &d = halfspaces[l];
        // A statement for each term, which takes less stack than one sum.
        Exact sum = term(b, c, d, a);
        sum = sum - term(a, c, d, b);
        sum = sum + term(a, b, d, c);
        return (sum - term(a, b, c, d)).sign();
    }

    /// The reference point of heights. Any point would do; a point of the set itself keeps the numbers small.
    Vec3 reference() const { return halfspaces[0].origin; }
    bool proves_empty(int i, int j, int k, int l) const {
        int weight[4];
        weights(i, j, k, l, weight);
        const int direction = common_sign(weight, 4);
        if (direction == 0) return false;
        const int member[4] = {i, j, k, l};
        for (int m = 0; m < 4; ++m) {
            if (member[m] >= bounding() && weight[m] != 0) return false;
        }
        return weighted_height(i, j, k, l) * direction < 0;
    }
    /// The half-spaces of the set; after them come the directions added to span space.
    int bounding() const { return spans ? count : count - 3; }

    static constexpr int max_count = most + 3;
    int count;
    bool spans = false;
    Halfspace halfspaces[max_count];
    Bounded height[max_count];
    int8_t sign[max_count * (max_count - 1) * (max_count - 2) / 6];  // by triple
    Bounded value[max_count * (max_count - 1) * (max_count - 2) / 6];

private:
    /// The determinant of three normals, times the height over the fourth half-space.
    Exact term(const Halfspace& a, const Halfspace& b, const Halfspace& c, const Halfspace& d) const {
        return determinant_of<Exact>(a.normal, b.normal, c.normal) * height_over<Exact>(d, reference());
    }
    /// With the exact sign. Opposite faces of boxes, and near and far planes, need no sum.
    static Bounded volume(Vec3 a, Vec3 b, Vec3 c) {
        if (a == -b || b == -c || c == -a) return Bounded(0);
        const Bounded rounded = determinant_of<Bounded>(a, b, c);
        if (rounded.certain()) return rounded;
        const double exact = determinant_of<Exact>(a, b, c).value();
        return {exact, rounding * std::fabs(exact)};
    }

    void compute() {
        for (int i = 0; i < count; ++i) height[i] = height_over<Bounded>(halfspaces[i], reference());
        int t = 0;  // triple(i, j, k)
        for (int k = 2; k < count; ++k) {
            for (int j = 1; j < k; ++j) {
                for (int i = 0; i < j; ++i, ++t) {
                    value[t] = volume(halfspaces[i].normal, halfspaces[j].normal, halfspaces[k].normal);
                    sign[t] = static_cast<int8_t>(value[t].sign());
                    spans = spans || sign[t] != 0;
                }
            }
        }
    }
};

template <int most>
GPHYS_NOINLINE bool Halfspaces::every_four_of_few_intersect() const {
    const Minors<most> minors(*this);
    for (int i = 0; i < minors.count; ++i) {
        for (int j = i + 1; j < minors.count; ++j) {
            for (int k = j + 1; k < minors.count; ++k) {
                for (int l = k + 1; l < minors.count; ++l) {
                    if (minors.proves_empty(i, j, k, l)) return false;
                }
            }
        }
    }
    return true;
}

bool Halfspaces::every_four_intersect() const {
    return count_ <= frustum_planes ? every_four_of_few_intersect<frustum_planes>()
                                    : every_four_of_few_intersect<capacity>();
}

bool Halfspaces::contain(Vec3 point) const {
    for (int i = 0; i < count_; ++i) {
        const auto height = [&](auto number) { return height_over<decltype(number)>(halfspace_[i], point); };
        if (sign_of(height) < 0) return false;
    }
    return true;
}

CommonPoint Halfspaces::likely_common_point() const {
    const Vec3 from = halfspace_[0].origin;
    Plane planes[capacity];
    double size = 0;
    for (int i = 0; i < count_; ++i) {
        const Halfspace& h = halfspace_[i];
        planes[i] = scaled_to_one({h.normal, h.distance + dot(h.normal, h.origin - from)});
        size = std::max(size, max_component(abs(h.origin - from)) + std::fabs(planes[i].distance));
    }
    // Rounding may put a point on the boundary outside.
    for (int i = 0; i < count_; ++i) planes[i].distance += 0x1p-40 * size;
    return nearest_common_point(planes, count_);
}

bool Halfspaces::have_common_point() const {
    if (count_ == 0) return true;
    const CommonPoint likely = likely_common_point();
    if (likely.outcome == CommonPoint::Outcome::found && contain(halfspace_[0].origin + likely.point)) return true;
    if (likely.outcome == CommonPoint::Outcome::none) {
        Halfspaces few;
        for (int i = 0; i < likely.plane_count; ++i) few.halfspace_[few.count_++] = halfspace_[likely.planes[i]];
        if (!few.every_four_intersect()) return false;
    }
    return every_four_intersect();
}

namespace {

/// The points (s, t) with u s + v t + height >= 0: a half-space in the plane of a triangle whose points are a + s (b -
/// a) + t (c - a). For a degenerate triangle u or v is 0, which is handled in the same way.
template <class N>
struct Halfplane {
    N u, v, height;
};

template <class N>
Halfplane<N> restricted(const Halfspace& halfspace, const Triangle& triangle) {
    using V = Vec<N>;
    const V normal = V::of(halfspace.normal);
    return {dot(normal, V::difference(triangle.b, triangle.a)), dot(normal, V::difference(triangle.c, triangle.a)),
            height_over<N>(halfspace, triangle.a)};
}

template <class N>
N minor(const Halfplane<N>& a, const Halfplane<N>& b) {
    return a.u * b.v - a.v * b.u;
}
template <class N>
N weighted_height(const Halfplane<N>& a, const Halfplane<N>& b, const Halfplane<N>& c) {
    return minor(b, c) * a.height - minor(a, c) * b.height + minor(a, b) * c.height;
}

/// The half-planes of a triangle's edges and of the half-spaces that cut it.
class CutTriangle {
public:
    CutTriangle(const Halfspace* halfspaces, int count, const Triangle& triangle)
        : halfspaces_(halfspaces), triangle_(triangle), count_(count + 3) {
        for (int i = 0; i < count_; ++i) rounded_[i] = halfplane<Bounded>(i);
    }

    bool is_empty() const {
        for (int i = 0; i < count_; ++i) {
            for (int j = i + 1; j < count_; ++j) {
                for (int k = j + 1; k < count_; ++k) {
                    const int weight[3] = {minor_sign(j, k), -minor_sign(i, k), minor_sign(i, j)};
                    const int direction = common_sign(weight, 3);
                    if (direction != 0 && height_sign(i, j, k) * direction < 0) return true;
                }
            }
        }
        return false;
    }

private:
    template <class N>
    Halfplane<N> halfplane(int i) const {
        switch (i) {
            case 0:
                return {N(1.0), N(0.0), N(0.0)};  // s >= 0
            case 1:
                return {N(0.0), N(1.0), N(0.0)};  // t >= 0
            case 2:
                return {N(-1.0), N(-1.0), N(1.0)};  // s + t <= 1
            default:
                return restricted<N>(halfspaces_[i - 3], triangle_);
        }
    }
    int minor_sign(int i, int j) const {
        const Bounded rounded = minor(rounded_[i], rounded_[j]);
        return rounded.certain() ? rounded.sign() : minor(halfplane<Exact>(i), halfplane<Exact>(j)).sign();
    }
    int height_sign(int i, int j, int k) const {
        const Bounded rounded = weighted_height(rounded_[i], rounded_[j], rounded_[k]);
        if (rounded.certain()) return rounded.sign();
        return weighted_height(halfplane<Exact>(i), halfplane<Exact>(j), halfplane<Exact>(k)).sign();
    }

    const Halfspace* halfspaces_;
    const Triangle& triangle_;
    int count_;
    Halfplane<Bounded> rounded_[12 + 3];
};

}  // namespace

bool Halfspaces::intersect(const Triangle& triangle) const {
    return !CutTriangle(halfspace_, count_, triangle).is_empty();
}

bool is_empty(const Frustum& frustum) {
    Halfspaces set;
    set.add(frustum);
    return !set.have_common_point();
}

namespace {

/// Tests the half-spaces 0..count - 1 other than i, j, k until one fails.
template <class Test>
bool all_others(int count, int i, int j, int k, Test&& test) {
    for (int l = 0; l < count; ++l) {
        if (l != i && l != j && l != k && !test(l)) return false;
    }
    return true;
}

}  // namespace

bool bounds(const Frustum& frustum, Box& out) {
    out = Box{};
    Halfspaces set;
    set.add(frustum);
    return !set.have_common_point() || Halfspaces::bounds_of_nonempty(set, frustum.origin, out);
}

/// Not inlined, so that the minors are on the stack only when those of have_common_point are gone.
GPHYS_NOINLINE bool Halfspaces::bounds_of_nonempty(const Halfspaces& set, Vec3 origin, Box& out) {
    const Minors<frustum_planes> minors(set);
    if (!minors.spans) return false;

    const auto triple_sign = [&](int i, int j, int l) -> int {
        if (l > j) return minors.sign[minors.triple(i, j, l)];
        return l > i ? -minors.sign[minors.triple(i, l, j)] : minors.sign[minors.triple(l, i, j)];
    };
    Box box;
    for (int i = 0; i < minors.count; ++i) {
        for (int j = i + 1; j < minors.count; ++j) {
            const Plane a{minors.halfspaces[i].normal, minors.halfspaces[i].distance};
            const Plane b{minors.halfspaces[j].normal, minors.halfspaces[j].distance};
            // The line of two planes is unbounded if no other plane cuts it. Parallel planes have no line; if the
            // normals span space, another pair has one.
            if (accurate_cross({}, a.normal, {}, b.normal) != Vec3{}) {
                for (int way : {-1, 1}) {
                    if (all_others(minors.count, i, j, -1, [&](int l) { return way * triple_sign(i, j, l) >= 0; })) {
                        return false;
                    }
                }
            }
            for (int k = j + 1; k < minors.count; ++k) {
                if (minors.sign[minors.triple(i, j, k)] == 0) continue;
                const bool is_corner = all_others(minors.count, i, j, k, [&](int l) {
                    int m[4] = {i, j, k, l};
                    std::sort(m, m + 4);
                    int weight[4];
                    minors.weights(m[0], m[1], m[2], m[3], weight);
                    const int own = static_cast<int>(std::find(m, m + 4, l) - m);
                    return weight[own] * minors.weighted_height(m[0], m[1], m[2], m[3]) >= 0;
                });
                if (!is_corner) continue;
                Vec3 corner;
                common_point(a, b, {minors.halfspaces[k].normal, minors.halfspaces[k].distance}, corner);
                // common_point has a relative error below 2^-42; adding the origin rounds 2^-53 of the sum.
                const Vec3 place = origin + corner;
                const Vec3 slack = abs(corner) * 0x1p-42 + abs(place) * 0x1p-52;
                for (int axis = 0; axis < 3; ++axis) {
                    box.min[axis] = std::min(box.min[axis], round_down(place[axis] - slack[axis]));
                    box.max[axis] = std::max(box.max[axis], round_up(place[axis] + slack[axis]));
                }
            }
        }
    }
    out = box;
    return true;
}

}  // namespace gphys
