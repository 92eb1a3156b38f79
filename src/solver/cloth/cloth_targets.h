// Animation targets of cloth, in the order of a substep.
#pragma once

#include <cstdint>

namespace gphys {

struct AnimationTargets;
struct ChainContacts;
struct ClothState;

/// After the prediction: moves particles that targets carry.
void carry_by_targets(const AnimationTargets& targets, ClothState& state);
/// Before the chains: projects predicted particles onto their bounds, which become their contact planes in the chains.
/// If `has_contact`, particles with contact planes of models keep those instead.
void find_target_contacts(AnimationTargets& targets, ClothState& state, ChainContacts& contacts, bool has_contact);
/// After the chains and limits.
void keep_cloth_to_targets(AnimationTargets& targets, ClothState& state, ChainContacts& contacts);
/// After the velocities have been computed.
void stop_cloth_at_targets(const AnimationTargets& targets, ClothState& state);
/// For a particle that has been displaced.
void stay_near_target(const AnimationTargets& targets, ClothState& state, uint32_t particle);

}  // namespace gphys
