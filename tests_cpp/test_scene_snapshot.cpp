// Snapshots of scenes: what is restored has the same ids and answers with the same bits; with its solver it steps on
// with the same bits; what is no snapshot is refused and changes nothing; made-up words are refused or are a sound
// scene.
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "meshes.h"
#include "scene/scene_snapshot.h"
#include "scene_fixture.h"
#include "snapshots.h"

using test::at;
using test::Random;
using test::SceneFixture;
using test::Words;

namespace {

constexpr uint32_t body = gphys::snapshot_header_words;

template <class T>
bool same_bits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

uint64_t hash(const gphys_scene* scene) {
    uint32_t halves[2];
    REQUIRE(gphys_scene_get_hash(scene, halves) == GPHYS_OK);
    return uint64_t{halves[1]} << 32 | halves[0];
}

Words snapshot(const gphys_scene* scene, int32_t embed_meshes = 1) {
    uint32_t total = 0;
    REQUIRE(gphys_scene_get_snapshot(scene, embed_meshes, nullptr, 0, &total) == GPHYS_INCOMPLETE);
    Words words(total, 0xabababab);
    REQUIRE(gphys_scene_get_snapshot(scene, embed_meshes, words.data(), total - 1, &total) == GPHYS_INCOMPLETE);
    REQUIRE(words[0] == 0xabababab);
    REQUIRE(gphys_scene_get_snapshot(scene, embed_meshes, words.data(), total, &total) == GPHYS_OK);
    REQUIRE(total == words.size());
    return words;
}

gphys_status restore(gphys_scene* scene, const Words& words, const gphys_scene* library = nullptr) {
    return gphys_scene_restore(scene, library, words.data(), static_cast<uint32_t>(words.size()));
}

void mend(Words& words) {
    const uint64_t sum = gphys::scene_snapshot_checksum(words.data(), static_cast<uint32_t>(words.size()));
    words[2] = static_cast<uint32_t>(words.size());
    words[3] = static_cast<uint32_t>(sum);
    words[4] = static_cast<uint32_t>(sum >> 32);
}

gphys_mesh* built(const test::Arrays& arrays) {
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create(nullptr, arrays.vertices.empty() ? nullptr : &arrays.vertices[0].x, 12,
                              static_cast<uint32_t>(arrays.vertices.size()), arrays.indices.data(),
                              static_cast<uint32_t>(arrays.indices.size()), &mesh) == GPHYS_OK);
    return mesh;
}

/// Models of all types, some with parents, some removed; they have moved, and so has the origin.
void fill(SceneFixture& s, uint32_t count, uint64_t seed) {
    Random random(seed);
    gphys_mesh* const meshes[3] = {built(test::sphere(1)), built(test::soup(20, seed)), built({})};
    std::vector<gphys_model_id> ids;
    for (uint32_t i = 0; i < count; ++i) {
        const gphys_vec3 p = random.point(1);
        const float r = random.uniform_float(0.05f, 0.5f);
        const gphys_sphere ball{p, r};
        const gphys_capsule capsule{p, random.point(1), r};
        const gphys_aabb box{{p.x - r, p.y - r, p.z - r}, {p.x + r, p.y + r, p.z + 2 * r}};
        const gphys_obb turned{p, {r, 2 * r, r}, random.rotation()};
        const gphys_plane plane{{0, 1, 0}, -20 - r};
        const gphys_triangle triangle{p, random.point(1), random.point(1)};
        const void* const shapes[] = {&ball, &capsule, &box, &turned, &plane, &triangle};
        gphys_model_desc desc;
        gphys_model_desc_init(&desc, sizeof desc);
        desc.layers = random.index(5) == 0 ? random.index(8) : 1;
        desc.tag = i;
        desc.parent = !ids.empty() && random.index(3) == 0 ? ids[random.index(static_cast<uint32_t>(ids.size()))] : 0;
        const gphys_transform place{random.point(10), random.rotation(), random.uniform_float(0.5f, 1.5f)};
        const uint32_t kind = random.index(7);
        gphys_model_id id = 0;
        REQUIRE(gphys_scene_add(s.scene,
                                static_cast<gphys_shape_type>(kind < 6 ? kind + 1 : uint32_t{GPHYS_SHAPE_MESH}),
                                kind < 6 ? shapes[kind] : meshes[random.index(3)], &place, &desc, &id) == GPHYS_OK);
        ids.push_back(id);
    }
    for (uint32_t i = 0; i < count / 5; ++i) {
        const gphys_transform place{random.point(10), random.rotation(), 1};
        REQUIRE(s.move(ids[random.index(count)], place) == GPHYS_OK);
    }
    for (uint32_t i = 0; i < count / 8; ++i) gphys_scene_remove(s.scene, ids[random.index(count)]);
    const double origin[3] = {1e6 + 0.1, -3, 0.25};
    REQUIRE(gphys_scene_set_origin(s.scene, origin) == GPHYS_OK);
    for (gphys_mesh* mesh : meshes) gphys_mesh_destroy(mesh);
}

/// All that can be asked has the same answers, with the same bits.
void require_same_answers(const gphys_scene* a, const gphys_scene* b, uint64_t seed, int rounds) {
    Random random(seed);
    REQUIRE(gphys_scene_validate(a) == GPHYS_OK);
    REQUIRE(gphys_scene_validate(b) == GPHYS_OK);
    const auto list = [](const gphys_scene* scene) {
        uint32_t total = 0;
        gphys_scene_get_models(scene, nullptr, 0, &total);
        std::vector<gphys_model_id> ids(total);
        REQUIRE(gphys_scene_get_models(scene, ids.data(), total, &total) == GPHYS_OK);
        return ids;
    };
    const std::vector<gphys_model_id> ids = list(a);
    REQUIRE(ids == list(b));
    gphys_aabb box{{-1, -1, -1}, {1, 1, 1}};
    gphys_scene_get_scene_bounds(a, &box);
    for (const gphys_model_id id : ids) {
        gphys_model_info info[2];
        gphys_transform local[2], world[2];
        for (const int k : {0, 1}) {
            const gphys_scene* scene = k ? b : a;
            REQUIRE(gphys_scene_get_info(scene, id, &info[k]) == GPHYS_OK);
            gphys_scene_get_transforms(scene, &id, 1, &local[k], sizeof local[k]);
            gphys_scene_get_world_transforms(scene, &id, 1, &world[k], sizeof world[k]);
        }
        REQUIRE(same_bits(info[0], info[1]));
        REQUIRE(same_bits(local[0], local[1]));
        REQUIRE(same_bits(world[0], world[1]));
    }
    const auto point = [&] {
        return gphys_vec3{random.uniform_float(box.min.x, box.max.x), random.uniform_float(box.min.y, box.max.y),
                          random.uniform_float(box.min.z, box.max.z)};
    };
    for (int i = 0; i < rounds; ++i) {
        const gphys_vec3 from = point(), to = point();
        const gphys_ray ray{from, {to.x - from.x, to.y - from.y, to.z - from.z}, 2};
        if (std::max({std::fabs(ray.direction.x), std::fabs(ray.direction.y), std::fabs(ray.direction.z)}) < 1e-30f)
            continue;
        const gphys_sphere ball{to, 2};
        gphys_hit hit[2]{};
        gphys_nearest near[2]{};
        gphys_status status[2][2];
        std::vector<gphys_model_id> met[2];
        for (const int k : {0, 1}) {
            const gphys_scene* scene = k ? b : a;
            status[k][0] = gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit[k]);
            status[k][1] = gphys_scene_nearest(scene, &from, INFINITY, GPHYS_ALL_LAYERS, &near[k]);
            uint32_t total = 0;
            gphys_scene_overlap(scene, GPHYS_SHAPE_SPHERE, &ball, 1, nullptr, 0, &total);
            met[k].resize(total);
            gphys_scene_overlap(scene, GPHYS_SHAPE_SPHERE, &ball, 1, met[k].data(), total, &total);
        }
        REQUIRE(same_bits(status[0], status[1]));
        REQUIRE(same_bits(hit[0], hit[1]));
        REQUIRE(same_bits(near[0], near[1]));
        REQUIRE(met[0] == met[1]);
    }
}

/// The same changes of both, which then have the same ids and answers.
void require_same_future(SceneFixture& a, SceneFixture& b, uint64_t seed) {
    for (SceneFixture* s : {&a, &b}) {
        Random random(seed);
        std::vector<gphys_model_id> ids(2000);
        uint32_t total = 0;
        REQUIRE(gphys_scene_get_models(s->scene, ids.data(), 2000, &total) == GPHYS_OK);
        ids.resize(total);
        for (int i = 0; i < 20 && !ids.empty(); ++i) {
            const gphys_model_id one = ids[random.index(total)], other = ids[random.index(total)];
            gphys_scene_set_parent(s->scene, one, random.index(2) ? other : 0, static_cast<int32_t>(random.index(2)));
            s->move(other, {random.point(10), random.rotation(), 1});
        }
        const double origin[3] = {1e6, 5, -0.125};
        REQUIRE(gphys_scene_set_origin(s->scene, origin) == GPHYS_OK);
        for (int i = 0; i < 10 && !ids.empty(); ++i) gphys_scene_remove(s->scene, ids[random.index(total)]);
        for (int i = 0; i < 1100; ++i) s->add_sphere(0.1f, {random.point(10), test::no_rotation, 1});
    }
    REQUIRE(hash(a.scene) == hash(b.scene));
    require_same_answers(a.scene, b.scene, seed, 50);
}

}  // namespace

TEST_CASE("a restored scene has the ids, answers, hash and future of the one that the snapshot was taken of") {
    for (const uint32_t count : {0u, 1u, 7u, 300u}) {
        for (const int32_t embedded : {0, 1}) {
            SceneFixture a, b;
            fill(a, count, 4 + count);
            b.add_box(at(1, 2, 3));
            const Words words = snapshot(a.scene, embedded);
            REQUIRE(restore(b.scene, words, a.scene) == GPHYS_OK);
            CHECK(hash(b.scene) == hash(a.scene));
            CHECK(snapshot(b.scene, embedded) == words);
            require_same_answers(a.scene, b.scene, 1, 200);
            require_same_future(a, b, 8);
        }
    }
}

TEST_CASE("a scene's hash is that of its state, not of how it came about") {
    SceneFixture a, b;
    fill(a, 100, 3);
    fill(b, 100, 3);
    CHECK(hash(a.scene) == hash(b.scene));
    const gphys_model_id id = a.add_box(at(1, 2, 3));
    CHECK(hash(a.scene) != hash(b.scene));
    REQUIRE(b.add_box(at(1, 2, 4)) == id);
    CHECK(hash(a.scene) != hash(b.scene));
    REQUIRE(b.move(id, at(1, 2, 3)) == GPHYS_OK);
    CHECK(hash(a.scene) == hash(b.scene));
    for (const int what : {0, 1, 2, 3}) {
        const uint64_t before = hash(a.scene);
        const gphys_sphere ball{{0, 0, 0}, 1};
        if (what == 0) REQUIRE(gphys_scene_set_layers(a.scene, id, 2) == GPHYS_OK);
        if (what == 1) REQUIRE(gphys_scene_set_tag(a.scene, id, 99) == GPHYS_OK);
        if (what == 2) REQUIRE(gphys_scene_set_shape(a.scene, id, GPHYS_SHAPE_SPHERE, &ball) == GPHYS_OK);
        if (what == 3) REQUIRE(gphys_scene_remove(a.scene, id) == GPHYS_OK);
        CHECK(hash(a.scene) != before);
    }
}

TEST_CASE("a scene rolls back to an earlier frame, with meshes that it still uses") {
    SceneFixture s, twin;
    fill(s, 200, 12);
    fill(twin, 200, 12);
    const Words frame = snapshot(s.scene, 0);
    const uint64_t then = hash(s.scene);
    for (int round = 0; round < 3; ++round) {
        require_same_future(s, s, 30 + static_cast<uint64_t>(round));
        REQUIRE(hash(s.scene) != then);
        REQUIRE(restore(s.scene, frame) == GPHYS_OK);
        REQUIRE(hash(s.scene) == then);
    }
    require_same_answers(s.scene, twin.scene, 5, 100);
}

TEST_CASE("meshes that are not embedded are found in a library, or the scene is refused and kept") {
    SceneFixture a, b, library;
    gphys_mesh* mesh = built(test::sphere(2));
    a.add(GPHYS_SHAPE_MESH, mesh, at(1, 0, 0));
    a.add(GPHYS_SHAPE_MESH, mesh, at(4, 0, 0));
    b.add_box(at(9, 9, 9));
    const uint64_t before = hash(b.scene);
    const Words words = snapshot(a.scene, 0);
    CHECK(restore(b.scene, words) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(restore(b.scene, words, library.scene) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(hash(b.scene) == before);
    gphys_mesh* same = built(test::sphere(2));
    gphys_mesh* other = built(test::sphere(1));
    library.add(GPHYS_SHAPE_MESH, other, at(0, 0, 0));
    CHECK(restore(b.scene, words, library.scene) == GPHYS_ERROR_INVALID_ARGUMENT);
    library.add(GPHYS_SHAPE_MESH, same, at(0, 0, 0));
    CHECK(restore(b.scene, words, library.scene) == GPHYS_OK);
    CHECK(hash(b.scene) == hash(a.scene));
    // Each mesh is in a snapshot once, and a scene of which it is all keeps them alive.
    for (gphys_mesh* each : {mesh, same, other}) gphys_mesh_destroy(each);
    const Words complete = snapshot(a.scene, 1);
    CHECK(complete.size() < 2 * 128 * 7);
    REQUIRE(gphys_scene_clear(a.scene) == GPHYS_OK);
    SceneFixture c;
    REQUIRE(restore(c.scene, complete) == GPHYS_OK);
    require_same_answers(b.scene, c.scene, 2, 100);
}

TEST_CASE("a scene and its solver, restored together, step on with the same bits") {
    test::World world;
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    gphys_mesh* mesh = built(test::sphere(2));
    const gphys_model_id ball = world.model(GPHYS_SHAPE_MESH, mesh);
    gphys_mesh_destroy(mesh);
    const gphys_body_id cloth = world.cloth({-1, 1.2f, -1}, {2, 0, 0}, {0, 0, 2}, 12, 12);
    world.cloth({-1, 3, -1}, {2, 0, 0}, {0, 0, 2}, 5, 5);
    REQUIRE(gphys_solver_attach(world.solver, world.scene, cloth, 0, ball, nullptr) == GPHYS_OK);
    const auto frame = [](test::World& w, gphys_model_id moving, int i) {
        const gphys_transform place = at(0.01f * static_cast<float>(i), 0, 0);
        REQUIRE(gphys_scene_set_transform(w.scene, moving, &place) == GPHYS_OK);
        w.step(1.0f / 60);
    };
    for (int i = 0; i < 20; ++i) frame(world, ball, i);
    const Words scene = snapshot(world.scene, 1), solver = test::snapshot(world.solver);
    test::World other;
    REQUIRE(restore(other.scene, scene) == GPHYS_OK);
    REQUIRE(test::restore(other.solver, solver) == GPHYS_OK);
    for (int i = 20; i < 60; ++i) {
        frame(world, ball, i);
        frame(other, ball, i);
        REQUIRE(test::hash(world.solver) == test::hash(other.solver));
        REQUIRE(hash(world.scene) == hash(other.scene));
    }
}

TEST_CASE("what is no snapshot of a scene is refused and changes nothing") {
    SceneFixture a, b;
    fill(a, 30, 9);
    b.add_box(at(1, 2, 3));
    const uint64_t before = hash(b.scene);
    const Words good = snapshot(a.scene, 1);
    for (size_t i = 0; i < good.size(); ++i) {
        Words words = good;
        words[i] ^= 1u << i % 32;
        REQUIRE(restore(b.scene, words) == GPHYS_ERROR_INVALID_ARGUMENT);
    }
    for (size_t count = 0; count < good.size(); count += 1 + count / 10) {
        Words words(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(count));
        words.reserve(1);
        REQUIRE(restore(b.scene, words) == GPHYS_ERROR_INVALID_ARGUMENT);
        if (count < body) continue;
        mend(words);
        REQUIRE(restore(b.scene, words) == GPHYS_ERROR_INVALID_ARGUMENT);
    }
    const std::pair<uint32_t, const char*> others[] = {
        {gphys::mesh_snapshot_magic, "words: they are a snapshot of a mesh"},
        {gphys::solver_snapshot_magic, "words: they are a snapshot of a solver"},
        {7, "words: they are no snapshot, by their first word"}};
    for (const auto& [first, why] : others) {
        Words words = good;
        words[0] = first;
        REQUIRE(restore(b.scene, words) == GPHYS_ERROR_INVALID_ARGUMENT);
        CHECK(std::string(gphys_last_error()) == std::string("gphys_scene_restore: ") + why);
    }
    CHECK(hash(b.scene) == before);
    CHECK(b.sound());
    REQUIRE(restore(b.scene, good) == GPHYS_OK);
    CHECK(hash(b.scene) == hash(a.scene));
}

TEST_CASE("running out of memory while a scene is restored leaves it as it was") {
    SceneFixture a, b;
    fill(a, 40, 2);
    b.add_box(at(1, 2, 3));
    const uint64_t before = hash(b.scene);
    const Words words = snapshot(a.scene, 1);
    size_t failures = 0;
    for (size_t failing = 0;; ++failing) {
        b.memory.failing = b.memory.allocations + failing;
        const gphys_status status = restore(b.scene, words);
        b.memory.failing = SIZE_MAX;
        if (status == GPHYS_OK) break;
        REQUIRE(status == GPHYS_ERROR_OUT_OF_MEMORY);
        REQUIRE(hash(b.scene) == before);
        REQUIRE(b.sound());
        ++failures;
    }
    CHECK(failures > 10);
    CHECK(hash(b.scene) == hash(a.scene));
}

namespace {

uint32_t hostile(Random& random, const Words& words, size_t where) {
    static const uint32_t values[] = {0,          1,          2,          5,          8,          9,
                                      16,         0xffffff,   0x1000000,  0x2000000,  0x7fffffff, 0x80000000,
                                      0xffffffff, 0x7fc00000, 0x7f800000, 0xff800000, 0x58635fa9, 0x58635faa,
                                      0x00000001, 0x3f800000, 0xbf800000, 0x26901d7d, 0x7ff80000};
    constexpr uint32_t kinds = sizeof values / sizeof values[0];
    const uint32_t kind = random.index(kinds + 6);
    if (kind < kinds) return values[kind];
    if (kind == kinds) return words[where] + 1;
    if (kind == kinds + 1) return words[where] - 1;
    if (kind == kinds + 2) return words[where] ^ 1u << random.index(32);
    if (kind == kinds + 3) return words[std::min(where + 1, words.size() - 1)];
    if (kind == kinds + 4) return static_cast<uint32_t>(random.engine());
    return words[body + random.index(static_cast<uint32_t>(words.size() - body))];
}

/// Refused, which changes nothing, or a sound scene: asked, changed, and copied out again.
bool attack(SceneFixture& s, const Words& words, uint64_t seed) {
    const uint64_t before = hash(s.scene);
    const gphys_status status = restore(s.scene, words);
    REQUIRE((status == GPHYS_OK || status == GPHYS_ERROR_INVALID_ARGUMENT));
    if (status != GPHYS_OK) {
        REQUIRE(hash(s.scene) == before);
        return false;
    }
    REQUIRE(s.sound());
    SceneFixture copy;
    REQUIRE(restore(copy.scene, snapshot(s.scene, 1)) == GPHYS_OK);
    require_same_answers(s.scene, copy.scene, seed, 5);
    gphys_model_id ids[3];
    uint32_t total = 0;
    gphys_scene_get_models(s.scene, ids, 3, &total);
    const double origin[3] = {};
    gphys_scene_set_origin(s.scene, origin);
    for (uint32_t i = 0; i < std::min(total, 3u); ++i) {
        gphys_scene_set_parent(s.scene, ids[i], ids[0], 1);
        REQUIRE(gphys_scene_remove(s.scene, ids[i]) == GPHYS_OK);
    }
    const gphys_model_id added = s.add_sphere(1, at(0, 0, 0));
    for (const gphys_model_id id : ids) REQUIRE(id != added);
    REQUIRE(s.sound());
    return true;
}

}  // namespace

TEST_CASE("made-up words are refused, or are a scene like any other") {
    Random random(21);
    int taken = 0, refused = 0;
    for (const uint32_t models : {3u, 25u}) {
        SceneFixture a, b;
        fill(a, models, 40 + models);
        const Words good = snapshot(a.scene, 1);
        for (size_t where = body; where < good.size(); ++where) {
            for (int i = 0; i < 2; ++i) {
                Words words = good;
                words[where] = hostile(random, good, where);
                mend(words);
                ++(attack(b, words, where) ? taken : refused);
            }
        }
        for (int i = 0; i < 1500; ++i) {
            Words words = good;
            if (random.index(10) == 0) words.resize(body + random.index(static_cast<uint32_t>(good.size())));
            for (uint32_t k = 1 + random.index(5); k > 0 && words.size() > body; --k) {
                // The embedded meshes, which have checksums of their own, are most of the words.
                const uint32_t most = std::min(static_cast<uint32_t>(words.size() - body), models * 30);
                const size_t where = body + random.index(most);
                words[where] = hostile(random, words, where);
            }
            mend(words);
            ++(attack(b, words, static_cast<uint64_t>(i)) ? taken : refused);
        }
    }
    CHECK(taken > 300);
    CHECK(refused > 300);
}

TEST_CASE("a scene's snapshot of the first format is read, as by every later release") {
    // As release 1.1 wrote it on a little-endian machine: what make() makes.
    const Words words = {
        0x67706873, 0x00000001, 0x0000009f, 0xb82818d8, 0xd70e397d, 0x00000001, 0x00000001, 0x00000003, 0x0000003e,
        0x00000000, 0xf376db5b, 0x3a78279e, 0x00000006, 0x00000018, 0x0000003e, 0x00000000, 0x00000000, 0x00000000,
        0x00000000, 0x00000000, 0x00000000, 0x00000004, 0x01000000, 0x01000001, 0x01000002, 0x01000003, 0x00000004,
        0x00000000, 0x00ffffff, 0x00ffffff, 0x00000003, 0x00000001, 0x00000000, 0xffffffff, 0x3f800000, 0x40000000,
        0x40400000, 0x00000000, 0x00000000, 0x00000000, 0x3f800000, 0x40000000, 0xbf800000, 0xbf800000, 0xbf800000,
        0x3f800000, 0x3f800000, 0x3f800000, 0x00000001, 0x00000001, 0x00000000, 0x00000000, 0x00000000, 0x3f800000,
        0x00000000, 0x00000000, 0x00000000, 0x00000000, 0x3f800000, 0x3f800000, 0x00000000, 0x00000000, 0x00000000,
        0x3f000000, 0x00000005, 0x00000001, 0x00000000, 0xffffffff, 0x00000000, 0x00000000, 0x00000000, 0x00000000,
        0x00000000, 0x00000000, 0x3f800000, 0x3f800000, 0x00000000, 0x3f800000, 0x00000000, 0xbf800000, 0x00000008,
        0x00000001, 0x00000000, 0xffffffff, 0xc0400000, 0x00000000, 0x00000000, 0x00000000, 0x00000000, 0x00000000,
        0x3f800000, 0x3f800000, 0x00000000, 0x0000000a, 0x00000000, 0x00000001, 0x00000003, 0x6770686d, 0x00000001,
        0x0000003e, 0x04ded3be, 0xd855099f, 0x00000006, 0x00000018, 0x00000001, 0x00000000, 0xffffffff, 0x00000000,
        0x00000000, 0x00000002, 0x00000004, 0x00000002, 0x00000000, 0x00000005, 0x00000003, 0x00000000, 0x00000004,
        0x00000000, 0x00000003, 0x00000005, 0x00000002, 0x00000001, 0x00000004, 0x00000001, 0x00000002, 0x00000005,
        0x00000001, 0x00000003, 0x00000004, 0x00000003, 0x00000001, 0x00000005, 0x3f800000, 0x00000000, 0x00000000,
        0xbf800000, 0x00000000, 0x00000000, 0x00000000, 0x3f800000, 0x00000000, 0x00000000, 0xbf800000, 0x00000000,
        0x00000000, 0x00000000, 0x3f800000, 0x00000000, 0x00000000, 0xbf800000, 0x00000000, 0x00000001, 0x00000002,
        0x00000003, 0x00000004, 0x00000005, 0x00000006, 0x80000007, 0x00000008};
    SceneFixture expected, restored;
    const gphys_sphere ball{{0, 0, 0}, 0.5f};
    const gphys_plane floor{{0, 1, 0}, -1};
    gphys_mesh* mesh = built(test::sphere(0));
    const gphys_model_id parent = expected.add_box(at(1, 2, 3, 2));
    expected.add(GPHYS_SHAPE_SPHERE, &ball, at(0, 1, 0), parent);
    expected.add(GPHYS_SHAPE_PLANE, &floor, at(0, 0, 0));
    expected.add(GPHYS_SHAPE_MESH, mesh, at(-3, 0, 0));
    gphys_mesh_destroy(mesh);
    REQUIRE(restore(restored.scene, words) == GPHYS_OK);
    CHECK(hash(restored.scene) == hash(expected.scene));
    require_same_answers(expected.scene, restored.scene, 6, 100);
}
