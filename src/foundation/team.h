// A team of workers for work in many short phases, each too short to wake threads for (fork-join with spinning and work
// stealing). The first thread to arrive is the leader. Later ones help, and spin between phases. The leader never waits
// for a thread that has not arrived, so a team of one does all the work itself.
//
// In each phase every member has a contiguous range of the tasks, mostly that of the phase before, whose data are in
// its cache, and takes them from its own cache line. One counter for all of them would cost each task two transfers of
// a cache line between cores (half a microsecond between distant ones). A member without tasks takes them from the ends
// of other members' ranges.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <type_traits>

#include "foundation/compiler.h"

namespace gphys {

class Team {
public:
    /// The largest number of tasks in a phase.
    static constexpr uint32_t most_tasks = (1u << 20) - 1;
    /// Threads that arrive later do not help: barriers would take longer than their share of a phase.
    static constexpr uint32_t most_members = 16;

    /// Called by each member. The first one runs the work, which calls share(); the others help and return when the
    /// work is done.
    template <class Work>
    void join(Work&& work) noexcept {
        const uint32_t member = arrived_.fetch_add(1, std::memory_order_relaxed);
        if (member >= most_members) return;
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
        ++phase_;
        issued_ += count;
        const uint32_t sharers = members();
        for (uint32_t member = sharers; member-- > 0;) {
            const uint32_t first = part(count, member, sharers), end = part(count, member + 1, sharers);
            members_[member].ticket.store(phase_ << 40 | uint64_t{end} << end_shift | first, std::memory_order_release);
        }
        take_all(0);
        for (SpinBackoff patience; finished() < issued_;) patience.wait();
    }

private:
    static constexpr int end_shift = 20;
    static constexpr size_t cache_line = 64;

    /// A ticket holds the number of the phase and the range of the remaining tasks, so that no task of another phase is
    /// taken. It is read by members that take tasks, `finished` by the leader that waits.
    struct Member {
        alignas(cache_line) std::atomic<uint64_t> ticket{0};
        alignas(cache_line) std::atomic<uint64_t> finished{0};  // in all phases, when the member last ran out of tasks
    };

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

    static uint32_t part(uint32_t count, uint32_t member, uint32_t sharers) {
        return static_cast<uint32_t>(uint64_t{count} * member / sharers);
    }

    uint32_t members() const { return std::min(arrived_.load(std::memory_order_relaxed), most_members); }

    uint64_t finished() const {
        uint64_t sum = 0;
        for (uint32_t member = 0; member < members(); ++member)
            sum += members_[member].finished.load(std::memory_order_acquire);
        return sum;
    }

    /// Runs tasks of the current phase until none is left: its own from the front, those of others from the end.
    void take_all(uint32_t member) {
        uint64_t run = 0;
        for (uint32_t i = 0, sharers = members(); i < sharers; ++i) {
            const uint32_t owner = (member + i) % sharers;
            const auto take = [&](uint64_t ticket) {
                return owner == member ? ticket + 1 : ticket - (uint64_t{1} << end_shift);
            };
            std::atomic<uint64_t>& tickets = members_[owner].ticket;
            uint64_t ticket = tickets.load(std::memory_order_acquire);
            for (;;) {
                const uint32_t first = ticket & most_tasks, end = ticket >> end_shift & most_tasks;
                if (first >= end) break;
                if (!tickets.compare_exchange_weak(ticket, take(ticket), std::memory_order_acq_rel)) continue;
                call_(context_, owner == member ? first : end - 1, member);
                ++run;
                ticket = tickets.load(std::memory_order_acquire);
            }
        }
        if (run == 0) return;
        std::atomic<uint64_t>& finished = members_[member].finished;
        finished.store(finished.load(std::memory_order_relaxed) + run, std::memory_order_release);
    }

    void help(uint32_t member) {
        take_all(member);
        const std::atomic<uint64_t>& ticket = members_[member].ticket;
        for (SpinBackoff patience; !done_.load(std::memory_order_acquire); patience.wait()) {
            const uint64_t range = ticket.load(std::memory_order_relaxed);
            if ((range & most_tasks) < (range >> end_shift & most_tasks)) take_all(member);
        }
    }

    Member members_[most_members];
    std::atomic<uint32_t> arrived_{0};
    std::atomic<bool> done_{false};
    // Written by the leader between phases.
    uint64_t phase_ = 0, issued_ = 0;
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
