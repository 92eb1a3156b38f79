#include "pick/pick.h"

#include <vector>

#include "test.h"

using namespace gphys;

namespace {

gphys_camera_desc described() {
    gphys_camera_desc desc{};
    desc.viewport_width = 640;
    desc.viewport_height = 480;
    return desc;
}

/// A scene of unit-sized spheres, boxes and capsules strewn about the origin.
struct World {
    Scene scene{nullptr};
    struct Model {
        gphys_model_id id;
        uint32_t layers;
        Shape shape;  // in the world
    };
    std::vector<Model> models;

    explicit World(uint64_t seed, int count, float extent) {
        test::Random random(seed);
        for (int i = 0; i < count; ++i) {
            const gphys_sphere sphere{{0, 0, 0}, random.uniform_float(0.1f, 1)};
            const gphys_obb box{{0, 0, 0}, {random.uniform_float(0.1f, 1), 0.5f, 0.2f}, random.rotation()};
            const gphys_capsule capsule{{-1, 0, 0}, {1, 0.5f, 0}, 0.25f};
            const gphys_transform transform{random.point(extent), random.rotation(), 1};
            gphys_model_desc desc{};
            desc.scale = {1, 1, 1};
            desc.layers = 1u << random.index(3);
            gphys_model_id model = 0;
            const gphys_shape_type types[] = {GPHYS_SHAPE_SPHERE, GPHYS_SHAPE_OBB, GPHYS_SHAPE_CAPSULE};
            const void* shapes[] = {&sphere, &box, &capsule};
            REQUIRE(scene.add(types[i % 3], shapes[i % 3], 0, &transform, 0, 1, desc, &model) == GPHYS_OK);
            const Transform placed = widen(transform);
            const Shape in_world[] = {transformed(widen(sphere), placed), transformed(widen(box), placed),
                                      transformed(widen(capsule), placed)};
            models.push_back({model, desc.layers, in_world[i % 3]});
        }
    }
};

/// Places the camera at random and gives it one of the three kinds of projection.
void set_up(Camera& camera, test::Random& random, int kind) {
    camera.set_transform(widen(random.point(15)), rotation_matrix(widen(random.rotation())));
    camera.set_perspective(random.uniform(0.3, 2), 0.1f, random.index(2) ? 60 : INFINITY);
    if (kind == 1) camera.set_orthographic(random.uniform(2, 30), -5, 40);
    if (kind == 2) REQUIRE(camera.set_projection(camera.projection_matrix()) == GPHYS_OK);
}

std::vector<gphys_model_id> in_rectangle(const Camera& camera, const Scene& scene, double x0, double y0, double x1,
                                         double y1, uint32_t layers) {
    std::vector<gphys_model_id> out(1000);
    out.resize(pick_rectangle(camera, scene, x0, y0, x1, y1, layers, out.data(), 1000));
    return out;
}

}  // namespace

TEST_CASE("pick finds what the ray through the pixel meets first, among all models one by one") {
    const World world(1, 200, 12);
    test::Random random(2);
    int found = 0;
    for (int i = 0; i < 3000; ++i) {
        Camera camera(nullptr, described());
        set_up(camera, random, i % 3);
        const double x = random.uniform(0, 640), y = random.uniform(0, 480);
        const uint32_t layers = i % 4 ? GPHYS_ALL_LAYERS : 2;
        gphys_hit hit{};
        const gphys_status status = pick(camera, world.scene, x, y, layers, hit);
        Ray ray;
        REQUIRE(camera.pick_ray(x, y, ray));
        double nearest = infinity;
        gphys_model_id first = 0;
        for (const World::Model& model : world.models) {
            Hit one;
            if ((model.layers & layers) && raycast(model.shape, ray, one) && one.t < nearest) {
                nearest = one.t;
                first = model.id;
            }
        }
        REQUIRE(status == (first ? GPHYS_OK : GPHYS_NO_HIT));
        if (!first) continue;
        ++found;
        REQUIRE(hit.t == static_cast<float>(nearest));
        if (hit.t > 0) REQUIRE(hit.model == first);
        // The point that was hit is seen at the pixel; it is rounded to float, at 27 metres to 2^-20.
        Vec3 pixel;
        if (hit.t > 0 && camera.project(widen(hit.point), pixel)) {
            REQUIRE(std::fabs(pixel.x - x) < 0.1);
            REQUIRE(std::fabs(pixel.y - y) < 0.1);
        }
    }
    REQUIRE(found > 200);
}

TEST_CASE("a rectangle of pixels holds the models whose shapes overlap its frustum") {
    const World world(3, 200, 12);
    test::Random random(4);
    size_t found = 0;
    for (int i = 0; i < 1000; ++i) {
        Camera camera(nullptr, described());
        set_up(camera, random, i % 3);
        const double x0 = random.uniform(-50, 690), y0 = random.uniform(-50, 530);
        const double x1 = random.uniform(-50, 690), y1 = random.uniform(-50, 530);
        const uint32_t layers = i % 4 ? GPHYS_ALL_LAYERS : 5;
        std::vector<gphys_model_id> expected;
        const Frustum seen = camera.frustum_of_pixels(x0, y0, x1, y1);
        for (const World::Model& model : world.models) {
            if ((model.layers & layers) && overlaps(model.shape, seen)) {
                expected.push_back(model.id);
            }
        }
        std::sort(expected.begin(), expected.end());
        const std::vector<gphys_model_id> models = in_rectangle(camera, world.scene, x0, y0, x1, y1, layers);
        REQUIRE(models == expected);
        REQUIRE(in_rectangle(camera, world.scene, x1, y0, x0, y1, layers) == models);
        found += models.size();
    }
    REQUIRE(found > 3000);
}

TEST_CASE("whatever a pixel picks, a rectangle around the pixel and cull hold") {
    const World world(5, 200, 12);
    test::Random random(6);
    for (int i = 0; i < 2000; ++i) {
        Camera camera(nullptr, described());
        set_up(camera, random, i % 3);
        const double x = random.uniform(1, 639), y = random.uniform(1, 479);
        gphys_hit hit{};
        if (pick(camera, world.scene, x, y, GPHYS_ALL_LAYERS, hit) != GPHYS_OK) continue;
        const std::vector<gphys_model_id> around =
            in_rectangle(camera, world.scene, x - 0.5, y - 0.5, x + 0.5, y + 0.5, GPHYS_ALL_LAYERS);
        REQUIRE(std::find(around.begin(), around.end(), hit.model) != around.end());
        std::vector<gphys_model_id> culled(1000);
        culled.resize(cull(camera, world.scene, GPHYS_ALL_LAYERS, culled.data(), 1000));
        REQUIRE(std::is_sorted(culled.begin(), culled.end()));
        REQUIRE(std::find(culled.begin(), culled.end(), hit.model) != culled.end());
        // A superset of what the whole picture shows.
        const std::vector<gphys_model_id> shown = in_rectangle(camera, world.scene, 0, 0, 640, 480, GPHYS_ALL_LAYERS);
        REQUIRE(std::includes(culled.begin(), culled.end(), shown.begin(), shown.end()));
    }
}
