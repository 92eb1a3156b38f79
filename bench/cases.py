"""The cases of the benchmarks in plain words: what a table or a figure says instead of a name in the code."""

# Sets of objects: the first part of the names of cases with rays.
OBJECTS = {
    "scene": "boxes", "sphere": "spheres", "instance": "copies of a mesh", "mesh_model": "a mesh, the model of a scene",
    "mesh": "a mesh", "hull": "convex hulls", "forest": "stretched copies of a tree", "flattened": "a flattened mesh",
}
# Rays: the rest of those names.
RAYS = {
    "ray_random": "random rays at {}", "ray_camera": "rays of a camera in tiles of 8 x 8 at {}", "ray_rows": "rays of a camera row by row at {}",
    "ray_any": "whether random rays hit {}", "ray_single": "random rays at {}, one call each",
    "single_random": "random rays at {}, one call each", "single_miss": "rays away from {}, one call each",
    "single_rows": "rays of a camera row by row at {}, one call each", "single_any": "whether random rays hit {}, one call each",
    "distance_random": "distances along random rays at {}", "distance_camera": "distances along rays of a camera at {}",
}
# Scenes that changed by single calls.
CHANGES = {
    "adds_random": "boxes added at random", "adds_sorted": "boxes added from left to right", "adds_line": "boxes added in a line",
    "adds_rows": "boxes added row by row", "adds_one_place": "boxes added at one place", "churn": "boxes removed and added",
    "moves": "small moves", "jumps": "jumps", "drift": "steady motion, a call for each move",
}
# Single calls whose latency is measured.
CALLS = {
    "latency_ray": "a ray at boxes", "latency_overlap": "which boxes a sphere overlaps", "latency_move": "moving a box",
    "latency_cull": "culling all boxes", "churn_remove": "removing a box", "churn_add": "adding a box again",
    "add_random": "adding boxes at random", "add_sorted": "adding boxes from left to right", "add_line": "adding boxes to a line",
    "add_rows": "adding boxes row by row", "add_one_place": "adding boxes at one place",
}
OTHERS = {
    "build_scene": "building a scene of boxes, per box", "memory_scene": "memory of a scene of boxes, per box",
    "memory_peak_scene": "most memory during the build, per box",
    "build_mesh": "building a mesh, per triangle", "memory_mesh": "memory of a mesh, per triangle",
    "memory_peak_mesh": "most memory during the build, per triangle",
    "save_mesh": "saving a mesh, per triangle", "save_mesh_bytes": "the same, per byte", "load_mesh": "loading a mesh, per triangle",
    "build_skin": "building a mesh that bends, per triangle", "refit_skin": "giving it new vertices, per triangle",
    "ray_at_moved_skin": "random rays at it after 1000 changes",
    "build_cloth": "building a waving sheet, per triangle", "refit_cloth": "giving it new vertices, per triangle",
    "ray_at_moved_cloth": "random rays at it after 1000 changes",
    "ray_at_simulated_cloth": "random rays at simulated cloth", "single_at_simulated_cloth": "the same, one call each",
    "overlap_sphere": "which boxes a sphere overlaps", "overlap_box": "which boxes a box overlaps",
    "nearest_box": "the nearest box to a point", "nearest_box_single": "the same, one call each",
    "nearest_point": "the nearest point to a point", "nearest_point_single": "the same, one call each",
    "mesh_nearest_scan": "the nearest point of a mesh, near its surface", "mesh_nearest_scan_single": "the same, one call each",
    "mesh_nearest_random": "the nearest point of a mesh, anywhere", "mesh_nearest_random_single": "the same, one call each",
    "segment": "a segment at boxes",
    "sweep_sphere": "a sphere swept at boxes", "sweep_capsule": "a capsule swept at boxes", "sweep_box": "a box swept at boxes",
    "cull": "culling boxes, per box", "hull_contains": "which hulls contain a point", "hull_overlap": "which hulls a sphere overlaps",
    "hull_sweep_capsule": "a capsule swept at convex hulls", "hull_sweep_box": "a box swept at convex hulls",
    "ray_without_one": "random rays that leave out a model", "single_without_one": "the same, one call each",
    "update_all": "moving all boxes, per box", "ray_after_update": "random rays at boxes after 100 frames of motion",
    "update_some": "moving some of the boxes, per box", "replace_some": "replacing some of the boxes, per box",
    "save_scene": "saving a scene, per box", "save_scene_bytes": "the same, per byte", "load_scene": "loading a scene, per box",
}

SOLVER = {
    "chain_30": "swinging chain of 30 links", "rope_1e3": "rope of 1000 links, weight of 1000 links",
    "rope_1e6": "rope of 1000 links, weight of 1,000,000 links", "ropes_1000x30": "1000 ropes of 30 links",
    "cloth_100": "cloth of 100 x 100 on two corners", "cloth_100_bend": "cloth of 100 x 100, stiff against bending",
    "ropes_threads": "1000 ropes of 30 links", "cloth_300_threads": "cloth of 300 x 300 on two corners",
    "free_1M_flying": "1,000,000 particles in the air", "free_1M_landing": "1,000,000 particles landing on boxes",
    "free_1M_lying": "1,000,000 particles at rest on boxes", "free_1M_steady": "1,000,000 particles at rest, steps of equal length",
    "free_1M_all": "1,000,000 particles, mean of three seconds",
    "free_100k_flying": "100,000 particles in the air", "free_100k_landing": "100,000 particles landing on boxes",
    "free_100k_lying": "100,000 particles at rest on boxes", "free_100k_steady": "100,000 particles at rest, steps of equal length",
    "free_100k_all": "100,000 particles, mean of three seconds",
    "ball_pit": "2000 balls poured into a pit", "rope_over_post": "a rope over a post, 1 kg against 3 kg",
    "drape_over_mesh": "cloth over a mesh", "drape_within_2_percent_mean": "cloth over a mesh within 2 % strain, mean frame",
    "drape_within_2_percent_longest": "cloth over a mesh within 2 % strain, longest frame",
}

HARD = {
    "boxes_random": "Random rays, many boxes", "boxes_camera": "Rays of a camera, many boxes", "mesh_random": "Random rays around a mesh",
    "mesh_camera": "Rays of a camera at a mesh", "leaks_near": "Rays out of a closed mesh",
    "leaks_far": "Out of a mesh 370 km from the origin", "leaks_slivers": "Out of a mesh of slivers, 1e6 : 1",
    "ray_box_edges": "Rays at faces, edges and corners", "ray_sphere_tangent": "Tangents of a sphere from 1000 km",
    "sphere_touches_box": "Spheres that touch a corner",
}


def words(case):
    """What a case measures; a case without an entry above keeps its name."""
    if case in OTHERS:
        return OTHERS[case]
    for objects, what in OBJECTS.items():
        rays = case[len(objects) + 1:] if case.startswith(objects + "_") else ""
        if rays in RAYS:
            return RAYS[rays].format(what)
    for prefix, what in (("after_", "random rays after {}"), ("memory_after_", "memory per box after {}"),
                         ("memory_peak_after_", "most memory per box, {}")):
        if case.startswith(prefix) and case[len(prefix):] in CHANGES:
            return what.format(CHANGES[case[len(prefix):]])
    return f"`{case}`"
