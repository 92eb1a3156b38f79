// Detection of the processor's instruction sets (isa.h).
#include "foundation/isa.h"

#include <cstdlib>
#include <cstring>
#include <string_view>

#include "foundation/compiler.h"

namespace gphys {
namespace {

constexpr Isa all_sets[] = {
#define GPHYS_ISA_VALUE(set, ...) Isa::set,
    GPHYS_FOR_EACH_ISA(GPHYS_ISA_VALUE, )
#undef GPHYS_ISA_VALUE
};

Isa look_up() {
    const char* wanted = std::getenv("GAMEPHYS_ISA");
    Isa best = base_isa;
    for (const Isa isa : all_sets) {
        if (!has(isa)) continue;
        if (wanted && !std::strcmp(wanted, name_of(isa))) return isa;
        best = isa;  // in order of width
    }
    return best;
}

}  // namespace

bool has([[maybe_unused]] Isa isa) {
#if GPHYS_X86
    const std::string_view name = name_of(isa);
    if (name == "sse2") return processor_has_sse2();
    if (name == "avx2") return processor_has_avx2();
    if (name == "avx512") return processor_has_avx512();
#endif
    return true;
}

Isa chosen_isa() {
    static const Isa chosen = look_up();
    return chosen;
}

const char* name_of(Isa isa) {
#define GPHYS_ISA_STRING(set, ...) #set,
    constexpr const char* names[] = {GPHYS_FOR_EACH_ISA(GPHYS_ISA_STRING, )};
#undef GPHYS_ISA_STRING
    return names[static_cast<int>(isa)];
}

}  // namespace gphys
