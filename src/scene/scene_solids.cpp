// Sweeps and penetrations of spheres, capsules and boxes in the scene. The candidates come from the BVH: by the ball of
// a sphere that sweeps, else by the AABB of the moving shape. The exact tests are sweep.cpp, sweep_convex.cpp and
// penetration.cpp.
#include "geometry/faces.h"
#include "scene/best_candidate.h"
#include "scene/scene.h"

namespace gphys {
namespace {

// Sweeps against the sides of surfaces that the filter allows.
bool sweep_shape(const MeshInstance& instance, const Shape& moving, Vec3 displacement, Faces faces, Hit& hit) {
    return sweep(instance, moving, displacement, hit, faces);
}
template <class Primitive>
bool sweep_shape(const Primitive& shape, const Shape& moving, Vec3 displacement, Faces faces, Hit& hit) {
    return hits_side(shape, displacement, faces) && sweep(Shape(shape), moving, displacement, hit);
}

bool sweep_shape(const MeshInstance& instance, const Sphere& moving, Vec3 displacement, Faces faces, Hit& hit) {
    return sweep(instance, moving, displacement, hit, Ties::as_reported, faces);
}
template <class Primitive>
bool sweep_shape(const Primitive& shape, const Sphere& moving, Vec3 displacement, Faces faces, Hit& hit) {
    return hits_side(shape, displacement, faces) && sweep(shape, moving, displacement, hit);
}

/// add(penetration, triangle) for each penetration into a model.
template <class Add>
void visit_penetrations(const MeshInstance& instance, const Shape& moving, const Add& add) {
    for_each_penetration(instance, moving, add);
}
template <class Primitive, class Add>
void visit_penetrations(const Primitive& shape, const Shape& moving, const Add& add) {
    if (overlaps(Shape(shape), moving)) add(gphys::penetration(Shape(shape), moving), GPHYS_NO_TRIANGLE);
}

}  // namespace

/// The first contact of a shape in motion. sweep_one(shape, hit) is its sweep against one model; traverse(visit) visits
/// the candidates in the BVH.
template <class SweepOne, class Traverse>
gphys_status Scene::first_contact(Vec3 displacement, const QueryFilter& filter, const SweepOne& sweep_one,
                                  const Traverse& traverse, gphys_hit& out) const {
    Hit first, hit;
    BestCandidate best;
    double end = 1;
    const auto test = [&](uint32_t slot) {
        const auto exact = [&](const auto& shape) { return sweep_one(shape, hit); };
        // Nothing precedes a contact at the start, except that of a lower id.
        if (!best.is_beaten_by(0, slot, ids_)) return;
        if (!may_pass(filter, slot) || !passes(filter, slot) || !with_shape(slot, exact)) return;
        const float t = reported(hit.t);
        if (!best.is_beaten_by(t, slot, ids_)) return;
        best = {t, slot};
        end = std::min(1.0, limit_of_ties<double>(t));
        first = hit;
    };
    for (const uint32_t slot : unbounded_) test(slot);
    traverse([&](uint32_t slot, double& t_max) {
        test(slot);
        t_max = end;
    });
    if (!best.exists()) return GPHYS_NO_HIT;
    out = to_contact(first, displacement, ids_.id(best.slot), tags_[best.slot]);
    return GPHYS_OK;
}

gphys_status Scene::sweep(const Sphere& moving, Vec3 displacement, const QueryFilter& filter, gphys_hit& out) const {
    const auto sweep_one = [&](const auto& shape, Hit& hit) {
        hit = Hit();
        return sweep_shape(shape, moving, displacement, filter.faces, hit);
    };
    const auto traverse = [&](const auto& visit) {
        bvh_.sweep(moving.center, displacement, moving.radius, visit, model_memory());
    };
    return first_contact(displacement, filter, sweep_one, traverse, out);
}

gphys_status Scene::sweep(const Shape& moving, Vec3 displacement, const QueryFilter& filter, gphys_hit& out) const {
    if (const auto* sphere = std::get_if<Sphere>(&moving)) return sweep(*sphere, displacement, filter, out);
    const auto sweep_one = [&](const auto& shape, Hit& hit) {
        return sweep_shape(shape, moving, displacement, filter.faces, hit);
    };
    const auto traverse = [&](const auto& visit) {
        const BoxInMotion box(moving);
        const Vec3 half = box.half_with_rounding(bvh_.bounds(), displacement);
        bvh_.sweep(box.middle, displacement, half, visit, model_memory());
    };
    return first_contact(displacement, filter, sweep_one, traverse, out);
}

void Scene::penetration(const Shape& moving, const QueryFilter& filter, DeepestPenetrations& out) const {
    const auto test = [&](uint32_t slot) {
        if (!may_pass(filter, slot) || !passes(filter, slot)) return true;
        with_shape(slot, [&](const auto& shape) {
            visit_penetrations(shape, moving, [&](const Penetration& penetration, uint32_t triangle) {
                out.add(to_penetration(penetration, triangle, ids_.id(slot), tags_[slot]));
            });
        });
        return true;
    };
    for (const uint32_t slot : unbounded_) test(slot);
    const auto visit = [&](uint32_t slot, bool) { return test(slot); };
    bvh_.overlap_box(BoxInMotion(moving).box, visit, model_memory(), model_memory());
}

}  // namespace gphys
