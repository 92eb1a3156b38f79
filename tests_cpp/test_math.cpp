#include "test.h"

using namespace gphys;

TEST_CASE("a rotation survives the way through its matrix and back") {
    test::Random random(1);
    for (int i = 0; i < 10000; ++i) {
        const Quat q = normalized(widen(random.rotation()));
        const Quat back = quaternion(rotation_matrix(q));
        const double same = q.x * back.x + q.y * back.y + q.z * back.z + q.w * back.w;
        // Each entry of the matrix carries a few roundings of 2^-53.
        REQUIRE(std::fabs(std::fabs(same) - 1) < 1e-15);
    }
}

TEST_CASE("a transform undoes itself") {
    test::Random random(2);
    for (int i = 0; i < 10000; ++i) {
        const Transform t{widen(random.point(100)), rotation_matrix(widen(random.rotation())), random.uniform(0.1, 10)};
        const Vec3 p = widen(random.point(100));
        REQUIRE(distance(t.inverse_apply(t.apply(p)), p) < 1e-11);
    }
}

TEST_CASE("a vector that goes through float comes back rounded") {
    // gcc 12 at -O3 returned x and y unchanged. Volatile, so that this is a function of its own.
    Vec3 (*volatile through_float)(Vec3) = [](Vec3 v) { return widen(narrow(v)); };
    test::Random random(3);
    for (int i = 0; i < 100; ++i) {
        const Vec3 exact{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        const Vec3 back = through_float(exact);
        for (int axis = 0; axis < 3; ++axis) {
            // A float has at most 24 significant bits: scaled so, it is a whole number.
            const double scaled = std::ldexp(back[axis], 23 - std::ilogb(back[axis]));
            REQUIRE(scaled == std::floor(scaled));
            REQUIRE(std::fabs(back[axis] - exact[axis]) <= 0x1p-25);
        }
    }
}
