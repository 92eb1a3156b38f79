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
    double settling = 0;         // seconds that cloth has been settling (cloth/settling.h); if any,
    Vec3 drift;                  // m/s: its velocity, averaged over some time; and a
    uint64_t support = 0;        // hash of the models that it may lie on
};

/// Call after a step has moved the body. Returns whether it has been at rest for long enough.
bool is_at_rest(Body& body, const SolverSettings& settings, double dt);
void fall_asleep(Body& body, const Scene* scene, double dt);
/// The same, and falls asleep; for a single body.
void rest(Body& body, const Scene* scene, const SolverSettings& settings, double dt);
void wake(Body& body);
/// Of rigid constraints only: elastic ones may be at rest at any length, and so may yielding braces of cloth. Their
/// strain is at most `strain`, or what relax_links leaves.
bool is_hardly_strained(const Body& body, double strain);

/// Whether a model that particles are attached to has moved since the last step, or is gone.
bool attachments_moved(const Constraints& constraints, const Scene* scene);

}  // namespace gphys
