// Meshes in the form of bodies: what scenes show of them, and queries meet. A mesh follows its body whenever that has
// changed: after a step, and after an edit that moves, cuts or thickens it. The scenes that have models of it hear of
// it from the mesh (mesh_users.h), so a solver knows no scene but the one of the step under way.
#pragma once

#include "mesh/mesh.h"
#include "solver/body.h"

namespace gphys {

/// The particle nearest to a point, the lowest of those: of the corners of a triangle that the body's meshes have, or
/// with GPHYS_NO_TRIANGLE of all. False if there is no such triangle.
bool nearest_particle(const Body& body, uint32_t triangle, Vec3 point, uint32_t& out);

class BodyMeshes {
public:
    explicit BodyMeshes(std::pmr::memory_resource* memory) : entries_(memory), positions_(memory), radii_(memory) {}
    ~BodyMeshes();
    BodyMeshes(const BodyMeshes&) = delete;
    BodyMeshes& operator=(const BodyMeshes&) = delete;

    /// A new one, which the caller holds. What throws std::bad_alloc has changed nothing.
    Mesh* make(const gphys_allocator* hooks, gphys_body_id id, const Body& body);

    // A mesh that cannot follow keeps the form that it has: where a model of it would leave the range of the world, or
    // there is no memory. Those that nobody else holds are let go.

    /// Those of one body follow it. `shift` is what its coordinates have grown by, without that it moved.
    void follow(gphys_body_id id, const Body& body, Vec3 shift = {}) noexcept;
    /// Each follows body_of(id): null if that is gone. Then, or if the body is no longer made of the same parts, the
    /// mesh stays as it is and belongs to whoever holds it.
    template <class BodyOf>
    void follow_all(const BodyOf& body_of, Vec3 shift = {}) noexcept;
    void let_go(gphys_body_id id) noexcept;

private:
    struct Entry {
        gphys_body_id id;
        Mesh* mesh;
    };

    MeshArrays arrays_of(const Body& body) noexcept;
    void bring(const Entry& entry, const Body& body, Vec3 shift) noexcept;
    static bool fits(const Mesh& mesh, const Body& body);
    static void release(const Entry& entry) noexcept;

    Vector<Entry> entries_;
    // Room for the largest body.
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
