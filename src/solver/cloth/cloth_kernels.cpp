// Kernels of cloth: elimination along eight chains side by side (Thomas's algorithm), with or without contact planes
// and joined bodies; limits; prediction; velocities; energies (cloth_kernels.h).
#include "solver/cloth/cloth_kernels.h"

#include <algorithm>

#include "foundation/simd.h"
#include "foundation/vec.h"

namespace gphys::GPHYS_ISA {
namespace {

// The compliance that every link has, relative to the inverse masses at its ends. It keeps the pivots of a straight
// chain between two pins away from zero. It leaves a millionth of the error. It bounds the sideways correction of a
// chain that is straight within an angle d: error * d / (d^2 + this) is at most error / (2 sqrt(this)), 500 times the
// error of pins too far apart.
constexpr float regularisation = 1e-6f;
// Keeps the pivot of a link between two pins from zero. It vanishes beside the inverse mass of any free particle, which
// is at least 1e-6.
constexpr float least_pivot = 1e-20f;
// Coincident particles separate along x. Added to any other coordinate difference it vanishes.
constexpr float aside = 1e-18f;
// A smaller square underflows, and so does subtracting `aside` again. Such a link has no direction, and does not pull.
constexpr float least_length = 1e-19f;
// Particles stop at the border of the world and at three times the speed of light, so that no square overflows.
constexpr float farthest = 2e15f, fastest = 1e9f;

struct Direction {
    Float8 x, y, z;  // unit
    Float8 length;
};

inline Direction direction(const Quads8& a, const Quads8& b) {
    const Float8 x = b.x - a.x + splat(aside), y = b.y - a.y, z = b.z - a.z;
    const Float8 length = sqrt(x * x + y * y + z * z);
    const Float8 inverse = splat(1) / max(length, splat(least_length));
    return {x * inverse, y * inverse, z * inverse, length};
}

double sum_of_lanes(Float8 v) {
    float lanes[8];
    store(lanes, v);
    double sum = 0;
    for (const float lane : lanes) sum += lane;
    return sum;
}

Float8 bounded(Float8 value, float limit) { return max(min(value, splat(limit)), splat(-limit)); }

/// The formulas of TimeScheme, written as differences from uniform motion. So rounded coefficients do not change
/// uniform motion, which would add up substep by substep.
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
        const Float8 acceleration = without_last_of_quads(load(motion.acceleration + i));
        const Float8 velocity =
            before +
            ((before - load(motion.velocity_before + i)) * earlier_ + acceleration * h_ - before * damping_) * drag_;
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

/// The contact model of particles without contacts.
struct NoSurfaces {
    // In exact arithmetic the pivot is larger, but the rounding of some thousand links might cancel it.
    static constexpr float least_pivot_part = regularisation;
    struct Normals {};
    static Normals normals(const uint32_t*) { return {}; }
    /// The mobility of a link in this direction: the sum of its ends' inverse masses along it.
    static Float8 mobility(const Quads8& a, const Normals&, const Quads8& b, const Normals&, const Direction&) {
        return (a.w + b.w) * splat(1 + regularisation);
    }
    /// The coupling between the links before and after a particle.
    static Float8 coupling(const Quads8& a, const Normals&, const Row& before, const Direction& n) {
        return a.w * (before.x * n.x + before.y * n.y + before.z * n.z);
    }
    static void move(float* at, const uint32_t* particles, const Quads8& pull) {
        Quads8 a = load_quads(at, particles);
        a.x = a.x + pull.x * a.w;
        a.y = a.y + pull.y * a.w;
        a.z = a.z + pull.z * a.w;
        store_quads(at, particles, a);
    }
};

void add_pull(float* pulls, const uint32_t* particles, const Quads8& pull) {
    Quads8 sum = load_quads(pulls, particles);
    sum.x = sum.x + pull.x;
    sum.y = sum.y + pull.y;
    sum.z = sum.z + pull.z;
    store_quads(pulls, particles, sum);
}

/// The same, adding up the pulls of links.
struct NoSurfacesPulling : NoSurfaces {
    float* pulls;

    explicit NoSurfacesPulling(float* sums) : pulls(sums) {}
    void move(float* at, const uint32_t* particles, const Quads8& pull) const {
        NoSurfaces::move(at, particles, pull);
        add_pull(pulls, particles, pull);
    }
};

/// The part of a pull away from the contact plane that the plane holds. `before`: the pull of previous chains away from
/// it, minus the normal force.
inline Float8 held_part(Float8 pull, Float8 before) {
    return pull - (max(before + pull, splat(0)) - max(before, splat(0)));
}

/// The contact model of particles with contact planes. With the normal N of its plane a particle has the inverse mass w
/// (1 - N N^T), so the system treats it as moving along the plane. The total pull of all chains so far away from the
/// plane, in excess of the normal force, moves the particle off, and later chains may move it back: the accumulated
/// pull is clamped, not each single one (Catto 2005, "Iterative dynamics with temporal coherence"). Clamping single
/// pulls would let a pushing link throw particles off, and none would bring them back.
struct Surfaces {
    // A chain between two held particles is infeasible: its last pivot would be 0 and throw it aside. The pivots of a
    // chain with a free end are at least half of the diagonal.
    static constexpr float least_pivot_part = 0.5f;
    // A link has at least this fraction of its ends' inverse masses, even along the normals of both. A particle that it
    // pulls off the plane then moves freely, by twice the error at most.
    static constexpr float least_mobility = 0.5f;

    const ClothSurfaces& arrays;

    using Normals = Quads8;
    /// 0 for particles that have been pulled off.
    Normals normals(const uint32_t* particles) const {
        const Quads8 normal = load_quads(arrays.normals, particles), pulled = load_quads(arrays.pulls, particles);
        const Mask8 held = product(pulled, normal) <= normal.w;
        const Float8 none = splat(0);
        return {choose(held, normal.x, none), choose(held, normal.y, none), choose(held, normal.z, none), none};
    }
    static Float8 mobility(const Quads8& a, const Normals& at_a, const Quads8& b, const Normals& at_b,
                           const Direction& n) {
        const Float8 off_a = along(n, at_a), off_b = along(n, at_b), sum = a.w + b.w;
        const Float8 free = sum - a.w * off_a * off_a - b.w * off_b * off_b;
        return max(free, sum * splat(least_mobility)) + sum * splat(regularisation);
    }
    static Float8 coupling(const Quads8& a, const Normals& at_a, const Row& before, const Direction& n) {
        const Float8 straight = before.x * n.x + before.y * n.y + before.z * n.z;
        const Float8 off = before.x * at_a.x + before.y * at_a.y + before.z * at_a.z;
        return a.w * (straight - off * along(n, at_a));
    }
    void move(float* at, const uint32_t* particles, const Quads8& pull) const {
        Quads8 a = load_quads(at, particles);
        const Quads8 normal = load_quads(arrays.normals, particles), pulled = load_quads(arrays.pulls, particles);
        const Float8 off = product(pull, normal), before = product(pulled, normal) - normal.w;
        const Float8 held = held_part(off, before);
        a.x = a.x + (pull.x - normal.x * held) * a.w;
        a.y = a.y + (pull.y - normal.y * held) * a.w;
        a.z = a.z + (pull.z - normal.z * held) * a.w;
        store_quads(at, particles, a);
        store_quads(arrays.pulls, particles, {pulled.x + pull.x, pulled.y + pull.y, pulled.z + pull.z, pulled.w});
    }

private:
    static Float8 product(const Quads8& a, const Quads8& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    static Float8 along(const Direction& n, const Normals& normal) {
        return n.x * normal.x + n.y * normal.y + n.z * normal.z;
    }
};

/// The contact model of joined cloth: particles have matrices W as inverse masses. In contact these become W - W N (W
/// N)^T / (N . W N), the inverse mass without motion along N.
struct Tethered {
    // Without contact, N and N . W N are 0, and the subtracted term is 0, too.
    static constexpr float least_inertia = 1e-30f;

    const ClothTethers& arrays;
    // The last pivot of a chain with a weight at its end is that of the weight.
    float least_pivot_part = arrays.has_contact ? Surfaces::least_pivot_part : NoSurfaces::least_pivot_part;

    struct Normals {
        Quads8 diagonal, off;       // of W
        Vec<Float8> normal, along;  // N, W N
        Float8 inverse;             // 1 / (N . W N)
    };
    static Float8 product(const Vec<Float8>& a, const Direction& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    static Vec<Float8> times(const Quads8& diagonal, const Quads8& off, Float8 x, Float8 y, Float8 z) {
        return {diagonal.x * x + off.z * y + off.y * z, off.z * x + diagonal.y * y + off.x * z,
                off.y * x + off.x * y + diagonal.z * z};
    }
    Normals normals(const uint32_t* particles) const {
        Normals out;
        out.diagonal = load_quads(arrays.diagonal, particles);
        out.off = load_quads(arrays.off, particles);
        const Quads8 normal = load_quads(arrays.surfaces.normals, particles);
        out.normal = {normal.x, normal.y, normal.z};
        out.along = times(out.diagonal, out.off, normal.x, normal.y, normal.z);
        const Float8 inertia = normal.x * out.along.x + normal.y * out.along.y + normal.z * out.along.z;
        out.inverse = splat(1) / max(inertia, splat(least_inertia));
        return out;
    }
    static Float8 off_plane(const Quads8& pull, const Normals& at) {
        return pull.x * at.along.x + pull.y * at.along.y + pull.z * at.along.z;
    }
    /// a . (W - W N (W N)^T / (N . W N)) b
    static Float8 through(const Normals& at, Float8 ax, Float8 ay, Float8 az, const Direction& b) {
        const Vec<Float8> moved = times(at.diagonal, at.off, ax, ay, az);
        const Float8 off = at.along.x * ax + at.along.y * ay + at.along.z * az;
        return product(moved, b) - off * product(at.along, b) * at.inverse;
    }
    static Float8 mobility(const Quads8& a, const Normals& at_a, const Quads8& b, const Normals& at_b,
                           const Direction& n) {
        const Float8 free =
            a.w * max(through(at_a, n.x, n.y, n.z, n), splat(0)) + b.w * max(through(at_b, n.x, n.y, n.z, n), splat(0));
        return free + (a.w + b.w) * splat(regularisation);
    }
    static Float8 coupling(const Quads8& a, const Normals& at_a, const Row& before, const Direction& n) {
        return a.w * through(at_a, before.x, before.y, before.z, n);
    }
    void move(float* at, const uint32_t* particles, const Quads8& pull) const {
        Quads8 a = load_quads(at, particles);
        const Normals here = normals(particles);
        const Float8 normal_force = load_quads(arrays.surfaces.normals, particles).w;
        const Quads8 pulled = load_quads(arrays.surfaces.pulls, particles);
        const Float8 held = held_part(off_plane(pull, here), off_plane(pulled, here) - normal_force) * here.inverse;
        const Vec<Float8> displacement = times(here.diagonal, here.off, pull.x - here.normal.x * held,
                                               pull.y - here.normal.y * held, pull.z - here.normal.z * held);
        a.x = a.x + displacement.x * a.w;
        a.y = a.y + displacement.y * a.w;
        a.z = a.z + displacement.z * a.w;
        store_quads(at, particles, a);
        add_pull(arrays.surfaces.pulls, particles, pull);
    }
};

/// Eliminates from the first link to the last. Let w be the inverse masses and c_j = w_j (n_(j-1) . n_j). The tensions
/// t solve
///   -c_j t_(j-1) + (w_j + w_(j+1) + softness_j) t_j - c_(j+1) t_(j+1) = error_j
/// A link that only pulls is in a chain of its own: it has no tension while it is short enough.
template <bool is_limit, class ContactModel>
void solve_batch(float* at, const ContactModel& surfaces, const ClothChains& chains, const ChainBatch& batch,
                 float* rows) {
    const uint32_t* particles = chains.particles + 8 * size_t{batch.first_particle};
    const float* rest = chains.rest + 8 * size_t{batch.first_link};
    const float* softness = chains.softness + 8 * size_t{batch.first_link};
    Quads8 a = load_quads(at, particles);
    auto at_a = surfaces.normals(particles);
    Row before;
    for (uint32_t j = 0; j < batch.link_count; ++j) {
        const Quads8 b = load_quads(at, particles + 8 * (j + 1));
        const auto at_b = surfaces.normals(particles + 8 * (j + 1));
        const Direction n = direction(a, b);
        Row row;
        row.x = n.x, row.y = n.y, row.z = n.z;
        row.coupling = surfaces.coupling(a, at_a, before, n);
        const Float8 diagonal = surfaces.mobility(a, at_a, b, at_b, n) + (load(softness + 8 * j) + splat(least_pivot));
        const Float8 pivot = diagonal - row.coupling * row.coupling * before.inverse_pivot;
        const Float8 inverse = splat(1) / max(pivot, diagonal * splat(surfaces.least_pivot_part));
        // The tension of a rigid link between two held particles follows from nothing. What its length lacks is
        // rounding, and divided by the least pivot it would be the largest pull on their models.
        row.inverse_pivot = select(diagonal <= splat(least_pivot), splat(0), inverse);
        Float8 error = n.length - load(rest + 8 * j);
        if (is_limit) error = max(error, splat(0));
        row.value = (error + row.coupling * before.value) * row.inverse_pivot;
        row.save(rows + cloth_row_floats * j);
        before = row;
        a = b;
        at_a = at_b;
    }
    // Substitutes from the last link to the first, moving each particle once both its links are known.
    const Float8 none = splat(0);
    Float8 tension = none, coupling = none;
    Quads8 pull{none, none, none, none};  // of the link after the particle
    for (uint32_t j = batch.link_count; j-- > 0;) {
        const Row row(rows + cloth_row_floats * j);
        tension = row.value + coupling * row.inverse_pivot * tension;
        coupling = row.coupling;
        const Quads8 own{row.x * tension, row.y * tension, row.z * tension, none};
        surfaces.move(at, particles + 8 * (j + 1), {pull.x - own.x, pull.y - own.y, pull.z - own.z, none});
        pull = own;
    }
    surfaces.move(at, particles, pull);
}

template <class ContactModel>
void solve_either(float* at, const ContactModel& surfaces, const ClothChains& chains, const ChainBatch& batch,
                  float* rows) {
    if (batch.limit) {
        solve_batch<true>(at, surfaces, chains, batch, rows);
    } else {
        solve_batch<false>(at, surfaces, chains, batch, rows);
    }
}

void solve(float* at, const ClothChains& chains, const ChainBatch& batch, float* rows) {
    solve_either(at, NoSurfaces{}, chains, batch, rows);
}

void solve_joined(float* at, const ClothTethers& tethers, const ClothChains& chains, const ChainBatch& batch,
                  float* rows) {
    solve_either(at, Tethered{tethers}, chains, batch, rows);
}

void solve_with_contacts(float* at, const ClothSurfaces& surfaces, const ClothChains& chains, const ChainBatch& batch,
                         float* rows) {
    solve_either(at, Surfaces{surfaces}, chains, batch, rows);
}

void solve_pulling(float* at, float* pulls, const ClothChains& chains, const ChainBatch& batch, float* rows) {
    solve_either(at, NoSurfacesPulling(pulls), chains, batch, rows);
}

/// The substitution of solve_batch.
void find_tensions(float* rows, uint32_t link_count) {
    Float8 tension = splat(0), coupling = splat(0);
    for (uint32_t j = link_count; j-- > 0;) {
        const Row row(rows + cloth_row_floats * j);
        tension = row.value + coupling * row.inverse_pivot * tension;
        coupling = row.coupling;
        store(rows + cloth_row_floats * j, tension);
    }
}

uint32_t list_strained(const float* at, const ClothChains& chains, const ChainBatch& batch, float part,
                       uint32_t* places) {
    const uint32_t* particles = chains.particles + 8 * size_t{batch.first_particle};
    const float* rest = chains.rest + 8 * size_t{batch.first_link};
    const float* softness = chains.softness + 8 * size_t{batch.first_link};
    Quads8 a = load_quads(at, particles);
    uint32_t count = 0;
    for (uint32_t j = 0; j < batch.link_count; ++j, particles += 8, rest += 8, softness += 8) {
        const Quads8 b = load_quads(at, particles + 8);
        const Float8 error = direction(a, b).length - load(rest);
        const Mask8 strained = load(rest) * splat(part) <= (batch.limit ? error : abs(error));
        const uint32_t lanes = bits(strained & (load(softness) <= splat(0)));
        for (uint32_t lane = 0; lanes >> lane != 0; ++lane) {
            if (lanes >> lane & 1) places[count++] = static_cast<uint32_t>(rest - chains.rest) + lane;
        }
        a = b;
    }
    return count;
}

/// Writes the indices of particles that are not pinned and for which is(their eight positions, balls, indices).
template <class Is>
uint32_t list_by_ball(const float* at, const float* balls, uint32_t particles, uint32_t* listed, Is&& is) {
    uint32_t count = 0;
    for (uint32_t first = 0; first < particles; first += 8) {
        uint32_t index[8];
        for (uint32_t lane = 0; lane < 8; ++lane) index[lane] = std::min(first + lane, particles - 1);
        const Quads8 p = load_quads(at, index), ball = load_quads(balls, index);
        uint32_t lanes = bits(is(p, ball, index)) & ~bits(p.w <= splat(0));
        if (particles - first < 8) lanes &= (1u << (particles - first)) - 1;
        for (uint32_t lane = 0; lanes >> lane != 0; ++lane) {
            if (lanes >> lane & 1) listed[count++] = first + lane;
        }
    }
    return count;
}

inline Float8 squared_distance(const Quads8& a, const Quads8& b) {
    const Float8 x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z;
}

uint32_t list_leaving(const float* at, const float* velocity, const float* balls, uint32_t particles, float h,
                      float fall, uint32_t* leaving) {
    return list_by_ball(at, balls, particles, leaving, [&](const Quads8& p, const Quads8& ball, const uint32_t* index) {
        const Quads8 v = load_quads(velocity, index);
        const Float8 travel = splat(h) * (sqrt(v.x * v.x + v.y * v.y + v.z * v.z) + splat(fall));
        return sqrt(ball.w) <= sqrt(squared_distance(p, ball)) + travel;
    });
}

uint32_t list_outside(const float* at, const float* balls, uint32_t particles, uint32_t* outside) {
    return list_by_ball(at, balls, particles, outside, [](const Quads8& p, const Quads8& ball, const uint32_t*) {
        return ball.w <= squared_distance(p, ball);
    });
}

double stored(const float* at, const ClothChains& chains, const ChainBatch& batch) {
    const uint32_t* particles = chains.particles + 8 * size_t{batch.first_particle};
    Quads8 a = load_quads(at, particles);
    Float8 sum = splat(0);
    for (uint32_t j = 0; j < batch.link_count; ++j) {
        const Quads8 b = load_quads(at, particles + 8 * (j + 1));
        Float8 stretch = direction(a, b).length - load(chains.rest + 8 * size_t{batch.first_link + j});
        if (batch.limit) stretch = max(stretch, splat(0));
        sum = sum + stretch * stretch * load(chains.stiffness + 8 * size_t{batch.first_link + j});
        a = b;
    }
    return sum_of_lanes(sum) / 2;
}

/// Calls moved(i, x, y, z) for each eight floats from the i-th on.
template <class Moved>
void limit_each(float* at, const ClothLimits& limits, uint32_t count, Moved&& moved) {
    for (uint32_t i = 0; i < count; i += 8) {
        const Quads8 anchor = load_quads(at, limits.anchors + i);
        Quads8 p = load_quads(at, limits.particles + i);
        const Float8 x = p.x - anchor.x + splat(aside), y = p.y - anchor.y, z = p.z - anchor.z;
        const Float8 square = x * x + y * y + z * z, most = load(limits.distances + i);
        if (bits(square <= most * most) == 0xff) continue;
        const Float8 back = min(most / max(sqrt(square), splat(least_length)), splat(1)) - splat(1);
        p.x = p.x + x * back;
        p.y = p.y + y * back;
        p.z = p.z + z * back;
        store_quads(at, limits.particles + i, p);
        moved(i, x * back, y * back, z * back);
    }
}

void limit(float* at, const ClothLimits& limits, uint32_t count) {
    limit_each(at, limits, count, [](uint32_t, Float8, Float8, Float8) {});
}

void limit_pulling(float* at, const ClothLimits& limits, uint32_t count, const float* acceleration, float* pulls) {
    limit_each(at, limits, count, [&](uint32_t i, Float8 x, Float8 y, Float8 z) {
        float lanes[3][8];
        store(lanes[0], x), store(lanes[1], y), store(lanes[2], z);
        for (uint32_t lane = 0; lane < 8; ++lane) {
            float* pull = pulls + 4 * size_t{limits.anchors[i + lane]};
            const float weight = acceleration[4 * size_t{limits.particles[i + lane]} + 3];
            for (int k = 0; k < 3; ++k) pull[k] -= lanes[k][lane] * weight;
        }
    });
}

/// The solved value; a particle that has become NaN or infinite stays where it was.
inline Float8 solved(const ClothMotion& motion, uint32_t i, Float8 start) {
    const Float8 at = load(motion.at + i);
    const Mask8 found = abs(at) <= splat(farthest);
    if (bits(found) == 0xff) return at;
    const Float8 kept = choose(found, at, start);
    store(motion.at + i, kept);
    return kept;
}

/// The rounding of the predicted position must not count as motion, or velocities would drift.
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
            const Float8 forward = solved(motion, i, start) - start + rounding;
            const Float8 bend = (forward * ratio - load(motion.moved + i)) * earlier;
            const Float8 velocity = bounded((forward + bend) / h, fastest);
            store(motion.moved + i, forward);
            store(motion.velocity_before + i, velocity);
            const Float8 fall = load(motion.acceleration + i);
            sum = sum + last_of_quads(fall) *
                            ((velocity - before) * (velocity + before) * half - without_last_of_quads(fall) * forward);
        }
        gain += sum_of_lanes(sum);
    }
    return gain;
}

double gain(const ClothMotion& motion) {
    const Float8 half = splat(0.5f);
    Float8 sum = splat(0);
    for (uint32_t i = 0; i < motion.floats; i += 8) {
        const Float8 now = load(motion.velocity + i), before = load(motion.velocity_before + i);
        const Float8 fall = load(motion.acceleration + i), forward = load(motion.at + i) - load(motion.start + i);
        sum = sum +
              last_of_quads(fall) * ((now - before) * (now + before) * half - without_last_of_quads(fall) * forward);
    }
    return sum_of_lanes(sum);
}

/// The same velocity for two particles.
Float8 twice(const float (&velocity)[3]) {
    const float quads[8] = {velocity[0], velocity[1], velocity[2], 0, velocity[0], velocity[1], velocity[2], 0};
    return load(quads);
}

double kinetic(const ClothMotion& motion, const float (&drift)[3]) {
    const Float8 along = twice(drift);
    Float8 sum = splat(0);
    for (uint32_t i = 0; i < motion.floats; i += 8) {
        const Float8 inner = load(motion.velocity + i) - along;
        sum = sum + last_of_quads(load(motion.acceleration + i)) * (inner * inner);
    }
    return sum_of_lanes(sum) / 2;
}

void slow(const ClothMotion& motion, const float (&drift)[3], float kept) {
    const Float8 along = twice(drift), part = splat(kept);
    for (uint32_t i = 0; i < motion.floats; i += 8) {
        const Float8 velocity = load(motion.velocity + i);
        const Float8 slower = bounded(along + (velocity - along) * part, fastest);
        const Mask8 held = last_of_quads(load(motion.acceleration + i)) <= splat(0);
        store(motion.velocity + i, choose(held, velocity, slower));
    }
}

void settle(const ClothMotion& motion, float kept_speed, float kept_way) {
    const Float8 speed = splat(kept_speed), way = splat(kept_way);
    for (uint32_t i = 0; i < motion.floats; i += 8) {
        const Float8 start = load(motion.start + i);
        store(motion.at + i, start + (load(motion.at + i) - start) * way);
        store(motion.velocity + i, load(motion.velocity + i) * speed);
    }
}

}  // namespace

const ClothKernels cloth_kernels = {predict,       solve,        solve_with_contacts,
                                    solve_pulling, solve_joined, find_tensions,
                                    list_strained, list_leaving, list_outside,
                                    stored,        limit,        limit_pulling,
                                    finish,        gain,         kinetic,
                                    slow,          settle};

}  // namespace gphys::GPHYS_ISA
