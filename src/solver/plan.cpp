// When the plan of a body is computed, and what follows from it. Constraints and pins change it part by part: the
// chains, the parameters of their links, adjacency lists and reach limits of cloth, and the layout of its kernels.
#include "solver/plan.h"

#include "solver/body.h"

namespace gphys {

void Plan::clear_chains() {
    chains.clear();
    colours.clear();
    particles.clear();
    slots.clear();
    rest.clear();
    compliance.clear();
    damping.clear();
    limit.clear();
}

void Plan::copy_parameters(const Constraints& constraints) {
    const size_t count = slots.size();
    rest.resize(count);
    compliance.resize(count);
    damping.resize(count);
    limit.resize(count);
    for (size_t link = 0; link < count; ++link) {
        const DistanceConstraint& constraint = constraints.by_slot[slots[link]];
        rest[link] = constraint.rest;
        compliance[link] = constraint.compliance;
        damping[link] = constraint.damping;
        limit[link] = static_cast<uint32_t>(constraint.limit);
    }
}

namespace {

/// Sets the flags of the plan that tell which kinds of links it has.
void classify_links(Plan& plan, const Constraints& constraints) {
    plan.branched = plan.method == GPHYS_SOLVE_DIRECT && std::any_of(constraints.links.begin(), constraints.links.end(),
                                                                     [](Links links) { return links.degree > 2; });
    plan.damped = std::any_of(plan.damping.begin(), plan.damping.end(), [](double damping) { return damping > 0; });
    plan.hubs.clear();
    if (plan.method == GPHYS_SOLVE_GRAPH) list_hubs(plan.hubs, constraints);
    plan.limited = std::find(plan.limit.begin(), plan.limit.end(), 1u) != plan.limit.end();
}

void pack_cloth(Body& body) {
    const uint32_t particles = body.particles.size();
    ClothBatches& batches = body.cloth.batches;
    pack_cloth_chains(batches, body.plan, particles);
    RigidLinks& rigid = body.cloth.rigid;
    if (body.kind == GPHYS_BODY_CLOTH) find_braces(rigid, body.constraints.ids.slots());
    rigid.edits.clear();
    rigid.listed_edits = 0;
    list_kept_links(body.cloth.relaxation.kept, batches, rigid, body.plan, particles);
}

/// Brings the lists of rigid links up to date, and the paths along them if they are known.
void update_rigid_links(Body& body) {
    RigidLinks& rigid = body.cloth.rigid;
    Vector<PinPath> paths = std::move(body.cloth.reach.paths);
    body.cloth.reach.paths.clear();  // not known, should this throw
    if (rigid.begin.empty()) return rigid.list(body.constraints, body.particles.size());
    const size_t first = rigid.listed_edits, last = rigid.edits.size();
    if (first < last || rigid.begin.size() != body.particles.size() + size_t{1}) {
        rigid.list_edits(body.constraints, body.particles.size());
        // No limits come from them while links can break.
        if (body.breaking.possible()) paths.clear();
        if (first < last && !paths.empty())
            repair_pin_paths(paths, rigid, rigid.edits.data() + first, rigid.edits.data() + last);
    }
    body.cloth.reach.paths = std::move(paths);
}

}  // namespace

void complete_plan(Body& body) {
    Plan& plan = body.plan;
    if (!plan.chains_current) return;
    if (plan.method == GPHYS_SOLVE_DIRECT) {
        Vector<double> tension = std::move(body.rope.tension);
        plan_direct_chains(plan, body.rope, body.constraints);
        body.rope.tension = std::move(tension);
    }
    if (plan.method == GPHYS_SOLVE_GRAPH) plan.copy_parameters(body.constraints);
    classify_links(plan, body.constraints);
    plan.described = true;
}

void update_plan(Body& body) {
    Plan& plan = body.plan;
    if (!plan.chains_current) {
        plan.chains_packed = false;
        plan.edits = 0;
        body.cloth.rigid.forget();
        plan.method = method_of(body);
        if (plan.method == GPHYS_SOLVE_FREE) plan.clear_chains();
        if (plan.method == GPHYS_SOLVE_DIRECT) plan_direct_chains(plan, body.rope, body.constraints);
        if (plan.method == GPHYS_SOLVE_GRAPH) plan_chain_colours(plan, body.constraints, body.particles);
        classify_links(plan, body.constraints);
        plan.chains_current = plan.described = true;
        plan.reach_current = false;
    }
    if (!plan.described) {
        if (plan.method == GPHYS_SOLVE_DIRECT) copy_direct_parameters(plan, body.rope, body.constraints);
        if (plan.method == GPHYS_SOLVE_GRAPH) plan.copy_parameters(body.constraints);
        classify_links(plan, body.constraints);
        plan.chains_packed = false;
        plan.described = true;
    }
    if (plan.method == GPHYS_SOLVE_GRAPH) update_rigid_links(body);
    if (!plan.reach_current) {
        Cloth& cloth = body.cloth;
        cloth.reach.limits.clear();
        plan.pins_packed = false;
        // Limits would carry loads past the links.
        if (plan.method == GPHYS_SOLVE_GRAPH && !body.breaking.possible())
            plan_reach_limits(cloth.reach, cloth.rigid, body.particles, cloth.sheet);
        plan.reach_current = true;
    }
    if (plan.method != GPHYS_SOLVE_GRAPH) return;
    // Pins change without the chains.
    if (!plan.chains_packed) {
        plan.pins_packed = false;
        pack_cloth(body);
        plan.chains_packed = true;
    }
    if (!plan.pins_packed) {
        pack_reach_limits(body.cloth.reach, body.particles.size());
        mark_attached(body.cloth.batches, body.constraints, body.particles);
        list_pinned_spans(body.cloth, plan, body.particles);
        plan.crowded =
            std::any_of(plan.hubs.begin(), plan.hubs.end(), [&](uint32_t hub) { return !body.particles.pinned(hub); });
        plan.pins_packed = true;
    }
}

}  // namespace gphys
