// Solids: rays, overlaps and sweeps among convex hulls, capsules and boxes that are swept, and rays that leave out one
// model.
#include "harness.h"

namespace bench {

namespace {

/// Peers must agree with the exact answers of the first, whose tests hold them against CGAL: to a thousandth of the
/// way, as they end within a tolerance, and they may see another object where two are met within that. Libraries mean
/// different things by a sweep that begins in an object, so those are left out.
template <class Query>
Check agrees(const std::vector<Query>& queries, const std::vector<Answer>& truth,
             bool (Implementation::*ask)(const std::vector<Query>&)) {
    return [&queries, &truth, ask](Implementation& implementation) -> std::pair<double, std::string> {
        (implementation.*ask)(queries);
        const std::vector<Answer> answers = implementation.answers();
        size_t wrong = 0, compared = 0;
        double worst = 0;
        for (size_t i = 0; i < answers.size(); ++i) {
            if (truth[i].t == 0) continue;
            ++compared;
            if (answers[i].object == no_object || truth[i].object == no_object) {
                wrong += answers[i].object != truth[i].object;
                continue;
            }
            const double difference = std::fabs(double(answers[i].t) - truth[i].t);
            wrong += difference > 1e-3;
            if (difference <= 1e-3) worst = std::max(worst, difference);
        }
        if (wrong > 0) return {static_cast<double>(wrong) / static_cast<double>(compared), "WRONG_FRACTION"};
        return {worst, "of the way"};
    };
}

template <class Query>
void sweep_case(Bench& bench, const std::string& name, uint32_t n, std::vector<Entry>& entries,
                const std::vector<Query>& queries) {
    if (!bench.wants(name, n)) return;
    bool (Implementation::*const ask)(const std::vector<Query>&) = &Implementation::sweeps;
    Implementation& first = *entries.front().implementation;
    (first.*ask)(queries);
    demand_variety(name, queries, first.answers());
    std::vector<Query> part;  // where all would take minutes
    for (size_t i = 0; i < queries.size(); i += 50) part.push_back(queries[i]);
    (first.*ask)(part);
    const std::vector<Answer> truth = first.answers();
    bench.measure(
        "query", name, n, entries,
        [&](Implementation& i) -> double {
            const std::vector<Query>& its_queries = i.is_slow() ? part : queries;
            return (i.*ask)(its_queries) ? static_cast<double>(its_queries.size()) : 0;
        },
        agrees(part, truth, ask));
}

/// Rocks, beside the same as surfaces of Embree and hulls of Bullet.
void hulls(Bench& bench, uint32_t n) {
    const Triangles mesh = rock();
    const std::vector<gphys_transform> content = placements(n);
    const float half = half_side(n);
    std::vector<Entry> entries = everybody();
    for (Entry& entry : entries) {
        if (!entry.implementation->load_hull(mesh, content)) entry.implementation.reset();
    }
    const std::vector<gphys_ray> random = random_rays(half, bench.ray_count(n)), camera = bench.camera_rays(half);
    const auto truth = [&](const gphys_ray& ray) { return reference(mesh, content, ray); };
    const RaySample sample(random, n * 20.0, truth), camera_sample(camera, n * 20.0, truth);
    entries.front().implementation->closest(random);
    demand_variety("hull_ray_random", random, entries.front().implementation->answers());
    // The same as a mesh, in which nothing is inside.
    entries.push_back({"gamephys_mesh", make_gamephys(1)});
    entries.back().implementation->load(mesh, content);
    bench.measure("query", "hull_ray_random", n, entries, closest_hits(random), closest_right(sample));
    bench.measure("query", "hull_ray_camera", n, entries, closest_hits(camera), closest_right(camera_sample));
    bench.measure("query", "hull_ray_single", n, entries, closest_hits_singly(random), closest_right(sample, true));
    entries.pop_back();

    // Balls of radius 0 are points: what contains them.
    for (const float radius : {0.0f, 1.0f}) {
        const std::string name = radius == 0 ? "hull_contains" : "hull_overlap";
        const std::vector<gphys_sphere> balls = query_spheres(half, 10000, radius);
        uint64_t expected = 0, total = 0;
        entries.front().implementation->overlap(balls, expected);
        if (expected < balls.size() / 100) throw std::runtime_error(name + ": too few balls find something");
        bench.measure(
            "query", name, n, entries,
            [&](Implementation& i) { return i.overlap(balls, total) ? static_cast<double>(balls.size()) : 0; },
            [&](Implementation& i) -> std::pair<double, std::string> {
                i.overlap(balls, total);
                const double difference = static_cast<double>(total) - static_cast<double>(expected);
                return {std::fabs(difference) / static_cast<double>(expected), "relative"};
            });
    }
    sweep_case(bench, "hull_sweep_capsule", n, entries, query_capsule_sweeps(half, 20000, 10));
    sweep_case(bench, "hull_sweep_box", n, entries, query_box_sweeps(half, 20000, 10));
}

void sweeps_at_boxes(Bench& bench, uint32_t n) {
    const std::vector<gphys_obb> content = boxes(n);
    const float half = half_side(n);
    std::vector<Entry> entries = everybody();
    load(entries, content);
    sweep_case(bench, "sweep_capsule", n, entries, query_capsule_sweeps(half, 50000, 10));
    sweep_case(bench, "sweep_box", n, entries, query_box_sweeps(half, 50000, 10));
}

/// `gamephys_plain` leaves out nothing. The model that is left out is one of many, and far from most rays.
void without_one(Bench& bench, uint32_t n) {
    const std::vector<gphys_obb> content = boxes(n);
    std::vector<Entry> entries;
    for (const char* name : {"gamephys", "gamephys_plain"}) {
        entries.push_back({name, make_gamephys(1)});
        entries.back().implementation->load(content);
    }
    const std::vector<gphys_ray> rays = random_rays(half_side(n), bench.ray_count(n) / 5);
    Implementation& plain = *entries.back().implementation;
    plain.closest(rays);
    demand_variety("ray_without_one", rays, plain.answers());
    const uint32_t left_out = n / 2;
    for (const bool singly : {false, true}) {
        const RaySample sample(rays, n, [&](const gphys_ray& ray) { return reference(content, ray); });
        const auto ask = [&](Implementation& i, const std::vector<gphys_ray>& some) {
            if (&i != &plain) return i.closest_without(some, left_out, singly);
            return singly ? i.closest_singly(some) : i.closest(some);
        };
        bench.measure(
            "query", singly ? "single_without_one" : "ray_without_one", n, entries,
            [&](Implementation& i) { return ask(i, rays) ? static_cast<double>(rays.size()) : 0; },
            [&](Implementation& i) -> std::pair<double, std::string> {
                ask(i, sample.queries);
                const std::vector<Answer> answers = i.answers();
                size_t wrong = 0;
                for (size_t k = 0; k < answers.size(); ++k) {
                    const bool is_left_out = &i != &plain && sample.truth[k].object == left_out;
                    wrong += is_left_out == (answers[k].object == sample.truth[k].object);
                }
                if (wrong > 0) return sample.wrong_fraction(wrong);
                return {0, "exact"};
            });
    }
}

}  // namespace

void solid_cases(Bench& bench) {
    for (const uint32_t n : {10000u, 100000u}) {
        if (!bench.wants(n) || (bench.quick() && n > 10000)) continue;
        hulls(bench, n);
        sweeps_at_boxes(bench, n);
        without_one(bench, n);
    }
}

}  // namespace bench
