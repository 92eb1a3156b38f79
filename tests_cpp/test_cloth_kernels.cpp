// The kernels of cloth: the same bits from each instruction set, and what they promise beside sums in double.
#include "solver/cloth/cloth_kernels.h"

#include <cmath>
#include <cstring>
#include <vector>

#include "foundation/isa.h"
#include "foundation/math.h"
#include "solver/cloth/whole_motion_kernels.h"
#include "test.h"

using namespace gphys;

namespace {

template <class Check>
void on_each_set(Check&& check) {
#define GPHYS_ISA_LISTED(set, ...) Isa::set,
    for (const Isa isa : {GPHYS_FOR_EACH_ISA(GPHYS_ISA_LISTED, )}) {
        if (!has(isa)) continue;
        CAPTURE(name_of(isa));
        check(isa);
    }
#undef GPHYS_ISA_LISTED
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

/// Forty particles, of which some are held, as the kernels take them.
struct Cloth {
    static constexpr uint32_t particles = 40;
    std::vector<float> at, start, moved, velocity, velocity_before, acceleration;

    Cloth() {
        test::Random random(5);
        for (uint32_t i = 0; i < particles; ++i) {
            const bool held = i % 7 == 3;
            const float mass = random.uniform_float(0.5f, 2);
            for (auto* values : {&at, &start, &moved, &velocity, &velocity_before, &acceleration}) {
                const float size = values == &moved ? 0.01f : 1;
                for (int k = 0; k < 3; ++k) values->push_back(size * random.uniform_float(-1, 1));
                values->push_back(0);
            }
            at.back() = held ? 0 : 1 / mass;
            acceleration.back() = held ? 0 : mass;
        }
    }
    ClothMotion motion() {
        return {4 * particles,          at.data(),          start.data(), moved.data(), velocity.data(),
                velocity_before.data(), acceleration.data()};
    }
};

}  // namespace

TEST_CASE("the kernels of cloth give the same bits on each instruction set") {
    constexpr uint32_t particles = 64, links = 7;
    test::Random random(21);
    std::vector<float> at, normals, rest;
    std::vector<uint32_t> order;
    for (uint32_t i = 0; i < particles; ++i) {
        const Vec3 normal = i % 3 == 0 ? random.direction() : Vec3{};
        for (int k = 0; k < 3; ++k) at.push_back(random.uniform_float(-1, 1));
        for (int k = 0; k < 3; ++k) normals.push_back(static_cast<float>(normal[k]));
        at.push_back(i % 7 == 0 ? 0 : random.uniform_float(0.5f, 2));  // some are held
        normals.push_back(i % 6 == 0 ? random.uniform_float(0, 0.1f) : 0);
        order.push_back(i);
    }
    for (uint32_t i = 0; i < 8 * links; ++i) rest.push_back(random.uniform_float(0.1f, 1));
    const std::vector<float> zeros(8 * links, 0.0f);
    std::vector<float> results[2];
    const auto solve = [&](Isa isa, std::vector<float>& result) {
        std::vector<float> moved = at, pulls(at.size(), 0.0f), rows(cloth_row_floats * links);
        const ClothChains chains{order.data(), rest.data(), zeros.data(), zeros.data()};
        const ClothKernels& kernels = cloth_kernels(isa);
        kernels.solve_with_contacts(moved.data(), {normals.data(), pulls.data()}, chains, {0, 0, links}, rows.data());
        result = moved;
        result.insert(result.end(), pulls.begin(), pulls.end());
        kernels.solve(moved.data(), chains, {0, 0, links}, rows.data());
        result.insert(result.end(), moved.begin(), moved.end());
        // Those longer by a tenth, of links that only pull, half of which are soft.
        std::vector<float> softness = zeros;
        for (size_t i = 0; i < softness.size(); i += 2) softness[i] = 1;
        std::vector<uint32_t> strained(rest.size());
        strained.resize(kernels.list_strained(at.data(), {order.data(), rest.data(), softness.data(), nullptr},
                                              {0, 0, links, 1}, 0.1f, strained.data()));
        auto next = strained.begin();
        for (uint32_t i = 1; i < rest.size(); i += 2) {
            const float *a = &at[4 * size_t{i}], *b = &at[4 * size_t{i + 8}];
            const double length = distance(Vec3{a[0], a[1], a[2]}, Vec3{b[0], b[1], b[2]});
            if (length < 1.1 * static_cast<double>(rest[i])) continue;
            REQUIRE(next != strained.end());
            CHECK(*next++ == i);
        }
        CHECK(next == strained.end());
    };
    solve(base_isa, results[0]);
    for (const float value : results[0]) REQUIRE(std::isfinite(value));
    on_each_set([&](Isa isa) {
        solve(isa, results[1]);
        CHECK(same_bits(results[0], results[1]));
    });
}

TEST_CASE("what one chain pushes off a surface the next takes back to it") {
    // Particle 0 lies on a floor at 0.9. A link of 1 m from below, where particle 1 is held at 0, pushes it up; one of
    // 1 m to particle 2, held at -0.1, then takes it back to where that link has its length.
    constexpr float height = 0.9f;
    const std::vector<float> rest(8, 1.0f), zeros(8, 0.0f), soft{0, 1e26f, 1e26f, 1e26f, 1e26f, 1e26f, 1e26f, 1e26f};
    on_each_set([&](Isa isa) {
        std::vector<float> at(20, 0.0f), normals(20, 0.0f), pulls(20, 0.0f), rows(cloth_row_floats);
        at[1] = height, at[3] = 1;
        at[9] = height - 1;
        at[16] = 1;  // 3 and 4 are for lanes without a link
        normals[1] = 1;
        const auto solve_link_to = [&](uint32_t other) {
            uint32_t ends[16];
            std::fill(ends, ends + 8, 3u), std::fill(ends + 8, ends + 16, 4u);
            ends[0] = 0, ends[8] = other;
            cloth_kernels(isa).solve_with_contacts(at.data(), {normals.data(), pulls.data()},
                                                   {ends, rest.data(), soft.data(), zeros.data()}, {0, 0, 1},
                                                   rows.data());
        };
        solve_link_to(1);
        CHECK(at[1] > height + 0.09f);
        solve_link_to(2);
        // But for the regularisation, a millionth of the error, and rounding.
        CHECK(std::fabs(at[1] - height) < 1e-6f);
    });
}

TEST_CASE("the kernels of cloth move particles with the same bits on each instruction set") {
    const ClothStep step{1.0f / 600, 1.0f / 700, 600.0f / 700, 1.46f, 0.4f, 0.3f, 0.68f};
    const float drift[3] = {0.3f, -0.2f, 0.1f};
    std::vector<std::vector<float>> wanted;
    on_each_set([&](Isa isa) {
        const ClothKernels& kernels = cloth_kernels(isa);
        Cloth cloth;
        std::vector<std::vector<float>> got;
        kernels.predict(cloth.motion(), step);
        got.push_back(cloth.at);
        const double gain = kernels.finish(cloth.motion(), step), energy = kernels.kinetic(cloth.motion(), drift);
        got.insert(got.end(), {cloth.moved, cloth.velocity_before});
        kernels.slow(cloth.motion(), drift, 0.9f);
        got.push_back(cloth.velocity);
        got.push_back({static_cast<float>(gain), static_cast<float>(energy)});
        for (const std::vector<float>& values : got) {
            for (const float value : values) REQUIRE(std::isfinite(value));
        }
        if (isa == base_isa) wanted = got;
        for (size_t i = 0; i < got.size(); ++i) CHECK(same_bits(got[i], wanted[i]));
    });
}

TEST_CASE("cloth is slowed beside the motion of the whole, and what is held goes on") {
    const float drift[3] = {0.3f, -0.2f, 0.1f}, kept = 0.75f;
    on_each_set([&](Isa isa) {
        Cloth cloth;
        const std::vector<float> before = cloth.velocity;
        double energy = 0;
        for (uint32_t i = 0; i < 4 * Cloth::particles; ++i) {
            if (i % 4 == 3) continue;
            const double inner = double{before[i]} - double{drift[i % 4]};
            energy += double{cloth.acceleration[i / 4 * 4 + 3]} * inner * inner / 2;
        }
        // A sum of 15 products of floats in each lane, which are off by three roundings each.
        const double rounding = 0x1p-24;
        CHECK(std::fabs(cloth_kernels(isa).kinetic(cloth.motion(), drift) / energy - 1) < (15 + 3) * rounding);
        cloth_kernels(isa).slow(cloth.motion(), drift, kept);
        for (uint32_t i = 0; i < 4 * Cloth::particles; ++i) {
            CAPTURE(i);
            if (i % 4 == 3 || cloth.at[i / 4 * 4 + 3] == 0) {
                CHECK(cloth.velocity[i] == before[i]);
            } else {
                const double d = double{drift[i % 4]}, slower = d + (double{before[i]} - d) * double{kept};
                CHECK(std::fabs(double{cloth.velocity[i]} - slower) <= 3 * rounding);  // three operations below 2
            }
        }
    });
}

TEST_CASE("particles of cloth come no further from their anchors than they may, and those nearer stay") {
    on_each_set([&](Isa isa) {
        Cloth cloth;
        const std::vector<float> before = cloth.at;
        std::vector<uint32_t> particles, anchors;
        std::vector<float> distances;
        for (uint32_t i = 8; i < Cloth::particles; ++i) {
            particles.push_back(i);
            anchors.push_back(i % 3);
            // None of the first sixteen is too far, and one of the last eight.
            distances.push_back(i < 24 || (i >= 32 && i != 36) ? 5 : 0.25f);
        }
        cloth_kernels(isa).limit(cloth.at.data(), {particles.data(), anchors.data(), distances.data()},
                                 static_cast<uint32_t>(particles.size()));
        for (size_t i = 0; i < particles.size(); ++i) {
            CAPTURE(i);
            const float *now = &cloth.at[4 * particles[i]], *then = &before[4 * particles[i]],
                        *anchor = &cloth.at[4 * anchors[i]];
            double square = 0, square_before = 0;
            for (int k = 0; k < 3; ++k) {
                square += std::pow(double{now[k]} - double{anchor[k]}, 2);
                square_before += std::pow(double{then[k]} - double{anchor[k]}, 2);
            }
            if (square_before <= std::pow(double{distances[i]}, 2)) {
                CHECK(std::memcmp(now, then, 16) == 0);
            } else {
                // Coordinates below 1 are off by half an ulp of 2^-24, and so is each of the five operations.
                CHECK(std::fabs(std::sqrt(square) - double{distances[i]}) < 6 * 0x1p-24);
            }
        }
    });
}

TEST_CASE("moments of cloth are sums over its particles, also where the last eight are fewer") {
    for (const uint32_t count : {1u, 7u, 8u, 37u, 40u}) {
        CAPTURE(count);
        Cloth cloth;
        ClothMotion motion = cloth.motion();
        motion.floats = 4 * count;
        ClothMoments<double> sums;
        for (uint32_t i = 0; i < motion.floats; i += 4) {
            const auto of = [i](const std::vector<float>& values) {
                return Vec3{double{values[i]}, double{values[i + 1]}, double{values[i + 2]}};
            };
            const double mass = double{cloth.acceleration[i + 3]};
            const Vec3 start = of(cloth.start), at = of(cloth.at), load = of(cloth.acceleration) * mass;
            const Vec3 earlier = of(cloth.velocity_before), velocity = of(cloth.velocity);
            sums.mass += mass;
            sums.before.add(mass, start, earlier);
            sums.after.add(mass, at, velocity);
            sums.squares += by_component(at, at) * mass;
            sums.products += Vec3{at.y * at.z, at.z * at.x, at.x * at.y} * mass;
            sums.force += load;
            sums.torque += cross(start, load) + cross(at, load);
            sums.energy += length_squared(velocity) * mass;
            sums.gain += (length_squared(velocity) - length_squared(earlier)) * mass / 2 - dot(load, at - start);
        }
        ClothMoments<double> first;
        on_each_set([&](Isa isa) {
            const ClothMoments<double> got = whole_motion_kernels(isa).moments(motion);
            if (isa == base_isa) first = got;
            constexpr size_t numbers = sizeof got / sizeof(double);
            double a[numbers], b[numbers], c[numbers];
            std::memcpy(a, &got, sizeof a), std::memcpy(b, &sums, sizeof b), std::memcpy(c, &first, sizeof c);
            for (size_t i = 0; i < numbers; ++i) {
                CAPTURE(i);
                CHECK(a[i] == c[i]);
                // Sums of 40 terms below 24, in another order.
                CHECK(std::fabs(a[i] - b[i]) <= 40 * 40 * 24 * 0x1p-53);
            }
        });
    }
}

TEST_CASE("what cloth has lost of its momentum is a sum over its particles, the same on each instruction set") {
    for (const uint32_t count : {1u, 7u, 8u, 37u, 40u}) {
        CAPTURE(count);
        Cloth cloth;
        ClothMotion motion = cloth.motion();
        motion.floats = 4 * count;
        const double damping = 2, h = 0.125;
        Momentum sum{};
        for (uint32_t i = 0; i < motion.floats; i += 4) {
            const auto of = [i](const std::vector<float>& values) {
                return Vec3{double{values[i]}, double{values[i + 1]}, double{values[i + 2]}};
            };
            const double mass = double{cloth.acceleration[i + 3]};
            const Vec3 start = of(cloth.start), at = of(cloth.at), load = of(cloth.acceleration) * mass;
            const Vec3 earlier = of(cloth.velocity_before) * mass, now = of(cloth.velocity) * mass * (1 + damping * h);
            sum.linear += earlier + load * h - now;
            sum.angular += cross(start, earlier) + cross(start + at, load) * (h / 2) - cross(at, now);
        }
        Momentum first{};
        on_each_set([&](Isa isa) {
            const Momentum got = whole_motion_kernels(isa).lost(motion, damping, h);
            if (isa == base_isa) first = got;
            CHECK((got.linear == first.linear && got.angular == first.angular));
            // 40 terms below 24 with some ten roundings to float.
            CHECK(max_component(abs(got.linear - sum.linear)) <= 40 * 10 * 24 * 0x1p-24);
            CHECK(max_component(abs(got.angular - sum.angular)) <= 40 * 10 * 24 * 0x1p-24);
        });
    }
}

TEST_CASE("a rigid motion is added to the velocities of cloth, and to no others") {
    const uint32_t count = 37;
    const double kept = 0.75;
    const Vec3 along{0.3, -0.2, 0.1}, turning{-1.5, 0.5, 2};
    on_each_set([&](Isa isa) {
        Cloth cloth;
        const std::vector<float> before = cloth.velocity;
        ClothMotion motion = cloth.motion();
        motion.floats = 4 * count;
        whole_motion_kernels(isa).move(motion, kept, along, turning);
        for (uint32_t i = 0; i < 4 * Cloth::particles; i += 4) {
            CAPTURE(i);
            const Vec3 at{double{cloth.at[i]}, double{cloth.at[i + 1]}, double{cloth.at[i + 2]}};
            const Vec3 added = along + cross(turning, at);
            for (int k = 0; k < 4; ++k) {
                const double old = double{before[i + static_cast<uint32_t>(k)]};
                const bool moves = i < 4 * count && k < 3;
                const double wanted = moves ? old * kept + added[k] : old;
                // Rounded to a float; in double, sums below 8 with four roundings before.
                const double rounding = moves ? 0x1p-24 * std::fabs(wanted) + 4 * 8 * 0x1p-53 : 0;
                CHECK(std::fabs(double{cloth.velocity[i + static_cast<uint32_t>(k)]} - wanted) <= rounding);
            }
        }
    });
}

TEST_CASE("free particles that may leave their balls are listed, and those that have left them") {
    constexpr float h = 0.125f, fall = 0.25f;
    Cloth cloth;
    test::Random random(8);
    std::vector<float> balls;
    for (const float at : cloth.at) balls.push_back(at + random.uniform_float(-0.2f, 0.2f));
    for (size_t i = 3; i < balls.size(); i += 4) balls[i] = random.uniform_float(0, 0.2f);
    for (const uint32_t count : {1u, 7u, 8u, 9u, 23u, Cloth::particles}) {
        std::vector<uint32_t> leaving, outside;
        for (uint32_t p = 0; p < count; ++p) {
            const auto vector = [&](const std::vector<float>& of) {
                return Vec3{double{of[4 * p]}, double{of[4 * p + 1]}, double{of[4 * p + 2]}};
            };
            const double off = length(vector(cloth.at) - vector(balls)), radius = std::sqrt(double{balls[4 * p + 3]});
            const double travel = double{h} * (length(vector(cloth.velocity)) + double{fall});
            // Not near enough to be decided by rounding.
            REQUIRE(std::fabs(off - radius) > 1e-6);
            REQUIRE(std::fabs(off + travel - radius) > 1e-6);
            if (cloth.at[4 * p + 3] == 0) continue;
            if (off + travel > radius) leaving.push_back(p);
            if (off > radius) outside.push_back(p);
        }
        on_each_set([&](Isa isa) {
            CAPTURE(count);
            std::vector<uint32_t> listed(count);
            const ClothKernels& kernels = cloth_kernels(isa);
            listed.resize(kernels.list_leaving(cloth.at.data(), cloth.velocity.data(), balls.data(), count, h, fall,
                                               listed.data()));
            CHECK(listed == leaving);
            listed.assign(count, 0);
            listed.resize(kernels.list_outside(cloth.at.data(), balls.data(), count, listed.data()));
            CHECK(listed == outside);
        });
    }
}
