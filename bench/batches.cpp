// gamephys_bench_batches [--quick] [--scene=NAME] [--rays=NAME] [--size=N] [--out=DIR]: what a batch of rays takes
// beside the same rays one call at a time, for many ways that rays go and for scenes with something far away in them.
// With --size the rays are cast in batches of N, such as the 12 pellets of a shot. Batches decide by themselves which
// rays share a traversal, so each pair is measured. DIR/batches.csv gets a row for each; the exit status is 1 if a
// batch takes longer than its single calls or gives other answers.
#include <time.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "workload.h"

namespace bench {

namespace {

constexpr float pi = 3.14159265f;

void check(gphys_status status) {
    if (status < 0) throw std::runtime_error(gphys_last_error());
}

double processor_time() {
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

gphys_vec3 sum(gphys_vec3 a, gphys_vec3 b, float times) {
    return {a.x + times * b.x, a.y + times * b.y, a.z + times * b.z};
}
float length(gphys_vec3 a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }
gphys_vec3 unit(gphys_vec3 a) { return sum({0, 0, 0}, a, 1 / length(a)); }

/// What rays are asked of: a scene, or a mesh by itself.
struct World {
    std::string name;
    float half;     // of the side of the cube in which most of it lies
    uint32_t size;  // rays of a batch
    gphys_scene* scene = nullptr;
    gphys_mesh* mesh = nullptr;

    World(std::string n, float h, uint32_t s) : name(std::move(n)), half(h), size(s) {}
    World(const World&) = delete;
    ~World() {
        gphys_scene_destroy(scene);
        gphys_mesh_destroy(mesh);
    }

    void add(gphys_shape_type type, const void* shapes, uint32_t stride, uint32_t count) {
        if (!scene) check(gphys_scene_create(nullptr, &scene));
        std::vector<gphys_model_id> ids(count);
        check(gphys_scene_add_batch(scene, type, shapes, stride, nullptr, 0, count, nullptr, ids.data()));
    }
    void make_mesh(const Triangles& triangles) {
        check(gphys_mesh_create(nullptr, &triangles.vertices[0].x, sizeof triangles.vertices[0],
                                static_cast<uint32_t>(triangles.vertices.size()), triangles.indices.data(),
                                static_cast<uint32_t>(triangles.indices.size()), &mesh));
    }

    void one(const gphys_ray& ray, gphys_hit& hit) const {
        hit = {};
        check(mesh ? gphys_shape_raycast(GPHYS_SHAPE_MESH, mesh, &ray, &hit)
                   : gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit));
    }
    /// cast(first, count) for each batch.
    template <class Cast>
    void for_each_batch(size_t rays, const Cast& cast) const {
        for (size_t first = 0; first < rays; first += size) {
            check(cast(first, static_cast<uint32_t>(std::min<size_t>(size, rays - first))));
        }
    }
    void all(const std::vector<gphys_ray>& rays, std::vector<gphys_hit>& hits) const {
        for_each_batch(rays.size(), [&](size_t i, uint32_t count) {
            return mesh ? gphys_shape_raycast_batch(GPHYS_SHAPE_MESH, mesh, &rays[i], sizeof rays[0], count, &hits[i],
                                                    sizeof hits[0])
                        : gphys_scene_raycast_batch(scene, &rays[i], sizeof rays[0], count, GPHYS_ALL_LAYERS, &hits[i],
                                                    sizeof hits[0]);
        });
    }
    bool has_any() const { return scene != nullptr; }
    void any_one(const gphys_ray& ray, int32_t& met) const {
        check(gphys_scene_raycast_any(scene, &ray, GPHYS_ALL_LAYERS, &met));
    }
    void any_all(const std::vector<gphys_ray>& rays, std::vector<int32_t>& met) const {
        for_each_batch(rays.size(), [&](size_t i, uint32_t count) {
            return gphys_scene_raycast_any_batch(scene, &rays[i], sizeof rays[0], count, GPHYS_ALL_LAYERS, &met[i],
                                                 sizeof met[0]);
        });
    }
};

struct MakeWorld {
    const char* name;
    std::function<void(World&)> fill;
    float half;
};

void add_boxes(World& world, uint32_t count) {
    const std::vector<gphys_obb> all = boxes(count);
    world.add(GPHYS_SHAPE_OBB, all.data(), sizeof all[0], count);
}
void add_spheres(World& world, uint32_t count) {
    const std::vector<gphys_sphere> all = spheres(count);
    world.add(GPHYS_SHAPE_SPHERE, all.data(), sizeof all[0], count);
}
void add_far(World& world, float distance) {
    const gphys_sphere backdrop = {{distance, 0.2f * distance, 0}, 10};
    world.add(GPHYS_SHAPE_SPHERE, &backdrop, 0, 1);
}

/// A mesh of unit size made as large as a cube, with a triangle elsewhere if it is not at 0.
Triangles large_mesh(int level, float half, float stray) {
    Triangles mesh = bumpy_sphere(level);
    for (gphys_vec3& v : mesh.vertices) v = sum({0, 0, 0}, v, half);
    if (stray != 0) {
        const auto first = static_cast<uint32_t>(mesh.vertices.size());
        for (const gphys_vec3 v : {gphys_vec3{stray, 0, 0}, {stray, 1, 0}, {stray, 0, 1}}) mesh.vertices.push_back(v);
        for (uint32_t i = 0; i < 3; ++i) mesh.indices.push_back(first + i);
    }
    return mesh;
}

std::vector<MakeWorld> worlds(bool quick) {
    const uint32_t few = 1000, some = 10'000, many = quick ? 20'000 : 100'000;
    std::vector<MakeWorld> result = {
        {"boxes_1k", [=](World& w) { add_boxes(w, few); }, half_side(few)},
        {"boxes_1k_far_500", [=](World& w) { add_boxes(w, few), add_far(w, 500); }, half_side(few)},
        {"boxes_10k", [=](World& w) { add_boxes(w, some); }, half_side(some)},
        {"boxes_10k_far_500", [=](World& w) { add_boxes(w, some), add_far(w, 500); }, half_side(some)},
        {"boxes_10k_far_5000", [=](World& w) { add_boxes(w, some), add_far(w, 5000); }, half_side(some)},
        {"boxes_10k_far_50000", [=](World& w) { add_boxes(w, some), add_far(w, 50000); }, half_side(some)},
        {"boxes_10k_slab",
         [=](World& w) {
             add_boxes(w, some);
             const float h = half_side(some);
             const gphys_aabb slab = {{-h, -h - 1, -h}, {h, -h, h}};
             w.add(GPHYS_SHAPE_AABB, &slab, 0, 1);
         },
         half_side(some)},
        {"voxels_8k",  // boxes without rotation, some of which touch
         [](World& w) {
             constexpr int side = 24;
             std::vector<gphys_aabb> all;
             for (int i = 0; i < side * side * side; ++i) {
                 if (i * 7 % 13 > 7) continue;
                 const auto low = [](int at) { return static_cast<float>(at - side / 2); };
                 const float x = low(i % side), y = low(i / side % side), z = low(i / side / side);
                 all.push_back({{x, y, z}, {x + 1, y + 1, z + 1}});
             }
             w.add(GPHYS_SHAPE_AABB, all.data(), sizeof all[0], static_cast<uint32_t>(all.size()));
         },
         12},
        {"boxes_10k_coincident",
         [=](World& w) {
             add_boxes(w, some);
             const gphys_sphere ball = {{3, 2, 1}, 1};
             w.add(GPHYS_SHAPE_SPHERE, &ball, 0, 100);
         },
         half_side(some)},
        {"spheres_100k", [=](World& w) { add_spheres(w, many); }, half_side(many)},
        {"spheres_100k_far_50000", [=](World& w) { add_spheres(w, many), add_far(w, 50000); }, half_side(many)},
        {"mesh_82k", [=](World& w) { w.make_mesh(large_mesh(quick ? 5 : 6, 50, 0)); }, 50},
        {"mesh_82k_stray", [=](World& w) { w.make_mesh(large_mesh(quick ? 5 : 6, 50, 5000)); }, 50},
        {"mesh_82k_model",
         [=](World& w) {
             World mesh("", 0, 0);
             mesh.make_mesh(large_mesh(quick ? 5 : 6, 50, 0));
             check(gphys_scene_create(nullptr, &w.scene));
             gphys_model_id id;
             check(gphys_scene_add(w.scene, GPHYS_SHAPE_MESH, mesh.mesh, nullptr, nullptr, &id));
         },
         50},
    };
    if (!quick) {
        result.push_back({"mesh_1.3M", [](World& w) { w.make_mesh(large_mesh(8, 50, 0)); }, 50});
        result.push_back({"boxes_1M", [](World& w) { add_boxes(w, 1'000'000); }, half_side(1'000'000)});
    }
    return result;
}

/// The rays of a camera that looks at the middle from so many half sides away, row by row.
std::vector<gphys_ray> camera(float half, float away, uint32_t count) {
    const auto width = static_cast<uint32_t>(std::sqrt(4.0 * count / 3)), height = count / width;
    const gphys_vec3 eye = {-half * away, 0.3f * half * away, 0.2f * half * away};
    const gphys_vec3 forward = unit(sum({0, 0, 0}, eye, -1)), right = unit({forward.z, 0, -forward.x});
    const gphys_vec3 up = {forward.y * right.z - forward.z * right.y, forward.z * right.x - forward.x * right.z,
                           forward.x * right.y - forward.y * right.x};
    std::vector<gphys_ray> rays;
    for (uint32_t i = 0; i < width * height; ++i) {
        const float x = (static_cast<float>(i % width) + 0.5f) / static_cast<float>(width) * 2 - 1;
        const float y = 1 - (static_cast<float>(i / width) + 0.5f) / static_cast<float>(height) * 2;
        const gphys_vec3 at = sum(sum(forward, right, 0.77f * x), up, 0.577f * y);
        rays.push_back({eye, unit(at), 8 * half * away});
    }
    return rays;
}

/// A sensor of 64 beams that turns once.
std::vector<gphys_ray> lidar(gphys_vec3 eye, float reach, uint32_t count) {
    constexpr uint32_t beams = 64;
    std::vector<gphys_ray> rays;
    for (uint32_t i = 0; i + beams <= count; i += beams) {
        const float turn = 2 * pi * static_cast<float>(i) / static_cast<float>(count);
        for (uint32_t beam = 0; beam < beams; ++beam) {
            const float rise = -0.43f + 0.47f * static_cast<float>(beam) / beams;
            rays.push_back(
                {eye, {std::cos(rise) * std::cos(turn), std::sin(rise), std::cos(rise) * std::sin(turn)}, reach});
        }
    }
    return rays;
}

template <class Direction>
std::vector<gphys_ray> from_everywhere(float half, uint32_t count, float t_max, const Direction& direction) {
    Random random(777);
    std::vector<gphys_ray> rays(count);
    for (gphys_ray& ray : rays) {
        const gphys_vec3 origin = random.point(half);
        ray = {origin, direction(random, origin), t_max};
    }
    return rays;
}

struct MakeRays {
    const char* name;
    std::function<std::vector<gphys_ray>(float half, uint32_t count)> make;
};

const std::vector<MakeRays> ray_kinds = {
    {"random", [](float half, uint32_t count) { return random_rays(half, count); }},
    {"camera_near", [](float half, uint32_t count) { return camera(half, 1.05f, count); }},
    {"camera_2", [](float half, uint32_t count) { return camera(half, 2, count); }},
    {"camera_6", [](float half, uint32_t count) { return camera(half, 6, count); }},
    {"camera_20", [](float half, uint32_t count) { return camera(half, 20, count); }},
    // Where neighbours are just so far apart that sharing a traversal begins to pay.
    {"camera_6_fine", [](float half, uint32_t count) { return camera(half, 6, 8 * count); }},
    {"lidar",
     [](float half, uint32_t count) {
         return lidar({0.1f, 0.2f, 0.3f}, 2 * half, count);
     }},
    {"parallel",
     [](float half, uint32_t count) {
         return from_everywhere(half, count, 1e4f, [](Random&, gphys_vec3) { return gphys_vec3{0.36f, 0.8f, 0.48f}; });
     }},
    {"area_light",
     [](float half, uint32_t count) {
         return from_everywhere(half, count, 1e4f, [](Random& random, gphys_vec3) {
             return sum({0.36f, 0.8f, 0.48f}, random.point(0.01f), 1);
         });
     }},
    {"ground_probes",
     [](float half, uint32_t count) {
         return from_everywhere(half, count, 10, [](Random&, gphys_vec3) { return gphys_vec3{0, -1, 0}; });
     }},
    {"lines_of_sight",
     [](float half, uint32_t count) {
         return from_everywhere(half, count, 1,
                                [=](Random& random, gphys_vec3 origin) { return sum(random.point(half), origin, -1); });
     }},
    {"short",
     [](float half, uint32_t count) {
         return from_everywhere(half, count, 1, [](Random& random, gphys_vec3) { return random.direction(); });
     }},
    {"outside_missing",
     [](float half, uint32_t count) {
         std::vector<gphys_ray> rays = random_rays(half, count);
         for (gphys_ray& ray : rays) ray.origin = sum(ray.origin, unit(ray.origin), 4 * half);
         for (gphys_ray& ray : rays) ray.direction = {-ray.direction.x, -ray.direction.y, -ray.direction.z};
         return rays;
     }},
};

struct Times {
    double batch = std::numeric_limits<double>::infinity(), single = batch;  // ns a ray
    uint64_t differ = 0;
    double met = 0;  // share of the rays
};

/// The fastest of some interleaved rounds.
template <class Batch, class Single>
void time_both(Times& times, size_t count, const Batch& batch, const Single& single) {
    constexpr int rounds = 5;
    for (int round = 0; round < rounds; ++round) {
        const double begin = processor_time();
        batch();
        const double middle = processor_time();
        for (size_t i = 0; i < count; ++i) single(i);
        const double end = processor_time(), each = 1e9 / static_cast<double>(count);
        times.batch = std::min(times.batch, each * (middle - begin));
        times.single = std::min(times.single, each * (end - middle));
    }
}

Times closest(const World& world, const std::vector<gphys_ray>& rays) {
    Times times;
    std::vector<gphys_hit> batch(rays.size()), single(rays.size());
    time_both(
        times, rays.size(), [&] { world.all(rays, batch); }, [&](size_t i) { world.one(rays[i], single[i]); });
    for (size_t i = 0; i < rays.size(); ++i) {
        const bool met = single[i].model != 0 || (world.mesh && single[i].flags + single[i].t > 0);
        times.met += met ? 1.0 / static_cast<double>(rays.size()) : 0;
        times.differ += met && std::memcmp(&batch[i], &single[i], sizeof batch[i]) != 0;
    }
    return times;
}

Times any(const World& world, const std::vector<gphys_ray>& rays) {
    Times times;
    std::vector<int32_t> batch(rays.size()), single(rays.size());
    time_both(
        times, rays.size(), [&] { world.any_all(rays, batch); }, [&](size_t i) { world.any_one(rays[i], single[i]); });
    for (size_t i = 0; i < rays.size(); ++i) {
        times.met += single[i] != 0 ? 1.0 / static_cast<double>(rays.size()) : 0;
        times.differ += batch[i] != single[i];
    }
    return times;
}

int run(bool quick, const std::string& only_scene, const std::string& only_rays, uint32_t size,
        const std::string& out) {
    std::FILE* csv = out.empty() ? nullptr : std::fopen((out + "/batches.csv").c_str(), "w");
    if (!out.empty() && !csv) throw std::runtime_error("cannot write into " + out);
    if (csv) std::fprintf(csv, "scene,rays,question,met,batch_ns,single_ns,ratio,differing\n");
    int slower = 0;
    for (const MakeWorld& make : worlds(quick)) {
        if (!only_scene.empty() && only_scene != make.name) continue;
        World world(make.name, make.half, size);
        make.fill(world);
        for (const MakeRays& kind : ray_kinds) {
            if (!only_rays.empty() && only_rays != kind.name) continue;
            const std::vector<gphys_ray> rays = kind.make(world.half, quick ? 20'000 : 100'000);
            const auto report = [&](const char* question, const Times& times) {
                const double ratio = times.batch / times.single;
                const bool bad = ratio > 1 || times.differ > 0;
                slower += bad;
                std::printf("%-24s %-16s %-8s met %5.1f %%  batch %8.1f  single %8.1f  ratio %5.2f%s%s\n", make.name,
                            kind.name, question, 100 * times.met, times.batch, times.single, ratio,
                            ratio > 1 ? "  SLOWER" : "", times.differ > 0 ? "  DIFFERS" : "");
                std::fflush(stdout);
                if (csv) {
                    std::fprintf(csv, "%s,%s,%s,%.4f,%.1f,%.1f,%.3f,%llu\n", make.name, kind.name, question, times.met,
                                 times.batch, times.single, ratio, static_cast<unsigned long long>(times.differ));
                }
            };
            report("closest", closest(world, rays));
            if (world.has_any()) report("any", any(world, rays));
        }
    }
    if (csv) std::fclose(csv);
    if (slower > 0) std::printf("%d batches take longer than single calls, or differ\n", slower);
    return slower > 0 ? 1 : 0;
}

}  // namespace

}  // namespace bench

int main(int count, char** arguments) {
    bool quick = false;
    std::string scene, rays, out;
    uint32_t size = std::numeric_limits<uint32_t>::max();
    for (int i = 1; i < count; ++i) {
        const std::string argument = arguments[i];
        if (argument == "--quick") {
            quick = true;
        } else if (argument.rfind("--scene=", 0) == 0) {
            scene = argument.substr(8);
        } else if (argument.rfind("--rays=", 0) == 0) {
            rays = argument.substr(7);
        } else if (argument.rfind("--size=", 0) == 0 && std::atoi(argument.c_str() + 7) > 0) {
            size = static_cast<uint32_t>(std::atoi(argument.c_str() + 7));
        } else if (argument.rfind("--out=", 0) == 0) {
            out = argument.substr(6);
        } else {
            std::fprintf(
                stderr,
                "usage: gamephys_bench_batches [--quick] [--scene=NAME] [--rays=NAME] [--size=N] [--out=DIR]\n");
            return 2;
        }
    }
    try {
        return bench::run(quick, scene, rays, size, out);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
