// Settings of the solver and of a body.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;

struct SolverSettings {
    Vec3 gravity{0, -9.81, 0};
    uint32_t substeps = 8;
    double fixed_step = 1.0 / 60;
    uint32_t max_steps = 8;
    double sleep_speed = 0;  // m/s; 0: bodies never sleep
    double sleep_strain = 0;
    double sleep_time = 0;                 // seconds
    double max_strain = 0, tolerance = 0;  // error targets, of strain and m/s; 0: none
    uint32_t max_substeps = 64;
    uint32_t max_work = 0;  // particles times substeps of a step; 0: no bound
};

struct BodySettings {
    double damping = 0, friction = 0, static_friction = 0, restitution = 0;
    uint32_t layers = 0;          // of the models it collides with
    uint32_t body_layers = 0;     // of the bodies it collides with
    uint32_t self_collision = 0;  // 1: with itself

    /// Whether static friction is larger than kinetic friction.
    bool sticks() const { return static_friction > friction; }
};

/// If it throws std::bad_alloc, nothing has changed.
void set_settings(Body& body, const BodySettings& settings);

}  // namespace gphys
