// Contacts of balls of very unequal masses (rigid_contacts.h).
#include "solver/body.h"
#include "solver/contact/particle_contacts.h"

namespace gphys {
namespace {

// Gauss-Seidel sweeps pass a load on by the ratio of the masses. Where a ball touches one that is so many times
// lighter, all contacts between balls are solved together, as those of clusters are.
constexpr double unequal = 8;

}  // namespace

bool ParticleContacts::has_unequal_balls(const BodyTable& bodies, const uint32_t* first, const uint32_t* end) {
    double lightest = infinity, heaviest = 0;
    for (const uint32_t* slot = first; slot != end; ++slot) {
        const Body& body = bodies[*slot];
        if (!moves_freely(body) || !collides_with_others(body)) continue;
        for (uint32_t p = 0; p < body.particles.size(); ++p) {
            if (body.particles.pinned(p)) continue;
            lightest = std::min(lightest, body.particles.mass[p]);
            heaviest = std::max(heaviest, body.particles.mass[p]);
        }
    }
    return heaviest > unequal * lightest;
}

/// Where the masses of two balls in contact are unequal, all contacts of balls become rigid. Returns whether they do.
bool ParticleContacts::couple_unequal(const Range& range) {
    const bool any = any_contact(range, [](const Contact& contact) {
        return contact.both_free && std::max(contact.part_of_a, contact.part_of_b) > unequal / (unequal + 1);
    });
    if (!any) return false;
    any_contact(range, [](Contact& contact) {
        contact.rigid = contact.rigid || contact.both_free;
        return false;
    });
    return true;
}

/// Undoes that, and what contacts have done since.
void ParticleContacts::uncouple_unequal(const Range& range) {
    any_contact(range, [&](Contact& contact) {
        contact.rigid = range.particles[contact.a].cluster || range.particles[contact.b].cluster;
        contact.separation = contact.more_separation = contact.friction_displacement = 0;
        contact.normal_change = contact.more_change = contact.friction_change = 0;
        return false;
    });
}

/// Whether the solution has moved particles farther than contacts can have made necessary. Corrections are a
/// projection: with the masses as weights, they are no longer than the way from where nothing was in contact, or
/// overlapped less. Among balls that are pressed deep into each other, the iterations may not converge.
bool ParticleContacts::have_thrown(const Range& range, Vec3 Particle::*value, Vec3 Particle::*uncorrected,
                                   Vec3 Particle::*before) {
    constexpr double farthest = 2;
    double moved = 0, way = 0;
    for (const Particle* p = range.particles; p != range.particles + range.count; ++p) {
        if (p->inverse_mass == 0 || p->*value == p->*uncorrected) continue;
        moved += length_squared(p->*value - p->*uncorrected) / p->inverse_mass;
        way += length_squared(before ? p->*uncorrected - p->*before : p->*uncorrected) / p->inverse_mass;
    }
    any_contact(range, [&](const Contact& contact) {
        const double lightest =
            std::min(range.particles[contact.a].inverse_mass, range.particles[contact.b].inverse_mass);
        const double apart = before ? contact.most_separation : contact.target_speed;
        if (contact.rigid && contact.separation > 0 && lightest > 0) way += apart * apart / lightest;
        return false;
    });
    return !(moved <= farthest * farthest * way);
}

}  // namespace gphys
