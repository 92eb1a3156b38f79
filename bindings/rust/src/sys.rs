// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
//! The C functions as they are.

use crate::types::*;
use std::ffi::c_void;
use std::os::raw::c_char;

#[repr(C)]
pub struct gphys_mesh {
    _opaque: [u8; 0],
}
#[repr(C)]
pub struct gphys_scene {
    _opaque: [u8; 0],
}
#[repr(C)]
pub struct gphys_camera {
    _opaque: [u8; 0],
}
#[repr(C)]
pub struct gphys_solver {
    _opaque: [u8; 0],
}

#[link(name = "gamephys")]
extern "C" {
    pub fn gphys_version() -> u32;
    pub fn gphys_status_name(status: Status) -> *const c_char;
    pub fn gphys_last_error() -> *const c_char;
    pub fn gphys_shape_validate(type_: ShapeType, shape: *const c_void) -> Status;
    pub fn gphys_shape_bounds(type_: ShapeType, shape: *const c_void, out_bounds: *mut Aabb) -> Status;
    pub fn gphys_shape_transform(type_: ShapeType, shape: *const c_void, transform: *const Transform, out_shape: *mut c_void) -> Status;
    pub fn gphys_shape_contains(type_: ShapeType, shape: *const c_void, point: *const Vec3, tolerance: f32, out_contains: *mut i32) -> Status;
    pub fn gphys_shape_contains_batch(type_: ShapeType, shape: *const c_void, points: *const Vec3, point_stride: u32, count: u32, tolerance: f32, out_contains: *mut i32, out_stride: u32) -> Status;
    pub fn gphys_shape_closest_point(type_: ShapeType, shape: *const c_void, point: *const Vec3, out_nearest: *mut Nearest) -> Status;
    pub fn gphys_shape_closest_point_batch(type_: ShapeType, shape: *const c_void, points: *const Vec3, point_stride: u32, count: u32, out_nearest: *mut Nearest, out_stride: u32) -> Status;
    pub fn gphys_segment_closest_points(a: *const Segment, b: *const Segment, out_a: *mut Vec3, out_b: *mut Vec3, out_distance: *mut f32) -> Status;
    pub fn gphys_shape_overlaps(a_type: ShapeType, a: *const c_void, b_type: ShapeType, b: *const c_void, out_overlaps: *mut i32) -> Status;
    pub fn gphys_shape_overlaps_batch(a_type: ShapeType, a: *const c_void, a_stride: u32, b_type: ShapeType, b: *const c_void, b_stride: u32, count: u32, out_overlaps: *mut i32, out_stride: u32) -> Status;
    pub fn gphys_shape_classify_plane(type_: ShapeType, shape: *const c_void, plane: *const Plane, out_side: *mut Side, out_signed_distance: *mut f32) -> Status;
    pub fn gphys_shape_classify_frustum(type_: ShapeType, shape: *const c_void, frustum: *const Frustum, out_side: *mut Side) -> Status;
    pub fn gphys_shape_raycast(type_: ShapeType, shape: *const c_void, ray: *const Ray, out_hit: *mut Hit) -> Status;
    pub fn gphys_shape_raycast_batch(type_: ShapeType, shape: *const c_void, rays: *const Ray, ray_stride: u32, count: u32, out_hits: *mut Hit, out_stride: u32) -> Status;
    pub fn gphys_shape_segment_test(type_: ShapeType, shape: *const c_void, segment: *const Segment, out_hit: *mut Hit) -> Status;
    pub fn gphys_shape_sweep_sphere(type_: ShapeType, shape: *const c_void, sphere: *const Sphere, displacement: *const Vec3, out_hit: *mut Hit) -> Status;
    pub fn gphys_shape_sweep(type_: ShapeType, shape: *const c_void, moving_type: ShapeType, moving: *const c_void, displacement: *const Vec3, out_hit: *mut Hit) -> Status;
    pub fn gphys_shape_penetration(type_: ShapeType, shape: *const c_void, moving_type: ShapeType, moving: *const c_void, out_penetration: *mut Penetration) -> Status;
    pub fn gphys_frustum_corners(frustum: *const Frustum, out_corners: *mut Vec3) -> Status;
    pub fn gphys_planes_intersection(a: *const Plane, b: *const Plane, c: *const Plane, out_point: *mut Vec3) -> Status;
    pub fn gphys_planes_intersection_batch(a: *const Plane, a_stride: u32, b: *const Plane, b_stride: u32, c: *const Plane, c_stride: u32, count: u32, out_points: *mut Vec3, out_stride: u32) -> Status;
    pub fn gphys_mat4_orthonormality(matrix: *const Mat4, out_deviation: *mut f32) -> Status;
    pub fn gphys_frustum_from_matrix(view_projection: *const Mat4, depth_range: DepthRange, reverse_z: i32, out_frustum: *mut Frustum) -> Status;
    pub fn gphys_mesh_check(vertices: *const Vec3, vertex_stride: u32, vertex_count: u32, indices: *const u32, index_count: u32, out_report: *mut MeshReport) -> Status;
    pub fn gphys_mesh_desc_init(desc: *mut MeshDesc, size: u32) -> Status;
    pub fn gphys_mesh_create(desc: *const MeshDesc, vertices: *const Vec3, vertex_stride: u32, vertex_count: u32, indices: *const u32, index_count: u32, out_mesh: *mut *mut gphys_mesh) -> Status;
    pub fn gphys_mesh_set_vertices(mesh: *mut gphys_mesh, vertices: *const Vec3, vertex_stride: u32, vertex_count: u32) -> Status;
    pub fn gphys_mesh_destroy(mesh: *mut gphys_mesh);
    pub fn gphys_mesh_get_report(mesh: *mut gphys_mesh, out_report: *mut MeshReport) -> Status;
    pub fn gphys_mesh_get_vertices(mesh: *mut gphys_mesh, out_vertices: *mut Vec3, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_mesh_get_indices(mesh: *mut gphys_mesh, out_indices: *mut u32, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_mesh_raycast_all(mesh: *mut gphys_mesh, ray: *const Ray, out_hits: *mut Hit, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_mesh_raycast_any(mesh: *mut gphys_mesh, ray: *const Ray, out_hit: *mut i32) -> Status;
    pub fn gphys_mesh_overlap(mesh: *mut gphys_mesh, type_: ShapeType, shape: *const c_void, out_triangles: *mut u32, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_mesh_get_octree_stats(mesh: *mut gphys_mesh, out_stats: *mut OctreeStats) -> Status;
    pub fn gphys_mesh_get_octree_boxes(mesh: *mut gphys_mesh, out_boxes: *mut OctreeBox, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_desc_init(desc: *mut SceneDesc, size: u32) -> Status;
    pub fn gphys_scene_create(desc: *const SceneDesc, out_scene: *mut *mut gphys_scene) -> Status;
    pub fn gphys_scene_destroy(scene: *mut gphys_scene);
    pub fn gphys_scene_set_origin(scene: *mut gphys_scene, origin: *const f64) -> Status;
    pub fn gphys_scene_get_origin(scene: *mut gphys_scene, out_origin: *mut f64) -> Status;
    pub fn gphys_model_desc_init(desc: *mut ModelDesc, size: u32) -> Status;
    pub fn gphys_scene_add(scene: *mut gphys_scene, type_: ShapeType, shape: *const c_void, transform: *const Transform, desc: *const ModelDesc, out_model: *mut ModelId) -> Status;
    pub fn gphys_scene_add_batch(scene: *mut gphys_scene, type_: ShapeType, shapes: *const c_void, shape_stride: u32, transforms: *const Transform, transform_stride: u32, count: u32, desc: *const ModelDesc, out_models: *mut ModelId) -> Status;
    pub fn gphys_scene_remove(scene: *mut gphys_scene, model: ModelId) -> Status;
    pub fn gphys_scene_remove_batch(scene: *mut gphys_scene, models: *const ModelId, count: u32) -> Status;
    pub fn gphys_scene_remove_subtree(scene: *mut gphys_scene, model: ModelId) -> Status;
    pub fn gphys_scene_clear(scene: *mut gphys_scene) -> Status;
    pub fn gphys_scene_has(scene: *mut gphys_scene, model: ModelId) -> Status;
    pub fn gphys_scene_get_models(scene: *mut gphys_scene, out_models: *mut ModelId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_get_roots(scene: *mut gphys_scene, out_models: *mut ModelId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_get_children(scene: *mut gphys_scene, model: ModelId, out_models: *mut ModelId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_get_info(scene: *mut gphys_scene, model: ModelId, out_info: *mut ModelInfo) -> Status;
    pub fn gphys_scene_get_shape(scene: *mut gphys_scene, model: ModelId, out_shape: *mut c_void, out_size: u32) -> Status;
    pub fn gphys_scene_get_bounds(scene: *mut gphys_scene, model: ModelId, out_bounds: *mut Aabb) -> Status;
    pub fn gphys_scene_get_scene_bounds(scene: *mut gphys_scene, out_bounds: *mut Aabb) -> Status;
    pub fn gphys_scene_set_shape(scene: *mut gphys_scene, model: ModelId, type_: ShapeType, shape: *const c_void) -> Status;
    pub fn gphys_scene_set_layers(scene: *mut gphys_scene, model: ModelId, layers: u32) -> Status;
    pub fn gphys_scene_set_tag(scene: *mut gphys_scene, model: ModelId, tag: u32) -> Status;
    pub fn gphys_scene_set_parent(scene: *mut gphys_scene, model: ModelId, parent: ModelId, keep_world: i32) -> Status;
    pub fn gphys_scene_set_transform(scene: *mut gphys_scene, model: ModelId, transform: *const Transform) -> Status;
    pub fn gphys_scene_set_transforms(scene: *mut gphys_scene, models: *const ModelId, transforms: *const Transform, transform_stride: u32, count: u32) -> Status;
    pub fn gphys_scene_get_transforms(scene: *mut gphys_scene, models: *const ModelId, count: u32, out_transforms: *mut Transform, out_stride: u32) -> Status;
    pub fn gphys_scene_get_world_transforms(scene: *mut gphys_scene, models: *const ModelId, count: u32, out_transforms: *mut Transform, out_stride: u32) -> Status;
    pub fn gphys_scene_raycast(scene: *mut gphys_scene, ray: *const Ray, layers: u32, out_hit: *mut Hit) -> Status;
    pub fn gphys_scene_raycast_batch(scene: *mut gphys_scene, rays: *const Ray, ray_stride: u32, count: u32, layers: u32, out_hits: *mut Hit, out_stride: u32) -> Status;
    pub fn gphys_scene_raycast_any(scene: *mut gphys_scene, ray: *const Ray, layers: u32, out_hit: *mut i32) -> Status;
    pub fn gphys_scene_raycast_any_batch(scene: *mut gphys_scene, rays: *const Ray, ray_stride: u32, count: u32, layers: u32, out_hits: *mut i32, out_stride: u32) -> Status;
    pub fn gphys_scene_raycast_all(scene: *mut gphys_scene, ray: *const Ray, layers: u32, out_hits: *mut Hit, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_raycast_all_batch(scene: *mut gphys_scene, rays: *const Ray, ray_stride: u32, count: u32, layers: u32, out_hits: *mut Hit, capacity: u32, out_offsets: *mut u32) -> Status;
    pub fn gphys_scene_segment_test(scene: *mut gphys_scene, segment: *const Segment, layers: u32, out_hit: *mut Hit) -> Status;
    pub fn gphys_scene_segment_test_batch(scene: *mut gphys_scene, segments: *const Segment, segment_stride: u32, count: u32, layers: u32, out_hits: *mut Hit, out_stride: u32) -> Status;
    pub fn gphys_scene_overlap(scene: *mut gphys_scene, type_: ShapeType, shape: *const c_void, layers: u32, out_models: *mut ModelId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_overlap_batch(scene: *mut gphys_scene, type_: ShapeType, shapes: *const c_void, shape_stride: u32, count: u32, layers: u32, out_models: *mut ModelId, capacity: u32, out_offsets: *mut u32) -> Status;
    pub fn gphys_scene_cull(scene: *mut gphys_scene, frustum: *const Frustum, layers: u32, out_models: *mut ModelId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_nearest(scene: *mut gphys_scene, point: *const Vec3, max_distance: f32, layers: u32, out_nearest: *mut Nearest) -> Status;
    pub fn gphys_scene_nearest_batch(scene: *mut gphys_scene, points: *const Vec3, point_stride: u32, count: u32, max_distance: f32, layers: u32, out_nearest: *mut Nearest, out_stride: u32) -> Status;
    pub fn gphys_scene_sweep_sphere(scene: *mut gphys_scene, sphere: *const Sphere, displacement: *const Vec3, layers: u32, out_hit: *mut Hit) -> Status;
    pub fn gphys_scene_sweep_sphere_batch(scene: *mut gphys_scene, spheres: *const Sphere, sphere_stride: u32, displacements: *const Vec3, displacement_stride: u32, count: u32, layers: u32, out_hits: *mut Hit, out_stride: u32) -> Status;
    pub fn gphys_scene_sweep(scene: *mut gphys_scene, type_: ShapeType, shape: *const c_void, displacement: *const Vec3, layers: u32, out_hit: *mut Hit) -> Status;
    pub fn gphys_scene_sweep_batch(scene: *mut gphys_scene, type_: ShapeType, shapes: *const c_void, shape_stride: u32, displacements: *const Vec3, displacement_stride: u32, count: u32, layers: u32, out_hits: *mut Hit, out_stride: u32) -> Status;
    pub fn gphys_scene_penetration(scene: *mut gphys_scene, type_: ShapeType, shape: *const c_void, layers: u32, out_penetrations: *mut Penetration, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_query_filter_desc_init(desc: *mut QueryFilterDesc, size: u32) -> Status;
    pub fn gphys_scene_raycast_filtered(scene: *mut gphys_scene, ray: *const Ray, filter: *const QueryFilterDesc, out_hit: *mut Hit) -> Status;
    pub fn gphys_scene_raycast_filtered_batch(scene: *mut gphys_scene, rays: *const Ray, ray_stride: u32, count: u32, filters: *const QueryFilterDesc, filter_stride: u32, out_hits: *mut Hit, out_stride: u32) -> Status;
    pub fn gphys_scene_raycast_any_filtered(scene: *mut gphys_scene, ray: *const Ray, filter: *const QueryFilterDesc, out_hit: *mut i32) -> Status;
    pub fn gphys_scene_raycast_any_filtered_batch(scene: *mut gphys_scene, rays: *const Ray, ray_stride: u32, count: u32, filters: *const QueryFilterDesc, filter_stride: u32, out_hits: *mut i32, out_stride: u32) -> Status;
    pub fn gphys_scene_raycast_all_filtered(scene: *mut gphys_scene, ray: *const Ray, filter: *const QueryFilterDesc, out_hits: *mut Hit, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_raycast_all_filtered_batch(scene: *mut gphys_scene, rays: *const Ray, ray_stride: u32, count: u32, filters: *const QueryFilterDesc, filter_stride: u32, out_hits: *mut Hit, capacity: u32, out_offsets: *mut u32) -> Status;
    pub fn gphys_scene_segment_test_filtered(scene: *mut gphys_scene, segment: *const Segment, filter: *const QueryFilterDesc, out_hit: *mut Hit) -> Status;
    pub fn gphys_scene_segment_test_filtered_batch(scene: *mut gphys_scene, segments: *const Segment, segment_stride: u32, count: u32, filters: *const QueryFilterDesc, filter_stride: u32, out_hits: *mut Hit, out_stride: u32) -> Status;
    pub fn gphys_scene_overlap_filtered(scene: *mut gphys_scene, type_: ShapeType, shape: *const c_void, filter: *const QueryFilterDesc, out_models: *mut ModelId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_overlap_filtered_batch(scene: *mut gphys_scene, type_: ShapeType, shapes: *const c_void, shape_stride: u32, count: u32, filters: *const QueryFilterDesc, filter_stride: u32, out_models: *mut ModelId, capacity: u32, out_offsets: *mut u32) -> Status;
    pub fn gphys_scene_cull_filtered(scene: *mut gphys_scene, frustum: *const Frustum, filter: *const QueryFilterDesc, out_models: *mut ModelId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_nearest_filtered(scene: *mut gphys_scene, point: *const Vec3, max_distance: f32, filter: *const QueryFilterDesc, out_nearest: *mut Nearest) -> Status;
    pub fn gphys_scene_nearest_filtered_batch(scene: *mut gphys_scene, points: *const Vec3, point_stride: u32, count: u32, max_distance: f32, filters: *const QueryFilterDesc, filter_stride: u32, out_nearest: *mut Nearest, out_stride: u32) -> Status;
    pub fn gphys_scene_sweep_sphere_filtered(scene: *mut gphys_scene, sphere: *const Sphere, displacement: *const Vec3, filter: *const QueryFilterDesc, out_hit: *mut Hit) -> Status;
    pub fn gphys_scene_sweep_sphere_filtered_batch(scene: *mut gphys_scene, spheres: *const Sphere, sphere_stride: u32, displacements: *const Vec3, displacement_stride: u32, count: u32, filters: *const QueryFilterDesc, filter_stride: u32, out_hits: *mut Hit, out_stride: u32) -> Status;
    pub fn gphys_scene_sweep_filtered(scene: *mut gphys_scene, type_: ShapeType, shape: *const c_void, displacement: *const Vec3, filter: *const QueryFilterDesc, out_hit: *mut Hit) -> Status;
    pub fn gphys_scene_sweep_filtered_batch(scene: *mut gphys_scene, type_: ShapeType, shapes: *const c_void, shape_stride: u32, displacements: *const Vec3, displacement_stride: u32, count: u32, filters: *const QueryFilterDesc, filter_stride: u32, out_hits: *mut Hit, out_stride: u32) -> Status;
    pub fn gphys_scene_penetration_filtered(scene: *mut gphys_scene, type_: ShapeType, shape: *const c_void, filter: *const QueryFilterDesc, out_penetrations: *mut Penetration, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_get_octree_stats(scene: *mut gphys_scene, out_stats: *mut OctreeStats) -> Status;
    pub fn gphys_scene_get_octree_boxes(scene: *mut gphys_scene, out_boxes: *mut OctreeBox, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_scene_validate(scene: *mut gphys_scene) -> Status;
    pub fn gphys_camera_desc_init(desc: *mut CameraDesc, size: u32) -> Status;
    pub fn gphys_camera_create(desc: *const CameraDesc, out_camera: *mut *mut gphys_camera) -> Status;
    pub fn gphys_camera_destroy(camera: *mut gphys_camera);
    pub fn gphys_camera_set_origin(camera: *mut gphys_camera, origin: *const f64) -> Status;
    pub fn gphys_camera_get_origin(camera: *mut gphys_camera, out_origin: *mut f64) -> Status;
    pub fn gphys_camera_set_perspective(camera: *mut gphys_camera, fov_y: f32, near_distance: f32, far_distance: f32) -> Status;
    pub fn gphys_camera_set_orthographic(camera: *mut gphys_camera, height: f32, near_distance: f32, far_distance: f32) -> Status;
    pub fn gphys_camera_set_projection(camera: *mut gphys_camera, projection: *const Mat4) -> Status;
    pub fn gphys_camera_set_perspective_aspect(camera: *mut gphys_camera, fov_y: f32, aspect: f32, near_distance: f32, far_distance: f32) -> Status;
    pub fn gphys_camera_set_orthographic_size(camera: *mut gphys_camera, width: f32, height: f32, near_distance: f32, far_distance: f32) -> Status;
    pub fn gphys_camera_set_viewport(camera: *mut gphys_camera, width: f32, height: f32) -> Status;
    pub fn gphys_camera_set_viewport_origin(camera: *mut gphys_camera, x: f32, y: f32) -> Status;
    pub fn gphys_camera_set_pick_start(camera: *mut gphys_camera, start: PickStart) -> Status;
    pub fn gphys_camera_get_projection(camera: *mut gphys_camera, out_kind: *mut Projection, out_size: *mut f32, out_near: *mut f32, out_far: *mut f32) -> Status;
    pub fn gphys_camera_get_viewport(camera: *mut gphys_camera, out_width: *mut f32, out_height: *mut f32) -> Status;
    pub fn gphys_camera_get_viewport_origin(camera: *mut gphys_camera, out_x: *mut f32, out_y: *mut f32) -> Status;
    pub fn gphys_camera_get_aspect(camera: *mut gphys_camera, out_aspect: *mut f32, out_is_fixed: *mut i32) -> Status;
    pub fn gphys_camera_get_image_size(camera: *mut gphys_camera, out_width: *mut f32, out_height: *mut f32) -> Status;
    pub fn gphys_camera_get_pick_start(camera: *mut gphys_camera, out_start: *mut PickStart) -> Status;
    pub fn gphys_camera_set_transform(camera: *mut gphys_camera, position: *const Vec3, rotation: *const Quat) -> Status;
    pub fn gphys_camera_set_world_matrix(camera: *mut gphys_camera, world: *const Mat4) -> Status;
    pub fn gphys_camera_set_view_matrix(camera: *mut gphys_camera, view: *const Mat4) -> Status;
    pub fn gphys_camera_look_at(camera: *mut gphys_camera, eye: *const Vec3, target: *const Vec3, up: *const Vec3) -> Status;
    pub fn gphys_camera_get_transform(camera: *mut gphys_camera, out_position: *mut Vec3, out_rotation: *mut Quat) -> Status;
    pub fn gphys_camera_get_world_matrix(camera: *mut gphys_camera, out_world: *mut Mat4) -> Status;
    pub fn gphys_camera_get_view_matrix(camera: *mut gphys_camera, out_view: *mut Mat4) -> Status;
    pub fn gphys_camera_get_projection_matrix(camera: *mut gphys_camera, out_projection: *mut Mat4) -> Status;
    pub fn gphys_camera_get_view_projection_matrix(camera: *mut gphys_camera, out_view_projection: *mut Mat4) -> Status;
    pub fn gphys_orbit_init(orbit: *mut Orbit) -> Status;
    pub fn gphys_camera_set_orbit(camera: *mut gphys_camera, orbit: *const Orbit) -> Status;
    pub fn gphys_camera_get_orbit(camera: *mut gphys_camera, out_orbit: *mut Orbit) -> Status;
    pub fn gphys_camera_set_orbit_speeds(camera: *mut gphys_camera, speeds: *const OrbitSpeeds) -> Status;
    pub fn gphys_camera_get_orbit_speeds(camera: *mut gphys_camera, out_speeds: *mut OrbitSpeeds) -> Status;
    pub fn gphys_camera_orbit_rotate(camera: *mut gphys_camera, units_x: f32, units_y: f32) -> Status;
    pub fn gphys_camera_orbit_zoom(camera: *mut gphys_camera, units: f32) -> Status;
    pub fn gphys_camera_orbit_pan(camera: *mut gphys_camera, units_right: f32, units_up: f32) -> Status;
    pub fn gphys_camera_orbit_update(camera: *mut gphys_camera) -> Status;
    pub fn gphys_camera_get_frustum(camera: *mut gphys_camera, out_frustum: *mut Frustum) -> Status;
    pub fn gphys_camera_get_corners(camera: *mut gphys_camera, out_corners: *mut Vec3) -> Status;
    pub fn gphys_camera_get_rectangle_frustum(camera: *mut gphys_camera, x0: f32, y0: f32, x1: f32, y1: f32, out_frustum: *mut Frustum) -> Status;
    pub fn gphys_camera_get_rectangle_corners(camera: *mut gphys_camera, x0: f32, y0: f32, x1: f32, y1: f32, out_corners: *mut Vec3) -> Status;
    pub fn gphys_camera_project(camera: *mut gphys_camera, point: *const Vec3, out_pixel: *mut Vec3) -> Status;
    pub fn gphys_camera_project_batch(camera: *mut gphys_camera, points: *const Vec3, point_stride: u32, count: u32, out_pixels: *mut Vec3, out_stride: u32) -> Status;
    pub fn gphys_camera_unproject(camera: *mut gphys_camera, pixel: *const Vec3, out_point: *mut Vec3) -> Status;
    pub fn gphys_camera_unproject_batch(camera: *mut gphys_camera, pixels: *const Vec3, pixel_stride: u32, count: u32, out_points: *mut Vec3, out_stride: u32) -> Status;
    pub fn gphys_camera_pick_ray(camera: *mut gphys_camera, pixel_x: f32, pixel_y: f32, out_ray: *mut Ray) -> Status;
    pub fn gphys_camera_pick_rays(camera: *mut gphys_camera, x: u32, y: u32, width: u32, height: u32, out_rays: *mut Ray, out_stride: u32) -> Status;
    pub fn gphys_camera_pick(camera: *mut gphys_camera, scene: *mut gphys_scene, pixel_x: f32, pixel_y: f32, layers: u32, out_hit: *mut Hit) -> Status;
    pub fn gphys_camera_pick_batch(camera: *mut gphys_camera, scene: *mut gphys_scene, pixels: *const [f32; 2], pixel_stride: u32, count: u32, layers: u32, out_hits: *mut Hit, out_stride: u32) -> Status;
    pub fn gphys_camera_pick_rectangle(camera: *mut gphys_camera, scene: *mut gphys_scene, x0: f32, y0: f32, x1: f32, y1: f32, layers: u32, out_models: *mut ModelId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_camera_cull(camera: *mut gphys_camera, scene: *mut gphys_scene, layers: u32, out_models: *mut ModelId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_camera_pick_filtered(camera: *mut gphys_camera, scene: *mut gphys_scene, pixel_x: f32, pixel_y: f32, filter: *const QueryFilterDesc, out_hit: *mut Hit) -> Status;
    pub fn gphys_camera_pick_filtered_batch(camera: *mut gphys_camera, scene: *mut gphys_scene, pixels: *const [f32; 2], pixel_stride: u32, count: u32, filters: *const QueryFilterDesc, filter_stride: u32, out_hits: *mut Hit, out_stride: u32) -> Status;
    pub fn gphys_camera_pick_rectangle_filtered(camera: *mut gphys_camera, scene: *mut gphys_scene, x0: f32, y0: f32, x1: f32, y1: f32, filter: *const QueryFilterDesc, out_models: *mut ModelId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_camera_cull_filtered(camera: *mut gphys_camera, scene: *mut gphys_scene, filter: *const QueryFilterDesc, out_models: *mut ModelId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_solver_desc_init(desc: *mut SolverDesc, size: u32) -> Status;
    pub fn gphys_solver_create(desc: *const SolverDesc, out_solver: *mut *mut gphys_solver) -> Status;
    pub fn gphys_solver_destroy(solver: *mut gphys_solver);
    pub fn gphys_solver_set_origin(solver: *mut gphys_solver, origin: *const f64) -> Status;
    pub fn gphys_solver_get_origin(solver: *mut gphys_solver, out_origin: *mut f64) -> Status;
    pub fn gphys_solver_set_gravity(solver: *mut gphys_solver, gravity: *const Vec3) -> Status;
    pub fn gphys_solver_set_substeps(solver: *mut gphys_solver, substeps: u32) -> Status;
    pub fn gphys_body_desc_init(desc: *mut BodyDesc, size: u32) -> Status;
    pub fn gphys_solver_add_particles(solver: *mut gphys_solver, desc: *const BodyDesc, positions: *const Vec3, position_stride: u32, count: u32, out_body: *mut BodyId) -> Status;
    pub fn gphys_solver_add_rope(solver: *mut gphys_solver, desc: *const BodyDesc, positions: *const Vec3, position_stride: u32, count: u32, link_length: f32, out_body: *mut BodyId) -> Status;
    pub fn gphys_solver_add_cloth(solver: *mut gphys_solver, desc: *const BodyDesc, corner: *const Vec3, edge_u: *const Vec3, edge_v: *const Vec3, columns: u32, rows: u32, out_body: *mut BodyId) -> Status;
    pub fn gphys_solver_add_cloth_mesh(solver: *mut gphys_solver, desc: *const BodyDesc, mesh: *mut gphys_mesh, transform: *const Transform, out_body: *mut BodyId) -> Status;
    pub fn gphys_solver_remove_body(solver: *mut gphys_solver, body: BodyId) -> Status;
    pub fn gphys_solver_get_bodies(solver: *mut gphys_solver, out_bodies: *mut BodyId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_solver_get_sleeping(solver: *mut gphys_solver, out_bodies: *mut BodyId, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_solver_wake(solver: *mut gphys_solver, body: BodyId) -> Status;
    pub fn gphys_solver_get_body_info(solver: *mut gphys_solver, body: BodyId, out_info: *mut BodyInfo) -> Status;
    pub fn gphys_solver_get_triangles(solver: *mut gphys_solver, body: BodyId, out_indices: *mut u32, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_solver_get_positions(solver: *mut gphys_solver, body: BodyId, first: u32, count: u32, out_positions: *mut Vec3, out_stride: u32) -> Status;
    pub fn gphys_solver_set_positions(solver: *mut gphys_solver, body: BodyId, first: u32, count: u32, positions: *const Vec3, stride: u32) -> Status;
    pub fn gphys_solver_get_velocities(solver: *mut gphys_solver, body: BodyId, first: u32, count: u32, out_velocities: *mut Vec3, out_stride: u32) -> Status;
    pub fn gphys_solver_set_velocities(solver: *mut gphys_solver, body: BodyId, first: u32, count: u32, velocities: *const Vec3, stride: u32) -> Status;
    pub fn gphys_solver_get_masses(solver: *mut gphys_solver, body: BodyId, first: u32, count: u32, out_masses: *mut f32, out_stride: u32) -> Status;
    pub fn gphys_solver_set_masses(solver: *mut gphys_solver, body: BodyId, first: u32, count: u32, masses: *const f32, stride: u32) -> Status;
    pub fn gphys_solver_set_radii(solver: *mut gphys_solver, body: BodyId, first: u32, count: u32, radii: *const f32, stride: u32) -> Status;
    pub fn gphys_solver_set_forces(solver: *mut gphys_solver, body: BodyId, first: u32, count: u32, forces: *const Vec3, stride: u32) -> Status;
    pub fn gphys_solver_set_pinned(solver: *mut gphys_solver, body: BodyId, first: u32, count: u32, pinned: i32) -> Status;
    pub fn gphys_solver_attach(solver: *mut gphys_solver, scene: *mut gphys_scene, body: BodyId, particle: u32, model: ModelId, local_point: *const Vec3) -> Status;
    pub fn gphys_solver_detach(solver: *mut gphys_solver, body: BodyId, particle: u32) -> Status;
    pub fn gphys_solver_add_distance(solver: *mut gphys_solver, body: BodyId, particle_a: u32, particle_b: u32, rest_length: f32, compliance: f32, out_constraint: *mut ConstraintId) -> Status;
    pub fn gphys_solver_add_max_distance(solver: *mut gphys_solver, body: BodyId, particle_a: u32, particle_b: u32, max_length: f32, compliance: f32, out_constraint: *mut ConstraintId) -> Status;
    pub fn gphys_solver_set_constraint_damping(solver: *mut gphys_solver, body: BodyId, constraint: ConstraintId, damping: f32) -> Status;
    pub fn gphys_solver_set_volume(solver: *mut gphys_solver, body: BodyId, rest_volume: f32, compliance: f32) -> Status;
    pub fn gphys_solver_get_volume(solver: *mut gphys_solver, body: BodyId, out_volume: *mut f32, out_pressure: *mut f32) -> Status;
    pub fn gphys_solver_remove_constraint(solver: *mut gphys_solver, body: BodyId, constraint: ConstraintId) -> Status;
    pub fn gphys_solver_get_constraints(solver: *mut gphys_solver, body: BodyId, out_constraints: *mut ConstraintInfo, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_solver_join(solver: *mut gphys_solver, body_a: BodyId, particle_a: u32, body_b: BodyId, particle_b: u32, rest_length: f32, compliance: f32, out_joint: *mut JointId) -> Status;
    pub fn gphys_solver_unjoin(solver: *mut gphys_solver, joint: JointId) -> Status;
    pub fn gphys_solver_get_joints(solver: *mut gphys_solver, body: BodyId, out_joints: *mut JointInfo, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_solver_step(solver: *mut gphys_solver, scene: *mut gphys_scene, dt: f32) -> Status;
    pub fn gphys_solver_advance(solver: *mut gphys_solver, scene: *mut gphys_scene, frame_time: f32, out_steps: *mut u32, out_leftover: *mut f32) -> Status;
    pub fn gphys_solver_get_substeps(solver: *mut gphys_solver, body: BodyId, out_substeps: *mut u32) -> Status;
    pub fn gphys_solver_get_stats(solver: *mut gphys_solver, body: BodyId, out_stats: *mut SolverStats) -> Status;
    pub fn gphys_solver_get_contacts(solver: *mut gphys_solver, out_contacts: *mut Contact, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_solver_get_impulses(solver: *mut gphys_solver, out_impulses: *mut Impulse, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_solver_get_snapshot(solver: *mut gphys_solver, out_words: *mut u32, capacity: u32, out_total: *mut u32) -> Status;
    pub fn gphys_solver_restore(solver: *mut gphys_solver, words: *const u32, count: u32) -> Status;
    pub fn gphys_solver_get_hash(solver: *mut gphys_solver, out_hash: *mut u32) -> Status;
}
