// Sheets that are compressed within their plane, as when a banner's bar stops while it rises, or its pins come
// together.
//
// Nothing takes such a sheet out of its plane: all forces are in it. There rigid links hold inverted cells, and the
// energy that these store, for good. A real sheet buckles, because it is never exactly flat. So an exactly flat one is
// displaced across its plane by a small part of its links, once: then it is not flat any more, and buckles.
#pragma once

namespace gphys {

struct Cloth;

/// Call with strained links, of cloth without contacts. `compressed`: the largest shortening of a link, relative to its
/// length.
void leave_plane(Cloth& cloth, double compressed);

}  // namespace gphys
