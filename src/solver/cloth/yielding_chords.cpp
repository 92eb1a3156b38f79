// Finds collapsed cloth, and softens its chords (yielding_chords.h).
#include "solver/cloth/yielding_chords.h"

#include "solver/cloth/cloth.h"
#include "solver/cloth/cloth_chains.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// Parts of its length by which a chord of collapsed cloth is too short, and by which one of unfolded cloth may be: a
// chord that is kept again while it is much too short throws the sheet about. Cloth on models is strained by up to a
// third where it rides on folds.
struct Limits {
    float collapsed, unfolded;
};
constexpr Limits alone{0.05f, 0.03f}, near_models{0.4f, 0.3f};
// Seconds. What collapses in fast motion unfolds on its own within this time, mostly.
constexpr double patience = 1.5;
// The part of its length by which a thread is stretched where the sheet is pulled beyond its reach. Chords that do not
// yield at once would give it energy all the while.
constexpr float pulled_apart = 0.2f;
// Of a yielding chord, for particles of the average mass, 1/s^2: the square of its frequency.
constexpr double stiffness = 900;

/// Whether one of some links is off its length by more than a part of it. wanted(link, length) says whether it counts.
template <class Wanted>
bool has_strained(Cloth& cloth, uint32_t kinds, float part, const Wanted& wanted) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    const KeptLinks& kept = cloth.relaxation.kept;
    Vector<uint32_t>& strained = cloth.relaxation.strained;
    const float* const at = cloth.state.at.data();
    for (const ChainBatch& batch : cloth.batches.chains) {
        if ((batch.kept & kinds) == 0) continue;
        const uint32_t count = kernels.list_strained(at, chains_of(cloth.batches), batch, part, strained.data());
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t number = kept.by_place[strained[i]];
            if (number == KeptLinks::none) continue;
            const KeptLinks::Link& link = kept.links[number];
            if (wanted(link, distance(get(&at[4 * size_t{link.a}]), get(&at[4 * size_t{link.b}])))) return true;
        }
    }
    return false;
}

bool has_chord_below(Cloth& cloth, float part) {
    return has_strained(cloth, ChainBatch::chords, part,
                        [](const KeptLinks::Link& link, double length) { return link.chord && length < link.rest; });
}

bool is_pulled_apart(Cloth& cloth) {
    return has_strained(cloth, ChainBatch::threads, pulled_apart,
                        [](const KeptLinks::Link& link, double length) { return !link.chord && length > link.rest; });
}

void soften_chords(Cloth& cloth, bool yield) {
    KeptLinks& kept = cloth.relaxation.kept;
    ClothBatches& batches = cloth.batches;
    const float softness = yield ? static_cast<float>(batches.scale / (cloth.state.average_mass * stiffness)) : 0;
    for (size_t place = 0; place < kept.by_place.size(); ++place) {
        const uint32_t number = kept.by_place[place];
        if (number == KeptLinks::none || !kept.links[number].chord) continue;
        kept.links[number].yields = yield;
        batches.softness[place] = softness;
    }
}

}  // namespace

void find_yielding_chords(Cloth& cloth, bool joined, bool near, double step_time) {
    YieldingChords& yielding = cloth.yielding;
    yielding.end_under_load = false;
    if (yielding.current && !yielding.any) return;
    const Limits& limits = near ? near_models : alone;
    const bool can_yield = cloth.relaxation.most_strain > 0 && !joined;
    const bool loaded = yielding.collapsed_time == YieldingChords::loaded;
    if (yielding.any) {
        soften_chords(cloth, false);
        yielding.any = can_yield && !loaded && has_chord_below(cloth, limits.unfolded);
        yielding.end_under_load = loaded;
    } else if (can_yield && !loaded && has_chord_below(cloth, limits.collapsed)) {
        yielding.collapsed_time += step_time;
        yielding.any = yielding.collapsed_time >= patience || is_pulled_apart(cloth);
    } else {
        yielding.collapsed_time = 0;
    }
    yielding.current = true;
    if (!yielding.any) return;
    yielding.collapsed_time = 0;
    soften_chords(cloth, true);
}

}  // namespace gphys
