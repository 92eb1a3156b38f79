// Meshes in the form of bodies, for scenes and queries. A mesh follows its body after each change: a step, or an edit
// that moves, cuts or thickens it. The mesh notifies the scenes with models of it (mesh_users.h), so a solver knows no
// scene but the one of the step under way.
#pragma once

#include "mesh/mesh.h"
#include "solver/body.h"

namespace gphys {

/// The particle nearest to a point, of several the lowest: among the corners of a triangle of the body's meshes, or
/// with GPHYS_NO_TRIANGLE among all. Returns false if there is no such triangle.
bool nearest_particle(const Body& body, uint32_t triangle, Vec3 point, uint32_t& out);

class BodyMeshes {
public:
    explicit BodyMeshes(std::pmr::memory_resource* memory) : entries_(memory), positions_(memory), radii_(memory) {}
    ~BodyMeshes();
    BodyMeshes(const BodyMeshes&) = delete;
    BodyMeshes& operator=(const BodyMeshes&) = delete;

    /// A new mesh, of which the caller owns a reference. If it throws std::bad_alloc, nothing has changed.
    Mesh* make(const gphys_allocator* hooks, gphys_body_id id, const Body& body);

    // A mesh of cloth that has torn gets its new corners and vertices. A mesh that cannot follow keeps its form: if a
    // model of it would leave the range of the world, or if there is no memory. Meshes that nobody else holds are
    // released.

    /// Updates the meshes of one body. `shift`: the change of its coordinates by a new origin, without motion.
    void follow(gphys_body_id id, const Body& body, Vec3 shift = {}) noexcept;
    /// Updates each mesh from body_of(id), which is null if the body is gone. Then, or if the body no longer consists
    /// of the same parts, the mesh keeps its form and belongs to its holders.
    template <class BodyOf>
    void follow_all(const BodyOf& body_of, Vec3 shift = {}) noexcept;
    void let_go(gphys_body_id id) noexcept;

private:
    struct Entry {
        gphys_body_id id;
        Mesh* mesh;
    };

    /// Memory for the arrays of a body. Throws std::bad_alloc.
    void reserve(const Body& body);
    MeshArrays arrays_of(const Body& body) noexcept;
    void bring(const Entry& entry, const Body& body, Vec3 shift) noexcept;
    static bool fits(const Mesh& mesh, const Body& body);
    static void release(const Entry& entry) noexcept;

    Vector<Entry> entries_;
    // Capacity for the largest body.
    Vector<gphys_vec3> positions_;
    Vector<float> radii_;
};

template <class BodyOf>
void BodyMeshes::follow_all(const BodyOf& body_of, Vec3 shift) noexcept {
    size_t kept = 0;
    for (const Entry entry : entries_) {
        const Body* const body = body_of(entry.id);
        if (!body || entry.mesh->is_held_once() || !fits(*entry.mesh, *body)) {
            release(entry);
        } else {
            bring(entry, *body, shift);
            entries_[kept++] = entry;
        }
    }
    entries_.resize(kept);
}

}  // namespace gphys
