// Ray and AABB by the slab method (Williams et al. 2005): the ray is in the box from the last entry into a slab to the
// first exit from one.
#pragma once

#include "foundation/float4.h"
#include "foundation/numbers.h"

namespace gphys {

/// The axis of the slab that a ray enters last.
template <class N>
class EnteredAxis {
public:
    using Mask = decltype(N() < N());

    /// Selects axis k in the lanes where the ray enters its slab later than those of the axes before.
    GPHYS_INLINE void take(int k, const Mask& later) {
        if (k == 1) y_ = later;
        if (k == 2) z_ = later;
    }
    /// The component along the axis, and a vector with that component replaced.
    GPHYS_INLINE N of(const Vec<N>& v) const { return select(z_, v.z, select(y_, v.y, v.x)); }
    GPHYS_INLINE Vec<N> with(const Vec<N>& v, const N& component) const {
        return {select(y_ | z_, v.x, component), select(y_ & !z_, component, v.y), select(z_, component, v.z)};
    }

private:
    Mask y_{}, z_{};
};
/// A single ray uses an index: masks make the test take 6 % longer.
template <>
class EnteredAxis<double> {
public:
    explicit EnteredAxis(int axis = 0) : axis_(axis) {}

    void take(int k, bool later) { axis_ = later ? k : axis_; }
    double of(const Vec<double>& v) const { return v[axis_]; }
    Vec<double> with(const Vec<double>& v, double component) const {
        double all[] = {v.x, v.y, v.z};
        all[axis_] = component;
        return {all[0], all[1], all[2]};
    }

private:
    int axis_;
};

/// The face through which a ray from outside enters a box.
template <class N>
struct EnteredFace {
    N t, coordinate, direction;  // of the ray along the axis
    EnteredAxis<N> axis;

    /// The point of entry: exactly on the face and clamped to it.
    GPHYS_INLINE Vec<N> point(const Vec<N>& low, const Vec<N>& high, const Vec<N>& origin, const Vec<N>& ray) const {
        return axis.with(max(low, min(high, origin + ray * t)), coordinate);
    }
    GPHYS_INLINE Vec<N> normal() const { return axis.with({}, -with_sign(1.0, direction)); }
};

/// Entries and exits by products with the reciprocal of the direction, with at most four roundings each. They decide if
/// the last entry is clearly before or after the first exit, and clearly after the other entries. Only t itself needs a
/// division. A slab along which the ray does not move has no entry and no exit if the ray is within it.
template <class N>
struct BoxEntry {
    using Mask = decltype(N() < N());

    Mask open;  // undecided: too close
    Mask no;    // misses; like `inside`, valid where `open` is not set
    Mask inside;
    EnteredAxis<N> axis;

    GPHYS_INLINE BoxEntry(const Vec<N>& low, const Vec<N>& high, const Vec<N>& origin, const Vec<N>& direction,
                          const N& t_max) {
        constexpr double more = 1 + 0x1p-49;
        const N lows[3] = {low.x, low.y, low.z}, highs[3] = {high.x, high.y, high.z};
        const N origins[3] = {origin.x, origin.y, origin.z}, directions[3] = {direction.x, direction.y, direction.z};
        N latest = -infinity, second = -infinity, exit = t_max;
        Mask outside{}, behind{};
        for (int k = 0; k < 3; ++k) {
            const Mask still = absolute(directions[k]) <= 0;
            const N speed = select(still, 1.0, directions[k]), inverse = 1 / speed;
            const N to_low = (lows[k] - origins[k]) * inverse, to_high = (highs[k] - origins[k]) * inverse;
            const N near = select(still, -infinity, least(to_high, to_low));
            const N far = select(still, infinity, largest(to_low, to_high));
            const Mask below = origins[k] < lows[k], above = highs[k] < origins[k], backward = speed < 0;
            outside = outside | below | above;
            behind = behind | (below & (backward | still)) | (above & !backward);
            axis.take(k, latest < near);
            second = largest(second, least(latest, near));
            latest = largest(latest, near);
            exit = least(far, exit);
        }
        const Mask late = exit * more < latest, clear = (latest * more < exit) & (second * more < latest);
        no = behind | (outside & late);
        inside = !outside;
        open = outside & !(no | clear);
    }

    GPHYS_INLINE EnteredFace<N> face(const Vec<N>& low, const Vec<N>& high, const Vec<N>& origin,
                                     const Vec<N>& direction) const {
        const N speed = axis.of(direction), along = select(absolute(speed) <= 0, 1.0, speed);
        const N coordinate = select(along < 0, axis.of(high), axis.of(low));
        return {(coordinate - axis.of(origin)) / along, coordinate, along, axis};
    }
};

/// A conservative test of a ray and a box centred at the origin. Times remain fractions, distance over speed along the
/// axis, so no division is needed. Margins on distances and speeds make a miss, or a hit, certain.
///
/// Vector: Float4 with the axes in one register, or a Vec.
template <class Vector>
class RayAndBox {
public:
    using Number = decltype(sum(Vector()));

    /// `margin` bounds the error of the coordinates of `from`, the origin of the ray, and of `half`; `speed_margin`
    /// that of the direction. The ray ends at t = `end`.
    GPHYS_INLINE RayAndBox(const Vector& from, const Vector& half, const Number& margin, const Vector& direction,
                           const Number& speed_margin, const Number& end)
        : twice_margin_(margin + margin), end_(end) {
        const Vector to_center = against(from, direction), speed = abs(direction);
        slow_ = positive(minus(speed, speed_margin));
        fast_ = plus(speed, speed_margin);
        near_ = minus(to_center - half, margin);
        far_ = plus(to_center + half, margin);
    }

    /// False if the ray certainly misses.
    GPHYS_INLINE auto may_hit() const {
        return all_axes(at_most(Vector(), far_) & at_most(near_, end_ * fast_) &
                        at_most(by_component(near_, yzx(slow_)), by_component(yzx(far_), fast_)) &
                        at_most(by_component(near_, zxy(slow_)), by_component(zxy(far_), fast_)));
    }
    /// True if the ray certainly hits.
    GPHYS_INLINE auto must_hit() const {
        const Vector near = positive(plus(near_, twice_margin_)), far = minus(far_, twice_margin_);
        const Vector above_zero = plus(Vector(), splat_as(end_, 0x1p-126f));
        return all_axes(at_most(above_zero, far) & at_most(near, end_ * slow_) &
                        at_most(by_component(near, yzx(fast_)), by_component(yzx(far), slow_)) &
                        at_most(by_component(near, zxy(fast_)), by_component(zxy(far), slow_)));
    }

private:
    Vector near_, far_, slow_, fast_;  // distances to the slabs, and speeds
    Number twice_margin_, end_;
};

}  // namespace gphys
