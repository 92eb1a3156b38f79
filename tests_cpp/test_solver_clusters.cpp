// Rigid clusters: momenta, the compound pendulum, hinges, rest on supports and friction, against the laws of rigid
// bodies.
#include <ctime>

#include "snapshots.h"
#include "solver/cloth/best_rotation.h"

using namespace test;
using gphys::Mat3;
using gphys::Vec3;

namespace {

constexpr float frame = 1.0f / 60;
constexpr double g = static_cast<double>(9.81f);

gphys_cluster_id cluster(const World& world, gphys_body_id body, const std::vector<uint32_t>& particles) {
    gphys_cluster_id id = 0;
    REQUIRE(gphys_solver_add_cluster(world.solver, body, particles.data(), static_cast<uint32_t>(particles.size()),
                                     &id) == GPHYS_OK);
    return id;
}
std::vector<uint32_t> numbers(uint32_t first, uint32_t count) {
    std::vector<uint32_t> all;
    for (uint32_t i = 0; i < count; ++i) all.push_back(first + i);
    return all;
}

/// A flat plank along x: `count` pairs of particles, from a corner on.
std::vector<gphys_vec3> plank(gphys_vec3 corner, float length, float width, uint32_t count) {
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i < count; ++i) {
        const float x = corner.x + length * static_cast<float>(i) / static_cast<float>(count - 1);
        points.push_back({x, corner.y, corner.z});
        points.push_back({x, corner.y, corner.z + width});
    }
    return points;
}
std::vector<gphys_vec3> cube(gphys_vec3 centre, float side) {
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i < 8; ++i) {
        const auto at = [&](uint32_t bit) { return (i >> bit & 1 ? 0.5f : -0.5f) * side; };
        points.push_back({centre.x + at(0), centre.y + at(1), centre.z + at(2)});
    }
    return points;
}
gphys_body_id add(World& world, const std::vector<gphys_vec3>& points,
                  const gphys_body_desc& desc = World::body_desc()) {
    const gphys_body_id body = world.particles(points, desc);
    cluster(world, body, numbers(0, static_cast<uint32_t>(points.size())));
    return body;
}
void rotate(std::vector<gphys_vec3>& points, Vec3 about, const Mat3& rotation) {
    for (gphys_vec3& p : points) p = gphys::narrow(about + rotation * (gphys::widen(p) - about));
}

/// The largest change of a distance between two of the particles, relative to the largest distance.
double strain(const std::vector<gphys_vec3>& made, const std::vector<gphys_vec3>& now) {
    double worst = 0, size = 0;
    for (size_t i = 0; i < made.size(); ++i) {
        for (size_t j = 0; j < i; ++j) {
            const double rest = distance(gphys::widen(made[i]), gphys::widen(made[j]));
            worst = std::max(worst, std::fabs(distance(gphys::widen(now[i]), gphys::widen(now[j])) - rest));
            size = std::max(size, rest);
        }
    }
    return worst / size;
}

struct Motion {
    Vec3 momentum, spin;
};
/// Of particles of one mass, about the origin.
Motion motion(const World& world, gphys_body_id body) {
    const std::vector<gphys_vec3> at = world.positions(body), velocity = world.velocities(body);
    Motion sum;
    for (size_t p = 0; p < at.size(); ++p) {
        sum.momentum += gphys::widen(velocity[p]);
        sum.spin += cross(gphys::widen(at[p]), gphys::widen(velocity[p]));
    }
    return sum;
}
void spin(World& world, gphys_body_id body, Vec3 turning, Vec3 velocity) {
    const std::vector<gphys_vec3> at = world.positions(body);
    Vec3 centre;
    for (const gphys_vec3& p : at) centre += gphys::widen(p) / static_cast<double>(at.size());
    for (uint32_t p = 0; p < at.size(); ++p) {
        world.set_velocity(body, p, gphys::narrow(velocity + cross(turning, gphys::widen(at[p]) - centre)));
    }
}
double fastest(const World& world, gphys_body_id body) {
    double most = 0;
    for (const gphys_vec3& v : world.velocities(body)) most = std::max(most, length(gphys::widen(v)));
    return most;
}

Vec3 normal(Random& random) { return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; }
Mat3 rotation(Random& random) { return gphys::rotation_matrix(gphys::widen(random.rotation())); }

double misfit(const std::vector<Vec3>& p, const std::vector<Vec3>& q, const Mat3& rotation) {
    double sum = 0;
    for (size_t i = 0; i < p.size(); ++i) sum += length_squared(p[i] - rotation * q[i]);
    return sum;
}

/// Two boxes of 0.2 m.
void add_posts(World& world, float distance, float height) {
    for (const float x : {0.0f, distance}) {
        const gphys_obb post{{x, height / 2, 0}, {0.1f, height / 2, 0.5f}, {0, 0, 0, 1}};
        world.model(GPHYS_SHAPE_OBB, &post);
    }
}
void add_floor(World& world, gphys_vec3 normal = {0, 1, 0}) {
    const gphys_plane floor{normal, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
}

/// Seconds of an oscillation of a particle along x: between passages of its place of rest, in one direction.
double period_of_x(World& world, gphys_body_id body, uint32_t particle, double rest, double seconds) {
    double before = world.position(body, particle).x - rest, first = -1, last = -1;
    int passages = 0;
    for (int i = 1; i * static_cast<double>(frame) < seconds; ++i) {
        world.step(frame);
        const double now = world.position(body, particle).x - rest;
        if (before < 0 && now >= 0) {
            const double at = (i - now / (now - before)) * static_cast<double>(frame);
            if (first < 0) first = at;
            last = at;
            ++passages;
        }
        before = now;
    }
    REQUIRE(passages >= 3);
    return (last - first) / (passages - 1);
}

}  // namespace

TEST_CASE("the rotation of a cluster is the best of all, for solid, flat, straight and mirrored shapes") {
    Random random(5);
    for (int kind = 0; kind < 4; ++kind) {
        for (int k = 0; k < 50; ++k) {
            const Mat3 turned = rotation(random);
            const double noise = k % 2 ? 0.2 : 0;
            std::vector<Vec3> p, q;
            for (int i = 0; i < 8; ++i) {
                Vec3 rest = normal(random);
                if (kind == 1) rest.z = 0;
                if (kind == 2) rest = {rest.x, 0, 0};
                q.push_back(rest);
                if (kind == 3) rest.x = -rest.x;
                p.push_back(turned * rest + normal(random) * noise);
            }
            Mat3 covariance{{}, {}, {}};
            for (size_t i = 0; i < p.size(); ++i) {
                covariance.x += p[i] * q[i].x;
                covariance.y += p[i] * q[i].y;
                covariance.z += p[i] * q[i].z;
            }
            const Mat3 best = gphys::best_rotation(covariance);
            CHECK(length(cross(best.x, best.y) - best.z) < 1e-12);
            const double least = misfit(p, q, best);
            if (kind < 3 && noise == 0) CHECK(least < 1e-24);
            for (int other = 0; other < 40; ++other) {
                CHECK(misfit(p, q, rotation(random)) > least);
                const Vec3 by = normal(random) * 1e-3;
                const Mat3 near = gphys::rotation_matrix(gphys::Quat{by.x, by.y, by.z, 1}) * best;
                CHECK(misfit(p, q, near) > least - 1e-14);
            }
        }
    }
    const Mat3 nothing = gphys::best_rotation({{}, {}, {}});
    CHECK((nothing.x.x == 1 && nothing.y.y == 1 && nothing.z.z == 1));
}

TEST_CASE("a free plank keeps its momenta and its shape") {
    for (const uint32_t substeps : {8u, 60u}) {
        World world(substeps, {0, 0, 0});
        const std::vector<gphys_vec3> made = plank({-0.5f, 0, -0.1f}, 1, 0.2f, 6);
        const gphys_body_id body = add(world, made);
        spin(world, body, {1, 3, 2}, {0.5f, 0.25f, 0});
        const Motion before = motion(world, body);
        const double energy = world.energy();
        double worst = 0;
        for (int i = 0; i < 600; ++i) {
            world.step(frame);
            worst = std::max(worst, strain(made, world.positions(body)));
        }
        const Motion after = motion(world, body);
        figure("momentum", length(after.momentum - before.momentum) / length(before.momentum), "lost");
        figure("angular momentum", length(after.spin - before.spin) / length(before.spin), "lost");
        figure("strain", worst, "");
        figure("energy", world.energy() / energy - 1, "gained");
        CHECK(length(after.momentum - before.momentum) < 1e-3 * length(before.momentum));
        CHECK(length(after.spin - before.spin) < 1e-3 * length(before.spin));
        CHECK(worst < 2e-6);
        CHECK(world.energy() < energy * (1 + 1e-5));
        CHECK(world.energy() > energy * 0.98);
    }
}

TEST_CASE("a plank pinned at one end is a compound pendulum") {
    const uint32_t count = 11;
    for (const bool flat : {false, true}) {
        World world;
        // On a line it swings about a point, with two columns about an edge.
        const std::vector<gphys_vec3> made =
            flat ? plank({0, 0, 0}, 1, 0.2f, count) : line({0, 0, 0}, {0.1f, 0, 0}, count);
        std::vector<gphys_vec3> hanging = made;
        const double angle = 0.05;
        rotate(hanging, {},
               gphys::rotation_matrix(
                   gphys::Quat{0, 0, std::sin((angle - gphys::pi / 2) / 2), std::cos((angle - gphys::pi / 2) / 2)}));
        const gphys_body_id body = add(world, hanging);
        world.pin(body, 0);
        if (flat) world.pin(body, 1);
        double inertia = 0, moment = 0;
        for (const gphys_vec3& p : made) {
            const double arm = p.x;
            inertia += arm * arm;
            moment += arm;
        }
        const double theory = 2 * gphys::pi * std::sqrt(inertia / (g * moment));
        const double measured = period_of_x(world, body, static_cast<uint32_t>(made.size() - 1), 0, 20);
        figure("period", measured / theory, "of the law");
        CHECK(std::fabs(measured / theory - 1) < 0.01);
        CHECK(strain(made, world.positions(body)) < 1e-6);
        // Pins are rounded to floats relative to the middle of the body.
        CHECK(length(world.position(body, 0)) < 2e-6);
        if (flat) CHECK(distance(world.position(body, 1), {0, 0, static_cast<double>(0.2f)}) < 2e-6);
    }
}

TEST_CASE("a cluster turns about one pin, about the line through two, and not at all with three") {
    for (const uint32_t pins : {1u, 2u, 3u}) {
        World world;
        const std::vector<gphys_vec3> made = cube({0, 0, 0}, 1);
        const gphys_body_id body = add(world, made);
        for (uint32_t i = 0; i < pins; ++i) world.pin(body, i);
        spin(world, body, {0.5, 0.25, 1}, {0, 0, 0});
        const double before = world.energy();
        for (int i = 0; i < 300; ++i) {
            world.step(frame);
            CHECK(world.energy() < before + 1e-3 * (1 + std::fabs(before)));
        }
        CHECK(strain(made, world.positions(body)) < 1e-6);
        double moved = 0;
        for (uint32_t p = 0; p < 8; ++p) {
            const Vec3 was = gphys::widen(made[p]), is = world.position(body, p);
            moved = std::max(moved, distance(was, is));
            // Pins 0 and 1 are an edge along x.
            if (pins == 2) CHECK(std::fabs(is.x - was.x) < 2e-6);
            if (p < pins) CHECK(distance(was, is) < 2e-6);
        }
        CHECK((pins == 3 ? moved < 2e-6 : moved > 0.1));
    }
}

TEST_CASE("models that a cluster is attached to carry its weight, and its moment") {
    // One end of a plank in a wall, by three particles that are not on a line: the wall carries the rest.
    World world;
    const gphys_obb wall{{0, 0, 0}, {0.05f, 0.05f, 0.05f}, {0, 0, 0, 1}};
    const gphys_model_id model = world.model(GPHYS_SHAPE_OBB, &wall);
    gphys_body_desc desc = World::body_desc();
    desc.layers = 0;
    desc.mass = 12;
    const std::vector<gphys_vec3> made = plank({0, 0, -0.1f}, 1, 0.2f, 6);
    const gphys_body_id body = add(world, made, desc);
    for (const uint32_t p : {0u, 1u, 2u}) {
        REQUIRE(gphys_solver_attach(world.solver, world.scene, body, p, model, nullptr) == GPHYS_OK);
    }
    for (int i = 0; i < 60; ++i) world.step(frame);
    gphys_impulse given{};
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_impulses(world.solver, &given, 1, &total) == GPHYS_OK);
    // Also of the attached particles.
    const double weight = -12 * g * static_cast<double>(frame);
    CHECK(static_cast<double>(given.linear.y) == Approx(weight).epsilon(1e-4));
    CHECK(static_cast<double>(given.angular.z) == Approx(weight / 2).epsilon(1e-4));
    CHECK(std::fabs(given.angular.x) < 1e-4f);
    CHECK(std::fabs(given.angular.y) < 1e-3f);
    CHECK(std::fabs(given.linear.x) + std::fabs(given.linear.z) < 1e-3f);
}

TEST_CASE("a cluster follows the model that it is attached to") {
    World world;
    const gphys_obb box{{0, 0, 0}, {0.05f, 0.05f, 0.05f}, {0, 0, 0, 1}};
    const gphys_model_id model = world.model(GPHYS_SHAPE_OBB, &box);
    gphys_body_desc desc = World::body_desc();
    desc.layers = 0;
    const std::vector<gphys_vec3> made = cube({0.5f, 0, 0}, 1);
    const gphys_body_id body = add(world, made, desc);
    for (const uint32_t p : {0u, 2u, 4u}) {
        REQUIRE(gphys_solver_attach(world.solver, world.scene, body, p, model, nullptr) == GPHYS_OK);
    }
    for (int i = 1; i <= 60; ++i) {
        const double angle = 0.02 * i;
        const gphys_transform turned{
            {0.01f * static_cast<float>(i), 0, 0},
            {0, static_cast<float>(std::sin(angle / 2)), 0, static_cast<float>(std::cos(angle / 2))},
            1};
        REQUIRE(gphys_scene_set_transform(world.scene, model, &turned) == GPHYS_OK);
        world.step(frame);
        const gphys::Transform wanted = gphys::widen(turned);
        for (uint32_t p = 0; p < 8; ++p) {
            CHECK(distance(world.position(body, p), wanted.apply(gphys::widen(made[p]))) < 2e-6);
        }
    }
}

TEST_CASE("a plank rests level on two posts") {
    World world;
    add_posts(world, 1.8f, 0.5f);
    add_floor(world);
    const std::vector<gphys_vec3> made = plank({-0.1f, 0.56f, -0.1f}, 2, 0.2f, 21);
    const gphys_body_id body = add(world, made, point_mass(0.02f, 0.5f, 0));
    for (int i = 0; i < 300; ++i) world.step(frame);
    double lowest = 1, highest = 0;
    for (const gphys_vec3& p : world.positions(body)) {
        lowest = std::min<double>(lowest, p.y);
        highest = std::max<double>(highest, p.y);
    }
    figure("sag", highest - lowest, "m");
    figure("height above the posts", (lowest + highest) / 2 - 0.52, "m");
    figure("speed", fastest(world, body), "m/s");
    // What friction holds may be above a plane by g h^2, 0.04 mm, at each post.
    CHECK(strain(made, world.positions(body)) < 1e-6);
    CHECK(highest - lowest < 2e-4);
    CHECK(std::fabs((lowest + highest) / 2 - 0.52) < 1e-4);
    CHECK(fastest(world, body) < 1e-4);
    // The posts carry the weight.
    gphys_impulse given[2];
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_impulses(world.solver, given, 2, &total) == GPHYS_OK);
    REQUIRE(total == 2);
    // By the law of the lever, wherever on its post it lies.
    const double weight = -g * static_cast<double>(frame), first = given[0].linear.y, second = given[1].linear.y;
    CHECK(first + second == Approx(weight).epsilon(1e-3));
    CHECK((first / weight > 0.8 / 1.8 && second / weight > 0.8 / 1.8));
}

TEST_CASE("a plank pushed over the edge of a table falls when its middle is beyond it") {
    for (const float beyond : {-0.1f, 0.1f}) {
        World world;
        const gphys_obb table{{-2, -0.5f, 0}, {2, 0.5f, 1}, {0, 0, 0, 1}};
        world.model(GPHYS_SHAPE_OBB, &table);
        const gphys_body_id body =
            add(world, plank({beyond - 0.5f, 0.02f, -0.1f}, 1, 0.2f, 21), point_mass(0.02f, 0.5f, 0));
        for (int i = 0; i < 120; ++i) world.step(frame);
        const double height = world.position(body, 41).y;
        figure("height of the end", height, "m");
        CHECK((beyond < 0 ? std::fabs(height - 0.02) < 1e-4 : height < -0.5));
    }
}

TEST_CASE("a cube tumbles onto a floor and comes to rest on a face") {
    for (const uint64_t seed : {1u, 2u, 3u, 4u}) {
        Random random(seed);
        World world;
        add_floor(world);
        std::vector<gphys_vec3> made = cube({0, 1, 0}, 0.3f);
        rotate(made, {0, 1, 0}, rotation(random));
        const gphys_body_id body = add(world, made, point_mass(0.02f, 0.4f, 0));
        spin(world, body, random.direction() * 5, {1, 0, 0.5});
        double worst = 0;
        for (int i = 0; i < 480; ++i) {
            world.step(frame);
            worst = std::max(worst, strain(made, world.positions(body)));
        }
        std::vector<double> heights;
        for (const gphys_vec3& p : world.positions(body)) heights.push_back(p.y);
        std::sort(heights.begin(), heights.end());
        figure("strain", worst, "");
        figure("speed at rest", fastest(world, body), "m/s");
        CHECK(std::fabs(heights[0] - 0.02) < 1e-4);
        CHECK(std::fabs(heights[3] - 0.02) < 1e-4);
        CHECK(std::fabs(heights[4] - 0.32) < 1e-4);
        CHECK(std::fabs(heights[7] - 0.32) < 1e-4);
        CHECK(fastest(world, body) < 1e-3);
        CHECK(worst < 0.05);
    }
}

TEST_CASE("a crate holds on a slope, or slides by Coulomb's law") {
    const double slope = 20 * gphys::pi / 180;
    for (const float friction : {0.5f, 0.2f, 0.0f}) {
        World world;
        const gphys_vec3 up{static_cast<float>(std::sin(slope)), static_cast<float>(std::cos(slope)), 0};
        add_floor(world, up);
        std::vector<gphys_vec3> made = cube({0, 0.12f, 0}, 0.2f);
        rotate(made, {}, gphys::rotation_matrix(gphys::Quat{0, 0, -std::sin(slope / 2), std::cos(slope / 2)}));
        const gphys_body_id body = add(world, made, point_mass(0.02f, friction, 0));
        const Vec3 start = world.position(body);
        for (int i = 0; i < 120; ++i) world.step(frame);
        const double way = distance(world.position(body), start);
        const double law = 2 * g * (std::sin(slope) - static_cast<double>(friction) * std::cos(slope));
        figure("way", way, "m");
        if (friction == 0.5f) {
            CHECK(way < 1e-4);
        } else {
            CHECK(way == Approx(law).epsilon(0.02));
        }
        CHECK(strain(made, world.positions(body)) < 1e-4);
    }
}

TEST_CASE("planks that share two particles are hinged there") {
    World world;
    const std::vector<gphys_vec3> made = plank({0, 0, -0.1f}, 2, 0.2f, 9);
    const gphys_body_id body = world.particles(made);
    cluster(world, body, numbers(0, 10));
    cluster(world, body, numbers(8, 10));
    world.pin(body, 0);
    world.pin(body, 1);
    const double before = world.energy();
    double worst = 0, most = before, folded = 4;
    for (int i = 0; i < 600; ++i) {
        world.step(frame);
        const std::vector<gphys_vec3> now = world.positions(body);
        for (const size_t first : {size_t{0}, size_t{8}}) {
            const auto part = [&](const std::vector<gphys_vec3>& all) {
                return std::vector<gphys_vec3>(all.begin() + static_cast<int>(first),
                                               all.begin() + static_cast<int>(first) + 10);
            };
            worst = std::max(worst, strain(part(made), part(now)));
        }
        most = std::max(most, world.energy());
        folded = std::min(folded, distance(world.position(body, 0), world.position(body, 16)));
    }
    figure("strain", worst, "");
    figure("energy", most - before, "J gained");
    figure("nearest ends", folded, "m");
    CHECK(worst < 5e-3);
    CHECK(most < before + 1e-3);
    CHECK(folded < 1.9);
}

TEST_CASE("a mattress of clusters that share particles lies on a slope for little more time than it flies",
          "[simulation]") {
    // Cubes of 27 particles with faces in common: 9 x 3 x 13 particles.
    constexpr uint32_t wide = 9, high = 3, deep = 13;
    std::vector<gphys_vec3> made;
    for (uint32_t z = 0; z < deep; ++z) {
        for (uint32_t y = 0; y < high; ++y) {
            for (uint32_t x = 0; x < wide; ++x)
                made.push_back({0.1f * static_cast<float>(x), 0.045f + 0.1f * static_cast<float>(y),
                                0.1f * static_cast<float>(z)});
        }
    }
    const gphys_vec3 down_the_slope{9.81f * std::sin(0.3f), -9.81f * std::cos(0.3f), 0};
    double least_time[2] = {1, 1};
    for (const bool lies : {false, true}) {
        World world(8, down_the_slope);
        if (lies) add_floor(world);
        const gphys_body_id body = world.particles(made, point_mass(0.045f, 15, 0.5f));
        for (uint32_t z = 0; z + 2 < deep; z += 2) {
            for (uint32_t x = 0; x + 2 < wide; x += 2) {
                std::vector<uint32_t> cube;
                for (uint32_t i = 0; i < 27; ++i) cube.push_back(((z + i / 9) * high + i / 3 % 3) * wide + x + i % 3);
                cluster(world, body, cube);
            }
        }
        for (int i = 0; i < 60; ++i) {
            const std::clock_t begin = std::clock();
            world.step(frame);
            least_time[lies] = std::min(least_time[lies], static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        }
        if (lies) CHECK(distance(gphys::widen(made[0]), world.position(body, 0)) < 1e-4);
        CHECK(strain(made, world.positions(body)) < 1e-5);
    }
    figure("in the air", least_time[0] * 1e3, "ms a step");
    figure("on the slope", least_time[1] * 1e3, "ms a step");
    CHECK(least_time[1] < 8 * least_time[0]);
}

TEST_CASE("a cluster alone holds a lattice whose links are gone") {
    World world;
    add_floor(world);
    const gphys_body_id body = world.cloth({0, 0.5f, 0}, {1, 0, 0}, {0, 0.2f, 1}, 5, 5, point_mass(0.02f, 0.4f, 0));
    const std::vector<gphys_vec3> made = world.positions(body);
    cluster(world, body, numbers(0, 25));
    gphys_body_info info{};
    REQUIRE(gphys_solver_get_body_info(world.solver, body, &info) == GPHYS_OK);
    std::vector<gphys_constraint_info> links(info.constraint_count);
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_constraints(world.solver, body, links.data(), info.constraint_count, &total) == GPHYS_OK);
    world.step(frame);
    for (const gphys_constraint_info& link : links) {
        REQUIRE(gphys_solver_remove_constraint(world.solver, body, link.id) == GPHYS_OK);
    }
    REQUIRE(gphys_solver_get_body_info(world.solver, body, &info) == GPHYS_OK);
    CHECK((info.constraint_count == 0 && info.method == GPHYS_SOLVE_GRAPH));
    for (int i = 0; i < 240; ++i) world.step(frame);
    CHECK(strain(made, world.positions(body)) < 1e-4);
    for (const gphys_vec3& p : world.positions(body)) CHECK(std::fabs(p.y - 0.02f) < 1e-4f);
}

TEST_CASE("a cluster keeps its place in memory, in snapshots and among ids") {
    World world, other;
    const gphys_body_id body = world.particles(cube({0, 1, 0}, 0.3f));
    add_floor(world);
    add_floor(other);
    const gphys_cluster_id first = cluster(world, body, {3, 1, 2}), second = cluster(world, body, {0, 1, 4, 5});
    CHECK(first < second);
    for (int i = 0; i < 40; ++i) {
        world.step(frame);
        if (i == 20) REQUIRE(gphys_solver_remove_cluster(world.solver, body, first) == GPHYS_OK);
        REQUIRE(restore(other.solver, snapshot(world.solver)) == GPHYS_OK);
        CHECK(hash(other.solver) == hash(world.solver));
        world.step(frame);
        other.step(frame);
        REQUIRE(hash(other.solver) == hash(world.solver));
    }
    uint32_t particles[8], total = 0;
    REQUIRE(gphys_solver_get_cluster_particles(other.solver, body, second, particles, 8, &total) == GPHYS_OK);
    CHECK((total == 4 && particles[0] == 0 && particles[1] == 1 && particles[2] == 4 && particles[3] == 5));
    // An id that is gone stays so after the last cluster, and in another solver.
    REQUIRE(gphys_solver_remove_cluster(world.solver, body, second) == GPHYS_OK);
    REQUIRE(restore(other.solver, snapshot(world.solver)) == GPHYS_OK);
    CHECK(gphys_solver_remove_cluster(other.solver, body, first) == GPHYS_ERROR_INVALID_ID);
    CHECK(gphys_solver_remove_cluster(other.solver, body, second) == GPHYS_ERROR_INVALID_ID);
    CHECK(cluster(world, body, {0, 1}) == cluster(other, body, {0, 1}));
    CHECK(hash(other.solver) == hash(world.solver));
}

TEST_CASE("without its clusters a body is what it was") {
    World world, other;
    for (World* const each : {&world, &other}) each->particles(line({0, 1, 0}, {0.5f, 0, 0}, 4));
    const gphys_body_id body = 1u << 24;
    gphys_body_info info{};
    const gphys_cluster_id id = cluster(world, body, {0, 1, 2});
    REQUIRE(gphys_solver_get_body_info(world.solver, body, &info) == GPHYS_OK);
    CHECK(info.method == GPHYS_SOLVE_GRAPH);
    REQUIRE(gphys_solver_remove_cluster(world.solver, body, id) == GPHYS_OK);
    REQUIRE(gphys_solver_get_body_info(world.solver, body, &info) == GPHYS_OK);
    CHECK(info.method == GPHYS_SOLVE_FREE);
    world.step(frame);
    other.step(frame);
    CHECK(world.position(body) == other.position(body));
}

TEST_CASE("clusters have the same bits from any number of workers", "[simulation]") {
    uint64_t expected = 0;
    for (const uint32_t workers : {1u, 2u, 3u, 4u}) {
        gphys_solver_desc desc = World::desc();
        desc.worker_count = workers;
        World world(desc);
        add_floor(world);
        Random random(9);
        for (int i = 0; i < 12; ++i) {
            const float x = static_cast<float>(i);
            std::vector<gphys_vec3> made = cube({x, 1, 0}, 0.3f);
            rotate(made, {static_cast<double>(x), 1, 0}, rotation(random));
            const gphys_body_id body = add(world, made, point_mass(0.02f, 0.4f, 0.2f));
            cluster(world, body, {0, 1, 2});
        }
        for (int i = 0; i < 90; ++i) world.step(frame);
        if (workers == 1) expected = hash(world.solver);
        CHECK(hash(world.solver) == expected);
    }
}

TEST_CASE("a cluster at rest sleeps, and wakes when another is added") {
    gphys_solver_desc desc = World::desc();
    desc.sleep_speed = 0.01f;
    desc.sleep_time = 0.5f;
    World world(desc);
    add_floor(world);
    const gphys_body_id body = add(world, cube({0, 0.2f, 0}, 0.3f), point_mass(0.02f, 0.4f, 0));
    const auto sleepers = [&] {
        uint32_t total = 9;
        REQUIRE(gphys_solver_get_sleeping(world.solver, nullptr, 0, &total) >= GPHYS_OK);
        return total;
    };
    for (int i = 0; i < 240; ++i) world.step(frame);
    CHECK(sleepers() == 1);
    const gphys_cluster_id id = cluster(world, body, {0, 1});
    CHECK(sleepers() == 0);
    for (int i = 0; i < 120; ++i) world.step(frame);
    CHECK(sleepers() == 1);
    REQUIRE(gphys_solver_remove_cluster(world.solver, body, id) == GPHYS_OK);
    CHECK(sleepers() == 0);
}

TEST_CASE("a bridge of planks between two ropes carries itself") {
    // Two ropes, pinned at their ends; a plank across every other pair of particles, of three particles more.
    const uint32_t pairs = 21;
    World world;
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i < pairs; ++i) {
        for (uint32_t k = 0; k < 5; ++k) {
            points.push_back({0.2f * static_cast<float>(i), 2, 0.25f * static_cast<float>(k)});
        }
    }
    const gphys_body_id body = world.particles(points);
    gphys_constraint_id ignored = 0;
    for (uint32_t i = 0; i < pairs; ++i) {
        for (const uint32_t side : {0u, 4u}) {
            if (i + 1 < pairs) {
                REQUIRE(gphys_solver_add_distance(world.solver, body, 5 * i + side, 5 * i + 5 + side, 0.21f, 0,
                                                  &ignored) == GPHYS_OK);
            }
            if (i == 0 || i + 1 == pairs) world.pin(body, 5 * i + side);
        }
        cluster(world, body, numbers(5 * i, 5));
    }
    double worst = 0, bent = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(frame);
        if (i < 300) continue;
        worst = std::max<double>(worst, world.stats().strain_max);
        const std::vector<gphys_vec3> now = world.positions(body);
        for (uint32_t k = 0; k < pairs; ++k) {
            const auto part = [&](const std::vector<gphys_vec3>& all) {
                return std::vector<gphys_vec3>(all.begin() + 5 * k, all.begin() + 5 * k + 5);
            };
            bent = std::max(bent, strain(part(points), part(now)));
        }
    }
    figure("strain of the ropes", worst, "");
    figure("bending of the planks", bent, "");
    figure("speed", fastest(world, body), "m/s");
    CHECK(worst < 0.02);
    CHECK(bent < 1e-2);
}

TEST_CASE("a wheel on an axle keeps its energy") {
    for (const uint32_t substeps : {8u, 32u}) {
        for (const float speed : {5.0f, 60.0f}) {  // rad/s
            World world(substeps, {0, 0, 0});
            std::vector<gphys_vec3> points{{0, 0, -0.1f}, {0, 0, 0.1f}};
            for (int i = 0; i < 16; ++i) {
                const double angle = i * gphys::pi / 8;
                points.push_back(
                    {static_cast<float>(0.3 * std::cos(angle)), static_cast<float>(0.3 * std::sin(angle)), 0});
            }
            const gphys_body_id wheel = add(world, points);
            world.pin(wheel, 0);
            world.pin(wheel, 1);
            for (uint32_t p = 2; p < 18; ++p)
                world.set_velocity(wheel, p, {-speed * points[p].y, speed * points[p].x, 0});
            world.step(frame);  // in which the time scheme starts
            const double before = world.stats(wheel).kinetic_energy;
            for (int i = 0; i < 600; ++i) world.step(frame);
            const double left = world.stats(wheel).kinetic_energy / before;
            INFO(substeps << " substeps, " << speed << " rad/s: " << left);
            CHECK(std::fabs(left - 1) < 1e-3);
        }
    }
}

TEST_CASE("a plank on a hinge swings as high as it fell, and less with damping") {
    for (const float damping : {0.0f, 0.3f}) {
        World world(8);
        gphys_body_desc desc = World::body_desc();
        desc.damping = damping;
        const gphys_body_id body = add(world, plank({0, 0, 0}, 1, 0.2f, 6), desc);
        world.pin(body, 0);
        world.pin(body, 1);
        double highest = -1;  // of the free end, in the last of twenty seconds
        for (int i = 0; i < 1200; ++i) {
            world.step(frame);
            if (i > 1080) highest = std::max(highest, world.position(body, 11).y);
        }
        INFO("damping " << damping << ": " << highest);
        if (damping == 0) {
            CHECK(std::fabs(highest) < 5e-3);
        } else {
            // An amplitude of a quarter turn becomes one of some 0.05 rad: 1 - cos of it is 0.002.
            CHECK(highest < -0.98);
        }
    }
}

TEST_CASE("a hoop that slides and rolls has the friction of Coulomb's law") {
    for (const int around : {16, 64}) {
        for (const float friction : {0.05f, 0.1f}) {
            // A slope of 0.3 rad as gravity that leans; it takes more than twice the friction to roll only.
            const float g = 9.81f, tilt = 0.3f;
            World world(8, {g * std::sin(tilt), -g * std::cos(tilt), 0});
            const gphys_aabb box{{-5, -1, -5}, {50, 0, 5}};
            world.model(GPHYS_SHAPE_AABB, &box);
            gphys_body_desc desc = World::body_desc();
            desc.friction = friction;
            desc.radius = 0.02f;
            std::vector<gphys_vec3> points;
            for (const float z : {0.0f, 0.2f}) {
                for (int i = 0; i < around; ++i) {
                    const double angle = 2 * gphys::pi * i / around;
                    points.push_back({static_cast<float>(0.3 * std::cos(angle)),
                                      static_cast<float>(0.32 + 0.3 * std::sin(angle)), z});
                }
            }
            add(world, points, desc);
            Vec3 sum;
            for (int i = 0; i < 120; ++i) {
                world.step(frame);
                gphys_impulse impulse{};
                uint32_t total = 0;
                REQUIRE(gphys_solver_get_impulses(world.solver, &impulse, 1, &total) == GPHYS_OK);
                sum += gphys::widen(impulse.linear);
            }
            const double ratio = sum.x / -sum.y;
            INFO("hoop of " << around << ", friction " << friction << ": " << ratio);
            CHECK(std::fabs(ratio / static_cast<double>(friction) - 1) < 0.02);
        }
    }
}
