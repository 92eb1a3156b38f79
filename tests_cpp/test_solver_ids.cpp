// Ids of bodies, constraints and joints name nothing else for a long time after what they named has gone.
#include <algorithm>

#include "scene_fixture.h"
#include "solver_world.h"

namespace {

constexpr int many = 100000;

gphys_status has(const gphys_solver* solver, gphys_body_id body) {
    uint32_t count = 0;
    return gphys_solver_get_substeps(solver, body, &count);
}

/// A solver whose memory is counted.
struct Counted {
    test::CountedMemory memory;
    const gphys_allocator hooks = memory.hooks();
    test::World world{desc()};

    size_t bytes() const { return memory.live_bytes; }
    gphys_solver_desc desc() const {
        gphys_solver_desc desc = test::World::desc();
        desc.allocator = &hooks;
        return desc;
    }
};

/// remove(id), then add(id) and is_stale(first): 100 000 times, after which no more memory is held than at the start.
template <class Add, class Remove, class IsStale>
void come_and_go(const Counted& counted, const Add& add, const Remove& remove, const IsStale& is_stale) {
    uint32_t first = 0, id = 0;
    REQUIRE(add(first) == GPHYS_OK);
    REQUIRE(remove(first) == GPHYS_OK);
    bool stale = true, works = true;
    size_t early_bytes = 0;
    for (int additions = 0; additions < many; ++additions) {
        works &= add(id) == GPHYS_OK;
        stale &= is_stale(first);
        works &= remove(id) == GPHYS_OK;
        if (additions == 2000) early_bytes = counted.bytes();
    }
    CHECK(works);
    CHECK(stale);
    CHECK(counted.bytes() == early_bytes);
}

}  // namespace

TEST_CASE("a removed body's id names no other for 100 000 additions") {
    Counted counted;
    gphys_solver* const solver = counted.world.solver;
    const gphys_vec3 place{0, 1, 0};
    for (int i = 0; i < 10; ++i) counted.world.particles({place});
    const gphys_body_desc desc = test::World::body_desc();
    come_and_go(
        counted, [&](uint32_t& id) { return gphys_solver_add_particles(solver, &desc, &place, 12, 1, &id); },
        [&](uint32_t id) { return gphys_solver_remove_body(solver, id); },
        [&](uint32_t id) { return has(solver, id) == GPHYS_ERROR_INVALID_ID; });
    counted.world.step(0.01f);
}

TEST_CASE("a removed constraint's id names no other for 100 000 additions") {
    Counted counted;
    gphys_solver* const solver = counted.world.solver;
    const gphys_body_id body = counted.world.rope({{0, 1, 0}, {1, 1, 0}, {2, 1, 0}}, 0);
    come_and_go(
        counted, [&](uint32_t& id) { return gphys_solver_add_distance(solver, body, 0, 2, -1, 0, &id); },
        [&](uint32_t id) { return gphys_solver_remove_constraint(solver, body, id); },
        [&](uint32_t id) {
            return gphys_solver_set_constraint_damping(solver, body, id, 1) == GPHYS_ERROR_INVALID_ID;
        });
    counted.world.step(0.01f);
}

TEST_CASE("a removed joint's id names no other for 100 000 additions") {
    Counted counted;
    gphys_solver* const solver = counted.world.solver;
    const gphys_body_id a = counted.world.particles({{0, 1, 0}}), b = counted.world.particles({{1, 1, 0}});
    come_and_go(
        counted, [&](uint32_t& id) { return gphys_solver_join(solver, a, 0, b, 0, -1, 0, &id); },
        [&](uint32_t id) { return gphys_solver_unjoin(solver, id); },
        // To remove what is not there changes nothing.
        [&](uint32_t id) { return gphys_solver_unjoin(solver, id) == GPHYS_ERROR_INVALID_ID; });
    counted.world.step(0.01f);
}

TEST_CASE("ids go on after a restore as they would have gone on without") {
    test::World world;
    gphys_solver* const solver = world.solver;
    const gphys_vec3 place{0, 1, 0};
    const gphys_body_id kept = world.particles({place}), gone = world.particles({place});
    REQUIRE(gphys_solver_remove_body(solver, gone) == GPHYS_OK);
    const auto next_ids = [&] {
        std::vector<gphys_body_id> ids;
        for (int i = 0; i < 1500; ++i) {
            ids.push_back(world.particles({place}));
            REQUIRE(gphys_solver_remove_body(solver, ids.back()) == GPHYS_OK);
        }
        return ids;
    };
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_snapshot(solver, nullptr, 0, &total) == GPHYS_INCOMPLETE);
    std::vector<uint32_t> words(total);
    REQUIRE(gphys_solver_get_snapshot(solver, words.data(), total, &total) == GPHYS_OK);
    const std::vector<gphys_body_id> before = next_ids();
    REQUIRE(gphys_solver_restore(solver, words.data(), total) == GPHYS_OK);
    CHECK(has(solver, kept) == GPHYS_OK);
    CHECK(has(solver, gone) == GPHYS_ERROR_INVALID_ID);
    CHECK(next_ids() == before);
    CHECK(std::find(before.begin(), before.end(), gone) == before.end());
}
