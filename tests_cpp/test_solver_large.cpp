// Work inside one large cloth is shared by the workers: with the same bits for any number of them.
#include <array>

#include "foundation/team.h"
#include "foundation/workers.h"
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

}  // namespace

TEST_CASE("a large cloth has the same bits whoever shares its work") {
    constexpr uint32_t n = 161;  // 154 000 links, of which 150 000 are enough to be shared
    const Hash alone = drape(1, n);
    CHECK(drape(2, n) == alone);
    CHECK(drape(5, n) == alone);
    // A host whose only thread does one task after the other, the last one first.
    const gphys_task_runner backwards{[](void*, gphys_task task, void* context, uint32_t count) {
                                          for (uint32_t i = count; i-- > 0;) task(context, i);
                                      },
                                      nullptr};
    CHECK(drape(3, n, &backwards) == alone);
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
