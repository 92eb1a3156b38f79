// Settings of solvers and bodies, checked: as they come in descs, and as they are changed later.
#pragma once

#include "gamephys_c.h"
#include "solver/solver.h"

namespace gphys {

gphys_status read_settings(const gphys_solver_settings& from, SolverSettings& to);
gphys_status read_settings(const gphys_body_settings& from, BodySettings& to);

}  // namespace gphys
