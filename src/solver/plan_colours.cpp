// Chains of cloth and other graphs. The constraints are covered by straight lines, and the lines are coloured greedily,
// so that chains of one colour share no particle and can be solved in any order or at once (line relaxation with graph
// colouring).
#include "solver/body.h"
#include "solver/straight_kernels.h"

namespace gphys {
namespace {

constexpr uint32_t none = 0xffffffff;

/// Vectors as a structure of arrays, padded to a multiple of eight.
struct VectorArray {
    explicit VectorArray(std::pmr::memory_resource* memory) : x(memory), y(memory), z(memory) {}

    void resize(size_t size) {
        for (Vector<double>* component : {&x, &y, &z}) component->resize((size + 7) / 8 * 8);
    }
    void set(size_t i, Vec3 v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }

    Vector<double> x, y, z;
};

/// For each constraint and each of its ends, the constraint that continues it straight on, or none. At each particle
/// the pairs that straight_kernels.cpp lists are matched greedily, the straightest first.
class StraightLines {
public:
    StraightLines(const Constraints& constraints, const Particles& particles, std::pmr::memory_resource* memory)
        : constraints_(constraints),
          particles_(particles),
          next_(2 * size_t{constraints.ids.slots()}, none, memory),
          ends_(constraints.ids.slots(), memory),
          directions_(memory),
          outward_(memory),
          rest_(memory),
          compliance_(memory),
          pairs_(memory) {
        find_directions();
        match(memory);
    }

    uint32_t next(uint32_t slot, uint32_t end_particle) const {
        return next_[half_edge(slot, ends_[slot].b == end_particle)];
    }
    uint32_t other_end(uint32_t slot, uint32_t particle) const {
        return ends_[slot].a == particle ? ends_[slot].b : ends_[slot].a;
    }

private:
    struct Ends {
        uint32_t a, b;
    };

    /// A constraint at one of its particles, as an index in next_.
    static uint32_t half_edge(uint32_t slot, bool second_end) { return 2 * slot + second_end; }

    void find_directions() {
        directions_.resize(constraints_.ids.slots());
        for (const uint32_t slot : constraints_.ids) {
            const DistanceConstraint& c = constraints_.by_slot[slot];
            ends_[slot] = {c.a, c.b};
            directions_.set(slot, particles_.position[c.b] - particles_.position[c.a]);
        }
        kernels_.normalize(directions_.x.data(), directions_.y.data(), directions_.z.data(), directions_.x.size());
    }

    /// Constraints that only pull are left out: each is solved alone.
    void match(std::pmr::memory_resource* memory) {
        Vector<uint32_t> begin(particles_.size() + 1, 0, memory);
        uint32_t most = 0;
        for (uint32_t p = 0; p < particles_.size(); ++p) {
            begin[p + 1] = begin[p] + constraints_.links[p].degree;
            most = std::max(most, constraints_.links[p].degree);
        }
        outward_.resize(most);
        rest_.resize(outward_.x.size());
        compliance_.resize(outward_.x.size());
        pairs_.resize(std::max(most, least_pairs));
        Vector<uint32_t> half_edges(begin.back(), memory), end(begin.begin(), begin.end() - 1, memory);
        for (const uint32_t slot : constraints_.ids) {
            if (constraints_.by_slot[slot].limit) continue;
            half_edges[end[constraints_.by_slot[slot].a]++] = half_edge(slot, false);
            half_edges[end[constraints_.by_slot[slot].b]++] = half_edge(slot, true);
        }
        Vector<StraightPair> candidates(memory);
        for (uint32_t p = 0; p < particles_.size(); ++p)
            match(half_edges.data() + begin[p], end[p] - begin[p], candidates);
    }

    /// Matches the constraints at one particle.
    void match(const uint32_t* half_edges, uint32_t count, Vector<StraightPair>& candidates) {
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t slot = half_edges[i] / 2;
            const double sign = half_edges[i] % 2 == 0 ? 1 : -1;
            outward_.set(i, Vec3{directions_.x[slot], directions_.y[slot], directions_.z[slot]} * sign);
            rest_[i] = constraints_.by_slot[slot].rest;
            compliance_[i] = constraints_.by_slot[slot].compliance;
        }
        const LinksAround around{outward_.x.data(), outward_.y.data(),  outward_.z.data(),
                                 rest_.data(),      compliance_.data(), count};
        candidates.clear();
        const uint32_t rows = static_cast<uint32_t>(pairs_.size()) / std::max(count, 1u);
        for (uint32_t first = 0; first < count; first += rows) {
            const uint32_t found = kernels_.list_pairs(around, first, std::min(first + rows, count), pairs_.data());
            candidates.insert(candidates.end(), pairs_.begin(), pairs_.begin() + found);
        }
        std::sort(candidates.begin(), candidates.end());
        for (const StraightPair& pair : candidates) {
            const uint32_t first = half_edges[pair.first], second = half_edges[pair.second];
            if (next_[first] != none || next_[second] != none) continue;
            next_[first] = second / 2;
            next_[second] = first / 2;
        }
    }

    static constexpr uint32_t least_pairs = 1024;

    const StraightKernels& kernels_ = straight_kernels(chosen_isa());
    const Constraints& constraints_;
    const Particles& particles_;
    Vector<uint32_t> next_;
    Vector<Ends> ends_;       // by slot: the particles of the constraint, close together for quick traversal
    VectorArray directions_;  // by slot, from the first end to the second
    // Of the particle that is matched:
    VectorArray outward_;  // directions from the particle
    Vector<double> rest_, compliance_;
    Vector<StraightPair> pairs_;
};

/// Covers all constraints by lines, from the lowest slot on. A line ends where it meets itself, because a chain passes
/// no particle twice; the rest of it becomes another line.
void collect_lines(const Constraints& constraints, const Particles& particles, Plan& lines,
                   std::pmr::memory_resource* memory) {
    const StraightLines straight(constraints, particles, memory);
    lines.slots.reserve(constraints.ids.size());
    lines.particles.reserve(2 * size_t{constraints.ids.size()});
    Vector<uint8_t> used(constraints.ids.slots(), 0, memory);
    Vector<uint32_t> last_line(particles.size(), none, memory);  // by particle: the line that was there last
    for (uint32_t seed = 0; seed < constraints.ids.slots(); ++seed) {
        while (constraints.ids.live(seed) && !used[seed]) {
            // Back to the beginning of the line, ...
            uint32_t slot = seed, start = constraints.by_slot[seed].a;
            for (;;) {
                const uint32_t before = straight.next(slot, start);
                if (before == none || before == seed || used[before]) break;
                slot = before;
                start = straight.other_end(slot, start);
            }
            // ... and along it.
            const uint32_t line = static_cast<uint32_t>(lines.chains.size());
            lines.begin_chain(start);
            last_line[start] = line;
            for (uint32_t particle = start; slot != none && !used[slot];) {
                particle = straight.other_end(slot, particle);
                if (last_line[particle] == line) break;
                last_line[particle] = line;
                used[slot] = 1;
                lines.add_link(slot, particle);
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
void plan_chain_colours(Plan& plan, const Constraints& constraints, const Particles& particles) {
    std::pmr::memory_resource* memory = plan.chains.get_allocator().resource();
    Plan lines(memory);
    collect_lines(constraints, particles, lines, memory);

    // All constraints of a line are of one kind.
    const auto kind_of = [&](uint32_t line) -> const DistanceConstraint& {
        return constraints.by_slot[lines.slots[lines.chains[line].first_link]];
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
        colour_count = colour_lines(particles, lines, colouring_order, of_kind, colour_count, colour);
    }

    Vector<uint32_t> order(line_count, memory);
    for (uint32_t line = 0; line < line_count; ++line) order[line] = line;
    // Within a colour the longest first, so that chains that are solved side by side have similar lengths.
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        if (colour[a] != colour[b]) return colour[a] < colour[b];
        return lines.chains[a].link_count > lines.chains[b].link_count;
    });
    plan.clear_chains();
    plan.particles.reserve(lines.particles.size());
    plan.slots.reserve(lines.slots.size());
    for (const uint32_t line : order) {
        const Chain& chain = lines.chains[line];
        if (plan.colours.size() == colour[line]) plan.colours.push_back(static_cast<uint32_t>(plan.chains.size()));
        plan.chains.push_back(
            {static_cast<uint32_t>(plan.particles.size()), static_cast<uint32_t>(plan.slots.size()), chain.link_count});
        const uint32_t* const line_particles = &lines.particles[chain.first_particle];
        const uint32_t* const line_slots = &lines.slots[chain.first_link];
        plan.particles.insert(plan.particles.end(), line_particles, line_particles + chain.link_count + 1);
        plan.slots.insert(plan.slots.end(), line_slots, line_slots + chain.link_count);
    }
    plan.colours.push_back(line_count);
    plan.copy_parameters(constraints);
}

}  // namespace gphys
