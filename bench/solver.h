// What the suite `solver` moves, and who moves it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "gamephys_c.h"

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
};

constexpr double gravity = 9.81;
constexpr double frame = 1.0 / 60;

/// A way to move a system.
class Method {
public:
    virtual ~Method() = default;
    virtual void step() = 0;  // one frame
    virtual std::vector<gphys_vec3> positions() const = 0;
    virtual std::vector<gphys_vec3> velocities() const = 0;
};

// `effort` is substeps per frame, or iterations where a frame is one step.
std::unique_ptr<Method> make_gamephys_solver(const System& system, uint32_t substeps);
/// Jakobsen 2001: Verlet's scheme on positions, one step a frame, projections of one link after the other.
std::unique_ptr<Method> make_jakobsen(const System& system, uint32_t iterations);
/// Macklin et al. 2016 and 2019: a single projection of each link per substep.
std::unique_ptr<Method> make_xpbd(const System& system, uint32_t substeps);
#ifdef GAMEPHYS_BENCH_PEERS
std::unique_ptr<Method> make_bullet_soft(const System& system, uint32_t iterations);
#endif

/// Processor time of this thread.
double seconds_of_thread();

/// What a body among models takes; strain at the end.
struct SceneResult {
    double seconds, strain_max, strain_rms;
};
SceneResult rain_on_boxes(uint32_t particles, uint32_t boxes, double seconds);
/// A square sheet, two metres wide, without diagonals, onto a bumpy ball of 70 000 triangles.
SceneResult drape_over_mesh(uint32_t columns, uint32_t substeps, double seconds);

}  // namespace bench
