-- A rope with a weight, and a cloth that falls over a ball.
local gp = require 'gamephys'

local scene, solver = gp.Scene(), gp.Solver()
scene:add(gp.Plane({ 0, 1, 0 }, 0))
scene:add(gp.Sphere({ 0, 1, 0 }, 1))

local line = gp.array('vec3', 41)
for i = 0, 40 do line[i] = gp.Vec3(5 + 0.05 * i, 3, 0) end
local rope = solver:add_rope(line, 0, { damping = 2 })
solver:set_pinned(rope, 0, 1, true)
solver:set_masses(rope, 40, { 5 })

local cloth = solver:add_cloth({ -1.5, 3, -1.5 }, { 3, 0, 0 }, { 0, 0, 3 }, 31, 31,
    { damping = 2, radius = 0.02, cloth_flags = gp.CLOTH_BEND })
local count = solver:get_body_info(cloth).particle_count
local positions = gp.array('vec3', count)
for _ = 1, 6 * 60 do
    solver:advance(scene, 1 / 60)
    solver:get_positions(cloth, 0, count, positions) -- the same memory each frame
end

local height = math.huge
for i = 0, count - 1 do
    local p = positions[i]
    height = math.min(height, math.sqrt(p.x ^ 2 + (p.y - 1) ^ 2 + p.z ^ 2) - 1)
end
local weight = solver:get_positions(rope, 40, 1)[0]
print(('weight %.3f m below the nail, cloth %.4f m above the ball'):format(3 - weight.y, height))
assert(weight.y < 1.02 and height > 0.015 and height < 0.03)
