// Random shapes as scenes store them, and tallies of what is told about them.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <ostream>

#include "scene/conservative_shape.h"
#include "scene/eight_models.h"
#include "test.h"

namespace gphys {

/// Coordinates on a coarse lattice make touches, edges in one line and zero components frequent.
class Cases {
public:
    explicit Cases(uint64_t seed) : random_(seed) {}

    bool coarse() const { return coarse_; }
    void next() { coarse_ = random_.index(2) == 0; }

    float number(float extent) {
        const float value = random_.uniform_float(-extent, extent);
        return coarse_ ? std::round(value) : value;
    }
    gphys_vec3 point(float extent) { return {number(extent), number(extent), number(extent)}; }
    float size() { return std::fabs(number(3)); }
    gphys_quat rotation() {
        if (coarse_) return random_.index(2) == 0 ? gphys_quat{0, 0, 0, 1} : gphys_quat{0, 0, 0.70710678f, 0.70710678f};
        // Any length that is let in.
        const Quat q = normalized(Quat{number(1), number(1), number(1), 1.01});
        const double length = random_.uniform_float(0.9995f, 1.0005f);
        return narrow(Quat{q.x * length, q.y * length, q.z * length, q.w * length});
    }
    gphys_transform transform() { return {point(5), rotation(), coarse_ ? 2.0f : random_.uniform_float(0.2f, 3)}; }
    gphys_sphere sphere() { return {point(2), size()}; }
    gphys_aabb aabb() {
        const gphys_vec3 center = random_.index(2) == 0 ? gphys_vec3{0, 0, 0} : point(2), half{size(), size(), size()};
        return {{center.x - half.x, center.y - half.y, center.z - half.z},
                {center.x + half.x, center.y + half.y, center.z + half.z}};
    }
    gphys_obb obb() { return {point(2), {size(), size(), size()}, rotation()}; }
    gphys_plane plane() {
        gphys_plane plane{point(2), number(5)};
        if (plane.normal.x == 0 && plane.normal.y == 0 && plane.normal.z == 0) plane.normal.y = 1;
        return plane;
    }
    Ray ray() {
        const gphys_vec3 direction = point(3);
        return {widen(point(12)), widen(direction), random_.index(3) == 0 ? infinity : std::fabs(number(4))};
    }

private:
    test::Random random_;
    bool coarse_ = false;
};

/// How often each verdict was given.
struct Tally {
    int no = 0, yes = 0, open = 0;

    /// Whether the verdict agrees with the exact answer.
    bool add(TriState verdict, bool truth) {
        ++(verdict == TriState::no ? no : verdict == TriState::yes ? yes : open);
        return verdict == TriState::undecided || (verdict == TriState::yes) == truth;
    }
};
inline std::ostream& operator<<(std::ostream& out, const Tally& tally) {
    return out << tally.no << " " << tally.yes << " " << tally.open;
}

/// That of one of eight questions.
inline TriState verdict_of(const TriStates8& verdicts, int k) {
    return tri_state((verdicts.no >> k & 1) != 0, (verdicts.yes >> k & 1) != 0);
}

/// As scenes keep models.
struct StoredModel {
    template <class Stored>
    StoredModel(const gphys_transform& w, const Stored& stored) : world(w) {
        std::memcpy(shape, &stored, std::min(sizeof stored, sizeof shape));
    }

    gphys_transform world;
    float words[2] = {NAN, INFINITY};
    float shape[6] = {};
};
static_assert(offsetof(StoredModel, shape) == shape_at * sizeof(float));

}  // namespace gphys
