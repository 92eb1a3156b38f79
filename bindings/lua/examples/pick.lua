-- What a camera sees: culling, a picture of picks, projection, marquee, orbit.
local gp = require 'gamephys'

local WIDTH, HEIGHT = 64, 16
local scene = gp.Scene()
local camera = gp.Camera { viewport_width = 640, viewport_height = 320 }
local balls = scene:add_batch { gp.Sphere({ -4, 0, 9 }, 1.5), gp.Sphere({ 0, 0, 9 }, 1.5), gp.Sphere({ 4, 0, 9 }, 1.5),
    gp.Sphere({ 0, 0, -50 }, 2) }
camera:set_perspective(0.7, 0.1, 100)
local orbit = gp.default_orbit()
orbit.target.z, orbit.distance, orbit.radians_per_unit = 9, 8, 0.01
camera:set_orbit(orbit)
assert(select(2, camera:cull(scene)) == 3)

local pixels = gp.array('float', 2 * WIDTH * HEIGHT)
for i = 0, WIDTH * HEIGHT - 1 do
    pixels[2 * i], pixels[2 * i + 1] = 10 * (i % WIDTH + 0.5), 20 * (math.floor(i / WIDTH) + 0.5)
end
local hits = camera:pick_batch(scene, pixels)
local shades = '@%#*+=-:.'
for row = 0, HEIGHT - 1 do
    local text = {}
    for column = 0, WIDTH - 1 do
        local hit = hits[row * WIDTH + column]
        local light = math.max(0, -0.5 * hit.normal.x + 0.6 * hit.normal.y - 0.6 * hit.normal.z)
        local shade = 9 - math.floor(8 * math.min(light, 1))
        text[#text + 1] = hit.model == 0 and ' ' or shades:sub(shade, shade)
    end
    print((table.concat(text):gsub(' +$', '')))
end

local pixel = camera:project({ -4, 0, 9 })
assert(camera:pick(scene, pixel.x, pixel.y).model == balls[0])
assert(select(2, camera:pick_rectangle(scene, 340, 0, 640, 320)) == 2)
camera:orbit_rotate(157.0796, 0) -- pixels of mouse movement: a quarter turn
camera:orbit_update()
local behind, count = scene:raycast_all(camera:pick_ray(320, 160))
assert(count == 3 and behind[1].model == balls[1])
print(('after a quarter turn %d balls stand behind one another'):format(count))
