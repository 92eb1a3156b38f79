#include "placed_model.h"

#include <algorithm>
#include <cmath>

#include "foundation/exact.h"

namespace fuzz {

using namespace gphys;

namespace {

Triangle triangle_of(const MeshSource& mesh, uint32_t i) { return widen(mesh.triangle(i)); }

/// Each number of a shape that a scale may have, times that of its axis, rounded once.
AnyShape scaled(const AnyShape& shape, const gphys_vec3& scale) {
    const auto times = [&](const gphys_vec3& v) { return gphys_vec3{v.x * scale.x, v.y * scale.y, v.z * scale.z}; };
    const auto of = [&](const auto& s) { return AnyShape::of(shape.type, s); };
    switch (shape.type) {
        case GPHYS_SHAPE_SPHERE: {
            const auto s = shape.as<gphys_sphere>();
            return of(gphys_sphere{times(s.center), s.radius * scale.x});
        }
        case GPHYS_SHAPE_CAPSULE: {
            const auto s = shape.as<gphys_capsule>();
            return of(gphys_capsule{times(s.a), times(s.b), s.radius * scale.x});
        }
        case GPHYS_SHAPE_AABB: {
            const auto s = shape.as<gphys_aabb>();
            return of(gphys_aabb{times(s.min), times(s.max)});
        }
        case GPHYS_SHAPE_OBB: {
            const auto s = shape.as<gphys_obb>();
            return of(gphys_obb{times(s.center), times(s.half_extents), s.rotation});
        }
        case GPHYS_SHAPE_PLANE: {
            const auto s = shape.as<gphys_plane>();
            return of(gphys_plane{s.normal, s.distance * scale.x});
        }
        default: {
            const auto s = shape.as<gphys_triangle>();
            return of(gphys_triangle{times(s.a), times(s.b), times(s.c)});
        }
    }
}

/// A segment is what its ends say, in the space of a mesh too: t is 1 exactly at its end there.
Ray into_mesh(const Ray& ray, const MeshPlace& place) {
    const Vec3 origin = place.inverse_apply(ray.origin);
    if (!ray.is_segment) return {origin, place.inverse_apply_to_vector(ray.direction), ray.t_max};
    return ray_along({origin, place.inverse_apply(end_of(ray))});
}

/// The normal of a hit in the world: that of the triangle divided by the scale, or against a ray along it.
Vec3 normal_of(const Hit& hit, const MeshSource& mesh, const Ray& ray, const MeshPlace& place) {
    if (place.axes.is_one()) return place.world.rotation * hit.normal;
    const Triangle t = triangle_of(mesh, hit.triangle);
    const Vec3 face = accurate_cross(t.a, t.b, t.a, t.c);
    if (face == Vec3{}) return ray.direction == Vec3{} ? hit.normal : -normalized(ray.direction);
    const Vec3 normal = place.axes.normal(normalized(face));
    return place.world.rotation * ((hit.flags & GPHYS_HIT_BACK) != 0 ? -normal : normal);
}

/// The largest coordinate as seen from a point; of a plane or frustum the distances that define it.
double reach(const Shape& shape, Vec3 from) {
    return std::visit(
        [from](const auto& s) {
            using S = std::decay_t<decltype(s)>;
            const S seen = relative_to(from, s);
            double most = 0;
            if constexpr (std::is_same_v<S, Plane>) {
                most = std::fabs(seen.distance) / length(seen.normal);
            } else if constexpr (std::is_same_v<S, Frustum>) {
                most = max_component(abs(seen.origin));
                for (const Plane& plane : seen.planes) {
                    if (plane.normal != Vec3{}) most = std::max(most, std::fabs(plane.distance) / length(plane.normal));
                }
            } else {
                const Box box = bounds(seen);
                for (int k = 0; k < 3; ++k) {
                    most = std::max({most, std::fabs(double{box.min[k]}), std::fabs(double{box.max[k]})});
                }
            }
            return most;
        },
        shape);
}

/// Whether the answer about a model and a query takes no rounding, or the same in every function. A mesh is asked in
/// its own space, where a box of the world is turned.
bool is_exact(const PlacedModel& model, const Shape& query) {
    const auto is_one = [](const Shape& shape, bool box) {
        return std::holds_alternative<Plane>(shape) || std::holds_alternative<Triangle>(shape) ||
               std::holds_alternative<Frustum>(shape) || (box && std::holds_alternative<Aabb>(shape));
    };
    const Shape* shape = std::get_if<Shape>(&model.shape);
    return is_one(query, shape != nullptr) && (!shape || is_one(*shape, true));
}

/// Moves the surface of a solid outward, or inward if `by` is negative. False for what has no inside that far from its
/// surface: it stays as it is.
bool grow(Shape& shape, double by) {
    return std::visit(
        [by](auto& s) {
            using S = std::decay_t<decltype(s)>;
            if constexpr (std::is_same_v<S, Sphere> || std::is_same_v<S, Capsule>) {
                if (s.radius + by < 0) return false;
                s.radius += by;
            } else if constexpr (std::is_same_v<S, Obb>) {
                if (std::min(s.half.x, std::min(s.half.y, s.half.z)) + by < 0) return false;
                s.half += Vec3{by, by, by};
            } else if constexpr (std::is_same_v<S, Aabb>) {
                const Vec3 size = s.max - s.min;
                if (std::min(size.x, std::min(size.y, size.z)) + 2 * by < 0) return false;
                s.min -= Vec3{by, by, by};
                s.max += Vec3{by, by, by};
            } else if constexpr (std::is_same_v<S, Frustum>) {
                for (Plane& plane : s.planes) plane.distance -= by * length(plane.normal);
            } else {
                return false;
            }
            return true;
        },
        shape);
}

}  // namespace

Shape widened(const AnyShape& shape) {
    switch (shape.type) {
        case GPHYS_SHAPE_SPHERE:
            return widen(shape.as<gphys_sphere>());
        case GPHYS_SHAPE_CAPSULE:
            return widen(shape.as<gphys_capsule>());
        case GPHYS_SHAPE_AABB:
            return widen(shape.as<gphys_aabb>());
        case GPHYS_SHAPE_OBB:
            return widen(shape.as<gphys_obb>());
        case GPHYS_SHAPE_PLANE:
            return widen(shape.as<gphys_plane>());
        case GPHYS_SHAPE_TRIANGLE:
            return widen(shape.as<gphys_triangle>());
        default:
            return widen(shape.as<gphys_frustum>());
    }
}

PlacedModel placed(gphys_model_id id, uint32_t tag, const gphys_transform& world, const AnyShape& given,
                   const MeshSource* source, const gphys_vec3& scale) {
    PlacedModel model{id, tag, widen(world), source, AxisScale(widen(scale))};
    if (source) return model;
    const AnyShape shape = scaled(given, scale);
    const Transform& t = model.world;
    const bool turned = world.rotation.x != 0 || world.rotation.y != 0 || world.rotation.z != 0;
    if (shape.type == GPHYS_SHAPE_AABB && !turned) {  // keeps its faces
        const Aabb box = widen(shape.as<gphys_aabb>());
        model.shape = Shape(Aabb{t.position + box.min * t.scale, t.position + box.max * t.scale});
    } else {
        model.shape = std::visit([&](const auto& s) { return Shape(transformed(s, t)); }, widened(shape));
    }
    return model;
}

bool raycast(const PlacedModel& model, const Ray& ray, gphys_hit& out) {
    Hit first;
    bool found = false;
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) {
        found = gphys::raycast(*shape, ray, first);
    } else {
        const MeshSource& mesh = *std::get<1>(model.shape);
        const MeshPlace place{model.world, model.axes};
        const Ray local = into_mesh(ray, place);
        for (uint32_t i = 0; i < mesh.triangles(); ++i) {
            Hit hit;
            if (!gphys::raycast(triangle_of(mesh, i), local, hit)) continue;
            if (found && to_hit(hit).t >= to_hit(first).t) continue;
            first = hit;
            first.triangle = i;
            found = true;
        }
        if (found) {
            first.point = place.apply(first.point);
            first.normal = normal_of(first, mesh, ray, place);
        }
    }
    if (found) out = to_hit(first, model.id, model.tag);
    return found;
}

namespace {

/// `local` is the solid in the mesh's coordinates.
template <class Solid>
bool sweep_model(const PlacedModel& model, const Solid& moving, const Solid& local, Vec3 displacement, gphys_hit& out) {
    Hit first;
    bool found = false;
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) {
        found = gphys::sweep(*shape, moving, displacement, first);
    } else {
        const MeshSource& mesh = *std::get<1>(model.shape);
        for (uint32_t i = 0; i < mesh.triangles(); ++i) {
            Hit hit;
            if (!gphys::sweep(model.axes(triangle_of(mesh, i)), local,
                              model.world.inverse_apply_to_vector(displacement), hit))
                continue;
            if (found && to_hit(hit).t >= to_hit(first).t) continue;
            first = hit;
            first.triangle = i;
            found = true;
        }
        first.point = model.world.apply(first.point);
        first.normal = model.world.rotation * first.normal;
    }
    if (found) out = to_contact(first, displacement, model.id, model.tag);
    return found;
}

}  // namespace

bool sweep(const PlacedModel& model, const Sphere& moving, Vec3 displacement, gphys_hit& out) {
    const Sphere local{model.world.inverse_apply(moving.center), moving.radius / model.world.scale};
    return sweep_model(model, moving, local, displacement, out);
}

bool sweep(const PlacedModel& model, const Shape& moving, Vec3 displacement, gphys_hit& out) {
    if (const Sphere* sphere = std::get_if<Sphere>(&moving)) return sweep(model, *sphere, displacement, out);
    return sweep_model(model, moving, inverse_transformed(moving, model.world), displacement, out);
}

void add_ways_out(const PlacedModel& model, const Shape& moving, std::vector<gphys_penetration>& out) {
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) {
        if (!gphys::overlaps(*shape, moving)) return;
        out.push_back(to_penetration(penetration(*shape, moving), GPHYS_NO_TRIANGLE, model.id, model.tag));
        return;
    }
    const MeshSource& mesh = *std::get<1>(model.shape);
    const Shape local = inverse_transformed(moving, model.world);
    for (uint32_t i = 0; i < mesh.triangles(); ++i) {
        const Triangle triangle = model.axes(triangle_of(mesh, i));
        if (!gphys::overlaps(Shape(triangle), local)) continue;
        const Penetration way = penetration(triangle, local);
        const Penetration world{way.depth * model.world.scale, model.world.rotation * way.normal,
                                model.world.apply(way.point)};
        out.push_back(to_penetration(world, i, model.id, model.tag));
    }
}

bool overlaps(const PlacedModel& model, const Shape& query) {
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) return gphys::overlaps(*shape, query);
    const MeshSource& mesh = *std::get<1>(model.shape);
    const Shape local = inverse_transformed(query, model.world);
    for (uint32_t i = 0; i < mesh.triangles(); ++i) {
        if (gphys::overlaps(Shape(model.axes(triangle_of(mesh, i))), local)) return true;
    }
    return false;
}

bool is_clear(const PlacedModel& model, const Shape& query) {
    if (is_exact(model, query)) return true;
    const Vec3 from = model.world.position;
    double of_model = 0;
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) {
        of_model = reach(*shape, from);
    } else {
        const MeshSource& mesh = *std::get<1>(model.shape);
        for (uint32_t i = 0; i < mesh.triangles(); ++i)
            of_model = std::max(of_model, reach(model.axes(triangle_of(mesh, i)), {}));
        of_model *= 2 * model.world.scale;  // turned, a coordinate is at most sqrt(3) of the largest
    }
    // No coordinates differ by more than the sum. The bound is 2^-40 of it, also for the larger or smaller shapes.
    const double by = 0x1p-38 * (of_model + reach(query, from));
    const auto answer = [&](double grown, bool& has_grown) {
        PlacedModel other = model;
        Shape other_query = query;
        Shape* shape = std::get_if<Shape>(&other.shape);
        has_grown = grow(other_query, grown) || (shape && grow(*shape, grown));
        return overlaps(other, other_query);
    };
    bool is_larger, is_smaller;
    const bool larger_overlaps = answer(by, is_larger), smaller_overlaps = answer(-by, is_smaller);
    return (is_larger && !larger_overlaps) || (is_smaller && smaller_overlaps);
}

bool has_clear_parts(const PlacedModel& model, const Shape& query) {
    if (std::holds_alternative<Shape>(model.shape)) return is_clear(model, query);
    const MeshSource& mesh = *std::get<1>(model.shape);
    const Shape local = inverse_transformed(query, model.world);
    for (uint32_t i = 0; i < mesh.triangles(); ++i) {
        if (!is_clear({model.id, model.tag, Transform{}, Shape(model.axes(triangle_of(mesh, i)))}, local)) return false;
    }
    return true;
}

bool nearest(const PlacedModel& model, Vec3 point, double within, gphys_nearest& out) {
    Vec3 closest;
    uint32_t triangle = GPHYS_NO_TRIANGLE;
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) {
        std::visit(
            [&](const auto& s) {
                if constexpr (!std::is_same_v<std::decay_t<decltype(s)>, Frustum>) closest = closest_point(s, point);
            },
            *shape);
    } else {
        const MeshSource& mesh = *std::get<1>(model.shape);
        const Vec3 local = model.world.inverse_apply(point);
        // Of triangles that are reported at the same distance in the world the lowest is the nearest.
        float least = std::numeric_limits<float>::infinity();
        for (uint32_t i = 0; i < mesh.triangles(); ++i) {
            const Vec3 candidate = model.world.apply(closest_point(model.axes(triangle_of(mesh, i)), local));
            const double squared = length_squared(candidate - point);
            const float distance = reported(std::sqrt(squared));
            if (squared > within * within || distance >= least) continue;
            least = distance;
            closest = candidate;
            triangle = i;
        }
        if (triangle == GPHYS_NO_TRIANGLE) return false;
    }
    const double squared = length_squared(closest - point);
    if (squared > within * within) return false;
    out = to_nearest(closest, std::sqrt(squared), triangle, model.id, model.tag);
    return true;
}

}  // namespace fuzz
