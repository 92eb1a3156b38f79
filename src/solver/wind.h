// The air around a body and what it does to it: drag and lift of triangles, drag of links and of free particles
// (formulas: gphys_solver_set_wind).
//
// Forces are those of the velocities at the beginning, of a substep for cloth, which is light for its area and held by
// its links, of a step for all else. They are true forces, also on what is held, until they would turn a velocity
// relative to the air round; then they are limited to what ends it. So any strength is stable.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"

namespace gphys {

struct Body;
struct CollisionContext;

struct Air {
    explicit Air(std::pmr::memory_resource* memory) : velocity(memory), force(memory), rate(memory), steady(memory) {}

    bool blows() const { return wind.density > 0; }

    gphys_wind wind{};
    Vector<Vec3> velocity;  // by particle, beside the wind's; empty: 0

    // Of a step under way, by particle:
    Vector<Vec3> force;    // newtons; during a step of what is not cloth in place of Body::force, which is in it
    Vector<double> rate;   // 1/s, of all forces on the particle together: none changes its velocity faster
    Vector<float> steady;  // of cloth: accelerations without air, as in Cloth
    bool forced = false;   // what Body::forced was
};

/// Makes room; throws std::bad_alloc.
void reserve_air(Body& body);
/// Around all substeps of a body that is no cloth: its forces have those of the air in them.
void begin_air(Body& body, Vec3 gravity, double dt);
void end_air(Body& body);
/// Before a substep of cloth: its accelerations have those of the air in them.
void blow_cloth(Body& body, const CollisionContext& around, double h);

void set_air_velocities(Body& body, uint32_t first, uint32_t count, const gphys_vec3* velocities, uint32_t stride);

}  // namespace gphys
