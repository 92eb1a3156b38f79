// Input that is valid but extreme: a status, or a motion of finite numbers.
#include "solver/state_range.h"
#include "solver_world.h"

using gphys::Vec3;
using test::World;

namespace {

constexpr float dt = 1.0f / 60;

/// The largest coordinate of any particle.
double farthest(const World& world, gphys_body_id body) {
    const std::vector<gphys_vec3> at = world.positions(body);
    REQUIRE(test::all_finite(at));
    REQUIRE(test::all_finite(world.velocities(body)));
    double most = 0;
    for (const gphys_vec3& p : at) most = std::max(most, max_component(abs(gphys::widen(p))));
    return most;
}

constexpr float tiny[] = {1e-45f, 1e-41f, 1e-38f, 1e-30f, 1e-24f, 1e-20f, 1e-18f, 1e-15f, 1e-12f, 1e-9f, 1e-6f};

}  // namespace

TEST_CASE("ropes of very short links stay where they are held, or fall") {
    // Beside others or alone, at rest or with links far longer than they shall be: how short is no matter.
    uint32_t combination = 0;
    for (const float link : tiny) {
        for (const float spacing : {0.0f, 1e-24f, 1e-6f, 0.1f}) {
            for (const uint32_t count : {2u, 3u, 9u}) {
                for (const uint32_t pins : {0u, 1u, 2u}) {
                    for (const uint32_t ropes : {1u, 8u}) {
                        if (!test::is_tried(combination++)) continue;
                        World world;
                        gphys_body_id rope = 0;
                        for (uint32_t i = 0; i < ropes; ++i) {
                            rope = world.rope(test::line({0, 0, 0}, {0, -spacing, 0}, count), link);
                            if (pins > 0) world.pin(rope, 0);
                            if (pins > 1) world.pin(rope, count - 1);
                        }
                        double most = 0;
                        for (int step = 0; step < 10; ++step) {
                            world.step(dt);
                            most = std::max(most, farthest(world, rope));
                        }
                        // A fall of a sixth of a second is 0.14 m, and no particle leaves the rope. What pulls itself
                        // together swings by no more than its length.
                        INFO("link " << link << ", spacing " << spacing << ", " << count << " particles, " << pins
                                     << " pins, " << ropes << " ropes");
                        const double length = static_cast<double>(spacing) * (count - 1);
                        CHECK(most <= length * 1.001 + (pins > 0 ? 1e-2 * (count - 1) * 0.01 : 0.15));
                    }
                }
            }
        }
    }
}

TEST_CASE("joints at hardly any distance are joints at none") {
    for (const float rest : tiny) {
        World world;
        const gphys_body_id a = world.rope(test::line({0, 0, 0}, {0.1f, 0, 0}, 5), 0);
        const gphys_body_id b = world.rope(test::line({0.4f, 0, 0}, {0.1f, 0, 0}, 5), 0);
        world.pin(a, 0);
        gphys_joint_id joint;
        REQUIRE(gphys_solver_join(world.solver, a, 4, b, 0, rest, 0, &joint) == GPHYS_OK);
        for (int step = 0; step < 60; ++step) world.step(dt);
        INFO("rest " << rest);
        CHECK(farthest(world, b) < 0.81);
        CHECK(distance(world.position(a, 4), world.position(b, 0)) < 2e-6);
    }
}

TEST_CASE("a sheet without area is refused") {
    World world;
    const gphys_vec3 corner{1, 2, 3};
    const std::pair<gphys_vec3, gphys_vec3> edges[] = {{{1, 0, 0}, {2, 0, 0}},
                                                       {{1, 0, 0}, {-1, 0, 0}},
                                                       {{1, 0, 0}, {0, 0, 0}},
                                                       {{0, 0, 0}, {0, 0, 0}},
                                                       {{0.3f, 0.1f, -0.7f}, {0.6f, 0.2f, -1.4f}},
                                                       {{1e-40f, 0, 0}, {3, 0, 0}}};
    for (const auto& [u, v] : edges) {
        for (const uint32_t n : {2u, 7u}) {
            gphys_body_id body = 77;
            CHECK(gphys_solver_add_cloth(world.solver, nullptr, &corner, &u, &v, n, n, &body) ==
                  GPHYS_ERROR_INVALID_ARGUMENT);
            CHECK(body == 77);
        }
    }
    uint32_t total = 1;
    REQUIRE(gphys_solver_get_bodies(world.solver, nullptr, 0, &total) >= GPHYS_OK);
    CHECK(total == 0);
}

TEST_CASE("sheets of hardly any area or size stay where they are held") {
    uint32_t combination = 0;
    for (const float size : {1e-45f, 1e-40f, 1e-36f, 1e-25f, 1e-19f, 1e-18f, 1e-15f, 1e-9f, 1e-4f, 1.0f}) {
        for (const float slant : {1.0f, 1e-3f, 1e-7f}) {
            for (const uint32_t n : {2u, 3u, 11u}) {
                const gphys_vec3 corner{0, 0, 0}, u{size, 0, 0};
                for (const gphys_vec3 v :
                     {gphys_vec3{size, slant * size, 0}, gphys_vec3{-size, 0, slant * size}, gphys_vec3{0, slant, 0}}) {
                    if (!test::is_tried(combination++)) continue;
                    World world;
                    gphys_body_id body;
                    const gphys_status status =
                        gphys_solver_add_cloth(world.solver, nullptr, &corner, &u, &v, n, n, &body);
                    if (status == GPHYS_ERROR_INVALID_ARGUMENT) continue;  // slant * size is 0
                    world.pin(body, 0);
                    double most = 0;
                    for (int step = 0; step < 60; ++step) {
                        world.step(dt);
                        most = std::max(most, farthest(world, body));
                    }
                    INFO("size " << size << ", slant " << slant << ", " << n << " particles a side");
                    const double reach = static_cast<double>(size) + length(gphys::widen(v));
                    CHECK(most <= 2 * reach + 1e-15);
                }
            }
        }
    }
}

TEST_CASE("meshes with triangles of no area make calm cloth") {
    // Needles, points, corners at one place that stay separate, and an edge that is used five times.
    const std::vector<std::pair<std::vector<float>, std::vector<uint32_t>>> meshes = {
        {{0, 0, 0, 1, 0, 0, 2, 0, 0}, {0, 1, 2}},
        {{0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 2}},
        {{0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0}, {0, 1, 2, 2, 1, 3}},
        {{0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {0, 1, 2, 2, 3, 4, 4, 5, 0}},
        {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 1, 1, 1}, {0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 5, 1, 0, 5}},
        {{0, 0, 0, 1, 0, 0, 1, 0, 0}, {0, 1, 2, 1, 2, 0, 1, 1, 2}},
        {{0, 0, 0, 1e-30f, 0, 0, 0, 1e-30f, 0, 1e-30f, 1e-30f, 0}, {0, 1, 2, 2, 1, 3}},
    };
    for (size_t i = 0; i < meshes.size(); ++i) {
        for (const bool pinned : {false, true}) {
            World world;
            const test::MeshHandle mesh(meshes[i].first, meshes[i].second);
            gphys_body_id body;
            REQUIRE(gphys_solver_add_cloth_mesh(world.solver, nullptr, mesh.mesh, nullptr, &body) == GPHYS_OK);
            if (pinned) world.pin(body, 0);
            const double before = world.energy(body);
            double most = 0;
            for (int step = 0; step < 60; ++step) {
                world.step(dt);
                most = std::max(most, farthest(world, body));
            }
            INFO("mesh " << i << (pinned ? ", pinned" : ""));
            // A second of falling, or the edges that lead to the pin.
            CHECK(most <= (pinned ? 3 : 6.0));
            CHECK(world.energy(body) <= before + 1e-3);
        }
    }
}

namespace {

/// Bodies of all kinds with parameters from the ends of their ranges.
struct Extremes {
    test::Random random;
    std::string story;
    World world;
    std::vector<gphys_body_id> bodies;

    explicit Extremes(uint64_t seed) : random(seed), world(settings()) {
        if (random.index(2)) add_models();
        const uint32_t count = 1 + random.index(3);
        for (uint32_t i = 0; i < count; ++i) add_body();
        for (const gphys_body_id body : bodies) change(body);
        if (bodies.size() > 1 && random.index(2)) {
            gphys_joint_id joint;
            const float rest = pick({-1, 0, 1e-30f, 1, 1e10f});
            gphys_solver_join(world.solver, bodies[0], 0, bodies[1], 0, rest, compliance(), &joint);
        }
    }

    float pick(std::initializer_list<float> values) {
        return values.begin()[random.index(static_cast<uint32_t>(values.size()))];
    }
    float compliance() { return pick({0, 0, 0, 1e-40f, 1e-10f, 1, 1e15f}); }
    gphys_solver_desc settings() {
        const float g = pick({0, 1e-40f, 9.81f, 9.81f, 1e5f, 1e15f});
        gphys_solver_desc desc = World::desc(1 + random.index(10), {0, -g, 0});
        desc.max_strain = pick({0, 0, 1e-30f, 0.01f});
        desc.tolerance = pick({0, 0, 1e-30f, 0.01f});
        desc.max_substeps = 16;
        desc.sleep_speed = pick({0, 1e-30f, 1});
        story += "gravity " + std::to_string(g);
        return desc;
    }
    void add_models() {
        const float size = pick({1e-30f, 1, 1e6f, 1e14f});
        const gphys_sphere sphere{{0, -size, 0}, size};
        world.model(GPHYS_SHAPE_SPHERE, &sphere);
        const gphys_plane plane{{0, 1, 0}, -2};
        world.model(GPHYS_SHAPE_PLANE, &plane);
        story += ", models of " + std::to_string(size);
    }
    void add_body() {
        gphys_body_desc desc = World::body_desc();
        desc.mass = pick({1e-45f, 1e-30f, 1e-10f, 1, 1, 1e10f, 1e15f});
        desc.radius = pick({0, 1e-40f, 0.01f, 0.01f, 10, 1e10f, 1e15f});
        desc.damping = pick({0, 0.5f, 1e-40f, 1e6f, 1e15f});
        desc.friction = pick({0, 0.5f, 1e-40f, 1e15f});
        desc.restitution = pick({0, 0.5f, 1});
        desc.compliance = compliance();
        desc.bend_compliance = compliance();
        desc.self_collision = random.index(2);
        desc.body_layers = random.index(2);
        const float size = pick({1e-45f, 1e-38f, 1e-25f, 1e-15f, 1e-8f, 0.1f, 0.1f, 1, 1e6f, 1e13f});
        const float off = pick({0, 0, 1, 1e10f, 9e14f});
        const uint32_t kind = random.index(4), count = 2 + random.index(14);
        std::vector<gphys_vec3> at;
        for (uint32_t i = 0; i < count; ++i) {
            const gphys_vec3 p = random.point(size);
            at.push_back({p.x + off, p.y, p.z + off});
        }
        gphys_body_id body = 0;
        gphys_status status;
        if (kind == 0) {
            status = gphys_solver_add_particles(world.solver, &desc, at.data(), 12, count, &body);
        } else if (kind == 1) {
            const float link = pick({0, 1e-45f, 1e-24f, 1e-9f, 0.1f, 1e10f, 1e15f});
            status = gphys_solver_add_rope(world.solver, &desc, at.data(), 12, count, link, &body);
        } else if (kind == 2) {
            const gphys_vec3 corner{off, 0, off}, u = random.point(size), v = random.point(size);
            status = gphys_solver_add_cloth(world.solver, &desc, &corner, &u, &v, 2 + random.index(5),
                                            2 + random.index(5), &body);
        } else {
            std::vector<float> vertices;
            for (const gphys_vec3& p : at) vertices.insert(vertices.end(), {p.x, p.y, p.z});
            std::vector<uint32_t> indices;
            for (uint32_t i = 0; i < 3 * count; ++i) indices.push_back(random.index(count));
            const test::MeshHandle mesh(vertices, indices);
            status = gphys_solver_add_cloth_mesh(world.solver, &desc, mesh.mesh, nullptr, &body);
        }
        story += "; kind " + std::to_string(kind) + " size " + std::to_string(std::log10(size)) + " off " +
                 std::to_string(off) + " mass " + std::to_string(std::log10(desc.mass)) + " radius " +
                 std::to_string(desc.radius) + " damping " + std::to_string(desc.damping) + " compliance " +
                 std::to_string(desc.compliance) + " self " + std::to_string(desc.self_collision);
        if (status == GPHYS_OK) bodies.push_back(body);
    }
    void change(gphys_body_id body) {
        if (random.index(2)) world.pin(body, 0);
        const gphys_vec3 velocity = random.point(pick({0, 1e-40f, 10, 1e6f, 1e14f}));
        if (random.index(3) == 0) world.set_velocity(body, 1, velocity);
        const gphys_vec3 force = random.point(pick({0, 1e-40f, 10, 1e10f, 1e15f}));
        if (random.index(3) == 0) REQUIRE(gphys_solver_set_forces(world.solver, body, 1, 1, &force, 12) == GPHYS_OK);
        const float mass = pick({1e-45f, 1e-20f, 1, 1e15f});
        if (random.index(3) == 0) REQUIRE(gphys_solver_set_masses(world.solver, body, 1, 1, &mass, 4) == GPHYS_OK);
        if (random.index(4) == 0)
            gphys_solver_set_volume(world.solver, body, pick({-1, 1e-30f, 1, 1e15f}), compliance());
    }
};

bool are_within(const std::vector<gphys_vec3>& values, double limit) {
    return std::all_of(values.begin(), values.end(),
                       [&](gphys_vec3 v) { return max_component(abs(gphys::widen(v))) <= limit; });
}

/// Places are in the range of coordinates; what is beyond all floats is reported as the largest.
bool is_finite(const World& world, gphys_body_id body) {
    const gphys_solver_stats stats = world.stats(body);
    return test::all_finite(world.positions(body)) && test::all_finite(world.velocities(body)) &&
           are_within(world.positions(body), GPHYS_MAX_COORDINATE) && std::isfinite(stats.kinetic_energy) &&
           std::isfinite(stats.potential_energy) && std::isfinite(stats.strain_max) && std::isfinite(stats.strain_rms);
}

bool contacts_are_finite(const World& world) {
    gphys_contact contacts[256];
    gphys_impulse impulses[64];
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_contacts(world.solver, contacts, 256, &total) >= GPHYS_OK);
    std::vector<gphys_vec3> all;
    for (uint32_t i = 0; i < std::min(total, 256u); ++i) all.insert(all.end(), {contacts[i].point, contacts[i].normal});
    REQUIRE(gphys_solver_get_impulses(world.solver, impulses, 64, &total) >= GPHYS_OK);
    for (uint32_t i = 0; i < std::min(total, 64u); ++i)
        all.insert(all.end(), {impulses[i].linear, impulses[i].angular});
    return test::all_finite(all);
}

void check_extremes(uint64_t seed) {
    Extremes extremes(seed);
    const float step = extremes.pick({1e-6f, 1.0f / 60, 1.0f / 60, 0.5f});
    INFO("seed " << seed << ": " << extremes.story << ", dt " << step);
    World restored;
    for (int i = 0; i < 10; ++i) {
        extremes.world.step(step);
        bool finite = contacts_are_finite(extremes.world);
        for (const gphys_body_id body : extremes.bodies) finite = finite && is_finite(extremes.world, body);
        REQUIRE(finite);
        uint32_t total = 0, hash[2], hash_restored[2];
        REQUIRE(gphys_solver_get_snapshot(extremes.world.solver, nullptr, 0, &total) == GPHYS_INCOMPLETE);
        std::vector<uint32_t> words(total);
        REQUIRE(gphys_solver_get_snapshot(extremes.world.solver, words.data(), total, &total) == GPHYS_OK);
        REQUIRE(gphys_solver_restore(restored.solver, words.data(), total) == GPHYS_OK);
        REQUIRE(gphys_solver_get_hash(extremes.world.solver, hash) == GPHYS_OK);
        REQUIRE(gphys_solver_get_hash(restored.solver, hash_restored) == GPHYS_OK);
        REQUIRE((hash[0] == hash_restored[0] && hash[1] == hash_restored[1]));
    }
}

}  // namespace

TEST_CASE("bodies with extreme parameters stay in range, and their snapshots are restored") {
    for (int seed = 0; seed < test::tries(100); ++seed) check_extremes(static_cast<uint64_t>(seed));
    // Tensions, impulses, places of contacts and histories that were no numbers.
    for (const uint64_t seed : {168, 193, 203, 236, 421, 663, 815, 825, 880, 1131, 1303, 1625, 1823, 1998, 2610})
        check_extremes(seed);
}

TEST_CASE("a body that has left the range has no contact from there") {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    gphys::Body body(std::pmr::new_delete_resource());
    body.particles.position = {{1, 2, 3}, {0, nan, 0}};
    body.particles.velocity = {{0, 0, 0}, {0, 0, 0}};
    body.contacts.points.resize(2 * gphys::contact_points_per_particle);
    body.contacts.point_count = {0, 1};
    body.contacts.points[gphys::contact_points_per_particle] = {7, 0, {nan, nan, nan}, {0, 1, 0}};
    gphys::stay_in_range(body);
    CHECK(gphys::is_finite(body.particles.position[1]));
    for (const gphys::ContactPoint& contact : body.contacts.points) CHECK((contact.model == 0 && contact.point.x == 0));
    CHECK((body.contacts.point_count[0] == 0 && body.contacts.point_count[1] == 0));
}
