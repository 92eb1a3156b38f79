// Snapshots of meshes: what is loaded answers with the same bits; what is no snapshot is refused; and words that
// somebody made up are refused or are a mesh that agrees with its triangles.
#include <array>
#include <cstring>
#include <memory>
#include <string>

#include "c_api/handles.h"
#include "mesh/mesh_snapshot.h"
#include "meshes.h"
#include "resources.h"

using namespace gphys;

namespace {

using Words = std::vector<uint32_t>;
using Handle = std::unique_ptr<gphys_mesh, void (*)(gphys_mesh*)>;

Handle handle(gphys_mesh* mesh) { return {mesh, gphys_mesh_destroy}; }

Handle built(const test::Arrays& arrays) {
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create(nullptr, arrays.vertices.empty() ? nullptr : &arrays.vertices[0].x, sizeof(gphys_vec3),
                              static_cast<uint32_t>(arrays.vertices.size()), arrays.indices.data(),
                              static_cast<uint32_t>(arrays.indices.size()), &mesh) == GPHYS_OK);
    return handle(mesh);
}

Words snapshot(const gphys_mesh* mesh) {
    uint32_t total = 0;
    REQUIRE(gphys_mesh_get_snapshot(mesh, nullptr, 0, &total) == GPHYS_INCOMPLETE);
    Words words(total + 1, 0xabababab);
    REQUIRE(gphys_mesh_get_snapshot(mesh, words.data(), total - 1, &total) == GPHYS_INCOMPLETE);
    REQUIRE(words[0] == 0xabababab);
    REQUIRE(gphys_mesh_get_snapshot(mesh, words.data(), total, &total) == GPHYS_OK);
    REQUIRE(words[total] == 0xabababab);
    words.pop_back();
    return words;
}

gphys_status load(const Words& words, Handle& out) {
    gphys_mesh* mesh = nullptr;
    const gphys_status status =
        gphys_mesh_create_from_snapshot(nullptr, words.data(), static_cast<uint32_t>(words.size()), &mesh);
    REQUIRE((status == GPHYS_OK) == (mesh != nullptr));
    out = handle(mesh);
    return status;
}

Handle loaded(const Words& words) {
    Handle mesh = handle(nullptr);
    REQUIRE(load(words, mesh) == GPHYS_OK);
    return mesh;
}

void mend(Words& words) {
    const uint64_t sum = mesh_snapshot_checksum(words.data(), static_cast<uint32_t>(words.size()));
    words[2] = static_cast<uint32_t>(words.size());
    words[3] = static_cast<uint32_t>(sum);
    words[4] = static_cast<uint32_t>(sum >> 32);
}

template <class T>
bool same_bits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Every kind of question, near the mesh: of two meshes of the same triangles the answers have the same bits.
void require_same_answers(const gphys_mesh* a, const gphys_mesh* b, uint64_t seed, int rounds) {
    test::Random random(seed);
    gphys_aabb box{};
    const gphys_status bounded = gphys_shape_bounds(GPHYS_SHAPE_MESH, a, &box);
    gphys_aabb other{};
    REQUIRE(gphys_shape_bounds(GPHYS_SHAPE_MESH, b, &other) == bounded);
    if (bounded == GPHYS_OK) REQUIRE(same_bits(box, other));
    const gphys_vec3 size{box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z};
    const float extent = std::max({size.x, size.y, size.z, 1e-30f});
    const auto point = [&] {
        const auto on = [&](float low, float length) {
            return std::clamp(low + length * random.uniform_float(-0.5f, 1.5f), -1e15f, 1e15f);
        };
        return gphys_vec3{on(box.min.x, size.x), on(box.min.y, size.y), on(box.min.z, size.z)};
    };
    std::vector<gphys_ray> rays(static_cast<size_t>(rounds));
    for (gphys_ray& ray : rays) {
        const gphys_vec3 to = point();
        ray = {point(), {}, 8};
        ray.direction = {(to.x - ray.origin.x) / 2, (to.y - ray.origin.y) / 2, (to.z - ray.origin.z) / 2};
        if (std::max({std::fabs(ray.direction.x), std::fabs(ray.direction.y), std::fabs(ray.direction.z)}) < 1e-30f)
            ray.direction = {0, 1, 0};
    }
    std::vector<gphys_hit> hits[2];
    for (const gphys_mesh* mesh : {a, b}) {
        std::vector<gphys_hit>& out = hits[mesh == b];
        out.resize(rays.size());
        REQUIRE(gphys_shape_raycast_batch(GPHYS_SHAPE_MESH, mesh, rays.data(), sizeof rays[0],
                                          static_cast<uint32_t>(rays.size()), out.data(), sizeof out[0]) == GPHYS_OK);
    }
    for (size_t i = 0; i < rays.size(); ++i) REQUIRE(same_bits(hits[0][i], hits[1][i]));
    for (int i = 0; i < rounds / 4; ++i) {
        const gphys_vec3 at = point(), to = point();
        const gphys_sphere ball{at, extent * random.uniform_float(0, 0.3f)};
        const gphys_vec3 way{to.x - at.x, to.y - at.y, to.z - at.z};
        gphys_hit hit[2]{}, sweep[2]{};
        gphys_nearest near[2]{};
        gphys_status status[2][3];
        std::vector<uint32_t> met[2];
        for (const gphys_mesh* mesh : {a, b}) {
            const int k = mesh == b;
            status[k][0] = gphys_shape_raycast(GPHYS_SHAPE_MESH, mesh, &rays[static_cast<size_t>(i)], &hit[k]);
            status[k][1] = gphys_shape_closest_point(GPHYS_SHAPE_MESH, mesh, &at, &near[k]);
            status[k][2] = gphys_shape_sweep_sphere(GPHYS_SHAPE_MESH, mesh, &ball, &way, &sweep[k]);
            uint32_t total = 0;
            gphys_mesh_overlap(mesh, GPHYS_SHAPE_SPHERE, &ball, nullptr, 0, &total);
            met[k].resize(total);
            REQUIRE(gphys_mesh_overlap(mesh, GPHYS_SHAPE_SPHERE, &ball, met[k].data(), total, &total) == GPHYS_OK);
        }
        REQUIRE(same_bits(status[0], status[1]));
        REQUIRE(same_bits(hit[0], hit[1]));
        REQUIRE(same_bits(near[0], near[1]));
        REQUIRE(same_bits(sweep[0], sweep[1]));
        REQUIRE(met[0] == met[1]);
    }
}

test::Arrays read_arrays(const gphys_mesh* mesh) {
    test::Arrays arrays;
    uint32_t total = 0;
    gphys_mesh_get_vertices(mesh, nullptr, 0, &total);
    arrays.vertices.resize(total);
    REQUIRE(gphys_mesh_get_vertices(mesh, arrays.vertices.data(), total, &total) == GPHYS_OK);
    gphys_mesh_get_indices(mesh, nullptr, 0, &total);
    arrays.indices.resize(total);
    REQUIRE(gphys_mesh_get_indices(mesh, arrays.indices.data(), total, &total) == GPHYS_OK);
    return arrays;
}

struct Sample {
    const char* what;
    test::Arrays arrays;
};

test::Arrays with_vertices_only() {
    test::Arrays arrays;
    arrays.vertices = {{1, 2, 3}, {4, 5, 6}};
    return arrays;
}

test::Arrays coincident(uint32_t count) {
    test::Arrays arrays;
    arrays.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (uint32_t i = 0; i < count; ++i) arrays.add(0, 1, 2);
    return arrays;
}

std::vector<Sample> samples() {
    return {{"nothing", {}},
            {"vertices without triangles", with_vertices_only()},
            {"one triangle", coincident(1)},
            {"eight triangles, one packet", coincident(8)},
            {"triangles that lie on each other", coincident(300)},
            {"a sphere", test::sphere(4)},
            {"a torus far away", test::torus(40, 20).placed({1e6, -1e6, 1e5}, {10, 10, 10})},
            {"a soup", test::soup(700, 5)},
            {"a flat grid", test::grid(20)},
            {"a mesh so small that it is magnified", test::sphere(2).placed({}, {1e-14, 1e-14, 1e-14})},
            {"a mesh of denormal size", test::soup(50, 6).placed({}, {1e-40, 1e-40, 1e-40})},
            {"a mesh as large as the range", test::sphere(2).placed({}, {9e14, 9e14, 9e14})}};
}

}  // namespace

TEST_CASE("a mesh from a snapshot is the same mesh, answers with the same bits and has the same snapshot") {
    for (const Sample& sample : samples()) {
        INFO(sample.what);
        const Handle mesh = built(sample.arrays);
        const Words words = snapshot(mesh.get());
        const Handle copy = loaded(words);
        CHECK(snapshot(copy.get()) == words);
        const test::Arrays arrays = read_arrays(copy.get());
        CHECK(std::equal(arrays.vertices.begin(), arrays.vertices.end(), sample.arrays.vertices.begin(),
                         sample.arrays.vertices.end(), same_bits<gphys_vec3>));
        CHECK(arrays.indices == sample.arrays.indices);
        gphys_mesh_report report[2];
        gphys_octree_stats stats[2];
        for (const int k : {0, 1}) {
            REQUIRE(gphys_mesh_get_report((k ? copy : mesh).get(), &report[k]) == GPHYS_OK);
            REQUIRE(gphys_mesh_get_octree_stats((k ? copy : mesh).get(), &stats[k]) == GPHYS_OK);
            stats[k].memory_bytes = 0;
            stats[k].cost = 0;  // summed in another order
        }
        CHECK(same_bits(report[0], report[1]));
        CHECK(same_bits(stats[0], stats[1]));
        CHECK(unwrap(mesh.get())->hash() == unwrap(copy.get())->hash());
        CHECK(unwrap(copy.get())->bvh().defect() == nullptr);
        require_same_answers(mesh.get(), copy.get(), 3, 200);
    }
}

TEST_CASE("a mesh that has been deformed comes out of its snapshot in its form, and can be deformed on") {
    const test::Arrays before = test::torus(30, 12);
    test::Arrays after = before;
    for (gphys_vec3& v : after.vertices) v = {v.x * 2, v.y + std::sin(3 * v.x), v.z};
    gphys_mesh_desc desc;
    REQUIRE(gphys_mesh_desc_init(&desc, sizeof desc) == GPHYS_OK);
    desc.deformable = 1;
    const auto count = static_cast<uint32_t>(before.vertices.size());
    gphys_mesh* made = nullptr;
    REQUIRE(gphys_mesh_create(&desc, &before.vertices[0].x, 12, count, before.indices.data(),
                              static_cast<uint32_t>(before.indices.size()), &made) == GPHYS_OK);
    const Handle mesh = handle(made);
    for (const test::Arrays& form : {after, before, after}) {
        REQUIRE(gphys_mesh_set_vertices(mesh.get(), &form.vertices[0].x, 12, count) == GPHYS_OK);
    }
    const Words words = snapshot(mesh.get());
    require_same_answers(loaded(words).get(), built(after).get(), 4, 100);
    REQUIRE(gphys_mesh_create_from_snapshot(&desc, words.data(), static_cast<uint32_t>(words.size()), &made) ==
            GPHYS_OK);
    const Handle copy = handle(made);
    CHECK(unwrap(copy.get())->hash() == unwrap(mesh.get())->hash());
    REQUIRE(gphys_mesh_set_vertices(copy.get(), &before.vertices[0].x, 12, count) == GPHYS_OK);
    require_same_answers(copy.get(), built(before).get(), 5, 100);
}

TEST_CASE("what is no snapshot of a mesh is refused") {
    const Words good = snapshot(built(test::sphere(2)).get());
    Handle mesh = handle(nullptr);
    for (size_t at = 0; at < good.size(); ++at) {
        Words words = good;
        words[at] ^= 1u << at % 32;
        REQUIRE(load(words, mesh) == GPHYS_ERROR_INVALID_ARGUMENT);
    }
    for (const size_t count : {size_t{0}, size_t{1}, size_t{4}, size_t{5}, size_t{10}, size_t{11}, good.size() - 1}) {
        Words words(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(count));
        words.reserve(1);
        REQUIRE(load(words, mesh) == GPHYS_ERROR_INVALID_ARGUMENT);
        if (count >= 5) words[2] = static_cast<uint32_t>(count);
        REQUIRE(load(words, mesh) == GPHYS_ERROR_INVALID_ARGUMENT);
    }
    const auto refused_as = [&](size_t at, uint32_t word, const char* why) {
        Words words = good;
        words[at] = word;
        if (at >= 5) mend(words);
        REQUIRE(load(words, mesh) == GPHYS_ERROR_INVALID_ARGUMENT);
        CHECK(std::string(gphys_last_error()) == std::string("gphys_mesh_create_from_snapshot: ") + why);
    };
    refused_as(0, 0x6d687067, "words: the byte order is not that of this machine");
    refused_as(0, 0x6770686e, "words: they are a snapshot of a solver");
    refused_as(0, 0x67706873, "words: they are a snapshot of a scene");
    refused_as(0, 7, "words: they are no snapshot, by their first word");
    refused_as(1, 2, "words: the format is not one that this version of the library reads");
    refused_as(1, 0, "words: the format is not one that this version of the library reads");
    refused_as(2, 7, "count is not the number of words of the snapshot");
    refused_as(3, 7, "words: the checksum is not that of the contents");
    refused_as(8, 0xffffffff, "words: the numbers in the report of the mesh contradict each other");
    const size_t indices = 11, vertices = indices + good[6];
    const size_t order = vertices + size_t{3} * good[5], nodes = order + good[6] / 3;
    refused_as(vertices, 0x7fc00000, "words: a vertex is out of range");
    refused_as(vertices + 1, 0x58635faa, "words: a vertex is out of range");
    refused_as(indices, good[5], "words: an index is out of range");
    refused_as(order, good[order + 1], "words: the order of the triangles is not a permutation");
    refused_as(order, good[6] / 3, "words: the order of the triangles is not a permutation");
    refused_as(good.size() - 1 - good[7], good[good.size() - 1 - good[7]] & 0x7fffffff,
               "words: the order of the triangles is not a permutation");
    refused_as(nodes, 16, "words: the octree of the mesh is not valid");
    refused_as(nodes, 15, "words: the octree of the mesh is not valid");
    refused_as(nodes, (good[nodes] + 1) % 8, "words: the octree of the mesh is not valid");
}

TEST_CASE("a surface with more vertices than any hull is not taken for one") {
    for (const int level : {3, 4}) {
        Words words = snapshot(built(test::sphere(level)).get());
        words.push_back(static_cast<uint32_t>(MeshKind::hull));
        mend(words);
        Handle mesh = handle(nullptr);
        REQUIRE(load(words, mesh) == GPHYS_ERROR_INVALID_ARGUMENT);
        CHECK(std::string(gphys_last_error()) ==
              "gphys_mesh_create_from_snapshot: words: the triangles are not the hull of their vertices");
    }
}

TEST_CASE("a tree as deep as the queries' stacks hold is taken, a deeper one refused") {
    // A chain of nodes with one child each, and a leaf.
    Words words = snapshot(built(test::sphere(0)).get());
    REQUIRE(words[7] == 1);
    const uint32_t leaf = words.back();
    words.pop_back();
    words.insert(words.end(), bvh_max_levels - 1, 0);
    words.push_back(leaf);
    words[7] = bvh_max_levels;
    mend(words);
    const Handle deep = loaded(words);
    require_same_answers(deep.get(), built(test::sphere(0)).get(), 9, 100);
    words.insert(words.end() - 1, 0);
    ++words[7];
    mend(words);
    Handle mesh = handle(nullptr);
    CHECK(load(words, mesh) == GPHYS_ERROR_INVALID_ARGUMENT);
}

namespace {

uint32_t hostile(test::Random& random, const Words& words, size_t at) {
    static const uint32_t values[] = {0,          1,          2,          7,          8,
                                      9,          15,         16,         0x7fffffff, 0x80000000,
                                      0x80000001, 0xffffffff, 0x7fc00000, 0x7f800000, 0xff800000,
                                      0x58635fa9, 0x58635faa, 0x00000001, 0x3f800000};
    constexpr uint32_t kinds = sizeof values / sizeof values[0];
    const uint32_t kind = random.index(kinds + 6);
    if (kind < kinds) return values[kind];
    if (kind == kinds) return words[at] + 1;
    if (kind == kinds + 1) return words[at] - 1;
    if (kind == kinds + 2) return words[at] ^ 0x80000000;
    if (kind == kinds + 3) return words[at] ^ 1u << random.index(32);
    return words[5 + random.index(static_cast<uint32_t>(words.size() - 5))];
}

/// Refused, or a mesh that answers as one built of the same arrays.
bool attack(const Words& words, uint64_t seed) {
    Handle mesh = handle(nullptr);
    const gphys_status status = load(words, mesh);
    REQUIRE((status == GPHYS_OK || status == GPHYS_ERROR_INVALID_ARGUMENT));
    if (status != GPHYS_OK) return false;
    REQUIRE(unwrap(mesh.get())->bvh().defect() == nullptr);
    const Handle expected = built(read_arrays(mesh.get()));
    require_same_answers(mesh.get(), expected.get(), seed, 12);
    loaded(snapshot(mesh.get()));
    return true;
}

}  // namespace

TEST_CASE("made-up words are refused, or are a mesh that agrees with its triangles") {
    test::Random random(17);
    int taken = 0, refused = 0;
    for (const Sample& sample : {samples()[2], samples()[3], samples()[9], Sample{"a small soup", test::soup(40, 3)}}) {
        INFO(sample.what);
        const Words good = snapshot(built(sample.arrays).get());
        for (size_t at = 5; at < good.size(); ++at) {
            for (int i = 0; i < 3; ++i) {
                Words words = good;
                words[at] = hostile(random, good, at);
                mend(words);
                ++(attack(words, at) ? taken : refused);
            }
        }
        for (int i = 0; i < 500; ++i) {
            Words words = good;
            if (random.index(8) == 0) words.resize(11 + random.index(static_cast<uint32_t>(good.size())));
            for (uint32_t k = 1 + random.index(5); k > 0; --k) {
                const size_t at = 5 + random.index(static_cast<uint32_t>(words.size() - 5));
                words[at] = hostile(random, words, at);
            }
            mend(words);
            ++(attack(words, static_cast<uint64_t>(i)) ? taken : refused);
        }
        // Triangles in another order, and nodes of other numbers of children, may be a tree as well.
        for (int i = 0; i < 200 && good[6] > 3; ++i) {
            Words words = good;
            const size_t order = 11 + size_t{3} * good[5] + good[6];
            const uint32_t triangles = good[6] / 3;
            for (int k = 0; k < 5; ++k) {
                std::swap(words[order + random.index(triangles)], words[order + random.index(triangles)]);
            }
            mend(words);
            ++(attack(words, static_cast<uint64_t>(i)) ? taken : refused);
        }
    }
    CHECK(taken > 300);
    CHECK(refused > 300);
}

TEST_CASE("a mesh's snapshot of the first format is read, as by every later release") {
    // Of four triangles at a corner, as release 1.1 wrote it on a little-endian machine.
    const Words words = {0x6770686d, 0x00000001, 0x00000028, 0x27e56b79, 0x0ad1c369, 0x00000004, 0x0000000c,
                         0x00000001, 0x00000000, 0xffffffff, 0x00000000, 0x00000000, 0x00000002, 0x00000001,
                         0x00000000, 0x00000001, 0x00000003, 0x00000000, 0x00000003, 0x00000002, 0x00000001,
                         0x00000002, 0x00000003, 0x00000000, 0x00000000, 0x00000000, 0x3f800000, 0x00000000,
                         0x00000000, 0x00000000, 0x40000000, 0x00000000, 0x00000000, 0x00000000, 0x40400000,
                         0x00000000, 0x00000001, 0x00000002, 0x80000003, 0x00000008};
    const Handle mesh = loaded(words);
    test::Arrays corner;
    corner.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
    for (const auto& t : {std::array<uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
        corner.add(t[0], t[1], t[2]);
    const test::Arrays arrays = read_arrays(mesh.get());
    CHECK(std::equal(arrays.vertices.begin(), arrays.vertices.end(), corner.vertices.begin(), corner.vertices.end(),
                     same_bits<gphys_vec3>));
    CHECK(arrays.indices == corner.indices);
    require_same_answers(mesh.get(), built(corner).get(), 1, 100);
}
