// How a batch is shared among a scene's workers: cut into chunks of fixed size, each item answered
// into its own place. The bits do not depend on who answers what.
#pragma once

#include <algorithm>
#include <atomic>

#include "c_api/api.h"
#include "foundation/workers.h"

namespace gphys {

/// Items that are handed out at once. 256 rays take about 0.1 ms: a thousand times what handing out
/// costs, and a thousandth of a batch that is worth sharing.
constexpr uint32_t batch_chunk = 256;

/// visit(begin, end) for each chunk of 0 .. count - 1.
template <class Visit>
void for_each_chunk(const Workers& workers, uint32_t count, Visit&& visit) {
    const uint32_t chunks = count / batch_chunk + (count % batch_chunk != 0);
    workers.run(chunks, [&](uint32_t chunk) {
        const uint32_t begin = chunk * batch_chunk;
        visit(begin, begin + std::min(batch_chunk, count - begin));
    });
}

/// answer(i) for each item; it writes the output of item i.
template <class Answer>
void answer_each(const Workers& workers, uint32_t count, Answer&& answer) {
    for_each_chunk(workers, count, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) answer(i);
    });
}

/// How many elements of an array there are to check: a stride of 0 repeats one.
inline uint32_t distinct(uint32_t stride, uint32_t count) { return stride == 0 ? std::min(count, 1u) : count; }

/// check(i) for each item. Returns the status of the first that is not GPHYS_OK; that one is
/// checked once more, on this thread, where its message belongs.
template <class Check>
gphys_status check_each(const Workers& workers, uint32_t count, Check&& check) {
    std::atomic<uint32_t> first_bad{count};
    for_each_chunk(workers, count, [&](uint32_t begin, uint32_t end) {
        uint32_t i = begin;
        while (i < end && check(i) == GPHYS_OK) ++i;
        if (i == end) return;
        uint32_t lowest = first_bad.load(std::memory_order_relaxed);
        while (i < lowest && !first_bad.compare_exchange_weak(lowest, i, std::memory_order_relaxed)) {
        }
    });
    const uint32_t bad = first_bad.load(std::memory_order_relaxed);
    return bad == count ? GPHYS_OK : check(bad);
}

}  // namespace gphys
