// Error targets: each body takes the substeps that its own motion needs. What a target means for the
// position of a rope is in test_solver.cpp, beside its reference.
#include <array>

#include "solver_world.h"

using namespace gphys;
using test::figure;
using test::World;

namespace {

gphys_solver_desc with_strain(float max_strain) {
    gphys_solver_desc desc = World::desc();
    desc.max_strain = max_strain;
    return desc;
}

/// A sheet of 31 x 31, a metre wide, that swings down from the horizontal.
struct Sheet {
    static constexpr uint32_t n = 31;
    World world;
    gphys_body_id body;

    explicit Sheet(const gphys_solver_desc& settings) : world(settings) {
        gphys_body_desc desc = World::body_desc();
        desc.damping = 1;
        desc.cloth_flags = GPHYS_CLOTH_SHEAR;
        body = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, n, n, desc);
        world.pin(body, 0), world.pin(body, n - 1);
    }
    double strain() const { return static_cast<double>(world.stats(body).strain_max); }
};

/// A sheet of 41 x 41, two metres wide, that falls on a ball from 10 cm above.
struct Draped {
    static constexpr uint32_t n = 41;
    const gphys_sphere ball{{0, 0, 0}, 0.5f};
    World world;
    gphys_body_id body;

    explicit Draped(const gphys_solver_desc& settings) : world(settings) {
        gphys_body_desc desc = World::body_desc();
        desc.damping = 1;
        desc.cloth_flags = 0;
        body = world.cloth({-1, 0.6f, -1}, {2, 0, 0}, {0, 0, 2}, n, n, desc);
        world.model(GPHYS_SHAPE_SPHERE, &ball);
    }
};

std::vector<gphys_vec3> hanging(float x) {
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 31; ++i) points.push_back({x, -0.1f * static_cast<float>(i), 0});
    return points;
}

template <class Scene>
void check_snapshots() {
    gphys_solver_desc settings = with_strain(0.01f);
    settings.tolerance = 1e-3f;
    Scene one(settings);
    settings.worker_count = 2;
    Scene two(settings);
    const auto run = [](Scene& sheet) {
        for (int i = 0; i < 20; ++i) sheet.world.step(1.0f / 60);
        std::array<uint32_t, 2> hash{};
        REQUIRE(gphys_solver_get_hash(sheet.world.solver, hash.data()) == GPHYS_OK);
        return hash;
    };
    CHECK(run(one) == run(two));
    std::vector<uint32_t> words(1 << 20);
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_snapshot(one.world.solver, words.data(), static_cast<uint32_t>(words.size()), &total) ==
            GPHYS_OK);
    Scene other(World::desc());
    REQUIRE(gphys_solver_restore(other.world.solver, words.data(), total) == GPHYS_OK);
    CHECK(other.world.substeps(one.body) == one.world.substeps(one.body));
    CHECK(run(other) == run(one));
}

}  // namespace

TEST_CASE("swinging cloth stays within its target of strain, as the default does not", "[simulation]") {
    struct Seen {
        double peak = 0;  // after the jolt in the first half second, which nothing has announced
        uint32_t most = 0, sum = 0;
    };
    const auto swing = [](const gphys_solver_desc& settings) {
        Sheet sheet(settings);
        Seen seen;
        for (int i = 0; i < 240; ++i) {
            sheet.world.step(1.0f / 60);
            if (i >= 30) seen.peak = std::max(seen.peak, sheet.strain());
            seen.most = std::max(seen.most, sheet.world.substeps(sheet.body));
            seen.sum += sheet.world.substeps(sheet.body);
        }
        return seen;
    };
    const Seen untold = swing(World::desc()), told = swing(with_strain(0.01f));
    figure("cloth, peak strain at 8 substeps", untold.peak * 100, "%");
    figure("cloth, peak strain with a target of 1 %", told.peak * 100, "%");
    figure("cloth, substeps a step with a target of 1 %", told.sum / 240.0, "");
    CHECK(untold.peak > 0.01);
    CHECK(told.peak <= 0.01);
    CHECK(told.sum < 240 * 20);
    CHECK(told.most <= 64);
}

TEST_CASE("what moves little takes fewer substeps than the default, and keeps its targets") {
    gphys_solver_desc settings = with_strain(0.01f);
    settings.tolerance = 1e-4f;
    World world(settings);
    const gphys_body_id still = world.rope(hanging(0), 0.1f), swinging = world.rope(hanging(1), 0.1f);
    const gphys_body_id flying = world.particles({{5, 0, 0}});
    world.pin(still, 0), world.pin(swinging, 0);
    world.set_velocity(swinging, 30, {20, 0, 0});
    CHECK(world.substeps(still) == 0);
    world.step(1.0f / 60);
    CHECK(world.substeps(still) == 8);
    for (int i = 0; i < 60; ++i) world.step(1.0f / 60);
    CHECK(world.substeps(still) == 1);
    CHECK(world.substeps(flying) == 1);
    CHECK(world.substeps(swinging) > 8);
    CHECK(length(world.position(still, 30) - Vec3{0, -3, 0}) < 1e-5);
    // The length of substeps is kept when that of steps changes.
    const uint32_t before = world.substeps(swinging);
    world.step(1.0f / 120);
    CHECK(world.substeps(swinging) <= before / 2 + 1);
}

TEST_CASE("targets that cannot be met take the most substeps, and no more") {
    gphys_solver_desc settings = with_strain(0.001f);
    settings.max_substeps = 12;
    World world(settings);
    // Pinned a tenth too far apart.
    const gphys_body_id rope = world.rope({{0, 0, 0}, {0.55f, 0, 0}, {1.1f, 0, 0}}, 0.5f);
    world.pin(rope, 0), world.pin(rope, 2);
    for (int i = 0; i < 10; ++i) world.step(1.0f / 60);
    CHECK(world.substeps(rope) == 12);
    CHECK(world.stats(rope).strain_max > 0.09f);
}

TEST_CASE("cloth that lands on a ball and whips around it meets its target in every step", "[simulation]") {
    struct Seen {
        double peak = 0;
        uint32_t most = 0, last = 0, inside = 0;
    };
    const auto drape = [](const gphys_solver_desc& settings) {
        Draped sheet(settings);
        Seen seen;
        for (int i = 0; i < 240; ++i) {
            sheet.world.step(1.0f / 60);
            seen.peak = std::max(seen.peak, static_cast<double>(sheet.world.stats(sheet.body).strain_max));
            seen.last = sheet.world.substeps(sheet.body);
            seen.most = std::max(seen.most, seen.last);
            for (const gphys_vec3& p : sheet.world.positions(sheet.body)) {
                seen.inside += length(widen(p)) < static_cast<double>(sheet.ball.radius);
            }
        }
        return seen;
    };
    const Seen untold = drape(World::desc()), told = drape(with_strain(0.02f));
    figure("draped cloth, peak strain at 8 substeps", untold.peak * 100, "%");
    figure("draped cloth, peak strain with a target of 2 %", told.peak * 100, "%");
    figure("draped cloth, most substeps with that target", told.most, "");
    figure("draped cloth, substeps at rest with that target", told.last, "");
    CHECK(untold.peak <= 0.03);
    CHECK(told.peak <= static_cast<double>(0.02f));
    CHECK(told.most > 8);
    CHECK(told.most <= 64);
    CHECK(told.last <= 8);
    CHECK(told.inside == 0);
}

TEST_CASE("what a target of strain asks for adds no energy to cloth", "[simulation]") {
    // Without damping, and so close a target that links are relaxed in every step.
    const float target = GENERATE(0.02f, 0.005f);
    World world(with_strain(target));
    gphys_body_desc desc = World::body_desc();
    desc.cloth_flags = 0;
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 31, 31, desc);
    world.pin(sheet, 0), world.pin(sheet, 30);
    const double before = world.energy(sheet);
    double most = before;
    for (int i = 0; i < 600; ++i) {
        world.step(1.0f / 60);
        most = std::max(most, world.energy(sheet));
    }
    CHECK(most <= before);
}

TEST_CASE("steps with targets are part of a snapshot, and the same for any number of workers", "[simulation]") {
    check_snapshots<Sheet>();
    check_snapshots<Draped>();
}

TEST_CASE("springs and slack strings have no strain that substeps could mend") {
    const bool strings = GENERATE(true, false);
    gphys_solver_desc desc = World::desc(8);
    desc.max_strain = 0.01f;
    World world(desc);
    // A spring that its load stretches by half, or a string of twice the length that it is given: both at rest.
    const gphys_body_id body = world.particles({{0, 0, 0}, {0, strings ? -0.5f : -1.5f, 0}});
    world.pin(body, 0);
    gphys_constraint_id id = 0;
    if (strings) {
        REQUIRE(gphys_solver_add_max_distance(world.solver, body, 0, 1, 1, 0, &id) == GPHYS_OK);
        world.pin(body, 1);
    } else {
        REQUIRE(gphys_solver_add_distance(world.solver, body, 0, 1, 1, 0.5f / (0.5f * 9.81f), &id) == GPHYS_OK);
    }
    for (int i = 0; i < 240; ++i) world.step(1.0f / 60);
    CHECK(world.substeps(body) == 1);
}
