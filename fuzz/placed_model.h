// A model where it stands in the world, in double precision, and what each question about it alone answers: by the
// functions for shapes, without tree, kernels or quick tests; a mesh triangle by triangle.
#pragma once

#include <variant>

#include "intersect/intersect.h"
#include "mesh_source.h"

namespace fuzz {

struct PlacedModel {
    gphys_model_id id;
    uint32_t tag;
    gphys::Transform world;
    std::variant<gphys::Shape, const MeshSource*> shape;
};

PlacedModel placed(gphys_model_id id, uint32_t tag, const gphys_transform& world, const AnyShape& shape,
                   const MeshSource* source);

bool raycast(const PlacedModel& model, const gphys::Ray& ray, gphys_hit& hit);
bool sweep(const PlacedModel& model, const gphys::Sphere& moving, gphys::Vec3 displacement, gphys_hit& hit);
bool overlaps(const PlacedModel& model, const gphys::Shape& query);
/// False for an empty mesh.
bool nearest(const PlacedModel& model, gphys::Vec3 point, gphys_nearest& near);

gphys::Shape widened(const AnyShape& shape);

}  // namespace fuzz
