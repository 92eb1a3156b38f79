// Cloth that lies on models keeps what it has seen of them from step to step: it notices when they are others, and
// goes on after a snapshot as without one.
#include "closed_cloth.h"
#include "snapshots.h"

using test::MeshHandle;
using test::point_mass;
using test::World;

namespace {

constexpr float radius = 0.01f;
constexpr float frame = 1.0f / 60;

const gphys_aabb table{{-1, -0.5f, -1}, {1, 0, 1}};

/// A sheet of 2/3 m by 2/3 m that comes to lie on what there is below y = 0.
gphys_body_id lay_sheet(World& world) {
    gphys_body_desc desc = point_mass(radius, 0.5f, 0);
    desc.damping = 2;
    const gphys_body_id cloth = world.cloth({-0.3f, 0.05f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f}, 13, 13, desc);
    for (int i = 0; i < 60; ++i) world.step(frame);
    return cloth;
}

double highest(const World& world, gphys_body_id cloth) {
    double y = -1e9;
    for (const gphys_vec3& p : world.positions(cloth)) y = std::max<double>(y, p.y);
    return y;
}
double lowest(const World& world, gphys_body_id cloth) {
    double y = 1e9;
    for (const gphys_vec3& p : world.positions(cloth)) y = std::min<double>(y, p.y);
    return y;
}

/// A square of 4 m x 4 m at a height, with a peak of 0.2 m in one corner and a pit as deep in another: whatever the
/// height, its box is the same.
MeshHandle plateau(float height) {
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
    constexpr uint32_t n = 8;
    for (uint32_t i = 0; i <= n; ++i) {
        for (uint32_t k = 0; k <= n; ++k) {
            const float y = i == 0 && k == 0 ? 0.2f : i == n && k == n ? -0.2f : height;
            const float x = 4 * static_cast<float>(i) / n - 2, z = 4 * static_cast<float>(k) / n - 2;
            vertices.insert(vertices.end(), {x, y, z});
            if (i == 0 || k == 0) continue;
            const uint32_t here = i * (n + 1) + k;
            indices.insert(indices.end(), {here - n - 2, here - n - 1, here, here - n - 2, here, here - 1});
        }
    }
    return MeshHandle(vertices, indices);
}

uint64_t hash(const gphys_solver* solver) {
    uint32_t halves[2];
    REQUIRE(gphys_solver_get_hash(solver, halves) == GPHYS_OK);
    return uint64_t{halves[1]} << 32 | halves[0];
}

}  // namespace

TEST_CASE("cloth that lies on a box falls when it is gone") {
    World world;
    const gphys_model_id box = world.model(GPHYS_SHAPE_AABB, &table);
    const gphys_body_id cloth = lay_sheet(world);
    REQUIRE(lowest(world, cloth) > 0);
    REQUIRE(gphys_scene_remove(world.scene, box) == GPHYS_OK);
    for (int i = 0; i < 30; ++i) world.step(frame);
    // Half a second with a damping of 2 a second takes it 0.9 m down, by g (t - (1 - exp(-2 t)) / 2) / 2.
    CHECK(highest(world, cloth) < -0.85);
    CHECK(lowest(world, cloth) > -0.95);
}

TEST_CASE("a model that comes where cloth lies pushes it away") {
    World world;
    world.model(GPHYS_SHAPE_AABB, &table);
    const gphys_body_id cloth = lay_sheet(world);
    const gphys_sphere ball{{0, -0.05f, 0}, 0.08f};  // its top is 3 cm above the box
    world.model(GPHYS_SHAPE_SPHERE, &ball);
    for (int i = 0; i < 30; ++i) world.step(frame);
    CHECK(highest(world, cloth) >= 0.03 + double{radius} - 1e-5);
    for (const gphys_vec3& p : world.positions(cloth)) {
        CHECK(distance(gphys::widen(p), {0, -0.05, 0}) >= 0.08 + double{radius} - 1e-5);
    }
}

TEST_CASE("cloth finds the models of another scene, though they have the same numbers and boxes") {
    const MeshHandle high = plateau(0), low = plateau(-0.1f);
    World world, other;
    const gphys_model_id here = world.model(GPHYS_SHAPE_MESH, high.mesh);
    REQUIRE(other.model(GPHYS_SHAPE_MESH, low.mesh) == here);
    const gphys_body_id cloth = lay_sheet(world);
    REQUIRE(lowest(world, cloth) > 0);
    for (int i = 0; i < 60; ++i) REQUIRE(gphys_solver_step(world.solver, other.scene, frame) == GPHYS_OK);
    CHECK(highest(world, cloth) < -0.1 + 1.2 * double{radius});
    CHECK(lowest(world, cloth) >= -0.1 + double{radius} - 1e-5);
}

TEST_CASE("what cloth has seen of a mesh is seen again after a snapshot") {
    World world;
    const MeshHandle mesh = plateau(-0.05f);
    const gphys_sphere ball{{0.1f, -0.1f, 0}, 0.12f};
    world.model(GPHYS_SHAPE_MESH, mesh.mesh);
    world.model(GPHYS_SHAPE_SPHERE, &ball);
    const gphys_body_id cloth = lay_sheet(world);
    // It slides, so that some particles keep what they have seen and others do not.
    const gphys_vec3 gravity{6, -9, 0};
    REQUIRE(gphys_solver_set_gravity(world.solver, &gravity) == GPHYS_OK);
    for (int i = 0; i < 10; ++i) world.step(frame);
    const gphys_vec3 before = world.positions(cloth)[0];
    std::vector<uint32_t> words(1 << 16);
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_snapshot(world.solver, words.data(), 1 << 16, &total) == GPHYS_OK);
    gphys_solver* copy = nullptr;
    REQUIRE(gphys_solver_create(nullptr, &copy) == GPHYS_OK);
    REQUIRE(gphys_solver_restore(copy, words.data(), total) == GPHYS_OK);
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        REQUIRE(gphys_solver_step(copy, world.scene, frame) == GPHYS_OK);
        REQUIRE(hash(copy) == hash(world.solver));
    }
    CHECK(distance(gphys::widen(before), world.position(cloth)) > 0.02);
    gphys_solver_destroy(copy);
}

TEST_CASE("cloth that comes out of a snapshot falls where no models are") {
    // Memory that holds no zeros: nothing that was not written may be taken for what was seen.
    const gphys_allocator littered{
        [](void*, size_t size, size_t alignment) {
            void* memory = ::operator new(size, std::align_val_t(alignment));
            return std::memset(memory, 0x5a, size);
        },
        [](void*, void* memory, size_t, size_t alignment) { ::operator delete(memory, std::align_val_t(alignment)); },
        nullptr};
    World world, empty;
    gphys_solver_desc desc = World::desc();
    desc.allocator = &littered;
    gphys_solver_destroy(empty.solver);
    REQUIRE(gphys_solver_create(&desc, &empty.solver) == GPHYS_OK);
    world.model(GPHYS_SHAPE_AABB, &table);
    const gphys_body_id cloth = lay_sheet(world);
    REQUIRE(test::restore(empty.solver, test::snapshot(world.solver)) == GPHYS_OK);
    for (int i = 0; i < 30; ++i) empty.step(frame);
    CHECK(highest(empty, cloth) < -0.85);
}

namespace {

/// Cloth that meets more and more of what lies around: a ball with gas in it, and a sheet that boxes grow into.
struct Yard : World {
    gphys_model_id growing = 0;

    Yard() {
        const gphys_plane slope{{0.2f, 0.98f, 0}, 0};
        model(GPHYS_SHAPE_PLANE, &slope);
        for (int i = 0; i < 12; ++i) {
            const float x = static_cast<float>(i);
            const gphys_sphere stone{{0.4f * x - 0.5f, -0.08f * x, 0.3f * (x - 6)}, 0.15f};
            model(GPHYS_SHAPE_SPHERE, &stone);
        }
        gphys_body_desc desc = point_mass(0.01f, 0.4f, 0.2f);
        const gphys_body_id ball = test::add(*this, test::icosphere(2), desc, 1.3f);
        REQUIRE(gphys_solver_set_volume(solver, ball, -1, 0) == GPHYS_OK);
        cloth({2, 1, -1}, {1, 0.1f, 0}, {0, 0.1f, 1}, 16, 16, desc);
        const gphys_obb box{{2.5f, -0.4f, -0.5f}, {0.2f, 0.2f, 0.2f}, {0, 0, 0.2f, 0.98f}};
        growing = model(GPHYS_SHAPE_OBB, &box);
    }
    void grow(int step) {
        const float half = 0.2f + 0.004f * static_cast<float>(step);
        const gphys_obb box{{2.5f, -0.4f, -0.5f}, {half, half, half}, {0, 0, 0.2f, 0.98f}};
        REQUIRE(gphys_scene_set_shape(scene, growing, GPHYS_SHAPE_OBB, &box) == GPHYS_OK);
    }
};

}  // namespace

TEST_CASE("cloth restored before every step goes on with the same bits as cloth that keeps its contact planes",
          "[simulation]") {
    Yard kept, restored;
    for (int i = 0; i < 150; ++i) {
        REQUIRE(test::restore(restored.solver, test::snapshot(restored.solver)) == GPHYS_OK);
        for (Yard* yard : {&kept, &restored}) {
            if (i % 3 == 0) yard->grow(i);
            yard->step(frame);
        }
        INFO("step " << i);
        REQUIRE(test::hash(kept.solver) == test::hash(restored.solver));
    }
}
