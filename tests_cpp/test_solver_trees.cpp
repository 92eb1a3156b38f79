// Trees of links, which are solved as a whole like chains.
#include <array>

#include "solver_world.h"

using namespace gphys;
using test::figure;
using test::World;

namespace {

constexpr double g = 9.81;
constexpr float frame = 1.0f / 60;

using Edges = std::vector<std::array<uint32_t, 2>>;

/// Particles of one kilogram each, links as long as placed.
gphys_body_id tree(World& world, const std::vector<gphys_vec3>& places, const Edges& edges,
                   gphys_body_desc desc = World::body_desc()) {
    desc.mass = static_cast<float>(places.size());
    const gphys_body_id body = world.particles(places, desc);
    for (const auto& [a, b] : edges) {
        gphys_constraint_id id = 0;
        REQUIRE(gphys_solver_add_distance(world.solver, body, a, b, -1, 0, &id) == GPHYS_OK);
    }
    return body;
}

gphys_solve_method method(const World& world, gphys_body_id body) {
    gphys_body_info info{};
    REQUIRE(gphys_solver_get_body_info(world.solver, body, &info) == GPHYS_OK);
    return info.method;
}

void set_mass(World& world, gphys_body_id body, uint32_t particle, float mass) {
    REQUIRE(gphys_solver_set_masses(world.solver, body, particle, 1, &mass, 4) == GPHYS_OK);
}

/// Particle 0 is the root. A branch at 1 leads to 2, one to 3, where it branches again.
const Edges twig = {{0, 1}, {1, 2}, {1, 3}, {3, 4}, {3, 5}};
const std::vector<gphys_vec3> twig_places = {
    {0, 0, 0}, {0.3f, 0, 0}, {0.5f, 0.125f, 0}, {0.5f, -0.25f, 0.1f}, {0.75f, -0.25f, 0.1f}, {0.5f, -0.25f, 0.5f}};

/// The same as rigid rods between points of one kilogram, the root held: accelerations from the multipliers that
/// keep the second derivatives of all squared lengths at zero, by a Runge-Kutta method of fourth order.
std::vector<Vec3> swung(double time, int steps) {
    const size_t n = twig_places.size(), m = twig.size();
    struct State {
        std::vector<Vec3> x, v;
    };
    const auto rate = [&](const State& s) {
        // Sum over links of c . c' / mass for links with a common particle that moves, and the right side.
        std::vector<std::vector<double>> a(m, std::vector<double>(m + 1, 0.0));
        const auto along = [&](size_t l) { return s.x[twig[l][1]] - s.x[twig[l][0]]; };
        for (size_t i = 0; i < m; ++i) {
            for (size_t j = 0; j < m; ++j) {
                for (const int end_i : {0, 1}) {
                    for (const int end_j : {0, 1}) {
                        if (twig[i][end_i] != twig[j][end_j] || twig[i][end_i] == 0) continue;
                        a[i][j] += (end_i == end_j ? 1 : -1) * dot(along(i), along(j));
                    }
                }
            }
            const Vec3 apart = s.v[twig[i][1]] - s.v[twig[i][0]];
            const double falls = (twig[i][0] == 0 ? 1 : 0) * -g;
            a[i][m] = -dot(apart, apart) - falls * along(i).y;
        }
        for (size_t k = 0; k < m; ++k) {
            for (size_t i = k + 1; i < m; ++i) {
                const double factor = a[i][k] / a[k][k];
                for (size_t j = k; j <= m; ++j) a[i][j] -= factor * a[k][j];
            }
        }
        State out{s.v, std::vector<Vec3>(n, Vec3{0, -g, 0})};
        out.v[0] = out.x[0] = {};
        std::vector<double> pull(m);
        for (size_t i = m; i-- > 0;) {
            pull[i] = a[i][m];
            for (size_t j = i + 1; j < m; ++j) pull[i] -= a[i][j] * pull[j];
            pull[i] /= a[i][i];
            if (twig[i][0] != 0) out.v[twig[i][0]] -= along(i) * pull[i];
            out.v[twig[i][1]] += along(i) * pull[i];
        }
        return out;
    };
    State s;
    for (const gphys_vec3& place : twig_places) s.x.push_back(widen(place));
    s.v.assign(n, Vec3{});
    const double h = time / steps;
    const auto moved = [&](const State& by, double part) {
        State out = s;
        for (size_t p = 0; p < n; ++p) out.x[p] += by.x[p] * (h * part), out.v[p] += by.v[p] * (h * part);
        return out;
    };
    for (int i = 0; i < steps; ++i) {
        const State a = rate(s), b = rate(moved(a, 0.5)), c = rate(moved(b, 0.5)), d = rate(moved(c, 1));
        for (size_t p = 0; p < n; ++p) {
            s.x[p] += (a.x[p] + (b.x[p] + c.x[p]) * 2 + d.x[p]) * (h / 6);
            s.v[p] += (a.v[p] + (b.v[p] + c.v[p]) * 2 + d.v[p]) * (h / 6);
        }
    }
    return s.x;
}

Vec3 momentum(const World& world, gphys_body_id body) {
    Vec3 sum;
    for (const gphys_vec3& v : world.velocities(body)) sum += widen(v);
    return sum;
}

Vec3 angular_momentum(const World& world, gphys_body_id body) {
    const auto at = world.positions(body), v = world.velocities(body);
    Vec3 sum;
    for (size_t p = 0; p < at.size(); ++p) sum += cross(widen(at[p]), widen(v[p]));
    return sum;
}

std::array<uint32_t, 2> hash_of(const World& world) {
    std::array<uint32_t, 2> hash{};
    REQUIRE(gphys_solver_get_hash(world.solver, hash.data()) == GPHYS_OK);
    return hash;
}

}  // namespace

TEST_CASE("a swinging tree comes to where rigid rods come, by the second order", "[simulation]") {
    // Halving the reference's step moves it by 1e-12.
    const std::vector<Vec3> expected = swung(1, 20000);
    double before = 0;
    for (const uint32_t substeps : {8u, 16u, 32u, 64u}) {
        World world(substeps);
        const gphys_body_id body = tree(world, twig_places, twig);
        world.pin(body, 0);
        REQUIRE(method(world, body) == GPHYS_SOLVE_DIRECT);
        for (int i = 0; i < 60; ++i) world.step(frame);
        double error = 0;
        for (uint32_t p = 0; p < expected.size(); ++p) {
            error = std::max(error, distance(world.position(body, p), expected[p]));
        }
        std::printf("    %u substeps: ", substeps);
        figure("off after a second", error, "m");
        // A second order's error falls by four; terms of the third are a fifth of it at these steps at most.
        if (before > 0) CHECK((before / error > 3.2 && before / error < 4.8));
        before = error;
        CHECK(world.stats(body).strain_max < 1e-6);
    }
    CHECK(before < 1e-3);
}

TEST_CASE("a tree with weights of a thousand times its other particles' keeps its lengths") {
    // Three boughs of 20 links from a trunk of 20.
    World world(8);
    std::vector<gphys_vec3> places = test::line({0, 0, 0}, {0.05f, 0, 0}, 21);
    Edges edges;
    for (uint32_t i = 0; i < 20; ++i) edges.push_back({i, i + 1});
    for (uint32_t bough = 0; bough < 3; ++bough) {
        const float aside = 0.03f * (static_cast<float>(bough) - 1);
        for (uint32_t i = 1; i <= 20; ++i) {
            const float n = static_cast<float>(i);
            edges.push_back(
                {i == 1 ? 20 : static_cast<uint32_t>(places.size()) - 1, static_cast<uint32_t>(places.size())});
            places.push_back({1 + 0.04f * n, 0, aside * n});
        }
    }
    const gphys_body_id body = tree(world, places, edges);
    world.pin(body, 0);
    for (const uint32_t tip : {40u, 60u, 80u}) set_mass(world, body, tip, 1000);
    double strain = 0;
    const double begin = world.energy(body);
    double most = begin;
    for (int i = 0; i < 600; ++i) {
        world.step(frame);
        strain = std::max(strain, static_cast<double>(world.stats(body).strain_max));
        most = std::max(most, world.energy(body));
    }
    figure("strain in 10 s", strain * 100, "%");
    figure("energy gained", (most - begin) / (3000 * g), "m");
    // As ropes with such a weight: the end of one whips where Newton's iterations are cut off.
    CHECK(strain < 5e-4);
    // Of weights that swing 1.8 m deep; kinetic energy is in float32.
    CHECK((most - begin) / (3000 * g) < 1e-4);
}

TEST_CASE("neither trees nor joined ropes gain energy in substeps of up to half a second") {
    for (const float heavy : {1.0f, 1000.0f}) {
        for (const float dt : {1e-6f, 1e-3f, 0.02f, 0.05f, 0.1f, 0.25f, 0.5f}) {
            for (const bool joined : {false, true}) {
                World world(1);
                if (joined) {
                    const auto& at = twig_places;
                    gphys_body_desc desc = World::body_desc();
                    desc.mass = 6;
                    const gphys_body_id stem = world.rope({at[0], at[1], at[3], at[4]}, 0, desc);
                    world.pin(stem, 0);
                    set_mass(world, stem, 3, heavy);
                    const gphys_body_id side = world.rope({at[1], at[2]}, 0, desc);
                    const gphys_body_id tip = world.rope({at[3], at[5]}, 0, desc);
                    gphys_joint_id joint = 0;
                    REQUIRE(gphys_solver_join(world.solver, stem, 1, side, 0, -1, 0, &joint) == GPHYS_OK);
                    REQUIRE(gphys_solver_join(world.solver, stem, 2, tip, 0, -1, 0, &joint) == GPHYS_OK);
                } else {
                    const gphys_body_id body = tree(world, twig_places, twig);
                    world.pin(body, 0);
                    set_mass(world, body, 4, heavy);
                }
                const double begin = world.energy();
                double most = begin, strain = 0;
                for (int i = 0; i < 400; ++i) {
                    world.step(dt);
                    most = std::max(most, world.energy());
                    strain = std::max(strain, static_cast<double>(world.stats().strain_max));
                }
                INFO("weight " << heavy << ", dt " << dt << (joined ? ", joined" : ", tree"));
                // Energies are float32, of weights that swing about a metre deep.
                CHECK(most - begin < 1e-6 * heavy * g);
                // A substep is found when no link lacks more than 1e-4 of its length.
                CHECK(strain < 1.01e-4);
            }
        }
    }
}

TEST_CASE("trees and joined ropes between pins too far apart share the stretch that cannot be avoided",
          "[simulation]") {
    for (const float over : {0.0005f, 0.001f, 0.01f, 0.03f, 0.06f, 0.3f, 1.0f}) {
        for (const bool joined : {false, true}) {
            World world(8);
            gphys_body_desc desc = World::body_desc();
            desc.damping = 5;
            const gphys_vec3 end{4 * (1 + over), 0, 0};
            gphys_body_id last = 0;
            if (joined) {
                const gphys_body_id rope = world.rope(test::line({0, 0, 0}, {0.1f, 0, 0}, 21), 0, desc);
                last = world.rope(test::line({2, 0, 0}, {0.1f, 0, 0}, 21), 0, desc);
                gphys_joint_id joint = 0;
                REQUIRE(gphys_solver_join(world.solver, rope, 20, last, 0, -1, 0, &joint) == GPHYS_OK);
                world.pin(rope, 0);
            } else {
                std::vector<gphys_vec3> places = test::line({0, 0, 0}, {0.1f, 0, 0}, 41);
                places.push_back({2, -0.1f, 0});  // hangs from the middle
                Edges edges{{20, 41}};
                for (uint32_t i = 0; i < 40; ++i) edges.push_back({i, i + 1});
                last = tree(world, places, edges, desc);
                world.pin(last, 0);
            }
            const uint32_t pin = joined ? 20 : 40;
            world.pin(last, pin);
            REQUIRE(gphys_solver_set_positions(world.solver, last, pin, 1, &end, 12) == GPHYS_OK);
            double strain = 0;
            for (int i = 0; i < 200; ++i) {
                world.step(frame);
                strain = std::max(strain, static_cast<double>(world.stats().strain_max));
            }
            INFO("too far by " << over << (joined ? ", joined" : ", tree"));
            // A link to a pin gives way half as far as one between two particles: 40 links as 39. What the links have
            // to yield beyond that to pull is less than a thousandth.
            const double share = static_cast<double>(over) * 40 / 39;
            CHECK(strain <= share * 1.001 + 1e-6);
            // What is moved into place at once is thrown, with a thousand joules at most, and comes to rest: 3.3
            // seconds damp that by exp(-33). What pulls 42 kg with up to 1e8 N then stirs them by 2 mm/s at most.
            CHECK(world.stats().kinetic_energy < 1e-4f);
        }
    }
}

TEST_CASE("three ropes of a tree hang in the triangle of their lengths") {
    // Pins 1.2 m apart, ropes of a metre to a knot, a weight on the third: the knot hangs 0.8 m deep.
    World world(8);
    std::vector<gphys_vec3> places{{0, 0, 0}};  // the knot
    Edges edges;
    const gphys_vec3 ends[3] = {{-0.6f, 0.8f, 0}, {0.6f, 0.8f, 0}, {0.6f, -0.8f, 0}};
    for (const gphys_vec3& end : ends) {
        for (uint32_t i = 1; i <= 10; ++i) {
            const float part = static_cast<float>(i) / 10;
            edges.push_back(
                {i == 1 ? 0 : static_cast<uint32_t>(places.size()) - 1, static_cast<uint32_t>(places.size())});
            places.push_back({end.x * part, end.y * part, end.z * part});
        }
    }
    gphys_body_desc desc = World::body_desc();
    desc.damping = 2;
    const gphys_body_id body = tree(world, places, edges, desc);
    world.pin(body, 10);
    world.pin(body, 20);
    set_mass(world, body, 30, 1e5f);
    for (int i = 0; i < 1200; ++i) world.step(frame);
    const Vec3 knot = world.position(body, 0), weight = world.position(body, 30);
    figure("knot off", length(knot), "m");
    figure("weight off", distance(weight, {0, -1, 0}), "m");
    // A rope of 10 kg that pulls with 6e5 N sags by w L / (8 T) = 2e-5 m, and is the shorter by 8 / 3 of its square.
    // What is left of the swing after 20 s is exp(-20) of 0.6 m; positions are float32.
    CHECK(length(knot) < 1e-6);
    CHECK(distance(weight, {0, -1, 0}) < 1e-6);
}

TEST_CASE("a tree that flies keeps its momentum") {
    World world(8, {0, 0, 0});
    const gphys_body_id body = tree(world, twig_places, twig);
    for (uint32_t p = 0; p < 6; ++p) {
        const float n = static_cast<float>(p);
        world.set_velocity(body, p, {0.3f * n, 1 - 0.25f * n, 0.1f * n * n});
    }
    world.step(frame);  // the part along the links has gone
    const Vec3 straight = momentum(world, body), turning = angular_momentum(world, body);
    for (int i = 0; i < 600; ++i) world.step(frame);
    figure("momentum lost", distance(momentum(world, body), straight) / length(straight), "");
    figure("angular momentum lost", distance(angular_momentum(world, body), turning) / length(turning), "");
    // Velocities are float32, and positions to 20 m, which six particles multiply by 5 m/s.
    CHECK(distance(momentum(world, body), straight) < 1e-6 * length(straight));
    CHECK(distance(angular_momentum(world, body), turning) < 2e-3 * length(turning));
}

TEST_CASE("a tree comes to lie on the ground, and stays a tree when it is cut") {
    World world(8);
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    gphys_body_desc desc = World::body_desc();
    desc.radius = 0.02f;
    desc.friction = 0.1f;  // more would hold a branch up on three legs
    std::vector<gphys_vec3> places = twig_places;
    for (gphys_vec3& place : places) place.y += 0.6f;
    const gphys_body_id body = tree(world, places, twig, desc);
    double deepest = 0, strain = 0;
    const auto run = [&](int frames) {
        for (int i = 0; i < frames; ++i) {
            world.step(frame);
            for (const gphys_vec3& at : world.positions(body)) {
                deepest = std::max(deepest, 0.02 - static_cast<double>(at.y));
            }
            strain = std::max(strain, static_cast<double>(world.stats(body).strain_max));
        }
    };
    run(300);
    figure("deepest", deepest, "m");
    figure("strain", strain * 100, "%");
    CHECK(deepest < 1e-6);
    CHECK(strain < 1e-3);
    CHECK(world.stats(body).contact_count == 6);
    CHECK(world.stats(body).kinetic_energy < 1e-6f);
    gphys_constraint_id cut = 0;
    REQUIRE(gphys_solver_add_distance(world.solver, body, 4, 5, -1, 0, &cut) == GPHYS_OK);  // a ring
    CHECK(method(world, body) == GPHYS_SOLVE_GRAPH);
    run(2);
    REQUIRE(gphys_solver_remove_constraint(world.solver, body, cut) == GPHYS_OK);
    CHECK(method(world, body) == GPHYS_SOLVE_DIRECT);
    run(2);
    CHECK(strain < 1e-3);
}

TEST_CASE("trees have the same bits whoever moves them, after a restore too, and go without a trace") {
    const auto grow = [](World& world) {
        std::vector<gphys_body_id> bodies;
        for (int i = 0; i < 20; ++i) {
            std::vector<gphys_vec3> places = twig_places;
            for (gphys_vec3& place : places) place.x += 3 * static_cast<float>(i);
            bodies.push_back(tree(world, places, twig));
            world.pin(bodies.back(), 0);
            world.rope({places[0], places[1], places[2]}, 0);
        }
        gphys_joint_id joint = 0;  // trees can be joined to others
        REQUIRE(gphys_solver_join(world.solver, bodies[0], 5, bodies[1], 0, -1, 0, &joint) == GPHYS_OK);
        return bodies;
    };
    gphys_solver_desc several = World::desc();
    several.worker_count = 4;
    World alone, shared(several);
    const auto mine = grow(alone), theirs = grow(shared);
    for (int i = 0; i < 20; ++i) alone.step(frame), shared.step(frame);
    CHECK(hash_of(alone) == hash_of(shared));

    uint32_t total = 0;
    REQUIRE(gphys_solver_get_snapshot(alone.solver, nullptr, 0, &total) == GPHYS_INCOMPLETE);
    std::vector<uint32_t> words(total);
    REQUIRE(gphys_solver_get_snapshot(alone.solver, words.data(), total, &total) == GPHYS_OK);
    World restored;
    REQUIRE(gphys_solver_restore(restored.solver, words.data(), total) == GPHYS_OK);
    CHECK(hash_of(restored) == hash_of(alone));
    for (World* world : {&alone, &shared, &restored}) {
        REQUIRE(gphys_solver_remove_body(world->solver, mine[7]) == GPHYS_OK);
        for (int i = 0; i < 20; ++i) world->step(frame);
    }
    CHECK(hash_of(alone) == hash_of(shared));
    CHECK(hash_of(alone) == hash_of(restored));
    CHECK(mine[7] == theirs[7]);
}
