// A scene under test, with the allocator hooks counted and able to fail at a chosen allocation.
#pragma once

#include <cstdlib>
#include <vector>

#include "test.h"

namespace test {

constexpr gphys_quat no_rotation{0, 0, 0, 1};

inline gphys_transform at(float x, float y, float z, float scale = 1) { return {{x, y, z}, no_rotation, scale}; }

class CountedMemory {
public:
    gphys_allocator hooks() { return {allocate, release, this}; }

    size_t live_bytes = 0, allocations = 0;
    size_t taken_bytes = 0;  // so far, given back or not
    /// The allocation, counted from 0, that fails; all later ones succeed.
    size_t failing = SIZE_MAX;

private:
    static void* allocate(void* user, size_t size, size_t alignment) {
        CountedMemory& self = *static_cast<CountedMemory*>(user);
        if (self.allocations++ == self.failing) return nullptr;
        self.live_bytes += size;
        self.taken_bytes += size;
        return ::operator new(size, std::align_val_t(alignment));
    }
    static void release(void* user, void* memory, size_t size, size_t alignment) {
        static_cast<CountedMemory*>(user)->live_bytes -= size;
        ::operator delete(memory, std::align_val_t(alignment));
    }
};

class SceneFixture {
public:
    SceneFixture() {
        const gphys_allocator hooks = memory.hooks();
        gphys_scene_desc desc;
        gphys_scene_desc_init(&desc, sizeof desc);
        desc.allocator = &hooks;
        REQUIRE(gphys_scene_create(&desc, &scene) == GPHYS_OK);
    }
    ~SceneFixture() {
        gphys_scene_destroy(scene);
        CHECK(memory.live_bytes == 0);
    }
    SceneFixture(const SceneFixture&) = delete;
    SceneFixture& operator=(const SceneFixture&) = delete;

    CountedMemory memory;
    gphys_scene* scene = nullptr;

    gphys_model_id add(gphys_shape_type type, const void* shape, const gphys_transform& transform,
                       gphys_model_id parent = 0) {
        gphys_model_desc desc;
        gphys_model_desc_init(&desc, sizeof desc);
        desc.parent = parent;
        gphys_model_id id = 0;
        REQUIRE(gphys_scene_add(scene, type, shape, &transform, &desc, &id) == GPHYS_OK);
        return id;
    }
    /// A box of edge 2.
    gphys_model_id add_box(const gphys_transform& transform, gphys_model_id parent = 0) {
        const gphys_aabb box{{-1, -1, -1}, {1, 1, 1}};
        return add(GPHYS_SHAPE_AABB, &box, transform, parent);
    }
    gphys_model_id add_sphere(float radius, const gphys_transform& transform, gphys_model_id parent = 0) {
        const gphys_sphere sphere{{0, 0, 0}, radius};
        return add(GPHYS_SHAPE_SPHERE, &sphere, transform, parent);
    }

    /// The model that a ray meets first, or 0.
    gphys_model_id first_on_ray(gphys_vec3 origin, gphys_vec3 direction) const {
        const gphys_ray ray{origin, direction, INFINITY};
        gphys_hit hit;
        return gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK ? hit.model : 0;
    }
    std::vector<gphys_model_id> in_sphere(gphys_vec3 center, float radius) const {
        const gphys_sphere sphere{center, radius};
        std::vector<gphys_model_id> found(10000);
        uint32_t total = 0;
        REQUIRE(gphys_scene_overlap(scene, GPHYS_SHAPE_SPHERE, &sphere, GPHYS_ALL_LAYERS, found.data(), 10000,
                                    &total) == GPHYS_OK);
        found.resize(total);
        return found;
    }
    gphys_transform world(gphys_model_id model) const {
        gphys_transform transform{};
        REQUIRE(gphys_scene_get_world_transforms(scene, &model, 1, &transform, sizeof transform) == GPHYS_OK);
        return transform;
    }
    gphys_transform local(gphys_model_id model) const {
        gphys_transform transform{};
        REQUIRE(gphys_scene_get_transforms(scene, &model, 1, &transform, sizeof transform) == GPHYS_OK);
        return transform;
    }
    gphys_status move(gphys_model_id model, const gphys_transform& transform) {
        return gphys_scene_set_transform(scene, model, &transform);
    }
    bool sound() const { return gphys_scene_validate(scene) == GPHYS_OK; }
};

}  // namespace test
