// Changes of the particles of a body by the caller.
#pragma once

#include "foundation/math.h"
#include "gamephys_c.h"

namespace gphys {

struct Body;
struct Constraints;

/// The caller has interrupted the motion: the time scheme must not use the history before this moment.
void interrupt(Body& body);
/// Pinned particles that are moved alone go there during the next step. If free ones are among them, or were placed
/// since the last step, all are placed at once. Throws std::bad_alloc before it changes anything.
void set_positions(Body& body, uint32_t first, uint32_t count, const gphys_vec3* positions, uint32_t stride);
void set_velocities(Body& body, uint32_t first, uint32_t count, const gphys_vec3* velocities, uint32_t stride);
void set_masses(Body& body, uint32_t first, uint32_t count, const float* masses, uint32_t stride);
void set_radii(Body& body, uint32_t first, uint32_t count, const float* radii, uint32_t stride);
/// Throws std::bad_alloc before it changes anything, and then wakes the body.
void set_friction_factors(Body& body, uint32_t first, uint32_t count, const float* factors, uint32_t stride);
void set_forces(Body& body, uint32_t first, uint32_t count, const gphys_vec3* forces, uint32_t stride);
/// Call at the end of a step. `way`: the fraction of the way of pins that it has covered; the rest is for the next one.
void end_moved_pins(Body& body, double way);
void set_pinned(Body& body, uint32_t first, uint32_t count, bool pinned);
/// Whether it follows a model.
bool is_attached(const Constraints& constraints, uint32_t particle);
// These may fail, by status or std::bad_alloc. If they do not, they wake the body.
void attach(Body& body, uint32_t particle, gphys_model_id model, Vec3 local);

}  // namespace gphys
