-- A scene and questions to it, one by one and in a batch.
local gp = require 'gamephys'

local LAYER_WORLD, LAYER_ROBOT = 1, 2
local scene = gp.Scene()
local ground = scene:add(gp.Plane({ 0, 1, 0 }, 0))

-- A row of 100 pyramids, five metres apart, that share one mesh, which they keep alive.
local mesh = gp.Mesh({ -1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, 2, 0 },
    { 0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4 })
assert(mesh:get_report().open_edge_count == 0)
local places = gp.array('transform', 100)
for i = 0, 99 do places[i] = gp.Transform({ 5 * i, 0, 10 }, { 0, 0, 0, 1 }, 1) end
local pyramids = scene:add_batch(mesh, places)
mesh:close()

-- A robot's arm, and a hand two metres above it that follows.
local arm = scene:add(gp.Capsule({ 0, 0, 0 }, { 0, 1, 0 }, 0.2), { { 0, 1, -5 }, { 0, 0, 0, 1 }, 1 }, { layers = LAYER_ROBOT })
local hand = scene:add(gp.Sphere({ 0, 0, 0 }, 0.5), { { 0, 2, 0 }, { 0, 0, 0, 1 }, 1 }, { layers = LAYER_ROBOT, parent = arm })

local hit = scene:raycast(gp.Ray({ 25, 1, 0 }, { 0, 0, 1 }, math.huge))
print(('ray: a pyramid, triangle %d, %g m away'):format(hit.triangle, hit.t))
assert(hit.model == pyramids[5] and math.abs(hit.t - 9.5) < 1e-6)

local sight = gp.Segment({ 0, 3, -10 }, { 0, 3, 0 })
assert(scene:segment_test(sight).model == hand)
assert(scene:segment_test(sight, LAYER_WORLD) == nil)
scene:set_transform(arm, { { 0, 1, -50 }, { 0, 0, 0, 1 }, 1 })
assert(scene:segment_test(sight) == nil)
assert(scene:nearest({ 0, 10, -50 }, math.huge, LAYER_WORLD).model == ground)

local _, count = scene:overlap(gp.Aabb({ -1, 0.5, 8 }, { 21, 1, 12 }), LAYER_WORLD)
print(('box: %d models'):format(count))
assert(count == 5)

-- One call for 1000 rays that look down.
local rays = gp.array('ray', 1000)
for i = 0, 999 do rays[i] = gp.Ray({ 0.5 * i, 5, 10 }, { 0, -1, 0 }, 10) end
local hits = scene:raycast_batch(rays, LAYER_WORLD)
local above = 0
for i = 0, 999 do
    if hits[i].t < 5 then above = above + 1 end
end
print(('batch: %d of 1000 rays end on a pyramid'):format(above))
assert(above == 299)
scene:close()
