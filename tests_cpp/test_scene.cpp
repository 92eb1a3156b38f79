#include "scene/scene.h"

#include <algorithm>
#include <cstring>

#include "c_api/handles.h"
#include "scene_fixture.h"

using namespace gphys;
using test::at;
using test::SceneFixture;

namespace {

gphys_model_info info(const SceneFixture& s, gphys_model_id model) {
    gphys_model_info info{};
    REQUIRE(gphys_scene_get_info(s.scene, model, &info) == GPHYS_OK);
    return info;
}

bool same_bits(const gphys_transform& a, const gphys_transform& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// All that a caller can see of a scene.
struct Snapshot {
    std::vector<gphys_model_id> ids;
    std::vector<gphys_model_info> infos;
    std::vector<gphys_transform> locals, worlds;
    std::vector<gphys_octree_box> root;

    explicit Snapshot(const SceneFixture& s) {
        uint32_t total = 0;
        gphys_scene_get_models(s.scene, nullptr, 0, &total);
        ids.resize(total);
        gphys_scene_get_models(s.scene, ids.data(), total, &total);
        for (const gphys_model_id id : ids) {
            infos.push_back(info(s, id));
            locals.push_back(s.local(id));
            worlds.push_back(s.world(id));
        }
        CHECK(s.sound());
    }
    bool operator==(const Snapshot& o) const {
        return ids == o.ids && std::equal(locals.begin(), locals.end(), o.locals.begin(), same_bits) &&
               std::equal(worlds.begin(), worlds.end(), o.worlds.begin(), same_bits) &&
               std::equal(infos.begin(), infos.end(), o.infos.begin(),
                          [](const auto& a, const auto& b) { return std::memcmp(&a, &b, sizeof a) == 0; });
    }
};

}  // namespace

// --- The book's scene lost, repeated and dangled; each line here is one of its defects -----------

TEST_CASE("a model far outside all others is found") {
    SceneFixture s;
    for (float x = 0; x < 20; ++x) s.add_box(at(3 * x, 0, 0));
    const gphys_model_id far = s.add_box(at(-1e6f, 5e5f, 3e5f));
    CHECK(s.first_on_ray({-1e6f, 5e5f, 0}, {0, 0, 1}) == far);
    CHECK(s.in_sphere({-1e6f, 5e5f, 3e5f}, 2) == std::vector<gphys_model_id>{far});
}

TEST_CASE("a model that reaches through the whole scene is listed once") {
    SceneFixture s;
    const gphys_model_id large = s.add_sphere(1000, at(0, 0, 0));
    std::vector<gphys_model_id> all{large};
    for (int i = 0; i < 500; ++i)
        all.push_back(s.add_box(at(static_cast<float>(i % 10 * 3), i / 100 * 3.f, i / 10 % 10 * 3.f)));
    std::sort(all.begin(), all.end());
    CHECK(s.in_sphere({0, 0, 0}, 900) == all);
    const gphys_ray ray{{-2000, 0.5f, 0.5f}, {1, 0, 0}, INFINITY};
    std::vector<gphys_hit> hits(1000);
    uint32_t total = 0;
    REQUIRE(gphys_scene_raycast_all(s.scene, &ray, GPHYS_ALL_LAYERS, hits.data(), 1000, &total) == GPHYS_OK);
    CHECK(std::count_if(hits.begin(), hits.begin() + total, [&](const gphys_hit& h) { return h.model == large; }) == 1);
}

TEST_CASE("a model added later is visible at once") {
    SceneFixture s;
    for (float x = 0; x < 50; ++x) s.add_box(at(3 * x, 0, 0));
    CHECK(s.first_on_ray({60, 50, 0}, {0, -1, 0}) != 0);
    const gphys_model_id later = s.add_box(at(60, 20, 0));
    CHECK(s.first_on_ray({60, 50, 0}, {0, -1, 0}) == later);
}

TEST_CASE("a removed model leaves nothing behind") {
    SceneFixture s;
    const gphys_model_id below = s.add_box(at(0, 0, 0)), above = s.add_box(at(0, 5, 0));
    CHECK(s.first_on_ray({0, 50, 0}, {0, -1, 0}) == above);
    REQUIRE(gphys_scene_remove(s.scene, above) == GPHYS_OK);
    CHECK(s.first_on_ray({0, 50, 0}, {0, -1, 0}) == below);
    CHECK(gphys_scene_has(s.scene, above) == GPHYS_ERROR_INVALID_ID);
    CHECK(gphys_scene_remove(s.scene, above) == GPHYS_ERROR_INVALID_ID);
    REQUIRE(gphys_scene_remove(s.scene, below) == GPHYS_OK);
    CHECK(s.first_on_ray({0, 50, 0}, {0, -1, 0}) == 0);
    gphys_aabb bounds;
    CHECK(gphys_scene_get_scene_bounds(s.scene, &bounds) == GPHYS_NO_HIT);
    CHECK(s.sound());
}

TEST_CASE("rays from far outside hit") {
    SceneFixture s;
    const gphys_model_id box = s.add_box(at(0, 0, 0));
    CHECK(s.first_on_ray({1e9f, 0, 0}, {-1, 0, 0}) == box);
    CHECK(s.first_on_ray({0, -1e12f, 0}, {0, 1e-3f, 0}) == box);
    CHECK(s.first_on_ray({1e9f, 1.5f, 0}, {-1, 0, 0}) == 0);
}

TEST_CASE("a miss after a hit keeps the hit") {
    SceneFixture s;
    const gphys_model_id hit = s.add_box(at(0, 0, 10));
    s.add_sphere(0.1f, at(0.9f, 0.9f, 20));
    s.add_box(at(5, 0, 5));
    CHECK(s.first_on_ray({0, 0, 0}, {0, 0, 1}) == hit);
}

TEST_CASE("of several models on a ray the nearest is hit, in whatever order they were added") {
    for (const bool reversed : {false, true}) {
        SceneFixture s;
        std::vector<gphys_model_id> ids;
        for (int i = 0; i < 30; ++i)
            ids.push_back(s.add_box(at(0, 0, 4.f * static_cast<float>(reversed ? 30 - i : i + 1))));
        CHECK(s.first_on_ray({0, 0, 0}, {0, 0, 1}) == (reversed ? ids.back() : ids.front()));
    }
}

TEST_CASE("equal hits go to the lower id") {
    SceneFixture s;
    std::vector<gphys_model_id> ids;
    for (int i = 0; i < 40; ++i) ids.push_back(s.add_box(at(0, 0, 5)));
    CHECK(s.first_on_ray({0, 0, 0}, {0, 0, 1}) == ids[0]);
    REQUIRE(gphys_scene_remove(s.scene, ids[0]) == GPHYS_OK);
    for (int i = 0; i < 1023; ++i) REQUIRE(gphys_scene_remove(s.scene, s.add_box(at(0, 0, 5))) == GPHYS_OK);
    const gphys_model_id later = s.add_box(at(0, 0, 5));  // its slot, but a higher generation
    CHECK(((later ^ ids[0]) & 0xffffff) == 0);
    CHECK(s.first_on_ray({0, 0, 0}, {0, 0, 1}) == ids[1]);
}

TEST_CASE("a model's sphere counts with its radius, times the scale") {
    SceneFixture s;
    const gphys_model_id ball = s.add_sphere(2, at(10, 0, 0, 3));
    CHECK(s.in_sphere({3, 0, 0}, 1) == std::vector<gphys_model_id>{ball});
    CHECK(s.in_sphere({3, 0, 0}, 0.99f).empty());
}

TEST_CASE("a model's plane moves with its translation and turns with its rotation") {
    SceneFixture s;
    const gphys_plane floor{{0, 1, 0}, 0};
    const gphys_model_id plane = s.add(GPHYS_SHAPE_PLANE, &floor, at(0, 7, 0));
    CHECK(s.in_sphere({100, 8, -100}, 1) == std::vector<gphys_model_id>{plane});
    CHECK(s.in_sphere({100, 8.1f, -100}, 1).empty());
    const float h = std::sqrt(0.5f);
    REQUIRE(s.move(plane, {{3, 0, 0}, {0, 0, h, h}, 1}) == GPHYS_OK);  // +y becomes -x
    CHECK(s.in_sphere({4, 55, 5}, 1.0001f) == std::vector<gphys_model_id>{plane});
    CHECK(s.in_sphere({4.1f, 55, 5}, 1).empty());
    gphys_aabb bounds;
    CHECK(gphys_scene_get_bounds(s.scene, plane, &bounds) == GPHYS_UNBOUNDED);
}

TEST_CASE("children at all levels follow their parent") {
    SceneFixture s;
    gphys_model_id chain[5];
    for (int i = 0; i < 5; ++i) chain[i] = s.add_box(at(0, 10, 0), i == 0 ? 0 : chain[i - 1]);
    for (int i = 0; i < 5; ++i) CHECK(s.world(chain[i]).position.y == 10.f * static_cast<float>(i + 1));
    REQUIRE(s.move(chain[0], at(100, 10, 0)) == GPHYS_OK);
    for (int i = 0; i < 5; ++i) {
        CHECK(s.first_on_ray({100, 10.f * static_cast<float>(i + 1), -50}, {0, 0, 1}) == chain[i]);
        CHECK(s.first_on_ray({0, 10.f * static_cast<float>(i + 1), -50}, {0, 0, 1}) == 0);
    }
    const float h = std::sqrt(0.5f);
    REQUIRE(s.move(chain[0], {{0, 0, 0}, {0, 0, h, h}, 2}) == GPHYS_OK);  // +y becomes -x
    CHECK(std::fabs(s.world(chain[4]).position.x + 80) < 1e-4f);          // 4 offsets of 10, scaled by 2
    CHECK(s.world(chain[4]).scale == 2);
    CHECK(s.sound());
}

TEST_CASE("a model cannot become its own ancestor") {
    SceneFixture s;
    const gphys_model_id a = s.add_box(at(0, 0, 0)), b = s.add_box(at(3, 0, 0), a), c = s.add_box(at(3, 0, 0), b);
    const Snapshot before(s);
    CHECK(gphys_scene_set_parent(s.scene, a, a, 0) == GPHYS_ERROR_CYCLE);
    CHECK(gphys_scene_set_parent(s.scene, a, c, 0) == GPHYS_ERROR_CYCLE);
    CHECK(gphys_scene_set_parent(s.scene, a, c, 1) == GPHYS_ERROR_CYCLE);
    CHECK(Snapshot(s) == before);
    CHECK(gphys_scene_set_parent(s.scene, c, a, 1) == GPHYS_OK);
    CHECK(gphys_scene_set_parent(s.scene, b, c, 1) == GPHYS_OK);
    CHECK(s.sound());
}

// --- Hierarchy -----------------------------------------------------------------------------------

TEST_CASE("a chain of 100000 models moves, and goes, without recursion") {
    SceneFixture s;
    test::Random random(33);
    std::vector<gphys_model_id> chain;
    gphys_vec3 above{0, 0, 0};
    for (int i = 0; i < 100000; ++i) {
        // Whole numbers, so that the steps add up exactly.
        const gphys_vec3 p = random.point(500);
        const gphys_vec3 place{std::round(p.x), std::round(p.y), std::round(p.z)};
        const gphys_transform step = at(place.x - above.x, place.y - above.y, place.z - above.z);
        chain.push_back(s.add_box(step, i == 0 ? 0 : chain.back()));
        above = place;
    }
    CHECK(same_bits(s.world(chain.back()), at(above.x, above.y, above.z)));
    const gphys_transform first = s.local(chain[0]);
    REQUIRE(s.move(chain[0], at(first.position.x, first.position.y + 500, first.position.z)) == GPHYS_OK);
    CHECK(same_bits(s.world(chain.back()), at(above.x, above.y + 500, above.z)));
    CHECK(gphys_scene_set_parent(s.scene, chain[0], chain.back(), 0) == GPHYS_ERROR_CYCLE);
    // All at once, deepest first: each model must still be visited once.
    std::vector<gphys_model_id> backwards(chain.rbegin(), chain.rend());
    const gphys_transform step = at(2, 0, 0);
    REQUIRE(gphys_scene_set_transforms(s.scene, backwards.data(), &step, 0, 100000) == GPHYS_OK);
    CHECK(s.world(chain.back()).position.x == 200000);
    CHECK(s.sound());
    REQUIRE(gphys_scene_remove_subtree(s.scene, chain[1]) == GPHYS_OK);
    CHECK(gphys_scene_has(s.scene, chain[0]) == GPHYS_OK);
    CHECK(gphys_scene_has(s.scene, chain.back()) == GPHYS_ERROR_INVALID_ID);
    CHECK(info(s, chain[0]).child_count == 0);
    CHECK(s.sound());
}

TEST_CASE("the children of a removed model stay where they are and lose their parent") {
    SceneFixture s;
    const gphys_model_id root = s.add_box({{5, 6, 7}, {0.6f, 0, 0, 0.8f}, 2});
    const gphys_model_id middle = s.add_box({{1, 2, 3}, {0, 0.6f, 0, 0.8f}, 0.5f}, root);
    const gphys_model_id leaves[2] = {s.add_box(at(4, 0, 0), middle), s.add_box(at(0, 4, 0), middle)};
    const gphys_transform before[2] = {s.world(leaves[0]), s.world(leaves[1])};
    REQUIRE(gphys_scene_remove(s.scene, middle) == GPHYS_OK);
    for (int i = 0; i < 2; ++i) {
        CHECK(same_bits(s.world(leaves[i]), before[i]));
        CHECK(same_bits(s.local(leaves[i]), before[i]));
        CHECK(info(s, leaves[i]).parent == 0);
    }
    CHECK(info(s, root).child_count == 0);
    CHECK(s.sound());
}

TEST_CASE("a new parent keeps the local transform or the place in the world, as asked") {
    SceneFixture s;
    const gphys_model_id parent = s.add_box({{10, 0, 0}, {0, 0.6f, 0, 0.8f}, 2});
    const gphys_model_id child = s.add_box(at(1, 2, 3));
    REQUIRE(gphys_scene_set_parent(s.scene, child, parent, 1) == GPHYS_OK);
    // Three roundings of float32 (local, its rotation, world) of coordinates up to 16.
    const float tolerance = 16 * 3 * 0x1p-24f;
    CHECK(std::fabs(s.world(child).position.x - 1) < tolerance);
    CHECK(std::fabs(s.world(child).position.y - 2) < tolerance);
    CHECK(std::fabs(s.world(child).position.z - 3) < tolerance);
    CHECK(s.world(child).scale == 1);
    CHECK(info(s, child).parent == parent);
    CHECK(info(s, parent).child_count == 1);

    REQUIRE(s.move(child, at(0, 5, 0)) == GPHYS_OK);
    CHECK(s.world(child).position.y == 10);
    const gphys_transform in_world = s.world(child);
    REQUIRE(gphys_scene_set_parent(s.scene, child, 0, 1) == GPHYS_OK);
    CHECK(same_bits(s.world(child), in_world));
    REQUIRE(gphys_scene_set_parent(s.scene, child, parent, 0) == GPHYS_OK);
    CHECK(s.local(child).position.y == 10);
    CHECK(s.world(child).position.y == 20);
    REQUIRE(gphys_scene_set_parent(s.scene, child, 0, 0) == GPHYS_OK);
    CHECK(s.world(child).position.y == 10);
    CHECK(s.sound());
}

TEST_CASE("of transforms for the same model in a batch the last counts, for its children too") {
    SceneFixture s;
    const gphys_model_id parent = s.add_box(at(0, 0, 0)), child = s.add_box(at(0, 0, 1), parent);
    const gphys_model_id models[4] = {child, parent, child, parent};
    const gphys_transform to[4] = {at(9, 9, 9), at(8, 8, 8), at(0, 0, 2), at(0, 1, 0)};
    REQUIRE(gphys_scene_set_transforms(s.scene, models, to, sizeof *to, 4) == GPHYS_OK);
    CHECK(same_bits(s.world(parent), at(0, 1, 0)));
    CHECK(same_bits(s.world(child), at(0, 1, 2)));
    CHECK(s.sound());
}

TEST_CASE("a transform that would carry a descendant out of range changes nothing") {
    SceneFixture s;
    const gphys_model_id a = s.add_box(at(0, 0, 0)), b = s.add_box(at(9e14f, 0, 0), a), c = s.add_box(at(1, 1, 1), b);
    const gphys_model_id other = s.add_box(at(-3, 0, 0));
    const Snapshot before(s);
    CHECK(s.move(a, at(9e14f, 0, 0)) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(Snapshot(s) == before);
    const gphys_model_id models[3] = {c, other, a};
    const gphys_transform to[3] = {at(5, 5, 5), at(6, 6, 6), at(9e14f, 0, 0)};
    CHECK(gphys_scene_set_transforms(s.scene, models, to, sizeof *to, 3) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(Snapshot(s) == before);
    CHECK(s.move(a, at(0, 0, 0, 1e15f)) == GPHYS_ERROR_INVALID_ARGUMENT);
    const gphys_model_id small = s.add_box(at(0, 0, 0, 1e-10f));
    const Snapshot with_small(s);
    CHECK(gphys_scene_set_parent(s.scene, small, 0, 1) == GPHYS_OK);
    const gphys_transform tiny = at(0, 0, 0, 1e-10f);
    gphys_model_desc desc;
    gphys_model_desc_init(&desc, sizeof desc);
    desc.parent = small;
    const gphys_sphere sphere{{0, 0, 0}, 1};
    gphys_model_id unused = 77;
    CHECK(gphys_scene_add(s.scene, GPHYS_SHAPE_SPHERE, &sphere, &tiny, &desc, &unused) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(unused == 77);
    CHECK(gphys_scene_set_parent(s.scene, c, small, 0) == GPHYS_OK);
    CHECK(gphys_scene_set_parent(s.scene, b, small, 1) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(s.sound());
}

TEST_CASE("world transforms are the double product of what lies above, rounded once a level") {
    test::Random random(30);
    SceneFixture s;
    std::vector<gphys_model_id> ids;
    for (int i = 0; i < 300; ++i) {
        const gphys_model_id parent = i < 10 ? 0 : ids[random.index(static_cast<uint32_t>(ids.size()))];
        ids.push_back(s.add_sphere(1, {random.point(5), random.rotation(), random.uniform_float(0.7f, 1.4f)}, parent));
    }
    for (int i = 0; i < 100; ++i) {
        REQUIRE(s.move(ids[random.index(300)],
                       {random.point(5), random.rotation(), random.uniform_float(0.7f, 1.4f)}) == GPHYS_OK);
    }
    for (const gphys_model_id id : ids) {
        const gphys_model_id parent = info(s, id).parent;
        const gphys_transform local = s.local(id);
        if (parent == 0) {
            CHECK(same_bits(s.world(id), local));
            continue;
        }
        // A point through both transforms against the product: 2^-24 of the position's and the
        // rotation's rounding, with coordinates that grow with the depth.
        const Vec3 p{0.3, -0.4, 0.5};
        const Vec3 expected = widen(s.world(parent)).apply(widen(local).apply(p));
        const Vec3 found = widen(s.world(id)).apply(p);
        REQUIRE(distance(found, expected) <= 4 * 0x1p-24 * (length(expected) + s.world(id).scale));
    }
    CHECK(s.sound());
}

// --- Coming and going ----------------------------------------------------------------------------

TEST_CASE("a mesh lives as long as a model uses it") {
    test::CountedMemory memory;
    const gphys_allocator hooks = memory.hooks();
    gphys_mesh_desc desc;
    gphys_mesh_desc_init(&desc, sizeof desc);
    desc.allocator = &hooks;
    const float vertices[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const uint32_t indices[3] = {0, 1, 2};
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create(&desc, vertices, 12, 3, indices, 3, &mesh) == GPHYS_OK);
    {
        SceneFixture s;
        const gphys_model_id a = s.add(GPHYS_SHAPE_MESH, mesh, at(0, 0, 5));
        s.add(GPHYS_SHAPE_MESH, mesh, at(0, 0, 6));
        gphys_mesh_destroy(mesh);
        CHECK(s.first_on_ray({0.2f, 0.2f, 0}, {0, 0, 1}) == a);
        REQUIRE(gphys_scene_remove(s.scene, a) == GPHYS_OK);
        CHECK(memory.live_bytes != 0);
    }
    CHECK(memory.live_bytes == 0);
}

TEST_CASE("a mesh without triangles stands in a scene and is never met") {
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create(nullptr, nullptr, 12, 0, nullptr, 0, &mesh) == GPHYS_OK);
    SceneFixture s;
    const gphys_model_id empty = s.add(GPHYS_SHAPE_MESH, mesh, at(1, 2, 3));
    gphys_mesh_destroy(mesh);
    CHECK(s.first_on_ray({1, 2, 0}, {0, 0, 1}) == 0);
    CHECK(s.in_sphere({1, 2, 3}, 1).empty());
    const gphys_vec3 point{1, 2, 3};
    gphys_nearest nearest;
    CHECK(gphys_scene_nearest(s.scene, &point, INFINITY, GPHYS_ALL_LAYERS, &nearest) == GPHYS_NO_HIT);
    gphys_aabb bounds;
    REQUIRE(gphys_scene_get_bounds(s.scene, empty, &bounds) == GPHYS_OK);
    CHECK(bounds.min.y == 2);
    CHECK(s.sound());
}

TEST_CASE("clearing a scene makes all its ids stale, also when the slots are used again") {
    SceneFixture s;
    std::vector<gphys_model_id> old;
    for (int i = 0; i < 50; ++i)
        old.push_back(s.add_box(at(3.f * static_cast<float>(i), 0, 0), i % 2 ? old.back() : 0));
    const gphys_plane floor{{0, 1, 0}, 0};
    old.push_back(s.add(GPHYS_SHAPE_PLANE, &floor, at(0, 0, 0)));
    REQUIRE(gphys_scene_clear(s.scene) == GPHYS_OK);
    CHECK(s.sound());
    CHECK(s.in_sphere({0, 0, 0}, 1e6f).empty());
    for (int round = 0; round < 2; ++round) {
        for (int i = 0; i < 1100; ++i) s.add_box(at(0, 0, 0));
        for (const gphys_model_id id : old) CHECK(gphys_scene_has(s.scene, id) == GPHYS_ERROR_INVALID_ID);
        CHECK(s.sound());
        REQUIRE(gphys_scene_clear(s.scene) == GPHYS_OK);
    }
}

TEST_CASE("a removed model's id names no other for 100 000 additions, one by one or in batches") {
    SceneFixture s;
    for (int i = 0; i < 100; ++i) s.add_box(at(4.f * static_cast<float>(i), 0, 0));
    const uint32_t batch = GENERATE(1u, 7u);
    const gphys_aabb box{{-1, -1, -1}, {1, 1, 1}};
    std::vector<gphys_model_id> first(batch), again(batch);
    const auto add = [&](std::vector<gphys_model_id>& ids) {
        return gphys_scene_add_batch(s.scene, GPHYS_SHAPE_AABB, &box, 0, nullptr, 0, batch, nullptr, ids.data());
    };
    REQUIRE(add(first) == GPHYS_OK);
    REQUIRE(gphys_scene_remove_batch(s.scene, first.data(), batch) == GPHYS_OK);
    bool stale = false, works = true;
    size_t early_bytes = 0;
    for (uint32_t additions = 0; additions < 100000; additions += batch) {
        works &= add(again) == GPHYS_OK;
        for (const gphys_model_id id : first) stale |= gphys_scene_has(s.scene, id) != GPHYS_ERROR_INVALID_ID;
        works &= gphys_scene_remove_batch(s.scene, again.data(), batch) == GPHYS_OK;
        if (additions < 2000) early_bytes = s.memory.live_bytes;
    }
    CHECK(works);
    CHECK_FALSE(stale);
    CHECK(s.memory.live_bytes == early_bytes);
    CHECK(s.sound());
}

TEST_CASE("room that was reserved for models is enough for others in their places") {
    test::CountedMemory memory;
    const gphys_allocator hooks = memory.hooks();
    gphys_scene_desc desc;
    gphys_scene_desc_init(&desc, sizeof desc);
    desc.allocator = &hooks;
    desc.reserve_models = 100;
    gphys_scene* scene = nullptr;
    REQUIRE(gphys_scene_create(&desc, &scene) == GPHYS_OK);
    // Planes are in no octree.
    const gphys_plane floor{{0, 1, 0}, 0};
    gphys_model_id id = 0;
    for (int i = 0; i < 100; ++i) {
        REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &floor, nullptr, nullptr, &id) == GPHYS_OK);
    }
    const size_t bytes = memory.live_bytes;
    for (int i = 0; i < 3000; ++i) {
        REQUIRE(gphys_scene_remove(scene, id) == GPHYS_OK);
        REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &floor, nullptr, nullptr, &id) == GPHYS_OK);
    }
    CHECK(memory.live_bytes == bytes);
    gphys_scene_destroy(scene);
}

TEST_CASE("removing many is all or none, and a model that stands twice is refused") {
    SceneFixture s;
    gphys_model_id ids[4];
    for (gphys_model_id& id : ids) id = s.add_box(at(0, 0, 0));
    const Snapshot before(s);
    const gphys_model_id twice[3] = {ids[0], ids[1], ids[0]};
    CHECK(gphys_scene_remove_batch(s.scene, twice, 3) == GPHYS_ERROR_INVALID_ID);
    const gphys_model_id unknown[3] = {ids[0], ids[1], 12345};
    CHECK(gphys_scene_remove_batch(s.scene, unknown, 3) == GPHYS_ERROR_INVALID_ID);
    CHECK(Snapshot(s) == before);
    CHECK(gphys_scene_remove_batch(s.scene, ids, 4) == GPHYS_OK);
    CHECK(Snapshot(s).ids.empty());
}

TEST_CASE("a batch adds what single calls add") {
    SceneFixture one, many;
    test::Random random(31);
    std::vector<gphys_sphere> spheres(700);
    std::vector<gphys_transform> transforms(700);
    for (int i = 0; i < 700; ++i) {
        spheres[i] = {random.point(1), random.uniform_float(0, 2)};
        transforms[i] = {random.point(30), random.rotation(), random.uniform_float(0.5f, 2)};
    }
    std::vector<gphys_model_id> ids(700);
    REQUIRE(gphys_scene_add_batch(many.scene, GPHYS_SHAPE_SPHERE, spheres.data(), sizeof(gphys_sphere),
                                  transforms.data(), sizeof(gphys_transform), 700, nullptr, ids.data()) == GPHYS_OK);
    for (int i = 0; i < 700; ++i) {
        CHECK(one.add(GPHYS_SHAPE_SPHERE, &spheres[i], transforms[i]) == ids[i]);
        gphys_aabb a, b;
        gphys_scene_get_bounds(one.scene, ids[i], &a);
        gphys_scene_get_bounds(many.scene, ids[i], &b);
        CHECK(std::memcmp(&a, &b, sizeof a) == 0);
    }
    CHECK(Snapshot(one) == Snapshot(many));
}

TEST_CASE("the order in which models were added does not change any set of results") {
    test::Random random(32);
    std::vector<gphys_transform> places(400);
    for (gphys_transform& place : places) place = {random.point(20), random.rotation(), 1};
    SceneFixture forward, backward;
    std::vector<gphys_model_id> ids_forward(400), ids_backward(400);
    for (int i = 0; i < 400; ++i) ids_forward[i] = forward.add_box(places[i]);
    for (int i = 400; i-- > 0;) ids_backward[i] = backward.add_box(places[i]);
    const auto place_of = [](const std::vector<gphys_model_id>& ids, gphys_model_id id) {
        return std::find(ids.begin(), ids.end(), id) - ids.begin();
    };
    for (int i = 0; i < 300; ++i) {
        const gphys_vec3 center = random.point(20);
        std::vector<std::ptrdiff_t> a, b;
        for (const gphys_model_id id : forward.in_sphere(center, 4)) a.push_back(place_of(ids_forward, id));
        for (const gphys_model_id id : backward.in_sphere(center, 4)) b.push_back(place_of(ids_backward, id));
        std::sort(b.begin(), b.end());
        REQUIRE(a == b);
        const gphys_vec3 direction = random.point(1);
        REQUIRE(place_of(ids_forward, forward.first_on_ray(center, direction)) ==
                place_of(ids_backward, backward.first_on_ray(center, direction)));
    }
}

// --- Memory --------------------------------------------------------------------------------------

TEST_CASE("without memory a change is refused as a whole") {
    const auto fails_cleanly = [](auto&& change) {
        for (size_t n = 0;; ++n) {
            SceneFixture s;
            std::vector<gphys_model_id> ids;
            for (int i = 0; i < 30; ++i) ids.push_back(s.add_box(at(3.f * static_cast<float>(i), 0, 0)));
            const gphys_model_id child = s.add_box(at(0, 3, 0), ids[0]);
            ids.push_back(child);
            const Snapshot before(s);
            s.memory.failing = s.memory.allocations + n;
            const gphys_status status = change(s, ids);
            const bool reached = s.memory.allocations > s.memory.failing;
            s.memory.failing = SIZE_MAX;
            if (!reached) return n;
            if (status == GPHYS_OK) {
                // The octree does without an improvement for which there is no memory.
                REQUIRE(s.sound());
                continue;
            }
            REQUIRE(status == GPHYS_ERROR_OUT_OF_MEMORY);
            REQUIRE(Snapshot(s) == before);
            REQUIRE(change(s, ids) == GPHYS_OK);
            REQUIRE(s.sound());
        }
    };
    gphys_model_id out[200];
    const gphys_sphere ball{{0, 0, 0}, 1};
    const gphys_plane floor{{0, 1, 0}, 0};
    const gphys_transform place = at(0, 50, 0);
    const auto add_one = [&](SceneFixture& s, const auto&) {
        return gphys_scene_add(s.scene, GPHYS_SHAPE_SPHERE, &ball, &place, nullptr, out);
    };
    CHECK(fails_cleanly(add_one) > 0);
    CHECK(fails_cleanly([&](SceneFixture& s, const auto&) {
              return gphys_scene_add(s.scene, GPHYS_SHAPE_PLANE, &floor, &place, nullptr, out);
          }) > 0);
    CHECK(fails_cleanly([&](SceneFixture& s, const auto& ids) {
              gphys_model_desc desc;
              gphys_model_desc_init(&desc, sizeof desc);
              desc.parent = ids[3];
              return gphys_scene_add_batch(s.scene, GPHYS_SHAPE_SPHERE, &ball, 0, &place, 0, 200, &desc, out);
          }) > 0);
    CHECK(fails_cleanly([&](SceneFixture& s, const auto& ids) {
              return gphys_scene_set_parent(s.scene, ids[5], ids[6], 1);
          }) > 0);
    // With some number of siblings the store of family records is just full.
    for (size_t siblings = 1; siblings < 8; ++siblings) {
        CHECK(fails_cleanly([&](SceneFixture& s, const auto& ids) {
                  for (size_t i = 1; i <= siblings; ++i) {
                      const gphys_status status = gphys_scene_set_parent(s.scene, ids[i], ids[0], 1);
                      if (status != GPHYS_OK) {
                          for (size_t k = 1; k < i; ++k)
                              REQUIRE(gphys_scene_set_parent(s.scene, ids[k], 0, 1) == GPHYS_OK);
                          return status;
                      }
                  }
                  const gphys_status status = gphys_scene_set_parent(s.scene, ids[1], ids[20], 1);
                  if (status != GPHYS_OK) {
                      for (size_t k = 1; k <= siblings; ++k)
                          REQUIRE(gphys_scene_set_parent(s.scene, ids[k], 0, 1) == GPHYS_OK);
                  }
                  return status;
              }) > 0);
    }
    // Moving needs no memory.
    fails_cleanly([&](SceneFixture& s, const auto& ids) {
        const auto count = static_cast<uint32_t>(ids.size());
        CHECK(gphys_scene_set_transforms(s.scene, ids.data(), &place, 0, count) == GPHYS_OK);
        return GPHYS_OK;
    });
}

TEST_CASE("room that was reserved for models holds them and their octree") {
    gphys_scene_desc desc;
    gphys_scene_desc_init(&desc, sizeof desc);
    desc.reserve_models = 20000;
    gphys_scene* scene = nullptr;
    REQUIRE(gphys_scene_create(&desc, &scene) == GPHYS_OK);
    gphys_octree_stats before, after;
    REQUIRE(gphys_scene_get_octree_stats(scene, &before) == GPHYS_OK);
    CHECK(before.memory_bytes > 0);
    test::Random random(5);
    const gphys_sphere ball{{0, 0, 0}, 1};
    for (uint32_t i = 0; i < desc.reserve_models; ++i) {
        const auto coordinate = [&] { return static_cast<float>(random.uniform(-50, 50)); };
        const gphys_transform place{{coordinate(), coordinate(), coordinate()}, {0, 0, 0, 1}, 1};
        gphys_model_id id = 0;
        REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &place, nullptr, &id) == GPHYS_OK);
    }
    REQUIRE(gphys_scene_get_octree_stats(scene, &after) == GPHYS_OK);
    CHECK(after.memory_bytes == before.memory_bytes);
    gphys_scene_destroy(scene);
}

TEST_CASE("a scene that cannot be created for lack of memory leaves nothing") {
    for (size_t n = 0;; ++n) {
        test::CountedMemory memory;
        const gphys_allocator hooks = memory.hooks();
        memory.failing = n;
        gphys_scene_desc desc;
        gphys_scene_desc_init(&desc, sizeof desc);
        desc.allocator = &hooks;
        desc.reserve_models = 100;
        gphys_scene* scene = nullptr;
        const gphys_status status = gphys_scene_create(&desc, &scene);
        if (status == GPHYS_OK) {
            gphys_scene_destroy(scene);
            CHECK(n > 1);
            CHECK(memory.live_bytes == 0);
            return;
        }
        CHECK(status == GPHYS_ERROR_OUT_OF_MEMORY);
        CHECK(scene == nullptr);
        CHECK(memory.live_bytes == 0);
    }
}

// --- Contact -------------------------------------------------------------------------------------

TEST_CASE("the contact of a point with a model: where, which way and how deep") {
    SceneFixture s;
    const auto contact = [&](gphys_model_id model, Vec3 point, Vec3 where, Vec3 normal, double depth) {
        Vec3 out, n;
        double signed_distance = 0;
        REQUIRE(unwrap(s.scene)->closest_point_model(model, point, out, n, signed_distance));
        CHECK(distance(out, where) < 1e-12);
        CHECK(distance(n, normal) < 1e-12);
        CHECK(std::fabs(signed_distance - depth) < 1e-12);
    };
    const gphys_model_id ball = s.add_sphere(2, at(10, 0, 0));
    contact(ball, {10, 5, 0}, {10, 2, 0}, {0, 1, 0}, 3);
    contact(ball, {10, 0, 0.5}, {10, 0, 2}, {0, 0, 1}, -1.5);
    contact(ball, {10, 0, 0}, {12, 0, 0}, {1, 0, 0}, -2);
    const gphys_model_id box = s.add_box(at(0, 0, 0));
    contact(box, {0, 3, 0}, {0, 1, 0}, {0, 1, 0}, 2);
    contact(box, {0.25, -0.75, 0.5}, {0.25, -1, 0.5}, {0, -1, 0}, -0.25);
    contact(box, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, 0);
    contact(box, {4, 5, 0}, {1, 1, 0}, {0.6, 0.8, 0}, 5);
    const gphys_capsule pill{{0, -1, 0}, {0, 1, 0}, 0.5f};
    const gphys_model_id capsule = s.add(GPHYS_SHAPE_CAPSULE, &pill, at(0, 0, 20));
    contact(capsule, {2, 0.5, 20}, {0.5, 0.5, 20}, {1, 0, 0}, 1.5);
    contact(capsule, {0, 1.25, 20}, {0, 1.5, 20}, {0, 1, 0}, -0.25);
    const gphys_plane floor{{0, 2, 0}, 6};
    const gphys_model_id plane = s.add(GPHYS_SHAPE_PLANE, &floor, at(0, 0, 0));
    contact(plane, {7, 4, 7}, {7, 3, 7}, {0, 1, 0}, 1);
    contact(plane, {7, 1, 7}, {7, 3, 7}, {0, -1, 0}, 2);
    const gphys_triangle corners{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const gphys_model_id triangle = s.add(GPHYS_SHAPE_TRIANGLE, &corners, at(0, 0, 50));
    contact(triangle, {1, 1, 52}, {1, 1, 50}, {0, 0, 1}, 2);
    contact(triangle, {1, 1, 49}, {1, 1, 50}, {0, 0, -1}, 1);
    contact(triangle, {1, 1, 50}, {1, 1, 50}, {0, 0, 1}, 0);
    contact(triangle, {-3, 1, 50}, {0, 1, 50}, {-1, 0, 0}, 3);
    const float vertices[9] = {0, 0, 0, 4, 0, 0, 0, 4, 0};
    const uint32_t indices[3] = {0, 1, 2};
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create(nullptr, vertices, 12, 3, indices, 3, &mesh) == GPHYS_OK);
    const gphys_model_id instance = s.add(GPHYS_SHAPE_MESH, mesh, at(0, 0, 70, 2));
    gphys_mesh_destroy(mesh);
    contact(instance, {1, 1, 73}, {1, 1, 70}, {0, 0, 1}, 3);
    contact(instance, {1, 1, 70}, {1, 1, 70}, {0, 0, 1}, 0);
}
