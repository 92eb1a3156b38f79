// gphys_solver_*: the settings of the solver, of bodies, of constraints and of the wind.
#include "c_api/solver_settings.h"

#include "foundation/strided.h"

using namespace gphys;

namespace {

Defect defect(const gphys_constraint_settings& settings) {
    if (!is_coordinate(settings.rest_length)) return {".rest_length", 0, settings.rest_length, coordinate_range};
    if (!is_amount(settings.compliance)) return {".compliance", 0, settings.compliance, amount_range};
    if (!is_amount(settings.damping)) return {".damping", 0, settings.damping, amount_range};
    return {};
}

}  // namespace

gphys_status gphys::check_constraints(const gphys_solver* solver, gphys_body_id body,
                                      const gphys_constraint_id* constraints, uint32_t count) {
    GPHYS_TRY(check_body(solver, body));
    if (count != 0) GPHYS_REQUIRE_POINTERS(constraints);
    for (uint32_t i = 0; i < count; ++i)
        GPHYS_TRY(check_constraint(unwrap(solver)->body(body).constraints, constraints[i]));
    return GPHYS_OK;
}

gphys_status gphys::read_settings(const gphys_solver_settings& from, SolverSettings& to) {
    GPHYS_TRY(check_valid("gravity", from.gravity));
    GPHYS_TRY(check_substeps("substeps", from.substeps));
    GPHYS_TRY(check_step("fixed_step", from.fixed_step));
    GPHYS_REQUIRE_IN_RANGE(from.max_steps >= 1, "max_steps", from.max_steps, "at least 1");
    GPHYS_TRY(check_amount("sleep_speed", from.sleep_speed));
    GPHYS_TRY(check_amount("sleep_strain", from.sleep_strain));
    GPHYS_TRY(check_amount("sleep_time", from.sleep_time));
    GPHYS_TRY(check_amount("max_strain", from.max_strain));
    GPHYS_TRY(check_amount("tolerance", from.tolerance));
    GPHYS_TRY(check_substeps("max_substeps", from.max_substeps));
    to = {widen(from.gravity), from.substeps,   from.fixed_step, from.max_steps,    from.sleep_speed, from.sleep_strain,
          from.sleep_time,     from.max_strain, from.tolerance,  from.max_substeps, from.max_work};
    return GPHYS_OK;
}

gphys_status gphys::read_settings(const gphys_body_settings& from, BodySettings& to) {
    GPHYS_TRY(check_amount("damping", from.damping));
    GPHYS_TRY(check_amount("friction", from.friction));
    GPHYS_REQUIRE_IN_RANGE(
        from.static_friction == 0 || (is_amount(from.static_friction) && from.static_friction >= from.friction),
        "static_friction", from.static_friction, "0, or from friction to 1e15");
    GPHYS_REQUIRE_IN_RANGE(from.restitution >= 0 && from.restitution <= 1, "restitution", from.restitution,
                           "from 0 to 1");
    GPHYS_REQUIRE_IN_RANGE(from.self_collision <= 1, "self_collision", from.self_collision, "0 or 1");
    to = {from.damping,       from.friction, std::max(from.friction, from.static_friction),
          from.restitution,   from.layers,   from.body_layers,
          from.self_collision};
    return GPHYS_OK;
}

gphys_status gphys_solver_get_settings(const gphys_solver* solver, gphys_solver_settings* out_settings) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver, out_settings);
        const SolverSettings& s = unwrap(solver)->settings();
        const auto narrowed = [](double value) { return static_cast<float>(value); };
        *out_settings = {narrow(s.gravity),
                         s.substeps,
                         narrowed(s.fixed_step),
                         s.max_steps,
                         narrowed(s.sleep_speed),
                         narrowed(s.sleep_strain),
                         narrowed(s.sleep_time),
                         narrowed(s.max_strain),
                         narrowed(s.tolerance),
                         s.max_substeps,
                         s.max_work};
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_set_settings(gphys_solver* solver, const gphys_solver_settings* settings) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver, settings);
        SolverSettings read;
        GPHYS_TRY(read_settings(*settings, read));
        unwrap(solver)->set_settings(read);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_body_settings(const gphys_solver* solver, gphys_body_id body,
                                            gphys_body_settings* out_settings) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE_POINTERS(out_settings);
        const BodySettings& s = unwrap(solver)->body(body).settings;
        const auto narrowed = [](double value) { return static_cast<float>(value); };
        *out_settings = {
            narrowed(s.damping), narrowed(s.friction), narrowed(s.static_friction), narrowed(s.restitution), s.layers,
            s.body_layers,       s.self_collision};
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_set_body_settings(gphys_solver* solver, gphys_body_id body,
                                            const gphys_body_settings* settings) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE_POINTERS(settings);
        BodySettings read;
        GPHYS_TRY(read_settings(*settings, read));
        set_settings(unwrap(solver)->body(body), read);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_constraint_kinds(const gphys_solver* solver, gphys_body_id body,
                                               const gphys_constraint_id* constraints, uint32_t count,
                                               gphys_constraint_kind* out_kinds, uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_constraints(solver, body, constraints, count));
        GPHYS_TRY(check_outputs("out_kinds", out_kinds, out_stride, count));
        const StridedOut<gphys_constraint_kind> to(out_kinds, out_stride);
        const Vector<DistanceConstraint>& by_slot = unwrap(solver)->body(body).constraints.by_slot;
        for (uint32_t i = 0; i < count; ++i) {
            const bool is_limit = by_slot[IdTable::slot_of(constraints[i])].limit != 0;
            to[i] = is_limit ? GPHYS_CONSTRAINT_MAX_DISTANCE : GPHYS_CONSTRAINT_DISTANCE;
        }
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_constraint_settings(const gphys_solver* solver, gphys_body_id body,
                                                  const gphys_constraint_id* constraints, uint32_t count,
                                                  gphys_constraint_settings* out_settings, uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_constraints(solver, body, constraints, count));
        GPHYS_TRY(check_outputs("out_settings", out_settings, out_stride, count));
        const StridedOut<gphys_constraint_settings> to(out_settings, out_stride);
        const Body& b = unwrap(solver)->body(body);
        for (uint32_t i = 0; i < count; ++i)
            to[i] = settings_of(b.constraints.by_slot[IdTable::slot_of(constraints[i])]);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_set_constraint_settings(gphys_solver* solver, gphys_body_id body,
                                                  const gphys_constraint_id* constraints,
                                                  const gphys_constraint_settings* settings, uint32_t setting_stride,
                                                  uint32_t count) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_constraints(solver, body, constraints, count));
        if (count != 0) GPHYS_REQUIRE_POINTERS(settings);
        GPHYS_TRY(check_stride("setting_stride", setting_stride, sizeof *settings, count));
        const Strided<gphys_constraint_settings> each(settings, setting_stride);
        for (uint32_t i = 0; i < count; ++i) {
            const Defect wrong = ::defect(each[i]);
            if (wrong) return fail(GPHYS_ERROR_INVALID_ARGUMENT, "settings", i, wrong);
        }
        set_constraint_settings(unwrap(solver)->body(body), constraints, settings, setting_stride, count);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_set_wind(gphys_solver* solver, gphys_body_id body, const gphys_wind* wind) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver, wind);
        if (body != 0) GPHYS_TRY(unwrap(solver)->check(body));
        GPHYS_TRY(check_valid("wind.velocity", wind->velocity));
        GPHYS_TRY(check_amount("wind.density", wind->density));
        GPHYS_TRY(check_amount("wind.drag", wind->drag));
        GPHYS_TRY(check_amount("wind.lift", wind->lift));
        unwrap(solver)->set_wind(body, *wind);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_wind(const gphys_solver* solver, gphys_body_id body, gphys_wind* out_wind) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE_POINTERS(out_wind);
        *out_wind = unwrap(solver)->body(body).air.wind;
        return GPHYS_OK;
    });
}
