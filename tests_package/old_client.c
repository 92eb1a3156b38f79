/* Compiled with the header of the last release and run with the present library. Every desc keeps
 * to the size that the client gave, and results fill the structs that it knows and no more. */
#define _POSIX_C_SOURCE 200112L /* posix_memalign */
#include <gamephys_c.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
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

static void* count_allocation(void* user, size_t size, size_t alignment) {
    void* memory = NULL;
    ++*(int*)user;
    return posix_memalign(&memory, alignment < sizeof memory ? sizeof memory : alignment, size) == 0 ? memory : NULL;
}
static void release(void* user, void* memory, size_t size, size_t alignment) {
    (void)user;
    (void)size;
    (void)alignment;
    free(memory);
}

/* Descs of which each field is set by itself, without init: what lies in the padding is garbage. Each field
 * has another value than its default, and is seen to have its effect. */
static int descs_are_taken_field_by_field(void) {
    int allocations = 0, before = 0;
    gphys_allocator allocator = {count_allocation, release, NULL};
    gphys_scene_desc scene_desc;
    gphys_model_desc model_desc;
    gphys_mesh_desc mesh_desc;
    gphys_camera_desc camera_desc;
    gphys_solver_desc solver_desc;
    gphys_body_desc body_desc;
    gphys_scene* scene = NULL;
    gphys_camera* camera = NULL;
    gphys_solver* solver = NULL;
    gphys_mesh* mesh = NULL;
    allocator.user = &allocations;
#define COUNTED (allocations > before && (before = allocations) > 0)

    FILL(scene_desc);
    scene_desc.struct_size = sizeof scene_desc;
    scene_desc.allocator = &allocator;
    scene_desc.reserve_models = 16;
    EXPECT(gphys_scene_create(&scene_desc, &scene) == GPHYS_OK && COUNTED);

    FILL(mesh_desc);
    mesh_desc.struct_size = sizeof mesh_desc;
    mesh_desc.allocator = &allocator;
    const float vertices[] = {-1, -1, 5, 1, -1, 5, 0, 1, 5};
    const uint32_t indices[] = {0, 1, 2};
    EXPECT(gphys_mesh_create(&mesh_desc, vertices, 12, 3, indices, 3, &mesh) == GPHYS_OK && COUNTED);

    gphys_model_id parent = 0, model = 0;
    gphys_model_info info;
    EXPECT(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, NULL, &parent) == GPHYS_OK);
    FILL(model_desc);
    model_desc.struct_size = sizeof model_desc;
    model_desc.parent = parent;
    model_desc.layers = 6;
    model_desc.tag = 9;
    EXPECT(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, &model_desc, &model) == GPHYS_OK);
    EXPECT(gphys_scene_get_info(scene, model, &info) == GPHYS_OK);
    EXPECT(info.parent == parent && info.layers == 6 && info.tag == 9);

    FILL(camera_desc);
    camera_desc.struct_size = sizeof camera_desc;
    camera_desc.allocator = &allocator;
    camera_desc.handedness = GPHYS_RIGHT_HANDED;
    camera_desc.depth_range = GPHYS_DEPTH_MINUS_ONE_TO_ONE;
    camera_desc.reverse_z = 1;
    camera_desc.viewport_width = 640;
    camera_desc.viewport_height = 480;
    gphys_vec3 pixel;
    const gphys_vec3 near_point = {0, 0, -0.1f}; /* on the near plane of a camera that looks along -Z */
    EXPECT(gphys_camera_create(&camera_desc, &camera) == GPHYS_OK && COUNTED);
    EXPECT(gphys_camera_project(camera, &near_point, &pixel) == GPHYS_OK);
    EXPECT(fabsf(pixel.x - 320) < 0.01f && fabsf(pixel.y - 240) < 0.01f && fabsf(pixel.z - 1) < 1e-5f);

    FILL(solver_desc);
    solver_desc.struct_size = sizeof solver_desc;
    solver_desc.allocator = &allocator;
    solver_desc.gravity.x = 1;
    solver_desc.gravity.y = 0;
    solver_desc.gravity.z = 0;
    solver_desc.substeps = 3;
    solver_desc.fixed_step = 0.25f;
    solver_desc.max_steps = 2;
    EXPECT(gphys_solver_create(&solver_desc, &solver) == GPHYS_OK && COUNTED);

    FILL(body_desc);
    body_desc.struct_size = sizeof body_desc;
    body_desc.mass = 3;
    body_desc.radius = 0.5f;
    body_desc.damping = 0;
    body_desc.friction = 0.25f;
    body_desc.restitution = 0.125f;
    body_desc.compliance = 0.5f;
    body_desc.bend_compliance = 0.75f;
    body_desc.cloth_flags = GPHYS_CLOTH_BEND;
    body_desc.layers = 1;
    const gphys_vec3 corner = {0, 0, 0}, edge_u = {1, 0, 0}, edge_v = {0, 0, 1};
    gphys_body_id body = 0;
    gphys_constraint_info constraints[32];
    uint32_t total = 0, steps = 0, bends = 0;
    float mass = 0;
    gphys_vec3 velocity;
    EXPECT(gphys_solver_add_cloth(solver, &body_desc, &corner, &edge_u, &edge_v, 3, 3, &body) == GPHYS_OK);
    EXPECT(gphys_solver_get_masses(solver, body, 0, 1, &mass, 4) == GPHYS_OK && fabsf(mass - 3.0f / 9) < 1e-6f);
    EXPECT(gphys_solver_get_constraints(solver, body, constraints, 32, &total) == GPHYS_OK);
    for (uint32_t i = 0; i < total; ++i) {
        EXPECT(constraints[i].compliance == 0.5f || constraints[i].compliance == 0.75f);
        bends += constraints[i].compliance == 0.75f;
    }
    EXPECT(total == 18 && bends == 6); /* without shear: 12 links and 6 across the middle lines */
    EXPECT(gphys_solver_advance(solver, NULL, 10, &steps, NULL) == GPHYS_OK && steps == 2);
    EXPECT(gphys_solver_get_velocities(solver, body, 4, 1, &velocity, 12) == GPHYS_OK);
    EXPECT(fabsf(velocity.x - 0.5f) < 1e-3f && velocity.y == 0 && velocity.z == 0);

    gphys_mesh_destroy(mesh);
    gphys_solver_destroy(solver);
    gphys_camera_destroy(camera);
    gphys_scene_destroy(scene);
    return 0;
}

int main(void) {
    /* It knows the fields of release 1.0. */
    if (GPHYS_VERSION_MINOR == 0 && descs_are_taken_field_by_field() != 0) return 1;
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
