// Cloth on models that move comes to rest in their motion. It slides, swings and is thrown as before.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "snapshots.h"

using test::figure;
using test::World;

namespace {

constexpr float frame = 1.0f / 60;
constexpr double pi = 3.14159265358979;

using Place = std::array<double, 3>;

/// Where a model is, and by how much it is turned about one of the axes.
struct Motion {
    Place shift{};
    double angle = 0;
    int axis = 2;
};

/// A sheet on a model that moves.
struct Ride : World {
    gphys_body_id sheet = 0;
    gphys_model_id model_id = 0;
    Motion now;

    void box(float half_x, float half_y, float half_z) {
        const gphys_aabb shape{{-half_x, -half_y, -half_z}, {half_x, half_y, half_z}};
        model_id = model(GPHYS_SHAPE_AABB, &shape);
    }
    void drape(float height, uint32_t particles, float side = 2) {
        sheet = cloth({-side / 2, height, -side / 2}, {side, 0, 0}, {0, 0, side}, particles, particles, body_desc());
    }
    static gphys_transform transform(const Motion& motion) {
        float turn[3] = {0, 0, 0};
        turn[motion.axis] = static_cast<float>(std::sin(motion.angle / 2));
        const auto narrow = [](double x) { return static_cast<float>(x); };
        return {{narrow(motion.shift[0]), narrow(motion.shift[1]), narrow(motion.shift[2])},
                {turn[0], turn[1], turn[2], narrow(std::cos(motion.angle / 2))},
                1};
    }
    void move_to(const Motion& motion) {
        now = motion;
        const gphys_transform place = transform(motion);
        REQUIRE(gphys_scene_set_transform(scene, model_id, &place) == GPHYS_OK);
        step(frame);
    }
    /// The particles as the model sees them.
    std::vector<Place> seen() const {
        std::vector<Place> out;
        const double c = std::cos(now.angle), s = std::sin(now.angle);
        const int u = (now.axis + 1) % 3, v = (now.axis + 2) % 3;
        for (const gphys_vec3& at : positions(sheet)) {
            const Place p{at.x - now.shift[0], at.y - now.shift[1], at.z - now.shift[2]};
            Place q = p;
            q[u] = c * p[u] + s * p[v];
            q[v] = c * p[v] - s * p[u];
            out.push_back(q);
        }
        return out;
    }
    /// Its root mean square speed relative to the model while it moves so from one time to another.
    double speed(const std::function<Motion(double)>& motion, int first, int last) {
        double sum = 0;
        size_t count = 0;
        std::vector<Place> before;
        for (int i = first; i < last; ++i) {
            move_to(motion(i * double{frame}));
            const std::vector<Place> after = seen();
            for (size_t p = 0; p < before.size(); ++p, ++count)
                for (int k = 0; k < 3; ++k) sum += std::pow((after[p][k] - before[p][k]) / frame, 2);
            before = after;
        }
        return std::sqrt(sum / static_cast<double>(count));
    }
    double middle() const {
        double sum = 0;
        for (const Place& p : seen()) sum += p[0];
        return sum / static_cast<double>(positions(sheet).size());
    }
};

double swing(double time, double frequency) { return std::sin(2 * pi * frequency * time); }

}  // namespace

TEST_CASE("a default sheet on a model that moves comes to rest in its motion", "[simulation]") {
    const std::function<Motion(double)> motions[] = {
        [](double t) {
            return Motion{{0, 0.01 * swing(t, 0.25), 0}};
        },  // breathes
        [](double t) {
            return Motion{{0.02 * swing(t, 0.3), 0, 0}, 0.02 * swing(t, 0.3)};
        },  // sways
        [](double t) {
            return Motion{{0, 0.5 * t, 0}};
        },  // a lift
        [](double t) {
            return Motion{{0, 0, 0}, 0.5 * t, 1};
        },  // a turntable
        [](double t) {
            return Motion{{0, 0.2 * swing(t, 0.15), 0}, 0.06 * swing(t, 0.12)};
        },  // a boat
    };
    for (const uint32_t substeps : {8u, 3u}) {
        for (const auto& motion : motions) {
            Ride ride;
            REQUIRE(gphys_solver_set_substeps(ride.solver, substeps) == GPHYS_OK);
            ride.box(0.6f, 0.02f, 0.4f);
            ride.drape(0.04f, 20, 1.6f);
            ride.speed(motion, 0, 720);
            const double speed = ride.speed(motion, 720, 900);
            figure("speed of a sheet on a model that moves, relative to it", speed, "m/s");
            CHECK(speed < 0.002);
        }
    }
}

TEST_CASE("a sheet that lies partly on a model that moves slowly comes to rest, too", "[simulation]") {
    Ride ride;
    ride.box(0.5f, 0.1f, 0.5f);
    const gphys_aabb beside{{0.5f, -0.1f, -0.5f}, {1.5f, 0.1f, 0.5f}};
    ride.model(GPHYS_SHAPE_AABB, &beside);
    ride.drape(0.12f, 20);
    const auto motion = [](double t) { return Motion{{0, 0, 0.004 * swing(t, 0.2)}}; };
    ride.speed(motion, 0, 720);
    const double speed = ride.speed(motion, 720, 900);
    figure("speed of a sheet on two models, relative to one that moves at up to 5 mm/s", speed, "m/s");
    CHECK(speed < 0.006);
}

TEST_CASE("a sheet at rest on a plate slides when the plate brakes, as Coulomb's law says", "[simulation]") {
    for (const double braking : {0.5, 4.0, 6.0}) {
        Ride ride;
        ride.box(2, 0.1f, 2);
        ride.drape(0.111f, 15, 1);
        // The plate changes its speed from step to step, so that a block on it slides for a moment in each.
        double x = 0, speed = 0, sliding = 0, exact = 0;
        const auto drive = [&](double acceleration) {
            const double before = speed, stop = 0.5 * 9.81 * frame;
            speed = std::clamp(speed + acceleration * frame, 0.0, 3.0);
            x += speed * frame;
            sliding += before - speed;
            const double after = std::copysign(std::max(0.0, std::fabs(sliding) - stop), sliding);
            exact += (sliding * sliding - after * after) / (2 * 0.5 * 9.81) * (sliding > 0 ? 1 : -1);
            sliding = after;
            ride.move_to({{x, 0, 0}});
        };
        for (int i = 0; i < 480; ++i) drive(0.5);
        const double before = ride.middle();
        exact = 0;
        for (int i = 0; i < 400; ++i) drive(-braking);
        const double slip = ride.middle() - before;
        figure("slip of a sheet on a plate that brakes", slip, "m");
        figure("that of a block", exact, "m");
        // Friction acts for whole substeps, and is half a substep ahead.
        CHECK(std::fabs(slip - exact) < 3 * frame / 8);
    }
}

TEST_CASE("a sheet at rest on a plate that tips slides at the angle of friction", "[simulation]") {
    Ride ride;
    ride.box(2, 0.1f, 2);
    ride.drape(0.111f, 15, 1);
    for (int i = 0; i < 240; ++i) ride.move_to({{0, 0.002 * i / 60, 0}});
    double before = ride.middle(), began = 0;
    for (int i = 1; i < 900 && began == 0; ++i) {
        const double angle = 2 * i / 60.0 * pi / 180;  // 2 degrees a second
        ride.move_to({{0, 0, 0}, angle});
        if (std::fabs(ride.middle() - before) > 1e-3) began = angle * 180 / pi;
    }
    figure("angle at which a sheet slides", began, "degrees");
    // 26.565; a millimetre takes a fifth of a second.
    CHECK(began > 26.5);
    CHECK(began < 27.5);
}

TEST_CASE("what hangs from a box that rolls far swings on", "[simulation]") {
    Ride ride;
    ride.box(0.4f, 0.4f, 0.4f);
    ride.drape(0.42f, 20);
    const auto motion = [](double t) { return Motion{{0, 0, 0}, 0.3 * swing(t, 0.2)}; };
    ride.speed(motion, 0, 720);
    const double speed = ride.speed(motion, 720, 1020);
    figure("speed of a sheet on a box that rolls by 17 degrees", speed, "m/s");
    CHECK(speed > 0.03);  // its edges, half a metre below the upper side, move by 0.3 half a metre at 0.2 Hz
}

TEST_CASE("a sheet that settles on a model that moves continues with the same bits from a snapshot", "[simulation]") {
    Ride kept, restored;
    for (Ride* ride : {&kept, &restored}) {
        ride->box(0.6f, 0.02f, 0.4f);
        ride->drape(0.04f, 15, 1.6f);
    }
    for (int i = 0; i < 480; ++i) {
        const Motion motion{{0, 0.01 * swing(i * double{frame}, 0.25), 0}};
        REQUIRE(test::restore(restored.solver, test::snapshot(restored.solver)) == GPHYS_OK);
        kept.move_to(motion);
        restored.move_to(motion);
    }
    CHECK(test::hash(kept.solver) == test::hash(restored.solver));
}

TEST_CASE("a sheet on a model that moves falls when its scene is gone") {
    Ride ride;
    ride.box(0.6f, 0.02f, 0.4f);
    ride.drape(0.04f, 15, 1.6f);
    const auto motion = [](double t) { return Motion{{0, 0.01 * swing(t, 0.25), 0}}; };
    ride.speed(motion, 0, 480);
    const float before = ride.positions(ride.sheet)[112].y;
    for (int i = 0; i < 30; ++i) REQUIRE(gphys_solver_step(ride.solver, nullptr, frame) == GPHYS_OK);
    CHECK(before - ride.positions(ride.sheet)[112].y > 1);  // g t^2 / 2 in half a second
}
