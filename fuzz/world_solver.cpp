// Solvers. The state is known by its hash: a call that fails leaves it, a snapshot brings it back, and a twin that is
// given the same calls, but whose tasks run in reverse order, always has the same.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "world.h"

namespace fuzz {
namespace {

constexpr uint32_t most_particles = 12;

void run_reversed(void*, gphys_task task, void* context, uint32_t count) {
    while (count-- > 0) task(context, count);
}

bool is_finite(const gphys_vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

uint64_t World::hash(const gphys_solver* solver) const {
    uint32_t halves[2] = {};
    FUZZ_CHECK(call(gphys_solver_get_hash, solver, halves) == GPHYS_OK, "a solver has a hash");
    return uint64_t{halves[1]} << 32 | halves[0];
}

template <class Call>
gphys_status World::on_both(const char* failing_call_changes_nothing, Call&& make) {
    const uint64_t before = hash(solver_);
    const bool faulty = p_.one_in(60);
    if (faulty) memory_.fail_after(p_.below(6));
    const gphys_status status = make(solver_);
    const bool failed = memory_.has_failed();
    memory_.never_fail();
    if (status < 0) FUZZ_CHECK(hash(solver_) == before, failing_call_changes_nothing);
    if (failed && status == GPHYS_ERROR_OUT_OF_MEMORY) return status;  // the twin was not asked
    const gphys_status twin_status = make(twin_);
    FUZZ_CHECK(twin_status == status, "a twin answers the same");
    const uint64_t after = hash(solver_);
    note(after);
    FUZZ_CHECK(hash(twin_) == after, "workers in another order make the same bits");
    return status;
}

void World::create_solver() {
    if (solver_ && !p_.one_in(3)) return add_body();
    gphys_solver_desc desc;
    call(gphys_solver_desc_init, &desc, static_cast<uint32_t>(sizeof desc));
    const gphys_allocator hooks = memory_.hooks();
    desc.allocator = &hooks;
    desc.substeps = 1 + p_.below(4);
    if (p_.one_in(4)) desc.sleep_speed = 0.05f;
    if (p_.one_in(4)) desc.sleep_time = 0.01f;
    if (p_.one_in(5)) desc.max_strain = 0.01f;
    if (p_.one_in(5)) desc.tolerance = 0.01f;
    desc.max_substeps = 1 + p_.below(8);
    desc.max_steps = 1 + p_.below(3);
    if (p_.one_in(20)) desc.fixed_step = p_.hostile();
    if (p_.one_in(20)) desc.max_strain = p_.hostile();
    gphys_solver *made = nullptr, *twin = nullptr;
    const gphys_status status = call(gphys_solver_create, &desc, &made);
    FUZZ_CHECK((status == GPHYS_OK) == (made != nullptr), "a solver is there if it was created");
    if (!made) return;
    const gphys_task_runner runner{run_reversed, nullptr};
    desc.task_runner = &runner;
    desc.worker_count = 4;
    FUZZ_CHECK(call(gphys_solver_create, &desc, &twin) == GPHYS_OK, "a solver is created with workers as without");
    call(gphys_solver_destroy, solver_);
    call(gphys_solver_destroy, twin_);
    solver_ = made;
    twin_ = twin;
    shown_ = 0;
    bodies_.clear();
    stale_bodies_.clear();
    double origin[3];
    call(gphys_scene_get_origin, scene_, origin);
    call(gphys_solver_set_origin, solver_, static_cast<const double*>(origin));
    call(gphys_solver_set_origin, twin_, static_cast<const double*>(origin));
}

gphys_body_id World::any_body() {
    const uint32_t choice = p_.byte();
    if (choice < 8) return p_.word();
    if (choice < 16 && !stale_bodies_.empty())
        return stale_bodies_[p_.below(static_cast<uint32_t>(stale_bodies_.size()))];
    if (bodies_.empty()) return 0;
    return bodies_[p_.below(static_cast<uint32_t>(bodies_.size()))];
}

void World::add_body() {
    if (!solver_) return create_solver();
    if (bodies_.size() >= 6) return remove_body();
    // A desc may say that it is larger than this: then there is room behind it.
    struct {
        gphys_body_desc desc;
        unsigned char behind[256];
    } sized{};
    gphys_body_desc& desc = sized.desc;
    call(gphys_body_desc_init, &desc, static_cast<uint32_t>(sizeof desc));
    desc.radius = p_.one_in(3) ? p_.size() / 8 : 0.05f;
    desc.mass = p_.one_in(6) ? p_.size() + 1e-3f : 1;
    desc.damping = p_.one_in(4) ? 0.5f : 0;
    desc.restitution = p_.one_in(4) ? 0.5f : 0;
    desc.compliance = p_.one_in(3) ? 1e-4f : 0;
    desc.cloth_flags = p_.below(4);
    desc.self_collision = p_.one_in(4) ? 1 : 0;
    desc.body_layers = p_.below(3);
    // By an earlier choice, so that the programs of the corpus keep their meaning.
    desc.shear_compliance = desc.body_layers == 2 ? 1e-2f : 0;
    desc.bending_stiffness = desc.restitution > 0 ? 0.1f : 0;
    if (p_.one_in(6)) desc.layers = 0;
    p_.spoil(desc, 20);
    desc.struct_size = p_.one_in(40) ? p_.byte() : sizeof desc;
    const uint32_t kind = p_.below(4), count = 1 + p_.below(most_particles);
    std::vector<gphys_vec3> points(count);
    for (gphys_vec3& point : points) point = p_.point();
    if (p_.one_in(20)) p_.spoil(points[0], 1);
    const float link_length = p_.one_in(3) ? p_.size() : 0;
    const gphys_vec3 u = p_.direction(), v = p_.direction();
    const uint32_t columns = 1 + p_.below(4), rows = 1 + p_.below(4), which = p_.below(3);
    const gphys_transform place = p_.transform();
    gphys_body_id made = 0;
    const gphys_status status = on_both("adding that fails changes nothing", [&](gphys_solver* s) {
        Output<gphys_body_id> id;
        gphys_status added = 0;
        switch (kind) {
            case 0:
                added = call(gphys_solver_add_particles, s, &desc, points.data(), 12u, count, &id.value);
                break;
            case 1:
                added = call(gphys_solver_add_rope, s, &desc, points.data(), 12u, count, link_length, &id.value);
                break;
            case 2:
                added = call(gphys_solver_add_cloth, s, &desc, points.data(), &u, &v, columns, rows, &id.value);
                break;
            default:
                added = call(gphys_solver_add_cloth_mesh, s, &desc, meshes_[which].get(), &place, &id.value);
        }
        id.after(added);
        if (s == solver_) made = id.value;
        return added;
    });
    if (status != GPHYS_OK) return;
    FUZZ_CHECK(std::find(stale_bodies_.begin(), stale_bodies_.end(), made) == stale_bodies_.end(),
               "a stale body's id does not come back");
    bodies_.push_back(made);
}

void World::remove_body() {
    if (!solver_) return create_solver();
    const gphys_body_id body = any_body();
    const auto at = std::find(bodies_.begin(), bodies_.end(), body);
    const gphys_status status = on_both("remove_body that fails changes nothing",
                                        [&](gphys_solver* s) { return call(gphys_solver_remove_body, s, body); });
    if (status == GPHYS_ERROR_OUT_OF_MEMORY) return;
    FUZZ_CHECK(status == (at != bodies_.end() ? GPHYS_OK : GPHYS_ERROR_INVALID_ID), "only bodies are removed");
    if (status != GPHYS_OK) return;
    stale_bodies_.push_back(body);
    bodies_.erase(at);
    if (body == shown_) shown_ = 0;
}

void World::set_state() {
    if (!solver_) return create_solver();
    const gphys_body_id body = any_body();
    const uint32_t first = p_.below(6), count = p_.below(6);
    std::vector<gphys_vec3> vectors(count + 1);
    std::vector<float> scalars(count + 1);
    std::vector<gphys_animation_target> targets(count + 1), aimed(count + 1);
    for (gphys_vec3& v : vectors) v = p_.point();
    for (float& s : scalars) s = p_.size() + 0.01f;
    if (p_.one_in(10)) p_.spoil(vectors[p_.below(count + 1)], 1);
    if (p_.one_in(10)) scalars[p_.below(count + 1)] = p_.hostile();
    const uint32_t strides[] = {12, 12, 12, 0, 7}, stride = strides[p_.below(5)];
    const uint32_t choice = p_.below(8);
    for (uint32_t i = 0; i <= count; ++i) {
        const float distances[] = {0, scalars[i], INFINITY};
        targets[i] = {vectors[i], vectors[count - i], distances[p_.below(3)], distances[p_.below(3)]};
    }
    const int32_t pinned = static_cast<int32_t>(p_.below(8) ? p_.below(2) : 3);
    on_both("a setter that fails changes nothing", [&](gphys_solver* s) {
        switch (choice) {
            case 0:
                return call(gphys_solver_set_positions, s, body, first, count, vectors.data(), stride);
            case 1:
                return call(gphys_solver_set_velocities, s, body, first, count, vectors.data(), stride);
            case 2:
                return call(gphys_solver_set_forces, s, body, first, count, vectors.data(), stride);
            case 3:
                return call(gphys_solver_set_masses, s, body, first, count, scalars.data(), stride / 3);
            case 4:
                // By an earlier choice, so that the programs of the corpus keep their meaning.
                return first % 2
                           ? call(gphys_solver_set_friction_factors, s, body, first, count, scalars.data(), stride / 3)
                           : call(gphys_solver_set_radii, s, body, first, count, scalars.data(), stride / 3);
            case 5:
                return call(gphys_solver_set_air_velocities, s, body, first, count, vectors.data(), stride);
            case 6:
                return call(gphys_solver_set_animation_targets, s, body, first, count, targets.data(),
                            stride == 12 ? uint32_t{sizeof targets[0]} : stride);
            default:
                return call(gphys_solver_set_pinned, s, body, first, count, pinned);
        }
    });
    std::vector<gphys_vec3> read(count + 1);
    std::vector<float> radii(count + 1), factors(count + 1);
    std::vector<int32_t> held(count + 1);
    const gphys_status status = call(gphys_solver_get_forces, solver_, body, first, count, read.data(), 12u);
    FUZZ_CHECK(call(gphys_solver_get_air_velocities, solver_, body, first, count, read.data(), 12u) == status &&
                   call(gphys_solver_get_animation_targets, solver_, body, first, count, aimed.data(),
                        uint32_t{sizeof aimed[0]}) == status &&
                   call(gphys_solver_get_radii, solver_, body, first, count, radii.data(), 4u) == status &&
                   call(gphys_solver_get_friction_factors, solver_, body, first, count, factors.data(), 4u) == status &&
                   call(gphys_solver_get_pinned, solver_, body, first, count, held.data(), 4u) == status,
               "what is set of particles is read");
    if (status == GPHYS_OK && count > 0) note(held[0]), note(aimed[0]), note(factors[0]);
}

void World::change_body() {
    if (!solver_) return create_solver();
    const gphys_body_id body = any_body();
    gphys_body_settings settings{};
    if (call(gphys_solver_get_body_settings, solver_, body, &settings) == GPHYS_OK) note(settings);
    settings.friction = p_.one_in(2) ? 0.3f : 0;
    settings.static_friction = p_.one_in(2) ? 0.6f : 0;
    settings.layers = p_.one_in(4) ? 0 : 0xffffffff;
    settings.body_layers = p_.below(3);
    settings.self_collision = p_.below(2);
    settings.restitution = p_.one_in(3) ? 0.5f : 0;
    p_.spoil(settings, 12);
    on_both("settings of a body that are refused change nothing",
            [&](gphys_solver* s) { return call(gphys_solver_set_body_settings, s, body, &settings); });
    gphys_wind wind{};
    if (call(gphys_solver_get_wind, solver_, body, &wind) == GPHYS_OK) note(wind);
    wind = {p_.point(), p_.one_in(3) ? 0 : p_.size(), 1.2f, p_.one_in(2) ? 0 : p_.size()};
    p_.spoil(wind, 12);
    const gphys_body_id blown = p_.one_in(4) ? 0 : body;
    on_both("a wind that is refused changes nothing",
            [&](gphys_solver* s) { return call(gphys_solver_set_wind, s, blown, &wind); });
}

void World::change_constraints() {
    if (!solver_) return create_solver();
    const gphys_body_id body = any_body();
    std::vector<gphys_constraint_info> known(8);
    uint32_t total = 0;
    call(gphys_solver_get_constraints, solver_, body, known.data(), 8u, &total);
    std::vector<gphys_constraint_id> ids;
    for (uint32_t i = 0; i < std::min<uint32_t>(total, 1 + p_.below(8)); ++i) ids.push_back(known[i].id);
    if (p_.one_in(12)) ids.push_back(p_.word());
    const uint32_t count = static_cast<uint32_t>(ids.size());
    std::vector<gphys_constraint_settings> settings(count + 1);
    const gphys_status read =
        call(gphys_solver_get_constraint_settings, solver_, body, ids.data(), count, settings.data(), 12u);
    std::vector<gphys_constraint_kind> kinds(count + 1, -1);
    FUZZ_CHECK(call(gphys_solver_get_constraint_kinds, solver_, body, ids.data(), count, kinds.data(), 4u) == read &&
                   std::all_of(kinds.begin(), kinds.end(), [](gphys_constraint_kind kind) { return kind <= 1; }),
               "each constraint has a kind");
    for (gphys_constraint_settings& each : settings) {
        if (read != GPHYS_OK || p_.one_in(2)) each.rest_length = p_.one_in(6) ? -1 : p_.size();
        if (p_.one_in(4)) each.compliance = p_.one_in(2) ? 0 : 1e-3f;
        if (p_.one_in(4)) each.damping = p_.size();
    }
    p_.spoil(settings[0], 12);
    on_both("settings of constraints that are refused change nothing", [&](gphys_solver* s) {
        return call(gphys_solver_set_constraint_settings, s, body, ids.data(), settings.data(), 12u, count);
    });
}

void World::constrain() {
    if (!solver_) return create_solver();
    const gphys_body_id body = any_body();
    const uint32_t a = p_.below(8), b = p_.below(8), choice = p_.below(4);
    const float length = p_.one_in(3) ? p_.size() : -1;
    float compliance = p_.one_in(2) ? 0 : 1e-3f;
    if (p_.one_in(12)) compliance = p_.hostile();
    std::vector<gphys_constraint_info> known(64);
    uint32_t total = 0;
    call(gphys_solver_get_constraints, solver_, body, known.data(), 64u, &total);
    total = std::min<uint32_t>(total, 64);
    const gphys_constraint_id some = total > 0 && !p_.one_in(8) ? known[p_.below(total)].id : p_.word();
    on_both("a change of constraints that fails changes nothing", [&](gphys_solver* s) {
        gphys_constraint_id made = 0;
        switch (choice) {
            case 0:
                return call(gphys_solver_add_distance, s, body, a, b, length, compliance, &made);
            case 1:
                return call(gphys_solver_add_max_distance, s, body, a, b, length, compliance, &made);
            case 2:
                return call(gphys_solver_set_constraint_damping, s, body, some, compliance);
            default:
                return call(gphys_solver_remove_constraint, s, body, some);
        }
    });
}

void World::join() {
    if (!solver_) return create_solver();
    const gphys_body_id a = any_body(), b = any_body();
    const uint32_t at_a = p_.below(6), at_b = p_.below(6);
    const float length = p_.one_in(2) ? p_.size() : p_.one_in(2) ? 0 : -1;
    const float compliance = p_.one_in(3) ? 1e-3f : 0;
    gphys_joint_info known[16];
    uint32_t total = 0;
    call(gphys_solver_get_joints, solver_, p_.one_in(2) ? 0 : a, known, 16u, &total);
    total = std::min<uint32_t>(total, 16);
    const bool ends = p_.one_in(4);
    const gphys_joint_id some = total > 0 && !p_.one_in(8) ? known[p_.below(total)].id : p_.word();
    on_both("a change of joints that fails changes nothing", [&](gphys_solver* s) {
        gphys_joint_id made = 0;
        return ends ? call(gphys_solver_unjoin, s, some)
                    : call(gphys_solver_join, s, a, at_a, b, at_b, length, compliance, &made);
    });
}

void World::attach() {
    if (!solver_) return create_solver();
    const gphys_body_id body = any_body();
    const uint32_t particle = p_.below(6);
    const gphys_model_id to = any_id();
    gphys_vec3 local = p_.point();
    p_.spoil(local, 20);
    const bool here = p_.one_in(2), ends = p_.one_in(4);
    on_both("an attachment that fails changes nothing", [&](gphys_solver* s) {
        return ends ? call(gphys_solver_detach, s, body, particle)
                    : call(gphys_solver_attach, s, scene_, body, particle, to, here ? nullptr : &local);
    });
    gphys_attachment attached[8];
    uint32_t total = 0;
    const gphys_status listed = call(gphys_solver_get_attachments, solver_, body, attached, 8u, &total);
    if (listed < 0) return;
    for (uint32_t i = 0; i < std::min(total, 8u); ++i) {
        int32_t pinned = 0;
        call(gphys_solver_get_pinned, solver_, body, attached[i].particle, 1u, &pinned, 4u);
        FUZZ_CHECK(pinned == 1 && (i == 0 || attached[i - 1].particle < attached[i].particle),
                   "attachments are listed by particle");
    }
}

void World::volume() {
    if (!solver_) return create_solver();
    const gphys_body_id body = any_body();
    float rest = p_.one_in(2) ? -1 : p_.size();
    const float compliance = p_.one_in(4) ? INFINITY : p_.one_in(2) ? 0 : 1e-4f;
    if (p_.one_in(12)) rest = p_.hostile();
    if (compliance == INFINITY) cluster(body, rest > 0 && rest < 100 ? static_cast<uint32_t>(rest * 8) % 16 : 1);
    if (compliance == 0 && rest > 0) tear(body, rest);
    gphys_status set = GPHYS_NO_HIT;
    on_both("set_volume that fails changes nothing",
            [&](gphys_solver* s) { return set = call(gphys_solver_set_volume, s, body, rest, compliance); });
    Output<float> held, pressure;
    const gphys_status status = call(gphys_solver_get_volume, solver_, body, &held.value, &pressure.value);
    held.after(status);
    pressure.after(status);
    Output<float> given, softness;
    const gphys_status told = call(gphys_solver_get_volume_settings, solver_, body, &given.value, &softness.value);
    given.after(told);
    softness.after(told);
    FUZZ_CHECK(told == status && (told != GPHYS_OK || set != GPHYS_OK || softness.value == compliance),
               "what holds a volume is read as it was set");
}

/// `choice` is of another decision, so that the programs of the corpus keep their meaning.
void World::cluster(gphys_body_id body, uint32_t choice) {
    const uint32_t members[] = {0, 1, 2, 3, 4, 5, 2};
    gphys_cluster_id known[4];
    uint32_t total = 0, size = 0;
    const gphys_status listed = call(gphys_solver_get_clusters, solver_, body, known, 4u, &total);
    total = listed < 0 ? 0 : std::min(total, 4u);
    const gphys_cluster_id last = total > 0 ? known[total - 1] : 0;
    on_both("a change of clusters that fails changes nothing", [&](gphys_solver* s) {
        gphys_cluster_id made = 0;
        if (choice % 4 == 0) return call(gphys_solver_remove_cluster, s, body, last);
        return call(gphys_solver_add_cluster, s, body, members + choice % 3, 2 + choice / 4, &made);
    });
    for (uint32_t i = 0; i < total; ++i) {
        uint32_t first = 0;
        const gphys_status status =
            call(gphys_solver_get_cluster_particles, solver_, body, known[i], &first, 1u, &size);
        FUZZ_CHECK(known[i] == last || (status == GPHYS_INCOMPLETE && size >= 2), "a listed cluster has particles");
    }
}

/// `force` is of another decision, as above: the breaking force of the first constraints, of which one is broken.
void World::tear(gphys_body_id body, float force) {
    gphys_constraint_info links[32];
    gphys_constraint_id ids[32];
    float forces[32];
    uint32_t total = 0;
    const gphys_status listed = call(gphys_solver_get_constraints, solver_, body, links, 32u, &total);
    if (listed < 0 || total == 0) return;
    total = std::min(total, 32u);
    for (uint32_t i = 0; i < total; ++i) ids[i] = links[i].id;
    gphys_status set = GPHYS_NO_HIT;
    on_both("breaking forces that are refused change nothing", [&](gphys_solver* s) {
        return set = call(gphys_solver_set_breaking_forces, s, body, ids, &force, 0u, total);
    });
    FUZZ_CHECK(call(gphys_solver_get_breaking_forces, solver_, body, ids, total, forces, 4u) == GPHYS_OK &&
                   (set != GPHYS_OK || (forces[0] == force && forces[total - 1] == force)),
               "breaking forces are read as they were set");
    const gphys_constraint_id broken = ids[static_cast<uint32_t>(std::min(force, 1000.0f)) % total];
    on_both("a break that is refused changes nothing",
            [&](gphys_solver* s) { return call(gphys_solver_break_constraint, s, body, broken, nullptr); });
}

void World::settings() {
    if (!solver_) return create_solver();
    gphys_vec3 gravity = p_.one_in(2) ? gphys_vec3{0, -9.81f, 0} : p_.point();
    p_.spoil(gravity, 12);
    const uint32_t substeps = p_.one_in(12) ? p_.byte() * 8 : 1 + p_.below(4);
    on_both("settings that are refused change nothing",
            [&](gphys_solver* s) { return call(gphys_solver_set_gravity, s, &gravity); });
    if (substeps <= 4 || substeps > 1000 || substeps == 0) {
        on_both("settings that are refused change nothing",
                [&](gphys_solver* s) { return call(gphys_solver_set_substeps, s, substeps); });
    }
    gphys_solver_settings all{};
    call(gphys_solver_get_settings, solver_, &all);
    note(all);
    all.max_work = p_.one_in(3) ? 1 + p_.below(400) : 0;
    p_.spoil(all, 6);
    // Thousands of substeps or steps would take the time of a campaign.
    const bool many = (all.substeps > 4 && all.substeps <= 1000) ||
                      (all.max_substeps > 64 && all.max_substeps <= 1000) || all.max_steps > 3;
    if (!many) {
        on_both("settings that are refused change nothing",
                [&](gphys_solver* s) { return call(gphys_solver_set_settings, s, &all); });
    }
    // The twin's are those of a runner, which take no memory.
    const uint32_t wanted = 1 + static_cast<uint32_t>(bodies_.size()) % 5;
    uint32_t workers = 0;
    FUZZ_CHECK(call(gphys_solver_set_worker_count, twin_, wanted) == GPHYS_OK, "a solver takes any number of threads");
    call(gphys_solver_get_worker_count, twin_, &workers);
    FUZZ_CHECK(workers == wanted, "the number of threads is as it was set");
    const gphys_body_id body = p_.one_in(3) ? 0 : any_body();
    on_both("wake that fails changes nothing", [&](gphys_solver* s) { return call(gphys_solver_wake, s, body); });
}

void World::move_solver_origin(const double* origin) {
    on_both("set_origin that fails changes nothing",
            [&](gphys_solver* s) { return call(gphys_solver_set_origin, s, origin); });
}

void World::step() {
    if (!solver_) return create_solver();
    const gphys_scene* scene = p_.one_in(4) ? nullptr : scene_;
    float dt = p_.one_in(3) ? 1.0f / 60 : static_cast<float>(1 + p_.byte()) / 1000;
    if (p_.one_in(30)) dt = p_.hostile();
    const bool advances = p_.one_in(4);
    uint32_t made = 0;
    bool cut_short = false;
    const gphys_status status = on_both("a step that fails changes nothing", [&](gphys_solver* s) {
        if (!advances) return call(gphys_solver_step, s, scene, dt);
        uint32_t steps = 0;
        float left = 0;
        const gphys_status advanced = call(gphys_solver_advance, s, scene, dt, &steps, &left);
        float read = -1;
        call(gphys_solver_get_leftover, s, &read);
        FUZZ_CHECK(read >= 0 && read < 1 && (advanced != GPHYS_OK || read == left), "what is owed is read back");
        if (s == solver_) {
            made = steps;
            cut_short = memory_.has_failed();
        } else if (cut_short && steps > made) {
            follow_solver();  // which has left out steps that it had no memory for
        }
        return advanced;
    });
    if (status != GPHYS_OK) return;
    for (const gphys_body_id body : bodies_) {
        gphys_body_info info;
        if (call(gphys_solver_get_body_info, solver_, body, &info) != GPHYS_OK) continue;
        std::vector<gphys_vec3> at(info.particle_count);
        call(gphys_solver_get_positions, solver_, body, 0u, info.particle_count, at.data(), 12u);
        for (const gphys_vec3& each : at) FUZZ_CHECK(is_finite(each), "a step leaves particles at finite places");
        call(gphys_solver_get_velocities, solver_, body, 0u, info.particle_count, at.data(), 12u);
        for (const gphys_vec3& each : at) FUZZ_CHECK(is_finite(each), "a step leaves particles with finite speeds");
    }
    check_shown();
}

void World::show_body() {
    const gphys_body_id body = any_body();
    gphys_mesh_desc desc;
    call(gphys_mesh_desc_init, &desc, static_cast<uint32_t>(sizeof desc));
    p_.spoil(desc, 20);
    desc.allocator = nullptr;
    gphys_mesh* mesh = nullptr;
    const gphys_status status = call(gphys_mesh_create_from_body, &desc, solver_, body, &mesh);
    FUZZ_CHECK((mesh != nullptr) == (status == GPHYS_OK), "a mesh of a body is there if it was created");
    if (!mesh) return;
    forget_shown();
    call(gphys_scene_create, nullptr, &gallery_);
    gphys_model_id model = 0;
    FUZZ_CHECK(call(gphys_scene_add, gallery_, GPHYS_SHAPE_MESH, mesh, nullptr, nullptr, &model) == GPHYS_OK,
               "a body is a model");
    shown_mesh_ = mesh;
    shown_ = body;
    check_shown();
}

void World::forget_shown() {
    call(gphys_mesh_destroy, shown_mesh_);
    call(gphys_scene_destroy, gallery_);
    shown_mesh_ = nullptr;
    gallery_ = nullptr;
    shown_ = 0;
}

void World::check_shown() {
    if (!shown_mesh_) return;
    FUZZ_CHECK(call(gphys_scene_validate, gallery_) == GPHYS_OK, "the scene of a body is sound");
    const gphys_ray ray{p_.point(), p_.direction(), INFINITY};
    gphys_hit hit;
    const gphys_status met = call(gphys_scene_raycast, gallery_, &ray, GPHYS_ALL_LAYERS, &hit);
    int32_t any = 0;
    if (call(gphys_scene_raycast_any, gallery_, &ray, GPHYS_ALL_LAYERS, &any) == GPHYS_OK) {
        FUZZ_CHECK(any == (met == GPHYS_OK), "a ray that meets anything of a body meets something first");
    }
    if (shown_ == 0) return;
    gphys_body_info info;
    FUZZ_CHECK(call(gphys_solver_get_body_info, solver_, shown_, &info) == GPHYS_OK, "a body that is shown is there");
    std::vector<gphys_vec3> at(info.particle_count), vertices(info.particle_count);
    call(gphys_solver_get_positions, solver_, shown_, 0u, info.particle_count, at.data(), 12u);
    uint32_t total = 0;
    call(gphys_mesh_get_vertices, shown_mesh_, vertices.data(), info.particle_count, &total);
    FUZZ_CHECK(total == info.particle_count && std::memcmp(at.data(), vertices.data(), 12 * size_t{total}) == 0,
               "the mesh of a body has its positions");
    Output<uint32_t> particle;
    const uint32_t triangle = met == GPHYS_OK && !p_.one_in(8) ? hit.triangle : p_.byte();
    const gphys_status found =
        call(gphys_solver_get_nearest_particle, solver_, shown_, triangle, at.data(), &particle.value);
    particle.after(found);
    FUZZ_CHECK(found != GPHYS_OK || particle.value < info.particle_count, "a particle of the body is nearest");
    FUZZ_CHECK(found == GPHYS_OK || met != GPHYS_OK || triangle != hit.triangle, "what a ray has met has a particle");
}

void World::follow_solver() {
    uint32_t total = 0;
    call(gphys_solver_get_snapshot, solver_, nullptr, 0u, &total);
    std::vector<uint32_t> words(total);
    call(gphys_solver_get_snapshot, solver_, words.data(), total, &total);
    // Both, because contacts of bodies are in no snapshot.
    for (gphys_solver* const each : {twin_, solver_}) {
        FUZZ_CHECK(call(gphys_solver_restore, each, words.data(), total) == GPHYS_OK, "a snapshot is restored");
    }
}

void World::snapshot() {
    if (!solver_) return create_solver();
    if (!snapshot_.empty() && p_.one_in(2)) {
        const gphys_status status = on_both("a restore that fails changes nothing", [&](gphys_solver* s) {
            return call(gphys_solver_restore, s, snapshot_.data(), static_cast<uint32_t>(snapshot_.size()));
        });
        if (status == GPHYS_ERROR_OUT_OF_MEMORY) return;
        FUZZ_CHECK(status == GPHYS_OK, "a snapshot is restored");
        FUZZ_CHECK(hash(solver_) == snapshot_hash_, "a snapshot brings back the state");
        bodies_ = snapshot_bodies_;
        shown_ = 0;
        stale_bodies_.clear();
        double origin[3];
        call(gphys_scene_get_origin, scene_, origin);
        call(gphys_solver_set_origin, solver_, static_cast<const double*>(origin));
        call(gphys_solver_set_origin, twin_, static_cast<const double*>(origin));
        return;
    }
    uint32_t total = 0;
    call(gphys_solver_get_snapshot, solver_, nullptr, 0u, &total);
    snapshot_.assign(total, 0xa5a5a5a5);
    FUZZ_CHECK(
        total == 0 || call(gphys_solver_get_snapshot, solver_, snapshot_.data(), total - 1, &total) == GPHYS_INCOMPLETE,
        "a snapshot without room is incomplete");
    FUZZ_CHECK(snapshot_[0] == 0xa5a5a5a5, "a snapshot is written as a whole or not at all");
    FUZZ_CHECK(call(gphys_solver_get_snapshot, solver_, snapshot_.data(), total, &total) == GPHYS_OK,
               "a snapshot is taken");
    snapshot_hash_ = hash(solver_);
    snapshot_bodies_ = bodies_;
}

void World::inspect_solver() {
    if (!solver_) return create_solver();
    std::vector<gphys_body_id> sorted = bodies_, listed(bodies_.size() + 1);
    std::sort(sorted.begin(), sorted.end());
    uint32_t total = 0;
    call(gphys_solver_get_bodies, solver_, listed.data(), static_cast<uint32_t>(listed.size()), &total);
    FUZZ_CHECK(total == sorted.size() && std::equal(sorted.begin(), sorted.end(), listed.begin()),
               "a solver has the bodies that were added");
    uint32_t particles = 0, constraints = 0;
    for (const gphys_body_id body : bodies_) {
        gphys_body_info info;
        if (call(gphys_solver_get_body_info, solver_, body, &info) != GPHYS_OK) continue;
        note(info);
        particles += info.particle_count;
        constraints += info.constraint_count;
        std::vector<gphys_constraint_info> links(info.constraint_count + 1);
        call(gphys_solver_get_constraints, solver_, body, links.data(), info.constraint_count, &total);
        FUZZ_CHECK(total == info.constraint_count, "a body lists its constraints");
        for (uint32_t i = 0; i < total; ++i) {
            FUZZ_CHECK(links[i].particle_a < info.particle_count && links[i].particle_b < info.particle_count,
                       "a constraint is of particles");
        }
        std::vector<uint32_t> triangles(3 * size_t{info.triangle_count} + 1);
        call(gphys_solver_get_triangles, solver_, body, triangles.data(), 3 * info.triangle_count, &total);
        FUZZ_CHECK(total == 3 * info.triangle_count, "a cloth lists its triangles");
        std::vector<float> masses(info.particle_count);
        call(gphys_solver_get_masses, solver_, body, 0u, info.particle_count, masses.data(), 4u);
        for (const float mass : masses) FUZZ_CHECK(mass > 0, "particles have mass");
        Output<uint32_t> substeps;
        substeps.after(call(gphys_solver_get_substeps, solver_, body, &substeps.value));
        gphys_solver_stats stats;
        call(gphys_solver_get_stats, solver_, body, &stats);
        FUZZ_CHECK(stats.particle_count == info.particle_count, "statistics count the particles");
    }
    gphys_solver_stats stats;
    call(gphys_solver_get_stats, solver_, 0u, &stats);
    FUZZ_CHECK(stats.particle_count == particles && stats.constraint_count == constraints, "statistics add up");
    gphys_contact contacts[64];
    gphys_impulse impulses[64];
    call(gphys_solver_get_contacts, solver_, contacts, 64u, &total);
    for (uint32_t i = 0; i < std::min(total, 64u); ++i) note(contacts[i]);
    gphys_body_contact touches[64], twins[64];
    uint32_t twin_total = 0;
    call(gphys_solver_get_body_contacts, solver_, touches, 64u, &total);
    call(gphys_solver_get_body_contacts, twin_, twins, 64u, &twin_total);
    FUZZ_CHECK(total == twin_total && std::memcmp(touches, twins, std::min(total, 64u) * sizeof touches[0]) == 0,
               "workers in another order list the same contacts of bodies");
    for (uint32_t i = 0; i < std::min(total, 64u); ++i) {
        note(touches[i]);
        FUZZ_CHECK(touches[i].body_a < touches[i].body_b && touches[i].impulse >= 0,
                   "a contact is of two bodies, which press each other");
        for (const gphys_body_id body : {touches[i].body_a, touches[i].body_b}) {
            FUZZ_CHECK(std::find(bodies_.begin(), bodies_.end(), body) != bodies_.end(), "contacts are of bodies");
        }
    }
    call(gphys_solver_get_impulses, solver_, impulses, 64u, &total);
    for (uint32_t i = 0; i < std::min(total, 64u); ++i) note(impulses[i]);
    call(gphys_solver_get_sleeping, solver_, listed.data(), static_cast<uint32_t>(listed.size()), &total);
    FUZZ_CHECK(total <= bodies_.size(), "not more bodies sleep than there are");
    double origin[3];
    call(gphys_solver_get_origin, solver_, origin);
    if (p_.one_in(2)) show_body();
}

void World::solver_misuse() {
    if (!solver_) return create_solver();
    gphys_solver* none = nullptr;
    const gphys_vec3 point = p_.point();
    const float scalar = 1;
    const gphys_body_id body = any_body();
    gphys_vec3 out;
    float value = 0;
    uint32_t total = 0;
    gphys_body_id made = 0;
    const uint64_t before = hash(solver_);
    const uint32_t words[] = {p_.word(), p_.word(), 6, 0, 0, 0, 0, 0};
    const gphys_status refused[] = {
        call(gphys_solver_create, nullptr, nullptr),
        call(gphys_solver_desc_init, nullptr, 8u),
        call(gphys_body_desc_init, nullptr, 8u),
        call(gphys_solver_set_gravity, solver_, nullptr),
        call(gphys_solver_set_substeps, solver_, 0u),
        call(gphys_solver_set_substeps, none, 1u),
        call(gphys_solver_add_particles, solver_, nullptr, &point, 12u, 0u, &made),
        call(gphys_solver_add_particles, solver_, nullptr, nullptr, 12u, 1u, &made),
        call(gphys_solver_add_rope, solver_, nullptr, &point, 12u, 1u, 0.0f, &made),
        call(gphys_solver_add_cloth, solver_, nullptr, &point, nullptr, &point, 2u, 2u, &made),
        call(gphys_solver_add_cloth_mesh, solver_, nullptr, nullptr, nullptr, &made),
        call(gphys_solver_remove_body, none, body),
        call(gphys_solver_get_bodies, solver_, nullptr, 4u, &total),
        call(gphys_solver_get_sleeping, none, nullptr, 0u, &total),
        call(gphys_solver_wake, none, body),
        call(gphys_solver_get_body_info, solver_, body, nullptr),
        call(gphys_solver_get_triangles, solver_, body, nullptr, 5u, &total),
        call(gphys_solver_get_positions, solver_, body, 0u, 0xffffffffu, &out, 12u),
        call(gphys_solver_get_velocities, solver_, body, 1000u, 1u, &out, 12u),
        call(gphys_solver_get_masses, none, body, 0u, 1u, &value, 4u),
        call(gphys_solver_set_positions, solver_, body, 0u, 1u, nullptr, 12u),
        call(gphys_solver_set_velocities, solver_, body, 0u, 1u, &point, 5u),
        call(gphys_solver_set_masses, solver_, body, 0u, 1000u, &scalar, 0u),
        call(gphys_solver_set_radii, none, body, 0u, 1u, &scalar, 4u),
        call(gphys_solver_set_forces, solver_, body, 0u, 1u, nullptr, 12u),
        call(gphys_solver_set_pinned, solver_, body, 0u, 1u, 2),
        call(gphys_solver_attach, solver_, nullptr, body, 0u, 1u, nullptr),
        call(gphys_solver_detach, solver_, body, 1000u),
        call(gphys_solver_get_attachments, none, body, nullptr, 1u, &total),
        call(gphys_solver_get_volume_settings, none, body, nullptr, nullptr),
        call(gphys_solver_get_constraint_kinds, solver_, body, nullptr, 1u, nullptr, 4u),
        call(gphys_solver_add_distance, solver_, body, 0u, 0u, 1.0f, 0.0f, &made),
        call(gphys_solver_add_max_distance, solver_, body, 0u, 1000u, 1.0f, 0.0f, &made),
        call(gphys_solver_set_constraint_damping, solver_, body, 0u, 1.0f),
        call(gphys_solver_set_volume, solver_, body, 0.0f, 0.0f),
        call(gphys_solver_remove_constraint, solver_, body, 0u),
        call(gphys_solver_add_cluster, solver_, body, &total, 1u, &made),
        call(gphys_solver_remove_cluster, solver_, body, 0u),
        call(gphys_solver_get_clusters, solver_, body, nullptr, 3u, &total),
        call(gphys_solver_get_cluster_particles, solver_, body, 0u, nullptr, 0u, &total),
        call(gphys_solver_set_breaking_forces, solver_, body, nullptr, &scalar, 0u, 1u),
        call(gphys_solver_get_breaking_forces, solver_, body, nullptr, 1u, nullptr, 4u),
        call(gphys_solver_break_constraint, solver_, body, 0u, nullptr),
        call(gphys_solver_get_breaks, solver_, nullptr, 3u, &total),
        call(gphys_solver_get_constraints, solver_, body, nullptr, 3u, &total),
        call(gphys_solver_join, solver_, body, 0u, body, 0u, 0.0f, 0.0f, &made),
        call(gphys_solver_unjoin, solver_, 0u),
        call(gphys_solver_get_joints, none, 0u, nullptr, 0u, &total),
        call(gphys_solver_step, none, nullptr, 0.01f),
        call(gphys_solver_step, solver_, nullptr, -1.0f),
        call(gphys_solver_advance, solver_, nullptr, -1.0f, nullptr, nullptr),
        call(gphys_solver_get_substeps, solver_, body, nullptr),
        call(gphys_solver_get_stats, solver_, 0u, nullptr),
        call(gphys_solver_get_contacts, solver_, nullptr, 3u, &total),
        call(gphys_solver_get_body_contacts, solver_, nullptr, 3u, &total),
        call(gphys_solver_get_impulses, none, nullptr, 0u, &total),
        call(gphys_solver_get_snapshot, solver_, nullptr, 0u, nullptr),
        call(gphys_solver_restore, solver_, words, 8u),
        call(gphys_solver_restore, solver_, nullptr, 8u),
        call(gphys_solver_get_hash, solver_, nullptr),
        call(gphys_solver_get_settings, none, nullptr),
        call(gphys_solver_set_settings, solver_, nullptr),
        call(gphys_solver_get_body_settings, solver_, body, nullptr),
        call(gphys_solver_set_body_settings, none, body, nullptr),
        call(gphys_solver_get_constraint_settings, solver_, body, nullptr, 1u, nullptr, 12u),
        call(gphys_solver_set_constraint_settings, solver_, body, nullptr, nullptr, 12u, 1u),
        call(gphys_solver_get_wind, solver_, body, nullptr),
        call(gphys_solver_set_wind, none, body, nullptr),
        call(gphys_solver_set_friction_factors, solver_, body, 0u, 1u, nullptr, 4u),
        call(gphys_solver_get_friction_factors, none, body, 0u, 1u, &value, 4u),
        call(gphys_solver_set_air_velocities, solver_, body, 0u, 1u, nullptr, 12u),
        call(gphys_solver_get_air_velocities, solver_, body, 1000u, 1u, &out, 12u),
        call(gphys_solver_set_animation_targets, solver_, body, 0u, 1u, nullptr, 32u),
        call(gphys_solver_get_animation_targets, none, body, 0u, 1u, nullptr, 32u),
        call(gphys_solver_get_radii, none, body, 0u, 1u, &value, 4u),
        call(gphys_solver_get_forces, solver_, body, 0u, 1u, &out, 5u),
        call(gphys_solver_get_pinned, solver_, body, 1000u, 1u, nullptr, 4u),
        call(gphys_solver_set_worker_count, solver_, 1025u),
        call(gphys_solver_get_worker_count, none, &total),
        call(gphys_solver_get_leftover, solver_, nullptr)};
    for (const gphys_status status : refused) FUZZ_CHECK(status < 0, "a call that makes no sense is refused");
    FUZZ_CHECK(hash(solver_) == before, "calls that make no sense change nothing");
    // What was refused has woken no body of the twin's either, or the hashes part from here.
    FUZZ_CHECK(hash(twin_) == before, "workers in another order make the same bits");
}

}  // namespace fuzz
