// gphys_scene_*: scenes, models and their transforms. Queries are in scene_queries.cpp.
#include "scene/scene.h"

#include <cstddef>

#include "c_api/api.h"
#include "c_api/batch.h"
#include "c_api/handles.h"
#include "c_api/lists.h"
#include "c_api/shape_input.h"

using namespace gphys;

namespace {

// The size in release 1.0. The next field is a pointer, because a smaller one would lie in the padding at the end of
// the old desc, which old clients need not have cleared.
constexpr size_t scene_desc_size = offsetof(gphys_scene_desc, task_runner);
constexpr size_t model_desc_size = offsetof(gphys_model_desc, scale);

constexpr gphys_scene_desc default_scene_desc{sizeof(gphys_scene_desc), nullptr, 0, nullptr, 0, 0};
constexpr gphys_model_desc default_model_desc{sizeof(gphys_model_desc), 0, 1, 0, no_scale};

gphys_status check_shapes(const Workers& workers, gphys_shape_type type, const void* shapes, uint32_t stride,
                          uint32_t count) {
    switch (type) {
        case GPHYS_SHAPE_MESH:
            if (count == 0) return GPHYS_OK;
            GPHYS_REQUIRE(shapes, "shape is null");
            return check_mesh_stride("shape_stride", stride);
        case GPHYS_SHAPE_FRUSTUM:
        case GPHYS_SHAPE_RAY:
        case GPHYS_SHAPE_SEGMENT:
            return fail(GPHYS_ERROR_UNSUPPORTED, "type", type,
                        "a shape that a model can have (no frustum, ray or segment)");
        default:
            break;
    }
    const size_t size = shape_struct_size(type);
    GPHYS_REQUIRE_IN_RANGE(size != 0, "type", type, "a gphys_shape_type");
    GPHYS_TRY(check_stride("shape_stride", stride, size, count));
    const Strided<char> shape(static_cast<const char*>(shapes), stride);
    return check_each(workers, distinct(stride, count), [&](uint32_t i) {
        Shape widened;
        return read_shape(type, shapes ? &shape[i] : nullptr, widened);
    });
}

gphys_status check_transforms(const Workers& workers, const gphys_transform* transforms, uint32_t stride,
                              uint32_t count) {
    GPHYS_TRY(check_stride("transform_stride", stride, sizeof(gphys_transform), count));
    const Strided<gphys_transform> transform(transforms, stride);
    return check_each(workers, distinct(stride, count),
                      [&](uint32_t i) { return check_element("transforms", i, transform[i]); });
}

gphys_status check_scale(const char* name, const gphys_vec3& scale) {
    const Defect defect = defect_of_scale(scale);
    return defect ? fail(GPHYS_ERROR_INVALID_ARGUMENT, name, defect) : GPHYS_OK;
}

/// For a desc: a program written for 1.0 and compiled anew may have filled it with zeros.
gphys_status complete_scale(const char* name, gphys_model_desc& desc) {
    if (desc.scale.x == 0 && desc.scale.y == 0 && desc.scale.z == 0) desc.scale = no_scale;
    return check_scale(name, desc.scale);
}

/// With desc_stride 0, all models share one desc.
gphys_status add_models(gphys_scene* scene, gphys_shape_type type, const void* shapes, uint32_t shape_stride,
                        const gphys_transform* transforms, uint32_t transform_stride, const gphys_model_desc* descs,
                        uint32_t desc_stride, uint32_t count, gphys_model_id* out_models) {
    GPHYS_REQUIRE_POINTERS(scene);
    if (count != 0) GPHYS_REQUIRE_POINTERS(out_models);
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_shapes(workers, type, shapes, shape_stride, count));
    if (transforms) GPHYS_TRY(check_transforms(workers, transforms, transform_stride, count));
    if (!descs || desc_stride == 0) {
        gphys_model_desc desc = default_model_desc;
        GPHYS_TRY(read_desc(descs, desc, model_desc_size));
        GPHYS_TRY(complete_scale("desc.scale", desc));
        return unwrap(scene)->add(type, shapes, shape_stride, transforms, transform_stride, count, desc, out_models);
    }
    GPHYS_TRY(check_stride("desc_stride", desc_stride, model_desc_size, count));
    Vector<gphys_model_desc> read(count, default_model_desc, &unwrap(scene)->memory);
    const Strided<char> desc(reinterpret_cast<const char*>(descs), desc_stride);
    GPHYS_TRY(check_each(workers, count, [&](uint32_t i) {
        GPHYS_TRY(read_desc_element(&desc[i], "desc_stride", desc_stride, read[i], model_desc_size));
        return complete_scale("descs.scale", read[i]);
    }));
    return unwrap(scene)->add(type, shapes, shape_stride, transforms, transform_stride, count,
                              Strided<gphys_model_desc>(read.data(), sizeof(gphys_model_desc)), out_models);
}

gphys_status remove_models(gphys_scene* scene, const gphys_model_id* models, uint32_t count) {
    GPHYS_REQUIRE_POINTERS(scene);
    if (count != 0) GPHYS_REQUIRE_POINTERS(models);
    return unwrap(scene)->remove(models, count);
}

using TransformOf = const gphys_transform& (Scene::*)(gphys_model_id) const;

gphys_status copy_transforms(const gphys_scene* scene, const gphys_model_id* models, uint32_t count,
                             gphys_transform* out_transforms, uint32_t out_stride, TransformOf transform_of) {
    GPHYS_REQUIRE_POINTERS(scene);
    if (count != 0) GPHYS_REQUIRE_POINTERS(models, out_transforms);
    GPHYS_TRY(check_out_stride("out_stride", out_stride, sizeof(gphys_transform), count));
    const Scene& from = *unwrap(scene);
    GPHYS_TRY(check_each(from.workers(), count, [&](uint32_t i) { return from.check(models[i]); }));
    const StridedOut<gphys_transform> out(out_transforms, out_stride);
    for_each_item(from.workers(), count, [&](uint32_t i) { out[i] = (from.*transform_of)(models[i]); });
    return GPHYS_OK;
}

}  // namespace

gphys_status gphys_scene_desc_init(gphys_scene_desc* desc, uint32_t size) {
    return guarded(__func__, [&] { return write_desc(desc, size, default_scene_desc, scene_desc_size); });
}

gphys_status gphys_scene_create(const gphys_scene_desc* desc, gphys_scene** out_scene) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(out_scene);
        gphys_scene_desc settings = default_scene_desc;
        GPHYS_TRY(read_desc(desc, settings, scene_desc_size));
        if (settings.reserved != 0) return newer_desc();
        GPHYS_TRY(check_allocator(settings.allocator));
        if (settings.reserve_models > IdTable::capacity) {
            return fail(GPHYS_ERROR_CAPACITY, "desc.reserve_models", settings.reserve_models, "at most 2^24 - 1");
        }
        GPHYS_TRY(check_task_runner(settings.task_runner));
        GPHYS_TRY(check_worker_count("desc.worker_count", settings.worker_count));
        *out_scene = wrap(
            create<Scene>(settings.allocator, settings.reserve_models, settings.worker_count, settings.task_runner));
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_get_snapshot(const gphys_scene* scene, int32_t embed_meshes, uint32_t* out_words,
                                      uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        GPHYS_TRY(check_bool("embed_meshes", embed_meshes));
        GPHYS_TRY(check_list("out_words", out_words, capacity, out_total));
        return unwrap(scene)->snapshot(embed_meshes != 0, out_words, capacity, *out_total);
    });
}

gphys_status gphys_scene_restore(gphys_scene* scene, const gphys_scene* library, const uint32_t* words,
                                 uint32_t count) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, words);
        return unwrap(scene)->restore(library ? *unwrap(library) : *unwrap(scene), words, count);
    });
}

gphys_status gphys_scene_get_hash(const gphys_scene* scene, uint32_t out_hash[2]) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, out_hash);
        uint32_t hash[2];
        unwrap(scene)->hash(hash);
        std::memcpy(out_hash, hash, sizeof hash);
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_set_origin(gphys_scene* scene, const double origin[3]) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, origin);
        GPHYS_TRY(check_origin(origin));
        return unwrap(scene)->set_origin({origin[0], origin[1], origin[2]});
    });
}

gphys_status gphys_scene_get_origin(const gphys_scene* scene, double out_origin[3]) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, out_origin);
        write_origin(unwrap(scene)->origin(), out_origin);
        return GPHYS_OK;
    });
}

void gphys_scene_destroy(gphys_scene* scene) {
    guarded(__func__, [&] { destroy(unwrap(scene)); });
}

gphys_status gphys_model_desc_init(gphys_model_desc* desc, uint32_t size) {
    return guarded(__func__, [&] { return write_desc(desc, size, default_model_desc, model_desc_size); });
}

gphys_status gphys_scene_add(gphys_scene* scene, gphys_shape_type type, const void* shape,
                             const gphys_transform* transform, const gphys_model_desc* desc,
                             gphys_model_id* out_model) {
    return guarded(__func__, [&]() -> gphys_status {
        if (transform) GPHYS_REQUIRE_VALID(*transform);
        return add_models(scene, type, shape, 0, transform, 0, desc, 0, 1, out_model);
    });
}

gphys_status gphys_scene_add_batch(gphys_scene* scene, gphys_shape_type type, const void* shapes, uint32_t shape_stride,
                                   const gphys_transform* transforms, uint32_t transform_stride, uint32_t count,
                                   const gphys_model_desc* desc, gphys_model_id* out_models) {
    return guarded(__func__, [&] {
        return add_models(scene, type, shapes, shape_stride, transforms, transform_stride, desc, 0, count, out_models);
    });
}

gphys_status gphys_scene_add_described_batch(gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                             uint32_t shape_stride, const gphys_transform* transforms,
                                             uint32_t transform_stride, const gphys_model_desc* descs,
                                             uint32_t desc_stride, uint32_t count, gphys_model_id* out_models) {
    return guarded(__func__, [&] {
        return add_models(scene, type, shapes, shape_stride, transforms, transform_stride, descs, desc_stride, count,
                          out_models);
    });
}

gphys_status gphys_scene_remove(gphys_scene* scene, gphys_model_id model) {
    return guarded(__func__, [&] { return remove_models(scene, &model, 1); });
}

gphys_status gphys_scene_remove_batch(gphys_scene* scene, const gphys_model_id* models, uint32_t count) {
    return guarded(__func__, [&] { return remove_models(scene, models, count); });
}

gphys_status gphys_scene_remove_subtree(gphys_scene* scene, gphys_model_id model) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        return unwrap(scene)->remove_subtree(model);
    });
}

gphys_status gphys_scene_clear(gphys_scene* scene) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        unwrap(scene)->clear();
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_set_worker_count(gphys_scene* scene, uint32_t workers) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        GPHYS_TRY(check_worker_count("workers", workers));
        unwrap(scene)->set_worker_count(workers);
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_get_worker_count(const gphys_scene* scene, uint32_t* out_workers) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, out_workers);
        *out_workers = unwrap(scene)->workers().count();
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_rebuild_octree(gphys_scene* scene) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        unwrap(scene)->rebuild_octree();
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_maintain_octree(gphys_scene* scene, uint32_t budget, int32_t* out_done) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, out_done);
        *out_done = unwrap(scene)->maintain_octree(budget) ? 1 : 0;
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_has(const gphys_scene* scene, gphys_model_id model) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        return unwrap(scene)->check(model);
    });
}

gphys_status gphys_scene_get_models(const gphys_scene* scene, gphys_model_id* out_models, uint32_t capacity,
                                    uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        return list_smallest("out_models", out_models, capacity, out_total, [&](auto& models) {
            unwrap(scene)->for_each_model([&](gphys_model_id model) { models.add(model); });
        });
    });
}

gphys_status gphys_scene_get_roots(const gphys_scene* scene, gphys_model_id* out_models, uint32_t capacity,
                                   uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        return list_smallest("out_models", out_models, capacity, out_total, [&](auto& models) {
            unwrap(scene)->for_each_model([&](gphys_model_id model) {
                if (unwrap(scene)->parent(model) == 0) models.add(model);
            });
        });
    });
}

gphys_status gphys_scene_get_children(const gphys_scene* scene, gphys_model_id model, gphys_model_id* out_models,
                                      uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        GPHYS_TRY(unwrap(scene)->check(model));
        return list_smallest("out_models", out_models, capacity, out_total, [&](auto& models) {
            unwrap(scene)->for_each_child(model, [&](gphys_model_id child) { models.add(child); });
        });
    });
}

gphys_status gphys_scene_get_info(const gphys_scene* scene, gphys_model_id model, gphys_model_info* out_info) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, out_info);
        const Scene& s = *unwrap(scene);
        GPHYS_TRY(s.check(model));
        *out_info = {s.type(model), s.parent(model), s.layers(model), s.tag(model), s.child_count(model)};
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_get_shape(const gphys_scene* scene, gphys_model_id model, void* out_shape, uint32_t out_size) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, out_shape);
        const Scene& s = *unwrap(scene);
        GPHYS_TRY(s.check(model));
        if (s.type(model) == GPHYS_SHAPE_MESH) {
            return fail(GPHYS_ERROR_UNSUPPORTED, "model: its shape is a mesh (see gphys_scene_get_mesh)");
        }
        const size_t size = shape_struct_size(s.type(model));
        GPHYS_REQUIRE_IN_RANGE(out_size >= size, "out_size", out_size, "at least the size of the model's shape");
        s.copy_unscaled_shape(model, out_shape);
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_get_mesh(const gphys_scene* scene, gphys_model_id model, gphys_mesh** out_mesh) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, out_mesh);
        GPHYS_TRY(unwrap(scene)->check(model));
        const Mesh* const mesh = unwrap(scene)->mesh(model);
        if (!mesh) return fail(GPHYS_ERROR_UNSUPPORTED, "model: its shape is not a mesh (see gphys_scene_get_shape)");
        mesh->retain();
        *out_mesh = wrap(const_cast<Mesh*>(mesh));  // scenes do not change meshes, but callers may
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_get_bounds(const gphys_scene* scene, gphys_model_id model, gphys_aabb* out_bounds) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, out_bounds);
        GPHYS_TRY(unwrap(scene)->check(model));
        Box box;
        if (!unwrap(scene)->bounds(model, box)) return GPHYS_UNBOUNDED;
        *out_bounds = narrow(box);
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_get_scene_bounds(const gphys_scene* scene, gphys_aabb* out_bounds) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, out_bounds);
        const Bvh8& bvh = unwrap(scene)->bvh();
        if (bvh.size() == 0) return GPHYS_NO_HIT;
        *out_bounds = narrow(bvh.bounds());
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_set_shape(gphys_scene* scene, gphys_model_id model, gphys_shape_type type, const void* shape) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        GPHYS_TRY(check_shapes(unwrap(scene)->workers(), type, shape, 0, 1));
        return unwrap(scene)->set_shape(model, type, shape);
    });
}

gphys_status gphys_scene_set_scale(gphys_scene* scene, gphys_model_id model, const gphys_vec3* scale) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, scale);
        GPHYS_TRY(check_scale("scale", *scale));
        return unwrap(scene)->set_scale(model, *scale);
    });
}

gphys_status gphys_scene_get_scale(const gphys_scene* scene, gphys_model_id model, gphys_vec3* out_scale) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, out_scale);
        GPHYS_TRY(unwrap(scene)->check(model));
        *out_scale = unwrap(scene)->scale(model);
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_set_layers(gphys_scene* scene, gphys_model_id model, uint32_t layers) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        return unwrap(scene)->set_layers(model, layers);
    });
}

gphys_status gphys_scene_set_tag(gphys_scene* scene, gphys_model_id model, uint32_t tag) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        return unwrap(scene)->set_tag(model, tag);
    });
}

gphys_status gphys_scene_set_parent(gphys_scene* scene, gphys_model_id model, gphys_model_id parent,
                                    int32_t keep_world) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        GPHYS_TRY(check_bool("keep_world", keep_world));
        return unwrap(scene)->set_parent(model, parent, keep_world != 0);
    });
}

gphys_status gphys_scene_set_transform(gphys_scene* scene, gphys_model_id model, const gphys_transform* transform) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, transform);
        GPHYS_REQUIRE_VALID(*transform);
        return unwrap(scene)->set_transforms(&model, transform, 0, 1);
    });
}

gphys_status gphys_scene_set_transforms(gphys_scene* scene, const gphys_model_id* models,
                                        const gphys_transform* transforms, uint32_t transform_stride, uint32_t count) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        if (count != 0) GPHYS_REQUIRE_POINTERS(models, transforms);
        GPHYS_TRY(check_transforms(unwrap(scene)->workers(), transforms, transform_stride, count));
        return unwrap(scene)->set_transforms(models, transforms, transform_stride, count);
    });
}

gphys_status gphys_scene_get_transforms(const gphys_scene* scene, const gphys_model_id* models, uint32_t count,
                                        gphys_transform* out_transforms, uint32_t out_stride) {
    return guarded(__func__,
                   [&] { return copy_transforms(scene, models, count, out_transforms, out_stride, &Scene::local); });
}

gphys_status gphys_scene_get_world_transforms(const gphys_scene* scene, const gphys_model_id* models, uint32_t count,
                                              gphys_transform* out_transforms, uint32_t out_stride) {
    return guarded(__func__,
                   [&] { return copy_transforms(scene, models, count, out_transforms, out_stride, &Scene::world); });
}

gphys_status gphys_scene_get_octree_stats(const gphys_scene* scene, gphys_octree_stats* out_stats) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene, out_stats);
        gphys_octree_stats stats = unwrap(scene)->bvh().stats();
        stats.unbounded_count = unwrap(scene)->unbounded_count();
        *out_stats = stats;
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_get_octree_boxes(const gphys_scene* scene, gphys_octree_box* out_boxes, uint32_t capacity,
                                          uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        return copy_boxes(unwrap(scene)->bvh(), out_boxes, capacity, out_total);
    });
}

gphys_status gphys_scene_validate(const gphys_scene* scene) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(scene);
        const char* wrong = unwrap(scene)->defect();
        return wrong ? fail(GPHYS_ERROR_INTERNAL, wrong) : GPHYS_OK;
    });
}
