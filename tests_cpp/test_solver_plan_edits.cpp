// Constraints that come and go in cloth: its plan is changed beside them, not made again.
#include "c_api/handles.h"
#include "scene_fixture.h"
#include "snapshots.h"
#include "solver/solver.h"

using namespace gphys;
using test::hash;
using test::Random;
using test::snapshot;
using test::Words;
using test::World;

namespace {

std::vector<gphys_constraint_id> constraints_of(const World& world, gphys_body_id body) {
    uint32_t total = 0;
    gphys_solver_get_constraints(world.solver, body, nullptr, 0, &total);
    std::vector<gphys_constraint_info> all(total);
    REQUIRE(gphys_solver_get_constraints(world.solver, body, all.data(), total, &total) == GPHYS_OK);
    std::vector<gphys_constraint_id> ids;
    for (const gphys_constraint_info& constraint : all) ids.push_back(constraint.id);
    return ids;
}

/// A link, or a string, between any two particles.
void add_any(const World& world, gphys_body_id body, uint32_t size, Random& random) {
    const uint32_t a = random.index(size), b = random.index(size);
    if (a == b) return;
    gphys_constraint_id added = 0;
    const float compliance = random.index(2) == 0 ? 0.0f : 0.01f;
    const auto add = random.index(4) == 0 ? gphys_solver_add_max_distance : gphys_solver_add_distance;
    REQUIRE(add(world.solver, body, a, b, -1, compliance, &added) == GPHYS_OK);
}

void edit(const World& world, gphys_body_id body, uint32_t size, Random& random) {
    const std::vector<gphys_constraint_id> ids = constraints_of(world, body);
    if (ids.empty() || random.index(2) == 0) return add_any(world, body, size, random);
    const gphys_constraint_id id = ids[random.index(static_cast<uint32_t>(ids.size()))];
    REQUIRE(gphys_solver_remove_constraint(world.solver, body, id) == GPHYS_OK);
}

/// Whether what has been followed through edits is what would be found all at once.
void check_lists(const World& world, gphys_body_id id) {
    Body& body = unwrap(world.solver)->body(id);
    if (!is_graph(body)) return;
    const auto kinds = [&] {
        std::vector<bool> out;
        for (const KeptLinks::Link& link : body.cloth.relaxation.kept.links) {
            out.push_back(link.brace);
            out.push_back(link.chord);
        }
        return out;
    };
    const std::vector<bool> followed = kinds();
    body.cloth.rigid.kinds.clear();
    if (body.kind == GPHYS_BODY_CLOTH) find_braces(body.cloth.rigid, body.constraints.ids.slots());
    list_kept_links(body.cloth.relaxation.kept, body.cloth.batches, body.cloth.rigid, body.plan, body.particles.size());
    CHECK(kinds() == followed);
}

const Plan& plan_of(const World& world, gphys_body_id body) { return unwrap(world.solver)->body(body).plan; }

}  // namespace

// A snapshot is taken only if each constraint stands in one chain and no colour has a particle twice.
TEST_CASE("cloth with links that come and go has a plan that a snapshot holds, and goes on alike from there") {
    Random random(7);
    for (int round = 0; round < 12; ++round) {
        World world;
        gphys_body_desc desc = World::body_desc();
        desc.cloth_flags = random.index(4);
        desc.self_collision = random.index(2);
        const uint32_t columns = 2 + random.index(10), rows = 2 + random.index(10), size = columns * rows;
        const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, columns, rows, desc);
        world.pin(sheet, 0);
        for (int frame = 0; frame < 40; ++frame) {
            // Now and then more than a plan takes.
            const uint32_t edits = random.index(8) == 0 ? random.index(2 * Plan::most_edits) : random.index(4);
            for (uint32_t i = 0; i < edits; ++i) edit(world, sheet, size, random);
            const Words words = snapshot(world.solver);
            World other;
            REQUIRE(gphys_solver_restore(other.solver, words.data(), static_cast<uint32_t>(words.size())) == GPHYS_OK);
            for (uint32_t i = random.index(2); i < edits; ++i) {
                edit(world, sheet, size, random);
                const Words edited = snapshot(world.solver);
                REQUIRE(gphys_solver_restore(other.solver, edited.data(), static_cast<uint32_t>(edited.size())) ==
                        GPHYS_OK);
            }
            for (const World* each : {&world, &other})
                REQUIRE(gphys_solver_step(each->solver, nullptr, 1.0f / 60) == GPHYS_OK);
            REQUIRE(hash(world.solver) == hash(other.solver));
            check_lists(world, sheet);
        }
    }
}

TEST_CASE("a link that comes or goes leaves the other chains of cloth as they are, up to so many a step") {
    World world;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 20, 20);
    world.pin(sheet, 0);
    world.step(1.0f / 60);
    const size_t chains = plan_of(world, sheet).chains.size(), colours = plan_of(world, sheet).colours.size();
    gphys_constraint_id added = 0;
    REQUIRE(gphys_solver_add_distance(world.solver, sheet, 30, 370, -1, 0.01f, &added) == GPHYS_OK);
    CHECK(plan_of(world, sheet).chains_current);
    CHECK(plan_of(world, sheet).chains.size() == chains + 1);
    REQUIRE(gphys_solver_remove_constraint(world.solver, sheet, added) == GPHYS_OK);
    CHECK(plan_of(world, sheet).chains.size() == chains);
    CHECK(plan_of(world, sheet).colours.size() == colours);
    // In the middle of a row, which parts.
    REQUIRE(gphys_solver_remove_constraint(world.solver, sheet, constraints_of(world, sheet)[190]) == GPHYS_OK);
    CHECK(plan_of(world, sheet).chains.size() == chains + 1);
    CHECK(plan_of(world, sheet).edits == 3);
    world.step(1.0f / 60);
    CHECK(plan_of(world, sheet).edits == 0);
    for (uint32_t i = 0; i <= Plan::most_edits; ++i) {
        CHECK(plan_of(world, sheet).chains_current);
        REQUIRE(gphys_solver_add_distance(world.solver, sheet, i, i + 45, -1, 0.01f, &added) == GPHYS_OK);
    }
    CHECK(!plan_of(world, sheet).chains_current);
}

/// What is left of a sheet without rings is solved as a tree.
TEST_CASE("cloth that is cut down to its threads is planned again as a body without rings") {
    World world;
    gphys_body_desc desc = World::body_desc();
    desc.cloth_flags = 0;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 2, 2, desc);
    world.step(1.0f / 60);
    REQUIRE(plan_of(world, sheet).method == GPHYS_SOLVE_GRAPH);
    REQUIRE(gphys_solver_remove_constraint(world.solver, sheet, constraints_of(world, sheet)[0]) == GPHYS_OK);
    CHECK(!plan_of(world, sheet).chains_current);
    world.step(1.0f / 60);
    CHECK(plan_of(world, sheet).method == GPHYS_SOLVE_DIRECT);
}

TEST_CASE(
    "an edit of cloth for which there is no memory changes nothing, and one that succeeds is the same with little") {
    test::CountedMemory memory;
    const gphys_allocator hooks = memory.hooks();
    gphys_solver_desc desc = World::desc();
    World plenty(desc);
    desc.allocator = &hooks;
    World scarce(desc);
    gphys_body_id sheet = 0;
    for (World* world : {&plenty, &scarce}) {
        sheet = world->cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 8, 8);
        world->pin(sheet, 0);
        world->step(1.0f / 60);
    }
    size_t failures = 0;
    // Each allocation of a call fails once.
    const auto edit_both = [&](auto&& call) {
        REQUIRE(call(plenty.solver) == GPHYS_OK);
        const uint64_t before = hash(scarce.solver);
        for (size_t later = 0;; ++later) {
            memory.failing = memory.allocations + later;
            const gphys_status status = call(scarce.solver);
            memory.failing = SIZE_MAX;
            if (status == GPHYS_OK) break;
            REQUIRE(status == GPHYS_ERROR_OUT_OF_MEMORY);
            REQUIRE(hash(scarce.solver) == before);
            ++failures;
        }
        REQUIRE(hash(scarce.solver) == hash(plenty.solver));
    };
    for (uint32_t i = 0; i < Plan::most_edits / 2; ++i) {
        gphys_constraint_id added = 0;
        edit_both([&](gphys_solver* solver) {
            return gphys_solver_add_distance(solver, sheet, i, 63 - i, -1, i % 2 ? 0 : 0.01f, &added);
        });
        const gphys_constraint_id removed = constraints_of(plenty, sheet)[5 * i];
        edit_both([&](gphys_solver* solver) { return gphys_solver_remove_constraint(solver, sheet, removed); });
    }
    CHECK(failures > 0);
    for (World* world : {&plenty, &scarce}) world->step(1.0f / 60);
    CHECK(hash(scarce.solver) == hash(plenty.solver));
}
