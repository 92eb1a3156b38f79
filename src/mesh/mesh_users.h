// Observers of a deformable mesh: the models that show it are notified when it changes. Meshes know nothing of scenes.
#pragma once

#include <mutex>

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

/// An owner of models with meshes; it knows each of them by a number.
class MeshUser {
public:
    /// Why the model cannot accept the present mesh, or null.
    virtual const char* check_mesh(uint32_t model) const = 0;
    /// The mesh has changed, and no user has rejected the change.
    virtual void mesh_changed(uint32_t model) noexcept = 0;
    /// All vertices have been shifted by `by`. The model moves the other way, so that it stays where it is.
    virtual void mesh_shifted(uint32_t model, Vec3 by) noexcept = 0;

protected:
    ~MeshUser() = default;
};

/// The users of one mesh. Thread safe: scenes of different threads may join and leave at the same time.
class MeshUsers {
public:
    explicit MeshUsers(std::pmr::memory_resource* memory) : users_(memory) {}

    /// If it throws std::bad_alloc, nothing has changed.
    void join(MeshUser& user, const uint32_t* models, uint32_t count);
    /// Undoes one join of the model.
    void leave(MeshUser& user, uint32_t model) noexcept;

    const char* check() const;
    void mesh_changed() const noexcept;
    void mesh_shifted(Vec3 by) const noexcept;

private:
    struct User {
        MeshUser* user;
        uint32_t model;
    };
    static bool before(const User& a, const User& b);

    mutable std::mutex mutex_;
    Vector<User> users_;  // sorted, for binary search
};

}  // namespace gphys
