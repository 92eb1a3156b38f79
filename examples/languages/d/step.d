/// A rope with a weight, and a cloth that falls over a ball.
import errors, gamephys_c;
import std.algorithm, std.exception, std.math, std.range, std.stdio;

void main() {
    gphys_scene* scene;
    gphys_scene_create(null, &scene).must;
    scope (exit) gphys_scene_destroy(scene);
    auto ground = gphys_plane(gphys_vec3(0, 1, 0), 0);
    auto ball = gphys_sphere(gphys_vec3(0, 1, 0), 1);
    gphys_model_id model;
    gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &ground, null, null, &model).must;
    gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, null, null, &model).must;

    gphys_solver* solver;
    gphys_solver_create(null, &solver).must;
    scope (exit) gphys_solver_destroy(solver);
    gphys_body_desc desc;
    gphys_body_desc_init(&desc, desc.sizeof).must;
    desc.damping = 2;

    auto line = iota(41).map!(i => gphys_vec3(5 + 0.05 * i, 3, 0)).array;
    float weight = 5;
    gphys_body_id rope, cloth;
    gphys_solver_add_rope(solver, &desc, line.ptr, gphys_vec3.sizeof, cast(uint) line.length, 0, &rope).must;
    gphys_solver_set_pinned(solver, rope, 0, 1, 1).must;
    gphys_solver_set_masses(solver, rope, 40, 1, &weight, weight.sizeof).must;

    auto corner = gphys_vec3(-1.5, 3, -1.5), along = gphys_vec3(3, 0, 0), across = gphys_vec3(0, 0, 3);
    desc.radius = 0.02;
    desc.cloth_flags = GPHYS_CLOTH_BEND;
    gphys_solver_add_cloth(solver, &desc, &corner, &along, &across, 31, 31, &cloth).must;

    foreach (frame; 0 .. 6 * 60) {
        uint made;
        gphys_solver_advance(solver, scene, 1.0f / 60, &made, null).must;
    }

    auto points = new gphys_vec3[31 * 31];
    gphys_solver_get_positions(solver, cloth, 0, cast(uint) points.length, points.ptr, gphys_vec3.sizeof).must;
    const height = points.map!(p => sqrt(p.x ^^ 2 + (p.y - 1) ^^ 2 + p.z ^^ 2) - 1).minElement;
    gphys_vec3 hanging;
    gphys_solver_get_positions(solver, rope, 40, 1, &hanging, gphys_vec3.sizeof).must;
    writefln("weight %.3f m below the nail, cloth %.4f m above the ball", 3 - hanging.y, height);
    enforce(hanging.y < 1.02 && height > 0.015 && height < 0.03);
}
