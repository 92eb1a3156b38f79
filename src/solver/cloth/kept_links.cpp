// Which links relax_links keeps within a strain (kept_links.h): all rigid links; without a strain target, all except
// the braces of cloth (braces.cpp).
#include "solver/cloth/kept_links.h"

#include "solver/cloth/cloth_batches.h"
#include "solver/cloth/rigid_links.h"
#include "solver/plan.h"

namespace gphys {

void list_kept_links(KeptLinks& kept, ClothBatches& batches, const RigidLinks& rigid, const Plan& plan,
                     uint32_t particles) {
    constexpr uint32_t lanes = 8;
    std::pmr::memory_resource* memory = kept.links.get_allocator().resource();
    kept.links.resize(batches.rest.size());
    kept.by_place.assign(batches.rest.size(), KeptLinks::none);
    kept.begin.assign(particles + size_t{1}, 0);
    uint32_t count = 0;
    const auto list_batch = [&](ChainBatch& batch, const Chain* chains) {
        batch.kept = 0;
        for (uint32_t i = 0; i < lanes * batch.link_count; ++i) {
            const uint32_t place = lanes * batch.first_link + i;
            if (batches.compliance[place] > 0) continue;
            const uint32_t* ends = &batches.particles[size_t{lanes} * batch.first_particle + i];
            const uint32_t a = ends[0], b = ends[lanes];
            const double rest = batches.rest[place];
            if (rest == 0) continue;
            const uint32_t slot = plan.slots[chains[i % lanes].first_link + i / lanes];
            const bool brace = rigid.has(RigidLinks::brace, slot), chord = brace || rigid.has(RigidLinks::chord, slot);
            batch.kept |= brace ? ChainBatch::braces : ChainBatch::threads;
            kept.by_place[place] = count;
            kept.links[count++] = {a, b, rest, batch.limit != 0, brace, chord && !batch.limit};
            if (chord) batch.kept |= ChainBatch::chords;
            ++kept.begin[a + 1], ++kept.begin[b + 1];
        }
    };
    for (size_t colour = 0; colour + 1 < batches.colours.size(); ++colour) {
        uint32_t chain = plan.colours[colour];
        for (uint32_t i = batches.colours[colour]; i < batches.colours[colour + 1]; ++i, chain += lanes) {
            list_batch(batches.chains[i], &plan.chains[chain]);
        }
    }
    kept.links.resize(count);
    for (uint32_t p = 0; p < particles; ++p) kept.begin[p + 1] += kept.begin[p];
    kept.at.resize(kept.begin.back());
    Vector<uint32_t> next(kept.begin.begin(), kept.begin.end() - 1, memory);
    for (uint32_t i = 0; i < kept.links.size(); ++i) {
        kept.at[next[kept.links[i].a]++] = i;
        kept.at[next[kept.links[i].b]++] = i;
    }
}

}  // namespace gphys
