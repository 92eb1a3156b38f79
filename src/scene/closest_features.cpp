// The search of closest_features.h: lower bounds from kernels (near_kernels.h), exact distances on demand.
#include "scene/closest_features.h"

namespace gphys {

void ClosestFeatures::clear(uint32_t points) {
    point_count_ = points;
    mesh_count_ = primitive_count_ = packet_count_ = 0;
}

bool ClosestFeatures::add(const Scene& scene, gphys_model_id model, uint32_t tag, const Sphere* balls) {
    scene_ = &scene;
    const Mesh* const mesh = scene.mesh(model);
    if (mesh && !mesh->is_hull()) {
        return add_mesh(*mesh, scene.world_transform(model), AxisScale(widen(scene.scale(model))), model, tag, balls);
    }
    if (primitive_count_ == most_exact) return false;
    primitives_[primitive_count_++] = {model, tag, balls};
    return true;
}

bool ClosestFeatures::add_mesh(const Mesh& mesh, const Transform& world, const AxisScale& axes, gphys_model_id model,
                               uint32_t tag, const Sphere* balls) {
    if (mesh.triangle_count() == 0) return true;
    if (mesh_count_ == most_meshes) return false;
    PlacedMesh& placed = meshes_[mesh_count_];
    placed.model = model;
    placed.tag = tag;
    placed.world = world;
    placed.axes = axes;
    placed.balls = balls;
    placed.unit = axes.least() * world.scale;
    const MeshPlace place = placed.place();
    Aabb centers{place.inverse_apply(balls[0].center), place.inverse_apply(balls[0].center)};
    double reach = 0;
    for (uint32_t i = 0; i < point_count_; ++i) {
        const Vec3 center = place.inverse_apply(balls[i].center);
        placed.probes[i] = NearProbe(center, balls[i].radius / placed.unit);
        centers = {min(centers.min, center), max(centers.max, center)};
        reach = std::max<double>(reach, placed.probes[i].radius);
    }
    const Vec3 margin{reach, reach, reach};
    const Box all = bounds(Aabb{centers.min - margin, centers.max + margin});
    // Each mesh starts at a new Box8.
    const uint32_t first = placed.first_packet = (packet_count_ + 7) / 8 * 8;
    uint32_t count = 0;
    const bool complete = mesh.bvh().overlap_box(all, [&](uint32_t number, bool) {
        if (first + count == most_packets) return false;
        packets_[first + count] = &mesh.packets()[number];
        boxes_[(first + count) / 8].set_lane(static_cast<int>(count % 8), mesh.bvh().box(number));
        ++count;
        return true;
    });
    if (count == 0) return complete;
    for (uint32_t i = count; i % 8 != 0; ++i) {  // valid numbers in unused lanes
        boxes_[(first + i) / 8].set_lane(static_cast<int>(i % 8), boxes_[first / 8].lane(0));
    }
    placed.packet_count = count;
    packet_count_ = first + count;
    ++mesh_count_;
    return complete;
}

uint32_t ClosestFeatures::select_point(uint32_t point) {
    point_ = point;
    exact_count_ = 0;
    uint32_t near_count = 0;
    for (uint32_t i = 0; i < mesh_count_; ++i) {
        PlacedMesh& mesh = meshes_[i];
        mesh.probes[point].shrink(mesh.balls[point].radius / mesh.unit);
        mesh.first_near = near_count;
        mesh.near_count = kernels_.find(boxes_ + mesh.first_packet / 8, packets_ + mesh.first_packet, mesh.packet_count,
                                        mesh.probes[point], near_ + near_count);
        near_count += mesh.near_count;
    }
    for (uint32_t i = 0; i < primitive_count_; ++i) {
        const Primitive& primitive = primitives_[i];
        const Sphere& ball = primitive.balls[point];
        ClosestFeature part{primitive.model, primitive.tag, {}, {}, 0, false, {}};
        scene_->closest_point_model(primitive.model, ball.center, part.closest, part.normal, part.distance);
        if (part.distance <= ball.radius) exact_[exact_count_++] = part;
    }
    return exact_count_ + 8 * near_count;
}

uint32_t ClosestFeatures::nearest_exact() const {
    uint32_t best = 0;
    for (uint32_t i = 1; i < exact_count_; ++i) {
        if (exact_[i].distance < exact_[best].distance) best = i;
    }
    return best;
}

/// Keeps the order of the others, which decides between equal distances.
void ClosestFeatures::remove_exact(uint32_t exact) {
    std::copy(exact_ + exact + 1, exact_ + exact_count_, exact_ + exact);
    --exact_count_;
}

void ClosestFeatures::compute_exact(const PlacedMesh& mesh, uint32_t place) {
    NearPacket& near = near_[mesh.first_near + place / 8];
    const int lane = static_cast<int>(place % 8);
    near.distance[lane] = std::numeric_limits<float>::infinity();
    const Sphere& ball = mesh.balls[point_];
    ClosestFeature part{mesh.model, mesh.tag, {}, {}, 0, true, mesh.triangle(*near.packet, lane)};
    closest_point_triangle(part.triangle, ball.center, part.closest, part.normal, part.distance);
    if (part.distance <= ball.radius) exact_[exact_count_++] = part;
}

/// The lane with the least lower bound. The first bound of a packet is that of its box; its triangles are measured only
/// when that bound is the least.
float ClosestFeatures::nearest_lane_of(const PlacedMesh& mesh, uint32_t& place) {
    NearPacket* const near = near_ + mesh.first_near;
    for (;;) {
        const float distance = kernels_.nearest(near, mesh.near_count, place);
        if (distance == std::numeric_limits<float>::infinity() || near[place / 8].measured) return distance;
        kernels_.measure(near[place / 8], mesh.probes[point_]);
    }
}

bool ClosestFeatures::pop_nearest(ClosestFeature& out) {
    for (;;) {
        double bound = infinity;
        const PlacedMesh* nearest = nullptr;
        uint32_t place = 0;
        for (uint32_t i = 0; i < mesh_count_; ++i) {
            uint32_t at;
            const double distance = nearest_lane_of(meshes_[i], at) * meshes_[i].unit;
            if (distance < bound) bound = distance, nearest = &meshes_[i], place = at;
        }
        const uint32_t exact = nearest_exact();
        // If the array is full of equal distances, any of them will do.
        const bool found = exact_count_ > 0 && (exact_[exact].distance < bound || exact_count_ == most_exact);
        if (!found && !nearest) return false;
        if (!found) {
            compute_exact(*nearest, place);
            continue;
        }
        out = exact_[exact];
        remove_exact(exact);
        return true;
    }
}

void ClosestFeatures::cull_behind(Vec3 normal, double height, uint32_t tag) {
    const auto is_behind = [&](const Triangle& t) {
        return dot(normal, t.a) <= height && dot(normal, t.b) <= height && dot(normal, t.c) <= height;
    };
    for (uint32_t i = exact_count_; i-- > 0;) {
        if (exact_[i].is_triangle && exact_[i].tag == tag && is_behind(exact_[i].triangle)) remove_exact(i);
    }
    for (uint32_t i = 0; i < mesh_count_; ++i) {
        PlacedMesh& mesh = meshes_[i];
        if (mesh.tag != tag || mesh.near_count == 0) continue;
        // The half-space in the space of the mesh, relative to the point.
        const Vec3 across = mesh.axes(transpose_times(mesh.world.rotation, normal));
        const double slope = mesh.axes.is_one() ? 1 : length(across);
        const Vec3 local = mesh.axes.is_one() ? across : across / slope;
        const double above = (height - dot(normal, mesh.balls[point_].center)) / (mesh.world.scale * slope);
        uint32_t lanes[most_packets];
        NearPacket* const near = near_ + mesh.first_near;
        mesh.near_count =
            kernels_.cull(near, mesh.near_count, mesh.probes[point_], HalfSpaceProbe(local, above), lanes);
        for (uint32_t k = 0; k < mesh.near_count; ++k) {
            for_each_lane(lanes[k], [&](int lane) {
                if (is_behind(mesh.triangle(*near[k].packet, lane))) {
                    near[k].distance[lane] = std::numeric_limits<float>::infinity();
                }
                return true;
            });
        }
    }
}

}  // namespace gphys
