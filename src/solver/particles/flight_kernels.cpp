// Kernels of free flight (flight_kernels.h): bounds of the paths of many particles, and their motion if no path comes
// near an obstacle. The scalar form is `Flight` (flight.h).
#include "solver/particles/flight_kernels.h"

#include "foundation/compiler.h"
#include "foundation/simd_double.h"

namespace gphys::GPHYS_ISA {
namespace {

constexpr uint32_t parts = flight_numbers / 8;

struct Flying {
    Double8 from, to, velocity_before, velocity;
};

struct Factors {
    Double8 kept, reach, fall;

    explicit Factors(const FlightGroups& groups)
        : kept(all_of<8>(groups.kept)), reach(all_of<8>(groups.reach)), fall(all_of<8>(groups.fall)) {}
};

/// The formulas of Flight, in the same order, so that a single particle gets the same bits.
GPHYS_INLINE Flying flown(const FlightGroups& groups, const Factors& factors, uint32_t group, uint32_t part) {
    const size_t at = size_t{group} * flight_numbers + 8 * part;
    const Double8 acceleration =
        load_doubles(groups.acceleration + size_t{group} * groups.acceleration_step + 8 * part);
    const Double8 from = load_doubles(groups.position + at), velocity = load_doubles(groups.velocity + at);
    return {from, from + (velocity * factors.reach + acceleration * factors.fall), velocity,
            velocity * factors.kept + acceleration * factors.reach};
}

/// Notes the obstacle for the particles whose paths overlap it; `before`: those that overlap earlier ones.
void note(uint32_t overlapping, uint32_t before, uint32_t obstacle, uint8_t* obstacle_of) {
    for (uint32_t i = 0; i < flight_group; ++i) {
        if (overlapping >> i & 1) obstacle_of[i] = before >> i & 1 ? several_obstacles : static_cast<uint8_t>(obstacle);
    }
}

/// From one bit for each of 3 x 8 coordinates to one bit for each of 8 particles: set if all three coordinates are.
uint32_t of_particles(uint32_t coordinates) {
    const uint32_t all = coordinates & coordinates >> 1 & coordinates >> 2;
    uint32_t result = 0;
    for (uint32_t i = 0; i < flight_group; ++i) result |= (all >> 3 * i & 1) << i;
    return result;
}

void bound(const FlightGroups& groups, FlightBounds& out) {
    const Factors factors(groups);
    constexpr double beyond = 1e300;
    Double8 low[parts], high[parts], fastest[parts], furthest[parts];
    for (uint32_t part = 0; part < parts; ++part) {
        low[part] = all_of<8>(beyond), high[part] = all_of<8>(-beyond);
        fastest[part] = furthest[part] = all_of<8>(0);
    }
    for (uint32_t group = 0; group < groups.count; ++group) {
        for (uint32_t part = 0; part < parts; ++part) {
            const Flying flying = flown(groups, factors, group, part);
            const Double8 way = flying.to - flying.from;
            low[part] = least(low[part], least(flying.from, flying.to));
            high[part] = largest(high[part], largest(flying.from, flying.to));
            fastest[part] = largest(fastest[part], largest(flying.velocity_before, -flying.velocity_before));
            furthest[part] = largest(furthest[part], largest(way, -way));
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        out.low[axis] = beyond, out.high[axis] = -beyond;
        out.fastest[axis] = out.furthest[axis] = 0;
    }
    for (uint32_t part = 0; part < parts; ++part) {
        double values[4][8];
        store(values[0], low[part]), store(values[1], high[part]);
        store(values[2], fastest[part]), store(values[3], furthest[part]);
        for (uint32_t lane = 0; lane < 8; ++lane) {
            const uint32_t axis = (8 * part + lane) % 3;
            out.low[axis] = least(out.low[axis], values[0][lane]);
            out.high[axis] = largest(out.high[axis], values[1][lane]);
            out.fastest[axis] = largest(out.fastest[axis], values[2][lane]);
            out.furthest[axis] = largest(out.furthest[axis], values[3][lane]);
        }
    }
}

/// One bit for each of 3 x 8 coordinates: whether the intervals of the two boxes overlap.
uint32_t common(const Double8 (&low)[parts], const Double8 (&high)[parts], const FlightBox& box) {
    uint32_t coordinates = 0;
    for (uint32_t part = 0; part < parts; ++part) {
        const uint32_t axis = 8 * part % 3;
        const Double8 box_low = load_doubles(box.low + axis), box_high = load_doubles(box.high + axis);
        coordinates |= bits((low[part] <= box_high) & (box_low <= high[part])) << 8 * part;
    }
    return coordinates;
}

bool rests(const Flying (&flying)[parts], const FlightBox& rest) {
    constexpr uint32_t all = (1u << flight_numbers) - 1;
    const Double8 zero = all_of<8>(0);
    Double8 at[parts];
    for (uint32_t part = 0; part < parts; ++part) {
        const Double8 v = flying[part].velocity_before;
        if (bits((v <= zero) & (zero <= v)) != 0xff) return false;
        at[part] = flying[part].from;
    }
    return common(at, at, rest) == all;
}

void fly(const FlightGroups& groups, const FlightObstacle* obstacles, uint32_t obstacle_count,
         const FlightAnswers& answers) {
    const Factors factors(groups);
    for (uint32_t group = 0; group < groups.count; ++group) {
        Flying flying[parts];
        Double8 low[parts], high[parts];
        for (uint32_t part = 0; part < parts; ++part) {
            flying[part] = flown(groups, factors, group, part);
            low[part] = least(flying[part].from, flying[part].to);
            high[part] = largest(flying[part].from, flying[part].to);
        }
        uint32_t overlapping = answers.overlapping[group], overlapped_count = overlapping == 0 ? 0 : 2, last = 0;
        for (uint32_t i = 0; i < obstacle_count; ++i) {
            const uint32_t coordinates = common(low, high, obstacles[i].all);
            const uint32_t by_this = coordinates == 0 ? 0 : of_particles(coordinates);
            if (by_this == 0) continue;
            note(by_this, overlapping, i, answers.obstacle_of + size_t{group} * flight_group);
            overlapping |= by_this;
            last = i;
            ++overlapped_count;
        }
        answers.overlapping[group] = static_cast<uint8_t>(overlapping);
        const bool alone = overlapped_count == 1 && overlapping == 0xff;
        answers.resting_on[group] =
            alone && rests(flying, obstacles[last].rest) ? static_cast<uint8_t>(last) : no_obstacle;
        if (overlapping != 0) continue;
        for (uint32_t part = 0; part < parts; ++part) {
            const size_t at = size_t{group} * flight_numbers + 8 * part;
            store_doubles(groups.position + at, flying[part].to);
            store_doubles(groups.velocity + at, flying[part].velocity);
        }
    }
}

}  // namespace

const FlightKernels flight_kernels{bound, fly};

}  // namespace gphys::GPHYS_ISA
