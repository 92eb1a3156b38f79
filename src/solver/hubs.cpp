// Hubs: particles with many links of one kind, such as the middle of a parachute, a web or a fan, or the pole of a
// ball.
//
// One sweep over chains moves a particle by each chain through it, one after the other. Written as a matrix, that is a
// product of projections, which is not symmetric: its eigenvalues may be complex, and then a substep turns the errors
// of one link into those of the next and feeds them with energy, as a force that follows the motion does. Around a hub
// the links form such a circle, and the more they are the less of the error each of them takes. A sweep there and back
// is a symmetric product. It is what exact solution gives for links of some other stiffness, and so it is stable for
// every length of the substep. A pinned hub is not moved, and its links do not form a circle.
#include <algorithm>

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

/// A link as one of its particles sees it.
struct Spoke {
    double rest, compliance;
    bool limit;

    bool same_kind(const Spoke& other) const { return limit == other.limit && compliance == other.compliance; }
    bool operator<(const Spoke& other) const {
        if (limit != other.limit) return limit < other.limit;
        return compliance != other.compliance ? compliance < other.compliance : rest < other.rest;
    }
};

bool is_hub(Spoke* spokes, uint32_t count) {
    std::sort(spokes, spokes + count);
    for (const HubSize& size : hub_sizes) {
        for (uint32_t i = 0; i + size.links <= count; ++i) {
            const Spoke &shortest = spokes[i], &longest = spokes[i + size.links - 1];
            if (shortest.same_kind(longest) && longest.rest <= size.ratio * shortest.rest) return true;
        }
    }
    return false;
}

}  // namespace

/// Particles with the number of links that one must have are listed by counting sort.
void list_hubs(Vector<uint32_t>& hubs, const Constraints& constraints) {
    const uint32_t particles = static_cast<uint32_t>(constraints.links.size());
    Vector<uint32_t> begin(particles + size_t{1}, 0, constraints.by_slot.get_allocator());
    for (uint32_t p = 0; p < particles; ++p) {
        const uint32_t degree = constraints.links[p].degree;
        begin[p + 1] = begin[p] + (degree >= hub_sizes[0].links ? degree : 0);
    }
    if (begin.back() == 0) return;
    Vector<Spoke> spokes(begin.back(), begin.get_allocator());
    Vector<uint32_t> next(begin.begin(), begin.end() - 1, begin.get_allocator());
    for (const uint32_t slot : constraints.ids) {
        const DistanceConstraint& link = constraints.by_slot[slot];
        for (const uint32_t p : {link.a, link.b}) {
            if (begin[p] < begin[p + 1]) spokes[next[p]++] = {link.rest, link.compliance, link.limit != 0};
        }
    }
    for (uint32_t p = 0; p < particles; ++p) {
        if (begin[p] < begin[p + 1] && is_hub(&spokes[begin[p]], begin[p + 1] - begin[p])) hubs.push_back(p);
    }
}

}  // namespace gphys
