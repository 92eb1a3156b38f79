// Ropes and free particles in scenes, with default settings: what models that they do not touch cost, what those cost
// that they touch, and laws that have a closed form. Strain is measured here, from positions, as how much too long and
// how much too short links are. A run writes tables to standard output:
//   gamephys_bench_ropes [--only NAME] [--frames N] [--substeps N]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "measure.h"

namespace {

constexpr double pi = 3.14159265358979323846, gravity = 9.81;

struct Options {
    std::string only;
    uint32_t substeps = 0;
    int frames = 0;

    bool wants(const std::string& name) const { return only.empty() || name.find(only) != std::string::npos; }
};

double distance(const gphys_vec3& a, const gphys_vec3& b) {
    return std::hypot(double{a.x} - b.x, double{a.y} - b.y, double{a.z} - b.z);
}

/// The same numbers on every machine.
class Numbers {
public:
    explicit Numbers(uint32_t seed) : state_(seed) {}
    float between(float low, float high) {
        state_ = state_ * 1664525u + 1013904223u;
        return low + (high - low) * static_cast<float>(state_ >> 8) / static_cast<float>(1 << 24);
    }

private:
    uint32_t state_;
};

struct World {
    explicit World(uint32_t substeps) {
        gphys_solver_desc desc;
        check(gphys_solver_desc_init(&desc, sizeof desc));
        if (substeps > 0) desc.substeps = substeps;
        check(gphys_solver_create(&desc, &solver));
        check(gphys_scene_create(nullptr, &scene));
        check(gphys_body_desc_init(&body, sizeof body));
    }
    ~World() {
        gphys_solver_destroy(solver);
        gphys_scene_destroy(scene);
        gphys_mesh_destroy(mesh);
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    gphys_model_id add(gphys_shape_type type, const void* shape, const gphys_transform* place = nullptr) {
        gphys_model_id model = 0;
        check(gphys_scene_add(scene, type, shape, place, nullptr, &model));
        return model;
    }
    /// A terrain of size x size metres, `height` + 2 sin(x / 8) cos(z / 8) high.
    gphys_model_id add_valley(float size, uint32_t cells, float height) {
        std::vector<gphys_vec3> vertices;
        std::vector<uint32_t> triangles;
        for (uint32_t row = 0; row <= cells; ++row) {
            for (uint32_t column = 0; column <= cells; ++column) {
                const float x = size * (static_cast<float>(column) / static_cast<float>(cells) - 0.5f);
                const float z = size * (static_cast<float>(row) / static_cast<float>(cells) - 0.5f);
                const float edge = std::max(std::fabs(x), std::fabs(z)) > 0.48f * size ? 100.0f : 0.0f;
                vertices.push_back({x, height + edge + 2 * std::sin(x / 8) * std::cos(z / 8), z});
                if (row == cells || column == cells) continue;
                const uint32_t a = row * (cells + 1) + column, b = a + cells + 1;
                for (const uint32_t corner : {a, b, a + 1, a + 1, b, b + 1}) triangles.push_back(corner);
            }
        }
        return add_mesh(vertices, triangles);
    }
    gphys_model_id add_mesh(const std::vector<gphys_vec3>& vertices, const std::vector<uint32_t>& triangles) {
        check(gphys_mesh_create(nullptr, &vertices[0].x, sizeof vertices[0], static_cast<uint32_t>(vertices.size()),
                                triangles.data(), static_cast<uint32_t>(triangles.size()), &mesh));
        gphys_model_id model = 0;
        check(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, nullptr, nullptr, &model));
        return model;
    }
    gphys_body_id add_rope(const std::vector<gphys_vec3>& points) {
        gphys_body_id id = 0;
        check(gphys_solver_add_rope(solver, &body, points.data(), sizeof points[0],
                                    static_cast<uint32_t>(points.size()), 0, &id));
        bodies.push_back(id);
        return id;
    }
    gphys_body_id add_particles(const std::vector<gphys_vec3>& points) {
        gphys_body_id id = 0;
        check(gphys_solver_add_particles(solver, &body, points.data(), sizeof points[0],
                                         static_cast<uint32_t>(points.size()), &id));
        bodies.push_back(id);
        return id;
    }
    std::vector<gphys_vec3> positions(gphys_body_id id, uint32_t count) const {
        std::vector<gphys_vec3> out(count);
        check(gphys_solver_get_positions(solver, id, 0, count, out.data(), sizeof out[0]));
        return out;
    }
    uint32_t contacts() const {
        uint32_t sum = 0;
        for (const gphys_body_id id : bodies) {
            gphys_solver_stats stats;
            check(gphys_solver_get_stats(solver, id, &stats));
            sum += stats.contact_count;
        }
        return sum;
    }

    gphys_solver* solver = nullptr;
    gphys_scene* scene = nullptr;
    gphys_mesh* mesh = nullptr;
    gphys_body_desc body{};
    std::vector<gphys_body_id> bodies;
};

void require_distinct(const std::vector<gphys_vec3>& points) {
    std::set<std::tuple<float, float, float>> seen;
    for (const gphys_vec3& p : points) seen.insert({p.x, p.y, p.z});
    if (seen.size() != points.size()) throw std::runtime_error("particles of the benchmark lie in one place");
}

struct Times {
    double mean = 0, p99 = 0, worst = 0;
};

Times summary(std::vector<double> times) {
    Times out;
    for (const double t : times) out.mean += t / static_cast<double>(times.size());
    std::sort(times.begin(), times.end());
    out.p99 = times[static_cast<size_t>(0.99 * static_cast<double>(times.size() - 1))];
    out.worst = times.back();
    return out;
}

template <class Act>
std::vector<double> step_frames(World& world, int frames, Act&& act, float time_of(long) = frame_time) {
    std::vector<double> times;
    for (int i = 0; i < frames; ++i) {
        act(i);
        const double begin = now();
        check(gphys_solver_step(world.solver, world.scene, time_of(i)));
        times.push_back(1e3 * (now() - begin));
    }
    return times;
}

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

// 10 000 free particles in a box of triangles.

void run_particles(const char* name, double turning, bool lying, const Options& options,
                   float time_of(long) = frame_time) {
    World world(options.substeps);
    world.body.radius = 0.02f;
    const std::vector<gphys_vec3> corners{{-3, -3, -3}, {3, -3, -3}, {-3, 3, -3}, {3, 3, -3},
                                          {-3, -3, 3},  {3, -3, 3},  {-3, 3, 3},  {3, 3, 3}};
    const uint32_t sides[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    std::vector<gphys_vec3> vertices;
    std::vector<uint32_t> triangles;
    constexpr uint32_t cells = 20;
    for (const auto& side : sides) {
        const uint32_t first = static_cast<uint32_t>(vertices.size());
        for (uint32_t i = 0; i <= cells; ++i) {
            for (uint32_t j = 0; j <= cells; ++j) {
                const float u = static_cast<float>(i) / cells, v = static_cast<float>(j) / cells;
                const gphys_vec3 &a = corners[side[0]], &b = corners[side[1]], &d = corners[side[3]];
                vertices.push_back({a.x + (b.x - a.x) * u + (d.x - a.x) * v, a.y + (b.y - a.y) * u + (d.y - a.y) * v,
                                    a.z + (b.z - a.z) * u + (d.z - a.z) * v});
                if (i == cells || j == cells) continue;
                const uint32_t p = first + i * (cells + 1) + j, q = p + cells + 1;
                for (const uint32_t corner : {p, q, p + 1, p + 1, q, q + 1}) triangles.push_back(corner);
            }
        }
    }
    const gphys_model_id box = world.add_mesh(vertices, triangles);
    Numbers numbers(1);
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 10000; ++i) {
        const float y = lying ? -2.979f : numbers.between(-2, 2);
        points.push_back({numbers.between(-2, 2), y, numbers.between(-2, 2)});
    }
    require_distinct(points);
    const gphys_body_id body = world.add_particles(points);
    const int frames = options.frames > 0 ? options.frames : 90;
    const Times times = summary(step_frames(
        world, frames,
        [&](int i) {
            if (turning == 0) return;
            const double angle = turning * (i + 1) / 60;
            const gphys_transform place{
                {0, 0, 0}, {0, 0, static_cast<float>(std::sin(angle / 2)), static_cast<float>(std::cos(angle / 2))}, 1};
            check(gphys_scene_set_transform(world.scene, box, &place));
        },
        time_of));
    uint32_t outside = 0;
    const double angle = turning * frames / 60;
    for (const gphys_vec3& p : world.positions(body, 10000)) {
        const double x = std::cos(angle) * p.x + std::sin(angle) * p.y,
                     y = std::cos(angle) * p.y - std::sin(angle) * p.x;
        outside += std::max({std::fabs(x), std::fabs(y), std::fabs(double{p.z})}) > 3;
    }
    std::printf("%-14s %7.2f %7.2f %7.2f | %8.3f | %u %u\n", name, times.mean, times.p99, times.worst, times.mean / 10,
                world.contacts(), outside);
}

// A rope of 0.5 kg over a fixed post, 1 kg at one end and another weight at the other (Atwood's machine).

void run_post(const char* shape, double friction, double heavy, uint32_t substeps) {
    World world(substeps);
    const float radius = 0.03f, length = 0.03f;
    const double bend = 0.3 + radius;
    gphys_capsule post{{0, 0, -2}, {0, 0, 2}, 0.3f};
    world.add(GPHYS_SHAPE_CAPSULE, &post);
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
    const auto energy = [&] {
        gphys_solver_stats stats;
        check(gphys_solver_get_stats(world.solver, rope, &stats));
        return double{stats.kinetic_energy} + stats.potential_energy;
    };
    const double before = energy();
    double most = before;
    const double top = world.positions(rope, links + 1)[links].y;
    step_frames(world, 36, [&](int) { most = std::max(most, energy()); });
    const std::vector<gphys_vec3> at = world.positions(rope, links + 1);
    const double grip = std::exp(friction * pi);
    // Without friction the rope's own mass counts, with it that of the weights alone is a bound.
    const double mass = 1 + heavy + (friction == 0 ? 0.5 : 0);
    const double exact = -std::max(0.0, gravity * (heavy - grip) / (friction == 0 ? mass : heavy + grip) * 0.18);
    std::printf("%-9s %4.1f %5.2f %3u | %8.3f %8.3f | %7.3f\n", shape, friction, heavy, substeps,
                double{at[links].y} - top, exact, most - before);
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

// 10 000 balls that collide with each other, poured into a pit.

void run_pit(const Options& options) {
    World world(options.substeps);
    world.body.radius = 0.05f;
    world.body.self_collision = 1;
    world.body.friction = 0.3f;
    const float wide = 1.5f;
    const gphys_plane planes[] = {
        {{0, 1, 0}, 0}, {{1, 0, 0}, -wide}, {{-1, 0, 0}, -wide}, {{0, 0, 1}, -wide}, {{0, 0, -1}, -wide}};
    for (const gphys_plane& plane : planes) world.add(GPHYS_SHAPE_PLANE, &plane);
    Numbers numbers(2);
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 10000; ++i) {
        const int layer = i / 400, place = i % 400;
        points.push_back({static_cast<float>(place % 20) * 0.14f - 1.33f + numbers.between(-0.01f, 0.01f),
                          0.2f + static_cast<float>(layer) * 0.14f,
                          static_cast<float>(place / 20) * 0.14f - 1.33f + numbers.between(-0.01f, 0.01f)});
    }
    require_distinct(points);
    const gphys_body_id balls = world.add_particles(points);
    const int frames = options.frames > 0 ? options.frames : 180;
    double nearest = 1;
    const auto measure = [&] {
        std::vector<gphys_vec3> at = world.positions(balls, 10000);
        std::sort(at.begin(), at.end(), [](const gphys_vec3& a, const gphys_vec3& b) { return a.x < b.x; });
        for (size_t i = 0; i < at.size(); ++i) {
            for (size_t j = i + 1; j < at.size() && at[j].x - at[i].x < 0.1f; ++j) {
                nearest = std::min(nearest, distance(at[i], at[j]) / 0.1);
            }
        }
    };
    const Times times = summary(step_frames(world, frames, [&](int i) {
        if (i % 10 == 0) measure();
    }));
    const std::vector<gphys_vec3> at = world.positions(balls, 10000);
    float top = 0;
    uint32_t outside = 0;
    for (const gphys_vec3& p : at) {
        top = std::max(top, p.y);
        outside += p.y < 0 || std::fabs(p.x) > wide || std::fabs(p.z) > wide;
    }
    std::printf("ball_pit       %7.2f %7.2f %7.2f | nearest pair %.3f diameters, top %.3f m, outside %u\n", times.mean,
                times.p99, times.worst, nearest, double{top}, outside);
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
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        const auto value = [&] { return i + 1 < count ? arguments[++i] : ""; };
        if (word == "--only") {
            options.only = value();
        } else if (word == "--frames") {
            options.frames = std::atoi(value());
        } else if (word == "--substeps") {
            options.substeps = static_cast<uint32_t>(std::atoi(value()));
        }
    }
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    try {
        std::printf("ropes          ms mean     p99   worst | longer %%, shorter %% | contacts at the end\n");
        for (const RopeScene& scene : rope_scenes) {
            if (options.wants(scene.name)) run_ropes(scene, options);
        }
        std::printf("particles      ms mean     p99   worst | us a particle | contacts, outside\n");
        if (options.wants("mesh_lying")) run_particles("mesh_lying", 0, true, options);
        // Steps of equal length, which the solver leaves out once nothing moves.
        if (options.wants("mesh_steady")) {
            run_particles("mesh_steady", 0, true, options, [](long) { return frame; });
        }
        if (options.wants("mesh_still")) run_particles("mesh_still", 0, false, options);
        if (options.wants("mesh_turns_3")) run_particles("mesh_turns_3", 3, false, options);
        if (options.wants("mesh_turns_10")) run_particles("mesh_turns_10", 10, false, options);
        std::printf("post  friction  kg substeps | heavy end, exact | energy gained, J\n");
        for (const uint32_t substeps : {8u, 16u, 32u}) {
            if (!options.wants("post")) break;
            run_post("capsule", 0, 3, substeps);
            run_post("capsule", 0, 1, substeps);
            for (const double friction : {0.1, 0.3}) {
                const double grip = std::exp(friction * pi);
                for (const double part : {0.96, 1.04, 2.0}) run_post("capsule", friction, grip * part, substeps);
            }
        }
        if (options.wants("bridge")) run_bridge(options);
        if (options.wants("ball_pit")) run_pit(options);
        if (options.wants("advance")) run_advance();
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
}
