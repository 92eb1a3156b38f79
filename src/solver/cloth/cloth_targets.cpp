// Animation targets as bounds of cloth particles: a predicted particle outside is projected onto its bounds, which then
// act as a contact plane in the chains.
#include "solver/cloth/cloth_targets.h"
#include "solver/body.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// Of a coordinate in float32, after some operations.
constexpr double rounding = 0x1p-20;

/// The allowed position of a particle with a target. Returns false if it is inside its bounds, or does not move freely.
bool find_place(const Body& body, uint32_t p, Vec3& place, TargetBounds& out_of) {
    const AnimationTargets& targets = body.targets;
    const float* const at = &body.cloth.at[4 * size_t{p}];
    if (at[3] == 0 || !targets.all[p].bounds()) return false;
    out_of.particle = p;
    place = allowed_place(targets.all[p], targets.fraction, targets.time, body.cloth.origin + get(at), out_of) -
            body.cloth.origin;
    return out_of.count > 0;
}

}  // namespace

void carry_by_targets(Body& body) {
    const AnimationTargets& targets = body.targets;
    for (uint32_t p = 0; p < targets.all.size(); ++p) {
        if (targets.all[p].carries == 0) continue;
        put(&body.cloth.at[4 * size_t{p}], place_of(targets.all[p], targets.fraction) - body.cloth.origin,
            farthest_in_cloth);
    }
}

void press_on_targets(Body& body, bool has_contact) {
    ClothContacts& contacts = body.cloth.contacts;
    for (uint32_t p = 0; p < body.targets.all.size(); ++p) {
        float *const at = &body.cloth.at[4 * size_t{p}], *const normal = &contacts.normals[4 * size_t{p}];
        Vec3 place;
        TargetBounds out_of;
        if (has_contact && get(normal) != Vec3{}) continue;
        if (!find_place(body, p, place, out_of)) continue;
        const Vec3 inward = out_of.bound[0].normal;
        put(normal, inward);
        normal[3] = static_cast<float>(dot(place - get(at), inward) / at[3]);
        put(at, place, farthest_in_cloth);
        put(&contacts.pulls[4 * size_t{p}], {});
        body.targets.pressing.push_back(out_of);
    }
}

void keep_cloth_to_targets(Body& body) {
    AnimationTargets& targets = body.targets;
    carry_by_targets(body);
    for (const TargetBounds& pressing : targets.pressing) {
        const size_t i = 4 * size_t{pressing.particle};
        put(&body.cloth.contacts.normals[i], {});
        // A particle that the chains have not moved away from its bounds is still at them.
        const Vec3 at = get(&body.cloth.at[i]);
        Vec3 place;
        TargetBounds out_of;
        const double off = dot(pressing.bound[0].normal, body.cloth.origin + at) - pressing.bound[0].offset;
        if (off <= rounding * max_component(abs(at)) && !find_place(body, pressing.particle, place, out_of))
            targets.reached.push_back(pressing);
    }
    for (uint32_t p = 0; p < targets.all.size(); ++p) {
        Vec3 place;
        TargetBounds out_of;
        if (!find_place(body, p, place, out_of)) continue;
        put(&body.cloth.at[4 * size_t{p}], place, farthest_in_cloth);
        targets.reached.push_back(out_of);
    }
}

void stop_cloth_at_targets(Body& body) {
    for (const TargetBounds& reached : body.targets.reached) {
        float* const velocity = &body.cloth.velocity[4 * size_t{reached.particle}];
        put(velocity, reached.turned(get(velocity)), fastest_in_cloth);
    }
}

void stay_near_target(Body& body, uint32_t particle) {
    Vec3 place;
    TargetBounds out_of;
    if (!body.targets.empty() && find_place(body, particle, place, out_of))
        put(&body.cloth.at[4 * size_t{particle}], place, farthest_in_cloth);
}

}  // namespace gphys
