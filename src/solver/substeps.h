// How many substeps a body takes, by error targets and a bound of work.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;
struct Cloth;
struct SolverSettings;

/// How many substeps it takes.
struct Substeps {
    uint32_t made = 0;     // in the last step
    uint32_t allowed = 0;  // in the step under way, by SolverSettings::max_work
    double wanted = 0;     // seconds, as error targets want the next; 0: not measured yet
};

/// The fewest substeps that a body may take; in how many substeps a body takes a step; at least,
/// beside models, if its fastest particle has that speed; for the rest of it, when a part is done in so many; and what
/// it has measured after it.
uint32_t least_substeps(const Body& body, double dt);
uint32_t substeps_of(const Body& body, const SolverSettings& settings, double dt);
uint32_t substeps_near_models(const Cloth& cloth, const SolverSettings& settings, double fastest, double dt);
uint32_t substeps_of_rest(const Body& body, const SolverSettings& settings, double dt, double done, uint32_t made);
void adapt_substep(Body& body, const SolverSettings& settings, double dt, uint32_t substeps);

}  // namespace gphys
