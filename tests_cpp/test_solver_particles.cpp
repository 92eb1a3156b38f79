// Free particles: what is done for many at once is what is done for one, and nothing gets through.
#include <array>
#include <cstring>

#include "meshes.h"
#include "scene/scene.h"
#include "solver/contact/flat_model.h"
#include "solver/particles/flight.h"
#include "solver/particles/flight_kernels.h"
#include "solver_world.h"

using namespace gphys;
using test::figure;
using test::point_mass;
using test::World;

namespace {

gphys_transform any_placement(test::Random& random, bool turned) {
    return {random.point(3), turned ? random.rotation() : gphys_quat{0, 0, 0, 1}, random.uniform_float(0.5f, 2)};
}

gphys_model_id add(Scene& scene, gphys_shape_type type, const void* shape, const gphys_transform& at) {
    gphys_model_desc desc;
    gphys_model_desc_init(&desc, sizeof desc);
    gphys_model_id model = 0;
    REQUIRE(scene.add(type, shape, 0, &at, 0, 1, desc, &model) == GPHYS_OK);
    return model;
}

}  // namespace

TEST_CASE("a flight is found again where it has been") {
    test::Random random(71);
    for (int i = 0; i < 20000; ++i) {
        const double damping = i % 3 == 0 ? 0 : std::exp(random.uniform(-12, 4)), latest = random.uniform(1e-4, 0.5);
        const Flight flight{random.direction() * random.uniform(0, 20), damping};
        const Vec3 towards = random.direction();
        const double sign = random.index(2) ? 1 : -1;  // thrown towards, or away and falling back
        Vec3 velocity = random.direction() * std::exp(random.uniform(-3, 6));
        velocity = velocity + towards * (std::fabs(dot(velocity, towards)) * sign - dot(velocity, towards));
        const double passed = random.uniform(0, 1) * latest;
        const double distance = dot(flight.displacement(velocity, FlightTime(damping, passed)), towards);
        const double end = dot(flight.displacement(velocity, FlightTime(damping, latest)), towards);
        if (distance <= 0 || end < distance) continue;  // the question is not asked of such
        const double found = flight.time_to(velocity, towards, distance, latest);
        const double there = dot(flight.displacement(velocity, FlightTime(damping, found)), towards);
        CAPTURE(i, damping, latest, passed, found);
        REQUIRE(found >= 0);
        REQUIRE(found <= latest);
        // The rounding of what the distance is the difference of.
        const double size = length(velocity) * latest + length(flight.acceleration) * latest * latest;
        REQUIRE(std::fabs(there - distance) <= 1e-14 * size);
    }
}

TEST_CASE("planes and boxes are swept as the scene sweeps them") {
    test::Random random(72);
    int counts[3] = {};
    for (int i = 0; i < 60000; ++i) {
        Scene scene(nullptr);
        const gphys_transform at = any_placement(random, i % 2 == 1);
        gphys_model_id model = 0;
        if (i % 3 == 0) {
            const gphys_vec3 normal = i % 4 < 2 ? narrow(random.direction()) : gphys_vec3{0, -1, 0};
            const gphys_plane plane{normal, random.uniform_float(-1, 1)};
            model = add(scene, GPHYS_SHAPE_PLANE, &plane, at);
        } else if (i % 3 == 1) {
            const gphys_vec3 corner = random.point(1);
            const gphys_aabb box{corner,
                                 {corner.x + random.uniform_float(0, 2), corner.y + random.uniform_float(0, 2),
                                  corner.z + random.uniform_float(0, 2)}};
            model = add(scene, GPHYS_SHAPE_AABB, &box, at);
        } else {
            const gphys_obb box{random.point(1),
                                {random.uniform_float(0, 1), random.uniform_float(0, 1), random.uniform_float(0, 1)},
                                random.rotation()};
            model = add(scene, GPHYS_SHAPE_OBB, &box, at);
        }
        FlatModel flat;
        REQUIRE(flat.prepare(scene, model));
        const Sphere moving{random.direction() * random.uniform(0, 8), i % 5 == 0 ? 0 : random.uniform(0, 0.3)};
        const Vec3 way = random.direction() * random.uniform(0, 8);
        Hit quick, exact;
        const TriState verdict = flat.sweep(moving, way, quick);
        ++counts[static_cast<int>(verdict)];
        if (verdict == TriState::undecided) continue;
        const bool met = scene.sweep_model(model, moving, way, exact);
        CAPTURE(i, moving.radius, quick.t, exact.t);
        if (met != (verdict == TriState::yes)) {  // at the very end of the way, or at an edge
            const double graze = verdict == TriState::yes ? quick.t : exact.t;
            REQUIRE(graze > 1 - 1e-12);
            continue;
        }
        if (!met) continue;
        REQUIRE(std::fabs(quick.t - exact.t) * length(way) <= 1e-12);
        REQUIRE(distance(quick.normal, exact.normal) <= 1e-7);  // the scene's comes from a difference of points
        REQUIRE(distance(quick.point, exact.point) <= 1e-11);
        REQUIRE((exact.flags & GPHYS_HIT_INSIDE) == 0);
    }
    CHECK(counts[static_cast<int>(TriState::yes)] > 4000);
    CHECK(counts[static_cast<int>(TriState::no)] > 20000);
    figure("sweeps left open", counts[static_cast<int>(TriState::undecided)] / 60000.0, "");

    Scene scene(nullptr);
    const gphys_sphere ball{{0, 0, 0}, 1};
    CHECK(!FlatModel().prepare(scene, add(scene, GPHYS_SHAPE_SPHERE, &ball, any_placement(random, false))));
}

TEST_CASE("the kernels of flight give the same bits on each instruction set, and those of a single flight") {
    constexpr uint32_t groups = 9, particles = groups * flight_group;
    test::Random random(73);
    std::vector<Vec3> position, velocity, acceleration;
    for (uint32_t i = 0; i < particles; ++i) {
        position.push_back(random.direction() * random.uniform(0, 5));
        velocity.push_back(random.direction() * random.uniform(0, 30));
        acceleration.push_back(random.direction() * random.uniform(0, 20));
    }
    std::array<FlightObstacle, 2> obstacles{};
    for (FlightObstacle& obstacle : obstacles) {
        const Vec3 low = random.direction() * 3, high = low + Vec3{1, 1, 1};
        for (uint32_t i = 0; i < FlightBox::size; ++i) {
            obstacle.all.low[i] = low[static_cast<int>(i % 3)], obstacle.all.high[i] = high[static_cast<int>(i % 3)];
            obstacle.rest.low[i] = 1, obstacle.rest.high[i] = -1;
        }
    }
    for (const bool alike : {false, true}) {
        const FlightTime time(alike ? 0 : 0.7, 1.0 / 60);
        std::vector<Vec3> accelerations = acceleration;
        if (alike) std::fill(accelerations.begin(), accelerations.end(), acceleration[0]);
        for (const Isa isa : test::isas()) {
            CAPTURE(alike, name_of(isa));
            std::vector<Vec3> at = position, speed = velocity;
            const FlightGroups flock{
                groups,    &at[0].x,   &speed[0].x, &accelerations[0].x, alike ? 0 : flight_numbers,
                time.kept, time.reach, time.fall};
            FlightBounds bounds{};
            flight_kernels(isa).bound(flock, bounds);
            std::vector<uint8_t> overlapping(groups, 0), obstacle_of(particles, 77), resting_on(groups, 77);
            overlapping[1] = 4;
            flight_kernels(isa).fly(flock, obstacles.data(), 2,
                                    {overlapping.data(), obstacle_of.data(), resting_on.data()});
            FlightBounds wanted{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}, {}, {}};
            uint32_t stayed = 0;
            for (uint32_t p = 0; p < particles; ++p) {
                const Flight flight{accelerations[p], 0};
                const Vec3 way = flight.displacement(velocity[p], time), to = position[p] + way;
                uint32_t obstacle_count = 0, last = 77;
                for (uint32_t k = 0; k < 2; ++k) {
                    bool inside = true;
                    for (int axis = 0; axis < 3; ++axis) {
                        inside = inside && std::min(position[p][axis], to[axis]) <= obstacles[k].all.high[axis] &&
                                 std::max(position[p][axis], to[axis]) >= obstacles[k].all.low[axis];
                    }
                    if (inside) ++obstacle_count, last = k;
                }
                for (int axis = 0; axis < 3; ++axis) {
                    wanted.low[axis] = std::min({wanted.low[axis], position[p][axis], to[axis]});
                    wanted.high[axis] = std::max({wanted.high[axis], position[p][axis], to[axis]});
                    wanted.fastest[axis] = std::max(wanted.fastest[axis], std::fabs(velocity[p][axis]));
                    wanted.furthest[axis] = std::max(wanted.furthest[axis], std::fabs(to[axis] - position[p][axis]));
                }
                const bool marked = p == flight_group + 2;
                REQUIRE((overlapping[p / flight_group] >> p % flight_group & 1) == (obstacle_count > 0 || marked));
                if (obstacle_count > 0)
                    REQUIRE(obstacle_of[p] == (obstacle_count > 1 || marked ? several_obstacles : last));
                const bool stays = overlapping[p / flight_group] != 0;
                stayed += stays;
                REQUIRE(at[p] == (stays ? position[p] : to));
                REQUIRE(speed[p] == (stays ? velocity[p] : flight.velocity(velocity[p], time)));
            }
            REQUIRE(std::memcmp(&bounds, &wanted, sizeof bounds) == 0);
            CHECK(stayed > 0);
            CHECK(stayed < particles);
        }
    }
}

TEST_CASE("particles fall, bounce, slide and lie with the same bits alone and in company") {
    for (const float restitution : {0.0f, 0.5f}) {
        World together, apart;
        test::Random random(74);
        std::vector<gphys_body_id> alone;
        for (World* world : {&together, &apart}) {
            test::Random boxes(75);
            const gphys_plane ground{{0, 1, 0}, 0};
            world->model(GPHYS_SHAPE_PLANE, &ground);
            for (int i = 0; i < 12; ++i) {
                const gphys_vec3 at = boxes.point(2);
                const gphys_aabb box{{-0.4f, -0.1f, -0.4f}, {0.4f, 0.1f, 0.4f}};
                const gphys_quat turn = i % 2 ? boxes.rotation() : gphys_quat{0, 0, 0, 1};
                const gphys_transform placed{{at.x, std::fabs(at.y), at.z}, turn, 1};
                world->model(GPHYS_SHAPE_AABB, &box, &placed);
            }
        }
        std::vector<gphys_vec3> points;
        gphys_vec3 middle{};
        for (int i = 0; i < 205; ++i) {  // in swarms of eight, which lie on the same model for the most part
            if (i % 8 == 0) middle = random.point(2);
            const gphys_vec3 p = random.point(0.1f);
            points.push_back({middle.x + p.x, 3 + middle.y / 2 + p.y, middle.z + p.z});
        }
        gphys_body_desc desc = point_mass(0.02f, 0.4f, restitution);
        const gphys_body_id cloud = together.particles(points, desc);
        desc.mass /= static_cast<float>(points.size());
        for (const gphys_vec3& p : points) alone.push_back(apart.particles({p}, desc));
        for (int i = 0; i < 150; ++i) {
            together.step(1.0f / 60);
            apart.step(1.0f / 60);
            const std::vector<gphys_vec3> at = together.positions(cloud), speed = together.velocities(cloud);
            for (size_t p = 0; p < points.size(); ++p) {
                CAPTURE(restitution, i, p);
                REQUIRE(widen(at[p]) == widen(apart.positions(alone[p])[0]));
                REQUIRE(widen(speed[p]) == widen(apart.velocities(alone[p])[0]));
            }
        }
        CHECK(together.stats().contact_count == apart.stats().contact_count);
        CHECK(together.stats().contact_count > 100);
        std::vector<gphys_impulse> impulses[2];
        for (int k = 0; k < 2; ++k) {
            impulses[k].resize(13);
            uint32_t count = 0;
            REQUIRE(gphys_solver_get_impulses((k ? apart : together).solver, impulses[k].data(), 13, &count) ==
                    GPHYS_OK);
            impulses[k].resize(count);
        }
        REQUIRE(impulses[0].size() == impulses[1].size());
        for (size_t i = 0; i < impulses[0].size(); ++i) {
            CHECK(impulses[0][i].model == impulses[1][i].model);
            CHECK(distance(widen(impulses[0][i].linear), widen(impulses[1][i].linear)) <= 1e-7);
            CHECK(distance(widen(impulses[0][i].angular), widen(impulses[1][i].angular)) <= 1e-7);
        }
    }
}

TEST_CASE("on level ground, under gravity from the side, swarms lie or slide as Coulomb says") {
    for (const double tangent : {0.0, 0.45, 0.49, 0.51, 0.8}) {
        const double g = 9.81f, angle = std::atan(tangent);
        World world(1, narrow(Vec3{std::sin(angle), -std::cos(angle), 0} * g));
        const gphys_aabb slab{{-50, -1, -50}, {50, 0, 50}};
        const gphys_model_id ground = world.model(GPHYS_SHAPE_AABB, &slab);
        std::vector<gphys_vec3> points;
        for (int i = 0; i < 40; ++i) points.push_back({0.3f * static_cast<float>(i), 0.1f + 2e-5f, 0});
        const gphys_body_id body = world.particles(points, point_mass(0.1f, 0.5f, 0));
        world.step(1.0f / 60);
        const std::vector<gphys_vec3> start = world.positions(body), speed = world.velocities(body);
        constexpr int steps = 60;
        const double t = steps * static_cast<double>(1.0f / 60), along = g * (std::sin(angle) - 0.5 * std::cos(angle));
        for (int i = 0; i < steps; ++i) world.step(1.0f / 60);
        const std::vector<gphys_vec3> end = world.positions(body);
        for (size_t p = 0; p < points.size(); ++p) {
            const double moved = distance(widen(end[p]), widen(start[p]));
            CAPTURE(tangent, p, moved);
            if (tangent <= 0.5) {
                REQUIRE(moved == 0);
            } else {
                // The start is a float32 of some metres.
                REQUIRE(std::fabs(moved - (speed[p].x * t + along * t * t / 2)) <= 1e-4 * moved + 1e-6);
            }
        }
        gphys_impulse impulse{};
        uint32_t count = 0;
        REQUIRE(gphys_solver_get_impulses(world.solver, &impulse, 1, &count) == GPHYS_OK);
        REQUIRE(count == 1);
        CHECK(impulse.model == ground);
        const double pressed = g * std::cos(angle) * static_cast<double>(1.0f / 60);  // of a kilogram
        CHECK(std::fabs(impulse.linear.y + pressed) <= 1e-6 * pressed);
        CHECK(std::fabs(impulse.linear.x - std::min(0.5, tangent) * pressed) <= 1e-5 * pressed);
        if (tangent > 0.5) continue;
        // All have the same mass, so it is as if the middle of them were pressed.
        double middle = 0;
        for (const gphys_vec3& p : end) middle += static_cast<double>(p.x) / 40;
        CHECK(std::fabs(impulse.angular.z + middle * pressed) <= 1e-4 * middle * pressed);
    }
}

namespace {

struct Shots {
    int shots = 0, crossings = 0;
};

struct Wall {
    gphys_shape_type shape;
    double speed, turning;  // m/s towards those who shoot, and rad/s about an axis in it
};

/// `count` shots at 1000 m/s from either side at a wall of a millimetre, which is 100 m wide: a box, a plane or a mesh
/// of two triangles. From up to 12 m away; each is followed for 25 ms, in which it may bounce.
Shots shoot(const Wall& kind, uint32_t count, uint64_t seed) {
    const test::MeshHandle sheet({0, -50, -50, 0, 50, -50, 0, 50, 50, 0, -50, 50}, {0, 1, 2, 0, 2, 3});
    const gphys_aabb box{{-0.0005f, -50, -50}, {0.0005f, 50, 50}};
    const gphys_plane plane{{1, 0, 0}, 0};
    constexpr float dt = 1.0f / 120;
    test::Random random(seed);
    Shots result;
    for (uint32_t done = 0; done < count;) {
        const float side = random.index(2) ? 1.0f : -1.0f;
        World world(2, {0, 0, 0});
        gphys_model_id wall = 0;
        if (kind.shape == GPHYS_SHAPE_AABB) wall = world.model(kind.shape, &box);
        if (kind.shape == GPHYS_SHAPE_PLANE) wall = world.model(kind.shape, &plane);
        if (kind.shape == GPHYS_SHAPE_MESH) wall = world.model(kind.shape, sheet.mesh);
        const uint32_t together = std::min(count - done, 5000u);
        std::vector<gphys_vec3> from, speed;
        for (uint32_t i = 0; i < together; ++i) {
            from.push_back(
                {side * random.uniform_float(0.05f, 12), random.uniform_float(-9, 9), random.uniform_float(-9, 9)});
            const Vec3 target{0, random.uniform(-9, 9), random.uniform(-9, 9)};
            speed.push_back(narrow(normalized(target - widen(from.back())) * 1000));
        }
        const gphys_body_id body = world.particles(from, point_mass(0.01f, 0.3f, random.index(2) ? 1.0f : 0.0f));
        world.step(dt);  // which notes where the wall stands
        REQUIRE(gphys_solver_set_velocities(world.solver, body, 0, together, speed.data(), 12) == GPHYS_OK);
        std::vector<uint8_t> crossed(together, 0);
        for (int i = 1; i <= 3; ++i) {
            const double time = dt * i, half = kind.turning * time / 2;
            const gphys_transform at{{static_cast<float>(side * kind.speed * time), 0, 0},
                                     {0, static_cast<float>(std::sin(half)), 0, static_cast<float>(std::cos(half))},
                                     1};
            if (kind.speed != 0 || kind.turning != 0) {
                REQUIRE(gphys_scene_set_transform(world.scene, wall, &at) == GPHYS_OK);
            }
            world.step(dt);
            const std::vector<gphys_vec3> positions = world.positions(body);
            for (uint32_t p = 0; p < together; ++p) {
                if (widen(at).inverse_apply(widen(positions[p])).x * side <= 0) crossed[p] = 1;
            }
        }
        for (const uint8_t one : crossed) result.crossings += one;
        result.shots += static_cast<int>(together);
        done += together;
    }
    return result;
}

void check_shots(uint32_t count_of_each) {
    const Wall walls[] = {{GPHYS_SHAPE_AABB, 0, 0},   {GPHYS_SHAPE_PLANE, 0, 0},  {GPHYS_SHAPE_MESH, 0, 0},
                          {GPHYS_SHAPE_AABB, 5, 0},   {GPHYS_SHAPE_AABB, 5, 0.3}, {GPHYS_SHAPE_AABB, -5, 0},
                          {GPHYS_SHAPE_AABB, -5, 2},  {GPHYS_SHAPE_MESH, 5, 0.3}, {GPHYS_SHAPE_MESH, 20, -2},
                          {GPHYS_SHAPE_PLANE, 5, 0.3}};
    Shots all;
    uint64_t seed = 11;
    for (const Wall& wall : walls) {
        const Shots of_kind = shoot(wall, count_of_each, seed++);
        CAPTURE(wall.shape, wall.speed, wall.turning);
        CHECK(of_kind.crossings == 0);
        all.shots += of_kind.shots, all.crossings += of_kind.crossings;
    }
    figure("shots at a thin wall", all.shots, "");
    figure("crossings", all.crossings, "");
}

/// Particles poured into the lower half of a sphere of radius 2, of 24 x 12 quads, with a wall on its rim.
void pour_into_bowl(uint32_t count, int seconds) {
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
    constexpr uint32_t around = 24, rings = 13;
    for (uint32_t r = 0; r <= rings; ++r) {
        const double polar = r < rings ? pi / 2 * r / (rings - 1) : pi / 2;
        for (uint32_t k = 0; k < around; ++k) {
            const double turn = 2 * pi * k / around;
            vertices.push_back(static_cast<float>(2 * std::sin(polar) * std::cos(turn)));
            vertices.push_back(static_cast<float>(r < rings ? -2 * std::cos(polar) : 6));
            vertices.push_back(static_cast<float>(2 * std::sin(polar) * std::sin(turn)));
        }
    }
    for (uint32_t r = 0; r < rings; ++r) {
        for (uint32_t k = 0; k < around; ++k) {
            const uint32_t a = r * around + k, b = r * around + (k + 1) % around;
            indices.insert(indices.end(), {a, b, a + around, b, b + around, a + around});
        }
    }
    const test::MeshHandle bowl(vertices, indices);
    World world(4);
    world.model(GPHYS_SHAPE_MESH, bowl.mesh);
    test::Random random(5);
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i < count; ++i) {
        points.push_back(
            {random.uniform_float(-1.2f, 1.2f), random.uniform_float(0, 4), random.uniform_float(-1.2f, 1.2f)});
    }
    const gphys_body_id body = world.particles(points, point_mass(0.02f, 0.5f, 0.3f));
    for (int i = 0; i < 60 * seconds; ++i) world.step(1.0f / 60);
    int leaks = 0;
    for (const gphys_vec3& p : world.positions(body)) leaks += length(widen(p)) > 2 || p.y > 0;
    double fastest = 0;
    for (const gphys_vec3& v : world.velocities(body)) fastest = std::max(fastest, length(widen(v)));
    figure("bowl, leaks", leaks, "");
    figure("bowl, fastest at the end", fastest, "m/s");
    CHECK(leaks == 0);
    CHECK(fastest < 1e-3);
}

}  // namespace

TEST_CASE("nothing passes through a wall of one millimetre at 1000 m/s, in a million shots", "[simulation]") {
    check_shots(100000);
}
TEST_CASE("nothing passes through a wall of one millimetre at 1000 m/s, in ten million shots", "[.long]") {
    check_shots(1000000);
}

TEST_CASE("particles poured into a bowl of triangles stay in it and come to rest") { pour_into_bowl(500, 8); }
TEST_CASE("10 000 particles poured into a bowl of triangles stay in it and come to rest", "[.long]") {
    pour_into_bowl(10000, 8);
}
