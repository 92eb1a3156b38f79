// What edits cost: the first step of a body, and the step after each kind of edit, beside a usual step of the same
// body. Each edit is made in its own step. A row is the shortest of some repetitions of a step, in milliseconds of
// processor time:
//   gamephys_bench_edits [--only NAME] [--repeat N]
// "first_removal" is the step after the first link of a sheet was removed, of "remove_link" it is one of many.
// "tear" includes the call that breaks the link. "breakable" is a usual step of a body whose links could break, beside
// one whose links cannot.
// "usual" is the shortest of the steps that follow the edit: what is pinned or joined may itself be moved in more time,
// or less. Steps after an edit of a rope may differ by more than the edit costs, as its motion does.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "measure.h"

namespace {

constexpr float spacing = 0.02f;

/// A body that hangs or flies, a rope of ten links beside it, and a model that nothing touches.
struct World {
    World() {
        check(gphys_solver_create(nullptr, &solver));
        check(gphys_scene_create(nullptr, &scene));
        const gphys_sphere sphere{{0, 100, 0}, 0.1f};
        check(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &sphere, nullptr, nullptr, &model));
    }
    ~World() {
        gphys_solver_destroy(solver);
        gphys_scene_destroy(scene);
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    void add_rope_beside() {
        std::vector<gphys_vec3> points;
        for (int i = 0; i <= 10; ++i) points.push_back({-spacing * static_cast<float>(i), -1, 0});
        check(gphys_solver_add_rope(solver, nullptr, points.data(), sizeof points[0], 11, 0, &beside));
    }
    void add_cloth(uint32_t side) {
        const float length = spacing * static_cast<float>(side - 1);
        const gphys_vec3 corner{0, 0, 0}, u{length, 0, 0}, v{0, 0, length};
        check(gphys_solver_add_cloth(solver, nullptr, &corner, &u, &v, side, side, &body));
        check(gphys_solver_set_pinned(solver, body, 0, 1, 1));
        check(gphys_solver_set_pinned(solver, body, side - 1, 1, 1));
    }
    void add_rope(uint32_t links) {
        std::vector<gphys_vec3> points;
        for (uint32_t i = 0; i <= links; ++i) points.push_back({spacing * static_cast<float>(i), 0, 0});
        check(gphys_solver_add_rope(solver, nullptr, points.data(), sizeof points[0], links + 1, 0, &body));
        check(gphys_solver_set_pinned(solver, body, 0, 1, 1));
    }
    void add_particles(uint32_t side) {
        std::vector<gphys_vec3> points;
        for (uint32_t i = 0; i < side * side; ++i)
            points.push_back({spacing * static_cast<float>(i % side), 0, spacing * static_cast<float>(i / side)});
        check(gphys_solver_add_particles(solver, nullptr, points.data(), sizeof points[0], side * side, &body));
    }
    uint32_t size() const {
        gphys_body_info info;
        check(gphys_solver_get_body_info(solver, body, &info));
        return info.particle_count;
    }
    gphys_solver_stats stats() const {
        gphys_solver_stats out;
        check(gphys_solver_get_stats(solver, body, &out));
        return out;
    }
    double step() {
        const double begin = now();
        check(gphys_solver_step(solver, scene, frame_time(steps++)));
        return 1e3 * (now() - begin);
    }

    gphys_solver* solver = nullptr;
    gphys_scene* scene = nullptr;
    gphys_model_id model = 0;
    gphys_body_id body = 0, beside = 0;
    long steps = 0;
};

void require_distinct(const World& world) {
    std::vector<gphys_vec3> points(world.size());
    check(gphys_solver_get_positions(world.solver, world.body, 0, world.size(), points.data(), sizeof points[0]));
    std::set<std::tuple<float, float, float>> seen;
    for (const gphys_vec3& p : points) seen.insert({p.x, p.y, p.z});
    if (seen.size() != points.size()) throw std::runtime_error("particles of the benchmark lie in one place");
}

struct BodyScene {
    const char* name;
    uint32_t particles, links;
    std::function<void(World&)> make;
};

uint32_t links_of_sheet(uint32_t side) {
    const uint32_t sides = 2 * side * (side - 1), diagonals = 2 * (side - 1) * (side - 1);
    const uint32_t bends = 2 * side * (side - 2);
    return sides + diagonals + bends;
}

const BodyScene scenes[] = {
    {"cloth_100", 10000, links_of_sheet(100), [](World& world) { world.add_cloth(100); }},
    {"cloth_200", 40000, links_of_sheet(200), [](World& world) { world.add_cloth(200); }},
    {"rope_1000", 1001, 1000, [](World& world) { world.add_rope(1000); }},
    {"particles_10000", 10000, 0, [](World& world) { world.add_particles(100); }},
};

/// An edit and the one that takes it back, of a particle in the middle of the body.
struct Edit {
    const char *name, *back;
    std::function<void(World&)> make, undo;
    // What the body must be afterwards, beyond what it was: pinned particles, constraints, joints.
    int pinned, constraints, joints;
};

uint32_t middle(const World& world) { return world.size() / 2; }

uint32_t joint_count(const World& world) {
    uint32_t total = 0;
    const gphys_status status = gphys_solver_get_joints(world.solver, 0, nullptr, 0, &total);
    if (status != GPHYS_INCOMPLETE) check(status);
    return total;
}

std::vector<Edit> edits_of(const BodyScene& scene) {
    static gphys_constraint_id added = 0;
    static gphys_joint_id joint = 0;
    static gphys_constraint_info removed;
    const auto set_mass = [](World& world, float part) {
        const float mass = part / static_cast<float>(world.size());
        check(gphys_solver_set_masses(world.solver, world.body, middle(world), 1, &mass, sizeof mass));
    };
    std::vector<Edit> edits{
        {"pin", "release", [](World& w) { check(gphys_solver_set_pinned(w.solver, w.body, middle(w), 1, 1)); },
         [](World& w) { check(gphys_solver_set_pinned(w.solver, w.body, middle(w), 1, 0)); }, 1, 0, 0},
        {"attach", "detach",
         [](World& w) { check(gphys_solver_attach(w.solver, w.scene, w.body, middle(w), w.model, nullptr)); },
         [](World& w) { check(gphys_solver_detach(w.solver, w.body, middle(w))); }, 1, 0, 0},
        {"set_mass", "set_mass_back", [=](World& w) { set_mass(w, 2); }, [=](World& w) { set_mass(w, 1); }, 0, 0, 0},
        {"join", "unjoin",
         [](World& w) { check(gphys_solver_join(w.solver, w.body, middle(w), w.beside, 0, -1, 0, &joint)); },
         [](World& w) { check(gphys_solver_unjoin(w.solver, joint)); }, 0, 0, 1},
    };
    if (scene.links > 0) {
        edits.push_back(
            {"add_link", "remove_added",
             [](World& w) {
                 check(gphys_solver_add_distance(w.solver, w.body, middle(w), middle(w) + 3, -1, 0.01f, &added));
             },
             [](World& w) { check(gphys_solver_remove_constraint(w.solver, w.body, added)); }, 0, 1, 0});
        edits.push_back({"remove_link", "add_removed",
                         [](World& w) {
                             std::vector<gphys_constraint_info> all(w.stats().constraint_count);
                             uint32_t total = 0;
                             check(gphys_solver_get_constraints(w.solver, w.body, all.data(),
                                                                static_cast<uint32_t>(all.size()), &total));
                             removed = all[all.size() / 2];
                             check(gphys_solver_remove_constraint(w.solver, w.body, removed.id));
                         },
                         [](World& w) {
                             check(gphys_solver_add_distance(w.solver, w.body, removed.particle_a, removed.particle_b,
                                                             removed.rest_length, removed.compliance, &added));
                         },
                         0, -1, 0});
    }
    return edits;
}

void print_row(const BodyScene& scene, const char* edit, double after, double usual) {
    std::printf("%-16s %-14s %8.3f %8.3f | %8.3f %7.2f\n", scene.name, edit, after, usual, after - usual,
                after / usual);
}

void run_first(const BodyScene& scene, int repeat) {
    double first = 1e9, usual = 1e9;
    for (int i = 0; i < repeat; ++i) {
        World world;
        scene.make(world);
        if (i == 0) {
            require_distinct(world);
            if (world.size() != scene.particles || world.stats().constraint_count != scene.links)
                throw std::runtime_error("the body of the benchmark is not what it should be");
        }
        first = std::min(first, world.step());
        for (int k = 0; k < 5; ++k) usual = std::min(usual, world.step());
    }
    print_row(scene, "first_step", first, usual);
}

void run_edit(const BodyScene& scene, const Edit& edit, int repeat) {
    World world;
    scene.make(world);
    world.add_rope_beside();
    for (int i = 0; i < 60; ++i) world.step();
    constexpr int calm = 4;                               // usual steps before and after
    double after[2] = {1e9, 1e9}, usual[2] = {1e9, 1e9};  // of the edit; of the one that takes it back
    for (int i = 0; i < repeat; ++i) {
        const gphys_solver_stats before = world.stats();
        const uint32_t joints = joint_count(world);
        for (const int back : {0, 1}) {
            (back ? edit.undo : edit.make)(world);
            if (!back) {
                const gphys_solver_stats now = world.stats();
                if (now.pinned_count != before.pinned_count + static_cast<uint32_t>(edit.pinned) ||
                    now.constraint_count != before.constraint_count + static_cast<uint32_t>(edit.constraints) ||
                    joint_count(world) != joints + static_cast<uint32_t>(edit.joints))
                    throw std::runtime_error(std::string("the edit did not do what it should: ") + edit.name);
            }
            after[back] = std::min(after[back], world.step());
            for (int k = 0; k < calm; ++k) usual[back] = std::min(usual[back], world.step());
        }
    }
    print_row(scene, edit.name, after[0], usual[0]);
    print_row(scene, edit.back, after[1], usual[1]);
}

std::vector<gphys_constraint_id> links_of(const World& world) {
    std::vector<gphys_constraint_info> all(world.stats().constraint_count);
    uint32_t total = 0;
    check(
        gphys_solver_get_constraints(world.solver, world.body, all.data(), static_cast<uint32_t>(all.size()), &total));
    std::vector<gphys_constraint_id> ids;
    for (const gphys_constraint_info& link : all) ids.push_back(link.id);
    return ids;
}

/// The first removal from a flat sheet: from then on the paths between its particles have to be known.
void run_first_removal(const BodyScene& scene, int repeat) {
    double after = 1e9, usual = 1e9;
    for (int i = 0; i < repeat; ++i) {
        World world;
        scene.make(world);
        const std::vector<gphys_constraint_id> links = links_of(world);
        for (int k = 0; k < 10; ++k) world.step();
        check(gphys_solver_remove_constraint(world.solver, world.body, links[scene.particles / 2]));
        if (world.stats().constraint_count + 1 != scene.links) throw std::runtime_error("no link was removed");
        after = std::min(after, world.step());
        for (int k = 0; k < 4; ++k) usual = std::min(usual, world.step());
    }
    print_row(scene, "first_removal", after, usual);
}

/// Cloth tears at particles far from each other, in the middle.
void run_tear(const BodyScene& scene, int repeat) {
    World world;
    scene.make(world);
    const std::vector<gphys_constraint_id> links = links_of(world);
    for (int i = 0; i < 60; ++i) world.step();
    double after = 1e9, usual = 1e9;
    for (int i = 0; i < repeat; ++i) {
        const uint32_t size = world.size();
        const double begin = now();
        check(gphys_solver_break_constraint(world.solver, world.body, links[scene.particles / 2 + 37 * i], nullptr));
        const double broken = 1e3 * (now() - begin);
        if (world.size() != size + 1) throw std::runtime_error("the cloth of the benchmark has not torn");
        after = std::min(after, broken + world.step());
        for (int k = 0; k < 4; ++k) usual = std::min(usual, world.step());
    }
    print_row(scene, "tear", after, usual);
}

void run_breakable(const BodyScene& scene, int repeat) {
    World worlds[2];
    for (World& world : worlds) scene.make(world);
    const std::vector<gphys_constraint_id> links = links_of(worlds[0]);
    const float force = 1e9f;
    check(gphys_solver_set_breaking_forces(worlds[0].solver, worlds[0].body, links.data(), &force, 0,
                                           static_cast<uint32_t>(links.size())));
    double steps[2] = {1e9, 1e9};
    for (int i = 0; i < 60; ++i) {
        for (World& world : worlds) world.step();
    }
    for (int i = 0; i < 5 * repeat; ++i) {
        for (int k = 0; k < 2; ++k) steps[k] = std::min(steps[k], worlds[k].step());
    }
    uint32_t breaks = 0;
    check(gphys_solver_get_breaks(worlds[0].solver, nullptr, 0, &breaks));
    if (breaks != 0) throw std::runtime_error("a link of the benchmark broke");
    print_row(scene, "breakable", steps[0], steps[1]);
}

}  // namespace

int main(int count, char** arguments) {
    std::string only;
    int repeat = 12;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        const auto value = [&] { return i + 1 < count ? arguments[++i] : ""; };
        if (word == "--only") {
            only = value();
        } else if (word == "--repeat") {
            repeat = std::max(1, std::atoi(value()));
        }
    }
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    try {
        std::printf("%-16s %-14s %8s %8s | %8s %7s\n", "body", "edit", "after ms", "usual", "more", "times");
        for (const BodyScene& scene : scenes) {
            const auto wants = [&](const char* edit) {
                return (std::string(scene.name) + "/" + edit).find(only) != std::string::npos;
            };
            if (wants("first_step")) run_first(scene, repeat);
            for (const Edit& edit : edits_of(scene)) {
                if (wants(edit.name)) run_edit(scene, edit, repeat);
            }
            if (scene.links > scene.particles && wants("first_removal")) run_first_removal(scene, repeat);
            if (scene.links > 0 && wants("breakable")) run_breakable(scene, repeat);
            if (scene.links > scene.particles && wants("tear")) run_tear(scene, repeat);
        }
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
}
