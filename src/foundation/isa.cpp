#include "foundation/isa.h"

#include <cstdlib>
#include <cstring>

namespace gphys {

namespace {

constexpr Isa all_sets[] = {
#define GPHYS_ISA_VALUE(set, ...) Isa::set,
    GPHYS_FOR_EACH_ISA(GPHYS_ISA_VALUE, )
#undef GPHYS_ISA_VALUE
};

Isa look_up() {
    const char* wanted = std::getenv("GAMEPHYS_ISA");
    Isa best = Isa::scalar;
    for (const Isa isa : all_sets) {
        if (!has(isa)) continue;
        if (wanted && !std::strcmp(wanted, name_of(isa))) return isa;
        best = isa;  // from the plainest to the widest
    }
    return best;
}

}  // namespace

bool has([[maybe_unused]] Isa isa) {
#if defined(__x86_64__) || defined(__i386__)
    if (isa == Isa::sse2) return __builtin_cpu_supports("sse2");
    if (isa == Isa::avx2) return __builtin_cpu_supports("avx2");
    if (isa == Isa::avx512) {
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
    }
#endif
    return true;
}

Isa chosen_isa() {
    static const Isa chosen = look_up();
    return chosen;
}

const char* name_of(Isa isa) {
    switch (isa) {
#define GPHYS_ISA_CASE(set, ...) \
    case Isa::set:               \
        return #set;
        GPHYS_FOR_EACH_ISA(GPHYS_ISA_CASE, )
#undef GPHYS_ISA_CASE
    }
    return "";
}

}  // namespace gphys
