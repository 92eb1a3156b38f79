// What it costs to show simulated cloth and ropes in a scene: by a mesh that follows the body, against a mesh that is
// built of its positions each frame, beside the step itself; and rays at it. Frames of the ways are interleaved, so
// that all see the same motion. A row for each, to standard output:
//   gamephys_bench_shown [--quick]
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "measure.h"

namespace {

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

void row(const std::string& what, uint32_t size, const std::vector<double>& nanoseconds) {
    std::printf("%-44s %7u %12.0f ns\n", what.c_str(), size, median(nanoseconds));
}

/// A sheet that hangs from two corners over a ball, in a solver of its own: shown or not.
struct Sheet {
    explicit Sheet(uint32_t side_, bool shown) : side(side_) {
        check(gphys_scene_create(nullptr, &scene));
        check(gphys_scene_create(nullptr, &seen));
        check(gphys_solver_create(nullptr, &solver));
        const gphys_sphere ball{{0, 1, 0}, 0.6f};
        gphys_model_id ignored;
        check(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, nullptr, nullptr, &ignored));
        const gphys_vec3 corner{-1.2f, 2, -1}, u{2.4f, 0, 0}, v{0, 0, 2.4f};
        check(gphys_solver_add_cloth(solver, nullptr, &corner, &u, &v, side, side, &body));
        check(gphys_solver_set_pinned(solver, body, 0, 1, 1));
        check(gphys_solver_set_pinned(solver, body, side - 1, 1, 1));
        positions.resize(size_t{side} * side);
        uint32_t total = 0;
        gphys_solver_get_triangles(solver, body, nullptr, 0, &total);
        indices.resize(total);
        check(gphys_solver_get_triangles(solver, body, indices.data(), total, &total));
        if (!shown) return;
        gphys_mesh* mesh = nullptr;
        check(gphys_mesh_create_from_body(nullptr, solver, body, &mesh));
        check(gphys_scene_add(seen, GPHYS_SHAPE_MESH, mesh, nullptr, nullptr, &model));
        gphys_mesh_destroy(mesh);
    }
    ~Sheet() {
        gphys_solver_destroy(solver);
        gphys_scene_destroy(scene);
        gphys_scene_destroy(seen);
    }
    Sheet(const Sheet&) = delete;
    Sheet& operator=(const Sheet&) = delete;

    double step() {
        const double start = now();
        check(gphys_solver_step(solver, scene, frame_time(steps++)));
        return 1e9 * (now() - start);
    }
    /// A mesh of what it is now, in place of the one before.
    double rebuild() {
        const double start = now();
        if (model != 0) check(gphys_scene_remove(seen, model));
        const auto count = static_cast<uint32_t>(positions.size());
        check(gphys_solver_get_positions(solver, body, 0, count, positions.data(), sizeof(gphys_vec3)));
        gphys_mesh* mesh = nullptr;
        check(gphys_mesh_create(nullptr, &positions[0].x, sizeof(gphys_vec3), count, indices.data(),
                                static_cast<uint32_t>(indices.size()), &mesh));
        check(gphys_scene_add(seen, GPHYS_SHAPE_MESH, mesh, nullptr, nullptr, &model));
        gphys_mesh_destroy(mesh);
        return 1e9 * (now() - start);
    }
    /// Nanoseconds a ray; `answers` is a sum over what they met.
    double rays(const std::vector<gphys_ray>& rays, std::vector<gphys_hit>& hits, bool batch, uint64_t& answers) const {
        const auto count = static_cast<uint32_t>(rays.size());
        const double start = now();
        if (batch) {
            check(gphys_scene_raycast_batch(seen, rays.data(), sizeof(gphys_ray), count, 1, hits.data(),
                                            sizeof(gphys_hit)));
        } else {
            for (uint32_t i = 0; i < count; ++i) {
                if (gphys_scene_raycast(seen, &rays[i], 1, &hits[i]) != GPHYS_OK) hits[i].triangle = GPHYS_NO_TRIANGLE;
            }
        }
        const double took = 1e9 * (now() - start) / count;
        for (const gphys_hit& hit : hits) answers += hit.triangle;
        return took;
    }

    uint32_t side;
    gphys_scene *scene = nullptr, *seen = nullptr;  // to collide with, and to be asked
    gphys_solver* solver = nullptr;
    gphys_body_id body = 0;
    gphys_model_id model = 0;
    std::vector<gphys_vec3> positions;
    std::vector<uint32_t> indices;
    long steps = 0;
};

void measure_sheet(uint32_t side, int frames) {
    Sheet plain(side, false), shown(side, true), built(side, false);
    std::vector<double> step, step_shown, rebuild, follow, single, single_built, batch, batch_built;
    std::vector<gphys_ray> rays;
    uint32_t random = 7;
    const auto uniform = [&] {
        random = random * 1664525u + 1013904223u;
        return static_cast<float>(random >> 8) / 16777216.0f;
    };
    for (int i = 0; i < 4096; ++i) {
        const gphys_vec3 from{8 * uniform() - 4, 4 * uniform(), 8 * uniform() - 4};
        const gphys_vec3 to{2 * uniform() - 1, 0.5f + 1.5f * uniform(), 2 * uniform() - 1};
        rays.push_back({from, {to.x - from.x, to.y - from.y, to.z - from.z}, 10});
    }
    std::vector<gphys_hit> hits(rays.size());
    for (int i = 0; i < frames; ++i) {
        step.push_back(plain.step());
        step_shown.push_back(shown.step());
        follow.push_back(step_shown.back() - step.back());
        built.step();
        rebuild.push_back(built.rebuild());
        uint64_t met = 0, met_built = 0;
        single.push_back(shown.rays(rays, hits, false, met));
        single_built.push_back(built.rays(rays, hits, false, met_built));
        batch.push_back(shown.rays(rays, hits, true, met));
        batch_built.push_back(built.rays(rays, hits, true, met_built));
        if (met != met_built) throw std::runtime_error("the two meshes answer differently");
    }
    const uint32_t triangles = 2 * (side - 1) * (side - 1);
    row("a step of the cloth", triangles, step);
    row("a step that its mesh follows", triangles, step_shown);
    row("the difference", triangles, follow);
    row("a mesh built of it, as a model", triangles, rebuild);
    row("a ray at the mesh that follows", triangles, single);
    row("a ray at the mesh built anew", triangles, single_built);
    row("the same in a batch: following", triangles, batch);
    row("the same in a batch: built anew", triangles, batch_built);
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
    try {
        for (const uint32_t side : {32u, 100u}) measure_sheet(side, quick ? 5 : 120);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
