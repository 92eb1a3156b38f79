// Ropes that nothing disturbs, in the form in which they are moved: one rope, or eight side by side, with the same
// bits. rope_kernels.cpp moves them, rope_layout_kernels.cpp puts them into this form and takes them out of it.
//
// A rope's particles are nodes in a row, each with the link to the next one.
#pragma once

#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

/// Where a body keeps one of its chains.
struct RopeArrays {
    const uint32_t* particles;  // from the first to the last
    uint32_t count;
    // By particle, those with coordinates as three numbers:
    double *position, *velocity, *start, *start_velocity;
    double* earlier_velocity;  // null: nobody asks for it
    const double *force, *mass, *inverse_mass;
    // By link:
    const double *target, *compliance;
    double* tension;
    bool forced;  // whether any force may be other than 0
};

template <int lanes>
struct RopeNode {
    using Value = double[lanes];

    Value position[3], velocity[3];     // m, m/s
    Value start[3], start_velocity[3];  // a part of a substep before
    Value earlier_velocity[3];          // two before
    Value history[3], predicted[3];     // of the part under way, without constraints
    Value acceleration[3];              // of gravity and forces
    Value mass, inverse_mass;           // kg, 1/kg
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

template <int lanes>
struct RopeKernelsOf {
    /// Nodes, as many as the longest rope has particles. Beyond the end of a shorter one there are particles that
    /// stay at its first one.
    void (*put)(RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes], const double (&gravity)[3]);
    /// Of nodes just put, how calmly the ropes move, as stages_kernels.cpp has it.
    void (*find_agility)(const RopeNode<lanes>* nodes, uint32_t count, double (&agility)[lanes]);
    /// One part of a substep, by the trapezoid rule or the backward formula in all lanes.
    void (*move)(RopeNode<lanes>* nodes, uint32_t count, const RopeStep<lanes>& step, bool trapezoid,
                 RopeBounds<lanes>& bounds);
    /// Only those that are wanted.
    void (*take)(const RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes],
                 const bool (&wanted)[lanes]);
};
struct RopeKernels {
    RopeKernelsOf<1> one;
    RopeKernelsOf<8> eight;
};

/// The compliance that every link has, relative to the inverse masses at its ends. It decides what
/// the constraints leave open (a straight chain between two pins). A link then stretches by
/// this * t (w_a + w_b), which is 1e-10 of how far one substep's forces could move it.
constexpr double rope_regularisation = 1e-10;
/// A nanometre, as far as particles stay off models. A shorter link is one without a length, and one that is shorter
/// at the moment is as stiff sideways as one of this length: tension / length would leave the range of doubles.
constexpr double rope_shortest = 1e-9;
// A link is settled within this part of its length: float32 output rounds coordinates of its size by as much.
constexpr double rope_settled = 1e-7;
// One that is off by more than this part of its length when the iterations are over has not been found: where
// links turn by more than a radian in a step Newton's method may circle, and velocities from such positions grow
// without bound. Where it converges it is off by less than a millionth by then.
constexpr double rope_lost = 1e-4;
// Ropes are calm as long as their agility is below the square of this many radians a substep.
constexpr double most_turn_in_stages = 0.5;

GPHYS_DECLARE_KERNELS(RopeKernels, rope_kernels)

}  // namespace gphys
