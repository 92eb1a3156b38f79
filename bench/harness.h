// What the suites of gamephys_bench share: who takes part, how a case is timed, and how its answers are checked.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>

#include "implementation.h"
#include "spread.h"
#include "thread_counts.h"

namespace bench {

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
    Spread spread;  // of the repetitions, whose fastest is value; of zeros: measured once
    std::string unit;
    double error;
    std::string error_unit;
};

/// Keeps the fastest repetition of each benchmark: the one that noise disturbed least.
class Fastest final : public benchmark::BenchmarkReporter {
public:
    std::map<std::string, double> seconds;
    std::map<std::string, std::vector<double>> all;

    Spread spread(const std::string& name) const {
        const auto found = all.find(name);
        return found == all.end() ? Spread{} : spread_of(found->second);
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

inline void add_on_threads(std::vector<Entry>& entries) {
    for (const uint32_t threads : thread_counts()) {
        entries.push_back({"gamephys_" + std::to_string(threads) + "_threads", make_gamephys(threads), true});
    }
}
/// Callers that have nothing to do with one another, with a part of the queries each: what the machine allows.
inline void add_apart(std::vector<Entry>& entries) {
    for (const uint32_t callers : thread_counts()) {
        entries.push_back({"gamephys_" + std::to_string(callers) + "_apart", make_gamephys(1, callers), true});
    }
}

inline std::vector<Entry> everybody([[maybe_unused]] bool moving = false) {
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
    uint32_t ray_count(uint32_t n) const {
        return options_.quick ? 50000 : n >= 4000000 ? 200000 : n >= 1000000 ? 500000 : 1000000;
    }
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
                 fastest.spread(entry->name).scaled(scale), "ns", error, error_unit});
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
                std::fputs(
                    "suite,case,implementation,n,value,unit,error,error_unit,lower_quartile,median,upper_quartile\n",
                    file);
            }
            std::fprintf(file, "%s,%s,%s,%u,%.4g,%s,%.3g,%s,%.4g,%.4g,%.4g\n", row.suite.c_str(), row.name.c_str(),
                         row.implementation.c_str(), row.n, row.value, row.unit.c_str(), row.error,
                         row.error_unit.c_str(), row.spread.lower, row.spread.median, row.spread.upper);
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

/// Wrong is a miss of what is hit, a hit of nothing, or a hit of another object at another distance. The error is that
/// of distances otherwise. Libraries mean different things by what begins in an object, so that is left out.
template <class Query>
Check answers_right(const Sample<Query>& sample, bool (Implementation::*ask)(const std::vector<Query>&)) {
    return [&sample, ask](Implementation& implementation) -> std::pair<double, std::string> {
        (implementation.*ask)(sample.queries);
        const std::vector<Answer> answers = implementation.answers();
        double worst = 0;
        size_t wrong = 0;
        for (size_t i = 0; i < answers.size(); ++i) {
            const Answer& truth = sample.truth[i];
            if (truth.t == 0) continue;
            if (answers[i].object == no_object || truth.object == no_object) {
                wrong += answers[i].object != truth.object;
                continue;
            }
            const double error = std::fabs(double(answers[i].t) - truth.t) / truth.t;
            if (answers[i].object != truth.object && error > 1e-4) {
                ++wrong;
            } else {
                worst = std::max(worst, error);
            }
        }
        if (wrong) return sample.wrong_fraction(wrong);
        return {worst, "relative"};
    };
}
inline Check closest_right(const RaySample& sample, bool singly = false) {
    return answers_right(sample, singly ? &Implementation::closest_singly : &Implementation::closest);
}

inline Check any_right(const RaySample& sample, bool singly = false) {
    return [&sample, singly](Implementation& implementation) -> std::pair<double, std::string> {
        std::vector<int32_t> answers;
        singly ? implementation.any_singly(sample.queries, answers) : implementation.any(sample.queries, answers);
        size_t wrong = 0;
        for (size_t i = 0; i < answers.size(); ++i) wrong += (answers[i] != 0) != (sample.truth[i].object != no_object);
        if (wrong) return sample.wrong_fraction(wrong);
        return {0, "relative"};
    };
}

inline std::pair<double, std::string> unchecked(Implementation&) { return {0, "unchecked"}; }

/// A part of the rays in which neighbours are still together: 8 by 8 rays of a camera are a tile.
/// 61 is prime, so that the tiles come from all columns of the picture.
inline std::vector<gphys_ray> every_61st_tile(const std::vector<gphys_ray>& rays) {
    std::vector<gphys_ray> some;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (i / 64 % 61 == 0) some.push_back(rays[i]);
    }
    return some;
}

/// The rays of a camera as its picture is stored.
inline std::vector<gphys_ray> row_by_row(const std::vector<gphys_ray>& tiles, size_t width) {
    std::vector<gphys_ray> rows(tiles.size());
    const size_t in_row = width / 8;
    for (size_t i = 0; i < tiles.size(); ++i) {
        const size_t tile = i / 64, x = tile % in_row * 8 + i % 8, y = tile / in_row * 8 + i / 8 % 8;
        rows[y * width + x] = tiles[i];
    }
    return rows;
}

/// Closest hits of all rays, or of a part where all would take minutes.
inline Task closest_hits(const std::vector<gphys_ray>& rays) {
    return [&rays, some = every_61st_tile(rays)](Implementation& i) -> double {
        const std::vector<gphys_ray>& its_rays = i.is_slow() ? some : rays;
        return i.closest(its_rays) ? static_cast<double>(its_rays.size()) : 0;
    };
}

/// Distances only.
inline Task distances(const std::vector<gphys_ray>& rays) {
    return [&rays](Implementation& i) { return i.distances(rays) ? static_cast<double>(rays.size()) : 0; };
}

/// Closest hits, a call for each ray.
inline Task closest_hits_singly(const std::vector<gphys_ray>& rays) {
    return [&rays, some = every_61st_tile(rays)](Implementation& i) -> double {
        const std::vector<gphys_ray>& its_rays = i.is_slow() ? some : rays;
        return i.closest_singly(its_rays) ? static_cast<double>(its_rays.size()) : 0;
    };
}

/// The same rays, pointing away: they miss the bounds of everything.
inline std::vector<gphys_ray> turned_away(std::vector<gphys_ray> rays) {
    for (gphys_ray& ray : rays) {
        const gphys_vec3 d = ray.direction;
        ray.direction = {-d.x, -d.y, -d.z};
    }
    return rays;
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

inline void report_memory(Bench& bench, const std::string& suite, const std::string& name, uint32_t n,
                          std::vector<Entry>& entries) {
    for (Entry& entry : entries) {
        if (!entry.implementation || entry.several_threads || entry.implementation->memory() == 0) continue;
        const auto add = [&](const std::string& what, uint64_t bytes) {
            bench.add({suite, what + name, entry.name, n, static_cast<double>(bytes) / n, {}, "B", 0, "exact"});
        };
        add("memory_", entry.implementation->memory());
        add("memory_peak_", entry.implementation->peak_memory());
    }
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

/// A copy with the tree, and back: beside a build, what it saves. Operations are of an item; `_bytes` of one byte.
inline void save_and_load(Bench& bench, const std::string& suite, const std::string& what, uint32_t n,
                          std::vector<Entry>& entries) {
    bench.measure(
        suite, "save_" + what, n, entries, [&](Implementation& i) { return i.save() > 0 ? n : 0; }, unchecked);
    bench.measure(
        suite, "save_" + what + "_bytes", n, entries, [](Implementation& i) { return static_cast<double>(i.save()); },
        unchecked);
    bench.measure(
        suite, "load_" + what, n, entries, [&](Implementation& i) { return i.load_saved() ? n : 0; }, unchecked);
}

/// solid_cases.cpp: convex hulls, sweeps of capsules and boxes, and rays without one model, for the query suite.
void solid_cases(Bench& bench);
/// update_suite.cpp.
void update_suite(Bench& bench);

}  // namespace bench
