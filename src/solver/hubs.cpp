// Hubs: particles with many links of one kind, such as the middle of a parachute, a web or a fan, or the pole of a
// ball.
//
// One sweep over chains moves a particle by each chain through it, one after the other. Written as a matrix, that is a
// product of projections, which is not symmetric: its eigenvalues may be complex, and then a substep turns the errors
// of one link into those of the next and feeds them with energy, as a force that follows the motion does. Around a hub
// the links form such a circle, and the more they are the less of the error each of them takes. A sweep forth and back
// is a symmetric product. It is what exact solution gives for links of some other stiffness, and so it is stable for
// every length of the substep.
#include <algorithm>
#include <iterator>

#include "solver/constraints.h"
#include "solver/plan.h"

namespace gphys {
namespace {

/// So many links of one kind make a hub if the longest is at most this many times as long as the shortest.
struct HubSize {
    uint32_t links;
    double ratio;
};
// With fewer links no web or disc was seen to gain energy. Those that do are regular: eight spokes of one length
// suffice. Irregular meshes have vertices with up to eleven edges, which do no harm and must not double their time: the
// Stanford bunny has six at most within the first of these ratios, eight within the second. Links against bending are
// longer than the edges beside them by more than the last (straight_kernels.cpp).
constexpr HubSize hub_sizes[] = {{8, 1.1}, {9, 1.25}, {12, 1.75}};
constexpr uint32_t least_of_hub = hub_sizes[0].links;

/// A link as one of its particles sees it.
struct Spoke {
    uint32_t particle;
    bool limit;
    double compliance, rest;

    bool same_kind(const Spoke& other) const {
        return particle == other.particle && limit == other.limit && compliance == other.compliance;
    }
    bool operator<(const Spoke& other) const {
        if (particle != other.particle) return particle < other.particle;
        if (limit != other.limit) return limit < other.limit;
        return compliance != other.compliance ? compliance < other.compliance : rest < other.rest;
    }
};

}  // namespace

bool has_hub(const Constraints& constraints) {
    const auto may_be_hub = [](Links links) { return links.degree >= least_of_hub; };
    if (std::none_of(constraints.links.begin(), constraints.links.end(), may_be_hub)) return false;
    Vector<Spoke> spokes(constraints.by_slot.get_allocator());
    for (uint32_t slot = 0; slot < constraints.ids.slots(); ++slot) {
        if (!constraints.ids.live(slot)) continue;
        const DistanceConstraint& link = constraints.by_slot[slot];
        for (const uint32_t p : {link.a, link.b}) {
            if (may_be_hub(constraints.links[p])) spokes.push_back({p, link.limit != 0, link.compliance, link.rest});
        }
    }
    std::sort(spokes.begin(), spokes.end());
    const auto begins_hub = [&](const Spoke& shortest) {
        return std::any_of(std::begin(hub_sizes), std::end(hub_sizes), [&](const HubSize& size) {
            if (static_cast<size_t>(&spokes.back() - &shortest) + 1 < size.links) return false;
            const Spoke& longest = *(&shortest + size.links - 1);
            return shortest.same_kind(longest) && longest.rest <= size.ratio * shortest.rest;
        });
    };
    return std::any_of(spokes.begin(), spokes.end(), begins_hub);
}

}  // namespace gphys
