// The air around a body and its forces: drag and lift of triangles, drag of links and of free particles (formulas:
// gphys_solver_set_wind).
//
// Forces on triangles and links follow from the velocities at the beginning: of a substep for cloth, which is light for
// its area and held by its links, of a step for ropes. They are the true forces, also on held particles, unless they
// would reverse a velocity relative to the air. Then they are limited to those that end it. Those on free particles
// are means over one or more substeps. So wind of any strength is stable.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"

namespace gphys {

struct Body;
struct CollisionContext;

struct Air {
    explicit Air(std::pmr::memory_resource* memory)
        : velocity(memory), force(memory), rate(memory), steady(memory), relative(memory), cloth_forces(memory) {}

    bool blows() const { return wind.density > 0; }

    gphys_wind wind{};
    Vector<Vec3> velocity;  // by particle, added to the wind's; empty: 0

    // Of the step under way, by particle:
    Vector<Vec3> force;   // newtons; except for cloth, it replaces Particles::force during a step, and includes it
    double lasting = 0;   // seconds for which the force on free particles may stay the same
    Vector<double> rate;  // 1/s, of all forces on the particle: a bound for how fast they change its velocity
    // The same of cloth, see AirOnCloth: four floats each.
    Vector<float> steady, relative, cloth_forces;
    bool forced = false;  // the value of Particles::forced before
};

/// Allocates memory. Throws std::bad_alloc.
void reserve_air(Body& body);
/// Call before and after all substeps of a body that is not cloth: adds the forces of the air to its forces.
void begin_air(Body& body, Vec3 gravity, double dt);
void end_air(Body& body);
/// Whether the body is of free particles in air, whose forces are renewed in the course of a step.
bool flies_in_air(const Body& body);
/// Renews the forces on the particles from first to end for the next h seconds.
void blow_flying(Body& body, Vec3 gravity, double h, uint32_t first, uint32_t end);
/// Call before a substep of cloth: adds the accelerations by the air to its accelerations.
void blow_cloth(Body& body, const CollisionContext& around, double h);

void set_air_velocities(Body& body, uint32_t first, uint32_t count, const gphys_vec3* velocities, uint32_t stride);

}  // namespace gphys
