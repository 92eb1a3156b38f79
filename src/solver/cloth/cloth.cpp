// Cloth and other graphs: chains of constraints, each solved directly, one colour after the other (block Gauss-Seidel
// with graph colouring). Within a chain the corrections of all links are found together by elimination of their
// tridiagonal system (Thomas's algorithm). So tension crosses the cloth in one sweep, where single constraints would
// need as many sweeps as there are links. There is one pass per substep, always in the same order, because alternating
// between forward and backward was seen to add energy.
//
// During a step the state is float32, relative to the middle of the body at the start of the step, with separate
// displacements and velocities. So positions of a sheet of two metres have a rounding error of 6e-8 m, wherever it is.
#include "solver/cloth/cloth_targets.h"
#include "solver/cloth/contact_cache.h"
#include "solver/cloth/relax_links.h"
#include "solver/cloth/whole_motion.h"
#include "solver/contact/collision.h"
#include "solver/contact/leave_solids.h"
#include "solver/quads.h"
#include "solver/rope/damping.h"

namespace gphys {
namespace {

// Masses are clamped to this ratio to the average: beyond it float32 shows no difference.
constexpr double most_mass_ratio = 1e6;
// Accelerations times the other factors must remain floats, too.
constexpr double hardest = 1e12;
// A softer link does not act: it yields 1e20 times as far as the heaviest particle.
constexpr double softest = 1e26;

ClothMotion motion_of(Cloth& cloth) {
    return {static_cast<uint32_t>(cloth.at.size()),
            cloth.at.data(),
            cloth.start.data(),
            cloth.moved.data(),
            cloth.velocity.data(),
            cloth.velocity_before.data(),
            cloth.acceleration.data()};
}

// Units of work of a team's members, in floats: 1000 particles, a few microseconds. A block is the unit of summation in
// the kernels; sums of blocks do not depend on who has computed them.
constexpr uint32_t share_floats = 4096, share_limits = 1024, block_floats = 256;

ClothMotion part_of(const ClothMotion& all, uint32_t first, uint32_t most_floats) {
    return {std::min(most_floats, all.floats - first),
            all.at + first,
            all.start + first,
            all.moved + first,
            all.velocity + first,
            all.velocity_before + first,
            all.acceleration + first};
}

/// Calls part(motion of some of the particles, index of their first float).
template <class Part>
void share_motion(Cloth& cloth, Part&& part) {
    const ClothMotion all = motion_of(cloth);
    share(cloth.team, (all.floats + share_floats - 1) / share_floats,
          [&](uint32_t i, uint32_t) { part(part_of(all, i * share_floats, share_floats), i * share_floats); });
}

void predict(const ClothKernels& kernels, Cloth& cloth, const ClothStep& step) {
    share_motion(cloth, [&](const ClothMotion& motion, uint32_t) { kernels.predict(motion, step); });
}

/// The sum over blocks of particles of kernel(motion).
template <class Kernel>
double sum_of_blocks(Cloth& cloth, Kernel&& kernel) {
    share_motion(cloth, [&](const ClothMotion& motion, uint32_t first) {
        for (uint32_t i = 0; i < motion.floats; i += block_floats) {
            cloth.sums[(first + i) / block_floats] = kernel(part_of(motion, i, block_floats));
        }
    });
    double sum = 0;
    for (const double of_block : cloth.sums) sum += of_block;
    return sum;
}

ClothStep cloth_step(const Body& body, double h) {
    const TimeScheme scheme(h, body.history.earlier_step);
    const auto narrowed = [](double value) { return static_cast<float>(value); };
    const double h_before = scheme.earlier > 0 ? body.history.earlier_step : 0, damping = body.settings.damping;
    return {narrowed(h),
            narrowed(h_before),
            narrowed(h_before / h),
            narrowed(scheme.next),
            narrowed(scheme.earlier),
            narrowed(damping),
            narrowed(scheme.drag(damping))};
}

ClothChains chains_of(const ClothBatches& batches) {
    return {batches.particles.data(), batches.rest.data(), batches.softness.data(), batches.stiffness.data()};
}

/// The same with the target lengths of damped links.
ClothChains damped_chains_of(const ClothBatches& batches) {
    ClothChains chains = chains_of(batches);
    if (!batches.damped.empty()) chains.rest = batches.target.data();
    return chains;
}

void soften(ClothBatches& batches, double average_mass, double step) {
    const double scale = average_mass / (step * step);
    if (batches.scale == scale) return;
    batches.scale = scale;
    batches.elastic = false;
    for (size_t i = 0; i < batches.compliance.size(); ++i) {
        const double compliance = batches.compliance[i];
        batches.softness[i] = to_float(compliance * scale, softest);
        const bool elastic = compliance > 0 && compliance < infinity;
        // Stiffer links than 1e15, and their energy, count as rigid.
        batches.stiffness[i] =
            elastic && compliance * average_mass > 1e-15 ? static_cast<float>(1 / (compliance * average_mass)) : 0;
        batches.elastic = batches.elastic || elastic;
    }
}

void damp_links(Body& body, const TimeScheme& scheme) {
    ClothBatches& batches = body.cloth.batches;
    const Cloth& cloth = body.cloth;
    for (const DampedInCloth& link : batches.damped) {
        const Vec3 now = get(&cloth.start[4 * size_t{link.b}]) - get(&cloth.start[4 * size_t{link.a}]);
        const Vec3 before = now - (get(&cloth.moved[4 * size_t{link.b}]) - get(&cloth.moved[4 * size_t{link.a}]));
        const DampedLink as = damped(link.rest, link.compliance, link.damping, scheme, length(now), length(before), 0);
        batches.target[link.link] = to_float(as.rest, farthest_in_cloth);
        batches.softness[link.link] = to_float(as.compliance * batches.scale, softest);
    }
}

/// Limits that have become taut: their ends stop separating, in an inelastic impact. Returns whether there were any,
/// which counts as an interruption.
bool capture_limits(Body& body, const CollisionContext& around, const TimeScheme& scheme) {
    Cloth& cloth = body.cloth;
    // Models got the forces of this substep as continuous ones; an impact has no such history.
    const double step = scheme.step(body.settings.damping);
    const double counted = scheme.h / (step * step) - scheme.next / scheme.h;
    const auto add_to_model = [&](uint32_t p, Vec3 impulse) {
        const Attachment* attachment = around.scene ? find_attachment(body.constraints, p) : nullptr;
        if (!attachment) return;
        float* pull = &body.cloth.contacts.pulls[4 * size_t{p}];
        const Vec3 given = (impulse - get(pull) * counted) * cloth.average_mass;
        add_impulse(body, around, attachment->model, cloth.origin + get(&cloth.at[4 * size_t{p}]), given);
        put(pull, {}, 0);
    };
    // Relative to the length: ten times the rounding of positions within about a metre.
    constexpr double slack = 1e-6;
    bool any = false;
    for (const LimitInCloth& limit : body.cloth.batches.limits) {
        const size_t a = 4 * size_t{limit.a}, b = 4 * size_t{limit.b};
        const double shortest = limit.rest * (1 - slack), mobility = double{cloth.at[a + 3]} + cloth.at[b + 3];
        if (distance(get(&cloth.start[a]), get(&cloth.start[b])) >= shortest || mobility == 0) continue;
        const Vec3 along = get(&cloth.at[b]) - get(&cloth.at[a]);
        const double length = gphys::length(along);
        if (length < shortest || length == 0) continue;
        any = true;
        const Vec3 apart =
            along * (dot(get(&cloth.velocity[b]) - get(&cloth.velocity[a]), along) / (length * length * mobility));
        put(&cloth.velocity[a], get(&cloth.velocity[a]) + apart * cloth.at[a + 3], fastest_in_cloth);
        put(&cloth.velocity[b], get(&cloth.velocity[b]) - apart * cloth.at[b + 3], fastest_in_cloth);
        add_to_model(limit.a, apart);
        add_to_model(limit.b, -apart);
    }
    return any;
}

double stored_energy(const ClothKernels& kernels, Body& body) {
    const ClothBatches& batches = body.cloth.batches;
    Cloth& cloth = body.cloth;
    double sum = body.cloth.volume.held ? stored_in_volume(body, cloth_volume(body)) / cloth.average_mass : 0;
    if (!batches.elastic) return sum;
    share(cloth.team, static_cast<uint32_t>(batches.chains.size()), [&](uint32_t i, uint32_t) {
        cloth.stored[i] = kernels.stored(cloth.at.data(), chains_of(batches), batches.chains[i]);
    });
    for (const double of_batch : cloth.stored) sum += of_batch;
    return sum;
}

/// Adds the pulls of chains and limits on attached particles: the force of a whole substep.
void add_pull_impulses(Body& body, const CollisionContext& around, double step, double h) {
    const double to_impulse = body.cloth.average_mass * h / (step * step);
    for (const Attachment& attachment : body.constraints.attachments) {
        const size_t i = 4 * size_t{attachment.particle};
        if (around.scene) {
            add_impulse(body, around, attachment.model, body.cloth.origin + get(&body.cloth.at[i]),
                        get(&body.cloth.contacts.pulls[i]) * to_impulse);
        }
    }
}

/// Attached particles move along arcs as their models rotate. Interpolating linearly between two positions on a circle
/// would bring them closer to each other.
void follow_models(Body& body, const CollisionContext& around) {
    gphys_model_id model = 0;
    const PlacedModel* moved = nullptr;
    Transform now;
    for (const Attachment& attachment : body.constraints.attachments) {
        if (attachment.begin == attachment.end) continue;
        Vec3 next = attachment.begin + (attachment.end - attachment.begin) * around.end;
        if (attachment.model != model) {
            model = attachment.model;
            moved = find_moved(around, model);
            if (moved) now = interpolate(moved->world, around.scene->world(model), around.end);
        }
        if (moved && around.end < 1) {
            const Vec3 aside = attachment.begin - widen(moved->world).apply(attachment.local);
            next = now.apply(attachment.local) + aside * (1 - around.end);
        }
        put(&body.cloth.at[4 * size_t{attachment.particle}], next - body.cloth.origin, farthest_in_cloth);
    }
    for (const Attachment& attachment : body.constraints.attachments) {
        put(&body.cloth.contacts.pulls[4 * size_t{attachment.particle}], {}, 0);
    }
}

/// Removes energy from the motion relative to a drift.
void slow_by(Body& body, Vec3 drift, double energy) {
    const double inner = inner_energy_of_cloth(body, drift);
    slow_cloth(body, drift, energy < inner ? std::sqrt(1 - energy / inner) : 0);
}

/// A solid holds cloth in it while the links get their lengths back. That must not make the cloth faster on average
/// than its speed of leaving. `gain`: joules beyond the work of forces in the substep.
void keep_calm(Body& body, double gain) {
    const double calm = body.cloth.average_mass * body.particles.size() * leaving_speed * leaving_speed / 2;
    const double excess = std::min(gain, inner_energy_of_cloth(body, {}) - calm);
    if (excess > 0) slow_by(body, {}, excess);
}

/// In long steps the errors that sweeps over a graph leave can do work. The relative motion within the body is slowed
/// so that the substep gains no energy; the motion of a free body as a whole stays.
void remove_energy(Body& body, double gain) {
    Vec3 drift;
    if (!body.cloth.held) {
        const Motion motion = motion_of_cloth(body);
        drift = motion.momentum / motion.mass;
    }
    slow_by(body, drift, gain);
}

/// Whether all external forces in this substep are known: none, or those of models in contact with a closed body. An
/// open body on models may rotate as a whole by the errors that its sweeps leave.
bool is_accounted_for(const Body& body, bool collides) {
    const ClothContacts& contacts = body.cloth.contacts;
    if (body.cloth.held || body.plan.joined || body.contacts.near) return false;
    if (body.targets.act()) return false;
    if (body.air.blows()) return false;  // the wind's force depends on the velocity that would be restored
    if (!collides || !(contacts.any_active() || contacts.sunk)) return true;
    return body.cloth.volume.held && !contacts.sunk && !contacts.pushed;
}

/// Calls part(its index, first particle, end) in any order.
template <class Part>
void share_parts(const Body& body, Part&& part) {
    constexpr uint32_t together = share_floats / 4;
    share(body.cloth.team, (body.particles.size() + together - 1) / together,
          [&](uint32_t i, uint32_t) { part(i, i * together, std::min(body.particles.size(), (i + 1) * together)); });
}

/// Calls each(particle) in any order.
template <class Each>
void share_particles(const Body& body, Each&& each) {
    share_parts(body, [&](uint32_t, uint32_t first, uint32_t end) {
        for (uint32_t p = first; p < end; ++p) each(p);
    });
}

/// Over all particles; the same however the work is shared.
ClothExtent extent_of(Body& body) {
    Vector<ClothExtent>& parts = body.cloth.extents;
    share_parts(body, [&](uint32_t i, uint32_t first, uint32_t end) {
        ClothExtent extent{{body.particles.position[first], body.particles.position[first]}, 0};
        for (uint32_t p = first; p < end; ++p) {
            extent.box = {min(extent.box.min, body.particles.position[p]),
                          max(extent.box.max, body.particles.position[p])};
            extent.mass += body.particles.mass[p];
        }
        parts[i] = extent;
    });
    ClothExtent all = parts[0];
    for (size_t i = 1; i < parts.size(); ++i) {
        all.box = {min(all.box.min, parts[i].box.min), max(all.box.max, parts[i].box.max)};
        all.mass += parts[i].mass;
    }
    return all;
}

void publish(Body& body) {
    Cloth& cloth = body.cloth;
    share_parts(body, [&](uint32_t i, uint32_t first, uint32_t end) {
        ClothWay way;
        for (uint32_t p = first; p < end; ++p) {
            const Vec3 before = body.particles.position[p];
            body.particles.position[p] = cloth.origin + get(&cloth.at[4 * size_t{p}]);
            body.particles.velocity[p] = get(&cloth.velocity[4 * size_t{p}]);
            keep_in_range(body.particles.position[p], body.particles.velocity[p], before);
            way.add(length_squared(body.particles.position[p] - before));
        }
        cloth.ways[i] = way;
    });
}

/// Calls solve(batch, chains, rows) for each batch: colours one after the other.
template <class Solve>
void solve_colours(Body& body, Solve&& solve) {
    ClothBatches& batches = body.cloth.batches;
    const ClothChains chains = damped_chains_of(batches);
    for (size_t colour = 0; colour + 1 < batches.colours.size(); ++colour) {
        const uint32_t first = batches.colours[colour], end = batches.colours[colour + 1];
        share(body.cloth.team, end - first, [&](uint32_t i, uint32_t member) {
            solve(batches.chains[first + i], chains,
                  &batches.rows[size_t{cloth_row_floats} * batches.longest * member]);
        });
    }
}

ClothLimits limits_of(const ClothBatches& batches) {
    return {batches.limited.data(), batches.anchors.data(), batches.distances.data()};
}

void reach_limits(Body& body) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    const ClothBatches& batches = body.cloth.batches;
    const ClothLimits limits = limits_of(batches);
    for (size_t rank = 0; rank + 1 < batches.ranks.size(); ++rank) {
        const uint32_t first = batches.ranks[rank], count = batches.ranks[rank + 1] - first;
        share(body.cloth.team, (count + share_limits - 1) / share_limits, [&](uint32_t i, uint32_t) {
            const uint32_t from = first + i * share_limits;
            kernels.limit(body.cloth.at.data(),
                          {limits.particles + from, limits.anchors + from, limits.distances + from},
                          std::min(share_limits, first + count - from));
        });
    }
}

}  // namespace

Motion motion_of_cloth(const Body& body) {
    const Cloth& cloth = body.cloth;
    Motion sum;
    for (size_t i = 0; i < 4 * size_t{cloth.particles}; i += 4) {
        sum.add(cloth.acceleration[i + 3] * cloth.average_mass, get(&cloth.velocity[i]));
    }
    return sum;
}

double inner_energy_of_cloth(Body& body, Vec3 drift) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    float common[3];
    put(common, drift, fastest_in_cloth);
    return body.cloth.average_mass *
           sum_of_blocks(body.cloth, [&](const ClothMotion& block) { return kernels.kinetic(block, common); });
}

void slow_cloth(Body& body, Vec3 drift, double kept) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    float common[3];
    put(common, drift, fastest_in_cloth);
    share_motion(body.cloth,
                 [&](const ClothMotion& motion, uint32_t) { kernels.slow(motion, common, static_cast<float>(kept)); });
}

size_t cloth_floats(const Body& body) {
    return (4 * (size_t{body.particles.size()} + body.cloth.batches.spare) + 7) / 8 * 8;
}

void reserve_cloth(Body& body) {
    Cloth& cloth = body.cloth;
    const size_t floats = cloth_floats(body);
    for (Vector<float>* values : {&cloth.at, &cloth.start, &cloth.velocity, &cloth.acceleration}) {
        values->resize(floats);
    }
    cloth.sums.resize((floats + block_floats - 1) / block_floats);
    cloth.stored.resize(body.cloth.batches.chains.size());
    if (cloth.most_strain > 0) {
        cloth.strained.resize(body.cloth.batches.rest.size());
        cloth.waiting.resize(body.cloth.batches.kept.links.size());
        cloth.listed.assign(body.cloth.batches.kept.links.size(), 0);
    }
    cloth.extents.resize((4 * size_t{body.particles.size()} + share_floats - 1) / share_floats);
    cloth.ways.resize(cloth.extents.size());
    if (!body.constraints.attachments.empty()) body.cloth.contacts.pulls.resize(floats);
    if (!body.targets.empty()) {
        body.cloth.contacts.normals.resize(floats);
        body.cloth.contacts.pulls.resize(floats);
    }
    if (body.cloth.volume.held) body.cloth.volume.gradient.resize(body.particles.size());
}

void begin_cloth(Body& body, const CollisionContext& around, Vec3 gravity) {
    Cloth& cloth = body.cloth;
    const ClothExtent extent = extent_of(body);
    if (!keeps_origin(body, extent.box)) {
        cloth.origin = (extent.box.min + extent.box.max) / 2;
        cloth.search_balls.clear();
    }
    cloth.average_mass = extent.mass / body.particles.size();
    cloth.wanted_substep = infinity;
    cloth.balance.current = false;
    cloth.pulled =
        (body.history.earlier_step == 0 && !body.contacts.has_contact) || !body.constraints.length_changes.empty();
    cloth.held = std::find(body.particles.inverse_mass.begin(), body.particles.inverse_mass.end(), 0.0) !=
                 body.particles.inverse_mass.end();
    share_particles(body, [&](uint32_t p) {
        const size_t i = 4 * size_t{p};
        put(&cloth.at[i], body.particles.position[p] - cloth.origin, farthest_in_cloth);
        put(&cloth.velocity[i], body.particles.velocity[p], fastest_in_cloth);
        const bool free = !body.particles.pinned(p);
        const double relative =
            std::clamp(body.particles.mass[p] / cloth.average_mass, 1 / most_mass_ratio, most_mass_ratio);
        cloth.at[i + 3] = free ? static_cast<float>(1 / relative) : 0;
        put(&cloth.acceleration[i], free ? gravity + body.particles.force[p] * body.particles.inverse_mass[p] : Vec3{},
            hardest);
        cloth.acceleration[i + 3] = free ? static_cast<float>(relative) : 0;
    });
    // Particles that do not move are in pairs a metre apart again, because limits on the first of a pair shift it
    // minimally.
    for (Vector<float>* values : {&cloth.at, &cloth.moved, &cloth.velocity, &cloth.velocity_before}) {
        std::fill(values->begin() + 4 * static_cast<std::ptrdiff_t>(body.particles.size()), values->end(), 0.0f);
    }
    for (uint32_t p = 1; p < body.cloth.batches.spare; p += 2) cloth.at[4 * (size_t{body.particles.size()} + p)] = 1;
    cloth.particles = body.particles.size();
    body.cloth.contacts.active.clear();
    if (collides(body, around)) {
        search_cloth_contacts(body, around, gravity);
    } else {
        cloth.search_balls.clear();
        if (!body.targets.empty()) std::fill(cloth.contacts.normals.begin(), cloth.contacts.normals.end(), 0.0f);
    }
}

void predict_cloth(Body& body, const CollisionContext& around, double h) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    Cloth& cloth = body.cloth;
    if (!body.constraints.length_changes.empty()) change_lengths(body, around.end);
    soften(body.cloth.batches, cloth.average_mass,
           TimeScheme(h, body.history.earlier_step).step(body.settings.damping));
    // Moving models and other bodies do work.
    const bool carried = std::any_of(body.constraints.attachments.begin(), body.constraints.attachments.end(),
                                     [](const Attachment& attachment) { return attachment.begin != attachment.end; });
    const bool closed = !carried && !cloth.pulled && !body.targets.moves;
    if (closed && !cloth.balance.current) cloth.balance.stored = stored_energy(kernels, body);
    cloth.balance.closed = closed;
    if (body.air.blows()) blow_cloth(body, around, h);
    predict(kernels, cloth, cloth_step(body, h));
    damp_links(body, TimeScheme(h, body.history.earlier_step));
    follow_models(body, around);
    aim_targets(body, around);
    carry_by_targets(body);
}

void solve_cloth(Body& body) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    ClothBatches& batches = body.cloth.batches;
    ClothContacts& contacts = body.cloth.contacts;
    press_on_targets(body, contacts.any_active());
    const bool has_contact = contacts.any_active() || !body.targets.pressing.empty();
    // Before the chains, which need the volume for their shape, and after them, because they leave an error in it.
    body.cloth.volume.given = 0;
    if (body.cloth.volume.held) solve_volume(body, batches.scale);
    solve_colours(body, [&](const ChainBatch& batch, const ClothChains& chains, float* rows) {
        float* const at = body.cloth.at.data();
        const ClothSurfaces surfaces{contacts.normals.data(), contacts.pulls.data()};
        if (body.plan.joined) {
            kernels.solve_joined(
                at, {body.cloth.tether_diagonal.data(), body.cloth.tether_off.data(), surfaces, has_contact}, chains,
                batch, rows);
        } else if (has_contact) {
            kernels.solve_with_contacts(at, surfaces, chains, batch, rows);
        } else if (batch.attached) {
            kernels.solve_pulling(at, contacts.pulls.data(), chains, batch, rows);
        } else {
            kernels.solve(at, chains, batch, rows);
        }
    });
    if (body.cloth.volume.held) solve_volume(body, batches.scale);
    if (contacts.any_active()) note_places(body);
    if (body.constraints.attachments.empty()) {
        reach_limits(body);
    } else {
        kernels.limit_pulling(body.cloth.at.data(), limits_of(batches), static_cast<uint32_t>(batches.limited.size()),
                              body.cloth.acceleration.data(), contacts.pulls.data());
    }
}

void project_cloth(Body& body) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    solve_colours(body, [&](const ChainBatch& batch, const ClothChains& chains, float* rows) {
        kernels.solve(body.cloth.at.data(), chains, batch, rows);
    });
    reach_limits(body);
}

void finish_cloth(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    Cloth& cloth = body.cloth;
    const TimeScheme scheme(h, body.history.earlier_step);
    const bool collides = gphys::collides(body, around);
    if (!body.constraints.attachments.empty()) add_pull_impulses(body, around, scheme.step(body.settings.damping), h);
    keep_cloth_to_targets(body);
    if (collides) leave_planes(body);
    const ClothStep step = cloth_step(body, h);
    const double gain = sum_of_blocks(cloth, [&](const ClothMotion& block) { return kernels.finish(block, step); });
    cloth.velocity.swap(cloth.velocity_before);
    if (collides) count_contacts(body, around, scheme.next / h);
    const bool captured = capture_limits(body, around, scheme);
    if (body.cloth.contacts.sunk && collides && !cloth.held) keep_calm(body, gain * cloth.average_mass);
    const bool bounded = body.targets.act();
    cloth.balance.closed = cloth.balance.closed && !(collides && body.cloth.contacts.pushed) && !bounded;
    const bool accounted = is_accounted_for(body, collides);
    const double before = cloth.balance.stored;
    if (cloth.balance.closed && !accounted) {
        cloth.balance.stored = stored_energy(kernels, body);
        cloth.balance.gain = (gain + cloth.balance.stored - before) * cloth.average_mass;
        if (cloth.balance.gain > 0 && !body.plan.joined) remove_energy(body, cloth.balance.gain);
    }
    stop_cloth_at_targets(body);
    body.contacts.has_contact = captured || bounded;
    if (collides) {
        body.contacts.has_contact = body.contacts.has_contact || body.cloth.contacts.any_active();
        turn_velocities(body, around, h);
        if (body.cloth.contacts.pushed) ease_links(body);
    }
    if (cloth.most_strain > 0) {
        if (collides) note_places(body);
        const double lost = relax_links(body, collides, h);
        if (collides) stop_taken_back(body, around, h);
        if (lost > 0 && cloth.balance.closed && !accounted) remove_energy(body, lost * cloth.average_mass);
    }
    if (accounted) {
        if (cloth.balance.closed) cloth.balance.stored = stored_energy(kernels, body);
        keep_momentum(body, h, cloth.balance.stored - before);
    }
    if (collides) {
        catch_escaped(body, around, gravity, h);
        if (body.cloth.contacts.sunk) leave_solids(body, h);
    }
    if (cloth.balance.closed && !accounted && !body.plan.joined && !body.cloth.contacts.sunk) {
        // Contact planes and friction only take energy, but pushing particles out of planes raises them.
        const double stored = stored_energy(kernels, body);
        const double all =
            sum_of_blocks(cloth, [&](const ClothMotion& block) { return kernels.gain(block); }) + stored - before;
        if (all > 0) remove_energy(body, all * cloth.average_mass);
        cloth.balance.stored = stored;
    }
    cloth.balance.current = cloth.balance.closed && !collides && (accounted || cloth.most_strain == 0);
    body.history.earlier_step = body.contacts.has_contact ? 0 : h;
}

void end_cloth_substep(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    const bool collides = gphys::collides(body, around);
    body.cloth.contacts.given = body.cloth.contacts.turning = {};
    if (collides) find_active_planes(body, around, gravity, TimeScheme(h, body.history.earlier_step));
    solve_cloth(body);
    finish_cloth(body, around, gravity, h);
}

void move_cloth(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    if (body.cloth.most_strain > 0 && collides(body, around)) search_ahead(body, around, gravity, h);
    predict_cloth(body, around, h);
    end_cloth_substep(body, around, gravity, h);
}

void end_cloth(Body& body, const CollisionContext& around) {
    if (collides(body, around)) record_contact_points(body, around);
    publish(body);
    if (collides(body, around)) keep_planes(body, around);
}

}  // namespace gphys
