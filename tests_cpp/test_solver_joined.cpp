// What bodies do when they are joined to others, they do as one body would: flights, strings, springs, contacts,
// forces on models, sleep, and changes while they move.
#include "solver_world.h"

using gphys::Vec3;
using test::figure;
using test::line;
using test::World;

namespace {

constexpr float dt = 1.0f / 60;
constexpr double g = static_cast<double>(9.81f);

gphys_joint_id join(World& world, gphys_body_id a, uint32_t particle_a, gphys_body_id b, uint32_t particle_b,
                    float rest = 0) {
    gphys_joint_id joint = 0;
    REQUIRE(gphys_solver_join(world.solver, a, particle_a, b, particle_b, rest, 0, &joint) == GPHYS_OK);
    return joint;
}

gphys_joint_info only_joint(const World& world) {
    gphys_joint_info info{};
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_joints(world.solver, 0, &info, 1, &total) == GPHYS_OK);
    REQUIRE(total == 1);
    return info;
}

uint32_t joint_count(const World& world) {
    uint32_t total = 0;
    gphys_solver_get_joints(world.solver, 0, nullptr, 0, &total);
    return total;
}

uint32_t asleep(const World& world) {
    uint32_t total = 0;
    gphys_solver_get_sleeping(world.solver, nullptr, 0, &total);
    return total;
}

gphys_body_desc of_mass(float mass) {
    gphys_body_desc desc = World::body_desc();
    desc.mass = mass;
    return desc;
}

Vec3 velocity(const World& world, gphys_body_id body, uint32_t particle = 0) {
    return gphys::widen(world.velocities(body)[particle]);
}

/// One particle.
gphys_body_id weight(World& world, gphys_vec3 at, float mass, uint32_t layers = 0xffffffff) {
    gphys_body_desc desc = of_mass(mass);
    desc.layers = layers;
    return world.particles({at}, desc);
}

gphys_model_id peg(World& world, gphys_vec3 at) {
    const gphys_sphere sphere{{0, 0, 0}, 0.01f};
    const gphys_transform transform{at, {0, 0, 0, 1}, 1};
    return world.model(GPHYS_SHAPE_SPHERE, &sphere, &transform);
}

gphys_solver_desc sleepy() {
    gphys_solver_desc desc = World::desc();
    desc.sleep_speed = 0.02f;
    return desc;
}

}  // namespace

TEST_CASE("a joint made in flight holds from the next step on, and a joint cut lets go") {
    World world(8);
    const gphys_body_id a = weight(world, {0, 0, 0}, 1), b = weight(world, {0.5f, 0, 0}, 3);
    for (int i = 0; i < 10; ++i) world.step(dt);
    const gphys_joint_id joint = join(world, a, 0, b, 0, -1);
    CHECK(only_joint(world).rest_length == Approx(0.5).epsilon(1e-6));
    world.set_velocity(a, 0, {0, 2, 0});
    world.set_velocity(b, 0, {0, 0, 1});
    const Vec3 centre = (world.position(a) + world.position(b) * 3.0) / 4, speed = Vec3{0, 2, 3} / 4;
    for (int i = 1; i <= 30; ++i) {
        world.step(dt);
        CHECK(std::fabs(distance(world.position(a), world.position(b)) - 0.5) < 1e-6);
    }
    const double t = 30.0 * static_cast<double>(dt);
    const Vec3 fallen = centre + speed * t - Vec3{0, g * t * t / 2, 0};
    CHECK(distance((world.position(a) + world.position(b) * 3.0) / 4, fallen) < 1e-4);

    REQUIRE(gphys_solver_unjoin(world.solver, joint) == GPHYS_OK);
    CHECK(joint_count(world) == 0);
    const Vec3 at = world.position(b), v = velocity(world, b);
    for (int i = 0; i < 30; ++i) world.step(dt);
    CHECK(distance(world.position(b), at + v * t - Vec3{0, g * t * t / 2, 0}) < 1e-5);
}

TEST_CASE("a rope that is cut from what it hangs on flies from there, awake") {
    for (const bool sleeping : {false, true}) {
        World world(sleepy());
        const gphys_body_id hook = weight(world, {0, 0, 0}, 1);
        const gphys_body_id rope = world.rope(line({0, 0, 0}, {0, -0.1f, 0}, 6), 0);
        world.pin(hook, 0);
        const gphys_joint_id joint = join(world, hook, 0, rope, 0);
        if (!sleeping) world.set_velocity(rope, 5, {2, 0, 0});
        for (int i = 0; i < (sleeping ? 120 : 13); ++i) world.step(dt);
        REQUIRE(asleep(world) == (sleeping ? 2u : 0u));
        Vec3 centre, speed;
        for (uint32_t i = 0; i < 6; ++i) centre += world.position(rope, i) / 6, speed += velocity(world, rope, i) / 6;
        REQUIRE(gphys_solver_unjoin(world.solver, joint) == GPHYS_OK);
        for (int i = 0; i < 30; ++i) world.step(dt);
        const double t = 30.0 * static_cast<double>(dt);
        Vec3 now;
        for (uint32_t i = 0; i < 6; ++i) now += world.position(rope, i) / 6;
        CAPTURE(sleeping);
        // Were the pull of the joint part of its history, a third of a substep's would stay: 1e-2 m here.
        CHECK(distance(now, centre + speed * t - Vec3{0, g * t * t / 2, 0}) < 1e-4);
    }
}

TEST_CASE("a joint goes with either of its bodies") {
    for (const bool first : {false, true}) {
        World world(8);
        const gphys_body_id a = weight(world, {0, 0, 0}, 1), b = weight(world, {0, -1, 0}, 1);
        world.pin(a, 0);
        join(world, a, 0, b, 0, -1);
        REQUIRE(gphys_solver_remove_body(world.solver, first ? a : b) == GPHYS_OK);
        CHECK(joint_count(world) == 0);
        world.step(dt);
    }
}

TEST_CASE("of several joints the one that is cut lets go and the others hold") {
    World world(8);
    const gphys_body_id top = weight(world, {0, 0, 0}, 1), middle = weight(world, {0, -1, 0}, 1);
    const gphys_body_id low = weight(world, {0, -2, 0}, 1);
    world.pin(top, 0);
    join(world, top, 0, middle, 0, -1);
    const gphys_joint_id cut = join(world, middle, 0, low, 0, -1);
    for (int i = 0; i < 5; ++i) world.step(dt);
    REQUIRE(gphys_solver_unjoin(world.solver, cut) == GPHYS_OK);
    for (int i = 0; i < 30; ++i) world.step(dt);
    const double t = 30.0 * static_cast<double>(dt);
    CHECK(std::fabs(world.position(middle).y + 1) < 1e-6);
    CHECK(std::fabs(world.position(low).y + 2 + g * t * t / 2) < 1e-4);
    CHECK(only_joint(world).force == Approx(g).epsilon(1e-4));
}

TEST_CASE("what is lifted off a floor touches it no longer") {
    World world(8);
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const gphys_body_id a = weight(world, {0, 0.0101f, 0}, 1), b = weight(world, {0.3f, 0.0101f, 0}, 1);
    join(world, a, 0, b, 0, -1);
    for (int i = 0; i < 10; ++i) world.step(dt);
    const auto contacts = [&] {
        uint32_t total = 0;
        gphys_solver_get_contacts(world.solver, nullptr, 0, &total);
        return total;
    };
    CHECK(contacts() == 2);
    for (const gphys_body_id body : {a, b}) {
        const gphys_vec3 up{body == a ? 0.0f : 0.3f, 1, 0};
        REQUIRE(gphys_solver_set_positions(world.solver, body, 0, 1, &up, 12) == GPHYS_OK);
    }
    world.step(dt);
    CHECK(contacts() == 0);
}

TEST_CASE("strings and damped springs of joined bodies act as those of one body") {
    const bool strings = GENERATE(true, false);
    World two(8), one(8);
    const auto link = [&](World& world, gphys_body_id body, uint32_t a, uint32_t b) {
        gphys_constraint_id id = 0;
        if (strings) {
            REQUIRE(gphys_solver_add_max_distance(world.solver, body, a, b, 1, 0, &id) == GPHYS_OK);
        } else {
            REQUIRE(gphys_solver_add_distance(world.solver, body, a, b, 1, 0.01f, &id) == GPHYS_OK);
            REQUIRE(gphys_solver_set_constraint_damping(world.solver, body, id, 3) == GPHYS_OK);
        }
    };
    // The middle particle of one is two halves of two.
    const gphys_vec3 top{0, 0, 0}, middle{0.8f, 0, 0}, end{1.4f, 0.2f, 0};
    const gphys_body_id upper = two.particles({top, middle}, of_mass(2));
    const gphys_body_id lower = two.particles({middle, end}, of_mass(2));
    gphys_body_desc whole = of_mass(3);
    whole.self_collision = 1;  // so that its substeps are made by the backward formula alone, as those of joined bodies
    const gphys_body_id all = one.particles({top, middle, end}, whole);
    const float both = 2;
    REQUIRE(gphys_solver_set_masses(one.solver, all, 1, 1, &both, 4) == GPHYS_OK);
    two.pin(upper, 0), one.pin(all, 0);
    link(two, upper, 0, 1), link(two, lower, 0, 1);
    link(one, all, 0, 1), link(one, all, 1, 2);
    join(two, upper, 1, lower, 0);
    double apart = 0, excess = 0, speeds = 0;
    for (int i = 0; i < 90; ++i) {
        two.step(dt), one.step(dt);
        apart = std::max(apart, distance(two.position(lower, 1), one.position(all, 2)));
        excess = std::max(excess, distance(two.position(lower, 1), two.position(lower, 0)) - 1);
        speeds = std::max(speeds, length(velocity(two, lower, 1) - velocity(one, all, 2)));
    }
    figure(strings ? "strings of two and of one, apart" : "springs of two and of one, apart", apart, "m");
    figure("the same, speeds", speeds, "m/s");
    CHECK(apart < (strings ? 1e-2 : 1e-6));  // joined, what is slack flies by the time scheme of ropes
    if (strings) CHECK(excess < 1e-5);
}

TEST_CASE("joints and ends of joined ropes give their models what hangs on them, moving as well", "[simulation]") {
    World world(8);
    gphys_transform at[2] = {{{0, 0, 0}, {0, 0, 0, 1}, 1}, {{1, 0, 0}, {0, 0, 0, 1}, 1}};
    const gphys_model_id models[2] = {peg(world, at[0].position), peg(world, at[1].position)};
    const bool hook_first = GENERATE(true, false), hang_by_end = GENERATE(true, false);
    const double mass = 2, hook_mass = 0.5;
    gphys_body_desc desc = of_mass(static_cast<float>(mass));
    desc.layers = 0, desc.damping = 3;
    const gphys_body_id rope = world.rope(
        [] {
            std::vector<gphys_vec3> points;  // 20 links of 0.06 m on a half circle
            for (int i = 0; i <= 20; ++i) {
                const double angle = gphys::pi * i / 20;
                points.push_back(
                    {static_cast<float>(0.5 - 0.5 * std::cos(angle)), static_cast<float>(-0.5 * std::sin(angle)), 0});
            }
            return points;
        }(),
        0, desc);
    gphys_body_id hooks[2] = {};
    for (int k = 0; k < 2; ++k) {
        if (k == 0 && hang_by_end) {
            REQUIRE(gphys_solver_attach(world.solver, world.scene, rope, 0, models[0], nullptr) == GPHYS_OK);
            continue;
        }
        hooks[k] = weight(world, at[k].position, static_cast<float>(hook_mass), 0);
        REQUIRE(gphys_solver_attach(world.solver, world.scene, hooks[k], 0, models[k], nullptr) == GPHYS_OK);
        const uint32_t end = k == 0 ? 0 : 20;
        hook_first ? join(world, hooks[k], 0, rope, end) : join(world, rope, end, hooks[k], 0);
    }
    gphys_impulse given[4];
    for (int frame = 0; frame < 600; ++frame) {
        for (int k = 0; k < 2; ++k) {
            at[k].position.z += 0.005f;  // 0.3 m/s, both
            REQUIRE(gphys_scene_set_transform(world.scene, models[k], &at[k]) == GPHYS_OK);
        }
        world.step(dt);
    }
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_impulses(world.solver, given, 4, &total) == GPHYS_OK);
    REQUIRE(total == 2);
    CAPTURE(hook_first, hang_by_end);
    const double second = static_cast<double>(dt);
    Vec3 sum;
    for (int k = 0; k < 2; ++k) {
        const Vec3 linear = gphys::widen(given[k].linear);
        sum += linear;
        // Half of the rope each, and the hook that is fixed to the model itself.
        const double carried = mass / 2 + (hooks[k] ? hook_mass : 0);
        CHECK(linear.y == Approx(-carried * g * second).epsilon(3e-3));
        CHECK((k == 0 ? linear.x : -linear.x) > 0.1 * carried * g * second);  // the rope draws them together
    }
    CHECK(std::fabs(sum.x) < 1e-3 * mass * g * second);
    // Damping of what is drawn through the air at 0.3 m/s, all but an attached end, and nothing else.
    const double drawn = hang_by_end ? mass * 20 / 21 : mass;
    CHECK(sum.z == Approx(-3 * drawn * 0.3 * second).epsilon(1e-3));
}

TEST_CASE("what is joined to a thing that lands, lands with it") {
    // A dumbbell that stands on a floor: its lower end meets the floor, its upper end nothing.
    World world(8);
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const gphys_body_id lower = weight(world, {0, 0.3f, 0}, 1), upper = weight(world, {0, 0.7f, 0}, 2, 0);
    const gphys_joint_id joint = join(world, lower, 0, upper, 0, -1);
    double strain = 0;
    for (int i = 0; i < 60; ++i) {
        world.step(dt);
        const double apart = world.position(upper).y - world.position(lower).y;
        strain = std::max(strain, std::fabs(apart / 0.4 - 1));
    }
    figure("strain of a dumbbell that lands", strain * 100, "%");
    CHECK(strain < 1e-5);
    CHECK(std::fabs(world.position(lower).y - 0.01) < 1e-5);
    CHECK(length(velocity(world, upper)) < 1e-3);
    CHECK(only_joint(world).id == joint);
    CHECK(only_joint(world).force == Approx(-2 * g).epsilon(1e-3));  // it carries the upper one
}

TEST_CASE("static friction holds joined ropes on a slope, and friction alone lets them go") {
    for (const bool sticks : {true, false}) {
        World world(8);
        const double angle = 0.4;  // tan 0.42
        const gphys_plane slope{{static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)), 0}, 0};
        world.model(GPHYS_SHAPE_PLANE, &slope);
        gphys_body_desc desc = of_mass(1);
        desc.friction = 0.3f;
        desc.static_friction = sticks ? 0.6f : 0;
        const auto down = [&](double way) {
            const Vec3 at = Vec3{std::cos(angle), -std::sin(angle), 0} * way + gphys::widen(slope.normal) * 0.010002;
            return gphys::narrow(at);
        };
        std::vector<gphys_vec3> high, low;
        for (int i = 0; i <= 10; ++i) high.push_back(down(0.05 * i)), low.push_back(down(0.5 + 0.05 * i));
        const gphys_body_id a = world.rope(high, 0, desc), b = world.rope(low, 0, desc);
        join(world, a, 10, b, 0);
        const Vec3 before = world.position(b, 10);
        for (int i = 0; i < 60; ++i) world.step(dt);
        const double slid = distance(world.position(b, 10), before), speed = length(velocity(world, b, 10));
        CAPTURE(sticks, slid, speed);
        if (sticks) {
            CHECK(slid < 1e-3);
        } else {
            const double a_free = g * (std::sin(angle) - static_cast<double>(0.3f) * std::cos(angle));
            CHECK(slid == Approx(a_free / 2).epsilon(0.03));
        }
    }
}

TEST_CASE("interruptions of one body take no momentum from those that it is joined to") {
    World world(8, {0, 0, 0});
    const gphys_body_id a = weight(world, {0, 0, 0}, 2), b = weight(world, {1, 0, 0}, 3);
    join(world, a, 0, b, 0, -1);
    world.set_velocity(a, 0, {0, 3, 0});
    const Vec3 before = Vec3{0, 6, 0};
    for (int i = 0; i < 120; ++i) {
        // The caller sets the speed that it has already.
        if (i % 3 == 0) world.set_velocity(b, 0, world.velocities(b)[0]);
        world.step(dt);
    }
    const Vec3 after = velocity(world, a) * 2.0 + velocity(world, b) * 3.0;
    figure("momentum lost by 40 interruptions of one end", length(after - before) / 6, "parts");
    CHECK(length(after - before) / 6 < 1e-5);
}

TEST_CASE("bodies that are joined take as many substeps as the one that needs most, and meet their targets") {
    for (const bool swinging_first : {false, true}) {
        gphys_solver_desc desc = World::desc();
        desc.tolerance = 1e-3f;
        desc.max_substeps = 100;
        World world(desc);
        // A rope that swings, joined at its pin to one that hangs still.
        const auto add = [&](bool swings) {
            const gphys_body_id rope =
                world.rope(swings ? line({0, 0, 0}, {0.1f, 0, 0}, 11) : line({0, 0, 0}, {0, -0.1f, 0}, 11), 0);
            world.pin(rope, 0);
            return rope;
        };
        const gphys_body_id first = add(swinging_first), second = add(!swinging_first);
        join(world, first, 0, second, 0);
        for (int i = 0; i < 25; ++i) world.step(dt);
        CAPTURE(swinging_first);
        CHECK(world.substeps(first) == world.substeps(second));
        CHECK(world.substeps(first) > 10);
    }
}

TEST_CASE("joined systems that sleep and those that do not are told apart") {
    World world(sleepy());
    const auto pair = [&](float x, gphys_vec3 step) {
        const gphys_body_id upper = world.rope(line({x, 0, 0}, step, 6), 0);
        const gphys_body_id lower = world.rope(line({x + 5 * step.x, 5 * step.y, 0}, step, 6), 0);
        world.pin(upper, 0);
        join(world, upper, 5, lower, 0);
        return lower;
    };
    pair(0, {0, -0.1f, 0});
    const gphys_body_id swinging = pair(5, {0.1f, 0, 0});
    for (int i = 0; i < 120; ++i) world.step(dt);
    CHECK(asleep(world) == 2);
    CHECK(std::fabs(distance(world.position(swinging, 5), world.position(swinging, 4)) - 0.1) < 1e-6);
    std::vector<gphys_joint_info> infos(2);
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_joints(world.solver, swinging, infos.data(), 2, &total) == GPHYS_OK);
    REQUIRE(total == 1);
    CHECK(distance(world.position(infos[0].body_a, 5), world.position(swinging, 0)) < 1e-6);
}

TEST_CASE("joined ropes are moved once, whatever moves beside them") {
    World beside(8), alone(8);
    gphys_body_id lower[2];
    for (int k = 0; k < 2; ++k) {
        World& world = k == 0 ? beside : alone;
        if (k == 0) world.pin(world.rope(line({0, 0, 9}, {0.1f, 0, 0}, 11), 0), 0);
        const gphys_body_id upper = world.rope(line({0, 0, 0}, {0.1f, 0, 0}, 11), 0);
        lower[k] = world.rope(line({1, 0, 0}, {0.1f, 0, 0}, 11), 0);
        world.pin(upper, 0);
        join(world, upper, 10, lower[k], 0);
        if (k == 0) world.pin(world.rope(line({0, 0, 12}, {0.1f, 0, 0}, 11), 0), 0);
        for (int i = 0; i < 30; ++i) world.step(dt);
    }
    for (uint32_t i = 0; i < 11; ++i) CHECK(beside.position(lower[0], i) == alone.position(lower[1], i));
}

TEST_CASE("joined ropes that might touch others, and do not, move as those that cannot") {
    World touching(8), passing(8);
    Vec3 end[2];
    for (int k = 0; k < 2; ++k) {
        World& world = k == 0 ? touching : passing;
        gphys_body_desc desc = of_mass(1);
        desc.body_layers = k == 0 ? 1 : 0;
        desc.radius = 0.001f;
        const gphys_body_id upper = world.rope(line({0, 0, 0}, {0.1f, 0, 0}, 6), 0, desc);
        const gphys_body_id lower = world.rope(line({0.55f, 0, 0}, {0.1f, 0, 0}, 6), 0, desc);
        world.pin(upper, 0);
        join(world, upper, 5, lower, 0, -1);
        for (int i = 0; i < 20; ++i) world.step(dt);
        end[k] = world.position(lower, 5);
    }
    figure("where contacts are looked for and where not, apart", distance(end[0], end[1]), "m");
    CHECK(distance(end[0], end[1]) < 1e-6);
}

TEST_CASE("a body that stands still beside one that swings does not fall asleep alone") {
    for (const bool swinging_first : {false, true}) {
        World world(sleepy());
        gphys_body_desc desc = of_mass(1);
        desc.body_layers = 1;
        desc.radius = 0.01f;
        const auto add = [&](bool swings) {
            const float z = swings ? 0.0f : 0.1f;
            const gphys_body_id rope =
                world.rope(swings ? line({0, 0, z}, {0.1f, 0, 0}, 11) : line({0, 0, z}, {0, -0.1f, 0}, 11), 0, desc);
            world.pin(rope, 0);
        };
        add(swinging_first), add(!swinging_first);
        for (int i = 0; i < 150; ++i) world.step(dt);
        CAPTURE(swinging_first);
        CHECK(asleep(world) == 0);
    }
}

TEST_CASE("ropes that meet in a knot do not push each other off it") {
    for (const bool in_a_row : {false, true}) {
        World world;
        // At twelve o'clock, four and eight, seen from above, and downwards.
        gphys_body_id ropes[3];
        for (int i = 0; i < 3; ++i) {
            const double angle = i * 2 * 3.14159265358979 / 3;
            const gphys_vec3 link{static_cast<float>(0.05 * std::sin(angle)), -0.025f,
                                  static_cast<float>(0.05 * std::cos(angle))};
            ropes[i] = world.rope(line({0, 0, 0}, link, 11), 0, test::colliding(0.1f, 0.01f));
        }
        world.pin(ropes[0], 0);
        for (int i = 1; i < 3; ++i) join(world, ropes[in_a_row ? i - 1 : 0], 0, ropes[i], 0);
        double strain = 0, gap = 0;
        for (int step = 0; step < 120; ++step) {
            world.step(dt);
            strain = std::max(strain, static_cast<double>(world.stats().strain_max));
            for (int i = 1; i < 3; ++i) gap = std::max(gap, length(world.position(ropes[i], 0)));
        }
        figure("strain", 100 * strain, "%");
        figure("gap", 1000 * gap, "mm");
        // The ends of two ropes pushed each other a diameter apart: 8 %.
        CHECK(strain < 0.005);
        CHECK(gap < 1e-5);
    }
}

TEST_CASE("balls on strings from one hook collide") {
    World world;
    const gphys_body_id hook = world.particles({{0, 0, 0}}, test::colliding(1, 0.05f));
    world.pin(hook, 0);
    const gphys_body_id left = world.particles({{-0.3f, -0.4f, 0}}, test::colliding(1, 0.05f));
    const gphys_body_id right = world.particles({{0.3f, -0.4f, 0}}, test::colliding(1, 0.05f));
    join(world, hook, 0, left, 0, 0.5f);
    join(world, hook, 0, right, 0, 0.5f);
    for (int step = 0; step < 120; ++step) {
        world.step(dt);
        // Overlaps are removed within a step.
        CHECK(distance(world.position(left), world.position(right)) > 0.1 * (1 - 1e-3));
    }
}
