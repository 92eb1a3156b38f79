// Snapshots: all state that the next step depends on, as words, and back.
//
// A snapshot is a header and the words of the state. Data that follow from others (the links of particles, the chains
// of a rope, the packed batches of cloth) are not stored but computed again. Data that depend on the past are stored:
// the chains of cloth depend on the positions of its particles when it was planned, and the tensions of a rope are the
// initial guess of the next step.
//
// Words may come from any source. Everything that is used as a number or an index is validated first
// (snapshot_check.h). A state that passes is as safe to step as one that the library has made.
#include "foundation/archive.h"
#include "foundation/snapshot_header.h"
#include "solver/snapshot/snapshot_check.h"

namespace gphys {
namespace {

// Version of the list below: increase it when that changes.
constexpr uint32_t format = 9;

/// Arrays that few bodies have. They come last, in the order of their keys: the key, which is the array and the slot of
/// the body, and the elements; of clusters their ids come before. A snapshot without them is as it was before there
/// were any.
enum class RareArray : uint32_t { targets, friction_factors, clusters, breaking_forces, bending };
constexpr uint32_t slot_bits = 24;
static_assert(IdTable::capacity < 1u << slot_bits);

// Copied byte by byte, so they must have no padding.
static_assert(sizeof(Vec3) == 24 && sizeof(DistanceConstraint) == 40 && sizeof(LengthChange) == 16 &&
              sizeof(Attachment) == 80 && sizeof(AnimationTarget) == 120 && sizeof(ClusterMember) == 32);
static_assert(sizeof(ContactPoint) == 32 && sizeof(ModelImpulse) == 56 && sizeof(PlacedModel) == 48 &&
              sizeof(Chain) == 12 && sizeof(ReachLimit) == 16);
static_assert(sizeof(Joint) == 56);

/// Body is const when it is written. Of a plan, only what its constraints do not determine is visited, and nothing if
/// the plan is outdated.
template <class Archive, class Body>
void visit_plan(Archive& archive, Body& body) {
    auto& plan = body.plan;
    // One word says whether it is up to date, and how often it has been edited since the last step.
    uint32_t edits_or_none = plan.chains_current ? 1 + plan.edits : 0;
    archive.value(edits_or_none);
    if constexpr (!std::is_const_v<Body>) {
        plan.chains_current = edits_or_none > 0;
        plan.edits = std::max(edits_or_none, 1u) - 1;
    }
    if (!plan.chains_current) return;
    archive.value(plan.method);
    if (plan.method == GPHYS_SOLVE_DIRECT) archive.array(body.rope.tension);
    if (plan.method != GPHYS_SOLVE_GRAPH) return;
    visit_all(archive, plan.chains, plan.colours, plan.particles, plan.slots, plan.reach_current);
    if (plan.reach_current) archive.array(body.cloth.reach.limits);
}

template <class Archive, class Body>
void visit_body(Archive& archive, Body& body) {
    auto& settings = body.settings;
    auto& particles = body.particles;
    auto& constraints = body.constraints;
    auto& contacts = body.contacts;
    auto& history = body.history;
    auto& cloth = body.cloth;
    auto& sleep = body.sleep;
    visit_all(archive, body.kind, settings.damping, settings.friction, settings.static_friction, settings.restitution,
              settings.layers, settings.body_layers, settings.self_collision);
    visit_all(archive, particles.position, particles.velocity, particles.force, particles.mass, particles.inverse_mass,
              particles.radius, body.air.wind, body.air.velocity, constraints.attachments);
    IdTable::visit(archive, constraints.ids);
    visit_all(archive, constraints.by_slot, constraints.length_changes, cloth.sheet.rest_position,
              cloth.sheet.triangles, contacts.self.placed);
    visit_all(archive, cloth.volume.held, cloth.volume.rest, cloth.volume.compliance, cloth.volume.pressure);
    visit_all(archive, history.start, history.start_velocity, history.earlier_step, history.placed);
    visit_all(archive, contacts.has_contact, cloth.balance.lost, contacts.points, body.substeps.made,
              body.substeps.wanted, contacts.stuck, contacts.impulses);
    visit_all(archive, sleep.rest_time, sleep.asleep, sleep.box, sleep.neighbourhood, sleep.settling, sleep.support,
              sleep.drift);
    visit_all(archive, cloth.state.moved, cloth.state.velocity_before, cloth.state.origin, cloth.cache.search_balls,
              cloth.yielding.any, cloth.yielding.collapsed_time);
    visit_plan(archive, body);
}

template <class Archive, class State>
void visit_globals(Archive& archive, State& state) {
    auto& settings = state.settings;
    visit_all(archive, settings.gravity, settings.substeps, settings.fixed_step, settings.max_steps,
              settings.sleep_speed, settings.sleep_strain, settings.sleep_time, settings.max_strain, settings.tolerance,
              settings.max_substeps, settings.max_work, state.origin, state.accumulator);
    IdTable::visit(archive, state.ids);
    IdTable::visit(archive, state.joint_ids);
    visit_all(archive, state.joints, state.near_models);
}

template <class Archive, class Array>
void write_rare(Archive& archive, const SolverState& state, RareArray which, Array&& array_of) {
    for (const uint32_t slot : state.ids) {
        if (array_of(state.bodies[slot]).empty()) continue;
        archive.value(static_cast<uint32_t>(which) << slot_bits | slot);
        archive.array(array_of(state.bodies[slot]));
    }
}

template <class Archive>
void write_bending(Archive& archive, const SolverState& state) {
    for (const uint32_t slot : state.ids) {
        if (!state.bodies[slot].rope.bending.resists()) continue;
        archive.value(static_cast<uint32_t>(RareArray::bending) << slot_bits | slot);
        archive.value(state.bodies[slot].rope.bending.stiffness);
    }
}

/// Also of a body that has none any more, because stale ids must stay stale.
template <class Archive>
void write_clusters(Archive& archive, const SolverState& state) {
    for (const uint32_t slot : state.ids) {
        const Clusters& clusters = state.bodies[slot].cloth.clusters;
        if (clusters.ids.slots() == 0) continue;
        archive.value(static_cast<uint32_t>(RareArray::clusters) << slot_bits | slot);
        IdTable::visit(archive, clusters.ids);
        archive.array(clusters.members);
    }
}

template <class Sink>
void write(Sink& sink, const SolverState& state) {
    Writer<Sink> archive(sink);
    visit_globals(archive, state);
    for (const uint32_t slot : state.ids) visit_body(archive, state.bodies[slot]);
    write_rare(
        archive, state, RareArray::targets, [](const Body& body) -> auto& { return body.targets.all; });
    write_rare(
        archive, state, RareArray::friction_factors,
        [](const Body& body) -> auto& { return body.contacts.friction_factor; });
    write_clusters(archive, state);
    write_rare(
        archive, state, RareArray::breaking_forces, [](const Body& body) -> auto& { return body.breaking.force; });
    write_bending(archive, state);
}

/// Computes what is not in a snapshot, except the plan. Throws std::bad_alloc.
void complete(Body& body) {
    body.constraints.links.resize(body.particles.size());
    for (const uint32_t slot : body.constraints.ids) change_links(body.constraints, slot, 1);
    body.particles.forced = std::any_of(body.particles.force.begin(), body.particles.force.end(),
                                        [](Vec3 force) { return force != Vec3{}; });
    if (!body.contacts.points.empty()) body.contacts.point_count.resize(body.particles.size());
    for (size_t i = 0; i < body.contacts.points.size(); ++i) {
        if (body.contacts.points[i].model != 0)
            body.contacts.point_count[i / contact_points_per_particle] = i % contact_points_per_particle + 1;
    }
}

const char* read_rare(Reader& archive, SolverState& state) {
    for (uint32_t next = 0; !archive.finished();) {
        uint32_t key = 0;
        archive.value(key);
        const uint32_t slot = key & ((1u << slot_bits) - 1);
        if (!archive.good() || key < next || slot >= state.ids.slots() || !state.ids.live(slot)) return cut_short;
        Body& body = state.bodies[slot];
        const char* wrong = nullptr;
        switch (RareArray{key >> slot_bits}) {
            case RareArray::targets:
                archive.array(body.targets.all);
                wrong = defect_of_targets(body);
                break;
            case RareArray::friction_factors:
                archive.array(body.contacts.friction_factor);
                wrong = defect_of_friction_factors(body);
                break;
            case RareArray::clusters:
                IdTable::visit(archive, body.cloth.clusters.ids);
                archive.array(body.cloth.clusters.members);
                wrong = defect_of_clusters(body);
                break;
            case RareArray::breaking_forces:
                archive.array(body.breaking.force);
                wrong = defect_of_breaking_forces(body);
                break;
            case RareArray::bending:
                archive.value(body.rope.bending.stiffness);
                wrong = defect_of_bending(body);
                break;
            default:
                return cut_short;
        }
        if (!archive.good()) return cut_short;
        if (wrong) return wrong;
        next = key + 1;
    }
    return nullptr;
}

const char* read(Reader& archive, SolverState& state) {
    visit_globals(archive, state);
    if (!archive.good()) return cut_short;
    if (const char* wrong = defect_of_globals(state)) return wrong;
    state.bodies.add_slots(state.ids.slots());
    for (const uint32_t slot : state.ids) {
        state.bodies.put(slot, new_body(state.bodies.memory()));
        Body& body = state.bodies[slot];
        visit_body(archive, body);
        if (!archive.good()) return cut_short;
        if (const char* wrong = defect(body)) return wrong;
        complete(body);
    }
    if (const char* wrong = defect_of_joints(state)) return wrong;
    if (const char* wrong = read_rare(archive, state)) return wrong;
    // Clusters decide which plans are possible.
    for (const uint32_t slot : state.ids) {
        if (const char* wrong = defect_of_plan(state.bodies[slot])) return wrong;
        complete_plan(state.bodies[slot]);
    }
    return nullptr;
}

uint64_t hash_of(const uint32_t* words, size_t count) {
    WordHash hash;
    hash.put(words, count);
    return hash.value();
}

}  // namespace

uint64_t hash_of_state(const Body& body) {
    WordHash hash;
    Writer<WordHash> archive(hash);
    visit_body(archive, body);
    return hash.value();
}

void Solver::hash(uint32_t (&out)[2]) const {
    WordHash hash;
    write(hash, state_);
    out[0] = static_cast<uint32_t>(hash.value());
    out[1] = static_cast<uint32_t>(hash.value() >> 32);
}

gphys_status Solver::snapshot(uint32_t* out, uint32_t capacity, uint32_t& total) const {
    WordCount count;
    write(count, state_);
    GPHYS_TRY(fit_snapshot(count.words + snapshot_header_words, capacity, total));
    WordCopy copy{out + snapshot_header_words};
    write(copy, state_);
    write_header(out, solver_snapshot_magic, format, total, hash_of(out + snapshot_header_words, count.words));
    return GPHYS_OK;
}

gphys_status Solver::restore(const uint32_t* words, uint32_t count) {
    const auto rejected = [](const char* why) { return fail(GPHYS_ERROR_INVALID_ARGUMENT, why); };
    SnapshotHeader header;
    if (const char* wrong = read_header(words, count, solver_snapshot_magic, format, format, header))
        return rejected(wrong);
    if (!header.has_checksum(hash_of(words + snapshot_header_words, count - snapshot_header_words))) {
        return rejected("words: the checksum is not that of the contents");
    }
    SolverState restored(&memory);
    Reader archive(words + snapshot_header_words, count - snapshot_header_words);
    if (const char* wrong = read(archive, restored)) return rejected(wrong);
    size_t given = 0;
    for (const Body& body : restored.bodies) given += body.contacts.impulses.size();
    impulse_sums_.reserve(given);
    const Vec3 shift = state_.origin - restored.origin;
    state_ = std::move(restored);
    add_impulses();
    particle_contacts_.clear_list();
    breaks_.clear();
    joints_current_ = false;
    update_meshes(shift);
    return GPHYS_OK;
}

}  // namespace gphys
