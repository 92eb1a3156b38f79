// Creation, sharing and queries of meshes.
//
// Raycasts traverse the BVH with a conservative test of eight triangles at once (triangle_test.h, for packets of rays
// of one origin shared_origin.h). Triangles that it does not reject get the exact test (raycast_triangle.cpp), in
// kernels eight pairs at a time (triangle_lanes.h). Sweeps, closest points and overlaps traverse the BVH with tests of
// boxes, and then test single triangles in double.
#include "mesh/mesh.h"

#include "foundation/exact.h"
#include "geometry/faces.h"
#include "geometry/raycast_box.h"
#include "mesh/closest_search.h"

namespace gphys {

namespace {

/// Meshes up to this size, in metres, are magnified. A product of two edges of a thousandth of it is 2^-84. That is
/// still 2^40 times the margin that the triangle tests add for subnormal numbers (triangle_setup.h).
constexpr double smallest_extent = 0x1p-32;

/// The rays in `found` have their hits already; find(i, hit) finds those of the other rays.
template <class Find>
uint64_t hits_of_others(uint64_t found, uint32_t count, gphys_hit* const* out, const Find& find) {
    for (uint32_t i = 0; i < count; ++i) {
        Hit hit;
        if ((found >> i & 1) != 0 || !find(i, hit)) continue;
        *out[i] = to_hit(hit);
        found |= uint64_t{1} << i;
    }
    return found;
}

double largest_coordinate(const MeshArrays& arrays) {
    double largest = 0;
    for (uint32_t i = 0; i < arrays.vertex_count; ++i)
        largest = std::max(largest, max_component(abs(widen(arrays.vertex(i)))));
    return largest;
}

}  // namespace

WordHash Mesh::hash_of_indices(const MeshArrays& arrays) {
    WordHash hash;
    hash.put(arrays.indices, arrays.index_count);
    return hash;
}

Mesh::Mesh(const gphys_allocator* hooks, const MeshArrays& arrays, const gphys_mesh_report& report, WordHash index_hash,
           Isa isa, bool deformable)
    : memory(hooks),
      kernels_(mesh_kernels(isa)),
      near_kernels_(near_kernels(isa)),
      report_(report),
      bvh_(&memory, isa),
      rays_root_(Box()),
      ray_packets_(Box(), 0),
      isa_(isa),
      kind_(arrays.kind),
      index_hash_(index_hash) {
    vertices_.reserve(arrays.vertex_count);
    for (uint32_t i = 0; i < arrays.vertex_count; ++i) vertices_.push_back(arrays.vertex(i));
    if (arrays.index_count > 0) indices_.assign(arrays.indices, arrays.indices + arrays.index_count);
    if (arrays.radii) radii_.assign(arrays.radii, arrays.radii + arrays.index_count / 3);
    if (deformable) {
        next_vertices_.resize(vertices_.size());
        next_radii_.resize(radii_.size());
        users_.emplace(&memory);
    }
}

Mesh::Mesh(const gphys_allocator* hooks, const MeshArrays& arrays, const gphys_mesh_report& report, Isa isa,
           bool deformable)
    : Mesh(hooks, arrays, report, hash_of_indices(arrays), isa, deformable) {
    pack();
    measure();
    if (is_hull()) hull_.make(vertices_, indices_);
    magnified_ = make_magnified(this->arrays(), report_, magnification_);
}

Mesh::Mesh(const gphys_allocator* hooks, const MeshParts& parts, bool deformable)
    : Mesh(hooks, parts.arrays, parts.report, parts.index_hash, chosen_isa(), deformable) {
    Vector<Box> boxes(&memory);
    pack_triangles(parts, packets_, boxes);
    if (is_links()) {
        for (size_t i = 0; i < boxes.size(); ++i) boxes[i] = box_of(packets_[i]);
    }
    bvh_.build(parts.tree, boxes.data());
    note_packed_area(boxes);
    measure();
    if (is_hull()) hull_.make(vertices_, indices_);
    magnified_ = make_magnified(this->arrays(), report_, magnification_);
}

MeshArrays Mesh::arrays() const {
    return {vertices_.empty() ? nullptr : &vertices_[0].x, sizeof(gphys_vec3),
            static_cast<uint32_t>(vertices_.size()),       indices_.data(),
            static_cast<uint32_t>(indices_.size()),        kind_,
            radii_.empty() ? nullptr : radii_.data()};
}

void Mesh::pack() {
    Vector<TrianglePacket> packets(&memory);
    Vector<Box> boxes(&memory);
    pack_triangles(arrays(), packets, boxes);
    if (is_links()) {
        for (size_t i = 0; i < boxes.size(); ++i) boxes[i] = box_of(packets[i]);
    }
    Vector<uint32_t> numbers(boxes.size(), &memory);
    for (uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
    bvh_.build(boxes.data(), numbers.data(), static_cast<uint32_t>(numbers.size()));
    packets_.swap(packets);
    note_packed_area(boxes);
}

void Mesh::note_packed_area(const Vector<Box>& boxes) {
    packed_area_ = 0;
    for (const Box& box : boxes) packed_area_ += half_area(box);
    packed_root_area_ = half_area(bounds());
}

void Mesh::measure() noexcept {
    WordHash hash = index_hash_;
    hash.put(vertices_.data(), vertices_.size() * (sizeof(gphys_vec3) / 4));
    hash.put(radii_.data(), radii_.size());
    hash_ = mesh_hash(hash, kind_);
    if (packets_.empty()) return;
    const Box box = bounds();
    rays_root_ = RootBounds(box);
    ray_packets_ = RayPackets(box, bvh_.size());
    center_ = (Vec3{box.min[0], box.min[1], box.min[2]} + Vec3{box.max[0], box.max[1], box.max[2]}) * 0.5;
    double squared = 0;
    for (const gphys_vec3& vertex : vertices_) squared = std::max(squared, length_squared(widen(vertex) - center_));
    double thickest = 0;
    for (const float radius : radii_) thickest = std::max<double>(thickest, radius);
    // Five roundings of 2^-53 each, of which those under the square root count half, and one of the sum.
    radius_ = (std::sqrt(squared) + thickest) * (1 + 0x1p-50);
    const gphys_vec3 center = narrow(center_);
    ball_ = {center, round_up((radius_ + distance(center_, widen(center))) * (1 + 0x1p-50))};
}

const Mesh* Mesh::make_magnified(const MeshArrays& of, const gphys_mesh_report& report, double& magnification) const {
    magnification = 1;
    const double largest = largest_coordinate(of);
    if (packets_.empty() || is_links() || largest == 0 || largest > smallest_extent) return nullptr;
    magnification = std::scalbn(1.0, -std::ilogb(largest));
    Vector<gphys_vec3> larger(vertices_.get_allocator());
    larger.reserve(of.vertex_count);
    for (uint32_t i = 0; i < of.vertex_count; ++i) larger.push_back(narrow(widen(of.vertex(i)) * magnification));
    MeshArrays from = of;
    from.vertices = &larger[0].x;
    from.vertex_stride = sizeof(gphys_vec3);
    return create<Mesh>(memory.hooks(), from, report, isa_);
}

double Mesh::radius(const AxisScale& axes) const {
    if (axes.is_one() || packets_.empty()) return radius_;
    const Aabb box = axes(bounds());
    return std::min(radius_ * axes.largest(), length(box.max - box.min) * 0.5) * (1 + 0x1p-50);
}

void Mesh::release(const Mesh* mesh) noexcept {
    // Acquire: whoever destroys the mesh must see all writes that other holders made before they released it.
    if (mesh->holds_.fetch_sub(1, std::memory_order_acq_rel) == 1) destroy(const_cast<Mesh*>(mesh));
}

gphys_octree_stats Mesh::bvh_stats() const {
    gphys_octree_stats stats = bvh_.stats();
    stats.item_count = triangle_count();
    stats.leaf_count = static_cast<uint32_t>(packets_.size());
    stats.node_count += stats.leaf_count;
    if (stats.depth > 0) ++stats.depth;
    uint64_t bytes = stats.memory_bytes + uint64_t{packets_.capacity()} * sizeof(TrianglePacket);
    if (magnified_) bytes += magnified_->bvh_stats().memory_bytes;
    stats.memory_bytes = static_cast<uint32_t>(std::min<uint64_t>(bytes, std::numeric_limits<uint32_t>::max()));
    return stats;
}

Ray Mesh::magnified(const Ray& ray) const {
    Ray result = ray;
    for (Vec3* part : {&result.origin, &result.direction, &result.rest}) *part = *part * magnification_;
    return result;
}

bool Mesh::crosses_alone(const Ray& ray, const TrianglePacket& packet, uint32_t lane, TriangleCrossing& crossing) {
    return crosses(packet.triangle(static_cast<int>(lane)), ShearedRay(ray), crossing);
}

NearestCrossing Mesh::crossing_by(decltype(MeshKernels::closest) kernel, const Ray& ray) const {
    NearestCrossing nearest;
    if (!packets_.empty()) kernel(tree(), ray, nearest, nullptr);
    return nearest;
}

namespace {

gphys_distance distance_of(const NearestCrossing& nearest) { return {nearest.t, 0, nearest.triangle}; }

}  // namespace

bool Mesh::raycast(const Ray& ray, Hit& hit) const {
    if (is_links()) return raycast_links(ray, hit);
    if (magnified_) return magnified_->raycast(magnified(ray), hit) && reduce(hit);
    if (is_hull() && contains(ray.origin)) return started_inside(ray, hit);
    return hit_at(crossing_by(kernels_.closest, ray), ray, hit);
}

namespace {

/// Not inlined: kernels write most hits.
template <class Find>
GPHYS_NOINLINE bool round_hit(const Find& find, gphys_hit& out) {
    Hit hit;
    if (!find(hit)) return false;
    out = to_hit(hit);
    return true;
}

}  // namespace

bool Mesh::raycast(const Ray& ray, gphys_hit& out) const {
    if (!is_plain()) return round_hit([&](Hit& hit) { return raycast(ray, hit); }, out);
    NearestCrossing nearest;
    if (kernels_.closest(tree(), ray, nearest, &out)) return true;
    return nearest.triangle != GPHYS_NO_TRIANGLE && round_hit([&](Hit& hit) { return hit_at(nearest, ray, hit); }, out);
}

bool Mesh::raycast_distance(const Ray& ray, gphys_distance& out) const {
    if (is_links() || is_hull()) {
        Hit hit;
        if (!raycast(ray, hit)) return false;
        out = {reported(hit.t), 0, hit.triangle};
        return true;
    }
    if (magnified_) return magnified_->raycast_distance(magnified(ray), out);
    const NearestCrossing nearest = crossing_by(kernels_.closest, ray);
    out = distance_of(nearest);
    return nearest.triangle != GPHYS_NO_TRIANGLE;
}

void Mesh::cross_many(decltype(MeshKernels::rays) kernel, const PreparedRay* rays, uint32_t count,
                      NearestCrossing* nearest) const {
    const auto exact = [](const PreparedRay& ray, const TrianglePacket& packet, uint32_t lane,
                          TriangleCrossing& crossing) {
        return crosses(packet.triangle(static_cast<int>(lane)), ray.sheared, crossing);
    };
    const auto ray_of = [&](uint32_t i) -> const Ray& { return rays[i].sheared; };
    const auto probe_of = [&](uint32_t i) -> const RayProbe& { return rays[i].along; };
    ray_packets_.split(ray_of, probe_of, count, [&](uint32_t first, uint32_t last, bool together) {
        kernel(bvh_.nodes(), bvh_.root(), packets_.data(), rays + first, last - first, together, is_hull(), exact,
               nearest + first);
    });
}

namespace {

/// A ray in world space, in the local space of the mesh.
Ray carried(const Ray& ray, const MeshPlace& place) {
    return {place.inverse_apply(ray.origin), place.inverse_apply_to_vector(ray.direction), ray.t_max};
}

/// Fewer rays of a batch are cast one by one. Measured: what a group of rays sets up costs as much as it saves at 7
/// unrelated rays, and at 15 coherent ones that only ask whether they hit.
constexpr uint32_t fewest_rays = 8, fewest_rays_for_any = 16;

/// Bit i is set if test(i).
template <class Test>
uint64_t bits_of(uint32_t count, const Test& test) {
    uint64_t set = 0;
    for (uint32_t i = 0; i < count; ++i) set |= uint64_t{test(i)} << i;
    return set;
}

}  // namespace

template <class RayOf, class At>
uint64_t Mesh::begin_inside(uint32_t count, const RayOf& ray_of, const At& at) const {
    if (!is_hull()) return 0;
    return bits_of(count, [&](uint32_t i) {
        const Ray ray = ray_of(i);
        Hit hit;
        if (!contains(ray.origin) || !started_inside(ray, hit)) return false;
        at(i, hit);
        return true;
    });
}

uint64_t Mesh::raycast_many(const gphys_ray* const* rays, uint32_t count, gphys_hit* const* out) const {
    if (packets_.empty() || count == 0) return 0;
    if (count < fewest_rays) return bits_of(count, [&](uint32_t i) { return raycast(widen(*rays[i]), *out[i]); });
    if (is_cast_singly()) {
        return hits_of_others(0, count, out, [&](uint32_t i, Hit& hit) { return raycast(widen(*rays[i]), hit); });
    }
    PreparedRays prepared;
    NearestCrossing nearest[rays_at_once];
    kernels_.prepare(rays, count, rays_root_, prepared.of);
    cross_many(kernels_.rays, prepared.of, count, nearest);
    const uint64_t found =
        hits_of_others(kernels_.hits(prepared.of, nearest, count, out), count, out,
                       [&](uint32_t i, Hit& hit) { return hit_at(nearest[i], prepared.of[i].sheared, hit); });
    return found | begin_inside(
                       count, [&](uint32_t i) { return widen(*rays[i]); },
                       [&](uint32_t i, const Hit& hit) { *out[i] = to_hit(hit); });
}

void Mesh::carry_out(Hit& hit, const Ray& ray, const MeshPlace& place) const {
    hit.point = place.apply(hit.point);
    if (place.axes.is_one()) {
        hit.normal = place.world.rotation * hit.normal;
        return;
    }
    Vec3 face;
    if (hit.triangle != GPHYS_NO_TRIANGLE) {
        const Triangle corners = triangle(hit.triangle);
        face = accurate_cross(corners.a, corners.b, corners.a, corners.c);
    }
    // A degenerate triangle has no normal; the hit gets the reversed direction of the ray (hit_at, started_inside).
    if (face != Vec3{}) {
        const Vec3 normal = place.axes.normal(normalized(face));
        hit.normal = place.world.rotation * ((hit.flags & GPHYS_HIT_BACK) != 0 ? -normal : normal);
    } else if (ray.direction != Vec3{}) {
        hit.normal = -normalized(ray.direction);
    }
}

uint64_t Mesh::raycast_many(const Ray* rays, uint32_t count, const MeshPlace& place, gphys_hit* const* out) const {
    if (packets_.empty()) return 0;
    const auto placed = [&](uint32_t i, bool found, Hit& hit) {
        if (found) carry_out(hit, rays[i], place);
        return found;
    };
    if (is_cast_singly()) {
        return hits_of_others(
            0, count, out, [&](uint32_t i, Hit& hit) { return placed(i, raycast(carried(rays[i], place), hit), hit); });
    }
    PreparedRays prepared;
    NearestCrossing nearest[rays_at_once];
    kernels_.prepare_placed(rays, count, place, rays_root_, prepared.of);
    cross_many(kernels_.rays, prepared.of, count, nearest);
    const bool one = place.axes.is_one();
    const uint64_t made = one ? kernels_.placed_hits(prepared.of, nearest, count, place.world, out) : 0;
    const uint64_t found = hits_of_others(made, count, out, [&](uint32_t i, Hit& hit) {
        return placed(i, hit_at(nearest[i], prepared.of[i].sheared, hit), hit);
    });
    return found | begin_inside(
                       count, [&](uint32_t i) { return carried(rays[i], place); },
                       [&](uint32_t i, Hit& hit) {
                           placed(i, true, hit);
                           *out[i] = to_hit(hit);
                       });
}

uint64_t Mesh::distances_of(const PreparedRays& prepared, uint32_t count, gphys_distance* out) const {
    NearestCrossing nearest[rays_at_once];
    cross_many(kernels_.rays, prepared.of, count, nearest);
    return bits_of(count, [&](uint32_t i) {
        out[i] = distance_of(nearest[i]);
        return nearest[i].triangle != GPHYS_NO_TRIANGLE;
    });
}

uint64_t Mesh::any_of(const PreparedRays& prepared, uint32_t count) const {
    NearestCrossing nearest[rays_at_once];
    cross_many(kernels_.rays_any, prepared.of, count, nearest);
    return bits_of(count, [&](uint32_t i) { return nearest[i].triangle != GPHYS_NO_TRIANGLE; });
}

uint64_t Mesh::raycast_distance_many(const gphys_ray* const* rays, uint32_t count, gphys_distance* out) const {
    std::fill_n(out, count, no_distance);
    if (packets_.empty() || count == 0) return 0;
    if (count < fewest_rays || is_cast_singly())
        return bits_of(count, [&](uint32_t i) { return raycast_distance(widen(*rays[i]), out[i]); });
    PreparedRays prepared;
    kernels_.prepare(rays, count, rays_root_, prepared.of);
    return distances_of(prepared, count, out) | begin_inside(
                                                    count, [&](uint32_t i) { return widen(*rays[i]); },
                                                    [&](uint32_t i, const Hit& hit) {
                                                        out[i] = {reported(hit.t), 0, hit.triangle};
                                                    });
}

uint64_t Mesh::raycast_distance_many(const Ray* rays, uint32_t count, const MeshPlace& place,
                                     gphys_distance* out) const {
    std::fill_n(out, count, no_distance);
    if (packets_.empty()) return 0;
    if (is_cast_singly())
        return bits_of(count, [&](uint32_t i) { return raycast_distance(carried(rays[i], place), out[i]); });
    PreparedRays prepared;
    kernels_.prepare_placed(rays, count, place, rays_root_, prepared.of);
    return distances_of(prepared, count, out) | begin_inside(
                                                    count, [&](uint32_t i) { return carried(rays[i], place); },
                                                    [&](uint32_t i, const Hit& hit) {
                                                        out[i] = {reported(hit.t), 0, hit.triangle};
                                                    });
}

uint64_t Mesh::raycast_any_many(const gphys_ray* const* rays, uint32_t count) const {
    if (packets_.empty() || count == 0) return 0;
    if (count < fewest_rays_for_any || is_cast_singly())
        return bits_of(count, [&](uint32_t i) { return raycast_any(widen(*rays[i])); });
    PreparedRays prepared;
    kernels_.prepare(rays, count, rays_root_, prepared.of);
    return any_of(prepared, count) |
           begin_inside(
               count, [&](uint32_t i) { return widen(*rays[i]); }, [](uint32_t, const Hit&) {});
}

uint64_t Mesh::raycast_any_many(const Ray* rays, uint32_t count, const MeshPlace& place) const {
    if (packets_.empty()) return 0;
    if (is_cast_singly()) return bits_of(count, [&](uint32_t i) { return raycast_any(carried(rays[i], place)); });
    PreparedRays prepared;
    kernels_.prepare_placed(rays, count, place, rays_root_, prepared.of);
    return any_of(prepared, count) |
           begin_inside(
               count, [&](uint32_t i) { return carried(rays[i], place); }, [](uint32_t, const Hit&) {});
}

bool Mesh::raycast_any(const Ray& ray) const {
    if (is_links()) return raycast_any_links(ray);
    if (magnified_) return magnified_->raycast_any(magnified(ray));
    if (is_hull() && contains(ray.origin)) return true;
    return crossing_by(kernels_.any, ray).triangle != GPHYS_NO_TRIANGLE;
}

bool Mesh::closest_point(Vec3 point, double max_distance, Vec3& out, uint32_t& triangle, const AxisScale& axes) const {
    return closest_point(point, max_distance, reported_distance, limit_of_reported, out, triangle, axes);
}

bool Mesh::sweep_point_at_hull(const Ray& way, Hit& hit, const AxisScale& axes) const {
    if (axes.is_one()) return raycast(way, hit);
    const Transform still;
    const MeshPlace place{still, axes};
    if (!raycast(carried(way, place), hit)) return false;
    carry_out(hit, way, place);
    return true;
}

namespace {

template <class Solid>
bool sweep_until(double t_max, const Triangle& triangle, const Solid& moving, Vec3 displacement, Hit& hit) {
    return sweep(triangle, moving, displacement, hit, t_max);
}
/// A link.
template <class Item, class Solid>
bool sweep_until(double, const Item& item, const Solid& moving, Vec3 displacement, Hit& hit) {
    return sweep(item, moving, displacement, hit);
}

}  // namespace

template <class Half, class SweepItem>
bool Mesh::find_contact(Vec3 middle, const Half& half, Vec3 displacement, const SweepItem& sweep_item, Hit& hit,
                        Ties ties, const AxisScale& axes) const {
    const RayProbe probe(middle, displacement, half, bounds());
    // A hull is one solid: the triangle that is really hit first gives the normal.
    const bool as_reported = ties == Ties::as_reported && !is_hull();
    Hit first;
    double first_t = infinity;
    bvh_.sweep(middle, displacement, half, [&](uint32_t number, double& t_max) {
        const TrianglePacket& packet = packets_[number];
        const auto lanes_along = [&] { return kernels_.lanes_along(packet, probe, probe.limit(t_max)); };
        for_each_lane(lanes_by(packet, lanes_along), [&](int lane) {
            // No contact precedes one at the start, except that of a lower index.
            if (first_t == 0 && packet.index[lane] > first.triangle) return true;
            const double limit = limit_of_ties(t_max);
            Hit candidate;
            if (!with_item(packet, lane, axes, [&](const auto& item) { return sweep_item(item, limit, candidate); }))
                return true;
            candidate.triangle = packet.index[lane];
            const double t = as_reported ? reported(candidate.t) : candidate.t;
            if (t < first_t || (t == first_t && candidate.triangle < first.triangle)) {
                first = candidate;
                first_t = t;
                t_max = std::min(t_max, as_reported ? limit_of_ties(t) : t);
            }
            return true;
        });
    });
    if (first.triangle == GPHYS_NO_TRIANGLE) return false;
    hit = first;
    if (is_hull()) hit.flags &= ~uint32_t{GPHYS_HIT_BACK};  // set by a triangle that is hit at its edge
    return true;
}

bool Mesh::sweep(const Sphere& moving, Vec3 displacement, Hit& hit, Ties ties, const AxisScale& axes,
                 Faces faces) const {
    if (packets_.empty()) return false;
    if (magnified_) {
        const Sphere larger{moving.center * magnification_, moving.radius * magnification_};
        return magnified_->sweep(larger, displacement * magnification_, hit, ties, axes, faces) && reduce(hit);
    }
    if (is_hull()) {
        if (is_sharp(moving, displacement, axes))
            return sweep_point_at_hull({moving.center, displacement, 1}, hit, axes);
        if (overlaps(moving, axes)) {
            start_in_hull(moving, displacement, hit, axes);
            return true;
        }
    }
    const auto sweep_item = [&](const auto& item, double t_max, Hit& candidate) {
        return (is_hull() || hits_side(item, displacement, faces)) &&
               sweep_until(t_max, item, moving, displacement, candidate);
    };
    const Vec3 half = axes.inverse(Vec3{moving.radius, moving.radius, moving.radius});
    const bool is_hit =
        axes.is_one()
            ? find_contact(moving.center, moving.radius, displacement, sweep_item, hit, ties, axes)
            : find_contact(axes.inverse(moving.center), half, axes.inverse(displacement), sweep_item, hit, ties, axes);
    if (is_hit && is_hull()) use_hull_normal(moving, displacement, hit, axes);
    return is_hit;
}

bool Mesh::sweep(const Shape& moving, Vec3 displacement, Hit& hit, const AxisScale& axes, Faces faces) const {
    if (packets_.empty()) return false;
    if (const auto* sphere = std::get_if<Sphere>(&moving)) {
        return sweep(*sphere, displacement, hit, Ties::as_reported, axes, faces);
    }
    const BoxInMotion box(moving);
    const Aabb extent = axes(bounds());
    const Vec3 half = box.half_with_rounding(gphys::bounds(extent), displacement);
    if (is_hull()) {
        const Vec3 center = axes(center_), reach = half + (extent.max - center);
        const double margin = 0x1p-48 * sum(abs(box.middle) + abs(center) + reach);
        if (!RayAndBox<Vec3>(box.middle - center, reach, margin, displacement, 0, 1).may_hit()) return false;
        if (overlaps(moving, axes)) {
            start_in_hull(moving, hit, axes);
            return true;
        }
        if (is_sharp(moving, displacement, axes)) {
            if (const std::optional<bool> swept = sweep_sharp_at_hull(moving, displacement, hit, axes)) return *swept;
        }
    }
    const auto sweep_item = [&](const auto& item, double t_max, Hit& candidate) {
        return (is_hull() || hits_side(item, displacement, faces)) &&
               sweep_until(t_max, item, moving, displacement, candidate);
    };
    if (!find_contact(axes.inverse(box.middle), axes.inverse(half), axes.inverse(displacement), sweep_item, hit,
                      Ties::as_reported, axes)) {
        return false;
    }
    if (is_hull()) use_hull_normal(moving, displacement, hit, axes);
    return true;
}

}  // namespace gphys
