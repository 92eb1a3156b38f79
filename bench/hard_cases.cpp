#include "hard_cases.h"

#include <cfloat>
#include <cmath>

namespace bench {

namespace {

constexpr int half[3] = {3, 2, 4};  // of the grid box, around (0, 0, 0)

int whole(Random& random, int extent) {
    return static_cast<int>(random.next() % static_cast<uint64_t>(2 * extent + 1)) - extent;
}

/// Slabs in whole numbers: entry and exit are compared as products.
bool meets_grid_box(const int (&origin)[3], const int (&direction)[3]) {
    struct Fraction {
        int64_t n, d;  // d > 0
    };
    const auto less = [](Fraction a, Fraction b) { return a.n * b.d < b.n * a.d; };
    Fraction entry{0, 1}, exit{1000000, 1};
    for (int k = 0; k < 3; ++k) {
        if (direction[k] == 0) {
            if (std::abs(origin[k]) > half[k]) return false;
            continue;
        }
        const int way = direction[k] > 0 ? 1 : -1;
        const Fraction in{-half[k] - way * origin[k], std::abs(direction[k])};
        const Fraction out{half[k] - way * origin[k], std::abs(direction[k])};
        if (less(entry, in)) entry = in;
        if (less(out, exit)) exit = out;
    }
    return !less(exit, entry);
}

}  // namespace

Triangles placed(Triangles mesh, gphys_vec3 offset, gphys_vec3 scale) {
    for (gphys_vec3& v : mesh.vertices) {
        v = {offset.x + scale.x * v.x, offset.y + scale.y * v.y, offset.z + scale.z * v.z};
    }
    return mesh;
}

HardRays rays_out_of(const Triangles& mesh, gphys_vec3 inside, uint32_t count) {
    Random random(11);
    HardRays work;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t* corner = &mesh.indices[3 * (random.next() % mesh.count())];
        const gphys_vec3 a = mesh.vertices[corner[0]], b = mesh.vertices[corner[1]];
        const float s = i % 2 ? 0 : random.uniform(0, 1);
        const gphys_vec3 target{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)};
        work.rays.push_back({inside, {target.x - inside.x, target.y - inside.y, target.z - inside.z}, 10});
        work.hits.push_back(true);
    }
    return work;
}

gphys_obb grid_box() { return {{0, 0, 0}, {half[0], half[1], half[2]}, {0, 0, 0, 1}}; }

HardRays rays_at_grid_box(uint32_t count) {
    Random random(12);
    HardRays work;
    while (work.rays.size() < count) {
        int origin[3], direction[3];
        bool inside = true, any = false;
        for (int k = 0; k < 3; ++k) {
            origin[k] = whole(random, 12);
            direction[k] = whole(random, 9);
            inside = inside && std::abs(origin[k]) <= half[k];
            any = any || direction[k] != 0;
        }
        if (inside || !any) continue;
        const auto vector = [](const int(&v)[3]) {
            return gphys_vec3{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
        };
        work.rays.push_back({vector(origin), vector(direction), 1000});
        work.hits.push_back(meets_grid_box(origin, direction));
    }
    return work;
}

gphys_sphere tangent_sphere() { return {{0, 0, 0}, 1}; }

HardRays rays_at_tangent_sphere(uint32_t count) {
    Random random(13);
    HardRays work;
    for (uint32_t i = 0; i < count; ++i) {
        const float angle = random.uniform(0, 6.2831853f);
        float x = std::cos(angle), y = std::sin(angle);
        for (uint64_t steps = random.next() % 3; steps > 0; --steps) x = std::nextafter(x, x > 0 ? FLT_MAX : -FLT_MAX);
        work.rays.push_back({{x, y, -1e6f}, {0, 0, 1}, 3e6f});
        // The squares of floats are exact in double; their sum in long double.
        work.hits.push_back(static_cast<long double>(double(x) * x) + double(y) * y <= 1);
    }
    return work;
}

std::vector<gphys_sphere> spheres_at_grid_box(uint32_t count, uint64_t& touching) {
    // Whole vectors of whole length, so that a radius can be exactly the distance.
    constexpr int vectors[4][4] = {{2, 3, 6, 7}, {1, 4, 8, 9}, {2, 6, 9, 11}, {3, 4, 12, 13}};
    Random random(14);
    std::vector<gphys_sphere> spheres;
    touching = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const int* v = vectors[random.next() % 4];
        const uint64_t turn = random.next() % 3;
        float at[3];
        for (int k = 0; k < 3; ++k) {
            const int out = half[k] + v[(k + turn) % 3];
            at[k] = static_cast<float>(random.next() % 2 ? out : -out);
        }
        float radius = static_cast<float>(v[3]);
        const uint64_t kind = random.next() % 3;
        if (kind == 0) radius = std::nextafter(radius, 0.0f);
        if (kind == 2) radius = std::nextafter(radius, FLT_MAX);
        touching += kind != 0;
        spheres.push_back({{at[0], at[1], at[2]}, radius});
    }
    return spheres;
}

}  // namespace bench
