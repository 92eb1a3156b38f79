// The kernels of box_kernels.h. x, y and z are in the lanes of a register; what the fourth lane holds has no effect on
// the others and raises no floating-point exception.
#include "scene/box_kernels.h"

#include <limits>

#include "foundation/compiler.h"
#include "foundation/numbers.h"
#include "foundation/simd_rotation.h"

#if GPHYS_HAS_AVX2

namespace gphys::GPHYS_ISA {

namespace {

/// The next double fills the fourth lane.
GPHYS_INLINE Axes load(const Vec<double>& v) { return _mm256_loadu_pd(&v.x); }

// --- Masks --------------------------------------------------------------------------------------

// They have all bits of a lane set or none. choose() reads the signs only.

GPHYS_INLINE Axes operator<(Axes a, Axes b) { return _mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ); }
GPHYS_INLINE Axes operator|(Axes a, Axes b) { return _mm256_or_pd(a.v, b.v); }
GPHYS_INLINE Axes operator&(Axes a, Axes b) { return _mm256_and_pd(a.v, b.v); }
GPHYS_INLINE Axes choose(Axes mask, Axes a, Axes b) { return _mm256_blendv_pd(b.v, a.v, mask.v); }

// --- Ray and box ---------------------------------------------------------------------------------

/// A ray and a box in a space where the box is axis-aligned.
struct Slabs {
    Axes origin, direction, low, high;
};

/// Where a ray enters a box: BoxEntry and EnteredFace (raycast_box.h).
class BoxEntrance {
public:
    GPHYS_INLINE BoxEntrance(const Slabs& slabs, double t_max) : slabs_(slabs) {
        // The fourth slab is unbounded, as is a slab along which the ray does not move, if the ray is within it.
        Axes low = blended<8>(slabs.low, splat_axes(-infinity)), high = blended<8>(slabs.high, splat_axes(infinity));
        speed_ = blended<8>(slabs.direction, splat_axes(1));
        const Axes still = _mm256_cmp_pd(speed_.v, _mm256_setzero_pd(), _CMP_EQ_OQ);
        if (signs_of(still) != 0) {
            const Axes outside = (slabs.origin < low) | (high < slabs.origin);
            if (signs_of(outside & still) != 0) return;
            low = choose(still, splat_axes(-infinity), low);
            high = choose(still, splat_axes(infinity), high);
            speed_ = choose(still, splat_axes(1), speed_);
        }
        const Axes inverse = quotients(1, speed_);
        face_ = choose(speed_, high, low);
        const Axes enters = by_component(face_ - slabs.origin, inverse);
        const Axes leaves = by_component(choose(speed_, low, high) - slabs.origin, inverse);
        const Axes latest = greatest_of(enters);
        const double entry = _mm256_cvtsd_f64(latest.v), exit = gphys::least(t_max, min_component(leaves));
        // The ray starts outside if an entry is after 0, or an exit before.
        if (exit * more < gphys::largest(entry, 0)) return;
        entered_ = _mm256_cmp_pd(by_component(enters, splat_axes(more)).v, latest.v, _CMP_NLT_UQ);
        const uint32_t last = signs_of(entered_);
        const bool clear = (0 < entry) & (entry * more < exit) & ((last & (last - 1)) == 0);
        answer_ = clear ? TriState::yes : TriState::undecided;
    }

    GPHYS_INLINE TriState answer() const { return answer_; }

    // If the answer is yes.

    GPHYS_INLINE double t() const { return max_component(quotients(face_ - slabs_.origin, speed_)); }
    /// Exactly on the face and clamped to it.
    GPHYS_INLINE Axes point(double t) const {
        const Axes along = slabs_.origin + slabs_.direction * t;
        return choose(entered_, face_, max(slabs_.low, min(slabs_.high, along)));
    }
    GPHYS_INLINE Axes normal() const { return entered_ & -with_signs(splat_axes(1), slabs_.direction); }

private:
    static constexpr double more = 1 + 0x1p-49;

    const Slabs& slabs_;
    TriState answer_ = TriState::no;
    Axes speed_, face_, entered_;  // the coordinates of the faces towards the ray; the axis of the one that it enters
};

/// Scalar form: to_hit.
GPHYS_INLINE void store_hit(double t, Axes point, Axes normal, Hits8::Rounded& hit) {
    constexpr double last = std::numeric_limits<float>::max();
    const __m128 place = _mm256_cvtpd_ps(min(splat_axes(last), max(splat_axes(-last), point)).v);
    const __m128 reported_t = _mm_set_ss(static_cast<float>(gphys::least(t, last)));
    // Stored together, since they are read together: two stores cannot be forwarded to one wider load.
    _mm_store_ps(&hit.t, _mm_move_ss(_mm_permute_ps(place, 0x90), reported_t));
    _mm_store_ps(&hit.normal.x, _mm256_cvtpd_ps(normal.v));
}

/// Of a box without rotation, as in with_placed (placed.h).
template <class... Hit>
GPHYS_INLINE TriState meet_unrotated(const Ray& ray, Axes low, Axes high, Hit&... hit) {
    const Slabs slabs{load(ray.origin), load(ray.direction), low, high};
    const BoxEntrance entrance(slabs, ray.t_max);
    if (sizeof...(hit) != 0 && entrance.answer() == TriState::yes) {
        [[maybe_unused]] const double t = entrance.t();
        (store_hit(t, entrance.point(t), entrance.normal(), hit), ...);
    }
    return entrance.answer();
}
/// Scalar form: raycast of an Obb.
template <class... Hit>
GPHYS_INLINE TriState meet_rotated(const Ray& ray, Axes center, Axes half, const AxesMatrix& axes, Hit&... hit) {
    const AxesMatrix rows = transposed(axes);
    const Slabs slabs{rows * (load(ray.origin) - center), rows * ray.direction, -half, half};
    const BoxEntrance entrance(slabs, ray.t_max);
    if (sizeof...(hit) != 0 && entrance.answer() == TriState::yes) {
        [[maybe_unused]] const double t = entrance.t();
        (store_hit(t, center + axes * entrance.point(t), axes * entrance.normal(), hit), ...);
    }
    return entrance.answer();
}

template <class... Hit>
TriState meet_aabb(const Ray& ray, const float* model, Hit&... hit) {
    const Axes position = widened<0, 1, 2>(model);
    const double scale = static_cast<double>(model[7]);
    const Axes low = widened<0, 1, 2>(model + shape_at), high = widened<1, 2, 3>(model + shape_at + 2);
    const __m128 rotation = _mm_loadu_ps(model + 3);
    if ((_mm_movemask_ps(_mm_cmpneq_ps(rotation, _mm_setzero_ps())) & 7) == 0) {
        return meet_unrotated(ray, position + low * scale, position + high * scale, hit...);
    }
    const AxesMatrix matrix = rotation_matrix(model + 3);
    return meet_rotated(ray, position + matrix * ((low + high) * 0.5 * scale), (high - low) * 0.5 * scale, matrix,
                        hit...);
}

template <class... Hit>
TriState meet_obb(const Ray& ray, const float* model, const float* rotation, Hit&... hit) {
    const Axes position = widened<0, 1, 2>(model);
    const double scale = static_cast<double>(model[7]);
    const AxesMatrix outer = rotation_matrix(model + 3), inner = rotation_matrix(rotation);
    return meet_rotated(ray, position + outer * (widened<0, 1, 2>(model + shape_at) * scale),
                        widened<1, 2, 3>(model + shape_at + 2) * scale, outer * inner, hit...);
}

}  // namespace

extern const BoxKernels box_kernels{meet_aabb<Hits8::Rounded>, meet_obb<Hits8::Rounded>, meet_aabb<>, meet_obb<>};

}  // namespace gphys::GPHYS_ISA

#endif
