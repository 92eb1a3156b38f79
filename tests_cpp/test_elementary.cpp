// The elementary functions beside MPFR. What is the double nearest to the true value is told by 160 bits: no value
// of these functions is so close to the middle between two doubles that more would be needed.
#include "foundation/elementary.h"

#include <mpfr.h>

#include <cfenv>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "foundation/elementary_rounding.h"
#include "foundation/elementary_wide.h"
#include "test.h"

using namespace gphys;

namespace {

class Real {
public:
    explicit Real(double value = 0) {
        mpfr_init2(value_, 160);
        mpfr_set_d(value_, value, MPFR_RNDN);
    }
    Real(const Real&) = delete;
    Real& operator=(const Real&) = delete;
    ~Real() { mpfr_clear(value_); }
    operator mpfr_ptr() { return value_; }

private:
    mpfr_t value_;
};

struct Function {
    const char* name;
    double (*ours)(double);
    void (*truth)(mpfr_ptr y, double x);
    double (*argument)(test::Random& random);
    double largest;             // argument
    std::vector<double> edges;  // their neighbourhoods are tested
};

/// Of any size between 2^low and 2^high, all sizes alike.
double of_any_size(test::Random& random, int low, int high) {
    return std::ldexp(random.uniform(1, 2), low + static_cast<int>(random.index(static_cast<uint32_t>(high - low))));
}

/// Of the exponential: of all sizes, evenly, up to the first entries of the table, and where results are below the
/// smallest normal double.
double time_constant(test::Random& random) {
    switch (random.index(4)) {
        case 0:
            return random.uniform(0, 40);
        case 1:
            return random.uniform(700, 746);
        default:
            return of_any_size(random, -60, 10);
    }
}

/// Of all sizes, evenly, and around the multiples of pi / 2.
double angle(test::Random& random) {
    const double sign = random.index(2) != 0 ? 1 : -1;
    switch (random.index(3)) {
        case 0:
            return sign * random.uniform(0, 4);
        case 1:
            return sign * of_any_size(random, -32, 2);
        default:
            return sign * (random.index(2) + 1) * (pi / 2) *
                   (1 + of_any_size(random, -53, -3) * (random.index(3) - 1.0));
    }
}

double any_number(test::Random& random) {
    const double size = random.index(2) != 0 ? of_any_size(random, -1074, 1024) : random.index(1u << 31) + 1.0;
    return random.index(2) != 0 ? size : -size;
}

template <int (*F)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t)>
void apply(mpfr_ptr y, double x) {
    mpfr_set_d(y, x, MPFR_RNDN);
    F(y, y, MPFR_RNDN);
}

const std::vector<Function>& functions() {
    static const std::vector<Function> all = [] {
        std::vector<double> steps, sixteenths, whole;
        for (int i = 1; i <= 128; ++i) steps.push_back(i * (0.69314718055994531 / 32));
        for (const double z :
             {0x1p-54, 0x1p-53, 0x1p-27, 0x1p-6, 1.0, 37.0, 37.43, 708.4, 709.8, 745.13, 745.2, 746.0}) {
            steps.push_back(z);
        }
        for (int i = 1; i <= 128; ++i) sixteenths.push_back(i / 32.0);
        for (const double x : {0x1p-30, 0x1p-27, 0x1p-26, pi / 4, pi / 2, 3 * pi / 4, pi, 5 * pi / 4}) {
            sixteenths.push_back(x);
        }
        for (int i = 1; i <= 64; ++i) whole.push_back(1.0 * i * i * i);
        whole.push_back(0x1p-1074);
        whole.push_back(0x1p-1022);
        return std::vector<Function>{
            {"exp(-z)", [](double z) { return decay(z).kept; }, [](mpfr_ptr y, double z) { apply<mpfr_exp>(y, -z); },
             time_constant, INFINITY, steps},
            {"1 - exp(-z)", [](double z) { return decay(z).lost; },
             [](mpfr_ptr y, double z) {
                 apply<mpfr_expm1>(y, -z);
                 mpfr_neg(y, y, MPFR_RNDN);
             },
             time_constant, INFINITY, steps},
            {"sin", [](double x) { return sin_cos(x).sin; }, apply<mpfr_sin>, angle, 4, sixteenths},
            {"cos", [](double x) { return sin_cos(x).cos; }, apply<mpfr_cos>, angle, 4, sixteenths},
            {"tan", gphys::tan, apply<mpfr_tan>, angle, 4, sixteenths},
            {"cbrt", gphys::cbrt, apply<mpfr_cbrt>, any_number, INFINITY, whole},
        };
    }();
    return all;
}

/// In units of the last place.
struct Errors {
    long cases = 0, wrong = 0;
    double worst = 0;

    void look(const Function& f, double x) {
        Real truth;
        f.truth(truth, x);
        const double got = f.ours(x), nearest = mpfr_get_d(truth, MPFR_RNDN);
        ++cases;
        const bool right = got == nearest && std::signbit(got) == std::signbit(nearest);
        if (!right && wrong++ == 0) UNSCOPED_INFO(f.name << " of " << x << " is " << got << ", not " << nearest);
        mpfr_sub_d(truth, truth, got, MPFR_RNDN);
        const double ulp = std::fabs(std::nextafter(nearest, INFINITY) - nearest);
        worst = std::max(worst, std::fabs(mpfr_get_d(truth, MPFR_RNDN)) / ulp);
    }
};

void test_errors(long count, bool print) {
    if (print)
        std::printf("| function | arguments | not nearest | largest error, ulp |\n| --- | ---: | ---: | ---: |\n");
    for (const Function& f : functions()) {
        test::Random random(7);
        Errors errors;
        for (const double edge : f.edges) {
            double x = edge;
            for (int i = 0; i < 4; ++i) x = std::nextafter(x, 0);
            for (int i = 0; i < 9; ++i, x = std::nextafter(x, INFINITY)) {
                if (x > 0 && x <= f.largest) errors.look(f, x);
            }
        }
        while (errors.cases < count) {
            const double x = f.argument(random);
            if (std::fabs(x) <= f.largest) errors.look(f, x);
        }
        CHECK(errors.wrong == 0);
        CHECK(errors.worst <= 0.5);
        CHECK(errors.worst > 0.49);
        if (print) std::printf("| %s | %ld | %ld | %.7f |\n", f.name, errors.cases, errors.wrong, errors.worst);
    }
}

/// How far the value is from the middle between two doubles, in units of the last place.
double from_middle(const Function& f, double x) {
    Real truth;
    f.truth(truth, x);
    const double below = mpfr_get_d(truth, MPFR_RNDD), above = mpfr_get_d(truth, MPFR_RNDU);
    Real twice(below);
    mpfr_add_d(twice, twice, above, MPFR_RNDN);
    mpfr_mul_ui(truth, truth, 2, MPFR_RNDN);
    mpfr_sub(truth, truth, twice, MPFR_RNDN);
    return mpfr_get_d(truth, MPFR_RNDN) / (2 * (above - below));
}

/// An x near a small one whose f is almost such a middle. f(x) is x or 1 but for something that changes slowly from
/// one double to the next, by `slope` last places of f for one of x, so the x for which that is right can be told.
double hard_neighbour(const Function& f, double x, double (*slope)(double)) {
    for (int i = 0; i < 3; ++i) {
        const double last = std::nextafter(x, INFINITY) - x;
        x -= std::round(from_middle(f, x) / slope(x)) * last;
    }
    return x;
}

double last_place(double x) { return std::nextafter(x, INFINITY) - x; }

}  // namespace

TEST_CASE("elementary functions give the double nearest to the true value") {
    test_errors(50000, std::getenv("GPHYS_PRINT_ERRORS") != nullptr);
}

TEST_CASE("elementary functions of millions of arguments give the double nearest to the true value", "[.long]") {
    test_errors(4000000, true);
}

TEST_CASE("elementary functions are right where the true value is almost the middle between two doubles") {
    // Slopes in last places of f; those below 1 have the last place 2^-53.
    const struct {
        const char* name;
        double (*slope)(double);
    } slopes[] = {
        {"exp(-z)", [](double z) { return -last_place(z) * 0x1p53; }},
        {"1 - exp(-z)", [](double z) { return -z; }},
        {"sin", [](double x) { return -x * x / 2; }},
        {"cos", [](double x) { return -x * last_place(x) * 0x1p53; }},
        {"tan", [](double x) { return x * x; }},
    };
    for (const Function& f : functions()) {
        for (const auto& slope : slopes) {
            if (std::string(slope.name) != f.name) continue;
            test::Random random(8);
            Errors errors;
            double closest = 1;
            int close = 0;
            for (int i = 0; i < 2000; ++i) {
                const double x = hard_neighbour(f, of_any_size(random, -24, -13), slope.slope);
                const double off = std::fabs(from_middle(f, x));
                closest = std::min(closest, off);
                close += off < 0x1p-13;  // closer than the first of the two phases can tell
                errors.look(f, x);
            }
            CAPTURE(f.name, closest);
            CHECK(errors.wrong == 0);
            CHECK(close > 1000);
            CHECK(closest < 0x1p-30);
        }
    }
}

TEST_CASE("elementary functions at the ends of their ranges") {
    REQUIRE(decay(0).kept == 1);
    REQUIRE(decay(0).lost == 0);
    REQUIRE(decay(INFINITY).kept == 0);
    REQUIRE(decay(INFINITY).lost == 1);
    REQUIRE(decay(0x1p-1074).lost == 0x1p-1074);
    REQUIRE(decay(745.13).kept == 0x1p-1074);
    REQUIRE(decay(745.14).kept == 0);
    REQUIRE(decay(1e300).kept == 0);
    REQUIRE(sin_cos(0).sin == 0);
    REQUIRE(sin_cos(0).cos == 1);
    REQUIRE(std::signbit(sin_cos(-0.0).sin));
    REQUIRE(std::signbit(gphys::tan(-0.0)));
    REQUIRE(gphys::tan(0x1p-1074) == 0x1p-1074);
    REQUIRE(sin_cos(4).cos == Approx(-0.6536436208636119));
    for (const double x : {std::nextafter(4.0, 5.0), -5.0, 1e300, double{INFINITY}, double{NAN}}) {
        REQUIRE(std::isnan(sin_cos(x).sin));
        REQUIRE(std::isnan(sin_cos(x).cos));
        REQUIRE(std::isnan(gphys::tan(x)));
    }
    REQUIRE(std::signbit(gphys::cbrt(-0.0)));
    REQUIRE(gphys::cbrt(-INFINITY) == -INFINITY);
    REQUIRE(std::isnan(gphys::cbrt(NAN)));
    for (int i = 1; i <= 1000; ++i) REQUIRE(gphys::cbrt(1.0 * i * i * i) == i);
}

TEST_CASE("elementary functions rise and fall as the true ones do") {
    // From one double to the next, where another entry of a table is taken, too.
    for (const Function& f : functions()) {
        const bool falls = f.name == std::string("exp(-z)") || f.name == std::string("cos");
        for (const double edge : f.edges) {
            if (edge > 1.5 && f.argument == angle) continue;
            double x = edge;
            for (int i = 0; i < 20; ++i) x = std::nextafter(x, 0);
            for (int i = 0; i < 40; ++i) {
                const double next = std::nextafter(x, INFINITY), here = f.ours(x), there = f.ours(next);
                CAPTURE(f.name, x);
                REQUIRE((falls ? there <= here : here <= there));
                x = next;
            }
        }
    }
}

TEST_CASE("elementary functions are the same in every rounding mode") {
    test::Random random(9);
    for (int i = 0; i < 5000; ++i) {
        for (const Function& f : functions()) {
            const volatile double x = f.argument(random);
            const double expected = f.ours(x);
            for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
                std::fesetround(mode);
                const volatile double got = f.ours(x);
                std::fesetround(FE_TONEAREST);
                const bool same = got == expected || (std::isnan(expected) && std::isnan(got));
                CAPTURE(f.name, x, mode);
                if (!same) REQUIRE(got == expected);
            }
        }
    }
    SUCCEED();
}

namespace {

constexpr mpfr_prec_t wide_bits = 300;

/// From 64-bit halves of its limbs, as they are.
void set(mpfr_ptr to, const Wide& from) {
    mpfr_set_ui(to, 0, MPFR_RNDN);
    for (int i = 7; i >= 0; --i) {
        mpfr_mul_2ui(to, to, 32, MPFR_RNDN);
        mpfr_add_ui(to, to, from.limb[i], MPFR_RNDN);
    }
    mpfr_div_2ui(to, to, 224, MPFR_RNDN);
}

struct Precise {
    mpfr_t value;
    Precise() { mpfr_init2(value, wide_bits); }
    Precise(const Precise&) = delete;
    Precise& operator=(const Precise&) = delete;
    ~Precise() { mpfr_clear(value); }
    /// Of the difference, as a power of two.
    double off(const Wide& from) const {
        Precise other;
        set(other.value, from);
        mpfr_sub(other.value, other.value, value, MPFR_RNDN);
        return std::fabs(mpfr_get_d(other.value, MPFR_RNDN));
    }
};

}  // namespace

TEST_CASE("constants of the elementary functions are right to their last bit") {
    Precise x;
    mpfr_const_log2(x.value, MPFR_RNDN);
    mpfr_div_ui(x.value, x.value, 32, MPFR_RNDN);
    REQUIRE(x.off(wide::ln2_32) < 0x1p-224);
    mpfr_neg(x.value, x.value, MPFR_RNDN);
    mpfr_exp(x.value, x.value, MPFR_RNDN);
    REQUIRE(x.off(wide::root_of_half) < 0x1p-224);
    mpfr_const_pi(x.value, MPFR_RNDN);
    mpfr_div_ui(x.value, x.value, 2, MPFR_RNDN);
    REQUIRE(x.off(wide::half_pi) < 0x1p-224);
    mpfr_set_d(x.value, 1.0 / 16, MPFR_RNDN);
    mpfr_sin(x.value, x.value, MPFR_RNDN);
    REQUIRE(x.off(wide::sin_16th) < 0x1p-224);
    mpfr_set_d(x.value, 1.0 / 16, MPFR_RNDN);
    mpfr_cos(x.value, x.value, MPFR_RNDN);
    REQUIRE(x.off(wide::cos_16th) < 0x1p-224);
}

TEST_CASE("the second phase of the elementary functions is right to 200 bits") {
    test::Random random(11);
    Precise truth, turned;
    for (int i = 0; i < 3000; ++i) {
        const double z = of_any_size(random, -54, 9);
        const wide::Steps steps(z);
        mpfr_set_d(truth.value, -z, MPFR_RNDN);
        mpfr_exp(truth.value, truth.value, MPFR_RNDN);
        mpfr_mul_2si(truth.value, truth.value, steps.halvings, MPFR_RNDN);
        REQUIRE(truth.off(wide::kept(parts_of(z).wide(), steps)) < 0x1p-200);
        const double x = i % 2 == 0 ? random.uniform(0, 4) : of_any_size(random, -27, 2);
        const int quarters = static_cast<int>(x / (pi / 2) + 0.5);
        const wide::SinCos found = wide::sin_cos(parts_of(x).wide(), quarters);
        mpfr_const_pi(turned.value, MPFR_RNDN);
        mpfr_mul_d(turned.value, turned.value, quarters * 0.5, MPFR_RNDN);
        mpfr_d_sub(turned.value, x, turned.value, MPFR_RNDN);
        mpfr_abs(turned.value, turned.value, MPFR_RNDN);
        mpfr_sin(truth.value, turned.value, MPFR_RNDN);
        REQUIRE(truth.off(found.sin) < 0x1p-200);
        mpfr_cos(truth.value, turned.value, MPFR_RNDN);
        REQUIRE(truth.off(found.cos) < 0x1p-200);
    }
}

TEST_CASE("products of 64 bits are the same from halves") {
    test::Random random(10);
    for (int i = 0; i < 100000; ++i) {
        const int shift = static_cast<int>(random.index(64));
        const uint64_t a = random.engine() >> shift, b = i % 7 == 0 ? ~uint64_t{0} : random.engine();
        const U128 whole = product(a, b), halves = product_by_halves(a, b);
        REQUIRE((whole.high == halves.high && whole.low == halves.low));
        const Wide wide = Wide::of(a, -64) * Wide::of(b, -64);
        REQUIRE((wide.fraction().high == whole.high && wide.fraction().low == whole.low));
    }
}
