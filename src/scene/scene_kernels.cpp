#include "scene/scene_kernels.h"

#include "octree/ray_lanes.h"

namespace gphys::GPHYS_ISA {

namespace {

void make_ray_quads(const Ray* rays, uint32_t count, RayQuads* to) {
    for (uint32_t first = 0; first < count; first += 8) {
        const Rays8 eight(rays + first, count - first);
        const auto sum_of = [](const auto(&v)[3]) { return v[0] + v[1] + v[2]; };
        Float8 head[3], rest[3], direction[3], size_of[3];
        Double8 magnitude[3];
        Double8 speed = least_speed;
        for (int k = 0; k < 3; ++k) {
            head[k] = narrowed(eight.origin[k]);
            rest[k] = narrowed(eight.origin[k] - widened(head[k]));
            magnitude[k] = absolute(eight.origin[k]);
            speed = largest(speed, absolute(eight.direction[k]));
        }
        const Double8 to_unit = 1 / speed;
        for (int k = 0; k < 3; ++k) {
            direction[k] = narrowed(eight.direction[k] * to_unit);
            size_of[k] = abs(direction[k]);
        }
        const auto at = [&](int i) -> RayQuads& { return to[first + static_cast<uint32_t>(i)]; };
        store_quads([&](int i) { return at(i).head; },
                    {head[0], head[1], head[2], narrowed(least(eight.t_max * speed, most_end))});
        store_quads([&](int i) { return at(i).rest; },
                    {rest[0], rest[1], rest[2], narrowed(slack * sum_of(magnitude))});
        store_quads([&](int i) { return at(i).direction; },
                    {direction[0], direction[1], direction[2], splat(float_slack) * sum_of(size_of)});
    }
}

struct Vector8 {
    Float8 x, y, z;
};
Vector8 operator+(const Vector8& a, const Vector8& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector8 operator-(const Vector8& a, const Vector8& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector8 operator*(Float8 s, const Vector8& a) { return {a.x * s, a.y * s, a.z * s}; }
Vector8 abs(const Vector8& a) { return {abs(a.x), abs(a.y), abs(a.z)}; }
Vector8 splat3(const float (&v)[3]) { return {splat(v[0]), splat(v[1]), splat(v[2])}; }
Float8 sum(const Vector8& a) { return a.x + a.y + a.z; }
Float8 dot(const Vector8& a, const Vector8& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector8 cross(const Vector8& a, const Vector8& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The squared length of what remains of the components above `less`.
Float8 square_beyond(const Vector8& a, Float8 less) {
    const Float8 zero = splat(0), x = max(a.x - less, zero), y = max(a.y - less, zero), z = max(a.z - less, zero);
    return x * x + y * y + z * z;
}

/// |q|^2 times a rotation, as ScaledTurn.
class Turn8 {
public:
    Turn8(const Vector8& u, Float8 w) : u_(u), w_(w), ww_(w * w), uu_(dot(u, u)) {}

    Float8 unit() const { return ww_ + uu_; }
    Vector8 operator()(const Vector8& v) const {
        return (ww_ - uu_) * v + splat(2) * (dot(u_, v) * u_ + w_ * cross(u_, v));
    }
    /// By the conjugate.
    Vector8 back(const Vector8& v) const { return (ww_ - uu_) * v + splat(2) * (dot(u_, v) * u_ + w_ * cross(v, u_)); }
    /// Lanes that leave all vectors as they are, to the last bit.
    Mask8 none() const { return has_no_vector() & (abs(w_) <= splat(1)) & (splat(1) <= abs(w_)); }
    /// Lanes that turn nothing.
    Mask8 has_no_vector() const { return sum(abs(u_)) <= splat(0); }
    /// Component i of axis j.
    void matrix(Float8 (&axis)[3][3]) const {
        const Float8 two = splat(2), rest = ww_ - uu_;
        const Float8 u[3] = {u_.x, u_.y, u_.z};
        for (int j = 0; j < 3; ++j) {
            const int next = (j + 1) % 3, previous = (j + 2) % 3;
            axis[j][j] = rest + two * (u[j] * u[j]);
            axis[j][next] = two * (u[j] * u[next] + w_ * u[previous]);
            axis[j][previous] = two * (u[j] * u[previous] - w_ * u[next]);
        }
    }

private:
    Vector8 u_;
    Float8 w_, ww_, uu_;
};

/// The placements of eight models.
struct Worlds8 {
    explicit Worlds8(const RaysAndModels<RayQuads>& pairs) : Worlds8(quads(pairs, 0), quads(pairs, 4)) {}

    Vector8 position;
    Turn8 turn;
    Float8 scale;

private:
    static Quads8 quads(const RaysAndModels<RayQuads>& pairs, int from) {
        return load_quads([&](int i) { return pairs.model[i] + from; });
    }
    Worlds8(const Quads8& a, const Quads8& b) : position{a.x, a.y, a.z}, turn({a.w, b.x, b.y}, b.z), scale(b.w) {}
};

/// Eight rays, seen from the centres of the shapes that they ask about.
struct Sight8 {
    /// `center` is in its model.
    [[gnu::always_inline]] Sight8(const RaysAndModels<RayQuads>& pairs, const Worlds8& world, const Vector8& center) {
        const Quads8 head = load_quads([&](int i) { return pairs.ray[i]->head; });
        const Quads8 rest = load_quads([&](int i) { return pairs.ray[i]->rest; });
        const Quads8 to = load_quads([&](int i) { return pairs.ray[i]->direction; });
        direction = {to.x, to.y, to.z};
        direction_slack = to.w;
        end = head.w;
        off = rest.w + splat(static_cast<float>(slack)) * sum(abs(world.position)) +
              splat(static_cast<float>(smallest_slack)) * (splat(1) + world.scale);
        from = {head.x, head.y, head.z};
        const Float8 zero = splat(0), one = splat(1);
        const Mask8 centered = sum(abs(center)) <= zero;
        if (bits(centered) != 0xff) {
            // Where a model leaves its shape as it is, the centre is as exact as it was found; the first of
            // two differences is rounded, too.
            const Vector8 scaled = world.scale * center;
            from = from - one / world.turn.unit() * world.turn(scaled);
            const Mask8 as_it_is = world.turn.none() & (world.scale <= one) & (one <= world.scale);
            const Float8 few = splat(few_roundings);
            off = off + choose(as_it_is, few, splat(float_slack)) * sum(abs(scaled)) +
                  choose(centered, zero, few * sum(abs(from)));
        }
        from = from - world.position + Vector8{rest.x, rest.y, rest.z};
    }

    Vector8 from, direction;
    Float8 end, direction_slack;
    Float8 off;  // by how much each coordinate is, besides some roundings of what is added up in the end
};

/// QuickRay::verdict of placed boxes: the same numbers and margins. `half` and `turn_back` are of boxes in
/// the world, `unit` is what that multiplies lengths by.
template <class TurnBack>
Verdicts8 rays_and_boxes(const Sight8& sight, const Vector8& half, Float8 unit, const TurnBack& turn_back) {
    const Float8 zero = splat(0);
    const Float8 margin = (splat(float_slack) * (sum(abs(sight.from)) + sum(half)) + sight.off) * unit;
    const Float8 speed_margin = sight.direction_slack * unit;
    const Vector8 height = turn_back(sight.from), climb = turn_back(sight.direction);
    const Float8 heights[3] = {height.x, height.y, height.z}, climbs[3] = {climb.x, climb.y, climb.z},
                 halves[3] = {half.x, half.y, half.z};
    Float8 near[3], far[3], slow[3], fast[3], latest[3], earliest[3];
    Mask8 may = zero <= zero, must = may, behind = splat(1) <= zero;
    for (int k = 0; k < 3; ++k) {
        const Float8 speed = abs(climbs[k]), reach = halves[k] * unit;
        const Float8 to_center = choose(zero <= climbs[k], zero - heights[k], heights[k]);
        slow[k] = max(speed - speed_margin, zero);
        fast[k] = speed + speed_margin;
        near[k] = to_center - reach - margin;
        far[k] = to_center + reach + margin;
        latest[k] = max(to_center - reach + margin, zero);
        earliest[k] = to_center + reach - margin;
        may = may & (zero <= far[k]) & (near[k] <= sight.end * fast[k]);
        must = must & (latest[k] <= sight.end * slow[k]);
        behind = behind | (earliest[k] <= zero);
    }
    for (int k = 0; k < 3; ++k) {
        for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
            may = may & (near[k] * slow[other] <= far[other] * fast[k]);
            must = must & (latest[k] * fast[other] <= earliest[other] * slow[k]);
        }
    }
    return {bits(may) ^ 0xff, bits(must) & (bits(behind) ^ 0xff)};
}

Verdicts8 rays_and_aabbs(const RaysAndModels<RayQuads>& pairs) {
    const Quads8 a = load_quads([&](int i) { return pairs.model[i] + shape_at; });
    const Quads8 b = load_quads([&](int i) { return pairs.model[i] + shape_at + 2; });
    const Vector8 low{a.x, a.y, a.z}, high{b.y, b.z, b.w};
    const Worlds8 world(pairs);
    const Sight8 sight(pairs, world, splat(0.5f) * (low + high));
    return rays_and_boxes(sight, splat(0.5f) * world.scale * (high - low), world.turn.unit(),
                          [&](const Vector8& v) { return world.turn.back(v); });
}

Verdicts8 rays_and_obbs(const RaysAndModels<RayQuads>& pairs) {
    const Quads8 a = load_quads([&](int i) { return pairs.model[i] + shape_at; });
    const Quads8 b = load_quads([&](int i) { return pairs.model[i] + shape_at + 2; });
    const Quads8 q = load_quads([&](int i) { return pairs.other[i]; });
    const Worlds8 world(pairs);
    const Turn8 turn({q.x, q.y, q.z}, q.w);
    const Sight8 sight(pairs, world, {a.x, a.y, a.z});
    return rays_and_boxes(sight, world.scale * Vector8{b.y, b.z, b.w}, world.turn.unit() * turn.unit(),
                          [&](const Vector8& v) { return turn.back(world.turn.back(v)); });
}

/// Whether the point of a ray that is closest to the centre, between its origin and its end, is certainly
/// outside, or inside (as Haines et al. 2019 find a sphere, so that little is lost far away).
///
/// Let u = 2^-24, and s the sum of the coordinates of where the ray comes from. With a direction of largest
/// component 1, the way to the closest point is off by 10 u s and three times what these coordinates are
/// off by; the point itself on each axis by that, by 5 u s, and once more by the coordinates. float_slack is
/// 128 u.
Verdicts8 rays_and_spheres(const RaysAndModels<RayQuads>& pairs) {
    const Quads8 sphere = load_quads([&](int i) { return pairs.other[i]; });
    const Worlds8 world(pairs);
    const Sight8 sight(pairs, world, {sphere.x, sphere.y, sphere.z});
    const Float8 zero = splat(0), radius = world.scale * sphere.w;
    const Float8 margin = splat(float_slack) * (sum(abs(sight.from)) + radius) + splat(4) * sight.off;
    // Of a ray without direction, one.
    const Float8 squared = max(dot(sight.direction, sight.direction), splat(1));
    const Float8 way = min(max((zero - dot(sight.from, sight.direction)) / squared, zero), sight.end);
    const Vector8 closest = abs(sight.from + way * sight.direction);
    const Float8 limit = radius * radius, above = limit * splat(1 + square_slack) + splat(smallest_square);
    const Float8 below = limit * splat(1 - square_slack), least = splat(smallest_square);
    return {bits(square_beyond(closest, margin) <= above) ^ 0xff,
            bits(below <= square_beyond(closest, zero - margin) + least) ^ 0xff};
}

/// Eight models that are Aabbs, as a point sees them: by the numbers and margins of BoxInSight (quick_shape.h).
struct Boxes8 {
    Boxes8(const float* quads, const uint32_t* first_quad, const SeenFrom& point)
        : Boxes8(quad(quads, first_quad, 0), quad(quads, first_quad, 1), quad(quads, first_quad, 2),
                 quad(quads, first_quad, 3), point) {}

    Vector8 half, from;  // on the axes of the world, the point from the centre
    Turn8 turn;
    Float8 margin;      // of each coordinate
    uint32_t centered;  // those about their origins; of the others nothing is known

private:
    Boxes8(const Quads8& a, const Quads8& b, const Quads8& c, const Quads8& d, const SeenFrom& point)
        : turn({a.w, b.x, b.y}, b.z) {
        const Vector8 position{a.x, a.y, a.z}, low{c.z, c.w, d.x}, high{d.y, d.z, d.w};
        const Float8 scale = b.w;
        centered = bits(equal_bits(splat(0) - low.x, high.x) & equal_bits(splat(0) - low.y, high.y) &
                        equal_bits(splat(0) - low.z, high.z));
        half = (splat(0.5f) * scale) * (high - low);
        from = splat3(point.head) - position + splat3(point.rest);
        const Float8 half_sum = sum(half), sums = sum(abs(position)) + half_sum;
        margin = splat(float_slack) * (sum(abs(from)) + half_sum) + splat(static_cast<float>(slack)) * sums +
                 splat(point.slack) + splat(static_cast<float>(smallest_slack)) * (splat(1) + scale);
    }
    static Quads8 quad(const float* quads, const uint32_t* first_quad, uint32_t number) {
        uint32_t index[8];
        for (int i = 0; i < 8; ++i) index[i] = first_quad[i] + number;
        return load_quads(quads, index);
    }
};

/// QuickPoint of the placed boxes: the same numbers and margins.
Verdicts8 boxes_near(const float* quads, const uint32_t* first_quad, const BallLanes& ball) {
    const Boxes8 boxes(quads, first_quad, ball.center);
    const Float8 unit = boxes.turn.unit();
    const Vector8 outside = abs(boxes.turn.back(boxes.from)) - unit * boxes.half;
    const Float8 scaled_margin = boxes.margin * unit, far = splat(ball.reach) * unit, limit = far * far;
    const Float8 at_least = square_beyond(outside, scaled_margin),
                 at_most = square_beyond(outside, splat(0) - scaled_margin);
    const Float8 above = limit * splat(1 + square_slack) + splat(smallest_square);
    const uint32_t no = bits(at_least <= above) ^ 0xff;
    const uint32_t yes = bits(limit * splat(1 - square_slack) <= at_most + splat(smallest_square)) ^ 0xff;
    return {no & boxes.centered, yes & boxes.centered};
}

/// The separating axes of QuickBlock, where the query is parallel to the axes of the world. Axes across an edge of each
/// are none where those are parallel, as in models that are not turned at all: to these the others are enough.
///
/// A component of an axis is off by at most 18 roundings of 2^-24 of `unit`: six, of numbers that add up to three times
/// that. What is added up of such components and distances takes five more. float_slack stands for 128.
Verdicts8 boxes_in_block(const float* quads, const uint32_t* first_quad, const BlockLanes& block) {
    const Boxes8 boxes(quads, first_quad, block.center);
    const Float8 unit = boxes.turn.unit();
    const Vector8 sizes = splat3(block.half);
    const Float8 offset[3] = {boxes.from.x, boxes.from.y, boxes.from.z};
    const Float8 own[3] = {sizes.x, sizes.y, sizes.z}, half[3] = {boxes.half.x, boxes.half.y, boxes.half.z};
    Float8 axis[3][3], size[3][3];  // component i of axis j, times unit
    boxes.turn.matrix(axis);
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) size[j][i] = abs(axis[j][i]);
    }
    const Float8 margin = unit * (boxes.margin + splat(float_slack) * sum(sizes));

    Float8 gap = splat(-std::numeric_limits<float>::max()), across = gap;  // the widest between them
    for (int k = 0; k < 3; ++k) {
        const Float8 reach = size[0][k] * half[0] + size[1][k] * half[1] + size[2][k] * half[2];
        const Float8 here = (abs(offset[k]) - own[k]) * unit - reach;
        const Float8 along = axis[k][0] * offset[0] + axis[k][1] * offset[1] + axis[k][2] * offset[2];
        const Float8 of_query = size[k][0] * own[0] + size[k][1] * own[1] + size[k][2] * own[2];
        const Float8 there = abs(along) - half[k] * unit - of_query;
        gap = max(gap, max(here, there));
    }
    for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        for (int j = 0; j < 3; ++j) {
            const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const Float8 distance = abs(offset[i2] * axis[j][i1] - offset[i1] * axis[j][i2]);
            const Float8 reach =
                own[i1] * size[j][i2] + own[i2] * size[j][i1] + half[j1] * size[j2][i] + half[j2] * size[j1][i];
            across = max(across, distance - reach);
        }
    }
    gap = choose(boxes.turn.has_no_vector(), gap, max(gap, across));
    const uint32_t no = bits(gap <= margin) ^ 0xff, yes = bits(splat(0) - margin <= gap) ^ 0xff;
    return {no & boxes.centered, yes & boxes.centered};
}

}  // namespace

extern const SceneKernels scene_kernels{make_ray_quads, rays_and_spheres, rays_and_aabbs,
                                        rays_and_obbs,  boxes_near,       boxes_in_block};

}  // namespace gphys::GPHYS_ISA
