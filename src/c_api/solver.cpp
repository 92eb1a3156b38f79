// gphys_solver_*: the solver, its bodies, the step, contacts and statistics. Particles and constraints of a body are in
// solver_state.cpp, settings in solver_settings.cpp.
#include "solver/solver.h"

#include <cstddef>

#include "c_api/api.h"
#include "c_api/handles.h"
#include "c_api/lists.h"
#include "c_api/mesh_desc.h"
#include "c_api/solver_settings.h"
#include "mesh/mesh.h"

using namespace gphys;

namespace {

constexpr size_t solver_desc_size = offsetof(gphys_solver_desc, task_runner);  // of release 1.0
constexpr size_t body_desc_size = offsetof(gphys_body_desc, static_friction);  // of release 1.0

constexpr uint32_t most_particles = (1u << 24) - 1;  // as many as constraints

constexpr gphys_solver_desc default_solver_desc{
    sizeof(gphys_solver_desc), nullptr, {0, -9.81f, 0}, 8, 1.0f / 60, 8, nullptr, 0, 0, 0.01f, 0.5f, 0, 0, 64, 0};
constexpr gphys_body_desc default_body_desc{sizeof(gphys_body_desc),
                                            1,
                                            0.01f,
                                            0,
                                            0.5f,
                                            0,
                                            0,
                                            0.001f,
                                            GPHYS_CLOTH_SHEAR | GPHYS_CLOTH_BEND,
                                            0xffffffff,
                                            0,
                                            0,
                                            0,
                                            0,
                                            0,
                                            0};

gphys_status read_body_desc(const gphys_body_desc* from, gphys_body_desc& desc) {
    desc = default_body_desc;
    GPHYS_TRY(read_desc(from, desc, body_desc_size));
    GPHYS_REQUIRE_IN_RANGE(is_amount(desc.mass) && desc.mass > 0, "desc.mass", desc.mass, positive_range);
    GPHYS_TRY(check_amount("desc.radius", desc.radius));
    BodySettings ignored;
    GPHYS_TRY(read_settings(gphys_body_settings{desc.damping, desc.friction, desc.static_friction, desc.restitution,
                                                desc.layers, desc.body_layers, desc.self_collision},
                            ignored));
    GPHYS_TRY(check_amount("desc.compliance", desc.compliance));
    GPHYS_TRY(check_amount("desc.bend_compliance", desc.bend_compliance));
    GPHYS_TRY(check_amount("desc.shear_compliance", desc.shear_compliance));
    GPHYS_TRY(check_amount("desc.breaking_force", desc.breaking_force));
    GPHYS_TRY(check_amount("desc.bending_stiffness", desc.bending_stiffness));
    GPHYS_REQUIRE_IN_RANGE((desc.cloth_flags & ~uint32_t{GPHYS_CLOTH_SHEAR | GPHYS_CLOTH_BEND}) == 0,
                           "desc.cloth_flags", desc.cloth_flags,
                           "a combination of GPHYS_CLOTH_SHEAR and GPHYS_CLOTH_BEND");
    return GPHYS_OK;
}

/// `name` is the parameter, or the product of parameters, that determines the number of particles.
gphys_status check_count(const char* name, uint64_t count, uint32_t least, const char* range) {
    const double value = static_cast<double>(count);
    GPHYS_REQUIRE_IN_RANGE(count >= least, name, value, range);
    if (count > most_particles) return fail(GPHYS_ERROR_CAPACITY, name, value, "at most 2^24 - 1");
    return GPHYS_OK;
}

gphys_status check_positions(const gphys_vec3* positions, uint32_t stride, uint32_t count) {
    GPHYS_REQUIRE_POINTERS(positions);
    GPHYS_TRY(check_position_stride("position_stride", stride, count));
    const Strided<gphys_vec3> position(positions, stride);
    for (uint32_t i = 0; i < count; ++i) GPHYS_TRY(check_element("positions", i, position[i]));
    return GPHYS_OK;
}

/// Below 1 after rounding to float too.
float leftover(const Solver& solver) { return std::min(static_cast<float>(solver.leftover()), std::nextafterf(1, 0)); }

/// A corner of a sheet or a vertex of a mesh, in world space.
gphys_status check_placed(Vec3 position) {
    GPHYS_REQUIRE(max_component(abs(position)) <= GPHYS_MAX_COORDINATE,
                  "the cloth: a coordinate of a particle would be beyond 1e15");
    return GPHYS_OK;
}

}  // namespace

gphys_status gphys_solver_desc_init(gphys_solver_desc* desc, uint32_t size) {
    return guarded(__func__, [&] { return write_desc(desc, size, default_solver_desc, solver_desc_size); });
}

gphys_status gphys_body_desc_init(gphys_body_desc* desc, uint32_t size) {
    return guarded(__func__, [&] { return write_desc(desc, size, default_body_desc, body_desc_size); });
}

gphys_status gphys_solver_create(const gphys_solver_desc* desc, gphys_solver** out_solver) {
    return guarded(__func__, [&]() -> gphys_status {
        gphys_solver_desc settings = default_solver_desc;
        GPHYS_TRY(read_desc(desc, settings, solver_desc_size));
        GPHYS_TRY(check_allocator(settings.allocator));
        SolverSettings in;
        GPHYS_TRY(read_settings(
            gphys_solver_settings{settings.gravity, settings.substeps, settings.fixed_step, settings.max_steps,
                                  settings.sleep_speed, settings.sleep_strain, settings.sleep_time, settings.max_strain,
                                  settings.tolerance, settings.max_substeps, settings.max_work},
            in));
        GPHYS_TRY(check_task_runner(settings.task_runner));
        GPHYS_TRY(check_worker_count("desc.worker_count", settings.worker_count));
        GPHYS_REQUIRE_POINTERS(out_solver);
        *out_solver = wrap(create<Solver>(settings.allocator, in, settings.worker_count, settings.task_runner));
        return GPHYS_OK;
    });
}

void gphys_solver_destroy(gphys_solver* solver) {
    guarded(__func__, [&] { destroy(unwrap(solver)); });
}

gphys_status gphys_solver_set_origin(gphys_solver* solver, const double origin[3]) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver, origin);
        GPHYS_TRY(check_origin(origin));
        GPHYS_REQUIRE(unwrap(solver)->set_origin({origin[0], origin[1], origin[2]}),
                      "origin: a coordinate of a particle would be beyond 1e15");
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_origin(const gphys_solver* solver, double out_origin[3]) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver, out_origin);
        write_origin(unwrap(solver)->origin(), out_origin);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_set_gravity(gphys_solver* solver, const gphys_vec3* gravity) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        GPHYS_REQUIRE_INPUT(gravity);
        unwrap(solver)->set_gravity(widen(*gravity));
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_set_substeps(gphys_solver* solver, uint32_t substeps) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        GPHYS_TRY(check_substeps("substeps", substeps));
        unwrap(solver)->set_substeps(substeps);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_add_particles(gphys_solver* solver, const gphys_body_desc* desc, const gphys_vec3* positions,
                                        uint32_t position_stride, uint32_t count, gphys_body_id* out_body) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        gphys_body_desc settings;
        GPHYS_TRY(read_body_desc(desc, settings));
        GPHYS_TRY(check_count("count", count, 1, "at least 1"));
        GPHYS_TRY(check_positions(positions, position_stride, count));
        GPHYS_REQUIRE_POINTERS(out_body);
        return unwrap(solver)->add_particles(settings, positions, position_stride, count, *out_body);
    });
}

gphys_status gphys_solver_add_rope(gphys_solver* solver, const gphys_body_desc* desc, const gphys_vec3* positions,
                                   uint32_t position_stride, uint32_t count, float link_length,
                                   gphys_body_id* out_body) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        gphys_body_desc settings;
        GPHYS_TRY(read_body_desc(desc, settings));
        GPHYS_TRY(check_count("count", count, 2, "at least 2"));
        GPHYS_TRY(check_positions(positions, position_stride, count));
        GPHYS_TRY(check_amount("link_length", link_length));
        GPHYS_REQUIRE_POINTERS(out_body);
        return unwrap(solver)->add_rope(settings, positions, position_stride, count, link_length, *out_body);
    });
}

gphys_status gphys_solver_add_cloth(gphys_solver* solver, const gphys_body_desc* desc, const gphys_vec3* corner,
                                    const gphys_vec3* edge_u, const gphys_vec3* edge_v, uint32_t columns, uint32_t rows,
                                    gphys_body_id* out_body) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        gphys_body_desc settings;
        GPHYS_TRY(read_body_desc(desc, settings));
        GPHYS_REQUIRE_POINTERS(corner, edge_u, edge_v);
        GPHYS_REQUIRE_VALID(*corner);
        GPHYS_REQUIRE_VALID(*edge_u);
        GPHYS_REQUIRE_VALID(*edge_v);
        GPHYS_REQUIRE_IN_RANGE(columns >= 2, "columns", columns, "at least 2");
        GPHYS_REQUIRE_IN_RANGE(rows >= 2, "rows", rows, "at least 2");
        GPHYS_TRY(check_count("columns * rows", uint64_t{columns} * rows, 4, "at least 4"));
        const Vec3 c = widen(*corner), u = widen(*edge_u), v = widen(*edge_v);
        // Products of floats are exact in double, so this is 0 for parallel edges and for no others.
        GPHYS_REQUIRE(cross(u, v) != Vec3{}, "edge_u, edge_v: the cloth has no area");
        GPHYS_TRY(check_placed(c + u));
        GPHYS_TRY(check_placed(c + v));
        GPHYS_TRY(check_placed(c + u + v));
        GPHYS_REQUIRE_POINTERS(out_body);
        return unwrap(solver)->add_cloth(settings, c, u, v, columns, rows, *out_body);
    });
}

gphys_status gphys_solver_add_cloth_mesh(gphys_solver* solver, const gphys_body_desc* desc, const gphys_mesh* mesh,
                                         const gphys_transform* transform, gphys_body_id* out_body) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        gphys_body_desc settings;
        GPHYS_TRY(read_body_desc(desc, settings));
        GPHYS_REQUIRE_POINTERS(mesh);
        if (transform) GPHYS_REQUIRE_VALID(*transform);
        const Transform placement = transform ? widen(*transform) : Transform{};
        const Mesh& source = *unwrap(mesh);
        if (source.kind() == MeshKind::body_links) {
            return fail(GPHYS_ERROR_UNSUPPORTED, "mesh: it has links instead of triangles");
        }
        GPHYS_TRY(check_count("mesh: vertex count", source.vertices().size(), 1, "at least 1"));
        for (const gphys_vec3& vertex : source.vertices()) GPHYS_TRY(check_placed(placement.apply(widen(vertex))));
        GPHYS_REQUIRE_POINTERS(out_body);
        return unwrap(solver)->add_cloth_mesh(settings, source, placement, *out_body);
    });
}

gphys_status gphys_solver_remove_body(gphys_solver* solver, gphys_body_id body) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        return unwrap(solver)->remove(body);
    });
}

gphys_status gphys_solver_get_bodies(const gphys_solver* solver, gphys_body_id* out_bodies, uint32_t capacity,
                                     uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        return list_smallest("out_bodies", out_bodies, capacity, out_total,
                             [&](auto& bodies) { unwrap(solver)->list(bodies); });
    });
}

gphys_status gphys_solver_get_sleeping(const gphys_solver* solver, gphys_body_id* out_bodies, uint32_t capacity,
                                       uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        return list_smallest("out_bodies", out_bodies, capacity, out_total,
                             [&](auto& bodies) { unwrap(solver)->list_sleeping(bodies); });
    });
}

gphys_status gphys_solver_wake(gphys_solver* solver, gphys_body_id body) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        if (body == 0) {
            unwrap(solver)->wake_all();
            return GPHYS_OK;
        }
        GPHYS_TRY(unwrap(solver)->check(body));
        unwrap(solver)->edit(body);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_body_info(const gphys_solver* solver, gphys_body_id body, gphys_body_info* out_info) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE_POINTERS(out_info);
        const Body& b = unwrap(solver)->body(body);
        const gphys_solve_method method = b.plan.chains_current ? b.plan.method : method_of(b);
        *out_info = {b.kind, method, b.particles.size(), b.constraints.ids.size(),
                     static_cast<uint32_t>(b.cloth.sheet.triangles.size() / 3)};
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_substeps(const gphys_solver* solver, gphys_body_id body, uint32_t* out_substeps) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE_POINTERS(out_substeps);
        *out_substeps = unwrap(solver)->body(body).substeps.made;
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_triangles(const gphys_solver* solver, gphys_body_id body, uint32_t* out_indices,
                                        uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        return list_copy(unwrap(solver)->body(body).cloth.sheet.triangles, "out_indices", out_indices, capacity,
                         out_total);
    });
}

gphys_status gphys_mesh_create_from_body(const gphys_mesh_desc* desc, gphys_solver* solver, gphys_body_id body,
                                         gphys_mesh** out_mesh) {
    return guarded(__func__, [&]() -> gphys_status {
        gphys_mesh_desc settings{};
        GPHYS_TRY(read_mesh_desc(desc, settings));
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE_POINTERS(out_mesh);
        *out_mesh = wrap(unwrap(solver)->make_mesh(settings.allocator, body));
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_nearest_particle(const gphys_solver* solver, gphys_body_id body, uint32_t triangle,
                                               const gphys_vec3* point, uint32_t* out_particle) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE_INPUT(point);
        GPHYS_REQUIRE_POINTERS(out_particle);
        uint32_t nearest = 0;
        GPHYS_REQUIRE(nearest_particle(unwrap(solver)->body(body), triangle, widen(*point), nearest),
                      "triangle: the mesh of the body has none of that index");
        *out_particle = nearest;
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_step(gphys_solver* solver, const gphys_scene* scene, float dt) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        GPHYS_TRY(check_step("dt", dt));
        if (scene) GPHYS_TRY(check_origins(solver, scene));
        unwrap(solver)->step(unwrap(scene), dt);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_advance(gphys_solver* solver, const gphys_scene* scene, float frame_time, uint32_t* out_steps,
                                  float* out_leftover) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        GPHYS_TRY(check_amount("frame_time", frame_time));
        if (scene) GPHYS_TRY(check_origins(solver, scene));
        uint32_t steps = 0;
        unwrap(solver)->advance(unwrap(scene), frame_time, steps);
        if (out_steps) *out_steps = steps;
        if (out_leftover) *out_leftover = leftover(*unwrap(solver));
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_set_worker_count(gphys_solver* solver, uint32_t workers) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        GPHYS_TRY(check_worker_count("workers", workers));
        unwrap(solver)->set_worker_count(workers);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_worker_count(const gphys_solver* solver, uint32_t* out_workers) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver, out_workers);
        *out_workers = unwrap(solver)->worker_count();
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_leftover(const gphys_solver* solver, float* out_leftover) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver, out_leftover);
        *out_leftover = leftover(*unwrap(solver));
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_hash(const gphys_solver* solver, uint32_t out_hash[2]) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver, out_hash);
        uint32_t hash[2];
        unwrap(solver)->hash(hash);
        std::memcpy(out_hash, hash, sizeof hash);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_snapshot(const gphys_solver* solver, uint32_t* out_words, uint32_t capacity,
                                       uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        GPHYS_TRY(check_list("out_words", out_words, capacity, out_total));
        return unwrap(solver)->snapshot(out_words, capacity, *out_total);
    });
}

gphys_status gphys_solver_restore(gphys_solver* solver, const uint32_t* words, uint32_t count) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver, words);
        return unwrap(solver)->restore(words, count);
    });
}

gphys_status gphys_solver_get_stats(const gphys_solver* solver, gphys_body_id body, gphys_solver_stats* out_stats) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        if (body != 0) GPHYS_TRY(unwrap(solver)->check(body));
        GPHYS_REQUIRE_POINTERS(out_stats);
        *out_stats = unwrap(solver)->stats(body);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_contacts(const gphys_solver* solver, gphys_contact* out_contacts, uint32_t capacity,
                                       uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        return list_smallest<ContactOrder>("out_contacts", out_contacts, capacity, out_total,
                                           [&](auto& contacts) { unwrap(solver)->contacts(contacts); });
    });
}

gphys_status gphys_solver_get_body_contacts(const gphys_solver* solver, gphys_body_contact* out_contacts,
                                            uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        return list_smallest<BodyContactOrder>("out_contacts", out_contacts, capacity, out_total,
                                               [&](auto& contacts) { unwrap(solver)->body_contacts(contacts); });
    });
}

gphys_status gphys_solver_get_impulses(const gphys_solver* solver, gphys_impulse* out_impulses, uint32_t capacity,
                                       uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        return list_smallest<ImpulseOrder>("out_impulses", out_impulses, capacity, out_total,
                                           [&](auto& impulses) { unwrap(solver)->impulses(impulses); });
    });
}
