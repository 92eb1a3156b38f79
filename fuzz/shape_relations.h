// What holds between answers about shapes: which are exact, how large a band of others is, and what a question gives
// when everything in it is moved, turned or scaled in a way that rounds nothing.
#pragma once

#include "program.h"

namespace fuzz {

/// Shapes whose overlaps with one another the header calls exact.
bool is_exact(gphys_shape_type type);
/// Shapes that rays and segments meet without a false answer.
bool has_exact_rays(gphys_shape_type type);

/// Both are valid.
bool overlap(const AnyShape& a, const AnyShape& b);

/// Whether the float sum is the exact one (the error term of Knuth 1969).
bool adds_exactly(float a, float b);

/// An upper bound of the largest coordinate difference of a shape and a point.
double extent(const AnyShape& shape, const gphys_vec3& point);
/// An upper bound of the largest coordinate.
double reach(const AnyShape& shape, const gphys_vec3& point);

/// Whether the answer of a pair is the same if its round shapes and turned boxes are larger or smaller by more than
/// the bound of the pair's error: then it has to be right.
bool is_clear(const AnyShape& a, const AnyShape& b);

/// The same pair, or ray, elsewhere, turned by permuting the axes, or scaled by a power of two: where that rounds
/// nothing, the answer is the same. hit: nullptr for a miss.
void check_moved_overlap(Program& p, const AnyShape& a, const AnyShape& b, bool overlaps);
void check_moved_ray(Program& p, const AnyShape& shape, const gphys_ray& ray, const gphys_hit* hit);

}  // namespace fuzz
