// Chains of cloth and other graphs. The constraints are covered by straight lines, and the lines are coloured greedily,
// so that chains of one colour share no particle and can be solved in any order or at once (line relaxation with graph
// colouring).
#include "solver/body.h"

namespace gphys {
namespace {

constexpr uint32_t none = 0xffffffff;

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
    StraightLines(const Constraints& constraints, const Particles& particles, std::pmr::memory_resource* memory)
        : constraints_(constraints),
          particles_(particles),
          next_(2 * size_t{constraints.ids.slots()}, none, memory),
          directions_(memory),
          around_(memory),
          outward_(memory),
          cosines_(memory),
          candidates_(memory) {
        find_directions();
        match(memory);
    }

    uint32_t next(uint32_t slot, uint32_t end_particle) const {
        return next_[half_edge(slot, constraints_.by_slot[slot].b == end_particle)];
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
        directions_.resize(constraints_.ids.slots());
        for (uint32_t slot = 0; slot < constraints_.ids.slots(); ++slot) {
            if (!constraints_.ids.live(slot)) continue;
            const DistanceConstraint& c = constraints_.by_slot[slot];
            directions_.set(slot, particles_.position[c.b] - particles_.position[c.a]);
        }
        directions_.normalize();
    }

    void match(std::pmr::memory_resource* memory) {
        Vector<uint32_t> begin(particles_.size() + 1, 0, memory);
        for (uint32_t p = 0; p < particles_.size(); ++p) begin[p + 1] = begin[p] + constraints_.links[p].degree;
        Vector<uint32_t> half_edges(begin.back(), memory), filled(begin.begin(), begin.end() - 1, memory);
        for (uint32_t slot = 0; slot < constraints_.ids.slots(); ++slot) {
            if (!constraints_.ids.live(slot)) continue;
            half_edges[filled[constraints_.by_slot[slot].a]++] = half_edge(slot, false);
            half_edges[filled[constraints_.by_slot[slot].b]++] = half_edge(slot, true);
        }
        for (uint32_t p = 0; p < particles_.size(); ++p) {
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
            const DistanceConstraint& constraint = constraints_.by_slot[slot];
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

    const Constraints& constraints_;
    const Particles& particles_;
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
                start = other_end(constraints.by_slot[slot], start);
            }
            // ... and along it.
            const uint32_t line = static_cast<uint32_t>(lines.chains.size());
            lines.begin_chain(start);
            last_line[start] = line;
            for (uint32_t particle = start; slot != none && !used[slot];) {
                particle = other_end(constraints.by_slot[slot], particle);
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
