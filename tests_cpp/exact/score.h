// The result of an examination: the number of cases, the false answers, and the largest error with its input. An
// examination compares a function with a reference. It takes the function as an argument, so it can also be run on
// mutants, copies with a deliberate fault; it must find the fault of each (mutation testing).
#pragma once

#include <algorithm>
#include <string>

#include "effort.h"
#include "test.h"

namespace test {

/// The floats of structs as hexadecimal text, which loses no bits.
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
    /// `bound`: the largest allowed error, in `unit`. Functions that return yes or no have none.
    explicit Score(std::string function, double bound = 0, std::string unit = "")
        : function_(std::move(function)), unit_(std::move(unit)), bound_(bound) {}

    /// Counts an answer. Both answers are right in a case within the documented tolerance.
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
        if (size <= worst_) return;  // NaN counts as the worst
        worst_ = size;
        worst_input_ = bits_of(input...);
    }

    /// Whether each answer is that of at least 2 % of the cases. Otherwise the cases test little.
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
    /// Appends a row for bench/scores.py, in one write, because other processes may append too.
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

/// Cases for a mutant: enough to find a fault in one answer of five hundred.
constexpr long spoiled_cases = 2000;

/// Whether no fault is found in a mutant, in so many cases or in twenty times as many. Longer and longer runs of the
/// same cases: most mutants show a fault in the first few.
template <class Examine, class Function>
bool seems_right(const Examine& examine, const Function& mutant) {
    const long counts[] = {spoiled_cases / 100, spoiled_cases / 10, spoiled_cases, 20 * spoiled_cases};
    return std::all_of(std::begin(counts), std::end(counts), [&](long count) { return examine(mutant, count).kept(); });
}

/// Checks that the examination finds no fault in the function, and one in each mutant.
template <class Examine, class Function, class... Spoiled>
void prove(long count, const Examine& examine, const Function& function, const Spoiled&... spoiled) {
    const Score score = examine(function, count);
    score.print();
    CHECK(score.kept());
    CHECK(score.both_ways());
    static_assert(sizeof...(spoiled) > 0, "an examination needs a mutant that it must reject");
    for (const bool kept : {seems_right(examine, spoiled)...}) CHECK_FALSE(kept);
}

}  // namespace test
