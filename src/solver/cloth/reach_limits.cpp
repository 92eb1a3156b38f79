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
        : begin(body.size() + 1, 0, memory), slot(memory) {
        const uint32_t slots = body.constraint_ids.slots();
        const auto is_rigid = [&](uint32_t s) {
            return body.constraint_ids.live(s) && body.constraints[s].compliance == 0;
        };
        for (uint32_t s = 0; s < slots; ++s) {
            if (!is_rigid(s)) continue;
            ++begin[body.constraints[s].a + 1];
            ++begin[body.constraints[s].b + 1];
        }
        for (size_t p = 1; p < begin.size(); ++p) begin[p] += begin[p - 1];
        slot.resize(begin.back());
        Vector<uint32_t> next(begin.begin(), begin.end() - 1, memory);
        for (uint32_t s = 0; s < slots; ++s) {
            if (!is_rigid(s)) continue;
            slot[next[body.constraints[s].a]++] = s;
            slot[next[body.constraints[s].b]++] = s;
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

/// Of a sheet in which no two particles come further apart than they are in the plane: to the pins that are nearest
/// there. These are sorted along the axis on which they are spread furthest.
class NearestPins {
public:
    NearestPins(const Body& body, std::pmr::memory_resource* memory) : rest_(body.rest_position), pins_(memory) {
        for (uint32_t p = 0; p < body.size(); ++p) {
            if (body.pinned(p)) pins_.push_back(p);
        }
        if (pins_.empty()) return;
        box_ = {rest_[pins_[0]], rest_[pins_[0]]};
        for (const uint32_t p : pins_) box_ = {min(box_.min, rest_[p]), max(box_.max, rest_[p])};
        axis_ = longest_axis(box_.max - box_.min);
        std::sort(pins_.begin(), pins_.end(), [&](uint32_t a, uint32_t b) {
            return rest_[a][axis_] != rest_[b][axis_] ? rest_[a][axis_] < rest_[b][axis_] : a < b;
        });
    }

    /// visit(pin, distance), the nearest first, of those alike the lowest; most_anchors at most.
    template <class Visit>
    void visit(uint32_t particle, Visit&& visit) const {
        const Vec3 at = rest_[particle];
        Vec3 aside = at - max(box_.min, min(at, box_.max));
        aside[axis_] = 0;
        const double least = length_squared(aside);  // from any pin, across the axis
        const auto before = [&](uint32_t pin, double x) { return rest_[pin][axis_] < x; };
        const auto middle = std::lower_bound(pins_.begin(), pins_.end(), at[axis_], before);
        Nearest nearest;
        for (auto pin = middle; pin != pins_.end(); ++pin) {
            if (!offer(*pin, at, least, nearest)) break;
        }
        for (auto pin = middle; pin != pins_.begin();) {
            if (!offer(*--pin, at, least, nearest)) break;
        }
        for (uint32_t i = 0; i < nearest.count; ++i) visit(nearest.pin[i], std::sqrt(nearest.square[i]));
    }
    bool empty() const { return pins_.empty(); }

private:
    struct Nearest {
        uint32_t count = 0;
        uint32_t pin[most_anchors];
        double square[most_anchors];
    };
    /// False if neither this one nor those behind it are near enough.
    bool offer(uint32_t pin, Vec3 at, double least, Nearest& nearest) const {
        const double along = rest_[pin][axis_] - at[axis_];
        constexpr double rounding = 1 + 1e-12;
        if (nearest.count == most_anchors && along * along + least > nearest.square[most_anchors - 1] * rounding) {
            return false;
        }
        const double square = length_squared(rest_[pin] - at);
        uint32_t place = nearest.count;
        for (; place > 0; --place) {
            const double other = nearest.square[place - 1];
            if (other < square || (other == square && nearest.pin[place - 1] < pin)) break;
            if (place == most_anchors) continue;
            nearest.pin[place] = nearest.pin[place - 1];
            nearest.square[place] = other;
        }
        if (place == most_anchors) return true;
        nearest.pin[place] = pin;
        nearest.square[place] = square;
        nearest.count = std::min(nearest.count + 1, most_anchors);
        return true;
    }

    const Vector<Vec3>& rest_;
    Vector<uint32_t> pins_;
    Aabb box_;
    int axis_ = 0;
};

void limit_flat(Body& body, std::pmr::memory_resource* memory) {
    const NearestPins pins(body, memory);
    if (pins.empty()) return;
    for (uint32_t p = 0; p < body.size(); ++p) {
        if (body.pinned(p)) continue;
        pins.visit(p, [&](uint32_t anchor, double distance) {
            body.plan.reach_limits.push_back({p, anchor, distance * (1 + slack)});
        });
    }
}

/// Dijkstra from all pins at once; each particle keeps the first few that reach it.
void limit_along_links(Body& body, std::pmr::memory_resource* memory) {
    Plan& plan = body.plan;
    const Neighbours neighbours(body, memory);
    struct Reached {
        uint32_t count = 0;
        uint32_t anchors[most_anchors];
    };
    Vector<Reached> reached(body.size(), memory);
    std::priority_queue<Way, Vector<Way>> ways{std::less<Way>(), Vector<Way>(memory)};
    for (uint32_t p = 0; p < body.size(); ++p) {
        if (body.pinned(p) && neighbours.begin[p] != neighbours.begin[p + 1]) ways.push({0, p, p});
    }
    while (!ways.empty()) {
        const Way way = ways.top();
        ways.pop();
        Reached& here = reached[way.particle];
        if (here.count == most_anchors) continue;
        const uint32_t* end = here.anchors + here.count;
        if (std::find(static_cast<const uint32_t*>(here.anchors), end, way.anchor) != end) continue;
        here.anchors[here.count++] = way.anchor;
        if (!body.pinned(way.particle)) {
            plan.reach_limits.push_back({way.particle, way.anchor, way.length * (1 + slack)});
        }
        for (uint32_t i = neighbours.begin[way.particle]; i < neighbours.begin[way.particle + 1]; ++i) {
            const DistanceConstraint& edge = body.constraints[neighbours.slot[i]];
            const uint32_t other = edge.a == way.particle ? edge.b : edge.a;
            if (reached[other].count < most_anchors) ways.push({way.length + edge.rest, other, way.anchor});
        }
    }
}

}  // namespace

void plan_reach_limits(Body& body) {
    Vector<ReachLimit>& limits = body.plan.reach_limits;
    limits.clear();
    std::pmr::memory_resource* memory = limits.get_allocator().resource();
    if (body.rest_position.empty()) {
        limit_along_links(body, memory);
    } else {
        limit_flat(body, memory);
    }
}

}  // namespace gphys
