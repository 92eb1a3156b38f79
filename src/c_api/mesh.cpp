// gphys_mesh_*: creation, vertices, snapshots, and queries of one mesh in its own coordinates.
#include "mesh/mesh.h"

#include "c_api/api.h"
#include "c_api/handles.h"
#include "c_api/lists.h"
#include "c_api/mesh_desc.h"
#include "c_api/mesh_tiles.h"
#include "c_api/shape_input.h"
#include "foundation/results.h"
#include "mesh/convex_hull.h"

using namespace gphys;

namespace {

gphys_status check_arrays(const MeshArrays& arrays) {
    GPHYS_REQUIRE(arrays.vertex_count == 0 || arrays.vertices, "vertices is null");
    GPHYS_TRY(check_spacing("vertex_stride", arrays.vertex_stride, sizeof(gphys_vec3)));
    GPHYS_REQUIRE(arrays.index_count == 0 || arrays.indices, "indices is null");
    GPHYS_REQUIRE_IN_RANGE(arrays.index_count % 3 == 0, "index_count", arrays.index_count, "a multiple of 3");
    return GPHYS_OK;
}

gphys_status check_indices(const MeshArrays& arrays, uint32_t triangle) {
    for (uint32_t i = 3 * triangle; i < 3 * triangle + 3; ++i) {
        if (arrays.indices[i] < arrays.vertex_count) continue;
        const double index = arrays.indices[i];
        return fail(GPHYS_ERROR_INVALID_ARGUMENT, "indices", i, Defect{"", 0, index, "below vertex_count"});
    }
    return GPHYS_OK;
}

gphys_status check_rays(const gphys_ray* rays, uint32_t ray_stride, uint32_t count) {
    GPHYS_REQUIRE(rays || count == 0, "rays is null");
    GPHYS_TRY(check_stride("ray_stride", ray_stride, sizeof *rays, count));
    const Strided<gphys_ray> each(rays, ray_stride);
    for (uint32_t i = 0; i < count; ++i) GPHYS_TRY(check_element("rays", i, each[i]));
    return GPHYS_OK;
}

gphys_status reject_deformable_hull(const gphys_mesh_desc& desc) {
    if (desc.deformable == 0) return GPHYS_OK;
    return fail(GPHYS_ERROR_UNSUPPORTED, "desc.deformable: a hull cannot be deformable");
}

gphys_status check_hull(const gphys_mesh* mesh) {
    GPHYS_REQUIRE_POINTERS(mesh);
    return unwrap(mesh)->is_hull() ? GPHYS_OK : fail(GPHYS_ERROR_UNSUPPORTED, "mesh: it is not a hull");
}

}  // namespace

gphys_status gphys_mesh_check(const float* vertices, uint32_t vertex_stride, uint32_t vertex_count,
                              const uint32_t* indices, uint32_t index_count, gphys_mesh_report* out_report) {
    return guarded(__func__, [&]() -> gphys_status {
        const MeshArrays arrays{vertices, vertex_stride, vertex_count, indices, index_count};
        GPHYS_TRY(check_arrays(arrays));
        GPHYS_REQUIRE_POINTERS(out_report);
        Memory memory(nullptr);
        *out_report = examine(arrays, &memory);
        return GPHYS_OK;
    });
}

gphys_status gphys_mesh_desc_init(gphys_mesh_desc* desc, uint32_t size) {
    return guarded(__func__, [&] { return write_desc(desc, size, gphys_mesh_desc{}, mesh_desc_size); });
}

gphys_status gphys_mesh_create(const gphys_mesh_desc* desc, const float* vertices, uint32_t vertex_stride,
                               uint32_t vertex_count, const uint32_t* indices, uint32_t index_count,
                               gphys_mesh** out_mesh) {
    return guarded(__func__, [&]() -> gphys_status {
        gphys_mesh_desc settings{};
        GPHYS_TRY(read_mesh_desc(desc, settings));
        const MeshArrays arrays{vertices, vertex_stride, vertex_count, indices, index_count};
        GPHYS_TRY(check_arrays(arrays));
        GPHYS_REQUIRE_POINTERS(out_mesh);
        Memory memory(settings.allocator);
        const gphys_mesh_report report = examine(arrays, &memory);
        if (report.bad_vertex_count > 0) {
            GPHYS_TRY(check_element("vertices", report.first_bad_vertex, arrays.vertex(report.first_bad_vertex)));
        }
        GPHYS_REQUIRE(report.bad_vertex_count == 0, "vertices: a vertex is out of range (see gphys_mesh_check)");
        if (report.out_of_range_count > 0) GPHYS_TRY(check_indices(arrays, report.first_out_of_range));
        GPHYS_REQUIRE(report.out_of_range_count == 0,
                      "indices: an index is not below vertex_count (see gphys_mesh_check)");
        *out_mesh = wrap(create<Mesh>(settings.allocator, arrays, report, chosen_isa(), settings.deformable != 0));
        return GPHYS_OK;
    });
}

gphys_status gphys_mesh_create_hull(const gphys_mesh_desc* desc, const float* points, uint32_t point_stride,
                                    uint32_t point_count, gphys_mesh** out_mesh) {
    return guarded(__func__, [&]() -> gphys_status {
        gphys_mesh_desc settings{};
        GPHYS_TRY(read_mesh_desc(desc, settings));
        GPHYS_TRY(reject_deformable_hull(settings));
        GPHYS_REQUIRE(point_count == 0 || points, "points is null");
        GPHYS_TRY(check_spacing("point_stride", point_stride, sizeof(gphys_vec3)));
        GPHYS_REQUIRE_POINTERS(out_mesh);
        const MeshArrays arrays{points, point_stride, point_count, nullptr, 0};
        for (uint32_t i = 0; i < point_count; ++i) GPHYS_TRY(check_element("points", i, arrays.vertex(i)));
        Memory memory(settings.allocator);
        HullSurface hull(&memory);
        switch (make_hull(arrays, hull)) {
            case HullDefect::flat:
                return invalid("points: all lie in a plane");
            case HullDefect::too_many_faces:
                return fail(GPHYS_ERROR_CAPACITY, "points: their hull would have more than 256 faces");
            case HullDefect::none:
                break;
        }
        const MeshArrays surface{&hull.vertices[0].x,
                                 sizeof(gphys_vec3),
                                 static_cast<uint32_t>(hull.vertices.size()),
                                 hull.indices.data(),
                                 static_cast<uint32_t>(hull.indices.size()),
                                 MeshKind::hull};
        *out_mesh = wrap(create<Mesh>(settings.allocator, surface, examine(surface, &memory)));
        return GPHYS_OK;
    });
}

gphys_status gphys_mesh_get_hull_planes(const gphys_mesh* mesh, gphys_plane* out_planes, uint32_t capacity,
                                        uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_hull(mesh));
        GPHYS_TRY(check_list("out_planes", out_planes, capacity, out_total));
        const Vector<Hull::Face>& faces = unwrap(mesh)->hull().faces();
        const uint32_t total = static_cast<uint32_t>(faces.size());
        for (uint32_t i = 0; i < std::min(total, capacity); ++i) {
            out_planes[i] = {narrow(faces[i].normal), reported(dot(faces[i].normal, faces[i].triangle.a))};
        }
        return listed(total, capacity, out_total);
    });
}

gphys_status gphys_mesh_get_hull_faces(const gphys_mesh* mesh, uint32_t* out_faces, uint32_t capacity,
                                       uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_hull(mesh));
        return list_copy(unwrap(mesh)->hull().face_of(), "out_faces", out_faces, capacity, out_total);
    });
}

gphys_status gphys_mesh_set_vertices(gphys_mesh* mesh, const float* vertices, uint32_t vertex_stride,
                                     uint32_t vertex_count) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh);
        Mesh& changed = *unwrap(mesh);
        if (!changed.deformable())
            return fail(GPHYS_ERROR_UNSUPPORTED, "mesh: desc.deformable was 0 when it was created");
        if (changed.led()) return fail(GPHYS_ERROR_UNSUPPORTED, "mesh: it follows a body of a solver");
        GPHYS_REQUIRE_IN_RANGE(vertex_count == changed.vertices().size(), "vertex_count", vertex_count,
                               "that of the mesh");
        const MeshArrays arrays{vertices, vertex_stride, vertex_count, nullptr, 0};
        GPHYS_TRY(check_arrays(arrays));
        for (uint32_t i = 0; i < vertex_count; ++i) GPHYS_TRY(check_element("vertices", i, arrays.vertex(i)));
        if (const char* wrong = changed.set_vertices(arrays)) return invalid(wrong);
        return GPHYS_OK;
    });
}

void gphys_mesh_destroy(gphys_mesh* mesh) {
    guarded(__func__, [&] {
        if (mesh) Mesh::release(unwrap(mesh));
    });
}

gphys_status gphys_mesh_get_info(const gphys_mesh* mesh, gphys_mesh_info* out_info) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh, out_info);
        const Mesh& m = *unwrap(mesh);
        *out_info = {static_cast<gphys_mesh_kind>(m.kind()), static_cast<uint32_t>(m.vertices().size()),
                     m.triangle_count(), m.deformable(), m.led()};
        return GPHYS_OK;
    });
}

gphys_status gphys_mesh_get_report(const gphys_mesh* mesh, gphys_mesh_report* out_report) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh, out_report);
        *out_report = unwrap(mesh)->report();
        return GPHYS_OK;
    });
}

gphys_status gphys_mesh_get_vertices(const gphys_mesh* mesh, gphys_vec3* out_vertices, uint32_t capacity,
                                     uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh);
        return list_copy(unwrap(mesh)->vertices(), "out_vertices", out_vertices, capacity, out_total);
    });
}

gphys_status gphys_mesh_get_indices(const gphys_mesh* mesh, uint32_t* out_indices, uint32_t capacity,
                                    uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh);
        return list_copy(unwrap(mesh)->indices(), "out_indices", out_indices, capacity, out_total);
    });
}

gphys_status gphys_mesh_get_snapshot(const gphys_mesh* mesh, uint32_t* out_words, uint32_t capacity,
                                     uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh);
        GPHYS_TRY(check_list("out_words", out_words, capacity, out_total));
        return unwrap(mesh)->snapshot(out_words, capacity, *out_total);
    });
}

gphys_status gphys_mesh_create_from_snapshot(const gphys_mesh_desc* desc, const uint32_t* words, uint32_t word_count,
                                             gphys_mesh** out_mesh) {
    return guarded(__func__, [&]() -> gphys_status {
        gphys_mesh_desc settings{};
        GPHYS_TRY(read_mesh_desc(desc, settings));
        GPHYS_REQUIRE_POINTERS(words, out_mesh);
        Memory memory(settings.allocator);
        MeshParts parts;
        if (const char* wrong = read_mesh_snapshot(words, word_count, &memory, parts)) return invalid(wrong);
        if (parts.arrays.kind == MeshKind::hull) GPHYS_TRY(reject_deformable_hull(settings));
        *out_mesh = wrap(create<Mesh>(settings.allocator, parts, settings.deformable != 0));
        return GPHYS_OK;
    });
}

gphys_status gphys_mesh_raycast_all(const gphys_mesh* mesh, const gphys_ray* ray, gphys_hit* out_hits,
                                    uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh);
        GPHYS_REQUIRE_INPUT(ray);
        GPHYS_TRY(check_list("out_hits", out_hits, capacity, out_total));
        const auto earlier = [](const gphys_hit& a, const gphys_hit& b) {
            return a.t < b.t || (a.t == b.t && a.triangle < b.triangle);
        };
        Smallest<gphys_hit, decltype(earlier)> hits(out_hits, capacity, earlier);
        unwrap(mesh)->raycast_all(widen(*ray), [&](const Hit& hit) { hits.add(to_hit(hit)); });
        return listed(hits.finish(), capacity, out_total);
    });
}

gphys_status gphys_mesh_raycast_any(const gphys_mesh* mesh, const gphys_ray* ray, int32_t* out_hit) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh);
        GPHYS_REQUIRE_INPUT(ray);
        GPHYS_REQUIRE_POINTERS(out_hit);
        *out_hit = unwrap(mesh)->raycast_any(widen(*ray));
        return GPHYS_OK;
    });
}

gphys_status gphys_mesh_raycast_any_batch(const gphys_mesh* mesh, const gphys_ray* rays, uint32_t ray_stride,
                                          uint32_t count, int32_t* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh);
        GPHYS_TRY(check_rays(rays, ray_stride, count));
        GPHYS_TRY(check_outputs("out_hits", out_hits, out_stride, count));
        const StridedOut<int32_t> out(out_hits, out_stride);
        const Strided<gphys_ray> each(rays, ray_stride);
        cast_at_mesh(each, count, out, [&](const gphys_ray* const* tile, const uint32_t* items, uint32_t size) {
            const uint64_t found = unwrap(mesh)->raycast_any_many(tile, size);
            for (uint32_t k = 0; k < size; ++k) out[items[k]] = static_cast<int32_t>(found >> k & 1);
        });
        return GPHYS_OK;
    });
}

gphys_status gphys_mesh_raycast_distance_batch(const gphys_mesh* mesh, const gphys_ray* rays, uint32_t ray_stride,
                                               uint32_t count, gphys_distance* out_distances, uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh);
        GPHYS_TRY(check_rays(rays, ray_stride, count));
        GPHYS_TRY(check_outputs("out_distances", out_distances, out_stride, count));
        const StridedOut<gphys_distance> out(out_distances, out_stride);
        const Strided<gphys_ray> each(rays, ray_stride);
        cast_at_mesh(each, count, out, [&](const gphys_ray* const* tile, const uint32_t* items, uint32_t size) {
            gphys_distance found[ImageTiles::most];
            unwrap(mesh)->raycast_distance_many(tile, size, found);
            for (uint32_t k = 0; k < size; ++k) out[items[k]] = found[k];
        });
        return GPHYS_OK;
    });
}

gphys_status gphys_mesh_overlap(const gphys_mesh* mesh, gphys_shape_type type, const void* shape,
                                uint32_t* out_triangles, uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh);
        Shape query;
        GPHYS_TRY(read_shape(type, shape, query));
        return list_smallest("out_triangles", out_triangles, capacity, out_total,
                             [&](auto& triangles) { unwrap(mesh)->list_overlaps(query, triangles); });
    });
}

gphys_status gphys_mesh_get_octree_stats(const gphys_mesh* mesh, gphys_octree_stats* out_stats) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh, out_stats);
        *out_stats = unwrap(mesh)->bvh_stats();
        return GPHYS_OK;
    });
}

gphys_status gphys_mesh_get_octree_boxes(const gphys_mesh* mesh, gphys_octree_box* out_boxes, uint32_t capacity,
                                         uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(mesh);
        return copy_boxes(*unwrap(mesh), out_boxes, capacity, out_total);
    });
}
