// Overlap and culling in the scene. Each query goes through the list of unbounded models and
// traverses the BVH. It tests each candidate conservatively, then exactly if undecided, and lowers the limit by which
// the traversal prunes. Results are ordered by what is reported, so they do not depend on the order of traversal.
#include <cmath>

#include "foundation/compiler.h"
#include "geometry/faces.h"
#include "scene/best_candidate.h"
#include "scene/conservative_tests.h"
#include "scene/scene.h"
#include "scene/slot_set.h"
#include "shapes/halfspaces.h"

namespace gphys {
namespace {

bool overlaps_shape(const MeshInstance& instance, const Shape& query) { return overlaps(instance, query); }
template <class Primitive>
bool overlaps_shape(const Primitive& shape, const Shape& query) {
    return overlaps(Shape(shape), query);
}

/// Conservative overlap of a plane and a box. The error of the sums is below 8 roundings of 2^-53 of the sum of
/// magnitudes.
bool may_overlap(const Plane& plane, const Box& box) {
    double middle = -plane.distance, reach = 0, magnitude = std::fabs(plane.distance);
    for (int k = 0; k < 3; ++k) {
        const double low = box.min[k], high = box.max[k], normal = plane.normal[k];
        middle += normal * ((low + high) * 0.5);
        reach += std::fabs(normal) * ((high - low) * 0.5);
        magnitude += std::fabs(normal) * std::max(std::fabs(low), std::fabs(high));
    }
    return std::fabs(middle) <= reach + 0x1p-50 * magnitude;
}

Box box_around(const Frustum& frustum) {
    Box box;
    return bounds_of_six_sided(frustum, box) || bounds(frustum, box) ? box : all_of_space;
}

}  // namespace

bool Scene::overlaps_box(gphys_model_id model, const Box& box) const {
    const Shape query = Aabb{{box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]}};
    return with_shape(IdTable::slot_of(model), [&](const auto& shape) { return overlaps_shape(shape, query); });
}

/// Adds the models of a list that overlap the query: Aabbs by test_eight(quads, first_quad), others by test(slot).
template <class Filter, class TestEight, class Test>
void Scene::overlap_each(const TestEight& test_eight, const uint32_t* slots, uint32_t count, const Filter& filter,
                         const Test& test, Smallest<gphys_model_id>& out) const {
    constexpr uint32_t quads = sizeof(Model) / (4 * sizeof(float));
    static_assert(quads == 4);
    uint32_t boxes[8], first_quad[8], pending = 0;
    const auto decide_boxes = [&] {
        for (uint32_t k = pending; k < 8; ++k) first_quad[k] = first_quad[0];
        const TriStates8 results = test_eight(reinterpret_cast<const float*>(models_.data()), first_quad);
        for (uint32_t k = 0; k < pending; ++k) {
            out.add_if((results.yes >> k & 1) && passes(filter, boxes[k]), ids_.id(boxes[k]));
        }
        uint32_t undecided = ~(results.no | results.yes) & ((1u << pending) - 1);
        for (; undecided != 0; undecided &= undecided - 1) test(boxes[lowest_bit(undecided)]);
        pending = 0;
    };
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t slot = slots[i];
        if (!may_pass(filter, slot)) continue;
        if (models_[slot].type() != GPHYS_SHAPE_AABB) {
            test(slot);
            continue;
        }
        boxes[pending] = slot;
        first_quad[pending] = quads * slot;
        if (++pending == 8) decide_boxes();
    }
    if (pending > 0) decide_boxes();
}

void Scene::find_candidates(const Shape* shapes, uint32_t count, uint32_t layers, OverlapItems* candidates) const {
    const ItemMemory models = model_memory(), if_inside = inside_memory(layers);
    std::visit(
        [&](const auto& first) {
            using Query = std::decay_t<decltype(first)>;
            if constexpr (std::is_same_v<Query, Plane> || std::is_same_v<Query, Frustum>) {
                for (uint32_t i = 0; i < count; ++i) candidates[i].complete = false;
            } else if constexpr (std::is_same_v<Query, Sphere>) {
                Sphere balls[OverlapItems::max_queries];
                for (uint32_t i = 0; i < count; ++i) balls[i] = std::get<Sphere>(shapes[i]);
                bvh_.overlap_balls(balls, count, models, if_inside, candidates);
            } else {
                Box boxes[OverlapItems::max_queries];
                for (uint32_t i = 0; i < count; ++i) boxes[i] = gphys::bounds(std::get<Query>(shapes[i]));
                bvh_.overlap_boxes(boxes, count, models, std::is_same_v<Query, Aabb> ? if_inside : models, candidates);
            }
        },
        shapes[0]);
}

template <class Filter>
uint32_t Scene::overlap_by(const Shape& query, const Filter& filter, gphys_model_id* out_ids, uint32_t capacity,
                           const OverlapItems* candidates) const {
    Smallest<gphys_model_id> out(out_ids, capacity);
    const uint32_t layers = layers_of(filter);
    const auto exact = [&](const auto& shape) { return overlaps_shape(shape, query); };
    std::visit(
        [&](const auto& shape) {
            using Query = std::decay_t<decltype(shape)>;
            const auto conservative = conservative_overlap(shape);
            const auto test = [&](uint32_t slot) {
                out.add_if(may_pass(filter, slot) && decide(filter, slot, conservative, exact), ids_.id(slot));
                return true;
            };
            for (const uint32_t slot : unbounded_) test(slot);
            // A model whose AABB is wholly inside the query is a result without a test of its shape.
            const bool is_result_if_inside = inside_is_result(layers);
            const auto find = [&](uint32_t slot, bool wholly_inside) {
                if (!wholly_inside || !is_result_if_inside) return test(slot);
                for_each_passing_in_layers(filter, &slot, 1,
                                           [&](uint32_t slot_in_layers) { out.add(ids_.id(slot_in_layers)); });
                return true;
            };
            const ItemMemory models = model_memory(), if_inside = inside_memory(layers);
            const bool has_candidates = candidates && candidates->complete;
            const auto find_by = [&](const auto& test_eight) {
                return [&](const uint32_t* slots, uint32_t count, bool wholly_inside) {
                    if (wholly_inside && is_result_if_inside) {
                        for_each_passing_in_layers(filter, slots, count,
                                                   [&](uint32_t slot) { out.add(ids_.id(slot)); });
                    } else {
                        overlap_each(test_eight, slots, count, filter, test, out);
                    }
                    return true;
                };
            };
            const auto find_among_candidates = [&](const auto& find_all) {
                return find_all(candidates->items[0], candidates->count[0], false) &&
                       find_all(candidates->items[1], candidates->count[1], true);
            };
            if constexpr (std::is_same_v<Query, Plane>) {
                bvh_.overlap([&](const Box& box) { return may_overlap(shape, box); }, test);
            } else if constexpr (std::is_same_v<Query, Frustum>) {
                bvh_.frustum(shape, box_around(shape), find, models, if_inside);
            } else if constexpr (std::is_same_v<Query, Sphere>) {
                const SphereQueryLanes ball(shape.center, shape.radius);
                const auto near_ball = [&](const float* quads, const uint32_t* first) {
                    return kernels_.boxes_and_sphere(quads, first, ball);
                };
                const auto find_all = find_by(near_ball);
                has_candidates ? find_among_candidates(find_all)
                               : bvh_.overlap_ball(shape.center, shape.radius, find_all, models, if_inside);
            } else if constexpr (std::is_same_v<Query, Aabb>) {
                const BoxQueryLanes block(shape);
                const auto in_block = [&](const float* quads, const uint32_t* first) {
                    return kernels_.boxes_and_box(quads, first, block);
                };
                const auto find_all = find_by(in_block);
                has_candidates ? find_among_candidates(find_all)
                               : bvh_.overlap_box(gphys::bounds(shape), find_all, models, if_inside);
            } else {
                const auto test_all = [&](const uint32_t* slots, uint32_t count, bool) {
                    return std::all_of(slots, slots + count, test);
                };
                has_candidates ? find_among_candidates(test_all)
                               : bvh_.overlap_box(gphys::bounds(shape), test_all, models, models);
            }
        },
        query);
    return out.finish();
}

/// Lists the ids of the slots that find_all(add) adds, each once, in ascending order; find_all returns their number. A
/// bit set of slots sorts them while they are found (slot_set.h). That of a large scene has its words at the end of
/// `out`. Returns false if that leaves no room: the contents are then undefined.
template <class FindAll>
bool Scene::list_by_set(const FindAll& find_all, gphys_model_id* out, uint32_t capacity, uint32_t& total) const {
    constexpr uint32_t words_on_stack = 1024;
    uint32_t on_stack[words_on_stack];
    const uint32_t words = SlotSet::words_for(ids_.slots()), behind = words <= words_on_stack ? 0 : words;
    if (capacity <= behind) return false;
    const uint32_t room = capacity - behind;
    SlotSet slots(behind == 0 ? on_stack : out + room, ids_.slots());
    total = find_all([&](uint32_t slot) { slots.add(slot); });
    if (total <= room) {
        slots.list(slot_set_kernels_, ids_.ids(), out, room);
    } else if (total > capacity || !slots.list_over_words(ids_.ids(), out)) {
        return false;
    }
    // The order of ids differs from that of slots where slots were reused: generations differ. Counts instead of
    // stopping at the first: the loop is vectorised.
    uint32_t descents = 0;
    for (uint32_t i = 1; i < total; ++i) descents += out[i] < out[i - 1];
    if (descents != 0) sort_distinct(out, total, capacity);
    return true;
}

template <class Filter>
uint32_t Scene::cull_by(const Frustum& frustum, const Filter& filter, gphys_model_id* out, uint32_t capacity) const {
    const bool all_in_layers = (common_layers_ & layers_of(filter)) != 0;
    const Box around = box_around(frustum);
    // add(slot) for each result; returns their number.
    const auto find = [&](const auto& add) {
        uint32_t total = 0;
        const auto add_if_passing = [&](uint32_t slot) {
            if (!may_pass(filter, slot) || !passes(filter, slot)) return;
            add(slot);
            ++total;
        };
        for (const uint32_t slot : unbounded_) {
            const auto is_in_view = [&](const Plane& plane) { return overlaps(Shape(plane), frustum); };
            if (with_plane(slot, is_in_view)) add_if_passing(slot);
        }
        bvh_.frustum(frustum, around, [&](const uint32_t* slots, uint32_t count) {
            if (all_in_layers) {
                total += for_each_passing_in_layers(filter, slots, count, add);
            } else {
                std::for_each(slots, slots + count, add_if_passing);
            }
            return true;
        });
        return total;
    };

    if (capacity == 0) return find([](uint32_t) {});
    uint32_t total = 0;
    if (list_by_set(find, out, capacity, total)) return total;
    Smallest<gphys_model_id> lowest(out, capacity);
    find([&](uint32_t slot) { lowest.add(ids_.id(slot)); });
    return lowest.finish();
}

uint32_t Scene::overlap(const Shape& shape, uint32_t layers, gphys_model_id* out, uint32_t capacity,
                        const OverlapItems* candidates) const {
    return overlap_by(shape, layers, out, capacity, candidates);
}
uint32_t Scene::overlap(const Shape& shape, const QueryFilter& filter, gphys_model_id* out, uint32_t capacity,
                        const OverlapItems* candidates) const {
    return overlap_by(shape, filter, out, capacity, candidates);
}

uint32_t Scene::cull(const Frustum& frustum, uint32_t layers, gphys_model_id* out, uint32_t capacity) const {
    return cull_by(frustum, layers, out, capacity);
}
uint32_t Scene::cull(const Frustum& frustum, const QueryFilter& filter, gphys_model_id* out, uint32_t capacity) const {
    return cull_by(frustum, filter, out, capacity);
}

}  // namespace gphys
