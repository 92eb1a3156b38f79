// The caller's hooks, as C++ may write them: an allocator, its release and a task runner that throw. No exception
// passes the library: a call returns a status, and an object that it made or left is whole. And on which threads they
// are called.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <stdexcept>
#include <thread>

#include "snapshots.h"

using test::line;

namespace {

constexpr float frame = 1.0f / 60;

/// Counts, and throws when told to.
struct Heap {
    std::thread::id caller = std::this_thread::get_id();
    std::atomic<long> calls{0}, elsewhere{0}, blocks{0};
    long throw_at = -1;  // the allocation, and all after it
    bool throw_at_release = false;
    gphys_allocator hooks{allocate, release, this};

    void note() { elsewhere += std::this_thread::get_id() != caller; }
    static void* allocate(void* user, size_t size, size_t alignment) {
        Heap& heap = *static_cast<Heap*>(user);
        heap.note();
        const long call = heap.calls++;
        if (heap.throw_at >= 0 && call >= heap.throw_at) throw std::runtime_error("no memory today");
        ++heap.blocks;
        return ::operator new(size, std::align_val_t(alignment));
    }
    static void release(void* user, void* memory, size_t, size_t alignment) {
        Heap& heap = *static_cast<Heap*>(user);
        heap.note();
        --heap.blocks;
        ::operator delete(memory, std::align_val_t(alignment));
        if (heap.throw_at_release) throw 7;
    }
};

/// Runs some of the tasks, on a thread of its own or on the caller's, and throws.
struct Runner {
    enum class Fails { never, at_once, later, with_tasks_running, silently } fails = Fails::never;
    int runs = 0;
    std::thread left_running;
    gphys_task_runner runner{run, this};

    ~Runner() {
        if (left_running.joinable()) left_running.join();
    }
    static void run(void* user, gphys_task task, void* context, uint32_t count) {
        Runner& self = *static_cast<Runner*>(user);
        ++self.runs;
        if (self.fails == Fails::silently) return;  // not one of the tasks
        if (self.fails == Fails::at_once) throw std::runtime_error("no threads today");
        if (self.fails == Fails::with_tasks_running) {
            if (self.left_running.joinable()) self.left_running.join();
            std::atomic<bool> running{false};
            self.left_running = std::thread([&running, task, context] {
                running = true;
                task(context, 0);
            });
            while (!running) std::this_thread::yield();
            // Long enough for that thread to be in the task.
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            throw 8;
        }
        std::thread other([&] { task(context, 0); });
        for (uint32_t i = 1; i < count; ++i) task(context, i);
        other.join();
        if (self.fails == Fails::later) throw 9;
    }
};

/// Joined ropes, each with a part of the work.
struct Ropes {
    gphys_solver* solver = nullptr;
    gphys_body_id bodies[32]{};

    explicit Ropes(const gphys_allocator* hooks, const gphys_task_runner* runner = nullptr) {
        gphys_solver_desc desc = test::World::desc();
        desc.allocator = hooks;
        desc.task_runner = runner;
        desc.worker_count = 4;
        REQUIRE(gphys_solver_create(&desc, &solver) == GPHYS_OK);
        for (int i = 0; i < 32; ++i) {
            const std::vector<gphys_vec3> points = line({0, 1, static_cast<float>(i)}, {0.1f, 0, 0}, 20);
            REQUIRE(gphys_solver_add_rope(solver, nullptr, points.data(), 12, 20, 0, &bodies[i]) == GPHYS_OK);
            REQUIRE(gphys_solver_set_pinned(solver, bodies[i], 0, 1, 1) == GPHYS_OK);
        }
        gphys_joint_id joint = 0;
        for (int i = 0; i < 16; i += 2) {
            REQUIRE(gphys_solver_join(solver, bodies[i], 19, bodies[i + 1], 19, -1, 0, &joint) == GPHYS_OK);
        }
    }
    Ropes(const Ropes&) = delete;
    ~Ropes() { gphys_solver_destroy(solver); }

    void step(int count) const {
        for (int i = 0; i < count; ++i) REQUIRE(gphys_solver_step(solver, nullptr, frame) == GPHYS_OK);
    }
};

/// Of many balls.
struct Balls {
    static constexpr uint32_t count = 5000;
    gphys_scene* scene = nullptr;
    std::vector<gphys_ray> rays;

    Balls(const gphys_allocator* hooks, const gphys_task_runner* runner) : rays(count) {
        gphys_scene_desc desc;
        gphys_scene_desc_init(&desc, sizeof desc);
        desc.allocator = hooks;
        desc.task_runner = runner;
        desc.worker_count = 4;
        REQUIRE(gphys_scene_create(&desc, &scene) == GPHYS_OK);
        std::vector<gphys_transform> places(count);
        std::vector<gphys_model_id> models(count);
        test::Random random(3);
        for (uint32_t i = 0; i < count; ++i) {
            places[i] = {random.point(50), {0, 0, 0, 1}, 1};
            rays[i] = {random.point(50), gphys::narrow(random.direction()), 100};
        }
        const gphys_sphere ball{{0, 0, 0}, 1};
        REQUIRE(gphys_scene_add_batch(scene, GPHYS_SHAPE_SPHERE, &ball, 0, places.data(), sizeof places[0], count,
                                      nullptr, models.data()) == GPHYS_OK);
        for (gphys_transform& place : places) place.position.x += 0.5f;
        REQUIRE(gphys_scene_set_transforms(scene, models.data(), places.data(), sizeof places[0], count) == GPHYS_OK);
        REQUIRE(gphys_scene_validate(scene) == GPHYS_OK);
    }
    Balls(const Balls&) = delete;
    ~Balls() { gphys_scene_destroy(scene); }

    std::vector<gphys_hit> cast() const {
        std::vector<gphys_hit> hits(count);
        REQUIRE(gphys_scene_raycast_batch(scene, rays.data(), sizeof rays[0], count, GPHYS_ALL_LAYERS, hits.data(),
                                          sizeof hits[0]) == GPHYS_OK);
        return hits;
    }
};

constexpr Runner::Fails failures[] = {Runner::Fails::at_once, Runner::Fails::later, Runner::Fails::with_tasks_running,
                                      Runner::Fails::silently};

}  // namespace

TEST_CASE("a solver's hooks are called on the caller's thread only, also after a restore") {
    Heap heap;
    {
        const Ropes ropes(&heap.hooks);
        ropes.step(5);
        const test::Words words = test::snapshot(ropes.solver);
        for (int i = 0; i < 20; ++i) {
            REQUIRE(test::restore(ropes.solver, words) == GPHYS_OK);
            ropes.step(2);
        }
    }
    CHECK(heap.calls > 100);
    CHECK(heap.elsewhere == 0);
    CHECK(heap.blocks == 0);
}

TEST_CASE("an allocator that throws has no memory, and nothing has changed") {
    Heap heap;
    const std::vector<gphys_vec3> points = line({0, 1, 0}, {0.1f, 0, 0}, 6);
    const gphys_sphere ball{{0, 0, 0}, 1};
    long failed = 0;
    for (long k = 0; k < 60; ++k) {
        gphys_solver* solver = nullptr;
        gphys_scene* scene = nullptr;
        gphys_body_id body = 0;
        gphys_model_id model = 0;
        heap.throw_at = heap.calls + k;
        gphys_solver_desc desc = test::World::desc();
        desc.allocator = &heap.hooks;
        gphys_scene_desc scene_desc;
        gphys_scene_desc_init(&scene_desc, sizeof scene_desc);
        scene_desc.allocator = &heap.hooks;
        const auto made = [&](const std::function<gphys_status()>& call) {
            gphys_status status = call();
            if (status != GPHYS_OK) {
                ++failed;
                REQUIRE(status == GPHYS_ERROR_OUT_OF_MEMORY);
                heap.throw_at = -1;
                status = call();
            }
            REQUIRE(status == GPHYS_OK);
        };
        made([&] { return gphys_solver_create(&desc, &solver); });
        made([&] { return gphys_scene_create(&scene_desc, &scene); });
        made([&] { return gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, nullptr, nullptr, &model); });
        made([&] { return gphys_solver_add_rope(solver, nullptr, points.data(), 12, 6, 0, &body); });
        made([&] { return gphys_solver_attach(solver, scene, body, 0, model, nullptr); });
        made([&] { return gphys_solver_step(solver, scene, frame); });
        heap.throw_at = -1;
        REQUIRE(gphys_scene_validate(scene) == GPHYS_OK);
        gphys_solver_destroy(solver);
        gphys_scene_destroy(scene);
        REQUIRE(heap.blocks == 0);
    }
    CHECK(failed > 30);
}

TEST_CASE("a release that throws ends nothing") {
    Heap heap;
    heap.throw_at_release = true;
    {
        const Ropes ropes(&heap.hooks);
        ropes.step(3);
        REQUIRE(gphys_solver_remove_body(ropes.solver, ropes.bodies[3]) == GPHYS_OK);
        REQUIRE(test::restore(ropes.solver, test::snapshot(ropes.solver)) == GPHYS_OK);
        ropes.step(1);
        const Balls balls(&heap.hooks, nullptr);
        REQUIRE(gphys_scene_clear(balls.scene) == GPHYS_OK);
        REQUIRE(gphys_scene_validate(balls.scene) == GPHYS_OK);
        const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        const uint32_t sides[3] = {0, 1, 2};
        gphys_mesh_desc desc;
        gphys_mesh_desc_init(&desc, sizeof desc);
        desc.allocator = &heap.hooks;
        gphys_mesh* mesh = nullptr;
        REQUIRE(gphys_mesh_create(&desc, corners, 12, 3, sides, 3, &mesh) == GPHYS_OK);
        gphys_mesh_destroy(mesh);
    }
    CHECK(heap.blocks == 0);
}

TEST_CASE("of a task runner that throws, the caller's thread does what is left") {
    Runner good;
    const Ropes ropes(nullptr, &good.runner);
    const Balls balls(nullptr, &good.runner);
    const std::vector<gphys_hit> hits = balls.cast();
    ropes.step(10);
    CHECK(good.runs > 10);
    for (const Runner::Fails fails : failures) {
        Runner bad;
        bad.fails = fails;
        const Ropes others(nullptr, &bad.runner);
        others.step(10);
        CHECK(test::hash(others.solver) == test::hash(ropes.solver));
        const Balls other_balls(nullptr, &bad.runner);
        const std::vector<gphys_hit> other_hits = other_balls.cast();
        CHECK(std::memcmp(hits.data(), other_hits.data(), hits.size() * sizeof hits[0]) == 0);
        CHECK(bad.runs > 10);
    }
}

// Sanitizers reserve more address space than a limit may leave.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("an object whose threads cannot be started is not made, and leaves nothing behind") {
    const pid_t child = fork();
    if (child == 0) {
        const rlimit stacks{8 << 20, 8 << 20}, room{size_t{1} << 30, size_t{1} << 30};
        setrlimit(RLIMIT_STACK, &stacks);
        setrlimit(RLIMIT_AS, &room);
        Heap heap;
        gphys_solver* solver = nullptr;
        gphys_scene* scene = nullptr;
        gphys_solver_desc desc = test::World::desc();
        desc.allocator = &heap.hooks;
        desc.worker_count = 1024;
        gphys_scene_desc scene_desc;
        gphys_scene_desc_init(&scene_desc, sizeof scene_desc);
        scene_desc.allocator = &heap.hooks;
        scene_desc.worker_count = 1024;
        const bool refused = gphys_solver_create(&desc, &solver) == GPHYS_ERROR_OUT_OF_MEMORY &&
                             gphys_scene_create(&scene_desc, &scene) == GPHYS_ERROR_OUT_OF_MEMORY;
        _exit(refused && !solver && !scene && heap.blocks == 0 ? 0 : 1);
    }
    int status = -1;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
}
#endif
