// Reach limits: no particle of a graph further from a pinned one than the rigid links between them are long.
#include <algorithm>

#include "solver/solver.h"
#include "test.h"

using namespace gphys;

namespace {

/// Particles with random links of 1 to 4 m, so that many ways are of one length and no sum is rounded.
Body random_graph(test::Random& random, uint32_t size, uint32_t link_count, uint32_t pin_count) {
    Body body(std::pmr::get_default_resource());
    body.particles.position.resize(size);
    body.particles.inverse_mass.assign(size, 1.0);
    body.constraints.links.resize(size);
    for (uint32_t i = 0; i < link_count; ++i) {
        const uint32_t a = random.index(size), b = random.index(size);
        gphys_constraint_id ignored;
        const double elastic = random.index(8) == 0 ? 1e-3 : 0.0;
        if (a != b) REQUIRE(add_constraint(body, {a, b, 1.0 + random.index(4), elastic, 0, 0}, ignored) == GPHYS_OK);
    }
    for (uint32_t i = 0; i < pin_count; ++i) body.particles.inverse_mass[random.index(size)] = 0;
    return body;
}

/// From one particle to all, by going over all links until nothing changes (Bellman & Ford).
std::vector<double> distances_from(const Body& body, uint32_t pin) {
    std::vector<double> distances(body.particles.size(), infinity);
    distances[pin] = 0;
    for (bool changed = true; changed;) {
        changed = false;
        for (const DistanceConstraint& link : body.constraints.by_slot) {
            if (link.compliance > 0) continue;
            for (const auto& [from, to] : {std::pair(link.a, link.b), std::pair(link.b, link.a)}) {
                if (distances[from] + link.rest >= distances[to]) continue;
                distances[to] = distances[from] + link.rest;
                changed = true;
            }
        }
    }
    return distances;
}

/// As long as the way from the pin that each names, and a millionth of slack. Returns how many.
size_t check_limits(const Body& body) {
    const uint32_t size = body.particles.size();
    std::vector<std::vector<double>> wanted(size), found(size), from(size);
    for (uint32_t pin = 0; pin < size; ++pin) {
        if (!body.particles.pinned(pin)) continue;
        from[pin] = distances_from(body, pin);
        for (uint32_t p = 0; p < size; ++p) {
            if (!body.particles.pinned(p) && from[pin][p] < infinity) wanted[p].push_back(from[pin][p]);
        }
    }
    for (const ReachLimit& limit : body.cloth.reach.limits) {
        REQUIRE(body.particles.pinned(limit.anchor));
        REQUIRE(limit.distance == from[limit.anchor][limit.particle] * (1 + 1e-6));
        found[limit.particle].push_back(limit.distance);
    }
    for (uint32_t p = 0; p < size; ++p) {
        std::sort(wanted[p].begin(), wanted[p].end());
        wanted[p].resize(std::min<size_t>(wanted[p].size(), 4));
        for (double& distance : wanted[p]) distance *= 1 + 1e-6;
        REQUIRE(found[p] == wanted[p]);
    }
    return body.cloth.reach.limits.size();
}

bool same_limits(const Vector<ReachLimit>& a, const Vector<ReachLimit>& b) {
    const auto same = [](const ReachLimit& l, const ReachLimit& r) {
        return l.particle == r.particle && l.anchor == r.anchor && l.distance == r.distance;
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

}  // namespace

TEST_CASE(
    "reach limits are the lengths of the shortest ways from the four nearest pins, also of pins that come and go") {
    test::Random random(26);
    size_t count = 0;
    for (int round = 0; round < 200; ++round) {
        const uint32_t size = 5 + random.index(60);
        Body body = random_graph(random, size, 2 * size, 1 + random.index(12));
        update_plan(body);
        const auto find_limits = [&] {
            plan_reach_limits(body.cloth.reach, body.cloth.rigid, body.particles, body.cloth.sheet);
        };
        count += check_limits(body);
        for (int edit = 0; edit < 4; ++edit) {
            double& inverse_mass = body.particles.inverse_mass[random.index(size)];
            inverse_mass = inverse_mass == 0 ? 1 : 0;
            find_limits();
            check_limits(body);
            // In the same order as those that are found all at once.
            const Vector<ReachLimit> followed = body.cloth.reach.limits;
            body.cloth.reach.paths.clear();
            find_limits();
            REQUIRE(same_limits(followed, body.cloth.reach.limits));
        }
    }
    CHECK(count > 5000);
}
