// What restricts the particles of a body: distance constraints between two, and attachments to models.
#pragma once

#include "foundation/ids.h"
#include "foundation/math.h"
#include "foundation/memory.h"
#include "foundation/results.h"
#include "gamephys_c.h"

namespace gphys {

struct Body;

/// |position[b] - position[a]| = rest + compliance * (tension - damping * its rate of change).
struct DistanceConstraint {
    uint32_t a, b;
    double rest, compliance;
    double damping;  // N s/m
    uint64_t limit;  // 1: a maximum distance, which pulls and never pushes; 64 bits, so that there is no padding
};

/// A rest length as it is stored. Below a nanometre, the smallest skin of particles, it counts as 0: the rounding of
/// the places of a mesh's vertices is no length that a strain could be relative to.
constexpr double shortest_length = 1e-9;
inline double counted_length(double rest) { return rest < shortest_length ? 0 : rest; }

inline uint32_t other_end(const DistanceConstraint& constraint, uint32_t particle) {
    return constraint.a == particle ? constraint.b : constraint.a;
}

/// A constraint whose length goes from one to that of its constraint during the next step.
struct LengthChange {
    uint64_t slot;  // of the constraint; 64 bits, so that there is no padding
    double from;    // metres
};

/// Where it is in the plan.
struct ChangedLink {
    static constexpr uint32_t none = 0xffffffff;

    uint32_t place = 0;                    // in the arrays of the plan; of cloth in ClothBatches::rest,
    uint32_t damped = none, limit = none;  // and in its lists of such
};

/// A pinned particle that follows a model, or that the caller has moved: then it has no model, and goes to its new
/// place evenly during the next step.
struct Attachment {
    uint32_t particle;
    gphys_model_id model;  // 0: moved by the caller
    Vec3 local;            // in the model's coordinates
    Vec3 begin, end;       // where it stands at the beginning and at the end of the current step
};

/// How a particle is joined to constraints. The exclusive or of their slots leads along a chain
/// without lists: coming by one constraint, it names the other.
struct Links {
    uint32_t degree = 0, slots = 0;
};

struct Constraints {
    explicit Constraints(std::pmr::memory_resource* source) : memory(source) {}

    std::pmr::memory_resource* memory;
    IdTable ids{memory};
    Vector<DistanceConstraint> by_slot{memory};
    Vector<LengthChange> length_changes{memory};  // for the next step, by slot
    Vector<ChangedLink> changed_links{memory};    // the same in the step under way
    Vector<Links> links{memory};                  // by particle
    Vector<Attachment> attachments{memory};       // by particle
};

/// The first attachment of this particle or a later one.
template <class Attachments>
auto attachments_from(Attachments& all, uint32_t particle) {
    const auto before = [](const Attachment& attachment, uint32_t p) { return attachment.particle < p; };
    return std::lower_bound(all.begin(), all.end(), particle, before);
}
/// Of a particle that follows a model or was moved; else null.
inline const Attachment* find_attachment(const Constraints& constraints, uint32_t particle) {
    const auto at = attachments_from(constraints.attachments, particle);
    return at != constraints.attachments.end() && at->particle == particle ? &*at : nullptr;
}
/// Whether any attached particle moves in this step.
inline bool are_carried(const Constraints& constraints) {
    return std::any_of(constraints.attachments.begin(), constraints.attachments.end(),
                       [](const Attachment& attachment) { return attachment.begin != attachment.end; });
}

struct ConstraintOrder {
    bool operator()(const gphys_constraint_info& a, const gphys_constraint_info& b) const { return a.id < b.id; }
};

// Of a body. What may fail, by status or std::bad_alloc, has then changed nothing; else it wakes the body.
/// Adds a constraint to the links of its particles (by = 1), or removes it (-1).
void change_links(Constraints& constraints, uint32_t slot, int by);
/// rest < 0: the present distance.
gphys_status add_constraint(Body& body, const DistanceConstraint& constraint, gphys_constraint_id& out);
/// GPHYS_OK, or the failure that names a stale id.
gphys_status check_constraint(const Constraints& constraints, gphys_constraint_id id);
/// N s/m
gphys_status set_damping(Body& body, gphys_constraint_id id, double damping);
gphys_status remove_constraint(Body& body, gphys_constraint_id id);
/// The same without the checks, in memory that was reserved. These do not wake the body or interrupt its motion.
/// `in_plan`: whether the plan is edited, else it is out of date. Adding returns the slot.
uint32_t insert_constraint(Body& body, const DistanceConstraint& constraint, bool in_plan);
void erase_constraint(Body& body, uint32_t slot, bool in_plan);
/// Replaces an end of a constraint by another particle. Its id stays. Uses memory that reserve_plan_edits has reserved.
void replace_end(Body& body, uint32_t slot, uint32_t from, uint32_t to);
void list_constraints(const Constraints& constraints, Smallest<gphys_constraint_info, ConstraintOrder>& out);

// constraint_settings.cpp: of one constraint, and of some that are there. May throw std::bad_alloc, and then has
// changed nothing.
gphys_constraint_settings settings_of(const DistanceConstraint& constraint);
void set_constraint_settings(Body& body, const gphys_constraint_id* ids, const gphys_constraint_settings* settings,
                             uint32_t stride, uint32_t count);
void forget_length_change(Constraints& constraints, uint32_t slot);

/// Where the constraints whose lengths change in this step are in the plan, which is up to date; and the lengths of
/// these at a fraction of the step. The first throws std::bad_alloc.
void find_changed_links(Body& body);
void change_lengths(Body& body, double fraction);

}  // namespace gphys
