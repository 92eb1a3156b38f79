// Cloth with default settings comes to rest on models, and where pins crowd it. Cloth that slides, falls over, swings
// or is moved does not.
#include <algorithm>
#include <cmath>

#include "snapshots.h"

using test::figure;
using test::World;

namespace {

constexpr float frame = 1.0f / 60;

struct Room : World {
    gphys_body_id sheet = 0;

    void run(int frames) {
        for (int i = 0; i < frames; ++i) step(frame);
    }
    gphys_model_id box() {
        const gphys_aabb cube{{-0.4f, -0.4f, -0.4f}, {0.4f, 0.4f, 0.4f}};
        return model(GPHYS_SHAPE_AABB, &cube);
    }
    void place(gphys_model_id model, gphys_vec3 at) {
        const gphys_transform place{at, {0, 0, 0, 1}, 1};
        REQUIRE(gphys_scene_set_transform(scene, model, &place) == GPHYS_OK);
    }
    /// A sheet of 2 m, this high above the middle.
    void drape(float height, uint32_t particles = 30) {
        sheet = cloth({-1, height, -1}, {2, 0, 0}, {0, 0, 2}, particles, particles, body_desc());
    }
    double fastest() const {
        double most = 0;
        for (const gphys_vec3& v : velocities(sheet)) most = std::max(most, double{std::hypot(v.x, v.y, v.z)});
        return most;
    }
    bool rests() const { return fastest() == 0; }
    /// The most that a particle is from where it was.
    double moved(const std::vector<gphys_vec3>& before) const {
        const std::vector<gphys_vec3> now = positions(sheet);
        double most = 0;
        for (size_t i = 0; i < now.size(); ++i)
            most = std::max(most,
                            double{std::hypot(now[i].x - before[i].x, now[i].y - before[i].y, now[i].z - before[i].z)});
        return most;
    }
    double mean_height() const {
        double sum = 0;
        const std::vector<gphys_vec3> all = positions(sheet);
        for (const gphys_vec3& at : all) sum += at.y;
        return sum / static_cast<double>(all.size());
    }
    /// The largest strain of the sides of a square grid of 2 m.
    double side_strain(uint32_t columns) const {
        const std::vector<gphys_vec3> at = positions(sheet);
        const double rest = 2.0 / (columns - 1);
        double most = 0;
        for (uint32_t p = 0; p < at.size(); ++p) {
            for (const uint32_t back : {1u, columns}) {
                if (p < back || (back == 1 && p % columns == 0)) continue;
                const gphys_vec3 &a = at[p - back], &b = at[p];
                most = std::max(most, std::fabs(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) / rest - 1));
            }
        }
        return most;
    }
};

}  // namespace

TEST_CASE("a default sheet on a box, a ball, a capsule or a bar comes to rest with its threads unstrained",
          "[simulation]") {
    const gphys_sphere ball{{0, 0, 0}, 0.5f};
    const gphys_capsule standing{{0, -0.8f, 0}, {0, 0.3f, 0}, 0.25f}, bar{{-2, 0.4f, 0}, {2, 0.4f, 0}, 0.05f};
    for (const int which : {0, 1, 2, 3}) {
        Room room;
        if (which == 0) room.box();
        if (which == 1) room.model(GPHYS_SHAPE_SPHERE, &ball);
        if (which == 2) room.model(GPHYS_SHAPE_CAPSULE, &standing);
        if (which == 3) room.model(GPHYS_SHAPE_CAPSULE, &bar);
        room.drape(0.6f, 40);
        int frames = 1;
        room.step(frame);
        for (; frames < 600 && !room.rests(); ++frames) room.step(frame);
        figure("seconds until a sheet rests", frames / 60.0, "s");
        CHECK(frames < 600);
        CHECK(room.side_strain(40) <= 0.03);  // half as much again as relaxation leaves
    }
}

TEST_CASE("a settled sheet presses what it lies on with its weight, and its moment", "[simulation]") {
    const gphys_sphere ball{{0, 0, 0}, 0.5f};
    for (const uint32_t substeps : {8u, 3u}) {
        for (const bool on_ball : {false, true}) {
            Room room;
            REQUIRE(gphys_solver_set_substeps(room.solver, substeps) == GPHYS_OK);
            if (on_ball) {
                room.model(GPHYS_SHAPE_SPHERE, &ball);
            } else {
                room.box();
            }
            room.drape(0.6f, 40);
            room.step(frame);
            for (int i = 0; i < 600 && !room.rests(); ++i) room.step(frame);
            REQUIRE(room.rests());
            room.step(frame);
            const std::vector<gphys_impulse> given = test::impulses(room);
            REQUIRE(given.size() == 1);
            gphys_vec3 middle{0, 0, 0};
            const std::vector<gphys_vec3> all = room.positions(room.sheet);
            for (const gphys_vec3& at : all) middle.x += at.x / 1600, middle.z += at.z / 1600;
            const double weight = 9.81 * double{frame};
            const gphys_vec3 force = given[0].linear, moment = given[0].angular;
            figure("force of a settled sheet, in parts of its weight", -double{force.y} / weight, "");
            // In floats, summed over 1600 particles and the substeps.
            CHECK(std::fabs(double{force.y} + weight) < 1e-4 * weight);
            CHECK(std::hypot(force.x, force.z) < 1e-4 * weight);
            CHECK(std::fabs(double{moment.x} - middle.z * weight) < 1e-3 * weight);
            CHECK(std::fabs(double{moment.z} + middle.x * weight) < 1e-3 * weight);
        }
    }
}

TEST_CASE("units do not matter for settling: a sheet in centimetres", "[simulation]") {
    Room room;
    gphys_solver_destroy(room.solver);
    gphys_solver_desc desc = World::desc(8, {0, -981, 0});
    REQUIRE(gphys_solver_create(&desc, &room.solver) == GPHYS_OK);
    const gphys_aabb cube{{-40, -40, -40}, {40, 40, 40}};
    room.model(GPHYS_SHAPE_AABB, &cube);
    gphys_body_desc body = World::body_desc();
    body.radius = 1;
    room.sheet = room.cloth({-100, 50, -100}, {200, 0, 0}, {0, 0, 200}, 30, 30, body);
    room.run(600);
    CHECK(room.rests());
}

TEST_CASE("a settled sheet falls when its support is gone, and follows it when it moves", "[simulation]") {
    Room room;
    const gphys_model_id box = room.box();
    room.drape(0.5f);
    room.run(500);
    REQUIRE(room.rests());
    const double height = room.mean_height();
    for (int i = 1; i <= 60; ++i) {
        room.place(box, {0, 0.1f * static_cast<float>(i) * frame, 0});
        room.step(frame);
    }
    CHECK(std::fabs(room.mean_height() - height - 0.1) < 0.03);  // it sags meanwhile
    CHECK_FALSE(room.rests());
    REQUIRE(gphys_scene_remove(room.scene, box) == GPHYS_OK);
    const double before = room.mean_height();
    room.run(30);
    // g t^2 / 2 and a start at 0.1 m/s
    CHECK(std::fabs(before - room.mean_height() - 9.81 / 8) < 0.12);
}

TEST_CASE("a model that passes a settled sheet does not stir it, and one that hits it does", "[simulation]") {
    Room room;
    room.box();
    const gphys_sphere ball{{0, 0, 0}, 0.1f};
    const gphys_transform far{{5, 0, 0}, {0, 0, 0, 1}, 1};
    const gphys_model_id passer = room.model(GPHYS_SHAPE_SPHERE, &ball, &far);
    room.drape(0.5f);
    room.run(500);
    REQUIRE(room.rests());
    const std::vector<gphys_vec3> before = room.positions(room.sheet);
    for (int i = 0; i <= 60; ++i) {
        room.place(passer, {-1.5f + 0.05f * static_cast<float>(i), 0, -1.4f});  // 0.3 m beside its edge
        room.step(frame);
    }
    CHECK(room.moved(before) < 1e-6);  // positions are rounded anew
    for (int i = 0; i <= 60; ++i) {
        room.place(passer, {-1.5f + 0.05f * static_cast<float>(i), 0.1f, -0.7f});
        room.step(frame);
    }
    CHECK(room.moved(before) > 0.05);
}

TEST_CASE("a sheet slides down a slope that is hardly too steep, as Coulomb's law says", "[simulation]") {
    for (const double degrees : {26.7, 28.0}) {  // friction of 0.5 holds up to 26.565
        Room room;
        const double angle = degrees * 3.14159265358979 / 180;
        const float s = static_cast<float>(std::sin(angle)), c = static_cast<float>(std::cos(angle));
        const gphys_plane slope{{-s, c, 0}, 0};
        room.model(GPHYS_SHAPE_PLANE, &slope);
        gphys_body_desc desc = World::body_desc();
        desc.friction = 0.5f;
        const float r = desc.radius;
        room.sheet = room.cloth({-s * r, c * r, -0.5f}, {c, s, 0}, {0, 0, 1}, 20, 20, desc);
        const std::vector<gphys_vec3> before = room.positions(room.sheet);
        room.run(240);
        const double expected = 9.81 / 2 * (std::sin(angle) - 0.5 * std::cos(angle)) * 16;
        const double way = room.moved(before);
        figure("way down the slope, in parts of the expected", way / expected, "");
        CHECK(way > 0.99 * expected);
        CHECK_FALSE(room.rests());
    }
}

TEST_CASE("a sheet that hangs from pins swings on, and one without friction does not settle") {
    Room hanging;
    hanging.sheet = hanging.cloth({-0.5f, 0, 0}, {1, 0, 0}, {0, -1, 0.02f}, 15, 15, World::body_desc());
    for (uint32_t p = 0; p < 15; ++p) hanging.pin(hanging.sheet, p);
    hanging.run(600);
    CHECK_FALSE(hanging.rests());
    CHECK(hanging.fastest() > 1e-3);

    Room ice;
    ice.box();
    gphys_body_desc desc = World::body_desc();
    desc.friction = 0;
    ice.sheet = ice.cloth({-1, 0.42f, -1}, {2, 0, 0}, {0, 0, 2}, 20, 20, desc);
    for (int i = 0; i < 120; ++i) {
        ice.step(frame);
        CHECK_FALSE(ice.rests());
    }
}

namespace {

/// A default curtain of 2 m whose pins are closer together than its links are long, by a tenth. It hangs in folds.
struct GatheredCurtain : Room {
    static constexpr uint32_t columns = 31, rows = 13;

    /// Pinned if there is no rail, at its place else.
    explicit GatheredCurtain(uint32_t substeps, const gphys_vec3* rail_at = nullptr, uint32_t every = 1) {
        REQUIRE(gphys_solver_set_substeps(solver, substeps) == GPHYS_OK);
        gphys_body_desc desc = body_desc();
        desc.damping = 1;
        sheet = cloth({-1, 0, 0}, {2, 0, 0}, {0, -0.8f, 0}, columns, rows, desc);
        std::vector<gphys_vec3> at = positions(sheet);
        for (uint32_t p = 0; p < at.size(); ++p) {
            at[p].z = 0.01f * std::sin(37.0f * at[p].x + 0.1f * static_cast<float>(p % 7));
            at[p].x *= 0.9f;
        }
        REQUIRE(gphys_solver_set_positions(solver, sheet, 0, static_cast<uint32_t>(at.size()), at.data(),
                                           sizeof(gphys_vec3)) == GPHYS_OK);
        if (rail_at) rail = Room::World::box({1, 0.01f, 0.01f}, *rail_at);
        for (uint32_t p = 0; p < columns; p += every) {
            if (rail_at) {
                REQUIRE(gphys_solver_attach(solver, scene, sheet, p, rail, nullptr) == GPHYS_OK);
            } else {
                pin(sheet, p);
            }
        }
    }
    gphys_model_id rail = 0;
    gphys_vec3 force() const {
        for (const gphys_impulse& given : test::impulses(*this)) {
            if (given.model == rail) return {given.linear.x / frame, given.linear.y / frame, given.linear.z / frame};
        }
        return {};
    }
    /// Velocities do not tell: they are 0 while relaxation moves particles, too.
    void come_to_rest() {
        int frames = 0;
        for (int still = 0; frames < 600 && still < 30; ++frames) {
            const std::vector<gphys_vec3> before = positions(sheet);
            step(frame);
            still = moved(before) == 0 ? still + 1 : 0;
        }
        figure("seconds until a gathered curtain rests", frames / 60.0, "s");
        REQUIRE(frames < 600);
    }
};

}  // namespace

TEST_CASE("a gathered curtain with default links comes to rest", "[simulation]") {
    for (const uint32_t substeps : {8u, 7u, 2u}) {
        GatheredCurtain room(substeps);
        room.come_to_rest();
        const std::vector<gphys_vec3> at_rest = room.positions(room.sheet);
        room.run(60);
        CHECK(room.moved(at_rest) == 0);
    }
}

TEST_CASE("a gathered curtain at rest moves again when something stirs it", "[simulation]") {
    GatheredCurtain room(8);
    room.come_to_rest();
    const std::vector<gphys_vec3> at_rest = room.positions(room.sheet);
    double least = 0.02;
    SECTION("a ball that passes through it") {
        const gphys_sphere ball{{0, 0, 0}, 0.2f};
        const gphys_transform away{{0, -0.5f, 1}, {0, 0, 0, 1}, 1};
        const gphys_model_id model = room.model(GPHYS_SHAPE_SPHERE, &ball, &away);
        for (int i = 1; i <= 60; ++i) {
            room.place(model, {0, -0.5f, 1 - static_cast<float>(i) / 30});
            room.step(frame);
        }
    }
    SECTION("a pin that is released") {
        REQUIRE(gphys_solver_set_pinned(room.solver, room.sheet, 0, 1, 0) == GPHYS_OK);
        room.run(30);
        least = 0.01;  // the corner hangs on a link of 67 mm that is gathered by a tenth
    }
    SECTION("a pin that is moved") {
        const gphys_vec3 to{at_rest[0].x + 0.05f, at_rest[0].y, at_rest[0].z + 0.1f};
        REQUIRE(gphys_solver_set_positions(room.solver, room.sheet, 0, 1, &to, sizeof to) == GPHYS_OK);
        room.run(30);
    }
    SECTION("wind") {
        const gphys_wind wind{{0, 0, 3}, 1.2f, 1.2f, 0};
        REQUIRE(gphys_solver_set_wind(room.solver, room.sheet, &wind) == GPHYS_OK);
        room.run(60);
    }
    SECTION("gravity that turns") {
        const gphys_vec3 aside{2, -9.5f, 1};
        REQUIRE(gphys_solver_set_gravity(room.solver, &aside) == GPHYS_OK);
        room.run(60);
    }
    CHECK(room.moved(at_rest) > least);
}

TEST_CASE("a gathered curtain that is attached to a model moves and rests as a pinned one, and goes with the model",
          "[simulation]") {
    const gphys_vec3 at{0, 0.1f, 0};
    GatheredCurtain attached(8, &at), pinned(8);
    for (int i = 0; i < 120; ++i) {
        if (i > 60) attached.place(attached.rail, at);  // where it is already
        attached.step(frame);
        pinned.step(frame);
    }
    // Pins are rounded to the floats of the cloth, and attached particles are not. Folds make millimetres of that.
    CHECK(attached.moved(pinned.positions(pinned.sheet)) < 0.01);
    attached.come_to_rest();
    const double height = attached.mean_height();
    for (int i = 1; i <= 30; ++i) {
        attached.place(attached.rail, {0, 0.1f + 0.01f * static_cast<float>(i), 0});
        attached.step(frame);
    }
    attached.run(30);
    CHECK(std::fabs(attached.mean_height() - height - 0.3) < 0.02);
}

TEST_CASE("a gathered curtain pulls its rail with its weight before it rests, and at rest", "[simulation]") {
    const gphys_vec3 at{0.3f, 0.1f, 0};
    for (const uint32_t every : {1u, 3u}) {
        for (const uint32_t substeps : {8u, 4u, 2u, 1u}) {
            GatheredCurtain room(substeps, &at, every);
            room.run(30);
            double mean = 0;
            for (int i = 0; i < 60; ++i) {
                room.step(frame);
                mean += double{room.force().y} / 60;
            }
            test::figure("force of a curtain, in parts of its weight", -mean / 9.81, "");
            // Its middle becomes slower or faster by less than 0.1 m/s meanwhile, or damping takes as much.
            CHECK(std::fabs(mean + 9.81) < 0.1);
            if (every > 1) continue;  // some of these move by micrometres for long
            room.come_to_rest();
            // In floats.
            CHECK(std::fabs(double{room.force().y} + 9.81) < 1e-6 * 9.81);
            CHECK(std::fabs(double{room.force().x}) < 1e-6 * 9.81);
            CHECK(std::fabs(double{room.force().z}) < 1e-6 * 9.81);
        }
    }
}

TEST_CASE("a sheet with small swings goes on swinging") {
    // By 2 mm at its end, so at most at 6 mm/s.
    Room room;
    room.sheet = room.cloth({-0.1f, 0, 0}, {0.2f, 0, 0}, {0, -1, 0}, 3, 11, World::body_desc());
    for (uint32_t p = 0; p < 3; ++p) room.pin(room.sheet, p);
    std::vector<gphys_vec3> at = room.positions(room.sheet);
    for (gphys_vec3& place : at) place.z = -0.002f * place.y;
    REQUIRE(gphys_solver_set_positions(room.solver, room.sheet, 0, static_cast<uint32_t>(at.size()), at.data(),
                                       sizeof(gphys_vec3)) == GPHYS_OK);
    const auto largest_swing = [&] {
        double largest = 0;
        for (int i = 0; i < 300; ++i) {
            room.step(frame);
            largest = std::max(largest, std::fabs(double{room.positions(room.sheet).back().z}));
        }
        return largest;
    };
    const double first = largest_swing();
    room.run(600);
    CHECK(largest_swing() > 0.6 * first);  // the time scheme loses 30 % in the 15 seconds between
}

TEST_CASE("a sheet that settles continues with the same bits from a snapshot", "[simulation]") {
    Room room;
    room.box();
    room.drape(0.5f, 20);
    room.step(frame);
    for (int restored = 0; restored < 400 && !room.rests(); ++restored) {
        const test::Words before = test::snapshot(room.solver);
        room.step(frame);
        const uint64_t expected = test::hash(room.solver);
        REQUIRE(test::restore(room.solver, before) == GPHYS_OK);
        room.step(frame);
        REQUIRE(test::hash(room.solver) == expected);
    }
    CHECK(room.rests());
}
