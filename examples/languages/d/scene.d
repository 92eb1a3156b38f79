/// A scene and questions to it, one by one and in a batch.
import errors, gamephys_c;
import std.algorithm, std.exception, std.math, std.range, std.stdio;

enum layerWorld = 1, layerRobot = 2;

gphys_transform at(float x, float y, float z) {
    return gphys_transform(gphys_vec3(x, y, z), gphys_quat(0, 0, 0, 1), 1);
}

void main() {
    gphys_scene* scene;
    gphys_scene_create(null, &scene).must;
    scope (exit) gphys_scene_destroy(scene);

    auto ground = gphys_plane(gphys_vec3(0, 1, 0), 0);
    gphys_model_id groundId;
    gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &ground, null, null, &groundId).must;

    // A row of 100 pyramids, five metres apart, that share one mesh, which they keep alive.
    auto vertices = [gphys_vec3(-1, 0, -1), gphys_vec3(1, 0, -1), gphys_vec3(1, 0, 1), gphys_vec3(-1, 0, 1), gphys_vec3(0, 2, 0)];
    uint[] indices = [0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4];
    gphys_mesh* mesh;
    gphys_mesh_create(null, &vertices[0].x, gphys_vec3.sizeof, cast(uint) vertices.length, indices.ptr,
            cast(uint) indices.length, &mesh).must;
    auto places = iota(100).map!(i => at(5 * i, 0, 10)).array;
    gphys_model_id[100] pyramids;
    gphys_scene_add_batch(scene, GPHYS_SHAPE_MESH, mesh, 0, places.ptr, gphys_transform.sizeof, 100, null,
            pyramids.ptr).must;
    gphys_mesh_destroy(mesh);

    // A robot's arm, and a hand two metres above it that follows.
    gphys_model_desc desc;
    gphys_model_desc_init(&desc, desc.sizeof).must;
    desc.layers = layerRobot;
    auto bone = gphys_capsule(gphys_vec3(0, 0, 0), gphys_vec3(0, 1, 0), 0.2);
    auto ball = gphys_sphere(gphys_vec3(0, 0, 0), 0.5);
    auto armPlace = at(0, 1, -5), handPlace = at(0, 2, 0), moved = at(0, 1, -50);
    gphys_model_id arm, hand;
    gphys_scene_add(scene, GPHYS_SHAPE_CAPSULE, &bone, &armPlace, &desc, &arm).must;
    desc.parent = arm;
    gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &handPlace, &desc, &hand).must;

    gphys_hit hit;
    auto forward = gphys_ray(gphys_vec3(25, 1, 0), gphys_vec3(0, 0, 1), float.infinity);
    enforce(gphys_scene_raycast(scene, &forward, allLayers, &hit).must == GPHYS_OK);
    writefln("ray: a pyramid, triangle %s, %s m away", hit.triangle, hit.t);
    enforce(hit.model == pyramids[5] && isClose(hit.t, 9.5, 1e-6));

    auto sight = gphys_segment(gphys_vec3(0, 3, -10), gphys_vec3(0, 3, 0));
    gphys_scene_segment_test(scene, &sight, allLayers, &hit).must;
    enforce(hit.model == hand);
    enforce(gphys_scene_segment_test(scene, &sight, layerWorld, &hit).must == GPHYS_NO_HIT);
    gphys_scene_set_transform(scene, arm, &moved).must;
    enforce(gphys_scene_segment_test(scene, &sight, allLayers, &hit).must == GPHYS_NO_HIT);
    auto box = gphys_aabb(gphys_vec3(-1, 0.5, 8), gphys_vec3(21, 1, 12));
    gphys_model_id[3] found; // has room for three
    uint total;
    enforce(gphys_scene_overlap(scene, GPHYS_SHAPE_AABB, &box, layerWorld, found.ptr, 3, &total).must == GPHYS_INCOMPLETE);
    writefln("box: %s models, the first three are %s", total, found);
    enforce(total == 5 && found[].isStrictlyMonotonic);

    auto bad = gphys_sphere(gphys_vec3(0, 0, 0), float.nan);
    writeln("an error: ", collectExceptionMsg!Exception(gphys_shape_validate(GPHYS_SHAPE_SPHERE, &bad).must).enforce);

    // One call for 1000 rays that look down.
    auto rays = iota(1000).map!(i => gphys_ray(gphys_vec3(0.5 * i, 5, 10), gphys_vec3(0, -1, 0), 10)).array;
    auto hits = new gphys_hit[1000];
    gphys_scene_raycast_batch(scene, rays.ptr, gphys_ray.sizeof, 1000, layerWorld, hits.ptr, gphys_hit.sizeof).must;
    const above = hits.count!(h => h.t < 5);
    writefln("batch: %s of 1000 rays end on a pyramid", above);
    enforce(above == 299);
}
