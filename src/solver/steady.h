// Steady bodies: a step has left the whole state of the body as it was, bit by bit. The next step with the same input
// would do the same, so it is left out. Results do not depend on this, but bodies that lie still cost next to nothing.
#pragma once

#include "shapes/shapes.h"

namespace gphys {

class Scene;
struct Body;
struct SolverSettings;

/// Not in snapshots: a restored body is moved until it is found to be steady again.
struct Steady {
    bool found = false;
    double step_time = 0;       // seconds: the last step,
    uint32_t substeps = 0;      // and the solver's setting in it
    uint64_t place = 0;         // after the last step: hash of the positions, or 0 if some particle moves;
    uint64_t state = 0;         // hash of the whole state, or 0 if it is not known;
    uint64_t surroundings = 0;  // and hash of the models near the body
    uint32_t pause = 0;         // steps without a comparison since the last one that failed,
    uint32_t left_out = 0;      // and those of them that are still to come
    Box search_box;             // where models may influence the body in a step
};

/// Call after a step of a body that was moved alone. Costs a test of the velocities. While these are almost 0 and steps
/// are equally long, a comparison of the state is made, which may take as long as the step of a free particle at rest;
/// after one that fails the next is made 1, 3, 7, 15 and then every 31 steps later.
void note_steadiness(Body& body, const Scene* scene, const SolverSettings& settings, double dt);

/// Hash of all that a snapshot holds of the body. Defined in snapshot.cpp.
uint64_t hash_of_state(const Body& body);

}  // namespace gphys
