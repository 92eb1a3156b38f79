// gphys_solver_*: settings of the solver, of bodies and of constraints, and the air, read and changed.
#include "c_api/solver_settings.h"

#include "c_api/api.h"
#include "c_api/handles.h"
#include "foundation/strided.h"

using namespace gphys;

namespace {

bool is_substeps(uint32_t substeps) { return substeps >= 1 && substeps <= most_substeps; }

gphys_status check_body(const gphys_solver* solver, gphys_body_id body) {
    GPHYS_REQUIRE(solver, "solver is null");
    return unwrap(solver)->check(body);
}

gphys_status check_ids(const gphys_solver* solver, gphys_body_id body, const gphys_constraint_id* constraints,
                       uint32_t count) {
    GPHYS_TRY(check_body(solver, body));
    GPHYS_REQUIRE(constraints || count == 0, "constraints is null");
    for (uint32_t i = 0; i < count; ++i) GPHYS_TRY(check_constraint(unwrap(solver)->body(body), constraints[i]));
    return GPHYS_OK;
}

const char* defect(const gphys_constraint_settings& settings) {
    if (!(std::fabs(settings.rest_length) <= GPHYS_MAX_COORDINATE)) return "rest_length: not finite or out of range";
    if (!is_amount(settings.compliance)) return "compliance: must be at least 0 and in range";
    if (!is_amount(settings.damping)) return "damping: must be at least 0 and in range";
    return nullptr;
}

}  // namespace

gphys_status gphys::read_settings(const gphys_solver_settings& from, SolverSettings& to) {
    GPHYS_REQUIRE_VALID(from.gravity);
    GPHYS_REQUIRE(is_substeps(from.substeps), "substeps: must be 1 to 1000");
    GPHYS_REQUIRE(from.fixed_step >= shortest_step && from.fixed_step <= longest_step,
                  "fixed_step: must be 1e-6 to 0.5");
    GPHYS_REQUIRE(from.max_steps >= 1, "max_steps: must be at least 1");
    GPHYS_REQUIRE(is_amount(from.sleep_speed), "sleep_speed: must be at least 0 and in range");
    GPHYS_REQUIRE(is_amount(from.sleep_strain), "sleep_strain: must be at least 0 and in range");
    GPHYS_REQUIRE(is_amount(from.sleep_time), "sleep_time: must be at least 0 and in range");
    GPHYS_REQUIRE(is_amount(from.max_strain), "max_strain: must be at least 0 and in range");
    GPHYS_REQUIRE(is_amount(from.tolerance), "tolerance: must be at least 0 and in range");
    GPHYS_REQUIRE(is_substeps(from.max_substeps), "max_substeps: must be 1 to 1000");
    to = {widen(from.gravity), from.substeps,   from.fixed_step, from.max_steps,    from.sleep_speed, from.sleep_strain,
          from.sleep_time,     from.max_strain, from.tolerance,  from.max_substeps, from.max_work};
    return GPHYS_OK;
}

gphys_status gphys::read_settings(const gphys_body_settings& from, BodySettings& to) {
    GPHYS_REQUIRE(is_amount(from.damping), "damping: must be at least 0 and in range");
    GPHYS_REQUIRE(is_amount(from.friction), "friction: must be at least 0 and in range");
    GPHYS_REQUIRE(
        from.static_friction == 0 || (is_amount(from.static_friction) && from.static_friction >= from.friction),
        "static_friction: must be 0, or at least friction and in range");
    GPHYS_REQUIRE(from.restitution >= 0 && from.restitution <= 1, "restitution: must be 0 to 1");
    GPHYS_REQUIRE(from.self_collision <= 1, "self_collision: must be 0 or 1");
    to = {from.damping,       from.friction, std::max(from.friction, from.static_friction),
          from.restitution,   from.layers,   from.body_layers,
          from.self_collision};
    return GPHYS_OK;
}

gphys_status gphys_solver_get_settings(const gphys_solver* solver, gphys_solver_settings* out_settings) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(solver && out_settings, "solver or out_settings is null");
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
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(solver && settings, "solver or settings is null");
        SolverSettings read;
        GPHYS_TRY(read_settings(*settings, read));
        unwrap(solver)->set_settings(read);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_body_settings(const gphys_solver* solver, gphys_body_id body,
                                            gphys_body_settings* out_settings) {
    return guarded([&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE(out_settings, "out_settings is null");
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
    return guarded([&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE(settings, "settings is null");
        BodySettings read;
        GPHYS_TRY(read_settings(*settings, read));
        set_settings(unwrap(solver)->body(body), read);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_constraint_settings(const gphys_solver* solver, gphys_body_id body,
                                                  const gphys_constraint_id* constraints, uint32_t count,
                                                  gphys_constraint_settings* out_settings, uint32_t out_stride) {
    return guarded([&]() -> gphys_status {
        GPHYS_TRY(check_ids(solver, body, constraints, count));
        GPHYS_REQUIRE(out_settings || count == 0, "out_settings is null");
        GPHYS_TRY(check_out_stride("out_stride", out_stride, sizeof *out_settings));
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
    return guarded([&]() -> gphys_status {
        GPHYS_TRY(check_ids(solver, body, constraints, count));
        GPHYS_REQUIRE(settings || count == 0, "settings is null");
        GPHYS_TRY(check_stride("setting_stride", setting_stride, sizeof *settings));
        const Strided<gphys_constraint_settings> each(settings, setting_stride);
        for (uint32_t i = 0; i < count; ++i) {
            if (const char* wrong = ::defect(each[i])) return invalid(wrong);
        }
        set_constraint_settings(unwrap(solver)->body(body), constraints, settings, setting_stride, count);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_set_wind(gphys_solver* solver, gphys_body_id body, const gphys_wind* wind) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(solver && wind, "solver or wind is null");
        if (body != 0) GPHYS_TRY(unwrap(solver)->check(body));
        GPHYS_REQUIRE_VALID(wind->velocity);
        GPHYS_REQUIRE(is_amount(wind->density), "wind.density: must be at least 0 and in range");
        GPHYS_REQUIRE(is_amount(wind->drag), "wind.drag: must be at least 0 and in range");
        GPHYS_REQUIRE(is_amount(wind->lift), "wind.lift: must be at least 0 and in range");
        unwrap(solver)->set_wind(body, *wind);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_wind(const gphys_solver* solver, gphys_body_id body, gphys_wind* out_wind) {
    return guarded([&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE(out_wind, "out_wind is null");
        *out_wind = unwrap(solver)->body(body).air.wind;
        return GPHYS_OK;
    });
}
