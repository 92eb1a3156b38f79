// The motion of the models that cloth lies on (carriers.h).
#include "solver/cloth/carriers.h"

#include "solver/body.h"
#include "solver/contact/collision.h"

namespace gphys {
namespace {

constexpr uint32_t unmoved = MovingCollider::unmoved;

/// Calls visit(contact, plane) for all contact planes of the cloth.
template <class Visit>
void each_plane(const ClothContacts& contacts, Visit&& visit) {
    for (const ClothContact& n : contacts.candidates) {
        for (uint32_t i = 0; i < n.plane_count; ++i) visit(n, n.planes[i]);
    }
}

/// The model that more than half of the planes are of; if there is none, any (Boyer and Moore 1991).
uint32_t most_frequent(const ClothContacts& contacts) {
    uint32_t found = unmoved, lead = 0;
    each_plane(contacts, [&](const ClothContact&, const ContactPlane& plane) {
        if (lead == 0) found = plane.moving_collider;
        lead += plane.moving_collider == found ? 1 : -1;
    });
    return found;
}

}  // namespace

RigidDisplacement::RigidDisplacement(const RigidMotion& motion) : turn(motion.rotation), shift(motion.shift) {
    turn.x.x -= 1, turn.y.y -= 1, turn.z.z -= 1;
}

Carriers find_carriers(const Body& body, const CollisionContext& around) {
    const Cloth& cloth = body.cloth;
    const ClothContacts& contacts = cloth.contacts;
    Carriers found;
    if (!collides(body, around) || cloth.moving_colliders.empty()) return found;
    const auto in_step = [&](uint32_t number) {
        return number == unmoved
                   ? RigidDisplacement()
                   : RigidDisplacement(motion_in_step(cloth.moving_colliders[number], cloth.state.origin, around));
    };
    found.first = most_frequent(contacts);
    found.of_first = in_step(found.first);
    uint32_t other = found.first;
    RigidDisplacement of_other = found.of_first;
    each_plane(contacts, [&](const ClothContact& n, const ContactPlane& plane) {
        const uint32_t number = plane.moving_collider;
        found.move = found.move || number != unmoved;
        found.rigid = found.rigid && (number == unmoved || cloth.moving_colliders[number].is_rigid);
        if (number == found.first) return;
        if (number != other) other = number, of_other = in_step(number);
        const Vec3 at = body.particles.position[n.particle] - cloth.state.origin;
        found.apart = std::max(found.apart, distance(found.of_first.of(at), of_other.of(at)));
    });
    return found;
}

RigidDisplacement displacement_in_substep(const Body& body, uint32_t moving_collider) {
    return moving_collider == unmoved ? RigidDisplacement()
                                      : RigidDisplacement(body.cloth.moving_colliders[moving_collider].substep_motion);
}

}  // namespace gphys
