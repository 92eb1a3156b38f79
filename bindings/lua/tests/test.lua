-- The package: every function with an answer that is known, batches against single calls, errors, ownership.
local ffi = require 'ffi'
local gp = require 'gamephys'

local UP, IDENTITY = { 0, 1, 0 }, { { 0, 0, 0 }, { 0, 0, 0, 1 }, 1 }
local ball = gp.Sphere({ 0, 0, 5 }, 1)
local ahead = gp.Ray({ 0, 0, 0 }, { 0, 0, 1 }, 100)

local function near(a, b, tolerance) return math.abs(a - b) <= (tolerance or 1e-5) end
local function same(a, b) return ffi.string(a, ffi.sizeof(a)) == ffi.string(b, ffi.sizeof(b)) end
local function is(v, x, y, z, tolerance) return near(v.x, x, tolerance) and near(v.y, y, tolerance) and near(v.z, z, tolerance) end
local function pyramid()
    return gp.Mesh({ -1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, 2, 0 }, { 0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4 })
end
local function fails(status, call, ...)
    local fine, caught = pcall(call, ...)
    assert(not fine, 'an error was expected')
    assert(gp.is_error(caught) and caught.status == status, tostring(caught))
    return tostring(caught)
end
local function raises(text, call, ...)
    local fine, caught = pcall(call, ...)
    assert(not fine and tostring(caught):find(text, 1, true), tostring(caught))
end

local tests = {}

function tests.ids_and_masks_beyond_32_bits_are_refused_by_name()
    local scene, solver = gp.Scene(), gp.Solver()
    local model = scene:add(ball)
    raises('is not a whole number from 0', scene.remove, scene, 2 ^ 32 + model)
    raises('model -1 is not', scene.remove, scene, -1)
    raises('is not a whole number', scene.remove, scene, model + 0.5)
    raises('model: expected a number, got nil', scene.remove, scene)
    raises('layers 4294967296 is not a set of 32 bits', scene.raycast, scene, ahead, 2 ^ 32)
    raises('tag 4294967296 is not', scene.add, scene, ball, nil, { tag = 2 ^ 32 })
    raises('dt: expected a number, got nil', solver.step, solver, scene)
    assert(scene:has(model) and scene:raycast(ahead, bit.bnot(2)).t == 4 and scene:raycast(ahead, -1).t == 4)
    assert(scene:raycast(ahead, bit.bnot(1)) == nil)
end

function tests.memory_that_is_too_short_or_of_unknown_length_is_refused()
    local scene, camera, solver = gp.Scene(), gp.Camera(), gp.Solver()
    local model, other = scene:add(ball), scene:add(ball)
    local rays = gp.array('ray', { ahead, ahead })
    local unknown = 'a pointer does not say how many elements it has'
    for _, object in ipairs { scene, camera, solver } do
        raises('expected 3 numbers, got 1', object.set_origin, object, gp.array('double', { 7 }))
        raises('expected 3 numbers, got 0', object.set_origin, object, gp.array('double', 0))
        raises('expected 3 numbers, got 2', object.set_origin, object, { 7, 7 })
        raises('expected 3 numbers, got a nil', object.set_origin, object)
        local three = gp.array('double', { 7, 7, 7 })
        raises(unknown, object.set_origin, object, three + 0)
        assert(object:get_origin()[0] == 0)
        object:set_origin(three)
        assert(object:get_origin()[2] == 7)
    end
    for _, kind in ipairs { 'void*', 'const void*', 'uint32_t*', 'const uint32_t*' } do
        raises(unknown, scene.remove_batch, scene, ffi.cast(kind, gp.array('uint32_t', { model, other })))
    end
    raises(unknown, scene.raycast_batch, scene, rays + 0)
    raises(unknown, scene.raycast_any_batch, scene, rays, nil, ffi.new 'int32_t[2]' + 0)
    raises('room for results must be an array', scene.raycast_any_batch, scene, rays, nil, {})
    raises('room for results has another length', scene.raycast_any_batch, scene, rays, nil, gp.array('int32_t', 1))
    raises('element 2 ', scene.remove_batch, scene, { model, other + 2 ^ 32 })
    raises('is not a whole number', scene.remove_batch, scene, { model + 0.5 })
    assert(scene:has(model) and scene:has(other))
end

function tests.what_is_not_given_is_the_identity_and_what_does_not_exist_is_refused()
    local whole = { gp.Transform(), gp.Transform { position = { 0, 0, 0 } }, gp.Transform({ 0, 0, 0 }, { 0, 0, 0, 1 }) }
    for _, transform in ipairs(whole) do assert(transform.rotation.w == 1 and transform.scale == 1) end
    local scene = gp.Scene()
    local model = scene:add(gp.Obb({ 0, 0, 0 }, { 1, 1, 1 }), { position = { 0, 0, 5 } })
    for _, ray in ipairs { gp.Ray({ 0, 0, 0 }, { 0, 0, 1 }), { { 0, 0, 0 }, { 0, 0, 1 } }, { origin = { 0, 0, 0 }, direction = { 0, 0, 1 } } } do
        assert(scene:raycast(ray).t == 4)
    end
    raises('gphys_ray has no field orgin', scene.raycast, scene, { orgin = { 0, 0, 0 } })
    raises('gphys_ray has no field orgin', gp.Ray, { orgin = { 0, 0, 0 } })
    raises('gphys_transform has no field postion', scene.set_transform, scene, model, { postion = { 1, 2, 3 } })
end

function tests.a_whole_body_is_read_and_pinned_by_default()
    local solver = gp.Solver()
    local rope = solver:add_rope { { 0, 0, 0 }, { 0, 1, 0 }, { 0, 2, 0 } }
    assert(gp.length(solver:get_positions(rope)) == 3 and gp.length(solver:get_positions(rope, 1)) == 2)
    raises('first: expected a number', solver.set_pinned, solver, rope, false)
    raises('count: expected a number', solver.set_pinned, solver, rope, 1, false)
    assert(solver:get_pinned(rope)[0] == 0)
    solver:set_pinned(rope, 1)
    local pinned = solver:get_pinned(rope)
    assert(pinned[0] == 0 and pinned[1] == 1 and pinned[2] == 1)
    solver:set_pinned(rope, 1, 1, false)
    assert(solver:get_pinned(rope)[1] == 0)
end

function tests.shapes()
    gp.validate(ball)
    local box = gp.bounds(ball)
    assert(is(box.min, -1, -1, 4) and is(box.max, 1, 1, 6))
    assert(gp.bounds(gp.Plane(UP, 0)) == nil)
    assert(is(gp.transform(gp.Aabb({ 0, 0, 0 }, { 2, 2, 2 }), { { 1, 0, 0 }, { 0, 0, 0, 1 }, 1 }).center, 2, 1, 1))
    assert(gp.contains(ball, { 0, 0, 4 }, 0) and not gp.contains(ball, { 0, 0, 3.5 }, 0))
    local inside = gp.contains_batch(ball, { { 0, 0, 5 }, { 0, 0, 3 } }, 0)
    assert(inside[0] == 1 and inside[1] == 0)
    assert(gp.closest_point(ball, { 0, 0, 0 }).distance == 4)
    assert(gp.closest_point_batch(ball, { { 0, 0, 0 }, { 0, 0, 9 } })[1].distance == 3)
    local a, b, distance = gp.segment_closest_points({ { 0, 0, 0 }, { 2, 0, 0 } }, { { 1, 3, -1 }, { 1, 3, 1 } })
    assert(is(a, 1, 0, 0) and is(b, 1, 3, 0) and distance == 3)
    assert(gp.overlaps(ball, gp.Aabb({ 0, 0, 0 }, { 1, 1, 4 })) and not gp.overlaps(ball, gp.Aabb({ 0, 0, 0 }, { 1, 1, 3 })))
    local touching = gp.overlaps_batch({ gp.Sphere({ 0, 0, 0 }, 1), gp.Sphere({ 0, 9, 0 }, 1) }, gp.Plane(UP, 0))
    assert(touching[0] == 1 and touching[1] == 0)
    local side, away = gp.classify_plane(ball, { { 0, 0, 1 }, 0 })
    assert(side == gp.SIDE_INSIDE and away == 4)
    assert(gp.raycast(ball, ahead).t == 4 and gp.raycast(ball, { { 0, 3, 0 }, { 0, 0, 1 }, 9 }) == nil)
    local rays = gp.array('ray', { ahead, { { 0, 3, 0 }, { 0, 0, 1 }, 9 } })
    local hits = gp.raycast_batch(ball, rays)
    assert(hits[0].t == 4 and hits[1].t == math.huge)
    assert(gp.segment_test(ball, { { 0, 0, 0 }, { 0, 0, 8 } }).t == 0.5)
    assert(near(gp.sweep_sphere(ball, { { 0, 0, 0 }, 1 }, { 0, 0, 10 }).t, 0.3))
end

function tests.frusta()
    local camera = gp.Camera()
    local frustum = camera:get_frustum()
    assert(gp.classify_frustum(ball, frustum) == gp.SIDE_INSIDE)
    local corners = gp.frustum_corners(frustum)
    local near_edge = camera:get_corners()[3]
    assert(near(corners[0].z, 0.1) and near(corners[7].z, 1000, 0.01) and is(corners[3], near_edge.x, near_edge.y, near_edge.z))
    local again = gp.frustum_from_matrix(camera:get_view_projection_matrix(), gp.DEPTH_ZERO_TO_ONE, false)
    assert(gp.classify_frustum(gp.Sphere({ 0, 0, -5 }, 1), again) == gp.SIDE_OUTSIDE)
end

function tests.meshes()
    local report = gp.mesh_check({ 0, 0, 0, 1, 0, 0, 0, 1, 0 }, { 0, 1, 7 })
    assert(report.triangle_count == 1 and report.out_of_range_count == 1)
    local mesh = pyramid()
    assert(mesh:get_report().open_edge_count == 0)
    local vertices, count = mesh:get_vertices()
    assert(count == 5 and is(vertices[4], 0, 2, 0))
    assert(gp.Mesh_from_snapshot((mesh:get_snapshot())):get_report().triangle_count == 6)
    local indices, numbers = mesh:get_indices()
    assert(numbers == 18 and indices[17] == 4)
    local down = gp.Ray({ 0.3, 5, 0.2 }, { 0, -1, 0 }, 10)
    local hits, met = mesh:raycast_all(down)
    assert(met == 2 and hits[0].t < hits[1].t and hits[1].t == 5 and mesh:raycast_any(down))
    assert(mesh:raycast_any_batch({ down, down })[1] == 1 and mesh:raycast_distance_batch({ down, down })[1].t == hits[0].t)
    assert(select(2, mesh:overlap(gp.Sphere({ 0, 2, 0 }, 0.1))) == 4)
    assert(mesh:get_octree_stats().item_count == 6)
    local boxes = mesh:get_octree_boxes()
    assert(boxes[0].depth == 0)
    assert(gp.raycast(mesh, down).triangle == hits[0].triangle)
end

function tests.models()
    local scene = gp.Scene { reserve_models = 4, worker_count = 2 }
    local model = scene:add(ball, nil, { tag = 7 })
    local two = scene:add_batch(gp.array('sphere', { { { 9, 0, 0 }, 1 }, { { 9, 5, 0 }, 2 } }), gp.Transform(unpack(IDENTITY)))
    assert(scene:has(model) and scene:has(two[1]) and not scene:has(12345))
    assert(select(2, scene:get_models()) == 3)
    assert(scene:get_info(model).tag == 7 and scene:get_shape(two[1]).radius == 2)
    assert(scene:get_bounds(two[0]).max.x == 10 and scene:get_scene_bounds().max.y == 7)
    scene:set_layers(model, 4)
    scene:set_tag(model, 8)
    assert(scene:raycast(ahead, 3) == nil and scene:raycast(ahead, 4).tag == 8)
    scene:set_parent(two[0], model, true)
    scene:set_transform(model, { { 0, 1, 0 }, { 0, 0, 0, 1 }, 1 })
    assert(scene:get_info(two[0]).parent == model)
    local ids = gp.array('uint32_t', { model, two[0] })
    assert(scene:get_transforms(ids)[1].position.y == 0 and scene:get_world_transforms(ids)[1].position.y == 1)
    scene:set_transforms(ids, { IDENTITY, IDENTITY })
    assert(scene:get_world_transforms(ids)[1].position.y == 0)
    scene:validate()
    scene:remove_subtree(model)
    assert(not scene:has(two[0]))
    scene:remove(two[1])
    local more = scene:add_batch { ball, ball, ball }
    scene:remove_batch(more)
    assert(scene:get_scene_bounds() == nil)
    scene:add(ball)
    scene:rebuild_octree()
    assert(scene:maintain_octree(1000))
    scene:set_worker_count(2)
    assert(scene:get_worker_count() == 2)
    scene:clear()
    assert(select(2, scene:get_models()) == 0)
    scene:set_origin { 1e9 + 0.5, 0, 0 }
    assert(scene:get_origin()[0] == 1e9 + 0.5)
end

function tests.models_with_descs_of_their_own()
    local scene = gp.Scene()
    local root = scene:add(ball)
    local function are(models, ...)
        assert(gp.length(models) == select('#', ...))
        for i, known in ipairs { ... } do
            local info = scene:get_info(models[i - 1])
            assert(info.parent == known[1] and info.layers == known[2] and info.tag == known[3])
        end
    end
    local three, some = { ball, ball, ball }, { { parent = root, layers = 2, tag = 5 }, { tag = 6 }, {} }
    are(scene:add_described_batch(three, nil, some), { root, 2, 5 }, { 0, 1, 6 }, { 0, 1, 0 })
    are(scene:add_described_batch(ball, nil, some), { root, 2, 5 }, { 0, 1, 6 }, { 0, 1, 0 })
    are(scene:add_described_batch({ ball, ball }, { IDENTITY, IDENTITY }, some[1]), { root, 2, 5 }, { root, 2, 5 })
    are(scene:add_described_batch { ball, ball }, { 0, 1, 0 }, { 0, 1, 0 })
    local descs = gp.array('model_desc', 2) -- an array of structs is taken as it is
    fails(gp.ERROR_STRUCT_SIZE, scene.add_described_batch, scene, ball, nil, descs)
    for i = 0, 1 do descs[i] = { struct_size = ffi.sizeof 'gphys_model_desc', layers = 4, tag = i } end
    are(scene:add_described_batch(ball, nil, descs), { 0, 4, 0 }, { 0, 4, 1 })
    local _, count = scene:get_models()
    raises('different lengths: 3 and 2', scene.add_described_batch, scene, three, nil, { {}, {} })
    raises('different lengths: 3 and 2', scene.add_described_batch, scene, three, { IDENTITY, IDENTITY }, { {}, {}, {} })
    raises('weight', scene.add_described_batch, scene, three, nil, { {}, {}, { weight = 1 } })
    fails(gp.ERROR_INVALID_ID, scene.add_described_batch, scene, three, nil, { parent = 12345 })
    assert(select(2, scene:get_models()) == count)
end

local function some_scene()
    local scene = gp.Scene()
    for i = 0, 29 do scene:add(gp.Sphere({ 3 * math.sin(i), 3 * math.cos(2 * i), i / 3 }, 0.7)) end
    return scene
end

function tests.batches_answer_as_single_calls_do()
    local scene, count = some_scene(), 200
    local rays, segments, points = gp.array('ray', count), gp.array('segment', count), gp.array('vec3', count)
    local spheres = gp.array('sphere', count)
    for i = 0, count - 1 do
        local direction = { math.sin(i) / 2, math.cos(3 * i) / 2, 1 }
        rays[i] = gp.Ray({ 0, 0, -5 }, direction, math.huge)
        segments[i] = gp.Segment({ 0, 0, -5 }, { 10 * direction[1], 10 * direction[2], 5 })
        points[i] = gp.Vec3(unpack(direction))
        spheres[i] = gp.Sphere({ 0, 0, -5 }, 0.2)
    end
    local hits, any, tested = scene:raycast_batch(rays), scene:raycast_any_batch(rays), scene:segment_test_batch(segments)
    local nearest, swept = scene:nearest_batch(points), scene:sweep_sphere_batch(spheres, points)
    local all, offsets = scene:raycast_all_batch(rays)
    local distances = scene:raycast_distance_batch(rays)
    local met = 0
    local function agree(item, single) return single and same(item, single) or not single and item.model == 0 end
    for i = 0, count - 1 do
        assert(agree(hits[i], scene:raycast(rays[i])) and agree(tested[i], scene:segment_test(segments[i])))
        assert(agree(nearest[i], scene:nearest(points[i])) and agree(swept[i], scene:sweep_sphere(spheres[i], points[i])))
        assert((any[i] ~= 0) == scene:raycast_any(rays[i]) and (any[i] ~= 0) == (hits[i].model ~= 0))
        local each, number = scene:raycast_all(rays[i])
        assert(offsets[i + 1] - offsets[i] == number and (number == 0 or same(each[0], all[offsets[i]])))
        assert(distances[i].t == hits[i].t and distances[i].model == hits[i].model)
        met = met + any[i]
    end
    assert(met > 0 and met < count)
    local room = gp.array('hit', count)
    assert(scene:raycast_batch(rays, nil, room) == room and same(room, hits))
end

function tests.a_batch_may_be_empty_but_is_no_single_id()
    local scene = gp.Scene()
    local model = scene:add(ball)
    assert(gp.length(scene:raycast_batch({})) == 0 and gp.length(scene:add_batch({})) == 0)
    local _, offsets = scene:overlap_batch({})
    assert(offsets[0] == 0)
    scene:set_transforms({}, {})
    raises('expected an array or a table, got a number', scene.get_world_transforms, scene, model)
end

function tests.filters_have_lists_of_models_and_batches_a_filter_for_each()
    local scene, models = gp.Scene(), {}
    for i = 1, 4 do models[i] = scene:add(gp.Sphere({ 0, 0, 4 * (i - 1) }, 1)) end
    local ray, near = gp.Ray({ 0, 0, -5 }, { 0, 0, 1 }), gp.Sphere({ 0, 0, 2 }, 2)
    for _, list in ipairs { { models[1], models[2] }, gp.array('uint32_t', { models[1], models[2] }), (scene:overlap(near)) } do
        assert(scene:raycast_filtered(ray, { ignored_models = list }).model == models[3])
        assert(scene:overlap_filtered(gp.Sphere({ 0, 0, 0 }, 50), { ignored_models = list })[0] == models[3])
    end
    assert(scene:raycast_filtered(ray, { ignored_models = {} }).model == models[1])
    local function met(filters)
        collectgarbage()
        local hits = scene:raycast_filtered_batch({ ray, ray, ray }, filters)
        return ('%d %d %d'):format(hits[0].model - models[1], hits[1].model - models[1], hits[2].model - models[1])
    end
    assert(met { {}, { ignored_model = models[1] }, { ignored_models = { models[1], models[2] } } } == '0 1 2')
    assert(met { ignored_models = { models[1], models[2] } } == '2 2 2' and met() == '0 0 0')
    local _, ends = scene:overlap_filtered_batch({ near, near }, { {}, { ignored_models = models } })
    assert(ends[1] == 2 and ends[2] == 2)
    raises('different lengths: 3 and 2', met, { {}, {} })
    raises('not a whole number', scene.raycast_filtered, scene, ray, { ignored_models = { 0.5 } })
end

function tests.filters_leave_out_models()
    local scene = gp.Scene()
    local body = scene:add(ball)
    scene:add(ball, gp.Transform({ 0, 0, 3 }, { 0, 0, 0, 1 }, 1), { parent = body })
    local target = scene:add(ball, gp.Transform({ 0, 0, 10 }, { 0, 0, 0, 1 }, 1))
    local ray, segment = gp.Ray({ 0, 0, 0 }, { 0, 0, 1 }, math.huge), gp.Segment({ 0, 0, 0 }, { 0, 0, 20 })
    local moving, way, large = gp.Sphere({ 0, 0, 0 }, 0.5), gp.Vec3(0, 0, 20), gp.Sphere({ 0, 0, 0 }, 50)
    local filter = { ignored_model = body, flags = gp.FILTER_SUBTREE }
    assert(scene:raycast_filtered(ray).model == body and scene:raycast_filtered(ray, filter).model == target)
    assert(scene:segment_test_filtered(segment, filter).model == target)
    assert(scene:nearest_filtered({ 0, 0, 0 }, math.huge, filter).model == target)
    assert(scene:sweep_sphere_filtered(moving, way, filter).model == target)
    assert(scene:raycast_any_filtered(ray, filter) and not scene:raycast_any_filtered(ray, { layers = 0 }))
    assert(scene:raycast_all_filtered(ray, filter)[0].model == target)
    assert(scene:overlap_filtered(large, filter)[0] == target)
    assert(scene:raycast_filtered_batch({ ray, ray }, filter)[1].model == target)
    assert(scene:raycast_any_filtered_batch({ ray, ray }, filter)[1] == 1)
    assert(scene:raycast_distance_filtered_batch({ ray, ray }, filter)[1].model == target)
    assert(scene:raycast_all_filtered_batch({ ray, ray }, filter)[1].model == target)
    assert(scene:segment_test_filtered_batch({ segment, segment }, filter)[1].model == target)
    assert(scene:nearest_filtered_batch({ way, way }, math.huge, filter)[1].model == target)
    assert(scene:sweep_sphere_filtered_batch({ moving, moving }, { way, way }, filter)[1].model == target)
    assert(scene:overlap_filtered_batch({ large, large }, filter)[1] == target)
    local camera = gp.Camera()
    camera:look_at({ 0, 0, -10 }, { 0, 0, 0 }, UP)
    assert(camera:pick_filtered(scene, 400, 300, filter).model == target)
    assert(camera:pick_filtered_batch(scene, { 400, 300, 1, 1 }, filter)[0].model == target)
    assert(camera:pick_rectangle_filtered(scene, 0, 0, 800, 600, filter)[0] == target)
    assert(camera:cull_filtered(scene, filter)[0] == target)
    assert(scene:cull_filtered(camera:get_frustum(), filter)[0] == target)
    local views = { camera:get_frustum(), camera:get_frustum() }
    local _, all_ends = scene:cull_batch(views)
    assert(all_ends[1] == 3 and all_ends[2] == 6)
    assert(scene:cull_filtered_batch(views, filter)[1] == target)
end

function tests.solids_move_up_to_what_they_touch_and_out_of_what_they_overlap()
    local centred = gp.Sphere({ 0, 0, 0 }, 1)
    assert(gp.sweep(centred, gp.Sphere({ 0, 4, 0 }, 1), { 0, -4, 0 }).t == 0.5)
    assert(gp.penetration(centred, gp.Sphere({ 0, 0, 1.5 }, 1)).depth == 0.5)
    local scene = gp.Scene()
    scene:add(centred)
    local target = scene:add(centred, gp.Transform({ 0, 0, 10 }, { 0, 0, 0, 1 }, 1))
    local moving, deep, way = gp.Sphere({ 0, 0, 5 }, 1), gp.Sphere({ 0, 0, 8.5 }, 1), gp.Vec3(0, 0, 6)
    local spheres, filter = { moving, moving }, { ignored_model = target }
    assert(scene:sweep(moving, way).model == target and not scene:sweep_filtered(moving, way, filter))
    assert(scene:sweep_batch(spheres, { way, way })[1].model == target)
    assert(scene:sweep_filtered_batch(spheres, { way, way }, filter)[1].model == 0)
    assert(scene:penetration(deep)[0].depth == 0.5 and gp.length(scene:penetration_filtered(deep, filter)) == 0)
    local ways_out, ends = scene:penetration_batch({ deep, moving })
    assert(ways_out[0].model == target and ends[1] == 1 and ends[2] == 1)
    local _, none = scene:penetration_filtered_batch({ deep, moving }, filter)
    assert(none[2] == 0)
    local others = { gp.Sphere({ 0, 4, 0 }, 1), gp.Sphere({ 0, 0, 1.5 }, 1) }
    local hits = gp.sweep_batch(centred, others, { { 0, -4, 0 }, { 0, -4, 0 } })
    assert(hits[0].t == 0.5 and hits[1].t == 0)
    local outs = gp.penetration_batch(centred, others)
    assert(outs[0].depth == -math.huge and outs[1].depth == 0.5)
end

function tests.shapes_change_and_trees_and_cameras_are_read()
    local scene = gp.Scene()
    local body = scene:add(ball)
    local head = scene:add(ball, nil, { parent = body })
    scene:set_shape(body, gp.Sphere({ 0, 0, 0 }, 5))
    assert(scene:get_bounds(body).max.x == 5)
    scene:set_scale(body, { 2, 2, 2 })
    assert(scene:get_bounds(body).max.x == 10 and scene:get_scale(body).y == 2)
    assert(scene:get_roots()[0] == body and scene:get_children(body)[0] == head)
    local camera = gp.Camera()
    camera:set_orthographic(10, 1, 100)
    camera:set_viewport(200, 100)
    local kind, size, from, to = camera:get_projection()
    assert(kind == gp.PROJECTION_ORTHOGRAPHIC and size == 10 and from == 1 and to == 100)
    local width, height = camera:get_viewport()
    assert(width == 200 and height == 100)
end

function tests.cameras_see_by_aspect_in_a_window_from_the_near_plane_on()
    local camera = gp.Camera()
    camera:set_perspective_aspect(1, 2, 1, 100)
    local aspect, fixed = camera:get_aspect()
    assert(aspect == 2 and fixed)
    local handedness, range, reverse_z = camera:get_conventions()
    assert(handedness == gp.LEFT_HANDED and range == gp.DEPTH_ZERO_TO_ONE and not reverse_z)
    camera:set_orthographic_size(8, 6, 1, 100)
    local width, height = camera:get_image_size()
    assert(width == 8 and height == 6)
    camera:set_viewport_origin(800, 0)
    local x, y = camera:get_viewport_origin()
    assert(x == 800 and y == 0)
    camera:set_perspective(1, 1, 100)
    assert(is(camera:pick_ray(1200, 300).origin, 0, 0, 1))
    camera:set_pick_start(gp.PICK_FROM_CENTRE)
    assert(camera:get_pick_start() == gp.PICK_FROM_CENTRE)
    assert(is(camera:pick_ray(1200, 300).origin, 0, 0, 0))
    local view = camera:get_view_matrix()
    camera:set_view_matrix(view)
    assert(gp.mat4_orthonormality(view) == 0)
    local corner = camera:get_corners()[6]
    assert(is(camera:get_rectangle_corners(800, 0, 1600, 600)[6], corner.x, corner.y, corner.z))
    assert(is(camera:get_rectangle_frustum(800, 0, 1200, 600).origin, 0, 0, 0))
    camera:set_orbit(gp.default_orbit())
    camera:set_orbit_speeds(gp.OrbitSpeeds(0.5, 1, 2, 3, 4))
    assert(camera:get_orbit_speeds().pan_y == 4)
    local x1, y2, z3 = gp.Plane({ 1, 0, 0 }, 1), gp.Plane({ 0, 1, 0 }, 2), gp.Plane({ 0, 0, 1 }, 3)
    assert(is(gp.planes_intersection(x1, y2, z3), 1, 2, 3))
    assert(gp.planes_intersection(x1, y2, y2) == nil)
    assert(is(gp.planes_intersection_batch({ x1, x1 }, { y2, y2 }, { y2, z3 })[1], 1, 2, 3))
end

function tests.a_mesh_deforms_and_its_models_with_it()
    local mesh = gp.Mesh({ 0, 0, 0, 1, 0, 0, 0, 1, 0 }, { 0, 1, 2 }, { deformable = 1 })
    local scene = gp.Scene()
    local model = scene:add(mesh)
    mesh:set_vertices({ 0, 0, 7, 1, 0, 7, 0, 1, 7 })
    assert(math.abs(scene:get_bounds(model).min.z - 7) < 1e-3)
    assert(mesh:get_info().deformable == 1)
    -- The mesh of a restored scene, met from behind, or not.
    local copy = gp.Scene()
    copy:restore(nil, scene:get_snapshot(true))
    local info = gp.Mesh_from_scene(copy, model):get_info()
    assert(info.kind == gp.MESH_SURFACE and info.vertex_count == 3 and info.triangle_count == 1)
    local from_behind = gp.Ray({ 0.2, 0.2, 0 }, { 0, 0, 1 }, math.huge)
    assert(copy:raycast_filtered(from_behind, { flags = gp.FILTER_NO_FRONT_FACES }).flags == gp.HIT_BACK)
    assert(copy:raycast_filtered(from_behind, { flags = gp.FILTER_NO_BACK_FACES }) == nil)
end

function tests.a_hull_is_a_solid_mesh()
    local hull = gp.Mesh_hull({ 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1, 0.1, 0.1 })
    local _, vertices = hull:get_vertices()
    local _, planes = hull:get_hull_planes()
    local faces, triangles = hull:get_hull_faces()
    assert(vertices == 4 and planes == 4 and triangles == 4 and faces[3] == 3)
end

function tests.a_rope_is_picked_as_a_model_that_follows_it()
    local solver = gp.Solver()
    local rope = solver:add_rope({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, 0)
    local scene = gp.Scene()
    local model = scene:add(gp.Mesh_from_body(solver, rope))
    solver:set_positions(rope, 0, { { 0, 0, 7 }, { 1, 0, 7 }, { 2, 0, 7 } })
    local hit = scene:raycast(gp.Ray({ 1.8, 0, 0 }, { 0, 0, 1 }, math.huge))
    assert(hit.model == model and hit.triangle == 1)
    assert(solver:get_nearest_particle(rope, hit.triangle, hit.point) == 2)
end

function tests.lists_of_any_length()
    local scene = gp.Scene()
    local models = scene:add_batch(gp.array('sphere', 500)) -- more than the first guess has room for
    local listed, count = scene:get_models()
    assert(count == 500 and gp.length(listed) == 500 and listed[499] == models[499])
    local found, offsets = scene:overlap_batch { gp.Aabb({ -1, -1, -1 }, { 1, 1, 1 }), gp.Aabb({ 5, 5, 5 }, { 6, 6, 6 }) }
    assert(gp.length(found) == 500 and offsets[1] == 500 and offsets[2] == 500)
    assert(select(2, scene:overlap(ball)) == 0)
    assert(select(2, scene:raycast_all(ahead)) == 500)
    assert(scene:get_octree_stats().item_count == 500 and select(2, scene:get_octree_boxes()) > 1)
    scene:remove_batch(listed)
end

function tests.cameras()
    local camera = gp.Camera()
    camera:look_at({ 0, 0, -10 }, { 0, 0, 0 }, UP)
    camera:set_perspective(1, 0.1, 100)
    assert(is(camera:project { 0, 0, 0 }, 400, 300, camera:project({ 0, 0, 0 }).z, 1e-2))
    assert(camera:project { 0, 0, -20 } == nil)
    local pixels = camera:project_batch { { 0, 0, 0 }, { 1, 1, 1 } }
    local points = camera:unproject_batch(pixels)
    assert(is(points[1], 1, 1, 1, 1e-2) and is(camera:unproject(pixels[1]), 1, 1, 1, 1e-2))
    assert(is(camera:pick_ray(400, 300).direction, 0, 0, 1))
    assert(gp.length(camera:pick_rays(0, 0, 4, 3)) == 12)

    local scene = gp.Scene()
    local model = scene:add(ball)
    assert(camera:pick(scene, 400, 300).model == model and camera:pick(scene, 1, 1) == nil)
    assert(camera:pick_batch(scene, { 400, 300, 1, 1 })[1].model == 0)
    assert(select(2, camera:pick_rectangle(scene, 0, 0, 800, 600)) == 1)
    assert(select(2, camera:cull(scene)) == 1 and select(2, scene:cull(camera:get_frustum())) == 1)

    camera:set_viewport(200, 100)
    camera:set_orthographic(10, 0.1, 100)
    local projection = camera:get_projection_matrix()
    assert(near(projection.m[5], 0.2) and near(projection.m[0], 0.1))
    camera:set_projection(projection)
    local world = camera:get_world_matrix()
    assert(world.m[14] == -10 and near(camera:get_view_matrix().m[14], 10))
    camera:set_world_matrix { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1 }
    assert(is(camera:get_transform(), 4, 5, 6))
    camera:set_transform({ 1, 2, 3 }, { 0, 1, 0, 0 })
    local position, rotation = camera:get_transform()
    assert(is(position, 1, 2, 3) and math.abs(rotation.y) == 1)
    camera:set_origin { 1, 0, 0 }
    assert(camera:get_origin()[0] == 1)

    camera = gp.Camera()
    fails(gp.ERROR_UNSUPPORTED, camera.get_orbit, camera)
    camera:set_orbit(gp.default_orbit())
    camera:orbit_rotate(0.5, 0.25)
    camera:orbit_zoom(1)
    camera:orbit_pan(2, 0)
    camera:orbit_update()
    local orbit = camera:get_orbit()
    assert(near(orbit.yaw, 0.5) and near(orbit.pitch, 0.25) and near(orbit.distance, 9) and near(math.abs(orbit.target.x), 2, 1e-3))
end

function tests.solver()
    local scene, solver = gp.Scene(), gp.Solver { substeps = 4 }
    solver:set_gravity { 0, -10, 0 }
    solver:set_substeps(5)
    local free = solver:add_particles({ { 0, 5, 0 }, { 1, 5, 0 } })
    solver:set_velocities(free, 1, { { 3, 0, 0 } })
    solver:step(scene, 0.1)
    assert(is(solver:get_velocities(free, 0, 1)[0], 0, -1, 0) and is(solver:get_positions(free, 1, 1)[0], 1.3, 4.95, 0))
    solver:set_masses(free, 0, { 2, 4 })
    assert(solver:get_masses(free, 0, 2)[1] == 4)
    solver:set_forces(free, 0, { { 0, 20, 0 }, { 0, 40, 0 } }) -- weightless
    solver:step(nil, 0.1)
    assert(is(solver:get_velocities(free, 0, 1)[0], 0, -1, 0))

    local plane = scene:add(gp.Plane(UP, 0))
    solver:set_radii(free, 0, { 0.5, 0.5 })
    solver:set_positions(free, 0, { { 0, 0.6, 0 }, { 9, 0.6, 0 } })
    solver:set_forces(free, 0, { { 0, 0, 0 }, { 0, 0, 0 } })
    for _ = 1, 30 do solver:step(scene, 0.02) end
    assert(near(solver:get_positions(free, 0, 1)[0].y, 0.5, 1e-3))
    local contacts, count = solver:get_contacts()
    assert(count == 2 and contacts[0].model == plane and contacts[0].normal.y == 1)

    local rope = solver:add_rope({ { 0, 8, 0 }, { 1, 8, 0 }, { 2, 8, 0 } }, 0, { mass = 3 })
    assert(solver:get_body_info(rope).kind == gp.BODY_ROPE)
    solver:set_pinned(rope, 0, 1, true)
    local tie = solver:add_distance(rope, 0, 2, -1, 0)
    local constraints, number = solver:get_constraints(rope)
    assert(number == 3 and constraints[2].id == tie and constraints[2].rest_length == 2)
    solver:remove_constraint(rope, tie)
    assert(select(2, solver:get_constraints(rope)) == 2)
    local hook = scene:add(gp.Sphere({ 0, 0, 0 }, 0.1), { { 0, 8, 0 }, { 0, 0, 0, 1 }, 1 }, { layers = 2 })
    solver:attach(scene, rope, 0, hook, { 0, 0, 0 })
    scene:set_transform(hook, { { 0, 9, 0 }, { 0, 0, 0, 1 }, 1 })
    local steps, leftover = solver:advance(scene, 0.025)
    assert(steps == 1 and near(leftover, 0.5) and near(solver:get_positions(rope, 0, 1)[0].y, 8 + 2 / 3))
    assert(solver:get_stats(rope).pinned_count == 1 and solver:get_stats(0).particle_count == 5)
    solver:detach(rope, 0)
    fails(gp.ERROR_INVALID_ARGUMENT, solver.detach, solver, rope, 0)

    local cloth = solver:add_cloth({ 0, 3, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, 3, 3)
    assert(select(2, solver:get_triangles(cloth)) == 24)
    local shirt = solver:add_cloth_mesh(pyramid(), IDENTITY)
    assert(solver:get_body_info(shirt).particle_count == 5)
    solver:remove_body(cloth)
    local bodies, left = solver:get_bodies()
    assert(left == 3 and bodies[0] == free)
    local snapshot, past = solver:get_snapshot(), solver:get_hash()
    solver:step(scene, 0.01)
    assert(not same(past, solver:get_hash()))
    solver:restore(snapshot)
    assert(same(past, solver:get_hash()))
    local copy = gp.Scene()
    copy:restore(nil, scene:get_snapshot(true))
    assert(same(copy:get_hash(), scene:get_hash()))
    solver:wake(0)
    assert(select(2, solver:get_sleeping()) == 0)
    solver:set_origin { 0, 1, 0 }
    assert(solver:get_origin()[1] == 1 and near(solver:get_positions(free, 0, 1)[0].y, -0.5, 1e-3))
end

function tests.substeps_are_as_many_as_asked_for_or_as_a_target_takes()
    local function substeps(desc)
        local solver = gp.Solver(desc)
        local cloth = solver:add_cloth({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, 3, 3)
        solver:set_pinned(cloth, 0, 1, true)
        assert(solver:get_substeps(cloth) == 0)
        for _ = 1, 5 do solver:step(nil, 0.01) end
        return solver:get_substeps(cloth)
    end
    assert(substeps {} == 8 and substeps { max_strain = 1e-6 } > 8)
end

function tests.a_string_holds_a_weight_and_a_pyramid_keeps_its_volume()
    local scene, solver = gp.Scene(), gp.Solver()
    local hook = scene:add(gp.Sphere({ 0, 0, 0 }, 0.1), nil, { tag = 5 })
    local weights = solver:add_particles(gp.array('vec3', { { 0, 0, 0 }, { 0, -1, 0 } }), { mass = 2, layers = 0 })
    solver:attach(scene, weights, 0, hook, { 0, 0, 0 })
    local string = solver:add_max_distance(weights, 0, 1, 2, 1e-6)
    solver:set_constraint_damping(weights, string, 50)
    assert(solver:get_constraint_kinds(weights, { string })[0] == gp.CONSTRAINT_MAX_DISTANCE)
    assert(solver:get_attachments(weights)[0].model == hook)
    for _ = 1, 300 do solver:step(scene, 0.01) end
    assert(near(solver:get_positions(weights, 1, 1)[0].y, -2, 1e-3))
    local impulses, count = solver:get_impulses()
    assert(count == 1 and impulses[0].model == hook and impulses[0].tag == 5)
    assert(near(impulses[0].linear.y, -2 * 9.81 * 0.01, 5e-3))
    local ball = solver:add_cloth_mesh(pyramid(), IDENTITY)
    solver:set_volume(ball, -1, 0)
    local volume, pressure = solver:get_volume(ball)
    assert(near(volume, 8 / 3) and pressure == 0)
    local rest, compliance = solver:get_volume_settings(ball)
    assert(rest == volume and compliance == 0)
    solver:set_volume(ball, 1, math.huge)
    fails(gp.ERROR_UNSUPPORTED, solver.get_volume, solver, ball)
end

function tests.settings_change_live()
    local solver = gp.Solver()
    local settings = solver:get_settings()
    settings.substeps = 5
    solver:set_settings(settings)
    assert(solver:get_settings().substeps == 5)
    solver:set_worker_count(2)
    assert(solver:get_worker_count() == 2 and solver:get_leftover() == 0)
    local rope = solver:add_rope(gp.array('vec3', { { 0, 0, 0 }, { 0, -1, 0 } }), 0)
    solver:set_pinned(rope, 0, 1, true)
    local pinned = solver:get_pinned(rope, 0, 2)
    assert(pinned[0] == 1 and pinned[1] == 0)
    local body = solver:get_body_settings(rope)
    body.damping = 0.5
    solver:set_body_settings(rope, body)
    assert(solver:get_body_settings(rope).damping == 0.5)
    local links = { solver:get_constraints(rope)[0].id }
    local link = solver:get_constraint_settings(rope, links)
    link[0].rest_length = 0.5
    solver:set_constraint_settings(rope, links, link)
    assert(near(solver:get_radii(rope, 0, 2)[1], 0.01, 1e-6))
    assert(solver:get_forces(rope, 0, 2)[1].y == 0)
    for _ = 1, 10 do solver:step(nil, 0.01) end
    assert(near(solver:get_positions(rope, 1, 1)[0].y, -0.5, 1e-5))
end

function tests.wind_carries_balls_along()
    local solver = gp.Solver { gravity = { 0, 0, 0 } }
    local balls = solver:add_particles(gp.array('vec3', { { 0, 0, 0 }, { 1, 0, 0 } }))
    solver:set_wind(balls, { { 2, 0, 0 }, 1e4, 0.5, 0 })
    assert(solver:get_wind(balls).density == 1e4)
    solver:set_air_velocities(balls, 1, { { 0, 3, 0 } })
    assert(solver:get_air_velocities(balls, 0, 2)[1].y == 3)
    for _ = 1, 500 do solver:step(nil, 0.01) end
    local speeds = solver:get_velocities(balls, 0, 2)
    assert(speeds[0].x > 1.8 and speeds[1].y > 2.7)
end

function tests.a_cluster_holds_out_a_particle_until_it_ends()
    local solver = gp.Solver()
    local plank = solver:add_particles(gp.array('vec3', { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }))
    solver:set_pinned(plank, 0, 2, true)
    local cluster = solver:add_cluster(plank, { 0, 1, 2 })
    local clusters, count = solver:get_clusters(plank)
    assert(count == 1 and clusters[0] == cluster)
    local particles, number = solver:get_cluster_particles(plank, cluster)
    assert(number == 3 and particles[0] == 0 and particles[2] == 2)
    for _ = 1, 30 do solver:step(nil, 0.01) end
    local place = solver:get_positions(plank, 2, 1)[0]
    assert(near(place.x, 2, 1e-5) and math.abs(place.y) < 1e-5)
    solver:remove_cluster(plank, cluster)
    for _ = 1, 30 do solver:step(nil, 0.01) end
    assert(solver:get_positions(plank, 2, 1)[0].y < -0.4)
    fails(gp.ERROR_INVALID_ID, solver.remove_cluster, solver, plank, cluster)
end

function tests.a_rope_breaks_under_its_weight_and_cloth_is_cut()
    local solver = gp.Solver()
    local rope = solver:add_rope(gp.array('vec3', { { 0, 0, 0 }, { 0, -1, 0 } }), 0)
    solver:set_pinned(rope, 0, 1, true)
    local links = { solver:get_constraints(rope)[0].id }
    solver:set_breaking_forces(rope, links, gp.array('float', { 3 }))
    assert(solver:get_breaking_forces(rope, links)[0] == 3)
    local breaks, count = solver:get_breaks()
    assert(count == 0)
    for _ = 1, 10 do
        if count == 0 then solver:step(nil, 0.01) end
        breaks, count = solver:get_breaks()
    end
    assert(count == 1 and breaks[0].body == rope and breaks[0].constraint == links[1] and breaks[0].load > 3)
    assert(breaks[0].torn_particle == gp.NO_PARTICLE)
    fails(gp.ERROR_INVALID_ID, solver.break_constraint, solver, rope, links[1])
    local sheet = solver:add_cloth({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, 3, 3)
    assert(solver:break_constraint(sheet, solver:get_constraints(sheet)[1].id).new_particle == 9)
end

function tests.one_of_two_balls_slides_over_ice()
    local solver, scene = gp.Solver(), gp.Scene()
    scene:add(gp.Plane({ 0, 1, 0 }, 0))
    local balls = solver:add_particles(gp.array('vec3', { { 0, 0.01, 0 }, { 0, 0.01, 1 } }))
    solver:set_friction_factors(balls, 1, { 0 })
    local factors = solver:get_friction_factors(balls, 0, 2)
    assert(factors[0] == 1 and factors[1] == 0)
    solver:set_velocities(balls, 0, { { 1, 0, 0 }, { 1, 0, 0 } })
    for _ = 1, 50 do solver:step(scene, 0.01) end
    local speeds = solver:get_velocities(balls, 0, 2)
    assert(speeds[0].x == 0 and near(speeds[1].x, 1, 1e-5))
end

function tests.a_ball_presses_the_one_that_it_lies_on()
    local solver, desc = gp.Solver(), { mass = 2, radius = 0.5, body_layers = 1 }
    local lower = solver:add_particles(gp.array('vec3', { { 0, 0, 0 } }), desc)
    local upper = solver:add_particles(gp.array('vec3', { { 0, 1, 0 } }), desc)
    solver:set_pinned(lower, 0, 1, true)
    for _ = 1, 20 do solver:step(nil, 0.01) end
    local contacts, count = solver:get_body_contacts()
    assert(count == 1 and contacts[0].body_a == lower and contacts[0].body_b == upper)
    assert(contacts[0].normal.y == 1 and near(contacts[0].impulse, 0.1962, 2e-3))
end

function tests.a_ball_hangs_below_its_animation_target()
    local solver = gp.Solver()
    local balls = solver:add_particles(gp.array('vec3', { { 0, 0, 0 }, { 1, 0, 0 } }))
    solver:set_animation_targets(balls, 1, { { { 1, 0, 0 }, { 0, 1, 0 }, 0.25, math.huge } })
    local targets = solver:get_animation_targets(balls, 0, 2)
    assert(targets[0].max_distance == math.huge and targets[1].max_distance == 0.25)
    for _ = 1, 60 do solver:step(nil, 0.01) end
    assert(solver:get_positions(balls, 1, 1)[0].y == -0.25)
end

function tests.a_joint_holds_a_particle_of_another_body()
    local solver = gp.Solver()
    local nail = solver:add_particles(gp.array('vec3', { { 0, 0, 0 } }), { mass = 2 })
    local weight = solver:add_particles(gp.array('vec3', { { 0, -1, 0 } }), { mass = 2 })
    solver:set_pinned(nail, 0, 1, true)
    local joint = solver:join(nail, 0, weight, 0, -1, 0)
    for _ = 1, 20 do solver:step(nil, 0.01) end
    local joints, count = solver:get_joints(weight)
    assert(count == 1 and joints[0].id == joint and joints[0].body_a == nail and joints[0].body_b == weight)
    assert(near(joints[0].force, 2 * 9.81, 0.01))
    solver:unjoin(joint)
    local _, left = solver:get_joints(0)
    assert(left == 0)
    fails(gp.ERROR_INVALID_ID, solver.unjoin, solver, joint)
end

function tests.errors_have_the_librarys_message()
    local scene = gp.Scene()
    assert(fails(gp.ERROR_INVALID_ARGUMENT, scene.add, scene, gp.Sphere({ 0, 0, 0 }, -1)):find 'radius')
    fails(gp.ERROR_INVALID_ID, scene.remove, scene, 12345)
    fails(gp.ERROR_UNSUPPORTED, gp.transform, pyramid(), IDENTITY)
    fails(gp.ERROR_UNSUPPORTED, scene.get_shape, scene, scene:add(pyramid()))
    raises('not a shape', scene.add, scene, 'ball')
    raises('vieport', gp.Camera, { vieport_width = 3 })
    raises('convert', scene.raycast_batch, scene, gp.array('segment', 7))
    raises('lengths', scene.sweep_sphere_batch, scene, gp.array('sphere', 2), gp.array('vec3', 3))
    raises('pointer', scene.raycast_batch, scene, ffi.cast('gphys_ray*', gp.array('ray', 2)))
    raises('whole', scene.raycast_batch, scene, gp.array('vec3', 2))
    raises('length', scene.raycast_batch, scene, gp.array('ray', 2), nil, gp.array('hit', 3))
    assert(gp.status_name(gp.NO_HIT) == 'GPHYS_NO_HIT' and gp.VERSION:match '^%d+%.%d+%.%d+$')
end

function tests.use_after_close_is_an_error()
    local scene, mesh = gp.Scene(), pyramid()
    scene:add(mesh)
    mesh:close()
    mesh:close()
    raises('mesh is closed', scene.add, scene, mesh)
    raises('mesh is closed', gp.raycast, mesh, ahead)
    raises('mesh is closed', scene.add_batch, scene, mesh, { IDENTITY })
    assert(scene:raycast({ { 0.1, 5, 0.1 }, { 0, -1, 0 }, 10 })) -- the model holds it
    scene:close()
    raises('scene is closed', scene.get_models, scene)
    raises('scene is closed', gp.Camera().pick, gp.Camera(), scene, 0, 0)
end

function tests.the_collector_frees()
    -- The allocator of a desc sees what is taken and given back.
    ffi.cdef 'void* aligned_alloc(size_t, size_t); void free(void*);'
    local bytes = 0
    local allocator = gp.Allocator()
    allocator.allocate = function(_, size, alignment)
        bytes = bytes + tonumber(size)
        return ffi.C.aligned_alloc(alignment, math.ceil(tonumber(size) / tonumber(alignment)) * alignment)
    end
    allocator.release = function(_, memory, size)
        bytes = bytes - tonumber(size)
        ffi.C.free(memory)
    end
    jit.off() -- callbacks from compiled code are not allowed,
    jit.flush() -- nor from code that is compiled already
    do
        local mesh = gp.Mesh({ 0, 0, 0, 1, 0, 0, 0, 1, 0 }, { 0, 1, 2 }, { allocator = allocator })
        local scene = gp.Scene { allocator = allocator }
        scene:add(mesh)
        assert(bytes > 0)
    end
    collectgarbage()
    collectgarbage()
    assert(bytes == 0, bytes)
    jit.on()
    allocator.allocate:free()
    allocator.release:free()
end

local failed = 0
for name, test in pairs(tests) do
    local fine, message = xpcall(test, function(caught) return debug.traceback(tostring(caught)) end)
    print((fine and 'passed ' or 'FAILED ') .. name)
    if not fine then
        failed = failed + 1
        print(message)
    end
end
os.exit(failed == 0 and 0 or 1)
