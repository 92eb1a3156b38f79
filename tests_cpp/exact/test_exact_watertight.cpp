// No ray leaves a closed mesh: from inside through edges, vertices and faces, by the mesh alone and by
// a scene of instances, one ray at a time and in batches, wherever the mesh is and whatever its size.
// The instruction set is that of GAMEPHYS_ISA; the build runs these tests on each.
#include "cases.h"
#include "meshes.h"
#include "score.h"

using namespace test;

namespace {

/// Where a closed mesh stands, as floats, and a point inside of it.
struct Solid {
    Arrays arrays;
    gphys_vec3 inside;
    double thickness;
};

/// Spheres and stretched spheres (slivers to 1e6 : 1), from millimetres to 1e7, near and far.
Solid solid(Cases& c, int levels) {
    const double size = std::pow(10.0, c.random.uniform(-3, 4));
    Vec3 scale{size, size, size}, offset;
    switch (c.random.index(4)) {
        case 0:
            break;
        case 1:
            scale.x *= 1e3;
            scale.z *= 1e-3;
            break;
        case 2:
            // As far as its shape survives the rounding of its vertices.
            offset = c.random.direction() * std::min(1e7, size * 1e4);
            break;
        default:
            offset = c.random.direction() * (3 * size);
    }
    return {sphere(levels).placed(offset, scale), narrow(offset), std::min(scale.x, scale.z)};
}

/// Not so far that no float is inside.
gphys_transform placement(Cases& c, double thickness) {
    const double scale = std::pow(10.0, c.random.uniform(-3, 3));
    const double furthest = std::min(1e7, 1e5 * thickness * scale);
    const Vec3 position = c.random.direction() * (furthest * std::pow(10.0, c.random.uniform(-6, 0)));
    return {narrow(position), c.rotation(), static_cast<float>(scale)};
}

/// A ray from near a point inside towards an edge, a vertex or the inside of a triangle.
gphys_ray ray_out(Cases& c, const Arrays& mesh, gphys_vec3 inside, const gphys_transform* placed) {
    const uint32_t corner = 3 * c.random.index(static_cast<uint32_t>(mesh.indices.size() / 3));
    const auto vertex = [&](uint32_t i) { return mesh.vertices[mesh.indices[corner + i]]; };
    const double s = c.one_in(3) ? 0 : c.random.uniform(0, 1), t = c.one_in(3) ? c.random.uniform(0, 1 - s) : 0;
    // Unrounded, so that an instance is aimed at where its own edges are.
    const Vec3 a = widen(vertex(0)), from = widen(inside);
    Vec3 target = a + (widen(vertex(1)) - a) * s + (widen(vertex(2)) - a) * t;
    Vec3 origin = from + (target - from) * (c.one_in(2) ? 0 : c.random.uniform(0, .5));
    if (placed) {
        const gphys::Transform world = gphys::widen(*placed);
        target = world.apply(target);
        origin = world.apply(origin);
    }
    gphys_ray ray{narrow(origin), narrow(target - widen(narrow(origin))), INFINITY};
    if (c.one_in(4)) c.nudge(ray.direction);
    return ray;
}

constexpr uint32_t rays_in_batch = 100;

/// Asks a batch of rays of a mesh or a scene, one by one and at once.
using Ask = void (*)(const gphys_mesh* mesh, const gphys_scene* scene, const gphys_ray* rays, gphys_hit* hits);

void one_by_one(const gphys_mesh* mesh, const gphys_scene* scene, const gphys_ray* rays, gphys_hit* hits) {
    for (uint32_t i = 0; i < rays_in_batch; ++i) {
        hits[i].t = INFINITY;
        if (scene) {
            gphys_scene_raycast(scene, &rays[i], GPHYS_ALL_LAYERS, &hits[i]);
        } else {
            gphys_shape_raycast(GPHYS_SHAPE_MESH, mesh, &rays[i], &hits[i]);
        }
    }
}
void at_once(const gphys_mesh* mesh, const gphys_scene* scene, const gphys_ray* rays, gphys_hit* hits) {
    const gphys_status status = scene ? gphys_scene_raycast_batch(scene, rays, sizeof rays[0], rays_in_batch,
                                                                  GPHYS_ALL_LAYERS, hits, sizeof hits[0])
                                      : gphys_shape_raycast_batch(GPHYS_SHAPE_MESH, mesh, rays, sizeof rays[0],
                                                                  rays_in_batch, hits, sizeof hits[0]);
    if (status != GPHYS_OK) hits[0].t = INFINITY;
}
/// Leaks where a weight rounds to zero.
void without_edges(const gphys_mesh* mesh, const gphys_scene* scene, const gphys_ray* rays, gphys_hit* hits) {
    at_once(mesh, scene, rays, hits);
    for (uint32_t i = 0; i < rays_in_batch; ++i) {
        if (std::min(hits[i].u, std::min(hits[i].v, 1 - hits[i].u - hits[i].v)) < 1e-7f) hits[i].t = INFINITY;
    }
}

/// What is asked in turn, each of its own kind of place.
template <class Fill>
void count_leaks(Score& score, Cases& c, Ask ask, const gphys_mesh* mesh, const gphys_scene* scene, long batches,
                 const Fill& fill) {
    gphys_ray rays[rays_in_batch];
    gphys_hit hits[rays_in_batch];
    for (long batch = 0; batch < batches; ++batch) {
        for (gphys_ray& ray : rays) {
            // Half an ulp of a tiny distance may be no direction at all.
            do ray = fill();
            while (gphys_shape_validate(GPHYS_SHAPE_RAY, &ray) != GPHYS_OK);
        }
        ask(mesh, scene, rays, hits);
        for (uint32_t i = 0; i < rays_in_batch; ++i) score.answer(!std::isinf(hits[i].t), true, rays[i]);
    }
    c.next();
}

Score leaks_of_meshes(const char* name, Ask ask, long count) {
    Cases c(71);
    Score score(name);
    constexpr long batches = 50;
    for (long i = 0; i < count; i += batches * rays_in_batch) {
        const Solid s = solid(c, 2 + static_cast<int>(c.random.index(3)));
        gphys_mesh* mesh = nullptr;
        gphys_mesh_create(nullptr, &s.arrays.vertices[0].x, sizeof(gphys_vec3),
                          static_cast<uint32_t>(s.arrays.vertices.size()), s.arrays.indices.data(),
                          static_cast<uint32_t>(s.arrays.indices.size()), &mesh);
        count_leaks(score, c, ask, mesh, nullptr, batches, [&] { return ray_out(c, s.arrays, s.inside, nullptr); });
        gphys_mesh_destroy(mesh);
    }
    return score;
}

Score leaks_of_scenes(const char* name, Ask ask, long count) {
    Cases c(72);
    Score score(name);
    constexpr long batches = 50;
    for (long i = 0; i < count; i += batches * rays_in_batch) {
        const Solid s = solid(c, 2 + static_cast<int>(c.random.index(2)));
        gphys_mesh* mesh = nullptr;
        gphys_mesh_create(nullptr, &s.arrays.vertices[0].x, sizeof(gphys_vec3),
                          static_cast<uint32_t>(s.arrays.vertices.size()), s.arrays.indices.data(),
                          static_cast<uint32_t>(s.arrays.indices.size()), &mesh);
        gphys_scene* scene = nullptr;
        gphys_scene_create(nullptr, &scene);
        std::vector<gphys_transform> places;
        for (int k = 0; k < 20; ++k) {
            gphys_model_id model;
            places.push_back(placement(c, s.thickness));
            gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, &places.back(), nullptr, &model);
        }
        count_leaks(score, c, ask, nullptr, scene, batches, [&] {
            return ray_out(c, s.arrays, s.inside, &places[c.random.index(static_cast<uint32_t>(places.size()))]);
        });
        gphys_scene_destroy(scene);
        gphys_mesh_destroy(mesh);
    }
    return score;
}

template <class Examine>
void prove_tight(const Examine& examine, const char* single, const char* batch) {
    const long count = cases(200000, 30000000);
    for (const auto& [name, ask] : {std::pair<const char*, Ask>{single, one_by_one}, {batch, at_once}}) {
        const Score score = examine(name, ask, count);
        score.print();
        CHECK(score.kept());
    }
    CHECK_FALSE(examine("", without_edges, 20000).kept());
}

}  // namespace

TEST_CASE("no ray leaves a closed mesh", "[watertight]") {
    prove_tight(leaks_of_meshes, "rays out of a mesh", "rays out of a mesh, in batches");
}

TEST_CASE("no ray leaves a closed instance in a scene", "[watertight]") {
    prove_tight(leaks_of_scenes, "rays out of an instance", "rays out of an instance, in batches");
}
