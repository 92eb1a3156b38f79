// The order in which joined bodies are eliminated: what it fills in, what that costs, and whether the result is right.
#include <ctime>
#include <functional>
#include <set>

#include "solver/body_table.h"
#include "solver/joints/elimination_order.h"
#include "solver/joints/joints.h"
#include "solver_world.h"

using gphys::Edge;
using gphys::Vec3;
using test::figure;
using test::World;

namespace {

struct Graph {
    uint32_t nodes;
    gphys::Vector<Edge> edges;
};

Graph chain(uint32_t n) {
    Graph graph{n, {}};
    for (uint32_t i = 0; i + 1 < n; ++i) graph.edges.push_back({i, i + 1});
    return graph;
}
Graph ring(uint32_t n) {
    Graph graph = chain(n);
    graph.edges.push_back({n - 1, 0});
    return graph;
}
Graph star(uint32_t n) {
    Graph graph{n, {}};
    for (uint32_t i = 1; i < n; ++i) graph.edges.push_back({0, i});
    return graph;
}
Graph tree(uint32_t n) {
    Graph graph{n, {}};
    for (uint32_t i = 1; i < n; ++i) graph.edges.push_back({(i - 1) / 3, i});
    return graph;
}
Graph grid(uint32_t columns, uint32_t rows) {
    Graph graph{columns * rows, {}};
    for (uint32_t i = 0; i < graph.nodes; ++i) {
        if (i % columns + 1 < columns) graph.edges.push_back({i, i + 1});
        if (i + columns < graph.nodes) graph.edges.push_back({i, i + columns});
    }
    return graph;
}
Graph random_graph(test::Random& random, uint32_t nodes, uint32_t edges) {
    Graph graph{nodes, {}};
    while (graph.edges.size() < edges) {
        const uint32_t a = random.index(nodes), b = random.index(nodes);
        if (a != b) graph.edges.push_back({a, b});
    }
    return graph;
}

std::vector<uint32_t> order_of(const Graph& graph) {
    gphys::Vector<uint32_t> order;
    gphys::order_by_degree(graph.nodes, graph.edges, order);
    std::vector<uint32_t> sorted(order.begin(), order.end());
    std::sort(sorted.begin(), sorted.end());
    for (uint32_t i = 0; i < sorted.size(); ++i) REQUIRE(sorted[i] == i);
    REQUIRE(order.size() == graph.nodes);
    return {order.begin(), order.end()};
}

struct Elimination {
    std::vector<std::set<uint32_t>> neighbours;
    size_t entries = 0;  // below the diagonal of the factor

    explicit Elimination(const Graph& graph) : neighbours(graph.nodes) {
        for (const Edge& edge : graph.edges) {
            neighbours[edge.a].insert(edge.b);
            neighbours[edge.b].insert(edge.a);
        }
    }
    void eliminate(uint32_t node) {
        const std::set<uint32_t> around = neighbours[node];
        entries += around.size();
        for (const uint32_t a : around) {
            neighbours[a].insert(around.begin(), around.end());
            neighbours[a].erase(a);
            neighbours[a].erase(node);
        }
        neighbours[node].clear();
    }
};

/// Entries that an order leaves beyond those of the graph itself.
size_t filled_in(const Graph& graph, const std::vector<uint32_t>& order) {
    Elimination elimination(graph);
    size_t edges = 0;
    for (const std::set<uint32_t>& around : elimination.neighbours) edges += around.size();
    for (const uint32_t node : order) elimination.eliminate(node);
    return elimination.entries - edges / 2;
}
size_t filled_in(const Graph& graph) { return filled_in(graph, order_of(graph)); }

/// By definition, on the graph itself.
std::vector<uint32_t> minimum_degree(const Graph& graph) {
    Elimination elimination(graph);
    std::vector<uint32_t> order;
    std::vector<bool> done(graph.nodes);
    while (order.size() < graph.nodes) {
        uint32_t best = graph.nodes;
        for (uint32_t n = 0; n < graph.nodes; ++n) {
            if (done[n]) continue;
            if (best == graph.nodes || elimination.neighbours[n].size() < elimination.neighbours[best].size()) best = n;
        }
        done[best] = true;
        order.push_back(best);
        elimination.eliminate(best);
    }
    return order;
}

/// Of processor time, the least of several.
double seconds_of(const std::function<void()>& work) {
    double best = gphys::infinity;
    for (int i = 0; i < 9; ++i) {
        const std::clock_t begin = std::clock();
        work();
        best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    return best;
}

}  // namespace

TEST_CASE("paths, stars and trees are ordered so that nothing is filled in") {
    for (const uint32_t n : {2u, 3u, 17u, 100u, 1000u}) {
        CHECK(filled_in(chain(n)) == 0);
        CHECK(filled_in(star(n)) == 0);
        CHECK(filled_in(tree(n)) == 0);
        // Each node that is taken out of a ring leaves an edge between its neighbours, until three are left.
        if (n > 3) CHECK(filled_in(ring(n)) == n - 3);
    }
}

TEST_CASE("a ladder and a grid are filled in no more than they must") {
    // Across a ladder two nodes always part it: each pair of rungs adds two entries at most.
    CHECK(filled_in(grid(2, 200)) <= 400);
    // By nested dissection 31/4 n^2 log2(n) entries at most in all (George 1973); minimum degree does better on
    // grids of this size. By rows it would be n^3.
    for (const uint32_t n : {10u, 20u, 40u}) {
        const Graph graph = grid(n, n);
        const double filled = static_cast<double>(filled_in(graph));
        figure("entries filled in for each node of a grid", filled / (n * n), "");
        CHECK(filled <= 31.0 / 4 * n * n * std::log2(n) / 2);
    }
}

TEST_CASE("the order is that of minimum degree by its definition") {
    test::Random random(5);
    for (uint32_t i = 0; i < 60; ++i) {
        const uint32_t nodes = 2 + random.index(60);
        const Graph graph = random_graph(random, nodes, random.index(3 * nodes));
        CHECK(order_of(graph) == minimum_degree(graph));
    }
    CHECK(order_of(grid(12, 12)) == minimum_degree(grid(12, 12)));
}

TEST_CASE("a graph is ordered in little more time than it takes to read it", "[simulation]") {
    // A hub beside half of the others: to read its list in each elimination would take n^2.
    const auto time_of = [](uint32_t n) {
        Graph wheel = ring(n);
        for (uint32_t i = 1; i < n; i += 2) wheel.edges.push_back({0, i});
        return seconds_of([&] { order_of(wheel); });
    };
    const double few = time_of(25000), many = time_of(100000);
    figure("a wheel of 100000 nodes is ordered in", many * 1e3, "ms");
    CHECK(many <= 8 * few);
}

namespace {

/// A hub and its neighbours, all of them free particles.
struct Star {
    gphys::Memory memory{nullptr};
    gphys::BodyTable bodies{&memory};
    gphys::Vector<gphys::Joint> joints;
    gphys::JointSystem system{std::pmr::get_default_resource()};
    static constexpr double h = 0.002;

    Star(uint32_t neighbours, uint64_t seed, bool pinned) {
        test::Random random(seed);
        bodies.reserve_slot();
        bodies.put(0, gphys::new_body(&memory));
        gphys::Body& body = bodies[0];
        for (uint32_t i = 0; i <= neighbours; ++i) {
            const Vec3 at = i == 0 ? Vec3{} : random.direction() * random.uniform(0.5, 2);
            body.particles.position.push_back(at);
            body.history.start.push_back(at);
            body.history.predicted.push_back(at + random.direction() * 0.01);
            body.particles.mass.push_back(random.uniform(0.1, 10));
            const bool held = pinned && i % 7 == 3;
            if (held) body.history.predicted.back() = at;
            body.particles.inverse_mass.push_back(held ? 0 : 1 / body.particles.mass.back());
        }
        for (uint32_t i = 0; i <= neighbours; ++i) system.add_node(0, i, false);
        for (uint32_t i = 1; i <= neighbours; ++i) {
            joints.push_back({0, 0, 0, i, length(body.particles.position[i]), 0, {}});
            gphys::JointSystem::Link link{};
            link.a = 0;
            link.b = i;
            link.owner = gphys::JointSystem::of_joint;
            link.index = i - 1;
            system.add_link(link);
        }
        for (size_t p = 0; p < body.particles.position.size(); ++p) {
            if (!body.particles.pinned(static_cast<uint32_t>(p)))
                body.particles.position[p] = body.history.predicted[p];
        }
        system.plan();
    }
};

}  // namespace

TEST_CASE("a star of joints is filled in linearly") {
    const Star small(400, 1, false), large(1600, 1, false);
    figure("entries for each joint", static_cast<double>(large.system.fill()) / 1600, "");
    CHECK(large.system.fill() <= 4.1 * static_cast<double>(small.system.fill()));
}

TEST_CASE("a star of joints moves as its equations say") {
    // Each particle is where its own inertia and the tensions put it, m (x - predicted) / h^2 = force, and each joint
    // is as long as it shall be.
    for (const uint32_t neighbours : {5u, 40u, 300u}) {
        Star star(neighbours, neighbours, false);
        gphys::Body& body = star.bodies[0];
        star.system.gather(star.bodies, star.joints, Star::h);
        for (int i = 0; i < 4; ++i) star.system.solve();  // each goes on from where the one before ended
        star.system.scatter(star.bodies);
        star.system.scatter_tensions(star.bodies, star.joints);
        std::vector<Vec3> forces(body.particles.size());
        double gap = 0, largest = 0, residual = 0;
        for (uint32_t i = 1; i < body.particles.size(); ++i) {
            const Vec3 along = body.particles.position[i] - body.particles.position[0];
            const gphys::Joint& joint = star.joints[i - 1];
            gap = std::max(gap, std::fabs(length(along) - joint.rest));
            const Vec3 pull = along / length(along) * joint.tension.x;
            forces[0] += pull;
            forces[i] -= pull;
            largest = std::max(largest, length(pull));
        }
        for (uint32_t i = 0; i < body.particles.size(); ++i) {
            const Vec3 inertia = (body.particles.position[i] - body.history.predicted[i]) *
                                 (body.particles.mass[i] / (Star::h * Star::h));
            residual = std::max(residual, length(inertia - forces[i]));
        }
        // Regularisation leaves 1e-10 of a correction; rounding 1e-16 of places, times m / h^2.
        CHECK(gap < 1e-9);
        CHECK(residual < 1e-9 * largest);
    }
}

TEST_CASE("a star of joints to particles that do not move is held by them") {
    Star star(100, 3, true);
    gphys::Body& body = star.bodies[0];
    // Three or more pins hold the hub where it began; its joints to them have the lengths of then.
    star.system.gather(star.bodies, star.joints, Star::h);
    for (int i = 0; i < 4; ++i) star.system.solve();
    star.system.scatter(star.bodies);
    CHECK(length(body.particles.position[0]) < 1e-8);
    for (uint32_t i = 1; i < body.particles.size(); ++i) {
        CHECK(std::fabs(distance(body.particles.position[i], body.particles.position[0]) - star.joints[i - 1].rest) <
              1e-8);
    }
}

TEST_CASE("a step of n bodies joined to one takes as long as one of n bodies in a row", "[simulation]") {
    // Both have as many nodes and links, and nothing is filled in. How their times grow with n depends on the caches.
    const auto time_of = [](uint32_t n, bool row) {
        World world;
        gphys_body_id last = world.particles({{0, 0, 0}});
        for (uint32_t i = 1; i < n; ++i) {
            const gphys_body_id body = world.particles({{static_cast<float>(i) * 0.1f, 0, 0}});
            gphys_joint_id joint;
            REQUIRE(gphys_solver_join(world.solver, last, 0, body, 0, -1, 0, &joint) == GPHYS_OK);
            if (row) last = body;
        }
        world.step(1.0f / 60);
        return seconds_of([&] { world.step(1.0f / 60); });
    };
    const double in_row = time_of(12800, true), around = time_of(12800, false);
    figure("12800 bodies joined to one take", around * 1e3, "ms a step");
    CHECK(around <= 1.5 * in_row);
}
