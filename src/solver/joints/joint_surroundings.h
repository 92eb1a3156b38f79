// The pairs of particles of different bodies that do not collide, because a joint holds them within touch of each
// other.
//
// Contacts would push apart what the joint pulls together: the last particle of a rope and the corner of cloth that it
// is joined to are at one place, and beside a seam the particles of both sheets are nearer than their radii. It is as
// within a body, where linked particles do not collide.
//
// Joints that hold their ends close together may share an end, as where several ropes of a net cross: what they join is
// one knot. Each longer joint has a knot of its own. Around a knot are, in each body, the joined particle, its
// neighbours, and those that are as near along links as two particles reach.
#pragma once

#include "foundation/ids.h"
#include "foundation/memory.h"
#include "solver/joints/joints.h"

namespace gphys {

class JointSurroundings {
public:
    explicit JointSurroundings(std::pmr::memory_resource* memory) : memory_(memory) {}

    /// `slots`: those of the joints that exist. Throws std::bad_alloc.
    void find(const BodyTable& bodies, const Vector<Joint>& joints, const IdTable& slots);
    /// Whether two particles of different bodies do not collide.
    bool has(uint32_t body_a, uint32_t a, uint32_t body_b, uint32_t b) const;

private:
    /// A particle around a knot.
    struct Member {
        uint32_t body, particle, knot;

        bool operator<(const Member& other) const;
    };

    std::pmr::memory_resource* memory_;
    Vector<Member> members_{memory_};  // sorted, each once
};

}  // namespace gphys
