#include "solver/cloth_kernels.h"

#include "foundation/simd.h"

namespace gphys::GPHYS_ISA {

namespace {

// The compliance that every link has, relative to the inverse masses at its ends: it keeps the pivots
// of a straight chain between two pins away from zero. It leaves a millionth of the error, and bounds
// the sideways correction of a chain straight within an angle d: error * d / (d^2 + this) is at most
// error / (2 sqrt(this)), 500 times the error of pins too far apart.
constexpr float regularisation = 1e-6f;
// Keeps the pivot of a link between two pins from zero; beside the inverse mass of anything that
// moves, 1e-6 at least, it is nothing.
constexpr float least_pivot = 1e-20f;
// Coincident particles part along x. Beside any other difference of coordinates it is lost.
constexpr float aside = 1e-18f;
// Particles stop at the border of the world and at three times the speed of light, so that no square
// here leaves the range of floats.
constexpr float farthest = 2e15f, fastest = 1e9f;

struct Direction {
    Float8 x, y, z;  // unit
    Float8 length;
};

Direction direction(const Quads8& a, const Quads8& b) {
    const Float8 x = b.x - a.x + splat(aside), y = b.y - a.y, z = b.z - a.z;
    const Float8 length = sqrt(x * x + y * y + z * z);
    const Float8 inverse = splat(1) / length;
    return {x * inverse, y * inverse, z * inverse, length};
}

double added(Float8 v) {
    float lanes[8];
    store(lanes, v);
    double sum = 0;
    for (const float lane : lanes) sum += lane;
    return sum;
}

Float8 bounded(Float8 value, float limit) { return max(min(value, splat(limit)), splat(-limit)); }

/// The formulas of TimeScheme as what differs from uniform motion: a rounded coefficient then does
/// not change uniform motion, as it would substep after substep.
class Prediction {
public:
    explicit Prediction(const ClothStep& step)
        : h_(splat(step.h)),
          h_before_(splat(step.h_before)),
          earlier_(splat(step.earlier)),
          part_(splat(step.earlier / step.next)),
          drag_(splat(step.drag)),
          damping_(splat(step.damping * step.h)) {}

    Float8 forward(const ClothMotion& motion, uint32_t i) const {
        const Float8 before = load(motion.velocity + i);
        const Float8 velocity = before + ((before - load(motion.velocity_before + i)) * earlier_ +
                                          load(motion.acceleration + i) * h_ - before * damping_) *
                                             drag_;
        return velocity * h_ + (load(motion.moved + i) - velocity * h_before_) * part_;
    }

private:
    Float8 h_, h_before_, earlier_, part_, drag_, damping_;
};

void predict(const ClothMotion& motion, const ClothStep& step) {
    const Prediction prediction(step);
    for (uint32_t i = 0; i < motion.floats; i += 8) {
        const Float8 start = load(motion.at + i);
        store(motion.start + i, start);
        store(motion.at + i, bounded(start + prediction.forward(motion, i), farthest));
    }
}

/// What elimination leaves of a link for substitution.
struct Row {
    Float8 x, y, z, inverse_pivot, value, coupling;

    void save(float* to) const {
        store(to, x), store(to + 8, y), store(to + 16, z);
        store(to + 24, inverse_pivot), store(to + 32, value), store(to + 40, coupling);
    }
    explicit Row(const float* from)
        : x(load(from)),
          y(load(from + 8)),
          z(load(from + 16)),
          inverse_pivot(load(from + 24)),
          value(load(from + 32)),
          coupling(load(from + 40)) {}
    Row() : Row(zeros) {}

    static constexpr float zeros[cloth_row_floats] = {};
};

/// Elimination from the first link to the last. With w the inverse masses and
/// c_j = w_j (n_(j-1) . n_j), the tensions t solve
///   -c_j t_(j-1) + (w_j + w_(j+1) + softness_j) t_j - c_(j+1) t_(j+1) = error_j
void solve(float* at, const ClothChains& chains, const ChainBatch& batch, float* rows) {
    const uint32_t* particles = chains.particles + 8 * size_t{batch.first_particle};
    const float* rest = chains.rest + 8 * size_t{batch.first_link};
    const float* softness = chains.softness + 8 * size_t{batch.first_link};
    Quads8 a = load_quads(at, particles);
    Row before;
    for (uint32_t j = 0; j < batch.link_count; ++j) {
        const Quads8 b = load_quads(at, particles + 8 * (j + 1));
        const Direction n = direction(a, b);
        Row row;
        row.x = n.x, row.y = n.y, row.z = n.z;
        row.coupling = a.w * (before.x * n.x + before.y * n.y + before.z * n.z);
        const Float8 diagonal = (a.w + b.w) * splat(1 + regularisation) + (load(softness + 8 * j) + splat(least_pivot));
        // In exact arithmetic the pivot is larger; the rounding of some thousand links might take it away.
        const Float8 pivot = diagonal - row.coupling * row.coupling * before.inverse_pivot;
        row.inverse_pivot = splat(1) / max(pivot, diagonal * splat(regularisation));
        row.value = (n.length - load(rest + 8 * j) + row.coupling * before.value) * row.inverse_pivot;
        row.save(rows + cloth_row_floats * j);
        before = row;
        a = b;
    }
    // Substitution, from the last link to the first, moving each particle once both links are known.
    const Float8 none = splat(0);
    Float8 tension = none, coupling = none;
    Quads8 pull{none, none, none, none};  // of the link after the particle
    for (uint32_t j = batch.link_count; j-- > 0;) {
        const Row row(rows + cloth_row_floats * j);
        tension = row.value + coupling * row.inverse_pivot * tension;
        coupling = row.coupling;
        const Quads8 own{row.x * tension, row.y * tension, row.z * tension, none};
        Quads8 b = load_quads(at, particles + 8 * (j + 1));
        b.x = b.x + (pull.x - own.x) * b.w;
        b.y = b.y + (pull.y - own.y) * b.w;
        b.z = b.z + (pull.z - own.z) * b.w;
        store_quads(at, particles + 8 * (j + 1), b);
        pull = own;
    }
    a = load_quads(at, particles);
    a.x = a.x + pull.x * a.w;
    a.y = a.y + pull.y * a.w;
    a.z = a.z + pull.z * a.w;
    store_quads(at, particles, a);
}

double stored(const float* at, const ClothChains& chains, const ChainBatch& batch) {
    const uint32_t* particles = chains.particles + 8 * size_t{batch.first_particle};
    Quads8 a = load_quads(at, particles);
    Float8 sum = splat(0);
    for (uint32_t j = 0; j < batch.link_count; ++j) {
        const Quads8 b = load_quads(at, particles + 8 * (j + 1));
        const Float8 stretch = direction(a, b).length - load(chains.rest + 8 * size_t{batch.first_link + j});
        sum = sum + stretch * stretch * load(chains.stiffness + 8 * size_t{batch.first_link + j});
        a = b;
    }
    return added(sum) / 2;
}

void limit(float* at, const ClothLimits& limits, uint32_t count) {
    for (uint32_t i = 0; i < count; i += 8) {
        const Quads8 anchor = load_quads(at, limits.anchors + i);
        Quads8 p = load_quads(at, limits.particles + i);
        const Float8 x = p.x - anchor.x + splat(aside), y = p.y - anchor.y, z = p.z - anchor.z;
        const Float8 length = sqrt(x * x + y * y + z * z);
        const Float8 back = min(load(limits.distances + i) / length, splat(1)) - splat(1);
        p.x = p.x + x * back;
        p.y = p.y + y * back;
        p.z = p.z + z * back;
        store_quads(at, limits.particles + i, p);
    }
}

/// The rounding of the predicted position is no motion: velocities would wander by it.
double finish(const ClothMotion& motion, const ClothStep& step) {
    const Prediction prediction(step);
    const Float8 h = splat(step.h), ratio = splat(step.ratio), earlier = splat(step.earlier), half = splat(0.5f);
    double gain = 0;
    for (uint32_t block = 0; block < motion.floats; block += 256) {
        Float8 sum = splat(0);
        for (uint32_t i = block; i < motion.floats && i < block + 256; i += 8) {
            const Float8 start = load(motion.start + i), before = load(motion.velocity + i);
            const Float8 predicted = prediction.forward(motion, i);
            const Float8 rounding = predicted - ((start + predicted) - start);
            const Float8 forward = load(motion.at + i) - start + rounding;
            const Float8 bend = (forward * ratio - load(motion.moved + i)) * earlier;
            const Float8 velocity = bounded((forward + bend) / h, fastest);
            store(motion.moved + i, forward);
            store(motion.velocity_before + i, velocity);
            sum = sum + load(motion.mass + i) * ((velocity - before) * (velocity + before) * half -
                                                 load(motion.acceleration + i) * forward);
        }
        gain += added(sum);
    }
    return gain;
}

}  // namespace

const ClothKernels cloth_kernels = {predict, solve, stored, limit, finish};

}  // namespace gphys::GPHYS_ISA
