// Animation targets: bounds around places that are given frame by frame, against what is known in closed form.
#include "snapshots.h"

using namespace test;
using gphys::Vec3;

namespace {

constexpr float frame = 1.0f / 60, none = INFINITY;

gphys_animation_target within(gphys_vec3 at, float max_distance) { return {at, {0, 0, 0}, max_distance, none}; }

void set(World& world, gphys_body_id body, uint32_t first, const std::vector<gphys_animation_target>& targets) {
    REQUIRE(gphys_solver_set_animation_targets(world.solver, body, first, static_cast<uint32_t>(targets.size()),
                                               targets.data(), sizeof targets[0]) == GPHYS_OK);
}
gphys_animation_target target_of(const World& world, gphys_body_id body, uint32_t particle) {
    gphys_animation_target target{};
    REQUIRE(gphys_solver_get_animation_targets(world.solver, body, particle, 1, &target, sizeof target) == GPHYS_OK);
    return target;
}
/// All particles of a body, to where they are and so far from there.
void set_where_they_are(World& world, gphys_body_id body, float max_distance) {
    std::vector<gphys_animation_target> targets;
    for (const gphys_vec3& at : world.positions(body)) targets.push_back(within(at, max_distance));
    set(world, body, 0, targets);
}

gphys_body_desc layers(uint32_t models, uint32_t self_collision = 0) {
    gphys_body_desc desc = World::body_desc();
    desc.layers = models;
    desc.self_collision = self_collision;
    return desc;
}

}  // namespace

TEST_CASE("Strain that no substeps cure, of targets that pull a sheet apart, does not take the maximum of them") {
    gphys_solver_desc settings{};
    REQUIRE(gphys_solver_desc_init(&settings, sizeof settings) == GPHYS_OK);
    settings.max_strain = 0.02f;
    World world(settings);
    const gphys_body_id body = world.cloth({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 11, 11);
    std::vector<gphys_animation_target> targets;
    for (const gphys_vec3& at : world.positions(body)) targets.push_back(within({1.5f * at.x, at.y, at.z}, 0.005f));
    set(world, body, 0, targets);
    uint32_t most = 0, now = 0;
    for (int i = 0; i < 20; ++i) {
        world.step(frame);
        REQUIRE(gphys_solver_get_substeps(world.solver, body, &now) == GPHYS_OK);
        most = std::max(most, now);
    }
    figure("most substeps", most, "");
    CHECK(most < settings.max_substeps);
    CHECK(now < settings.max_substeps / 2);
    REQUIRE(all_finite(world.positions(body)));
}

TEST_CASE("A free particle hangs at exactly its distance below its target, at rest") {
    for (const uint32_t substeps : {1u, 8u}) {
        World world(substeps);
        const gphys_body_id ball = world.particles({{0, 2, 0}});
        set(world, ball, 0, {within({0, 2, 0}, 0.25f)});
        for (int i = 0; i < 60; ++i) world.step(frame);
        CHECK(world.positions(ball)[0].y == 1.75f);
        CHECK(world.velocities(ball)[0].y == 0);
        // Let go, it falls.
        set(world, ball, 0, {within({0, 0, 0}, none)});
        world.step(frame);
        CHECK(world.positions(ball)[0].y < 1.75f);
    }
}

TEST_CASE("A rope hangs from a particle at its bound as from a pin, the bound of any other kind of motion as well") {
    for (const bool joined : {false, true}) {
        World world(8);
        gphys_body_desc desc = World::body_desc();
        desc.damping = 5;
        const gphys_body_id rope = world.rope(line({0, 2, 0}, {0, -0.1f, 0}, 11), 0, desc);
        const gphys_body_id other = world.particles({{0, 0.9f, 0}}, desc);
        gphys_joint_id joint = 0;
        if (joined) REQUIRE(gphys_solver_join(world.solver, rope, 10, other, 0, -1, 0, &joint) == GPHYS_OK);
        set(world, rope, 0, {within({0, 2, 0}, 0.25f)});
        for (int i = 0; i < 240; ++i) world.step(frame);
        const std::vector<gphys_vec3> at = world.positions(rope);
        CHECK(std::fabs(at[0].y - 1.75f) < 1e-6f);
        CHECK(std::fabs(at[0].x) < 1e-6f);
        const double strain = static_cast<double>(world.stats(rope).strain_max);
        figure(joined ? "strain of a joined rope that hangs from a target" : "strain of one alone", strain, "");
        // Joined, the particle alone is put back, by what all below it falls in a substep.
        CHECK(strain < (joined ? 0.05 : 1e-5));
        CHECK(std::fabs(world.velocities(rope)[0].y) < 1e-4f);
    }
}

TEST_CASE("Cloth hangs from particles at their bounds as from pins") {
    World world(8);
    gphys_body_desc desc = World::body_desc();
    desc.damping = 2;
    const gphys_body_id sheet = world.cloth({0, 2, 0}, {1, 0, 0}, {0, -1, 0}, 21, 21, desc);
    std::vector<gphys_animation_target> targets;
    const std::vector<gphys_vec3> first = world.positions(sheet);
    for (uint32_t p = 0; p < 21; ++p) targets.push_back(within(first[p], 0.05f));
    set(world, sheet, 0, targets);
    for (int i = 0; i < 240; ++i) world.step(frame);
    const std::vector<gphys_vec3> at = world.positions(sheet);
    double worst = 0;
    for (uint32_t p = 0; p < 21; ++p) {
        const Vec3 off = gphys::widen(at[p]) - gphys::widen(first[p]);
        worst = std::max(worst, length(off) - static_cast<double>(0.05f));
    }
    figure("beyond the bound", worst, "m");
    CHECK(worst < 3e-7);  // float32 of a sheet of a metre
    CHECK(std::fabs(at[10].y - 1.95f) < 1e-3f);
    const double strain = static_cast<double>(world.stats(sheet).strain_max);
    figure("strain", strain, "");
    CHECK(strain < 0.02);
}

TEST_CASE("A target of distance 0 carries its particle evenly, also a pinned one, and others not what is held") {
    for (int kind = 0; kind < 3; ++kind) {
        World world(8, {0, 0, 0});
        const std::vector<gphys_vec3> row = line({0, 0, 0}, {0.1f, 0, 0}, 3);
        const gphys_body_id body = kind == 0   ? world.particles(row)
                                   : kind == 1 ? world.rope(row, 0)
                                               : world.cloth({0, 0, 0}, {0.2f, 0, 0}, {0, 0.2f, 0}, 3, 3);
        CAPTURE(kind);
        world.pin(body, 0);
        world.pin(body, 2);
        for (int i = 1; i <= 30; ++i) {
            const float way = 0.05f * static_cast<float>(i);
            set(world, body, 0, {within({0, 0, way}, 0), within({0.1f, 0, way}, 0), within({0.2f, 0, way}, 0.01f)});
            world.step(frame);
            if (i == 1) continue;  // the first target is at once where it is set
            const std::vector<gphys_vec3> at = world.positions(body), velocity = world.velocities(body);
            CHECK(at[0].z == way);
            CHECK(at[1].z == way);
            CHECK(std::fabs(at[2].z) < 1e-6f);  // cloth is float32 around its middle
            if (i == 2) continue;
            CHECK(std::fabs(velocity[0].z - 3) < 1e-4f);
            CHECK(std::fabs(velocity[1].z - 3) < 1e-4f);
            CHECK(velocity[2].z == 0);
        }
        int32_t pinned[3];
        REQUIRE(gphys_solver_get_pinned(world.solver, body, 0, 3, pinned, 4) == GPHYS_OK);
        CHECK((pinned[0] == 1 && pinned[1] == 0 && pinned[2] == 1));
        // What stands still has no speed, and without a target a pinned particle stays where it is.
        world.step(frame);
        world.step(frame);
        CHECK(std::fabs(world.velocities(body)[0].z) < 1e-4f);
        set(world, body, 0, {within({0, 0, 9}, 0)});
        world.step(frame);
        const float last = world.positions(body)[0].z;
        set(world, body, 0, {within({0, 0, 0}, none)});
        CHECK(world.velocities(body)[0].z == 0);
        world.step(frame);
        CHECK(world.positions(body)[0].z == last);
    }
}

TEST_CASE("What a target drags along has its velocity, at its distance behind it") {
    for (int kind = 0; kind < 3; ++kind) {
        for (const bool carries : {false, true}) {
            World world(8, {0, 0, 0});
            const std::vector<gphys_vec3> row = line({0, 0, 0}, {0.1f, 0, 0}, 3);
            const gphys_body_id body = kind == 0   ? world.particles(row)
                                       : kind == 1 ? world.rope(row, 0)
                                                   : world.cloth({0, 0, 0}, {0.2f, 0, 0}, {0, 0.2f, 0}, 3, 3);
            const std::vector<gphys_vec3> first = world.positions(body);
            const float distance = carries ? 0 : 0.25f;
            float way = 0;
            for (int i = 0; i <= 60; ++i) {
                way = 0.05f * static_cast<float>(i);
                std::vector<gphys_animation_target> targets;
                for (const gphys_vec3& at : first) targets.push_back(within({at.x, at.y, at.z + way}, distance));
                set(world, body, 0, targets);
                world.step(frame);
            }
            const std::vector<gphys_vec3> at = world.positions(body), velocity = world.velocities(body);
            double off = 0, slow = 0;
            for (size_t p = 0; p < first.size(); ++p) {
                const Vec3 behind = gphys::widen(first[p]) + Vec3{0, 0, static_cast<double>(way - distance)};
                off = std::max(off, length(gphys::widen(at[p]) - behind));
                slow = std::max(slow, length(gphys::widen(velocity[p]) - Vec3{0, 0, 3}));
            }
            CAPTURE(kind, carries, off, slow);
            CHECK(off < 1e-5);
            CHECK(slow < 1e-4);
        }
    }
}

TEST_CASE("A fast target does not go its way in one substep") {
    World world(8, {0, 0, 0});
    const gphys_body_id ball = world.particles({{0, 0, 0}});
    set(world, ball, 0, {within({0, 0, 0}, 0.5f)});
    world.step(frame);
    // In an eighth of the frame it would get 480 m/s.
    set(world, ball, 0, {within({1, 0, 0}, 0.5f)});
    world.step(frame);
    CHECK(world.positions(ball)[0].x == 0.5f);
    CHECK(std::fabs(world.velocities(ball)[0].x - 60) < 1e-3f);
}

TEST_CASE("A backstop is a plane, and its edge with the ball is where both leave room") {
    for (int kind = 0; kind < 3; ++kind) {
        CAPTURE(kind);
        // Gravity presses down on the plane and along it.
        World world(8, {5, -9, 0});
        gphys_body_desc desc = World::body_desc();
        desc.damping = 3;
        const std::vector<gphys_vec3> row = line({0, 1, 0}, {0, 0, 0.1f}, 3);
        const gphys_body_id body = kind == 0   ? world.particles(row, desc)
                                   : kind == 1 ? world.rope(row, 0, desc)
                                               : world.cloth({0, 1, 0}, {0, 0, 0.2f}, {0.2f, 0, 0}, 3, 3, desc);
        const std::vector<gphys_vec3> first = world.positions(body);
        std::vector<gphys_animation_target> targets;
        for (const gphys_vec3& at : first) targets.push_back({at, {0, 4, 0}, 0.5f, 0.3f});
        set(world, body, 0, targets);
        for (int i = 0; i < 240; ++i) world.step(frame);
        const std::vector<gphys_vec3> at = world.positions(body), velocity = world.velocities(body);
        for (size_t p = 0; p < first.size(); ++p) {
            CHECK(std::fabs(at[p].x - first[p].x - 0.4f) < 1e-5f);
            CHECK(std::fabs(at[p].y - first[p].y + 0.3f) < 1e-5f);
            CHECK(std::fabs(at[p].z - first[p].z) < 1e-5f);
            CHECK(length(gphys::widen(velocity[p])) < 1e-4);
        }
        // Without a ball it slides on along the plane.
        for (gphys_animation_target& target : targets) target.max_distance = none;
        set(world, body, 0, targets);
        for (int i = 0; i < 60; ++i) world.step(frame);
        CHECK(world.positions(body)[0].x > first[0].x + 1);
        CHECK(std::fabs(world.positions(body)[0].y - first[0].y + 0.3f) < 1e-5f);
    }
}

TEST_CASE("A backstop that turns takes particles with it") {
    World world(16, {0, 0, 0});
    const gphys_body_id ball = world.particles({{1, 0, 0}});
    // As a door on its hinge at the origin: half a radian a second.
    double angle = 0;
    for (int i = 0; i < 60; ++i) {
        angle = 0.5 * i * static_cast<double>(frame);
        const gphys_vec3 normal{static_cast<float>(-std::sin(angle)), static_cast<float>(std::cos(angle)), 0};
        set(world, ball, 0, {{{0, 0, 0}, normal, none, 0}});
        world.step(frame);
    }
    const Vec3 n{-std::sin(angle), std::cos(angle), 0}, at = world.position(ball);
    CHECK(std::fabs(dot(at, n)) < 1e-6);
    // Without friction it has no speed along the door but what it won by the centrifugal force.
    CHECK(std::fabs(dot(gphys::widen(world.velocities(ball)[0]), n) - 0.5 * length(at)) < 2e-3);
}

TEST_CASE("What lies within its bounds is not touched") {
    for (int kind = 0; kind < 3; ++kind) {
        CAPTURE(kind);
        World with(8), without(8);
        gphys_body_id bodies[2];
        World* const worlds[2] = {&with, &without};
        for (int i = 0; i < 2; ++i) {
            const std::vector<gphys_vec3> row = line({0, 3, 0}, {0.1f, 0, 0}, 12);
            bodies[i] = kind == 0   ? worlds[i]->particles(row)
                        : kind == 1 ? worlds[i]->rope(row, 0)
                                    : worlds[i]->cloth({0, 3, 0}, {1, 0, 0}, {0, 0, 1}, 12, 12);
            if (kind > 0) worlds[i]->pin(bodies[i], 0);
        }
        double apart = 0;
        for (int i = 0; i < 60; ++i) {
            set_where_they_are(with, bodies[0], 0.5f);
            with.step(frame);
            without.step(frame);
            const std::vector<gphys_vec3> a = with.positions(bodies[0]), b = without.positions(bodies[1]);
            for (size_t p = 0; p < a.size(); ++p)
                apart = std::max(apart, length(gphys::widen(a[p]) - gphys::widen(b[p])));
        }
        // A rope with targets is solved by the other of its two solutions.
        CHECK(apart <= (kind == 1 ? 1e-5 : 0));
    }
}

TEST_CASE("Targets that are where the particles are cost no momentum") {
    World world(8, {0, 0, 0});
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 8, 8);
    for (uint32_t p = 0; p < 64; ++p) world.set_velocity(sheet, p, {0, 0, 3});
    for (int i = 0; i < 60; ++i) {
        set_where_they_are(world, sheet, 0.06f);  // it goes 0.05 m in a frame
        world.step(frame);
    }
    for (const gphys_vec3& velocity : world.velocities(sheet))
        CHECK(length(gphys::widen(velocity) - Vec3{0, 0, 3}) < 1e-4);
}

TEST_CASE("Contacts win: a target in a model leaves its particle outside") {
    for (int kind = 0; kind < 3; ++kind) {
        CAPTURE(kind);
        World world(8, {0, 0, 0});
        const gphys_sphere sphere{{0, 0, 0}, 0.5f};
        world.model(GPHYS_SHAPE_SPHERE, &sphere);
        const std::vector<gphys_vec3> row = line({0, 0.8f, -0.1f}, {0, 0, 0.1f}, 3);
        const gphys_body_id body = kind == 0   ? world.particles(row)
                                   : kind == 1 ? world.rope(row, 0)
                                               : world.cloth({0, 0.8f, -0.1f}, {0, 0, 0.2f}, {0.2f, 0, 0}, 3, 3);
        const std::vector<gphys_vec3> first = world.positions(body);
        double nearest = 1;
        for (int i = 0; i < 120; ++i) {
            const float way = std::min(1.4f, 0.05f * static_cast<float>(i));  // through the middle
            std::vector<gphys_animation_target> targets;
            for (const gphys_vec3& at : first) targets.push_back(within({at.x, at.y - way, at.z}, 0.05f));
            set(world, body, 0, targets);
            world.step(frame);
            for (const gphys_vec3& at : world.positions(body)) nearest = std::min(nearest, length(gphys::widen(at)));
        }
        figure("nearest to the middle of a ball of 0.51 m", nearest, "m");
        CHECK(nearest > 0.51 - 1e-4);
    }
}

TEST_CASE("What a target takes far in one step meets the models and bodies on its way") {
    for (int kind = 0; kind < 3; ++kind) {
        CAPTURE(kind);
        World world(8, {0, 0, 0});
        const gphys_aabb wall{{2, -1, -1}, {2.5f, 1, 1}};
        world.model(GPHYS_SHAPE_AABB, &wall);
        const std::vector<gphys_vec3> row = line({0, 0, -0.1f}, {0, 0, 0.1f}, 3);
        const gphys_body_id body = kind == 0   ? world.particles(row)
                                   : kind == 1 ? world.rope(row, 0)
                                               : world.cloth({0, 0, -0.1f}, {0, 0, 0.2f}, {0, 0.2f, 0}, 3, 3);
        const std::vector<gphys_vec3> first = world.positions(body);
        for (const float way : {0.0f, 4.0f}) {
            std::vector<gphys_animation_target> targets;
            for (const gphys_vec3& at : first) targets.push_back(within({at.x + way, at.y, at.z}, 0.5f));
            set(world, body, 0, targets);
            world.step(frame);
        }
        for (const gphys_vec3& at : world.positions(body)) {
            CHECK(at.x < 2);
            CHECK(at.x > 1.9f);
        }
    }

    World world(8, {0, 0, 0});
    gphys_body_desc thick = World::body_desc();
    thick.radius = 0.25f;
    thick.body_layers = 1;
    const gphys_body_id fast = world.particles({{0, 0, 0}}, thick), still = world.particles({{2, 0, 0}}, thick);
    set(world, fast, 0, {within({0, 0, 0}, 0.1f)});
    world.step(frame);
    set(world, fast, 0, {within({4, 0, 0}, 0.1f)});
    for (int i = 0; i < 2; ++i) world.step(frame);
    CHECK(world.positions(still)[0].x > 3.5f);
}

TEST_CASE("A teleport is set_positions and a new target: nothing is left of the way") {
    World world(8);
    const gphys_body_id sheet = world.cloth({0, 2, 0}, {1, 0, 0}, {0, -1, 0}, 8, 8);
    std::vector<gphys_vec3> at = world.positions(sheet);
    const auto aim = [&](float shift, float distance) {
        std::vector<gphys_animation_target> targets;
        for (size_t p = 0; p < at.size(); ++p)
            targets.push_back(within({at[p].x + shift, at[p].y, at[p].z}, p < 8 ? 0 : distance));
        set(world, sheet, 0, targets);
    };
    aim(0, 0.2f);
    for (int i = 0; i < 60; ++i) world.step(frame);
    // In either order.
    for (const bool first : {true, false}) {
        std::vector<gphys_vec3> moved = world.positions(sheet);
        const double energy = static_cast<double>(world.stats(sheet).kinetic_energy);
        const float shift = first ? 100.0f : 200.0f;
        for (gphys_vec3& p : moved) p.x += 100;
        if (first) aim(shift, 0.2f);
        REQUIRE(gphys_solver_set_positions(world.solver, sheet, 0, 64, moved.data(), 12) == GPHYS_OK);
        if (!first) aim(shift, 0.2f);
        for (int i = 0; i < 10; ++i) {
            world.step(frame);
            CHECK(static_cast<double>(world.stats(sheet).kinetic_energy) < energy + 0.01);
        }
        CHECK(std::fabs(world.positions(sheet)[0].x - shift) < 1e-4f);
    }
}

TEST_CASE("A body wakes when a target changes, and not when it is set again") {
    gphys_solver_desc desc = World::desc(8);
    desc.sleep_speed = 0.01f;
    desc.sleep_time = 0.2f;
    for (int kind = 0; kind < 3; ++kind) {
        CAPTURE(kind);
        World world(desc);
        gphys_body_desc damped = World::body_desc();
        damped.damping = 5;
        const std::vector<gphys_vec3> row = line({0, 2, 0}, {0, -0.1f, 0}, 5);
        const gphys_body_id body = kind == 0   ? world.particles(row, damped)
                                   : kind == 1 ? world.rope(row, 0, damped)
                                               : world.cloth({0, 2, 0}, {0.4f, 0, 0}, {0, -0.4f, 0}, 5, 5, damped);
        set_where_they_are(world, body, 0.05f);
        std::vector<gphys_animation_target> targets;
        for (uint32_t p = 0; p < world.positions(body).size(); ++p) targets.push_back(target_of(world, body, p));
        const auto sleeps = [&] {
            uint32_t total = 0;
            gphys_solver_get_sleeping(world.solver, nullptr, 0, &total);
            return total == 1;
        };
        for (int i = 0; i < 600 && !sleeps(); ++i) {
            set(world, body, 0, targets);
            world.step(frame);
        }
        REQUIRE(sleeps());
        targets[0].position.x += 0.2f;
        set(world, body, 0, targets);
        CHECK(!sleeps());
        world.step(frame);
        CHECK(world.positions(body)[0].x > 0.1f);
    }
}

TEST_CASE("Targets are where they were in the world when the origin moves") {
    World world(8, {0, 0, 0});
    const gphys_body_id ball = world.particles({{5, 0, 0}});
    set(world, ball, 0, {within({5, 0, 0}, 0.5f)});
    world.step(frame);
    const double origin[3] = {4, 0, 0};
    REQUIRE(gphys_solver_set_origin(world.solver, origin) == GPHYS_OK);
    REQUIRE(gphys_scene_set_origin(world.scene, origin) == GPHYS_OK);
    CHECK(target_of(world, ball, 0).position.x == 1);
    world.step(frame);
    CHECK(world.positions(ball)[0].x == 1);
}

TEST_CASE("An origin from which a target would be out of range is refused and changes nothing") {
    World world(8, {0, 0, 0});
    const gphys_body_id ball = world.particles({{-9e14f, 0, 0}});
    gphys_animation_target far = within({9e14f, 0, 0}, INFINITY);
    far.normal = {0, 1, 0};
    far.backstop = 1;
    set(world, ball, 0, {far});
    const double origin[3] = {-9e14, 0, 0};
    REQUIRE(gphys_solver_set_origin(world.solver, origin) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(target_of(world, ball, 0).position.x == 9e14f);
    CHECK(world.positions(ball)[0].x == -9e14f);
    // Of one that is taken away nothing is left.
    set(world, ball, 0, {within({9e14f, 0, 0}, INFINITY)});
    REQUIRE(gphys_solver_set_origin(world.solver, origin) == GPHYS_OK);
}

namespace {

/// Of all kinds, with targets of all kinds, beside a model that moves.
struct Party {
    explicit Party(uint32_t workers) : world(settings(workers)) {
        const gphys_capsule shape{{0, -0.5f, 0}, {0, 0.5f, 0}, 0.3f};
        runner = world.model(GPHYS_SHAPE_CAPSULE, &shape);
        bodies = {world.cloth({-0.3f, 0.6f, 0.35f}, {0.6f, 0, 0}, {0, -0.8f, 0.1f}, 9, 11),
                  world.rope(line({0.4f, 0.8f, 0}, {0, -0.1f, 0}, 9), 0),
                  world.rope(line({-0.4f, 0.8f, 0}, {0, -0.1f, 0}, 9), 0, layers(0)),
                  world.rope(line({-0.8f, 0.8f, 0}, {0, -0.1f, 0}, 9), 0, layers(1, 1)),
                  world.rope(line({0.8f, 0.8f, 0}, {0, -0.1f, 0}, 9), 0),
                  world.particles(line({-0.5f, 1.2f, 0}, {0.1f, 0, 0}, 11))};
        gphys_joint_id joint = 0;
        REQUIRE(gphys_solver_join(world.solver, bodies[3], 8, bodies[4], 8, 2, 0, &joint) == GPHYS_OK);
        for (const gphys_body_id body : bodies) first.push_back(world.positions(body));
    }
    static gphys_solver_desc settings(uint32_t workers) {
        gphys_solver_desc desc = World::desc(6);
        desc.worker_count = workers;
        return desc;
    }
    void step() {
        const float way = 0.04f * static_cast<float>(count++), turn = std::fmod(way, 1.0f);
        const gphys_transform place{{0, 0, way}, {0, 0, 0, 1}, 1};
        REQUIRE(gphys_scene_set_transform(world.scene, runner, &place) == GPHYS_OK);
        for (size_t i = 0; i < bodies.size(); ++i) {
            std::vector<gphys_animation_target> targets;
            for (size_t p = 0; p < first[i].size(); ++p) {
                const gphys_vec3 at = first[i][p];
                const float distance = p % 5 == 4 ? none : 0.05f * static_cast<float>(p % 5);
                targets.push_back({{at.x, at.y, at.z + way},
                                   {turn, 0, 1},
                                   distance,
                                   p % 3 == 0 ? none : 0.02f * static_cast<float>(p)});
            }
            set(world, bodies[i], 0, targets);
        }
        world.step(frame);
    }

    World world;
    gphys_model_id runner = 0;
    std::vector<gphys_body_id> bodies;
    std::vector<std::vector<gphys_vec3>> first;
    int count = 0;
};

}  // namespace

TEST_CASE("Targets: the same bits for any number of workers, and from a snapshot on") {
    Party party(1), shared(4);
    for (int i = 0; i < 40; ++i) {
        party.step();
        shared.step();
        REQUIRE(hash(party.world.solver) == hash(shared.world.solver));
    }
    for (const gphys_body_id body : party.bodies) CHECK(all_finite(party.world.positions(body)));
    Party other(1);
    other.count = party.count;
    REQUIRE(restore(other.world.solver, snapshot(party.world.solver)) == GPHYS_OK);
    const gphys_transform place{{0, 0, 0.04f * 39}, {0, 0, 0, 1}, 1};
    REQUIRE(gphys_scene_set_transform(other.world.scene, other.runner, &place) == GPHYS_OK);
    for (int i = 0; i < 10; ++i) {
        CHECK(hash(party.world.solver) == hash(other.world.solver));
        CHECK(snapshot(party.world.solver) == snapshot(other.world.solver));
        party.step();
        other.step();
    }
}

TEST_CASE("A snapshot with made-up targets is refused") {
    World world(8);
    const gphys_body_id ball = world.particles({{0, 0, 0}, {1, 0, 0}});
    const Words without = snapshot(world.solver);
    set(world, ball, 0, {{{0.5f, 0, 0}, {0, 1, 0}, 1, 1}, within({0.5f, 0, 0}, 2)});
    const Words good = snapshot(world.solver);
    // A slot, a length, two targets.
    const size_t at = without.size();
    REQUIRE(good.size() == at + 2 + 2 * 30);
    CHECK(restore(world.solver, good) == GPHYS_OK);
    uint32_t refused = 0;
    for (size_t word = at; word < good.size(); ++word) {
        for (const uint32_t value : {0xffffffffu, 0x7ff80000u, 0xfff00000u, 7u}) {
            const gphys_status status = restore(world.solver, forged(good, word, value));
            CHECK((status == GPHYS_OK || status == GPHYS_ERROR_INVALID_ARGUMENT));
            refused += status != GPHYS_OK;
            if (status == GPHYS_OK) world.step(frame);
            CHECK(all_finite(world.positions(ball)));
        }
    }
    CHECK(refused >= 2 + 4 + 2 * (2 + 8));
    CHECK(restore(world.solver, forged(good, at, 1)) == GPHYS_ERROR_INVALID_ARGUMENT);      // no such body
    CHECK(restore(world.solver, forged(good, at + 1, 1)) == GPHYS_ERROR_INVALID_ARGUMENT);  // too few
}

TEST_CASE("Without any bounds there are no targets") {
    World world(8);
    const gphys_body_id ball = world.particles({{0, 0, 0}, {1, 0, 0}});
    const uint64_t before = hash(world.solver);
    set(world, ball, 0, {within({3, 0, 0}, none)});
    CHECK(hash(world.solver) == before);
    CHECK(target_of(world, ball, 0).max_distance == none);
    set(world, ball, 1, {{{0.1f, 0.2f, 0.3f}, {0, 0.7f, 0.8f}, 0.4f, 0.5f}});
    const gphys_animation_target target = target_of(world, ball, 1);
    CHECK((target.position.z == 0.3f && target.normal.z == 0.8f && target.max_distance == 0.4f &&
           target.backstop == 0.5f));
    CHECK(target_of(world, ball, 0).max_distance == none);
    set(world, ball, 0, {within({3, 0, 0}, none), within({3, 0, 0}, none)});
    CHECK(hash(world.solver) == before);
}
