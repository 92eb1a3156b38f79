# frozen_string_literal: true

# Ruby: overhead.rb [milliseconds a case]
require 'gamephys'
include Gamephys

RAYS = 1000
BUDGET = 1e-3 * (ARGV[0] || 200).to_f

def seconds = Process.clock_gettime(Process::CLOCK_MONOTONIC)

def measure(name, items = 1)
  finish, best, calls = seconds + BUDGET, Float::INFINITY, 1
  while seconds < finish || best.infinite?
    start = seconds
    calls.times { yield }
    elapsed = seconds - start
    elapsed < 1e-3 ? calls *= 2 : best = [best, elapsed / calls].min
  end
  puts format('ruby,%s,%.2f', name, 1e9 * best / items)
end

scene, camera = Scene.new, Camera.new
model = scene.add(Sphere.new([0, 0, 5], 1))
ray = Ray.new([0, 0, 0], [0, 0, 1], 100)
rays = Ray.pack(ray) * RAYS
hits = Records.new(Hit, RAYS)
raise 'wrong answer' unless scene.raycast(ray).t == 4 && scene.raycast_batch(rays, out: hits)[RAYS - 1].t == 4

measure('scalar') { scene.has?(model) }
measure('vec3') { camera.get_origin }
measure('raycast') { scene.raycast(ray) }
measure('raycast_batch', RAYS) { scene.raycast_batch(rays, out: hits) }
