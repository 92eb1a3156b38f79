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
    if (body.breaking.possible()) reserve_more(body.breaking.force, 1);
    const bool in_plan = can_add_to_plan(body);
    wake(body);
    DistanceConstraint added = constraint;
    if (added.rest < 0) added.rest = distance(body.particles.position[added.a], body.particles.position[added.b]);
    added.rest = counted_length(added.rest);
    out = body.constraints.ids.id(insert_constraint(body, added, in_plan));
    interrupt(body);
    return GPHYS_OK;
}

uint32_t insert_constraint(Body& body, const DistanceConstraint& constraint, bool in_plan) {
    Constraints& constraints = body.constraints;
    const uint32_t slot = IdTable::slot_of(constraints.ids.add());
    if (slot == constraints.by_slot.size()) constraints.by_slot.emplace_back();
    constraints.by_slot[slot] = constraint;
    if (body.breaking.possible()) {
        body.breaking.force.resize(constraints.by_slot.size());
        body.breaking.force[slot] = infinity;
    }
    change_links(constraints, slot, 1);
    body.plan.chains_current = in_plan;
    if (in_plan) add_to_plan(body, slot);
    return slot;
}

gphys_status check_constraint(const Constraints& constraints, gphys_constraint_id id) {
    if (constraints.ids.has(id)) return GPHYS_OK;
    return fail(GPHYS_ERROR_INVALID_ID, "constraint", id, "the id of a constraint of the body");
}

gphys_status set_damping(Body& body, gphys_constraint_id id, double damping) {
    GPHYS_TRY(check_constraint(body.constraints, id));
    wake(body);
    body.constraints.by_slot[IdTable::slot_of(id)].damping = damping;
    body.plan.described = false;
    return GPHYS_OK;
}

gphys_status remove_constraint(Body& body, gphys_constraint_id id) {
    GPHYS_TRY(check_constraint(body.constraints, id));
    const uint32_t slot = IdTable::slot_of(id);
    const bool in_plan = can_remove_from_plan(body, slot);
    wake(body);
    erase_constraint(body, slot, in_plan);
    interrupt(body);
    if (!body.cloth.sheet.rest_position.empty()) body.plan.reach_current = false;
    body.cloth.sheet.rest_position.clear();
    return GPHYS_OK;
}

void erase_constraint(Body& body, uint32_t slot, bool in_plan) {
    change_links(body.constraints, slot, -1);
    forget_length_change(body.constraints, slot);
    body.constraints.ids.remove(body.constraints.ids.id(slot));
    body.plan.chains_current = in_plan;
    if (in_plan) remove_from_plan(body, slot);
}

void replace_end(Body& body, uint32_t slot, uint32_t from, uint32_t to) {
    DistanceConstraint& constraint = body.constraints.by_slot[slot];
    body.plan.chains_current = can_add_to_plan(body);
    if (body.plan.chains_current) remove_from_plan(body, slot);
    change_links(body.constraints, slot, -1);
    (constraint.a == from ? constraint.a : constraint.b) = to;
    change_links(body.constraints, slot, 1);
    body.plan.chains_current = can_add_to_plan(body);
    if (body.plan.chains_current) add_to_plan(body, slot);
}

void list_constraints(const Constraints& constraints, Smallest<gphys_constraint_info, ConstraintOrder>& out) {
    for (const uint32_t slot : constraints.ids) {
        const DistanceConstraint& c = constraints.by_slot[slot];
        out.add({constraints.ids.id(slot), c.a, c.b, static_cast<float>(c.rest), static_cast<float>(c.compliance)});
    }
}

}  // namespace gphys
