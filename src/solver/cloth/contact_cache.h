// Which contacts of the previous step can be reused (contact_cache.cpp).
#pragma once

#include "foundation/memory.h"
#include "shapes/shapes.h"

namespace gphys {

struct Body;
struct CollisionContext;
class Scene;

struct ContactCache {
    explicit ContactCache(std::pmr::memory_resource* memory) : search_balls(memory) {}

    static constexpr float no_ball = -1;  // as the distance

    /// Four floats for each particle: where it searched for contacts last, relative to the origin, and how far. Empty
    /// if the next step must search anew.
    Vector<float> search_balls;
    uint64_t neighbourhood = 0;  // a hash of the models around the body at the end of the last step
    bool current = false;  // whether contact planes and `neighbourhood` are of a previous step; false after a snapshot
};

/// What can be reused: nothing, so that all particles search; the positions and radii of the last search; or also its
/// contact planes.
enum class Reuse { nothing, balls, planes };
/// Whether the origin of the relative coordinates is still near the middle of the box.
bool keeps_origin(const ContactCache& cache, Vec3 origin, const Aabb& box);
/// A hash of the models that the balls of a body reach; 0 without a scene.
uint64_t models_around(const Body& body, const Scene* scene);
/// Call at the beginning of a step, when the moving models are known.
Reuse reusable_contacts(const Body& body, const CollisionContext& around);
/// Call at the end of a step.
void update_cache(Body& body, const CollisionContext& around);

}  // namespace gphys
