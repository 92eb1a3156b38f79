#include "placed_model.h"

namespace fuzz {

using namespace gphys;

namespace {

Triangle triangle_of(const MeshSource& mesh, uint32_t i) { return widen(mesh.triangle(i)); }

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

PlacedModel placed(gphys_model_id id, uint32_t tag, const gphys_transform& world, const AnyShape& shape,
                   const MeshSource* source) {
    PlacedModel model{id, tag, widen(world), source};
    if (source) return model;
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
        const Ray local{model.world.inverse_apply(ray.origin), model.world.inverse_apply_to_vector(ray.direction),
                        ray.t_max};
        for (uint32_t i = 0; i < mesh.triangles(); ++i) {
            Hit hit;
            if (!gphys::raycast(triangle_of(mesh, i), local, hit)) continue;
            if (found && to_hit(hit).t >= to_hit(first).t) continue;
            first = hit;
            first.triangle = i;
            found = true;
        }
        first.point = model.world.apply(first.point);
        first.normal = model.world.rotation * first.normal;
    }
    if (found) out = to_hit(first, model.id, model.tag);
    return found;
}

bool sweep(const PlacedModel& model, const Sphere& moving, Vec3 displacement, gphys_hit& out) {
    Hit first;
    bool found = false;
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) {
        found = gphys::sweep(*shape, moving, displacement, first);
    } else {
        const MeshSource& mesh = *std::get<1>(model.shape);
        const Sphere local{model.world.inverse_apply(moving.center), moving.radius / model.world.scale};
        for (uint32_t i = 0; i < mesh.triangles(); ++i) {
            Hit hit;
            if (!gphys::sweep(triangle_of(mesh, i), local, model.world.inverse_apply_to_vector(displacement), hit))
                continue;
            if (found && to_hit(hit).t >= to_hit(first).t) continue;
            first = hit;
            first.triangle = i;
            found = true;
        }
        first.point = model.world.apply(first.point);
        first.normal = model.world.rotation * first.normal;
    }
    if (found) out = to_hit(first, model.id, model.tag);
    return found;
}

bool overlaps(const PlacedModel& model, const Shape& query) {
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) return gphys::overlaps(*shape, query);
    const MeshSource& mesh = *std::get<1>(model.shape);
    const Shape local = inverse_transformed(query, model.world);
    for (uint32_t i = 0; i < mesh.triangles(); ++i) {
        if (gphys::overlaps(Shape(triangle_of(mesh, i)), local)) return true;
    }
    return false;
}

bool nearest(const PlacedModel& model, Vec3 point, gphys_nearest& out) {
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
            const Vec3 candidate = model.world.apply(closest_point(triangle_of(mesh, i), local));
            const float distance = reported(std::sqrt(length_squared(candidate - point)));
            if (distance >= least) continue;
            least = distance;
            closest = candidate;
            triangle = i;
        }
        if (triangle == GPHYS_NO_TRIANGLE) return false;
    }
    out = to_nearest(closest, std::sqrt(length_squared(closest - point)), triangle, model.id, model.tag);
    return true;
}

}  // namespace fuzz
