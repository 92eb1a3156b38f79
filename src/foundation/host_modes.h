// Floating-point modes that a host may have changed: the rounding mode, and flush-to-zero, which game engines and audio
// code enable. The library needs the default modes; for example, the error terms of exact arithmetic are exact in no
// others (Shewchuk 1997). Every entry point sets them and restores those of the host.
#pragma once

#include <atomic>
#include <cstdint>

#include "foundation/compiler.h"

namespace gphys {

#if GPHYS_X86

/// MXCSR. In 32-bit programs also the control word of the x87, which converts 64-bit integers to doubles.
struct HostModes {
    uint32_t mxcsr;
    uint16_t x87;
};

constexpr uint16_t x87_rounding = 0x0c00;

/// Tests the effect of the modes: four sums, one of which differs in each non-standard mode. Reading MXCSR takes 3 ns;
/// this is too fast to measure in the shortest call.
GPHYS_INLINE bool modes_are_standard() {
    // Rounding up, rounding down, a denormal result (flush to zero), a denormal operand (denormals are zero). The
    // denormal result has a denormal operand, too: from normal ones it takes an assist of 30 ns on some processors.
    alignas(16) static constexpr float first[] = {1, 1, 0x1p-126f, 0x1p-126f};
    alignas(16) static constexpr float second[] = {0x1p-30f, -0x1p-30f, -0x1p-127f, 0x1p-127f};
    alignas(16) static constexpr float sums[] = {1, 1, 0x1p-127f, 0x1.8p-126f};
    const __m128 sum = _mm_add_ps(opaque(_mm_loadu_ps(first)), _mm_loadu_ps(second));
    const __m128i same = _mm_cmpeq_epi32(_mm_castps_si128(sum), _mm_castps_si128(_mm_loadu_ps(sums)));
    return _mm_movemask_epi8(same) == 0xffff && (x87_control() & x87_rounding) == 0;
}

/// Returns the modes of the host.
inline HostModes set_standard_modes() {
    constexpr uint32_t rounding = 0x6000, flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
    const HostModes host{_mm_getcsr(), x87_control()};
    _mm_setcsr(host.mxcsr & ~(rounding | flush_to_zero | denormals_are_zero));
    set_x87_control(static_cast<uint16_t>(host.x87 & ~x87_rounding));
    return host;
}

/// Keeps exception flags that have been raised since.
inline void set_modes(HostModes host) {
    constexpr uint32_t raised = 0x003f;
    _mm_setcsr(host.mxcsr | (_mm_getcsr() & raised));
    set_x87_control(host.x87);
}

#elif defined(GPHYS_HAS_FPCR)

struct HostModes {
    uint64_t fpcr;
};

/// Bits of FPCR: rounding mode, FZ, and FIZ of FEAT_AFP.
constexpr uint64_t modes_in_fpcr = 0x00c00000 | 0x01000000 | 0x1;

inline void set_modes(HostModes host) { write_fpcr(host.fpcr); }
inline bool modes_are_standard() { return (read_fpcr() & modes_in_fpcr) == 0; }
inline HostModes set_standard_modes() {
    const HostModes host{read_fpcr()};
    set_modes({host.fpcr & ~modes_in_fpcr});
    return host;
}

#else

/// WebAssembly has no such modes.
struct HostModes {};
inline bool modes_are_standard() { return true; }
inline HostModes set_standard_modes() { return {}; }
inline void set_modes(HostModes) {}

#endif

/// Sets the standard modes of this thread; the destructor restores those of the host.
class StandardModes {
public:
    StandardModes() noexcept : changed_(!modes_are_standard()) {
        if (changed_) set();
    }
    ~StandardModes() {
        if (changed_) restore();
    }
    StandardModes(const StandardModes&) = delete;
    StandardModes& operator=(const StandardModes&) = delete;

private:
    // The fences keep the compiler from moving loads and stores across the change of modes. Not inlined, because few
    // hosts need it.
    GPHYS_NOINLINE void set() {
        host_ = set_standard_modes();
        std::atomic_signal_fence(std::memory_order_seq_cst);
    }
    GPHYS_NOINLINE void restore() const {
        std::atomic_signal_fence(std::memory_order_seq_cst);
        set_modes(host_);
    }

    const bool changed_;
    HostModes host_{};
};

}  // namespace gphys
