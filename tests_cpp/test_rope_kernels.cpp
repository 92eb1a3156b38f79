// The kernels that gather ropes into lanes, move them and scatter them: the same bits from each instruction set, for
// one rope and for eight, and nothing of a rope that is not wanted.
#include <cstring>
#include <numeric>
#include <vector>

#include "foundation/isa.h"
#include "solver/rope/rope_kernels.h"
#include "solver/time_scheme.h"
#include "test.h"

using namespace gphys;

namespace {

constexpr Isa all_sets[] = {
#define GPHYS_TEST_ISA(set, ...) Isa::set,
    GPHYS_FOR_EACH_ISA(GPHYS_TEST_ISA, )
#undef GPHYS_TEST_ISA
};
constexpr double gravity[3] = {0, -9.81, 0.5};
constexpr uint32_t longest = 9;

/// As a body keeps it, with its particles in any order.
struct Rope {
    explicit Rope(uint32_t which) : damping(0.1 * which), forced(which % 3 == 1) {
        test::Random random(which);
        const uint32_t size = which == 7 ? 2 : longest - which;
        particles.resize(size);
        std::iota(particles.begin(), particles.end(), 0u);
        if (which % 2) std::reverse(particles.begin(), particles.end());
        for (auto* vectors : {&position, &velocity, &start, &start_velocity, &earlier_velocity, &force}) {
            for (uint32_t i = 0; i < 3 * size; ++i) vectors->push_back(random.uniform(-1, 1) * 0.1 * which);
        }
        if (!forced) std::fill(force.begin(), force.end(), 0.0);
        for (uint32_t i = 0; i < size; ++i) {
            double* const at = &position[3 * particles[i]];
            at[0] = 0.1 * i, at[1] = random.uniform(0, 0.02), at[2] = 0;
            for (int k = 0; k < 3; ++k) start[3 * particles[i] + k] = at[k] - 0.001 * which;
            mass.push_back(random.uniform(0.5, 2));
            inverse_mass.push_back(1 / mass.back());
        }
        if (which != 2) inverse_mass[particles[0]] = 0;
        if (which == 4) inverse_mass[particles[1]] = 0;
        for (uint32_t i = 0; i + 1 < size; ++i) {
            target.push_back(0.1);
            compliance.push_back(which == 3 ? 1e-4 : 0);
            tension.push_back(random.uniform(0, 20));
        }
    }

    RopeArrays arrays(bool estimated) {
        return {particles.data(),
                static_cast<uint32_t>(particles.size()),
                position.data(),
                velocity.data(),
                start.data(),
                start_velocity.data(),
                estimated ? earlier_velocity.data() : nullptr,
                force.data(),
                mass.data(),
                inverse_mass.data(),
                target.data(),
                compliance.data(),
                tension.data(),
                forced};
    }
    std::vector<double> state() const {
        std::vector<double> all;
        for (const auto* part : {&position, &velocity, &start, &start_velocity, &earlier_velocity, &tension}) {
            all.insert(all.end(), part->begin(), part->end());
        }
        return all;
    }

    double damping;
    bool forced;
    std::vector<uint32_t> particles;
    std::vector<double> position, velocity, start, start_velocity, earlier_velocity, force;
    std::vector<double> mass, inverse_mass, target, compliance, tension;
};

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), 8 * a.size()) == 0;
}

template <int lanes>
void set_step(RopeScheme<lanes>& to, int lane, const TimeScheme& scheme, double damping) {
    const double step = scheme.step(damping);
    to.h[lane] = scheme.h, to.rate[lane] = 1 / scheme.h;
    to.next[lane] = scheme.next, to.inverse_next[lane] = 1 / scheme.next;
    to.now[lane] = scheme.now, to.earlier[lane] = scheme.earlier;
    to.damping[lane] = damping, to.drag[lane] = scheme.drag(damping);
    to.step_squared[lane] = step * step, to.inverse_step_squared[lane] = 1 / (step * step);
    to.extrapolation[lane] = scheme.earlier * scheme.advance;
}

struct Way {
    bool trapezoid, estimated;
};

/// One part of a substep. Returns their largest frequencies, squared.
template <int lanes>
std::vector<double> move(const RopeKernelsOf<lanes>& kernels, Rope* ropes, const Way& way,
                         const bool (&wanted)[lanes]) {
    static RopeNode<lanes> nodes[longest];
    RopeArrays arrays[lanes];
    RopeScheme<lanes> step;
    RopeBounds<lanes> bounds{};
    uint32_t count = 0;
    for (int lane = 0; lane < lanes; ++lane) {
        constexpr double h = 1.0 / 240;
        arrays[lane] = ropes[lane].arrays(way.estimated);
        count = std::max(count, arrays[lane].count);
        set_step(step, lane, way.trapezoid ? TimeScheme::trapezoid(h) : TimeScheme(h, h), ropes[lane].damping);
    }
    double frequency_squared[lanes];
    kernels.gather(nodes, count, arrays, gravity);
    kernels.find_largest_frequency(nodes, count, frequency_squared);
    kernels.move(nodes, count, step, way.trapezoid, bounds);
    kernels.scatter(nodes, count, arrays, wanted);
    return {frequency_squared, frequency_squared + lanes};
}

std::vector<Rope> eight_ropes() {
    std::vector<Rope> ropes;
    for (uint32_t which = 0; which < 8; ++which) ropes.emplace_back(which);
    return ropes;
}

}  // namespace

TEST_CASE("the kernels of ropes give the same bits on each instruction set, for one rope and for eight") {
    const Way way = {GENERATE(false, true), GENERATE(false, true)};
    CAPTURE(way.trapezoid, way.estimated);
    const std::vector<Rope> before = eight_ropes();
    std::vector<Rope> alone = before;
    std::vector<double> frequency_squared;
    for (Rope& rope : alone) {
        frequency_squared.push_back(move<1>(rope_kernels(base_isa).one, &rope, way, {true})[0]);
        CHECK(!same_bits(rope.state(), before[&rope - alone.data()].state()));
    }
    for (const Isa isa : all_sets) {
        if (!has(isa)) continue;
        CAPTURE(name_of(isa));
        std::vector<Rope> together = before;
        bool wanted[8];
        for (int lane = 0; lane < 8; ++lane) wanted[lane] = true;
        CHECK(same_bits(move<8>(rope_kernels(isa).eight, together.data(), way, wanted), frequency_squared));
        for (uint32_t lane = 0; lane < 8; ++lane) {
            CAPTURE(lane);
            CHECK(same_bits(together[lane].state(), alone[lane].state()));
            Rope one = before[lane];
            CHECK(move<1>(rope_kernels(isa).one, &one, way, {true})[0] == frequency_squared[lane]);
            CHECK(same_bits(one.state(), alone[lane].state()));
        }
    }
}

TEST_CASE("the kernels of ropes leave those alone that are not wanted") {
    const Way way = {true, true};
    const std::vector<Rope> before = eight_ropes();
    for (const Isa isa : all_sets) {
        if (!has(isa)) continue;
        CAPTURE(name_of(isa));
        std::vector<Rope> ropes = before, all = before;
        bool wanted[8], everyone[8];
        for (int lane = 0; lane < 8; ++lane) wanted[lane] = lane % 3 == 1, everyone[lane] = true;
        move<8>(rope_kernels(isa).eight, ropes.data(), way, wanted);
        move<8>(rope_kernels(isa).eight, all.data(), way, everyone);
        for (uint32_t lane = 0; lane < 8; ++lane) {
            CAPTURE(lane);
            CHECK(same_bits(ropes[lane].state(), (wanted[lane] ? all : before)[lane].state()));
        }
    }
}

TEST_CASE("the largest frequency of a rope is that with which its links turn, swing or stretch") {
    Rope rope(0);
    const double turning = 3, rounding = 1e-14;  // a dozen operations, each off by 2^-53 at most
    std::fill(rope.velocity.begin(), rope.velocity.end(), 0.0);
    std::fill(rope.start_velocity.begin(), rope.start_velocity.end(), 0.0);
    std::fill(rope.tension.begin(), rope.tension.end(), 0.0);
    std::fill(rope.mass.begin(), rope.mass.end(), 1.0);
    for (double& inverse : rope.inverse_mass) inverse = inverse > 0 ? 1 : 0;
    const auto frequency_squared = [&] {
        Rope copy = rope;
        return move<1>(rope_kernels(chosen_isa()).one, &copy, {true, false}, {true})[0];
    };
    const double fall = std::sqrt(9.81 * 9.81 + 0.25), resting = 0.25 * fall * 2 / 0.1;
    CHECK(std::fabs(frequency_squared() / (resting)-1) < rounding);
    // As it has since the part before: 6 times the square of what is new counts more than the whole.
    rope.velocity[3 * 8 + 1] = turning * 0.1;
    CHECK(std::fabs(frequency_squared() / (std::max(6 * turning * turning, resting)) - 1) < rounding);
    rope.start_velocity[3 * 8 + 1] = turning * 0.1;
    rope.tension[4] = -100;
    CHECK(std::fabs(frequency_squared() / (0.25 * 100 * 2 / 0.1) - 1) < rounding);
    rope.compliance[2] = 1e-5;
    CHECK(std::fabs(frequency_squared() / (0.25 * 2 / 1e-5) - 1) < rounding);
}
