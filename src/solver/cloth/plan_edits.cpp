// Edits of the plan of cloth: a constraint that is added becomes a chain of its own, in the first colour without its
// two particles (greedy graph colouring); a constraint that is removed splits its chain in two. All other chains and
// colours stay. Planning a sheet of 100 x 100 again takes about as long as a step, an edit takes O(chains). But edits
// leave shorter chains and more colours than a new plan, so after most_edits of them in one step the body is planned
// again.
#include "solver/body.h"

namespace gphys {
namespace {

/// Whether a body without this constraint is still solved as a graph.
bool has_ring_without(Body& body, uint32_t slot) {
    struct Without {
        Constraints& constraints;
        uint32_t slot;

        Without(Constraints& c, uint32_t removed) : constraints(c), slot(removed) { change_links(c, slot, -1); }
        ~Without() { change_links(constraints, slot, 1); }
    };
    const Without without(body.constraints, slot);
    return method_of(body, body.constraints.ids.size() - 1) == GPHYS_SOLVE_GRAPH;
}

uint32_t end_particle(const Chain& chain) { return chain.first_particle + chain.link_count + 1; }
uint32_t end_link(const Chain& chain) { return chain.first_link + chain.link_count; }

/// Computes where the chains from number `from` on begin in the arrays, which hold them one after the other.
void number_chains(Plan& plan, size_t from) {
    for (size_t i = from; i < plan.chains.size(); ++i) {
        plan.chains[i].first_particle = i == 0 ? 0 : end_particle(plan.chains[i - 1]);
        plan.chains[i].first_link = i == 0 ? 0 : end_link(plan.chains[i - 1]);
    }
}

template <class T>
auto at(Vector<T>& values, size_t i) {
    return values.begin() + static_cast<typename Vector<T>::difference_type>(i);
}

/// Restores the order by length after a chain became shorter: moves it behind the longer chains of its colour. `end`:
/// the first chain of the next colour.
void move_behind_longer(Plan& plan, size_t chain, size_t end) {
    const Chain moved = plan.chains[chain];
    size_t next = chain + 1;
    while (next < end && plan.chains[next].link_count > moved.link_count) ++next;
    const Chain last = plan.chains[next - 1];
    std::rotate(at(plan.particles, moved.first_particle), at(plan.particles, end_particle(moved)),
                at(plan.particles, end_particle(last)));
    std::rotate(at(plan.slots, moved.first_link), at(plan.slots, end_link(moved)), at(plan.slots, end_link(last)));
    std::rotate(at(plan.chains, chain), at(plan.chains, chain + 1), at(plan.chains, next));
    number_chains(plan, chain);
}

/// Where the particles of a colour begin in the plan's array; for the number of colours, the end of that array.
uint32_t colour_begin(const Plan& plan, size_t colour) {
    const uint32_t chain = plan.colours[colour];
    return chain < plan.chains.size() ? plan.chains[chain].first_particle
                                      : static_cast<uint32_t>(plan.particles.size());
}

bool has_either(const Plan& plan, size_t colour, uint32_t a, uint32_t b) {
    const auto begin = plan.particles.begin() + colour_begin(plan, colour);
    const auto end = plan.particles.begin() + colour_begin(plan, colour + 1);
    return std::any_of(begin, end, [&](uint32_t p) { return p == a || p == b; });
}

/// The first colour of constraints of the same kind (limit or not) that has neither particle. If there is none, adds a
/// colour behind those of that kind.
size_t colour_for(const Body& body, Plan& plan, const DistanceConstraint& constraint) {
    size_t colour = 0;
    for (; colour + 1 < plan.colours.size(); ++colour) {
        const uint32_t slot = plan.slots[plan.chains[plan.colours[colour]].first_link];
        const uint64_t limit = body.constraints.by_slot[slot].limit;
        if (limit > constraint.limit) break;
        if (limit == constraint.limit && !has_either(plan, colour, constraint.a, constraint.b)) return colour;
    }
    plan.colours.insert(at(plan.colours, colour), plan.colours[colour]);
    return colour;
}

/// Marks what was computed from the chains and from this constraint as out of date. Uses reserved memory.
void note_edit(Body& body, uint32_t slot, bool added) {
    const DistanceConstraint& constraint = body.constraints.by_slot[slot];
    body.plan.described = false;
    if (constraint.compliance == 0) {
        body.cloth.rigid.edits.push_back({constraint.a, constraint.b, slot, constraint.rest, added});
        body.plan.reach_current = false;
    }
    body.contacts.self.linked_begin.clear();
    ++body.plan.edits;
}

void reserve_edits(Body& body, uint32_t count) {
    Plan& plan = body.plan;
    reserve_more(plan.chains, count);
    reserve_more(plan.colours, count);
    reserve_more(plan.particles, 2 * count);
    reserve_more(plan.slots, count);
    reserve_more(body.cloth.rigid.edits, count);
}

}  // namespace

void reserve_plan_edits(Body& body) { reserve_edits(body, Plan::most_edits); }

bool can_add_to_plan(Body& body) {
    const Plan& plan = body.plan;
    if (!plan.chains_current || plan.method != GPHYS_SOLVE_GRAPH || plan.edits == Plan::most_edits) return false;
    reserve_edits(body, 1);
    return true;
}

bool can_remove_from_plan(Body& body, uint32_t slot) { return can_add_to_plan(body) && has_ring_without(body, slot); }

void add_to_plan(Body& body, uint32_t slot) {
    Plan& plan = body.plan;
    const DistanceConstraint& constraint = body.constraints.by_slot[slot];
    const size_t colour = colour_for(body, plan, constraint);
    const uint32_t chain = plan.colours[colour + 1];
    const uint32_t particle = colour_begin(plan, colour + 1);
    const uint32_t link = particle - chain;  // each chain has a particle more than links
    plan.particles.insert(at(plan.particles, particle), {constraint.a, constraint.b});
    plan.slots.insert(at(plan.slots, link), slot);
    plan.chains.insert(at(plan.chains, chain), {particle, link, 1});
    number_chains(plan, chain);
    for (size_t i = colour + 1; i < plan.colours.size(); ++i) ++plan.colours[i];
    note_edit(body, slot, true);
}

void remove_from_plan(Body& body, uint32_t slot) {
    Plan& plan = body.plan;
    const uint32_t link =
        static_cast<uint32_t>(std::find(plan.slots.begin(), plan.slots.end(), slot) - plan.slots.begin());
    const auto after = std::upper_bound(plan.chains.begin(), plan.chains.end(), link,
                                        [](uint32_t l, const Chain& chain) { return l < chain.first_link; });
    const size_t i = static_cast<size_t>(after - plan.chains.begin()) - 1;
    const Chain whole = plan.chains[i];
    const uint32_t before = link - whole.first_link, behind = whole.link_count - before - 1;
    // An end of the chain with no link left loses its particle, too.
    if (behind == 0) plan.particles.erase(at(plan.particles, end_particle(whole) - 1));
    if (before == 0) plan.particles.erase(at(plan.particles, whole.first_particle));
    plan.slots.erase(at(plan.slots, link));
    const uint32_t parts = uint32_t{before > 0} + uint32_t{behind > 0};
    if (parts == 0) plan.chains.erase(at(plan.chains, i));
    if (parts == 2) plan.chains.insert(at(plan.chains, i + 1), {0, 0, behind});
    if (parts > 0) plan.chains[i].link_count = before > 0 ? before : behind;
    const auto colour = std::upper_bound(plan.colours.begin(), plan.colours.end(), static_cast<uint32_t>(i));
    for (auto end = colour; end != plan.colours.end(); ++end) *end += parts - 1;
    number_chains(plan, i);
    const size_t end = *colour;
    for (uint32_t part = parts; part-- > 0;) move_behind_longer(plan, i + part, end);
    if (*colour == *(colour - 1)) plan.colours.erase(colour);
    note_edit(body, slot, false);
}

}  // namespace gphys
