// A triangle mesh with its own BVH. Immutable unless it was created as deformable, so models, scenes and threads can
// share it. Reference counted.
//
//   mesh.cpp            creation and queries
//   mesh_overlap.cpp    overlaps with shapes and other meshes
//   links.cpp           queries of capsules in place of triangles
//   hull.cpp            queries of a convex hull, which is solid
//   deform.cpp          new vertices
//   mesh_snapshot.cpp   snapshots
//
// The items of the BVH are packets of up to eight triangles. Queries are in the mesh's local space. Their results are
// those of testing every triangle: the tree and the packets only reject triangles, conservatively (box8.h,
// triangle_probe.h). Of results that are equal as reported, the lower index wins.
#pragma once

#include <atomic>
#include <optional>

#include "bvh/bvh8.h"
#include "foundation/results.h"
#include "foundation/word_hash.h"
#include "mesh/corner_inside.h"
#include "mesh/hull.h"
#include "mesh/mesh_kernels.h"
#include "mesh/mesh_place.h"
#include "mesh/mesh_ray.h"
#include "mesh/mesh_snapshot.h"
#include "mesh/mesh_users.h"
#include "mesh/near_kernels.h"

namespace gphys {

struct Core;

class Mesh {
public:
    /// `report` is the report of the arrays. It must list no bad vertex and no index out of range.
    Mesh(const gphys_allocator* hooks, const MeshArrays& arrays, const gphys_mesh_report& report,
         Isa isa = chosen_isa(), bool deformable = false);
    /// From the parts of a valid snapshot. The mesh keeps no reference to them.
    Mesh(const gphys_allocator* hooks, const MeshParts& parts, bool deformable);
    ~Mesh() {
        if (magnified_) release(magnified_);
    }
    Mesh(const Mesh&) = delete;
    Mesh& operator=(const Mesh&) = delete;

    void retain() const noexcept { holds_.fetch_add(1, std::memory_order_relaxed); }
    /// Whether the caller holds the only reference.
    bool is_held_once() const noexcept { return holds_.load(std::memory_order_acquire) == 1; }
    static void release(const Mesh* mesh) noexcept;

    MeshKind kind() const { return kind_; }
    bool is_hull() const { return kind_ == MeshKind::hull; }
    bool is_body() const { return kind_ == MeshKind::body_surface || kind_ == MeshKind::body_links; }
    bool deformable() const { return users_.has_value(); }
    /// Replaces the vertices of a deformable mesh by as many valid ones, and the radii of links unless `arrays.radii`
    /// is null. Afterwards all queries answer as if the mesh had been created from them. Returns why a model cannot
    /// follow the change, or null. On failure, or if it throws std::bad_alloc, nothing has changed.
    const char* set_vertices(const MeshArrays& arrays);
    /// The same with other corners of as many triangles, and other vertices: of cloth that has torn.
    const char* set_surface(const MeshArrays& arrays);
    /// Call after new vertices that are the old ones shifted by `by`: the models of a deformable mesh stay where they
    /// were.
    void shift_models(Vec3 by) const noexcept { users_->mesh_shifted(by); }
    /// Set by solvers while a body leads this deformable mesh, that is, sets its vertices.
    void set_led(bool led) noexcept { led_ = led; }
    bool led() const { return led_; }
    /// Registers models for notification of changes. Does nothing if the mesh is not deformable.
    void join(MeshUser& user, const uint32_t* models, uint32_t count) const {
        if (users_) users_->join(user, models, count);
    }
    void leave(MeshUser& user, uint32_t model) const noexcept {
        if (users_) users_->leave(user, model);
    }

    uint32_t triangle_count() const { return report_.triangle_count; }
    Triangle triangle(uint32_t index) const {
        const uint32_t* corner = indices_.data() + size_t{3} * index;
        return {widen(vertices_[corner[0]]), widen(vertices_[corner[1]]), widen(vertices_[corner[2]])};
    }
    const Vector<gphys_vec3>& vertices() const { return vertices_; }
    const Vector<uint32_t>& indices() const { return indices_; }
    /// Counts of the current vertices.
    gphys_mesh_report report() const;
    /// Empty if there are no triangles.
    Box bounds() const { return bvh_.bounds(); }
    /// Centre of the bounds, and a bound for the distance of the vertices from it. With `axes`: of the scaled mesh,
    /// from the scaled centre.
    Vec3 center() const { return center_; }
    double radius() const { return radius_; }
    double radius(const AxisScale& axes) const;
    /// The same as floats, rounded outward.
    const gphys_sphere& ball() const { return ball_; }
    /// Hash of the contents: equal meshes have equal hashes.
    uint64_t hash() const { return hash_; }
    /// Empty unless the mesh is a hull.
    const Hull& hull() const { return hull_; }
    const Bvh8& bvh() const { return bvh_; }
    const Vector<TrianglePacket>& packets() const { return packets_; }

    /// See gphys_mesh_get_snapshot.
    gphys_status snapshot(uint32_t* out, uint32_t capacity, uint32_t& total) const;

    /// Statistics of the tree as if triangles were its items: the leaves are the packets.
    gphys_octree_stats bvh_stats() const;
    /// Visits each box of that tree, parents first: visit(gphys_octree_box).
    template <class Visit>
    void for_each_box(Visit&& visit) const;

    bool raycast(const Ray& ray, Hit& hit) const;
    /// The same, rounded.
    bool raycast(const Ray& ray, gphys_hit& hit) const;
    /// Whether cross_placed answers the ray.
    bool crosses_placed(const Ray& ray) const { return !ray.is_segment && is_plain(); }
    /// MeshKernels::closest_placed, or with `any` any_placed.
    bool cross_placed(bool any, const Ray& ray, const gphys_transform& world, const Vec3& axes,
                      NearestCrossing& nearest, gphys_hit* hit) const {
        const auto kernel = any ? kernels_.any_placed : kernels_.closest_placed;
        return kernel(tree(), ray, &world.position.x, axes, nearest, hit);
    }
    /// The first hit of the ray: its t and triangle, as they are reported.
    bool raycast_distance(const Ray& ray, gphys_distance& out) const;
    /// The same answers for up to rays_at_once rays, rounded: bit i of the result is set if *rays[i] hits, and then
    /// *out[i] has the hit. Faster than single rays, and more so for coherent ones.
    static constexpr uint32_t rays_at_once = Bvh8::rays_at_once;
    uint64_t raycast_many(const gphys_ray* const* rays, uint32_t count, gphys_hit* const* out) const;
    /// The same for a mesh at `place`, and for rays in double precision that are no segments.
    uint64_t raycast_many(const Ray* rays, uint32_t count, const MeshPlace& place, gphys_hit* const* out) const;
    /// Transforms a hit of a world-space ray from the mesh's space to the world.
    void carry_out(Hit& hit, const Ray& ray, const MeshPlace& place) const;
    bool raycast_any(const Ray& ray) const;
    /// For up to rays_at_once rays: *out[i] gets the t and triangle that raycast_many reports; bit i of the result is
    /// set if ray i hits.
    uint64_t raycast_distance_many(const gphys_ray* const* rays, uint32_t count, gphys_distance* out) const;
    uint64_t raycast_distance_many(const Ray* rays, uint32_t count, const MeshPlace& place, gphys_distance* out) const;
    /// Bit i of the result is set if rays[i] hits anything.
    uint64_t raycast_any_many(const gphys_ray* const* rays, uint32_t count) const;
    uint64_t raycast_any_many(const Ray* rays, uint32_t count, const MeshPlace& place) const;
    /// Every triangle that the ray hits, in no particular order: visit(const Hit&).
    template <class Visit>
    void raycast_all(const Ray& ray, Visit&& visit) const;

    // The following functions are about the scaled mesh, in its frame (mesh_place.h). Links only have the scale 1.

    /// Whether a hull contains the point, exactly. False for other meshes.
    bool contains(Vec3 point, const AxisScale& axes = {}) const;
    /// False if no point is within max_distance. Inside a hull, the result is the point itself, without a triangle.
    bool closest_point(Vec3 point, double max_distance, Vec3& out, uint32_t& triangle,
                       const AxisScale& axes = {}) const;
    /// The same, but points are compared by distance_of(point of a triangle, its squared distance in the mesh), a float
    /// or a double. A point beyond limit_of(distance) in the mesh cannot tie with it. An infinite distance counts as no
    /// result.
    template <class DistanceOf, class LimitOf>
    bool closest_point(Vec3 point, double max_distance, const DistanceOf& distance_of, const LimitOf& limit_of,
                       Vec3& out, uint32_t& triangle, const AxisScale& axes = {}) const;
    /// The first form for up to points_at_once points, without a limit or scales: found(i, point, triangle) for each
    /// that has a closest point.
    static constexpr uint32_t points_at_once = Bvh8::points_at_once;
    template <class Found>
    void closest_point_many(const Vec3* points, uint32_t count, Found&& found) const;
    /// On surfaces, `faces` selects the sides of triangles that can be hit.
    bool sweep(const Sphere& moving, Vec3 displacement, Hit& hit, Ties ties = Ties::as_reported,
               const AxisScale& axes = {}, Faces faces = {}) const;
    /// For a moving sphere, capsule or box.
    bool sweep(const Shape& moving, Vec3 displacement, Hit& hit, const AxisScale& axes = {}, Faces faces = {}) const;
    bool overlaps(const Shape& shape, const AxisScale& axes = {}) const;
    /// Without scales.
    bool overlaps(const Mesh& other) const;
    /// Visits every triangle (of the surface, not the solid) that overlaps the shape: visit(triangle).
    template <class Visit>
    void for_each_overlap(const Shape& shape, const Visit& visit, const AxisScale& axes = {}) const {
        const auto visit_some = [](void* context, const uint32_t* triangles, uint32_t count) {
            for (uint32_t i = 0; i < count; ++i) (*static_cast<const Visit*>(context))(triangles[i]);
        };
        find_overlaps(shape, {visit_some, const_cast<Visit*>(&visit)}, axes);
    }
    /// Lists these triangles.
    void list_overlaps(const Shape& shape, Smallest<uint32_t>& out) const;
    /// Visits the penetration of a sphere, capsule or box into each triangle that it overlaps: visit(Penetration,
    /// triangle). A hull has one penetration, without a triangle.
    template <class Visit>
    void for_each_penetration(const Shape& moving, Visit&& visit, const AxisScale& axes = {}) const {
        if (is_hull()) {
            if (overlaps(moving, axes)) visit(penetration_of_hull(moving, axes), GPHYS_NO_TRIANGLE);
            return;
        }
        const auto visit_way_out = [&](uint32_t index) {
            if (is_links()) {
                visit(penetration(link(triangle(index), index), moving), index);
            } else {
                visit(penetration(axes(triangle(index)), moving), index);
            }
        };
        for_each_overlap(moving, visit_way_out, axes);
    }

    Memory memory;

private:
    /// Without packets and tree, which the public constructors add.
    Mesh(const gphys_allocator* hooks, const MeshArrays& arrays, const gphys_mesh_report& report, WordHash index_hash,
         Isa isa, bool deformable);
    /// The mesh's own arrays.
    MeshArrays arrays() const;

    bool is_links() const { return kind_ == MeshKind::body_links; }
    /// Whether rays meet the triangles and nothing else.
    bool is_plain() const { return !magnified_ && !is_links() && !is_hull() && !packets_.empty(); }
    /// Whether the rays of a batch are cast one by one.
    bool is_cast_singly() const { return magnified_ || is_links(); }
    /// The solid overlaps the hull.
    Penetration penetration_of_hull(const Shape& moving, const AxisScale& axes) const;
    /// An upper bound for the coordinates of the Minkowski difference of the hull and a core, both relative to `from`.
    double hull_size(const Core& core, Vec3 from, const AxisScale& axes) const;
    /// The contact point of a hull and a core, relative to `from`, after moving them along the normal by their
    /// distance.
    Vec3 contact_on_hull(const Core& core, Vec3 from, Vec3 normal, double distance, double size,
                         uint32_t& nearest_triangle, const AxisScale& axes) const;
    /// Whether the radius of a moving solid is too small to change the answer.
    bool is_sharp(const Shape& moving, Vec3 displacement, const AxisScale& axes) const;
    /// Sweeps such a solid, without its radius, against the hull as a whole. It does not overlap at the start. Sweeps
    /// against single triangles would fail: at an edge of the hull, rounding may miss each of the triangles, and their
    /// edges have normals that the hull does not have. No result if rounding leaves it undecided.
    std::optional<bool> sweep_sharp_at_hull(const Shape& moving, Vec3 displacement, Hit& hit,
                                            const AxisScale& axes) const;
    /// From the hull to the core along a unit vector, both relative to `from`.
    double gap_along(Vec3 unit, const Core& core, Vec3 from, const AxisScale& axes) const;
    /// The normal of a contact, or another one if the plane across it does not separate hull and core.
    Vec3 normal_at_hull(const Core& core, Vec3 from, Vec3 displacement, Vec3 normal, double size,
                        const AxisScale& axes) const;
    /// Replaces a normal that only a triangle has by a normal of the hull.
    void use_hull_normal(const Shape& moving, Vec3 displacement, Hit& hit, const AxisScale& axes) const;
    bool sweep_point_at_hull(const Ray& way, Hit& hit, const AxisScale& axes) const;
    void start_in_hull(const Sphere& moving, Vec3 displacement, Hit& hit, const AxisScale& axes) const;
    void start_in_hull(const Shape& moving, Hit& hit, const AxisScale& axes) const;
    /// Whether some point of the shape, if it has any, is in this hull.
    bool contains_point_of(const Shape& shape, const AxisScale& axes) const;
    /// Whether the first corner of some triangle of the other mesh is in this hull.
    bool contains_part_of(const Mesh& other) const;
    Capsule link(const Triangle& triangle, uint32_t index) const { return {triangle.a, triangle.b, radii_[index]}; }
    /// visit(item), where item is the scaled triangle, or the capsule that the triangle represents.
    template <class Visit>
    auto with_item(const TrianglePacket& packet, int lane, const AxisScale& axes, Visit&& visit) const {
        if (is_links()) return visit(link(packet.triangle(lane), packet.index[lane]));
        return visit(axes(packet.triangle(lane)));
    }
    template <class Solid, class Item>
    static bool overlaps_item(const Solid& solid, const Item& item) {
        return has_corner_inside(solid, item) || gphys::overlaps(solid, item);
    }
    /// The used lanes of the packet; of links, those that exist.
    uint32_t lanes_of(const TrianglePacket& packet) const { return is_links() ? links_of(packet) : packet.lanes(); }
    uint32_t links_of(const TrianglePacket& packet) const;
    /// The lanes that a conservative test does not reject; of links, all.
    template <class Test>
    uint32_t lanes_by(const TrianglePacket& packet, Test&& test) const {
        return is_links() ? links_of(packet) : test();
    }
    uint32_t lanes_in_box(const TrianglePacket& packet, const Box& box) const {
        return lanes_by(packet, [&] { return kernels_.lanes_in_box(packet, box); });
    }
    /// The bounding box of all items of the packet.
    Box box_of(const TrianglePacket& packet) const;
    bool raycast_links(const Ray& ray, Hit& hit) const;
    bool raycast_any_links(const Ray& ray) const;
    template <class Visit>
    void raycast_all_links(const Ray& ray, Visit&& visit) const;
    /// Partitions the triangles into packets and builds the tree. If it throws std::bad_alloc, nothing has changed.
    void pack();
    void note_packed_area(const Vector<Box>& boxes);
    /// Refits packets and tree to the current vertices. Returns the total area of the packets' boxes.
    double refit() noexcept;
    /// Computes what depends on the vertices and the tree: radius, ball, hash.
    void measure() noexcept;
    static WordHash hash_of_indices(const MeshArrays& arrays);
    /// The magnified mesh of these arrays, or null if they need none.
    const Mesh* make_magnified(const MeshArrays& of, const gphys_mesh_report& report, double& magnification) const;
    /// Exchanges the vertices and radii with the next ones, the magnified mesh with this one, and what exchange_more()
    /// exchanges. See set_vertices.
    template <class ExchangeMore>
    const char* exchange_vertices(const Mesh* magnified, double magnification, ExchangeMore&& exchange_more);

    /// Storage for many prepared rays, without initialisation.
    union PreparedRays {
        PreparedRays() {}
        PreparedRay of[rays_at_once];
    };
    MeshTree tree() const {
        return {bvh_.nodes(), bvh_.root(), is_hull(), packets_.data(), rays_root_, center_, radius_, crosses_alone};
    }
    /// MeshTree::exact
    static bool crosses_alone(const Ray& ray, const TrianglePacket& packet, uint32_t lane, TriangleCrossing& crossing);
    NearestCrossing crossing_by(decltype(MeshKernels::closest) kernel, const Ray& ray) const;
    /// at(i, hit) for each ray, in the mesh's own space, that begins inside a hull. Returns their bits.
    template <class RayOf, class At>
    uint64_t begin_inside(uint32_t count, const RayOf& ray_of, const At& at) const;
    /// Runs kernels_.rays or rays_any on the ray packets that the rays are split into.
    void cross_many(decltype(MeshKernels::rays) kernel, const PreparedRay* rays, uint32_t count,
                    NearestCrossing* nearest) const;
    uint64_t distances_of(const PreparedRays& prepared, uint32_t count, gphys_distance* out) const;
    uint64_t any_of(const PreparedRays& prepared, uint32_t count) const;
    /// Visits the packets with triangles that the ray may hit, roughly front to back. visit(packet, lanes) returns the
    /// new limit; a negative one ends the traversal.
    template <class Visit>
    void traverse(const PreparedRay& ray, Visit&& visit) const;

    // Implementations of raycast_all and closest_point, for this mesh or for the magnified one.
    template <class Visit>
    void cross_all(const Ray& ray, Visit&& visit) const;
    template <class DistanceOf, class LimitOf>
    class ClosestSearch;
    template <class DistanceOf, class LimitOf>
    bool find_closest(Vec3 point, double max_distance, const DistanceOf& distance_of, const LimitOf& limit_of,
                      Vec3& out, uint32_t& triangle, const AxisScale& axes) const;
    /// The first triangle hit by a moving solid whose bounding box has half extents `half` around `middle`.
    template <class Half, class SweepItem>
    bool find_contact(Vec3 middle, const Half& half, Vec3 displacement, const SweepItem& sweep_item, Hit& hit,
                      Ties ties, const AxisScale& axes) const;
    /// Converts a query to the coordinates of the magnified mesh; reduce converts the answer back.
    Ray magnified(const Ray& ray) const;
    bool reduce(Hit& hit) const {
        hit.point = hit.point / magnification_;
        return true;
    }

    /// Called with triangles that overlap the shape. Without a function the first one ends the search.
    struct OverlapVisitor {
        void (*visit)(void* context, const uint32_t* triangles, uint32_t count);
        void* context;
    };
    /// Whether a triangle overlaps the shape.
    bool find_overlaps(const Shape& shape, const OverlapVisitor& to, const AxisScale& axes) const;

    mutable std::atomic<uint32_t> holds_{1};
    const MeshKernels& kernels_;
    const NearKernels& near_kernels_;
    gphys_mesh_report report_;
    Vector<gphys_vec3> vertices_{&memory};
    Vector<uint32_t> indices_{&memory};
    Vector<float> radii_{&memory};  // of links
    Vector<TrianglePacket> packets_{&memory};
    Bvh8 bvh_;
    RootBounds rays_root_;
    RayPackets ray_packets_;
    Vec3 center_;
    double radius_ = 0;
    gphys_sphere ball_{};
    uint64_t hash_ = 0;
    // Only for meshes so small that the margin of the float tests, which must stay above subnormal numbers, would leave
    // almost nothing to reject: the same mesh times a power of two. It answers raycasts, sweeps and closest points with
    // the same bits, because the multiplication is exact.
    const Mesh* magnified_ = nullptr;
    double magnification_ = 1;
    Hull hull_{&memory};

    const Isa isa_;
    const MeshKind kind_;
    bool led_ = false;
    WordHash index_hash_;
    double packed_area_ = 0, packed_root_area_ = 0;  // at the last packing: of the packets' boxes, of the root
    // Only for deformable meshes:
    mutable std::optional<MeshUsers> users_;
    Vector<gphys_vec3> next_vertices_{&memory};  // the candidates during set_vertices; otherwise the previous ones
    Vector<float> next_radii_{&memory};
};

template <class Visit>
void Mesh::traverse(const PreparedRay& ray, Visit&& visit) const {
    if (packets_.empty()) return;
    using Function = std::remove_reference_t<Visit>;
    const auto step = [](void* context, const TrianglePacket& packet, uint32_t lanes) {
        return (*static_cast<Function*>(context))(packet, lanes);
    };
    kernels_.ray(bvh_.nodes(), bvh_.root(), packets_.data(), ray,
                 {step, const_cast<void*>(static_cast<const void*>(&visit))});
}

template <class Visit>
void Mesh::raycast_all(const Ray& ray, Visit&& visit) const {
    if (is_links()) return raycast_all_links(ray, visit);
    if (is_hull()) {
        Hit hit;
        if (raycast(ray, hit)) visit(hit);
        return;
    }
    if (!magnified_) return cross_all(ray, visit);
    magnified_->cross_all(magnified(ray), [&](Hit hit) {
        reduce(hit);
        visit(hit);
    });
}

template <class Visit>
void Mesh::raycast_all_links(const Ray& ray, Visit&& visit) const {
    bvh_.raycast(ray, ray.t_max, [&](uint32_t number, double&) {
        const TrianglePacket& packet = packets_[number];
        for_each_lane(links_of(packet), [&](int lane) {
            Hit hit;
            if (!gphys::raycast(link(packet.triangle(lane), packet.index[lane]), ray, hit)) return true;
            hit.triangle = packet.index[lane];
            visit(hit);
            return true;
        });
    });
}

template <class Visit>
void Mesh::cross_all(const Ray& ray, Visit&& visit) const {
    const PreparedRay prepared(ray, rays_root_);
    traverse(prepared, [&](const TrianglePacket& packet, uint32_t lanes) {
        for_each_lane(lanes, [&](int lane) {
            const Triangle corners = packet.triangle(lane);
            TriangleCrossing crossing;
            if (!crosses(corners, prepared.sheared, crossing)) return true;
            Hit hit;
            make_hit(corners, prepared.sheared, crossing, hit);
            hit.triangle = packet.index[lane];
            visit(hit);
            return true;
        });
        return prepared.limit;
    });
}

template <class Visit>
void Mesh::for_each_box(Visit&& visit) const {
    bvh_.for_each_box(
        [&](gphys_octree_box box) {
            box.item_count = 0;
            visit(box);
        },
        [&](uint32_t number, gphys_octree_box box) {
            box.item_count = packets_[number].count();
            visit(box);
        });
}

}  // namespace gphys
