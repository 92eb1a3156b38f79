// Eight rays in the lanes of registers, for kernels: loads by transposition (Vec<Double8> from eight Ray structs), and
// stores of their probes (box8.h).
#pragma once

#include "bvh/ray_setup.h"
#include "foundation/compiler.h"
#include "foundation/simd_double.h"

namespace gphys::GPHYS_ISA {

struct Rays8 {
    Vec<Double8> origin, direction;
    Double8 t_max;

    /// `count` >= 1; the last ray fills the other lanes.
    Rays8(const Ray* rays, uint32_t count)
        : Rays8([&](int i) -> const Ray& {
              return rays[static_cast<uint32_t>(i) < count ? static_cast<uint32_t>(i) : count - 1];
          }) {}
    /// ray_at(i), i < 8.
    template <class RayAt>
    GPHYS_INLINE explicit Rays8(const RayAt& ray_at) {
        static_assert(offsetof(Ray, t_max) == 6 * sizeof(double));
        const auto at = [&](int i, int number) { return &ray_at(i).origin.x + number; };
        Double8 four[4];
        load_components([&](int i) { return at(i, 0); }, four);
        origin = {four[0], four[1], four[2]};
        load_components([&](int i) { return at(i, 3); }, four);
        direction = {four[0], four[1], four[2]};
        t_max = four[3];
    }
};

/// Stores the probes of eight rays in at(i); returns their limits for t_max. For one ray: store_probe (ray_setup.h).
template <class At>
Float8 store_probes(Double8 t_max, const RaySetup<Vec<Double8>>& setup, const At& at) {
    const auto quads_of = [](const Vec<Double8>& v) {
        return Quads8{narrowed(v.x), narrowed(v.y), narrowed(v.z), splat(0)};
    };
    store_quads([&](int i) { return at(i).near_origin; }, quads_of(setup.near_origin));
    store_quads([&](int i) { return at(i).far_origin; }, quads_of(setup.far_origin));
    store_quads([&](int i) { return at(i).minus_inverse; }, quads_of(setup.minus_inverse));
    const Quads8 direction = quads_of(setup.unit_direction);
    const auto faces = [&](int32_t first, int32_t last) {
        return Quads8{choose_bits(signs(direction.x), last, first),
                      choose_bits(signs(direction.y), last + 8, first + 8),
                      choose_bits(signs(direction.z), last + 16, first + 16), splat(0)};
    };
    store_quads([&](int i) { return reinterpret_cast<float*>(at(i).near_face); }, faces(0, 24));
    store_quads([&](int i) { return reinterpret_cast<float*>(at(i).far_face); }, faces(24, 0));
    const Double8 begin[] = {setup.begin.x, setup.begin.y, setup.begin.z, 0};
    const Double8 path[] = {setup.slack, setup.scale, setup.start, setup.span};
    store_components([&](int i) { return at(i).begin; }, begin);
    store_components([&](int i) { return reinterpret_cast<double*>(&at(i).path); }, path);
    return narrowed(ray_limit(t_max, setup.slack, setup.scale, setup.start, setup.span));
}

}  // namespace gphys::GPHYS_ISA
