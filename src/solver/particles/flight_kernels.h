// The flight of many particles at once, eight at a time. Coordinates stay as they lie in memory, x y z of
// one particle after the other: eight particles are three times eight numbers, and what belongs to them
// is laid out in the same way.
#pragma once

#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

constexpr uint8_t several_obstacles = 0xff, no_obstacle = 0xfe;
constexpr uint32_t flight_group = 8, flight_numbers = 3 * flight_group;

/// Some groups of particles during a substep.
struct FlightGroups {
    uint32_t count;
    double *position, *velocity;
    const double* acceleration;  // flight_numbers for each group,
    uint32_t acceleration_step;  // so many numbers apart; 0: the same for all
    double kept, reach, fall;    // as FlightTime has them
};

/// Of all particles of some groups.
struct FlightBounds {
    double low[3], high[3];          // of their positions before and after
    double fastest[3], furthest[3];  // by axis: speeds before, and ways
};

/// A box, low and high corner, eight times.
struct FlightBox {
    double low[flight_numbers], high[flight_numbers];
};
struct FlightObstacle {
    FlightBox all;   // what touches it
    FlightBox rest;  // where what has no speed stays on it; low > high: nowhere
};

struct FlightAnswers {
    /// By group. Bit i is set, beside those that are, if the box around the path of particle i touches an
    /// obstacle: such a group stays where it is.
    uint8_t* overlapping;
    uint8_t* obstacle_of;  // by particle that touches any: the number of the last one, or several_obstacles
    uint8_t* resting_on;   // by group: the obstacle that all of it rests on and touches alone, or no_obstacle
};

struct FlightKernels {
    void (*bound)(const FlightGroups& groups, FlightBounds& out);
    /// Moves the groups of which no particle comes by an obstacle.
    void (*fly)(const FlightGroups& groups, const FlightObstacle* obstacles, uint32_t obstacle_count,
                const FlightAnswers& answers);
};

GPHYS_DECLARE_KERNELS(FlightKernels, flight_kernels)

}  // namespace gphys
