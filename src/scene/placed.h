// A public shape transformed to world space, in double precision: visit gets the primitive, or the instance of a mesh.
#pragma once

#include "foundation/float4.h"
#include "geometry/intersect.h"
#include "mesh/mesh_instance.h"
#include "scene/model_scale.h"

namespace gphys {

inline bool is_turned(const gphys_quat& rotation) { return rotation.x != 0 || rotation.y != 0 || rotation.z != 0; }

template <class Stored, class Visit>
auto with_placed(const Stored& shape, const gphys_transform& world, Visit&& visit) {
    return visit(transformed(widen(shape), widen(world)));
}

/// Without rotation, not even of negative zeros, the centre takes no matrix to get the same bits.
template <class Visit>
auto with_placed(const gphys_sphere& shape, const gphys_transform& world, Visit&& visit) {
    const Sphere sphere = widen(shape);
    const Mask4 rotation = as_mask(load4(world.rotation));
    if (any(rotation & mask4(-1, -1, -1, 0))) return visit(transformed(sphere, widen(world)));
    const double scale = world.scale;
    return visit(Sphere{widen(world.position) + Mat3() * (sphere.center * scale), sphere.radius * scale});
}

/// Without rotation a box keeps its faces where they are, to the last bit.
template <class Visit>
auto with_placed(const gphys_aabb& shape, const gphys_transform& world, Visit&& visit) {
    const Aabb box = widen(shape);
    if (is_turned(world.rotation)) return visit(transformed(box, widen(world)));
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
