// What bodies give to models, against the balance of momentum.
#include <cstring>

#include "resources.h"
#include "solver_world.h"

using namespace test;
using gphys::Vec3;

namespace {

constexpr double g = static_cast<double>(9.81f);
constexpr float frame = 1 / 60.0f;

gphys_transform placed(float x, float y, float z) {
    gphys_transform transform{};
    transform.position = {x, y, z};
    transform.rotation.w = 1;
    transform.scale = 1;
    return transform;
}

gphys_model_id ground(World& world, gphys_vec3 normal = {0, 1, 0}) {
    const gphys_plane plane{normal, 0};
    return world.model(GPHYS_SHAPE_PLANE, &plane);
}

gphys_model_id ball(World& world, float x, float y, float z) {
    const gphys_sphere sphere{{0, 0, 0}, 0.05f};
    const gphys_transform transform = placed(x, y, z);
    return world.model(GPHYS_SHAPE_SPHERE, &sphere, &transform);
}

Vec3 linear(const World& world, gphys_model_id model) {
    for (const gphys_impulse& impulse : impulses(world)) {
        if (impulse.model == model) return gphys::widen(impulse.linear);
    }
    return {};
}

Vec3 angular(const World& world, gphys_model_id model) {
    for (const gphys_impulse& impulse : impulses(world)) {
        if (impulse.model == model) return gphys::widen(impulse.angular);
    }
    return {};
}

/// A particle, a rope or a sheet of 3 kg that lies on the ground.
gphys_body_id lay(World& world, gphys_body_kind kind, float height = 0.0101f) {
    gphys_body_desc desc = World::body_desc();
    desc.mass = 3;
    if (kind == GPHYS_BODY_CLOTH) return world.cloth({1, height, 1}, {1, 0, 0}, {0, 0, 1}, 15, 15, desc);
    std::vector<gphys_vec3> places;
    for (int i = 0; i < 30; ++i) places.push_back({0.05f * static_cast<float>(i), height, 0});
    return kind == GPHYS_BODY_ROPE ? world.rope(places, 0, desc) : world.particles(places, desc);
}

}  // namespace

TEST_CASE("What lies on the ground presses it with its weight") {
    for (const gphys_body_kind kind : {GPHYS_BODY_PARTICLES, GPHYS_BODY_ROPE, GPHYS_BODY_CLOTH}) {
        for (const float height : {0.0101f, 0.4f}) {
            World world(8);
            const gphys_model_id floor = ground(world);
            lay(world, kind, height);
            double worst = 0;
            for (int i = 0; i < 180; ++i) {
                world.step(frame);
                if (i >= 120) worst = std::max(worst, length(linear(world, floor) - Vec3{0, -3 * g * frame, 0}));
            }
            std::printf("    kind %d from %.2f m: off by %.3g of %.3g N s\n", kind, static_cast<double>(height), worst,
                        3 * g * frame);
            // At rest what comes is what gravity has given. The answer is a float32.
            CHECK(worst < 1e-6 * 3 * g * frame);
        }
    }
}

TEST_CASE("What falls gives the ground all of its momentum") {
    for (const gphys_body_kind kind : {GPHYS_BODY_PARTICLES, GPHYS_BODY_ROPE, GPHYS_BODY_CLOTH}) {
        World world(8);
        const gphys_model_id floor = ground(world);
        lay(world, kind, 0.5f);
        Vec3 sum;
        const int steps = 120;
        for (int i = 0; i < steps; ++i) {
            world.step(frame);
            sum += linear(world, floor);
        }
        const Vec3 whole{0, -3 * g * frame * steps, 0};
        std::printf("    kind %d: %.6g of %.6g N s\n", kind, sum.y, whole.y);
        // From rest to rest it is the whole impulse of gravity. Each of 960 substeps rounds the velocities of
        // cloth, of 3 m/s at most, to 2^-24 of them.
        CHECK(length(sum - whole) < 2e-5 * length(whole));
    }
}

TEST_CASE("In every step momentum goes to models as it leaves what drapes over them") {
    for (const gphys_body_kind kind : {GPHYS_BODY_ROPE, GPHYS_BODY_CLOTH}) {
        World world(8);
        ground(world);
        const gphys_sphere post{{0.7f, 0.6f, 0}, 0.3f};
        world.model(GPHYS_SHAPE_SPHERE, &post);
        gphys_body_desc desc = World::body_desc();
        desc.mass = 3;
        std::vector<gphys_vec3> places;
        for (int i = 0; i < 40; ++i) places.push_back({0.05f * static_cast<float>(i), 1.1f, 0.01f});
        const gphys_body_id body = kind == GPHYS_BODY_ROPE
                                       ? world.rope(places, 0, desc)
                                       : world.cloth({0, 1.1f, -0.6f}, {1.5f, 0, 0}, {0, 0, 1.2f}, 16, 13, desc);
        const auto momentum = [&] {
            const std::vector<gphys_vec3> velocities = world.velocities(body);
            Vec3 sum;
            for (const gphys_vec3& v : velocities)
                sum += gphys::widen(v) * (3.0 / static_cast<double>(velocities.size()));
            return sum;
        };
        Vec3 before = momentum();
        double worst = 0, most = 0;
        for (int i = 0; i < 120; ++i) {
            world.step(frame);
            Vec3 given;
            for (const gphys_impulse& impulse : impulses(world)) given += gphys::widen(impulse.linear);
            const Vec3 after = momentum(), missing = before + Vec3{0, -3 * g * frame, 0} - after - given;
            worst = std::max(worst, length(missing));
            most = std::max(most, length(given));
            before = after;
        }
        std::printf("    kind %d: %.3g N s missing at most, of %.3g that a step gave\n", kind, worst, most);
        // What Newton's method leaves of a whipping rope after four iterations, and float32 of cloth.
        CHECK(worst < 5e-4 * most);
    }
}

TEST_CASE("A bounce gives m (1 + e) v") {
    World world(8);
    const gphys_model_id floor = ground(world);
    gphys_body_desc desc = World::body_desc();
    desc.mass = 2;
    desc.radius = 0;
    desc.restitution = 0.75f;
    world.particles({{0.5f, 1, 0.25f}}, desc);
    const double fall = std::sqrt(2 / g);
    for (int i = 0; i * frame < fall; ++i) world.step(frame);
    const double expected = 2 * 1.75 * g * fall;
    figure("impulse of a bounce, relative error", std::fabs(linear(world, floor).y / -expected - 1), "");
    CHECK(std::fabs(linear(world, floor).y / -expected - 1) < 1e-6);
    // r x J about the floor's position, the origin, with r = (0.5, 0, 0.25).
    CHECK(length(angular(world, floor) - Vec3{0.25 * expected, 0, -0.5 * expected}) < 1e-6 * expected);
}

TEST_CASE("Friction gives a slope what it takes") {
    // tan = 0.75: what slides with 0.25 presses with m g cos and drags with a quarter of that.
    World world(8);
    const gphys_model_id slope = ground(world, {0.6f, 0.8f, 0});
    for (const gphys_body_kind kind : {GPHYS_BODY_PARTICLES, GPHYS_BODY_ROPE, GPHYS_BODY_CLOTH}) {
        gphys_body_desc desc = World::body_desc();
        desc.mass = 1.5f;
        desc.friction = 0.25f;
        gphys_body_id body = 0;
        const auto on_slope = [](double along, double across) {
            const Vec3 at = Vec3{0.6, 0.8, 0} * 0.010002 + Vec3{0.8, -0.6, 0} * along + Vec3{0, 0, across};
            return gphys::narrow(at);
        };
        if (kind == GPHYS_BODY_PARTICLES) body = world.particles({on_slope(0, 0), on_slope(0.5, 0)}, desc);
        if (kind == GPHYS_BODY_ROPE) body = world.rope({on_slope(0, 0), on_slope(0.5, 0), on_slope(1, 0)}, 0, desc);
        if (kind == GPHYS_BODY_CLOTH) body = world.cloth(on_slope(0, 0), {0.8f, -0.6f, 0}, {0, 0, 1}, 9, 9, desc);
        for (uint32_t p = 0; p < world.positions(body).size(); ++p) world.set_velocity(body, p, {0.8f, -0.6f, 0});
        Vec3 sum;
        for (int i = 0; i < 60; ++i) {
            world.step(frame);
            if (i >= 30) sum += linear(world, slope);
        }
        sum = sum / 30.0;
        const double press = 1.5 * g * 0.8 * frame;
        const double into = -dot(sum, Vec3{0.6, 0.8, 0}), along = dot(sum, Vec3{0.8, -0.6, 0});
        std::printf("    kind %d: presses with %.6g, drags with %.6g of %.6g N s\n", kind, into, along, press);
        // Cloth in float32 is pushed by 5e-5 m in a substep, rounded to 6e-8 m, from which friction is reckoned.
        const double tolerance = kind == GPHYS_BODY_CLOTH ? 1e-2 : 1e-4;
        CHECK(std::fabs(into / press - 1) < tolerance);
        CHECK(std::fabs(along / (0.25 * press) - 1) < tolerance);
        REQUIRE(gphys_solver_remove_body(world.solver, body) == GPHYS_OK);
        CHECK(impulses(world).empty());
    }
}

TEST_CASE("What hangs pulls its models with its weight") {
    for (const bool is_cloth : {false, true}) {
        World world(8);
        const gphys_model_id left = ball(world, 0, 5, 0), right = ball(world, 1, 5, 0);
        gphys_body_desc desc = World::body_desc();
        desc.mass = 2;
        desc.layers = 0;
        desc.damping = 1;
        gphys_body_id body = 0;
        uint32_t last = 0;
        if (is_cloth) {
            body = world.cloth({0, 5, 0}, {1, 0, 0}, {0, -1, 0}, 11, 11, desc);
            last = 10;
        } else {
            std::vector<gphys_vec3> places;
            for (int i = 0; i <= 20; ++i) places.push_back({0.05f * static_cast<float>(i), 5, 0});
            body = world.rope(places, 0.06f, desc);
            last = 20;
        }
        REQUIRE(gphys_solver_attach(world.solver, world.scene, body, 0, left, nullptr) == GPHYS_OK);
        REQUIRE(gphys_solver_attach(world.solver, world.scene, body, last, right, nullptr) == GPHYS_OK);
        for (int i = 0; i < 1800; ++i) world.step(frame);
        const Vec3 a = linear(world, left), b = linear(world, right);
        std::printf("    %s: %.6g + %.6g of %.6g N s, across %.3g\n", is_cloth ? "cloth" : "rope", a.y, b.y,
                    -2 * g * frame, a.x);
        // After 30 s with a rate of 1/s nothing moves; half of the weight each, and as much across.
        CHECK(std::fabs(a.y + b.y + 2 * g * frame) < 2e-4 * 2 * g * frame);
        CHECK(std::fabs(a.y - b.y) < 1e-2 * 2 * g * frame);
        CHECK(a.x > 0);
        CHECK(std::fabs(a.x + b.x) < 1e-3 * 2 * g * frame);
    }
}

// Its links along the edge have lengths that rounding makes wrong, and nothing between them can give way.
TEST_CASE("A flag pulls the pole that holds its edge with its weight", "[simulation]") {
    for (const uint32_t flags : {0u, uint32_t{GPHYS_CLOTH_SHEAR | GPHYS_CLOTH_BEND}}) {
        for (const bool is_joined : {false, true}) {
            for (const bool touches : {false, true}) {
                World world(8);
                const gphys_model_id pole = ball(world, 0, 0, 0);
                const gphys_plane wall{{0, 0.1f, 1}, -0.01f};
                if (touches) world.model(GPHYS_SHAPE_PLANE, &wall);
                gphys_body_desc desc = World::body_desc();
                desc.mass = 2;
                desc.damping = 2;
                desc.friction = 0;
                desc.cloth_flags = flags;
                const gphys_body_id flag =
                    world.cloth({0.06f, 5.1f, 0.03f}, {0.7f, 0, 0.1f}, {0, -1.1f, 0.37f}, 7, 12, desc);
                for (uint32_t row = 0; row < 12; ++row) {
                    REQUIRE(gphys_solver_attach(world.solver, world.scene, flag, 7 * row, pole, nullptr) == GPHYS_OK);
                }
                double weight = 2;
                if (is_joined) {
                    desc.mass = 1;
                    const gphys_body_id tassel = world.rope({{0.76f, 4, 0.5f}, {0.76f, 3.9f, 0.5f}}, 0, desc);
                    gphys_joint_id joint = 0;
                    REQUIRE(gphys_solver_join(world.solver, flag, 83, tassel, 0, 0, 0, &joint) == GPHYS_OK);
                    weight += 1;
                }
                Vec3 sum{};
                for (int i = 0; i < 900; ++i) {
                    world.step(frame);
                    if (i < 840) continue;
                    for (const gphys_impulse& impulse : impulses(world)) sum = sum + gphys::widen(impulse.linear);
                }
                INFO(flags << ' ' << is_joined << ' ' << touches);
                CHECK(length(sum - Vec3{0, -weight * g, 0}) < 5e-3 * weight * g);
            }
        }
    }
}

// Whatever relaxation, limits of the energy and settling do to the velocities.
TEST_CASE("Attached cloth gives its models in each step what its own momentum lacks") {
    for (const uint32_t substeps : {1u, 2u, 8u}) {
        for (const bool is_gathered : {false, true}) {
            for (const uint32_t models : {1u, 2u}) {
                World world(substeps);
                const gphys_model_id left = ball(world, -0.5f, 2, 0.01f),
                                     right = models == 2 ? ball(world, 0.5f, 2.1f, 0) : left;
                gphys_body_desc desc = World::body_desc();
                desc.layers = 0;
                desc.mass = 2;
                const gphys_body_id body = world.cloth({-0.5f, 2, 0}, {1, 0, 0}, {0, -0.6f, 0.3f}, 21, 11, desc);
                std::vector<gphys_vec3> at = world.positions(body);
                for (gphys_vec3& place : at) place.x *= is_gathered ? 0.9f : 1.0f;
                REQUIRE(gphys_solver_set_positions(world.solver, body, 0, 21 * 11, at.data(), 12) == GPHYS_OK);
                for (uint32_t p = 0; p < 21; p += 2) {
                    REQUIRE(gphys_solver_attach(world.solver, world.scene, body, p, p < 10 ? left : right, nullptr) ==
                            GPHYS_OK);
                }
                const double mass = 2.0 / (21 * 11), weight = 2 * g * double{frame};
                struct Momentum {
                    Vec3 linear, angular, first_moment;
                };
                const auto momentum = [&] {
                    const std::vector<gphys_vec3> place = world.positions(body), speed = world.velocities(body);
                    Momentum sum{};
                    for (size_t p = 0; p < place.size(); ++p) {
                        const Vec3 x = gphys::widen(place[p]), of = gphys::widen(speed[p]) * mass;
                        sum.linear += of, sum.angular += cross(x, of), sum.first_moment += x * mass;
                    }
                    return sum;
                };
                const auto place_of = [&](gphys_model_id model) {
                    return model == left ? Vec3{-0.5, 2, 0.01} : Vec3{0.5, 2.1, 0};
                };
                double worst = 0, worst_moment = 0;
                for (int i = 0; i < 60; ++i) {
                    const Momentum before = momentum();
                    world.step(frame);
                    const Momentum after = momentum();
                    Vec3 sum, moment;
                    for (const gphys_impulse& impulse : impulses(world)) {
                        sum += gphys::widen(impulse.linear);
                        moment += gphys::widen(impulse.angular) +
                                  cross(place_of(impulse.model), gphys::widen(impulse.linear));
                    }
                    const Vec3 fall{0, -g * double{frame}, 0};
                    worst = std::max(worst, length(before.linear - after.linear + fall * 2 - sum) / weight);
                    const Vec3 torque = cross((before.first_moment + after.first_moment) / 2, fall);
                    Vec3 lacks = before.angular - after.angular + torque - moment;
                    lacks.x = 0;  // a line of particles holds nothing about itself
                    worst_moment = std::max(worst_moment, length(lacks) / weight);
                }
                std::printf("    %u substeps, %s, %u models: %.2g of the weight, %.2g m\n", substeps,
                            is_gathered ? "gathered" : "flat", models, worst, worst_moment);
                CHECK(worst < 1e-4);
                CHECK(worst_moment < 2e-3);  // a ten-thousandth of what is missing, as add_missing_impulses says
            }
        }
    }
}

namespace {

enum class Hung { rope, sheet, crate };

/// 2 kg at (0, 1, 0) and below, which touches nothing. Particle 0 is there.
gphys_body_id hang(World& world, Hung kind) {
    gphys_body_desc desc = World::body_desc();
    desc.mass = 2;
    desc.layers = 0;
    desc.damping = 1;
    if (kind == Hung::sheet) return world.cloth({0, 1, 0}, {0.4f, 0, 0}, {0, -0.4f, 0}, 5, 5, desc);
    std::vector<gphys_vec3> places;
    if (kind == Hung::rope) {
        for (int i = 0; i < 6; ++i) places.push_back({0, 1 - 0.1f * static_cast<float>(i), 0});
        return world.rope(places, 0, desc);
    }
    for (int i = 0; i < 8; ++i) {
        places.push_back({i & 1 ? 0.2f : 0, 1 - (i & 2 ? 0.2f : 0), i & 4 ? 0.2f : 0});
    }
    const gphys_body_id crate = world.particles(places, desc);
    const uint32_t all[] = {0, 1, 2, 3, 4, 5, 6, 7};
    gphys_cluster_id cluster = 0;
    REQUIRE(gphys_solver_add_cluster(world.solver, crate, all, 8, &cluster) == GPHYS_OK);
    return crate;
}

/// Joins particle 0 of both as they are.
void join(World& world, gphys_body_id a, gphys_body_id b) {
    gphys_joint_id joint = 0;
    REQUIRE(gphys_solver_join(world.solver, a, 0, b, 0, -1, 0, &joint) == GPHYS_OK);
}

double force_of_joint(const World& world) {
    gphys_joint_info joint{};
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_joints(world.solver, 0, &joint, 1, &total) == GPHYS_OK);
    return static_cast<double>(joint.force);
}

}  // namespace

TEST_CASE("What hangs by a joint pulls with its weight, whatever the body above it touches", "[simulation]") {
    for (const Hung kind : {Hung::rope, Hung::sheet, Hung::crate}) {
        for (const bool lies : {false, true}) {
            World world(8);
            const gphys_model_id floor = ground(world), nail = ball(world, 5, 5, 0);
            // Two particles of 0.5 kg: one lies on the ground, and so does the other, or it is nailed.
            gphys_body_desc desc = World::body_desc();
            desc.damping = 1;
            const gphys_body_id above = world.particles({{0, lies ? 0.0101f : 1.5f, 0}, {3, 0.0101f, 0}}, desc);
            if (!lies) REQUIRE(gphys_solver_attach(world.solver, world.scene, above, 0, nail, nullptr) == GPHYS_OK);
            const gphys_body_id body = hang(world, kind);
            if (lies) {
                std::vector<gphys_vec3> places = world.positions(body);
                for (gphys_vec3& place : places) place.y -= 1.5f;
                REQUIRE(gphys_solver_set_positions(world.solver, body, 0, static_cast<uint32_t>(places.size()),
                                                   places.data(), 12) == GPHYS_OK);
            }
            join(world, body, above);
            for (int i = 0; i < 900; ++i) world.step(frame);
            INFO(static_cast<int>(kind) << ' ' << lies);
            CHECK(std::fabs(force_of_joint(world) - 2 * g) < 5e-3 * 2 * g);
            const double held = linear(world, lies ? floor : nail).y, wanted = (lies ? 3 : 2.5) * g * frame;
            CHECK(std::fabs(held + wanted) < 5e-3 * wanted);
        }
    }
}

TEST_CASE("What is joined and lies on the ground presses it with its weight") {
    for (const Hung kind : {Hung::rope, Hung::sheet, Hung::crate}) {
        World world(8);
        const gphys_model_id floor = ground(world);
        gphys_body_id bodies[2];
        for (int i = 0; i < 2; ++i) {
            bodies[i] = hang(world, kind);
            std::vector<gphys_vec3> places = world.positions(bodies[i]);
            for (gphys_vec3& place : places) {
                const float down = 1 - place.y;
                // A crate stands, others lie.
                place = kind == Hung::crate ? gphys_vec3{place.x + static_cast<float>(i), 0.2101f - down, place.z}
                                            : gphys_vec3{place.x + static_cast<float>(i), 0.0101f, place.z + down};
            }
            REQUIRE(gphys_solver_set_positions(world.solver, bodies[i], 0, static_cast<uint32_t>(places.size()),
                                               places.data(), 12) == GPHYS_OK);
            gphys_body_settings settings{};
            REQUIRE(gphys_solver_get_body_settings(world.solver, bodies[i], &settings) == GPHYS_OK);
            settings.layers = GPHYS_ALL_LAYERS;
            REQUIRE(gphys_solver_set_body_settings(world.solver, bodies[i], &settings) == GPHYS_OK);
        }
        gphys_joint_id joint = 0;
        const uint32_t corner = kind == Hung::crate ? 2 : 0;  // at the bottom
        REQUIRE(gphys_solver_join(world.solver, bodies[0], corner, bodies[1], corner, -1, 0, &joint) == GPHYS_OK);
        for (int i = 0; i < 300; ++i) world.step(frame);
        INFO(static_cast<int>(kind));
        CHECK(std::fabs(linear(world, floor).y + 4 * g * frame) < 5e-3 * 4 * g * frame);
    }
}

TEST_CASE("A whirling rope pulls its model with the centripetal force, and a string that snaps taut with its jerk") {
    World world(16, {0, 0, 0});
    const gphys_model_id hub = ball(world, 1e4f, 0, 0);
    gphys_body_desc desc = World::body_desc();
    desc.layers = 0;
    desc.mass = 2;  // of which half whirls
    const gphys_body_id body = world.rope({{1e4f, 0, 0}, {1e4f + 0.5f, 0, 0}}, 0, desc);
    REQUIRE(gphys_solver_attach(world.solver, world.scene, body, 0, hub, nullptr) == GPHYS_OK);
    world.set_velocity(body, 1, {0, 1, 0});
    double worst = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        // m v^2 / r = 2 N, a frame later on a way turned by 2 / 60 radian.
        if (i > 0) worst = std::max(worst, std::fabs(length(linear(world, hub)) / (2 * frame) - 1));
    }
    figure("centripetal, relative error", worst, "");
    CHECK(worst < 1e-3);

    // One string makes a chain, three make a tree, and three whose ends slack strings join make a graph.
    for (const uint32_t strings : {1u, 3u, 6u}) {
        World other(16, {0, 0, 0});
        const gphys_model_id nail = ball(other, 0, 0, 0);
        desc.mass = 4;  // 1 kg each
        const gphys_body_id strung = other.particles({{0, 0, 0}, {0.4f, 0, 0}, {0, 0.4f, 0}, {0, 0, 0.4f}}, desc);
        const gphys_vec3 speeds[] = {{2.9f, 0, 0}, {0, 2.9f, 0}, {0, 0, 2.9f}};
        const uint32_t taut = std::min(strings, 3u);
        for (uint32_t i = 0; i < strings; ++i) {
            const uint32_t from = i < 3 ? 0 : i - 2, to = i < 3 ? i + 1 : (i - 2) % 3 + 1;
            gphys_constraint_id id = 0;
            REQUIRE(gphys_solver_add_max_distance(other.solver, strung, from, to, i < 3 ? 0.5f : 5.0f, 0, &id) ==
                    GPHYS_OK);
        }
        gphys_body_info info{};
        REQUIRE(gphys_solver_get_body_info(other.solver, strung, &info) == GPHYS_OK);
        CHECK(info.method == (strings <= 3 ? GPHYS_SOLVE_DIRECT : GPHYS_SOLVE_GRAPH));
        REQUIRE(gphys_solver_attach(other.solver, other.scene, strung, 0, nail, nullptr) == GPHYS_OK);
        for (uint32_t i = 1; i <= taut; ++i) other.set_velocity(strung, i, speeds[i - 1]);
        Vec3 sum;
        for (int i = 0; i < 30; ++i) {
            other.step(frame);
            sum += linear(other, nail);
        }
        std::printf("    jerk of %u strings: (%.5g, %.5g, %.5g) of 2.9 N s each\n", strings, sum.x, sum.y, sum.z);
        // In a graph to the rounding of float32: 2^-24 of 0.5 m in a substep of 1 ms is 3e-5 m/s.
        for (uint32_t i = 0; i < taut; ++i) {
            CHECK(std::fabs(sum[static_cast<int>(i)] - 2.9) < (strings <= 3 ? 1e-5 : 1e-3));
        }
    }
}

TEST_CASE("A string that becomes taut gives its jerk, by whichever formula") {
    // In a step of 1/60 s: by the backward formula, in the second part of a first step, and by the trapezoid rule.
    for (const float speed : {15.0f, 2.9f}) {
        World world(1, {0, 0, 0});
        const gphys_model_id nail = ball(world, 0, 0, 0);
        gphys_body_desc desc = World::body_desc();
        desc.mass = 2;
        const gphys_body_id strung = world.particles({{0, 0, 0}, {0.4f, 0, 0}}, desc);
        gphys_constraint_id id = 0;
        REQUIRE(gphys_solver_add_max_distance(world.solver, strung, 0, 1, 0.5f, 0, &id) == GPHYS_OK);
        REQUIRE(gphys_solver_attach(world.solver, world.scene, strung, 0, nail, nullptr) == GPHYS_OK);
        world.set_velocity(strung, 1, {speed, 0, 0});
        double sum = 0;
        for (int i = 0; i < 10; ++i) {
            world.step(frame);
            sum += linear(world, nail).x;
        }
        std::printf("    jerk at %g m/s: %.6g N s of 1 kg\n", static_cast<double>(speed), sum);
        CHECK(std::fabs(sum / static_cast<double>(speed) - 1) < 1e-6);
    }
}

TEST_CASE("What sleeps goes on pressing") {
    gphys_solver_desc desc;
    gphys_solver_desc_init(&desc, sizeof desc);
    desc.sleep_speed = 0.01f;
    World world;
    gphys_solver_destroy(world.solver);
    REQUIRE(gphys_solver_create(&desc, &world.solver) == GPHYS_OK);
    const gphys_model_id floor = ground(world);
    for (const gphys_body_kind kind : {GPHYS_BODY_PARTICLES, GPHYS_BODY_ROPE, GPHYS_BODY_CLOTH}) lay(world, kind);
    for (int i = 0; i < 120; ++i) world.step(frame);
    uint32_t asleep = 0;
    REQUIRE(gphys_solver_get_sleeping(world.solver, nullptr, 0, &asleep) == GPHYS_INCOMPLETE);
    CHECK(asleep == 3);
    CHECK(length(linear(world, floor) - Vec3{0, -9 * g * frame, 0}) < 1e-5);
}

TEST_CASE("Impulses do not depend on workers, and survive a snapshot") {
    uint32_t hashes[3][2];
    std::vector<gphys_impulse> seen[3];
    int row = 0;
    for (const uint32_t workers : {1u, 2u, 5u}) {
        gphys_solver_desc desc;
        gphys_solver_desc_init(&desc, sizeof desc);
        desc.worker_count = workers;
        World world;
        gphys_solver_destroy(world.solver);
        REQUIRE(gphys_solver_create(&desc, &world.solver) == GPHYS_OK);
        ground(world);
        ball(world, 0.5f, 0.1f, 0);
        for (int i = 0; i < 5; ++i) {
            lay(world, GPHYS_BODY_CLOTH, 0.2f + 0.1f * static_cast<float>(i));
            lay(world, GPHYS_BODY_ROPE, 0.25f + 0.1f * static_cast<float>(i));
            lay(world, GPHYS_BODY_PARTICLES, 0.3f + 0.1f * static_cast<float>(i));
        }
        for (int i = 0; i < 25; ++i) world.step(frame);
        seen[row] = impulses(world);
        CHECK(seen[row].size() == 2);
        REQUIRE(gphys_solver_get_hash(world.solver, hashes[row]) == GPHYS_OK);
        CHECK(std::memcmp(seen[row].data(), seen[0].data(), 2 * sizeof(gphys_impulse)) == 0);
        CHECK(std::memcmp(hashes[row], hashes[0], sizeof hashes[0]) == 0);
        uint32_t total = 0;
        gphys_solver_get_snapshot(world.solver, nullptr, 0, &total);
        std::vector<uint32_t> words(total);
        REQUIRE(gphys_solver_get_snapshot(world.solver, words.data(), total, &total) == GPHYS_OK);
        World copy;
        REQUIRE(gphys_solver_restore(copy.solver, words.data(), total) == GPHYS_OK);
        CHECK(std::memcmp(impulses(copy).data(), seen[0].data(), 2 * sizeof(gphys_impulse)) == 0);
        ++row;
    }
}

TEST_CASE("Steps with all kinds of constraints and contacts allocate nothing, and running out changes nothing") {
    WatchedMemory memory;
    const gphys_allocator hooks{[](void* user, size_t size, size_t alignment) -> void* {
                                    try {
                                        return static_cast<WatchedMemory*>(user)->allocate(size, alignment);
                                    } catch (const std::bad_alloc&) {
                                        return nullptr;
                                    }
                                },
                                [](void* user, void* p, size_t size, size_t alignment) {
                                    static_cast<WatchedMemory*>(user)->deallocate(p, size, alignment);
                                },
                                &memory};
    {
        World world;
        gphys_solver_destroy(world.solver);
        gphys_solver_desc desc;
        gphys_solver_desc_init(&desc, sizeof desc);
        desc.allocator = &hooks;
        REQUIRE(gphys_solver_create(&desc, &world.solver) == GPHYS_OK);
        ground(world);
        const gphys_model_id nail = ball(world, 0, 1, 0);
        const gphys_body_id sheet = lay(world, GPHYS_BODY_CLOTH, 0.3f), rope = lay(world, GPHYS_BODY_ROPE, 0.3f);
        gphys_body_desc sticky = World::body_desc();
        sticky.static_friction = 1;
        world.particles({{0, 0.3f, 0}}, sticky);
        const gphys_vec3 corners[] = {{0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {0, 1, 1}};
        const uint32_t faces[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
        gphys_mesh* mesh = nullptr;
        REQUIRE(gphys_mesh_create(nullptr, &corners[0].x, 12, 4, faces, 12, &mesh) == GPHYS_OK);
        gphys_body_id ball = 0;
        REQUIRE(gphys_solver_add_cloth_mesh(world.solver, &sticky, mesh, nullptr, &ball) == GPHYS_OK);
        gphys_mesh_destroy(mesh);
        REQUIRE(gphys_solver_attach(world.solver, world.scene, rope, 0, nail, nullptr) == GPHYS_OK);
        REQUIRE(gphys_solver_attach(world.solver, world.scene, sheet, 0, nail, nullptr) == GPHYS_OK);

        const auto until_it_fits = [&](auto&& call) {
            int refusals = 0;
            for (long allowed = 0;; ++allowed, ++refusals) {
                uint32_t before[2], after[2];
                gphys_solver_get_hash(world.solver, before);
                memory.fail_at = memory.allocations + allowed;
                const gphys_status status = call();
                memory.fail_at = -1;
                if (status == GPHYS_OK) return refusals;
                REQUIRE(status == GPHYS_ERROR_OUT_OF_MEMORY);
                gphys_solver_get_hash(world.solver, after);
                CHECK(std::memcmp(before, after, sizeof before) == 0);
            }
        };
        gphys_constraint_id string = 0;
        CHECK(until_it_fits([&] { return gphys_solver_set_volume(world.solver, ball, -1, 0); }) >= 1);
        until_it_fits([&] { return gphys_solver_add_max_distance(world.solver, rope, 0, 29, 1, 0.01f, &string); });
        REQUIRE(gphys_solver_set_constraint_damping(world.solver, rope, string, 1) == GPHYS_OK);
        REQUIRE(gphys_solver_step(world.solver, world.scene, frame) == GPHYS_OK);
        const long before = memory.allocations;
        for (int i = 0; i < 60; ++i) {
            REQUIRE(gphys_solver_step(world.solver, world.scene, frame) == GPHYS_OK);
            CHECK(impulses(world).size() >= 1);
        }
        CHECK(memory.allocations == before);
        gphys_solver_destroy(world.solver);
        world.solver = nullptr;
    }
}

TEST_CASE("Moments count from the model, wherever it is") {
    World world(8);
    const gphys_model_id model = ball(world, 5, 0, 2);
    gphys_body_desc desc = World::body_desc();
    desc.restitution = 1;
    const gphys_body_id body = world.particles({{5, 0.061f, 2}}, desc);
    world.set_velocity(body, 0, {0, -3, 0});
    world.step(frame);
    CHECK(linear(world, model).y < -5.9);  // 2 m v, through the middle of the ball
    CHECK(length(angular(world, model)) < 1e-6);
}

TEST_CASE("What is attached gives its model what it is accelerated and pressed with") {
    World world(8);
    const gphys_model_id model = ball(world, 0, 0, 0);
    gphys_body_desc desc = World::body_desc();
    desc.mass = 2;
    desc.layers = 0;
    const gphys_body_id body = world.particles({{0, 0, 0}}, desc);
    REQUIRE(gphys_solver_attach(world.solver, world.scene, body, 0, model, nullptr) == GPHYS_OK);
    const gphys_vec3 force{7, 0, 0};
    REQUIRE(gphys_solver_set_forces(world.solver, body, 0, 1, &force, 12) == GPHYS_OK);
    world.step(frame);
    const gphys_transform moved = placed(0, 0, 0.005f);  // from rest to 0.3 m/s
    REQUIRE(gphys_scene_set_transform(world.scene, model, &moved) == GPHYS_OK);
    world.step(frame);
    const double second = static_cast<double>(frame);
    const Vec3 expected{7 * second, -2 * g * second, -2 * 0.005 / second};
    CHECK(length(linear(world, model) - expected) < 1e-5);
}
