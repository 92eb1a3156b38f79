// The contacts in which something heavy presses on cloth, as loads of its links (cloth/contact_loads.h).
#pragma once

#include "solver/body.h"
#include "solver/contact/heavy_bodies.h"

namespace gphys {

struct Joined;

class ParticleContacts::ClothLoads {
public:
    ClothLoads(const Range& range, const Island& island, BodyTable& bodies, const uint32_t* slots)
        : range_(range), bodies_(bodies), heavy_(range, bodies), first_(slots), end_(slots + island.body_count) {}

    /// Finds the loads of all cloth. Call when the contacts have corrected the prediction.
    void find(Vec3 gravity, double h);
    /// Whether `find` has found any.
    bool any() const;
    /// Moves the loads as the links have moved the cloth under them.
    void move(const Joined& joined, const CollisionContext& around, Vec3 gravity);

private:
    static bool may_be_loaded(const Body& body) {
        return is_graph(body) && !body.cloth.batches.chains.empty() && !body.cloth.loads.is_loaded.empty();
    }
    static LoadUnits units_of(const Body& cloth) { return {cloth.cloth.state.origin, cloth.cloth.state.average_mass}; }
    const Body& body_of(const ContactLoad& share) const { return bodies_[range_.particles[share.by].body]; }
    void bound_joined_energy(const Joined& joined, Vec3 gravity);
    void leave_out_carried_ropes(ContactLoads& loads) const;
    void add(const Pair& pair, const Contact& contact, uint32_t on, uint32_t by, Vec3 normal);

    const Range& range_;
    BodyTable& bodies_;
    HeavyBodies heavy_;
    const uint32_t *const first_, *const end_;  // slots of the bodies
};

}  // namespace gphys
