// The list of pairs of particles that may come into contact: a Verlet list (Verlet 1967) by spatial hashing (Teschner
// et al. 2003), in groups (particle_contacts.h).
#include "solver/contact/particle_pairs.h"

#include "solver/contact/particle_contacts.h"
#include "solver/joints/joint_surroundings.h"

namespace gphys {
namespace {

constexpr uint32_t crowded_pairs = 4;
constexpr uint32_t crowded_tests = 8;
// Margin of a particle at rest, in radii. With a larger margin the list is valid for longer and has more pairs.
constexpr double least_margin = 0.2;
// The margin of a moving particle covers this many substeps at its present speed.
constexpr double margin_substeps = 2;

bool linked(const Body& body, uint32_t a, uint32_t b) {
    const auto begin = body.contacts.self.linked.begin() + body.contacts.self.linked_begin[a],
               end = body.contacts.self.linked.begin() + body.contacts.self.linked_begin[a + 1];
    return std::binary_search(begin, end, b);
}

/// Within one body. Linked particles that overlap at rest do not collide.
bool collide_within(const Body& body, uint32_t a, uint32_t b) {
    if (!body.settings.self_collision) return false;
    if (body.plan.method == GPHYS_SOLVE_FREE) return true;
    return distance(body.contacts.self.placed[a], body.contacts.self.placed[b]) >
               body.particles.radius[a] + body.particles.radius[b] &&
           !linked(body, a, b);
}

struct Grid {
    double size;
    // If there are few cells in the box around all particles, they are numbered: the numbers of a row along z follow
    // each other. Else cells are hashed, and different ones may share a key, which costs time but changes no result.
    bool numbered = false;
    int64_t first[3] = {}, last[3] = {};  // of the numbered cells

    // Beyond this, and for NaN, all are in one cell, because the cast would trap.
    static constexpr double most = 1e15;
    int64_t along(double x) const {
        const double cell = std::floor(x / size);
        return static_cast<int64_t>(cell > -most ? std::min(cell, most) : -most);
    }
    void number(const Aabb& box, double most_cells) {
        double cells = 1;
        for (int k = 0; k < 3; ++k) {
            first[k] = along(box.min[k]);
            last[k] = along(box.max[k]);
            cells *= static_cast<double>(last[k] - first[k] + 1);
        }
        numbered = cells <= most_cells;
    }
    uint64_t count(int k) const { return static_cast<uint64_t>(last[k] - first[k] + 1); }
    uint64_t next_key(uint64_t key, int64_t cell, int k) const {
        return numbered ? key * count(k) + static_cast<uint64_t>(cell - first[k]) : mixed(key, cell);
    }
    uint64_t key(Vec3 at) const {
        uint64_t key = 0;
        for (int k = 0; k < 3; ++k) {
            const int64_t cell = along(at[k]);
            key = next_key(key, numbered ? std::clamp(cell, first[k], last[k]) : cell, k);  // for NaN
        }
        return key;
    }
};

}  // namespace

bool ParticleContacts::list_is_valid(const Range& range) const {
    std::atomic<bool> valid{true};
    share_particles(range, [&](uint32_t first, uint32_t end) {
        const auto is_near = [](const Particle& p) {
            return p.margin >= 0 && length_squared(p.at - p.list_position) <= p.margin * p.margin;
        };
        if (!std::all_of(range.particles + first, range.particles + end, is_near))
            valid.store(false, std::memory_order_relaxed);
    });
    return valid.load(std::memory_order_relaxed);
}

/// The search for the pairs of one list.
class ParticleContacts::PairSearch {
public:
    PairSearch(const Range& range, const BodyTable& bodies) : range_(range), bodies_(bodies) {}

    void run();

private:
    void sort_by_cell();
    void sort_by_group();
    void use_one_group();
    bool fill();
    void fill_crowded();
    bool cells_around(const Particle& p, int64_t (&low)[3], int64_t (&high)[3]) const;
    template <class Visit>
    bool each_cell(const Particle& p, Visit&& visit) const;
    template <class Visit>
    bool each_row(const Particle& p, Visit&& visit) const;
    uint32_t begin_of(uint64_t bucket) const { return range_.buckets[bucket + 1]; }
    uint32_t end_of(uint64_t bucket) const {
        return bucket + 1 < range_.table_size ? range_.buckets[bucket + 2] : range_.count;
    }
    bool finds(uint32_t i, const Particle& p, const Near& q) const;

    Near near(uint32_t i) const { return {range_.particles[i].at, range_.particles[i].reach(), 0, i}; }
    bool is_deep(uint32_t i, uint32_t j) const {
        const Particle &p = range_.particles[i], &q = range_.particles[j];
        const double radii = (p.radius + q.radius) * (1 - deep);
        return length_squared(p.at - q.at) < radii * radii;
    }

    const Range& range_;
    const BodyTable& bodies_;
    Grid grid_{1};
    double largest_reach_ = 0;
    Aabb box_{};  // of the particles
    bool grouped_ = false;
};

/// Sorts the particles by the number or the hash of their cell (counting sort). Cells are as wide as two particles of
/// average reach, so that such a particle visits 27 cells.
void ParticleContacts::PairSearch::sort_by_cell() {
    share_particles(range_, [&](uint32_t first, uint32_t end) {
        for (uint32_t i = first; i < end; ++i) range_.keys[i] = grid_.key(range_.particles[i].at);
    });
    const uint32_t mask = range_.table_size - 1;
    std::fill(range_.buckets, range_.buckets + range_.table_size + 1, 0);
    for (uint32_t i = 0; i < range_.count; ++i) ++range_.buckets[(range_.keys[i] & mask) + 1];
    for (uint32_t b = 0; b < range_.table_size; ++b) range_.buckets[b + 1] += range_.buckets[b];
    // The start of each bucket moves to the place after it: bucket b is buckets[b + 1] .. its successor's.
    for (uint32_t i = range_.count; i-- > 0;) {
        Near& place = range_.sorted[--range_.buckets[(range_.keys[i] & mask) + 1]];
        place = near(i);
        place.key = range_.keys[i];
    }
}

void ParticleContacts::PairSearch::use_one_group() {
    std::fill(range_.groups, range_.groups + range_.group_count, Group{});
    range_.groups[0].size = range_.count;
    for (uint32_t i = 0; i < range_.count; ++i) range_.order[i] = i;
    grouped_ = false;
}

/// Sorts the particles by group. A particle finds pairs with others that are less than half a coarse cell away.
///
/// The groups of a colour are in the order of their cells along the box around all, its longest side first, and have
/// about as many particles each. So a member of the team, which takes neighbouring groups of each colour, mostly has
/// the particles in its cache that it wrote for the last one.
void ParticleContacts::PairSearch::sort_by_group() {
    constexpr uint32_t bins = least_grouped;
    const Grid coarse{4 * largest_reach_ * (1 + 0x1p-20)};
    const Vec3 extent = box_.max - box_.min;
    int axes[3] = {0, 1, 2};
    std::stable_sort(axes, axes + 3, [&](int a, int b) { return extent[a] > extent[b]; });
    double sizes[3], all = 1;
    for (int k = 0; k < 3; ++k) {
        sizes[k] = static_cast<double>(coarse.along(box_.max[axes[k]]) - coarse.along(box_.min[axes[k]]) + 1);
        all *= sizes[k];
    }
    uint32_t* const histogram = range_.order;
    std::fill(histogram, histogram + bins, 0);
    for (uint32_t i = 0; i < range_.count; ++i) {
        double place = 0;
        uint64_t colour = 0;
        for (int k = 0; k < 3; ++k) {
            const int64_t cell = coarse.along(range_.particles[i].at[axes[k]]);
            place = place * sizes[k] + static_cast<double>(cell - coarse.along(box_.min[axes[k]]));
            colour = 2 * colour + static_cast<uint64_t>(cell & 1);
        }
        const uint64_t bin = std::min(static_cast<uint64_t>(place / all * bins), uint64_t{bins - 1});
        ++histogram[bin];
        range_.keys[i] = colour * bins + bin;
    }
    for (uint32_t bin = 0, before = 0; bin < bins; ++bin) {
        const uint32_t count = histogram[bin];
        histogram[bin] = static_cast<uint32_t>(uint64_t{groups_per_colour} * before / range_.count);
        before += count;
    }
    const auto group_of = [&](uint32_t i) {
        return range_.keys[i] / bins * groups_per_colour + histogram[range_.keys[i] % bins];
    };
    std::fill(range_.groups, range_.groups + range_.group_count, Group{});
    for (uint32_t i = 0; i < range_.count; ++i) {
        range_.keys[i] = group_of(i);
        ++range_.groups[range_.keys[i]].size;
    }
    for (uint32_t g = 0, next = 0; g < range_.group_count; ++g) {
        range_.groups[g].first = next;
        next += range_.groups[g].size;
        range_.groups[g].size = 0;
    }
    for (uint32_t i = 0; i < range_.count; ++i) {
        Group& group = range_.groups[range_.keys[i]];
        range_.order[group.first + group.size++] = i;
    }
    grouped_ = true;
}

/// The cells that a particle has to search. Returns false if these are more than all particles.
bool ParticleContacts::PairSearch::cells_around(const Particle& p, int64_t (&low)[3], int64_t (&high)[3]) const {
    const double reach = 2 * p.reach();
    double cells = 1;
    for (int k = 0; k < 3; ++k) {
        low[k] = grid_.along(p.at[k] - reach);
        high[k] = grid_.along(p.at[k] + reach);
        cells *= static_cast<double>(high[k] - low[k] + 1);
        if (!grid_.numbered) continue;
        low[k] = std::max(low[k], grid_.first[k]);
        high[k] = std::min(high[k], grid_.last[k]);
    }
    return cells <= range_.count;
}

/// Calls visit(key, first, end) for the ranges of `sorted` that a particle has to search for those of a key. Returns
/// false if these are more than all particles.
template <class Visit>
bool ParticleContacts::PairSearch::each_cell(const Particle& p, Visit&& visit) const {
    int64_t low[3], high[3];
    if (!cells_around(p, low, high)) return false;
    const uint64_t mask = range_.table_size - 1;
    for (int64_t x = low[0]; x <= high[0]; ++x) {
        const uint64_t key_x = grid_.next_key(0, x, 0);
        for (int64_t y = low[1]; y <= high[1]; ++y) {
            const uint64_t key_xy = grid_.next_key(key_x, y, 1);
            for (int64_t z = low[2]; z <= high[2]; ++z) {
                const uint64_t key = grid_.next_key(key_xy, z, 2), bucket = key & mask;
                const uint32_t first = begin_of(bucket), end = end_of(bucket);
                if (first < end) visit(key, first, end);
            }
        }
    }
    return true;
}

/// The same by rows of numbered cells: visit(first, end).
template <class Visit>
bool ParticleContacts::PairSearch::each_row(const Particle& p, Visit&& visit) const {
    int64_t low[3], high[3];
    if (!cells_around(p, low, high)) return false;
    if (low[2] > high[2]) return true;  // for NaN
    for (int64_t x = low[0]; x <= high[0]; ++x) {
        const uint64_t key_x = grid_.next_key(0, x, 0);
        for (int64_t y = low[1]; y <= high[1]; ++y) {
            const uint64_t key_xy = grid_.next_key(key_x, y, 1);
            visit(begin_of(grid_.next_key(key_xy, low[2], 2)), end_of(grid_.next_key(key_xy, high[2], 2)));
        }
    }
    return true;
}

/// Whether particle i lists the pair with q: the one with the larger reach does. Of two with the same reach it is, in
/// groups, one at random, because a group whose particles list most of their pairs would not have the room.
bool ParticleContacts::PairSearch::finds(uint32_t i, const Particle& p, const Near& q) const {
    const double reach = p.reach() + q.reach;
    if (length_squared(p.at - q.at) > reach * reach || q.reach > p.reach() || q.particle == i) return false;
    if (q.reach == p.reach()) {
        const uint64_t mine = grouped_ ? mixed(0, i) : i, others = grouped_ ? mixed(0, q.particle) : q.particle;
        if (others < mine) return false;
    }
    const Particle& other = range_.particles[q.particle];
    if (p.inverse_mass == 0 && other.inverse_mass == 0) return false;
    const Body &a = bodies_[p.body], &b = bodies_[other.body];
    if (p.body == other.body) return collide_within(a, p.number, other.number);
    if ((a.settings.body_layers & b.settings.body_layers) == 0) return false;
    return !a.plan.joined || !b.plan.joined || !range_.beside_joints->has(p.body, p.number, other.body, other.number);
}

/// Lists the pairs of all groups. Returns whether there was room for all. Stops when there are too many.
bool ParticleContacts::PairSearch::fill() {
    std::atomic<uint32_t> all{0};  // in both passes of fill_groups
    return fill_groups(range_, &Group::pairs, pairs_per_particle, [&](Group& group, uint32_t begin, uint32_t room) {
        uint32_t found = 0;
        group.deep = 0;
        const auto fits = [&] { return found <= range_.most_pairs(); };
        for (uint32_t k = group.first; k < group.first + group.size; ++k) {
            const uint32_t i = range_.order[k], before = found;
            const Particle& p = range_.particles[i];
            const auto test = [&](const Near& q) {
                if (!finds(i, p, q) || found++ >= room) return;
                if (is_deep(i, q.particle)) ++group.deep;
                range_.pairs[begin + found - 1] = {std::min(i, q.particle), std::max(i, q.particle)};
            };
            const auto test_all = [&](uint32_t first, uint32_t end) {
                for (; first < end && fits(); ++first) test(range_.sorted[first]);
            };
            const auto test_of_key = [&](uint64_t key, uint32_t first, uint32_t end) {
                for (; first < end && fits(); ++first) {
                    if (range_.sorted[first].key == key) test(range_.sorted[first]);
                }
            };
            const bool few = grid_.numbered ? each_row(p, test_all) : each_cell(p, test_of_key);
            for (uint32_t j = 0; j < range_.count && !few && fits(); ++j) test(near(j));
            const uint32_t more = found - before;
            if (all.fetch_add(more, std::memory_order_relaxed) + more > 2 * range_.most_pairs() || !fits()) break;
        }
        return found;
    });
}

/// A bounded number of pairs for each particle: with the particles with the next indices, cyclically, so that all are
/// in about as many pairs.
void ParticleContacts::PairSearch::fill_crowded() {
    uint32_t& count = range_.groups[0].pairs.count;
    count = 0;
    for (uint32_t i = 0; i < range_.count; ++i) {
        const Particle& p = range_.particles[i];
        uint32_t found = 0;
        const auto test = [&](const Near& q) {
            if (!finds(i, p, q) || count == range_.most_pairs()) return;
            range_.pairs[count++] = {std::min(i, q.particle), std::max(i, q.particle)};
            ++found;
        };
        const auto search = [&](uint32_t entries, uint32_t next, auto&& entry) {
            for (uint32_t k = 0; k < std::min(entries, crowded_tests) && found < crowded_pairs; ++k) {
                entry(next + k < entries ? next + k : next + k - entries);
            }
        };
        const bool few = each_cell(p, [&](uint64_t key, uint32_t first, uint32_t end) {
            if (found == crowded_pairs) return;
            const Near *const list = range_.sorted + first, *const list_end = range_.sorted + end;
            const auto next = static_cast<uint32_t>(
                std::upper_bound(list, list_end, i, [](uint32_t a, const Near& b) { return a < b.particle; }) - list);
            search(end - first, next % (end - first), [&](uint32_t k) {
                if (list[k].key == key) test(list[k]);
            });
        });
        if (!few) search(range_.count, (i + 1) % range_.count, [&](uint32_t j) { test(near(j)); });
    }
}

void ParticleContacts::PairSearch::run() {
    share_particles(range_, [&](uint32_t first, uint32_t end) {
        for (uint32_t i = first; i < end; ++i) {
            Particle& p = range_.particles[i];
            p.list_position = p.at;
            p.margin = std::max(least_margin * p.radius, margin_substeps * distance(p.at, p.before));
        }
    });
    double sum = 0;
    box_ = {range_.particles[0].at, range_.particles[0].at};
    for (uint32_t i = 0; i < range_.count; ++i) {
        sum += range_.particles[i].reach();
        largest_reach_ = std::max(largest_reach_, range_.particles[i].reach());
        box_ = {min(box_.min, range_.particles[i].at), max(box_.max, range_.particles[i].at)};
    }
    range_.listed.sort();
    if (sum == 0) {  // points at rest
        std::fill(range_.groups, range_.groups + range_.group_count, Group{});
        return;
    }
    grid_.size = 2 * sum / range_.count;
    grid_.number(box_, range_.table_size);
    sort_by_cell();
    if (range_.group_count > 1) {
        sort_by_group();
        if (fill()) return;
    }
    use_one_group();
    if (fill() || uint64_t{range_.groups[0].deep} * one_deep_of <= range_.groups[0].pairs.count) return;
    fill_crowded();
}

void ParticleContacts::find_pairs(const Range& range, const BodyTable& bodies) const {
    PairSearch(range, bodies).run();
    for (uint32_t i = 0; i < range.count; ++i) range.particles[i].paired = false;
    for (const Group* group = range.groups; group != range.groups + range.group_count; ++group) {
        for (uint32_t i = group->pairs.begin; i < group->pairs.begin + group->pairs.count; ++i)
            range.particles[range.pairs[i].a].paired = range.particles[range.pairs[i].b].paired = true;
    }
}

void list_linked(Body& body) {
    const uint32_t n = body.particles.size();
    body.contacts.self.linked_begin.clear();  // marks the list as missing, in case memory runs out
    body.contacts.self.linked.resize(2 * size_t{body.constraints.ids.size()});
    body.contacts.self.linked_begin.assign(size_t{n} + 1, 0);
    for (uint32_t p = 0; p < n; ++p)
        body.contacts.self.linked_begin[p + 1] = body.contacts.self.linked_begin[p] + body.constraints.links[p].degree;
    for (uint32_t slot = 0; slot < body.constraints.ids.slots(); ++slot) {
        if (!body.constraints.ids.live(slot)) continue;
        const DistanceConstraint& c = body.constraints.by_slot[slot];
        body.contacts.self.linked[body.contacts.self.linked_begin[c.a]++] = c.b;
        body.contacts.self.linked[body.contacts.self.linked_begin[c.b]++] = c.a;
    }
    for (uint32_t p = n; p > 0; --p) body.contacts.self.linked_begin[p] = body.contacts.self.linked_begin[p - 1];
    body.contacts.self.linked_begin[0] = 0;
    for (uint32_t p = 0; p < n; ++p) {
        std::sort(body.contacts.self.linked.begin() + body.contacts.self.linked_begin[p],
                  body.contacts.self.linked.begin() + body.contacts.self.linked_begin[p + 1]);
    }
}

}  // namespace gphys
