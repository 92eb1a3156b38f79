-- A lidar that turns on a vehicle: a million rays a frame, from FFI arrays that the library reads in place.
--
-- lidar [frames] [columns]: 64 beams for each column, 15625 columns are a million rays.
local gp = require 'gamephys'

local BEAMS, RANGE = 64, 120
local frames, columns = tonumber(arg[1] or 3), tonumber(arg[2] or 15625)

-- A street: ground, and houses and posts to both sides.
local scene = gp.Scene()
scene:add(gp.Plane({ 0, 1, 0 }, 0))
for i = 0, 39 do
    local side, z = 1 - 2 * (i % 2), 5 * i - 100
    scene:add(gp.Aabb({ 14 * side - 5, 0, z }, { 14 * side + 5, 6, z + 8 }))
    scene:add(gp.Capsule({ 7 * side, 0, z }, { 7 * side, 6, z }, 0.15))
end

local count = columns * BEAMS
local rays, hits = gp.array('ray', count), gp.array('hit', count) -- hits are filled again by every frame
for i = 0, count - 1 do
    local turn = math.floor(i / BEAMS) / columns * 2 * math.pi
    local tilt = -0.43 + 0.46 * (i % BEAMS) / (BEAMS - 1)
    local ray = rays[i]
    ray.origin.y, ray.t_max = 1.8, RANGE
    ray.direction.x = math.cos(turn) * math.cos(tilt)
    ray.direction.y = math.sin(tilt)
    ray.direction.z = math.sin(turn) * math.cos(tilt)
end
for frame = 0, frames - 1 do
    for i = 0, count - 1 do rays[i].origin.z = 0.5 * frame end -- the vehicle drives on
    local start = os.clock()
    scene:raycast_batch(rays, nil, hits)
    local time = os.clock() - start
    local seen = 0
    for i = 0, count - 1 do
        local ray, hit = rays[i], hits[i]
        if hit.model ~= 0 then
            seen = seen + 1
            assert(hit.t <= RANGE and math.abs(ray.origin.y + ray.direction.y * hit.t - hit.point.y) < 1e-4)
        end
    end
    print(('frame %d: %d rays in %.0f ms, %d points'):format(frame, count, 1e3 * time, seen))
    assert(seen > count / 2 and seen < count)
end
scene:close()
