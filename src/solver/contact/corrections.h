// What corrections of the places of particles in contact do to their bodies. For particle_contacts.cpp.
#pragma once

#include "solver/body.h"
#include "solver/contact/collision.h"
#include "solver/contact/collision_memory.h"
#include "solver/particles/flight_planes.h"
#include "solver/quads.h"
#include "solver/time_scheme.h"

namespace gphys {

/// Calls visit(particle, displacement) for the particles that contacts have moved.
template <class Particle, class Visit>
void each_moved(const Particle* first, const Particle* end, Visit&& visit) {
    for (const Particle* p = first; p != end; ++p) {
        if (p->inverse_mass > 0 && p->at != p->uncorrected) visit(p->number, p->at - p->uncorrected);
    }
}

/// A displacement of a particle by contacts, in a substep of h seconds, is to change its velocity by displacement / h,
/// as it does in bodies without links, or momentum would not be conserved. With the history of an undisturbed motion
/// the time scheme would change it by up to 5 / 3 of that, so the history is displaced, too.
inline void displace_history(Body& body, uint32_t particle, Vec3 displacement, double h) {
    if (TimeScheme(h, body.history.earlier_step).earlier == 0) return;
    const Vec3 back = displacement * (body.history.earlier_step / h);
    if (is_graph(body)) {
        float* const moved = &body.cloth.state.moved[4 * size_t{particle}];
        put(moved, get(moved) + back);
    } else {
        body.history.earlier[particle] -= back;
    }
}

/// For particles of a body whose constraints are solved afterwards: corrects their predicted positions. h: seconds of
/// the substep.
template <class Particle>
void correct_predicted(const Particle* first, const Particle* end, Body& body, double h) {
    if (is_graph(body)) {
        for (const Particle* p = first; p != end; ++p) {
            const Vec3 displacement = p->inverse_mass > 0 ? p->at - p->uncorrected : Vec3{};
            float* const at = &body.cloth.state.at[4 * size_t{p->number}];
            if (displacement != Vec3{}) {
                body.contacts.pushed = true;
                put(at, get(at) + displacement);
                displace_history(body, p->number, displacement, h);
            }
            if (!p->supports) continue;
            note_correction(body.cloth.contacts, p->number, displacement, p->supports->push(), p->supports->friction());
        }
        return;
    }
    each_moved(first, end, [&](uint32_t p, Vec3 displacement) {
        body.contacts.pushed = true;
        body.particles.position[p] += displacement;
        body.history.predicted[p] += displacement;
        displace_history(body, p, displacement, h);
        if (body.plan.limited) body.rope.slack[p] = 0;
    });
}

/// The same for consecutive particles of a body without links, or with links that have been solved.
template <class Particle>
void correct_block(const Particle* first, const Particle* end, Body& body, const CollisionContext& around,
                   const ImpulseAccumulator& accumulator, double bounce_threshold, FlightPlanes* planes,
                   CollisionMemory* memory) {
    Extent places;
    double longest = 0;
    each_moved(first, end, [&](uint32_t p, Vec3 displacement) {
        places.add({{body.particles.position[p], body.particles.position[p]}, {}});
        longest = std::max(longest, length_squared(displacement));
    });
    if (longest > 0 && collides(body, around)) {
        const double room = 2 * body.particles.largest_radius + std::sqrt(longest);
        const Vec3 reach{room, room, room};
        if (planes) planes->select_pushed(body, around, first->number, static_cast<uint32_t>(end - first));
        const Collider& collider = memory->collider.emplace(
            around, body, bounds(Aabb{places.box.min - reach, places.box.max + reach}), accumulator, planes);
        if (!collider.idle()) {
            each_moved(first, end, [&](uint32_t p, Vec3 displacement) {
                collider.slide(body, p, body.particles.position[p], displacement, around.end, bounce_threshold);
            });
            return;
        }
    }
    each_moved(first, end, [&](uint32_t p, Vec3 displacement) {
        body.particles.position[p] += displacement;
        keep_in_range(body.particles.position[p], body.particles.velocity[p]);
    });
}

/// For particles at the end of their substep: corrects their positions as far as the models allow. `planes` and `team`:
/// as in fly.
template <class Particle>
void correct_moved(const Particle* first, const Particle* end, Body& body, const CollisionContext& around,
                   double bounce_threshold, FlightPlanes* planes, Team* team) {
    if (is_graph(body)) {
        each_moved(first, end, [&](uint32_t p, Vec3 displacement) {
            float* const at = &body.cloth.state.at[4 * size_t{p}];
            put(at, get(at) + displacement);
            if (collides(body, around) && push_out_of_planes(body.cloth.contacts, body.cloth.state, p))
                body.cloth.contacts.clusters_pushed = true;
        });
        push_out_clusters(body);
        return;
    }
    if (body.flight.all.empty()) planes = nullptr;
    const uint32_t count = static_cast<uint32_t>(end - first);
    constexpr uint32_t size = FlightPlanes::most_particles;
    share(body.contacts.parts.empty() ? nullptr : team, (count + size - 1) / size,
          [&](uint32_t block, uint32_t member) {
              const Particle* const begin = first + block * size;
              correct_block(begin, begin + std::min(size, count - block * size), body, around,
                            body.contacts.accumulator(block), bounce_threshold, planes ? planes + member : nullptr,
                            around.memory ? around.memory + member : nullptr);
          });
}

}  // namespace gphys
