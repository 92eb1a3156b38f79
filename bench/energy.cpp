// Energy over a million steps: gamephys_bench_energy FILE. A mass on a spring, one radian of its oscillation about ten
// steps long, and a pendulum of a rigid link, each moved by the book's integrators and by gamephys, in float32. A row
// is a case, a method, a number of steps, and the largest change of the energy so far, as a part of its first
// value. Nothing is timed: the file is the same on every machine.
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include "gamephys_c.h"
#include "integrators.h"

namespace {

constexpr float h = 1.0f / 60;
constexpr double rate = 6, length = 1, gravity = 9.81;
constexpr int steps = 1000000;

void fail(const char* what) {
    std::fprintf(stderr, "%s: %s\n", what, gphys_last_error());
    std::exit(1);
}
void check(gphys_status status) {
    if (status != GPHYS_OK) fail(gphys_status_name(status));
}

/// Writes the largest change of the energy so far, ten times a decade of steps.
void follow(std::FILE* file, const char* what, const char* method, double first, const std::function<double()>& step) {
    double largest = 0, next = 1;
    for (int n = 1; n <= steps; ++n) {
        const double change = std::fabs(step() / first - 1);
        largest = std::isfinite(change) ? std::fmax(largest, change) : HUGE_VAL;
        if (n >= next || n == steps) {
            std::fprintf(file, "%s,%s,%d,%.6g\n", what, method, n, largest);
            if (largest > 1e6) return;  // there is nothing more to be seen
            next *= 1.2589254;
        }
    }
}

double of_spring(double x, double v) { return (v * v + rate * rate * x * x) / 2; }
double of_pendulum(double y, double speed_squared) { return speed_squared / 2 + gravity * (y + length); }

void springs(std::FILE* file) {
    using namespace bench::book;
    const auto pull = [](float x) { return static_cast<float>(-rate * rate) * x; };
    const double first = of_spring(1, 0);
    Moving<float> p{1, 0};
    follow(file, "spring", "explicit_euler", first, [&] {
        explicit_euler(p, h, pull);
        return of_spring(p.position, p.velocity);
    });
    p = {1, 0};
    follow(file, "spring", "semi_implicit_euler", first, [&] {
        semi_implicit_euler(p, h, pull);
        return of_spring(p.position, p.velocity);
    });
    // The velocity in the middle of three positions; it begins at rest.
    Verlet<float> q{1, static_cast<float>(1 - rate * rate * h * h / 2)};
    follow(file, "spring", "verlet", first, [&] {
        const float before = q.old_position, now = q.position;
        verlet(q, h, pull);
        return of_spring(now, (q.position - before) / (2 * h));
    });
}

/// A particle that hangs from another, which is pinned; compliance 0: rigid.
gphys_body_id hung(gphys_solver* solver, gphys_vec3 at, float rest, float compliance) {
    const gphys_vec3 places[2] = {{0, 0, 0}, at};
    gphys_body_desc desc;
    gphys_body_id body;
    gphys_constraint_id link;
    check(gphys_body_desc_init(&desc, sizeof desc));
    desc.mass = 2;  // one kilogram each
    check(gphys_solver_add_particles(solver, &desc, places, sizeof places[0], 2, &body));
    check(gphys_solver_set_pinned(solver, body, 0, 1, 1));
    check(gphys_solver_add_distance(solver, body, 0, 1, rest, compliance, &link));
    return body;
}

void with_gamephys(std::FILE* file, uint32_t substeps, bool spring) {
    gphys_solver_desc desc;
    gphys_solver* solver;
    check(gphys_solver_desc_init(&desc, sizeof desc));
    desc.substeps = substeps;
    desc.gravity = {0, spring ? 0 : static_cast<float>(-gravity), 0};
    check(gphys_solver_create(&desc, &solver));
    // The spring is 10 m long and stretched by one, so that it stays on its line.
    const gphys_body_id body = spring ? hung(solver, {11, 0, 0}, 10, static_cast<float>(1 / (rate * rate)))
                                      : hung(solver, {static_cast<float>(length), 0, 0}, static_cast<float>(length), 0);
    const std::string method = "gamephys_" + std::to_string(substeps);
    const double first = spring ? of_spring(1, 0) : of_pendulum(0, 0);
    follow(file, spring ? "spring" : "pendulum", method.c_str(), first, [&] {
        gphys_vec3 p, v;
        check(gphys_solver_step(solver, nullptr, h));
        check(gphys_solver_get_positions(solver, body, 1, 1, &p, sizeof p));
        check(gphys_solver_get_velocities(solver, body, 1, 1, &v, sizeof v));
        if (spring) return of_spring(p.x - 10, v.x);
        return of_pendulum(p.y, double(v.x) * v.x + double(v.y) * v.y + double(v.z) * v.z);
    });
    gphys_solver_destroy(solver);
}

/// The book's rope of one link: Verlet, then the particle is put back to the length of the link.
void pendulum_of_the_book(std::FILE* file) {
    using namespace bench::book;
    Verlet<float> x{1, 1}, y{0, 0};
    follow(file, "pendulum", "verlet", of_pendulum(0, 0), [&] {
        const float bx = x.old_position, by = y.old_position, ny = y.position;
        verlet(x, h, [](float) { return 0.0f; });
        verlet(y, h, [](float) { return static_cast<float>(-gravity); });
        const float far = std::sqrt(x.position * x.position + y.position * y.position);
        x.position /= far;
        y.position /= far;
        const double vx = (x.position - bx) / (2 * h), vy = (y.position - by) / (2 * h);
        return of_pendulum(ny, vx * vx + vy * vy);
    });
}

}  // namespace

int main(int argc, char** argv) {
    std::FILE* file = argc == 2 ? std::fopen(argv[1], "w") : nullptr;
    if (!file) {
        std::fprintf(stderr, "usage: gamephys_bench_energy FILE\n");
        return 2;
    }
    std::fprintf(file, "case,method,steps,change\n");
    springs(file);
    pendulum_of_the_book(file);
    for (const uint32_t substeps : {1u, 8u}) {
        with_gamephys(file, substeps, true);
        with_gamephys(file, substeps, false);
    }
    return std::fclose(file) == 0 ? 0 : 1;
}
