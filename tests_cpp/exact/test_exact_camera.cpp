// Pixels, world points, rays and frusta of a camera, beside its own definition in 300 digits.
#include "oracle.h"
#include "score.h"

using namespace test;

namespace {

/// A camera's parameters, as given and in 300 digits.
struct Lens {
    gphys_camera_desc desc;
    bool perspective;
    float fov_or_height, near_distance, far_distance;
    gphys_vec3 position;
    gphys_quat rotation;
    gphys_pick_start start;

    explicit Lens(Cases& c) {
        gphys_camera_desc_init(&desc, sizeof desc);
        desc.handedness = c.one_in(2) ? GPHYS_LEFT_HANDED : GPHYS_RIGHT_HANDED;
        desc.depth_range = c.one_in(2) ? GPHYS_DEPTH_ZERO_TO_ONE : GPHYS_DEPTH_MINUS_ONE_TO_ONE;
        desc.reverse_z = c.one_in(2);
        desc.viewport_width = c.random.uniform_float(100, 4000);
        desc.viewport_height = c.random.uniform_float(100, 4000);
        perspective = !c.one_in(3);
        fov_or_height = perspective ? c.random.uniform_float(.02f, 3.1f)
                                    : static_cast<float>(std::pow(10.0, c.random.uniform(-2, 4)));
        near_distance = static_cast<float>(std::pow(10.0, c.random.uniform(-3, 1)));
        far_distance = near_distance * static_cast<float>(std::pow(10.0, c.random.uniform(.1, 7)));
        if (perspective && c.one_in(3)) far_distance = INFINITY;
        position = narrow(c.random.direction() * std::pow(10.0, c.random.uniform(-2, 7)));
        rotation = c.rotation();
        start = c.one_in(2) ? GPHYS_PICK_FROM_NEAR_PLANE : GPHYS_PICK_FROM_CENTRE;
    }

    gphys_camera* make() const {
        gphys_camera* camera = nullptr;
        REQUIRE(gphys_camera_create(&desc, &camera) == GPHYS_OK);
        REQUIRE((perspective ? gphys_camera_set_perspective : gphys_camera_set_orthographic)(
                    camera, fov_or_height, near_distance, far_distance) == GPHYS_OK);
        REQUIRE(gphys_camera_set_transform(camera, &position, &rotation) == GPHYS_OK);
        REQUIRE(gphys_camera_set_pick_start(camera, start) == GPHYS_OK);
        return camera;
    }

    Big half_height() const { return perspective ? tan(Big(fov_or_height) / 2) : Big(fov_or_height) / 2; }
    Big half_width() const { return half_height() * desc.viewport_width / desc.viewport_height; }
    double sign() const { return desc.handedness == GPHYS_LEFT_HANDED ? 1 : -1; }
    Big depth_of(const Big& near_weight, const Big& far_weight) const {
        const Big low = desc.depth_range == GPHYS_DEPTH_ZERO_TO_ONE ? 0 : -1;
        return desc.reverse_z ? near_weight + far_weight * low : near_weight * low + far_weight;
    }

    /// Right, up, forward of a world point.
    BigVec into(const BigVec& p) const {
        const Rotation r(rotation);
        const BigVec offset = p - BigVec(position);
        const auto along = [&](int k) { return dot(big(CGAL::ORIGIN + r.axis[k]), offset); };
        return {along(0), along(1), along(2) * sign()};
    }
    BigVec out(const BigVec& lens) const {
        const Rotation r(rotation);
        const auto axis = [&](int k) { return big(CGAL::ORIGIN + r.axis[k]); };
        return BigVec(position) + axis(0) * lens.x + axis(1) * lens.y + axis(2) * (lens.z * sign());
    }
    /// False behind the camera.
    bool project(const gphys_vec3& point, BigVec& pixel) const {
        const BigVec p = into(BigVec(point));
        if (perspective && p.z <= 0) return false;
        const Big n = near_distance, scale = perspective ? p.z : Big(1);
        pixel.x = (1 + p.x / (half_width() * scale)) / 2 * desc.viewport_width;
        pixel.y = (1 - p.y / (half_height() * scale)) / 2 * desc.viewport_height;
        const bool endless = std::isinf(far_distance);
        const Big f = endless ? Big(0) : Big(far_distance);
        Big at_near = endless ? n / p.z : (f - p.z) / (f - n);
        if (perspective && !endless) at_near = at_near * n / p.z;
        pixel.z = depth_of(at_near, 1 - at_near);
        return true;
    }
    bool starts_near() const { return !perspective || start == GPHYS_PICK_FROM_NEAR_PLANE; }
    /// Where the line of sight of a pixel starts in the world.
    BigVec start_of_sight(double x, double y) const {
        if (!starts_near()) return BigVec(position);
        if (perspective) return out(direction(x, y) * Big(near_distance));
        return out({(2 * Big(x) / desc.viewport_width - 1) * half_width(),
                    (1 - 2 * Big(y) / desc.viewport_height) * half_height(), near_distance});
    }
    BigVec direction(double x, double y) const {
        if (!perspective) return {0, 0, 1};
        return {(2 * Big(x) / desc.viewport_width - 1) * half_width(),
                (1 - 2 * Big(y) / desc.viewport_height) * half_height(), 1};
    }
};

gphys_vec3 seen_point(Cases& c, const Lens& lens) {
    const double depth = lens.near_distance * std::pow(10.0, c.random.uniform(0, 6));
    const Vec3 offset{depth * c.random.uniform(-1, 1), depth * c.random.uniform(-1, 1), depth * lens.sign()};
    return narrow(widen(lens.position) + rotation_matrix(widen(lens.rotation)) * offset);
}

using Project = gphys_status (*)(const gphys_camera*, const gphys_vec3*, gphys_vec3*);

gphys_status shifted(const gphys_camera* camera, const gphys_vec3* point, gphys_vec3* pixel) {
    const gphys_status status = gphys_camera_project(camera, point, pixel);
    pixel->x += .01f;
    return status;
}
/// As a matrix of floats does it.
gphys_status by_matrix(const gphys_camera* camera, const gphys_vec3* p, gphys_vec3* pixel) {
    const gphys_status status = gphys_camera_project(camera, p, pixel);
    gphys_mat4 m;
    gphys_camera_get_view_projection_matrix(camera, &m);
    const auto row = [&](int r) { return m.m[r] * p->x + m.m[4 + r] * p->y + m.m[8 + r] * p->z + m.m[12 + r]; };
    pixel->z = row(2) / row(3);
    return status;
}

using Cast = gphys_status (*)(const gphys_camera*, float, float, gphys_ray*);
gphys_status turned(const gphys_camera* camera, float x, float y, gphys_ray* ray) {
    return gphys_camera_pick_ray(camera, x + .01f, y, ray);
}

}  // namespace

TEST_CASE("a camera projects to a thousandth of a pixel and 4 ulps of depth", "[camera]") {
    const auto examine = [](Project project, long count) {
        Cases c(81);
        Score score("project", 1, "of the bound");
        for (long i = 0; i < count; ++i) {
            const Lens lens(c);
            gphys_camera* camera = lens.make();
            const gphys_vec3 point = c.one_in(3) ? c.point() : seen_point(c, lens);
            gphys_vec3 pixel{};
            BigVec expected;
            const bool given = project(camera, &point, &pixel) == GPHYS_OK;
            const bool in_front = lens.project(point, expected);
            // Beyond the range of coordinates there is no answer either.
            const double furthest =
                in_front ? std::max(std::fabs(rounded(expected.x)), std::fabs(rounded(expected.y))) : 0;
            score.answer(given, in_front, !in_front || furthest > 1e14, point, lens.position, lens.rotation);
            if (given && in_front && furthest < 1e14) {
                const auto error = [&](float computed, const Big& truth, double bound) {
                    score.error(error_of(computed, truth) / (bound + ulp_of(rounded(truth))), point, lens.position,
                                lens.rotation, lens.fov_or_height);
                };
                error(pixel.x, expected.x, 1e-3);
                error(pixel.y, expected.y, 1e-3);
                error(pixel.z, expected.z, 4 * 0x1p-24);
            }
            gphys_camera_destroy(camera);
            c.next();
        }
        return score;
    };
    prove(cases(2000, 1000000), examine, gphys_camera_project, shifted, by_matrix);
}

TEST_CASE("a camera unprojects to an ulp of the largest coordinate", "[camera]") {
    const auto examine = [](Project unproject, long count) {
        Cases c(82);
        Score score("unproject", 2, "ulps of W");
        for (long i = 0; i < count; ++i) {
            const Lens lens(c);
            gphys_camera* camera = lens.make();
            // A pixel and depth that some point has.
            const gphys_vec3 seen = seen_point(c, lens);
            gphys_vec3 pixel, point{};
            if (gphys_camera_project(camera, &seen, &pixel) == GPHYS_OK) {
                const bool given = unproject(camera, &pixel, &point) == GPHYS_OK;
                // The depth of that pixel, from the same linear weights.
                const Big at_low =
                    lens.desc.depth_range == GPHYS_DEPTH_ZERO_TO_ONE ? Big(pixel.z) : (Big(pixel.z) + 1) / 2;
                const Big far_weight = lens.desc.reverse_z ? 1 - at_low : at_low, near_weight = 1 - far_weight;
                const Big n = lens.near_distance;
                const bool endless = std::isinf(lens.far_distance);
                const Big f = endless ? Big(0) : Big(lens.far_distance);
                Big z;
                bool finite = true;
                if (!lens.perspective) {
                    z = n * near_weight + f * far_weight;
                } else {
                    const Big inverse = near_weight / n + (endless ? Big(0) : far_weight / f);
                    finite = inverse > 0;
                    if (finite) z = 1 / inverse;
                }
                score.answer(given, finite, !finite || z > 1e14, pixel, lens.position);
                if (given && finite) {
                    BigVec on_lens = lens.direction(pixel.x, pixel.y) * z;
                    if (!lens.perspective) {
                        on_lens.x = (2 * Big(pixel.x) / lens.desc.viewport_width - 1) * lens.half_width();
                        on_lens.y = (1 - 2 * Big(pixel.y) / lens.desc.viewport_height) * lens.half_height();
                    }
                    const BigVec expected = lens.out(on_lens);
                    const double unit = ulp_of(std::max(largest(widen(lens.position)), largest(widen(point))));
                    score.error(error_of(point.x, expected.x) / unit, pixel, lens.position);
                    score.error(error_of(point.y, expected.y) / unit, pixel, lens.position);
                    score.error(error_of(point.z, expected.z) / unit, pixel, lens.position);
                }
            }
            gphys_camera_destroy(camera);
            c.next();
        }
        return score;
    };
    const Project off = [](const gphys_camera* camera, const gphys_vec3* pixel, gphys_vec3* point) {
        const gphys_status status = gphys_camera_unproject(camera, pixel, point);
        for (int i = 0; i < 3; ++i) point->z = after(point->z);
        return status;
    };
    const Score score = examine(gphys_camera_unproject, cases(2000, 1000000));
    score.print();
    CHECK(score.kept());
    CHECK_FALSE(examine(off, 2000).kept());
}

TEST_CASE("the ray of a pixel has its image there, to a thousandth of a pixel or what its floats tell", "[camera]") {
    const auto examine = [](Cast cast, long count) {
        Cases c(83);
        Score score("pick ray", 1, "of the bound");
        for (long i = 0; i < count; ++i) {
            const Lens lens(c);
            gphys_camera* camera = lens.make();
            const float x = c.random.uniform_float(0, lens.desc.viewport_width);
            const float y = c.random.uniform_float(0, lens.desc.viewport_height);
            gphys_ray ray{};
            score.answer(cast(camera, x, y, &ray) == GPHYS_OK, true, lens.position);
            // Where it starts is rounded once: half an ulp, and what doubles of the size of the position lose.
            const BigVec from = lens.start_of_sight(x, y);
            const BigVec offset = from - BigVec(lens.position);
            const double lost = 0x1p-50 * (largest(widen(lens.position)) + rounded(sqrt(dot(offset, offset))));
            const float coordinates[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
            const Big expected[3] = {from.x, from.y, from.z};
            for (int k = 0; k < 3; ++k) {
                const double bound = .5 * ulp_of(coordinates[k]) + lost;
                score.error(error_of(coordinates[k], expected[k]) / bound, lens.position, lens.rotation);
            }
            if (lens.perspective) {
                // The image of the direction.
                const Rotation r(lens.rotation);
                const BigVec d(ray.direction);
                const auto along = [&](int k) { return dot(big(CGAL::ORIGIN + r.axis[k]), d); };
                const Big z = along(2) * lens.sign();
                const Big px = (1 + along(0) / (lens.half_width() * z)) / 2 * lens.desc.viewport_width;
                const Big py = (1 - along(1) / (lens.half_height() * z)) / 2 * lens.desc.viewport_height;
                // Half an ulp of each component of a unit vector turns it by at most 2^-25 sqrt(3); the image
                // moves by what its scale there makes of that.
                const double scale = rounded(lens.desc.viewport_height / 2 / lens.half_height());
                const double stretch = rounded(dot(lens.direction(x, y), lens.direction(x, y)));
                const double bound = std::max(1e-3, 0x1p-24 * scale * stretch);
                score.error(error_of(x, px) / bound, lens.position, lens.rotation);
                score.error(error_of(y, py) / bound, lens.position, lens.rotation);
            }
            gphys_camera_destroy(camera);
            c.next();
        }
        return score;
    };
    const Score score = examine(gphys_camera_pick_ray, cases(2000, 1000000));
    score.print();
    CHECK(score.kept());
    CHECK_FALSE(examine(turned, 2000).kept());
}

namespace {

/// A ray in 300 digits and how it meets a triangle.
struct Sight {
    BigVec from, along;  // along: unit
    Big length;          // to the far plane
    double slack = 0;    // of where it starts: a near plane's point is rounded
    bool endless;

    Sight(const Lens& lens, double x, double y) : endless(std::isinf(lens.far_distance)) {
        const BigVec zero(0, 0, 0), way = lens.direction(x, y);
        const Big size = sqrt(dot(way, way));
        from = lens.start_of_sight(x, y);
        const BigVec start = from - BigVec(lens.position);
        if (lens.starts_near()) slack = 0x1p-50 * (largest(widen(lens.position)) + rounded(sqrt(dot(start, start))));
        along = (lens.out(way) - lens.out(zero)) * (1 / size);
        if (!endless) length = (Big(lens.far_distance) - (lens.starts_near() ? lens.near_distance : 0)) * size;
    }
};

struct Sighting {
    bool may_be = false, must_be = false;
    Big t = 0;
    double slack = 0;  // of t
};

/// The direction of a double ray is off by a few 2^-53; what it passes by at an angle of less than
/// 2^-46, or nearer than its start is off, may be hit or not, and t is off by as much over the cosine.
Sighting sighting(const Sight& sight, const gphys_triangle& triangle) {
    const BigVec corner[3] = {BigVec(triangle.a) - sight.from, BigVec(triangle.b) - sight.from,
                              BigVec(triangle.c) - sight.from};
    bool positive = false, negative = false, clear = true;
    for (int i = 0; i < 3; ++i) {
        const BigVec normal = cross(corner[i], corner[(i + 1) % 3]);
        const Big volume = dot(sight.along, normal), size = sqrt(dot(normal, normal));
        // Twice the area over the edge is how far the edge's line is from the start.
        const BigVec edge = corner[(i + 1) % 3] - corner[i];
        if (abs(volume) <= size * Big(0x1p-46) + sqrt(dot(edge, edge)) * Big(sight.slack)) {
            clear = false;
        } else {
            (volume > 0 ? positive : negative) = true;
        }
    }
    const BigVec normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const Big climb = dot(normal, sight.along), size = sqrt(dot(normal, normal));
    Sighting result;
    if (positive && negative) return result;
    if (abs(climb) <= size * Big(0x1p-20)) {  // seen from the side, or degenerate: not examined
        result.may_be = true;
        result.slack = INFINITY;
        return result;
    }
    result.t = dot(normal, corner[0]) / climb;
    result.slack = (std::fabs(rounded(result.t)) * 0x1p-46 + sight.slack) * rounded(size / abs(climb));
    const Big slack = result.slack;
    result.may_be = result.t >= -slack && (sight.endless || result.t <= sight.length + slack);
    result.must_be = clear && result.t >= slack && (sight.endless || result.t <= sight.length - slack);
    return result;
}

/// Asks for what a pixel shows: the tag of a model, or the triangle of a mesh.
using Pick = gphys_status (*)(const gphys_camera*, const gphys_scene*, float, float, uint32_t, gphys_hit*);

gphys_status pick_beside(const gphys_camera* camera, const gphys_scene* scene, float x, float y, uint32_t layers,
                         gphys_hit* hit) {
    return gphys_camera_pick(camera, scene, x + .01f, y, layers, hit);
}
gphys_status pick_by_floats(const gphys_camera* camera, const gphys_scene* scene, float x, float y, uint32_t layers,
                            gphys_hit* hit) {
    gphys_ray ray;
    gphys_camera_pick_ray(camera, x, y, &ray);
    return gphys_scene_raycast(scene, &ray, layers, hit);
}

constexpr uint32_t seen_count = 6;

/// Triangles near each other, behind or beside one another, as models or as one mesh.
gphys_scene* scene_of(const gphys_triangle (&triangles)[seen_count], bool as_mesh) {
    gphys_scene* scene = nullptr;
    REQUIRE(gphys_scene_create(nullptr, &scene) == GPHYS_OK);
    gphys_model_id model = 0;
    if (as_mesh) {
        uint32_t indices[3 * seen_count];
        for (uint32_t i = 0; i < 3 * seen_count; ++i) indices[i] = i;
        gphys_mesh* mesh = nullptr;
        REQUIRE(gphys_mesh_create(nullptr, &triangles[0].a.x, sizeof(gphys_vec3), 3 * seen_count, indices,
                                  3 * seen_count, &mesh) == GPHYS_OK);
        REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, nullptr, nullptr, &model) == GPHYS_OK);
        gphys_mesh_destroy(mesh);
        return scene;
    }
    for (uint32_t i = 0; i < seen_count; ++i) {
        REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_TRIANGLE, &triangles[i], nullptr, nullptr, &model) == GPHYS_OK);
        REQUIRE(gphys_scene_set_tag(scene, model, i) == GPHYS_OK);
    }
    return scene;
}

}  // namespace

TEST_CASE("a pixel shows the model, and of a mesh the triangle, that the exact line of sight meets first", "[camera]") {
    const auto examine = [](Pick pick, long count) {
        Cases c(84);
        Score score("pick", 1, "of 1 ulp of t and its band");
        for (long i = 0; i < count; ++i) {
            const Lens lens(c);
            gphys_camera* camera = lens.make();
            gphys_triangle triangles[seen_count];
            const Vec3 middle = widen(seen_point(c, lens));
            const double size = length(middle - widen(lens.position)) * std::pow(10.0, c.random.uniform(-3, 0));
            const gphys_triangle* last = nullptr;
            for (gphys_triangle& t : triangles) {
                for (gphys_vec3* corner : {&t.a, &t.b, &t.c}) {
                    *corner = narrow(middle + c.random.direction() * (size * c.random.uniform(.1, 1)));
                }
                if (last && c.one_in(2)) t.a = last->b, t.b = last->a;  // a shared edge
                last = &t;
            }
            const bool as_mesh = c.one_in(2);
            gphys_scene* scene = scene_of(triangles, as_mesh);
            const gphys_vec3 target = target_on(c, triangles[c.random.index(seen_count)]);
            gphys_vec3 pixel;
            if (gphys_camera_project(camera, &target, &pixel) == GPHYS_OK) {
                gphys_hit hit{};
                const bool given = pick(camera, scene, pixel.x, pixel.y, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK;
                const uint32_t found = as_mesh ? hit.triangle : hit.tag;
                const Sight sight(lens, pixel.x, pixel.y);
                Sighting sightings[seen_count];
                // No later than this something is met for certain, and the triangle that is.
                Big latest = -1;
                uint32_t first = 0;
                for (uint32_t k = 0; k < seen_count; ++k) {
                    sightings[k] = sighting(sight, triangles[k]);
                    const Big end = sightings[k].t + Big(sightings[k].must_be ? sightings[k].slack : 0);
                    if (sightings[k].must_be && (latest < 0 || end < latest)) latest = end, first = k;
                }
                bool right = !given && latest < 0;
                if (given && found < seen_count) {
                    const Sighting& s = sightings[found];
                    const bool examined = !std::isinf(s.slack);
                    // Of those that are reported at the same float the lowest is the answer.
                    const Big tie = found < first ? Big(ulp_of(rounded(latest))) : Big(0);
                    right = s.may_be && (!examined || latest < 0 || s.t - Big(s.slack) <= latest + tie);
                    if (right && examined) {
                        score.error(error_of(hit.t, s.t) / (ulp_of(rounded(s.t)) + s.slack), lens.position, pixel);
                    }
                }
                score.answer(given, right == given, lens.position, lens.rotation, pixel, triangles);
            }
            gphys_scene_destroy(scene);
            gphys_camera_destroy(camera);
            c.next();
        }
        return score;
    };
    prove(cases(1500, 1000000), examine, gphys_camera_pick, pick_beside, pick_by_floats);
}
