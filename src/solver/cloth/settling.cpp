// When cloth settles (settling.h). Speeds are compared with that after a fall by the length of a link, so units do not
// matter.
#include "solver/cloth/settling.h"

#include "solver/body.h"
#include "solver/contact/collision.h"

namespace gphys {
namespace {

// Seconds that a body has been settling: until then the damping grows; from then on displacements fade; the end.
constexpr double full_damping = 0.5, fading = 0.7, settled = 1.2;
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

bool is_near_moving_model(const ClothContact& n) {
    return std::any_of(n.planes, n.planes + n.plane_count,
                       [](const ContactPlane& plane) { return plane.moving_collider != ContactPlane::unmoved; });
}

bool is_held(const ClothContacts& contacts) {
    if (!contacts.any_active()) return false;
    const auto held = std::count_if(contacts.active.begin(), contacts.active.end(),
                                    [&](uint32_t number) { return contacts.candidates[number].held; });
    return static_cast<double>(held) >= least_held * static_cast<double>(contacts.active.size());
}

/// Metres by which particles move in a step at a part of the speed after such a fall, while displacements fade as they
/// do.
double way_at(const Body& body, double part, double gravity, double dt) {
    return part * std::sqrt(2 * gravity * body.cloth.batches.link_length) * dt *
           std::max(least_kept, body.cloth.settling.kept);
}

bool is_slow(const Body& body, const ClothTravel& travel, double slow, double gravity, double dt) {
    const double way = way_at(body, slow, gravity, dt);
    return travel.sum <= way * way * body.particles.size() && travel.longest <= most * most * way * way &&
           length(body.sleep.drift) <= drift * std::sqrt(2 * gravity * body.cloth.batches.link_length);
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
    if (contacts.has_moving_model || contacts.penetrating) return false;
    if (is_held(contacts))
        return is_slow(body, travel, slow, gravity, dt) &&
               is_hardly_strained(body, most_strain * body.cloth.relaxation.most_strain);
    return is_slow(body, travel, slow_hanging, gravity, dt) && moves_in_place(body, travel, gravity, dt);
}

}  // namespace

void begin_settling(Body& body, const CollisionContext& around) {
    Sleep& sleep = body.sleep;
    const Vector<ClothContact>& candidates = body.cloth.contacts.candidates;
    if (sleep.settling > 0 && (are_carried(body.constraints) || sleep.support != models_around(body, around.scene) ||
                               std::any_of(candidates.begin(), candidates.end(), is_near_moving_model)))
        sleep.settling = 0;
    body.cloth.settling.damping = most_damping * std::min(1.0, sleep.settling / full_damping);
    body.cloth.settling.kept = std::clamp((settled - sleep.settling) / (settled - fading), 0.0, 1.0);
}

void settle(Body& body, double h) {
    const Settling& settling = body.cloth.settling;
    if (!settling.acts()) return;
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    const float way = static_cast<float>(settling.kept),
                speed = settling.kept > 0 ? static_cast<float>(1 / (1 + settling.damping * h)) : 0;
    share_motion(body.cloth.state, body.cloth.shares.team,
                 [&](const ClothMotion& motion, uint32_t) { kernels.settle(motion, speed, way); });
}

void note_settling(Body& body, const Scene* scene, Vec3 gravity, double dt, bool alone) {
    Sleep& sleep = body.sleep;
    if (!alone || !is_left_alone(body)) {
        sleep.settling = 0;
        sleep.drift = {};
        return;
    }
    if (body.cloth.settling.kept == 0) return;  // it lies still until something else changes
    const ClothTravel travel = total_travel(body.cloth.shares);
    constexpr double still = 1e-6;  // m/s: it may be steady without this
    if (body.cloth.settling.kept == 1 && travel.longest <= still * still * dt * dt) {
        sleep.settling = 0;
        sleep.drift = {};
        return;
    }
    const Vec3 velocity =
        travel.together / (dt * std::max(least_kept, body.cloth.settling.kept) * body.particles.size());
    sleep.drift += (velocity - sleep.drift) * std::min(1.0, dt / drift_time);
    if (may_settle(body, travel, length(gravity), dt)) {
        sleep.settling = std::min(settled, sleep.settling + dt);
    } else {
        sleep.settling = std::max(0.0, sleep.settling - return_rate * dt);
    }
    if (sleep.settling > 0) sleep.support = models_around(body, scene);
    if (sleep.settling < settled) return;
    sleep.drift = {};
    body.steady.pause = body.steady.left_out = 0;  // it may be steady from now on
}

}  // namespace gphys
