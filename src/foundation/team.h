// Workers that share one long piece of work, phase after phase, with too little in a phase to wake
// anybody for. Whoever comes first leads; those who come later help, waiting busily between phases.
// The leader never waits for one who has not come, so a team of one does all the work itself.
//
// Members take tasks from both ends, by turns: what two of them did in a phase they mostly do in the next, and
// find it in their caches.
#pragma once

#include <atomic>
#include <thread>
#include <type_traits>

#include "foundation/compiler.h"

namespace gphys {

class Team {
public:
    /// More tasks are not in a phase.
    static constexpr uint32_t most_tasks = (1u << 20) - 1;

    /// To be called by each member. The first one does the work, which calls share; the others help and
    /// return when it is done.
    template <class Work>
    void join(Work&& work) noexcept {
        const uint32_t member = members_.fetch_add(1, std::memory_order_relaxed);
        if (member > 0) return help(member);
        work();
        done_.store(true, std::memory_order_release);
    }

    /// Of the leader: task(i, member) for each i below count, by whoever is there; returns when all are done.
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

    /// A little of the processor's time, then, if others need it, the system's.
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

    /// The tasks that are left of the phase under way. The ticket holds the phase, the end of those tasks and the
    /// first, so that nobody takes a task of one phase for that of another.
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
    // Of the phase under way: written while none is.
    void (*call_)(void*, uint32_t, uint32_t) = nullptr;
    void* context_ = nullptr;
};

/// For work that may be done alone: null stands for the caller.
template <class Task>
void share(Team* team, uint32_t count, Task&& task) noexcept {
    if (team && count > 1) {
        team->share(count, task);
    } else {
        for (uint32_t i = 0; i < count; ++i) task(i, 0);
    }
}

}  // namespace gphys
