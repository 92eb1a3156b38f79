// Aerodynamic forces: drag and lift of triangles, links and particles (wind.h).
#include "solver/wind.h"

#include <limits>

#include "foundation/strided.h"
#include "solver/body.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"
#include "solver/triangle_drag.h"
#include "solver/wind_kernels.h"

namespace gphys {
namespace {

// Metres a second, and square metres: its square is a double.
constexpr double least_length = 1e-150;
constexpr double hardest = 1e12;  // m/s^2, as in cloth_state.cpp

/// The force on a ball in newtons, for each square metre of its radius squared and (m/s)^2.
double drag_of_ball(const gphys_wind& wind) { return 0.5 * wind.density * wind.drag * pi; }

/// Sums the forces of triangles and links by particle. `Relative` gives velocities relative to the air, `Place`
/// positions, by particle.
template <class Place, class Relative>
class Forces {
public:
    Forces(Body& body, const Place& place, const Relative& relative)
        : body_(body), air_(body.air), place_(place), relative_(relative) {
        std::fill(air_.force.begin(), air_.force.end(), Vec3{});
        std::fill(air_.rate.begin(), air_.rate.end(), 0.0);
    }

    void add_triangles() {
        for (size_t i = 0; i < body_.cloth.sheet.triangles.size(); i += 3)
            add_triangle(&body_.cloth.sheet.triangles[i]);
    }
    void add_links() {
        for (const uint32_t slot : body_.constraints.ids) add_link(body_.constraints.by_slot[slot]);
    }
    void add_particles() {
        const double part = drag_of_ball(air_.wind);
        for (uint32_t p = 0; p < body_.particles.size(); ++p) {
            const Vec3 u = relative_(p);
            const double d = part * body_.particles.radius[p] * body_.particles.radius[p] * length(u);
            add(p, u * -d, d);
        }
    }
    /// Limits each force to the one that would end the motion relative to the air at this rate, 1/s.
    void limit(double most) {
        for (uint32_t p = 0; p < body_.particles.size(); ++p) {
            if (air_.rate[p] > most) air_.force[p] *= most / air_.rate[p];
        }
    }

private:
    /// Adds a force; `growth`: newtons by which it grows at most if all velocities grow by 1 m/s.
    void add(uint32_t p, Vec3 force, double growth) {
        air_.force[p] += force;
        air_.rate[p] += growth * body_.particles.inverse_mass[p];
    }

    void add_triangle(const uint32_t* corners) {
        const uint32_t a = corners[0], b = corners[1], c = corners[2];
        const Vec3 twice = cross(place_(b) - place_(a), place_(c) - place_(a));  // twice the area, along the normal
        const Vec3 u = (relative_(a) + relative_(b) + relative_(c)) * (1.0 / 3);
        const double unit = air_.wind.density / 12.0;
        const TriangleDrag<double> all = triangle_drag<double>(twice, u, air_.wind.drag, air_.wind.lift, least_length);
        for (const uint32_t p : {a, b, c}) add(p, all.force * unit, all.growth * unit);
    }

    void add_link(const DistanceConstraint& link) {
        const Vec3 way = place_(link.b) - place_(link.a), u = (relative_(link.a) + relative_(link.b)) * 0.5;
        const double length = gphys::length(way);
        if (length == 0) return;
        const Vec3 direction = way / length, across = u - direction * dot(u, direction);
        const double diameter = body_.particles.radius[link.a] + body_.particles.radius[link.b];
        const double half = 0.25 * air_.wind.density * air_.wind.drag * diameter * length * gphys::length(across);
        for (const uint32_t p : {link.a, link.b}) add(p, across * -half, half);
    }

    Body& body_;
    Air& air_;
    const Place& place_;
    const Relative& relative_;
};

Vec3 velocity_at(const Air& air, uint32_t p) {
    const Vec3 wind = widen(air.wind.velocity);
    return air.velocity.empty() ? wind : wind + air.velocity[p];
}

template <class Place, class Relative>
void add_up(Body& body, const Place& place, const Relative& relative, double most_rate) {
    Forces<Place, Relative> forces(body, place, relative);
    if (body.kind == GPHYS_BODY_CLOTH) forces.add_triangles();
    if (body.kind == GPHYS_BODY_ROPE) forces.add_links();
    if (body.kind == GPHYS_BODY_PARTICLES) forces.add_particles();
    forces.limit(most_rate);
}

/// The time in which no velocity relative to the air falls by more than a thirty-second part of itself by drag. With
/// the same force for so long, the way is wrong by a sixth of the square of that at most, 0.02 %.
double time_of_same_drag(const Body& body, Vec3 gravity, double dt) {
    constexpr double most_lost = 1.0 / 32;
    double square = 0;  // of the largest rate of loss
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        const double w = body.particles.inverse_mass[p], radius = body.particles.radius[p], k = radius * radius * w;
        const Vec3 u = body.particles.velocity[p] - velocity_at(body.air, p);
        const Vec3 change = (gravity + body.particles.force[p] * w) * dt;
        square = std::max(square, k * k * (length_squared(u) + length_squared(change)));
    }
    const double rate = drag_of_ball(body.air.wind) * std::sqrt(square);
    return rate > 0 ? most_lost / rate : infinity;
}

}  // namespace

void reserve_air(Body& body) {
    if (!body.air.blows()) return;
    body.air.force.resize(body.particles.size());
    body.air.rate.resize(body.particles.size());
    if (!is_graph(body)) return;
    for (Vector<float>* const values : {&body.air.steady, &body.air.relative, &body.air.cloth_forces})
        values->resize(body.cloth.state.acceleration.size());
}

void begin_air(Body& body, Vec3 gravity, double dt) {
    if (!body.air.blows() || is_graph(body)) return;
    if (flies_in_air(body)) {
        std::copy(body.particles.force.begin(), body.particles.force.end(), body.air.force.begin());
        body.air.lasting = time_of_same_drag(body, gravity, dt);
    } else {
        const auto place = [&](uint32_t p) { return body.particles.position[p]; };
        const auto relative = [&](uint32_t p) { return body.particles.velocity[p] - velocity_at(body.air, p); };
        add_up(body, place, relative, 1 / dt);
        for (uint32_t p = 0; p < body.particles.size(); ++p) body.air.force[p] += body.particles.force[p];
        body.air.force.swap(body.particles.force);
    }
    body.air.forced = body.particles.forced;
    body.particles.forced = true;
}

bool flies_in_air(const Body& body) {
    return body.air.blows() && body.plan.method == GPHYS_SOLVE_FREE && !body.plan.joined &&
           body.kind == GPHYS_BODY_PARTICLES;
}

/// Of second order, and stable for any h. With the acceleration a without drag and k |u| u that of drag, an implicit
/// half step gives the speed s in the middle of that time, s (1 + k s h / 2) = |u + a h / 2|. Then du/dt = a - k s u,
/// with exp(-z) = 1 / (1 + z + z^2 / 2), ends at
///     (u + a h (1 + r) / 2) / (1 + k h |u + a h / 2|),   r^2 = 1 + 2 k h |u + a h / 2|.
/// That is exact without a, and at the terminal velocity. The force is the constant one that leads there.
void blow_flying(Body& body, Vec3 gravity, double h, uint32_t first, uint32_t end) {
    const Air& air = body.air;
    const double part = drag_of_ball(air.wind), damping = body.settings.damping;
    for (uint32_t p = first; p < end; ++p) {
        const double w = body.particles.inverse_mass[p], radius = body.particles.radius[p];
        const Vec3 velocity = body.particles.velocity[p], u = velocity - velocity_at(air, p);
        Vec3 change;  // a h
        if (w > 0) change = (gravity + air.force[p] * w - velocity * damping) * h;
        const double k = part * (radius * radius), speed = length(u + change * 0.5);
        const double growth = k * w * h * speed, r = std::sqrt(1 + 2 * growth), both = 1 / ((1 + r) * (1 + growth));
        body.particles.force[p] = air.force[p] - (u * (1 + r) + change * r) * (k * speed * both);
    }
}

void end_air(Body& body) {
    if (!body.air.blows() || is_graph(body)) return;
    body.air.force.swap(body.particles.force);
    body.particles.forced = body.air.forced;
}

namespace {

Vec3 vector_at(const Vector<float>& values, uint32_t p) { return get(&values[4 * size_t{p}]); }

/// Newtons for each unit of AirOnCloth::forces.
double newtons_per_unit(const gphys_wind& wind) { return double{std::max(wind.drag, wind.lift)} * wind.density / 12; }

/// What the kernels need for a substep of `h` seconds.
AirOnCloth air_on_cloth(Body& body, const TimeScheme& scheme, double h) {
    const ClothState& state = body.cloth.state;
    const gphys_wind& wind = body.air.wind;
    AirOnCloth on{};
    on.floats = static_cast<uint32_t>(state.at.size());
    on.at = state.at.data(), on.velocity = state.velocity.data(), on.velocity_before = state.velocity_before.data();
    on.steady = body.air.steady.data(), on.relative = body.air.relative.data();
    on.forces = body.air.cloth_forces.data(), on.acceleration = body.cloth.state.acceleration.data();
    on.triangles = body.cloth.sheet.triangles.data(), on.triangle_count = body.cloth.sheet.triangles.size() / 3;
    for (int half = 0; half < 8; half += 4)
        on.wind[half] = wind.velocity.x, on.wind[half + 1] = wind.velocity.y, on.wind[half + 2] = wind.velocity.z;
    on.by_particle = !body.air.velocity.empty();
    on.before = to_float(scheme.earlier / scheme.next, 1);
    const float larger = std::max(wind.drag, wind.lift);
    on.drag = larger > 0 ? wind.drag / larger : 0, on.lift = larger > 0 ? wind.lift / larger : 0;
    constexpr double most = std::numeric_limits<float>::max();
    on.unit = to_float(newtons_per_unit(wind) / state.average_mass, most);
    on.most_rate = to_float(1 / (scheme.drag(body.settings.damping) * h), most);
    return on;
}

/// The forces on links and particles of a body that is solved as cloth is.
void blow_links(Body& body, const AirOnCloth& on) {
    const auto place = [&](uint32_t p) { return vector_at(body.cloth.state.at, p); };
    const auto relative = [&](uint32_t p) { return vector_at(body.air.relative, p); };
    add_up(body, place, relative, on.most_rate);
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        put(&body.cloth.state.acceleration[4 * size_t{p}],
            vector_at(body.air.steady, p) + body.air.force[p] * body.particles.inverse_mass[p], hardest);
    }
}

}  // namespace

void blow_cloth(Body& body, const CollisionContext& around, double h) {
    const ClothState& state = body.cloth.state;
    Air& air = body.air;
    if (around.begin == 0) std::copy(state.acceleration.begin(), state.acceleration.end(), air.steady.begin());
    const WindKernels& kernels = wind_kernels(chosen_isa());
    const AirOnCloth on = air_on_cloth(body, TimeScheme(h, body.history.earlier_step), h);
    for (uint32_t p = 0; on.by_particle && p < body.particles.size(); ++p)
        put(&air.relative[4 * size_t{p}], velocity_at(air, p), hardest);
    kernels.find_relative(on);
    const bool sheet = body.kind == GPHYS_BODY_CLOTH;
    if (sheet) {
        kernels.add_forces(on);
        kernels.accelerate(on);
    } else {
        blow_links(body, on);
    }
    if (!around.scene) return;
    for (const Attachment& attachment : body.constraints.attachments) {
        const uint32_t p = attachment.particle;
        const Vec3 force = sheet ? vector_at(air.cloth_forces, p) * newtons_per_unit(air.wind) : air.force[p];
        add_impulse(body, around, attachment.model, state.origin + vector_at(state.at, p), force * h);
    }
}

void set_air_velocities(Body& body, uint32_t first, uint32_t count, const gphys_vec3* velocities, uint32_t stride) {
    if (body.air.velocity.empty()) body.air.velocity.resize(body.particles.size());
    wake(body);
    const Strided<gphys_vec3> from(velocities, stride);
    for (uint32_t i = 0; i < count; ++i) body.air.velocity[first + i] = widen(from[i]);
}

}  // namespace gphys
