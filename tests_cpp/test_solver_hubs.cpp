// Cloth and nets with a particle that has many links: parachutes, webs, discs.
#include <algorithm>
#include <cmath>

#include "solver_world.h"

using namespace test;
using gphys::Vec3;

namespace {

constexpr double pi = 3.14159265358979;

/// The middle, and behind it `rings` circles of as many particles as there are spokes, in the plane or as a dome.
std::vector<gphys_vec3> disc(uint32_t spokes, uint32_t rings, double radius, double height) {
    std::vector<gphys_vec3> places{{0, 0, 0}};
    for (uint32_t j = 1; j <= rings; ++j) {
        for (uint32_t i = 0; i < spokes; ++i) {
            const double angle = 2 * pi * i / spokes, part = static_cast<double>(j) / rings;
            places.push_back({static_cast<float>(radius * part * std::sin(angle)),
                              static_cast<float>(-height * part * part),
                              static_cast<float>(radius * part * std::cos(angle))});
        }
    }
    return places;
}

/// The particle of a spoke on a ring; both from 0.
uint32_t at(uint32_t spokes, uint32_t ring, uint32_t spoke) { return 1 + ring * spokes + spoke % spokes; }

gphys_body_id cloth_of(World& world, uint32_t spokes, uint32_t rings, double radius, double height,
                       const gphys_body_desc& desc) {
    std::vector<float> vertices;
    for (const gphys_vec3& p : disc(spokes, rings, radius, height)) vertices.insert(vertices.end(), {p.x, p.y, p.z});
    std::vector<uint32_t> triangles;
    for (uint32_t i = 0; i < spokes; ++i) {
        triangles.insert(triangles.end(), {0, at(spokes, 0, i), at(spokes, 0, i + 1)});
        for (uint32_t j = 0; j + 1 < rings; ++j) {
            const uint32_t a = at(spokes, j, i), b = at(spokes, j, i + 1);
            triangles.insert(triangles.end(), {a, a + spokes, b, b, a + spokes, b + spokes});
        }
    }
    const MeshHandle mesh(vertices, triangles);
    gphys_body_id cloth = 0;
    REQUIRE(gphys_solver_add_cloth_mesh(world.solver, &desc, mesh.mesh, nullptr, &cloth) == GPHYS_OK);
    return cloth;
}

void link(World& world, gphys_body_id body, uint32_t a, uint32_t b, float compliance) {
    gphys_constraint_id id = 0;
    REQUIRE(gphys_solver_add_distance(world.solver, body, a, b, -1, compliance, &id) == GPHYS_OK);
}

double fastest(const World& world, gphys_body_id body) {
    double speed = 0;
    for (const gphys_vec3& v : world.velocities(body)) speed = std::max(speed, length(gphys::widen(v)));
    return speed;
}

}  // namespace

TEST_CASE("A parachute whose gores meet in one point keeps its shape, and sinks as its area says", "[simulation]") {
    for (const uint32_t gores : {8u, 10u, 16u, 24u}) {
        World world;
        gphys_body_desc desc = World::body_desc();
        desc.mass = 4;
        constexpr uint32_t rings = 8;
        const gphys_body_id canopy = cloth_of(world, gores, rings, 3, 0.65, desc);
        desc.mass = 80;
        const gphys_body_id load = world.particles({{0, -6.5f, 0}}, desc);
        for (uint32_t i = 0; i < gores; i += 2) {
            gphys_joint_id line = 0;
            REQUIRE(gphys_solver_join(world.solver, canopy, at(gores, rings - 1, i), load, 0, -1, 0, &line) ==
                    GPHYS_OK);
        }
        const gphys_wind calm{{0, 0, 0}, 1.2f, 1.2f, 1.2f};
        REQUIRE(gphys_solver_set_wind(world.solver, canopy, &calm) == GPHYS_OK);
        double strain = 0;
        for (int frame = 0; frame < 300; ++frame) {
            world.step(1.0f / 60);
            if (frame >= 120) strain = std::max(strain, static_cast<double>(world.stats(canopy).strain_max));
        }
        const double sinks = -world.velocities(load)[0].y;
        figure("speed of the parachute", sinks, "m/s");
        figure("strain of the parachute", strain, "");
        CHECK(sinks > 6.8);
        CHECK(sinks < 7.1);
        CHECK(strain < 0.05);
    }
}

TEST_CASE("A web of elastic cords gains no energy, and rests, whatever the number of its spokes", "[simulation]") {
    for (const uint32_t spokes : {8u, 10u, 12u, 16u, 32u}) {
        constexpr uint32_t rings = 10;
        World world;
        gphys_body_desc desc = World::body_desc();
        desc.mass = 0.01f;
        desc.damping = 1;
        const gphys_body_id web = world.particles(disc(spokes, rings, 1, 0), desc);
        for (uint32_t i = 0; i < spokes; ++i) {
            link(world, web, 0, at(spokes, 0, i), 1e-3f);
            for (uint32_t j = 0; j < rings; ++j) {
                const uint32_t here = at(spokes, j, i);
                if (j + 1 < rings) link(world, web, here, here + spokes, 1e-3f);
                link(world, web, here, at(spokes, j, i + 1), 1e-3f);
            }
            world.pin(web, at(spokes, rings - 1, i));
        }
        const double before = world.energy(web);
        double most = -1;
        for (int frame = 0; frame < 300; ++frame) {
            world.step(1.0f / 60);
            most = std::max(most, world.energy(web) - before);
        }
        figure("energy that the web gained", most, "J");
        figure("speed of the web after 5 s", fastest(world, web), "m/s");
        CHECK(most < 1e-3);  // a hundredth of a fall by its radius
        CHECK(fastest(world, web) < 0.02);
    }
}

/// The sweeps there and back must add up to one force of each link.
///
///     pin ---.         .--- pin      sixteen springs
///             '-- m --'
TEST_CASE("A weight on many elastic links hangs where their forces carry it") {
    constexpr uint32_t spokes = 16;
    constexpr double stiffness = 1000, mass = 0.5;
    World world;
    gphys_body_desc desc = World::body_desc();
    desc.mass = static_cast<float>(mass * (spokes + 1));
    desc.damping = 3;
    const gphys_body_id net = world.particles(disc(spokes, 1, 1, -0.5), desc);
    for (uint32_t i = 0; i < spokes; ++i) {
        link(world, net, 0, at(spokes, 0, i), static_cast<float>(1 / stiffness));
        link(world, net, at(spokes, 0, i), at(spokes, 0, i + 1), 0);  // a ring, which makes it a graph
        world.pin(net, at(spokes, 0, i));
    }
    for (int frame = 0; frame < 600; ++frame) world.step(1.0f / 60);
    const Vec3 away = world.position(net, 1) - world.position(net, 0);
    const double force = spokes * stiffness * (length(away) - std::sqrt(1.25)) * away.y / length(away);
    figure("force of the links, in parts of the weight", force / (mass * 9.81), "");
    CHECK(std::fabs(force / (mass * 9.81) - 1) < 0.01);
}

TEST_CASE("A disc of cloth that tumbles in free flight gains no energy, and loses little", "[simulation]") {
    constexpr uint32_t spokes = 24;
    World world(8, {0, 0, 0});
    gphys_body_desc desc = World::body_desc();
    const gphys_body_id cloth = cloth_of(world, spokes, 8, 1, 0.2, desc);
    std::vector<gphys_vec3> velocities;
    for (const gphys_vec3& p : world.positions(cloth)) {
        const Vec3 v = cross({3, 1, 0.5}, gphys::widen(p));
        velocities.push_back({static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
    }
    REQUIRE(gphys_solver_set_velocities(world.solver, cloth, 0, static_cast<uint32_t>(velocities.size()),
                                        velocities.data(), 12) == GPHYS_OK);
    const double before = world.energy(cloth);
    double most = 0;
    for (int frame = 0; frame < 600; ++frame) {
        world.step(1.0f / 60);
        most = std::max(most, world.energy(cloth) - before);
    }
    figure("energy kept by the disc in 10 s", world.energy(cloth) / before, "");
    CHECK(most < 1e-3 * before);
    CHECK(world.energy(cloth) > 0.94 * before);
}
