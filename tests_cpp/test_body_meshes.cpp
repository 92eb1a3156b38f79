// Meshes in the form of bodies: beside meshes and capsules that are made of the same particles, while these move, and
// the bodies, which do not notice.
#include <array>
#include <cstring>
#include <memory>

#include "mesh/mesh_snapshot.h"
#include "scene_fixture.h"
#include "solver_world.h"

using namespace gphys;

namespace {

struct Destroy {
    void operator()(gphys_mesh* mesh) const { gphys_mesh_destroy(mesh); }
    void operator()(gphys_scene* scene) const { gphys_scene_destroy(scene); }
};
using MeshHandle = std::unique_ptr<gphys_mesh, Destroy>;
using SceneHandle = std::unique_ptr<gphys_scene, Destroy>;

MeshHandle mesh_of(gphys_solver* solver, gphys_body_id body) {
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create_from_body(nullptr, solver, body, &mesh) == GPHYS_OK);
    return MeshHandle(mesh);
}

gphys_model_id show(gphys_scene* scene, const gphys_mesh* mesh) {
    gphys_model_id model = 0;
    REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, nullptr, nullptr, &model) == GPHYS_OK);
    return model;
}

SceneHandle empty_scene() {
    gphys_scene* scene = nullptr;
    REQUIRE(gphys_scene_create(nullptr, &scene) == GPHYS_OK);
    return SceneHandle(scene);
}

std::vector<gphys_vec3> positions_of(const gphys_solver* solver, gphys_body_id body) {
    gphys_body_info info;
    REQUIRE(gphys_solver_get_body_info(solver, body, &info) == GPHYS_OK);
    std::vector<gphys_vec3> positions(info.particle_count);
    REQUIRE(gphys_solver_get_positions(solver, body, 0, info.particle_count, positions.data(), 12) == GPHYS_OK);
    return positions;
}

/// A scene that holds the cloth as a mesh which is made of its particles now.
SceneHandle scene_of_cloth(const gphys_solver* solver, gphys_body_id body) {
    const std::vector<gphys_vec3> positions = positions_of(solver, body);
    uint32_t total = 0;
    gphys_solver_get_triangles(solver, body, nullptr, 0, &total);
    std::vector<uint32_t> indices(total);
    REQUIRE(gphys_solver_get_triangles(solver, body, indices.data(), total, &total) == GPHYS_OK);
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create(nullptr, &positions[0].x, 12, static_cast<uint32_t>(positions.size()), indices.data(),
                              total, &mesh) == GPHYS_OK);
    const MeshHandle owner(mesh);
    SceneHandle scene = empty_scene();
    show(scene.get(), mesh);
    return scene;
}

/// A scene that holds the rope as a capsule for each link, and a ball for each particle that is thicker. The models by
/// the triangle that stands for them, 0 for those that are not there.
SceneHandle scene_of_rope(const gphys_solver* solver, gphys_body_id body, std::vector<gphys_model_id>& links) {
    const std::vector<gphys_vec3> positions = positions_of(solver, body);
    std::vector<float> radii(positions.size());
    REQUIRE(gphys_solver_get_radii(solver, body, 0, static_cast<uint32_t>(radii.size()), radii.data(), 4) == GPHYS_OK);
    SceneHandle scene = empty_scene();
    const size_t count = positions.size();
    links.assign(2 * count - 1, 0);
    for (size_t i = 0; i + 1 < count; ++i) {
        const gphys_capsule link{positions[i], positions[i + 1], std::min(radii[i], radii[i + 1])};
        REQUIRE(gphys_scene_add(scene.get(), GPHYS_SHAPE_CAPSULE, &link, nullptr, nullptr, &links[i]) == GPHYS_OK);
    }
    for (size_t p = 1; p + 1 < count; ++p) {
        if (radii[p] <= std::min(radii[p - 1], radii[p + 1])) continue;
        const gphys_capsule ball{positions[p], positions[p], radii[p]};
        REQUIRE(gphys_scene_add(scene.get(), GPHYS_SHAPE_CAPSULE, &ball, nullptr, nullptr, &links[count - 1 + p]) ==
                GPHYS_OK);
    }
    return scene;
}

bool same(gphys_vec3 a, gphys_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Where and how, whatever of.
bool same_place(const gphys_hit& a, const gphys_hit& b) {
    return a.t == b.t && same(a.point, b.point) && same(a.normal, b.normal) && a.flags == b.flags;
}

struct Questions {
    explicit Questions(uint64_t seed) : random(seed) {}

    gphys_vec3 around(const gphys_aabb& box) {
        const auto in = [&](float low, float high) {
            return static_cast<float>(random.uniform(low - 0.2, high + 0.2));
        };
        return {in(box.min.x, box.max.x), in(box.min.y, box.max.y), in(box.min.z, box.max.z)};
    }

    test::Random random;
    int hits = 0;
};

/// Every kind of question to two scenes; is_same(hit, hit), and overlaps and distances that must agree. A box meets
/// one of several points at the same time, which is another one if its axes are given otherwise.
template <class IsSame>
void require_same_answers(const gphys_scene* mine, const gphys_scene* theirs, Questions& questions, int count,
                          IsSame&& is_same) {
    gphys_aabb box, other_box;
    REQUIRE(gphys_scene_get_scene_bounds(mine, &box) == GPHYS_OK);
    REQUIRE(gphys_scene_get_scene_bounds(theirs, &other_box) == GPHYS_OK);
    std::vector<gphys_ray> rays;
    for (int i = 0; i < count; ++i) {
        const gphys_vec3 a = questions.around(box), b = questions.around(box);
        const gphys_ray ray{a, {b.x - a.x, b.y - a.y, b.z - a.z}, i % 3 == 0 ? 1.0f : INFINITY};
        rays.push_back(ray);
        gphys_hit hit{}, other{};
        const gphys_status found = gphys_scene_raycast(mine, &ray, GPHYS_ALL_LAYERS, &hit);
        REQUIRE(found == gphys_scene_raycast(theirs, &ray, GPHYS_ALL_LAYERS, &other));
        if (found == GPHYS_OK) {
            REQUIRE(is_same(hit, other));
            ++questions.hits;
        }
        int32_t any = 2;
        REQUIRE(gphys_scene_raycast_any(mine, &ray, GPHYS_ALL_LAYERS, &any) == GPHYS_OK);
        REQUIRE(any == (found == GPHYS_OK));
        const gphys_segment segment{a, b};
        const gphys_status crossed = gphys_scene_segment_test(mine, &segment, GPHYS_ALL_LAYERS, &hit);
        REQUIRE(crossed == gphys_scene_segment_test(theirs, &segment, GPHYS_ALL_LAYERS, &other));
        if (crossed == GPHYS_OK) REQUIRE(is_same(hit, other));
        gphys_nearest near{}, other_near{};
        REQUIRE(gphys_scene_nearest(mine, &a, INFINITY, GPHYS_ALL_LAYERS, &near) == GPHYS_OK);
        REQUIRE(gphys_scene_nearest(theirs, &a, INFINITY, GPHYS_ALL_LAYERS, &other_near) == GPHYS_OK);
        REQUIRE(near.distance == other_near.distance);
        REQUIRE(same(near.point, other_near.point));
        const gphys_sphere ball{a, 0.05f};
        const gphys_capsule pill{a, {a.x, a.y + 0.1f, a.z}, 0.03f};
        const gphys_aabb cube{{a.x - 0.05f, a.y - 0.05f, a.z - 0.05f}, {a.x + 0.05f, a.y + 0.05f, a.z + 0.05f}};
        const gphys_triangle face{a, b, {a.x + 0.1f, a.y, a.z}};
        const gphys_plane plane{{0, 1, 0}, a.y};
        const std::pair<gphys_shape_type, const void*> shapes[] = {{GPHYS_SHAPE_SPHERE, &ball},
                                                                   {GPHYS_SHAPE_CAPSULE, &pill},
                                                                   {GPHYS_SHAPE_AABB, &cube},
                                                                   {GPHYS_SHAPE_TRIANGLE, &face},
                                                                   {GPHYS_SHAPE_PLANE, &plane}};
        for (const auto& [type, shape] : shapes) {
            uint32_t total = 0, other_total = 0;
            gphys_scene_overlap(mine, type, shape, GPHYS_ALL_LAYERS, nullptr, 0, &total);
            gphys_scene_overlap(theirs, type, shape, GPHYS_ALL_LAYERS, nullptr, 0, &other_total);
            REQUIRE((total > 0) == (other_total > 0));
            if (type == GPHYS_SHAPE_TRIANGLE || type == GPHYS_SHAPE_PLANE) continue;
            const gphys_status met = gphys_scene_sweep(mine, type, shape, &ray.direction, GPHYS_ALL_LAYERS, &hit);
            REQUIRE(met == gphys_scene_sweep(theirs, type, shape, &ray.direction, GPHYS_ALL_LAYERS, &other));
            if (met == GPHYS_OK) {
                REQUIRE(hit.t == other.t);
                if (hit.t > 0 && type == GPHYS_SHAPE_SPHERE) REQUIRE(is_same(hit, other));
            }
            gphys_penetration ways[64], other_ways[64];
            gphys_scene_penetration(mine, type, shape, GPHYS_ALL_LAYERS, ways, 64, &total);
            gphys_scene_penetration(theirs, type, shape, GPHYS_ALL_LAYERS, other_ways, 64, &other_total);
            REQUIRE(total == other_total);
            for (uint32_t k = 0; k < std::min(total, 64u); ++k) REQUIRE(ways[k].depth == other_ways[k].depth);
        }
    }
    std::vector<gphys_hit> many(rays.size());
    REQUIRE(gphys_scene_raycast_batch(mine, rays.data(), sizeof(gphys_ray), static_cast<uint32_t>(rays.size()),
                                      GPHYS_ALL_LAYERS, many.data(), sizeof(gphys_hit)) == GPHYS_OK);
    for (size_t i = 0; i < rays.size(); ++i) {
        gphys_hit single{};
        const bool found = gphys_scene_raycast(mine, &rays[i], GPHYS_ALL_LAYERS, &single) == GPHYS_OK;
        REQUIRE(found == (many[i].model != 0));
        if (found) REQUIRE(std::memcmp(&single, &many[i], sizeof single) == 0);
    }
}

bool same_hit(const gphys_hit& a, const gphys_hit& b) {
    return same_place(a, b) && a.model == b.model && a.triangle == b.triangle && a.u == b.u && a.v == b.v;
}

/// A cloth and a rope that fall onto a ball above the ground.
struct Falling : test::World {
    explicit Falling(const gphys_solver_desc& desc) : test::World(desc) {
        const gphys_plane ground{{0, 1, 0}, 0};
        const gphys_sphere ball{{0, 0.7f, 0}, 0.5f};
        model(GPHYS_SHAPE_PLANE, &ground);
        model(GPHYS_SHAPE_SPHERE, &ball);
        sheet = cloth({-1, 1.4f, -1}, {2, 0, 0}, {0, 0, 2}, 21, 17);
        std::vector<gphys_vec3> points;
        for (int i = 0; i < 30; ++i) points.push_back({-1.2f + 0.08f * static_cast<float>(i), 1.7f, 0.3f});
        gphys_body_desc thick = body_desc();
        thick.radius = 0.03f;
        line = rope(points, 0, thick);
        const float weight = 0.12f;
        REQUIRE(gphys_solver_set_radii(solver, line, 12, 1, &weight, 4) == GPHYS_OK);
    }
    explicit Falling() : Falling(desc()) {}

    std::array<uint32_t, 2> hash() const {
        std::array<uint32_t, 2> hash{};
        REQUIRE(gphys_solver_get_hash(solver, hash.data()) == GPHYS_OK);
        return hash;
    }
    void step() { REQUIRE(gphys_solver_step(solver, scene, 1.0f / 60) == GPHYS_OK); }

    gphys_body_id sheet, line;
};

}  // namespace

TEST_CASE("the mesh of a falling cloth answers as one made of its positions") {
    Falling world;
    const MeshHandle mesh = mesh_of(world.solver, world.sheet);
    const SceneHandle shown = empty_scene();
    show(shown.get(), mesh.get());
    Questions questions(5);
    for (int step = 0; step < 100; ++step) {
        world.step();
        const SceneHandle expected = scene_of_cloth(world.solver, world.sheet);
        require_same_answers(shown.get(), expected.get(), questions, 8, same_hit);
        INFO(gphys_last_error());
        REQUIRE(gphys_scene_validate(shown.get()) == GPHYS_OK);
    }
    REQUIRE(questions.hits > 100);
}

TEST_CASE("the mesh of a falling rope answers as its capsules") {
    Falling world;
    const MeshHandle mesh = mesh_of(world.solver, world.line);
    const SceneHandle shown = empty_scene();
    show(shown.get(), mesh.get());
    Questions questions(6);
    for (int step = 0; step < 100; ++step) {
        world.step();
        std::vector<gphys_model_id> links;
        const SceneHandle expected = scene_of_rope(world.solver, world.line, links);
        require_same_answers(shown.get(), expected.get(), questions, 8, [&](const gphys_hit& a, const gphys_hit& b) {
            return same_place(a, b) && a.triangle < links.size() && links[a.triangle] == b.model;
        });
        INFO(gphys_last_error());
        REQUIRE(gphys_scene_validate(shown.get()) == GPHYS_OK);
    }
    REQUIRE(questions.hits > 100);
}

TEST_CASE("rays from inside a rope's mesh begin there, and all hits of it are listed") {
    test::World world;
    const gphys_body_id line = world.rope({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0);
    const float radius = 0.25f;
    REQUIRE(gphys_solver_set_radii(world.solver, line, 0, 3, &radius, 0) == GPHYS_OK);
    const MeshHandle mesh = mesh_of(world.solver, line);
    show(world.scene, mesh.get());
    gphys_hit hit;
    const gphys_ray within{{1.5f, 0.1f, 0}, {0, 2, 0}, 5};
    REQUIRE(gphys_scene_raycast(world.scene, &within, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK);
    REQUIRE(hit.t == 0);
    REQUIRE(hit.flags == GPHYS_HIT_INSIDE);
    REQUIRE(hit.triangle == 1);
    REQUIRE(same(hit.normal, {0, -1, 0}));
    const gphys_ray along{{-2, 0, 0}, {1, 0, 0}, 10};
    gphys_hit hits[4];
    uint32_t total = 0;
    REQUIRE(gphys_mesh_raycast_all(mesh.get(), &along, hits, 4, &total) == GPHYS_OK);
    REQUIRE(total == 2);
    REQUIRE((hits[0].triangle == 0 && hits[0].t == 1.75f && hits[1].triangle == 1 && hits[1].t == 2.75f));
    int32_t any = 0;
    REQUIRE(gphys_mesh_raycast_any(mesh.get(), &along, &any) == GPHYS_OK);
    REQUIRE(any == 1);
    // Solid: a point on the axis is in it.
    const gphys_vec3 middle{0.5f, 0, 0};
    REQUIRE(gphys_shape_contains(GPHYS_SHAPE_MESH, mesh.get(), &middle, 0, &any) == GPHYS_OK);
    REQUIRE(any == 1);
}

TEST_CASE("free particles are met as balls, each the triangle of its number") {
    test::World world(8, {0, 0, 0});
    const gphys_body_id dust = world.particles({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    const float radii[] = {0.1f, 0.2f, 0.3f};
    REQUIRE(gphys_solver_set_radii(world.solver, dust, 0, 3, radii, 4) == GPHYS_OK);
    const MeshHandle mesh = mesh_of(world.solver, dust);
    show(world.scene, mesh.get());
    for (uint32_t i = 0; i < 3; ++i) {
        gphys_hit hit;
        const gphys_ray down{{static_cast<float>(i), 5, 0}, {0, -1, 0}, 10};
        REQUIRE(gphys_scene_raycast(world.scene, &down, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK);
        REQUIRE(hit.triangle == i);
        REQUIRE(hit.point.y == radii[i]);
    }
    const gphys_vec3 speed{0, 1, 0};
    REQUIRE(gphys_solver_set_velocities(world.solver, dust, 1, 1, &speed, 0) == GPHYS_OK);
    REQUIRE(gphys_solver_step(world.solver, world.scene, 0.25f) == GPHYS_OK);
    gphys_aabb box;
    REQUIRE(gphys_shape_bounds(GPHYS_SHAPE_MESH, mesh.get(), &box) == GPHYS_OK);
    REQUIRE(box.max.y == Approx(0.45f));
}

TEST_CASE("a rope is shown as it is cut, tied again, moved and thickened") {
    test::World world;
    const gphys_body_id line = world.rope({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, 0);
    const MeshHandle mesh = mesh_of(world.solver, line);
    show(world.scene, mesh.get());
    const auto meets = [&](gphys_vec3 from) {
        const gphys_ray down{from, {0, -1, 0}, 10};
        gphys_hit hit;
        return gphys_scene_raycast(world.scene, &down, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK;
    };
    gphys_constraint_info links[3];
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_constraints(world.solver, line, links, 3, &total) == GPHYS_OK);
    REQUIRE(meets({1.5f, 5, 0}));
    REQUIRE(gphys_solver_remove_constraint(world.solver, line, links[1].id) == GPHYS_OK);
    REQUIRE_FALSE(meets({1.5f, 5, 0}));
    REQUIRE(meets({0.5f, 5, 0}));
    REQUIRE(meets({1, 5, 0}));
    REQUIRE(meets({2.5f, 5, 0}));
    gphys_constraint_id tied;
    REQUIRE(gphys_solver_add_max_distance(world.solver, line, 2, 1, -1, 0, &tied) == GPHYS_OK);
    REQUIRE(meets({1.5f, 5, 0}));
    const gphys_vec3 places[] = {{0, 0, 7}, {1, 0, 7}};
    REQUIRE(gphys_solver_set_positions(world.solver, line, 0, 2, places, 12) == GPHYS_OK);
    REQUIRE_FALSE(meets({0.5f, 5, 0}));
    REQUIRE(meets({0.5f, 5, 7}));
    REQUIRE_FALSE(meets({0.5f, 5, 7.4f}));
    const float radius = 0.5f;
    REQUIRE(gphys_solver_set_radii(world.solver, line, 0, 1, &radius, 0) == GPHYS_OK);
    REQUIRE(meets({0, 5, 7.4f}));  // a weight at the end
    REQUIRE_FALSE(meets({0.5f, 5, 7.4f}));
    REQUIRE(gphys_solver_set_radii(world.solver, line, 0, 2, &radius, 0) == GPHYS_OK);
    REQUIRE(meets({0.5f, 5, 7.4f}));
    REQUIRE(gphys_scene_validate(world.scene) == GPHYS_OK);
}

TEST_CASE("bodies move with the same bits whether scenes show them or not, for any number of workers") {
    Falling plain;
    std::vector<std::array<uint32_t, 2>> expected;
    for (int step = 0; step < 60; ++step) {
        plain.step();
        expected.push_back(plain.hash());
    }
    for (const uint32_t workers : {1u, 2u, 4u}) {
        gphys_solver_desc desc = test::World::desc();
        desc.worker_count = workers;
        Falling shown(desc);
        const MeshHandle sheet = mesh_of(shown.solver, shown.sheet), line = mesh_of(shown.solver, shown.line);
        show(shown.scene, sheet.get());
        show(shown.scene, line.get());
        for (int step = 0; step < 60; ++step) {
            shown.step();
            REQUIRE(shown.hash() == expected[static_cast<size_t>(step)]);
        }
    }
}

TEST_CASE("a body sleeps on beside others that move as models") {
    gphys_solver_desc desc = test::World::desc();
    desc.sleep_speed = 0.05f;
    desc.sleep_time = 0.1f;
    test::World world(desc);
    const gphys_plane ground{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &ground);
    const gphys_body_id rests = world.particles({{0, 0.01f, 0}});
    const gphys_body_id line = world.rope({{0, 1, 0}, {0.5f, 1, 0}}, 0);
    REQUIRE(gphys_solver_set_pinned(world.solver, line, 0, 1, 1) == GPHYS_OK);
    const MeshHandle a = mesh_of(world.solver, rests), b = mesh_of(world.solver, line);
    show(world.scene, a.get());
    show(world.scene, b.get());
    for (int i = 0; i < 60; ++i) REQUIRE(gphys_solver_step(world.solver, world.scene, 1.0f / 60) == GPHYS_OK);
    gphys_body_id asleep[2];
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_sleeping(world.solver, asleep, 2, &total) == GPHYS_OK);
    REQUIRE(total == 1);
    REQUIRE(asleep[0] == rests);
}

TEST_CASE("a restored solver brings its meshes back, and embedded copies are not collided with") {
    Falling world;
    const MeshHandle sheet = mesh_of(world.solver, world.sheet), line = mesh_of(world.solver, world.line);
    const gphys_model_id sheet_model = show(world.scene, sheet.get());
    show(world.scene, line.get());
    const auto snapshot = [](auto&& get) {
        uint32_t total = 0;
        REQUIRE(get(nullptr, 0u, &total) == GPHYS_INCOMPLETE);
        std::vector<uint32_t> words(total);
        REQUIRE(get(words.data(), total, &total) == GPHYS_OK);
        return words;
    };
    const auto scene_hash = [&] {
        std::array<uint32_t, 2> hash{};
        REQUIRE(gphys_scene_get_hash(world.scene, hash.data()) == GPHYS_OK);
        return hash;
    };
    for (int i = 0; i < 20; ++i) world.step();
    const std::vector<uint32_t> solver_then = snapshot([&](uint32_t* out, uint32_t room, uint32_t* total) {
        return gphys_solver_get_snapshot(world.solver, out, room, total);
    });
    const auto scene_then = [&](int32_t embed) {
        return snapshot([&](uint32_t* out, uint32_t room, uint32_t* total) {
            return gphys_scene_get_snapshot(world.scene, embed, out, room, total);
        });
    };
    const std::vector<uint32_t> by_name = scene_then(0), complete = scene_then(1);
    const auto hash_then = scene_hash();
    for (int i = 0; i < 20; ++i) world.step();
    const auto bits_later = world.hash();
    const auto hash_later = scene_hash();
    REQUIRE(hash_later != hash_then);

    REQUIRE(gphys_solver_restore(world.solver, solver_then.data(), static_cast<uint32_t>(solver_then.size())) ==
            GPHYS_OK);
    REQUIRE(scene_hash() == hash_then);
    REQUIRE(gphys_scene_restore(world.scene, nullptr, by_name.data(), static_cast<uint32_t>(by_name.size())) ==
            GPHYS_OK);
    for (int i = 0; i < 20; ++i) world.step();
    REQUIRE(world.hash() == bits_later);
    REQUIRE(scene_hash() == hash_later);

    // On another machine: copies of the meshes, until their models are given those of the bodies there.
    test::World other;
    REQUIRE(gphys_solver_restore(other.solver, solver_then.data(), static_cast<uint32_t>(solver_then.size())) ==
            GPHYS_OK);
    REQUIRE(gphys_scene_restore(other.scene, nullptr, complete.data(), static_cast<uint32_t>(complete.size())) ==
            GPHYS_OK);
    gphys_aabb box, later;
    REQUIRE(gphys_scene_get_bounds(other.scene, sheet_model, &box) == GPHYS_OK);
    for (int i = 0; i < 19; ++i) REQUIRE(gphys_solver_step(other.solver, other.scene, 1.0f / 60) == GPHYS_OK);
    REQUIRE(gphys_scene_get_bounds(other.scene, sheet_model, &later) == GPHYS_OK);
    REQUIRE(std::memcmp(&box, &later, sizeof box) == 0);
    const MeshHandle there = mesh_of(other.solver, world.sheet);
    REQUIRE(gphys_scene_set_shape(other.scene, sheet_model, GPHYS_SHAPE_MESH, there.get()) == GPHYS_OK);
    REQUIRE(gphys_solver_step(other.solver, other.scene, 1.0f / 60) == GPHYS_OK);
    std::array<uint32_t, 2> bits{};
    REQUIRE(gphys_solver_get_hash(other.solver, bits.data()) == GPHYS_OK);
    REQUIRE(bits == bits_later);
    REQUIRE(gphys_scene_get_bounds(world.scene, sheet_model, &box) == GPHYS_OK);
    REQUIRE(gphys_scene_get_bounds(other.scene, sheet_model, &later) == GPHYS_OK);
    REQUIRE(std::memcmp(&box, &later, sizeof box) == 0);
}

TEST_CASE("a snapshot of links is links again, and made-up words are refused or answer without harm") {
    Falling world;
    const MeshHandle mesh = mesh_of(world.solver, world.line);
    uint32_t total = 0;
    REQUIRE(gphys_mesh_get_snapshot(mesh.get(), nullptr, 0, &total) == GPHYS_INCOMPLETE);
    std::vector<uint32_t> good(total);
    REQUIRE(gphys_mesh_get_snapshot(mesh.get(), good.data(), total, &total) == GPHYS_OK);
    const auto load = [](const std::vector<uint32_t>& words) {
        gphys_mesh* loaded = nullptr;
        const gphys_status status =
            gphys_mesh_create_from_snapshot(nullptr, words.data(), static_cast<uint32_t>(words.size()), &loaded);
        REQUIRE((status == GPHYS_OK) == (loaded != nullptr));
        return MeshHandle(loaded);
    };
    {
        const MeshHandle copy = load(good);
        REQUIRE(copy);
        const SceneHandle original = empty_scene(), again = empty_scene();
        show(original.get(), mesh.get());
        show(again.get(), copy.get());
        Questions questions(8);
        require_same_answers(original.get(), again.get(), questions, 100, same_hit);
    }
    test::Random random(9);
    const uint32_t hostile[] = {0, 1, 2, 3, 8, 0x7fffffff, 0x80000000, 0xffffffff, 0x7fc00000, 0x58635fa9, 0xd8635fa9};
    int taken = 0, refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::vector<uint32_t> words = good;
        for (uint32_t changes = 1 + random.index(3); changes > 0; --changes) {
            const auto size = static_cast<uint32_t>(words.size());
            words[5 + random.index(size - 5)] = random.index(2) == 0 ? hostile[random.index(11)]  //
                                                                     : words[5 + random.index(size - 5)];
        }
        const uint64_t sum = mesh_snapshot_checksum(words.data(), static_cast<uint32_t>(words.size()));
        words[3] = static_cast<uint32_t>(sum);
        words[4] = static_cast<uint32_t>(sum >> 32);
        const MeshHandle loaded = load(words);
        ++(loaded ? taken : refused);
        if (!loaded) continue;
        const SceneHandle scene = empty_scene();
        show(scene.get(), loaded.get());
        REQUIRE(gphys_scene_validate(scene.get()) == GPHYS_OK);
        const gphys_ray ray{{0, 9, 0.3f}, {random.uniform_float(-0.2f, 0.2f), -1, 0}, INFINITY};
        gphys_hit hit;
        int32_t any = 0;
        const bool met = gphys_scene_raycast(scene.get(), &ray, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK;
        REQUIRE(gphys_scene_raycast_any(scene.get(), &ray, GPHYS_ALL_LAYERS, &any) == GPHYS_OK);
        REQUIRE(any == met);
        gphys_nearest near;
        const gphys_status found = gphys_scene_nearest(scene.get(), &ray.origin, INFINITY, GPHYS_ALL_LAYERS, &near);
        REQUIRE((found == GPHYS_OK || found == GPHYS_NO_HIT));
    }
    REQUIRE(taken > 300);
    REQUIRE(refused > 300);
}

TEST_CASE("a mesh stays as it is when its body is gone, or becomes another one") {
    test::World world;
    uint32_t words = 0;
    std::vector<uint32_t> before;
    REQUIRE(gphys_solver_get_snapshot(world.solver, nullptr, 0, &words) == GPHYS_INCOMPLETE);
    before.resize(words);
    REQUIRE(gphys_solver_get_snapshot(world.solver, before.data(), words, &words) == GPHYS_OK);
    const gphys_body_id line = world.rope({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0);
    const MeshHandle mesh = mesh_of(world.solver, line);
    const gphys_vec3 places[] = {{0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    REQUIRE(gphys_mesh_set_vertices(mesh.get(), &places[0].x, 12, 3) == GPHYS_ERROR_UNSUPPORTED);
    REQUIRE(gphys_solver_restore(world.solver, before.data(), words) == GPHYS_OK);
    REQUIRE(gphys_mesh_set_vertices(mesh.get(), &places[0].x, 12, 3) == GPHYS_OK);
    gphys_aabb box;
    REQUIRE(gphys_shape_bounds(GPHYS_SHAPE_MESH, mesh.get(), &box) == GPHYS_OK);
    REQUIRE(box.max.y == Approx(1.01f));
    // Of the same id, but of other parts.
    const gphys_body_id shorter = world.rope({{0, 0, 0}, {1, 0, 0}}, 0);
    REQUIRE(shorter == line);
    REQUIRE(gphys_solver_step(world.solver, nullptr, 0.01f) == GPHYS_OK);
    gphys_aabb after;
    REQUIRE(gphys_shape_bounds(GPHYS_SHAPE_MESH, mesh.get(), &after) == GPHYS_OK);
    REQUIRE(std::memcmp(&box, &after, sizeof box) == 0);
}

TEST_CASE("models of bodies stay in their place in the world when origins move") {
    for (const bool scene_first : {true, false}) {
        CAPTURE(scene_first);
        test::World world;
        const gphys_body_id line = world.rope({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0);
        const MeshHandle mesh = mesh_of(world.solver, line);
        const gphys_model_id model = show(world.scene, mesh.get());
        for (const double x : {4096.5, 10000.1, -3.25}) {
            const double origin[3] = {x, 0, 2 * x};
            const auto move_scene = [&] { REQUIRE(gphys_scene_set_origin(world.scene, origin) == GPHYS_OK); };
            if (scene_first) move_scene();
            REQUIRE(gphys_solver_set_origin(world.solver, origin) == GPHYS_OK);
            if (!scene_first) move_scene();
            gphys_transform place;
            REQUIRE(gphys_scene_get_transforms(world.scene, &model, 1, &place, sizeof place) == GPHYS_OK);
            if (scene_first) {
                REQUIRE(same(place.position, {0, 0, 0}));
            } else {
                REQUIRE(std::fabs(place.position.x) <= 0.001f);
            }
            const gphys_ray down{{static_cast<float>(0.5 - x), 5, static_cast<float>(-2 * x)}, {0, -1, 0}, 10};
            gphys_hit hit;
            REQUIRE(gphys_scene_raycast(world.scene, &down, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK);
            REQUIRE(hit.triangle == 0);
            REQUIRE(gphys_solver_step(world.solver, world.scene, 1e-6f) == GPHYS_OK);
            REQUIRE(gphys_scene_validate(world.scene) == GPHYS_OK);
        }
    }
}

TEST_CASE("a mesh that cannot follow keeps its form until it can") {
    test::World world(8, {0, 0, 0});
    const gphys_body_id dust = world.particles({{0, 0, 0}, {1, 0, 0}});
    const MeshHandle mesh = mesh_of(world.solver, dust);
    const gphys_transform large{{0, 0, 0}, {0, 0, 0, 1}, 1e14f};
    gphys_model_id model = 0;
    REQUIRE(gphys_scene_add(world.scene, GPHYS_SHAPE_MESH, mesh.get(), &large, nullptr, &model) == GPHYS_OK);
    gphys_vec3 seen[2], far{1000, 0, 0}, near{3, 0, 0};
    uint32_t total = 0;
    REQUIRE(gphys_solver_set_positions(world.solver, dust, 1, 1, &far, 0) == GPHYS_OK);
    REQUIRE(gphys_mesh_get_vertices(mesh.get(), seen, 2, &total) == GPHYS_OK);
    REQUIRE(seen[1].x == 1);
    REQUIRE(gphys_solver_set_positions(world.solver, dust, 1, 1, &near, 0) == GPHYS_OK);
    REQUIRE(gphys_mesh_get_vertices(mesh.get(), seen, 2, &total) == GPHYS_OK);
    REQUIRE(seen[1].x == 3);
    REQUIRE(gphys_scene_validate(world.scene) == GPHYS_OK);
}

TEST_CASE("a mesh that nobody holds is let go, and scene, mesh and solver go in any order") {
    for (int order = 0; order < 6; ++order) {
        CAPTURE(order);
        test::CountedMemory memory;
        const gphys_allocator hooks = memory.hooks();
        gphys_solver_desc desc = test::World::desc();
        desc.allocator = &hooks;
        gphys_solver* solver = nullptr;
        REQUIRE(gphys_solver_create(&desc, &solver) == GPHYS_OK);
        const gphys_vec3 corner{0, 0, 0}, u{1, 0, 0}, v{0, 0, 1};
        gphys_body_id sheet = 0;
        REQUIRE(gphys_solver_add_cloth(solver, nullptr, &corner, &u, &v, 5, 5, &sheet) == GPHYS_OK);
        gphys_mesh_desc mesh_desc;
        REQUIRE(gphys_mesh_desc_init(&mesh_desc, sizeof mesh_desc) == GPHYS_OK);
        mesh_desc.allocator = &hooks;
        gphys_mesh* mesh = nullptr;
        REQUIRE(gphys_mesh_create_from_body(&mesh_desc, solver, sheet, &mesh) == GPHYS_OK);
        SceneHandle scene = empty_scene();
        show(scene.get(), mesh);
        const int first = order / 2, second = (first + 1 + order % 2) % 3, third = 3 - first - second;
        for (const int which : {first, second, third}) {
            if (which == 0) scene.reset();
            if (which == 1) gphys_mesh_destroy(mesh);
            if (which == 2) {
                gphys_solver_destroy(solver);
                solver = nullptr;
            } else if (solver) {
                REQUIRE(gphys_solver_step(solver, scene.get(), 0.01f) == GPHYS_OK);
            }
        }
        REQUIRE(memory.live_bytes == 0);
    }
}

TEST_CASE("the nearest particle is that of the link or triangle which was hit") {
    test::World world;
    const gphys_body_id line = world.rope({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0);
    const gphys_body_id sheet = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 2, 2);
    const auto nearest = [&](gphys_body_id body, uint32_t triangle, gphys_vec3 point) {
        uint32_t particle = 99;
        const gphys_status status = gphys_solver_get_nearest_particle(world.solver, body, triangle, &point, &particle);
        REQUIRE((status == GPHYS_OK) == (particle != 99));
        return particle;
    };
    REQUIRE(nearest(line, 0, {0.4f, 0.1f, 0}) == 0);
    REQUIRE(nearest(line, 0, {0.6f, 0.1f, 0}) == 1);
    REQUIRE(nearest(line, 0, {0.5f, 0.1f, 0}) == 0);
    REQUIRE(nearest(line, 1, {-5, 0, 0}) == 1);
    REQUIRE(nearest(line, 2, {2, 0, 0}) == 0);
    REQUIRE(nearest(line, 4, {0, 0, 0}) == 2);
    REQUIRE(nearest(line, 5, {0, 0, 0}) == 99);
    REQUIRE(nearest(line, GPHYS_NO_TRIANGLE, {1.9f, 0, 0}) == 2);
    REQUIRE(nearest(sheet, 1, {0.9f, 0, 0.9f}) == 3);
    REQUIRE(nearest(sheet, 0, {0.9f, 0, 0.9f}) == 1);
    REQUIRE(nearest(sheet, 2, {0, 0, 0}) == 99);
}
