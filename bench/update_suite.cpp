// Scenes that change: models that move, that are added and removed one by one, what single calls take at worst, and
// rays at the trees that all this leaves.
#include "harness.h"

namespace bench {

namespace {

void demand_calls(const std::string& name, const CallTimes& times, size_t count) {
    if (times.count() != count) throw std::runtime_error(name + ": calls are missing");
}

/// Rays at what was added and changed a call at a time, against a fresh build of the same boxes.
void rays_beside_fresh(Bench& bench, const std::string& name, Entry used, const std::vector<gphys_obb>& content,
                       uint32_t ray_count) {
    const auto n = static_cast<uint32_t>(content.size());
    std::vector<Entry> entries;
    entries.push_back(std::move(used));
    entries.push_back({"gamephys_fresh", make_gamephys(1)});
    entries.back().implementation->load(content);
    const std::vector<gphys_ray> rays = rays_at(content, ray_count);
    entries.front().implementation->closest(rays);
    demand_variety(name, rays, entries.front().implementation->answers());
    const RaySample sample(rays, n, [&](const gphys_ray& r) { return reference(content, r); });
    bench.measure("update", name, n, entries, closest_hits(rays), closest_right(sample));
    report_memory(bench, "update", name, n, entries);
}

void report_calls(Bench& bench, const std::string& name, uint32_t n, const CallTimes& times) {
    const std::pair<const char*, double> quantiles[] = {{"_p50", 0.5}, {"_p99", 0.99}, {"_p99_9", 0.999}, {"_max", 1}};
    for (const auto& [suffix, part] : quantiles) {
        bench.add({"update", name + suffix, "gamephys", n, times.quantile(part), {}, "ns", 0, "unchecked"});
    }
}

/// Runs of the same calls, of each of which the fastest counts.
constexpr int runs_of_calls = 3;

/// Boxes added one by one in several orders: what the worst add takes, and rays at the tree that it leaves.
void one_by_one(Bench& bench, uint32_t n) {
    for (const Arrangement& arrangement : arrangements(n)) {
        const std::string name = "after_adds_" + arrangement.name, added = "add_" + arrangement.name;
        if (bench.wants(added, n)) {
            CallTimes adds;
            for (int run = 0; run < runs_of_calls; ++run) {
                make_gamephys(1, 1, false)->load_one_by_one(arrangement.boxes, adds);
            }
            demand_calls(added, adds, n);
            report_calls(bench, added, n, adds);
        }
        // Where all boxes are in one place, each ray meets all.
        const uint32_t ray_count = arrangement.name == "one_place" ? 50 : bench.ray_count(n) / 10;
        if (bench.wants(name, n)) {
            Entry used{"gamephys", make_gamephys(1)};
            CallTimes adds;
            used.implementation->load_one_by_one(arrangement.boxes, adds);
            rays_beside_fresh(bench, name, std::move(used), arrangement.boxes, ray_count);
        }
    }
}

/// Boxes that are removed, and added elsewhere, ten times each and a million times at least.
void churn(Bench& bench, uint32_t n) {
    if (!bench.wants("after_churn", n) && !bench.wants("churn", n)) return;
    const uint32_t count = bench.quick() ? 10 * n : std::max(10 * n, 1000000u);
    const std::vector<Jump> all = jumps(n, count, 31);
    std::vector<gphys_obb> content = boxes(n);
    CallTimes removes, adds;
    for (int run = 0; run < runs_of_calls; ++run) {
        Entry used{"gamephys", make_gamephys(1, 1, run + 1 == runs_of_calls)};
        used.implementation->load(content);
        used.implementation->replace_one_by_one(all, removes, adds);
        if (run + 1 < runs_of_calls) continue;
        for (const Jump& jump : all) content[jump.object] = jump.to;
        demand_calls("churn", removes, count);
        report_calls(bench, "churn_remove", n, removes);
        report_calls(bench, "churn_add", n, adds);
        rays_beside_fresh(bench, "after_churn", std::move(used), content, bench.ray_count(n));
    }
}

/// A thousand frames in which all boxes move a little, or one in a hundred jumps; and frames in which all boxes go
/// straight on, moved by a call each.
void moves(Bench& bench, uint32_t n) {
    if (bench.wants("after_moves", n)) {
        std::vector<gphys_obb> content = boxes(n);
        Entry used{"gamephys", make_gamephys(1)};
        used.implementation->load(content);
        for (uint64_t frame = 0; frame < 1000; ++frame) {
            jiggle(content, frame);
            used.implementation->move_all(content);
        }
        rays_beside_fresh(bench, "after_moves", std::move(used), content, bench.ray_count(n));
    }
    if (bench.wants("after_drift", n)) {
        std::vector<gphys_obb> content = boxes(n);
        Drift drift(n, half_side(n));
        Entry used{"gamephys", make_gamephys(1)};
        used.implementation->load(content);
        const uint32_t frames = bench.quick() ? 100 : std::clamp(30000000 / n, 30u, 600u);
        for (uint32_t frame = 0; frame < frames; ++frame) {
            drift.step(content);
            for (uint32_t i = 0; i < n; ++i) used.implementation->move_some(content, i, 1);
        }
        rays_beside_fresh(bench, "after_drift", std::move(used), content, bench.ray_count(n));
    }
    if (!bench.wants("after_jumps", n)) return;
    std::vector<gphys_obb> content = boxes(n);
    Entry used{"gamephys", make_gamephys(1)};
    used.implementation->load(content);
    for (uint64_t frame = 0; frame < 1000; ++frame) {
        for (const Jump& jump : jumps(n, n / 100, 1000 + frame)) {
            content[jump.object].center = jump.to.center;
            content[jump.object].rotation = jump.to.rotation;
            used.implementation->move_some(content, jump.object, 1);
        }
    }
    rays_beside_fresh(bench, "after_jumps", std::move(used), content, bench.ray_count(n));
}

/// How long single calls take in frames that mix them.
void latencies(Bench& bench, uint32_t n) {
    if (!bench.wants("latency", n)) return;
    constexpr uint32_t frame_count = 100, ray_count = 1000, ball_count = 100, move_count = 100;
    const float half = half_side(n);
    const std::vector<gphys_obb> content = boxes(n);
    const std::vector<gphys_ray> rays = random_rays(half, frame_count * ray_count);
    const std::vector<gphys_sphere> balls = query_spheres(half, frame_count * ball_count, 3);
    const std::vector<Jump> all = jumps(n, frame_count * move_count, 77);
    FrameTimes times;
    for (int run = 0; run < runs_of_calls; ++run) {
        const std::unique_ptr<Implementation> used = make_gamephys(1, 1, false);
        used->load(content);
        for (CallTimes* calls : {&times.rays, &times.overlaps, &times.moves, &times.culls}) calls->start_run();
        for (uint32_t f = 0; f < frame_count; ++f) {
            used->run_frame({{rays.begin() + f * ray_count, rays.begin() + (f + 1) * ray_count},
                             {balls.begin() + f * ball_count, balls.begin() + (f + 1) * ball_count},
                             {all.begin() + f * move_count, all.begin() + (f + 1) * move_count},
                             view(half)},
                            times);
        }
    }
    demand_calls("latency_ray", times.rays, rays.size());
    demand_calls("latency_move", times.moves, all.size());
    if (5 * times.hits < runs_of_calls * rays.size()) throw std::runtime_error("latency_ray: too few rays hit");
    if (times.overlapping < runs_of_calls * balls.size()) throw std::runtime_error("latency_overlap: too few meet");
    if (times.visible < uint64_t{runs_of_calls} * frame_count * n / 50) {
        throw std::runtime_error("latency_cull: too few boxes are visible");
    }
    report_calls(bench, "latency_ray", n, times.rays);
    report_calls(bench, "latency_overlap", n, times.overlaps);
    report_calls(bench, "latency_move", n, times.moves);
    report_calls(bench, "latency_cull", n, times.culls);
}

void update_of_many(Bench& bench) {
    const uint32_t n = bench.sizes().back() < 100000 ? 10000 : 100000;
    std::vector<gphys_obb> content = boxes(n);
    std::vector<std::vector<gphys_obb>> frames;
    for (uint64_t frame = 0; frame < 16; ++frame) {
        jiggle(content, frame);
        frames.push_back(content);
    }
    std::vector<Entry> entries = everybody(true);
    add_on_threads(entries);
    load(entries, boxes(n));
    size_t frame = 0;
    bench.measure(
        "update", "update_all", n, entries,
        [&](Implementation& i) { return i.move_all(frames[frame++ % frames.size()]) ? n : 0; }, unchecked);

    // A hundred frames of motion, then rays; beside them a fresh build of the same boxes.
    for (uint64_t f = 16; f < 116; ++f) {
        jiggle(content, f);
        for (Entry& entry : entries) {
            if (entry.implementation) entry.implementation->move_all(content);
        }
    }
    std::vector<Entry> fresh = everybody();
    load(fresh, content);
    for (Entry& entry : fresh) entries.push_back({entry.name + "_fresh", std::move(entry.implementation)});
    const std::vector<gphys_ray> rays = random_rays(half_side(n), bench.ray_count(n));
    const RaySample sample(rays, n, [&](const gphys_ray& r) { return reference(content, r); });
    bench.measure("update", "ray_after_update", n, entries, closest_hits(rays), closest_right(sample));

    const uint32_t some = n / 100;
    uint32_t first = 0;
    const auto next = [&] { return first = (first + some) % (n - some); };
    bench.measure(
        "update", "update_some", n, entries,
        [&](Implementation& i) { return i.move_some(content, next(), some) ? some : 0; }, unchecked);
    save_and_load(bench, "update", "scene", n, entries);
    bench.measure(
        "update", "replace_some", n, entries,
        [&](Implementation& i) { return i.remove_and_insert(content, next(), some) ? some : 0; }, unchecked);
}

}  // namespace

void update_suite(Bench& bench) {
    for (const uint32_t n : bench.sizes()) {
        if (n < 10000 || !bench.wants(n)) continue;
        one_by_one(bench, n);
        churn(bench, n);
        if (n <= 100000) {
            moves(bench, n);
            latencies(bench, n);
        }
    }
    update_of_many(bench);
}

}  // namespace bench
