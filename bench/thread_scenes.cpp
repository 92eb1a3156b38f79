// What threads gain in scenes with many bodies and with one large body. Solvers with one worker and with several move
// the same scene by turns, and the time is that of the clock on the wall. All must end with the same bits. A run writes
// a row for each scene to standard output:
//   gamephys_bench_threads [--only NAME] [--frames N] [--substeps N] [--workers N]
// "ratio" is the median over frames of the time with one worker divided by that with several. "apart" is the same for
// as many copies of the scene that have one worker each, on threads of their own: what the machine has to give.
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <thread>

#include "solver_world.h"

namespace {

double wall() {
    timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Moving {
    gphys_model_id model;
    gphys_vec3 from, speed;
};

/// A world, and what moves in it.
struct Stage {
    Stage(uint32_t substeps, uint32_t workers) : world(substeps) {
        check(gphys_solver_set_worker_count(world.solver, workers));
    }

    gphys_body_id add_sheet(gphys_vec3 corner, gphys_vec3 u, gphys_vec3 v, uint32_t columns, uint32_t rows) {
        gphys_body_id id = 0;
        check(gphys_solver_add_cloth(world.solver, &world.body, &corner, &u, &v, columns, rows, &id));
        world.bodies.push_back(id);
        sizes.push_back(columns * rows);
        return id;
    }
    void add_rope(const std::vector<gphys_vec3>& points) {
        world.add_rope(points);
        sizes.push_back(static_cast<uint32_t>(points.size()));
    }
    void add_particles(const std::vector<gphys_vec3>& points) {
        require_distinct(points);
        world.add_particles(points);
        sizes.push_back(static_cast<uint32_t>(points.size()));
    }
    double step(int i) {
        const float time = static_cast<float>(i) * frame;
        for (const Moving& m : moving) {
            const gphys_transform place{
                {m.from.x + m.speed.x * time, m.from.y + m.speed.y * time, m.from.z + m.speed.z * time},
                {0, 0, 0, 1},
                1};
            check(gphys_scene_set_transform(world.scene, m.model, &place));
        }
        const double begin = wall();
        check(gphys_solver_step(world.solver, world.scene, frame_time(i)));
        return 1e3 * (wall() - begin);
    }
    std::vector<gphys_vec3> all_positions() const {
        std::vector<gphys_vec3> all;
        for (size_t i = 0; i < sizes.size(); ++i) {
            const std::vector<gphys_vec3> of_body = world.positions(world.bodies[i], sizes[i]);
            all.insert(all.end(), of_body.begin(), of_body.end());
        }
        return all;
    }

    World world;
    std::vector<uint32_t> sizes;
    std::vector<Moving> moving;
};

void hang(Stage& stage, uint32_t side) {
    const gphys_body_id sheet = stage.add_sheet({-1, 0, -1}, {2, 0, 0}, {0, 0, 2}, side, side);
    check(gphys_solver_set_pinned(stage.world.solver, sheet, 0, 1, 1));
    check(gphys_solver_set_pinned(stage.world.solver, sheet, side - 1, 1, 1));
}

void drape(Stage& stage, uint32_t side) {
    const gphys_sphere ball{{0, 0, 0}, 0.5f};
    stage.world.add(GPHYS_SHAPE_SPHERE, &ball);
    stage.add_sheet({-1, 0.51f, -1}, {2, 0, 0}, {0, 0, 2}, side, side);
}

/// Capes of 15 x 20 on capsules that walk at 1.5 m/s.
void add_characters(Stage& stage) {
    const gphys_capsule figure{{0, 0.3f, 0}, {0, 1.5f, 0}, 0.25f};
    for (int i = 0; i < 100; ++i) {
        const gphys_vec3 at{2.0f * static_cast<float>(i % 10), 0, 2.0f * static_cast<float>(i / 10)};
        const gphys_transform place{at, {0, 0, 0, 1}, 1};
        const gphys_model_id model = stage.world.add(GPHYS_SHAPE_CAPSULE, &figure, &place);
        stage.moving.push_back({model, at, {0, 0, -1.5f}});
        const gphys_body_id cape =
            stage.add_sheet({at.x - 0.4f, 1.5f, at.z + 0.28f}, {0.8f, 0, 0}, {0, -1.1f, 0.1f}, 15, 20);
        for (uint32_t p = 0; p < 15; ++p)
            check(gphys_solver_attach(stage.world.solver, stage.world.scene, cape, p, model, nullptr));
    }
}

/// Ropes of 30 links that fall over spheres.
void add_ropes(Stage& stage) {
    for (int i = 0; i < 1000; ++i) {
        const float x = 4 * static_cast<float>(i % 25), z = 0.5f * static_cast<float>(i / 25);
        const gphys_sphere sphere{{x + 1.5f, -0.5f, z}, 0.2f};
        stage.world.add(GPHYS_SHAPE_SPHERE, &sphere);
        std::vector<gphys_vec3> points;
        for (int k = 0; k <= 30; ++k) points.push_back({x + 0.1f * static_cast<float>(k), 0, z});
        stage.add_rope(points);
    }
}

/// 10 000 balls that collide with each other, poured into a pit.
void add_balls(Stage& stage) {
    stage.world.body.radius = 0.05f;
    stage.world.body.self_collision = 1;
    for (const gphys_plane& plane :
         {gphys_plane{{0, 1, 0}, 0}, gphys_plane{{1, 0, 0}, -1.5f}, gphys_plane{{-1, 0, 0}, -1.5f},
          gphys_plane{{0, 0, 1}, -1.5f}, gphys_plane{{0, 0, -1}, -1.5f}}) {
        stage.world.add(GPHYS_SHAPE_PLANE, &plane);
    }
    Numbers numbers(2);
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 10000; ++i) {
        const auto near = [&](int cell) {
            return static_cast<float>(cell) * 0.14f - 1.33f + numbers.between(-0.01f, 0.01f);
        };
        const float x = near(i % 20), z = near(i / 20 % 20);
        points.push_back({x, 0.2f + 0.14f * static_cast<float>(i / 400), z});
    }
    stage.add_particles(points);
}

/// 100,000 particles that land on a terrain.
void add_rain(Stage& stage) {
    stage.world.add_valley(100, 100, -3);
    Numbers numbers(3);
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 100000; ++i)
        points.push_back({numbers.between(-40, 40), numbers.between(0, 2), numbers.between(-40, 40)});
    stage.add_particles(points);
}

struct Scene {
    const char* name;
    int frames;
    std::function<void(Stage&)> make;
};

const Scene scenes[] = {
    {"characters", 120, add_characters},
    {"ropes_on_spheres", 120, add_ropes},
    {"ball_pit", 60, add_balls},
    {"rain", 60, add_rain},
    {"hanging_100", 120, [](Stage& stage) { hang(stage, 100); }},
    {"hanging_150", 60, [](Stage& stage) { hang(stage, 150); }},
    {"hanging_200", 60, [](Stage& stage) { hang(stage, 200); }},
    {"hanging_300", 60, [](Stage& stage) { hang(stage, 300); }},
    {"draped_100", 120, [](Stage& stage) { drape(stage, 100); }},
    {"draped_150", 60, [](Stage& stage) { drape(stage, 150); }},
    {"draped_200", 60, [](Stage& stage) { drape(stage, 200); }},
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// Milliseconds of all frames of a copy on this thread, beside others.
double run_beside_others(const Scene& scene, uint32_t substeps, int frames, uint32_t others) {
    const auto run = [&] {
        Stage stage(substeps, 1);
        scene.make(stage);
        double sum = 0;
        for (int i = 0; i < frames; ++i) sum += stage.step(i);
        return sum;
    };
    std::vector<std::thread> threads;
    for (uint32_t i = 0; i < others; ++i) threads.emplace_back(run);
    const double time = run();
    for (std::thread& thread : threads) thread.join();
    return time;
}

void run_scene(const Scene& scene, const Options& options) {
    const int frames = options.frames > 0 ? options.frames : scene.frames;
    Stage alone(options.substeps, 1), together(options.substeps, options.workers);
    scene.make(alone);
    scene.make(together);
    std::vector<double> one, several, ratios;
    for (int i = 0; i < frames; ++i) {
        one.push_back(alone.step(i));
        several.push_back(together.step(i));
        ratios.push_back(one.back() / several.back());
    }
    const std::vector<gphys_vec3> a = alone.all_positions(), b = together.all_positions();
    if (std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) != 0)
        throw std::runtime_error(std::string(scene.name) + ": the bits depend on the number of workers");
    const double apart =
        mean(one) * frames * options.workers / run_beside_others(scene, options.substeps, frames, options.workers - 1);
    std::printf("%-17s %8.2f %8.2f | %5.2f %5.2f | %u\n", scene.name, mean(one), mean(several), median(ratios), apart,
                alone.world.contacts());
}

}  // namespace

int main(int count, char** arguments) {
    const Options options(count, arguments);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    try {
        std::printf("scene             ms mean, 1 worker and %u | ratio apart | contacts\n", options.workers);
        for (const Scene& scene : scenes) {
            if (options.wants(scene.name)) run_scene(scene, options);
        }
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
}
