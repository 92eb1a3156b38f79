// Drag and lift, against what is known in closed form.
#include "snapshots.h"

using namespace test;
using gphys::Vec3;

namespace {

constexpr double g = static_cast<double>(9.81f), pi = 3.14159265358979324;
constexpr float frame = 1.0f / 60;

void blow(World& world, gphys_body_id body, const gphys_wind& wind) {
    REQUIRE(gphys_solver_set_wind(world.solver, body, &wind) == GPHYS_OK);
}

gphys_body_desc of_mass(float mass) {
    gphys_body_desc desc = World::body_desc();
    desc.mass = mass;
    return desc;
}

struct Momentum {
    Vec3 linear, angular;  // angular about the middle
};
/// Of a body whose particles all have this mass.
Momentum momentum(const World& world, gphys_body_id body, double mass) {
    const std::vector<gphys_vec3> at = world.positions(body), velocity = world.velocities(body);
    Vec3 middle;
    for (const gphys_vec3& p : at) middle += gphys::widen(p) * (1.0 / static_cast<double>(at.size()));
    Momentum sum;
    for (size_t i = 0; i < at.size(); ++i) {
        sum.linear += gphys::widen(velocity[i]) * mass;
        sum.angular += cross(gphys::widen(at[i]) - middle, gphys::widen(velocity[i]) * mass);
    }
    return sum;
}

/// Per kilogram, of particles of equal masses.
double energy_in_air(const World& world, gphys_body_id body, gphys_vec3 wind) {
    const std::vector<gphys_vec3> velocities = world.velocities(body);
    double sum = 0;
    for (const gphys_vec3& v : velocities) sum += length_squared(gphys::widen(v) - gphys::widen(wind)) / 2;
    return sum / static_cast<double>(velocities.size());
}

}  // namespace

TEST_CASE("A ball falls with its terminal velocity, and gets there as it should") {
    World world(8);
    gphys_body_desc desc = of_mass(0.0027f);
    desc.radius = 0.02f;
    const gphys_body_id ball = world.particles({{0, 0, 0}}, desc);
    blow(world, ball, {{0, 0, 0}, 1.2f, 0.5f, 0});
    const double mass = static_cast<double>(0.0027f), r = static_cast<double>(0.02f);
    const double terminal = std::sqrt(2 * mass * g / (static_cast<double>(1.2f) * 0.5 * pi * r * r));
    double worst = 0;
    for (int i = 1; i <= 600; ++i) {
        world.step(frame);
        const double exact = terminal * std::tanh(g * i * static_cast<double>(frame) / terminal);
        worst = std::max(worst, std::fabs(-world.velocities(ball)[0].y - exact));
    }
    figure("falling ball, largest error of its speed", worst / terminal, "of the terminal velocity");
    // Of second order. A force that lasts while drag takes 1/32 of the speed is wrong by a sixth of its square at most.
    CHECK(worst < 2e-4 * terminal);
    CHECK(std::fabs(-world.velocities(ball)[0].y - terminal) < 1e-6 * terminal);
}

TEST_CASE("The way of a fast ball in air is wrong by the square of the substep") {
    gphys_body_desc desc = of_mass(0.0027f);
    desc.radius = 0.02f;
    const double mass = static_cast<double>(desc.mass), r = static_cast<double>(desc.radius);
    const double k = static_cast<double>(1.2f) / 2 * 0.5 * pi * r * r / mass;
    const Vec3 wind{-3, 0, 1};
    // The slow twin: the midpoint rule in steps of 10 microseconds.
    Vec3 at, v{30, 30, 0};
    for (int i = 0; i < 100000; ++i) {
        const double h = 1e-5;
        const auto rate = [&](Vec3 now) { return Vec3{0, -g, 0} - (now - wind) * (k * length(now - wind)); };
        const Vec3 middle = v + rate(v) * (h / 2);
        at += middle * h;
        v += rate(middle) * h;
    }
    const auto error = [&](uint32_t substeps, int steps) {
        World world(substeps);
        const gphys_body_id ball = world.particles({{0, 0, 0}}, desc);
        const gphys_vec3 velocity{30, 30, 0};
        REQUIRE(gphys_solver_set_velocities(world.solver, ball, 0, 1, &velocity, 0) == GPHYS_OK);
        blow(world, ball, {{-3, 0, 1}, 1.2f, 0.5f, 0});
        for (int i = 0; i < steps; ++i) world.step(1.0f / static_cast<float>(steps));
        return length(world.position(ball, 0) - at);
    };
    const double in_frames = error(8, 60);
    figure("fast ball, error of its place after 1 s at 8 substeps", in_frames, "m");
    CHECK(in_frames < 3e-4 * length(at));
    // Long steps, of which drag takes up to 60 % of the speed: below 1/32 the force would last for several substeps.
    double before = error(1, 10);
    for (const uint32_t substeps : {2u, 4u, 8u}) {
        const double now = error(substeps, 10);
        CHECK(now < before / 3.5);
        before = now;
    }
}

TEST_CASE("What holds a ball in the wind gets its drag") {
    World world(8, {0, 0, 0});
    const gphys_sphere away{{0, 50, 0}, 1};
    const gphys_model_id model = world.model(GPHYS_SHAPE_SPHERE, &away);
    const gphys_body_id ball = world.particles({{0, 0, 0}}, of_mass(0.1f));
    REQUIRE(gphys_solver_attach(world.solver, world.scene, ball, 0, model, nullptr) == GPHYS_OK);
    blow(world, ball, {{0, 0, 30}, 1.2f, 0.5f, 0});
    world.step(frame);
    gphys_impulse impulse{};
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_impulses(world.solver, &impulse, 1, &total) == GPHYS_OK);
    const double r = static_cast<double>(World::body_desc().radius);
    const double drag = static_cast<double>(1.2f) / 2 * 0.5 * pi * r * r * 30 * 30;
    CHECK(std::fabs(impulse.linear.z / static_cast<double>(frame) / drag - 1) < 1e-5);
}

TEST_CASE("A sheet falls flat with its terminal velocity") {
    for (const float lift : {0.0f, 1.2f}) {
        World world(8);
        const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 6, 6, of_mass(0.2f));
        // As heavy as the area that each particle carries, or the rim would fall faster.
        std::vector<uint32_t> corners(150);
        uint32_t total = 0;
        REQUIRE(gphys_solver_get_triangles(world.solver, sheet, corners.data(), 150, &total) == GPHYS_OK);
        std::vector<float> masses(36, 0.0f);
        for (const uint32_t p : corners) masses[p] += 0.2f / 150;
        REQUIRE(gphys_solver_set_masses(world.solver, sheet, 0, 36, masses.data(), 4) == GPHYS_OK);
        blow(world, sheet, {{0, 0, 0}, 1.2f, 1.2f, lift});
        for (int i = 0; i < 120; ++i) world.step(frame);
        const double mass = static_cast<double>(0.2f), c = static_cast<double>(1.2f);
        const double terminal = std::sqrt(2 * mass * g / (c * c));
        double worst = 0;
        for (const gphys_vec3& v : world.velocities(sheet)) {
            worst = std::max(worst, std::fabs(static_cast<double>(-v.y) / terminal - 1));
        }
        figure("falling sheet, largest error of a speed", worst, "of itself");
        // Masses and velocities of float32, and what bends the sheet by the rounding of its places.
        CHECK(worst < 1e-3);
    }
}

TEST_CASE("The force on an oblique sheet is that of the formula, and turns it by nothing") {
    for (const double angle : {0.0, 0.3, 0.8, 1.2, 1.5}) {  // of the normal, from the wind
        for (const float lift : {0.0f, 0.4f, 1.0f}) {
            World world(1, {0, 0, 0});
            const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
            // Across the wind along z; a parallelogram without a middle particle.
            const gphys_body_id sheet = world.cloth({0, 0, 0}, {s, c, 0}, {0, 0, 0.5f}, 4, 6, of_mass(1));
            const double wind = 8, density = static_cast<double>(1.2f), area = 0.5;
            blow(world, sheet, {{8, 0, 0}, 1.2f, 1.0f, lift});
            // The force is that of the beginning: of a sheet at rest.
            const float dt = 1e-3f;
            world.step(dt);
            const Vec3 n{std::cos(angle), -std::sin(angle), 0}, u{-wind, 0, 0};
            const double cosine = std::cos(angle), part = density / 2 * area * wind;
            const double along = std::max(0.0, cosine - static_cast<double>(lift) * cosine * cosine);
            const Vec3 force = (u * along + n * (dot(u, n) * static_cast<double>(lift))) * -part;
            const Momentum got = momentum(world, sheet, 1.0 / 24);
            const double h = static_cast<double>(dt), scale = part * wind * h;
            // Places of float32 are off by 3e-8 m, which links take back in a thousandth of a second.
            CHECK(length(got.linear - force * h) < 1e-3 * scale);
            CHECK(length(got.angular) < 1e-3 * scale);
        }
    }
}

TEST_CASE("A wind that begins takes bodies along and never beyond, whatever its strength") {
    for (const float density : {1.2f, 1e3f, 1e6f, 1e15f}) {
        World world(8, {0, 0, 0});
        const gphys_vec3 wind{3, -4, 12};
        gphys_body_desc desc = of_mass(0.1f);
        const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 5, 5, desc);
        const gphys_body_id rope = world.rope(line({0, 0, 3}, {0.1f, 0.02f, 0}, 8), 0, desc);
        const gphys_body_id balls = world.particles(line({0, 0, 6}, {0.1f, 0, 0}, 9), desc);
        blow(world, 0, {wind, density, 1.2f, 1.2f});
        double left = 13, energy[2] = {energy_in_air(world, sheet, wind), energy_in_air(world, rope, wind)};
        for (int i = 0; i < 240; ++i) {
            world.step(frame);
            // Balls have nothing that pulls them elsewhere.
            for (const gphys_vec3& v : world.velocities(balls)) {
                const double now = length(gphys::widen(wind) - gphys::widen(v));
                CHECK(now <= left + 1e-5);
                CHECK(dot(gphys::widen(wind) - gphys::widen(v), gphys::widen(wind)) >= -1e-4);
            }
            left = length(gphys::widen(wind) - gphys::widen(world.velocities(balls)[0]));
            // Links pass speed on, and bend links give back what they hold: a hundred-thousandth of the 84 J/kg at
            // first.
            for (size_t k = 0; k < 2; ++k) {
                const double now = energy_in_air(world, k == 0 ? sheet : rope, wind);
                INFO("body " << k << " density " << density);
                CHECK(now <= energy[k] * 1.001 + 1e-3);
                energy[k] = now;
            }
        }
        if (density >= 1e3f) CHECK(left < 0.1);
    }
}

TEST_CASE("Bodies that are held stay finite in a storm") {
    for (const float density : {1.2f, 1e6f, 1e15f}) {
        World world(8);
        const gphys_body_id flag = world.cloth({0, 0, 0}, {1, 0, 0}, {0, -0.6f, 0}, 11, 7, of_mass(0.1f));
        for (uint32_t row = 0; row < 7; ++row) world.pin(flag, row * 11);
        const gphys_body_id rope = world.rope(line({0, 0, 3}, {0, -0.1f, 0}, 12), 0, of_mass(0.1f));
        world.pin(rope, 0);
        blow(world, 0, {{20, 1, 4}, density, 1.2f, 1.0f});
        for (int i = 0; i < 120; ++i) world.step(frame);
        for (const gphys_body_id body : {flag, rope}) {
            for (const gphys_vec3& p : world.positions(body)) CHECK(length(gphys::widen(p) - Vec3{0, 0, 1.5}) < 3);
        }
        CHECK(world.stats(rope).strain_max < 1e-3f);
        CHECK(world.stats(flag).strain_max < 0.2f);
    }
}

TEST_CASE("What holds a sheet across the wind gets its drag") {
    World world(8, {0, 0, 0});
    const gphys_sphere away{{0, 50, 0}, 1};
    const gphys_model_id model = world.model(GPHYS_SHAPE_SPHERE, &away);
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 5, 5, of_mass(0.05f));
    for (uint32_t p = 0; p < 25; ++p) {
        REQUIRE(gphys_solver_attach(world.solver, world.scene, sheet, p, model, nullptr) == GPHYS_OK);
    }
    blow(world, sheet, {{0, 0, 30}, 1.2f, 1.1f, 0.5f});
    world.step(frame);
    gphys_impulse impulse{};
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_impulses(world.solver, &impulse, 1, &total) == GPHYS_OK);
    const double drag = static_cast<double>(1.2f) / 2 * static_cast<double>(1.1f) * 30 * 30;
    // Also a sheet that the wind would take along within a step.
    CHECK(std::fabs(impulse.linear.z / static_cast<double>(frame) / drag - 1) < 1e-5);
}

TEST_CASE("A rope in a steady wind hangs at the angle where drag carries it") {
    World world(8);
    gphys_body_desc desc = of_mass(0.1f);
    desc.radius = 0.01f;
    desc.damping = 1;
    const gphys_body_id rope = world.rope(line({0, 0, 0}, {0, -0.1f, 0}, 11), 0, desc);
    world.pin(rope, 0);
    const double wind = 6;
    blow(world, rope, {{6, 0, 0}, 1.2f, 1.1f, 0});
    for (int i = 0; i < 1800; ++i) world.step(frame);
    // Each link carries its weight along and across itself: w sin a = rho/2 C d (U cos a)^2, by bisection. Half of a
    // link's weight hangs on either end, and of the last node's there is half a link too much: what is left of the
    // mass of eleven particles for ten links.
    const double weight = static_cast<double>(0.1f) * g,
                 push = 0.5 * static_cast<double>(1.2f) * static_cast<double>(1.1f) * 0.02 * wind * wind;
    const auto angle = [&](double w) {
        double low = 0, high = pi / 2;
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            (w * std::sin(middle) < push * std::cos(middle) * std::cos(middle) ? low : high) = middle;
        }
        return low;
    };
    const Vec3 end = world.position(rope, 10);
    const double got = std::atan2(end.x, -end.y);
    figure("rope in the wind, angle", got, "rad");
    // Nodes weigh 1/11 each: links see between 10/11 and 11/10 of the weight of a uniform rope.
    CHECK(got < angle(weight * 10 / 11));
    CHECK(got > angle(weight * 11 / 10));
}

TEST_CASE("A level rope falls with its terminal velocity") {
    World world(8);
    gphys_body_desc desc = of_mass(0.11f);
    desc.radius = 0.02f;
    const gphys_body_id rope = world.rope(line({0, 0, 0}, {0.1f, 0, 0}, 11), 0, desc);
    // Halves of links at the ends: they weigh half.
    const float half = 0.005f;
    for (const uint32_t end : {0u, 10u}) {
        REQUIRE(gphys_solver_set_masses(world.solver, rope, end, 1, &half, 4) == GPHYS_OK);
    }
    blow(world, rope, {{0, 0, 0}, 1.2f, 1.2f, 0});
    for (int i = 0; i < 600; ++i) world.step(frame);
    const double mass = 0.1, c = static_cast<double>(1.2f);
    const double terminal = std::sqrt(2 * mass * g / (c * c * 2 * static_cast<double>(0.02f)));
    for (const gphys_vec3& v : world.velocities(rope)) CHECK(std::fabs(-v.y / terminal - 1) < 1e-4);
}

TEST_CASE("Air has a velocity at each particle") {
    World world(8, {0, 0, 0});
    const gphys_body_id balls = world.particles(line({0, 0, 0}, {1, 0, 0}, 3), of_mass(0.001f));
    blow(world, balls, {{1, 0, 0}, 1e3f, 1, 0});
    const gphys_vec3 gusts[2] = {{0, 2, 0}, {0, 0, -3}};
    REQUIRE(gphys_solver_set_air_velocities(world.solver, balls, 1, 2, gusts, 12) == GPHYS_OK);
    for (int i = 0; i < 600; ++i) world.step(frame);
    const std::vector<gphys_vec3> v = world.velocities(balls);
    const gphys_vec3 expected[3] = {{1, 0, 0}, {1, 2, 0}, {1, 0, -3}};
    for (int i = 0; i < 3; ++i) CHECK(length(gphys::widen(v[i]) - gphys::widen(expected[i])) < 0.1);
    gphys_vec3 read[3];
    REQUIRE(gphys_solver_get_air_velocities(world.solver, balls, 0, 3, read, 12) == GPHYS_OK);
    CHECK((read[0].y == 0 && read[1].y == 2 && read[2].z == -3));
}

TEST_CASE("Wind ends when its density is 0, and forces that were set stay what they are") {
    World world(8, {0, 0, 0});
    const gphys_body_id rope = world.rope(line({0, 0, 0}, {0, -0.1f, 0}, 4), 0);
    const gphys_vec3 force{0, 0, 1};
    REQUIRE(gphys_solver_set_forces(world.solver, rope, 0, 4, &force, 0) == GPHYS_OK);
    blow(world, rope, {{5, 0, 0}, 1.2f, 1, 0});
    world.step(frame);
    gphys_vec3 forces[4];
    REQUIRE(gphys_solver_get_forces(world.solver, rope, 0, 4, forces, 12) == GPHYS_OK);
    CHECK((forces[1].x == 0 && forces[1].z == 1));
    CHECK(world.velocities(rope)[1].x > 0);
    blow(world, rope, {{5, 0, 0}, 0, 1, 0});
    const double before = momentum(world, rope, 0.25).linear.x;
    for (int i = 0; i < 10; ++i) world.step(frame);
    CHECK(std::fabs(momentum(world, rope, 0.25).linear.x - before) < 1e-7);
}

TEST_CASE("A snapshot in the wind goes on with the same bits, alone or with others") {
    World world(4), other(4);
    const gphys_body_id flag = world.cloth({0, 0, 0}, {1, 0, 0}, {0, -0.6f, 0}, 6, 5, of_mass(0.1f));
    world.pin(flag, 0);
    const gphys_body_id rope = world.rope(line({0, 0, 3}, {0, -0.1f, 0}, 5), 0);
    world.particles(line({0, 0, 6}, {0.3f, 0, 0}, 5));
    gphys_joint_id joint = 0;
    REQUIRE(gphys_solver_join(world.solver, flag, 5, rope, 0, -1, 0, &joint) == GPHYS_OK);
    blow(world, 0, {{4, 0, 2}, 1.2f, 1.2f, 0.8f});
    const gphys_vec3 gust{0, 1, 0};
    REQUIRE(gphys_solver_set_air_velocities(world.solver, flag, 3, 4, &gust, 0) == GPHYS_OK);
    for (int i = 0; i < 10; ++i) world.step(frame);
    REQUIRE(restore(other.solver, snapshot(world.solver)) == GPHYS_OK);
    for (int i = 0; i < 5; ++i) {
        world.step(frame);
        other.step(frame);
        CHECK(hash(world.solver) == hash(other.solver));
    }
}
