// Questions to the scene. Each walks the octree (and the few models that no octree can hold), asks
// the exact shape of each candidate, and tells the octree what is not worth visiting any more.
#include <cmath>

#include "shapes/halfspaces.h"
#include "scene/scene.h"

namespace gphys {

namespace {

/// The best answer so far: smallest value, then lowest id, in whatever order the octree delivers.
struct Winner {
    double value;
    gphys_model_id model = 0;

    bool is_beaten_by(double other, gphys_model_id id) const {
        return model == 0 || other < value || (other == value && id < model);
    }
};

bool overlaps_shape(const MeshInstance& instance, const Shape& query) { return overlaps(instance, query); }
template <class Primitive>
bool overlaps_shape(const Primitive& shape, const Shape& query) {
    return overlaps(Shape(shape), query);
}

bool closest_point_of(const MeshInstance& instance, Vec3 point, double max_distance, Vec3& out, uint32_t& triangle) {
    return closest_point(instance, point, max_distance, out, triangle);
}
template <class Primitive>
bool closest_point_of(const Primitive& shape, Vec3 point, double, Vec3& out, uint32_t& triangle) {
    triangle = GPHYS_NO_TRIANGLE;
    out = closest_point(shape, point);
    return true;
}

bool is_met(const MeshInstance& instance, const Ray& ray) { return raycast_any(instance, ray); }
template <class Primitive>
bool is_met(const Primitive& shape, const Ray& ray) {
    Hit hit;
    return raycast(shape, ray, hit);
}

/// Whether a box may touch a plane. The error of the sums is below 8 roundings of 2^-53 of what is
/// added up.
bool may_touch(const Plane& plane, const Box& box) {
    double middle = -plane.distance, reach = 0, magnitude = std::fabs(plane.distance);
    for (int k = 0; k < 3; ++k) {
        const double low = box.min[k], high = box.max[k], normal = plane.normal[k];
        middle += normal * ((low + high) * 0.5);
        reach += std::fabs(normal) * ((high - low) * 0.5);
        magnitude += std::fabs(normal) * std::max(std::fabs(low), std::fabs(high));
    }
    return std::fabs(middle) <= reach + 0x1p-50 * magnitude;
}

}  // namespace

gphys_status Scene::raycast(const Ray& ray, uint32_t layers, gphys_hit& out) const {
    Hit first;
    Winner winner{infinity};
    Ray rest = ray;
    const auto ask = [&](uint32_t slot) {
        const Model& model = models_[slot];
        Hit hit;
        if (!(model.layers & layers)) return;
        if (!with_shape(model, [&](const auto& shape) { return gphys::raycast(shape, rest, hit); })) return;
        if (!winner.is_beaten_by(hit.t, ids_.id(slot))) return;
        winner = {hit.t, ids_.id(slot)};
        first = hit;
        // Shapes tell exactly what lies beyond t_max, while t is rounded (to 2^-50 of it at worst).
        // The slack keeps those in whose rounded t is the same, for the lower id to win.
        rest.t_max = std::min(ray.t_max, hit.t * (1 + 0x1p-40));
    };
    for (const uint32_t slot : unbounded_) ask(slot);
    octree_.raycast(rest, [&](uint32_t slot, double& t_max) {
        ask(slot);
        t_max = rest.t_max;
    });
    if (winner.model == 0) return GPHYS_NO_HIT;
    out = to_hit(first, winner.model, tag(winner.model));
    return GPHYS_OK;
}

bool Scene::raycast_any(const Ray& ray, uint32_t layers) const {
    const auto met = [&](uint32_t slot) {
        const Model& model = models_[slot];
        return (model.layers & layers) && with_shape(model, [&](const auto& shape) { return is_met(shape, ray); });
    };
    for (const uint32_t slot : unbounded_) {
        if (met(slot)) return true;
    }
    bool found = false;
    octree_.raycast(ray, [&](uint32_t slot, double& t_max) {
        found = found || met(slot);
        if (found) t_max = -1;
    });
    return found;
}

void Scene::raycast_all(const Ray& ray, uint32_t layers, Smallest<gphys_hit, FirstHit>& out) const {
    const auto ask = [&](uint32_t slot) {
        const Model& model = models_[slot];
        Hit hit;
        if (!(model.layers & layers)) return;
        if (!with_shape(model, [&](const auto& shape) { return gphys::raycast(shape, ray, hit); })) return;
        out.add(to_hit(hit, ids_.id(slot), model.tag));
    };
    for (const uint32_t slot : unbounded_) ask(slot);
    octree_.raycast(ray, [&](uint32_t slot, double&) { ask(slot); });
}

void Scene::overlap(const Shape& query, uint32_t layers, Smallest<gphys_model_id>& out) const {
    const auto ask = [&](uint32_t slot) {
        const Model& model = models_[slot];
        if ((model.layers & layers) &&
            with_shape(model, [&](const auto& shape) { return overlaps_shape(shape, query); })) {
            out.add(ids_.id(slot));
        }
        return true;
    };
    for (const uint32_t slot : unbounded_) ask(slot);
    std::visit(
        [&](const auto& shape) {
            using Query = std::decay_t<decltype(shape)>;
            if constexpr (std::is_same_v<Query, Plane>) {
                octree_.overlap([&](const Box& box) { return may_touch(shape, box); }, ask);
            } else if constexpr (std::is_same_v<Query, Frustum>) {
                octree_.frustum(shape, [&](uint32_t slot, bool) { return ask(slot); });
            } else {
                octree_.overlap_box(gphys::bounds(shape), ask);
            }
        },
        query);
}

gphys_status Scene::nearest(Vec3 point, double max_distance, uint32_t layers, gphys_nearest& out) const {
    Winner winner{max_distance * max_distance};
    Vec3 closest;
    uint32_t closest_triangle = GPHYS_NO_TRIANGLE;
    const auto ask = [&](uint32_t slot) {
        const Model& model = models_[slot];
        Vec3 candidate;
        uint32_t triangle;
        if (!(model.layers & layers)) return;
        if (!with_shape(model, [&](const auto& shape) {
                return closest_point_of(shape, point, std::sqrt(winner.value), candidate, triangle);
            })) {
            return;
        }
        const double square = length_squared(candidate - point);
        if (square > winner.value || !winner.is_beaten_by(square, ids_.id(slot))) return;
        winner = {square, ids_.id(slot)};
        closest = candidate;
        closest_triangle = triangle;
    };
    for (const uint32_t slot : unbounded_) ask(slot);
    octree_.nearest(point, std::sqrt(winner.value), [&](uint32_t slot, double& within) {
        ask(slot);
        within = std::sqrt(winner.value);
    });
    if (winner.model == 0) return GPHYS_NO_HIT;
    out = to_nearest(closest, std::sqrt(winner.value), closest_triangle, winner.model, tag(winner.model));
    return GPHYS_OK;
}

gphys_status Scene::sweep(const Sphere& moving, Vec3 displacement, uint32_t layers, gphys_hit& out) const {
    Hit first;
    Winner winner{infinity};
    const auto ask = [&](uint32_t slot) {
        const Model& model = models_[slot];
        Hit hit;
        if (!(model.layers & layers)) return;
        if (!with_shape(model, [&](const auto& shape) { return gphys::sweep(shape, moving, displacement, hit); })) {
            return;
        }
        if (!winner.is_beaten_by(hit.t, ids_.id(slot))) return;
        winner = {hit.t, ids_.id(slot)};
        first = hit;
    };
    for (const uint32_t slot : unbounded_) ask(slot);
    octree_.sweep(moving.center, displacement, moving.radius, [&](uint32_t slot, double& t_max) {
        ask(slot);
        t_max = std::min(t_max, winner.value);
    });
    if (winner.model == 0) return GPHYS_NO_HIT;
    out = to_hit(first, winner.model, tag(winner.model));
    return GPHYS_OK;
}

void Scene::cull(const Frustum& frustum, uint32_t layers, Smallest<gphys_model_id>& out) const {
    for (const uint32_t slot : unbounded_) {
        const Model& model = models_[slot];
        if ((model.layers & layers) &&
            with_shape(model, [&](const auto& shape) { return overlaps_shape(shape, frustum); })) {
            out.add(ids_.id(slot));
        }
    }
    // The three axes of the boxes stand beside the six planes: without them a box behind the
    // viewer that crosses the planes of two sides would count.
    Box around;
    const bool bounded = gphys::bounds(frustum, around);
    octree_.frustum(frustum, [&](uint32_t slot, bool) {
        if ((models_[slot].layers & layers) && (!bounded || overlaps(octree_.box(slot), around))) {
            out.add(ids_.id(slot));
        }
        return true;
    });
}

}  // namespace gphys
