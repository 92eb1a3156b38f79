// The plan of a body: chains among its constraints.
//
// The constraints of ropes and trees are a forest, which is peeled from its leaves inward into chains and solved
// directly. Any other graph, such as cloth, is covered by straight lines. These are coloured, so that chains of one
// colour can be solved in any order or at once (line relaxation with graph colouring).
#include "solver/body.h"
#include "solver/rope/rope_kernels.h"

namespace gphys {
namespace {

constexpr uint32_t none = 0xffffffff;

uint32_t other_end(const DistanceConstraint& constraint, uint32_t particle) {
    return constraint.a == particle ? constraint.b : constraint.a;
}

/// Peels chains off from their leaves, particles with one constraint left: begin(leaf), then visit(slot, next particle)
/// along the chain, to another leaf or to a particle with further constraints. Trees are visited as a whole. What
/// remains of other graphs are their cycles and the paths between them. O(particles).
template <class Begin, class Visit>
void peel_chains(const Body& body, Begin&& begin, Visit&& visit) {
    Vector<Links> remaining(body.constraints.links, body.constraints.links.get_allocator());
    for (uint32_t leaf = 0; leaf < body.particles.size(); ++leaf) {
        if (remaining[leaf].degree != 1) continue;
        begin(leaf);
        for (uint32_t particle = leaf; remaining[particle].degree == 1;) {
            const uint32_t slot = remaining[particle].slots;
            remaining[particle] = {};
            particle = other_end(body.constraints.by_slot[slot], particle);
            --remaining[particle].degree;
            remaining[particle].slots ^= slot;
            visit(slot, particle);
        }
    }
}

/// Constraints of a particle. Elimination couples them all with each other, so its work grows with their third power.
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

/// Copies the parameters of the links from their constraints.
void copy_parameters(const Constraints& constraints, Plan& plan) {
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

/// Forests are solved directly: peeling visits all their constraints.
gphys_solve_method method_of(const Body& body, uint32_t constraint_count) {
    if (body.cloth.volume.held) return GPHYS_SOLVE_GRAPH;
    if (constraint_count == 0) return GPHYS_SOLVE_FREE;
    for (const Links& links : body.constraints.links) {
        if (links.degree > most_branches) return GPHYS_SOLVE_GRAPH;
    }
    uint32_t visited = 0;
    peel_chains(
        body, [](uint32_t) {}, [&](uint32_t, uint32_t) { ++visited; });
    return visited == constraint_count ? GPHYS_SOLVE_DIRECT : GPHYS_SOLVE_GRAPH;
}

gphys_solve_method method_of(const Body& body) { return method_of(body, body.constraints.ids.size()); }

namespace {

void copy_direct_parameters(Body& body) {
    Plan& plan = body.plan;
    copy_parameters(body.constraints, plan);
    for (double& rest : plan.rest) rest = rest < rope_shortest ? 0 : rest;
    body.rope.damped_rest = plan.rest;
    body.rope.damped_compliance = plan.compliance;
    body.rope.target = plan.rest;
}

}  // namespace

void plan_direct_chains(Body& body) {
    Plan& plan = body.plan;
    clear_chains(plan);
    peel_chains(
        body, [&](uint32_t end) { begin_chain(plan, end); },
        [&](uint32_t slot, uint32_t particle) { add_link(plan, slot, particle); });
    copy_direct_parameters(body);
    body.rope.rows.resize(longest_chain(plan) + 1);
    body.rope.earlier_tension.assign(plan.rest.size(), 0.0);
    body.rope.tension.assign(plan.rest.size(), 0.0);
}

namespace {

/// Vectors as a structure of arrays, so that the compiler vectorises the loops over them.
struct VectorArray {
    explicit VectorArray(std::pmr::memory_resource* memory) : x(memory), y(memory), z(memory) {}

    void resize(size_t size) { x.resize(size), y.resize(size), z.resize(size); }
    void set(size_t i, Vec3 v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }

    /// With the same bits as normalized. Zero vectors stay.
    void normalize() {
        for (size_t i = 0; i < x.size(); ++i) {
            const double largest = gphys::largest(gphys::largest(absolute(x[i]), absolute(y[i])), absolute(z[i]));
            const double scale = largest > 0 ? largest : 1;
            const double u = x[i] / scale, v = y[i] / scale, w = z[i] / scale;
            const double length = largest > 0 ? square_root(u * u + v * v + w * w) : 1;
            x[i] = u / length, y[i] = v / length, z[i] = w / length;
        }
    }

    Vector<double> x, y, z;
};

/// For each constraint and each of its ends, the constraint that continues it straight on, or none. At each particle
/// the candidates are matched greedily, the straightest pair first.
class StraightLines {
public:
    StraightLines(const Body& body, std::pmr::memory_resource* memory)
        : body_(body),
          next_(2 * size_t{body.constraints.ids.slots()}, none, memory),
          directions_(memory),
          around_(memory),
          outward_(memory),
          cosines_(memory),
          candidates_(memory) {
        find_directions();
        match(memory);
    }

    uint32_t next(uint32_t slot, uint32_t end_particle) const {
        return next_[half_edge(slot, body_.constraints.by_slot[slot].b == end_particle)];
    }

private:
    /// A constraint at one of its particles.
    struct HalfEdge {
        uint32_t index;  // in next_
        bool limit;
        double rest, compliance;
    };
    /// Two constraints with a common particle that may continue each other.
    struct Candidate {
        double straightness;     // cosine of the angle between them: -1 is straight on
        uint32_t first, second;  // in around_, which is in the order of slots

        bool operator<(const Candidate& other) const {
            if (straightness != other.straightness) return straightness < other.straightness;
            return first != other.first ? first < other.first : second < other.second;
        }
    };

    // A line turns by less than 45 degrees at a particle, and joins only constraints of one kind. Bend constraints are
    // twice as long as the edges beside them; the edges of a mesh vary less than this ratio.
    static constexpr double least_straight = -0.70710678118654752;
    static constexpr double most_ratio = 1.75;

    static uint32_t half_edge(uint32_t slot, bool second_end) { return 2 * slot + second_end; }

    static bool same_kind(const HalfEdge& a, const HalfEdge& b) {
        if (a.limit || b.limit) return false;  // each one that only pulls is solved alone
        return a.compliance == b.compliance && a.rest <= most_ratio * b.rest && b.rest <= most_ratio * a.rest;
    }

    void find_directions() {
        const Constraints& constraints = body_.constraints;
        directions_.resize(constraints.ids.slots());
        for (uint32_t slot = 0; slot < constraints.ids.slots(); ++slot) {
            if (!constraints.ids.live(slot)) continue;
            const DistanceConstraint& c = constraints.by_slot[slot];
            directions_.set(slot, body_.particles.position[c.b] - body_.particles.position[c.a]);
        }
        directions_.normalize();
    }

    void match(std::pmr::memory_resource* memory) {
        const Constraints& constraints = body_.constraints;
        Vector<uint32_t> begin(body_.particles.size() + 1, 0, memory);
        for (uint32_t p = 0; p < body_.particles.size(); ++p) begin[p + 1] = begin[p] + constraints.links[p].degree;
        Vector<uint32_t> half_edges(begin.back(), memory), filled(begin.begin(), begin.end() - 1, memory);
        for (uint32_t slot = 0; slot < constraints.ids.slots(); ++slot) {
            if (!constraints.ids.live(slot)) continue;
            half_edges[filled[constraints.by_slot[slot].a]++] = half_edge(slot, false);
            half_edges[filled[constraints.by_slot[slot].b]++] = half_edge(slot, true);
        }
        for (uint32_t p = 0; p < body_.particles.size(); ++p) {
            match(half_edges.data() + begin[p], begin[p + 1] - begin[p]);
        }
    }

    /// Matches the constraints at one particle.
    void match(const uint32_t* half_edges, uint32_t count) {
        around_.resize(count);
        outward_.resize(count);
        cosines_.resize(count);
        candidates_.clear();
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t slot = half_edges[i] / 2;
            const DistanceConstraint& constraint = body_.constraints.by_slot[slot];
            around_[i] = {half_edges[i], constraint.limit != 0, constraint.rest, constraint.compliance};
            const double sign = half_edges[i] % 2 == 0 ? 1 : -1;
            outward_.set(i, Vec3{directions_.x[slot], directions_.y[slot], directions_.z[slot]} * sign);
        }
        for (uint32_t i = 0; i < count; ++i) {
            const double x = outward_.x[i], y = outward_.y[i], z = outward_.z[i];
            for (uint32_t j = i + 1; j < count; ++j)
                cosines_[j] = x * outward_.x[j] + y * outward_.y[j] + z * outward_.z[j];
            for (uint32_t j = i + 1; j < count; ++j) {
                if (cosines_[j] <= least_straight && same_kind(around_[i], around_[j]))
                    candidates_.push_back({cosines_[j], i, j});
            }
        }
        std::sort(candidates_.begin(), candidates_.end());
        for (const Candidate& candidate : candidates_) {
            uint32_t& after_first = next_[around_[candidate.first].index];
            uint32_t& after_second = next_[around_[candidate.second].index];
            if (after_first != none || after_second != none) continue;
            after_first = around_[candidate.second].index / 2;
            after_second = around_[candidate.first].index / 2;
        }
    }

    const Body& body_;
    Vector<uint32_t> next_;
    VectorArray directions_;  // by slot, from the first end to the second
    // Of the particle that is matched:
    Vector<HalfEdge> around_;
    VectorArray outward_;  // directions from the particle
    Vector<double> cosines_;
    Vector<Candidate> candidates_;
};

/// Covers all constraints by lines, from the lowest slot on. A line ends where it meets itself, because a chain passes
/// no particle twice; the rest of it becomes another line.
void collect_lines(const Body& body, Plan& lines, std::pmr::memory_resource* memory) {
    const StraightLines straight(body, memory);
    lines.slots.reserve(body.constraints.ids.size());
    lines.particles.reserve(2 * size_t{body.constraints.ids.size()});
    Vector<uint8_t> used(body.constraints.ids.slots(), 0, memory);
    Vector<uint32_t> last_line(body.particles.size(), none, memory);  // by particle: the line that was there last
    for (uint32_t seed = 0; seed < body.constraints.ids.slots(); ++seed) {
        while (body.constraints.ids.live(seed) && !used[seed]) {
            // Back to the beginning of the line, ...
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
            last_line[start] = line;
            for (uint32_t particle = start; slot != none && !used[slot];) {
                particle = other_end(body.constraints.by_slot[slot], particle);
                if (last_line[particle] == line) break;
                last_line[particle] = line;
                used[slot] = 1;
                add_link(lines, slot, particle);
                slot = straight.next(slot, particle);
            }
        }
    }
}

/// The lowest colour that no particle of the chain has yet, or 64. `masks`: by particle, a bit for each colour.
uint32_t free_colour(const Plan& lines, const Chain& chain, const Vector<uint64_t>& masks) {
    uint64_t taken = 0;
    for (uint32_t i = 0; i <= chain.link_count; ++i) taken |= masks[lines.particles[chain.first_particle + i]];
    uint32_t colour = 0;
    while (colour < 64 && (taken >> colour & 1)) ++colour;
    return colour;
}

/// Colours the lines for which of_kind(line), greedily in the given order, with colours from first_colour on. Lines
/// that find 64 colours taken wait for the next 64. Returns the end of the colours.
template <class OfKind>
uint32_t colour_lines(const Particles& particles, const Plan& lines, const Vector<uint32_t>& colouring_order,
                      OfKind&& of_kind, uint32_t first_colour, Vector<uint32_t>& colours) {
    Vector<uint64_t> masks(particles.size(), 0, colours.get_allocator());
    uint32_t colour_count = first_colour;
    for (bool incomplete = true; incomplete;) {
        incomplete = false;
        const uint32_t base = colour_count;
        std::fill(masks.begin(), masks.end(), 0);
        for (const uint32_t line : colouring_order) {
            if (colours[line] != none || !of_kind(line)) continue;
            const Chain& chain = lines.chains[line];
            const uint32_t colour = free_colour(lines, chain, masks);
            if (colour == 64) {
                incomplete = true;
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

/// Lines of one colour share no particle: rows, columns and diagonals of a grid become a colour each. The colour that
/// is solved last has no error left, so the softest lines come first, and of equally soft ones those whose constraints
/// were added last. So the sides of a grid come after its diagonals, which cannot all keep their lengths on a surface
/// with Gaussian curvature.
void plan_chain_colours(Body& body) {
    Plan& plan = body.plan;
    std::pmr::memory_resource* memory = plan.chains.get_allocator().resource();
    Plan lines(memory);
    collect_lines(body, lines, memory);

    // All constraints of a line are of one kind.
    const auto kind_of = [&](uint32_t line) -> const DistanceConstraint& {
        return body.constraints.by_slot[lines.slots[lines.chains[line].first_link]];
    };
    const uint32_t line_count = static_cast<uint32_t>(lines.chains.size());
    Vector<uint32_t> colouring_order(line_count, memory);
    for (uint32_t i = 0; i < line_count; ++i) colouring_order[i] = line_count - 1 - i;
    std::stable_sort(colouring_order.begin(), colouring_order.end(),
                     [&](uint32_t a, uint32_t b) { return kind_of(a).compliance > kind_of(b).compliance; });
    Vector<uint32_t> colour(line_count, none, memory);
    uint32_t colour_count = 0;
    // Links that only pull have colours of their own, the last, because another kernel solves them.
    for (const uint32_t limit : {0u, 1u}) {
        const auto of_kind = [&](uint32_t line) { return kind_of(line).limit == limit; };
        colour_count = colour_lines(body.particles, lines, colouring_order, of_kind, colour_count, colour);
    }

    Vector<uint32_t> order(line_count, memory);
    for (uint32_t line = 0; line < line_count; ++line) order[line] = line;
    // Within a colour the longest first, so that chains that are solved side by side have similar lengths.
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        if (colour[a] != colour[b]) return colour[a] < colour[b];
        return lines.chains[a].link_count > lines.chains[b].link_count;
    });
    clear_chains(plan);
    plan.particles.reserve(lines.particles.size());
    plan.slots.reserve(lines.slots.size());
    for (const uint32_t line : order) {
        const Chain& chain = lines.chains[line];
        if (plan.colours.size() == colour[line]) plan.colours.push_back(static_cast<uint32_t>(plan.chains.size()));
        plan.chains.push_back(
            {static_cast<uint32_t>(plan.particles.size()), static_cast<uint32_t>(plan.slots.size()), chain.link_count});
        const uint32_t* const particles = &lines.particles[chain.first_particle];
        const uint32_t* const slots = &lines.slots[chain.first_link];
        plan.particles.insert(plan.particles.end(), particles, particles + chain.link_count + 1);
        plan.slots.insert(plan.slots.end(), slots, slots + chain.link_count);
    }
    plan.colours.push_back(line_count);
    copy_parameters(body.constraints, plan);
}

namespace {

/// Sets the flags of the plan that tell which kinds of links it has.
void classify_links(Body& body) {
    Plan& plan = body.plan;
    plan.branched =
        plan.method == GPHYS_SOLVE_DIRECT && std::any_of(body.constraints.links.begin(), body.constraints.links.end(),
                                                         [](Links links) { return links.degree > 2; });
    plan.damped = std::any_of(plan.damping.begin(), plan.damping.end(), [](double damping) { return damping > 0; });
    plan.limited = std::find(plan.limit.begin(), plan.limit.end(), 1u) != plan.limit.end();
}

}  // namespace

namespace {

void pack_cloth(Body& body) {
    const uint32_t particles = body.particles.size();
    ClothBatches& batches = body.cloth.batches;
    pack_cloth_chains(batches, body.plan, particles);
    list_kept_links(body.cloth.relaxation.kept, batches, body.cloth.rigid, body.plan, particles,
                    body.constraints.ids.slots(), body.kind == GPHYS_BODY_CLOTH);
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
    if (plan.method == GPHYS_SOLVE_GRAPH) copy_parameters(body.constraints, plan);
    classify_links(body);
    plan.described = true;
}

void update_plan(Body& body) {
    Plan& plan = body.plan;
    if (!plan.chains_current) {
        plan.chains_packed = false;
        plan.edits = 0;
        body.cloth.rigid.forget();
        plan.method = method_of(body);
        if (plan.method == GPHYS_SOLVE_FREE) clear_chains(plan);
        if (plan.method == GPHYS_SOLVE_DIRECT) plan_direct_chains(body);
        if (plan.method == GPHYS_SOLVE_GRAPH) plan_chain_colours(body);
        classify_links(body);
        plan.chains_current = plan.described = true;
        plan.reach_current = false;
    }
    if (!plan.described) {
        if (plan.method == GPHYS_SOLVE_DIRECT) copy_direct_parameters(body);
        if (plan.method == GPHYS_SOLVE_GRAPH) copy_parameters(body.constraints, plan);
        classify_links(body);
        plan.chains_packed = false;
        plan.described = true;
    }
    if (body.cloth.rigid.begin.empty() && plan.method == GPHYS_SOLVE_GRAPH) {
        body.cloth.reach.paths.clear();
        body.cloth.rigid.list(plan, body.particles.size());
    }
    if (!plan.reach_current) {
        Cloth& cloth = body.cloth;
        cloth.reach.limits.clear();
        plan.pins_packed = false;
        if (plan.method == GPHYS_SOLVE_GRAPH) plan_reach_limits(cloth.reach, cloth.rigid, body.particles, cloth.sheet);
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
        mark_attached(body.cloth.batches, body.constraints, body.particles.size());
        plan.pins_packed = true;
    }
}

}  // namespace gphys
