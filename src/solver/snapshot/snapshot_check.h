// Whether what was read from a snapshot can be a solver's state. The hash of a snapshot finds damage;
// these checks keep words that were made up from reaching past an array.
#pragma once

#include "solver/solver.h"

namespace gphys {

constexpr const char* cut_short = "words: no snapshot has these lengths";

/// What is wrong, or nullptr: of everything but the bodies and joints, of joints whose bodies are fine, and
/// of one body.
const char* defect_of_globals(const SolverState& state);
const char* defect_of_joints(const SolverState& state);
const char* defect(const Body& body);

}  // namespace gphys
