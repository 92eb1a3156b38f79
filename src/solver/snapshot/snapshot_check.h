// Whether what was read from a snapshot can be a solver's state. The hash of a snapshot finds damage; these checks
// are for words that were made up. Every index must lie within its array, every number in the range that the
// library keeps it in; an order that could be any (the chains of cloth) must be one of all constraints.
#pragma once

#include "solver/solver.h"

namespace gphys {

constexpr const char* cut_short = "words: no snapshot has these lengths";

/// What is wrong, or nullptr: of everything but the bodies and joints, of joints whose bodies are fine, and
/// of one body: without its plan, and its plan once the rest has been completed. May throw std::bad_alloc.
const char* defect_of_globals(const SolverState& state);
const char* defect_of_joints(const SolverState& state);
const char* defect(const Body& body);
const char* defect_of_plan(const Body& body);
/// Of its animation targets, of which there are some.
const char* defect_of_targets(const Body& body);

}  // namespace gphys
