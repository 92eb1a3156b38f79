// Which links relax_links keeps within a strain (kept_links.h): all rigid links; without a strain target, all except
// the braces of cloth. A brace is a diagonal of a cell that has both diagonals. Four particles that are all linked to
// each other cannot bend in their plane, as cells on a surface of double curvature must. There the diagonals may yield,
// as in woven cloth, and the threads keep their lengths.
//
// A cell is found as two common neighbours of the ends of a link that are linked to each other; its diagonals are the
// pair of opposite links with the largest sum of squares. Whether a link is a brace depends on nearby links only, so
// after an edit only links near it are tested again.
#include "solver/cloth/kept_links.h"

#include "solver/cloth/cloth_batches.h"
#include "solver/cloth/rigid_links.h"
#include "solver/plan.h"

namespace gphys {
namespace {

const RigidLinks::End* find(const RigidLinks& rigid, uint32_t a, uint32_t b) {
    for (uint32_t i = rigid.begin[a]; i < rigid.begin[a + 1]; ++i) {
        if (rigid.at[i].to == b) return &rigid.at[i];
    }
    return nullptr;
}

/// Whether the link from a to b is a brace.
bool is_brace(const RigidLinks& rigid, uint32_t a, uint32_t b, double rest) {
    constexpr uint32_t most = 16;  // in a grid, two particles have fewer common neighbours
    RigidLinks::End common[most], from_b[most];
    uint32_t count = 0;
    for (uint32_t i = rigid.begin[a], j = rigid.begin[b]; i < rigid.begin[a + 1] && j < rigid.begin[b + 1];) {
        const RigidLinks::End &of_a = rigid.at[i], &of_b = rigid.at[j];
        if (of_a.to == of_b.to && count < most) common[count] = of_a, from_b[count++] = of_b;
        of_a.to <= of_b.to ? ++i : ++j;
    }
    const auto square = [](double x) { return x * x; };
    for (uint32_t i = 0; i < count; ++i) {
        for (uint32_t j = i + 1; j < count; ++j) {
            const RigidLinks::End* across = find(rigid, common[i].to, common[j].to);
            if (!across) continue;
            const double sum = square(rest) + square(across->rest);
            if (sum > square(common[i].rest) + square(from_b[j].rest) &&
                sum > square(common[j].rest) + square(from_b[i].rest)) {
                return true;
            }
        }
    }
    return false;
}

/// Whether links are braces: as known before, except near links that came or went since. Such a link can only change
/// links whose ends are both among its ends and their neighbours.
class Braces {
public:
    Braces(RigidLinks& rigid, uint32_t particles, uint32_t constraint_slots)
        : rigid_(rigid), near_(particles, 0, rigid.at.get_allocator()) {
        rigid.braces.resize(constraint_slots, unknown);
        for (const uint32_t p : rigid.changed) {
            near_[p] = 1;
            for (uint32_t i = rigid.begin[p]; i < rigid.begin[p + 1]; ++i) near_[rigid.at[i].to] = 1;
        }
    }

    bool contain(uint32_t slot, uint32_t a, uint32_t b, double rest) {
        uint8_t& brace = rigid_.braces[slot];
        if (brace == unknown || (near_[a] && near_[b])) brace = is_brace(rigid_, a, b, rest) ? yes : no;
        return brace == yes;
    }

private:
    static constexpr uint8_t unknown = 0, no = 1, yes = 2;

    RigidLinks& rigid_;
    Vector<uint8_t> near_;  // by particle
};

}  // namespace

void list_kept_links(KeptLinks& kept, ClothBatches& batches, RigidLinks& rigid, const Plan& plan, uint32_t particles,
                     uint32_t constraint_slots, bool has_braces) {
    constexpr uint32_t lanes = 8;
    std::pmr::memory_resource* memory = kept.links.get_allocator().resource();
    Braces braces(rigid, particles, constraint_slots);
    kept.links.clear();
    kept.by_place.assign(batches.rest.size(), KeptLinks::none);
    kept.begin.assign(particles + size_t{1}, 0);
    const auto list_batch = [&](ChainBatch& batch, uint32_t first_chain) {
        batch.kept = 0;
        for (uint32_t i = 0; i < lanes * batch.link_count; ++i) {
            const uint32_t place = lanes * batch.first_link + i;
            if (batches.compliance[place] > 0) continue;
            const uint32_t* ends = &batches.particles[size_t{lanes} * batch.first_particle + i];
            const uint32_t a = ends[0], b = ends[lanes];
            const double rest = batches.rest[place];
            if (rest == 0) continue;
            const uint32_t slot = plan.slots[plan.chains[first_chain + i % lanes].first_link + i / lanes];
            const bool brace = has_braces && braces.contain(slot, a, b, rest);
            batch.kept |= brace ? ChainBatch::braces : ChainBatch::threads;
            kept.by_place[place] = static_cast<uint32_t>(kept.links.size());
            kept.links.push_back({a, b, rest, batch.limit != 0, brace});
            ++kept.begin[a + 1], ++kept.begin[b + 1];
        }
    };
    for (size_t colour = 0; colour + 1 < batches.colours.size(); ++colour) {
        uint32_t chain = plan.colours[colour];
        for (uint32_t i = batches.colours[colour]; i < batches.colours[colour + 1]; ++i, chain += lanes) {
            list_batch(batches.chains[i], chain);
        }
    }
    for (uint32_t p = 0; p < particles; ++p) kept.begin[p + 1] += kept.begin[p];
    kept.at.resize(kept.begin.back());
    Vector<uint32_t> next(kept.begin.begin(), kept.begin.end() - 1, memory);
    for (uint32_t i = 0; i < kept.links.size(); ++i) {
        kept.at[next[kept.links[i].a]++] = i;
        kept.at[next[kept.links[i].b]++] = i;
    }
    rigid.changed.clear();
}

}  // namespace gphys
