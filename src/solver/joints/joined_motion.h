// One substep of joined bodies.
#pragma once

#include "solver/body_table.h"
#include "solver/joints/joints.h"

namespace gphys {

struct CollisionContext;

/// Bodies that are joined, directly or through others, and the systems of their joints.
struct Joined {
    BodyTable& bodies;
    Vector<Joint>& joints;
    const uint32_t *slots_begin, *slots_end;  // of the bodies, ascending
    Vector<JointSystem>& all_systems;
    const uint32_t *systems_begin, *systems_end;  // indices into all_systems
    const Vector<Tether>& all_tethers;            // sorted by body and particle
};

/// visit(body, its slot)
template <class Visit>
void each_body(const Joined& joined, Visit&& visit) {
    for (const uint32_t* slot = joined.slots_begin; slot != joined.slots_end; ++slot) {
        visit(joined.bodies[*slot], *slot);
    }
}

/// One substep of all of them, or the two parts of a substep.
void move_joined(const Joined& joined, const CollisionContext& around, Vec3 gravity, double h);
void begin_joined(const Joined& joined, const CollisionContext& around, Vec3 gravity, double h);
void end_joined(const Joined& joined, const CollisionContext& around, Vec3 gravity, double h);
/// Whether the next substep is the first one after the caller has joined or placed bodies, and rigid joints or links
/// have wrong lengths.
bool starts_misplaced(const Joined& joined);
/// In place of a first part of such a substep, of h seconds: closes joints and links. That is no motion
/// (rope/rope_start.h), so bodies outside must not feel it as contacts would make them.
void close_joined(const Joined& joined, const CollisionContext& around, Vec3 gravity, double h);
/// Solves the joints after the prediction of a substep of h seconds, without contacts, and moves no body. Then
/// add_cluster_response adds the response of a joined cluster to those of its body, in ascending order. Contacts may
/// add impulses to it, which end_joined takes.
void solve_without_contacts(const Joined& joined, double h);
void add_cluster_response(const Joined& joined, uint32_t slot, uint32_t cluster);
/// At the end of a substep, when contacts have added impulses to responses, N s for each unit of mass: changes the
/// velocities of all that is joined to those clusters.
void change_joined_velocities(const Joined& joined);
/// Whether any particle is pinned or attached.
bool has_pin(const Particles& particles);
/// joined_energy.cpp: if one of the bodies is cloth, slows all of them so that a substep gains no energy.
void limit_joined_energy(const Joined& joined, Vec3 gravity);
/// Call at the end of a first substep of h seconds, in place of it: after bodies were placed or joined, maybe with
/// wrong lengths (rope/rope_start.h).
void bound_starting_energy(const Joined& joined, Vec3 gravity, double h);
/// The same for cloth with loads. Call note_joined_energy before links are solved, and slow_joined when the velocities
/// of all bodies and loads are known. That returns the factor of the velocities.
void note_joined_energy(const Joined& joined, Vec3 gravity, double h);
double slow_joined(const Joined& joined, Vec3 gravity);

}  // namespace gphys
