// A team of workers for work in many short phases, each too short to wake threads for (fork-join with spinning). The
// first thread to arrive is the leader. Later ones help, and spin between phases. The leader never waits for a thread
// that has not arrived, so a team of one does all the work itself.
//
// Members take tasks alternately from both ends. So two members mostly get the same tasks in each phase, whose data are
// in their caches.
#pragma once

#include <atomic>
#include <thread>
#include <type_traits>

#include "foundation/compiler.h"

namespace gphys {

class Team {
public:
    /// The largest number of tasks in a phase.
    static constexpr uint32_t most_tasks = (1u << 20) - 1;

    /// Called by each member. The first one runs the work, which calls share(); the others help and return when the
    /// work is done.
    template <class Work>
    void join(Work&& work) noexcept {
        const uint32_t member = members_.fetch_add(1, std::memory_order_relaxed);
        if (member > 0) return help(member);
        work();
        done_.store(true, std::memory_order_release);
    }

    /// Called by the leader: task(i, member) for each i below count, on all members that have arrived. Returns when all
    /// tasks are done.
    template <class Task>
    void share(uint32_t count, Task&& task) noexcept {
        call_ = [](void* context, uint32_t i, uint32_t member) {
            (*static_cast<std::remove_reference_t<Task>*>(context))(i, member);
        };
        context_ = const_cast<void*>(static_cast<const void*>(&task));
        finished_.store(0, std::memory_order_relaxed);
        ticket_.store(++phase_ << 40 | uint64_t{count} << end_shift, std::memory_order_release);
        take_all(0);
        for (SpinBackoff patience; finished_.load(std::memory_order_acquire) < count;) patience.wait();
    }

private:
    static constexpr int end_shift = 20;

    /// Spins with pause instructions first, then yields to the system.
    class SpinBackoff {
    public:
        void wait() {
            if (++turns_ % 256 == 0) {
                std::this_thread::yield();
                return;
            }
            pause_briefly();
        }

    private:
        uint32_t turns_ = 0;
    };

    /// Runs the remaining tasks of the current phase. The ticket holds the number of the phase and the range of its
    /// remaining tasks, so that no member takes a task of another phase.
    void take_all(uint32_t member) {
        const bool from_end = member % 2 == 1;
        uint64_t ticket = ticket_.load(std::memory_order_acquire);
        for (;;) {
            const uint32_t first = ticket & most_tasks, end = ticket >> end_shift & most_tasks;
            if (first >= end) return;
            const uint64_t next = from_end ? ticket - (uint64_t{1} << end_shift) : ticket + 1;
            if (!ticket_.compare_exchange_weak(ticket, next, std::memory_order_acq_rel)) continue;
            call_(context_, from_end ? end - 1 : first, member);
            finished_.fetch_add(1, std::memory_order_release);
            ticket = ticket_.load(std::memory_order_acquire);
        }
    }

    void help(uint32_t member) {
        for (SpinBackoff patience; !done_.load(std::memory_order_acquire); patience.wait()) take_all(member);
    }

    std::atomic<uint32_t> members_{0}, finished_{0};
    std::atomic<uint64_t> ticket_{0};
    std::atomic<bool> done_{false};
    uint64_t phase_ = 0;
    // Of the current phase; written between phases.
    void (*call_)(void*, uint32_t, uint32_t) = nullptr;
    void* context_ = nullptr;
};

/// If team is null, the caller runs all tasks.
template <class Task>
void share(Team* team, uint32_t count, Task&& task) noexcept {
    if (team && count > 1) {
        team->share(count, task);
    } else {
        for (uint32_t i = 0; i < count; ++i) task(i, 0);
    }
}

}  // namespace gphys
