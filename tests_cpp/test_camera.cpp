#include "camera/camera.h"

#include <vector>

#include "test.h"

using namespace gphys;

namespace {

// The reference: the same questions in long double, from the floats that the camera was given.

struct Wide {
    long double x = 0, y = 0, z = 0;
};

Wide operator+(Wide a, Wide b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Wide operator-(Wide a, Wide b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Wide operator*(Wide a, long double s) { return {a.x * s, a.y * s, a.z * s}; }
long double dot(Wide a, Wide b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Wide cross(Wide a, Wide b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Wide unit(Wide a) { return a * (1 / std::sqrt(dot(a, a))); }
Wide wide(gphys_vec3 v) { return {v.x, v.y, v.z}; }

/// Rotation of v by the direction of q.
Wide rotated(gphys_quat q, Wide v) {
    const Wide u{q.x, q.y, q.z};
    const long double w = q.w, norm = dot(u, u) + w * w;
    return (u * (2 * dot(u, v)) + v * (w * w - dot(u, u)) + cross(u, v) * (2 * w)) * (1 / norm);
}

struct Pose {
    gphys_vec3 position{};
    gphys_quat rotation{0, 0, 0, 1};
    gphys_handedness handedness = GPHYS_LEFT_HANDED;

    Wide right() const { return rotated(rotation, {1, 0, 0}); }
    Wide up() const { return rotated(rotation, {0, 1, 0}); }
    Wide forward() const { return rotated(rotation, {0, 0, handedness == GPHYS_LEFT_HANDED ? 1.0L : -1.0L}); }
    Wide world(long double x, long double y, long double z) const {
        return wide(position) + right() * x + up() * y + forward() * z;
    }
};

gphys_camera_desc described(gphys_handedness handedness = GPHYS_LEFT_HANDED,
                            gphys_depth_range depth_range = GPHYS_DEPTH_ZERO_TO_ONE, bool reverse_z = false,
                            float width = 800, float height = 600) {
    gphys_camera_desc desc{};
    desc.handedness = handedness;
    desc.depth_range = depth_range;
    desc.reverse_z = reverse_z;
    desc.viewport_width = width;
    desc.viewport_height = height;
    return desc;
}

Camera placed(const Pose& pose, gphys_camera_desc desc) {
    desc.handedness = pose.handedness;
    Camera camera(nullptr, desc);
    camera.set_transform(widen(pose.position), rotation_matrix(widen(pose.rotation)));
    return camera;
}

Pose random_pose(test::Random& random, float extent) {
    return {random.point(extent), random.rotation(), random.index(2) ? GPHYS_RIGHT_HANDED : GPHYS_LEFT_HANDED};
}

/// |value - reference| in ulps of float at `size`. Below 2^-26 a component is what cancellation
/// left of terms near 1, which double precision carries to 2^-52: there the ulp is that of 2^-26.
double ulps(float value, long double reference, long double size) {
    const double magnitude = std::max(std::fabs(static_cast<double>(size)), 0x1p-26);
    return std::fabs(static_cast<double>(value - reference)) / std::ldexp(1.0, std::ilogb(magnitude) - 23);
}

/// Rows of a view or projection matrix as textbooks print them.
Mat4 rows(std::initializer_list<double> elements) {
    Mat4 m;
    int i = 0;
    for (double element : elements) {
        m(i / 4, i % 4) = element;
        ++i;
    }
    return m;
}

void require_matrix(const Mat4& a, const Mat4& b, double tolerance) {
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            INFO("row " << row << ", column " << column << ": " << a(row, column) << " against " << b(row, column));
            REQUIRE(std::fabs(a(row, column) - b(row, column)) <= tolerance * std::max(1.0, std::fabs(b(row, column))));
        }
    }
}

}  // namespace

TEST_CASE("a look-at view is the hand-computed one") {
    // From (1, 2, 3) along +Z with +Y up. Left-handed: right is +X, forward is z.
    Camera left(nullptr, described(GPHYS_LEFT_HANDED));
    left.look_at({1, 2, 3}, {1, 2, 13}, {0, 1, 0});
    require_matrix(left.view_matrix(), rows({1, 0, 0, -1, 0, 1, 0, -2, 0, 0, 1, -3, 0, 0, 0, 1}), 0);
    // Right-handed: right is -X, and z points back, along -Z.
    Camera right(nullptr, described(GPHYS_RIGHT_HANDED));
    right.look_at({1, 2, 3}, {1, 2, 13}, {0, 1, 0});
    require_matrix(right.view_matrix(), rows({-1, 0, 0, 1, 0, 1, 0, -2, 0, 0, -1, 3, 0, 0, 0, 1}), 0);
    // Along -Z, as OpenGL's default: right is +X.
    right.look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
    require_matrix(right.view_matrix(), rows({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -5, 0, 0, 0, 1}), 0);
}

TEST_CASE("a look-at view is the textbook's: D3DXMatrixLookAtLH, D3DXMatrixLookAtRH and gluLookAt") {
    test::Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const gphys_vec3 eye = random.point(100), target = random.point(100), up = narrow(random.direction());
        for (gphys_handedness handedness : {GPHYS_LEFT_HANDED, GPHYS_RIGHT_HANDED}) {
            Camera camera(nullptr, described(handedness));
            camera.look_at(widen(eye), widen(target), widen(up));
            // zaxis = normal(at - eye) or normal(eye - at); xaxis = normal(cross(up, zaxis)).
            const Wide z = unit(handedness == GPHYS_LEFT_HANDED ? wide(target) - wide(eye) : wide(eye) - wide(target));
            const Wide x = unit(cross(wide(up), z)), y = cross(z, x);
            Mat4 textbook;
            const Wide axes[3] = {x, y, z};
            for (int row = 0; row < 3; ++row) {
                textbook(row, 0) = static_cast<double>(axes[row].x);
                textbook(row, 1) = static_cast<double>(axes[row].y);
                textbook(row, 2) = static_cast<double>(axes[row].z);
                textbook(row, 3) = static_cast<double>(-dot(axes[row], wide(eye)));
            }
            textbook(3, 3) = 1;
            // Errors of 2^-52 grow by the 170 metres to the eye, and by the inverse of the angle between
            // up and view, which is at least 0.03 in these.
            require_matrix(camera.view_matrix(), textbook, 1e-11);
        }
    }
}

TEST_CASE("looking straight down or up gives an orthonormal view, always the same") {
    // The book's was NaN.
    test::Random random(2);
    for (gphys_handedness handedness : {GPHYS_LEFT_HANDED, GPHYS_RIGHT_HANDED}) {
        for (int i = 0; i < 1000; ++i) {
            const gphys_vec3 direction = i < 2 ? gphys_vec3{0, i ? 1.0f : -1.0f, 0} : narrow(random.direction());
            const Vec3 eye = i < 2 ? Vec3{1, 5, 2} : Vec3{};
            Camera camera(nullptr, described(handedness)), again(nullptr, described(handedness));
            // Exactly parallel, opposite, and off by what rounds away.
            for (Vec3 up : {widen(direction), widen(direction) * -3, widen(direction) + Vec3{1e-17, 0, 0}}) {
                camera.look_at(eye, eye + widen(direction) * 2, up);
                again.look_at(eye, eye + widen(direction) * 2, up);
                const Mat3 axes = camera.rotation();
                REQUIRE(distance(cross(axes.x, axes.y), axes.z) < 1e-15);
                REQUIRE(std::fabs(length(axes.x) - 1) < 1e-15);
                REQUIRE(std::fabs(length(axes.y) - 1) < 1e-15);
                const Vec3 forward = axes.z * (handedness == GPHYS_LEFT_HANDED ? 1 : -1);
                REQUIRE(distance(forward, normalized(widen(direction))) < 1e-15);
                REQUIRE((axes.x == again.rotation().x && axes.y == again.rotation().y));
            }
        }
    }
}

TEST_CASE("an up vector close to the view still decides, and the view stays orthonormal") {
    for (double angle = 1e-3; angle > 1e-14; angle /= 3) {
        Camera camera(nullptr, described());
        camera.look_at({}, {0, 0, 1}, {0, angle, 1});
        const Mat3 axes = camera.rotation();
        REQUIRE(distance(axes.y, {0, 1, 0}) < 1e-15);
        REQUIRE(distance(axes.x, {1, 0, 0}) < 1e-15);
        camera.look_at({}, {0.6, 0, 0.8}, {0.6, angle, 0.8});
        REQUIRE(std::fabs(dot(camera.rotation().y, camera.rotation().z)) < 1e-15);
        REQUIRE(distance(camera.rotation().y, {0, 1, 0}) < 4e-16 / angle);
    }
}

TEST_CASE("a rotation given is the rotation kept, and its matrix is proper in either handedness") {
    test::Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const Pose pose = random_pose(random, 1000);
        const Camera camera = placed(pose, described());
        const Mat3 given = rotation_matrix(widen(pose.rotation)), kept = camera.rotation();
        REQUIRE((given.x == kept.x && given.y == kept.y && given.z == kept.z));
        REQUIRE(distance(cross(kept.x, kept.y), kept.z) < 1e-15);
        REQUIRE(camera.position() == widen(pose.position));
        require_matrix(camera.view_matrix() * camera.world_matrix(),
                       rows({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}), 1e-12);
    }
}

TEST_CASE("projection matrices are the textbooks' in every convention") {
    const float fov = 1.1f, n = 0.25f, f = 300;
    const double y = 1 / std::tan(fov / 2.0), x = y * 600 / 800;
    const double w = 2.0 / (10 * 800.0 / 600), h = 2.0 / 10;
    // D3DXMatrixPerspectiveFovLH/RH and OrthoLH/RH; gluPerspective and glOrtho for right-handed -1..1
    // and the same with z negated for left-handed. Reverse-Z exchanges n and f.
    for (int reverse_z : {0, 1}) {
        const double zn = reverse_z ? f : n, zf = reverse_z ? n : f;
        const auto matrices = [&](gphys_handedness handedness, gphys_depth_range range, bool endless) {
            Camera camera(nullptr, described(handedness, range, reverse_z));
            camera.set_perspective(fov, n, endless ? INFINITY : f);
            const Mat4 perspective = camera.projection_matrix();
            camera.set_orthographic(10, n, f);
            return std::pair<Mat4, Mat4>{perspective, camera.projection_matrix()};
        };
        const auto require_both = [](std::pair<Mat4, Mat4> both, const Mat4& perspective, const Mat4& orthographic) {
            require_matrix(both.first, perspective, 1e-15);
            require_matrix(both.second, orthographic, 1e-15);
        };
        require_both(matrices(GPHYS_LEFT_HANDED, GPHYS_DEPTH_ZERO_TO_ONE, false),
                     rows({x, 0, 0, 0, 0, y, 0, 0, 0, 0, zf / (zf - zn), -zn * zf / (zf - zn), 0, 0, 1, 0}),
                     rows({w, 0, 0, 0, 0, h, 0, 0, 0, 0, 1 / (zf - zn), -zn / (zf - zn), 0, 0, 0, 1}));
        require_both(matrices(GPHYS_RIGHT_HANDED, GPHYS_DEPTH_ZERO_TO_ONE, false),
                     rows({x, 0, 0, 0, 0, y, 0, 0, 0, 0, zf / (zn - zf), zn * zf / (zn - zf), 0, 0, -1, 0}),
                     rows({w, 0, 0, 0, 0, h, 0, 0, 0, 0, 1 / (zn - zf), zn / (zn - zf), 0, 0, 0, 1}));
        require_both(
            matrices(GPHYS_RIGHT_HANDED, GPHYS_DEPTH_MINUS_ONE_TO_ONE, false),
            rows({x, 0, 0, 0, 0, y, 0, 0, 0, 0, -(zf + zn) / (zf - zn), -2 * zf * zn / (zf - zn), 0, 0, -1, 0}),
            rows({w, 0, 0, 0, 0, h, 0, 0, 0, 0, -2 / (zf - zn), -(zf + zn) / (zf - zn), 0, 0, 0, 1}));
        require_both(matrices(GPHYS_LEFT_HANDED, GPHYS_DEPTH_MINUS_ONE_TO_ONE, false),
                     rows({x, 0, 0, 0, 0, y, 0, 0, 0, 0, (zf + zn) / (zf - zn), -2 * zf * zn / (zf - zn), 0, 0, 1, 0}),
                     rows({w, 0, 0, 0, 0, h, 0, 0, 0, 0, 2 / (zf - zn), -(zf + zn) / (zf - zn), 0, 0, 0, 1}));
        // The limits for f without bound (Upchurch and Desbrun 2012).
        const double a = reverse_z ? 0 : 1, b = reverse_z ? n : -n, c = reverse_z ? -1 : 1;
        require_matrix(matrices(GPHYS_LEFT_HANDED, GPHYS_DEPTH_ZERO_TO_ONE, true).first,
                       rows({x, 0, 0, 0, 0, y, 0, 0, 0, 0, a, b, 0, 0, 1, 0}), 1e-15);
        require_matrix(matrices(GPHYS_RIGHT_HANDED, GPHYS_DEPTH_MINUS_ONE_TO_ONE, true).first,
                       rows({x, 0, 0, 0, 0, y, 0, 0, 0, 0, -c, -2 * c * n, 0, 0, -1, 0}), 1e-15);
    }
}

TEST_CASE("the view-projection matrix takes points to where project says") {
    test::Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const Pose pose = random_pose(random, 100);
        Camera camera = placed(pose, described(pose.handedness, i & 1, i & 2));
        if (i & 4) camera.set_orthographic(20, 0.1f, 100);
        const Mat4 view_projection = camera.view_projection_matrix();
        const Vec3 p = widen(random.point(100));
        const Vec4 clip = view_projection * Vec4{p.x, p.y, p.z, 1};
        Vec3 pixel;
        REQUIRE(camera.project(p, pixel) == (clip.w > 0));
        if (clip.w < 1e-3) continue;
        REQUIRE(std::fabs(pixel.x - (1 + clip.x / clip.w) * 400) < 1e-6);
        REQUIRE(std::fabs(pixel.y - (1 - clip.y / clip.w) * 300) < 1e-6);
        REQUIRE(std::fabs(pixel.z - clip.z / clip.w) < 1e-9);
    }
}

TEST_CASE("project, unproject and pick ray hold 1e-3 pixel at any distance from the origin") {
    struct Lens {
        float fov, n, f;
    };
    test::Random random(5);
    const float width = 1920, height = 1080;
    double worst_pixel = 0, worst_ray = 0, worst_depth = 0;
    for (const Lens& lens :
         {Lens{1, 1e-3f, 1e6f}, Lens{1, 1e-3f, INFINITY}, Lens{2.5f, 0.1f, 100}, Lens{0.2f, 0.01f, 1e4f}}) {
        const long double tangent = std::tan(static_cast<long double>(lens.fov) / 2);
        for (float extent : {0.0f, 1.0f, 1e3f, 1e5f, 1e7f}) {
            for (int i = 0; i < 500; ++i) {
                const Pose pose = random_pose(random, extent);
                Camera camera = placed(pose, described(pose.handedness, GPHYS_DEPTH_ZERO_TO_ONE, true, width, height));
                camera.set_perspective(lens.fov, lens.n, lens.f);
                // A float point somewhere in view, and where its image really is.
                const long double z = lens.n * std::pow(10.0L, random.uniform(0, 6));
                const long double spread = z * tangent;
                const Wide ideal =
                    pose.world(spread * width / height * random.uniform(-1, 1), spread * random.uniform(-1, 1), z);
                const gphys_vec3 point{static_cast<float>(ideal.x), static_cast<float>(ideal.y),
                                       static_cast<float>(ideal.z)};
                const Wide offset = wide(point) - wide(pose.position);
                const long double depth = dot(offset, pose.forward());
                const long double x = dot(offset, pose.right()) / (depth * tangent * width / height);
                const long double y = dot(offset, pose.up()) / (depth * tangent);
                // Rounding the point to float may have thrown it out of view.
                if (depth < lens.n || depth > lens.f || std::fabs(x) > 1 || std::fabs(y) > 1) continue;
                Vec3 pixel;
                REQUIRE(camera.project(widen(point), pixel));
                const gphys_vec3 out = narrow(pixel);
                worst_pixel = std::max(worst_pixel, static_cast<double>(std::fabs(out.x - (1 + x) / 2 * width)));
                worst_pixel = std::max(worst_pixel, static_cast<double>(std::fabs(out.y - (1 - y) / 2 * height)));
                const long double n = lens.n, f = lens.f;
                const long double expected = lens.f == INFINITY ? n / depth : n / depth * ((f - depth) / (f - n));
                worst_depth = std::max(worst_depth, std::fabs(static_cast<double>(out.z - expected)));

                Vec3 back;
                REQUIRE(camera.unproject(pixel, back));
                // The way there and back in double: 2^-53 of the point's size and of its distance, and
                // what depth cannot tell: for a far plane, steps of 2^-53 in a depth that ends at 0.
                REQUIRE(distance(back, widen(point)) <= 1e-14 * (extent + static_cast<double>(depth)) *
                                                            (1 + 1e-3 * static_cast<double>(depth / lens.n)));

                Ray ray;
                REQUIRE(camera.pick_ray(pixel.x, pixel.y, ray));
                // It starts on the near plane, but for the rounding of a double of the size of the position.
                const Wide start{static_cast<long double>(ray.origin.x) - pose.position.x,
                                 static_cast<long double>(ray.origin.y) - pose.position.y,
                                 static_cast<long double>(ray.origin.z) - pose.position.z};
                const double slack = 0x1p-51 * (extent + lens.n * 4);
                REQUIRE(std::fabs(static_cast<double>(dot(start, pose.forward()) - lens.n)) <= slack);
                const Wide across = start - unit(Wide{ray.direction.x, ray.direction.y, ray.direction.z}) *
                                                std::sqrt(dot(start, start));
                REQUIRE(static_cast<double>(std::sqrt(dot(across, across))) <= 2 * slack);
                camera.set_pick_start(GPHYS_PICK_FROM_CENTRE);
                Ray from_centre;
                REQUIRE(camera.pick_ray(pixel.x, pixel.y, from_centre));
                REQUIRE(from_centre.origin == widen(pose.position));
                REQUIRE(from_centre.direction == ray.direction);
                const double before = static_cast<double>(std::sqrt(dot(start, start)));
                REQUIRE((lens.f == INFINITY
                             ? ray.t_max == infinity && from_centre.t_max == infinity
                             : std::fabs(from_centre.t_max - before - ray.t_max) <= slack + 1e-15 * from_centre.t_max));
                camera.set_pick_start(GPHYS_PICK_FROM_NEAR_PLANE);
                const Vec3 direction = widen(narrow(ray.direction));
                const Wide wide_direction{direction.x, direction.y, direction.z};
                const long double ahead = dot(wide_direction, pose.forward());
                const long double ray_x = dot(wide_direction, pose.right()) / (ahead * tangent * width / height);
                const long double ray_y = dot(wide_direction, pose.up()) / (ahead * tangent);
                worst_ray = std::max(worst_ray, static_cast<double>(std::fabs(ray_x - x) / 2 * width));
                worst_ray = std::max(worst_ray, static_cast<double>(std::fabs(ray_y - y) / 2 * height));
            }
        }
    }
    INFO("pixel " << worst_pixel << ", pick ray " << worst_ray << ", reverse-Z depth " << worst_depth);
    // A float pixel up to 1920 is rounded by 6e-5; the float direction of the narrowest lens above
    // by 2^-25 * 3^0.5 * 5400 pixels per radian.
    CHECK(worst_pixel < 1e-3);
    CHECK(worst_ray < 1e-3);
    CHECK(worst_depth < 4 * 0x1p-24);
}

TEST_CASE("frustum planes are within 2 ulp of the exact ones") {
    test::Random random(6);
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
        const Pose pose = random_pose(random, i % 2 ? 1e7f : 10);
        Camera camera = placed(pose, described(pose.handedness, i & 1, i & 2, 1920, 1080));
        const float fov = random.uniform_float(0.1f, 3), n = random.uniform_float(1e-3f, 1);
        const float f = i % 3 == 0 ? INFINITY : random.uniform_float(10, 1e6f);
        camera.set_perspective(fov, n, f);
        const Frustum seen = camera.frustum();
        REQUIRE(seen.origin == widen(pose.position));
        const long double tangent_y = std::tan(static_cast<long double>(fov) / 2), tangent_x = tangent_y * 16 / 9;
        const Wide right = pose.right(), up = pose.up(), forward = pose.forward();
        const Wide normals[6] = {forward,
                                 f == INFINITY ? Wide{} : forward * -1,
                                 unit(right + forward * tangent_x),
                                 unit(right * -1 + forward * tangent_x),
                                 unit(up + forward * tangent_y),
                                 unit(up * -1 + forward * tangent_y)};
        const float distances[6] = {n, f == INFINITY ? -1 : -f, 0, 0, 0, 0};
        for (int k = 0; k < 6; ++k) {
            const gphys_vec3 normal = narrow(seen.planes[k].normal);
            worst = std::max({worst, ulps(normal.x, normals[k].x, normals[k].x),
                              ulps(normal.y, normals[k].y, normals[k].y), ulps(normal.z, normals[k].z, normals[k].z)});
            REQUIRE(seen.planes[k].distance == distances[k]);
        }
    }
    INFO(worst);
    CHECK(worst <= 2);
}

TEST_CASE("frustum corners are within 2 ulp of the exact ones") {
    test::Random random(7);
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
        const Pose pose = random_pose(random, i % 2 ? 1e7f : 10);
        Camera camera = placed(pose, described(pose.handedness, i & 1, i & 2, 1920, 1080));
        const float fov = random.uniform_float(0.1f, 3), n = random.uniform_float(1e-3f, 1);
        const float f = random.uniform_float(10, 1e6f);
        const bool flat = i % 3 == 0;
        if (flat) {
            camera.set_orthographic(fov, n, f);
        } else {
            camera.set_perspective(fov, n, f);
        }
        Vec3 corners[8];
        REQUIRE(camera.corners(corners));
        for (int k = 0; k < 8; ++k) {
            const long double z = k < 4 ? n : f;
            const long double half =
                flat ? static_cast<long double>(fov) / 2 : z * std::tan(static_cast<long double>(fov) / 2);
            const Wide exact =
                pose.world((k % 4 == 1 || k % 4 == 2 ? half : -half) * 16 / 9, k % 4 >= 2 ? half : -half, z);
            const gphys_vec3 corner = narrow(corners[k]);
            // Where position and offset cancel, the ulp is theirs.
            const long double size = std::max(z, half);
            worst = std::max({worst, ulps(corner.x, exact.x, std::max(std::fabs(exact.x), size)),
                              ulps(corner.y, exact.y, std::max(std::fabs(exact.y), size)),
                              ulps(corner.z, exact.z, std::max(std::fabs(exact.z), size))});
        }
    }
    INFO(worst);
    CHECK(worst <= 2);
    Camera endless(nullptr, described());
    endless.set_perspective(1, 0.1f, INFINITY);
    Vec3 unused[8];
    REQUIRE_FALSE(endless.corners(unused));
}

TEST_CASE("the frustum holds what has an image in the viewport") {
    test::Random random(8);
    int inside = 0;
    for (int i = 0; i < 40000; ++i) {
        const Pose pose = random_pose(random, 10);
        Camera camera = placed(pose, described(pose.handedness, i & 1, i & 2));
        if (i % 5 == 1) camera.set_orthographic(20, -5, 30);
        if (i % 5 == 2) camera.set_perspective(1, 0.5f, INFINITY);
        if (i % 5 == 3) REQUIRE(camera.set_projection(camera.projection_matrix()) == GPHYS_OK);
        const Frustum seen = camera.frustum();
        const Vec3 p = widen(random.point(30));
        bool held = true;
        double margin = infinity;
        for (const Plane& plane : seen.planes) {
            const double side = dot(plane.normal, p - seen.origin) - plane.distance;
            held = held && side >= 0;
            margin = std::min(margin, std::fabs(side));
        }
        if (margin < 1e-9) continue;
        Vec3 pixel;
        const double low = i & 1 ? -1 : 0;
        const bool imaged = camera.project(p, pixel) && pixel.x >= 0 && pixel.x <= 800 && pixel.y >= 0 &&
                            pixel.y <= 600 && pixel.z >= low && pixel.z <= 1;
        REQUIRE(held == imaged);
        inside += held;
    }
    REQUIRE(inside > 1000);
}

TEST_CASE("a resize keeps the vertical field and leaves user projections alone") {
    Camera camera(nullptr, described());
    camera.set_perspective(1, 0.1f, 100);
    Vec3 wide_view, narrow_view;
    REQUIRE(camera.project({1, 1, 5}, wide_view));
    camera.set_viewport(400, 600);
    REQUIRE(camera.project({1, 1, 5}, narrow_view));
    REQUIRE(narrow_view.y == wide_view.y);
    REQUIRE(std::fabs((narrow_view.x - 200) - (wide_view.x - 400)) < 1e-12);
    camera.set_orthographic(10, 0, 100);
    camera.set_viewport(1000, 500);
    REQUIRE(camera.project({10, 5, 50}, wide_view));
    REQUIRE((wide_view.x == 1000 && wide_view.y == 0));
    const Mat4 fixed = camera.projection_matrix();
    REQUIRE(camera.set_projection(fixed) == GPHYS_OK);
    camera.set_viewport(10, 500);
    require_matrix(camera.projection_matrix(), fixed, 0);
}

TEST_CASE("up is up and the first pixel is top left, in perspective and orthographic") {
    // The book's orthographic picture stood on its head.
    for (gphys_handedness handedness : {GPHYS_LEFT_HANDED, GPHYS_RIGHT_HANDED}) {
        Camera camera(nullptr, described(handedness));
        camera.look_at({0, 0, 0}, {0, 0, 10}, {0, 1, 0});
        const double right = handedness == GPHYS_LEFT_HANDED ? 1 : -1;
        for (bool flat : {false, true}) {
            if (flat) camera.set_orthographic(10, 0.1f, 100);
            Vec3 pixel;
            REQUIRE(camera.project({right, 2, 10}, pixel));
            REQUIRE(pixel.x > 400);
            REQUIRE(pixel.y < 300);
            Vec3 corners[8];
            REQUIRE(camera.corners(corners));
            REQUIRE(camera.project(corners[3], pixel));
            REQUIRE(std::fabs(pixel.x) + std::fabs(pixel.y) < 1e-9);
        }
    }
}

TEST_CASE("picking works for near = 0.001, wide views and 10 x 10 orthographic") {
    // The book's inverse gave up (|det| <= 0.005) and returned identity.
    Camera camera(nullptr, described());
    camera.look_at({3, 4, -5}, {0, 0, 0}, {0, 1, 0});
    for (int kind = 0; kind < 3; ++kind) {
        if (kind == 0) camera.set_perspective(1, 0.001f, 1000);
        if (kind == 1) camera.set_perspective(3.1f, 0.1f, 1000);
        if (kind == 2) camera.set_orthographic(10, 0.1f, 100);
        for (int user = 0; user < 2; ++user) {
            if (user) REQUIRE(camera.set_projection(widen(narrow(camera.projection_matrix()))) == GPHYS_OK);
            Ray ray;
            REQUIRE(camera.pick_ray(400, 300, ray));
            // The middle pixel looks at the target; a user matrix in float moves that by 2^-24 at most.
            const Vec3 to_target = Vec3{} - ray.origin;
            REQUIRE(length(cross(to_target, ray.direction)) < 1e-6);
            REQUIRE(dot(to_target, ray.direction) > 0);
        }
    }
}

TEST_CASE("a world matrix that drifted is mended: view direction kept, then up") {
    test::Random random(9);
    for (int i = 0; i < 2000; ++i) {
        const Pose pose = random_pose(random, 100);
        Camera camera = placed(pose, described());
        const Mat4 world = camera.world_matrix();
        Mat4 drifted = world;
        for (int column = 0; column < 3; ++column) {
            const double stretch = random.uniform(0.5, 2);
            for (int row = 0; row < 3; ++row)
                drifted(row, column) = (drifted(row, column) + random.uniform(-0.01, 0.01)) * stretch;
        }
        REQUIRE(camera.set_world_matrix(drifted) == GPHYS_OK);
        const Mat3 mended = camera.rotation();
        REQUIRE(distance(cross(mended.x, mended.y), mended.z) < 1e-15);
        REQUIRE(std::fabs(length(mended.y) - 1) < 1e-15);
        const Vec3 z = normalized(Vec3{drifted(0, 2), drifted(1, 2), drifted(2, 2)});
        REQUIRE(distance(mended.z, z) < 1e-15);
        const Vec3 y{drifted(0, 1), drifted(1, 1), drifted(2, 1)};
        REQUIRE(std::fabs(dot(cross(y, z), mended.y)) < 1e-14);
        REQUIRE(dot(y, mended.y) > 0);
        REQUIRE(camera.set_world_matrix(world) == GPHYS_OK);
        require_matrix(camera.world_matrix(), world, 1e-15);
    }
}

TEST_CASE("a world matrix that mirrors or spans no space is refused and changes nothing") {
    Camera camera(nullptr, described());
    camera.look_at({1, 2, 3}, {4, 5, 7}, {0, 1, 0});
    const Mat4 before = camera.world_matrix();
    Mat4 mirrored = before;
    for (int row = 0; row < 3; ++row) mirrored(row, 0) *= -1;
    REQUIRE(camera.set_world_matrix(mirrored) == GPHYS_ERROR_INVALID_ARGUMENT);
    for (int axis = 0; axis < 3; ++axis) {
        Mat4 flat = before;
        for (int row = 0; row < 3; ++row) flat(row, axis) = 0;
        REQUIRE(camera.set_world_matrix(flat) == GPHYS_ERROR_SINGULAR);
        // One axis in the plane of the others, each element rounded to float.
        for (int row = 0; row < 3; ++row) {
            flat(row, axis) = static_cast<float>(0.6 * before(row, (axis + 1) % 3) + 0.8 * before(row, (axis + 2) % 3));
        }
        REQUIRE(camera.set_world_matrix(flat) == GPHYS_ERROR_SINGULAR);
    }
    require_matrix(camera.world_matrix(), before, 0);
}

TEST_CASE("a user projection may be off-centre") {
    // glFrustum(-1, 3, -2, 1, 1, 50) in a right-handed camera of depth -1..1.
    const double l = -1, r = 3, b = -2, t = 1, n = 1, f = 50;
    const Mat4 matrix = rows({2 * n / (r - l), 0, (r + l) / (r - l), 0, 0, 2 * n / (t - b), (t + b) / (t - b), 0, 0, 0,
                              -(f + n) / (f - n), -2 * f * n / (f - n), 0, 0, -1, 0});
    Camera camera(nullptr, described(GPHYS_RIGHT_HANDED, GPHYS_DEPTH_MINUS_ONE_TO_ONE));
    REQUIRE(camera.set_projection(matrix) == GPHYS_OK);
    require_matrix(camera.projection_matrix(), matrix, 0);
    Vec3 corners[8], pixel;
    REQUIRE(camera.corners(corners));
    REQUIRE(distance(corners[0], {l, b, -n}) < 1e-14);
    REQUIRE(distance(corners[2], {r, t, -n}) < 1e-14);
    REQUIRE(distance(corners[7], {l * f, t * f, -f}) < 1e-11);
    REQUIRE(camera.project({l, t, -n}, pixel));
    REQUIRE(distance(pixel, {0, 0, -1}) < 1e-12);
    // Each corner lies on its three planes.
    const Frustum seen = camera.frustum();
    for (int k = 0; k < 8; ++k) {
        const int on[3] = {k < 4 ? GPHYS_FRUSTUM_NEAR : GPHYS_FRUSTUM_FAR,
                           k % 4 == 0 || k % 4 == 3 ? GPHYS_FRUSTUM_LEFT : GPHYS_FRUSTUM_RIGHT,
                           k % 4 < 2 ? GPHYS_FRUSTUM_BOTTOM : GPHYS_FRUSTUM_TOP};
        for (int plane : on) {
            REQUIRE(std::fabs(dot(seen.planes[plane].normal, corners[k]) - seen.planes[plane].distance) < 1e-11);
        }
    }
}

TEST_CASE("a user projection that cannot be one is refused and changes nothing") {
    Camera camera(nullptr, described());
    const Mat4 before = camera.projection_matrix();
    REQUIRE(camera.set_projection(Mat4{}) == GPHYS_ERROR_SINGULAR);
    Mat4 flat = before;
    for (int column = 0; column < 4; ++column) flat(0, column) = flat(1, column);
    REQUIRE(camera.set_projection(flat) == GPHYS_ERROR_SINGULAR);
    // Reverse-Z with an infinite far plane, for a camera that is not reversed: near is at infinity.
    const Mat4 reversed = rows({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0.1, 0, 0, 1, 0});
    REQUIRE(camera.set_projection(reversed) == GPHYS_ERROR_INVALID_ARGUMENT);
    require_matrix(camera.projection_matrix(), before, 0);
    REQUIRE(Camera(nullptr, described(GPHYS_LEFT_HANDED, GPHYS_DEPTH_ZERO_TO_ONE, true)).set_projection(reversed) ==
            GPHYS_OK);
}

TEST_CASE("a rectangle of pixels sees what projects into it, in all three projections") {
    test::Random random(10);
    for (int i = 0; i < 20000; ++i) {
        const Pose pose = random_pose(random, 10);
        Camera camera = placed(pose, described(pose.handedness, i & 1, i & 2));
        if (i % 3 == 1) camera.set_orthographic(20, -5, 30);
        if (i % 3 == 2) REQUIRE(camera.set_projection(camera.projection_matrix()) == GPHYS_OK);
        const double x0 = random.uniform(-100, 900), y0 = random.uniform(-100, 700);
        const double x1 = random.uniform(-100, 900), y1 = random.uniform(-100, 700);
        const Frustum seen = camera.frustum_of_pixels(x0, y0, x1, y1);
        // A point in or near the view.
        Vec3 p;
        const double low = i & 1 ? -1 : 0;
        const Vec3 pixel{random.uniform(-100, 900), random.uniform(-100, 700), random.uniform(low, 1)};
        REQUIRE(camera.unproject(pixel, p));
        double margin = infinity;
        bool held = true;
        for (const Plane& plane : seen.planes) {
            const double side = dot(plane.normal, p - seen.origin) - plane.distance;
            held = held && side >= 0;
            margin = std::min(margin, std::fabs(side));
        }
        if (margin < 1e-9) continue;
        REQUIRE(held == (pixel.x >= std::min(x0, x1) && pixel.x <= std::max(x0, x1) && pixel.y >= std::min(y0, y1) &&
                         pixel.y <= std::max(y0, y1)));
    }
}

TEST_CASE("orbiting places the camera, and its position is one that float can hold") {
    gphys_orbit orbit{};
    orbit.target = {1, 2, 3};
    orbit.up = {0, 1, 0};
    orbit.distance = 7;
    orbit.pitch = 0.5f;
    orbit.yaw = 1;
    orbit.radians_per_unit = orbit.metres_per_unit = 1;
    orbit.min_distance = 1;
    orbit.max_distance = INFINITY;
    orbit.min_pitch = -1;
    orbit.max_pitch = 1;
    for (gphys_handedness handedness : {GPHYS_LEFT_HANDED, GPHYS_RIGHT_HANDED}) {
        Camera camera(nullptr, described(handedness));
        REQUIRE(camera.orbit() == nullptr);
        camera.set_orbit(orbit);
        REQUIRE(camera.orbit() != nullptr);
        REQUIRE(camera.position() == widen(narrow(camera.position())));
        REQUIRE(distance(camera.position(), camera.orbit()->position()) < 1e-6);
        REQUIRE(camera.position().y > 2);
        REQUIRE(camera.frustum().origin == camera.position());
        Vec3 pixel;
        REQUIRE(camera.project(widen(orbit.target), pixel));
        REQUIRE(std::fabs(pixel.x - 400) < 1e-3);
        REQUIRE(std::fabs(pixel.y - 300) < 1e-3);
        // More yaw: the camera turns to its right, so what it saw moves to the left.
        const Vec3 ahead = camera.position() + (widen(orbit.target) - camera.position()) * 0.9;
        camera.orbit()->rotate(0.01, 0);
        camera.orbit()->update();
        const Mat3 turned = camera.orbit()->axes();
        REQUIRE(dot(turned.x, ahead - camera.position()) < 0);
        camera.follow_orbit();
        REQUIRE(distance(camera.position(), camera.orbit()->position()) < 1e-6);
    }
    // At the end of the range of coordinates the camera stays within it.
    orbit.target = {-GPHYS_MAX_COORDINATE, 0, 0};
    orbit.distance = GPHYS_MAX_COORDINATE;
    orbit.yaw = static_cast<float>(pi / 2);
    Camera camera(nullptr, described());
    camera.set_orbit(orbit);
    REQUIRE(max_component(abs(camera.position())) <= GPHYS_MAX_COORDINATE);
}
