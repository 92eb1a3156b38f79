// What a body is made of: particles, one array per quantity, and distance constraints.
//
// All state is double precision: the rounding of a position 1e5 m from the origin is then 1e-11 m,
// so more substeps never hurt and a body needs no origin of its own. Velocity is stored, not
// derived from old positions.
#pragma once

#include <optional>

#include "foundation/ids.h"
#include "foundation/math.h"
#include "foundation/team.h"
#include "shapes/shapes.h"
#include "solver/cloth/cloth_contacts.h"
#include "solver/cloth/volume.h"
#include "solver/contact/impulses.h"
#include "solver/plan.h"
#include "solver/time_scheme.h"
#include "solver/wind.h"

namespace gphys {

/// |position[b] - position[a]| = rest + compliance * (tension - damping * its rate of change).
struct DistanceConstraint {
    uint32_t a, b;
    double rest, compliance;
    double damping;  // N s/m
    uint64_t limit;  // 1: a maximum distance, which pulls and never pushes; 64 bits, so that there is no padding
};

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

/// A particle that follows a model.
struct Attachment {
    uint32_t particle;
    gphys_model_id model;
    Vec3 local;       // in the model's coordinates
    Vec3 begin, end;  // where it stands at the beginning and at the end of the current step
};

/// How a particle is joined to constraints. The exclusive or of their slots leads along a chain
/// without lists: coming by one constraint, it names the other.
struct Links {
    uint32_t degree = 0, slots = 0;
};

/// A model that a particle touched in the last step; model 0 is none.
struct Touch {
    gphys_model_id model = 0;
    uint32_t tag = 0;
    gphys_vec3 point{}, normal{};
};
constexpr uint32_t touches_per_particle = 4;  // a corner is three models; one more for good measure

/// Crossing all coordinates in the shortest substep, 2e15 m in 1e-9 s, takes 2e24 m/s; beyond this, squares of speeds
/// would soon leave the doubles.
constexpr double fastest_particle = 1e30;

inline bool is_within(double limit, Vec3 value) {
    return std::fabs(value.x) <= limit && std::fabs(value.y) <= limit && std::fabs(value.z) <= limit;
}

/// A particle that leaves the range of coordinates stops at its border, and so does one that is no number any more:
/// then forces were too large for doubles.
inline void keep_in_range(Vec3& position, Vec3& velocity) {
    constexpr double limit = GPHYS_MAX_COORDINATE;
    if (!is_within(fastest_particle, velocity)) velocity = {};
    if (is_within(limit, position)) return;
    const auto kept = [](double x) { return x > -limit ? (x < limit ? x : limit) : -limit; };
    position = {kept(position.x), kept(position.y), kept(position.z)};
    velocity = {};
}
/// The same of what has been solved, which is known to have been somewhere else before: there it stays if it is no
/// number any more.
inline void keep_in_range(Vec3& position, Vec3& velocity, Vec3 before) {
    if (!is_within(std::numeric_limits<double>::max(), position)) position = before, velocity = {};
    keep_in_range(position, velocity);
}

struct BodySettings {
    double damping = 0, friction = 0, static_friction = 0, restitution = 0;
    uint32_t layers = 0;          // of the models it collides with
    uint32_t body_layers = 0;     // of the bodies it collides with
    uint32_t self_collision = 0;  // 1: with itself

    /// Whether what is at rest on a model is held by more than slows what slides.
    bool sticks() const { return static_friction > friction; }
};

/// Of a body at rest.
struct Sleep {
    double calm = 0;  // seconds that it has been at rest
    bool asleep = false;
    Box box;                     // if asleep: what lies in it may wake it,
    uint64_t neighbourhood = 0;  // and this is a hash of that
};

/// Of a substep of cloth.
struct ClothBalance {
    bool closed = false;   // no energy comes from outside
    double gain = 0;       // joules beyond those that forces gave
    double lost = 0;       // and those that what it is joined to has lost with it; of a whole system in the first cloth
    double stored = 0;     // by elastic links, per average mass
    bool current = false;  // whether none has moved since
};

/// Of some of its particles.
struct ClothExtent {
    Aabb box;
    double mass;
};

/// The state of cloth during a step, as cloth_kernels.h takes it: four floats for each particle, and
/// for a few more that do not move.
struct ClothState {
    explicit ClothState(std::pmr::memory_resource* memory)
        : at(memory),
          start(memory),
          moved(memory),
          velocity(memory),
          velocity_before(memory),
          acceleration(memory),
          search_balls(memory),
          sums(memory),
          stored(memory),
          extents(memory),
          tether_diagonal(memory),
          tether_off(memory),
          strained(memory),
          waiting(memory),
          listed(memory) {}

    Vec3 origin;              // of the positions
    double average_mass = 1;  // of the particles
    uint32_t particles = 0;   // that are the body's
    Team* team = nullptr;     // who shares the work of the step under way; null: nobody
    bool pulled = false;      // the caller may have done work on it since the last step
    bool held = false;        // whether any particle does not move freely
    Vector<float> at, start, moved, velocity, velocity_before, acceleration;
    /// Four floats a particle: where it searched for contacts last, relative to the origin, and how far. Empty if the
    /// next step has to begin anew.
    Vector<float> search_balls;
    static constexpr float no_ball = -1;  // how far
    Vector<double> sums;                  // of energy, by block of particles
    Vector<double> stored;                // energy, by batch of chains
    Vector<ClothExtent> extents;          // by share of particles
    ClothBalance balance;
    Vector<float> tether_diagonal, tether_off;  // as ClothTethers takes them; only of joined cloth
    // Of cloth that is relaxed (relax_links.cpp):
    double most_strain = 0;              // of its rigid links; 0: it is not relaxed
    bool braces_yield = false;           // these are not relaxed
    double wanted_substep = 0;           // seconds: the longest that would have done, in the worst substep of this step
    Vector<uint32_t> strained, waiting;  // room for all links
    Vector<uint8_t> listed;              // by KeptLinks::links: whether it is waiting
};

/// What some particles are in, and the largest of their speeds by axis.
struct Extent {
    Aabb box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    Vec3 fastest;

    void add(const Extent& other) {
        box = {min(box.min, other.box.min), max(box.max, other.box.max)};
        fastest = max(fastest, other.fastest);
    }
};

/// Of a body of free particles that workers may share: what it gives to models in a step.
struct FlightPart {
    explicit FlightPart(std::pmr::memory_resource* memory) : impulses(memory) {}

    Vector<ModelImpulse> impulses;
    bool touched = false;
    Extent extent;
};
/// Particles in a part, some 0.3 ms of work: many times what it takes to hand it out.
constexpr uint32_t part_size = 16384;

struct Body {
    explicit Body(std::pmr::memory_resource* memory)
        : position(memory),
          velocity(memory),
          force(memory),
          mass(memory),
          inverse_mass(memory),
          radius(memory),
          air(memory),
          attachments(memory),
          constraint_ids(memory),
          constraints(memory),
          length_changes(memory),
          changed_links(memory),
          links(memory),
          volume(memory),
          rest_position(memory),
          triangles(memory),
          placed(memory),
          linked_begin(memory),
          linked(memory),
          predicted(memory),
          start(memory),
          start_velocity(memory),
          earlier(memory),
          earlier_velocity(memory),
          flying(memory),
          solved(memory),
          touches(memory),
          touch_count(memory),
          impulses(memory),
          parts(memory),
          held(memory),
          stuck(memory),
          cloth(memory),
          cloth_contacts(memory),
          plan(memory) {}

    uint32_t size() const { return static_cast<uint32_t>(position.size()); }
    bool pinned(uint32_t particle) const { return inverse_mass[particle] == 0; }

    gphys_body_kind kind = GPHYS_BODY_PARTICLES;
    BodySettings settings;

    Vector<Vec3> position, velocity, force;
    Vector<double> mass;
    Vector<double> inverse_mass;  // 0: pinned or attached
    Vector<double> radius;
    double smallest_radius = 0, largest_radius = -1;  // < 0: not known
    bool forced = false;                              // whether a force may be other than 0
    Air air;
    Vector<Attachment> attachments;  // by particle

    IdTable constraint_ids;
    Vector<DistanceConstraint> constraints;  // by slot
    Vector<LengthChange> length_changes;     // for the next step, by slot
    Vector<ChangedLink> changed_links;       // the same in the step under way
    Vector<Links> links;                     // by particle
    Volume volume;
    /// Where the particles of a flat sheet stand at rest: the distance of two of them is then the
    /// furthest they can ever be apart. Empty for other bodies and for torn sheets.
    Vector<Vec3> rest_position;
    Vector<uint32_t> triangles;  // of cloth, for drawing

    // Of a body that collides with itself: where its particles were placed, and to which each is linked:
    // linked[linked_begin[p] .. linked_begin[p + 1]], ascending.
    Vector<Vec3> placed;
    Vector<uint32_t> linked_begin, linked;

    // The history that the time scheme needs: the state at the beginning of the substep under way,
    // and the one a substep before it. Of cloth it is in `cloth`.
    Vector<Vec3> predicted;  // where the particles would go without constraints
    Vector<Vec3> start, start_velocity, earlier, earlier_velocity;
    Vector<uint8_t> flying;   // by particle, of ropes with limits: whether none of its links was taut at the start
    double earlier_step = 0;  // seconds between the two; 0 when motion was interrupted, by the caller or a contact
    bool in_stages = false;   // whether the substeps of the step under way are made by both formulas of TimeScheme

    Vector<Vec3> solved;  // of ropes: the positions that the links had found when they met models

    Vector<Touch> touches;          // touches_per_particle each; empty until the body meets a scene
    Vector<uint8_t> touch_count;    // by particle: how many of its touches there are
    Vector<ModelImpulse> impulses;  // by model, of the last step
    Vector<FlightPart> parts;       // of free particles, if there are several; empty between steps
    /// By particle: 0, or if it touched something in the substep under way one more than the place of the
    /// last such in its touches.
    Vector<uint8_t> held;
    Vector<uint32_t> stuck;  // by particle, if it sticks: whether friction has held it to a model, or it rests
    bool touched = false;    // whether any did, unless the caller has interrupted the motion since

    bool joined = false;  // to other bodies, or branched; set at the beginning of a step
    bool near = false;    // particles of it may touch others in this substep
    bool sunk = false;    // some are in models, deeper than they come out at once, in this substep

    std::optional<Extent> extent;  // if a step has found it and nothing has changed since

    Sleep sleep;
    uint32_t substeps = 0;          // of the last step
    uint32_t allowed_substeps = 0;  // of the step under way, by SolverSettings::max_work
    double wanted_substep = 0;      // seconds, as error targets want the next; 0: not measured yet
    ClothState cloth;
    ClothContacts cloth_contacts;
    Plan plan;
};

inline const Attachment* find_attachment(const Body& body, uint32_t particle) {
    const auto before = [](const Attachment& attachment, uint32_t p) { return attachment.particle < p; };
    const auto at = std::lower_bound(body.attachments.begin(), body.attachments.end(), particle, before);
    return at != body.attachments.end() && at->particle == particle ? &*at : nullptr;
}

inline bool is_graph(const Body& body) { return body.plan.method == GPHYS_SOLVE_GRAPH; }

/// Unit. Coincident particles part along a fixed axis: any direction is as good.
inline Vec3 link_direction(const Body& body, uint32_t a, uint32_t b) {
    const Vec3 along = body.position[b] - body.position[a];
    const double length = gphys::length(along);
    return length > 0 ? along / length : Vec3{1, 0, 0};
}
/// What a link of a rope, from a to b, has given to its particle a in a substep, newton seconds.
inline Vec3 link_impulse(const Body& body, uint32_t a, uint32_t b, uint32_t link, const TimeScheme& scheme) {
    const Plan& plan = body.plan;
    return link_direction(body, a, b) * (plan.tension[link] * scheme.h + plan.earlier_tension[link] * scheme.lean);
}

/// Metres by which a constraint is too long or, below 0, too short; a maximum distance is never too short.
inline double excess(const Body& body, const DistanceConstraint& c) {
    const double stretch = distance(body.position[c.a], body.position[c.b]) - c.rest;
    return c.limit ? std::max(0.0, stretch) : stretch;
}

}  // namespace gphys
