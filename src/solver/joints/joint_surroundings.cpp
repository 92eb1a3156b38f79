// Finds the particles around joints (joint_surroundings.h).
#include "solver/joints/joint_surroundings.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "solver/body_table.h"

namespace gphys {
namespace {

/// A particle near the end of a joint, and its distance along links, metres.
struct Near {
    uint32_t particle;
    double way;
};

/// The links of a body by particle.
class LinkLists {
public:
    double largest_radius = 0;

    LinkLists(const Body& body, std::pmr::memory_resource* memory)
        : links_(memory), is_near_(body.particles.size(), uint8_t{0}, memory) {
        for (uint32_t slot = 0; slot < body.constraints.ids.slots(); ++slot) {
            if (!body.constraints.ids.live(slot)) continue;
            const DistanceConstraint& c = body.constraints.by_slot[slot];
            links_.push_back({c.a, c.b, c.rest});
            links_.push_back({c.b, c.a, c.rest});
        }
        std::stable_sort(links_.begin(), links_.end(),
                         [](const Link& x, const Link& y) { return x.particle < y.particle; });
        for (const double radius : body.particles.radius) largest_radius = std::max(largest_radius, double{radius});
    }
    /// A particle, its neighbours, and those within `reach`. The nearest come first.
    void find_near(uint32_t particle, double reach, Vector<Near>& near) {
        near.assign(1, {particle, 0});
        is_near_[particle] = 1;
        for (size_t i = 0; i < near.size(); ++i) {
            const Near from = near[i];
            each_of(from.particle, [&](uint32_t other, double length) {
                const double way = from.way + length;
                if (is_near_[other] || (i > 0 && way > reach)) return;
                is_near_[other] = 1;
                near.push_back({other, way});
            });
        }
        for (const Near& each : near) is_near_[each.particle] = 0;
    }

private:
    struct Link {
        uint32_t particle, other;
        double length;
    };

    template <class Visit>
    void each_of(uint32_t particle, Visit&& visit) const {
        auto link = std::lower_bound(links_.begin(), links_.end(), particle,
                                     [](const Link& x, uint32_t p) { return x.particle < p; });
        for (; link != links_.end() && link->particle == particle; ++link) visit(link->other, link->length);
    }

    Vector<Link> links_;       // sorted by particle
    Vector<uint8_t> is_near_;  // by particle; 0 between calls
};

/// Sets of ends of joints, each named by its first end.
class Knots {
public:
    Knots(size_t ends, std::pmr::memory_resource* memory) : earlier_(ends, memory) {
        std::iota(earlier_.begin(), earlier_.end(), 0u);
    }
    uint32_t of(uint32_t end) {
        for (; earlier_[end] != end; end = earlier_[end]) earlier_[end] = earlier_[earlier_[end]];
        return end;
    }
    void unite(uint32_t a, uint32_t b) {
        a = of(a), b = of(b);
        earlier_[std::max(a, b)] = std::min(a, b);
    }

private:
    Vector<uint32_t> earlier_;  // an earlier end of the set, or the end itself
};

template <class Value>
void sort_and_unite(Vector<Value>& values) {
    std::sort(values.begin(), values.end());
    const auto is_same = [](const Value& x, const Value& y) { return !(x < y) && !(y < x); };
    values.erase(std::unique(values.begin(), values.end(), is_same), values.end());
}

}  // namespace

bool JointSurroundings::Member::operator<(const Member& other) const {
    return std::tie(body, particle, knot) < std::tie(other.body, other.particle, other.knot);
}

void JointSurroundings::find(const BodyTable& bodies, const Vector<Joint>& joints, const IdTable& slots) {
    members_.clear();
    struct End {
        uint32_t body, particle;

        bool operator<(const End& other) const {
            return std::tie(body, particle) < std::tie(other.body, other.particle);
        }
    };
    Vector<End> ends(memory_);
    Vector<uint32_t> joined(memory_);  // bodies
    for (const uint32_t slot : slots) {
        const Joint& joint = joints[slot];
        ends.insert(ends.end(), {{joint.body_a, joint.particle_a}, {joint.body_b, joint.particle_b}});
        joined.insert(joined.end(), {joint.body_a, joint.body_b});
    }
    sort_and_unite(ends);
    sort_and_unite(joined);
    Vector<LinkLists> lists(memory_);
    for (const uint32_t body : joined) lists.emplace_back(bodies[body], memory_);
    const auto lists_of = [&](uint32_t body) -> LinkLists& {
        return lists[static_cast<size_t>(std::lower_bound(joined.begin(), joined.end(), body) - joined.begin())];
    };
    const auto end_of = [&](uint32_t body, uint32_t particle) {
        return static_cast<uint32_t>(std::lower_bound(ends.begin(), ends.end(), End{body, particle}) - ends.begin());
    };
    struct KnotEnd {
        uint32_t knot, end;

        bool operator<(const KnotEnd& other) const { return std::tie(knot, end) < std::tie(other.knot, other.end); }
    };
    Knots knots(ends.size(), memory_);
    Vector<KnotEnd> of_knots(memory_);
    uint32_t next_knot = static_cast<uint32_t>(ends.size());
    for (const uint32_t slot : slots) {
        const Joint& joint = joints[slot];
        const uint32_t a = end_of(joint.body_a, joint.particle_a), b = end_of(joint.body_b, joint.particle_b);
        // Half of the distance at which they touch: beads on a string are no knot.
        if (joint.rest <= (lists_of(joint.body_a).largest_radius + lists_of(joint.body_b).largest_radius) / 2) {
            knots.unite(a, b);
        } else {
            of_knots.insert(of_knots.end(), {{next_knot, a}, {next_knot, b}});
            ++next_knot;
        }
    }
    for (uint32_t end = 0; end < ends.size(); ++end) of_knots.push_back({knots.of(end), end});
    std::sort(of_knots.begin(), of_knots.end());
    Vector<Near> near(memory_);
    for (auto first = of_knots.begin(), last = first; first != of_knots.end(); first = last) {
        while (last != of_knots.end() && last->knot == first->knot) ++last;
        if (last - first == 1) continue;  // its joints are all long
        double largest = 0, second = 0;   // radii
        for (auto i = first; i != last; ++i) {
            const double radius = lists_of(ends[i->end].body).largest_radius;
            second = std::max(second, std::min(radius, largest));
            largest = std::max(largest, radius);
        }
        for (auto i = first; i != last; ++i) {
            const End& end = ends[i->end];
            LinkLists& links = lists_of(end.body);
            const double of_others = links.largest_radius < largest ? largest : second;
            links.find_near(end.particle, links.largest_radius + of_others, near);
            for (const Near& each : near) members_.push_back({end.body, each.particle, first->knot});
        }
    }
    sort_and_unite(members_);
}

bool JointSurroundings::has(uint32_t body_a, uint32_t a, uint32_t body_b, uint32_t b) const {
    for (auto i = std::lower_bound(members_.begin(), members_.end(), Member{body_a, a, 0});
         i != members_.end() && i->body == body_a && i->particle == a; ++i) {
        if (std::binary_search(members_.begin(), members_.end(), Member{body_b, b, i->knot})) return true;
    }
    return false;
}

}  // namespace gphys
