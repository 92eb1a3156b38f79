// The cube root: Halley's method in double, then the correctly rounded result (elementary_rounding.h).
#include "foundation/elementary.h"
#include "foundation/elementary_rounding.h"

namespace gphys {

double cbrt(double x) {
    if (!(std::fabs(x) > 0 && std::fabs(x) < HUGE_VAL)) return x;
    if (x < 0) return -cbrt(-x);
    // x = m 8^scale, 1 <= m < 8
    const int exponent = std::ilogb(x), scale = (exponent - (exponent % 3 + 3) % 3) / 3;
    const double m = std::scalbn(x, -3 * scale);
    // Halley's method: each step triples the number of correct digits. The first guess is within 0.1.
    double root = 0.85 + 0.15 * m;
    for (int i = 0; i < 3; ++i) {
        const double cube = root * root * root;
        root *= (cube + 2 * m) / (2 * cube + m);
    }
    // One step of Newton's method for the remainder m - root^3. The 124 fractional bits hold all of m, and of root^3
    // all that affects the result.
    const Parts r = parts_of(root), whole = parts_of(m);
    const int shift = -(3 * r.exponent + 124);
    const U128 square = product(r.integer, r.integer);
    const U128 cube = (product(square.high, r.integer) << (64 - shift)) + (product(square.low, r.integer) >> shift);
    const U128 cubed = U128{0, whole.integer} << (whole.exponent + 124);
    const double left = cubed < cube ? -to_double(cube - cubed) : to_double(cubed - cube);
    const double nearest = rounded(sum(root, left * 0x1p-124 / (3 * root * root)), 66, [&](Parts middle) {
        const Wide c = middle.wide();
        return c * c * c < whole.wide();
    });
    return std::scalbn(nearest, scale);
}

}  // namespace gphys
