// Threads, their wake-up, and the job system of the host (workers.h).
#include "foundation/workers.h"

#include <system_error>

#include "foundation/host_modes.h"

#if defined(__unix__) || defined(__APPLE__)
#include <signal.h>
#include <unistd.h>
#endif

namespace gphys {
namespace {

#if defined(__unix__) || defined(__APPLE__)
long this_process() { return getpid(); }

/// Blocks asynchronous signals while threads are created, which inherit the mask: the host's own threads handle them.
/// Synchronous faults and the signals of profilers are not blocked.
class SignalsBlocked {
public:
    SignalsBlocked() {
        sigset_t outside;
        sigfillset(&outside);
        for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGPROF}) sigdelset(&outside, own);
        pthread_sigmask(SIG_BLOCK, &outside, &before_);
    }
    ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

private:
    sigset_t before_;
};
#else
long this_process() { return 0; }

class SignalsBlocked {
public:
    SignalsBlocked() {}
};
#endif

/// A WebAssembly module has no threads unless it is built with shared memory.
#if defined(__wasm__) && !defined(__wasm_atomics__)
constexpr bool platform_has_threads = false;
#else
constexpr bool platform_has_threads = true;
#endif

}  // namespace

Workers::Workers(uint32_t count, const gphys_task_runner* runner, std::pmr::memory_resource* memory)
    : count_(runner || platform_has_threads ? std::max(count, 1u) : 1), threads_(memory), process_(this_process()) {
    if (runner) runner_ = *runner;
    if (runner || count_ == 1) return;
    sync_ = new (memory->allocate(sizeof(SyncBlock), alignof(SyncBlock))) SyncBlock;
    try {
        const SignalsBlocked blocked;
        threads_.reserve(count_ - 1);
        while (threads_.size() < count_ - 1) threads_.emplace_back([sync = sync_] { serve(*sync); });
    } catch (const std::system_error&) {  // no more threads
        stop();
        throw std::bad_alloc();
    } catch (...) {
        stop();
        throw;
    }
}

Workers::~Workers() {
    if (sync_) stop();
}

void Workers::set_count(uint32_t count) {
    if (std::max(count, 1u) == count_ && !in_forked_child()) return;
    Workers others(count, runner_.run ? &runner_ : nullptr, threads_.get_allocator().resource());
    std::swap(count_, others.count_);
    threads_.swap(others.threads_);
    std::swap(sync_, others.sync_);
    std::swap(process_, others.process_);
}

void Workers::stop() {
    if (in_forked_child()) {
        // In a forked child the threads do not exist, and the state of the condition variables is theirs: joining or
        // destroying would block.
        for (std::thread& lost : threads_) new (&lost) std::thread();
    } else {
        {
            const std::lock_guard<std::mutex> lock(sync_->mutex);
            sync_->stopping = true;
        }
        sync_->wake.notify_all();
        for (std::thread& thread : threads_) thread.join();
        sync_->~SyncBlock();
    }
    threads_.get_allocator().resource()->deallocate(sync_, sizeof(SyncBlock), alignof(SyncBlock));
}

/// fork copies the calling thread only, and all locks as they were at that moment.
bool Workers::in_forked_child() const { return process_ != this_process(); }

void Workers::share(Job& job) const noexcept {
    if (runner_.run) {
        const auto take_part = [](void* context, uint32_t) {
            const StandardModes modes;  // on a thread of the host
            Job& shared = *static_cast<Job*>(context);
            shared.taking_part.fetch_add(1, std::memory_order_relaxed);
            shared.drain();
            shared.taking_part.fetch_sub(1, std::memory_order_release);
        };
        try {
            runner_.run(runner_.user, take_part, &job, std::min(count_, job.count));
        } catch (...) {  // a runner written in C++
        }
        // Run the tasks that the runner has not: half a step cannot be undone.
        job.drain();
        while (job.taking_part.load(std::memory_order_acquire) > 0) std::this_thread::yield();
        return;
    }
    if (in_forked_child() || !sync_->serving.try_lock()) {
        job.drain();
        return;
    }
    const std::lock_guard<std::mutex> served(sync_->serving, std::adopt_lock);
    {
        const std::lock_guard<std::mutex> lock(sync_->mutex);
        sync_->job = &job;
    }
    sync_->wake.notify_all();
    job.drain();
    std::unique_lock<std::mutex> lock(sync_->mutex);
    sync_->job = nullptr;
    sync_->done.wait(lock, [this] { return sync_->working == 0; });
}

/// The main function of a thread.
void Workers::serve(SyncBlock& sync) {
    std::unique_lock<std::mutex> lock(sync.mutex);
    for (;;) {
        sync.wake.wait(lock, [&sync] { return sync.stopping || sync.job; });
        if (sync.stopping) return;
        Job& job = *sync.job;
        ++sync.working;
        lock.unlock();
        job.drain();
        lock.lock();
        sync.job = nullptr;
        if (--sync.working == 0) sync.done.notify_one();
    }
}

}  // namespace gphys
