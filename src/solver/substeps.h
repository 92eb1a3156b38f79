// The number of substeps of a body, by error targets and a bound of work.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;
struct Cloth;
struct SolverSettings;

/// The substeps of a body.
struct Substeps {
    uint32_t made = 0;     // in the last step
    uint32_t allowed = 0;  // in the step under way, by SolverSettings::max_work
    double wanted = 0;     // seconds of the next substep, by error targets; 0: not measured yet
};

/// least_substeps: the fewest allowed. substeps_of: the number for a step. substeps_near_models: the least near models,
/// for the speed of its fastest particle. substeps_of_rest: the number for the rest of a step, of which a part is done.
/// adapt_substep: measures the error of a finished step.
uint32_t least_substeps(const Body& body, double dt);
uint32_t substeps_of(const Body& body, const SolverSettings& settings, double dt);
uint32_t substeps_near_models(const Cloth& cloth, const SolverSettings& settings, double fastest, double dt);
uint32_t substeps_of_rest(const Body& body, const SolverSettings& settings, double dt, double done, uint32_t made);
void adapt_substep(Body& body, const SolverSettings& settings, double dt, uint32_t substeps);

}  // namespace gphys
