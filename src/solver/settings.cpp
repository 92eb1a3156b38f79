// Settings that may change while bodies move: those of the solver, and those that all particles of a body share.
#include "solver/solver.h"

namespace gphys {

void Solver::set_settings(const SolverSettings& settings) {
    const SolverSettings& now = state_.settings;
    // Bodies at rest by other measures may not be at rest by these.
    if (settings.gravity != now.gravity || settings.sleep_speed != now.sleep_speed ||
        settings.sleep_strain != now.sleep_strain || settings.sleep_time != now.sleep_time) {
        wake_all();
    }
    // What the next step would do depends on all of them.
    for (Body& body : state_.bodies) body.steady = {};
    state_.settings = settings;
    state_.accumulator = std::min(state_.accumulator, settings.fixed_step);
}

void Solver::set_wind(gphys_body_id of, const gphys_wind& wind) {
    for (const uint32_t slot : state_.ids) {
        if (of != 0 && slot != IdTable::slot_of(of)) continue;
        wake(state_.bodies[slot]);
        state_.bodies[slot].air.wind = wind;
    }
}

void set_settings(Body& body, const BodySettings& settings) {
    Vector<Vec3> placed(body.contacts.self.placed.get_allocator());
    if (settings.self_collision && !body.settings.self_collision) placed = body.particles.position;  // may throw
    wake(body);
    if (settings.self_collision != body.settings.self_collision) {
        body.contacts.self.placed.swap(placed);
        body.contacts.self.linked_begin.clear();
        body.contacts.self.linked.clear();
    }
    // What friction holds now was held by another friction.
    if (settings.friction != body.settings.friction || settings.static_friction != body.settings.static_friction) {
        body.contacts.stuck.clear();
    }
    body.settings = settings;
}

}  // namespace gphys
