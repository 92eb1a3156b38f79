// Animation targets as bounds of cloth particles: a predicted particle outside is projected onto its bounds, which then
// act as a contact plane in the chains.
#include "solver/cloth/cloth_targets.h"
#include "solver/animation_targets.h"
#include "solver/cloth/chain_contacts.h"
#include "solver/cloth/cloth_state.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// Of a coordinate in float32, after some operations.
constexpr double rounding = 0x1p-20;

/// Whether a particle moves freely and is outside of its bounds.
bool is_outside(const AnimationTargets& targets, const ClothState& state, uint32_t p) {
    const float* const at = &state.at[4 * size_t{p}];
    return at[3] != 0 && !is_allowed(targets.all[p], targets.fraction, state.origin + get(at));
}

/// The allowed position of such a particle.
Vec3 find_place(const AnimationTargets& targets, const ClothState& state, uint32_t p, TargetBounds& out_of) {
    out_of.particle = p;
    const Vec3 at = state.origin + get(&state.at[4 * size_t{p}]);
    return allowed_place(targets.all[p], targets.fraction, targets.time, at, out_of) - state.origin;
}

}  // namespace

void carry_by_targets(const AnimationTargets& targets, ClothState& state) {
    for (uint32_t p = 0; p < targets.all.size(); ++p) {
        if (targets.all[p].carries == 0) continue;
        put(&state.at[4 * size_t{p}], place_of(targets.all[p], targets.fraction) - state.origin, farthest_in_cloth);
    }
}

void find_target_contacts(AnimationTargets& targets, ClothState& state, ChainContacts& contacts, bool has_contact) {
    for (uint32_t p = 0; p < targets.all.size(); ++p) {
        float *const at = &state.at[4 * size_t{p}], *const normal = &contacts.normals[4 * size_t{p}];
        if ((has_contact && get(normal) != Vec3{}) || !is_outside(targets, state, p)) continue;
        TargetBounds out_of;
        const Vec3 place = find_place(targets, state, p, out_of);
        const Vec3 inward = out_of.bound[0].normal;
        put(normal, inward);
        normal[3] = static_cast<float>(dot(place - get(at), inward) / at[3]);
        put(at, place, farthest_in_cloth);
        put(&contacts.pulls[4 * size_t{p}], {});
        targets.pressing.push_back(out_of);
    }
}

void keep_cloth_to_targets(AnimationTargets& targets, ClothState& state, ChainContacts& contacts) {
    carry_by_targets(targets, state);
    for (const TargetBounds& pressing : targets.pressing) {
        const size_t i = 4 * size_t{pressing.particle};
        put(&contacts.normals[i], {});
        // A particle that the chains have not moved away from its bounds is still at them.
        const Vec3 at = get(&state.at[i]);
        const double off = dot(pressing.bound[0].normal, state.origin + at) - pressing.bound[0].offset;
        if (off <= rounding * max_component(abs(at)) && !is_outside(targets, state, pressing.particle))
            targets.reached.push_back(pressing);
    }
    for (uint32_t p = 0; p < targets.all.size(); ++p) {
        if (!is_outside(targets, state, p)) continue;
        TargetBounds out_of;
        put(&state.at[4 * size_t{p}], find_place(targets, state, p, out_of), farthest_in_cloth);
        targets.reached.push_back(out_of);
    }
}

void stop_cloth_at_targets(const AnimationTargets& targets, ClothState& state) {
    for (const TargetBounds& reached : targets.reached) {
        float* const velocity = &state.velocity[4 * size_t{reached.particle}];
        put(velocity, reached.turned(get(velocity)), fastest_in_cloth);
    }
}

void stay_near_target(const AnimationTargets& targets, ClothState& state, uint32_t particle) {
    if (targets.empty() || !is_outside(targets, state, particle)) return;
    TargetBounds out_of;
    put(&state.at[4 * size_t{particle}], find_place(targets, state, particle, out_of), farthest_in_cloth);
}

}  // namespace gphys
