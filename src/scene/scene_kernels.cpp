// The kernels of scene_kernels.h. Each has the numbers and margins of a scalar test in conservative_tests.h, named
// above it, with one model in each lane.
#include "scene/scene_kernels.h"

#include "bvh/ray_lanes.h"
#include "foundation/compiler.h"
#include "foundation/scaled_rotation.h"
#include "geometry/overlap_boxes.h"
#include "geometry/raycast_box.h"
#include "geometry/raycast_sphere.h"

namespace gphys::GPHYS_ISA {
namespace {

/// Scalar form: the constructor of ConservativeRay.
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

Vec<Float8> splat3(const float (&v)[3]) { return {splat(v[0]), splat(v[1]), splat(v[2])}; }
/// Squared length of a vector whose components are reduced by `less`, to at least 0.
Float8 square_beyond(const Vec<Float8>& a, Float8 less) {
    const Float8 zero = splat(0), x = max(a.x - less, zero), y = max(a.y - less, zero), z = max(a.z - less, zero);
    return x * x + y * y + z * z;
}

/// Eight rotations by quaternions.
class Rotations8 : public ScaledRotation<Vec<Float8>> {
public:
    Rotations8(Float8 x, Float8 y, Float8 z, Float8 w) : ScaledRotation({x, y, z}, w) {}

    /// Lanes that change no bit of any vector.
    Mask8 is_identity() const { return has_no_rotation() & (abs(w()) <= splat(1)) & (splat(1) <= abs(w())); }
    /// Lanes without a rotation; the quaternion's w may be any number.
    Mask8 has_no_rotation() const { return sum(abs(axis())) <= splat(0); }
    /// Times norm_squared().
    Matrix<Float8> matrix() const {
        return scaled_rotation_matrix(Quaternion<Float8>{axis().x, axis().y, axis().z, w()});
    }
};

/// The transforms of eight models.
struct Worlds8 {
    explicit Worlds8(const RaysAndModels<RayQuads>& pairs) : Worlds8(quads(pairs, 0), quads(pairs, 4)) {}

    Vec<Float8> position;
    Rotations8 rotation;
    Float8 scale;

private:
    static Quads8 quads(const RaysAndModels<RayQuads>& pairs, int from) {
        return load_quads([&](int i) { return pairs.model[i] + from; });
    }
    Worlds8(const Quads8& a, const Quads8& b) : position{a.x, a.y, a.z}, rotation(a.w, b.x, b.y, b.z), scale(b.w) {}
};

/// Eight rays, relative to the centres of the shapes of their models.
struct RelativeRays8 {
    /// `center` is in the space of the model.
    GPHYS_INLINE RelativeRays8(const RaysAndModels<RayQuads>& pairs, const Worlds8& world, const Vec<Float8>& center) {
        const Quads8 head = load_quads([&](int i) { return pairs.ray[i]->head; });
        const Quads8 rest = load_quads([&](int i) { return pairs.ray[i]->rest; });
        const Quads8 to = load_quads([&](int i) { return pairs.ray[i]->direction; });
        direction = {to.x, to.y, to.z};
        direction_slack = to.w;
        end = head.w;
        error = rest.w + splat(static_cast<float>(slack)) * sum(abs(world.position)) +
                splat(static_cast<float>(smallest_slack)) * (splat(1) + world.scale);
        from = {head.x, head.y, head.z};
        const Float8 zero = splat(0), one = splat(1);
        const Mask8 centered = sum(abs(center)) <= zero;
        if (bits(centered) != 0xff) {
            // With the identity, the centre has only its own roundings. The first of two differences is rounded, too.
            const Vec<Float8> scaled = world.scale * center;
            from = from - one / world.rotation.norm_squared() * world.rotation(scaled);
            const Mask8 is_unchanged = world.rotation.is_identity() & (world.scale <= one) & (one <= world.scale);
            const Float8 few = splat(few_roundings);
            error = error + choose(is_unchanged, few, splat(float_slack)) * sum(abs(scaled)) +
                    choose(centered, zero, few * sum(abs(from)));
        }
        from = from - world.position + Vec<Float8>{rest.x, rest.y, rest.z};
    }

    Vec<Float8> from, direction;
    Float8 end, direction_slack;
    Float8 error;  // error bound of each coordinate, besides float_slack times the sums
};

/// ConservativeRay::verdict of placed boxes. to_box_axes(v) rotates a world vector to the box's axes and multiplies its
/// length by `unit`.
template <class ToBoxAxes>
TriStates8 rays_and_boxes(const RelativeRays8& rays, const Vec<Float8>& half, Float8 unit,
                          const ToBoxAxes& to_box_axes) {
    const Float8 margin = (splat(float_slack) * (sum(abs(rays.from)) + sum(half)) + rays.error) * unit;
    const RayAndBox<Vec<Float8>> both(to_box_axes(rays.from), half * unit, margin, to_box_axes(rays.direction),
                                      rays.direction_slack * unit, rays.end);
    return {bits(both.may_hit()) ^ 0xff, bits(both.must_hit())};
}

TriStates8 rays_and_aabbs(const RaysAndModels<RayQuads>& pairs) {
    const Quads8 a = load_quads([&](int i) { return pairs.model[i] + shape_at; });
    const Quads8 b = load_quads([&](int i) { return pairs.model[i] + shape_at + 2; });
    const Vec<Float8> low{a.x, a.y, a.z}, high{b.y, b.z, b.w};
    const Worlds8 world(pairs);
    const RelativeRays8 rays(pairs, world, splat(0.5f) * (low + high));
    return rays_and_boxes(rays, splat(0.5f) * world.scale * (high - low), world.rotation.norm_squared(),
                          [&](const Vec<Float8>& v) { return world.rotation.inverse(v); });
}

TriStates8 rays_and_obbs(const RaysAndModels<RayQuads>& pairs) {
    const Quads8 a = load_quads([&](int i) { return pairs.model[i] + shape_at; });
    const Quads8 b = load_quads([&](int i) { return pairs.model[i] + shape_at + 2; });
    const Quads8 q = load_quads([&](int i) { return pairs.other[i]; });
    const Worlds8 world(pairs);
    const Rotations8 rotation(q.x, q.y, q.z, q.w);
    const RelativeRays8 rays(pairs, world, {a.x, a.y, a.z});
    return rays_and_boxes(rays, world.scale * Vec<Float8>{b.y, b.z, b.w},
                          world.rotation.norm_squared() * rotation.norm_squared(),
                          [&](const Vec<Float8>& v) { return rotation.inverse(world.rotation.inverse(v)); });
}

/// ConservativeRay::verdict of spheres, in float: whether the point of the ray that is closest to the centre is
/// certainly outside or inside the sphere.
TriStates8 rays_and_spheres(const RaysAndModels<RayQuads>& pairs) {
    const Quads8 sphere = load_quads([&](int i) { return pairs.other[i]; });
    const Worlds8 world(pairs);
    const RelativeRays8 rays(pairs, world, {sphere.x, sphere.y, sphere.z});
    const Float8 zero = splat(0), radius = world.scale * sphere.w;
    const Float8 margin = splat(float_slack) * (sum(abs(rays.from)) + radius) + splat(4) * rays.error;
    const Float8 squared = max(dot(rays.direction, rays.direction), splat(1));  // 1 for a direction of zero
    const Vec<Float8> closest = abs(closest_on_ray(rays.from, rays.direction, squared, rays.end));
    const Float8 limit = radius * radius, above = limit * splat(1 + square_slack) + splat(smallest_square);
    const Float8 below = limit * splat(1 - square_slack), least = splat(smallest_square);
    return {bits(square_beyond(closest, margin) <= above) ^ 0xff,
            bits(below <= square_beyond(closest, zero - margin) + least) ^ 0xff};
}

/// Eight Aabbs relative to a point: RelativeBox (conservative_shape.h).
struct Boxes8 {
    Boxes8(const float* quads, const uint32_t* first_quad, const QueryPoint& point)
        : Boxes8(quad(quads, first_quad, 0), quad(quads, first_quad, 1), quad(quads, first_quad, 2),
                 quad(quads, first_quad, 3), point) {}

    Vec<Float8> half, from;  // from: the point relative to the centre, on the world's axes
    Rotations8 rotation;
    Float8 margin;      // error bound of each coordinate
    uint32_t centered;  // lanes centred on their origins; the others are not valid

private:
    Boxes8(const Quads8& a, const Quads8& b, const Quads8& c, const Quads8& d, const QueryPoint& point)
        : rotation(a.w, b.x, b.y, b.z) {
        const Vec<Float8> position{a.x, a.y, a.z}, low{c.z, c.w, d.x}, high{d.y, d.z, d.w};
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

/// ConservativePoint of placed boxes.
TriStates8 boxes_and_sphere(const float* quads, const uint32_t* first_quad, const SphereQueryLanes& ball) {
    const Boxes8 boxes(quads, first_quad, ball.center);
    const Float8 unit = boxes.rotation.norm_squared();
    const Vec<Float8> outside = abs(boxes.rotation.inverse(boxes.from)) - unit * boxes.half;
    const Float8 scaled_margin = boxes.margin * unit, far = splat(ball.reach) * unit, limit = far * far;
    const Float8 at_least = square_beyond(outside, scaled_margin),
                 at_most = square_beyond(outside, splat(0) - scaled_margin);
    const Float8 above = limit * splat(1 + square_slack) + splat(smallest_square);
    const uint32_t no = bits(at_least <= above) ^ 0xff;
    const uint32_t yes = bits(limit * splat(1 - square_slack) <= at_most + splat(smallest_square)) ^ 0xff;
    return {no & boxes.centered, yes & boxes.centered};
}

/// ConservativeBoxQuery for an AABB query: separating axes. Models without a rotation need only the axes of faces.
///
/// Error of a component of an axis: at most 18 roundings of 2^-24 of `unit`, since six roundings apply to numbers that
/// add up to three times `unit`. Sums of products with such components take five more. float_slack covers 128.
TriStates8 boxes_and_box(const float* quads, const uint32_t* first_quad, const BoxQueryLanes& block) {
    const Boxes8 boxes(quads, first_quad, block.center);
    const Float8 unit = boxes.rotation.norm_squared();
    const Vec<Float8> sizes = splat3(block.half);
    const Matrix<Float8> axes = boxes.rotation.matrix();
    const BoxAndRotatedBox<Float8> both{sizes, boxes.from, boxes.half, axes, abs(axes), unit};
    const Float8 margin = unit * (boxes.margin + splat(float_slack) * sum(sizes));
    Float8 gap = both.face_gap();
    gap = choose(boxes.rotation.has_no_rotation(), gap, max(gap, both.edge_gap()));
    const uint32_t no = bits(gap <= margin) ^ 0xff, yes = bits(splat(0) - margin <= gap) ^ 0xff;
    return {no & boxes.centered, yes & boxes.centered};
}

}  // namespace

extern const SceneKernels scene_kernels{make_ray_quads, rays_and_spheres, rays_and_aabbs,
                                        rays_and_obbs,  boxes_and_sphere, boxes_and_box};

}  // namespace gphys::GPHYS_ISA
