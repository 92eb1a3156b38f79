// Cloth that was pulled beyond its reach, and crumpled by it, hangs as before when it is let go.
#include "snapshots.h"
#include "solver_world.h"

using namespace gphys;
using test::World;

namespace {

constexpr float dt = 1.0f / 60;
constexpr uint32_t side = 20, middle = side * (side / 2) + side / 2 - 1;

struct Curtain {
    World world;
    gphys_body_id body;

    static gphys_body_desc damped() {
        gphys_body_desc desc = World::body_desc();
        desc.damping = 1;
        return desc;
    }
    explicit Curtain(uint32_t substeps)
        : world(substeps), body(world.cloth({0, 0, 0}, {1, 0, 0}, {0, -1, 0.02f}, side, side, damped())) {
        world.pin(body, 0);
        world.pin(body, side - 1);
        steps(60);
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i) REQUIRE(gphys_solver_step(world.solver, world.scene, dt) == GPHYS_OK);
    }
    gphys_vec3 at(uint32_t particle) const {
        gphys_vec3 place;
        REQUIRE(gphys_solver_get_positions(world.solver, body, particle, 1, &place, 12) == GPHYS_OK);
        return place;
    }
    gphys_solver_stats stats() const {
        gphys_solver_stats stats;
        REQUIRE(gphys_solver_get_stats(world.solver, body, &stats) == GPHYS_OK);
        return stats;
    }
    /// Pulls the middle aside and up by so many metres, within some frames. Returns the largest kinetic energy.
    double pull(float by, int frames) {
        const gphys_vec3 from = at(middle);
        double largest = 0;
        world.pin(body, middle);
        for (int i = 1; i <= frames; ++i) {
            const float part = by * static_cast<float>(i) / static_cast<float>(frames);
            const gphys_vec3 to{from.x + 0.3f * part, from.y + 0.3f * part, from.z + part};
            REQUIRE(gphys_solver_set_positions(world.solver, body, middle, 1, &to, 12) == GPHYS_OK);
            steps(1);
            largest = std::max(largest, static_cast<double>(stats().kinetic_energy));
        }
        REQUIRE(gphys_solver_set_pinned(world.solver, body, middle, 1, 0) == GPHYS_OK);
        return largest;
    }
    void check_hangs() const {
        const gphys_solver_stats now = stats();
        CHECK(now.strain_max < 0.03);
        CHECK(now.kinetic_energy < 0.1);
        CHECK(now.potential_energy < -4.6);  // 1 kg, 0.5 m below its pins: -4.9
    }
};

void pull_and_let_go(uint32_t substeps, int frames) {
    Curtain curtain(substeps);
    curtain.pull(0.5f, frames);
    curtain.steps(360);
    curtain.check_hangs();
}

}  // namespace

TEST_CASE("a curtain that is pulled in its middle beyond its reach hangs as before when it is let go", "[simulation]") {
    pull_and_let_go(8, 30);
    pull_and_let_go(8, 300);
    pull_and_let_go(32, 30);
}
TEST_CASE("a curtain that is pulled in its middle hangs as before in more substeps", "[.long]") {
    pull_and_let_go(16, 30);
    pull_and_let_go(16, 300);
    pull_and_let_go(32, 300);
}

TEST_CASE("a curtain that is held beyond its reach gains little energy", "[simulation]") {
    Curtain curtain(8);
    CHECK(curtain.pull(0.4f, 300) < 5);
}

TEST_CASE("a curtain that a large force has crumpled hangs as before") {
    Curtain curtain(8);
    const gphys_vec3 force{3000, 3000, 10000}, none{0, 0, 0};
    REQUIRE(gphys_solver_set_forces(curtain.world.solver, curtain.body, middle, 1, &force, 12) == GPHYS_OK);
    curtain.steps(30);
    REQUIRE(gphys_solver_set_forces(curtain.world.solver, curtain.body, middle, 1, &none, 12) == GPHYS_OK);
    curtain.steps(360);
    curtain.check_hangs();
}

TEST_CASE("a crumpled curtain goes on alike from a snapshot") {
    Curtain curtain(8);
    curtain.pull(0.5f, 30);
    const auto words = test::snapshot(curtain.world.solver);
    World other;
    REQUIRE(test::restore(other.solver, words) == GPHYS_OK);
    for (int i = 0; i < 120; ++i) {
        curtain.steps(1);
        REQUIRE(gphys_solver_step(other.solver, other.scene, dt) == GPHYS_OK);
        REQUIRE(test::hash(other.solver) == test::hash(curtain.world.solver));
    }
}
