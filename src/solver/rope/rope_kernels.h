// The substep of ropes that nothing disturbs: one rope, or eight side by side, with the same bits.
//
// A rope's particles are nodes in a row, each with the link to the next one. Several chains of a body
// follow each other, and particles in no chain follow them, with links between that are not there.
#pragma once

#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

template <int lanes>
struct RopeNode {
    using Value = double[lanes];

    Value position[3], velocity[3];     // m, m/s
    Value start[3], start_velocity[3];  // a part of a substep before
    Value earlier_velocity[3];          // two before
    Value history[3], predicted[3];     // of the part under way, without constraints
    Value acceleration[3];              // of gravity and forces
    Value mass;                         // kg
    Value free;                         // 0: pinned, else 1
    // Of the link to the next node:
    Value present;                 // 0: none, or between two pins; else 1
    Value target, inverse_target;  // metres
    Value compliance;              // m/N
    Value regularisation;          // 1/kg; what makes the system regular where there is no link
    Value sideways;                // m^2; moved by less across itself, a link is settled
    Value tension;                 // N
    // What elimination leaves for substitution:
    Value inverse[6];               // of the system up to this node, its part for this node
    Value own[3];                   // the solution without the nodes that follow; then the solution
    Value pull[3], own_tension;     // of the link that arrives
    Value direction[3], stiffness;  // of the link that leaves
};

/// Of one part of a substep, as TimeScheme has them.
template <int lanes>
struct RopeStep {
    using Value = double[lanes];

    Value h, rate;  // s, 1/s
    Value next, inverse_next, now, earlier;
    Value damping, drag;
    Value step_squared, inverse_step_squared;  // of the scheme: what a force has to do with a position
    Value curve;                               // h^2 / 2 / the part before; 0: there was none
};

/// What all nodes have kept within since it was last reset, and whether a part has ended with lengths of links
/// that had not been found: 0 or 1.
template <int lanes>
struct RopeBounds {
    double low[3][lanes], high[3][lanes];
    double lost[lanes];
};

/// One part of a substep, by the trapezoid rule or the backward formula in all lanes.
struct RopeKernels {
    void (*move_one)(RopeNode<1>* nodes, uint32_t count, const RopeStep<1>& step, bool trapezoid,
                     RopeBounds<1>& bounds);
    void (*move_eight)(RopeNode<8>* nodes, uint32_t count, const RopeStep<8>& step, bool trapezoid,
                       RopeBounds<8>& bounds);
};

// A link is settled within this part of its length: float32 output rounds coordinates of its size by as much.
constexpr double rope_settled = 1e-7;
// One that is off by more than this part of its length when the iterations are over has not been found: where
// links turn by more than a radian in a step Newton's method may circle, and velocities from such positions grow
// without bound. Where it converges it is off by less than a millionth by then.
constexpr double rope_lost = 1e-4;

GPHYS_DECLARE_KERNELS(RopeKernels, rope_kernels)

}  // namespace gphys
