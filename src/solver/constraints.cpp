// Constraints come and go. What can fail checks and makes room first, and wakes the body then.
#include "solver/constraints.h"

#include "foundation/status.h"
#include "solver/body.h"
#include "solver/state.h"

namespace gphys {

void change_links(Constraints& constraints, uint32_t slot, int by) {
    for (const uint32_t p : {constraints.by_slot[slot].a, constraints.by_slot[slot].b}) {
        constraints.links[p].degree += static_cast<uint32_t>(by);
        constraints.links[p].slots ^= slot;
    }
}

gphys_status add_constraint(Body& body, const DistanceConstraint& constraint, gphys_constraint_id& out) {
    if (!body.constraints.ids.reserve(1)) {
        return fail(GPHYS_ERROR_CAPACITY, "the body would have more than 2^24 - 1 constraints");
    }
    reserve_more(body.constraints.by_slot, 1);
    const bool in_plan = can_add_to_plan(body);
    wake(body);
    out = body.constraints.ids.add();
    const uint32_t slot = IdTable::slot_of(out);
    if (slot == body.constraints.by_slot.size()) body.constraints.by_slot.emplace_back();
    DistanceConstraint& added = body.constraints.by_slot[slot];
    added = constraint;
    if (added.rest < 0) added.rest = distance(body.particles.position[added.a], body.particles.position[added.b]);
    change_links(body.constraints, slot, 1);
    body.plan.chains_current = in_plan;
    if (in_plan) add_to_plan(body, slot);
    interrupt(body);
    return GPHYS_OK;
}

gphys_status check_constraint(const Constraints& constraints, gphys_constraint_id id) {
    if (constraints.ids.has(id)) return GPHYS_OK;
    return fail(GPHYS_ERROR_INVALID_ID, "constraint", id, "the id of a constraint of the body");
}

gphys_status set_damping(Body& body, gphys_constraint_id id, double damping) {
    const gphys_status status = check_constraint(body.constraints, id);
    if (status != GPHYS_OK) return status;
    wake(body);
    body.constraints.by_slot[IdTable::slot_of(id)].damping = damping;
    body.plan.described = false;
    return GPHYS_OK;
}

gphys_status remove_constraint(Body& body, gphys_constraint_id id) {
    const gphys_status status = check_constraint(body.constraints, id);
    if (status != GPHYS_OK) return status;
    const uint32_t slot = IdTable::slot_of(id);
    const bool in_plan = can_remove_from_plan(body, slot);
    wake(body);
    change_links(body.constraints, slot, -1);
    forget_length_change(body.constraints, slot);
    body.constraints.ids.remove(id);
    body.plan.chains_current = in_plan;
    if (in_plan) remove_from_plan(body, slot);
    interrupt(body);
    if (!body.cloth.sheet.rest_position.empty()) body.plan.reach_current = false;
    body.cloth.sheet.rest_position.clear();
    return GPHYS_OK;
}

void list_constraints(const Constraints& constraints, Smallest<gphys_constraint_info, ConstraintOrder>& out) {
    for (uint32_t slot = 0; slot < constraints.ids.slots(); ++slot) {
        if (!constraints.ids.live(slot)) continue;
        const DistanceConstraint& c = constraints.by_slot[slot];
        out.add({constraints.ids.id(slot), c.a, c.b, static_cast<float>(c.rest), static_cast<float>(c.compliance)});
    }
}

}  // namespace gphys
