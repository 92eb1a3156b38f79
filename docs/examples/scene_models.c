/* Models of a scene: adding, changing, looking at and removing them. */
#include <math.h>

#include "check.h"

/* A scene with room for 10 000 models, whose large calls two threads share. */
static void create(void) {
    gphys_scene_desc desc;
    gphys_scene* scene = NULL;
    MUST(gphys_scene_desc_init(&desc, sizeof desc));
    desc.reserve_models = 10000;
    desc.worker_count = 2;
    MUST(gphys_scene_create(&desc, &scene));
    gphys_scene_destroy(scene);
}

/* A crate of 1 m, 5 m along x. The tag comes back with every hit, and queries
 * see it whose mask has the bit 2. */
static void add(gphys_scene* scene) {
    const gphys_aabb box = {{-0.5f, 0, -0.5f}, {0.5f, 1, 0.5f}};
    const gphys_transform place = {{5, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_model_desc desc;
    gphys_model_id crate;
    MUST(gphys_model_desc_init(&desc, sizeof desc));
    desc.tag = 42;
    desc.layers = 2;
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &box, &place, &desc, &crate));
    EXPECT(gphys_scene_has(scene, crate) == GPHYS_OK);
}

/* A fence of 50 posts, 2 m apart: a stride of 0 gives all of them the same shape. */
static void add_batch(gphys_scene* scene) {
    const gphys_capsule post = {{0, 0, 0}, {0, 1, 0}, 0.1f};
    gphys_transform places[50];
    gphys_model_id posts[50];
    uint32_t total;
    for (int i = 0; i < 50; ++i)
        places[i] = (gphys_transform){{2.0f * (float)i, 0, 0}, {0, 0, 0, 1}, 1};
    MUST(gphys_scene_add_batch(scene, GPHYS_SHAPE_CAPSULE, &post, 0, places,
                               sizeof places[0], 50, NULL, posts));
    EXPECT(gphys_scene_get_models(scene, NULL, 0, &total) == GPHYS_INCOMPLETE &&
           total == 50);
}

/* Three coins of one shape, each with a number of its own. */
static void add_described_batch(gphys_scene* scene) {
    const gphys_sphere coin = {{0, 0, 0}, 0.02f};
    const gphys_transform places[3] = {{{0, 1, 0}, {0, 0, 0, 1}, 1},
                                       {{1, 1, 0}, {0, 0, 0, 1}, 1},
                                       {{2, 1, 0}, {0, 0, 0, 1}, 1}};
    gphys_model_desc descs[3];
    gphys_model_id coins[3];
    gphys_model_info info;
    for (uint32_t i = 0; i < 3; ++i) {
        MUST(gphys_model_desc_init(&descs[i], sizeof descs[i]));
        descs[i].tag = 100 + i;
    }
    MUST(gphys_scene_add_described_batch(scene, GPHYS_SHAPE_SPHERE, &coin, 0, places,
                                         sizeof places[0], descs, sizeof descs[0], 3,
                                         coins));
    MUST(gphys_scene_get_info(scene, coins[2], &info));
    EXPECT(info.tag == 102);
}

/* Somebody takes a coin. Its id stays invalid, so what still knows it finds out. */
static void remove_one(gphys_scene* scene, gphys_model_id coin) {
    MUST(gphys_scene_remove(scene, coin));
    EXPECT(gphys_scene_has(scene, coin) == GPHYS_ERROR_INVALID_ID);
}

/* A wave of enemies is over. All of them go in one call, or none if an id is wrong. */
static void remove_many(gphys_scene* scene, const gphys_model_id enemies[3]) {
    MUST(gphys_scene_remove_batch(scene, enemies, 3));
    /* Once more is an error, as they are gone. */
    EXPECT(gphys_scene_remove_batch(scene, enemies, 3) == GPHYS_ERROR_INVALID_ID);
}

/* The next level begins with an empty scene. */
static void clear(gphys_scene* scene) {
    uint32_t total;
    MUST(gphys_scene_clear(scene));
    MUST(gphys_scene_get_models(scene, NULL, 0, &total));
    EXPECT(total == 0);
}

/* A walk over all models of a scene with two crates: first how many there are, then
 * their ids. */
static void list(const gphys_scene* scene) {
    uint32_t total;
    gphys_scene_get_models(scene, NULL, 0, &total);
    gphys_model_id* models = malloc(total * sizeof *models);
    MUST(gphys_scene_get_models(scene, models, total, &total));
    for (uint32_t i = 0; i < total; ++i) MUST(gphys_scene_has(scene, models[i]));
    EXPECT(total == 2 && models[0] < models[1]);
    free(models);
}

/* What a crate of 1 m is and what its shape is, for an editor's panel. */
static void describe(const gphys_scene* scene, gphys_model_id crate) {
    gphys_model_info info;
    gphys_aabb box;
    MUST(gphys_scene_get_info(scene, crate, &info));
    EXPECT(info.type == GPHYS_SHAPE_AABB && info.layers == 1 && info.parent == 0);
    MUST(gphys_scene_get_shape(scene, crate, &box, sizeof box));
    EXPECT(box.max.x - box.min.x == 1); /* as it was given, wherever the crate is */
}

/* The mesh of a rock, to draw it. The handle is one of its own and is given back. */
static void mesh_of(const gphys_scene* scene, gphys_model_id rock) {
    gphys_mesh* mesh = NULL;
    gphys_mesh_info info;
    MUST(gphys_scene_get_mesh(scene, rock, &mesh));
    MUST(gphys_mesh_get_info(mesh, &info));
    EXPECT(info.kind == GPHYS_MESH_HULL && info.vertex_count == 4);
    gphys_mesh_destroy(mesh);
}

/* The boxes in the world of a crate of 1 m at x = 5, and of all models: the other crate
 * is at x = 9. */
static void bounds(const gphys_scene* scene, gphys_model_id crate) {
    gphys_aabb box, all;
    MUST(gphys_scene_get_bounds(scene, crate, &box));
    MUST(gphys_scene_get_scene_bounds(scene, &all));
    EXPECT(fabsf(box.min.x - 4.5f) < 1e-4f && fabsf(box.max.x - 5.5f) < 1e-4f);
    EXPECT(all.min.x <= box.min.x && fabsf(all.max.x - 9.5f) < 1e-4f);
}

/* A character crouches: another shape for the same model, whose id, place and tag stay.
 */
static void set_shape(gphys_scene* scene, gphys_model_id character) {
    const gphys_capsule crouching = {{0, 0.25f, 0}, {0, 0.75f, 0}, 0.25f};
    gphys_aabb box;
    MUST(gphys_scene_set_shape(scene, character, GPHYS_SHAPE_CAPSULE, &crouching));
    MUST(gphys_scene_get_bounds(scene, character, &box));
    EXPECT(fabsf(box.max.y - 1) < 1e-4f);
}

/* A crate of 1 m becomes a wall: 6 m long, 3 m high, a quarter of a metre thick. */
static void set_scale(gphys_scene* scene, gphys_model_id crate) {
    const gphys_vec3 scale = {6, 3, 0.25f};
    gphys_vec3 now;
    gphys_aabb box;
    MUST(gphys_scene_set_scale(scene, crate, &scale));
    MUST(gphys_scene_get_scale(scene, crate, &now));
    MUST(gphys_scene_get_bounds(scene, crate, &box));
    EXPECT(now.x == 6 && fabsf(box.max.y - box.min.y - 3) < 1e-4f);
}

/* A ghost: a ray with the mask 1 goes through, one with the mask 4 meets it. The crate
 * is 4.5 m ahead. */
static void set_layers(gphys_scene* scene, gphys_model_id crate) {
    const gphys_ray ray = {{0, 0.5f, 0}, {1, 0, 0}, 4.75f};
    gphys_hit hit;
    MUST(gphys_scene_set_layers(scene, crate, 4));
    EXPECT(gphys_scene_raycast(scene, &ray, 1, &hit) == GPHYS_NO_HIT);
    MUST(gphys_scene_raycast(scene, &ray, 4, &hit));
    EXPECT(hit.model == crate && hit.t == 4.5f);
}

/* The tag says what a model is to the program: an index into its own table, changed
 * when the entry moves. */
static void set_tag(gphys_scene* scene, gphys_model_id crate) {
    gphys_model_info info;
    MUST(gphys_scene_set_tag(scene, crate, 17));
    MUST(gphys_scene_get_info(scene, crate, &info));
    EXPECT(info.tag == 17);
}

/* A door turns by a quarter about its hinge, the y axis. The next query sees it there.
 */
static void set_transform(gphys_scene* scene, gphys_model_id door) {
    const float half = sqrtf(0.5f);
    const gphys_transform open = {{5, 0, 0}, {0, half, 0, half}, 1};
    gphys_transform now;
    MUST(gphys_scene_set_transform(scene, door, &open));
    MUST(gphys_scene_get_transforms(scene, &door, 1, &now, sizeof now));
    EXPECT(now.rotation.y == half && now.position.x == 5);
}

/* All that moved in a frame is placed in one call. */
static void set_transforms(gphys_scene* scene, const gphys_model_id cars[2]) {
    const gphys_transform places[2] = {{{10, 0, 0}, {0, 0, 0, 1}, 1},
                                       {{10, 0, 3}, {0, 0, 0, 1}, 1}};
    gphys_transform now[2];
    MUST(gphys_scene_set_transforms(scene, cars, places, sizeof places[0], 2));
    MUST(gphys_scene_get_world_transforms(scene, cars, 2, now, sizeof now[0]));
    EXPECT(now[0].position.x == 10 && now[1].position.z == 3);
}

static gphys_scene* empty(void) {
    gphys_scene* scene = NULL;
    MUST(gphys_scene_create(NULL, &scene));
    return scene;
}

static gphys_model_id crate_at(gphys_scene* scene, float x) {
    const gphys_aabb box = {{-0.5f, 0, -0.5f}, {0.5f, 1, 0.5f}};
    const gphys_transform place = {{x, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_model_id crate;
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &box, &place, NULL, &crate));
    return crate;
}

int main(void) {
    gphys_scene* scene = empty();
    create();
    add(scene);
    clear(scene);
    add_batch(scene);
    clear(scene);
    add_described_batch(scene);
    clear(scene);

    const gphys_model_id crates[2] = {crate_at(scene, 5), crate_at(scene, 9)};
    list(scene);
    describe(scene, crates[0]);
    bounds(scene, crates[0]);
    set_layers(scene, crates[0]);
    set_tag(scene, crates[0]);
    set_scale(scene, crates[0]);
    set_transform(scene, crates[0]);
    set_transforms(scene, crates);
    set_shape(scene, crates[1]);

    const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    gphys_mesh* hull = NULL;
    gphys_model_id rock;
    MUST(gphys_mesh_create_hull(NULL, corners[0], sizeof corners[0], 4, &hull));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_MESH, hull, NULL, NULL, &rock));
    gphys_mesh_destroy(hull); /* the model keeps it */
    mesh_of(scene, rock);

    remove_one(scene, rock);
    const gphys_model_id enemies[3] = {crate_at(scene, 1), crate_at(scene, 2),
                                       crate_at(scene, 3)};
    remove_many(scene, enemies);
    gphys_scene_destroy(scene);
    return 0;
}
