#include "world.h"

namespace fuzz {

const char* const target_name = "world";

World::World(Program& program) : p_(program) {
    const MeshSource tetrahedron({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
    const MeshSource ridge({{-1, 0, -1}, {0, 1, -1}, {1, 0, -1}, {-1, 0, 1}, {0, 1, 1}, {1, 0, 1}},
                           {0, 3, 1, 1, 3, 4, 1, 4, 2, 2, 4, 5});
    sources_ = {tetrahedron, ridge, MeshSource({}, {})};
    for (const MeshSource& source : sources_) meshes_.push_back(source.create());
    create_scene();
}

World::~World() {
    memory_.never_fail();
    if (p_.one_in(2)) forget_shown();  // else last
    call(gphys_scene_destroy, scene_);
    call(gphys_camera_destroy, camera_);
    call(gphys_solver_destroy, solver_);
    call(gphys_solver_destroy, twin_);
    forget_shown();
}

void World::run() {
    constexpr Op edits[] = {&World::add,
                            &World::add,
                            &World::add,
                            &World::add_batch,
                            &World::remove,
                            &World::set_parent,
                            &World::set_transform,
                            &World::set_transforms,
                            &World::set_properties,
                            &World::remove_batch,
                            &World::remove_subtree,
                            &World::inspect_scene,
                            &World::set_transform,
                            &World::set_scene_origin,
                            &World::save_scene,
                            &World::misuse_scene,
                            &World::add,
                            &World::set_shape,
                            &World::set_scale};
    constexpr Op queries[] = {
        &World::raycast,          &World::raycast,          &World::segment_test,  &World::overlap,
        &World::nearest,          &World::nearest,          &World::sweep,         &World::cull,
        &World::overlap,          &World::ray_batches,      &World::other_batches, &World::query_misuse,
        &World::filtered_queries, &World::filtered_batches, &World::sweep_solid,   &World::ways_out};
    constexpr Op views[] = {&World::create_camera,  &World::place_camera, &World::project_camera, &World::orbit,
                            &World::inspect_camera, &World::project,      &World::pick,           &World::pick_lists,
                            &World::place_camera,   &World::pick,         &World::view_camera,    &World::rectangles};
    constexpr Op motions[] = {&World::create_solver,
                              &World::add_body,
                              &World::add_body,
                              &World::remove_body,
                              &World::set_state,
                              &World::set_state,
                              &World::constrain,
                              &World::join,
                              &World::attach,
                              &World::volume,
                              &World::settings,
                              &World::change_body,
                              &World::change_constraints,
                              &World::step,
                              &World::step,
                              &World::snapshot,
                              &World::inspect_solver,
                              &World::solver_misuse};
    // Most programs are about one part.
    const uint32_t part = p_.below(6);
    for (int i = 0; i < 200 && !p_.done(); ++i) {
        const uint32_t choice = p_.byte();
        if (part == 0 || part == 1 || (part > 3 && choice < 90)) {
            choice & 1 ? (this->*edits[p_.below(std::size(edits))])()
                       : (this->*queries[p_.below(std::size(queries))])();
        } else if (part == 2 || (part > 3 && choice < 150)) {
            choice < 60 ? (this->*edits[p_.below(std::size(edits))])() : (this->*views[p_.below(std::size(views))])();
        } else {
            choice < 20 ? (this->*edits[p_.below(std::size(edits))])()
                        : (this->*motions[p_.below(std::size(motions))])();
        }
        if (p_.one_in(200)) clear();
    }
    inspect_scene();
    if (solver_) inspect_solver();
    memory_.never_fail();
    call(gphys_scene_destroy, scene_);
    scene_ = nullptr;
    call(gphys_solver_destroy, solver_);
    solver_ = nullptr;
    call(gphys_solver_destroy, twin_);
    twin_ = nullptr;
    call(gphys_camera_destroy, camera_);
    camera_ = nullptr;
    FUZZ_CHECK(memory_.live_bytes() == 0, "objects that are destroyed give back their memory");
}

void run(Program& p) {
    World world(p);
    world.run();
}

}  // namespace fuzz
