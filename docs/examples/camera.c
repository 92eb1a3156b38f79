/* A camera: its projection, its place, its matrices, and what it sees. The camera of
 * these examples is at the origin, as at creation: left-handed, it looks along +Z, with
 * +Y up and +X right, in a viewport of 800 by 600 pixels. */
#include <math.h>

#include "check.h"

/* A camera for OpenGL: right-handed, with depths from -1 to 1, for a window of 1280 by
 * 720 pixels. */
static void create(void) {
    gphys_camera_desc desc;
    gphys_camera* camera = NULL;
    MUST(gphys_camera_desc_init(&desc, sizeof desc));
    desc.handedness = GPHYS_RIGHT_HANDED;
    desc.depth_range = GPHYS_DEPTH_MINUS_ONE_TO_ONE;
    desc.viewport_width = 1280;
    desc.viewport_height = 720;
    MUST(gphys_camera_create(&desc, &camera));
    gphys_camera_destroy(camera);
}

/* What a camera was created with: the defaults here, which are those of DirectX. */
static void conventions(const gphys_camera* camera) {
    gphys_handedness handedness;
    gphys_depth_range depth_range;
    int32_t reverse_z;
    MUST(gphys_camera_get_conventions(camera, &handedness, &depth_range, &reverse_z));
    EXPECT(handedness == GPHYS_LEFT_HANDED && depth_range == GPHYS_DEPTH_ZERO_TO_ONE &&
           reverse_z == 0);
}

/* A view of 60 degrees from bottom to top, from 10 cm to 500 m. */
static void perspective(gphys_camera* camera) {
    const float fov_y = 1.0471976f;
    gphys_projection kind;
    float size, near_distance, far_distance;
    MUST(gphys_camera_set_perspective(camera, fov_y, 0.1f, 500));
    MUST(gphys_camera_get_projection(camera, &kind, &size, &near_distance,
                                     &far_distance));
    EXPECT(kind == GPHYS_PROJECTION_PERSPECTIVE && size == fov_y);
    EXPECT(near_distance == 0.1f && far_distance == 500);
}

/* A map from above that shows 30 m from top to bottom. The window has 800 by 600
 * pixels, so it shows 40 m across. */
static void orthographic(gphys_camera* camera) {
    float width, height;
    MUST(gphys_camera_set_orthographic(camera, 30, 0, 100));
    MUST(gphys_camera_get_image_size(camera, &width, &height));
    EXPECT(width == 40 && height == 30);
}

/* A film picture of 2.39 : 1, whatever the window: the aspect stays when the window
 * changes. */
static void perspective_aspect(gphys_camera* camera) {
    float aspect;
    int32_t is_fixed;
    MUST(gphys_camera_set_perspective_aspect(camera, 0.8f, 2.39f, 0.1f, 500));
    MUST(gphys_camera_get_aspect(camera, &aspect, &is_fixed));
    EXPECT(aspect == 2.39f && is_fixed == 1);
}

/* A shadow map of 64 m by 64 m, whatever the viewport. */
static void orthographic_size(gphys_camera* camera) {
    float width, height;
    MUST(gphys_camera_set_orthographic_size(camera, 64, 64, 0, 200));
    MUST(gphys_camera_get_image_size(camera, &width, &height));
    EXPECT(width == 64 && height == 64);
}

/* A projection matrix of another library: orthographic, 4 m wide, 2 m high, from z = 0
 * to 10. */
static void projection(gphys_camera* camera) {
    const gphys_mat4 matrix = {{0.5f, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.1f, 0, 0, 0, 0, 1}};
    gphys_mat4 now;
    MUST(gphys_camera_set_projection(camera, &matrix));
    MUST(gphys_camera_get_projection_matrix(camera, &now));
    EXPECT(now.m[0] == 0.5f && now.m[5] == 1 && now.m[10] == 0.1f);
}

/* The window was resized. */
static void viewport(gphys_camera* camera) {
    float width, height;
    MUST(gphys_camera_set_viewport(camera, 1920, 1080));
    MUST(gphys_camera_get_viewport(camera, &width, &height));
    EXPECT(width == 1920 && height == 1080);
}

/* The right half of a window of 1600 by 600 pixels: pixels count from the window's
 * corner, x from 800 on. */
static void split_screen(gphys_camera* camera) {
    const gphys_vec3 ahead = {0, 0, 10};
    gphys_vec3 pixel;
    float x, y;
    MUST(gphys_camera_set_viewport(camera, 800, 600));
    MUST(gphys_camera_set_viewport_origin(camera, 800, 0));
    MUST(gphys_camera_get_viewport_origin(camera, &x, &y));
    EXPECT(x == 800 && y == 0);
    MUST(gphys_camera_project(camera, &ahead, &pixel));
    EXPECT(fabsf(pixel.x - 1200) < 1e-3f && fabsf(pixel.y - 300) < 1e-3f);
}

/* The camera goes to (0, 2, -5) and turns by 90 degrees about y: it looks along +x
 * then. */
static void place(gphys_camera* camera) {
    const gphys_vec3 position = {0, 2, -5};
    const gphys_quat rotation = {0, sqrtf(0.5f), 0, sqrtf(0.5f)};
    gphys_vec3 where;
    gphys_quat turned;
    MUST(gphys_camera_set_transform(camera, &position, &rotation));
    MUST(gphys_camera_get_transform(camera, &where, &turned));
    EXPECT(where.y == 2 && where.z == -5 && fabsf(turned.y - rotation.y) < 1e-6f);
}

/* Stand at (3, 2, -5) and look at a point in front, straight along z. */
static void look_at(gphys_camera* camera) {
    const gphys_vec3 eye = {3, 2, -5}, target = {3, 2, 0}, up = {0, 1, 0};
    gphys_vec3 pixel;
    MUST(gphys_camera_look_at(camera, &eye, &target, &up));
    MUST(gphys_camera_project(camera, &target, &pixel));
    /* The target is in the middle of 800 by 600 pixels. */
    EXPECT(fabsf(pixel.x - 400) < 1e-3f && fabsf(pixel.y - 300) < 1e-3f);
}

/* A matrix of an animation places the camera: its columns are the axes, then the
 * position. */
static void world_matrix(gphys_camera* camera) {
    const gphys_mat4 world = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 2, -5, 1}};
    gphys_mat4 now;
    MUST(gphys_camera_set_world_matrix(camera, &world));
    MUST(gphys_camera_get_world_matrix(camera, &now));
    EXPECT(now.m[12] == 3 && now.m[13] == 2 && now.m[14] == -5);
}

/* The view matrix of another engine, from the world to the camera: the camera is at (3,
 * 2, -5). */
static void view_matrix(gphys_camera* camera) {
    const gphys_mat4 view = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -3, -2, 5, 1}};
    gphys_mat4 now;
    gphys_vec3 position;
    gphys_quat rotation;
    MUST(gphys_camera_set_view_matrix(camera, &view));
    MUST(gphys_camera_get_view_matrix(camera, &now));
    MUST(gphys_camera_get_transform(camera, &position, &rotation));
    EXPECT(position.x == 3 && position.y == 2 && position.z == -5 && now.m[14] == 5);
}

/* What a shader needs: one matrix that takes points of the world to clip space. */
static void matrices(const gphys_camera* camera) {
    gphys_mat4 projection, view_projection;
    MUST(gphys_camera_get_projection_matrix(camera, &projection));
    MUST(gphys_camera_get_view_projection_matrix(camera, &view_projection));
    /* The last row of a left-handed perspective takes z for w. */
    EXPECT(projection.m[11] == 1);
}

/* The volume that is seen, to draw it, and for queries: a point 10 m ahead of a camera
 * at the origin is in it. */
static void frustum(const gphys_camera* camera) {
    const gphys_vec3 ahead = {0, 0, 10};
    gphys_frustum view;
    gphys_vec3 corners[8];
    int32_t seen;
    MUST(gphys_camera_get_frustum(camera, &view));
    MUST(gphys_camera_get_corners(camera, corners));
    MUST(gphys_shape_contains(GPHYS_SHAPE_FRUSTUM, &view, &ahead, 0, &seen));
    EXPECT(seen == 1);
    EXPECT(corners[0].x < 0 && corners[0].y < 0); /* near, left, bottom */
}

/* What is seen in the upper left quarter of the image, 400 by 300 pixels of 800 by 600:
 * a tile of it. */
static void tile(const gphys_camera* camera) {
    const gphys_vec3 ahead_left = {-1, 1, 10}, ahead_right = {1, 1, 10};
    gphys_frustum view;
    gphys_vec3 corners[8];
    int32_t left, right;
    MUST(gphys_camera_get_rectangle_frustum(camera, 0, 0, 400, 300, &view));
    MUST(gphys_camera_get_rectangle_corners(camera, 0, 0, 400, 300, corners));
    MUST(gphys_shape_contains(GPHYS_SHAPE_FRUSTUM, &view, &ahead_left, 0, &left));
    MUST(gphys_shape_contains(GPHYS_SHAPE_FRUSTUM, &view, &ahead_right, 0, &right));
    EXPECT(left == 1 && right == 0);
    /* The near corner at the right and the bottom is in the middle of the image. */
    EXPECT(fabsf(corners[1].x) < 1e-6f);
}

/* Where a name is drawn over a head, and back: a pixel with its depth is a point of the
 * world. */
static void project(const gphys_camera* camera) {
    const gphys_vec3 head = {1, 2, 10};
    gphys_vec3 pixel, point;
    MUST(gphys_camera_project(camera, &head, &pixel));
    EXPECT(pixel.x > 400 && pixel.y < 300); /* right of the middle and above it */
    MUST(gphys_camera_unproject(camera, &pixel, &point));
    EXPECT(fabsf(point.x - 1) < 1e-3f && fabsf(point.y - 2) < 1e-3f &&
           fabsf(point.z - 10) < 1e-2f);
}

/* Names of three players. The last is behind the camera and has no pixel: its numbers
 * are INFINITY. */
static void project_batch(const gphys_camera* camera) {
    const gphys_vec3 heads[3] = {{0, 0, 5}, {1, 2, 10}, {0, 2, -10}};
    gphys_vec3 pixels[3];
    MUST(gphys_camera_project_batch(camera, heads, sizeof heads[0], 3, pixels,
                                    sizeof pixels[0]));
    EXPECT(fabsf(pixels[0].x - 400) < 1e-3f && fabsf(pixels[0].y - 300) < 1e-3f);
    EXPECT(pixels[2].x == INFINITY);
}

/* Points of a depth image: the middle of the image, on the near plane and on the far
 * one. */
static void unproject_batch(const gphys_camera* camera) {
    const gphys_vec3 pixels[2] = {{400, 300, 0}, {400, 300, 1}};
    gphys_vec3 points[2];
    MUST(gphys_camera_unproject_batch(camera, pixels, sizeof pixels[0], 2, points,
                                      sizeof points[0]));
    EXPECT(fabsf(points[0].z - 0.1f) < 1e-6f && fabsf(points[1].z - 1000) < 1);
}

/* The player has gone 5 km along x, and the origin of the scene went with him: the
 * camera's must be the same. */
static void origin(gphys_camera* camera) {
    const double player[3] = {5000, 0, 0};
    double now[3];
    gphys_vec3 position;
    gphys_quat rotation;
    MUST(gphys_camera_set_origin(camera, player));
    MUST(gphys_camera_get_origin(camera, now));
    MUST(gphys_camera_get_transform(camera, &position, &rotation));
    /* It has stayed where it was in the world. */
    EXPECT(now[0] == 5000 && position.x == -5000);
}

/* Each example has a camera as it is at creation. */
static gphys_camera* fresh(gphys_camera* old) {
    gphys_camera* camera = NULL;
    gphys_camera_destroy(old);
    MUST(gphys_camera_create(NULL, &camera));
    return camera;
}

int main(void) {
    void (*const settings[])(gphys_camera*) = {
        perspective, orthographic, perspective_aspect, orthographic_size,
        projection,  viewport,     split_screen,       place,
        look_at,     world_matrix, view_matrix,        origin};
    gphys_camera* camera = NULL;
    create();
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; ++i) {
        camera = fresh(camera);
        settings[i](camera);
    }
    camera = fresh(camera);
    conventions(camera);
    matrices(camera);
    frustum(camera);
    tile(camera);
    project(camera);
    project_batch(camera);
    unproject_batch(camera);
    gphys_camera_destroy(camera);
    return 0;
}
