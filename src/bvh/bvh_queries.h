// The queries of bvh8.h: each makes a probe, runs a kernel (bvh_kernels.h), and passes the items to the visitor.
// Visitors are templates here and function pointers in the kernels, so that the kernels are compiled once.
#pragma once

#include <type_traits>

#include "bvh/bvh8.h"
#include "foundation/compiler.h"

namespace gphys {

/// Runs a kernel whose visitor lowers a bound (t_max or a distance). The probe converts the bound to the kernel's
/// limit.
template <class Probe, class Visit>
void Bvh8::traverse_to_bound(void (*kernel)(const BvhNode*, uint32_t, const Probe&, float, const BvhVisitor&),
                             const Probe& probe, double bound, float limit, Visit& visit, ItemMemory items) const {
    struct Context {
        const Probe& probe;
        Visit& visit;
        double bound;
        float limit;
    };
    Context state{probe, visit, bound, limit};
    const auto step = [](void* context, uint32_t item) {
        Context& c = *static_cast<Context*>(context);
        const double before = c.bound;
        c.visit(item, c.bound);
        if (c.bound != before) c.limit = c.probe.limit(c.bound);
        return c.limit;
    };
    kernel(nodes_.data(), root_, probe, limit, {step, &state, items});
}

/// Whether a ray begins beyond a side of the box and goes away from it.
inline bool leaves(const Box& box, const Ray& ray) {
    bool away = false;
    const auto test = [&](double from, double along, float low, float high) {
        away |= ((high < from) & (0 <= along)) | ((from < low) & (along <= 0));
    };
    test(ray.origin.x, ray.direction.x, box.min[0], box.max[0]);
    test(ray.origin.y, ray.direction.y, box.min[1], box.max[1]);
    test(ray.origin.z, ray.direction.z, box.min[2], box.max[2]);
    return away;
}

/// A kernel for a tree of one item whose visitor tests it: that says as much as a test of its box.
inline void visit_only_item(const BvhNode* nodes, uint32_t root, const RayProbe&, float, const BvhVisitor& to) {
    to.visit(to.context, nodes[root & ~bvh_leaf_bit].child[0]);
}

template <class MakeVisit>
void Bvh8::traverse_ray(decltype(BvhKernels::ray) kernel, const Ray& ray, double t_max, const MakeVisit& make_visit,
                        ItemMemory items) const {
    if (root_ == none) return;
    RayProbe probe;
    float limit = 0;
    if (kernel == visit_only_item) {
        if (leaves(bounds_, ray)) return;
        probe.path = {0, 1, 0, 0};
    } else {
        limit = kernels_.probe(ray, t_max, bounds_, probe);
        if (!(limit >= 0)) return;
    }
    auto&& visit = make_visit();
    traverse_to_bound(kernel, probe, t_max, limit, visit, items);
}

template <class Visit>
void Bvh8::raycast(const Ray& ray, double t_max, Visit&& visit, ItemMemory items) const {
    traverse_ray(
        kernels_.ray, ray, t_max, [&]() -> Visit& { return visit; }, items);
}

template <class MakeVisit>
void Bvh8::raycast_by(const Ray& ray, double t_max, MakeVisit&& make_visit, ItemMemory items) const {
    traverse_ray(size_ == 1 && is_leaf(root_) ? visit_only_item : kernels_.ray, ray, t_max, make_visit, items);
}

template <class Visit>
void Bvh8::traverse_rays(decltype(BvhKernels::rays) kernel, const Ray* rays, uint32_t count, Visit& visit,
                         ItemMemory items) const {
    if (root_ == none || count == 0) return;
    struct Context {
        Context(const Ray* r, Visit& v) : rays(r), visit(v) {}

        RayProbe probes[rays_at_once];
        float limits[rays_at_once];
        uint32_t first;  // ray of the present run
        const Ray* rays;
        Visit& visit;

        uint32_t visit_pairs(const uint32_t* from_first, const uint32_t* some, uint32_t size, float* new_limits) {
            uint32_t numbers[8];
            for (uint32_t k = 0; k < size; ++k) numbers[k] = first + from_first[k];
            const uint32_t shorter = visit(numbers, some, size);
            for (uint32_t rest = shorter; rest != 0; rest &= rest - 1) {
                const int k = lowest_bit(rest);
                new_limits[k] = probes[numbers[k]].limit(rays[numbers[k]].t_max);
            }
            return shorter;
        }
    };
    Context state(rays, visit);
    kernels_.probes(rays, count, RootBounds(bounds_), state.probes, state.limits);
    const auto visit_pairs = [](void* context, const uint32_t* from_first, const uint32_t* some, uint32_t size,
                                float* new_limits) {
        return static_cast<Context*>(context)->visit_pairs(from_first, some, size, new_limits);
    };
    const auto probe_of = [&](uint32_t i) -> const RayProbe& { return state.probes[i]; };
    const auto ray_of = [&](uint32_t i) -> const Ray& { return rays[i]; };
    RayPackets(bounds_, size_).split(ray_of, probe_of, count, [&](uint32_t first, uint32_t last, bool is_packet) {
        state.first = first;
        kernel(nodes_.data(), root_, state.probes + first, state.limits + first, last - first, is_packet,
               {visit_pairs, &state, items});
    });
}

template <class Visit>
void Bvh8::raycast_many(const Ray* rays, uint32_t count, Visit&& visit, ItemMemory items) const {
    traverse_rays(kernels_.rays, rays, count, visit, items);
}

template <class Visit>
void Bvh8::raycast_any_many(const Ray* rays, uint32_t count, Visit&& visit, ItemMemory items) const {
    traverse_rays(kernels_.rays_any, rays, count, visit, items);
}

template <class Visit>
bool Bvh8::raycast_any(const Ray& ray, Visit&& visit, ItemMemory items) const {
    return raycast_any_by(
        ray, [&] { return [&](uint32_t item) { return visit(item); }; }, items);
}

template <class MakeVisit>
bool Bvh8::raycast_any_by(const Ray& ray, MakeVisit&& make_visit, ItemMemory items) const {
    bool found = false;
    const auto make_until_found = [&] {
        return [&found, visit = make_visit()](uint32_t item, double& t_max) {
            found = visit(item);
            if (found) t_max = -1;
        };
    };
    const auto kernel = size_ == 1 && is_leaf(root_) ? visit_only_item : kernels_.ray_any;
    traverse_ray(kernel, ray, ray.t_max, make_until_found, items);
    return found;
}

template <class Visit>
void Bvh8::sweep(Vec3 center, Vec3 displacement, double radius, Visit&& visit, ItemMemory items) const {
    if (root_ == none) return;
    const RayProbe probe(center, displacement, radius, bounds_);
    traverse_to_bound(kernels_.ray, probe, 1, probe.limit(1), visit, items);
}

template <class Visit>
void Bvh8::sweep(Vec3 middle, Vec3 displacement, Vec3 half, Visit&& visit, ItemMemory items) const {
    if (root_ == none) return;
    const RayProbe probe(middle, displacement, half, bounds_);
    traverse_to_bound(kernels_.ray, probe, 1, probe.limit(1), visit, items);
}

template <class Visit>
void Bvh8::nearest(Vec3 point, double max_distance, Visit&& visit, ItemMemory items) const {
    if (root_ == none) return;
    const PointProbe probe(point, bounds_);
    traverse_to_bound(kernels_.point, probe, max_distance, probe.limit(max_distance), visit, items);
}

template <class Visit>
void Bvh8::nearest_many(const Vec3* points, uint32_t count, double* reaches, Visit&& visit, ItemMemory items) const {
    if (root_ == none) return;
    struct Context {
        Context(double* r, Visit& v) : reaches(r), visit(v) {}

        PointProbe probes[points_at_once];
        double* reaches;
        Visit& visit;
    };
    Context state(reaches, visit);
    float limits[points_at_once];
    for (uint32_t i = 0; i < count; ++i) {
        state.probes[i] = PointProbe(points[i], bounds_);
        limits[i] = state.probes[i].limit(reaches[i]);
    }
    const auto visit_pairs = [](void* context, const uint32_t* numbers, const uint32_t* some, uint32_t size,
                                float* new_limits) {
        Context& c = *static_cast<Context*>(context);
        uint32_t nearer = 0;
        for (uint32_t k = 0; k < size; ++k) {
            double& reach = c.reaches[numbers[k]];
            const double before = reach;
            c.visit(numbers[k], some[k]);
            if (reach == before) continue;
            new_limits[k] = c.probes[numbers[k]].limit(reach);
            nearer |= 1u << k;
        }
        return nearer;
    };
    kernels_.points(nodes_.data(), root_, state.probes, limits, count, {visit_pairs, &state, items});
}

template <class Visit>
void Bvh8::nearest(const WeightedPointProbe& probe, double max_distance, Visit&& visit) const {
    if (root_ == none) return;
    traverse_to_bound(kernels_.weighted_point, probe, max_distance, probe.limit(max_distance), visit, {});
}

/// Adapts a visitor of lists or of single items.
template <class Visit>
BvhListVisitor Bvh8::list_visitor(Visit& visit, ItemMemory items, ItemMemory items_inside) {
    constexpr bool ignores_inside = std::is_invocable_v<Visit&, const uint32_t*, uint32_t>;
    const auto all = [](void* context, const uint32_t* list, uint32_t count, [[maybe_unused]] bool inside) -> bool {
        Visit& to = *static_cast<Visit*>(context);
        if constexpr (ignores_inside) {
            return to(list, count);
        } else if constexpr (std::is_invocable_v<Visit&, const uint32_t*, uint32_t, bool>) {
            return to(list, count, inside);
        } else {
            return std::all_of(list, list + count, [&](uint32_t item) { return to(item, inside); });
        }
    };
    return {all, const_cast<void*>(static_cast<const void*>(&visit)), items, items_inside, !ignores_inside};
}

template <class Visit>
bool Bvh8::overlap_box(const Box& box, Visit&& visit, ItemMemory items, ItemMemory items_inside) const {
    return root_ == none || kernels_.box(nodes_.data(), root_, box, list_visitor(visit, items, items_inside));
}

template <class Visit>
bool Bvh8::overlap_ball(Vec3 center, double radius, Visit&& visit, ItemMemory items, ItemMemory items_inside) const {
    return root_ == none || kernels_.ball(nodes_.data(), root_, BallProbe(center, radius, bounds_),
                                          list_visitor(visit, items, items_inside));
}

inline void Bvh8::overlap_boxes(const Box* boxes, uint32_t count, ItemMemory items, ItemMemory items_inside,
                                OverlapItems* found) const {
    for (uint32_t i = 0; i < count; ++i) found[i].clear();
    if (root_ != none) kernels_.boxes(nodes_.data(), root_, boxes, count, items, items_inside, found);
}

inline void Bvh8::overlap_balls(const Sphere* balls, uint32_t count, ItemMemory items, ItemMemory items_inside,
                                OverlapItems* found) const {
    BallProbe probes[OverlapItems::max_queries];
    for (uint32_t i = 0; i < count; ++i) {
        found[i].clear();
        probes[i] = BallProbe(balls[i].center, balls[i].radius, bounds_);
    }
    if (root_ != none) kernels_.balls(nodes_.data(), root_, probes, count, items, items_inside, found);
}

template <class Visit>
bool Bvh8::frustum(const Frustum& frustum, const Box& around, Visit&& visit, ItemMemory items,
                   ItemMemory items_inside) const {
    return root_ == none || kernels_.frustum(nodes_.data(), root_, FrustumProbe(frustum, around),
                                             list_visitor(visit, items, items_inside));
}

template <class Visit>
bool Bvh8::overlap_pairs(const Bvh8& other, Visit&& visit) const {
    if (root_ == none || other.root_ == none) return true;
    using Function = std::remove_reference_t<Visit>;
    const auto pair = [](void* context, uint32_t item, uint32_t other_item) {
        return (*static_cast<Function*>(context))(item, other_item);
    };
    return kernels_.pairs(nodes_.data(), root_, other.nodes_.data(), other.root_,
                          {pair, const_cast<void*>(static_cast<const void*>(&visit))});
}

template <class MayOverlap, class Visit>
bool Bvh8::overlap(MayOverlap&& may_overlap, Visit&& visit) const {
    if (root_ == none) return true;
    NodeRef stack[bvh_max_open];
    int size = 0;
    stack[size++] = root_;
    while (size > 0) {
        const NodeRef ref = stack[--size];
        const Node& node = nodes_[index_of(ref)];
        for (uint32_t lane = 0; lane < node.count; ++lane) {
            if (!may_overlap(node.boxes.lane(static_cast<int>(lane)))) continue;
            if (!is_leaf(ref)) {
                stack[size++] = node.child[lane];
            } else if (!visit(node.child[lane])) {
                return false;
            }
        }
    }
    return true;
}

template <class Visit, class VisitItem>
void Bvh8::for_each_box(Visit&& visit, VisitItem&& visit_item) const {
    const auto boxed = [](const Box& box, uint32_t depth, uint32_t items) {
        return gphys_octree_box{
            {{box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]}}, depth, items};
    };
    if (root_ == none) return;
    struct Entry {
        NodeRef ref;
        uint32_t depth;
        Box box;
    };
    Entry stack[bvh_max_open];
    int size = 0;
    stack[size++] = {root_, 0, bounds_};
    while (size > 0) {
        const Entry entry = stack[--size];
        const Node& node = nodes_[index_of(entry.ref)];
        visit(boxed(entry.box, entry.depth, is_leaf(entry.ref) ? node.count : 0));
        for (uint32_t lane = node.count; lane-- > 0;) {
            const Box box = node.boxes.lane(static_cast<int>(lane));
            if (is_leaf(entry.ref)) {
                visit_item(node.child[lane], boxed(box, entry.depth + 1, 1));
            } else {
                stack[size++] = {node.child[lane], entry.depth + 1, box};
            }
        }
    }
}

}  // namespace gphys
