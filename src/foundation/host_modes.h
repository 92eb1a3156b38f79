// The modes of the floating-point unit that a host may have changed: the direction of rounding, and whether denormal
// numbers are flushed to zero, as game engines and audio code have it. All arithmetic here needs the modes that
// programs start in: exact sums of two doubles, for one, are exact in no other (Shewchuk 1997).
#pragma once

#include <atomic>
#include <cstdint>

#include "foundation/compiler.h"

namespace gphys {

#if GPHYS_X86

/// MXCSR; for 32-bit programs the control word of the x87 too, which rounds where 64-bit integers become doubles.
struct HostModes {
    uint32_t mxcsr;
    uint16_t x87;
};

inline uint16_t x87_control() {
    uint16_t control = 0;
#if defined(__i386__)
    __asm__ volatile("fnstcw %0" : "=m"(control));
#endif
    return control;
}
inline void set_x87_control([[maybe_unused]] uint16_t control) {
#if defined(__i386__)
    __asm__ volatile("fldcw %0" : : "m"(control));
#endif
}
constexpr uint16_t x87_rounding = 0x0c00;

/// By what they do: four sums, of which each mode that is not standard changes one. MXCSR itself takes 3 ns to read,
/// this is not seen beside the shortest call.
GPHYS_INLINE bool modes_are_standard() {
    // Half a unit in the last place is rounded away, on both sides; a sum of normal numbers is denormal; a summand is.
    alignas(16) static constexpr float first[] = {1, 1, 0x1.8p-126f, 0x1p-126f};
    alignas(16) static constexpr float second[] = {0x1p-30f, -0x1p-30f, -0x1p-126f, 0x1p-127f};
    alignas(16) static constexpr float sums[] = {1, 1, 0x1p-127f, 0x1.8p-126f};
    __m128 sum = _mm_loadu_ps(first);
#if defined(__GNUC__) || defined(__clang__)
    __asm__ volatile("" : "+x"(sum));  // or it would be the compiler that adds
#endif
    sum = _mm_add_ps(sum, _mm_loadu_ps(second));
    const __m128i same = _mm_cmpeq_epi32(_mm_castps_si128(sum), _mm_castps_si128(_mm_loadu_ps(sums)));
    return _mm_movemask_epi8(same) == 0xffff && (x87_control() & x87_rounding) == 0;
}

/// The modes so far.
inline HostModes set_standard_modes() {
    constexpr uint32_t rounding = 0x6000, flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
    const HostModes host{_mm_getcsr(), x87_control()};
    _mm_setcsr(host.mxcsr & ~(rounding | flush_to_zero | denormals_are_zero));
    set_x87_control(static_cast<uint16_t>(host.x87 & ~x87_rounding));
    return host;
}

/// Exceptions that have been raised since then stay raised.
inline void set_modes(HostModes host) {
    constexpr uint32_t raised = 0x003f;
    _mm_setcsr(host.mxcsr | (_mm_getcsr() & raised));
    set_x87_control(host.x87);
}

#elif defined(__aarch64__) && defined(__GNUC__)

struct HostModes {
    uint64_t fpcr;
};

/// In FPCR: the direction of rounding, FZ, and FIZ of FEAT_AFP.
constexpr uint64_t modes_in_fpcr = 0x00c00000 | 0x01000000 | 0x1;

inline HostModes host_modes() {
    HostModes host;
    __asm__ volatile("mrs %0, fpcr" : "=r"(host.fpcr));
    return host;
}
inline void set_modes(HostModes host) { __asm__ volatile("msr fpcr, %0" : : "r"(host.fpcr)); }
inline bool modes_are_standard() { return (host_modes().fpcr & modes_in_fpcr) == 0; }
inline HostModes set_standard_modes() {
    const HostModes host = host_modes();
    set_modes({host.fpcr & ~modes_in_fpcr});
    return host;
}

#else

/// WebAssembly has no others.
struct HostModes {};
inline bool modes_are_standard() { return true; }
inline HostModes set_standard_modes() { return {}; }
inline void set_modes(HostModes) {}

#endif

/// While it lives this thread has the standard modes; then it has the host's again.
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
    // The compiler knows nothing of modes: the fences keep on this side of them what is read and written. Out of
    // line, as almost no host needs it.
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
