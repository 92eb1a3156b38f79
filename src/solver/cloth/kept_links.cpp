// Which links relax_links keeps within a strain: all rigid ones, but without a target not the braces of cloth. Four
// particles that are all linked to each other, as the corners of a cell with both diagonals, cannot bend in their
// plane. Cells that lie on what is round both ways would have to; there their diagonals yield, as those of woven cloth
// do, and the threads do not.
#include "solver/body.h"

namespace gphys {
namespace {

/// A rigid link as one of its particles sees it.
struct Joint {
    uint32_t to;
    double rest;

    bool operator<(const Joint& other) const { return to < other.to; }
};

/// The rigid links of a body by particle.
class RigidLinks {
public:
    RigidLinks(const Body& body, std::pmr::memory_resource* memory)
        : begin_(body.particles.size() + 1, 0, memory), at_(memory) {
        const Plan& plan = body.plan;
        const auto each = [&](auto&& visit) {
            for (const Chain& chain : plan.chains) {
                for (uint32_t j = 0; j < chain.link_count; ++j) {
                    if (plan.compliance[chain.first_link + j] > 0) continue;
                    const uint32_t* ends = &plan.particles[chain.first_particle + j];
                    visit(ends[0], ends[1], plan.rest[chain.first_link + j]);
                }
            }
        };
        each([&](uint32_t a, uint32_t b, double) { ++begin_[a + 1], ++begin_[b + 1]; });
        for (uint32_t p = 0; p < body.particles.size(); ++p) begin_[p + 1] += begin_[p];
        at_.resize(begin_.back());
        Vector<uint32_t> next(begin_.begin(), begin_.end() - 1, memory);
        each([&](uint32_t a, uint32_t b, double rest) {
            at_[next[a]++] = {b, rest};
            at_[next[b]++] = {a, rest};
        });
        for (uint32_t p = 0; p < body.particles.size(); ++p)
            std::sort(at_.begin() + begin_[p], at_.begin() + begin_[p + 1]);
    }

    /// Whether it crosses another one in a cell with both diagonals: of the three pairs of links without a common
    /// particle the diagonals have the largest sum of squares.
    bool is_brace(uint32_t a, uint32_t b, double rest) const {
        constexpr uint32_t most = 16;  // what has more neighbours in common with another is no grid
        Joint common[most], from_b[most];
        uint32_t count = 0;
        for (uint32_t i = begin_[a], j = begin_[b]; i < begin_[a + 1] && j < begin_[b + 1];) {
            if (at_[i].to == at_[j].to && count < most) common[count] = at_[i], from_b[count++] = at_[j];
            at_[i].to <= at_[j].to ? ++i : ++j;
        }
        const auto square = [](double x) { return x * x; };
        for (uint32_t i = 0; i < count; ++i) {
            for (uint32_t j = i + 1; j < count; ++j) {
                const Joint* across = find(common[i].to, common[j].to);
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

private:
    const Joint* find(uint32_t a, uint32_t b) const {
        for (uint32_t i = begin_[a]; i < begin_[a + 1]; ++i) {
            if (at_[i].to == b) return &at_[i];
        }
        return nullptr;
    }

    Vector<uint32_t> begin_;  // by particle, in at_
    Vector<Joint> at_;
};

}  // namespace

void list_kept_links(Body& body) {
    constexpr uint32_t lanes = 8;
    ClothBatches& batches = body.cloth.batches;
    KeptLinks& kept = batches.kept;
    std::pmr::memory_resource* memory = kept.links.get_allocator().resource();
    const RigidLinks rigid(body, memory);
    kept.links.clear();
    kept.by_place.assign(batches.rest.size(), KeptLinks::none);
    kept.begin.assign(body.particles.size() + 1, 0);
    for (ChainBatch& batch : batches.chains) {
        batch.kept = 0;
        for (uint32_t i = 0; i < lanes * batch.link_count; ++i) {
            const uint32_t place = lanes * batch.first_link + i;
            if (batches.compliance[place] > 0) continue;
            const uint32_t* particles = &batches.particles[size_t{lanes} * batch.first_particle + i];
            const uint32_t a = particles[0], b = particles[lanes];
            const double rest = batches.rest[place];
            if (rest == 0) continue;
            const bool brace = body.kind == GPHYS_BODY_CLOTH && rigid.is_brace(a, b, rest);
            batch.kept |= brace ? ChainBatch::braces : ChainBatch::threads;
            kept.by_place[place] = static_cast<uint32_t>(kept.links.size());
            kept.links.push_back({a, b, rest, batch.limit != 0, brace});
            ++kept.begin[a + 1], ++kept.begin[b + 1];
        }
    }
    for (uint32_t p = 0; p < body.particles.size(); ++p) kept.begin[p + 1] += kept.begin[p];
    kept.at.resize(kept.begin.back());
    Vector<uint32_t> next(kept.begin.begin(), kept.begin.end() - 1, memory);
    for (uint32_t i = 0; i < kept.links.size(); ++i) {
        kept.at[next[kept.links[i].a]++] = i;
        kept.at[next[kept.links[i].b]++] = i;
    }
}

}  // namespace gphys
