// Snapshots that somebody made up: every word of many kinds of states changed, alone or with others, and the checksum
// mended. They are refused, or they are states that can be stepped and asked like any other. Memory errors, numbers
// that do not fit and endless loops are for the sanitizers and for the patience of ctest to see.
#include <functional>

#include "snapshots.h"

using test::line;
using test::mend;
using test::MeshHandle;
using test::Random;
using test::restore;
using test::Words;
using test::World;

namespace {

constexpr float frame = 1.0f / 60;

/// A world in the midst of something, which can go on.
struct State {
    const char* what;
    std::function<void(World&)> make;
    int frames;
};

gphys_solver_desc with_sleep() {
    gphys_solver_desc desc = World::desc(2);
    desc.sleep_speed = 0.05f;
    desc.sleep_strain = 0.5f;
    desc.sleep_time = 0.1f;
    return desc;
}
void replace_solver(World& world, const gphys_solver_desc& desc) {
    gphys_solver_destroy(world.solver);
    REQUIRE(gphys_solver_create(&desc, &world.solver) == GPHYS_OK);
}
void add_floor(World& world) {
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
}
gphys_model_id add_ball(World& world, gphys_vec3 at, float radius) {
    const gphys_sphere ball{at, radius};
    return world.model(GPHYS_SHAPE_SPHERE, &ball);
}
void join(World& world, gphys_body_id a, uint32_t p, gphys_body_id b, uint32_t q, float rest) {
    gphys_joint_id joint = 0;
    REQUIRE(gphys_solver_join(world.solver, a, p, b, q, rest, 0, &joint) == GPHYS_OK);
}

const State states[] = {
    {"a rope that hangs and one that lies",
     [](World& world) {
         add_floor(world);
         world.pin(world.rope(line({0, 2, 0}, {0.1f, 0, 0}, 5), 0), 0);
         world.rope(line({2, 0.02f, 0}, {0.1f, 0, 0}, 4), 0);
     },
     20},
    {"a rope on a model that moves",
     [](World& world) {
         add_floor(world);
         const gphys_model_id ball = add_ball(world, {0, 0, 0}, 0.1f);
         const gphys_body_id rope = world.rope(line({0, 1, 0}, {0.1f, 0, 0}, 4), 0);
         const gphys_transform up{{0, 1, 0}, {0, 0, 0, 1}, 1}, on{{0.1f, 1, 0}, {0, 0, 0, 1}, 1};
         REQUIRE(gphys_scene_set_transform(world.scene, ball, &up) == GPHYS_OK);
         REQUIRE(gphys_solver_attach(world.solver, world.scene, rope, 0, ball, nullptr) == GPHYS_OK);
         world.step(frame);
         REQUIRE(gphys_scene_set_transform(world.scene, ball, &on) == GPHYS_OK);
     },
     1},
    {"joined ropes, and one that branches",
     [](World& world) {
         const gphys_body_id a = world.rope(line({0, 2, 0}, {0.1f, 0, 0}, 4), 0);
         const gphys_body_id b = world.rope(line({0.3f, 2, 0}, {0, -0.1f, 0}, 3), 0);
         const gphys_body_id weight = world.particles({{0.3f, 1.7f, 0}});
         gphys_constraint_id link = 0;
         const gphys_body_id tree = world.particles(line({2, 2, 0}, {0.1f, 0, 0.02f}, 5));
         for (const uint32_t leaf : {1u, 2u, 3u, 4u}) {
             REQUIRE(gphys_solver_add_distance(world.solver, tree, 0, leaf, -1, 0, &link) == GPHYS_OK);
         }
         world.pin(a, 0);
         world.pin(tree, 1);
         join(world, a, 3, b, 0, 0);
         join(world, b, 2, weight, 0, -1);
     },
     5},
    {"cloth over a ball, pinned",
     [](World& world) {
         add_floor(world);
         add_ball(world, {0.3f, 0.3f, 0.3f}, 0.25f);
         const gphys_body_id cloth = world.cloth({0, 0.58f, 0}, {0.6f, 0, 0}, {0, 0, 0.6f}, 4, 4);
         world.pin(cloth, 0);
     },
     12},
    {"cloth that hangs from a model and carries a rope",
     [](World& world) {
         const gphys_model_id ball = add_ball(world, {0, 0, 0}, 0.05f);
         const gphys_body_id cloth = world.cloth({0, 1, 0}, {0.4f, 0, 0}, {0, 0, 0.4f}, 3, 3);
         REQUIRE(gphys_solver_attach(world.solver, world.scene, cloth, 0, ball, nullptr) == GPHYS_OK);
         join(world, cloth, 8, world.rope(line({0.4f, 1, 0.4f}, {0, -0.1f, 0}, 3), 0), 0, 0);
     },
     5},
    {"links that yield, are damped or only pull, with error targets",
     [](World& world) {
         gphys_solver_desc desc = World::desc(2);
         desc.max_strain = 0.01f;
         desc.tolerance = 0.01f;
         replace_solver(world, desc);
         add_ball(world, {0.2f, 0.3f, 0}, 0.2f);
         gphys_body_desc soft = World::body_desc();
         soft.compliance = 1e-3f;
         const gphys_body_id rope = world.rope(line({0, 0.6f, 0}, {0.1f, 0, 0}, 4), 0, soft);
         const gphys_body_id cloth = world.cloth({0, 0.55f, -0.2f}, {0.4f, 0, 0}, {0, 0, 0.4f}, 3, 3, soft);
         gphys_constraint_id link = 0;
         gphys_constraint_info first{};
         uint32_t total = 0;
         for (const gphys_body_id body : {rope, cloth}) {
             gphys_solver_get_constraints(world.solver, body, &first, 1, &total);
             REQUIRE(gphys_solver_set_constraint_damping(world.solver, body, first.id, 0.5f) == GPHYS_OK);
         }
         REQUIRE(gphys_solver_add_max_distance(world.solver, cloth, 0, 8, 0.5f, 0, &link) == GPHYS_OK);
         const gphys_body_id chain = world.particles(line({0, 2, 0}, {0.05f, 0, 0}, 4));
         for (uint32_t p = 0; p < 3; ++p) {
             REQUIRE(gphys_solver_add_max_distance(world.solver, chain, p, p + 1, 0.1f, 0, &link) == GPHYS_OK);
         }
         world.pin(chain, 0);
     },
     6},
    {"a balloon",
     [](World& world) {
         add_floor(world);
         const MeshHandle form({0, 0.1f, 0, 0.4f, 0.1f, 0, 0, 0.5f, 0, 0, 0.1f, 0.4f},
                               {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
         gphys_body_id body = 0;
         REQUIRE(gphys_solver_add_cloth_mesh(world.solver, nullptr, form.mesh, nullptr, &body) == GPHYS_OK);
         REQUIRE(gphys_solver_set_volume(world.solver, body, -1, 1e-6f) == GPHYS_OK);
     },
     8},
    {"particles that collide with one another and stick",
     [](World& world) {
         add_floor(world);
         gphys_body_desc desc = test::point_mass(0.05f, 0.4f, 0.3f);
         desc.static_friction = 0.6f;
         desc.self_collision = 1;
         desc.body_layers = 1;
         world.particles(line({0, 0.05f, 0}, {0.05f, 0.06f, 0.01f}, 6), desc);
         world.rope(line({0, 0.3f, 0.05f}, {0.11f, 0, 0}, 4), 0, desc);
     },
     10},
    {"friction of single particles",
     [](World& world) {
         add_floor(world);
         gphys_body_desc desc = test::point_mass(0.05f, 0.4f, 0);
         desc.static_friction = 0.6f;
         const gphys_body_id bodies[] = {world.particles(line({0, 0.05f, 0}, {0.2f, 0, 0}, 3), desc),
                                         world.rope(line({0, 0.05f, 1}, {0.1f, 0, 0}, 3), 0, desc),
                                         world.cloth({0, 0.05f, 2}, {0.2f, 0, 0}, {0, 0, 0.2f}, 3, 3, desc)};
         const float factors[] = {0, 0.5f, 2};
         for (const gphys_body_id body : bodies) {
             REQUIRE(gphys_solver_set_friction_factors(world.solver, body, 0, 3, factors, 4) == GPHYS_OK);
         }
     },
     3},
    {"clusters, one of them gone",
     [](World& world) {
         add_floor(world);
         const uint32_t all[] = {0, 1, 2, 3, 4, 5};
         const gphys_body_id bodies[] = {
             world.particles({{0, 0.1f, 0}, {0.2f, 0.1f, 0}, {0, 0.3f, 0}, {0, 0.1f, 0.2f}}),
             world.rope(line({0, 0.3f, 1}, {0.1f, 0, 0}, 6), 0),
             world.cloth({0, 0.2f, 2}, {0.2f, 0, 0}, {0, 0.05f, 0.2f}, 3, 3)};
         gphys_cluster_id cluster = 0;
         for (const gphys_body_id body : bodies) {
             REQUIRE(gphys_solver_add_cluster(world.solver, body, all, 4, &cluster) == GPHYS_OK);
             REQUIRE(gphys_solver_add_cluster(world.solver, body, all, 2, &cluster) == GPHYS_OK);
         }
         REQUIRE(gphys_solver_remove_cluster(world.solver, bodies[2], cluster) == GPHYS_OK);
         REQUIRE(gphys_solver_add_cluster(world.solver, bodies[1], all + 1, 5, &cluster) == GPHYS_OK);
         world.pin(bodies[1], 0);
     },
     8},
    {"breaking forces, and torn cloth",
     [](World& world) {
         add_floor(world);
         gphys_body_desc desc = World::body_desc();
         desc.breaking_force = 0.3f;
         const gphys_body_id sheet = world.cloth({0, 0.4f, 0}, {0.4f, 0, 0}, {0, -0.3f, 0.1f}, 4, 4, desc);
         const gphys_body_id rope = world.rope(line({0, 0.3f, 1}, {0.1f, 0, 0}, 4), 0, desc);
         world.pin(sheet, 0);
         world.pin(sheet, 3);
         world.pin(rope, 0);
     },
     8},
    {"ropes that resist bending",
     [](World& world) {
         add_floor(world);
         gphys_body_desc desc = World::body_desc();
         desc.bending_stiffness = 0.1f;
         world.pin(world.rope(line({0, 0.3f, 0}, {0.1f, 0, 0}, 4), 0, desc), 0);
         world.rope(line({0, 0.1f, 1}, {0.1f, 0, 0.1f}, 3), 0, desc);
     },
     8},
    {"sleepers",
     [](World& world) {
         replace_solver(world, with_sleep());
         add_floor(world);
         world.rope(line({0, 0.011f, 0}, {0.1f, 0, 0}, 3), 0);
         world.cloth({0, 0.011f, 1}, {0.2f, 0, 0}, {0, 0, 0.2f}, 3, 3);
     },
     40},
    {"bodies that come and went, changed since the last step",
     [](World& world) {
         const gphys_body_id first = world.particles({{0, 0, 0}}), second = world.particles({{1, 0, 0}});
         const gphys_body_id rope = world.rope(line({0, 1, 0}, {0.1f, 0, 0}, 4), 0);
         const gphys_body_id cloth = world.cloth({0, 2, 0}, {0.2f, 0, 0}, {0, 0, 0.2f}, 3, 3);
         gphys_constraint_id link = 0;
         world.step(frame);
         REQUIRE(gphys_solver_remove_body(world.solver, first) == GPHYS_OK);
         REQUIRE(gphys_solver_remove_body(world.solver, second) == GPHYS_OK);
         REQUIRE(gphys_solver_add_distance(world.solver, rope, 0, 2, -1, 0, &link) == GPHYS_OK);
         REQUIRE(gphys_solver_remove_constraint(world.solver, rope, link) == GPHYS_OK);
         world.pin(cloth, 0);
         const gphys_vec3 force{0, 1, 0};
         REQUIRE(gphys_solver_set_forces(world.solver, rope, 0, 1, &force, 12) == GPHYS_OK);
         REQUIRE(gphys_solver_advance(world.solver, world.scene, 1.7f * frame, nullptr, nullptr) == GPHYS_OK);
         REQUIRE(gphys_solver_add_distance(world.solver, cloth, 0, 8, -1, 0, &link) == GPHYS_OK);
     },
     0},
};

World& made(World& world, const State& state) {
    state.make(world);
    for (int i = 0; i < state.frames; ++i) world.step(frame);
    return world;
}

/// Everything that can be asked for, and a few steps.
void use(World& world) {
    gphys_solver* const solver = world.solver;
    uint32_t total = 0, bodies_total = 0;
    gphys_body_id bodies[16];
    std::vector<gphys_vec3> places;
    const auto ask = [&] {
        gphys_solver_stats stats;
        gphys_contact contacts[8];
        gphys_body_contact touches[8];
        gphys_impulse impulses[8];
        gphys_joint_info joints[8];
        REQUIRE(gphys_solver_get_stats(solver, 0, &stats) == GPHYS_OK);
        REQUIRE(gphys_solver_get_contacts(solver, contacts, 8, &total) >= GPHYS_OK);
        REQUIRE(gphys_solver_get_body_contacts(solver, touches, 8, &total) >= GPHYS_OK);
        REQUIRE(gphys_solver_get_impulses(solver, impulses, 8, &total) >= GPHYS_OK);
        REQUIRE(gphys_solver_get_joints(solver, 0, joints, 8, &total) >= GPHYS_OK);
        REQUIRE(gphys_solver_get_bodies(solver, bodies, 16, &bodies_total) == GPHYS_OK);
        for (uint32_t i = 0; i < bodies_total; ++i) {
            gphys_body_info info;
            gphys_constraint_info links[8];
            uint32_t corners[8];
            float volume = 0;
            REQUIRE(gphys_solver_get_body_info(solver, bodies[i], &info) == GPHYS_OK);
            REQUIRE(gphys_solver_get_constraints(solver, bodies[i], links, 8, &total) >= GPHYS_OK);
            REQUIRE(gphys_solver_get_triangles(solver, bodies[i], corners, 8, &total) >= GPHYS_OK);
            gphys_solver_get_volume(solver, bodies[i], &volume, nullptr);
            gphys_cluster_id clusters[4];
            REQUIRE(gphys_solver_get_clusters(solver, bodies[i], clusters, 4, &total) >= GPHYS_OK);
            for (uint32_t k = 0; k < std::min(total, 4u); ++k) {
                uint32_t members = 0;
                REQUIRE(gphys_solver_get_cluster_particles(solver, bodies[i], clusters[k], corners, 8, &members) >=
                        GPHYS_OK);
                REQUIRE(members >= 2);
            }
            places.resize(info.particle_count);
            REQUIRE(gphys_solver_get_positions(solver, bodies[i], 0, info.particle_count, places.data(), 12) ==
                    GPHYS_OK);
        }
    };
    ask();
    for (int i = 0; i < 2; ++i) {
        // A made-up origin may not be the scene's.
        if (gphys_solver_step(solver, world.scene, frame) != GPHYS_OK) {
            REQUIRE(gphys_solver_step(solver, nullptr, frame) == GPHYS_OK);
        }
    }
    ask();
    const Words after = test::snapshot(solver);
    const gphys_status again = restore(solver, after);
    REQUIRE((again == GPHYS_OK || again == GPHYS_ERROR_INVALID_ARGUMENT));
    // What comes and goes finds its ids in order.
    const gphys_vec3 point{0, 1, 0};
    gphys_body_id added = 0;
    REQUIRE(gphys_solver_add_particles(solver, nullptr, &point, 12, 1, &added) == GPHYS_OK);
    for (uint32_t i = 0; i < bodies_total; ++i) {
        REQUIRE(bodies[i] != added);
        REQUIRE(gphys_solver_remove_body(solver, bodies[i]) == GPHYS_OK);
    }
}

/// What one might write over a word.
uint32_t hostile(Random& random, const Words& words, size_t at) {
    static const uint32_t values[] = {
        0,          1,          2,          7,          0xffffff,   0x1000000,  0x7fffffff,
        0x80000000, 0xffffffff, 0x7fc00000, 0x7f800000, 0xff800000, 0x7f7fffff, 0x7ff80000,
        0x7ff00000, 0xfff00000, 0x7fefffff, 0x5fe00000, 0x46293e59, 0xc6293e59, 0x41cdcd65,
        0x00100000, 0x00000001, 0x3ff00000, 0x430c6bf5, 0x4e6e1000, 0x3e112e0c, 0x58635fa9,
    };
    const uint32_t kinds = sizeof values / sizeof values[0], kind = random.index(kinds + 6);
    if (kind < kinds) return values[kind];
    const size_t other = test::header_words + random.index(static_cast<uint32_t>(words.size() - test::header_words));
    switch (kind - kinds) {
        case 0:
            return words[at] + 1;
        case 1:
            return words[at] - 1;
        case 2:
            return words[at] ^ 1u << random.index(32);
        case 3:
            return words[std::min(at + 1 + random.index(4), words.size() - 1)];
        case 4:
            return words[other];
        default:
            return static_cast<uint32_t>(random.engine());
    }
}

struct Count {
    int taken = 0, refused = 0;
};

void attack(World& world, const Words& words, Count& count) {
    const gphys_status status = restore(world.solver, words);
    REQUIRE((status == GPHYS_OK || status == GPHYS_ERROR_INVALID_ARGUMENT));
    ++(status == GPHYS_OK ? count.taken : count.refused);
    if (status == GPHYS_OK) use(world);
}

/// So many changes of each word that is tried, and so many of several words at once.
Count attack_everywhere(const State& state, uint32_t changes, uint32_t combinations, uint64_t seed) {
    World world;
    const Words good = test::snapshot(made(world, state).solver);
    Random random(seed);
    Count count;
    const uint32_t words = static_cast<uint32_t>(good.size() - test::header_words);
    for (size_t at = test::header_words; at < good.size(); ++at) {
        if (!test::is_tried(static_cast<uint32_t>(at))) continue;
        for (uint32_t i = 0; i < changes; ++i) attack(world, test::forged(good, at, hostile(random, good, at)), count);
    }
    for (uint32_t i = 0; i < combinations; ++i) {
        Words forgery = good;
        const size_t around = test::header_words + random.index(words);
        for (uint32_t k = 2 + random.index(5); k > 0; --k) {
            const bool near = random.index(2) == 0;
            const size_t at =
                near ? std::min(around + random.index(16), good.size() - 1) : test::header_words + random.index(words);
            forgery[at] = hostile(random, good, at);
        }
        mend(forgery);
        attack(world, forgery, count);
    }
    return count;
}

}  // namespace

TEST_CASE("whatever state a solver is in, its snapshot restores and goes on with the same bits") {
    for (const State& state : states) {
        INFO(state.what);
        World world, other;
        made(world, state);
        for (int i = 0; i < 20; ++i) {
            REQUIRE(restore(other.solver, test::snapshot(world.solver)) == GPHYS_OK);
            REQUIRE(test::hash(other.solver) == test::hash(world.solver));
            for (gphys_solver* const solver : {world.solver, other.solver}) {
                REQUIRE(gphys_solver_step(solver, world.scene, frame) == GPHYS_OK);
            }
            REQUIRE(test::hash(other.solver) == test::hash(world.solver));
        }
    }
}

TEST_CASE("a hostile snapshot is refused, or a state like any other") {
    Count all;
    for (const State& state : states) {
        INFO(state.what);
        const Count count = attack_everywhere(state, 1, test::tries(200), 11);
        all.taken += count.taken;
        all.refused += count.refused;
    }
    CHECK(all.taken > test::tries(1000));
    CHECK(all.refused > test::tries(1000));
}

TEST_CASE("a hostile snapshot is refused, or a state like any other, at length", "[.long]") {
    for (uint64_t seed = 0; seed < 20; ++seed) {
        for (const State& state : states) {
            INFO(state.what);
            attack_everywhere(state, 8, 4000, 1000 + seed);
        }
    }
}
