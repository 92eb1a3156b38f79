// Consistency check of a scene, for gphys_scene_validate and the tests. Derives again what is stored, and compares.
#include <algorithm>
#include <cstring>

#include "scene/scene.h"

namespace gphys {
namespace {

bool same_bits(const gphys_transform& a, const gphys_transform& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

const char* Scene::defect() const {
    if (const char* wrong = ids_.defect()) return wrong;
    if (const char* wrong = bvh_.defect()) return wrong;
    if (ids_.slots() > models_.size() || ids_.slots() > tags_.size()) return "there are more slots than models";

    uint32_t bounded = 0, unbounded = 0, families = 0, linked_children = 0, counted_children = 0;
    for (uint32_t slot = 0; slot < ids_.slots(); ++slot) {
        if (!ids_.live(slot)) {
            if (bvh_.contains(slot)) return "the bvh holds a removed model";
            continue;
        }
        const Model& model = models_[slot];
        if (model.moving || model.carried) return "a mark of a move was left behind";

        if (common_layers_ & ~model.layers) return "a model is not in the layers common to all";
        Box box;
        if (check_placement(slot, model.world, box)) return "a model stands where the scene cannot hold it";
        const bool is_plane = model.type() == GPHYS_SHAPE_PLANE;
        if (is_plane == bvh_.contains(slot)) return "a model is not where queries look for it";
        if (is_plane) {
            const uint32_t position = model.shape[position_in_list];
            if (position >= unbounded_.size() || unbounded_[position] != slot)
                return "an unbounded model is not listed";
            ++unbounded;
        } else {
            const Box held = bvh_.box(slot);
            if (!std::equal(held.min, held.min + 3, box.min) || !std::equal(held.max, held.max + 3, box.max)) {
                return "the bvh holds an old box";
            }
            ++bounded;
        }

        if (!model.has_family()) continue;
        ++families;
        const Family& record = family(slot);
        if (record.parent == none && record.first_child == none) return "a model without relatives keeps a record";
        const gphys_transform expected =
            record.parent == none ? record.local : composed(models_[record.parent].world, record.local);
        if (!same_bits(model.world, expected)) return "a world transform does not follow from its parent's";
        if (record.parent != none) ++linked_children;
        uint32_t previous = none, children = 0;
        for (uint32_t child = record.first_child; child != none; child = family(child).next) {
            if (!ids_.live(child) || !models_[child].has_family()) return "a child does not exist";
            if (family(child).parent != slot) return "a child has another parent";
            if (family(child).previous != previous) return "children are not linked both ways";
            if (++children > record.child_count) return "children are miscounted";
            previous = child;
        }
        if (children != record.child_count) return "children are miscounted";
        counted_children += children;
    }
    if (bounded != bvh_.size()) return "the bvh holds more than the models";
    if (unbounded != unbounded_.size()) return "the list of unbounded models holds more than them";
    if (families != families_.size()) return "records of families are miscounted";
    if (linked_children != counted_children) return "a child is missing from its parent's list";

    for (uint32_t first = 0; first < ids_.slots(); first += LayerBlocks::block_slots) {
        LayerCounts counts;
        for (uint32_t slot = first; slot < std::min(first + LayerBlocks::block_slots, ids_.slots()); ++slot) {
            if (ids_.live(slot)) counts.add(models_[slot].layers);
        }
        if (!layer_blocks_.agrees(first / LayerBlocks::block_slots, counts)) return "layers are miscounted";
    }

    // Models of a cycle are not reached from any root.
    uint32_t reached = 0;
    for (const uint32_t slot : ids_) {
        if (parent_of(slot) != none) continue;
        for (uint32_t below = slot; below != none; below = next_below(below, slot)) ++reached;
    }
    if (reached != ids_.size()) return "models form a cycle";
    return nullptr;
}

}  // namespace gphys
