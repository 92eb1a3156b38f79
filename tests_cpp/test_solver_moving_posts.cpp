// Ropes in contact with models that move: the laws are those of models at rest, seen from the model.
#include <cmath>
#include <functional>

#include "post.h"
#include "solver_world.h"

using namespace gphys;
using test::figure;
using test::World;

namespace {

constexpr double g = 9.81f;

using Placement = std::function<gphys_transform(double time)>;

gphys_transform at(Vec3 place, Vec3 axis = {0, 0, 1}, double angle = 0, float scale = 1) {
    const double s = std::sin(angle / 2);
    return {narrow(place),
            {static_cast<float>(axis.x * s), static_cast<float>(axis.y * s), static_cast<float>(axis.z * s),
             static_cast<float>(std::cos(angle / 2))},
            scale};
}

/// The corners of a box with edges of 2, and its faces.
const std::vector<float> corners{-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};
const std::vector<uint32_t> faces{0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                  2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 3, 7, 1, 7, 5};

constexpr uint32_t links = 120;
constexpr float link = 0.03f, post = 0.3f, thick = 0.03f;

/// A rope over a capsule that moves, its middle on top, with a weight at each end.
struct MovingPost : World {
    gphys_model_id capsule = 0;
    gphys_body_id hung = 0;
    Placement placement;
    int steps = 0;

    MovingPost(const Placement& placed, uint32_t substeps, float mass, float friction, float left, float right)
        : World(substeps), placement(placed) {
        const gphys_capsule shape{{0, 0, -2}, {0, 0, 2}, post};
        const gphys_transform now = placement(0);
        capsule = model(GPHYS_SHAPE_CAPSULE, &shape, &now);
        gphys_body_desc desc = body_desc();
        desc.mass = mass;
        desc.radius = thick;
        desc.friction = friction;
        const std::vector<gphys_vec3> points = test::points_over_post(links, link, double{post} + thick);
        hung = rope(points, 0, desc);
        REQUIRE(gphys_solver_set_masses(solver, hung, 0, 1, &left, 4) == GPHYS_OK);
        REQUIRE(gphys_solver_set_masses(solver, hung, links, 1, &right, 4) == GPHYS_OK);
        // A model moves if it was elsewhere in the step before, so the first one is of a model at rest.
        hold(1);
        step(1.0f / 60);
        hold(0);
    }
    void hold(uint8_t pinned) {
        REQUIRE(gphys_solver_set_pinned(solver, hung, 0, 1, pinned) == GPHYS_OK);
        REQUIRE(gphys_solver_set_pinned(solver, hung, links, 1, pinned) == GPHYS_OK);
    }
    void go() {
        const gphys_transform now = placement(++steps / 60.0);
        REQUIRE(gphys_scene_set_transform(scene, capsule, &now) == GPHYS_OK);
        step(1.0f / 60);
    }
    /// How far the right end falls in 0.6 s, seen from the post.
    double fall() {
        const double before = position(hung, links).y - placement(0).position.y;
        for (int i = 0; i < 36; ++i) go();
        return before - (position(hung, links).y - placement(0.6).position.y);
    }
};

}  // namespace

TEST_CASE("a rope that falls on a model that moves does what it does in the frame of the model") {
    // Times and speeds are dyadic, so that the places of the model are exact in float32.
    constexpr float dt = 1.0f / 64, thickness = 0.0625f;
    constexpr Vec3 speed{0.5, 0.25, -0.25};
    const test::MeshHandle box(corners, faces);
    std::vector<float> ground;
    std::vector<uint32_t> triangles;
    for (uint32_t i = 0; i <= 40; ++i) {
        for (uint32_t j = 0; j <= 40; ++j) {
            const float x = 0.0625f * static_cast<float>(i) - 1.25f, z = 0.0625f * static_cast<float>(j) - 1.25f;
            ground.insert(ground.end(), {x, 0.1f * std::sin(5 * x) * std::cos(4 * z) - 0.6f, z});
            const uint32_t a = i * 41 + j, b = a + 41;
            if (i < 40 && j < 40) triangles.insert(triangles.end(), {a, a + 1, b, a + 1, b + 1, b});
        }
    }
    const test::MeshHandle hills(ground, triangles);
    double worst = 0, worst_on_hills = 0;
    for (int kind = 0; kind < 5; ++kind) {
        for (const uint32_t substeps : {1u, 8u}) {
            for (const float friction : {0.0f, 0.5f}) {
                INFO("kind " << kind << ", " << substeps << " substeps, friction " << friction);
                World still(substeps), moving(substeps);
                const gphys_transform turned{{0, -1.5f, 0}, {0, 0, 0, 1}, 0.5f};
                gphys_model_id model = 0;
                gphys_body_id still_rope = 0, moving_rope = 0;
                for (World* const world : {&still, &moving}) {
                    const gphys_capsule capsule{{-1, -1, -0.25f}, {1, -1, 0.25f}, 0.5f};
                    const gphys_sphere sphere{{0, -1.5f, 0}, 1};
                    const gphys_aabb slab{{-0.5f, -2, -2}, {0.5f, -0.5f, 2}};
                    if (kind == 0) model = world->model(GPHYS_SHAPE_CAPSULE, &capsule);
                    if (kind == 1) model = world->model(GPHYS_SHAPE_SPHERE, &sphere);
                    if (kind == 2) model = world->model(GPHYS_SHAPE_AABB, &slab);
                    if (kind == 3) model = world->model(GPHYS_SHAPE_MESH, box.mesh, &turned);
                    if (kind == 4) model = world->model(GPHYS_SHAPE_MESH, hills.mesh);
                    gphys_body_desc desc = World::body_desc();
                    desc.radius = thickness;
                    desc.friction = friction;
                    const bool moves = world == &moving;
                    gphys_body_id& rope = moves ? moving_rope : still_rope;
                    rope = world->rope(test::line({-0.9f, -0.3f, 0.1f}, {0.1f, 0, 0}, 16), 0, desc);
                    for (uint32_t p = 0; p < 16 && !moves; ++p) world->set_velocity(rope, p, narrow(-speed));
                }
                gphys_transform begin{{0, 0, 0}, {0, 0, 0, 1}, 1};
                if (kind == 3) begin = turned;
                for (int i = 1; i <= 64; ++i) {
                    gphys_transform now = begin;
                    const Vec3 way = speed * (i * double{dt});
                    now.position = narrow(widen(begin.position) + way);
                    REQUIRE(gphys_scene_set_transform(moving.scene, model, &now) == GPHYS_OK);
                    still.step(dt);
                    moving.step(dt);
                    for (uint32_t p = 0; p < 16 && i <= 40; ++p) {
                        const double off =
                            distance(moving.position(moving_rope, p), still.position(still_rope, p) + way);
                        double& largest = kind == 4 ? worst_on_hills : worst;
                        largest = std::max(largest, off);
                        const gphys_sphere ball{narrow(moving.position(moving_rope, p)), thickness * 0.999f};
                        uint32_t overlapped = 0;
                        REQUIRE(gphys_scene_overlap(moving.scene, GPHYS_SHAPE_SPHERE, &ball, 0, nullptr, 0,
                                                    &overlapped) == GPHYS_OK);
                        REQUIRE(overlapped == 0);
                    }
                }
            }
        }
    }
    figure("a rope on a moving model, seen from the model", worst, "m");
    figure("a rope on moving hills, seen from the hills", worst_on_hills, "m");
    // Normal forces, and with them friction, converge to a hundredth, and planes follow a ball within a skin, 6e-6 m.
    CHECK(worst < 3e-5);
    // Searches reach farther while the model moves. Which planes a particle on several edges keeps differs, and what
    // slips grows.
    CHECK(worst_on_hills < 0.05);
}

TEST_CASE("a post that spins lifts a rope as the capstan equation says") {
    // Friction drives the rope to the left with equal weights: m (g + a) = exp(friction pi) m (g - a).
    for (const uint32_t substeps : {8u, 16u}) {
        for (const float friction : {0.1f, 0.2f}) {
            CAPTURE(substeps, friction);
            const Placement spins = [](double t) { return at({}, {0, 0, 1}, 20 * t); };
            const double grip = std::exp(double{friction} * pi), exact = -g * (grip - 1) / (grip + 1) / 2 * 0.36;
            CHECK(MovingPost(spins, substeps, 0.01f, friction, 1, 1).fall() == Approx(exact).epsilon(0.02));
        }
    }
}

TEST_CASE("a rope over a post that is raised ever faster is Atwood's machine with more gravity") {
    const Placement raised = [](double t) { return at({0, g * t * t / 4, 0}); };
    // As in test_solver_posts.cpp. At first the rope is at rest, and the post has the mean speed of its first step.
    const double mass = 0.5, q = mass / (double{link} * links), total = 1 + 3 + mass;
    const double w = std::sqrt(2 * q * 1.5 * g / total), exact = 2 / (2 * q) * (std::cosh(w * 0.6) - 1);
    for (const uint32_t substeps : {8u, 16u}) {
        CAPTURE(substeps);
        CHECK(MovingPost(raised, substeps, 0.5f, 0, 1, 3).fall() == Approx(exact).epsilon(0.02));
    }
}

TEST_CASE("a model that moves gets the momentum that a rope loses") {
    for (const bool turns : {false, true}) {
        World world(8);
        const gphys_obb shape{{0, 0, 0}, {0.5f, 0.5f, 0.5f}, {0, 0, 0, 1}};
        const gphys_model_id box = world.model(GPHYS_SHAPE_OBB, &shape);
        gphys_body_desc desc = World::body_desc();
        desc.radius = 0.02f;
        desc.mass = 1;
        const gphys_body_id rope = world.rope(test::line({-1, 0.55f, 0.1f}, {0.1f, 0, 0}, 21), 0, desc);
        const auto momentum = [&] {
            Vec3 sum;
            for (const gphys_vec3& v : world.velocities(rope)) sum += widen(v) / 21;
            return sum;
        };
        Vec3 before;
        double worst = 0, most = 0;
        for (int i = 1; i <= 90; ++i) {
            const double t = i / 60.0;
            const gphys_transform now =
                at({0.3 * std::sin(3 * t), 0.2 * std::sin(2 * t), 0}, {0.6, 0.8, 0}, turns ? 2 * t : 0);
            REQUIRE(gphys_scene_set_transform(world.scene, box, &now) == GPHYS_OK);
            world.step(1.0f / 60);
            gphys_impulse impulse{};
            uint32_t count = 0;
            REQUIRE(gphys_solver_get_impulses(world.solver, &impulse, 1, &count) == GPHYS_OK);
            const Vec3 after = momentum(), given = count > 0 ? widen(impulse.linear) : Vec3{};
            worst = std::max(worst, length(given + (after - before) + Vec3{0, g / 60, 0}));
            most = std::max(most, length(given));
            before = after;
        }
        CAPTURE(turns);
        // Contacts that change between stick and slip may not converge in 16 iterations. What is then left of the
        // equations of particles without contacts is given to no model.
        CHECK(worst < 1e-4);
        CHECK(most > 0.2);
    }
}

TEST_CASE("walkers go through ropes that hang, and into none of them", "[simulation]") {
    const gphys_capsule shape{{0, 0.2f, 0}, {0, 1.7f, 0}, 0.2f};
    for (const bool ground : {false, true}) {
        for (const uint32_t substeps : {1u, 8u}) {
            CAPTURE(ground, substeps);
            World world(substeps);
            const gphys_plane floor{{0, 1, 0}, 0};
            if (ground) world.model(GPHYS_SHAPE_PLANE, &floor);
            std::vector<gphys_model_id> walkers;
            for (int i = 0; i < 4; ++i) walkers.push_back(world.model(GPHYS_SHAPE_CAPSULE, &shape));
            gphys_body_desc desc = World::body_desc();
            desc.radius = 0.02f;
            std::vector<gphys_body_id> ropes;
            for (int i = 0; i < 25; ++i) {
                const float x = 0.5f * static_cast<float>(i % 5) - 1, z = 0.5f * static_cast<float>(i / 5) - 1;
                ropes.push_back(world.rope(test::line({x, 2.2f, z}, {0, -0.1f, 0}, 22), 0, desc));
                world.pin(ropes.back(), 0);
            }
            double nearest = 1, longest = 0;
            for (int i = 0; i <= 180; ++i) {
                std::vector<Vec3> places;
                for (size_t w = 0; w < walkers.size(); ++w) {
                    // Each has its lane.
                    const double way = (w % 2 ? -1 : 1) * (i / 60.0 * 1.5 - 2.5);
                    const Vec3 place{way, 0, 0.6 * static_cast<double>(w) - 0.9};
                    const gphys_transform now = at(place, {0, 1, 0}, 3 * i / 60.0);
                    REQUIRE(gphys_scene_set_transform(world.scene, walkers[w], &now) == GPHYS_OK);
                    places.push_back(widen(now.position));
                }
                world.step(1.0f / 60);
                for (const gphys_body_id rope : ropes) {
                    longest = std::max(longest, double{world.stats(rope).strain_max});
                    for (const gphys_vec3& p : world.positions(rope)) {
                        for (const Vec3 place : places) {
                            const Vec3 off = widen(p) - place;
                            const Vec3 closest{0, std::clamp(off.y, double{shape.a.y}, double{shape.b.y}), 0};
                            nearest = std::min(nearest, distance(off, closest) - double{shape.radius} - 0.02);
                        }
                    }
                }
            }
            figure("walkers among ropes, nearest", nearest, "m");
            figure("walkers among ropes, largest strain", longest, "");
            CHECK(nearest > -1e-6);
            CHECK(nearest < 1e-4);
        }
    }
}

TEST_CASE("no rope leaves a closed mesh that turns", "[simulation]") {
    const test::MeshHandle box(corners, faces);
    struct Case {
        double turning;  // rad/s
        uint32_t substeps;
    };
    for (const Case& c : {Case{0.5, 8}, Case{3, 8}, Case{10, 8}, Case{25, 1}, Case{25, 4}, Case{60, 4}}) {
        const double turning = c.turning;
        INFO("turning at " << turning << " rad/s, " << c.substeps << " substeps");
        World world(c.substeps);
        const gphys_model_id model = world.model(GPHYS_SHAPE_MESH, box.mesh);
        gphys_body_desc desc = test::point_mass(0.02f, 0.5f, 0.3f);
        std::vector<gphys_body_id> ropes;
        for (int i = 0; i < 16; ++i) {
            const float x = -0.6f + 0.35f * static_cast<float>(i % 4), z = -0.6f + 0.35f * static_cast<float>(i / 4);
            ropes.push_back(world.rope(test::line({x, -0.5f, z}, {0.02f, 0.1f, 0}, 11), 0, desc));
        }
        gphys_transform now{};
        for (int i = 1; i <= 120; ++i) {
            now = at({}, {0, 0, 1}, turning * i / 60);
            REQUIRE(gphys_scene_set_transform(world.scene, model, &now) == GPHYS_OK);
            world.step(1.0f / 60);
        }
        int outside = 0;
        for (const gphys_body_id rope : ropes) {
            for (const gphys_vec3& p : world.positions(rope)) {
                outside += max_component(abs(widen(now).inverse_apply(widen(p)))) > 1;
            }
        }
        CHECK(outside == 0);
    }
}

TEST_CASE("ropes that a thin wall pushes along a floor stay in front of it", "[simulation]") {
    int behind = 0;
    for (const uint32_t substeps : {1u, 8u}) {
        for (const float friction : {0.0f, 0.4f}) {
            World world(substeps);
            const gphys_aabb floor{{-50, -1, -50}, {50, 0, 50}}, plate{{-0.0005f, -1, -50}, {0.0005f, 1, 50}};
            world.model(GPHYS_SHAPE_AABB, &floor);
            const gphys_model_id wall = world.model(GPHYS_SHAPE_AABB, &plate);
            gphys_body_desc desc = test::point_mass(0.01f, friction, 0);
            std::vector<gphys_body_id> ropes;
            for (int i = 0; i < 20; ++i) {
                const float x = 0.05f + 0.0137f * static_cast<float>(i);
                ropes.push_back(world.rope(test::line({x, 0.0101f, 2.0f * static_cast<float>(i) - 20},
                                                      {0.03f * static_cast<float>(i % 3), 0, 0.1f}, 11),
                                           0, desc));
            }
            double furthest = 0;
            for (int i = 0; i < 120; ++i) {
                const double t = i / 60.0;
                const gphys_transform now =
                    at({1.8 * t, 0.3 * std::sin(5 * t), 0}, {0, 1, 0}, 0.002 * std::sin(20 * t));
                REQUIRE(gphys_scene_set_transform(world.scene, wall, &now) == GPHYS_OK);
                world.step(1.0f / 60);
                for (const gphys_body_id rope : ropes) {
                    for (const gphys_vec3& p : world.positions(rope)) {
                        const double ahead = widen(now).inverse_apply(widen(p)).x - 0.0005;
                        behind += ahead < 0.01 - 1e-6;
                        furthest = std::max(furthest, ahead);
                    }
                }
            }
            CHECK(furthest > 0.3);
        }
    }
    CHECK(behind == 0);
}

TEST_CASE("a rope stays outside a post that grows, jumps or turns fast") {
    for (int kind = 0; kind < 3; ++kind) {
        CAPTURE(kind);
        World world(8);
        const gphys_capsule capsule{{0, 0, -2}, {0, 0, 2}, 0.5f};
        const gphys_model_id model = world.model(GPHYS_SHAPE_CAPSULE, &capsule);
        std::vector<gphys_vec3> tent;
        for (int i = -10; i <= 10; ++i) {
            const float x = 0.1f * static_cast<float>(i);
            tent.push_back({x, 1.3f - 0.7f * std::fabs(x), 0});
        }
        const gphys_body_id rope = world.rope(tent, 0, test::point_mass(0.03f, 0.5f, 0));
        world.pin(rope, 0);
        world.pin(rope, 20);
        for (int i = 1; i <= 90; ++i) {
            const double t = i / 60.0;
            const gphys_transform now = kind == 0   ? at({}, {0, 0, 1}, 0, static_cast<float>(1 + 0.2 * t))
                                        : kind == 1 ? at({0.1 * (i / 20), 0.05 * (i / 20), 0})
                                                    : at({0, 0.05 * t, 0}, {0, 0, 1}, 60 * t);
            REQUIRE(gphys_scene_set_transform(world.scene, model, &now) == GPHYS_OK);
            world.step(1.0f / 60);
        }
        const Vec3 middle{kind == 1 ? 0.4 : 0, kind == 1 ? 0.2 : kind == 2 ? 0.075 : 0, 0};
        const double radius = kind == 0 ? 0.5 * 1.3 : 0.5;
        double nearest = 1;
        for (const gphys_vec3& p : world.positions(rope))
            nearest = std::min(nearest, distance(widen(p), middle + Vec3{0, 0, double{p.z}}) - radius - 0.03);
        CHECK(nearest > -1e-5);
        CHECK(nearest < (kind == 2 ? 0.1 : 1e-3));  // the fast one throws it up
    }
}

TEST_CASE("a paddle on a long arm meets all ropes in its way") {
    // Thin, and 8 cm broad on an arm of a metre. In one substep its way is curved by 1 - cos(0.2), 2 cm.
    for (const uint32_t substeps : {1u, 4u}) {
        for (const bool is_mesh : {false, true}) {
            CAPTURE(substeps, is_mesh);
            World world(substeps, {0, 0, 0});
            const gphys_aabb plate{{0.96f, -0.5f, -0.0005f}, {1.04f, 0.5f, 0.0005f}};
            const test::MeshHandle mesh({0.96f, -0.5f, 0, 1.04f, -0.5f, 0, 1.04f, 0.5f, 0, 0.96f, 0.5f, 0},
                                        {0, 1, 2, 0, 2, 3});
            const gphys_model_id paddle =
                is_mesh ? world.model(GPHYS_SHAPE_MESH, mesh.mesh) : world.model(GPHYS_SHAPE_AABB, &plate);
            std::vector<gphys_body_id> ropes;
            for (int i = 0; i < 100; ++i) {
                const double angle = -0.05 - 0.34 * i / 100, arm = 1 + 0.03 * std::sin(i);
                const gphys_vec3 from{static_cast<float>(arm * std::cos(angle)), -0.05f,
                                      static_cast<float>(-arm * std::sin(angle))};
                ropes.push_back(world.rope(test::line(from, {0, 0.05f, 0}, 3), 0, test::point_mass(0.005f, 0, 0)));
            }
            world.step(1.0f / 60);
            const gphys_transform now = at({}, {0, 1, 0}, -0.4);
            REQUIRE(gphys_scene_set_transform(world.scene, paddle, &now) == GPHYS_OK);
            world.step(1.0f / 60);
            int missed = 0;
            for (const gphys_body_id rope : ropes) {
                for (const gphys_vec3& v : world.velocities(rope)) missed += length(widen(v)) < 10;
            }
            CHECK(missed == 0);
        }
    }
}
