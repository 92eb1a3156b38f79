#include "bvh/bvh8.h"

#include <cfenv>
#include <map>
#include <set>
#include <vector>

#include "each_set.h"
#include "meshes.h"
#include "resources.h"
#include "test.h"

using namespace gphys;

namespace {

using Boxes = std::map<uint32_t, Box>;  // the slow twin: all items and their boxes

/// Where boxes are drawn from. Each kind has broken some tree.
enum class Kind { spread, equal, flat, points, outliers, tiny, remote, nested };
constexpr Kind kinds[] = {Kind::spread,   Kind::equal, Kind::flat,   Kind::points,
                          Kind::outliers, Kind::tiny,  Kind::remote, Kind::nested};

Box random_box(test::Random& random, Kind kind) {
    double extent = 100, size = 5;
    Vec3 shift;
    if (kind == Kind::equal) return {{1, 2, 3}, {4, 5, 6}};
    if (kind == Kind::outliers && random.index(50) == 0) extent = 1e15, size = 1e15;
    if (kind == Kind::tiny) extent = 1e-30, size = 1e-38;
    if (kind == Kind::remote) shift = {1e6, -1e6, 1e6};
    if (kind == Kind::nested) extent = 0, size = std::ldexp(1.0, static_cast<int>(random.index(140)) - 90);
    const Vec3 low =
        shift + Vec3{random.uniform(-extent, extent), random.uniform(-extent, extent), random.uniform(-extent, extent)};
    Vec3 high = low + Vec3{random.uniform(0, size), random.uniform(0, size), random.uniform(0, size)};
    if (kind == Kind::points) high = low;
    if (kind == Kind::flat) high[static_cast<int>(random.index(3))] = low[static_cast<int>(random.index(3))];
    Box box;
    for (int k = 0; k < 3; ++k) {
        const float a = static_cast<float>(low[k]), b = static_cast<float>(high[k]);
        box.min[k] = std::min(a, b);
        box.max[k] = std::max(a, b);
    }
    return box;
}

/// Entry of a ray into a box grown by radius, in extended precision; false if it misses.
bool entry_of(const Box& box, const Ray& ray, double radius, double& entry) {
    long double near = 0, far = ray.t_max;
    for (int k = 0; k < 3; ++k) {
        const long double low = static_cast<long double>(box.min[k]) - ray.origin[k] - radius;
        const long double high = static_cast<long double>(box.max[k]) - ray.origin[k] + radius;
        if (ray.direction[k] == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        const long double a = low / ray.direction[k], b = high / ray.direction[k];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    entry = static_cast<double>(near);
    return near <= far;
}

double distance_of(const Box& box, Vec3 p) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        const double gap = std::max({box.min[k] - p[k], p[k] - box.max[k], 0.0});
        sum += gap * gap;
    }
    return std::sqrt(sum);
}

double furthest_of(const Box& box, Vec3 p) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        const double reach = std::max(box.max[k] - p[k], p[k] - box.min[k]);
        sum += reach * reach;
    }
    return std::sqrt(sum);
}

bool holds(const Box& outer, const Box& inner) {
    for (int k = 0; k < 3; ++k) {
        if (inner.min[k] < outer.min[k] || outer.max[k] < inner.max[k]) return false;
    }
    return true;
}

/// Aims at a box's inside, or exactly at one of its faces, edges and corners.
Ray random_ray(test::Random& random, const Boxes& boxes, Kind kind) {
    const Box start = random_box(random, kind);
    Ray ray{{start.min[0], start.min[1], start.min[2]}, random.direction(), infinity};
    if (!boxes.empty() && random.index(4) != 0) {
        auto item = boxes.lower_bound(random.index(boxes.rbegin()->first + 1));
        const Box& box = item->second;
        Vec3 target;
        for (int k = 0; k < 3; ++k) {
            const uint32_t where = random.index(3);
            target[k] = where == 0   ? box.min[k]
                        : where == 1 ? box.max[k]
                                     : random.uniform(box.min[k], static_cast<double>(box.max[k]));
        }
        ray.direction = target - ray.origin;
        if (random.index(3) == 0) {
            // Along an axis, in the plane of a face.
            const int axis = static_cast<int>(random.index(3));
            ray.direction = {};
            ray.direction[axis] = random.index(2) ? 1.0 : -1.0;
            ray.origin = target;
            ray.origin[axis] = start.min[axis];
        }
        if (random.index(4) == 0) ray.direction[static_cast<int>(random.index(3))] *= 1e-30;
        if (random.index(4) == 0) ray.direction *= random.index(2) ? 1e-18 : 1e12;
    }
    if (random.index(4) == 0) ray.t_max = random.uniform(0, 2);
    return ray;
}

/// Some of its planes touch a box as nearly as double can say, from inside or outside.
Frustum random_frustum(test::Random& random, const Boxes& boxes, Kind kind) {
    const Box box = random_box(random, kind);
    Frustum frustum;
    frustum.origin = {box.min[0], box.min[1], box.min[2]};
    const double size = kind == Kind::tiny ? 1e-30 : kind == Kind::remote || kind == Kind::outliers ? 1e6 : 60;
    for (Plane& plane : frustum.planes) {
        plane = {random.direction() * random.uniform(0.5, 2), random.uniform(-size, size / 4)};
    }
    for (int p = 0; p < 2 && !boxes.empty(); ++p) {
        Plane& plane = frustum.planes[p];
        const Box& aim = boxes.lower_bound(random.index(boxes.rbegin()->first + 1))->second;
        const bool most = random.index(2) != 0;
        plane.distance = 0;
        for (int k = 0; k < 3; ++k) {
            const bool use_max = (plane.normal[k] > 0) == most;
            plane.distance += plane.normal[k] * ((use_max ? aim.max[k] : aim.min[k]) - frustum.origin[k]);
        }
        if (random.index(2)) plane.distance = std::nextafter(plane.distance, random.index(2) ? 1e30 : -1e30);
    }
    if (random.index(3) == 0) frustum.planes[GPHYS_FRUSTUM_FAR] = {{0, 0, 0}, -1};
    return frustum;
}

/// 1 wholly inside, -1 wholly outside one plane, 0 else; extended precision.
int side_of(const Box& box, const Frustum& frustum) {
    bool inside = true;
    for (const Plane& plane : frustum.planes) {
        long double most = 0, least = 0;
        for (int k = 0; k < 3; ++k) {
            const long double a = plane.normal[k] * (static_cast<long double>(box.min[k]) - frustum.origin[k]);
            const long double b = plane.normal[k] * (static_cast<long double>(box.max[k]) - frustum.origin[k]);
            most += std::max(a, b);
            least += std::min(a, b);
        }
        if (most < plane.distance) return -1;
        inside = inside && least >= plane.distance;
    }
    return inside ? 1 : 0;
}

constexpr int trapped_exceptions = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW;

struct QueryCounts {
    uint64_t needed = 0, visited = 0;
};

/// The closest entry, with ties to the lower item, as exact tests behind the tree find it.
struct Nearest {
    double entry = infinity;
    uint32_t item = Bvh8::none;

    void meet(uint32_t other, const Box& box, const Ray& ray, double radius, double& t_max) {
        double its_entry;
        if (!entry_of(box, {ray.origin, ray.direction, t_max}, radius, its_entry)) return;
        if (its_entry < entry || (its_entry == entry && other < item)) {
            t_max = entry = its_entry;
            item = other;
        }
    }
};

void compare_ray(const Bvh8& tree, const Boxes& boxes, const Ray& ray, double radius, QueryCounts& counts) {
    std::set<uint32_t> visited;
    Nearest nearest, expected;
    const auto visit_all = [&](uint32_t item, double&) { REQUIRE(visited.insert(item).second); };
    const auto visit_nearest = [&](uint32_t item, double& t_max) {
        nearest.meet(item, boxes.at(item), ray, radius, t_max);
    };
    std::feclearexcept(FE_ALL_EXCEPT);
    if (radius == 0) {
        tree.raycast(ray, ray.t_max, visit_all);
    } else {
        tree.sweep(ray.origin, ray.direction, radius, visit_all);
    }
    REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
    if (radius == 0) {
        tree.raycast(ray, ray.t_max, visit_nearest);
    } else {
        tree.sweep(ray.origin, ray.direction, radius, visit_nearest);
    }

    double t_max = ray.t_max;
    for (const auto& [item, box] : boxes) {
        double entry;
        if (!entry_of(box, ray, radius, entry)) continue;
        ++counts.needed;
        REQUIRE(visited.count(item) == 1);
        expected.meet(item, box, ray, radius, t_max);
    }
    counts.visited += visited.size();
    REQUIRE(nearest.item == expected.item);
    REQUIRE(nearest.entry == expected.entry);
}

/// Rays at once against each by itself.
void compare_rays(const Bvh8& tree, const Boxes& boxes, std::vector<Ray> rays) {
    std::vector<std::vector<uint32_t>> visits(rays.size()), visits_in_no_order(rays.size()), alone(rays.size());
    std::vector<Nearest> nearest(rays.size()), nearest_alone(rays.size());
    const auto count = static_cast<uint32_t>(rays.size());
    const std::vector<Ray> whole = rays;
    std::feclearexcept(FE_ALL_EXCEPT);
    tree.raycast_many(rays.data(), count, [&](const uint32_t* numbers, const uint32_t* items, uint32_t size) {
        for (uint32_t k = 0; k < size; ++k) visits[numbers[k]].push_back(items[k]);
        return 0u;
    });
    tree.raycast_any_many(rays.data(), count, [&](const uint32_t* numbers, const uint32_t* items, uint32_t size) {
        for (uint32_t k = 0; k < size; ++k) visits_in_no_order[numbers[k]].push_back(items[k]);
        return 0u;
    });
    REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
    // Those that end where they first meet something.
    std::vector<bool> ended(rays.size());
    tree.raycast_any_many(rays.data(), count, [&](const uint32_t* numbers, const uint32_t*, uint32_t size) {
        for (uint32_t k = 0; k < size; ++k) {
            ended[numbers[k]] = true;
            rays[numbers[k]].t_max = -1;
        }
        return (1u << size) - 1;
    });
    rays = whole;
    tree.raycast_many(rays.data(), count, [&](const uint32_t* numbers, const uint32_t* items, uint32_t size) {
        for (uint32_t k = 0; k < size; ++k) {
            const uint32_t i = numbers[k];
            nearest[i].meet(items[k], boxes.at(items[k]), whole[i], 0, rays[i].t_max);
        }
        return (1u << size) - 1;
    });
    rays = whole;
    for (uint32_t i = 0; i < count; ++i) {
        tree.raycast(rays[i], rays[i].t_max, [&](uint32_t item, double&) { alone[i].push_back(item); });
        tree.raycast(rays[i], rays[i].t_max, [&](uint32_t item, double& t_max) {
            nearest_alone[i].meet(item, boxes.at(item), rays[i], 0, t_max);
        });
        std::sort(alone[i].begin(), alone[i].end());
        for (std::vector<uint32_t>* all : {&visits[i], &visits_in_no_order[i]}) {
            std::sort(all->begin(), all->end());
            bool thrice = false;
            for (size_t k = 2; k < all->size(); ++k) thrice = thrice || (*all)[k] == (*all)[k - 2];
            REQUIRE_FALSE(thrice);
            all->erase(std::unique(all->begin(), all->end()), all->end());
            REQUIRE(*all == alone[i]);
        }
        REQUIRE(ended[i] == !alone[i].empty());
        REQUIRE(nearest[i].item == nearest_alone[i].item);
        REQUIRE(nearest[i].entry == nearest_alone[i].entry);
    }
}

void compare_queries(const Bvh8& tree, const Boxes& boxes, test::Random& random, Kind kind, int rounds) {
    std::vector<Vec3> points;
    std::vector<double> limits;
    std::vector<uint32_t> nearest_items;
    for (int round = 0; round < rounds; ++round) {
        QueryCounts counts;
        compare_ray(tree, boxes, random_ray(random, boxes, kind), 0, counts);
        Ray motion = random_ray(random, boxes, kind);
        motion.t_max = 1;
        compare_ray(tree, boxes, motion, kind == Kind::tiny ? 1e-31 : random.uniform(0.001, 3), counts);
        motion.direction = {};
        compare_ray(tree, boxes, motion, 0, counts);

        const Box query = random_box(random, kind);
        std::map<uint32_t, bool> visited;
        const auto visit = [&](uint32_t item, bool inside) { return visited.emplace(item, inside).second; };
        REQUIRE(tree.overlap_box(query, visit));
        std::set<uint32_t> visited_by_test;
        REQUIRE(tree.overlap([&](const Box& box) { return overlaps(box, query); },
                             [&](uint32_t item) { return visited_by_test.insert(item).second; }));
        REQUIRE(visited.size() == visited_by_test.size());
        for (const auto& [item, box] : boxes) {
            REQUIRE(visited.count(item) == overlaps(box, query));
            REQUIRE(visited_by_test.count(item) == overlaps(box, query));
            if (visited.count(item)) REQUIRE(visited[item] == holds(query, box));
        }

        const Vec3 center{query.max[0], query.min[1], query.max[2]};
        const double radius = kind == Kind::tiny ? random.uniform(0, 1e-30) : random.uniform(0, 20);
        visited.clear();
        std::feclearexcept(FE_ALL_EXCEPT);
        REQUIRE(tree.overlap_ball(center, radius, visit));
        REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
        const double largest_coordinate = furthest_of(tree.bounds(), {}) + length(center);
        for (const auto& [item, box] : boxes) {
            const double nearest_point = distance_of(box, center), furthest = furthest_of(box, center);
            if (nearest_point <= radius) REQUIRE(visited.count(item) == 1);
            if (furthest > radius && visited.count(item)) REQUIRE_FALSE(visited[item]);
            // Some roundings of float, squares that underflow, and what double arithmetic may be off by.
            const double error = 0x1p-19 * radius + 1e-18;
            if (nearest_point > radius + error + 0x1p-46 * largest_coordinate) REQUIRE(visited.count(item) == 0);
            if (furthest < radius - error) REQUIRE(visited[item]);
        }

        const Vec3 point{query.min[0], query.max[1], query.min[2]};
        const double limit = random.index(2) ? infinity : random.uniform(0, 50);
        double nearest = limit, expected = limit;
        uint32_t nearest_item = Bvh8::none, expected_item = Bvh8::none;
        std::feclearexcept(FE_ALL_EXCEPT);
        tree.nearest(point, nearest, [&](uint32_t item, double& max_distance) {
            const double d = distance_of(boxes.at(item), point);
            if (d < nearest || (d == nearest && item < nearest_item)) {
                nearest = max_distance = d;
                nearest_item = item;
            }
        });
        REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
        for (const auto& [item, box] : boxes) {
            const double d = distance_of(box, point);
            if (d < expected || (d == expected && expected_item == Bvh8::none)) {
                expected = d;
                expected_item = item;
            }
        }
        REQUIRE(nearest_item == expected_item);
        points.push_back(point);
        limits.push_back(limit);
        nearest_items.push_back(nearest_item);

        const Frustum frustum = random_frustum(random, boxes, kind);
        std::map<uint32_t, bool> seen;
        std::feclearexcept(FE_ALL_EXCEPT);
        const auto see = [&](uint32_t item, bool inside) { return seen.emplace(item, inside).second; };
        REQUIRE(tree.frustum(frustum, all_of_space, see));
        REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
        for (const auto& [item, box] : boxes) {
            const int side = side_of(box, frustum);
            if (side >= 0) REQUIRE(seen.count(item) == 1);
            if (side < 1 && seen.count(item)) REQUIRE_FALSE(seen[item]);
        }
    }

    std::vector<uint32_t> nearest_of_many(points.size(), Bvh8::none);
    std::feclearexcept(FE_ALL_EXCEPT);
    const auto count = static_cast<uint32_t>(points.size());
    tree.nearest_many(points.data(), count, limits.data(), [&](uint32_t i, uint32_t item) {
        const double d = distance_of(boxes.at(item), points[i]);
        if (d < limits[i] || (d == limits[i] && item < nearest_of_many[i])) {
            limits[i] = d;
            nearest_of_many[i] = item;
        }
    });
    REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
    REQUIRE(nearest_of_many == nearest_items);
}

void require_sound(const Bvh8& tree, const Boxes& boxes) {
    const char* defect = tree.defect();
    INFO((defect ? defect : ""));
    REQUIRE(defect == nullptr);
    REQUIRE(tree.size() == boxes.size());
    for (const auto& [item, box] : boxes) REQUIRE(tree.box(item) == box);
}

Boxes random_boxes(test::Random& random, Kind kind, uint32_t count) {
    Boxes boxes;
    for (uint32_t item = 0; item < count; ++item) boxes[item] = random_box(random, kind);
    return boxes;
}

void build(Bvh8& tree, const Boxes& boxes) {
    std::vector<Box> values;
    std::vector<uint32_t> items;
    for (const auto& [item, box] : boxes) {
        items.push_back(item);
        values.push_back(box);
    }
    tree.build(values.data(), items.data(), static_cast<uint32_t>(items.size()));
}

/// One random change, made to the tree and to its twin.
void change(Bvh8& tree, Boxes& boxes, test::Random& random, Kind kind) {
    const auto any = [&] { return boxes.lower_bound(random.index(boxes.rbegin()->first + 1)); };
    const uint32_t action = boxes.empty() ? 0 : random.index(100);
    if (action < 45) {
        uint32_t item = random.index(4000);
        while (boxes.count(item)) ++item;
        const Box box = random_box(random, kind);
        tree.insert(item, box);
        boxes[item] = box;
    } else if (action < 70) {
        const auto item = any();
        tree.remove(item->first);
        boxes.erase(item);
    } else {
        const auto item = any();
        item->second = random_box(random, kind);
        tree.update(item->first, item->second);
    }
}

}  // namespace

TEST_CASE("an empty octree answers every query with nothing") {
    Bvh8 tree(std::pmr::get_default_resource());
    REQUIRE(tree.size() == 0);
    REQUIRE(tree.stats().depth == 0);
    REQUIRE_FALSE(tree.contains(0));
    test::Random random(1);
    compare_queries(tree, {}, random, Kind::spread, 10);
    REQUIRE(tree.defect() == nullptr);
}

TEST_CASE("an octree finds what a linear scan finds, after a build of any size") {
    test::Random random(2);
    for (Kind kind : kinds) {
        for (uint32_t count : {1u, 2u, 7u, 8u, 9u, 64u, 65u, 500u, 3000u}) {
            INFO("kind " << static_cast<int>(kind) << ", " << count << " boxes");
            const Boxes boxes = random_boxes(random, kind, count);
            Bvh8 tree(std::pmr::get_default_resource());
            std::feclearexcept(FE_ALL_EXCEPT);
            build(tree, boxes);
            REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
            require_sound(tree, boxes);
            compare_queries(tree, boxes, random, kind, test::tries_on_each_set(count < 100 ? 60 : 12));
        }
    }
}

TEST_CASE("an octree finds what a linear scan finds, after any sequence of changes") {
    test::Random random(3);
    for (Kind kind : kinds) {
        INFO("kind " << static_cast<int>(kind));
        Bvh8 tree(std::pmr::get_default_resource());
        Boxes boxes;
        std::feclearexcept(FE_ALL_EXCEPT);
        for (int batch = 0; batch < test::tries_on_each_set(50); ++batch) {
            for (int i = 0; i < 300; ++i) change(tree, boxes, random, kind);
            require_sound(tree, boxes);
            REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
            compare_queries(tree, boxes, random, kind, 2);
            std::feclearexcept(FE_ALL_EXCEPT);
        }
        while (!boxes.empty()) {
            tree.remove(boxes.begin()->first);
            boxes.erase(boxes.begin());
            if (boxes.size() % 64 == 0) require_sound(tree, boxes);
        }
    }
}

TEST_CASE("rays at once find in an octree what each finds alone, in company or not") {
    test::Random random(13);
    for (Kind kind : kinds) {
        for (uint32_t count : {1u, 9u, 200u, 3000u}) {
            INFO("kind " << static_cast<int>(kind) << ", " << count << " boxes");
            const Boxes boxes = random_boxes(random, kind, count);
            Bvh8 tree(std::pmr::get_default_resource());
            build(tree, boxes);
            for (int round = 0; round < test::tries_on_each_set(10); ++round) {
                // Runs of rays, each in company of the first of its run, closer or less close.
                std::vector<Ray> rays;
                while (rays.size() < Bvh8::rays_at_once) {
                    const Ray first = random_ray(random, boxes, kind);
                    const double spread = std::ldexp(length(first.direction), -static_cast<int>(random.index(30)));
                    const uint32_t company = 1 + random.index(64);
                    for (uint32_t i = 0; i < company && rays.size() < Bvh8::rays_at_once; ++i) {
                        Ray ray = first;
                        if (i > 0) ray.direction += random.direction() * spread;
                        if (random.index(8) == 0) ray.t_max = random.index(2) ? -1.0 : random.uniform(0, 2);
                        if (random.index(50) == 0) ray.direction = {};
                        rays.push_back(ray);
                    }
                }
                compare_rays(tree, boxes, rays);
            }
        }
    }
}

TEST_CASE("queries side by side find in an octree what each finds alone, on every processor") {
    test::Random random(29);
    uint32_t complete = 0, too_much = 0, inside = 0;
    const auto compare = [&](const OverlapItems& met, const auto& alone) {
        too_much += !met.complete;
        if (!met.complete) return;
        ++complete;
        std::map<uint32_t, bool> found, expected;
        for (const bool within : {false, true}) {
            for (uint32_t i = 0; i < met.count[within]; ++i)
                REQUIRE(found.emplace(met.items[within][i], within).second);
            inside += within ? met.count[within] : 0;
        }
        alone([&](uint32_t item, bool within) { return expected.emplace(item, within).second; });
        REQUIRE(found == expected);
    };
    for (const Isa isa : test::isas()) {
        for (Kind kind : kinds) {
            for (uint32_t count : {0u, 1u, 9u, 200u, 5000u}) {
                INFO(name_of(isa) << ", kind " << static_cast<int>(kind) << ", " << count << " boxes");
                const Boxes items = random_boxes(random, kind, count);
                Bvh8 tree(std::pmr::get_default_resource(), isa);
                build(tree, items);
                for (int round = 0; round < 10; ++round) {
                    const uint32_t queries = 1 + random.index(OverlapItems::max_queries);
                    Box boxes[OverlapItems::max_queries];
                    Sphere balls[OverlapItems::max_queries];
                    for (uint32_t k = 0; k < queries; ++k) {
                        boxes[k] = random_box(random, kind);
                        const Vec3 low{boxes[k].min[0], boxes[k].min[1], boxes[k].min[2]};
                        const double size = kind == Kind::tiny ? 1e-31 : std::exp2(random.uniform(-2, 7));
                        balls[k] = {low, size};
                        if (random.index(2)) boxes[k] = bounds(balls[k]);
                    }
                    OverlapItems met[OverlapItems::max_queries];
                    tree.overlap_boxes(boxes, queries, {}, {}, met);
                    for (uint32_t k = 0; k < queries; ++k) {
                        compare(met[k], [&](const auto& visit) { tree.overlap_box(boxes[k], visit); });
                    }
                    tree.overlap_balls(balls, queries, {}, {}, met);
                    for (uint32_t k = 0; k < queries; ++k) {
                        compare(met[k],
                                [&](const auto& visit) { tree.overlap_ball(balls[k].center, balls[k].radius, visit); });
                    }
                }
            }
        }
    }
    CHECK(complete > 1000);
    CHECK(too_much > 100);
    CHECK(inside > 1000);
}

TEST_CASE("updating many items of an octree at once is like updating each") {
    test::Random random(4);
    for (Kind kind : kinds) {
        Boxes boxes = random_boxes(random, kind, 1000);
        Bvh8 tree(std::pmr::get_default_resource());
        build(tree, boxes);
        for (uint32_t count : {0u, 1u, 50u, 124u, 125u, 600u, 1000u}) {
            std::vector<uint32_t> items;
            std::vector<Box> moved;
            for (uint32_t i = 0; i < count; ++i) {
                items.push_back(i * 7 % 1000);
                moved.push_back(random_box(random, kind));
                boxes[items.back()] = moved.back();
            }
            tree.update_many(count, [&](const auto& put, bool) {
                for (uint32_t k = 0; k < count; ++k) put(items[k], moved[k]);
            });
            require_sound(tree, boxes);
            compare_queries(tree, boxes, random, kind, 5);
        }
    }
}

TEST_CASE("inserting many items into an octree at once is like inserting each") {
    test::Random random(5);
    Boxes boxes = random_boxes(random, Kind::spread, 1000);
    Bvh8 tree(std::pmr::get_default_resource());
    build(tree, boxes);
    for (uint32_t count : {0u, 3u, 100u, 2000u}) {
        std::vector<uint32_t> items;
        std::vector<Box> added;
        for (uint32_t i = 0; i < count; ++i) {
            items.push_back(static_cast<uint32_t>(boxes.size()));
            added.push_back(random_box(random, Kind::spread));
            boxes[items.back()] = added.back();
        }
        tree.insert_many(items.data(), added.data(), count);
        require_sound(tree, boxes);
        compare_queries(tree, boxes, random, Kind::spread, 5);
    }
    tree.clear();
    require_sound(tree, {});
    tree.insert(7, {{0, 0, 0}, {1, 1, 1}});
    require_sound(tree, {{7, {{0, 0, 0}, {1, 1, 1}}}});
}

TEST_CASE("boxes in a geometric series do not make an octree deeper than its stacks") {
    // Each new box is twice as far out: the cheapest cut always parts it from all others.
    Bvh8 tree(std::pmr::get_default_resource());
    Boxes boxes;
    uint32_t item = 0;
    for (int round = 0; round < 60; ++round) {
        for (int exponent = -120; exponent < 50; ++exponent) {
            const float x = std::ldexp(1.0f + static_cast<float>(round) / 64, exponent);
            boxes[item] = {{x, x, x}, {x, x, x}};
            tree.insert(item, boxes[item]);
            ++item;
        }
    }
    require_sound(tree, boxes);
    test::Random random(6);
    compare_queries(tree, boxes, random, Kind::nested, 10);
    build(tree, boxes);
    require_sound(tree, boxes);
    REQUIRE(tree.stats().depth <= Bvh8::max_built_levels);
}

TEST_CASE("interleaved traversals of a tree that is deeper than their stacks visit all items") {
    // As seen from the origin, each box is twice as far as the one before: the deepest nodes are nearest, and all
    // others wait.
    Bvh8 tree(std::pmr::get_default_resource());
    uint32_t count = 0;
    for (int round = 0; round < 60; ++round) {
        for (int exponent = -120; exponent < 50; ++exponent) {
            const float x = std::ldexp(1.0f + static_cast<float>(round) / 64, exponent);
            tree.insert(count++, {{x, x, x}, {x, x, x}});
        }
    }
    constexpr uint32_t queries = 3;
    std::vector<std::vector<bool>> seen;
    const auto begin = [&] { seen.assign(queries, std::vector<bool>(count)); };
    const auto require_all = [&] {
        for (const auto& of_query : seen) REQUIRE(std::count(of_query.begin(), of_query.end(), true) == count);
    };
    const Ray ray{{}, {1, 1, 1}, infinity};
    const std::vector<Ray> rays(queries, ray);
    const auto visit = [&](const uint32_t* numbers, const uint32_t* items, uint32_t size) {
        for (uint32_t k = 0; k < size; ++k) seen[numbers[k]][items[k]] = true;
        return 0u;
    };
    begin();
    tree.raycast_many(rays.data(), queries, visit);
    require_all();
    begin();
    tree.raycast_any_many(rays.data(), queries, visit);
    require_all();
    const std::vector<Vec3> points(queries);
    std::vector<double> reaches(queries, infinity);
    begin();
    tree.nearest_many(points.data(), queries, reaches.data(), [&](uint32_t i, uint32_t item) { seen[i][item] = true; });
    require_all();
}

TEST_CASE("an octree rebuilds itself when all its items change places at once") {
    test::Random random(7);
    Boxes boxes = random_boxes(random, Kind::spread, 4000);
    Bvh8 tree(std::pmr::get_default_resource());
    build(tree, boxes);
    const float built_cost = tree.stats().cost;
    REQUIRE(tree.stats().rebuilds == 0);
    std::vector<uint32_t> items;
    std::vector<Box> moved;
    for (auto& [item, box] : boxes) {
        box = random_box(random, Kind::spread);
        items.push_back(item);
        moved.push_back(box);
    }
    tree.update_many(4000, [&](const auto& put, bool) {
        for (uint32_t k = 0; k < 4000; ++k) put(items[k], moved[k]);
    });
    REQUIRE(tree.stats().rebuilds == 1);
    // Both trees hold boxes of the same distribution: their costs agree within sampling noise.
    REQUIRE(tree.stats().cost < 1.2f * built_cost);
    require_sound(tree, boxes);
}

TEST_CASE("inserting one by one makes an octree not much worse than a build") {
    test::Random random(8);
    const Boxes boxes = random_boxes(random, Kind::spread, 5000);
    Bvh8 grown(std::pmr::get_default_resource()), built(std::pmr::get_default_resource());
    for (const auto& [item, box] : boxes) grown.insert(item, box);
    build(built, boxes);
    // The quality measure allows twice the area.
    REQUIRE(grown.stats().cost < 2.5f * built.stats().cost);
}

TEST_CASE("octree statistics and boxes agree with each other") {
    test::Random random(9);
    const Boxes boxes = random_boxes(random, Kind::spread, 777);
    Bvh8 tree(std::pmr::get_default_resource());
    build(tree, boxes);
    const gphys_octree_stats stats = tree.stats();
    uint32_t nodes = 0, leaves = 0, items = 0, deepest = 0;
    double root_area = 0, area = 0;
    const auto half_area_of = [](const gphys_aabb& box) {
        const double x = double{box.max.x} - box.min.x, y = double{box.max.y} - box.min.y,
                     z = double{box.max.z} - box.min.z;
        return x * y + y * z + z * x;
    };
    tree.for_each_box([&](const gphys_octree_box& box) {
        REQUIRE(box.bounds.min.x <= box.bounds.max.x);
        REQUIRE((nodes == 0) == (box.depth == 0));
        if (nodes == 0) root_area = half_area_of(box.bounds);
        area += half_area_of(box.bounds);
        ++nodes;
        leaves += box.item_count > 0;
        items += box.item_count;
        deepest = std::max(deepest, box.depth);
    });
    REQUIRE(items == 777);
    REQUIRE(stats.item_count == 777);
    REQUIRE(stats.node_count == nodes);
    REQUIRE(stats.leaf_count == leaves);
    REQUIRE(stats.depth == deepest + 1);
    REQUIRE(stats.memory_bytes > 0);
    for (const auto& [item, box] : boxes) {
        area += half_area_of({{box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]}});
    }
    // What a line that meets the root box meets of each box is its share of the area. Rounded to a float.
    REQUIRE(std::fabs(stats.cost / (area / root_area) - 1) < 1e-6);
}

TEST_CASE("pairs of two octrees are all overlapping pairs, each once") {
    test::Random random(10);
    for (uint32_t count : {1u, 8u, 100u, 600u}) {
        const Boxes a = random_boxes(random, Kind::spread, count), b = random_boxes(random, Kind::flat, 300);
        Bvh8 tree_a(std::pmr::get_default_resource()), tree_b(std::pmr::get_default_resource());
        build(tree_a, a);
        build(tree_b, b);
        std::set<std::pair<uint32_t, uint32_t>> pairs, expected;
        for (const auto& [i, box] : a) {
            for (const auto& [j, other] : b) {
                if (overlaps(box, other)) expected.emplace(i, j);
            }
        }
        REQUIRE(tree_a.overlap_pairs(tree_b, [&](uint32_t i, uint32_t j) { return pairs.emplace(i, j).second; }));
        REQUIRE(pairs == expected);
        pairs.clear();
        REQUIRE(tree_b.overlap_pairs(tree_a, [&](uint32_t j, uint32_t i) { return pairs.emplace(i, j).second; }));
        REQUIRE(pairs == expected);
        if (!expected.empty()) {
            REQUIRE_FALSE(tree_a.overlap_pairs(tree_b, [](uint32_t, uint32_t) { return false; }));
        }
    }
}

TEST_CASE("visitors can end octree queries") {
    test::Random random(11);
    const Boxes boxes = random_boxes(random, Kind::equal, 100);
    Bvh8 tree(std::pmr::get_default_resource());
    build(tree, boxes);
    int visits = 0;
    tree.raycast({{2, 3, 4}, {1, 0, 0}, infinity}, infinity, [&](uint32_t, double& t_max) { ++visits, t_max = -1; });
    REQUIRE(visits == 1);
    tree.nearest({2, 3, 4}, infinity, [&](uint32_t, double& distance) { ++visits, distance = -1; });
    REQUIRE(visits == 2);
    REQUIRE_FALSE(tree.overlap_box({{2, 3, 4}, {2, 3, 4}}, [&](uint32_t, bool) { return ++visits, false; }));
    REQUIRE(visits == 3);
    REQUIRE_FALSE(tree.overlap_ball({2, 3, 4}, 1, [&](uint32_t, bool) { return ++visits, false; }));
    REQUIRE(visits == 4);
    // All of them inside, of which more are found than are handed on at once.
    REQUIRE_FALSE(tree.overlap_ball({2, 3, 4}, 10, [&](uint32_t, bool) { return ++visits < 40; }));
    REQUIRE(visits == 40);
}

TEST_CASE("rays from beyond the range of float find the boxes of an octree") {
    // A model's scale divides the ray when it is taken into the model's own coordinates.
    test::Random random(12);
    const Boxes boxes = random_boxes(random, Kind::spread, 500);
    Bvh8 tree(std::pmr::get_default_resource());
    build(tree, boxes);
    for (double far : {1e10, 1e20, 1e30, 1e60}) {
        const double direction_scale = far / 100;
        const Ray ray{{far, 0, 0}, {-direction_scale, 0, 0}, infinity};
        std::set<uint32_t> visited;
        std::feclearexcept(FE_ALL_EXCEPT);
        tree.raycast(ray, ray.t_max, [&](uint32_t item, double&) { visited.insert(item); });
        tree.sweep(ray.origin, ray.direction * 200, far / 1000, [&](uint32_t item, double&) { visited.insert(item); });
        double distance = infinity;
        tree.nearest(ray.origin, infinity, [&](uint32_t item, double& max_distance) {
            max_distance = distance = std::min(distance, distance_of(boxes.at(item), ray.origin));
        });
        REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
        for (const auto& [item, box] : boxes) {
            double entry;
            if (entry_of(box, ray, 0, entry)) REQUIRE(visited.count(item) == 1);
            REQUIRE(distance <= distance_of(box, ray.origin));
        }
    }
}

TEST_CASE("running out of memory leaves an octree as it was") {
    test::Random random(13);
    test::WatchedMemory memory;
    {
        Bvh8 tree(&memory);
        Boxes boxes;
        long refusals = 0;
        for (int i = 0; i < 3000; ++i) {
            if (i % 3 == 0) memory.fail_at = memory.allocations + static_cast<long>(random.index(2));
            const uint32_t item = static_cast<uint32_t>(i);
            const Box box = random_box(random, Kind::spread);
            try {
                tree.insert(item, box);
                boxes[item] = box;
            } catch (const std::bad_alloc&) {
                ++refusals;
                REQUIRE_FALSE(tree.contains(item));
            }
            if (!boxes.empty() && i % 2 == 0) {
                const auto moved = boxes.lower_bound(random.index(boxes.rbegin()->first + 1));
                moved->second = random_box(random, Kind::spread);
                tree.update(moved->first, moved->second);
            }
            if (i % 100 == 0) require_sound(tree, boxes);
            memory.fail_at = -1;
        }
        REQUIRE(refusals >= 3);
        std::vector<uint32_t> items;
        std::vector<Box> added;
        for (uint32_t i = 0; i < 5000; ++i) {
            items.push_back(10000 + i);
            added.push_back(random_box(random, Kind::spread));
        }
        for (uint32_t count : {300u, 5000u}) {
            for (long fail_after : {0L, 1L, 2L}) {
                memory.fail_at = memory.allocations + fail_after;
                try {
                    tree.insert_many(items.data(), added.data(), count);
                    for (uint32_t i = 0; i < count; ++i) tree.remove(items[i]);
                } catch (const std::bad_alloc&) {
                    ++refusals;
                }
                memory.fail_at = -1;
                require_sound(tree, boxes);
            }
        }
        memory.fail_at = memory.allocations;
        REQUIRE_THROWS_AS(tree.build(added.data(), items.data(), 5000), std::bad_alloc);
        memory.fail_at = -1;
        require_sound(tree, boxes);
        compare_queries(tree, boxes, random, Kind::spread, 10);
    }
    REQUIRE(memory.bytes_in_use == 0);
}

TEST_CASE("octree queries allocate nothing, and a few removals and updates neither") {
    test::Random random(14);
    test::WatchedMemory memory;
    Boxes boxes = random_boxes(random, Kind::spread, 2000);
    Bvh8 tree(&memory);
    build(tree, boxes);
    const long before = memory.allocations;
    compare_queries(tree, boxes, random, Kind::spread, 20);
    tree.overlap_pairs(tree, [](uint32_t, uint32_t) { return true; });
    for (uint32_t item = 0; item < 100; ++item) {
        boxes[item].max[0] += 1;
        tree.update(item, boxes[item]);
        tree.remove(1000 + item);
        boxes.erase(1000 + item);
    }
    REQUIRE(tree.stats().item_count == 1900);
    REQUIRE(memory.allocations == before);
    require_sound(tree, boxes);
}
