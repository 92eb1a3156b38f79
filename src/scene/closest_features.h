// The convex parts of models (primitives, hulls, and triangles of meshes) near a group of points: nearest first, and
// without those behind planes that the caller has found.
//
// One traversal serves all points. Triangles stay in the packets of their meshes, with lower bounds of their distances
// in float; the exact distance is computed only for those that may be the nearest.
#pragma once

#include "mesh/near_kernels.h"
#include "scene/scene.h"

namespace gphys {

/// A convex part of a model, near a point.
struct ClosestFeature {
    gphys_model_id model;
    uint32_t tag;          // as the model was added with
    Vec3 closest, normal;  // as those of closest_point_model
    double distance;       // signed
    bool is_triangle;
    Triangle triangle;  // in world space
};

class ClosestFeatures {
public:
    static constexpr uint32_t most_points = 8;

    void clear(uint32_t points);
    /// Parts of a model that touch balls[i] are near point i. The balls are kept by reference. False if there are
    /// too many parts, of which some are missing then.
    bool add(const Scene& scene, gphys_model_id model, uint32_t tag, const Sphere* balls);

    /// All parts that touch a point's balls are there; what was asked of another one no longer is. Balls may have
    /// become smaller since the models were added. Returns how many parts there are at most.
    uint32_t select_point(uint32_t point);
    /// Takes out the nearest part that is there; false if none is.
    bool take_nearest(ClosestFeature& out);
    /// Leaves out triangles of models with the tag that are wholly behind dot(normal, place) = height; `normal` is
    /// unit.
    void cull_behind(Vec3 normal, double height, uint32_t tag);
    /// visit(tag, distance) for what is left: some parts of each model, and one that is nearest. A distance may be
    /// larger.
    template <class Visit>
    void for_each_left(Visit&& visit);

private:
    static constexpr uint32_t most_packets = 128, most_meshes = 16, most_exact = 64;

    struct PlacedMesh {
        gphys_model_id model;
        uint32_t tag;
        Transform world;
        AxisScale axes;
        double unit;  // that a distance in the mesh as it is has in the world, at least
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
    uint32_t nearest_known() const;
    void take_out(uint32_t known);
    void compute(const PlacedMesh& mesh, uint32_t place);
    float nearest_in(const PlacedMesh& mesh, uint32_t& place);

    const NearKernels& kernels_ = near_kernels(chosen_isa());
    const Scene* scene_;
    uint32_t point_count_ = 0, point_ = 0;
    uint32_t mesh_count_ = 0, primitive_count_ = 0, packet_count_ = 0, known_count_ = 0;
    PlacedMesh meshes_[most_meshes];
    Primitive primitives_[most_exact];
    const TrianglePacket* packets_[most_packets];
    Box8 boxes_[most_packets / 8];  // of the packets
    NearPacket near_[most_packets];
    ClosestFeature known_[most_exact];  // whose distances are known
};

template <class Visit>
void ClosestFeatures::for_each_left(Visit&& visit) {
    for (uint32_t i = 0; i < known_count_; ++i) visit(known_[i].tag, known_[i].distance);
    for (uint32_t i = 0; i < mesh_count_; ++i) {
        uint32_t place;
        const float distance = nearest_in(meshes_[i], place);
        if (distance < std::numeric_limits<float>::infinity()) visit(meshes_[i].tag, distance * meshes_[i].unit);
    }
}

}  // namespace gphys
