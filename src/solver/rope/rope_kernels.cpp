// Newton's method on all positions and tensions of a rope, as in rope_direct.cpp, by elimination of one node after the
// other. The geometric stiffness k (1 - n n^T) of a link acts as k in all directions if its tension t is replaced by t'
// = t - k n.u, where u is the relative displacement of its ends: its row n.u - r t = -error becomes (1 - r k) n.u - r
// t' = -error. Then a link couples two nodes by numbers and vectors instead of matrices, and a node passes on the
// inverse of a symmetric 3 x 3 matrix.
#include "solver/rope/rope_nodes.h"

#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

namespace {

// Newton's method squares the error in each iteration: two iterations do for a swinging rope, four for a whip.
constexpr int most_iterations = 4;
// Coincident particles separate along x. Added to any other difference of coordinates it is lost, and its square is
// still a double.
constexpr double aside = 1e-150;
// GPHYS_MAX_COORDINATE, as a float: a node that leaves the range of coordinates stops there.
constexpr double farthest = 1e15f;

template <class Value>
struct Symmetric3 {
    Value xx, xy, xz, yy, yz, zz;

    Vec<Value> operator*(const Vec<Value>& v) const {
        return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
    }
    Symmetric3& operator+=(const Symmetric3& s) {
        xx = xx + s.xx, xy = xy + s.xy, xz = xz + s.xz, yy = yy + s.yy, yz = yz + s.yz, zz = zz + s.zz;
        return *this;
    }
    /// one / this, by L D L^T. For a pinned node, whose one is 0, the inverse is 0.
    Symmetric3 inverse(const Value& one) const {
        return inverse(one, [](const Value& pivot) { return pivot; });
    }
    template <class Bounded>
    Symmetric3 inverse(const Value& one, const Bounded& bounded) const {
        const Value ix = one / bounded(xx), lyx = xy * ix, lzx = xz * ix;
        const Value iy = one / bounded(yy - lyx * xy), below = yz - lyx * xz, lzy = below * iy;
        const Value iz = one / bounded(zz - lzx * xz - lzy * below), mzx = lyx * lzy - lzx;
        const Value ixz = mzx * iz, jyz = lzy * iz, jxy = lyx * iy;
        return {ix + lyx * jxy + mzx * ixz, -(jxy + lzy * ixz), ixz, iy + lzy * jyz, -jyz, iz};
    }
};

/// The prediction without constraints, and Newton's initial guess: the previous motion, with constraints, continued.
template <class Value>
struct Course {
    Vec<Value> history, predicted, onward;
};

template <int lanes>
Course<Doubles<lanes>> by_backward_formula(const RopeNode<lanes>& node, const RopeStep<lanes>& step) {
    using Value = Doubles<lanes>;
    const Value h = load(step.h), now = load(step.now), earlier = load(step.earlier), curve = load(step.curve);
    const Vec<Value> at = load3(node.position), velocity = load3(node.velocity);
    const Vec<Value> velocity_before = load3(node.start_velocity);
    const Vec<Value> history = at * now - load3(node.start) * earlier;
    const Vec<Value> falling =
        (velocity * now - velocity_before * earlier + load3(node.acceleration) * h) * load(step.drag);
    const Vec<Value> predicted = (history + falling * h) * load(step.inverse_next);
    const Vec<Value> onward = at + velocity * h + (velocity - velocity_before) * curve;
    return {history, predicted, select(all_of<lanes>(0) < curve, onward, predicted)};
}

/// `force`, in newtons, is that of the links at the beginning.
template <int lanes>
Course<Doubles<lanes>> by_trapezoid(const RopeNode<lanes>& node, const RopeStep<lanes>& step,
                                    const Vec<Doubles<lanes>>& force) {
    using Value = Doubles<lanes>;
    const Value h = load(step.h);
    const Vec<Value> at = load3(node.position), velocity = load3(node.velocity);
    const Vec<Value> fall = load3(node.acceleration);
    const Vec<Value> rate = fall + force * load(node.inverse_mass) - velocity * load(step.damping);
    const Vec<Value> history = at + velocity * h;
    const Vec<Value> falling = (velocity + (rate + fall) * h) * load(step.drag);
    // The step h of the trapezoid rule is half of the time that passes.
    return {history, history + falling * h, at + (velocity + rate * h) * (h + h)};
}

template <int lanes>
void begin(RopeNode<lanes>& node, const Course<Doubles<lanes>>& course) {
    const Vec<Doubles<lanes>> at = load3(node.position);
    const auto is_free = all_of<lanes>(0) < load(node.free);
    store3(node.earlier_velocity, load3(node.start_velocity));
    store3(node.start, at);
    store3(node.start_velocity, load3(node.velocity));
    store3(node.history, course.history);
    store3(node.predicted, select(is_free, course.predicted, at));
    store3(node.position, select(is_free, course.onward, at));
}

template <int lanes>
void begin_trapezoid(RopeNode<lanes>* nodes, uint32_t count, const RopeStep<lanes>& step) {
    using Value = Doubles<lanes>;
    const Value none = all_of<lanes>(0), one = all_of<lanes>(1), hair = all_of<lanes>(aside);
    Vec<Value> arriving{none, none, none}, at = load3(nodes[0].position);
    for (uint32_t i = 0; i < count; ++i) {
        Vec<Value> leaving{none, none, none}, next = at;
        if (i + 1 < count) {
            next = load3(nodes[i + 1].position);
            const Vec<Value> along = next - at;
            const Value length = square_root(dot(along, along) + hair * hair);
            leaving = Vec<Value>{along.x + hair, along.y, along.z} * (load(nodes[i].tension) * (one / length));
        }
        begin(nodes[i], by_trapezoid(nodes[i], step, leaving - arriving));
        arriving = leaving;
        at = next;
    }
}

template <class Value>
Value in_range(const Value& x, const Value& limit) {
    return largest(least(x, limit), -limit);
}

template <int lanes>
void finish(RopeNode<lanes>& node, const RopeStep<lanes>& step, RopeBounds<lanes>& bounds) {
    using Value = Doubles<lanes>;
    const Value limit = all_of<lanes>(farthest), none = all_of<lanes>(0);
    const auto is_free = none < load(node.free);
    Vec<Value> at = load3(node.position);
    at = {in_range(at.x, limit), in_range(at.y, limit), in_range(at.z, limit)};
    store3(node.position, at);
    const Vec<Value> velocity = (at * load(step.next) - load3(node.history)) * load(step.rate);
    store3(node.velocity, select(is_free, velocity, load3(node.velocity)));
    const Vec<Value> low = load3(bounds.low), high = load3(bounds.high);
    store3(bounds.low, Vec<Value>{least(low.x, at.x), least(low.y, at.y), least(low.z, at.z)});
    store3(bounds.high, Vec<Value>{largest(high.x, at.x), largest(high.y, at.y), largest(high.z, at.z)});
}

template <class Value>
struct Link {
    Vec<Value> direction;
    Value stiffness;  // k
    Value error;      // metres, > 0: too long
    Value softness;   // r: of compliance and regularisation
    Value rigid;      // 1 - r k
};

template <int lanes>
Symmetric3<Doubles<lanes>> load_symmetric(const double (&from)[6][lanes]) {
    return {load(from[0]), load(from[1]), load(from[2]), load(from[3]), load(from[4]), load(from[5])};
}

/// Eliminates from the first node to the last. Returns the length of the rope, as placed and at rest together.
/// `pushes`: of contacts, by node, if there are any.
template <bool with_pushes, int lanes>
Doubles<lanes> eliminate(RopeNode<lanes>* nodes, const RopePush<lanes>* pushes, uint32_t count,
                         const Doubles<lanes>& step_squared, const Doubles<lanes>& inverse_step_squared) {
    using Value = Doubles<lanes>;
    const Value none = all_of<lanes>(0), one = all_of<lanes>(1), hair = all_of<lanes>(aside);
    const Value hair_squared = hair * hair;
    const Vec<Value> nowhere{none, none, none};
    const Link<Value> absent{nowhere, none, none, one, one};
    Value reach = none;
    Symmetric3<Value> before{none, none, none, none, none, none};
    Vec<Value> own_before = nowhere, at = load3(nodes[0].position);
    Link<Value> arriving = absent;
    for (uint32_t i = 0; i < count; ++i) {
        RopeNode<lanes>& node = nodes[i];
        Link<Value> leaving = absent;
        Vec<Value> next = at;
        if (i + 1 < count) {
            next = load3(nodes[i + 1].position);
            const Vec<Value> along = next - at;
            const Value length = square_root(dot(along, along) + hair_squared);
            const Value present = load(node.present), target = load(node.target), inverse = one / length;
            leaving.direction = Vec<Value>{along.x + hair, along.y, along.z} * (inverse * present);
            // A link that is short at the moment must not become infinitely stiff sideways.
            leaving.stiffness =
                largest(load(node.tension), none) * step_squared * least(inverse, load(node.inverse_target));
            leaving.error = (length - target) * present;
            leaving.softness = load(node.compliance) * inverse_step_squared + load(node.regularisation);
            leaving.rigid = largest(one - leaving.softness * leaving.stiffness, none);
            reach = reach + (length + target) * present;
            store3(node.direction, leaving.direction);
            store(node.stiffness, leaving.stiffness);
        }
        // The contribution of the previous nodes, through the coupling by the arriving link.
        const Value k = arriving.stiffness, k_squared = k * k, mass = load(node.mass);
        const Vec<Value> n = arriving.direction, v = before * n, q = n - v * k;
        const Value softness = arriving.softness + arriving.rigid * dot(n, v);
        const Value diagonal = mass + k + leaving.stiffness;
        Symmetric3<Value> block{diagonal - k_squared * before.xx, -(k_squared * before.xy),
                                -(k_squared * before.xz),         diagonal - k_squared * before.yy,
                                -(k_squared * before.yz),         diagonal - k_squared * before.zz};
        Vec<Value> force = (load3(node.predicted) - at) * mass + own_before * k;
        Symmetric3<Value> inner;
        if constexpr (with_pushes) {
            block += load_symmetric(pushes[i].stiffness);
            force += load3(pushes[i].force);
            // No eigenvalue is less than the mass. Where an iteration has gone astray, tensions are so large that
            // rounding could make a pivot 0.
            const Value least_pivot = mass * all_of<lanes>(0.5);
            inner = block.inverse(load(node.free), [&](const Value& pivot) { return largest(pivot, least_pivot); });
        } else {
            inner = block.inverse(load(node.free));
        }
        const Vec<Value> w = inner * q;
        const Value inverse_pivot = one / (softness + arriving.rigid * dot(q, w));
        const Vec<Value> pull = w * (arriving.rigid * inverse_pivot);
        const Vec<Value> alone = inner * force;
        const Value tension = (arriving.rigid * (dot(q, alone) - dot(n, own_before)) + arriving.error) * inverse_pivot;
        own_before = alone - w * tension;
        before = {inner.xx - w.x * pull.x, inner.xy - w.x * pull.y, inner.xz - w.x * pull.z,
                  inner.yy - w.y * pull.y, inner.yz - w.y * pull.z, inner.zz - w.z * pull.z};
        store(node.inverse[0], before.xx), store(node.inverse[1], before.xy), store(node.inverse[2], before.xz);
        store(node.inverse[3], before.yy), store(node.inverse[4], before.yz), store(node.inverse[5], before.zz);
        store3(node.own, own_before);
        store3(node.pull, pull);
        store(node.own_tension, tension);
        arriving = leaving;
        at = next;
    }
    return reach;
}

/// Substitutes from the last node to the first, and moves the lanes that are not settled. Returns those that are still
/// not settled: in which a link has moved perpendicular to itself, which the linearisation neglects.
/// With `most_tension` tensions stay within it.
template <int lanes, class Mask>
Mask substitute(RopeNode<lanes>* nodes, uint32_t count, const Doubles<lanes>& inverse_step_squared,
                const Doubles<lanes>& reach, const Mask& active, const Doubles<lanes>* most_tension = nullptr) {
    using Value = Doubles<lanes>;
    const Value none = all_of<lanes>(0);
    const Vec<Value> nowhere{none, none, none};
    Vec<Value> moved_next = nowhere;
    Value tension = none, longest = none;
    Mask moving = none < none;
    for (uint32_t i = count; i-- > 0;) {
        RopeNode<lanes>& node = nodes[i];
        Vec<Value> given = nowhere;
        const Vec<Value> n = i + 1 < count ? load3(node.direction) : nowhere;
        const Value k = i + 1 < count ? load(node.stiffness) : none;
        given = moved_next * k + n * tension;
        const Vec<Value> moved = load3(node.own) + load_symmetric(node.inverse) * given;
        store3(node.own, moved);
        store3(node.position, select(active, load3(node.position) + moved, load3(node.position)));
        longest = largest(longest, dot(moved, moved));
        if (i + 1 < count) {
            const Vec<Value> apart = moved_next - moved;
            const Value along = dot(n, apart);
            Value newtons = (tension + k * along) * inverse_step_squared;
            if (most_tension) newtons = in_range(newtons, *most_tension);
            store(node.tension, select(active, newtons, load(node.tension)));
            moving = moving | (load(node.sideways) < dot(apart, apart) - along * along);
        }
        tension = load(node.own_tension) + dot(load3(node.pull), given);
        moved_next = moved;
    }
    // No iteration moves a particle by more than `reach`.
    longest = square_root(longest);
    const Mask too_far = active & (reach < longest);
    if (any(too_far)) {
        const Value back = select(too_far, reach / largest(longest, reach) - all_of<lanes>(1), none);
        for (uint32_t i = 0; i < count; ++i) {
            store3(nodes[i].position, load3(nodes[i].position) + load3(nodes[i].own) * back);
        }
    }
    return (active & moving) | too_far;
}

/// The lanes in which the length of a link does not match its tension. A link of zero length has no relative error.
template <int lanes>
auto find_lost(const RopeNode<lanes>* nodes, uint32_t count) {
    using Value = Doubles<lanes>;
    const Value none = all_of<lanes>(0), part = all_of<lanes>(rope_lost);
    auto lost = none < none;
    for (uint32_t i = 0; i + 1 < count; ++i) {
        const RopeNode<lanes>& node = nodes[i];
        const Vec<Value> along = load3(nodes[i + 1].position) - load3(node.position);
        const Value target = load(node.target), stretch = load(node.compliance) * load(node.tension);
        const Value misfit = (square_root(dot(along, along)) - target - stretch) * load(node.present);
        lost = lost | ((none < target) & (part * target < largest(misfit, -misfit)));
    }
    return lost;
}

// Otherwise gcc calls the operators on eight doubles, and passes them through memory.
template <int lanes>
GPHYS_FLATTEN void begin_all(RopeNode<lanes>* nodes, uint32_t count, const RopeStep<lanes>& step, bool trapezoid) {
    if (trapezoid) {
        begin_trapezoid(nodes, count, step);
    } else {
        for (uint32_t i = 0; i < count; ++i) begin(nodes[i], by_backward_formula(nodes[i], step));
    }
}

template <int lanes>
GPHYS_FLATTEN void move(RopeNode<lanes>* nodes, uint32_t count, const RopeStep<lanes>& step, bool trapezoid,
                        RopeBounds<lanes>& bounds) {
    begin_all(nodes, count, step, trapezoid);
    // No valid correction is larger than the length of the rope, as placed and at rest together, but that of an
    // infeasible system may be after regularisation.
    const Doubles<lanes> step_squared = load(step.step_squared), inverse_step_squared = load(step.inverse_step_squared);
    auto active = all_of<lanes>(0) < all_of<lanes>(1);
    for (int iteration = 0; iteration < most_iterations && any(active); ++iteration) {
        const Doubles<lanes> reach = eliminate<false, lanes>(nodes, nullptr, count, step_squared, inverse_step_squared);
        active = substitute(nodes, count, inverse_step_squared, reach, active);
    }
    if (any(active)) {
        const auto lost = find_lost(nodes, count);
        store(bounds.lost, select(lost, all_of<lanes>(1), load(bounds.lost)));
    }
    for (uint32_t i = 0; i < count; ++i) finish(nodes[i], step, bounds);
}

template <int lanes>
GPHYS_FLATTEN void iterate(RopeNode<lanes>* nodes, const RopePush<lanes>* pushes, uint32_t count,
                           const RopeEquations<lanes>& equations, bool (&moving)[lanes]) {
    const Doubles<lanes> none = all_of<lanes>(0), inverse_step_squared = load(equations.inverse_step_squared);
    eliminate<true, lanes>(nodes, pushes, count, load(equations.step_squared), inverse_step_squared);
    const Doubles<lanes> most_tension = load(equations.most_tension);
    const auto still = substitute(nodes, count, inverse_step_squared, load(equations.reach),
                                  none < load(equations.active), &most_tension);
    double numbers[lanes];
    store(numbers, select(still, all_of<lanes>(1), none));
    for (int lane = 0; lane < lanes; ++lane) moving[lane] = numbers[lane] != 0;
}

}  // namespace

const RopeKernels rope_kernels = {{put_ropes<1>, find_agility<1>, move<1>, take_ropes<1>, iterate<1>},
                                  {put_ropes<8>, find_agility<8>, move<8>, take_ropes<8>, iterate<8>}};

}  // namespace gphys::GPHYS_ISA
