// Which shapes are surfaces, and from which side a motion meets them.
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

/// Whether a motion meets a side of the shape that is asked for: the back if the normal looks along it. Solids have
/// none that could be left out, nor does what is met edge on have a back.
template <class Solid>
bool meets_side(const Solid&, Vec3, Faces) {
    return true;
}
inline bool meets_side(const Plane& plane, Vec3 displacement, Faces faces) {
    return faces.are_all() || faces.include(sign_of([&](auto number) {
                                                using V = Vec<decltype(number)>;
                                                return dot(V::of(plane.normal), V::of(displacement));
                                            }) > 0);
}
inline bool meets_side(const Triangle& triangle, Vec3 displacement, Faces faces) {
    return faces.are_all() || faces.include(sign_of([&](auto number) {
                                                using V = Vec<decltype(number)>;
                                                const auto normal = cross(V::difference(triangle.b, triangle.a),
                                                                          V::difference(triangle.c, triangle.a));
                                                return dot(normal, V::of(displacement));
                                            }) > 0);
}

}  // namespace gphys
