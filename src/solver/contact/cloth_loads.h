// The contacts in which something heavy presses on cloth, as loads of its links (cloth/contact_loads.h).
#pragma once

#include "solver/body.h"
#include "solver/contact/particle_contacts.h"

namespace gphys {

class ParticleContacts::ClothLoads {
public:
    ClothLoads(const Range& range, const Island& island, BodyTable& bodies, const uint32_t* slots)
        : range_(range), bodies_(bodies), first_(slots), end_(slots + island.body_count) {}

    /// Whether particles of a body may be loads: free ones, those of ropes, and rigid clusters that nothing in their
    /// body holds, since the links of cloth and other clusters would act on them afterwards.
    static bool may_press(const Body& body) {
        const Cloth& cloth = body.cloth;
        if (!is_graph(body)) return !body.plan.joined;
        return !body.plan.joined && cloth.batches.chains.empty() && !cloth.clusters.empty() && !cloth.clusters.overlap;
    }
    /// Finds the loads of all cloth. Call when the contacts have corrected the prediction.
    void find(Vec3 gravity, double h);
    /// Whether `find` has found any.
    bool any() const;
    /// Moves the loads as the links have moved the cloth under them.
    void move(const CollisionContext& around);

private:
    static constexpr uint32_t none = 0xffffffff;

    static bool may_be_loaded(const Body& body) {
        return is_graph(body) && !body.plan.joined && !body.cloth.batches.chains.empty() &&
               !body.cloth.loads.is_loaded.empty();
    }
    uint32_t first_of(uint32_t by) const;
    double inverse_mass_of(uint32_t of) const;
    const Body& body_of(const ContactLoad& share) const { return bodies_[range_.particles[share.by].body]; }
    void leave_out_carried_ropes(ContactLoads& loads) const;
    void add(const Pair& pair, uint32_t on, uint32_t by, Vec3 normal);
    HeavyBody heavy_particle(uint32_t of, const Body& cloth, Vec3 gravity, double h) const;
    HeavyBody heavy_cluster(uint32_t of, const Body& cloth, double h) const;
    LoadMotion motion_of(const HeavyBody& heavy, const Body& cloth) const;
    void move_cluster(const HeavyBody& heavy);

    const Range& range_;
    BodyTable& bodies_;
    const uint32_t *const first_, *const end_;  // slots of the bodies
};

}  // namespace gphys
