// Triangles, radii and vertices of the meshes of bodies (body_meshes.h).
#include "solver/body_meshes.h"

namespace gphys {
namespace {

/// For a rope: the links from each particle to the next. They precede the balls, one around each particle.
uint32_t link_count(const Body& body) { return body.kind == GPHYS_BODY_ROPE ? body.particles.size() - 1 : 0; }

/// Triangles of cloth; for a link from a to b: a, b, b; for a ball three times its particle.
Vector<uint32_t> indices_of(const Body& body, std::pmr::memory_resource* memory) {
    if (body.kind == GPHYS_BODY_CLOTH) return Vector<uint32_t>(body.cloth.sheet.triangles, memory);
    Vector<uint32_t> indices(memory);
    indices.reserve(size_t{3} * (link_count(body) + body.particles.size()));
    for (uint32_t p = 0; p < link_count(body); ++p) indices.insert(indices.end(), {p, p + 1, p + 1});
    for (uint32_t p = 0; p < body.particles.size(); ++p) indices.insert(indices.end(), {p, p, p});
    return indices;
}

/// Radii as in MeshArrays. A link exists while a constraint connects its ends, and is as thick as the thinner of them.
/// A ball exists where it is thicker than the links beside it, which otherwise contain it.
void find_radii(const Body& body, Vector<float>& radii) {
    const auto radius_of = [&](uint32_t particle) { return static_cast<float>(body.particles.radius[particle]); };
    const uint32_t links = link_count(body);
    std::fill_n(radii.begin(), links, -1.0f);
    for (uint32_t slot = 0; links > 0 && slot < body.constraints.ids.slots(); ++slot) {
        if (!body.constraints.ids.live(slot)) continue;
        const DistanceConstraint& c = body.constraints.by_slot[slot];
        const uint32_t low = std::min(c.a, c.b);
        if (std::max(c.a, c.b) - low == 1) radii[low] = std::min(radius_of(low), radius_of(low + 1));
    }
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        const float radius = radius_of(p);
        const bool held = (p > 0 && p <= links && radii[p - 1] == radius) || (p < links && radii[p] == radius);
        radii[links + p] = held ? -1 : radius;
    }
}

}  // namespace

bool nearest_particle(const Body& body, uint32_t triangle, Vec3 point, uint32_t& out) {
    double least = infinity;
    const auto offer = [&](uint32_t particle) {
        const double squared = length_squared(body.particles.position[particle] - point);
        if (squared > least || (squared == least && particle > out)) return;
        least = squared;
        out = particle;
    };
    if (triangle == GPHYS_NO_TRIANGLE) {
        for (uint32_t p = 0; p < body.particles.size(); ++p) offer(p);
    } else if (body.kind == GPHYS_BODY_CLOTH) {
        if (triangle >= body.cloth.sheet.triangles.size() / 3) return false;
        for (size_t corner = 0; corner < 3; ++corner) offer(body.cloth.sheet.triangles[size_t{3} * triangle + corner]);
    } else {
        const uint32_t links = link_count(body);
        if (triangle >= links + body.particles.size()) return false;
        if (triangle < links) {
            offer(triangle);
            offer(triangle + 1);
        } else {
            offer(triangle - links);
        }
    }
    return least < infinity;
}

BodyMeshes::~BodyMeshes() {
    for (const Entry& entry : entries_) release(entry);
}

void BodyMeshes::release(const Entry& entry) noexcept {
    entry.mesh->set_led(false);
    Mesh::release(entry.mesh);
}

void BodyMeshes::reserve(const Body& body) {
    if (positions_.size() < body.particles.size()) positions_.resize(body.particles.size());
    if (radii_.size() < link_count(body) + body.particles.size())
        radii_.resize(link_count(body) + body.particles.size());
}

/// The present form of the body. Uses reserved memory.
MeshArrays BodyMeshes::arrays_of(const Body& body) noexcept {
    for (uint32_t p = 0; p < body.particles.size(); ++p) positions_[p] = narrow(body.particles.position[p]);
    MeshArrays arrays{&positions_[0].x, sizeof(gphys_vec3), body.particles.size(), nullptr, 0, MeshKind::body_surface,
                      nullptr};
    if (body.kind != GPHYS_BODY_CLOTH) {
        find_radii(body, radii_);
        arrays.kind = MeshKind::body_links;
        arrays.radii = radii_.data();
    }
    return arrays;
}

Mesh* BodyMeshes::make(const gphys_allocator* hooks, gphys_body_id id, const Body& body) {
    std::pmr::memory_resource* const memory = entries_.get_allocator().resource();
    reserve(body);
    reserve_more(entries_, 1);
    const Vector<uint32_t> indices = indices_of(body, memory);
    MeshArrays arrays = arrays_of(body);
    arrays.indices = indices.data();
    arrays.index_count = static_cast<uint32_t>(indices.size());
    const gphys_mesh_report report = examine(arrays, memory);
    Mesh* const mesh = create<Mesh>(hooks, arrays, report, chosen_isa(), true);
    mesh->set_led(true);
    mesh->retain();
    entries_.push_back({id, mesh});
    return mesh;
}

bool BodyMeshes::fits(const Mesh& mesh, const Body& body) {
    const bool is_cloth = body.kind == GPHYS_BODY_CLOTH;
    if (is_cloth != (mesh.kind() == MeshKind::body_surface)) return false;
    if (is_cloth) return mesh.indices().size() == body.cloth.sheet.triangles.size();
    return mesh.vertices().size() == body.particles.size() &&
           mesh.triangle_count() == link_count(body) + body.particles.size();
}

void BodyMeshes::bring(const Entry& entry, const Body& body, Vec3 shift) noexcept {
    try {
        reserve(body);
        MeshArrays arrays = arrays_of(body);
        const Vector<uint32_t>& triangles = body.cloth.sheet.triangles;
        arrays.indices = triangles.data();
        arrays.index_count = static_cast<uint32_t>(triangles.size());
        const bool has_torn = body.kind == GPHYS_BODY_CLOTH && (entry.mesh->vertices().size() != arrays.vertex_count ||
                                                                entry.mesh->indices() != triangles);
        if (has_torn ? entry.mesh->set_surface(arrays) : entry.mesh->set_vertices(arrays)) return;
    } catch (const std::bad_alloc&) {
        return;
    }
    if (shift != Vec3{}) entry.mesh->shift_models(shift);
}

void BodyMeshes::follow(gphys_body_id id, const Body& body, Vec3 shift) noexcept {
    for (const Entry& entry : entries_) {
        if (entry.id == id) bring(entry, body, shift);
    }
}

void BodyMeshes::let_go(gphys_body_id id) noexcept {
    const auto of_body = [&](const Entry& entry) {
        if (entry.id != id) return false;
        release(entry);
        return true;
    };
    entries_.erase(std::remove_if(entries_.begin(), entries_.end(), of_body), entries_.end());
}

}  // namespace gphys
