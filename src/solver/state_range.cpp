// Keeps bodies in the range of numbers (state_range.h).
#include "solver/state_range.h"

#include "solver/contact/collision.h"
#include "solver/state.h"

namespace gphys {
namespace {

/// Written so that compilers vectorise it. NaN is not within.
template <class Number>
bool all_within(double limit, const Number* values, size_t count) {
    const Number most = static_cast<Number>(limit);
    Number outside = 0;
    for (size_t i = 0; i < count; ++i) outside = std::fabs(values[i]) <= most ? outside : 1;
    return outside == 0;
}

bool all_within(double limit, const Vector<Vec3>& values) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return all_within(limit, reinterpret_cast<const double*>(values.data()), 3 * values.size());
}

template <class Number>
bool all_finite(const Vector<Number>& values) {
    return all_within(std::numeric_limits<Number>::max(), values.data(), values.size());
}

/// Ropes are brought back in each substep (finish_chains), so that their history is in range, too, unless contacts with
/// other particles have changed their velocities afterwards.
bool is_in_range(const Body& body) {
    if (!all_within(farthest_place, body.particles.position) || !all_within(fastest_particle, body.particles.velocity))
        return false;
    if (!is_graph(body)) {
        const bool collides = body.settings.self_collision || body.settings.body_layers != 0;
        return all_finite(body.rope.tension) &&
               (!collides || all_within(fastest_particle, body.history.start_velocity));
    }
    return all_within(far_range, body.history.start) && all_finite(body.cloth.state.moved) &&
           all_finite(body.cloth.state.velocity_before) && is_finite(body.cloth.volume.pressure) &&
           is_finite(body.cloth.balance.lost);
}

void bring_back(Body& body) {
    for (uint32_t p = 0; p < body.particles.size(); ++p)
        keep_in_range(body.particles.position[p], body.particles.velocity[p]);
    interrupt(body);
    clear_contact_points(body);
    if (!body.history.start.empty()) body.history.start = body.particles.position;
    if (!body.history.start_velocity.empty()) body.history.start_velocity = body.particles.velocity;
    for (Vector<float>* values : {&body.cloth.state.moved, &body.cloth.state.velocity_before}) {
        std::fill(values->begin(), values->end(), 0.0f);
    }
    body.cloth.cache.search_balls.clear();
    body.cloth.balance.lost = 0;
    std::fill(body.rope.tension.begin(), body.rope.tension.end(), 0.0);
    body.cloth.volume.pressure = 0;
    body.particles.extent.reset();
}

}  // namespace

void stay_in_range(Body& body) {
    if (!is_in_range(body)) bring_back(body);
    for (ModelImpulse& given : body.contacts.impulses) {
        if (!is_finite(given.linear) || !is_finite(given.angular)) given.linear = given.angular = {};
    }
}

}  // namespace gphys
