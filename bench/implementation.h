// What a library must be able to do to take part. A function that returns false says that the
// library has no such operation; the case then has no row for it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "workload.h"

namespace bench {

constexpr uint32_t no_object = 0xffffffffu;

/// Answer of a ray: object or triangle index from 0, and the distance.
struct Answer {
    float t;
    uint32_t object;
};

/// Bytes that an implementation holds, everything counted, and the most that it has held.
class Heap {
public:
    void add(int64_t bytes) {
        now_ += bytes;
        peak_ = now_ > peak_ ? now_ : peak_;
    }
    void forget_peak() { peak_ = now_; }
    uint64_t now() const { return static_cast<uint64_t>(now_); }
    uint64_t peak() const { return static_cast<uint64_t>(peak_); }

private:
    int64_t now_ = 0, peak_ = 0;
};

/// Nanoseconds of each of a row of calls. The row is run several times, and of each call the fastest run counts:
/// what the machine did besides does not strike the same call twice.
class CallTimes {
public:
    void start_run() { next_ = 0; }
    void add(double ns) {
        if (next_ == times_.size()) times_.push_back(ns);
        times_[next_] = ns < times_[next_] ? ns : times_[next_];
        ++next_;
    }
    template <class Call>
    void time(const Call& call) {
        const auto start = std::chrono::steady_clock::now();
        call();
        add(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
    }
    size_t count() const { return times_.size(); }
    /// The time that a part of all calls does not exceed.
    double quantile(double part) const {
        std::vector<double> sorted = times_;
        std::sort(sorted.begin(), sorted.end());
        const auto place = static_cast<size_t>(std::ceil(part * static_cast<double>(sorted.size())));
        return sorted.at(place == 0 ? 0 : place - 1);
    }

private:
    std::vector<double> times_;
    size_t next_ = 0;
};

/// What a frame of a game asks, a call for each, and how long the calls take.
struct Frame {
    std::vector<gphys_ray> rays;
    std::vector<gphys_sphere> balls;
    std::vector<Jump> moves;
    gphys_frustum frustum;
};
struct FrameTimes {
    CallTimes rays, overlaps, moves, culls;
    uint64_t hits = 0, overlapping = 0, visible = 0;  // of all runs
};

class Implementation {
public:
    virtual ~Implementation() = default;

    // Content; each call replaces what was there.
    virtual bool load(const std::vector<gphys_obb>&) { return false; }
    virtual bool load(const std::vector<gphys_sphere>&) { return false; }
    virtual bool load(const std::vector<gphys_vec3>&) { return false; }
    virtual bool load(const Triangles&) { return false; }
    virtual bool load(const Triangles&, const std::vector<gphys_transform>&) { return false; }
    virtual bool load(const Triangles&, const std::vector<Stretched>&) { return false; }
    /// Triangles that will move, and where their vertices go.
    /// A convex hull, as the solid that the library has for it.
    virtual bool load_hull(const Triangles&, const std::vector<gphys_transform>&) { return false; }
    virtual bool load_deformable(const Triangles&) { return false; }
    virtual bool deform(const std::vector<gphys_vec3>&) { return false; }
    /// A body of a solver as a model that follows it.
    virtual bool load_body(gphys_solver*, gphys_body_id) { return false; }
    /// Takes rays in packets, of which only those of a camera have any use.
    virtual bool wants_packets() const { return false; }
    /// So slow that a part of the rays must do.
    virtual bool is_slow() const { return false; }

    /// Bytes of the heap that the content takes, all that belongs to it included, and the most while it was
    /// loaded; 0 if unknown.
    virtual uint64_t memory() const { return 0; }
    virtual uint64_t peak_memory() const { return 0; }

    virtual bool closest(const std::vector<gphys_ray>&) { return false; }
    /// How far, and to what, without the rest of a hit.
    virtual bool distances(const std::vector<gphys_ray>&) { return false; }
    /// As closest, a call for each ray.
    virtual bool closest_singly(const std::vector<gphys_ray>&) { return false; }
    virtual bool any_singly(const std::vector<gphys_ray>&, std::vector<int32_t>&) { return false; }
    virtual bool nearest(const std::vector<gphys_vec3>&) { return false; }
    virtual bool nearest_singly(const std::vector<gphys_vec3>&) { return false; }
    /// t is a part of the way.
    virtual bool segments(const std::vector<gphys_segment>&) { return false; }
    virtual bool sweeps(const std::vector<Sweep>&) { return false; }
    virtual bool sweeps(const std::vector<CapsuleSweep>&) { return false; }
    virtual bool sweeps(const std::vector<BoxSweep>&) { return false; }
    /// As closest and closest_singly, without one object.
    virtual bool closest_without(const std::vector<gphys_ray>&, uint32_t /*object*/, bool /*singly*/) { return false; }
    /// What it found; to put that into a form that all have in common is no part of the work.
    virtual std::vector<Answer> answers() const { return answers_; }
    virtual bool any(const std::vector<gphys_ray>&, std::vector<int32_t>&) { return false; }
    /// Total number of overlapping boxes over all queries.
    virtual bool overlap(const std::vector<gphys_sphere>&, uint64_t& /*total*/) { return false; }
    virtual bool overlap(const std::vector<gphys_aabb>&, uint64_t& /*total*/) { return false; }
    /// Number of boxes whose bounds touch the frustum.
    virtual bool cull(const gphys_frustum&, uint64_t& /*total*/) { return false; }

    /// Boxes move to new places; the structure is ready for queries afterwards.
    virtual bool move_all(const std::vector<gphys_obb>&) { return false; }
    /// Boxes first .. first + count - 1 move to their places in the list.
    virtual bool move_some(const std::vector<gphys_obb>&, uint32_t /*first*/, uint32_t /*count*/) { return false; }
    /// Copies the content out, with its tree, so that load_saved can bring it back; the bytes of the copy, or 0.
    virtual uint64_t save() { return 0; }
    virtual bool load_saved() { return false; }
    virtual bool remove_and_insert(const std::vector<gphys_obb>&, uint32_t /*first*/, uint32_t /*count*/) {
        return false;
    }

    // A call for each object.

    /// As load, into an empty scene.
    virtual bool load_one_by_one(const std::vector<gphys_obb>&, CallTimes& /*adds*/) { return false; }
    /// Boxes are removed, and added again where they go.
    virtual bool replace_one_by_one(const std::vector<Jump>&, CallTimes& /*removes*/, CallTimes& /*adds*/) {
        return false;
    }
    virtual bool run_frame(const Frame&, FrameTimes&) { return false; }

protected:
    std::vector<Answer> answers_;
};

/// `worker_count` of the scene, and threads that call, each with a part of the queries. Its memory is counted, or else
/// it has no allocator but its own.
std::unique_ptr<Implementation> make_gamephys(uint32_t worker_count, uint32_t callers = 1, bool counted = true);
/// The library's own trees with float tests in place of its exact ones: for the accuracy suite.
std::unique_ptr<Implementation> make_gamephys_float();
/// A sweep over all boxes with SIMD, the baseline for culling: over all, or over blocks of 64 that are near each
/// other, with a box around each that is tested first.
std::unique_ptr<Implementation> make_simd_sweep(bool in_blocks);
#ifdef GAMEPHYS_BENCH_PEERS
/// Packets are of sixteen coherent rays.
enum class EmbreeMode { plain, robust, refit, packets, packets_robust };
std::unique_ptr<Implementation> make_embree(EmbreeMode mode);
std::unique_ptr<Implementation> make_bullet();
std::unique_ptr<Implementation> make_fcl();
/// Knows nearest points only, by a k-d tree.
std::unique_ptr<Implementation> make_nanoflann();
#endif

/// The true answer of one ray by a loop over everything in double precision.
Answer reference(const std::vector<gphys_obb>&, const gphys_ray&);
Answer reference(const std::vector<gphys_sphere>&, const gphys_ray&);
Answer reference(const Triangles&, const gphys_ray&);
Answer reference(const Triangles&, const std::vector<gphys_transform>&, const gphys_ray&);
Answer reference(const Triangles&, const std::vector<Stretched>&, const gphys_ray&);
/// Of a point: the nearest and its distance.
Answer reference(const std::vector<gphys_obb>&, const gphys_vec3&);
Answer reference(const std::vector<gphys_vec3>&, const gphys_vec3&);
Answer reference(const Triangles&, const gphys_vec3&);
Answer reference(const std::vector<gphys_obb>&, const gphys_segment&);
Answer reference(const std::vector<gphys_obb>&, const Sweep&);

}  // namespace bench
