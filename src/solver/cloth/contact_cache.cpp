// The contact cache of cloth. A particle reuses its ball and its contact planes in the next step while it stays in the
// ball and the models around the body are the same as at the end of the last step, because then nothing in the ball can
// have changed. So cloth that lies or hangs beside models hardly searches.
//
// Balls and contact planes follow from the positions of the search, its radius, and the models. So only the former two
// are in a snapshot. A body restored from one, or with other models around it, searches again from there.
#include "solver/cloth/contact_cache.h"
#include "solver/contact/collision.h"
#include "solver/contact/neighbourhood.h"

namespace gphys {
namespace {

Aabb places_of(const Body& body) {
    Aabb box{body.particles.position[0], body.particles.position[0]};
    for (const Vec3 at : body.particles.position) box = {min(box.min, at), max(box.max, at)};
    return box;
}

/// The box that the balls reach: each is as large as a link or as its particle, plus the particle's radius.
Box box_around_balls(const Body& body) {
    const double reach = std::max(body.cloth.batches.link_length, body.particles.largest_radius);
    const double room = 2 * (reach + body.particles.largest_radius);
    const Aabb box = places_of(body);
    return bounds(Aabb{box.min - Vec3{room, room, room}, box.max + Vec3{room, room, room}});
}

}  // namespace

uint64_t models_around(const Body& body, const Scene* scene) {
    if (!scene) return 0;
    return neighbourhood(*scene, box_around_balls(body), body.settings.layers, [](gphys_model_id) {});
}

bool keeps_origin(const ContactCache& cache, Vec3 origin, const Aabb& box) {
    // Coordinates, and their rounding, are then at most a quarter larger than necessary.
    constexpr double farthest_aside = 1.0 / 8;
    if (cache.search_balls.empty()) return false;
    const Vec3 aside = (box.min + box.max) / 2 - origin;
    return max_component(abs(aside)) <= farthest_aside * max_component(box.max - box.min);
}

Reuse reusable_contacts(const Body& body, const CollisionContext& around) {
    const ContactCache& cache = body.cloth.cache;
    if (cache.search_balls.empty() || !body.cloth.moving_colliders.empty()) return Reuse::nothing;
    const bool same = cache.current && cache.neighbourhood == models_around(body, around.scene);
    return same ? Reuse::planes : Reuse::balls;
}

void update_cache(Body& body, const CollisionContext& around) {
    ContactCache& cache = body.cloth.cache;
    const Vector<ClothContact>& candidates = body.cloth.contacts.candidates;
    const bool has_planes =
        std::any_of(candidates.begin(), candidates.end(), [](const ClothContact& n) { return n.plane_count > 0; });
    if (!has_planes || !body.cloth.moving_colliders.empty()) {
        cache.search_balls.clear();
        return;
    }
    cache.current = true;
    cache.neighbourhood = models_around(body, around.scene);
}

}  // namespace gphys
