// The C++ headers: every function with an answer that is known, batches against single calls, errors, ownership.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

#include <gamephys.hpp>

#include <cmath>
#include <cstring>
#include <limits>

using namespace gamephys;

namespace {

constexpr float INF = std::numeric_limits<float>::infinity();
const Vec3 zero{0, 0, 0}, up{0, 1, 0};
const Quat still{0, 0, 0, 1};
const Transform identity{zero, still, 1};
const Sphere ball{{0, 0, 5}, 1};
const Ray ahead{zero, {0, 0, 1}, 100};

template <class T>
bool same(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool near(const Vec3& a, const Vec3& b, float tolerance = 1e-5f) {
    return std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance && std::abs(a.z - b.z) <= tolerance;
}

Mesh pyramid() {
    const std::vector<float> vertices{-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, 2, 0};
    const std::vector<uint32_t> indices{0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4};
    const MeshDesc desc = mesh_desc();
    return Mesh(Span<const float>(vertices.data(), 5, 12), indices, &desc);
}

template <class Call>
std::string failure(gphys_status status, Call call) {
    try {
        call();
    } catch (const Error& error) {
        CHECK(error.status == status);
        return error.what();
    }
    FAIL("an error was expected");
    return {};
}

}  // namespace

TEST_CASE("shapes") {
    validate(ball);
    CHECK(same(*bounds(ball), Aabb{{-1, -1, 4}, {1, 1, 6}}));
    CHECK_FALSE(bounds(Plane{up, 0}));
    CHECK(near(transform(Aabb{zero, {2, 2, 2}}, Transform{{1, 0, 0}, still, 1}).center, {2, 1, 1}));
    CHECK(contains(ball, {0, 0, 4}, 0));
    CHECK_FALSE(contains(ball, {0, 0, 3.5f}, 0));
    const std::vector<Vec3> points{{0, 0, 5}, zero};
    std::vector<int32_t> inside(2);
    contains_batch(ball, points, 0, inside);
    CHECK(inside == std::vector<int32_t>{1, 0});
    CHECK(closest_point(ball, zero)->distance == 4);
    std::vector<Nearest> nearest(2);
    closest_point_batch(ball, points, nearest);
    CHECK(nearest[1].distance == 4);
    const auto [a, b, distance] = segment_closest_points({zero, {2, 0, 0}}, {{1, 3, -1}, {1, 3, 1}});
    CHECK((near(a, {1, 0, 0}) && near(b, {1, 3, 0}) && distance == 3));
    CHECK(overlaps(ball, Aabb{zero, {1, 1, 4}}));
    CHECK_FALSE(overlaps(ball, Aabb{zero, {1, 1, 3}}));
    const std::vector<Sphere> balls{{zero, 1}, {{0, 9, 0}, 1}};
    overlaps_batch(balls, Plane{up, 0}, inside);
    CHECK(inside == std::vector<int32_t>{1, 0});
    CHECK(classify_plane(ball, {{0, 0, 1}, 0}) == std::make_tuple(GPHYS_SIDE_INSIDE, 4.0f));
    CHECK(raycast(ball, ahead)->t == 4);
    CHECK_FALSE(raycast(ball, {{0, 3, 0}, {0, 0, 1}, 9}));
    std::vector<Hit> hits(1);
    raycast_batch(ball, std::vector<Ray>{ahead}, hits);
    CHECK(hits[0].t == 4);
    CHECK(segment_test(ball, {zero, {0, 0, 8}})->t == 0.5f);
    CHECK(sweep_sphere(ball, {zero, 1}, {0, 0, 10})->t == Approx(0.3f));
}

TEST_CASE("frusta") {
    const CameraDesc desc = camera_desc();
    const Camera camera(&desc);
    const Frustum frustum = camera.get_frustum();
    CHECK(classify_frustum(ball, frustum) == GPHYS_SIDE_INSIDE);
    const auto corners = frustum_corners(frustum);
    CHECK(near((*corners)[3], (*camera.get_corners())[3]));
    const Frustum again = frustum_from_matrix(camera.get_view_projection_matrix(), GPHYS_DEPTH_ZERO_TO_ONE, false);
    CHECK(classify_frustum(Sphere{{0, 0, -5}, 1}, again) == GPHYS_SIDE_OUTSIDE);
}

TEST_CASE("meshes") {
    const std::vector<float> vertices{0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::vector<uint32_t> indices{0, 1, 7};
    CHECK(mesh_check(Span<const float>(vertices.data(), 3, 12), indices).out_of_range_count == 1);
    const Mesh mesh = pyramid();
    CHECK(mesh.get_report().open_edge_count == 0);
    CHECK(near(mesh.get_vertices().at(4), {0, 2, 0}));
    CHECK(mesh.get_indices().size() == 18);
    CHECK(Mesh(mesh.get_snapshot()).get_indices() == mesh.get_indices());
    const Ray down{{0.3f, 5, 0.2f}, {0, -1, 0}, 10};
    const std::vector<Hit> hits = mesh.raycast_all(down);
    REQUIRE(hits.size() == 2);
    CHECK((hits[0].t < hits[1].t && hits[1].t == 5 && mesh.raycast_any(down)));
    CHECK(mesh.overlap(Sphere{{0, 2, 0}, 0.1f}).size() == 4);
    CHECK(mesh.get_octree_stats().item_count == 6);
    CHECK(mesh.get_octree_boxes().at(0).depth == 0);
    CHECK(raycast(mesh, down)->triangle == hits[0].triangle);
    const std::vector<Ray> two{down, {{9, 9, 9}, up, INF}};
    std::vector<int32_t> any(2);
    std::vector<Distance> distances(2);
    mesh.raycast_any_batch(two, any);
    mesh.raycast_distance_batch(two, distances);
    CHECK((any[0] == 1 && any[1] == 0));
    CHECK((distances[0].t == hits[0].t && distances[0].triangle == hits[0].triangle && distances[1].t == INF));
}

TEST_CASE("ids with a step between them are refused") {
    Scene scene;
    std::vector<gphys_model_id> models(6);
    for (gphys_model_id& model : models) model = scene.add(ball, nullptr, nullptr);
    const Span<const gphys_model_id> every_other(models.data(), 3, 8);
    std::vector<Transform> places(3, identity);
    CHECK_THROWS_AS(scene.remove_batch(every_other), std::invalid_argument);
    CHECK_THROWS_AS(scene.set_transforms(every_other, places), std::invalid_argument);
    CHECK_THROWS_AS(scene.get_transforms(every_other, places), std::invalid_argument);
    const Span<gphys_model_id> room(models.data(), 3, 8);
    CHECK_THROWS_AS(scene.add_batch(std::vector<Sphere>(3, ball), {}, nullptr, room), std::invalid_argument);
    const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::vector<uint32_t> indices{0, 9, 1, 9, 2, 9};
    CHECK_THROWS_AS(Mesh(Span<const float>(corners.data(), 3, 12), Span<const uint32_t>(indices.data(), 3, 8)),
                    std::invalid_argument);
    CHECK(scene.get_models() == models);
    scene.remove_batch(
        Span<const gphys_model_id>(&models[4], 1, 8));  // there is nothing between one element and the next
    CHECK(scene.get_models().size() == 5);
}

TEST_CASE("an array without elements is not one that is left out") {
    Scene scene;
    const std::vector<Ray> no_rays;
    const std::vector<Transform> no_places;
    std::vector<Hit> no_hits;
    std::vector<gphys_model_id> models;
    scene.raycast_batch(no_rays, GPHYS_ALL_LAYERS, no_hits);
    scene.set_transforms(models, no_places);
    scene.add_batch(std::vector<Sphere>{}, no_places, nullptr, models);
    CHECK(scene.overlap_batch(std::vector<Sphere>{}, GPHYS_ALL_LAYERS).values.empty());
    CHECK(scene.cull_batch(std::vector<Frustum>{}, GPHYS_ALL_LAYERS).values.empty());
    models.resize(3);
    try {
        scene.add_batch(std::vector<Sphere>(3, ball), no_places, nullptr, models);
        FAIL("arrays of different lengths");
    } catch (const std::invalid_argument& error) {
        CHECK(std::string(error.what()) == "arrays of different lengths: 3 and 0");
    }
    CHECK(scene.get_models().empty());
    scene.add_batch(std::vector<Sphere>(3, ball), {}, nullptr, models);
    scene.add_batch(std::vector<Sphere>(3, ball), nullptr, nullptr, models);
    CHECK(scene.get_models().size() == 6);
}

TEST_CASE("models with descs of their own") {
    Scene scene;
    const std::vector<Sphere> three(3, ball);
    const gphys_model_id root = scene.add(ball);
    std::vector<gphys_model_id> models(3);
    std::vector<ModelDesc> some(3, model_desc());
    some[0].parent = root;
    some[0].layers = 2;
    some[0].tag = 5;
    some[1].tag = 6;
    using Read = std::array<uint32_t, 3>;
    const Read first{root, 2, 5}, second{0, 1, 6}, third{0, 1, 0};
    const auto read_back = [&] {
        std::vector<Read> read;
        for (const gphys_model_id model : models) {
            const ModelInfo info = scene.get_info(model);
            read.push_back({info.parent, info.layers, info.tag});
        }
        return read;
    };
    scene.add_described_batch(three, {}, some, models);
    CHECK(read_back() == std::vector<Read>{first, second, third});
    scene.add_described_batch(ball, {}, some, models);
    CHECK(read_back() == std::vector<Read>{first, second, third});
    scene.add_described_batch(three, identity, some[0], models);
    CHECK(read_back() == std::vector<Read>(3, first));
    scene.add_described_batch(three, {}, {}, models);
    CHECK(read_back() == std::vector<Read>(3, third));
    const size_t count = scene.get_models().size();
    CHECK_THROWS_AS(scene.add_described_batch(three, {}, std::vector<ModelDesc>(2, model_desc()), models),
                    std::invalid_argument);
    CHECK_THROWS_AS(scene.add_described_batch(three, {}, std::vector<ModelDesc>(3), models), Error);
    some[2].parent = 12345;
    CHECK_THROWS_AS(scene.add_described_batch(three, {}, some, models), Error);
    CHECK(scene.get_models().size() == count);
}

TEST_CASE("models") {
    SceneDesc desc = scene_desc();
    desc.worker_count = 2;
    Scene scene(&desc);
    ModelDesc tagged = model_desc();
    tagged.tag = 7;
    const uint32_t model = scene.add(ball, nullptr, &tagged);
    std::vector<gphys_model_id> two(2);
    scene.add_batch(std::vector<Sphere>{{{9, 0, 0}, 1}, {{9, 5, 0}, 2}}, {}, nullptr, two);
    CHECK((scene.has(model) && scene.has(two[1]) && !scene.has(12345)));
    CHECK(scene.get_models().size() == 3);
    CHECK(scene.get_info(model).tag == 7);
    CHECK(same(scene.get_shape<Sphere>(two[1]), Sphere{{9, 5, 0}, 2}));
    CHECK_THROWS_AS(scene.get_shape<Capsule>(two[1]), std::invalid_argument);
    CHECK(scene.get_bounds(two[0])->max.x == 10);
    CHECK(scene.get_scene_bounds()->max.y == 7);
    scene.set_layers(model, 4);
    scene.set_tag(model, 8);
    CHECK_FALSE(scene.raycast(ahead, 3));
    CHECK(scene.raycast(ahead, 4)->tag == 8);
    scene.set_parent(two[0], model, true);
    scene.set_transform(model, {up, still, 1});
    CHECK(scene.get_info(two[0]).parent == model);
    const std::vector<gphys_model_id> ids{model, two[0]};
    std::vector<Transform> places(2);
    scene.get_transforms(ids, places);
    CHECK((places[0].position.y == 1 && places[1].position.y == 0));
    scene.get_world_transforms(ids, places);
    CHECK(places[1].position.y == 1);
    scene.set_transforms(ids, std::vector<Transform>{identity, identity});
    scene.get_world_transforms(ids, places);
    CHECK(places[1].position.y == 0);
    scene.validate();
    scene.remove_subtree(model);
    CHECK_FALSE(scene.has(two[0]));
    scene.remove_batch(std::vector<gphys_model_id>{two[1]});
    CHECK_FALSE(scene.get_scene_bounds());
    scene.remove(scene.add(ball));
    scene.add(ball);
    scene.rebuild_octree();
    CHECK(scene.maintain_octree(1000));
    scene.set_worker_count(2);
    CHECK(scene.get_worker_count() == 2);
    scene.clear();
    CHECK(scene.get_models().empty());
    scene.set_origin({1e9 + 0.5, 0, 0});
    CHECK(scene.get_origin() == std::array<double, 3>{1e9 + 0.5, 0, 0});
}

TEST_CASE("batches answer as single calls do") {
    Scene scene;
    const auto at = [](float i) { return Vec3{3 * std::sin(i), 3 * std::cos(2 * i), i / 3}; };
    for (int i = 0; i < 30; ++i) scene.add(Sphere{at(static_cast<float>(i)), 0.7f});
    const size_t count = 200;
    std::vector<Vec3> directions(count);
    std::vector<Ray> rays(count);
    std::vector<Segment> segments(count);
    const std::vector<Sphere> spheres(count, Sphere{{0, 0, -5}, 0.2f});
    for (size_t i = 0; i < count; ++i) {
        const float angle = static_cast<float>(i);
        directions[i] = {std::sin(angle) / 2, std::cos(3 * angle) / 2, 1};
        rays[i] = {{0, 0, -5}, directions[i], INF};
        segments[i] = {{0, 0, -5}, {10 * directions[i].x, 10 * directions[i].y, 5}};
    }
    std::vector<Hit> hits(count), tested(count), swept(count);
    std::vector<Nearest> nearest(count);
    std::vector<int32_t> any(count);
    scene.raycast_batch(rays, GPHYS_ALL_LAYERS, hits);
    scene.segment_test_batch(segments, GPHYS_ALL_LAYERS, tested);
    scene.sweep_sphere_batch(spheres, directions, GPHYS_ALL_LAYERS, swept);
    scene.nearest_batch(directions, INF, GPHYS_ALL_LAYERS, nearest);
    scene.raycast_any_batch(rays, GPHYS_ALL_LAYERS, any);
    std::vector<Distance> distances(count);
    scene.raycast_distance_batch(rays, GPHYS_ALL_LAYERS, distances);
    for (size_t i = 0; i < count; ++i) CHECK((distances[i].t == hits[i].t && distances[i].model == hits[i].model));
    const auto [all, offsets] = scene.raycast_all_batch(rays);
    const auto agree = [](const Hit& batched, const std::optional<Hit>& single) {
        return single ? same(*single, batched) : batched.model == 0;
    };
    size_t met = 0;
    for (size_t i = 0; i < count; ++i) {
        CHECK(agree(hits[i], scene.raycast(rays[i])));
        CHECK(agree(tested[i], scene.segment_test(segments[i])));
        CHECK(agree(swept[i], scene.sweep_sphere(spheres[i], directions[i])));
        CHECK(same(nearest[i], *scene.nearest(directions[i], INF)));
        CHECK((any[i] != 0) == scene.raycast_any(rays[i]));
        CHECK(scene.raycast_all(rays[i]).size() == offsets[i + 1] - offsets[i]);
        met += any[i] != 0;
    }
    CHECK((met > 0 && met < count));
    struct Tagged {
        uint32_t mark;
        Hit hit;
    };
    std::vector<Tagged> wide(count, {5, {}});
    scene.raycast_batch(rays, GPHYS_ALL_LAYERS, Span<Hit>(&wide[0].hit, count, sizeof(Tagged)));
    CHECK((same(wide.back().hit, hits.back()) && wide.back().mark == 5));
}

TEST_CASE("filters have lists of models, and batches a filter for each item") {
    Scene scene;
    std::vector<gphys_model_id> models;
    for (int i = 0; i < 4; ++i) models.push_back(scene.add(Sphere{{0, 0, 4 * float(i)}, 1}));
    const std::vector<Ray> rays(3, Ray{{0, 0, -5}, {0, 0, 1}, INF});
    const QueryFilterDesc filter = query_filter_desc(Span<const gphys_model_id>(models.data(), 2));
    CHECK(filter.ignored_count == 2);
    CHECK(scene.raycast_filtered(rays[0], &filter)->model == models[2]);
    CHECK(!scene.raycast_any_filtered(rays[0], std::array{query_filter_desc(models)}.data()));
    CHECK_THROWS_AS(query_filter_desc(Span<const gphys_model_id>(models.data(), 2, 8)), std::invalid_argument);

    std::vector<QueryFilterDesc> each(3, query_filter_desc());
    each[1].ignored_model = models[0];
    each[2] = filter;
    std::vector<Hit> hits(3);
    const auto met = [&hits] { return std::vector{hits[0].model, hits[1].model, hits[2].model}; };
    scene.raycast_filtered_batch(rays, each, hits);
    CHECK(met() == std::vector(models.begin(), models.begin() + 3));
    scene.raycast_filtered_batch(rays, filter, hits);
    CHECK(met() == std::vector(3, models[2]));
    scene.raycast_filtered_batch(rays, nullptr, hits);
    CHECK(met() == std::vector(3, models[0]));
    const Sphere ball{{0, 0, 2}, 2};
    CHECK(scene.overlap_filtered_batch(ball, each).offsets == std::vector<uint32_t>{0, 2, 3, 3});
    each.pop_back();
    CHECK_THROWS_AS(scene.raycast_filtered_batch(rays, each, hits), std::invalid_argument);
}

TEST_CASE("filters leave out models") {
    Scene scene;
    ModelDesc on_body = model_desc();
    const gphys_model_id body = on_body.parent = scene.add(ball);
    const Transform at_head{{0, 0, 3}, still, 1}, far_off{{0, 0, 10}, still, 1};
    scene.add(ball, &at_head, &on_body);
    const gphys_model_id target = scene.add(ball, &far_off);
    QueryFilterDesc filter = query_filter_desc();
    filter.ignored_model = body;
    filter.flags = GPHYS_FILTER_SUBTREE;
    const std::vector<Ray> rays(2, Ray{zero, {0, 0, 1}, INF});
    const std::vector<Segment> segments(2, Segment{zero, {0, 0, 20}});
    const std::vector<Sphere> moving(2, Sphere{zero, 0.5f}), large(2, Sphere{zero, 50});
    const std::vector<Vec3> ways(2, Vec3{0, 0, 20});
    const std::vector<gphys_model_id> one{target}, two{target, target};
    CHECK(scene.raycast_filtered(rays[0], nullptr)->model == body);
    CHECK(scene.raycast_filtered(rays[0], &filter)->model == target);
    CHECK(scene.segment_test_filtered(segments[0], &filter)->model == target);
    CHECK(scene.nearest_filtered(zero, INF, &filter)->model == target);
    CHECK(scene.sweep_sphere_filtered(moving[0], ways[0], &filter)->model == target);
    CHECK(scene.raycast_any_filtered(rays[0], &filter));
    CHECK(scene.raycast_all_filtered(rays[0], &filter).size() == 1);
    CHECK(scene.overlap_filtered(large[0], &filter) == one);
    std::vector<Hit> hits(2);
    std::vector<Nearest> nearest(2);
    std::vector<int32_t> any(2);
    scene.raycast_filtered_batch(rays, filter, hits);
    CHECK(hits[1].model == target);
    scene.segment_test_filtered_batch(segments, filter, hits);
    CHECK(hits[1].model == target);
    scene.sweep_sphere_filtered_batch(moving, ways, filter, hits);
    CHECK(hits[1].model == target);
    scene.nearest_filtered_batch(ways, INF, filter, nearest);
    CHECK(nearest[1].model == target);
    scene.raycast_any_filtered_batch(rays, filter, any);
    CHECK(any[1] == 1);
    std::vector<Distance> distances(2);
    scene.raycast_distance_filtered_batch(rays, filter, distances);
    CHECK(distances[1].model == target);
    const auto [all, hit_ends] = scene.raycast_all_filtered_batch(rays, filter);
    CHECK((all.size() == 2 && hit_ends.back() == 2));
    const auto [found, ends] = scene.overlap_filtered_batch(large, filter);
    CHECK((found == two && ends.back() == 2));
    Camera camera;
    camera.look_at({0, 0, -10}, zero, up);
    CHECK(camera.pick_filtered(scene, 400, 300, &filter)->model == target);
    const std::vector<float> mice{400, 300, 1, 1};
    camera.pick_filtered_batch(scene, Span<const float>(mice.data(), 2, 8), filter, hits);
    CHECK((hits[0].model == target && hits[1].model == 0));
    CHECK(camera.pick_rectangle_filtered(scene, 0, 0, 800, 600, &filter) == one);
    CHECK(camera.cull_filtered(scene, &filter) == one);
    CHECK(scene.cull_filtered(camera.get_frustum(), &filter) == one);
    const std::vector<Frustum> views(2, camera.get_frustum());
    CHECK((scene.cull_batch(views).offsets == std::vector<uint32_t>{0, 3, 6}));
    CHECK((scene.cull_filtered_batch(views, filter).offsets == std::vector<uint32_t>{0, 1, 2}));
}

TEST_CASE("solids move up to what they touch, and out of what they overlap") {
    const Sphere centred{zero, 1}, inside{{0, 0, 1.5f}, 1}, above{{0, 4, 0}, 1};
    CHECK(sweep(centred, above, {0, -4, 0})->t == 0.5f);
    CHECK(penetration(centred, inside)->depth == 0.5f);
    CHECK(!penetration(centred, above));
    Scene scene;
    scene.add(centred);
    const Transform far_off{{0, 0, 10}, still, 1};
    const gphys_model_id target = scene.add(centred, &far_off);
    QueryFilterDesc filter = query_filter_desc();
    filter.ignored_model = target;
    const std::vector<Sphere> moving(2, Sphere{{0, 0, 5}, 1});
    const std::vector<Vec3> ways(2, Vec3{0, 0, 6});
    const Sphere deep{{0, 0, 8.5f}, 1};
    CHECK(scene.sweep(moving[0], ways[0])->model == target);
    CHECK(!scene.sweep_filtered(moving[0], ways[0], &filter));
    std::vector<Hit> hits(2);
    scene.sweep_batch(moving, ways, GPHYS_ALL_LAYERS, hits);
    CHECK((hits[1].model == target && hits[1].t == 0.5f));
    scene.sweep_filtered_batch(moving, ways, filter, hits);
    CHECK(hits[1].model == 0);
    CHECK(scene.penetration(deep).at(0).depth == 0.5f);
    CHECK(scene.penetration_filtered(deep, &filter).empty());
    const std::vector<Sphere> crowd{deep, moving[0]};
    const auto [ways_out, ends] = scene.penetration_batch(crowd);
    CHECK((ways_out.size() == 1 && ways_out[0].model == target && ends == std::vector<uint32_t>{0, 1, 1}));
    CHECK(scene.penetration_filtered_batch(crowd, filter).offsets.back() == 0);
    sweep_batch(centred, std::vector<Sphere>{above, inside}, Vec3{0, -4, 0}, hits);
    CHECK((hits[0].t == 0.5f && hits[1].t == 0));
    std::vector<Penetration> outs(2);
    penetration_batch(centred, std::vector<Sphere>{inside, above}, outs);
    CHECK((outs[0].depth == 0.5f && outs[1].depth == -INF));
}

TEST_CASE("shapes change, trees and cameras are read") {
    Scene scene;
    ModelDesc on_body = model_desc();
    const gphys_model_id body = on_body.parent = scene.add(ball);
    const gphys_model_id head = scene.add(ball, nullptr, &on_body);
    scene.set_shape(body, Sphere{zero, 5});
    CHECK(scene.get_bounds(body)->max.x == 5);
    scene.set_scale(body, Vec3{2, 2, 2});
    CHECK(scene.get_bounds(body)->max.x == 10);
    CHECK(scene.get_scale(body).y == 2);
    CHECK(scene.get_roots() == std::vector<gphys_model_id>{body});
    CHECK(scene.get_children(body) == std::vector<gphys_model_id>{head});
    Camera camera;
    camera.set_orthographic(10, 1, 100);
    camera.set_viewport(200, 100);
    const auto [kind, size, from, to] = camera.get_projection();
    CHECK((kind == GPHYS_PROJECTION_ORTHOGRAPHIC && size == 10 && from == 1 && to == 100));
    const auto [width, height] = camera.get_viewport();
    CHECK((width == 200 && height == 100));
}

TEST_CASE("cameras see by aspect, in a window, from the near plane on") {
    Camera camera;
    camera.set_perspective_aspect(1, 2, 1, 100);
    const auto [aspect, fixed] = camera.get_aspect();
    CHECK((aspect == 2 && fixed));
    const auto [handedness, range, reverse_z] = camera.get_conventions();
    CHECK((handedness == GPHYS_LEFT_HANDED && range == GPHYS_DEPTH_ZERO_TO_ONE && reverse_z == 0));
    camera.set_orthographic_size(8, 6, 1, 100);
    const auto [width, height] = camera.get_image_size();
    CHECK((width == 8 && height == 6));
    camera.set_viewport_origin(800, 0);
    const auto [x, y] = camera.get_viewport_origin();
    CHECK((x == 800 && y == 0));
    CHECK(near(camera.pick_ray(1200, 300)->origin, {0, 0, 1}));
    camera.set_perspective(1, 1, 100);
    camera.set_pick_start(GPHYS_PICK_FROM_CENTRE);
    CHECK(camera.get_pick_start() == GPHYS_PICK_FROM_CENTRE);
    CHECK(near(camera.pick_ray(1200, 300)->origin, zero));
    camera.look_at({1, 2, 3}, zero, up);
    const Mat4 view = camera.get_view_matrix();
    camera.set_view_matrix(view);
    CHECK(mat4_orthonormality(view) < 1e-6f);
    CHECK(near(std::get<0>(camera.get_transform()), {1, 2, 3}));
    const auto corners = camera.get_rectangle_corners(800, 0, 1600, 600), all = camera.get_corners();
    for (int i = 0; i < 8; ++i) CHECK(near((*corners)[i], (*all)[i]));
    CHECK(near(camera.get_rectangle_frustum(800, 0, 1200, 600).origin, {1, 2, 3}));
    camera.set_orbit(orbit());
    camera.set_orbit_speeds({0.5f, 1, 2, 3, 4});
    CHECK(camera.get_orbit_speeds().pan_y == 4);
    camera.orbit_rotate(1, 0);
    camera.orbit_update();
    CHECK(camera.get_orbit().yaw == 0.5f);
    const Plane x1{{1, 0, 0}, 1}, y2{up, 2}, z3{{0, 0, 1}, 3};
    CHECK(near(*planes_intersection(x1, y2, z3), {1, 2, 3}));
    CHECK(!planes_intersection(x1, y2, y2));
    std::vector<Vec3> points(2);
    planes_intersection_batch(std::vector<Plane>{x1, x1}, std::vector<Plane>{y2, y2}, std::vector<Plane>{z3, y2},
                              points);
    CHECK((near(points[0], {1, 2, 3}) && points[1].x == INF));
}

TEST_CASE("a hull is a solid mesh") {
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1f, 0.1f, 0.1f}};
    const Mesh hull(Span<const float>(&corners[0].x, 5, 12));
    CHECK(hull.get_vertices().size() == 4);
    CHECK(hull.get_hull_planes().size() == 4);
    CHECK(hull.get_hull_faces() == std::vector<uint32_t>{0, 1, 2, 3});
    CHECK(contains(hull, corners[4], 0));
}

TEST_CASE("a mesh deforms, and its models with it") {
    MeshDesc desc = mesh_desc();
    desc.deformable = 1;
    std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto numbers = [&] { return Span<const float>(&corners[0].x, 3, 12); };
    Mesh mesh(numbers(), std::vector<uint32_t>{0, 1, 2}, &desc);
    Scene scene;
    const gphys_model_id model = scene.add(mesh);
    for (Vec3& corner : corners) corner.z = 7;
    mesh.set_vertices(numbers());
    CHECK(std::fabs(scene.get_bounds(model)->min.z - 7) < 1e-3f);
    CHECK(mesh.get_info().deformable == 1);
    // The mesh of a restored scene, met from behind, or not.
    Scene copy;
    copy.restore(nullptr, scene.get_snapshot(1));
    const MeshInfo info = Mesh(copy, model).get_info();
    CHECK((info.kind == GPHYS_MESH_SURFACE && info.vertex_count == 3 && info.triangle_count == 1));
    const Ray from_behind{{0.2f, 0.2f, 0}, {0, 0, 1}, INFINITY};
    QueryFilterDesc filter = query_filter_desc();
    filter.flags = GPHYS_FILTER_NO_FRONT_FACES;
    CHECK(copy.raycast_filtered(from_behind, &filter)->flags == GPHYS_HIT_BACK);
    filter.flags = GPHYS_FILTER_NO_BACK_FACES;
    CHECK(!copy.raycast_filtered(from_behind, &filter));
}

TEST_CASE("a rope is picked as a model that follows it") {
    Solver solver;
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, later{{0, 0, 7}, {1, 0, 7}, {2, 0, 7}};
    const gphys_body_id rope = solver.add_rope(points, 0);
    Scene scene;
    const gphys_model_id model = scene.add(Mesh(solver, rope));
    solver.set_positions(rope, 0, later);
    const auto hit = scene.raycast(Ray{{1.8f, 0, 0}, {0, 0, 1}, INFINITY});
    CHECK((hit && hit->model == model && hit->triangle == 1));
    CHECK(solver.get_nearest_particle(rope, hit->triangle, hit->point) == 2);
}

TEST_CASE("lists of any length") {
    Scene scene;
    std::vector<gphys_model_id> models(500);  // more than the first guess has room for
    scene.add_batch(std::vector<Sphere>(500, Sphere{zero, 0}), {}, nullptr, models);
    CHECK(scene.get_models() == models);
    const auto [found, offsets] =
        scene.overlap_batch(std::vector<Aabb>{{{-1, -1, -1}, {1, 1, 1}}, {{5, 5, 5}, {6, 6, 6}}});
    CHECK((found == models && offsets == std::vector<uint32_t>{0, 500, 500}));
    CHECK(scene.overlap(ball).empty());
    CHECK(scene.raycast_all(ahead).size() == 500);
    CHECK(scene.get_octree_stats().item_count == 500);
    CHECK(scene.get_octree_boxes().size() > 1);
}

TEST_CASE("camera") {
    Camera camera;
    camera.look_at({0, 0, -10}, zero, up);
    camera.set_perspective(1, 0.1f, 100);
    const Vec3 pixel = *camera.project(zero);
    CHECK(near(pixel, {400, 300, pixel.z}, 1e-2f));
    CHECK_FALSE(camera.project({0, 0, -20}));
    std::vector<Vec3> points{zero, {1, 1, 1}}, pixels(2);
    camera.project_batch(points, pixels);
    camera.unproject_batch(pixels, points);
    CHECK(near(points[1], {1, 1, 1}, 1e-2f));
    CHECK(near(*camera.unproject(pixels[1]), {1, 1, 1}, 1e-2f));
    CHECK(near(camera.pick_ray(400, 300)->direction, {0, 0, 1}));
    std::vector<Ray> rays(12);
    camera.pick_rays(0, 0, 4, 3, rays);
    CHECK(rays[11].direction.z > 0);

    Scene scene;
    const std::vector<gphys_model_id> one{scene.add(ball)};
    CHECK(camera.pick(scene, 400, 300)->model == one[0]);
    CHECK_FALSE(camera.pick(scene, 1, 1));
    std::vector<Hit> hits(2);
    const std::vector<float> mice{400, 300, 1, 1};
    camera.pick_batch(scene, Span<const float>(mice.data(), 2, 8), GPHYS_ALL_LAYERS, hits);
    CHECK((hits[0].model == one[0] && hits[1].model == 0));
    CHECK(camera.pick_rectangle(scene, 0, 0, 800, 600) == one);
    CHECK(camera.cull(scene) == one);
    CHECK(scene.cull(camera.get_frustum()) == one);

    camera.set_viewport(200, 100);
    camera.set_orthographic(10, 0.1f, 100);
    const Mat4 projection = camera.get_projection_matrix();
    CHECK(projection.m[5] == Approx(0.2f));
    camera.set_projection(projection);
    CHECK(camera.get_world_matrix().m[14] == -10);
    CHECK(camera.get_view_matrix().m[14] == Approx(10));
    camera.set_world_matrix({{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1}});
    CHECK(near(std::get<0>(camera.get_transform()), {4, 5, 6}));
    camera.set_transform({1, 2, 3}, {0, 1, 0, 0});
    CHECK(near(std::get<0>(camera.get_transform()), {1, 2, 3}));
    camera.set_origin({1, 0, 0});
    CHECK(camera.get_origin()[0] == 1);
}

TEST_CASE("orbit") {
    Camera camera;
    failure(GPHYS_ERROR_UNSUPPORTED, [&] { camera.get_orbit(); });
    camera.set_orbit(gamephys::orbit());
    camera.orbit_rotate(0.5f, 0.25f);
    camera.orbit_zoom(1);
    camera.orbit_pan(2, 0);
    camera.orbit_update();
    const Orbit orbit = camera.get_orbit();
    CHECK(near({orbit.yaw, orbit.pitch, orbit.distance}, {0.5f, 0.25f, 9}));
    CHECK(std::abs(orbit.target.x) == Approx(2));
}

TEST_CASE("particles") {
    Scene scene;
    SolverDesc desc = solver_desc();
    desc.substeps = 4;
    Solver solver(&desc);
    solver.set_gravity({0, -10, 0});
    solver.set_substeps(5);
    const auto free = solver.add_particles(std::vector<Vec3>{{0, 5, 0}, {1, 5, 0}});
    const auto state = [&](auto get, uint32_t first) {
        std::vector<Vec3> one(1);
        (solver.*get)(free, first, 1, one);
        return one[0];
    };
    solver.set_velocities(free, 1, std::vector<Vec3>{{3, 0, 0}});
    solver.step(&scene, 0.1f);
    CHECK(near(state(&Solver::get_velocities, 0), {0, -1, 0}));
    CHECK(near(state(&Solver::get_positions, 1), {1.3f, 4.95f, 0}));
    solver.set_masses(free, 0, std::vector<float>{2, 4});
    std::vector<float> masses(2);
    solver.get_masses(free, 0, 2, masses);
    CHECK(masses == std::vector<float>{2, 4});
    solver.set_forces(free, 0, std::vector<Vec3>{{0, 20, 0}, {0, 40, 0}});  // weightless
    solver.step(nullptr, 0.1f);
    CHECK(near(state(&Solver::get_velocities, 0), {0, -1, 0}));

    const auto plane = scene.add(Plane{up, 0});
    solver.set_radii(free, 0, std::vector<float>{0.5f, 0.5f});
    solver.set_positions(free, 0, std::vector<Vec3>{{0, 0.6f, 0}, {9, 0.6f, 0}});
    solver.set_forces(free, 0, std::vector<Vec3>{zero, zero});
    for (int i = 0; i < 30; ++i) solver.step(&scene, 0.02f);
    CHECK(state(&Solver::get_positions, 0).y == Approx(0.5f).margin(1e-3));
    const auto contacts = solver.get_contacts();
    REQUIRE(contacts.size() == 2);
    CHECK((contacts[0].model == plane && near(contacts[0].normal, up)));
    solver.set_origin({0, 1, 0});
    CHECK(solver.get_origin()[1] == 1);
    CHECK(state(&Solver::get_positions, 0).y == Approx(-0.5f).margin(1e-3));
}

TEST_CASE("rope and cloth") {
    Scene scene;
    Solver solver;
    const BodyDesc desc = body_desc();
    const auto rope = solver.add_rope(std::vector<Vec3>{{0, 8, 0}, {1, 8, 0}, {2, 8, 0}}, 0, &desc);
    CHECK(solver.get_body_info(rope).kind == GPHYS_BODY_ROPE);
    solver.set_pinned(rope, 0, 1, true);
    const auto tie = solver.add_distance(rope, 0, 2, -1, 0);
    CHECK(same(solver.get_constraints(rope).at(2), ConstraintInfo{tie, 0, 2, 2, 0}));
    solver.remove_constraint(rope, tie);
    CHECK(solver.get_constraints(rope).size() == 2);
    ModelDesc unseen = model_desc();
    unseen.layers = 2;
    const Transform nail{{0, 8, 0}, still, 1};
    const auto hook = scene.add(Sphere{zero, 0.1f}, &nail, &unseen);
    solver.attach(scene, rope, 0, hook, &zero);
    scene.set_transform(hook, {{0, 9, 0}, still, 1});
    const auto [steps, leftover] = solver.advance(&scene, 0.025f);
    CHECK((steps == 1 && leftover == Approx(0.5f)));
    std::vector<Vec3> end(1);
    solver.get_positions(rope, 0, 1, end);
    CHECK(end[0].y == Approx(8 + 2 / 3.0));
    CHECK(solver.get_stats(rope).pinned_count == 1);
    solver.detach(rope, 0);
    failure(GPHYS_ERROR_INVALID_ARGUMENT, [&] { solver.detach(rope, 0); });

    const auto cloth = solver.add_cloth({0, 3, 0}, {1, 0, 0}, {0, 0, 1}, 3, 3);
    CHECK(solver.get_triangles(cloth).size() == 24);
    const auto shirt = solver.add_cloth_mesh(pyramid(), &identity);
    CHECK(solver.get_body_info(shirt).particle_count == 5);
    solver.remove_body(cloth);
    CHECK(solver.get_bodies() == std::vector<gphys_body_id>{rope, shirt});

    const std::vector<uint32_t> snapshot = solver.get_snapshot();
    const auto past = solver.get_hash();
    solver.step(&scene, 0.01f);
    CHECK(solver.get_hash() != past);
    solver.restore(snapshot);
    CHECK(solver.get_hash() == past);
    const std::vector<uint32_t> scene_snapshot = scene.get_snapshot(1);
    Scene copy;
    copy.restore(nullptr, scene_snapshot);
    CHECK(copy.get_hash() == scene.get_hash());
    copy.restore(&scene, scene.get_snapshot(0));
    CHECK(copy.get_snapshot(1) == scene_snapshot);
    solver.wake(rope);
    CHECK(solver.get_sleeping().empty());
}

TEST_CASE("a body takes the substeps that are asked for, or that a target takes") {
    const auto substeps = [](float max_strain) {
        auto desc = solver_desc();
        desc.max_strain = max_strain;
        Solver solver(&desc);
        const auto cloth = solver.add_cloth(zero, {1, 0, 0}, {0, 0, 1}, 3, 3);
        solver.set_pinned(cloth, 0, 1, true);
        CHECK(solver.get_substeps(cloth) == 0);
        for (int i = 0; i < 5; ++i) solver.step(nullptr, 0.01f);
        return solver.get_substeps(cloth);
    };
    CHECK(substeps(0) == 8);
    CHECK(substeps(1e-6f) > 8);
}

TEST_CASE("a string holds a weight, its hook feels both, a pyramid keeps its volume") {
    Scene scene;
    Solver solver;
    auto tagged = model_desc();
    tagged.tag = 5;
    const auto hook = scene.add(Sphere{zero, 0.1f}, nullptr, &tagged);
    auto desc = body_desc();
    desc.mass = 2;
    desc.layers = 0;
    const auto weights = solver.add_particles(std::vector<Vec3>{zero, {0, -1, 0}}, &desc);
    solver.attach(scene, weights, 0, hook, &zero);
    const auto string = solver.add_max_distance(weights, 0, 1, 2, 1e-6f);
    solver.set_constraint_damping(weights, string, 50);
    std::vector<gphys_constraint_kind> kinds(1);
    solver.get_constraint_kinds(weights, std::vector<gphys_constraint_id>{string}, kinds);
    CHECK(kinds[0] == GPHYS_CONSTRAINT_MAX_DISTANCE);
    CHECK(solver.get_attachments(weights).at(0).model == hook);
    for (int i = 0; i < 300; ++i) solver.step(&scene, 0.01f);
    std::vector<Vec3> end(1);
    solver.get_positions(weights, 1, 1, end);
    CHECK(end[0].y == Approx(-2).margin(1e-3));
    const auto impulses = solver.get_impulses();
    REQUIRE(impulses.size() == 1);
    CHECK((impulses[0].model == hook && impulses[0].tag == 5));
    CHECK(impulses[0].linear.y == Approx(-2 * 9.81 * 0.01).margin(0.005));

    const auto ball = solver.add_cloth_mesh(pyramid(), &identity);
    solver.set_volume(ball, -1, 0);
    const auto [volume, pressure] = solver.get_volume(ball);
    CHECK((volume == Approx(8.0 / 3) && pressure == 0));
    const auto [rest_volume, compliance] = solver.get_volume_settings(ball);
    CHECK((rest_volume == volume && compliance == 0));
    solver.set_volume(ball, 1, INFINITY);
    failure(GPHYS_ERROR_UNSUPPORTED, [&] { solver.get_volume(ball); });
}

TEST_CASE("settings change live: a winch, damping, what was set is read") {
    Solver solver;
    auto settings = solver.get_settings();
    settings.substeps = 5;
    solver.set_settings(settings);
    CHECK(solver.get_settings().substeps == 5);
    solver.set_worker_count(2);
    CHECK(solver.get_worker_count() == 2);
    CHECK(solver.get_leftover() == 0);
    const auto rope = solver.add_rope(std::vector<Vec3>{zero, {0, -1, 0}}, 0);
    solver.set_pinned(rope, 0, 1, true);
    std::vector<std::int32_t> pinned(2);
    solver.get_pinned(rope, 0, 2, pinned);
    CHECK((pinned[0] == 1 && pinned[1] == 0));
    auto body = solver.get_body_settings(rope);
    body.damping = 0.5f;
    solver.set_body_settings(rope, body);
    CHECK(solver.get_body_settings(rope).damping == 0.5f);
    const std::vector<gphys_constraint_id> links{solver.get_constraints(rope)[0].id};
    std::vector<gphys_constraint_settings> link(1);
    solver.get_constraint_settings(rope, links, link);
    link[0].rest_length = 0.5f;
    solver.set_constraint_settings(rope, links, link);
    std::vector<float> radii(2);
    solver.get_radii(rope, 0, 2, radii);
    CHECK(radii[1] == 0.01f);
    std::vector<Vec3> vectors(2);
    solver.get_forces(rope, 0, 2, vectors);
    CHECK(vectors[1].y == 0);
    for (int i = 0; i < 10; ++i) solver.step(nullptr, 0.01f);
    solver.get_positions(rope, 0, 2, vectors);
    CHECK(vectors[1].y == Approx(-0.5).margin(1e-5));
}

TEST_CASE("wind carries balls along") {
    auto desc = solver_desc();
    desc.gravity = zero;
    Solver solver(&desc);
    const auto balls = solver.add_particles(std::vector<Vec3>{zero, {1, 0, 0}});
    solver.set_wind(balls, {{2, 0, 0}, 1e4f, 0.5f, 0});
    CHECK(solver.get_wind(balls).density == 1e4f);
    solver.set_air_velocities(balls, 1, std::vector<Vec3>{{0, 3, 0}});
    std::vector<Vec3> vectors(2);
    solver.get_air_velocities(balls, 0, 2, vectors);
    CHECK((vectors[0].y == 0 && vectors[1].y == 3));
    for (int i = 0; i < 500; ++i) solver.step(nullptr, 0.01f);
    solver.get_velocities(balls, 0, 2, vectors);
    CHECK((vectors[0].x > 1.8f && vectors[1].y > 2.7f));
}

TEST_CASE("a cluster holds out a particle until it ends") {
    Solver solver;
    const auto plank = solver.add_particles(std::vector<Vec3>{zero, {1, 0, 0}, {2, 0, 0}});
    solver.set_pinned(plank, 0, 2, true);
    const auto cluster = solver.add_cluster(plank, std::vector<uint32_t>{0, 1, 2});
    CHECK(solver.get_clusters(plank) == std::vector<gphys_cluster_id>{cluster});
    CHECK(solver.get_cluster_particles(plank, cluster) == std::vector<uint32_t>{0, 1, 2});
    std::vector<Vec3> places(1);
    for (int i = 0; i < 30; ++i) solver.step(nullptr, 0.01f);
    solver.get_positions(plank, 2, 1, places);
    CHECK((places[0].x == Approx(2) && std::abs(places[0].y) < 1e-5f));
    solver.remove_cluster(plank, cluster);
    for (int i = 0; i < 30; ++i) solver.step(nullptr, 0.01f);
    solver.get_positions(plank, 2, 1, places);
    CHECK(places[0].y < -0.4f);
    failure(GPHYS_ERROR_INVALID_ID, [&] { solver.remove_cluster(plank, cluster); });
}

TEST_CASE("a rope breaks under its weight, and cloth is cut") {
    Solver solver;
    const auto rope = solver.add_rope(std::vector<Vec3>{zero, {0, -1, 0}}, 0);
    solver.set_pinned(rope, 0, 1, true);
    const std::vector<gphys_constraint_id> links{solver.get_constraints(rope)[0].id};
    solver.set_breaking_forces(rope, links, std::vector<float>{3});
    std::vector<float> forces(1);
    solver.get_breaking_forces(rope, links, forces);
    CHECK(forces[0] == 3);
    CHECK(solver.get_breaks().empty());
    for (int i = 0; i < 10 && solver.get_breaks().empty(); ++i) solver.step(nullptr, 0.01f);
    const auto breaks = solver.get_breaks();
    REQUIRE(breaks.size() == 1);
    CHECK((breaks[0].body == rope && breaks[0].constraint == links[0] && breaks[0].load > 3));
    CHECK(breaks[0].torn_particle == GPHYS_NO_PARTICLE);
    failure(GPHYS_ERROR_INVALID_ID, [&] { solver.break_constraint(rope, links[0]); });
    const auto sheet = solver.add_cloth(zero, {1, 0, 0}, {0, 0, 1}, 3, 3);
    CHECK(solver.break_constraint(sheet, solver.get_constraints(sheet)[1].id).new_particle == 9);
}

TEST_CASE("one of two balls slides over ice") {
    auto desc = solver_desc();
    desc.gravity = {0, -10, 0};
    Solver solver(&desc);
    Scene scene;
    scene.add(Plane{{0, 1, 0}, 0});
    const auto balls = solver.add_particles(std::vector<Vec3>{{0, 0.01f, 0}, {0, 0.01f, 1}});
    solver.set_friction_factors(balls, 1, std::vector<float>{0});
    std::vector<float> factors(2);
    solver.get_friction_factors(balls, 0, 2, factors);
    CHECK((factors[0] == 1 && factors[1] == 0));
    solver.set_velocities(balls, 0, std::vector<Vec3>{{1, 0, 0}, {1, 0, 0}});
    for (int i = 0; i < 50; ++i) solver.step(&scene, 0.01f);
    std::vector<Vec3> speeds(2);
    solver.get_velocities(balls, 0, 2, speeds);
    CHECK((speeds[0].x == 0 && speeds[1].x == Approx(1)));
}

TEST_CASE("a ball presses the one that it lies on") {
    Solver solver;
    auto desc = body_desc();
    desc.mass = 2;
    desc.radius = 0.5f;
    desc.body_layers = 1;
    const auto lower = solver.add_particles(std::vector<Vec3>{zero}, &desc);
    const auto upper = solver.add_particles(std::vector<Vec3>{{0, 1, 0}}, &desc);
    solver.set_pinned(lower, 0, 1, true);
    for (int i = 0; i < 20; ++i) solver.step(nullptr, 0.01f);
    const auto contacts = solver.get_body_contacts();
    REQUIRE(contacts.size() == 1);
    CHECK((contacts[0].body_a == lower && contacts[0].body_b == upper && contacts[0].normal.y == 1));
    CHECK(contacts[0].impulse == Approx(0.1962f).epsilon(1e-2));
}

TEST_CASE("a ball hangs below its animation target") {
    gamephys::Solver solver;
    const auto balls = solver.add_particles(std::vector<Vec3>{zero, {1, 0, 0}});
    std::vector<gamephys::AnimationTarget> targets(2);
    solver.get_animation_targets(balls, 0, 2, targets);
    CHECK(targets[1].max_distance == INFINITY);
    targets[1] = {{1, 0, 0}, zero, 0.25f, INFINITY};
    solver.set_animation_targets(balls, 0, targets);
    for (int i = 0; i < 60; ++i) solver.step(nullptr, 0.01f);
    std::vector<Vec3> at(1);
    solver.get_positions(balls, 1, 1, at);
    CHECK(at[0].y == -0.25f);
}

TEST_CASE("a joint holds a particle of another body") {
    Solver solver;
    auto desc = body_desc();
    desc.mass = 2;
    const auto nail = solver.add_particles(std::vector<Vec3>{zero}, &desc);
    const auto weight = solver.add_particles(std::vector<Vec3>{{0, -1, 0}}, &desc);
    solver.set_pinned(nail, 0, 1, true);
    const auto joint = solver.join(nail, 0, weight, 0, -1, 0);
    for (int i = 0; i < 20; ++i) solver.step(nullptr, 0.01f);
    const auto joints = solver.get_joints(weight);
    REQUIRE(joints.size() == 1);
    CHECK((joints[0].id == joint && joints[0].body_a == nail && joints[0].body_b == weight));
    CHECK(joints[0].force == Approx(2 * 9.81).margin(0.01));
    solver.unjoin(joint);
    CHECK(solver.get_joints(0).empty());
    failure(GPHYS_ERROR_INVALID_ID, [&] { solver.unjoin(joint); });
}

TEST_CASE("errors have the library's message") {
    Scene scene;
    CHECK(failure(GPHYS_ERROR_INVALID_ARGUMENT, [&] {
              scene.add(Sphere{zero, -1});
          }).find("radius") != std::string::npos);
    failure(GPHYS_ERROR_INVALID_ID, [&] { scene.remove(12345); });
    const auto model = scene.add(pyramid());
    failure(GPHYS_ERROR_UNSUPPORTED, [&] { scene.get_shape<Sphere>(model); });
    std::vector<Hit> two(2);
    CHECK_THROWS_AS(scene.raycast_batch(std::vector<Ray>{ahead}, 1, two), std::invalid_argument);
    CHECK_THROWS_AS(scene.sweep_sphere_batch(std::vector<Sphere>(2), std::vector<Vec3>(1), 1, two),
                    std::invalid_argument);
    CHECK(std::string(gphys_status_name(GPHYS_NO_HIT)) == "GPHYS_NO_HIT");
    CHECK(gphys_version() >> 16 == GPHYS_VERSION_MAJOR);
}

TEST_CASE("an object that was given up is an error") {
    Scene scene;
    Mesh mesh = pyramid();
    scene.add(mesh);
    mesh.reset();
    failure(GPHYS_ERROR_INVALID_ARGUMENT, [&] { scene.add(mesh); });
    CHECK(scene.raycast({{0.1f, 5, 0.1f}, {0, -1, 0}, 10}));  // the model holds it
    const Scene other = std::move(scene);
    CHECK(other.get_models().size() == 1);
    failure(GPHYS_ERROR_INVALID_ARGUMENT, [&] { scene.get_models(); });
    Solver solver;
    CHECK_THROWS_AS(solver.step(&scene, 0.01f), std::invalid_argument);  // not a step without a scene
    solver.step(nullptr, 0.01f);
}
