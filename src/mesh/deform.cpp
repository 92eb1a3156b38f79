// New vertices for the same triangles. Packets and the BVH are refitted (bottom-up), and subtrees that have degraded
// are rebuilt, as in a scene (bvh_rebuild.cpp). Neighbours on a surface stay neighbours when it bends, so packets
// hardly degrade. If they do, because a surface is torn apart, all triangles are partitioned into packets again.
#include "mesh/mesh.h"

namespace gphys {
namespace {

/// The triangles are packed anew when the area of the packets' boxes, absolute or relative to the root box, has grown
/// by this factor since the last packing. Rotating a flat sheet grows its boxes to at most three times their area, and
/// only once, because the new area is compared with the last packing.
constexpr double packed_growth = 2;

template <class T>
bool same_bits(const Vector<T>& a, const Vector<T>& b) {
    return a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

}  // namespace

gphys_mesh_report Mesh::report() const {
    gphys_mesh_report now = report_;
    if (deformable()) count_degenerate(arrays(), now);
    return now;
}

template <class ExchangeMore>
const char* Mesh::exchange_vertices(const Mesh* magnified, double magnification, ExchangeMore&& exchange_more) {
    const auto change = [&] {
        vertices_.swap(next_vertices_);
        radii_.swap(next_radii_);
        std::swap(magnified_, magnified);
        std::swap(magnification_, magnification);
        exchange_more();
        const double area = refit();
        measure();
        return area;
    };
    const double area = change();
    const char* const error = users_->check();
    if (error) {
        change();
    } else {
        users_->mesh_changed();
    }
    if (magnified) release(magnified);
    if (error || packets_.empty()) return error;
    if (area > packed_growth * packed_area_ ||
        area * packed_root_area_ > packed_growth * packed_area_ * half_area(bounds())) {
        try {
            pack();
        } catch (const std::bad_alloc&) {
            return nullptr;  // the old packing is still valid, only slower
        }
    }
    return nullptr;
}

const char* Mesh::set_vertices(const MeshArrays& arrays) {
    for (uint32_t i = 0; i < arrays.vertex_count; ++i) next_vertices_[i] = arrays.vertex(i);
    const float* const radii = arrays.radii ? arrays.radii : radii_.data();
    std::copy_n(radii, radii_.size(), next_radii_.begin());
    if (same_bits(next_vertices_, vertices_) && same_bits(next_radii_, radii_)) return nullptr;
    MeshArrays next = this->arrays();
    if (!next_vertices_.empty()) next.vertices = &next_vertices_[0].x;
    double magnification;
    const Mesh* const magnified = make_magnified(next, report_, magnification);
    return exchange_vertices(magnified, magnification, [] {});
}

const char* Mesh::set_surface(const MeshArrays& arrays) {
    Vector<uint32_t> indices(arrays.indices, arrays.indices + arrays.index_count, &memory);
    Vector<gphys_vec3> vertices(arrays.vertex_count, &memory), room(arrays.vertex_count, &memory);
    for (uint32_t i = 0; i < arrays.vertex_count; ++i) vertices[i] = arrays.vertex(i);
    gphys_mesh_report report = examine(arrays, &memory);
    WordHash index_hash = hash_of_indices(arrays);
    double magnification;
    const Mesh* const magnified = make_magnified(arrays, report, magnification);
    next_vertices_.swap(vertices);
    const char* const error = exchange_vertices(magnified, magnification, [&] {
        indices_.swap(indices);
        std::swap(report_, report);
        std::swap(index_hash_, index_hash);
    });
    next_vertices_.swap(error ? vertices : room);
    return error;
}

double Mesh::refit() noexcept {
    double area = 0;
    bvh_.update_many(static_cast<uint32_t>(packets_.size()), [&](const auto& put, bool) {
        for (uint32_t number = 0; number < packets_.size(); ++number) {
            TrianglePacket& packet = packets_[number];
            for (int lane = 0; lane < 8; ++lane) {
                const uint32_t index = packet.index[lane];
                const uint32_t* corner = indices_.data() + size_t{3} * (index != packet.none ? index : packet.index[0]);
                for (int c = 0; c < 3; ++c) {
                    const gphys_vec3& v = vertices_[corner[c]];
                    packet.corner[c][0][lane] = v.x;
                    packet.corner[c][1][lane] = v.y;
                    packet.corner[c][2][lane] = v.z;
                }
            }
            const Box box = box_of(packet);
            area += half_area(box);
            put(number, box);
        }
    });
    return area;
}

}  // namespace gphys
