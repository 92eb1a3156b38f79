// The list of contacts between particles of different bodies in the last step.
//
// All islands share one array. During a step each island writes its contacts to its own range. After the step the
// ranges are joined at the front of the array; that is the list. Contacts of sleeping bodies stay in it: during a step
// they are at the end of the array, because sleeping particles need no range.
#pragma once

#include "foundation/ids.h"
#include "foundation/memory.h"
#include "gamephys_c.h"

namespace gphys {

class BodyTable;
struct Island;

/// Two particles that touched. Their bodies are in the order of their slots.
struct BodyContact {
    gphys_body_id body_a;
    uint32_t particle_a;
    gphys_body_id body_b;
    uint32_t particle_b;
    gphys_vec3 normal;  // unit, from a to b
    float impulse;      // N s along the normal in this step

    bool operator<(const BodyContact& other) const {
        if (body_a != other.body_a) return body_a < other.body_a;
        if (particle_a != other.particle_a) return particle_a < other.particle_a;
        return body_b != other.body_b ? body_b < other.body_b : particle_b < other.particle_b;
    }
};

/// The contacts of an island in the current step.
class IslandContacts {
public:
    IslandContacts(BodyContact* contacts, uint32_t most, uint32_t* count, uint32_t* sorted)
        : contacts_(contacts), most_(most), count_(count), sorted_(sorted) {}

    static constexpr uint32_t none = 0xffffffff;

    void clear() const { *count_ = *sorted_ = 0; }
    /// Call when indices of contacts are no longer known: sorts the contacts, so that `add` finds them.
    void sort() const;
    /// The index of a contact, which is added if it is new; `none` if there is no room.
    uint32_t add(const BodyContact& contact) const;
    BodyContact& operator[](uint32_t index) const { return contacts_[index]; }

private:
    BodyContact* contacts_;
    uint32_t most_;
    uint32_t *count_, *sorted_;  // contacts, of which the first are sorted
};

class BodyContacts {
public:
    explicit BodyContacts(std::pmr::memory_resource* memory)
        : contacts_(memory), counts_(memory), sorted_counts_(memory) {}

    /// Before a step, for all particles that may collide with other bodies. Throws std::bad_alloc; then the list is as
    /// it was.
    void reserve(uint32_t particles);
    /// Call when nothing can fail any more and all bodies that the step moves are awake. `moving`: their particles that
    /// may collide, which have the first ranges.
    void begin_step(const IdTable& ids, const BodyTable& bodies, uint32_t moving) noexcept;
    IslandContacts of_island(uint32_t first_particle, uint32_t particles);
    /// Call after the step.
    void end_step(const Vector<Island>& islands);
    void clear() { listed_ = 0; }

    const BodyContact* begin() const { return contacts_.data(); }
    const BodyContact* end() const { return contacts_.data() + listed_; }

private:
    Vector<BodyContact> contacts_;
    Vector<uint32_t> counts_, sorted_counts_;  // of the island whose first particle this is
    size_t listed_ = 0, asleep_ = 0;
};

}  // namespace gphys
