#include "foundation/sort_distinct.h"

#include <algorithm>
#include <limits>

#include "foundation/compiler.h"

namespace gphys {
namespace {

constexpr uint32_t few = 32;
/// Values in a range of so many bits are sorted by bit sets. One of so many bits is on the stack, 8 KB.
constexpr uint32_t set_bits = 17, stack_bits = 16;
/// A set with more words than this for each value takes longer than std::sort.
constexpr uint32_t most_words_of_each = 16;
constexpr uint32_t digit_bits = 8;

/// Rank sort: each value goes to the index that is the number of smaller ones. More comparisons than std::sort, but
/// vectorized and without branches.
void sort_few(uint32_t* values, uint32_t count) {
    constexpr uint32_t at_once = 8, sign = 1u << 31;  // SIMD registers compare signed integers
    int32_t given[few];
    std::fill_n(given, few, std::numeric_limits<int32_t>::max());
    for (uint32_t i = 0; i < count; ++i) given[i] = static_cast<int32_t>(values[i] ^ sign);
    const uint32_t end = (count + at_once - 1) / at_once * at_once;
    for (uint32_t i = 0; i < count; ++i) {
        uint32_t place = 0;
        for (uint32_t j = 0; j < end; ++j) place += given[j] < given[i];
        values[place] = static_cast<uint32_t>(given[i]) ^ sign;
    }
}

constexpr uint32_t words_of(uint32_t range) { return range / 32 + 1; }

void list_set(const uint32_t* set, uint32_t words, uint32_t first, uint32_t* out) {
    for (uint32_t word = 0; word < words; ++word) {
        for (uint32_t rest = set[word]; rest != 0; rest &= rest - 1) {
            *out++ = first + 32 * word + static_cast<uint32_t>(lowest_bit(rest));
        }
    }
}

/// Values from `first` to first + range; `set` has the words for that.
void sort_by_set(uint32_t* values, uint32_t count, uint32_t first, uint32_t range, uint32_t* set) {
    const uint32_t words = words_of(range);
    std::fill_n(set, words, 0);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t bit = values[i] - first;
        set[bit / 32] |= 1u << bit % 32;
    }
    list_set(set, words, first, values);
}

/// The same with a set of part of the range at a time; the values above it move to the end meanwhile.
GPHYS_NOINLINE void sort_by_sets_on_stack(uint32_t* values, uint32_t count, uint32_t first, uint32_t range) {
    constexpr uint32_t part = 1u << stack_bits, words = part / 32;
    uint32_t set[words + 1];  // the last word is for the values above
    for (; range >= part; range -= part, first += part) {
        std::fill_n(set, words, 0);
        uint32_t below = count;
        for (uint32_t i = count; i-- > 0;) {
            // Without an unpredictable branch.
            const uint32_t value = values[i], bit = value - first;
            const bool is_above = bit >= part;
            values[below - 1] = value;
            below -= is_above;
            set[is_above ? words : bit / 32] |= 1u << bit % 32;
        }
        list_set(set, words, first, values);
        values += below;
        count -= below;
    }
    sort_by_set(values, count, first, range, set);
}

/// Divides the values by the highest bits of their range, then sorts each part.
GPHYS_NOINLINE void sort_by_digits(uint32_t* values, uint32_t count, uint32_t first, uint32_t range) {
    uint32_t shift = 0;
    while (range >> shift >> digit_bits != 0) ++shift;
    shift = std::max(shift, set_bits);
    const uint32_t digits = (range >> shift) + 1;
    uint32_t next[1u << digit_bits], end[1u << digit_bits];
    std::fill_n(end, digits, 0);
    const auto digit_of = [&](uint32_t value) { return (value - first) >> shift; };
    for (uint32_t i = 0; i < count; ++i) ++end[digit_of(values[i])];
    uint32_t sum = 0;
    for (uint32_t digit = 0; digit < digits; ++digit) {
        next[digit] = sum;
        end[digit] = sum += end[digit];
    }
    for (uint32_t digit = 0; digit < digits; ++digit) {
        while (next[digit] < end[digit]) {
            uint32_t value = values[next[digit]];
            for (uint32_t other = digit_of(value); other != digit; other = digit_of(value)) {
                std::swap(value, values[next[other]++]);
            }
            values[next[digit]++] = value;
        }
    }
    for (uint32_t digit = 0, begin = 0; digit < digits; begin = end[digit++]) {
        sort_distinct(values + begin, end[digit] - begin, end[digit] - begin);
    }
}

}  // namespace

void sort_distinct(uint32_t* values, uint32_t count, uint32_t capacity) {
    if (count <= few) return sort_few(values, count);
    uint32_t first = values[0], last = values[0], descents = 0;
    for (uint32_t i = 1; i < count; ++i) {
        first = std::min(first, values[i]);
        last = std::max(last, values[i]);
        descents += values[i] < values[i - 1];  // instead of stopping at the first: the loop is vectorised
    }
    if (descents == 0) return;
    const uint32_t range = last - first;
    if (range >> set_bits != 0) return sort_by_digits(values, count, first, range);
    if (range / 32 / most_words_of_each > count) return std::sort(values, values + count);
    const bool fits_behind = range >> stack_bits != 0 && words_of(range) <= capacity - count;
    if (!fits_behind) return sort_by_sets_on_stack(values, count, first, range);
    sort_by_set(values, count, first, range, values + count);
}

}  // namespace gphys
