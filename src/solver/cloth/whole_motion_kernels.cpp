// Sums over the particles of cloth in double precision, and a change of their velocities (whole_motion_kernels.h). Lane
// i of a register sums particles i, i + 8, ..., so all instruction sets give the same bits.
#include "solver/cloth/whole_motion_kernels.h"

#include <algorithm>

#include "foundation/simd_double.h"

namespace gphys::GPHYS_ISA {
namespace {

/// Addresses of eight particles from the first float of one; behind the end that of the last.
class EightParticles {
public:
    EightParticles(const ClothMotion& motion, uint32_t first) : first_(first), last_(motion.floats - 4) {}

    GPHYS_INLINE Quads8 load_floats(const float* from) const {
        return load_quads([&](int i) GPHYS_INLINE_LAMBDA { return from + place(i); });
    }
    GPHYS_INLINE Four8 load(const float* from) const {
        return Four8([&](int i) GPHYS_INLINE_LAMBDA { return from + place(i); });
    }
    GPHYS_INLINE void store(float* to, const Quads8& quads) const {
        store_quads([&](int i) GPHYS_INLINE_LAMBDA { return to + place(i); }, quads);
    }
    /// 0 behind the end.
    template <class Number, class Lanes>
    GPHYS_INLINE Lanes without_repeated(Lanes values) const {
        if (first_ + 28 <= last_) return values;
        Number lanes[8];
        GPHYS_ISA::store(lanes, values);
        for (uint32_t i = 0; i < 8; ++i) {
            if (first_ + 4 * i > last_) lanes[i] = 0;
        }
        return GPHYS_ISA::load(lanes);
    }

private:
    GPHYS_INLINE uint32_t place(int i) const {
        const uint32_t wanted = first_ + 4 * static_cast<uint32_t>(i);
        return wanted < last_ ? wanted : last_;
    }

    uint32_t first_, last_;
};

GPHYS_INLINE Vec<Double8> vector_of(const Four8& quads) { return {quads.x, quads.y, quads.z}; }
GPHYS_INLINE Vec<Float8> vector_of(const Quads8& quads) { return {quads.x, quads.y, quads.z}; }
GPHYS_INLINE Vec<Double8> widened(const Vec<Float8>& v) { return {widened(v.x), widened(v.y), widened(v.z)}; }

double sum_of(Double8 v) {
    double lanes[8];
    store(lanes, v);
    double sum = 0;
    for (const double lane : lanes) sum += lane;
    return sum;
}
Vec<double> sum_of(const Vec<Double8>& v) { return {sum_of(v.x), sum_of(v.y), sum_of(v.z)}; }
ClothMoments<double>::Motion sum_of(const ClothMoments<Double8>::Motion& motion) {
    return {sum_of(motion.first_moment), sum_of(motion.momentum), sum_of(motion.angular_momentum)};
}

ClothMoments<double> moments(const ClothMotion& motion) {
    ClothMoments<Double8> sums{};
    for (uint32_t first = 0; first < motion.floats; first += 32) {
        const EightParticles eight(motion, first);
        const Vec<Double8> start = vector_of(eight.load(motion.start)), at = vector_of(eight.load(motion.at));
        const Vec<Double8> earlier = vector_of(eight.load(motion.velocity_before));
        const Vec<Double8> velocity = vector_of(eight.load(motion.velocity));
        const Four8 fall = eight.load(motion.acceleration);
        const Double8 mass = eight.without_repeated<double>(fall.w);
        const Vec<Double8> load = vector_of(fall) * mass, weighted = at * mass;

        sums.mass = sums.mass + mass;
        sums.before.add(mass, start, earlier);
        sums.after.add(mass, at, velocity);
        sums.squares += by_component(weighted, at);
        sums.products += Vec<Double8>{weighted.y * at.z, weighted.z * at.x, weighted.x * at.y};
        sums.force += load;
        sums.torque += cross(start + at, load);
        sums.energy = sums.energy + dot(velocity, velocity) * mass;
        const Double8 faster = dot(velocity - earlier, velocity + earlier) * mass * Double8(0.5);
        sums.gain = sums.gain + (faster - dot(load, at - start));
    }
    return {sum_of(sums.mass),  sum_of(sums.before), sum_of(sums.after),  sum_of(sums.squares), sum_of(sums.products),
            sum_of(sums.force), sum_of(sums.torque), sum_of(sums.energy), sum_of(sums.gain)};
}

/// A particle loses m (v0 + a h - v1 (1 + d h)): as in the backward formula, drag is that of the velocity at the end.
/// So there is none at rest. Its moment is the difference of the angular momenta and the mean torque.
Momentum lost(const ClothMotion& motion, double damping, double h) {
    constexpr double strongest = 1e6;  // nothing moves; and no product overflows
    const Float8 seconds = splat(static_cast<float>(h)), half = splat(static_cast<float>(h / 2)),
                 undamped = splat(static_cast<float>(std::min(1 + damping * h, strongest)));
    Vec<Double8> linear{}, angular{};
    for (uint32_t first = 0; first < motion.floats; first += 32) {
        const EightParticles eight(motion, first);
        const Vec<Float8> at = vector_of(eight.load_floats(motion.at)),
                          start = vector_of(eight.load_floats(motion.start));
        const Vec<Float8> before = vector_of(eight.load_floats(motion.velocity_before)),
                          after = vector_of(eight.load_floats(motion.velocity));
        const Quads8 fall = eight.load_floats(motion.acceleration);
        const Float8 mass = eight.without_repeated<float>(fall.w);
        const Vec<Float8> fell = vector_of(fall);
        const Vec<Float8> impulse = (before + fell * seconds - after * undamped) * mass;
        linear += widened(impulse);
        angular += widened(cross(at, impulse) - cross(at - start, before + fell * half) * mass);
    }
    return {sum_of(linear), sum_of(angular)};
}

void move(const ClothMotion& motion, double kept, const Vec<double>& velocity, const Vec<double>& angular_velocity) {
    const auto in_all_lanes = [](const Vec<double>& v) { return Vec<Double8>{v.x, v.y, v.z}; };
    const Vec<Double8> along = in_all_lanes(velocity), turning = in_all_lanes(angular_velocity);
    for (uint32_t first = 0; first < motion.floats; first += 32) {
        const EightParticles eight(motion, first);
        const Four8 before = eight.load(motion.velocity);
        const Vec<Double8> after =
            vector_of(before) * Double8(kept) + (along + cross(turning, vector_of(eight.load(motion.at))));
        eight.store(motion.velocity, {narrowed(after.x), narrowed(after.y), narrowed(after.z), narrowed(before.w)});
    }
}

void settle(const ClothMotion& motion, float kept_speed, float kept_way, const Matrix<double>& turn,
            const Vec<double>& shift, double rate) {
    const auto in_all_lanes = [](const Vec<double>& v) {
        return Vec<Float8>{splat(static_cast<float>(v.x)), splat(static_cast<float>(v.y)),
                           splat(static_cast<float>(v.z))};
    };
    const Vec<Float8> x = in_all_lanes(turn.x), y = in_all_lanes(turn.y), z = in_all_lanes(turn.z),
                      shifted = in_all_lanes(shift);
    const Float8 speed = splat(kept_speed), way = splat(kept_way), per_second = splat(static_cast<float>(rate)),
                 none = splat(0);
    for (uint32_t first = 0; first < motion.floats; first += 32) {
        const EightParticles eight(motion, first);
        const Quads8 at = eight.load_floats(motion.at), v = eight.load_floats(motion.velocity);
        const Vec<Float8> start = vector_of(eight.load_floats(motion.start));
        const Mask8 pinned = at.w <= none;
        Vec<Float8> carried = x * start.x + y * start.y + z * start.z + shifted;
        carried = {choose(pinned, none, carried.x), choose(pinned, none, carried.y), choose(pinned, none, carried.z)};
        const Vec<Float8> with = carried * per_second;
        const Vec<Float8> slower = with + (vector_of(v) - with) * speed;
        const Vec<Float8> end = start + (carried + (vector_of(at) - start - carried) * way);
        eight.store(motion.at, {end.x, end.y, end.z, at.w});
        eight.store(motion.velocity, {slower.x, slower.y, slower.z, v.w});
    }
}

}  // namespace

const WholeMotionKernels whole_motion_kernels = {moments, lost, move, settle};

}  // namespace gphys::GPHYS_ISA
