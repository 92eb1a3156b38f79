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

/// The allowed position of a particle with a target. Returns false if it is inside its bounds, or does not move freely.
bool find_place(const AnimationTargets& targets, const ClothState& state, uint32_t p, Vec3& place,
                TargetBounds& out_of) {
    const float* const at = &state.at[4 * size_t{p}];
    if (at[3] == 0 || !targets.all[p].bounds()) return false;
    out_of.particle = p;
    place =
        allowed_place(targets.all[p], targets.fraction, targets.time, state.origin + get(at), out_of) - state.origin;
    return out_of.count > 0;
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
        Vec3 place;
        TargetBounds out_of;
        if (has_contact && get(normal) != Vec3{}) continue;
        if (!find_place(targets, state, p, place, out_of)) continue;
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
        Vec3 place;
        TargetBounds out_of;
        const double off = dot(pressing.bound[0].normal, state.origin + at) - pressing.bound[0].offset;
        if (off <= rounding * max_component(abs(at)) && !find_place(targets, state, pressing.particle, place, out_of))
            targets.reached.push_back(pressing);
    }
    for (uint32_t p = 0; p < targets.all.size(); ++p) {
        Vec3 place;
        TargetBounds out_of;
        if (!find_place(targets, state, p, place, out_of)) continue;
        put(&state.at[4 * size_t{p}], place, farthest_in_cloth);
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
    Vec3 place;
    TargetBounds out_of;
    if (!targets.empty() && find_place(targets, state, particle, place, out_of))
        put(&state.at[4 * size_t{particle}], place, farthest_in_cloth);
}

}  // namespace gphys
