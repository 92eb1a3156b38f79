"""Python: overhead.py [milliseconds a case]"""
import sys
from time import perf_counter

import gamephys as gp
import numpy as np

RAYS = 1000
budget = 1e-3 * float(sys.argv[1] if len(sys.argv) > 1 else 200)
scene, camera = gp.Scene(), gp.Camera()
model = scene.add(gp.Sphere((0, 0, 5), 1))
ray = gp.Ray((0, 0, 0), (0, 0, 1), 100)
rays = np.full(RAYS, np.frombuffer(bytes(ray), gp.ray_dtype)[0])
hits = np.empty(RAYS, gp.hit_dtype)


def measure(name, call, items=1):
    end, best, calls = perf_counter() + budget, float("inf"), 1
    while perf_counter() < end or best == float("inf"):
        start = perf_counter()
        for _ in range(calls):
            call()
        elapsed = perf_counter() - start
        if elapsed < 1e-3:
            calls *= 2
        else:
            best = min(best, elapsed / calls)
    print(f"python,{name},{1e9 * best / items:.2f}")


assert scene.raycast(ray).t == 4 and scene.raycast_batch(rays, out=hits)["t"][-1] == 4
measure("scalar", lambda: model in scene)
measure("vec3", camera.get_origin)
measure("raycast", lambda: scene.raycast(ray))
measure("raycast_batch", lambda: scene.raycast_batch(rays, out=hits), RAYS)
