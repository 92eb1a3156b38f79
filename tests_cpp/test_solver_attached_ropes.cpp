// Ropes that hang on models that move: hair, tails, lamps, cranes.
#include <cmath>

#include "solver_world.h"

namespace {

using gphys::Vec3;
using test::World;

constexpr float frame = 1.0f / 60;
constexpr int frames = 90;

/// A hub that sways and turns, with ropes of 4 particles and more fixed around it.
struct Hub {
    enum class Near { nothing, model };

    explicit Hub(Near near, uint32_t substeps = 8) : world(substeps) {
        const gphys_sphere sphere{{0, 0, 0}, 0.1f};
        hub = world.model(GPHYS_SHAPE_SPHERE, &sphere);
        desc.layers = near == Near::model ? 1 : 0;
        if (near == Near::model) {
            // Within a step's reach of the ropes, and never touched.
            const gphys_plane below{{0, 1, 0}, -1.7f};
            const gphys_model_id model = world.model(GPHYS_SHAPE_PLANE, &below);
            REQUIRE(gphys_scene_set_layers(world.scene, hub, 2) == GPHYS_OK);
            REQUIRE(gphys_scene_set_layers(world.scene, model, 1) == GPHYS_OK);
        }
    }

    void add(uint32_t i) {
        const float angle = static_cast<float>(i), x = std::cos(angle), z = std::sin(angle);
        const gphys_body_id rope =
            world.rope(test::line({0.15f * x, 0, 0.15f * z}, {0.1f * x, -0.05f, 0.1f * z}, 4 + i), 0, desc);
        REQUIRE(gphys_solver_attach(world.solver, world.scene, rope, 0, hub, nullptr) == GPHYS_OK);
        ropes.push_back(rope);
    }

    static gphys_transform transform(int n) {
        const float time = static_cast<float>(n) * frame, half = std::sin(2 * time) / 2;
        return {{0.3f * std::sin(4 * time), 0.1f * std::sin(9 * time), 0}, {0, std::sin(half), 0, std::cos(half)}, 1};
    }
    void step() {
        const gphys_transform next = transform(++count);
        REQUIRE(gphys_scene_set_transform(world.scene, hub, &next) == GPHYS_OK);
        world.step(frame);
    }

    /// What the hub was given in the last step, N s.
    Vec3 impulse() const {
        gphys_impulse impulses[4];
        uint32_t total = 0;
        REQUIRE(gphys_solver_get_impulses(world.solver, impulses, 4, &total) == GPHYS_OK);
        REQUIRE(total <= 4);
        for (uint32_t i = 0; i < total; ++i) {
            if (impulses[i].model == hub) return gphys::widen(impulses[i].linear);
        }
        return {};
    }

    World world;
    gphys_body_desc desc = World::body_desc();
    gphys_model_id hub = 0;
    std::vector<gphys_body_id> ropes;
    int count = 0;
};

double farthest(const std::vector<gphys_vec3>& a, const std::vector<gphys_vec3>& b) {
    double most = 0;
    for (size_t i = 0; i < a.size(); ++i) most = std::max(most, distance(gphys::widen(a[i]), gphys::widen(b[i])));
    return most;
}

}  // namespace

TEST_CASE("A rope on a model that moves does not depend on other ropes") {
    Hub all(Hub::Near::nothing);
    for (uint32_t i = 0; i < 11; ++i) all.add(i);
    for (int n = 0; n < frames; ++n) all.step();
    for (uint32_t i = 0; i < 11; ++i) {
        Hub alone(Hub::Near::nothing);
        alone.add(i);
        for (int n = 0; n < frames; ++n) alone.step();
        // Bit for bit: ropes of several lengths share the lanes of registers.
        CHECK(farthest(all.world.positions(all.ropes[i]), alone.world.positions(alone.ropes[0])) == 0);
    }
}

TEST_CASE("A rope on a model that moves does not depend on whether another model is near") {
    Hub free(Hub::Near::nothing), near(Hub::Near::model);
    for (uint32_t i = 0; i < 11; ++i) free.add(i), near.add(i);
    double worst = 0, most_given = 0;
    for (int n = 0; n < frames; ++n) {
        free.step(), near.step();
        most_given = std::max(most_given, length(free.impulse() - near.impulse()) / length(near.impulse()));
        for (uint32_t i = 0; i < 11; ++i) {
            worst = std::max(worst, farthest(free.world.positions(free.ropes[i]), near.world.positions(near.ropes[i])));
        }
    }
    test::figure("difference", worst, "m");
    test::figure("difference of what the model is given, relative", most_given, "");
    // The same equations, solved to 1e-7 of a link by different kernels.
    CHECK(worst < 1e-5);
    CHECK(most_given < 1e-4);
}

TEST_CASE("Ropes on a model that moves follow it exactly, keep their length, and converge", "[simulation]") {
    const auto end = [](uint32_t substeps) {
        Hub hub(Hub::Near::nothing, substeps);
        for (uint32_t i = 0; i < 8; ++i) hub.add(i);
        for (int n = 0; n < 60; ++n) hub.step();
        std::vector<gphys_vec3> all;
        for (uint32_t i = 0; i < 8; ++i) {
            const std::vector<gphys_vec3> places = hub.world.positions(hub.ropes[i]);
            const float angle = static_cast<float>(i);
            const Vec3 held = gphys::widen(Hub::transform(hub.count))
                                  .apply({double{0.15f * std::cos(angle)}, 0, double{0.15f * std::sin(angle)}});
            // The local point and the place are rounded to float32.
            CHECK(distance(gphys::widen(places[0]), held) < 1e-7);
            for (size_t k = 1; k < places.size(); ++k) {
                const double link = distance(gphys::widen(places[k - 1]), gphys::widen(places[k]));
                CHECK(std::fabs(link / std::hypot(0.1, 0.05) - 1) < 1e-5);
            }
            all.insert(all.end(), places.begin(), places.end());
        }
        return all;
    };
    const std::vector<gphys_vec3> exact = end(512);
    double errors[3];
    for (int i = 0; i < 3; ++i) {
        errors[i] = farthest(end(8u << i), exact);
        std::printf("    error with %d substeps: %.3g m\n", 8 << i, errors[i]);
    }
    // Models move at a constant speed in each step, so each step begins with a jerk, and the order is 1.
    CHECK(errors[0] < 0.02);
    CHECK(errors[1] < 0.6 * errors[0]);
    CHECK(errors[2] < 0.6 * errors[1]);
}

TEST_CASE("A rope that two models pull beyond its length shares the stretch, and has its length when they let go") {
    constexpr uint32_t links = 20;
    // Above ground that is near, and that the rope may touch when it sags, and above nothing.
    const bool near = GENERATE(false, true);
    World world(8);
    const gphys_sphere knob{{0, 0, 0}, 0.05f};
    const gphys_transform apart{{0.9f, 0, 0}, {0, 0, 0, 1}, 1};
    const gphys_model_id left = world.model(GPHYS_SHAPE_SPHERE, &knob);
    const gphys_model_id right = world.model(GPHYS_SHAPE_SPHERE, &knob, &apart);
    const gphys_plane ground{{0, 1, 0}, -0.25f};
    const gphys_model_id below = world.model(GPHYS_SHAPE_PLANE, &ground);
    REQUIRE(gphys_scene_set_layers(world.scene, left, 2) == GPHYS_OK);
    REQUIRE(gphys_scene_set_layers(world.scene, right, 2) == GPHYS_OK);
    REQUIRE(gphys_scene_set_layers(world.scene, below, 1) == GPHYS_OK);
    gphys_body_desc desc = World::body_desc();
    desc.layers = near ? 1 : 0;
    const gphys_body_id rope = world.rope(test::line({0, 0, 0}, {0.045f, 0, 0}, links + 1), 0.05f, desc);
    REQUIRE(gphys_solver_attach(world.solver, world.scene, rope, 0, left, nullptr) == GPHYS_OK);
    REQUIRE(gphys_solver_attach(world.solver, world.scene, rope, links, right, nullptr) == GPHYS_OK);
    double worst = 0;
    for (int n = 1; n <= 180; ++n) {
        // 0.9 to 1.3 m and back, twice.
        const float span = 1.1f - 0.2f * std::cos(static_cast<float>(n) * frame * 4.1887902f);
        const gphys_transform moved{{span, 0, 0}, {0, 0, 0, 1}, 1};
        REQUIRE(gphys_scene_set_transform(world.scene, right, &moved) == GPHYS_OK);
        world.step(frame);
        const std::vector<gphys_vec3> places = world.positions(rope);
        const double mean = std::max(1.0, double{span}) / links;
        for (uint32_t k = 1; k <= links; ++k) {
            const double link = distance(gphys::widen(places[k - 1]), gphys::widen(places[k]));
            worst = std::max(worst, std::fabs(link / mean - 1));
        }
    }
    test::figure(near ? "largest strain beyond the mean, near the ground" : "largest strain beyond the mean", worst,
                 "");
    CHECK(worst < 0.01);
}
