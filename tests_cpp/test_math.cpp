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
