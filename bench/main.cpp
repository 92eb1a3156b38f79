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
#include "harness.h"
#include "measure.h"

namespace bench {

namespace {

/// Packets are for rays that go together.
Task without_packets(const Task& task) {
    return [task](Implementation& i) { return i.wants_packets() ? 0 : task(i); };
}

void ray_cases(Bench& bench, const std::string& suite, const std::string& prefix, uint32_t n, float half,
               std::vector<Entry>& entries, double tests_per_ray, const std::function<Answer(const gphys_ray&)>& truth,
               bool with_any_batch) {
    const std::vector<gphys_ray> random = random_rays(half, bench.ray_count(n)), away = turned_away(random);
    const RaySample random_sample(random, tests_per_ray, truth), away_sample(away, tests_per_ray, truth);
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

void scene_suite(Bench& bench) {
    std::vector<uint32_t> sizes = bench.sizes();
    if (!bench.quick()) sizes.push_back(4000000);
    for (const uint32_t n : sizes) {
        if (!bench.wants(n)) continue;
        const float half = half_side(n);
        const std::vector<gphys_obb> content = boxes(n);
        std::vector<Entry> entries = everybody();
        add_on_threads(entries);
        bench.measure(
            "scene", "build_scene", n, entries, [&](Implementation& i) { return i.load(content) ? n : 0; }, unchecked);
        report_memory(bench, "scene", "scene", n, entries);
        add_packets(entries, content);
        const size_t loaded = entries.size();
        add_apart(entries);
        for (size_t i = loaded; i < entries.size(); ++i) entries[i].implementation->load(content);
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

/// Cloth that a solver has let down on a ball: rays at the body as a model, beside a mesh that was built of its
/// triangles, which is what others have.
void simulated_cloth(Bench& bench) {
    const uint32_t side = bench.quick() ? 40 : 120, n = 2 * (side - 1) * (side - 1);
    if (!bench.wants(n)) return;
    gphys_scene* scene = nullptr;
    gphys_solver* solver = nullptr;
    gphys_model_id ball_model = 0;
    gphys_body_id body = 0;
    const gphys_sphere ball{{0, 0, 0}, 0.6f};
    const gphys_vec3 corner{-1, 0.7f, -1}, u{2, 0, 0}, v{0, 0, 2};
    check(gphys_scene_create(nullptr, &scene));
    check(gphys_solver_create(nullptr, &solver));
    check(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, nullptr, nullptr, &ball_model));
    check(gphys_solver_add_cloth(solver, nullptr, &corner, &u, &v, side, side, &body));
    std::vector<Entry> entries = everybody();
    entries.front().implementation->load_body(solver, body);
    for (int frame = 0; frame < 60; ++frame) check(gphys_solver_step(solver, scene, 1.0f / 60));
    Triangles form{std::vector<gphys_vec3>(size_t{side} * side), std::vector<uint32_t>(size_t{3} * n)};
    uint32_t total = 0;
    check(gphys_solver_get_positions(solver, body, 0, side * side, form.vertices.data(), sizeof(gphys_vec3)));
    check(gphys_solver_get_triangles(solver, body, form.indices.data(), 3 * n, &total));
    std::vector<Entry> built = everybody();
    load(built, form);
    built.front().name += "_built";
    for (size_t i = 1; i < built.size(); ++i) entries[i] = std::move(built[i]);
    entries.push_back(std::move(built.front()));
    const std::vector<gphys_ray> rays = random_rays(1.1f, bench.ray_count(n));
    const RaySample sample(rays, n, [&](const gphys_ray& r) { return reference(form, r); });
    bench.measure("mesh", "ray_at_simulated_cloth", n, entries, closest_hits(rays), closest_right(sample));
    bench.measure("mesh", "single_at_simulated_cloth", n, entries, closest_hits_singly(rays),
                  closest_right(sample, true));
    entries.clear();
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);
}

/// Meshes that are stretched along their axes: a forest of one tree, and a prop that is flattened, beside a mesh of
/// the multiplied vertices.
void stretched_meshes(Bench& bench) {
    const auto rays_at = [&](const std::string& name, uint32_t n, float half, std::vector<Entry>& entries,
                             double tests_per_ray, const auto& truth) {
        for (const bool of_camera : {false, true}) {
            const std::string row = name + (of_camera ? "_ray_camera" : "_ray_random");
            if (!bench.wants(row, n)) continue;
            const std::vector<gphys_ray> rays =
                of_camera ? bench.camera_rays(half) : random_rays(half, bench.ray_count(n));
            entries.front().implementation->closest(rays);
            demand_variety(row, rays, entries.front().implementation->answers());
            const RaySample sample(rays, tests_per_ray, truth);
            bench.measure("mesh", row, n, entries, closest_hits(rays), closest_right(sample));
        }
    };
    const uint32_t trees = bench.quick() ? 1000 : 10000;
    if (bench.wants(trees)) {
        const Triangles tree = bumpy_sphere(3);
        const std::vector<Stretched> content = forest(trees);
        std::vector<Entry> entries = everybody();
        load(entries, tree, content);
        rays_at("forest", trees, half_side(trees), entries, trees * 20.0,
                [&](const gphys_ray& r) { return reference(tree, content, r); });
    }
    const Triangles prop = bumpy_sphere(bench.quick() ? 5 : 6);
    if (!bench.wants(prop.count())) return;
    const std::vector<Stretched> flat{{{{0, 0, 0}, {0, 0, 0, 1}, 1}, {1, 0.05f, 1}}};
    Triangles multiplied = prop;
    for (gphys_vec3& vertex : multiplied.vertices) vertex.y *= flat[0].scale.y;
    std::vector<Entry> entries = everybody();
    load(entries, prop, flat);
    entries.push_back({"gamephys_multiplied", make_gamephys(1)});
    entries.back().implementation->load(multiplied, std::vector<gphys_transform>{flat[0].place});
    rays_at("flattened", prop.count(), 1.1f, entries, prop.count(),
            [&](const gphys_ray& r) { return reference(prop, flat, r); });
}

/// Queries with one answer each, against the loop in double precision.
template <class Query, class Content>
void answer_case(Bench& bench, const std::string& suite, const std::string& name, uint32_t n,
                 std::vector<Entry>& entries, const Content& content, const std::vector<Query>& queries,
                 bool (Implementation::*ask)(const std::vector<Query>&)) {
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
    bench.measure(suite, name, n, entries, task, answers_right(sample, ask));
}

/// In a batch, and a call for each.
template <class Content>
void nearest_cases(Bench& bench, const std::string& suite, const std::string& name, uint32_t n,
                   std::vector<Entry>& entries, const Content& content, const std::vector<gphys_vec3>& points) {
    answer_case(bench, suite, name, n, entries, content, points, &Implementation::nearest);
    answer_case(bench, suite, name + "_single", n, entries, content, points, &Implementation::nearest_singly);
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
        nearest_cases(bench, "mesh", "mesh_nearest_scan", mesh.count(), entries, mesh, points_near(mesh, 100000));
        nearest_cases(bench, "mesh", "mesh_nearest_random", mesh.count(), entries, mesh, query_points(1.1f, 20000));
        add_packets(entries, mesh);
        const auto truth = [&](const gphys_ray& r) { return reference(mesh, r); };
        ray_cases(bench, "mesh", "mesh", mesh.count(), 1.1f, entries, mesh.count(), truth, true);
        // The mesh as the one model of a scene; others, who need no model for that, have it as it is.
        const std::vector<gphys_transform> one{{{0, 0, 0}, {0, 0, 0, 1}, 1}};
        entries.front().implementation->load(mesh, one);
        ray_cases(bench, "mesh", "mesh_model", mesh.count(), 1.1f, entries, mesh.count(), truth, true);
    }
    moving_meshes(bench);
    simulated_cloth(bench);
    stretched_meshes(bench);
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

void query_suite(Bench& bench) {
    for (const uint32_t n : bench.sizes()) {
        if (n < 10000 || !bench.wants(n)) continue;
        const std::vector<gphys_obb> content = boxes(n);
        const float half = half_side(n);
        std::vector<Entry> entries = everybody();
        add_on_threads(entries);
        add_apart(entries);
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
        nearest_cases(bench, "query", "nearest_box", n, entries, content, query_points(half, 100000));
        answer_case(bench, "query", "segment", n, entries, content, query_segments(half, 100000, 10),
                    &Implementation::segments);
        answer_case(bench, "query", "sweep_sphere", n, entries, content, query_sweeps(half, 100000, 0.1f, 10),
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
        nearest_cases(bench, "query", "nearest_point", n, of_points, points, query_points(half, 100000));
    }
    solid_cases(bench);
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
    return [right = closest_right(sample)](Implementation& implementation) -> std::pair<double, std::string> {
        const auto [error, unit] = right(implementation);
        return {unit == "WRONG_FRACTION" ? error : 0, "FALSE_FRACTION"};
    };
}

/// Queries of every day, in which hardly a ray is hard: what exactness costs there.
template <class Content>
void easy_cases(Bench& bench, const std::string& prefix, uint32_t n, float half, const Content& content,
                std::vector<Entry>& entries) {
    load(entries, content);
    add_packets(entries, content);
    for (const bool of_camera : {false, true}) {
        const std::vector<gphys_ray> rays = of_camera ? bench.camera_rays(half) : random_rays(half, bench.ray_count(n));
        const RaySample sample(rays, n, [&](const gphys_ray& r) { return reference(content, r); });
        const Task cast = closest_hits(rays);
        bench.measure("accuracy", prefix + (of_camera ? "_camera" : "_random"), n, entries,
                      of_camera ? cast : without_packets(cast), false_answers(sample));
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
