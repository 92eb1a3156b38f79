// Finding chains among constraints: the ones that a rope or a tree consists of, for direct solving, or the
// colours of straight lines that cover a cloth.
#include "solver/body.h"
#include "solver/rope/rope_kernels.h"

namespace gphys {
namespace {

constexpr uint32_t none = 0xffffffff;

uint32_t other_end(const DistanceConstraint& constraint, uint32_t particle) {
    return constraint.a == particle ? constraint.b : constraint.a;
}

/// Take trees apart, from each end to the other or to where there is still a branch: begin(end), then
/// pass(slot, next particle) along the chain. What remains are rings, and what is between them.
template <class Begin, class Pass>
void walk_chains(const Body& body, Begin&& begin, Pass&& pass) {
    Vector<Links> left(body.constraints.links, body.constraints.links.get_allocator());
    for (uint32_t end = 0; end < body.particles.size(); ++end) {
        if (left[end].degree != 1) continue;
        begin(end);
        for (uint32_t particle = end; left[particle].degree == 1;) {
            const uint32_t slot = left[particle].slots;
            left[particle] = {};
            particle = other_end(body.constraints.by_slot[slot], particle);
            --left[particle].degree;
            left[particle].slots ^= slot;
            pass(slot, particle);
        }
    }
}

/// Elimination couples the links of a particle with each other: its work grows with the third power of their number.
constexpr uint32_t most_branches = 64;

void clear_chains(Plan& plan) {
    plan.chains.clear();
    plan.colours.clear();
    plan.particles.clear();
    plan.slots.clear();
    plan.rest.clear();
    plan.compliance.clear();
    plan.damping.clear();
    plan.limit.clear();
}

void begin_chain(Plan& plan, uint32_t particle) {
    plan.chains.push_back({static_cast<uint32_t>(plan.particles.size()), static_cast<uint32_t>(plan.slots.size()), 0});
    plan.particles.push_back(particle);
}

void add_link(Plan& plan, uint32_t slot, uint32_t particle) {
    plan.particles.push_back(particle);
    plan.slots.push_back(slot);
    ++plan.chains.back().link_count;
}

/// What their constraints are like.
void describe_links(const Constraints& constraints, Plan& plan) {
    const size_t count = plan.slots.size();
    plan.rest.resize(count);
    plan.compliance.resize(count);
    plan.damping.resize(count);
    plan.limit.resize(count);
    for (size_t link = 0; link < count; ++link) {
        const DistanceConstraint& constraint = constraints.by_slot[plan.slots[link]];
        plan.rest[link] = constraint.rest;
        plan.compliance[link] = constraint.compliance;
        plan.damping[link] = constraint.damping;
        plan.limit[link] = static_cast<uint32_t>(constraint.limit);
    }
}

uint32_t longest_chain(const Plan& plan) {
    uint32_t longest = 0;
    for (const Chain& chain : plan.chains) longest = std::max(longest, chain.link_count);
    return longest;
}

}  // namespace

/// In trees, walking inward from all ends passes every constraint.
gphys_solve_method method_of(const Body& body) {
    const uint32_t constraint_count = body.constraints.ids.size();
    if (body.cloth.volume.held) return GPHYS_SOLVE_GRAPH;
    if (constraint_count == 0) return GPHYS_SOLVE_FREE;
    for (const Links& links : body.constraints.links) {
        if (links.degree > most_branches) return GPHYS_SOLVE_GRAPH;
    }
    uint32_t passed = 0;
    walk_chains(
        body, [](uint32_t) {}, [&](uint32_t, uint32_t) { ++passed; });
    return passed == constraint_count ? GPHYS_SOLVE_DIRECT : GPHYS_SOLVE_GRAPH;
}

namespace {

void describe_direct_links(Body& body) {
    Plan& plan = body.plan;
    describe_links(body.constraints, plan);
    for (double& rest : plan.rest) rest = rest < rope_shortest ? 0 : rest;
    body.rope.damped_rest = plan.rest;
    body.rope.damped_compliance = plan.compliance;
    body.rope.target = plan.rest;
}

}  // namespace

void plan_direct_chains(Body& body) {
    Plan& plan = body.plan;
    clear_chains(plan);
    walk_chains(
        body, [&](uint32_t end) { begin_chain(plan, end); },
        [&](uint32_t slot, uint32_t particle) { add_link(plan, slot, particle); });
    describe_direct_links(body);
    body.rope.rows.resize(longest_chain(plan) + 1);
    body.rope.earlier_tension.assign(plan.rest.size(), 0.0);
    body.rope.tension.assign(plan.rest.size(), 0.0);
}

namespace {

/// For each constraint and each of its ends, the constraint that continues it straight on, or none.
class StraightLines {
public:
    StraightLines(const Body& body, std::pmr::memory_resource* memory)
        : body_(body), next_(2 * size_t{body.constraints.ids.slots()}, none, memory) {
        pair_up(memory);
    }

    uint32_t next(uint32_t slot, uint32_t end_particle) const { return next_[index(slot, end_particle)]; }

private:
    /// Two constraints with a common particle; the lower straightness the straighter.
    struct Pair {
        double straightness;  // cosine of the angle between them: -1 is straight on
        uint32_t particle, first, second;

        bool operator<(const Pair& other) const {
            if (straightness != other.straightness) return straightness < other.straightness;
            if (particle != other.particle) return particle < other.particle;
            return first != other.first ? first < other.first : second < other.second;
        }
    };

    // A line bends by less than 45 degrees at a particle, and joins only constraints of one kind: a
    // bend constraint is twice as long as the edges beside it, the edges of a mesh vary less.
    static constexpr double least_straight = -0.70710678118654752;
    static constexpr double most_ratio = 1.75;

    size_t index(uint32_t slot, uint32_t particle) const {
        return 2 * size_t{slot} + (body_.constraints.by_slot[slot].b == particle);
    }

    Vec3 direction(uint32_t slot, uint32_t from) const {
        const Vec3 along =
            body_.particles.position[other_end(body_.constraints.by_slot[slot], from)] - body_.particles.position[from];
        return along == Vec3{} ? along : normalized(along);
    }

    bool same_kind(const DistanceConstraint& a, const DistanceConstraint& b) const {
        if (a.limit || b.limit) return false;  // whether one pulls is decided for it alone
        return a.compliance == b.compliance && a.rest <= most_ratio * b.rest && b.rest <= most_ratio * a.rest;
    }

    void pair_up(std::pmr::memory_resource* memory) {
        Vector<uint32_t> begin(body_.particles.size() + 1, 0, memory);
        for (uint32_t p = 0; p < body_.particles.size(); ++p)
            begin[p + 1] = begin[p] + body_.constraints.links[p].degree;
        Vector<uint32_t> at(begin.back(), memory), filled(begin.begin(), begin.end() - 1, memory);
        for (uint32_t slot = 0; slot < body_.constraints.ids.slots(); ++slot) {
            if (!body_.constraints.ids.live(slot)) continue;
            at[filled[body_.constraints.by_slot[slot].a]++] = slot;
            at[filled[body_.constraints.by_slot[slot].b]++] = slot;
        }
        Vector<Pair> pairs(memory);
        Vector<Vec3> directions(memory);  // of the constraints at a particle
        for (uint32_t p = 0; p < body_.particles.size(); ++p) {
            pairs.clear();
            directions.clear();
            for (uint32_t i = begin[p]; i < begin[p + 1]; ++i) directions.push_back(direction(at[i], p));
            for (uint32_t i = begin[p]; i < begin[p + 1]; ++i) {
                for (uint32_t j = i + 1; j < begin[p + 1]; ++j) {
                    if (!same_kind(body_.constraints.by_slot[at[i]], body_.constraints.by_slot[at[j]])) continue;
                    const double straightness = dot(directions[i - begin[p]], directions[j - begin[p]]);
                    if (straightness <= least_straight) pairs.push_back({straightness, p, at[i], at[j]});
                }
            }
            std::sort(pairs.begin(), pairs.end());
            for (const Pair& pair : pairs) {
                uint32_t& after_first = next_[index(pair.first, p)];
                uint32_t& after_second = next_[index(pair.second, p)];
                if (after_first != none || after_second != none) continue;
                after_first = pair.second;
                after_second = pair.first;
            }
        }
    }

    const Body& body_;
    Vector<uint32_t> next_;
};

/// Cover all constraints by lines, those with the lowest slots first. A line that meets itself ends
/// there, for a chain passes no particle twice; what is left of it becomes another line.
void collect_lines(const Body& body, Plan& lines, std::pmr::memory_resource* memory) {
    const StraightLines straight(body, memory);
    Vector<uint8_t> used(body.constraints.ids.slots(), 0, memory);
    Vector<uint32_t> seen(body.particles.size(), none, memory);  // the line that passed a particle last
    for (uint32_t seed = 0; seed < body.constraints.ids.slots(); ++seed) {
        while (body.constraints.ids.live(seed) && !used[seed]) {
            // Back to where the line begins, ...
            uint32_t slot = seed, start = body.constraints.by_slot[seed].a;
            for (;;) {
                const uint32_t before = straight.next(slot, start);
                if (before == none || before == seed || used[before]) break;
                slot = before;
                start = other_end(body.constraints.by_slot[slot], start);
            }
            // ... and along it.
            const uint32_t line = static_cast<uint32_t>(lines.chains.size());
            begin_chain(lines, start);
            seen[start] = line;
            for (uint32_t particle = start; slot != none && !used[slot];) {
                particle = other_end(body.constraints.by_slot[slot], particle);
                if (seen[particle] == line) break;
                seen[particle] = line;
                used[slot] = 1;
                add_link(lines, slot, particle);
                slot = straight.next(slot, particle);
            }
        }
    }
    describe_links(body.constraints, lines);
}

/// The lowest colour whose chains leave all particles of the chain alone; masks has a bit per colour.
uint32_t free_colour(const Plan& lines, const Chain& chain, const Vector<uint64_t>& masks) {
    uint64_t taken = 0;
    for (uint32_t i = 0; i <= chain.link_count; ++i) taken |= masks[lines.particles[chain.first_particle + i]];
    uint32_t colour = 0;
    while (colour < 64 && (taken >> colour & 1)) ++colour;
    return colour;
}

/// Give a colour to each line for which of_kind(line), `turn` by turn, those from first_colour on. Returns
/// the end of the colours.
template <class OfKind>
uint32_t colour_lines(const Particles& particles, const Plan& lines, const Vector<uint32_t>& turn, OfKind&& of_kind,
                      uint32_t first_colour, Vector<uint32_t>& colours) {
    Vector<uint64_t> masks(particles.size(), 0, colours.get_allocator());
    uint32_t colour_count = first_colour;
    for (bool waiting = true; waiting;) {
        waiting = false;
        const uint32_t base = colour_count;
        std::fill(masks.begin(), masks.end(), 0);
        for (const uint32_t line : turn) {
            if (colours[line] != none || !of_kind(line)) continue;
            const Chain& chain = lines.chains[line];
            const uint32_t colour = free_colour(lines, chain, masks);
            if (colour == 64) {
                waiting = true;
                continue;
            }
            colours[line] = base + colour;
            colour_count = std::max(colour_count, base + colour + 1);
            for (uint32_t i = 0; i <= chain.link_count; ++i) {
                masks[lines.particles[chain.first_particle + i]] |= uint64_t{1} << colour;
            }
        }
    }
    return colour_count;
}

}  // namespace

/// Colour the lines greedily so that those of one colour share no particle: rows, columns and
/// diagonals of a grid become a colour each. Lines that find 64 colours taken wait for the next 64.
/// The colour that is solved last has no error left, so the softest lines come first, and of those
/// alike the ones of constraints added last: the sides of a grid after its diagonals, which cannot all
/// keep their lengths on a surface that is round both ways.
void plan_chain_colours(Body& body) {
    Plan& plan = body.plan;
    std::pmr::memory_resource* memory = plan.chains.get_allocator().resource();
    Plan lines(memory);
    collect_lines(body, lines, memory);

    const uint32_t line_count = static_cast<uint32_t>(lines.chains.size());
    Vector<uint32_t> turn(line_count, memory);
    for (uint32_t i = 0; i < line_count; ++i) turn[i] = line_count - 1 - i;
    std::stable_sort(turn.begin(), turn.end(), [&](uint32_t a, uint32_t b) {
        return lines.compliance[lines.chains[a].first_link] > lines.compliance[lines.chains[b].first_link];
    });
    Vector<uint32_t> colour(line_count, none, memory);
    uint32_t colour_count = 0;
    // Links that only pull, which are solved by another kernel, have colours of their own, the last.
    for (const uint32_t limit : {0u, 1u}) {
        const auto of_kind = [&](uint32_t line) { return lines.limit[lines.chains[line].first_link] == limit; };
        colour_count = colour_lines(body.particles, lines, turn, of_kind, colour_count, colour);
    }

    Vector<uint32_t> order(line_count, memory);
    for (uint32_t line = 0; line < line_count; ++line) order[line] = line;
    // Within a colour the longest first, so that chains solved side by side are of one length.
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        if (colour[a] != colour[b]) return colour[a] < colour[b];
        return lines.chains[a].link_count > lines.chains[b].link_count;
    });
    clear_chains(plan);
    for (const uint32_t line : order) {
        const Chain& chain = lines.chains[line];
        if (plan.colours.size() == colour[line]) plan.colours.push_back(static_cast<uint32_t>(plan.chains.size()));
        begin_chain(plan, lines.particles[chain.first_particle]);
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            add_link(plan, lines.slots[chain.first_link + i], lines.particles[chain.first_particle + i + 1]);
        }
    }
    plan.colours.push_back(line_count);
    describe_links(body.constraints, plan);
}

namespace {

/// What the links of a plan are like.
void note_kinds(Body& body) {
    Plan& plan = body.plan;
    plan.branched =
        plan.method == GPHYS_SOLVE_DIRECT && std::any_of(body.constraints.links.begin(), body.constraints.links.end(),
                                                         [](Links links) { return links.degree > 2; });
    plan.damped = std::any_of(plan.damping.begin(), plan.damping.end(), [](double damping) { return damping > 0; });
    plan.limited = std::find(plan.limit.begin(), plan.limit.end(), 1u) != plan.limit.end();
}

}  // namespace

void complete_plan(Body& body) {
    Plan& plan = body.plan;
    if (!plan.chains_current) return;
    if (plan.method == GPHYS_SOLVE_DIRECT) {
        Vector<double> tension = std::move(body.rope.tension);
        plan_direct_chains(body);
        body.rope.tension = std::move(tension);
    }
    if (plan.method == GPHYS_SOLVE_GRAPH) describe_links(body.constraints, plan);
    note_kinds(body);
    plan.described = true;
}

void update_plan(Body& body) {
    Plan& plan = body.plan;
    if (!plan.chains_current) {
        plan.chains_packed = false;
        plan.method = method_of(body);
        if (plan.method == GPHYS_SOLVE_FREE) clear_chains(plan);
        if (plan.method == GPHYS_SOLVE_DIRECT) plan_direct_chains(body);
        if (plan.method == GPHYS_SOLVE_GRAPH) plan_chain_colours(body);
        note_kinds(body);
        plan.chains_current = plan.described = true;
        plan.reach_current = false;
    }
    if (!plan.described) {
        if (plan.method == GPHYS_SOLVE_DIRECT) describe_direct_links(body);
        if (plan.method == GPHYS_SOLVE_GRAPH) describe_links(body.constraints, plan);
        note_kinds(body);
        plan.chains_packed = false;
        plan.described = true;
    }
    if (!plan.reach_current) {
        body.cloth.reach_limits.clear();
        plan.pins_packed = false;
        if (plan.method == GPHYS_SOLVE_GRAPH) plan_reach_limits(body);
        plan.reach_current = true;
    }
    if (plan.method != GPHYS_SOLVE_GRAPH) return;
    // Pins come and go without changing the chains.
    if (!plan.chains_packed) {
        plan.pins_packed = false;
        pack_cloth_chains(body);
        plan.chains_packed = true;
    }
    if (!plan.pins_packed) {
        pack_pins(body);
        plan.pins_packed = true;
    }
}

}  // namespace gphys
