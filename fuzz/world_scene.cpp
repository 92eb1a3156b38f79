// Changes of a scene, with right and wrong arguments, beside a list of what the scene must hold.
#include <algorithm>
#include <cmath>

#include "world.h"

namespace fuzz {
namespace {

constexpr uint32_t most_models = 40;

/// Whether a world transform has been kept below a parent, up to rounding. Each number is rounded twice to float32, of
/// the local transform and of the world's: by 2^-24 of itself. What a local position loses is 2^-24 of its length,
/// which in the world is that of the way from the parent; of a unit quaternion two roundings change 2^-23 at most. The
/// rest, of the computation in double precision, is below 1e-4 of that.
bool is_kept(const gphys_transform& before, const gphys_transform& after, const gphys_transform& parent) {
    constexpr double half_ulp = 0x1p-24 * 1.0001;
    const double least = 0x1p-149 * (1 + parent.scale);  // denormal numbers
    const gphys::Vec3 from = gphys::widen(before.position), to = gphys::widen(after.position);
    const double lost = half_ulp * distance(from, gphys::widen(parent.position));
    for (int k = 0; k < 3; ++k) {
        if (std::fabs(to[k] - from[k]) > lost + half_ulp * std::fabs(from[k]) + least) return false;
    }
    const gphys::Quat a = normalized(gphys::widen(before.rotation)), b = normalized(gphys::widen(after.rotation));
    const double sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0 ? -1 : 1;
    const double turned =
        std::hypot(std::hypot(a.x - sign * b.x, a.y - sign * b.y), std::hypot(a.z - sign * b.z, a.w - sign * b.w));
    return turned <= 2 * half_ulp && std::fabs(double{after.scale} - before.scale) <= 2 * half_ulp * before.scale;
}

}  // namespace

void World::create_scene() {
    gphys_scene_desc desc;
    call(gphys_scene_desc_init, &desc, static_cast<uint32_t>(sizeof desc));
    const gphys_allocator hooks = memory_.hooks();
    desc.allocator = &hooks;
    desc.reserve_models = p_.below(4);
    FUZZ_CHECK(call(gphys_scene_create, &desc, &scene_) == GPHYS_OK, "a scene is created");
}

const Model* World::model(gphys_model_id id) const {
    const auto at = std::lower_bound(models_.begin(), models_.end(), id,
                                     [](const Model& m, gphys_model_id wanted) { return m.id < wanted; });
    return at != models_.end() && at->id == id ? &*at : nullptr;
}
Model* World::model(gphys_model_id id) { return const_cast<Model*>(static_cast<const World*>(this)->model(id)); }

gphys_model_id World::any_id() {
    const uint32_t choice = p_.byte();
    if (choice < 8) return p_.word();
    if (choice < 20 && !stale_.empty()) return stale_[p_.below(static_cast<uint32_t>(stale_.size()))];
    if (choice < 24 || models_.empty()) return 0;
    return models_[p_.below(static_cast<uint32_t>(models_.size()))].id;
}

bool World::is_below(gphys_model_id id, gphys_model_id ancestor) const {
    for (; id != 0; id = model(id)->parent) {
        if (id == ancestor) return true;
    }
    return false;
}

void World::follow_parents() {
    std::vector<bool> done(models_.size());
    for (size_t left = models_.size(); left > 0;) {
        for (size_t i = 0; i < models_.size(); ++i) {
            Model& m = models_[i];
            const Model* parent = m.parent ? model(m.parent) : nullptr;
            if (done[i] || (parent && !done[static_cast<size_t>(parent - models_.data())])) continue;
            m.world = parent ? gphys::composed(parent->world, m.local) : m.local;
            done[i] = true;
            --left;
        }
    }
}

void World::read_locals() {
    for (Model& m : models_) {
        FUZZ_CHECK(call(gphys_scene_get_transforms, scene_, &m.id, 1u, &m.local,
                        static_cast<uint32_t>(sizeof m.local)) == GPHYS_OK,
                   "a model has a transform");
    }
    follow_parents();
}

void World::forget(gphys_model_id id) {
    stale_.push_back(id);
    models_.erase(models_.begin() + (model(id) - models_.data()));
}

void World::add() {
    if (models_.size() >= most_models) return remove();
    gphys_model_desc desc;
    call(gphys_model_desc_init, &desc, static_cast<uint32_t>(sizeof desc));
    desc.layers = p_.one_in(3) ? 1u << p_.below(3) : 7;
    desc.tag = p_.byte();
    desc.parent = p_.one_in(3) ? any_id() : 0;
    if (p_.one_in(3)) desc.scale = any_scale();
    gphys_transform local = p_.transform();
    p_.spoil(local, 40);
    AnyShape shape = p_.shape(p_.shape_type(p_.one_in(40)));
    p_.spoil(shape, 40);
    const bool is_mesh = p_.one_in(3);
    const uint32_t which = p_.below(3);
    // Where what else is drawn is near.
    if (is_mesh && p_.one_in(2)) local = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    if (is_mesh) shape.type = GPHYS_SHAPE_MESH;
    const void* given = is_mesh ? static_cast<const void*>(meshes_[which].get()) : shape.bytes;
    if (p_.one_in(40)) memory_.fail_after(p_.below(4));
    Output<gphys_model_id> id;
    const gphys_status status = call(gphys_scene_add, scene_, shape.type, given, &local, &desc, &id.value);
    const bool out_of_memory = memory_.has_failed();
    memory_.never_fail();
    id.after(status);
    const bool valid = is_valid(local) && (is_mesh || is_valid(shape)) && shape.type != GPHYS_SHAPE_FRUSTUM &&
                       (desc.parent == 0 || model(desc.parent));
    const bool is_equal = desc.scale.x == desc.scale.y && desc.scale.y == desc.scale.z;
    FUZZ_CHECK(status == GPHYS_OK ? valid && !out_of_memory
                                  : !valid || out_of_memory || status == GPHYS_ERROR_INVALID_ARGUMENT ||
                                        (status == GPHYS_ERROR_UNSUPPORTED && !is_equal),
               "models are added exactly where their arguments are valid");
    if (status != GPHYS_OK) return;
    FUZZ_CHECK(id.value != 0 && !model(id.value), "each model has an id of its own");
    FUZZ_CHECK(std::find(stale_.begin(), stale_.end(), id.value) == stale_.end(), "a stale id does not come back");
    Model added{id.value, desc.parent, desc.layers, desc.tag, shape, is_mesh ? &sources_[which] : nullptr,
                local,    local,       desc.scale};
    if (desc.parent) added.world = gphys::composed(model(desc.parent)->world, local);
    models_.insert(std::lower_bound(models_.begin(), models_.end(), id.value,
                                    [](const Model& m, gphys_model_id wanted) { return m.id < wanted; }),
                   added);
}

void World::add_batch() {
    const uint32_t count = p_.below(6);
    if (models_.size() + count >= most_models) return remove_batch();
    const gphys_shape_type type = p_.shape_type(false);
    struct Spaced {
        AnyShape shape;
    };
    std::vector<Spaced> shapes(count + 1);
    std::vector<gphys_transform> locals(count + 1);
    for (Spaced& each : shapes) each.shape = p_.shape(type);
    for (gphys_transform& local : locals) local = p_.transform();
    if (count > 0) p_.spoil(shapes[p_.below(count)].shape, 8);
    const uint32_t shape_strides[] = {sizeof(Spaced), sizeof(Spaced), 0, 4, 13};
    const uint32_t stride = shape_strides[p_.below(5)];
    const bool with_transforms = !p_.one_in(4);
    std::vector<gphys_model_id> ids(count + 1, 0xa5a5a5a5);
    const gphys_transform* given = with_transforms ? locals.data() : nullptr;
    const uint32_t local_stride = sizeof(gphys_transform);
    std::vector<gphys_model_desc> descs(count + 1, gphys_model_desc{sizeof(gphys_model_desc), 0, 1, 0, {1, 1, 1}});
    const bool described = count % 2 == 1;
    for (uint32_t i = 0; described && i < count; ++i) {
        if (i % 2 == 1 && !models_.empty()) descs[i].parent = models_[i % models_.size()].id;
        descs[i].layers = 1u << i;
        descs[i].tag = 100 + i;
    }
    const gphys_status status =
        described ? call(gphys_scene_add_described_batch, scene_, type, shapes[0].shape.bytes, stride, given,
                         local_stride, descs.data(), uint32_t{sizeof descs[0]}, count, ids.data())
                  : call(gphys_scene_add_batch, scene_, type, shapes[0].shape.bytes, stride, given, local_stride, count,
                         nullptr, ids.data());
    bool valid = count == 0 || stride == sizeof(Spaced) || stride == 0;
    for (uint32_t i = 0; i < count; ++i) {
        valid = valid && is_valid(shapes[stride ? i : 0].shape) && (!with_transforms || is_valid(locals[i]));
    }
    FUZZ_CHECK(status != GPHYS_OK || valid, "a batch of models is added only if all are valid");
    FUZZ_CHECK(status == GPHYS_OK || ids[0] == 0xa5a5a5a5, "an error leaves outputs untouched");
    if (status != GPHYS_OK) return;
    const gphys_transform identity{{0, 0, 0}, {0, 0, 0, 1}, 1};
    for (uint32_t i = 0; i < count; ++i) {
        note(ids[i]);
        FUZZ_CHECK(ids[i] != 0 && !model(ids[i]), "each model has an id of its own");
        const gphys_transform& local = with_transforms ? locals[i] : identity;
        const gphys_model_desc& desc = descs[i];
        const gphys_transform world = desc.parent ? gphys::composed(model(desc.parent)->world, local) : local;
        const Model added{ids[i],  desc.parent, desc.layers, desc.tag, shapes[stride ? i : 0].shape,
                          nullptr, local,       world};
        models_.insert(std::lower_bound(models_.begin(), models_.end(), ids[i],
                                        [](const Model& m, gphys_model_id wanted) { return m.id < wanted; }),
                       added);
    }
}

void World::remove() {
    const gphys_model_id id = any_id();
    const gphys_status status = call(gphys_scene_remove, scene_, id);
    FUZZ_CHECK(status == (model(id) ? GPHYS_OK : GPHYS_ERROR_INVALID_ID), "only models are removed");
    if (status != GPHYS_OK) return;
    for (Model& m : models_) {
        if (m.parent == id) m.parent = 0;
    }
    forget(id);
    read_locals();
}

void World::remove_batch() {
    std::vector<gphys_model_id> ids(p_.below(5));
    bool valid = true;
    for (size_t i = 0; i < ids.size(); ++i) {
        ids[i] = any_id();
        valid = valid && model(ids[i]) && std::find(ids.begin(), ids.begin() + i, ids[i]) == ids.begin() + i;
    }
    const gphys_status status = call(gphys_scene_remove_batch, scene_, ids.data(), static_cast<uint32_t>(ids.size()));
    FUZZ_CHECK((status == GPHYS_OK) == valid, "models are removed all or none");
    if (status != GPHYS_OK) return;
    for (const gphys_model_id id : ids) {
        for (Model& m : models_) {
            if (m.parent == id) m.parent = 0;
        }
        forget(id);
    }
    read_locals();
}

void World::remove_subtree() {
    const gphys_model_id id = any_id();
    const gphys_status status = call(gphys_scene_remove_subtree, scene_, id);
    FUZZ_CHECK(status == (model(id) ? GPHYS_OK : GPHYS_ERROR_INVALID_ID), "only models are removed");
    if (status != GPHYS_OK) return;
    std::vector<gphys_model_id> gone;
    for (const Model& m : models_) {
        if (is_below(m.id, id)) gone.push_back(m.id);
    }
    for (const gphys_model_id each : gone) forget(each);
}

void World::clear() {
    FUZZ_CHECK(call(gphys_scene_clear, scene_) == GPHYS_OK, "a scene is cleared");
    while (!models_.empty()) forget(models_.back().id);
}

void World::set_transform() {
    const gphys_model_id id = any_id();
    gphys_transform local = p_.transform();
    p_.spoil(local, 20);
    const gphys_status status = call(gphys_scene_set_transform, scene_, id, &local);
    const bool valid = model(id) && is_valid(local);
    FUZZ_CHECK(status == GPHYS_OK ? valid : !valid || status == GPHYS_ERROR_INVALID_ARGUMENT,
               "only models are moved, and to valid places");
    if (status != GPHYS_OK) return;
    model(id)->local = local;
    follow_parents();
}

void World::set_transforms() {
    const uint32_t count = p_.below(12);
    std::vector<gphys_model_id> ids(count + 1);
    std::vector<gphys_transform> locals(count + 1);
    bool valid = true;
    for (uint32_t i = 0; i < count; ++i) {
        ids[i] = any_id();
        locals[i] = p_.transform();
        p_.spoil(locals[i], 60);
        valid = valid && model(ids[i]) && is_valid(locals[i]);
    }
    const bool shared = p_.one_in(8);
    if (shared) valid = is_valid(locals[0]) || count == 0;
    for (uint32_t i = 0; shared && i < count; ++i) valid = valid && model(ids[i]);
    const gphys_status status = call(gphys_scene_set_transforms, scene_, ids.data(), locals.data(),
                                     shared ? 0u : static_cast<uint32_t>(sizeof(gphys_transform)), count);
    FUZZ_CHECK(status == GPHYS_OK ? valid : !valid || status == GPHYS_ERROR_INVALID_ARGUMENT,
               "models are moved all or none");
    if (status != GPHYS_OK) return;
    for (uint32_t i = 0; i < count; ++i) model(ids[i])->local = locals[shared ? 0 : i];
    follow_parents();
}

void World::set_parent() {
    const gphys_model_id id = any_id(), parent = any_id();
    const int32_t keep_world = static_cast<int32_t>(p_.below(20) ? p_.below(2) : 2);
    const gphys_status status = call(gphys_scene_set_parent, scene_, id, parent, keep_world);
    const bool valid = model(id) && (parent == 0 || model(parent)) && keep_world < 2;
    const bool cycle = valid && is_below(parent, id);
    if (cycle) FUZZ_CHECK(status == GPHYS_ERROR_CYCLE, "no model becomes its own ancestor");
    FUZZ_CHECK(status == GPHYS_OK ? valid && !cycle : !valid || cycle || status == GPHYS_ERROR_INVALID_ARGUMENT,
               "parents are set exactly where the arguments are valid");
    if (status != GPHYS_OK) return;
    Model& m = *model(id);
    m.parent = parent;
    const gphys_transform before = m.world;
    read_locals();
    if (!keep_world) return;
    FUZZ_CHECK(parent ? is_kept(before, m.world, model(parent)->world) : same_bits(before, m.world),
               "a world transform is kept");
}

void World::set_properties() {
    const gphys_model_id id = any_id();
    const uint32_t layers = p_.one_in(10) ? 0 : 1u << p_.below(3), tag = p_.byte();
    const gphys_status status = call(gphys_scene_set_layers, scene_, id, layers);
    FUZZ_CHECK(status == (model(id) ? GPHYS_OK : GPHYS_ERROR_INVALID_ID), "only models have layers");
    call(gphys_scene_set_tag, scene_, id, tag);
    if (status != GPHYS_OK) return;
    model(id)->layers = layers;
    model(id)->tag = tag;
}

void World::set_shape() {
    const gphys_model_id id = any_id();
    AnyShape shape = p_.shape(p_.shape_type(p_.one_in(40)));
    p_.spoil(shape, 40);
    const bool is_mesh = p_.one_in(4);
    const uint32_t which = p_.below(3);
    if (is_mesh) shape.type = GPHYS_SHAPE_MESH;
    const void* given = is_mesh ? static_cast<const void*>(meshes_[which].get()) : shape.bytes;
    if (p_.one_in(10)) memory_.fail_after(p_.below(3));
    const gphys_status status = call(gphys_scene_set_shape, scene_, id, shape.type, given);
    const bool out_of_memory = memory_.has_failed();
    memory_.never_fail();
    FUZZ_CHECK(status != GPHYS_OK || model(id), "only models have shapes");
    FUZZ_CHECK(status != GPHYS_OK || is_mesh || is_valid(shape), "only valid shapes are set");
    FUZZ_CHECK(status != GPHYS_ERROR_OUT_OF_MEMORY || out_of_memory, "memory is short only where hooks fail");
    if (status != GPHYS_OK) return;
    model(id)->shape = shape;
    model(id)->source = is_mesh ? &sources_[which] : nullptr;
}

gphys_vec3 World::any_scale() {
    const auto factor = [&] {
        return p_.one_in(4)
                   ? 1.0f
                   : std::ldexp(1.0f + static_cast<float>(p_.below(100)) / 64, static_cast<int>(p_.below(12)) - 6);
    };
    gphys_vec3 scale{factor(), factor(), factor()};
    if (p_.one_in(3)) scale.y = scale.z = scale.x;
    return scale;
}

void World::set_scale() {
    const gphys_model_id id = any_id();
    const uint64_t before = scene_hash();
    gphys_vec3 scale = any_scale(), is{};
    if (p_.one_in(20)) scale.y = static_cast<float>(p_.hostile());
    if (p_.one_in(10)) memory_.fail_after(p_.below(3));
    const gphys_status status = call(gphys_scene_set_scale, scene_, id, &scale);
    const bool out_of_memory = memory_.has_failed();
    memory_.never_fail();
    FUZZ_CHECK(status != GPHYS_OK || model(id), "only models have scales");
    FUZZ_CHECK(status != GPHYS_ERROR_OUT_OF_MEMORY || out_of_memory, "memory is short only where hooks fail");
    FUZZ_CHECK(status == GPHYS_OK || scene_hash() == before, "a scale that is refused changes nothing");
    if (status != GPHYS_OK) return;
    FUZZ_CHECK(call(gphys_scene_get_scale, scene_, id, &is) == GPHYS_OK && std::memcmp(&is, &scale, sizeof is) == 0,
               "a scale is read as it was set");
    FUZZ_CHECK(call(gphys_scene_validate, scene_) == GPHYS_OK, "a scene with a scale is sound");
    gphys_ray rays[8];
    gphys_hit hits[8], hit{};
    for (gphys_ray& ray : rays) ray = p_.ray();
    if (call(gphys_scene_raycast_batch, scene_, rays, uint32_t{sizeof rays[0]}, 8u, 7u, hits,
             uint32_t{sizeof hits[0]}) == GPHYS_OK) {
        for (int i = 0; i < 8; ++i) {
            const bool met = call(gphys_scene_raycast, scene_, &rays[i], 7u, &hit) == GPHYS_OK;
            FUZZ_CHECK(met == (hits[i].model != 0) && (!met || std::memcmp(&hit, &hits[i], sizeof hit) == 0),
                       "scaled models are met alike by a ray and by a batch");
        }
    }
    const std::vector<uint32_t> words = scene_snapshot(0);
    gphys_scene* copy = nullptr;
    uint32_t hash[2] = {};
    FUZZ_CHECK(
        call(gphys_scene_create, nullptr, &copy) == GPHYS_OK &&
            call(gphys_scene_restore, copy, scene_, words.data(), static_cast<uint32_t>(words.size())) == GPHYS_OK &&
            call(gphys_scene_get_hash, copy, hash) == GPHYS_OK && (uint64_t{hash[1]} << 32 | hash[0]) == scene_hash(),
        "scales are in snapshots");
    gphys_scene_destroy(copy);
    gphys_vec3& kept = model(id)->scale;
    if (p_.one_in(3)) {
        FUZZ_CHECK(call(gphys_scene_set_scale, scene_, id, &kept) == GPHYS_OK && scene_hash() == before,
                   "with the scale that it had a model is what it was");
        return;
    }
    kept = scale;
}

void World::set_scene_origin() {
    double origin[3] = {p_.number(), p_.number(), p_.number()};
    if (p_.one_in(20)) origin[p_.below(3)] = p_.hostile();
    double before[3], after[3];
    call(gphys_scene_get_origin, scene_, before);
    const gphys_status status = call(gphys_scene_set_origin, scene_, origin);
    call(gphys_scene_get_origin, scene_, after);
    const double* expected = status == GPHYS_OK ? origin : before;
    FUZZ_CHECK(std::equal(expected, expected + 3, after), "an origin is set, or kept on an error");
    if (camera_ && status == GPHYS_OK) call(gphys_camera_set_origin, camera_, origin);
    if (solver_ && status == GPHYS_OK) move_solver_origin(origin);
    read_locals();
}

void World::inspect_scene() {
    FUZZ_CHECK(call(gphys_scene_validate, scene_) == GPHYS_OK, "a scene is sound");
    if (models_.size() % 8 == 7) {
        const gphys_status status = call(gphys_scene_rebuild_octree, scene_);
        FUZZ_CHECK(status == GPHYS_OK || status == GPHYS_ERROR_OUT_OF_MEMORY, "an octree is built anew");
        FUZZ_CHECK(call(gphys_scene_validate, scene_) == GPHYS_OK, "a scene is sound after its octree was built anew");
    }
    if (models_.size() % 8 == 3) {
        int32_t done = 7;
        const gphys_status status = call(gphys_scene_maintain_octree, scene_, p_.below(2000), &done);
        FUZZ_CHECK(status == GPHYS_OK || (status == GPHYS_ERROR_OUT_OF_MEMORY && done == 7), "an octree is maintained");
        FUZZ_CHECK(call(gphys_scene_validate, scene_) == GPHYS_OK, "a scene is sound after its octree was maintained");
    }
    if (models_.size() % 16 == 5) {
        const uint32_t wanted = 1 + static_cast<uint32_t>(models_.size() / 16) % 3;
        uint32_t before = 0, workers = 0;
        call(gphys_scene_get_worker_count, scene_, &before);
        const gphys_status status = call(gphys_scene_set_worker_count, scene_, wanted);
        FUZZ_CHECK(status == GPHYS_OK || status == GPHYS_ERROR_OUT_OF_MEMORY, "a scene takes any number of threads");
        call(gphys_scene_get_worker_count, scene_, &workers);
        FUZZ_CHECK(workers == (status == GPHYS_OK ? wanted : before), "the number of threads is as it was set");
    }
    uint32_t total = 0;
    std::vector<gphys_model_id> ids(models_.size() + 1);
    const uint32_t capacity = p_.one_in(3) ? p_.below(4) : static_cast<uint32_t>(models_.size());
    const gphys_status listed = call(gphys_scene_get_models, scene_, capacity ? ids.data() : nullptr,
                                     std::min<uint32_t>(capacity, ids.size()), &total);
    FUZZ_CHECK(total == models_.size(), "a scene has the models that were added");
    FUZZ_CHECK(listed == (total > capacity ? GPHYS_INCOMPLETE : GPHYS_OK), "a list that is cut short says so");
    for (uint32_t i = 0; i < std::min(total, capacity); ++i) {
        FUZZ_CHECK(ids[i] == models_[i].id, "models are listed by id");
    }
    call(gphys_scene_get_roots, scene_, nullptr, 0u, &total);
    FUZZ_CHECK(total == std::count_if(models_.begin(), models_.end(), [](const Model& m) { return m.parent == 0; }),
               "models without a parent are the roots");
    for (const Model& m : models_) {
        FUZZ_CHECK(call(gphys_scene_has, scene_, m.id) == GPHYS_OK, "a scene has the models that were added");
        gphys_model_info info;
        call(gphys_scene_get_info, scene_, m.id, &info);
        note(info);
        const auto is_child = [&](const Model& other) { return other.parent == m.id; };
        FUZZ_CHECK(info.type == m.shape.type && info.parent == m.parent && info.layers == m.layers && info.tag == m.tag,
                   "a model is what it was made");
        FUZZ_CHECK(info.child_count == std::count_if(models_.begin(), models_.end(), is_child),
                   "a model counts its children");
        std::vector<gphys_model_id> children(models_.size() + 1);
        uint32_t children_count = 0;
        call(gphys_scene_get_children, scene_, m.id, children.data(), static_cast<uint32_t>(models_.size()),
             &children_count);
        children.resize(children_count);
        FUZZ_CHECK(children.size() == info.child_count && std::is_sorted(children.begin(), children.end()) &&
                       std::all_of(children.begin(), children.end(),
                                   [&](gphys_model_id child) { return model(child) && model(child)->parent == m.id; }),
                   "a model lists its children");
        gphys_transform local, world;
        call(gphys_scene_get_transforms, scene_, &m.id, 1u, &local, static_cast<uint32_t>(sizeof local));
        call(gphys_scene_get_world_transforms, scene_, &m.id, 1u, &world, static_cast<uint32_t>(sizeof world));
        note(world);
        FUZZ_CHECK(same_bits(local, m.local), "a model stands where it was put");
        FUZZ_CHECK(same_bits(world, m.world), "a model follows its parents");
        AnyShape shape;
        const gphys_status copied =
            call(gphys_scene_get_shape, scene_, m.id, static_cast<void*>(shape.bytes), uint32_t{sizeof shape.bytes});
        FUZZ_CHECK(copied == (m.source ? GPHYS_ERROR_UNSUPPORTED : GPHYS_OK), "shapes are returned, but for meshes");
        FUZZ_CHECK(m.source || std::memcmp(shape.bytes, m.shape.bytes, m.shape.size) == 0,
                   "a model has the shape that it was given");
        gphys_mesh* mesh = nullptr;
        const gphys_status held = call(gphys_scene_get_mesh, scene_, m.id, &mesh);
        FUZZ_CHECK(held == (m.source ? GPHYS_OK : GPHYS_ERROR_UNSUPPORTED) && (held == GPHYS_OK) == (mesh != nullptr),
                   "a model of a mesh gives a handle of it");
        if (mesh) {
            gphys_mesh_info about;
            call(gphys_mesh_get_info, mesh, &about);
            FUZZ_CHECK(about.vertex_count == m.source->vertices().size() &&
                           about.triangle_count == m.source->triangles() && about.follows_body == 0,
                       "a model has the mesh that it was given");
            call(gphys_mesh_destroy, mesh);
        }
        Output<gphys_aabb> box;
        const gphys_status bounded = call(gphys_scene_get_bounds, scene_, m.id, &box.value);
        box.after(bounded);
        FUZZ_CHECK(bounded == (m.shape.type == GPHYS_SHAPE_PLANE ? GPHYS_UNBOUNDED : GPHYS_OK),
                   "all models but planes have bounds");
    }
    for (const gphys_model_id id : stale_) {
        if (p_.one_in(4))
            FUZZ_CHECK(call(gphys_scene_has, scene_, id) == GPHYS_ERROR_INVALID_ID, "a stale id stays so");
    }
    gphys_octree_stats stats;
    call(gphys_scene_get_octree_stats, scene_, &stats);
    FUZZ_CHECK(stats.item_count + stats.unbounded_count == models_.size(), "a tree holds all models");
    std::vector<gphys_octree_box> boxes(stats.node_count + 1);
    call(gphys_scene_get_octree_boxes, scene_, boxes.data(), stats.node_count, &total);
    Output<gphys_aabb> box;
    box.after(call(gphys_scene_get_scene_bounds, scene_, &box.value));
}

void World::misuse_scene() {
    const gphys_model_id id = any_id();
    const gphys_transform local = p_.transform();
    gphys_model_desc desc{};
    desc.struct_size = p_.byte();
    gphys_model_id out = 0;
    gphys_aabb box;
    gphys_transform transform;
    uint32_t total = 0;
    const gphys_sphere ball{{0, 0, 0}, 1};
    const gphys_shape_type sphere = GPHYS_SHAPE_SPHERE;
    const double nowhere[3] = {0, 1e300, 0};
    gphys_scene* none = nullptr;
    uint32_t words[8] = {};
    const gphys_status refused[] = {
        call(gphys_scene_get_snapshot, none, 0, words, 8u, &total),
        call(gphys_scene_get_snapshot, scene_, 2, words, 8u, &total),
        call(gphys_scene_get_snapshot, scene_, 0, nullptr, 8u, &total),
        call(gphys_scene_get_snapshot, scene_, 0, words, 8u, nullptr),
        call(gphys_scene_restore, none, none, words, 8u),
        call(gphys_scene_restore, scene_, none, words, 8u),
        call(gphys_scene_restore, scene_, none, nullptr, 8u),
        call(gphys_scene_get_hash, none, words),
        call(gphys_scene_get_hash, scene_, nullptr),
        call(gphys_scene_add, none, sphere, &ball, &local, nullptr, &out),
        call(gphys_scene_add, scene_, sphere, nullptr, &local, nullptr, &out),
        call(gphys_scene_add, scene_, gphys_shape_type{GPHYS_SHAPE_RAY}, &ball, &local, nullptr, &out),
        call(gphys_scene_add, scene_, sphere, &ball, &local, nullptr, nullptr),
        call(gphys_scene_add_batch, scene_, sphere, &ball, 0u, nullptr, 0u, 2u, nullptr, nullptr),
        call(gphys_scene_add_batch, scene_, gphys_shape_type{GPHYS_SHAPE_MESH}, meshes_[0].get(), 8u, nullptr, 0u, 2u,
             nullptr, &out),
        call(gphys_scene_add_described_batch, scene_, sphere, &ball, 0u, nullptr, 0u, nullptr, 0u, 2u, nullptr),
        call(gphys_scene_remove, none, id),
        call(gphys_scene_remove_batch, scene_, nullptr, 2u),
        call(gphys_scene_remove_subtree, none, id),
        call(gphys_scene_clear, none),
        call(gphys_scene_rebuild_octree, none),
        call(gphys_scene_maintain_octree, scene_, 1u, nullptr),
        call(gphys_scene_set_worker_count, scene_, 1025u),
        call(gphys_scene_get_worker_count, scene_, nullptr),
        call(gphys_scene_get_models, scene_, nullptr, 3u, &total),
        call(gphys_scene_get_info, scene_, id, nullptr),
        call(gphys_scene_get_shape, scene_, id, static_cast<void*>(&box), 3u),
        call(gphys_scene_get_mesh, scene_, id, nullptr),
        call(gphys_mesh_get_info, nullptr, nullptr),
        call(gphys_scene_get_bounds, scene_, id, nullptr),
        call(gphys_scene_get_scene_bounds, none, &box),
        call(gphys_scene_set_layers, none, id, 1u),
        call(gphys_scene_set_tag, none, id, 1u),
        call(gphys_scene_set_parent, none, id, id, 0),
        call(gphys_scene_set_transform, scene_, id, nullptr),
        call(gphys_scene_set_transforms, scene_, &id, nullptr, 32u, 1u),
        call(gphys_scene_get_transforms, scene_, &id, 1u, &transform, 30u),
        call(gphys_scene_get_world_transforms, scene_, nullptr, 1u, &transform, 32u),
        call(gphys_scene_set_origin, scene_, nowhere),
        call(gphys_scene_get_origin, scene_, nullptr),
        call(gphys_scene_validate, none),
        call(gphys_scene_get_octree_stats, scene_, nullptr),
        call(gphys_scene_get_octree_boxes, scene_, nullptr, 4u, nullptr),
        call(gphys_scene_create, nullptr, nullptr),
        call(gphys_scene_desc_init, nullptr, 32u)};
    for (const gphys_status status : refused) FUZZ_CHECK(status < 0, "a call that makes no sense is refused");
    if (desc.struct_size < offsetof(gphys_model_desc, scale)) {
        FUZZ_CHECK(call(gphys_scene_add, scene_, sphere, &ball, &local, &desc, &out) == GPHYS_ERROR_STRUCT_SIZE,
                   "a desc that is smaller than that of 1.0 is refused");
    }
}

}  // namespace fuzz
