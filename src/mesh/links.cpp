// Raycasts against a mesh whose triangles stand for capsules: links of ropes, and particles. The other queries are
// those of a mesh of triangles, with each triangle replaced by its capsule (Mesh::with_item). There are no conservative
// tests for packets of capsules: ropes have few links, and a leaf has eight at most.
#include "mesh/mesh.h"

namespace gphys {

Box Mesh::box_of(const TrianglePacket& packet) const {
    if (!is_links()) return packet.box();
    Box all;
    for (uint32_t lane = 0; lane < packet.count(); ++lane) {
        const double radius = std::max(radii_[packet.index[lane]], 0.0f);
        for (int k = 0; k < 3; ++k) {
            const float a = packet.corner[0][k][lane], b = packet.corner[1][k][lane];
            const float low = round_down(std::min(a, b) - radius), high = round_up(std::max(a, b) + radius);
            all.min[k] = lane == 0 ? low : std::min(all.min[k], low);
            all.max[k] = lane == 0 ? high : std::max(all.max[k], high);
        }
    }
    return without_negative_zeros(all);
}

uint32_t Mesh::links_of(const TrianglePacket& packet) const {
    uint32_t lanes = packet.lanes();
    for (uint32_t lane = 0; lane < packet.count(); ++lane) {
        if (std::signbit(radii_[packet.index[lane]])) lanes &= ~(1u << lane);
    }
    return lanes;
}

bool Mesh::raycast_links(const Ray& ray, Hit& hit) const {
    Hit first;
    float first_t = std::numeric_limits<float>::infinity();
    bvh_.raycast(ray, ray.t_max, [&](uint32_t number, double& t_max) {
        const TrianglePacket& packet = packets_[number];
        for_each_lane(links_of(packet), [&](int lane) {
            Hit candidate;
            if (!gphys::raycast(link(packet.triangle(lane), packet.index[lane]), ray, candidate)) return true;
            candidate.triangle = packet.index[lane];
            const float t = reported(candidate.t);
            if (t < first_t || (t == first_t && candidate.triangle < first.triangle)) {
                first = candidate;
                first_t = t;
                t_max = std::min(t_max, limit_of_ties<double>(t));
            }
            return true;
        });
    });
    if (first.triangle == GPHYS_NO_TRIANGLE) return false;
    hit = first;
    return true;
}

bool Mesh::raycast_any_links(const Ray& ray) const {
    return bvh_.raycast_any(ray, [&](uint32_t number) {
        const TrianglePacket& packet = packets_[number];
        return !for_each_lane(links_of(packet), [&](int lane) {
            Hit hit;
            return !gphys::raycast(link(packet.triangle(lane), packet.index[lane]), ray, hit);
        });
    });
}

}  // namespace gphys
