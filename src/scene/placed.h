// A stored shape in world space, in double precision, for the exact tests: visit(primitive), or visit(MeshInstance).
// The transform is applied at each query instead of being stored, since a model then fits into one cache line.
#pragma once

#include "foundation/float4.h"
#include "geometry/intersect.h"
#include "mesh/mesh_instance.h"
#include "scene/model_scale.h"

namespace gphys {

inline bool is_rotated(const gphys_quat& rotation) { return rotation.x != 0 || rotation.y != 0 || rotation.z != 0; }

template <class Stored, class Visit>
auto with_placed(const Stored& shape, const gphys_transform& world, Visit&& visit) {
    return visit(transformed(widen(shape), widen(world)));
}

/// With all rotation bits zero, the same bits result without a rotation matrix.
template <class Visit>
auto with_placed(const gphys_sphere& shape, const gphys_transform& world, Visit&& visit) {
    const Sphere sphere = widen(shape);
    const Mask4 rotation = as_mask(load4(world.rotation));
    if (any(rotation & mask4(-1, -1, -1, 0))) return visit(transformed(sphere, widen(world)));
    const double scale = world.scale;
    return visit(Sphere{widen(world.position) + Mat3() * (sphere.center * scale), sphere.radius * scale});
}

/// The same for planes.
template <class Visit>
auto with_placed(const gphys_plane& shape, const gphys_transform& world, Visit&& visit) {
    const Plane plane = widen(shape);
    const Mask4 rotation = as_mask(load4(world.rotation));
    if (any(rotation & mask4(-1, -1, -1, 0))) return visit(transformed(plane, widen(world)));
    const Vec3 normal = Mat3() * plane.normal;
    return visit(Plane{normal, plane.distance * double{world.scale} + dot(normal, widen(world.position))});
}

/// Without rotation the faces of a box are exact.
template <class Visit>
auto with_placed(const gphys_aabb& shape, const gphys_transform& world, Visit&& visit) {
    const Aabb box = widen(shape);
    if (is_rotated(world.rotation)) return visit(transformed(box, widen(world)));
    const Vec3 position = widen(world.position);
    const double scale = world.scale;
    return visit(Aabb{position + box.min * scale, position + box.max * scale});
}

template <class Visit>
auto with_placed(const ModelMesh& stored, const gphys_transform& world, Visit&& visit) {
    const Transform wide = widen(world);
    return visit(MeshInstance{*stored.mesh, wide, stored.axes()});
}

}  // namespace gphys
