// The list of a mesh's observers, sorted and guarded by a mutex (mesh_users.h).
#include "mesh/mesh_users.h"

#include <functional>

namespace gphys {

bool MeshUsers::before(const User& a, const User& b) {
    if (a.user != b.user) return std::less<MeshUser*>()(a.user, b.user);
    return a.model < b.model;
}

void MeshUsers::join(MeshUser& user, const uint32_t* models, uint32_t count) {
    const std::lock_guard<std::mutex> lock(mutex_);
    reserve_more(users_, count);
    if (count == 1) {
        const User one{&user, models[0]};
        users_.insert(std::upper_bound(users_.begin(), users_.end(), one, before), one);
        return;
    }
    for (uint32_t i = 0; i < count; ++i) users_.push_back({&user, models[i]});
    std::sort(users_.begin(), users_.end(), before);
}

void MeshUsers::leave(MeshUser& user, uint32_t model) noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    users_.erase(std::lower_bound(users_.begin(), users_.end(), User{&user, model}, before));
}

const char* MeshUsers::check() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const User& each : users_) {
        if (const char* why = each.user->check_mesh(each.model)) return why;
    }
    return nullptr;
}

void MeshUsers::mesh_changed() const noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const User& each : users_) each.user->mesh_changed(each.model);
}

void MeshUsers::mesh_shifted(Vec3 by) const noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const User& each : users_) each.user->mesh_shifted(each.model, by);
}

}  // namespace gphys
