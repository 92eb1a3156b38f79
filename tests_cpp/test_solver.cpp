// The hard cases of particle and constraint solvers, each against its exact answer.
#include <cstring>

#include "resources.h"
#include "solver_world.h"

using namespace gphys;
using test::figure;
using test::line;
using test::World;

namespace {

constexpr double g = 9.81f;  // as the solver is given it

double length_between(const std::vector<gphys_vec3>& p, size_t a, size_t b) {
    return distance(widen(p[a]), widen(p[b]));
}

}  // namespace

TEST_CASE("free fall is exact whatever the steps") {
    World world(3);
    const gphys_body_id body = world.particles({{0, 0, 0}});
    world.set_velocity(body, 0, {1, 30, -2});
    test::Random random(1);
    double t = 0;
    while (t < 10) {
        const float dt = random.uniform_float(0.002f, 0.05f);
        world.step(dt);
        t += static_cast<double>(dt);
    }
    const Vec3 exact{t, 30 * t - g * t * t / 2, -2 * t};
    const double error = distance(world.position(body), exact);
    figure("free fall, error after 10 s", error, "m");
    CHECK(error <= 1e-4);  // of which float32 output is 2e-5 at 200 m
}

TEST_CASE("damping is exp(-c t) at any step") {
    for (const uint32_t substeps : {1u, 7u, 100u}) {
        World world(substeps, {0, 0, 0});
        gphys_body_desc desc = World::body_desc();
        desc.damping = 3;
        const gphys_body_id body = world.particles({{0, 0, 0}}, desc);
        world.set_velocity(body, 0, {1, 0, 0});
        for (int i = 0; i < 10; ++i) world.step(0.1f);
        // x(t) = (1 - exp(-3 t)) / 3; dt is 0.1 rounded to float, 1.5e-9 off.
        CHECK(std::fabs(world.position(body).x - (1 - std::exp(-3.0)) / 3) < 1e-7);
    }
}

TEST_CASE("an elastic link oscillates at the right rate, with an error of second order") {
    // 1 kg on a compliance 1 / (2 pi)^2: 1 Hz. Started 1 m stretched, no gravity.
    double amplitude = 0, errors[3];
    for (int level = 0; level < 3; ++level) {
        World world(5u << level, {0, 0, 0});
        gphys_body_desc desc = World::body_desc();
        desc.mass = 2;
        desc.compliance = static_cast<float>(1 / (4 * pi * pi));
        const gphys_body_id body = world.rope({{0, 0, 0}, {11, 0, 0}}, 10, desc);
        world.pin(body, 0);
        // At a turning point a phase error counts by its square, so what is lost is amplitude; a quarter
        // before it the phase error is the position.
        for (int i = 0; i < 585; ++i) world.step(1.0f / 60);
        errors[level] = std::fabs(world.position(body, 1).x - 10);
        for (int i = 0; i < 15; ++i) world.step(1.0f / 60);
        if (level == 1) amplitude = std::fabs(world.position(body, 1).x - 11);
    }
    figure("oscillator, amplitude lost in 10 s at 600 Hz", amplitude, "");
    CHECK(amplitude < 1e-4);
    for (int level = 0; level < 2; ++level) {
        const double slope = std::log2(errors[level] / errors[level + 1]);
        figure("oscillator, order of convergence", slope, "");
        CHECK(std::fabs(slope - 2) <= 0.1);
    }
}

TEST_CASE("a pendulum from the horizontal keeps its energy") {
    World world(4);
    const gphys_body_id body = world.rope({{0, 0, 0}, {1, 0, 0}}, 0);
    world.pin(body, 0);
    const double scale = 0.5 * g;  // half a kilogram falls one metre
    for (int i = 0; i < 240 * 60; ++i) world.step(1.0f / 240);
    const double drift = std::fabs(world.energy()) / scale;
    figure("pendulum, energy drift in 60 s", drift, "");
    CHECK(drift <= 5e-3);
    CHECK(world.stats().strain_max < 1e-6f);
}

TEST_CASE("a hanging chain takes the shape of the discrete catenary") {
    // 100 links of 0.1 m between supports 6 m apart; settled under strong damping.
    // With equal masses at the joints tan(theta_j) = (j + 1/2 - n/2) k, and sum of l cos(theta_j) = 6.
    constexpr uint32_t links = 100;
    const double l = 0.1f, span = 6;
    const auto angle_tangent = [](double k, uint32_t j) { return (j + 0.5 - links / 2.0) * k; };
    double low = 0, high = 10;
    for (int i = 0; i < 200; ++i) {
        const double k = (low + high) / 2;
        double width = 0;
        for (uint32_t j = 0; j < links; ++j) width += l / std::hypot(1, angle_tangent(k, j));
        (width > span ? low : high) = k;
    }
    double sag = 0;
    for (uint32_t j = 0; j < links / 2; ++j) sag += l * angle_tangent(low, j) / std::hypot(1, angle_tangent(low, j));

    World world;
    gphys_body_desc desc = World::body_desc();
    desc.damping = 5;
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i <= links; ++i) {  // a circular arc, to begin with
        const double turn = pi * i / links;
        points.push_back(narrow(Vec3{3 - 3 * std::cos(turn), -3 * std::sin(turn), 0}));
    }
    const gphys_body_id body = world.rope(points, 0.1f, desc);
    world.pin(body, 0);
    world.pin(body, links);
    for (int i = 0; i < 1200; ++i) world.step(1.0f / 60);
    const double error = std::fabs(world.position(body, links / 2).y - sag) / std::fabs(sag);
    figure("catenary, relative error of the sag", error, "");
    CHECK(std::fabs(sag + 3.628) < 1e-3);
    CHECK(error <= 1e-5);
}

TEST_CASE("a rope of 1000 links does not stretch under a million times a link's weight") {
    for (const float ratio : {1.0f, 1e3f, 1e6f}) {
        for (const bool swing : {false, true}) {
            World world(4);
            gphys_body_desc desc = World::body_desc();
            desc.mass = 1001;
            const gphys_body_id body = world.rope(
                line({0, 0, 0}, swing ? gphys_vec3{0.01f, 0, 0} : gphys_vec3{0, -0.01f, 0}, 1001), 0.01f, desc);
            world.pin(body, 0);
            REQUIRE(gphys_solver_set_masses(world.solver, body, 1000, 1, &ratio, 4) == GPHYS_OK);
            float peak = 0;
            for (int i = 0; i < 90; ++i) {
                world.step(1.0f / 60);
                peak = std::max(peak, world.stats().strain_max);
            }
            std::printf("    rope 1000, tip mass %g, %s: peak strain %.2g %%\n", static_cast<double>(ratio),
                        swing ? "swinging" : "hanging", static_cast<double>(peak) * 100);
            CHECK(peak <= (swing ? 5e-4f : 2e-4f));
        }
    }
}

namespace {

constexpr uint32_t swinging_chain_particles = 31;

/// 30 links of 0.1 m, tip mass 10, from the horizontal, after a second; SHAKE with a step of 1e-5 s in double.
std::vector<Vec3> swinging_chain_reference() {
    constexpr uint32_t n = swinging_chain_particles;
    constexpr double h = 1e-5, l = 0.1f;
    std::vector<Vec3> x(n), before(n);
    for (uint32_t i = 0; i < n; ++i) x[i] = {i * l, 0, 0};
    const auto inverse_mass = [](uint32_t i) { return i == 0 ? 0.0 : i == n - 1 ? 0.1 : 1.0; };
    for (uint32_t i = 0; i < n; ++i) before[i] = x[i] + (i ? Vec3{0, -g * h * h / 2, 0} : Vec3{});
    for (int step = 0; step < 100000; ++step) {
        std::vector<Vec3> next(n);
        for (uint32_t i = 0; i < n; ++i) next[i] = i ? x[i] * 2 - before[i] + Vec3{0, -g * h * h, 0} : x[i];
        // Newton on the tridiagonal system of the n - 1 links; directions at the start of the step.
        for (int iteration = 0; iteration < 2; ++iteration) {
            double pivot[n], value[n], lambda[n], over[n];
            for (uint32_t j = 0; j + 1 < n; ++j) {
                const Vec3 d = x[j + 1] - x[j], e = next[j + 1] - next[j];
                double diagonal = 2 * dot(e, d) * (inverse_mass(j) + inverse_mass(j + 1));
                double residual = dot(e, e) - l * l;
                over[j] = j + 2 < n ? -2 * dot(e, x[j + 2] - x[j + 1]) * inverse_mass(j + 1) : 0;
                if (j > 0) {
                    const double under = -2 * dot(e, x[j] - x[j - 1]) * inverse_mass(j);
                    diagonal -= under * over[j - 1] / pivot[j - 1];
                    residual -= under * value[j - 1] / pivot[j - 1];
                }
                pivot[j] = diagonal;
                value[j] = residual;
            }
            for (uint32_t j = n - 1; j-- > 0;) {
                lambda[j] = (value[j] - (j + 2 < n ? over[j] * lambda[j + 1] : 0)) / pivot[j];
            }
            for (uint32_t j = 0; j + 1 < n; ++j) {
                const Vec3 d = (x[j + 1] - x[j]) * lambda[j];
                next[j] += d * inverse_mass(j);
                next[j + 1] -= d * inverse_mass(j + 1);
            }
        }
        before = x;
        x = next;
    }
    return x;
}

struct SwingingChain {
    double rms;                // metres from the reference after a second
    uint32_t substeps_a_step;  // mean
};

SwingingChain swing_chain(const gphys_solver_desc& settings, const std::vector<Vec3>& reference) {
    constexpr uint32_t n = swinging_chain_particles;
    World world(settings);
    gphys_body_desc desc = World::body_desc();
    desc.mass = n;
    const gphys_body_id body = world.rope(line({0, 0, 0}, {0.1f, 0, 0}, n), 0.1f, desc);
    world.pin(body, 0);
    const float tip = 10;
    REQUIRE(gphys_solver_set_masses(world.solver, body, n - 1, 1, &tip, 4) == GPHYS_OK);
    uint32_t substeps = 0;
    for (int i = 0; i < 60; ++i) {
        world.step(1.0f / 60);
        substeps += world.substeps(body);
    }
    double squares = 0;
    for (uint32_t i = 0; i < n; ++i) squares += length_squared(world.position(body, i) - reference[i]);
    return {std::sqrt(squares / n), substeps / 60};
}

}  // namespace

TEST_CASE("a swinging chain follows the reference") {
    const std::vector<Vec3> reference = swinging_chain_reference();
    for (const uint32_t substeps : {4u, 8u, 16u}) {
        const SwingingChain chain = swing_chain(World::desc(substeps), reference);
        std::printf("    chain of 30, %u substeps: rms %.3g m from the reference\n", substeps, chain.rms);
        CHECK(chain.rms <= 0.016 / (substeps * substeps));  // 1e-3 with 4, and an error of second order
    }
}

TEST_CASE("a rope with a weight comes as close to the reference as its tolerance says") {
    const std::vector<Vec3> reference = swinging_chain_reference();
    gphys_solver_desc settings = World::desc();
    const SwingingChain untold = swing_chain(settings, reference);
    for (const float tolerance : {1e-2f, 1e-3f, 1e-4f}) {
        settings.tolerance = tolerance;
        settings.max_substeps = 200;
        const SwingingChain chain = swing_chain(settings, reference);
        std::printf("    tolerance %g m: %u substeps a step, rms %.3g m\n", static_cast<double>(tolerance),
                    chain.substeps_a_step, chain.rms);
        CHECK(chain.rms <= tolerance);
    }
    std::printf("    without: %u substeps a step, rms %.3g m\n", untold.substeps_a_step, untold.rms);
    CHECK(untold.rms > 1e-4);
}

TEST_CASE("cloth on two corners hardly stretches", "[simulation]") {
    constexpr uint32_t n = 100;
    World world(20);
    gphys_body_desc desc = World::body_desc();
    desc.mass = n * n;
    desc.damping = 1;
    const gphys_body_id body = world.cloth({0, 0, 0}, {1.98f, 0, 0}, {0, 0, 1.98f}, n, n, desc);
    world.pin(body, 0);
    world.pin(body, n - 1);
    double peak = 0, stretched = 0;
    for (int i = 0; i < 90; ++i) {
        world.step(1.0f / 60);
        const std::vector<gphys_vec3> p = world.positions(body);
        stretched = 0;
        for (uint32_t k = 0; k < n * n; ++k) {
            if (k % n + 1 < n) stretched = std::max(stretched, length_between(p, k, k + 1) / 0.02 - 1);
            if (k + n < n * n) stretched = std::max(stretched, length_between(p, k, k + n) / 0.02 - 1);
        }
        peak = std::max(peak, stretched);
    }
    figure("cloth 100 x 100, peak stretch along the threads", peak * 100, "%");
    figure("cloth 100 x 100, stretch at the end", stretched * 100, "%");
    CHECK(peak <= 0.01);
    CHECK(stretched <= 0.005);
}

TEST_CASE("a cloth in free space keeps its momentum") {
    constexpr uint32_t n = 20;
    World world(8, {0, 0, 0});
    gphys_body_desc desc = World::body_desc();
    desc.mass = n * n;
    const gphys_body_id body = world.cloth({-0.95f, 0, -0.95f}, {1.9f, 0, 0}, {0, 0, 1.9f}, n, n, desc);
    const auto momenta = [&](Vec3& linear, Vec3& angular) {
        const auto x = world.positions(body), v = world.velocities(body);
        Vec3 centre;
        for (uint32_t i = 0; i < n * n; ++i) centre += widen(x[i]) / (n * n);
        linear = angular = {};
        for (uint32_t i = 0; i < n * n; ++i) linear += widen(v[i]), angular += cross(widen(x[i]) - centre, widen(v[i]));
    };
    const auto start = world.positions(body);
    for (uint32_t i = 0; i < n * n; ++i) {
        world.set_velocity(body, i, narrow(cross(Vec3{0, 2, 0}, widen(start[i])) + Vec3{1, 0, 0}));
    }
    Vec3 linear0, angular0, linear1, angular1;
    momenta(linear0, angular0);
    for (int i = 0; i < 300; ++i) world.step(1.0f / 60);
    momenta(linear1, angular1);
    const double lost = distance(linear0, linear1) / length(linear0);
    const double lost_spin = distance(angular0, angular1) / length(angular0);
    figure("spinning cloth, linear momentum lost in 5 s", lost, "");
    figure("spinning cloth, angular momentum lost in 5 s", lost_spin, "");
    CHECK(lost <= 1e-3);
    CHECK(lost_spin <= 1e-2);
}

TEST_CASE("nothing gets worse 100 km from the origin") {
    double errors[2];
    for (int far = 0; far < 2; ++far) {
        const float offset = far ? 1e5f : 0.0f;
        World world(64);
        const gphys_body_id body = world.rope(line({offset, offset, 0}, {0.125f, 0, 0}, 9), 0.125f);
        world.pin(body, 0);
        for (int i = 0; i < 60; ++i) world.step(1.0f / 60);
        errors[far] = static_cast<double>(world.stats().strain_max);
    }
    figure("strain at the origin", errors[0], "");
    figure("strain at 1e5 m", errors[1], "");
    CHECK(errors[1] <= 2 * errors[0] + 1e-9);  // 1e-9: 100 times the rounding of 1e5 m, per 0.125 m
}

TEST_CASE("any time step is finite and adds no energy") {
    for (const float dt : {1e-6f, 1e-4f, 0.01f, 0.1f, 0.5f}) {
        for (int kind = 0; kind < 2; ++kind) {
            World world(4);
            gphys_body_id body = 0;
            if (kind == 0) {
                body = world.rope(line({0, 0, 0}, {0.1f, 0, 0}, 21), 0.1f);
                world.pin(body, 0);
            } else {
                body = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 11, 11);
                world.pin(body, 0);
                world.pin(body, 10);
            }
            const double before = world.energy();
            double most = before;
            for (int i = 0; i < 200; ++i) {
                world.step(dt);
                most = std::max(most, world.energy());
            }
            CAPTURE(dt, kind);
            CHECK(test::all_finite(world.positions(body)));
            // The body has 1 kg and 2 m to fall: 1 % of that energy.
            CHECK(most - before <= 0.2);
        }
    }
}

TEST_CASE("undamped bodies do not gain energy in the long run", "[simulation]") {
    for (int kind = 0; kind < 7; ++kind) {
        World world(8);
        gphys_body_id body = 0;
        if (kind == 0) body = world.rope(line({0, 0, 0}, {0.1f, 0, 0}, 31), 0.1f);
        if (kind == 1) body = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 16, 16);
        if (kind == 2) {  // a closed ring: a graph
            std::vector<gphys_vec3> ring;
            for (int i = 0; i < 24; ++i) ring.push_back(narrow(Vec3{std::cos(i * pi / 12), 0, std::sin(i * pi / 12)}));
            body = world.rope(ring, 0);
            gphys_constraint_id id;
            REQUIRE(gphys_solver_add_distance(world.solver, body, 23, 0, -1, 0, &id) == GPHYS_OK);
        }
        gphys_body_desc desc = World::body_desc();
        if (kind == 3) {
            desc.compliance = 1e-3f;
            body = world.rope(line({0, 0, 0}, {0.1f, 0, 0}, 11), 0.1f, desc);
        }
        if (kind == 4 || kind == 5) {
            desc.cloth_flags = kind == 4 ? 0 : GPHYS_CLOTH_BEND;
            body = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 16, 16, desc);
        }
        if (kind == 6) {  // a net of strings
            std::vector<gphys_vec3> knots;
            for (int i = 0; i < 64; ++i) knots.push_back(narrow(Vec3{0.1 * (i % 8), 0, 0.1 * (i / 8)}));
            body = world.particles(knots);
            gphys_constraint_id id;
            for (uint32_t i = 0; i < 64; ++i) {
                if (i % 8 < 7) gphys_solver_add_max_distance(world.solver, body, i, i + 1, -1, 0, &id);
                if (i < 56) gphys_solver_add_max_distance(world.solver, body, i, i + 8, -1, 0, &id);
            }
        }
        world.pin(body, 0);
        const double before = world.energy();
        double most = before;
        for (int i = 0; i < 1200; ++i) {
            world.step(1.0f / 60);
            most = std::max(most, world.energy());
        }
        CAPTURE(kind);
        std::printf("    undamped for 20 s, kind %d: energy %+.3g J at most, of %.3g J\n", kind, most - before, g);
        CHECK(most - before < 0.01 * g);
    }
}

TEST_CASE("degenerate systems stay finite and where they are") {
    const auto settle = [](World& world, gphys_body_id body, double reach) {
        for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
        for (const gphys_vec3& p : world.positions(body)) {
            CHECK(std::isfinite(p.x + p.y + p.z));
            CHECK(length(widen(p)) <= reach);
        }
    };
    SECTION("a straight rope between two pins") {
        World world;
        const gphys_body_id body = world.rope(line({0, 0, 0}, {0.1f, 0, 0}, 11), 0.1f);
        world.pin(body, 0), world.pin(body, 10);
        settle(world, body, 1.1);
        CHECK(std::fabs(world.position(body, 5).y) < 0.01);
    }
    SECTION("pins twice as far apart as the rope is long") {
        World world;
        const gphys_body_id body = world.rope(line({0, 0, 0}, {0.2f, 0, 0}, 11), 0.1f);
        world.pin(body, 0), world.pin(body, 10);
        settle(world, body, 2.2);
        CHECK(std::fabs(world.position(body, 5).x - 1) < 1e-3);  // the stretch is shared evenly
    }
    SECTION("all particles in one place") {
        World world;
        const gphys_body_id body = world.rope(std::vector<gphys_vec3>(11, {0, 0, 0}), 0.1f);
        world.pin(body, 0);
        settle(world, body, 1.01);
    }
    SECTION("links without length") {
        World world;
        const gphys_body_id body = world.rope(std::vector<gphys_vec3>(5, {0, 0, 0}), 0);
        world.pin(body, 0);
        settle(world, body, 1e-3);
    }
    SECTION("everything pinned") {
        World world;
        const gphys_body_id body = world.rope(line({0, 0, 0}, {0.3f, 0, 0}, 4), 0.1f);
        REQUIRE(gphys_solver_set_pinned(world.solver, body, 0, 4, 1) == GPHYS_OK);
        settle(world, body, 1);
    }
    SECTION("a cloth between pins too far apart, all corners") {
        World world;
        const gphys_body_id body = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 8, 8);
        for (const uint32_t corner : {0u, 7u, 56u, 63u}) world.pin(body, corner);
        const gphys_vec3 away{3, 0, 3};
        REQUIRE(gphys_solver_set_positions(world.solver, body, 63, 1, &away, 12) == GPHYS_OK);
        settle(world, body, 10);
    }
}

TEST_CASE("the method follows from the constraints") {
    World world;
    const auto method = [&](gphys_body_id body) {
        gphys_body_info info{};
        REQUIRE(gphys_solver_get_body_info(world.solver, body, &info) == GPHYS_OK);
        return info.method;
    };
    const gphys_body_id body = world.particles(line({0, 0, 0}, {1, 0, 0}, 5));
    gphys_constraint_id ids[5];
    CHECK(method(body) == GPHYS_SOLVE_FREE);
    const uint32_t order[] = {2, 0, 3, 1, 4};  // a chain through 2, 0, 3, 1, 4
    for (int i = 0; i < 4; ++i) {
        REQUIRE(gphys_solver_add_distance(world.solver, body, order[i], order[i + 1], -1, 0, &ids[i]) == GPHYS_OK);
        CHECK(method(body) == GPHYS_SOLVE_DIRECT);
    }
    REQUIRE(gphys_solver_add_distance(world.solver, body, 4, 2, -1, 0, &ids[4]) == GPHYS_OK);  // a ring
    CHECK(method(body) == GPHYS_SOLVE_GRAPH);
    world.step(0.01f);
    REQUIRE(gphys_solver_remove_constraint(world.solver, body, ids[1]) == GPHYS_OK);
    CHECK(method(body) == GPHYS_SOLVE_DIRECT);
    world.step(0.01f);
    REQUIRE(gphys_solver_add_distance(world.solver, body, 4, 3, -1, 0, &ids[1]) == GPHYS_OK);  // and another
    CHECK(method(body) == GPHYS_SOLVE_GRAPH);
    REQUIRE(gphys_solver_remove_constraint(world.solver, body, ids[3]) == GPHYS_OK);  // leaves a branch, at 4
    CHECK(method(body) == GPHYS_SOLVE_DIRECT);
    world.step(0.01f);
    CHECK(world.stats(body).strain_max < 1e-6);
}

TEST_CASE("a value that is not a number is refused and nothing else changes") {
    std::vector<gphys_vec3> results[2];
    for (int attempt = 0; attempt < 2; ++attempt) {
        World world;
        const gphys_body_id rope = world.rope(line({0, 0, 0}, {0.1f, 0, 0}, 9), 0);
        const gphys_body_id other = world.particles({{5, 5, 5}, {6, 5, 5}});
        if (attempt == 1) {
            const gphys_vec3 bad[] = {{1, 1, 1}, {0, NAN, 0}};
            CHECK(gphys_solver_set_positions(world.solver, other, 0, 2, bad, 12) == GPHYS_ERROR_INVALID_ARGUMENT);
            CHECK(gphys_solver_set_velocities(world.solver, other, 0, 2, bad, 12) == GPHYS_ERROR_INVALID_ARGUMENT);
            CHECK(gphys_solver_set_forces(world.solver, rope, 0, 2, bad, 12) == GPHYS_ERROR_INVALID_ARGUMENT);
        }
        for (int i = 0; i < 30; ++i) world.step(1.0f / 60);
        results[attempt] = world.positions(rope);
        const auto others = world.positions(other);
        results[attempt].insert(results[attempt].end(), others.begin(), others.end());
    }
    CHECK(std::memcmp(results[0].data(), results[1].data(), results[0].size() * sizeof(gphys_vec3)) == 0);
}

TEST_CASE("a body that runs away stops at the border of the world and leaves others alone") {
    World world;
    const gphys_body_id runaway = world.rope({{9e14f, 0, 0}, {9e14f, 1, 0}}, 1), calm = world.particles({{0, 0, 0}});
    REQUIRE(gphys_solver_set_velocities(world.solver, runaway, 0, 2, std::vector<gphys_vec3>(2, {1e15f, 0, 0}).data(),
                                        12) == GPHYS_OK);
    for (int i = 0; i < 100; ++i) world.step(0.5f);
    for (const gphys_vec3& p : world.positions(runaway)) CHECK(std::fabs(p.x) <= GPHYS_MAX_COORDINATE);
    CHECK(std::fabs(world.position(calm).y + 0.5 * g * 50 * 50) < 0.01);
}

TEST_CASE("advance makes the same steps however time is divided") {
    World whole, pieces;
    const gphys_body_id a = whole.particles({{0, 0, 0}}), b = pieces.particles({{0, 0, 0}});
    uint32_t steps = 0, made = 0;
    float leftover = 0;
    for (int i = 0; i < 10; ++i) {
        REQUIRE(gphys_solver_advance(whole.solver, nullptr, 0.1f, &steps, &leftover) == GPHYS_OK);
        CHECK(steps == 6);
    }
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(gphys_solver_advance(pieces.solver, nullptr, 0.001f, &steps, &leftover) == GPHYS_OK);
        made += steps;
        CHECK((leftover >= 0 && leftover < 1));
    }
    CHECK(made == 60);
    CHECK(whole.position(a) == pieces.position(b));
    REQUIRE(gphys_solver_advance(whole.solver, nullptr, 100, &steps, nullptr) == GPHYS_OK);
    CHECK(steps == 8);  // max_steps; the rest is dropped
}

TEST_CASE("a step allocates nothing once the bodies are known, and running out of memory changes nothing") {
    test::WatchedMemory memory;
    const gphys_allocator hooks{[](void* user, size_t size, size_t alignment) -> void* {
                                    try {
                                        return static_cast<test::WatchedMemory*>(user)->allocate(size, alignment);
                                    } catch (const std::bad_alloc&) {
                                        return nullptr;
                                    }
                                },
                                [](void* user, void* p, size_t size, size_t alignment) {
                                    static_cast<test::WatchedMemory*>(user)->deallocate(p, size, alignment);
                                },
                                &memory};
    {
        World scene_owner;
        const gphys_plane floor{{0, 1, 0}, -0.5f};
        scene_owner.model(GPHYS_SHAPE_PLANE, &floor);
        gphys_solver_desc desc;
        gphys_solver_desc_init(&desc, sizeof desc);
        desc.allocator = &hooks;
        gphys_solver* solver = nullptr;
        REQUIRE(gphys_solver_create(&desc, &solver) == GPHYS_OK);
        const gphys_vec3 corner{0, 0, 0}, u{1, 0, 0}, v{0, 0, 1};
        gphys_body_id cloth = 0;
        for (long allowed = 0;; ++allowed) {
            memory.fail_at = memory.allocations + allowed;
            const gphys_status status = gphys_solver_add_cloth(solver, nullptr, &corner, &u, &v, 8, 8, &cloth);
            memory.fail_at = -1;
            if (status == GPHYS_OK) break;
            REQUIRE(status == GPHYS_ERROR_OUT_OF_MEMORY);
            uint32_t total = 1;
            CHECK(gphys_solver_get_bodies(solver, nullptr, 0, &total) == GPHYS_OK);
            CHECK(total == 0);
        }
        memory.fail_at = memory.allocations;
        CHECK(gphys_solver_step(solver, scene_owner.scene, 0.01f) == GPHYS_ERROR_OUT_OF_MEMORY);
        memory.fail_at = -1;
        for (int i = 0; i < 60; ++i) REQUIRE(gphys_solver_step(solver, scene_owner.scene, 0.01f) == GPHYS_OK);
        const long before = memory.allocations;
        for (int i = 0; i < 60; ++i) REQUIRE(gphys_solver_step(solver, scene_owner.scene, 0.01f) == GPHYS_OK);
        CHECK(memory.allocations == before);
        gphys_solver_destroy(solver);
    }
    CHECK(memory.bytes_in_use == 0);
}
