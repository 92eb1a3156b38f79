/* Meshes: triangles with a tree, and solid hulls of points. The ramp of these examples
 * has two triangles. It rises from y = 0 at x = 0 to y = 2 at x = 4, and is 3 m wide,
 * from z = 0 on. */
#include <math.h>

#include "check.h"

/* A ramp: a rectangle of two triangles that rises from y = 0 at x = 0 to y = 2 at x
 * = 4. */
static const float RAMP[4][3] = {{0, 0, 0}, {4, 2, 0}, {4, 2, 3}, {0, 0, 3}};
static const uint32_t TRIANGLES[6] = {0, 2, 1, 0, 3, 2};

static gphys_mesh* ramp(void) {
    gphys_mesh* mesh = NULL;
    MUST(gphys_mesh_create(NULL, RAMP[0], sizeof RAMP[0], 4, TRIANGLES, 6, &mesh));
    return mesh;
}

static gphys_mesh* unit_cube(void) {
    static const float corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                        {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    gphys_mesh* hull = NULL;
    MUST(gphys_mesh_create_hull(NULL, corners[0], sizeof corners[0], 8, &hull));
    return hull;
}

/* Arrays of a file: the last index of the second triangle points beyond the vertices.
 */
static void check(void) {
    const float vertices[4][3] = {{0, 0, 0}, {4, 2, 0}, {4, 2, 3}, {0, 0, 3}};
    const uint32_t indices[6] = {0, 2, 1, 0, 3, 4};
    gphys_mesh_report report;
    MUST(gphys_mesh_check(vertices[0], sizeof vertices[0], 4, indices, 6, &report));
    EXPECT(report.triangle_count == 2 && report.degenerate_count == 0 &&
           report.bad_vertex_count == 0);
    EXPECT(report.out_of_range_count == 1 && report.first_out_of_range == 1);
}

/* A ramp of two triangles, and a ray that looks down on its middle. The arrays are
 * copied. */
static void create(void) {
    const float vertices[4][3] = {{0, 0, 0}, {4, 2, 0}, {4, 2, 3}, {0, 0, 3}};
    const uint32_t indices[6] = {0, 2, 1, 0, 3, 2};
    const gphys_ray down = {{2, 10, 1}, {0, -1, 0}, INFINITY};
    gphys_mesh* mesh = NULL;
    gphys_hit hit;
    MUST(gphys_mesh_create(NULL, vertices[0], sizeof vertices[0], 4, indices, 6,
                           &mesh));
    MUST(gphys_shape_raycast(GPHYS_SHAPE_MESH, mesh, &down, &hit));
    EXPECT(hit.t == 9 && hit.point.y == 1 && hit.triangle == 0);
    gphys_mesh_destroy(mesh);
}

/* A flag of one triangle whose tip the wind moves: only a deformable mesh takes other
 * vertices. */
static void set_vertices(void) {
    float vertices[3][3] = {{0, 2, 0}, {0, 3, 0}, {1, 2.5f, 0}};
    const uint32_t indices[3] = {0, 1, 2};
    gphys_mesh_desc desc;
    gphys_mesh* flag = NULL;
    gphys_aabb box;
    MUST(gphys_mesh_desc_init(&desc, sizeof desc));
    desc.deformable = 1;
    MUST(gphys_mesh_create(&desc, vertices[0], sizeof vertices[0], 3, indices, 3,
                           &flag));
    vertices[2][2] = 0.5f;
    MUST(gphys_mesh_set_vertices(flag, vertices[0], sizeof vertices[0], 3));
    MUST(gphys_shape_bounds(GPHYS_SHAPE_MESH, flag, &box));
    EXPECT(box.max.z == 0.5f);
    gphys_mesh_destroy(flag);
}

/* The hull of nine points, the corners of a cube and its centre. It is solid: the point
 * in its middle is in it. */
static void create_hull(void) {
    const float points[9][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                {1, 1, 0}, {0, 0, 1}, {1, 0, 1},
                                {0, 1, 1}, {1, 1, 1}, {0.5f, 0.5f, 0.5f}};
    const gphys_vec3 middle = {0.5f, 0.5f, 0.5f};
    gphys_mesh* hull = NULL;
    int32_t inside;
    MUST(gphys_mesh_create_hull(NULL, points[0], sizeof points[0], 9, &hull));
    MUST(gphys_shape_contains(GPHYS_SHAPE_MESH, hull, &middle, 0, &inside));
    EXPECT(inside == 1);
    gphys_mesh_destroy(hull);
}

/* The six faces of a cube, whose sides are 1 m long, and the face that each of its
 * triangles belongs to. */
static void hull_faces(const gphys_mesh* cube) {
    gphys_plane planes[6];
    uint32_t faces[12], plane_count, triangle_count;
    MUST(gphys_mesh_get_hull_planes(cube, planes, 6, &plane_count));
    MUST(gphys_mesh_get_hull_faces(cube, faces, 12, &triangle_count));
    EXPECT(plane_count == 6 && triangle_count == 12); /* two triangles a face */
    for (uint32_t i = 0; i < triangle_count; ++i) EXPECT(faces[i] == i / 2);
    const gphys_vec3 n = planes[0].normal;
    /* The normals are along the axes. */
    EXPECT(fabsf(n.x) + fabsf(n.y) + fabsf(n.z) == 1);
}

/* What a mesh is, for the list of an editor: a ramp of two triangles, which joins no
 * others at its four sides. */
static void describe(const gphys_mesh* mesh) {
    gphys_mesh_info info;
    gphys_mesh_report report;
    MUST(gphys_mesh_get_info(mesh, &info));
    MUST(gphys_mesh_get_report(mesh, &report));
    EXPECT(info.kind == GPHYS_MESH_SURFACE && info.vertex_count == 4 &&
           info.triangle_count == 2);
    EXPECT(info.deformable == 0 && info.follows_body == 0);
    EXPECT(report.open_edge_count == 4);
}

/* The arrays of a mesh, to draw it. With no room the calls count, so that there is room
 * at the second call. */
static void arrays(const gphys_mesh* mesh) {
    uint32_t vertex_count, index_count;
    EXPECT(gphys_mesh_get_vertices(mesh, NULL, 0, &vertex_count) == GPHYS_INCOMPLETE);
    EXPECT(gphys_mesh_get_indices(mesh, NULL, 0, &index_count) == GPHYS_INCOMPLETE);
    gphys_vec3* vertices = malloc(vertex_count * sizeof *vertices);
    uint32_t* indices = malloc(index_count * sizeof *indices);
    MUST(gphys_mesh_get_vertices(mesh, vertices, vertex_count, &vertex_count));
    MUST(gphys_mesh_get_indices(mesh, indices, index_count, &index_count));
    EXPECT(vertex_count == 4 && vertices[1].x == 4 && vertices[1].y == 2);
    EXPECT(index_count == 6 && indices[0] == 0 && indices[1] == 2);
    free(vertices);
    free(indices);
}

/* A mesh with its tree goes into a cache, and comes back without the work of building
 * the tree. */
static void snapshot(const gphys_mesh* mesh) {
    uint32_t count;
    EXPECT(gphys_mesh_get_snapshot(mesh, NULL, 0, &count) == GPHYS_INCOMPLETE);
    uint32_t* words = malloc(count * sizeof *words);
    MUST(gphys_mesh_get_snapshot(mesh, words, count, &count));

    gphys_mesh* loaded = NULL;
    gphys_mesh_info info;
    MUST(gphys_mesh_create_from_snapshot(NULL, words, count, &loaded));
    MUST(gphys_mesh_get_info(loaded, &info));
    EXPECT(info.triangle_count == 2);
    gphys_mesh_destroy(loaded);
    free(words);
}

/* All hits of a ray that goes up through the ramp at x = 2: one, at a height of 1 m. */
static void raycast_all(const gphys_mesh* ramp) {
    const gphys_ray up = {{2, -5, 1}, {0, 1, 0}, 100};
    gphys_hit hits[4];
    uint32_t total;
    MUST(gphys_mesh_raycast_all(ramp, &up, hits, 4, &total));
    EXPECT(total == 1 && hits[0].t == 6 && hits[0].point.y == 1);
    EXPECT(hits[0].flags & GPHYS_HIT_BACK); /* from below, behind the normal */
}

/* Is a place in the shade of a ramp, with the sun straight above? One place, then
 * three. */
static void raycast_any(const gphys_mesh* ramp) {
    const gphys_ray to_sun[3] = {{{3, 0, 1}, {0, 1, 0}, INFINITY},
                                 {{3, 5, 1}, {0, 1, 0}, INFINITY},
                                 {{9, 0, 1}, {0, 1, 0}, INFINITY}};
    int32_t shaded, all_shaded[3];
    MUST(gphys_mesh_raycast_any(ramp, &to_sun[0], &shaded));
    EXPECT(shaded == 1);
    MUST(gphys_mesh_raycast_any_batch(ramp, to_sun, sizeof to_sun[0], 3, all_shaded,
                                      sizeof all_shaded[0]));
    /* The second place is above the ramp, the third beside it. */
    EXPECT(all_shaded[0] == 1 && all_shaded[1] == 0 && all_shaded[2] == 0);
}

/* Heights of a terrain, by rays that look down from 100 m at three places. The last
 * place is beside the mesh. */
static void heights(const gphys_mesh* ramp) {
    const gphys_ray down[3] = {{{1, 100, 1}, {0, -1, 0}, 200},
                               {{3, 100, 2}, {0, -1, 0}, 200},
                               {{5, 100, 1}, {0, -1, 0}, 200}};
    gphys_distance found[3];
    MUST(gphys_mesh_raycast_distance_batch(ramp, down, sizeof down[0], 3, found,
                                           sizeof found[0]));
    EXPECT(100 - found[0].t == 0.5f && 100 - found[1].t == 1.5f);
    EXPECT(found[2].t == INFINITY && found[2].triangle == GPHYS_NO_TRIANGLE);
}

/* The triangles of a ramp that a foot touches, a ball with a radius of 10 cm. */
static void overlap(const gphys_mesh* ramp) {
    const gphys_sphere foot = {{3, 1.5f, 0.5f}, 0.1f};
    uint32_t triangles[2], total;
    MUST(gphys_mesh_overlap(ramp, GPHYS_SHAPE_SPHERE, &foot, triangles, 2, &total));
    EXPECT(total == 1 && triangles[0] == 0);
}

/* The tree of a mesh: how large it is, and its boxes to draw. That of two triangles is
 * one leaf. */
static void octree(const gphys_mesh* ramp) {
    gphys_octree_stats stats;
    gphys_octree_box boxes[8];
    uint32_t total;
    MUST(gphys_mesh_get_octree_stats(ramp, &stats));
    MUST(gphys_mesh_get_octree_boxes(ramp, boxes, 8, &total));
    printf("%u triangles, %u nodes, %u bytes\n", (unsigned)stats.item_count,
           (unsigned)stats.node_count, (unsigned)stats.memory_bytes);
    EXPECT(stats.item_count == 2 && total >= 1);
    EXPECT(boxes[0].depth == 0 && boxes[0].bounds.max.x >= 4 &&
           boxes[0].bounds.max.y >= 2);
}

int main(void) {
    gphys_mesh *slope = ramp(), *cube = unit_cube();
    check();
    create();
    set_vertices();
    create_hull();
    hull_faces(cube);
    describe(slope);
    arrays(slope);
    snapshot(slope);
    raycast_all(slope);
    raycast_any(slope);
    heights(slope);
    overlap(slope);
    octree(slope);
    gphys_mesh_destroy(slope);
    gphys_mesh_destroy(cube);
    return 0;
}
