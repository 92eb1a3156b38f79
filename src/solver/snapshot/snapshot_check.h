// Validation of a state read from a snapshot. The hash of a snapshot detects damage; these checks detect forged words.
// Every index must lie within its array, every number in the range that the library keeps it in. An order that could be
// any (the chains of cloth) must be a permutation of all constraints.
#pragma once

#include "solver/solver.h"

namespace gphys {

constexpr const char* cut_short = "words: the lengths in it do not add up to count";

/// Each returns what is wrong, or nullptr. They check everything but the bodies and joints; joints, once the bodies are
/// valid; one body without its plan; and its plan, once the rest has been completed. May throw std::bad_alloc.
const char* defect_of_globals(const SolverState& state);
const char* defect_of_joints(const SolverState& state);
const char* defect(const Body& body);
const char* defect_of_plan(const Body& body);
/// The animation targets of a body that has some.
const char* defect_of_targets(const Body& body);
/// The same for friction factors.
const char* defect_of_friction_factors(const Body& body);
/// The same of clusters.
const char* defect_of_clusters(const Body& body);
/// The same of breaking forces.
const char* defect_of_breaking_forces(const Body& body);
const char* defect_of_bending(const Body& body);

}  // namespace gphys
