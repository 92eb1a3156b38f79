// The thread pool of one object (fork-join): threads started when it is created, or the job system of the host.
//
// run(count, task) calls task(0) .. task(count - 1), each once, and returns when all are done. The threads and the
// caller take task numbers from one atomic counter. So none waits while there is work, and a thread that never arrives
// (asleep, busy, lost to fork) does no harm. Which thread runs which task differs from run to run. A task writes only
// to elements that its number determines, so results are the same for any number of workers.
//
// A task neither throws nor allocates: an object's allocator is called on the caller's thread only, before the run. A
// task runner written in C++ may throw; then the caller's thread runs the remaining tasks.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "foundation/memory.h"

namespace gphys {

class Workers {
public:
    /// More than any machine has; a larger count is rejected as a mistake.
    static constexpr uint32_t max_count = 1024;

    /// `count` threads including the caller's; 0 means 1. Uses those of `runner` if it is not null, else starts count -
    /// 1. If they cannot be started, throws std::bad_alloc and leaves none running. On a platform without threads only
    /// the caller runs tasks.
    Workers(uint32_t count, const gphys_task_runner* runner, std::pmr::memory_resource* memory);
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers();

    /// The number of threads that may run tasks at the same time, at least 1.
    uint32_t count() const { return count_; }
    /// As at construction, with the same runner. Must not be called during a run. If the threads cannot be started,
    /// throws std::bad_alloc and keeps those that there are.
    void set_count(uint32_t count);

    /// Several threads may call this at once: the workers serve one of them, the others run their tasks alone. Must not
    /// be called within a task.
    template <class Task>
    void run(uint32_t count, Task&& task) const noexcept {
        if (count_ == 1 || count <= 1) {
            for (uint32_t i = 0; i < count; ++i) task(i);
            return;
        }
        Job job([](void* context, uint32_t i) { (*static_cast<std::remove_reference_t<Task>*>(context))(i); },
                const_cast<void*>(static_cast<const void*>(&task)), count);
        share(job);
    }

private:
    /// The run in progress, on the stack of the caller.
    struct Job {
        Job(gphys_task call_, void* context_, uint32_t count_) : call(call_), context(context_), count(count_) {}
        void drain() {
            for (uint64_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) {
                call(context, static_cast<uint32_t>(i));
            }
        }

        gphys_task call;
        void* context;
        uint32_t count;
        std::atomic<uint64_t> next{0};         // 64 bits: each thread increments it once past count
        std::atomic<uint32_t> taking_part{0};  // threads of a runner
    };

    /// The shared state of a caller and the threads.
    struct SyncBlock {
        std::mutex serving;  // held by the caller whose run the threads serve
        std::mutex mutex;    // guards the members below
        std::condition_variable wake, done;
        Job* job = nullptr;  // with tasks left
        uint32_t working = 0;
        bool stopping = false;
    };

    void share(Job& job) const noexcept;
    static void serve(SyncBlock& sync);
    void stop();
    bool in_forked_child() const;

    uint32_t count_;
    gphys_task_runner runner_{};
    Vector<std::thread> threads_;
    SyncBlock* sync_ = nullptr;  // null without threads
    long process_;               // of the threads
};

/// If workers is null, the caller's thread runs all tasks.
template <class Task>
void run(const Workers* workers, uint32_t count, Task&& task) noexcept {
    if (workers) {
        workers->run(count, task);
    } else {
        for (uint32_t i = 0; i < count; ++i) task(i);
    }
}

}  // namespace gphys
