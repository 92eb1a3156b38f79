// How far the times of repetitions lie apart: the middle half of them.
#pragma once

#include <algorithm>
#include <vector>

namespace bench {

struct Spread {
    double lower = 0, median = 0, upper = 0;  // quartiles

    Spread scaled(double factor) const { return {lower * factor, median * factor, upper * factor}; }
};

/// Of at least one time.
inline Spread spread_of(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    const auto at = [&](size_t quarters) { return times[quarters * (times.size() - 1) / 4]; };
    return {at(1), times[times.size() / 2], at(3)};
}

}  // namespace bench
