// The surface of cloth parts at a particle: a plane through one end of a broken link, normal to the link, divides the
// triangles around that end; those on the side of the other end get a copy of the particle (Mueller, Heidelberger,
// Hennix & Ratcliff 2007, "Position based dynamics"; Souza, von Wangenheim & Comunello 2014, "Fast simulation of cloth
// tearing"). No triangle is lost, and no mass.
//
// The two sides stay joined at their other corners until the loads there break more links, so a crack grows particle
// by particle. A link that is no edge of a triangle (of a rope, or a brace where the surface cannot part) is removed.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"
#include "solver/constraints.h"

namespace gphys {

struct Body;

/// A triangle around a particle, listed under one of its other corners.
struct Spoke {
    uint32_t corner, triangle;

    bool operator<(const Spoke& other) const {
        return corner != other.corner ? corner < other.corner : triangle < other.triangle;
    }
};

/// Memory for tearing.
struct TearSpace {
    explicit TearSpace(std::pmr::memory_resource* source) : memory(source) {}

    std::pmr::memory_resource* memory;
    Vector<uint32_t> link_begin{memory}, links{memory};          // by particle: the slots of its constraints
    Vector<uint32_t> triangle_begin{memory}, triangles{memory};  // by particle: its triangles
    Vector<Spoke> spokes{memory};                                // around the particle where cloth parts, sorted
    Vector<uint32_t> parting{memory};                            // the triangles that get the copy
    Vector<uint8_t> sides{memory};                               // by triangle, while they are divided
    Vector<uint8_t> marks{memory};                               // by particle
    Vector<Links> remaining{memory};                             // for method_of
};

/// Allocates what `count` breaks need. Returns false beyond the capacity of ids. Throws std::bad_alloc; then nothing
/// has changed.
bool reserve_tears(Body& body, uint32_t count);

/// Breaks of one body, one after the other. The neighbourhoods of two tears have no particle in common that parts: the
/// loads around a tear are those of the surface before it.
class Tearing {
public:
    /// After reserve_tears.
    explicit Tearing(Body& body);

    /// Breaks a link. Returns false, and changes nothing, if it is near another break, or if it is an edge and the
    /// surface cannot part at either end. Sets the particles of `out`.
    bool break_link(uint32_t slot, gphys_break& out) noexcept;
    /// Call after the last one.
    void finish() noexcept;

private:
    /// A division of the triangles around a particle.
    struct Division {
        uint32_t particle = 0;
        uint32_t parting = 0, all = 0;  // numbers of triangles
        bool possible = false;
        bool pinned = false, interior = false;  // others are preferred

        bool is_better(const Division& other) const {
            if (possible != other.possible) return possible;
            if (pinned != other.pinned) return other.pinned;
            return !interior && other.interior;
        }
    };

    Division divide(uint32_t particle, uint32_t from) noexcept;
    void part(const Division& division, gphys_break& out) noexcept;
    uint32_t copy_particle(const Division& division) noexcept;
    void share_links(uint32_t particle, uint32_t copy) noexcept;
    uint8_t side_of(uint32_t particle, uint32_t far) const noexcept;
    bool is_edge(uint32_t a, uint32_t b) const noexcept;
    bool is_corner(uint32_t triangle, uint32_t particle) const noexcept;

    Body& body_;
    TearSpace& space_;
    const uint32_t listed_;  // particles in the lists
};

}  // namespace gphys
