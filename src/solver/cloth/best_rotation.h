// The rotation that brings one set of points nearest to another.
#pragma once

#include "foundation/math.h"

namespace gphys {

/// The rotation R for which the sum of m |p - R q|^2 is least, for the sum of m p q^T. If several are equally good, as
/// for points on a line, one of them.
Mat3 best_rotation(const Mat3& covariance);

}  // namespace gphys
