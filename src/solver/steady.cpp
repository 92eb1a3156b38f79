// When a body is steady (steady.h): its particles hardly move, and the last step began and ended in the same state,
// with the same models around. The comparison is by 64-bit hashes; that of the whole state is made only while the
// positions stay the same.
#include "solver/steady.h"

#include "foundation/word_hash.h"
#include "solver/contact/neighbourhood.h"
#include "solver/solver.h"

namespace gphys {
namespace {

/// Whether the input of a step is all in the state of the body and in its surroundings, and the state may stay the
/// same. Particles on a model may do so with velocities in the order of the rounding of their positions.
bool may_be_steady(const Body& body, const SolverSettings& settings) {
    constexpr double slow = 1e-6;  // m/s
    // With a bound on work, the substeps of a body depend on the others.
    if (settings.max_work > 0 || body.plan.joined || body.breaking.possible()) return false;
    if (!body.targets.empty()) return false;
    const Vector<Vec3>& velocity = body.particles.velocity;
    return std::all_of(velocity.begin(), velocity.end(), [](Vec3 v) { return max_component(abs(v)) < slow; });
}

uint64_t hash_of_places(const Particles& particles) {
    WordHash hash;
    hash.put(particles.position.data(), particles.position.size() * (sizeof(Vec3) / 4));
    return hash.value();
}

/// 0 if there is no scene. visit(model): the models that a step would list.
template <class Visit>
uint64_t hash_of_surroundings(const Body& body, const Scene* scene, Visit&& visit) {
    if (!scene || body.settings.layers == 0) return 0;
    uint64_t sum = 1;  // does not depend on the order of models
    each_near_model(*scene, body.steady.search_box, body.settings.layers, [&](gphys_model_id model) {
        WordHash hash;
        const uint64_t place = hash_of(*scene, model);
        const uint32_t tag = scene->tag(model);
        hash.put(&place, sizeof place / 4);
        hash.put(&tag, 1);
        sum += hash.value();
        visit(model);
    });
    return sum;
}

/// After a comparison that has failed; the next ones wait longer and longer.
void put_off(Steady& steady) {
    constexpr uint32_t longest = 31;
    steady.pause = std::min(2 * steady.pause + 1, longest);
    steady.left_out = steady.pause;
}

}  // namespace

void note_steadiness(Body& body, const Scene* scene, const SolverSettings& settings, double dt) {
    Steady& now = body.steady;
    const Steady before = now;
    now.found = false;
    now.place = now.state = 0;
    now.step_time = dt;
    now.substeps = settings.substeps;
    if (dt != before.step_time || settings.substeps != before.substeps) return;
    if (body.sleep.asleep || !may_be_steady(body, settings)) return;
    if (now.left_out > 0) {
        --now.left_out;
        return;
    }
    now.place = hash_of_places(body.particles);
    if (before.place == 0) return;
    if (now.place != before.place) {
        put_off(now);
        return;
    }
    now.state = hash_of_state(body);
    now.surroundings = hash_of_surroundings(body, scene, [](gphys_model_id) {});
    if (before.state == 0) return;
    now.found = now.state == before.state && now.surroundings == before.surroundings;
    if (now.found) {
        now.pause = 0;
    } else {
        put_off(now);
    }
}

bool Solver::stays_steady(const Body& body, const Scene* scene, double dt) {
    const Steady& steady = body.steady;
    if (!steady.found || !body.targets.empty()) return false;
    if (dt != steady.step_time || state_.settings.substeps != steady.substeps) return false;
    see_attached_models(scene, body.constraints, next_near_models_.size());
    const auto see_near = [&](gphys_model_id model) { see(*scene, model); };
    return hash_of_surroundings(body, scene, see_near) == steady.surroundings &&
           !attachments_moved(body.constraints, scene);
}

}  // namespace gphys
