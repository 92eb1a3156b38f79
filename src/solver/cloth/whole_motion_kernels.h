// The loops of whole_motion.cpp over all particles of cloth, eight side by side.
#pragma once

#include "foundation/rotation.h"
#include "foundation/vec.h"
#include "solver/cloth/cloth_kernels.h"

namespace gphys {

/// Sums over particles, about the origin of the cloth and per average mass.
template <class N>
struct ClothMoments {
    struct Motion {
        Vec<N> first_moment, momentum, angular_momentum;

        GPHYS_INLINE void add(const N& mass, const Vec<N>& at, const Vec<N>& velocity) {
            const Vec<N> impulse = velocity * mass;
            first_moment += at * mass;
            momentum += impulse;
            angular_momentum += cross(at, impulse);
        }
    };

    N mass{};
    Motion before, after;      // at the start and at the end of a substep
    Vec<N> squares, products;  // of coordinates at the end: xx, yy, zz and yz, zx, xy
    Vec<N> force, torque;      // torque: the sum of those at the start and at the end
    N energy{};                // twice the kinetic energy at the end
    N gain{};                  // kinetic energy gained in the substep beyond the work of forces
};

/// About the origin of the cloth.
struct Momentum {
    Vec<double> linear, angular;
};

struct WholeMotionKernels {
    ClothMoments<double> (*moments)(const ClothMotion& motion);
    /// What forces and drag have not taken in a substep of h seconds, per average mass.
    Momentum (*lost)(const ClothMotion& motion, double damping, double h);
    /// Scales the velocities and adds a rigid motion: the velocity of the origin, and the angular velocity.
    void (*move)(const ClothMotion& motion, double kept, const Vec<double>& velocity,
                 const Vec<double>& angular_velocity);
    /// Keeps parts of the velocities and of the displacements since the start of the substep, relative to a rigid
    /// motion in it: the rotation minus 1, the displacement of the origin, and 1 / h.
    void (*settle)(const ClothMotion& motion, float kept_speed, float kept_way, const Matrix<double>& turn,
                   const Vec<double>& shift, double rate);
};

GPHYS_DECLARE_KERNELS(WholeMotionKernels, whole_motion_kernels)

}  // namespace gphys
