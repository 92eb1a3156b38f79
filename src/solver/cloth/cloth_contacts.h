// Cloth and what it touches, during a step.
//
// At the beginning of a step each particle searches for contacts, unless what it has seen before still holds
// (contact_cache.cpp): it gets a ball in which it may move, and the half-spaces that it must stay in there.
// Models are looked at part by part, each of them convex: a primitive, or a triangle of a mesh. The
// plane through the closest point of a part, across the way to it, has the part behind it; a part that
// is wholly behind the plane of a nearer one adds none. Within the ball no other part can be reached,
// and the half-spaces leave a convex space: a particle that is in it before and after a substep has
// touched nothing on its way. Only one that leaves the ball is swept against the scene, and looks
// around again.
//
// The contact planes of a model that moves go with it, from substep to substep; a particle looks as far for them as the
// model comes in the step. Friction and speed are relative to it.
//
// Contacts are part of the chains' equations: a particle that touches moves along the contact plane or off (Surfaces in
// cloth_kernels.cpp). After the chains friction takes it back, at most by friction times all that the contact plane has
// pushed it with in the substep and at most to its place on the contact plane. Taking it for immovable while friction
// holds it would leave what strains the links between two such particles to stay.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/cloth/moving_colliders.h"

namespace gphys {

struct Body;
struct CollisionContext;
struct TimeScheme;

/// A particle stays where dot(normal, its position) >= offset; relative to the cloth's origin, at the end of the
/// substep.
struct ContactPlane {
    static constexpr uint32_t unmoved = 0xffffffff;

    Vec3 normal;
    double offset;
    gphys_model_id model;
    uint32_t moving_collider;  // its number in ClothContacts::moving_colliders, or unmoved
};

/// A particle that may touch something in this step. What all substeps ask of it comes first, in a cache line or two.
struct alignas(64) Neighbour {
    static constexpr uint32_t most_planes = 4;

    uint32_t particle;
    uint32_t plane_count;
    uint32_t active_planes;  // bit i: contact plane i was active in this step
    int32_t active_plane;    // the contact plane that pushed it most in this substep, or -1
    ContactPlane planes[most_planes];
    // Of one that touches, in this substep:
    double crept;               // metres, which its speed alone takes it, where that counts as none; else -1
    double pressed;             // metres, by how much contact planes have moved it
    double total;               // the same with what links pulled it against them by
    double slowed;              // metres, by how much friction has slowed it before the links pulled
    double approach;            // speed towards the contact plane when it meets it, if that is more than none; else 0
    bool active_before_chains;  // whether it touched before the chains were solved
    bool held;                  // whether friction keeps it at its place on the contact plane
    Vec3 coming;                // if so, the velocity predicted for the end of this substep
    Vec3 chained;               // and where the chains have left it, before limits
    Vec3 moved;  // metres, by chains and limits; against what contact planes did, if it touched after them
    // For what models get from it:
    gphys_model_id getting;  // the model that gets the next two:
    Vec3 given, turning;     // m/s, what it has lost to it, and the moment of that about the cloth's origin
    // Of one that is in a model deeper than it comes out at once (leave_solids.cpp):
    uint32_t sunk_planes;  // bit by contact plane: those that are where the particle is
    uint32_t sunk_most;    // the one that it is deepest behind,
    double depth;          // and by how much: 0 if it is in nothing
    Vec3 aim;              // while it leaves: where it was to go, or the links have left it,
    bool aims;             // and whether it is there

    /// At the beginning of a step.
    void rest() {
        active_planes = 0;
        active_plane = -1;
        total = slowed = crept = 0;
    }
};

struct ClothContacts {
    explicit ClothContacts(std::pmr::memory_resource* memory)
        : moving_colliders(memory),
          neighbours(memory),
          active(memory),
          place(memory),
          balls(memory),
          normals(memory),
          pulls(memory),
          escaped(memory) {}

    static constexpr uint32_t nowhere = 0xffffffff;

    Vector<MovingCollider> moving_colliders;
    Vector<Neighbour> neighbours;
    Vector<uint32_t> active;       // indices of the neighbours that are in contact in this substep
    Vector<uint32_t> place;        // by particle: in neighbours, or nowhere
    Vector<float> balls;           // four floats a particle: centre, square of the radius
    Vector<float> normals, pulls;  // four floats a particle, as ClothSurfaces takes them
    Vector<uint32_t> escaped;      // of this substep; at its beginning those that search for contacts
    Vec3 given, turning;           // as those of the neighbours, of all in this substep, times their relative masses
    uint64_t neighbourhood = 0;    // a hash of the models that were around when the last step ended
    bool pushed = false;           // whether any that touches is, by a model that moves
    bool sunk = false;             // whether any has been found in a model
    bool kept = false;             // whether there was a last step, so that the above are its; not after a snapshot

    bool any_active() const { return !active.empty(); }
};

/// By turns before and after the chains of a substep.
void reserve_cloth_contacts(Body& body);
void search_cloth_contacts(Body& body, const CollisionContext& around, Vec3 gravity);
/// Before a substep: those that it would take out of their balls search for contacts now, so that chains know their
/// contact planes.
void search_ahead(Body& body, const CollisionContext& around, Vec3 gravity, double h);
void find_active_planes(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme);
void note_places(Body& body);
void leave_planes(Body& body);
void count_contacts(Body& body, const CollisionContext& around, double rate);
void turn_velocities(Body& body, const CollisionContext& around, double h);
/// A model that moves carries particles further in a substep than friction should: links between two that touch
/// something get their lengths back.
void ease_links(Body& body);
/// What relaxing links has taken back since note_places of the way of a particle that touches something is no motion.
void stop_taken_back(Body& body, const CollisionContext& around, double h);
/// Whether friction has kept a particle at its place in this substep, on a model that stands still and while none of
/// the body is in one.
bool is_held(const Body& body, uint32_t particle);
/// Moves a particle aside, but not into its contact planes, nor out of what its target allows.
void shift(Body& body, uint32_t particle, Vec3 way, bool collides);
void catch_escaped(Body& body, const CollisionContext& around, Vec3 gravity, double h);
void record_contact_points(Body& body, const CollisionContext& around);
/// What the particle has touched and given to models, before its neighbour is replaced.
void finish_neighbour(Neighbour& neighbour, Body& body, const CollisionContext& around);
/// A particle that something else has moved, out of the contact planes that were near it.
void stay_outside(Body& body, uint32_t particle);

}  // namespace gphys
