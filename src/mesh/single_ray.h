// A single ray against the triangles of a mesh, for kernels: prepared in registers, then traversed to the nearest or to
// any crossing. Triangles that the float test does not reject get the exact test one by one (single_crossing.h): on
// average there is less than one, for which eight lanes of doubles take longer with AVX2 and as long with AVX-512.
#pragma once

#include "bvh/ordered_traversal.h"
#include "bvh/ray_setup.h"
#include "foundation/compiler.h"
#include "foundation/simd_rotation.h"
#include "geometry/shear.h"
#include "mesh/mesh_kernels.h"
#include "mesh/single_crossing.h"
#include "mesh/single_hit.h"
#include "mesh/triangle_setup.h"
#include "mesh/triangle_test.h"

namespace gphys::GPHYS_ISA {

GPHYS_INLINE TriangleProbe probe_of_triangles(const SingleShear<Axes>& ray, const RaySetup<Axes>& along,
                                              const RootBounds& box) {
    const TriangleSetup<Axes> setup(ray, along.begin, along.slack, along.span < unbounded_span, box);
    const auto narrow = [](double value) { return static_cast<float>(value); };
    TriangleProbe probe;
    probe.axis[0] = ray.kx, probe.axis[1] = ray.ky, probe.axis[2] = ray.kz;
    for (int k = 0; k < 3; ++k) probe.origin[k] = narrow(setup.origin[k]);
    probe.across = {{narrow(setup.slope_x), narrow(setup.slope_y)},
                    {narrow(setup.error_slope_x), narrow(setup.error_slope_y)}};
    const float ahead = narrow(setup.ahead);
    probe.rest = {ahead, 1 - ahead, narrow(setup.margin), narrow(setup.error)};
    return probe;
}

/// The nearest crossing so far, among those on allowed sides. ray_in_mesh() gives the ray to the exact test.
template <class RayInMesh>
class CountedCrossings {
public:
    GPHYS_INLINE CountedCrossings(const RayInMesh& ray_in_mesh, Faces faces, const SingleCrossing& quick,
                                  const MeshTree& mesh, NearestCrossing& nearest)
        : ray_in_mesh_(ray_in_mesh),
          quick_(quick),
          front_(mesh.only_front || faces.front),
          back_(!mesh.only_front && faces.back),
          edge_(!mesh.only_front && faces.front),
          exact_(mesh.exact),
          nearest_(nearest) {}

    /// Tests some lanes of a packet.
    GPHYS_INLINE void test(const TrianglePacket& packet, uint32_t lanes) {
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto i = static_cast<uint32_t>(lowest_bit(lanes));
            TriangleCrossing crossing;
            const TriState crosses = quick_(packet, i, crossing);
            if (crosses == TriState::no) continue;
            if (crosses == TriState::undecided && !exact_(ray_in_mesh_(), packet, i, crossing)) continue;
            if (!(crossing.facing < 0 ? front_ : crossing.facing > 0 ? back_ : edge_)) continue;
            nearest_.take(crossing, reported(crossing.t), packet, i);
        }
    }

private:
    const RayInMesh& ray_in_mesh_;
    const SingleCrossing& quick_;
    bool front_, back_, edge_;
    CrossesTriangleAlone exact_;
    NearestCrossing& nearest_;
};

/// `origin` and `direction` are those of ray_in_mesh().
template <class Order, class RayInMesh>
GPHYS_INLINE void cast_ray(const MeshTree& mesh, const Axes& origin, const Axes& direction, double t_max, Faces faces,
                           const RayInMesh& ray_in_mesh, NearestCrossing& nearest) {
    const RaySetup<Axes> along(origin, direction, mesh.box);
    const auto limit_at = [&](double t) GPHYS_INLINE_LAMBDA {
        return static_cast<float>(ray_limit(t, along.slack, along.scale, along.start, along.span));
    };
    float limit = limit_at(t_max);
    if (!(limit >= 0)) return;
    RayProbe probe;
    store_probe(along, probe);
    const SingleRayTest test(probe);
    // Most misses end here, before the constants of triangles are set up.
    const BvhNode& first = node_at(mesh.nodes, mesh.root);
    Float8 entry;
    if ((test.hits(first.boxes, limit, entry) & lanes_of(first)) == 0) return;
    const SingleShear<Axes> shear(direction);
    const TriangleTest triangles(probe_of_triangles(shear, along, mesh.box));
    const SingleCrossing quick(shear, origin, t_max);
    CountedCrossings crossings(ray_in_mesh, faces, quick, mesh, nearest);
    traverse_ordered(
        mesh.nodes, mesh.root, test, limit,
        [&](uint32_t number) GPHYS_INLINE_LAMBDA {
            const TrianglePacket& packet = mesh.packets[number];
            const uint32_t lanes = triangles.hits(packet, limit);
            if (lanes == 0) return limit;
            const float before = nearest.t;
            crossings.test(packet, lanes);
            if (nearest.t < before) {
                limit = std::is_same_v<Order, AnyHit> ? -1 : limit_at(limit_of_ties<double>(nearest.t));
            }
            return limit;
        },
        [](const BvhNode&) {});
}

/// Of a mesh without a place.
template <class Order>
bool cast_ray(const MeshTree& mesh, const Ray& ray, NearestCrossing& nearest, gphys_hit* hit) {
    const Axes direction = axes_of(ray.direction);
    cast_ray<Order>(
        mesh, axes_of(ray.origin), direction, ray.t_max, ray.faces,
        [&]() GPHYS_INLINE_LAMBDA -> const Ray& { return ray; }, nearest);
    return hit && write_hit(
                      nearest, direction, [](Axes&, Axes&) GPHYS_INLINE_LAMBDA {}, *hit);
}

/// Whether a ray certainly misses the ball around a mesh.
GPHYS_INLINE bool misses_ball(const MeshTree& mesh, const Axes& origin, const Axes& direction, double t_max) {
    const Axes center = axes_of(mesh.center), from = origin - center;
    const double direction_squared = dot(direction, direction);
    const double nearest_t = -dot(from, direction) / (direction_squared > 0 ? direction_squared : 1);
    // An infinite t_max would give NaN with a direction of zero.
    const Axes closest = from + direction * gphys::largest(0, gphys::least(nearest_t, gphys::least(t_max, 0x1p600)));
    // A few dozen roundings of 2^-53, each of at most the sum of all.
    const double size = max_component(abs(origin)) + max_component(abs(center)) + mesh.radius;
    return mesh.radius * mesh.radius + 0x1p-43 * size * size < dot(closest, closest);
}

/// Of a mesh at the place of a model, with a scale for each axis, by a ray in the world that is no segment. The scalar
/// form is in mesh_instance.cpp.
template <class Order>
bool cast_ray_at_placed(const MeshTree& mesh, const Ray& ray, const float* model, const Vec<double>& axes,
                        NearestCrossing& nearest, gphys_hit* hit) {
    // MeshPlace::inverse_apply and inverse_apply_to_vector
    const Axes position = widened<0, 1, 2>(model), scale = axes_of(axes) * static_cast<double>(model[7]);
    const AxesMatrix rotation = rotation_matrix(model + 3), back = transposed(rotation);
    const Axes origin = quotients(repeated(back * (axes_of(ray.origin) - position)), scale);
    const Axes direction = quotients(repeated(back * ray.direction), scale);
    if (misses_ball(mesh, origin, direction, ray.t_max)) return false;
    const auto ray_in_mesh = [&] {
        double from[4], along[4];
        store(from, origin);
        store(along, direction);
        Ray in_mesh;
        load(from, in_mesh.origin);
        load(along, in_mesh.direction);
        in_mesh.t_max = ray.t_max;
        in_mesh.faces = ray.faces;
        return in_mesh;
    };
    cast_ray<Order>(mesh, origin, direction, ray.t_max, ray.faces, ray_in_mesh, nearest);
    const auto place = [&](Axes& point, Axes& normal) GPHYS_INLINE_LAMBDA {
        point = position + rotation * by_component(point, scale);
        normal = rotation * normal;
    };
    const bool is_uniform = axes.x == 1 && axes.y == 1 && axes.z == 1;
    return hit && is_uniform && write_hit(nearest, direction, place, *hit);
}

}  // namespace gphys::GPHYS_ISA
