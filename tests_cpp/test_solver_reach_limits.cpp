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

void check_lists(const RigidLinks& a, const RigidLinks& b) {
    REQUIRE(a.begin == b.begin);
    const auto same = [](const RigidLinks::End& l, const RigidLinks::End& r) {
        return l.to == r.to && l.slot == r.slot && l.rest == r.rest;
    };
    REQUIRE(std::equal(a.at.begin(), a.at.end(), b.at.begin(), b.at.end(), same));
}

bool same_paths(const Vector<PinPath>& a, const Vector<PinPath>& b) {
    const auto same = [](const PinPath& l, const PinPath& r) {
        return l.length == r.length && l.particle == r.particle && l.anchor == r.anchor;
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
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

TEST_CASE("after edits of links the shortest ways from pins are those of a search of all, bit by bit") {
    test::Random random(27);
    size_t repaired = 0, unreachable = 0;
    for (int round = 0; round < 400; ++round) {
        uint32_t size = 5 + random.index(60);
        Body body = random_graph(random, size, size + random.index(size), 1 + random.index(6));
        // Sums of other lengths are rounded, and ends of links without length are equally far away.
        for (DistanceConstraint& link : body.constraints.by_slot) {
            if (round % 2 == 1) link.rest = round % 4 == 3 && random.index(4) == 0 ? 0 : random.uniform(0.1, 0.3);
        }
        update_plan(body);
        for (int step = 0; step < 6; ++step) {
            for (uint32_t edit = random.index(4); edit-- > 0;) {
                const uint32_t slot = random.index(body.constraints.ids.slots());
                if (random.index(2) == 0 && body.constraints.ids.live(slot)) {
                    REQUIRE(remove_constraint(body, body.constraints.ids.id(slot)) == GPHYS_OK);
                    continue;
                }
                if (random.index(8) == 0) {  // as tearing does
                    body.particles.position.emplace_back();
                    body.particles.inverse_mass.push_back(1);
                    body.constraints.links.emplace_back();
                    ++size;
                }
                const uint32_t a = random.index(size), b = random.index(8) == 0 ? size - 1 : random.index(size);
                gphys_constraint_id ignored;
                if (a != b) REQUIRE(add_constraint(body, {a, b, 1.0 + random.index(4), 0, 0, 0}, ignored) == GPHYS_OK);
            }
            if (random.index(3) == 0) {
                body.particles.inverse_mass[random.index(size)] = random.index(2);
                body.plan.reach_current = false;
            }
            const bool known = !body.cloth.reach.paths.empty();
            update_plan(body);
            if (body.plan.method != GPHYS_SOLVE_GRAPH) break;
            RigidLinks lists(std::pmr::get_default_resource());
            lists.list(body.constraints, size);
            check_lists(body.cloth.rigid, lists);
            Vector<PinPath> paths;
            update_pin_paths(paths, lists, body.particles);
            REQUIRE(same_paths(body.cloth.reach.paths, paths));
            repaired += known;
            unreachable += paths.size() < size;
        }
    }
    CHECK(repaired > 500);
    CHECK(unreachable > 50);
}
