// Statistics of bodies: strain, energy, contacts, impulses.
#include "solver/solver.h"

namespace gphys {
namespace {

struct Totals {
    uint32_t particles = 0, pinned = 0, constraints = 0, contacts = 0, rigid = 0;
    double strain_max = 0, strain_squared = 0, kinetic = 0, potential = 0;
};

void add(const Body& body, Vec3 gravity, Totals& totals) {
    totals.particles += body.particles.size();
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        totals.pinned += body.particles.pinned(p);
        if (!body.particles.pinned(p))
            totals.kinetic += 0.5 * body.particles.mass[p] * length_squared(body.particles.velocity[p]);
        totals.potential -= body.particles.mass[p] * dot(gravity, body.particles.position[p]);
    }
    totals.potential += bending_energy(body);
    if (body.cloth.volume.held)
        totals.potential += stored_in_volume(body.cloth.volume, volume_of(body.cloth.sheet, body.particles));
    totals.constraints += body.constraints.ids.size();
    for (const uint32_t slot : body.constraints.ids) {
        const DistanceConstraint& c = body.constraints.by_slot[slot];
        const double stretch = excess(body.particles, c);
        if (c.compliance > 0) {
            totals.potential += 0.5 * stretch * stretch / c.compliance;
        } else if (c.rest > 0) {
            const double strain = std::fabs(stretch) / c.rest;
            totals.strain_max = std::max(totals.strain_max, strain);
            totals.strain_squared += strain * strain;
            ++totals.rigid;
        }
    }
    for (const ContactPoint& point : body.contacts.points) totals.contacts += point.model != 0;
}

}  // namespace

gphys_solver_stats Solver::stats(gphys_body_id id) const {
    Totals totals;
    if (id != 0) {
        add(body(id), state_.settings.gravity, totals);
    } else {
        for (const Body& each : state_.bodies) add(each, state_.settings.gravity, totals);
    }
    const double strain_rms = totals.rigid > 0 ? std::sqrt(totals.strain_squared / totals.rigid) : 0;
    return {totals.particles,
            totals.pinned,
            totals.constraints,
            totals.contacts,
            to_float(totals.strain_max),
            to_float(strain_rms),
            to_float(totals.kinetic),
            to_float(totals.potential)};
}

void Solver::impulses(Smallest<gphys_impulse, ImpulseOrder>& out) const {
    const auto narrowed = [](Vec3 v) { return gphys_vec3{to_float(v.x), to_float(v.y), to_float(v.z)}; };
    impulse_sums_.each([&](const ModelImpulse& given) {
        out.add({given.model, given.tag, narrowed(given.linear), narrowed(given.angular)});
    });
}

void Solver::body_contacts(Smallest<gphys_body_contact, BodyContactOrder>& out) const {
    for (const BodyContact& contact : particle_contacts_.listed()) {
        if (!state_.ids.has(contact.body_a) || !state_.ids.has(contact.body_b)) continue;
        const Particles &of_a = body(contact.body_a).particles, &of_b = body(contact.body_b).particles;
        const uint32_t a = contact.particle_a, b = contact.particle_b;
        const float gap = to_float(distance(of_a.position[a], of_b.position[b]) - of_a.radius[a] - of_b.radius[b]);
        if (contact.body_a < contact.body_b) {
            out.add({contact.body_a, a, contact.body_b, b, contact.normal, gap, contact.impulse});
        } else {
            out.add({contact.body_b, b, contact.body_a, a, narrow(-widen(contact.normal)), gap, contact.impulse});
        }
    }
}

void Solver::contacts(Smallest<gphys_contact, ContactOrder>& out) const {
    for (const uint32_t slot : state_.ids) {
        const Vector<ContactPoint>& points = state_.bodies[slot].contacts.points;
        for (size_t i = 0; i < points.size(); ++i) {
            const ContactPoint& t = points[i];
            const uint32_t particle = static_cast<uint32_t>(i / contact_points_per_particle);
            if (t.model != 0) out.add({state_.ids.id(slot), particle, t.model, t.tag, t.point, t.normal});
        }
    }
}

}  // namespace gphys
