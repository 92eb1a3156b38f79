/* gphys_mesh_*: what each entry point accepts, refuses and leaves alone. */
#include <math.h>
#include <stdlib.h>

#include "test.h"

static const float cube_vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
static const uint32_t cube_indices[] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                        2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

static gphys_mesh* make_cube(void) {
    gphys_mesh* mesh = NULL;
    assert_int_equal(gphys_mesh_create(NULL, cube_vertices, 12, 8, cube_indices, 36, &mesh), GPHYS_OK);
    assert_non_null(mesh);
    return mesh;
}

static void test_report(void** state) {
    gphys_mesh_report report, checked;
    gphys_mesh* mesh = make_cube();
    (void)state;
    assert_int_equal(gphys_mesh_get_report(mesh, &report), GPHYS_OK);
    assert_int_equal(report.triangle_count, 12);
    assert_int_equal(report.degenerate_count, 0);
    assert_int_equal(report.open_edge_count, 0);
    assert_int_equal(report.first_degenerate, GPHYS_NO_TRIANGLE);
    assert_int_equal(gphys_mesh_check(cube_vertices, 12, 8, cube_indices, 36, &checked), GPHYS_OK);
    assert_memory_equal(&report, &checked, sizeof report);
    gphys_mesh_destroy(mesh);
}

static void a_mesh_tells_what_it_is(void** state) {
    gphys_mesh *surface = make_cube(), *hull = NULL, *soft = NULL;
    gphys_mesh_desc desc;
    gphys_mesh_info info = {7, 7, 7, 7, 7};
    (void)state;
    assert_int_equal(gphys_mesh_get_info(NULL, &info), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_info(surface, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(info.kind, 7);
    assert_int_equal(gphys_mesh_get_info(surface, &info), GPHYS_OK);
    assert_true(info.kind == GPHYS_MESH_SURFACE && info.vertex_count == 8 && info.triangle_count == 12);
    assert_true(info.deformable == 0 && info.follows_body == 0);
    assert_int_equal(gphys_mesh_create_hull(NULL, cube_vertices, 12, 7, &hull), GPHYS_OK);
    assert_int_equal(gphys_mesh_get_info(hull, &info), GPHYS_OK);
    assert_true(info.kind == GPHYS_MESH_HULL && info.vertex_count == 7 && info.triangle_count == 10);
    assert_true(info.deformable == 0 && info.follows_body == 0);
    assert_int_equal(gphys_mesh_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.deformable = 1;
    assert_int_equal(gphys_mesh_create(&desc, cube_vertices, 12, 8, cube_indices, 36, &soft), GPHYS_OK);
    assert_int_equal(gphys_mesh_get_info(soft, &info), GPHYS_OK);
    assert_true(info.kind == GPHYS_MESH_SURFACE && info.deformable == 1 && info.follows_body == 0);
    gphys_mesh_destroy(surface);
    gphys_mesh_destroy(hull);
    gphys_mesh_destroy(soft);
}

static void test_check_finds_what_create_refuses(void** state) {
    float vertices[24];
    uint32_t indices[36];
    gphys_mesh_report report;
    gphys_mesh* mesh = (gphys_mesh*)&report;
    (void)state;
    memcpy(vertices, cube_vertices, sizeof vertices);
    memcpy(indices, cube_indices, sizeof indices);
    indices[10] = 8;
    assert_int_equal(gphys_mesh_check(vertices, 12, 8, indices, 36, &report), GPHYS_OK);
    assert_int_equal(report.out_of_range_count, 1);
    assert_int_equal(report.first_out_of_range, 3);
    assert_int_equal(gphys_mesh_create(NULL, vertices, 12, 8, indices, 36, &mesh), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_string_equal(gphys_last_error(), "gphys_mesh_create: indices[10] 8 is not below vertex_count");
    indices[10] = 0xffffffffu;
    assert_int_equal(gphys_mesh_create(NULL, vertices, 12, 8, indices, 36, &mesh), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_string_equal(gphys_last_error(), "gphys_mesh_create: indices[10] 4294967295 is not below vertex_count");
    indices[10] = cube_indices[10];

    {
        const float bad[] = {NAN, INFINITY, -INFINITY, 1.1e15f, -FLT_MAX};
        size_t i;
        for (i = 0; i < sizeof bad / sizeof *bad; ++i) {
            vertices[7] = bad[i];
            assert_int_equal(gphys_mesh_check(vertices, 12, 8, indices, 36, &report), GPHYS_OK);
            assert_int_equal(report.bad_vertex_count, 1);
            assert_int_equal(report.first_bad_vertex, 2);
            assert_int_equal(gphys_mesh_create(NULL, vertices, 12, 8, indices, 36, &mesh),
                             GPHYS_ERROR_INVALID_ARGUMENT);
            assert_true(strlen(gphys_last_error()) > 0);
        }
    }
    assert_ptr_equal(mesh, &report);
}

static void test_arguments_of_create(void** state) {
    gphys_mesh* mesh = NULL;
    gphys_mesh_report report;
    gphys_mesh_desc desc;
    gphys_allocator half = {NULL, NULL, NULL};
    (void)state;
    assert_int_equal(gphys_mesh_create(NULL, NULL, 12, 8, cube_indices, 36, &mesh), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create(NULL, cube_vertices, 12, 8, NULL, 36, &mesh), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create(NULL, cube_vertices, 12, 8, cube_indices, 36, NULL),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create(NULL, cube_vertices, 12, 8, cube_indices, 35, &mesh),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create(NULL, cube_vertices, 0, 8, cube_indices, 36, &mesh),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create(NULL, cube_vertices, 8, 8, cube_indices, 36, &mesh),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create(NULL, cube_vertices, 14, 8, cube_indices, 36, &mesh),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_check(cube_vertices, 12, 8, cube_indices, 36, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_check(NULL, 12, 8, cube_indices, 36, &report), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_check(cube_vertices, 12, 8, NULL, 36, &report), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_check(cube_vertices, 4, 8, cube_indices, 36, &report), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_check(cube_vertices, 12, 8, cube_indices, 1, &report), GPHYS_ERROR_INVALID_ARGUMENT);

    assert_int_equal(gphys_mesh_desc_init(NULL, sizeof desc), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_desc_init(&desc, 3), GPHYS_ERROR_STRUCT_SIZE);
    memset(&desc, 0, sizeof desc);
    assert_int_equal(gphys_mesh_create(&desc, cube_vertices, 12, 8, cube_indices, 36, &mesh), GPHYS_ERROR_STRUCT_SIZE);
    assert_int_equal(gphys_mesh_desc_init(&desc, sizeof desc), GPHYS_OK);
    assert_int_equal(desc.struct_size, sizeof desc);
    assert_null(desc.allocator);
    desc.allocator = &half;
    assert_int_equal(gphys_mesh_create(&desc, cube_vertices, 12, 8, cube_indices, 36, &mesh),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_null(mesh);
    gphys_mesh_destroy(NULL);
}

static void test_a_mesh_without_triangles(void** state) {
    gphys_mesh* mesh = NULL;
    gphys_ray ray = {{0, 0, 0}, {1, 0, 0}, INFINITY};
    gphys_octree_stats stats;
    gphys_mesh_report report;
    uint32_t total = 7;
    int32_t hit = 7;
    (void)state;
    assert_int_equal(gphys_mesh_create(NULL, NULL, 12, 0, NULL, 0, &mesh), GPHYS_OK);
    assert_int_equal(gphys_mesh_get_report(mesh, &report), GPHYS_OK);
    assert_int_equal(report.triangle_count, 0);
    assert_int_equal(gphys_mesh_raycast_any(mesh, &ray, &hit), GPHYS_OK);
    assert_int_equal(hit, 0);
    assert_int_equal(gphys_mesh_raycast_all(mesh, &ray, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    assert_int_equal(gphys_mesh_get_octree_stats(mesh, &stats), GPHYS_OK);
    assert_int_equal(stats.depth, 0);
    assert_int_equal(gphys_mesh_get_octree_boxes(mesh, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    gphys_mesh_destroy(mesh);
}

static void test_arrays_are_copied(void** state) {
    float vertices[8][5]; /* wider than a vertex */
    uint32_t indices[36], out_indices[37], total = 0, i;
    gphys_vec3 out_vertices[9];
    gphys_mesh* mesh = NULL;
    (void)state;
    for (i = 0; i < 8; ++i) {
        memcpy(vertices[i], cube_vertices + 3 * i, 12);
        vertices[i][3] = vertices[i][4] = NAN;
    }
    memcpy(indices, cube_indices, sizeof indices);
    assert_int_equal(gphys_mesh_create(NULL, &vertices[0][0], sizeof vertices[0], 8, indices, 36, &mesh), GPHYS_OK);
    memset(vertices, 0, sizeof vertices);
    memset(indices, 0, sizeof indices);

    assert_int_equal(gphys_mesh_get_vertices(mesh, NULL, 0, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 8);
    assert_int_equal(gphys_mesh_get_vertices(mesh, out_vertices, 9, &total), GPHYS_OK);
    assert_memory_equal(out_vertices, cube_vertices, sizeof cube_vertices);
    assert_int_equal(gphys_mesh_get_indices(mesh, out_indices, 37, &total), GPHYS_OK);
    assert_int_equal(total, 36);
    assert_memory_equal(out_indices, cube_indices, sizeof cube_indices);
    memset(out_indices, 0xff, sizeof out_indices);
    assert_int_equal(gphys_mesh_get_indices(mesh, out_indices, 5, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 36);
    assert_memory_equal(out_indices, cube_indices, 5 * sizeof *out_indices);
    assert_int_equal(out_indices[5], 0xffffffffu);
    gphys_mesh_destroy(mesh);
}

static void test_batches_of_rays(void** state) {
    gphys_mesh* mesh = make_cube();
    gphys_ray rays[70];
    gphys_hit hits[70];
    gphys_distance distances[70];
    int32_t any[70], one;
    int i, met = 0;
    (void)state;
    for (i = 0; i < 70; ++i) {
        /* an image of the cube, of which some rays miss */
        const gphys_ray ray = {{-1, 0.5f, 0.5f}, {1, (float)(i % 10 - 5) / 6, (float)(i / 10 - 3) / 6}, INFINITY};
        rays[i] = ray;
    }
    assert_int_equal(gphys_shape_raycast_batch(GPHYS_SHAPE_MESH, mesh, rays, sizeof *rays, 70, hits, sizeof *hits),
                     GPHYS_OK);
    assert_int_equal(gphys_mesh_raycast_distance_batch(mesh, rays, sizeof *rays, 70, distances, sizeof *distances),
                     GPHYS_OK);
    assert_int_equal(gphys_mesh_raycast_any_batch(mesh, rays, sizeof *rays, 70, any, sizeof *any), GPHYS_OK);
    for (i = 0; i < 70; ++i) {
        assert_memory_equal(&distances[i].t, &hits[i].t, sizeof(float));
        assert_int_equal(distances[i].triangle, hits[i].triangle);
        assert_int_equal(distances[i].model, 0);
        assert_int_equal(gphys_mesh_raycast_any(mesh, &rays[i], &one), GPHYS_OK);
        assert_int_equal(any[i], one);
        assert_int_equal(any[i], hits[i].triangle != GPHYS_NO_TRIANGLE);
        met += any[i];
    }
    assert_true(met > 10 && met < 60);
    /* one ray twice, and none */
    assert_int_equal(gphys_mesh_raycast_any_batch(mesh, &rays[35], 0, 2, any, sizeof *any), GPHYS_OK);
    assert_true(any[0] == 1 && any[1] == 1);
    assert_int_equal(gphys_mesh_raycast_any_batch(mesh, NULL, 0, 0, NULL, 4), GPHYS_OK);
    assert_int_equal(gphys_mesh_raycast_distance_batch(mesh, NULL, 0, 0, NULL, 12), GPHYS_OK);

    any[0] = 7, distances[0].t = 7;
    rays[1].t_max = NAN;
    assert_int_equal(gphys_mesh_raycast_any_batch(NULL, rays, 0, 1, any, 4), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_any_batch(mesh, NULL, 0, 1, any, 4), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_any_batch(mesh, rays, 30, 1, any, 4), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_any_batch(mesh, rays, 0, 1, NULL, 4), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_any_batch(mesh, rays, 0, 1, any, 2), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_any_batch(mesh, rays, 28, 2, any, 4), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(gphys_last_error(), ": rays[1].t_max nan is not "));
    assert_int_equal(gphys_mesh_raycast_distance_batch(NULL, rays, 0, 1, distances, 12), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_distance_batch(mesh, NULL, 0, 1, distances, 12), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_distance_batch(mesh, rays, 30, 1, distances, 12), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_distance_batch(mesh, rays, 0, 1, NULL, 12), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_distance_batch(mesh, rays, 0, 1, distances, 8), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_distance_batch(mesh, rays, 28, 2, distances, 12), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_true(any[0] == 7 && distances[0].t == 7);
    gphys_mesh_destroy(mesh);
}

static void test_raycast_all(void** state) {
    gphys_mesh* mesh = make_cube();
    /* Through the diagonals of the faces x = 0 and x = 1: two triangles each. */
    gphys_ray ray = {{-1, 0.5f, 0.5f}, {0.5f, 0, 0}, INFINITY};
    gphys_hit hits[5];
    uint32_t total = 0;
    int32_t any = 0;
    (void)state;
    assert_int_equal(gphys_mesh_raycast_all(mesh, &ray, hits, 5, &total), GPHYS_OK);
    assert_int_equal(total, 4);
    assert_true(hits[0].t == 2 && hits[1].t == 2 && hits[2].t == 4 && hits[3].t == 4);
    assert_true(hits[0].triangle == 8 && hits[1].triangle == 9);
    assert_true(hits[2].triangle == 10 && hits[3].triangle == 11);
    assert_true(hits[0].normal.x == -1 && hits[0].model == 0 && hits[0].tag == 0);
    memset(hits, 0, sizeof hits);
    assert_int_equal(gphys_mesh_raycast_all(mesh, &ray, hits, 3, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 4);
    assert_true(hits[0].triangle == 8 && hits[1].triangle == 9 && hits[2].triangle == 10 && hits[3].triangle == 0);
    assert_int_equal(gphys_mesh_raycast_any(mesh, &ray, &any), GPHYS_OK);
    assert_int_equal(any, 1);
    ray.t_max = 1.9f;
    assert_int_equal(gphys_mesh_raycast_any(mesh, &ray, &any), GPHYS_OK);
    assert_int_equal(any, 0);
    assert_int_equal(gphys_mesh_raycast_all(mesh, &ray, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);

    total = 77, any = 77;
    ray.t_max = INFINITY;
    assert_int_equal(gphys_mesh_raycast_all(NULL, &ray, hits, 5, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_all(mesh, NULL, hits, 5, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_all(mesh, &ray, NULL, 5, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_all(mesh, &ray, hits, 5, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_any(NULL, &ray, &any), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_any(mesh, NULL, &any), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_raycast_any(mesh, &ray, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    ray.direction.x = 0;
    assert_int_equal(gphys_mesh_raycast_any(mesh, &ray, &any), GPHYS_ERROR_INVALID_ARGUMENT);
    ray.direction.x = NAN;
    assert_int_equal(gphys_mesh_raycast_all(mesh, &ray, hits, 5, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_true(total == 77 && any == 77);
    gphys_mesh_destroy(mesh);
}

static void test_overlap(void** state) {
    gphys_mesh* mesh = make_cube();
    gphys_sphere sphere = {{0, 0.5f, 0.5f}, 0.25f};
    gphys_plane plane = {{1, 0, 0}, 0};
    uint32_t triangles[12], total = 0;
    (void)state;
    assert_int_equal(gphys_mesh_overlap(mesh, GPHYS_SHAPE_SPHERE, &sphere, triangles, 12, &total), GPHYS_OK);
    assert_int_equal(total, 2);
    assert_true(triangles[0] == 8 && triangles[1] == 9);
    assert_int_equal(gphys_mesh_overlap(mesh, GPHYS_SHAPE_SPHERE, &sphere, triangles, 1, &total), GPHYS_INCOMPLETE);
    assert_true(total == 2 && triangles[0] == 8);
    /* All but the two of the face x = 1: the others touch the plane at least with a corner. */
    assert_int_equal(gphys_mesh_overlap(mesh, GPHYS_SHAPE_PLANE, &plane, triangles, 12, &total), GPHYS_OK);
    assert_int_equal(total, 10);

    total = 77;
    assert_int_equal(gphys_mesh_overlap(NULL, GPHYS_SHAPE_SPHERE, &sphere, triangles, 12, &total),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_overlap(mesh, GPHYS_SHAPE_SPHERE, NULL, triangles, 12, &total),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_overlap(mesh, 99, &sphere, triangles, 12, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_overlap(mesh, GPHYS_SHAPE_MESH, mesh, triangles, 12, &total), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_mesh_overlap(mesh, GPHYS_SHAPE_SPHERE, &sphere, NULL, 12, &total),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_overlap(mesh, GPHYS_SHAPE_SPHERE, &sphere, triangles, 12, NULL),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    sphere.radius = -1;
    assert_int_equal(gphys_mesh_overlap(mesh, GPHYS_SHAPE_SPHERE, &sphere, triangles, 12, &total),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(total, 77);
    gphys_mesh_destroy(mesh);
}

static void test_octree(void** state) {
    gphys_mesh* mesh = make_cube();
    gphys_octree_stats stats;
    gphys_octree_box boxes[16];
    uint32_t total = 0, items = 0, i;
    (void)state;
    assert_int_equal(gphys_mesh_get_octree_stats(mesh, &stats), GPHYS_OK);
    assert_int_equal(stats.item_count, 12);
    assert_int_equal(stats.unbounded_count, 0);
    assert_int_equal(stats.rebuilds, 0);
    assert_int_equal(stats.depth, 2);
    assert_int_equal(gphys_mesh_get_octree_boxes(mesh, boxes, 16, &total), GPHYS_OK);
    assert_int_equal(total, stats.node_count);
    assert_int_equal(boxes[0].depth, 0);
    assert_true(boxes[0].bounds.min.x == 0 && boxes[0].bounds.max.z == 1);
    for (i = 0; i < total; ++i) items += boxes[i].item_count;
    assert_int_equal(items, 12);
    boxes[1].depth = 99;
    assert_int_equal(gphys_mesh_get_octree_boxes(mesh, boxes, 1, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, stats.node_count);
    assert_int_equal(boxes[1].depth, 99);

    assert_int_equal(gphys_mesh_get_octree_stats(NULL, &stats), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_octree_stats(mesh, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_octree_boxes(NULL, boxes, 1, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_octree_boxes(mesh, NULL, 1, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_octree_boxes(mesh, boxes, 1, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_report(NULL, (gphys_mesh_report*)boxes), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_report(mesh, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_vertices(NULL, NULL, 0, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_vertices(mesh, NULL, 1, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_vertices(mesh, NULL, 0, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_indices(NULL, NULL, 0, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_indices(mesh, NULL, 1, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_indices(mesh, NULL, 0, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    gphys_mesh_destroy(mesh);
}

/* An allocator that fails at a given allocation. */
typedef struct Budget {
    long allocations, fail_at, live;
    size_t bytes;
} Budget;

static void* budget_allocate(void* user, size_t size, size_t alignment) {
    Budget* budget = user;
    char *start, *block;
    if (budget->allocations++ == budget->fail_at) return NULL;
    start = malloc(size + alignment + sizeof(void*));
    if (!start) return NULL;
    block = start + sizeof(void*);
    block += (alignment - (uintptr_t)block % alignment) % alignment;
    memcpy(block - sizeof start, &start, sizeof start);
    ++budget->live;
    budget->bytes += size;
    return block;
}

static void budget_release(void* user, void* memory, size_t size, size_t alignment) {
    Budget* budget = user;
    char* start;
    (void)alignment;
    memcpy(&start, (char*)memory - sizeof start, sizeof start);
    --budget->live;
    budget->bytes -= size;
    free(start);
}

static gphys_status make_surface(const gphys_mesh_desc* desc, gphys_mesh** out_mesh) {
    return gphys_mesh_create(desc, cube_vertices, 12, 8, cube_indices, 36, out_mesh);
}

static gphys_status make_hull(const gphys_mesh_desc* desc, gphys_mesh** out_mesh) {
    return gphys_mesh_create_hull(desc, cube_vertices, 12, 8, out_mesh);
}

static void running_out_of_memory(gphys_status (*make)(const gphys_mesh_desc* desc, gphys_mesh** out_mesh)) {
    Budget budget = {0, -1, 0, 0};
    gphys_allocator allocator;
    gphys_mesh_desc desc;
    gphys_mesh* mesh = NULL;
    gphys_ray ray = {{-1, 0.5f, 0.5f}, {1, 0, 0}, INFINITY};
    gphys_hit hits[4];
    uint32_t total;
    long needed, fail_at;
    allocator.allocate = budget_allocate;
    allocator.release = budget_release;
    allocator.user = &budget;
    assert_int_equal(gphys_mesh_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.allocator = &allocator;
    assert_int_equal(make(&desc, &mesh), GPHYS_OK);
    needed = budget.allocations;
    assert_true(needed > 3 && budget.live > 0);
    assert_int_equal(gphys_mesh_raycast_all(mesh, &ray, hits, 4, &total), GPHYS_OK);
    assert_int_equal(budget.allocations, needed);
    gphys_mesh_destroy(mesh);
    assert_int_equal(budget.live, 0);
    assert_int_equal(budget.bytes, 0);

    for (fail_at = 0; fail_at < needed; ++fail_at) {
        budget.allocations = 0;
        budget.fail_at = fail_at;
        mesh = NULL;
        assert_int_equal(make(&desc, &mesh), GPHYS_ERROR_OUT_OF_MEMORY);
        assert_null(mesh);
        assert_int_equal(budget.live, 0);
        assert_int_equal(budget.bytes, 0);
    }
}

static void test_running_out_of_memory(void** state) {
    (void)state;
    running_out_of_memory(make_surface);
    running_out_of_memory(make_hull);
}

static void a_hull_is_made_of_points(void** state) {
    /* A cube with a point inside, one on a face, one on an edge, and one twice. */
    float points[12 * 3];
    gphys_mesh *hull = NULL, *refused = (gphys_mesh*)points, *surface, *loaded = NULL;
    gphys_mesh_desc desc;
    gphys_mesh_report report;
    gphys_plane planes[8];
    gphys_vec3 vertices[9];
    uint32_t faces[13], words[600], total, i;
    gphys_ray ray = {{0.25f, 0.5f, -3}, {0, 0, 1}, INFINITY};
    const gphys_ray from_inside = {{0.25f, 0.5f, 0.5f}, {0, 0, 1}, INFINITY};
    gphys_hit hit;
    int32_t contains;
    (void)state;
    memcpy(points, cube_vertices, sizeof cube_vertices);
    for (i = 0; i < 3; ++i) {
        points[24 + i] = 0.5f;
        points[27 + i] = i == 0 ? 1.0f : 0.5f;
        points[30 + i] = i == 0 ? 0.5f : 1.0f;
        points[33 + i] = 1;
    }
    assert_int_equal(gphys_mesh_create_hull(NULL, points, 12, 12, &hull), GPHYS_OK);
    assert_int_equal(gphys_mesh_get_vertices(hull, vertices, 9, &total), GPHYS_OK);
    assert_int_equal(total, 8);
    assert_memory_equal(vertices, cube_vertices, sizeof cube_vertices);
    assert_int_equal(gphys_mesh_get_report(hull, &report), GPHYS_OK);
    assert_true(report.triangle_count == 12 && report.open_edge_count == 0 && report.degenerate_count == 0);
    assert_int_equal(gphys_mesh_get_hull_planes(hull, planes, 8, &total), GPHYS_OK);
    assert_int_equal(total, 6);
    for (i = 0; i < 6; ++i) {
        const float* n = &planes[i].normal.x;
        assert_true(fabsf(n[0]) + fabsf(n[1]) + fabsf(n[2]) == 1);
        assert_true(planes[i].distance == (n[0] + n[1] + n[2] > 0 ? 1.0f : 0.0f));
    }
    assert_int_equal(gphys_mesh_get_hull_faces(hull, faces, 13, &total), GPHYS_OK);
    assert_int_equal(total, 12);
    for (i = 0; i < 12; ++i) assert_int_equal(faces[i], i / 2);
    assert_int_equal(gphys_mesh_get_hull_planes(hull, planes, 2, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 6);
    assert_int_equal(gphys_mesh_get_hull_faces(hull, NULL, 0, &total), GPHYS_INCOMPLETE);

    assert_int_equal(gphys_shape_raycast(GPHYS_SHAPE_MESH, hull, &ray, &hit), GPHYS_OK);
    assert_true(hit.t == 3 && hit.normal.z == -1 && hit.flags == 0 && faces[hit.triangle] < 6);
    assert_int_equal(gphys_shape_raycast(GPHYS_SHAPE_MESH, hull, &from_inside, &hit), GPHYS_OK);
    assert_true(hit.t == 0 && hit.flags == GPHYS_HIT_INSIDE && hit.triangle == GPHYS_NO_TRIANGLE);
    assert_int_equal(gphys_shape_contains(GPHYS_SHAPE_MESH, hull, &from_inside.origin, 0, &contains), GPHYS_OK);
    assert_int_equal(contains, 1);
    assert_int_equal(gphys_shape_contains(GPHYS_SHAPE_MESH, hull, &ray.origin, 0, &contains), GPHYS_OK);
    assert_int_equal(contains, 0);

    assert_int_equal(gphys_mesh_get_snapshot(hull, words, 600, &total), GPHYS_OK);
    assert_int_equal(gphys_mesh_create_from_snapshot(NULL, words, total, &loaded), GPHYS_OK);
    assert_int_equal(gphys_mesh_get_hull_planes(loaded, planes, 8, &total), GPHYS_OK);
    assert_int_equal(total, 6);
    gphys_mesh_destroy(loaded);
    assert_int_equal(gphys_mesh_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.deformable = 1;
    assert_int_equal(gphys_mesh_create_hull(&desc, points, 12, 12, &refused), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_mesh_create_from_snapshot(&desc, words, 600, &refused), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_snapshot(hull, words, 600, &total), GPHYS_OK);
    assert_int_equal(gphys_mesh_create_from_snapshot(&desc, words, total, &refused), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_mesh_set_vertices(hull, points, 12, 8), GPHYS_ERROR_UNSUPPORTED);

    /* Flat, too many faces, bad points and arguments. */
    assert_int_equal(gphys_mesh_create_hull(NULL, points, 12, 4, &refused), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create_hull(NULL, NULL, 12, 0, &refused), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create_hull(NULL, NULL, 12, 8, &refused), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create_hull(NULL, points, 0, 8, &refused), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create_hull(NULL, points, 14, 8, &refused), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create_hull(NULL, points, 12, 8, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    {
        float many[3 * 600];
        for (i = 0; i < 600; ++i) {
            const float angle = (float)i * 0.0104719755f;
            many[3 * i] = 100 * cosf(angle);
            many[3 * i + 1] = 100 * sinf(angle);
            many[3 * i + 2] = (float)(i % 2);
        }
        assert_int_equal(gphys_mesh_create_hull(NULL, many, 12, 600, &refused), GPHYS_ERROR_CAPACITY);
    }
    points[4] = NAN;
    assert_int_equal(gphys_mesh_create_hull(NULL, points, 12, 12, &refused), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_ptr_equal(refused, points);
    surface = make_cube();
    assert_int_equal(gphys_mesh_get_hull_planes(surface, planes, 8, &total), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_mesh_get_hull_faces(surface, faces, 13, &total), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_mesh_get_hull_planes(NULL, planes, 8, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_hull_faces(NULL, faces, 13, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_hull_planes(hull, NULL, 8, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_hull_faces(hull, faces, 13, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    gphys_mesh_destroy(surface);
    gphys_mesh_destroy(hull);
}

/* As of any solid: a particle that falls on a hull lies on it, one that was put inside comes out, and what moves fast
   does not pass. */
static void particles_stay_outside_of_a_hull(void** state) {
    const float slope[] = {-4, 0, -4, 4, 0, -4, -4, 0, 4, 4, 0, 4, -4, 1, -4, -4, 1, 4};
    gphys_vec3 start[3] = {{-1, 3, 0}, {-1.5f, 0.6f, 1}, {-2, 5, 2}}, at[3],
               velocities[3] = {{0, 0, 0}, {0, 0, 0}, {0, -400, 0}};
    gphys_mesh* hull = NULL;
    gphys_scene* scene;
    gphys_solver* solver;
    gphys_body_desc desc;
    gphys_body_id bodies[2];
    gphys_model_id model;
    gphys_nearest near;
    int kind, i;
    uint32_t p;
    (void)state;
    assert_int_equal(gphys_mesh_create_hull(NULL, slope, 12, 6, &hull), GPHYS_OK);
    for (kind = 0; kind < 2; ++kind) {
        assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
        assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, hull, NULL, NULL, &model), GPHYS_OK);
        assert_int_equal(gphys_solver_create(NULL, &solver), GPHYS_OK);
        assert_int_equal(gphys_body_desc_init(&desc, sizeof desc), GPHYS_OK);
        desc.radius = 0.05f;
        desc.friction = 1;
        desc.restitution = 0;
        if (kind == 0) {
            assert_int_equal(gphys_solver_add_particles(solver, &desc, start, sizeof *start, 3, bodies), GPHYS_OK);
            assert_int_equal(gphys_solver_set_velocities(solver, bodies[0], 0, 3, velocities, sizeof *velocities),
                             GPHYS_OK);
        } else {
            assert_int_equal(gphys_solver_add_rope(solver, &desc, start, sizeof *start, 3, 0, bodies), GPHYS_OK);
        }
        for (i = 0; i < 300; ++i) assert_int_equal(gphys_solver_step(solver, scene, 0.01f), GPHYS_OK);
        assert_int_equal(gphys_solver_get_positions(solver, bodies[0], 0, 3, at, sizeof *at), GPHYS_OK);
        for (p = 0; p < 3; ++p) {
            assert_int_equal(gphys_shape_closest_point(GPHYS_SHAPE_MESH, hull, &at[p], &near), GPHYS_OK);
            assert_true(near.distance > 0.049f && (near.distance < 0.06f || kind == 1));
        }
        gphys_solver_destroy(solver);
        gphys_scene_destroy(scene);
    }
    gphys_mesh_destroy(hull);
}

/* It lies on the hull of a box, and is lifted by it. */
static void cloth_is_carried_by_a_hull(void** state) {
    const float corners[] = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};
    const gphys_vec3 corner = {-1.5f, 1.2f, -1.5f}, edge_u = {3, 0, 0}, edge_v = {0, 0, 3};
    gphys_transform place = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_vec3 at[16 * 16], local;
    gphys_mesh* hull = NULL;
    gphys_scene* scene;
    gphys_solver* solver;
    gphys_body_id cloth;
    gphys_model_id model;
    gphys_nearest near;
    int step, p;
    float highest = -INFINITY;
    (void)state;
    assert_int_equal(gphys_mesh_create_hull(NULL, corners, 12, 8, &hull), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, hull, NULL, NULL, &model), GPHYS_OK);
    assert_int_equal(gphys_solver_create(NULL, &solver), GPHYS_OK);
    assert_int_equal(gphys_solver_add_cloth(solver, NULL, &corner, &edge_u, &edge_v, 16, 16, &cloth), GPHYS_OK);
    for (step = 0; step < 180; ++step) {
        if (step >= 90) {
            place.position.y += 0.02f;
            assert_int_equal(gphys_scene_set_transform(scene, model, &place), GPHYS_OK);
        }
        assert_int_equal(gphys_solver_step(solver, scene, 1 / 60.0f), GPHYS_OK);
        assert_int_equal(gphys_solver_get_positions(solver, cloth, 0, 256, at, sizeof *at), GPHYS_OK);
        for (p = 0; p < 256; ++p) {
            local = at[p];
            local.y -= place.position.y;
            assert_int_equal(gphys_shape_closest_point(GPHYS_SHAPE_MESH, hull, &local, &near), GPHYS_OK);
            assert_true(near.distance > 0.0099f);
        }
    }
    for (p = 0; p < 256; ++p) highest = at[p].y > highest ? at[p].y : highest;
    assert_true(highest > 2.8f && highest < 3.2f);
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);
    gphys_mesh_destroy(hull);
}

static void a_deformable_mesh_takes_other_vertices(void** state) {
    float moved[5 * 4];
    const float vertices[4 * 3] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const uint32_t indices[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    gphys_mesh *mesh = NULL, *rigid = NULL;
    gphys_mesh_desc desc;
    gphys_mesh_report report;
    gphys_scene* scene;
    gphys_model_id model;
    gphys_aabb bounds;
    gphys_ray ray = {{0.1f, 0.1f, -5}, {0, 0, 1}, INFINITY};
    gphys_hit hit;
    uint32_t i;
    (void)state;
    assert_int_equal(gphys_mesh_desc_init(&desc, sizeof desc), GPHYS_OK);
    assert_true(desc.deformable == 0 && desc.reserved == 0);
    desc.deformable = 2;
    assert_int_equal(gphys_mesh_create(&desc, vertices, 12, 4, indices, 12, &mesh), GPHYS_ERROR_INVALID_ARGUMENT);
    desc.deformable = 1;
    desc.reserved = 1;
    assert_int_equal(gphys_mesh_create(&desc, vertices, 12, 4, indices, 12, &mesh), GPHYS_ERROR_INVALID_ARGUMENT);
    desc.reserved = 0;
    assert_int_equal(gphys_mesh_create(&desc, vertices, 12, 4, indices, 12, &mesh), GPHYS_OK);
    assert_int_equal(gphys_mesh_create(NULL, vertices, 12, 4, indices, 12, &rigid), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, NULL, &model), GPHYS_OK);

    for (i = 0; i < 20; ++i) moved[i] = i % 5 < 3 ? vertices[i / 5 * 3 + i % 5] + (i % 5 == 2 ? 10.0f : 0.0f) : NAN;
    assert_int_equal(gphys_mesh_set_vertices(mesh, moved, 20, 4), GPHYS_OK);
    assert_int_equal(gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit), GPHYS_OK);
    assert_true(hit.model == model && hit.t == 15);
    assert_int_equal(gphys_scene_get_bounds(scene, model, &bounds), GPHYS_OK);
    assert_true(bounds.min.z <= 10 && bounds.min.z > 9.999f && bounds.max.z >= 11 && bounds.max.z < 11.001f);
    assert_int_equal(gphys_scene_validate(scene), GPHYS_OK);
    for (i = 0; i < 4; ++i) moved[5 * i + 2] = 3; /* flat: the last corner is the first one now */
    assert_int_equal(gphys_mesh_set_vertices(mesh, moved, 20, 4), GPHYS_OK);
    assert_int_equal(gphys_mesh_get_report(mesh, &report), GPHYS_OK);
    assert_true(report.degenerate_count == 2 && report.first_degenerate == 1 && report.open_edge_count == 0);
    assert_int_equal(gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit), GPHYS_OK);
    assert_true(hit.t == 8);

    assert_int_equal(gphys_mesh_set_vertices(rigid, vertices, 12, 4), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_mesh_set_vertices(NULL, vertices, 12, 4), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_set_vertices(mesh, NULL, 12, 4), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_set_vertices(mesh, vertices, 8, 4), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_set_vertices(mesh, vertices, 12, 3), GPHYS_ERROR_INVALID_ARGUMENT);
    for (i = 0; i < 4; ++i) {
        float bad[12];
        memcpy(bad, vertices, sizeof bad);
        bad[i * 3 + i % 3] = i % 2 ? NAN : 2e15f;
        assert_int_equal(gphys_mesh_set_vertices(mesh, bad, 12, 4), GPHYS_ERROR_INVALID_ARGUMENT);
    }
    assert_int_equal(gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit), GPHYS_OK);
    assert_true(hit.t == 8);
    gphys_mesh_destroy(mesh);
    gphys_mesh_destroy(rigid);
    gphys_scene_destroy(scene);
}

/* Takes a snapshot into memory of its own. */
static uint32_t* snapshot_of(const gphys_mesh* mesh, uint32_t* count) {
    uint32_t* words;
    assert_int_equal(gphys_mesh_get_snapshot(mesh, NULL, 0, count), GPHYS_INCOMPLETE);
    words = malloc(sizeof *words * *count);
    assert_int_equal(gphys_mesh_get_snapshot(mesh, words, *count, count), GPHYS_OK);
    return words;
}

static void test_a_snapshot_is_loaded(void** state) {
    const gphys_ray ray = {{0.3f, 0.2f, -1}, {0, 0, 1}, 10};
    gphys_mesh *mesh = make_cube(), *loaded = NULL;
    gphys_hit hit, expected;
    gphys_mesh_report report;
    gphys_mesh_desc desc;
    uint32_t count, again, *words = snapshot_of(mesh, &count), *second;
    (void)state;
    assert_int_equal(gphys_shape_raycast(GPHYS_SHAPE_MESH, mesh, &ray, &expected), GPHYS_OK);
    gphys_mesh_destroy(mesh);
    assert_int_equal(gphys_mesh_desc_init(&desc, sizeof desc), GPHYS_OK);
    assert_int_equal(gphys_mesh_create_from_snapshot(&desc, words, count, &loaded), GPHYS_OK);
    assert_int_equal(gphys_shape_raycast(GPHYS_SHAPE_MESH, loaded, &ray, &hit), GPHYS_OK);
    assert_memory_equal(&hit, &expected, sizeof hit);
    assert_int_equal(gphys_mesh_get_report(loaded, &report), GPHYS_OK);
    assert_int_equal(report.triangle_count, 12);
    assert_int_equal(report.open_edge_count, 0);
    second = snapshot_of(loaded, &again);
    assert_int_equal(again, count);
    assert_memory_equal(second, words, sizeof *words * count);
    free(second);
    free(words);
    gphys_mesh_destroy(loaded);
}

static void test_what_is_no_snapshot_is_refused(void** state) {
    gphys_mesh *mesh = make_cube(), *loaded = NULL;
    uint32_t count, i, *words = snapshot_of(mesh, &count), total = 7;
    (void)state;
    for (i = 0; i < count; ++i) {
        words[i] ^= 1u << i % 32;
        assert_int_equal(gphys_mesh_create_from_snapshot(NULL, words, count, &loaded), GPHYS_ERROR_INVALID_ARGUMENT);
        words[i] ^= 1u << i % 32;
        assert_int_equal(gphys_mesh_create_from_snapshot(NULL, words, i, &loaded), GPHYS_ERROR_INVALID_ARGUMENT);
    }
    assert_int_equal(gphys_mesh_create_from_snapshot(NULL, NULL, count, &loaded), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create_from_snapshot(NULL, words, count, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_null(loaded);
    assert_int_equal(gphys_mesh_get_snapshot(NULL, words, count, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_snapshot(mesh, NULL, 1, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_get_snapshot(mesh, words, count, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(total, 7);
    free(words);
    gphys_mesh_destroy(mesh);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hull_is_made_of_points),
        cmocka_unit_test(particles_stay_outside_of_a_hull),
        cmocka_unit_test(cloth_is_carried_by_a_hull),
        cmocka_unit_test(test_report),
        cmocka_unit_test(a_mesh_tells_what_it_is),
        cmocka_unit_test(test_check_finds_what_create_refuses),
        cmocka_unit_test(test_arguments_of_create),
        cmocka_unit_test(test_a_mesh_without_triangles),
        cmocka_unit_test(test_arrays_are_copied),
        cmocka_unit_test(test_batches_of_rays),
        cmocka_unit_test(test_raycast_all),
        cmocka_unit_test(test_overlap),
        cmocka_unit_test(test_octree),
        cmocka_unit_test(test_running_out_of_memory),
        cmocka_unit_test(a_deformable_mesh_takes_other_vertices),
        cmocka_unit_test(test_a_snapshot_is_loaded),
        cmocka_unit_test(test_what_is_no_snapshot_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
