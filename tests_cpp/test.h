// Catch2, 2.x or 3.x, and a reproducible random generator for the tests.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <random>

#include "foundation/math.h"

// gcc defines it under the address sanitizer.
#if !defined(__SANITIZE_ADDRESS__) && defined(__has_feature)
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__ 1
#endif
#endif

namespace test {

/// How many cases of a random test are tried: all, or in the short form (GAMEPHYS_SHORT_TESTS) one of eight.
constexpr int tries(int all) {
#ifdef GPHYS_SHORT_TESTS
    return all / 8;
#else
    return all;
#endif
}

/// Whether this combination of parameters is tried: each is, or in the short form one of five. Lists whose length is no
/// multiple of five so have all of their values tried.
constexpr bool is_tried([[maybe_unused]] uint32_t combination) {
#ifdef GPHYS_SHORT_TESTS
    return combination % 5 == 0;
#else
    return true;
#endif
}

struct Random {
    std::mt19937_64 engine;
    explicit Random(uint64_t seed) : engine(seed) {}

    /// Uniform in low..high. Not std::uniform_real_distribution: its results differ by library.
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
    }
    float uniform_float(float low, float high) { return static_cast<float>(uniform(low, high)); }
    uint32_t index(uint32_t count) { return static_cast<uint32_t>((engine() >> 32) * count >> 32); }
    gphys_vec3 point(float extent) {
        return {uniform_float(-extent, extent), uniform_float(-extent, extent), uniform_float(-extent, extent)};
    }
    gphys::Vec3 direction() {
        for (;;) {
            const gphys::Vec3 v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
            const double l2 = gphys::length_squared(v);
            if (l2 > 1e-6 && l2 <= 1) return v / std::sqrt(l2);
        }
    }
    gphys_quat rotation() {
        for (;;) {
            const gphys::Quat q{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
            const double l2 = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
            if (l2 > 1e-2 && l2 <= 1) return gphys::narrow(gphys::normalized(q));
        }
    }
};

}  // namespace test
