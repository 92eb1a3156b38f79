// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
using System;
using System.Runtime.InteropServices;

namespace Gamephys {

// The C functions as they are.
internal static unsafe class Low {
    private const string Library = "gamephys";

    [DllImport(Library)] internal static extern uint gphys_version();
    [DllImport(Library)] internal static extern IntPtr gphys_status_name(Status status);
    [DllImport(Library)] internal static extern IntPtr gphys_last_error();
    [DllImport(Library)] internal static extern Status gphys_shape_validate(ShapeType type, void* shape);
    [DllImport(Library)] internal static extern Status gphys_shape_bounds(ShapeType type, void* shape, Aabb* out_bounds);
    [DllImport(Library)] internal static extern Status gphys_shape_transform(ShapeType type, void* shape, Transform* transform, void* out_shape);
    [DllImport(Library)] internal static extern Status gphys_shape_contains(ShapeType type, void* shape, Vec3* point, float tolerance, int* out_contains);
    [DllImport(Library)] internal static extern Status gphys_shape_contains_batch(ShapeType type, void* shape, Vec3* points, uint point_stride, uint count, float tolerance, int* out_contains, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_shape_closest_point(ShapeType type, void* shape, Vec3* point, Nearest* out_nearest);
    [DllImport(Library)] internal static extern Status gphys_shape_closest_point_batch(ShapeType type, void* shape, Vec3* points, uint point_stride, uint count, Nearest* out_nearest, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_segment_closest_points(Segment* a, Segment* b, Vec3* out_a, Vec3* out_b, float* out_distance);
    [DllImport(Library)] internal static extern Status gphys_shape_overlaps(ShapeType a_type, void* a, ShapeType b_type, void* b, int* out_overlaps);
    [DllImport(Library)] internal static extern Status gphys_shape_overlaps_batch(ShapeType a_type, void* a, uint a_stride, ShapeType b_type, void* b, uint b_stride, uint count, int* out_overlaps, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_shape_classify_plane(ShapeType type, void* shape, Plane* plane, Side* out_side, float* out_signed_distance);
    [DllImport(Library)] internal static extern Status gphys_shape_classify_frustum(ShapeType type, void* shape, Frustum* frustum, Side* out_side);
    [DllImport(Library)] internal static extern Status gphys_shape_raycast(ShapeType type, void* shape, Ray* ray, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_shape_raycast_batch(ShapeType type, void* shape, Ray* rays, uint ray_stride, uint count, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_shape_segment_test(ShapeType type, void* shape, Segment* segment, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_shape_sweep_sphere(ShapeType type, void* shape, Sphere* sphere, Vec3* displacement, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_shape_sweep(ShapeType type, void* shape, ShapeType moving_type, void* moving, Vec3* displacement, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_shape_sweep_batch(ShapeType type, void* shapes, uint shape_stride, ShapeType moving_type, void* moving, uint moving_stride, Vec3* displacements, uint displacement_stride, uint count, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_shape_penetration(ShapeType type, void* shape, ShapeType moving_type, void* moving, Penetration* out_penetration);
    [DllImport(Library)] internal static extern Status gphys_shape_penetration_batch(ShapeType type, void* shapes, uint shape_stride, ShapeType moving_type, void* moving, uint moving_stride, uint count, Penetration* out_penetrations, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_frustum_corners(Frustum* frustum, Vec3* out_corners);
    [DllImport(Library)] internal static extern Status gphys_planes_intersection(Plane* a, Plane* b, Plane* c, Vec3* out_point);
    [DllImport(Library)] internal static extern Status gphys_planes_intersection_batch(Plane* a, uint a_stride, Plane* b, uint b_stride, Plane* c, uint c_stride, uint count, Vec3* out_points, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_mat4_orthonormality(Mat4* matrix, float* out_deviation);
    [DllImport(Library)] internal static extern Status gphys_frustum_from_matrix(Mat4* view_projection, DepthRange depth_range, int reverse_z, Frustum* out_frustum);
    [DllImport(Library)] internal static extern Status gphys_mesh_check(float* vertices, uint vertex_stride, uint vertex_count, uint* indices, uint index_count, MeshReport* out_report);
    [DllImport(Library)] internal static extern Status gphys_mesh_desc_init(MeshDesc* desc, uint size);
    [DllImport(Library)] internal static extern Status gphys_mesh_create(MeshDesc* desc, float* vertices, uint vertex_stride, uint vertex_count, uint* indices, uint index_count, IntPtr* out_mesh);
    [DllImport(Library)] internal static extern Status gphys_mesh_create_hull(MeshDesc* desc, float* points, uint point_stride, uint point_count, IntPtr* out_mesh);
    [DllImport(Library)] internal static extern Status gphys_mesh_get_hull_planes(MeshHandle mesh, Plane* out_planes, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_mesh_get_hull_faces(MeshHandle mesh, uint* out_faces, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_mesh_set_vertices(MeshHandle mesh, float* vertices, uint vertex_stride, uint vertex_count);
    [DllImport(Library)] internal static extern void gphys_mesh_destroy(IntPtr mesh);
    [DllImport(Library)] internal static extern Status gphys_mesh_get_info(MeshHandle mesh, MeshInfo* out_info);
    [DllImport(Library)] internal static extern Status gphys_mesh_get_report(MeshHandle mesh, MeshReport* out_report);
    [DllImport(Library)] internal static extern Status gphys_mesh_get_vertices(MeshHandle mesh, Vec3* out_vertices, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_mesh_get_indices(MeshHandle mesh, uint* out_indices, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_mesh_get_snapshot(MeshHandle mesh, uint* out_words, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_mesh_create_from_snapshot(MeshDesc* desc, uint* words, uint word_count, IntPtr* out_mesh);
    [DllImport(Library)] internal static extern Status gphys_mesh_raycast_all(MeshHandle mesh, Ray* ray, Hit* out_hits, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_mesh_raycast_any(MeshHandle mesh, Ray* ray, int* out_hit);
    [DllImport(Library)] internal static extern Status gphys_mesh_raycast_any_batch(MeshHandle mesh, Ray* rays, uint ray_stride, uint count, int* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_mesh_raycast_distance_batch(MeshHandle mesh, Ray* rays, uint ray_stride, uint count, Distance* out_distances, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_mesh_overlap(MeshHandle mesh, ShapeType type, void* shape, uint* out_triangles, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_mesh_get_octree_stats(MeshHandle mesh, OctreeStats* out_stats);
    [DllImport(Library)] internal static extern Status gphys_mesh_get_octree_boxes(MeshHandle mesh, OctreeBox* out_boxes, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_desc_init(SceneDesc* desc, uint size);
    [DllImport(Library)] internal static extern Status gphys_scene_create(SceneDesc* desc, IntPtr* out_scene);
    [DllImport(Library)] internal static extern void gphys_scene_destroy(IntPtr scene);
    [DllImport(Library)] internal static extern Status gphys_scene_set_worker_count(SceneHandle scene, uint workers);
    [DllImport(Library)] internal static extern Status gphys_scene_get_worker_count(SceneHandle scene, uint* out_workers);
    [DllImport(Library)] internal static extern Status gphys_scene_set_origin(SceneHandle scene, double* origin);
    [DllImport(Library)] internal static extern Status gphys_scene_get_origin(SceneHandle scene, double* out_origin);
    [DllImport(Library)] internal static extern Status gphys_model_desc_init(ModelDesc* desc, uint size);
    [DllImport(Library)] internal static extern Status gphys_scene_add(SceneHandle scene, ShapeType type, void* shape, Transform* transform, ModelDesc* desc, uint* out_model);
    [DllImport(Library)] internal static extern Status gphys_scene_add_batch(SceneHandle scene, ShapeType type, void* shapes, uint shape_stride, Transform* transforms, uint transform_stride, uint count, ModelDesc* desc, uint* out_models);
    [DllImport(Library)] internal static extern Status gphys_scene_add_described_batch(SceneHandle scene, ShapeType type, void* shapes, uint shape_stride, Transform* transforms, uint transform_stride, ModelDesc* descs, uint desc_stride, uint count, uint* out_models);
    [DllImport(Library)] internal static extern Status gphys_scene_remove(SceneHandle scene, uint model);
    [DllImport(Library)] internal static extern Status gphys_scene_remove_batch(SceneHandle scene, uint* models, uint count);
    [DllImport(Library)] internal static extern Status gphys_scene_remove_subtree(SceneHandle scene, uint model);
    [DllImport(Library)] internal static extern Status gphys_scene_clear(SceneHandle scene);
    [DllImport(Library)] internal static extern Status gphys_scene_has(SceneHandle scene, uint model);
    [DllImport(Library)] internal static extern Status gphys_scene_get_models(SceneHandle scene, uint* out_models, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_get_roots(SceneHandle scene, uint* out_models, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_get_children(SceneHandle scene, uint model, uint* out_models, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_get_info(SceneHandle scene, uint model, ModelInfo* out_info);
    [DllImport(Library)] internal static extern Status gphys_scene_get_shape(SceneHandle scene, uint model, void* out_shape, uint out_size);
    [DllImport(Library)] internal static extern Status gphys_scene_get_mesh(SceneHandle scene, uint model, IntPtr* out_mesh);
    [DllImport(Library)] internal static extern Status gphys_scene_get_bounds(SceneHandle scene, uint model, Aabb* out_bounds);
    [DllImport(Library)] internal static extern Status gphys_scene_get_scene_bounds(SceneHandle scene, Aabb* out_bounds);
    [DllImport(Library)] internal static extern Status gphys_scene_set_shape(SceneHandle scene, uint model, ShapeType type, void* shape);
    [DllImport(Library)] internal static extern Status gphys_scene_set_scale(SceneHandle scene, uint model, Vec3* scale);
    [DllImport(Library)] internal static extern Status gphys_scene_get_scale(SceneHandle scene, uint model, Vec3* out_scale);
    [DllImport(Library)] internal static extern Status gphys_scene_set_layers(SceneHandle scene, uint model, uint layers);
    [DllImport(Library)] internal static extern Status gphys_scene_set_tag(SceneHandle scene, uint model, uint tag);
    [DllImport(Library)] internal static extern Status gphys_scene_set_parent(SceneHandle scene, uint model, uint parent, int keep_world);
    [DllImport(Library)] internal static extern Status gphys_scene_set_transform(SceneHandle scene, uint model, Transform* transform);
    [DllImport(Library)] internal static extern Status gphys_scene_set_transforms(SceneHandle scene, uint* models, Transform* transforms, uint transform_stride, uint count);
    [DllImport(Library)] internal static extern Status gphys_scene_get_transforms(SceneHandle scene, uint* models, uint count, Transform* out_transforms, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_get_world_transforms(SceneHandle scene, uint* models, uint count, Transform* out_transforms, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast(SceneHandle scene, Ray* ray, uint layers, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_batch(SceneHandle scene, Ray* rays, uint ray_stride, uint count, uint layers, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_distance_batch(SceneHandle scene, Ray* rays, uint ray_stride, uint count, uint layers, Distance* out_distances, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_any(SceneHandle scene, Ray* ray, uint layers, int* out_hit);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_any_batch(SceneHandle scene, Ray* rays, uint ray_stride, uint count, uint layers, int* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_all(SceneHandle scene, Ray* ray, uint layers, Hit* out_hits, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_all_batch(SceneHandle scene, Ray* rays, uint ray_stride, uint count, uint layers, Hit* out_hits, uint capacity, uint* out_offsets);
    [DllImport(Library)] internal static extern Status gphys_scene_segment_test(SceneHandle scene, Segment* segment, uint layers, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_scene_segment_test_batch(SceneHandle scene, Segment* segments, uint segment_stride, uint count, uint layers, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_overlap(SceneHandle scene, ShapeType type, void* shape, uint layers, uint* out_models, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_overlap_batch(SceneHandle scene, ShapeType type, void* shapes, uint shape_stride, uint count, uint layers, uint* out_models, uint capacity, uint* out_offsets);
    [DllImport(Library)] internal static extern Status gphys_scene_cull(SceneHandle scene, Frustum* frustum, uint layers, uint* out_models, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_cull_batch(SceneHandle scene, Frustum* frusta, uint frustum_stride, uint count, uint layers, uint* out_models, uint capacity, uint* out_offsets);
    [DllImport(Library)] internal static extern Status gphys_scene_nearest(SceneHandle scene, Vec3* point, float max_distance, uint layers, Nearest* out_nearest);
    [DllImport(Library)] internal static extern Status gphys_scene_nearest_batch(SceneHandle scene, Vec3* points, uint point_stride, uint count, float max_distance, uint layers, Nearest* out_nearest, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_sweep_sphere(SceneHandle scene, Sphere* sphere, Vec3* displacement, uint layers, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_scene_sweep_sphere_batch(SceneHandle scene, Sphere* spheres, uint sphere_stride, Vec3* displacements, uint displacement_stride, uint count, uint layers, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_sweep(SceneHandle scene, ShapeType type, void* shape, Vec3* displacement, uint layers, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_scene_sweep_batch(SceneHandle scene, ShapeType type, void* shapes, uint shape_stride, Vec3* displacements, uint displacement_stride, uint count, uint layers, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_penetration(SceneHandle scene, ShapeType type, void* shape, uint layers, Penetration* out_penetrations, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_penetration_batch(SceneHandle scene, ShapeType type, void* shapes, uint shape_stride, uint count, uint layers, Penetration* out_penetrations, uint capacity, uint* out_offsets);
    [DllImport(Library)] internal static extern Status gphys_query_filter_desc_init(QueryFilterDescData* desc, uint size);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_filtered(SceneHandle scene, Ray* ray, QueryFilterDescData* filter, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_filtered_batch(SceneHandle scene, Ray* rays, uint ray_stride, uint count, QueryFilterDescData* filters, uint filter_stride, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_distance_filtered_batch(SceneHandle scene, Ray* rays, uint ray_stride, uint count, QueryFilterDescData* filters, uint filter_stride, Distance* out_distances, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_any_filtered(SceneHandle scene, Ray* ray, QueryFilterDescData* filter, int* out_hit);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_any_filtered_batch(SceneHandle scene, Ray* rays, uint ray_stride, uint count, QueryFilterDescData* filters, uint filter_stride, int* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_all_filtered(SceneHandle scene, Ray* ray, QueryFilterDescData* filter, Hit* out_hits, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_raycast_all_filtered_batch(SceneHandle scene, Ray* rays, uint ray_stride, uint count, QueryFilterDescData* filters, uint filter_stride, Hit* out_hits, uint capacity, uint* out_offsets);
    [DllImport(Library)] internal static extern Status gphys_scene_segment_test_filtered(SceneHandle scene, Segment* segment, QueryFilterDescData* filter, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_scene_segment_test_filtered_batch(SceneHandle scene, Segment* segments, uint segment_stride, uint count, QueryFilterDescData* filters, uint filter_stride, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_overlap_filtered(SceneHandle scene, ShapeType type, void* shape, QueryFilterDescData* filter, uint* out_models, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_overlap_filtered_batch(SceneHandle scene, ShapeType type, void* shapes, uint shape_stride, uint count, QueryFilterDescData* filters, uint filter_stride, uint* out_models, uint capacity, uint* out_offsets);
    [DllImport(Library)] internal static extern Status gphys_scene_cull_filtered(SceneHandle scene, Frustum* frustum, QueryFilterDescData* filter, uint* out_models, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_cull_filtered_batch(SceneHandle scene, Frustum* frusta, uint frustum_stride, uint count, QueryFilterDescData* filters, uint filter_stride, uint* out_models, uint capacity, uint* out_offsets);
    [DllImport(Library)] internal static extern Status gphys_scene_nearest_filtered(SceneHandle scene, Vec3* point, float max_distance, QueryFilterDescData* filter, Nearest* out_nearest);
    [DllImport(Library)] internal static extern Status gphys_scene_nearest_filtered_batch(SceneHandle scene, Vec3* points, uint point_stride, uint count, float max_distance, QueryFilterDescData* filters, uint filter_stride, Nearest* out_nearest, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_sweep_sphere_filtered(SceneHandle scene, Sphere* sphere, Vec3* displacement, QueryFilterDescData* filter, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_scene_sweep_sphere_filtered_batch(SceneHandle scene, Sphere* spheres, uint sphere_stride, Vec3* displacements, uint displacement_stride, uint count, QueryFilterDescData* filters, uint filter_stride, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_sweep_filtered(SceneHandle scene, ShapeType type, void* shape, Vec3* displacement, QueryFilterDescData* filter, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_scene_sweep_filtered_batch(SceneHandle scene, ShapeType type, void* shapes, uint shape_stride, Vec3* displacements, uint displacement_stride, uint count, QueryFilterDescData* filters, uint filter_stride, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_scene_penetration_filtered(SceneHandle scene, ShapeType type, void* shape, QueryFilterDescData* filter, Penetration* out_penetrations, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_penetration_filtered_batch(SceneHandle scene, ShapeType type, void* shapes, uint shape_stride, uint count, QueryFilterDescData* filters, uint filter_stride, Penetration* out_penetrations, uint capacity, uint* out_offsets);
    [DllImport(Library)] internal static extern Status gphys_scene_rebuild_octree(SceneHandle scene);
    [DllImport(Library)] internal static extern Status gphys_scene_maintain_octree(SceneHandle scene, uint budget, int* out_done);
    [DllImport(Library)] internal static extern Status gphys_scene_get_octree_stats(SceneHandle scene, OctreeStats* out_stats);
    [DllImport(Library)] internal static extern Status gphys_scene_get_octree_boxes(SceneHandle scene, OctreeBox* out_boxes, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_validate(SceneHandle scene);
    [DllImport(Library)] internal static extern Status gphys_scene_get_snapshot(SceneHandle scene, int embed_meshes, uint* out_words, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_scene_restore(SceneHandle scene, SceneHandle library, uint* words, uint count);
    [DllImport(Library)] internal static extern Status gphys_scene_get_hash(SceneHandle scene, uint* out_hash);
    [DllImport(Library)] internal static extern Status gphys_camera_desc_init(CameraDesc* desc, uint size);
    [DllImport(Library)] internal static extern Status gphys_camera_create(CameraDesc* desc, IntPtr* out_camera);
    [DllImport(Library)] internal static extern void gphys_camera_destroy(IntPtr camera);
    [DllImport(Library)] internal static extern Status gphys_camera_set_origin(CameraHandle camera, double* origin);
    [DllImport(Library)] internal static extern Status gphys_camera_get_origin(CameraHandle camera, double* out_origin);
    [DllImport(Library)] internal static extern Status gphys_camera_set_perspective(CameraHandle camera, float fov_y, float near_distance, float far_distance);
    [DllImport(Library)] internal static extern Status gphys_camera_set_orthographic(CameraHandle camera, float height, float near_distance, float far_distance);
    [DllImport(Library)] internal static extern Status gphys_camera_set_projection(CameraHandle camera, Mat4* projection);
    [DllImport(Library)] internal static extern Status gphys_camera_set_perspective_aspect(CameraHandle camera, float fov_y, float aspect, float near_distance, float far_distance);
    [DllImport(Library)] internal static extern Status gphys_camera_set_orthographic_size(CameraHandle camera, float width, float height, float near_distance, float far_distance);
    [DllImport(Library)] internal static extern Status gphys_camera_set_viewport(CameraHandle camera, float width, float height);
    [DllImport(Library)] internal static extern Status gphys_camera_set_viewport_origin(CameraHandle camera, float x, float y);
    [DllImport(Library)] internal static extern Status gphys_camera_set_pick_start(CameraHandle camera, PickStart start);
    [DllImport(Library)] internal static extern Status gphys_camera_get_projection(CameraHandle camera, Projection* out_kind, float* out_size, float* out_near, float* out_far);
    [DllImport(Library)] internal static extern Status gphys_camera_get_viewport(CameraHandle camera, float* out_width, float* out_height);
    [DllImport(Library)] internal static extern Status gphys_camera_get_viewport_origin(CameraHandle camera, float* out_x, float* out_y);
    [DllImport(Library)] internal static extern Status gphys_camera_get_aspect(CameraHandle camera, float* out_aspect, int* out_is_fixed);
    [DllImport(Library)] internal static extern Status gphys_camera_get_image_size(CameraHandle camera, float* out_width, float* out_height);
    [DllImport(Library)] internal static extern Status gphys_camera_get_pick_start(CameraHandle camera, PickStart* out_start);
    [DllImport(Library)] internal static extern Status gphys_camera_get_conventions(CameraHandle camera, Handedness* out_handedness, DepthRange* out_depth_range, int* out_reverse_z);
    [DllImport(Library)] internal static extern Status gphys_camera_set_transform(CameraHandle camera, Vec3* position, Quat* rotation);
    [DllImport(Library)] internal static extern Status gphys_camera_set_world_matrix(CameraHandle camera, Mat4* world);
    [DllImport(Library)] internal static extern Status gphys_camera_set_view_matrix(CameraHandle camera, Mat4* view);
    [DllImport(Library)] internal static extern Status gphys_camera_look_at(CameraHandle camera, Vec3* eye, Vec3* target, Vec3* up);
    [DllImport(Library)] internal static extern Status gphys_camera_get_transform(CameraHandle camera, Vec3* out_position, Quat* out_rotation);
    [DllImport(Library)] internal static extern Status gphys_camera_get_world_matrix(CameraHandle camera, Mat4* out_world);
    [DllImport(Library)] internal static extern Status gphys_camera_get_view_matrix(CameraHandle camera, Mat4* out_view);
    [DllImport(Library)] internal static extern Status gphys_camera_get_projection_matrix(CameraHandle camera, Mat4* out_projection);
    [DllImport(Library)] internal static extern Status gphys_camera_get_view_projection_matrix(CameraHandle camera, Mat4* out_view_projection);
    [DllImport(Library)] internal static extern Status gphys_orbit_init(Orbit* orbit);
    [DllImport(Library)] internal static extern Status gphys_camera_set_orbit(CameraHandle camera, Orbit* orbit);
    [DllImport(Library)] internal static extern Status gphys_camera_get_orbit(CameraHandle camera, Orbit* out_orbit);
    [DllImport(Library)] internal static extern Status gphys_camera_set_orbit_speeds(CameraHandle camera, OrbitSpeeds* speeds);
    [DllImport(Library)] internal static extern Status gphys_camera_get_orbit_speeds(CameraHandle camera, OrbitSpeeds* out_speeds);
    [DllImport(Library)] internal static extern Status gphys_camera_orbit_rotate(CameraHandle camera, float units_x, float units_y);
    [DllImport(Library)] internal static extern Status gphys_camera_orbit_zoom(CameraHandle camera, float units);
    [DllImport(Library)] internal static extern Status gphys_camera_orbit_pan(CameraHandle camera, float units_right, float units_up);
    [DllImport(Library)] internal static extern Status gphys_camera_orbit_update(CameraHandle camera);
    [DllImport(Library)] internal static extern Status gphys_camera_get_frustum(CameraHandle camera, Frustum* out_frustum);
    [DllImport(Library)] internal static extern Status gphys_camera_get_corners(CameraHandle camera, Vec3* out_corners);
    [DllImport(Library)] internal static extern Status gphys_camera_get_rectangle_frustum(CameraHandle camera, float x0, float y0, float x1, float y1, Frustum* out_frustum);
    [DllImport(Library)] internal static extern Status gphys_camera_get_rectangle_corners(CameraHandle camera, float x0, float y0, float x1, float y1, Vec3* out_corners);
    [DllImport(Library)] internal static extern Status gphys_camera_project(CameraHandle camera, Vec3* point, Vec3* out_pixel);
    [DllImport(Library)] internal static extern Status gphys_camera_project_batch(CameraHandle camera, Vec3* points, uint point_stride, uint count, Vec3* out_pixels, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_camera_unproject(CameraHandle camera, Vec3* pixel, Vec3* out_point);
    [DllImport(Library)] internal static extern Status gphys_camera_unproject_batch(CameraHandle camera, Vec3* pixels, uint pixel_stride, uint count, Vec3* out_points, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_camera_pick_ray(CameraHandle camera, float pixel_x, float pixel_y, Ray* out_ray);
    [DllImport(Library)] internal static extern Status gphys_camera_pick_rays(CameraHandle camera, uint x, uint y, uint width, uint height, Ray* out_rays, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_camera_pick(CameraHandle camera, SceneHandle scene, float pixel_x, float pixel_y, uint layers, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_camera_pick_batch(CameraHandle camera, SceneHandle scene, float* pixels, uint pixel_stride, uint count, uint layers, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_camera_pick_rectangle(CameraHandle camera, SceneHandle scene, float x0, float y0, float x1, float y1, uint layers, uint* out_models, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_camera_cull(CameraHandle camera, SceneHandle scene, uint layers, uint* out_models, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_camera_pick_filtered(CameraHandle camera, SceneHandle scene, float pixel_x, float pixel_y, QueryFilterDescData* filter, Hit* out_hit);
    [DllImport(Library)] internal static extern Status gphys_camera_pick_filtered_batch(CameraHandle camera, SceneHandle scene, float* pixels, uint pixel_stride, uint count, QueryFilterDescData* filters, uint filter_stride, Hit* out_hits, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_camera_pick_rectangle_filtered(CameraHandle camera, SceneHandle scene, float x0, float y0, float x1, float y1, QueryFilterDescData* filter, uint* out_models, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_camera_cull_filtered(CameraHandle camera, SceneHandle scene, QueryFilterDescData* filter, uint* out_models, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_desc_init(SolverDesc* desc, uint size);
    [DllImport(Library)] internal static extern Status gphys_solver_create(SolverDesc* desc, IntPtr* out_solver);
    [DllImport(Library)] internal static extern void gphys_solver_destroy(IntPtr solver);
    [DllImport(Library)] internal static extern Status gphys_solver_set_worker_count(SolverHandle solver, uint workers);
    [DllImport(Library)] internal static extern Status gphys_solver_get_worker_count(SolverHandle solver, uint* out_workers);
    [DllImport(Library)] internal static extern Status gphys_solver_set_origin(SolverHandle solver, double* origin);
    [DllImport(Library)] internal static extern Status gphys_solver_get_origin(SolverHandle solver, double* out_origin);
    [DllImport(Library)] internal static extern Status gphys_solver_set_gravity(SolverHandle solver, Vec3* gravity);
    [DllImport(Library)] internal static extern Status gphys_solver_set_substeps(SolverHandle solver, uint substeps);
    [DllImport(Library)] internal static extern Status gphys_solver_get_settings(SolverHandle solver, SolverSettings* out_settings);
    [DllImport(Library)] internal static extern Status gphys_solver_set_settings(SolverHandle solver, SolverSettings* settings);
    [DllImport(Library)] internal static extern Status gphys_body_desc_init(BodyDesc* desc, uint size);
    [DllImport(Library)] internal static extern Status gphys_solver_add_particles(SolverHandle solver, BodyDesc* desc, Vec3* positions, uint position_stride, uint count, uint* out_body);
    [DllImport(Library)] internal static extern Status gphys_solver_add_rope(SolverHandle solver, BodyDesc* desc, Vec3* positions, uint position_stride, uint count, float link_length, uint* out_body);
    [DllImport(Library)] internal static extern Status gphys_solver_add_cloth(SolverHandle solver, BodyDesc* desc, Vec3* corner, Vec3* edge_u, Vec3* edge_v, uint columns, uint rows, uint* out_body);
    [DllImport(Library)] internal static extern Status gphys_solver_add_cloth_mesh(SolverHandle solver, BodyDesc* desc, MeshHandle mesh, Transform* transform, uint* out_body);
    [DllImport(Library)] internal static extern Status gphys_solver_remove_body(SolverHandle solver, uint body);
    [DllImport(Library)] internal static extern Status gphys_solver_get_bodies(SolverHandle solver, uint* out_bodies, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_get_sleeping(SolverHandle solver, uint* out_bodies, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_wake(SolverHandle solver, uint body);
    [DllImport(Library)] internal static extern Status gphys_solver_get_body_settings(SolverHandle solver, uint body, BodySettings* out_settings);
    [DllImport(Library)] internal static extern Status gphys_solver_set_body_settings(SolverHandle solver, uint body, BodySettings* settings);
    [DllImport(Library)] internal static extern Status gphys_solver_get_body_info(SolverHandle solver, uint body, BodyInfo* out_info);
    [DllImport(Library)] internal static extern Status gphys_solver_get_triangles(SolverHandle solver, uint body, uint* out_indices, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_mesh_create_from_body(MeshDesc* desc, SolverHandle solver, uint body, IntPtr* out_mesh);
    [DllImport(Library)] internal static extern Status gphys_solver_get_nearest_particle(SolverHandle solver, uint body, uint triangle, Vec3* point, uint* out_particle);
    [DllImport(Library)] internal static extern Status gphys_solver_get_positions(SolverHandle solver, uint body, uint first, uint count, Vec3* out_positions, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_set_positions(SolverHandle solver, uint body, uint first, uint count, Vec3* positions, uint stride);
    [DllImport(Library)] internal static extern Status gphys_solver_get_velocities(SolverHandle solver, uint body, uint first, uint count, Vec3* out_velocities, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_set_velocities(SolverHandle solver, uint body, uint first, uint count, Vec3* velocities, uint stride);
    [DllImport(Library)] internal static extern Status gphys_solver_get_masses(SolverHandle solver, uint body, uint first, uint count, float* out_masses, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_set_masses(SolverHandle solver, uint body, uint first, uint count, float* masses, uint stride);
    [DllImport(Library)] internal static extern Status gphys_solver_get_radii(SolverHandle solver, uint body, uint first, uint count, float* out_radii, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_set_radii(SolverHandle solver, uint body, uint first, uint count, float* radii, uint stride);
    [DllImport(Library)] internal static extern Status gphys_solver_get_friction_factors(SolverHandle solver, uint body, uint first, uint count, float* out_factors, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_set_friction_factors(SolverHandle solver, uint body, uint first, uint count, float* factors, uint stride);
    [DllImport(Library)] internal static extern Status gphys_solver_get_forces(SolverHandle solver, uint body, uint first, uint count, Vec3* out_forces, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_set_forces(SolverHandle solver, uint body, uint first, uint count, Vec3* forces, uint stride);
    [DllImport(Library)] internal static extern Status gphys_solver_get_pinned(SolverHandle solver, uint body, uint first, uint count, int* out_pinned, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_set_pinned(SolverHandle solver, uint body, uint first, uint count, int pinned);
    [DllImport(Library)] internal static extern Status gphys_solver_set_wind(SolverHandle solver, uint body, Wind* wind);
    [DllImport(Library)] internal static extern Status gphys_solver_get_wind(SolverHandle solver, uint body, Wind* out_wind);
    [DllImport(Library)] internal static extern Status gphys_solver_set_air_velocities(SolverHandle solver, uint body, uint first, uint count, Vec3* velocities, uint stride);
    [DllImport(Library)] internal static extern Status gphys_solver_get_air_velocities(SolverHandle solver, uint body, uint first, uint count, Vec3* out_velocities, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_set_animation_targets(SolverHandle solver, uint body, uint first, uint count, AnimationTarget* targets, uint stride);
    [DllImport(Library)] internal static extern Status gphys_solver_get_animation_targets(SolverHandle solver, uint body, uint first, uint count, AnimationTarget* out_targets, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_attach(SolverHandle solver, SceneHandle scene, uint body, uint particle, uint model, Vec3* local_point);
    [DllImport(Library)] internal static extern Status gphys_solver_detach(SolverHandle solver, uint body, uint particle);
    [DllImport(Library)] internal static extern Status gphys_solver_get_attachments(SolverHandle solver, uint body, Attachment* out_attachments, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_add_distance(SolverHandle solver, uint body, uint particle_a, uint particle_b, float rest_length, float compliance, uint* out_constraint);
    [DllImport(Library)] internal static extern Status gphys_solver_add_max_distance(SolverHandle solver, uint body, uint particle_a, uint particle_b, float max_length, float compliance, uint* out_constraint);
    [DllImport(Library)] internal static extern Status gphys_solver_set_constraint_damping(SolverHandle solver, uint body, uint constraint, float damping);
    [DllImport(Library)] internal static extern Status gphys_solver_set_volume(SolverHandle solver, uint body, float rest_volume, float compliance);
    [DllImport(Library)] internal static extern Status gphys_solver_get_volume(SolverHandle solver, uint body, float* out_volume, float* out_pressure);
    [DllImport(Library)] internal static extern Status gphys_solver_get_volume_settings(SolverHandle solver, uint body, float* out_rest_volume, float* out_compliance);
    [DllImport(Library)] internal static extern Status gphys_solver_remove_constraint(SolverHandle solver, uint body, uint constraint);
    [DllImport(Library)] internal static extern Status gphys_solver_get_constraints(SolverHandle solver, uint body, ConstraintInfo* out_constraints, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_get_constraint_kinds(SolverHandle solver, uint body, uint* constraints, uint count, ConstraintKind* out_kinds, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_get_constraint_settings(SolverHandle solver, uint body, uint* constraints, uint count, ConstraintSettings* out_settings, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_set_constraint_settings(SolverHandle solver, uint body, uint* constraints, ConstraintSettings* settings, uint setting_stride, uint count);
    [DllImport(Library)] internal static extern Status gphys_solver_add_cluster(SolverHandle solver, uint body, uint* particles, uint count, uint* out_cluster);
    [DllImport(Library)] internal static extern Status gphys_solver_remove_cluster(SolverHandle solver, uint body, uint cluster);
    [DllImport(Library)] internal static extern Status gphys_solver_get_clusters(SolverHandle solver, uint body, uint* out_clusters, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_get_cluster_particles(SolverHandle solver, uint body, uint cluster, uint* out_particles, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_join(SolverHandle solver, uint body_a, uint particle_a, uint body_b, uint particle_b, float rest_length, float compliance, uint* out_joint);
    [DllImport(Library)] internal static extern Status gphys_solver_unjoin(SolverHandle solver, uint joint);
    [DllImport(Library)] internal static extern Status gphys_solver_get_joints(SolverHandle solver, uint body, JointInfo* out_joints, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_set_breaking_forces(SolverHandle solver, uint body, uint* constraints, float* forces, uint force_stride, uint count);
    [DllImport(Library)] internal static extern Status gphys_solver_get_breaking_forces(SolverHandle solver, uint body, uint* constraints, uint count, float* out_forces, uint out_stride);
    [DllImport(Library)] internal static extern Status gphys_solver_break_constraint(SolverHandle solver, uint body, uint constraint, Break* out_result);
    [DllImport(Library)] internal static extern Status gphys_solver_get_breaks(SolverHandle solver, Break* out_breaks, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_step(SolverHandle solver, SceneHandle scene, float dt);
    [DllImport(Library)] internal static extern Status gphys_solver_advance(SolverHandle solver, SceneHandle scene, float frame_time, uint* out_steps, float* out_leftover);
    [DllImport(Library)] internal static extern Status gphys_solver_get_leftover(SolverHandle solver, float* out_leftover);
    [DllImport(Library)] internal static extern Status gphys_solver_get_substeps(SolverHandle solver, uint body, uint* out_substeps);
    [DllImport(Library)] internal static extern Status gphys_solver_get_stats(SolverHandle solver, uint body, SolverStats* out_stats);
    [DllImport(Library)] internal static extern Status gphys_solver_get_contacts(SolverHandle solver, Contact* out_contacts, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_get_body_contacts(SolverHandle solver, BodyContact* out_contacts, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_get_impulses(SolverHandle solver, Impulse* out_impulses, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_get_snapshot(SolverHandle solver, uint* out_words, uint capacity, uint* out_total);
    [DllImport(Library)] internal static extern Status gphys_solver_restore(SolverHandle solver, uint* words, uint count);
    [DllImport(Library)] internal static extern Status gphys_solver_get_hash(SolverHandle solver, uint* out_hash);
}

internal sealed class MeshHandle : ObjectHandle {
    internal static readonly MeshHandle None = new MeshHandle(IntPtr.Zero);
    internal MeshHandle(IntPtr made) : base(made) { }
    protected override bool ReleaseHandle() {
        Low.gphys_mesh_destroy(handle);
        return true;
    }
}

internal sealed class SceneHandle : ObjectHandle {
    internal static readonly SceneHandle None = new SceneHandle(IntPtr.Zero);
    internal SceneHandle(IntPtr made) : base(made) { }
    protected override bool ReleaseHandle() {
        Low.gphys_scene_destroy(handle);
        return true;
    }
}

internal sealed class CameraHandle : ObjectHandle {
    internal static readonly CameraHandle None = new CameraHandle(IntPtr.Zero);
    internal CameraHandle(IntPtr made) : base(made) { }
    protected override bool ReleaseHandle() {
        Low.gphys_camera_destroy(handle);
        return true;
    }
}

internal sealed class SolverHandle : ObjectHandle {
    internal static readonly SolverHandle None = new SolverHandle(IntPtr.Zero);
    internal SolverHandle(IntPtr made) : base(made) { }
    protected override bool ReleaseHandle() {
        Low.gphys_solver_destroy(handle);
        return true;
    }
}

}
