// Ropes near models whose rigid links do not have their lengths at the beginning of a substep.
//
// A rope that the caller has placed so gets its lengths back before it moves, because a correction within the substep
// would become a high velocity.
//
// A rope that is pulled around a post between two pins cannot have its lengths. The contacts show that only in the
// solution, unlike pins that are farther apart than the rope is long (set_targets). Newton's method distributes a
// hundredth along the rope, as the regularisation of the links allows, but it does not converge for much more. So the
// rope yields: its links aim at the lengths that they have, less a hundredth, and share the stretch evenly. If the pins
// come closer, it shortens by as much in each substep.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

struct Body;
struct Chain;
struct CollisionContext;
struct TimeScheme;
class RopeContacts;

/// A substep begins feasible if each rigid link is wrong by at most this fraction of its length. A larger error would
/// be corrected within the substep, at a speed that grows as the substep gets shorter.
constexpr double most_initial_strain = 0.05;

/// By how much the rigid links are wrong at most, as a fraction of their target lengths.
double largest_strain(const Body& body, const Vector<Vec3>& positions);
/// Sets the target lengths of a chain's links. If two pins are farther apart than the rigid links between them are
/// long, these share the unavoidable stretch in proportion to their lengths. So they do in a rope that yields.
void set_targets(Body& body, const Chain& chain);
/// Call after the prediction and RopeContacts::begin. `contacts`: those in the equations, or null. Restores lengths, or
/// lets the rope yield. Returns whether the rope has been displaced, so that its contacts must begin again.
bool begin_stretched(Body& body, RopeContacts* contacts, const CollisionContext& around, const TimeScheme& scheme);
/// Call after the last iteration: if Newton's method has torn a rope apart that yields, it stays where it was. Returns
/// whether it does.
bool stay_if_torn(Body& body);
/// Call at the end of the substep, and if it begins again.
void stop_yielding(Body& body);

}  // namespace gphys
