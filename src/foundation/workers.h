// The threads that share the work of one object: started when it is created, or the caller's own.
//
// run(count, task) calls task(0) .. task(count - 1), each once, and returns when all are done. The
// threads and the caller take the numbers from one counter, so that none of them waits while there
// is work, and a thread that never comes (asleep, busy elsewhere, lost to fork) costs only its
// share. Which thread gets which number differs from run to run: a task writes to places that its
// number alone decides, and results are the same for any count of workers.
//
// A task neither throws nor allocates: the hooks of an object's memory are called on the caller's
// thread only. What tasks need is made ready before. A runner may throw, if it is written in C++; then the caller's
// thread does what is left, and the results are those of any other count of workers.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "foundation/memory.h"

namespace gphys {

class Workers {
public:
    /// More are taken for a mistake: no machine's threads are that many, and none would help.
    static constexpr uint32_t max_count = 1024;

    /// `count` threads, the caller's included; 0 stands for 1. Those of `runner` if there is one,
    /// else count - 1 are started. Throws std::bad_alloc, with none left running, if they cannot be;
    /// on a platform without threads the caller's is all there is.
    Workers(uint32_t count, const gphys_task_runner* runner, std::pmr::memory_resource* memory);
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers();

    /// How many may work at the same time, at least 1: what to divide work by.
    uint32_t count() const { return count_; }

    /// Runs may be asked for by several threads at once: the workers serve one of them and the
    /// others do their own work. No run from within a task.
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
    /// What is being run: lives on the stack of the caller.
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
        std::atomic<uint64_t> next{0};         // wider than count: every thread goes one beyond
        std::atomic<uint32_t> taking_part{0};  // threads of a runner
    };

    /// Where a caller and the threads meet.
    struct Meeting {
        std::mutex serving;  // held by the caller that the threads work for
        std::mutex mutex;    // guards what is below
        std::condition_variable wake, done;
        Job* job = nullptr;  // with work left to take
        uint32_t working = 0;
        bool stopping = false;
    };

    void share(Job& job) const noexcept;
    void serve() const;
    void stop();
    bool in_forked_child() const;

    uint32_t count_;
    gphys_task_runner runner_{};
    Vector<std::thread> threads_;
    Meeting* meeting_ = nullptr;  // if there are threads
    long process_;                // that they are in
};

/// For objects that may have been given none: null stands for the caller's thread alone.
template <class Task>
void run(const Workers* workers, uint32_t count, Task&& task) noexcept {
    if (workers) {
        workers->run(count, task);
    } else {
        for (uint32_t i = 0; i < count; ++i) task(i);
    }
}

}  // namespace gphys
