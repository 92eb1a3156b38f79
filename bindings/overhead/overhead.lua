-- LuaJIT: overhead.lua [milliseconds a case]
local gp = require 'gamephys'

local RAYS = 1000
local budget = 1e-3 * tonumber(arg[1] or 200)
local scene, camera = gp.Scene(), gp.Camera()
local model = scene:add(gp.Sphere({ 0, 0, 5 }, 1))
local ray, hit = gp.Ray({ 0, 0, 0 }, { 0, 0, 1 }, 100), gp.Hit()
local rays, hits = gp.array('ray', RAYS), gp.array('hit', RAYS)
for i = 0, RAYS - 1 do rays[i] = ray end

local function measure(name, call, items)
    local finish, best, calls = os.clock() + budget, math.huge, 1
    while os.clock() < finish or best == math.huge do
        local start = os.clock()
        for _ = 1, calls do call() end
        local elapsed = os.clock() - start
        if elapsed < 1e-3 then calls = calls * 2 else best = math.min(best, elapsed / calls) end
    end
    print(('lua,%s,%.2f'):format(name, 1e9 * best / items))
end

assert(scene:raycast(ray).t == 4 and scene:raycast_batch(rays, nil, hits)[RAYS - 1].t == 4)
measure('scalar', function() scene:has(model) end, 1)
measure('vec3', function() camera:get_origin() end, 1)
measure('raycast', function() scene:raycast(ray, nil, hit) end, 1)
measure('raycast_batch', function() scene:raycast_batch(rays, nil, hits) end, RAYS)
