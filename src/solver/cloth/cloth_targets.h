// Animation targets of cloth, in the parts of a substep.
#pragma once

#include <cstdint>

namespace gphys {

struct Body;

/// Once particles are predicted: what targets carry goes with them.
void carry_by_targets(Body& body);
/// Before the chains: what is predicted beyond its bounds goes along these in the chains, unless it `touches` a model
/// and goes along that.
void press_on_targets(Body& body, bool has_contact);
/// After the chains and limits.
void keep_cloth_to_targets(Body& body);
/// Once there are velocities.
void stop_cloth_at_targets(Body& body);
/// A particle that something else has moved.
void stay_near_target(Body& body, uint32_t particle);

}  // namespace gphys
