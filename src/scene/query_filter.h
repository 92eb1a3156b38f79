// Query filters: a layer mask, and optionally models to ignore.
//
// Raycasts, overlaps, nearest points and culling (scene.h) are templates of the filter, so that a plain layer mask
// costs nothing more. For the other queries a mask is converted to a filter. A filter has two steps: a cheap test of
// layers and hierarchy, then the lookup in the list of ignored models. The lookup runs after the conservative test of
// the shape, so only for the few models that may be results.
#pragma once

#include <cstdint>

#include "gamephys_c.h"
#include "shapes/shapes.h"

namespace gphys {

/// The caller's ids of models to ignore, in any order; ids of removed models are allowed.
class IgnoredIds {
public:
    IgnoredIds() = default;
    /// Reads the ids once. They must stay valid and unchanged.
    IgnoredIds(const gphys_model_id* ids, uint32_t count) : ids_(ids), count_(count) {
        // Counts instead of stopping at the first: the loop is vectorised.
        uint32_t descents = 0;
        for (uint32_t i = 1; i < count; ++i) descents += ids[i] < ids[i - 1];
        ascending_ = descents == 0;
    }

    bool empty() const { return count_ == 0; }
    bool contains(gphys_model_id id) const {
        if (ascending_ && count_ > linear_count) return binary_search(id);
        uint32_t found = 0;
        for (uint32_t i = 0; i < count_; ++i) found |= uint32_t{ids_[i] == id};
        return found != 0;
    }

private:
    static constexpr uint32_t linear_count = 16;  // up to here a linear search is faster

    bool binary_search(gphys_model_id id) const {
        const gphys_model_id* first = ids_;
        for (uint32_t rest = count_; rest > 1;) {
            const uint32_t half = rest / 2;
            first += first[half - 1] < id ? half : 0;
            rest -= half;
        }
        return *first == id;
    }

    const gphys_model_id* ids_ = nullptr;
    uint32_t count_ = 0;
    bool ascending_ = true;
};

/// Made of layers alone, or by Scene::query_filter.
struct QueryFilter {
    QueryFilter() = default;
    QueryFilter(uint32_t only_layers) : layers(only_layers) {}  // implicit: a layer mask is a filter

    uint32_t layers = GPHYS_ALL_LAYERS;
    uint32_t ignored_slot = ~0u;  // ~0u: no model
    bool ignores_below = false;   // ignored_slot has descendants, which are ignored, too
    IgnoredIds ignored;
    Faces faces;  // sides of surfaces that rays and sweeps hit
};

/// Filters of several items of a batch: the same for all if step is 0, else one for each.
struct BatchFilters {
    const QueryFilter* first;
    uint32_t step;

    const QueryFilter& of(uint32_t item) const { return first[item * step]; }
};

/// Items of a batch that are queried at once if each has its own filter. More would need too much stack.
constexpr uint32_t max_batch_filters = 16;

inline uint32_t filter_of_item(uint32_t layers, uint32_t) { return layers; }
inline const QueryFilter& filter_of_item(const BatchFilters& filters, uint32_t item) { return filters.of(item); }

/// Items with the same number share a filter; numbers are below the number of items.
inline uint32_t filter_number(uint32_t, uint32_t) { return 0; }
inline uint32_t filter_number(const BatchFilters& filters, uint32_t item) { return item * filters.step; }

inline Faces faces_of(uint32_t) { return {}; }
inline Faces faces_of(const QueryFilter& filter) { return filter.faces; }
/// The ray with the filter's faces.
inline const Ray& filtered(const Ray& ray, uint32_t) { return ray; }
inline Ray filtered(Ray ray, const QueryFilter& filter) {
    ray.faces = filter.faces;
    return ray;
}
inline void filter_rays(Ray*, uint32_t, uint32_t) {}
inline void filter_rays(Ray* rays, uint32_t count, const BatchFilters& filters) {
    for (uint32_t i = 0; i < count; ++i) rays[i].faces = filters.of(i).faces;
}

}  // namespace gphys
