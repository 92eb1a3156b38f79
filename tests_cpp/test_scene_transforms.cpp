// Models moved: their boxes, what is refused, and that nothing has moved then.
#include <cfenv>
#include <cstring>

#include "meshes.h"
#include "scene/bounds_kernels.h"
#include "scene/conservative_shape.h"
#include "scene_fixture.h"

using namespace gphys;
using test::at;
using test::SceneFixture;

namespace {

std::vector<gphys_transform> places(const SceneFixture& s, const std::vector<gphys_model_id>& models) {
    std::vector<gphys_transform> result;
    for (const gphys_model_id model : models) result.push_back(s.local(model));
    return result;
}

bool same_bits(const std::vector<gphys_transform>& a, const std::vector<gphys_transform>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

gphys_status move(SceneFixture& s, const std::vector<gphys_model_id>& models, const std::vector<gphys_transform>& to) {
    return gphys_scene_set_transforms(s.scene, models.data(), to.data(), sizeof to[0],
                                      static_cast<uint32_t>(models.size()));
}

}  // namespace

TEST_CASE("rotations are refused where their length leaves 1e-3 of one, to the last bit") {
    test::Random random(41);
    SceneFixture s;
    const gphys_model_id model = s.add_box(at(0, 0, 0));
    int refused = 0;
    for (int i = 0; i < 50000; ++i) {
        gphys_transform to = at(1, 2, 3);
        to.rotation = random.rotation();
        // From the limit to far beyond it, of which the widest is told from the sum of rounded squares.
        const double limit = i % 2 ? 1.001 : 0.999, wide = std::exp2(random.uniform(-24, -8));
        const auto length = static_cast<float>(limit * (1 + random.uniform(-wide, wide)));
        for (float* part : {&to.rotation.x, &to.rotation.y, &to.rotation.z, &to.rotation.w}) *part *= length;
        long double square = 0;
        for (const float part : {to.rotation.x, to.rotation.y, to.rotation.z, to.rotation.w}) {
            square += static_cast<long double>(part) * part;
        }
        // 53 bits of the library's sum against 64 of this one.
        const long double above = square - 1.001L * 1.001L, below = 0.999L * 0.999L - square;
        if (std::fabs(above) < 1e-15L || std::fabs(below) < 1e-15L) continue;
        const bool valid = above < 0 && below < 0;
        REQUIRE(s.move(model, to) == (valid ? GPHYS_OK : GPHYS_ERROR_INVALID_ARGUMENT));
        refused += !valid;
    }
    CHECK(refused > 10000);
}

TEST_CASE("a number of a transform that is none or out of range is refused, and raises nothing") {
    SceneFixture s;
    std::vector<gphys_model_id> models;
    for (int i = 0; i < 20; ++i) models.push_back(s.add_box(at(static_cast<float>(3 * i), 0, 0)));
    const std::vector<gphys_transform> before = places(s, models);
    std::vector<gphys_transform> good = before;
    for (gphys_transform& to : good) to.position.y = 5;
    const float wrong[] = {NAN, -NAN, INFINITY, -INFINITY, 1.0001e15f, -1.0001e15f, 3e38f};
    for (const float number : wrong) {
        for (size_t part = 0; part < sizeof(gphys_transform) / sizeof(float); ++part) {
            std::vector<gphys_transform> to = good;
            std::memcpy(reinterpret_cast<char*>(&to[19]) + part * sizeof number, &number, sizeof number);
            std::feclearexcept(FE_ALL_EXCEPT);
            REQUIRE(move(s, models, to) == GPHYS_ERROR_INVALID_ARGUMENT);
            REQUIRE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) == 0);
            REQUIRE(same_bits(places(s, models), before));
        }
    }
    for (const float scale : {0.f, -0.f, -1.f, 0.9e-15f}) {
        std::vector<gphys_transform> to = good;
        to[19].scale = scale;
        REQUIRE(move(s, models, to) == GPHYS_ERROR_INVALID_ARGUMENT);
        REQUIRE(same_bits(places(s, models), before));
    }
    CHECK(move(s, models, good) == GPHYS_OK);
    CHECK(same_bits(places(s, models), good));
    CHECK(s.sound());
}

TEST_CASE("what would reach beyond the range of coordinates stays, whichever shape it is") {
    // A box reaches to 2^52 = 4.5e15 at most; with this scale each reaches to 5e15 or more.
    const float scale = 1e6f, size = 5e9f;
    const gphys_transform too_large = at(0, 0, 0, scale);
    const auto refuses = [&](gphys_shape_type type, const void* shape) {
        SceneFixture s;
        gphys_model_id model = 0;
        REQUIRE(gphys_scene_add(s.scene, type, shape, nullptr, nullptr, &model) == GPHYS_OK);
        const std::vector<gphys_model_id> models{s.add_box(at(0, 0, 0)), s.add_box(at(1, 0, 0))};
        const std::vector<gphys_model_id> all{model, models[0], models[1]};
        const std::vector<gphys_transform> before = places(s, all);
        CHECK(s.move(model, too_large) == GPHYS_ERROR_INVALID_ARGUMENT);
        CHECK(move(s, all, {too_large, at(5, 5, 5), at(6, 6, 6)}) == GPHYS_ERROR_INVALID_ARGUMENT);
        CHECK(same_bits(places(s, all), before));
        // Small ones beside it may go where it may not.
        CHECK(move(s, models, {too_large, at(6, 6, 6)}) == GPHYS_OK);
        CHECK(s.sound());
    };
    const gphys_aabb box{{0, 0, size - 1}, {1, 1, size}};
    const gphys_obb turned{{0, size, 0}, {1, 1, 1}, {0, 0, 0, 1}};
    const gphys_sphere sphere{{0, 0, 0}, size};
    const gphys_capsule capsule{{0, 0, 0}, {-size, 0, 0}, 1};
    const gphys_triangle triangle{{0, 0, 0}, {0, 1, 0}, {0, 0, -size}};
    refuses(GPHYS_SHAPE_AABB, &box);
    refuses(GPHYS_SHAPE_OBB, &turned);
    refuses(GPHYS_SHAPE_SPHERE, &sphere);
    refuses(GPHYS_SHAPE_CAPSULE, &capsule);
    refuses(GPHYS_SHAPE_TRIANGLE, &triangle);
}

TEST_CASE("an Aabb that is not turned keeps its exact box") {
    SceneFixture s;
    const gphys_model_id box = s.add_box(at(10, 20, 30, 2));
    gphys_aabb bounds;
    REQUIRE(gphys_scene_get_bounds(s.scene, box, &bounds) == GPHYS_OK);
    CHECK(bounds.min.x == 8);
    CHECK(bounds.max.z == 32);
    // The ray runs along the face: exact arithmetic is needed to hit, and the next float misses.
    CHECK(s.first_on_ray({12, 20, 0}, {0, 0, 1}) == box);
    CHECK(s.first_on_ray({std::nextafter(12.f, 13.f), 20, 0}, {0, 0, 1}) == 0);
}

TEST_CASE("the world box of a turned box holds its corners, and little more") {
    test::Random random(31);
    SceneFixture s;
    const auto number = [&](double size) { return static_cast<float>(random.uniform(-size, size)); };
    for (int i = 0; i < 20000; ++i) {
        const double far = std::exp2(random.uniform(-20, 23)), size = std::exp2(random.uniform(-20, 20));
        gphys_aabb shape{{number(size) - static_cast<float>(size), -static_cast<float>(size), -1},
                         {static_cast<float>(size), static_cast<float>(size), number(1) + 1}};
        // Those about their own origin, and those but for a hair, go different ways.
        if (i % 4 > 0) shape.min = {-shape.max.x, -shape.max.y, -shape.max.z};
        if (i % 8 == 2) shape.min.z = shape.max.z;
        if (i % 4 == 1) shape.min.z = std::nextafter(shape.min.z, -INFINITY);
        gphys_transform place = at(number(far), number(far), number(far), std::exp2(number(10)));
        place.rotation = random.rotation();
        gphys_model_id model = 0;
        gphys_aabb box;
        REQUIRE(gphys_scene_add(s.scene, GPHYS_SHAPE_AABB, &shape, &place, nullptr, &model) == GPHYS_OK);
        REQUIRE(gphys_scene_get_bounds(s.scene, model, &box) == GPHYS_OK);
        REQUIRE(gphys_scene_remove(s.scene, model) == GPHYS_OK);

        const gphys_quat& r = place.rotation;
        const long double x = r.x, y = r.y, z = r.z, w = r.w, norm = x * x + y * y + z * z + w * w;
        const long double rows[3][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                                        {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                                        {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
        const float positions[3] = {place.position.x, place.position.y, place.position.z};
        const float box_min[3] = {box.min.x, box.min.y, box.min.z}, box_max[3] = {box.max.x, box.max.y, box.max.z};
        for (int k = 0; k < 3; ++k) {
            long double low = positions[k], high = positions[k], magnitude = std::fabs(low);
            const float mins[3] = {shape.min.x, shape.min.y, shape.min.z};
            const float maxs[3] = {shape.max.x, shape.max.y, shape.max.z};
            for (int j = 0; j < 3; ++j) {
                const long double factor = rows[k][j] / norm * place.scale;
                low += std::min(factor * mins[j], factor * maxs[j]);
                high += std::max(factor * mins[j], factor * maxs[j]);
            }
            for (int j = 0; j < 3; ++j) {
                magnitude += std::fabs(positions[j]);
                magnitude += place.scale * std::max(std::fabs(mins[j]), std::fabs(maxs[j]));
            }
            REQUIRE(box_min[k] <= low);
            REQUIRE(box_max[k] >= high);
            // As the header says.
            const long double sizes = place.scale * (std::fabs(maxs[0] - mins[0]) + std::fabs(maxs[1] - mins[1]) +
                                                     std::fabs(maxs[2] - mins[2]));
            const long double furthest = std::max(std::fabs(low), std::fabs(high));
            const long double more = 3 * 0x1p-23L * furthest + 0x1p-19L * sizes + 0x1p-41L * magnitude;
            REQUIRE(box_min[k] >= low - more);
            REQUIRE(box_max[k] <= high + more);
        }
    }
}

TEST_CASE("the boxes of eight turned Aabbs at once are those of each, on any instruction set") {
    struct Stored {
        gphys_transform world;
        float words[2] = {NAN, INFINITY};
        gphys_aabb box;
    };
    test::Random random(32);
    int told = 0;
    for (int round = 0; round < 2000; ++round) {
        Stored stored[8];
        const float* models[8];
        for (int k = 0; k < 8; ++k) {
            const float far = std::exp2(random.uniform_float(-140, 49)),
                        size = std::exp2(random.uniform_float(-140, 30));
            const gphys_vec3 p = random.point(far), h = random.point(size);
            stored[k].world = {p, random.rotation(), std::exp2(random.uniform_float(-10, 10))};
            // Faces with the signs that they have, flat ones among them.
            stored[k].box = {{-std::fabs(h.x), -std::fabs(h.y), -std::fabs(h.z)},
                             {std::fabs(h.x), std::fabs(h.y), std::fabs(h.z)}};
            if (random.index(4) == 0) stored[k].box.min.y = -0.0f, stored[k].box.max.y = 0;
            if (random.index(8) == 0) stored[k].box.min.z = stored[k].box.max.z = 0;
            if (random.index(8) == 0) stored[k].box.min.x = std::nextafter(stored[k].box.min.x, -INFINITY);
            if (random.index(8) == 0) stored[k].world.rotation = test::no_rotation;
            if (random.index(8) == 0) stored[k].world.rotation = {0, 0, std::numeric_limits<float>::denorm_min(), 1};
            models[7 - k] = &stored[k].world.position.x;
        }
        for (const Isa isa : test::isas()) {
            Box8 boxes;
            const uint32_t known = bounds_kernels(isa).rotated_aabbs(models, boxes);
            for (int k = 0; k < 8; ++k) {
                const Stored& one = stored[7 - k];
                const bool known_one = (known >> k & 1) != 0;
                REQUIRE(known_one == (is_rotated(one.world.rotation) && is_centered(one.box)));
                if (!known_one) continue;
                ++told;
                const Box truth = conservative_bounds(one.box, one.world), box = boxes.lane(k);
                REQUIRE(std::memcmp(&box, &truth, sizeof box) == 0);
            }
        }
    }
    CHECK(told > 8000);
}

TEST_CASE("models of all types that move at once stand where each alone would, and raise nothing") {
    const gphys_aabb box{{-1, -2, -3}, {1, 2, 3}}, corner{{0, 0, 0}, {1, 2, 3}};
    const gphys_obb obb{{1, 0, 0}, {1, 2, 3}, {0.6f, 0, 0, 0.8f}};
    const gphys_sphere sphere{{1, 0, 0}, 2};
    const gphys_capsule capsule{{-1, 0, 0}, {1, 0, 0}, 1};
    const gphys_plane plane{{0, 1, 0}, 1};
    const gphys_triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::pair<gphys_shape_type, const void*> shapes[] = {
        {GPHYS_SHAPE_AABB, &box},          {GPHYS_SHAPE_SPHERE, &sphere},  {GPHYS_SHAPE_AABB, &corner},
        {GPHYS_SHAPE_OBB, &obb},           {GPHYS_SHAPE_PLANE, &plane},    {GPHYS_SHAPE_AABB, &box},
        {GPHYS_SHAPE_TRIANGLE, &triangle}, {GPHYS_SHAPE_CAPSULE, &capsule}};
    test::Random random(33);
    for (const uint32_t count : {1u, 7u, 8u, 9u, 100u, 3000u}) {
        SceneFixture together, alone;
        std::vector<gphys_model_id> models;
        std::vector<gphys_transform> to;
        for (uint32_t i = 0; i < count; ++i) {
            const auto& [type, shape] = shapes[random.index(std::size(shapes))];
            models.push_back(together.add(type, shape, at(0, 0, 0)));
            REQUIRE(alone.add(type, shape, at(0, 0, 0)) == models.back());
            to.push_back({random.point(100), random.rotation(), random.uniform_float(0.5f, 2)});
            if (random.index(4) == 0) to.back().rotation = test::no_rotation;
        }
        std::feclearexcept(FE_ALL_EXCEPT);
        REQUIRE(move(together, models, to) == GPHYS_OK);
        CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) == 0);
        CHECK(together.sound());
        for (uint32_t i = 0; i < count; ++i) {
            REQUIRE(alone.move(models[i], to[i]) == GPHYS_OK);
            gphys_aabb one, other;
            const gphys_status status = gphys_scene_get_bounds(alone.scene, models[i], &one);
            REQUIRE(gphys_scene_get_bounds(together.scene, models[i], &other) == status);
            if (status == GPHYS_OK) REQUIRE(std::memcmp(&one, &other, sizeof one) == 0);
        }
    }
}
