// Bodies at rest fall asleep, and then cost one query of the scene per step. A body falls asleep once it has been slow
// for long enough and is hardly strained. The speed alone would put a rope to sleep that is about to snap back. It
// wakes when it is edited, when gravity changes, and when a model near it is added, removed or moved, or the scene is
// another one. Bodies of an island sleep and wake together.
#include "solver/contact/collision.h"
#include "solver/contact/neighbourhood.h"
#include "solver/solver.h"

namespace gphys {
namespace {

bool is_slow(const Particles& particles, double speed) {
    return std::all_of(particles.velocity.begin(), particles.velocity.end(),
                       [&](Vec3 velocity) { return length_squared(velocity) <= speed * speed; });
}

/// For a graph that has made a step. If its links contradict each other and friction, as on sharp edges, its particles
/// oscillate by small distances without end, and some farther now and then. So the average distance per step decides. A
/// falling flap, even of a few particles, soon exceeds the bound for single particles.
bool goes_slowly(const Body& body, double speed, double dt) {
    constexpr double most = 10;  // times the average, of each particle
    const ClothTravel all = total_travel(body.cloth.shares);
    const double way = speed * dt, square = way * way;
    return all.sum <= square * body.particles.size() && all.longest <= most * most * square &&
           is_slow(body.particles, most * speed);
}

}  // namespace

bool is_hardly_strained(const Body& body, double strain) {
    if (is_graph(body) && body.cloth.relaxation.braces_yield) {
        // The strain that relax_links leaves, and that models may cause beyond it.
        strain = std::max(strain, 1.5 * body.cloth.relaxation.most_strain);
        const Vector<KeptLinks::Link>& links = body.cloth.relaxation.kept.links;
        return std::all_of(links.begin(), links.end(), [&](const KeptLinks::Link& link) {
            const double error = distance(body.particles.position[link.a], body.particles.position[link.b]) - link.rest;
            return link.brace || (link.limit && error < 0) || std::fabs(error) <= strain * link.rest;
        });
    }
    double sum = 0, largest_gap = 0;  // of rest lengths; of the links without a length
    uint32_t count = 0;
    for (const uint32_t slot : body.constraints.ids) {
        const DistanceConstraint& c = body.constraints.by_slot[slot];
        if (c.compliance > 0) continue;
        const double error = std::fabs(excess(body.particles, c));
        sum += c.rest;
        ++count;
        if (c.rest == 0) {
            largest_gap = std::max(largest_gap, error);
        } else if (error > strain * c.rest) {
            return false;
        }
    }
    // A link without a length is never exactly so long. It may be off by as much as the others.
    return largest_gap == 0 || largest_gap * count <= strain * sum;
}

namespace {

/// Calls visit(model) for the models in the box of a sleeping body.
template <class Visit>
uint64_t neighbourhood(const Body& body, const Scene* scene, Visit&& visit) {
    if (!scene || body.settings.layers == 0) return 0;
    return neighbourhood(*scene, body.sleep.box, body.settings.layers, visit);
}

}  // namespace

bool attachments_moved(const Constraints& constraints, const Scene* scene) {
    return scene &&
           std::any_of(constraints.attachments.begin(), constraints.attachments.end(), [&](const Attachment& a) {
               return a.model == 0 || !scene->has(a.model) || scene->world_transform(a.model).apply(a.local) != a.end;
           });
}

void wake(Body& body) {
    body.steady = {};
    body.flight.forget();
    body.sleep.rest_time = body.sleep.settling = 0;
    body.sleep.drift = {};
    body.sleep.asleep = false;
    body.particles.extent.reset();
    body.cloth.cache.search_balls.clear();
}

bool is_at_rest(Body& body, const SolverSettings& settings, double dt) {
    if (settings.sleep_speed == 0) return false;
    const bool slow =
        is_graph(body) ? goes_slowly(body, settings.sleep_speed, dt) : is_slow(body.particles, settings.sleep_speed);
    const bool at_rest = slow && is_hardly_strained(body, settings.sleep_strain);
    body.sleep.rest_time = at_rest ? body.sleep.rest_time + dt : 0;
    return body.sleep.rest_time >= settings.sleep_time;
}

void fall_asleep(Body& body, const Scene* scene, double dt) {
    Sleep& sleep = body.sleep;
    sleep.asleep = true;
    std::fill(body.particles.velocity.begin(), body.particles.velocity.end(), Vec3{});
    body.history.earlier_step = 0;
    // A model beyond this is noticed before it can come near.
    sleep.box = swept_box(body, body.particles.position, body.particles.position, dt * fastest_model);
    sleep.neighbourhood = neighbourhood(body, scene, [](gphys_model_id) {});
}

void rest(Body& body, const Scene* scene, const SolverSettings& settings, double dt) {
    note_settling(body, scene, settings.gravity, dt, true);
    if (is_at_rest(body, settings, dt)) fall_asleep(body, scene, dt);
    note_steadiness(body, scene, settings, dt);
}

bool Solver::stays_asleep(const Body& body, const Scene* scene) {
    if (!body.sleep.asleep) return false;
    // Its models are tracked like those of other bodies: if one moves and wakes it, its former place is known.
    see_attached_models(scene, body.constraints, next_near_models_.size());
    return neighbourhood(body, scene, [&](gphys_model_id model) { see(*scene, model); }) == body.sleep.neighbourhood &&
           !attachments_moved(body.constraints, scene);
}

void Solver::set_gravity(Vec3 gravity) {
    if (gravity != state_.settings.gravity) wake_all();
    state_.settings.gravity = gravity;
}

void Solver::wake_all() {
    for (Body& body : state_.bodies) wake(body);
}

void Solver::list_sleeping(Smallest<gphys_body_id>& out) const {
    for (const uint32_t slot : state_.ids) {
        if (state_.bodies[slot].sleep.asleep) out.add(state_.ids.id(slot));
    }
}

}  // namespace gphys
