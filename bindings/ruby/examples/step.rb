# frozen_string_literal: true

# A rope with a weight, and a cloth that falls over a ball.
require 'gamephys'
include Gamephys

def assert(truth) = truth || raise('wrong answer')

scene = Scene.new
solver = Solver.new
scene.add(Plane.new([0, 1, 0], 0))
scene.add(Sphere.new([0, 1, 0], 1))

line = Array.new(41) { |i| [5 + 0.05 * i, 3, 0] }
rope = solver.add_rope(line, damping: 2)
solver.set_pinned(rope, 0, 1, true)
solver.set_masses(rope, 40, [5])

cloth = solver.add_cloth([-1.5, 3, -1.5], [3, 0, 0], [0, 0, 3], 31, 31, damping: 2, radius: 0.02, cloth_flags: CLOTH_BEND)
count = solver.get_body_info(cloth).particle_count
positions = Records.new(Vec3, count)
(6 * 60).times do
  solver.advance(scene, 1.0 / 60)
  solver.get_positions(cloth, 0, count, out: positions) # the same memory each frame
end

height = positions.map { |x, y, z| Math.sqrt(x**2 + (y - 1)**2 + z**2) - 1 }.min
weight = solver.get_positions(rope, 40, 1)[0]
puts format('weight %.3f m below the nail, cloth %.4f m above the ball', 3 - weight[1], height)
assert weight[1] < 1.02 && height.between?(0.015, 0.03)
