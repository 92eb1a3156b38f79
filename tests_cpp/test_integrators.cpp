// The book's integrators, which the benchmarks compare the solver with, beside the closed forms of their recurrences.
#include "../bench/integrators.h"

#include <cmath>

#include "test.h"

using namespace bench::book;

namespace {

constexpr double h = 1.0 / 60, g = -9.81;
double fall(double) { return g; }

// A spring of one radian a second times `rate`.
struct Spring {
    double rate;
    double operator()(double x) const { return -rate * rate * x; }
};

// Sums of a few hundred terms of size 10, each rounded to 2^-53 of itself.
constexpr double rounding = 1e-11;

}  // namespace

TEST_CASE("the book's integrators fall as their recurrences do: by n (n - 1) / 2 or n (n + 1) / 2 times g h h") {
    Moving<double> explicitly{0, 0}, half{0, 0};
    Verlet<double> verlet_position{0, 0};
    for (int n = 1; n <= 600; ++n) {
        explicit_euler(explicitly, h, fall);
        semi_implicit_euler(half, h, fall);
        verlet(verlet_position, h, fall);
        CHECK(std::fabs(explicitly.position - g * h * h * n * (n - 1) / 2) < rounding * n);
        CHECK(std::fabs(half.position - g * h * h * n * (n + 1) / 2) < rounding * n);
        CHECK(std::fabs(verlet_position.position - g * h * h * n * (n + 1) / 2) < rounding * n);
    }
    // All three are off the parabola by half a step's fall for each step; gamephys is not.
    CHECK(std::fabs(half.position - g * 10 * 10 / 2) > 0.8);
}

TEST_CASE("explicit Euler on a spring multiplies the energy by 1 + (w h)^2 in each step") {
    const Spring spring{6};
    Moving<double> p{1, 0};
    double expected = 18;  // w^2 x^2 / 2
    for (int n = 1; n <= 600; ++n) {
        explicit_euler(p, h, spring);
        expected *= 1 + 36 * h * h;
        const double energy = (p.velocity * p.velocity + 36 * p.position * p.position) / 2;
        CHECK(std::fabs(energy / expected - 1) < 1e-12);  // 600 products of numbers rounded to 2^-53
    }
    CHECK(expected > 18 * 300);
}

TEST_CASE("semi-implicit Euler on a spring keeps v v + w w x x - h w w x v, whatever the number of steps") {
    const Spring spring{6};
    Moving<double> p{1, 0};
    for (int n = 1; n <= 100000; ++n) semi_implicit_euler(p, h, spring);
    const double kept = p.velocity * p.velocity + 36 * p.position * p.position - h * 36 * p.position * p.velocity;
    CHECK(std::fabs(kept - 36) < 36e-11);  // 1e5 roundings of 2^-53, all of one sign
}

TEST_CASE("Verlet on a spring is a cosine of the angle whose half has the sine w h / 2") {
    const Spring spring{6};
    const double angle = 2 * std::asin(6 * h / 2);
    Verlet<double> p{1, std::cos(-angle)};
    for (int n = 1; n <= 10000; ++n) {
        verlet(p, h, spring);
        CHECK(std::fabs(p.position - std::cos(n * angle)) < 1e-11 * n);  // roundings add up as n^2 at most: 2^-53 n^2
    }
    // Stable up to w h = 2, and no further.
    const Spring stiff{2.01 / h};
    Verlet<double> q{1, 1};
    for (int n = 0; n < 300; ++n) verlet(q, h, stiff);
    CHECK(std::fabs(q.position) > 1e6);
}
