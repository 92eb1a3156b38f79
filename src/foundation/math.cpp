// Rotation matrix to quaternion, and composition of transforms (math.h).
#include "foundation/math.h"

namespace gphys {

Quat quaternion(const Mat3& m) {
    const double trace = m.x.x + m.y.y + m.z.z;
    // Divide by the largest of the four components, which is at least 1/2.
    if (trace >= m.x.x && trace >= m.y.y && trace >= m.z.z) {
        return normalized(Quat{m.y.z - m.z.y, m.z.x - m.x.z, m.x.y - m.y.x, 1 + trace});
    }
    if (m.x.x >= m.y.y && m.x.x >= m.z.z) {
        return normalized(Quat{1 + m.x.x - m.y.y - m.z.z, m.x.y + m.y.x, m.z.x + m.x.z, m.y.z - m.z.y});
    }
    if (m.y.y >= m.z.z) return normalized(Quat{m.x.y + m.y.x, 1 + m.y.y - m.z.z - m.x.x, m.y.z + m.z.y, m.z.x - m.x.z});
    return normalized(Quat{m.z.x + m.x.z, m.y.z + m.z.y, 1 + m.z.z - m.x.x - m.y.y, m.x.y - m.y.x});
}

gphys_transform composed(const gphys_transform& parent, const gphys_transform& local) {
    return {narrow(widen(parent).apply(widen(local.position))),
            narrow(normalized(widen(parent.rotation) * widen(local.rotation))),
            static_cast<float>(double{parent.scale} * local.scale)};
}

gphys_transform relative(const gphys_transform& parent, const gphys_transform& world) {
    return {narrow(widen(parent).inverse_apply(widen(world.position))),
            narrow(normalized(conjugate(widen(parent.rotation)) * widen(world.rotation))),
            static_cast<float>(double{world.scale} / parent.scale)};
}

}  // namespace gphys
