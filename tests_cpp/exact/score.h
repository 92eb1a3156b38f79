// What an examination found: how many cases it asked, which answers were false, how large the worst
// error was and of which input. An examination is a function of the examined function, so that a
// spoiled copy can stand in for it: one that finds nothing wrong with a spoiled copy proves nothing.
#pragma once

#include <string>

#include "effort.h"
#include "test.h"

namespace test {

/// Structs of floats, to the bit.
template <class... Values>
std::string bits_of(const Values&... values) {
    std::string text;
    const auto append = [&](const void* value, size_t size) {
        text += "{";
        for (size_t i = 0; i < size; i += sizeof(float)) {
            float number;
            std::memcpy(&number, static_cast<const char*>(value) + i, sizeof number);
            char digits[32];
            std::snprintf(digits, sizeof digits, "%s%a", i ? " " : "", static_cast<double>(number));
            text += digits;
        }
        text += "} ";
    };
    (append(&values, sizeof values), ...);
    return text;
}

class Score {
public:
    /// `bound`: of the error, in its unit; a function that only says yes or no has none.
    explicit Score(std::string function, double bound = 0, std::string unit = "")
        : function_(std::move(function)), unit_(std::move(unit)), bound_(bound) {}

    /// An answer that must be the truth, unless the case is so close that it may be either.
    template <class... Input>
    void answer(bool given, bool may_be_yes, bool may_be_no, const Input&... input) {
        ++cases_;
        yes_ += given;
        if (given ? may_be_yes : may_be_no) return;
        if (false_++ == 0) first_false_ = bits_of(input...);
    }
    template <class... Input>
    void answer(bool given, bool truth, const Input&... input) {
        answer(given, truth, !truth, input...);
    }
    template <class... Input>
    void error(double size, const Input&... input) {
        if (size <= worst_) return;  // a NaN is taken for the worst
        worst_ = size;
        worst_input_ = bits_of(input...);
    }

    /// Neither answer came too seldom for the examination to mean anything.
    bool both_ways() const { return yes_ * 50 > cases_ && (cases_ - yes_) * 50 > cases_; }
    bool kept() const { return false_ == 0 && worst_ <= bound_; }

    void print() const {
        std::printf("%-34s %9ld cases %9ld yes %3ld false", function_.c_str(), cases_, yes_, false_);
        if (!unit_.empty()) std::printf("  worst %.3g of %.3g %s", worst_, bound_, unit_.c_str());
        if (false_) std::printf("\n    first false: %s", first_false_.c_str());
        if (!unit_.empty() && worst_ > 0) std::printf("\n    worst: %s", worst_input_.c_str());
        std::printf("\n");
        std::fflush(stdout);
        const char* file = std::getenv("GAMEPHYS_SCORES");
        if (file) append_to(file);
    }

private:
    /// A row for bench/scores.py, written at once, for others may be appending too.
    void append_to(const char* path) const {
        const char* isa = std::getenv("GAMEPHYS_ISA");
        char numbers[128];
        std::snprintf(numbers, sizeof numbers, "%ld,%ld,%ld,%.9g,%.9g", cases_, yes_, false_, worst_, bound_);
        const std::string row = '"' + function_ + "\"," + build + ',' + (isa ? isa : "best") + ',' + numbers + ',' +
                                unit_ + ',' + (false_ ? first_false_ : worst_input_) + '\n';
        std::FILE* file = std::fopen(path, "a");
        REQUIRE(file);
        REQUIRE(std::fwrite(row.data(), 1, row.size(), file) == row.size());
        REQUIRE(std::fclose(file) == 0);
    }

    static constexpr const char* build =
#if defined __clang__
        "clang"
#else
        "gcc"
#endif
#if defined __OPTIMIZE__
        " optimised"
#else
        " -O0"
#endif
#if defined __FMA__
        " -march=haswell"
#endif
        ;

    std::string function_, unit_, first_false_, worst_input_;
    double bound_, worst_ = 0;
    long cases_ = 0, yes_ = 0, false_ = 0;
};

/// Enough to catch what is wrong in one answer of five hundred; what is not caught so gets many more.
constexpr long spoiled_cases = 2000;

/// The examined function keeps its promise, and each of the spoiled ones is caught not to.
template <class Examine, class Function, class... Spoiled>
void prove(long count, const Examine& examine, const Function& function, const Spoiled&... spoiled) {
    const Score score = examine(function, count);
    score.print();
    CHECK(score.kept());
    CHECK(score.both_ways());
    static_assert(sizeof...(spoiled) > 0, "an examination is proven by what it catches");
    const auto seems_right = [&](const auto& wrong) {
        return examine(wrong, spoiled_cases).kept() && examine(wrong, 20 * spoiled_cases).kept();
    };
    for (const bool kept : {seems_right(spoiled)...}) CHECK_FALSE(kept);
}

}  // namespace test
