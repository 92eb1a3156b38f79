// Breaking forces of links, their loads in a step, and which of them exceed these (breaking.h).
#include <algorithm>

#include "foundation/strided.h"
#include "solver/body.h"
#include "solver/cloth/cloth_kernels.h"

namespace gphys {

double breaking_force(const Breaking& breaking, uint32_t slot) {
    return breaking.possible() && breaking.force[slot] < infinity ? breaking.force[slot] : 0;
}

void set_breaking_forces(Body& body, const gphys_constraint_id* ids, const float* forces, uint32_t stride,
                         uint32_t count) {
    const Strided<float> from(forces, stride);
    Breaking& breaking = body.breaking;
    const bool before = breaking.possible();
    bool any = before;
    for (uint32_t i = 0; i < count && !any; ++i) any = from[i] > 0;
    if (!before && any) breaking.force.assign(body.constraints.by_slot.size(), infinity);
    wake(body);
    if (!any) return;
    for (uint32_t i = 0; i < count; ++i) breaking.force[IdTable::slot_of(ids[i])] = from[i] > 0 ? from[i] : infinity;
    if (std::all_of(breaking.force.begin(), breaking.force.end(), [](double force) { return force == infinity; }))
        breaking.force.clear();
    if (breaking.possible() != before) body.plan.reach_current = false;
}

void reserve_breaking(Body& body) {
    Breaking& breaking = body.breaking;
    if (!breaking.possible()) {
        breaking.impulse.clear();
        return;
    }
    breaking.impulse.resize(is_graph(body) ? body.cloth.batches.rest.size() : body.plan.slots.size());
    breaking.pull.resize(is_graph(body) ? body.cloth.batches.rest.size() : 0);
    breaking.overloads.reserve(body.plan.slots.size());
    constexpr uint32_t particles_per_break = 128;
    const uint32_t wanted = (body.particles.size() + particles_per_break - 1) / particles_per_break;
    breaking.allowed = reserve_tears(body, wanted) ? wanted : 0;
}

void begin_loads(Body& body) noexcept { std::fill(body.breaking.impulse.begin(), body.breaking.impulse.end(), 0.0); }

void add_chain_loads(Body& body, const TimeScheme& scheme) {
    for (size_t link = 0; link < body.rope.tension.size(); ++link) {
        body.breaking.impulse[link] +=
            body.rope.tension[link] * scheme.h + body.rope.earlier_tension[link] * scheme.explicit_h;
    }
}

void note_pulls(Breaking& breaking, const ChainBatch& batch, const float* rows, bool again) {
    constexpr uint32_t lanes = 8;
    for (uint32_t j = 0; j < batch.link_count; ++j) {
        const float* const row = rows + cloth_row_floats * j;
        float* const pull = &breaking.pull[lanes * size_t{batch.first_link + j}];
        for (uint32_t lane = 0; lane < lanes; ++lane) pull[lane] = again ? pull[lane] + row[lane] : row[lane];
    }
}

void add_cloth_loads(Body& body, const TimeScheme& scheme) {
    const double h = body.history.earlier_step > 0 ? scheme.h : scheme.h / scheme.next;
    const double impulse = body.cloth.batches.scale * h;  // of a pull that moves an average particle by a metre
    for (size_t place = 0; place < body.breaking.pull.size(); ++place)
        body.breaking.impulse[place] += impulse * body.breaking.pull[place];
}

namespace {

/// Such a link is no part of the motion, and its tension is undetermined.
bool is_between_pins(const Body& body, uint32_t slot) {
    const DistanceConstraint& link = body.constraints.by_slot[slot];
    return body.particles.pinned(link.a) && body.particles.pinned(link.b);
}

}  // namespace

void find_overloads(Body& body, double dt) noexcept {
    Breaking& breaking = body.breaking;
    breaking.overloads.clear();
    const auto add_if_over = [&](uint32_t link, uint32_t place) {
        const uint32_t slot = body.plan.slots[link];
        const double load = breaking.impulse[place] / dt;
        if (load > breaking.force[slot] && !is_between_pins(body, slot))
            breaking.overloads.push_back({load / breaking.force[slot], load, slot});
    };
    if (is_graph(body)) {
        each_link_place(body.plan, body.cloth.batches, add_if_over);
    } else {
        for (uint32_t link = 0; link < breaking.impulse.size(); ++link) add_if_over(link, link);
    }
    std::make_heap(breaking.overloads.begin(), breaking.overloads.end());
}

}  // namespace gphys
