// Particles against particles: of two bodies, and of one with itself.
#include <chrono>

#include "solver_world.h"

using gphys::Vec3;
using test::figure;
using test::World;

namespace {

constexpr float dt = 1.0f / 60;

gphys_body_desc colliding(float radius, float mass) {
    gphys_body_desc desc = World::body_desc();
    desc.radius = radius;
    desc.mass = mass;
    desc.body_layers = 1;
    return desc;
}

void throw_all(World& world, gphys_body_id body, gphys_vec3 velocity) {
    const std::vector<gphys_vec3> all(world.positions(body).size(), velocity);
    REQUIRE(gphys_solver_set_velocities(world.solver, body, 0, static_cast<uint32_t>(all.size()), all.data(), 12) ==
            GPHYS_OK);
}

/// The nearest pair of particles of two bodies.
double nearest(const std::vector<gphys_vec3>& a, const std::vector<gphys_vec3>& b) {
    double least = gphys::infinity;
    for (const gphys_vec3& p : a) {
        for (const gphys_vec3& q : b) least = std::min(least, distance(gphys::widen(p), gphys::widen(q)));
    }
    return least;
}

struct Pairs {
    uint32_t touching = 0, pressed = 0;  // as near as their radii and a thousandth; nearer by more than a tenth
    double nearest = gphys::infinity;
};

/// Of equal spheres, sorted along x.
Pairs count_pairs(std::vector<gphys_vec3> all, double diameter) {
    std::sort(all.begin(), all.end(), [](const gphys_vec3& a, const gphys_vec3& b) { return a.x < b.x; });
    Pairs pairs;
    for (size_t i = 0; i < all.size(); ++i) {
        for (size_t j = i + 1; j < all.size() && all[j].x - all[i].x < 1.001 * diameter; ++j) {
            const double apart = distance(gphys::widen(all[i]), gphys::widen(all[j]));
            pairs.nearest = std::min(pairs.nearest, apart);
            pairs.touching += apart < 1.001 * diameter;
            pairs.pressed += apart < 0.9 * diameter;
        }
    }
    return pairs;
}

/// `count` spheres fall out of a loose heap into a box; how they lie after `frames`. `most_pressed`: pairs nearer
/// than 0.9 diameters.
void pour(uint32_t count, int frames, uint32_t most_pressed) {
    constexpr float radius = 0.02f;
    const float half = 0.5f * std::cbrt(static_cast<float>(count) / 10000);
    World world;
    const gphys_plane walls[] = {
        {{0, 1, 0}, 0}, {{1, 0, 0}, -half}, {{-1, 0, 0}, -half}, {{0, 0, 1}, -half}, {{0, 0, -1}, -half}};
    for (const gphys_plane& wall : walls) world.model(GPHYS_SHAPE_PLANE, &wall);
    gphys_body_desc desc = colliding(radius, static_cast<float>(count) * 0.03f);
    desc.self_collision = 1;
    desc.friction = 0.3f;
    test::Random random(9);
    const uint32_t side = static_cast<uint32_t>(2 * half / (2.2f * radius)) - 1;
    std::vector<gphys_vec3> heap;
    for (uint32_t i = 0; i < count; ++i) {
        const auto along = [&](uint32_t k) {
            return 2.2f * radius * static_cast<float>(k) + random.uniform_float(-0.05f, 0.05f) * radius;
        };
        heap.push_back({-half + 1.5f * radius + along(i % side), 0.1f + radius + along(i / side / side),
                        -half + 1.5f * radius + along(i / side % side)});
    }
    const gphys_body_id body = world.particles(heap, desc);
    const auto begin = std::chrono::steady_clock::now();
    for (int frame = 0; frame < frames; ++frame) world.step(dt);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    figure("ns per particle and substep", time.count() * 1e9 / (8.0 * frames * count), "ns");
    const std::vector<gphys_vec3> all = world.positions(body);
    float top = 0;
    for (const gphys_vec3& p : all) {
        // A skin of 1e-4 radii keeps them off the walls, and contacts leave them there.
        REQUIRE(p.y >= radius * 0.999f);
        REQUIRE(std::max(std::fabs(p.x), std::fabs(p.z)) <= half - radius * 0.999f);
        top = std::max(top, p.y);
    }
    const Pairs pairs = count_pairs(all, 2 * radius);
    const double spheres = count * 4.0 / 3 * gphys::pi * std::pow(radius, 3);
    const double filled = spheres / (4.0 * half * half * (top + radius));
    figure("nearest pair", pairs.nearest / (2 * radius), "diameters");
    figure("of the volume filled", filled, "parts");
    CHECK(pairs.pressed <= most_pressed);
    CHECK(pairs.touching >= 0.9 * count);  // all but those on the floor rest on another
    // No packing of equal spheres is denser than pi / sqrt(18) (Hales 2005): they have not collapsed.
    CHECK(filled < 0.7405);
}

}  // namespace

TEST_CASE("two particles collide as the laws of impact say") {
    World world(8, {0, 0, 0});
    const double e = 0.8, mass_a = 2, mass_b = 3, speed_a = 7, speed_b = -2;
    const float aside = GENERATE(0.0f, 0.03f);
    gphys_body_desc desc = colliding(0.05f, static_cast<float>(mass_a));
    desc.restitution = static_cast<float>(e);
    desc.friction = 0;
    const gphys_body_id a = world.particles({{-1, 0, 0}}, desc);
    desc.mass = static_cast<float>(mass_b);
    const gphys_body_id b = world.particles({{1, aside, 0}}, desc);
    throw_all(world, a, {static_cast<float>(speed_a), 0, 0});
    throw_all(world, b, {static_cast<float>(speed_b), 0, 0});
    for (int frame = 0; frame < 30; ++frame) world.step(dt);
    const Vec3 after_a = gphys::widen(world.velocities(a)[0]), after_b = gphys::widen(world.velocities(b)[0]);
    // Smooth spheres: the impulse goes along the line of centres at the moment of touch.
    const double y = static_cast<double>(aside) / 0.1;
    const Vec3 normal{std::sqrt(1 - y * y), y, 0};
    const double approach = (speed_a - speed_b) * normal.x;
    const Vec3 impulse = normal * ((1 + e) * approach / (1 / mass_a + 1 / mass_b));
    CHECK(length(after_a - (Vec3{speed_a, 0, 0} - impulse / mass_a)) < 1e-5);
    CHECK(length(after_b - (Vec3{speed_b, 0, 0} + impulse / mass_b)) < 1e-5);
    CHECK(length(after_a * mass_a + after_b * mass_b - Vec3{mass_a * speed_a + mass_b * speed_b, 0, 0}) < 1e-5);
}

TEST_CASE("bodies whose masks share no bit pass through each other, as all do by default") {
    World world(8, {0, 0, 0});
    gphys_body_desc desc = colliding(0.05f, 1);
    const bool by_default = GENERATE(true, false);
    if (by_default) desc = World::body_desc();
    const gphys_body_id a = world.particles({{-0.5f, 0, 0}}, desc);
    if (!by_default) desc.body_layers = 2;
    const gphys_body_id b = world.particles({{0.5f, 0, 0}}, desc);
    throw_all(world, a, {5, 0, 0});
    throw_all(world, b, {-5, 0, 0});
    for (int frame = 0; frame < 60; ++frame) world.step(dt);
    CHECK(world.velocities(a)[0].x == 5);
    CHECK(world.velocities(b)[0].x == -5);
}

TEST_CASE("particles poured into a box pile up") { pour(1000, 60, 0); }
TEST_CASE("10 000 particles poured into a box pile up", "[.long]") {
    // 4 sweeps in each of 8 substeps carry a load on by 32 particles a step, and this heap is 30 deep: what it
    // weighs down reaches its floor late. One pair in a hundred.
    pour(10000, 240, 100);
}

TEST_CASE("a sheet that falls on another that is pinned stays above it", "[simulation]") {
    constexpr float spacing = 0.05f, radius = 0.45f * spacing;
    const float speed = GENERATE(0.0f, 4.0f, 10.0f);
    World world;
    const gphys_body_id below = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 21, 21, colliding(radius, 1));
    for (uint32_t i = 0; i < 21; ++i) {
        for (const uint32_t p : {i, 420 + i, 21 * i, 21 * i + 20}) world.pin(below, p);
    }
    // Turned, so that threads cross.
    const gphys_body_id above =
        world.cloth({0.213f, 0.3f, 0.221f}, {0.6f, 0, 0.1f}, {-0.1f, 0, 0.6f}, 13, 13, colliding(radius, 0.4f));
    throw_all(world, above, {0, -speed, 0});
    uint32_t through = 0;
    double apart = gphys::infinity;
    for (int frame = 0; frame < 150; ++frame) {
        world.step(dt);
        const std::vector<gphys_vec3> low = world.positions(below), high = world.positions(above);
        apart = std::min(apart, nearest(low, high));
        for (const gphys_vec3& p : high) {
            const auto nearer = [&](const gphys_vec3& a, const gphys_vec3& b) {
                return distance(gphys::widen(a), gphys::widen(p)) < distance(gphys::widen(b), gphys::widen(p));
            };
            through += p.y < std::min_element(low.begin(), low.end(), nearer)->y;
        }
    }
    figure("nearest pair", apart / (2 * radius), "diameters");
    figure("strain at rest", world.stats().strain_max * 100, "%");
    // What constraints press into each other is parted at the end of a step, by sweeps that leave a few per cent.
    CHECK(apart >= 0.95 * 2 * radius);
    CHECK(through == 0);
    CHECK(world.stats().kinetic_energy < 1e-2f);
}

TEST_CASE("cloth that is folded rests on itself", "[simulation]") {
    constexpr float spacing = 0.04f, radius = 0.4f * spacing;
    constexpr uint32_t columns = 31, rows = 21;
    World world;
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    gphys_body_desc desc = colliding(radius, 1);
    desc.self_collision = 1;
    desc.cloth_flags = GPHYS_CLOTH_SHEAR;
    const gphys_body_id sheet =
        world.cloth({0, radius, 0}, {spacing * (columns - 1), 0, 0}, {0, 0, spacing * (rows - 1)}, columns, rows, desc);
    // The right half in a loop of three radii over the left one, three diameters up.
    std::vector<gphys_vec3> folded = world.positions(sheet);
    const double middle = spacing * (columns - 1) / 2, bow = 3 * static_cast<double>(radius);
    for (gphys_vec3& p : folded) {
        const double beyond = p.x - middle, angle = std::min(beyond / bow, gphys::pi);
        if (beyond <= 0) continue;
        const double straight = beyond - angle * bow;
        p.x = static_cast<float>(middle + bow * std::sin(angle) - straight);
        p.y = static_cast<float>(static_cast<double>(radius) + bow * (1 - std::cos(angle)));
    }
    REQUIRE(gphys_solver_set_positions(world.solver, sheet, 0, columns * rows, folded.data(), 12) == GPHYS_OK);
    for (int frame = 0; frame < 240; ++frame) world.step(dt);
    const std::vector<gphys_vec3> at = world.positions(sheet);
    double least = gphys::infinity, height = 0;
    uint32_t counted = 0, fallen = 0;
    for (uint32_t i = 0; i < columns * rows; ++i) {
        for (uint32_t j = i + 1; j < columns * rows; ++j) {
            const int across = static_cast<int>(i % columns) - static_cast<int>(j % columns);
            const int down = static_cast<int>(i / columns) - static_cast<int>(j / columns);
            if (std::abs(across) <= 1 && std::abs(down) <= 1) continue;  // linked
            least = std::min(least, distance(gphys::widen(at[i]), gphys::widen(at[j])));
        }
        if (i % columns <= columns / 2 + 6) continue;
        ++counted;
        height += at[i].y;
        fallen += at[i].y < 1.9f * radius;
    }
    height /= counted;
    figure("nearest pair", least / (2 * radius), "diameters");
    figure("mean height of the upper layer", height / radius, "radii");
    CHECK(least >= 0.95 * 2 * radius);
    CHECK(fallen == 0);
    // Lying on the lower one at r: by 2 r if particle lies on particle, by sqrt(4 r^2 - spacing^2 / 2) = 0.93 r if
    // each lies in the middle of a cell.
    CHECK(height >= 1.93 * static_cast<double>(radius));
    CHECK(height <= 3.05 * static_cast<double>(radius));
}

TEST_CASE("a rope that is thrown across another does not pass, and gains no energy") {
    constexpr float spacing = 0.05f, radius = 0.4f * spacing;
    const float speed = GENERATE(2.0f, 5.0f, 10.0f);
    World world(8, {0, 0, 0});
    std::vector<gphys_vec3> taut, thrown;
    for (int i = 0; i < 41; ++i) {
        const float along = -1 + spacing * static_cast<float>(i);
        taut.push_back({along, 0, 0});
        thrown.push_back({0.013f, 0.3f, along});
    }
    const gphys_body_id a = world.rope(taut, 0, colliding(radius, 1)), b = world.rope(thrown, 0, colliding(radius, 1));
    world.pin(a, 0);
    world.pin(a, 40);
    throw_all(world, b, {0, -speed, 0});
    const double before = world.energy();
    double most = before;
    uint32_t through = 0;
    for (int frame = 0; frame < 60; ++frame) {
        world.step(dt);
        most = std::max(most, world.energy());
        const std::vector<gphys_vec3> low = world.positions(a);
        // The ends may swing round; the middle, which lies across, could only have passed through.
        const gphys_vec3 middle = world.positions(b)[20];
        const auto nearer = [&](const gphys_vec3& p, const gphys_vec3& q) {
            return std::fabs(p.x - middle.x) < std::fabs(q.x - middle.x);
        };
        through += middle.y < std::min_element(low.begin(), low.end(), nearer)->y;
    }
    figure("energy gained", (most - before) / before, "parts");
    CHECK(through == 0);
    CHECK(most - before <= 1e-3 * before);
}

TEST_CASE("two sheets that collide in free space keep their momentum") {
    World world(8, {0, 0, 0});
    const gphys_body_id a = world.cloth({0, 0, 0}, {0.5f, 0, 0}, {0, 0, 0.5f}, 11, 11, colliding(0.02f, 1));
    const gphys_body_id b = world.cloth({0.1f, 0.2f, 0.1f}, {0.5f, 0, 0}, {0, 0, 0.5f}, 11, 11, colliding(0.02f, 1));
    throw_all(world, b, {0, -3, 0});
    for (int frame = 0; frame < 60; ++frame) world.step(dt);
    Vec3 sum;
    for (const gphys_body_id body : {a, b}) {
        for (const gphys_vec3& v : world.velocities(body)) sum += gphys::widen(v) / 121;
    }
    figure("momentum lost", length(sum - Vec3{0, -3, 0}) / 3, "parts");
    CHECK(length(sum - Vec3{0, -3, 0}) <= 3e-3);  // a thousandth, as of a free sheet
    CHECK(world.velocities(a)[60].y < -0.5f);     // they did collide
}

TEST_CASE("contacts between bodies allocate nothing after the first step") {
    long allocations = 0;
    const gphys_allocator hooks{[](void* user, size_t size, size_t) -> void* {
                                    ++*static_cast<long*>(user);
                                    return std::malloc(size);
                                },
                                [](void*, void* memory, size_t, size_t) { std::free(memory); }, &allocations};
    gphys_solver_desc desc;
    gphys_solver_desc_init(&desc, sizeof desc);
    desc.allocator = &hooks;
    World world;
    gphys_solver_destroy(world.solver);
    REQUIRE(gphys_solver_create(&desc, &world.solver) == GPHYS_OK);
    gphys_body_desc body = colliding(0.02f, 1);
    body.self_collision = 1;
    const gphys_body_id below = world.cloth({0, 0, 0}, {0.5f, 0, 0}, {0, 0, 0.5f}, 11, 11, body);
    world.pin(below, 0);
    world.pin(below, 120);
    world.cloth({0.1f, 1, 0.1f}, {0.5f, 0, 0}, {0, 0, 0.5f}, 11, 11, body);  // meets the other only later
    world.step(dt);
    const long before = allocations;
    for (int frame = 0; frame < 90; ++frame) world.step(dt);
    CHECK(allocations == before);
    gphys_solver_destroy(world.solver);
    world.solver = nullptr;
}
