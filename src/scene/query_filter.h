// Query filters: a layer mask, and optionally models to ignore.
//
// The queries of scene.h are templates over the kind of filter. A filter is applied in two steps: a cheap test by
// layers, and, if the conservative test of the shape has not rejected the model, the lookup in the list or tree of
// ignored models. So the lookup runs only for the few models that may be results.
#pragma once

#include <cstdint>

#include "gamephys_c.h"
#include "shapes/shapes.h"

namespace gphys {

/// The caller's ids of models to ignore, in any order; ids of removed models are allowed.
class IgnoredIds {
public:
    IgnoredIds() = default;
    /// One walk through them. They must live as long, unchanged.
    IgnoredIds(const gphys_model_id* ids, uint32_t count) : ids_(ids), count_(count) {
        // Counted to the end, several are compared at once.
        uint32_t descents = 0;
        for (uint32_t i = 1; i < count; ++i) descents += ids[i] < ids[i - 1];
        ascending_ = descents == 0;
    }

    bool empty() const { return count_ == 0; }
    bool hold(gphys_model_id id) const {
        if (ascending_ && count_ > few) return found_by_halves(id);
        uint32_t found = 0;
        for (uint32_t i = 0; i < count_; ++i) found |= uint32_t{ids_[i] == id};
        return found != 0;
    }

private:
    static constexpr uint32_t few = 16;  // that are compared sooner than searched

    bool found_by_halves(gphys_model_id id) const {
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

/// Made by Scene::query_filter.
struct QueryFilter {
    uint32_t layers = GPHYS_ALL_LAYERS;
    uint32_t ignored_slot = ~0u;  // of a model, or of none
    bool ignores_below = false;   // its descendants, too; it has some
    IgnoredIds ignored;
    Faces faces;  // of surfaces, that rays and sweeps meet
};

/// Those of several rays: one for all with a step of 0, else one for each.
struct RayFilters {
    const QueryFilter* first;
    uint32_t step;

    const QueryFilter& of(uint32_t ray) const { return first[ray * step]; }
};

/// The number of rays of a batch if each has its own filter; more would need too much stack.
constexpr uint32_t most_ray_filters = 16;

inline uint32_t filter_of_ray(uint32_t layers, uint32_t) { return layers; }
inline const QueryFilter& filter_of_ray(const RayFilters& filters, uint32_t ray) { return filters.of(ray); }

inline Faces faces_of(uint32_t) { return {}; }
inline Faces faces_of(const QueryFilter& filter) { return filter.faces; }
/// The ray as the filter lets it meet surfaces.
inline const Ray& filtered(const Ray& ray, uint32_t) { return ray; }
inline Ray filtered(Ray ray, const QueryFilter& filter) {
    ray.faces = filter.faces;
    return ray;
}
inline void filter_rays(Ray*, uint32_t, uint32_t) {}
inline void filter_rays(Ray* rays, uint32_t count, const RayFilters& filters) {
    for (uint32_t i = 0; i < count; ++i) rays[i].faces = filters.of(i).faces;
}

}  // namespace gphys
