#include "foundation/exact.h"

#include "test.h"

using namespace gphys;

namespace {

/// Determinants of small integers are exact in 128-bit integers: an independent reference.
using Wide = __int128;

int sign(Wide v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

struct Lattice {
    int64_t x, y, z;
    Vec3 point(double scale) const { return Vec3{double(x), double(y), double(z)} * scale; }
};

Lattice lattice_point(test::Random& random, int bits) {
    const auto coordinate = [&] { return int64_t(random.engine() >> (64 - bits)) - (int64_t(1) << (bits - 1)); };
    return {coordinate(), coordinate(), coordinate()};
}

int reference_orientation(Lattice a, Lattice b, Lattice c, Lattice d) {
    const Wide ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    const Wide vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    const Wide wx = d.x - a.x, wy = d.y - a.y, wz = d.z - a.z;
    return sign((uy * vz - uz * vy) * wx + (uz * vx - ux * vz) * wy + (ux * vy - uy * vx) * wz);
}

}  // namespace

TEST_CASE("the orientation of four points equals integer arithmetic, most of them nearly coplanar") {
    test::Random random(1);
    int flat = 0;
    for (int i = 0; i < 200000; ++i) {
        // 24 bits like a float's: the determinant needs 75 and double has 53.
        const Lattice a = lattice_point(random, 24), b = lattice_point(random, 24), c = lattice_point(random, 24);
        Lattice d = lattice_point(random, 24);
        if (i % 2) {
            // A lattice point on the line through a and b, extended, moved by at most one unit.
            const int64_t k = random.index(3);
            d = {b.x + k * (b.x - a.x), b.y + k * (b.y - a.y), b.z + k * (b.z - a.z) + int64_t(random.index(3)) - 1};
        }
        const int expected = reference_orientation(a, b, c, d);
        flat += expected == 0;
        // Powers of two scale without rounding, down to where the double product would be 1e-135.
        for (double scale : {1.0, 0x1p-149, 0x1p25}) {
            REQUIRE(orientation(a.point(scale), b.point(scale), c.point(scale), d.point(scale)) == expected);
        }
    }
    REQUIRE(flat > 10000);
}

TEST_CASE("sums of numbers of all magnitudes cancel exactly") {
    test::Random random(2);
    for (int i = 0; i < 20000; ++i) {
        double terms[8];
        for (double& t : terms) t = std::ldexp(random.uniform(-1, 1), int(random.index(240)) - 149);
        // Every ordering of +terms and -terms leaves the one that is kept.
        Exact sum(terms[0]);
        for (int k = 1; k < 8; ++k) sum = sum + Exact(terms[k]);
        for (int k = 1; k < 8; ++k) sum = sum - Exact(terms[k]);
        REQUIRE(sum.value() == terms[0]);
        REQUIRE((sum - Exact(terms[0])).sign() == 0);
    }
}

TEST_CASE("products of sums obey the distributive law at degree six over the range of floats") {
    test::Random random(3);
    for (int i = 0; i < 5000; ++i) {
        Exact left(1.0), right(1.0), difference(0.0);
        double a[3], b[3];
        for (int k = 0; k < 3; ++k) {
            a[k] = static_cast<float>(std::ldexp(random.uniform(-1, 1), int(random.index(190)) - 145));
            b[k] = static_cast<float>(std::ldexp(random.uniform(-1, 1), int(random.index(190)) - 145));
            left = left * (Exact(a[k]) + Exact(b[k])) * (Exact(a[k]) - Exact(b[k]));
            right = right * (Exact(a[k]) * Exact(a[k]) - Exact(b[k]) * Exact(b[k]));
        }
        REQUIRE((left - right).sign() == 0);
        const double smallest = std::numeric_limits<float>::denorm_min();
        difference = left + Exact(smallest) - right;
        REQUIRE(difference.value() == smallest);
    }
}

TEST_CASE("a collinear triple turns about no axis, its neighbours in float do") {
    test::Random random(4);
    for (int i = 0; i < 20000; ++i) {
        const Lattice a = lattice_point(random, 20), step = lattice_point(random, 20);
        const Lattice b{a.x + step.x, a.y + step.y, a.z + step.z};
        const Lattice c{a.x + 3 * step.x, a.y + 3 * step.y, a.z + 3 * step.z};
        REQUIRE(turning_axis(a.point(1), b.point(1), c.point(1)) == -1);
        const Lattice beside{c.x, c.y, c.z + 1};
        const bool along_z = step.x == 0 && step.y == 0;
        REQUIRE((turning_axis(a.point(1), b.point(1), beside.point(1)) == -1) == along_z);
    }
}

TEST_CASE("an accurate cross product keeps its digits where a rounded one loses them all") {
    test::Random random(5);
    for (int i = 0; i < 20000; ++i) {
        const Lattice a = lattice_point(random, 24), step = lattice_point(random, 22);
        const Lattice b{a.x + step.x, a.y + step.y, a.z + step.z};
        // Nearly parallel to a b: one lattice unit off.
        const Lattice c{a.x + 3 * step.x, a.y + 3 * step.y + 1, a.z + 3 * step.z};
        const Vec3 n = accurate_cross(a.point(1), b.point(1), a.point(1), c.point(1));
        // cross(step, 3 step + (0, 1, 0)) = cross(step, (0, 1, 0))
        REQUIRE(n == Vec3{double(-step.z), 0, double(step.x)});
    }
}

TEST_CASE("an accurate cross product equals integer arithmetic, most of them of nearly parallel vectors") {
    test::Random random(7);
    for (int i = 0; i < 100000; ++i) {
        // Products need 62 bits and double has 53.
        const Lattice a = lattice_point(random, 30), b = lattice_point(random, 30), c = lattice_point(random, 30);
        // c + (b - a) and a step aside, ever smaller.
        const Lattice aside = lattice_point(random, 2 + i % 28);
        const Lattice d{c.x + b.x - a.x + aside.x, c.y + b.y - a.y + aside.y, c.z + b.z - a.z + aside.z};
        const Lattice p{b.x - a.x, b.y - a.y, b.z - a.z}, q{d.x - c.x, d.y - c.y, d.z - c.z};
        const double expected[3] = {double(Wide(p.y) * q.z - Wide(p.z) * q.y),
                                    double(Wide(p.z) * q.x - Wide(p.x) * q.z),
                                    double(Wide(p.x) * q.y - Wide(p.y) * q.x)};
        const Vec3 result = accurate_cross(a.point(1), b.point(1), c.point(1), d.point(1));
        for (int k = 0; k < 3; ++k) REQUIRE(std::fabs(result[k] - expected[k]) <= 0x1p-44 * std::fabs(expected[k]));
    }
}

TEST_CASE("a running error bound covers the error") {
    test::Random random(6);
    for (int i = 0; i < 100000; ++i) {
        const Vec3 a = widen(random.point(1000)), b = widen(random.point(1000)), c = widen(random.point(1000));
        const auto polynomial = [&](auto number) {
            using V = Vec<decltype(number)>;
            return dot(cross(V::difference(a, b), V::difference(c, b)), V::of(a)) - dot(V::of(b), V::of(c));
        };
        const Bounded quick = polynomial(Bounded());
        const Exact exact = polynomial(Exact());
        REQUIRE(std::fabs((exact - Exact(quick.value)).value()) <= quick.error);
    }
}

TEST_CASE("determinants in integers are those of expansions, as long as their numbers spread over 41 bits") {
    test::Random random(5);
    constexpr int64_t most = (int64_t{1} << 41) - 1;
    int flat = 0;
    for (int i = 0; i < 50000; ++i) {
        Lattice v[3];
        for (Lattice& each : v) {
            if (i % 4 == 0) {  // as large as can be
                each = {random.index(2) ? most : -most, random.index(2) ? most : -most, random.index(2) ? most : -most};
            } else {
                each = lattice_point(random, 2 + static_cast<int>(random.index(40)));
            }
        }
        // In a plane with the others, or just beside it.
        if (i % 4 == 1) v[0] = {v[1].x - v[2].x, v[1].y - v[2].y, v[1].z - v[2].z + int64_t(random.index(2))};
        Vec3 a = v[0].point(0x1p-30), b = v[1].point(1), c = v[2].point(1);
        for (int axis = 0; axis < 3; ++axis) {
            const double unit = std::ldexp(1.0, static_cast<int>(random.index(120)) - 60);
            a[axis] *= unit, b[axis] *= unit, c[axis] *= unit;
        }
        using V = Vec<Exact>;
        const double expected = dot(V::of(a), cross(V::of(b), V::of(c))).value();
        double value = 0;
        if (!integer_determinant(a, b, c, value)) {  // a common scale may not do for a
            REQUIRE(i % 4 != 0);
            continue;
        }
        REQUIRE(std::fabs(value - expected) <= 0x1p-52 * std::fabs(expected));
        flat += value == 0;
    }
    REQUIRE(flat > 4000);
    double value;
    REQUIRE(integer_determinant({1, 0, 0}, {0, 1, 0}, {0, 0x1p-40, 1}, value));
    REQUIRE(value == 1);
    REQUIRE_FALSE(integer_determinant({1, 0, 0}, {0, 1, 0}, {0, 0x1p-41, 1}, value));
    REQUIRE_FALSE(integer_determinant({1, 0x1p-41, 0}, {1, 1, 0}, {0, 1, 1}, value));
    REQUIRE_FALSE(integer_determinant({1, 0, 0}, {0, 0x1p-201, 0}, {0, 0, 1}, value));
}

TEST_CASE("numbers that overflow lose their sign, not their room") {
    const Exact beyond = Exact(1e200) * Exact(1e200);
    Exact sum = beyond;
    for (int i = 0; i < 1000; ++i) sum = sum + beyond * Exact(std::ldexp(1.0, i - 500)) + Exact(i);
    const Exact product = sum * sum * beyond;
    CHECK(std::abs(product.sign()) <= 1);
    CHECK((Exact(3) * Exact(5) - Exact(15)).sign() == 0);
}

TEST_CASE("a difference is known to be exact or not") {
    Vec3 difference;
    REQUIRE(difference_is_exact({1, 2, 3}, {0x1p-50, 5, -3}, difference));
    REQUIRE(difference == Vec3{1 - 0x1p-50, -3, 6});
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 a{1, 1, 1}, b;
        b[axis] = 0x1p-60;
        REQUIRE_FALSE(difference_is_exact(a, b, difference));
        REQUIRE_FALSE(difference_is_exact(b, a, difference));
    }
}
