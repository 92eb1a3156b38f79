// The check of the host's floating-point modes; tests_c/test_host_modes.c tests whole calls in them.
#include "foundation/host_modes.h"

#include "test.h"

using namespace gphys;

#if GPHYS_X86

namespace {

/// A call, so that no sum is moved across a change of modes.
GPHYS_NOINLINE bool are_standard() { return modes_are_standard(); }

}  // namespace

TEST_CASE("each rounding mode, flush-to-zero and denormals-are-zero are told from the standard modes") {
    constexpr uint32_t rounding = 1u << 13, flush_to_zero = 1u << 15, denormals_are_zero = 1u << 6;
    const uint32_t host = _mm_getcsr();
    const uint32_t standard = host & ~(3 * rounding | flush_to_zero | denormals_are_zero);
    for (uint32_t direction = 0; direction < 4; ++direction) {
        for (const uint32_t flushed : {0u, flush_to_zero, denormals_are_zero, flush_to_zero | denormals_are_zero}) {
            _mm_setcsr(standard | direction * rounding | flushed);
            const bool result = are_standard();
            _mm_setcsr(host);
            CHECK(result == (direction == 0 && flushed == 0));
        }
    }
}

#endif
