// The work that every implementation gets: generated from fixed seeds, the same everywhere.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gamephys_c.h"

namespace bench {

struct Triangles {
    std::vector<gphys_vec3> vertices;
    std::vector<uint32_t> indices;
    uint32_t count() const { return static_cast<uint32_t>(indices.size() / 3); }
};

/// Small, reproducible generator (splitmix64).
class Random {
public:
    explicit Random(uint64_t seed) : state_(seed) {}
    uint64_t next();
    float uniform(float low, float high);
    gphys_vec3 point(float extent);
    gphys_vec3 direction();
    gphys_quat rotation();

private:
    uint64_t state_;
};

/// Half the side of a cube in which n objects have constant density: one in 64 cubic metres.
float half_side(uint32_t n);

std::vector<gphys_obb> boxes(uint32_t n);
std::vector<gphys_sphere> spheres(uint32_t n);
/// Placements of unit-sized meshes.
std::vector<gphys_transform> placements(uint32_t n);
/// A mesh that is stretched along its own axes before it is placed.
struct Stretched {
    gphys_transform place;
    gphys_vec3 scale;
};
/// The placements, each with a scale per axis from 0.3 to 1.
std::vector<Stretched> forest(uint32_t n);
/// A step of random motion for all boxes; at most 0.1 m and a few degrees.
void jiggle(std::vector<gphys_obb>& boxes, uint64_t frame);

/// Steady motion: each box has a velocity of its own, at most 0.2 m a step along each axis, and turns back at the
/// border.
class Drift {
public:
    Drift(size_t count, float half_side);
    void step(std::vector<gphys_obb>& boxes);

private:
    std::vector<gphys_vec3> velocities_;
    float half_side_;
};

/// Boxes in the order in which they are added one by one, as worlds are made: at random places, sorted along an axis,
/// along a line, row by row of a floor, all at one place.
struct Arrangement {
    std::string name;
    std::vector<gphys_obb> boxes;
};
std::vector<Arrangement> arrangements(uint32_t n);
/// Boxes that go to random places of the cube, and which; a box may go more than once.
struct Jump {
    uint32_t object;
    gphys_obb to;
};
std::vector<Jump> jumps(uint32_t n, uint32_t count, uint64_t seed);
/// Rays from 5 to 50 m away, each through one of the boxes.
std::vector<gphys_ray> rays_at(const std::vector<gphys_obb>& boxes, uint32_t count);

/// Long rays from outside the cube to random points of it.
std::vector<gphys_ray> random_rays(float half_side, uint32_t count);
/// Points within a hundredth of the mesh's size of its surface, as those of a scan of it.
std::vector<gphys_vec3> points_near(const Triangles& mesh, uint32_t count);
/// The rays of a camera outside the cube that sees all of it, in tiles of 8 by 8 pixels.
std::vector<gphys_ray> camera_rays(float half_side, uint32_t width, uint32_t height);
std::vector<gphys_sphere> query_spheres(float half_side, uint32_t count, float radius);
std::vector<gphys_aabb> query_boxes(float half_side, uint32_t count, float half);
struct Sweep {
    gphys_sphere sphere;
    gphys_vec3 displacement;
};
/// A solid that moves: a capsule or a box.
template <class Solid>
struct SolidSweep {
    Solid solid;
    gphys_vec3 displacement;
};
using CapsuleSweep = SolidSweep<gphys_capsule>;
using BoxSweep = SolidSweep<gphys_obb>;
std::vector<CapsuleSweep> query_capsule_sweeps(float half_side, uint32_t count, float length);
std::vector<BoxSweep> query_box_sweeps(float half_side, uint32_t count, float length);
std::vector<gphys_vec3> query_points(float half_side, uint32_t count);
/// Between points of the cube that are that far apart.
std::vector<gphys_segment> query_segments(float half_side, uint32_t count, float length);
std::vector<Sweep> query_sweeps(float half_side, uint32_t count, float radius, float length);
/// A frustum that sees about a tenth of the cube.
gphys_frustum view(float half_side);

/// The convex hull of a rock within the unit ball, closed: 76 faces.
Triangles rock();
/// A sphere of radius about 1 with hills, 20 * 4^level triangles, closed.
Triangles bumpy_sphere(int level);

/// Surfaces that take other forms, at rest: a tube, as the skin of a limb, and a sheet, as cloth.
Triangles tube(uint32_t rings, uint32_t around);
Triangles sheet(uint32_t side);
/// What becomes of the vertices: the limb bends to and fro, waves run through the cloth.
std::vector<gphys_vec3> bent(const Triangles& tube, double phase);
std::vector<gphys_vec3> waving(const Triangles& sheet, double phase);

}  // namespace bench
