// 10 000 free particles in scenes, with default settings: on static meshes and boxes, on models that move, and with
// each other. "slip" is how far the fastest of those that lie, which friction should hold, moves on the model. A run
// writes tables to standard output:
//   gamephys_bench_particles [--only NAME] [--frames N] [--substeps N]
#include <cstdio>

#include "solver_world.h"

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr uint32_t particle_count = 10000;
constexpr float radius = 0.02f;

/// The inside of a cube of 6 m, of 4800 triangles.
gphys_model_id add_mesh_box(World& world) {
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
    return world.add_mesh(vertices, triangles);
}

/// A slab with its upper side where the floor of that cube is.
gphys_model_id add_slab(World& world) {
    const gphys_aabb slab{{-3, -3.5f, -3}, {3, -3, 3}};
    return world.add(GPHYS_SHAPE_AABB, &slab);
}

/// A rotation about z.
gphys_transform turned(double angle) {
    return {{0, 0, 0}, {0, 0, static_cast<float>(std::sin(angle / 2)), static_cast<float>(std::cos(angle / 2))}, 1};
}

struct Scene {
    const char* name;
    bool lying;  // at first, on the floor
    gphys_model_id (*add)(World&);
    gphys_transform (*place)(double time);  // of that model; null if it does not move
    int walkers;                            // capsules that walk through the particles in circles, at up to 1.5 m/s
    bool equal_steps;
};

gphys_transform lift(double t) {
    return {{0, static_cast<float>(0.5 * (1 - std::cos(2 * pi * t / 3))), 0}, {0, 0, 0, 1}, 1};
}
/// Speeds up at 2 m/s^2 for a second, then brakes.
gphys_transform truck(double t) {
    const double x = t < 1 ? t * t : 1 + 2 * (t - 1) - (t - 1) * (t - 1);
    return {{static_cast<float>(x), 0, 0}, {0, 0, 0, 1}, 1};
}
/// Rolls to 15 degrees and back in three seconds.
gphys_transform deck(double t) { return turned(pi / 24 * (1 - std::cos(2 * pi * t / 3))); }
/// Speeds up at 0.7 rad/s^2.
gphys_transform roundabout(double t) {
    const double angle = 0.35 * t * t;
    return {{0, 0, 0}, {0, static_cast<float>(std::sin(angle / 2)), 0, static_cast<float>(std::cos(angle / 2))}, 1};
}
gphys_transform turns_at_3(double t) { return turned(3 * t); }
gphys_transform turns_at_10(double t) { return turned(10 * t); }

constexpr Scene scenes[] = {
    {"mesh_lying", true, add_mesh_box, nullptr, 0, false},
    {"mesh_steady", true, add_mesh_box, nullptr, 0, true},
    {"mesh_falling", false, add_mesh_box, nullptr, 0, false},
    {"mesh_walker", true, add_mesh_box, nullptr, 1, false},
    {"slab_walker", true, add_slab, nullptr, 1, false},
    {"mesh_crowd", true, add_mesh_box, nullptr, 40, false},
    {"slab_crowd", true, add_slab, nullptr, 40, false},
    {"mesh_lift", true, add_mesh_box, lift, 0, false},
    {"slab_lift", true, add_slab, lift, 0, false},
    {"mesh_truck", true, add_mesh_box, truck, 0, false},
    {"slab_truck", true, add_slab, truck, 0, false},
    {"mesh_deck", true, add_mesh_box, deck, 0, false},
    {"mesh_roundabout", true, add_mesh_box, roundabout, 0, false},
    {"mesh_turns_3", false, add_mesh_box, turns_at_3, 0, false},
    {"mesh_turns_10", false, add_mesh_box, turns_at_10, 0, false},
};

gphys_vec3 conjugate_rotate(const gphys_quat& q, const gphys_vec3& v) {
    const double x = -q.x, y = -q.y, z = -q.z, w = q.w;
    const double cx = y * v.z - z * v.y + w * v.x, cy = z * v.x - x * v.z + w * v.y, cz = x * v.y - y * v.x + w * v.z;
    return {static_cast<float>(v.x + 2 * (y * cz - z * cy)), static_cast<float>(v.y + 2 * (z * cx - x * cz)),
            static_cast<float>(v.z + 2 * (x * cy - y * cx))};
}

/// Places relative to the model.
std::vector<gphys_vec3> relative_places(const World& world, gphys_body_id body, const gphys_transform& place) {
    std::vector<gphys_vec3> out = world.positions(body, particle_count);
    for (gphys_vec3& p : out) {
        p = conjugate_rotate(place.rotation, {p.x - place.position.x, p.y - place.position.y, p.z - place.position.z});
    }
    return out;
}

void run_scene(const Scene& scene, const Options& options) {
    World world(options.substeps);
    world.body.radius = radius;
    world.body.friction = 0.6f;
    const gphys_model_id model = scene.add(world);
    Numbers numbers(1);
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i < particle_count; ++i) {
        const float y = scene.lying ? -2.979f : numbers.between(-2, 2);
        points.push_back({numbers.between(-2, 2), y, numbers.between(-2, 2)});
    }
    require_distinct(points);
    const gphys_body_id body = world.add_particles(points);
    const float thick = scene.walkers > 1 ? 0.1f : 0.3f;
    const gphys_capsule legs{{0, -3 + thick, 0}, {0, -1.3f, 0}, thick};
    std::vector<gphys_model_id> walkers;
    for (int i = 0; i < scene.walkers; ++i) walkers.push_back(world.add(GPHYS_SHAPE_CAPSULE, &legs));

    const gphys_transform identity{{0, 0, 0}, {0, 0, 0, 1}, 1};
    const auto place_at = [&](int frames_done) { return scene.place ? scene.place(frames_done / 60.0) : identity; };
    constexpr int landed = 15;  // frames
    const int frames = options.frames > 0 ? options.frames : 90;
    std::vector<gphys_vec3> before;
    const Times times = summary(step_frames(
        world, frames,
        [&](int i) {
            if (i == landed) before = relative_places(world, body, place_at(i));
            const gphys_transform place = place_at(i + 1);
            if (scene.place) check(gphys_scene_set_transform(world.scene, model, &place));
            for (size_t k = 0; k < walkers.size(); ++k) {
                const double share = static_cast<double>(k + 1) / scene.walkers, away = 0.1 + 1.4 * share;
                const double angle = (i + 1) / 60.0 + 14 * pi * share;
                const gphys_transform at{
                    {static_cast<float>(away * std::cos(angle)), 0, static_cast<float>(away * std::sin(angle))},
                    {0, 0, 0, 1},
                    1};
                check(gphys_scene_set_transform(world.scene, walkers[k], &at));
            }
        },
        scene.equal_steps ? [](long) { return frame; } : frame_time));
    uint32_t outside = 0;
    double slip = 0;
    const std::vector<gphys_vec3> after = relative_places(world, body, place_at(frames));
    for (uint32_t i = 0; i < particle_count; ++i) {
        const gphys_vec3& p = after[i];
        outside += std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) > 3;
        if (scene.lying && walkers.empty() && frames > landed) slip = std::max(slip, distance(p, before[i]));
    }
    std::printf("%-15s %7.2f %7.2f %7.2f | %8.3f | %u %u %.4f\n", scene.name, times.mean, times.p99, times.worst,
                times.mean / 10, world.contacts(), outside, 1e3 * slip);
}

/// The distance of the nearest pair of balls of a diameter of `diameter`, in diameters; at most 1.
double nearest_pair(std::vector<gphys_vec3> at, float diameter) {
    double nearest = 1;
    std::sort(at.begin(), at.end(), [](const gphys_vec3& a, const gphys_vec3& b) { return a.x < b.x; });
    for (size_t i = 0; i < at.size(); ++i) {
        for (size_t j = i + 1; j < at.size() && at[j].x - at[i].x < diameter; ++j) {
            nearest = std::min(nearest, distance(at[i], at[j]) / double{diameter});
        }
    }
    return nearest;
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
    const Times times = summary(step_frames(world, frames, [&](int i) {
        if (i % 10 == 0) nearest = std::min(nearest, nearest_pair(world.positions(balls, 10000), 0.1f));
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

// 500 marbles that collide with each other, poured into a mesh: a funnel of 192 triangles that is too narrow at its end
// for all of them.

void run_funnel(const Options& options) {
    World world(options.substeps);
    world.body.radius = 0.04f;
    world.body.mass = 5;
    world.body.self_collision = 1;
    world.body.friction = 0.2f;
    world.body.restitution = 0.3f;
    const gphys_plane ground{{0, 1, 0}, 0};
    world.add(GPHYS_SHAPE_PLANE, &ground);
    constexpr uint32_t sides = 32, rings = 4;
    constexpr float profile[rings][2] = {{1.2f, 2.5f}, {0.9f, 2}, {0.15f, 1.2f}, {0.15f, 0.9f}};
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
    for (uint32_t ring = 0; ring < rings; ++ring) {
        for (uint32_t side = 0; side < sides; ++side) {
            const float angle = 2 * 3.14159265f * static_cast<float>(side) / sides, wide = profile[ring][0];
            for (const float part : {wide * std::cos(angle), profile[ring][1], wide * std::sin(angle)})
                vertices.push_back(part);
            if (ring + 1 == rings) continue;
            const uint32_t a = ring * sides + side, b = ring * sides + (side + 1) % sides;
            for (const uint32_t corner : {a, b, a + sides, b, b + sides, a + sides}) indices.push_back(corner);
        }
    }
    gphys_mesh* mesh = nullptr;
    check(gphys_mesh_create(nullptr, vertices.data(), 12, rings * sides, indices.data(),
                            static_cast<uint32_t>(indices.size()), &mesh));
    world.add(GPHYS_SHAPE_MESH, mesh);
    gphys_mesh_destroy(mesh);
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 500; ++i) {
        points.push_back({-0.5f + 0.1f * static_cast<float>(i % 10), 2.2f + 0.1f * static_cast<float>(i / 100),
                          -0.5f + 0.1f * static_cast<float>(i / 10 % 10)});
    }
    require_distinct(points);
    const gphys_body_id marbles = world.add_particles(points);
    const int frames = options.frames > 0 ? options.frames : 240;
    const Times times = summary(step_frames(world, frames, [](int) {}));
    const std::vector<gphys_vec3> at = world.positions(marbles, 500);
    uint32_t outside = 0, above = 0;
    for (const gphys_vec3& p : at) {
        const float wide = std::hypot(p.x, p.z);
        above += p.y > 1.2f;
        outside += p.y < 0 || (p.y > 1.2f && wide > 0.15f + 0.94f * (p.y - 1.2f)) || (p.y > 0.9f && wide > 1.2f);
    }
    std::printf("ball_funnel    %7.2f %7.2f %7.2f | nearest pair %.3f diameters, still above %u, outside %u\n",
                times.mean, times.p99, times.worst, nearest_pair(at, 0.08f), above, outside);
}

}  // namespace

int main(int count, char** arguments) {
    const Options options(count, arguments);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    try {
        std::printf("particles       ms mean     p99   worst | us a particle | contacts, outside, slip in mm\n");
        for (const Scene& scene : scenes) {
            if (options.wants(scene.name)) run_scene(scene, options);
        }
        if (options.wants("ball_pit")) run_pit(options);
        if (options.wants("ball_funnel")) run_funnel(options);
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
}
