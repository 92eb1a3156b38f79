// Balls that begin in each other, in models, or between models that close on them: they come apart without speed.
#include "solver_world.h"

using test::figure;
using test::World;

namespace {

constexpr float frame = 1 / 60.0f;

gphys_transform placed(gphys_vec3 at) { return {at, {0, 0, 0, 1}, 1}; }

gphys_model_id ball(World& world, float radius, gphys_vec3 at) {
    const gphys_sphere sphere{{0, 0, 0}, radius};
    const gphys_transform transform = placed(at);
    return world.model(GPHYS_SHAPE_SPHERE, &sphere, &transform);
}

gphys_body_desc balls(float radius) {
    gphys_body_desc desc = World::body_desc();
    desc.radius = radius;
    desc.friction = 0.3f;
    desc.self_collision = 1;
    desc.body_layers = 1;
    return desc;
}

float fastest(const World& world, gphys_body_id body) {
    float most = 0;
    for (const gphys_vec3& v : world.velocities(body)) most = std::max(most, std::hypot(v.x, v.y, v.z));
    return most;
}

/// 324 balls at rest in a pit of 2 x 2 m.
struct Heap {
    static constexpr float radius = 0.09f;
    World world;
    gphys_body_id body;

    Heap() {
        const gphys_plane ground{{0, 1, 0}, 0};
        world.model(GPHYS_SHAPE_PLANE, &ground);
        for (const float side : {-1.1f, 1.1f}) {
            world.box({0.1f, 1, 1.1f}, {side, 1, 0});
            world.box({1.1f, 1, 0.1f}, {0, 1, side});
        }
        std::vector<gphys_vec3> places;
        for (int i = 0; i < 324; ++i) {
            const auto layer = static_cast<float>(i / 81);
            places.push_back({-0.85f + 0.21f * static_cast<float>(i / 9 % 9) + 0.003f * layer, 0.1f + 0.2f * layer,
                              -0.85f + 0.21f * static_cast<float>(i % 9)});
        }
        gphys_body_desc desc = balls(radius);
        desc.mass = 60;
        desc.damping = 0.5f;
        body = world.particles(places, desc);
        for (int i = 0; i < 180; ++i) world.step(frame);
    }
    /// The greatest speed in two seconds; call(i) before each step.
    template <class Call>
    float fastest_while(Call&& call) {
        float most = 0;
        for (int i = 0; i < 120; ++i) {
            call(i);
            world.step(frame);
            most = std::max(most, fastest(world, body));
        }
        return most;
    }
    bool all_inside() const {
        for (const gphys_vec3& at : world.positions(body)) {
            if (std::max(std::fabs(at.x), std::fabs(at.z)) > 1 - radius || at.y < radius) return false;
        }
        return true;
    }
};

/// 2000 balls, with so many substeps, fall on each other in a pit of 2 x 2 m.
void pour_into_a_deep_heap(uint32_t substeps) {
    constexpr float radius = 0.1f;
    World world(substeps);
    const gphys_plane planes[] = {{{0, 1, 0}, 0}, {{1, 0, 0}, -1}, {{-1, 0, 0}, -1}, {{0, 0, 1}, -1}, {{0, 0, -1}, -1}};
    for (const gphys_plane& plane : planes) world.model(GPHYS_SHAPE_PLANE, &plane);
    std::vector<gphys_vec3> places;
    for (int i = 0; i < 2000; ++i) {
        // Moved from the grid by up to 1 cm: layers that lie exactly above each other would stay there.
        const auto along = [](int place, int moved) {
            return 0.24f * (static_cast<float>(place) - 3.5f) + 0.02f * (static_cast<float>(moved % 101) / 100 - 0.5f);
        };
        places.push_back({along(i % 8, 37 * i), 0.2f + 0.24f * static_cast<float>(i / 64), along(i / 8 % 8, 71 * i)});
    }
    gphys_body_desc desc = balls(radius);
    desc.friction = 0;
    const gphys_body_id body = world.particles(places, desc);
    double most = world.energy(body), before = most;
    for (int i = 0; i < 180; ++i) {
        world.step(frame);
        most = std::max(most, world.energy(body));
    }
    INFO(substeps << " substeps");
    CHECK(most < before * (1 + 1e-6));
    CHECK(fastest(world, body) < 5);
    std::vector<gphys_vec3> at = world.positions(body);
    std::sort(at.begin(), at.end(), [](const gphys_vec3& a, const gphys_vec3& b) { return a.x < b.x; });
    double nearest = 1;
    for (size_t i = 0; i < at.size(); ++i) {
        for (size_t k = i + 1; k < at.size() && at[k].x - at[i].x < 2 * radius; ++k) {
            const double apart = std::hypot(at[k].x - at[i].x, at[k].y - at[i].y, at[k].z - at[i].z);
            nearest = std::min(nearest, apart / (2.0 * radius));
        }
    }
    figure("nearest pair in a heap", nearest, "diameters");
    figure("fastest in a heap", fastest(world, body), "m/s");
    if (substeps >= 4) CHECK(nearest > (substeps == 4 ? 0.95 : 0.98));
}

}  // namespace

TEST_CASE("Two balls that begin too near come apart without speed, however deep they are") {
    constexpr gphys_vec3 still{0, 0, 0};
    for (const float overlap : {0.02f, 0.1f, 0.5f, 0.9f, 1.0f}) {
        World world;
        REQUIRE(gphys_solver_set_gravity(world.solver, &still) == GPHYS_OK);
        const gphys_body_id body = world.particles({{0, 0, 0}, {0.07f * (1 - overlap), 0, 0}}, balls(0.035f));
        for (int i = 0; i < 30; ++i) world.step(frame);
        const std::vector<gphys_vec3> at = world.positions(body);
        CHECK(std::hypot(at[1].x - at[0].x, at[1].y - at[0].y, at[1].z - at[0].z) > 0.07f * 0.999f);
        // An error of 0.001 diameters is corrected with the velocities, half by each ball, in a substep of 1 / 480 s.
        CHECK(fastest(world, body) < 1.01f * 0.001f * 0.07f / 2 * 480);
    }
}

TEST_CASE("A model that appears in a heap of balls, or grows there, throws none away", "[simulation]") {
    // A ball that slides from a model into free room falls by at most 0.3 m.
    const float falling = std::sqrt(2 * 9.81f * 0.3f);
    for (const float radius : {0.1f, 0.3f}) {
        Heap heap;
        ball(heap.world, radius, {0, 0.3f, 0});
        const float most = heap.fastest_while([](int) {});
        figure("a ball appears", most, "m/s");
        CHECK(most < falling);
        CHECK(heap.all_inside());
    }
    {
        Heap heap;
        heap.world.box({0.2f, 0.2f, 0.2f}, {0, 0.3f, 0});
        const float most = heap.fastest_while([](int) {});
        figure("a crate appears", most, "m/s");
        CHECK(most < falling);
        CHECK(heap.all_inside());
    }
    Heap heap;
    const gphys_model_id grows = ball(heap.world, 0.02f, {0, 0.3f, 0});
    const float most = heap.fastest_while([&](int i) {
        const gphys_sphere sphere{{0, 0, 0}, std::min(0.3f, 0.02f + 0.005f * static_cast<float>(i))};
        REQUIRE(gphys_scene_set_shape(heap.world.scene, grows, GPHYS_SHAPE_SPHERE, &sphere) == GPHYS_OK);
    });
    figure("a ball grows", most, "m/s");
    CHECK(most < falling);
    CHECK(heap.all_inside());
}

TEST_CASE("What a model presses against a wall gets no more than its speed") {
    constexpr float radius = 0.09f, speed = 0.7f;
    for (const int count : {1, 2, 3}) {
        for (const float overlap : {0.01f, 0.1f}) {
            for (const bool round : {false, true}) {
                World world;
                const gphys_plane ground{{0, 1, 0}, 0};
                world.model(GPHYS_SHAPE_PLANE, &ground);
                world.box({0.1f, 1, 1}, {1.1f, 1, 0});
                std::vector<gphys_vec3> places;
                for (int i = 0; i < count; ++i) places.push_back({0.9f - 0.2f * static_cast<float>(i), 0.0901f, 0});
                const gphys_body_id body = world.particles(places, balls(radius));
                const float to = 0.7f - 2 * radius * static_cast<float>(count) + overlap, from = to - 0.3f;
                const gphys_model_id presses =
                    round ? ball(world, 0.3f, {from, 0.3f, 0}) : world.box({0.3f, 0.3f, 0.3f}, {from, 0.3f, 0});
                float most = 0;
                for (int i = 0; i < 100; ++i) {
                    const gphys_transform there =
                        placed({std::min(to, from + speed * frame * static_cast<float>(i)), 0.3f, 0});
                    REQUIRE(gphys_scene_set_transform(world.scene, presses, &there) == GPHYS_OK);
                    world.step(frame);
                    most = std::max(most, fastest(world, body));
                }
                INFO(count << " balls, overlap " << overlap << (round ? ", a ball presses" : ", a box presses"));
                // A box that presses three deeply squeezes one out between the others: it goes up as well, as fast as
                // the box comes.
                const bool squeezed_out = count == 3 && !round && overlap > 0.05f;
                CHECK(most < (squeezed_out ? std::sqrt(2.0f) : 1.2f) * speed);
            }
        }
    }
}

TEST_CASE("Balls poured into a deep heap gain no energy, and do not sink into each other", "[simulation]") {
    for (const uint32_t substeps : {1u, 8u}) pour_into_a_deep_heap(substeps);
}
TEST_CASE("Balls poured into a deep heap gain no energy, nor do they sink, with other numbers of substeps", "[.long]") {
    for (const uint32_t substeps : {2u, 3u, 4u}) pour_into_a_deep_heap(substeps);
}

TEST_CASE("Targets of strain and of error take no substeps from balls that are poured into a heap", "[simulation]") {
    constexpr float radius = 0.05f;
    for (const bool of_strain : {true, false}) {
        gphys_solver_desc settings = World::desc(8);
        (of_strain ? settings.max_strain : settings.tolerance) = 0.02f;
        World world(settings);
        const gphys_plane planes[] = {
            {{0, 1, 0}, 0}, {{1, 0, 0}, -0.5f}, {{-1, 0, 0}, -0.5f}, {{0, 0, 1}, -0.5f}, {{0, 0, -1}, -0.5f}};
        for (const gphys_plane& plane : planes) world.model(GPHYS_SHAPE_PLANE, &plane);
        std::vector<gphys_vec3> places;
        for (int i = 0; i < 512; ++i) {
            const auto along = [](int place, int moved) {
                return 0.12f * (static_cast<float>(place) - 3.5f) + 0.0001f * static_cast<float>(moved % 101);
            };
            places.push_back(
                {along(i % 8, 37 * i), 0.06f + 0.12f * static_cast<float>(i / 64), along(i / 8 % 8, 71 * i)});
        }
        const gphys_body_id body = world.particles(places, balls(radius));
        double nearest = 1;
        for (int step = 0; step < 120; ++step) {
            world.step(frame);
            const std::vector<gphys_vec3> at = world.positions(body);
            for (size_t i = 0; i < at.size() && step % 10 == 0; ++i) {
                for (size_t k = 0; k < i; ++k) {
                    const double apart = std::hypot(at[k].x - at[i].x, at[k].y - at[i].y, at[k].z - at[i].z);
                    nearest = std::min(nearest, apart / (2.0 * radius));
                }
            }
        }
        INFO((of_strain ? "a target of strain" : "a target of error"));
        figure("nearest pair", nearest, "diameters");
        CHECK(world.substeps(body) == 8);
        CHECK(nearest > 0.95);  // in a single substep: 0.3
    }
}
