// Bending stiffness of chains. At a particle between two links of rest lengths l and l', which are straight at rest,
// the energy is that of a rod with unit tangents T and T' (Bergou et al. 2008, "Discrete elastic rods", with the chord
// of the turning angle in place of its tangent):
//
//     stiffness / (l + l') |T' - T|^2 = |r|^2 / 2,   r = after (x_next - x) - before (x - x_previous),
//     before = s / l, after = s / l', s = sqrt(2 stiffness / (l + l'))
//
// Between links of equal length it is stiffness / l (1 - cos angle). With the links at rest length it is quadratic in
// the positions and the same in all directions. So the matrix of its second derivatives is constant and
// semidefinite: three equal matrices of five diagonals, which stiff_chains.cpp and joints/ add to the equations of the
// links. Newton's method solves it exactly, in each iteration. Forces and torques add up to zero.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/plan.h"

namespace gphys {

struct Body;
struct Constraints;
struct Particles;
struct TimeScheme;
struct CollisionContext;

/// A particle between two links of a chain, sqrt(N/m); 0 where the chain does not resist bending.
struct Bend {
    double before = 0, after = 0;

    /// Between links of these rest lengths, of which `bent` metres belong to the particle and can bend.
    static Bend between(double stiffness, double before, double after, double bent) {
        if (before == 0 || after == 0 || bent == 0) return {};
        const double s = std::sqrt(stiffness / bent);
        return {s / before, s / after};
    }
    bool resists() const { return after > 0; }
    Vec3 strain(Vec3 previous, Vec3 at, Vec3 next) const { return (next - at) * after - (at - previous) * before; }
};

struct Bending {
    explicit Bending(std::pmr::memory_resource* memory) : bends(memory) {}

    bool resists() const { return stiffness > 0; }

    double stiffness = 0;  // N m^2
    Vector<Bend> bends;    // by link of the plan, at its first particle; empty if the body does not resist bending
    // Whether the chains are not moved but corrected. Then they keep their predicted shape instead of straightening.
    bool keeps_shape = false;
};

/// Computes the bends from the rest lengths of the plan and the pins. A chain bends freely at particles with more than
/// two links, as it does beside a link without length. Half of each link belongs to either end. A link between two pins
/// does not bend, so only the other half counts: then a clamped end is exact to second order in the lengths of links.
void find_bends(Bending& bending, const Plan& plan, const Constraints& constraints, const Particles& particles);

/// Calls visit(particle, newtons), three times for each bend, with the forces at the given places.
template <class Visit>
void each_bending_force(const Bending& bending, const Plan& plan, const Vector<Vec3>& at, Visit&& visit) {
    if (!bending.resists()) return;
    for (const Chain& chain : plan.chains) {
        const uint32_t* const particle = &plan.particles[chain.first_particle];
        for (uint32_t i = 1; i < chain.link_count; ++i) {
            const Bend& bend = bending.bends[chain.first_link + i];
            if (!bend.resists()) continue;
            const Vec3 strain = bend.strain(at[particle[i - 1]], at[particle[i]], at[particle[i + 1]]);
            visit(particle[i - 1], strain * -bend.before);
            visit(particle[i], strain * (bend.before + bend.after));
            visit(particle[i + 1], strain * -bend.after);
        }
    }
}

/// Joules, with the present constraints and pins; 0 for bodies that are not solved directly.
double bending_energy(const Body& body);

/// Adds the bending forces at attached particles to the impulses of their models.
void add_bending_impulses(Body& body, const CollisionContext& around, const TimeScheme& scheme);

}  // namespace gphys
