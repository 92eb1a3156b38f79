# frozen_string_literal: true

# The package: every function with an answer that is known, batches against single calls, errors, ownership.
require 'minitest/autorun'
require 'gamephys'

class TestGamephys < Minitest::Test
  include Gamephys

  UP = [0, 1, 0].freeze
  STILL = [0, 0, 0, 1].freeze
  IDENTITY = Transform.new(position: [0, 0, 0]).freeze
  BALL = Sphere.new([0, 0, 5], 1).freeze
  AHEAD = Ray.new([0, 0, 0], [0, 0, 1], 100).freeze

  def pyramid(**desc)
    Mesh.new([[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1], [0, 2, 0]],
             [0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4], **desc)
  end

  def assert_vector(expected, actual, tolerance = 1e-5)
    assert_equal expected.size, actual.size
    expected.zip(actual) { |a, b| assert_in_delta a, b, tolerance }
  end

  def assert_fails(status, &call)
    caught = assert_raises(Error, InvalidArgument, InvalidId, &call)
    assert_equal status, caught.status
    caught.message
  end

  def test_shapes
    Gamephys.validate(BALL)
    assert_equal Aabb.new([-1, -1, 4], [1, 1, 6]), Gamephys.bounds(BALL)
    assert_nil Gamephys.bounds(Plane.new(UP, 0))
    moved = Gamephys.transform(Aabb.new([0, 0, 0], [2, 2, 2]), { position: [1, 0, 0] })
    assert_equal [2, 1, 1], moved.center
    assert Gamephys.contains?(BALL, [0, 0, 4])
    refute Gamephys.contains?(BALL, [0, 0, 3.5])
    assert Gamephys.contains?(BALL, [0, 0, 3.5], tolerance: 0.5)
    assert_equal [1, 0], Gamephys.contains_batch(BALL, [[0, 0, 5], [0, 0, 3]]).to_a
    assert_equal 4, Gamephys.closest_point(BALL, [0, 0, 0]).distance
    assert_equal [4, 3], Gamephys.closest_point_batch(BALL, [[0, 0, 0], [0, 0, 9]]).map(&:distance)
    a, b, distance = Gamephys.segment_closest_points([[0, 0, 0], [2, 0, 0]], [[1, 3, -1], [1, 3, 1]])
    assert_equal [[1, 0, 0], [1, 3, 0], 3], [a, b, distance]
    assert Gamephys.overlaps?(BALL, Aabb.new([0, 0, 0], [1, 1, 4]))
    refute Gamephys.overlaps?(BALL, Aabb.new([0, 0, 0], [1, 1, 3]))
    touching = Gamephys.overlaps_batch([Sphere.new([0, 0, 0], 1), Sphere.new([0, 9, 0], 1)], Plane.new(UP, 0))
    assert_equal [1, 0], touching.to_a
    assert_equal [SIDE_INSIDE, 4], Gamephys.classify_plane(BALL, Plane.new([0, 0, 1], 0))
    assert_equal 4, Gamephys.raycast(BALL, AHEAD).t
    aside = Ray.new([0, 3, 0], [0, 0, 1], 9)
    assert_nil Gamephys.raycast(BALL, aside)
    assert_equal [4, Float::INFINITY], Gamephys.raycast_batch(BALL, [AHEAD, aside]).map(&:t)
    assert_equal 0.5, Gamephys.segment_test(BALL, [[0, 0, 0], [0, 0, 8]]).t
    assert_in_delta 0.3, Gamephys.sweep_sphere(BALL, Sphere.new([0, 0, 0], 1), [0, 0, 10]).t
  end

  def test_frusta
    camera = Camera.new
    frustum = camera.get_frustum
    assert_equal SIDE_INSIDE, Gamephys.classify_frustum(BALL, frustum)
    corners = Gamephys.frustum_corners(frustum)
    assert_equal 8, corners.size
    assert_in_delta 1000, corners[7][2], 0.01
    assert_vector camera.get_corners[3], corners[3]
    again = Gamephys.frustum_from_matrix(camera.get_view_projection_matrix, DEPTH_ZERO_TO_ONE, false)
    assert_equal SIDE_OUTSIDE, Gamephys.classify_frustum(Sphere.new([0, 0, -5], 1), again)
  end

  def test_meshes
    report = Gamephys.mesh_check([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 7])
    assert_equal [1, 1], [report.triangle_count, report.out_of_range_count]
    mesh = pyramid
    assert_equal 0, mesh.get_report.open_edge_count
    assert_equal [0, 2, 0], mesh.get_vertices[4]
    assert_equal [18, 4], [mesh.get_indices.size, mesh.get_indices[17]]
    assert_equal mesh.get_indices.to_a, Mesh.from_snapshot(mesh.get_snapshot).get_indices.to_a
    down = Ray.new([0.3, 5, 0.2], [0, -1, 0], 10)
    first, last = mesh.raycast_all(down).to_a
    assert first.t < last.t && last.t == 5
    assert mesh.raycast_any?(down)
    assert_equal [1, 1], mesh.raycast_any_batch([down, down]).to_a
    assert_equal mesh.raycast_all(down).to_a[0].t, mesh.raycast_distance_batch([down, down]).to_a[1].t
    assert_equal 4, mesh.overlap(Sphere.new([0, 2, 0], 0.1)).size
    assert_equal 6, mesh.get_octree_stats.item_count
    assert_equal 0, mesh.get_octree_boxes[0].depth
    assert_equal first.triangle, Gamephys.raycast(mesh, down).triangle
  end

  def test_a_batch_may_be_empty
    scene = Scene.new
    assert_equal [0, 0], [scene.raycast_batch([]).size, scene.add_batch([]).size]
    values, offsets = scene.overlap_batch([])
    assert_equal [0, [0]], [values.size, offsets.to_a]
    assert_raises(TypeError) { scene.add_batch([3]) }
  end

  def test_ids_that_are_no_whole_numbers_of_32_bits_are_refused
    scene = Scene.new
    models = Array.new(2) { scene.add(BALL) }
    assert_raises(TypeError) { scene.remove(models[0] + 0.5) }
    assert_raises(RangeError) { scene.remove(models[0] + 2**32) }
    assert_raises(TypeError) { scene.remove_batch([models[0] + 0.5]) }
    [-1, 2**32 + models[0], 2**64 + models[0]].each { |id| assert_raises(RangeError) { scene.remove_batch([models[1], id]) } }
    assert_raises(RangeError) { scene.raycast_filtered(AHEAD, { ignored_models: [2**32 + models[0]] }) }
    assert(models.all? { |model| scene.has?(model) })
  end

  def test_memory_that_is_too_short_is_refused
    scene = Scene.new
    short = FFI::MemoryPointer.new(:uint8, Ray::BYTES)
    assert_raises(ArgumentError) { Records.new(Ray, 2, short) }
    assert_raises(ArgumentError) { Records.new(Ray, -1) }
    assert_raises(ArgumentError) { scene.raycast_batch(FFI::Pointer.new(short.address)) } # of unknown length
    assert_raises(ArgumentError) { scene.set_origin([7, 7]) }
    assert_equal(1, scene.raycast_any_batch(Records.new(Ray, 1, short).tap { |rays| rays[0] = AHEAD }).size)
  end

  def test_models
    scene = Scene.new(reserve_models: 4, worker_count: 2)
    model = scene.add(BALL, tag: 7)
    two = scene.add_batch([Sphere.new([9, 0, 0], 1), Sphere.new([9, 5, 0], 2)], IDENTITY).to_a
    assert scene.has?(model) && scene.include?(two[1])
    refute scene.has?(12_345)
    assert_equal 3, scene.get_models.size
    assert_equal 7, scene.get_info(model).tag
    assert_equal Sphere.new([9, 5, 0], 2), scene.get_shape(two[1])
    assert_equal 10, scene.get_bounds(two[0]).max[0]
    assert_equal 7, scene.get_scene_bounds.max[1]
    scene.set_layers(model, 4)
    scene.set_tag(model, 8)
    assert_nil scene.raycast(AHEAD, layers: 3)
    assert_equal 8, scene.raycast(AHEAD, layers: 4).tag
    scene.set_parent(two[0], model, true)
    scene.set_transform(model, [[0, 1, 0], STILL, 1])
    assert_equal model, scene.get_info(two[0]).parent
    ids = [model, two[0]]
    assert_equal [1, 0], scene.get_transforms(ids).map { |each| each.position[1] }
    assert_equal [1, 1], scene.get_world_transforms(ids).map { |each| each.position[1] }
    scene.set_transforms(ids, [IDENTITY, IDENTITY])
    assert_equal 0, scene.get_world_transforms(ids)[1].position[1]
    scene.validate
    scene.remove_subtree(model)
    refute scene.has?(two[0])
    scene.remove(two[1])
    scene.remove_batch(scene.add_batch([BALL, BALL, BALL]))
    assert_nil scene.get_scene_bounds
    scene.add(BALL)
    scene.rebuild_octree
    assert scene.maintain_octree(1000)
    scene.set_worker_count(2)
    assert_equal 2, scene.get_worker_count
    scene.clear
    assert_equal 0, scene.get_models.size
    scene.set_origin([1e9 + 0.5, 0, 0])
    assert_equal [1e9 + 0.5, 0, 0], scene.get_origin
  end

  def test_models_with_descs_of_their_own
    scene = Scene.new
    root = scene.add(BALL)
    read_back = ->(models) { models.map { |model| scene.get_info(model).then { |info| [info.parent, info.layers, info.tag] } } }
    some = [{ parent: root, layers: 2, tag: 5 }, { tag: 6 }, {}]
    known = [[root, 2, 5], [0, 1, 6], [0, 1, 0]]
    assert_equal known, read_back.(scene.add_described_batch([BALL] * 3, nil, some))
    assert_equal known, read_back.(scene.add_described_batch(BALL, nil, some))
    assert_equal known[0, 1] * 2, read_back.(scene.add_described_batch([BALL] * 2, [IDENTITY] * 2, some[0]))
    assert_equal [[0, 1, 0]] * 2, read_back.(scene.add_described_batch([BALL] * 2))
    assert_equal 0, scene.add_described_batch(BALL, nil, []).size
    count = scene.get_models.size
    assert_raises(ArgumentError) { scene.add_described_batch([BALL] * 2, nil, some) }
    assert_raises(ArgumentError) { scene.add_described_batch([BALL] * 2, nil, [{}, { weight: 1 }]) }
    assert_raises(TypeError) { scene.add_described_batch([BALL] * 2, nil, 7) }
    assert_raises(InvalidId) { scene.add_described_batch([BALL] * 2, nil, { parent: 12_345 }) }
    assert_equal count, scene.get_models.size
  end

  def test_batches_answer_as_single_calls_do
    scene = Scene.new
    30.times { |i| scene.add(Sphere.new([3 * Math.sin(i), 3 * Math.cos(2 * i), i / 3.0], 0.7)) }
    directions = Array.new(200) { |i| [Math.sin(i) / 2, Math.cos(3 * i) / 2, 1] }
    rays = directions.map { |direction| Ray.new([0, 0, -5], direction, Float::INFINITY) }
    segments = directions.map { |x, y, _| Segment.new([0, 0, -5], [10 * x, 10 * y, 5]) }
    spheres = directions.map { Sphere.new([0, 0, -5], 0.2) }
    hits = scene.raycast_batch(rays)
    batches = [hits, scene.segment_test_batch(segments), scene.nearest_batch(directions), scene.sweep_sphere_batch(spheres, directions)]
    singles = [rays.map { |each| scene.raycast(each) }, segments.map { |each| scene.segment_test(each) },
               directions.map { |each| scene.nearest(each) }, spheres.zip(directions).map { |pair| scene.sweep_sphere(*pair) }]
    batches.zip(singles) do |batch, single|
      assert_equal single, batch.map { |each| each unless each.model.zero? }
    end
    any = scene.raycast_any_batch(rays).to_a
    assert_equal any, (rays.map { |each| scene.raycast_any?(each) ? 1 : 0 })
    assert any.include?(0) && any.include?(1)
    assert_equal hits.map { |each| [each.t, each.model] }, (scene.raycast_distance_batch(rays).map { |each| [each.t, each.model] })
    all, offsets = scene.raycast_all_batch(rays)
    rays.each_with_index { |each, i| assert_equal scene.raycast_all(each).to_a, all.to_a[offsets[i]...offsets[i + 1]] }

    packed = Ray.pack_all(rays)
    assert_equal hits.to_a, scene.raycast_batch(packed).to_a
    room = Records.new(Hit, 200)
    assert_same room, scene.raycast_batch(packed, out: room)
    assert_equal hits.to_s, room.to_s
    memory = FFI::MemoryPointer.from_string(packed)
    assert_raises(ArgumentError) { scene.raycast_batch(memory) } # one byte too many: the string's end
    assert_equal hits.to_s, scene.raycast_batch(Records.new(Ray, 200, memory)).to_s
  end

  def test_filters_have_lists_of_models_and_batches_a_filter_for_each
    scene = Scene.new
    models = Array.new(4) { |i| scene.add(Sphere.new([0, 0, 4 * i], 1)) }
    ray, near = Ray.new([0, 0, -5], [0, 0, 1], Float::INFINITY), Sphere.new([0, 0, 2], 2)
    [models[0, 2], models[0, 2].pack('L*'), scene.overlap(near)].each do |list|
      filter = { ignored_models: list }
      GC.start
      assert_equal models[2], scene.raycast_filtered(ray, filter).model
      assert_equal models[2, 2], scene.overlap_filtered(Sphere.new([0, 0, 0], 50), filter).to_a
    end
    [[], nil].each { |list| assert_equal models[0], scene.raycast_filtered(ray, { ignored_models: list }).model }
    met = ->(filters) { scene.raycast_filtered_batch([ray] * 3, filters).map(&:model) }
    assert_equal models[0, 3], met.call([{}, { ignored_model: models[0] }, { ignored_models: models[0, 2] }])
    assert_equal [models[2]] * 3, met.call({ ignored_models: models[0, 2] })
    assert_equal [models[0]] * 3, met.call(nil)
    assert_equal [0, 2, 2], scene.overlap_filtered_batch([near, near], [{}, { ignored_models: models }])[1].to_a
    assert_raises(ArgumentError) { met.call([{}, {}]) }
    assert_raises(ArgumentError) { met.call({ ignored_count: 1 }) }
  end

  def test_filters_leave_out_models
    scene = Scene.new
    body = scene.add(BALL)
    scene.add(BALL, [[0, 0, 3], STILL, 1], parent: body)
    target = scene.add(BALL, [[0, 0, 10], STILL, 1])
    filter = { ignored_model: body, flags: FILTER_SUBTREE }
    ray, segment = Ray.new([0, 0, 0], [0, 0, 1], Float::INFINITY), Segment.new([0, 0, 0], [0, 0, 20])
    moving, large, way = Sphere.new([0, 0, 0], 0.5), Sphere.new([0, 0, 0], 50), [0, 0, 20]
    assert_equal body, scene.raycast_filtered(ray).model
    singles = [scene.raycast_filtered(ray, filter), scene.segment_test_filtered(segment, filter),
               scene.nearest_filtered([0, 0, 0], filter), scene.sweep_sphere_filtered(moving, way, filter)]
    assert_equal [target] * 4, singles.map(&:model)
    assert scene.raycast_any_filtered?(ray, filter)
    assert_equal [target], scene.raycast_all_filtered(ray, filter).map(&:model)
    assert_equal [target], scene.overlap_filtered(large, filter).to_a
    batches = [scene.raycast_filtered_batch([ray, ray], filter), scene.segment_test_filtered_batch([segment, segment], filter),
               scene.nearest_filtered_batch([way, way], filter), scene.sweep_sphere_filtered_batch([moving, moving], [way, way], filter)]
    assert_equal [[target, target]] * 4, (batches.map { |batch| batch.map(&:model) })
    assert_equal [1, 1], scene.raycast_any_filtered_batch([ray, ray], filter).to_a
    assert_equal [target, target], scene.raycast_distance_filtered_batch([ray, ray], filter).map(&:model)
    assert_equal [0, 1, 2], scene.raycast_all_filtered_batch([ray, ray], filter)[1]
    assert_equal [target, target], scene.overlap_filtered_batch([large, large], filter)[0].to_a
    camera = Camera.new
    camera.look_at([0, 0, -10], [0, 0, 0], UP)
    assert_equal target, camera.pick_filtered(scene, 400, 300, filter).model
    assert_equal [target, 0], camera.pick_filtered_batch(scene, [[400, 300], [1, 1]], filter).map(&:model)
    lists = [camera.pick_rectangle_filtered(scene, 0, 0, 800, 600, filter), camera.cull_filtered(scene, filter),
             scene.cull_filtered(camera.get_frustum, filter)]
    assert_equal [[target]] * 3, lists.map(&:to_a)
    views = [camera.get_frustum, camera.get_frustum]
    assert_equal [0, 3, 6], scene.cull_batch(views)[1].to_a
    assert_equal [target, target], scene.cull_filtered_batch(views, filter)[0].to_a
  end

  def test_solids_move_up_to_what_they_touch_and_out_of_what_they_overlap
    centred = Sphere.new([0, 0, 0], 1)
    assert_equal 0.5, Gamephys.sweep(centred, Sphere.new([0, 4, 0], 1), [0, -4, 0]).t
    assert_equal 0.5, Gamephys.penetration(centred, Sphere.new([0, 0, 1.5], 1)).depth
    scene = Scene.new
    scene.add(centred)
    target = scene.add(centred, [[0, 0, 10], STILL, 1])
    moving, deep, way, filter = Sphere.new([0, 0, 5], 1), Sphere.new([0, 0, 8.5], 1), [0, 0, 6], { ignored_model: target }
    assert_equal target, scene.sweep(moving, way).model
    assert_nil scene.sweep_filtered(moving, way, filter)
    assert_equal [target, target], scene.sweep_batch([moving, moving], [way, way]).map(&:model)
    assert_equal [0, 0], scene.sweep_filtered_batch([moving, moving], [way, way], filter).map(&:model)
    assert_equal [0.5], scene.penetration(deep).map(&:depth)
    assert_empty scene.penetration_filtered(deep, filter).to_a
    ways_out, ends = scene.penetration_batch([deep, moving])
    assert_equal [[target], [0, 1, 1]], [ways_out.map(&:model), ends.to_a]
    assert_equal [0, 0, 0], scene.penetration_filtered_batch([deep, moving], filter)[1].to_a
    others = [Sphere.new([0, 4, 0], 1), Sphere.new([0, 0, 1.5], 1)]
    assert_equal [0.5, 0], Gamephys.sweep_batch(centred, others, [[0, -4, 0], [0, -4, 0]]).map(&:t)
    assert_equal [-Float::INFINITY, 0.5], Gamephys.penetration_batch(centred, others).map(&:depth)
  end

  def test_shapes_change_and_trees_and_cameras_are_read
    scene = Scene.new
    body = scene.add(BALL)
    head = scene.add(BALL, parent: body)
    scene.set_shape(body, Sphere.new([0, 0, 0], 5))
    assert_equal 5, scene.get_bounds(body).max[0]
    scene.set_scale(body, [2, 2, 2])
    assert_equal [10, 2], [scene.get_bounds(body).max[0], scene.get_scale(body)[1]]
    assert_equal [[body], [head]], [scene.get_roots.to_a, scene.get_children(body).to_a]
    camera = Camera.new
    camera.set_orthographic(10, 1, 100)
    camera.set_viewport(200, 100)
    assert_equal [PROJECTION_ORTHOGRAPHIC, 10, 1, 100], camera.get_projection
    assert_equal [200, 100], camera.get_viewport
  end

  def test_cameras_see_by_aspect_in_a_window_from_the_near_plane_on
    camera = Camera.new
    camera.set_perspective_aspect(1, 2, 1, 100)
    assert_equal [2, true], camera.get_aspect
    assert_equal [LEFT_HANDED, DEPTH_ZERO_TO_ONE, false], camera.get_conventions
    camera.set_orthographic_size(8, 6, 1, 100)
    assert_equal [8, 6], camera.get_image_size
    camera.set_viewport_origin(800, 0)
    assert_equal [800, 0], camera.get_viewport_origin
    camera.set_perspective(1, 1, 100)
    assert_equal 1, camera.pick_ray(1200, 300).origin[2]
    camera.set_pick_start(PICK_FROM_CENTRE)
    assert_equal PICK_FROM_CENTRE, camera.get_pick_start
    assert_equal 0, camera.pick_ray(1200, 300).origin[2]
    view = camera.get_view_matrix
    camera.set_view_matrix(view)
    assert_equal 0, Gamephys.mat4_orthonormality(view)
    corners = camera.get_rectangle_corners(800, 0, 1600, 600)
    assert_equal camera.get_corners.map(&:to_a), corners.map(&:to_a)
    assert_equal [0, 0, 0], camera.get_rectangle_frustum(800, 0, 1200, 600).origin.to_a
    camera.set_orbit(Gamephys.default_orbit)
    camera.set_orbit_speeds(OrbitSpeeds.new(0.5, 1, 2, 3, 4))
    assert_equal 4, camera.get_orbit_speeds.pan_y
    x1, y2, z3 = Plane.new([1, 0, 0], 1), Plane.new([0, 1, 0], 2), Plane.new([0, 0, 1], 3)
    assert_equal [1, 2, 3], Gamephys.planes_intersection(x1, y2, z3).to_a
    assert_nil Gamephys.planes_intersection(x1, y2, y2)
    assert_equal [1, 2, 3], Gamephys.planes_intersection_batch([x1, x1], [y2, y2], [y2, z3])[1].to_a
  end

  def test_a_mesh_deforms_and_its_models_with_it
    mesh = Mesh.new([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [0, 1, 2], deformable: 1)
    scene = Scene.new
    model = scene.add(mesh)
    mesh.set_vertices([[0, 0, 7], [1, 0, 7], [0, 1, 7]])
    assert_in_delta 7, scene.get_bounds(model).min[2], 1e-3
    assert_equal 1, mesh.get_info.deformable
    # The mesh of a restored scene, met from behind, or not.
    copy = Scene.new
    copy.restore(nil, scene.get_snapshot(true))
    info = Mesh.from_scene(copy, model).get_info
    assert_equal [MESH_SURFACE, 3, 1], [info.kind, info.vertex_count, info.triangle_count]
    from_behind = Ray.new([0.2, 0.2, 0], [0, 0, 1], Float::INFINITY)
    assert_equal HIT_BACK, copy.raycast_filtered(from_behind, { flags: FILTER_NO_FRONT_FACES }).flags
    assert_nil copy.raycast_filtered(from_behind, { flags: FILTER_NO_BACK_FACES })
  end

  def test_a_hull_is_a_solid_mesh
    hull = Mesh.hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0.1, 0.1, 0.1]])
    assert_equal 4, hull.get_vertices.size
    assert_equal 4, hull.get_hull_planes.size
    assert_equal 4, hull.get_hull_faces.size
  end

  def test_a_rope_is_picked_as_a_model_that_follows_it
    solver = Solver.new
    rope = solver.add_rope([[0, 0, 0], [1, 0, 0], [2, 0, 0]])
    scene = Scene.new
    model = scene.add(Mesh.from_body(solver, rope))
    solver.set_positions(rope, 0, [[0, 0, 7], [1, 0, 7], [2, 0, 7]])
    hit = scene.raycast(Ray.new([1.8, 0, 0], [0, 0, 1], Float::INFINITY))
    assert_equal [model, 1], [hit.model, hit.triangle]
    assert_equal 2, solver.get_nearest_particle(rope, hit.triangle, hit.point)
  end

  def test_lists_of_any_length
    scene = Scene.new
    models = scene.add_batch(Records.new(Sphere, 500)) # more than the first guess has room for
    assert_equal models.to_a, scene.get_models.to_a
    found, offsets = scene.overlap_batch([Aabb.new([-1, -1, -1], [1, 1, 1]), Aabb.new([5, 5, 5], [6, 6, 6])])
    assert_equal [0, 500, 500], offsets
    assert_equal models.to_a, found.to_a
    assert_equal 0, scene.overlap(BALL).size
    assert_equal 500, scene.raycast_all(AHEAD).size
    assert_equal 500, scene.get_octree_stats.item_count
    assert_operator scene.get_octree_boxes.size, :>, 1
  end

  def test_camera
    camera = Camera.new
    camera.look_at([0, 0, -10], [0, 0, 0], UP)
    camera.set_perspective(1, 0.1, 100)
    assert_vector [400, 300], camera.project([0, 0, 0]).first(2), 1e-2
    assert_nil camera.project([0, 0, -20])
    pixels = camera.project_batch([[0, 0, 0], [1, 1, 1]])
    assert_vector [1, 1, 1], camera.unproject_batch(pixels)[1], 1e-2
    assert_vector [1, 1, 1], camera.unproject(pixels[1]), 1e-2
    assert_vector [0, 0, 1], camera.pick_ray(400, 300).direction
    assert_equal 12, camera.pick_rays(0, 0, 4, 3).size

    scene = Scene.new
    model = scene.add(BALL)
    assert_equal model, camera.pick(scene, 400, 300).model
    assert_nil camera.pick(scene, 1, 1)
    assert_equal [model, 0], camera.pick_batch(scene, [[400, 300], [1, 1]]).map(&:model)
    assert_equal [model], camera.pick_rectangle(scene, 0, 0, 800, 600).to_a
    assert_equal [[model], [model]], [camera.cull(scene).to_a, scene.cull(camera.get_frustum).to_a]

    camera.set_viewport(200, 100)
    camera.set_orthographic(10, 0.1, 100)
    projection = camera.get_projection_matrix
    assert_vector [0.1, 0.2], projection.values_at(0, 5)
    camera.set_projection(projection)
    assert_equal(-10, camera.get_world_matrix[14])
    assert_in_delta 10, camera.get_view_matrix[14]
    camera.set_world_matrix([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1])
    assert_equal [[4, 5, 6], STILL], camera.get_transform
    camera.set_transform([1, 2, 3], [0, 1, 0, 0])
    assert_equal [1, 2, 3], camera.get_transform[0]
    camera.set_origin([1, 0, 0])
    assert_equal [1, 0, 0], camera.get_origin
  end

  def test_orbit
    camera = Camera.new
    assert_fails(ERROR_UNSUPPORTED) { camera.get_orbit }
    camera.set_orbit(Gamephys.default_orbit)
    camera.orbit_rotate(0.5, 0.25)
    camera.orbit_zoom(1)
    camera.orbit_pan(2, 0)
    camera.orbit_update
    orbit = camera.get_orbit
    assert_vector [0.5, 0.25, 9], [orbit.yaw, orbit.pitch, orbit.distance]
    assert_in_delta 2, orbit.target[0].abs, 1e-3
  end

  def test_particles
    scene = Scene.new
    solver = Solver.new(substeps: 4, gravity: [0, -1, 0])
    solver.set_gravity([0, -10, 0])
    solver.set_substeps(5)
    free = solver.add_particles([[0, 5, 0], [1, 5, 0]])
    solver.set_velocities(free, 1, [[3, 0, 0]])
    solver.step(scene, 0.1)
    assert_vector [0, -1, 0], solver.get_velocities(free, 0, 1)[0]
    assert_vector [1.3, 4.95, 0], solver.get_positions(free, 1, 1)[0]
    solver.set_masses(free, 0, [2, 4])
    assert_equal [2, 4], solver.get_masses(free, 0, 2).to_a
    solver.set_forces(free, 0, [[0, 20, 0], [0, 40, 0]]) # weightless
    solver.step(nil, 0.1)
    assert_vector [0, -1, 0], solver.get_velocities(free, 0, 1)[0]

    plane = scene.add(Plane.new(UP, 0))
    solver.set_radii(free, 0, [0.5, 0.5])
    solver.set_positions(free, 0, [[0, 0.6, 0], [9, 0.6, 0]])
    solver.set_forces(free, 0, [[0, 0, 0], [0, 0, 0]])
    30.times { solver.step(scene, 0.02) }
    assert_in_delta 0.5, solver.get_positions(free, 0, 1)[0][1], 1e-3
    assert_equal [[plane, UP]] * 2, (solver.get_contacts.map { |each| [each.model, each.normal] })
    solver.set_origin([0, 1, 0])
    assert_equal [0, 1, 0], solver.get_origin
    assert_in_delta(-0.5, solver.get_positions(free, 0, 1)[0][1], 1e-3)
  end

  def test_rope_and_cloth
    scene = Scene.new
    solver = Solver.new
    rope = solver.add_rope([[0, 8, 0], [1, 8, 0], [2, 8, 0]], mass: 3)
    assert_equal BODY_ROPE, solver.get_body_info(rope).kind
    solver.set_pinned(rope, 0, 1, true)
    tie = solver.add_distance(rope, 0, 2, -1)
    assert_equal ConstraintInfo.new(tie, 0, 2, 2, 0), solver.get_constraints(rope).to_a.last
    solver.remove_constraint(rope, tie)
    assert_equal 2, solver.get_constraints(rope).size
    hook = scene.add(Sphere.new([0, 0, 0], 0.1), [[0, 8, 0], STILL, 1], layers: 2)
    solver.attach(scene, rope, 0, hook, [0, 0, 0])
    scene.set_transform(hook, [[0, 9, 0], STILL, 1])
    steps, leftover = solver.advance(scene, 0.025)
    assert_equal 1, steps
    assert_in_delta 0.5, leftover, 1e-5
    assert_in_delta 8 + 2 / 3.0, solver.get_positions(rope, 0, 1)[0][1], 1e-5
    assert_equal 1, solver.get_stats(rope).pinned_count
    solver.detach(rope, 0)
    assert_fails(ERROR_INVALID_ARGUMENT) { solver.detach(rope, 0) }

    cloth = solver.add_cloth([0, 3, 0], [1, 0, 0], [0, 0, 1], 3, 3)
    assert_equal 24, solver.get_triangles(cloth).size
    shirt = solver.add_cloth_mesh(pyramid, IDENTITY)
    assert_equal 5, solver.get_body_info(shirt).particle_count
    solver.remove_body(cloth)
    assert_equal [rope, shirt], solver.get_bodies.to_a

    snapshot = solver.get_snapshot
    past = solver.get_hash
    solver.step(scene, 0.01)
    refute_equal past, solver.get_hash
    solver.restore(snapshot)
    assert_equal past, solver.get_hash
    copy = Scene.new
    copy.restore(nil, scene.get_snapshot(true))
    assert_equal scene.get_hash, copy.get_hash
    solver.wake(0)
    assert_equal [], solver.get_sleeping.to_a
  end

  def test_substeps_are_as_many_as_asked_for_or_as_a_target_takes
    substeps = lambda do |desc|
      solver = Solver.new(**desc)
      cloth = solver.add_cloth([0, 0, 0], [1, 0, 0], [0, 0, 1], 3, 3)
      solver.set_pinned(cloth, 0, 1, true)
      assert_equal 0, solver.get_substeps(cloth)
      5.times { solver.step(nil, 0.01) }
      solver.get_substeps(cloth)
    end
    assert_equal 8, substeps.call({})
    assert_operator substeps.call({ max_strain: 1e-6 }), :>, 8
  end

  def test_a_string_holds_a_weight_and_a_pyramid_keeps_its_volume
    scene = Scene.new
    solver = Solver.new
    hook = scene.add(Sphere.new([0, 0, 0], 0.1), nil, tag: 5)
    weights = solver.add_particles([[0, 0, 0], [0, -1, 0]], mass: 2, layers: 0)
    solver.attach(scene, weights, 0, hook, [0, 0, 0])
    string = solver.add_max_distance(weights, 0, 1, 2, compliance: 1e-6)
    solver.set_constraint_damping(weights, string, 50)
    assert_equal [CONSTRAINT_MAX_DISTANCE], solver.get_constraint_kinds(weights, [string]).to_a
    assert_equal [hook], solver.get_attachments(weights).map(&:model)
    300.times { solver.step(scene, 0.01) }
    assert_in_delta(-2, solver.get_positions(weights, 1, 1)[0][1], 1e-3)
    impulses = solver.get_impulses.to_a
    assert_equal [[hook, 5]], (impulses.map { |impulse| [impulse.model, impulse.tag] })
    assert_in_delta(-2 * 9.81 * 0.01, impulses[0].linear[1], 5e-3)
    ball = solver.add_cloth_mesh(pyramid, IDENTITY)
    solver.set_volume(ball, -1)
    volume, pressure = solver.get_volume(ball)
    assert_in_delta 8.0 / 3, volume, 1e-5
    assert_equal 0, pressure
    assert_equal [volume, 0], solver.get_volume_settings(ball)
    solver.set_volume(ball, 1, compliance: Float::INFINITY)
    assert_fails(ERROR_UNSUPPORTED) { solver.get_volume(ball) }
  end

  def test_settings_change_live
    solver = Solver.new
    settings = solver.get_settings
    settings.substeps = 5
    solver.set_settings(settings)
    assert_equal 5, solver.get_settings.substeps
    solver.set_worker_count(2)
    assert_equal [2, 0], [solver.get_worker_count, solver.get_leftover]
    rope = solver.add_rope([[0, 0, 0], [0, -1, 0]])
    solver.set_pinned(rope, 0, 1, true)
    assert_equal [1, 0], solver.get_pinned(rope, 0, 2).to_a
    body = solver.get_body_settings(rope)
    body.damping = 0.5
    solver.set_body_settings(rope, body)
    assert_equal 0.5, solver.get_body_settings(rope).damping
    links = [solver.get_constraints(rope)[0].id]
    link = solver.get_constraint_settings(rope, links).to_a
    link[0].rest_length = 0.5
    solver.set_constraint_settings(rope, links, link)
    assert_in_delta 0.01, solver.get_radii(rope, 0, 2)[1], 1e-6
    assert_equal [0, 0, 0], solver.get_forces(rope, 0, 2)[1].to_a
    10.times { solver.step(nil, 0.01) }
    assert_in_delta(-0.5, solver.get_positions(rope, 1, 1)[0][1], 1e-5)
  end

  def test_wind_carries_balls_along
    solver = Solver.new(gravity: [0, 0, 0])
    balls = solver.add_particles([[0, 0, 0], [1, 0, 0]])
    solver.set_wind(balls, Wind.new([2, 0, 0], 1e4, 0.5, 0))
    assert_equal 1e4, solver.get_wind(balls).density
    solver.set_air_velocities(balls, 1, [[0, 3, 0]])
    assert_equal [0, 3, 0], solver.get_air_velocities(balls, 0, 2)[1].to_a
    500.times { solver.step(nil, 0.01) }
    first, second = solver.get_velocities(balls, 0, 2).to_a
    assert_operator first[0], :>, 1.8
    assert_operator second[1], :>, 2.7
  end

  def test_a_cluster_holds_out_a_particle_until_it_ends
    solver = Solver.new
    plank = solver.add_particles([[0, 0, 0], [1, 0, 0], [2, 0, 0]])
    solver.set_pinned(plank, 0, 2, true)
    cluster = solver.add_cluster(plank, [0, 1, 2])
    assert_equal [cluster], solver.get_clusters(plank).to_a
    assert_equal [0, 1, 2], solver.get_cluster_particles(plank, cluster).to_a
    30.times { solver.step(nil, 0.01) }
    place = solver.get_positions(plank, 2, 1)[0]
    assert_in_delta 2, place[0], 1e-5
    assert_in_delta 0, place[1], 1e-5
    solver.remove_cluster(plank, cluster)
    30.times { solver.step(nil, 0.01) }
    assert_operator solver.get_positions(plank, 2, 1)[0][1], :<, -0.4
    assert_fails(ERROR_INVALID_ID) { solver.remove_cluster(plank, cluster) }
  end

  def test_a_rope_breaks_under_its_weight_and_cloth_is_cut
    solver = Solver.new
    rope = solver.add_rope([[0, 0, 0], [0, -1, 0]])
    solver.set_pinned(rope, 0, 1, true)
    links = [solver.get_constraints(rope)[0].id]
    solver.set_breaking_forces(rope, links, [3])
    assert_equal [3], solver.get_breaking_forces(rope, links).to_a
    assert_empty solver.get_breaks.to_a
    10.times { solver.step(nil, 0.01) if solver.get_breaks.to_a.empty? }
    broken = solver.get_breaks.to_a
    assert_equal 1, broken.size
    assert_equal [rope, links[0], NO_PARTICLE], [broken[0].body, broken[0].constraint, broken[0].torn_particle]
    assert_operator broken[0].load, :>, 3
    assert_fails(ERROR_INVALID_ID) { solver.break_constraint(rope, links[0]) }
    sheet = solver.add_cloth([0, 0, 0], [1, 0, 0], [0, 0, 1], 3, 3)
    assert_equal 9, solver.break_constraint(sheet, solver.get_constraints(sheet)[1].id).new_particle
  end

  def test_one_of_two_balls_slides_over_ice
    solver = Solver.new
    scene = Scene.new
    scene.add(Plane.new([0, 1, 0], 0))
    balls = solver.add_particles([[0, 0.01, 0], [0, 0.01, 1]])
    solver.set_friction_factors(balls, 1, [0])
    assert_equal [1, 0], solver.get_friction_factors(balls, 0, 2).to_a
    solver.set_velocities(balls, 0, [[1, 0, 0], [1, 0, 0]])
    50.times { solver.step(scene, 0.01) }
    first, second = solver.get_velocities(balls, 0, 2).to_a
    assert_equal 0, first[0]
    assert_in_delta 1, second[0], 1e-5
  end

  def test_a_ball_presses_the_one_that_it_lies_on
    solver = Solver.new
    desc = { mass: 2, radius: 0.5, body_layers: 1 }
    lower = solver.add_particles([[0, 0, 0]], **desc)
    upper = solver.add_particles([[0, 1, 0]], **desc)
    solver.set_pinned(lower, 0, 1, true)
    20.times { solver.step(nil, 0.01) }
    contacts = solver.get_body_contacts.to_a
    assert_equal [[lower, upper, UP]], (contacts.map { |each| [each.body_a, each.body_b, each.normal] })
    assert_in_delta 0.1962, contacts[0].impulse, 2e-3
  end

  def test_a_ball_hangs_below_its_animation_target
    solver = Solver.new
    balls = solver.add_particles([[0, 0, 0], [1, 0, 0]])
    solver.set_animation_targets(balls, 1, [AnimationTarget.new([1, 0, 0], [0, 1, 0], 0.25, Float::INFINITY)])
    assert_equal [Float::INFINITY, 0.25], solver.get_animation_targets(balls, 0, 2).to_a.map(&:max_distance)
    60.times { solver.step(nil, 0.01) }
    assert_equal(-0.25, solver.get_positions(balls, 1, 1)[0].to_a[1])
  end

  def test_a_joint_holds_a_particle_of_another_body
    solver = Solver.new
    nail = solver.add_particles([[0, 0, 0]], mass: 2)
    weight = solver.add_particles([[0, -1, 0]], mass: 2)
    solver.set_pinned(nail, 0, 1, true)
    joint = solver.join(nail, 0, weight, 0, -1)
    20.times { solver.step(nil, 0.01) }
    joints = solver.get_joints(weight).to_a
    assert_equal [[joint, nail, weight]], (joints.map { |held| [held.id, held.body_a, held.body_b] })
    assert_in_delta(2 * 9.81, joints[0].force, 0.01)
    solver.unjoin(joint)
    assert_empty solver.get_joints(0).to_a
    assert_fails(ERROR_INVALID_ID) { solver.unjoin(joint) }
  end

  def test_errors_have_the_librarys_message
    scene = Scene.new
    assert_match(/radius/, assert_raises(InvalidArgument) { scene.add(Sphere.new([0, 0, 0], -1)) }.message)
    assert_raises(InvalidId) { scene.remove(12_345) }
    assert_fails(ERROR_UNSUPPORTED) { Gamephys.transform(pyramid, IDENTITY) }
    assert_fails(ERROR_UNSUPPORTED) { scene.get_shape(scene.add(pyramid)) }
    assert_raises(TypeError) { scene.add('ball') }
    assert_raises(ArgumentError) { scene.add(Sphere.new([0, 0], 1)) }
    assert_raises(ArgumentError) { Camera.new(vieport_width: 3) }
    assert_raises(ArgumentError) { scene.raycast_batch([1, 2, 3].pack('f*')) }
    assert_raises(TypeError) { scene.raycast_batch(Records.new(Segment, 7)) }
    assert_raises(ArgumentError) { scene.raycast_batch([AHEAD], out: Records.new(Hit, 2)) }
    assert_raises(ArgumentError) { scene.sweep_sphere_batch([BALL], [UP, UP]) }
    assert_raises(IndexError) { Records.new(Hit, 2)[2] }
    assert_equal 'GPHYS_NO_HIT', Gamephys.status_name(NO_HIT)
    assert_match(/\A\d+\.\d+\.\d+\z/, Gamephys::VERSION)
  end

  def test_use_after_close_is_an_error
    scene = Scene.new
    mesh = pyramid
    scene.add(mesh)
    mesh.close
    mesh.close
    assert_raises(Closed) { scene.add(mesh) }
    assert_raises(Closed) { scene.add_batch(mesh, [IDENTITY]) }
    assert_raises(Closed) { Gamephys.raycast(mesh, AHEAD) }
    assert scene.raycast(Ray.new([0.1, 5, 0.1], [0, -1, 0], 10)) # the model holds it
    scene.close
    assert_raises(Closed) { scene.get_models }
    assert_raises(TypeError) { Scene.new.dup }
    assert_raises(TypeError) { Solver.new.step(Camera.new, 0.1) }
    assert_raises(TypeError) { Camera.new.cull(12_345) }
    assert_raises(Closed) { Camera.new.pick(scene, 0, 0) }
    assert_raises(Closed) { Scene.open { |each| each }.get_models }
  end

  # The functions of an allocator see what is taken and given back.
  def test_the_collector_frees
    bytes = 0
    kept = {}
    allocate = FFI::Function.new(:pointer, %i[pointer size_t size_t]) do |_, size, alignment|
      memory = FFI::MemoryPointer.new(:uint8, size + alignment)
      start = memory + (-memory.address % alignment)
      kept[start.address] = memory
      bytes += size
      start
    end
    release = FFI::Function.new(:void, %i[pointer pointer size_t size_t]) do |_, memory, size, _|
      kept.delete(memory.address)
      bytes -= size
    end
    allocator = FFI::MemoryPointer.new(:pointer, 3).write_array_of_pointer([allocate, release, nil])
    pyramid(allocator: allocator).close
    assert_equal 0, bytes
    Array.new(10) { Scene.new(allocator: allocator).add(BALL) }
    assert_operator bytes, :>, 0
    taken = bytes
    GC.start
    assert_operator bytes, :<, taken
  end
end
