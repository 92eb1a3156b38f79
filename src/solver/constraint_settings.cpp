// Settings of constraints may change while they act: a winch, a muscle. The plan of the chains stays; the parameters of
// their links are updated. A length does not jump, which would throw the load: it changes to the new one at constant
// speed during the next step.
#include "foundation/strided.h"
#include "solver/body.h"
#include "solver/rope/rope_kernels.h"

namespace gphys {
namespace {

bool before(const LengthChange& change, uint64_t slot) { return change.slot < slot; }

/// Uses reserved memory.
void change_length(Body& body, uint32_t slot, double to) {
    DistanceConstraint& constraint = body.constraints.by_slot[slot];
    if (to == constraint.rest) return;
    const auto at =
        std::lower_bound(body.constraints.length_changes.begin(), body.constraints.length_changes.end(), slot, before);
    if (at == body.constraints.length_changes.end() || at->slot != slot) {
        body.constraints.length_changes.insert(at, {slot, constraint.rest});
    }
    // A sheet that does not keep its lengths is no longer flat, and may be larger.
    if (constraint.compliance == 0 && to > constraint.rest) {
        body.cloth.sheet.rest_position.clear();
        body.plan.reach_current = false;
    }
    constraint.rest = to;
}

ChangedLink in_cloth(const ClothBatches& batches, uint32_t place, uint32_t limit) {
    ChangedLink found{place, ChangedLink::none, limit};
    const auto before = [](const DampedInCloth& damped, uint32_t wanted) { return damped.link < wanted; };
    const auto at = std::lower_bound(batches.damped.begin(), batches.damped.end(), place, before);
    if (at != batches.damped.end() && at->link == place) {
        found.damped = static_cast<uint32_t>(at - batches.damped.begin());
    }
    return found;
}

void set_length_in_cloth(ClothBatches& batches, KeptLinks& kept, const ChangedLink& link, double rest) {
    const float narrowed = static_cast<float>(rest);
    batches.rest[link.place] = narrowed;
    if (!batches.target.empty()) batches.target[link.place] = narrowed;
    if (link.damped != ChangedLink::none) batches.damped[link.damped].rest = rest;
    if (link.limit != ChangedLink::none) batches.limits[link.limit].rest = narrowed;
    const uint32_t number = kept.by_place[link.place];
    if (number != KeptLinks::none) kept.links[number].rest = narrowed;
}

}  // namespace

gphys_constraint_settings settings_of(const DistanceConstraint& constraint) {
    return {static_cast<float>(constraint.rest), static_cast<float>(constraint.compliance),
            static_cast<float>(constraint.damping)};
}

void set_constraint_settings(Body& body, const gphys_constraint_id* ids, const gphys_constraint_settings* settings,
                             uint32_t stride, uint32_t count) {
    reserve_more(body.constraints.length_changes, count);
    wake(body);
    const Strided<gphys_constraint_settings> from(settings, stride);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t slot = IdTable::slot_of(ids[i]);
        DistanceConstraint& constraint = body.constraints.by_slot[slot];
        const bool was_rigid = constraint.compliance == 0;
        constraint.compliance = from[i].compliance;
        constraint.damping = from[i].damping;
        // A constraint that is no longer rigid must not limit the reach of particles; one that is rigid now must.
        if (was_rigid != (constraint.compliance == 0))
            body.cloth.sheet.rest_position.clear(), body.plan.reach_current = false;
        const double rest = from[i].rest_length;
        const double present = distance(body.particles.position[constraint.a], body.particles.position[constraint.b]);
        change_length(body, slot, counted_length(rest < 0 ? present : rest));
    }
    body.plan.described = false;
    body.cloth.rigid.forget();
}

void forget_length_change(Constraints& constraints, uint32_t slot) {
    const auto at =
        std::lower_bound(constraints.length_changes.begin(), constraints.length_changes.end(), slot, before);
    if (at != constraints.length_changes.end() && at->slot == slot) constraints.length_changes.erase(at);
}

void find_changed_links(Body& body) {
    const Plan& plan = body.plan;
    body.constraints.changed_links.resize(body.constraints.length_changes.size());
    Vector<uint32_t> change_of(body.constraints.by_slot.size(), ChangedLink::none,
                               body.constraints.changed_links.get_allocator());
    for (uint32_t i = 0; i < body.constraints.length_changes.size(); ++i)
        change_of[body.constraints.length_changes[i].slot] = i;
    if (!is_graph(body)) {
        for (uint32_t link = 0; link < plan.slots.size(); ++link) {
            const uint32_t change = change_of[plan.slots[link]];
            if (change != ChangedLink::none) body.constraints.changed_links[change].place = link;
        }
        return;
    }
    uint32_t limits = 0;  // limits so far, in the order in which they are packed
    each_link_place(plan, body.cloth.batches, [&](uint32_t link, uint32_t place) {
        const uint32_t limit = plan.limit[link] && plan.compliance[link] == 0 ? limits++ : ChangedLink::none;
        const uint32_t change = change_of[plan.slots[link]];
        if (change != ChangedLink::none)
            body.constraints.changed_links[change] = in_cloth(body.cloth.batches, place, limit);
    });
}

void change_lengths(Body& body, double fraction) {
    Plan& plan = body.plan;
    for (size_t i = 0; i < body.constraints.length_changes.size(); ++i) {
        const LengthChange& change = body.constraints.length_changes[i];
        const ChangedLink& link = body.constraints.changed_links[i];
        const double to = body.constraints.by_slot[change.slot].rest;
        const double rest = fraction < 1 ? change.from + (to - change.from) * fraction : to;
        if (is_graph(body)) {
            set_length_in_cloth(body.cloth.batches, body.cloth.relaxation.kept, link, rest);
        } else {
            plan.rest[link.place] = body.rope.damped_rest[link.place] = rest < rope_shortest ? 0 : rest;
        }
    }
}

}  // namespace gphys
