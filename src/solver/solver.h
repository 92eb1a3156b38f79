// Bodies made of particles and distance constraints, and the step that moves them. A step reads:
// forces -> integrate -> constraints -> collide -> publish, once per substep and body, or per island of
// bodies that influence each other.
//
//   body.h             what a body is composed of; each part is declared by its owner
//   body_table.h       the bodies by slot
//   builders.cpp       adding and removing bodies
//   state.cpp          changes of particles by the caller; moving the origin
//   constraints.cpp    adding and removing constraints
//   settings.cpp       settings of the solver and of bodies
//   constraint_settings.cpp  settings of constraints: winches and muscles
//   plan.cpp           in which order the constraints of a body are solved
//   plan_colours.cpp   chains of cloth and their colours; straight_kernels.cpp: which links continue each other
//   hubs.cpp           particles with many links, around which the sweeps of cloth go there and back
//   prepare.cpp        before a step: plans, memory, broad phase, tasks
//   step.cpp           the step: how each body is moved
//   time_scheme.h      the time integration of constrained bodies
//   islands.cpp        bodies that influence each other, moved in one task
//   jumps.cpp          models that jump, and bodies that are attached to them
//   sleep.cpp          bodies at rest; steady.cpp: bodies that a step would leave as they are
//   wind.cpp           drag and lift
//   tearing/           links that break, and cloth that tears
//   animation_targets.cpp  positions from an animation, and how far from there particles may be
//   state_range.cpp    the range of numbers in which a step ends
//   error_targets.cpp  the number of substeps of a body
//   stats.cpp          strain, energy, contacts
//   body_meshes.cpp    bodies as meshes in scenes
//   particles/         bodies without constraints: exact flight and impacts
//   rope/              chains and trees: Newton's method on the whole chain
//     plan_chains.cpp    its chains
//     rope_substep.cpp   a substep of a rope, also in contact with models
//     rope_stepper.h     one rope, from one system of equations to the next
//     stages_kernels.cpp whether a substep has two stages (TR-BDF2), for a seventh of the error
//     rope_direct.cpp    links of a single rope, by block elimination
//     rope_contacts.cpp  contacts with models, as part of its equations; rope_contact_search.cpp: the search for them
//     rope_lanes.cpp     undisturbed ropes, eight side by side
//     rope_contact_lanes.cpp  ropes that may touch models, their equations solved side by side
//     rope_kernels.cpp   what these two compute; rope_layout_kernels.cpp: gather and scatter
//     rope_start.cpp     the first substep after links were placed with wrong lengths
//     rope_limits.cpp    links that only pull
//     damping.h          damped links as undamped ones with other parameters
//   cloth/             cloth and graphs: colours of chains
//     plan_cloth.cpp     chains and limits, packed for the kernels
//     plan_edits.cpp     its chains when a constraint comes or goes
//     rigid_links.cpp    adjacency lists, for reach limits; braces.cpp: diagonals that may yield
//     cloth.h            the parts of its state, each with its own header
//     cloth.cpp          a substep
//     cloth_state.cpp    positions and velocities in the layout of the kernels; cloth_shares.h: work of several threads
//     cloth_chains.cpp   sweeps over the chains
//     cloth_energy.cpp   the energy balance of a substep; whole_motion.cpp: momentum and angular momentum
//     cloth_attachments.cpp  particles attached to models
//     cloth_contacts.cpp contacts with models, as part of its chains
//     cloth_targets.cpp  its animation targets, as part of its chains
//     settling.cpp       cloth that lies on models or hangs comes to rest
//     relax_links.cpp    links that chains have left strained; kept_links.cpp: which links, all but braces
//     yielding_chords.cpp  collapsed cloth, whose diagonals and links against bending yield
//     contact_search.cpp the search for contact planes; contact_cache.cpp: reuse from step to step
//     reach_limits.cpp   long range attachments to pins
//     volume.cpp         the enclosed volume of closed cloth
//     clusters.cpp       particles that keep their shape; cluster_edits.cpp, best_rotation.cpp
//   contact/           particles against the scene and against particles; impulses on models; lists of contacts
//   joints/            joints between bodies: Newton's method on joined chains and clusters, by sparse elimination
//   snapshot/          the whole state as words, and back; its hash
#pragma once

#include "foundation/results.h"
#include "foundation/workers.h"
#include "scene/scene.h"
#include "solver/body_meshes.h"
#include "solver/body_table.h"
#include "solver/contact/collision_memory.h"
#include "solver/contact/impulse_sums.h"
#include "solver/contact/particle_contacts.h"
#include "solver/islands.h"
#include "solver/joints/joined_motion.h"
#include "solver/joints/joint_surroundings.h"
#include "solver/jumps.h"
#include "solver/particles/flight_planes.h"
#include "solver/rope/rope_lanes.h"
#include "solver/rope/rope_stepper.h"

namespace gphys {

/// The strain to which links of cloth are relaxed if no target is set.
constexpr double usual_cloth_strain = 0.02;
constexpr uint32_t most_substeps = 1000;
constexpr float shortest_step = 1e-6f, longest_step = 0.5f;  // seconds

/// All state that the next step depends on, except the scene. Snapshots contain it.
struct SolverState {
    explicit SolverState(Memory* memory)
        : ids(memory), bodies(memory), joint_ids(memory), joints(memory), near_models(memory) {}

    SolverSettings settings;
    Vec3 origin;             // in the world, of all coordinates
    double accumulator = 0;  // seconds that advance has not simulated yet, less than a step
    IdTable ids;
    BodyTable bodies;
    IdTable joint_ids;
    Vector<Joint> joints;             // by slot
    Vector<PlacedModel> near_models;  // models near the bodies, where they were at the last step
};

/// Order: by body, particle, model.
struct ContactOrder {
    bool operator()(const gphys_contact& a, const gphys_contact& b) const {
        if (a.body != b.body) return a.body < b.body;
        return a.particle != b.particle ? a.particle < b.particle : a.model < b.model;
    }
};
struct BodyContactOrder {
    bool operator()(const gphys_body_contact& a, const gphys_body_contact& b) const {
        if (a.body_a != b.body_a) return a.body_a < b.body_a;
        if (a.particle_a != b.particle_a) return a.particle_a < b.particle_a;
        return a.body_b != b.body_b ? a.body_b < b.body_b : a.particle_b < b.particle_b;
    }
};
struct ImpulseOrder {
    bool operator()(const gphys_impulse& a, const gphys_impulse& b) const { return a.model < b.model; }
};
/// A size, a mass or a factor that callers may give.
inline bool is_amount(double value) { return value >= 0 && value <= double{GPHYS_MAX_COORDINATE}; }

struct JointOrder {
    bool operator()(const gphys_joint_info& a, const gphys_joint_info& b) const { return a.id < b.id; }
};

class Solver {
public:
    Solver(const gphys_allocator* hooks, const SolverSettings& settings, uint32_t worker_count = 1,
           const gphys_task_runner* task_runner = nullptr)
        : memory(hooks), workers_(worker_count, task_runner, &memory) {
        state_.settings = settings;
    }
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;

    Memory memory;

    /// Wakes all bodies if it changes.
    void set_gravity(Vec3 gravity);
    /// For a body, or 0 for all.
    void set_wind(gphys_body_id of, const gphys_wind& wind);
    /// settings.cpp
    void set_settings(const SolverSettings& settings);
    void set_substeps(uint32_t substeps) { state_.settings.substeps = substeps; }
    const SolverSettings& settings() const { return state_.settings; }
    uint32_t worker_count() const { return workers_.count(); }
    void set_worker_count(uint32_t count) { workers_.set_count(count); }
    /// All particles stay where they are in the world, and wake. Returns false if one would leave the range of
    /// coordinates.
    bool set_origin(Vec3 origin);
    Vec3 origin() const { return state_.origin; }

    // Bodies. Values have been checked. A function that fails, by status or std::bad_alloc, changes nothing.

    gphys_status add_particles(const gphys_body_desc& desc, const gphys_vec3* positions, uint32_t stride,
                               uint32_t count, gphys_body_id& out);
    /// link_length 0: the lengths as placed.
    gphys_status add_rope(const gphys_body_desc& desc, const gphys_vec3* positions, uint32_t stride, uint32_t count,
                          double link_length, gphys_body_id& out);
    gphys_status add_cloth(const gphys_body_desc& desc, Vec3 corner, Vec3 edge_u, Vec3 edge_v, uint32_t columns,
                           uint32_t rows, gphys_body_id& out);
    gphys_status add_cloth_mesh(const gphys_body_desc& desc, const Mesh& mesh, const Transform& placement,
                                gphys_body_id& out);
    gphys_status remove(gphys_body_id body);

    /// GPHYS_OK, or the failure that names a stale id.
    gphys_status check(gphys_body_id body) const;
    void list(Smallest<gphys_body_id>& out) const;
    /// The id must be valid.
    const Body& body(gphys_body_id id) const { return state_.bodies[IdTable::slot_of(id)]; }

    /// For functions that wake it themselves, after their checks.
    Body& body(gphys_body_id id) { return state_.bodies[IdTable::slot_of(id)]; }
    /// The body, to be changed: wakes it.
    Body& edit(gphys_body_id id) {
        Body& body = state_.bodies[IdTable::slot_of(id)];
        wake(body);
        return body;
    }
    void wake_all();
    void list_sleeping(Smallest<gphys_body_id>& out) const;

    /// A mesh in the form of a body, which follows it from now on. The caller owns a reference.
    Mesh* make_mesh(const gphys_allocator* hooks, gphys_body_id id) { return meshes_.make(hooks, id, body(id)); }
    void update_mesh(gphys_body_id id) noexcept { meshes_.follow(id, body(id)); }

    // joints.cpp. Bodies and particles must exist; rest < 0: the present distance.
    gphys_status join(gphys_body_id body_a, uint32_t particle_a, gphys_body_id body_b, uint32_t particle_b, double rest,
                      double compliance, gphys_joint_id& out);
    gphys_status unjoin(gphys_joint_id joint);
    /// For one body, or 0 for all.
    void list_joints(gphys_body_id of, Smallest<gphys_joint_info, JointOrder>& out) const;

    /// May throw std::bad_alloc before anything has moved, not after. Then all state in snapshots is unchanged.
    void step(const Scene* scene, double dt);
    /// `steps` are those made. Throws std::bad_alloc if there is no memory for the first step; if there is none for a
    /// later one, that and those after it are left out.
    void advance(const Scene* scene, double frame_time, uint32_t& steps);
    /// The fraction of a step that advance still owes, 0 to 1.
    double leftover() const { return state_.accumulator / state_.settings.fixed_step; }

    /// For one body, or 0 for all.
    gphys_solver_stats stats(gphys_body_id body) const;
    void contacts(Smallest<gphys_contact, ContactOrder>& out) const;
    void body_contacts(Smallest<gphys_body_contact, BodyContactOrder>& out) const;
    void impulses(Smallest<gphys_impulse, ImpulseOrder>& out) const;

    // tearing/breaks.cpp
    /// Breaks a constraint, as a load would.
    gphys_status break_constraint(gphys_body_id body, gphys_constraint_id constraint, gphys_break& out);
    /// Those of the last step or frame, in their order.
    const Vector<gphys_break>& breaks() const { return breaks_; }

    // snapshot.cpp
    void hash(uint32_t (&out)[2]) const;
    /// Returns GPHYS_INCOMPLETE, and writes nothing, if it does not fit.
    gphys_status snapshot(uint32_t* out, uint32_t capacity, uint32_t& total) const;
    /// Throws std::bad_alloc. A failure changes nothing.
    gphys_status restore(const uint32_t* words, uint32_t count);

private:
    /// A body of the step under way.
    struct ActiveBody {
        uint32_t size, slot, substeps;
        uint32_t chains;                 // of its constraints
        uint32_t parts;                  // into which its particles are divided; 0: it is moved as a whole
        bool plain = false;              // a rope that the kernels support
        bool undisturbed = false;        // a plain rope that hits nothing while it stays in `reachable`
        bool restarts = false;           // of undisturbed ropes: the time scheme does, after an interruption
        double fastest = 0;              // m/s, bound of the particles' speeds
        Box reachable{};                 // what it can reach in this step
        Box search_box{};                // the same, enlarged for models that move
        uint32_t near_model_count = 0;   // models in search_box
        uint32_t moved_model_count = 0;  // models that have moved and come into search_box
        bool models_move = false;        // whether some of them come into `reachable`
        bool in_island = false;          // moved by the task of an island
        bool jumps = false;              // with a model that it is attached to

        bool near_models() const { return near_model_count > 0 || models_move; }
        /// Whether its equations are solved in the kernels, together with contacts (RopeContactLanes).
        bool has_contact_lane() const { return plain && chains == 1 && near_models(); }
        /// Whether other ropes take the lanes beside it.
        bool shares_contact_lanes() const {
            return has_contact_lane() && !undisturbed && size <= longest_rope_in_lanes;
        }
        /// Whether two undisturbed ropes can be moved side by side.
        bool can_share_lanes(const ActiveBody& other) const {
            return chains == 1 && other.chains == 1 && restarts == other.restarts && substeps == other.substeps;
        }
        /// The order of tasks: other bodies, then ropes that share contact lanes, then undisturbed ropes, those that
        /// can share lanes next to each other. The largest first, so that no worker begins a large body when the
        /// others are done.
        bool operator<(const ActiveBody& other) const {
            if (undisturbed != other.undisturbed) return other.undisturbed;
            if (shares_contact_lanes() != other.shares_contact_lanes()) return other.shares_contact_lanes();
            if (undisturbed && restarts != other.restarts) return restarts;
            if (undisturbed && chains != other.chains) return chains > other.chains;
            if (undisturbed && substeps != other.substeps) return substeps > other.substeps;
            return size != other.size ? size > other.size : slot < other.slot;
        }
    };
    /// The unit of work of one worker: one body, a part of one, or ropes that are moved side by side.
    struct Task {
        uint32_t first, count;  // in active_
        bool shared;            // one cloth, for all workers at once
        uint32_t part;          // of a body that is divided
    };
    /// Some particles of an active body.
    struct ParticleRange {
        uint32_t active, first;
        Extent extent;
    };

    /// What prepare has changed in a body and snapshots hold, to restore it if the step runs out of memory.
    struct Undo {
        Undo(uint32_t slot_, const Body& body, std::pmr::memory_resource* memory)
            : slot(slot_),
              chains_current(body.plan.chains_current),
              reach_current(body.plan.reach_current),
              earlier_step(body.history.earlier_step),
              attachments(memory),
              reach_limits(memory) {}
        void apply(Body& body);

        uint32_t slot;
        bool chains_current, reach_current;
        double earlier_step;
        Vector<Attachment> attachments;   // if some were released
        Vector<ReachLimit> reach_limits;  // if they have been planned again
    };

    gphys_status insert(BodyOwner body, gphys_body_id& out);
    /// The first step of a frame clears the list of breaks.
    void simulate(const Scene* scene, double dt, bool first);
    void see(const Scene& scene, gphys_model_id model);
    void see_attached_models(const Scene* scene, const Constraints& constraints, size_t first);
    void list_moved_models(const Scene& scene);
    void update_meshes(Vec3 shift = {}) noexcept;
    void prepare(const Scene* scene, double dt);
    void prepare_body(uint32_t slot, const Scene* scene, double dt);
    void begin_step(const Scene* scene) noexcept;
    void make_tasks();
    void divide_bodies();
    void reserve_flight_planes();
    void reserve_collision_memory();
    bool is_worth_sharing(const ActiveBody& active, size_t particles) const;
    void move_shared(const ActiveBody& active, const Scene* scene, double dt);
    void move_shared(Island& island, const Scene* scene, double dt);
    SharingTrial& sharing_trial(const Island& island) {
        return state_.bodies[island_bodies_[island.first_body]].cloth.shares.trial;
    }
    void begin_body_step(const ActiveBody& active, const Scene* scene, double dt);
    void end_body_step(Body& body, const Scene* scene, double dt, uint32_t substeps);
    uint32_t move_in_substeps(Body& body, uint32_t count, const CollisionContext& step);
    RopeStepper begin_rope_step(const ActiveBody& active, RopeContacts& contacts, uint32_t worker, const Scene* scene,
                                double dt);
    void end_rope_step(const RopeStepper& rope, const Scene* scene, double dt);
    template <int lanes>
    void move_contact_lanes(const ActiveBody* ropes, uint32_t count, uint32_t worker, const Scene* scene, double dt);
    void move_body(const ActiveBody& active, uint32_t worker, const Scene* scene, double dt);
    void move_part(const Task& task, uint32_t worker, const Scene* scene, double dt);
    void move_undisturbed(const Task& task, uint32_t worker, const Scene* scene, double dt);
    CollisionContext context_of(const Scene* scene, double dt, double begin, double end) const {
        return {scene, &moved_models_, dt, begin, end, share_};
    }
    /// With the memory of a worker, for collisions.
    CollisionContext context_of(const Scene* scene, uint32_t worker, double dt, double begin, double end) {
        return {scene, &moved_models_, dt, begin, end, share_, scene ? &collision_memory_[worker] : nullptr};
    }
    FlightPlanes* flight_planes(uint32_t worker, const Scene* scene) {
        return scene ? &flight_planes_[worker] : nullptr;
    }
    void remove_joint(uint32_t slot);
    void remove_joints_of(uint32_t body);
    void plan_joints();
    void unite_bodies(const Scene* scene, double dt);
    void unite_near_bodies(DisjointSets& sets, double dt);
    void list_islands();
    void move_colliding(const Island& island, const Joined& joined, const CollisionContext& around, double h,
                        FlightPlanes* planes);
    void move_island(const Island& island, uint32_t worker, const Scene* scene, double dt);
    /// Whether the body sleeps and nothing wakes it.
    bool stays_asleep(const Body& body, const Scene* scene);
    /// steady.cpp: whether a step, from the state after the last one, would change nothing.
    bool stays_steady(const Body& body, const Scene* scene, double dt);
    void list_near_models(const Scene& scene, double dt);
    void limit_work(double dt);
    void find_disturbed(const Scene& scene);
    void add_impulses();
    void reserve_breaks();
    void break_overloaded(double dt) noexcept;

    Workers workers_;
    SolverState state_{&memory};
    /// The next state_.near_models, with the present places; and those of state_.near_models that have moved since.
    Vector<PlacedModel> next_near_models_{&memory};
    /// Seconds in which the models move from the places at the last step to the present ones, and the part of this way
    /// in the step under way. Of steps of a frame that are not the last, it is less than 1.
    double model_time_ = 0, share_ = 1;
    Vector<MovedModel> moved_models_{&memory};
    Vector<ActiveBody> active_{&memory};
    Vector<Undo> undo_{&memory};
    Vector<Task> tasks_{&memory};
    Vector<ParticleRange> ranges_{&memory};
    ThreadArena scratch_memory_{&memory};
    Vector<RopeScratch> rope_scratch_{&memory};  // by worker
    // By worker, from the first step beside a scene on:
    Vector<FlightPlanes> flight_planes_{&memory};
    Vector<CollisionMemory> collision_memory_{&memory};
    ImpulseSums impulse_sums_{&memory};  // of the last step
    /// By slot of a body: the root of its set (union-find), whether the set of that root is awake, and whether it is in
    /// an island.
    Vector<uint32_t> set_of_{&memory};
    Vector<uint8_t> awake_{&memory}, in_island_{&memory};
    /// Of the step under way: the islands, their bodies by set, those of them that are joined, and their systems.
    Vector<Island> islands_{&memory};
    Vector<uint32_t> island_bodies_{&memory}, joined_bodies_{&memory}, island_systems_{&memory};
    /// The systems of the joints, and whether they are up to date with joints and chains.
    Vector<JointSystem> systems_{&memory};
    Vector<Tether> tethers_{&memory};
    bool joints_current_ = false;
    Vector<gphys_break> breaks_{&memory};
    ParticleContacts particle_contacts_{&memory};
    /// Boxes around bodies that collide with others, for one step.
    struct SweptBounds {
        uint32_t slot;
        Aabb box;
    };
    Vector<SweptBounds> swept_bounds_{&memory};
    BodyMeshes meshes_{&memory};
    JointSurroundings beside_joints_{&memory};
};

}  // namespace gphys
