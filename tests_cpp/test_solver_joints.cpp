// Joints between bodies: as stiff as one body, forces equal and opposite, and what becomes of them.
#include "solver/joints/sparse_ldl.h"
#include "solver_world.h"

using gphys::Vec3;
using test::figure;
using test::World;

namespace {

constexpr float dt = 1.0f / 60;

gphys_joint_id join(World& world, gphys_body_id a, uint32_t particle_a, gphys_body_id b, uint32_t particle_b,
                    float rest = 0, float compliance = 0) {
    gphys_joint_id joint = 0;
    REQUIRE(gphys_solver_join(world.solver, a, particle_a, b, particle_b, rest, compliance, &joint) == GPHYS_OK);
    return joint;
}

std::vector<gphys_joint_info> joints(const World& world, gphys_body_id body = 0) {
    std::vector<gphys_joint_info> infos(64);
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_joints(world.solver, body, infos.data(), 64, &total) == GPHYS_OK);
    infos.resize(total);
    return infos;
}

/// The largest distance of joined particles from what their joint says, in metres.
double worst_gap(const World& world) {
    double gap = 0;
    for (const gphys_joint_info& joint : joints(world)) {
        const double now =
            distance(world.position(joint.body_a, joint.particle_a), world.position(joint.body_b, joint.particle_b));
        gap = std::max(gap, std::fabs(now - joint.rest_length));
    }
    return gap;
}

std::vector<gphys_vec3> line(uint32_t count, gphys_vec3 from, gphys_vec3 to) {
    std::vector<gphys_vec3> points;
    for (uint32_t i = 0; i < count; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(count - 1);
        points.push_back({from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t, from.z + (to.z - from.z) * t});
    }
    return points;
}

gphys_body_desc of_mass(float mass) {
    gphys_body_desc desc = World::body_desc();
    desc.mass = mass;
    return desc;
}

struct Momentum {
    Vec3 linear, angular;
};
Momentum momentum(const World& world) {
    Momentum sum{};
    gphys_body_id bodies[16];
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_bodies(world.solver, bodies, 16, &total) == GPHYS_OK);
    for (uint32_t b = 0; b < total; ++b) {
        const std::vector<gphys_vec3> at = world.positions(bodies[b]), velocity = world.velocities(bodies[b]);
        std::vector<float> mass(at.size());
        REQUIRE(gphys_solver_get_masses(world.solver, bodies[b], 0, static_cast<uint32_t>(at.size()), mass.data(), 4) ==
                GPHYS_OK);
        for (size_t i = 0; i < at.size(); ++i) {
            const Vec3 p = gphys::widen(velocity[i]) * static_cast<double>(mass[i]);
            sum.linear += p;
            sum.angular += cross(gphys::widen(at[i]), p);
        }
    }
    return sum;
}

/// Cloth of n x n particles that hangs by two corners; a rope hangs from another, with a weight at its end.
void cloth_with_a_rope_gains_no_energy(uint32_t n, float heavy, float step) {
    World world(1);
    gphys_body_desc desc = of_mass(1);
    desc.cloth_flags = GPHYS_CLOTH_SHEAR;
    const gphys_body_id cloth = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, n, n, desc);
    world.pin(cloth, 0);
    world.pin(cloth, n - 1);
    const gphys_body_id rope = world.rope(line(11, {1, 0, 1}, {2, 0, 1}), 0, of_mass(1));
    REQUIRE(gphys_solver_set_masses(world.solver, rope, 10, 1, &heavy, 4) == GPHYS_OK);
    join(world, cloth, n * n - 1, rope, 0);
    const double before = world.energy();
    double most = before;
    for (int i = 0; i < 200; ++i) {
        world.step(step);
        most = std::max(most, world.energy());
    }
    INFO(n << " x " << n << ", weight " << heavy << ", step " << step);
    // Energies are float32, of masses that fall for metres.
    CHECK(most - before <= 1e-6 * (2 + heavy) * 9.81);
}

}  // namespace

TEST_CASE("a sparse matrix is taken apart and solved as a dense one") {
    // A saddle point: random masses, and links of small compliance between random pairs.
    test::Random random(31);
    for (const uint32_t masses : {1u, 2u, 17u, 60u}) {
        const uint32_t links = masses / 2, n = masses + links;
        std::vector<std::vector<double>> dense(n, std::vector<double>(n, 0.0));
        gphys::Vector<uint32_t> begin{0}, rows;
        std::vector<double> entries, diagonal;
        for (uint32_t i = 0; i < masses; ++i) {
            diagonal.push_back(dense[i][i] = random.uniform(1, 1000));
            begin.push_back(0);
        }
        for (uint32_t link = masses; link < n; ++link) {
            diagonal.push_back(dense[link][link] = -1e-6);
            for (int end = 0; end < 3; ++end) {  // may be the same one twice: entries add up
                const uint32_t row = random.index(masses);
                const double value = random.uniform(-1, 1);
                rows.push_back(row);
                entries.push_back(value);
                dense[row][link] += value;
                dense[link][row] += value;
            }
            begin.push_back(static_cast<uint32_t>(rows.size()));
        }
        gphys::SparseLdl matrix(std::pmr::get_default_resource());
        matrix.analyse(begin, rows);
        for (int again = 0; again < 2; ++again) {
            matrix.factor(entries.data(), diagonal.data());
            std::vector<double> x(n), b(n, 0.0);
            for (double& value : x) value = random.uniform(-1, 1);
            for (uint32_t i = 0; i < n; ++i) {
                for (uint32_t j = 0; j < n; ++j) b[i] += dense[i][j] * x[j];
            }
            matrix.solve(b.data());
            for (uint32_t i = 0; i < n; ++i) CHECK(std::fabs(b[i] - x[i]) < 1e-6);
        }
    }
}

namespace {

/// Two joined ropes of 100 links from the horizontal, and one of 200 whose middle particle has the mass of both ends.
struct SwingingRopes {
    World two, one;
    gphys_body_id upper, lower, rope;

    explicit SwingingRopes(uint32_t substeps) : two(substeps), one(substeps) {
        upper = two.rope(line(101, {0, 0, 0}, {10, 0, 0}), 0);
        lower = two.rope(line(101, {10, 0, 0}, {20, 0, 0}), 0);
        two.pin(upper, 0);
        join(two, upper, 100, lower, 0);
        rope = one.rope(line(201, {0, 0, 0}, {20, 0, 0}), 0, of_mass(201.0f / 101));
        const float both = 2.0f / 101;
        REQUIRE(gphys_solver_set_masses(one.solver, rope, 100, 1, &both, 4) == GPHYS_OK);
        one.pin(rope, 0);
    }
    void step() {
        two.step(dt);
        one.step(dt);
    }
    double apart() { return distance(two.position(lower, 100), one.position(rope, 200)); }
};

}  // namespace

TEST_CASE("two joined ropes swing like one that is as long", "[simulation]") {
    SwingingRopes ropes(8);
    // Joined to a nail, the one rope is moved as those are.
    const gphys_body_id nail = ropes.one.particles({{0, 0, 0}});
    ropes.one.pin(nail, 0);
    join(ropes.one, ropes.rope, 0, nail, 0);
    double gap = 0, strain = 0, apart = 0;
    for (int frame = 0; frame < 180; ++frame) {
        ropes.step();
        gap = std::max(gap, worst_gap(ropes.two));
        strain = std::max(strain, static_cast<double>(ropes.two.stats().strain_max));
        apart = std::max(apart, ropes.apart());
    }
    figure("gap of the joint", gap / 0.1 * 100, "% of a link");
    figure("strain", strain * 100, "%");
    figure("distance of the free ends", apart, "m");
    CHECK(gap <= 1e-4 * 0.1);
    CHECK(strain <= 1e-5);
    // Positions come out as floats, rounded to 1e-6 m here; the whip of a free end magnifies.
    CHECK(apart <= 1e-4);
}

TEST_CASE("two joined ropes converge to where one alone does", "[simulation]") {
    // It goes by another formula of second order: twice the substeps, a fourth of the distance.
    double apart[2];
    for (const uint32_t substeps : {16u, 32u}) {
        SwingingRopes ropes(substeps);
        for (int frame = 0; frame < 90; ++frame) ropes.step();
        apart[substeps / 32] = ropes.apart();
        std::printf("    %u substeps: free ends apart by %.3g m\n", substeps, ropes.apart());
    }
    CHECK(apart[1] < 1e-4);
    CHECK(apart[1] < apart[0] / 3);
}

TEST_CASE("a weight on a bridle pulls its ropes as statics says, and a soft joint gives way as Hooke says",
          "[simulation]") {
    World world;
    const double mass = 50, g = 9.81, compliance = 1e-4;
    // Two ropes of 3 m from pins 3.6 m apart meet 2.4 m below; a third of 1 m hangs from there.
    const gphys_body_id left = world.rope(line(31, {-1.8f, 0, 0}, {0, -2.4f, 0}), 0, of_mass(0.01f));
    const gphys_body_id right = world.rope(line(31, {1.8f, 0, 0}, {0, -2.4f, 0}), 0, of_mass(0.01f));
    const gphys_body_id down = world.rope(line(11, {0, -2.4f, 0}, {0, -3.4f, 0}), 0, of_mass(0.01f));
    gphys_body_desc heavy = of_mass(static_cast<float>(mass));
    heavy.damping = 5;  // or it would bounce on its spring for ever
    const gphys_body_id weight = world.particles({{0, -3.6f, 0}}, heavy);
    world.pin(left, 0);
    world.pin(right, 0);
    join(world, left, 30, down, 0);
    const gphys_joint_id knot = join(world, right, 30, down, 0);
    const gphys_joint_id spring = join(world, down, 10, weight, 0, 0.2f, static_cast<float>(compliance));
    REQUIRE(joints(world).size() == 3);
    double gap = 0;
    for (int frame = 0; frame < 1200; ++frame) {
        world.step(dt);
        for (const gphys_joint_info& joint : joints(world)) {
            if (joint.id == spring) continue;
            gap = std::max(gap, distance(world.position(joint.body_a, joint.particle_a),
                                         world.position(joint.body_b, joint.particle_b)));
        }
    }
    figure("gap of the knots", gap, "m");
    CHECK(gap <= 1e-6);
    double force_of_knot = 0, force_of_spring = 0;
    for (const gphys_joint_info& joint : joints(world)) {
        if (joint.id == knot) force_of_knot = joint.force;
        if (joint.id == spring) force_of_spring = joint.force;
    }
    // The ropes' own weight, 0.03 kg together, is within the tolerance.
    CHECK(std::fabs(force_of_spring / (mass * g) - 1) < 1e-3);
    CHECK(std::fabs(force_of_knot / (mass * g / 2 / 0.8) - 1) < 1e-3);
    const double stretch = distance(world.position(down, 10), world.position(weight)) - 0.2;
    CHECK(std::fabs(stretch / (mass * g * compliance) - 1) < 2e-3);
}

TEST_CASE("a ring of ropes, a star and a net keep their joints and their lengths", "[simulation]") {
    World world;
    std::vector<gphys_body_id> ropes;
    double most_strain = 1e-5;
    SECTION("ring") {
        for (int k = 0; k < 6; ++k) {
            const auto corner = [](int i) {
                const double angle = gphys::pi / 3 * i;
                return gphys_vec3{static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0};
            };
            ropes.push_back(world.rope(line(21, corner(k), corner(k + 1)), 0));
        }
        for (size_t k = 0; k < 6; ++k) join(world, ropes[k], 20, ropes[(k + 1) % 6], 0);
        world.pin(ropes[0], 0);
    }
    SECTION("star, with weights at the ends") {
        const gphys_body_id hub = world.particles({{0, 0, 0}}, of_mass(0.1f));
        for (int k = 0; k < 8; ++k) {
            const double angle = gphys::pi / 4 * k;
            const gphys_vec3 end{static_cast<float>(std::cos(angle)), 0, static_cast<float>(std::sin(angle))};
            ropes.push_back(world.rope(line(11, {0, 0, 0}, end), 0, of_mass(0.1f)));
            join(world, ropes.back(), 0, hub, 0);
            join(world, ropes.back(), 10, world.particles({end}, of_mass(10)), 0);
        }
        world.pin(ropes[0], 10);
        most_strain = 5e-4;  // of a rope with a thousand times its links' mass at the end
    }
    SECTION("net of 5 x 5 crossing ropes") {
        for (int way = 0; way < 2; ++way) {
            for (int k = 0; k < 5; ++k) {
                const float at = 0.2f * static_cast<float>(k);
                ropes.push_back(way == 0 ? world.rope(line(9, {at, 0, 0}, {at, 0, 0.8f}), 0)
                                         : world.rope(line(9, {0, 0, at}, {0.8f, 0, at}), 0));
            }
        }
        for (uint32_t a = 0; a < 5; ++a) {
            for (uint32_t b = 0; b < 5; ++b) join(world, ropes[a], 2 * b, ropes[5 + b], 2 * a);
        }
        world.pin(ropes[0], 0);
        world.pin(ropes[4], 0);
    }
    double gap = 0, strain = 0;
    const double before = world.energy();
    double most = before;
    for (int frame = 0; frame < 300; ++frame) {
        world.step(dt);
        gap = std::max(gap, worst_gap(world));
        strain = std::max(strain, static_cast<double>(world.stats().strain_max));
        most = std::max(most, world.energy());
    }
    figure("gap", gap, "m");
    figure("strain", strain * 100, "%");
    CHECK(gap <= 1e-6);
    CHECK(strain <= most_strain);
    CHECK(most - before <= 1e-3 * std::fabs(world.energy() - before));
}

TEST_CASE("a weight of a thousand particles hangs by a rope from a corner of cloth", "[simulation]") {
    World world;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {2, 0, 0}, {0, -2, 0}, 30, 30);
    world.pin(sheet, 0);
    world.pin(sheet, 29);
    const uint32_t corner = 29 * 30;
    const gphys_body_id rope = world.rope(line(31, {0, -2, 0}, {0, -3.5f, 0}), 0, of_mass(30.0f / 900));
    const double mass = 1000.0 / 900;
    const gphys_body_id weight = world.particles({{0, -3.5f, 0}}, of_mass(static_cast<float>(mass)));
    join(world, sheet, corner, rope, 0);
    const gphys_joint_id last = join(world, rope, 30, weight, 0);
    double gap = 0, strain = 0, pull = 0;  // the last as a mean over eight seconds
    for (int frame = 0; frame < 660; ++frame) {
        // A push from the side at first, so that it swings by some degrees.
        const gphys_vec3 force{frame < 30 ? 1.0f : 0.0f, 0, frame < 30 ? 1.0f : 0.0f};
        REQUIRE(gphys_solver_set_forces(world.solver, weight, 0, 1, &force, 12) == GPHYS_OK);
        world.step(dt);
        gap = std::max(gap, worst_gap(world));
        strain = std::max(strain, static_cast<double>(world.stats().strain_max));
        for (const gphys_joint_info& joint : joints(world)) {
            if (joint.id == last && frame >= 180) pull += static_cast<double>(joint.force) / 480;
        }
    }
    figure("gap", gap / (2.0 / 29) * 100, "% of a link");
    figure("strain", strain * 100, "%");
    CHECK(gap <= 1e-3 * 2.0 / 29);
    CHECK(strain <= 0.03);
    // It swings by up to 8 degrees: 1 - cos is a hundredth, and its speed adds twice as much.
    CHECK(std::fabs(pull / (mass * 9.81) - 1) < 0.05);
}

TEST_CASE("two sheets that are sewn together hang like one", "[simulation]") {
    World two, one;
    const gphys_body_id upper = two.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 20, 20);
    const gphys_body_id lower = two.cloth({0, 0, 1}, {1, 0, 0}, {0, 0, 1}, 20, 20);
    for (uint32_t i = 0; i < 20; ++i) join(two, upper, 380 + i, lower, i);
    two.pin(upper, 0);
    two.pin(upper, 19);
    const gphys_body_id sheet = one.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 39.0f / 19}, 20, 40, of_mass(2));
    one.pin(sheet, 0);
    one.pin(sheet, 19);
    double gap = 0;
    for (int frame = 0; frame < 900; ++frame) {
        two.step(dt);
        one.step(dt);
        gap = std::max(gap, worst_gap(two));
    }
    figure("gap", gap, "m");
    figure("strain of two", two.stats().strain_max * 100, "%");
    figure("strain of one", one.stats().strain_max * 100, "%");
    CHECK(gap <= 1e-6);
    CHECK(two.stats().strain_max <= 2 * one.stats().strain_max + 0.005f);
}

TEST_CASE("cloth with a rope at a corner gains no energy in substeps of up to half a second", "[simulation]") {
    for (const float heavy : {0.01f, 1.0f, 30.0f, 1000.0f}) {
        for (const float step : {2e-3f, 1 / 60.0f, 0.1f, 0.5f}) cloth_with_a_rope_gains_no_energy(11, heavy, step);
    }
}

TEST_CASE("fine cloth with a rope at a corner gains no energy in any of these substeps", "[.long]") {
    for (const float heavy : {0.01f, 1.0f, 30.0f, 1000.0f}) {
        for (const float step : {2e-3f, 1 / 60.0f, 0.1f, 0.5f}) cloth_with_a_rope_gains_no_energy(41, heavy, step);
    }
}

TEST_CASE("what is joined keeps its momentum when nothing acts from outside") {
    World world(8, {0, 0, 0});
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 12, 12);
    const gphys_body_id rope = world.rope(line(21, {1, 1, 0}, {2, 1, 0}), 0, of_mass(0.5f));
    const gphys_body_id weight = world.particles({{2, 1, 0}}, of_mass(3));
    join(world, sheet, 143, rope, 0);
    join(world, rope, 20, weight, 0);
    world.set_velocity(weight, 0, {0, 3, 2});
    const Momentum before = momentum(world);
    for (int frame = 0; frame < 300; ++frame) world.step(dt);
    const Momentum after = momentum(world);
    const double linear = length(after.linear - before.linear) / length(before.linear);
    const double angular = length(after.angular - before.angular) / length(before.angular);
    figure("linear momentum lost", linear, "parts");
    figure("angular momentum lost", angular, "parts");
    // The thresholds of a free sheet: a thousandth in 5 s. Angular momentum is that of the rope's time scheme.
    CHECK(linear <= 1e-4);
    CHECK(angular <= 3e-3);
}

TEST_CASE("joints between pins too far apart, or of points in one place, stay finite") {
    World world;
    const gphys_body_id left = world.rope(line(11, {0, 0, 0}, {1, 0, 0}), 0);
    const gphys_body_id right = world.rope(line(11, {1, 0, 0}, {2, 0, 0}), 0);
    world.pin(left, 0);
    world.pin(right, 10);
    join(world, left, 10, right, 0);
    const gphys_body_id a = world.particles({{5, 0, 0}}), b = world.particles({{5, 0, 0}});
    join(world, a, 0, b, 0, 0.3f);
    const gphys_body_id c = world.particles({{6, 0, 0}}), d = world.particles({{6.5f, 0, 0}});
    world.pin(c, 0);
    world.pin(d, 0);
    join(world, c, 0, d, 0);
    for (int frame = 0; frame < 60; ++frame) {
        const gphys_vec3 away{2 + 0.05f * static_cast<float>(frame), 0, 0};
        REQUIRE(gphys_solver_set_positions(world.solver, right, 10, 1, &away, 12) == GPHYS_OK);
        world.step(dt);
        for (const gphys_body_id body : {left, right, a, b, c, d}) {
            REQUIRE(test::all_finite(world.positions(body)));
            REQUIRE(test::all_finite(world.velocities(body)));
        }
    }
    // The stretch is shared: 4.95 m by 20 links, each then within a tenth of the mean but those at the pins,
    // which give way by half as much.
    const std::vector<gphys_vec3> shared = world.positions(left);
    for (size_t i = 1; i < 10; ++i) {
        const double link = distance(gphys::widen(shared[i]), gphys::widen(shared[i + 1]));
        CHECK(std::fabs(link / (4.95 / 20) - 1) < 0.1);
    }
    CHECK(std::fabs(distance(world.position(a), world.position(b)) - 0.3) < 1e-4);
}

TEST_CASE("a joint goes with its bodies, wakes them and lets them sleep together") {
    gphys_solver_desc desc;
    gphys_solver_desc_init(&desc, sizeof desc);
    desc.sleep_speed = 0.02f;
    World world;
    gphys_solver_destroy(world.solver);
    REQUIRE(gphys_solver_create(&desc, &world.solver) == GPHYS_OK);
    gphys_body_desc damped = World::body_desc();
    damped.damping = 2;
    const gphys_body_id upper = world.rope(line(11, {0, 0, 0}, {0, -1, 0}), 0, damped);
    const gphys_body_id lower = world.rope(line(11, {0, -1, 0}, {0.2f, -2, 0}), 0, damped);
    world.pin(upper, 0);
    const gphys_joint_id joint = join(world, upper, 10, lower, 0);
    const auto sleeping = [&] {
        uint32_t total = 0;
        gphys_solver_get_sleeping(world.solver, nullptr, 0, &total);
        return total;
    };
    int frames = 0;
    while (sleeping() == 0 && ++frames < 2000) world.step(dt);
    REQUIRE(sleeping() == 2);
    const gphys_vec3 push{1, 0, 0};
    REQUIRE(gphys_solver_set_velocities(world.solver, lower, 10, 1, &push, 12) == GPHYS_OK);
    world.step(dt);
    CHECK(sleeping() == 0);

    CHECK(joints(world, lower).size() == 1);
    REQUIRE(gphys_solver_remove_body(world.solver, upper) == GPHYS_OK);
    CHECK(joints(world).empty());
    CHECK(gphys_solver_unjoin(world.solver, joint) == GPHYS_ERROR_INVALID_ID);
    const double before = world.position(lower, 5).y;
    for (int frame = 0; frame < 30; ++frame) world.step(dt);
    CHECK(before - world.position(lower, 5).y > 0.8);  // it falls: 0.9 m with this damping
}

TEST_CASE("joined bodies collide, and the joint of two on a floor stays closed", "[simulation]") {
    World world;
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const gphys_body_id a = world.rope(line(21, {0, 1, 0}, {1, 1.2f, 0}), 0);
    const gphys_body_id b = world.rope(line(21, {1, 1.2f, 0}, {1, 1, 1}), 0);
    const gphys_body_id sheet = world.cloth({1, 1, 1}, {0.5f, 0, 0}, {0, 0, 0.5f}, 11, 11);
    join(world, a, 20, b, 0);
    join(world, b, 20, sheet, 0);
    double lowest = 1;
    for (int frame = 0; frame < 300; ++frame) {
        world.step(dt);
        for (const gphys_body_id body : {a, b, sheet}) {
            for (const gphys_vec3& p : world.positions(body)) lowest = std::min(lowest, static_cast<double>(p.y));
        }
    }
    figure("gap at rest", worst_gap(world), "m");
    figure("strain at rest", world.stats().strain_max * 100, "%");
    CHECK(lowest >= 0.01 * (1 - 1e-3));
    CHECK(worst_gap(world) <= 1e-3 * 0.05);
    CHECK(world.stats().strain_max <= 0.01f);
}
