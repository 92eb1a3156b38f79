// A solver and a scene with the handling around them, and what the solver's tests measure.
#pragma once

#include <cstdio>
#include <vector>

#include "test.h"

namespace test {

struct World {
    gphys_solver* solver = nullptr;
    gphys_scene* scene = nullptr;

    explicit World(uint32_t substeps = 8, gphys_vec3 gravity = {0, -9.81f, 0}) : World(desc(substeps, gravity)) {}
    explicit World(const gphys_solver_desc& desc) {
        gphys_solver_create(&desc, &solver);
        gphys_scene_create(nullptr, &scene);
    }
    World(const World&) = delete;
    ~World() {
        gphys_solver_destroy(solver);
        gphys_scene_destroy(scene);
    }

    static gphys_solver_desc desc(uint32_t substeps = 8, gphys_vec3 gravity = {0, -9.81f, 0}) {
        gphys_solver_desc desc;
        gphys_solver_desc_init(&desc, sizeof desc);
        desc.substeps = substeps;
        desc.gravity = gravity;
        return desc;
    }
    static gphys_body_desc body_desc() {
        gphys_body_desc desc;
        gphys_body_desc_init(&desc, sizeof desc);
        return desc;
    }
    gphys_body_id particles(const std::vector<gphys_vec3>& positions, const gphys_body_desc& desc = body_desc()) {
        gphys_body_id body = 0;
        REQUIRE(gphys_solver_add_particles(solver, &desc, positions.data(), 12, static_cast<uint32_t>(positions.size()),
                                           &body) == GPHYS_OK);
        return body;
    }
    gphys_body_id rope(const std::vector<gphys_vec3>& positions, float link,
                       const gphys_body_desc& desc = body_desc()) {
        gphys_body_id body = 0;
        REQUIRE(gphys_solver_add_rope(solver, &desc, positions.data(), 12, static_cast<uint32_t>(positions.size()),
                                      link, &body) == GPHYS_OK);
        return body;
    }
    gphys_body_id cloth(gphys_vec3 corner, gphys_vec3 u, gphys_vec3 v, uint32_t columns, uint32_t rows,
                        const gphys_body_desc& desc = body_desc()) {
        gphys_body_id body = 0;
        REQUIRE(gphys_solver_add_cloth(solver, &desc, &corner, &u, &v, columns, rows, &body) == GPHYS_OK);
        return body;
    }
    gphys_model_id model(gphys_shape_type type, const void* shape, const gphys_transform* transform = nullptr) {
        gphys_model_id model = 0;
        REQUIRE(gphys_scene_add(scene, type, shape, transform, nullptr, &model) == GPHYS_OK);
        return model;
    }
    /// Parallel to the axes.
    gphys_model_id box(gphys_vec3 half, gphys_vec3 at) {
        const gphys_aabb box{{-half.x, -half.y, -half.z}, half};
        const gphys_transform there{at, {0, 0, 0, 1}, 1};
        return model(GPHYS_SHAPE_AABB, &box, &there);
    }
    void pin(gphys_body_id body, uint32_t particle) {
        REQUIRE(gphys_solver_set_pinned(solver, body, particle, 1, 1) == GPHYS_OK);
    }
    void set_velocity(gphys_body_id body, uint32_t particle, gphys_vec3 velocity) {
        REQUIRE(gphys_solver_set_velocities(solver, body, particle, 1, &velocity, 12) == GPHYS_OK);
    }
    void step(float dt) { REQUIRE(gphys_solver_step(solver, scene, dt) == GPHYS_OK); }
    gphys_solver_stats stats(gphys_body_id body = 0) const {
        gphys_solver_stats stats{};
        REQUIRE(gphys_solver_get_stats(solver, body, &stats) == GPHYS_OK);
        return stats;
    }
    double energy(gphys_body_id body = 0) const {
        const gphys_solver_stats s = stats(body);
        return static_cast<double>(s.kinetic_energy) + s.potential_energy;
    }
    uint32_t substeps(gphys_body_id body) const {
        uint32_t count = 0;
        REQUIRE(gphys_solver_get_substeps(solver, body, &count) == GPHYS_OK);
        return count;
    }
    std::vector<gphys_vec3> positions(gphys_body_id body) const { return read(body, gphys_solver_get_positions); }
    std::vector<gphys_vec3> velocities(gphys_body_id body) const { return read(body, gphys_solver_get_velocities); }
    gphys::Vec3 position(gphys_body_id body, uint32_t particle = 0) const {
        return gphys::widen(positions(body)[particle]);
    }

private:
    template <class Get>
    std::vector<gphys_vec3> read(gphys_body_id body, Get&& get) const {
        gphys_body_info info{};
        REQUIRE(gphys_solver_get_body_info(solver, body, &info) == GPHYS_OK);
        std::vector<gphys_vec3> values(info.particle_count);
        REQUIRE(get(solver, body, 0, info.particle_count, values.data(), 12) == GPHYS_OK);
        return values;
    }
};

struct MeshHandle {
    gphys_mesh* mesh = nullptr;
    MeshHandle(const std::vector<float>& vertices, const std::vector<uint32_t>& indices) {
        REQUIRE(gphys_mesh_create(nullptr, vertices.data(), 12, static_cast<uint32_t>(vertices.size() / 3),
                                  indices.data(), static_cast<uint32_t>(indices.size()), &mesh) == GPHYS_OK);
    }
    MeshHandle(const MeshHandle&) = delete;
    ~MeshHandle() { gphys_mesh_destroy(mesh); }
};

inline gphys_body_desc point_mass(float radius, float friction, float restitution) {
    gphys_body_desc desc = World::body_desc();
    desc.radius = radius;
    desc.friction = friction;
    desc.restitution = restitution;
    return desc;
}

/// Of particles that collide with those of other bodies.
inline gphys_body_desc colliding(float mass, float radius) {
    gphys_body_desc desc = World::body_desc();
    desc.mass = mass;
    desc.radius = radius;
    desc.body_layers = 1;
    return desc;
}

/// `count` points, each a step from the one before.
inline std::vector<gphys_vec3> line(gphys_vec3 from, gphys_vec3 step, uint32_t count) {
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i < count; ++i) {
        const float n = static_cast<float>(i);
        points.push_back({from.x + n * step.x, from.y + n * step.y, from.z + n * step.z});
    }
    return points;
}

/// Of the last step, on eight models at most.
inline std::vector<gphys_impulse> impulses(const World& world) {
    std::vector<gphys_impulse> out(8);
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_impulses(world.solver, out.data(), 8, &total) == GPHYS_OK);
    out.resize(total);
    return out;
}

/// What a case measured, for the record.
inline void figure(const char* what, double value, const char* unit) {
    std::printf("    %s: %.4g %s\n", what, value, unit);
}

inline bool all_finite(const std::vector<gphys_vec3>& values) {
    for (const gphys_vec3& v : values) {
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return false;
    }
    return true;
}

}  // namespace test
