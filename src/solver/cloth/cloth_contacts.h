// Contacts of cloth with models, during a step.
//
// At the beginning of a step each particle searches for contacts, unless the contact cache is still valid
// (contact_cache.cpp). It gets a ball in which it may move, and half-spaces that it must stay in there (speculative
// contacts; Catto 2013). Models are handled part by part, each of them convex: a primitive, or a triangle of a mesh.
// The part is behind the plane through its closest point, perpendicular to the direction of the particle. Parts that
// are wholly behind the plane of a nearer one add none. Within the ball no other part can be reached, and the
// half-spaces leave a convex region. So a particle that is in it before and after a substep has hit nothing in between.
// Only a particle that leaves its ball is swept against the scene, and searches again.
//
// The contact planes of a moving model move with it, from substep to substep. A particle searches as far as the model
// can approach in the step. Friction and velocities are relative to the model.
//
// Contacts are part of the equations of chains: a particle in contact moves along the contact plane or away from it
// (Surfaces in cloth_kernels.cpp). After the chains, friction moves it back towards its place on the plane; Coulomb's
// law bounds this by the coefficient times the normal displacement of the substep. Particles that friction holds are
// not pinned in the equations, because links between two pinned particles would stay strained.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/cloth/chain_contacts.h"
#include "solver/cloth/cloth_state.h"
#include "solver/contact/moving_colliders.h"

namespace gphys {

struct AnimationTargets;
struct Body;
struct BodySettings;
struct CollisionContext;
struct TimeScheme;

/// A particle in front of it satisfies dot(normal, position) >= offset; relative to the cloth's origin, at the end of
/// the substep.
struct ContactPlane {
    static constexpr uint32_t unmoved = MovingCollider::unmoved;

    Vec3 normal;
    double offset;
    double thickness;  // metres that the plane is in front of the surface, beyond the contact margin
    gphys_model_id model;
    uint32_t moving_collider;  // index in Cloth::moving_colliders, or unmoved
};

/// The contact state of a particle that may be in contact in this step. Loops over many particles in contact are bound
/// by memory, so members that are used together share cache lines: two lines for the place on one contact plane, two
/// for velocities and impulses.
struct alignas(64) ClothContact {
    static constexpr uint32_t most_planes = 4;

    uint32_t particle;
    uint32_t plane_count;
    uint32_t active_planes;  // bit i: contact plane i was active in this step
    int32_t active_plane;    // the contact plane that pushed it most in this substep, or -1
    // For a particle in contact, in this substep:
    double rest_slip;  // metres: displacement by its own velocity, if that is small enough to count as rest; else -1
    double normal_displacement;  // metres: total displacement by contact planes
    double normal_total;         // metres: the same plus the pull of links against them
    double friction_before;      // metres: displacement that friction has removed before the links
    double cluster_impulse;      // relative mass times metres: what a joined cluster has got by it along the normal
    double approach;  // speed of approach to the contact plane at impact, if it is large enough to bounce; else 0
    bool active_before_chains;  // whether it was active before the chains were solved
    bool held;                  // whether friction holds it at its place on the contact plane
    bool is_at_target;          // whether it is at its target, see below
    bool is_even;               // whether friction holds it as if the model changed its velocity evenly in the step
    Vec3 moved;  // metres: displacement by chains and limits; if it became active after them, by planes, reversed
    ContactPlane planes[most_planes];
    double depth;  // metres behind the plane that it is deepest behind; 0 if it is in no model
    // What contacts with other particles have added to the prediction of this substep, and, in metres, by how much they
    // have pressed it onto models, and what friction has taken of that:
    Vec3 corrected;
    double pressed, pressed_friction;
    Vec3 predicted_velocity;  // if active: the velocity predicted for the end of this substep
    // For the impulses on models:
    gphys_model_id impulse_model;  // the model that gets the next two:
    Vec3 impulse, moment;          // m/s: its impulse on the model per mass, and the moment about the cloth's origin
    // For a particle that is deeper in a model than it can leave at once (leave_solids.cpp):
    uint32_t penetrated_planes;  // bit i: contact plane i is at the particle, not at the surface
    uint32_t deepest_plane;      // index of the plane that it is deepest behind
    Vec3 target;                 // where it shall go, or, while it is there, where the links would move it

    /// Call at the beginning of a step, if the planes of the last step are reused.
    void rest() {
        active_planes = 0;
        active_plane = -1;
        normal_total = friction_before = rest_slip = 0;
    }
};

struct ClothContacts {
    explicit ClothContacts(std::pmr::memory_resource* memory)
        : candidates(memory), active(memory), candidate_of(memory), balls(memory), saved(memory), escaped(memory) {}

    static constexpr uint32_t none = 0xffffffff;

    Vector<ClothContact> candidates;  // particles with contact planes within their balls
    Vector<uint32_t> active;          // indices of the candidates that are in contact in this substep
    Vector<uint32_t> candidate_of;    // by particle: its index in candidates, or none
    Vector<float> balls;              // four floats for each particle: centre, squared radius
    Vector<float> saved;              // positions, by save_positions
    Vector<uint32_t> escaped;         // particles outside their balls; when searching, those that search
    // Sums of those of the candidates in this substep, times their relative masses; and of the pulls on attached
    // particles and pins of a body that has attachments.
    Vec3 impulse, moment;
    bool has_moving_model = false;  // whether any active one is in contact with a moving model
    bool penetrating = false;       // whether any was found in a model
    bool clusters_pushed = false;   // whether models have moved particles of clusters since push_out_clusters

    /// Adds an impulse at a place.
    void add(Vec3 at, Vec3 given) { impulse += given, moment += cross(at, given); }
    bool any_active() const { return !active.empty(); }
    /// Whether a particle has an active contact plane. Only where models are near.
    bool is_active(uint32_t particle) const {
        const uint32_t number = candidate_of[particle];
        return number != none && candidates[number].active_plane >= 0;
    }
    /// `floats`: the length of the arrays of the state. Throws std::bad_alloc.
    void reserve(uint32_t particles, size_t floats);
};

/// The contact plane that a place is deepest behind, or nearest to. `depth`: metres behind it; -infinity without
/// planes.
uint32_t deepest_plane(const ClothContact& contact, Vec3 at, double& depth);
/// Two models that close on a particle, such as a hand and a hip, may leave less room than its diameter. It cannot be
/// in front of both planes then: projected out of one after the other it is thrown to and fro, and each projection
/// counts as normal force, whose friction would tear the cloth along with one of them. So there its thickness yields,
/// to both sides alike, and the particle is in the middle.
void make_room(ClothContact& contact, Vec3 at);
/// At the beginning of a step.
void search_cloth_contacts(Body& body, const CollisionContext& around, Vec3 gravity);
/// Call before a substep: particles that would leave their balls search now, so that the chains know their contact
/// planes.
void search_ahead(Body& body, const CollisionContext& around, Vec3 gravity, double h);
void find_active_planes(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme);
/// Call between that and resolve_contacts, when constraints have moved a particle to another plane than its active one:
/// as if it had been found active, in the direction of which nothing has pulled it yet.
void activate_plane(Body& body, ClothContact& contact, int32_t plane, const TimeScheme& scheme);
/// Where a particle in contact is if it sticks to its place on its active contact plane. `start`: its position at the
/// start of the substep.
Vec3 place_on_plane(const ClothContact& n, const Vector<MovingCollider>& moving_colliders, Vec3 start);
/// Whether a particle is one of a cluster, and friction of its weight alone would let it follow the model of a contact
/// plane if that changed its velocity evenly in the step. A model has one velocity in each step, so it jumps at the
/// beginning: friction of one substep is not enough for that, and a load that it does suffice for would topple. A jump
/// that is too large for this stays one, or a bat would hit with half of its speed along the surface.
bool follows_evenly(const Body& body, uint32_t particle, const ContactPlane& plane, const CollisionContext& around,
                    Vec3 gravity);
void save_positions(ClothContacts& contacts, const ClothState& state);
void resolve_contacts(Body& body);
void add_contact_impulses(Body& body, const CollisionContext& around, double rate);
void solve_contact_velocities(Body& body, const CollisionContext& around, double h);
/// Call if moving models are in contact. Friction moves particles with their models, and so strains links between two
/// particles in contact. Restores the lengths of these links.
void relax_links_in_contact(Body& body);
/// Removes the velocity that corresponds to displacements undone by relax_links since save_positions, for particles in
/// contact.
void stop_undone_motion(Body& body, const CollisionContext& around, double h);
/// Whether friction has held a particle at its place in this substep, on a static model, while no particle of the body
/// is in a model.
bool is_held(const ClothContacts& contacts, uint32_t particle);
/// Displaces a particle, but not into its contact planes or out of the bounds of its target.
void displace(ClothState& state, ClothContacts& contacts, const AnimationTargets& targets, uint32_t particle,
              Vec3 displacement, bool collides);
void sweep_escaped(Body& body, const CollisionContext& around, Vec3 gravity, double h);
void record_contact_points(Body& body, const CollisionContext& around);
/// Records the contact points and impulses of a particle, before its contact state is replaced.
void finish_contact(ClothContact& contact, Body& body, const CollisionContext& around);
/// Projects a particle that has been displaced out of its contact planes.
bool push_out_of_planes(ClothContacts& contacts, ClothState& state, uint32_t particle);
/// Call when contacts with other particles have corrected the predicted position, and have pressed it onto models.
void note_correction(ClothContacts& contacts, uint32_t particle, Vec3 displacement, Vec3 push, Vec3 friction);

}  // namespace gphys
