// Models that jump from one step to the next, as characters that respawn and levels that are loaded again do. A jump is
// not a motion: nothing is swept along the way, and nothing gets its speed.
#pragma once

#include <optional>

#include "solver/contact/collision.h"

namespace gphys {

/// m/s. The broad phase finds a model up to this fast before it hits a particle at rest, so that the model is swept
/// along its path. A faster one only hits what is where it arrives. A larger value makes a step track more models
/// around each body.
constexpr double fastest_model = 50;

/// The model's entry in a sorted list; null if there is none.
const PlacedModel* find_placed(const Vector<PlacedModel>& models, gphys_model_id model);

/// Whether a model has changed its place by a jump, in `time` seconds: its velocity changed by more than fastest_model
/// to more than that, it turned by a right angle or more, or it grew as fast.
bool has_jumped(const Scene& scene, const PlacedModel& before, double time);

/// The rigid motion by which to move a whole body, because the model that it is attached to has jumped. None if other
/// particles are pinned or attached elsewhere, so that they would not end where they belong.
std::optional<RigidMotion> motion_of_jump(const Body& body, const Scene& scene, const Vector<PlacedModel>& before,
                                          double time);

/// Velocities turn with the body. Animation targets take effect at once: the caller has set them at the new place.
void move_rigidly(Body& body, const RigidMotion& motion);

}  // namespace gphys
