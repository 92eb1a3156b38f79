// Results that are reported as equally far go to the lower id, then to the lower triangle index, however
// the doubles differ that they were rounded from, and whichever way the question is put.
//
// A linear scan gives what is expected: each model is asked alone, in a scene of its own, and the floats are
// compared that it reports.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "c_api/handles.h"
#include "meshes.h"
#include "scene_fixture.h"

using namespace gphys;
using test::Random;

namespace {

template <class T>
bool same_bits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

struct SceneDeleter {
    void operator()(gphys_scene* scene) const { gphys_scene_destroy(scene); }
};
using SceneHolder = std::unique_ptr<gphys_scene, SceneDeleter>;

SceneHolder make_scene() {
    gphys_scene* scene = nullptr;
    REQUIRE(gphys_scene_create(nullptr, &scene) == GPHYS_OK);
    return SceneHolder(scene);
}

gphys_vec3 operator+(gphys_vec3 a, gphys_vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
gphys_vec3 operator-(gphys_vec3 a, gphys_vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
gphys_vec3 operator*(float s, gphys_vec3 a) { return {s * a.x, s * a.y, s * a.z}; }

/// How many questions were asked, were answered by several models equally far, and were not answered as expected.
struct Tally {
    int asked = 0, tied = 0, wrong = 0;
};

/// Models in one scene, and each of them in a scene of its own.
class Models {
public:
    SceneHolder all = make_scene();

    /// Slots that were used before: all but 1023 are used again, by models of higher ids than those in new slots.
    void use_slots(uint32_t count) {
        const gphys_sphere ball{{0, 0, 0}, 1};
        std::vector<gphys_model_id> ids(count);
        REQUIRE(gphys_scene_add_batch(all.get(), GPHYS_SHAPE_SPHERE, &ball, 0, nullptr, 0, count, nullptr,
                                      ids.data()) == GPHYS_OK);
        std::reverse(ids.begin(), ids.end());
        REQUIRE(gphys_scene_remove_batch(all.get(), ids.data(), count) == GPHYS_OK);
    }
    void add(gphys_shape_type type, const void* shape, const gphys_transform& place, gphys_model_id parent = 0) {
        gphys_model_desc desc;
        gphys_model_desc_init(&desc, sizeof desc);
        desc.parent = parent;
        One one{0, make_scene()};
        gphys_model_id alone = 0;
        gphys_transform world;
        REQUIRE(gphys_scene_add(all.get(), type, shape, &place, &desc, &one.id) == GPHYS_OK);
        REQUIRE(gphys_scene_get_world_transforms(all.get(), &one.id, 1, &world, sizeof world) == GPHYS_OK);
        REQUIRE(gphys_scene_add(one.scene.get(), type, shape, &world, nullptr, &alone) == GPHYS_OK);
        const auto behind = std::lower_bound(each_.begin(), each_.end(), one.id,
                                             [](const One& a, gphys_model_id id) { return a.id < id; });
        each_.insert(behind, std::move(one));
    }
    gphys_model_id first_id() const { return each_.front().id; }

    /// The first of the answers that ask(scene, answer) gives of each model, by before(a, b); their number, and
    /// how many are as near as the first.
    template <class Answer, class Ask, class Far>
    bool first_of(const Ask& ask, const Far& far, Answer& out, uint32_t& tied) const {
        bool found = false;
        tied = 0;
        for (const One& one : each_) {
            Answer answer;
            if (ask(one.scene.get(), &answer) != GPHYS_OK) continue;
            answer.model = one.id;
            if (!found || far(answer) < far(out)) {
                out = answer;
                tied = 0;
            }
            tied += far(answer) == far(out);
            found = true;
        }
        return found;
    }

private:
    struct One {
        gphys_model_id id;
        SceneHolder scene;
    };
    std::vector<One> each_;  // by id
};

float far_of(const gphys_hit& hit) { return hit.t; }
float far_of(const gphys_nearest& nearest) { return nearest.distance; }

/// One question of a kind, put alone; and all of them in a batch.
template <class Answer, class Question, class Ask, class AskBatch>
Tally compare(const Models& models, const std::vector<Question>& questions, const Ask& ask, const AskBatch& ask_batch) {
    Tally tally;
    std::vector<Answer> in_batch(questions.size());
    REQUIRE(ask_batch(models.all.get(), in_batch.data()) == GPHYS_OK);
    for (size_t i = 0; i < questions.size(); ++i) {
        const auto ask_one = [&](const gphys_scene* scene, Answer* out) { return ask(scene, questions[i], out); };
        Answer expected{}, found{};
        uint32_t tied = 0;
        const bool any = models.first_of(
            ask_one, [](const Answer& answer) { return far_of(answer); }, expected, tied);
        const gphys_status status = ask_one(models.all.get(), &found);
        ++tally.asked;
        tally.tied += tied > 1;
        tally.wrong += status != (any ? GPHYS_OK : GPHYS_NO_HIT) || (any && !same_bits(found, expected)) ||
                       (any ? !same_bits(in_batch[i], expected) : in_batch[i].model != 0);
    }
    return tally;
}

/// The first of all hits is that of the first one, and what is left of a list that was cut short are its first.
int wrong_lists(const Models& models, const std::vector<gphys_ray>& rays) {
    int wrong = 0;
    for (const gphys_ray& ray : rays) {
        gphys_hit first{}, all[100], some[100];
        uint32_t total = 0, again = 0;
        const gphys_status status = gphys_scene_raycast(models.all.get(), &ray, GPHYS_ALL_LAYERS, &first);
        REQUIRE(gphys_scene_raycast_all(models.all.get(), &ray, GPHYS_ALL_LAYERS, all, 100, &total) == GPHYS_OK);
        wrong += (status == GPHYS_OK) != (total > 0) || (total > 0 && !same_bits(first, all[0]));
        wrong += !std::is_sorted(all, all + total, [](const gphys_hit& a, const gphys_hit& b) {
            return a.t < b.t || (a.t == b.t && a.model < b.model);
        });
        for (const uint32_t capacity : {1u, 2u, 3u}) {
            gphys_scene_raycast_all(models.all.get(), &ray, GPHYS_ALL_LAYERS, some, capacity, &again);
            wrong += again != total || std::memcmp(some, all, std::min(capacity, total) * sizeof some[0]) != 0;
        }
    }
    return wrong;
}

Tally compare_rays(const Models& models, const std::vector<gphys_ray>& rays) {
    const auto count = static_cast<uint32_t>(rays.size());
    return compare<gphys_hit>(
        models, rays,
        [](const gphys_scene* scene, const gphys_ray& ray, gphys_hit* out) {
            return gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, out);
        },
        [&](const gphys_scene* scene, gphys_hit* out) {
            return gphys_scene_raycast_batch(scene, rays.data(), sizeof rays[0], count, GPHYS_ALL_LAYERS, out,
                                             sizeof *out);
        });
}

Tally compare_segments(const Models& models, const std::vector<gphys_segment>& segments) {
    const auto count = static_cast<uint32_t>(segments.size());
    return compare<gphys_hit>(
        models, segments,
        [](const gphys_scene* scene, const gphys_segment& segment, gphys_hit* out) {
            return gphys_scene_segment_test(scene, &segment, GPHYS_ALL_LAYERS, out);
        },
        [&](const gphys_scene* scene, gphys_hit* out) {
            return gphys_scene_segment_test_batch(scene, segments.data(), sizeof segments[0], count, GPHYS_ALL_LAYERS,
                                                  out, sizeof *out);
        });
}

Tally compare_nearest(const Models& models, const std::vector<gphys_vec3>& points, float most) {
    const auto count = static_cast<uint32_t>(points.size());
    return compare<gphys_nearest>(
        models, points,
        [&](const gphys_scene* scene, const gphys_vec3& point, gphys_nearest* out) {
            return gphys_scene_nearest(scene, &point, most, GPHYS_ALL_LAYERS, out);
        },
        [&](const gphys_scene* scene, gphys_nearest* out) {
            return gphys_scene_nearest_batch(scene, points.data(), sizeof points[0], count, most, GPHYS_ALL_LAYERS, out,
                                             sizeof *out);
        });
}

Tally compare_sweeps(const Models& models, const std::vector<gphys_segment>& ways, float radius) {
    const auto count = static_cast<uint32_t>(ways.size());
    std::vector<gphys_sphere> spheres;
    std::vector<gphys_vec3> displacements;
    for (const gphys_segment& way : ways) {
        spheres.push_back({way.a, radius});
        displacements.push_back(way.b - way.a);
    }
    return compare<gphys_hit>(
        models, ways,
        [&](const gphys_scene* scene, const gphys_segment& way, gphys_hit* out) {
            const gphys_sphere sphere{way.a, radius};
            const gphys_vec3 displacement = way.b - way.a;
            return gphys_scene_sweep_sphere(scene, &sphere, &displacement, GPHYS_ALL_LAYERS, out);
        },
        [&](const gphys_scene* scene, gphys_hit* out) {
            return gphys_scene_sweep_sphere_batch(scene, spheres.data(), sizeof spheres[0], displacements.data(), 12,
                                                  count, GPHYS_ALL_LAYERS, out, sizeof *out);
        });
}

gphys_vec3 placed(const gphys_transform& place, gphys_vec3 at) { return narrow(widen(place).apply(widen(at))); }

/// Not on a lattice of floats, turned or not.
gphys_transform awkward_place(bool turned) {
    const gphys_quat turn = narrow(normalized(Quat{0.3, -0.2, 0.5, 0.7}));
    return {{0.1f, 0.3f, 0.7f}, turned ? turn : test::no_rotation, 0.7f};
}

/// Boxes of edge 1 side by side, in any order, as Aabbs or as Obbs.
void add_grid(Models& models, Random& random, const gphys_transform& place, int size, bool as_obbs) {
    std::vector<gphys_aabb> boxes;
    for (int i = 0; i < size * size * size; ++i) {
        const gphys_vec3 low{static_cast<float>(i % size), static_cast<float>(i / size % size),
                             static_cast<float>(i / size / size)};
        boxes.push_back({low, low + gphys_vec3{1, 1, 1}});
    }
    for (size_t i = boxes.size(); i > 1; --i) std::swap(boxes[i - 1], boxes[random.index(static_cast<uint32_t>(i))]);
    for (const gphys_aabb& box : boxes) {
        const gphys_obb obb{0.5f * (box.min + box.max), {0.5f, 0.5f, 0.5f}, test::no_rotation};
        as_obbs ? models.add(GPHYS_SHAPE_OBB, &obb, place) : models.add(GPHYS_SHAPE_AABB, &box, place);
    }
}

/// A corner of boxes on the surface of the grid, or on an edge or a face between such, and a way out.
struct OnGrid {
    gphys_vec3 at, out;

    OnGrid(Random& random, int size) : out{0, 0, 0} {
        const uint32_t axis = random.index(3), next = (axis + 1) % 3, last = (axis + 2) % 3, lines = random.index(3);
        const auto end = static_cast<float>(size);
        const auto corner = [&] { return static_cast<float>(random.index(static_cast<uint32_t>(size) + 1)); };
        const bool behind = random.index(2) == 0;
        (&at.x)[axis] = behind ? 0 : end;
        (&at.x)[next] = corner();
        (&at.x)[last] = lines == 0 ? random.uniform_float(0, end) : corner();
        (&out.x)[axis] = behind ? -1.f : 1.f;
    }
    /// Somewhere outside, one of four times so far away that trees are small beside the way there.
    gphys_vec3 from(Random& random) const {
        const float reach = random.index(4) ? 9 : 900;
        const gphys_vec3 aside = random.index(4) == 0 ? gphys_vec3{0, 0, 0} : random.point(reach);
        return at + random.uniform_float(0.1f, reach) * out + random.uniform_float(0, 0.3f) * aside;
    }
};

/// Through a point. One of four ends near it, as near as floats can tell.
gphys_ray ray_to(Random& random, gphys_vec3 target, gphys_vec3 from) {
    const float t_max = 1 + 0x1p-23f * static_cast<float>(random.index(5)) - 0x1p-22f;
    return {from, target - from, random.index(4) ? INFINITY : t_max};
}
gphys_segment segment_to(gphys_vec3 target, gphys_vec3 from) { return {from, target + 0.5f * (target - from)}; }

}  // namespace

TEST_CASE("rays in a scene through what boxes share meet the lowest id of those at equal t") {
    Random random(60);
    for (const bool turned : {false, true}) {
        for (const bool as_obbs : {false, true}) {
            Models models;
            models.use_slots(1023 + 10);
            const gphys_transform place = awkward_place(turned);
            add_grid(models, random, place, 3, as_obbs);
            std::vector<gphys_ray> rays;
            std::vector<gphys_segment> segments;
            for (int i = 0; i < test::tries(20480); ++i) {
                const OnGrid on(random, 3);
                const gphys_vec3 target = placed(place, on.at), from = placed(place, on.from(random));
                rays.push_back(ray_to(random, target, from));
                if (i % 4 == 0) segments.push_back(segment_to(target, from));
                // Neighbours, which share a walk.
                for (int k = 0; i % 8 == 7 && k < 8; ++k) {
                    rays.push_back(ray_to(random, placed(place, OnGrid(random, 3).at), {20, 13, 17}));
                }
            }
            const Tally of_rays = compare_rays(models, rays), of_segments = compare_segments(models, segments);
            INFO((turned ? "turned, " : "straight, ") << (as_obbs ? "obbs" : "aabbs"));
            CHECK(of_rays.asked >= test::tries(40000));
            CHECK(of_rays.wrong == 0);
            CHECK(of_rays.tied > test::tries(1500));
            CHECK(of_segments.wrong == 0);
            CHECK(of_segments.tied > test::tries(300));
            rays.resize(static_cast<size_t>(test::tries(5000)));
            CHECK(wrong_lists(models, rays) == 0);
        }
    }
}

TEST_CASE("spheres swept in a scene meet the lowest id of what they reach at equal t") {
    Random random(61);
    for (const bool turned : {false, true}) {
        Models models;
        const gphys_transform place = awkward_place(turned);
        add_grid(models, random, place, 3, turned);
        std::vector<gphys_segment> ways;
        for (int i = 0; i < 5000; ++i) {
            const OnGrid on(random, 3);
            ways.push_back(segment_to(placed(place, on.at), placed(place, on.from(random))));
        }
        for (const float radius : {0.f, 0.3f}) {
            const Tally tally = compare_sweeps(models, ways, radius);
            CHECK(tally.wrong == 0);
            CHECK(tally.tied > 200);
        }
    }
}

TEST_CASE("a point in a scene that is equally far from several models is nearest to the lowest id") {
    Random random(62);
    for (const bool turned : {false, true}) {
        Models models;
        const gphys_transform place = awkward_place(turned);
        add_grid(models, random, place, 3, turned);
        std::vector<gphys_vec3> points;
        for (int i = 0; i < 15000; ++i) {
            const OnGrid on(random, 3);
            points.push_back(placed(place, on.at + random.uniform_float(0, 3) * on.out));
        }
        for (const float most : {INFINITY, 1.f}) {
            const Tally tally = compare_nearest(models, points, most);
            CHECK(tally.wrong == 0);
            CHECK(tally.tied > 1000);
        }
    }
}

TEST_CASE("of round models and triangles of a scene that share points the lowest id is met and nearest") {
    Random random(63);
    Models models;
    models.use_slots(1023 + 10);
    std::vector<gphys_vec3> shared;
    for (int i = 0; i < 8; ++i) {
        const gphys_vec3 at{6.1f * static_cast<float>(i % 2), 6.3f * static_cast<float>(i / 2 % 2),
                            6.7f * static_cast<float>(i / 4)};
        shared.push_back(at);
        for (int k = 0; k < 4; ++k) {
            // The same sphere, put there in different ways: its centre is not the same double.
            const float part = 0.1f + 0.2f * static_cast<float>(k);
            const gphys_sphere ball{(1 - part) * at, 0.5f};
            if (i % 2 == 0) models.add(GPHYS_SHAPE_SPHERE, &ball, {part * at, test::no_rotation, 1});
            const gphys_capsule capsule{at, at + random.point(2), 0.5f};
            if (i % 4 == 1) models.add(GPHYS_SHAPE_CAPSULE, &capsule, test::at(0, 0, 0));
            const gphys_triangle triangle{at, at + random.point(2), at + random.point(2)};
            if (i % 4 == 3) models.add(GPHYS_SHAPE_TRIANGLE, &triangle, test::at(0, 0, 0));
        }
    }
    for (int i = 0; i < 2; ++i) {
        const gphys_plane plane{{1, 1, 1}, i == 0 ? -6.f : -3.f};
        models.add(GPHYS_SHAPE_PLANE, &plane, i == 0 ? test::at(0, 0, 0) : test::at(-1, -1, -1));
    }
    std::vector<gphys_ray> rays;
    std::vector<gphys_segment> ways;
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 6000; ++i) {
        const gphys_vec3 target = shared[random.index(8)], from = target + narrow(2.5 * random.direction());
        rays.push_back(ray_to(random, target, from));
        ways.push_back(segment_to(target, from));
        points.push_back(from);
    }
    const Tally of_rays = compare_rays(models, rays), of_sweeps = compare_sweeps(models, ways, 0.2f),
                of_points = compare_nearest(models, points, INFINITY);
    CHECK(of_rays.wrong == 0);
    CHECK(of_rays.tied > 2000);
    CHECK(of_sweeps.wrong == 0);
    CHECK(of_sweeps.tied > 2000);
    CHECK(of_points.wrong == 0);
    CHECK(of_points.tied > 2000);
    CHECK(wrong_lists(models, rays) == 0);
}

TEST_CASE("where all of a scene is reported at the largest t, or at none, the lowest id is met") {
    Random random(64);
    Models models;
    for (const int i : {3, 1, 4, 0, 2}) {
        const gphys_aabb box{{1e-32f * static_cast<float>(i), 0, 0}, {1 + static_cast<float>(i), 1, 1}};
        models.add(GPHYS_SHAPE_AABB, &box, test::at(0, 0, 0));
        const gphys_sphere ball{{20 + static_cast<float>(i), 0, 0}, 2};
        models.add(GPHYS_SHAPE_SPHERE, &ball, test::at(0, 0, 0));
    }
    std::vector<gphys_ray> beyond, at_once;
    for (int i = 0; i < 500; ++i) {
        const gphys_vec3 from = random.point(1) + gphys_vec3{-60, 0.5f, 0.5f};
        beyond.push_back({from, {1e-38f, random.uniform_float(0, 1e-40f), 0}, INFINITY});
        const gphys_vec3 before{-1e-32f, random.uniform_float(0, 1), random.uniform_float(0, 1)};
        at_once.push_back({before, {1e15f, random.uniform_float(0, 1e15f), 0}, INFINITY});
    }
    const Tally of_beyond = compare_rays(models, beyond), of_at_once = compare_rays(models, at_once);
    CHECK(of_beyond.wrong == 0);
    CHECK(of_beyond.tied > 300);
    CHECK(of_at_once.wrong == 0);
    CHECK(of_at_once.tied > 300);
    CHECK(wrong_lists(models, beyond) == 0);
    CHECK(wrong_lists(models, at_once) == 0);
}

TEST_CASE("meshes of a scene that touch and coincide give the lowest id, and each its lowest triangle") {
    Random random(65);
    const test::Arrays sheet = test::grid(4), ball = test::sphere(2);
    const auto make = [](const test::Arrays& arrays) {
        gphys_mesh* mesh = nullptr;
        REQUIRE(gphys_mesh_create(nullptr, &arrays.vertices[0].x, 12, static_cast<uint32_t>(arrays.vertices.size()),
                                  arrays.indices.data(), static_cast<uint32_t>(arrays.indices.size()),
                                  &mesh) == GPHYS_OK);
        return mesh;
    };
    gphys_mesh *sheets = make(sheet), *balls = make(ball);
    Models models;
    models.use_slots(1023 + 10);
    const gphys_transform place = awkward_place(true);
    // Below a parent and not, in one piece and in quarters of half the size, twice.
    const gphys_sphere far{{500, 0, 0}, 0};
    models.add(GPHYS_SHAPE_SPHERE, &far, place);
    const gphys_model_id parent = models.first_id();
    for (int twice = 0; twice < 2; ++twice) {
        for (int quarter = 3; quarter >= 0; --quarter) {
            const gphys_vec3 at{2.f * static_cast<float>(quarter % 2), 2.f * static_cast<float>(quarter / 2), 0};
            models.add(GPHYS_SHAPE_MESH, sheets, {at, test::no_rotation, 0.5f}, parent);
        }
        models.add(GPHYS_SHAPE_MESH, sheets, place);
        models.add(GPHYS_SHAPE_MESH, balls, {{2, 2, 0.5f}, test::no_rotation, 1}, parent);
    }
    std::vector<gphys_ray> rays;
    std::vector<gphys_segment> ways;
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 6000; ++i) {
        const gphys_vec3 at{0.5f * static_cast<float>(random.index(9)), 0.5f * static_cast<float>(random.index(9)), 0};
        const gphys_vec3 target =
            placed(place, i % 3 == 0 ? ball.vertices[random.index(66)] + gphys_vec3{2, 2, 0.5f} : at);
        const gphys_vec3 from = target + random.point(random.index(4) ? 6 : 600);
        rays.push_back(ray_to(random, target, from));
        ways.push_back(segment_to(target, from));
        points.push_back(placed(place, at + gphys_vec3{0, 0, random.uniform_float(-2, 2)}));
    }
    const Tally of_rays = compare_rays(models, rays), of_segments = compare_segments(models, ways),
                of_sweeps = compare_sweeps(models, ways, 0.2f), of_points = compare_nearest(models, points, INFINITY);
    CHECK(of_rays.wrong == 0);
    CHECK(of_rays.tied > 1000);
    CHECK(of_segments.wrong == 0);
    CHECK(of_segments.tied > 300);
    CHECK(of_sweeps.wrong == 0);
    CHECK(of_sweeps.tied > 1000);
    CHECK(of_points.wrong == 0);
    CHECK(of_points.tied > 1000);
    CHECK(wrong_lists(models, rays) == 0);
    gphys_mesh_destroy(sheets);
    gphys_mesh_destroy(balls);
}

TEST_CASE("of the triangles of a placed mesh at equal distance in the scene the lowest is nearest") {
    Random random(67);
    const test::Arrays arrays = test::sphere(2);
    Mesh* const mesh = arrays.make();
    int tied = 0, wrong = 0, wrong_in_reach = 0;
    for (const bool turned : {false, true}) {
        const gphys_transform place = awkward_place(turned);
        const Transform world = widen(place);
        const SceneHolder scene = make_scene();
        gphys_model_id id = 0;
        REQUIRE(gphys_scene_add(scene.get(), GPHYS_SHAPE_MESH, wrap(mesh), &place, nullptr, &id) == GPHYS_OK);
        for (int i = 0; i < 4000; ++i) {
            // Above a vertex that triangles share, on it, or far away.
            const gphys_vec3 vertex = arrays.vertices[random.index(static_cast<uint32_t>(arrays.vertices.size()))];
            const float height = i % 4 == 0 ? 0 : i % 4 == 1 ? 900 : random.uniform_float(0, 2);
            const gphys_vec3 point = placed(place, (1 + height) * vertex);
            const Vec3 local = world.inverse_apply(widen(point));
            gphys_nearest expected{}, found{}, in_reach{};
            expected.distance = INFINITY;
            int as_near = 0;
            for (uint32_t triangle = 0; triangle < mesh->triangle_count(); ++triangle) {
                const Vec3 closest = world.apply(closest_point(mesh->triangle(triangle), local));
                const gphys_nearest one = to_nearest(closest, distance(closest, widen(point)), triangle, id, 0);
                if (one.distance < expected.distance) expected = one, as_near = 0;
                as_near += one.distance == expected.distance;
            }
            tied += as_near > 1;
            gphys_scene_nearest(scene.get(), &point, INFINITY, GPHYS_ALL_LAYERS, &found);
            wrong += !same_bits(found, expected);
            const float reach = std::nextafter(expected.distance, INFINITY);
            gphys_scene_nearest(scene.get(), &point, reach, GPHYS_ALL_LAYERS, &in_reach);
            wrong_in_reach += !same_bits(in_reach, expected);
        }
    }
    CHECK(tied > 4000);
    CHECK(wrong == 0);
    CHECK(wrong_in_reach == 0);
    Mesh::release(mesh);
}

TEST_CASE("of triangles of a mesh at equal t or distance the lowest is met and nearest, on every processor") {
    Random random(66);
    // Corners and edges that six and more triangles share, far from the origin and at no round numbers.
    test::Arrays arrays = test::sphere(2);
    for (gphys_vec3& v : arrays.vertices) v = placed(awkward_place(true), 7 * v);
    // In no order.
    for (size_t i = arrays.indices.size() / 3; i > 1; --i) {
        const size_t j = random.index(static_cast<uint32_t>(i));
        std::swap_ranges(arrays.indices.begin() + 3 * static_cast<std::ptrdiff_t>(i - 1),
                         arrays.indices.begin() + 3 * static_cast<std::ptrdiff_t>(i),
                         arrays.indices.begin() + 3 * static_cast<std::ptrdiff_t>(j));
    }
    for (const Isa isa : test::isas()) {
        INFO(name_of(isa));
        Mesh* const mesh = arrays.make(nullptr, isa);
        int tied = 0, tied_points = 0, wrong = 0, wrong_in_group = 0, wrong_points = 0, wrong_sweeps = 0;
        for (int i = 0; i < test::tries(300); ++i) {
            gphys_ray rays[Mesh::rays_at_once];
            gphys_hit hits[Mesh::rays_at_once], expected[Mesh::rays_at_once];
            const gphys_ray* each[Mesh::rays_at_once];
            gphys_hit* out[Mesh::rays_at_once];
            uint64_t met = 0;
            const gphys_vec3 eye = random.point(20);
            for (uint32_t k = 0; k < Mesh::rays_at_once; ++k) {
                const uint32_t* corner = arrays.indices.data() + 3 * random.index(mesh->triangle_count());
                const gphys_vec3 a = arrays.vertices[corner[0]], b = arrays.vertices[corner[1]];
                const gphys_vec3 target = random.index(2) ? a : a + random.uniform_float(0, 1) * (b - a);
                rays[k] = i % 2 ? ray_to(random, target, target + random.point(random.index(4) ? 9 : 900))
                                : gphys_ray{eye, target - eye, INFINITY};
                each[k] = rays + k;
                out[k] = hits + k;
                Hit first;
                int at_once = 0;
                for (uint32_t triangle = 0; triangle < mesh->triangle_count(); ++triangle) {
                    Hit hit;
                    if (!raycast(mesh->triangle(triangle), widen(rays[k]), hit)) continue;
                    hit.triangle = triangle;
                    const bool none = first.triangle == GPHYS_NO_TRIANGLE;
                    if (!none && reported(hit.t) > reported(first.t)) continue;
                    at_once = none || reported(hit.t) < reported(first.t) ? 1 : at_once + 1;
                    if (at_once == 1) first = hit;
                }
                tied += at_once > 1;
                expected[k] = to_hit(first);
                met |= uint64_t{first.triangle != GPHYS_NO_TRIANGLE} << k;
                Hit alone;
                const bool found = mesh->raycast(widen(rays[k]), alone);
                wrong +=
                    found != (first.triangle != GPHYS_NO_TRIANGLE) || (found && !same_bits(to_hit(alone), expected[k]));

                const Vec3 point = widen(k % 2 ? target : rays[k].origin);
                Vec3 closest;
                uint32_t nearest = 0, expected_nearest = 0;
                float least = INFINITY;
                int as_near = 0;
                mesh->closest_point(point, infinity, closest, nearest);
                for (uint32_t triangle = 0; triangle < mesh->triangle_count(); ++triangle) {
                    const float far = reported(distance(closest_point(mesh->triangle(triangle), point), point));
                    if (far < least) expected_nearest = triangle, least = far, as_near = 0;
                    as_near += far == least;
                }
                tied_points += as_near > 1;
                wrong_points += nearest != expected_nearest;
            }
            const uint64_t found = mesh->raycast_many(each, Mesh::rays_at_once, out);
            wrong_in_group += found != met;
            for (uint32_t k = 0; k < Mesh::rays_at_once; ++k) {
                wrong_in_group += (found >> k & 1) != 0 && !same_bits(hits[k], expected[k]);
            }
            for (uint32_t k = 0; k < 8; ++k) {
                const Sphere moving{widen(rays[k].origin), 0.3};
                const Vec3 way = widen(rays[k].direction);
                Hit first, hit;
                for (uint32_t triangle = 0; triangle < mesh->triangle_count(); ++triangle) {
                    Hit candidate;
                    if (!sweep(mesh->triangle(triangle), moving, way, candidate)) continue;
                    candidate.triangle = triangle;
                    const bool none = first.triangle == GPHYS_NO_TRIANGLE;
                    if (none || reported(candidate.t) < reported(first.t)) first = candidate;
                }
                mesh->sweep(moving, way, hit);
                wrong_sweeps += hit.triangle != first.triangle;
            }
        }
        CHECK(tied > test::tries(500));
        CHECK(tied_points > test::tries(5000));
        CHECK(wrong == 0);
        CHECK(wrong_in_group == 0);
        CHECK(wrong_points == 0);
        CHECK(wrong_sweeps == 0);
        Mesh::release(mesh);
    }
}

TEST_CASE("of layers of a mesh that are closer than floats can tell from far away the lowest index is the answer") {
    constexpr uint32_t layers = 100;
    Random random(68);
    test::Arrays arrays;
    for (uint32_t i = 0; i < layers; ++i) {
        const float z = 5 + 1e-5f * static_cast<float>(layers - 1 - i * 37 % layers),
                    x = random.uniform_float(-0.1f, 0.1f);
        arrays.vertices.insert(arrays.vertices.end(), {{x - 2, -1, z}, {x + 2, -1, z}, {x, 2, z}});
        arrays.add(3 * i, 3 * i + 1, 3 * i + 2);
    }
    for (const Isa isa : test::isas()) {
        INFO(name_of(isa));
        Mesh* const mesh = arrays.make(nullptr, isa);
        int tied = 0, wrong_rays = 0, wrong_sweeps = 0, wrong_points = 0;
        for (int i = 0; i < 200; ++i) {
            const Vec3 from = widen(gphys_vec3{random.uniform_float(-0.2f, 0.2f), random.uniform_float(-0.2f, 0.2f),
                                               random.uniform_float(-2000, -1000)});
            const Vec3 way{0, 0, 2 * std::fabs(from.z)};
            const Sphere ball{from, 0.25};
            const auto first_by = [&](const auto& far_of_triangle) {
                uint32_t first = GPHYS_NO_TRIANGLE;
                float least = INFINITY;
                for (uint32_t k = 0; k < layers; ++k) {
                    const float far = reported(far_of_triangle(mesh->triangle(k)));
                    tied += far == least;
                    if (far < least) least = far, first = k;
                }
                return first;
            };
            Hit hit;
            Vec3 closest;
            uint32_t nearest = 0;
            REQUIRE(mesh->raycast({from, way, 1}, hit));
            wrong_rays += hit.triangle != first_by([&](const Triangle& triangle) {
                              Hit one;
                              return raycast(triangle, {from, way, 1}, one) ? one.t : infinity;
                          });
            REQUIRE(mesh->sweep(ball, way, hit));
            wrong_sweeps += hit.triangle != first_by([&](const Triangle& triangle) {
                                Hit one;
                                return sweep(triangle, ball, way, one) ? one.t : infinity;
                            });
            REQUIRE(mesh->closest_point(from, infinity, closest, nearest));
            wrong_points += nearest != first_by([&](const Triangle& triangle) {
                                return distance(closest_point(triangle, from), from);
                            });
        }
        CHECK(tied > 2000);
        CHECK(wrong_rays == 0);
        CHECK(wrong_sweeps == 0);
        CHECK(wrong_points == 0);
        Mesh::release(mesh);
    }
}
