// Chains of bodies that are solved directly. The constraints of ropes and trees are a forest, which is peeled from its
// leaves inward: each chain leads from a leaf to another one, or to where the rest of the tree continues.
#include "solver/body.h"
#include "solver/rope/rope_kernels.h"

namespace gphys {
namespace {

/// Peels chains off from their leaves, particles with one constraint left: begin(leaf), then visit(slot, next particle)
/// along the chain, to another leaf or to a particle with further constraints. Trees are visited as a whole. What
/// remains of other graphs are their cycles and the paths between them. O(particles).
template <class Begin, class Visit>
void peel_chains(const Constraints& constraints, Vector<Links>& remaining, Begin&& begin, Visit&& visit) {
    remaining = constraints.links;
    for (uint32_t leaf = 0; leaf < remaining.size(); ++leaf) {
        if (remaining[leaf].degree != 1) continue;
        begin(leaf);
        for (uint32_t particle = leaf; remaining[particle].degree == 1;) {
            const uint32_t slot = remaining[particle].slots;
            remaining[particle] = {};
            particle = other_end(constraints.by_slot[slot], particle);
            --remaining[particle].degree;
            remaining[particle].slots ^= slot;
            visit(slot, particle);
        }
    }
}

/// Constraints of a particle. Elimination couples them all with each other, so its work grows with their third power.
constexpr uint32_t most_branches = 64;

uint32_t longest_chain(const Plan& plan) {
    uint32_t longest = 0;
    for (const Chain& chain : plan.chains) longest = std::max(longest, chain.link_count);
    return longest;
}

/// Forests are solved directly: peeling visits all their constraints.
gphys_solve_method method_of(const Body& body, uint32_t constraint_count, Vector<Links>& remaining) {
    if (body.cloth.volume.held || !body.cloth.clusters.empty()) return GPHYS_SOLVE_GRAPH;
    if (constraint_count == 0) return GPHYS_SOLVE_FREE;
    for (const Links& links : body.constraints.links) {
        if (links.degree > most_branches) return GPHYS_SOLVE_GRAPH;
    }
    uint32_t visited = 0;
    peel_chains(
        body.constraints, remaining, [](uint32_t) {}, [&](uint32_t, uint32_t) { ++visited; });
    return visited == constraint_count ? GPHYS_SOLVE_DIRECT : GPHYS_SOLVE_GRAPH;
}

}  // namespace

gphys_solve_method method_of(const Body& body, uint32_t constraint_count) {
    Vector<Links> remaining(body.constraints.links.get_allocator());
    return method_of(body, constraint_count, remaining);
}

gphys_solve_method method_of(const Body& body) { return method_of(body, body.constraints.ids.size()); }

gphys_solve_method method_of(const Body& body, Vector<Links>& remaining) {
    return method_of(body, body.constraints.ids.size(), remaining);
}

void copy_direct_parameters(Plan& plan, Rope& rope, const Constraints& constraints) {
    plan.copy_parameters(constraints);
    for (double& rest : plan.rest) rest = rest < rope_shortest ? 0 : rest;
    rope.damped_rest = plan.rest;
    rope.damped_compliance = plan.compliance;
    rope.target = plan.rest;
}

void plan_direct_chains(Plan& plan, Rope& rope, const Constraints& constraints) {
    plan.clear_chains();
    Vector<Links> remaining(constraints.links.get_allocator());
    peel_chains(
        constraints, remaining, [&](uint32_t leaf) { plan.begin_chain(leaf); },
        [&](uint32_t slot, uint32_t particle) { plan.add_link(slot, particle); });
    copy_direct_parameters(plan, rope, constraints);
    rope.rows.resize(longest_chain(plan) + 1);
    rope.earlier_tension.assign(plan.rest.size(), 0.0);
    rope.tension.assign(plan.rest.size(), 0.0);
    if (!rope.bending.resists()) return;
    rope.bending.bends.assign(plan.rest.size(), Bend{});
    rope.stiff_rows.resize(4 * rope.rows.size() + 2 * stiff_band);
}

}  // namespace gphys
