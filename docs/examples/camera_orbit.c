/* A camera that circles a target, moved by a mouse. */
#include <math.h>

#include "check.h"

/* A camera 8 m from a statue's middle, which turns by a radian for 500 pixels of the
 * mouse. */
static void start(gphys_camera* camera) {
    gphys_orbit orbit, now;
    gphys_vec3 position;
    gphys_quat rotation;
    MUST(gphys_orbit_init(&orbit));
    orbit.target = (gphys_vec3){0, 1, 0};
    orbit.distance = 8;
    orbit.radians_per_unit = 1.0f / 500;
    MUST(gphys_camera_set_orbit(camera, &orbit));
    MUST(gphys_camera_get_orbit(camera, &now));
    MUST(gphys_camera_get_transform(camera, &position, &rotation));
    /* It looks along z, from 8 m before the target. */
    EXPECT(now.distance == 8 && position.y == 1 && position.z == -8);
}

/* The mouse goes 250 pixels to the right with its button held. Input adds up until the
 * frame's update. */
static void rotate(gphys_camera* camera) {
    gphys_orbit now;
    MUST(gphys_camera_orbit_rotate(camera, 100, 0));
    MUST(gphys_camera_orbit_rotate(camera, 150, 0));
    MUST(gphys_camera_orbit_update(camera));
    MUST(gphys_camera_get_orbit(camera, &now));
    EXPECT(fabsf(now.yaw - 0.5f) < 1e-6f); /* a radian for 500 pixels */
}

/* The wheel: 3 m closer to the target, which was 8 m away. */
static void zoom(gphys_camera* camera) {
    gphys_orbit now;
    MUST(gphys_camera_orbit_zoom(camera, 3)); /* a metre for a unit */
    MUST(gphys_camera_orbit_update(camera));
    MUST(gphys_camera_get_orbit(camera, &now));
    EXPECT(now.distance == 5);
}

/* The middle button: the target goes half a metre up and the camera with it. */
static void pan(gphys_camera* camera) {
    gphys_orbit before, after;
    MUST(gphys_camera_get_orbit(camera, &before));
    MUST(gphys_camera_orbit_pan(camera, 0, 0.5f));
    MUST(gphys_camera_orbit_update(camera));
    MUST(gphys_camera_get_orbit(camera, &after));
    EXPECT(fabsf(after.target.y - before.target.y - 0.5f) < 1e-6f);
}

/* A setting of the user's: the mouse turned round from top to bottom, and the wheel
 * twice as fast. */
static void speeds(gphys_camera* camera) {
    gphys_orbit_speeds speeds;
    gphys_orbit before, after;
    MUST(gphys_camera_get_orbit_speeds(camera, &speeds));
    speeds.rotate_y = -speeds.rotate_y;
    speeds.zoom *= 2;
    MUST(gphys_camera_set_orbit_speeds(camera, &speeds));
    MUST(gphys_camera_get_orbit(camera, &before));
    MUST(gphys_camera_orbit_zoom(camera, 1));
    MUST(gphys_camera_orbit_update(camera));
    MUST(gphys_camera_get_orbit(camera, &after));
    EXPECT(before.distance - after.distance == 2);
}

int main(void) {
    gphys_camera* camera = NULL;
    MUST(gphys_camera_create(NULL, &camera));
    start(camera);
    rotate(camera);
    zoom(camera);
    pan(camera);
    speeds(camera);
    gphys_camera_destroy(camera);
    return 0;
}
