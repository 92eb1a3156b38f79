// Heavy particles of other bodies that press on cloth: balls in a net, a trampoline.
//
// The contacts between particles are solved before the links of the cloth (contact/particle_contacts.h). A light
// particle would give way to a heavy one there, and its links would pull it back afterwards, without a force on what
// presses. So while the links are solved, each pressed particle has the mass of its share of the load, too, and the
// load moves by the mean of the displacements of its shares (mass splitting; Tonge, Benevolenski and Voroshilov 2012).
// That conserves momentum. The links are swept several times, because heavy and light particles in one chain converge
// slowly, and with the load's motion shared by many chains.
//
// The links must not do work on the load: they are a little elastic by their regularisation, and the lengths that
// sweeps give back to them would be a spring without a loss. So the energy of cloth and loads is bounded by what it was
// before the links were solved.
//
// Where cloth is crumpled between loads and a model, the elimination of a chain of very unequal masses has no accurate
// solution, and throws particles and loads far beyond all that moves. Energy could not bring them back. Such sweeps are
// undone, and the links are solved without loads in that substep.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

struct Body;
struct Cloth;
struct ClothState;

/// The share of a heavy particle that presses on one particle of the cloth.
struct ContactLoad {
    uint32_t by;        // what presses: a particle of the island's contacts
    uint32_t particle;  // of the cloth
    uint32_t pair;      // of the contact, in the list of the island
    Vec3 normal;        // unit, from the particle to the load
    // The mass that the particle gains along the normal and across it, relative to the average of the cloth:
    double along = 0, across = 0;
    Vec3 place{};        // of the particle, before the links that are solved next
    double impulse = 0;  // along the normal: metres * relative mass; after accelerate_loads, m/s * relative mass
};

/// What presses, and its motion. Positions are relative to the cloth's origin.
struct HeavyParticle {
    uint32_t by;           // as in ContactLoad
    double mass;           // relative to the average of the cloth
    Vec3 place, velocity;  // when the contacts are solved
    Vec3 acceleration;     // by gravity and forces
    uint32_t end = 0;      // its shares are those before this one and after those of the particle before it
    Vec3 moved{};          // by the links
    Vec3 before{};         // the velocity without them
};

struct ContactLoads {
    explicit ContactLoads(std::pmr::memory_resource* memory)
        : all(memory), heavy(memory), is_loaded(memory), predicted(memory) {}

    static constexpr int sweeps = 6;  // over the links, if there is any load

    // Of the substep under way; the loads of a heavy particle together, at most one for each particle of the cloth.
    Vector<ContactLoad> all;
    Vector<HeavyParticle> heavy;
    Vector<uint8_t> is_loaded;  // by particle of the cloth; empty if there cannot be any load
    Vector<float> predicted;    // ClothState::at before the links are solved
    double motion = 0;          // before the links are solved: mass * square of the way, of cloth and loads
    bool closed = false;        // whether no energy comes from outside
    double energy = 0;          // before the links are solved, see limit_energy_of_loads

    bool any() const { return !all.empty(); }
};

/// Throws std::bad_alloc.
void reserve_loads(ContactLoads& loads, uint32_t particles, size_t floats);
/// Call when all loads of the substep are known, in the order of what presses: `all` and `heavy`.
void begin_loads(Body& body, double h);
/// Before the links are solved, or after something else has moved loaded particles; and when links have moved them.
void note_places(ContactLoads& loads, const ClothState& state);
void move_loads(ContactLoads& loads, const ClothState& state);
/// Call when all sweeps are done: whether they have moved loaded particles farther than the motion before them, and the
/// strain of the links, can have made necessary.
bool links_threw_loads(const Cloth& cloth);
/// Undoes the sweeps. In those that follow, loads neither add to the masses nor move.
void undo_loads(Cloth& cloth);
/// Undoes the motion of loaded particles since note_places.
void restore_places(const ContactLoads& loads, ClothState& state);
/// Call when the velocities are known: adds the links' to those of the heavy particles, and slows cloth and loads so
/// that the links have not added energy. The impulses of the loads become those that have changed the velocities.
void accelerate_loads(Body& body, double h);
/// Call at the end of the substep.
void clear_loads(ContactLoads& loads);

}  // namespace gphys
