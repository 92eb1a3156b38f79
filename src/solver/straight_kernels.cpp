// Which links at a particle continue each other (straight_kernels.h). Cosines are summed in the order x, y, z, so all
// instruction sets give the same bits.
#include "solver/straight_kernels.h"

#include "foundation/compiler.h"
#include "foundation/simd_double.h"

namespace gphys::GPHYS_ISA {
namespace {

// A line turns by less than 45 degrees at a particle, and joins only constraints of one kind. Bend constraints are
// twice as long as the edges beside them; the edges of a mesh vary less than this ratio.
constexpr double least_straight = -0.70710678118654752;
constexpr double most_ratio = 1.75;

/// With the same bits as normalized.
void normalize(double* x, double* y, double* z, size_t count) {
    const Double8 zero(0), one(1);
    for (size_t i = 0; i < count; i += 8) {
        const Double8 a = load_doubles(x + i), b = load_doubles(y + i), c = load_doubles(z + i);
        const Double8 size = largest(largest(absolute(a), absolute(b)), absolute(c));
        const DoubleMask8 some = zero < size;
        const Double8 scale = select(some, size, one);
        const Double8 u = a / scale, v = b / scale, w = c / scale;
        const Double8 length = select(some, square_root(u * u + v * v + w * w), one);
        store_doubles(x + i, u / length);
        store_doubles(y + i, v / length);
        store_doubles(z + i, w / length);
    }
}

uint32_t list_pairs(const LinksAround& around, uint32_t begin, uint32_t end, StraightPair* pairs) {
    constexpr uint32_t lanes = 8;
    const Double8 limit(least_straight), ratio(most_ratio);
    uint32_t found = 0;
    for (uint32_t i = begin; i < end; ++i) {
        const Double8 x(around.x[i]), y(around.y[i]), z(around.z[i]);
        const Double8 rest(around.rest[i]), longest = rest * ratio, compliance(around.compliance[i]);
        for (uint32_t block = (i + 1) / lanes * lanes; block < around.count; block += lanes) {
            const Double8 cosine = x * load_doubles(around.x + block) + y * load_doubles(around.y + block) +
                                   z * load_doubles(around.z + block);
            const Double8 other_rest = load_doubles(around.rest + block);
            const Double8 other_compliance = load_doubles(around.compliance + block);
            const auto same_kind = (other_rest <= longest) & (rest <= ratio * other_rest) &
                                   (other_compliance <= compliance) & (compliance <= other_compliance);
            const uint32_t from = i + 1 > block ? i + 1 - block : 0;
            const uint32_t to = around.count - block < lanes ? around.count - block : lanes;
            uint32_t continued = bits((cosine <= limit) & same_kind) & (0xffu << from) & (0xffu >> (lanes - to));
            if (continued == 0) continue;
            double cosines[lanes];
            store_doubles(cosines, cosine);
            for (; continued != 0; continued &= continued - 1) {
                const uint32_t lane = static_cast<uint32_t>(lowest_bit(continued));
                pairs[found++] = {cosines[lane], i, block + lane};
            }
        }
    }
    return found;
}

}  // namespace

const StraightKernels straight_kernels = {normalize, list_pairs};

}  // namespace gphys::GPHYS_ISA
