// A scene of random models, changed at random, and the slow obvious answers: each model's shape is
// placed in the world and asked, one after the other, without a tree. Meshes likewise, triangle by
// triangle.
#pragma once

#include <array>
#include <cstring>
#include <functional>
#include <map>
#include <variant>
#include <vector>

#include "geometry/intersect.h"
#include "test.h"

namespace test {

using namespace gphys;

struct MeshSource {
    std::vector<gphys_vec3> vertices;
    std::vector<uint32_t> indices;

    Triangle triangle(uint32_t i) const {
        return {widen(vertices[indices[3 * i]]), widen(vertices[indices[3 * i + 1]]),
                widen(vertices[indices[3 * i + 2]])};
    }
    uint32_t triangle_count() const { return static_cast<uint32_t>(indices.size() / 3); }
    gphys_mesh* create() const {
        gphys_mesh* mesh = nullptr;
        REQUIRE(gphys_mesh_create(nullptr, &vertices[0].x, sizeof(gphys_vec3), static_cast<uint32_t>(vertices.size()),
                                  indices.data(), static_cast<uint32_t>(indices.size()), &mesh) == GPHYS_OK);
        return mesh;
    }
};

inline MeshSource cube_mesh() {
    MeshSource cube;
    for (int i = 0; i < 8; ++i) cube.vertices.push_back({i & 1 ? 1.f : -1.f, i & 2 ? 1.f : -1.f, i & 4 ? 1.f : -1.f});
    cube.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return cube;
}

inline MeshSource random_mesh(Random& random, uint32_t triangles) {
    MeshSource mesh;
    for (uint32_t i = 0; i < 3 * triangles; ++i) {
        const gphys_vec3 at = i % 3 == 0 ? random.point(2) : random.point(0.7f);
        const gphys_vec3 base = i % 3 == 0 ? gphys_vec3{} : mesh.vertices[i / 3 * 3];
        mesh.vertices.push_back({base.x + at.x, base.y + at.y, base.z + at.z});
        mesh.indices.push_back(i);
    }
    return mesh;
}

/// A model as the public interface describes it, placed in the world.
struct PlacedModel {
    gphys_model_id id;
    uint32_t layers, tag;
    Transform world;
    std::variant<Shape, const MeshSource*> shape;
};

inline bool raycast(const PlacedModel& model, const Ray& ray, Hit& hit) {
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) return gphys::raycast(*shape, ray, hit);
    const MeshSource& mesh = *std::get<1>(model.shape);
    Ray local{model.world.inverse_apply(ray.origin), model.world.inverse_apply_to_vector(ray.direction), ray.t_max};
    if (ray.is_segment) {
        // Both ends are where the mesh has its own points.
        local = ray_along({local.origin, model.world.inverse_apply(end_of(ray))});
        local.t_max = ray.t_max;
    }
    bool found = false;
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        Hit candidate;
        if (!gphys::raycast(mesh.triangle(i), local, candidate)) continue;
        if (found && reported(candidate.t) >= reported(hit.t)) continue;
        hit = candidate;
        hit.triangle = i;
        found = true;
    }
    if (found) {
        hit.point = model.world.apply(hit.point);
        hit.normal = model.world.rotation * hit.normal;
    }
    return found;
}

/// `local` is the solid in the mesh's coordinates.
template <class Solid>
bool sweep_solid(const PlacedModel& model, const Solid& moving, const Solid& local, Vec3 displacement, Hit& hit) {
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) return gphys::sweep(*shape, moving, displacement, hit);
    const MeshSource& mesh = *std::get<1>(model.shape);
    bool found = false;
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        Hit candidate;
        if (!gphys::sweep(mesh.triangle(i), local, model.world.inverse_apply_to_vector(displacement), candidate))
            continue;
        if (found && reported(candidate.t) >= reported(hit.t)) continue;
        hit = candidate;
        hit.triangle = i;
        found = true;
    }
    if (found) {
        hit.point = model.world.apply(hit.point);
        hit.normal = model.world.rotation * hit.normal;
    }
    return found;
}

inline bool sweep(const PlacedModel& model, const Sphere& moving, Vec3 displacement, Hit& hit) {
    const Sphere local{model.world.inverse_apply(moving.center), moving.radius / model.world.scale};
    return sweep_solid(model, moving, local, displacement, hit);
}
inline bool sweep(const PlacedModel& model, const Shape& moving, Vec3 displacement, Hit& hit) {
    if (const Sphere* sphere = std::get_if<Sphere>(&moving)) return sweep(model, *sphere, displacement, hit);
    return sweep_solid(model, moving, inverse_transformed(moving, model.world), displacement, hit);
}

/// The ways of a solid out of the model, in no order.
inline void add_ways_out(const PlacedModel& model, const Shape& moving, std::vector<gphys_penetration>& out) {
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) {
        if (!gphys::overlaps(*shape, moving)) return;
        out.push_back(to_penetration(penetration(*shape, moving), GPHYS_NO_TRIANGLE, model.id, model.tag));
        return;
    }
    const MeshSource& mesh = *std::get<1>(model.shape);
    const Shape local = inverse_transformed(moving, model.world);
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        if (!gphys::overlaps(Shape(mesh.triangle(i)), local)) continue;
        const Penetration way = penetration(mesh.triangle(i), local);
        out.push_back(to_penetration(
            {way.depth * model.world.scale, model.world.rotation * way.normal, model.world.apply(way.point)}, i,
            model.id, model.tag));
    }
}

inline bool overlaps(const PlacedModel& model, const Shape& query) {
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) return gphys::overlaps(*shape, query);
    const MeshSource& mesh = *std::get<1>(model.shape);
    const Shape local = inverse_transformed(query, model.world);
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        if (gphys::overlaps(Shape(mesh.triangle(i)), local)) return true;
    }
    return false;
}

/// The distance, as a double, the point and the triangle; infinity if none is within `most`.
inline double closest_point(const PlacedModel& model, Vec3 point, double most, Vec3& out, uint32_t& triangle) {
    triangle = GPHYS_NO_TRIANGLE;
    if (const Shape* shape = std::get_if<Shape>(&model.shape)) {
        std::visit(
            [&](const auto& s) {
                if constexpr (!std::is_same_v<std::decay_t<decltype(s)>, Frustum>) out = gphys::closest_point(s, point);
            },
            *shape);
        const double squared = length_squared(out - point);
        return squared > most * most ? infinity : std::sqrt(squared);
    }
    const MeshSource& mesh = *std::get<1>(model.shape);
    const Vec3 local = model.world.inverse_apply(point);
    double least = infinity;
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        const Vec3 candidate = model.world.apply(gphys::closest_point(mesh.triangle(i), local));
        const double squared = length_squared(candidate - point);
        if (squared > most * most || reported(std::sqrt(squared)) >= reported(least)) continue;
        least = std::sqrt(squared);
        out = candidate;
        triangle = i;
    }
    return least;
}

class RandomScene {
public:
    explicit RandomScene(uint64_t seed) : random(seed) {
        REQUIRE(gphys_scene_create(nullptr, &scene) == GPHYS_OK);
        sources_ = {cube_mesh(), random_mesh(random, 20), random_mesh(random, 40)};
        for (size_t i = 0; i < sources_.size(); ++i) meshes_[i] = sources_[i].create();
    }
    ~RandomScene() {
        gphys_scene_destroy(scene);
        for (gphys_mesh* mesh : meshes_) gphys_mesh_destroy(mesh);
    }
    RandomScene(const RandomScene&) = delete;
    RandomScene& operator=(const RandomScene&) = delete;

    Random random;
    gphys_scene* scene = nullptr;
    std::vector<PlacedModel> models;  // by id, after look()
    /// Whole numbers and no rotation: things touch, coincide and tie all the time.
    bool on_grid = false;
    /// That all models share; 0 once they are not to.
    uint32_t common_layer = 8;

    gphys_vec3 point(float extent) {
        gphys_vec3 p = random.point(extent);
        if (on_grid) p = {std::round(p.x), std::round(p.y), std::round(p.z)};
        return p;
    }
    float size(float most) { return on_grid ? static_cast<float>(random.index(3)) : random.uniform_float(0, most); }

    gphys_transform transform() {
        gphys_transform t{point(random.index(20) == 0 ? 1e5f : 12), {0, 0, 0, 1}, 1};
        if (!on_grid && random.index(3) != 0) t.rotation = random.rotation();
        if (!on_grid && random.index(2) != 0) t.scale = random.uniform_float(0.2f, 3);
        return t;
    }

    /// A shape in its public form.
    struct AnyShape {
        gphys_shape_type type;
        alignas(8) unsigned char bytes[128];
        template <class Public>
        void hold(gphys_shape_type as, const Public& shape) {
            type = as;
            std::memcpy(bytes, &shape, sizeof shape);
        }
    };

    AnyShape primitive(float extent) {
        AnyShape any;
        const gphys_vec3 a = point(extent), b = point(extent), c = point(extent);
        const gphys_vec3 half{size(1.5f), size(1.5f), size(1.5f)};
        switch (random.index(30)) {
            case 0:
                any.hold(GPHYS_SHAPE_PLANE, gphys_plane{on_grid ? gphys_vec3{0, 2, 0} : random.point(1), 2 * a.x});
                break;
            case 1:
            case 2:
            case 3:
            case 4:
                any.hold(GPHYS_SHAPE_TRIANGLE, gphys_triangle{a, b, c});
                break;
            case 5:
            case 6:
            case 7:
            case 8:
            case 9:
                any.hold(GPHYS_SHAPE_CAPSULE, gphys_capsule{a, b, half.x});
                break;
            case 10:
            case 11:
            case 12:
            case 13:
            case 14:
                any.hold(GPHYS_SHAPE_OBB, gphys_obb{a, half, on_grid ? gphys_quat{0, 0, 0, 1} : random.rotation()});
                break;
            case 15:
            case 16:
            case 17:
            case 18:
            case 19:
                any.hold(GPHYS_SHAPE_SPHERE, gphys_sphere{a, half.x});
                break;
            default:
                any.hold(GPHYS_SHAPE_AABB, gphys_aabb{a, {a.x + half.x, a.y + half.y, a.z + half.z}});
        }
        return any;
    }

    /// A box that looks in a random direction, or a pyramid.
    gphys_frustum frustum() {
        const Mat3 axes = on_grid ? Mat3{} : rotation_matrix(widen(random.rotation()));
        const double slope = random.index(2) ? 0.0 : 0.5;
        gphys_frustum f{};
        f.origin = point(10);
        const float width = 1 + size(6), depth = 2 + size(15);
        const auto plane = [](Vec3 normal, float distance) { return gphys_plane{narrow(normal), distance}; };
        f.planes[GPHYS_FRUSTUM_NEAR] = plane(axes.z, 0);
        f.planes[GPHYS_FRUSTUM_FAR] = random.index(4) == 0 ? gphys_plane{{0, 0, 0}, -1} : plane(-axes.z, -depth);
        f.planes[GPHYS_FRUSTUM_LEFT] = plane(axes.x + axes.z * slope, -width);
        f.planes[GPHYS_FRUSTUM_RIGHT] = plane(-axes.x + axes.z * slope, -width);
        f.planes[GPHYS_FRUSTUM_BOTTOM] = plane(axes.y + axes.z * slope, -width);
        f.planes[GPHYS_FRUSTUM_TOP] = plane(-axes.y + axes.z * slope, -width);
        return f;
    }

    void add() {
        gphys_model_desc desc;
        gphys_model_desc_init(&desc, sizeof desc);
        desc.layers = 1u << random.index(3) | 1u << random.index(3) | common_layer;
        desc.tag = random.index(1000);
        if (!ids_.empty() && random.index(3) == 0) desc.parent = any_model();
        const gphys_transform at = transform();
        gphys_model_id id = 0;
        if (random.index(15) == 0) {
            const uint32_t which = random.index(static_cast<uint32_t>(sources_.size()));
            REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_MESH, meshes_[which], &at, &desc, &id) == GPHYS_OK);
            mesh_of_[id] = &sources_[which];
        } else {
            const AnyShape shape = primitive(2);
            REQUIRE(gphys_scene_add(scene, shape.type, shape.bytes, &at, &desc, &id) == GPHYS_OK);
        }
        ids_.push_back(id);
    }

    /// Another shape or mesh in the place of what the model is.
    void reshape(gphys_model_id model) {
        if (random.index(5) == 0) {
            const uint32_t which = random.index(static_cast<uint32_t>(sources_.size()));
            REQUIRE(gphys_scene_set_shape(scene, model, GPHYS_SHAPE_MESH, meshes_[which]) == GPHYS_OK);
            mesh_of_[model] = &sources_[which];
        } else {
            const AnyShape shape = primitive(2);
            REQUIRE(gphys_scene_set_shape(scene, model, shape.type, shape.bytes) == GPHYS_OK);
        }
    }

    void change() {
        if (ids_.size() < 20 || (ids_.size() < 150 && random.index(4) == 0)) return add();
        const gphys_model_id model = any_model();
        switch (random.index(9)) {
            case 8:
                reshape(model);
                break;
            case 0:
                REQUIRE(gphys_scene_remove(scene, model) == GPHYS_OK);
                break;
            case 1:
                if (random.index(8) == 0) REQUIRE(gphys_scene_remove_subtree(scene, model) == GPHYS_OK);
                break;
            case 2: {
                const gphys_status status =
                    gphys_scene_set_parent(scene, model, random.index(2) ? any_model() : 0, random.index(2));
                REQUIRE((status == GPHYS_OK || status == GPHYS_ERROR_CYCLE));
                break;
            }
            case 3:
                REQUIRE(gphys_scene_set_layers(scene, model, 1u << random.index(3) | common_layer) == GPHYS_OK);
                break;
            case 4: {
                std::vector<gphys_model_id> some;
                std::vector<gphys_transform> to;
                for (uint32_t i = random.index(static_cast<uint32_t>(ids_.size())); i > 0; --i) {
                    some.push_back(any_model());
                    to.push_back(transform());
                }
                REQUIRE(gphys_scene_set_transforms(scene, some.data(), to.data(), sizeof(gphys_transform),
                                                   static_cast<uint32_t>(some.size())) == GPHYS_OK);
                break;
            }
            default: {
                const gphys_transform to = transform();
                REQUIRE(gphys_scene_set_transform(scene, model, &to) == GPHYS_OK);
            }
        }
        list();
    }

    /// Read the scene through the public interface.
    void look() {
        list();
        models.clear();
        for (const gphys_model_id id : ids_) {
            gphys_model_info info;
            gphys_transform at;
            REQUIRE(gphys_scene_get_info(scene, id, &info) == GPHYS_OK);
            REQUIRE(gphys_scene_get_world_transforms(scene, &id, 1, &at, sizeof at) == GPHYS_OK);
            models.push_back({id, info.layers, info.tag, widen(at), {}});
            PlacedModel& model = models.back();
            if (info.type == GPHYS_SHAPE_MESH) {
                model.shape = mesh_of_.at(id);
                continue;
            }
            alignas(8) unsigned char bytes[128];
            REQUIRE(gphys_scene_get_shape(scene, id, bytes, sizeof bytes) == GPHYS_OK);
            model.shape = placed(info.type, bytes, at);
        }
    }

    gphys_model_id any_model() { return ids_[random.index(static_cast<uint32_t>(ids_.size()))]; }

private:
    template <class Public>
    static Public read(const void* bytes) {
        Public shape;
        std::memcpy(&shape, bytes, sizeof shape);
        return shape;
    }

    static Shape placed(gphys_shape_type type, const void* bytes, const gphys_transform& at) {
        const Transform world = widen(at);
        switch (type) {
            case GPHYS_SHAPE_SPHERE:
                return transformed(widen(read<gphys_sphere>(bytes)), world);
            case GPHYS_SHAPE_CAPSULE:
                return transformed(widen(read<gphys_capsule>(bytes)), world);
            case GPHYS_SHAPE_OBB:
                return transformed(widen(read<gphys_obb>(bytes)), world);
            case GPHYS_SHAPE_PLANE:
                return transformed(widen(read<gphys_plane>(bytes)), world);
            case GPHYS_SHAPE_TRIANGLE:
                return transformed(widen(read<gphys_triangle>(bytes)), world);
            default: {
                const Aabb box = widen(read<gphys_aabb>(bytes));
                const bool turned = at.rotation.x != 0 || at.rotation.y != 0 || at.rotation.z != 0;
                if (turned) return transformed(box, world);
                return Aabb{world.position + box.min * world.scale, world.position + box.max * world.scale};
            }
        }
    }

    void list() {
        uint32_t total = 0;
        gphys_scene_get_models(scene, nullptr, 0, &total);
        ids_.resize(total);
        REQUIRE(gphys_scene_get_models(scene, ids_.data(), total, &total) == GPHYS_OK);
    }

    std::vector<gphys_model_id> ids_;
    std::vector<MeshSource> sources_;
    std::array<gphys_mesh*, 3> meshes_{};
    std::map<gphys_model_id, const MeshSource*> mesh_of_;
};

}  // namespace test
