// Bodies that come and go beside many others, and bodies of a single particle: what an effect or a volley consists of.
#include <algorithm>
#include <cstring>
#include <deque>

#include "scene_fixture.h"
#include "snapshots.h"
#include "solver_world.h"

using namespace test;

namespace {

bool same_bits(const gphys_vec3& a, const gphys_vec3& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

std::vector<gphys_impulse> impulses(const gphys_solver* solver) {
    std::vector<gphys_impulse> out(100);
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_impulses(solver, out.data(), 100, &total) == GPHYS_OK);
    out.resize(total);
    return out;
}

/// Points that fall past a box, and some that fly into it.
struct Volley {
    std::vector<gphys_vec3> places, velocities;

    Volley() {
        Random random(5);
        for (int i = 0; i < 43; ++i) {
            places.push_back(random.point(3));
            velocities.push_back(random.point(i % 3 == 0 ? 20 : 2));
        }
    }
    void set(const World& world, gphys_body_id body, uint32_t first) const {
        const uint32_t count = world.stats(body).particle_count;
        REQUIRE(gphys_solver_set_velocities(world.solver, body, 0, count, &velocities[first], 12) == GPHYS_OK);
    }
};

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

TEST_CASE("bodies of any number of particles fly with the same bits") {
    const Volley volley;
    const gphys_aabb box{{-1, -1, -1}, {1, 1, 1}};
    const uint32_t all = static_cast<uint32_t>(volley.places.size());
    for (const int surroundings : {0, 1, 2}) {  // no scene, an empty one, a box
        World whole, parts;
        std::vector<gphys_body_id> bodies;
        for (World* world : {&whole, &parts}) {
            if (surroundings == 2) world->model(GPHYS_SHAPE_AABB, &box);
        }
        gphys_body_desc desc = World::body_desc();
        desc.damping = 0.1f;
        desc.restitution = 0.5f;
        const gphys_body_id together = whole.particles(volley.places, desc);
        volley.set(whole, together, 0);
        std::vector<uint32_t> firsts;
        for (uint32_t first = 0, size = 1; first < all; first += size, size = size % 9 + 1) {
            const auto begin = volley.places.begin() + first, end = begin + std::min(size, all - first);
            firsts.push_back(first);
            bodies.push_back(parts.particles({begin, end}, desc));
            volley.set(parts, bodies.back(), first);
        }
        for (int i = 0; i < 60; ++i) {
            for (World* world : {&whole, &parts}) {
                REQUIRE(gphys_solver_step(world->solver, surroundings > 0 ? world->scene : nullptr, 1 / 60.0f) ==
                        GPHYS_OK);
            }
        }
        const std::vector<gphys_vec3> expected = whole.positions(together);
        for (size_t i = 0; i < bodies.size(); ++i) {
            const std::vector<gphys_vec3> found = parts.positions(bodies[i]);
            for (size_t p = 0; p < found.size(); ++p) {
                CAPTURE(surroundings, i, p);
                REQUIRE(same_bits(found[p], expected[firsts[i] + p]));
            }
        }
    }
}

TEST_CASE("a force takes a particle to models that gravity would not take it to") {
    World world(8, {0, 0, 0});
    const gphys_aabb wall{{5, -1, -1}, {20, 1, 1}};
    world.model(GPHYS_SHAPE_AABB, &wall);
    const gphys_body_id body = world.particles({{0, 0, 0}}, point_mass(0.1f, 0, 0));
    const gphys_vec3 force{80000, 0, 0};  // 11 m in a step
    REQUIRE(gphys_solver_set_forces(world.solver, body, 0, 1, &force, 12) == GPHYS_OK);
    world.step(1 / 60.0f);
    const double x = world.position(body).x;
    CHECK(x > 4.89);
    CHECK(x < 4.9);
}
