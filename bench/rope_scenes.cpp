// Ropes in scenes, with default settings: what models that they do not touch cost, what those cost that they touch, and
// laws that have a closed form. Strain is measured here, from positions, as how much too long and how much too short
// links are. A run writes tables to standard output:
//   gamephys_bench_ropes [--only NAME] [--frames N] [--substeps N]
#include <cstdio>
#include <functional>

#include "solver_world.h"

namespace {

constexpr double pi = 3.14159265358979323846, gravity = 9.81;

// 1000 ropes of 30 links, 3 m long, that fall from level over what is there.

constexpr uint32_t rope_links = 30;
constexpr float link_length = 0.1f;

std::vector<gphys_vec3> rope_at(float x, float y, float z, uint32_t links) {
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i <= links; ++i) points.push_back({x + link_length * static_cast<float>(i), y, z});
    return points;
}

struct RopeScene {
    const char* name;
    uint32_t ropes, links;
    bool pinned;  // at the first particle
    std::function<void(World&)> make;
};

void add_grid(World& world, float below, bool spheres, float beside) {
    for (int row = 0; row < 40; ++row) {
        for (int column = 0; column < 25; ++column) {
            const gphys_vec3 at{static_cast<float>(column) * 4 + 1.5f, -below, static_cast<float>(row) * 0.5f + beside};
            if (spheres) {
                const gphys_sphere sphere{at, 0.2f};
                world.add(GPHYS_SHAPE_SPHERE, &sphere);
            } else {
                const gphys_aabb box{{at.x - 0.2f, at.y - 0.2f, at.z - 0.2f}, {at.x + 0.2f, at.y + 0.2f, at.z + 0.2f}};
                world.add(GPHYS_SHAPE_AABB, &box);
            }
        }
    }
}

void add_ground(World& world, float below) {
    const gphys_plane plane{{0, 1, 0}, -below};
    world.add(GPHYS_SHAPE_PLANE, &plane);
}

const RopeScene rope_scenes[] = {
    {"empty", 1000, rope_links, true, [](World&) {}},
    {"plane_100", 1000, rope_links, true, [](World& world) { add_ground(world, 100); }},
    {"plane_3.5", 1000, rope_links, true, [](World& world) { add_ground(world, 3.5f); }},
    {"plane_1.5", 1000, rope_links, true, [](World& world) { add_ground(world, 1.5f); }},
    {"box_100", 1000, rope_links, true,
     [](World& world) {
         const gphys_aabb box{{-200, -102, -200}, {200, -100, 200}};
         world.add(GPHYS_SHAPE_AABB, &box);
     }},
    {"valley", 1000, rope_links, true, [](World& world) { world.add_valley(400, 224, -60); }},
    {"ground", 1000, rope_links, false, [](World& world) { add_ground(world, 0.5f); }},
    {"on_boxes", 1000, rope_links, false, [](World& world) { add_grid(world, 0.5f, false, 0); }},
    {"on_spheres", 1000, rope_links, false, [](World& world) { add_grid(world, 0.5f, true, 0); }},
    {"by_spheres", 1000, rope_links, true, [](World& world) { add_grid(world, 0.5f, true, 0.25f + 0.2f); }},
    {"on_valley", 1000, rope_links, false, [](World& world) { world.add_valley(400, 224, -3); }},
    {"one_touches", 1000, rope_links, true,
     [](World& world) {
         const gphys_sphere sphere{{1.5f, -0.5f, 0}, 0.2f};
         world.add(GPHYS_SHAPE_SPHERE, &sphere);
     }},
    {"long_empty", 1, 1000, true, [](World&) {}},
    {"long_on_boxes", 1, 1000, false, [](World& world) { add_grid(world, 0.5f, false, 0); }},
};

void run_ropes(const RopeScene& scene, const Options& options) {
    World world(options.substeps);
    world.body.radius = 0.02f;
    world.body.mass = 0.1f * static_cast<float>(scene.links);
    scene.make(world);
    for (uint32_t r = 0; r < scene.ropes; ++r) {
        const gphys_body_id rope =
            world.add_rope(rope_at(static_cast<float>(r % 25) * 4, 0, static_cast<float>(r / 25) * 0.5f, scene.links));
        if (scene.pinned) check(gphys_solver_set_pinned(world.solver, rope, 0, 1, 1));
    }
    double stretch = 0, compression = 0;
    const auto measure = [&] {
        for (uint32_t r = 0; r<scene.ropes; r += scene.ropes> 20 ? 7 : 1) {
            const std::vector<gphys_vec3> at = world.positions(world.bodies[r], scene.links + 1);
            for (uint32_t i = 0; i < scene.links; ++i) {
                const double part = distance(at[i], at[i + 1]) / link_length - 1;
                stretch = std::max(stretch, part);
                compression = std::max(compression, -part);
            }
        }
    };
    const int frames = options.frames > 0 ? options.frames : 90;
    const Times times = summary(step_frames(world, frames, [&](int i) {
        if (i > 0) measure();
    }));
    measure();
    std::printf("%-14s %7.2f %7.2f %7.2f | %8.4f %8.4f | %u\n", scene.name, times.mean, times.p99, times.worst,
                100 * stretch, 100 * compression, world.contacts());
}

// Capsules as wide as a person that walk in circles at 1 m/s among ropes: hanging ones, as in a forest of vines, or
// short ones at rest on the ground.

struct WalkScene {
    const char* name;
    bool hanging;
    uint32_t walkers;
    std::function<void(World&)> ground;
};

void add_slab(World& world) {
    const gphys_aabb slab{{-30, -1, -30}, {30, 0, 30}};
    world.add(GPHYS_SHAPE_AABB, &slab);
}

const WalkScene walk_scenes[] = {
    {"hanging", true, 0, [](World& world) { add_ground(world, 0); }},
    {"hanging_walk", true, 40, [](World& world) { add_ground(world, 0); }},
    {"hanging_mesh", true, 40, [](World& world) { world.add_valley(60, 60, -2.2f); }},
    {"lying", false, 0, add_slab},
    {"lying_walk_1", false, 1, add_slab},
    {"lying_walk", false, 40, add_slab},
};

void run_walkers(const WalkScene& scene, const Options& options) {
    World world(options.substeps);
    world.body.radius = 0.02f;
    scene.ground(world);
    const uint32_t links = scene.hanging ? 20 : 10, across = scene.hanging ? 20 : 32,
                   ropes = scene.hanging ? 400 : 1000;
    const float length = scene.hanging ? 0.1f : 0.05f, apart = scene.hanging ? 1.0f : 0.6f;
    for (uint32_t r = 0; r < ropes; ++r) {
        const float x = static_cast<float>(r % across) * apart - 9.6f,
                    z = static_cast<float>(r / across) * apart - 9.6f;
        std::vector<gphys_vec3> points;
        for (uint32_t i = 0; i <= links; ++i) {
            const float way = length * static_cast<float>(i);
            points.push_back(scene.hanging ? gphys_vec3{x, 2.5f - way, z} : gphys_vec3{x + way, 0.03f, z});
        }
        const gphys_body_id rope = world.add_rope(points);
        if (scene.hanging) check(gphys_solver_set_pinned(world.solver, rope, 0, 1, 1));
    }
    const gphys_capsule person{{0, 0.2f, 0}, {0, 1.7f, 0}, 0.2f};
    std::vector<gphys_model_id> walkers;
    for (uint32_t i = 0; i < scene.walkers; ++i) walkers.push_back(world.add(GPHYS_SHAPE_CAPSULE, &person));
    const auto walk = [&](int frame) {
        for (size_t k = 0; k < walkers.size(); ++k) {
            const double share = (static_cast<double>(k) + 1) / static_cast<double>(walkers.size());
            const double away = 9 * (0.1 + 0.9 * share), angle = frame / (60.0 * away) + 14 * pi * share;
            const gphys_transform at{
                {static_cast<float>(away * std::cos(angle)), 0, static_cast<float>(away * std::sin(angle))},
                {0, 0, 0, 1},
                1};
            check(gphys_scene_set_transform(world.scene, walkers[k], &at));
        }
    };
    walk(0);
    for (int i = 0; i < 60; ++i) check(gphys_solver_step(world.solver, world.scene, frame_time(i)));
    const uint32_t still = world.contacts();
    uint32_t most = still;
    double strain = 0;
    const Times times = summary(step_frames(world, options.frames > 0 ? options.frames : 400, [&](int i) {
        walk(i + 1);
        if (i % 10 > 0) return;
        gphys_solver_stats stats;
        check(gphys_solver_get_stats(world.solver, 0, &stats));
        strain = std::max(strain, double{stats.strain_max});
        most = std::max(most, world.contacts());
    }));
    if (scene.walkers > 0 && scene.hanging && most == 0) throw std::runtime_error("walkers touched no rope");
    if (!scene.hanging && still < ropes * links) throw std::runtime_error("ropes do not lie on the ground");
    std::printf("%-14s %7.2f %7.2f %7.2f | %8.4f | %u to %u\n", scene.name, times.mean, times.p99, times.worst,
                100 * strain, still, most);
}

// Ropes that hang on models. "hair": 2000 strands of 12 particles on a head that sways and turns, "hair_collides" with
// the head as an obstacle, "pinned" with their roots pinned beside a still head. "lamps": 400 cords of 16 under a
// ceiling, with the ceiling as an obstacle.

struct HangScene {
    const char* name;
    bool attached, collides, moves, lamps;
};
const HangScene hang_scenes[] = {
    {"hair_pinned", false, false, false, false}, {"hair_still", true, false, false, false},
    {"hair", true, false, true, false},          {"hair_collides", true, true, true, false},
    {"lamps", true, true, false, true},
};

void run_hanging(const HangScene& scene, const Options& options) {
    World world(options.substeps);
    if (!scene.collides) world.body.layers = 0;
    world.body.mass = scene.lamps ? 0.5f : 0.001f;
    world.body.radius = scene.lamps ? 0.01f : 0.002f;
    const gphys_sphere head{{0, 0, 0}, 0.12f};
    const gphys_aabb ceiling{{-10, 0.01f, -10}, {10, 0.5f, 10}};
    const gphys_model_id model =
        scene.lamps ? world.add(GPHYS_SHAPE_AABB, &ceiling) : world.add(GPHYS_SHAPE_SPHERE, &head);
    const uint32_t particles = scene.lamps ? 16 : 12;
    Numbers numbers(4);
    for (int i = 0; i < (scene.lamps ? 400 : 2000); ++i) {
        gphys_vec3 root{static_cast<float>(i % 20) - 10, 0, static_cast<float>(i / 20) - 10}, link{0.06f, -0.05f, 0};
        if (!scene.lamps) {
            const double up = numbers.between(-0.2f, 1), turn = numbers.between(0, static_cast<float>(2 * pi));
            const double side = std::sqrt(1 - up * up), x = side * std::cos(turn), z = side * std::sin(turn);
            const auto out = [&](double length) {
                return gphys_vec3{static_cast<float>(length * x), static_cast<float>(length * up),
                                  static_cast<float>(length * z)};
            };
            root = out(0.123), link = out(0.025);
        }
        std::vector<gphys_vec3> points;
        for (uint32_t k = 0; k < particles; ++k) {
            const float n = static_cast<float>(k);
            points.push_back({root.x + n * link.x, root.y + n * link.y, root.z + n * link.z});
        }
        const gphys_body_id rope = world.add_rope(points);
        if (scene.attached) {
            check(gphys_solver_attach(world.solver, world.scene, rope, 0, model, nullptr));
        } else {
            check(gphys_solver_set_pinned(world.solver, rope, 0, 1, 1));
        }
    }
    double strain = 0;
    uint32_t most = 0;
    const Times times = summary(step_frames(world, options.frames > 0 ? options.frames : 240, [&](int i) {
        const double time = i / 60.0, half = std::sin(2 * time) / 2;
        const gphys_transform at{
            {static_cast<float>(0.5 * std::sin(3 * time)), static_cast<float>(0.05 * std::sin(11 * time)), 0},
            {0, static_cast<float>(std::sin(half)), 0, static_cast<float>(std::cos(half))},
            1};
        if (scene.moves) check(gphys_scene_set_transform(world.scene, model, &at));
        if (i % 10 > 0) return;
        gphys_solver_stats stats;
        check(gphys_solver_get_stats(world.solver, 0, &stats));
        strain = std::max(strain, double{stats.strain_max});
        most = std::max(most, world.contacts());
    }));
    if (scene.collides && scene.moves && most == 0) throw std::runtime_error("no strand touched the head");
    std::printf("%-14s %7.2f %7.2f %7.2f | %8.4f | at most %u\n", scene.name, times.mean, times.p99, times.worst,
                100 * strain, most);
}

// A rope of 0.5 kg over a post, 1 kg at one end and another weight at the other (Atwood's machine). The post is fixed,
// or is raised with half the acceleration of gravity.

void run_post(bool raised, double friction, double heavy, uint32_t substeps) {
    World world(substeps);
    const float radius = 0.03f, length = 0.03f;
    const double bend = 0.3 + radius;
    gphys_capsule post{{0, 0, -2}, {0, 0, 2}, 0.3f};
    const gphys_model_id model = world.add(GPHYS_SHAPE_CAPSULE, &post);
    world.body.mass = 0.5f;
    world.body.radius = radius;
    world.body.friction = static_cast<float>(friction);
    constexpr int links = 120;
    std::vector<gphys_vec3> points;
    for (int i = 0; i <= links; ++i) {
        const double way = (i - links / 2) * double{length}, half = pi * bend / 2;
        const bool on = std::fabs(way) < half;
        points.push_back({static_cast<float>(on ? bend * std::sin(way / bend) : std::copysign(bend, way)),
                          static_cast<float>(on ? bend * std::cos(way / bend) : half - std::fabs(way)), 0});
    }
    const gphys_body_id rope = world.add_rope(points);
    const float masses[] = {1, static_cast<float>(heavy)};
    check(gphys_solver_set_masses(world.solver, rope, 0, 1, &masses[0], sizeof(float)));
    check(gphys_solver_set_masses(world.solver, rope, links, 1, &masses[1], sizeof(float)));
    // The first step is of a model at rest, so the ends are held in it.
    const auto hold = [&](uint8_t held) {
        for (const uint32_t end : {0u, static_cast<uint32_t>(links)}) {
            check(gphys_solver_set_pinned(world.solver, rope, end, 1, held));
        }
    };
    hold(1);
    check(gphys_solver_step(world.solver, world.scene, frame_time(0)));
    hold(0);
    const auto energy = [&] {
        gphys_solver_stats stats;
        check(gphys_solver_get_stats(world.solver, rope, &stats));
        return double{stats.kinetic_energy} + stats.potential_energy;
    };
    const double before = energy();
    double most = before;
    const double top = world.positions(rope, links + 1)[links].y, lift = raised ? gravity / 2 : 0;
    double height = 0;
    step_frames(world, 36, [&](int i) {
        if (!raised) most = std::max(most, energy());
        const double t = (i + 1) / 60.0;
        height = lift * t * t / 2;
        const gphys_transform at{{0, static_cast<float>(height), 0}, {0, 0, 0, 1}, 1};
        check(gphys_scene_set_transform(world.scene, model, &at));
    });
    const std::vector<gphys_vec3> at = world.positions(rope, links + 1);
    const double grip = std::exp(friction * pi);
    // Without friction the rope's own mass counts, and what has come over the post adds its weight. With friction the
    // weights alone are a bound.
    const double pull = gravity + lift, mass = 1.5 + heavy, by_metre = 0.5 / (links * double{length});
    const double rate = std::sqrt(2 * by_metre * pull / mass);
    const double exact = friction == 0 ? -(heavy - 1) / (2 * by_metre) * (std::cosh(rate * 0.6) - 1)
                                       : -std::max(0.0, pull * (heavy - grip) / (heavy + grip) * 0.18);
    std::printf("%-9s %4.1f %5.2f %3u | %8.3f %8.3f | %7.3f\n", raised ? "raised" : "fixed", friction, heavy, substeps,
                double{at[links].y} - top - height, exact, most - before);
}

// Weights at the ends of a bridge of ropes and planks would be rigid bodies; here it is a chain of heavy links.

void run_bridge(const Options& options) {
    World world(options.substeps);
    world.body.radius = 0.05f;
    world.body.mass = 30;
    constexpr uint32_t planks = 20;
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i <= planks; ++i) points.push_back({0.5f * static_cast<float>(i), 0, 0});
    const gphys_body_id bridge = world.add_rope(points);
    const gphys_vec3 near_end{9.8f, 0, 0};
    for (const uint32_t end : {0u, planks}) {
        check(gphys_solver_set_pinned(world.solver, bridge, end, 1, 1));
    }
    check(gphys_solver_set_positions(world.solver, bridge, planks, 1, &near_end, sizeof near_end));
    double stretch = 0, standing = 0;
    const Times times = summary(step_frames(world, 600, [&](int i) {
        const uint32_t under = std::min(planks - 1, 1 + static_cast<uint32_t>(i / 20));
        std::vector<gphys_vec3> forces(planks + 1, gphys_vec3{0, 0, 0});
        forces[under].y = -80 * 9.81f;
        check(gphys_solver_set_forces(world.solver, bridge, 0, planks + 1, forces.data(), sizeof forces[0]));
        const std::vector<gphys_vec3> at = world.positions(bridge, planks + 1);
        standing = 0;
        for (uint32_t k = 0; k < planks && i > 60; ++k) {
            standing = std::max(standing, std::fabs(distance(at[k], at[k + 1]) / 0.5 - 1));
        }
        stretch = std::max(stretch, standing);
    }));
    std::printf("bridge         %7.3f %7.3f %7.3f | peak %.4f %%, standing %.4f %%\n", times.mean, times.p99,
                times.worst, 100 * stretch, 100 * standing);
}

/// Frames of 4 to 40 ms: what advance leaves over has to stay below a step.
void run_advance() {
    World world(0);
    world.add_rope(rope_at(0, 0, 0, 4));
    Numbers numbers(3);
    float most = 0;
    double time = 0, steps = 0;
    float leftover = 0;
    for (int i = 0; i < 20000; ++i) {
        const float dt = numbers.between(0.004f, 0.04f);
        uint32_t made = 0;
        check(gphys_solver_advance(world.solver, nullptr, dt, &made, &leftover));
        time += double{dt};
        steps += made;
        most = std::max(most, leftover);
    }
    std::printf("advance        largest leftover %.9f of a step; time off by %.3g steps\n", double{most},
                time * 60 - steps - double{leftover});
}

}  // namespace

int main(int count, char** arguments) {
    const Options options(count, arguments);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    try {
        std::printf("ropes          ms mean     p99   worst | longer %%, shorter %% | contacts at the end\n");
        for (const RopeScene& scene : rope_scenes) {
            if (options.wants(scene.name)) run_ropes(scene, options);
        }
        std::printf("walkers        ms mean     p99   worst | strain %% | contacts\n");
        for (const WalkScene& scene : walk_scenes) {
            if (options.wants(scene.name)) run_walkers(scene, options);
        }
        std::printf("on models      ms mean     p99   worst | strain %% | contacts\n");
        for (const HangScene& scene : hang_scenes) {
            if (options.wants(scene.name)) run_hanging(scene, options);
        }
        std::printf("post  friction  kg substeps | heavy end, exact | energy gained, J\n");
        for (const uint32_t substeps : {8u, 16u, 32u}) {
            if (!options.wants("post")) break;
            run_post(false, 0, 3, substeps);
            run_post(true, 0, 3, substeps);
            run_post(false, 0, 1, substeps);
            for (const double friction : {0.1, 0.3}) {
                const double grip = std::exp(friction * pi);
                for (const double part : {0.96, 1.04, 2.0}) run_post(false, friction, grip * part, substeps);
            }
        }
        if (options.wants("bridge")) run_bridge(options);
        if (options.wants("advance")) run_advance();
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
}
