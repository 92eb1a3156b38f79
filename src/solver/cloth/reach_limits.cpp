// Long-range attachments (Kim, Chentanez, Mueller 2012): a particle is never further from a pinned
// one than the rigid constraints between them are long. Applied after all else, they stop at once
// the stretch that sweeps over constraints would take many substeps to remove.
#include <queue>

#include "solver/body.h"

namespace gphys {
namespace {

// Limits to the nearest pins hold the most; a pinned edge gives each particle dozens that add nothing.
constexpr uint32_t most_anchors = 4;
// Limits leave this part of slack, so that they act on stretch and not on rounding.
constexpr double slack = 1e-6;

struct Neighbours {
    explicit Neighbours(const Body& body, std::pmr::memory_resource* memory)
        : begin(body.particles.size() + 1, 0, memory), slot(memory) {
        const uint32_t slots = body.constraints.ids.slots();
        const auto is_rigid = [&](uint32_t s) {
            return body.constraints.ids.live(s) && body.constraints.by_slot[s].compliance == 0;
        };
        for (uint32_t s = 0; s < slots; ++s) {
            if (!is_rigid(s)) continue;
            ++begin[body.constraints.by_slot[s].a + 1];
            ++begin[body.constraints.by_slot[s].b + 1];
        }
        for (size_t p = 1; p < begin.size(); ++p) begin[p] += begin[p - 1];
        slot.resize(begin.back());
        Vector<uint32_t> next(begin.begin(), begin.end() - 1, memory);
        for (uint32_t s = 0; s < slots; ++s) {
            if (!is_rigid(s)) continue;
            slot[next[body.constraints.by_slot[s].a]++] = s;
            slot[next[body.constraints.by_slot[s].b]++] = s;
        }
    }

    Vector<uint32_t> begin;  // by particle, into slot
    Vector<uint32_t> slot;   // of rigid constraints
};

/// A way of known length from a pinned particle.
struct Way {
    double length;
    uint32_t particle, anchor;

    /// The shortest first; equal ones in an order that is always the same.
    bool operator<(const Way& other) const {
        if (length != other.length) return length > other.length;
        return particle != other.particle ? particle > other.particle : anchor > other.anchor;
    }
};

/// The ways to a particle that may be among the first few to reach it: the shortest known from each of the nearest
/// anchors. Any other is longer than these, or as long as one from the same anchor, and would be of no use.
class Nearest {
public:
    /// Whether a way is among them from here on.
    bool improve(double length, uint32_t anchor) {
        uint32_t i = 0;
        while (i < count_ && anchors_[i] != anchor) ++i;
        if (i < count_ && length >= lengths_[i]) return false;
        if (i == most_anchors) {
            i = static_cast<uint32_t>(std::max_element(lengths_, lengths_ + most_anchors) - lengths_);
            if (length > lengths_[i]) return false;
        }
        count_ = std::max(count_, i + 1);
        anchors_[i] = anchor;
        lengths_[i] = length;
        return true;
    }

private:
    uint32_t count_ = 0;
    uint32_t anchors_[most_anchors];
    double lengths_[most_anchors];
};

}  // namespace

/// Dijkstra from all pins at once; each particle keeps the first few that reach it.
void plan_reach_limits(Body& body) {
    body.cloth.reach_limits.clear();
    std::pmr::memory_resource* memory = body.cloth.reach_limits.get_allocator().resource();
    const Neighbours neighbours(body, memory);
    struct Reached {
        uint32_t count = 0;
        uint32_t anchors[most_anchors];
    };
    Vector<Reached> reached(body.particles.size(), memory);
    Vector<Nearest> nearest(body.particles.size(), memory);
    std::priority_queue<Way, Vector<Way>> ways{std::less<Way>(), Vector<Way>(memory)};
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p) && neighbours.begin[p] != neighbours.begin[p + 1]) ways.push({0, p, p});
    }
    while (!ways.empty()) {
        const Way way = ways.top();
        ways.pop();
        Reached& here = reached[way.particle];
        if (here.count == most_anchors) continue;
        const uint32_t* end = here.anchors + here.count;
        if (std::find(static_cast<const uint32_t*>(here.anchors), end, way.anchor) != end) continue;
        here.anchors[here.count++] = way.anchor;
        if (!body.particles.pinned(way.particle)) {
            const bool flat = !body.cloth.rest_position.empty();
            const double straight =
                flat ? distance(body.cloth.rest_position[way.particle], body.cloth.rest_position[way.anchor])
                     : way.length;
            body.cloth.reach_limits.push_back({way.particle, way.anchor, std::min(straight, way.length) * (1 + slack)});
        }
        for (uint32_t i = neighbours.begin[way.particle]; i < neighbours.begin[way.particle + 1]; ++i) {
            const DistanceConstraint& edge = body.constraints.by_slot[neighbours.slot[i]];
            const uint32_t other = edge.a == way.particle ? edge.b : edge.a;
            const double length = way.length + edge.rest;
            if (nearest[other].improve(length, way.anchor)) ways.push({length, other, way.anchor});
        }
    }
}

}  // namespace gphys
