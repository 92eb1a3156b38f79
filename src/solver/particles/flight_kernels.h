// The flight of many particles, eight at a time. Coordinates stay in memory as they are, x y z of one particle after
// the other. So eight particles are three times eight numbers, and accelerations have the same layout.
#pragma once

#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

constexpr uint8_t several_obstacles = 0xff, no_obstacle = 0xfe;
constexpr uint32_t flight_group = 8, flight_numbers = 3 * flight_group;

/// Some groups of eight particles during a substep.
struct FlightGroups {
    uint32_t count;
    double *position, *velocity;
    const double* acceleration;  // flight_numbers for each group,
    uint32_t acceleration_step;  // this many numbers apart; 0: the same for all groups
    double kept, reach, fall;    // see FlightTime
};

/// Bounds of all particles of some groups.
struct FlightBounds {
    double low[3], high[3];          // of the positions before and after
    double fastest[3], furthest[3];  // by axis: speeds before, and displacements
};

/// A box, low and high corner: x y z x y z x y z x, so that the eight numbers for a part of eight particles are
/// adjacent, whichever coordinate the part begins with.
struct FlightBox {
    static constexpr uint32_t size = 10;
    double low[size], high[size];
};
struct FlightObstacle {
    FlightBox all;   // particles whose path overlaps it may hit the obstacle
    FlightBox rest;  // a particle at rest in it stays at rest on the obstacle; low > high: empty
};

struct FlightAnswers {
    /// By group. Input: bits of particles to skip. Output: bit i is added if the box around the path of particle i
    /// overlaps an obstacle. A group with any bit set is not moved.
    uint8_t* overlapping;
    uint8_t* obstacle_of;  // by particle that overlaps any: the index of the last one, or several_obstacles
    uint8_t* resting_on;   // by group: the only obstacle that it overlaps, if all of it rests on it, or no_obstacle
};

struct FlightKernels {
    void (*bound)(const FlightGroups& groups, FlightBounds& out);
    /// Moves the groups in which no path overlaps an obstacle.
    void (*fly)(const FlightGroups& groups, const FlightObstacle* obstacles, uint32_t obstacle_count,
                const FlightAnswers& answers);
};

GPHYS_DECLARE_KERNELS(FlightKernels, flight_kernels)

}  // namespace gphys
