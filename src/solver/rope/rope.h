// What the ways of solving ropes have in common: one by one (rope_direct.cpp), side by side (rope_lanes.cpp)
// and joined to others (joint_system.cpp).
#pragma once

#include "foundation/math.h"
#include "solver/plan.h"

namespace gphys {

/// The compliance that every link has, relative to the inverse masses at its ends. It decides what
/// the constraints leave open (a straight chain between two pins). A link then stretches by
/// this * t (w_a + w_b), which is 1e-10 of how far one substep's forces could move it.
constexpr double rope_regularisation = 1e-10;

struct Body;

/// Whether its first substep is made in parts, after an interruption.
bool starts_again(const Body& body);
/// Whether its substeps of h seconds may be made in two stages: it goes on without an interruption, and no link
/// moves by much meanwhile. stages.cpp.
bool may_go_in_stages(const Body& body, Vec3 gravity, double h);

/// Between two pins that are further apart than the rigid links between them are long together, no link can keep
/// its length; the stretch that cannot be avoided is shared in proportion.
/// pinned(i) and at(i) are of particle i of the chain; stretch(i, length) is called for each link that is to be
/// so long, which differs from its rest length by the same factor for all.
template <class Pinned, class At, class Stretch>
void share_stretch(const Plan& plan, const Chain& chain, Pinned&& pinned, At&& at, Stretch&& stretch) {
    const double* const rest = plan.rest.data() + chain.first_link;
    uint32_t pin = chain.link_count + 1;  // the last one passed; none yet
    double total = 0;
    bool rigid = true;
    for (uint32_t i = 0; i <= chain.link_count; ++i) {
        if (i > 0) {
            total += rest[i - 1];
            rigid = rigid && plan.compliance[chain.first_link + i - 1] == 0;
        }
        if (!pinned(i)) continue;
        if (pin < i && rigid) {
            const double span = distance(at(pin), at(i));
            for (uint32_t j = pin; j < i && span > total; ++j) {
                stretch(j, total > 0 ? rest[j] * (span / total) : span / (i - pin));
            }
        }
        pin = i;
        total = 0;
        rigid = true;
    }
}

}  // namespace gphys
