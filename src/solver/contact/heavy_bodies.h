// The bodies that can be loads of cloth and ropes: free particles, particles of ropes, and rigid clusters.
#pragma once

#include "solver/body.h"
#include "solver/contact/particle_contacts.h"

namespace gphys {

class ParticleContacts::HeavyBodies {
public:
    static constexpr uint32_t none = 0xffffffff;

    HeavyBodies(const Range& range, BodyTable& bodies) : range_(range), bodies_(bodies) {}

    /// Whether particles of a body may be loads: free ones, those of ropes, and rigid clusters that nothing in their
    /// body holds, since the links of cloth and other clusters would act on them afterwards.
    static bool may_press(const Body& body) {
        const Cloth& cloth = body.cloth;
        if (!is_graph(body)) return !body.plan.joined;
        return !body.plan.joined && cloth.batches.chains.empty() && !cloth.clusters.empty() && !cloth.clusters.overlap;
    }
    /// The first particle of what moves as one with a particle that presses; none if it is no load, or pins hold it.
    uint32_t first_of(uint32_t by) const;
    double inverse_mass_of(uint32_t of) const;
    /// The load whose first particle is `of`, after the prediction of a substep of `h` seconds.
    HeavyBody find(uint32_t of, const LoadUnits& units, Vec3 gravity, double h) const;
    /// As it is now: it may press on several bodies, one of which has moved it.
    LoadMotion motion_of(const HeavyBody& heavy, const LoadUnits& units) const;
    /// Metres: how far contacts have moved its centre since the prediction.
    Vec3 pushed(const HeavyBody& heavy) const;
    /// Moves the particles of a load by HeavyBody::moved and turned, and gives them its motion.
    void move(const HeavyBody& heavy);

private:
    HeavyBody particle(uint32_t of, const LoadUnits& units, Vec3 gravity, double h) const;
    HeavyBody cluster(uint32_t of, const LoadUnits& units, double h) const;
    void move_cluster(const HeavyBody& heavy);

    const Range& range_;
    BodyTable& bodies_;
};

}  // namespace gphys
