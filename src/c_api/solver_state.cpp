// gphys_solver_*: getters and setters of the particles, constraints and joints of a body.
#include "c_api/api.h"
#include "c_api/handles.h"
#include "c_api/lists.h"
#include "c_api/solver_settings.h"
#include "foundation/strided.h"
#include "solver/contact/friction.h"
#include "solver/solver.h"
#include "solver/state.h"

using namespace gphys;

namespace {

gphys_status check_range(const gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count) {
    GPHYS_TRY(check_body(solver, body));
    const uint32_t size = unwrap(solver)->body(body).particles.size();
    GPHYS_REQUIRE_IN_RANGE(first <= size && count <= size - first, "first + count", double(first) + count,
                           "at most the particle count of the body");
    return GPHYS_OK;
}

gphys_status check_particle(const gphys_solver* solver, gphys_body_id body, uint32_t particle) {
    GPHYS_TRY(check_body(solver, body));
    GPHYS_REQUIRE_IN_RANGE(particle < unwrap(solver)->body(body).particles.size(), "particle", particle,
                           "below the particle count of the body");
    return GPHYS_OK;
}

/// A setter checks the range and all elements of its array before it uses any. defect_of(element).
template <class T, class DefectOf>
gphys_status check_each(const gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                        const char* name, const T* elements, uint32_t stride, DefectOf&& defect_of) {
    GPHYS_TRY(check_range(solver, body, first, count));
    if (count != 0) GPHYS_TRY(check_pointers(name, elements));
    GPHYS_TRY(check_stride("stride", stride, sizeof(T), count));
    const Strided<T> element(elements, stride);
    for (uint32_t i = 0; i < count; ++i) {
        const Defect wrong = defect_of(element[i]);
        if (wrong) return fail(GPHYS_ERROR_INVALID_ARGUMENT, name, i, wrong);
    }
    return GPHYS_OK;
}

Defect defect_of_vector(const gphys_vec3& value) { return defect(value); }
Defect defect_of_mass(float value) {
    return value > 0 && value <= GPHYS_MAX_COORDINATE ? Defect{} : Defect{"", 0, value, positive_range};
}
/// A radius or a friction factor.
Defect defect_of_amount(float value) { return is_amount(value) ? Defect{} : Defect{"", 0, value, amount_range}; }

constexpr char distance_range[] = "from 0 to 1e15 or INFINITY";
Defect defect_of_target(const gphys_animation_target& target) {
    const auto is_distance = [](float value) { return is_amount(value) || value == INFINITY; };
    if (Defect wrong = defect(target.position)) return wrong.field = ".position", wrong;
    if (!is_distance(target.max_distance)) return {".max_distance", 0, target.max_distance, distance_range};
    if (!is_distance(target.backstop)) return {".backstop", 0, target.backstop, distance_range};
    if (target.backstop == INFINITY) return {};
    if (Defect wrong = defect(target.normal)) return wrong.field = ".normal", wrong;
    return widen(target.normal) == Vec3{} ? Defect{".normal: length", 0, 0, "above 0"} : Defect{};
}

/// A getter of a range of particles: value_of(body, i) for each.
template <class T, class ValueOf>
gphys_status get_each(const gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                      const char* out_name, T* out, uint32_t stride, const ValueOf& value_of) {
    GPHYS_TRY(check_range(solver, body, first, count));
    GPHYS_TRY(check_outputs(out_name, out, stride, count));
    const Body& from = unwrap(solver)->body(body);
    const StridedOut<T> to(out, stride);
    for (uint32_t i = 0; i < count; ++i) to[i] = value_of(from, first + i);
    return GPHYS_OK;
}

}  // namespace

gphys_status gphys_solver_get_positions(const gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                        gphys_vec3* out_positions, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return get_each(solver, body, first, count, "out_positions", out_positions, out_stride,
                        [](const Body& from, uint32_t i) { return narrow(from.particles.position[i]); });
    });
}

gphys_status gphys_solver_set_positions(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                        const gphys_vec3* positions, uint32_t stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_range(solver, body, first, count));
        GPHYS_TRY(check_position_stride("stride", stride, count));
        GPHYS_TRY(check_each(solver, body, first, count, "positions", positions, stride, defect_of_vector));
        set_positions(unwrap(solver)->edit(body), first, count, positions, stride);
        unwrap(solver)->update_mesh(body);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_velocities(const gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                         gphys_vec3* out_velocities, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return get_each(solver, body, first, count, "out_velocities", out_velocities, out_stride,
                        [](const Body& from, uint32_t i) { return narrow(from.particles.velocity[i]); });
    });
}

gphys_status gphys_solver_set_velocities(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                         const gphys_vec3* velocities, uint32_t stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_each(solver, body, first, count, "velocities", velocities, stride, defect_of_vector));
        set_velocities(unwrap(solver)->edit(body), first, count, velocities, stride);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_masses(const gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                     float* out_masses, uint32_t out_stride) {
    return guarded(__func__, [&] {
        // A mass that was divided among many particles may be below the smallest float. It is not reported as 0.
        return get_each(
            solver, body, first, count, "out_masses", out_masses, out_stride, [](const Body& from, uint32_t i) {
                return std::max(static_cast<float>(from.particles.mass[i]), std::numeric_limits<float>::denorm_min());
            });
    });
}

gphys_status gphys_solver_set_masses(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                     const float* masses, uint32_t stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_each(solver, body, first, count, "masses", masses, stride, defect_of_mass));
        set_masses(unwrap(solver)->edit(body), first, count, masses, stride);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_radii(const gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                    float* out_radii, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return get_each(solver, body, first, count, "out_radii", out_radii, out_stride,
                        [](const Body& from, uint32_t i) { return static_cast<float>(from.particles.radius[i]); });
    });
}

gphys_status gphys_solver_set_radii(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                    const float* radii, uint32_t stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_each(solver, body, first, count, "radii", radii, stride, defect_of_amount));
        set_radii(unwrap(solver)->edit(body), first, count, radii, stride);
        unwrap(solver)->update_mesh(body);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_friction_factors(const gphys_solver* solver, gphys_body_id body, uint32_t first,
                                               uint32_t count, float* out_factors, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return get_each(solver, body, first, count, "out_factors", out_factors, out_stride,
                        [](const Body& from, uint32_t i) { return static_cast<float>(friction_factor(from, i)); });
    });
}

gphys_status gphys_solver_set_friction_factors(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                               const float* factors, uint32_t stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_each(solver, body, first, count, "factors", factors, stride, defect_of_amount));
        set_friction_factors(unwrap(solver)->body(body), first, count, factors, stride);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_forces(const gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                     gphys_vec3* out_forces, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return get_each(solver, body, first, count, "out_forces", out_forces, out_stride,
                        [](const Body& from, uint32_t i) { return narrow(from.particles.force[i]); });
    });
}

gphys_status gphys_solver_set_forces(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                     const gphys_vec3* forces, uint32_t stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_each(solver, body, first, count, "forces", forces, stride, defect_of_vector));
        set_forces(unwrap(solver)->edit(body), first, count, forces, stride);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_set_air_velocities(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                             const gphys_vec3* velocities, uint32_t stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_each(solver, body, first, count, "velocities", velocities, stride, defect_of_vector));
        set_air_velocities(unwrap(solver)->body(body), first, count, velocities, stride);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_air_velocities(const gphys_solver* solver, gphys_body_id body, uint32_t first,
                                             uint32_t count, gphys_vec3* out_velocities, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return get_each(solver, body, first, count, "out_velocities", out_velocities, out_stride,
                        [](const Body& from, uint32_t i) {
                            const Vector<Vec3>& velocity = from.air.velocity;
                            return velocity.empty() ? gphys_vec3{0, 0, 0} : narrow(velocity[i]);
                        });
    });
}

gphys_status gphys_solver_set_animation_targets(gphys_solver* solver, gphys_body_id body, uint32_t first,
                                                uint32_t count, const gphys_animation_target* targets,
                                                uint32_t stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_each(solver, body, first, count, "targets", targets, stride, defect_of_target));
        set_animation_targets(unwrap(solver)->body(body), first, count, targets, stride);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_animation_targets(const gphys_solver* solver, gphys_body_id body, uint32_t first,
                                                uint32_t count, gphys_animation_target* out_targets,
                                                uint32_t out_stride) {
    return guarded(__func__, [&] {
        return get_each(solver, body, first, count, "out_targets", out_targets, out_stride,
                        [](const Body& from, uint32_t i) { return animation_target(from, i); });
    });
}

gphys_status gphys_solver_get_pinned(const gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                     int32_t* out_pinned, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return get_each(solver, body, first, count, "out_pinned", out_pinned, out_stride,
                        [](const Body& from, uint32_t i) { return int32_t{from.particles.pinned(i)}; });
    });
}

gphys_status gphys_solver_set_pinned(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                     int32_t pinned) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_range(solver, body, first, count));
        GPHYS_TRY(check_bool("pinned", pinned));
        set_pinned(unwrap(solver)->edit(body), first, count, pinned != 0);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_attach(gphys_solver* solver, const gphys_scene* scene, gphys_body_id body, uint32_t particle,
                                 gphys_model_id model, const gphys_vec3* local_point) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_particle(solver, body, particle));
        GPHYS_REQUIRE_POINTERS(scene);
        GPHYS_TRY(check_origins(solver, scene));
        GPHYS_TRY(unwrap(scene)->check(model));
        if (local_point) GPHYS_REQUIRE_VALID(*local_point);
        Body& b = unwrap(solver)->body(body);
        const Vec3 local = local_point
                               ? widen(*local_point)
                               : unwrap(scene)->world_transform(model).inverse_apply(b.particles.position[particle]);
        attach(b, particle, model, local);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_detach(gphys_solver* solver, gphys_body_id body, uint32_t particle) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_particle(solver, body, particle));
        GPHYS_REQUIRE_IN_RANGE(is_attached(unwrap(solver)->body(body).constraints, particle), "particle", particle,
                               "attached");
        set_pinned(unwrap(solver)->edit(body), particle, 1, false);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_attachments(const gphys_solver* solver, gphys_body_id body,
                                          gphys_attachment* out_attachments, uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_TRY(check_list("out_attachments", out_attachments, capacity, out_total));
        uint32_t total = 0;
        for (const Attachment& from : unwrap(solver)->body(body).constraints.attachments) {
            if (from.model == 0) continue;
            if (total < capacity) out_attachments[total] = {from.particle, from.model, narrow(from.local)};
            ++total;
        }
        return listed(total, capacity, out_total);
    });
}

namespace {

/// A distance, or with limit = 1 a maximum distance.
gphys_status add_link(gphys_solver* solver, gphys_body_id body, uint32_t particle_a, uint32_t particle_b, float length,
                      float compliance, uint64_t limit, gphys_constraint_id* out_constraint) {
    GPHYS_TRY(check_particle(solver, body, particle_a));
    GPHYS_TRY(check_particle(solver, body, particle_b));
    GPHYS_REQUIRE_IN_RANGE(particle_a != particle_b, "particle_b", particle_b, "another particle than particle_a");
    GPHYS_TRY(check_coordinate(limit ? "max_length" : "rest_length", length));
    GPHYS_TRY(check_amount("compliance", compliance));
    GPHYS_REQUIRE_POINTERS(out_constraint);
    GPHYS_TRY(add_constraint(unwrap(solver)->body(body), {particle_a, particle_b, length, compliance, 0, limit},
                             *out_constraint));
    unwrap(solver)->update_mesh(body);
    return GPHYS_OK;
}

}  // namespace

gphys_status gphys_solver_add_distance(gphys_solver* solver, gphys_body_id body, uint32_t particle_a,
                                       uint32_t particle_b, float rest_length, float compliance,
                                       gphys_constraint_id* out_constraint) {
    return guarded(__func__, [&] {
        return add_link(solver, body, particle_a, particle_b, rest_length, compliance, 0, out_constraint);
    });
}

gphys_status gphys_solver_add_max_distance(gphys_solver* solver, gphys_body_id body, uint32_t particle_a,
                                           uint32_t particle_b, float max_length, float compliance,
                                           gphys_constraint_id* out_constraint) {
    return guarded(__func__, [&] {
        return add_link(solver, body, particle_a, particle_b, max_length, compliance, 1, out_constraint);
    });
}

gphys_status gphys_solver_set_constraint_damping(gphys_solver* solver, gphys_body_id body,
                                                 gphys_constraint_id constraint, float damping) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_TRY(check_amount("damping", damping));
        return set_damping(unwrap(solver)->body(body), constraint, damping);
    });
}

gphys_status gphys_solver_set_volume(gphys_solver* solver, gphys_body_id body, float rest_volume, float compliance) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE_IN_RANGE(is_coordinate(rest_volume) && rest_volume != 0, "rest_volume", rest_volume,
                               "from -1e15 to 1e15 and not 0");
        GPHYS_REQUIRE_IN_RANGE(is_amount(compliance) || compliance == INFINITY, "compliance", compliance,
                               "from 0 to 1e15 or INFINITY");
        Body& b = unwrap(solver)->body(body);
        if (compliance < INFINITY) return set_volume(b, rest_volume, compliance);
        release_volume(b);
        return GPHYS_OK;
    });
}

namespace {

gphys_status check_held_volume(const gphys_solver* solver, gphys_body_id body) {
    GPHYS_TRY(check_body(solver, body));
    if (unwrap(solver)->body(body).cloth.volume.held) return GPHYS_OK;
    return fail(GPHYS_ERROR_UNSUPPORTED, "body: gphys_solver_set_volume was not called");
}

}  // namespace

gphys_status gphys_solver_get_volume(const gphys_solver* solver, gphys_body_id body, float* out_volume,
                                     float* out_pressure) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_held_volume(solver, body));
        const Body& b = unwrap(solver)->body(body);
        if (out_volume) *out_volume = to_float(volume_of(b.cloth.sheet, b.particles));
        if (out_pressure) *out_pressure = to_float(b.cloth.volume.pressure);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_volume_settings(const gphys_solver* solver, gphys_body_id body, float* out_rest_volume,
                                              float* out_compliance) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_held_volume(solver, body));
        const Volume& volume = unwrap(solver)->body(body).cloth.volume;
        if (out_rest_volume) *out_rest_volume = to_float(volume.rest);
        if (out_compliance) *out_compliance = to_float(volume.compliance);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_remove_constraint(gphys_solver* solver, gphys_body_id body, gphys_constraint_id constraint) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_TRY(remove_constraint(unwrap(solver)->body(body), constraint));
        unwrap(solver)->update_mesh(body);
        return GPHYS_OK;
    });
}

gphys_status gphys_solver_get_constraints(const gphys_solver* solver, gphys_body_id body,
                                          gphys_constraint_info* out_constraints, uint32_t capacity,
                                          uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        return list_smallest<ConstraintOrder>(
            "out_constraints", out_constraints, capacity, out_total,
            [&](auto& constraints) { list_constraints(unwrap(solver)->body(body).constraints, constraints); });
    });
}

gphys_status gphys_solver_join(gphys_solver* solver, gphys_body_id body_a, uint32_t particle_a, gphys_body_id body_b,
                               uint32_t particle_b, float rest_length, float compliance, gphys_joint_id* out_joint) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_particle(solver, body_a, particle_a));
        GPHYS_TRY(check_particle(solver, body_b, particle_b));
        GPHYS_REQUIRE_IN_RANGE(body_a != body_b, "body_b", body_b, "another body than body_a");
        GPHYS_TRY(check_coordinate("rest_length", rest_length));
        GPHYS_TRY(check_amount("compliance", compliance));
        GPHYS_REQUIRE_POINTERS(out_joint);
        return unwrap(solver)->join(body_a, particle_a, body_b, particle_b, rest_length, compliance, *out_joint);
    });
}

gphys_status gphys_solver_unjoin(gphys_solver* solver, gphys_joint_id joint) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        return unwrap(solver)->unjoin(joint);
    });
}

gphys_status gphys_solver_get_joints(const gphys_solver* solver, gphys_body_id body, gphys_joint_info* out_joints,
                                     uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(solver);
        if (body != 0) GPHYS_TRY(unwrap(solver)->check(body));
        return list_smallest<JointOrder>("out_joints", out_joints, capacity, out_total,
                                         [&](auto& joints) { unwrap(solver)->list_joints(body, joints); });
    });
}
