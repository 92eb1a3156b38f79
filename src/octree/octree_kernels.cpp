#include "octree/octree_kernels.h"

#include "octree/octree_many.h"
#include "octree/ray_lanes.h"

namespace gphys::GPHYS_ISA {

namespace {

void make_probes(const Ray* rays, uint32_t count, const RaysRoot& root, RayProbe* probes, float* limits) {
    for (uint32_t first = 0; first < count; first += 8) {
        const Rays8 eight(rays + first, count - first);
        const RaySetup<Double8> setup(eight.origin, eight.direction, root);
        RayProbe* const to = probes + first;
        store(limits + first, put_probes(eight.t_max, setup, [&](int i) -> RayProbe& { return to[i]; }));
    }
}

template <class Test, class Probe>
void walk_nearest_first(const OctreeNode* nodes, uint32_t root, const Probe& probe, float limit,
                        const OctreeVisitor& to) {
    nearest_first(nodes, root, Test(probe), limit, [&](uint32_t item) { return to.visit(to.context, item); });
}

template <class Walk>
void walk_rays(const OctreeNode* nodes, uint32_t root, const RayProbe* probes, const float* limits, uint32_t count,
               bool together, const OctreeRayVisitor& to) {
    const auto probe_of = [&](uint32_t ray) -> const RayProbe& { return probes[ray]; };
    const auto visit = [&](const uint32_t* rays, const uint32_t* items, uint32_t some, float* new_limits) {
        return to.visit(to.context, rays, items, some, new_limits);
    };
    const auto fetch = [&](uint32_t item) __attribute__((always_inline)) { fetch_item(to.items, item); };
    if (!together) return rays_in_turns<Walk>(nodes, root, probe_of, limits, count, visit, fetch);
    RayLimits of_all(count, [&](uint32_t ray) { return limits[ray]; });
    const auto visit_and_set = [&](const uint32_t* rays, const uint32_t* items, uint32_t some) {
        float new_limits[8];
        for (uint32_t moved = visit(rays, items, some, new_limits); moved != 0; moved &= moved - 1) {
            const int i = __builtin_ctz(moved);
            of_all.limits[rays[i]] = new_limits[i];
        }
    };
    VisitsByEight visits(visit_and_set);
    BundleTest bundle(probe_of, of_all.limits, count);
    const bool done = rays_together(
        nodes, root, bundle, count, [&](uint32_t group, uint32_t set, uint32_t item) { visits.add(group, set, item); },
        [&] { visits.finish(); }, fetch);
    if (!done) rays_in_turns<Walk>(nodes, root, probe_of, of_all.limits, count, visit, fetch);
}

void walk_ray_any(const OctreeNode* nodes, uint32_t root, const RayProbe& probe, float limit, const OctreeVisitor& to) {
    if (!(limit >= 0)) return;
    const RayTest test(probe);
    everywhere(
        nodes, root,
        [&](const Box8& boxes) {
            Float8 entry;
            return test.hits(boxes, limit, entry);
        },
        [&](const OctreeNode& leaf, uint32_t lanes) {
            for (; lanes != 0; lanes &= lanes - 1) {
                if (to.visit(to.context, leaf.child[__builtin_ctz(lanes)]) < 0) return false;
            }
            return true;
        });
}

bool walk_box(const OctreeNode* nodes, uint32_t root, const Box& box, const OctreeListVisitor& to) {
    const BoxTest test(box);
    return everything_met(
        nodes, root, [&](const Box8& boxes, uint32_t& inside) { return test.hits(boxes, inside); }, to);
}

bool walk_ball(const OctreeNode* nodes, uint32_t root, const BallProbe& probe, const OctreeListVisitor& to) {
    const BallTest test(probe);
    return everything_met(
        nodes, root, [&](const Box8& boxes, uint32_t& inside) { return test.hits(boxes, inside); }, to);
}

template <class Test, class Query>
void walk_several(const OctreeNode* nodes, uint32_t root, const Query* queries, uint32_t count, ItemMemory items,
                  ItemMemory items_inside, ItemsMet* met) {
    everything_met_by_several(
        nodes, root, count,
        [&](uint32_t query, const Box8& boxes, uint32_t& inside) { return Test(queries[query]).hits(boxes, inside); },
        items, items_inside, met);
}

/// Planes that a node is wholly inside need no test below it, and when none is left the whole
/// subtree is inside (Assarsson and Möller 2000).
bool walk_frustum(const OctreeNode* nodes, uint32_t root, const FrustumProbe& probe, const OctreeListVisitor& to) {
    const FrustumTest test(probe);
    const BoxTest around(probe.around);
    FoundItems found(to);
    NodesToVisit crossing(nodes);
    crossing.push_root(root, FrustumTest::all_planes);
    uint32_t wholly, planes[8];  // lanes that are inside, and the planes of the others
    const auto look = [&](const OctreeNode& node, uint32_t planes_of_node) {
        Float8 crossed;
        const uint32_t hits = lanes_of(node) & around.hits(node.boxes) & test.hits(node.boxes, planes_of_node, crossed);
        wholly = hits & bits(crossed <= splat(0));
        const Float8 sets = integer_bits(crossed);
        std::memcpy(planes, &sets, sizeof planes);
        return hits;
    };
    while (!crossing.empty()) {
        while (!crossing.leaf_is_next()) {
            const auto [node, planes_of_node] = crossing.take_inner();
            const uint32_t hits = look(node, planes_of_node);
            crossing.push(node, hits & ~wholly, planes);
            if (wholly != 0 && !found.add_below(nodes, node, wholly)) return false;
        }
        while (crossing.has_leaf()) {
            const auto [leaf, planes_of_leaf] = crossing.take_leaf();
            if (to.asks_inside) {
                const uint32_t hits = look(leaf, planes_of_leaf);
                if (!found.add(leaf.child, hits, wholly)) return false;
            } else {
                const uint32_t hits = around.hits(leaf.boxes) & test.hits(leaf.boxes, planes_of_leaf);
                if (!found.add(leaf.child, hits & lanes_of(leaf))) return false;
            }
        }
    }
    return found.finish();
}

/// Both trees at once: each lane of one node is tested against the eight of the other, and where
/// one side is a leaf the other goes down alone.
bool walk_pairs(const OctreeNode* nodes, uint32_t root, const OctreeNode* other_nodes, uint32_t other_root,
                const OctreePairVisitor& to) {
    const auto below_other = [&](uint32_t item, const BoxTest& test, uint32_t ref) {
        return everywhere(
            other_nodes, ref, [&](const Box8& boxes) { return test.hits(boxes); },
            [&](const OctreeNode& leaf, uint32_t lanes) {
                for (; lanes != 0; lanes &= lanes - 1) {
                    if (!to.visit(to.context, item, leaf.child[__builtin_ctz(lanes)])) return false;
                }
                return true;
            });
    };
    struct Pair {
        uint32_t a, b;
    };
    // Each step goes down at least one level on one side and leaves at most 63 pairs behind.
    Pair stack[64 * octree_max_levels];
    int size = 0;
    stack[size++] = {root, other_root};
    while (size > 0) {
        const Pair pair = stack[--size];
        const OctreeNode& a = node_at(nodes, pair.a);
        const OctreeNode& b = node_at(other_nodes, pair.b);
        for (uint32_t i = 0; i < a.count; ++i) {
            const BoxTest test(a.boxes, i);
            if (is_leaf(pair.a)) {
                if (!below_other(a.child[i], test, pair.b)) return false;
                continue;
            }
            uint32_t rest = test.hits(b.boxes) & lanes_of(b);
            if (is_leaf(pair.b)) {
                if (rest != 0) stack[size++] = {a.child[i], pair.b};
            } else {
                for (; rest != 0; rest &= rest - 1) stack[size++] = {a.child[i], b.child[__builtin_ctz(rest)]};
            }
        }
    }
    return true;
}

/// Of three rows the least of each, of both halves of the lanes: out[k] or out[4 + k].
void least_of_rows(const Float8 (&rows)[3], float (&out)[8]) {
    Float8 least;
    for (int i = 0; i < register_count; ++i) {
        FloatRegister lanes[4] = {rows[0].part[i], rows[1].part[i], rows[2].part[i], rows[2].part[i]};
        transpose(lanes);
        least.part[i] = minimum(minimum(lanes[0], lanes[1]), minimum(lanes[2], lanes[3]));
    }
    store(out, least);
}

void around_node(const OctreeNode& node, Box& out) {
    static constexpr float numbers[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const Mask8 used = load(numbers) <= splat(static_cast<float>(node.count) - 1);
    const Float8 beyond_all = splat(__FLT_MAX__), zero = splat(0);
    Float8 low[3], high[3];  // the latter with the other sign
    for (int k = 0; k < 3; ++k) {
        low[k] = choose(used, load(node.boxes.row[k]), beyond_all);
        high[k] = choose(used, zero - load(node.boxes.row[3 + k]), beyond_all);
    }
    float min[8], less_max[8];
    least_of_rows(low, min);
    least_of_rows(high, less_max);
    for (int k = 0; k < 3; ++k) {
        out.min[k] = min[k] < min[4 + k] ? min[k] : min[4 + k];
        out.max[k] = 0 - (less_max[k] < less_max[4 + k] ? less_max[k] : less_max[4 + k]);
    }
}

}  // namespace

extern const OctreeKernels octree_kernels{
    make_probes,
    walk_nearest_first<RayTest, RayProbe>,
    walk_rays<NearestFirst>,
    walk_rays<LongestFirst>,
    walk_nearest_first<PointTest, PointProbe>,
    walk_ray_any,
    walk_box,
    walk_ball,
    walk_several<BoxTest, Box>,
    walk_several<BallTest, BallProbe>,
    walk_frustum,
    walk_pairs,
    around_node,
};

}  // namespace gphys::GPHYS_ISA
