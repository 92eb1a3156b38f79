// Bodies at rest, which are not moved until something wakes them.
#pragma once

#include "shapes/shapes.h"

namespace gphys {

/// Of a body at rest.
struct Sleep {
    double calm = 0;  // seconds that it has been at rest
    bool asleep = false;
    Box box;                     // if asleep: what lies in it may wake it,
    uint64_t neighbourhood = 0;  // and this is a hash of that
};

}  // namespace gphys
