"""What a camera sees: culling, a picture of picks, projection, marquee, orbit."""
import gamephys as gp
import numpy as np

WIDTH, HEIGHT = 64, 16

with gp.Scene() as scene, gp.Camera(gp.CameraDesc(viewport_width=640, viewport_height=320)) as camera:
    balls = scene.add_batch([gp.Sphere((-4, 0, 9), 1.5), gp.Sphere((0, 0, 9), 1.5), gp.Sphere((4, 0, 9), 1.5),
                             gp.Sphere((0, 0, -50), 2)])
    camera.set_perspective(0.7, 0.1, 100)
    orbit = gp.default_orbit()
    orbit.target, orbit.distance, orbit.radians_per_unit = (0, 0, 9), 8, 0.01
    camera.set_orbit(orbit)
    assert len(camera.cull(scene)) == 3

    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    pixels = np.float32(np.stack([10 * (x + 0.5), 20 * (y + 0.5)], -1))
    hits = camera.pick_batch(scene, pixels).reshape(HEIGHT, WIDTH)
    light = np.clip(hits["normal"] @ np.float32([-0.5, 0.6, -0.6]), 0, 1)
    for row in np.where(hits["model"] == 0, 9, np.int32(8 - 8 * light)):
        print("".join("@%#*+=-:. "[i] for i in row).rstrip())

    pixel = camera.project((-4, 0, 9))
    assert camera.pick(scene, pixel.x, pixel.y).model == balls[0]
    assert list(camera.pick_rectangle(scene, 340, 0, 640, 320)) == sorted(balls[1:3])
    camera.orbit_rotate(157.0796, 0)                             # pixels of mouse movement: a quarter turn
    camera.orbit_update()
    behind = scene.raycast_all(camera.pick_ray(320, 160))
    assert len(behind) == 3 and behind["model"][1] == balls[1]
    print(f"after a quarter turn {len(behind)} balls stand behind one another")
