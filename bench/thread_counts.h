// With how many threads work is measured beside one.
#pragma once

#include <cstdint>
#include <thread>
#include <vector>

namespace bench {

/// 2, 4, 8 and so on up to the number of processors; 2 in any case.
inline std::vector<uint32_t> thread_counts() {
    std::vector<uint32_t> counts{2};
    while (2 * counts.back() <= std::thread::hardware_concurrency()) counts.push_back(2 * counts.back());
    return counts;
}

}  // namespace bench
