// Which rigid links of cloth are braces, and which are chords (rigid_links.h). A brace is a diagonal of a cell that has
// both diagonals. Four particles that are all linked to each other cannot bend in their plane, as cells on a surface of
// double curvature must. There the diagonals may yield, as in woven cloth, and the threads keep their lengths.
//
// A cell is found as two common neighbours of the ends of a link that are linked to each other; its diagonals are the
// pair of opposite links with the largest sum of squares. Whether a link is a brace depends on nearby links only, so
// after an edit only links near it are tested again.
#include "solver/cloth/rigid_links.h"

namespace gphys {
namespace {

double square(double x) { return x * x; }

class BraceSearch {
public:
    explicit BraceSearch(RigidLinks& rigid)
        : rigid_(rigid),
          particles_(static_cast<uint32_t>(rigid.begin.size()) - 1),
          longest_(particles_, 0, rigid.at.get_allocator()),
          neighbour_(particles_, none, rigid.at.get_allocator()) {
        for (uint32_t p = 0; p < particles_; ++p) {
            for (uint32_t i = rigid.begin[p]; i < rigid.begin[p + 1]; ++i)
                longest_[p] = std::max(longest_[p], square(rigid.at[i].rest));
        }
    }

    void test_all() {
        for (uint32_t a = 0; a < particles_; ++a) test(a, [](uint32_t) { return true; });
    }
    /// Tests the links whose ends are both among the ends of edited links and their neighbours: only these can be
    /// braces now and not before, or the reverse.
    void test_near_changes() {
        Vector<uint8_t> near(particles_, 0, rigid_.at.get_allocator());
        for (const RigidLinks::Edit& edit : rigid_.edits) {
            for (const uint32_t p : {edit.a, edit.b}) {
                near[p] = 1;
                for (uint32_t i = rigid_.begin[p]; i < rigid_.begin[p + 1]; ++i) near[rigid_.at[i].to] = 1;
            }
        }
        for (uint32_t a = 0; a < particles_; ++a) {
            if (near[a]) test(a, [&](uint32_t b) { return near[b] != 0; });
        }
    }

private:
    static constexpr uint32_t none = 0xffffffff;
    static constexpr double rounding = 1e-6;  // of squared lengths

    /// Tests the links from a to later particles b with wanted(b).
    template <class Wanted>
    void test(uint32_t a, Wanted&& wanted) {
        const uint32_t end = rigid_.begin[a + 1];
        for (uint32_t i = rigid_.begin[a]; i < end; ++i) neighbour_[rigid_.at[i].to] = i;
        for (uint32_t i = rigid_.begin[a]; i < end; ++i) {
            const RigidLinks::End& link = rigid_.at[i];
            if (link.to > a && wanted(link.to)) rigid_.kinds[link.slot] = kinds_of(link);
        }
        for (uint32_t i = rigid_.begin[a]; i < end; ++i) neighbour_[rigid_.at[i].to] = none;
    }

    /// Of a link from the particle whose neighbours are marked.
    uint8_t kinds_of(const RigidLinks::End& link) const {
        constexpr uint32_t most = 16;  // in a grid, two particles have fewer common neighbours
        struct Common {
            uint32_t particle;
            double from_a, from_b;  // squared lengths
        } common[most];
        uint32_t count = 0;
        for (uint32_t j = rigid_.begin[link.to]; j < rigid_.begin[link.to + 1] && count < most; ++j) {
            const uint32_t i = neighbour_[rigid_.at[j].to];
            if (i == none) continue;
            common[count++] = {rigid_.at[j].to, square(rigid_.at[i].rest), square(rigid_.at[j].rest)};
        }
        const double own = square(link.rest);
        uint8_t kinds = 0;
        for (uint32_t i = 0; i < count; ++i) {
            const Common& c = common[i];
            if (std::max(c.from_a, c.from_b) < own * (1 - rounding)) kinds |= RigidLinks::chord;
            for (uint32_t j = i + 1; j < count; ++j) {
                const Common& d = common[j];
                const double opposite = std::max(c.from_a + d.from_b, d.from_a + c.from_b);
                // The search through a list is rarely needed: the longest link is a bound.
                if (own + longest_[c.particle] <= opposite) continue;
                if (own + squared_length(c.particle, d.particle) > opposite) return kinds | RigidLinks::brace;
            }
        }
        return kinds;
    }

    /// Of the link between two particles; without one, minus infinity.
    double squared_length(uint32_t a, uint32_t b) const {
        for (uint32_t i = rigid_.begin[a]; i < rigid_.begin[a + 1]; ++i) {
            if (rigid_.at[i].to == b) return square(rigid_.at[i].rest);
        }
        return -infinity;
    }

    RigidLinks& rigid_;
    uint32_t particles_;
    Vector<double> longest_;      // by particle: the squared length of its longest link
    Vector<uint32_t> neighbour_;  // by particle: its place among the neighbours of the particle under test, or none
};

}  // namespace

void find_braces(RigidLinks& rigid, uint32_t constraint_slots) {
    BraceSearch search(rigid);
    const bool known = !rigid.kinds.empty();
    rigid.kinds.resize(constraint_slots, 0);
    known ? search.test_near_changes() : search.test_all();
}

}  // namespace gphys
