// Cameras: settings that are refused leave the camera as it was, batches give the bits of single calls, and what is
// picked or culled fits together.
#include <algorithm>
#include <cmath>

#include "world.h"

namespace fuzz {
namespace {

bool is_finite(const gphys_vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// All that a camera tells of itself.
struct View {
    gphys_vec3 position;
    gphys_quat rotation;
    gphys_mat4 world, view, projection, view_projection;
    gphys_frustum frustum;
};

View view_of(const gphys_camera* camera) {
    View v{};
    const gphys_status statuses[] = {call(gphys_camera_get_transform, camera, &v.position, &v.rotation),
                                     call(gphys_camera_get_world_matrix, camera, &v.world),
                                     call(gphys_camera_get_view_matrix, camera, &v.view),
                                     call(gphys_camera_get_projection_matrix, camera, &v.projection),
                                     call(gphys_camera_get_view_projection_matrix, camera, &v.view_projection)};
    for (const gphys_status status : statuses) FUZZ_CHECK(status == GPHYS_OK, "a camera tells where it is");
    call(gphys_camera_get_frustum, camera, &v.frustum);
    note(v);
    return v;
}

/// A change of the camera by a call that may be refused.
template <class Call>
gphys_status change(gphys_camera* camera, Call&& make) {
    const View before = view_of(camera);
    const gphys_status status = make();
    const View after = view_of(camera);
    FUZZ_CHECK(status == GPHYS_OK || same_bits(before, after), "a camera whose change is refused is as before");
    FUZZ_CHECK(is_finite(after.position) && is_valid(after.rotation), "a camera stands somewhere");
    return status;
}

}  // namespace

void World::create_camera() {
    gphys_camera_desc desc;
    call(gphys_camera_desc_init, &desc, static_cast<uint32_t>(sizeof desc));
    const gphys_allocator hooks = memory_.hooks();
    desc.allocator = &hooks;
    desc.handedness = static_cast<int32_t>(p_.below(2));
    desc.depth_range = static_cast<int32_t>(p_.below(2));
    desc.reverse_z = static_cast<int32_t>(p_.below(2));
    if (p_.one_in(6)) desc.handedness = static_cast<int32_t>(p_.byte());
    if (p_.one_in(6)) desc.viewport_width = p_.hostile();
    gphys_camera* made = nullptr;
    const gphys_status status = call(gphys_camera_create, &desc, &made);
    FUZZ_CHECK((status == GPHYS_OK) == (made != nullptr), "a camera is there if it was created");
    if (!made) return;
    gphys_handedness handedness = -1;
    gphys_depth_range range = -1;
    int32_t reverse_z = -1;
    call(gphys_camera_get_conventions, made, &handedness, &range, &reverse_z);
    FUZZ_CHECK(handedness == desc.handedness && range == desc.depth_range && reverse_z == desc.reverse_z,
               "a camera tells what it was created with");
    double origin[3];
    call(gphys_scene_get_origin, scene_, origin);
    call(gphys_camera_set_origin, made, static_cast<const double*>(origin));
    call(gphys_camera_destroy, camera_);
    camera_ = made;
}

void World::place_camera() {
    if (!camera_) return create_camera();
    switch (p_.below(4)) {
        case 0: {
            gphys_vec3 position = p_.point();
            gphys_quat rotation = p_.rotation();
            p_.spoil(position, 12);
            p_.spoil(rotation, 12);
            const gphys_status status =
                change(camera_, [&] { return call(gphys_camera_set_transform, camera_, &position, &rotation); });
            FUZZ_CHECK((status == GPHYS_OK) == (is_valid(position) && is_valid(rotation)),
                       "cameras stand in valid places");
            return;
        }
        case 1: {
            gphys_vec3 eye = p_.point(), target = p_.point(), up = p_.direction();
            p_.spoil(eye, 12);
            p_.spoil(up, 12);
            change(camera_, [&] { return call(gphys_camera_look_at, camera_, &eye, &target, &up); });
            return;
        }
        case 2: {
            gphys_mat4 world{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
            for (int i = 0; i < 12; ++i) {
                if (p_.one_in(3) && i % 4 != 3) world.m[i] = p_.number();
            }
            p_.spoil(world, 12);
            change(camera_, [&] { return call(gphys_camera_set_world_matrix, camera_, &world); });
            return;
        }
        default: {
            double origin[3] = {p_.number(), p_.number(), p_.number()}, back[3];
            if (p_.one_in(4)) origin[0] = p_.hostile();
            call(gphys_scene_get_origin, scene_, back);
            call(gphys_camera_set_origin, camera_, static_cast<const double*>(origin));
            call(gphys_camera_get_origin, camera_, origin);
            call(gphys_camera_set_origin, camera_, static_cast<const double*>(back));
        }
    }
}

void World::project_camera() {
    if (!camera_) return create_camera();
    const bool bad = p_.one_in(6);
    const float near_distance = bad ? p_.hostile() : 0.01f + p_.size();
    const float far_distance = p_.one_in(3) ? INFINITY : near_distance + 0.1f + p_.size() * 8;
    switch (p_.below(4)) {
        case 0: {
            const float angle = bad ? p_.hostile() : 0.1f + static_cast<float>(p_.byte()) / 100;
            gphys_status set = GPHYS_NO_HIT;
            change(camera_, [&] {
                set = call(gphys_camera_set_perspective, camera_, angle, near_distance, far_distance);
                return set;
            });
            gphys_projection kind = -1;
            float size = 0, from = 0, to = 0;
            call(gphys_camera_get_projection, camera_, &kind, &size, &from, &to);
            FUZZ_CHECK(set != GPHYS_OK || (kind == GPHYS_PROJECTION_PERSPECTIVE && size == angle &&
                                           from == near_distance && to == far_distance),
                       "a perspective is read as it was set");
            return;
        }
        case 1: {
            const float height = bad ? p_.hostile() : 0.1f + p_.size();
            change(camera_,
                   [&] { return call(gphys_camera_set_orthographic, camera_, height, near_distance, far_distance); });
            return;
        }
        case 2: {
            const float width = bad ? p_.hostile() : 1.0f + static_cast<float>(p_.byte());
            const float height = 1.0f + static_cast<float>(p_.byte());
            gphys_status set = GPHYS_NO_HIT;
            change(camera_, [&] {
                set = call(gphys_camera_set_viewport, camera_, width, height);
                return set;
            });
            float x = 0, y = 0;
            call(gphys_camera_get_viewport, camera_, &x, &y);
            FUZZ_CHECK(set != GPHYS_OK || (x == width && y == height), "a viewport is read as it was set");
            return;
        }
        default: {
            gphys_mat4 projection;
            call(gphys_camera_get_projection_matrix, camera_, &projection);
            if (p_.one_in(2)) projection.m[p_.below(16)] = p_.number();
            p_.spoil(projection, 12);
            change(camera_, [&] { return call(gphys_camera_set_projection, camera_, &projection); });
        }
    }
}

void World::view_camera() {
    if (!camera_) return create_camera();
    const float from = p_.one_in(8) ? p_.hostile() : 0.01f + p_.size(), to = from + 0.1f + p_.size() * 8;
    const float width = p_.one_in(8) ? p_.hostile() : 0.1f + p_.size(), height = 0.1f + p_.size();
    gphys_status set = GPHYS_NO_HIT;
    float aspect = 0, image_width = 0, image_height = 0, x = 0, y = 0;
    int32_t fixed = -1;
    switch (p_.below(5)) {
        case 0:
            change(camera_,
                   [&] { return set = call(gphys_camera_set_perspective_aspect, camera_, height, width, from, to); });
            call(gphys_camera_get_aspect, camera_, &aspect, &fixed);
            FUZZ_CHECK(set != GPHYS_OK || (aspect == width && fixed == 1), "an aspect is read as it was set");
            return;
        case 1:
            change(camera_,
                   [&] { return set = call(gphys_camera_set_orthographic_size, camera_, width, height, from, to); });
            call(gphys_camera_get_image_size, camera_, &image_width, &image_height);
            FUZZ_CHECK(set != GPHYS_OK || (image_width == width && image_height == height),
                       "what an orthographic camera sees is as large as it was set");
            return;
        case 2:
            change(camera_, [&] { return set = call(gphys_camera_set_viewport_origin, camera_, width, from); });
            call(gphys_camera_get_viewport_origin, camera_, &x, &y);
            FUZZ_CHECK(set != GPHYS_OK || (x == width && y == from), "a viewport's place is read as it was set");
            return;
        case 3: {
            gphys_pick_start start = static_cast<gphys_pick_start>(p_.below(3)), now = -1;
            set = call(gphys_camera_set_pick_start, camera_, start);
            call(gphys_camera_get_pick_start, camera_, &now);
            FUZZ_CHECK((set == GPHYS_OK) == (start < 2) && (set != GPHYS_OK || now == start),
                       "where sight begins is read as it was set");
            return;
        }
        default: {
            gphys_mat4 view, world;
            call(gphys_camera_get_view_matrix, camera_, &view);
            if (p_.one_in(3)) view.m[p_.below(16)] = p_.number();
            p_.spoil(view, 12);
            if (change(camera_, [&] { return call(gphys_camera_set_view_matrix, camera_, &view); }) != GPHYS_OK) return;
            float deviation = 1;
            call(gphys_camera_get_world_matrix, camera_, &world);
            call(gphys_mat4_orthonormality, &world, &deviation);
            FUZZ_CHECK(deviation < 0x1p-22f, "a camera's axes are orthonormal");
        }
    }
}

void World::rectangles() {
    if (!camera_) return create_camera();
    const float x0 = p_.one_in(8) ? p_.hostile() : p_.number(), y0 = p_.number();
    const float x1 = x0 + p_.number(), y1 = y0 + p_.number();
    Output<gphys_frustum> frustum;
    const gphys_status seen = call(gphys_camera_get_rectangle_frustum, camera_, x0, y0, x1, y1, &frustum.value);
    frustum.after(seen);
    FUZZ_CHECK(seen != GPHYS_OK || is_valid(AnyShape::of(GPHYS_SHAPE_FRUSTUM, frustum.value)),
               "a rectangle's frustum is one that shapes are compared with");
    struct Corners {
        gphys_vec3 corner[8];
    };
    Output<Corners> corners;
    const gphys_status found = call(gphys_camera_get_rectangle_corners, camera_, x0, y0, x1, y1, corners.value.corner);
    corners.after(found);
    for (const gphys_vec3& corner : corners.value.corner) {
        FUZZ_CHECK(found != GPHYS_OK || is_finite(corner), "a rectangle's corners are finite");
    }
}

void World::orbit() {
    if (!camera_) return create_camera();
    gphys_orbit orbit;
    call(gphys_orbit_init, &orbit);
    orbit.target = p_.point();
    orbit.up = p_.direction();
    orbit.distance = p_.size() + 0.5f;
    orbit.yaw = p_.number();
    orbit.pitch = p_.number() / 8;
    p_.spoil(orbit, 8);
    const gphys_status status = change(camera_, [&] { return call(gphys_camera_set_orbit, camera_, &orbit); });
    Output<gphys_orbit> present;
    const gphys_status known = call(gphys_camera_get_orbit, camera_, &present.value);
    present.after(known);
    FUZZ_CHECK(status != GPHYS_OK || known == GPHYS_OK, "an orbit that was set is known");
    if (known != GPHYS_OK) return;
    if (p_.one_in(4)) {
        gphys_orbit_speeds speeds{p_.number(), p_.number(), p_.number(), p_.number(), p_.number()}, now;
        p_.spoil(speeds, 8);
        const gphys_status set = call(gphys_camera_set_orbit_speeds, camera_, &speeds);
        call(gphys_camera_get_orbit_speeds, camera_, &now);
        FUZZ_CHECK(set != GPHYS_OK || same_bits(now, speeds), "an orbit's speeds are read as they were set");
    }
    for (int i = 0; i < 3; ++i) {
        const float a = p_.one_in(8) ? p_.hostile() : p_.number(), b = p_.number();
        call(gphys_camera_orbit_rotate, camera_, a, b);
        call(gphys_camera_orbit_zoom, camera_, b);
        call(gphys_camera_orbit_pan, camera_, b, a);
    }
    change(camera_, [&] { return call(gphys_camera_orbit_update, camera_); });
    call(gphys_camera_get_orbit, camera_, &present.value);
    FUZZ_CHECK(
        present.value.distance >= present.value.min_distance && present.value.distance <= present.value.max_distance,
        "an orbit keeps its distances");
    FUZZ_CHECK(present.value.pitch >= present.value.min_pitch && present.value.pitch <= present.value.max_pitch,
               "an orbit keeps its pitch");
}

void World::inspect_camera() {
    if (!camera_) return create_camera();
    const View view = view_of(camera_);
    const AnyShape frustum = AnyShape::of(GPHYS_SHAPE_FRUSTUM, view.frustum);
    Output<gphys_frustum> again;
    const gphys_status framed = call(gphys_camera_get_frustum, camera_, &again.value);
    again.after(framed);
    FUZZ_CHECK(framed != GPHYS_OK || is_valid(frustum), "a camera's frustum is one that shapes are compared with");
    struct Corners {
        gphys_vec3 corner[8];
    };
    Output<Corners> corners;
    const gphys_status status = call(gphys_camera_get_corners, camera_, corners.value.corner);
    corners.after(status);
    for (const gphys_vec3& corner : corners.value.corner) {
        FUZZ_CHECK(status != GPHYS_OK || is_finite(corner), "a camera's corners are finite");
    }
    gphys_camera* none = nullptr;
    gphys_vec3 point{};
    gphys_ray ray;
    const gphys_status refused[] = {call(gphys_camera_create, nullptr, nullptr),
                                    call(gphys_camera_get_transform, none, nullptr, nullptr),
                                    call(gphys_camera_get_frustum, camera_, nullptr),
                                    call(gphys_camera_look_at, camera_, nullptr, &point, &point),
                                    call(gphys_camera_project, camera_, nullptr, &point),
                                    call(gphys_camera_unproject, none, &point, &point),
                                    call(gphys_camera_project_batch, camera_, &point, 7u, 1u, &point, 12u),
                                    call(gphys_camera_unproject_batch, camera_, &point, 12u, 1u, &point, 7u),
                                    call(gphys_camera_pick_ray, camera_, NAN, 0.0f, &ray),
                                    call(gphys_camera_pick_rays, camera_, 0u, 0u, 1u, 1u, &ray, 2u),
                                    call(gphys_camera_set_origin, camera_, nullptr),
                                    call(gphys_orbit_init, nullptr),
                                    call(gphys_camera_set_orbit, camera_, nullptr),
                                    call(gphys_camera_desc_init, nullptr, 0u)};
    for (const gphys_status refusal : refused) FUZZ_CHECK(refusal < 0, "a call that makes no sense is refused");
}

void World::project() {
    if (!camera_) return create_camera();
    const uint32_t count = 1 + p_.below(8);
    std::vector<gphys_vec3> points(count), pixels(count), back(count);
    for (gphys_vec3& point : points) point = p_.point();
    FUZZ_CHECK(call(gphys_camera_project_batch, camera_, points.data(), 12u, count, pixels.data(), 12u) == GPHYS_OK,
               "a batch of valid points is projected");
    for (uint32_t i = 0; i < count; ++i) {
        gphys_vec3 single{INFINITY, INFINITY, INFINITY};
        const gphys_status status = call(gphys_camera_project, camera_, &points[i], &single);
        note(single);
        FUZZ_CHECK(same_bits(single, pixels[i]), "project_batch gives the bits of project");
        FUZZ_CHECK(status != GPHYS_OK || is_valid(single), "an image is in range");
        if (status != GPHYS_OK) pixels[i] = points[i];
    }
    const gphys_status status =
        call(gphys_camera_unproject_batch, camera_, pixels.data(), 12u, count, back.data(), 12u);
    for (uint32_t i = 0; status == GPHYS_OK && i < count; ++i) {
        gphys_vec3 single{INFINITY, INFINITY, INFINITY};
        const gphys_status one = call(gphys_camera_unproject, camera_, &pixels[i], &single);
        note(single);
        FUZZ_CHECK(same_bits(single, back[i]), "unproject_batch gives the bits of unproject");
        FUZZ_CHECK(one != GPHYS_OK || is_valid(single), "an unprojected point is in range");
    }
}

void World::pick() {
    if (!camera_) return create_camera();
    const uint32_t layers = mask(), count = 1 + p_.below(20);
    std::vector<float> pixels(2 * count);
    for (float& pixel : pixels) pixel = static_cast<float>(p_.below(800)) + (p_.one_in(2) ? 0.5f : 0.0f);
    std::vector<gphys_hit> hits(count);
    const gphys_status batch = call(gphys_camera_pick_batch, camera_, scene_, pixels.data(), 8u, count, layers,
                                    hits.data(), uint32_t{sizeof(gphys_hit)});
    for (uint32_t i = 0; i < count; ++i) {
        gphys_hit single{0, 0, INFINITY, {}, {}, GPHYS_NO_TRIANGLE, 0, 0, 0};
        const gphys_status status =
            call(gphys_camera_pick, camera_, scene_, pixels[2 * i], pixels[2 * i + 1], layers, &single);
        note(single);
        FUZZ_CHECK(batch != GPHYS_OK || status < 0 || same_bits(single, hits[i]), "pick_batch gives the bits of pick");
        if (status == GPHYS_OK) {
            const Model* m = model(single.model);
            FUZZ_CHECK(m && (m->layers & layers) && m->tag == single.tag, "a pick names a model that is seen");
        }
        Output<gphys_ray> ray;
        const gphys_status cast = call(gphys_camera_pick_ray, camera_, pixels[2 * i], pixels[2 * i + 1], &ray.value);
        ray.after(cast);
        FUZZ_CHECK(cast != GPHYS_OK || is_valid(ray.value), "a pick ray is valid");
    }
    const uint32_t x = p_.below(50), y = p_.below(50), width = p_.below(6), height = p_.below(6);
    std::vector<gphys_ray> rays(width * height + 1);
    const gphys_status made =
        call(gphys_camera_pick_rays, camera_, x, y, width, height, rays.data(), uint32_t{sizeof(gphys_ray)});
    for (uint32_t i = 0; made == GPHYS_OK && i < width * height; ++i) {
        gphys_ray single{};
        call(gphys_camera_pick_ray, camera_, static_cast<float>(x + i % width) + 0.5f,
             static_cast<float>(y + i / width) + 0.5f, &single);
        FUZZ_CHECK(same_bits(single, rays[i]), "pick_rays gives the bits of pick_ray");
    }
}

void World::pick_lists() {
    if (!camera_) return create_camera();
    const uint32_t layers = mask();
    std::vector<gphys_model_id> marked(64), culled(64);
    uint32_t marked_count = 0, culled_count = 0;
    const gphys_status cull = call(gphys_camera_cull, camera_, scene_, layers, culled.data(), 64u, &culled_count);
    const float x0 = static_cast<float>(p_.below(400)), y0 = static_cast<float>(p_.below(300));
    const float x1 = p_.one_in(6) ? p_.hostile() : x0 + 1 + static_cast<float>(p_.below(400));
    const float y1 = y0 + 1 + static_cast<float>(p_.below(300));
    const gphys_status pick =
        call(gphys_camera_pick_rectangle, camera_, scene_, x0, y0, x1, y1, layers, marked.data(), 64u, &marked_count);
    if (cull != GPHYS_OK || pick != GPHYS_OK) return;
    marked.resize(marked_count);
    culled.resize(culled_count);
    for (const gphys_model_id id : marked) note(id);
    for (const gphys_model_id id : culled) note(id);
    FUZZ_CHECK(std::is_sorted(marked.begin(), marked.end()) && std::is_sorted(culled.begin(), culled.end()),
               "lists are in the order of ids");
    for (const gphys_model_id id : marked)
        FUZZ_CHECK(model(id) && (model(id)->layers & layers), "a marquee names models");
}

}  // namespace fuzz
