#include "foundation/float4.h"

#include <cstring>
#include <initializer_list>
#include <limits>

#include "foundation/simd_plain.h"
#include "test.h"

using namespace gphys;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), not_a_number = std::numeric_limits<float>::quiet_NaN();

template <class A, class B>
bool same_bits(const A& a, const B& b) {
    static_assert(sizeof a == sizeof b);
    return std::memcmp(&a, &b, sizeof a) == 0;
}
/// NaN is NaN, whatever else its bits say.
bool same_floats(simd4::FloatRegister a, simd_plain::FloatRegister b) {
    for (int i = 0; i < 4; ++i) {
        const float x = a[i], y = b[i];
        if (!(x != x && y != y) && !same_bits(x, y)) return false;
    }
    return true;
}
bool same_doubles(simd4::DoubleRegister a, simd_plain::DoubleRegister b) {
    for (int i = 0; i < 2; ++i) {
        const double x = a[i], y = b[i];
        if (!(x != x && y != y) && !same_bits(x, y)) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("registers of four floats compute what plain numbers do, with zeros, infinities and NaN") {
    const float values[] = {0.0f, -0.0f, 1, -1, 1.5f, -3.25f, 1e-40f, -1e-40f, 3e38f, 7, inf, -inf, not_a_number};
    constexpr int count = sizeof values / sizeof values[0];
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < count; ++k) {
            const float a[4] = {values[i], values[(i + 1) % count], values[(i + 3) % count], values[(i + 4) % count]};
            const float b[4] = {values[k], values[(k + 2) % count], values[(k + 3) % count], values[(k + 5) % count]};
            const simd4::FloatRegister x = simd4::load_register(a), y = simd4::load_register(b);
            const simd_plain::FloatRegister p = simd_plain::load_register(a), q = simd_plain::load_register(b);
            INFO(i << ", " << k);
            REQUIRE(same_floats(x + y, p + q));
            REQUIRE(same_floats(x - y, p - q));
            REQUIRE(same_floats(x * y, p * q));
            REQUIRE(same_floats(x / y, p / q));
            REQUIRE(same_floats(minimum(x, y), minimum(p, q)));
            REQUIRE(same_floats(maximum(x, y), maximum(p, q)));
            REQUIRE(same_floats(square_root(x), square_root(p)));
            REQUIRE(same_bits(x < y, p < q));
            REQUIRE(same_bits(x <= y, p <= q));
            REQUIRE(same_bits(x != y, p != q));
            REQUIRE(same_bits(equal_bits(x, y), equal_bits(p, q)));
            REQUIRE(same_bits(greater_bits(x, y), greater_bits(p, q)));
            REQUIRE(same_bits(signs(x), signs(p)));
            REQUIRE(bits(x <= y) == bits(p <= q));
            REQUIRE(same_floats(choose(x < y, x, y), choose(p < q, p, q)));
            REQUIRE(same_bits(as_mask(x) & as_mask(y), as_mask(p) & as_mask(q)));
            REQUIRE(same_bits(as_mask(x) | as_mask(y), as_mask(p) | as_mask(q)));
            REQUIRE(same_bits(as_mask(x) ^ as_mask(y), as_mask(p) ^ as_mask(q)));
            REQUIRE(same_floats(simd4::shuffle<3, 1, 2, 0>(x, y), simd_plain::shuffle<3, 1, 2, 0>(p, q)));
            simd4::FloatRegister rows[4] = {x, y, y, x};
            simd_plain::FloatRegister plain_rows[4] = {p, q, q, p};
            transpose(rows);
            transpose(plain_rows);
            for (int r = 0; r < 4; ++r) REQUIRE(same_floats(rows[r], plain_rows[r]));
        }
    }
}

TEST_CASE("registers of integers and of two doubles compute what plain numbers do") {
    const int32_t numbers[4] = {0, 7, 8, 1 << 25};
    const auto set = [&](auto mask) {
        std::memcpy(&mask, numbers, sizeof mask);
        return mask;
    };
    const simd4::MaskRegister n = set(simd4::MaskRegister());
    const simd_plain::MaskRegister m = set(simd_plain::MaskRegister());
    CHECK(same_bits(add_integers(n, n), add_integers(m, m)));
    CHECK(same_bits(simd4::shift_right<3>(n), simd_plain::shift_right<3>(m)));
    CHECK(same_floats(to_floats(n), to_floats(m)));
    const float whole[4] = {0, 3, 1000, -2};
    CHECK(same_bits(integer_bits(simd4::load_register(whole)), integer_bits(simd_plain::load_register(whole))));

    const double values[] = {0.0, -0.0, 1, -2.5, 1e-310, 1e300, inf, -inf, not_a_number, 1.0 + 0x1p-30};
    constexpr int count = sizeof values / sizeof values[0];
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < count; ++k) {
            const double a[2] = {values[i], values[(i + 1) % count]}, b[2] = {values[k], values[(k + 2) % count]};
            const simd4::DoubleRegister x = simd4::load_register(a), y = simd4::load_register(b);
            const simd_plain::DoubleRegister p = simd_plain::load_register(a), q = simd_plain::load_register(b);
            INFO(i << ", " << k);
            REQUIRE(same_doubles(x + y, p + q));
            REQUIRE(same_doubles(x - y, p - q));
            REQUIRE(same_doubles(x * y, p * q));
            REQUIRE(same_doubles(x / y, p / q));
            REQUIRE(same_doubles(-x, -p));
            REQUIRE(same_doubles(least(x, y), least(p, q)));
            REQUIRE(same_doubles(largest(x, y), largest(p, q)));
            REQUIRE(same_doubles(square_root(x), square_root(p)));
            REQUIRE(same_doubles(absolute(x), absolute(p)));
            REQUIRE(same_doubles(with_sign(x, y), with_sign(p, q)));
            REQUIRE(same_bits(x < y, p < q));
            REQUIRE(same_bits(x <= y, p <= q));
            REQUIRE(bits((x < y) | !(x <= y)) == bits((p < q) | !(p <= q)));
            REQUIRE(bits((x <= y) & (y <= x)) == bits((p <= q) & (q <= p)));
            REQUIRE(same_doubles(select(x < y, x, y), select(p < q, p, q)));
            const simd4::DoubleRegister wide[2] = {x, y};
            const simd_plain::DoubleRegister plain_wide[2] = {p, q};
            REQUIRE(same_floats(narrowed(wide), narrowed(plain_wide)));
            simd4::DoubleRegister back[2];
            simd_plain::DoubleRegister plain_back[2];
            widen_to(back, narrowed(wide));
            widen_to(plain_back, narrowed(plain_wide));
            for (int r = 0; r < 2; ++r) REQUIRE(same_doubles(back[r], plain_back[r]));
        }
    }
}
