// Newton's method on all positions and tensions of a rope, with the equations of rope_direct.cpp. The linear system is
// block tridiagonal: elimination from the first node to the last, then back substitution.
//
// The geometric stiffness k (1 - n n^T) of a link couples two nodes by a 3 x 3 matrix. It acts as k in all directions
// if the tension t is replaced by t' = t - k n.u, where u is the relative displacement of the ends. The row of the
// link, n.u - r t = -error, becomes (1 - r k) n.u - r t' = -error. Now a link couples two nodes by numbers and vectors,
// and a node passes on the inverse of a symmetric 3 x 3 matrix.
#include "solver/rope/rope_nodes.h"

#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {
namespace {

// Newton's method squares the error in each iteration: two iterations do for a swinging rope, four for a whip.
constexpr int most_iterations = 4;
// Metres. Added to each difference of x, so that coincident particles separate along x. Rounding removes it from any
// other difference, and its square is still a double.
constexpr double tiny_length = 1e-150;
// GPHYS_MAX_COORDINATE, rounded to float. A node that leaves the range of coordinates stops there.
constexpr double coordinate_limit = 1e15f;

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

/// The prediction without constraints, and Newton's initial guess: the previous motion, which obeyed the constraints,
/// extrapolated.
template <class Value>
struct Prediction {
    Vec<Value> history, predicted, initial_guess;
};

template <int lanes>
Prediction<Doubles<lanes>> predict_backward(const RopeNode<lanes>& node, const RopeScheme<lanes>& step) {
    using Value = Doubles<lanes>;
    const Value h = load(step.h), now = load(step.now), earlier = load(step.earlier),
                extrapolation = load(step.extrapolation);
    const Vec<Value> at = load3(node.position), velocity = load3(node.velocity);
    const Vec<Value> velocity_before = load3(node.start_velocity);
    const Vec<Value> history = at * now - load3(node.start) * earlier;
    const Vec<Value> falling =
        (velocity * now - velocity_before * earlier + load3(node.acceleration) * h) * load(step.drag);
    const Vec<Value> predicted = (history + falling * h) * load(step.inverse_next);
    const Vec<Value> initial_guess = at + velocity * h + (velocity - velocity_before) * extrapolation;
    return {history, predicted, select(all_of<lanes>(0) < extrapolation, initial_guess, predicted)};
}

/// `force`: newtons, of the links at the beginning.
template <int lanes>
Prediction<Doubles<lanes>> predict_trapezoid(const RopeNode<lanes>& node, const RopeScheme<lanes>& step,
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

/// `seconds`: of the part. Pinned nodes move at their velocity.
template <int lanes>
void begin(RopeNode<lanes>& node, const Prediction<Doubles<lanes>>& prediction, const Doubles<lanes>& seconds) {
    const Vec<Doubles<lanes>> at = load3(node.position), carried = at + load3(node.velocity) * seconds;
    const auto is_free = all_of<lanes>(0) < load(node.free);
    store3(node.earlier_velocity, load3(node.start_velocity));
    store3(node.start, at);
    store3(node.start_velocity, load3(node.velocity));
    store3(node.history, prediction.history);
    store3(node.predicted, select(is_free, prediction.predicted, carried));
    store3(node.position, select(is_free, prediction.initial_guess, carried));
}

template <int lanes>
void begin_trapezoid(RopeNode<lanes>* nodes, uint32_t count, const RopeScheme<lanes>& step) {
    using Value = Doubles<lanes>;
    const Value zero = all_of<lanes>(0), one = all_of<lanes>(1), tiny = all_of<lanes>(tiny_length);
    const Value h = load(step.h);
    Vec<Value> arriving{zero, zero, zero}, at = load3(nodes[0].position);
    for (uint32_t i = 0; i < count; ++i) {
        Vec<Value> leaving{zero, zero, zero}, next = at;
        if (i + 1 < count) {
            next = load3(nodes[i + 1].position);
            const Vec<Value> along = next - at;
            const Value length = square_root(dot(along, along) + tiny * tiny);
            leaving = Vec<Value>{along.x + tiny, along.y, along.z} * (load(nodes[i].tension) * (one / length));
        }
        begin(nodes[i], predict_trapezoid(nodes[i], step, leaving - arriving), h + h);
        arriving = leaving;
        at = next;
    }
}

template <class Value>
Value clamped(const Value& x, const Value& limit) {
    return largest(least(x, limit), -limit);
}

template <int lanes>
void finish(RopeNode<lanes>& node, const RopeScheme<lanes>& step, RopeBounds<lanes>& bounds) {
    using Value = Doubles<lanes>;
    const Value limit = all_of<lanes>(coordinate_limit), zero = all_of<lanes>(0);
    const auto is_free = zero < load(node.free);
    Vec<Value> at = load3(node.position);
    at = {clamped(at.x, limit), clamped(at.y, limit), clamped(at.z, limit)};
    store3(node.position, at);
    const Vec<Value> velocity = (at * load(step.next) - load3(node.history)) * load(step.rate);
    store3(node.velocity, select(is_free, velocity, load3(node.velocity)));
    const Vec<Value> low = load3(bounds.low), high = load3(bounds.high);
    store3(bounds.low, Vec<Value>{least(low.x, at.x), least(low.y, at.y), least(low.z, at.z)});
    store3(bounds.high, Vec<Value>{largest(high.x, at.x), largest(high.y, at.y), largest(high.z, at.z)});
}

/// The equation of a link in one iteration, with the names of the file's comment.
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
/// `contacts`: by node; null without contacts.
template <bool with_contacts, int lanes>
Doubles<lanes> eliminate(RopeNode<lanes>* nodes, const RopeContactTerm<lanes>* contacts, uint32_t count,
                         const Doubles<lanes>& step_squared, const Doubles<lanes>& inverse_step_squared) {
    using Value = Doubles<lanes>;
    const Value zero = all_of<lanes>(0), one = all_of<lanes>(1), tiny = all_of<lanes>(tiny_length);
    const Value tiny_squared = tiny * tiny;
    const Vec<Value> zero_vector{zero, zero, zero};
    const Link<Value> absent{zero_vector, zero, zero, one, one};
    Value total_length = zero;
    Symmetric3<Value> previous_inverse{zero, zero, zero, zero, zero, zero};
    Vec<Value> previous_displacement = zero_vector, at = load3(nodes[0].position);
    Link<Value> arriving = absent;
    for (uint32_t i = 0; i < count; ++i) {
        RopeNode<lanes>& node = nodes[i];
        Link<Value> leaving = absent;
        Vec<Value> next = at;
        if (i + 1 < count) {
            next = load3(nodes[i + 1].position);
            const Vec<Value> along = next - at;
            const Value length = square_root(dot(along, along) + tiny_squared);
            const Value present = load(node.present), target = load(node.target), inverse = one / length;
            leaving.direction = Vec<Value>{along.x + tiny, along.y, along.z} * (inverse * present);
            // A link that is short at the moment must not become infinitely stiff sideways.
            leaving.stiffness =
                largest(load(node.tension), zero) * step_squared * least(inverse, load(node.inverse_target));
            leaving.error = (length - target) * present;
            leaving.softness = load(node.compliance) * inverse_step_squared + load(node.regularisation);
            leaving.rigid = largest(one - leaving.softness * leaving.stiffness, zero);
            total_length = total_length + (length + target) * present;
            store3(node.direction, leaving.direction);
            store(node.stiffness, leaving.stiffness);
        }
        // The contribution of the previous nodes, through the coupling by the arriving link.
        const Value k = arriving.stiffness, k_squared = k * k, mass = load(node.mass);
        const Vec<Value> n = arriving.direction, v = previous_inverse * n, q = n - v * k;
        const Value softness = arriving.softness + arriving.rigid * dot(n, v);
        const Value diagonal = mass + k + leaving.stiffness;
        Symmetric3<Value> block{diagonal - k_squared * previous_inverse.xx, -(k_squared * previous_inverse.xy),
                                -(k_squared * previous_inverse.xz),         diagonal - k_squared * previous_inverse.yy,
                                -(k_squared * previous_inverse.yz),         diagonal - k_squared * previous_inverse.zz};
        Vec<Value> force = (load3(node.predicted) - at) * mass + previous_displacement * k;
        Symmetric3<Value> inner;
        if constexpr (with_contacts) {
            block += load_symmetric(contacts[i].stiffness);
            force += load3(contacts[i].force);
            // No eigenvalue is less than the mass. But an iteration far from the solution may have such large tensions
            // that rounding makes a pivot 0.
            const Value least_pivot = mass * all_of<lanes>(0.5);
            inner = block.inverse(load(node.free), [&](const Value& pivot) { return largest(pivot, least_pivot); });
        } else {
            inner = block.inverse(load(node.free));
        }
        const Vec<Value> w = inner * q;
        const Value inverse_pivot = one / (softness + arriving.rigid * dot(q, w));
        const Vec<Value> tension_response = w * (arriving.rigid * inverse_pivot);
        const Vec<Value> without_link = inner * force;
        const Value tension =
            (arriving.rigid * (dot(q, without_link) - dot(n, previous_displacement)) + arriving.error) * inverse_pivot;
        previous_displacement = without_link - w * tension;
        previous_inverse = {inner.xx - w.x * tension_response.x, inner.xy - w.x * tension_response.y,
                            inner.xz - w.x * tension_response.z, inner.yy - w.y * tension_response.y,
                            inner.yz - w.y * tension_response.z, inner.zz - w.z * tension_response.z};
        store(node.inverse[0], previous_inverse.xx), store(node.inverse[1], previous_inverse.xy),
            store(node.inverse[2], previous_inverse.xz);
        store(node.inverse[3], previous_inverse.yy), store(node.inverse[4], previous_inverse.yz),
            store(node.inverse[5], previous_inverse.zz);
        store3(node.displacement, previous_displacement);
        store3(node.tension_response, tension_response);
        store(node.arriving_tension, tension);
        arriving = leaving;
        at = next;
    }
    return total_length;
}

/// Substitutes from the last node to the first, and moves the active lanes. No node moves by more than
/// `most_displacement`, and tensions are clamped to `most_tension` unless it is null. Returns the active lanes that
/// have not converged: a link has moved perpendicular to itself, which the linearisation neglects.
template <int lanes, class Mask>
Mask substitute(RopeNode<lanes>* nodes, uint32_t count, const Doubles<lanes>& inverse_step_squared,
                const Doubles<lanes>& most_displacement, const Mask& active,
                const Doubles<lanes>* most_tension = nullptr) {
    using Value = Doubles<lanes>;
    const Value zero = all_of<lanes>(0);
    const Vec<Value> zero_vector{zero, zero, zero};
    Vec<Value> next_displacement = zero_vector;
    Value tension = zero, longest = zero;
    Mask unconverged = zero < zero;
    for (uint32_t i = count; i-- > 0;) {
        RopeNode<lanes>& node = nodes[i];
        Vec<Value> force = zero_vector;
        const Vec<Value> n = i + 1 < count ? load3(node.direction) : zero_vector;
        const Value k = i + 1 < count ? load(node.stiffness) : zero;
        force = next_displacement * k + n * tension;
        const Vec<Value> displacement = load3(node.displacement) + load_symmetric(node.inverse) * force;
        store3(node.displacement, displacement);
        store3(node.position, select(active, load3(node.position) + displacement, load3(node.position)));
        longest = largest(longest, dot(displacement, displacement));
        if (i + 1 < count) {
            const Vec<Value> relative = next_displacement - displacement;
            const Value along = dot(n, relative);
            Value newtons = (tension + k * along) * inverse_step_squared;
            if (most_tension) newtons = clamped(newtons, *most_tension);
            store(node.tension, select(active, newtons, load(node.tension)));
            unconverged = unconverged | (load(node.lateral_tolerance) < dot(relative, relative) - along * along);
        }
        tension = load(node.arriving_tension) + dot(load3(node.tension_response), force);
        next_displacement = displacement;
    }
    longest = square_root(longest);
    const Mask too_far = active & (most_displacement < longest);
    if (any(too_far)) {
        const Value correction =
            select(too_far, most_displacement / largest(longest, most_displacement) - all_of<lanes>(1), zero);
        for (uint32_t i = 0; i < count; ++i) {
            store3(nodes[i].position, load3(nodes[i].position) + load3(nodes[i].displacement) * correction);
        }
    }
    return (active & unconverged) | too_far;
}

/// The lanes in which Newton's method has failed: the length of a link does not match its tension. A link of zero
/// length has no relative error.
template <int lanes>
auto find_failed(const RopeNode<lanes>* nodes, uint32_t count) {
    using Value = Doubles<lanes>;
    const Value zero = all_of<lanes>(0), part = all_of<lanes>(rope_failure);
    auto failed = zero < zero;
    for (uint32_t i = 0; i + 1 < count; ++i) {
        const RopeNode<lanes>& node = nodes[i];
        const Vec<Value> along = load3(nodes[i + 1].position) - load3(node.position);
        const Value target = load(node.target), stretch = load(node.compliance) * load(node.tension);
        const Value residual = (square_root(dot(along, along)) - target - stretch) * load(node.present);
        failed = failed | ((zero < target) & (part * target < largest(residual, -residual)));
    }
    return failed;
}

// Otherwise gcc calls the operators on eight doubles, and passes them through memory.
template <int lanes>
GPHYS_FLATTEN void begin_all(RopeNode<lanes>* nodes, uint32_t count, const RopeScheme<lanes>& step, bool trapezoid) {
    if (trapezoid) {
        begin_trapezoid(nodes, count, step);
    } else {
        for (uint32_t i = 0; i < count; ++i) begin(nodes[i], predict_backward(nodes[i], step), load(step.h));
    }
}

template <int lanes>
GPHYS_FLATTEN void move(RopeNode<lanes>* nodes, uint32_t count, const RopeScheme<lanes>& step, bool trapezoid,
                        RopeBounds<lanes>& bounds) {
    begin_all(nodes, count, step, trapezoid);
    const Doubles<lanes> step_squared = load(step.step_squared), inverse_step_squared = load(step.inverse_step_squared);
    auto active = all_of<lanes>(0) < all_of<lanes>(1);
    for (int iteration = 0; iteration < most_iterations && any(active); ++iteration) {
        const Doubles<lanes> total_length =
            eliminate<false, lanes>(nodes, nullptr, count, step_squared, inverse_step_squared);
        // No valid correction is larger than this length. That of an infeasible system may be, after regularisation.
        active = substitute(nodes, count, inverse_step_squared, total_length, active);
    }
    if (any(active)) {
        const auto failed = find_failed(nodes, count);
        store(bounds.failed, select(failed, all_of<lanes>(1), load(bounds.failed)));
    }
    for (uint32_t i = 0; i < count; ++i) finish(nodes[i], step, bounds);
}

template <int lanes>
GPHYS_FLATTEN void iterate(RopeNode<lanes>* nodes, const RopeContactTerm<lanes>* contacts, uint32_t count,
                           const RopeEquations<lanes>& equations, bool (&unconverged)[lanes]) {
    const Doubles<lanes> zero = all_of<lanes>(0), inverse_step_squared = load(equations.inverse_step_squared);
    eliminate<true, lanes>(nodes, contacts, count, load(equations.step_squared), inverse_step_squared);
    const Doubles<lanes> most_tension = load(equations.most_tension);
    const auto active = substitute(nodes, count, inverse_step_squared, load(equations.most_displacement),
                                   zero < load(equations.active), &most_tension);
    double numbers[lanes];
    store(numbers, select(active, all_of<lanes>(1), zero));
    for (int lane = 0; lane < lanes; ++lane) unconverged[lane] = numbers[lane] != 0;
}

}  // namespace

const RopeKernels rope_kernels = {{gather_ropes<1>, find_largest_frequency<1>, move<1>, scatter_ropes<1>, iterate<1>},
                                  {gather_ropes<8>, find_largest_frequency<8>, move<8>, scatter_ropes<8>, iterate<8>}};

}  // namespace gphys::GPHYS_ISA
