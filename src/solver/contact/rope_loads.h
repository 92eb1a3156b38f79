// What presses on ropes and is much heavier, as loads of their links: balls, and rigid clusters such as crates.
//
// Contacts are solved before the links. A light particle of a rope gives way there, and its links would then pull it
// back without a force on what presses on it. So while the links are solved, a pressed particle has the mass of its
// share of the load, too, and the load moves by the sum of what its shares take (mass splitting; Tonge, Benevolenski
// and Voroshilov 2012). That conserves momentum. Without friction a particle has this mass along the normal of the
// contact only. With any friction it sticks: bounded by Coulomb's law in each substep, crates slip out of slings. A
// cluster is one load, as on cloth (cloth/contact_loads.h): a share has the mass that the cluster has at the particle
// that presses.
//
// Links that are strained when a load arrives, by what Newton's method has left, would give it speed as a spring does.
// So if nothing outside does work on the ropes of an island, and pins or models take the momentum, the impulses of the
// links on loads are scaled so that ropes and loads together have no more energy than before.
#pragma once

#include "solver/contact/heavy_bodies.h"

namespace gphys {

class ParticleContacts::RopeLoads {
public:
    RopeLoads(const Range& range, const Island& island, BodyTable& bodies, const uint32_t* slots)
        : range_(range), bodies_(bodies), heavy_(range, bodies), first_(slots), end_(slots + island.body_count) {}

    /// Whether particles of a body may be loads of ropes. Those of other ropes have links of their own.
    static bool may_press(const Body& body) {
        return (moves_freely(body) || is_graph(body)) && HeavyBodies::may_press(body);
    }
    /// Finds the loads of all ropes. Call when the contacts have corrected the prediction.
    void find(Vec3 gravity, double h);
    bool any() const;
    /// Moves the loads as the links have moved the ropes under them.
    void move(const CollisionContext& around);

private:
    static constexpr LoadUnits units{{}, 1};

    static bool is_rope(const Body& body) { return body.plan.method == GPHYS_SOLVE_DIRECT; }
    void add(const Pair& pair, const Contact& contact, uint32_t on, uint32_t by, Vec3 normal);
    void divide_loads(Body& rope, Vec3 gravity, double h);
    void move_by(Body& rope);
    template <class Visit>
    void each_load(Visit&& visit);
    void bound_energy(const CollisionContext& around);

    const Range& range_;
    BodyTable& bodies_;
    HeavyBodies heavy_;
    const uint32_t *const first_, *const end_;  // slots of the bodies
};

}  // namespace gphys
