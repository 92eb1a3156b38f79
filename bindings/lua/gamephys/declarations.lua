-- Generated from gamephys_api.json by bindings/generate.py. Not for editing.
return {
    declarations = [[
typedef int32_t gphys_status;
typedef int32_t gphys_shape_type;
typedef int32_t gphys_side;
typedef int32_t gphys_depth_range;
typedef int32_t gphys_mesh_kind;
typedef uint32_t gphys_model_id;
typedef int32_t gphys_projection;
typedef int32_t gphys_handedness;
typedef int32_t gphys_pick_start;
typedef uint32_t gphys_body_id;
typedef uint32_t gphys_constraint_id;
typedef int32_t gphys_body_kind;
typedef int32_t gphys_solve_method;
typedef int32_t gphys_constraint_kind;
typedef uint32_t gphys_cluster_id;
typedef uint32_t gphys_joint_id;
typedef struct gphys_mesh gphys_mesh;
typedef struct gphys_scene gphys_scene;
typedef struct gphys_camera gphys_camera;
typedef struct gphys_solver gphys_solver;
typedef void (*gphys_task)(void *, uint32_t);
typedef struct gphys_allocator { void *(*allocate)(void *, size_t, size_t); void (*release)(void *, void *, size_t, size_t); void *user; } gphys_allocator;
typedef struct gphys_task_runner { void (*run)(void *, gphys_task, void *, uint32_t); void *user; } gphys_task_runner;
typedef struct gphys_vec3 { float x; float y; float z; } gphys_vec3;
typedef struct gphys_quat { float x; float y; float z; float w; } gphys_quat;
typedef struct gphys_mat4 { float m[16]; } gphys_mat4;
typedef struct gphys_transform { gphys_vec3 position; gphys_quat rotation; float scale; } gphys_transform;
typedef struct gphys_ray { gphys_vec3 origin; gphys_vec3 direction; float t_max; } gphys_ray;
typedef struct gphys_segment { gphys_vec3 a; gphys_vec3 b; } gphys_segment;
typedef struct gphys_sphere { gphys_vec3 center; float radius; } gphys_sphere;
typedef struct gphys_capsule { gphys_vec3 a; gphys_vec3 b; float radius; } gphys_capsule;
typedef struct gphys_aabb { gphys_vec3 min; gphys_vec3 max; } gphys_aabb;
typedef struct gphys_obb { gphys_vec3 center; gphys_vec3 half_extents; gphys_quat rotation; } gphys_obb;
typedef struct gphys_plane { gphys_vec3 normal; float distance; } gphys_plane;
typedef struct gphys_triangle { gphys_vec3 a; gphys_vec3 b; gphys_vec3 c; } gphys_triangle;
typedef struct gphys_frustum { gphys_vec3 origin; gphys_plane planes[6]; } gphys_frustum;
typedef struct gphys_hit { uint32_t model; uint32_t tag; float t; gphys_vec3 point; gphys_vec3 normal; uint32_t triangle; float u; float v; uint32_t flags; } gphys_hit;
typedef struct gphys_nearest { uint32_t model; uint32_t tag; gphys_vec3 point; float distance; uint32_t triangle; } gphys_nearest;
typedef struct gphys_distance { float t; uint32_t model; uint32_t triangle; } gphys_distance;
typedef struct gphys_penetration { uint32_t model; uint32_t tag; gphys_vec3 point; gphys_vec3 normal; float depth; uint32_t triangle; } gphys_penetration;
typedef struct gphys_mesh_report { uint32_t triangle_count; uint32_t degenerate_count; uint32_t first_degenerate; uint32_t out_of_range_count; uint32_t first_out_of_range; uint32_t bad_vertex_count; uint32_t first_bad_vertex; uint32_t open_edge_count; } gphys_mesh_report;
typedef struct gphys_mesh_desc { uint32_t struct_size; const gphys_allocator *allocator; int32_t deformable; uint32_t reserved; } gphys_mesh_desc;
typedef struct gphys_mesh_info { gphys_mesh_kind kind; uint32_t vertex_count; uint32_t triangle_count; int32_t deformable; int32_t follows_body; } gphys_mesh_info;
typedef struct gphys_octree_stats { uint32_t item_count; uint32_t unbounded_count; uint32_t node_count; uint32_t leaf_count; uint32_t depth; uint32_t rebuilds; float cost; uint32_t memory_bytes; } gphys_octree_stats;
typedef struct gphys_octree_box { gphys_aabb bounds; uint32_t depth; uint32_t item_count; } gphys_octree_box;
typedef struct gphys_scene_desc { uint32_t struct_size; const gphys_allocator *allocator; uint32_t reserve_models; const gphys_task_runner *task_runner; uint32_t worker_count; uint32_t reserved; } gphys_scene_desc;
typedef struct gphys_model_desc { uint32_t struct_size; gphys_model_id parent; uint32_t layers; uint32_t tag; gphys_vec3 scale; } gphys_model_desc;
typedef struct gphys_model_info { gphys_shape_type type; gphys_model_id parent; uint32_t layers; uint32_t tag; uint32_t child_count; } gphys_model_info;
typedef struct gphys_query_filter_desc { uint32_t struct_size; uint32_t layers; gphys_model_id ignored_model; uint32_t flags; const gphys_model_id *ignored_models; uint32_t ignored_count; uint32_t reserved; } gphys_query_filter_desc;
typedef struct gphys_camera_desc { uint32_t struct_size; const gphys_allocator *allocator; gphys_handedness handedness; gphys_depth_range depth_range; int32_t reverse_z; float viewport_width; float viewport_height; uint32_t reserved; } gphys_camera_desc;
typedef struct gphys_orbit { gphys_vec3 target; gphys_vec3 up; float distance; float yaw; float pitch; float radians_per_unit; float metres_per_unit; float min_distance; float max_distance; float min_pitch; float max_pitch; } gphys_orbit;
typedef struct gphys_orbit_speeds { float rotate_x; float rotate_y; float zoom; float pan_x; float pan_y; } gphys_orbit_speeds;
typedef struct gphys_solver_desc { uint32_t struct_size; const gphys_allocator *allocator; gphys_vec3 gravity; uint32_t substeps; float fixed_step; uint32_t max_steps; const gphys_task_runner *task_runner; uint32_t worker_count; float sleep_speed; float sleep_strain; float sleep_time; float max_strain; float tolerance; uint32_t max_substeps; uint32_t max_work; } gphys_solver_desc;
typedef struct gphys_solver_settings { gphys_vec3 gravity; uint32_t substeps; float fixed_step; uint32_t max_steps; float sleep_speed; float sleep_strain; float sleep_time; float max_strain; float tolerance; uint32_t max_substeps; uint32_t max_work; } gphys_solver_settings;
typedef struct gphys_body_desc { uint32_t struct_size; float mass; float radius; float damping; float friction; float restitution; float compliance; float bend_compliance; uint32_t cloth_flags; uint32_t layers; float static_friction; uint32_t self_collision; uint32_t body_layers; float shear_compliance; float breaking_force; float bending_stiffness; } gphys_body_desc;
typedef struct gphys_body_settings { float damping; float friction; float static_friction; float restitution; uint32_t layers; uint32_t body_layers; uint32_t self_collision; } gphys_body_settings;
typedef struct gphys_body_info { gphys_body_kind kind; gphys_solve_method method; uint32_t particle_count; uint32_t constraint_count; uint32_t triangle_count; } gphys_body_info;
typedef struct gphys_wind { gphys_vec3 velocity; float density; float drag; float lift; } gphys_wind;
typedef struct gphys_animation_target { gphys_vec3 position; gphys_vec3 normal; float max_distance; float backstop; } gphys_animation_target;
typedef struct gphys_attachment { uint32_t particle; gphys_model_id model; gphys_vec3 local_point; } gphys_attachment;
typedef struct gphys_constraint_info { gphys_constraint_id id; uint32_t particle_a; uint32_t particle_b; float rest_length; float compliance; } gphys_constraint_info;
typedef struct gphys_constraint_settings { float rest_length; float compliance; float damping; } gphys_constraint_settings;
typedef struct gphys_joint_info { gphys_joint_id id; gphys_body_id body_a; uint32_t particle_a; gphys_body_id body_b; uint32_t particle_b; float rest_length; float compliance; float force; } gphys_joint_info;
typedef struct gphys_break { gphys_body_id body; gphys_constraint_id constraint; uint32_t particle_a; uint32_t particle_b; uint32_t torn_particle; uint32_t new_particle; float load; } gphys_break;
typedef struct gphys_solver_stats { uint32_t particle_count; uint32_t pinned_count; uint32_t constraint_count; uint32_t contact_count; float strain_max; float strain_rms; float kinetic_energy; float potential_energy; } gphys_solver_stats;
typedef struct gphys_contact { gphys_body_id body; uint32_t particle; gphys_model_id model; uint32_t tag; gphys_vec3 point; gphys_vec3 normal; } gphys_contact;
typedef struct gphys_body_contact { gphys_body_id body_a; uint32_t particle_a; gphys_body_id body_b; uint32_t particle_b; gphys_vec3 normal; float distance; float impulse; } gphys_body_contact;
typedef struct gphys_impulse { gphys_model_id model; uint32_t tag; gphys_vec3 linear; gphys_vec3 angular; } gphys_impulse;
uint32_t gphys_version(void);
const char *gphys_status_name(gphys_status status);
const char *gphys_last_error(void);
gphys_status gphys_shape_validate(gphys_shape_type type, const void *shape);
gphys_status gphys_shape_bounds(gphys_shape_type type, const void *shape, gphys_aabb *out_bounds);
gphys_status gphys_shape_transform(gphys_shape_type type, const void *shape, const gphys_transform *transform, void *out_shape);
gphys_status gphys_shape_contains(gphys_shape_type type, const void *shape, const gphys_vec3 *point, float tolerance, int32_t *out_contains);
gphys_status gphys_shape_contains_batch(gphys_shape_type type, const void *shape, const gphys_vec3 *points, uint32_t point_stride, uint32_t count, float tolerance, int32_t *out_contains, uint32_t out_stride);
gphys_status gphys_shape_closest_point(gphys_shape_type type, const void *shape, const gphys_vec3 *point, gphys_nearest *out_nearest);
gphys_status gphys_shape_closest_point_batch(gphys_shape_type type, const void *shape, const gphys_vec3 *points, uint32_t point_stride, uint32_t count, gphys_nearest *out_nearest, uint32_t out_stride);
gphys_status gphys_segment_closest_points(const gphys_segment *a, const gphys_segment *b, gphys_vec3 *out_a, gphys_vec3 *out_b, float *out_distance);
gphys_status gphys_shape_overlaps(gphys_shape_type a_type, const void *a, gphys_shape_type b_type, const void *b, int32_t *out_overlaps);
gphys_status gphys_shape_overlaps_batch(gphys_shape_type a_type, const void *a, uint32_t a_stride, gphys_shape_type b_type, const void *b, uint32_t b_stride, uint32_t count, int32_t *out_overlaps, uint32_t out_stride);
gphys_status gphys_shape_classify_plane(gphys_shape_type type, const void *shape, const gphys_plane *plane, gphys_side *out_side, float *out_signed_distance);
gphys_status gphys_shape_classify_frustum(gphys_shape_type type, const void *shape, const gphys_frustum *frustum, gphys_side *out_side);
gphys_status gphys_shape_raycast(gphys_shape_type type, const void *shape, const gphys_ray *ray, gphys_hit *out_hit);
gphys_status gphys_shape_raycast_batch(gphys_shape_type type, const void *shape, const gphys_ray *rays, uint32_t ray_stride, uint32_t count, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_shape_segment_test(gphys_shape_type type, const void *shape, const gphys_segment *segment, gphys_hit *out_hit);
gphys_status gphys_shape_sweep_sphere(gphys_shape_type type, const void *shape, const gphys_sphere *sphere, const gphys_vec3 *displacement, gphys_hit *out_hit);
gphys_status gphys_shape_sweep(gphys_shape_type type, const void *shape, gphys_shape_type moving_type, const void *moving, const gphys_vec3 *displacement, gphys_hit *out_hit);
gphys_status gphys_shape_sweep_batch(gphys_shape_type type, const void *shapes, uint32_t shape_stride, gphys_shape_type moving_type, const void *moving, uint32_t moving_stride, const gphys_vec3 *displacements, uint32_t displacement_stride, uint32_t count, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_shape_penetration(gphys_shape_type type, const void *shape, gphys_shape_type moving_type, const void *moving, gphys_penetration *out_penetration);
gphys_status gphys_shape_penetration_batch(gphys_shape_type type, const void *shapes, uint32_t shape_stride, gphys_shape_type moving_type, const void *moving, uint32_t moving_stride, uint32_t count, gphys_penetration *out_penetrations, uint32_t out_stride);
gphys_status gphys_frustum_corners(const gphys_frustum *frustum, gphys_vec3 *out_corners);
gphys_status gphys_planes_intersection(const gphys_plane *a, const gphys_plane *b, const gphys_plane *c, gphys_vec3 *out_point);
gphys_status gphys_planes_intersection_batch(const gphys_plane *a, uint32_t a_stride, const gphys_plane *b, uint32_t b_stride, const gphys_plane *c, uint32_t c_stride, uint32_t count, gphys_vec3 *out_points, uint32_t out_stride);
gphys_status gphys_mat4_orthonormality(const gphys_mat4 *matrix, float *out_deviation);
gphys_status gphys_frustum_from_matrix(const gphys_mat4 *view_projection, gphys_depth_range depth_range, int32_t reverse_z, gphys_frustum *out_frustum);
gphys_status gphys_mesh_check(const float *vertices, uint32_t vertex_stride, uint32_t vertex_count, const uint32_t *indices, uint32_t index_count, gphys_mesh_report *out_report);
gphys_status gphys_mesh_desc_init(gphys_mesh_desc *desc, uint32_t size);
gphys_status gphys_mesh_create(const gphys_mesh_desc *desc, const float *vertices, uint32_t vertex_stride, uint32_t vertex_count, const uint32_t *indices, uint32_t index_count, gphys_mesh **out_mesh);
gphys_status gphys_mesh_create_hull(const gphys_mesh_desc *desc, const float *points, uint32_t point_stride, uint32_t point_count, gphys_mesh **out_mesh);
gphys_status gphys_mesh_get_hull_planes(const gphys_mesh *mesh, gphys_plane *out_planes, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_mesh_get_hull_faces(const gphys_mesh *mesh, uint32_t *out_faces, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_mesh_set_vertices(gphys_mesh *mesh, const float *vertices, uint32_t vertex_stride, uint32_t vertex_count);
void gphys_mesh_destroy(gphys_mesh *mesh);
gphys_status gphys_mesh_get_info(const gphys_mesh *mesh, gphys_mesh_info *out_info);
gphys_status gphys_mesh_get_report(const gphys_mesh *mesh, gphys_mesh_report *out_report);
gphys_status gphys_mesh_get_vertices(const gphys_mesh *mesh, gphys_vec3 *out_vertices, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_mesh_get_indices(const gphys_mesh *mesh, uint32_t *out_indices, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_mesh_get_snapshot(const gphys_mesh *mesh, uint32_t *out_words, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_mesh_create_from_snapshot(const gphys_mesh_desc *desc, const uint32_t *words, uint32_t word_count, gphys_mesh **out_mesh);
gphys_status gphys_mesh_raycast_all(const gphys_mesh *mesh, const gphys_ray *ray, gphys_hit *out_hits, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_mesh_raycast_any(const gphys_mesh *mesh, const gphys_ray *ray, int32_t *out_hit);
gphys_status gphys_mesh_raycast_any_batch(const gphys_mesh *mesh, const gphys_ray *rays, uint32_t ray_stride, uint32_t count, int32_t *out_hits, uint32_t out_stride);
gphys_status gphys_mesh_raycast_distance_batch(const gphys_mesh *mesh, const gphys_ray *rays, uint32_t ray_stride, uint32_t count, gphys_distance *out_distances, uint32_t out_stride);
gphys_status gphys_mesh_overlap(const gphys_mesh *mesh, gphys_shape_type type, const void *shape, uint32_t *out_triangles, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_mesh_get_octree_stats(const gphys_mesh *mesh, gphys_octree_stats *out_stats);
gphys_status gphys_mesh_get_octree_boxes(const gphys_mesh *mesh, gphys_octree_box *out_boxes, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_desc_init(gphys_scene_desc *desc, uint32_t size);
gphys_status gphys_scene_create(const gphys_scene_desc *desc, gphys_scene **out_scene);
void gphys_scene_destroy(gphys_scene *scene);
gphys_status gphys_scene_set_worker_count(gphys_scene *scene, uint32_t workers);
gphys_status gphys_scene_get_worker_count(const gphys_scene *scene, uint32_t *out_workers);
gphys_status gphys_scene_set_origin(gphys_scene *scene, const double *origin);
gphys_status gphys_scene_get_origin(const gphys_scene *scene, double *out_origin);
gphys_status gphys_model_desc_init(gphys_model_desc *desc, uint32_t size);
gphys_status gphys_scene_add(gphys_scene *scene, gphys_shape_type type, const void *shape, const gphys_transform *transform, const gphys_model_desc *desc, gphys_model_id *out_model);
gphys_status gphys_scene_add_batch(gphys_scene *scene, gphys_shape_type type, const void *shapes, uint32_t shape_stride, const gphys_transform *transforms, uint32_t transform_stride, uint32_t count, const gphys_model_desc *desc, gphys_model_id *out_models);
gphys_status gphys_scene_add_described_batch(gphys_scene *scene, gphys_shape_type type, const void *shapes, uint32_t shape_stride, const gphys_transform *transforms, uint32_t transform_stride, const gphys_model_desc *descs, uint32_t desc_stride, uint32_t count, gphys_model_id *out_models);
gphys_status gphys_scene_remove(gphys_scene *scene, gphys_model_id model);
gphys_status gphys_scene_remove_batch(gphys_scene *scene, const gphys_model_id *models, uint32_t count);
gphys_status gphys_scene_remove_subtree(gphys_scene *scene, gphys_model_id model);
gphys_status gphys_scene_clear(gphys_scene *scene);
gphys_status gphys_scene_has(const gphys_scene *scene, gphys_model_id model);
gphys_status gphys_scene_get_models(const gphys_scene *scene, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_get_roots(const gphys_scene *scene, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_get_children(const gphys_scene *scene, gphys_model_id model, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_get_info(const gphys_scene *scene, gphys_model_id model, gphys_model_info *out_info);
gphys_status gphys_scene_get_shape(const gphys_scene *scene, gphys_model_id model, void *out_shape, uint32_t out_size);
gphys_status gphys_scene_get_mesh(const gphys_scene *scene, gphys_model_id model, gphys_mesh **out_mesh);
gphys_status gphys_scene_get_bounds(const gphys_scene *scene, gphys_model_id model, gphys_aabb *out_bounds);
gphys_status gphys_scene_get_scene_bounds(const gphys_scene *scene, gphys_aabb *out_bounds);
gphys_status gphys_scene_set_shape(gphys_scene *scene, gphys_model_id model, gphys_shape_type type, const void *shape);
gphys_status gphys_scene_set_scale(gphys_scene *scene, gphys_model_id model, const gphys_vec3 *scale);
gphys_status gphys_scene_get_scale(const gphys_scene *scene, gphys_model_id model, gphys_vec3 *out_scale);
gphys_status gphys_scene_set_layers(gphys_scene *scene, gphys_model_id model, uint32_t layers);
gphys_status gphys_scene_set_tag(gphys_scene *scene, gphys_model_id model, uint32_t tag);
gphys_status gphys_scene_set_parent(gphys_scene *scene, gphys_model_id model, gphys_model_id parent, int32_t keep_world);
gphys_status gphys_scene_set_transform(gphys_scene *scene, gphys_model_id model, const gphys_transform *transform);
gphys_status gphys_scene_set_transforms(gphys_scene *scene, const gphys_model_id *models, const gphys_transform *transforms, uint32_t transform_stride, uint32_t count);
gphys_status gphys_scene_get_transforms(const gphys_scene *scene, const gphys_model_id *models, uint32_t count, gphys_transform *out_transforms, uint32_t out_stride);
gphys_status gphys_scene_get_world_transforms(const gphys_scene *scene, const gphys_model_id *models, uint32_t count, gphys_transform *out_transforms, uint32_t out_stride);
gphys_status gphys_scene_raycast(const gphys_scene *scene, const gphys_ray *ray, uint32_t layers, gphys_hit *out_hit);
gphys_status gphys_scene_raycast_batch(const gphys_scene *scene, const gphys_ray *rays, uint32_t ray_stride, uint32_t count, uint32_t layers, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_scene_raycast_distance_batch(const gphys_scene *scene, const gphys_ray *rays, uint32_t ray_stride, uint32_t count, uint32_t layers, gphys_distance *out_distances, uint32_t out_stride);
gphys_status gphys_scene_raycast_any(const gphys_scene *scene, const gphys_ray *ray, uint32_t layers, int32_t *out_hit);
gphys_status gphys_scene_raycast_any_batch(const gphys_scene *scene, const gphys_ray *rays, uint32_t ray_stride, uint32_t count, uint32_t layers, int32_t *out_hits, uint32_t out_stride);
gphys_status gphys_scene_raycast_all(const gphys_scene *scene, const gphys_ray *ray, uint32_t layers, gphys_hit *out_hits, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_raycast_all_batch(const gphys_scene *scene, const gphys_ray *rays, uint32_t ray_stride, uint32_t count, uint32_t layers, gphys_hit *out_hits, uint32_t capacity, uint32_t *out_offsets);
gphys_status gphys_scene_segment_test(const gphys_scene *scene, const gphys_segment *segment, uint32_t layers, gphys_hit *out_hit);
gphys_status gphys_scene_segment_test_batch(const gphys_scene *scene, const gphys_segment *segments, uint32_t segment_stride, uint32_t count, uint32_t layers, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_scene_overlap(const gphys_scene *scene, gphys_shape_type type, const void *shape, uint32_t layers, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_overlap_batch(const gphys_scene *scene, gphys_shape_type type, const void *shapes, uint32_t shape_stride, uint32_t count, uint32_t layers, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_offsets);
gphys_status gphys_scene_cull(const gphys_scene *scene, const gphys_frustum *frustum, uint32_t layers, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_cull_batch(const gphys_scene *scene, const gphys_frustum *frusta, uint32_t frustum_stride, uint32_t count, uint32_t layers, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_offsets);
gphys_status gphys_scene_nearest(const gphys_scene *scene, const gphys_vec3 *point, float max_distance, uint32_t layers, gphys_nearest *out_nearest);
gphys_status gphys_scene_nearest_batch(const gphys_scene *scene, const gphys_vec3 *points, uint32_t point_stride, uint32_t count, float max_distance, uint32_t layers, gphys_nearest *out_nearest, uint32_t out_stride);
gphys_status gphys_scene_sweep_sphere(const gphys_scene *scene, const gphys_sphere *sphere, const gphys_vec3 *displacement, uint32_t layers, gphys_hit *out_hit);
gphys_status gphys_scene_sweep_sphere_batch(const gphys_scene *scene, const gphys_sphere *spheres, uint32_t sphere_stride, const gphys_vec3 *displacements, uint32_t displacement_stride, uint32_t count, uint32_t layers, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_scene_sweep(const gphys_scene *scene, gphys_shape_type type, const void *shape, const gphys_vec3 *displacement, uint32_t layers, gphys_hit *out_hit);
gphys_status gphys_scene_sweep_batch(const gphys_scene *scene, gphys_shape_type type, const void *shapes, uint32_t shape_stride, const gphys_vec3 *displacements, uint32_t displacement_stride, uint32_t count, uint32_t layers, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_scene_penetration(const gphys_scene *scene, gphys_shape_type type, const void *shape, uint32_t layers, gphys_penetration *out_penetrations, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_penetration_batch(const gphys_scene *scene, gphys_shape_type type, const void *shapes, uint32_t shape_stride, uint32_t count, uint32_t layers, gphys_penetration *out_penetrations, uint32_t capacity, uint32_t *out_offsets);
gphys_status gphys_query_filter_desc_init(gphys_query_filter_desc *desc, uint32_t size);
gphys_status gphys_scene_raycast_filtered(const gphys_scene *scene, const gphys_ray *ray, const gphys_query_filter_desc *filter, gphys_hit *out_hit);
gphys_status gphys_scene_raycast_filtered_batch(const gphys_scene *scene, const gphys_ray *rays, uint32_t ray_stride, uint32_t count, const gphys_query_filter_desc *filters, uint32_t filter_stride, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_scene_raycast_distance_filtered_batch(const gphys_scene *scene, const gphys_ray *rays, uint32_t ray_stride, uint32_t count, const gphys_query_filter_desc *filters, uint32_t filter_stride, gphys_distance *out_distances, uint32_t out_stride);
gphys_status gphys_scene_raycast_any_filtered(const gphys_scene *scene, const gphys_ray *ray, const gphys_query_filter_desc *filter, int32_t *out_hit);
gphys_status gphys_scene_raycast_any_filtered_batch(const gphys_scene *scene, const gphys_ray *rays, uint32_t ray_stride, uint32_t count, const gphys_query_filter_desc *filters, uint32_t filter_stride, int32_t *out_hits, uint32_t out_stride);
gphys_status gphys_scene_raycast_all_filtered(const gphys_scene *scene, const gphys_ray *ray, const gphys_query_filter_desc *filter, gphys_hit *out_hits, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_raycast_all_filtered_batch(const gphys_scene *scene, const gphys_ray *rays, uint32_t ray_stride, uint32_t count, const gphys_query_filter_desc *filters, uint32_t filter_stride, gphys_hit *out_hits, uint32_t capacity, uint32_t *out_offsets);
gphys_status gphys_scene_segment_test_filtered(const gphys_scene *scene, const gphys_segment *segment, const gphys_query_filter_desc *filter, gphys_hit *out_hit);
gphys_status gphys_scene_segment_test_filtered_batch(const gphys_scene *scene, const gphys_segment *segments, uint32_t segment_stride, uint32_t count, const gphys_query_filter_desc *filters, uint32_t filter_stride, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_scene_overlap_filtered(const gphys_scene *scene, gphys_shape_type type, const void *shape, const gphys_query_filter_desc *filter, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_overlap_filtered_batch(const gphys_scene *scene, gphys_shape_type type, const void *shapes, uint32_t shape_stride, uint32_t count, const gphys_query_filter_desc *filters, uint32_t filter_stride, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_offsets);
gphys_status gphys_scene_cull_filtered(const gphys_scene *scene, const gphys_frustum *frustum, const gphys_query_filter_desc *filter, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_cull_filtered_batch(const gphys_scene *scene, const gphys_frustum *frusta, uint32_t frustum_stride, uint32_t count, const gphys_query_filter_desc *filters, uint32_t filter_stride, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_offsets);
gphys_status gphys_scene_nearest_filtered(const gphys_scene *scene, const gphys_vec3 *point, float max_distance, const gphys_query_filter_desc *filter, gphys_nearest *out_nearest);
gphys_status gphys_scene_nearest_filtered_batch(const gphys_scene *scene, const gphys_vec3 *points, uint32_t point_stride, uint32_t count, float max_distance, const gphys_query_filter_desc *filters, uint32_t filter_stride, gphys_nearest *out_nearest, uint32_t out_stride);
gphys_status gphys_scene_sweep_sphere_filtered(const gphys_scene *scene, const gphys_sphere *sphere, const gphys_vec3 *displacement, const gphys_query_filter_desc *filter, gphys_hit *out_hit);
gphys_status gphys_scene_sweep_sphere_filtered_batch(const gphys_scene *scene, const gphys_sphere *spheres, uint32_t sphere_stride, const gphys_vec3 *displacements, uint32_t displacement_stride, uint32_t count, const gphys_query_filter_desc *filters, uint32_t filter_stride, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_scene_sweep_filtered(const gphys_scene *scene, gphys_shape_type type, const void *shape, const gphys_vec3 *displacement, const gphys_query_filter_desc *filter, gphys_hit *out_hit);
gphys_status gphys_scene_sweep_filtered_batch(const gphys_scene *scene, gphys_shape_type type, const void *shapes, uint32_t shape_stride, const gphys_vec3 *displacements, uint32_t displacement_stride, uint32_t count, const gphys_query_filter_desc *filters, uint32_t filter_stride, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_scene_penetration_filtered(const gphys_scene *scene, gphys_shape_type type, const void *shape, const gphys_query_filter_desc *filter, gphys_penetration *out_penetrations, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_penetration_filtered_batch(const gphys_scene *scene, gphys_shape_type type, const void *shapes, uint32_t shape_stride, uint32_t count, const gphys_query_filter_desc *filters, uint32_t filter_stride, gphys_penetration *out_penetrations, uint32_t capacity, uint32_t *out_offsets);
gphys_status gphys_scene_rebuild_octree(gphys_scene *scene);
gphys_status gphys_scene_maintain_octree(gphys_scene *scene, uint32_t budget, int32_t *out_done);
gphys_status gphys_scene_get_octree_stats(const gphys_scene *scene, gphys_octree_stats *out_stats);
gphys_status gphys_scene_get_octree_boxes(const gphys_scene *scene, gphys_octree_box *out_boxes, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_validate(const gphys_scene *scene);
gphys_status gphys_scene_get_snapshot(const gphys_scene *scene, int32_t embed_meshes, uint32_t *out_words, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_scene_restore(gphys_scene *scene, const gphys_scene *library, const uint32_t *words, uint32_t count);
gphys_status gphys_scene_get_hash(const gphys_scene *scene, uint32_t *out_hash);
gphys_status gphys_camera_desc_init(gphys_camera_desc *desc, uint32_t size);
gphys_status gphys_camera_create(const gphys_camera_desc *desc, gphys_camera **out_camera);
void gphys_camera_destroy(gphys_camera *camera);
gphys_status gphys_camera_set_origin(gphys_camera *camera, const double *origin);
gphys_status gphys_camera_get_origin(const gphys_camera *camera, double *out_origin);
gphys_status gphys_camera_set_perspective(gphys_camera *camera, float fov_y, float near_distance, float far_distance);
gphys_status gphys_camera_set_orthographic(gphys_camera *camera, float height, float near_distance, float far_distance);
gphys_status gphys_camera_set_projection(gphys_camera *camera, const gphys_mat4 *projection);
gphys_status gphys_camera_set_perspective_aspect(gphys_camera *camera, float fov_y, float aspect, float near_distance, float far_distance);
gphys_status gphys_camera_set_orthographic_size(gphys_camera *camera, float width, float height, float near_distance, float far_distance);
gphys_status gphys_camera_set_viewport(gphys_camera *camera, float width, float height);
gphys_status gphys_camera_set_viewport_origin(gphys_camera *camera, float x, float y);
gphys_status gphys_camera_set_pick_start(gphys_camera *camera, gphys_pick_start start);
gphys_status gphys_camera_get_projection(const gphys_camera *camera, gphys_projection *out_kind, float *out_size, float *out_near, float *out_far);
gphys_status gphys_camera_get_viewport(const gphys_camera *camera, float *out_width, float *out_height);
gphys_status gphys_camera_get_viewport_origin(const gphys_camera *camera, float *out_x, float *out_y);
gphys_status gphys_camera_get_aspect(const gphys_camera *camera, float *out_aspect, int32_t *out_is_fixed);
gphys_status gphys_camera_get_image_size(const gphys_camera *camera, float *out_width, float *out_height);
gphys_status gphys_camera_get_pick_start(const gphys_camera *camera, gphys_pick_start *out_start);
gphys_status gphys_camera_get_conventions(const gphys_camera *camera, gphys_handedness *out_handedness, gphys_depth_range *out_depth_range, int32_t *out_reverse_z);
gphys_status gphys_camera_set_transform(gphys_camera *camera, const gphys_vec3 *position, const gphys_quat *rotation);
gphys_status gphys_camera_set_world_matrix(gphys_camera *camera, const gphys_mat4 *world);
gphys_status gphys_camera_set_view_matrix(gphys_camera *camera, const gphys_mat4 *view);
gphys_status gphys_camera_look_at(gphys_camera *camera, const gphys_vec3 *eye, const gphys_vec3 *target, const gphys_vec3 *up);
gphys_status gphys_camera_get_transform(const gphys_camera *camera, gphys_vec3 *out_position, gphys_quat *out_rotation);
gphys_status gphys_camera_get_world_matrix(const gphys_camera *camera, gphys_mat4 *out_world);
gphys_status gphys_camera_get_view_matrix(const gphys_camera *camera, gphys_mat4 *out_view);
gphys_status gphys_camera_get_projection_matrix(const gphys_camera *camera, gphys_mat4 *out_projection);
gphys_status gphys_camera_get_view_projection_matrix(const gphys_camera *camera, gphys_mat4 *out_view_projection);
gphys_status gphys_orbit_init(gphys_orbit *orbit);
gphys_status gphys_camera_set_orbit(gphys_camera *camera, const gphys_orbit *orbit);
gphys_status gphys_camera_get_orbit(const gphys_camera *camera, gphys_orbit *out_orbit);
gphys_status gphys_camera_set_orbit_speeds(gphys_camera *camera, const gphys_orbit_speeds *speeds);
gphys_status gphys_camera_get_orbit_speeds(const gphys_camera *camera, gphys_orbit_speeds *out_speeds);
gphys_status gphys_camera_orbit_rotate(gphys_camera *camera, float units_x, float units_y);
gphys_status gphys_camera_orbit_zoom(gphys_camera *camera, float units);
gphys_status gphys_camera_orbit_pan(gphys_camera *camera, float units_right, float units_up);
gphys_status gphys_camera_orbit_update(gphys_camera *camera);
gphys_status gphys_camera_get_frustum(const gphys_camera *camera, gphys_frustum *out_frustum);
gphys_status gphys_camera_get_corners(const gphys_camera *camera, gphys_vec3 *out_corners);
gphys_status gphys_camera_get_rectangle_frustum(const gphys_camera *camera, float x0, float y0, float x1, float y1, gphys_frustum *out_frustum);
gphys_status gphys_camera_get_rectangle_corners(const gphys_camera *camera, float x0, float y0, float x1, float y1, gphys_vec3 *out_corners);
gphys_status gphys_camera_project(const gphys_camera *camera, const gphys_vec3 *point, gphys_vec3 *out_pixel);
gphys_status gphys_camera_project_batch(const gphys_camera *camera, const gphys_vec3 *points, uint32_t point_stride, uint32_t count, gphys_vec3 *out_pixels, uint32_t out_stride);
gphys_status gphys_camera_unproject(const gphys_camera *camera, const gphys_vec3 *pixel, gphys_vec3 *out_point);
gphys_status gphys_camera_unproject_batch(const gphys_camera *camera, const gphys_vec3 *pixels, uint32_t pixel_stride, uint32_t count, gphys_vec3 *out_points, uint32_t out_stride);
gphys_status gphys_camera_pick_ray(const gphys_camera *camera, float pixel_x, float pixel_y, gphys_ray *out_ray);
gphys_status gphys_camera_pick_rays(const gphys_camera *camera, uint32_t x, uint32_t y, uint32_t width, uint32_t height, gphys_ray *out_rays, uint32_t out_stride);
gphys_status gphys_camera_pick(const gphys_camera *camera, const gphys_scene *scene, float pixel_x, float pixel_y, uint32_t layers, gphys_hit *out_hit);
gphys_status gphys_camera_pick_batch(const gphys_camera *camera, const gphys_scene *scene, const float *pixels, uint32_t pixel_stride, uint32_t count, uint32_t layers, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_camera_pick_rectangle(const gphys_camera *camera, const gphys_scene *scene, float x0, float y0, float x1, float y1, uint32_t layers, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_camera_cull(const gphys_camera *camera, const gphys_scene *scene, uint32_t layers, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_camera_pick_filtered(const gphys_camera *camera, const gphys_scene *scene, float pixel_x, float pixel_y, const gphys_query_filter_desc *filter, gphys_hit *out_hit);
gphys_status gphys_camera_pick_filtered_batch(const gphys_camera *camera, const gphys_scene *scene, const float *pixels, uint32_t pixel_stride, uint32_t count, const gphys_query_filter_desc *filters, uint32_t filter_stride, gphys_hit *out_hits, uint32_t out_stride);
gphys_status gphys_camera_pick_rectangle_filtered(const gphys_camera *camera, const gphys_scene *scene, float x0, float y0, float x1, float y1, const gphys_query_filter_desc *filter, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_camera_cull_filtered(const gphys_camera *camera, const gphys_scene *scene, const gphys_query_filter_desc *filter, gphys_model_id *out_models, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_desc_init(gphys_solver_desc *desc, uint32_t size);
gphys_status gphys_solver_create(const gphys_solver_desc *desc, gphys_solver **out_solver);
void gphys_solver_destroy(gphys_solver *solver);
gphys_status gphys_solver_set_worker_count(gphys_solver *solver, uint32_t workers);
gphys_status gphys_solver_get_worker_count(const gphys_solver *solver, uint32_t *out_workers);
gphys_status gphys_solver_set_origin(gphys_solver *solver, const double *origin);
gphys_status gphys_solver_get_origin(const gphys_solver *solver, double *out_origin);
gphys_status gphys_solver_set_gravity(gphys_solver *solver, const gphys_vec3 *gravity);
gphys_status gphys_solver_set_substeps(gphys_solver *solver, uint32_t substeps);
gphys_status gphys_solver_get_settings(const gphys_solver *solver, gphys_solver_settings *out_settings);
gphys_status gphys_solver_set_settings(gphys_solver *solver, const gphys_solver_settings *settings);
gphys_status gphys_body_desc_init(gphys_body_desc *desc, uint32_t size);
gphys_status gphys_solver_add_particles(gphys_solver *solver, const gphys_body_desc *desc, const gphys_vec3 *positions, uint32_t position_stride, uint32_t count, gphys_body_id *out_body);
gphys_status gphys_solver_add_rope(gphys_solver *solver, const gphys_body_desc *desc, const gphys_vec3 *positions, uint32_t position_stride, uint32_t count, float link_length, gphys_body_id *out_body);
gphys_status gphys_solver_add_cloth(gphys_solver *solver, const gphys_body_desc *desc, const gphys_vec3 *corner, const gphys_vec3 *edge_u, const gphys_vec3 *edge_v, uint32_t columns, uint32_t rows, gphys_body_id *out_body);
gphys_status gphys_solver_add_cloth_mesh(gphys_solver *solver, const gphys_body_desc *desc, const gphys_mesh *mesh, const gphys_transform *transform, gphys_body_id *out_body);
gphys_status gphys_solver_remove_body(gphys_solver *solver, gphys_body_id body);
gphys_status gphys_solver_get_bodies(const gphys_solver *solver, gphys_body_id *out_bodies, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_get_sleeping(const gphys_solver *solver, gphys_body_id *out_bodies, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_wake(gphys_solver *solver, gphys_body_id body);
gphys_status gphys_solver_get_body_settings(const gphys_solver *solver, gphys_body_id body, gphys_body_settings *out_settings);
gphys_status gphys_solver_set_body_settings(gphys_solver *solver, gphys_body_id body, const gphys_body_settings *settings);
gphys_status gphys_solver_get_body_info(const gphys_solver *solver, gphys_body_id body, gphys_body_info *out_info);
gphys_status gphys_solver_get_triangles(const gphys_solver *solver, gphys_body_id body, uint32_t *out_indices, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_mesh_create_from_body(const gphys_mesh_desc *desc, gphys_solver *solver, gphys_body_id body, gphys_mesh **out_mesh);
gphys_status gphys_solver_get_nearest_particle(const gphys_solver *solver, gphys_body_id body, uint32_t triangle, const gphys_vec3 *point, uint32_t *out_particle);
gphys_status gphys_solver_get_positions(const gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, gphys_vec3 *out_positions, uint32_t out_stride);
gphys_status gphys_solver_set_positions(gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, const gphys_vec3 *positions, uint32_t stride);
gphys_status gphys_solver_get_velocities(const gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, gphys_vec3 *out_velocities, uint32_t out_stride);
gphys_status gphys_solver_set_velocities(gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, const gphys_vec3 *velocities, uint32_t stride);
gphys_status gphys_solver_get_masses(const gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, float *out_masses, uint32_t out_stride);
gphys_status gphys_solver_set_masses(gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, const float *masses, uint32_t stride);
gphys_status gphys_solver_get_radii(const gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, float *out_radii, uint32_t out_stride);
gphys_status gphys_solver_set_radii(gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, const float *radii, uint32_t stride);
gphys_status gphys_solver_get_friction_factors(const gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, float *out_factors, uint32_t out_stride);
gphys_status gphys_solver_set_friction_factors(gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, const float *factors, uint32_t stride);
gphys_status gphys_solver_get_forces(const gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, gphys_vec3 *out_forces, uint32_t out_stride);
gphys_status gphys_solver_set_forces(gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, const gphys_vec3 *forces, uint32_t stride);
gphys_status gphys_solver_get_pinned(const gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, int32_t *out_pinned, uint32_t out_stride);
gphys_status gphys_solver_set_pinned(gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, int32_t pinned);
gphys_status gphys_solver_set_wind(gphys_solver *solver, gphys_body_id body, const gphys_wind *wind);
gphys_status gphys_solver_get_wind(const gphys_solver *solver, gphys_body_id body, gphys_wind *out_wind);
gphys_status gphys_solver_set_air_velocities(gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, const gphys_vec3 *velocities, uint32_t stride);
gphys_status gphys_solver_get_air_velocities(const gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, gphys_vec3 *out_velocities, uint32_t out_stride);
gphys_status gphys_solver_set_animation_targets(gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, const gphys_animation_target *targets, uint32_t stride);
gphys_status gphys_solver_get_animation_targets(const gphys_solver *solver, gphys_body_id body, uint32_t first, uint32_t count, gphys_animation_target *out_targets, uint32_t out_stride);
gphys_status gphys_solver_attach(gphys_solver *solver, const gphys_scene *scene, gphys_body_id body, uint32_t particle, gphys_model_id model, const gphys_vec3 *local_point);
gphys_status gphys_solver_detach(gphys_solver *solver, gphys_body_id body, uint32_t particle);
gphys_status gphys_solver_get_attachments(const gphys_solver *solver, gphys_body_id body, gphys_attachment *out_attachments, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_add_distance(gphys_solver *solver, gphys_body_id body, uint32_t particle_a, uint32_t particle_b, float rest_length, float compliance, gphys_constraint_id *out_constraint);
gphys_status gphys_solver_add_max_distance(gphys_solver *solver, gphys_body_id body, uint32_t particle_a, uint32_t particle_b, float max_length, float compliance, gphys_constraint_id *out_constraint);
gphys_status gphys_solver_set_constraint_damping(gphys_solver *solver, gphys_body_id body, gphys_constraint_id constraint, float damping);
gphys_status gphys_solver_set_volume(gphys_solver *solver, gphys_body_id body, float rest_volume, float compliance);
gphys_status gphys_solver_get_volume(const gphys_solver *solver, gphys_body_id body, float *out_volume, float *out_pressure);
gphys_status gphys_solver_get_volume_settings(const gphys_solver *solver, gphys_body_id body, float *out_rest_volume, float *out_compliance);
gphys_status gphys_solver_remove_constraint(gphys_solver *solver, gphys_body_id body, gphys_constraint_id constraint);
gphys_status gphys_solver_get_constraints(const gphys_solver *solver, gphys_body_id body, gphys_constraint_info *out_constraints, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_get_constraint_kinds(const gphys_solver *solver, gphys_body_id body, const gphys_constraint_id *constraints, uint32_t count, gphys_constraint_kind *out_kinds, uint32_t out_stride);
gphys_status gphys_solver_get_constraint_settings(const gphys_solver *solver, gphys_body_id body, const gphys_constraint_id *constraints, uint32_t count, gphys_constraint_settings *out_settings, uint32_t out_stride);
gphys_status gphys_solver_set_constraint_settings(gphys_solver *solver, gphys_body_id body, const gphys_constraint_id *constraints, const gphys_constraint_settings *settings, uint32_t setting_stride, uint32_t count);
gphys_status gphys_solver_add_cluster(gphys_solver *solver, gphys_body_id body, const uint32_t *particles, uint32_t count, gphys_cluster_id *out_cluster);
gphys_status gphys_solver_remove_cluster(gphys_solver *solver, gphys_body_id body, gphys_cluster_id cluster);
gphys_status gphys_solver_get_clusters(const gphys_solver *solver, gphys_body_id body, gphys_cluster_id *out_clusters, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_get_cluster_particles(const gphys_solver *solver, gphys_body_id body, gphys_cluster_id cluster, uint32_t *out_particles, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_join(gphys_solver *solver, gphys_body_id body_a, uint32_t particle_a, gphys_body_id body_b, uint32_t particle_b, float rest_length, float compliance, gphys_joint_id *out_joint);
gphys_status gphys_solver_unjoin(gphys_solver *solver, gphys_joint_id joint);
gphys_status gphys_solver_get_joints(const gphys_solver *solver, gphys_body_id body, gphys_joint_info *out_joints, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_set_breaking_forces(gphys_solver *solver, gphys_body_id body, const gphys_constraint_id *constraints, const float *forces, uint32_t force_stride, uint32_t count);
gphys_status gphys_solver_get_breaking_forces(const gphys_solver *solver, gphys_body_id body, const gphys_constraint_id *constraints, uint32_t count, float *out_forces, uint32_t out_stride);
gphys_status gphys_solver_break_constraint(gphys_solver *solver, gphys_body_id body, gphys_constraint_id constraint, gphys_break *out_result);
gphys_status gphys_solver_get_breaks(const gphys_solver *solver, gphys_break *out_breaks, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_step(gphys_solver *solver, const gphys_scene *scene, float dt);
gphys_status gphys_solver_advance(gphys_solver *solver, const gphys_scene *scene, float frame_time, uint32_t *out_steps, float *out_leftover);
gphys_status gphys_solver_get_leftover(const gphys_solver *solver, float *out_leftover);
gphys_status gphys_solver_get_substeps(const gphys_solver *solver, gphys_body_id body, uint32_t *out_substeps);
gphys_status gphys_solver_get_stats(const gphys_solver *solver, gphys_body_id body, gphys_solver_stats *out_stats);
gphys_status gphys_solver_get_contacts(const gphys_solver *solver, gphys_contact *out_contacts, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_get_body_contacts(const gphys_solver *solver, gphys_body_contact *out_contacts, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_get_impulses(const gphys_solver *solver, gphys_impulse *out_impulses, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_get_snapshot(const gphys_solver *solver, uint32_t *out_words, uint32_t capacity, uint32_t *out_total);
gphys_status gphys_solver_restore(gphys_solver *solver, const uint32_t *words, uint32_t count);
gphys_status gphys_solver_get_hash(const gphys_solver *solver, uint32_t *out_hash);
]],
    constants = {
        OK = 0,
        NO_HIT = 1,
        INCOMPLETE = 2,
        UNBOUNDED = 3,
        ERROR_INVALID_ARGUMENT = -1,
        ERROR_INVALID_ID = -2,
        ERROR_STRUCT_SIZE = -3,
        ERROR_OUT_OF_MEMORY = -4,
        ERROR_CAPACITY = -5,
        ERROR_CYCLE = -6,
        ERROR_UNSUPPORTED = -7,
        ERROR_SINGULAR = -8,
        ERROR_INTERNAL = -100,
        FRUSTUM_NEAR = 0,
        FRUSTUM_FAR = 1,
        FRUSTUM_LEFT = 2,
        FRUSTUM_RIGHT = 3,
        FRUSTUM_BOTTOM = 4,
        FRUSTUM_TOP = 5,
        HIT_INSIDE = 1,
        HIT_BACK = 2,
        SHAPE_SPHERE = 1,
        SHAPE_CAPSULE = 2,
        SHAPE_AABB = 3,
        SHAPE_OBB = 4,
        SHAPE_PLANE = 5,
        SHAPE_TRIANGLE = 6,
        SHAPE_FRUSTUM = 7,
        SHAPE_MESH = 8,
        SHAPE_RAY = 16,
        SHAPE_SEGMENT = 17,
        SIDE_OUTSIDE = -1,
        SIDE_CROSSING = 0,
        SIDE_INSIDE = 1,
        DEPTH_ZERO_TO_ONE = 0,
        DEPTH_MINUS_ONE_TO_ONE = 1,
        MESH_SURFACE = 0,
        MESH_BODY_SURFACE = 1,
        MESH_BODY_LINKS = 2,
        MESH_HULL = 3,
        FILTER_SUBTREE = 1,
        FILTER_NO_BACK_FACES = 2,
        FILTER_NO_FRONT_FACES = 4,
        PROJECTION_PERSPECTIVE = 0,
        PROJECTION_ORTHOGRAPHIC = 1,
        PROJECTION_USER = 2,
        LEFT_HANDED = 0,
        RIGHT_HANDED = 1,
        PICK_FROM_NEAR_PLANE = 0,
        PICK_FROM_CENTRE = 1,
        CLOTH_SHEAR = 1,
        CLOTH_BEND = 2,
        BODY_PARTICLES = 1,
        BODY_ROPE = 2,
        BODY_CLOTH = 3,
        SOLVE_FREE = 0,
        SOLVE_DIRECT = 1,
        SOLVE_GRAPH = 2,
        CONSTRAINT_DISTANCE = 0,
        CONSTRAINT_MAX_DISTANCE = 1,
        VERSION_MAJOR = 1,
        VERSION_MINOR = 1,
        VERSION_PATCH = 0,
        MAX_COORDINATE = 1000000000000000.0,
        NO_TRIANGLE = 4294967295,
        NO_PARTICLE = 4294967295,
        ALL_LAYERS = 4294967295,
    },
    structs = {
        { name = "allocator", fields = { "allocate", "release", "user" }, numbers = {  } },
        { name = "task_runner", fields = { "run", "user" }, numbers = {  } },
        { name = "vec3", fields = { "x", "y", "z" }, numbers = {  }, built = true },
        { name = "quat", fields = { "x", "y", "z", "w" }, numbers = {  }, built = true },
        { name = "mat4", fields = { "m" }, numbers = {  } },
        { name = "transform", fields = { "position", "rotation", "scale" }, numbers = {  }, built = true },
        { name = "ray", fields = { "origin", "direction", "t_max" }, numbers = {  }, built = true },
        { name = "segment", fields = { "a", "b" }, numbers = {  }, built = true },
        { name = "sphere", fields = { "center", "radius" }, numbers = {  }, built = true },
        { name = "capsule", fields = { "a", "b", "radius" }, numbers = {  }, built = true },
        { name = "aabb", fields = { "min", "max" }, numbers = {  }, built = true },
        { name = "obb", fields = { "center", "half_extents", "rotation" }, numbers = {  }, built = true },
        { name = "plane", fields = { "normal", "distance" }, numbers = {  }, built = true },
        { name = "triangle", fields = { "a", "b", "c" }, numbers = {  }, built = true },
        { name = "frustum", fields = { "origin", "planes" }, numbers = {  } },
        { name = "hit", fields = { "model", "tag", "t", "point", "normal", "triangle", "u", "v", "flags" }, numbers = { model = "whole", tag = "whole", triangle = "whole", flags = "bits" } },
        { name = "nearest", fields = { "model", "tag", "point", "distance", "triangle" }, numbers = { model = "whole", tag = "whole", triangle = "whole" } },
        { name = "distance", fields = { "t", "model", "triangle" }, numbers = { model = "whole", triangle = "whole" } },
        { name = "penetration", fields = { "model", "tag", "point", "normal", "depth", "triangle" }, numbers = { model = "whole", tag = "whole", triangle = "whole" } },
        { name = "mesh_report", fields = { "triangle_count", "degenerate_count", "first_degenerate", "out_of_range_count", "first_out_of_range", "bad_vertex_count", "first_bad_vertex", "open_edge_count" }, numbers = { triangle_count = "whole", degenerate_count = "whole", first_degenerate = "whole", out_of_range_count = "whole", first_out_of_range = "whole", bad_vertex_count = "whole", first_bad_vertex = "whole", open_edge_count = "whole" } },
        { name = "mesh_desc", fields = { "struct_size", "allocator", "deformable", "reserved" }, numbers = { struct_size = "whole", deformable = "to_flag", reserved = "whole" } },
        { name = "mesh_info", fields = { "kind", "vertex_count", "triangle_count", "deformable", "follows_body" }, numbers = { kind = "to_flag", vertex_count = "whole", triangle_count = "whole", deformable = "to_flag", follows_body = "to_flag" } },
        { name = "octree_stats", fields = { "item_count", "unbounded_count", "node_count", "leaf_count", "depth", "rebuilds", "cost", "memory_bytes" }, numbers = { item_count = "whole", unbounded_count = "whole", node_count = "whole", leaf_count = "whole", depth = "whole", rebuilds = "whole", memory_bytes = "whole" } },
        { name = "octree_box", fields = { "bounds", "depth", "item_count" }, numbers = { depth = "whole", item_count = "whole" } },
        { name = "scene_desc", fields = { "struct_size", "allocator", "reserve_models", "task_runner", "worker_count", "reserved" }, numbers = { struct_size = "whole", reserve_models = "whole", worker_count = "whole", reserved = "whole" } },
        { name = "model_desc", fields = { "struct_size", "parent", "layers", "tag", "scale" }, numbers = { struct_size = "whole", parent = "whole", layers = "bits", tag = "whole" } },
        { name = "model_info", fields = { "type", "parent", "layers", "tag", "child_count" }, numbers = { type = "to_flag", parent = "whole", layers = "bits", tag = "whole", child_count = "whole" } },
        { name = "query_filter_desc", fields = { "struct_size", "layers", "ignored_model", "flags", "ignored_models", "ignored_count", "reserved" }, numbers = { struct_size = "whole", layers = "bits", ignored_model = "whole", flags = "bits", ignored_count = "whole", reserved = "whole" }, lists = { ignored_models = "ignored_count" } },
        { name = "camera_desc", fields = { "struct_size", "allocator", "handedness", "depth_range", "reverse_z", "viewport_width", "viewport_height", "reserved" }, numbers = { struct_size = "whole", handedness = "to_flag", depth_range = "to_flag", reverse_z = "to_flag", reserved = "whole" } },
        { name = "orbit", fields = { "target", "up", "distance", "yaw", "pitch", "radians_per_unit", "metres_per_unit", "min_distance", "max_distance", "min_pitch", "max_pitch" }, numbers = {  } },
        { name = "orbit_speeds", fields = { "rotate_x", "rotate_y", "zoom", "pan_x", "pan_y" }, numbers = {  } },
        { name = "solver_desc", fields = { "struct_size", "allocator", "gravity", "substeps", "fixed_step", "max_steps", "task_runner", "worker_count", "sleep_speed", "sleep_strain", "sleep_time", "max_strain", "tolerance", "max_substeps", "max_work" }, numbers = { struct_size = "whole", substeps = "whole", max_steps = "whole", worker_count = "whole", max_substeps = "whole", max_work = "whole" } },
        { name = "solver_settings", fields = { "gravity", "substeps", "fixed_step", "max_steps", "sleep_speed", "sleep_strain", "sleep_time", "max_strain", "tolerance", "max_substeps", "max_work" }, numbers = { substeps = "whole", max_steps = "whole", max_substeps = "whole", max_work = "whole" } },
        { name = "body_desc", fields = { "struct_size", "mass", "radius", "damping", "friction", "restitution", "compliance", "bend_compliance", "cloth_flags", "layers", "static_friction", "self_collision", "body_layers", "shear_compliance", "breaking_force", "bending_stiffness" }, numbers = { struct_size = "whole", cloth_flags = "bits", layers = "bits", self_collision = "whole", body_layers = "bits" } },
        { name = "body_settings", fields = { "damping", "friction", "static_friction", "restitution", "layers", "body_layers", "self_collision" }, numbers = { layers = "bits", body_layers = "bits", self_collision = "whole" } },
        { name = "body_info", fields = { "kind", "method", "particle_count", "constraint_count", "triangle_count" }, numbers = { kind = "to_flag", method = "to_flag", particle_count = "whole", constraint_count = "whole", triangle_count = "whole" } },
        { name = "wind", fields = { "velocity", "density", "drag", "lift" }, numbers = {  } },
        { name = "animation_target", fields = { "position", "normal", "max_distance", "backstop" }, numbers = {  } },
        { name = "attachment", fields = { "particle", "model", "local_point" }, numbers = { particle = "whole", model = "whole" } },
        { name = "constraint_info", fields = { "id", "particle_a", "particle_b", "rest_length", "compliance" }, numbers = { id = "whole", particle_a = "whole", particle_b = "whole" } },
        { name = "constraint_settings", fields = { "rest_length", "compliance", "damping" }, numbers = {  } },
        { name = "joint_info", fields = { "id", "body_a", "particle_a", "body_b", "particle_b", "rest_length", "compliance", "force" }, numbers = { id = "whole", body_a = "whole", particle_a = "whole", body_b = "whole", particle_b = "whole" } },
        { name = "break", fields = { "body", "constraint", "particle_a", "particle_b", "torn_particle", "new_particle", "load" }, numbers = { body = "whole", constraint = "whole", particle_a = "whole", particle_b = "whole", torn_particle = "whole", new_particle = "whole" } },
        { name = "solver_stats", fields = { "particle_count", "pinned_count", "constraint_count", "contact_count", "strain_max", "strain_rms", "kinetic_energy", "potential_energy" }, numbers = { particle_count = "whole", pinned_count = "whole", constraint_count = "whole", contact_count = "whole" } },
        { name = "contact", fields = { "body", "particle", "model", "tag", "point", "normal" }, numbers = { body = "whole", particle = "whole", model = "whole", tag = "whole" } },
        { name = "body_contact", fields = { "body_a", "particle_a", "body_b", "particle_b", "normal", "distance", "impulse" }, numbers = { body_a = "whole", particle_a = "whole", body_b = "whole", particle_b = "whole" } },
        { name = "impulse", fields = { "model", "tag", "linear", "angular" }, numbers = { model = "whole", tag = "whole" } },
    },
    shapes = {"sphere", "capsule", "aabb", "obb", "plane", "triangle", "frustum", "ray", "segment"},
    objects = {"mesh", "scene", "camera", "solver"},
}
