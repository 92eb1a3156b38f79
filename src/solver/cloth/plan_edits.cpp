// A constraint that comes or goes changes the plan of cloth beside it only: it becomes a chain of its own, or the chain
// that it was in is parted there. All other chains and colours stay, and a step does not plan the body again.
#include "solver/body.h"

namespace gphys {
namespace {

/// Whether a body that loses a constraint is still a graph with a ring.
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

/// Chains from one on lie in the arrays one behind the other.
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

/// A chain that has become shorter goes behind the longer ones of its colour, which ends with chain `end`.
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

/// The first particle of a colour in the plan's array; of the colour behind the last one its end.
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

/// The lowest colour of its kind that leaves both particles alone, or a new one, the last of the kind.
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

/// What follows from the chains, and from a constraint that has come or gone.
void note_edit(Body& body, const DistanceConstraint& constraint) {
    body.plan.described = false;
    if (constraint.compliance == 0) body.plan.reach_current = false;
    body.contacts.self.linked_begin.clear();
    ++body.plan.edits;
}

}  // namespace

bool can_add_to_plan(Body& body) {
    Plan& plan = body.plan;
    if (!plan.chains_current || plan.method != GPHYS_SOLVE_GRAPH || plan.edits == Plan::most_edits) return false;
    reserve_more(plan.chains, 1);
    reserve_more(plan.colours, 1);
    reserve_more(plan.particles, 2);
    reserve_more(plan.slots, 1);
    reserve_more(body.cloth.rigid.changed, 2);
    return true;
}

bool can_remove_from_plan(Body& body, uint32_t slot) { return can_add_to_plan(body) && has_ring_without(body, slot); }

void add_to_plan(Body& body, uint32_t slot) {
    Plan& plan = body.plan;
    const DistanceConstraint& constraint = body.constraints.by_slot[slot];
    if (constraint.compliance == 0) body.cloth.rigid.change(constraint.a, constraint.b);
    const size_t colour = colour_for(body, plan, constraint);
    const uint32_t chain = plan.colours[colour + 1];
    const uint32_t particle = colour_begin(plan, colour + 1);
    const uint32_t link = particle - chain;  // each chain has a particle more than links
    plan.particles.insert(at(plan.particles, particle), {constraint.a, constraint.b});
    plan.slots.insert(at(plan.slots, link), slot);
    plan.chains.insert(at(plan.chains, chain), {particle, link, 1});
    number_chains(plan, chain);
    for (size_t i = colour + 1; i < plan.colours.size(); ++i) ++plan.colours[i];
    note_edit(body, constraint);
}

void remove_from_plan(Body& body, uint32_t slot) {
    Plan& plan = body.plan;
    const DistanceConstraint& constraint = body.constraints.by_slot[slot];
    if (constraint.compliance == 0) body.cloth.rigid.change(constraint.a, constraint.b);
    const uint32_t link =
        static_cast<uint32_t>(std::find(plan.slots.begin(), plan.slots.end(), slot) - plan.slots.begin());
    const auto after = std::upper_bound(plan.chains.begin(), plan.chains.end(), link,
                                        [](uint32_t l, const Chain& chain) { return l < chain.first_link; });
    const size_t i = static_cast<size_t>(after - plan.chains.begin()) - 1;
    const Chain whole = plan.chains[i];
    const uint32_t before = link - whole.first_link, behind = whole.link_count - before - 1;
    // What is left of the chain on one side alone may be nothing: its particle goes, too.
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
    note_edit(body, constraint);
}

}  // namespace gphys
