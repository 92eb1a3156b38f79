/* Compiled with the header of the last release and run with the present library. Every desc keeps
 * to the size that the client gave, and results fill the structs that it knows and no more. */
#include <gamephys_c.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define EXPECT(condition)                                                          \
    do {                                                                           \
        if (!(condition)) return printf("line %d: %s\n", __LINE__, #condition), 1; \
    } while (0)

/* A struct with bytes behind it that must stay as they are. */
#define GUARDED(type)            \
    struct {                     \
        type value;              \
        unsigned char guard[64]; \
    }
#define FILL(guarded) memset(&(guarded), 0xa5, sizeof(guarded))

static int intact(const unsigned char* guard) {
    for (int i = 0; i < 64; ++i) {
        if (guard[i] != 0xa5) return 0;
    }
    return 1;
}

int main(void) {
    GUARDED(gphys_scene_desc) scene_desc;
    GUARDED(gphys_model_desc) model_desc;
    GUARDED(gphys_mesh_desc) mesh_desc;
    GUARDED(gphys_camera_desc) camera_desc;
    GUARDED(gphys_solver_desc) solver_desc;
    GUARDED(gphys_body_desc) body_desc;
#define INIT(desc)                                                           \
    FILL(desc);                                                              \
    EXPECT(gphys_##desc##_init(&desc.value, sizeof desc.value) == GPHYS_OK); \
    EXPECT(desc.value.struct_size == sizeof desc.value && intact(desc.guard))
    INIT(scene_desc);
    INIT(model_desc);
    INIT(mesh_desc);
    INIT(camera_desc);
    INIT(solver_desc);
    INIT(body_desc);
    EXPECT(scene_desc.value.allocator == NULL && scene_desc.value.reserve_models == 0);
    EXPECT(model_desc.value.parent == 0 && model_desc.value.layers == 1 && model_desc.value.tag == 0);
    EXPECT(mesh_desc.value.allocator == NULL);
    EXPECT(camera_desc.value.allocator == NULL && camera_desc.value.handedness == GPHYS_LEFT_HANDED);
    EXPECT(camera_desc.value.depth_range == GPHYS_DEPTH_ZERO_TO_ONE && camera_desc.value.reverse_z == 0);
    EXPECT(camera_desc.value.viewport_width == 800 && camera_desc.value.viewport_height == 600);
    EXPECT(solver_desc.value.allocator == NULL && solver_desc.value.gravity.y == -9.81f);
    EXPECT(solver_desc.value.gravity.x == 0 && solver_desc.value.gravity.z == 0 && solver_desc.value.substeps == 8);
    EXPECT(solver_desc.value.fixed_step == 1.0f / 60 && solver_desc.value.max_steps == 8);
    EXPECT(body_desc.value.mass == 1 && body_desc.value.radius == 0.01f && body_desc.value.damping == 0);
    EXPECT(body_desc.value.friction == 0.5f && body_desc.value.restitution == 0 && body_desc.value.compliance == 0);
    EXPECT(body_desc.value.bend_compliance == 0.001f && body_desc.value.layers == GPHYS_ALL_LAYERS);
    EXPECT(body_desc.value.cloth_flags == (GPHYS_CLOTH_SHEAR | GPHYS_CLOTH_BEND));

    gphys_scene* scene = NULL;
    gphys_camera* camera = NULL;
    gphys_solver* solver = NULL;
    gphys_mesh* mesh = NULL;
    EXPECT(gphys_scene_create(&scene_desc.value, &scene) == GPHYS_OK);
    EXPECT(gphys_camera_create(&camera_desc.value, &camera) == GPHYS_OK);
    EXPECT(gphys_solver_create(&solver_desc.value, &solver) == GPHYS_OK);
    const float vertices[] = {-1, -1, 5, 1, -1, 5, 0, 1, 5};
    const uint32_t indices[] = {0, 1, 2};
    EXPECT(gphys_mesh_create(&mesh_desc.value, vertices, 12, 3, indices, 3, &mesh) == GPHYS_OK);

    gphys_model_id model = 0;
    model_desc.value.tag = 7;
    EXPECT(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, &model_desc.value, &model) == GPHYS_OK);
    const gphys_ray ray = {{0, 0, 0}, {0, 0, 1}, INFINITY};
    GUARDED(gphys_hit) hit;
    FILL(hit);
    EXPECT(gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit.value) == GPHYS_OK && intact(hit.guard));
    EXPECT(hit.value.model == model && hit.value.tag == 7 && hit.value.t == 5 && hit.value.triangle == 0);
    EXPECT(hit.value.point.x == 0 && hit.value.point.y == 0 && hit.value.point.z == 5 && hit.value.normal.z == -1);
    EXPECT(hit.value.u == 0.25f && hit.value.v == 0.5f && (hit.value.flags & ~(uint32_t)GPHYS_HIT_BACK) == 0);
    const gphys_vec3 origin = {0, 0, 0};
    GUARDED(gphys_nearest) nearest;
    FILL(nearest);
    EXPECT(gphys_scene_nearest(scene, &origin, INFINITY, GPHYS_ALL_LAYERS, &nearest.value) == GPHYS_OK);
    EXPECT(intact(nearest.guard) && nearest.value.model == model && nearest.value.tag == 7);
    EXPECT(nearest.value.distance == 5 && nearest.value.point.z == 5 && nearest.value.triangle == 0);

    GUARDED(gphys_ray) pick;
    FILL(pick);
    EXPECT(gphys_camera_pick_ray(camera, 400, 300, &pick.value) == GPHYS_OK && intact(pick.guard));
    EXPECT(pick.value.direction.z == 1 && pick.value.t_max > 999);
    gphys_body_id body = 0;
    EXPECT(gphys_solver_add_particles(solver, &body_desc.value, &origin, 0, 1, &body) == GPHYS_OK);
    GUARDED(gphys_solver_stats) stats;
    FILL(stats);
    EXPECT(gphys_solver_step(solver, NULL, 0.1f) == GPHYS_OK);
    EXPECT(gphys_solver_get_stats(solver, body, &stats.value) == GPHYS_OK && intact(stats.guard));
    EXPECT(stats.value.particle_count == 1 && stats.value.kinetic_energy > 0.4f);

    gphys_mesh_destroy(mesh);
    gphys_solver_destroy(solver);
    gphys_camera_destroy(camera);
    gphys_scene_destroy(scene);
    return 0;
}
