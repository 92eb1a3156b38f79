// A scene, a camera and a solver that a random program creates, edits, asks and steps, beside what they must hold.
//
// The model of the scene is the list of its models as they were given; queries are compared with all of them asked
// one by one (placed_model.h). Of the solver the hash is known: a call that fails leaves it, a snapshot brings it
// back, and a second solver that is given the same calls, with workers that take their tasks in reverse, has it too.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "check.h"
#include "memory_hooks.h"
#include "mesh_source.h"
#include "placed_model.h"
#include "program.h"

namespace fuzz {

struct Model {
    gphys_model_id id, parent;
    uint32_t layers, tag;
    AnyShape shape;            // type GPHYS_SHAPE_MESH: mesh is set
    const MeshSource* source;  // of a mesh
    gphys_transform local, world;
    gphys_vec3 scale{1, 1, 1};
};

class World {
public:
    explicit World(Program& program);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    void run();

private:
    using Op = void (World::*)();

    // world_scene.cpp: changes of the scene, and what it says about itself
    void create_scene();
    void add();
    void add_batch();
    void remove();
    void remove_batch();
    void remove_subtree();
    void clear();
    void set_transform();
    void set_transforms();
    void set_parent();
    void set_properties();
    void set_shape();
    void set_scale();
    gphys_vec3 any_scale();
    void set_scene_origin();
    void inspect_scene();
    void misuse_scene();
    gphys_model_id any_id();  // mostly of a model, sometimes stale or never given out
    const Model* model(gphys_model_id id) const;
    Model* model(gphys_model_id id);
    bool is_below(gphys_model_id id, gphys_model_id ancestor) const;
    void forget(gphys_model_id id);
    void follow_parents();  // world transforms of the models, parents first
    void read_locals();

    // world_scene_snapshot.cpp
    void save_scene();
    void restore_scene();
    void restore_forged_scene();
    uint64_t scene_hash() const;
    std::vector<uint32_t> scene_snapshot(int32_t embed_meshes) const;

    // world_queries.cpp: the scene against all models, one by one
    uint32_t mask();
    AnyShape solid();
    std::vector<PlacedModel> placed(uint32_t layers) const;
    void raycast();
    void segment_test();
    void overlap();
    void nearest();
    void sweep();
    void sweep_solid();
    void ways_out();
    void cull();
    void ray_batches();
    void other_batches();
    void query_misuse();

    // world_filter.cpp: those that leave out models
    void make_filter(gphys_query_filter_desc& filter, std::vector<gphys_model_id>& list);
    bool is_left_out(gphys_model_id id, const gphys_query_filter_desc& filter) const;
    void filtered_queries();
    void filtered_batches();

    // world_camera.cpp
    void create_camera();
    void place_camera();
    void project_camera();
    void orbit();
    void view_camera();
    void rectangles();
    void inspect_camera();
    void project();
    void pick();
    void pick_lists();

    // world_solver.cpp
    void create_solver();
    void add_body();
    void remove_body();
    void set_state();
    void constrain();
    void join();
    void attach();
    void volume();
    void cluster(gphys_body_id body, uint32_t choice);
    void tear(gphys_body_id body, float force);
    void settings();
    void change_body();
    void change_constraints();
    void move_solver_origin(const double* origin);
    void step();
    void follow_solver();
    void snapshot();
    void inspect_solver();
    void show_body();
    void check_shown();
    void forget_shown();
    void solver_misuse();
    gphys_body_id any_body();
    uint64_t hash(const gphys_solver* solver) const;
    /// Make the same call on both solvers, on the first at times without memory: on an error neither has changed.
    template <class Call>
    gphys_status on_both(const char* failing_call_changes_nothing, Call&& make);

    Program& p_;
    MemoryHooks memory_;
    std::vector<MeshSource> sources_;
    std::vector<MeshHandle> meshes_;
    gphys_scene* scene_ = nullptr;
    std::vector<Model> models_;  // by id
    std::vector<gphys_model_id> stale_;
    std::vector<uint32_t> saved_scene_;
    std::vector<Model> saved_models_;
    std::vector<gphys_model_id> saved_stale_;
    uint64_t saved_hash_ = 0;
    int32_t saved_meshes_ = 0;  // whether they are in it
    gphys_camera* camera_ = nullptr;
    gphys_solver* solver_ = nullptr;
    gphys_solver* twin_ = nullptr;
    std::vector<gphys_body_id> bodies_, stale_bodies_;
    std::vector<uint32_t> snapshot_;
    uint64_t snapshot_hash_ = 0;
    std::vector<gphys_body_id> snapshot_bodies_;
    // A body as a model, in a scene of its own.
    gphys_scene* gallery_ = nullptr;
    gphys_mesh* shown_mesh_ = nullptr;
    gphys_body_id shown_ = 0;  // 0: it is gone, or may have other parts
    int steps_ = 0;
};

}  // namespace fuzz
