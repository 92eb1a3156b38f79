// Kernels of ropes: one rope, or eight side by side, with the same bits. rope_kernels.cpp moves undisturbed ropes, and
// iterates with others; rope_layout_kernels.cpp converts from and to the arrays of bodies.
//
// The particles of a rope are nodes in a row, each with the link to the next node.
#pragma once

#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

/// Where a body stores one of its chains.
struct RopeArrays {
    const uint32_t* particles;  // from the first to the last
    uint32_t count;
    // By particle, those with coordinates as three numbers:
    double *position, *velocity, *start, *start_velocity;
    double* earlier_velocity;  // null if nobody needs it
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
    Value start[3], start_velocity[3];  // one part of a substep earlier
    Value earlier_velocity[3];          // two parts earlier
    Value history[3], predicted[3];     // of the part under way, without constraints
    Value acceleration[3];              // of gravity and forces
    Value mass, inverse_mass;           // kg, 1/kg
    Value free;                         // 0: pinned, else 1
    // Of the link to the next node:
    Value present;                 // 0: none, or between two pins; else 1
    Value target, inverse_target;  // metres
    Value compliance;              // m/N
    Value regularisation;          // 1/kg; keeps the system regular where there is no link
    Value sideways;                // m^2; a link that moves less perpendicular to itself is settled
    Value tension;                 // N
    // Left by elimination for substitution:
    Value inverse[6];               // of the system up to this node, the block of this node
    Value own[3];                   // the solution without later nodes; then the whole solution
    Value pull[3], own_tension;     // of the arriving link
    Value direction[3], stiffness;  // of the leaving link
};

/// The coefficients of one part of a substep, as in TimeScheme.
template <int lanes>
struct RopeStep {
    using Value = double[lanes];

    Value h, rate;  // s, 1/s
    Value next, inverse_next, now, earlier;
    Value damping, drag;
    Value step_squared, inverse_step_squared;  // of the scheme: force to displacement
    Value curve;                               // h^2 / 2 / previous part; 0: there was none
};

/// What contacts add to the equation of a node, times the square of the step.
template <int lanes>
struct RopePush {
    double stiffness[6][lanes];  // kg; xx, xy, xz, yy, yz, zz
    double force[3][lanes];      // kg m
};

/// Of the scheme, as in RopeStep; the farthest that a node may move in an iteration; the largest tension; and which
/// lanes are to be moved: 0 or 1.
template <int lanes>
struct RopeEquations {
    double step_squared[lanes], inverse_step_squared[lanes];
    double reach[lanes], most_tension[lanes];
    double active[lanes];
};

/// Bounds of all nodes since the last reset, and whether a part has ended without finding all lengths of links: 0 or 1.
template <int lanes>
struct RopeBounds {
    double low[3][lanes], high[3][lanes];
    double lost[lanes];
};

template <int lanes>
struct RopeKernelsOf {
    /// Loads nodes, as many as the longest rope has particles. The nodes beyond the end of a shorter rope stay at its
    /// first particle.
    void (*put)(RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes], const double (&gravity)[3]);
    /// After put: how calmly the ropes move (stages_kernels.cpp).
    void (*find_agility)(const RopeNode<lanes>* nodes, uint32_t count, double (&agility)[lanes]);
    /// Runs one part of a substep, by the trapezoid rule or the backward formula in all lanes.
    void (*move)(RopeNode<lanes>* nodes, uint32_t count, const RopeStep<lanes>& step, bool trapezoid,
                 RopeBounds<lanes>& bounds);
    /// Stores the wanted lanes.
    void (*take)(const RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes],
                 const bool (&wanted)[lanes]);
    /// Makes one of Newton's iterations, with contacts. `moving`: the lanes in which a link has moved too far
    /// perpendicular to itself for this to be the last one.
    void (*iterate)(RopeNode<lanes>* nodes, const RopePush<lanes>* pushes, uint32_t count,
                    const RopeEquations<lanes>& equations, bool (&moving)[lanes]);
};
struct RopeKernels {
    RopeKernelsOf<1> one;
    RopeKernelsOf<8> eight;
};

/// The compliance that every link has, relative to the inverse masses at its ends. It decides what the constraints
/// leave open (a straight chain between two pins). A link then stretches by this * t (w_a + w_b), which is 1e-10 of the
/// displacement that the forces of one substep could cause.
constexpr double rope_regularisation = 1e-10;
/// A nanometre, the smallest skin of particles. A shorter link counts as one of zero length. A link that is shorter at
/// the moment is as stiff sideways as one of this length, because tension / length would overflow.
constexpr double rope_shortest = 1e-9;
// A link is settled within this fraction of its length: float32 output rounds coordinates of its size by as much.
constexpr double rope_settled = 1e-7;
// If the length of a link is wrong by more than this fraction after the iterations, it has not been found. Where links
// turn by more than a radian in a step, Newton's method may cycle, and velocities from such positions grow without
// bound. Where it converges, the error is below a millionth by then.
constexpr double rope_lost = 1e-4;
// Ropes are calm while their agility is below the square of this many radians per substep.
constexpr double most_turn_in_stages = 0.5;

GPHYS_DECLARE_KERNELS(RopeKernels, rope_kernels)

}  // namespace gphys
