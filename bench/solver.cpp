// gamephys_bench_solver [CASE...] [--quick] [--out=DIR]: work and precision of solvers. Each method moves each
// system for some seconds; DIR/solver.csv gets a row for each with the time of a 60 Hz frame beside
// the stretch, the energy gained and the distance from a reference, or how deep it is in models.
#include "solver.h"

#include <time.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "thread_counts.h"

namespace bench {

namespace {

constexpr double bend_compliance = 1e-3;  // m/N

class Gamephys final : public Method {
public:
    Gamephys(const System& system, uint32_t substeps, uint32_t workers) {
        gphys_solver_desc desc;
        check(gphys_solver_desc_init(&desc, sizeof desc));
        desc.gravity = {0, -static_cast<float>(gravity), 0};
        desc.substeps = substeps;
        desc.worker_count = workers;
        check(gphys_solver_create(&desc, &solver_));
        for (size_t first = 0; first < system.positions.size(); first += system.body_size) add(system, first);
    }
    ~Gamephys() override { gphys_solver_destroy(solver_); }
    void step(float seconds) override { check(gphys_solver_step(solver_, nullptr, seconds)); }
    std::vector<gphys_vec3> positions() const override { return read(gphys_solver_get_positions); }
    std::vector<gphys_vec3> velocities() const override { return read(gphys_solver_get_velocities); }

private:
    void add(const System& system, size_t first) {
        gphys_body_desc desc;
        check(gphys_body_desc_init(&desc, sizeof desc));
        desc.damping = system.damping;
        desc.cloth_flags = GPHYS_CLOTH_SHEAR | (system.bend ? GPHYS_CLOTH_BEND : 0);
        desc.bend_compliance = static_cast<float>(bend_compliance);
        gphys_body_id body = 0;
        if (system.columns > 0) {
            const uint32_t n = system.columns;
            check(gphys_solver_add_cloth(solver_, &desc, &system.positions[0], &system.positions[n - 1],
                                         &system.positions[n * (n - 1)], n, n, &body));
        } else {
            check(gphys_solver_add_rope(solver_, &desc, &system.positions[first], 12, system.body_size,
                                        static_cast<float>(system.links[0].rest), &body));
        }
        for (uint32_t i = 0; i < system.body_size; ++i) {
            const float mass = system.masses[first + i];
            check(mass > 0 ? gphys_solver_set_masses(solver_, body, i, 1, &mass, 4)
                           : gphys_solver_set_pinned(solver_, body, i, 1, 1));
        }
        bodies_.emplace_back(body, system.body_size);
    }

    template <class Get>
    std::vector<gphys_vec3> read(Get&& get) const {
        std::vector<gphys_vec3> out;
        for (const auto& [body, size] : bodies_) {
            out.resize(out.size() + size);
            check(get(solver_, body, 0, size, &out[out.size() - size], 12));
        }
        return out;
    }

    gphys_solver* solver_ = nullptr;
    std::vector<std::pair<gphys_body_id, uint32_t>> bodies_;
};

/// Ropes of `links` links of the given length from the origin along x, their first ends pinned.
System ropes(uint32_t count, uint32_t links, float length, float tip_mass) {
    System system;
    system.body_size = links + 1;
    for (uint32_t rope = 0; rope < count; ++rope) {
        for (uint32_t i = 0; i <= links; ++i) {
            const auto p = static_cast<uint32_t>(system.positions.size());
            if (i > 0) system.links.push_back({p - 1, p, static_cast<double>(length), 0});
            system.positions.push_back({static_cast<float>(i) * length, 0, static_cast<float>(rope)});
            system.masses.push_back(i == 0 ? 0 : i == links ? tip_mass : 1);
        }
    }
    return system;
}

/// A square sheet of n x n particles 2 cm apart, level, held at two corners.
System cloth(uint32_t n, bool bend) {
    System system;
    system.body_size = n * n;
    system.columns = n;
    system.bend = bend;
    system.damping = 1;
    constexpr double spacing = 0.02;
    for (uint32_t i = 0; i < n * n; ++i) {
        system.positions.push_back({static_cast<float>(i % n * spacing), 0, static_cast<float>(i / n * spacing)});
    }
    system.masses.assign(n * n, 1);
    system.masses[0] = system.masses[n - 1] = 0;
    const auto join = [&](uint32_t right, uint32_t down, bool mirrored, double compliance) {
        for (uint32_t row = 0; row + down < n; ++row) {
            for (uint32_t column = 0; column + right < n; ++column) {
                const uint32_t from = row * n + column + (mirrored ? right : 0);
                const uint32_t to = (row + down) * n + column + (mirrored ? 0 : right);
                system.links.push_back({from, to, spacing * std::hypot(right, down), compliance});
            }
        }
    };
    join(1, 0, false, 0);
    join(0, 1, false, 0);
    join(1, 1, false, 0);
    join(1, 1, true, 0);
    if (bend) join(2, 0, false, bend_compliance), join(0, 2, false, bend_compliance);
    return system;
}

double distance(gphys_vec3 a, gphys_vec3 b) {
    return std::hypot(static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y, static_cast<double>(a.z) - b.z);
}

/// Of rigid links: the largest stretch and compression, and the root mean square of both. The stretch is infinite where
/// a method is unstable, so that links are a million times too long or are not numbers any more.
struct Strain {
    double stretch = 0, compression = 0, rms = 0;

    void widen(const Strain& other) {
        stretch = std::max(stretch, other.stretch);
        compression = std::max(compression, other.compression);
        rms = std::max(rms, other.rms);
    }
};

Strain strain_of(const System& system, const std::vector<gphys_vec3>& positions) {
    Strain result;
    double squares = 0, count = 0;
    for (const Link& link : system.links) {
        if (link.compliance > 0) continue;
        const double strain = distance(positions[link.a], positions[link.b]) / link.rest - 1;
        result.stretch = std::max(result.stretch, strain < 1e6 ? strain : std::numeric_limits<double>::infinity());
        result.compression = std::max(result.compression, -strain);
        squares += strain * strain;
        ++count;
    }
    result.rms = std::sqrt(squares / count);
    return result;
}

/// Joules, without what compliant links hold.
double energy(const System& system, const Method& method) {
    const std::vector<gphys_vec3> positions = method.positions(), velocities = method.velocities();
    double sum = 0;
    for (size_t i = 0; i < positions.size(); ++i) {
        const gphys_vec3 v = velocities[i];
        const double speed = std::hypot(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
        sum += system.masses[i] * (speed * speed / 2 + gravity * positions[i].y);
    }
    return sum;
}

/// Where a rope of `ropes` is after a second, by Newton's second law in double precision: SHAKE
/// (Ryckaert et al. 1977) in steps of 10 microseconds, each link projected until all are right.
std::vector<gphys_vec3> reference(const System& system, double seconds) {
    struct Point {
        double at[3], before[3];
    };
    constexpr double h = 1e-5;
    std::vector<Point> points;
    for (size_t i = 0; i < system.positions.size(); ++i) {
        const gphys_vec3 p = system.positions[i];
        Point point{{p.x, p.y, p.z}, {p.x, p.y, p.z}};
        if (system.masses[i] > 0) point.before[1] -= gravity * h * h / 2;
        points.push_back(point);
    }
    std::vector<Point> start;
    for (int64_t step = 0; step < std::llround(seconds / h); ++step) {
        start = points;
        for (size_t i = 0; i < points.size(); ++i) {
            if (system.masses[i] == 0) continue;
            for (int k = 0; k < 3; ++k) {
                points[i].at[k] += start[i].at[k] - start[i].before[k] - (k == 1 ? gravity * h * h : 0);
                points[i].before[k] = start[i].at[k];
            }
        }
        double worst = 1;
        for (int sweep = 0; sweep < 1000 && worst > 1e-10; ++sweep) {
            worst = 0;
            for (size_t turn = 0; turn < system.links.size(); ++turn) {
                const Link& link = system.links[sweep % 2 ? system.links.size() - 1 - turn : turn];
                Point &a = points[link.a], &b = points[link.b];
                double now = 0, along = 0;
                for (int k = 0; k < 3; ++k) {
                    const double d = b.at[k] - a.at[k];
                    now += d * d;
                    along += d * (start[link.b].at[k] - start[link.a].at[k]);
                }
                const double wa = system.masses[link.a] > 0 ? 1.0 / system.masses[link.a] : 0;
                const double wb = system.masses[link.b] > 0 ? 1.0 / system.masses[link.b] : 0;
                const double pull = (now - link.rest * link.rest) / (2 * along * (wa + wb));
                worst = std::max(worst, std::fabs(now / (link.rest * link.rest) - 1));
                for (int k = 0; k < 3; ++k) {
                    const double d = start[link.b].at[k] - start[link.a].at[k];
                    a.at[k] += wa * pull * d;
                    b.at[k] -= wb * pull * d;
                }
            }
        }
    }
    std::vector<gphys_vec3> out;
    for (const Point& p : points) {
        out.push_back({static_cast<float>(p.at[0]), static_cast<float>(p.at[1]), static_cast<float>(p.at[2])});
    }
    return out;
}

struct Contender {
    std::string name;
    std::function<std::unique_ptr<Method>(const System&, uint32_t)> make;
    std::vector<uint32_t> efforts;
    bool several_threads = false;  // timed by the clock on the wall
};

double seconds_on_the_wall() {
    timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

/// Of a frame of solvers that have a thread each, by the clock: what they make together.
double milliseconds_apart(const System& system, double seconds, uint32_t substeps, uint32_t solvers) {
    std::vector<double> frames_per_ms(solvers);
    const auto move = [&](double& rate) {
        Gamephys solver(system, substeps, 1);
        std::vector<double> times;
        for (int i = 0; i < std::lround(seconds / frame); ++i) {
            const double start = seconds_on_the_wall();
            solver.step(frame_time(i));
            times.push_back(seconds_on_the_wall() - start);
        }
        rate = 1e-3 / spread_of(times).median;
    };
    std::vector<std::thread> others;
    for (uint32_t i = 1; i < solvers; ++i) others.emplace_back(move, std::ref(frames_per_ms[i]));
    move(frames_per_ms[0]);
    for (std::thread& other : others) other.join();
    return 1 / std::accumulate(frames_per_ms.begin(), frames_per_ms.end(), 0.0);
}

/// Of positions at the end, metres.
using ErrorOf = std::function<double(const std::vector<gphys_vec3>&)>;

/// The root mean square of the distances from where the particles should be.
ErrorOf distance_from(const std::vector<gphys_vec3>& truth) {
    return [truth](const std::vector<gphys_vec3>& positions) {
        double squares = 0;
        for (size_t i = 0; i < truth.size(); ++i) squares += std::pow(distance(positions[i], truth[i]), 2);
        return std::sqrt(squares / static_cast<double>(truth.size()));
    };
}

class Table {
public:
    /// Of all cases if none is wanted.
    Table(const std::string& path, std::vector<std::string> wanted)
        : file_(std::fopen(path.c_str(), "w")), wanted_(std::move(wanted)) {
        if (!file_) throw std::runtime_error("cannot write " + path);
        std::fputs(
            "suite,case,method,substeps,ms,strain_max,strain_rms,energy_gain,position_error,compression_max,"
            "ms_lower_quartile,ms_upper_quartile\n",
            file_);
    }
    ~Table() { std::fclose(file_); }

    void run(const char* name, const System& system, double seconds, const std::vector<Contender>& contenders,
             const ErrorOf& error_of = {}) {
        if (!wants(name)) return;
        for (const Contender& contender : contenders) {
            for (const uint32_t effort : contender.efforts) {
                print(name, contender, effort, measure(system, seconds, contender, effort, error_of));
            }
        }
    }

    /// One thread, several of one solver, and as many of which each has a solver of its own with the same bodies, so
    /// that only the processor keeps them from being as many times as fast. By turns, the best of several rounds: where
    /// processors are shared, what one of several threads has to wait for differs from second to second.
    void run_threads(const char* name, const System& system, double seconds, uint32_t substeps) {
        if (!wants(name)) return;
        const auto on_threads = [](uint32_t workers) {
            return [workers](const System& bodies, uint32_t effort) -> std::unique_ptr<Method> {
                return std::make_unique<Gamephys>(bodies, effort, workers);
            };
        };
        const std::vector<uint32_t> counts = thread_counts();
        std::vector<Contender> contenders{{"1_thread", on_threads(1), {}, true}};
        for (const uint32_t n : counts) {
            contenders.push_back({std::to_string(n) + "_threads", on_threads(n), {}, true});
        }
        constexpr int rounds = 5;
        std::vector<Row> best(contenders.size());
        std::vector<double> apart(counts.size());
        for (int round = 0; round < rounds; ++round) {
            for (size_t i = 0; i < contenders.size(); ++i) {
                const Row row = measure(system, seconds, contenders[i], substeps, {});
                if (round == 0 || row.ms.median < best[i].ms.median) best[i] = row;
            }
            for (size_t i = 0; i < counts.size(); ++i) {
                const double ms = milliseconds_apart(system, seconds, substeps, counts[i]);
                if (round == 0 || ms < apart[i]) apart[i] = ms;
            }
        }
        for (size_t i = 0; i < contenders.size(); ++i) print(name, contenders[i], substeps, best[i]);
        for (size_t i = 0; i < counts.size(); ++i) {
            const std::string method = std::to_string(counts[i]) + "_apart";
            std::printf("%-18s %-10s %5u %9.3f ms\n", name, method.c_str(), substeps, apart[i]);
            std::fprintf(file_, "solver,%s,%s,%u,%.4g,,,,\n", name, method.c_str(), substeps, apart[i]);
        }
        std::fflush(stdout);
    }

    bool wants(const std::string& name) const {
        return wanted_.empty() || std::find(wanted_.begin(), wanted_.end(), name) != wanted_.end();
    }

    void run_rain(const std::string& name, const char* method_name, const Rain& rain,
                  const std::function<std::unique_ptr<Method>(const Rain&)>& make) {
        if (!wants(name)) return;
        const std::unique_ptr<Method> method = make(rain);
        double depth = 0;
        for (const RainResult& result : measure_rain(rain, *method, depth)) {
            const double ms = result.seconds * 1e3, each = ms * 1e6 / static_cast<double>(rain.particles.size());
            std::printf("%-18s %-10s %5u %9.3f ms   %s, %.1f ns a particle, %.2g m deep\n", name.c_str(), method_name,
                        1, ms, result.when, each, depth);
            std::fprintf(file_, "solver,%s_%s,%s,1,%.4g,,,,%.3g,\n", name.c_str(), result.when, method_name, ms, depth);
        }
        std::fflush(stdout);
    }

    void run_pit(const char* name, const Pit& pit, double seconds, const char* method_name,
                 const std::vector<uint32_t>& efforts,
                 const std::function<std::unique_ptr<Method>(const Pit&, uint32_t)>& make) {
        if (!wants(name)) return;
        for (const uint32_t effort : efforts) {
            const PitResult result = measure_pit(pit, *make(pit, effort), seconds);
            const Spread ms = result.seconds.scaled(1e3);
            std::printf("%-18s %-10s %5u %9.3f ms   overlap %.3g m\n", name, method_name, effort, ms.median,
                        result.overlap);
            std::fprintf(file_, "solver,%s,%s,%u,%.4g,,,,%.3g,,%.4g,%.4g\n", name, method_name, effort, ms.median,
                         result.overlap, ms.lower, ms.upper);
        }
        std::fflush(stdout);
    }

    void run_drape(const char* name, const char* method_name, const Drape& drape, double seconds, uint32_t effort,
                   const std::function<std::unique_ptr<Method>(const Drape&, uint32_t)>& make) {
        if (!wants(name)) return;
        const std::unique_ptr<Method> method = make(drape, effort);
        const double ms = measure_drape(*method, seconds) * 1e3;
        const std::vector<gphys_vec3> positions = method->positions();
        const Strain strain = strain_of(drape.sheet, positions);
        const double depth = depth_in_ball(positions);
        std::printf("%-18s %-10s %5u %9.3f ms   %s at the end, %.2g m deep\n", name, method_name, effort, ms,
                    described(strain).c_str(), depth);
        std::fflush(stdout);
        std::fprintf(file_, "solver,%s,%s,%u,%.4g,%.4g,%.4g,,%.3g,%.4g\n", name, method_name, effort, ms,
                     strain.stretch, strain.rms, depth, strain.compression);
    }

    /// With a target of strain: rows with the mean of all frames and with the longest one, both beside the largest
    /// strain of the whole run.
    void run_drape_within(const std::string& name, const Drape& drape, double seconds, float max_strain,
                          uint32_t max_substeps) {
        if (!wants(name)) return;
        Strain strain;
        double depth = 0;
        const auto see = [&](const std::vector<gphys_vec3>& positions) {
            strain.widen(strain_of(drape.sheet, positions));
            depth = std::max(depth, depth_in_ball(positions));
        };
        const DrapeFrames frames = measure_drape_within(drape, max_strain, max_substeps, seconds, see);
        const auto put = [&](const char* which, double substeps, double taken) {
            std::printf("%-18s %-10s %5.1f %9.3f ms   %s frame, %s, %.2g m deep\n", name.c_str(), "gamephys", substeps,
                        taken * 1e3, which, described(strain).c_str(), depth);
            std::fprintf(file_, "solver,%s_%s,gamephys,%.1f,%.4g,%.4g,%.4g,,%.3g,%.4g\n", name.c_str(), which, substeps,
                         taken * 1e3, strain.stretch, strain.rms, depth, strain.compression);
        };
        put("mean", frames.substeps, frames.mean);
        put("longest", frames.most_substeps, frames.longest);
        std::fflush(stdout);
    }

private:
    struct Row {
        Spread ms;  // of the frames
        Strain strain;
        double gain;
        std::string error;
    };

    Row measure(const System& system, double seconds, const Contender& contender, uint32_t effort,
                const ErrorOf& error_of) {
        const auto clock = contender.several_threads ? seconds_on_the_wall : now;
        const std::unique_ptr<Method> method = contender.make(system, effort);
        const double before = energy(system, *method);
        std::vector<double> times;
        Strain strain;
        for (int i = 0; i < std::lround(seconds / frame); ++i) {
            const double start = clock();
            method->step(frame_time(i));
            times.push_back(clock() - start);
            strain.widen(strain_of(system, method->positions()));
        }
        // What there is to gain or lose: all masses falling as far as the system is long.
        double weight = 0, size = 0;
        for (size_t i = 0; i < system.positions.size(); ++i) {
            weight += gravity * system.masses[i];
            size = std::max(size, distance(system.positions[i], system.positions[0]));
        }
        const double gain = (energy(system, *method) - before) / (weight * size);
        std::string error;
        if (error_of) {
            char text[32];
            std::snprintf(text, sizeof text, "%.3g", error_of(method->positions()));
            error = text;
        }
        return {spread_of(times).scaled(1e3), strain, gain, error};
    }

    void print(const char* name, const Contender& contender, uint32_t effort, const Row& row) {
        const char* method = contender.name.c_str();
        std::printf("%-18s %-10s %5u %9.3f ms   %s   energy %+9.2g   error %s\n", name, method, effort, row.ms.median,
                    described(row.strain).c_str(), row.gain, row.error.c_str());
        std::fflush(stdout);
        std::fprintf(file_, "solver,%s,%s,%u,%.4g,%.4g,%.4g,%.4g,%s,%.4g,%.4g,%.4g\n", name, method, effort,
                     row.ms.median, row.strain.stretch, row.strain.rms, row.gain, row.error.c_str(),
                     row.strain.compression, row.ms.lower, row.ms.upper);
    }

    static std::string described(const Strain& strain) {
        char text[96];
        std::snprintf(text, sizeof text, "stretch %9.3g compression %9.3g rms %9.3g", strain.stretch,
                      strain.compression, strain.rms);
        return text;
    }

    std::FILE* file_;
    std::vector<std::string> wanted_;
};

}  // namespace

std::unique_ptr<Method> make_gamephys_solver(const System& system, uint32_t substeps) {
    return std::make_unique<Gamephys>(system, substeps, 1);
}

int run(int argc, char** argv) {
    bool quick = false;
    std::string directory = ".";
    std::vector<std::string> wanted;
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--quick")) quick = true;
        if (!std::strncmp(argv[i], "--out=", 6)) directory = argv[i] + 6;
        if (argv[i][0] != '-') wanted.emplace_back(argv[i]);
    }
    Table table(directory + "/solver.csv", wanted);
    const auto everybody = [&](std::vector<uint32_t> substeps, const std::vector<uint32_t>& baseline_substeps) {
        std::vector<Contender> all{{"gamephys", make_gamephys_solver, std::move(substeps)},
                                   {"jakobsen", make_jakobsen, {50}},
                                   {"xpbd", make_xpbd, baseline_substeps},
                                   {"explicit_euler", make_explicit_euler, baseline_substeps},
                                   {"semi_implicit_euler", make_semi_implicit_euler, baseline_substeps}};
#ifdef GAMEPHYS_BENCH_PEERS
        all.push_back({"bullet", make_bullet_soft, {10, 50}});
#endif
        return all;
    };
    const double seconds = quick ? 1 : 10;
    const System chain = ropes(1, 30, 0.1f, 10);
    table.run("chain_30", chain, 1, everybody({2, 4, 8, 16, 32}, {20, 100}),
              table.wants("chain_30") ? distance_from(reference(chain, 1)) : ErrorOf());
    table.run("rope_1e3", ropes(1, 1000, 0.01f, 1e3f), seconds, everybody({2, 4, 8}, {100, 1000}));
    table.run("rope_1e6", ropes(1, 1000, 0.01f, 1e6f), seconds, everybody({2, 4, 8}, {100, 1000}));
    table.run("ropes_1000x30", ropes(1000, 30, 0.1f, 1), quick ? 0.5 : 5, everybody({1, 2, 4}, {20}));
    table.run("cloth_100", cloth(100, false), quick ? 1.5 : 10, everybody({10, 20, 40}, {20, 100}));
    table.run("cloth_100_bend", cloth(100, true), quick ? 1.5 : 10, everybody({10, 20, 40}, {20, 100}));
    table.run_threads("ropes_threads", ropes(1000, 30, 0.1f, 1), 0.5, 8);
    table.run_threads("cloth_300_threads", cloth(300, false), 0.5, 8);
    // Bullet takes too long for a million.
    const Rain drizzle = make_rain(100000, 1000);
    if (!quick) table.run_rain("free_1M", "gamephys", make_rain(1000000, 1000), make_gamephys_rain);
    table.run_rain("free_100k", "gamephys", drizzle, make_gamephys_rain);
    const Pit pit = make_pit(2000);
    const double pouring = quick ? 1.5 : 4;
    table.run_pit("ball_pit", pit, pouring, "gamephys", {2, 4, 8, 16}, make_gamephys_pit);
    const System over_post = make_post_rope();
    std::vector<Contender> winders{{"gamephys", make_gamephys_post, {2, 4, 8, 16}},
                                   {"jakobsen", make_jakobsen, {50}},
                                   {"xpbd", make_xpbd, {20, 100}}};
#ifdef GAMEPHYS_BENCH_PEERS
    table.run_pit("ball_pit", pit, pouring, "bullet", {10, 50}, make_bullet_pit);
    table.run_pit("ball_pit", pit, pouring, "bullet_substeps", {4, 8}, make_bullet_pit_substeps);
    winders.push_back({"bullet", make_bullet_post, {10, 50}});
#endif
    constexpr double falling = 0.6;  // s
    table.run("rope_over_post", over_post, falling, winders, [&](const std::vector<gphys_vec3>& positions) {
        return std::fabs(positions.back().y - post_rope_height(over_post, falling));
    });
    const Drape drape = make_drape(100);
    for (const uint32_t substeps : {8u, 16u}) {
        table.run_drape("drape_over_mesh", "gamephys", drape, quick ? 0.5 : 3, substeps, make_gamephys_drape);
    }
    table.run_drape_within("drape_within_2_percent", drape, quick ? 1 : 10, 0.02f, 32);
#ifdef GAMEPHYS_BENCH_PEERS
    table.run_rain("free_100k", "bullet", drizzle, make_bullet_rain);
#endif
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
