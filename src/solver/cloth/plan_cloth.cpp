// Packs the chains of cloth for the kernels, which solve eight chains side by side, one in each SIMD lane (structure of
// arrays). The chains of a colour share no particle, so their order is free; they come sorted by length, and the eight
// chains of a batch differ little in length. Empty lanes get links of infinite compliance between two particles that do
// not move.
#include "solver/cloth/cloth_batches.h"
#include "solver/constraints.h"
#include "solver/particles/particles.h"

namespace gphys {
namespace {

constexpr uint32_t lanes = 8;

/// Lists damped links and links that only pull, which are also handled one by one, of the chains `first` .. `last` - 1.
void list_kinds(const Plan& plan, uint32_t first, uint32_t last, const ChainBatch& batch, ClothBatches& batches) {
    for (uint32_t j = 0; j < batch.link_count; ++j) {
        for (uint32_t lane = 0; first + lane < last; ++lane) {
            const Chain& chain = plan.chains[first + lane];
            if (j >= chain.link_count) continue;
            const uint32_t link = chain.first_link + j, place = lanes * (batch.first_link + j) + lane;
            const uint32_t a = plan.particles[chain.first_particle + j],
                           b = plan.particles[chain.first_particle + j + 1];
            if (plan.damping[link] > 0 && plan.compliance[link] > 0)
                batches.damped.push_back({place, a, b, plan.rest[link], plan.compliance[link], plan.damping[link]});
            if (plan.limit[link] && plan.compliance[link] == 0)
                batches.limits.push_back({place, a, b, static_cast<float>(plan.rest[link])});
        }
    }
}

/// Packs up to eight chains of one colour, `first` .. `last` - 1, sorted by length. Lanes without a link get the two
/// particles from `fixed_particle` on. Returns whether there are such lanes.
bool pack_chains(const Plan& plan, uint32_t first, uint32_t last, uint32_t fixed_particle, const ChainBatch& batch,
                 ClothBatches& batches) {
    bool full = true;
    for (uint32_t lane = 0; lane < lanes; ++lane) {
        const Chain chain = first + lane < last ? plan.chains[first + lane] : Chain{0, 0, 0};
        const uint32_t count = chain.link_count;
        uint32_t* const particles = &batches.particles[size_t{lanes} * batch.first_particle + lane];
        float* const rest = &batches.rest[size_t{lanes} * batch.first_link + lane];
        double* const compliance = &batches.compliance[size_t{lanes} * batch.first_link + lane];
        // A lane without a chain has no particles of its own.
        const uint32_t particle_count = count > 0 ? count + 1 : 0;
        for (uint32_t j = 0; j < particle_count; ++j) particles[lanes * j] = plan.particles[chain.first_particle + j];
        for (uint32_t j = 0; j < count; ++j) {
            rest[lanes * j] = static_cast<float>(plan.rest[chain.first_link + j]);
            compliance[lanes * j] = plan.compliance[chain.first_link + j];
        }
        for (uint32_t j = particle_count; j <= batch.link_count; ++j) particles[lanes * j] = fixed_particle + j % 2;
        for (uint32_t j = count; j < batch.link_count; ++j) rest[lanes * j] = 0, compliance[lanes * j] = infinity;
        full = full && count == batch.link_count;
    }
    return !full;
}

/// Lists the batches, and sets the sizes of the arrays that hold them.
void list_batches(ClothBatches& batches, const Plan& plan) {
    batches.chains.clear();
    batches.colours.clear();
    batches.longest = 0;
    uint32_t particles = 0, links = 0;
    for (size_t colour = 0; colour + 1 < plan.colours.size(); ++colour) {
        batches.colours.push_back(static_cast<uint32_t>(batches.chains.size()));
        for (uint32_t first = plan.colours[colour]; first < plan.colours[colour + 1]; first += lanes) {
            const Chain& longest = plan.chains[first];
            batches.chains.push_back({particles, links, longest.link_count, plan.limit[longest.first_link]});
            batches.longest = std::max(batches.longest, longest.link_count);
            particles += longest.link_count + 1;
            links += longest.link_count;
        }
    }
    batches.colours.push_back(static_cast<uint32_t>(batches.chains.size()));
    batches.particles.resize(size_t{lanes} * particles);
    batches.rest.resize(size_t{lanes} * links);
    batches.compliance.resize(size_t{lanes} * links);
}

}  // namespace

void pack_cloth_chains(ClothBatches& batches, const Plan& plan, uint32_t particles) {
    list_batches(batches, plan);
    batches.damped.clear();
    batches.limits.clear();
    batches.spare = 2;
    for (size_t colour = 0; colour + 1 < plan.colours.size(); ++colour) {
        const uint32_t end = plan.colours[colour + 1];
        const ChainBatch* batch = &batches.chains[batches.colours[colour]];
        // Batches of a colour may be solved at the same time, so each has its own particles that do not move.
        uint32_t spare = 0;
        for (uint32_t first = plan.colours[colour]; first < end; first += lanes, ++batch) {
            const uint32_t last = std::min(first + lanes, end);
            if (pack_chains(plan, first, last, particles + spare, *batch, batches)) spare += 2;
            if (plan.damped || plan.limited) list_kinds(plan, first, last, *batch, batches);
        }
        batches.spare = std::max(batches.spare, spare);
    }
    double length = 0;
    for (const double rest : plan.rest) length += rest;
    batches.link_length = length / static_cast<double>(std::max<size_t>(1, plan.rest.size()));
    batches.target.clear();
    if (!batches.damped.empty()) batches.target = batches.rest;
    batches.continued.resize(plan.hubs.empty() ? 0 : batches.rest.size());
    batches.softness.resize(batches.rest.size());
    batches.stiffness.resize(batches.rest.size());
    batches.scale = 0;
    batches.rows.resize(size_t{cloth_row_floats} * batches.longest);
}

void mark_attached(ClothBatches& batches, const Constraints& constraints, const Particles& particles) {
    const auto is_held = [&](uint32_t p) { return p < particles.size() && particles.pinned(p); };
    for (ChainBatch& batch : batches.chains) {
        const uint32_t* first = &batches.particles[lanes * size_t{batch.first_particle}];
        batch.attached = !constraints.attachments.empty() &&
                         std::any_of(first, first + lanes * size_t{batch.link_count + 1}, is_held);
    }
}

}  // namespace gphys
