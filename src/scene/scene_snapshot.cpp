// Writing and reading snapshots of a scene (scene_snapshot.h), and its hash.
#include "scene/scene_snapshot.h"

#include <algorithm>
#include <cstddef>
#include <functional>

#include "foundation/archive.h"
#include "mesh/mesh_snapshot.h"
#include "scene/scene.h"

namespace gphys {

/// A mesh that models use, identified by its contents.
struct UsedMesh {
    uint32_t hash[2];
    uint32_t vertices, indices;
    uint32_t words;  // of its embedded snapshot; 0: not embedded

    static UsedMesh of(const Mesh& mesh, uint32_t words) {
        return {{static_cast<uint32_t>(mesh.hash()), static_cast<uint32_t>(mesh.hash() >> 32)},
                static_cast<uint32_t>(mesh.vertices().size()),
                static_cast<uint32_t>(mesh.indices().size()),
                words};
    }
};

/// References to meshes, released by the destructor.
class HeldMeshes {
public:
    explicit HeldMeshes(std::pmr::memory_resource* memory) : meshes_(memory) {}
    ~HeldMeshes() {
        for (const Mesh* mesh : meshes_) Mesh::release(mesh);
    }
    HeldMeshes(const HeldMeshes&) = delete;
    HeldMeshes& operator=(const HeldMeshes&) = delete;

    void reserve(uint32_t count) { meshes_.reserve(count); }
    /// Takes over one reference. Memory was reserved before.
    void take(const Mesh* mesh) { meshes_.push_back(mesh); }
    uint32_t size() const { return static_cast<uint32_t>(meshes_.size()); }
    const Mesh* operator[](uint32_t number) const { return meshes_[number]; }

private:
    Vector<const Mesh*> meshes_;
};

namespace {

/// Order by contents; ignores whether they are embedded.
bool operator<(const UsedMesh& a, const UsedMesh& b) { return std::memcmp(&a, &b, offsetof(UsedMesh, words)) < 0; }

using Sizes = SceneSnapshotSizes;
constexpr const char* cut_short = "words: the lengths in it do not add up to count";

/// A model without its place in the world and its shape.
struct ModelWords {
    uint32_t type, layers, tag;
    uint32_t parent;  // slot; ~0: none
    gphys_transform local;
};

/// Numbers distinct meshes in the order of their addition.
class MeshNumbers {
public:
    explicit MeshNumbers(std::pmr::memory_resource* memory) : meshes_(memory), by_address_(memory) {}

    void add(const Mesh* mesh) {
        if (!meshes_.empty() && meshes_.back() == mesh) return;
        const auto place = lower_bound(mesh);
        if (place != by_address_.end() && place->mesh == mesh) return;
        by_address_.insert(place, {mesh, size()});
        meshes_.push_back(mesh);
    }
    uint32_t size() const { return static_cast<uint32_t>(meshes_.size()); }
    const Mesh* operator[](uint32_t number) const { return meshes_[number]; }
    uint32_t number_of(const Mesh* mesh) const {
        return std::lower_bound(by_address_.begin(), by_address_.end(), mesh, before)->number;
    }

private:
    struct Entry {
        const Mesh* mesh;
        uint32_t number;
    };
    static bool before(const Entry& entry, const Mesh* mesh) { return std::less<const Mesh*>()(entry.mesh, mesh); }
    Vector<Entry>::iterator lower_bound(const Mesh* mesh) {
        return std::lower_bound(by_address_.begin(), by_address_.end(), mesh, before);
    }

    Vector<const Mesh*> meshes_;
    Vector<Entry> by_address_;
};

/// The meshes of a scene, searched by contents.
class MeshesByContents {
public:
    MeshesByContents(const MeshNumbers& meshes, std::pmr::memory_resource* memory) : entries_(memory) {
        entries_.reserve(meshes.size());
        for (uint32_t i = 0; i < meshes.size(); ++i) entries_.push_back({UsedMesh::of(*meshes[i], 0), meshes[i]});
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.used < b.used; });
    }
    /// Null if there is none.
    const Mesh* find(const UsedMesh& wanted) const {
        const auto before = [](const Entry& entry, const UsedMesh& used) { return entry.used < used; };
        const auto found = std::lower_bound(entries_.begin(), entries_.end(), wanted, before);
        return found == entries_.end() || wanted < found->used ? nullptr : found->mesh;
    }

private:
    struct Entry {
        UsedMesh used;
        const Mesh* mesh;
    };
    Vector<Entry> entries_;
};

bool is_model_type(uint32_t type) {
    return type == GPHYS_SHAPE_SPHERE || type == GPHYS_SHAPE_CAPSULE || type == GPHYS_SHAPE_AABB ||
           type == GPHYS_SHAPE_OBB || type == GPHYS_SHAPE_PLANE || type == GPHYS_SHAPE_TRIANGLE ||
           type == GPHYS_SHAPE_MESH;
}

bool is_place_in_world(Vec3 place) { return max_component(abs(place)) <= 2 * GPHYS_MAX_COORDINATE; }

}  // namespace

/// All members of a scene that a snapshot replaces, except the BVH.
struct Scene::Contents {
    explicit Contents(Memory* source) : memory(source) {}

    Memory* memory;
    IdTable ids{memory};
    LargeArray<Model> models{memory};
    LargeArray<uint32_t> tags{memory};
    LayerBlocks layer_blocks{memory};
    LargeArray<ShapeTail> shape_tails{memory};
    Pool<Family> families{memory};
    LargeArray<Unscaled> unscaled{memory};
    LargeArray<WorldPlace> places{memory};
    Vector<uint32_t> unbounded{memory};
    Vec3 origin;
    float widest_scale = 1, farthest_point = 0;
    uint32_t common_layers = ~0u, large_mesh_count = 0;
    uint32_t large_meshes[most_large_meshes];
};

void Scene::swap_contents(Contents& other) noexcept {
    std::swap(ids_, other.ids);
    models_.swap(other.models);
    tags_.swap(other.tags);
    layer_blocks_.swap(other.layer_blocks);
    shape_tails_.swap(other.shape_tails);
    std::swap(families_, other.families);
    unscaled_.swap(other.unscaled);
    places_.swap(other.places);
    unbounded_.swap(other.unbounded);
    std::swap(origin_, other.origin);
    std::swap(widest_scale_, other.widest_scale);
    std::swap(farthest_point_, other.farthest_point);
    std::swap(common_layers_, other.common_layers);
    std::swap(large_mesh_count_, other.large_mesh_count);
    std::swap(large_meshes_, other.large_meshes);
}

template <class Visit>
void Scene::for_each_mesh(Visit&& visit) const {
    for (const uint32_t slot : ids_) {
        if (const Mesh* mesh = stored_mesh(slot)) visit(mesh);
    }
}

bool Scene::any_scaled() const {
    for (const uint32_t slot : ids_) {
        if (!is_one(scale_of(slot))) return true;
    }
    return false;
}

/// put_mesh(mesh) writes the reference to a mesh.
template <class Sink, class PutMesh>
void Scene::write_state(Sink& sink, const PutMesh& put_mesh) const {
    Writer<Sink> writer(sink);
    writer.value(origin_);
    IdTable::visit(writer, ids_);
    const bool scaled = any_scaled();
    for (const uint32_t slot : ids_) {
        const Model& model = models_[slot];
        writer.value(ModelWords{model.type_, model.layers, tags_[slot], parent_of(slot), local_of(slot)});
        if (!places_.empty()) {
            const bool placed = slot < places_.size() && parent_of(slot) == none;
            writer.value(placed ? places_[slot].world() : Vec3());
        }
        if (scaled) writer.value(scale_of(slot));
        with_type(model.type(), [&](auto shape) {
            if constexpr (std::is_same_v<decltype(shape), ModelMesh>) {
                put_mesh(stored_mesh(slot));
            } else {
                copy_unscaled_shape(ids_.id(slot), &shape);
                writer.value(shape);
            }
        });
    }
}

void Scene::hash(uint32_t (&out)[2]) const {
    WordHash hash;
    Writer<WordHash> writer(hash);
    write_state(hash, [&](const Mesh* mesh) { writer.value(UsedMesh::of(*mesh, 0)); });
    out[0] = static_cast<uint32_t>(hash.value());
    out[1] = static_cast<uint32_t>(hash.value() >> 32);
}

gphys_status Scene::snapshot(bool embed_meshes, uint32_t* out, uint32_t capacity, uint32_t& total) const {
    MeshNumbers meshes(&memory);
    for_each_mesh([&](const Mesh* mesh) { meshes.add(mesh); });
    Vector<UsedMesh> used(&memory);
    used.reserve(meshes.size());
    uint64_t embedded = 0;
    for (uint32_t i = 0; i < meshes.size(); ++i) {
        uint32_t words = 0;
        if (embed_meshes && meshes[i]->snapshot(nullptr, 0, words) != GPHYS_INCOMPLETE) return GPHYS_ERROR_CAPACITY;
        used.push_back(UsedMesh::of(*meshes[i], words));
        embedded += words;
    }
    const auto put_all = [&](auto& sink) {
        Writer<std::decay_t<decltype(sink)>> writer(sink);
        writer.value(Sizes{meshes.size(), bvh_.node_count(), bvh_.size(), static_cast<uint32_t>(embedded),
                           (places_.empty() ? 0 : has_places) | (any_scaled() ? has_scales : 0)});
        for (const UsedMesh& mesh : used) writer.value(mesh);
        write_state(sink, [&](const Mesh* mesh) { writer.value(meshes.number_of(mesh)); });
    };
    WordCount count;
    put_all(count);
    const uint64_t tree = uint64_t{bvh_.node_count()} + bvh_.size();
    const uint64_t words = snapshot_header_words + count.words + tree + embedded;
    GPHYS_TRY(fit_snapshot(words, capacity, total));

    WordCopy copy{out + snapshot_header_words};
    put_all(copy);
    uint32_t *node = copy.to, *item = copy.to + bvh_.node_count();
    bvh_.visit_layout([&](uint32_t word) { *node++ = word; }, [&](uint32_t slot) { *item++ = slot; });
    uint32_t* next = copy.to + tree;
    for (uint32_t i = 0; embed_meshes && i < meshes.size(); ++i) {
        uint32_t size = 0;
        meshes[i]->snapshot(next, used[i].words, size);
        next += size;
    }
    write_header(out, scene_snapshot_magic, scene_snapshot_format, total, scene_snapshot_checksum(out, total));
    return GPHYS_OK;
}

uint64_t scene_snapshot_checksum(const uint32_t* words, uint32_t count) {
    const uint32_t* const body = words + snapshot_header_words;
    const uint32_t size = count - snapshot_header_words;
    uint32_t embedded = 0;
    constexpr uint32_t place = offsetof(Sizes, embedded_words) / 4;
    if (size > place) std::memcpy(&embedded, body + place, sizeof embedded);
    WordHash hash;
    hash.put(body, embedded <= size ? size - embedded : size);
    return hash.value();
}

namespace {

/// Returns what is wrong, or nullptr.
const char* load_embedded(const uint32_t* words, const UsedMesh& used, Memory& memory, HeldMeshes& meshes) {
    MeshParts parts;
    if (const char* wrong = read_mesh_snapshot(words, used.words, &memory, parts)) return wrong;
    const bool is_same = parts.hash == (uint64_t{used.hash[1]} << 32 | used.hash[0]) &&
                         parts.arrays.vertex_count == used.vertices && parts.arrays.index_count == used.indices;
    if (!is_same) return "words: an embedded mesh is not the one that the models use";
    meshes.take(create<Mesh>(memory.hooks(), parts, false));
    return nullptr;
}

}  // namespace

/// Finds the meshes of a snapshot, in its order: embedded ones, and ones that models of the library use. Returns what
/// is wrong, or nullptr.
const char* Scene::find_meshes(const Vector<UsedMesh>& wanted, const uint32_t* embedded, uint32_t embedded_words,
                               const Scene& library, HeldMeshes& found) {
    const auto is_embedded = [](const UsedMesh& used) { return used.words > 0; };
    MeshNumbers known(&memory);
    if (!std::all_of(wanted.begin(), wanted.end(), is_embedded)) {
        library.for_each_mesh([&](const Mesh* mesh) { known.add(mesh); });
    }
    const MeshesByContents by_contents(known, &memory);
    found.reserve(static_cast<uint32_t>(wanted.size()));
    for (const UsedMesh& used : wanted) {
        if (used.words > embedded_words) return cut_short;
        if (is_embedded(used)) {
            if (const char* wrong = load_embedded(embedded, used, memory, found)) return wrong;
            embedded += used.words;
            embedded_words -= used.words;
            continue;
        }
        const Mesh* mesh = by_contents.find(used);
        if (!mesh) {
            return "words: a mesh is neither embedded nor used by a model of library, or of scene if that is NULL";
        }
        mesh->retain();
        found.take(mesh);
    }
    return embedded_words == 0 ? nullptr : cut_short;
}

/// Reads the models into an empty scene. Returns what is wrong, or nullptr.
const char* Scene::read_models(Reader& reader, const HeldMeshes& meshes, uint32_t parts) {
    reader.value(origin_);
    IdTable::visit(reader, ids_);
    if (!reader.good()) return cut_short;
    if (!(max_component(abs(origin_)) <= GPHYS_MAX_COORDINATE)) return "words: the origin is out of range";
    if (ids_.defect()) return "words: the ids of the models contradict each other";
    const uint32_t slots = ids_.slots();
    models_.resize(slots);
    tags_.resize(slots);
    layer_blocks_.grow(slots);
    const bool placed = (parts & has_places) != 0;
    if (placed) places_.resize(slots);
    Vector<uint32_t> parents(slots, none, &memory);
    for (uint32_t slot = 0; slot < slots; ++slot) {
        if (!ids_.live(slot)) continue;
        ModelWords words{};
        reader.value(words);
        WorldPlace place;
        if (placed) reader.value(place);
        gphys_vec3 scale = no_scale;
        if ((parts & has_scales) != 0) reader.value(scale);
        if (!reader.good()) return cut_short;
        if (!is_model_type(words.type)) return "words: the type of a model is not a gphys_shape_type";
        if (gphys::defect(words.local)) return "words: the local transform of a model is out of range";
        if (!is_place_in_world(place.world())) return "words: the world transform of a model is out of range";
        if (defect_of_scale(scale)) return "words: the scale of a model is out of range";
        reserve_shapes(static_cast<gphys_shape_type>(words.type), !is_one(scale), slots);
        if (placed) places_[slot] = place;
        tags_[slot] = words.tag;
        parents[slot] = words.parent;
        Model& model = models_[slot];
        model.world = words.local;
        model.layers = words.layers;
        layer_blocks_.add(slot, words.layers);
        model.family = no_family;
        common_layers_ &= words.layers;
        const char* wrong = with_type(static_cast<gphys_shape_type>(words.type), [&](auto shape) -> const char* {
            constexpr const char* wrong_scale = "words: the scale of a model does not suit its shape";
            if constexpr (std::is_same_v<decltype(shape), ModelMesh>) {
                uint32_t number = 0;
                reader.value(number);
                if (!reader.good() || number >= meshes.size())
                    return "words: the mesh of a model is not in the snapshot";
                const Mesh* const mesh = meshes[number];
                if (check_scale(*mesh, scale)) return wrong_scale;
                mesh->join(mesh_follower_, &slot, 1);
                model.type_ = words.type;
                store_shape(slot, mesh, scale);
                if (mesh->triangle_count() == 0) common_layers_ = 0;
                return nullptr;
            } else {
                reader.value(shape);
                if (!reader.good()) return cut_short;
                if (gphys::defect(shape)) return "words: the shape of a model is out of range";
                if (check_scale(static_cast<gphys_shape_type>(words.type), &shape, scale)) return wrong_scale;
                model.type_ = words.type;
                store_shape(slot, &shape, scale);
                return nullptr;
            }
        });
        if (wrong) return wrong;
    }
    return link_families(parents);
}

/// Links models to their parents and derives the world transforms; before, Model::world has the local ones. Returns
/// what is wrong, or nullptr.
const char* Scene::link_families(const Vector<uint32_t>& parents) {
    for (uint32_t slot = ids_.slots(); slot-- > 0;) {  // so that lists of children begin with the lowest slot
        if (!ids_.live(slot) || parents[slot] == none) continue;
        if (parents[slot] >= ids_.slots() || !ids_.live(parents[slot]))
            return "words: the parent of a model does not exist";
        const gphys_transform local = models_[slot].world;
        families_.reserve(2);
        link(slot, parents[slot]);
        family(slot).local = local;
    }
    uint32_t reached = 0;
    for (const uint32_t top : ids_) {
        if (parent_of(top) != none) continue;
        for (uint32_t slot = top; slot != none; slot = next_below(slot, top), ++reached) {
            derive_world(slot);
            Box box;
            if (models_[slot].type() == GPHYS_SHAPE_PLANE) {
                if (const char* wrong = check_placement(slot, models_[slot].world, box)) return wrong;
                reserve_more(unbounded_, 1);
                list_unbounded(slot);
            }
            if (models_[slot].type() == GPHYS_SHAPE_MESH) list_large_mesh(slot);
        }
    }
    return reached == ids_.size() ? nullptr : "words: the parents of the models form a cycle";
}

/// Builds the BVH of the models from a layout. Returns what is wrong, or nullptr; on failure the BVH is unchanged.
const char* Scene::build_bvh(const BvhLayout& layout) {
    constexpr const char* wrong_items = "words: the octree does not contain the models";
    if (layout.defect()) return "words: the octree is not valid";
    if (layout.item_count != ids_.size() - unbounded_.size()) return wrong_items;
    Vector<uint8_t> is_item(ids_.slots(), 0, &memory);
    Vector<Box> boxes(layout.item_count, &memory);
    for (uint32_t i = 0; i < layout.item_count; ++i) {
        const uint32_t slot = layout.item(i);
        if (slot >= ids_.slots() || !ids_.live(slot) || is_item[slot] || models_[slot].type() == GPHYS_SHAPE_PLANE) {
            return wrong_items;
        }
        is_item[slot] = 1;
        if (const char* wrong = check_placement(slot, models_[slot].world, boxes[i])) return wrong;
        farthest_point_ = std::max(farthest_point_, farthest_point(slot));
    }
    bvh_.build(layout, boxes.data());
    return nullptr;
}

/// Also for a state that was read only in part: models without an id, or ids without a model.
void Scene::release_meshes() {
    const size_t slots = std::min<size_t>(models_.size(), ids_.slots());
    for (uint32_t slot = 0; slot < slots; ++slot) {
        if (ids_.live(slot)) release_shape(slot);
    }
}

/// Reads the new contents in place of the old ones, so that all member functions apply to them. On an error the old
/// ones are swapped back.
gphys_status Scene::restore(const Scene& library, const uint32_t* words, uint32_t count) {
    const auto reject = [](const char* why) { return fail(GPHYS_ERROR_INVALID_ARGUMENT, why); };
    SnapshotHeader header;
    if (const char* wrong = read_header(words, count, scene_snapshot_magic, 1, scene_snapshot_format, header)) {
        return reject(wrong);
    }
    if (!header.has_checksum(scene_snapshot_checksum(words, count)))
        return reject("words: the checksum is not that of the contents");
    Sizes sizes{};
    Reader all(words + snapshot_header_words, count - snapshot_header_words);
    all.value(sizes);
    const uint64_t behind = uint64_t{sizes.nodes} + sizes.items + sizes.embedded_words;
    const uint64_t before = snapshot_header_words + sizeof sizes / 4;
    if (!all.good() || before + behind > count || sizes.parts > (has_places | has_scales)) return reject(cut_short);
    Reader reader(words + before, static_cast<size_t>(count - before - behind));
    const uint32_t* const nodes = words + (count - behind);
    const BvhLayout layout{nodes, sizes.nodes, nodes + sizes.nodes, sizes.items};

    if (sizes.meshes > (count - before) / (sizeof(UsedMesh) / 4)) return reject(cut_short);
    Vector<UsedMesh> wanted(sizes.meshes, &memory);
    for (UsedMesh& mesh : wanted) reader.value(mesh);
    if (!reader.good()) return reject(cut_short);
    HeldMeshes meshes(&memory);
    if (const char* wrong =
            find_meshes(wanted, nodes + sizes.nodes + sizes.items, sizes.embedded_words, library, meshes)) {
        return reject(wrong);
    }

    Contents old(&memory);
    swap_contents(old);
    const auto restore_old = [&] {
        release_meshes();
        swap_contents(old);
    };
    try {
        const char* wrong = read_models(reader, meshes, sizes.parts);
        if (!wrong && !reader.finished()) wrong = cut_short;
        if (!wrong) wrong = build_bvh(layout);
        if (wrong) {
            restore_old();
            return reject(wrong);
        }
    } catch (...) {
        restore_old();
        throw;
    }
    swap_contents(old);
    release_meshes();
    swap_contents(old);
    return GPHYS_OK;
}

}  // namespace gphys
