// What the benchmarks of ropes and of free particles share: a solver with a scene, input that is the same on every
// machine, and times of frames.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "measure.h"

struct Options {
    std::string only;
    uint32_t substeps = 0, workers = 2;
    int frames = 0;

    Options(int count, char** arguments) {
        for (int i = 1; i < count; ++i) {
            const std::string word = arguments[i];
            const auto value = [&] { return i + 1 < count ? arguments[++i] : ""; };
            if (word == "--only") {
                only = value();
            } else if (word == "--frames") {
                frames = std::atoi(value());
            } else if (word == "--substeps") {
                substeps = static_cast<uint32_t>(std::atoi(value()));
            } else if (word == "--workers") {
                workers = static_cast<uint32_t>(std::max(1, std::atoi(value())));
            }
        }
    }
    bool wants(const std::string& name) const { return only.empty() || name.find(only) != std::string::npos; }
};

inline double distance(const gphys_vec3& a, const gphys_vec3& b) {
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

inline void require_distinct(const std::vector<gphys_vec3>& points) {
    std::set<std::tuple<float, float, float>> seen;
    for (const gphys_vec3& p : points) seen.insert({p.x, p.y, p.z});
    if (seen.size() != points.size()) throw std::runtime_error("particles of the benchmark lie in one place");
}

struct Times {
    double mean = 0, p99 = 0, worst = 0;
};

inline Times summary(std::vector<double> times) {
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
