// Sleeping: bodies at rest are not moved until something wakes them.
#pragma once

#include "shapes/shapes.h"

namespace gphys {

class Scene;
struct Body;
struct Constraints;
struct SolverSettings;

/// The state of a body at rest.
struct Sleep {
    double rest_time = 0;  // seconds that it has been at rest
    bool asleep = false;
    Box box;                     // while asleep: models in it may wake it,
    uint64_t neighbourhood = 0;  // and this is a hash of them
};

/// Call after a step has moved the body. Returns whether it has been at rest for long enough.
bool is_at_rest(Body& body, const SolverSettings& settings, double dt);
void fall_asleep(Body& body, const Scene* scene, double dt);
/// The same, and falls asleep; for a single body.
void rest(Body& body, const Scene* scene, const SolverSettings& settings, double dt);
void wake(Body& body);

/// Whether a model that particles are attached to has moved since the last step, or is gone.
bool attachments_moved(const Constraints& constraints, const Scene* scene);

}  // namespace gphys
