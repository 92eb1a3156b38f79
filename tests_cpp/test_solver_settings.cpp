// Settings that change while bodies move: of the solver, of bodies, and of constraints.
#include "snapshots.h"

using namespace test;
using gphys::Vec3;

namespace {

constexpr double g = static_cast<double>(9.81f);
constexpr float frame = 1.0f / 60;

gphys_body_settings settings_of(const World& world, gphys_body_id body) {
    gphys_body_settings settings{};
    REQUIRE(gphys_solver_get_body_settings(world.solver, body, &settings) == GPHYS_OK);
    return settings;
}
void set(World& world, gphys_body_id body, const gphys_body_settings& settings) {
    REQUIRE(gphys_solver_set_body_settings(world.solver, body, &settings) == GPHYS_OK);
}

std::vector<gphys_constraint_id> links_of(const World& world, gphys_body_id body) {
    uint32_t total = 0;
    gphys_solver_get_constraints(world.solver, body, nullptr, 0, &total);
    std::vector<gphys_constraint_info> infos(total);
    REQUIRE(gphys_solver_get_constraints(world.solver, body, infos.data(), total, &total) == GPHYS_OK);
    std::vector<gphys_constraint_id> ids;
    for (const gphys_constraint_info& info : infos) ids.push_back(info.id);
    return ids;
}
gphys_constraint_settings settings_of(const World& world, gphys_body_id body, gphys_constraint_id link) {
    gphys_constraint_settings settings{};
    REQUIRE(gphys_solver_get_constraint_settings(world.solver, body, &link, 1, &settings, sizeof settings) == GPHYS_OK);
    return settings;
}
/// The same for all.
void set(World& world, gphys_body_id body, const std::vector<gphys_constraint_id>& links,
         const gphys_constraint_settings& settings) {
    REQUIRE(gphys_solver_set_constraint_settings(world.solver, body, links.data(), &settings, 0,
                                                 static_cast<uint32_t>(links.size())) == GPHYS_OK);
}
void set_length(World& world, gphys_body_id body, const std::vector<gphys_constraint_id>& links, double length) {
    gphys_constraint_settings settings = settings_of(world, body, links.front());
    settings.rest_length = static_cast<float>(length);
    set(world, body, links, settings);
}

/// A rope of a metre that hangs with 10 kg at its end.
gphys_body_id loaded_rope(World& world, float compliance = 0) {
    gphys_body_desc desc = World::body_desc();
    desc.compliance = compliance;
    const gphys_body_id rope = world.rope(line({0, 0, 0}, {0, -0.1f, 0}, 11), 0, desc);
    const float weight = 10;
    REQUIRE(gphys_solver_set_masses(world.solver, rope, 10, 1, &weight, 4) == GPHYS_OK);
    world.pin(rope, 0);
    return rope;
}

}  // namespace

TEST_CASE("A winch lifts a weight at its speed") {
    World world(8);
    const gphys_body_id rope = loaded_rope(world);
    const std::vector<gphys_constraint_id> links = links_of(world, rope);
    for (int i = 0; i < 30; ++i) world.step(frame);
    const double bottom = world.position(rope, 10).y, speed = 0.5;
    double slowest = 1, fastest = 0;
    for (int i = 1; i <= 60; ++i) {
        set_length(world, rope, links, 0.1 - speed * frame * i / 10);
        world.step(frame);
        const double now = gphys::widen(world.velocities(rope)[10]).y;
        if (i > 10) slowest = std::min(slowest, now), fastest = std::max(fastest, now);
    }
    figure("winch, height against the rope reeled in", std::fabs(world.position(rope, 10).y - bottom - speed), "m");
    // Links are as long as they are to 1e-9 of their length; lengths are float32 of 0.1 m, ten of them.
    CHECK(std::fabs(world.position(rope, 10).y - bottom - speed) < 1e-6);
    // A length that jumped at the beginning of each step would make it eight times as fast, and then still.
    CHECK(slowest > 0.98 * speed);
    CHECK(fastest < 1.02 * speed);
}

TEST_CASE("A rope that is let out hangs as long as it is") {
    World world(8);
    const gphys_body_id rope = loaded_rope(world);
    const std::vector<gphys_constraint_id> links = links_of(world, rope);
    for (int i = 1; i <= 60; ++i) {
        set_length(world, rope, links, 0.1 + 0.1 * i / 60);
        world.step(frame);
    }
    for (int i = 0; i < 60; ++i) world.step(frame);
    CHECK(std::fabs(world.position(rope, 10).y + 2) < 1e-5);
    CHECK(world.stats(rope).strain_max < 1e-6);
}

TEST_CASE("A muscle in a graph pulls its ends together") {
    // A triangle can have any lengths without stress.
    World world(8, {0, 0, 0});
    gphys_body_desc desc = World::body_desc();
    desc.damping = 4;
    const gphys_body_id body = world.particles({{0, 0, 0}, {1, 0, 0}, {0.5f, 0.8f, 0}}, desc);
    std::vector<gphys_constraint_id> links;
    for (uint32_t i = 0; i < 3; ++i) {
        gphys_constraint_id id = 0;
        REQUIRE(gphys_solver_add_distance(world.solver, body, i, (i + 1) % 3, -1, i == 0 ? 1e-4f : 0, &id) == GPHYS_OK);
        links.push_back(id);
    }
    gphys_body_info info{};
    REQUIRE(gphys_solver_get_body_info(world.solver, body, &info) == GPHYS_OK);
    REQUIRE(info.method == GPHYS_SOLVE_GRAPH);
    world.step(frame);
    for (int i = 1; i <= 60; ++i) {
        set_length(world, body, {links[0]}, 1 - 0.3 * i / 60);
        world.step(frame);
    }
    for (int i = 0; i < 240; ++i) world.step(frame);
    // Its spring has settled; float32 positions.
    CHECK(std::fabs(distance(world.position(body, 0), world.position(body, 1)) - 0.7) < 1e-5);
    CHECK(world.stats(body).strain_max < 1e-5);
}

TEST_CASE("Pinned cloth that is given longer links hangs lower") {
    // Reach limits are those of the new lengths.
    World world(8);
    gphys_body_desc desc = World::body_desc();
    desc.cloth_flags = GPHYS_CLOTH_SHEAR;
    desc.damping = 2;
    const gphys_body_id cloth = world.cloth({0, 0, 0}, {0.5f, 0, 0}, {0, -0.5f, 0}, 6, 6, desc);
    for (uint32_t p = 0; p < 6; ++p) world.pin(cloth, p);
    world.step(frame);
    std::vector<gphys_constraint_id> upright;
    uint32_t total = 0;
    gphys_constraint_info infos[200];
    REQUIRE(gphys_solver_get_constraints(world.solver, cloth, infos, 200, &total) == GPHYS_OK);
    for (uint32_t i = 0; i < total; ++i) {
        if (infos[i].particle_b == infos[i].particle_a + 6) upright.push_back(infos[i].id);
        // Diagonals would keep the cells as they are.
        if (infos[i].particle_b != infos[i].particle_a + 6 && infos[i].particle_b != infos[i].particle_a + 1) {
            REQUIRE(gphys_solver_remove_constraint(world.solver, cloth, infos[i].id) == GPHYS_OK);
        }
    }
    for (int i = 1; i <= 60; ++i) {
        set_length(world, cloth, upright, 0.1 + 0.05 * i / 60);
        world.step(frame);
    }
    for (int i = 0; i < 120; ++i) world.step(frame);
    // The rest is what is left to links by the relaxation of cloth without a target: 2 %.
    CHECK(std::fabs(world.position(cloth, 32).y + 0.75) < 0.75 * 0.02);
}

TEST_CASE("A link's compliance and damping change without a jump of its ends") {
    World world(8);
    const gphys_body_id body = world.particles({{0, 0, 0}, {0, -1, 0}});
    world.pin(body, 0);
    gphys_constraint_id link = 0;
    REQUIRE(gphys_solver_add_distance(world.solver, body, 0, 1, 1, 1e-2f, &link) == GPHYS_OK);
    gphys_constraint_settings settings = settings_of(world, body, link);
    CHECK((settings.rest_length == 1 && settings.compliance == 1e-2f && settings.damping == 0));
    settings.damping = 20;
    set(world, body, {link}, settings);
    for (int i = 0; i < 300; ++i) world.step(frame);
    const double weight = 0.5 * g;  // a body of 1 kg has two particles
    CHECK(std::fabs(-world.position(body, 1).y - 1 - weight * 1e-2f) < 1e-6);
    settings.compliance = 3e-2f;
    set(world, body, {link}, settings);
    CHECK(settings_of(world, body, link).compliance == 3e-2f);
    for (int i = 0; i < 600; ++i) world.step(frame);
    CHECK(std::fabs(-world.position(body, 1).y - 1 - weight * 3e-2f) < 1e-5);
}

TEST_CASE("A constraint that is removed before the step is not missed") {
    for (const bool graph : {false, true}) {
        World world(4);
        const gphys_body_id body = graph ? world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 4, 4)
                                         : world.rope(line({0, 0, 0}, {0.1f, 0, 0}, 6), 0);
        world.pin(body, 0);
        const std::vector<gphys_constraint_id> links = links_of(world, body);
        set_length(world, body, links, 0.2);
        REQUIRE(gphys_solver_remove_constraint(world.solver, body, links[2]) == GPHYS_OK);
        world.step(frame);
        CHECK(world.stats(body).constraint_count == links.size() - 1);
    }
}

TEST_CASE("A snapshot between a change of settings and the step goes on with the same bits") {
    for (const int kind : {0, 1, 2}) {
        World world(4), other(4);
        gphys_body_desc desc = World::body_desc();
        desc.compliance = 1e-4f;
        const gphys_body_id body = kind == 0   ? loaded_rope(world)
                                   : kind == 1 ? world.cloth({0, 0, 0}, {0.6f, 0, 0}, {0, 0, 0.6f}, 5, 5)
                                               : world.cloth({0, 0, 0}, {0.6f, 0, 0}, {0, 0, 0.6f}, 5, 5, desc);
        world.pin(body, 0);
        const std::vector<gphys_constraint_id> links = links_of(world, body);
        for (int i = 0; i < 10; ++i) world.step(frame);
        gphys_constraint_settings settings = settings_of(world, body, links[3]);
        settings.rest_length *= 1.5f;
        settings.damping = 0.1f;
        set(world, body, {links[3], links[5], links[2]}, settings);
        REQUIRE(restore(other.solver, snapshot(world.solver)) == GPHYS_OK);
        for (int i = 0; i < 5; ++i) {
            world.step(frame);
            other.step(frame);
            CHECK(hash(world.solver) == hash(other.solver));
        }
        REQUIRE(restore(other.solver, snapshot(world.solver)) == GPHYS_OK);
        world.step(frame);
        other.step(frame);
        CHECK(hash(world.solver) == hash(other.solver));
    }
}

TEST_CASE("A floor turns to ice and back") {
    World world(8);
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const gphys_body_id body = world.particles({{0, 0.0100011f, 0}}, point_mass(0.01f, 0, 0));
    world.set_velocity(body, 0, {3, 0, 0});
    for (int i = 0; i < 30; ++i) world.step(frame);
    const double before = gphys::widen(world.velocities(body)[0]).x;
    CHECK(before > 2.99);
    gphys_body_settings settings = settings_of(world, body);
    settings.friction = 0.4f;
    settings.static_friction = 0.6f;
    set(world, body, settings);
    for (int i = 0; i < 30; ++i) world.step(frame);
    // mu g t; impacts count what presses by substep: a part of g h.
    CHECK(std::fabs(before - gphys::widen(world.velocities(body)[0]).x - 0.4 * g * 30 * frame) < 0.4 * g * frame / 4);
    settings.static_friction = 0;
    set(world, body, settings);
    CHECK(settings_of(world, body).static_friction == settings.friction);
    for (int i = 0; i < 60; ++i) world.step(frame);
    CHECK(world.velocities(body)[0].x == 0);
}

TEST_CASE("Layers decide from the next step on what a body meets") {
    World world(8);
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const gphys_body_id body = world.particles({{0, 0.5f, 0}}, point_mass(0.01f, 0.5f, 0));
    for (int i = 0; i < 60; ++i) world.step(frame);
    CHECK(std::fabs(world.position(body).y - 0.01) < 1e-5);
    gphys_body_settings settings = settings_of(world, body);
    settings.layers = 0;
    set(world, body, settings);
    for (int i = 0; i < 60; ++i) world.step(frame);
    CHECK(std::fabs(world.position(body).y - 0.01 + 0.5 * g) < 0.01);
    CHECK(world.stats(body).contact_count == 0);
}

TEST_CASE("Particles collide with one another once they are told to") {
    World world(8, {0, 0, 0});
    gphys_body_desc desc = point_mass(0.1f, 0, 1);
    const gphys_body_id body = world.particles({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, desc);
    world.set_velocity(body, 1, {1, 0, 0});
    gphys_body_settings settings = settings_of(world, body);
    settings.self_collision = 1;
    set(world, body, settings);
    for (int i = 0; i < 180; ++i) world.step(frame);
    // Equal masses change velocities; positions of the impact are exact to a substep.
    CHECK(std::fabs(world.velocities(body)[1].x) < 1e-6f);
    CHECK(std::fabs(world.velocities(body)[2].x - 1) < 1e-6f);
    settings.self_collision = 0;
    set(world, body, settings);
    world.set_velocity(body, 2, {-2, 0, 0});
    for (int i = 0; i < 180; ++i) world.step(frame);
    CHECK(world.velocities(body)[2].x == -2);
}

TEST_CASE("Damping and restitution change while a ball bounces") {
    World world(8);
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const gphys_body_id body = world.particles({{0, 1.01f, 0}}, point_mass(0.01f, 0, 0));
    gphys_body_settings settings = settings_of(world, body);
    settings.restitution = 0.5f;
    set(world, body, settings);
    double highest = 0;
    bool bounced = false;
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        bounced = bounced || world.velocities(body)[0].y > 0;
        if (bounced) highest = std::max(highest, world.position(body).y - 0.01);
    }
    // e^2 h; the peak lies within half a frame, g dt^2 / 8.
    CHECK(std::fabs(highest - 0.25) < g * frame * frame / 8 + 1e-4);
    World empty(8, {0, 0, 0});
    const gphys_body_id slow = empty.particles({{0, 0, 0}});
    empty.set_velocity(slow, 0, {1, 0, 0});
    settings.damping = 2;
    set(empty, slow, settings);
    for (int i = 0; i < 60; ++i) empty.step(frame);
    CHECK(std::fabs(empty.velocities(slow)[0].x - std::exp(-2.0)) < 1e-6);
}

TEST_CASE("Settings of a solver are read as they were given, and change") {
    gphys_solver_desc desc = World::desc(5, {0, -3, 0});
    desc.fixed_step = 0.01f;
    desc.max_steps = 3;
    desc.sleep_speed = 0.1f;
    desc.max_strain = 0.01f;
    desc.tolerance = 0.1f;
    desc.max_substeps = 40;
    desc.max_work = 1000;
    World world(desc);
    gphys_solver_settings settings{};
    REQUIRE(gphys_solver_get_settings(world.solver, &settings) == GPHYS_OK);
    CHECK((settings.substeps == 5 && settings.gravity.y == -3 && settings.fixed_step == 0.01f));
    CHECK((settings.max_steps == 3 && settings.sleep_speed == 0.1f && settings.sleep_strain == 0.01f));
    CHECK((settings.sleep_time == 0.5f && settings.max_strain == 0.01f && settings.tolerance == 0.1f));
    CHECK((settings.max_substeps == 40 && settings.max_work == 1000));
    uint32_t steps = 0;
    float leftover = 0;
    world.particles({{0, 0, 0}});
    REQUIRE(gphys_solver_advance(world.solver, nullptr, 0.009f, &steps, &leftover) == GPHYS_OK);
    CHECK(steps == 0);
    settings.fixed_step = 0.002f;
    settings.gravity = {0, 0, 0};
    REQUIRE(gphys_solver_set_settings(world.solver, &settings) == GPHYS_OK);
    // What is owed beyond a step is dropped, and the state is one that a snapshot may have.
    World other;
    CHECK(restore(other.solver, snapshot(world.solver)) == GPHYS_OK);
    REQUIRE(gphys_solver_advance(world.solver, nullptr, 0, &steps, &leftover) == GPHYS_OK);
    CHECK(steps == 1);
}

TEST_CASE("Sleepers wake when the settings of sleep change") {
    gphys_solver_desc desc = World::desc(4, {0, 0, 0});
    desc.sleep_speed = 0.1f;
    World world(desc);
    world.particles({{0, 0, 0}});
    for (int i = 0; i < 40; ++i) world.step(frame);
    uint32_t asleep = 0;
    gphys_solver_get_sleeping(world.solver, nullptr, 0, &asleep);
    REQUIRE(asleep == 1);
    gphys_solver_settings settings{};
    REQUIRE(gphys_solver_get_settings(world.solver, &settings) == GPHYS_OK);
    settings.sleep_speed = 0;
    REQUIRE(gphys_solver_set_settings(world.solver, &settings) == GPHYS_OK);
    gphys_solver_get_sleeping(world.solver, nullptr, 0, &asleep);
    CHECK(asleep == 0);
}

TEST_CASE("Bodies share the work that a step may do") {
    gphys_solver_desc desc = World::desc(8);
    World world(desc);
    const gphys_body_id rope = world.rope(line({0, 0, 0}, {0.1f, 0, 0}, 100), 0);
    const gphys_body_id cloth = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 10, 10);
    world.pin(rope, 0);
    const gphys_body_id joined = world.rope(line({5, 0, 0}, {0.1f, 0, 0}, 100), 0);
    const gphys_body_id to = world.rope(line({5, 1, 0}, {0.1f, 0, 0}, 100), 0);
    gphys_joint_id joint = 0;
    REQUIRE(gphys_solver_join(world.solver, joined, 0, to, 0, -1, 0, &joint) == GPHYS_OK);
    const auto substeps = [&](uint32_t max_work) {
        gphys_solver_settings settings{};
        REQUIRE(gphys_solver_get_settings(world.solver, &settings) == GPHYS_OK);
        settings.max_work = max_work;
        REQUIRE(gphys_solver_set_settings(world.solver, &settings) == GPHYS_OK);
        world.step(frame);
        uint32_t work = 0;
        for (const gphys_body_id body : {rope, cloth, joined, to}) work += 100 * world.substeps(body);
        return work;
    };
    CHECK(substeps(0) == 3200);
    CHECK(substeps(3200) == 3200);
    CHECK(substeps(3199) == 2800);
    CHECK(substeps(1600) == 1600);
    CHECK(substeps(1) == 400);
    // Cloth takes one for each 25 ms.
    world.step(0.09f);
    CHECK((world.substeps(cloth) == 4 && world.substeps(rope) == 1));
}
