// Links of no length, and of lengths that are only rounding, such as those between the vertices at a ball's pole.
#include "scene_fixture.h"
#include "solver_world.h"

using namespace test;

namespace {

constexpr float frame = 1 / 60.0f;

/// A ball as modelling programs export it: rings of vertices from pole to pole, where all of a ring are at one place,
/// up to the rounding of sines.
struct PoleBall {
    static constexpr int rings = 12, ring = 2 * rings;
    std::vector<float> vertices;
    std::vector<uint32_t> indices;

    explicit PoleBall(bool exact) {
        for (int i = 0; i <= rings; ++i) {
            const double polar = pi * i / rings, sine = exact && i % rings == 0 ? 0 : std::sin(polar) / 2;
            for (int j = 0; j < ring; ++j) {
                const double around = pi * j / rings;
                for (const double x : {sine * std::cos(around), std::cos(polar) / 2, sine * std::sin(around)})
                    vertices.push_back(static_cast<float>(x));
            }
        }
        for (uint32_t i = 0; i < rings; ++i) {
            for (uint32_t j = 0; j < ring; ++j) {
                const uint32_t a = i * ring + j, b = i * ring + (j + 1) % ring, c = a + ring, d = b + ring;
                indices.insert(indices.end(), {a, b, c, c, b, d});
            }
        }
    }

private:
    static constexpr double pi = 3.14159265358979323846;
};

gphys_body_id add(const World& world, const PoleBall& ball) {
    const MeshHandle mesh(ball.vertices, ball.indices);
    gphys_body_id body = 0;
    REQUIRE(gphys_solver_add_cloth_mesh(world.solver, nullptr, mesh.mesh, nullptr, &body) == GPHYS_OK);
    return body;
}

gphys_solver_desc desc_with(float max_strain, gphys_vec3 gravity) {
    gphys_solver_desc desc = World::desc(8, gravity);
    desc.max_strain = max_strain;
    desc.sleep_speed = 0.05f;
    return desc;
}

uint32_t sleeping(const World& world) {
    uint32_t count = 0;
    gphys_solver_get_sleeping(world.solver, nullptr, 0, &count);
    return count;
}

std::vector<gphys_constraint_info> constraints(const World& world, gphys_body_id body) {
    std::vector<gphys_constraint_info> out(world.stats(body).constraint_count);
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_constraints(world.solver, body, out.data(), static_cast<uint32_t>(out.size()), &total) ==
            GPHYS_OK);
    return out;
}

float rest_length(const World& world, gphys_body_id body, gphys_constraint_id id) {
    gphys_constraint_settings settings{};
    REQUIRE(gphys_solver_get_constraint_settings(world.solver, body, &id, 1, &settings, sizeof settings) == GPHYS_OK);
    return settings.rest_length;
}

}  // namespace

TEST_CASE("a ball with many vertices at its poles is unstrained, and sleeps") {
    for (const bool exact : {true, false}) {
        for (const float max_strain : {0.0f, 0.02f}) {
            World world(desc_with(max_strain, {0, 0, 0}));
            const gphys_body_id body = add(world, PoleBall(exact));
            for (int i = 0; i < 60; ++i) world.step(frame);
            CAPTURE(exact, max_strain);
            CHECK(world.stats(body).strain_max < 0.01f);
            CHECK(world.substeps(body) == (max_strain > 0 ? 1 : 8));
            CHECK(sleeping(world) == 1);
        }
    }
}

TEST_CASE("such a ball falls on the ground within its strain, and without the maximum of substeps", "[simulation]") {
    for (const bool exact : {true, false}) {
        World world(desc_with(0.02f, {0, -9.81f, 0}));
        const gphys_plane ground{{0, 1, 0}, -0.6f};
        world.model(GPHYS_SHAPE_PLANE, &ground);
        const gphys_body_id body = add(world, PoleBall(exact));
        float worst = 0;
        for (int i = 0; i < 120; ++i) {
            world.step(frame);
            worst = std::max(worst, world.stats(body).strain_max);
        }
        CAPTURE(exact);
        // Positions of cloth are rounded to floats.
        CHECK(worst < 0.0201f);
        CHECK(world.substeps(body) < 64);
    }
}

TEST_CASE("a length below a nanometre is stored as 0, however it is given") {
    World world;
    const gphys_body_id body = world.particles({{0, 0, 0}, {1e-10f, 0, 0}, {1, 0, 0}, {1 + 1e-3f, 0, 0}});
    gphys_constraint_id id = 0;
    const auto added = [&](uint32_t a, uint32_t b, float length, auto&& add) {
        REQUIRE(add(world.solver, body, a, b, length, 0.0f, &id) == GPHYS_OK);
        return rest_length(world, body, id);
    };
    for (const auto& add : {gphys_solver_add_distance, gphys_solver_add_max_distance}) {
        CHECK(added(0, 1, -1, add) == 0);
        CHECK(added(0, 2, 0.9e-9f, add) == 0);
        CHECK(added(0, 2, 1.1e-9f, add) == 1.1e-9f);
        CHECK(added(2, 3, -1, add) == Approx(1e-3f).epsilon(1e-3));
    }
    for (const float length : {0.9e-9f, 1.1e-9f}) {
        const gphys_constraint_settings settings{length, 0, 0};
        REQUIRE(gphys_solver_set_constraint_settings(world.solver, body, &id, &settings, 0, 1) == GPHYS_OK);
        CHECK(rest_length(world, body, id) == (length < 1e-9f ? 0 : length));
    }
    const gphys_body_id ball = add(world, PoleBall(false));
    size_t without_length = 0;
    for (const gphys_constraint_info& info : constraints(world, ball)) {
        without_length += info.rest_length == 0;
        REQUIRE((info.rest_length == 0 || info.rest_length > 0.01f));
    }
    CHECK(without_length >= 2 * (PoleBall::ring - 1));
}

TEST_CASE("a link of no length that is torn apart keeps its body awake") {
    World world(desc_with(0, {0, 0, 0}));
    const gphys_body_id body = world.particles({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    for (const uint32_t held : {0u, 1u}) world.pin(body, held);
    gphys_constraint_id link = 0, torn = 0;
    REQUIRE(gphys_solver_add_distance(world.solver, body, 1, 2, -1, 0, &link) == GPHYS_OK);
    REQUIRE(gphys_solver_add_distance(world.solver, body, 0, 1, 0, 0, &torn) == GPHYS_OK);
    for (int i = 0; i < 60; ++i) world.step(frame);
    CHECK(sleeping(world) == 0);
    REQUIRE(gphys_solver_remove_constraint(world.solver, body, torn) == GPHYS_OK);
    for (int i = 0; i < 60; ++i) world.step(frame);
    CHECK(sleeping(world) == 1);
}
