/// What a camera sees: culling, a picture of picks, projection, marquee, orbit.
import errors, gamephys_c;
import std.algorithm, std.exception, std.range, std.stdio, std.string;

enum width = 64, height = 16;

void main() {
    gphys_scene* scene;
    gphys_scene_create(null, &scene).must;
    scope (exit) gphys_scene_destroy(scene);
    auto shapes = [gphys_sphere(gphys_vec3(-4, 0, 9), 1.5), gphys_sphere(gphys_vec3(0, 0, 9), 1.5),
        gphys_sphere(gphys_vec3(4, 0, 9), 1.5), gphys_sphere(gphys_vec3(0, 0, -50), 2)];
    gphys_model_id[4] balls, seen;
    gphys_scene_add_batch(scene, GPHYS_SHAPE_SPHERE, shapes.ptr, gphys_sphere.sizeof, null, 0, 4, null, balls.ptr).must;

    gphys_camera_desc desc;
    gphys_camera_desc_init(&desc, desc.sizeof).must;
    desc.viewport_width = 10 * width;
    desc.viewport_height = 20 * height;
    gphys_camera* camera;
    gphys_camera_create(&desc, &camera).must;
    scope (exit) gphys_camera_destroy(camera);
    gphys_camera_set_perspective(camera, 0.7, 0.1, 100).must;
    gphys_orbit orbit;
    gphys_orbit_init(&orbit).must;
    orbit.target = gphys_vec3(0, 0, 9);
    orbit.distance = 8;
    orbit.radians_per_unit = 0.01;
    gphys_camera_set_orbit(camera, &orbit).must;
    uint total;
    gphys_camera_cull(camera, scene, allLayers, seen.ptr, 4, &total).must;
    enforce(total == 3);

    // A ray for each character cell, all in one batch.
    float[2][] pixels;
    foreach (row; 0 .. height) foreach (column; 0 .. width) pixels ~= [10 * (column + 0.5f), 20 * (row + 0.5f)];
    auto hits = new gphys_hit[pixels.length];
    gphys_camera_pick_batch(camera, scene, pixels[0].ptr, 8, cast(uint) pixels.length, allLayers, hits.ptr, gphys_hit.sizeof).must;
    foreach (row; hits.chunks(width)) {
        writeln(row.map!((hit) {
            const light = clamp(-0.5 * hit.normal.x + 0.6 * hit.normal.y - 0.6 * hit.normal.z, 0, 1);
            return hit.model ? "@%#*+=-:."[8 - cast(size_t)(8 * light)] : ' ';
        }).array.stripRight);
    }

    gphys_vec3 pixel;
    gphys_hit hit;
    gphys_camera_project(camera, &shapes[0].center, &pixel).must;
    gphys_camera_pick(camera, scene, pixel.x, pixel.y, allLayers, &hit).must;
    enforce(hit.model == balls[0]);
    gphys_camera_pick_rectangle(camera, scene, 340, 0, 640, 320, allLayers, seen.ptr, 4, &total).must;
    enforce(seen[0 .. total] == balls[1 .. 3]);

    gphys_camera_orbit_rotate(camera, 157.0796, 0).must; // pixels of mouse movement: a quarter turn
    gphys_camera_orbit_update(camera).must;
    gphys_ray ray;
    gphys_hit[4] behind;
    gphys_camera_pick_ray(camera, 320, 160, &ray).must;
    gphys_scene_raycast_all(scene, &ray, allLayers, behind.ptr, 4, &total).must;
    enforce(total == 3 && behind[1].model == balls[1]);
    writefln("after a quarter turn %s balls stand behind one another", total);
}
