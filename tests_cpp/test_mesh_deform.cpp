// Meshes that take other vertices: beside meshes that are made of them, in scenes, and when something fails.
#include <cstring>
#include <memory>

#include "meshes.h"
#include "scene/scene.h"

using namespace gphys;

namespace {

struct Release {
    void operator()(Mesh* mesh) const { Mesh::release(mesh); }
};
using MeshPtr = std::unique_ptr<Mesh, Release>;

MeshPtr made(const test::Arrays& arrays, bool deformable, const gphys_allocator* hooks = nullptr) {
    Memory memory(hooks);
    return MeshPtr(create<Mesh>(hooks, arrays.view(), examine(arrays.view(), &memory), chosen_isa(), deformable));
}

/// A tube of quads along x, bent to an arc and pinched, as skin around a joint.
test::Arrays tube(int rings, int around) {
    test::Arrays arrays;
    for (int i = 0; i < rings; ++i) {
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * pi * k / around;
            arrays.vertices.push_back(narrow(Vec3{4.0 * i / rings, std::cos(angle) / 4, std::sin(angle) / 4}));
        }
    }
    const auto at = [&](int i, int k) { return static_cast<uint32_t>(i * around + k % around); };
    for (int i = 0; i + 1 < rings; ++i) {
        for (int k = 0; k < around; ++k) {
            arrays.add(at(i, k), at(i + 1, k), at(i, k + 1));
            arrays.add(at(i, k + 1), at(i + 1, k), at(i + 1, k + 1));
        }
    }
    return arrays;
}

/// By up to `angle` at the end of four metres.
test::Arrays bent(const test::Arrays& straight, double angle) {
    test::Arrays arrays = straight;
    for (gphys_vec3& v : arrays.vertices) {
        const double turn = angle * v.x / 4, radius = angle == 0 ? 0 : 4 / angle;
        const double x = angle == 0 ? v.x : (radius - v.y) * std::sin(turn);
        const double y = angle == 0 ? v.y : radius - (radius - v.y) * std::cos(turn);
        v = narrow(Vec3{x, y, v.z * (1 + 0.3 * std::sin(turn))});
    }
    return arrays;
}

bool same(const Hit& a, const Hit& b) {
    return a.t == b.t && a.triangle == b.triangle && a.point == b.point && a.normal == b.normal;
}

/// All questions, with the same bits.
void require_same(const Mesh& a, const Mesh& b, test::Random& random, int questions) {
    REQUIRE(a.bounds() == b.bounds());
    REQUIRE(a.hash() == b.hash());
    REQUIRE((a.center() == b.center() && a.radius() == b.radius()));
    const gphys_mesh_report one = a.report(), other = b.report();
    REQUIRE(std::memcmp(&one, &other, sizeof one) == 0);
    const double size = std::max(a.radius(), 1e-30);
    const auto point = [&] { return widen(narrow(a.center() + random.direction() * (size * random.uniform(0, 1.5)))); };
    int met = 0;
    for (int i = 0; i < questions; ++i) {
        const Vec3 from = point(), to = point();
        const Ray ray{from, to - from, i % 3 == 0 ? 1 : infinity};
        Hit mine, theirs;
        const bool hits = a.raycast(ray, mine);
        REQUIRE(hits == b.raycast(ray, theirs));
        met += hits;
        if (hits) REQUIRE(same(mine, theirs));
        REQUIRE(a.raycast_any(ray) == hits);
        const gphys_ray floats{narrow(ray.origin), narrow(ray.direction), static_cast<float>(ray.t_max)};
        const gphys_ray* const rays[] = {&floats};
        gphys_hit mine_many{}, theirs_many{};
        gphys_hit* const out_mine[] = {&mine_many};
        gphys_hit* const out_theirs[] = {&theirs_many};
        REQUIRE(a.raycast_many(rays, 1, out_mine) == b.raycast_many(rays, 1, out_theirs));
        REQUIRE(std::memcmp(&mine_many, &theirs_many, sizeof mine_many) == 0);
        uint32_t near = 0, other_near = 0;
        Vec3 closest, other_closest;
        REQUIRE(a.closest_point(from, size, closest, near) == b.closest_point(from, size, other_closest, other_near));
        REQUIRE((near == other_near && closest == other_closest));
        const Sphere ball{from, size * random.uniform(0, 0.1)};
        const bool swept = a.sweep(ball, to - from, mine);
        REQUIRE(swept == b.sweep(ball, to - from, theirs));
        if (swept) REQUIRE(same(mine, theirs));
        std::vector<uint32_t> touched, other_touched;
        const auto list = [](std::vector<uint32_t>& all) {
            return [&all](uint32_t triangle) {
                all.push_back(triangle);
                return true;
            };
        };
        a.for_each_overlap(ball, list(touched));
        b.for_each_overlap(ball, list(other_touched));
        std::sort(touched.begin(), touched.end());
        std::sort(other_touched.begin(), other_touched.end());
        REQUIRE(touched == other_touched);
    }
    REQUIRE((met > 0 || a.triangle_count() < 100));
}

}  // namespace

TEST_CASE("a mesh that was deformed answers as one made of the same vertices") {
    test::Random random(71);
    const test::Arrays straight = tube(60, 24);
    const MeshPtr mesh = made(straight, true);
    for (int frame = 0; frame < 60; ++frame) {
        const test::Arrays now = bent(straight, 3 * std::sin(0.4 * frame));
        REQUIRE(mesh->set_vertices(now.view()) == nullptr);
        REQUIRE(mesh->bvh().defect() == nullptr);
        const MeshPtr fresh = made(now, false);
        require_same(*mesh, *fresh, random, 40);
    }
}

TEST_CASE("whatever becomes of the vertices, a deformed mesh answers as a new one") {
    test::Random random(72);
    for (int round = 0; round < 12; ++round) {
        const test::Arrays start = round % 2 ? test::sphere(3) : tube(20, 12);
        const MeshPtr mesh = made(start, true);
        for (int step = 0; step < 12; ++step) {
            test::Arrays now = start;
            // Scattered, drawn together to a point, flat, tiny (magnified inside), far away.
            const int kind = static_cast<int>(random.index(6));
            const double scale = kind == 3 ? 1e-20 : kind == 4 ? 1e-12 : 1;
            for (gphys_vec3& v : now.vertices) {
                const Vec3 at = kind == 0 ? random.direction() * random.uniform(0, 5) : widen(v);
                v = narrow(at * scale + (kind == 5 ? Vec3{1e6, -1e6, 3e5} : Vec3{}));
                if (kind == 1) v = {1, 2, 3};
                if (kind == 2) v.y = 0.5f;
            }
            REQUIRE(mesh->set_vertices(now.view()) == nullptr);
            REQUIRE(mesh->bvh().defect() == nullptr);
            const MeshPtr fresh = made(now, false);
            if (kind != 1) require_same(*mesh, *fresh, random, 25);
            REQUIRE(std::memcmp(mesh->vertices().data(), now.vertices.data(),
                                now.vertices.size() * sizeof(gphys_vec3)) == 0);
        }
    }
}

TEST_CASE("scenes follow a mesh that deforms: all its models, in every scene") {
    test::Random random(73);
    const test::Arrays straight = tube(30, 12);
    MeshPtr mesh = made(straight, true);
    const MeshPtr rigid = made(straight, false);
    Scene scenes[2] = {Scene(nullptr), Scene(nullptr)};
    gphys_model_desc desc{};
    desc.scale = {1, 1, 1};
    desc.layers = 1;
    std::vector<gphys_model_id> models[2];
    std::vector<gphys_transform> places[2];
    for (int s = 0; s < 2; ++s) {
        for (int i = 0; i < 40; ++i) {
            const gphys_transform place{narrow(random.direction() * 20.0),
                                        narrow(normalized(Quat{random.uniform(-1, 1), random.uniform(-1, 1), 0, 1})),
                                        random.uniform_float(0.5f, 2)};
            gphys_model_id model = 0;
            const Mesh* const used = i % 3 == 0 ? rigid.get() : mesh.get();
            REQUIRE(scenes[s].add(GPHYS_SHAPE_MESH, used, 0, &place, 0, 1, desc, &model) == GPHYS_OK);
            models[s].push_back(model);
            places[s].push_back(place);
        }
    }
    for (int frame = 0; frame < 30; ++frame) {
        // Some come and go, or change to and from the mesh.
        for (int s = 0; s < 2; ++s) {
            const size_t i = random.index(40);
            if (random.index(2)) {
                const void* const used = random.index(2) ? rigid.get() : mesh.get();
                REQUIRE(scenes[s].set_shape(models[s][i], GPHYS_SHAPE_MESH, used) == GPHYS_OK);
            } else {
                REQUIRE(scenes[s].remove(&models[s][i], 1) == GPHYS_OK);
                REQUIRE(scenes[s].add(GPHYS_SHAPE_MESH, mesh.get(), 0, &places[s][i], 0, 1, desc, &models[s][i]) ==
                        GPHYS_OK);
            }
        }
        const test::Arrays now = bent(straight, 2.5 * std::sin(0.5 * frame));
        REQUIRE(mesh->set_vertices(now.view()) == nullptr);
        const MeshPtr fresh = made(now, false);
        for (int s = 0; s < 2; ++s) {
            REQUIRE(scenes[s].defect() == nullptr);
            Scene again(nullptr);
            for (size_t i = 0; i < 40; ++i) {
                const bool deforms = scenes[s].mesh(models[s][i]) == mesh.get();
                gphys_model_id model = 0;
                REQUIRE(again.add(GPHYS_SHAPE_MESH, deforms ? fresh.get() : rigid.get(), 0, &places[s][i], 0, 1, desc,
                                  &model) == GPHYS_OK);
            }
            for (int i = 0; i < 100; ++i) {
                const Vec3 from = random.direction() * 30.0, to = random.direction() * 20.0;
                gphys_hit hit{}, expected{};
                const gphys_status status = scenes[s].raycast(Ray{from, to - from, infinity}, 1, hit);
                REQUIRE(status == again.raycast(Ray{from, to - from, infinity}, 1, expected));
                REQUIRE((status != GPHYS_OK || (hit.t == expected.t && hit.triangle == expected.triangle)));
            }
        }
    }
    // A scene may outlive the caller's mesh.
    mesh.reset();
    REQUIRE(scenes[0].defect() == nullptr);
    scenes[0].clear();
}

TEST_CASE("a form that a model cannot have is refused, and nothing changes") {
    const test::Arrays ball = test::sphere(2);
    const MeshPtr mesh = made(ball, true);
    Scene scene(nullptr);
    gphys_model_desc desc{};
    desc.scale = {1, 1, 1};
    desc.layers = 1;
    gphys_model_id models[2];
    const gphys_transform places[2] = {{{0, 0, 0}, {0, 0, 0, 1}, 1}, {{9, 0, 0}, {0, 0, 0, 1}, 1e9f}};
    REQUIRE(scene.add(GPHYS_SHAPE_MESH, mesh.get(), 0, places, sizeof places[0], 2, desc, models) == GPHYS_OK);
    const uint64_t hash = mesh->hash();
    const gphys_sphere before = mesh->ball();
    const test::Arrays large = ball.placed({0, 0, 0}, {1e12, 1e12, 1e12});
    REQUIRE(mesh->set_vertices(large.view()) != nullptr);
    REQUIRE(mesh->hash() == hash);
    REQUIRE(mesh->ball().radius == before.radius);
    REQUIRE(scene.defect() == nullptr);
    test::Random random(74);
    require_same(*mesh, *made(ball, false), random, 50);
    REQUIRE(scene.remove(&models[1], 1) == GPHYS_OK);
    REQUIRE(mesh->set_vertices(large.view()) == nullptr);
    REQUIRE(scene.defect() == nullptr);
    Box box;
    REQUIRE(scene.bounds(models[0], box));
    REQUIRE(box.max[0] >= 1e12f);
}

TEST_CASE("a tree that was deformed a thousand times costs rays little more than a new one") {
    // Boxes of a tree's nodes, as rays meet them: the areas, of those against the area of the root.
    const auto cost = [](const Mesh& mesh) {
        double area = 0;
        mesh.for_each_box([&](const gphys_octree_box& box) {
            const Vec3 extent = widen(box.bounds.max) - widen(box.bounds.min);
            area += extent.x * extent.y + extent.y * extent.z + extent.z * extent.x;
        });
        return area;
    };
    const test::Arrays straight = tube(120, 32);
    const MeshPtr mesh = made(straight, true);
    test::Arrays now = straight;
    for (int frame = 1; frame <= 1000; ++frame) {
        now = bent(straight, 3 * std::sin(0.05 * frame));
        REQUIRE(mesh->set_vertices(now.view()) == nullptr);
    }
    const double ratio = cost(*mesh) / cost(*made(now, false));
    INFO("areas after a thousand frames, of a new tree's: " << ratio);
    CHECK(ratio < 1.5);
    // Torn apart: packets are cut anew.
    test::Random random(75);
    for (gphys_vec3& v : now.vertices) v = narrow(random.direction() * random.uniform(0, 2));
    REQUIRE(mesh->set_vertices(now.view()) == nullptr);
    const double torn = cost(*mesh) / cost(*made(now, false));
    INFO("areas when torn apart, of a new tree's: " << torn);
    CHECK(torn < 1.01);
}
