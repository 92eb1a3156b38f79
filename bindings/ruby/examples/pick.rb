# frozen_string_literal: true

# What a camera sees: culling, a picture of picks, projection, marquee, orbit.
require 'gamephys'
include Gamephys

def assert(truth) = truth || raise('wrong answer')

WIDTH, HEIGHT = 64, 16
scene = Scene.new
camera = Camera.new(viewport_width: 640, viewport_height: 320)
balls = scene.add_batch([[-4, 0, 9, 1.5], [0, 0, 9, 1.5], [4, 0, 9, 1.5], [0, 0, -50, 2]]
  .map { |x, y, z, radius| Sphere.new([x, y, z], radius) }).to_a
camera.set_perspective(0.7, 0.1, 100)
orbit = Gamephys.default_orbit
orbit.target, orbit.distance, orbit.radians_per_unit = [0, 0, 9], 8, 0.01
camera.set_orbit(orbit)
assert camera.cull(scene).size == 3

pixels = Array.new(WIDTH * HEIGHT) { |i| [10 * (i % WIDTH + 0.5), 20 * (i / WIDTH + 0.5)] }
camera.pick_batch(scene, pixels).each_slice(WIDTH) do |row|
  text = row.map do |hit|
    x, y, z = hit.normal
    hit.model.zero? ? ' ' : '@%#*+=-:.'[8 - (8 * (-0.5 * x + 0.6 * y - 0.6 * z).clamp(0, 1)).to_i]
  end
  puts text.join.rstrip
end

x, y = camera.project([-4, 0, 9])
assert camera.pick(scene, x, y).model == balls[0]
assert camera.pick_rectangle(scene, 340, 0, 640, 320).to_a == balls[1..2]
camera.orbit_rotate(157.0796, 0) # pixels of mouse movement: a quarter turn
camera.orbit_update
behind = scene.raycast_all(camera.pick_ray(320, 160))
assert behind.size == 3 && behind[1].model == balls[1]
puts "after a quarter turn #{behind.size} balls stand behind one another"
