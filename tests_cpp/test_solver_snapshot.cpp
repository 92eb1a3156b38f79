// Snapshots: what is put back goes on with the same bits, and what is no snapshot is refused.
#include "snapshots.h"

using test::forged;
using test::hash;
using test::snapshot;
using test::Words;
using test::World;

namespace {

/// A body of each kind among moving models, with holes among the ids, cut and added constraints.
struct Busy : World {
    gphys_model_id carrier = 0, hammer = 0;
    gphys_body_id rope = 0, cloth = 0;
    gphys_constraint_id rope_link = 0;
    int frame = 0;

    Busy() : World(4) {
        const gphys_plane floor{{0, 1, 0}, 0};
        const gphys_sphere ball{{0.5f, 0.4f, 0.5f}, 0.35f};
        const gphys_aabb box{{-0.1f, -0.1f, -0.1f}, {0.1f, 0.1f, 0.1f}};
        model(GPHYS_SHAPE_PLANE, &floor);
        model(GPHYS_SHAPE_SPHERE, &ball);
        carrier = model(GPHYS_SHAPE_AABB, &box);
        hammer = model(GPHYS_SHAPE_AABB, &box);
        move_models();
        gphys_body_desc bouncing = body_desc();
        bouncing.restitution = 0.7f;
        bouncing.self_collision = 1;
        const gphys_body_id gone = particles({{9, 9, 9}});
        particles({{0, 1, 0}, {0.5f, 2, 0.5f}, {0.2f, 1.5f, 0.1f}}, bouncing);
        REQUIRE(gphys_solver_remove_body(solver, gone) == GPHYS_OK);
        std::vector<gphys_vec3> points;
        for (int i = 0; i < 20; ++i) points.push_back({-0.5f + 0.05f * static_cast<float>(i), 1.2f, 0.2f});
        rope = World::rope(points, 0);
        REQUIRE(gphys_solver_attach(solver, scene, rope, 0, carrier, nullptr) == GPHYS_OK);
        REQUIRE(gphys_solver_add_distance(solver, rope, 3, 4, -1, 1e-4f, &rope_link) == GPHYS_OK);
        for (gphys_vec3& point : points) point.y += 3;
        const gphys_body_id whip = World::rope(points, 0.06f);  // in the air, solved directly
        pin(whip, 0);
        const gphys_body_id sheet = World::cloth({3, 3, 3}, {1, 0, 0}, {0, 0, 1}, 5, 5);
        pin(sheet, 4);
        // Something hangs from both.
        for (gphys_vec3& point : points) point.x += 0.95f;
        const gphys_body_id tail = World::rope(points, 0);
        gphys_joint_id joint = 0, removed = 0;
        REQUIRE(gphys_solver_join(solver, whip, 19, tail, 0, 0, 0, &removed) == GPHYS_OK);
        REQUIRE(gphys_solver_join(solver, whip, 19, tail, 0, 0, 0, &joint) == GPHYS_OK);
        REQUIRE(gphys_solver_unjoin(solver, removed) == GPHYS_OK);
        REQUIRE(gphys_solver_join(solver, particles({{3, 2.5f, 3}}), 0, sheet, 0, -1, 1e-5f, &joint) == GPHYS_OK);
        cloth = World::cloth({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 9, 7);
        pin(cloth, 0);
        gphys_constraint_info first{};
        uint32_t total = 0;
        REQUIRE(gphys_solver_get_constraints(solver, cloth, &first, 1, &total) == GPHYS_INCOMPLETE);
        REQUIRE(gphys_solver_remove_constraint(solver, cloth, first.id) == GPHYS_OK);
    }

    void move_models() {
        const float t = static_cast<float>(frame) / 60;
        const gphys_transform places[] = {{{-0.5f + 0.2f * t, 1.2f, 0.2f}, {0, 0, 0, 1}, 1},
                                          {{2 - 2 * t, 0.1f, 0.3f}, {0, 0, 0, 1}, 1}};
        const gphys_model_id models[] = {carrier, hammer};
        REQUIRE(gphys_scene_set_transforms(scene, models, places, sizeof places[0], 2) == GPHYS_OK);
    }
    void run(int frames) {
        for (int i = 0; i < frames; ++i) {
            ++frame;
            move_models();
            step(1.0f / 60);
        }
    }
    void back_to(int earlier) {
        frame = earlier;
        move_models();
    }
};

}  // namespace

TEST_CASE("steps after a restore have the bits that they had after the snapshot") {
    Busy world;
    world.run(60);
    CHECK(world.stats().contact_count > 0);
    const Words middle = snapshot(world.solver);
    const uint64_t at_middle = hash(world.solver);
    std::vector<uint64_t> hashes;
    for (int i = 0; i < 60; ++i) {
        world.run(1);
        hashes.push_back(hash(world.solver));
        CHECK(hashes.back() != at_middle);
    }
    const std::vector<gphys_vec3> cloth = world.positions(world.cloth);

    REQUIRE(gphys_solver_restore(world.solver, middle.data(), static_cast<uint32_t>(middle.size())) == GPHYS_OK);
    world.back_to(60);
    CHECK(hash(world.solver) == at_middle);
    CHECK(snapshot(world.solver) == middle);
    for (int i = 0; i < 60; ++i) {
        world.run(1);
        CHECK(hash(world.solver) == hashes[static_cast<size_t>(i)]);
    }
    CHECK(std::memcmp(cloth.data(), world.positions(world.cloth).data(), cloth.size() * sizeof cloth[0]) == 0);
}

TEST_CASE("a snapshot makes another solver the same, ids and settings included") {
    Busy world;
    const gphys_vec3 gravity{0, -5, 1};
    REQUIRE(gphys_solver_set_gravity(world.solver, &gravity) == GPHYS_OK);
    world.run(30);
    const double origin[3] = {1000, 0, -0.1};
    REQUIRE(gphys_solver_set_origin(world.solver, origin) == GPHYS_OK);
    REQUIRE(gphys_scene_set_origin(world.scene, origin) == GPHYS_OK);
    const Words middle = snapshot(world.solver);
    gphys_solver* other = nullptr;
    REQUIRE(gphys_solver_create(nullptr, &other) == GPHYS_OK);
    REQUIRE(gphys_solver_restore(other, middle.data(), static_cast<uint32_t>(middle.size())) == GPHYS_OK);
    for (int i = 0; i < 60; ++i) {
        REQUIRE(gphys_solver_step(other, world.scene, 1.0f / 60) == GPHYS_OK);
        REQUIRE(gphys_solver_step(world.solver, world.scene, 1.0f / 60) == GPHYS_OK);
        CHECK(hash(other) == hash(world.solver));
    }
    // What the ids say and what comes of changes is the same, too.
    CHECK(gphys_solver_remove_constraint(other, world.rope, world.rope_link) == GPHYS_OK);
    CHECK(gphys_solver_remove_constraint(world.solver, world.rope, world.rope_link) == GPHYS_OK);
    const gphys_vec3 points[2] = {{0, 0, 0}, {0, 0, 0}};
    gphys_body_id here = 0, there = 1;
    REQUIRE(gphys_solver_add_particles(world.solver, nullptr, points, 12, 2, &here) == GPHYS_OK);
    REQUIRE(gphys_solver_add_particles(other, nullptr, points, 12, 2, &there) == GPHYS_OK);
    CHECK(here == there);
    REQUIRE(gphys_solver_step(other, nullptr, 0.01f) == GPHYS_OK);
    REQUIRE(gphys_solver_step(world.solver, nullptr, 0.01f) == GPHYS_OK);
    CHECK(hash(other) == hash(world.solver));
    gphys_solver_destroy(other);
}

TEST_CASE("cloth that was planned in another shape goes on with the same chains") {
    // The chains of a mesh-like graph follow its straight lines: bent, it would be planned otherwise.
    World world;
    const gphys_body_id cloth = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 10, 10);
    for (const uint32_t corner : {0u, 9u}) world.pin(cloth, corner);
    for (int i = 0; i < 90; ++i) world.step(1.0f / 60);
    const Words bent = snapshot(world.solver);
    for (int i = 0; i < 30; ++i) world.step(1.0f / 60);
    const uint64_t wanted = hash(world.solver);
    World other;
    REQUIRE(gphys_solver_restore(other.solver, bent.data(), static_cast<uint32_t>(bent.size())) == GPHYS_OK);
    for (int i = 0; i < 30; ++i) other.step(1.0f / 60);
    CHECK(hash(other.solver) == wanted);
}

TEST_CASE("the hash tells states apart that differ in any one thing") {
    World world;
    const gphys_body_id body = world.rope({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0);
    std::vector<uint64_t> seen{hash(world.solver)};
    const auto differs = [&] {
        seen.push_back(hash(world.solver));
        return std::find(seen.begin(), seen.end() - 1, seen.back()) == seen.end() - 1;
    };
    const gphys_vec3 vector{0.5f, 0, 0};
    const float amount = 0.25f;
    const double origin[3] = {1, 0, 0};
    gphys_constraint_id link = 0;
    gphys_solver_set_positions(world.solver, body, 2, 1, &vector, 0);
    CHECK(differs());
    gphys_solver_set_velocities(world.solver, body, 1, 1, &vector, 0);
    CHECK(differs());
    gphys_solver_set_forces(world.solver, body, 0, 1, &vector, 0);
    CHECK(differs());
    gphys_solver_set_masses(world.solver, body, 0, 1, &amount, 0);
    CHECK(differs());
    gphys_solver_set_radii(world.solver, body, 0, 1, &amount, 0);
    CHECK(differs());
    gphys_solver_set_pinned(world.solver, body, 0, 1, 1);
    CHECK(differs());
    gphys_solver_add_distance(world.solver, body, 0, 2, -1, 0, &link);
    CHECK(differs());
    gphys_solver_set_substeps(world.solver, 3);
    CHECK(differs());
    gphys_solver_set_origin(world.solver, origin);
    CHECK(differs());
    gphys_solver_advance(world.solver, nullptr, 0.001f, nullptr, nullptr);
    CHECK(differs());
    CHECK(hash(world.solver) == hash(world.solver));
}

TEST_CASE("what is no snapshot is refused and changes nothing") {
    Busy world;
    world.run(20);
    const Words good = snapshot(world.solver);
    world.run(1);
    const uint64_t before = hash(world.solver);
    const auto refused = [&](const Words& words) {
        return gphys_solver_restore(world.solver, words.data(), static_cast<uint32_t>(words.size())) ==
                   GPHYS_ERROR_INVALID_ARGUMENT &&
               hash(world.solver) == before;
    };
    test::Random random(5);
    for (int i = 0; i < 300; ++i) {
        Words damaged = good;
        damaged[i < 5 ? static_cast<size_t>(i) : random.index(static_cast<uint32_t>(good.size()))] ^=
            1u << random.index(32);
        REQUIRE(refused(damaged));
    }
    for (const size_t size : {size_t{0}, size_t{1}, size_t{4}, size_t{5}, good.size() - 1}) {
        REQUIRE(refused(Words(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size))));
    }
    Words longer = good, other_order = good;
    longer.push_back(0);
    REQUIRE(refused(longer));
    for (uint32_t& w : other_order) w = w >> 24 | (w >> 8 & 0xff00) | (w << 8 & 0xff0000) | w << 24;
    REQUIRE(refused(other_order));
    CHECK(std::string(gphys_last_error()).find("byte order") != std::string::npos);
    CHECK(gphys_solver_restore(world.solver, nullptr, 0) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(hash(world.solver) == before);
}

TEST_CASE("a forged snapshot is refused or taken, and never reaches past an array") {
    Busy world;
    world.run(20);
    const Words good = snapshot(world.solver);
    test::Random random(6);
    const uint32_t values[] = {0, 1, 2, 7, 0xff, 0xffffff, 0x1000000, 0x7fffffff, 0x80000000, 0x7ff80000, 0xffffffff};
    int taken = 0, refused = 0;
    for (int i = 0; i < test::tries(3000); ++i) {
        const size_t at = 5 + random.index(static_cast<uint32_t>(good.size()) - 5);
        const Words words = forged(good, at, values[random.index(sizeof values / sizeof values[0])]);
        const gphys_status status =
            gphys_solver_restore(world.solver, words.data(), static_cast<uint32_t>(words.size()));
        REQUIRE((status == GPHYS_OK || status == GPHYS_ERROR_INVALID_ARGUMENT));
        ++(status == GPHYS_OK ? taken : refused);
        // A forged origin may not be the scene's.
        if (status == GPHYS_OK && gphys_solver_step(world.solver, world.scene, 0.01f) != GPHYS_OK) {
            REQUIRE(gphys_solver_step(world.solver, nullptr, 0.01f) == GPHYS_OK);
        }
    }
    CHECK(taken > 100);
    CHECK(refused > 100);
}
