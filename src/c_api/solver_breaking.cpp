// gphys_solver_*: constraints that break.
#include "c_api/api.h"
#include "c_api/handles.h"
#include "c_api/lists.h"
#include "c_api/solver_settings.h"
#include "foundation/strided.h"

using namespace gphys;

gphys_status gphys_solver_set_breaking_forces(gphys_solver* solver, gphys_body_id body,
                                              const gphys_constraint_id* constraints, const float* forces,
                                              uint32_t force_stride, uint32_t count) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_constraints(solver, body, constraints, count));
        if (count != 0) GPHYS_REQUIRE_POINTERS(forces);
        GPHYS_TRY(check_stride("force_stride", force_stride, sizeof *forces, count));
        const Strided<float> each(forces, force_stride);
        for (uint32_t i = 0; i < count; ++i) {
            if (!is_amount(each[i]))
                return fail(GPHYS_ERROR_INVALID_ARGUMENT, "forces", i, Defect{"", 0, each[i], amount_range});
        }
        set_breaking_forces(unwrap(solver)->body(body), constraints, forces, force_stride, count);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_breaking_forces(const gphys_solver* solver, gphys_body_id body,
                                              const gphys_constraint_id* constraints, uint32_t count, float* out_forces,
                                              uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_constraints(solver, body, constraints, count));
        GPHYS_TRY(check_outputs("out_forces", out_forces, out_stride, count));
        const StridedOut<float> to(out_forces, out_stride);
        const Breaking& breaking = unwrap(solver)->body(body).breaking;
        for (uint32_t i = 0; i < count; ++i)
            to[i] = static_cast<float>(breaking_force(breaking, IdTable::slot_of(constraints[i])));
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_break_constraint(gphys_solver* solver, gphys_body_id body, gphys_constraint_id constraint,
                                           gphys_break* out_result) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_constraints(solver, body, &constraint, 1));
        gphys_break made;
        GPHYS_TRY(unwrap(solver)->break_constraint(body, constraint, made));
        if (out_result) *out_result = made;
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_breaks(const gphys_solver* solver, gphys_break* out_breaks, uint32_t capacity,
                                     uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        return list_copy(unwrap(solver)->breaks(), "out_breaks", out_breaks, capacity, out_total);
    });
}
