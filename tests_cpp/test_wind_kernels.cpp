// The forces of the air on cloth, on each instruction set, beside the formula in double.
#include "solver/wind_kernels.h"

#include <cmath>
#include <cstring>
#include <vector>

#include "solver/triangle_drag.h"
#include "test.h"

using namespace gphys;
using test::Random;

namespace {

#define GPHYS_ISA_LISTED(set, ...) Isa::set,

/// A crumpled sheet of random triangles in a wind. The last particle is pinned.
struct Sheet {
    static constexpr uint32_t particles = 19;
    static constexpr size_t triangle_count = 29;

    Sheet(float size, float speed) : random(7) {
        for (uint32_t p = 0; p < particles; ++p) {
            const float mass = random.uniform_float(0.5f, 2);
            push(at, size, p + 1 < particles ? 1 / mass : 0);
            push(velocity, speed, 0);
            push(velocity_before, speed, 0);
            push(steady, 10, mass);
        }
        for (std::vector<float>* values : {&at, &velocity, &velocity_before, &steady}) values->resize(80);
        relative = forces = acceleration = std::vector<float>(80);
        for (size_t i = 0; i < triangle_count; ++i) {
            const uint32_t first = random.index(particles);
            for (const uint32_t next : {0u, 1u, 3u}) triangles.push_back((first + next) % particles);
        }
    }
    void push(std::vector<float>& to, float extent, float last) {
        const gphys_vec3 point = random.point(extent);
        to.insert(to.end(), {point.x, point.y, point.z, last});
    }
    AirOnCloth air() {
        AirOnCloth air{};
        air.floats = 80;
        air.at = at.data(), air.velocity = velocity.data(), air.velocity_before = velocity_before.data();
        air.steady = steady.data(), air.relative = relative.data(), air.forces = forces.data();
        air.acceleration = acceleration.data();
        air.triangles = triangles.data(), air.triangle_count = triangle_count;
        air.drag = 1, air.lift = 0.7f, air.unit = 3, air.before = 1.0f / 3, air.most_rate = 1e30f;
        return air;
    }
    std::vector<float> run(Isa isa, const AirOnCloth& air) {
        const WindKernels& kernels = wind_kernels(isa);
        kernels.find_relative(air);
        kernels.add_forces(air);
        kernels.accelerate(air);
        return acceleration;
    }

    Random random;
    std::vector<float> at, velocity, velocity_before, steady, relative, forces, acceleration;
    std::vector<uint32_t> triangles;
};

Vec3 vector_of(const std::vector<float>& values, uint32_t p) {
    return {values[4 * p], values[4 * p + 1], values[4 * p + 2]};
}

}  // namespace

TEST_CASE("the air's forces on cloth are those of the formula, with the same bits on each instruction set") {
    Sheet sheet(1, 5);
    AirOnCloth air = sheet.air();
    for (const int half : {0, 4}) air.wind[half] = 3, air.wind[half + 1] = -2, air.wind[half + 2] = 1;
    std::vector<Vec3> relative, forces(Sheet::particles);
    std::vector<double> growths(Sheet::particles);
    for (uint32_t p = 0; p < Sheet::particles; ++p) {
        const Vec3 now = vector_of(sheet.velocity, p), before = vector_of(sheet.velocity_before, p);
        const Vec3 free = sheet.at[4 * p + 3] > 0 ? now + (now - before) / 3 : now;
        relative.push_back(free - Vec3{3, -2, 1});
    }
    for (size_t i = 0; i < sheet.triangles.size(); i += 3) {
        const uint32_t a = sheet.triangles[i], b = sheet.triangles[i + 1], c = sheet.triangles[i + 2];
        const Vec3 at = vector_of(sheet.at, a);
        const Vec3 twice = cross(vector_of(sheet.at, b) - at, vector_of(sheet.at, c) - at);
        const Vec3 u = (relative[a] + relative[b] + relative[c]) / 3;
        // As gphys_solver_set_wind states it, with C_D = 1, C_L = 0.7.
        const Vec3 n = twice / length(twice);
        const double cosine = std::fabs(dot(u, n)) / length(u), lift = 0.7f;
        const Vec3 force = (u * std::max(0.0, cosine - lift * cosine * cosine) + n * (lift * dot(u, n))) *
                           (-length(u) * length(twice));
        const double growth = length(u) * length(twice) * (std::max(0.0, cosine - lift * cosine * cosine) + lift);
        for (const uint32_t p : {a, b, c}) forces[p] += force, growths[p] += growth;
    }
    std::vector<float> first;
    for (const float most_rate : {1e30f, 10.0f}) {
        air.most_rate = most_rate;
        first.clear();
        for (const Isa isa : {GPHYS_FOR_EACH_ISA(GPHYS_ISA_LISTED, )}) {
            if (!has(isa)) continue;
            const std::vector<float> got = sheet.run(isa, air);
            if (first.empty()) first = got;
            CHECK(std::memcmp(first.data(), got.data(), sizeof(float) * got.size()) == 0);
            for (uint32_t p = 0; p < Sheet::particles; ++p) {
                const double rate = 3 * double{sheet.at[4 * p + 3]};
                const double by = std::min(rate, double{most_rate} / growths[p]);
                const Vec3 exact = vector_of(sheet.steady, p) + (rate > 0 ? forces[p] * by : Vec3{});
                // Some 30 roundings of a triangle, in up to ten triangles: 2^-24 each.
                CHECK(length(vector_of(got, p) - exact) <= 2e-6 * (length(exact) + growths[p] * by * 10));
                CHECK(got[4 * p + 3] == sheet.steady[4 * p + 3]);
            }
        }
    }
}

TEST_CASE("the air's forces on cloth stay finite, and never reverse a velocity relative to the air") {
    for (const float size : {1e-20f, 1e-9f, 1e12f}) {
        for (const float speed : {0.0f, 1e-30f, 1e9f}) {
            Sheet sheet(size, speed);
            AirOnCloth air = sheet.air();
            air.wind[0] = air.wind[4] = speed * 1e6f;
            air.unit = 3e38f;
            air.most_rate = 1000;
            for (const Isa isa : {GPHYS_FOR_EACH_ISA(GPHYS_ISA_LISTED, )}) {
                if (!has(isa)) continue;
                const std::vector<float> got = sheet.run(isa, air);
                for (uint32_t p = 0; p < Sheet::particles; ++p) {
                    double fastest = 0;
                    for (uint32_t q = 0; q < Sheet::particles; ++q)
                        fastest = std::max(fastest, length(vector_of(sheet.relative, q)));
                    const double most = length(vector_of(sheet.steady, p)) + 1000 * fastest;
                    CHECK(length(vector_of(got, p)) <= 1.0001 * most);
                }
            }
        }
    }
}
