// Breaks at the end of a step, and by the caller. Those of a step use memory that it has reserved, so a step that
// cannot get it fails before anything has moved.
#include "solver/solver.h"

namespace gphys {

void Solver::reserve_breaks() {
    size_t most = breaks_.size();
    for (const ActiveBody& active : active_) {
        const Body& body = state_.bodies[active.slot];
        if (body.breaking.possible()) most += body.breaking.allowed;
    }
    breaks_.reserve(most);
}

/// Body by body; of a body the most overloaded links first.
void Solver::break_overloaded(double dt) noexcept {
    std::sort(active_.begin(), active_.end(), [](const ActiveBody& a, const ActiveBody& b) { return a.slot < b.slot; });
    for (const ActiveBody& active : active_) {
        Body& body = state_.bodies[active.slot];
        if (!body.breaking.possible()) continue;
        find_overloads(body, dt);
        Vector<Overload>& overloads = body.breaking.overloads;
        if (overloads.empty()) continue;
        Tearing tearing(body);
        uint32_t left = body.breaking.allowed;
        const size_t before = breaks_.size();
        while (left > 0 && !overloads.empty()) {
            std::pop_heap(overloads.begin(), overloads.end());
            gphys_break out{};
            out.body = state_.ids.id(active.slot);
            out.load = static_cast<float>(overloads.back().load);
            if (tearing.break_link(overloads.back().slot, out)) {
                breaks_.push_back(out);
                --left;
            }
            overloads.pop_back();
        }
        if (breaks_.size() == before) continue;
        tearing.finish();
        if (body.sleep.asleep) wake(body);
    }
}

gphys_status Solver::break_constraint(gphys_body_id id, gphys_constraint_id constraint, gphys_break& out) {
    Body& body = state_.bodies[IdTable::slot_of(id)];
    GPHYS_TRY(check_constraint(body.constraints, constraint));
    if (!reserve_tears(body, 1)) {
        return fail(GPHYS_ERROR_CAPACITY, "the body would have more than 2^24 - 1 particles or constraints");
    }
    Tearing tearing(body);
    gphys_break made{};
    made.body = id;
    if (!tearing.break_link(IdTable::slot_of(constraint), made)) {
        return fail(GPHYS_ERROR_UNSUPPORTED, "constraint: the surface cannot part at either of its particles");
    }
    tearing.finish();
    wake(body);
    update_mesh(id);
    out = made;
    return GPHYS_OK;
}

}  // namespace gphys
