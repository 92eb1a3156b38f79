// Friction by particle: Coulomb's law with the coefficient of each, in every kind of contact.
#include "snapshots.h"

using namespace test;
using gphys::Vec3;

namespace {

constexpr float frame = 1.0f / 60;
constexpr double g = static_cast<double>(9.81f);

/// A slope: unit vectors away from it, down it and along it. The plane has float components, which the tests are
/// compared with.
struct Slope {
    Vec3 normal, down;
    double sine, cosine;

    explicit Slope(double degrees) {
        const double angle = degrees * 3.14159265358979324 / 180;
        normal = gphys::widen(gphys::narrow(Vec3{std::sin(angle), std::cos(angle), 0}));
        normal = normal / length(normal);
        sine = normal.x, cosine = normal.y;
        down = {cosine, -sine, 0};
    }
    void add_to(World& world) const {
        const gphys_plane plane{gphys::narrow(normal), 0};
        world.model(GPHYS_SHAPE_PLANE, &plane);
    }
    gphys_vec3 place(double along, double across) const {
        return gphys::narrow(normal * 0.010002 + down * along + Vec3{0, 0, across});
    }
};

void set_factors(World& world, gphys_body_id body, uint32_t first, const std::vector<float>& factors) {
    REQUIRE(gphys_solver_set_friction_factors(world.solver, body, first, static_cast<uint32_t>(factors.size()),
                                              factors.data(), 4) == GPHYS_OK);
}
void set_all(World& world, gphys_body_id body, float factor) {
    const uint32_t count = static_cast<uint32_t>(world.positions(body).size());
    REQUIRE(gphys_solver_set_friction_factors(world.solver, body, 0, count, &factor, 0) == GPHYS_OK);
}

gphys_body_desc rubbing(float friction, float static_friction = 0) {
    gphys_body_desc desc = World::body_desc();
    desc.friction = friction;
    desc.static_friction = static_friction;
    return desc;
}

Vec3 velocity(const World& world, gphys_body_id body, uint32_t particle = 0) {
    return gphys::widen(world.velocities(body)[particle]);
}
Vec3 mean_velocity(const World& world, gphys_body_id body) {
    Vec3 sum;
    const std::vector<gphys_vec3> velocities = world.velocities(body);
    for (const gphys_vec3& v : velocities) sum += gphys::widen(v);
    return sum / static_cast<double>(velocities.size());
}

}  // namespace

TEST_CASE("On a slope of 20 degrees those with friction above its tangent stay, the others slide at g (sin - mu cos)") {
    const Slope slope(20);  // tan = 0.36397
    const std::vector<float> coefficients{0, 0.1f, 0.2f, 0.3f, 0.35f, 0.36f, 0.368f, 0.4f, 0.5f, 0.8f, 2};
    for (const float of_body : {1.0f, 0.5f}) {
        World world(8);
        slope.add_to(world);
        std::vector<gphys_vec3> places;
        std::vector<float> factors;
        for (size_t i = 0; i < coefficients.size(); ++i) {
            places.push_back(slope.place(0, 0.5 * static_cast<double>(i)));
            factors.push_back(coefficients[i] / of_body);
        }
        const gphys_body_id row = world.particles(places, rubbing(of_body));
        set_factors(world, row, 0, factors);
        for (int i = 0; i < 60; ++i) world.step(frame);
        double worst = 0, drift = 0;
        for (uint32_t p = 0; p < places.size(); ++p) {
            const double mu = static_cast<double>(of_body) * static_cast<double>(factors[p]);
            const double speed = g * (slope.sine - mu * slope.cosine);
            if (speed > 0) {
                worst = std::max(worst, std::fabs(dot(velocity(world, row, p), slope.down) / speed - 1));
            } else {
                drift = std::max(drift, distance(world.position(row, p), gphys::widen(places[p])));
            }
        }
        figure("error of speeds", worst, "");
        figure("drift of what stays", drift, "m");
        CHECK(worst < 1e-4);
        CHECK(drift < 1e-5);  // the skin that they fall through, and float32
    }
}

TEST_CASE("Factors that are all the same are a friction of the body, bit for bit") {
    // Ropes, cloth and particles, on models that stand and move, joined, and on one another.
    const auto make = [](World& world, bool by_factors) {
        // Whose products are floats.
        const float factor = 0.75f, scale = by_factors ? 1 : factor, friction = 0.8125f * scale, at_rest = scale;
        const gphys_plane floor{{0, 1, 0}, 0};
        const gphys_sphere ball{{0, 0, 0}, 0.4f};
        world.model(GPHYS_SHAPE_PLANE, &floor);
        world.model(GPHYS_SHAPE_SPHERE, &ball);
        gphys_body_desc desc = rubbing(friction, at_rest);
        desc.restitution = 0.3f;
        std::vector<gphys_body_id> bodies;
        bodies.push_back(world.rope(line({-0.5f, 0.5f, 0.02f}, {0.05f, 0, 0}, 21), 0, desc));
        bodies.push_back(world.cloth({-0.5f, 0.8f, -0.5f}, {1, 0, 0}, {0, 0, 1}, 9, 9, desc));
        bodies.push_back(world.particles(line({-1, 0.3f, 1}, {0.05f, 0.01f, 0}, 40), desc));
        bodies.push_back(world.rope(line({0.2f, 0.3f, 1.2f}, {0.05f, 0, 0}, 6), 0, desc));
        desc.self_collision = desc.body_layers = 1;
        bodies.push_back(world.particles(line({1.5f, 0.1f, 0}, {0.001f, 0.03f, 0.001f}, 12), desc));
        bodies.push_back(world.rope(line({1.45f, 0.6f, 0}, {0.025f, 0, 0}, 6), 0, desc));
        gphys_joint_id joint = 0;
        REQUIRE(gphys_solver_join(world.solver, bodies[2], 0, bodies[3], 0, -1, 0, &joint) == GPHYS_OK);
        for (const gphys_body_id body : bodies) {
            for (uint32_t p = 0; p < world.positions(body).size(); ++p) world.set_velocity(body, p, {0.7f, 0, 0.2f});
            if (by_factors) set_all(world, body, factor);
        }
        return bodies;
    };
    const bool moves = GENERATE(false, true);
    World by_factors(4), by_body(4);
    const std::vector<gphys_body_id> bodies = make(by_factors, true);
    make(by_body, false);
    const gphys_aabb box{{-0.2f, 0, -2}, {0.2f, 0.3f, 2}};
    const gphys_model_id pushers[] = {by_factors.model(GPHYS_SHAPE_AABB, &box), by_body.model(GPHYS_SHAPE_AABB, &box)};
    for (int i = 0; i < 90; ++i) {
        const gphys_transform place{{moves ? 3 - 0.03f * static_cast<float>(i) : 3, 0, 0}, {0, 0, 0, 1}, 1};
        REQUIRE(gphys_scene_set_transform(by_factors.scene, pushers[0], &place) == GPHYS_OK);
        REQUIRE(gphys_scene_set_transform(by_body.scene, pushers[1], &place) == GPHYS_OK);
        by_factors.step(frame);
        by_body.step(frame);
    }
    for (const gphys_body_id body : bodies) {
        const std::vector<gphys_vec3> a = by_factors.positions(body), b = by_body.positions(body);
        CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
    }
    CHECK(by_factors.stats().contact_count > 20);
}

TEST_CASE("A sheet of two halves slides by the mean of their coefficients, and is held by one of them") {
    // The lower half pulls the upper one, so the sheet stays taut.
    const Slope slope(20);
    for (const bool holds : {false, true}) {
        World world(8);
        slope.add_to(world);
        const uint32_t n = 10;
        const gphys_body_id sheet =
            world.cloth(slope.place(0, 0), gphys::narrow(slope.down), {0, 0, 1}, n, n, rubbing(1));
        const float upper = holds ? 1.2f : 0.3f, lower = holds ? 0.05f : 0.1f;
        std::vector<float> factors;
        for (uint32_t p = 0; p < n * n; ++p) factors.push_back(p % n < n / 2 ? upper : lower);
        set_factors(world, sheet, 0, factors);
        const Vec3 from = world.position(sheet);
        for (int i = 0; i < 60; ++i) world.step(frame);
        const double mean = (static_cast<double>(upper) + static_cast<double>(lower)) / 2;
        const double speed = g * (slope.sine - mean * slope.cosine);
        if (holds) {
            figure("drift of a sheet held by its sticky half", distance(world.position(sheet), from), "m");
            CHECK(distance(world.position(sheet), from) < 1e-3);
        } else {
            const double measured = dot(mean_velocity(world, sheet), slope.down);
            figure("speed of a sheet of two halves", measured / speed, "of the law");
            CHECK(std::fabs(measured / speed - 1) < 1e-2);
        }
    }
}

TEST_CASE("A rope with a slippery middle across a box is moved by what exceeds the friction of its ends") {
    const uint32_t n = 31;
    const double mu = 0.5, held_by = mu * g * 20 / n;  // of 1 kg, of which 20 particles rub
    for (const double pull : {0.9 * held_by, 1.5 * held_by}) {
        World world(8);
        const gphys_aabb box{{-10, -1, -1}, {10, 0, 1}};
        world.model(GPHYS_SHAPE_AABB, &box);
        const gphys_body_id rope =
            world.rope(line({-1.5f, 0.010001f, 0}, {0.1f, 0, 0}, n), 0, rubbing(static_cast<float>(mu)));
        set_factors(world, rope, 10, std::vector<float>(11, 0));
        const gphys_vec3 force{static_cast<float>(pull), 0, 0};
        REQUIRE(gphys_solver_set_forces(world.solver, rope, n - 1, 1, &force, 12) == GPHYS_OK);
        const Vec3 from = world.position(rope);
        for (int i = 0; i < 60; ++i) world.step(frame);
        const double speed = std::max(0.0, pull - held_by);  // of 1 kg in 1 s
        figure("speed of a rope that is pulled", mean_velocity(world, rope).x, "m/s");
        figure("by the law", speed, "m/s");
        if (speed == 0) CHECK(distance(world.position(rope), from) < 1e-5);
        CHECK(std::fabs(mean_velocity(world, rope).x - speed) < 1e-4 * std::max(speed, 1.0));
    }
}

TEST_CASE("Ice comes and goes while particles slide over it") {
    World world(8);
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const double mu = static_cast<double>(0.3f);
    const gphys_body_id pucks = world.particles(line({0, 0.010001f, 0}, {0, 0, 0.5f}, 3), rubbing(0.3f));
    for (uint32_t p = 0; p < 3; ++p) world.set_velocity(pucks, p, {3, 0, 0});
    const auto slide = [&](int frames) {
        for (int i = 0; i < frames; ++i) world.step(frame);
    };
    slide(12);
    set_factors(world, pucks, 1, {0, 2});  // the second is on ice, the third on sand
    slide(12);
    set_all(world, pucks, 1);
    slide(12);
    const double t = 0.2, rub[3] = {3 * t, 2 * t, 4 * t};
    for (uint32_t p = 0; p < 3; ++p) {
        const double expected = 3 - mu * g * rub[p];
        CHECK(velocity(world, pucks, p).x == Approx(expected).epsilon(1e-4));
    }
}

TEST_CASE("Of many that lie still side by side only those on ice begin to slide") {
    // On a horizontal floor, with a tilted gravity.
    const gphys_vec3 gravity{3, -9, 0};  // tan = 1/3
    World world(8, gravity);
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const gphys_body_id row = world.particles(line({0, 0.010001f, 0}, {0, 0, 0.1f}, 24), rubbing(0.5f));
    for (int i = 0; i < 10; ++i) world.step(frame);
    for (const gphys_vec3& v : world.velocities(row)) CHECK(gphys::widen(v) == Vec3{});
    set_factors(world, row, 9, {0, 0.25f});
    for (int i = 0; i < 60; ++i) world.step(frame);
    for (uint32_t p = 0; p < 24; ++p) {
        const double mu = p == 9 ? 0 : p == 10 ? 0.125 : 0.5, speed = std::max(0.0, 3 - 9 * mu);
        CHECK(std::fabs(velocity(world, row, p).x - speed) <= 1e-4 * speed);
    }
}

TEST_CASE("What sleeps on a slope wakes on ice, and slides") {
    const Slope slope(20);
    gphys_solver_desc desc = World::desc();
    desc.sleep_speed = 0.05f;
    desc.sleep_time = 0.25f;
    for (const gphys_body_kind kind : {GPHYS_BODY_PARTICLES, GPHYS_BODY_ROPE, GPHYS_BODY_CLOTH}) {
        World world(desc);
        slope.add_to(world);
        const std::vector<gphys_vec3> places{slope.place(0, 0), slope.place(0.3, 0), slope.place(0.6, 0)};
        const gphys_body_desc of_body = rubbing(0.6f, 0.8f);
        const gphys_body_id body = kind == GPHYS_BODY_PARTICLES ? world.particles(places, of_body)
                                   : kind == GPHYS_BODY_ROPE    ? world.rope(places, 0, of_body)
                                                             : world.cloth(slope.place(0, 0), gphys::narrow(slope.down),
                                                                           {0, 0, 1}, 7, 7, of_body);
        const auto sleepers = [&] {
            uint32_t total = 0;
            gphys_solver_get_sleeping(world.solver, nullptr, 0, &total);
            return total;
        };
        for (int i = 0; i < 60; ++i) world.step(frame);
        REQUIRE(sleepers() == 1);
        set_all(world, body, 0.25f);
        CHECK(sleepers() == 0);
        for (int i = 0; i < 60; ++i) world.step(frame);
        const double speed = g * (slope.sine - 0.15 * slope.cosine);
        std::printf("    kind %d: %.6g of %.6g m/s\n", kind, dot(mean_velocity(world, body), slope.down), speed);
        CHECK(std::fabs(dot(mean_velocity(world, body), slope.down) / speed - 1) < 0.02);
    }
}

TEST_CASE("Static friction has the factor too") {
    const Slope slope(20);
    for (const gphys_body_kind kind : {GPHYS_BODY_PARTICLES, GPHYS_BODY_ROPE, GPHYS_BODY_CLOTH}) {
        for (const float factor : {1.0f, 0.5f, 0.0f}) {  // static 0.6 holds, 0.3 and 0 do not
            World world(8);
            slope.add_to(world);
            const std::vector<gphys_vec3> places{slope.place(0, 0), slope.place(0.3, 0), slope.place(0.6, 0)};
            const gphys_body_desc of_body = rubbing(0.2f, 0.6f);
            const gphys_body_id body =
                kind == GPHYS_BODY_PARTICLES ? world.particles(places, of_body)
                : kind == GPHYS_BODY_ROPE
                    ? world.rope(places, 0, of_body)
                    : world.cloth(slope.place(0, 0), gphys::narrow(slope.down), {0, 0, 1}, 7, 7, of_body);
            set_all(world, body, factor);
            const Vec3 from = world.position(body);
            for (int i = 0; i < 60; ++i) world.step(frame);
            const double mu = 0.2 * static_cast<double>(factor), speed = g * (slope.sine - mu * slope.cosine);
            if (factor == 1) {
                CHECK(distance(world.position(body), from) < 1e-5);
            } else {
                CHECK(std::fabs(dot(mean_velocity(world, body), slope.down) / speed - 1) < 0.02);
            }
        }
    }
}

TEST_CASE("A pair of particles has the mean of their frictions, of two bodies or of one") {
    const bool one_body = GENERATE(false, true);
    World world(8);
    gphys_body_desc desc = rubbing(0.5f);
    desc.body_layers = 1;
    desc.self_collision = one_body ? 1 : 0;
    gphys_body_id slider = 0, hill = 0;
    uint32_t on_top = 0;
    if (one_body) {
        slider = hill = world.particles({{0, -100, 0}, {0, 0.02f, 0}}, desc);
        on_top = 1;
    } else {
        hill = world.particles({{0, -100, 0}}, desc);
        slider = world.particles({{0, 0.02f, 0}}, desc);
    }
    const float large = 100, small = 0.02f;
    REQUIRE(gphys_solver_set_radii(world.solver, hill, 0, 1, &large, 4) == GPHYS_OK);
    REQUIRE(gphys_solver_set_radii(world.solver, slider, on_top, 1, &small, 4) == GPHYS_OK);
    world.pin(hill, 0);
    set_factors(world, hill, 0, {0.2f});
    set_factors(world, slider, on_top, {1.8f});  // sqrt(0.1 * 0.9) = 0.3
    world.set_velocity(slider, on_top, {2, 0, 0});
    for (int i = 0; i < 18; ++i) world.step(frame);
    // It presses with its weight, less v^2 / 100 m of at most 4 m^2/s^2: 0.4 %.
    CHECK(velocity(world, slider, on_top).x == Approx(2 - 0.3 * g * 0.3).epsilon(0.01));
}

TEST_CASE("The friction of a body scales those of its particles, and other settings leave them") {
    const Slope slope(20);
    World world(8);
    slope.add_to(world);
    const gphys_body_id row = world.particles({slope.place(0, 0), slope.place(0, 1)}, rubbing(1));
    set_factors(world, row, 0, {0.25f, 0.5f});
    gphys_body_settings settings{};
    REQUIRE(gphys_solver_get_body_settings(world.solver, row, &settings) == GPHYS_OK);
    CHECK(settings.friction == 1);
    settings.restitution = 0.5f;
    settings.friction = settings.static_friction = 0.5f;
    REQUIRE(gphys_solver_set_body_settings(world.solver, row, &settings) == GPHYS_OK);
    float factors[2] = {};
    REQUIRE(gphys_solver_get_friction_factors(world.solver, row, 0, 2, factors, 4) == GPHYS_OK);
    CHECK((factors[0] == 0.25f && factors[1] == 0.5f));
    for (int i = 0; i < 60; ++i) world.step(frame);
    for (uint32_t p = 0; p < 2; ++p) {
        const double speed = g * (slope.sine - 0.125 * (p + 1) * slope.cosine);
        CHECK(dot(velocity(world, row, p), slope.down) == Approx(speed).epsilon(1e-4));
    }
}

TEST_CASE("Factors belong to the state: snapshots restore them, and without any it is what it was") {
    World world(4), other(4);
    const Slope slope(20);
    slope.add_to(world);
    slope.add_to(other);
    const gphys_body_id gone = world.particles({slope.place(5, 0)});
    const gphys_body_id cloth =
        world.cloth(slope.place(0, 0), gphys::narrow(slope.down), {0, 0, 1}, 6, 6, rubbing(0.5f, 0.6f));
    const gphys_body_id rope = world.rope({slope.place(0, 2), slope.place(0.3, 2), slope.place(0.6, 2)}, 0);
    const gphys_animation_target target{slope.place(0, 2), {0, 1, 0}, 0.5f, INFINITY};
    REQUIRE(gphys_solver_set_animation_targets(world.solver, rope, 0, 1, &target, 0) == GPHYS_OK);
    REQUIRE(gphys_solver_remove_body(world.solver, gone) == GPHYS_OK);
    world.step(frame);
    const uint64_t without = hash(world.solver);
    const Words earlier = snapshot(world.solver);
    set_factors(world, cloth, 7, {0.1f, 0.2f, 0});
    set_factors(world, rope, 2, {0.3f});
    CHECK(hash(world.solver) != without);
    const Words words = snapshot(world.solver);
    REQUIRE(restore(other.solver, words) == GPHYS_OK);
    CHECK(snapshot(other.solver) == words);
    float read[6] = {};
    REQUIRE(gphys_solver_get_friction_factors(other.solver, cloth, 6, 6, read, 4) == GPHYS_OK);
    CHECK((read[0] == 1 && read[1] == 0.1f && read[2] == 0.2f && read[3] == 0 && read[4] == 1));
    for (int i = 0; i < 30; ++i) {
        world.step(frame);
        other.step(frame);
        CHECK(hash(world.solver) == hash(other.solver));
    }
    // One that was taken without factors has none.
    REQUIRE(restore(world.solver, earlier) == GPHYS_OK);
    CHECK(hash(world.solver) == without);
    set_factors(world, rope, 1, {0.5f});
    set_factors(world, rope, 1, {1});
    CHECK(hash(world.solver) == without);
}

TEST_CASE("Made-up friction factors are refused") {
    World world(4);
    const gphys_body_id body = world.particles(line({0, 0, 0}, {1, 0, 0}, 3));
    set_factors(world, body, 0, {0.25f, 0.5f, 0.75f});
    const Words words = snapshot(world.solver);
    // The last words are the key, the number of factors, and three doubles.
    const size_t key = words.size() - 8;
    REQUIRE(words[key] == 1u << 24);
    REQUIRE(words[key + 1] == 3);
    World other(4);
    const uint64_t before = hash(other.solver);
    const auto refused = [&](size_t at, uint32_t word) {
        CHECK(restore(other.solver, forged(words, at, word)) == GPHYS_ERROR_INVALID_ARGUMENT);
        CHECK(hash(other.solver) == before);
    };
    refused(key, 0);                        // targets, of another size
    refused(key, 2u << 24);                 // an array that does not exist
    refused(key, 1u << 24 | 1);             // of a body that does not exist
    refused(key + 1, 2);                    // with words left over
    refused(key + 1, 4);                    // beyond the end
    refused(words.size() - 1, 0xbff00000);  // negative
    refused(words.size() - 1, 0x7ff00000);  // infinite
    refused(words.size() - 1, 0x7ff80000);  // no number
    Words twice = words;
    twice.insert(twice.end(), words.end() - 8, words.end());
    twice[2] += 8;
    mend(twice);
    CHECK(restore(other.solver, twice) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(restore(other.solver, words) == GPHYS_OK);
}

TEST_CASE("Friction by particle has the same bits for any number of workers", "[simulation]") {
    uint64_t first = 0;
    for (uint32_t workers = 1; workers <= 4; ++workers) {
        gphys_solver_desc desc = World::desc(4);
        desc.worker_count = workers;
        World world(desc);
        const Slope slope(20);
        slope.add_to(world);
        std::vector<gphys_vec3> places;
        std::vector<float> factors;
        for (uint32_t p = 0; p < 40000; ++p) {  // three parts
            places.push_back(slope.place(0.03 * (p % 200), 0.03 * (p / 200)));
            factors.push_back(0.02f * static_cast<float>(p / 64 % 100));
        }
        set_factors(world, world.particles(places, rubbing(0.5f, 0.6f)), 0, factors);
        const gphys_body_id sheet =
            world.cloth(slope.place(-2, 0), gphys::narrow(slope.down), {0, 0, 1}, 20, 20, rubbing(0.5f));
        set_factors(world, sheet, 50, std::vector<float>(200, 0.1f));
        for (int i = 0; i < 20; ++i) {
            set_factors(world, sheet, static_cast<uint32_t>(i), {0.2f});
            world.step(frame);
        }
        if (workers == 1) first = hash(world.solver);
        CHECK(hash(world.solver) == first);
    }
}
