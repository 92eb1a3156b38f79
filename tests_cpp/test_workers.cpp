// Threads that share work: every number once, several callers at a time, children of fork, signals,
// and nothing left behind.
#include "foundation/workers.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "resources.h"
#include "test.h"

using namespace gphys;

namespace {

/// A job system: a fresh thread for each task.
void run_on_threads(void*, gphys_task task, void* context, uint32_t count) {
    std::vector<std::thread> threads;
    for (uint32_t i = 0; i < count; ++i) threads.emplace_back([=] { task(context, i); });
    for (std::thread& thread : threads) thread.join();
}
const gphys_task_runner on_threads{run_on_threads, nullptr};

bool each_once(const Workers& workers, uint32_t count) {
    std::vector<std::atomic<int>> times(count);
    workers.run(count, [&](uint32_t i) { ++times[i]; });
    return std::all_of(times.begin(), times.end(), [](const std::atomic<int>& n) { return n == 1; });
}

/// Tasks that run to the end only if all run at the same time.
template <class WhileAll>
void run_together(const Workers& workers, uint32_t count, WhileAll&& while_all) {
    std::atomic<uint32_t> here{0};
    workers.run(count, [&](uint32_t) {
        ++here;
        while (here < count) std::this_thread::yield();
        while_all();
    });
}

size_t thread_count() {
    const std::filesystem::directory_iterator tasks("/proc/self/task");
    return static_cast<size_t>(std::distance(begin(tasks), end(tasks)));
}

// The system may list a thread for a moment after it was joined.

size_t thread_count_at_rest() {
    size_t count = thread_count();
    for (size_t before = count + 1; before != count;) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        before = std::exchange(count, thread_count());
    }
    return count;
}

bool thread_count_becomes(size_t count) {
    for (int patience = 0; patience < 1000 && thread_count() != count; ++patience) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return thread_count() == count;
}

/// Runs in a child of fork; true if the child returns true. All threads must have run before: one that starts may hold
/// locks of a sanitizer's allocator, which the child would inherit.
template <class Body>
bool in_child(Body&& body) {
    const pid_t child = fork();
    if (child == 0) _exit(body() ? 0 : 1);
    int status = -1;
    return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// A scene of many balls with workers, through the public header.
struct Busy {
    static constexpr uint32_t count = 20000;

    explicit Busy(const gphys_allocator* hooks, uint32_t worker_count = 4) {
        gphys_scene_desc desc;
        gphys_scene_desc_init(&desc, sizeof desc);
        desc.allocator = hooks;
        desc.worker_count = worker_count;
        REQUIRE(gphys_scene_create(&desc, &scene) == GPHYS_OK);
        for (gphys_vec3& point : points) point = random.point(100);
        const gphys_sphere ball{{0, 0, 0}, 1};
        REQUIRE(gphys_scene_add_batch(scene, GPHYS_SHAPE_SPHERE, &ball, 0, nullptr, 0, count, nullptr, models.data()) ==
                GPHYS_OK);
        move_all();
    }
    ~Busy() { gphys_scene_destroy(scene); }

    void move_all() {
        for (gphys_transform& transform : transforms) transform = {random.point(100), {0, 0, 0, 1}, 1};
        CHECK(gphys_scene_set_transforms(scene, models.data(), transforms.data(), sizeof transforms[0], count) ==
              GPHYS_OK);
    }
    std::vector<gphys_nearest> nearest() const {
        std::vector<gphys_nearest> answers(points.size());
        gphys_scene_nearest_batch(scene, points.data(), sizeof points[0], static_cast<uint32_t>(points.size()),
                                  INFINITY, 1, answers.data(), sizeof answers[0]);
        return answers;
    }

    gphys_scene* scene = nullptr;
    test::Random random{7};
    std::vector<gphys_vec3> points = std::vector<gphys_vec3>(2000);
    std::vector<gphys_transform> transforms = std::vector<gphys_transform>(count);
    std::vector<gphys_model_id> models = std::vector<gphys_model_id>(count);
};

}  // namespace

TEST_CASE("workers run every task once, whatever their number") {
    test::WatchedMemory memory;
    for (const uint32_t count : {0u, 1u, 2u, 3u, 7u}) {
        const Workers own(count, nullptr, &memory), lent(count, &on_threads, &memory);
        CHECK(own.count() == std::max(count, 1u));
        CHECK(lent.count() == own.count());
        for (const uint32_t tasks : {0u, 1u, 2u, 5u, 1000u}) {
            CHECK(each_once(own, tasks));
            CHECK(each_once(lent, tasks));
        }
    }
    CHECK(memory.bytes_in_use == 0);
}

TEST_CASE("workers allocate nothing for a run") {
    test::WatchedMemory memory;
    const Workers workers(3, nullptr, &memory);
    const long before = memory.allocations;
    CHECK(each_once(workers, 100));
    CHECK(memory.allocations == before);
}

TEST_CASE("two workers work at the same time") {
    const Workers own(2, nullptr, std::pmr::new_delete_resource());
    for (int i = 0; i < 1000; ++i) run_together(own, 2, [] {});
    const Workers lent(2, &on_threads, std::pmr::new_delete_resource());
    run_together(lent, 2, [] {});
}

TEST_CASE("workers are started with their owner and joined with it, none for a count of one or a runner") {
    std::thread([] {}).join();  // with the first one a sanitizer starts its own
    const size_t before = thread_count_at_rest();
    {
        const Workers four(4, nullptr, std::pmr::new_delete_resource());
        const Workers one(1, nullptr, std::pmr::new_delete_resource());
        const Workers lent(4, &on_threads, std::pmr::new_delete_resource());
        CHECK(thread_count_becomes(before + 3));
    }
    CHECK(thread_count_becomes(before));
}

TEST_CASE("workers change their number: others are started, and the former ones joined") {
    const size_t before = thread_count_at_rest();
    test::WatchedMemory memory;
    {
        Workers own(1, nullptr, &memory), lent(1, &on_threads, &memory);
        for (const uint32_t count : {4u, 2u, 2u, 1u, 0u, 3u}) {
            own.set_count(count);
            lent.set_count(count);
            const uint32_t threads = std::max(count, 1u);
            CHECK(thread_count_becomes(before + threads - 1));
            CHECK(own.count() == threads);
            CHECK(lent.count() == threads);
            CHECK(each_once(own, 1000));
            CHECK(each_once(lent, 1000));
            if (threads > 1) {
                run_together(own, 2, [] {});
                run_together(lent, 2, [] {});
            }
        }
        memory.fail_at = memory.allocations;
        CHECK_THROWS_AS(own.set_count(5), std::bad_alloc);
        CHECK(own.count() == 3);
        run_together(own, 2, [] {});
    }
    CHECK(thread_count_becomes(before));
    CHECK(memory.bytes_in_use == 0);
}

TEST_CASE("workers serve one of several callers, and no caller waits for another") {
    const Workers workers(2, nullptr, std::pmr::new_delete_resource());
    std::atomic<int> wrong{0};
    std::vector<std::thread> callers;
    for (int c = 0; c < 4; ++c) {
        callers.emplace_back([&] {
            for (int i = 0; i < 500; ++i) wrong += !each_once(workers, 20);
        });
    }
    for (std::thread& caller : callers) caller.join();
    CHECK(wrong == 0);

    // While one caller holds the workers, another one gets its answer.
    run_together(workers, 2, [&] {
        std::thread other([&] { wrong += !each_once(workers, 20); });
        other.join();
    });
    CHECK(wrong == 0);
}

TEST_CASE("workers leave signals to the host's threads, but not faults") {
    const Workers workers(2, nullptr, std::pmr::new_delete_resource());
    const std::thread::id caller = std::this_thread::get_id();
    bool takes_interrupt = true, takes_fault = false;
    run_together(workers, 2, [&] {
        if (std::this_thread::get_id() == caller) return;
        sigset_t blocked;
        pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
        takes_interrupt = sigismember(&blocked, SIGINT) == 0;
        takes_fault = sigismember(&blocked, SIGFPE) == 0;
    });
    CHECK_FALSE(takes_interrupt);
    CHECK(takes_fault);
    sigset_t blocked;
    pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
    CHECK(sigismember(&blocked, SIGINT) == 0);
}

TEST_CASE("workers are gone in a child of fork, where the caller works alone and destroying returns") {
    test::WatchedMemory memory;
    auto workers = std::make_unique<Workers>(4, nullptr, &memory);
    run_together(*workers, 4, [] {});
    CHECK(in_child([&] {
        const bool right = each_once(*workers, 100);
        workers.reset();
        return right && memory.bytes_in_use == 0;
    }));
    CHECK(each_once(*workers, 100));
}

TEST_CASE("workers are started again in a child of fork when they are set there") {
    test::WatchedMemory memory;
    auto workers = std::make_unique<Workers>(2, nullptr, &memory);
    run_together(*workers, 2, [] {});
    CHECK(in_child([&] {
        workers->set_count(2);
        run_together(*workers, 2, [] {});
        const bool right = each_once(*workers, 100);
        workers.reset();
        return right && memory.bytes_in_use == 0;
    }));
    CHECK(each_once(*workers, 100));
}

TEST_CASE("workers that cannot be started are a failed allocation, and those before them end") {
    test::WatchedMemory memory;
    for (long fail_at = 0; fail_at < 2; ++fail_at) {
        memory.fail_at = memory.allocations + fail_at;
        CHECK_THROWS_AS(Workers(4, nullptr, &memory), std::bad_alloc);
        CHECK(memory.bytes_in_use == 0);
    }
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they need the address space
    CHECK(in_child([] {
        const size_t before = thread_count_at_rest();
        // Room for some of the stacks, which are 8 MB each unless the system's limit says otherwise.
        const rlimit stacks{8 << 20, 8 << 20}, room{size_t{1} << 30, size_t{1} << 30};
        setrlimit(RLIMIT_STACK, &stacks);
        setrlimit(RLIMIT_AS, &room);
        try {
            const Workers many(Workers::max_count, nullptr, std::pmr::new_delete_resource());
        } catch (const std::bad_alloc&) {
            return thread_count_becomes(before);
        }
        return false;
    }));
#endif
}

TEST_CASE("workers never call a scene's hooks") {
    struct Heap {
        std::thread::id caller = std::this_thread::get_id();
        std::atomic<int> elsewhere{0}, calls{0};
        void count() {
            ++calls;
            elsewhere += std::this_thread::get_id() != caller;
        }
    } heap;
    const gphys_allocator hooks{[](void* user, size_t size, size_t alignment) {
                                    static_cast<Heap*>(user)->count();
                                    return ::operator new(size, std::align_val_t(alignment));
                                },
                                [](void* user, void* memory, size_t, size_t alignment) {
                                    static_cast<Heap*>(user)->count();
                                    ::operator delete(memory, std::align_val_t(alignment));
                                },
                                &heap};
    {
        Busy busy(&hooks);
        for (int frame = 0; frame < 3; ++frame) busy.move_all();
        CHECK(gphys_scene_validate(busy.scene) == GPHYS_OK);
    }
    CHECK(heap.elsewhere == 0);
    CHECK(heap.calls > 0);
}

TEST_CASE("workers move models to where one thread moves them, also one that stands twice") {
    Busy alone(nullptr, 1), shared(nullptr, 4);
    for (const bool twice : {false, true}) {
        for (Busy* busy : {&alone, &shared}) {
            if (twice) busy->models.back() = busy->models.front();
            busy->move_all();
            REQUIRE(gphys_scene_validate(busy->scene) == GPHYS_OK);
        }
        for (uint32_t i = 0; i < Busy::count; ++i) {
            gphys_aabb box, other;
            REQUIRE(gphys_scene_get_bounds(alone.scene, alone.models[i], &box) == GPHYS_OK);
            REQUIRE(gphys_scene_get_bounds(shared.scene, shared.models[i], &other) == GPHYS_OK);
            REQUIRE(std::memcmp(&box, &other, sizeof box) == 0);
        }
    }
}

TEST_CASE("workers answer callers who query one scene at the same time as they answer one") {
    const Busy busy(nullptr);
    const std::vector<gphys_nearest> expected = busy.nearest();
    std::atomic<int> wrong{0};
    std::vector<std::thread> callers;
    for (int c = 0; c < 3; ++c) {
        callers.emplace_back([&] {
            for (int i = 0; i < 10; ++i) {
                wrong += std::memcmp(busy.nearest().data(), expected.data(), expected.size() * sizeof expected[0]) != 0;
            }
        });
    }
    for (std::thread& caller : callers) caller.join();
    CHECK(wrong == 0);
}
