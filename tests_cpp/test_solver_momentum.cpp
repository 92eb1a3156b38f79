// What nothing outside touches keeps its momentum and its angular momentum, whatever its links do to each other.
#include "closed_cloth.h"

using namespace test;
using gphys::Vec3;
using gphys::widen;

namespace {

/// Of particles of one mass: per mass, about their centre.
struct Momenta {
    Vec3 linear, angular;
};
Momenta momenta(const World& world, gphys_body_id body) {
    const std::vector<gphys_vec3> at = world.positions(body), velocity = world.velocities(body);
    const double part = 1.0 / static_cast<double>(at.size());
    Vec3 centre;
    Momenta sum;
    for (const gphys_vec3& p : at) centre += widen(p) * part;
    for (size_t i = 0; i < at.size(); ++i) {
        sum.linear += widen(velocity[i]) * part;
        sum.angular += cross(widen(at[i]) - centre, widen(velocity[i])) * part;
    }
    return sum;
}

/// About the centre, with one velocity for all besides.
void spin(const World& world, gphys_body_id body, Vec3 turning, Vec3 velocity) {
    const std::vector<gphys_vec3> at = world.positions(body);
    Vec3 centre;
    for (const gphys_vec3& p : at) centre += widen(p) / static_cast<double>(at.size());
    std::vector<gphys_vec3> velocities;
    for (const gphys_vec3& p : at) velocities.push_back(gphys::narrow(velocity + cross(turning, widen(p) - centre)));
    REQUIRE(gphys_solver_set_velocities(world.solver, body, 0, static_cast<uint32_t>(at.size()), velocities.data(),
                                        12) == GPHYS_OK);
}

/// What is lost of both at most, in parts, at the ends of so many seconds.
struct Lost {
    double linear = 0, angular = 0;
};
Lost lost_in(World& world, gphys_body_id body, int seconds) {
    const Momenta before = momenta(world, body);
    Lost lost;
    for (int i = 0; i < 60 * seconds; ++i) {
        world.step(1.0f / 60);
        if (i % 60 != 59) continue;
        const Momenta now = momenta(world, body);
        lost.linear = std::max(lost.linear, distance(now.linear, before.linear) / length(before.linear));
        lost.angular = std::max(lost.angular, distance(now.angular, before.angular) / length(before.angular));
    }
    return lost;
}

/// n^3 particles 0.25 m apart, each linked to the others of every cell that it is in.
gphys_body_id lattice(World& world, int n) {
    std::vector<gphys_vec3> at;
    for (int z = 0; z < n; ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                at.push_back(
                    {0.25f * static_cast<float>(x), 0.25f * static_cast<float>(y), 0.25f * static_cast<float>(z)});
            }
        }
    }
    const gphys_body_id body = world.particles(at);
    gphys_constraint_id link = 0;
    for (uint32_t a = 0; a < at.size(); ++a) {
        for (uint32_t b = a + 1; b < at.size(); ++b) {
            if (distance(widen(at[a]), widen(at[b])) > 0.25 * 1.8) continue;
            REQUIRE(gphys_solver_add_distance(world.solver, body, a, b, -1, 0, &link) == GPHYS_OK);
        }
    }
    return body;
}

// A thousandth in ten seconds: what nobody sees.
constexpr double most_lost = 1e-3;

void check(const char* what, const Lost& lost) {
    std::printf("    %s: momentum off by %.2g, angular momentum by %.2g\n", what, lost.linear, lost.angular);
    CHECK(lost.linear < most_lost);
    CHECK(lost.angular < most_lost);
}

}  // namespace

TEST_CASE("a lattice of rigid links goes on turning") {
    World world(8, {0, 0, 0});
    const gphys_body_id body = lattice(world, 5);
    spin(world, body, {0, 4, 1}, {1, 0, 0});
    const double energy = world.energy(body);
    check("5^3 particles", lost_in(world, body, 10));
    // Nothing in it gives way, so its energy is that of its turning: it stays.
    const double left = world.energy(body) / energy;
    figure("energy left", left, "parts");
    CHECK(left > 0.99);
    CHECK(left < 1.0001);
}

TEST_CASE("a ball goes on turning, with its volume held and without", "[simulation]") {
    const Surface sphere = icosphere(2);
    for (const float compliance : {-1.0f, 0.0f, 1e-5f}) {
        World world(8, {0, 0, 0});
        gphys_body_desc desc = World::body_desc();
        desc.cloth_flags = 0;
        const gphys_body_id body = add(world, sphere, desc, 0);
        if (compliance >= 0) REQUIRE(gphys_solver_set_volume(world.solver, body, -1, compliance) == GPHYS_OK);
        spin(world, body, {4, 0, 0}, {0, 1, 0});
        check(compliance < 0 ? "without" : compliance == 0 ? "volume held" : "gas", lost_in(world, body, 10));
    }
}

TEST_CASE("a ball of gas and soft links keeps its momentum") {
    const Surface sphere = icosphere(0);
    World world(8, {0, 0, 0});
    gphys_body_desc desc = World::body_desc();
    desc.compliance = 1e-3f;
    const gphys_body_id body = add(world, sphere, desc, 0);
    REQUIRE(gphys_solver_set_volume(world.solver, body, 4, 1e-4f) == GPHYS_OK);
    spin(world, body, {0, 1, 2}, {0.1f, 0, 0});
    check("gas", lost_in(world, body, 10));
}

TEST_CASE("a free sheet keeps its momenta while it tumbles and folds, in few substeps and in many", "[simulation]") {
    for (const uint32_t substeps : {8u, 60u}) {
        World world(substeps, {0, 0, 0});
        const gphys_body_id body = world.cloth({-0.95f, 0, -0.95f}, {1.9f, 0, 0}, {0, 0, 1.9f}, 20, 20);
        spin(world, body, {3, 2, 0.5}, {1, 0, 0});
        world.set_velocity(body, 0, {0, 20, 0});
        check(substeps == 8 ? "8 substeps" : "60 substeps", lost_in(world, body, 20));
    }
}

TEST_CASE("forces turn a body as much as they do by Euler's law") {
    // A couple of forces on the corners of a sheet that turns freely about its normal: its angular momentum grows by
    // their moment times the time.
    World world(8, {0, 0, 0});
    const gphys_body_id body = world.cloth({-0.5f, 0, -0.5f}, {1, 0, 0}, {0, 0, 1}, 11, 11);
    Vec3 given;
    for (int i = 0; i < 120; ++i) {
        const std::vector<gphys_vec3> at = world.positions(body);
        const gphys_vec3 push{0, 0, 0.1f}, pull{0, 0, -0.1f};
        REQUIRE(gphys_solver_set_forces(world.solver, body, 0, 1, &push, 12) == GPHYS_OK);
        REQUIRE(gphys_solver_set_forces(world.solver, body, 120, 1, &pull, 12) == GPHYS_OK);
        world.step(1.0f / 60);
        const std::vector<gphys_vec3> after = world.positions(body);
        // By the trapezoid rule, whose error for arms that turn by w h in a step is (w h)^2 / 12.
        const auto arm = [](const std::vector<gphys_vec3>& p) { return widen(p[0]) - widen(p[120]); };
        given += cross((arm(at) + arm(after)) / 2, Vec3{0, 0, static_cast<double>(0.1f)}) / 60;
    }
    const double moment = length(given);
    const Vec3 angular = momenta(world, body).angular;
    figure("angular momentum off the moment of the forces", distance(angular, given) / moment, "parts");
    CHECK(distance(angular, given) < 2e-3 * moment);
}

TEST_CASE("drag takes angular momentum as it takes velocity") {
    World world(8, {0, 0, 0});
    gphys_body_desc desc = World::body_desc();
    desc.damping = 0.5f;
    const gphys_body_id body = world.cloth({-0.5f, 0, -0.5f}, {1, 0, 0}, {0, 0, 1}, 11, 11, desc);
    spin(world, body, {0, 3, 0}, {1, 0, 0});
    const Momenta before = momenta(world, body);
    for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
    const Momenta now = momenta(world, body);
    const double kept = std::exp(-1.0);
    figure("angular momentum off exp(-c t)", length(now.angular) / length(before.angular) / kept - 1, "parts");
    CHECK(std::fabs(length(now.angular) / length(before.angular) / kept - 1) < 1e-4);
    CHECK(std::fabs(length(now.linear) / length(before.linear) / kept - 1) < 1e-4);
}
