#include "camera/projection.h"

#include <cfenv>
#include <vector>

#include "test.h"

using namespace gphys;

namespace {

const std::vector<DepthRange>& depth_ranges() {
    static const std::vector<DepthRange> all = {
        {GPHYS_DEPTH_ZERO_TO_ONE, false},
        {GPHYS_DEPTH_ZERO_TO_ONE, true},
        {GPHYS_DEPTH_MINUS_ONE_TO_ONE, false},
        {GPHYS_DEPTH_MINUS_ONE_TO_ONE, true},
    };
    return all;
}

const std::vector<Perspective>& perspectives() {
    static const std::vector<Perspective> all = {
        {1.2, 0.9, 0.1f, 1000}, {0.8, 0.6, 0.001f, 1e6f},  {0.8, 0.6, 0.01f, 1e6f},     {1.6, 0.9, 0.5f, infinity},
        {40, 30, 0.1f, 100},    {0.8, 0.6, 1, 1.0000001f}, {0.8, 0.6, 1e-6f, infinity}, {1e-3, 2e-3, 10, 1e15f},
    };
    return all;
}

const std::vector<Orthographic>& orthographics() {
    static const std::vector<Orthographic> all = {
        {5, 5, 0.1f, 100}, {100, 50, -200, 300}, {0.01, 0.02, 1000, 1000.5f}, {1e6, 1e6, -1e6f, 1e6f}};
    return all;
}

UserProjection user(const Mat4& matrix) {
    UserProjection projection{matrix, {}};
    REQUIRE(inverse(matrix, projection.from_clip));
    return projection;
}

/// Distances from near to far, evenly in their logarithms; near itself and far itself are among them.
std::vector<double> distances(double n, double f) {
    const double end = f < infinity ? f : n * 1e6;
    std::vector<double> out;
    for (int i = 0; i <= 20; ++i) out.push_back(i == 20 ? end : n * std::pow(end / n, i / 20.0));
    return out;
}

double relative_error(double value, long double reference) {
    return static_cast<double>(std::fabs((value - reference) / reference));
}

}  // namespace

TEST_CASE("depth is exact on the near and far plane") {
    Vec3 image;
    for (const DepthRange& depth_range : depth_ranges()) {
        for (const Perspective& p : perspectives()) {
            REQUIRE(p.project(depth_range, {0, 0, p.near_distance}, image));
            REQUIRE(image.z == depth_range.near_depth);
            if (p.far_distance == infinity) continue;
            REQUIRE(p.project(depth_range, {0, 0, p.far_distance}, image));
            REQUIRE(image.z == depth_range.far_depth);
        }
        for (const Orthographic& p : orthographics()) {
            REQUIRE(p.project(depth_range, {0, 0, p.near_distance}, image));
            REQUIRE(image.z == depth_range.near_depth);
            REQUIRE(p.project(depth_range, {0, 0, p.far_distance}, image));
            REQUIRE(image.z == depth_range.far_depth);
        }
    }
}

TEST_CASE("depth follows n and f to the last bits, reversed in relative terms too") {
    for (const Perspective& p : perspectives()) {
        const long double n = p.near_distance, f = p.far_distance;
        for (double z : distances(p.near_distance, p.far_distance)) {
            const long double zl = z;
            const bool finite = p.far_distance < infinity;
            const long double near_weight = finite ? n / zl * ((f - zl) / (f - n)) : n / zl;
            Vec3 image;
            REQUIRE(p.project({GPHYS_DEPTH_ZERO_TO_ONE, true}, {0, 0, z}, image));
            // Four roundings of the formula and one of the reference.
            if (near_weight != 0) REQUIRE(relative_error(image.z, near_weight) < 5 * 0x1p-53);
            REQUIRE(p.project({GPHYS_DEPTH_ZERO_TO_ONE, false}, {0, 0, z}, image));
            REQUIRE(std::fabs(image.z - (1 - near_weight)) < 5 * 0x1p-53);
        }
    }
}

TEST_CASE("projecting agrees with the matrix") {
    test::Random random(1);
    for (const DepthRange& depth_range : depth_ranges()) {
        const auto agree = [&](const auto& kind, Vec3 point, double tolerance) {
            const Vec4 clip = kind.matrix(depth_range) * Vec4{point.x, point.y, point.z, 1};
            Vec3 image;
            REQUIRE(kind.project(depth_range, point, image));
            REQUIRE(std::fabs(image.x - clip.x / clip.w) < 1e-13);
            REQUIRE(std::fabs(image.y - clip.y / clip.w) < 1e-13);
            REQUIRE(std::fabs(image.z - clip.z / clip.w) < tolerance);
        };
        for (const Perspective& p : perspectives()) {
            // The matrix cancels digits where n and f are close; what is tested is its use.
            const double lost = p.far_distance < infinity ? p.far_distance / (p.far_distance - p.near_distance) : 1;
            for (double z : distances(p.near_distance, p.far_distance)) {
                const double x = random.uniform(-1, 1) * z * p.half_width;
                const double y = random.uniform(-1, 1) * z * p.half_height;
                agree(p, {x, y, z}, 1e-15 * (4 + lost));
                agree(user(p.matrix(depth_range)), {x, y, z}, 1e-15 * (4 + lost));
            }
        }
        for (const Orthographic& p : orthographics()) {
            for (int i = 0; i < 20; ++i) {
                const double z = random.uniform(p.near_distance, p.far_distance);
                agree(p, {random.uniform(-1, 1) * p.half_width, random.uniform(-1, 1) * p.half_height, z}, 1e-12);
            }
        }
    }
}

TEST_CASE("unprojecting undoes projecting") {
    test::Random random(2);
    for (const DepthRange& depth_range : depth_ranges()) {
        const auto round_trip = [&](const auto& kind, Vec3 point, double tolerance) {
            Vec3 image, back;
            REQUIRE(kind.project(depth_range, point, image));
            REQUIRE(kind.unproject(depth_range, image, back));
            REQUIRE(distance(back, point) <= tolerance * length(point));
        };
        for (const Perspective& p : perspectives()) {
            for (double z : distances(p.near_distance, p.far_distance)) {
                const Vec3 point{random.uniform(-1, 1) * z * p.half_width, random.uniform(-1, 1) * z * p.half_height,
                                 z};
                // An error of 2^-53 in the depth is one of z / n * 2^-53 in z, unless depth is near 0 there.
                const bool reverse = depth_range.near_depth == 1 && depth_range.far_depth == 0;
                const double lost = reverse ? 1 : 1 + z / p.near_distance;
                round_trip(p, point, 16 * lost * 0x1p-53);
            }
        }
        for (const Orthographic& p : orthographics()) {
            for (int i = 0; i < 20; ++i) {
                const double z = random.uniform(p.near_distance, p.far_distance);
                round_trip(p, {random.uniform(-1, 1) * p.half_width, random.uniform(-1, 1) * p.half_height, z}, 1e-12);
            }
        }
    }
}

TEST_CASE("the far plane of n = 0.01, f = 1e6 is where it should be") {
    // The book's came out as NaN.
    const Perspective p{0.8, 0.6, 0.01f, 1e6f};
    for (const DepthRange& depth_range : depth_ranges()) {
        Vec3 point;
        REQUIRE(p.unproject(depth_range, {1, -1, depth_range.far_depth}, point));
        REQUIRE(point.z == 1e6f);
        REQUIRE(std::fabs(point.x / (0.8 * 1e6) - 1) < 1e-15);
        REQUIRE(std::fabs(point.y / (-0.6 * 1e6) - 1) < 1e-15);
        Plane planes[6];
        p.planes(depth_range, {}, planes);
        REQUIRE(planes[GPHYS_FRUSTUM_FAR].normal == Vec3{0, 0, -1});
        REQUIRE(planes[GPHYS_FRUSTUM_FAR].distance == -1e6f);
        for (const Plane& plane : planes) REQUIRE(std::isfinite(plane.normal.x + plane.normal.y + plane.normal.z));
    }
}

TEST_CASE("up is up in an orthographic picture") {
    // The book's was upside down.
    const Orthographic p{10, 10, 0, 100};
    Vec3 image;
    REQUIRE(p.project({GPHYS_DEPTH_ZERO_TO_ONE, false}, {2, 5, 50}, image));
    REQUIRE(image.x == 0.2);
    REQUIRE(image.y == 0.5);
    REQUIRE(image.z == 0.5);
}

TEST_CASE("what is behind, or at infinity, has no image and no place") {
    Vec3 out;
    for (const DepthRange& depth_range : depth_ranges()) {
        const Perspective finite{0.8, 0.6, 0.1f, 100}, endless{0.8, 0.6, 0.1f, infinity};
        for (const Perspective& p : {finite, endless}) {
            REQUIRE_FALSE(p.project(depth_range, {0, 0, 0}, out));
            REQUIRE_FALSE(p.project(depth_range, {1, 1, -5}, out));
            REQUIRE_FALSE(user(p.matrix(depth_range)).project(depth_range, {0, 0, -5}, out));
            // Far weights beyond 1.001 lie past infinity for n / f = 0.001.
            const double beyond = depth_range.depth(-0.1, 1.1);
            REQUIRE_FALSE(p.unproject(depth_range, {0, 0, beyond}, out));
            REQUIRE_FALSE(user(p.matrix(depth_range)).unproject(depth_range, {0, 0, beyond}, out));
        }
        REQUIRE_FALSE(endless.unproject(depth_range, {0.5, 0.5, depth_range.far_depth}, out));
        REQUIRE_FALSE(user(endless.matrix(depth_range)).unproject(depth_range, {0.5, 0.5, depth_range.far_depth}, out));
    }
}

TEST_CASE("a far plane at infinity is found there in spite of rounding, in any user matrix") {
    test::Random random(5);
    for (const DepthRange& depth_range : depth_ranges()) {
        for (int i = 0; i < 500; ++i) {
            // Off-centre and, as homogeneous coordinates allow, scaled as a whole.
            Mat4 m = Perspective{0.8, 0.6, random.uniform(0.01, 1), infinity}.matrix(depth_range);
            m(0, 2) = random.uniform(-1, 1);
            m(1, 2) = random.uniform(-1, 1);
            const double scale = random.uniform(0.1, 10);
            for (double& element : m.m) element *= scale;
            const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
            Vec3 point;
            REQUIRE_FALSE(user(m).unproject(depth_range, {x, y, depth_range.far_depth}, point));
            Ray ray;
            REQUIRE(user(m).cast(depth_range, x, y, ray));
            REQUIRE(ray.t_max == infinity);
        }
    }
}

TEST_CASE("a cast ray runs along the points of its image and ends on the far plane") {
    test::Random random(3);
    for (const DepthRange& depth_range : depth_ranges()) {
        const auto check = [&](const auto& kind, double far_distance, double tolerance) {
            const double x = random.uniform(-1.5, 1.5), y = random.uniform(-1.5, 1.5);
            Ray ray;
            REQUIRE(kind.cast(depth_range, x, y, ray));
            REQUIRE(std::fabs(length(ray.direction) - 1) < 1e-15);
            REQUIRE(ray.direction.z > 0);
            if (far_distance == infinity) {
                REQUIRE(ray.t_max == infinity);
            } else {
                const Vec3 end = ray.origin + ray.direction * ray.t_max;
                REQUIRE(std::fabs(end.z - far_distance) <= tolerance * std::max(1.0, std::fabs(far_distance)));
            }
            for (double part : {0.001, 0.1, 0.5, 1.0}) {
                Vec3 image;
                const double t = part * std::min(ray.t_max, 1000.0);
                REQUIRE(kind.project(depth_range, ray.origin + ray.direction * t, image));
                REQUIRE(std::fabs(image.x - x) < tolerance);
                REQUIRE(std::fabs(image.y - y) < tolerance);
            }
        };
        for (const Perspective& p : perspectives()) {
            check(p, p.far_distance, 1e-13);
            Ray ray;
            REQUIRE(p.cast(depth_range, 0.3, 0.4, ray));
            REQUIRE(ray.origin.z == p.near_distance);
            REQUIRE(p.cast_from_centre(0.3, 0.4).origin == Vec3{});
        }
        for (const Orthographic& p : orthographics()) {
            check(p, p.far_distance, 1e-9);
            Ray ray;
            REQUIRE(p.cast(depth_range, 0.3, 0.4, ray));
            REQUIRE(ray.origin.z == p.near_distance);
        }
        const Perspective plain{0.8, 0.6, 0.5f, 100}, endless{0.8, 0.6, 0.5f, infinity};
        check(user(plain.matrix(depth_range)), 100, 1e-10);
        check(user(endless.matrix(depth_range)), infinity, 1e-10);
        Ray from_user, from_perspective;
        REQUIRE(user(plain.matrix(depth_range)).cast(depth_range, 0.3, -0.4, from_user));
        REQUIRE(plain.cast(depth_range, 0.3, -0.4, from_perspective));
        REQUIRE(distance(from_user.direction, from_perspective.direction) < 1e-12);
        REQUIRE(std::fabs(from_user.origin.z - 0.5) < 1e-13);
        REQUIRE(user(endless.matrix(depth_range)).cast(depth_range, 0.3, -0.4, from_user));
        REQUIRE(from_user.t_max == infinity);
    }
}

TEST_CASE("planes from parameters and planes from the matrix are the same") {
    const Window windows[] = {{}, {-0.5, 0.25, 0.1, 0.75}, {0.5, 2, -3, -1}};
    for (const DepthRange& depth_range : depth_ranges()) {
        for (const Window& window : windows) {
            const auto check = [&](const auto& kind, double tolerance) {
                Plane own[6], from_matrix[6];
                kind.planes(depth_range, window, own);
                clip_planes(kind.matrix(depth_range), depth_range, window, from_matrix);
                for (int i = 0; i < 6; ++i) {
                    REQUIRE(distance(own[i].normal, from_matrix[i].normal) < 1e-14);
                    REQUIRE(std::fabs(own[i].distance - from_matrix[i].distance) <=
                            tolerance * (1 + std::fabs(own[i].distance)));
                }
            };
            // A matrix resolves f no better than 2^-53 f / n.
            check(Perspective{0.8, 0.6, 0.5f, 100}, 1e-12);
            check(Perspective{1.6, 0.9, 0.5f, infinity}, 1e-12);
            for (const Orthographic& p : orthographics()) check(p, 1e-11);
        }
    }
}

TEST_CASE("a line of sight that never meets an oblique near plane has no ray") {
    // Depth 0 on the plane x = 1 (lens coordinates): lines of sight to the left never reach it.
    Mat4 oblique;
    oblique(0, 0) = oblique(1, 1) = 1;
    oblique(2, 0) = 0.5;
    oblique(2, 3) = -0.5;
    oblique(3, 2) = 1;
    const DepthRange depth_range(GPHYS_DEPTH_ZERO_TO_ONE, false);
    Ray ray;
    REQUIRE(user(oblique).cast(depth_range, 0.5, 0, ray));
    REQUIRE(std::fabs(ray.origin.x - 1) < 1e-15);
    REQUIRE_FALSE(user(oblique).cast(depth_range, -0.5, 0, ray));
}

TEST_CASE("planes too close to be told apart leave no line of sight, and divide nothing by zero") {
    Mat4 flat;  // near at z = 1, far at z = 1 + 1e-30
    flat(0, 0) = flat(1, 1) = flat(3, 3) = 1;
    flat(2, 2) = 1e30;
    flat(2, 3) = -1e30;
    const UserProjection projection = user(flat);
    Ray ray;
    std::feclearexcept(FE_ALL_EXCEPT);
    REQUIRE_FALSE(projection.cast({GPHYS_DEPTH_ZERO_TO_ONE, false}, 0.25, 0.5, ray));
    REQUIRE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) == 0);
}
