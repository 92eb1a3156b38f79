// Snapshots of a scene: what is restored is what was saved, and words that somebody made up do no harm.
#include "scene/scene_snapshot.h"

#include <algorithm>

#include "world.h"

namespace fuzz {

uint64_t World::scene_hash() const {
    uint32_t halves[2] = {};
    FUZZ_CHECK(call(gphys_scene_get_hash, scene_, halves) == GPHYS_OK, "a scene has a hash");
    return uint64_t{halves[1]} << 32 | halves[0];
}

std::vector<uint32_t> World::scene_snapshot(int32_t embed_meshes) const {
    uint32_t total = 0;
    FUZZ_CHECK(call(gphys_scene_get_snapshot, scene_, embed_meshes, nullptr, 0u, &total) == GPHYS_INCOMPLETE,
               "no snapshot has no words");
    std::vector<uint32_t> words(total, 0xa5a5a5a5);
    FUZZ_CHECK(
        call(gphys_scene_get_snapshot, scene_, embed_meshes, words.data(), total - 1, &total) == GPHYS_INCOMPLETE,
        "a snapshot without room is incomplete");
    FUZZ_CHECK(words[0] == 0xa5a5a5a5, "a snapshot is written as a whole or not at all");
    FUZZ_CHECK(call(gphys_scene_get_snapshot, scene_, embed_meshes, words.data(), total, &total) == GPHYS_OK &&
                   total == words.size(),
               "a snapshot of a scene is taken");
    return words;
}

void World::save_scene() {
    if (!saved_scene_.empty() && p_.one_in(2)) return restore_scene();
    if (p_.one_in(3)) return restore_forged_scene();
    saved_meshes_ = p_.below(2);
    saved_scene_ = scene_snapshot(saved_meshes_);
    saved_models_ = models_;
    saved_stale_ = stale_;
    saved_hash_ = scene_hash();
}

void World::restore_scene() {
    const uint64_t before = scene_hash();
    if (p_.one_in(8)) memory_.fail_after(p_.below(30));
    const gphys_status status = call(gphys_scene_restore, scene_, p_.one_in(2) ? scene_ : nullptr, saved_scene_.data(),
                                     static_cast<uint32_t>(saved_scene_.size()));
    const bool out_of_memory = memory_.has_failed();
    memory_.never_fail();
    if (status != GPHYS_OK) {
        FUZZ_CHECK(scene_hash() == before, "a restore that fails changes nothing");
        const auto has_mesh = [](const Model& m) { return m.source != nullptr; };
        const bool may_be_missing = !saved_meshes_ && std::any_of(saved_models_.begin(), saved_models_.end(), has_mesh);
        FUZZ_CHECK(out_of_memory || may_be_missing, "a snapshot is restored");
        return;
    }
    FUZZ_CHECK(scene_hash() == saved_hash_, "a snapshot brings back the state");
    models_ = saved_models_;
    stale_ = saved_stale_;
    read_locals();
    double origin[3];
    call(gphys_scene_get_origin, scene_, origin);
    if (camera_) call(gphys_camera_set_origin, camera_, origin);
    if (solver_) move_solver_origin(origin);
    FUZZ_CHECK(call(gphys_scene_validate, scene_) == GPHYS_OK, "a restored scene is sound");
}

/// Words that somebody made up are refused, or are a scene like any other; then the true one is put back.
void World::restore_forged_scene() {
    const MayRaise made_up_words;
    const std::vector<uint32_t> good = scene_snapshot(1);
    std::vector<uint32_t> words = good;
    const uint64_t before = scene_hash();
    const uint32_t first = gphys::snapshot_header_words, size = static_cast<uint32_t>(words.size());
    const auto any = [&] { return first + p_.below(std::min(size - first, 65536u)); };
    for (uint32_t changes = 1 + p_.below(3); changes > 0; --changes) {
        uint32_t& word = words[any()];
        const uint32_t likely[] = {0,          1,          2,          8,          15,       0x01000000,
                                   0x00ffffff, 0xffffffff, 0x7fc00000, 0x58635fa9, word + 1, word - 1};
        word = p_.one_in(3) ? words[any()] : p_.one_in(4) ? p_.word() : likely[p_.below(std::size(likely))];
    }
    const uint64_t sum = gphys::scene_snapshot_checksum(words.data(), size);
    words[3] = static_cast<uint32_t>(sum);
    words[4] = static_cast<uint32_t>(sum >> 32);
    const gphys_status status = call(gphys_scene_restore, scene_, nullptr, words.data(), size);
    if (status != GPHYS_OK) {
        FUZZ_CHECK(scene_hash() == before, "a restore that fails changes nothing");
        return;
    }
    FUZZ_CHECK(call(gphys_scene_validate, scene_) == GPHYS_OK, "a scene of made-up words is sound");
    const gphys_ray ray = p_.ray();
    gphys_hit hits[4];
    uint32_t total = 0;
    call(gphys_scene_raycast, scene_, &ray, 7u, hits);
    call(gphys_scene_raycast_all, scene_, &ray, 7u, hits, 4u, &total);
    const gphys_sphere ball{p_.point(), p_.size()};
    gphys_model_id met[4];
    call(gphys_scene_overlap, scene_, gphys_shape_type{GPHYS_SHAPE_SPHERE}, &ball, 7u, met, 4u, &total);
    gphys_model_id added = 0;
    call(gphys_scene_add, scene_, gphys_shape_type{GPHYS_SHAPE_SPHERE}, &ball, nullptr, nullptr, &added);
    call(gphys_scene_get_models, scene_, met, 4u, &total);
    for (uint32_t i = 0; i < std::min(total, 4u); ++i) call(gphys_scene_remove, scene_, met[i]);
    FUZZ_CHECK(call(gphys_scene_validate, scene_) == GPHYS_OK, "a scene of made-up words is changed like any other");
    FUZZ_CHECK(call(gphys_scene_restore, scene_, nullptr, good.data(), size) == GPHYS_OK && scene_hash() == before,
               "a snapshot brings back the state");
}

}  // namespace fuzz
