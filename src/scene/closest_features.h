// Closest features of models (primitives, hulls, triangles of meshes) to up to eight points: nearest first, without the
// triangles behind planes that the caller has found. The solver builds its contact planes from them.
//
// One traversal of a mesh's BVH serves all points. Triangles stay in the packets of their mesh, with lower bounds of
// their distances in float. The exact distance is computed only for triangles that may be the nearest (lazy evaluation
// as in best-first search: Hjaltason and Samet, "Distance browsing in spatial databases", 1999).
#pragma once

#include "mesh/near_kernels.h"
#include "scene/scene.h"

namespace gphys {

/// A convex part of a model, near a point.
struct ClosestFeature {
    gphys_model_id model;
    uint32_t tag;          // given to add()
    Vec3 closest, normal;  // as from closest_point_model
    double distance;       // signed
    bool is_triangle;
    Triangle triangle;  // in world space
};

class ClosestFeatures {
public:
    static constexpr uint32_t most_points = 8;

    void clear(uint32_t points);
    /// Adds the parts of a model. Those that overlap balls[i] are near point i. Keeps a reference to `balls`. Returns
    /// false if there are more parts than fit; then some are missing.
    bool add(const Scene& scene, gphys_model_id model, uint32_t tag, const Sphere* balls);

    /// Starts with all parts near one point, and discards the state of another point. Balls may have shrunk since
    /// add(). Returns an upper bound of the number of parts.
    uint32_t select_point(uint32_t point);
    /// Removes and returns the nearest remaining part; false if none is left.
    bool pop_nearest(ClosestFeature& out);
    /// Removes the triangles of models with the tag that lie wholly in dot(normal, p) <= height. `normal` is unit.
    void cull_behind(Vec3 normal, double height, uint32_t tag);
    /// visit(tag, distance) for remaining parts: for each mesh one with the least lower bound of the distance, and all
    /// with a known distance.
    template <class Visit>
    void for_each_remaining(Visit&& visit);

private:
    static constexpr uint32_t most_packets = 128, most_meshes = 16, most_exact = 64;

    struct PlacedMesh {
        gphys_model_id model;
        uint32_t tag;
        Transform world;
        AxisScale axes;
        double unit;  // the least length in the world of a unit length in the mesh
        const Sphere* balls;
        uint32_t first_packet, packet_count;  // in packets_
        uint32_t first_near, near_count;      // in near_
        NearProbe probes[most_points];

        MeshPlace place() const { return {world, axes}; }
        Triangle triangle(const TrianglePacket& packet, int lane) const {
            return transformed(axes(packet.triangle(lane)), world);
        }
    };
    struct Primitive {
        gphys_model_id model;
        uint32_t tag;
        const Sphere* balls;
    };

    bool add_mesh(const Mesh& mesh, const Transform& world, const AxisScale& axes, gphys_model_id model, uint32_t tag,
                  const Sphere* balls);
    uint32_t nearest_exact() const;
    void remove_exact(uint32_t known);
    void compute_exact(const PlacedMesh& mesh, uint32_t place);
    float nearest_lane_of(const PlacedMesh& mesh, uint32_t& place);

    const NearKernels& kernels_ = near_kernels(chosen_isa());
    const Scene* scene_;
    uint32_t point_count_ = 0, point_ = 0;
    uint32_t mesh_count_ = 0, primitive_count_ = 0, packet_count_ = 0, exact_count_ = 0;
    PlacedMesh meshes_[most_meshes];
    Primitive primitives_[most_exact];
    const TrianglePacket* packets_[most_packets];
    Box8 boxes_[most_packets / 8];  // of the packets
    NearPacket near_[most_packets];
    ClosestFeature exact_[most_exact];  // parts with an exact distance
};

template <class Visit>
void ClosestFeatures::for_each_remaining(Visit&& visit) {
    for (uint32_t i = 0; i < exact_count_; ++i) visit(exact_[i].tag, exact_[i].distance);
    for (uint32_t i = 0; i < mesh_count_; ++i) {
        uint32_t place;
        const float distance = nearest_lane_of(meshes_[i], place);
        if (distance < std::numeric_limits<float>::infinity()) visit(meshes_[i].tag, distance * meshes_[i].unit);
    }
}

}  // namespace gphys
