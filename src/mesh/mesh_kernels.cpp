// Kernels of raycasts against meshes: preparation of rays (eight at once), traversal for a single ray, for packets of
// coherent rays and for interleaved ones (bvh/*_traversal.h), and the making of hits.
#include "mesh/mesh_kernels.h"

#include <optional>

#include "bvh/interleaved_traversal.h"
#include "bvh/ordered_traversal.h"
#include "bvh/packet_traversal.h"
#include "bvh/ray_lanes.h"
#include "foundation/compiler.h"
#include "geometry/shear.h"
#include "mesh/shared_origin.h"
#include "mesh/single_ray.h"
#include "mesh/triangle_lanes.h"
#include "mesh/triangle_setup.h"
#include "mesh/triangle_test.h"

namespace gphys::GPHYS_ISA {
namespace {

GPHYS_INLINE void prefetch_packet(const TrianglePacket* packets, uint32_t number) {
    prefetch_range(packets + number, sizeof(TrianglePacket));
}

/// Inlined twice: called, it adds 2 to 4 % to the instructions of a batch with SSE2, and 1 % with AVX2.
GPHYS_INLINE void prepare_eight(const Vec<Double8>& origin, const Vec<Double8>& direction, Double8 t_max,
                                const RootBounds& root, PreparedRay* eight) {
    const auto at = [&](int i) -> PreparedRay& { return eight[i]; };
    const RaySetup<Vec<Double8>> along(origin, direction, root);
    const Float8 limits = store_probes(t_max, along, [&](int i) -> RayProbe& { return at(i).along; });

    const Shear<Double8> shear(direction);
    const TriangleSetup<Vec<Double8>> setup(shear, along.begin, along.slack, along.span < unbounded_span, root);
    constexpr Vec<double> number{0, 1, 2};
    const auto axis = [](Double8 k) { return integer_bits(narrowed(k)); };
    const Quads8 axes{axis(shear.x(number)), axis(shear.y(number)), axis(shear.z(number)), splat(0)};
    store_quads([&](int i) { return reinterpret_cast<float*>(at(i).triangles.axis); }, axes);
    store_quads([&](int i) { return reinterpret_cast<float*>(&at(i).sheared.kx); }, axes);
    store_quads([&](int i) { return at(i).triangles.origin; },
                {narrowed(setup.origin[0]), narrowed(setup.origin[1]), narrowed(setup.origin[2]), splat(0)});
    store_quads([&](int i) { return reinterpret_cast<float*>(&at(i).triangles.across); },
                {narrowed(setup.slope_x), narrowed(setup.slope_y), narrowed(setup.error_slope_x),
                 narrowed(setup.error_slope_y)});
    const Float8 ahead = narrowed(setup.ahead);
    store_quads([&](int i) { return reinterpret_cast<float*>(&at(i).triangles.rest); },
                {ahead, splat(1) - ahead, narrowed(setup.margin), narrowed(setup.error)});

    const Double8 begin[4] = {origin.x, origin.y, origin.z, direction.x},
                  go[4] = {direction.x, direction.y, direction.z, t_max};
    const Double8 from[4] = {shear.x(origin), shear.y(origin), shear.z(origin), shear.speed};
    const Double8 rest[4] = {shear.sx, shear.sy, t_max, 0};
    store_components([&](int i) { return &at(i).sheared.origin.x; }, begin);
    store_components([&](int i) { return &at(i).sheared.direction.x; }, go);
    store_components([&](int i) { return at(i).sheared.from; }, from);
    store_components([&](int i) { return &at(i).sheared.sx; }, rest);
    alignas(32) float limit[8];
    store(limit, limits);
    for (int i = 0; i < 8; ++i) at(i).limit = limit[i];
    // is_segment is not read after shearing. Rays with a choice of faces are cast one by one.
    const Double8 no_rest[4] = {t_max, 0, 0, 0};
    store_components([&](int i) { return &at(i).sheared.t_max; }, no_rest);
}

void prepare(const gphys_ray* const* rays, uint32_t count, const RootBounds& root, PreparedRay* to) {
    static_assert(sizeof(gphys_ray) == 7 * sizeof(float));
    for (uint32_t first = 0; first < count; first += 8) {
        const auto given = [&](int i) {
            const uint32_t next = first + static_cast<uint32_t>(i);
            return &rays[next < count ? next : count - 1]->origin.x;
        };
        const Four8 begins(given), goes([&](int i) { return given(i) + 3; });
        prepare_eight({begins.x, begins.y, begins.z}, {goes.x, goes.y, goes.z}, goes.w, root, to + first);
    }
}

Vec<Double8> splat3(const Vec3& v) { return {v.x, v.y, v.z}; }
Matrix<Double8> splat3(const Mat3& m) { return {splat3(m.x), splat3(m.y), splat3(m.z)}; }

void prepare_placed(const Ray* rays, uint32_t count, const MeshPlace& place, const RootBounds& root, PreparedRay* to) {
    const Vec<Double8> position = splat3(place.world.position);
    const Matrix<Double8> rotation = splat3(place.world.rotation);
    const Vec<Double8> scale = splat3(place.scale);
    for (uint32_t first = 0; first < count; first += 8) {
        const Rays8 eight(rays + first, count - first);
        // MeshPlace::inverse_apply and inverse_apply_to_vector
        const Vec<Double8> origin = quotients(transpose_times(rotation, eight.origin - position), scale);
        const Vec<Double8> direction = quotients(transpose_times(rotation, eight.direction), scale);
        prepare_eight(origin, direction, eight.t_max, root, to + first);
    }
}

void walk_ray(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const PreparedRay& ray,
              const PacketVisitor& to) {
    const TriangleTest test(ray.triangles);
    float limit = ray.limit;
    traverse_ordered(
        nodes, root, SingleRayTest(ray.along), limit,
        [&](uint32_t number) {
            const uint32_t lanes = test.hits(packets[number], limit);
            if (lanes != 0) limit = to.visit(to.context, packets[number], lanes);
            return limit;
        },
        [](const BvhNode&) {});
}

/// Collects pairs of a ray and a triangle and tests eight of them at once. A hit lowers the limit of its ray, or, with
/// ends_rays, makes it negative.
class Crossing {
public:
    Crossing(const PreparedRay* rays, const TrianglePacket& any, bool only_front, CrossesTriangle exact,
             NearestCrossing* nearest, float* limits, bool ends_rays)
        : rays_(rays),
          only_front_(only_front),
          ends_rays_(ends_rays),
          exact_(exact),
          nearest_(nearest),
          limits_(limits),
          pairs_(any) {}

    /// Adds the triangles of a packet that a ray may hit.
    void add(uint32_t ray, const TrianglePacket& packet) {
        add(ray, packet, TriangleTest(rays_[ray].triangles).hits(packet, limits_[ray]));
    }
    void add(uint32_t ray, const TrianglePacket& packet, uint32_t lanes) {
        for (; lanes != 0; lanes &= lanes - 1) {
            pairs_.add(ray, packet, static_cast<uint32_t>(lowest_bit(lanes)));
            if (pairs_.count == 8) finish();
        }
    }
    /// Rays that have found a nearer hit get new limits.
    void finish() {
        uint32_t open = (1u << pairs_.count) - 1;
#if GPHYS_HAS_AVX2
        if (pairs_.count >= worth_eight_lanes) {
            const Crossings8 crossings(pairs_, rays_);
            for (uint32_t yes = crossings.yes & open; yes != 0; yes &= yes - 1) {
                const auto i = static_cast<uint32_t>(lowest_bit(yes));
                if (take(i, crossings[i], crossings.rounded_t[i])) shorten(i, crossings.limit[i]);
            }
            open &= ~(crossings.no | crossings.yes);
        }
#endif
        for (; open != 0; open &= open - 1) {
            const auto i = static_cast<uint32_t>(lowest_bit(open));
            const PreparedRay& ray = rays_[pairs_.ray[i]];
            TriangleCrossing crossing;
            if (exact_(ray, *pairs_.packet[i], pairs_.lane[i], crossing) && take(i, crossing, reported(crossing.t))) {
                shorten(i, ray.along.limit(limit_of_ties(crossing.t)));
            }
        }
        pairs_.count = 0;
    }

private:
    bool take(uint32_t i, const TriangleCrossing& crossing, float t) {
        if (only_front_ && crossing.facing >= 0) return false;
        return nearest_[pairs_.ray[i]].take(crossing, t, *pairs_.packet[i], pairs_.lane[i]);
    }

    void shorten(uint32_t i, float limit) { limits_[pairs_.ray[i]] = ends_rays_ ? -1 : limit; }

    const PreparedRay* rays_;
    bool only_front_, ends_rays_;
    CrossesTriangle exact_;
    NearestCrossing* nearest_;
    float* limits_;
    RaysAndTriangles pairs_;
};

/// Returns false if the packet diverges: its rays have to go on from the present limits.
bool walk_packet(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const PreparedRay* rays,
                 uint32_t count, Crossing& crossing, float* limits) {
    PacketTest packet_test([&](uint32_t ray) -> const RayProbe& { return rays[ray].along; }, limits, count);
    std::optional<SharedOrigin> shared;
    TrianglesFromOrigin seen;
    uint32_t seen_number = 0xffffffff;  // none
    const auto visit = [&](uint32_t group, uint32_t set, uint32_t number) {
        if (!shared) shared.emplace(rays, count);
        const TrianglePacket& packet = packets[number];
        if (*shared && seen_number != number) {
            seen.see(shared->first(), packet);
            seen_number = number;
        }
        for (; set != 0; set &= set - 1) {
            const uint32_t ray = 8 * group + static_cast<uint32_t>(lowest_bit(set));
            if (*shared) {
                crossing.add(ray, packet, seen.hits(shared->slope_x[ray], shared->slope_y[ray], limits[ray]));
            } else {
                crossing.add(ray, packet);
            }
        }
    };
    return traverse_packet(
        nodes, root, packet_test, count, visit, [&] { crossing.finish(); },
        [&](uint32_t number) GPHYS_INLINE_LAMBDA { prefetch_packet(packets, number); });
}

/// Order is ClosestHit or AnyHit.
template <class Order>
void walk_rays(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const PreparedRay* rays,
               uint32_t count, bool together, bool only_front, CrossesTriangle exact, NearestCrossing* nearest) {
    PacketLimits of_all(count, [&](uint32_t ray) { return rays[ray].limit; });
    float* const limits = of_all.limits;
    Crossing crossing(rays, packets[0], only_front, exact, nearest, limits, std::is_same_v<Order, AnyHit>);
    if (together && walk_packet(nodes, root, packets, rays, count, crossing, limits)) return;
    const auto visit = [&](const uint32_t* numbers, const uint32_t* items, uint32_t size, float* new_limits) {
        float before[8];
        for (uint32_t k = 0; k < size; ++k) {
            before[k] = limits[numbers[k]];
            crossing.add(numbers[k], packets[items[k]]);
        }
        crossing.finish();
        uint32_t moved = 0;
        for (uint32_t k = 0; k < size; ++k) {
            new_limits[k] = limits[numbers[k]];
            moved |= uint32_t{new_limits[k] < before[k]} << k;
        }
        return moved;
    };
    traverse_interleaved<Order, RayTest>(
        nodes, root, [&](uint32_t ray) -> const RayProbe& { return rays[ray].along; }, limits, count, visit,
        [&](uint32_t number) GPHYS_INLINE_LAMBDA { prefetch_packet(packets, number); });
}

#if GPHYS_HAS_AVX2
template <class Place>
uint64_t hits_at(const PreparedRay* rays, const NearestCrossing* nearest, uint32_t count, const Place& place,
                 gphys_hit* const* out) {
    uint64_t made = 0;
    uint32_t number[8], size = 0;
    const auto make = [&] {
        const NearestCrossing* of[8];
        const PreparedRay* by[8];
        gphys_hit* to[8];
        for (uint32_t i = 0; i < 8; ++i) {
            const uint32_t ray = number[i < size ? i : 0];
            of[i] = nearest + ray;
            by[i] = rays + ray;
            to[i] = out[ray];
        }
        for (uint32_t rest = make_hits(of, by, place, to) & ((1u << size) - 1); rest != 0; rest &= rest - 1) {
            made |= uint64_t{1} << number[lowest_bit(rest)];
        }
        size = 0;
    };
    for (uint32_t ray = 0; ray < count; ++ray) {
        number[size] = ray;
        size += nearest[ray].triangle != GPHYS_NO_TRIANGLE;
        if (size == 8) make();
    }
    if (size != 0) make();
    return made;
}

uint64_t hits(const PreparedRay* rays, const NearestCrossing* nearest, uint32_t count, gphys_hit* const* out) {
    return hits_at(
        rays, nearest, count, [](Vec<Double8>&, Vec<Double8>&) {}, out);
}

uint64_t placed_hits(const PreparedRay* rays, const NearestCrossing* nearest, uint32_t count, const Transform& world,
                     gphys_hit* const* out) {
    const Vec<Double8> position = splat3(world.position);
    const Matrix<Double8> rotation = splat3(world.rotation);
    const Double8 scale = world.scale;
    // The scalar form is Transform::apply.
    const auto place = [&](Vec<Double8>& point, Vec<Double8>& normal) {
        point = position + rotation * (point * scale);
        normal = rotation * normal;
    };
    return hits_at(rays, nearest, count, place, out);
}
#else
// Single hits are faster.
uint64_t hits(const PreparedRay*, const NearestCrossing*, uint32_t, gphys_hit* const*) { return 0; }
uint64_t placed_hits(const PreparedRay*, const NearestCrossing*, uint32_t, const Transform&, gphys_hit* const*) {
    return 0;
}
#endif

uint32_t lanes_in_box(const TrianglePacket& packet, const Box& box) {
    return BoxTest(box).hits(boxes_of(packet)) & used_lanes(packet);
}

uint32_t lanes_along(const TrianglePacket& packet, const RayProbe& probe, float limit) {
    Float8 entry;
    return RayTest(probe).hits(boxes_of(packet), limit, entry) & used_lanes(packet);
}

uint32_t lanes_near_weighted(const TrianglePacket& packet, const WeightedPointProbe& probe, float limit) {
    Float8 distance_squared;
    return WeightedPointTest(probe).hits(boxes_of(packet), limit, distance_squared) & used_lanes(packet);
}

}  // namespace

extern const MeshKernels mesh_kernels{prepare,
                                      prepare_placed,
                                      walk_ray,
                                      cast_ray<ClosestHit>,
                                      cast_ray<AnyHit>,
                                      cast_ray_at_placed<ClosestHit>,
                                      cast_ray_at_placed<AnyHit>,
                                      walk_rays<ClosestHit>,
                                      walk_rays<AnyHit>,
                                      hits,
                                      lanes_in_box,
                                      lanes_along,
                                      lanes_near_weighted,
                                      placed_hits};

}  // namespace gphys::GPHYS_ISA
