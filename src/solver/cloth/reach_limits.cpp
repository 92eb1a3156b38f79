// Long-range attachments (Kim, Chentanez, Mueller 2012): a particle is never further from a pinned
// one than the rigid constraints between them are long. Applied after all else, they stop at once
// the stretch that sweeps over constraints would take many substeps to remove.
#include <iterator>

#include "solver/body.h"

namespace gphys {
namespace {

// Limits to the nearest pins hold the most; a pinned edge gives each particle dozens that add nothing.
constexpr uint32_t most_anchors = 4;
// Limits leave this part of slack, so that they act on stretch and not on rounding.
constexpr double slack = 1e-6;

/// The ways to a particle that may be among the first few to reach it: the shortest known from each of the nearest
/// anchors. Any other is longer than these, or as long as one from the same anchor, and would be of no use.
class Nearest {
public:
    /// Whether a way is among them from here on.
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

/// Ways in the order in which Dijkstra's algorithm takes them. Those of nearly one length share a bucket, which becomes
/// a heap when its turn comes: heaps have a few elements, and each way is moved there once or twice.
class Ways {
public:
    /// No way is pushed that is longer than the one popped last and the longest link.
    Ways(const RigidLinks& rigid, std::pmr::memory_resource* memory) : buckets_(memory) {
        double longest = 0, sum = 0;
        for (const RigidLinks::End& link : rigid.at) longest = std::max(longest, link.rest), sum += link.rest;
        const double mean = sum / static_cast<double>(std::max<size_t>(1, rigid.at.size()));
        per_width_ = longest > 0 ? std::min(128 / mean, (most_buckets - 3) / longest) : 1;
        uint64_t needed = 4;
        while (static_cast<double>(needed) < longest * per_width_ + 3) needed *= 2;
        buckets_.resize(needed);
    }

    void push(const ReachWay& way) {
        const auto number = static_cast<uint64_t>(way.length * per_width_);
        Vector<ReachWay>& bucket = bucket_of(number);
        bucket.push_back(way);
        if (number == current_ && is_heap_) std::push_heap(bucket.begin(), bucket.end(), later);
        ++count_;
    }
    bool empty() const { return count_ == 0; }
    ReachWay pop() {
        while (bucket_of(current_).empty()) ++current_, is_heap_ = false;
        Vector<ReachWay>& bucket = bucket_of(current_);
        if (!is_heap_) std::make_heap(bucket.begin(), bucket.end(), later);
        is_heap_ = true;
        std::pop_heap(bucket.begin(), bucket.end(), later);
        const ReachWay way = bucket.back();
        bucket.pop_back();
        --count_;
        return way;
    }

private:
    static constexpr double most_buckets = 4096;

    static bool later(const ReachWay& a, const ReachWay& b) { return b < a; }
    Vector<ReachWay>& bucket_of(uint64_t number) { return buckets_[number & (buckets_.size() - 1)]; }

    double per_width_;
    Vector<Vector<ReachWay>> buckets_;  // a power of two; by turns, the one of a length, counted in widths
    uint64_t current_ = 0;
    bool is_heap_ = false;  // whether the current one is
    size_t count_ = 0;
};

/// The ways from one anchor.
class FromOne {
public:
    FromOne(size_t particles, std::pmr::memory_resource* memory) : shortest_(particles, infinity, memory) {}

    /// Whether a way is worth to be followed, as far as is known.
    bool improve(const ReachWay& way) {
        if (!(way.length < shortest_[way.particle])) return false;
        shortest_[way.particle] = way.length;
        return true;
    }
    /// Whether it is, when its turn has come.
    bool take(const ReachWay& way) { return way.length == shortest_[way.particle]; }

private:
    Vector<double> shortest_;
};

/// Those from any number of anchors; each particle keeps the first few that reach it.
class FromNearest {
public:
    FromNearest(size_t particles, std::pmr::memory_resource* memory)
        : reached_(particles, memory), nearest_(particles, memory) {}

    bool improve(const ReachWay& way) { return nearest_[way.particle].improve(way.length, way.anchor); }
    bool take(const ReachWay& way) {
        Reached& here = reached_[way.particle];
        if (here.count == most_anchors) return false;
        const uint32_t* end = here.anchors + here.count;
        if (std::find(static_cast<const uint32_t*>(here.anchors), end, way.anchor) != end) return false;
        here.anchors[here.count++] = way.anchor;
        return true;
    }

private:
    struct Reached {
        uint32_t count = 0;
        uint32_t anchors[most_anchors];
    };

    Vector<Reached> reached_;
    Vector<Nearest> nearest_;
};

/// Dijkstra from some anchors at once. In order.
template <class Known>
Vector<ReachWay> find_ways(const RigidLinks& rigid, const uint32_t* anchors, size_t count) {
    std::pmr::memory_resource* const memory = rigid.at.get_allocator().resource();
    const size_t particles = rigid.begin.size() - 1;
    Known known(particles, memory);
    Vector<ReachWay> found(memory);
    found.reserve(particles);
    Ways ways(rigid, memory);
    const auto offer = [&](const ReachWay& way) {
        if (known.improve(way)) ways.push(way);
    };
    for (size_t i = 0; i < count; ++i) offer({0, anchors[i], anchors[i]});
    while (!ways.empty()) {
        const ReachWay way = ways.pop();
        if (!known.take(way)) continue;
        found.push_back(way);
        for (uint32_t i = rigid.begin[way.particle]; i < rigid.begin[way.particle + 1]; ++i) {
            offer({way.length + rigid.at[i].rest, rigid.at[i].to, way.anchor});
        }
    }
    return found;
}

/// Bring the ways up to date with what is pinned. If there are and were a few anchors only, each reaches all, and the
/// ways from the others stay.
void update_ways(const Body& body, const RigidLinks& rigid, Vector<ReachWay>& ways) {
    const auto memory = ways.get_allocator();
    Vector<uint32_t> anchors(memory), added(memory);
    Vector<uint8_t> known(body.particles.size(), 0, memory);
    uint32_t before = 0;
    for (const ReachWay& way : ways) {
        if (way.particle == way.anchor) known[way.anchor] = 1, ++before;
    }
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (!body.particles.pinned(p) || rigid.begin[p] == rigid.begin[p + 1]) continue;
        anchors.push_back(p);
        if (!known[p]) added.push_back(p);
    }
    if (anchors.size() > most_anchors || before > most_anchors) {
        ways = find_ways<FromNearest>(rigid, anchors.data(), anchors.size());
        return;
    }
    Vector<ReachWay> all(memory);
    all.reserve(ways.size());
    std::copy_if(ways.begin(), ways.end(), std::back_inserter(all),
                 [&](const ReachWay& way) { return body.particles.pinned(way.anchor); });
    for (const uint32_t anchor : added) {
        const Vector<ReachWay> found = find_ways<FromOne>(rigid, &anchor, 1);
        Vector<ReachWay> merged(all.size() + found.size(), memory);
        std::merge(all.begin(), all.end(), found.begin(), found.end(), merged.begin());
        all.swap(merged);
    }
    ways.swap(all);
}

}  // namespace

void plan_reach_limits(Body& body) {
    Cloth& cloth = body.cloth;
    cloth.reach_limits.clear();
    update_ways(body, cloth.rigid, cloth.pin_ways);
    cloth.reach_limits.reserve(cloth.pin_ways.size());
    const bool flat = !cloth.rest_position.empty();
    for (const ReachWay& way : cloth.pin_ways) {
        if (body.particles.pinned(way.particle)) continue;
        const double straight =
            flat ? distance(cloth.rest_position[way.particle], cloth.rest_position[way.anchor]) : way.length;
        cloth.reach_limits.push_back({way.particle, way.anchor, std::min(straight, way.length) * (1 + slack)});
    }
}

}  // namespace gphys
