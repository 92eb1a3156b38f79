// gamephys_bench SUITE... [--quick] [--out=DIR] [--case=NAME] [--objects=N]: times each case for each
// implementation with Google Benchmark in interleaved repetitions, keeps the fastest, compares the
// answers with a double-precision loop, and writes DIR/<suite>.csv. NAME and N leave out all others.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>

#include "hard_cases.h"
#include "implementation.h"

namespace bench {

namespace {

struct Options {
    bool quick = false;
    std::string directory = ".";
    std::string only;      // case
    uint32_t objects = 0;  // if not 0, only so many

    bool wants(uint32_t n) const { return objects == 0 || n == objects; }
    bool wants(const std::string& name, uint32_t n) const { return (only.empty() || name == only) && wants(n); }
};

struct Row {
    std::string suite, name, implementation;
    uint32_t n;
    double value;
    double median;  // of the repetitions, whose fastest is value; 0: measured once
    std::string unit;
    double error;
    std::string error_unit;
};

/// Keeps the fastest repetition of each benchmark: the one that noise disturbed least.
class Fastest final : public benchmark::BenchmarkReporter {
public:
    std::map<std::string, double> seconds;
    std::map<std::string, std::vector<double>> all;

    double median(const std::string& name) {
        std::vector<double>& times = all[name];
        if (times.empty()) return 0;
        std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
        return times[times.size() / 2];
    }

    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
            const bool shared = !run.run_name.time_type.empty();  // "real_time", where that was asked for
            const double time =
                (shared ? run.real_accumulated_time : run.cpu_accumulated_time) / static_cast<double>(run.iterations);
            const auto found = seconds.try_emplace(run.run_name.function_name, time).first;
            found->second = std::min(found->second, time);
            all[run.run_name.function_name].push_back(time);
        }
    }
};

struct Entry {
    std::string name;
    std::unique_ptr<Implementation> implementation;
    /// Timed by the clock on the wall, not by what the calling thread takes of a processor.
    bool several_threads = false;
};

Entry on_two_threads() { return {"gamephys_2_threads", make_gamephys(2), true}; }
/// Two callers that have nothing to do with one another, with half of the queries each: what the machine allows.
Entry two_apart() { return {"gamephys_2_apart", make_gamephys(1, 2), true}; }

std::vector<Entry> everybody([[maybe_unused]] bool moving = false) {
    std::vector<Entry> all;
    all.push_back({"gamephys", make_gamephys(1)});
#ifdef GAMEPHYS_BENCH_PEERS
    all.push_back({"embree", make_embree(moving ? EmbreeMode::refit : EmbreeMode::plain)});
    all.push_back({"embree_robust", make_embree(EmbreeMode::robust)});
    all.push_back({"bullet", make_bullet()});
    all.push_back({"fcl", make_fcl()});
    all.push_back({"nanoflann", make_nanoflann()});
#endif
    return all;
}

/// Returns how many operations it did; 0 if the implementation has no such operation.
using Task = std::function<double(Implementation&)>;
/// How far the answers of an implementation are off, and in which unit.
using Check = std::function<std::pair<double, std::string>(Implementation&)>;

class Bench {
public:
    explicit Bench(const Options& options) : options_(options) {}

    bool quick() const { return options_.quick; }
    uint32_t ray_count(uint32_t n) const { return options_.quick ? 50000 : n >= 1000000 ? 500000 : 1000000; }
    uint32_t camera_width() const { return options_.quick ? 256 : 1024; }
    std::vector<gphys_ray> camera_rays(float half_side) const {
        return bench::camera_rays(half_side, camera_width(), camera_width() * 3 / 4);
    }
    bool wants(uint32_t n) const { return options_.wants(n); }
    bool wants(const std::string& name, uint32_t n) const { return options_.wants(name, n); }
    std::vector<uint32_t> sizes() const {
        return options_.quick ? std::vector<uint32_t>{1000, 10000}
                              : std::vector<uint32_t>{1000, 10000, 100000, 1000000};
    }

    /// Time one task on all implementations that know it, interleaved: often where it is short, as clocks change
    /// for seconds at a time. What takes seconds is timed once: noise is small beside it.
    void measure(const std::string& suite, const std::string& name, uint32_t n, std::vector<Entry>& entries,
                 const Task& task, const Check& check) {
        if (!options_.wants(name, n)) {
            // What the others ask has to be there.
            const bool builds = name.rfind("build_", 0) == 0;
            for (Entry& entry : entries) {
                if (builds && entry.implementation) task(*entry.implementation);
            }
            return;
        }
        Fastest fastest;
        std::vector<std::pair<Entry*, double>> taking_part;  // and the operations of a task
        for (Entry& entry : entries) {
            if (!entry.implementation) continue;
            const auto start = std::chrono::steady_clock::now();
            const std::clock_t start_of_processor = std::clock();
            const double operations = task(*entry.implementation);
            const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            const double worked = static_cast<double>(std::clock() - start_of_processor) / CLOCKS_PER_SEC;
            const double seconds = entry.several_threads ? passed : worked;
            if (operations == 0) continue;
            taking_part.emplace_back(&entry, operations);
            if (seconds > 5) {
                fastest.seconds[entry.name] = seconds;
                continue;
            }
            benchmark::internal::Benchmark* registered = benchmark::RegisterBenchmark(
                entry.name.c_str(), [implementation = entry.implementation.get(), &task](benchmark::State& state) {
                    for (auto _ : state) task(*implementation);
                });
            registered->Repetitions(seconds < 0.2 ? 15 : 5);
            if (entry.several_threads) registered->UseRealTime();
        }
        benchmark::RunSpecifiedBenchmarks(&fastest, ".*");
        benchmark::ClearRegisteredBenchmarks();
        for (const auto& [entry, operations] : taking_part) {
            const auto [error, error_unit] = check(*entry->implementation);
            const double scale = 1e9 / operations;
            add({suite, name, entry->name, n, fastest.seconds.at(entry->name) * scale,
                 fastest.median(entry->name) * scale, "ns", error, error_unit});
        }
    }

    void add(Row row) {
        std::printf("%-8s %-20s %-18s %9u %12.2f %-4s  error %.3g %s\n", row.suite.c_str(), row.name.c_str(),
                    row.implementation.c_str(), row.n, row.value, row.unit.c_str(), row.error, row.error_unit.c_str());
        std::fflush(stdout);
        rows_.push_back(std::move(row));
    }

    void write() const {
        std::map<std::string, std::FILE*> files;
        for (const Row& row : rows_) {
            std::FILE*& file = files[row.suite];
            if (!file) {
                file = std::fopen((options_.directory + "/" + row.suite + ".csv").c_str(), "w");
                if (!file) throw std::runtime_error("cannot write into " + options_.directory);
                std::fputs("suite,case,implementation,n,value,unit,error,error_unit,median\n", file);
            }
            std::fprintf(file, "%s,%s,%s,%u,%.4g,%s,%.3g,%s,%.4g\n", row.suite.c_str(), row.name.c_str(),
                         row.implementation.c_str(), row.n, row.value, row.unit.c_str(), row.error,
                         row.error_unit.c_str(), row.median);
        }
        for (const auto& file : files) std::fclose(file.second);
    }

private:
    Options options_;
    std::vector<Row> rows_;
};

/// Some of the queries with their true answers: as many as a second or two allows.
template <class Query>
struct Sample {
    template <class Reference>
    Sample(const std::vector<Query>& all, double tests_per_ray, Reference reference) {
        const auto affordable = static_cast<size_t>(std::clamp(2e8 / tests_per_ray, 20.0, 2000.0));
        const size_t count = std::min(all.size(), affordable);
        for (size_t i = 0; i < count; ++i) {
            queries.push_back(all[i * all.size() / count]);
            truth.push_back(reference(queries.back()));
        }
    }

    std::pair<double, std::string> wrong_fraction(size_t wrong) const {
        return {static_cast<double>(wrong) / static_cast<double>(queries.size()), "WRONG_FRACTION"};
    }

    std::vector<Query> queries;
    std::vector<Answer> truth;
};
using RaySample = Sample<gphys_ray>;

/// Distances may differ by float rounding; a hit of something else, or a miss, is wrong.
template <class Query>
Check answers_right(const Sample<Query>& sample, bool (Implementation::*ask)(const std::vector<Query>&)) {
    return [&sample, ask](Implementation& implementation) -> std::pair<double, std::string> {
        (implementation.*ask)(sample.queries);
        const std::vector<Answer> answers = implementation.answers();
        double worst = 0;
        size_t wrong = 0;
        for (size_t i = 0; i < answers.size(); ++i) {
            const Answer& truth = sample.truth[i];
            if (answers[i].object == no_object || truth.object == no_object) {
                wrong += answers[i].object != truth.object;
                continue;
            }
            const double difference = std::fabs(double(answers[i].t) - truth.t);
            const double error = difference == 0 ? 0 : difference / truth.t;  // 0 inside of something
            if (error > 1e-4) {
                ++wrong;
            } else {
                worst = std::max(worst, error);
            }
        }
        if (wrong) return sample.wrong_fraction(wrong);
        return {worst, "relative"};
    };
}
Check closest_right(const RaySample& sample, bool singly = false) {
    return answers_right(sample, singly ? &Implementation::closest_singly : &Implementation::closest);
}

Check any_right(const RaySample& sample, bool singly = false) {
    return [&sample, singly](Implementation& implementation) -> std::pair<double, std::string> {
        std::vector<int32_t> answers;
        singly ? implementation.any_singly(sample.queries, answers) : implementation.any(sample.queries, answers);
        size_t wrong = 0;
        for (size_t i = 0; i < answers.size(); ++i) wrong += (answers[i] != 0) != (sample.truth[i].object != no_object);
        if (wrong) return sample.wrong_fraction(wrong);
        return {0, "relative"};
    };
}

std::pair<double, std::string> unchecked(Implementation&) { return {0, "unchecked"}; }

/// A part of the rays in which neighbours are still together: 8 by 8 rays of a camera are a tile.
/// 61 is prime, so that the tiles come from all columns of the picture.
std::vector<gphys_ray> every_61st_tile(const std::vector<gphys_ray>& rays) {
    std::vector<gphys_ray> some;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (i / 64 % 61 == 0) some.push_back(rays[i]);
    }
    return some;
}

/// The rays of a camera as its picture is stored.
std::vector<gphys_ray> row_by_row(const std::vector<gphys_ray>& tiles, size_t width) {
    std::vector<gphys_ray> rows(tiles.size());
    const size_t in_row = width / 8;
    for (size_t i = 0; i < tiles.size(); ++i) {
        const size_t tile = i / 64, x = tile % in_row * 8 + i % 8, y = tile / in_row * 8 + i / 8 % 8;
        rows[y * width + x] = tiles[i];
    }
    return rows;
}

/// Closest hits of all rays, or of a part where all would take minutes.
Task closest_hits(const std::vector<gphys_ray>& rays) {
    return [&rays, some = every_61st_tile(rays)](Implementation& i) -> double {
        const std::vector<gphys_ray>& its_rays = i.is_slow() ? some : rays;
        return i.closest(its_rays) ? static_cast<double>(its_rays.size()) : 0;
    };
}

/// Distances only.
Task distances(const std::vector<gphys_ray>& rays) {
    return [&rays](Implementation& i) { return i.distances(rays) ? static_cast<double>(rays.size()) : 0; };
}

/// Closest hits, a call for each ray.
Task closest_hits_singly(const std::vector<gphys_ray>& rays) {
    return [&rays, some = every_61st_tile(rays)](Implementation& i) -> double {
        const std::vector<gphys_ray>& its_rays = i.is_slow() ? some : rays;
        return i.closest_singly(its_rays) ? static_cast<double>(its_rays.size()) : 0;
    };
}

/// The same rays, pointing away: they miss the bounds of everything.
std::vector<gphys_ray> turned_away(std::vector<gphys_ray> rays) {
    for (gphys_ray& ray : rays) {
        const gphys_vec3 d = ray.direction;
        ray.direction = {-d.x, -d.y, -d.z};
    }
    return rays;
}

void ray_cases(Bench& bench, const std::string& suite, const std::string& prefix, uint32_t n, float half,
               std::vector<Entry>& entries, double tests_per_ray, const std::function<Answer(const gphys_ray&)>& truth,
               bool with_any_batch) {
    const std::vector<gphys_ray> random = random_rays(half, bench.ray_count(n)), away = turned_away(random);
    const RaySample random_sample(random, tests_per_ray, truth), away_sample(away, tests_per_ray, truth);
    const auto without_packets = [](const Task& task) -> Task {
        return [task](Implementation& i) { return i.wants_packets() ? 0 : task(i); };
    };
    bench.measure(suite, prefix + "_ray_random", n, entries, without_packets(closest_hits(random)),
                  closest_right(random_sample));
    bench.measure(suite, prefix + "_distance_random", n, entries, distances(random),
                  answers_right(random_sample, &Implementation::distances));
    bench.measure(suite, prefix + "_single_random", n, entries, closest_hits_singly(random),
                  closest_right(random_sample, true));
    bench.measure(suite, prefix + "_single_miss", n, entries, closest_hits_singly(away),
                  closest_right(away_sample, true));
    const std::vector<gphys_ray> camera = bench.camera_rays(half);
    const RaySample camera_sample(camera, tests_per_ray, truth);
    bench.measure(suite, prefix + "_ray_camera", n, entries, closest_hits(camera), closest_right(camera_sample));
    bench.measure(suite, prefix + "_distance_camera", n, entries, distances(camera),
                  answers_right(camera_sample, &Implementation::distances));
    const std::vector<gphys_ray> rows = row_by_row(camera, bench.camera_width());
    bench.measure(suite, prefix + "_ray_rows", n, entries, closest_hits(rows), closest_right(camera_sample));
    bench.measure(suite, prefix + "_single_rows", n, entries, closest_hits_singly(rows),
                  closest_right(camera_sample, true));
    std::vector<int32_t> hits;
    const auto count = static_cast<double>(random.size());
    if (with_any_batch) {
        bench.measure(suite, prefix + "_ray_any", n, entries,
                      without_packets([&](Implementation& i) { return i.any(random, hits) ? count : 0; }),
                      any_right(random_sample));
    }
    bench.measure(
        suite, prefix + "_single_any", n, entries,
        [&](Implementation& i) { return i.any_singly(random, hits) ? count : 0; }, any_right(random_sample, true));
}

template <class... Content>
void load(std::vector<Entry>& entries, const Content&... content) {
    for (Entry& entry : entries) {
        if (!entry.implementation->load(content...)) entry.implementation.reset();
    }
}

/// Embree's packets: the same structure as without them, so that only rays are of interest.
template <class Content>
void add_packets([[maybe_unused]] std::vector<Entry>& entries, [[maybe_unused]] const Content& content) {
#ifdef GAMEPHYS_BENCH_PEERS
    entries.push_back({"embree_packets", make_embree(EmbreeMode::packets)});
    entries.back().implementation->load(content);
    entries.push_back({"embree_packets_robust", make_embree(EmbreeMode::packets_robust)});
    entries.back().implementation->load(content);
#endif
}

void report_memory(Bench& bench, const std::string& suite, const std::string& name, uint32_t n,
                   std::vector<Entry>& entries) {
    for (Entry& entry : entries) {
        if (!entry.implementation || entry.several_threads || entry.implementation->memory() == 0) continue;
        const auto add = [&](const std::string& what, uint64_t bytes) {
            bench.add({suite, what + name, entry.name, n, static_cast<double>(bytes) / n, 0, "B", 0, "exact"});
        };
        add("memory_", entry.implementation->memory());
        add("memory_peak_", entry.implementation->peak_memory());
    }
}

void scene_suite(Bench& bench) {
    for (const uint32_t n : bench.sizes()) {
        if (!bench.wants(n)) continue;
        const float half = half_side(n);
        const std::vector<gphys_obb> content = boxes(n);
        std::vector<Entry> entries = everybody();
        entries.push_back(on_two_threads());
        bench.measure(
            "scene", "build_scene", n, entries, [&](Implementation& i) { return i.load(content) ? n : 0; }, unchecked);
        report_memory(bench, "scene", "scene", n, entries);
        add_packets(entries, content);
        entries.push_back(two_apart());
        entries.back().implementation->load(content);
        ray_cases(
            bench, "scene", "scene", n, half, entries, n, [&](const gphys_ray& r) { return reference(content, r); },
            true);
    }
    const uint32_t n = bench.sizes().back() < 100000 ? 10000 : 100000;
    {
        const std::vector<gphys_sphere> content = spheres(n);
        std::vector<Entry> entries = everybody();
        load(entries, content);
        ray_cases(
            bench, "scene", "sphere", n, half_side(n), entries, n,
            [&](const gphys_ray& r) { return reference(content, r); }, false);
    }
    {
        const Triangles mesh = bumpy_sphere(3);
        const std::vector<gphys_transform> content = placements(n);
        std::vector<Entry> entries = everybody();
        load(entries, mesh, content);
        ray_cases(
            bench, "scene", "instance", n, half_side(n), entries, n * 20.0,
            [&](const gphys_ray& r) { return reference(mesh, content, r); }, false);
    }
}

/// Meshes that move: a limb that bends, cloth in the wind. What a new form costs against building, and rays after a
/// thousand of them against rays at a mesh that was built of the last.
void moving_meshes(Bench& bench) {
    struct Motion {
        std::string name;
        Triangles rest;
        std::vector<gphys_vec3> (*at)(const Triangles&, double phase);
    };
    const bool quick = bench.sizes().back() < 100000;
    for (const Motion& motion : {Motion{"skin", tube(quick ? 51 : 251, quick ? 100 : 200), bent},
                                 Motion{"cloth", sheet(quick ? 72 : 225), waving}}) {
        const uint32_t n = motion.rest.count();
        if (!bench.wants(n)) continue;
        std::vector<std::vector<gphys_vec3>> frames;
        for (int frame = 0; frame < 50; ++frame) frames.push_back(motion.at(motion.rest, 0.1257 * frame));
        std::vector<Entry> entries = everybody(true);
        bench.measure(
            "mesh", "build_" + motion.name, n, entries,
            [&](Implementation& i) { return i.load_deformable(motion.rest) ? n : 0; }, unchecked);
        size_t next = 0;
        bench.measure(
            "mesh", "refit_" + motion.name, n, entries,
            [&](Implementation& i) { return i.deform(frames[next++ % frames.size()]) ? n : 0; }, unchecked);
        for (Entry& entry : entries) {
            for (int frame = 0; entry.implementation && frame < 1000; ++frame) {
                if (!entry.implementation->deform(frames[static_cast<size_t>(frame + 17) % frames.size()])) break;
            }
        }
        Triangles last = motion.rest;
        last.vertices = frames[(999 + 17) % frames.size()];
        std::vector<Entry> fresh = everybody();
        load(fresh, last);
        for (Entry& entry : fresh) entries.push_back({entry.name + "_fresh", std::move(entry.implementation)});
        const std::vector<gphys_ray> rays = random_rays(1.1f, bench.ray_count(n));
        const RaySample sample(rays, n, [&](const gphys_ray& r) { return reference(last, r); });
        bench.measure("mesh", "ray_at_moved_" + motion.name, n, entries, closest_hits(rays), closest_right(sample));
    }
}

/// A copy with the tree, and back: beside a build, what it saves. Operations are of an item; `_bytes` of one byte.
void save_and_load(Bench& bench, const std::string& suite, const std::string& what, uint32_t n,
                   std::vector<Entry>& entries) {
    bench.measure(
        suite, "save_" + what, n, entries, [&](Implementation& i) { return i.save() > 0 ? n : 0; }, unchecked);
    bench.measure(
        suite, "save_" + what + "_bytes", n, entries, [](Implementation& i) { return static_cast<double>(i.save()); },
        unchecked);
    bench.measure(
        suite, "load_" + what, n, entries, [&](Implementation& i) { return i.load_saved() ? n : 0; }, unchecked);
}

void mesh_suite(Bench& bench) {
    for (const int level : bench.sizes().size() > 2 ? std::vector<int>{6, 8} : std::vector<int>{5}) {
        const Triangles mesh = bumpy_sphere(level);
        if (!bench.wants(mesh.count())) continue;
        std::vector<Entry> entries = everybody();
        bench.measure(
            "mesh", "build_mesh", mesh.count(), entries,
            [&](Implementation& i) { return i.load(mesh) ? mesh.count() : 0; }, unchecked);
        report_memory(bench, "mesh", "mesh", mesh.count(), entries);
        save_and_load(bench, "mesh", "mesh", mesh.count(), entries);
        add_packets(entries, mesh);
        const auto truth = [&](const gphys_ray& r) { return reference(mesh, r); };
        ray_cases(bench, "mesh", "mesh", mesh.count(), 1.1f, entries, mesh.count(), truth, true);
        // The mesh as the one model of a scene; others, who need no model for that, have it as it is.
        const std::vector<gphys_transform> one{{{0, 0, 0}, {0, 0, 0, 1}, 1}};
        entries.front().implementation->load(mesh, one);
        ray_cases(bench, "mesh", "mesh_model", mesh.count(), 1.1f, entries, mesh.count(), truth, true);
    }
    moving_meshes(bench);
}

/// All implementations must count the same; the first is taken as right. Of 100000 pairs one may be
/// so close to touching that float arithmetic decides it either way.
Check same_count(const uint64_t& expected, const std::function<bool(Implementation&, uint64_t&)>& count) {
    return [&expected, count](Implementation& implementation) -> std::pair<double, std::string> {
        uint64_t total = 0;
        count(implementation, total);
        const double difference =
            std::fabs(static_cast<double>(total) - static_cast<double>(expected)) / static_cast<double>(expected);
        return {difference, difference <= 1e-5 ? "relative" : "DIFFERS"};
    };
}

/// A benchmark of queries that nothing answers, or that ask the same again and again, measures nothing.
template <class Query>
void demand_variety(const std::string& name, const std::vector<Query>& queries, const std::vector<Answer>& answers) {
    size_t hits = 0, repeated = 0;
    std::set<std::vector<unsigned char>> seen;
    for (const Query& query : queries) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(&query);
        repeated += !seen.emplace(bytes, bytes + sizeof query).second;
    }
    for (const Answer& answer : answers) hits += answer.object != no_object;
    if (repeated > queries.size() / 1000) throw std::runtime_error(name + ": queries are repeated");
    if (answers.size() != queries.size() || 5 * hits < queries.size()) {
        throw std::runtime_error(name + ": too few queries find something");
    }
}

/// Queries with one answer each, against the loop in double precision.
template <class Query, class Content>
void answer_case(Bench& bench, const std::string& name, std::vector<Entry>& entries, const Content& content,
                 const std::vector<Query>& queries, bool (Implementation::*ask)(const std::vector<Query>&)) {
    const auto n = static_cast<uint32_t>(content.size());
    if (!bench.wants(name, n)) return;
    const Sample<Query> sample(queries, n, [&](const Query& query) { return reference(content, query); });
    Implementation& first = *entries.front().implementation;
    (first.*ask)(queries);
    demand_variety(name, queries, first.answers());
    std::vector<Query> part;  // where all would take minutes
    for (size_t i = 0; i < queries.size(); i += 50) part.push_back(queries[i]);
    const auto task = [&](Implementation& i) -> double {
        const std::vector<Query>& its_queries = i.is_slow() ? part : queries;
        return (i.*ask)(its_queries) ? static_cast<double>(its_queries.size()) : 0;
    };
    bench.measure("query", name, n, entries, task, answers_right(sample, ask));
}

void query_suite(Bench& bench) {
    for (const uint32_t n : bench.sizes()) {
        if (n < 10000 || !bench.wants(n)) continue;
        const std::vector<gphys_obb> content = boxes(n);
        const float half = half_side(n);
        std::vector<Entry> entries = everybody();
        entries.push_back(on_two_threads());
        entries.push_back(two_apart());
        load(entries, content);
        uint64_t expected = 0, total = 0;
        const auto run = [&](const std::string& name, double operations,
                             const std::function<bool(Implementation&, uint64_t&)>& count) {
            count(*entries.front().implementation, expected);
            bench.measure(
                "query", name, n, entries, [&](Implementation& i) { return count(i, total) ? operations : 0; },
                same_count(expected, count));
        };
        const std::vector<gphys_sphere> balls = query_spheres(half, 10000, 5);
        run("overlap_sphere", static_cast<double>(balls.size()),
            [&](Implementation& i, uint64_t& sum) { return i.overlap(balls, sum); });
        const std::vector<gphys_aabb> blocks = query_boxes(half, 10000, 5);
        run("overlap_box", static_cast<double>(blocks.size()),
            [&](Implementation& i, uint64_t& sum) { return i.overlap(blocks, sum); });
        answer_case(bench, "nearest_box", entries, content, query_points(half, 100000), &Implementation::nearest);
        answer_case(bench, "segment", entries, content, query_segments(half, 100000, 10), &Implementation::segments);
        answer_case(bench, "sweep_sphere", entries, content, query_sweeps(half, 100000, 0.1f, 10),
                    &Implementation::sweeps);
        const gphys_frustum frustum = view(half);
        for (const bool in_blocks : {false, true}) {
            entries.push_back({in_blocks ? "simd_blocks" : "simd_sweep", make_simd_sweep(in_blocks)});
            entries.back().implementation->load(content);
        }
        run("cull", n, [&](Implementation& i, uint64_t& sum) { return i.cull(frustum, sum); });
        std::vector<gphys_vec3> points;
        for (const gphys_obb& box : content) points.push_back(box.center);
        std::vector<Entry> of_points = everybody();
        load(of_points, points);
        answer_case(bench, "nearest_point", of_points, points, query_points(half, 100000), &Implementation::nearest);
    }
}

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
        bench.add({"update", name + suffix, "gamephys", n, times.quantile(part), 0, "ns", 0, "unchecked"});
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

/// A thousand frames in which all boxes move a little, or one in a hundred jumps.
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
    entries.push_back(on_two_threads());
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

/// Which share of the answers is false.
Check false_answers(const HardRays& work) {
    return [&work](Implementation& implementation) -> std::pair<double, std::string> {
        implementation.closest(work.rays);
        const std::vector<Answer> answers = implementation.answers();
        size_t wrong = 0;
        for (size_t i = 0; i < answers.size(); ++i) wrong += (answers[i].object != no_object) != work.hits[i];
        return {static_cast<double>(wrong) / static_cast<double>(answers.size()), "FALSE_FRACTION"};
    };
}

/// The same where the truth is that of a loop in double precision, for some of the rays.
Check false_answers(const RaySample& sample) {
    return [&sample](Implementation& implementation) -> std::pair<double, std::string> {
        implementation.closest(sample.queries);
        const std::vector<Answer> answers = implementation.answers();
        size_t wrong = 0;
        for (size_t i = 0; i < answers.size(); ++i) {
            const Answer &answer = answers[i], &truth = sample.truth[i];
            wrong += answer.object != truth.object ||
                     (truth.object != no_object && std::fabs(double(answer.t) - truth.t) > 1e-4 * truth.t);
        }
        return {sample.wrong_fraction(wrong).first, "FALSE_FRACTION"};
    };
}

/// Queries of every day, in which hardly a ray is hard: what exactness costs there.
template <class Content>
void easy_cases(Bench& bench, const std::string& prefix, uint32_t n, float half, const Content& content,
                std::vector<Entry>& entries) {
    load(entries, content);
    for (const bool of_camera : {false, true}) {
        const std::vector<gphys_ray> rays = of_camera ? bench.camera_rays(half) : random_rays(half, bench.ray_count(n));
        const RaySample sample(rays, n, [&](const gphys_ray& r) { return reference(content, r); });
        bench.measure("accuracy", prefix + (of_camera ? "_camera" : "_random"), n, entries, closest_hits(rays),
                      false_answers(sample));
    }
}

void accuracy_suite(Bench& bench) {
    const uint32_t count = bench.ray_count(1000);
    const auto everybody = [] {
        std::vector<Entry> all = bench::everybody();
        all.push_back({"gamephys_float", make_gamephys_float()});
        return all;
    };
    {
        const uint32_t n = bench.sizes().back() < 100000 ? 10000 : 100000;
        std::vector<Entry> entries = everybody();
        easy_cases(bench, "boxes", n, half_side(n), boxes(n), entries);
        const Triangles mesh = bumpy_sphere(n < 100000 ? 4 : 6);
        entries = everybody();
        easy_cases(bench, "mesh", mesh.count(), 1.1f, mesh, entries);
    }
    const auto cast = [&](const std::string& name, uint32_t n, std::vector<Entry>& entries, const HardRays& work) {
        bench.measure("accuracy", name, n, entries, closest_hits(work.rays), false_answers(work));
    };
    const Triangles mesh = bumpy_sphere(5);
    const struct {
        const char* name;
        gphys_vec3 offset, scale;
    } meshes[] = {{"leaks_near", {0, 0, 0}, {1, 1, 1}},
                  {"leaks_far", {3e5f, -2e5f, 1e5f}, {1000, 1000, 1000}},
                  {"leaks_slivers", {0, 0, 0}, {1000, 1, .001f}}};
    for (const auto& m : meshes) {
        const Triangles content = placed(mesh, m.offset, m.scale);
        std::vector<Entry> entries = everybody();
        load(entries, content);
        cast(m.name, mesh.count(), entries, rays_out_of(content, m.offset, count));
    }
    {
        const std::vector<gphys_obb> content{grid_box()};
        std::vector<Entry> entries = everybody();
        load(entries, content);
        cast("ray_box_edges", 1, entries, rays_at_grid_box(count));
        uint64_t touching = 0, total = 0;
        const std::vector<gphys_sphere> balls = spheres_at_grid_box(count / 10, touching);
        bench.measure(
            "accuracy", "sphere_touches_box", 1, entries,
            [&](Implementation& i) { return i.overlap(balls, total) ? static_cast<double>(balls.size()) : 0; },
            [&](Implementation& i) -> std::pair<double, std::string> {
                i.overlap(balls, total);
                const double difference = static_cast<double>(total) - static_cast<double>(touching);
                return {std::fabs(difference) / static_cast<double>(balls.size()), "FALSE_FRACTION"};
            });
    }
    {
        const std::vector<gphys_sphere> content{tangent_sphere()};
        std::vector<Entry> entries = everybody();
        load(entries, content);
        cast("ray_sphere_tangent", 1, entries, rays_at_tangent_sphere(count));
    }
}

}  // namespace

int run(int argc, char** argv) {
    Options options;
    std::vector<std::string> suites;
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--quick")) {
            options.quick = true;
        } else if (!std::strncmp(argv[i], "--out=", 6)) {
            options.directory = argv[i] + 6;
        } else if (!std::strncmp(argv[i], "--case=", 7)) {
            options.only = argv[i] + 7;
        } else if (!std::strncmp(argv[i], "--objects=", 10)) {
            options.objects = static_cast<uint32_t>(std::strtoul(argv[i] + 10, nullptr, 10));
        } else {
            suites.emplace_back(argv[i]);
        }
    }
    const std::map<std::string, void (*)(Bench&)> known = {{"scene", scene_suite},
                                                           {"mesh", mesh_suite},
                                                           {"query", query_suite},
                                                           {"update", update_suite},
                                                           {"accuracy", accuracy_suite}};
    if (suites.empty()) suites = {"scene", "mesh", "query", "update"};
    for (const std::string& suite : suites) {
        if (!known.count(suite)) {
            std::fprintf(stderr, "unknown suite %s; there are: scene mesh query update accuracy\n", suite.c_str());
            return 2;
        }
    }
    std::string interleave = "--benchmark_enable_random_interleaving=true", min_time = "--benchmark_min_time=0.01",
                program = argv[0];
    char* arguments[] = {program.data(), interleave.data(), min_time.data(), nullptr};
    int count = 3;
    benchmark::Initialize(&count, arguments);
    Bench bench(options);
    for (const std::string& suite : suites) known.at(suite)(bench);
    bench.write();
    return 0;
}

}  // namespace bench

int main(int argc, char** argv) {
    try {
        return bench::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
