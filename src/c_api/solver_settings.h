// Checks of solver and body settings, for descs and for the functions that change them later.
#pragma once

#include "c_api/api.h"
#include "c_api/handles.h"
#include "scene/scene.h"
#include "solver/solver.h"

namespace gphys {

/// A length, time, mass, compliance or coefficient.
inline gphys_status check_amount(const char* name, float value) noexcept {
    GPHYS_REQUIRE_IN_RANGE(is_amount(value), name, value, amount_range);
    return GPHYS_OK;
}
inline gphys_status check_substeps(const char* name, uint32_t substeps) noexcept {
    GPHYS_REQUIRE_IN_RANGE(substeps >= 1 && substeps <= most_substeps, name, substeps, "from 1 to 1000");
    return GPHYS_OK;
}
inline gphys_status check_step(const char* name, float seconds) noexcept {
    GPHYS_REQUIRE_IN_RANGE(seconds >= shortest_step && seconds <= longest_step, name, seconds, "from 1e-6 to 0.5");
    return GPHYS_OK;
}
/// Positions are relative to the origin of the object.
inline gphys_status check_origins(const gphys_solver* solver, const gphys_scene* scene) noexcept {
    GPHYS_REQUIRE(unwrap(solver)->origin() == unwrap(scene)->origin(), "solver, scene: their origins differ");
    return GPHYS_OK;
}

inline gphys_status check_body(const gphys_solver* solver, gphys_body_id body) noexcept {
    GPHYS_REQUIRE_POINTERS(solver);
    return unwrap(solver)->check(body);
}
gphys_status check_constraints(const gphys_solver* solver, gphys_body_id body, const gphys_constraint_id* constraints,
                               uint32_t count);
gphys_status read_settings(const gphys_solver_settings& from, SolverSettings& to);
gphys_status read_settings(const gphys_body_settings& from, BodySettings& to);

}  // namespace gphys
