#include "camera/clip_space.h"

#include "test.h"

using namespace gphys;

namespace {

Mat4 random_matrix(test::Random& random) {
    Mat4 m;
    for (double& element : m.m) element = random.uniform_float(-1, 1);
    return m;
}

/// Largest element of matrix * inverse - 1, in long double.
double residual(const Mat4& matrix, const Mat4& inverted) {
    long double largest = 0;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            long double sum = row == column ? -1 : 0;
            for (int k = 0; k < 4; ++k) sum += static_cast<long double>(matrix(row, k)) * inverted(k, column);
            largest = std::max(largest, std::fabs(sum));
        }
    }
    return static_cast<double>(largest);
}

/// The textbooks' left-handed perspective for depth 0..1 (D3DXMatrixPerspectiveFovLH).
Mat4 perspective_lh(double fov_y, double aspect, double n, double f) {
    Mat4 m;
    m(0, 0) = 1 / std::tan(fov_y / 2) / aspect;
    m(1, 1) = 1 / std::tan(fov_y / 2);
    m(2, 2) = f / (f - n);
    m(2, 3) = -n * f / (f - n);
    m(3, 2) = 1;
    return m;
}

}  // namespace

TEST_CASE("a matrix times its inverse is one") {
    test::Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const Mat4 m = random_matrix(random);
        Mat4 inverted;
        REQUIRE(inverse(m, inverted));
        double size = 0;
        for (double element : inverted.m) size = std::max(size, std::fabs(element));
        // Elements of m are below 1; Gauss-Jordan with complete pivoting leaves a residual of some
        // tens of roundings of the inverse's elements.
        REQUIRE(residual(m, inverted) <= 64 * size * 0x1p-53);
    }
}

TEST_CASE("the inverse does not fear small determinants: near = 0.001, wide views, 10 x 10 orthographic") {
    // Below the |det| of 0.005 at which the book's inverse gave up.
    Mat4 orthographic;
    orthographic(0, 0) = orthographic(1, 1) = 2.0 / 10;
    orthographic(2, 2) = 1.0 / 1000;
    orthographic(3, 3) = 1;
    struct Case {
        Mat4 matrix;
        double z;  // of a point not so far beyond near that its depth rounds to that of infinity
    };
    for (const Case& c : {Case{perspective_lh(1, 1.5, 0.001, 1000), 1}, Case{perspective_lh(3.1, 2, 0.1, 1000), 3},
                          Case{orthographic, 3}, Case{perspective_lh(1, 1, 1e-30, 1e6), 3e-30},
                          Case{perspective_lh(1, 1, 1e12, 1e15), 2e12}}) {
        Mat4 inverted;
        REQUIRE(inverse(c.matrix, inverted));
        const Vec4 back = inverted * (c.matrix * Vec4{0.25 * c.z, -0.5 * c.z, c.z, 1});
        REQUIRE(std::fabs(back.x / back.w / c.z - 0.25) < 1e-12);
        REQUIRE(std::fabs(back.y / back.w / c.z + 0.5) < 1e-12);
        REQUIRE(std::fabs(back.z / back.w / c.z - 1) < 1e-12);
    }
}

TEST_CASE("a singular matrix has no inverse, whatever its scale") {
    test::Random random(2);
    Mat4 unused;
    REQUIRE_FALSE(inverse(Mat4{}, unused));
    for (int i = 0; i < 2000; ++i) {
        for (double scale : {1e-30, 1.0, 1e12}) {
            Mat4 m = random_matrix(random);
            // One column is the sum of two others: with elements that are multiples of 2^-20 exactly.
            for (double& element : m.m) element = std::ldexp(std::round(std::ldexp(element, 20)), -20);
            for (int row = 0; row < 4; ++row) m(row, 3) = m(row, 0) + m(row, 1);
            for (double& element : m.m) element *= scale;
            REQUIRE_FALSE(inverse(m, unused));
            m(1, 3) += 1e-6 * scale;
            REQUIRE(inverse(m, unused));
        }
    }
}

TEST_CASE("a product applies its right factor first") {
    test::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Mat4 a = random_matrix(random), b = random_matrix(random);
        const Vec4 v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 1};
        const Vec4 once = (a * b) * v, twice = a * (b * v);
        REQUIRE(std::fabs(once.x - twice.x) + std::fabs(once.y - twice.y) < 1e-14);
        REQUIRE(std::fabs(once.z - twice.z) + std::fabs(once.w - twice.w) < 1e-14);
    }
}

TEST_CASE("depth weights invert depth in every convention") {
    for (gphys_depth_range range : {GPHYS_DEPTH_ZERO_TO_ONE, GPHYS_DEPTH_MINUS_ONE_TO_ONE}) {
        for (bool reverse_z : {false, true}) {
            const DepthRange depth_range(range, reverse_z);
            REQUIRE(depth_range.depth(1, 0) == (reverse_z ? 1 : range == GPHYS_DEPTH_ZERO_TO_ONE ? 0 : -1));
            REQUIRE(depth_range.depth(0, 1) == (!reverse_z ? 1 : range == GPHYS_DEPTH_ZERO_TO_ONE ? 0 : -1));
            REQUIRE(depth_range.near_weight(depth_range.depth(0.25, 0.75)) == 0.25);
            REQUIRE(depth_range.far_weight(depth_range.depth(0.25, 0.75)) == 0.75);
        }
    }
    // Reverse-Z keeps the relative accuracy of what is far: 1 - (1 - 1e-20) would be 0.
    REQUIRE(DepthRange(GPHYS_DEPTH_ZERO_TO_ONE, true).near_weight(1e-20) == 1e-20);
}

TEST_CASE("clip planes bound exactly what lands in the clip volume") {
    test::Random random(4);
    for (int i = 0; i < 2000; ++i) {
        const Mat4 m = random_matrix(random);
        const DepthRange depth_range(i & 1, i & 2);
        const Window window{random.uniform(-1, 0), random.uniform(0, 1), random.uniform(-1, 0), random.uniform(0, 1)};
        Plane planes[6];
        clip_planes(m, depth_range, window, planes);
        const double low = std::min(depth_range.near_depth, depth_range.far_depth);
        for (int k = 0; k < 50; ++k) {
            const Vec3 p = random.direction() * random.uniform(0, 5);
            const Vec4 clip = m * Vec4{p.x, p.y, p.z, 1};
            bool inside = true;
            double margin = infinity;
            const double slack[6] = {clip.z - low * clip.w,           clip.w - clip.z,
                                     clip.x - window.left * clip.w,   window.right * clip.w - clip.x,
                                     clip.y - window.bottom * clip.w, window.top * clip.w - clip.y};
            for (double s : slack) {
                inside = inside && s >= 0;
                margin = std::min(margin, std::fabs(s));
            }
            if (margin < 1e-12) continue;
            bool bounded = true;
            for (const Plane& plane : planes) bounded = bounded && dot(plane.normal, p) >= plane.distance;
            REQUIRE(bounded == inside);
        }
        for (const Plane& plane : planes) REQUIRE(std::fabs(length(plane.normal) - 1) < 1e-15);
    }
}

TEST_CASE("clip planes at infinity hold everything or nothing") {
    Mat4 infinite = perspective_lh(1, 1, 0.5, 10);
    infinite(2, 2) = 1;
    infinite(2, 3) = -0.5;
    Plane planes[6];
    clip_planes(infinite, DepthRange(GPHYS_DEPTH_ZERO_TO_ONE, false), {}, planes);
    REQUIRE(planes[GPHYS_FRUSTUM_FAR].normal == Vec3{});
    REQUIRE(planes[GPHYS_FRUSTUM_FAR].distance == -1);
    REQUIRE(planes[GPHYS_FRUSTUM_NEAR].normal == Vec3{0, 0, 1});
    REQUIRE(planes[GPHYS_FRUSTUM_NEAR].distance == 0.5);
    infinite(2, 3) = 0.5;
    clip_planes(infinite, DepthRange(GPHYS_DEPTH_ZERO_TO_ONE, false), {}, planes);
    REQUIRE(planes[GPHYS_FRUSTUM_FAR].distance == 1);
}
