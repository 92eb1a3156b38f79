// What ropes have in common that are solved one by one (rope_direct.cpp) and side by side (rope_lanes.cpp).
#pragma once

#include "solver/plan.h"

namespace gphys {

struct Body;
class RopeContacts;

/// Whether its first substep is made in parts, after an interruption.
bool starts_again(const Body& body);

/// The lengths that links shall have. Between two pins that are further apart than the rigid links between them are
/// long together, no link can keep its length; the stretch that cannot be avoided is shared in proportion.
void set_targets(Body& body, const Chain& chain);

/// solve_directly together with contacts, or without if there are none (null).
bool solve_touching(Body& body, double step, RopeContacts* contacts);

/// The part of its length that a rigid link may lack before a substep and count as in shape. Those that are put right
/// by it do so at a speed that grows as it gets shorter.
constexpr double in_shape = 0.05;

}  // namespace gphys
