# frozen_string_literal: true

# A scene and questions to it, one by one and in a batch.
require 'gamephys'
include Gamephys

def assert(truth) = truth || raise('wrong answer')

LAYER_WORLD, LAYER_ROBOT = 1, 2
STILL = [0, 0, 0, 1].freeze

Scene.open do |scene|
  ground = scene.add(Plane.new([0, 1, 0], 0))

  # A row of 100 pyramids, five metres apart, that share one mesh, which they keep alive.
  vertices = [[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1], [0, 2, 0]]
  triangles = [[0, 1, 2], [0, 2, 3], [1, 0, 4], [2, 1, 4], [3, 2, 4], [0, 3, 4]]
  places = Array.new(100) { |i| Transform.new([5 * i, 0, 10], STILL, 1) }
  pyramids = Mesh.open(vertices, triangles) do |mesh|
    assert mesh.get_report.open_edge_count.zero?
    scene.add_batch(mesh, places).to_a
  end

  # A robot's arm, and a hand two metres above it that follows.
  arm = scene.add(Capsule.new([0, 0, 0], [0, 1, 0], 0.2), [[0, 1, -5], STILL, 1], layers: LAYER_ROBOT)
  hand = scene.add(Sphere.new([0, 0, 0], 0.5), [[0, 2, 0], STILL, 1], layers: LAYER_ROBOT, parent: arm)

  hit = scene.raycast(Ray.new([25, 1, 0], [0, 0, 1], Float::INFINITY))
  puts format('ray: a pyramid, triangle %<triangle>d, %<t>g m away', hit.to_h)
  assert hit.model == pyramids[5] && (hit.t - 9.5).abs < 1e-6

  sight = Segment.new([0, 3, -10], [0, 3, 0])
  assert scene.segment_test(sight).model == hand
  assert scene.segment_test(sight, layers: LAYER_WORLD).nil?
  scene.set_transform(arm, [[0, 1, -50], STILL, 1])
  assert scene.segment_test(sight).nil?
  assert scene.nearest([0, 10, -50], layers: LAYER_WORLD).model == ground

  found = scene.overlap(Aabb.new([-1, 0.5, 8], [21, 1, 12]), layers: LAYER_WORLD)
  puts "box: #{found.size} models"
  assert found.to_a == pyramids.first(5)

  # One call for 1000 rays that look down: 7 floats each.
  rays = Array.new(1000) { |i| [0.5 * i, 5, 10, 0, -1, 0, 10] }.flatten.pack('f*')
  above = scene.raycast_batch(rays, layers: LAYER_WORLD).count { |each| each.t < 5 }
  puts "batch: #{above} of 1000 rays end on a pyramid"
  assert above == 299
end
