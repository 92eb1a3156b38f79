// Finds the particles around joints (joint_surroundings.h).
#include "solver/joints/joint_surroundings.h"

#include <algorithm>
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

}  // namespace

bool JointSurroundings::JointPair::operator<(const JointPair& other) const {
    return std::tie(body_a, body_b, a, b) < std::tie(other.body_a, other.body_b, other.a, other.b);
}

void JointSurroundings::find(const BodyTable& bodies, const Vector<Joint>& joints, const IdTable& slots) {
    pairs_.clear();
    Vector<uint32_t> joined(memory_);  // bodies, ascending
    for (const uint32_t slot : slots) joined.insert(joined.end(), {joints[slot].body_a, joints[slot].body_b});
    std::sort(joined.begin(), joined.end());
    joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
    Vector<LinkLists> lists(memory_);
    for (const uint32_t body : joined) lists.emplace_back(bodies[body], memory_);
    const auto lists_of = [&](uint32_t body) -> LinkLists& {
        return lists[static_cast<size_t>(std::lower_bound(joined.begin(), joined.end(), body) - joined.begin())];
    };
    Vector<Near> near_a(memory_), near_b(memory_);
    for (const uint32_t slot : slots) {
        const Joint& joint = joints[slot];
        LinkLists &of_a = lists_of(joint.body_a), &of_b = lists_of(joint.body_b);
        const double reach = of_a.largest_radius + of_b.largest_radius;
        of_a.find_near(joint.particle_a, reach, near_a);
        of_b.find_near(joint.particle_b, reach, near_b);
        for (const Near& a : near_a) {
            for (const Near& b : near_b) {
                pairs_.push_back(joint.body_a < joint.body_b
                                     ? JointPair{joint.body_a, joint.body_b, a.particle, b.particle}
                                     : JointPair{joint.body_b, joint.body_a, b.particle, a.particle});
            }
        }
    }
    std::sort(pairs_.begin(), pairs_.end());
    const auto is_same = [](const JointPair& x, const JointPair& y) { return !(x < y) && !(y < x); };
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end(), is_same), pairs_.end());
}

bool JointSurroundings::has(uint32_t body_a, uint32_t a, uint32_t body_b, uint32_t b) const {
    return std::binary_search(pairs_.begin(), pairs_.end(),
                              body_a < body_b ? JointPair{body_a, body_b, a, b} : JointPair{body_b, body_a, b, a});
}

}  // namespace gphys
