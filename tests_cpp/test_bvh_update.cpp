// What changes cost an octree, and what they leave of its quality. Work is counted, never timed.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "bvh/bvh8.h"
#include "foundation/workers.h"
#include "meshes.h"
#include "resources.h"
#include "test.h"

using namespace gphys;

namespace {

Box box_at(Vec3 low, double size) {
    Box box;
    for (int k = 0; k < 3; ++k) {
        box.min[k] = static_cast<float>(low[k]);
        box.max[k] = static_cast<float>(low[k] + size);
    }
    return box;
}

struct Items {
    std::vector<uint32_t> numbers;
    std::vector<Box> boxes;

    void add(const Box& box) {
        numbers.push_back(static_cast<uint32_t>(numbers.size()));
        boxes.push_back(box);
    }
    uint32_t count() const { return static_cast<uint32_t>(numbers.size()); }
    void build(Bvh8& tree) const { tree.build(boxes.data(), numbers.data(), count()); }
    void update(Bvh8& tree) const {
        tree.update_many(count(), [&](const auto& put, bool) {
            for (uint32_t i = 0; i < count(); ++i) put(numbers[i], boxes[i]);
        });
    }
};

Items scattered(test::Random& random, uint32_t count, double extent) {
    Items items;
    const auto coordinate = [&] { return random.uniform(-extent, extent); };
    for (uint32_t i = 0; i < count; ++i) {
        const double x = coordinate(), y = coordinate(), z = coordinate();
        items.add(box_at({x, y, z}, random.uniform(0.4, 2)));
    }
    return items;
}

void move(Box& box, Vec3 by) {
    for (int k = 0; k < 3; ++k) {
        box.min[k] += static_cast<float>(by[k]);
        box.max[k] += static_cast<float>(by[k]);
    }
}

void require_sound(const Bvh8& tree) {
    const char* defect = tree.defect();
    INFO((defect ? defect : ""));
    REQUIRE(defect == nullptr);
}

float cost_of_build(const Items& items) {
    Bvh8 tree(std::pmr::get_default_resource());
    items.build(tree);
    return tree.stats().cost;
}

bool same_nodes(const Bvh8& a, const Bvh8& b) {
    const gphys_octree_stats stats = a.stats();
    if (stats.node_count != b.stats().node_count || a.root() != b.root()) return false;
    for (uint32_t i = 0; i < stats.node_count; ++i) {
        const BvhNode &x = a.nodes()[i], &y = b.nodes()[i];
        if (x.count != y.count || x.parent != y.parent || x.lane != y.lane) return false;
        for (uint32_t lane = 0; lane < x.count; ++lane) {
            if (x.child[lane] != y.child[lane]) return false;
            if (!(x.boxes.lane(static_cast<int>(lane)) == y.boxes.lane(static_cast<int>(lane)))) return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("an octree stays shallow, and is never rebuilt, whatever the order of insertion") {
    constexpr uint32_t count = 5000;
    const std::vector<std::pair<const char*, std::function<Box(uint32_t)>>> orders = {
        {"along a line",
         [](uint32_t i) {
             return box_at({i * 1.0, 0, 0}, 0.5);
         }},
        {"along a line, inward",
         [](uint32_t i) {
             return box_at({count - i * 1.0, 0, 0}, 0.5);
         }},
        {"along a spiral",
         [](uint32_t i) {
             return box_at({i * 0.01 * std::cos(i * 0.06), i * 0.01 * std::sin(i * 0.06), 0}, 0.5);
         }},
        {"growing",
         [](uint32_t i) {
             return box_at({std::pow(1.004, i), 0, 0}, 0.5);
         }},
        {"doubling, over and over",
         [](uint32_t i) {
             const double x = std::ldexp(1 + i * 1e-5, static_cast<int>(i % 120) - 70);
             return box_at({x, x, x}, 0);
         }},
        {"around each other",
         [](uint32_t i) {
             return box_at(Vec3{-0.5, -0.5, -0.5} * std::pow(1.004, i), std::pow(1.004, i));
         }},
        {"at one point", [](uint32_t) { return box_at({}, 0.5); }},
    };
    for (const auto& [name, box_of] : orders) {
        INFO(name);
        test::WatchedMemory memory, memory_of_build;
        Bvh8 tree(&memory), built(&memory_of_build);
        Items items;
        for (uint32_t i = 0; i < count; ++i) {
            items.add(box_of(i));
            tree.insert(i, items.boxes.back());
        }
        items.build(built);
        require_sound(tree);
        REQUIRE(tree.stats().rebuilds == 0);
        // Nodes split into parts of three at least: 3^8 > 5000. Building parts again by cost takes
        // more levels where sizes or places differ by magnitudes, as the build of all does.
        REQUIRE(tree.stats().depth <= std::max(12u, 2 * built.stats().depth));
        REQUIRE(tree.stats().leaf_count <= count / 3);
        REQUIRE(tree.stats().cost <= 2 * built.stats().cost);
        // Whatever is built again takes memory for its items first: each is a few times.
        REQUIRE(memory.bytes_taken <= 10 * memory_of_build.bytes_taken);
    }
}

TEST_CASE("an octree stays good without a rebuild while all its items wander") {
    for (const bool straight : {true, false}) {
        INFO((straight ? "straight on" : "to and fro"));
        test::Random random(21);
        Items items = scattered(random, 4000, 30);
        std::vector<Vec3> steps;
        for (uint32_t i = 0; i < items.count(); ++i) steps.push_back(random.direction() * 0.1);
        test::WatchedMemory memory;
        Bvh8 tree(&memory);
        items.build(tree);
        const double bytes_of_build = memory.bytes_taken;
        for (int frame = 0; frame < 100; ++frame) {
            for (uint32_t i = 0; i < items.count(); ++i) {
                move(items.boxes[i], straight ? steps[i] : random.direction() * 0.3);
            }
            const double before = memory.bytes_taken;
            items.update(tree);
            // In one frame parts of at most half of the items are built again,
            REQUIRE(memory.bytes_taken - before <= 0.5 * bytes_of_build);
        }
        // on average an eighth.
        REQUIRE(memory.bytes_taken <= bytes_of_build * (1 + 100 / 8.0));
        require_sound(tree);
        REQUIRE(tree.stats().rebuilds == 0);
        REQUIRE(tree.stats().cost <= 1.15f * cost_of_build(items));
    }
}

TEST_CASE("an octree whose items stay about where they are is only refitted") {
    test::Random random(22);
    const Items items = scattered(random, 4000, 30);
    test::WatchedMemory memory;
    Bvh8 tree(&memory);
    items.build(tree);
    const long allocations = memory.allocations;
    for (int frame = 0; frame < 20; ++frame) {
        Items moved = items;
        for (Box& box : moved.boxes) move(box, random.direction() * 0.1);
        moved.update(tree);
    }
    REQUIRE(memory.allocations == allocations);
    require_sound(tree);
}

TEST_CASE("items that jump one by one leave an octree as good as items removed and inserted", "[simulation]") {
    // Of one scene the costs differ by some percent either way, as chance has it.
    float cost_updated = 0, cost_replaced = 0, cost_built = 0;
    for (uint32_t seed = 23; seed < 35; ++seed) {
        test::Random random(seed);
        Items items = scattered(random, 4000, 30);
        Bvh8 updated(std::pmr::get_default_resource()), replaced(std::pmr::get_default_resource());
        items.build(updated);
        items.build(replaced);
        for (uint32_t change = 0; change < 3 * items.count(); ++change) {
            const uint32_t i = change % items.count();
            // One after the other: compilers differ in the order of arguments, and the data would, too.
            const double size = random.uniform(0.4, 2), distance = random.uniform(0, 50);
            items.boxes[i] = box_at(random.direction() * distance, size);
            updated.update(i, items.boxes[i]);
            replaced.remove(i);
            replaced.insert(i, items.boxes[i]);
        }
        require_sound(updated);
        require_sound(replaced);
        cost_updated += updated.stats().cost;
        cost_replaced += replaced.stats().cost;
        cost_built += cost_of_build(items);
    }
    REQUIRE(cost_updated <= 1.02f * cost_replaced);
    REQUIRE(cost_updated <= 1.36f * cost_built);
}

TEST_CASE("an octree stays good and small while its items wander one by one, come and go") {
    test::Random random(24);
    Items items = scattered(random, 3000, 30);
    Bvh8 tree(std::pmr::get_default_resource());
    items.build(tree);
    const uint32_t bytes = tree.stats().memory_bytes;
    for (int round = 0; round < 40; ++round) {
        for (uint32_t i = 0; i < items.count(); ++i) {
            move(items.boxes[i], random.direction() * 0.3);
            if (random.index(20) != 0) {
                tree.update(i, items.boxes[i]);
            } else {
                tree.remove(i);
                tree.insert(i, items.boxes[i]);
            }
        }
    }
    require_sound(tree);
    REQUIRE(tree.stats().rebuilds == 0);
    REQUIRE(tree.stats().cost <= 1.3f * cost_of_build(items));
    REQUIRE(tree.stats().memory_bytes <= 1.5 * bytes);
}

TEST_CASE("an octree stays good while its items go straight on, moved one by one", "[simulation]") {
    test::Random random(25);
    Items items = scattered(random, 3000, 30);
    std::vector<Vec3> steps;
    for (uint32_t i = 0; i < items.count(); ++i) steps.push_back(random.direction() * random.uniform(0, 0.1));
    Bvh8 tree(std::pmr::get_default_resource());
    items.build(tree);
    float worst = 0;
    for (int frame = 1; frame <= 1000; ++frame) {
        for (uint32_t i = 0; i < items.count(); ++i) {
            // To and fro, for 200 frames each way: farther than the middle of the scene.
            move(items.boxes[i], steps[i] * (frame / 200 % 2 == 0 ? 1 : -1));
            tree.update(i, items.boxes[i]);
        }
        if (frame % 100 == 0) worst = std::max(worst, tree.stats().cost / cost_of_build(items));
    }
    require_sound(tree);
    REQUIRE(tree.stats().rebuilds == 0);
    REQUIRE(worst <= 1.8);  // 1.55; without renewal 2.3, and more with more items and frames
}

TEST_CASE("an octree renewed while its items come, go and move is that of its items, and as good as new") {
    for (const uint32_t per_step : {0u, 1u, 7u}) {
        INFO(per_step << " changes for each step of maintenance");
        test::Random random(26 + per_step);
        Items items = scattered(random, 6000, 30);
        Bvh8 tree(std::pmr::get_default_resource());
        // In order of one axis, as a level is streamed.
        std::sort(items.boxes.begin(), items.boxes.end(),
                  [](const Box& a, const Box& b) { return a.min[0] < b.min[0]; });
        for (uint32_t i = 0; i < items.count(); ++i) tree.insert(i, items.boxes[i]);
        const float grown_cost = tree.stats().cost;
        uint32_t steps = 0;
        while (!tree.maintain(20)) {
            REQUIRE(++steps < 3000);
            for (uint32_t change = 0; change < per_step && steps < 40; ++change) {
                const uint32_t i = static_cast<uint32_t>(random.index(static_cast<int>(items.count())));
                const uint32_t kind = static_cast<uint32_t>(random.index(4));
                if (kind == 0) tree.remove(i);
                if (kind <= 1) {
                    const double size = random.uniform(0.4, 2), distance = random.uniform(0, 30);
                    items.boxes[i] = box_at(random.direction() * distance, size);
                }
                if (kind > 1) move(items.boxes[i], random.direction() * 0.3);
                if (kind == 0) {
                    tree.insert(i, items.boxes[i]);
                } else {
                    tree.update(i, items.boxes[i]);
                }
            }
            if (steps % 50 == 0) require_sound(tree);
        }
        REQUIRE(steps > 50);
        require_sound(tree);
        REQUIRE(tree.size() == items.count());
        for (uint32_t i = 0; i < items.count(); ++i) REQUIRE(tree.box(i) == items.boxes[i]);
        if (per_step == 0) REQUIRE(tree.stats().cost < 0.9f * grown_cost);
        REQUIRE(tree.stats().cost <= (per_step == 0 ? 1.001f : 1.2f) * cost_of_build(items));
    }
}

TEST_CASE("an octree of rows that come in order, and of rows in front for rows behind, stays nearly as good as new",
          "[simulation]") {
    constexpr uint32_t count = 20000, row = 70, rows_more = 1000;
    const auto in_rows = [](uint32_t i) { return box_at({2.0 * (i / row), 0, 2.0 * (i % row)}, 1); };
    Items items;
    Bvh8 tree(std::pmr::get_default_resource());
    for (uint32_t i = 0; i < count; ++i) {
        items.add(in_rows(i));
        tree.insert(i, items.boxes[i]);
    }
    const float grown = tree.stats().cost / cost_of_build(items);
    float replaced = 0;
    uint32_t placed = count;
    for (uint32_t r = 0; r < rows_more; ++r) {
        for (uint32_t k = 0; k < row; ++k, ++placed) {
            const uint32_t i = placed % count;
            tree.remove(i);
            tree.insert(i, items.boxes[i] = in_rows(placed));
        }
        if (r % 100 == 99) replaced += tree.stats().cost / cost_of_build(items) / (rows_more / 100);
    }
    require_sound(tree);
    INFO("costs, divided by those of a build: " << grown << " as they came, " << replaced << " in the mean later");
    REQUIRE(tree.stats().rebuilds == 0);
    REQUIRE(grown <= 1.27f);     // 1.18; with eight children for every parent, 1.33
    REQUIRE(replaced <= 1.28f);  // 1.23; 1.31
}

TEST_CASE("an octree in pages of the system is sound while the memory of its renewals is given back") {
    test::Random random(67);
    Memory memory(nullptr);
    constexpr uint32_t count = 40000, steps = 60000;
    Items items = scattered(random, count, 60);
    Bvh8 tree(&memory);
    for (uint32_t i = 0; i < count; ++i) {
        tree.insert(i, items.boxes[i]);
        if (i % 4000 == 0) require_sound(tree);
    }
    for (uint32_t step = 0; step < steps; ++step) {
        const auto i = static_cast<uint32_t>(random.index(count));
        items.boxes[i] = box_at(random.direction() * random.uniform(0, 60), 1);
        tree.remove(i);
        tree.insert(i, items.boxes[i]);
        if (step % 5000 == 0) require_sound(tree);
    }
    require_sound(tree);
    REQUIRE(tree.size() == count);
    for (uint32_t i = 0; i < count; ++i) REQUIRE(tree.box(i) == items.boxes[i]);
    REQUIRE(tree.stats().cost <= 1.3f * cost_of_build(items));
}

TEST_CASE("an octree that loses all its items during a renewal is empty") {
    test::Random random(27);
    const Items items = scattered(random, 2000, 30);
    Bvh8 tree(std::pmr::get_default_resource());
    for (uint32_t i = 0; i < items.count(); ++i) tree.insert(i, items.boxes[i]);
    REQUIRE(!tree.maintain(10));
    for (uint32_t i = 0; i < items.count(); ++i) tree.remove(i);
    while (!tree.maintain(100)) REQUIRE(tree.size() == 0);
    require_sound(tree);
    REQUIRE(tree.size() == 0);
    tree.insert(5, items.boxes[5]);
    require_sound(tree);
    REQUIRE(tree.box(5) == items.boxes[5]);
}

TEST_CASE("a renewal of items at one point halves them") {
    Bvh8 tree(std::pmr::get_default_resource());
    Items items;
    for (uint32_t i = 0; i < 3000; ++i) {
        items.add(box_at({1, 2, 3}, 0.5));
        tree.insert(i, items.boxes.back());
    }
    while (!tree.maintain(50)) require_sound(tree);
    require_sound(tree);
    REQUIRE(tree.stats().cost <= 1.001f * cost_of_build(items));
}

TEST_CASE("an octree that loses most of its items gives up its nodes") {
    test::Random random(25);
    const Items items = scattered(random, 4000, 30);
    Bvh8 tree(std::pmr::get_default_resource());
    items.build(tree);
    for (uint32_t i = 0; i < items.count(); ++i) {
        if (i % 20 != 0) tree.remove(i);
    }
    require_sound(tree);
    REQUIRE(tree.size() == 200);
    // Leaves of two or fewer were dissolved.
    REQUIRE(tree.stats().leaf_count <= 200 / 3);
}

TEST_CASE("any number of workers makes the same octree, bit for bit") {
    test::Random random(26);
    for (const uint32_t count : {1u, 8u, 9u, 500u, 20000u}) {
        Items items = scattered(random, count, 50);
        Bvh8 alone(std::pmr::get_default_resource());
        items.build(alone);
        for (const uint32_t threads : {1u, 2u, 5u}) {
            INFO(count << " items, " << threads << " threads");
            const Workers workers(threads, nullptr, std::pmr::get_default_resource());
            Bvh8 shared(std::pmr::get_default_resource(), chosen_isa(), &workers);
            items.build(shared);
            require_sound(shared);
            REQUIRE(same_nodes(alone, shared));
            if (threads != 5) continue;
            for (int frame = 0; frame < 10; ++frame) {
                for (Box& box : items.boxes) move(box, random.direction());
                items.update(alone);
                items.update(shared);
            }
            require_sound(shared);
            REQUIRE(same_nodes(alone, shared));
        }
    }
}

TEST_CASE("the box around a node is that around its lanes in use, on any instruction set") {
    test::Random random(12);
    for (int round = 0; round < 2000; ++round) {
        BvhNode node{};
        node.count = 1 + random.index(8);
        Box around;
        for (int i = 0; i < 8; ++i) {
            const auto number = [&] { return random.uniform_float(-1, 1) * std::exp2(random.uniform_float(-149, 52)); };
            const float x = number(), y = number(), z = number();
            const Box box{{x, y, z}, {x + std::fabs(number()), y, z + 1}};
            node.boxes.set_lane(i, box);
            if (static_cast<uint32_t>(i) < node.count) around.include(box);
        }
        for (const Isa isa : test::isas()) {
            Box same;
            bvh_kernels(isa).node_bounds(node, same);
            REQUIRE(same == around);
        }
    }
}
