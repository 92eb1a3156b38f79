// Long-range attachments (Kim, Chentanez, Mueller-Fischer 2012): a particle stays within the length of the shortest
// path of rigid links from each of its nearest pins. Applied after all else, these limits remove at once the stretch
// for which sweeps over the links would need many substeps.
//
// The paths are found by Dijkstra's algorithm from all pins at once. Each particle keeps the nearest four pins. The
// queue is an array of buckets by length (Dial 1969), in which heaps stay small, because lengths are real numbers.
// While there are at most four pins, the paths of each are kept, so that a new pin needs only its own search.
#include "solver/cloth/reach_limits.h"

#include <iterator>

#include "solver/cloth/cloth_sheet.h"
#include "solver/cloth/cloth_state.h"
#include "solver/cloth/rigid_links.h"
#include "solver/particles/particles.h"

namespace gphys {
namespace {

// A pinned edge would give each particle dozens of limits. More than the nearest few hardly reduce the stretch.
constexpr uint32_t most_anchors = 4;
// Limits leave this fraction of slack, so that they act on stretch and not on rounding.
constexpr double slack = 1e-6;

/// The lengths of the shortest known paths from the nearest anchors to one particle. A longer path, or one as long from
/// the same anchor, is pruned.
class NearestAnchors {
public:
    /// Returns whether the path is now among them.
    bool improve(double length, uint32_t anchor) {
        for (uint32_t i = 0; i < count_; ++i) {
            if (anchors_[i] == anchor) return replace(i, length, anchor, length < lengths_[i]);
        }
        if (count_ < most_anchors) return replace(count_++, length, anchor, true);
        const uint32_t last = static_cast<uint32_t>(std::max_element(lengths_, lengths_ + most_anchors) - lengths_);
        return replace(last, length, anchor, length <= lengths_[last]);
    }

private:
    bool replace(uint32_t i, double length, uint32_t anchor, bool better) {
        if (better) anchors_[i] = anchor, lengths_[i] = length;
        return better;
    }

    uint32_t count_ = 0;
    uint32_t anchors_[most_anchors];
    double lengths_[most_anchors];
};

/// The priority queue of Dijkstra's algorithm: buckets of paths of similar length. A bucket becomes a binary heap when
/// it is the first that is not empty. So heaps have a few elements, and each path is moved once or twice.
class PathQueue {
public:
    /// A path that is pushed must not be longer than the last one popped plus the longest link.
    PathQueue(const RigidLinks& rigid, std::pmr::memory_resource* memory) : buckets_(memory) {
        double longest = 0, sum = 0;
        for (const RigidLinks::End& link : rigid.at) longest = std::max(longest, link.rest), sum += link.rest;
        const double mean = sum / static_cast<double>(std::max<size_t>(1, rigid.at.size()));
        per_width_ = longest > 0 ? std::min(128 / mean, (most_buckets - 3) / longest) : 1;
        uint64_t needed = 4;
        while (static_cast<double>(needed) < longest * per_width_ + 3) needed *= 2;
        buckets_.resize(needed);
    }

    void push(const PinPath& path) {
        const auto number = static_cast<uint64_t>(path.length * per_width_);
        Vector<PinPath>& bucket = bucket_of(number);
        bucket.push_back(path);
        if (number == current_ && is_heap_) std::push_heap(bucket.begin(), bucket.end(), later);
        ++count_;
    }
    bool empty() const { return count_ == 0; }
    PinPath pop() {
        while (bucket_of(current_).empty()) ++current_, is_heap_ = false;
        Vector<PinPath>& bucket = bucket_of(current_);
        if (!is_heap_) std::make_heap(bucket.begin(), bucket.end(), later);
        is_heap_ = true;
        std::pop_heap(bucket.begin(), bucket.end(), later);
        const PinPath path = bucket.back();
        bucket.pop_back();
        --count_;
        return path;
    }

private:
    static constexpr double most_buckets = 4096;

    static bool later(const PinPath& a, const PinPath& b) { return b < a; }
    Vector<PinPath>& bucket_of(uint64_t number) { return buckets_[number & (buckets_.size() - 1)]; }

    double per_width_;                 // 1 / (width of a bucket in metres)
    Vector<Vector<PinPath>> buckets_;  // a power of two; number modulo their count
    uint64_t current_ = 0;
    bool is_heap_ = false;  // whether the current bucket is a heap
    size_t count_ = 0;
};

/// Labels for paths from one anchor: the shortest known length by particle.
class LabelsOfOne {
public:
    LabelsOfOne(size_t particles, std::pmr::memory_resource* memory) : shortest_(particles, infinity, memory) {}

    /// Whether to push the path.
    bool improve(const PinPath& path) {
        if (!(path.length < shortest_[path.particle])) return false;
        shortest_[path.particle] = path.length;
        return true;
    }
    /// Whether to keep the path when it is popped.
    bool settle(const PinPath& path) { return path.length == shortest_[path.particle]; }

private:
    Vector<double> shortest_;
};

/// Labels for paths from any number of anchors; each particle keeps the first few that reach it.
class LabelsOfNearest {
public:
    LabelsOfNearest(size_t particles, std::pmr::memory_resource* memory)
        : settled_(particles, memory), nearest_(particles, memory) {}

    bool improve(const PinPath& path) { return nearest_[path.particle].improve(path.length, path.anchor); }
    bool settle(const PinPath& path) {
        Settled& here = settled_[path.particle];
        if (here.count == most_anchors) return false;
        const uint32_t* end = here.anchors + here.count;
        if (std::find(static_cast<const uint32_t*>(here.anchors), end, path.anchor) != end) return false;
        here.anchors[here.count++] = path.anchor;
        return true;
    }

private:
    struct Settled {
        uint32_t count = 0;
        uint32_t anchors[most_anchors];
    };

    Vector<Settled> settled_;
    Vector<NearestAnchors> nearest_;
};

/// Dijkstra's algorithm from some anchors at once. Returns the paths in ascending order.
template <class Labels>
Vector<PinPath> find_paths(const RigidLinks& rigid, const uint32_t* anchors, size_t count) {
    std::pmr::memory_resource* const memory = rigid.at.get_allocator().resource();
    const size_t particles = rigid.begin.size() - 1;
    Labels labels(particles, memory);
    Vector<PinPath> found(memory);
    found.reserve(particles);
    PathQueue queue(rigid, memory);
    const auto offer = [&](const PinPath& path) {
        if (labels.improve(path)) queue.push(path);
    };
    for (size_t i = 0; i < count; ++i) offer({0, anchors[i], anchors[i]});
    while (!queue.empty()) {
        const PinPath path = queue.pop();
        if (!labels.settle(path)) continue;
        found.push_back(path);
        for (uint32_t i = rigid.begin[path.particle]; i < rigid.begin[path.particle + 1]; ++i) {
            offer({path.length + rigid.at[i].rest, rigid.at[i].to, path.anchor});
        }
    }
    return found;
}

/// Updates the paths after particles were pinned or released. With at most `most_anchors` pins before and now, each pin
/// reaches all particles, so the paths from the other pins stay valid.
void update_paths(const Particles& particles, const RigidLinks& rigid, Vector<PinPath>& paths) {
    const auto memory = paths.get_allocator();
    Vector<uint32_t> anchors(memory), added(memory);
    Vector<uint8_t> known(particles.size(), 0, memory);
    uint32_t before = 0;
    for (const PinPath& path : paths) {
        if (path.particle == path.anchor) known[path.anchor] = 1, ++before;
    }
    for (uint32_t p = 0; p < particles.size(); ++p) {
        if (!particles.pinned(p) || rigid.begin[p] == rigid.begin[p + 1]) continue;
        anchors.push_back(p);
        if (!known[p]) added.push_back(p);
    }
    if (anchors.size() > most_anchors || before > most_anchors) {
        paths = find_paths<LabelsOfNearest>(rigid, anchors.data(), anchors.size());
        return;
    }
    Vector<PinPath> all(memory);
    all.reserve(paths.size());
    std::copy_if(paths.begin(), paths.end(), std::back_inserter(all),
                 [&](const PinPath& path) { return particles.pinned(path.anchor); });
    for (const uint32_t anchor : added) {
        const Vector<PinPath> found = find_paths<LabelsOfOne>(rigid, &anchor, 1);
        Vector<PinPath> merged(all.size() + found.size(), memory);
        std::merge(all.begin(), all.end(), found.begin(), found.end(), merged.begin());
        all.swap(merged);
    }
    paths.swap(all);
}

ClothLimits packed(const ReachLimits& reach) {
    return {reach.limited.data(), reach.anchors.data(), reach.distances.data()};
}

}  // namespace

void plan_reach_limits(ReachLimits& reach, const RigidLinks& rigid, const Particles& particles,
                       const ClothSheet& sheet) {
    reach.limits.clear();
    update_paths(particles, rigid, reach.paths);
    reach.limits.reserve(reach.paths.size());
    const bool flat = !sheet.rest_position.empty();
    for (const PinPath& path : reach.paths) {
        if (particles.pinned(path.particle)) continue;
        const double straight =
            flat ? distance(sheet.rest_position[path.particle], sheet.rest_position[path.anchor]) : path.length;
        reach.limits.push_back({path.particle, path.anchor, std::min(straight, path.length) * (1 + slack)});
    }
}

/// The limits of one particle act one after the other, those of different particles in eight lanes: rank 0 has the
/// nearest anchor of each particle, rank 1 the second nearest, and so on.
void pack_reach_limits(ReachLimits& reach, uint32_t particles) {
    constexpr uint32_t lanes = 8;
    Vector<uint32_t> rank(reach.limits.size(), reach.limited.get_allocator()),
        count(particles, 0, rank.get_allocator());
    uint32_t ranks = 0;
    for (size_t i = 0; i < reach.limits.size(); ++i) {
        rank[i] = count[reach.limits[i].particle]++;
        ranks = std::max(ranks, rank[i] + 1);
    }
    const auto add = [&](const ReachLimit& limit) {
        reach.limited.push_back(limit.particle);
        reach.anchors.push_back(limit.anchor);
        reach.distances.push_back(static_cast<float>(limit.distance));
    };
    reach.limited.clear();
    reach.anchors.clear();
    reach.distances.clear();
    reach.ranks.assign(1, 0);
    for (uint32_t r = 0; r < ranks; ++r) {
        for (size_t i = 0; i < reach.limits.size(); ++i) {
            if (rank[i] == r) add(reach.limits[i]);
        }
        while (reach.limited.size() % lanes != 0) add({particles, particles, 0});  // a particle that does not move
        reach.ranks.push_back(static_cast<uint32_t>(reach.limited.size()));
    }
}

void apply_reach_limits(const ReachLimits& reach, ClothState& state, Team* team) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    const ClothLimits limits = packed(reach);
    for (size_t rank = 0; rank + 1 < reach.ranks.size(); ++rank) {
        const uint32_t first = reach.ranks[rank], count = reach.ranks[rank + 1] - first;
        share(team, (count + share_limits - 1) / share_limits, [&](uint32_t i, uint32_t) {
            const uint32_t from = first + i * share_limits;
            kernels.limit(state.at.data(), {limits.particles + from, limits.anchors + from, limits.distances + from},
                          std::min(share_limits, first + count - from));
        });
    }
}

void apply_reach_limits(const ReachLimits& reach, ClothState& state, float* pulls) {
    cloth_kernels(chosen_isa())
        .limit_pulling(state.at.data(), packed(reach), static_cast<uint32_t>(reach.limited.size()),
                       state.acceleration.data(), pulls);
}

}  // namespace gphys
