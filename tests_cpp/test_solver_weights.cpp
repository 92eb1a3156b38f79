// Heaps, against the laws of statics: what lies on other things presses a model with its weight, and friction on the
// model follows.
#include "snapshots.h"
#include "solver_world.h"

using gphys::Vec3;
using test::figure;
using test::World;

namespace {

constexpr double g = static_cast<double>(9.81f);
constexpr float frame = 1 / 60.0f;
constexpr float radius = 0.05f;

gphys_transform placed(gphys_vec3 at) { return {at, {0, 0, 0, 1}, 1}; }

/// Walls around a square of 1 m.
void add_walls(World& world, float half = 0.5f) {
    for (const float side : {-1.0f, 1.0f}) {
        world.box({0.5f, 3, 3}, {side * (half + 0.5f), 3.02f, 0});
        world.box({3, 3, 0.5f}, {0, 3.02f, side * (half + 0.5f)});
    }
}

gphys_body_desc balls(float mass, float friction) {
    gphys_body_desc desc = World::body_desc();
    desc.radius = radius;
    desc.mass = mass;
    desc.friction = friction;
    desc.self_collision = 1;
    desc.body_layers = 1;
    return desc;
}

/// Layers of 10 x 10 balls, each 1 kg, one on the other.
gphys_body_id add_layers(World& world, int count, float friction, float height = 0) {
    std::vector<gphys_vec3> places;
    for (int i = 0; i < 100 * count; ++i) {
        const int row = i / 10 % 10, layer = i / 100;
        places.push_back({0.1f * static_cast<float>(i % 10) - 0.45f, height + 0.1f * static_cast<float>(layer) + radius,
                          0.1f * static_cast<float>(row) - 0.45f});
    }
    gphys_body_desc desc = balls(100 * static_cast<float>(count), friction);
    desc.radius = 0.049f;
    return world.particles(places, desc);
}

/// A pit of triangles, 1 m square, with a floor of 10 x 10 cells that rises towards the walls by `rise` metres.
test::MeshHandle mesh_pit(float rise) {
    constexpr int cells = 10, row = cells + 1;
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
    const auto add_cell = [&](int a, int b, int c, int d) {
        for (const int corner : {a, b, c, b, d, c}) indices.push_back(static_cast<uint32_t>(corner));
    };
    for (int z = 0; z < row; ++z) {
        for (int x = 0; x < row; ++x) {
            const float u = 0.2f * static_cast<float>(x) - 1, v = 0.2f * static_cast<float>(z) - 1;
            for (const float part : {0.5f * u, rise * std::max(u * u, v * v), 0.5f * v}) vertices.push_back(part);
            if (x < cells && z < cells)
                add_cell(z * row + x, (z + 1) * row + x, z * row + x + 1, (z + 1) * row + x + 1);
        }
    }
    const int corners[] = {0, cells, row * row - 1, cells * row}, above = row * row;
    for (const int corner : corners) {
        const size_t at = size_t{3} * static_cast<size_t>(corner);
        const float place[] = {vertices[at], 3, vertices[at + 2]};
        vertices.insert(vertices.end(), place, place + 3);
    }
    for (int i = 0; i < 4; ++i) add_cell(corners[i], above + i, corners[(i + 1) % 4], above + (i + 1) % 4);
    return {vertices, indices};
}

/// On one model, or on all: 0.
Vec3 impulse_on(const World& world, gphys_model_id model) {
    Vec3 sum;
    for (const gphys_impulse& impulse : impulses(world)) {
        if (model == 0 || impulse.model == model) sum += gphys::widen(impulse.linear);
    }
    return sum;
}

/// The mean force on a model over a second, after three seconds.
double mean_weight_on(World& world, gphys_model_id model) {
    double sum = 0;
    for (int i = 0; i < 240; ++i) {
        world.step(frame);
        if (i >= 180) sum -= impulse_on(world, model).y;
    }
    return sum;
}

}  // namespace

TEST_CASE("Layers of balls between walls press the floor with the weight of all", "[simulation]") {
    for (const int count : {1, 2, 4, 8}) {
        World world;
        const gphys_model_id floor = world.box({5, 0.5f, 5}, {0, -0.5f, 0});
        add_walls(world);
        add_layers(world, count, 0);
        const double part = mean_weight_on(world, floor) / (100 * count * g);
        figure("layers", count, "");
        figure("floor carries", part, "of the weight");
        CHECK(std::fabs(part - 1) < 0.01);
    }
}

TEST_CASE("Layers of balls in a pit of triangles press it with the weight of all, and stay inside", "[simulation]") {
    for (const float rise : {0.0f, 0.1f}) {
        World world;
        const test::MeshHandle pit = mesh_pit(rise);
        const gphys_model_id model = world.model(GPHYS_SHAPE_MESH, pit.mesh);
        const gphys_body_id body = add_layers(world, 4, 0.3f, rise);
        const double part = mean_weight_on(world, model) / (400 * g);
        figure("mesh carries", part, "of the weight");
        CHECK(std::fabs(part - 1) < 0.01);
        for (const gphys_vec3& at : world.positions(body)) {
            const float edge = std::max(std::fabs(at.x), std::fabs(at.z));
            CHECK(edge < 0.5f - 0.0489f);
            CHECK(at.y > 0.0489f);
        }
    }
}

TEST_CASE("A heap in a pit of triangles goes on with the same bits after it is restored", "[simulation]") {
    World world, other;
    const test::MeshHandle pit = mesh_pit(0.1f);
    world.model(GPHYS_SHAPE_MESH, pit.mesh);
    other.model(GPHYS_SHAPE_MESH, pit.mesh);
    add_layers(world, 2, 0.3f, 0.1f);
    for (int i = 0; i < 40; ++i) world.step(frame);
    for (int round = 0; round < 3; ++round) {
        REQUIRE(test::restore(other.solver, test::snapshot(world.solver)) == GPHYS_OK);
        for (int i = 0; i < 20; ++i) {
            world.step(frame);
            other.step(frame);
            REQUIRE(test::hash(world.solver) == test::hash(other.solver));
        }
    }
}

TEST_CASE("A ball passes on the weight of one that is a hundred times as heavy") {
    World world;
    const gphys_model_id floor = world.box({5, 0.5f, 5}, {0, -0.5f, 0});
    add_walls(world, 0.0505f);
    world.particles({{0, radius, 0}}, balls(1, 0.5f));
    world.particles({{0, 3 * radius, 0}}, balls(100, 0.5f));
    CHECK(std::fabs(mean_weight_on(world, floor) / (101 * g) - 1) < 1e-3);
    gphys_body_contact contact{};
    uint32_t count = 0;
    REQUIRE(gphys_solver_get_body_contacts(world.solver, &contact, 1, &count) == GPHYS_OK);
    REQUIRE(count == 1);
    CHECK(std::fabs(static_cast<double>(contact.impulse) * 60 / (100 * g) - 1) < 1e-3);
}

TEST_CASE("A sheet and a rope pass on the weight of what lies on them", "[simulation]") {
    World world;
    const gphys_model_id floor = world.box({5, 0.5f, 5}, {0, -0.5f, 0});
    gphys_body_desc desc = balls(1, 0.5f);
    desc.self_collision = 0;
    desc.radius = 0.02f;
    world.cloth({-0.5f, 0.021f, -0.5f}, {1, 0, 0}, {0, 0, 1}, 20, 20, desc);
    desc.mass = 3;
    world.cloth({-0.5f, 0.07f, -0.5f}, {1, 0, 0}, {0, 0, 1}, 20, 20, desc);
    std::vector<gphys_vec3> below, above;
    for (int i = 0; i < 20; ++i) below.push_back({0.04f * static_cast<float>(i), 0.021f, 2});
    for (int i = 4; i < 16; ++i) above.push_back({0.04f * static_cast<float>(i), 0.065f, 2});
    desc.mass = 1;
    world.rope(below, 0, desc);
    desc.mass = 2;
    world.rope(above, 0, desc);
    CHECK(std::fabs(mean_weight_on(world, floor) / (7 * g) - 1) < 0.01);
}

TEST_CASE("The impulses on models are the change of momentum of a heap, which gains no energy") {
    for (const float restitution : {0.0f, 0.5f}) {
        World world;
        world.box({5, 0.5f, 5}, {0, -0.5f, 0});
        add_walls(world, 0.25f);
        std::vector<gphys_vec3> places;
        for (int i = 0; i < 60; ++i) {
            places.push_back({0.09f * static_cast<float>(i % 3) + 0.01f * static_cast<float>(i % 7) - 0.1f,
                              0.2f + 0.12f * static_cast<float>(i / 9),
                              0.09f * static_cast<float>(i / 3 % 3) + 0.01f * static_cast<float>(i % 5) - 0.1f});
        }
        gphys_body_desc desc = balls(60, 0.4f);
        desc.restitution = restitution;
        const gphys_body_id body = world.particles(places, desc);
        const auto momentum = [&] {
            Vec3 sum;
            for (const gphys_vec3& v : world.velocities(body)) sum += gphys::widen(v);
            return sum;
        };
        double off = 0, gained = 0, energy = world.energy(body);
        Vec3 before = momentum();
        for (int i = 0; i < 240; ++i) {
            world.step(frame);
            const Vec3 now = momentum(), by_gravity{0, -g, 0};
            off = std::max(off, length(now - before - by_gravity + impulse_on(world, 0)));
            before = now;
            const double left = world.energy(body);
            if (i > 0) gained = std::max(gained, left - energy);
            energy = left;
        }
        figure("momentum that is not accounted for", off, "N s");
        figure("gain of energy in a step", gained, "J");
        CHECK(off < 2e-3);
        CHECK(gained < 0.01);
    }
}

TEST_CASE("A heap lies on a slope that holds one of its balls, and slides down a steeper one", "[simulation]") {
    for (const int layers : {1, 2, 4}) {
        for (const double degrees : {10.0, 15.0, 20.0, 30.0}) {
            World world;
            const double angle = degrees / 180 * 3.14159265358979, half = angle / 2;
            const Vec3 normal{std::sin(angle), std::cos(angle), 0}, down{std::cos(angle), -std::sin(angle), 0};
            const gphys_aabb slope{{-50, -1, -50}, {50, 0, 50}};
            gphys_transform transform = placed({0, 0, 0});
            transform.rotation = {0, 0, static_cast<float>(-std::sin(half)), static_cast<float>(std::cos(half))};
            world.model(GPHYS_SHAPE_AABB, &slope, &transform);
            std::vector<gphys_vec3> places;
            for (int layer = 0; layer < layers; ++layer) {
                for (int i = 0; i < (10 - layer) * (10 - layer); ++i) {
                    const int row = i / (10 - layer), column = i % (10 - layer);
                    const Vec3 across{0, 0, 0.1 * row + 0.05 * layer};
                    places.push_back(gphys::narrow(down * (0.1 * column + 0.05 * layer) +
                                                   normal * (0.05 + 0.0708 * layer) + across));
                }
            }
            const gphys_body_id body = world.particles(places, balls(10, 0.5f));
            const auto slid = [&] {
                Vec3 sum;
                const std::vector<gphys_vec3> at = world.positions(body);
                for (uint32_t i = 0; i < 100; ++i) sum += gphys::widen(at[i]) - gphys::widen(places[i]);
                return dot(sum, down) / 100;
            };
            for (int i = 0; i < 120; ++i) world.step(frame);
            const double exact = 0.5 * g * (std::sin(angle) - 0.5 * std::cos(angle)) * 4;
            if (degrees == 30) {
                CHECK(std::fabs(slid() / exact - 1) < 0.02);
            } else {
                CHECK(std::fabs(slid()) < 1e-3);
            }
        }
    }
}

TEST_CASE("A floor that moves under layers of balls drags them by Coulomb's law of their weight", "[simulation]") {
    for (const float friction : {0.2f, 0.5f}) {
        for (const int layers : {1, 4}) {
            World world;
            const gphys_model_id floor = world.box({50, 0.5f, 50}, {0, -0.5f, 0});
            add_walls(world);
            add_layers(world, layers, friction);
            Vec3 sum, on_all;
            for (int i = 0; i < 180; ++i) {
                const gphys_transform transform = placed({static_cast<float>(i + 1) / 120, -0.5f, 0});
                REQUIRE(gphys_scene_set_transform(world.scene, floor, &transform) == GPHYS_OK);
                world.step(frame);
                if (i < 120) continue;
                sum += impulse_on(world, floor);
                on_all += impulse_on(world, 0);
            }
            CHECK(std::fabs(on_all.y / (-100 * layers * g) - 1) < 0.01);
            CHECK(std::fabs(sum.x / sum.y / static_cast<double>(friction) - 1) < 0.01);
        }
    }
}

TEST_CASE("A heap that presses on models moves alike with every number of workers") {
    uint32_t hashes[2][2];
    Vec3 pressed[2];
    for (const uint32_t workers : {1u, 3u}) {
        gphys_solver_desc settings = World::desc();
        settings.worker_count = workers;
        World world(settings);
        const gphys_model_id floor = world.box({5, 0.5f, 5}, {0, -0.5f, 0});
        add_walls(world);
        add_layers(world, 25, 0.4f);
        for (int i = 0; i < 20; ++i) world.step(frame);
        REQUIRE(gphys_solver_get_hash(world.solver, hashes[workers > 1]) == GPHYS_OK);
        pressed[workers > 1] = impulse_on(world, floor);
    }
    CHECK(hashes[0][0] == hashes[1][0]);
    CHECK(hashes[0][1] == hashes[1][1]);
    CHECK(pressed[0] == pressed[1]);
}
