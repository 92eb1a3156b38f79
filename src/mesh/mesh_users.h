// Who has to know when a deformable mesh changes: the models that show it. Meshes know nothing of scenes.
#pragma once

#include <mutex>

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

/// What holds models of meshes, each known to it by a number.
class MeshUser {
public:
    /// Why the model cannot have the mesh as it is now, or null.
    virtual const char* refusal_of_mesh(uint32_t model) const = 0;
    /// The mesh has changed, and nobody rejects that.
    virtual void mesh_changed(uint32_t model) noexcept = 0;
    /// The coordinates of all vertices have grown by that, and the model moves the other way, to stay where it is.
    virtual void mesh_shifted(uint32_t model, Vec3 by) noexcept = 0;

protected:
    ~MeshUser() = default;
};

/// The users of one mesh. Scenes of different threads may come and go at the same time.
class MeshUsers {
public:
    explicit MeshUsers(std::pmr::memory_resource* memory) : users_(memory) {}

    /// What throws std::bad_alloc has changed nothing.
    void join(MeshUser& user, const uint32_t* models, uint32_t count);
    /// Takes back one join of the model.
    void leave(MeshUser& user, uint32_t model) noexcept;

    const char* refusal() const;
    void mesh_changed() const noexcept;
    void mesh_shifted(Vec3 by) const noexcept;

private:
    struct User {
        MeshUser* user;
        uint32_t model;
    };
    static bool before(const User& a, const User& b);

    mutable std::mutex mutex_;
    Vector<User> users_;  // in order, so that one is found quickly
};

}  // namespace gphys
