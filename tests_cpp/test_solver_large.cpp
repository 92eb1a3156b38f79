// Work inside one large body is shared by the workers: with the same bits for any number of them.
#include <array>

#include "foundation/team.h"
#include "foundation/workers.h"
#include "solver/cloth/cloth_shares.h"
#include "solver_world.h"

using namespace gphys;
using test::World;

namespace {

using Hash = std::array<uint32_t, 2>;

/// A sheet of n x n falls on a box and hangs from a corner; another body moves beside it.
Hash drape(uint32_t workers, uint32_t n, const gphys_task_runner* runner = nullptr) {
    gphys_solver_desc settings = World::desc();
    settings.worker_count = workers;
    settings.task_runner = runner;
    World world(settings);
    const gphys_aabb box{{0.3f, -0.5f, 0.3f}, {0.9f, -0.02f, 0.9f}};
    world.model(GPHYS_SHAPE_AABB, &box);
    gphys_body_desc desc = World::body_desc();
    desc.cloth_flags = GPHYS_CLOTH_SHEAR | GPHYS_CLOTH_BEND;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1.5f, 0, 0}, {0, 0, 1.5f}, n, n, desc);
    world.pin(sheet, 0);
    world.rope({{5, 0, 0}, {5, 1, 0}, {6, 1, 0}}, 0);
    for (int i = 0; i < 6; ++i) world.step(1.0f / 60);
    REQUIRE(test::all_finite(world.positions(sheet)));
    CHECK(world.stats(sheet).contact_count > 0);
    Hash hash{};
    REQUIRE(gphys_solver_get_hash(world.solver, hash.data()) == GPHYS_OK);
    return hash;
}

/// A host whose only thread does one task after the other, the last one first.
const gphys_task_runner backwards{[](void*, gphys_task task, void* context, uint32_t count) {
                                      for (uint32_t i = count; i-- > 0;) task(context, i);
                                  },
                                  nullptr};

/// 40 000 particles, which are shared in three parts, rain on boxes, one of which moves; one particle hangs on it.
Hash rain(uint32_t workers, const gphys_task_runner* runner = nullptr) {
    gphys_solver_desc settings = World::desc(3);
    settings.worker_count = workers;
    settings.task_runner = runner;
    World world(settings);
    const gphys_aabb ground{{-20, -1, -20}, {20, 0, 20}}, block{{-1, 0, -1}, {1, 0.7f, 1}};
    world.model(GPHYS_SHAPE_AABB, &ground);
    gphys_transform at{{0, 0, 0}, {0, 0, 0, 1}, 1};
    const gphys_model_id moving = world.model(GPHYS_SHAPE_AABB, &block, &at);
    test::Random random(3);
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i < 40000; ++i) {
        points.push_back({random.uniform_float(-4, 4), random.uniform_float(0.8f, 1.2f), random.uniform_float(-4, 4)});
    }
    gphys_body_desc desc = test::point_mass(0.01f, 0.4f, 0);
    desc.static_friction = 0.6f;
    const gphys_body_id body = world.particles(points, desc);
    const gphys_vec3 local{0, 0.9f, 0};
    REQUIRE(gphys_solver_attach(world.solver, world.scene, body, 20000, moving, &local) == GPHYS_OK);
    double upward = 0, worst = 0;  // momentum of the kilogram that all have together
    for (int i = 0; i < 90; ++i) {
        if (i < 60) at.position.x = 0.01f * static_cast<float>(i);
        REQUIRE(gphys_scene_set_transform(world.scene, moving, &at) == GPHYS_OK);
        world.step(1.0f / 60);
        gphys_impulse impulses[4];
        uint32_t count = 0;
        REQUIRE(gphys_solver_get_impulses(world.solver, impulses, 4, &count) == GPHYS_OK);
        double expected = 9.81 / 60 - upward;
        upward = 0;
        for (const gphys_vec3& v : world.velocities(body)) upward += v.y / 40000.0;
        expected += upward;
        for (uint32_t k = 0; k < count; ++k) expected += impulses[k].linear.y;
        worst = std::max(worst, std::fabs(expected));
    }
    test::figure("momentum that models do not get", worst, "N s");
    CHECK(worst < 1e-6);  // the rounding of the sums to float32, of 1.5 N s at most
    Hash hash{};
    REQUIRE(gphys_solver_get_hash(world.solver, hash.data()) == GPHYS_OK);
    return hash;
}

/// 2500 balls of two bodies, whose contacts are in groups: they fall into a pit, or fly through each other's places
/// without gravity. Returns the hash at the end.
Hash balls(uint32_t workers, bool fall, const gphys_task_runner* runner = nullptr) {
    gphys_solver_desc settings = World::desc();
    settings.worker_count = workers;
    settings.task_runner = runner;
    if (!fall) settings.gravity = {0, 0, 0};
    World world(settings);
    constexpr float wide = 0.75f, radius = 0.05f;
    if (fall) {
        for (const gphys_plane& plane :
             {gphys_plane{{0, 1, 0}, 0}, gphys_plane{{1, 0, 0}, -wide}, gphys_plane{{-1, 0, 0}, -wide},
              gphys_plane{{0, 0, 1}, -wide}, gphys_plane{{0, 0, -1}, -wide}}) {
            world.model(GPHYS_SHAPE_PLANE, &plane);
        }
    }
    gphys_body_desc desc = World::body_desc();
    desc.radius = radius;
    desc.friction = 0.3f;
    desc.self_collision = 1;
    desc.body_layers = 1;
    test::Random random(4);
    std::vector<gphys_vec3> points[2];
    for (uint32_t i = 0; i < 2500; ++i) {
        const auto at = [&](uint32_t cell) {
            return (static_cast<float>(cell) - 4.5f) * 0.14f + random.uniform_float(-0.01f, 0.01f);
        };
        const float x = at(i % 10), z = at(i / 10 % 10);
        points[i % 5 < 3].push_back({x, 0.1f + 0.14f * static_cast<float>(i / 100), z});
    }
    const gphys_body_id bodies[2]{world.particles(points[0], desc), world.particles(points[1], desc)};
    const auto momentum = [&] {
        Vec3 sum;
        for (int b = 0; b < 2; ++b) {
            for (const gphys_vec3& v : world.velocities(bodies[b]))
                sum += widen(v) * (desc.mass / static_cast<double>(points[b].size()));
        }
        return sum;
    };
    if (!fall) {
        for (int b = 0; b < 2; ++b) {
            std::vector<gphys_vec3> velocities;
            for (const gphys_vec3& at : points[b]) {
                velocities.push_back({-3 * at.x + random.uniform_float(-1, 1), 3 * (1.75f - at.y), -3 * at.z});
            }
            REQUIRE(gphys_solver_set_velocities(world.solver, bodies[b], 0, static_cast<uint32_t>(points[b].size()),
                                                velocities.data(), sizeof velocities[0]) == GPHYS_OK);
        }
    }
    const Vec3 before = momentum();
    double nearest = 1;
    uint32_t outside = 0;
    for (int i = 0; i < 40; ++i) {
        world.step(1.0f / 60);
        if (i % 10 != 9) continue;
        std::vector<gphys_vec3> all = world.positions(bodies[0]);
        const std::vector<gphys_vec3> others = world.positions(bodies[1]);
        all.insert(all.end(), others.begin(), others.end());
        std::sort(all.begin(), all.end(), [](const gphys_vec3& a, const gphys_vec3& b) { return a.x < b.x; });
        for (size_t a = 0; a < all.size(); ++a) {
            for (size_t b = a + 1; b < all.size() && all[b].x - all[a].x < 2 * radius; ++b)
                nearest = std::min(nearest, distance(widen(all[a]), widen(all[b])) / double{2 * radius});
            if (fall) outside += all[a].y < 0 || std::max(std::fabs(all[a].x), std::fabs(all[a].z)) > wide;
        }
    }
    test::figure(fall ? "nearest balls of a pile" : "nearest balls in the air", nearest, "diameters");
    CHECK(nearest > 0.85);
    CHECK(outside == 0);
    // Rounding to float32 of 2500 velocities of at most 16 m/s, with masses that add up to 2 kg.
    if (!fall) CHECK(length(momentum() - before) < 2 * 16 * 0x1p-24);
    Hash hash{};
    REQUIRE(gphys_solver_get_hash(world.solver, hash.data()) == GPHYS_OK);
    return hash;
}

}  // namespace

TEST_CASE("a large cloth has the same bits whoever shares its work", "[simulation]") {
    constexpr uint32_t n = 85;  // 42 500 links, of which 20 000 are enough to be shared
    const Hash alone = drape(1, n);
    CHECK(drape(2, n) == alone);
    CHECK(drape(5, n) == alone);
    CHECK(drape(3, n, &backwards) == alone);
}

TEST_CASE("free particles of a large body have the same bits, and press as much, whoever shares their work",
          "[simulation]") {
    const Hash alone = rain(1);
    CHECK(rain(2) == alone);
    CHECK(rain(5) == alone);
    CHECK(rain(3, &backwards) == alone);
}

TEST_CASE("many balls have the same bits whoever shares the work on their contacts", "[simulation]") {
    const bool fall = GENERATE(true, false);
    const Hash alone = balls(1, fall);
    CHECK(balls(2, fall) == alone);
    CHECK(balls(5, fall) == alone);
    CHECK(balls(3, fall, &backwards) == alone);
}

TEST_CASE("work is shared while that takes less time, also while it grows") {
    SharingTrial trial;
    double alone = 1e-3;
    const auto shared_steps_of = [&](uint32_t steps, double part, double growth) {
        uint32_t shared_steps = 0;
        for (uint32_t i = 0; i < steps; ++i, alone *= growth) {
            const bool is_shared = trial.is_shared();
            shared_steps += is_shared;
            trial.add(is_shared, is_shared ? part * alone : alone);
        }
        return shared_steps;
    };
    CHECK(shared_steps_of(1, 1000, 1) == 1);  // the first step counts for nothing
    CHECK(shared_steps_of(640, 0.6, 1) == 620);
    CHECK(shared_steps_of(640, 1.3, 1.01) == 20);
    CHECK(shared_steps_of(640, 0.8, 1 / 1.01) == 620);
}

TEST_CASE("a team does each task of each phase once, and one phase after the other") {
    const Workers workers(4, nullptr, std::pmr::new_delete_resource());
    for (int round = 0; round < 50; ++round) {
        Team team;
        constexpr uint32_t phases = 40, most = 37;
        std::vector<std::atomic<uint32_t>> done(phases * most);
        std::atomic<bool> in_order{true};
        workers.run(workers.count(), [&](uint32_t) {
            team.join([&] {
                for (uint32_t phase = 0; phase < phases; ++phase) {
                    const uint32_t count = phase % most;
                    team.share(count, [&](uint32_t i, uint32_t member) {
                        if (member >= workers.count()) in_order = false;
                        for (uint32_t k = 0; phase > 0 && k < (phase - 1) % most; ++k) {
                            if (done[(phase - 1) * most + k] != 1) in_order = false;
                        }
                        ++done[phase * most + i];
                    });
                }
            });
        });
        REQUIRE(in_order);
        for (uint32_t phase = 0; phase < phases; ++phase) {
            for (uint32_t i = 0; i < most; ++i) REQUIRE(done[phase * most + i] == (i < phase % most ? 1 : 0));
        }
    }
}
