// Packs the chains of cloth for the kernels, which solve eight chains side by side, one in each SIMD lane (structure of
// arrays). The chains of a colour share no particle, so their order is free; they come sorted by length, and the eight
// chains of a batch differ little in length. Empty lanes get links of infinite compliance between two particles that do
// not move.
#include "solver/cloth/cloth_batches.h"
#include "solver/constraints.h"

namespace gphys {
namespace {

constexpr uint32_t lanes = 8;

/// Lists damped links and links that only pull, which are also handled one by one.
void pack_kind(const Plan& plan, uint32_t place, uint32_t link, ClothBatches& batches) {
    const uint32_t a = plan.particles[place], b = plan.particles[place + 1];
    if (plan.damping[link] > 0 && plan.compliance[link] > 0) {
        batches.damped.push_back({static_cast<uint32_t>(batches.rest.size()), a, b, plan.rest[link],
                                  plan.compliance[link], plan.damping[link]});
    }
    if (plan.limit[link] && plan.compliance[link] == 0) {
        batches.limits.push_back(
            {static_cast<uint32_t>(batches.rest.size()), a, b, static_cast<float>(plan.rest[link])});
    }
}

/// Packs up to eight chains of one colour, `first` .. `last` - 1, sorted by length. Lanes without a link get the two
/// particles from `fixed_particle` on. Returns whether there are such lanes.
bool pack_chains(const Plan& plan, uint32_t first, uint32_t last, uint32_t fixed_particle, ClothBatches& batches) {
    const uint32_t link_count = plan.chains[first].link_count;
    bool full = true;
    batches.chains.push_back({static_cast<uint32_t>(batches.particles.size()) / lanes,
                              static_cast<uint32_t>(batches.rest.size()) / lanes, link_count,
                              plan.limit[plan.chains[first].first_link]});
    for (uint32_t j = 0; j <= link_count; ++j) {
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            const bool there = first + lane < last && j <= plan.chains[first + lane].link_count;
            full = full && there;
            batches.particles.push_back(there ? plan.particles[plan.chains[first + lane].first_particle + j]
                                              : fixed_particle + j % 2);
        }
    }
    for (uint32_t j = 0; j < link_count; ++j) {
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            const bool there = first + lane < last && j < plan.chains[first + lane].link_count;
            const uint32_t link = there ? plan.chains[first + lane].first_link + j : 0;
            if (there) pack_kind(plan, plan.chains[first + lane].first_particle + j, link, batches);
            batches.rest.push_back(there ? static_cast<float>(plan.rest[link]) : 0);
            batches.compliance.push_back(there ? plan.compliance[link] : infinity);
        }
    }
    return !full;
}

}  // namespace

void pack_cloth_chains(ClothBatches& batches, const Plan& plan, uint32_t particles) {
    batches.chains.clear();
    batches.colours.clear();
    batches.particles.clear();
    batches.rest.clear();
    batches.compliance.clear();
    batches.damped.clear();
    batches.limits.clear();
    batches.longest = 0;
    batches.spare = 2;
    for (size_t colour = 0; colour + 1 < plan.colours.size(); ++colour) {
        const uint32_t end = plan.colours[colour + 1];
        batches.colours.push_back(static_cast<uint32_t>(batches.chains.size()));
        // Batches of a colour may be solved at the same time, so each has its own particles that do not move.
        uint32_t spare = 0;
        for (uint32_t first = plan.colours[colour]; first < end; first += lanes) {
            if (pack_chains(plan, first, std::min(first + lanes, end), particles + spare, batches)) spare += 2;
            batches.longest = std::max(batches.longest, batches.chains.back().link_count);
        }
        batches.spare = std::max(batches.spare, spare);
    }
    batches.colours.push_back(static_cast<uint32_t>(batches.chains.size()));
    double length = 0;
    for (const double rest : plan.rest) length += rest;
    batches.link_length = length / static_cast<double>(std::max<size_t>(1, plan.rest.size()));
    batches.target.clear();
    if (!batches.damped.empty()) batches.target = batches.rest;
    batches.softness.resize(batches.rest.size());
    batches.stiffness.resize(batches.rest.size());
    batches.scale = 0;
    batches.rows.resize(size_t{cloth_row_floats} * batches.longest);
}

void mark_attached(ClothBatches& batches, const Constraints& constraints, uint32_t particles) {
    Vector<uint8_t> attached(particles + size_t{batches.spare}, 0, batches.rest.get_allocator());
    for (const Attachment& attachment : constraints.attachments) attached[attachment.particle] = 1;
    for (ChainBatch& batch : batches.chains) {
        const uint32_t* first = &batches.particles[lanes * size_t{batch.first_particle}];
        batch.attached =
            std::any_of(first, first + lanes * size_t{batch.link_count + 1}, [&](uint32_t p) { return attached[p]; });
    }
}

}  // namespace gphys
