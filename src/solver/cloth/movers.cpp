#include "solver/cloth/movers.h"

#include "solver/contact/collision.h"

namespace gphys {
namespace {

Mat3 transposed(const Mat3& m) { return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}}; }

Ride ride(const Transform& from, const Transform& to, Vec3 origin) {
    return {to.rotation * transposed(from.rotation), to.apply(from.inverse_apply(origin)) - origin};
}

}  // namespace

void find_movers(Body& body, const Surroundings& around) {
    // Half a radian: ranges are then less than three times what they are for a model that does not turn.
    constexpr double most_turn = 0.5;
    Vector<Mover>& movers = body.cloth_contacts.movers;
    movers.clear();
    for (const PlacedModel& before : *around.moved) {
        if (!(around.scene->layers(before.model) & body.settings.layers)) continue;
        const gphys_transform& after = around.scene->world(before.model);
        Mover mover{};
        mover.model = before.model;
        mover.before = before.world;
        mover.bounded = way_of(*around.scene, before, mover.way);
        // Of unit quaternions, up to their rounding: |q - p| = 2 sin(angle / 4), and their product is the cosine of
        // half the angle.
        const Quat p = normalized(widen(before.world.rotation)), q = normalized(widen(after.rotation));
        const double cosine = std::min(1.0, std::fabs(p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w));
        mover.turn = 2 * std::sqrt(1 - cosine * cosine) + 1e-6;  // and the rounding of an angle near 0
        // Towards the middle of the circle 1 - cos(angle / 2), and less than that along the way, where the arc is
        // not passed evenly.
        mover.bulge = 2 * (1 - cosine);
        mover.is_rigid = before.world.scale == after.scale && mover.turn < most_turn;
        movers.push_back(mover);
    }
    move_movers(body, around);
}

void move_movers(Body& body, const Surroundings& around) {
    const Vec3 origin = body.cloth.origin;
    for (Mover& mover : body.cloth_contacts.movers) {
        if (!mover.is_rigid) continue;
        const gphys_transform& after = around.scene->world(mover.model);
        const Transform begin = interpolate(mover.before, after, around.begin);
        const Transform end = interpolate(mover.before, after, around.end);
        mover.carry = ride(begin, end, origin);
        mover.from_end = ride(widen(after), end, origin);
        mover.middle = end.position - origin;
    }
}

}  // namespace gphys
