// exp(-z) = 2^-k 2^(-i/32) exp(-h) with 1 <= i <= 32 and 0 <= h < 2^-5.5, by a table and a series (Tang 1989).
#include "foundation/elementary.h"
#include "foundation/elementary_rounding.h"
#include "foundation/elementary_wide.h"

namespace gphys {
namespace {

/// 2^(-i/32) for i = 1 .. 32.
struct Powers {
    Wide all[33];
    U128 fraction[33];

    constexpr Powers() : all(), fraction() {
        all[0] = wide::one;
        for (int i = 1; i <= 32; ++i) {
            all[i] = all[i - 1] * wide::root_of_half;
            fraction[i] = all[i].fraction();
        }
    }
};
constexpr Powers powers;

/// s with 1 - exp(-h) = h (1 - s), times 2^69, within 2^-67; h < 2^-5.5 is given times 2^69.
/// s = h/2! - h^2/3! + ...; the first omitted term is h^9/10! < 2^-71. Odd and even powers are summed separately, two
/// shorter dependency chains, which takes half of the time.
uint64_t series(uint64_t h) {
    constexpr uint64_t odd[] = {0x8000000000000000, 0x0aaaaaaaaaaaaaaa, 0x005b05b05b05b05b, 0x0001a01a01a01a01};
    constexpr uint64_t even[] = {0x2aaaaaaaaaaaaaaa, 0x0222222222222222, 0x000d00d00d00d00d, 0x00002e3bc74aad8e};
    const uint64_t square = high_product(h, h);  // times 2^74
    uint64_t first = odd[3], second = even[3];
    for (int n = 2; n >= 0; --n) {
        first = odd[n] + (high_product(square, first) >> 10);
        second = even[n] + (high_product(square, second) >> 10);
    }
    return high_product(h, first - (high_product(h, second) >> 5));
}

using wide::Steps;

double rounded_kept(Approximation kept, int accuracy, Parts z, const Steps& steps) {
    return rounded(kept, accuracy,
                   [&](Parts middle) { return middle.wide(steps.halvings) < wide::kept(z.wide(), steps); });
}
double rounded_lost(Approximation lost, int accuracy, Parts z, const Steps& steps) {
    return rounded(lost, accuracy, [&](Parts middle) {
        return middle.wide() < wide::one - scaled(wide::kept(z.wide(), steps), -steps.halvings);
    });
}

}  // namespace

// The series ends where h^29 / 29! < 2^-260.
Wide wide::kept(const Wide& z, const Steps& steps) {
    const Wide h = z - ln2_32 * Wide::of(static_cast<uint64_t>(steps.count), 0);
    Wide sum = one;
    for (uint32_t n = 28; n >= 1; --n) sum = one - h * sum / n;
    return powers.all[steps.entry] * sum;
}

Decay decay(double z) {
    // exp(-z) = 1 - z + z^2/2 - ... is above 1 - 2^-54, the middle below 1, and z^2/2 is below half of the last bit of
    // z.
    if (z <= 0x1p-54) return {1, z};
    if (!(z < 746)) return {0, 1};  // below half of the smallest double
    const Parts parts = parts_of(z);
    const Steps steps(z);
    if (steps.count == 0) {
        // lost = z (1 - s), from all bits of z.
        const Approximation whole = approximation(parts);
        const uint64_t s = series((whole.fraction >> (-5 - whole.exponent)).high);
        const U128 lost = whole.fraction - (product(whole.fraction.high, s) >> 5);
        return {rounded_kept({U128{} - (lost >> -whole.exponent), 0}, 70, parts, steps),
                rounded_lost({lost, whole.exponent}, 66, parts, steps)};
    }
    // The rest modulo 1; the last bit of z is at least 2^-58.
    const uint64_t count = static_cast<uint64_t>(steps.count);
    constexpr U128 step = wide::ln2_32.fraction();
    const U128 h =
        (U128{0, parts.integer} << (128 + parts.exponent)) - product(step.low, count) - U128{step.high * count, 0};
    const uint64_t h69 = (h >> 59).low;
    const U128 lost_in_rest = h - (product(h69, series(h69)) >> 10);
    const U128 table = powers.fraction[steps.entry], kept = table - high_product(table, lost_in_rest);
    Decay result{rounded_kept({kept, -steps.halvings}, 70, parts, steps), 1};
    // lost >= 2^-5.6; it rounds to 1 where kept is below 2^-54.
    if (steps.halvings < 54) result.lost = rounded_lost({U128{} - (kept >> steps.halvings), 0}, 66, parts, steps);
    return result;
}

}  // namespace gphys
