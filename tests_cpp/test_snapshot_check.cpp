// What a snapshot may hold, number by number: a state of which one number is at the end of its range is taken, one with
// a single number beyond it is refused. The states are made by a solver, and changed where it keeps them.
#include "solver/snapshot/snapshot_check.h"
#include "solver/state.h"

#include <functional>

#include "test.h"

using namespace gphys;

namespace {

constexpr double range = GPHYS_MAX_COORDINATE, tiny = 0x1p-1074;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
double beyond(double value) { return std::nextafter(value, infinity); }

gphys_body_desc body_desc() {
    gphys_body_desc desc;
    gphys_body_desc_init(&desc, sizeof desc);
    return desc;
}

/// A rope that collides with itself, and a sheet; the first particle of each is pinned.
struct Bodies {
    Solver solver{nullptr, {}};
    gphys_body_id rope_id = 0, sheet_id = 0;

    Bodies() {
        const gphys_vec3 points[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
        gphys_body_desc desc = body_desc();
        desc.self_collision = 1;
        REQUIRE(solver.add_rope(desc, points, sizeof *points, 4, 0, rope_id) == GPHYS_OK);
        REQUIRE(solver.add_cloth(body_desc(), {0, 9, 0}, {1, 0, 0}, {0, 0, 1}, 3, 3, sheet_id) == GPHYS_OK);
        set_pinned(rope(), 0, 1, true);
        set_pinned(sheet(), 0, 1, true);
        solver.step(nullptr, 0.01);
    }
    Body& rope() { return solver.body(rope_id); }
    Body& sheet() { return solver.body(sheet_id); }
};

using Change = std::function<void(Body&)>;
using Check = const char*(const Body&);

/// Whether the check takes a body that was changed so. The body is put back afterwards.
bool takes(Body& body, const Change& change, Check& check = defect) {
    const Body before = body;
    change(body);
    const bool taken = check(body) == nullptr;
    body = before;
    return taken;
}

/// A number of a body, values that it may have, and values that it may not have. No number may be NaN.
void check_number(Body& body, const std::function<double&(Body&)>& number, const std::vector<double>& taken,
                  std::vector<double> refused) {
    refused.push_back(not_a_number);
    for (const double value : taken) {
        INFO("taken: " << value);
        CHECK(takes(body, [&](Body& b) { number(b) = value; }));
    }
    for (const double value : refused) {
        INFO("refused: " << value);
        CHECK_FALSE(takes(body, [&](Body& b) { number(b) = value; }));
    }
}

/// Likewise each coordinate of a vector, of which no magnitude is beyond the limit.
void check_vector(Body& body, const std::function<Vec3&(Body&)>& vector, double limit) {
    for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        check_number(body, [&](Body& b) -> double& { return vector(b).*axis; }, {limit, -limit},
                     {beyond(limit), -beyond(limit)});
    }
}

/// The five numbers of an IdTable, which it shows to archives alone.
struct TableNumbers {
    explicit TableNumbers(IdTable& table) { IdTable::visit(*this, table); }
    void array(LargeArray<uint32_t>& values) { entries = &values; }
    void value(uint32_t& number) { numbers.push_back(&number); }

    LargeArray<uint32_t>* entries = nullptr;
    std::vector<uint32_t*> numbers;  // live, free, oldest, newest
};

/// `taken` says whether a state is taken whose table, with ids in use and one that was removed, was changed so.
void check_table(const std::function<bool(const std::function<void(IdTable&)>&)>& taken) {
    CHECK(taken([](IdTable&) {}));
    for (size_t i = 0; i < 4; ++i) {
        CHECK_FALSE(taken([&](IdTable& ids) { *TableNumbers(ids).numbers[i] = 100; }));
    }
    CHECK_FALSE(taken([](IdTable& ids) { *TableNumbers(ids).entries->begin() = 0; }));
}

}  // namespace

TEST_CASE("a snapshot's settings are in their ranges, each by itself") {
    const auto taken = [](const std::function<void(SolverState&)>& change) {
        Memory memory(nullptr);
        SolverState state(&memory);
        change(state);
        return defect_of_globals(state) == nullptr;
    };
    CHECK(taken([](SolverState&) {}));
    const auto check = [&](const std::function<double&(SolverState&)>& number, const std::vector<double>& good,
                           std::vector<double> bad) {
        bad.push_back(not_a_number);
        for (const double value : good) CHECK(taken([&](SolverState& state) { number(state) = value; }));
        for (const double value : bad) CHECK_FALSE(taken([&](SolverState& state) { number(state) = value; }));
    };
    for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        const std::vector<double> good{range, -range}, bad{beyond(range), -beyond(range)};
        check([&](SolverState& s) -> double& { return s.settings.gravity.*axis; }, good, bad);
        check([&](SolverState& s) -> double& { return s.origin.*axis; }, good, bad);
    }
    using Settings = SolverSettings;
    for (double Settings::*const amount : {&Settings::sleep_speed, &Settings::sleep_strain, &Settings::sleep_time,
                                           &Settings::max_strain, &Settings::tolerance}) {
        check([&](SolverState& s) -> double& { return s.settings.*amount; }, {0, range}, {-tiny, beyond(range)});
    }
    check([](SolverState& s) -> double& { return s.settings.fixed_step; }, {1e-6f, 0.5},
          {std::nextafter(double{1e-6f}, 0), beyond(0.5), -0.01});
    check([](SolverState& s) -> double& { return s.accumulator; }, {0, 1.0 / 60}, {-tiny, beyond(1.0 / 60)});
    for (uint32_t Settings::*const count : {&Settings::substeps, &Settings::max_substeps}) {
        for (const uint32_t good : {1u, 1000u}) CHECK(taken([&](SolverState& s) { s.settings.*count = good; }));
        for (const uint32_t bad : {0u, 1001u}) CHECK_FALSE(taken([&](SolverState& s) { s.settings.*count = bad; }));
    }
    CHECK(taken([](SolverState& s) { s.settings.max_steps = 1; }));
    CHECK_FALSE(taken([](SolverState& s) { s.settings.max_steps = 0; }));
    check_table([&](const std::function<void(IdTable&)>& change) {
        return taken([&](SolverState& s) {
            s.ids.reserve(2);
            s.ids.remove(s.ids.add());
            s.ids.add();
            change(s.ids);
        });
    });
}

TEST_CASE("a snapshot's models are in order, each in a place") {
    const auto taken = [](const std::vector<PlacedModel>& models) {
        Memory memory(nullptr);
        SolverState state(&memory);
        state.near_models.assign(models.begin(), models.end());
        return defect_of_globals(state) == nullptr;
    };
    const auto placed = [](gphys_model_id model, gphys_transform at = {{0, 0, 0}, {0, 0, 0, 1}, 1},
                           gphys_vec3 velocity = {0, 0, 0}) {
        return PlacedModel{model, at, velocity};
    };
    CHECK(taken({placed(1), placed(2), placed(9)}));
    CHECK_FALSE(taken({placed(1), placed(1)}));
    CHECK_FALSE(taken({placed(2), placed(1)}));
    const float far = 4 * GPHYS_MAX_COORDINATE, further = std::nextafter(far, HUGE_VALF);
    CHECK(taken({placed(1, {{far, -far, far}, {0, 0, 0, 1}, 1}, {1e20f, 0, 0})}));
    CHECK_FALSE(taken({placed(1, {{further, 0, 0}, {0, 0, 0, 1}, 1})}));
    CHECK_FALSE(taken({placed(1, {{0, 0, 0}, {0, 0, 0, 0.9f}, 1})}));
    CHECK_FALSE(taken({placed(1, {{0, 0, 0}, {0, 0, 0, 1}, 0})}));
    CHECK_FALSE(taken({placed(1, {{0, 0, 0}, {0, 0, 0, 1}, 1}, {HUGE_VALF, 0, 0})}));
}

TEST_CASE("a snapshot's arrays of a body have the lengths that belong together") {
    Bodies bodies;
    Body &rope = bodies.rope(), &sheet = bodies.sheet();
    REQUIRE(takes(rope, [](Body&) {}));
    REQUIRE(takes(sheet, [](Body&) {}));
    const Change longer[] = {
        [](Body& b) { b.particles.velocity.emplace_back(); },
        [](Body& b) { b.particles.force.emplace_back(); },
        [](Body& b) { b.particles.mass.push_back(1); },
        [](Body& b) { b.particles.inverse_mass.push_back(1); },
        [](Body& b) { b.particles.radius.push_back(0); },
        [](Body& b) { b.constraints.by_slot.push_back({}); },
        [](Body& b) { b.cloth.sheet.rest_position.resize(10); },
        [](Body& b) { b.contacts.self.placed.resize(10); },
        [](Body& b) { b.history.start.resize(10); },
        [](Body& b) { b.history.start_velocity.resize(10); },
        [](Body& b) { b.contacts.points.resize(10); },
        [](Body& b) { b.contacts.stuck.resize(10); },
        [](Body& b) { b.cloth.cache.search_balls.resize(10); },
        [](Body& b) { b.cloth.sheet.triangles.push_back(0); },
        [](Body& b) { b.settings.self_collision = 2; },
        [](Body& b) { b.settings.self_collision ^= 1; },
    };
    for (const Change& change : longer) {
        INFO(&change - longer);
        CHECK_FALSE(takes(rope, change));
        CHECK_FALSE(takes(sheet, change));
    }
    // A body has particles, and some arrays may be missing.
    Memory memory(nullptr);
    CHECK(defect(Body(&memory)) != nullptr);
    CHECK(takes(sheet, [](Body& b) { b.cloth.sheet.rest_position.clear(); }));
    CHECK(takes(rope, [](Body& b) { b.history.start.clear(), b.history.start_velocity.clear(); }));
    CHECK(takes(
        sheet, [](Body& b) { b.contacts.points.resize(9 * contact_points_per_particle), b.contacts.stuck.resize(9); }));
}

TEST_CASE("a snapshot's numbers of a body are in their ranges, each by itself") {
    Bodies bodies;
    Body &rope = bodies.rope(), &sheet = bodies.sheet();
    for (const gphys_body_kind kind : {GPHYS_BODY_PARTICLES - 1, GPHYS_BODY_CLOTH + 1}) {
        CHECK_FALSE(takes(rope, [&](Body& b) { b.kind = kind; }));
    }
    const std::vector<double> amounts{0, range}, no_amounts{-tiny, beyond(range)};
    for (double BodySettings::*const amount :
         {&BodySettings::damping, &BodySettings::friction, &BodySettings::static_friction}) {
        check_number(
            rope, [&](Body& b) -> double& { return b.settings.*amount; }, amounts, no_amounts);
    }
    check_number(rope, [](Body& b) -> double& { return b.settings.restitution; }, {0, 1}, {-tiny, beyond(1)});
    check_number(rope, [](Body& b) -> double& { return b.substeps.wanted; }, {0, 0.5}, {-tiny, beyond(0.5)});
    check_number(rope, [](Body& b) -> double& { return b.history.earlier_step; }, {0, 0.5}, {-tiny, beyond(0.5)});
    check_number(
        rope, [](Body& b) -> double& { return b.sleep.rest_time; }, amounts, no_amounts);
    check_number(
        rope, [](Body& b) -> double& { return b.particles.radius.back(); }, amounts, no_amounts);
    check_number(sheet, [](Body& b) -> double& { return b.cloth.balance.lost; }, {0, 1e300}, {-tiny, infinity});
    check_number(sheet, [](Body& b) -> double& { return b.cloth.volume.rest; }, {0, 1e300}, {-tiny, infinity});
    check_number(
        sheet, [](Body& b) -> double& { return b.cloth.volume.compliance; }, amounts, no_amounts);
    check_number(sheet, [](Body& b) -> double& { return b.cloth.volume.pressure; }, {-1e300, 1e300},
                 {infinity, -infinity});

    // On its way a place may be rounded beyond the range; relative to a former origin it was up to four times as far.
    constexpr double place = range * (1 + 0x1p-40), earlier = 4 * range, speed = 1e30;
    check_vector(
        rope, [](Body& b) -> Vec3& { return b.particles.position.back(); }, place);
    check_vector(
        rope, [](Body& b) -> Vec3& { return b.particles.velocity.back(); }, speed);
    check_vector(
        rope, [](Body& b) -> Vec3& { return b.particles.force.back(); }, range);
    check_vector(
        rope, [](Body& b) -> Vec3& { return b.contacts.self.placed.back(); }, place);
    check_vector(
        rope, [](Body& b) -> Vec3& { return b.history.start.resize(4), b.history.start.back(); }, earlier);
    check_vector(
        rope, [](Body& b) -> Vec3& { return b.history.start_velocity.resize(4), b.history.start_velocity.back(); },
        speed);
    check_vector(
        sheet, [](Body& b) -> Vec3& { return b.cloth.sheet.rest_position.back(); }, place);
    check_vector(
        sheet, [](Body& b) -> Vec3& { return b.cloth.state.origin; }, place);

    CHECK(takes(sheet, [](Body& b) { b.contacts.stuck.assign(9, 1); }));
    CHECK_FALSE(takes(sheet, [](Body& b) { b.contacts.stuck.assign(9, 1), b.contacts.stuck.back() = 2; }));
    for (Vector<float> ClothState::*const floats : {&ClothState::moved, &ClothState::velocity_before}) {
        CHECK(takes(sheet, [&](Body& b) { (b.cloth.state.*floats).assign(1, 1e30f); }));
        CHECK_FALSE(takes(sheet, [&](Body& b) { (b.cloth.state.*floats).assign(1, HUGE_VALF); }));
    }
    const uint32_t corners = static_cast<uint32_t>(sheet.cloth.sheet.triangles.size());
    REQUIRE(corners > 0);
    CHECK_FALSE(takes(sheet, [](Body& b) { b.cloth.sheet.triangles.back() = 9; }));
}

TEST_CASE("a snapshot's masses are positive, of pinned particles too, and fit their inverses") {
    Bodies bodies;
    Body& rope = bodies.rope();
    for (const uint32_t particle : {0u, 3u}) {  // one of them pinned
        const auto with_mass = [&](double mass) {
            return takes(rope, [&](Body& b) {
                b.particles.mass[particle] = mass;
                if (!b.particles.pinned(particle)) b.particles.inverse_mass[particle] = 1 / mass;
            });
        };
        const double least_mass = 0x1p-173;  // the least float, shared among 2^24
        CHECK(with_mass(least_mass));
        CHECK(with_mass(range));
        for (const double mass : {0.0, std::nextafter(least_mass, 0), -1.0, beyond(range), infinity, not_a_number}) {
            CHECK_FALSE(with_mass(mass));
        }
    }
    for (const double inverse : {beyond(1 / rope.particles.mass[3]), -1.0, not_a_number}) {
        CHECK_FALSE(takes(rope, [&](Body& b) { b.particles.inverse_mass[3] = inverse; }));
    }
}

TEST_CASE("a snapshot's touches, boxes and looks around are of numbers") {
    Bodies bodies;
    Body& sheet = bodies.sheet();
    const auto with_touch = [&](const gphys_vec3& point, const gphys_vec3& normal) {
        return takes(sheet, [&](Body& b) {
            b.contacts.points.resize(9 * contact_points_per_particle);
            b.contacts.points.back() = {1, 0, point, normal};
        });
    };
    CHECK(with_touch({1e30f, -1e30f, 0}, {0, -1, 0}));
    CHECK_FALSE(with_touch({0, 0, 0}, {0, 1.0001f, 0}));
    for (float gphys_vec3::*const axis : {&gphys_vec3::x, &gphys_vec3::y, &gphys_vec3::z}) {
        gphys_vec3 point{0, 0, 0};
        point.*axis = HUGE_VALF;
        CHECK_FALSE(with_touch(point, {0, 1, 0}));
    }
    for (int i = 0; i < 3; ++i) {
        CHECK_FALSE(takes(sheet, [&](Body& b) { b.sleep.box.min[i] = -HUGE_VALF; }));
        CHECK_FALSE(takes(sheet, [&](Body& b) { b.sleep.box.max[i] = HUGE_VALF; }));
    }
    const auto with_search = [&](size_t number, float value) {
        return takes(sheet, [&](Body& b) {
            b.cloth.cache.search_balls.assign(size_t{4} * 9, 1);
            b.cloth.cache.search_balls[size_t{4} * 8 + number] = value;
        });
    };
    const float far = 4 * GPHYS_MAX_COORDINATE, further = std::nextafter(far, HUGE_VALF);
    for (size_t axis = 0; axis < 3; ++axis) {
        CHECK(with_search(axis, -far));
        CHECK_FALSE(with_search(axis, -further));
    }
    for (const float reach : {0.0f, far, ContactCache::no_ball}) CHECK(with_search(3, reach));
    for (const float reach : {-0.5f, further, HUGE_VALF}) CHECK_FALSE(with_search(3, reach));
}

TEST_CASE("a snapshot's impulses are of numbers, and by model") {
    Bodies bodies;
    Body& rope = bodies.rope();
    const auto with_impulses = [&](const std::vector<ModelImpulse>& impulses) {
        return takes(rope, [&](Body& b) { b.contacts.impulses.assign(impulses.begin(), impulses.end()); });
    };
    CHECK(with_impulses({{1, 0, {1e300, 0, 0}, {}}, {2, 0, {}, {}}}));
    CHECK_FALSE(with_impulses({{2, 0, {}, {}}, {1, 0, {}, {}}}));
    CHECK_FALSE(with_impulses({{1, 0, {}, {}}, {1, 0, {}, {}}}));
    for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        Vec3 wrong;
        wrong.*axis = infinity;
        CHECK_FALSE(with_impulses({{1, 0, wrong, {}}}));
        CHECK_FALSE(with_impulses({{1, 0, {}, wrong}}));
    }
}

TEST_CASE("a snapshot's attachments are of pinned particles, in order, in a place") {
    Bodies bodies;
    Body& rope = bodies.rope();
    set_pinned(rope, 0, 2, true);
    const auto with = [&](const std::vector<Attachment>& attachments) {
        return takes(rope, [&](Body& b) { b.constraints.attachments.assign(attachments.begin(), attachments.end()); });
    };
    const Vec3 far{4 * range, 0, 0}, further{0, 0, beyond(4 * range)};
    CHECK(with({{0, 1, {1e32, 0, 0}, far, far}, {1, 1, {}, {}, {}}}));
    CHECK_FALSE(with({{1, 1, {}, {}, {}}, {0, 1, {}, {}, {}}}));
    CHECK_FALSE(with({{1, 1, {}, {}, {}}, {1, 1, {}, {}, {}}}));
    CHECK_FALSE(with({{2, 1, {}, {}, {}}}));  // free
    CHECK_FALSE(with({{4, 1, {}, {}, {}}}));  // not there
    CHECK_FALSE(with({{0, 1, {0, beyond(1e32), 0}, {}, {}}}));
    CHECK_FALSE(with({{0, 1, {}, further, {}}}));
    CHECK_FALSE(with({{0, 1, {}, {}, further}}));
}

TEST_CASE("a snapshot's constraints join two particles each, by amounts") {
    Bodies bodies;
    Body& rope = bodies.rope();
    const auto number = [&](double DistanceConstraint::*field, const std::vector<double>& taken,
                            const std::vector<double>& refused) {
        check_number(
            rope, [&](Body& b) -> double& { return b.constraints.by_slot.back().*field; }, taken, refused);
    };
    number(&DistanceConstraint::rest, {0, 4 * range}, {-tiny, beyond(4 * range)});
    number(&DistanceConstraint::compliance, {0, range}, {-tiny, beyond(range)});
    number(&DistanceConstraint::damping, {0, range}, {-tiny, beyond(range)});
    CHECK(takes(rope, [](Body& b) { b.constraints.by_slot.back().limit = 1; }));
    CHECK_FALSE(takes(rope, [](Body& b) { b.constraints.by_slot.back().limit = 2; }));
    CHECK_FALSE(takes(rope, [](Body& b) { b.constraints.by_slot.back().a = 4; }));
    CHECK_FALSE(takes(rope, [](Body& b) { b.constraints.by_slot.back().b = 4; }));
    CHECK_FALSE(takes(rope, [](Body& b) { b.constraints.by_slot.back().a = b.constraints.by_slot.back().b; }));
    // What was removed may hold anything.
    gphys_constraint_id id = rope.constraints.ids.id(2);
    REQUIRE(remove_constraint(rope, id) == GPHYS_OK);
    CHECK(takes(rope, [](Body& b) { b.constraints.by_slot[2].a = 9; }));
    check_table([&](const std::function<void(IdTable&)>& change) {
        return takes(rope, [&](Body& b) { change(b.constraints.ids); });
    });
}

TEST_CASE("a snapshot's joints join particles of two bodies that are there") {
    Bodies bodies;
    const auto taken = [&](const std::function<void(SolverState&)>& change) {
        Memory memory(nullptr);
        SolverState state(&memory);
        state.ids.reserve(3);
        state.joint_ids.reserve(1);
        for (int i = 0; i < 3; ++i) state.ids.add();
        state.joint_ids.add();
        state.bodies.add_slots(3);
        for (uint32_t slot = 0; slot < 3; ++slot) {
            state.bodies.put(slot, new_body(&memory));
            state.bodies[slot] = bodies.rope();
        }
        state.ids.remove(state.ids.id(2));
        state.joints.push_back({0, 3, 1, 0, 1, 0, {}});
        change(state);
        return defect_of_joints(state) == nullptr;
    };
    CHECK(taken([](SolverState&) {}));
    CHECK_FALSE(taken([](SolverState& s) { s.joints[0].particle_a = 4; }));
    CHECK_FALSE(taken([](SolverState& s) { s.joints[0].particle_b = 4; }));
    CHECK_FALSE(taken([](SolverState& s) { s.joints[0].body_a = 3; }));
    CHECK_FALSE(taken([](SolverState& s) { s.joints[0].body_b = 3; }));
    CHECK_FALSE(taken([](SolverState& s) { s.joints[0].body_a = 2; }));  // removed
    CHECK_FALSE(taken([](SolverState& s) { s.joints[0].body_b = 0; }));  // the same
    CHECK_FALSE(taken([](SolverState& s) { s.joints.push_back({}); }));
    for (const double rest : {0.0, 4 * range}) CHECK(taken([&](SolverState& s) { s.joints[0].rest = rest; }));
    for (const double rest : {-tiny, beyond(4 * range), not_a_number}) {
        CHECK_FALSE(taken([&](SolverState& s) { s.joints[0].rest = rest; }));
    }
    for (const double compliance : {-tiny, beyond(range), not_a_number}) {
        CHECK_FALSE(taken([&](SolverState& s) { s.joints[0].compliance = compliance; }));
    }
    for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        CHECK_FALSE(taken([&](SolverState& s) { s.joints[0].tension.*axis = infinity; }));
    }
    check_table([&](const std::function<void(IdTable&)>& change) {
        return taken([&](SolverState& s) {
            s.joint_ids.reserve(1);
            s.joint_ids.remove(s.joint_ids.add());
            s.joints.push_back({});
            change(s.joint_ids);
        });
    });
}

TEST_CASE("a snapshot's plan of a rope is the one that its constraints ask for") {
    Bodies bodies;
    Body& rope = bodies.rope();
    const auto taken = [&](const Change& change) { return takes(rope, change, defect_of_plan); };
    REQUIRE(rope.plan.chains_current);
    REQUIRE(rope.plan.method == GPHYS_SOLVE_DIRECT);
    CHECK(taken([](Body&) {}));
    CHECK_FALSE(taken([](Body& b) { b.plan.method = GPHYS_SOLVE_GRAPH; }));
    CHECK_FALSE(taken([](Body& b) { b.plan.method = GPHYS_SOLVE_FREE; }));
    CHECK_FALSE(taken([](Body& b) { b.rope.tension.push_back(0); }));
    CHECK_FALSE(taken([](Body& b) { b.rope.tension.back() = infinity; }));
    // One that is out of date says nothing.
    CHECK(taken([](Body& b) { b.plan.chains_current = false, b.plan.method = GPHYS_SOLVE_FREE; }));
}

/// The same plan, but for the chains of one family, which come in reverse.
void reverse_family(Plan& plan, size_t family) {
    const Plan before = plan;
    std::reverse(plan.chains.begin() + plan.colours[family], plan.chains.begin() + plan.colours[family + 1]);
    plan.particles.clear();
    plan.slots.clear();
    for (Chain& chain : plan.chains) {
        const auto particle = before.particles.begin() + chain.first_particle;
        const auto slot = before.slots.begin() + chain.first_link;
        chain.first_particle = static_cast<uint32_t>(plan.particles.size());
        chain.first_link = static_cast<uint32_t>(plan.slots.size());
        plan.particles.insert(plan.particles.end(), particle, particle + chain.link_count + 1);
        plan.slots.insert(plan.slots.end(), slot, slot + chain.link_count);
    }
}

TEST_CASE("in a snapshot's plan of cloth the longest chain of a family comes first, others in any order") {
    Bodies bodies;
    Body& sheet = bodies.sheet();
    const Plan& plan = sheet.plan;
    size_t alike = 0, unlike = 0;
    for (size_t family = 0; family + 1 < plan.colours.size(); ++family) {
        const uint32_t longest = plan.chains[plan.colours[family]].link_count;
        const uint32_t shortest = plan.chains[plan.colours[family + 1] - 1].link_count;
        INFO(longest << " to " << shortest << " links");
        const bool taken = takes(
            sheet, [&](Body& b) { reverse_family(b.plan, family); }, defect_of_plan);
        CHECK(taken == (longest == shortest));
        ++(longest == shortest ? alike : unlike);
    }
    CHECK(alike > 0);
    CHECK(unlike > 0);
}

TEST_CASE("a snapshot's plan of cloth has each constraint once, and solves side by side what shares no particle") {
    Bodies bodies;
    Body& sheet = bodies.sheet();
    const auto taken = [&](const Change& change) { return takes(sheet, change, defect_of_plan); };
    const Plan& plan = sheet.plan;
    REQUIRE(plan.method == GPHYS_SOLVE_GRAPH);
    REQUIRE(plan.chains.size() > 2);
    REQUIRE(plan.colours.size() > 2);
    REQUIRE(plan.reach_current);
    REQUIRE_FALSE(sheet.cloth.reach.limits.empty());
    CHECK(taken([](Body&) {}));
    CHECK_FALSE(taken([](Body& b) { b.plan.particles.back() = 9; }));

    // Chains lie one behind the other.
    CHECK_FALSE(taken([](Body& b) { ++b.plan.chains[1].first_particle; }));
    CHECK_FALSE(taken([](Body& b) { ++b.plan.chains[1].first_link; }));
    CHECK_FALSE(taken([](Body& b) { b.plan.chains.back().link_count = 0; }));
    CHECK_FALSE(taken([](Body& b) { ++b.plan.chains.back().link_count; }));
    CHECK_FALSE(taken([](Body& b) { b.plan.particles.push_back(0); }));
    CHECK_FALSE(taken([](Body& b) { b.plan.slots.push_back(0); }));
    CHECK_FALSE(taken([](Body& b) { b.plan.chains.pop_back(), --b.plan.colours.back(); }));

    // Families follow each other from the first chain to the last; a longer chain comes first.
    CHECK_FALSE(taken([](Body& b) { b.plan.colours.clear(); }));
    CHECK_FALSE(taken([](Body& b) { b.plan.colours.front() = 1; }));
    CHECK_FALSE(taken([](Body& b) { --b.plan.colours.back(); }));
    CHECK_FALSE(taken([](Body& b) { std::swap(b.plan.colours[0], b.plan.colours[1]); }));
    CHECK_FALSE(taken([](Body& b) { b.plan.colours[1] = b.plan.colours.back() + 1; }));
    CHECK_FALSE(taken([](Body& b) { b.plan.colours.erase(b.plan.colours.begin() + 1); }));  // a common particle

    // Each link is the constraint between its particles.
    CHECK_FALSE(taken([](Body& b) { b.plan.slots[0] = b.plan.slots[1]; }));
    CHECK_FALSE(taken([](Body& b) { std::swap(b.plan.slots.front(), b.plan.slots.back()); }));
    CHECK_FALSE(taken([](Body& b) { b.plan.slots[0] = b.constraints.ids.slots(); }));
    CHECK_FALSE(taken([](Body& b) { std::swap(b.plan.particles.front(), b.plan.particles.back()); }));
    CHECK_FALSE(taken([](Body& b) { b.constraints.ids.remove(b.constraints.ids.id(b.plan.slots[0])); }));
    for (const bool first : {true, false}) {
        // One end alone is not enough, whichever way round.
        const uint32_t from = plan.particles[0], to = plan.particles[1], shared = first ? from : to;
        const uint32_t elsewhere = 8 - from - to;
        REQUIRE((elsewhere < 9 && elsewhere != from && elsewhere != to));
        CHECK_FALSE(taken([&](Body& b) {
            b.constraints.by_slot[b.plan.slots[0]].a = shared, b.constraints.by_slot[b.plan.slots[0]].b = elsewhere;
        }));
        CHECK_FALSE(taken([&](Body& b) {
            b.constraints.by_slot[b.plan.slots[0]].b = shared, b.constraints.by_slot[b.plan.slots[0]].a = elsewhere;
        }));
    }
    // Which of its ends comes first does not matter, but all of a family push, or none does.
    CHECK(taken([](Body& b) {
        std::swap(b.constraints.by_slot[b.plan.slots[0]].a, b.constraints.by_slot[b.plan.slots[0]].b);
    }));
    CHECK_FALSE(taken([](Body& b) { b.constraints.by_slot[b.plan.slots[0]].limit ^= 1; }));
    CHECK_FALSE(taken([](Body& b) { b.constraints.by_slot[b.plan.slots[1]].limit ^= 1; }));

    // Limits lead from a free particle to a pinned one.
    CHECK_FALSE(taken([](Body& b) { b.cloth.reach.limits.back().particle = 9; }));
    CHECK_FALSE(taken([](Body& b) { b.cloth.reach.limits.back().anchor = 9; }));
    CHECK_FALSE(taken([](Body& b) { b.cloth.reach.limits.back().particle = 0; }));
    CHECK_FALSE(taken([](Body& b) { b.cloth.reach.limits.back().anchor = 1; }));
    const auto distance = [&](double metres) {
        return taken([&](Body& b) { b.cloth.reach.limits.back().distance = metres; });
    };
    CHECK(distance(0));
    CHECK(distance(4 * range * IdTable::capacity));
    for (const double metres : {-tiny, beyond(4 * range * IdTable::capacity), not_a_number}) {
        CHECK_FALSE(distance(metres));
    }
}
