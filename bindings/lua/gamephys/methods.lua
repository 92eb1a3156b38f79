-- Generated from gamephys_api.json by bindings/generate.py. Not for editing.
return function(gp, runtime)
local C, ALL_LAYERS = runtime.C, gp.ALL_LAYERS
local opened, kind, address, to_value = runtime.opened, runtime.kind, runtime.address, runtime.to_value
local to_numbers, to_desc, to_descs, to_flag = runtime.to_numbers, runtime.to_desc, runtime.to_descs, runtime.to_flag
local to_array, to_shapes, common, results = runtime.to_array, runtime.to_shapes, runtime.common, runtime.results
local whole, bits, signed, real = runtime.whole, runtime.bits, runtime.signed, runtime.real
local list, ragged, check, found, answered = runtime.list, runtime.ragged, runtime.check, runtime.found, runtime.answered
local float = runtime.element 'float'
local double = runtime.element 'double'
local int32_t = runtime.element 'int32_t'
local uint32_t = runtime.element 'uint32_t'
local Vec3 = runtime.element 'gphys_vec3'
local Quat = runtime.element 'gphys_quat'
local Mat4 = runtime.element 'gphys_mat4'
local Transform = runtime.element 'gphys_transform'
local Ray = runtime.element 'gphys_ray'
local Segment = runtime.element 'gphys_segment'
local Sphere = runtime.element 'gphys_sphere'
local Capsule = runtime.element 'gphys_capsule'
local Aabb = runtime.element 'gphys_aabb'
local Obb = runtime.element 'gphys_obb'
local Plane = runtime.element 'gphys_plane'
local Triangle = runtime.element 'gphys_triangle'
local Frustum = runtime.element 'gphys_frustum'
local Hit = runtime.element 'gphys_hit'
local Nearest = runtime.element 'gphys_nearest'
local Distance = runtime.element 'gphys_distance'
local Penetration = runtime.element 'gphys_penetration'
local MeshReport = runtime.element 'gphys_mesh_report'
local MeshDesc = runtime.element 'gphys_mesh_desc'
local MeshInfo = runtime.element 'gphys_mesh_info'
local OctreeStats = runtime.element 'gphys_octree_stats'
local OctreeBox = runtime.element 'gphys_octree_box'
local SceneDesc = runtime.element 'gphys_scene_desc'
local ModelDesc = runtime.element 'gphys_model_desc'
local ModelInfo = runtime.element 'gphys_model_info'
local QueryFilterDesc = runtime.element 'gphys_query_filter_desc'
local CameraDesc = runtime.element 'gphys_camera_desc'
local Orbit = runtime.element 'gphys_orbit'
local OrbitSpeeds = runtime.element 'gphys_orbit_speeds'
local SolverDesc = runtime.element 'gphys_solver_desc'
local SolverSettings = runtime.element 'gphys_solver_settings'
local BodyDesc = runtime.element 'gphys_body_desc'
local BodySettings = runtime.element 'gphys_body_settings'
local BodyInfo = runtime.element 'gphys_body_info'
local Wind = runtime.element 'gphys_wind'
local AnimationTarget = runtime.element 'gphys_animation_target'
local Attachment = runtime.element 'gphys_attachment'
local ConstraintInfo = runtime.element 'gphys_constraint_info'
local ConstraintSettings = runtime.element 'gphys_constraint_settings'
local JointInfo = runtime.element 'gphys_joint_info'
local Break = runtime.element 'gphys_break'
local SolverStats = runtime.element 'gphys_solver_stats'
local Contact = runtime.element 'gphys_contact'
local BodyContact = runtime.element 'gphys_body_contact'
local Impulse = runtime.element 'gphys_impulse'

local Mesh = runtime.class 'mesh'
--- Build a mesh from copies of the arrays. Triangles of zero area are kept: queries treat them as the
--- segments or points that they are, and the report counts them. 0 triangles are allowed.
--- Cost: O(n log n), about 1 us per triangle.
--- @raise status ERROR_INVALID_ARGUMENT: for an index out of range, an index_count that is no multiple
---     of 3 or a bad vertex; gp.mesh_check tells which
function gp.Mesh(vertices, indices, desc)
    local vertices, vertices_count, vertices_stride = to_array(float, vertices, 3)
    local indices, indices_count, indices_stride = to_array(uint32_t, indices)
    return Mesh.create(function(made)
        return C.gphys_mesh_create(desc and to_desc(MeshDesc, desc), vertices, vertices_stride, vertices_count, indices, indices_count, made)
    end)
end

--- Make the convex hull of points: a mesh that is solid, as spheres and boxes are. It can be used
--- wherever a mesh can: functions of shapes, models of scenes, snapshots, and solvers, whose particles
--- stay outside and are pushed out. A ray that starts inside hits at t = 0 with HIT_INSIDE; one from
--- outside hits the face through which it enters, `triangle` says where. Whether a ray hits and whether
--- a point is inside is exact with respect to the points. Inside, the closest point is the point itself
--- and triangle NO_TRIANGLE. Mesh:overlap lists the triangles of the surface; Mesh:raycast_all gives
--- only the first hit. The vertices are the points that are corners of the hull, in their original
--- order; of equal points the first. The triangles come face by face, all that lie in one plane being
--- one face; seen from outside their corners go counterclockwise where axes are right-handed, and the
--- normal cross(b - a, c - a) points out.
--- Cost: O(point_count * faces); allocates. Rays take O(log faces), other queries up to O(faces).
--- Source: quickhull (Barber, Dobkin, Huhdanpaa 1996) with exact predicates. Since 1.1.
--- @param desc deformable must be 0
--- @param points elements of 3 floats, metres; copied
--- @raise status ERROR_INVALID_ARGUMENT: if a point is out of range or if all lie in a plane, which is
---     decided exactly
--- @raise status ERROR_CAPACITY: if the hull has more than 256 faces
--- @raise status ERROR_UNSUPPORTED: if desc asks for a deformable mesh
function gp.Mesh_hull(points, desc)
    local points, points_count, points_stride = to_array(float, points, 3)
    return Mesh.create(function(made)
        return C.gphys_mesh_create_hull(desc and to_desc(MeshDesc, desc), points, points_stride, points_count, made)
    end)
end

--- Make a mesh from a snapshot: all its answers have the same bits as those of the mesh in the
--- snapshot. Any words are safe, also from an untrusted source: vertices, indices and the tree are
--- checked, and what follows from them is computed. Forged words are refused, or taken as a mesh like
--- any other; only the counts of its report (triangles of zero area, open edges) are taken from the
--- words as they are.
--- Cost: O(n), a small part of Mesh's; allocates.
--- @param desc with `deformable` the mesh takes new vertices, even if the one in the snapshot did not
--- @raise status ERROR_INVALID_ARGUMENT: for words that are no snapshot of a mesh, damaged, of a later
---     format or of another byte order
--- @raise status ERROR_UNSUPPORTED: for a deformable hull
function gp.Mesh_from_snapshot(words, desc)
    local words, words_count, words_stride = to_array(uint32_t, words)
    return Mesh.create(function(made)
        return C.gphys_mesh_create_from_snapshot(desc and to_desc(MeshDesc, desc), words, words_count, made)
    end)
end

--- A handle of a model's mesh: of the mesh itself, not of a copy, so that what Mesh:set_vertices does
--- to it is seen by all its models. It gives the meshes of a restored scene, which are not deformable
--- if they were embedded in its snapshot.
--- Cost: O(1). Since 1.1.
--- @return a reference of its own, which keeps the mesh alive, and is to be destroyed like any handle.
--- @raise status ERROR_UNSUPPORTED: if the model's shape is no mesh
function gp.Mesh_from_scene(scene, model)
    return Mesh.create(function(made)
        return C.gphys_scene_get_mesh(opened(scene), whole(model, 'model'), made)
    end)
end

--- Make a mesh that has the form of a body and follows it automatically: cloth, ropes and particles can
--- be hit by rays, picked, overlapped and culled as models of scenes (Scene:add with SHAPE_MESH;
--- without a transform the model is where the body is) or queried by shape_* and mesh_* functions.
--- Vertex p is particle p. For cloth the mesh is the surface of its triangles, in the order of
--- Solver:get_triangles. A rope of n particles is solid. In a hit, `triangle` t below n - 1 is the link
--- from particle t to t + 1, a capsule with the smaller of their radii, present while a constraint
--- holds them together; n - 1 + p is particle p, a sphere, present where no link beside it is as thick.
--- Free particles are spheres, and `triangle` is the particle. Solver:get_nearest_particle finds the
--- particle of a hit. The mesh has the new form when Solver:step, Solver:advance, Solver:restore or an
--- edit of the body returns. When cloth tears (Break), its triangles keep their numbers, and the mesh
--- gets vertices for the new particles. A model that would leave the range of the world, and a torn
--- mesh or one of less than 2^-32 m for which there is no memory, keep their form until they can
--- follow. Solver:set_origin moves the coordinates of the mesh, and the models back by as much: they
--- stay where they are in the world, exactly if scenes have moved their origin before. Bodies neither
--- collide with models of such meshes nor wake because of them: BodyDesc.body_layers sets which bodies
--- collide. A restored body is followed if it has the same id and parts as before. Restore the solver
--- before the scene. A mesh that is loaded from a snapshot, that of a scene included, is a copy that
--- follows nothing; Scene:set_shape gives its model one that does. Mesh and solver are destroyed in any
--- order. When the body is gone the mesh keeps the form that it had last and is deformable by
--- Mesh:set_vertices, which returns ERROR_UNSUPPORTED before. A mesh that neither its handle nor a
--- model holds follows no more.
--- Threads: the functions above become edits of the mesh and of each scene that has a model of it.
--- Cost: as Mesh, and then that of Mesh:set_vertices for a body that has moved; one that rests is
--- compared, O(particles). Since 1.1.
--- @param desc the mesh is deformable whatever it says
function gp.Mesh_from_body(solver, body, desc)
    return Mesh.create(function(made)
        return C.gphys_mesh_create_from_body(desc and to_desc(MeshDesc, desc), opened(solver), whole(body, 'body'), made)
    end)
end

--- The planes of a hull's faces: normals are unit and point out, within float32 rounding.
--- Cost: O(faces). Since 1.1.
--- @raise status ERROR_UNSUPPORTED: for a mesh that is no hull
function Mesh:get_hull_planes()
    return list(Plane, function(out, capacity, total)
        return C.gphys_mesh_get_hull_planes(opened(self), out, capacity, total)
    end)
end

--- For each triangle of a hull the index of its face in the list of Mesh:get_hull_planes, ascending
--- from 0.
--- Cost: O(triangles). Since 1.1.
--- @raise status ERROR_UNSUPPORTED: for a mesh that is no hull
function Mesh:get_hull_faces()
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_mesh_get_hull_faces(opened(self), out, capacity, total)
    end)
end

--- Replace the vertices of a deformable mesh, such as a skinned character, or cloth as
--- Solver:get_positions writes it. All models of the mesh take the new form at once, in every scene,
--- and all answers have the same bits as those of a mesh created from the new vertices. A call that
--- fails leaves the mesh and the scenes as they were. A solver sees the new form at its next step, as a
--- surface that stands still.
--- Threads: an edit of the mesh and of every scene that has a model of it: not beside other calls on
--- these.
--- Cost: O(vertices + triangles + log n for each model), a few per cent of creating it: the tree is
--- refitted, and parts that have degraded are rebuilt. If the triangles have moved apart so far that
--- the boxes of their groups of eight have twice the area, once as much as creating it. Allocates.
--- Since 1.1.
--- @param vertices elements of 3 floats, metres; copied
--- @raise status ERROR_UNSUPPORTED: if the mesh is not deformable
--- @raise status ERROR_INVALID_ARGUMENT: for a vertex that is not finite or too large, or if a model of
---     the mesh would reach beyond the range of coordinates
function Mesh:set_vertices(vertices)
    local vertices, vertices_count, vertices_stride = to_array(float, vertices, 3)
    check(C.gphys_mesh_set_vertices(opened(self), vertices, vertices_stride, vertices_count))
end

--- Kind and size of a mesh, and whether its vertices change.
--- Cost: O(1). Since 1.1.
function Mesh:get_info(out_info)
    out_info = out_info or MeshInfo.new()
    check(C.gphys_mesh_get_info(opened(self), out_info))
    return out_info
end

--- What the mesh was built from: the report that gp.mesh_check makes of its arrays.
--- Cost: O(1); O(triangles) for a deformable mesh.
function Mesh:get_report(out_report)
    out_report = out_report or MeshReport.new()
    check(C.gphys_mesh_get_report(opened(self), out_report))
    return out_report
end

--- Copy the vertices out, in metres and in their original order.
--- Cost: O(vertices).
function Mesh:get_vertices()
    return list(Vec3, function(out, capacity, total)
        return C.gphys_mesh_get_vertices(opened(self), out, capacity, total)
    end)
end

--- Copy the indices out, three for each triangle, in their original order.
--- Cost: O(n).
function Mesh:get_indices()
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_mesh_get_indices(opened(self), out, capacity, total)
    end)
end

--- Copy a mesh out with its tree, from which Mesh makes it without building the tree.
--- Threads: any.
--- Cost: O(n), some 24 bytes and 5 ns for each triangle; no allocation.
--- @return the snapshot. Words are in the machine's byte order. Every later release of the same major
---     version reads it.
--- @raise status ERROR_CAPACITY: beyond 2^32 - 1 words
function Mesh:get_snapshot()
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_mesh_get_snapshot(opened(self), out, capacity, total)
    end)
end

--- All hits of a ray, by t, then triangle. A ray through a shared edge hits both triangles.
--- Cost: O(log n + k) expected.
function Mesh:raycast_all(ray)
    return list(Hit, function(out, capacity, total)
        return C.gphys_mesh_raycast_all(opened(self), to_value(Ray, ray), out, capacity, total)
    end)
end

do
    local out_hit = int32_t.array(1)
    --- Whether a ray hits anything; cheaper than the closest hit.
    --- Cost: O(log n) expected.
    function Mesh:raycast_any(ray)
        check(C.gphys_mesh_raycast_any(opened(self), to_value(Ray, ray), out_hit))
        return out_hit[0] ~= 0
    end
end

--- Whether each of the rays hits anything, as Mesh:raycast_any.
--- Cost: that of as many single calls; less if neighbouring rays are similar. Since 1.1.
function Mesh:raycast_any_batch(rays, out)
    local rays, rays_count, rays_stride = to_array(Ray, rays)
    local count = common(rays_count)
    out = results(int32_t, out, count)
    check(C.gphys_mesh_raycast_any_batch(opened(self), rays, rays_stride, count, out, int32_t.size))
    return out
end

--- How far each of the rays goes, and which triangle it hits: t and triangle of gp.raycast_batch for
--- the mesh, with the same bits, without the rest of a hit; model is 0.
--- Cost: less than that of gp.raycast_batch. Since 1.1.
--- @return a ray that hits nothing gets t = INFINITY and triangle = NO_TRIANGLE.
function Mesh:raycast_distance_batch(rays, out)
    local rays, rays_count, rays_stride = to_array(Ray, rays)
    local count = common(rays_count)
    out = results(Distance, out, count)
    check(C.gphys_mesh_raycast_distance_batch(opened(self), rays, rays_stride, count, out, Distance.size))
    return out
end

--- Indices of all triangles that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
--- ascending.
--- Cost: O(log n + k) expected.
--- @raise status ERROR_UNSUPPORTED: for other types of shapes
function Mesh:overlap(shape)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_mesh_overlap(opened(self), kind(shape), address(shape), out, capacity, total)
    end)
end

--- How the mesh's octree is made up.
--- Cost: O(nodes).
function Mesh:get_octree_stats(out_stats)
    out_stats = out_stats or OctreeStats.new()
    check(C.gphys_mesh_get_octree_stats(opened(self), out_stats))
    return out_stats
end

--- Boxes of the mesh's octree, each parent before its children.
--- Cost: O(nodes).
function Mesh:get_octree_boxes()
    return list(OctreeBox, function(out, capacity, total)
        return C.gphys_mesh_get_octree_boxes(opened(self), out, capacity, total)
    end)
end

local Scene = runtime.class 'scene'
--- Create a scene without models. With a worker_count of n, all batch queries of the scene
--- (Camera:pick_batch too), and adding and moving many models, share their work among n threads; the
--- results have the same bits for every n. Without a task_runner n - 1 threads are started here and
--- joined when the scene is destroyed. They serve one call at a time: calls made meanwhile run on their
--- own thread alone. They take no signals but faults, and have the standard floating-point settings. In
--- a child of fork they are gone: calls there run on one thread, as they do on a platform without
--- threads (WebAssembly, unless built for shared memory), whatever is asked for.
--- Cost: O(reserve_models), and that of starting the threads.
--- @param desc nil: the defaults
--- @raise status ERROR_OUT_OF_MEMORY: also if the threads cannot be started
--- @raise status ERROR_CAPACITY: if reserve_models is above 2^24 - 1
function gp.Scene(desc)
    return Scene.create(function(made)
        return C.gphys_scene_create(desc and to_desc(SceneDesc, desc), made)
    end)
end

--- Change the number of threads that share the calls of a scene, for example when the user changes a
--- setting. They are those of its task_runner if it was created with one. In a child of fork they are
--- started again. Answers keep their bits.
--- Cost: that of joining the former threads and starting others; allocates. Since 1.1.
--- @param workers as SceneDesc.worker_count
--- @raise status ERROR_OUT_OF_MEMORY: also if the threads cannot be started; the former ones are kept
function Scene:set_worker_count(workers)
    check(C.gphys_scene_set_worker_count(opened(self), whole(workers, 'workers')))
end

do
    local out_workers = uint32_t.array(1)
    --- How many threads share the calls of a scene: 1 or more, 1 on a platform without threads. In a child
    --- of fork it is still the number that was set, though calls run on one thread.
    --- Cost: O(1). Since 1.1.
    function Scene:get_worker_count()
        check(C.gphys_scene_get_worker_count(opened(self), out_workers))
        return out_workers[0]
    end
end

--- Move the point of the world that all coordinates of the scene are relative to, those passed to it
--- and those that it returns. Models stay where they are in the world: the positions of those without a
--- parent become what they are from there, kept in double precision and rounded to float32 once,
--- however often the origin moves. For worlds beyond some kilometres: keep the origin near the camera,
--- and when the camera has gone a few kilometres, move it together with that of cameras and solvers.
--- Cost: that of Scene:set_transforms of all models, and 24 bytes a model from the first call on.
--- Queries cost nothing more. Allocates.
--- @param origin x, y, z in the world, within MAX_COORDINATE; before the first call 0 0 0
--- @raise status ERROR_INVALID_ARGUMENT: also if a model would leave the range of coordinates
function Scene:set_origin(origin)
    check(C.gphys_scene_set_origin(opened(self), to_numbers(double, origin, 3)))
end

--- Where in the world the scene's coordinates count from.
--- Cost: O(1).
function Scene:get_origin()
    local out_origin = double.array(3)
    check(C.gphys_scene_get_origin(opened(self), out_origin))
    return out_origin
end

do
    local out_model = uint32_t.array(1)
    --- Add a model.
    --- Cost: O(log n) amortised.
    --- @param shape sphere, capsule, AABB, OBB, plane, triangle or mesh (a hull too)
    --- @param shape in the model's own coordinates
    --- @param transform local; nil is the identity
    --- @param desc nil: no parent, layer 1, tag 0
    --- @raise status ERROR_UNSUPPORTED: for another type, or a scale that the shape cannot have
    ---     (Scene:set_scale)
    --- @raise status ERROR_INVALID_ID: for a stale parent
    --- @raise status ERROR_CAPACITY: beyond 2^24 - 1 models
    function Scene:add(shape, transform, desc)
        check(C.gphys_scene_add(opened(self), kind(shape), address(shape), transform and to_value(Transform, transform), desc and to_desc(ModelDesc, desc), out_model))
        return out_model[0]
    end
end

--- Add the models of one type, all or none, as Scene:add does one.
--- Fails as Scene:add.
--- Cost: O(elements log n), less with workers; a rebuild of the octree, O(n log n), where their number
--- is of the order of n.
--- @param shapes in the models' own coordinates
--- @param transforms local; nil is the identity
--- @param desc for all; nil: no parent, layer 1, tag 0
function Scene:add_batch(shapes, transforms, desc, out)
    local shapes, shapes_kind, shapes_count, shapes_stride = to_shapes(shapes)
    local transforms, transforms_count, transforms_stride = to_array(Transform, transforms)
    local count = common(shapes_count, transforms_count)
    out = results(uint32_t, out, count)
    check(C.gphys_scene_add_batch(opened(self), shapes_kind, shapes, shapes_stride, transforms, transforms_stride, count, desc and to_desc(ModelDesc, desc), out))
    return out
end

--- Add the models of one type, all or none, each with a desc of its own.
--- Fails as Scene:add; ERROR_STRUCT_SIZE as for a single desc.
--- Cost: as Scene:add_batch.
--- @param shapes in the models' own coordinates
--- @param transforms local; nil is the identity
--- @param descs one for each; nil: no parent, layer 1, tag 0. Parents are models that the scene has
---     before the call
function Scene:add_described_batch(shapes, transforms, descs, out)
    local shapes, shapes_kind, shapes_count, shapes_stride = to_shapes(shapes)
    local transforms, transforms_count, transforms_stride = to_array(Transform, transforms)
    local descs, descs_count, descs_stride = to_descs(ModelDesc, descs)
    local count = common(shapes_count, transforms_count, descs_count)
    out = results(uint32_t, out, count)
    check(C.gphys_scene_add_described_batch(opened(self), shapes_kind, shapes, shapes_stride, transforms, transforms_stride, descs, descs_stride, count, out))
    return out
end

--- Remove a model. Its children stay where they are in the world and lose their parent.
--- Cost: O(log n) amortised, and O(1) a child. Renews the octree as far as there is memory.
function Scene:remove(model)
    check(C.gphys_scene_remove(opened(self), whole(model, 'model')))
end

--- Remove models, all or none.
--- Cost: that of as many calls of Scene:remove. Renews the octree as far as there is memory.
--- @param models the ids; an id that appears twice is ERROR_INVALID_ID
function Scene:remove_batch(models)
    local models, models_count, models_stride = to_array(uint32_t, models)
    local count = common(models_count)
    check(C.gphys_scene_remove_batch(opened(self), models, count))
end

--- Remove a model and all its descendants.
--- Cost: O(log n) amortised for each. Renews the octree as far as there is memory.
function Scene:remove_subtree(model)
    check(C.gphys_scene_remove_subtree(opened(self), whole(model, 'model')))
end

--- Remove all models. Ids given out before stay invalid.
--- Cost: O(n).
function Scene:clear()
    check(C.gphys_scene_clear(opened(self)))
end

--- Whether an id names a model of this scene.
--- Cost: O(1).
function Scene:has(model)
    return answered(C.gphys_scene_has(opened(self), whole(model, 'model')), -2)
end

--- Ids of all models, ascending.
--- Cost: O(n).
function Scene:get_models()
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_scene_get_models(opened(self), out, capacity, total)
    end)
end

--- Ids of all models without a parent, ascending.
--- Cost: O(n).
function Scene:get_roots()
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_scene_get_roots(opened(self), out, capacity, total)
    end)
end

--- Ids of the direct children of a model, ascending.
--- Cost: O(k log k).
function Scene:get_children(model)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_scene_get_children(opened(self), whole(model, 'model'), out, capacity, total)
    end)
end

--- Kind, parent, layers, tag and number of children of a model.
--- Cost: O(1).
function Scene:get_info(model, out_info)
    out_info = out_info or ModelInfo.new()
    check(C.gphys_scene_get_info(opened(self), whole(model, 'model'), out_info))
    return out_info
end

--- World box of a model, by which queries find it: contains the model, and is wider by at most 3 ulps
--- and 2^-19 of the sum of its sizes. That of an empty mesh is its position.
--- Cost: O(1).
--- @return nil for a plane.
function Scene:get_bounds(model, out_bounds)
    out_bounds = out_bounds or Aabb.new()
    if found(C.gphys_scene_get_bounds(opened(self), whole(model, 'model'), out_bounds)) then return out_bounds end
end

--- World box of all bounded models. Planes are left out.
--- Cost: O(1).
--- @return nil if there are none.
function Scene:get_scene_bounds(out_bounds)
    out_bounds = out_bounds or Aabb.new()
    if found(C.gphys_scene_get_scene_bounds(opened(self), out_bounds)) then return out_bounds end
end

--- Give a model another shape, or another mesh, of any type that Scene:add takes: a character crouches,
--- a level of detail changes, a wall breaks. Its id, parent, children, tag, layers, scale and
--- transforms stay. Sleeping bodies near it wake, and particles that are inside then come out as they
--- do of any solid.
--- Cost: as Scene:set_transform of a model without children, whatever the size of a mesh.
--- @param shape as in Scene:add: a struct, copied, or a mesh with SHAPE_MESH. The scene holds the new
---     mesh and no longer the old one, which may be the same.
--- @raise status ERROR_UNSUPPORTED: for a frustum, ray or segment, and for a shape that cannot have the
---     model's scale (Scene:set_scale)
--- @raise status ERROR_INVALID_ARGUMENT: also if the model would leave the range of the world
--- @raise status ERROR_OUT_OF_MEMORY:
function Scene:set_shape(model, shape)
    check(C.gphys_scene_set_shape(opened(self), whole(model, 'model'), kind(shape), address(shape)))
end

--- Scale a model's own shape along the three axes of the model, before its transform: a tree grows, a
--- unit box becomes a wall, a rock is stretched. Every query, and solvers, see the scaled shape;
--- normals are those of its surface. Children and attached particles (Solver:attach) are not affected:
--- they follow the transform, whose scale is one number. A new scale replaces the old one. No scale
--- mirrors: for that, negate a coordinate of a mesh's vertices and swap two corners of each triangle.
--- There is no form for many models: three equal numbers belong in their transforms
--- (Scene:set_transforms), and Scene:add_described_batch takes a scale for each model that it adds. A
--- mesh or a hull is scaled exactly, without a copy: answers are those of a mesh of the scaled
--- vertices. Of a box or a triangle each number is multiplied and rounded to float32. A sphere, capsule
--- or plane, and an OBB whose own rotation is not the identity, take three equal numbers only.
--- Cost: as Scene:set_transform of a model without children. Models that have a scale take 16 bytes
--- more if they are meshes, else 52, up to the highest id. Queries of a scaled mesh or hull take 1 to
--- 11 % more; rays at a mesh that is flattened to a twentieth take 1.3 times those at a mesh of the
--- scaled vertices, whose tree is made for that form.
--- @param scale x, y, z, each from 1e-15 to 1e15
--- @raise status ERROR_UNSUPPORTED: for numbers that are not equal where they have to be, and for the
---     mesh of a rope or of particles (Mesh) unless it is 1 1 1
--- @raise status ERROR_INVALID_ARGUMENT: also if a coordinate of the scaled shape would exceed
---     MAX_COORDINATE, if a number times that of a mesh's world transform is not from 1e-15 to 1e15, or
---     if the model would leave the range of the world
--- @raise status ERROR_OUT_OF_MEMORY:
function Scene:set_scale(model, scale)
    check(C.gphys_scene_set_scale(opened(self), whole(model, 'model'), to_value(Vec3, scale)))
end

--- The scale of a model's own shape, 1 1 1 unless another was set.
--- Cost: O(1).
function Scene:get_scale(model, out_scale)
    out_scale = out_scale or Vec3.new()
    check(C.gphys_scene_get_scale(opened(self), whole(model, 'model'), out_scale))
    return out_scale
end

--- Change which queries see a model: those with a mask m of which layers & m is not 0. Children are not
--- affected.
--- Cost: O(1).
--- @param layers any mask; 0: no query sees it
function Scene:set_layers(model, layers)
    check(C.gphys_scene_set_layers(opened(self), whole(model, 'model'), bits(layers, 'layers')))
end

--- Change the number that a model's hits report beside its id. Children are not affected.
--- Cost: O(1).
--- @param tag any number of the caller's
function Scene:set_tag(model, tag)
    check(C.gphys_scene_set_tag(opened(self), whole(model, 'model'), whole(tag, 'tag')))
end

--- Make a model the child of another one, or of none (0).
--- Cost: O(depth of the tree of models), and as Scene:set_transform for what moves. Renews the octree
--- as far as there is memory.
--- @param keep_world 0: the local transform is kept, the model jumps; 1: the local transform is changed
---     so that the world transform stays (within float32 rounding)
--- @raise status ERROR_CYCLE: if parent is the model or one of its descendants
function Scene:set_parent(model, parent, keep_world)
    check(C.gphys_scene_set_parent(opened(self), whole(model, 'model'), whole(parent, 'parent'), to_flag(keep_world, 'keep_world')))
end

--- Set a model's local transform. Descendants follow.
--- Cost: O(log n) for each model that moves. Renews the octree as far as there is memory.
--- @param transform relative to the parent; scale > 0
--- @raise status ERROR_INVALID_ARGUMENT: also if it, or a descendant, would leave the range of the
---     world
function Scene:set_transform(model, transform)
    check(C.gphys_scene_set_transform(opened(self), whole(model, 'model'), to_value(Transform, transform)))
end

--- Set the local transforms of many models, all or none; a model that appears twice gets the last.
--- Descendants follow.
--- Cost: O(log n) for each model that moves when few move, O(n) when many do; less with workers. Renews
--- the octree as far as there is memory.
--- @param models the ids
--- @param transforms as in Scene:set_transform
function Scene:set_transforms(models, transforms)
    local models, models_count, models_stride = to_array(uint32_t, models)
    local transforms, transforms_count, transforms_stride = to_array(Transform, transforms)
    local count = common(models_count, transforms_count)
    check(C.gphys_scene_set_transforms(opened(self), models, transforms, transforms_stride, count))
end

--- Local transforms of the models, as they were set: relative to the parent.
--- Cost: O(elements).
--- @param models the ids; an id may appear twice
function Scene:get_transforms(models, out)
    local models, models_count, models_stride = to_array(uint32_t, models)
    local count = common(models_count)
    out = results(Transform, out, count)
    check(C.gphys_scene_get_transforms(opened(self), models, count, out, Transform.size))
    return out
end

--- World transforms of the models: with those of all ancestors applied, rounded to float32. Answers of
--- queries are exact with respect to these.
--- Cost: O(elements).
--- @param models the ids; an id may appear twice
function Scene:get_world_transforms(models, out)
    local models, models_count, models_stride = to_array(uint32_t, models)
    local count = common(models_count)
    out = results(Transform, out, count)
    check(C.gphys_scene_get_world_transforms(opened(self), models, count, out, Transform.size))
    return out
end

--- Closest model on a ray; the fields are exact as in gp.raycast.
--- Cost: O(log n) expected; no allocation.
--- @return nil if nothing is found.
function Scene:raycast(ray, layers, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_scene_raycast(opened(self), to_value(Ray, ray), bits(layers or ALL_LAYERS, 'layers'), out_hit)) then return out_hit end
end

--- Closest models on the rays, as Scene:raycast; a ray that hits nothing gets model = 0 and t =
--- INFINITY.
--- Cost: at most that of as many single calls; shared among workers.
function Scene:raycast_batch(rays, layers, out)
    local rays, rays_count, rays_stride = to_array(Ray, rays)
    local count = common(rays_count)
    out = results(Hit, out, count)
    check(C.gphys_scene_raycast_batch(opened(self), rays, rays_stride, count, bits(layers or ALL_LAYERS, 'layers'), out, Hit.size))
    return out
end

--- How far each of the rays goes, and what it hits: t, model and triangle of Scene:raycast_batch, with
--- the same bits, without the rest of a hit. For lidars and depth images.
--- Cost: less than that of Scene:raycast_batch; shared among workers. Since 1.1.
--- @return a ray that hits nothing gets t = INFINITY, model = 0 and triangle = NO_TRIANGLE.
function Scene:raycast_distance_batch(rays, layers, out)
    local rays, rays_count, rays_stride = to_array(Ray, rays)
    local count = common(rays_count)
    out = results(Distance, out, count)
    check(C.gphys_scene_raycast_distance_batch(opened(self), rays, rays_stride, count, bits(layers or ALL_LAYERS, 'layers'), out, Distance.size))
    return out
end

do
    local out_hit = int32_t.array(1)
    --- Whether a ray meets anything (shadow, line of sight); cheaper than the closest hit.
    --- Cost: O(log n) expected.
    function Scene:raycast_any(ray, layers)
        check(C.gphys_scene_raycast_any(opened(self), to_value(Ray, ray), bits(layers or ALL_LAYERS, 'layers'), out_hit))
        return out_hit[0] ~= 0
    end
end

--- Whether each of the rays meets anything, as Scene:raycast_any.
--- Cost: at most that of as many single calls; shared among workers.
function Scene:raycast_any_batch(rays, layers, out)
    local rays, rays_count, rays_stride = to_array(Ray, rays)
    local count = common(rays_count)
    out = results(int32_t, out, count)
    check(C.gphys_scene_raycast_any_batch(opened(self), rays, rays_stride, count, bits(layers or ALL_LAYERS, 'layers'), out, int32_t.size))
    return out
end

--- Every model that a ray meets, each once with its first hit, by t, then id.
--- Cost: O(log n + k log k) expected.
function Scene:raycast_all(ray, layers)
    return list(Hit, function(out, capacity, total)
        return C.gphys_scene_raycast_all(opened(self), to_value(Ray, ray), bits(layers or ALL_LAYERS, 'layers'), out, capacity, total)
    end)
end

--- Every model that each of the rays meets, as Scene:raycast_all: the hits of ray i are at
--- hits[offsets[i]] up to offsets[i + 1].
--- The contents of hits behind the last hit are unspecified.
--- Cost: that of as many single calls; shared among workers.
function Scene:raycast_all_batch(rays, layers)
    local rays, rays_count, rays_stride = to_array(Ray, rays)
    local count = common(rays_count)
    return ragged(Hit, function(out, capacity, offsets)
        return C.gphys_scene_raycast_all_batch(opened(self), rays, rays_stride, count, bits(layers or ALL_LAYERS, 'layers'), out, capacity, offsets)
    end, count)
end

--- Closest model along a segment from a to b, both included; t in 0..1. Fields as in gp.segment_test.
--- Cost: O(log n) expected.
--- @return nil if nothing is found.
function Scene:segment_test(segment, layers, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_scene_segment_test(opened(self), to_value(Segment, segment), bits(layers or ALL_LAYERS, 'layers'), out_hit)) then return out_hit end
end

--- Closest models along the segments, as Scene:segment_test; one that hits nothing gets model = 0 and t
--- = INFINITY.
--- Cost: that of as many single calls; shared among workers.
function Scene:segment_test_batch(segments, layers, out)
    local segments, segments_count, segments_stride = to_array(Segment, segments)
    local count = common(segments_count)
    out = results(Hit, out, count)
    check(C.gphys_scene_segment_test_batch(opened(self), segments, segments_stride, count, bits(layers or ALL_LAYERS, 'layers'), out, Hit.size))
    return out
end

--- Ids of all models that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum, as
--- gp.overlaps, ascending.
--- Cost: O(log n + k) expected, and O(k log k) to order hundreds of ids. Room in models for n / 32 + 64
--- more saves most of that, unless many models have replaced removed ones.
--- @raise status ERROR_UNSUPPORTED: for other types of shapes
function Scene:overlap(shape, layers)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_scene_overlap(opened(self), kind(shape), address(shape), bits(layers or ALL_LAYERS, 'layers'), out, capacity, total)
    end)
end

--- Ids of all models that each of the shapes of one type overlaps, as Scene:overlap: those of shape i
--- are at models[offsets[i]] up to offsets[i + 1], as in Scene:raycast_all_batch.
--- Cost: at most that of as many single calls; shared among workers.
--- @raise status ERROR_UNSUPPORTED: as there
function Scene:overlap_batch(shapes, layers)
    local shapes, shapes_kind, shapes_count, shapes_stride = to_shapes(shapes)
    local count = common(shapes_count)
    return ragged(uint32_t, function(out, capacity, offsets)
        return C.gphys_scene_overlap_batch(opened(self), shapes_kind, shapes, shapes_stride, count, bits(layers or ALL_LAYERS, 'layers'), out, capacity, offsets)
    end, count)
end

--- Ids of all models whose world box is not wholly outside any of a frustum's six planes or its own
--- box, ascending: for drawing. No visible model is missed. Some invisible ones near the frustum's
--- edges are listed, too: a few per cent more where models are compact or not rotated; about a third
--- more where they are long or flat and rotated, so that their world boxes are mostly empty, and as
--- many again as are visible where they are as long as the view is wide. Scene:overlap leaves these out
--- by testing the shapes. In scenes of more than 130 000 models, room for n / 32 more ids than are
--- listed is best: it is used to order them.
--- Cost: O(log n + k) expected.
function Scene:cull(frustum, layers)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_scene_cull(opened(self), to_value(Frustum, frustum), bits(layers or ALL_LAYERS, 'layers'), out, capacity, total)
    end)
end

--- Ids of the models in each of count frusta, as Scene:cull: for split screens, cascades of shadow
--- maps, faces of a cube map, many sensors. Those of frustum i are at models[offsets[i]] up to
--- offsets[i + 1], as in Scene:raycast_all_batch.
--- Cost: that of as many single calls; shared among workers. Since 1.1.
function Scene:cull_batch(frusta, layers)
    local frusta, frusta_count, frusta_stride = to_array(Frustum, frusta)
    local count = common(frusta_count)
    return ragged(uint32_t, function(out, capacity, offsets)
        return C.gphys_scene_cull_batch(opened(self), frusta, frusta_stride, count, bits(layers or ALL_LAYERS, 'layers'), out, capacity, offsets)
    end, count)
end

--- The model nearest to a point, and its closest point.
--- Cost: O(log n) expected if all models are in the layers. Otherwise those that are not, and are
--- nearer than the answer, are visited in vain, until it is faster to test all models in the layers.
--- That takes time for them, for n / 64 words, and for 64 words where one of 64 consecutive models is
--- in the layers. So the nearest of 10 or of 1000 among 100 000 models takes some 3 us, and of 100 some
--- 15 us.
--- @param max_distance metres, >= 0, INFINITY allowed; a model at exactly this distance counts
--- @return nil if nothing is found.
function Scene:nearest(point, max_distance, layers, out_nearest)
    out_nearest = out_nearest or Nearest.new()
    if found(C.gphys_scene_nearest(opened(self), to_value(Vec3, point), real(max_distance or math.huge, 'max_distance'), bits(layers or ALL_LAYERS, 'layers'), out_nearest)) then return out_nearest end
end

--- The models nearest to the points, as Scene:nearest; a point with none gets model = 0 and distance =
--- INFINITY.
--- Cost: that of as many single calls; shared among workers.
--- @param max_distance metres, >= 0, INFINITY allowed, for all points
function Scene:nearest_batch(points, max_distance, layers, out)
    local points, points_count, points_stride = to_array(Vec3, points)
    local count = common(points_count)
    out = results(Nearest, out, count)
    check(C.gphys_scene_nearest_batch(opened(self), points, points_stride, count, real(max_distance or math.huge, 'max_distance'), bits(layers or ALL_LAYERS, 'layers'), out, Nearest.size))
    return out
end

--- First model that a sphere touches while it moves by displacement; t in 0..1. Fields as in
--- gp.sweep_sphere.
--- Cost: O(log n + k) expected, k the models that the swept box touches.
--- @param displacement metres; may be zero
--- @return nil if nothing is found.
function Scene:sweep_sphere(sphere, displacement, layers, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_scene_sweep_sphere(opened(self), to_value(Sphere, sphere), to_value(Vec3, displacement), bits(layers or ALL_LAYERS, 'layers'), out_hit)) then return out_hit end
end

--- First models that the spheres touch while each moves by its displacement, as Scene:sweep_sphere; one
--- that touches nothing gets model = 0 and t = INFINITY.
--- Cost: that of as many single calls; shared among workers.
--- @param displacements metres
function Scene:sweep_sphere_batch(spheres, displacements, layers, out)
    local spheres, spheres_count, spheres_stride = to_array(Sphere, spheres)
    local displacements, displacements_count, displacements_stride = to_array(Vec3, displacements)
    local count = common(spheres_count, displacements_count)
    out = results(Hit, out, count)
    check(C.gphys_scene_sweep_sphere_batch(opened(self), spheres, spheres_stride, displacements, displacements_stride, count, bits(layers or ALL_LAYERS, 'layers'), out, Hit.size))
    return out
end

--- First model that a sphere, capsule, AABB or OBB touches while it moves by displacement, without
--- turning; t in 0..1. Fields as in gp.sweep.
--- Cost: O(log n + k) expected, k the models that the swept box touches.
--- @param displacement metres; may be zero
--- @return nil if nothing is found.
--- @raise status ERROR_UNSUPPORTED: for other types
function Scene:sweep(shape, displacement, layers, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_scene_sweep(opened(self), kind(shape), address(shape), to_value(Vec3, displacement), bits(layers or ALL_LAYERS, 'layers'), out_hit)) then return out_hit end
end

--- First models that the shapes of one type touch while each moves by its displacement, as Scene:sweep;
--- one that touches nothing gets model = 0 and t = INFINITY.
--- Cost: that of as many single calls; shared among workers.
--- @param displacements metres
--- @raise status ERROR_UNSUPPORTED: as Scene:sweep
function Scene:sweep_batch(shapes, displacements, layers, out)
    local shapes, shapes_kind, shapes_count, shapes_stride = to_shapes(shapes)
    local displacements, displacements_count, displacements_stride = to_array(Vec3, displacements)
    local count = common(shapes_count, displacements_count)
    out = results(Hit, out, count)
    check(C.gphys_scene_sweep_batch(opened(self), shapes_kind, shapes, shapes_stride, displacements, displacements_stride, count, bits(layers or ALL_LAYERS, 'layers'), out, Hit.size))
    return out
end

--- What a sphere, capsule, AABB or OBB overlaps, and how it gets out: an element for each model, and of
--- a mesh one for each triangle, as gp.penetration. Deepest first; equal depths by model, then
--- triangle. Each is the way out of that one alone. The models are those of Scene:overlap.
--- Cost: O(log n + k log k) expected.
--- @raise status ERROR_UNSUPPORTED: for other types
function Scene:penetration(shape, layers)
    return list(Penetration, function(out, capacity, total)
        return C.gphys_scene_penetration(opened(self), kind(shape), address(shape), bits(layers or ALL_LAYERS, 'layers'), out, capacity, total)
    end)
end

--- What each of the shapes of one type overlaps, and how it gets out, as Scene:penetration: the ways
--- out of shape i are at penetrations[offsets[i]] up to offsets[i + 1], as in Scene:raycast_all_batch.
--- So a crowd of characters is pushed out in one call.
--- Cost: that of as many single calls; shared among workers. Since 1.1.
--- @raise status ERROR_UNSUPPORTED: as Scene:penetration
function Scene:penetration_batch(shapes, layers)
    local shapes, shapes_kind, shapes_count, shapes_stride = to_shapes(shapes)
    local count = common(shapes_count)
    return ragged(Penetration, function(out, capacity, offsets)
        return C.gphys_scene_penetration_batch(opened(self), shapes_kind, shapes, shapes_stride, count, bits(layers or ALL_LAYERS, 'layers'), out, capacity, offsets)
    end, count)
end

--- Closest model on a ray that the filter sees, as Scene:raycast.
--- Cost: that of Scene:raycast for one ignored model. For each model that is met within the ray's
--- reach, besides: O(its depth below its root) with FILTER_SUBTREE if ignored_model has children; of m
--- ignored_models O(log m) if they are ascending, as all lists of the library are, else O(m). Whether
--- they are takes O(m) a call. Where faces are left out, a batch tests a mesh one ray at a time.
--- @param filter nil: the defaults
--- @return nil if nothing is found.
--- @raise status ERROR_INVALID_ARGUMENT: for unknown flags, or ignored_models nil with an ignored_count
---     above 0
function Scene:raycast_filtered(ray, filter, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_scene_raycast_filtered(opened(self), to_value(Ray, ray), filter and to_desc(QueryFilterDesc, filter), out_hit)) then return out_hit end
end

--- Closest models on the rays that the filters see, as Scene:raycast_batch.
--- Cost: at most that of as many calls of Scene:raycast_filtered; shared among workers.
--- @param filters nil: the defaults
function Scene:raycast_filtered_batch(rays, filters, out)
    local rays, rays_count, rays_stride = to_array(Ray, rays)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(rays_count, filters_count)
    out = results(Hit, out, count)
    check(C.gphys_scene_raycast_filtered_batch(opened(self), rays, rays_stride, count, filters, filters_stride, out, Hit.size))
    return out
end

--- How far each of the rays goes among the models that its filter sees, as
--- Scene:raycast_distance_batch: a lidar leaves out the robot that carries it.
--- Cost: less than that of Scene:raycast_filtered_batch; shared among workers. Since 1.1.
--- @param filters nil: the defaults
function Scene:raycast_distance_filtered_batch(rays, filters, out)
    local rays, rays_count, rays_stride = to_array(Ray, rays)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(rays_count, filters_count)
    out = results(Distance, out, count)
    check(C.gphys_scene_raycast_distance_filtered_batch(opened(self), rays, rays_stride, count, filters, filters_stride, out, Distance.size))
    return out
end

do
    local out_hit = int32_t.array(1)
    --- Whether a ray meets anything that the filter sees, as Scene:raycast_any: line of sight between two
    --- models that both are left out.
    --- Cost: as Scene:raycast_filtered.
    --- @param filter nil: the defaults
    function Scene:raycast_any_filtered(ray, filter)
        check(C.gphys_scene_raycast_any_filtered(opened(self), to_value(Ray, ray), filter and to_desc(QueryFilterDesc, filter), out_hit))
        return out_hit[0] ~= 0
    end
end

--- Whether each of the rays meets anything that its filter sees, as Scene:raycast_any_batch.
--- Cost: at most that of as many single calls; shared among workers.
--- @param filters nil: the defaults
function Scene:raycast_any_filtered_batch(rays, filters, out)
    local rays, rays_count, rays_stride = to_array(Ray, rays)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(rays_count, filters_count)
    out = results(int32_t, out, count)
    check(C.gphys_scene_raycast_any_filtered_batch(opened(self), rays, rays_stride, count, filters, filters_stride, out, int32_t.size))
    return out
end

--- Every model that a ray meets and the filter sees, as Scene:raycast_all.
--- Cost: that of Scene:raycast_all, and for each model as Scene:raycast_filtered.
--- @param filter nil: the defaults
function Scene:raycast_all_filtered(ray, filter)
    return list(Hit, function(out, capacity, total)
        return C.gphys_scene_raycast_all_filtered(opened(self), to_value(Ray, ray), filter and to_desc(QueryFilterDesc, filter), out, capacity, total)
    end)
end

--- Every model that each of the rays meets and its filter sees, as Scene:raycast_all_batch.
--- Cost: that of as many single calls; shared among workers.
--- @param filters nil: the defaults
function Scene:raycast_all_filtered_batch(rays, filters)
    local rays, rays_count, rays_stride = to_array(Ray, rays)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(rays_count, filters_count)
    return ragged(Hit, function(out, capacity, offsets)
        return C.gphys_scene_raycast_all_filtered_batch(opened(self), rays, rays_stride, count, filters, filters_stride, out, capacity, offsets)
    end, count)
end

--- Closest model along a segment that the filter sees, as Scene:segment_test.
--- Cost: as Scene:raycast_filtered.
--- @param filter nil: the defaults
--- @return nil if nothing is found.
function Scene:segment_test_filtered(segment, filter, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_scene_segment_test_filtered(opened(self), to_value(Segment, segment), filter and to_desc(QueryFilterDesc, filter), out_hit)) then return out_hit end
end

--- Closest models along the segments that the filters see, as Scene:segment_test_batch.
--- Cost: that of as many single calls; shared among workers.
--- @param filters nil: the defaults
function Scene:segment_test_filtered_batch(segments, filters, out)
    local segments, segments_count, segments_stride = to_array(Segment, segments)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(segments_count, filters_count)
    out = results(Hit, out, count)
    check(C.gphys_scene_segment_test_filtered_batch(opened(self), segments, segments_stride, count, filters, filters_stride, out, Hit.size))
    return out
end

--- Ids of all models that overlap a shape and that the filter sees, as Scene:overlap.
--- Cost: that of Scene:overlap, and for each model as Scene:raycast_filtered.
--- @param filter nil: the defaults
--- @raise status ERROR_UNSUPPORTED: for types of shapes that Scene:overlap does not take
function Scene:overlap_filtered(shape, filter)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_scene_overlap_filtered(opened(self), kind(shape), address(shape), filter and to_desc(QueryFilterDesc, filter), out, capacity, total)
    end)
end

--- Ids of all models that each of the shapes of one type overlaps and its filter sees, as
--- Scene:overlap_batch.
--- Cost: at most that of as many single calls; shared among workers.
--- @param filters nil: the defaults
--- @raise status ERROR_UNSUPPORTED: as there
function Scene:overlap_filtered_batch(shapes, filters)
    local shapes, shapes_kind, shapes_count, shapes_stride = to_shapes(shapes)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(shapes_count, filters_count)
    return ragged(uint32_t, function(out, capacity, offsets)
        return C.gphys_scene_overlap_filtered_batch(opened(self), shapes_kind, shapes, shapes_stride, count, filters, filters_stride, out, capacity, offsets)
    end, count)
end

--- Ids of all models in a frustum, by their world boxes, that the filter sees, as Scene:cull: a
--- player's own head, say, is not drawn.
--- Cost: that of Scene:cull, and for each model as Scene:raycast_filtered.
--- @param filter nil: the defaults
function Scene:cull_filtered(frustum, filter)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_scene_cull_filtered(opened(self), to_value(Frustum, frustum), filter and to_desc(QueryFilterDesc, filter), out, capacity, total)
    end)
end

--- Ids of the models in each of count frusta that its filter sees, as Scene:cull_batch: each player's
--- view leaves out the player's own head.
--- Cost: that of as many single calls; shared among workers. Since 1.1.
--- @param filters nil: the defaults
function Scene:cull_filtered_batch(frusta, filters)
    local frusta, frusta_count, frusta_stride = to_array(Frustum, frusta)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(frusta_count, filters_count)
    return ragged(uint32_t, function(out, capacity, offsets)
        return C.gphys_scene_cull_filtered_batch(opened(self), frusta, frusta_stride, count, filters, filters_stride, out, capacity, offsets)
    end, count)
end

--- The model nearest to a point that the filter sees, as Scene:nearest: the nearest other model, if the
--- one at the point is left out.
--- Cost: that of Scene:nearest, and for each model as Scene:raycast_filtered; each ignored model that
--- is nearer than the answer is visited.
--- @param max_distance metres, >= 0, INFINITY allowed; a model at exactly this distance counts
--- @param filter nil: the defaults
--- @return nil if nothing is found.
function Scene:nearest_filtered(point, max_distance, filter, out_nearest)
    out_nearest = out_nearest or Nearest.new()
    if found(C.gphys_scene_nearest_filtered(opened(self), to_value(Vec3, point), real(max_distance or math.huge, 'max_distance'), filter and to_desc(QueryFilterDesc, filter), out_nearest)) then return out_nearest end
end

--- The models nearest to the points that the filters see, as Scene:nearest_batch.
--- Cost: that of as many single calls; shared among workers.
--- @param max_distance metres, >= 0, INFINITY allowed, for all points
--- @param filters nil: the defaults
function Scene:nearest_filtered_batch(points, max_distance, filters, out)
    local points, points_count, points_stride = to_array(Vec3, points)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(points_count, filters_count)
    out = results(Nearest, out, count)
    check(C.gphys_scene_nearest_filtered_batch(opened(self), points, points_stride, count, real(max_distance or math.huge, 'max_distance'), filters, filters_stride, out, Nearest.size))
    return out
end

--- First model that a moving sphere touches and the filter sees, as Scene:sweep_sphere: the sphere may
--- be the bounding sphere of the ignored model.
--- Cost: that of Scene:sweep_sphere, and for each model as Scene:raycast_filtered.
--- @param displacement metres; may be zero
--- @param filter nil: the defaults
--- @return nil if nothing is found.
function Scene:sweep_sphere_filtered(sphere, displacement, filter, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_scene_sweep_sphere_filtered(opened(self), to_value(Sphere, sphere), to_value(Vec3, displacement), filter and to_desc(QueryFilterDesc, filter), out_hit)) then return out_hit end
end

--- First models that count moving spheres touch and the filters see, as Scene:sweep_sphere_batch.
--- Cost: that of as many single calls; shared among workers.
--- @param displacements metres
--- @param filters nil: the defaults
function Scene:sweep_sphere_filtered_batch(spheres, displacements, filters, out)
    local spheres, spheres_count, spheres_stride = to_array(Sphere, spheres)
    local displacements, displacements_count, displacements_stride = to_array(Vec3, displacements)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(spheres_count, displacements_count, filters_count)
    out = results(Hit, out, count)
    check(C.gphys_scene_sweep_sphere_filtered_batch(opened(self), spheres, spheres_stride, displacements, displacements_stride, count, filters, filters_stride, out, Hit.size))
    return out
end

--- First model that a moving sphere, capsule, AABB or OBB touches and the filter sees, as Scene:sweep:
--- a character leaves out its own model.
--- Cost: that of Scene:sweep, and for each model as Scene:raycast_filtered.
--- @param displacement metres; may be zero
--- @param filter nil: the defaults
--- @return nil if nothing is found.
--- @raise status ERROR_UNSUPPORTED: for other types
function Scene:sweep_filtered(shape, displacement, filter, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_scene_sweep_filtered(opened(self), kind(shape), address(shape), to_value(Vec3, displacement), filter and to_desc(QueryFilterDesc, filter), out_hit)) then return out_hit end
end

--- First models that count moving shapes of one type touch and the filters see, as Scene:sweep_batch.
--- Cost: that of as many single calls; shared among workers.
--- @param displacements metres
--- @param filters nil: the defaults
--- @raise status ERROR_UNSUPPORTED: as Scene:sweep
function Scene:sweep_filtered_batch(shapes, displacements, filters, out)
    local shapes, shapes_kind, shapes_count, shapes_stride = to_shapes(shapes)
    local displacements, displacements_count, displacements_stride = to_array(Vec3, displacements)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(shapes_count, displacements_count, filters_count)
    out = results(Hit, out, count)
    check(C.gphys_scene_sweep_filtered_batch(opened(self), shapes_kind, shapes, shapes_stride, displacements, displacements_stride, count, filters, filters_stride, out, Hit.size))
    return out
end

--- What a sphere, capsule, AABB or OBB overlaps and the filter sees, and how it gets out, as
--- Scene:penetration.
--- Cost: that of Scene:penetration, and for each model as Scene:raycast_filtered.
--- @param filter nil: the defaults
--- @raise status ERROR_UNSUPPORTED: for other types
function Scene:penetration_filtered(shape, filter)
    return list(Penetration, function(out, capacity, total)
        return C.gphys_scene_penetration_filtered(opened(self), kind(shape), address(shape), filter and to_desc(QueryFilterDesc, filter), out, capacity, total)
    end)
end

--- What each of the shapes of one type overlaps and its filter sees, and how it gets out, as
--- Scene:penetration_batch: each character leaves out its own model.
--- Cost: that of as many single calls; shared among workers. Since 1.1.
--- @param filters nil: the defaults
--- @raise status ERROR_UNSUPPORTED: as Scene:penetration
function Scene:penetration_filtered_batch(shapes, filters)
    local shapes, shapes_kind, shapes_count, shapes_stride = to_shapes(shapes)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(shapes_count, filters_count)
    return ragged(Penetration, function(out, capacity, offsets)
        return C.gphys_scene_penetration_filtered_batch(opened(self), shapes_kind, shapes, shapes_stride, count, filters, filters_stride, out, capacity, offsets)
    end, count)
end

--- Rebuild the scene's octree, as good as that of one Scene:add_batch. Never required: ids, answers and
--- their bits do not change. Where many models were added one by one, such as a level that was streamed
--- in, rays then take 0.6 to 0.95 of the time.
--- Cost: O(n log n), 0.15 to 0.45 us a model, less with workers; allocates. Since 1.1.
--- @raise status ERROR_OUT_OF_MEMORY: with nothing changed
function Scene:rebuild_octree()
    check(C.gphys_scene_rebuild_octree(opened(self)))
end

do
    local out_done = int32_t.array(1)
    --- Rebuild the octree in parts, one in each call, until it is as good as after Scene:rebuild_octree:
    --- for levels that are streamed in while frames go on. Each Scene:add and Scene:remove does a part by
    --- itself; these calls do the rest. Never needed: ids, answers and their bits stay as they are. Models
    --- may be added, moved and removed between the calls. A call that updates an eighth of them or more
    --- restarts it.
    --- Cost: O(budget); allocates, until it is done about 130 bytes a model. Since 1.1.
    --- @param budget how much work to do, as a number of models, of 0.3 to 3 us each. The work is the same
    ---     on every machine and does not depend on time.
    --- @return 1: nothing is left to do, since fewer than one in 64 models were added one by one; 0: call
    ---     again.
    --- @raise status ERROR_OUT_OF_MEMORY: : the octree is as before, and the next call begins again
    function Scene:maintain_octree(budget)
        check(C.gphys_scene_maintain_octree(opened(self), whole(budget, 'budget'), out_done))
        return out_done[0] ~= 0
    end
end

--- How the scene's octree is made up.
--- Cost: O(nodes).
function Scene:get_octree_stats(out_stats)
    out_stats = out_stats or OctreeStats.new()
    check(C.gphys_scene_get_octree_stats(opened(self), out_stats))
    return out_stats
end

--- Boxes of the scene's octree, each parent before its children.
--- Cost: O(nodes).
function Scene:get_octree_boxes()
    return list(OctreeBox, function(out, capacity, total)
        return C.gphys_scene_get_octree_boxes(opened(self), out, capacity, total)
    end)
end

--- Check the scene's own structure: every model once in the tree, every box around its content, parents
--- and children in agreement, free slots free. For tests.
--- Cost: O(n).
--- @raise status ERROR_INTERNAL: and the error's message says what is wrong
function Scene:validate()
    check(C.gphys_scene_validate(opened(self)))
end

--- Copy the whole state out: the origin, models with their ids, parents, tags, layers, transforms and
--- shapes, the order of future ids, and the octree. Workers and allocator are not in it.
--- Cost: O(n), some 80 bytes and 100 ns for each model, besides embedded meshes (Mesh:get_snapshot).
--- Allocates a few words for each different mesh.
--- @param embed_meshes 1: meshes are in the snapshot, each once, so it is complete in itself: for saved
---     games and for other machines. 0: they are identified by their content, and Scene:restore looks
---     for them: for undo, and rollback each frame.
--- @return the snapshot. Words are in the machine's byte order. Every later release of the same major
---     version reads it.
--- @raise status ERROR_CAPACITY: beyond 2^32 - 1 words
function Scene:get_snapshot(embed_meshes)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_scene_get_snapshot(opened(self), to_flag(embed_meshes, 'embed_meshes'), out, capacity, total)
    end)
end

--- Replace the whole state by that of a snapshot, of this or of another scene. Ids are those of the
--- time of the snapshot, and so are future ones. All answers have the bits that they had then; a solver
--- that is restored with its scene continues with the same bits. On an error the scene is as before.
--- Any words are safe, also from an untrusted source: all that is used as a number or an index is
--- checked first. Forged words are refused, or taken as a scene like any other.
--- Cost: O(n), 150 to 700 ns for each model, besides embedded meshes (Mesh). Allocates.
--- @param library meshes that are not embedded are looked for among those that models of this scene
---     use, by their content: vertices and indices. A mesh deformed since must get its old form back
---     first. nil: among those that models of `scene` itself use, before it is restored.
--- @raise status ERROR_INVALID_ARGUMENT: for words that are no snapshot of a scene, damaged, of a later
---     format or of another byte order, and if a mesh is missing
--- @raise status ERROR_OUT_OF_MEMORY: if there is no room for it
function Scene:restore(library, words)
    local words, words_count, words_stride = to_array(uint32_t, words)
    local count = common(words_count)
    check(C.gphys_scene_restore(opened(self), library and opened(library), words, count))
end

--- A hash of the whole state except the octree, the low half first; meshes count by their content.
--- Equal states have equal hashes on every machine; different ones differ with near certainty (not
--- against an adversary). Compare it between machines that run the same simulation, to detect when they
--- diverge.
--- Cost: O(n), some 50 ns for each model.
function Scene:get_hash()
    local out_hash = uint32_t.array(2)
    check(C.gphys_scene_get_hash(opened(self), out_hash))
    return out_hash
end

local Camera = runtime.class 'camera'
--- Create a camera at the origin, with the projection and the viewport of its desc.
--- Cost: O(1).
--- @param desc nil: the defaults
function gp.Camera(desc)
    return Camera.create(function(made)
        return C.gphys_camera_create(desc and to_desc(CameraDesc, desc), made)
    end)
end

--- Move the point of the world that the camera's coordinates count from; see Scene:set_origin. The
--- camera and the target of its orbit stay where they are in the world. Picking and culling need a
--- scene of the same origin, else they fail with ERROR_INVALID_ARGUMENT.
--- Cost: O(1).
--- @param origin x, y, z in the world, metres, within MAX_COORDINATE
function Camera:set_origin(origin)
    check(C.gphys_camera_set_origin(opened(self), to_numbers(double, origin, 3)))
end

--- Where in the world the camera's coordinates count from, metres.
--- Cost: O(1).
function Camera:get_origin()
    local out_origin = double.array(3)
    check(C.gphys_camera_get_origin(opened(self), out_origin))
    return out_origin
end

--- Use a perspective projection: distant objects appear smaller.
--- Cost: O(1).
--- @param fov_y full vertical angle in radians, 1e-6 <= fov_y < pi
--- @param near_distance metres, > 0
--- @param far_distance metres, > near_distance; INFINITY allowed
function Camera:set_perspective(fov_y, near_distance, far_distance)
    check(C.gphys_camera_set_perspective(opened(self), real(fov_y, 'fov_y'), real(near_distance, 'near_distance'), real(far_distance, 'far_distance')))
end

--- Use an orthographic projection: the distance does not change apparent size.
--- Cost: O(1).
--- @param height metres seen from top to bottom, >= 1e-6; the width follows from the viewport and is at
---     most twice MAX_COORDINATE
--- @param near_distance metres, may be negative
--- @param far_distance metres, at least 1e-6 above near_distance
function Camera:set_orthographic(height, near_distance, far_distance)
    check(C.gphys_camera_set_orthographic(opened(self), real(height, 'height'), real(near_distance, 'near_distance'), real(far_distance, 'far_distance')))
end

--- Use any projection matrix of the camera's depth range and direction (off-centre, oblique, another
--- library's). It is not changed by Camera:set_viewport.
--- Cost: O(1).
--- @raise status ERROR_SINGULAR: if it has no inverse, or is too close to such a matrix to tell
--- @raise status ERROR_INVALID_ARGUMENT: if a plane other than far lies at infinity, as it does when
---     the matrix is for another depth range, or one lies beyond MAX_COORDINATE
function Camera:set_projection(projection)
    check(C.gphys_camera_set_projection(opened(self), to_value(Mat4, projection)))
end

--- As Camera:set_perspective, with a fixed aspect ratio: the image is stretched to the viewport, as
--- with pixels that are not square, and the viewport does not change what is seen.
--- Cost: O(1). Since 1.1.
--- @param fov_y full vertical angle in radians, 1e-6 <= fov_y < pi
--- @param aspect width over height of what is seen, 1e-6 .. 1e6
--- @param near_distance metres, > 0
--- @param far_distance metres, > near_distance; INFINITY allowed
function Camera:set_perspective_aspect(fov_y, aspect, near_distance, far_distance)
    check(C.gphys_camera_set_perspective_aspect(opened(self), real(fov_y, 'fov_y'), real(aspect, 'aspect'), real(near_distance, 'near_distance'), real(far_distance, 'far_distance')))
end

--- As Camera:set_orthographic, with a width of its own, which the viewport does not change.
--- Cost: O(1). Since 1.1.
--- @param width metres seen from left to right, >= 1e-6
--- @param height metres seen from top to bottom, >= 1e-6
--- @param near_distance metres, may be negative
--- @param far_distance metres, at least 1e-6 above near_distance
function Camera:set_orthographic_size(width, height, near_distance, far_distance)
    check(C.gphys_camera_set_orthographic_size(opened(self), real(width, 'width'), real(height, 'height'), real(near_distance, 'near_distance'), real(far_distance, 'far_distance')))
end

--- Set the size of the viewport. A perspective keeps fov_y, an orthographic projection its height; the
--- call is refused if that makes the width more than twice MAX_COORDINATE.
--- Cost: O(1).
--- @param width pixels, 1e-3 .. 1e6
--- @param height pixels, 1e-3 .. 1e6
function Camera:set_viewport(width, height)
    check(C.gphys_camera_set_viewport(opened(self), real(width, 'width'), real(height, 'height')))
end

--- Where the viewport is in its window, as one of several of a split screen: pixels of all functions
--- count from the window's top left corner. (0, 0) at creation.
--- Cost: O(1). Since 1.1.
--- @param x pixels from the window's left edge to the viewport's
--- @param y pixels from the window's top edge to the viewport's
function Camera:set_viewport_origin(x, y)
    check(C.gphys_camera_set_viewport_origin(opened(self), real(x, 'x'), real(y, 'y')))
end

--- Where the rays of a perspective begin, for all functions that pick. From the near plane at creation;
--- rays of other projections always begin there.
--- Cost: O(1). Since 1.1.
function Camera:set_pick_start(start)
    check(C.gphys_camera_set_pick_start(opened(self), signed(start, 'start')))
end

do
    local out_kind = int32_t.array(1)
    local out_size = float.array(1)
    local out_near = float.array(1)
    local out_far = float.array(1)
    --- How the camera projects, as it was set.
    --- Cost: O(1).
    --- @return what of the following was called last: Camera:set_perspective, as at creation,
    ---     Camera:set_orthographic (or those with a width of their own), or Camera:set_projection. the
    ---     vertical field of view in radians of a perspective, the height in metres of an orthographic
    ---     projection, 0 of a matrix. the distance of the near plane, metres; 0 of a matrix. that of the
    ---     far plane; INFINITY without one; 0 of a matrix.
    function Camera:get_projection()
        check(C.gphys_camera_get_projection(opened(self), out_kind, out_size, out_near, out_far))
        return out_kind[0], out_size[0], out_near[0], out_far[0]
    end
end

do
    local out_width = float.array(1)
    local out_height = float.array(1)
    --- The size of the viewport, in pixels, as it was set. Its width over its height is the aspect of the
    --- image.
    --- Cost: O(1).
    function Camera:get_viewport()
        check(C.gphys_camera_get_viewport(opened(self), out_width, out_height))
        return out_width[0], out_height[0]
    end
end

do
    local out_x = float.array(1)
    local out_y = float.array(1)
    --- Where the viewport is in its window, in pixels, as it was set.
    --- Cost: O(1). Since 1.1.
    function Camera:get_viewport_origin()
        check(C.gphys_camera_get_viewport_origin(opened(self), out_x, out_y))
        return out_x[0], out_y[0]
    end
end

do
    local out_aspect = float.array(1)
    local out_is_fixed = int32_t.array(1)
    --- Width over height of what is seen: as it was set, or else, and always with a matrix, that of the
    --- viewport.
    --- Cost: O(1). Since 1.1.
    --- @return 1 if Camera:set_perspective_aspect or Camera:set_orthographic_size was the last to set the
    ---     projection; 0 if it follows the viewport.
    function Camera:get_aspect()
        check(C.gphys_camera_get_aspect(opened(self), out_aspect, out_is_fixed))
        return out_aspect[0], out_is_fixed[0] ~= 0
    end
end

do
    local out_width = float.array(1)
    local out_height = float.array(1)
    --- Width and height of what is seen, within an ulp: at a distance of one metre by a perspective (twice
    --- the tangents of half the angles; over the viewport's size, what a pixel spans there), at any
    --- distance by an orthographic projection, in metres as they were set; 0 by a matrix.
    --- Cost: O(1). Since 1.1.
    function Camera:get_image_size()
        check(C.gphys_camera_get_image_size(opened(self), out_width, out_height))
        return out_width[0], out_height[0]
    end
end

do
    local out_start = int32_t.array(1)
    --- Where the rays of a perspective begin, as it was set.
    --- Cost: O(1). Since 1.1.
    function Camera:get_pick_start()
        check(C.gphys_camera_get_pick_start(opened(self), out_start))
        return out_start[0]
    end
end

do
    local out_handedness = int32_t.array(1)
    local out_depth_range = int32_t.array(1)
    local out_reverse_z = int32_t.array(1)
    --- What the camera was created with, as in CameraDesc.
    --- Cost: O(1). Since 1.1.
    function Camera:get_conventions()
        check(C.gphys_camera_get_conventions(opened(self), out_handedness, out_depth_range, out_reverse_z))
        return out_handedness[0], out_depth_range[0], out_reverse_z[0] ~= 0
    end
end

--- Place the camera.
--- Cost: O(1).
--- @param position metres, of its centre
--- @param rotation from its own axes to those of the world
function Camera:set_transform(position, rotation)
    check(C.gphys_camera_set_transform(opened(self), to_value(Vec3, position), to_value(Quat, rotation)))
end

--- Place it by a world matrix (camera to world). The axes are made orthonormal (the view direction
--- kept, then up), so that a matrix which drifted is corrected.
--- Cost: O(1).
--- @raise status ERROR_SINGULAR: if the axes do not span space
--- @raise status ERROR_INVALID_ARGUMENT: if they mirror or the last row is not 0 0 0 1
function Camera:set_world_matrix(world)
    check(C.gphys_camera_set_world_matrix(opened(self), to_value(Mat4, world)))
end

--- Place it by a view matrix (world to camera): by the world matrix that is its inverse, as
--- Camera:set_world_matrix. That of Camera:get_view_matrix puts a camera back within 2^-22 of its
--- distance from the origin and 2^-22 rad.
--- Cost: O(1). Since 1.1.
--- @raise status ERROR_SINGULAR: if the axes do not span space
--- @raise status ERROR_INVALID_ARGUMENT: if they mirror, the last row is not 0 0 0 1, or the camera
---     would be beyond MAX_COORDINATE
function Camera:set_view_matrix(view)
    check(C.gphys_camera_set_view_matrix(opened(self), to_value(Mat4, view)))
end

--- Stand at eye and look at target. When up is parallel to the view, a perpendicular direction is
--- chosen in its place, always the same for the same input.
--- Cost: O(1).
--- @raise status ERROR_INVALID_ARGUMENT: if eye equals target or up is zero
function Camera:look_at(eye, target, up)
    check(C.gphys_camera_look_at(opened(self), to_value(Vec3, eye), to_value(Vec3, target), to_value(Vec3, up)))
end

--- The camera's position, in metres, and its rotation, rounded to float32.
--- Cost: O(1).
function Camera:get_transform()
    local out_position = Vec3.new()
    local out_rotation = Quat.new()
    check(C.gphys_camera_get_transform(opened(self), out_position, out_rotation))
    return out_position, out_rotation
end

--- The matrix from camera to world.
--- Cost: O(1).
function Camera:get_world_matrix(out_world)
    out_world = out_world or Mat4.new()
    check(C.gphys_camera_get_world_matrix(opened(self), out_world))
    return out_world
end

--- The matrix from world to camera: the transpose of the orthonormal world axes, and the position
--- transformed by it.
--- Cost: O(1).
function Camera:get_view_matrix(out_view)
    out_view = out_view or Mat4.new()
    check(C.gphys_camera_get_view_matrix(opened(self), out_view))
    return out_view
end

--- The matrix from camera to clip space.
--- Cost: O(1).
function Camera:get_projection_matrix(out_projection)
    out_projection = out_projection or Mat4.new()
    check(C.gphys_camera_get_projection_matrix(opened(self), out_projection))
    return out_projection
end

--- Projection * view, multiplied in double precision and rounded once.
--- Cost: O(1).
function Camera:get_view_projection_matrix(out_view_projection)
    out_view_projection = out_view_projection or Mat4.new()
    check(C.gphys_camera_get_view_projection_matrix(opened(self), out_view_projection))
    return out_view_projection
end

--- Start orbiting with these settings; places the camera at once and drops pending input. An angle or a
--- distance outside its limits is brought inside.
--- Cost: O(1).
function Camera:set_orbit(orbit)
    check(C.gphys_camera_set_orbit(opened(self), to_value(Orbit, orbit)))
end

--- The present settings, angles and distance of the orbit.
--- Cost: O(1).
--- @raise status ERROR_UNSUPPORTED: if the camera was never set to orbit
function Camera:get_orbit(out_orbit)
    out_orbit = out_orbit or Orbit.new()
    check(C.gphys_camera_get_orbit(opened(self), out_orbit))
    return out_orbit
end

--- Set a speed for each input of the orbit, in place of the two of Orbit, which Camera:set_orbit starts
--- from. Input since the last update uses the new speeds.
--- Cost: O(1). Since 1.1.
--- @raise status ERROR_UNSUPPORTED: if the camera was never set to orbit
function Camera:set_orbit_speeds(speeds)
    check(C.gphys_camera_set_orbit_speeds(opened(self), to_value(OrbitSpeeds, speeds)))
end

--- The present speeds of the orbit's inputs.
--- Cost: O(1). Since 1.1.
--- @raise status ERROR_UNSUPPORTED: if the camera was never set to orbit
function Camera:get_orbit_speeds(out_speeds)
    out_speeds = out_speeds or OrbitSpeeds.new()
    check(C.gphys_camera_get_orbit_speeds(opened(self), out_speeds))
    return out_speeds
end

--- Add input to the orbit: yaw by units_x, pitch by units_y, times radians_per_unit or the speeds that
--- were set.
--- Cost: O(1).
--- @param units_x finite, any size
--- @param units_y finite, any size
--- @raise status ERROR_UNSUPPORTED: if the camera was never set to orbit
function Camera:orbit_rotate(units_x, units_y)
    check(C.gphys_camera_orbit_rotate(opened(self), real(units_x, 'units_x'), real(units_y, 'units_y')))
end

--- Add input to the orbit: move closer by units times metres_per_unit or the speed that was set, or
--- away if negative.
--- Cost: O(1).
--- @param units finite, any size
--- @raise status ERROR_UNSUPPORTED: if the camera was never set to orbit
function Camera:orbit_zoom(units)
    check(C.gphys_camera_orbit_zoom(opened(self), real(units, 'units')))
end

--- Add input to the orbit: move the target to the camera's right and up, as the last update left them,
--- by units times metres_per_unit or the speeds that were set.
--- Cost: O(1).
--- @param units_right finite, any size
--- @param units_up finite, any size
--- @raise status ERROR_UNSUPPORTED: if the camera was never set to orbit
function Camera:orbit_pan(units_right, units_up)
    check(C.gphys_camera_orbit_pan(opened(self), real(units_right, 'units_right'), real(units_up, 'units_up')))
end

--- Apply the input since the last update, within the limits, and place the camera. Angles are wrapped
--- to -pi .. pi in constant time.
--- Cost: O(1).
--- @raise status ERROR_UNSUPPORTED: if the camera was never set to orbit
function Camera:orbit_update()
    check(C.gphys_camera_orbit_update(opened(self)))
end

--- The view frustum, with origin at the camera's position and planes from its parameters: each number
--- within 2 ulp. All functions of shapes accept it. A user projection gives its planes by
--- Gribb-Hartmann in double precision.
--- Cost: O(1).
function Camera:get_frustum(out_frustum)
    out_frustum = out_frustum or Frustum.new()
    check(C.gphys_camera_get_frustum(opened(self), out_frustum))
    return out_frustum
end

--- World positions of the corners of the view frustum, in the order of gp.frustum_corners.
--- Cost: O(1).
--- @return nil with an infinite far plane, or a corner beyond the largest float.
function Camera:get_corners()
    local out_corners = Vec3.array(8)
    if found(C.gphys_camera_get_corners(opened(self), out_corners)) then return out_corners end
end

--- What is seen in a rectangle of pixels, as Camera:get_frustum: of a tile, a marquee, a portal.
--- Cost: O(1). Since 1.1.
--- @param x0 pixels, a corner of the rectangle; may lie outside the viewport
--- @param y0 pixels, a corner of the rectangle; may lie outside the viewport
--- @param x1 pixels, the opposite corner, in any order; may lie outside the viewport
--- @param y1 pixels, the opposite corner, in any order; may lie outside the viewport
--- @raise status ERROR_INVALID_ARGUMENT: if the rectangle has no area, or a side of what a matrix shows
---     in it lies at infinity or beyond MAX_COORDINATE
function Camera:get_rectangle_frustum(x0, y0, x1, y1, out_frustum)
    out_frustum = out_frustum or Frustum.new()
    check(C.gphys_camera_get_rectangle_frustum(opened(self), real(x0, 'x0'), real(y0, 'y0'), real(x1, 'x1'), real(y1, 'y1'), out_frustum))
    return out_frustum
end

--- World positions of the corners of what is seen in a rectangle of pixels, as Camera:get_corners.
--- Cost: O(1). Since 1.1.
--- @param x0 as Camera:get_rectangle_frustum
--- @param y0 as Camera:get_rectangle_frustum
--- @param x1 as Camera:get_rectangle_frustum
--- @param y1 as Camera:get_rectangle_frustum
--- @return nil as Camera:get_corners.
function Camera:get_rectangle_corners(x0, y0, x1, y1)
    local out_corners = Vec3.array(8)
    if found(C.gphys_camera_get_rectangle_corners(opened(self), real(x0, 'x0'), real(y0, 'y0'), real(x1, 'x1'), real(y1, 'y1'), out_corners)) then return out_corners end
end

--- World point to pixel, within 1e-3 pixel and 1 ulp, depth within 2^-22. x, y may lie outside the
--- viewport; z is the depth in the camera's range.
--- Cost: O(1).
--- @return nil if the point is not in front of the camera's centre (no image), or its image lies beyond
---     the range of coordinates.
function Camera:project(point, out_pixel)
    out_pixel = out_pixel or Vec3.new()
    if found(C.gphys_camera_project(opened(self), to_value(Vec3, point), out_pixel)) then return out_pixel end
end

--- Pixels of count world points, as Camera:project; a point without an image gets x = y = z = INFINITY.
--- Cost: O(elements).
--- @param points metres
function Camera:project_batch(points, out)
    local points, points_count, points_stride = to_array(Vec3, points)
    local count = common(points_count)
    out = results(Vec3, out, count)
    check(C.gphys_camera_project_batch(opened(self), points, points_stride, count, out, Vec3.size))
    return out
end

--- Pixel and depth to world point: the inverse of Camera:project.
--- Cost: O(1).
--- @return nil for the depth of an infinite far plane, and for points beyond that or beyond the range
---     of coordinates.
function Camera:unproject(pixel, out_point)
    out_point = out_point or Vec3.new()
    if found(C.gphys_camera_unproject(opened(self), to_value(Vec3, pixel), out_point)) then return out_point end
end

--- World points of the pixels with depth, as Camera:unproject; one at infinity gets x = y = z =
--- INFINITY.
--- Cost: O(elements).
--- @param pixels x, y in pixels, z the depth
function Camera:unproject_batch(pixels, out)
    local pixels, pixels_count, pixels_stride = to_array(Vec3, pixels)
    local count = common(pixels_count)
    out = results(Vec3, out, count)
    check(C.gphys_camera_unproject_batch(opened(self), pixels, pixels_stride, count, out, Vec3.size))
    return out
end

--- The ray through a pixel, of unit direction, from the near plane on; t_max ends on the far plane
--- (INFINITY without one). With PICK_FROM_CENTRE that of a perspective starts at the camera's position.
--- Its image is within 1e-3 pixel of the given one or, for fields of view below about 3 degrees, within
--- half an ulp of its direction. Its start is rounded to float32, too, which moves the ray by half an
--- ulp of the coordinates (but not from the camera's position, which has float coordinates);
--- Camera:pick is not limited in this way.
--- Cost: O(1).
--- @param pixel_x pixels; may lie outside the viewport
--- @param pixel_y pixels; may lie outside the viewport
--- @return nil if the line of sight does not meet the near plane (user projections), or would begin
---     beyond MAX_COORDINATE.
function Camera:pick_ray(pixel_x, pixel_y, out_ray)
    out_ray = out_ray or Ray.new()
    if found(C.gphys_camera_pick_ray(opened(self), real(pixel_x, 'pixel_x'), real(pixel_y, 'pixel_y'), out_ray)) then return out_ray end
end

--- Rays for a rectangle of pixel centres, as Camera:pick_ray, row by row.
--- Cost: O(width * height).
--- @param x the left column of the rectangle
--- @param y its top row
--- @param width its columns
--- @param height its rows; width * height fewer than 2^32
function Camera:pick_rays(x, y, width, height, out)
    out = results(Ray, out, width * height)
    check(C.gphys_camera_pick_rays(opened(self), whole(x, 'x'), whole(y, 'y'), whole(width, 'width'), whole(height, 'height'), out, Ray.size))
    return out
end

--- The model under a pixel: the first hit of Camera:pick_ray, before that is rounded to float32; t is
--- in metres from where it starts.
--- Cost: O(log n) expected.
--- @param pixel_x pixels; may lie outside the viewport
--- @param pixel_y pixels; may lie outside the viewport
--- @return nil if nothing is found.
function Camera:pick(scene, pixel_x, pixel_y, layers, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_camera_pick(opened(self), opened(scene), real(pixel_x, 'pixel_x'), real(pixel_y, 'pixel_y'), bits(layers or ALL_LAYERS, 'layers'), out_hit)) then return out_hit end
end

--- The models under the pixels, as Camera:pick; a pixel without one gets model = 0 and t = INFINITY.
--- Cost: at most that of as many single calls; shared among the scene's workers.
--- @param pixels x, y pairs of floats
function Camera:pick_batch(scene, pixels, layers, out)
    local pixels, pixels_count, pixels_stride = to_array(float, pixels, 2)
    local count = common(pixels_count)
    out = results(Hit, out, count)
    check(C.gphys_camera_pick_batch(opened(self), opened(scene), pixels, pixels_stride, count, bits(layers or ALL_LAYERS, 'layers'), out, Hit.size))
    return out
end

--- Marquee: ids of all models in the pixel rectangle, hidden ones included, between near and far plane;
--- tested by their exact shapes, ascending.
--- Cost: that of Scene:overlap.
--- @param x0 pixels, a corner of the rectangle; may lie outside the viewport
--- @param y0 pixels, a corner of the rectangle; may lie outside the viewport
--- @param x1 pixels, the opposite corner, in any order; may lie outside the viewport
--- @param y1 pixels, the opposite corner, in any order; may lie outside the viewport
--- @raise status ERROR_INVALID_ARGUMENT: if the rectangle has no area
function Camera:pick_rectangle(scene, x0, y0, x1, y1, layers)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_camera_pick_rectangle(opened(self), opened(scene), real(x0, 'x0'), real(y0, 'y0'), real(x1, 'x1'), real(y1, 'y1'), bits(layers or ALL_LAYERS, 'layers'), out, capacity, total)
    end)
end

--- Ids of the models to draw: Scene:cull with the camera's frustum.
--- Cost: O(log n + k) expected.
function Camera:cull(scene, layers)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_camera_cull(opened(self), opened(scene), bits(layers or ALL_LAYERS, 'layers'), out, capacity, total)
    end)
end

--- The model under a pixel that the filter sees, as Camera:pick: what lies behind a selection.
--- Cost: as Scene:raycast_filtered.
--- @param pixel_x pixels; may lie outside the viewport
--- @param pixel_y pixels; may lie outside the viewport
--- @param filter nil: the defaults
--- @return nil if nothing is found.
function Camera:pick_filtered(scene, pixel_x, pixel_y, filter, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_camera_pick_filtered(opened(self), opened(scene), real(pixel_x, 'pixel_x'), real(pixel_y, 'pixel_y'), filter and to_desc(QueryFilterDesc, filter), out_hit)) then return out_hit end
end

--- The models under the pixels that the filters see, as Camera:pick_batch.
--- Cost: at most that of as many single calls; shared among the scene's workers.
--- @param pixels x, y pairs of floats
--- @param filters nil: the defaults
function Camera:pick_filtered_batch(scene, pixels, filters, out)
    local pixels, pixels_count, pixels_stride = to_array(float, pixels, 2)
    local filters, filters_count, filters_stride = to_descs(QueryFilterDesc, filters)
    local count = common(pixels_count, filters_count)
    out = results(Hit, out, count)
    check(C.gphys_camera_pick_filtered_batch(opened(self), opened(scene), pixels, pixels_stride, count, filters, filters_stride, out, Hit.size))
    return out
end

--- Marquee: ids of all models in the pixel rectangle that the filter sees, as Camera:pick_rectangle.
--- Cost: as Scene:overlap_filtered.
--- @param x0 pixels, a corner of the rectangle
--- @param y0 pixels, a corner of the rectangle
--- @param x1 pixels, the opposite corner, in any order
--- @param y1 pixels, the opposite corner, in any order
--- @param filter nil: the defaults
function Camera:pick_rectangle_filtered(scene, x0, y0, x1, y1, filter)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_camera_pick_rectangle_filtered(opened(self), opened(scene), real(x0, 'x0'), real(y0, 'y0'), real(x1, 'x1'), real(y1, 'y1'), filter and to_desc(QueryFilterDesc, filter), out, capacity, total)
    end)
end

--- Ids of the models to draw that the filter sees: Scene:cull_filtered with the camera's frustum.
--- Cost: as Scene:cull_filtered.
--- @param filter nil: the defaults
function Camera:cull_filtered(scene, filter)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_camera_cull_filtered(opened(self), opened(scene), filter and to_desc(QueryFilterDesc, filter), out, capacity, total)
    end)
end

local Solver = runtime.class 'solver'
--- Create a solver without bodies. With a worker_count of n, n threads share the bodies of a step; the
--- results have the same bits for every n. Threads are started, joined and lost as those of Scene.
--- Cost: O(1), and that of starting the threads.
--- @param desc nil: the defaults
--- @raise status ERROR_OUT_OF_MEMORY: also if the threads cannot be started
function gp.Solver(desc)
    return Solver.create(function(made)
        return C.gphys_solver_create(desc and to_desc(SolverDesc, desc), made)
    end)
end

--- Change the number of threads that share the steps of a solver, as Scene:set_worker_count. The bits
--- of the motion stay the same.
--- Cost: as Scene:set_worker_count; allocates. Since 1.1.
--- @param workers as SolverDesc.worker_count
--- @raise status ERROR_OUT_OF_MEMORY: also if the threads cannot be started; the former ones are kept
function Solver:set_worker_count(workers)
    check(C.gphys_solver_set_worker_count(opened(self), whole(workers, 'workers')))
end

do
    local out_workers = uint32_t.array(1)
    --- How many threads share the steps of a solver, as Scene:get_worker_count.
    --- Cost: O(1). Since 1.1.
    function Solver:get_worker_count()
        check(C.gphys_solver_get_worker_count(opened(self), out_workers))
        return out_workers[0]
    end
end

--- Move the point of the world that the coordinates of all particles count from; see Scene:set_origin.
--- Particles stay where they are in the world and keep moving as they do. A step and an attachment need
--- a scene of the same origin, else they fail with ERROR_INVALID_ARGUMENT.
--- Cost: O(particles).
--- @param origin x, y, z in the world, metres, within MAX_COORDINATE
--- @raise status ERROR_INVALID_ARGUMENT: also if a particle or an animation target would leave the
---     range of coordinates
function Solver:set_origin(origin)
    check(C.gphys_solver_set_origin(opened(self), to_numbers(double, origin, 3)))
end

--- Where in the world the particles' coordinates count from, metres.
--- Cost: O(1).
function Solver:get_origin()
    local out_origin = double.array(3)
    check(C.gphys_solver_get_origin(opened(self), out_origin))
    return out_origin
end

--- Change the acceleration of all particles, from the next step on. Wakes all bodies if it changes.
--- Cost: O(bodies).
--- @param gravity m/s^2; may be zero
function Solver:set_gravity(gravity)
    check(C.gphys_solver_set_gravity(opened(self), to_value(Vec3, gravity)))
end

--- Change the number of substeps of a step. More substeps: smaller errors, proportionally more time.
--- The error of motion goes with the square of their length. Ropes that move calmly - in a substep no
--- link turns by half a radian, or would swing by one if its ends were pushed - make each in two stages
--- (TR-BDF2; Bank et al. 1985): twice the time, a seventh of the error.
--- Cost: O(1).
--- @param substeps 1 .. 1000
function Solver:set_substeps(substeps)
    check(C.gphys_solver_set_substeps(opened(self), whole(substeps, 'substeps')))
end

--- The settings of a solver as they are.
--- Cost: O(1).
function Solver:get_settings(out_settings)
    out_settings = out_settings or SolverSettings.new()
    check(C.gphys_solver_get_settings(opened(self), out_settings))
    return out_settings
end

--- Change all settings, from the next step on. Read them, change some, and give them back. Bodies wake
--- if gravity or the settings of sleep change. Time that Solver:advance owes beyond the new fixed_step
--- is dropped.
--- Cost: O(bodies).
function Solver:set_settings(settings)
    check(C.gphys_solver_set_settings(opened(self), to_value(SolverSettings, settings)))
end

do
    local out_body = uint32_t.array(1)
    --- Add a body of particles without constraints.
    --- Cost: O(elements).
    --- @param desc nil: the defaults
    --- @param positions metres
    --- @raise status ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies
    function Solver:add_particles(positions, desc)
        local positions, positions_count, positions_stride = to_array(Vec3, positions)
        local count = common(positions_count)
        check(C.gphys_solver_add_particles(opened(self), desc and to_desc(BodyDesc, desc), positions, positions_stride, count, out_body))
        return out_body[0]
    end
end

do
    local out_body = uint32_t.array(1)
    --- Add a rope through the given points, one particle at each.
    --- Cost: O(elements).
    --- @param desc nil: the defaults
    --- @param positions metres
    --- @param link_length rest length of each link in metres; 0: as placed. A length below 1e-9 m counts as
    ---     0. Rigid links get their lengths in the first step, and the particles no speed by it.
    --- @raise status ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies
    function Solver:add_rope(positions, link_length, desc)
        local positions, positions_count, positions_stride = to_array(Vec3, positions)
        local count = common(positions_count)
        check(C.gphys_solver_add_rope(opened(self), desc and to_desc(BodyDesc, desc), positions, positions_stride, count, real(link_length or 0, 'link_length'), out_body))
        return out_body[0]
    end
end

do
    local out_body = uint32_t.array(1)
    --- Add a rectangle of cloth: particle (column, row) is number row * columns + column and stands at
    --- corner + column / (columns - 1) * edge_u + row / (rows - 1) * edge_v. Its constraints, in the order
    --- of their ids, are those from row to row, those from column to column, both diagonals (CLOTH_SHEAR),
    --- and those that resist folding (CLOTH_BEND); Solver:set_constraint_settings makes them softer or
    --- stiffer later.
    --- Cost: O(columns * rows).
    --- @param desc nil: the defaults
    --- @param corner metres
    --- @param edge_u metres, from the corner along a row
    --- @param edge_v metres, from the corner along a column
    --- @param columns >= 2
    --- @param rows >= 2
    --- @raise status ERROR_INVALID_ARGUMENT: if the edges are parallel or zero
    --- @raise status ERROR_CAPACITY: beyond 2^24 - 1 particles, links or bodies
    function Solver:add_cloth(corner, edge_u, edge_v, columns, rows, desc)
        check(C.gphys_solver_add_cloth(opened(self), desc and to_desc(BodyDesc, desc), to_value(Vec3, corner), to_value(Vec3, edge_u), to_value(Vec3, edge_v), whole(columns, 'columns'), whole(rows, 'rows'), out_body))
        return out_body[0]
    end
end

do
    local out_body = uint32_t.array(1)
    --- Add cloth in the form of a mesh: a particle at each vertex, a constraint along each edge, and with
    --- CLOTH_BEND one across each inner edge, whose ids come after those of the edges. Vertices at the same
    --- place stay separate: an edge shorter than 1e-9 m, as at the poles of many imported balls, has a rest
    --- length of 0.
    --- Cost: O(n log n).
    --- @param desc nil: the defaults
    --- @param transform places the mesh; nil is the identity
    --- @raise status ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies
    --- @raise status ERROR_UNSUPPORTED: for a mesh made from a rope or from particles, which has no
    ---     triangles
    function Solver:add_cloth_mesh(mesh, transform, desc)
        check(C.gphys_solver_add_cloth_mesh(opened(self), desc and to_desc(BodyDesc, desc), opened(mesh), transform and to_value(Transform, transform), out_body))
        return out_body[0]
    end
end

--- Remove a body with its constraints and joints. Its id stays invalid. The impulses that it gave in
--- the last step are no longer listed.
--- Cost: O(particles + constraints of the body), O(joints of the solver), and O(bodies that gave
--- impulses to the same models).
function Solver:remove_body(body)
    check(C.gphys_solver_remove_body(opened(self), whole(body, 'body')))
end

--- Ids of all bodies, ascending.
--- Cost: O(bodies).
function Solver:get_bodies()
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_solver_get_bodies(opened(self), out, capacity, total)
    end)
end

--- Ids of the bodies that are asleep, ascending. A body falls asleep at the end of a step when for
--- sleep_time seconds no particle was faster than sleep_speed and no rigid constraint strained by more
--- than sleep_strain; cloth, when its root mean square speed from step to step was no higher, no
--- particle ten times as fast, and strain, without a max_strain, at most 3 %, that of diagonals of
--- cells apart: these yield, on sharp and round models by a tenth and more. Its speed is then 0, it
--- keeps its contacts, and a step costs it one query for models nearby. It wakes in the next step after
--- a model within reach (as far as one could move in a step at 50 m/s) was added, removed or moved, or
--- a model that it is attached to, or after the scene was replaced; and at once by any change of its
--- state, of gravity or of the origin. Cloth is brought to rest, whatever sleep_speed is, once friction
--- holds it on models that stand still and it moves by centimetres a second without sagging further:
--- within a second it is slowed down to 0. It moves again when one of these models or the body changes.
--- Not in wind, with joints, animation targets, clusters or a volume, or near other bodies.
--- Cost: O(bodies).
function Solver:get_sleeping()
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_solver_get_sleeping(opened(self), out, capacity, total)
    end)
end

--- Wake a body; its time of rest begins again.
--- Cost: O(1) a body.
--- @param body 0: all
function Solver:wake(body)
    check(C.gphys_solver_wake(opened(self), whole(body, 'body')))
end

--- The present settings of a body; static_friction as it acts, at least friction.
--- Cost: O(1).
function Solver:get_body_settings(body, out_settings)
    out_settings = out_settings or BodySettings.new()
    check(C.gphys_solver_get_body_settings(opened(self), whole(body, 'body'), out_settings))
    return out_settings
end

--- Change all settings of a body, from the next step on: read them, change some, and give them back.
--- Wakes the body.
--- Cost: O(1); O(particles) when self_collision changes, and it allocates.
function Solver:set_body_settings(body, settings)
    check(C.gphys_solver_set_body_settings(opened(self), whole(body, 'body'), to_value(BodySettings, settings)))
end

--- What a body is made of and how it is solved.
--- Cost: O(1); after a change of constraints O(particles), and it allocates.
function Solver:get_body_info(body, out_info)
    out_info = out_info or BodyInfo.new()
    check(C.gphys_solver_get_body_info(opened(self), whole(body, 'body'), out_info))
    return out_info
end

--- Particle numbers of a cloth's triangles, three each, for drawing. Where cloth tears (Break) they
--- change, and their number does not.
--- Cost: O(triangles).
function Solver:get_triangles(body)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_solver_get_triangles(opened(self), whole(body, 'body'), out, capacity, total)
    end)
end

do
    local out_particle = uint32_t.array(1)
    --- The particle of a body nearest to a point, for example to grab it; of equally near ones the lowest.
    --- Cost: O(1); O(particles) for NO_TRIANGLE. Since 1.1.
    --- @param triangle as in a hit, nearest or penetration of the body's mesh: its corners are compared, of
    ---     a rope the ends of the link, or the particle; NO_TRIANGLE: all particles
    --- @param point metres, in the solver's coordinates: that of the hit
    --- @raise status ERROR_INVALID_ARGUMENT: also if the mesh has no such triangle
    function Solver:get_nearest_particle(body, triangle, point)
        check(C.gphys_solver_get_nearest_particle(opened(self), whole(body, 'body'), whole(triangle, 'triangle'), to_value(Vec3, point), out_particle))
        return out_particle[0]
    end
end

--- Where the particles are, metres.
--- Cost: O(count).
--- @param first the first particle
--- @param count how many from there on; a range beyond the body is ERROR_INVALID_ARGUMENT
function Solver:get_positions(body, first, count, out)
    if first == nil then first = 0 end
    if count == nil then count = math.max(0, self:get_body_info(body).particle_count - whole(first, 'first')) end
    out = results(Vec3, out, count)
    check(C.gphys_solver_get_positions(opened(self), whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), out, Vec3.size))
    return out
end

--- Move particles at once and without collision on the way; velocities stay as they are. Wakes the
--- body. Rigid links that are too long or too short then get their lengths in the next step, and the
--- particles no speed by it. Pinned particles that are moved alone pull the others: during the next
--- step they go evenly from where they were to their new places, as attached ones do. They are placed
--- at once before the body's first step, or if a free particle of the body is placed as well.
--- Cost: O(elements).
--- @param first as in Solver:get_positions
function Solver:set_positions(body, first, positions)
    local positions, positions_count, positions_stride = to_array(Vec3, positions)
    local count = common(positions_count)
    check(C.gphys_solver_set_positions(opened(self), whole(body, 'body'), whole(first, 'first'), count, positions, positions_stride))
end

--- How fast the particles are, m/s.
--- Cost: O(count).
--- @param first as in Solver:get_positions
--- @param count as in Solver:get_positions
--- @return 0 of what is pinned and stands still.
function Solver:get_velocities(body, first, count, out)
    if first == nil then first = 0 end
    if count == nil then count = math.max(0, self:get_body_info(body).particle_count - whole(first, 'first')) end
    out = results(Vec3, out, count)
    check(C.gphys_solver_get_velocities(opened(self), whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), out, Vec3.size))
    return out
end

--- Give particles a velocity, which the next step starts from. Wakes the body. Pinned particles keep 0.
--- Cost: O(elements).
--- @param first as in Solver:get_positions
--- @param velocities m/s
function Solver:set_velocities(body, first, velocities)
    local velocities, velocities_count, velocities_stride = to_array(Vec3, velocities)
    local count = common(velocities_count)
    check(C.gphys_solver_set_velocities(opened(self), whole(body, 'body'), whole(first, 'first'), count, velocities, velocities_stride))
end

--- Masses of particles, kg. That of a pinned particle is what it has when it is released.
--- Cost: O(count).
--- @param first as in Solver:get_positions
--- @param count as in Solver:get_positions
function Solver:get_masses(body, first, count, out)
    if first == nil then first = 0 end
    if count == nil then count = math.max(0, self:get_body_info(body).particle_count - whole(first, 'first')) end
    out = results(float, out, count)
    check(C.gphys_solver_get_masses(opened(self), whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), out, float.size))
    return out
end

--- Change the masses of particles. A pinned particle keeps its mass for the time when it is released.
--- Wakes the body.
--- Cost: O(elements).
--- @param first as in Solver:get_positions
--- @param masses kg, > 0
function Solver:set_masses(body, first, masses)
    local masses, masses_count, masses_stride = to_array(float, masses)
    local count = common(masses_count)
    check(C.gphys_solver_set_masses(opened(self), whole(body, 'body'), whole(first, 'first'), count, masses, masses_stride))
end

--- Collision radii of particles, metres.
--- Cost: O(count).
--- @param first as in Solver:get_positions
--- @param count as in Solver:get_positions
function Solver:get_radii(body, first, count, out)
    if first == nil then first = 0 end
    if count == nil then count = math.max(0, self:get_body_info(body).particle_count - whole(first, 'first')) end
    out = results(float, out, count)
    check(C.gphys_solver_get_radii(opened(self), whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), out, float.size))
    return out
end

--- Change the collision radii of particles. Wakes the body.
--- Cost: O(elements).
--- @param first as in Solver:get_positions
--- @param radii metres, >= 0
function Solver:set_radii(body, first, radii)
    local radii, radii_count, radii_stride = to_array(float, radii)
    local count = common(radii_count)
    check(C.gphys_solver_set_radii(opened(self), whole(body, 'body'), whole(first, 'first'), count, radii, radii_stride))
end

--- Friction factors of particles; 1 until they are set.
--- Cost: O(count). Since 1.1.
--- @param first as in Solver:get_positions
--- @param count as in Solver:get_positions
function Solver:get_friction_factors(body, first, count, out)
    if first == nil then first = 0 end
    if count == nil then count = math.max(0, self:get_body_info(body).particle_count - whole(first, 'first')) end
    out = results(float, out, count)
    check(C.gphys_solver_get_friction_factors(opened(self), whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), out, float.size))
    return out
end

--- Give particles more or less friction than their body has: ice, a sticky hem, a worn patch. In every
--- contact, with models and with particles, the coefficients of a particle are the friction and the
--- static_friction of its body times its factor. A body with a friction of 1 thus has the factors for
--- coefficients; Solver:set_body_settings scales them all and keeps the factors. Wakes the body.
--- Cost: O(elements); the first factor other than 1 O(particles), and it allocates. Since 1.1.
--- @param first as in Solver:get_positions
--- @param factors >= 0
function Solver:set_friction_factors(body, first, factors)
    local factors, factors_count, factors_stride = to_array(float, factors)
    local count = common(factors_count)
    check(C.gphys_solver_set_friction_factors(opened(self), whole(body, 'body'), whole(first, 'first'), count, factors, factors_stride))
end

--- The forces that were set for particles, newtons.
--- Cost: O(count).
--- @param first as in Solver:get_positions
--- @param count as in Solver:get_positions
function Solver:get_forces(body, first, count, out)
    if first == nil then first = 0 end
    if count == nil then count = math.max(0, self:get_body_info(body).particle_count - whole(first, 'first')) end
    out = results(Vec3, out, count)
    check(C.gphys_solver_get_forces(opened(self), whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), out, Vec3.size))
    return out
end

--- Set the forces that act on particles beside gravity, from now on until set again. Wakes the body.
--- Cost: O(elements).
--- @param first as in Solver:get_positions
--- @param forces newtons
function Solver:set_forces(body, first, forces)
    local forces, forces_count, forces_stride = to_array(Vec3, forces)
    local count = common(forces_count)
    check(C.gphys_solver_set_forces(opened(self), whole(body, 'body'), whole(first, 'first'), count, forces, forces_stride))
end

--- Which particles are pinned or attached.
--- Cost: O(count).
--- @param first as in Solver:get_positions
--- @param count as in Solver:get_positions
function Solver:get_pinned(body, first, count, out)
    if first == nil then first = 0 end
    if count == nil then count = math.max(0, self:get_body_info(body).particle_count - whole(first, 'first')) end
    out = results(int32_t, out, count)
    check(C.gphys_solver_get_pinned(opened(self), whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), out, int32_t.size))
    return out
end

--- Pin or release particles. A pinned particle stays where it is put and moves only by
--- Solver:set_positions, or with an animation target of max_distance 0; else its speed is 0. Both
--- pinning and releasing end an attachment.
--- Cost: O(count).
--- @param first as in Solver:get_positions
--- @param count as in Solver:get_positions
--- @param pinned 1: pin; 0: release
function Solver:set_pinned(body, first, count, pinned)
    if first == nil then first = 0 end
    if count == nil then count = math.max(0, self:get_body_info(body).particle_count - whole(first, 'first')) end
    if pinned == nil then pinned = true end
    check(C.gphys_solver_set_pinned(opened(self), whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), to_flag(pinned, 'pinned')))
end

--- Put a body into moving air. Until this is called there is none. Wakes the body. With u the velocity
--- relative to the air, the force is on a triangle of cloth -rho/2 A |u| ((C_D cos a - C_L cos^2 a) u +
--- C_L (u . n) n), cos a = |u . n| / |u|, the first term not below 0: drag as A cos a, which is what
--- the wind sees of it, and lift across the wind as sin a cos a (Keckeisen et al. 2004, "Modelling
--- effects of wind fields in cloth animations"); with C_L = C_D it is nearly the pressure on a plate,
--- along n; on a link of a rope -rho/2 C_D 2 r l |u'| u', u' the part of u across it, r the radius (the
--- cross-flow principle: Hoerner 1965, "Fluid-dynamic drag"); on a free particle -rho/2 C_D pi r^2 |u|
--- u. Strong wind carries bodies along but never overshoots: whatever the density, a substep does not
--- reverse u. The drag of a free particle is of second order in the substep; that of a link is the one
--- at the beginning of the step.
--- Cost: O(1) a body; in each substep of cloth some 370 instructions a triangle, in each step of a rope
--- as many for each link; some 100 for each free particle, as often as drag takes 1/32 of a speed.
--- @param body 0: all bodies there are
--- @param wind of density 0: no air
function Solver:set_wind(body, wind)
    check(C.gphys_solver_set_wind(opened(self), whole(body, 'body'), to_value(Wind, wind)))
end

--- The air around a body as it was set; zeros if it was not.
--- Cost: O(1).
function Solver:get_wind(body, out_wind)
    out_wind = out_wind or Wind.new()
    check(C.gphys_solver_get_wind(opened(self), whole(body, 'body'), out_wind))
    return out_wind
end

--- Give the air at particles a velocity beside that of Wind, from now on until set again: gusts,
--- eddies, a field of your own that is sampled at the particles' positions. Wakes the body.
--- Cost: O(elements); the first time O(particles), and it allocates.
--- @param first as in Solver:get_positions
--- @param velocities m/s
function Solver:set_air_velocities(body, first, velocities)
    local velocities, velocities_count, velocities_stride = to_array(Vec3, velocities)
    local count = common(velocities_count)
    check(C.gphys_solver_set_air_velocities(opened(self), whole(body, 'body'), whole(first, 'first'), count, velocities, velocities_stride))
end

--- Velocities of the air at particles, m/s, beside that of Wind.
--- Cost: O(count).
--- @param first as in Solver:get_positions
--- @param count as in Solver:get_positions
function Solver:get_air_velocities(body, first, count, out)
    if first == nil then first = 0 end
    if count == nil then count = math.max(0, self:get_body_info(body).particle_count - whole(first, 'first')) end
    out = results(Vec3, out, count)
    check(C.gphys_solver_get_air_velocities(opened(self), whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), out, Vec3.size))
    return out
end

--- Give particles animation targets, before each step that is to follow an animation: a cape or skirt
--- that is skinned to its character stays within max_distance of the skinned vertices and does not sink
--- into the body behind them. In the next step position and normal go evenly from the old target to the
--- new one, substep by substep; distances act at once. A target that is not set again stands still. A
--- first target, and that of a particle which Solver:set_positions has moved since the last step, takes
--- effect at its new place at once: to teleport, make that call and this one. If the body is attached
--- to a model that jumps (Solver:step), this call alone is enough. max_distance 0 carries a particle:
--- it is at its target, as if attached there, and moves links with infinite mass; this also moves a
--- pinned particle, which stays pinned, at constant speed during a step. Otherwise particles that are
--- pinned or attached are not moved. A particle that is out of its bounds at the end of a substep is
--- put on the nearest place within both, without friction; its velocity across them is then that of the
--- target. What lies within its bounds is not touched. Bounds act after constraints and before models:
--- where a target is inside a model, or behind one, the particle stays outside. Links yield to bounds
--- that contradict them. What hangs from a particle at its bounds is carried, in cloth and in ropes
--- that are moved alone; ropes and free particles that are joined, or collide with bodies, are put back
--- particle by particle, and links beside these may be strained by the motion of a substep. Wakes the
--- body if a target changes.
--- Cost: O(elements); the first time O(particles), and it allocates. In each substep some 100 ns a
--- particle; ropes with targets are solved one by one, as those that touch models. Since 1.1.
--- @param first as in Solver:get_positions
--- @param targets max_distance and backstop INFINITY: no target any more
function Solver:set_animation_targets(body, first, targets)
    local targets, targets_count, targets_stride = to_array(AnimationTarget, targets)
    local count = common(targets_count)
    check(C.gphys_solver_set_animation_targets(opened(self), whole(body, 'body'), whole(first, 'first'), count, targets, targets_stride))
end

--- Animation targets of particles as they were set; 0 and INFINITY of what has none.
--- Cost: O(count). Since 1.1.
--- @param first as in Solver:get_positions
--- @param count as in Solver:get_positions
function Solver:get_animation_targets(body, first, count, out)
    if first == nil then first = 0 end
    if count == nil then count = math.max(0, self:get_body_info(body).particle_count - whole(first, 'first')) end
    out = results(AnimationTarget, out, count)
    check(C.gphys_solver_get_animation_targets(opened(self), whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), out, AnimationTarget.size))
    return out
end

--- Fix a particle to a model: it follows the model's transform in each step, and is released when the
--- model is gone. Steps must then be given this scene; in a step without one the particle stays where
--- it is. If the model jumps (Solver:step), the whole body goes with it as if it were rigid, and its
--- velocities turn with it: a cape stays on a character that respawns. Bodies with other pinned
--- particles, joints, or attachments to models that go elsewhere do not, nor do bodies without
--- constraints.
--- Cost: O(1); allocates.
--- @param scene of the same origin as the solver; not modified
--- @param local_point in the model's coordinates, to which its transform applies, with the transform's
---     scale, and not Scene:set_scale; nil: where the particle is now
--- @raise status ERROR_INVALID_ARGUMENT: for a particle that does not exist
function Solver:attach(scene, body, particle, model, local_point)
    check(C.gphys_solver_attach(opened(self), opened(scene), whole(body, 'body'), whole(particle, 'particle'), whole(model, 'model'), local_point and to_value(Vec3, local_point)))
end

--- Release an attached particle.
--- Cost: O(1).
--- @raise status ERROR_INVALID_ARGUMENT: if it is not attached, or does not exist
function Solver:detach(body, particle)
    check(C.gphys_solver_detach(opened(self), whole(body, 'body'), whole(particle, 'particle')))
end

--- The attachments of a body, by particle. One to a model that is gone is listed until the next step.
--- Cost: O(attachments). Since 1.1.
function Solver:get_attachments(body)
    return list(Attachment, function(out, capacity, total)
        return C.gphys_solver_get_attachments(opened(self), whole(body, 'body'), out, capacity, total)
    end)
end

do
    local out_constraint = uint32_t.array(1)
    --- Hold two different particles of a body at a distance.
    --- Cost: O(1); the next step plans the body again, O(constraints).
    --- @param rest_length metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
    --- @param compliance metres per newton, >= 0; 0 is rigid
    --- @raise status ERROR_INVALID_ARGUMENT: for a particle that does not exist or twice the same one
    --- @raise status ERROR_CAPACITY: beyond 2^24 - 1 constraints of a body
    function Solver:add_distance(body, particle_a, particle_b, rest_length, compliance)
        check(C.gphys_solver_add_distance(opened(self), whole(body, 'body'), whole(particle_a, 'particle_a'), whole(particle_b, 'particle_b'), real(rest_length, 'rest_length'), real(compliance or 0, 'compliance'), out_constraint))
        return out_constraint[0]
    end
end

do
    local out_constraint = uint32_t.array(1)
    --- Keep two different particles of a body from being further apart than a length, like a string between
    --- them: it pulls and never pushes. While it is slack it does nothing; when it becomes taut, and is
    --- rigid, only the speed at which the particles separate is lost.
    --- Fails as Solver:add_distance.
    --- It is a constraint like others: listed with max_length as its rest_length, removed as they are, and
    --- strained only when it is too long.
    --- Cost: as Solver:add_distance.
    --- @param max_length metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
    --- @param compliance metres per newton, >= 0, of what it yields beyond that; 0 is rigid
    function Solver:add_max_distance(body, particle_a, particle_b, max_length, compliance)
        check(C.gphys_solver_add_max_distance(opened(self), whole(body, 'body'), whole(particle_a, 'particle_a'), whole(particle_b, 'particle_b'), real(max_length, 'max_length'), real(compliance or 0, 'compliance'), out_constraint))
        return out_constraint[0]
    end
end

--- Damp a constraint that has compliance: when its ends separate at speed v, it pulls with damping * v
--- in addition to its tension; one of Solver:add_max_distance never pushes. The decay depends on time,
--- not on steps. Rigid constraints have nothing to damp.
--- Cost: as Solver:add_distance.
--- @param damping N s/m, >= 0; 0, which every constraint begins with: none
--- @raise status ERROR_INVALID_ID: for a body or constraint that does not exist
function Solver:set_constraint_damping(body, constraint, damping)
    check(C.gphys_solver_set_constraint_damping(opened(self), whole(body, 'body'), whole(constraint, 'constraint'), real(damping, 'damping')))
end

--- Hold the volume that the triangles of a cloth enclose, as air in a ball does. One volume a body;
--- setting it again changes it, which inflates a body.
--- Cost: O(triangles) in each substep, twice. Allocates.
--- @param rest_volume m^3, > 0; negative: the present volume
--- @param compliance m^3 per pascal, >= 0: the volume that a pressure of one pascal takes; 0: as water,
---     which keeps its volume; INFINITY: none, which ends the constraint
--- @raise status ERROR_UNSUPPORTED: if the triangles do not close (each side is that of two triangles),
---     are not oriented consistently, or face inward when the present volume is asked for
function Solver:set_volume(body, rest_volume, compliance)
    check(C.gphys_solver_set_volume(opened(self), whole(body, 'body'), real(rest_volume, 'rest_volume'), real(compliance or 0, 'compliance')))
end

do
    local out_volume = float.array(1)
    local out_pressure = float.array(1)
    --- The volume held by Solver:set_volume, m^3, as it is, and the pressure in pascals with which it was
    --- held at the end of the last step: above 0 it pushes outward.
    --- Cost: O(triangles).
    --- @raise status ERROR_UNSUPPORTED: if none is held
    function Solver:get_volume(body)
        check(C.gphys_solver_get_volume(opened(self), whole(body, 'body'), out_volume, out_pressure))
        return out_volume[0], out_pressure[0]
    end
end

do
    local out_rest_volume = float.array(1)
    local out_compliance = float.array(1)
    --- What was given to Solver:set_volume: m^3 (for a negative volume the one at that time), and m^3 per
    --- pascal.
    --- Cost: O(1). Since 1.1.
    --- @raise status ERROR_UNSUPPORTED: if none is held
    function Solver:get_volume_settings(body)
        check(C.gphys_solver_get_volume_settings(opened(self), whole(body, 'body'), out_rest_volume, out_compliance))
        return out_rest_volume[0], out_compliance[0]
    end
end

--- Remove a constraint of a body, even one created with it. Its id stays invalid. Wakes the body. The
--- triangles of cloth stay together: Solver:break_constraint tears them apart.
--- Cost: as Solver:add_distance; allocates.
--- @raise status ERROR_INVALID_ID: for a body or constraint that does not exist, or no longer
function Solver:remove_constraint(body, constraint)
    check(C.gphys_solver_remove_constraint(opened(self), whole(body, 'body'), whole(constraint, 'constraint')))
end

--- All constraints of a body, including those created with the body, by id.
--- Cost: O(constraints).
function Solver:get_constraints(body)
    return list(ConstraintInfo, function(out, capacity, total)
        return C.gphys_solver_get_constraints(opened(self), whole(body, 'body'), out, capacity, total)
    end)
end

--- Which constraints keep a length, and which a maximum.
--- Cost: O(elements). Since 1.1.
--- @param constraints the ids; one may appear twice
function Solver:get_constraint_kinds(body, constraints, out)
    local constraints, constraints_count, constraints_stride = to_array(uint32_t, constraints)
    local count = common(constraints_count)
    out = results(int32_t, out, count)
    check(C.gphys_solver_get_constraint_kinds(opened(self), whole(body, 'body'), constraints, count, out, int32_t.size))
    return out
end

--- The present settings of constraints.
--- Cost: O(elements).
--- @param constraints the ids; one may appear twice
function Solver:get_constraint_settings(body, constraints, out)
    local constraints, constraints_count, constraints_stride = to_array(uint32_t, constraints)
    local count = common(constraints_count)
    out = results(ConstraintSettings, out, count)
    check(C.gphys_solver_get_constraint_settings(opened(self), whole(body, 'body'), constraints, count, out, ConstraintSettings.size))
    return out
end

--- Change constraints while they act, all or none: winches, muscles. A rest length goes from the old to
--- the new one at constant speed during the next step; a winch that reels in at v m/s is given a length
--- that is v dt shorter before each step of dt. Wakes the body.
--- Cost: O(elements); in the next step O(constraints) to pack them again, of rigid cloth with pins that
--- gets longer links O(n log n). Chains are not planned again. Allocates.
--- @param constraints the ids; one that appears twice gets the last
function Solver:set_constraint_settings(body, constraints, settings)
    local constraints, constraints_count, constraints_stride = to_array(uint32_t, constraints)
    local settings, settings_count, settings_stride = to_array(ConstraintSettings, settings)
    local count = common(constraints_count, settings_count)
    check(C.gphys_solver_set_constraint_settings(opened(self), whole(body, 'body'), constraints, settings, settings_stride, count))
end

do
    local out_cluster = uint32_t.array(1)
    --- Make particles of a body a rigid cluster: they keep the shape in which they are now, and move and
    --- turn as one stiff part, such as a plank of a bridge, a crate or a plate of armour. Links between
    --- them are not needed. A particle may be in several clusters: planks with two particles in common are
    --- hinged there, with one they are jointed. The mass of a cluster is that of its particles; hollow
    --- shapes are light in the middle. Particles that are pinned or attached stay where they are held: with
    --- one the cluster swings about it, with two about the line through them, and with three that are not
    --- on a line it does not move. Models that particles are attached to get the impulses. Contacts with
    --- models move the cluster as a whole, with friction; only particles touch, not the faces between them,
    --- so they should be no further apart than the thickness of the thinnest thing that a cluster meets. It
    --- bounces as a whole, too; one that is held, joined, or shares particles shows only the share of its
    --- restitution that its particles in contact have of its mass. A shape is matched once in each substep,
    --- after the links: then what hangs from it by links may be strained a little, and clusters that share
    --- particles approach their shapes in eight passes. What is joined to it by Solver:join is solved
    --- together with it, unless one of its particles is attached, or another cluster has it, too: hang
    --- heavy loads, or a light cluster under a heavy load, by joints. Bodies with clusters are solved as
    --- cloth (SOLVE_GRAPH), ropes and free particles too. The rest positions of cloth are not changed by a
    --- cluster.
    --- Cost: O(particles); allocates. In each substep about 1 us a cluster, 50 ns a particle of it and 0.3
    --- us one that touches a model, and up to eight times that if clusters of the body share particles; the
    --- first and the last cluster plan the body again, O(constraints). Since 1.1.
    --- @param particles count different particles, at least 2
    --- @raise status ERROR_INVALID_ARGUMENT: for a particle that does not exist or appears twice
    --- @raise status ERROR_CAPACITY: beyond 2^24 - 1 clusters of a body, or that many particles in them
    function Solver:add_cluster(body, particles)
        local particles, particles_count, particles_stride = to_array(uint32_t, particles)
        local count = common(particles_count)
        check(C.gphys_solver_add_cluster(opened(self), whole(body, 'body'), particles, count, out_cluster))
        return out_cluster[0]
    end
end

--- End a cluster. Its particles stay where they are; its id stays invalid. Wakes the body.
--- Cost: O(particles in clusters of the body). Since 1.1.
--- @raise status ERROR_INVALID_ID: for a body or cluster that does not exist, or no longer
function Solver:remove_cluster(body, cluster)
    check(C.gphys_solver_remove_cluster(opened(self), whole(body, 'body'), whole(cluster, 'cluster')))
end

--- All clusters of a body, by id.
--- Cost: O(clusters). Since 1.1.
function Solver:get_clusters(body)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_solver_get_clusters(opened(self), whole(body, 'body'), out, capacity, total)
    end)
end

--- The particles of a cluster, in the order in which they were given.
--- Cost: O(particles of the cluster). Since 1.1.
--- @raise status ERROR_INVALID_ID: for a body or cluster that does not exist, or no longer
function Solver:get_cluster_particles(body, cluster)
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_solver_get_cluster_particles(opened(self), whole(body, 'body'), whole(cluster, 'cluster'), out, capacity, total)
    end)
end

do
    local out_joint = uint32_t.array(1)
    --- Hold a particle of one body and a particle of another at a distance. Both are moved, by forces that
    --- are equal and opposite; either may be pinned or attached. Joined ropes, free particles and rigid
    --- clusters are solved as one system, as stiff as one rope; a joined particle of cloth has the inertia
    --- of all that hangs on it. Free particles of a joined body are moved by the time scheme of ropes, no
    --- longer exactly. Joined bodies are moved by one thread and fall asleep and wake together. A joint is
    --- removed with either body. Particles of the two that are linked to a joint within touch of each other
    --- do not collide there.
    --- Cost: the next step plans all joined ropes again. A link of them takes 2.5 to 4 times as long as one
    --- of a rope that is not joined. Allocates.
    --- @param rest_length metres; 0: at the same place, as below 1e-9; negative: the present distance.
    ---     Particles at another distance are moved to it in the next step; by a rigid joint without speed.
    --- @param compliance metres per newton, >= 0; 0 is rigid
    --- @raise status ERROR_INVALID_ARGUMENT: for a particle that does not exist or twice the same body (see
    ---     Solver:add_distance)
    --- @raise status ERROR_CAPACITY: beyond 2^24 - 1 joints
    function Solver:join(body_a, particle_a, body_b, particle_b, rest_length, compliance)
        check(C.gphys_solver_join(opened(self), whole(body_a, 'body_a'), whole(particle_a, 'particle_a'), whole(body_b, 'body_b'), whole(particle_b, 'particle_b'), real(rest_length, 'rest_length'), real(compliance or 0, 'compliance'), out_joint))
        return out_joint[0]
    end
end

--- End a joint. Wakes both bodies.
--- Cost: as Solver:join.
--- @raise status ERROR_INVALID_ID: for a joint that does not exist, or no longer
function Solver:unjoin(joint)
    check(C.gphys_solver_unjoin(opened(self), whole(joint, 'joint')))
end

--- Joints of a body, by id.
--- Cost: O(joints of the solver).
--- @param body 0: of all bodies
function Solver:get_joints(body)
    return list(JointInfo, function(out, capacity, total)
        return C.gphys_solver_get_joints(opened(self), whole(body, 'body'), out, capacity, total)
    end)
end

--- Breaking forces of constraints. Wakes the body.
--- Cost: O(elements + constraints); of cloth that gets its first or loses its last one also that of a
--- pin. Allocates. Since 1.1.
--- @param constraints the ids; one that appears twice gets the last
--- @param forces newtons, >= 0; 0: never breaks, as all that are added to a body later
function Solver:set_breaking_forces(body, constraints, forces)
    local constraints, constraints_count, constraints_stride = to_array(uint32_t, constraints)
    local forces, forces_count, forces_stride = to_array(float, forces)
    local count = common(constraints_count, forces_count)
    check(C.gphys_solver_set_breaking_forces(opened(self), whole(body, 'body'), constraints, forces, forces_stride, count))
end

--- What Solver:set_breaking_forces or BodyDesc.breaking_force has set; 0: never breaks.
--- Cost: O(elements). Since 1.1.
--- @param constraints the ids; one may appear twice
--- @return newtons.
function Solver:get_breaking_forces(body, constraints, out)
    local constraints, constraints_count, constraints_stride = to_array(uint32_t, constraints)
    local count = common(constraints_count)
    out = results(float, out, count)
    check(C.gphys_solver_get_breaking_forces(opened(self), whole(body, 'body'), constraints, count, out, float.size))
    return out
end

--- Break a constraint as a load would, whatever its breaking force: scissors, claws. Wakes the body.
--- Cost: O(particles + constraints); allocates. Since 1.1.
--- @return what came of it.
--- @raise status ERROR_UNSUPPORTED: and nothing has changed, for an edge where the cloth cannot part:
---     of a triangle that is connected to no other
--- @raise status ERROR_CAPACITY: beyond 2^24 - 1 particles or constraints
function Solver:break_constraint(body, constraint, out_result)
    out_result = out_result or Break.new()
    check(C.gphys_solver_break_constraint(opened(self), whole(body, 'body'), whole(constraint, 'constraint'), out_result))
    return out_result
end

--- Constraints that broke in the last Solver:step or Solver:advance, in its order: for sounds, dust,
--- and to know that a body has more particles. Not those that the caller broke. They are not part of
--- snapshots: after Solver:restore there are none.
--- Cost: O(breaks); no allocation. The same bits for any number of workers. Since 1.1.
function Solver:get_breaks()
    return list(Break, function(out, capacity, total)
        return C.gphys_solver_get_breaks(opened(self), out, capacity, total)
    end)
end

--- Simulate dt seconds in the set number of substeps, or as many as the error targets ask for; cloth
--- takes more where they would be longer than 25 ms.
--- Particles do not pass through models, whatever their speed, nor models that move at up to 50 m/s
--- through particles. A model moves evenly from its place at the last step to its present one, unless
--- it jumps: it turns by a right angle or more, its velocity changes by more than 50 m/s to more than
--- that, or its surface does by a change of scale. One that jumps is not swept and gives no speed. What
--- is then within a solid is pushed out slowly; what is then behind a plane or a mesh stays there.
--- Allocates when what it steps has changed.
--- Cost: O(particles + constraints) a substep, and a scene query for particles near models; O(1) and a
--- scene query for a body that the last step, of the same dt, left exactly as it was.
--- @param scene to collide with and to follow attachments; nil: none. Not modified.
--- @param dt seconds, 1e-6 .. 0.5
function Solver:step(scene, dt)
    check(C.gphys_solver_step(opened(self), scene and opened(scene), real(dt, 'dt')))
end

do
    local out_steps = uint32_t.array(1)
    local out_leftover = float.array(1)
    --- Simulate a frame of any length in steps of fixed_step; what is left over is kept for the next frame,
    --- so the motion does not depend on the frame rate. Models, pins and animation targets are given the
    --- places of the end of the frame. They move there evenly in the time since the last step: attached
    --- particles, pins and what lies on models are at their places of the time that the solver has reached,
    --- leftover of a step before that of the frame. Impulses, contacts and breaks are those of the last
    --- step.
    --- Cost: that of the steps made.
    --- @param frame_time seconds, >= 0
    --- @return steps made. 0 <= fraction of a step still owed < 1, to interpolate when drawing.
    --- @raise status ERROR_OUT_OF_MEMORY: if there is none for the first step: nothing has changed. If
    ---     there is none for a later one
    function Solver:advance(scene, frame_time)
        check(C.gphys_solver_advance(opened(self), scene and opened(scene), real(frame_time, 'frame_time'), out_steps, out_leftover))
        return out_steps[0], out_leftover[0]
    end
end

do
    local out_leftover = float.array(1)
    --- The fraction of a step that Solver:advance still owes: what it gave last as leftover, unless the
    --- solver was restored or given another fixed_step since.
    --- Cost: O(1). Since 1.1.
    --- @return from 0 to below 1.
    function Solver:get_leftover()
        check(C.gphys_solver_get_leftover(opened(self), out_leftover))
        return out_leftover[0]
    end
end

do
    local out_substeps = uint32_t.array(1)
    --- The substeps that a body took in the last step; 0 before its first. With SolverDesc.max_strain or
    --- tolerance set, each body takes as many as its own motion needs: their length follows from what the
    --- last step measured, the largest strain of its rigid constraints and the local error of the time
    --- scheme, both proportional to the square of that length. It is at most quartered and grows by at most
    --- an eighth from one step to the next, so a sudden impact exceeds a target for a few steps; one of
    --- strain only where links of cloth cannot be relaxed below it. A target that cannot be met takes
    --- max_substeps, unless the strain of cloth stays above eight times the target. Where positions jump,
    --- by contacts, the error is that of the jump. What may meet others takes at least the set number.
    --- Cost: O(1).
    function Solver:get_substeps(body)
        check(C.gphys_solver_get_substeps(opened(self), whole(body, 'body'), out_substeps))
        return out_substeps[0]
    end
end

--- Counts, strain and energy of a body at present.
--- Cost: O(particles + constraints).
--- @param body 0: all bodies together
function Solver:get_stats(body, out_stats)
    out_stats = out_stats or SolverStats.new()
    check(C.gphys_solver_get_stats(opened(self), whole(body, 'body'), out_stats))
    return out_stats
end

--- Contacts of the last step by body, particle, model.
--- Cost: O(contacts).
function Solver:get_contacts()
    return list(Contact, function(out, capacity, total)
        return C.gphys_solver_get_contacts(opened(self), out, capacity, total)
    end)
end

--- Contacts between bodies in the last step, of any substep, by body_a, particle_a, body_b, particle_b:
--- for sounds, damage and sparks. Of sleeping bodies those of the step in which they fell asleep.
--- Contacts with a body that was removed are no longer listed. They are not part of snapshots: after
--- Solver:restore there are none until the next step. Contacts within a body (BodyDesc.self_collision)
--- are not listed. where particles have more than 12 contacts on average, not all are known.
--- Cost: O(contacts); no allocation. The same bits for any number of workers. Since 1.1.
function Solver:get_body_contacts()
    return list(BodyContact, function(out, capacity, total)
        return C.gphys_solver_get_body_contacts(opened(self), out, capacity, total)
    end)
end

--- Impulses of the last step, of all bodies together, by model; of sleeping bodies those of the step in
--- which they fell asleep. After Solver:advance, times the steps that it made, they are those of the
--- frame. Divided by dt they are mean forces: what lies on a model presses on it with its weight. A
--- particle of cloth that touches several models at once gives its impulse to the one that it touches
--- most. Models have no mass here: the step does as if they went where you put them, whatever the
--- force. So a rope between a held end and a body of yours must be elastic, its stiffness times dt^2
--- well below the mass of the body, which needs some damping; a body of yours much lighter than what
--- hangs from it should be moved in small steps.
--- Cost: O(models touched); no allocation. The same bits for any number of workers.
function Solver:get_impulses()
    return list(Impulse, function(out, capacity, total)
        return C.gphys_solver_get_impulses(opened(self), out, capacity, total)
    end)
end

--- Copy the whole state out: settings, origin, bodies with their ids, constraints, contacts and
--- impulses, time that Solver:advance still owes. The scene, workers and allocator are not in it.
--- Cost: O(particles + constraints), some 50 words for each.
--- @return the snapshot. It is for the same release of the library and machines of the same byte order;
---     it may be stored, but not changed.
--- @raise status ERROR_CAPACITY: beyond 2^32 - 1 words
function Solver:get_snapshot()
    return list(uint32_t, function(out, capacity, total)
        return C.gphys_solver_get_snapshot(opened(self), out, capacity, total)
    end)
end

--- Replace the whole state by that of a snapshot, of this or of another solver. Ids are those of the
--- time of the snapshot. Steps continue with the same bits as they did then, provided that the scene,
--- too, is as it was. On an error the solver is as before. Any words are safe, also from an untrusted
--- source: all that is used as a number or an index is checked first. Forged words are refused, or
--- taken as a state whose numbers are in range.
--- Cost: as Solver:get_snapshot; allocates.
--- @raise status ERROR_INVALID_ARGUMENT: for words that are no snapshot, damaged, of another version or
---     byte order
--- @raise status ERROR_OUT_OF_MEMORY: if there is no room for it
function Solver:restore(words)
    local words, words_count, words_stride = to_array(uint32_t, words)
    local count = common(words_count)
    check(C.gphys_solver_restore(opened(self), words, count))
end

--- A hash of the whole state, the low half first. Equal states have equal hashes on every machine;
--- different ones differ with near certainty (not against an adversary). Compare it between machines
--- that run the same simulation, to detect when they diverge.
--- Cost: O(particles + constraints).
function Solver:get_hash()
    local out_hash = uint32_t.array(2)
    check(C.gphys_solver_get_hash(opened(self), out_hash))
    return out_hash
end

--- Whether the fields of the shape are in the ranges stated beside its struct.
--- Cost: O(1).
--- @raise status ERROR_INVALID_ARGUMENT: and the error's message names the field
function gp.validate(shape)
    check(C.gphys_shape_validate(kind(shape), address(shape)))
end

--- The smallest float box that holds the shape: each side rounded outward, by at most 1 ulp.
--- Cost: O(1), for a mesh too.
--- @return nil for a plane, a ray without end (or with one beyond all floats) and a frustum that
---     extends to infinity; for an empty mesh or frustum.
function gp.bounds(shape, out_bounds)
    out_bounds = out_bounds or Aabb.new()
    if found(C.gphys_shape_bounds(kind(shape), address(shape), out_bounds)) then return out_bounds end
end

do
    local out_contains = int32_t.array(1)
    --- Whether the point is within tolerance metres of the shape (solid or surface). With tolerance 0 the
    --- answer is exact: on the plane, on the segment, inside the box (an OBB's axes are those of its
    --- rotation in double precision). Others are as gp.overlaps with a sphere.
    --- Cost: O(1); O(log n) expected for a mesh.
    --- @param tolerance metres, >= 0
    function gp.contains(shape, point, tolerance)
        check(C.gphys_shape_contains(kind(shape), address(shape), to_value(Vec3, point), real(tolerance or 0, 'tolerance'), out_contains))
        return out_contains[0] ~= 0
    end
end

--- Whether each of the points is within tolerance metres of one shape, as gp.contains.
--- Cost: that of as many single calls.
--- @param tolerance metres, >= 0, for all points
function gp.contains_batch(shape, points, tolerance, out)
    local points, points_count, points_stride = to_array(Vec3, points)
    local count = common(points_count)
    out = results(int32_t, out, count)
    check(C.gphys_shape_contains_batch(kind(shape), address(shape), points, points_stride, count, real(tolerance or 0, 'tolerance'), out, int32_t.size))
    return out
end

--- The point of the shape that is closest to the given point: the point itself inside a solid. Error: 1
--- ulp of the largest coordinate per axis, the distance 1 ulp and 2^-40 of the largest coordinate
--- difference. If several are equally close, one of them, always the same. For a ray, t is limited by
--- t_max.
--- Cost: O(1); O(log n) expected for a mesh.
--- @return nil only for an empty mesh or an empty frustum.
function gp.closest_point(shape, point, out_nearest)
    out_nearest = out_nearest or Nearest.new()
    if found(C.gphys_shape_closest_point(kind(shape), address(shape), to_value(Vec3, point), out_nearest)) then return out_nearest end
end

--- The points of one shape that are closest to each of the points, as gp.closest_point. An element for
--- which there is none gets distance INFINITY.
--- Cost: that of as many single calls.
function gp.closest_point_batch(shape, points, out)
    local points, points_count, points_stride = to_array(Vec3, points)
    local count = common(points_count)
    out = results(Nearest, out, count)
    check(C.gphys_shape_closest_point_batch(kind(shape), address(shape), points, points_stride, count, out, Nearest.size))
    return out
end

do
    local out_distance = float.array(1)
    --- The closest points of two segments and their distance. Parallel segments have many: the first along
    --- a, always the same.
    --- Cost: O(1).
    --- @return metres.
    function gp.segment_closest_points(a, b)
        local out_a = Vec3.new()
        local out_b = Vec3.new()
        check(C.gphys_segment_closest_points(to_value(Segment, a), to_value(Segment, b), out_a, out_b, out_distance))
        return out_a, out_b, out_distance[0]
    end
end

do
    local out_overlaps = int32_t.array(1)
    --- Whether two shapes have a point in common; any pair of sphere, capsule, AABB, OBB, plane, triangle,
    --- frustum and mesh, in either order. A mesh is its surface: a sphere deep inside a closed mesh does
    --- not overlap it. A convex hull (Mesh) is solid. Exact between AABBs, planes, triangles, meshes and
    --- frusta; other pairs are decided in double precision and may err only where the gap is below 2^-40 of
    --- the largest coordinate difference.
    --- Cost: 5 to 500 ns, 0.5 to 20 us with a frustum; O(log n + k) expected with a mesh.
    --- @raise status ERROR_UNSUPPORTED: for a ray or segment (see gp.segment_test)
    function gp.overlaps(a, b)
        check(C.gphys_shape_overlaps(kind(a), address(a), kind(b), address(b), out_overlaps))
        return out_overlaps[0] ~= 0
    end
end

--- Whether the shapes of each of the pairs overlap, as gp.overlaps: pair i is a[i] against b[i].
--- Cost: that of as many single calls.
--- @param a shapes of one type
--- @param b shapes of one type
--- @raise status ERROR_UNSUPPORTED: for rays and segments
function gp.overlaps_batch(a, b, out)
    local a, a_kind, a_count, a_stride = to_shapes(a)
    local b, b_kind, b_count, b_stride = to_shapes(b)
    local count = common(a_count, b_count)
    out = results(int32_t, out, count)
    check(C.gphys_shape_overlaps_batch(a_kind, a, a_stride, b_kind, b, b_stride, count, out, int32_t.size))
    return out
end

do
    local out_side = int32_t.array(1)
    local out_signed_distance = float.array(1)
    --- Classify a sphere, capsule, AABB, OBB or triangle against a plane.
    --- Cost: O(1).
    --- @return metres, of the shape's nearest point to the plane: > 0 in front, < 0 behind, 0 when
    ---     crossing.
    --- @raise status ERROR_UNSUPPORTED: for other types of shapes
    function gp.classify_plane(shape, plane)
        check(C.gphys_shape_classify_plane(kind(shape), address(shape), to_value(Plane, plane), out_side, out_signed_distance))
        return out_side[0], out_signed_distance[0]
    end
end

do
    local out_side = int32_t.array(1)
    --- Classify a sphere, capsule, AABB, OBB or triangle against a frustum, exactly: outside means that no
    --- point is shared, inside that the frustum holds the whole shape.
    --- Cost: O(1).
    --- @raise status ERROR_UNSUPPORTED: for other types of shapes
    function gp.classify_frustum(shape, frustum)
        check(C.gphys_shape_classify_frustum(kind(shape), address(shape), to_value(Frustum, frustum), out_side))
        return out_side[0]
    end
end

--- First hit of a ray with a sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. Triangles
--- and meshes are hit from both sides, and meshes are watertight: a ray through a shared edge or vertex
--- always meets one of the triangles there. Error: t within 1 ulp. No false miss and no false hit at
--- all for spheres, triangles, meshes, AABBs and planes; for capsules only within 2^-48 of the
--- distance. An OBB is hit as if it were larger or smaller by up to 2^-40 of the distance.
--- docs/accuracy.md has the bounds of all functions.
--- Cost: O(1); O(log n) expected for a mesh.
--- @return nil if nothing is found.
--- @raise status ERROR_UNSUPPORTED: for a ray or a segment as the shape
function gp.raycast(shape, ray, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_shape_raycast(kind(shape), address(shape), to_value(Ray, ray), out_hit)) then return out_hit end
end

--- First hits of the rays with one shape, as gp.raycast. A ray that hits nothing gets t = INFINITY,
--- triangle = NO_TRIANGLE and zeros in its hits element.
--- Cost: that of as many single calls; less for rays at a mesh if neighbouring rays are similar.
--- @raise status ERROR_UNSUPPORTED: for a ray or a segment as the shape
function gp.raycast_batch(shape, rays, out)
    local rays, rays_count, rays_stride = to_array(Ray, rays)
    local count = common(rays_count)
    out = results(Hit, out, count)
    check(C.gphys_shape_raycast_batch(kind(shape), address(shape), rays, rays_stride, count, out, Hit.size))
    return out
end

--- First hit along the segment from a to b; t runs from 0 to 1. Contains both end points exactly. A
--- segment whose ends coincide hits at t = 0 if the shape contains the point; on a solid, for lack of a
--- direction, the normal is zero.
--- Cost: as gp.raycast.
--- @return nil if nothing is found.
--- @raise status ERROR_UNSUPPORTED: for a ray or a segment as the shape
function gp.segment_test(shape, segment, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_shape_segment_test(kind(shape), address(shape), to_value(Segment, segment), out_hit)) then return out_hit end
end

--- First contact of a sphere that moves by displacement with a sphere, capsule, AABB, OBB, plane,
--- triangle, frustum or mesh.
--- Error: as if the radius were off by 2^-40 of the largest coordinate difference, and 1 ulp of t.
--- Cost: O(1), about 10 us for a frustum, which is approached step by step; O(log n + k) expected for a
--- mesh.
--- @param displacement metres; may be zero
--- @return t in 0..1 of the displacement; point: of contact, on the shape; normal: from the point to
---     the sphere's centre; in double precision its dot with the displacement is never above 0. Already
---     overlapping: t = 0, HIT_INSIDE, and the normal may be along the displacement too; where the
---     centre itself is in a solid, it is opposite to the displacement (zero if that is zero). A sphere
---     of radius 0 gets the hit of the ray along its path. nil if nothing is found.
--- @raise status ERROR_UNSUPPORTED: for a ray or a segment as the shape
function gp.sweep_sphere(shape, sphere, displacement, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_shape_sweep_sphere(kind(shape), address(shape), to_value(Sphere, sphere), to_value(Vec3, displacement), out_hit)) then return out_hit end
end

--- First contact of a sphere, capsule, AABB or OBB that moves by displacement, without turning, with a
--- sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. A frustum, unless a sphere moves, must
--- be the hull of its corners (gp.frustum_corners).
--- Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
--- ulp of t. Point and normal are those of that contact.
--- Cost: O(1), 0.1 to 2 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh.
--- @param displacement metres; may be zero
--- @return t, point and normal as in gp.sweep_sphere, which gives the answer for a sphere. The point is
---     one of those where the two touch, always the same. Already overlapping, except for a sphere: t =
---     0, HIT_INSIDE, and point and normal of gp.penetration; for a mesh that is not a hull, those of
---     its first triangle. nil if nothing is found.
--- @raise status ERROR_UNSUPPORTED: for a ray or a segment as the shape, for a frustum that is not the
---     hull of its corners, unless a sphere moves, and for other types that move
function gp.sweep(shape, moving, displacement, out_hit)
    out_hit = out_hit or Hit.new()
    if found(C.gphys_shape_sweep(kind(shape), address(shape), kind(moving), address(moving), to_value(Vec3, displacement), out_hit)) then return out_hit end
end

--- First contacts of count moving shapes of one type with the shapes of another, as gp.sweep: moving[i]
--- with shapes[i]. One that touches nothing gets t = INFINITY, triangle = NO_TRIANGLE and zeros.
--- Cost: that of as many single calls. Since 1.1.
--- @param shapes shapes of one type
--- @param moving shapes of one type
--- @param displacements metres
--- @raise status ERROR_UNSUPPORTED: as gp.sweep
function gp.sweep_batch(shapes, moving, displacements, out)
    local shapes, shapes_kind, shapes_count, shapes_stride = to_shapes(shapes)
    local moving, moving_kind, moving_count, moving_stride = to_shapes(moving)
    local displacements, displacements_count, displacements_stride = to_array(Vec3, displacements)
    local count = common(shapes_count, moving_count, displacements_count)
    out = results(Hit, out, count)
    check(C.gphys_shape_sweep_batch(shapes_kind, shapes, shapes_stride, moving_kind, moving, moving_stride, displacements, displacements_stride, count, out, Hit.size))
    return out
end

--- The shortest translation that takes a sphere, capsule, AABB or OBB out of a sphere, capsule, AABB,
--- OBB, plane, triangle or frustum: to where the two just touch, on the side of a plane or triangle
--- that is nearer. Of a mesh: out of the triangle that it is deepest in; others may remain, and have
--- translations of their own. Of a hull: out of all of it, and triangle is NO_TRIANGLE. A frustum must
--- be the hull of its corners (gp.frustum_corners).
--- Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
--- ulp of depth; by 2^-32 where the centre or axis of a round solid is closer than that to the other
--- shape. Added to float positions, the translation may leave an overlap as large as the spacing of
--- floats there.
--- Cost: O(1), 0.1 to 1 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh. Boxes by
--- separating axes (Gottschalk 1996), round solids by the distance of their core (Gilbert, Johnson,
--- Keerthi 1988).
--- @return depth and normal of the translation, which is their product; of several equally short ones
---     always the same one. The deepest point of the solid is point - depth * normal. nil if nothing is
---     found.
--- @raise status ERROR_UNSUPPORTED: for rays, segments, frusta that are not the hull of their corners,
---     and for other types that move
function gp.penetration(shape, moving, out_penetration)
    out_penetration = out_penetration or Penetration.new()
    if found(C.gphys_shape_penetration(kind(shape), address(shape), kind(moving), address(moving), out_penetration)) then return out_penetration end
end

--- The shortest translations that take the shapes of one type out of the shapes of another, as
--- gp.penetration: moving[i] out of shapes[i]. One that overlaps nothing gets depth = -INFINITY,
--- triangle = NO_TRIANGLE and zeros.
--- Cost: that of as many single calls. Since 1.1.
--- @param shapes shapes of one type
--- @param moving shapes of one type
--- @raise status ERROR_UNSUPPORTED: as gp.penetration
function gp.penetration_batch(shapes, moving, out)
    local shapes, shapes_kind, shapes_count, shapes_stride = to_shapes(shapes)
    local moving, moving_kind, moving_count, moving_stride = to_shapes(moving)
    local count = common(shapes_count, moving_count)
    out = results(Penetration, out, count)
    check(C.gphys_shape_penetration_batch(shapes_kind, shapes, shapes_stride, moving_kind, moving, moving_stride, count, out, Penetration.size))
    return out
end

--- The eight corners, each the intersection of three planes: near then far, each in the order
--- left-bottom, right-bottom, right-top, left-top. A frustum is the convex hull of its corners (the
--- intersections themselves, not rounded to floats) if each is within MAX_COORDINATE and in front of
--- the three planes that do not meet there, by more than 2^-39 of its distance from origin; that is,
--- unless it is empty, flat, unbounded or ends in a tip. Solids are swept against such a frustum and
--- pushed out of it; for the bounds of their errors, origin counts as a corner.
--- Cost: O(1).
--- @return nil if three planes do not meet in a point (infinite far plane), or meet beyond the largest
---     float.
function gp.frustum_corners(frustum)
    local out_corners = Vec3.array(8)
    if found(C.gphys_frustum_corners(to_value(Frustum, frustum), out_corners)) then return out_corners end
end

--- The point that three planes have in common, within an ulp of each coordinate.
--- Cost: O(1). Source: Cramer's rule. Since 1.1.
--- @return nil if the planes have no single point in common, which is decided exactly, or one beyond
---     MAX_COORDINATE.
function gp.planes_intersection(a, b, c, out_point)
    out_point = out_point or Vec3.new()
    if found(C.gphys_planes_intersection(to_value(Plane, a), to_value(Plane, b), to_value(Plane, c), out_point)) then return out_point end
end

--- The points of the triples of planes, as gp.planes_intersection; one without gets x = y = z =
--- INFINITY.
--- Cost: that of as many single calls. Since 1.1.
--- @param a the planes
--- @param b the planes
--- @param c the planes
function gp.planes_intersection_batch(a, b, c, out)
    local a, a_count, a_stride = to_array(Plane, a)
    local b, b_count, b_stride = to_array(Plane, b)
    local c, c_count, c_stride = to_array(Plane, c)
    local count = common(a_count, b_count, c_count)
    out = results(Vec3, out, count)
    check(C.gphys_planes_intersection_batch(a, a_stride, b, b_stride, c, c_stride, count, out, Vec3.size))
    return out
end

do
    local out_deviation = float.array(1)
    --- How far the axes of a matrix (its first three columns without the last row) are from orthonormal:
    --- the largest |a_i . a_j - d_ij|, where d_ij is 1 for i = j, else 0. 0 for the identity, below 2^-22
    --- for the matrices that a camera gives, about 2e for axes that are too long by a fraction e.
    --- Cost: O(1). Since 1.1.
    --- @param matrix elements within MAX_COORDINATE
    function gp.mat4_orthonormality(matrix)
        check(C.gphys_mat4_orthonormality(to_value(Mat4, matrix), out_deviation))
        return out_deviation[0]
    end
end

--- The frustum of any view-projection matrix (Gribb and Hartmann 2001), in double precision, with
--- origin (0, 0, 0). For a camera, Camera:get_frustum is more precise.
--- Cost: O(1).
--- @param reverse_z 0: near has the low depth; 1: near has the high depth
--- @raise status ERROR_SINGULAR: if the matrix has no inverse, or what it shows has no volume: its four
---     near corners are not all finite points in front of the viewer
function gp.frustum_from_matrix(view_projection, depth_range, reverse_z, out_frustum)
    out_frustum = out_frustum or Frustum.new()
    check(C.gphys_frustum_from_matrix(to_value(Mat4, view_projection), signed(depth_range, 'depth_range'), to_flag(reverse_z, 'reverse_z'), out_frustum))
    return out_frustum
end

--- Examine arrays without building anything. Allocates while it runs.
--- Cost: O(n log n).
--- @param vertices elements of 3 floats, metres
--- @param indices numbers, three for each triangle
--- @return what was found; indices out of range and bad vertices are counted, not refused.
--- @raise status ERROR_INVALID_ARGUMENT: for an index_count that is no multiple of 3
function gp.mesh_check(vertices, indices, out_report)
    local vertices, vertices_count, vertices_stride = to_array(float, vertices, 3)
    local indices, indices_count, indices_stride = to_array(uint32_t, indices)
    out_report = out_report or MeshReport.new()
    check(C.gphys_mesh_check(vertices, vertices_stride, vertices_count, indices, indices_count, out_report))
    return out_report
end
end
