// What cloth has found around it in one step and need not look for in the next. A particle keeps its ball and its
// contact planes while it stays in the ball and the models around the body are those that were there when the last step
// ended; then nothing in the ball can have changed. Cloth that lies or hangs beside models hardly searches for
// contacts.
//
// Balls and contact planes follow from where the particles looked, how far, and the models. So only the former are in a
// snapshot, and a body that comes out of one, or finds other models, looks again from there.
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

/// What balls reach: each is as large as a link, or as its particle, and beyond it there is the particle's radius.
Box around_balls(const Body& body) {
    const double reach = std::max(body.cloth.batches.link_length, body.particles.largest_radius);
    const double room = 2 * (reach + body.particles.largest_radius);
    const Aabb box = places_of(body);
    return bounds(Aabb{box.min - Vec3{room, room, room}, box.max + Vec3{room, room, room}});
}

uint64_t neighbourhood(const Body& body, const Scene& scene) {
    return neighbourhood(scene, around_balls(body), body.settings.layers, [](gphys_model_id) {});
}

}  // namespace

bool keeps_origin(const Body& body, const Aabb& box) {
    // Coordinates are then a quarter larger than they have to be, and so is their rounding.
    constexpr double farthest_aside = 1.0 / 8;
    if (body.cloth.search_balls.empty()) return false;
    const Vec3 aside = (box.min + box.max) / 2 - body.cloth.origin;
    return max_component(abs(aside)) <= farthest_aside * max_component(box.max - box.min);
}

Reuse reuse_contacts(Body& body, const CollisionContext& around) {
    Vector<float>& search_balls = body.cloth.search_balls;
    const ClothContacts& contacts = body.cloth.contacts;
    if (search_balls.empty() || !contacts.moving_colliders.empty()) {
        search_balls.assign(4 * size_t{body.particles.size()}, Cloth::no_ball);
        return Reuse::nothing;
    }
    const bool same = contacts.kept && contacts.neighbourhood == neighbourhood(body, *around.scene);
    return same ? Reuse::planes : Reuse::balls;
}

void keep_planes(Body& body, const CollisionContext& around) {
    ClothContacts& contacts = body.cloth.contacts;
    const bool has_planes = std::any_of(contacts.neighbours.begin(), contacts.neighbours.end(),
                                        [](const Neighbour& n) { return n.plane_count > 0; });
    if (!has_planes || !contacts.moving_colliders.empty()) {
        body.cloth.search_balls.clear();
        return;
    }
    contacts.kept = true;
    contacts.neighbourhood = neighbourhood(body, *around.scene);
}

}  // namespace gphys
