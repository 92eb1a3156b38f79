// Bodies that come and go beside many others, as in effects.
#include <algorithm>
#include <cstring>
#include <deque>

#include "scene_fixture.h"
#include "snapshots.h"
#include "solver_world.h"

using namespace test;

namespace {

std::vector<gphys_impulse> impulses(const gphys_solver* solver) {
    std::vector<gphys_impulse> out(100);
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_impulses(solver, out.data(), 100, &total) == GPHYS_OK);
    out.resize(total);
    return out;
}

}  // namespace

TEST_CASE("a body that is added takes memory for itself only, and for its slot in the tables") {
    CountedMemory memory;
    const gphys_allocator hooks = memory.hooks();
    gphys_solver_desc desc = World::desc();
    desc.allocator = &hooks;
    World world(desc);
    const std::vector<gphys_vec3> places = line({0, 0, 0}, {0, 0.1f, 0}, 100);
    size_t before = memory.taken_bytes;
    std::deque<gphys_body_id> living{world.particles(places)};
    const size_t own = memory.taken_bytes - before;
    constexpr size_t others = 3000, slots = others + 3000;
    for (size_t i = 0; i < others; ++i) world.particles({places[0]});
    size_t most = 0;
    for (size_t i = others; i < slots; ++i) {
        before = memory.taken_bytes;
        living.push_back(world.particles(places));
        most = std::max(most, memory.taken_bytes - before);
        if (living.size() <= 10) continue;
        before = memory.taken_bytes;
        REQUIRE(gphys_solver_remove_body(world.solver, living.front()) == GPHYS_OK);
        REQUIRE(memory.taken_bytes == before);
        living.pop_front();
    }
    figure("own memory of a body", static_cast<double>(own), "bytes");
    figure("most that an addition took", static_cast<double>(most), "bytes");
    // A table that grows by an eighth: an address and an id for each slot.
    CHECK(most <= own + (sizeof(void*) + sizeof(uint32_t)) * (slots + slots / 8));
}

TEST_CASE("a removed body's impulses leave the sums as if it had never been there") {
    World world, again;
    const gphys_plane plane{{0, 1, 0}, 0};
    const gphys_sphere posts[] = {{{0, 0.5f, 0}, 0.5f}, {{3, 0.5f, 0}, 0.5f}};
    world.model(GPHYS_SHAPE_PLANE, &plane);
    for (const gphys_sphere& post : posts) world.model(GPHYS_SHAPE_SPHERE, &post);
    std::vector<gphys_body_id> bodies;
    for (int i = 0; i < 5; ++i) {
        const float z = 0.03f * static_cast<float>(i);
        bodies.push_back(world.rope(line({-1, 1.03f, z}, {0.1f, 0, 0}, 20), 0));
        bodies.push_back(world.particles(line({-1, 0.0101f, z + 1}, {0.1f, 0, 0}, 20)));
    }
    bodies.push_back(world.particles({{3, 1.02f, 0}}));  // alone on the second post
    for (int i = 0; i < 20; ++i) world.step(1 / 60.0f);
    REQUIRE(impulses(world.solver).size() == 3);
    Random random(6);
    for (size_t left = bodies.size(); left > 0; --left) {
        const size_t gone = left == bodies.size() ? left - 1 : random.index(static_cast<uint32_t>(left));
        REQUIRE(gphys_solver_remove_body(world.solver, bodies[gone]) == GPHYS_OK);
        std::swap(bodies[gone], bodies[left - 1]);
        // A restored solver sums those of the bodies that are left.
        REQUIRE(restore(again.solver, snapshot(world.solver)) == GPHYS_OK);
        const std::vector<gphys_impulse> now = impulses(world.solver), sums = impulses(again.solver);
        CAPTURE(left);
        REQUIRE(now.size() == sums.size());
        for (size_t i = 0; i < now.size(); ++i) REQUIRE(std::memcmp(&now[i], &sums[i], sizeof now[i]) == 0);
        REQUIRE(now.size() <= 2);
    }
    CHECK(impulses(world.solver).empty());
}
