// Sheets that are compressed within their plane, as when a banner's bar stops while it rises, or its pins come
// together.
//
// Nothing takes such a sheet out of its plane: all forces are in it. There rigid links hold inverted cells, and the
// energy that these store, for good. A real sheet buckles, because it is never exactly flat. So an exactly flat one is
// displaced across its plane, once: into folds across the direction in which it is shortest, as high as its links need,
// and by a small part of a link at random. Then it is not flat any more, and buckles.
#pragma once

namespace gphys {

struct Body;

/// Call with strained links. `strain`: the largest shortening of a link, relative to its length. Particles stay outside
/// the planes of their contacts, so a sheet on the ground rises from it, within the bounds of their targets, and at
/// their joints. Returns the energy that forces have lost by it, per average mass.
double leave_plane(Body& body, double strain, bool collides);
/// Call at the beginning of the first step after particles were placed, before contacts are found: the same if links
/// have wrong lengths, too long or too short, or if the cloth is joined to other bodies, which may pull it together
/// within its plane. Returns whether links have wrong lengths.
bool start_cloth(Body& body);

}  // namespace gphys
