// A model where it stands in the world, in double precision, and what each question about it alone answers: by the
// functions for shapes, without tree, kernels or quick tests; a mesh triangle by triangle.
#pragma once

#include <variant>
#include <vector>

#include "geometry/intersect.h"
#include "mesh/mesh_place.h"
#include "mesh_source.h"

namespace fuzz {

struct PlacedModel {
    gphys_model_id id;
    uint32_t tag;
    gphys::Transform world;
    std::variant<gphys::Shape, const MeshSource*> shape;  // a shape is scaled already
    gphys::AxisScale axes = {};                           // of a mesh
};

PlacedModel placed(gphys_model_id id, uint32_t tag, const gphys_transform& world, const AnyShape& shape,
                   const MeshSource* source, const gphys_vec3& scale);

bool raycast(const PlacedModel& model, const gphys::Ray& ray, gphys_hit& hit);
bool sweep(const PlacedModel& model, const gphys::Sphere& moving, gphys::Vec3 displacement, gphys_hit& hit);
/// The same for a moving sphere, capsule or box.
bool sweep(const PlacedModel& model, const gphys::Shape& moving, gphys::Vec3 displacement, gphys_hit& hit);
/// The ways of a sphere, capsule or box out of the model, in no order.
void add_ways_out(const PlacedModel& model, const gphys::Shape& moving, std::vector<gphys_penetration>& out);
bool overlaps(const PlacedModel& model, const gphys::Shape& query);
/// Whether the answer of overlaps is the same if the query, or else the model, is larger, or smaller, by more than the
/// error that the header allows for the pair: then it has to be right.
bool is_clear(const PlacedModel& model, const gphys::Shape& query);
/// The same of each triangle, if the model is a mesh.
bool has_clear_parts(const PlacedModel& model, const gphys::Shape& query);
/// False if nothing is within that distance, which the doubles decide: what is reported at it may be beyond.
bool nearest(const PlacedModel& model, gphys::Vec3 point, double within, gphys_nearest& near);

gphys::Shape widened(const AnyShape& shape);

}  // namespace fuzz
