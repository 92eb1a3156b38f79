// The volume that the triangles of a cloth enclose, as one constraint on all its particles:
//
//     volume = rest - compliance * pressure,   V = sum over triangles of a . (b x c) / 6
//
// Its gradient at a particle is a third of the surrounding area, outward. So pressure pushes the particle with the
// force pressure * gradient, as an enclosed gas does.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"

namespace gphys {

struct Body;
struct ChainContacts;
struct ClothSheet;
struct ClothState;
struct Particles;

struct Volume {
    explicit Volume(std::pmr::memory_resource* memory) : gradient(memory) {}

    bool held = false;
    double rest = 0;        // m^3
    double compliance = 0;  // m^3/Pa; 0: rigid
    double pressure = 0;    // Pa, of the last substep
    /// The Lagrange multiplier, accumulated in the current substep. Times the gradient, it is the displacement of a
    /// particle of average mass, in metres.
    double multiplier = 0;
    Vector<Vec3> gradient;  // by particle
};

/// Whether each edge of a triangle is that of exactly one other triangle, in the opposite direction. Throws
/// std::bad_alloc.
bool encloses_volume(const ClothSheet& sheet);
double volume_of(const ClothSheet& sheet, const Particles& particles);
/// Energy of the compression, joules.
double stored_in_volume(const Volume& constraint, double volume);

/// For the positions of cloth during a substep.
double cloth_volume(const ClothSheet& sheet, const ClothState& state);
/// For cloth during a substep: moves the particles to correct the volume. `scale` is the average mass / step^2;
/// `has_contact`: whether any contact plane is active; `pulls_count`: whether pulls are added up.
void solve_volume(Volume& volume, const ClothSheet& sheet, ClothState& state, ChainContacts& contacts, double scale,
                  bool has_contact, bool pulls_count);

/// rest < 0: the present volume. The body keeps the volume from then on.
gphys_status set_volume(Body& body, double rest, double compliance);
void release_volume(Body& body);

}  // namespace gphys
