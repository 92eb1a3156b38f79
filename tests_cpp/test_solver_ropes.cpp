// Ropes that nothing disturbs are moved side by side: with the same bits as alone, whatever the
// instruction set, and not past what they could meet after all.
#include <cfenv>
#include <cstring>

#include "solver/time_scheme.h"
#include "solver_world.h"

using namespace gphys;
using test::World;

namespace {

/// Ropes of all kinds: `which` decides on length, masses, pins, compliance and damping.
gphys_body_id add_rope(World& world, uint32_t which) {
    test::Random random(which);
    gphys_body_desc desc = World::body_desc();
    desc.mass = static_cast<float>(random.uniform(0.1, 10));
    desc.damping = which % 3 == 0 ? 0.5f : 0;
    desc.compliance = which % 4 == 1 ? 1e-3f : 0;
    const uint32_t count = 2 + random.index(40);
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i < count; ++i) {
        const float way = 0.1f * static_cast<float>(i);
        points.push_back({static_cast<float>(which) + way, 0, which % 2 ? way : 0});
    }
    const gphys_body_id rope = world.rope(points, which % 5 == 2 ? 0.08f : 0, desc);
    if (which % 7 != 3) world.pin(rope, 0);
    if (which % 5 == 2) world.pin(rope, count - 1);  // further apart than the rope is long
    if (which % 6 == 4) world.pin(rope, count / 2);
    const float weight = 100;
    if (which % 3 == 1) REQUIRE(gphys_solver_set_masses(world.solver, rope, count - 1, 1, &weight, 4) == GPHYS_OK);
    return rope;
}

bool same_bits(const std::vector<gphys_vec3>& a, const std::vector<gphys_vec3>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), 12 * a.size()) == 0;
}

}  // namespace

TEST_CASE("a rope moves with the same bits alone and among others") {
    constexpr uint32_t ropes = 43;
    World together;
    std::vector<gphys_body_id> bodies;
    for (uint32_t which = 0; which < ropes; ++which) bodies.push_back(add_rope(together, which));
    for (int i = 0; i < 30; ++i) {
        // The caller interrupts one now and then.
        if (i % 4 == 2) together.set_velocity(bodies[5], 1, {0, 1, 0});
        together.step(1.0f / 60);
    }
    for (uint32_t which = 0; which < ropes; ++which) {
        CAPTURE(which);
        World alone;
        const gphys_body_id rope = add_rope(alone, which);
        for (int i = 0; i < 30; ++i) {
            if (which == 5 && i % 4 == 2) alone.set_velocity(rope, 1, {0, 1, 0});
            alone.step(1.0f / 60);
        }
        REQUIRE(test::all_finite(alone.positions(rope)));
        CHECK(same_bits(alone.positions(rope), together.positions(bodies[which])));
        CHECK(same_bits(alone.velocities(rope), together.velocities(bodies[which])));
    }
}

namespace {

/// A floor, and boxes, balls and a mesh on it.
void add_things(World& world) {
    const gphys_plane floor{{0, 1, 0}, -1.5f};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    for (int i = 0; i < 16; ++i) {
        const float x = 3 * static_cast<float>(i) + 1;
        const gphys_aabb box{{x, -1, -0.3f}, {x + 0.5f, -0.5f, 0.3f}};
        const gphys_sphere ball{{x + 1.5f, -0.8f, 0.1f}, 0.4f};
        world.model(GPHYS_SHAPE_AABB, &box);
        world.model(GPHYS_SHAPE_SPHERE, &ball);
    }
}

gphys_body_id add_touching_rope(World& world, uint32_t which) {
    test::Random random(which);
    gphys_body_desc desc = World::body_desc();
    desc.radius = 0.02f;
    desc.friction = which % 3 == 2 ? 0 : 0.4f;
    desc.static_friction = which % 4 == 1 ? 0.6f : 0;
    desc.restitution = which % 5 == 4 ? 0.5f : 0;
    desc.compliance = which % 4 == 3 ? 1e-4f : 0;
    const float x = static_cast<float>(random.uniform(0, 45)), drop = 0.02f * static_cast<float>(which % 6);
    return world.rope(test::line({x, drop - 0.4f, 0}, {0.1f, 0, 0}, 2 + random.index(30)), 0, desc);
}

gphys_solver_desc with_workers(uint32_t workers) {
    gphys_solver_desc desc = World::desc();
    desc.worker_count = workers;
    return desc;
}

}  // namespace

TEST_CASE("a rope that touches models moves with the same bits alone and among others", "[simulation]") {
    constexpr uint32_t ropes = 61;
    for (const uint32_t workers : {1u, 3u}) {
        World together(with_workers(workers));
        add_things(together);
        std::vector<gphys_body_id> bodies;
        for (uint32_t which = 0; which < ropes; ++which) bodies.push_back(add_touching_rope(together, which));
        for (int i = 0; i < 40; ++i) together.step(1.0f / 60);
        uint32_t touching = 0;
        for (uint32_t which = 0; which < ropes; ++which) {
            CAPTURE(workers, which);
            World alone;
            add_things(alone);
            const gphys_body_id rope = add_touching_rope(alone, which);
            for (int i = 0; i < 40; ++i) alone.step(1.0f / 60);
            touching += alone.stats(rope).contact_count > 0;
            REQUIRE(test::all_finite(alone.positions(rope)));
            CHECK(same_bits(alone.positions(rope), together.positions(bodies[which])));
            CHECK(same_bits(alone.velocities(rope), together.velocities(bodies[which])));
        }
        CHECK(touching > ropes / 2);
    }
}

TEST_CASE("a long straight rope that lands on boxes keeps its lengths", "[simulation]") {
    // Its links are pressed together along a line, which they can leave to any side.
    double worst = 0;
    for (const uint32_t substeps : {6u, 8u}) {
        World world(substeps);
        for (int i = 0; i < 50; ++i) {
            const float x = 4 * static_cast<float>(i / 2) + 1.5f, y = -0.5f, z = 0.5f * static_cast<float>(i % 2);
            const gphys_aabb box{{x - 0.2f, y - 0.2f, z - 0.2f}, {x + 0.2f, y + 0.2f, z + 0.2f}};
            world.model(GPHYS_SHAPE_AABB, &box);
        }
        std::vector<gphys_vec3> points;
        for (int i = 0; i <= 1000; ++i) points.push_back({0.1f * static_cast<float>(i), 0, 0});
        gphys_body_desc desc = World::body_desc();
        desc.radius = 0.02f;
        desc.mass = 100;
        const gphys_body_id rope = world.rope(points, 0, desc);
        for (int i = 0; i < 60; ++i) {
            world.step(1.0f / 60);
            const std::vector<gphys_vec3> at = world.positions(rope);
            for (uint32_t k = 0; k < 1000; ++k) {
                worst = std::max(worst, std::fabs(distance(widen(at[k]), widen(at[k + 1])) / double{0.1f} - 1));
            }
        }
    }
    test::figure("a long rope that lands on boxes, peak strain", 100 * worst, "%");
    // A link that turns by 0.1 radians in the last iteration is too long by 0.1^2 / 2.
    CHECK(worst < 0.005);
}

TEST_CASE("the pieces of a cut rope move with the same bits as ropes of their own") {
    // Down from one nail and up to another.
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 4; ++i) points.push_back({0, -0.1f * static_cast<float>(i), 0.02f * static_cast<float>(i)});
    for (int i = 4; i < 9; ++i) points.push_back({0.1f, -0.1f * static_cast<float>(8 - i), 0});
    const std::vector<gphys_vec3> first(points.begin(), points.begin() + 4), second(points.begin() + 4, points.end());
    const auto weigh = [](World& world, gphys_body_id rope, size_t count) {
        const std::vector<float> masses(count, 0.5f);
        REQUIRE(gphys_solver_set_masses(world.solver, rope, 0, static_cast<uint32_t>(count), masses.data(), 4) ==
                GPHYS_OK);
    };
    World cut, apart;
    const gphys_body_id whole = cut.rope(points, 0), pieces[2] = {apart.rope(first, 0), apart.rope(second, 0)};
    weigh(cut, whole, 9), weigh(apart, pieces[0], 4), weigh(apart, pieces[1], 5);
    cut.pin(whole, 0), cut.pin(whole, 8), apart.pin(pieces[0], 0), apart.pin(pieces[1], 4);
    gphys_constraint_info links[8];
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_constraints(cut.solver, whole, links, 8, &total) == GPHYS_OK);
    REQUIRE(gphys_solver_remove_constraint(cut.solver, whole, links[3].id) == GPHYS_OK);
    for (int i = 0; i < 60; ++i) cut.step(1.0f / 60), apart.step(1.0f / 60);
    std::vector<gphys_vec3> moved = apart.positions(pieces[0]);
    const std::vector<gphys_vec3> rest = apart.positions(pieces[1]);
    moved.insert(moved.end(), rest.begin(), rest.end());
    CHECK(same_bits(cut.positions(whole), moved));
    CHECK(!same_bits(moved, points));
}

TEST_CASE("ropes divide nothing by zero, whether they yield or not") {
    World world;
    for (uint32_t which = 0; which < 40; ++which) add_rope(world, which);
    std::feclearexcept(FE_ALL_EXCEPT);
    for (int i = 0; i < 5; ++i) REQUIRE(gphys_solver_step(world.solver, nullptr, 1.0f / 60) == GPHYS_OK);
    REQUIRE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) == 0);
}

TEST_CASE("a damped rope falls as the closed form says") {
    const double damping = 2, seconds = 0.5;
    double errors[2];
    for (const uint32_t substeps : {1u, 2u}) {
        World world(substeps);
        gphys_body_desc desc = World::body_desc();
        desc.damping = static_cast<float>(damping);
        const gphys_body_id rope = world.rope({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 1, desc);
        for (int i = 0; i < 30; ++i) world.step(1.0f / 60);
        const double fallen = 9.81 / damping * (seconds - (1 - std::exp(-damping * seconds)) / damping);
        errors[substeps - 1] = std::fabs(world.position(rope, 1).y + fallen);
        std::printf("    damped fall, %u substeps: off by %.3g of %.3g m\n", substeps, errors[substeps - 1], fallen);
    }
    // Half of the formula's 0.04 h^2 times what the acceleration changes by, 6.2 m/s^2.
    CHECK(errors[0] < 3e-5);
    CHECK(errors[1] < errors[0] / 2);
}

TEST_CASE("ropes do not pass what was not near when the step began") {
    World world;
    const gphys_aabb wall{{10, -50, -50}, {10.01f, 50, 50}};
    world.model(GPHYS_SHAPE_AABB, &wall);
    // 3e5 m/s^2 brings the first rope 40 m further in a step, which its speed did not tell.
    const gphys_body_id pulled = world.rope({{0, 0, 0}, {0, 0.1f, 0}, {0, 0.2f, 0}}, 0.1f);
    const gphys_body_id beside = world.rope({{0, 0, 1}, {0, 0.1f, 1}, {0, 0.2f, 1}}, 0.1f);
    const gphys_vec3 force{1e5f, 0, 0};
    REQUIRE(gphys_solver_set_forces(world.solver, pulled, 0, 3, &force, 0) == GPHYS_OK);
    world.step(1.0f / 60);
    for (const gphys_vec3& p : world.positions(pulled)) {
        CHECK(p.x > 1);
        CHECK(p.x < 10);
    }
    for (const gphys_vec3& p : world.positions(beside)) CHECK(p.x == 0);
}

TEST_CASE("ropes are taken along by a model that is gone by the end of the step") {
    World world;
    const gphys_aabb wall{{-0.05f, -5, -5}, {0.05f, 5, 5}};
    gphys_transform at{{-0.07f, 0, 0}, {0, 0, 0, 1}, 1};
    const gphys_model_id model = world.model(GPHYS_SHAPE_AABB, &wall, &at);
    const gphys_body_id rope = world.rope({{0, 0, 0}, {0, 0.1f, 0}, {0, 0.2f, 0}}, 0.1f);
    world.step(1.0f / 60);
    at.position.x = 0.7f;  // at 46 m/s
    REQUIRE(gphys_scene_set_transform(world.scene, model, &at) == GPHYS_OK);
    world.step(1.0f / 60);
    for (const gphys_vec3& p : world.positions(rope)) CHECK(p.x > 0.7f);
}

TEST_CASE("a floor of more parts than a rope looks at carries it as one box does") {
    // A thousand tiles beside each other, in a mesh or each a box, and a hundred boxes that all are the whole floor:
    // the surface is the same. Thrown at it, the rope sees a quarter of a metre far.
    constexpr uint32_t cells = 40;
    constexpr float tile = 0.02f, half = cells * tile / 2, radius = 0.01f, way_down = 0.6f;
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
    for (uint32_t i = 0; i <= cells; ++i) {
        for (uint32_t j = 0; j <= cells; ++j) {
            vertices.insert(vertices.end(),
                            {tile * static_cast<float>(i) - half, 0, tile * static_cast<float>(j) - half});
            const uint32_t here = i * (cells + 1) + j, across = here + cells + 1;
            if (i < cells && j < cells) {
                indices.insert(indices.end(), {here, here + 1, across, across, here + 1, across + 1});
            }
        }
    }
    const test::MeshHandle mesh(vertices, indices);
    enum Floor { one_box, tiles, whole_boxes, triangles };
    for (const Floor floor : {one_box, tiles, whole_boxes, triangles}) {
        CAPTURE(floor);
        World world;
        const gphys_aabb whole{{-half, -1, -half}, {half, 0, half}};
        if (floor == triangles) world.model(GPHYS_SHAPE_MESH, mesh.mesh);
        for (uint32_t i = 0; i < (floor == one_box ? 1 : floor == whole_boxes ? 100 : 0); ++i) {
            world.model(GPHYS_SHAPE_AABB, &whole);
        }
        for (uint32_t i = 0; floor == tiles && i < cells * cells; ++i) {
            const float x = tile * static_cast<float>(i / cells) - half,
                        z = tile * static_cast<float>(i % cells) - half;
            const gphys_aabb box{{x, -1, z}, {x + tile, 0, z + tile}};
            world.model(GPHYS_SHAPE_AABB, &box);
        }
        gphys_body_desc desc = test::point_mass(radius, 0.5f, 0);
        const uint32_t count = 12;
        const gphys_body_id rope = world.rope(test::line({-0.21f, way_down, 0.013f}, {0.04f, 0, 0}, count), 0, desc);
        for (uint32_t p = 0; p < count; ++p) world.set_velocity(rope, p, {0, -10, 0});
        for (int frame = 0; frame < 60; ++frame) {
            world.step(1.0f / 60);
            for (const gphys_vec3& p : world.positions(rope)) REQUIRE(p.y > radius - 1e-5f);
            REQUIRE(world.stats(rope).strain_max < 1e-4f);
        }
        // It has come to rest where it fell. A skin is 1e-4 of a radius.
        for (uint32_t p = 0; p < count; ++p) {
            const Vec3 at = world.position(rope, p);
            CHECK(std::fabs(at.y - double{radius}) < 1e-5);
            CHECK(std::fabs(at.x - (0.04 * p - 0.21)) < 1e-3);
            CHECK(std::fabs(at.z - 0.013) < 1e-3);
        }
        CHECK(world.stats(rope).kinetic_energy < 1e-6f);
    }
}

TEST_CASE("ropes of any link and load add no energy at any step") {
    // From half a second for links of a millimetre, which swing 8 times meanwhile, with a weight 10^5 times theirs.
    double grown = 0, strained = 0;
    for (const float h : {0.025f, 0.1f, 0.5f}) {
        for (const uint32_t count : {3u, 5u, 31u}) {
            for (const float link : {1e-3f, 0.1f, 10.0f}) {
                for (const bool heavy : {false, true}) {
                    for (const bool elastic : {false, true}) {
                        CAPTURE(h, count, link, heavy, elastic);
                        gphys_body_desc desc = World::body_desc();
                        desc.compliance = elastic ? 1e-4f * link : 0;
                        std::vector<gphys_vec3> points;
                        for (uint32_t i = 0; i < count; ++i) {
                            points.push_back(
                                {link * static_cast<float>(i), 0.1f * link * static_cast<float>(i % 2), 0});
                        }
                        World world(1);
                        const gphys_body_id rope = world.rope(points, 0, desc);
                        world.pin(rope, 0);
                        const float weight = (heavy ? 1e5f : 1.0f) / static_cast<float>(count);
                        REQUIRE(gphys_solver_set_masses(world.solver, rope, count - 1, 1, &weight, 4) == GPHYS_OK);
                        const double before = world.energy();
                        // What its weight gains by falling from horizontal.
                        const double whole = 9.81 * static_cast<double>(weight + 1) * count * static_cast<double>(link);
                        for (int i = 0; i < 200; ++i) {
                            world.step(h);
                            grown = std::max(grown, (world.energy() - before) / whole);
                            if (!elastic) strained = std::max(strained, static_cast<double>(world.stats().strain_max));
                        }
                        REQUIRE(test::all_finite(world.positions(rope)));
                    }
                }
            }
        }
    }
    test::figure("energy gained at steps of up to 0.5 s", grown * 100, "%");
    test::figure("strain at steps of up to 0.5 s", strained * 100, "%");
    CHECK(grown < 1e-3);
    CHECK(strained < 0.05);  // regularisation gives way with the square of the step
}
