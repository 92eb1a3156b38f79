// Bodies that collide: a rain of free particles on boxes, and a sheet over a fine mesh.
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "solver.h"

namespace bench {

namespace {

void check(gphys_status status) {
    if (status != GPHYS_OK) throw std::runtime_error(gphys_last_error());
}

struct World {
    explicit World(uint32_t substeps) {
        gphys_solver_desc desc;
        check(gphys_solver_desc_init(&desc, sizeof desc));
        desc.substeps = substeps;
        check(gphys_solver_create(&desc, &solver));
        check(gphys_scene_create(nullptr, &scene));
    }
    World(const World&) = delete;
    ~World() {
        gphys_solver_destroy(solver);
        gphys_scene_destroy(scene);
        gphys_mesh_destroy(mesh);
    }

    gphys_solver* solver = nullptr;
    gphys_scene* scene = nullptr;
    gphys_mesh* mesh = nullptr;
};

/// A ball of 4 rings^2 triangles, less those at its poles, with bumps.
gphys_mesh* bumpy_ball(uint32_t rings) {
    constexpr double pi = 3.14159265358979;
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
    const uint32_t columns = 2 * rings;
    for (uint32_t ring = 0; ring <= rings; ++ring) {
        for (uint32_t column = 0; column < columns; ++column) {
            const double down = pi * ring / rings, around = 2 * pi * column / columns;
            const double radius = 0.5 * (1 + 0.12 * std::sin(3 * down) * std::sin(4 * around));
            for (const double x :
                 {std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)}) {
                vertices.push_back(static_cast<float>(radius * x));
            }
            if (ring == 0) continue;
            const uint32_t right = (column + 1) % columns, above = (ring - 1) * columns, below = ring * columns;
            if (ring > 1) indices.insert(indices.end(), {above + column, above + right, below + column});
            if (ring < rings) indices.insert(indices.end(), {above + right, below + right, below + column});
        }
    }
    gphys_mesh* mesh = nullptr;
    check(gphys_mesh_create(nullptr, vertices.data(), 0, static_cast<uint32_t>(vertices.size() / 3), indices.data(),
                            static_cast<uint32_t>(indices.size()), &mesh));
    return mesh;
}

double median_step(const World& world, double seconds) {
    std::vector<double> times;
    for (int i = 0; i < std::lround(seconds / frame); ++i) {
        const double start = seconds_of_thread();
        check(gphys_solver_step(world.solver, world.scene, static_cast<float>(frame)));
        times.push_back(seconds_of_thread() - start);
    }
    std::nth_element(times.begin(), times.begin() + static_cast<long>(times.size() / 2), times.end());
    return times[times.size() / 2];
}

}  // namespace

SceneResult rain_on_boxes(uint32_t particles, uint32_t boxes, double seconds) {
    World world(1);
    std::mt19937 random(1);
    const auto uniform = [&](double low, double high) {
        return static_cast<float>(std::uniform_real_distribution<double>(low, high)(random));
    };
    for (uint32_t i = 0; i < boxes; ++i) {
        const float x = uniform(0, 100), z = uniform(0, 100), height = uniform(0.5, 5);
        const gphys_aabb box{{x - 1, 0, z - 1}, {x + 1, height, z + 1}};
        gphys_model_id model = 0;
        check(gphys_scene_add(world.scene, GPHYS_SHAPE_AABB, &box, nullptr, nullptr, &model));
    }
    const gphys_plane ground{{0, 1, 0}, 0};
    gphys_model_id model = 0;
    check(gphys_scene_add(world.scene, GPHYS_SHAPE_PLANE, &ground, nullptr, nullptr, &model));
    // A body is a cloud of a thousand, as an emitter makes them.
    constexpr uint32_t cloud = 1000;
    std::vector<gphys_vec3> points(cloud);
    for (uint32_t first = 0; first < particles; first += cloud) {
        const float x = uniform(0, 98), y = uniform(3, 20), z = uniform(0, 98);
        for (gphys_vec3& p : points) p = {x + uniform(0, 2), y + uniform(0, 2), z + uniform(0, 2)};
        gphys_body_id body = 0;
        check(gphys_solver_add_particles(world.solver, nullptr, points.data(), 0, cloud, &body));
    }
    return {median_step(world, seconds), 0, 0};
}

SceneResult drape_over_mesh(uint32_t columns, uint32_t substeps, double seconds) {
    World world(substeps);
    world.mesh = bumpy_ball(133);
    gphys_model_id model = 0;
    check(gphys_scene_add(world.scene, GPHYS_SHAPE_MESH, world.mesh, nullptr, nullptr, &model));
    gphys_body_desc desc;
    check(gphys_body_desc_init(&desc, sizeof desc));
    desc.damping = 1;
    desc.cloth_flags = 0;
    const gphys_vec3 corner{-1, 0.6f, -1}, u{2, 0, 0}, v{0, 0, 2};
    gphys_body_id body = 0;
    check(gphys_solver_add_cloth(world.solver, &desc, &corner, &u, &v, columns, columns, &body));
    const double step = median_step(world, seconds);
    gphys_solver_stats stats;
    check(gphys_solver_get_stats(world.solver, body, &stats));
    return {step, stats.strain_max, stats.strain_rms};
}

}  // namespace bench
