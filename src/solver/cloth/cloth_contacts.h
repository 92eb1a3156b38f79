// Cloth and what it touches, during a step.
//
// At the beginning of a step each particle looks around: it gets a ball in which it may move, and the
// half-spaces that it must stay in there. Models are looked at part by part, each of them convex: a
// primitive, or a triangle of a mesh. The plane through the closest point of a part, across the way to
// it, has the part behind it; a part that is wholly behind the plane of a nearer one adds none. Within
// the ball no other part can be reached, and the half-spaces leave a convex space: a particle that is
// in it before and after a substep has touched nothing on its way. Only one that leaves the ball is
// swept against the scene, and looks around again.
//
// Contacts are part of the chains' equations. A particle that touches moves along the wall or off
// (Surfaces in cloth_kernels.cpp); one that friction holds, because it touches and has no speed, does
// not move at all, until what the links pull it with leaves the cone of friction. What slides is slowed
// by friction times all that the wall has pushed it with in the substep.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"

namespace gphys {

struct Body;
struct Surroundings;

/// A particle stays where dot(normal, its position) >= offset; relative to the cloth's origin.
struct Wall {
    Vec3 normal;
    double offset;
    gphys_model_id model;
};

/// A particle that may touch something in this step.
struct Neighbour {
    static constexpr uint32_t most_walls = 4;

    uint32_t particle;
    uint32_t wall_count;
    Wall walls[most_walls];
    uint32_t touched;     // bit by wall: in this step
    int32_t touching;     // the wall that pressed it most in this substep, or -1
    bool held;            // by friction, in this substep
    bool still;           // it had no speed, where that makes a difference
    double inverse_mass;  // relative, while it is held
    double pressed;       // metres, by how much walls have moved it in this substep
    double total;         // the same with what links pulled it against them by
    double slowed;        // metres, by how much friction has slowed it before the links pulled
    bool slipping;        // what pulled it in the substep before was more than friction holds
    double approach;      // speed towards the wall before it touched
    // For what models get from it:
    bool chained_touching;   // whether it touched before the chains were solved
    Vec3 coming;             // the velocity predicted for the end of this substep
    Vec3 first_pull;         // what `pulls` began with
    Vec3 chained;            // where the chains have left it, before limits
    Vec3 moved;              // metres, by chains and limits; against what walls did, if it touched after them
    gphys_model_id getting;  // the model that gets the next two:
    Vec3 given, turning;     // m/s, what it has lost to it, and the moment of that about the cloth's origin
};

struct ClothContacts {
    explicit ClothContacts(std::pmr::memory_resource* memory)
        : neighbours(memory), place(memory), balls(memory), normals(memory), pulls(memory), escaped(memory) {}

    static constexpr uint32_t nowhere = 0xffffffff;

    Vector<Neighbour> neighbours;
    Vector<uint32_t> place;        // by particle: in neighbours, or nowhere
    Vector<float> balls;           // four floats a particle: centre, square of the radius
    Vector<float> normals, pulls;  // four floats a particle, as ClothSurfaces takes them
    Vector<uint32_t> escaped;      // of this substep
    bool touching = false;         // whether any particle is, in this substep
};

}  // namespace gphys
