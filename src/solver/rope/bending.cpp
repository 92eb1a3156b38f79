// Bending stiffness of chains: what does not depend on how their equations are solved (bending.h).
#include "solver/rope/bending.h"

#include "solver/body.h"
#include "solver/contact/impulses.h"

namespace gphys {

void find_bends(Bending& bending, const Plan& plan, const Constraints& constraints, const Particles& particles) {
    if (!bending.resists()) return;
    for (const Chain& chain : plan.chains) {
        const uint32_t* const particle = &plan.particles[chain.first_particle];
        const auto is_held = [&](uint32_t i) {
            return particles.pinned(particle[i]) && particles.pinned(particle[i + 1]);
        };
        for (uint32_t i = 1; i < chain.link_count; ++i) {
            const uint32_t link = chain.first_link + i;
            const double before = plan.rest[link - 1], after = plan.rest[link];
            const double bent = (is_held(i - 1) ? 0 : before / 2) + (is_held(i) ? 0 : after / 2);
            const bool branches = constraints.links[particle[i]].degree > 2;
            bending.bends[link] = branches ? Bend{} : Bend::between(bending.stiffness, before, after, bent);
        }
    }
}

double bending_energy(const Body& body) {
    const double stiffness = body.rope.bending.stiffness;
    const Constraints& constraints = body.constraints;
    const Particles& particles = body.particles;
    // Whether the links are a forest is known from the last step. Before that, by their number, without a search.
    const bool direct =
        body.plan.chains_current ? body.plan.method == GPHYS_SOLVE_DIRECT : constraints.ids.size() < particles.size();
    if (stiffness == 0 || !direct) return 0;
    const auto bent = [&](const DistanceConstraint& link) {
        return particles.pinned(link.a) && particles.pinned(link.b) ? 0 : counted_length(link.rest) / 2;
    };
    double sum = 0;
    // The plan may be out of date. Each pair of links is found at that with the lower slot.
    for (const uint32_t slot : constraints.ids) {
        const DistanceConstraint& link = constraints.by_slot[slot];
        for (const uint32_t p : {link.a, link.b}) {
            const uint32_t other_slot = constraints.links[p].slots ^ slot;
            if (constraints.links[p].degree != 2 || other_slot < slot) continue;
            const DistanceConstraint& other = constraints.by_slot[other_slot];
            const Bend bend = Bend::between(stiffness, counted_length(link.rest), counted_length(other.rest),
                                            bent(link) + bent(other));
            sum += length_squared(bend.strain(particles.position[other_end(link, p)], particles.position[p],
                                              particles.position[other_end(other, p)])) /
                   2;
        }
    }
    return sum;
}

void add_bending_impulses(Body& body, const CollisionContext& around, const TimeScheme& scheme) {
    const auto add = [&](const Vector<Vec3>& at, double seconds) {
        each_bending_force(body.rope.bending, body.plan, at, [&](uint32_t p, Vec3 force) {
            if (body.particles.pinned(p)) add_anchor_impulse(body, around, p, force * seconds);
        });
    };
    add(body.particles.position, scheme.h);
    if (scheme.explicit_h > 0) add(body.history.start, scheme.explicit_h);
}

}  // namespace gphys
