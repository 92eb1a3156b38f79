// Which shapes are surfaces, and which side of them a motion hits.
#pragma once

#include "foundation/exact.h"
#include "shapes/shapes.h"

namespace gphys {

template <class Solid>
bool is_surface(const Solid&) {
    return false;
}
inline bool is_surface(const Plane&) { return true; }
inline bool is_surface(const Triangle&) { return true; }
inline bool is_surface(const Shape& shape) {
    return std::holds_alternative<Plane>(shape) || std::holds_alternative<Triangle>(shape);
}

/// Whether a motion hits a side of the shape that `faces` includes. It hits the back if the normal points along the
/// motion. Solids have no back, and a motion parallel to a surface hits neither side: both always count.
template <class Solid>
bool hits_side(const Solid&, Vec3, Faces) {
    return true;
}
inline bool hits_side(const Plane& plane, Vec3 displacement, Faces faces) {
    return faces.are_all() || faces.include(sign_of([&](auto number) {
                                                using V = Vec<decltype(number)>;
                                                return dot(V::of(plane.normal), V::of(displacement));
                                            }) > 0);
}
inline bool hits_side(const Triangle& triangle, Vec3 displacement, Faces faces) {
    return faces.are_all() || faces.include(sign_of([&](auto number) {
                                                using V = Vec<decltype(number)>;
                                                const auto normal = cross(V::difference(triangle.b, triangle.a),
                                                                          V::difference(triangle.c, triangle.a));
                                                return dot(normal, V::of(displacement));
                                            }) > 0);
}

}  // namespace gphys
