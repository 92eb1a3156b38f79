// Constraints that break and cloth that tears: loads against the laws of statics and momentum, the surface and the
// constraints after any tears, and what belongs to the particles.
#include <algorithm>
#include <cstring>
#include <map>
#include <set>

#include "c_api/handles.h"
#include "scene_fixture.h"
#include "snapshots.h"
#include "solver/solver.h"

using namespace test;
using gphys::Body;
using gphys::Vec3;

namespace {

constexpr float frame = 1.0f / 60;
constexpr double g = static_cast<double>(9.81f);

const Body& body_of(const World& world, gphys_body_id id) { return gphys::unwrap(world.solver)->body(id); }

std::vector<gphys_break> breaks_of(const World& world) {
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_breaks(world.solver, nullptr, 0, &total) >= GPHYS_OK);
    std::vector<gphys_break> breaks(total);
    REQUIRE(gphys_solver_get_breaks(world.solver, breaks.data(), total, &total) == GPHYS_OK);
    return breaks;
}
std::vector<gphys_constraint_info> constraints_of(const World& world, gphys_body_id body) {
    uint32_t total = 0;
    gphys_solver_get_constraints(world.solver, body, nullptr, 0, &total);
    std::vector<gphys_constraint_info> all(total);
    REQUIRE(gphys_solver_get_constraints(world.solver, body, all.data(), total, &total) == GPHYS_OK);
    return all;
}
std::vector<uint32_t> triangles_of(const World& world, gphys_body_id body) {
    uint32_t total = 0;
    gphys_solver_get_triangles(world.solver, body, nullptr, 0, &total);
    std::vector<uint32_t> all(total);
    REQUIRE(gphys_solver_get_triangles(world.solver, body, all.data(), total, &total) == GPHYS_OK);
    return all;
}
double mass_of(const World& world, gphys_body_id body) {
    std::vector<float> masses(world.stats(body).particle_count);
    REQUIRE(gphys_solver_get_masses(world.solver, body, 0, static_cast<uint32_t>(masses.size()), masses.data(), 4) ==
            GPHYS_OK);
    double sum = 0;
    for (const float mass : masses) sum += mass;
    return sum;
}
gphys_body_desc breaking_at(float force) {
    gphys_body_desc desc = World::body_desc();
    desc.breaking_force = force;
    return desc;
}
std::vector<gphys_vec3> line_down(uint32_t count, float link) {
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i < count; ++i) points.push_back({0, -link * static_cast<float>(i), 0});
    return points;
}
/// The status of breaking one of the constraints.
gphys_status cut(const World& world, gphys_body_id body, gphys_constraint_id constraint, gphys_break* out = nullptr) {
    return gphys_solver_break_constraint(world.solver, body, constraint, out);
}
/// Breaks up to `count` constraints, any of them. Returns how many broke.
uint32_t cut_any(const World& world, gphys_body_id body, uint32_t count, Random& random) {
    uint32_t broken = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const std::vector<gphys_constraint_info> all = constraints_of(world, body);
        const gphys_status status = cut(world, body, all[random.index(static_cast<uint32_t>(all.size()))].id);
        REQUIRE((status == GPHYS_OK || status == GPHYS_ERROR_UNSUPPORTED));
        broken += status == GPHYS_OK;
    }
    return broken;
}

using Edge = std::pair<uint32_t, uint32_t>;
Edge edge(uint32_t a, uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// The number of pieces of the surface that hang together by common particles.
size_t piece_count(const std::vector<uint32_t>& triangles, uint32_t particles) {
    std::vector<uint32_t> root(particles);
    for (uint32_t p = 0; p < particles; ++p) root[p] = p;
    const auto find = [&](uint32_t p) {
        while (root[p] != p) p = root[p] = root[root[p]];
        return p;
    };
    for (size_t i = 0; i < triangles.size(); ++i) root[find(triangles[i])] = find(triangles[i / 3 * 3]);
    std::set<uint32_t> roots;
    for (const uint32_t p : triangles) roots.insert(find(p));
    return roots.size();
}

/// Whether each edge of a triangle has one constraint, and each other constraint lies in the surface: between opposite
/// corners of two triangles with a common edge, or along two edges.
void check_surface(const World& world, gphys_body_id body) {
    const std::vector<uint32_t> triangles = triangles_of(world, body);
    std::map<Edge, std::vector<uint32_t>> opposite;
    std::map<uint32_t, std::set<uint32_t>> beside;
    for (size_t i = 0; i < triangles.size(); i += 3) {
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t a = triangles[i + k], b = triangles[i + (k + 1) % 3];
            opposite[edge(a, b)].push_back(triangles[i + (k + 2) % 3]);
            beside[a].insert(b), beside[b].insert(a);
        }
    }
    std::set<Edge> across;
    for (const auto& [ends, corners] : opposite) {
        CHECK(corners.size() <= 2);
        if (corners.size() == 2) across.insert(edge(corners[0], corners[1]));
    }
    std::map<Edge, int> held;
    size_t outside = 0;
    for (const gphys_constraint_info& c : constraints_of(world, body)) {
        const Edge ends = edge(c.particle_a, c.particle_b);
        if (opposite.count(ends)) {
            ++held[ends];
        } else if (!across.count(ends)) {
            const std::set<uint32_t>& first = beside[ends.first];
            outside +=
                std::none_of(first.begin(), first.end(), [&](uint32_t p) { return beside[p].count(ends.second) != 0; });
        }
    }
    CHECK(outside == 0);
    CHECK(held.size() == opposite.size());
    CHECK(std::all_of(held.begin(), held.end(), [](const auto& each) { return each.second == 1; }));
}

}  // namespace

// Statics: the first link carries all mass below it.
TEST_CASE("a rope breaks at its first link when the weight below exceeds the breaking force") {
    const float dt = GENERATE(0.002f, frame, 0.1f);
    const uint32_t substeps = GENERATE(1u, 8u, 40u);
    CAPTURE(dt, substeps);
    const double weight = 20 * g / 21;
    for (const double factor : {0.999999, 1.000001}) {
        World world(substeps);
        gphys_body_desc desc = breaking_at(static_cast<float>(weight * factor));
        const gphys_body_id rope = world.rope(line_down(21, 0.1f), 0, desc);
        world.pin(rope, 0);
        std::vector<gphys_break> breaks;
        for (int i = 0; i < 20 && breaks.empty(); ++i) {
            world.step(dt);
            breaks = breaks_of(world);
        }
        REQUIRE(breaks.size() == (factor < 1));
        if (factor > 1) continue;
        CHECK(breaks[0].body == rope);
        CHECK(breaks[0].constraint == constraints_of(world, rope)[0].id - 1);
        CHECK(edge(breaks[0].particle_a, breaks[0].particle_b) == edge(0, 1));
        CHECK(breaks[0].torn_particle == GPHYS_NO_PARTICLE);
        CHECK(breaks[0].new_particle == GPHYS_NO_PARTICLE);
        CHECK(breaks[0].load == Approx(weight).epsilon(1e-6));
        CHECK(world.stats(rope).constraint_count == 19);
        // What is below falls freely.
        const Vec3 before = world.position(rope, 20);
        world.step(dt);
        CHECK(world.position(rope, 20).y < before.y);
        CHECK(breaks_of(world).empty());
    }
}

TEST_CASE("of many ropes those break that are too weak, side by side or near models") {
    const bool near = GENERATE(false, true);
    World world;
    const gphys_aabb table{{-1, -3.5f, -1}, {30, -2.5f, 1}};
    if (near) world.model(GPHYS_SHAPE_AABB, &table);
    const double weight = 20 * g / 21;
    std::vector<gphys_body_id> ropes;
    for (int i = 0; i < 24; ++i) {
        std::vector<gphys_vec3> points = line_down(21, 0.1f);
        for (gphys_vec3& p : points) p.x = static_cast<float>(i);
        ropes.push_back(world.rope(points, 0));
        world.pin(ropes.back(), 0);
    }
    // Meanwhile the time scheme has begun.
    for (int i = 0; i < 5; ++i) world.step(frame);
    for (int i = 0; i < 24; ++i) {
        const gphys_body_id rope = ropes[static_cast<size_t>(i)];
        const float force = static_cast<float>(weight * (0.9995 + 0.00004 * i));
        for (const gphys_constraint_info& link : constraints_of(world, rope)) {
            REQUIRE(gphys_solver_set_breaking_forces(world.solver, rope, &link.id, &force, 0, 1) == GPHYS_OK);
        }
    }
    std::set<gphys_body_id> broken;
    for (int i = 0; i < 10; ++i) {
        world.step(frame);
        for (const gphys_break& each : breaks_of(world)) CHECK(broken.insert(each.body).second);
    }
    for (int i = 0; i < 24; ++i) CHECK(broken.count(ropes[static_cast<size_t>(i)]) == (i <= 12));
}

// It is moved as if it could not leave the region that gravity allows, and then once more.
TEST_CASE("the load of a rope that a force carries off counts once") {
    for (const double factor : {0.99, 1.01}) {
        World world;
        gphys_body_desc desc = breaking_at(static_cast<float>(5000 * factor));
        desc.mass = 1;
        const gphys_body_id rope = world.rope({{0, 0, 0}, {1, 0, 0}}, 0, desc);
        const gphys_vec3 force{10000, 0, 0};
        REQUIRE(gphys_solver_set_forces(world.solver, rope, 1, 1, &force, 0) == GPHYS_OK);
        world.step(frame);
        CHECK(breaks_of(world).size() == (factor < 1));
    }
}

// The mean force of a blow is its momentum divided by the step: of a string that becomes taut the momentum of the ball,
// and its weight for the rest of the step.
TEST_CASE("a falling ball breaks a string by its momentum") {
    const bool in_graph = GENERATE(false, true);
    CAPTURE(in_graph);
    const auto fall = [&](double force) {
        World world;
        std::vector<gphys_vec3> points{{0, 0, 0}, {0, -0.9f, 0}};
        if (in_graph) points.insert(points.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
        gphys_body_desc desc = World::body_desc();
        desc.mass = 0.5f * static_cast<float>(points.size());
        const gphys_body_id body = world.particles(points, desc);
        gphys_constraint_id string = 0, ignored = 0;
        for (uint32_t p = 2; p < points.size(); ++p) {
            const uint32_t next = p + 1 < points.size() ? p + 1 : 2;
            REQUIRE(gphys_solver_add_distance(world.solver, body, p, next, -1, 0, &ignored) == GPHYS_OK);
        }
        REQUIRE(gphys_solver_add_max_distance(world.solver, body, 0, 1, 1, 0, &string) == GPHYS_OK);
        const float narrowed = static_cast<float>(force);
        REQUIRE(gphys_solver_set_breaking_forces(world.solver, body, &string, &narrowed, 0, 1) == GPHYS_OK);
        world.pin(body, 0);
        world.set_velocity(body, 1, {0, -3, 0});
        std::vector<gphys_break> breaks;
        for (int i = 0; i < 5 && breaks.empty(); ++i) {
            world.step(frame);
            breaks = breaks_of(world);
        }
        return breaks;
    };
    // From 3 m/s after 0.1 m, at the time t with 0.1 = 3 t + g t^2 / 2, in the second step of 1/60 s.
    const double v = std::sqrt(9 + 2 * g * 0.1), rest_of_step = 2 * frame - (v - 3) / g;
    const double load = 0.5 * (v / frame + g * rest_of_step / frame);
    const std::vector<gphys_break> breaks = fall(0.9999 * load);
    REQUIRE(breaks.size() == 1);
    CHECK(breaks[0].load == Approx(load).epsilon(1e-4));
    CHECK(fall(1.0001 * load).empty());
}

// Each particle at rest is in balance: the loads of its links carry its weight.
TEST_CASE("the loads of hanging cloth carry its weight") {
    World world;
    gphys_body_desc desc = breaking_at(1e6f);
    desc.damping = 2;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, -1, 0}, 13, 13, desc);
    for (uint32_t p = 0; p < 13; ++p) world.pin(sheet, p);
    const Body& body = body_of(world, sheet);
    for (int i = 0; i < 300; ++i) world.step(frame);
    std::vector<double> below(13), slot_load(body.constraints.by_slot.size());
    const int frames = 60;
    for (int i = 0; i < frames; ++i) {
        world.step(frame);
        gphys::each_link_place(body.plan, body.cloth.batches, [&](uint32_t link, uint32_t place) {
            const gphys::DistanceConstraint& c = body.constraints.by_slot[body.plan.slots[link]];
            const Vec3 along = body.particles.position[c.b] - body.particles.position[c.a];
            const double down = body.breaking.impulse[place] / frame / frames * std::fabs(along.y) / length(along);
            // The rows between which it leads.
            for (uint32_t row = std::min(c.a, c.b) / 13; row < std::max(c.a, c.b) / 13; ++row) below[row] += down;
        });
    }
    for (uint32_t row = 0; row < 12; ++row) {
        CAPTURE(row);
        CHECK(below[row] == Approx(g * (12 - row) / 13).epsilon(0.01));
    }
}

TEST_CASE("cloth keeps its mass, its triangles and its shape whatever breaks") {
    const uint32_t flags = GENERATE(0u, 1u, 2u, 3u);
    CAPTURE(flags);
    Random random(5);
    World world(8, {0, 0, 0});
    gphys_body_desc desc = World::body_desc();
    desc.cloth_flags = flags;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 12, 9, desc);
    if ((flags & GPHYS_CLOTH_SHEAR) == 0) {
        // The builder has not linked the diagonals that are edges of triangles.
        for (uint32_t row = 0; row < 8; ++row) {
            for (uint32_t column = 0; column < 11; ++column) {
                gphys_constraint_id ignored = 0;
                const uint32_t p = 12 * row + column;
                REQUIRE(gphys_solver_add_distance(world.solver, sheet, p + 1, p + 12, -1, 0, &ignored) == GPHYS_OK);
            }
        }
    }
    const size_t corners = triangles_of(world, sheet).size();
    const double mass = mass_of(world, sheet);
    uint32_t broken = 0;
    for (int round = 0; round < 25; ++round) {
        broken += cut_any(world, sheet, 8, random);
        CHECK(triangles_of(world, sheet).size() == corners);
        CHECK(mass_of(world, sheet) == Approx(mass).epsilon(1e-6));
        check_surface(world, sheet);
        CHECK(world.stats(sheet).strain_max < 1e-5f);
        const uint64_t before = hash(world.solver);
        World other(8, {0, 0, 0});
        REQUIRE(restore(other.solver, snapshot(world.solver)) == GPHYS_OK);
        REQUIRE(hash(other.solver) == before);
        world.step(frame);
        other.step(frame);
        REQUIRE(hash(other.solver) == hash(world.solver));
        CHECK(world.stats(sheet).strain_max < 1e-5f);
    }
    CHECK(broken > 100);
    CHECK(world.stats(sheet).particle_count > 150);
}

TEST_CASE("a sheet under more weight than it holds parts in two, and its energy does not grow") {
    const bool holds = GENERATE(true, false);
    World world;
    gphys_body_desc desc = breaking_at(holds ? 60.0f : 20.0f);
    desc.damping = 0.5f;
    const uint32_t columns = 8, rows = 16, count = columns * rows;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {0.7f, 0, 0}, {0, -1.5f, 0}, columns, rows, desc);
    for (uint32_t p = 0; p < columns; ++p) world.pin(sheet, p);
    // 20 kg at the lower edge: 25 N for each of its threads.
    const std::vector<float> heavy(columns, 20.0f / columns);
    REQUIRE(gphys_solver_set_masses(world.solver, sheet, count - columns, columns, heavy.data(), 4) == GPHYS_OK);
    double energy = world.energy(sheet);
    size_t breaks = 0;
    for (int i = 0; i < 90; ++i) {
        world.step(frame);
        for (const gphys_break& each : breaks_of(world)) CHECK(each.load > desc.breaking_force);
        breaks += breaks_of(world).size();
        const double now = world.energy(sheet);
        CHECK(now <= energy + 1e-3);
        energy = now;
    }
    const size_t pieces = piece_count(triangles_of(world, sheet), world.stats(sheet).particle_count);
    if (holds) {
        CHECK(breaks == 0);
        CHECK(pieces == 1);
    } else {
        CHECK(pieces >= 2);
        CHECK(world.position(sheet, count - 1).y < -4);
        CHECK(world.position(sheet, columns).y > -1);
        check_surface(world, sheet);
    }
}

TEST_CASE("a tear goes on where it began") {
    World world(8, {0, 0, 0});
    const uint32_t size = 11;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, size, size);
    // Across the middle of the left edge, and then along: each tear is at the end of the last.
    std::vector<uint32_t> torn;
    for (uint32_t column = 0; column < size; ++column) {
        const uint32_t from = 5 * size + column, to = from + size;
        for (const gphys_constraint_info& c : constraints_of(world, sheet)) {
            if (edge(c.particle_a, c.particle_b) != edge(from, to)) continue;
            gphys_break made{};
            REQUIRE(cut(world, sheet, c.id, &made) == GPHYS_OK);
            torn.push_back(made.torn_particle);
            CHECK(made.new_particle + 1 == world.stats(sheet).particle_count);
            CHECK(made.load == 0);
            break;
        }
    }
    CHECK(torn.size() == size);
    check_surface(world, sheet);
    CHECK(piece_count(triangles_of(world, sheet), world.stats(sheet).particle_count) == 2);
}

TEST_CASE("a particle and its copy share mass and momentum, and only one of them stays pinned") {
    World world(8, {0, 0, 0});
    gphys_body_desc desc = World::body_desc();
    desc.self_collision = 1;
    desc.static_friction = 1;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 2, 3, desc);
    for (uint32_t p = 0; p < 6; ++p) {
        world.set_velocity(sheet, p, {static_cast<float>(p), 1, 0});
        const float factor = 1 + static_cast<float>(p);
        REQUIRE(gphys_solver_set_friction_factors(world.solver, sheet, p, 1, &factor, 0) == GPHYS_OK);
    }
    const gphys_vec3 force{6, 0, 0}, air{1, 2, 3};
    REQUIRE(gphys_solver_set_forces(world.solver, sheet, 0, 6, &force, 0) == GPHYS_OK);
    REQUIRE(gphys_solver_set_air_velocities(world.solver, sheet, 0, 6, &air, 0) == GPHYS_OK);
    world.pin(sheet, 2);
    world.pin(sheet, 3);
    const gphys_animation_target held{{0, 0, 0.5f}, {0, 0, 0}, 0, INFINITY};
    REQUIRE(gphys_solver_set_animation_targets(world.solver, sheet, 2, 1, &held, 0) == GPHYS_OK);
    gphys_constraint_id across = 0;
    for (const gphys_constraint_info& c : constraints_of(world, sheet))
        if (edge(c.particle_a, c.particle_b) == edge(2, 4)) across = c.id;
    gphys_break made{};
    REQUIRE(cut(world, sheet, across, &made) == GPHYS_OK);
    REQUIRE(made.torn_particle == 2);
    REQUIRE(made.new_particle == 6);
    const Body& body = body_of(world, sheet);
    CHECK(body.particles.pinned(2));
    CHECK_FALSE(body.particles.pinned(6));
    CHECK(body.particles.mass[2] + body.particles.mass[6] == Approx(1.0 / 6));
    CHECK(body.particles.force[2].x + body.particles.force[6].x == Approx(6));
    CHECK(body.particles.position[6] == body.particles.position[2]);
    CHECK(body.contacts.friction_factor[6] == 3);
    CHECK(body.air.velocity[6] == Vec3{1, 2, 3});
    CHECK(body.contacts.self.placed[6] == body.contacts.self.placed[2]);
    for (int i = 0; i < 10; ++i) world.step(frame);
    CHECK(length(world.position(sheet, 2) - Vec3{0, 0, 0.5}) < 1e-7);
    CHECK(length(world.position(sheet, 6) - Vec3{0, 0, 0.5}) > 0.01);
    check_surface(world, sheet);
}

TEST_CASE("links between pins, and in compression, do not break") {
    World world;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, -1, 0}, 5, 5, breaking_at(50));
    for (uint32_t p = 0; p < 5; ++p) world.pin(sheet, p);
    const gphys_vec3 apart{2, 0, 0};
    REQUIRE(gphys_solver_set_positions(world.solver, sheet, 4, 1, &apart, 0) == GPHYS_OK);
    for (int i = 0; i < 5; ++i) {
        world.step(frame);
        for (const gphys_break& each : breaks_of(world)) CHECK(edge(each.particle_a, each.particle_b) != edge(3, 4));
    }
    World column;
    gphys_body_desc desc = breaking_at(0.01f);
    const gphys_body_id post = column.rope({{0, 0, 0}, {0, 1, 0}}, 0, desc);
    column.pin(post, 0);
    for (int i = 0; i < 20; ++i) {
        column.step(0.001f);
        CHECK(breaks_of(column).empty());
    }
}

TEST_CASE("a step breaks one constraint for each 128 particles of a body at most") {
    World world;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {3, 0, 0}, {0, -3, 0}, 20, 20, breaking_at(1e-3f));
    for (uint32_t p = 0; p < 20; ++p) world.pin(sheet, p);
    size_t most = 0;
    for (int i = 0; i < 10; ++i) {
        const size_t before = world.stats(sheet).particle_count;
        world.step(frame);
        const std::vector<gphys_break> breaks = breaks_of(world);
        CHECK(breaks.size() <= (before + 127) / 128);
        most = std::max(most, breaks.size());
        std::set<uint32_t> torn;
        for (const gphys_break& each : breaks) CHECK(torn.insert(each.torn_particle).second);
    }
    CHECK(most >= 4);
    // All steps of a frame.
    uint32_t steps = 0;
    REQUIRE(gphys_solver_advance(world.solver, world.scene, 0.05f, &steps, nullptr) == GPHYS_OK);
    CHECK(steps == 3);
    CHECK(breaks_of(world).size() > most);
}

TEST_CASE("torn cloth beside models moves alike with any number of threads, and from a snapshot on", "[simulation]") {
    const auto run = [&](uint32_t workers, int from_snapshot) {
        gphys_solver_desc settings = World::desc();
        World world(settings);
        REQUIRE(gphys_solver_set_worker_count(world.solver, workers) == GPHYS_OK);
        const gphys_sphere ball{{0.5f, -0.4f, -0.3f}, 0.15f};
        const gphys_model_id model = world.model(GPHYS_SHAPE_SPHERE, &ball);
        std::vector<gphys_body_id> sheets;
        for (int i = 0; i < 3; ++i) {
            const float x = 0.4f * static_cast<float>(i);
            sheets.push_back(world.cloth({x, 0, 0}, {0.4f, 0, 0}, {0, -1, 0}, 15, 20, breaking_at(1)));
            for (uint32_t p = 0; p < 15; ++p) world.pin(sheets.back(), p);
        }
        std::vector<uint64_t> hashes;
        size_t breaks = 0;
        // The ball stops in the cloth, so that contact planes are reused.
        for (int i = 0; i < 50; ++i) {
            const gphys_transform place{{0, 0, 0.03f * static_cast<float>(std::min(i, 30))}, {0, 0, 0, 1}, 1};
            REQUIRE(gphys_scene_set_transform(world.scene, model, &place) == GPHYS_OK);
            if (i == from_snapshot) REQUIRE(restore(world.solver, snapshot(world.solver)) == GPHYS_OK);
            world.step(frame);
            breaks += breaks_of(world).size();
            hashes.push_back(hash(world.solver));
            for (const gphys_body_id sheet : sheets) {
                for (const gphys_vec3 velocity : world.velocities(sheet)) CHECK(length(gphys::widen(velocity)) < 10);
            }
        }
        CHECK(breaks > 20);
        for (const gphys_body_id sheet : sheets) check_surface(world, sheet);
        return hashes;
    };
    const std::vector<uint64_t> alone = run(1, -1);
    CHECK(run(2, -1) == alone);
    CHECK(run(4, 25) == alone);
    CHECK(run(1, 20) == alone);
}

TEST_CASE("cloth that tears on a still ball stays outside it", "[simulation]") {
    World world;
    const gphys_sphere ball{{0, 0, 0}, 0.4f};
    world.model(GPHYS_SHAPE_SPHERE, &ball);
    gphys_body_desc desc = breaking_at(0.6f);
    desc.damping = 1;
    const gphys_body_id sheet = world.cloth({-0.5f, 0.5f, -0.5f}, {1, 0, 0}, {0, 0, 1}, 25, 25, desc);
    const std::vector<float> heavy(25, 0.05f);
    REQUIRE(gphys_solver_set_masses(world.solver, sheet, 0, 25, heavy.data(), 4) == GPHYS_OK);
    REQUIRE(gphys_solver_set_masses(world.solver, sheet, 600, 25, heavy.data(), 4) == GPHYS_OK);
    size_t breaks = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        breaks += breaks_of(world).size();
        const std::vector<gphys_vec3> places = world.positions(sheet), velocities = world.velocities(sheet);
        for (size_t p = 0; p < places.size(); ++p) {
            CHECK(length(gphys::widen(places[p])) > 0.4);
            CHECK(length(gphys::widen(velocities[p])) < 20);
        }
    }
    CHECK(breaks > 20);
}

TEST_CASE("the mesh of a body that tears is that of its new surface") {
    World world(8, {0, 0, 0});
    Random random(3);
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 10, 10);
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create_from_body(nullptr, world.solver, sheet, &mesh) == GPHYS_OK);
    const gphys_model_id model = world.model(GPHYS_SHAPE_MESH, mesh);
    for (int round = 0; round < 10; ++round) {
        const Words before = snapshot(world.solver);
        REQUIRE(cut_any(world, sheet, 6, random) > 0);
        for (uint32_t p = 0; p < world.stats(sheet).particle_count; ++p)
            world.set_velocity(sheet, p, {random.uniform_float(-1, 1), random.uniform_float(-1, 1), 0});
        world.step(frame);
        for (const bool back : {false, true}) {
            if (back) REQUIRE(restore(world.solver, before) == GPHYS_OK);
            gphys_mesh* anew = nullptr;
            REQUIRE(gphys_mesh_create_from_body(nullptr, world.solver, sheet, &anew) == GPHYS_OK);
            CHECK(gphys::unwrap(mesh)->hash() == gphys::unwrap(anew)->hash());
            gphys_mesh_report report{}, wanted{};
            REQUIRE(gphys_mesh_get_report(mesh, &report) == GPHYS_OK);
            REQUIRE(gphys_mesh_get_report(anew, &wanted) == GPHYS_OK);
            CHECK(std::memcmp(&report, &wanted, sizeof report) == 0);
            for (int i = 0; i < 200; ++i) {
                const gphys_ray ray{{random.uniform_float(0, 1), 3, random.uniform_float(0, 1)},
                                    {random.uniform_float(-0.2f, 0.2f), -1, 0},
                                    INFINITY};
                gphys_hit hit{}, by_new{};
                CHECK(gphys_shape_raycast(GPHYS_SHAPE_MESH, mesh, &ray, &hit) ==
                      gphys_shape_raycast(GPHYS_SHAPE_MESH, anew, &ray, &by_new));
                CHECK(std::memcmp(&hit, &by_new, sizeof hit) == 0);
            }
            gphys_mesh_destroy(anew);
            REQUIRE(gphys_scene_validate(world.scene) == GPHYS_OK);
        }
    }
    REQUIRE(gphys_scene_remove(world.scene, model) == GPHYS_OK);
    gphys_mesh_destroy(mesh);
}

TEST_CASE("gas escapes from a torn ball") {
    World world(8, {0, 0, 0});
    const gphys_body_id box = [&] {
        const float v[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        const uint32_t faces[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
        gphys_mesh* mesh = nullptr;
        REQUIRE(gphys_mesh_create(nullptr, v, 12, 4, faces, 12, &mesh) == GPHYS_OK);
        gphys_body_id body = 0;
        REQUIRE(gphys_solver_add_cloth_mesh(world.solver, nullptr, mesh, nullptr, &body) == GPHYS_OK);
        gphys_mesh_destroy(mesh);
        return body;
    }();
    REQUIRE(gphys_solver_set_volume(world.solver, box, -1, 0) == GPHYS_OK);
    world.step(frame);
    float volume = 0;
    REQUIRE(gphys_solver_get_volume(world.solver, box, &volume, nullptr) == GPHYS_OK);
    REQUIRE(cut(world, box, constraints_of(world, box)[0].id) == GPHYS_OK);
    CHECK(gphys_solver_get_volume(world.solver, box, &volume, nullptr) == GPHYS_ERROR_UNSUPPORTED);
    world.step(frame);
    CHECK(world.stats(box).particle_count == 5);
}

TEST_CASE("breaking forces are kept by constraint, and those that come later do not break") {
    World world(8, {0, 0, 0});
    const gphys_body_id rope = world.rope(line_down(4, 1), 0, breaking_at(7));
    const std::vector<gphys_constraint_info> links = constraints_of(world, rope);
    std::vector<float> forces(4);
    gphys_constraint_id ids[] = {links[0].id, links[1].id, links[2].id, 0};
    REQUIRE(gphys_solver_add_distance(world.solver, rope, 0, 3, -1, 0, &ids[3]) == GPHYS_OK);
    const auto get = [&] {
        REQUIRE(gphys_solver_get_breaking_forces(world.solver, rope, ids, 4, forces.data(), 4) == GPHYS_OK);
        return forces;
    };
    CHECK(get() == std::vector<float>{7, 7, 7, 0});
    const float one[] = {3, 0};
    REQUIRE(gphys_solver_set_breaking_forces(world.solver, rope, ids + 1, one, 4, 2) == GPHYS_OK);
    CHECK(get() == std::vector<float>{7, 3, 0, 0});
    World other;
    REQUIRE(restore(other.solver, snapshot(world.solver)) == GPHYS_OK);
    REQUIRE(gphys_solver_get_breaking_forces(other.solver, rope, ids, 4, forces.data(), 4) == GPHYS_OK);
    CHECK(forces == std::vector<float>{7, 3, 0, 0});
    REQUIRE(gphys_solver_remove_constraint(world.solver, rope, ids[1]) == GPHYS_OK);
    const float never = 0;
    REQUIRE(gphys_solver_set_breaking_forces(world.solver, rope, ids, &never, 0, 1) == GPHYS_OK);
    REQUIRE(gphys_solver_get_breaking_forces(world.solver, rope, ids, 1, forces.data(), 4) == GPHYS_OK);
    CHECK(forces[0] == 0);
    CHECK(gphys_solver_get_breaking_forces(world.solver, rope, ids + 1, 1, forces.data(), 4) == GPHYS_ERROR_INVALID_ID);
}
