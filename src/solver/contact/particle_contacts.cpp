// Contacts between particles: what their pairs make of them in a substep, and relaxation (particle_contacts.h).
#include "solver/contact/particle_contacts.h"

#include "solver/contact/cloth_loads.h"
#include "solver/contact/cluster_contacts.h"
#include "solver/contact/collision.h"
#include "solver/contact/corrections.h"
#include "solver/contact/friction.h"
#include "solver/contact/leave_solids.h"
#include "solver/contact/pair_corrections.h"
#include "solver/contact/particle_pairs.h"
#include "solver/contact/rope_loads.h"
#include "solver/joints/joined_motion.h"
#include "solver/quads.h"
#include "solver/rope/rope.h"

namespace gphys {
namespace {

// Gauss-Seidel sweeps over the contacts of a substep. Each sweep propagates a load by at least one particle, so for a
// deep pile more sweeps and more substeps help equally.
constexpr int sweeps = 4;
// Pairs with a smaller gap, in sums of their radii, are contacts too, because others may press them together.
constexpr double near_gap = 0.02;
// Pairs that overlap at the beginning of a substep separate by at most this much in it, in sums of their radii.
// Separating them at once would give them a high speed.
constexpr double most_correction = 0.1;
// Of a pair with a free particle, a small overlap is an error of the sweeps, which the next ones correct with the
// velocities: without these, deep heaps would sink into themselves. It is what the sweeps leave of the fall of as many
// layers in a substep, and at least a part of the sum of the radii. The rest was there before, as a deep overlap was,
// so what removes it gives no speed: it moves the free particle, because links would turn every correction into speed.
constexpr double fallen_layers = 16;
constexpr double least_error = 1e-3, shallow_overlap = 0.03, deep_overlap = 0.06;  // in sums of the radii

/// 1 for an overlap that may be an error of the sweeps, 0 for a deep one.
double shallowness(double overlap, double radii) {
    if (overlap <= shallow_overlap * radii) return 1;  // radii may be 0
    return std::max(0.0, (deep_overlap - overlap / radii) / (deep_overlap - shallow_overlap));
}

double error_of_sweeps(double overlap, double radii, Vec3 gravity, double h) {
    const double fallen = fallen_layers * length(gravity) * h * h * shallowness(overlap, radii);
    return std::clamp(fallen, least_error * radii, most_correction * radii);
}

Vec3 velocity_of(const Body& body, uint32_t p) {
    return is_graph(body) ? get(&body.cloth.state.velocity[4 * size_t{p}]) : body.particles.velocity[p];
}

/// Where a particle of cloth was at the beginning of the substep.
Vec3 start_of(const Body& body, uint32_t p) {
    return body.cloth.state.origin + get(&body.cloth.state.start[4 * size_t{p}]);
}

/// Whether a particle has moved farther than its velocities take it: a model that it was in has moved it at once. Then
/// its way is no motion, with which it would hit others.
bool was_pushed_out(Vec3 way, Vec3 velocity_before, Vec3 velocity, double h) {
    const double fastest = std::max(length_squared(velocity_before), length_squared(velocity));
    return length_squared(way) > 1.01 * 1.01 * h * h * fastest;
}

/// A unit direction for a pair at one point. Different pairs have different directions, so that a pile spreads in all
/// directions. The direction depends on the indices alone and has the same bits on each machine; no component is 0.
Vec3 direction_of_pair(uint32_t a, uint32_t b) {
    constexpr int bits = 21;
    const uint64_t key = mixed(mixed(mixed(0, a), b), 0);
    const auto component = [&](int k) {
        const uint64_t part = (key >> (bits * k)) & ((uint64_t{1} << bits) - 1);
        return (static_cast<double>(part) + 0.5) / (1 << (bits - 1)) - 1;
    };
    const Vec3 direction{component(0), component(1), component(2)};
    return direction / length(direction);
}

/// The time at which two points, whose difference goes from `from` to `to`, are first as close as `reach`; above 1:
/// never.
double time_of_impact(Vec3 from, Vec3 to, double reach) {
    const Vec3 motion = to - from;
    const double a = length_squared(motion), b = dot(from, motion), c = length_squared(from) - reach * reach;
    if (c <= 0) return 0;
    const double discriminant = b * b - a * c;
    if (b >= 0 || discriminant < 0) return infinity;
    return c / (-b + std::sqrt(discriminant));
}

}  // namespace

Vec3 place_of(const Body& body, uint32_t p) {
    return is_graph(body) ? body.cloth.state.origin + get(&body.cloth.state.at[4 * size_t{p}])
                          : body.particles.position[p];
}

void ParticleContacts::reserve(const BodyTable& bodies, Vector<Island>& islands,
                               const Vector<uint32_t>& island_bodies) {
    uint32_t total = 0, most = 0, groups = 0, clusters = 0, pairs = 0, rows = 0;
    for (Island& island : islands) {
        island.first_particle = total;
        island.colliding_count = 0;
        for (uint32_t i = 0; i < island.body_count; ++i) {
            const Body& body = bodies[island_bodies[island.first_body + i]];
            if (collides_with_others(body)) island.colliding_count += body.particles.size();
        }
        total += island.colliding_count;
        island.first_group = groups;
        groups += group_count(island.colliding_count);
        island.first_cluster = clusters;
        island.first_rigid_pair = pairs;
        island.first_row = rows;
        ClusterContacts::count(island, bodies, &island_bodies[island.first_body]);
        clusters += island.cluster_count;
        const uint32_t* const first_slot = &island_bodies[island.first_body];
        island.unequal = has_unequal_balls(bodies, first_slot, first_slot + island.body_count);
        if (island.unequal) {
            const uint32_t most = contacts_per_particle * island.colliding_count;
            island.rigid_pair_count = std::max(1u, island.rigid_pair_count) + most;
            island.row_count += most;
        }
        pairs += island.rigid_pair_count;
        rows += island.row_count;
    }
    // Which bodies are near each other changes from step to step, so there is room for all that may collide.
    for (const Body& body : bodies) most += collides_with_others(body) ? body.particles.size() : 0;
    particles_.resize(most);
    pairs_.resize(size_t{most} * pairs_per_particle);
    contacts_.resize(size_t{most} * contacts_per_particle);
    buckets_.resize(size_t{most} * 4);
    sorted_.resize(most);
    keys_.resize(most);
    supports_.resize(most);
    order_.resize(most);
    groups_.resize(groups);
    clusters_.resize(clusters);
    rigid_pairs_.resize(pairs);
    rigid_groups_.resize(size_t{pairs} + clusters);
    rows_.resize(rows);
    listed_.reserve(most);
}

void ParticleContacts::begin_step(const IdTable& ids, const BodyTable& bodies, const Vector<Island>& islands) noexcept {
    uint32_t moving = 0;
    for (const Island& island : islands) moving += island.colliding_count;
    listed_.begin_step(ids, bodies, moving);
}

ParticleContacts::Range ParticleContacts::range(const Island& island) {
    const size_t first = island.first_particle;
    uint32_t table = 1;
    while (table < 2 * island.colliding_count) table *= 2;  // with its end, at most four times the particles
    return {&particles_[first],
            island.colliding_count,
            &pairs_[first * pairs_per_particle],
            &contacts_[first * contacts_per_particle],
            &buckets_[first * 4],
            table,
            &sorted_[first],
            &keys_[first],
            &supports_[first],
            &order_[first],
            &groups_[island.first_group],
            group_count(island.colliding_count),
            island.team,
            listed_.of_island(island.first_particle, island.colliding_count),
            clusters_.data() + island.first_cluster,
            island.cluster_count,
            rigid_pairs_.data() + island.first_rigid_pair,
            island.rigid_pair_count,
            {rows_.data() + island.first_row, island.row_count,
             rigid_groups_.data() + island.first_rigid_pair + island.first_cluster,
             island.rigid_pair_count + island.cluster_count},
            island.unequal,
            island.beside_joints};
}

void ParticleContacts::begin(const Island& island, const IdTable& ids, const BodyTable& bodies, const uint32_t* slots) {
    const Range range = this->range(island);
    Particle* next = range.particles;
    ContactCluster* cluster = range.clusters;
    for (uint32_t i = 0; i < island.body_count; ++i) {
        const Body& body = bodies[slots[i]];
        if (!collides_with_others(body)) continue;
        Particle* const of_body = next;
        for (uint32_t p = 0; p < body.particles.size(); ++p, ++next) {
            *next = {};
            next->body = slots[i];
            next->number = p;
            next->id = ids.id(slots[i]);
            next->radius = body.particles.radius[p];
            next->margin = -1;  // in no list yet
            next->at = place_of(body, p);
            next->velocity = velocity_of(body, p);
        }
        ClusterContacts::list(body, range, of_body, cluster);
    }
    std::fill(range.groups, range.groups + range.group_count, Group{});
    range.listed.clear();
}

void ParticleContacts::gather(const Range& range, const BodyTable& bodies, double h) const {
    share_particles(range, [&](uint32_t first, uint32_t end) {
        for (uint32_t i = first; i < end; ++i) {
            Particle& p = range.particles[i];
            const Body& body = bodies[p.body];
            p.before = p.at;
            p.at = p.uncorrected = place_of(body, p.number);
            const Vec3 velocity_before = p.velocity;
            p.velocity = p.uncorrected_velocity = velocity_of(body, p.number);
            // The shape, links and models, or joints that closed, have moved it after the contacts of the last substep.
            if (p.cluster || body.contacts.closed) {
                p.before = is_graph(body) ? start_of(body, p.number) : body.history.start[p.number];
            }
            if (moves_freely(body) && was_pushed_out(p.at - p.before, velocity_before, p.velocity, h))
                p.before = p.at - p.velocity * h;
            p.inverse_mass = body.particles.inverse_mass[p.number];
        }
    });
}

/// Finds the models under the particles of pairs.
void ParticleContacts::find_supports(const Range& range, const BodyTable& bodies,
                                     const CollisionContext& around) const {
    share_particles(range, [&](uint32_t first, uint32_t end) {
        for (uint32_t i = first; i < end; ++i) {
            Particle& p = range.particles[i];
            Supports& supports = range.supports[i];
            const Body& body = bodies[p.body];
            p.supports = p.paired && !p.cluster && supports.find_for_positions(body, p.number, p.at, around) ? &supports
                                                                                                             : nullptr;
            p.uncorrected = p.at;
        }
    });
}

/// Returns whether many pairs overlap deeply: more than one contact in one_deep_of.
bool ParticleContacts::find_contacts(const Range& range, const BodyTable& bodies, bool final, Vec3 gravity,
                                     double h) const {
    const double bounce_threshold = find_bounce_threshold(gravity, h);
    fill_groups(range, &Group::contacts, contacts_per_particle, [&](Group& group, uint32_t begin, uint32_t room) {
        uint32_t found = 0;
        group.deep = 0;
        group.overlapping = group.sinking = false;
        for (uint32_t i = 0; i < group.pairs.count; ++i) {
            const Pair& pair = range.pairs[group.pairs.begin + i];
            const Particle &a = range.particles[pair.a], &b = range.particles[pair.b];
            const double radii = a.radius + b.radius;
            const Vec3 before = b.before - a.before, now = b.at - a.at;
            const double t = time_of_impact(before, now, radii);
            if (t > 1 && length_squared(now) > radii * radii * (1 + near_gap) * (1 + near_gap)) continue;
            if (found++ >= room) continue;
            if (length_squared(before) < radii * radii * (1 - deep) * (1 - deep)) ++group.deep;
            const Vec3 at_impact = t > 1 ? now : before + (now - before) * t;
            const double length = gphys::length(at_impact);
            const Vec3 normal = length > 0 ? at_impact / length : direction_of_pair(pair.a, pair.b);
            const Body &of_a = bodies[a.body], &of_b = bodies[b.body];
            const double all_overlap = radii - gphys::length(before);
            const bool a_is_free = moves_freely(of_a), b_is_free = moves_freely(of_b);
            const bool both_free = a_is_free && b_is_free;
            const double error = both_free ? error_of_sweeps(all_overlap, radii, gravity, h) : least_error * radii;
            const double overlap = all_overlap - error;
            const bool stays = !final && overlap > 0 && (a_is_free || b_is_free);
            group.overlapping = group.overlapping || stays;
            group.sinking = group.sinking || (stays && both_free);
            // The speed at the time of impact. The speed at the end of the substep is larger, and with it particles
            // would bounce for ever.
            const Vec3 at_end = b.velocity - a.velocity, gained = (at_end - (now - before) / h) * 2;
            const double approach = -dot(at_end - gained * (1 - std::min(t, 1.0)), normal);
            const double restitution = std::sqrt(of_a.settings.restitution * of_b.settings.restitution);
            const double friction = std::sqrt(friction_coefficients(of_a, a.number).kinetic *
                                              friction_coefficients(of_b, b.number).kinetic);
            const double inverse_mass = a.inverse_mass + b.inverse_mass;
            const bool rigid = a.cluster || b.cluster;
            const double closing = dot(before - now, normal),
                         in_full = std::max(0.0, closing) + most_correction * radii;
            double most_separation = in_full;
            if (rigid && !final) {
                // Links have moved cloth since the last contacts. That is no motion, either, and with a model behind it
                // the cloth would throw the cluster.
                const auto start = [](const Body& body, const Particle& p) {
                    return p.supports && is_graph(body) ? start_of(body, p.number) : p.before;
                };
                const double closing = dot(start(of_b, b) - start(of_a, a) - now, normal);
                // What removes their overlap becomes speed: no more than gravity gives them. The rest is removed at the
                // end of the step. That does not move what is joined, of which small overlaps are errors of the sweeps,
                // unless joints have closed in this step.
                const bool joined =
                    (of_a.plan.joined || of_b.plan.joined) && !of_a.contacts.closed && !of_b.contacts.closed;
                const double slow = std::max(0.0, closing + gphys::length(gravity) * h * h);
                most_separation = joined ? slow + (in_full - slow) * shallowness(all_overlap, radii) : slow;
            }
            range.contacts[begin + found - 1] = {pair.a,
                                                 pair.b,
                                                 both_free,
                                                 rigid,
                                                 normal,
                                                 stays ? radii - overlap : radii,
                                                 std::clamp(overlap, 0.0, most_correction * radii - error),
                                                 a.inverse_mass / inverse_mass,
                                                 b.inverse_mass / inverse_mass,
                                                 friction,
                                                 approach > bounce_threshold ? restitution * approach : 0,
                                                 0,
                                                 0,
                                                 0,
                                                 most_separation,
                                                 0,
                                                 0,
                                                 0};
        }
        return found;
    });
    uint64_t contacts = 0, deep_contacts = 0;
    for (uint32_t i = 0; i < range.group_count; ++i) {
        contacts += range.groups[i].contacts.count;
        deep_contacts += range.groups[i].deep;
    }
    return deep_contacts * one_deep_of > contacts;
}

namespace {

/// For particles of a rope that have moved with the cloth on which they press: without their lengths, rigid links would
/// turn the difference into speed.
template <class Particle>
void displace_loaded_rope(const Particle* first, const Particle* end, Body& body, const CollisionContext& around,
                          double h) {
    bool any = false;
    each_moved(first, end, [&](uint32_t, Vec3) { any = true; });
    if (!any) return;  // its motion goes on
    body.history.start = body.particles.position;
    each_moved(first, end, [&](uint32_t p, Vec3 displacement) { body.particles.position[p] += displacement; });
    const Vector<double>& compliance = body.plan.compliance;
    if (std::any_of(compliance.begin(), compliance.end(), [](double c) { return c > 0; })) {
        end_leaving(body, around, true);
    } else {
        restore_lengths(body, around, h);
    }
}

}  // namespace

/// Adds an impulse, newton seconds, to that of a pair in the list. The normal goes from its first particle to the
/// second.
void ParticleContacts::add_to_list(const Range& range, Pair& pair, Vec3 normal, double impulse) {
    const Particle &a = range.particles[pair.a], &b = range.particles[pair.b];
    if (pair.listed == IslandContacts::none) pair.listed = range.listed.add({a.id, a.number, b.id, b.number, {}, 0});
    if (pair.listed == IslandContacts::none) return;
    BodyContact& listed = range.listed[pair.listed];
    listed.normal = narrow(normal);
    if (impulse > 0) listed.impulse = to_float(static_cast<double>(listed.impulse) + impulse);
}

/// For pairs of different bodies that have been separated in this substep: adds `change` of their contact, times
/// `rate`, to their impulse.
void ParticleContacts::add_impulses(const Range& range, double (Contact::*change)() const, double rate) const {
    each_between_bodies(range, [&](Pair& pair, const Contact& contact) {
        if (!(contact.all_separation() > 0)) return;
        const double inverse_mass = range.particles[contact.a].inverse_mass + range.particles[contact.b].inverse_mass;
        add_to_list(range, pair, contact.normal, (contact.*change)() * rate / inverse_mass);
    });
}

/// Adds the impulses of what the sweeps have pressed onto models.
void ParticleContacts::add_support_impulses(const Island& island, BodyTable& bodies, const uint32_t* slots,
                                            const CollisionContext& around, double rate) {
    each_body(island, bodies, slots, [&](Body& body, const Particle* first, const Particle* end) {
        SupportImpulses impulses(body, around, rate);
        for (const Particle* p = first; p != end; ++p) {
            if (p->supports) impulses.add(p->number, place_of(body, p->number), *p->supports);
        }
        impulses.end();
    });
}

void ParticleContacts::move_loads(const Island& island, BodyTable& bodies, const uint32_t* slots, const Joined& joined,
                                  const CollisionContext& around, Vec3 gravity, double h, FlightPlanes* planes) {
    const Range range = this->range(island);
    ClothLoads loads(range, island, bodies, slots);
    if (!loads.any()) return;
    each_body(island, bodies, slots, [&](Body& body, Particle* first, Particle* end) {
        if (!HeavyBodies::may_press(body)) return;
        for (Particle* p = first; p != end; ++p) p->at = p->uncorrected = place_of(body, p->number);
    });
    loads.move(joined, around, gravity);
    const double bounce_threshold = find_bounce_threshold(gravity, h);
    each_body(island, bodies, slots, [&](Body& body, const Particle* first, const Particle* end) {
        if (!HeavyBodies::may_press(body)) return;
        if (body.plan.method == GPHYS_SOLVE_DIRECT) {
            displace_loaded_rope(first, end, body, around, h);
        } else {
            correct_moved(first, end, body, around, bounce_threshold, planes, island.team);
        }
    });
}

void ParticleContacts::move_loads_of_ropes(const Island& island, BodyTable& bodies, const uint32_t* slots,
                                           const CollisionContext& around, Vec3 gravity, double h,
                                           FlightPlanes* planes) {
    const Range range = this->range(island);
    RopeLoads loads(range, island, bodies, slots);
    if (!loads.any()) return;
    const auto each_load = [&](auto&& visit) {
        each_body(island, bodies, slots, [&](Body& body, Particle* first, Particle* end) {
            if (RopeLoads::may_press(body)) visit(body, first, end);
        });
    };
    each_load([](Body& body, Particle* first, Particle* end) {
        for (Particle* p = first; p != end; ++p) p->at = p->uncorrected = place_of(body, p->number);
    });
    loads.move(around);
    const double bounce_threshold = find_bounce_threshold(gravity, h);
    each_load([&](Body& body, const Particle* first, const Particle* end) {
        correct_moved(first, end, body, around, bounce_threshold, planes, island.team);
    });
}

/// Removes what was too near at the beginning of the substep, without speed.
void ParticleContacts::separate_overlapping(const Island& island, BodyTable& bodies, const uint32_t* slots,
                                            const CollisionContext& around, double bounce_threshold,
                                            FlightPlanes* planes) {
    each_body(island, bodies, slots, [&](Body& body, Particle* first, Particle* end) {
        for (Particle* p = first; p != end; ++p) p->at = p->uncorrected = place_of(body, p->number);
    });
    sweep(range(island), sweeps, [&](Contact& contact, Particle& a, Particle& b) {
        const double correction = contact.radii + contact.overlap - dot(b.at - a.at, contact.normal);
        if (correction <= 0) return;
        const bool a_is_free = moves_freely(bodies[a.body]), b_is_free = moves_freely(bodies[b.body]);
        if (a_is_free) a.at -= contact.normal * (b_is_free ? correction * contact.part_of_a : correction);
        if (b_is_free) b.at += contact.normal * (a_is_free ? correction * contact.part_of_b : correction);
    });
    each_body(island, bodies, slots, [&](Body& body, const Particle* first, const Particle* end) {
        correct_moved(first, end, body, around, bounce_threshold, planes, island.team);
    });
}

ParticleContacts::Found ParticleContacts::solve_contacts(const Island& island, const BodyTable& bodies,
                                                         const Joined* joined, const CollisionContext& around,
                                                         Vec3 gravity, double h) {
    const Range range = this->range(island);
    gather(range, bodies, h);
    if (!list_is_valid(range)) find_pairs(range, bodies);
    find_supports(range, bodies, around);
    const bool any_deep = find_contacts(range, bodies, !joined, gravity, h);
    Found found{false, false, any_deep};
    bool sinking = false;
    for (const Group* group = range.groups; group != range.groups + range.group_count; ++group) {
        found.any = found.any || group->contacts.count > 0;
        found.overlapping = found.overlapping || group->overlapping;
        sinking = sinking || group->sinking;
    }
    // Overlaps tell that the sweeps have not sufficed.
    const int times = sinking ? 2 * sweeps : sweeps;
    if (range.unequal && couple_unequal(range)) {
        solve_coupled_positions(range, bodies, joined, around, times, gravity, h);
        if (!have_thrown(range, &Particle::at, &Particle::uncorrected, &Particle::before)) return found;
        uncouple_unequal(range);
        for (Particle* p = range.particles; p != range.particles + range.count; ++p) p->at = p->uncorrected;
        find_supports(range, bodies, around);
    }
    if (range.cluster_count == 0) {
        sweep(range, times, [](Contact& contact, Particle& a, Particle& b) { solve_position(contact, a, b); });
    } else {
        solve_coupled_positions(range, bodies, joined, around, times, gravity, h);
    }
    return found;
}

void ParticleContacts::solve_coupled_positions(const Range& range, const BodyTable& bodies, const Joined* joined,
                                               const CollisionContext& around, int times, Vec3 gravity, double h) {
    ClusterContacts clusters(range, bodies, around.end - around.begin);
    clusters.begin_positions(joined, around, gravity, h);
    clusters.solve(times, clusters.tolerance(gravity, h), [](Contact& contact, Particle& a, Particle& b) {
        if (!contact.rigid) solve_position(contact, a, b);
    });
    clusters.end_positions();
}

void ParticleContacts::solve_positions(const Island& island, BodyTable& bodies, const uint32_t* slots,
                                       const Joined& joined, const CollisionContext& around, Vec3 gravity, double h,
                                       FlightPlanes* planes) {
    const double bounce_threshold = find_bounce_threshold(gravity, h);
    const Found contacts = solve_contacts(island, bodies, &joined, around, gravity, h);
    const Range range = this->range(island);
    // Separating deep pairs changes no velocity, so it transfers no impulse.
    if (contacts.any && island.body_count > 1) add_impulses(range, &Contact::all_separation, contacts.deep ? 0 : 1 / h);
    if (contacts.any && !contacts.deep) {
        add_support_impulses(island, bodies, slots, around, 1 / h);
        ClusterContacts(range, bodies, around.end - around.begin).press_models_by_places(bodies, around, 1 / h);
    }
    for (const Group* group = range.groups; group != range.groups + range.group_count; ++group) {
        for (uint32_t i = group->pairs.begin; i < group->pairs.begin + group->pairs.count; ++i) {
            for (const uint32_t p : {range.pairs[i].a, range.pairs[i].b})
                bodies[range.particles[p].body].contacts.near = true;
            if (island.body_count == 1) break;
        }
    }
    each_body(island, bodies, slots, [&](Body& body, const Particle* first, const Particle* end) {
        if (body.contacts.near) body.cloth.balance.closed = false;  // others do work
        if (!contacts.any) return;
        if (!moves_freely(body)) {
            correct_predicted(first, end, body, h);
            return;
        }
        // If many pairs overlap deeply, the correction changes no velocities, because it would give the particles high
        // speeds. Approaching pairs are stopped by solve_velocities.
        if (!contacts.deep)
            each_moved(first, end, [&](uint32_t p, Vec3 change) { body.particles.velocity[p] += change / h; });
        correct_moved(first, end, body, around, bounce_threshold, planes, island.team);
    });
    if (contacts.overlapping) separate_overlapping(island, bodies, slots, around, bounce_threshold, planes);
    if (contacts.any && !contacts.deep && island.body_count > 1) {
        ClothLoads(range, island, bodies, slots).find(gravity, h);
        RopeLoads(range, island, bodies, slots).find(gravity, h);
    }
}

void ParticleContacts::solve_velocities(const Island& island, BodyTable& bodies, const uint32_t* slots,
                                        const Joined& joined, const CollisionContext& around, Vec3 gravity, double h) {
    const Range range = this->range(island);
    share_particles(range, [&](uint32_t first, uint32_t end) {
        for (uint32_t i = first; i < end; ++i) {
            Particle& p = range.particles[i];
            const Body& body = bodies[p.body];
            p.velocity = p.uncorrected_velocity = velocity_of(body, p.number);
            Supports& supports = range.supports[i];
            const Vec3 at = place_of(body, p.number);
            const bool any = (p.cluster ? p.cluster->active : p.paired) &&
                             supports.find_for_velocities(body, p.number, at, p.velocity, around, gravity);
            p.supports = any ? &supports : nullptr;
        }
    });
    const bool coupled = range.unequal && any_contact(range, [](const Contact& contact) { return contact.rigid; });
    if (range.cluster_count == 0 && !coupled) {
        sweep(range, sweeps, [](Contact& contact, Particle& a, Particle& b) { solve_velocity(contact, a, b); });
    } else {
        ClusterContacts clusters(range, bodies, around.end - around.begin);
        const double tolerance = clusters.tolerance(gravity, h) / h;
        // What is coupled may be thrown, and then the velocities from before are kept.
        clusters.begin_velocities(coupled ? nullptr : &joined, tolerance);
        clusters.solve(sweeps, tolerance, [](Contact& contact, Particle& a, Particle& b) {
            if (!contact.rigid) solve_velocity(contact, a, b);
        });
        clusters.end_velocities();
        clusters.press_models_by_velocities(bodies, around);
        if (coupled && have_thrown(range, &Particle::velocity, &Particle::uncorrected_velocity, nullptr)) {
            uncouple_unequal(range);
            for (Particle* p = range.particles; p != range.particles + range.count; ++p) {
                p->velocity = p->uncorrected_velocity;
                p->supports = nullptr;
            }
        }
    }
    if (island.body_count > 1) add_impulses(range, &Contact::all_change, 1);
    add_support_impulses(island, bodies, slots, around, 1);
    share_particles(range, [&](uint32_t first, uint32_t end) {
        for (uint32_t i = first; i < end; ++i) {
            const Particle& p = range.particles[i];
            if (p.velocity == p.uncorrected_velocity) continue;
            Body& body = bodies[p.body];
            if (is_graph(body)) {
                put(&body.cloth.state.velocity[4 * size_t{p.number}], p.velocity);
            } else {
                body.particles.velocity[p.number] = p.velocity;
            }
        }
    });
    change_joined_velocities(joined);
    each_body(island, bodies, slots, [&](Body& body, const Particle*, const Particle*) {
        if (!body.contacts.near) return;
        // Motion with contacts is not smooth, so the time scheme must not use its history.
        body.contacts.near = false;
        body.contacts.has_contact = true;
        body.history.earlier_step = 0;
    });
}

void ParticleContacts::solve_final_positions(const Island& island, BodyTable& bodies, const uint32_t* slots,
                                             const CollisionContext& around, Vec3 gravity, double h) {
    const double bounce_threshold = find_bounce_threshold(gravity, h);
    CollisionContext ended = around;  // nothing moves any more
    ended.begin = ended.end;
    if (!solve_contacts(island, bodies, nullptr, ended, gravity, h).any) return;
    each_body(island, bodies, slots, [&](Body& body, const Particle* first, const Particle* end) {
        if (!moves_freely(body)) correct_moved(first, end, body, around, bounce_threshold, nullptr, nullptr);
    });
}

}  // namespace gphys
