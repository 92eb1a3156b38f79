/* Models and their transforms through the public header: bad input is refused and changes nothing. */
#include "test.h"

static const gphys_aabb unit_box = {{-1, -1, -1}, {1, 1, 1}};
static const gphys_transform identity = {{0, 0, 0}, {0, 0, 0, 1}, 1};

static gphys_scene* scene_of_two(gphys_model_id models[2]) {
    gphys_scene* scene = NULL;
    gphys_transform at = identity;
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, NULL, NULL, &models[0]), GPHYS_OK);
    at.position.x = 10;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, &at, NULL, &models[1]), GPHYS_OK);
    return scene;
}

static void assert_invalid(gphys_status status) {
    assert_int_equal(status, GPHYS_ERROR_INVALID_ARGUMENT);
    assert_true(gphys_last_error()[0] != 0);
}

static void messages_of_a_single_addition_name_its_parameters(void** state) {
    gphys_scene* scene = NULL;
    gphys_model_id model;
    gphys_transform at = identity;
    (void)state;
    at.scale = -1;
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, &at, NULL, &model));
    assert_non_null(strstr(gphys_last_error(), "gphys_scene_add: transform.scale -1"));
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_MESH, NULL, NULL, NULL, &model));
    assert_string_equal(gphys_last_error(), "gphys_scene_add: shape is null");
    gphys_scene_destroy(scene);
}

/* The scene still holds just the two models, where they were. */
static void assert_untouched(gphys_scene* scene, const gphys_model_id models[2]) {
    gphys_model_id found[4];
    gphys_transform transforms[2];
    uint32_t total = 0;
    assert_int_equal(gphys_scene_get_models(scene, found, 4, &total), GPHYS_OK);
    assert_int_equal(total, 2);
    assert_memory_equal(found, models, 2 * sizeof *found);
    assert_int_equal(gphys_scene_get_transforms(scene, models, 2, transforms, sizeof *transforms), GPHYS_OK);
    assert_memory_equal(&transforms[0], &identity, sizeof identity);
    assert_true(transforms[1].position.x == 10);
    assert_int_equal(gphys_scene_validate(scene), GPHYS_OK);
}

static void descs_have_defaults_and_a_size(void** state) {
    gphys_scene_desc scene_desc;
    gphys_model_desc model_desc;
    gphys_scene* scene = NULL;
    gphys_model_id model = 7;
    struct {
        gphys_model_desc known;
        uint32_t unknown[2];
    } newer;
    (void)state;
    assert_invalid(gphys_scene_desc_init(NULL, sizeof scene_desc));
    assert_invalid(gphys_model_desc_init(NULL, sizeof model_desc));
    assert_int_equal(gphys_scene_desc_init(&scene_desc, 3), GPHYS_ERROR_STRUCT_SIZE);
    assert_int_equal(gphys_model_desc_init(&model_desc, 0), GPHYS_ERROR_STRUCT_SIZE);
    assert_int_equal(gphys_scene_desc_init(&scene_desc, sizeof scene_desc), GPHYS_OK);
    assert_int_equal(scene_desc.reserve_models, 0);
    assert_null(scene_desc.allocator);
    assert_int_equal(gphys_model_desc_init(&model_desc, sizeof model_desc), GPHYS_OK);
    assert_int_equal(model_desc.layers, 1);
    assert_int_equal(model_desc.parent, 0);
    assert_int_equal(model_desc.tag, 0);

    scene_desc.struct_size = 1;
    assert_int_equal(gphys_scene_create(&scene_desc, &scene), GPHYS_ERROR_STRUCT_SIZE);
    scene_desc.struct_size = sizeof scene_desc;
    scene_desc.reserve_models = 1u << 24;
    assert_int_equal(gphys_scene_create(&scene_desc, &scene), GPHYS_ERROR_CAPACITY);
    assert_null(scene);
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);

    model_desc.struct_size = 2;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, NULL, &model_desc, &model),
                     GPHYS_ERROR_STRUCT_SIZE);
    /* A newer client's desc: taken while what this library does not know is zero. */
    assert_int_equal(gphys_model_desc_init(&newer.known, sizeof newer), GPHYS_OK);
    newer.unknown[1] = 1;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, NULL, &newer.known, &model),
                     GPHYS_ERROR_STRUCT_SIZE);
    assert_int_equal(model, 7);
    newer.unknown[1] = 0;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, NULL, &newer.known, &model), GPHYS_OK);
    gphys_scene_destroy(scene);
}

static void creation_checks_its_arguments(void** state) {
    gphys_scene_desc desc;
    gphys_allocator half = {NULL, NULL, NULL};
    gphys_scene* scene = NULL;
    (void)state;
    gphys_scene_destroy(NULL);
    assert_invalid(gphys_scene_create(NULL, NULL));
    gphys_scene_desc_init(&desc, sizeof desc);
    desc.allocator = &half;
    assert_invalid(gphys_scene_create(&desc, &scene));
    assert_null(scene);
}

static void add_refuses_what_is_no_model(void** state) {
    gphys_model_id models[2], out = 99, outs[2] = {98, 97};
    gphys_scene* scene = scene_of_two(models);
    gphys_transform bad = identity;
    gphys_aabb boxes[2];
    gphys_model_desc desc;
    gphys_ray ray = {{0, 0, 0}, {1, 0, 0}, 1};
    gphys_frustum frustum;
    (void)state;
    memset(&frustum, 0, sizeof frustum);
    boxes[0] = boxes[1] = unit_box;
    assert_invalid(gphys_scene_add(NULL, GPHYS_SHAPE_AABB, &unit_box, NULL, NULL, &out));
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, NULL, NULL, NULL, &out));
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_MESH, NULL, NULL, NULL, &out));
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, NULL, NULL, NULL));
    assert_invalid(gphys_scene_add(scene, 0, &unit_box, NULL, NULL, &out));
    assert_invalid(gphys_scene_add(scene, 12345, &unit_box, NULL, NULL, &out));
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_RAY, &ray, NULL, NULL, &out), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SEGMENT, &ray, NULL, NULL, &out), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_FRUSTUM, &frustum, NULL, NULL, &out), GPHYS_ERROR_UNSUPPORTED);
    boxes[1].max.y = NAN;
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &boxes[1], NULL, NULL, &out));
    boxes[1].max.y = INFINITY;
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &boxes[1], NULL, NULL, &out));
    boxes[1].max.y = -2;
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &boxes[1], NULL, NULL, &out));
    assert_invalid(gphys_scene_add_batch(scene, GPHYS_SHAPE_AABB, boxes, sizeof *boxes, NULL, 0, 2, NULL, outs));
    assert_invalid(gphys_scene_add_batch(scene, GPHYS_SHAPE_AABB, boxes, 20, NULL, 0, 1, NULL, outs));
    assert_invalid(gphys_scene_add_batch(scene, GPHYS_SHAPE_AABB, boxes, 26, NULL, 0, 1, NULL, outs));
    assert_invalid(gphys_scene_add_batch(scene, GPHYS_SHAPE_AABB, boxes, 0, &identity, 4, 1, NULL, outs));
    assert_invalid(gphys_scene_add_batch(scene, GPHYS_SHAPE_AABB, boxes, 0, NULL, 0, 1, NULL, NULL));
    bad.position.z = NAN;
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, &bad, NULL, &out));
    bad.position.z = 2e15f;
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, &bad, NULL, &out));
    bad = identity;
    bad.scale = 0;
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, &bad, NULL, &out));
    bad.scale = -1;
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, &bad, NULL, &out));
    bad.scale = FLT_MIN;
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, &bad, NULL, &out));
    bad = identity;
    bad.rotation.w = 2;
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, &bad, NULL, &out));
    gphys_model_desc_init(&desc, sizeof desc);
    desc.parent = 0x01ffffff;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, NULL, &desc, &out), GPHYS_ERROR_INVALID_ID);
    assert_int_equal(out, 99);
    assert_int_equal(outs[0], 98);
    assert_untouched(scene, models);
    assert_int_equal(gphys_scene_add_batch(scene, GPHYS_SHAPE_AABB, NULL, 24, NULL, 0, 0, NULL, NULL), GPHYS_OK);
    assert_untouched(scene, models);
    gphys_scene_destroy(scene);
}

static void stale_ids_are_refused_everywhere(void** state) {
    gphys_model_id models[2], twice[2];
    gphys_scene* scene = scene_of_two(models);
    const gphys_model_id stale[4] = {0, 5, 0x02000000, 0xffffffff};
    gphys_model_info info;
    gphys_aabb box = {{7, 7, 7}, {7, 7, 7}};
    gphys_transform transform = {{7, 7, 7}, {7, 7, 7, 7}, 7};
    int i;
    (void)state;
    memset(&info, 7, sizeof info);
    for (i = 0; i < 4; ++i) {
        const gphys_model_id id = stale[i];
        assert_int_equal(gphys_scene_has(scene, id), GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_remove(scene, id), GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_remove_subtree(scene, id), GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_get_info(scene, id, &info), GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_get_shape(scene, id, &box, sizeof box), GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_get_bounds(scene, id, &box), GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_set_layers(scene, id, 1), GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_set_tag(scene, id, 1), GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_set_parent(scene, id, 0, 0), GPHYS_ERROR_INVALID_ID);
        if (id) assert_int_equal(gphys_scene_set_parent(scene, models[0], id, 0), GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_set_transform(scene, id, &identity), GPHYS_ERROR_INVALID_ID);
        twice[0] = models[1];
        twice[1] = id;
        assert_int_equal(gphys_scene_set_transforms(scene, twice, &identity, 0, 2), GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_remove_batch(scene, twice, 2), GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_get_transforms(scene, &id, 1, &transform, sizeof transform),
                         GPHYS_ERROR_INVALID_ID);
        assert_int_equal(gphys_scene_get_world_transforms(scene, &id, 1, &transform, sizeof transform),
                         GPHYS_ERROR_INVALID_ID);
    }
    assert_int_equal(info.tag, 0x07070707);
    assert_true(box.min.x == 7);
    assert_true(transform.scale == 7);
    assert_untouched(scene, models);
    gphys_scene_destroy(scene);
}

static void null_and_bad_strides_are_refused_everywhere(void** state) {
    gphys_model_id models[2];
    gphys_scene* scene = scene_of_two(models);
    gphys_model_info info;
    gphys_aabb box;
    gphys_transform transform = identity;
    gphys_octree_stats stats;
    gphys_octree_box octree_box;
    uint32_t total = 55;
    int32_t done = 7;
    (void)state;
    assert_invalid(gphys_scene_has(NULL, models[0]));
    assert_invalid(gphys_scene_remove(NULL, models[0]));
    assert_invalid(gphys_scene_remove_batch(NULL, models, 2));
    assert_invalid(gphys_scene_remove_batch(scene, NULL, 2));
    assert_invalid(gphys_scene_remove_subtree(NULL, models[0]));
    assert_invalid(gphys_scene_clear(NULL));
    assert_invalid(gphys_scene_rebuild_octree(NULL));
    assert_invalid(gphys_scene_maintain_octree(NULL, 1, &done));
    assert_invalid(gphys_scene_maintain_octree(scene, 1, NULL));
    assert_int_equal(done, 7);
    assert_invalid(gphys_scene_get_models(NULL, models, 2, &total));
    assert_invalid(gphys_scene_get_models(scene, NULL, 2, &total));
    assert_invalid(gphys_scene_get_models(scene, models, 2, NULL));
    assert_invalid(gphys_scene_get_info(NULL, models[0], &info));
    assert_invalid(gphys_scene_get_info(scene, models[0], NULL));
    assert_invalid(gphys_scene_get_shape(NULL, models[0], &box, sizeof box));
    assert_invalid(gphys_scene_get_shape(scene, models[0], NULL, sizeof box));
    assert_invalid(gphys_scene_get_shape(scene, models[0], &box, sizeof box - 1));
    assert_invalid(gphys_scene_get_bounds(NULL, models[0], &box));
    assert_invalid(gphys_scene_get_bounds(scene, models[0], NULL));
    assert_invalid(gphys_scene_get_scene_bounds(NULL, &box));
    assert_invalid(gphys_scene_get_scene_bounds(scene, NULL));
    assert_invalid(gphys_scene_set_shape(NULL, models[0], GPHYS_SHAPE_AABB, &unit_box));
    assert_invalid(gphys_scene_set_shape(scene, models[0], GPHYS_SHAPE_AABB, NULL));
    assert_invalid(gphys_scene_set_shape(scene, models[0], GPHYS_SHAPE_MESH, NULL));
    assert_invalid(gphys_scene_set_shape(scene, models[0], 99, &unit_box));
    assert_int_equal(gphys_scene_set_shape(scene, models[0], GPHYS_SHAPE_SEGMENT, &unit_box), GPHYS_ERROR_UNSUPPORTED);
    assert_invalid(gphys_scene_set_layers(NULL, models[0], 1));
    assert_invalid(gphys_scene_set_tag(NULL, models[0], 1));
    assert_invalid(gphys_scene_set_parent(NULL, models[0], 0, 0));
    assert_invalid(gphys_scene_set_parent(scene, models[0], 0, 2));
    assert_invalid(gphys_scene_set_transform(NULL, models[0], &identity));
    assert_invalid(gphys_scene_set_transform(scene, models[0], NULL));
    transform.position.y = NAN;
    assert_invalid(gphys_scene_set_transform(scene, models[0], &transform));
    transform.position.y = -INFINITY;
    assert_invalid(gphys_scene_set_transform(scene, models[0], &transform));
    assert_invalid(gphys_scene_set_transforms(NULL, models, &identity, 0, 2));
    assert_invalid(gphys_scene_set_transforms(scene, NULL, &identity, 0, 2));
    assert_invalid(gphys_scene_set_transforms(scene, models, NULL, 0, 2));
    assert_invalid(gphys_scene_set_transforms(scene, models, &identity, 28, 2));
    assert_invalid(gphys_scene_get_transforms(NULL, models, 1, &transform, sizeof transform));
    assert_invalid(gphys_scene_get_transforms(scene, NULL, 1, &transform, sizeof transform));
    assert_invalid(gphys_scene_get_transforms(scene, models, 1, NULL, sizeof transform));
    assert_invalid(gphys_scene_get_transforms(scene, models, 1, &transform, 0));
    assert_invalid(gphys_scene_get_world_transforms(scene, models, 1, &transform, 33));
    assert_invalid(gphys_scene_get_octree_stats(NULL, &stats));
    assert_invalid(gphys_scene_get_octree_stats(scene, NULL));
    assert_invalid(gphys_scene_get_octree_boxes(NULL, &octree_box, 1, &total));
    assert_invalid(gphys_scene_get_octree_boxes(scene, NULL, 1, &total));
    assert_invalid(gphys_scene_get_octree_boxes(scene, &octree_box, 1, NULL));
    assert_invalid(gphys_scene_validate(NULL));
    assert_int_equal(total, 55);
    assert_untouched(scene, models);
    gphys_scene_destroy(scene);
}

static void what_was_set_is_what_one_gets(void** state) {
    gphys_model_id models[2], found[1];
    gphys_scene* scene = scene_of_two(models);
    gphys_model_info info;
    gphys_aabb box;
    gphys_octree_stats stats;
    gphys_octree_box boxes[8];
    uint32_t total = 0;
    (void)state;
    assert_int_equal(gphys_scene_set_layers(scene, models[1], 6), GPHYS_OK);
    assert_int_equal(gphys_scene_set_tag(scene, models[1], 0xabcdef), GPHYS_OK);
    assert_int_equal(gphys_scene_set_parent(scene, models[1], models[0], 1), GPHYS_OK);
    assert_int_equal(gphys_scene_get_info(scene, models[1], &info), GPHYS_OK);
    assert_int_equal(info.type, GPHYS_SHAPE_AABB);
    assert_int_equal(info.layers, 6);
    assert_int_equal(info.tag, 0xabcdef);
    assert_int_equal(info.parent, models[0]);
    assert_int_equal(info.child_count, 0);
    assert_int_equal(gphys_scene_get_info(scene, models[0], &info), GPHYS_OK);
    assert_int_equal(info.child_count, 1);
    assert_int_equal(gphys_scene_get_shape(scene, models[0], &box, sizeof box), GPHYS_OK);
    assert_memory_equal(&box, &unit_box, sizeof box);
    assert_int_equal(gphys_scene_get_bounds(scene, models[1], &box), GPHYS_OK);
    assert_true(box.min.x == 9 && box.max.x == 11 && box.min.y == -1);
    assert_int_equal(gphys_scene_get_scene_bounds(scene, &box), GPHYS_OK);
    assert_true(box.min.x == -1 && box.max.x == 11);

    assert_int_equal(gphys_scene_get_models(scene, NULL, 0, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 2);
    assert_int_equal(gphys_scene_get_models(scene, found, 1, &total), GPHYS_INCOMPLETE);
    assert_int_equal(found[0], models[0]);
    assert_int_equal(gphys_scene_get_octree_stats(scene, &stats), GPHYS_OK);
    assert_int_equal(stats.item_count, 2);
    assert_int_equal(stats.unbounded_count, 0);
    assert_int_equal(gphys_scene_get_octree_boxes(scene, boxes, 8, &total), GPHYS_OK);
    assert_int_equal(total, stats.node_count);
    assert_int_equal(boxes[0].depth, 0);
    assert_int_equal(gphys_scene_clear(scene), GPHYS_OK);
    assert_int_equal(gphys_scene_get_models(scene, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    gphys_scene_destroy(scene);
}

static void an_octree_built_anew_is_that_of_one_call(void** state) {
    enum { SIDE = 40, COUNT = SIDE * SIDE };
    static gphys_transform places[COUNT];
    static gphys_model_id models[COUNT];
    static const gphys_aabb box = {{-0.4f, -0.4f, -0.4f}, {0.4f, 0.4f, 0.4f}};
    gphys_scene *grown, *built;
    gphys_octree_stats before, after, fresh;
    gphys_ray ray;
    gphys_hit hit, again;
    uint32_t i;
    (void)state;
    memset(&ray, 0, sizeof ray);
    memset(&hit, 0, sizeof hit);
    memset(&again, 0, sizeof again);
    ray.origin.x = -5;
    ray.origin.z = 3.125f;
    ray.direction.x = 1;
    ray.t_max = INFINITY;
    assert_int_equal(gphys_scene_create(NULL, &grown), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &built), GPHYS_OK);
    assert_int_equal(gphys_scene_rebuild_octree(grown), GPHYS_OK); /* of no model */
    for (i = 0; i < COUNT; ++i) {
        memset(&places[i], 0, sizeof places[i]);
        places[i].position.x = (float)(i % SIDE);
        places[i].position.z = (float)(i / SIDE);
        places[i].rotation.w = places[i].scale = 1;
        assert_int_equal(gphys_scene_add(grown, GPHYS_SHAPE_AABB, &box, &places[i], NULL, &models[i]), GPHYS_OK);
    }
    assert_int_equal(
        gphys_scene_add_batch(built, GPHYS_SHAPE_AABB, &box, 0, places, sizeof places[0], COUNT, NULL, models),
        GPHYS_OK);
    assert_int_equal(gphys_scene_raycast(grown, &ray, GPHYS_ALL_LAYERS, &hit), GPHYS_OK);
    assert_int_equal(gphys_scene_get_octree_stats(grown, &before), GPHYS_OK);
    assert_int_equal(gphys_scene_rebuild_octree(grown), GPHYS_OK);
    assert_int_equal(gphys_scene_get_octree_stats(grown, &after), GPHYS_OK);
    assert_int_equal(gphys_scene_get_octree_stats(built, &fresh), GPHYS_OK);
    assert_int_equal(after.item_count, COUNT);
    assert_int_equal(after.rebuilds, before.rebuilds + 1);
    assert_true(after.cost < 0.95f * before.cost);
    assert_true(after.cost < 1.01f * fresh.cost);
    assert_int_equal(gphys_scene_validate(grown), GPHYS_OK);
    assert_int_equal(gphys_scene_raycast(grown, &ray, GPHYS_ALL_LAYERS, &again), GPHYS_OK);
    assert_memory_equal(&hit, &again, sizeof hit);
    gphys_scene_destroy(grown);
    gphys_scene_destroy(built);
}

static void maintenance_makes_an_octree_as_good_as_new_while_the_scene_changes(void** state) {
    enum { SIDE = 80, COUNT = SIDE * SIDE };
    static gphys_model_id models[COUNT];
    static const gphys_aabb box = {{-0.4f, -0.4f, -0.4f}, {0.4f, 0.4f, 0.4f}};
    gphys_scene* scene;
    gphys_octree_stats before, after, fresh;
    gphys_transform place;
    int32_t done = 0;
    uint32_t i, calls = 0;
    (void)state;
    memset(&place, 0, sizeof place);
    place.rotation.w = place.scale = 1;
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_maintain_octree(scene, 1000, &done), GPHYS_OK); /* of no model */
    assert_int_equal(done, 1);
    for (i = 0; i < COUNT; ++i) {
        place.position.x = (float)(i % SIDE);
        place.position.z = (float)(i / SIDE);
        assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &box, &place, NULL, &models[i]), GPHYS_OK);
    }
    assert_int_equal(gphys_scene_get_octree_stats(scene, &before), GPHYS_OK);
    assert_int_equal(gphys_scene_maintain_octree(scene, 0, &done), GPHYS_OK);
    assert_int_equal(done, 0);
    for (; !done; ++calls) {
        assert_true(calls < COUNT);
        assert_int_equal(gphys_scene_maintain_octree(scene, 100, &done), GPHYS_OK);
        assert_int_equal(gphys_scene_validate(scene), GPHYS_OK);
        if (calls != 10) continue;
        /* One that moves, and one that goes and comes back elsewhere. */
        place.position.x = (float)(calls % SIDE) + 0.5f;
        place.position.z = (float)(7 * calls % SIDE) + 0.5f;
        assert_int_equal(gphys_scene_set_transform(scene, models[calls], &place), GPHYS_OK);
        place.position.z = SIDE - 1 - place.position.z;
        assert_int_equal(gphys_scene_remove(scene, models[COUNT - 1 - calls]), GPHYS_OK);
        assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &box, &place, NULL, &models[COUNT - 1 - calls]),
                         GPHYS_OK);
    }
    assert_true(calls > 10 && calls < 200); /* so many models are built a hundred at a time, and what changes */
    assert_int_equal(gphys_scene_get_octree_stats(scene, &after), GPHYS_OK);
    assert_int_equal(gphys_scene_rebuild_octree(scene), GPHYS_OK);
    assert_int_equal(gphys_scene_get_octree_stats(scene, &fresh), GPHYS_OK);
    assert_int_equal(after.item_count, COUNT);
    assert_int_equal(after.rebuilds, before.rebuilds); /* no call built all of it */
    assert_true(after.cost < 0.95f * before.cost);
    assert_true(after.cost < fresh.cost + 1.1f); /* the changes may have given the root a parent, which costs 1 */
    assert_int_equal(gphys_scene_maintain_octree(scene, 0, &done), GPHYS_OK);
    assert_int_equal(done, 1);
    gphys_scene_destroy(scene);
}

static void the_tree_of_models_can_be_read(void** state) {
    gphys_model_id models[2], children[3], found[4] = {9, 9, 9, 9};
    gphys_scene* scene = scene_of_two(models);
    gphys_model_desc desc;
    uint32_t total = 7, i;
    (void)state;
    gphys_model_desc_init(&desc, sizeof desc);
    desc.parent = models[0];
    for (i = 0; i < 3; ++i)
        assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, NULL, &desc, &children[i]), GPHYS_OK);
    assert_int_equal(gphys_scene_get_roots(scene, found, 4, &total), GPHYS_OK);
    assert_true(total == 2 && found[0] == models[0] && found[1] == models[1] && found[2] == 9);
    assert_int_equal(gphys_scene_get_children(scene, models[0], found, 4, &total), GPHYS_OK);
    assert_true(total == 3 && found[0] == children[0] && found[1] == children[1] && found[2] == children[2]);
    assert_int_equal(gphys_scene_set_parent(scene, children[1], children[2], 0), GPHYS_OK);
    assert_int_equal(gphys_scene_get_children(scene, models[0], found, 1, &total), GPHYS_INCOMPLETE);
    assert_true(total == 2 && found[0] == children[0] && found[1] == children[1]);
    assert_int_equal(gphys_scene_get_children(scene, children[2], found, 4, &total), GPHYS_OK);
    assert_true(total == 1 && found[0] == children[1]);
    assert_int_equal(gphys_scene_get_children(scene, models[1], NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    assert_int_equal(gphys_scene_remove(scene, models[0]), GPHYS_OK);
    assert_int_equal(gphys_scene_get_roots(scene, NULL, 0, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 3);
    assert_int_equal(gphys_scene_get_children(scene, models[0], found, 4, &total), GPHYS_ERROR_INVALID_ID);
    assert_invalid(gphys_scene_get_children(NULL, models[1], found, 4, &total));
    assert_invalid(gphys_scene_get_children(scene, models[1], NULL, 4, &total));
    assert_invalid(gphys_scene_get_children(scene, models[1], found, 4, NULL));
    assert_invalid(gphys_scene_get_roots(NULL, found, 4, &total));
    assert_invalid(gphys_scene_get_roots(scene, NULL, 4, &total));
    assert_invalid(gphys_scene_get_roots(scene, found, 4, NULL));
    assert_int_equal(total, 3);
    gphys_scene_destroy(scene);
}

static void an_origin_is_checked_kept_and_returned(void** state) {
    const double origin[3] = {1e9, -2e9, 0.125}, bad[3] = {0, 0, (double)INFINITY};
    double now[3] = {7, 7, 7};
    gphys_model_id models[2];
    gphys_transform at;
    gphys_scene* scene = scene_of_two(models);
    (void)state;
    assert_invalid(gphys_scene_set_origin(NULL, origin));
    assert_invalid(gphys_scene_set_origin(scene, NULL));
    assert_invalid(gphys_scene_set_origin(scene, bad));
    assert_invalid(gphys_scene_get_origin(NULL, now));
    assert_invalid(gphys_scene_get_origin(scene, NULL));
    assert_untouched(scene, models);
    assert_int_equal(gphys_scene_get_origin(scene, now), GPHYS_OK);
    assert_true(now[0] == 0 && now[1] == 0 && now[2] == 0);
    assert_int_equal(gphys_scene_set_origin(scene, origin), GPHYS_OK);
    assert_int_equal(gphys_scene_get_origin(scene, now), GPHYS_OK);
    assert_memory_equal(now, origin, sizeof now);
    assert_int_equal(gphys_scene_get_transforms(scene, &models[1], 1, &at, sizeof at), GPHYS_OK);
    assert_true(at.position.y == 2e9f && at.position.z == -0.125f);
    now[0] = now[1] = now[2] = 0;
    assert_int_equal(gphys_scene_set_origin(scene, now), GPHYS_OK);
    assert_untouched(scene, models);
    gphys_scene_destroy(scene);
}

static void a_snapshot_brings_back_the_scene(void** state) {
    static const gphys_sphere ball = {{0, 0, 0}, 0.5f};
    static const gphys_transform place = {{1, 2, 3}, {0, 0, 0, 1}, 2};
    const gphys_ray ray = {{1, 2, -10}, {0, 0, 1}, 100};
    static uint32_t words[256];
    uint32_t count = 0, total = 7, hash[2], other[2], i;
    gphys_scene *scene = NULL, *copy = NULL;
    gphys_model_id model = 0, later[2] = {0, 0};
    gphys_hit hit, expected;
    (void)state;
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &copy), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &place, NULL, &model), GPHYS_OK);
    assert_int_equal(gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &expected), GPHYS_OK);
    assert_int_equal(gphys_scene_get_snapshot(scene, 1, NULL, 0, &count), GPHYS_INCOMPLETE);
    assert_true(count > 20 && count < 256);
    assert_int_equal(gphys_scene_get_snapshot(scene, 0, words, 256, &total), GPHYS_OK);
    assert_int_equal(total, count);

    assert_int_equal(gphys_scene_restore(copy, NULL, words, count), GPHYS_OK);
    assert_int_equal(gphys_scene_raycast(copy, &ray, GPHYS_ALL_LAYERS, &hit), GPHYS_OK);
    assert_memory_equal(&hit, &expected, sizeof hit);
    assert_int_equal(gphys_scene_get_hash(scene, hash), GPHYS_OK);
    assert_int_equal(gphys_scene_get_hash(copy, other), GPHYS_OK);
    assert_memory_equal(hash, other, sizeof hash);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &later[0]), GPHYS_OK);
    assert_int_equal(gphys_scene_add(copy, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &later[1]), GPHYS_OK);
    assert_int_equal(later[0], later[1]);
    assert_int_equal(gphys_scene_validate(copy), GPHYS_OK);

    assert_int_equal(gphys_scene_get_hash(copy, hash), GPHYS_OK);
    for (i = 0; i < count; ++i) {
        words[i] ^= 1u << i % 32;
        assert_int_equal(gphys_scene_restore(copy, scene, words, count), GPHYS_ERROR_INVALID_ARGUMENT);
        words[i] ^= 1u << i % 32;
        assert_int_equal(gphys_scene_restore(copy, scene, words, i), GPHYS_ERROR_INVALID_ARGUMENT);
    }
    assert_int_equal(gphys_scene_restore(NULL, scene, words, count), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_restore(copy, NULL, NULL, count), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_get_snapshot(NULL, 1, words, 256, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_get_snapshot(scene, 2, words, 256, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_get_snapshot(scene, 1, NULL, 256, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_get_snapshot(scene, 1, words, 256, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_get_hash(NULL, hash), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_get_hash(scene, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(total, count);
    assert_int_equal(gphys_scene_get_hash(copy, other), GPHYS_OK);
    assert_memory_equal(hash, other, sizeof hash);
    gphys_scene_destroy(copy);
    gphys_scene_destroy(scene);
}

static const float tent_vertices[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
static const uint32_t tent_indices[6] = {0, 1, 2, 0, 2, 3};

/* The removal of the last model of a mesh is undone with a library that has the mesh. */
static void a_mesh_that_a_restore_does_not_find_comes_from_a_library(void** state) {
    static uint32_t words[1024];
    gphys_scene *scene = NULL, *library = NULL;
    gphys_mesh* mesh = NULL;
    gphys_model_id tent = 0, shelved = 0;
    uint32_t total = 0, hash[2], other[2];
    (void)state;
    assert_int_equal(gphys_mesh_create(NULL, tent_vertices[0], 12, 4, tent_indices, 6, &mesh), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &library), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, NULL, &tent), GPHYS_OK);
    assert_int_equal(gphys_scene_get_snapshot(scene, 0, words, 1024, &total), GPHYS_OK);
    assert_int_equal(gphys_scene_get_hash(scene, hash), GPHYS_OK);
    assert_int_equal(gphys_scene_remove(scene, tent), GPHYS_OK);
    assert_int_equal(gphys_scene_restore(scene, NULL, words, total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(gphys_last_error(), "nor used by a model of library, or of scene if that is NULL"));
    assert_int_equal(gphys_scene_restore(scene, library, words, total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_add(library, GPHYS_SHAPE_MESH, mesh, NULL, NULL, &shelved), GPHYS_OK);
    assert_int_equal(gphys_scene_restore(scene, library, words, total), GPHYS_OK);
    assert_int_equal(gphys_scene_get_hash(scene, other), GPHYS_OK);
    assert_memory_equal(hash, other, sizeof hash);
    gphys_mesh_destroy(mesh);
    gphys_scene_destroy(library);
    gphys_scene_destroy(scene);
}

/* A scene that is restored has meshes of its own: handles of them serve like those that created the first ones. */
static void the_mesh_of_a_model_is_had_back(void** state) {
    static uint32_t words[1024];
    gphys_scene *scene = NULL, *copy = NULL;
    gphys_mesh *mesh = NULL, *got = NULL, *again = NULL, *untouched = (gphys_mesh*)words;
    gphys_mesh_desc desc;
    gphys_mesh_info info;
    gphys_model_id tent = 0, box = 0, other = 0;
    gphys_vec3 vertices[4];
    const gphys_ray ray = {{0.5f, 0.5f, -1}, {0, 0, 1}, 100};
    gphys_hit hit, moved;
    uint32_t indices[6], total = 0;
    (void)state;
    assert_int_equal(gphys_mesh_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.deformable = 1;
    assert_int_equal(gphys_mesh_create(&desc, tent_vertices[0], 12, 4, tent_indices, 6, &mesh), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &copy), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, NULL, &tent), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, NULL, NULL, &box), GPHYS_OK);
    assert_int_equal(gphys_scene_set_layers(scene, box, 2), GPHYS_OK);

    /* The mesh itself, held by three: the creator, the model and the new handle. */
    assert_int_equal(gphys_scene_get_mesh(scene, tent, &got), GPHYS_OK);
    assert_ptr_equal(got, mesh);
    gphys_mesh_destroy(mesh);
    vertices[0].x = vertices[0].y = 0, vertices[0].z = 4;
    vertices[1].x = 2, vertices[1].y = 0, vertices[1].z = 4;
    vertices[2].x = 0, vertices[2].y = 2, vertices[2].z = 4;
    vertices[3].x = vertices[3].y = 0, vertices[3].z = 6;
    assert_int_equal(gphys_scene_raycast(scene, &ray, 1, &hit), GPHYS_OK);
    assert_int_equal(gphys_mesh_set_vertices(got, &vertices[0].x, 12, 4), GPHYS_OK);
    assert_int_equal(gphys_scene_raycast(scene, &ray, 1, &moved), GPHYS_OK);
    assert_true(hit.t == 1 && moved.t == 5);
    gphys_mesh_destroy(got);
    assert_int_equal(gphys_scene_raycast(scene, &ray, 1, &moved), GPHYS_OK);

    /* Of a restored scene. The handle outlives the scene and goes on in another one. */
    assert_int_equal(gphys_scene_get_snapshot(scene, 1, words, 1024, &total), GPHYS_OK);
    assert_int_equal(gphys_scene_restore(copy, NULL, words, total), GPHYS_OK);
    assert_int_equal(gphys_scene_get_mesh(copy, tent, &got), GPHYS_OK);
    assert_true(got != mesh);
    gphys_scene_destroy(copy);
    assert_int_equal(gphys_mesh_get_info(got, &info), GPHYS_OK);
    assert_true(info.kind == GPHYS_MESH_SURFACE && info.vertex_count == 4 && info.triangle_count == 2);
    assert_true(info.follows_body == 0);
    assert_int_equal(gphys_mesh_get_indices(got, indices, 6, &total), GPHYS_OK);
    assert_memory_equal(indices, tent_indices, sizeof indices);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, got, NULL, NULL, &other), GPHYS_OK);
    assert_int_equal(gphys_scene_get_mesh(scene, other, &again), GPHYS_OK);
    assert_ptr_equal(again, got);
    gphys_mesh_destroy(again);
    gphys_mesh_destroy(got);
    assert_int_equal(gphys_scene_remove(scene, tent), GPHYS_OK);
    assert_int_equal(gphys_scene_raycast(scene, &ray, 1, &hit), GPHYS_OK);
    assert_true(hit.model == other && hit.t == moved.t);

    assert_int_equal(gphys_scene_get_mesh(scene, box, &untouched), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_scene_get_mesh(scene, tent, &untouched), GPHYS_ERROR_INVALID_ID);
    assert_invalid(gphys_scene_get_mesh(NULL, other, &untouched));
    assert_invalid(gphys_scene_get_mesh(scene, other, NULL));
    assert_ptr_equal(untouched, (gphys_mesh*)words);
    gphys_scene_destroy(scene);
}

/* The same models as by single calls: the two scenes have one hash. */
static void a_batch_gives_each_model_its_own_desc(void** state) {
    enum { COUNT = 6 };
    struct {
        gphys_model_desc desc;
        float unused;
    } descs[COUNT];
    const gphys_transform up = {{0, 2, 0}, {0, 0, 0, 1}, 1};
    gphys_transform places[COUNT];
    gphys_model_id roots[2][2], models[2][COUNT], parent;
    gphys_scene* scenes[2];
    gphys_model_info info;
    uint32_t hashes[2][2];
    int i, s;
    (void)state;
    memset(descs, 0, sizeof descs);
    for (s = 0; s < 2; ++s) {
        assert_int_equal(gphys_scene_create(NULL, &scenes[s]), GPHYS_OK);
        for (i = 0; i < 2; ++i)
            assert_int_equal(gphys_scene_add(scenes[s], GPHYS_SHAPE_AABB, &unit_box, &up, NULL, &roots[s][i]),
                             GPHYS_OK);
    }
    assert_memory_equal(roots[0], roots[1], sizeof roots[0]);
    for (i = 0; i < COUNT; ++i) {
        gphys_model_desc_init(&descs[i].desc, sizeof descs[i].desc);
        descs[i].desc.parent = i % 3 == 2 ? 0 : roots[0][i % 3];
        descs[i].desc.layers = 1u << i;
        descs[i].desc.tag = 70 + (uint32_t)i;
        places[i] = identity;
        places[i].position.x = (float)(3 * i);
    }
    assert_int_equal(gphys_scene_add_described_batch(scenes[0], GPHYS_SHAPE_AABB, &unit_box, 0, places, sizeof *places,
                                                     &descs[0].desc, sizeof descs[0], COUNT, models[0]),
                     GPHYS_OK);
    for (i = 0; i < COUNT; ++i)
        assert_int_equal(
            gphys_scene_add(scenes[1], GPHYS_SHAPE_AABB, &unit_box, &places[i], &descs[i].desc, &models[1][i]),
            GPHYS_OK);
    assert_memory_equal(models[0], models[1], sizeof models[0]);
    assert_int_equal(gphys_scene_get_info(scenes[0], models[0][4], &info), GPHYS_OK);
    assert_int_equal(info.parent, roots[0][1]);
    assert_int_equal(info.layers, 16);
    assert_int_equal(info.tag, 74);
    assert_int_equal(gphys_scene_get_hash(scenes[0], hashes[0]), GPHYS_OK);
    assert_int_equal(gphys_scene_get_hash(scenes[1], hashes[1]), GPHYS_OK);
    assert_memory_equal(hashes[0], hashes[1], sizeof hashes[0]);

    models[0][0] = 99;
    parent = descs[5].desc.parent;
    descs[5].desc.parent = 0x01ffffff;
    assert_int_equal(gphys_scene_add_described_batch(scenes[0], GPHYS_SHAPE_AABB, &unit_box, 0, places, sizeof *places,
                                                     &descs[0].desc, sizeof descs[0], COUNT, models[0]),
                     GPHYS_ERROR_INVALID_ID);
    descs[5].desc.parent = parent;
    descs[3].desc.struct_size = 8;
    assert_int_equal(gphys_scene_add_described_batch(scenes[0], GPHYS_SHAPE_AABB, &unit_box, 0, places, sizeof *places,
                                                     &descs[0].desc, sizeof descs[0], COUNT, models[0]),
                     GPHYS_ERROR_STRUCT_SIZE);
    descs[3].desc.struct_size = sizeof descs[3]; /* a newer client's, with zeros where this release knows nothing */
    assert_invalid(gphys_scene_add_described_batch(scenes[0], GPHYS_SHAPE_AABB, &unit_box, 0, NULL, 0, &descs[0].desc,
                                                   12, COUNT, models[0]));
    assert_invalid(gphys_scene_add_described_batch(scenes[0], GPHYS_SHAPE_AABB, &unit_box, 0, NULL, 0, &descs[0].desc,
                                                   sizeof descs[0], COUNT, NULL));
    assert_int_equal(models[0][0], 99);
    assert_int_equal(gphys_scene_get_hash(scenes[0], hashes[0]), GPHYS_OK);
    assert_memory_equal(hashes[0], hashes[1], sizeof hashes[0]);
    assert_int_equal(gphys_scene_add_described_batch(scenes[0], GPHYS_SHAPE_AABB, &unit_box, 0, places, sizeof *places,
                                                     &descs[0].desc, sizeof descs[0], COUNT, models[0]),
                     GPHYS_OK);
    assert_int_equal(gphys_scene_validate(scenes[0]), GPHYS_OK);
    gphys_scene_destroy(scenes[0]);
    gphys_scene_destroy(scenes[1]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(messages_of_a_single_addition_name_its_parameters),
        cmocka_unit_test(descs_have_defaults_and_a_size),
        cmocka_unit_test(creation_checks_its_arguments),
        cmocka_unit_test(an_origin_is_checked_kept_and_returned),
        cmocka_unit_test(add_refuses_what_is_no_model),
        cmocka_unit_test(a_batch_gives_each_model_its_own_desc),
        cmocka_unit_test(stale_ids_are_refused_everywhere),
        cmocka_unit_test(null_and_bad_strides_are_refused_everywhere),
        cmocka_unit_test(what_was_set_is_what_one_gets),
        cmocka_unit_test(an_octree_built_anew_is_that_of_one_call),
        cmocka_unit_test(maintenance_makes_an_octree_as_good_as_new_while_the_scene_changes),
        cmocka_unit_test(the_tree_of_models_can_be_read),
        cmocka_unit_test(a_snapshot_brings_back_the_scene),
        cmocka_unit_test(a_mesh_that_a_restore_does_not_find_comes_from_a_library),
        cmocka_unit_test(the_mesh_of_a_model_is_had_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
