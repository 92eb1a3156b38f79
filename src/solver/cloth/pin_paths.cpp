// The shortest paths from pins along rigid links (pin_paths.h), by Dijkstra's algorithm from all pins at once. The
// queue is an array of buckets by length (Dial 1969), in which heaps stay small, because lengths are real numbers.
//
// After edits of links, the lengths that depended on them are found as Ramalingam & Reps (1996) do: a particle keeps
// its length if a neighbour that keeps its own accounts for it; the others are searched again from those that keep
// theirs. The sums are those of a search of all, so the paths are the same, bit by bit.
#include "solver/cloth/pin_paths.h"

#include <iterator>

#include "solver/particles/particles.h"

namespace gphys {
namespace {

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
    // Links without length lead to paths that are pushed when later ones have been popped.
    if (!std::is_sorted(found.begin(), found.end())) std::sort(found.begin(), found.end());
    return found;
}

/// The paths from one pin, after links came or went.
class PathRepair {
public:
    /// `lengths`: by particle, of the paths before; becomes that of the paths now.
    PathRepair(const RigidLinks& rigid, uint32_t anchor, double* lengths)
        : rigid_(rigid), anchor_(anchor), length_(lengths), queue_(rigid.at.get_allocator()), lost_(queue_) {}

    void run(const RigidLinks::Edit* first, const RigidLinks::Edit* last) {
        find_lost(first, last);
        const auto offer_from = [&](uint32_t p) {
            each_link(p, [&](const RigidLinks::End& link) { offer(link.to, length_[p] + link.rest); });
        };
        for (const RigidLinks::Edit* edit = first; edit != last; ++edit) offer_from(edit->a), offer_from(edit->b);
        for (const PinPath& path : lost_) {
            each_link(path.particle,
                      [&](const RigidLinks::End& link) { offer(path.particle, length_[link.to] + link.rest); });
        }
        while (!queue_.empty()) {
            const PinPath path = pop();
            if (path.length == length_[path.particle]) offer_from(path.particle);
        }
    }

private:
    static bool later(const PinPath& a, const PinPath& b) { return b < a; }

    template <class Visit>
    void each_link(uint32_t p, Visit&& visit) const {
        for (uint32_t i = rigid_.begin[p]; i < rigid_.begin[p + 1]; ++i) visit(rigid_.at[i]);
    }
    void push(double length, uint32_t p) {
        queue_.push_back({length, p, anchor_});
        std::push_heap(queue_.begin(), queue_.end(), later);
    }
    PinPath pop() {
        std::pop_heap(queue_.begin(), queue_.end(), later);
        const PinPath path = queue_.back();
        queue_.pop_back();
        return path;
    }
    void offer(uint32_t p, double length) {
        if (!(length < length_[p])) return;
        length_[p] = length;
        push(length, p);
    }

    /// Forgets the lengths that no neighbour accounts for, the shortest first.
    void find_lost(const RigidLinks::Edit* first, const RigidLinks::Edit* last) {
        const auto suspect = [&](uint32_t p) {
            if (length_[p] < infinity) push(length_[p], p);
        };
        for (const RigidLinks::Edit* edit = first; edit != last; ++edit) suspect(edit->a), suspect(edit->b);
        while (!queue_.empty()) {
            const PinPath path = pop();
            if (path.length != length_[path.particle] || is_accounted_for(path.particle)) continue;
            length_[path.particle] = infinity;
            lost_.push_back(path);
            each_link(path.particle, [&](const RigidLinks::End& link) {
                if (length_[link.to] == path.length + link.rest) suspect(link.to);
            });
        }
    }
    /// By a neighbour that is nearer. One at the same length might in turn depend on this particle.
    bool is_accounted_for(uint32_t p) const {
        bool accounted = p == anchor_;
        each_link(p, [&](const RigidLinks::End& link) {
            accounted = accounted || (length_[link.to] < length_[p] && length_[link.to] + link.rest == length_[p]);
        });
        return accounted;
    }

    const RigidLinks& rigid_;
    uint32_t anchor_;
    double* length_;
    Vector<PinPath> queue_;  // a heap
    Vector<PinPath> lost_;   // as they were
};

}  // namespace

/// With at most `most_anchors` pins before and now, each pin reaches all particles, so the paths from the other pins
/// stay valid.
void update_pin_paths(Vector<PinPath>& paths, const RigidLinks& rigid, const Particles& particles) {
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

void repair_pin_paths(Vector<PinPath>& paths, const RigidLinks& rigid, const RigidLinks::Edit* first,
                      const RigidLinks::Edit* last) {
    const auto memory = paths.get_allocator();
    const size_t particles = rigid.begin.size() - 1;
    Vector<uint32_t> anchors(memory);
    Vector<uint8_t> number(particles, 0, memory);  // by anchor
    for (const PinPath& path : paths) {
        if (path.particle != path.anchor) continue;
        // More than these share the particles among them: a path that is lost may let another pin in.
        if (anchors.size() == most_anchors) return paths.clear();
        number[path.anchor] = static_cast<uint8_t>(anchors.size());
        anchors.push_back(path.anchor);
    }
    Vector<double> lengths(anchors.size() * particles, infinity, memory);
    const auto length_of = [&](const PinPath& path) -> double& {
        return lengths[number[path.anchor] * particles + path.particle];
    };
    for (const PinPath& path : paths) length_of(path) = path.length;
    Vector<double> before(lengths, memory);
    for (size_t i = 0; i < anchors.size(); ++i) PathRepair(rigid, anchors[i], &lengths[i * particles]).run(first, last);

    const auto alone = [&](uint32_t p) { return rigid.begin[p] == rigid.begin[p + 1]; };
    Vector<PinPath> kept(memory), changed(memory);
    kept.reserve(paths.size());
    for (const PinPath& path : paths) {
        if (length_of(path) == path.length && !alone(path.anchor)) kept.push_back(path);
    }
    for (size_t i = 0; i < lengths.size(); ++i) {
        const uint32_t anchor = anchors[i / particles];
        if (lengths[i] != before[i] && lengths[i] < infinity)
            changed.push_back({lengths[i], static_cast<uint32_t>(i % particles), anchor});
    }
    std::sort(changed.begin(), changed.end());
    paths.resize(kept.size() + changed.size());
    std::merge(kept.begin(), kept.end(), changed.begin(), changed.end(), paths.begin());
}

}  // namespace gphys
