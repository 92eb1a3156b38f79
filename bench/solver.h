// What the suite `solver` moves, and who moves it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gamephys_c.h"
#include "measure.h"
#include "spread.h"

namespace bench {

struct Link {
    uint32_t a, b;
    double rest, compliance;  // metres, m/N
};

/// Particles under gravity, joined by links. Those of mass 0 are pinned.
struct System {
    std::vector<gphys_vec3> positions;
    std::vector<float> masses;
    std::vector<Link> links;
    float damping = 0;       // rate in 1/s
    uint32_t body_size = 0;  // particles of each body
    uint32_t columns = 0;    // of a square sheet, which is one body; 0: ropes
    bool bend = false;       // whether the sheet has links that resist folding
    double post = 0;         // how far particles stay from the z axis: a fixed round post, and their own radius
};

constexpr double gravity = 9.81;

/// A way to move a system.
class Method {
public:
    virtual ~Method() = default;
    virtual void step(float seconds) = 0;  // one frame
    virtual std::vector<gphys_vec3> positions() const = 0;
    virtual std::vector<gphys_vec3> velocities() const = 0;
};

// `effort` is substeps per frame, or iterations where a frame is one step.
std::unique_ptr<Method> make_gamephys_solver(const System& system, uint32_t substeps);
/// Jakobsen 2001: Verlet's scheme on positions, one step a frame, projections of one link after the other.
std::unique_ptr<Method> make_jakobsen(const System& system, uint32_t iterations);
/// Macklin et al. 2016 and 2019: a single projection of each link per substep.
std::unique_ptr<Method> make_xpbd(const System& system, uint32_t substeps);
/// Springs as stiff as the substeps allow. Positions move by the old velocities, or by the new ones.
std::unique_ptr<Method> make_explicit_euler(const System& system, uint32_t substeps);
std::unique_ptr<Method> make_semi_implicit_euler(const System& system, uint32_t substeps);
#ifdef GAMEPHYS_BENCH_PEERS
std::unique_ptr<Method> make_bullet_soft(const System& system, uint32_t iterations);
#endif

// Bodies among models.

/// Boxes on the ground y = 0, and particles above them in clouds of a thousand, as an emitter makes them, each cloud
/// a body.
struct Rain {
    std::vector<gphys_aabb> boxes;
    std::vector<gphys_vec3> particles;
};
constexpr uint32_t cloud_size = 1000;
Rain make_rain(uint32_t particles, uint32_t boxes);

/// A square sheet without diagonals, two metres wide, above a ball of 70 000 triangles with bumps.
struct Drape {
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
    System sheet;
};
Drape make_drape(uint32_t columns);

/// Balls in layers above a square pit, without friction: rigid spheres and particles move alike.
struct Pit {
    std::vector<gphys_vec3> balls;
    float radius, half_width;  // metres
};
Pit make_pit(uint32_t balls);

/// Atwood's machine without friction: a rope of 0.5 kg over a post, 1 kg at its first end and 3 kg at its last.
System make_post_rope();
/// How high its last end is after some seconds, metres: exact as long as the rope is on the post.
double post_rope_height(const System& rope, double seconds);
constexpr float post_radius = 0.3f, post_rope_radius = 0.03f;

std::unique_ptr<Method> make_gamephys_rain(const Rain& rain);
std::unique_ptr<Method> make_gamephys_pit(const Pit& pit, uint32_t substeps);
std::unique_ptr<Method> make_gamephys_post(const System& rope, uint32_t substeps);
std::unique_ptr<Method> make_gamephys_drape(const Drape& drape, uint32_t substeps);
#ifdef GAMEPHYS_BENCH_PEERS
std::unique_ptr<Method> make_bullet_rain(const Rain& rain);
/// Rigid spheres. A frame is one step with iterations, or substeps with the usual ten.
std::unique_ptr<Method> make_bullet_pit(const Pit& pit, uint32_t iterations);
std::unique_ptr<Method> make_bullet_pit_substeps(const Pit& pit, uint32_t substeps);
std::unique_ptr<Method> make_bullet_post(const System& rope, uint32_t iterations);
#endif

/// Of the frames of some part of the time.
struct RainResult {
    const char* when;
    double seconds;  // of a frame
};
/// Three seconds, after which all lie, and half a second of equal steps; `depth` gets how deep the deepest centre is in
/// a box or the ground, metres.
std::vector<RainResult> measure_rain(const Rain& rain, Method& method, double& depth);
struct PitResult {
    Spread seconds;  // of the frames
    double overlap;  // the largest of two balls, or of a ball and the pit, at the end of a frame; metres
};
PitResult measure_pit(const Pit& pit, Method& method, double seconds);
/// Seconds of a frame: the median.
double measure_drape(Method& method, double seconds);
/// The same sheet with a target of strain instead of a number of substeps.
struct DrapeFrames {
    double mean = 0, longest = 0;  // seconds of a frame
    double substeps = 0;           // of a frame, on average
    uint32_t most_substeps = 0;
};
/// seen(positions) after each frame.
DrapeFrames measure_drape_within(const Drape& drape, float max_strain, uint32_t max_substeps, double seconds,
                                 const std::function<void(const std::vector<gphys_vec3>&)>& seen);
/// How deep the deepest particle is in the ball, metres.
double depth_in_ball(const std::vector<gphys_vec3>& positions);

}  // namespace bench
