// Kernels of ropes: one rope, or eight side by side, with the same bits. rope_kernels.cpp predicts and solves ropes in
// which nothing but links, gravity and forces acts, and makes single iterations of ropes in contact.
// rope_layout_kernels.cpp gathers ropes from the arrays of bodies and scatters them back.
//
// The particles of a rope are nodes in a row, each with the link to the next node. Lane l of every array belongs to
// rope l (array of structures of arrays).
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
    Value lateral_tolerance;       // m^2: squared displacement perpendicular to a converged link
    Value tension;                 // N
    // Left by elimination for back substitution:
    Value inverse[6];               // of the node's block, after elimination of the nodes before it
    Value displacement[3];          // without the nodes after it; after back substitution the whole
    Value tension_response[3];      // of the arriving link's tension, to a force on this node
    Value arriving_tension;         // of that link, without the nodes after it
    Value direction[3], stiffness;  // of the leaving link
};

/// The coefficients of one part of a substep, as in TimeScheme.
template <int lanes>
struct RopeScheme {
    using Value = double[lanes];

    Value h, rate;  // s, 1/s
    Value next, inverse_next, now, earlier;
    Value damping, drag;
    Value step_squared, inverse_step_squared;  // of the scheme: force to displacement
    Value extrapolation;                       // h^2 / (2 h_before), of the acceleration; 0: there was no part before
};

/// The contribution of contacts to the equation of a node, times the square of the step.
template <int lanes>
struct RopeContactTerm {
    double stiffness[6][lanes];  // kg; xx, xy, xz, yy, yz, zz
    double force[3][lanes];      // kg m
};

/// The parameters of an iteration with contacts.
template <int lanes>
struct RopeEquations {
    double step_squared[lanes], inverse_step_squared[lanes];  // as in RopeScheme
    double most_displacement[lanes];                          // m, of a node in one iteration
    double most_tension[lanes];                               // N
    double active[lanes];                                     // 1: the lane is moved; else 0
};

/// Bounds of all nodes since the last reset, and whether Newton's method has failed in any part since: 0 or 1.
template <int lanes>
struct RopeBounds {
    double low[3][lanes], high[3][lanes];
    double failed[lanes];
};

template <int lanes>
struct RopeKernelsOf {
    /// Loads nodes, as many as the longest rope has particles. The nodes beyond the end of a shorter rope stay at its
    /// first particle. Pinned nodes get a velocity of 0.
    void (*gather)(RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes],
                   const double (&gravity)[3]);
    /// Call after gather. The square of each rope's largest angular frequency, 1/s^2 (stages_kernels.cpp).
    void (*find_largest_frequency)(const RopeNode<lanes>* nodes, uint32_t count, double (&frequency_squared)[lanes]);
    /// Runs one part of a substep, by the trapezoid rule or the backward formula in all lanes. Pinned nodes move at
    /// their velocity.
    void (*move)(RopeNode<lanes>* nodes, uint32_t count, const RopeScheme<lanes>& step, bool trapezoid,
                 RopeBounds<lanes>& bounds);
    /// Stores the wanted lanes.
    void (*scatter)(const RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes],
                    const bool (&wanted)[lanes]);
    /// Makes one of Newton's iterations, with contacts. `unconverged`: the lanes that need another one, because a link
    /// has moved too far perpendicular to itself.
    void (*iterate)(RopeNode<lanes>* nodes, const RopeContactTerm<lanes>* contacts, uint32_t count,
                    const RopeEquations<lanes>& equations, bool (&unconverged)[lanes]);
};
struct RopeKernels {
    RopeKernelsOf<1> one;
    RopeKernelsOf<8> eight;
};

/// The compliance that every link has, relative to the inverse masses at its ends. It decides what the constraints
/// leave open (a straight chain between two pins). A link then stretches by this * t (w_a + w_b), which is 1e-10 of the
/// displacement that the forces of one substep could cause.
constexpr double rope_regularisation = 1e-10;
/// Metres: a nanometre, the smallest skin of particles. A shorter link counts as one of zero length. A link that is
/// shorter at the moment is as stiff sideways as one of this length, because tension / length would overflow.
constexpr double rope_shortest = 1e-9;
/// Newton's method has converged when each link is wrong by at most this fraction of its length: float32 output rounds
/// coordinates of its size by as much.
constexpr double rope_tolerance = 1e-7;
/// Newton's method has failed if a link is wrong by more than this fraction of its length after the last iteration.
/// Where links turn by more than a radian in a step, the method may cycle, and velocities from such positions grow
/// without bound. Where it converges, the error is below a millionth by then.
constexpr double rope_failure = 1e-4;
/// Radians. A substep has two stages while a rope's largest angular frequency times the substep is at most this.
constexpr double trapezoid_most_angle = 0.5;

GPHYS_DECLARE_KERNELS(RopeKernels, rope_kernels)

}  // namespace gphys
