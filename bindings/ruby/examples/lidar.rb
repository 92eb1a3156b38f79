# frozen_string_literal: true

# A lidar that turns on a vehicle: a million rays a frame, as packed floats in and out.
#
# lidar [frames] [columns]: 64 beams for each column, 15625 columns are a million rays.
require 'gamephys'
include Gamephys

def assert(truth) = truth || raise('wrong answer')

BEAMS = 64
RANGE = 120
frames = Integer(ARGV[0] || 3)
columns = Integer(ARGV[1] || 15_625)

scene = Scene.new
scene.add(Plane.new([0, 1, 0], 0))
40.times do |i| # houses and posts to both sides of a street
  side = 1 - 2 * (i % 2)
  z = 5 * i - 100
  scene.add(Aabb.new([14 * side - 5, 0, z], [14 * side + 5, 6, z + 8]))
  scene.add(Capsule.new([7 * side, 0, z], [7 * side, 6, z], 0.15))
end

directions = Array.new(columns * BEAMS) do |i|
  turn = i / BEAMS / columns.to_f * 2 * Math::PI
  tilt = -0.43 + 0.46 * (i % BEAMS) / (BEAMS - 1)
  [Math.cos(turn) * Math.cos(tilt), Math.sin(tilt), Math.sin(turn) * Math.cos(tilt)]
end
hits = nil # filled again by every frame
frames.times do |frame|
  origin = [0, 1.8, 0.5 * frame] # the vehicle drives on
  rays = directions.flat_map { |direction| [*origin, *direction, RANGE] }.pack('f*')
  start = Process.clock_gettime(Process::CLOCK_MONOTONIC)
  hits = scene.raycast_batch(rays, out: hits)
  time = Process.clock_gettime(Process::CLOCK_MONOTONIC) - start
  # Each hit: model, tag, t, point, normal, triangle, u, v, flags.
  values = hits.to_s.unpack('LLf7Lf2L' * directions.size).each_slice(13)
  seen = values.zip(directions).count do |(model, _tag, t, _x, y, *), direction|
    next false if model.zero?

    assert t <= RANGE && (origin[1] + direction[1] * t - y).abs < 1e-4
  end
  puts format('frame %d: %d rays in %.0f ms, %d points', frame, directions.size, 1e3 * time, seen)
  assert seen > directions.size / 2 && seen < directions.size
end
scene.close
