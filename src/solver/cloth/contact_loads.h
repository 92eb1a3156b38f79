// What presses on cloth and is much heavier: balls and rigid clusters of other bodies in a net, on a trampoline.
//
// The contacts between particles are solved before the links of the cloth (contact/particle_contacts.h). A light
// particle would give way to a heavy one there, and its links would pull it back afterwards, without a force on what
// presses. So while the links are solved, each pressed particle has the mass of its share of the load, too, and the
// load moves by the mean of the displacements of its shares (mass splitting; Tonge, Benevolenski and Voroshilov 2012).
// That conserves momentum. A rigid cluster is one load, with its mass and inertia: a share has the mass that the
// cluster has at the pressed particle. The links are swept several times, because heavy and light particles in one
// chain converge slowly, and with the load's motion shared by many chains.
//
// A taut chain resists being pushed aside with twice its tension by the length of a link (the geometric stiffness;
// Tournier, Nesme, Gilles and Faure 2015). Chains are solved with the directions that links had before, which leaves
// this out. In long substeps the chain between a load and a pin would then get its length by throwing its light
// particles aside rather than by moving the load, and sweeps would not converge. So in cloth that pins or models hold,
// the particles that carry no load have at least the mass of that stiffness, all the same one, which changes nothing
// between each other. This mass weighs on what holds the cloth, and where that moves, it would push: so it needs the
// bound of energy below.
//
// The links must not do work on the load: they are a little elastic by their regularisation, and the lengths that
// sweeps give back to them would be a spring without a loss. So the energy of cloth and loads is bounded by what it was
// before the links were solved. On models that move, all with one velocity, it is that in their frame, in which they do
// no work; where pins move, it is that in the frame of their mean velocity, and what they do relative to each other is
// taken, too. A load that a model carries loses only what links have added: the speed that contacts have given it is
// that at which the model holds it. Pins that lift a load off a model have it carried no more.
//
// The reach limits of cloth (reach_limits.h) do not act on it while it has loads.
//
// Cloth that is joined to other bodies is swept in turn with these, and its energy is bounded together with theirs
// (joints/joined_motion.cpp, joined_energy.cpp).
//
// Where cloth is crumpled between loads and a model, the elimination of a chain of very unequal masses has no accurate
// solution, and throws particles and loads far beyond all that moves. Energy could not bring them back. Such sweeps are
// undone, and the links are solved without loads in that substep.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/contact/heavy_body.h"

namespace gphys {

struct Body;
struct ChainContacts;
struct Cloth;
struct ClothState;
struct CollisionContext;

/// The share of a load that presses on one particle of the cloth.
struct ContactLoad {
    uint32_t of;        // the load: the first particle of what moves as one, among the island's contacts
    uint32_t by;        // the particle of it that presses
    uint32_t particle;  // of the cloth
    uint32_t pair;      // of the contact, in the list of the island
    Vec3 normal;        // unit, from the particle to the load
    double friction;    // coefficient of the contact
    Vec3 arm{};         // from the centre of the load to the particle that presses
    // The mass that the particle gains along the normal and across it, relative to the average of the cloth:
    double along = 0, across = 0;
    Vec3 place{};        // of the particle, before the links that are solved next
    Vec3 taken{};        // by the load, of the pulls of links: relative mass * metres
    double impulse = 0;  // along the normal: metres * relative mass; after accelerate_loads, m/s * relative mass
};

struct ContactLoads {
    explicit ContactLoads(std::pmr::memory_resource* memory)
        : all(memory), heavy(memory), is_loaded(memory), predicted(memory) {}

    static constexpr int sweeps = 6;  // over the links, if there is any load

    // Of the substep under way; the shares of a load together, at most one for each particle of the cloth.
    Vector<ContactLoad> all;
    Vector<HeavyBody> heavy;
    Vector<uint8_t> is_loaded;  // by particle of the cloth; empty if there cannot be any load
    Vector<float> predicted;    // ClothState::at before the links are solved
    double seconds = 0;         // of the substep
    double rate = 0;            // 1/s: by which a displacement by links changes the velocity
    double motion = 0;          // before the links are solved: mass * square of the way, of cloth and loads
    bool closed = false;        // whether no energy comes from outside, in `frame`
    bool pins_move = false;     // in this step, of cloth that is not joined
    bool on_moving = false;     // whether models in contact move
    Vec3 frame{};               // m/s: the velocity of those models; or, if pins move, the mean one of pins
    double energy = 0;          // before the links are solved, in that frame

    bool any() const { return !all.empty(); }
};

/// Throws std::bad_alloc.
void reserve_loads(ContactLoads& loads, uint32_t particles, size_t floats);
/// Call when all loads of the substep are known, with `all` in the order of loads.
void begin_loads(Body& body, double h);
/// Call before the links are solved, when contact planes have corrected the prediction.
void note_motion(Cloth& cloth);
/// Call then, for cloth that is not joined: gives its particles the inertia of the tension that will stop the loads.
void add_inertia_of_tension(Cloth& cloth);
/// The same as note_motion of the energy alone, in a substep of `h` seconds.
void note_energy(Cloth& cloth, double h);
/// After something else has moved loaded particles; and when links have moved them.
void note_places(ContactLoads& loads, const ClothState& state);
void move_loads(ContactLoads& loads, const ClothState& state);
/// Call when all sweeps are done: whether they have moved loaded particles farther than the motion before them, and the
/// strain of the links, can have made necessary.
bool links_threw_loads(const Cloth& cloth);
/// Undoes the sweeps. In those that follow, loads neither add to the masses nor move.
void undo_loads(Cloth& cloth);
/// Call when all sweeps are done, for cloth that is not joined: Coulomb's law for loads near a model on which the cloth
/// lies. While links are solved, a load moves with its particles. What contacts and links together have given it
/// across the normal, beyond the friction that its weight allows, is taken back: the cloth has slid under it.
void limit_friction_of_loads(Cloth& cloth);
/// Call when all sweeps are done: takes what loads have taken from the pulls on their particles. The rest acts on the
/// models that these touch.
void take_pulls_of_loads(const ContactLoads& loads, ChainContacts& in_chains);
/// The energy of cloth and loads now, in the frame of the models, per average mass. Call after accelerate_loads.
double energy_after_links(Cloth& cloth);
/// Whether note_motion, and what has followed, tell all work that anything outside of cloth and loads has done.
bool is_energy_known(const Body& body);
/// Call when the velocities are known: adds the links' to those of the loads, and slows cloth and loads so that the
/// links have not added energy. The impulses of the loads become those that have changed the velocities.
void accelerate_loads(Body& body, const CollisionContext& around);
/// Call at the end of the substep.
void clear_loads(ContactLoads& loads);

}  // namespace gphys
