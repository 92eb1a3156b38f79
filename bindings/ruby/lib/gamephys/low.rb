# frozen_string_literal: true

# Generated from gamephys_api.json by bindings/generate.py. Not for editing.
module Gamephys
  module Low

    class MeshDesc < FFI::Struct
      layout :struct_size, :uint32, :allocator, :pointer, :deformable, :int32, :reserved, :uint32
    end

    class SceneDesc < FFI::Struct
      layout :struct_size, :uint32, :allocator, :pointer, :reserve_models, :uint32, :task_runner, :pointer, :worker_count, :uint32, :reserved, :uint32
    end

    class ModelDesc < FFI::Struct
      layout :struct_size, :uint32, :parent, :uint32, :layers, :uint32, :tag, :uint32, :scale, [:float, 3]
    end

    class QueryFilterDesc < FFI::Struct
      layout :struct_size, :uint32, :layers, :uint32, :ignored_model, :uint32, :flags, :uint32, :ignored_models, :pointer, :ignored_count, :uint32, :reserved, :uint32
      LISTS = { ignored_models: :ignored_count }.freeze
    end

    class CameraDesc < FFI::Struct
      layout :struct_size, :uint32, :allocator, :pointer, :handedness, :int32, :depth_range, :int32, :reverse_z, :int32, :viewport_width, :float, :viewport_height, :float, :reserved, :uint32
    end

    class SolverDesc < FFI::Struct
      layout :struct_size, :uint32, :allocator, :pointer, :gravity, [:float, 3], :substeps, :uint32, :fixed_step, :float, :max_steps, :uint32, :task_runner, :pointer, :worker_count, :uint32, :sleep_speed, :float, :sleep_strain, :float, :sleep_time, :float, :max_strain, :float, :tolerance, :float, :max_substeps, :uint32, :max_work, :uint32
    end

    class BodyDesc < FFI::Struct
      layout :struct_size, :uint32, :mass, :float, :radius, :float, :damping, :float, :friction, :float, :restitution, :float, :compliance, :float, :bend_compliance, :float, :cloth_flags, :uint32, :layers, :uint32, :static_friction, :float, :self_collision, :uint32, :body_layers, :uint32, :shear_compliance, :float, :breaking_force, :float, :bending_stiffness, :float
    end

    attach_function :gphys_version, [], :uint32
    attach_function :gphys_status_name, [:int32], :string
    attach_function :gphys_last_error, [], :string
    attach_function :gphys_shape_validate, [:int32, :pointer], :int32
    attach_function :gphys_shape_bounds, [:int32, :pointer, :pointer], :int32
    attach_function :gphys_shape_transform, [:int32, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_shape_contains, [:int32, :pointer, :pointer, :float, :pointer], :int32
    attach_function :gphys_shape_contains_batch, [:int32, :pointer, :pointer, :uint32, :uint32, :float, :pointer, :uint32], :int32
    attach_function :gphys_shape_closest_point, [:int32, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_shape_closest_point_batch, [:int32, :pointer, :pointer, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_segment_closest_points, [:pointer, :pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_shape_overlaps, [:int32, :pointer, :int32, :pointer, :pointer], :int32
    attach_function :gphys_shape_overlaps_batch, [:int32, :pointer, :uint32, :int32, :pointer, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_shape_classify_plane, [:int32, :pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_shape_classify_frustum, [:int32, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_shape_raycast, [:int32, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_shape_raycast_batch, [:int32, :pointer, :pointer, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_shape_segment_test, [:int32, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_shape_sweep_sphere, [:int32, :pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_shape_sweep, [:int32, :pointer, :int32, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_shape_sweep_batch, [:int32, :pointer, :uint32, :int32, :pointer, :uint32, :pointer, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_shape_penetration, [:int32, :pointer, :int32, :pointer, :pointer], :int32
    attach_function :gphys_shape_penetration_batch, [:int32, :pointer, :uint32, :int32, :pointer, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_frustum_corners, [:pointer, :pointer], :int32
    attach_function :gphys_planes_intersection, [:pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_planes_intersection_batch, [:pointer, :uint32, :pointer, :uint32, :pointer, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_mat4_orthonormality, [:pointer, :pointer], :int32
    attach_function :gphys_frustum_from_matrix, [:pointer, :int32, :int32, :pointer], :int32
    attach_function :gphys_mesh_check, [:pointer, :uint32, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_mesh_desc_init, [:pointer, :uint32], :int32
    attach_function :gphys_mesh_create, [:pointer, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_mesh_create_hull, [:pointer, :pointer, :uint32, :uint32, :pointer], :int32
    attach_function :gphys_mesh_get_hull_planes, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_mesh_get_hull_faces, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_mesh_set_vertices, [:pointer, :pointer, :uint32, :uint32], :int32
    attach_function :gphys_mesh_destroy, [:pointer], :void
    attach_function :gphys_mesh_get_info, [:pointer, :pointer], :int32
    attach_function :gphys_mesh_get_report, [:pointer, :pointer], :int32
    attach_function :gphys_mesh_get_vertices, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_mesh_get_indices, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_mesh_get_snapshot, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_mesh_create_from_snapshot, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_mesh_raycast_all, [:pointer, :pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_mesh_raycast_any, [:pointer, :pointer, :pointer], :int32
    attach_function :gphys_mesh_raycast_any_batch, [:pointer, :pointer, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_mesh_raycast_distance_batch, [:pointer, :pointer, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_mesh_overlap, [:pointer, :int32, :pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_mesh_get_octree_stats, [:pointer, :pointer], :int32
    attach_function :gphys_mesh_get_octree_boxes, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_desc_init, [:pointer, :uint32], :int32
    attach_function :gphys_scene_create, [:pointer, :pointer], :int32
    attach_function :gphys_scene_destroy, [:pointer], :void
    attach_function :gphys_scene_set_worker_count, [:pointer, :uint32], :int32
    attach_function :gphys_scene_get_worker_count, [:pointer, :pointer], :int32
    attach_function :gphys_scene_set_origin, [:pointer, :pointer], :int32
    attach_function :gphys_scene_get_origin, [:pointer, :pointer], :int32
    attach_function :gphys_model_desc_init, [:pointer, :uint32], :int32
    attach_function :gphys_scene_add, [:pointer, :int32, :pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_scene_add_batch, [:pointer, :int32, :pointer, :uint32, :pointer, :uint32, :uint32, :pointer, :pointer], :int32
    attach_function :gphys_scene_add_described_batch, [:pointer, :int32, :pointer, :uint32, :pointer, :uint32, :pointer, :uint32, :uint32, :pointer], :int32
    attach_function :gphys_scene_remove, [:pointer, :uint32], :int32
    attach_function :gphys_scene_remove_batch, [:pointer, :pointer, :uint32], :int32
    attach_function :gphys_scene_remove_subtree, [:pointer, :uint32], :int32
    attach_function :gphys_scene_clear, [:pointer], :int32
    attach_function :gphys_scene_has, [:pointer, :uint32], :int32
    attach_function :gphys_scene_get_models, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_get_roots, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_get_children, [:pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_get_info, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_get_shape, [:pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_get_mesh, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_get_bounds, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_get_scene_bounds, [:pointer, :pointer], :int32
    attach_function :gphys_scene_set_shape, [:pointer, :uint32, :int32, :pointer], :int32
    attach_function :gphys_scene_set_scale, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_get_scale, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_set_layers, [:pointer, :uint32, :uint32], :int32
    attach_function :gphys_scene_set_tag, [:pointer, :uint32, :uint32], :int32
    attach_function :gphys_scene_set_parent, [:pointer, :uint32, :uint32, :int32], :int32
    attach_function :gphys_scene_set_transform, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_set_transforms, [:pointer, :pointer, :pointer, :uint32, :uint32], :int32
    attach_function :gphys_scene_get_transforms, [:pointer, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_get_world_transforms, [:pointer, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_raycast, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_raycast_batch, [:pointer, :pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_raycast_distance_batch, [:pointer, :pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_raycast_any, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_raycast_any_batch, [:pointer, :pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_raycast_all, [:pointer, :pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_raycast_all_batch, [:pointer, :pointer, :uint32, :uint32, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_segment_test, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_segment_test_batch, [:pointer, :pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_overlap, [:pointer, :int32, :pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_overlap_batch, [:pointer, :int32, :pointer, :uint32, :uint32, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_cull, [:pointer, :pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_cull_batch, [:pointer, :pointer, :uint32, :uint32, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_nearest, [:pointer, :pointer, :float, :uint32, :pointer], :int32
    attach_function :gphys_scene_nearest_batch, [:pointer, :pointer, :uint32, :uint32, :float, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_sweep_sphere, [:pointer, :pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_sweep_sphere_batch, [:pointer, :pointer, :uint32, :pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_sweep, [:pointer, :int32, :pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_sweep_batch, [:pointer, :int32, :pointer, :uint32, :pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_penetration, [:pointer, :int32, :pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_penetration_batch, [:pointer, :int32, :pointer, :uint32, :uint32, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_query_filter_desc_init, [:pointer, :uint32], :int32
    attach_function :gphys_scene_raycast_filtered, [:pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_scene_raycast_filtered_batch, [:pointer, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_raycast_distance_filtered_batch, [:pointer, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_raycast_any_filtered, [:pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_scene_raycast_any_filtered_batch, [:pointer, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_raycast_all_filtered, [:pointer, :pointer, :pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_raycast_all_filtered_batch, [:pointer, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_segment_test_filtered, [:pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_scene_segment_test_filtered_batch, [:pointer, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_overlap_filtered, [:pointer, :int32, :pointer, :pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_overlap_filtered_batch, [:pointer, :int32, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_cull_filtered, [:pointer, :pointer, :pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_cull_filtered_batch, [:pointer, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_nearest_filtered, [:pointer, :pointer, :float, :pointer, :pointer], :int32
    attach_function :gphys_scene_nearest_filtered_batch, [:pointer, :pointer, :uint32, :uint32, :float, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_sweep_sphere_filtered, [:pointer, :pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_scene_sweep_sphere_filtered_batch, [:pointer, :pointer, :uint32, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_sweep_filtered, [:pointer, :int32, :pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_scene_sweep_filtered_batch, [:pointer, :int32, :pointer, :uint32, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_scene_penetration_filtered, [:pointer, :int32, :pointer, :pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_penetration_filtered_batch, [:pointer, :int32, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_rebuild_octree, [:pointer], :int32
    attach_function :gphys_scene_maintain_octree, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_get_octree_stats, [:pointer, :pointer], :int32
    attach_function :gphys_scene_get_octree_boxes, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_validate, [:pointer], :int32
    attach_function :gphys_scene_get_snapshot, [:pointer, :int32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_scene_restore, [:pointer, :pointer, :pointer, :uint32], :int32
    attach_function :gphys_scene_get_hash, [:pointer, :pointer], :int32
    attach_function :gphys_camera_desc_init, [:pointer, :uint32], :int32
    attach_function :gphys_camera_create, [:pointer, :pointer], :int32
    attach_function :gphys_camera_destroy, [:pointer], :void
    attach_function :gphys_camera_set_origin, [:pointer, :pointer], :int32
    attach_function :gphys_camera_get_origin, [:pointer, :pointer], :int32
    attach_function :gphys_camera_set_perspective, [:pointer, :float, :float, :float], :int32
    attach_function :gphys_camera_set_orthographic, [:pointer, :float, :float, :float], :int32
    attach_function :gphys_camera_set_projection, [:pointer, :pointer], :int32
    attach_function :gphys_camera_set_perspective_aspect, [:pointer, :float, :float, :float, :float], :int32
    attach_function :gphys_camera_set_orthographic_size, [:pointer, :float, :float, :float, :float], :int32
    attach_function :gphys_camera_set_viewport, [:pointer, :float, :float], :int32
    attach_function :gphys_camera_set_viewport_origin, [:pointer, :float, :float], :int32
    attach_function :gphys_camera_set_pick_start, [:pointer, :int32], :int32
    attach_function :gphys_camera_get_projection, [:pointer, :pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_camera_get_viewport, [:pointer, :pointer, :pointer], :int32
    attach_function :gphys_camera_get_viewport_origin, [:pointer, :pointer, :pointer], :int32
    attach_function :gphys_camera_get_aspect, [:pointer, :pointer, :pointer], :int32
    attach_function :gphys_camera_get_image_size, [:pointer, :pointer, :pointer], :int32
    attach_function :gphys_camera_get_pick_start, [:pointer, :pointer], :int32
    attach_function :gphys_camera_get_conventions, [:pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_camera_set_transform, [:pointer, :pointer, :pointer], :int32
    attach_function :gphys_camera_set_world_matrix, [:pointer, :pointer], :int32
    attach_function :gphys_camera_set_view_matrix, [:pointer, :pointer], :int32
    attach_function :gphys_camera_look_at, [:pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_camera_get_transform, [:pointer, :pointer, :pointer], :int32
    attach_function :gphys_camera_get_world_matrix, [:pointer, :pointer], :int32
    attach_function :gphys_camera_get_view_matrix, [:pointer, :pointer], :int32
    attach_function :gphys_camera_get_projection_matrix, [:pointer, :pointer], :int32
    attach_function :gphys_camera_get_view_projection_matrix, [:pointer, :pointer], :int32
    attach_function :gphys_orbit_init, [:pointer], :int32
    attach_function :gphys_camera_set_orbit, [:pointer, :pointer], :int32
    attach_function :gphys_camera_get_orbit, [:pointer, :pointer], :int32
    attach_function :gphys_camera_set_orbit_speeds, [:pointer, :pointer], :int32
    attach_function :gphys_camera_get_orbit_speeds, [:pointer, :pointer], :int32
    attach_function :gphys_camera_orbit_rotate, [:pointer, :float, :float], :int32
    attach_function :gphys_camera_orbit_zoom, [:pointer, :float], :int32
    attach_function :gphys_camera_orbit_pan, [:pointer, :float, :float], :int32
    attach_function :gphys_camera_orbit_update, [:pointer], :int32
    attach_function :gphys_camera_get_frustum, [:pointer, :pointer], :int32
    attach_function :gphys_camera_get_corners, [:pointer, :pointer], :int32
    attach_function :gphys_camera_get_rectangle_frustum, [:pointer, :float, :float, :float, :float, :pointer], :int32
    attach_function :gphys_camera_get_rectangle_corners, [:pointer, :float, :float, :float, :float, :pointer], :int32
    attach_function :gphys_camera_project, [:pointer, :pointer, :pointer], :int32
    attach_function :gphys_camera_project_batch, [:pointer, :pointer, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_camera_unproject, [:pointer, :pointer, :pointer], :int32
    attach_function :gphys_camera_unproject_batch, [:pointer, :pointer, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_camera_pick_ray, [:pointer, :float, :float, :pointer], :int32
    attach_function :gphys_camera_pick_rays, [:pointer, :uint32, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_camera_pick, [:pointer, :pointer, :float, :float, :uint32, :pointer], :int32
    attach_function :gphys_camera_pick_batch, [:pointer, :pointer, :pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_camera_pick_rectangle, [:pointer, :pointer, :float, :float, :float, :float, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_camera_cull, [:pointer, :pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_camera_pick_filtered, [:pointer, :pointer, :float, :float, :pointer, :pointer], :int32
    attach_function :gphys_camera_pick_filtered_batch, [:pointer, :pointer, :pointer, :uint32, :uint32, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_camera_pick_rectangle_filtered, [:pointer, :pointer, :float, :float, :float, :float, :pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_camera_cull_filtered, [:pointer, :pointer, :pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_desc_init, [:pointer, :uint32], :int32
    attach_function :gphys_solver_create, [:pointer, :pointer], :int32
    attach_function :gphys_solver_destroy, [:pointer], :void
    attach_function :gphys_solver_set_worker_count, [:pointer, :uint32], :int32
    attach_function :gphys_solver_get_worker_count, [:pointer, :pointer], :int32
    attach_function :gphys_solver_set_origin, [:pointer, :pointer], :int32
    attach_function :gphys_solver_get_origin, [:pointer, :pointer], :int32
    attach_function :gphys_solver_set_gravity, [:pointer, :pointer], :int32
    attach_function :gphys_solver_set_substeps, [:pointer, :uint32], :int32
    attach_function :gphys_solver_get_settings, [:pointer, :pointer], :int32
    attach_function :gphys_solver_set_settings, [:pointer, :pointer], :int32
    attach_function :gphys_body_desc_init, [:pointer, :uint32], :int32
    attach_function :gphys_solver_add_particles, [:pointer, :pointer, :pointer, :uint32, :uint32, :pointer], :int32
    attach_function :gphys_solver_add_rope, [:pointer, :pointer, :pointer, :uint32, :uint32, :float, :pointer], :int32
    attach_function :gphys_solver_add_cloth, [:pointer, :pointer, :pointer, :pointer, :pointer, :uint32, :uint32, :pointer], :int32
    attach_function :gphys_solver_add_cloth_mesh, [:pointer, :pointer, :pointer, :pointer, :pointer], :int32
    attach_function :gphys_solver_remove_body, [:pointer, :uint32], :int32
    attach_function :gphys_solver_get_bodies, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_sleeping, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_wake, [:pointer, :uint32], :int32
    attach_function :gphys_solver_get_body_settings, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_set_body_settings, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_body_info, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_triangles, [:pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_mesh_create_from_body, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_nearest_particle, [:pointer, :uint32, :uint32, :pointer, :pointer], :int32
    attach_function :gphys_solver_get_positions, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_set_positions, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_get_velocities, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_set_velocities, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_get_masses, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_set_masses, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_get_radii, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_set_radii, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_get_friction_factors, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_set_friction_factors, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_get_forces, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_set_forces, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_get_pinned, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_set_pinned, [:pointer, :uint32, :uint32, :uint32, :int32], :int32
    attach_function :gphys_solver_set_wind, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_wind, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_set_air_velocities, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_get_air_velocities, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_set_animation_targets, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_get_animation_targets, [:pointer, :uint32, :uint32, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_attach, [:pointer, :pointer, :uint32, :uint32, :uint32, :pointer], :int32
    attach_function :gphys_solver_detach, [:pointer, :uint32, :uint32], :int32
    attach_function :gphys_solver_get_attachments, [:pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_add_distance, [:pointer, :uint32, :uint32, :uint32, :float, :float, :pointer], :int32
    attach_function :gphys_solver_add_max_distance, [:pointer, :uint32, :uint32, :uint32, :float, :float, :pointer], :int32
    attach_function :gphys_solver_set_constraint_damping, [:pointer, :uint32, :uint32, :float], :int32
    attach_function :gphys_solver_set_volume, [:pointer, :uint32, :float, :float], :int32
    attach_function :gphys_solver_get_volume, [:pointer, :uint32, :pointer, :pointer], :int32
    attach_function :gphys_solver_get_volume_settings, [:pointer, :uint32, :pointer, :pointer], :int32
    attach_function :gphys_solver_remove_constraint, [:pointer, :uint32, :uint32], :int32
    attach_function :gphys_solver_get_constraints, [:pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_constraint_kinds, [:pointer, :uint32, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_get_constraint_settings, [:pointer, :uint32, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_set_constraint_settings, [:pointer, :uint32, :pointer, :pointer, :uint32, :uint32], :int32
    attach_function :gphys_solver_add_cluster, [:pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_remove_cluster, [:pointer, :uint32, :uint32], :int32
    attach_function :gphys_solver_get_clusters, [:pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_cluster_particles, [:pointer, :uint32, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_join, [:pointer, :uint32, :uint32, :uint32, :uint32, :float, :float, :pointer], :int32
    attach_function :gphys_solver_unjoin, [:pointer, :uint32], :int32
    attach_function :gphys_solver_get_joints, [:pointer, :uint32, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_set_breaking_forces, [:pointer, :uint32, :pointer, :pointer, :uint32, :uint32], :int32
    attach_function :gphys_solver_get_breaking_forces, [:pointer, :uint32, :pointer, :uint32, :pointer, :uint32], :int32
    attach_function :gphys_solver_break_constraint, [:pointer, :uint32, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_breaks, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_step, [:pointer, :pointer, :float], :int32
    attach_function :gphys_solver_advance, [:pointer, :pointer, :float, :pointer, :pointer], :int32
    attach_function :gphys_solver_get_leftover, [:pointer, :pointer], :int32
    attach_function :gphys_solver_get_substeps, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_stats, [:pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_contacts, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_body_contacts, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_impulses, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_get_snapshot, [:pointer, :pointer, :uint32, :pointer], :int32
    attach_function :gphys_solver_restore, [:pointer, :pointer, :uint32], :int32
    attach_function :gphys_solver_get_hash, [:pointer, :pointer], :int32
  end
end
