// Elimination along chains that resist bending.
#pragma once

#include "solver/rope/chain_view.h"

namespace gphys {

class RopeContacts;

/// Solves the equations of an iteration. rows[i].value becomes the solution, as in rope_direct.cpp.
void solve_stiff(const ChainView& view, StiffRow* stiff, DirectRow* rows, RopeContacts* contacts);

}  // namespace gphys
