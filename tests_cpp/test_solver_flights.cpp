// What free particles know of the models around them (flight_planes.h), which nothing may show but the time. Every case
// of events runs beside a solver that knows nothing, because it is restored from its own snapshot before each step.
#include <functional>

#include "c_api/handles.h"
#include "snapshots.h"
#include "solver/solver.h"

using namespace gphys;
using test::figure;
using test::World;

namespace {

constexpr float frame = 1.0f / 60;

/// A square of 2 x 2 x cells^2 triangles about the origin, with gentle hills.
struct Hills {
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
    gphys_mesh* mesh = nullptr;

    explicit Hills(float width, uint32_t cells = 12, float height = 0.05f) {
        for (uint32_t i = 0; i <= cells; ++i) {
            for (uint32_t j = 0; j <= cells; ++j) {
                const float x = width * (static_cast<float>(i) / static_cast<float>(cells) - 0.5f);
                const float z = width * (static_cast<float>(j) / static_cast<float>(cells) - 0.5f);
                vertices.insert(vertices.end(), {x, height * std::sin(3 * x) * std::cos(2 * z), z});
                if (i == cells || j == cells) continue;
                const uint32_t a = i * (cells + 1) + j, b = a + cells + 1;
                indices.insert(indices.end(), {a, a + 1, b, a + 1, b + 1, b});
            }
        }
        gphys_mesh_desc desc;
        gphys_mesh_desc_init(&desc, sizeof desc);
        desc.deformable = 1;
        REQUIRE(gphys_mesh_create(&desc, vertices.data(), 12, static_cast<uint32_t>(vertices.size() / 3),
                                  indices.data(), static_cast<uint32_t>(indices.size()), &mesh) == GPHYS_OK);
    }
    Hills(const Hills&) = delete;
    ~Hills() { gphys_mesh_destroy(mesh); }
};

/// Particles that have come to rest on hills, and one that bounces, so that the body is not steady.
struct Gravel : World {
    Hills hills{4};
    gphys_model_id ground = 0;
    gphys_body_id body = 0;

    Gravel() : World(4) {
        ground = model(GPHYS_SHAPE_MESH, hills.mesh);
        std::vector<gphys_vec3> points;
        for (int i = 0; i < 60; ++i) {
            points.push_back({-1.5f + 0.05f * static_cast<float>(i), 0.08f, 0.02f * static_cast<float>(i % 9)});
        }
        points.push_back({0, 40, 0});
        body = particles(points, test::point_mass(0.02f, 0.6f, 0));
        for (int i = 0; i < 100; ++i) step(frame);
    }
    /// Those whose planes have been kept from the last step.
    uint32_t kept() const {
        const Body& internals = unwrap(solver)->body(body);
        uint32_t count = 0;
        for (uint32_t p = 0; p < internals.flight.all.size(); ++p) {
            const FlightBall& ball = internals.flight.all[p];
            count += ball.sight == Sight::clear && ball.count > 0 && ball.center == internals.particles.position[p];
        }
        return count;
    }
    void move_ground(gphys_vec3 at, float turned) {
        const gphys_transform place{at, {std::sin(turned / 2), 0, 0, std::cos(turned / 2)}, 1};
        REQUIRE(gphys_scene_set_transform(scene, ground, &place) == GPHYS_OK);
    }
};

struct Event {
    const char* name;
    std::function<void(Gravel&)> happens;
};

const std::vector<Event>& events() {
    static const std::vector<Event> all{
        {"nothing", [](Gravel&) {}},
        {"the ground goes", [](Gravel& g) { REQUIRE(gphys_scene_remove(g.scene, g.ground) == GPHYS_OK); }},
        {"the ground sinks",
         [](Gravel& g) {
             g.move_ground({0, -0.1f, 0}, 0);
         }},
        {"the ground tilts",
         [](Gravel& g) {
             g.move_ground({0, 0, 0}, 0.02f);
         }},
        {"the ground changes its form",
         [](Gravel& g) {
             std::vector<float> flat = g.hills.vertices;
             for (size_t i = 1; i < flat.size(); i += 3) flat[i] = -0.2f;
             REQUIRE(gphys_mesh_set_vertices(g.hills.mesh, flat.data(), 12, static_cast<uint32_t>(flat.size() / 3)) ==
                     GPHYS_OK);
         }},
        {"the ground becomes a ball",
         [](Gravel& g) {
             const gphys_sphere ball{{0, -1, 0}, 0.9f};
             REQUIRE(gphys_scene_set_shape(g.scene, g.ground, GPHYS_SHAPE_SPHERE, &ball) == GPHYS_OK);
         }},
        {"the ground is in other layers",
         [](Gravel& g) { REQUIRE(gphys_scene_set_layers(g.scene, g.ground, 0x80000000u) == GPHYS_OK); }},
        {"a model is added",
         [](Gravel& g) {
             const gphys_aabb box{{-0.5f, -0.2f, -0.2f}, {0.5f, 0.07f, 0.3f}};
             g.model(GPHYS_SHAPE_AABB, &box);
         }},
        {"radii",
         [](Gravel& g) {
             const float radius = 0.015f;
             REQUIRE(gphys_solver_set_radii(g.solver, g.body, 0, 30, &radius, 0) == GPHYS_OK);
         }},
        {"friction ends",
         [](Gravel& g) {
             const float none = 0;
             REQUIRE(gphys_solver_set_friction_factors(g.solver, g.body, 0, 30, &none, 0) == GPHYS_OK);
         }},
        {"gravity turns",
         [](Gravel& g) {
             const gphys_vec3 aside{8, -6, 0};
             REQUIRE(gphys_solver_set_gravity(g.solver, &aside) == GPHYS_OK);
         }},
        {"forces",
         [](Gravel& g) {
             const gphys_vec3 up{0.2f, 0.5f, 0};
             REQUIRE(gphys_solver_set_forces(g.solver, g.body, 0, 30, &up, 0) == GPHYS_OK);
         }},
        {"pushed",
         [](Gravel& g) {
             for (uint32_t p = 0; p < 60; p += 7) g.set_velocity(g.body, p, {1, 0.5f, 0});
         }},
    };
    return all;
}

}  // namespace

TEST_CASE("particles at rest on a mesh go on with the same bits as those that search in each step") {
    Gravel first;
    const test::Words calm = test::snapshot(first.solver);
    for (const Event& event : events()) {
        INFO(event.name);
        Gravel known, searching;
        for (const Gravel* each : {&known, &searching}) REQUIRE(test::restore(each->solver, calm) == GPHYS_OK);
        const auto step_both = [&] {
            known.step(frame);
            REQUIRE(test::restore(searching.solver, test::snapshot(searching.solver)) == GPHYS_OK);
            searching.step(frame);
            REQUIRE(test::hash(known.solver) == test::hash(searching.solver));
        };
        for (int i = 0; i < 3; ++i) step_both();
        REQUIRE(known.kept() > 50);
        event.happens(known);
        event.happens(searching);
        for (int i = 0; i < 30; ++i) step_both();
    }
}

TEST_CASE("particles that a walker does not come near keep their planes, with the same bits") {
    Gravel known, searching;
    const test::Words calm = test::snapshot(known.solver);
    const gphys_capsule legs{{0, 0.2f, 0}, {0, 1, 0}, 0.2f};
    gphys_model_id walkers[2];
    Gravel* const both[] = {&known, &searching};
    for (int i = 0; i < 2; ++i) {
        const gphys_transform outside{{-2.5f, 0, 0.05f}, {0, 0, 0, 1}, 1};
        walkers[i] = both[i]->model(GPHYS_SHAPE_CAPSULE, &legs, &outside);
        REQUIRE(test::restore(both[i]->solver, calm) == GPHYS_OK);
    }
    const std::vector<gphys_vec3> laid = known.positions(known.body);
    uint32_t fewest = 60, forgotten = 0;
    uint64_t surroundings = 0;
    for (int step = 0; step < 150; ++step) {
        // Walks through, stands for a while in the middle, and goes on.
        const float way = std::min(step, 60) * 0.04f + std::max(step - 90, 0) * 0.04f;
        const gphys_transform at{{-2.5f + way, 0, 0.05f}, {0, 0, 0, 1}, 1};
        for (int i = 0; i < 2; ++i) {
            REQUIRE(gphys_scene_set_transform(both[i]->scene, walkers[i], &at) == GPHYS_OK);
        }
        known.step(frame);
        REQUIRE(test::restore(searching.solver, test::snapshot(searching.solver)) == GPHYS_OK);
        searching.step(frame);
        REQUIRE(test::hash(known.solver) == test::hash(searching.solver));
        if (step > 0) fewest = std::min(fewest, known.kept());
        const uint64_t around = unwrap(known.solver)->body(known.body).flight.last_surroundings;
        forgotten += around != surroundings;
        surroundings = around;
    }
    uint32_t moved = 0;
    const std::vector<gphys_vec3> now = known.positions(known.body);
    for (uint32_t p = 0; p < 60; ++p) {
        moved += distance(widen(now[p]), widen(laid[p])) > 0.05;
        CHECK(now[p].y > -0.05f);  // the lowest place of the ground: a foot pushes none through it
    }
    CHECK(moved > 10);
    CHECK(fewest > 20);
    CHECK(forgotten <= 4);  // in the first step, and when the walker comes near, stands, and goes on
}

TEST_CASE("particles at rest press on a mesh with their weight, in each step") {
    Gravel gravel;
    for (int i = 0; i < 5; ++i) {
        gravel.step(frame);
        gphys_impulse impulse{};
        uint32_t total = 0;
        REQUIRE(gphys_solver_get_impulses(gravel.solver, &impulse, 1, &total) == GPHYS_OK);
        REQUIRE(total == 1);
        // The body weighs 1 kg; one of 61 particles is in the air. The tolerance is that of float32.
        CHECK(std::fabs(impulse.linear.y + 9.81 / 60 * 60 / 61) < 1e-6);
        CHECK(std::hypot(impulse.linear.x, impulse.linear.z) < 1e-6);
    }
}

TEST_CASE("a flight that hits nothing has the bits of one without models") {
    Hills hills(8, 12, 0.4f);
    World empty(4), beside(4);
    gphys_body_desc desc = test::point_mass(0.02f, 0.5f, 0.5f);
    desc.damping = 0.3f;
    test::Random random(3);
    std::vector<gphys_vec3> points, speeds;
    for (int i = 0; i < 700; ++i) {
        points.push_back({random.uniform_float(-2, 2), random.uniform_float(1, 2), random.uniform_float(-2, 2)});
        speeds.push_back({random.uniform_float(-4, 4), random.uniform_float(2, 5), random.uniform_float(-4, 4)});
    }
    const gphys_model_id ground = beside.model(GPHYS_SHAPE_MESH, hills.mesh);
    gphys_body_id bodies[2];
    World* const worlds[] = {&empty, &beside};
    for (int w = 0; w < 2; ++w) {
        bodies[w] = worlds[w]->particles(points, desc);
        REQUIRE(gphys_solver_set_velocities(worlds[w]->solver, bodies[w], 0, 700, speeds.data(), 12) == GPHYS_OK);
    }
    for (int i = 0; i < 20; ++i) {
        // It turns under them, without coming near.
        const gphys_transform place{{0, -0.4f, 0}, {0, std::sin(0.05f * i), 0, std::cos(0.05f * i)}, 1};
        REQUIRE(gphys_scene_set_transform(beside.scene, ground, &place) == GPHYS_OK);
        for (World* world : worlds) world->step(frame);
        const std::vector<gphys_vec3> a = empty.positions(bodies[0]), b = beside.positions(bodies[1]);
        REQUIRE(std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
    }
}

TEST_CASE("nothing leaves a closed mesh that turns", "[simulation]") {
    const std::vector<float> corners{-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1,
                                     -1, -1, 1,  1, -1, 1,  -1, 1, 1,  1, 1, 1};
    const test::MeshHandle box(corners, {0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                         2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 3, 7, 1, 7, 5});
    for (const float turning : {0.5f, 3.0f, 10.0f}) {
        INFO("turning at " << turning << " rad/s");
        World world(8);
        const gphys_model_id model = world.model(GPHYS_SHAPE_MESH, box.mesh);
        test::Random random(7);
        std::vector<gphys_vec3> points;
        for (int i = 0; i < 500; ++i) {
            points.push_back({random.uniform_float(-0.6f, 0.6f), random.uniform_float(-0.6f, 0.6f),
                              random.uniform_float(-0.6f, 0.6f)});
        }
        const gphys_body_id body = world.particles(points, test::point_mass(0.02f, 0.5f, 0.3f));
        gphys_transform at{};
        for (int i = 1; i <= 180; ++i) {
            const double half = turning * i / 120;
            at = {{0, 0, 0}, {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))}, 1};
            REQUIRE(gphys_scene_set_transform(world.scene, model, &at) == GPHYS_OK);
            world.step(frame);
        }
        int outside = 0;
        for (const gphys_vec3& p : world.positions(body)) {
            outside += max_component(abs(widen(at).inverse_apply(widen(p)))) > 1;
        }
        CHECK(outside == 0);
    }
}

TEST_CASE("models get the momentum that particles lose, also while these come to rest one by one") {
    World world(8);
    const gphys_aabb box{{-1, -1, -1}, {1, 0, 1}};
    world.model(GPHYS_SHAPE_AABB, &box);
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 32; ++i) {
        points.push_back({0.05f * static_cast<float>(i % 8), 0.02f + 0.0003f * static_cast<float>(i * i % 29),
                          0.05f * static_cast<float>(i / 8)});
    }
    const gphys_body_id body = world.particles(points, test::point_mass(0.02f, 0.5f, 0));
    const auto momentum = [&] {
        double sum = 0;
        for (const gphys_vec3& v : world.velocities(body)) sum += double{v.y} / 32;  // of 1 kg
        return sum;
    };
    double before = 0;
    for (int i = 0; i < 10; ++i) {
        world.step(frame);
        gphys_impulse impulse{};
        uint32_t total = 0;
        REQUIRE(gphys_solver_get_impulses(world.solver, &impulse, 1, &total) == GPHYS_OK);
        const double now = momentum();
        // The tolerance is that of the velocities and impulses in float32.
        CHECK(std::fabs(impulse.linear.y + (now - before) + 9.81f * double{frame}) < 1e-6);
        before = now;
    }
    CHECK(before == 0);
}

TEST_CASE("a small part of a model that turns far hits a particle between the ends of its way") {
    // In the space of the model the particle goes along an arc of 0.33 rad, 27 mm beside its chord; the square is
    // there.
    const test::MeshHandle square({1.99f, 0, -0.01f, 2.01f, 0, -0.01f, 2.01f, 0, 0.01f, 1.99f, 0, 0.01f},
                                  {0, 1, 2, 0, 2, 3});
    constexpr double turn = 0.33;
    World world(8, {0, 0, 0});
    const auto placed = [](double angle) {
        const double half = angle / 2;
        return gphys_transform{
            {0, 0, 0}, {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))}, 1};
    };
    gphys_transform at = placed(-turn);
    const gphys_model_id model = world.model(GPHYS_SHAPE_MESH, square.mesh, &at);
    const gphys_body_id body =
        world.particles({{static_cast<float>(2 * std::cos(turn / 2)), static_cast<float>(-2 * std::sin(turn / 2)), 0}},
                        test::point_mass(1e-3f, 0, 0));
    world.step(frame);
    at = placed(0);
    REQUIRE(gphys_scene_set_transform(world.scene, model, &at) == GPHYS_OK);
    world.step(frame);
    CHECK(length(widen(world.velocities(body)[0])) > 10);
}
