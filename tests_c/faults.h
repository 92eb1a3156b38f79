/* Memory that runs out. A session makes, changes, steps and asks objects; it is run once undisturbed, and then again
 * and again, each time with another of its allocations failing, alone or (every fifth) with all that come after it. The
 * call that meets the failure says so or does without; if it says so, everything is as it was before, and after memory
 * is back the session goes on to the same end. Nothing is left behind. */
#ifndef FAULTS_H
#define FAULTS_H

#include "test.h"

#include <stdio.h>
#include <stdlib.h>

#define MOST_CALLS 512
#define FRAME (1 / 60.0f)

/* Allocator hooks: `failing` is the number of the allocation that fails, -1 for none. */
typedef struct {
    long calls, failing, refused, blocks;
    int all_after;
} heap;

static inline void* take(void* user, size_t size, size_t alignment) {
    heap* h = user;
    char *block, *place;
    const long call = h->calls++;
    if (h->failing >= 0 && (call == h->failing || (h->all_after && call > h->failing))) {
        ++h->refused;
        return NULL;
    }
    block = malloc(size + alignment + sizeof block);
    if (!block) abort();
    place = block + sizeof block;
    place += (alignment - (uintptr_t)place % alignment) % alignment;
    memcpy(place - sizeof block, &block, sizeof block);
    ++h->blocks;
    return place;
}

static inline void give_back(void* user, void* memory, size_t size, size_t alignment) {
    heap* h = user;
    char* block;
    (void)size;
    (void)alignment;
    memcpy(&block, (char*)memory - sizeof block, sizeof block);
    free(block);
    --h->blocks;
}

typedef struct {
    heap heap;
    gphys_allocator hooks;
    gphys_mesh* mesh;
    gphys_scene* scene;
    gphys_camera* camera;
    gphys_solver* solver;
    gphys_model_id models[64];
    int calls;
    int undisturbed; /* then digests are noted, otherwise they are what they should be */
    uint64_t digests[MOST_CALLS];
} session;

static inline void mix(uint64_t* digest, const void* from, size_t size) {
    const unsigned char* bytes = from;
    size_t i;
    for (i = 0; i < size; ++i) *digest = (*digest ^ bytes[i]) * 1099511628211u;
}

static inline void mix_scene(uint64_t* digest, const gphys_scene* scene) {
    gphys_model_id models[1024];
    gphys_hit hits[16];
    const gphys_ray rays[2] = {{{-20, 0.5f, 0.2f}, {1, 0, 0}, 100}, {{0.3f, 20, 0.1f}, {0, -1, 0.01f}, 100}};
    double origin[3];
    uint32_t total = 0, i;
    assert_int_equal(gphys_scene_validate(scene), GPHYS_OK);
    assert_int_equal(gphys_scene_get_models(scene, models, 1024, &total), GPHYS_OK);
    mix(digest, models, total * sizeof *models);
    for (i = 0; i < total; ++i) {
        gphys_model_info info;
        gphys_transform transform;
        gphys_aabb box;
        assert_int_equal(gphys_scene_get_info(scene, models[i], &info), GPHYS_OK);
        mix(digest, &info, sizeof info);
        assert_int_equal(gphys_scene_get_transforms(scene, &models[i], 1, &transform, sizeof transform), GPHYS_OK);
        mix(digest, &transform, sizeof transform);
        assert_int_equal(gphys_scene_get_world_transforms(scene, &models[i], 1, &transform, sizeof transform),
                         GPHYS_OK);
        mix(digest, &transform, sizeof transform);
        if (gphys_scene_get_bounds(scene, models[i], &box) == GPHYS_OK) mix(digest, &box, sizeof box);
    }
    for (i = 0; i < 2; ++i) {
        gphys_scene_raycast_all(scene, &rays[i], GPHYS_ALL_LAYERS, hits, 16, &total);
        mix(digest, hits, (total < 16 ? total : 16) * sizeof *hits);
    }
    gphys_scene_get_origin(scene, origin);
    mix(digest, origin, sizeof origin);
}

static inline void mix_solver(uint64_t* digest, const gphys_solver* solver) {
    uint32_t hash[2], total = 0;
    gphys_body_id sleeping[16];
    gphys_joint_info joints[16];
    gphys_impulse impulses[16];
    gphys_contact contacts[16];
    gphys_body_contact touches[16];
    assert_int_equal(gphys_solver_get_hash(solver, hash), GPHYS_OK);
    mix(digest, hash, sizeof hash);
    assert_int_equal(gphys_solver_get_sleeping(solver, sleeping, 16, &total), GPHYS_OK);
    mix(digest, sleeping, total * sizeof *sleeping);
    assert_int_equal(gphys_solver_get_joints(solver, 0, joints, 16, &total), GPHYS_OK);
    mix(digest, joints, total * sizeof *joints);
    gphys_solver_get_impulses(solver, impulses, 16, &total);
    mix(digest, impulses, (total < 16 ? total : 16) * sizeof *impulses);
    gphys_solver_get_contacts(solver, contacts, 16, &total);
    mix(digest, contacts, (total < 16 ? total : 16) * sizeof *contacts);
    mix(digest, &total, sizeof total);
    gphys_solver_get_body_contacts(solver, touches, 16, &total);
    mix(digest, touches, (total < 16 ? total : 16) * sizeof *touches);
    mix(digest, &total, sizeof total);
}

/* All that can be seen of the objects that there are. */
static inline uint64_t digest_of(const session* s) {
    uint64_t digest = 14695981039346656037u;
    if (s->mesh) {
        gphys_mesh_report report;
        assert_int_equal(gphys_mesh_get_report(s->mesh, &report), GPHYS_OK);
        mix(&digest, &report, sizeof report);
    }
    if (s->scene) mix_scene(&digest, s->scene);
    if (s->camera) {
        gphys_mat4 matrix;
        assert_int_equal(gphys_camera_get_view_projection_matrix(s->camera, &matrix), GPHYS_OK);
        mix(&digest, &matrix, sizeof matrix);
    }
    if (s->solver) mix_solver(&digest, s->solver);
    return digest;
}

/* Whether the call is to be made again: it has said that memory ran out, and everything is as it was. */
static inline int ran_out(session* s, gphys_status status) {
    if (status != GPHYS_ERROR_OUT_OF_MEMORY) return 0;
    assert_true(s->heap.refused > 0);
    assert_true(digest_of(s) == s->digests[s->calls]);
    s->heap.failing = -1;
    return 1;
}

/* `before`: the allocations when the call began. With GPHYS_PRINT_ALLOCATING in the environment, prints each call that
 * allocates, for tests_package/allocations.sh. */
static inline void note(session* s, const char* call, long before, gphys_status status) {
    assert_int_equal(status, GPHYS_OK);
    if (s->undisturbed && s->heap.calls > before && getenv("GPHYS_PRINT_ALLOCATING")) printf("allocates: %s\n", call);
    ++s->calls;
    assert_true(s->calls < MOST_CALLS);
    if (s->undisturbed) s->digests[s->calls] = digest_of(s);
}

#define DO(call)                                   \
    do {                                           \
        const long before_ = s->heap.calls;        \
        gphys_status status_ = (call);             \
        if (ran_out(s, status_)) status_ = (call); \
        note(s, #call, before_, status_);          \
    } while (0)

/* Runs it with every allocation failing in turn, or with each nth that GPHYS_FAULTS_EVERY in the environment asks for.
 */
static inline void with_all_failing(void (*run)(session*)) {
    const char* setting = getenv("GPHYS_FAULTS_EVERY");
    const long every = setting ? strtol(setting, NULL, 10) : 1;
    static session s;
    uint64_t end = 0;
    long total = -1, failing;
    int all_after;
    for (all_after = 0; all_after < 2; ++all_after) {
        for (failing = -1; failing < total || total < 0; failing += all_after ? 5 * every : every) {
            memset(&s, 0, offsetof(session, digests));
            s.undisturbed = total < 0;
            s.heap.failing = failing;
            s.heap.all_after = all_after;
            s.hooks.allocate = take;
            s.hooks.release = give_back;
            s.hooks.user = &s.heap;
            if (s.undisturbed) s.digests[0] = digest_of(&s);
            run(&s);
            if (s.undisturbed) {
                end = digest_of(&s);
                total = s.heap.calls;
            }
            assert_true(digest_of(&s) == end);
            assert_true(failing < 0 || s.heap.refused > 0);
            gphys_solver_destroy(s.solver);
            gphys_camera_destroy(s.camera);
            gphys_scene_destroy(s.scene);
            gphys_mesh_destroy(s.mesh);
            assert_int_equal(s.heap.blocks, 0);
        }
    }
    assert_true(total > 3);
}

/* A bumpy square of 2 * 8 * 8 triangles. */
static inline gphys_status make_mesh(session* s) {
    float vertices[9 * 9 * 3];
    uint32_t indices[6 * 8 * 8], i, j, n = 0;
    gphys_mesh_desc desc;
    for (i = 0; i < 9; ++i) {
        for (j = 0; j < 9; ++j) {
            float* v = &vertices[3 * (9 * i + j)];
            v[0] = (float)i / 4 - 1;
            v[1] = 0.05f * (float)((i * 7 + j * 3) % 5);
            v[2] = (float)j / 4 - 1;
        }
    }
    for (i = 0; i < 8; ++i) {
        for (j = 0; j < 8; ++j) {
            const uint32_t a = 9 * i + j, b = a + 1, c = a + 9, d = c + 1;
            indices[n++] = a, indices[n++] = b, indices[n++] = c;
            indices[n++] = c, indices[n++] = b, indices[n++] = d;
        }
    }
    gphys_mesh_desc_init(&desc, sizeof desc);
    desc.allocator = &s->hooks;
    desc.deformable = 1;
    return gphys_mesh_create(&desc, vertices, 12, 81, indices, n, &s->mesh);
}

static inline gphys_status make_scene(session* s, uint32_t workers) {
    gphys_scene_desc desc;
    gphys_scene_desc_init(&desc, sizeof desc);
    desc.allocator = &s->hooks;
    desc.worker_count = workers;
    return gphys_scene_create(&desc, &s->scene);
}

static inline gphys_status make_solver(session* s, uint32_t workers) {
    gphys_solver_desc desc;
    gphys_solver_desc_init(&desc, sizeof desc);
    desc.allocator = &s->hooks;
    desc.worker_count = workers;
    desc.sleep_speed = 0.05f;
    desc.sleep_strain = 0.5f;
    desc.sleep_time = 0.1f;
    return gphys_solver_create(&desc, &s->solver);
}

static inline gphys_transform at(float x, float y, float z) {
    gphys_transform t = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    t.position.x = x, t.position.y = y, t.position.z = z;
    return t;
}

#endif
