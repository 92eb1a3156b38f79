#include "camera/orbit.h"

#include "test.h"

using namespace gphys;

namespace {

gphys_orbit settings() {
    gphys_orbit orbit{};
    orbit.up = {0, 1, 0};
    orbit.distance = 10;
    orbit.radians_per_unit = 1;
    orbit.metres_per_unit = 1;
    orbit.min_distance = 0.01f;
    orbit.max_distance = INFINITY;
    orbit.min_pitch = -static_cast<float>(pi / 2);
    orbit.max_pitch = static_cast<float>(pi / 2);
    return orbit;
}

void require_near(Vec3 a, Vec3 b, double tolerance) {
    INFO(a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z);
    REQUIRE(distance(a, b) <= tolerance);
}

void require_orthonormal(const Mat3& axes, double right_sign) {
    // A few roundings of 2^-53 in each.
    REQUIRE(std::fabs(length(axes.x) - 1) < 1e-15);
    REQUIRE(std::fabs(length(axes.y) - 1) < 1e-15);
    REQUIRE(std::fabs(length(axes.z) - 1) < 1e-15);
    require_near(cross(axes.y, axes.z) * right_sign, axes.x, 1e-15);
}

}  // namespace

TEST_CASE("an orbit at yaw 0 and pitch 0 looks along +Z for up +Y, in either handedness") {
    for (double right_sign : {1.0, -1.0}) {
        const Orbit orbit(settings(), right_sign);
        REQUIRE(orbit.axes().z == Vec3{0, 0, 1});
        REQUIRE(orbit.axes().y == Vec3{0, 1, 0});
        REQUIRE(orbit.axes().x == Vec3{right_sign, 0, 0});
        REQUIRE(orbit.position() == Vec3{0, 0, -10});
    }
}

TEST_CASE("yaw turns the view to the right and pitch makes it look down") {
    for (double right_sign : {1.0, -1.0}) {
        Orbit orbit(settings(), right_sign);
        orbit.rotate(pi / 2, 0);
        orbit.update();
        require_near(orbit.axes().z, {right_sign, 0, 0}, 1e-15);
        require_near(orbit.position(), {-10 * right_sign, 0, 0}, 1e-14);
        orbit.rotate(-pi / 2, pi / 4);
        orbit.update();
        require_near(orbit.axes().z, Vec3{0, -1, 1} / std::sqrt(2.0), 1e-15);
        require_near(orbit.position(), Vec3{0, 10, -10} / std::sqrt(2.0), 1e-14);
        REQUIRE(orbit.axes().y.y > 0);
    }
}

TEST_CASE("an orbit looks straight down and up without a NaN or a jump") {
    for (double pitch : {pi / 2, -pi / 2}) {
        Orbit orbit(settings(), 1);
        orbit.rotate(0.5, pitch);
        orbit.update();
        require_orthonormal(orbit.axes(), 1);
        require_near(orbit.axes().z, {0, pitch > 0 ? -1.0 : 1.0, 0}, 1e-15);
        const Vec3 right = orbit.axes().x;
        orbit.rotate(0, pitch > 0 ? -1e-6 : 1e-6);
        orbit.update();
        require_near(orbit.axes().x, right, 1e-15);
        REQUIRE(orbit.axes().y.y > 0);
    }
    // Input beyond the pole stops there: the view never turns over.
    Orbit orbit(settings(), 1);
    orbit.rotate(0, 100);
    orbit.update();
    REQUIRE(orbit.axes().y.y >= 0);
    REQUIRE(orbit.settings().pitch == settings().max_pitch);
}

TEST_CASE("angles of any size are wrapped in constant time") {
    // The book subtracted a turn at a time, which does nothing to 1e10 in float and never ended.
    for (double units : {1e10, -1e10, 3e38, -3e38}) {
        Orbit orbit(settings(), 1);
        orbit.rotate(units, units);
        orbit.update();
        const float yaw = orbit.settings().yaw;
        REQUIRE(std::fabs(yaw) <= static_cast<float>(pi));
        REQUIRE(std::fabs(yaw - std::remainder(units, 2 * pi)) < 1e-6);
        require_orthonormal(orbit.axes(), 1);
    }
    gphys_orbit wild = settings();
    wild.yaw = 1e10f;
    REQUIRE(std::fabs(Orbit(wild, 1).settings().yaw) <= static_cast<float>(pi));
}

TEST_CASE("rotation and zoom do not depend on how often update is called") {
    test::Random random(1);
    for (int i = 0; i < 100; ++i) {
        gphys_orbit start = settings();
        start.radians_per_unit = 0.01f;
        start.metres_per_unit = 0.001f;
        Orbit once(start, 1), often(start, 1);
        for (int k = 0; k < 100; ++k) {
            const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), zoom = random.uniform(-1, 1);
            once.rotate(x, y);
            once.zoom(zoom);
            often.rotate(x, y);
            often.zoom(zoom);
            often.update();
        }
        once.update();
        // 100 additions round by up to 2^-53 of 10 each.
        require_near(once.axes().z, often.axes().z, 1e-12);
        require_near(once.position(), often.position(), 1e-12);
    }
}

TEST_CASE("an update without input changes nothing, and input counts once") {
    Orbit orbit(settings(), 1);
    orbit.rotate(0.3, 0.2);
    orbit.zoom(1);
    orbit.pan(2, 3);
    orbit.update();
    const Vec3 position = orbit.position();
    for (int i = 0; i < 5; ++i) orbit.update();
    REQUIRE(orbit.position() == position);
}

TEST_CASE("zoom and pan are metres, whatever the distance") {
    for (float away : {0.5f, 10.0f, 1000.0f}) {
        gphys_orbit start = settings();
        start.distance = away;
        start.metres_per_unit = 0.25f;
        start.yaw = 0.7f;
        start.pitch = 0.4f;
        Orbit orbit(start, 1);
        orbit.zoom(1);
        orbit.update();
        REQUIRE(orbit.settings().distance == away - 0.25f);
        orbit.pan(4, -8);
        orbit.update();
        const Vec3 target = widen(orbit.settings().target);
        const Mat3 axes = orbit.axes();
        require_near(target, axes.x - axes.y * 2, 1e-6);
        // What the camera looks at is the target.
        require_near(orbit.position() + axes.z * (away - 0.25), axes.x - axes.y * 2, 1e-12);
    }
}

TEST_CASE("an orbit keeps its limits") {
    gphys_orbit limited = settings();
    limited.min_distance = 2;
    limited.max_distance = 20;
    limited.min_pitch = -0.5f;
    limited.max_pitch = 1;
    Orbit orbit(limited, 1);
    orbit.zoom(100);
    orbit.rotate(0, 100);
    orbit.update();
    REQUIRE(orbit.settings().distance == 2);
    REQUIRE(orbit.settings().pitch == 1);
    orbit.zoom(-100);
    orbit.rotate(0, -100);
    orbit.update();
    REQUIRE(orbit.settings().distance == 20);
    REQUIRE(orbit.settings().pitch == -0.5f);
    limited.distance = 100;
    limited.pitch = 1.5f;
    const Orbit brought_in(limited, 1);
    REQUIRE(brought_in.settings().distance == 20);
    REQUIRE(brought_in.settings().pitch == 1);
    Orbit unlimited(settings(), 1);
    unlimited.zoom(-3e38);
    unlimited.pan(3e38, 3e38);
    unlimited.update();
    REQUIRE(unlimited.settings().distance == GPHYS_MAX_COORDINATE);
    REQUIRE(std::fabs(unlimited.settings().target.x) == GPHYS_MAX_COORDINATE);
}

TEST_CASE("any direction can be up") {
    test::Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 up = random.direction();
        const double right_sign = i % 2 ? 1 : -1;
        gphys_orbit start = settings();
        start.up = narrow(up * random.uniform(1e-3, 1e3));
        start.yaw = random.uniform_float(-3, 3);
        start.pitch = random.uniform_float(-1.57f, 1.57f);
        start.target = random.point(10);
        const Orbit orbit(start, right_sign);
        require_orthonormal(orbit.axes(), right_sign);
        // The view makes the angle of pitch with the plane across up, and its target is ahead.
        REQUIRE(std::fabs(dot(orbit.axes().z, up) + std::sin(start.pitch)) < 1e-6);
        REQUIRE(std::fabs(dot(orbit.axes().x, up)) < 1e-6);
        require_near(orbit.position() + orbit.axes().z * 10, widen(start.target), 1e-13);
    }
}
