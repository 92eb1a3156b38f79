// When cloth settles (settling.h). Speeds are compared with that after a fall by the length of a link, so units do not
// matter.
#include "solver/cloth/settling.h"

#include "solver/body.h"
#include "solver/cloth/whole_motion_kernels.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// Seconds that a body has been settling: until then the damping grows; from then on displacements fade; the end.
constexpr double full_damping = 0.5, fading = 0.7, settled = 1.2;
// On models that move displacements fade to this part. With less, what hangs down would not follow a model that tilts
// slowly; with more, it moves by more than some millimetres a second.
constexpr double kept_on_moving = 0.1, settled_on_moving = settled - kept_on_moving * (settled - fading);
// What moves with a model while it settles needs no friction for that. So it does not settle while the model changes
// its velocity by more than this part of gravity, where friction might not suffice.
constexpr double most_acceleration = 0.1;
// 1/s. A flap of half a metre swings at 5 rad/s, and so comes to rest soonest.
constexpr double most_damping = 10;
// What its root mean square speed may be, and that of a single particle relative to this. Sheets on models were seen to
// keep moving at 0.04 on average.
constexpr double slow = 0.07, most = 10;
// The same of cloth that hangs, and by what factor its velocities must differ from the distances that its particles
// have moved: of cloth that swings both are the same.
constexpr double slow_hanging = 0.015, differs = 2;
// What hangs at a root mean square speed below this rests already.
constexpr double resting = 1e-3;
// What the speed of its middle may be, averaged over some time. It tells sagging, toppling and sliding from moving back
// and forth: a sheet that folds up slowly before it falls over is at 0.01.
constexpr double drift = 0.009, drift_time = 0.5;
// Less motion than this part of the displacements is not expected of it while they fade: particles that collide with
// one another move after links and contacts.
constexpr double least_kept = 0.1;
// The part of the particles in contact that friction holds. Links pull others over the models back and forth; of a body
// that slides it holds none.
constexpr double least_held = 0.2;
// The strain that it may have, relative to that which relax_links leaves.
constexpr double most_strain = 1.5;
// How much faster it stops settling than it settles, if it moves.
constexpr double return_rate = 4;

/// Whether nothing acts on it but gravity, links and models. What rolls is left out.
bool is_left_alone(const Body& body) {
    return is_graph(body) && !body.plan.joined && body.targets.empty() && !body.air.blows() &&
           !body.cloth.volume.held && body.cloth.clusters.empty();
}

/// Whether friction holds enough of the particles in contact that counts(contact) is true for.
template <class Counts>
bool is_held(const ClothContacts& contacts, const Counts& counts) {
    if (!contacts.any_active()) return false;
    const auto held = std::count_if(contacts.active.begin(), contacts.active.end(), [&](uint32_t number) {
        return contacts.candidates[number].held && counts(contacts.candidates[number]);
    });
    return static_cast<double>(held) >= least_held * static_cast<double>(contacts.active.size());
}

bool is_held(const ClothContacts& contacts) {
    return is_held(contacts, [](const ClothContact&) { return true; });
}

/// Whether friction holds enough particles that had the velocities of their models before the substep, too.
bool goes_along(const Body& body) {
    const ClothState& state = body.cloth.state;
    const double most = body.cloth.settling.most_jump;
    return is_held(body.cloth.contacts, [&](const ClothContact& n) {
        const size_t i = 4 * size_t{n.particle};
        return length_squared(get(&state.velocity[i]) - get(&state.velocity_before[i])) <= most * most;
    });
}

double speed_of_fall(const Body& body, double gravity) {
    return std::sqrt(2 * gravity * body.cloth.batches.link_length);
}

/// Metres by which particles move in a step at a part of the speed after such a fall, while displacements fade as they
/// do.
double way_at(const Body& body, double part, double gravity, double dt) {
    return part * speed_of_fall(body, gravity) * dt * std::max(least_kept, body.cloth.settling.kept);
}

bool is_slow(const Body& body, const ClothTravel& travel, double slow, double gravity, double dt) {
    const double way = way_at(body, slow, gravity, dt);
    return travel.sum <= way * way * body.particles.size() && travel.longest <= most * most * way * way &&
           length(body.sleep.drift) <= drift * speed_of_fall(body, gravity);
}

/// Whether pins that stand still hold it, and its velocities are not those of its motion. Where pins are closer
/// together than the links between them, for instance, chains move particles in each substep and relaxation moves them
/// back. Then velocities show what is undone, or none is left where the energy of these moves is taken from all motion.
bool moves_in_place(const Body& body, const ClothTravel& travel, double gravity, double dt) {
    if (body.cloth.state.held.empty() || are_carried(body.constraints)) return false;
    double sum = 0;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        const double square = length_squared(body.particles.velocity[p]);
        if (body.particles.pinned(p) && square > 0) return false;
        sum += square;
    }
    sum *= dt * dt;
    const double larger = std::max(sum, travel.sum), smaller = std::min(sum, travel.sum),
                 least = way_at(body, resting, gravity, dt);
    return larger >= differs * differs * smaller && larger >= least * least * body.particles.size();
}

/// Whether it hardly moves, and what holds it will keep it where it is.
bool may_settle(const Body& body, const ClothTravel& travel, double gravity, double dt) {
    const ClothContacts& contacts = body.cloth.contacts;
    if ((contacts.has_moving_model && !body.cloth.settling.carried) || contacts.penetrating) return false;
    if (is_held(contacts))
        return is_slow(body, travel, slow, gravity, dt) &&
               is_hardly_strained(body, most_strain * body.cloth.relaxation.most_strain);
    return is_slow(body, travel, slow_hanging, gravity, dt) && moves_in_place(body, travel, gravity, dt);
}

/// Whether models can carry it: nothing else moves it, and they move rigidly and nearly together.
bool can_be_carried(const Body& body, double gravity, double dt) {
    const Carriers& carriers = body.cloth.settling.carriers;
    return body.cloth.state.held.empty() && carriers.rigid &&
           carriers.apart <= slow * speed_of_fall(body, gravity) * dt;
}

/// What settle does, relative to the motion of models.
void settle_on_moving(Body& body, float speed, float way, double h) {
    ClothState& state = body.cloth.state;
    const ClothContacts& contacts = body.cloth.contacts;
    const WholeMotionKernels& kernels = whole_motion_kernels(chosen_isa());
    const uint32_t first = body.cloth.settling.carriers.first;
    const RigidDisplacement of_first = displacement_in_substep(body, first);
    share_motion(state, body.cloth.shares.team, [&](const ClothMotion& motion, uint32_t) {
        kernels.settle(motion, speed, way, of_first.turn, of_first.shift, 1 / h);
    });
    if (body.cloth.settling.carriers.apart == 0) return;
    for (const uint32_t number : contacts.active) {
        const ClothContact& n = contacts.candidates[number];
        const uint32_t other = n.planes[n.active_plane].moving_collider;
        if (other == first) continue;
        const size_t i = 4 * size_t{n.particle};
        const Vec3 start = get(&state.start[i]);
        const Vec3 more = displacement_in_substep(body, other).of(start) - of_first.of(start);
        put(&state.at[i], get(&state.at[i]) + more * (1 - double{way}));
        put(&state.velocity[i], get(&state.velocity[i]) + more * ((1 - double{speed}) / h));
    }
}

}  // namespace

void begin_settling(Body& body, const CollisionContext& around, Vec3 gravity) {
    Sleep& sleep = body.sleep;
    Settling& settling = body.cloth.settling;
    settling.carriers = find_carriers(body, around);
    bool is_left = !settling.carriers.move && !are_carried(body.constraints), have_moved = settling.carriers.move;
    if (is_left && sleep.settling > 0) {
        const uint64_t support = models_around(body, around.scene);
        have_moved = sleep.support == ~support;  // see note_settling
        is_left = sleep.support == support;
    }
    settling.carried = have_moved && can_be_carried(body, length(gravity), around.step_time);
    settling.most_jump = most_acceleration * length(gravity) * around.step_time;
    if (!is_left && !settling.carried) sleep.settling = 0;
    if (settling.carried) sleep.settling = std::min(sleep.settling, settled_on_moving);
    settling.damping = most_damping * std::min(1.0, sleep.settling / full_damping);
    settling.kept = std::clamp((settled - sleep.settling) / (settled - fading), 0.0, 1.0);
}

void settle(Body& body, double h) {
    Settling& settling = body.cloth.settling;
    if (!settling.acts()) return;
    if (settling.carried && !goes_along(body)) {
        body.sleep.settling = settling.damping = 0;
        settling.kept = 1;
        return;
    }
    const float way = static_cast<float>(settling.kept),
                speed = settling.kept > 0 ? static_cast<float>(1 / (1 + settling.damping * h)) : 0;
    if (settling.carried) return settle_on_moving(body, speed, way, h);
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    share_motion(body.cloth.state, body.cloth.shares.team,
                 [&](const ClothMotion& motion, uint32_t) { kernels.settle(motion, speed, way); });
}

void note_travel(Body& body) {
    Settling& settling = body.cloth.settling;
    if (!settling.carried) return;
    const ClothState& state = body.cloth.state;
    settling.travelled = {};
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        const Vec3 start = body.particles.position[p] - state.origin;
        settling.travelled.add(get(&state.at[4 * size_t{p}]) - start - settling.carriers.of_first.of(start));
    }
}

void note_settling(Body& body, const Scene* scene, Vec3 gravity, double dt, bool alone) {
    Sleep& sleep = body.sleep;
    if (!alone || !is_left_alone(body)) {
        sleep.settling = 0;
        sleep.drift = {};
        return;
    }
    const Settling& settling = body.cloth.settling;
    if (settling.kept == 0) return;  // it lies still until something else changes
    const ClothTravel travel = settling.carried ? settling.travelled : total_travel(body.cloth.shares);
    constexpr double still = 1e-6;  // m/s: it may be steady without this
    if (settling.kept == 1 && travel.longest <= still * still * dt * dt) {
        sleep.settling = 0;
        sleep.drift = {};
        return;
    }
    const Vec3 velocity = travel.together / (dt * std::max(least_kept, settling.kept) * body.particles.size());
    sleep.drift += (velocity - sleep.drift) * std::min(1.0, dt / drift_time);
    if (may_settle(body, travel, length(gravity), dt)) {
        sleep.settling = std::min(settled, sleep.settling + dt);
    } else {
        sleep.settling = std::max(0.0, sleep.settling - return_rate * dt);
    }
    if (sleep.settling > 0) {
        const uint64_t support = models_around(body, scene);
        sleep.support = settling.carried && settling.carriers.move ? ~support : support;  // they may stop at once
    }
    if (sleep.settling < settled) return;
    sleep.drift = {};
    body.steady.pause = body.steady.left_out = 0;  // it may be steady from now on
}

}  // namespace gphys
