// Which blocks of consecutive slots have models of a layer. The BVH knows no layers: with this, queries find the models
// of a rare layer without it (scene_nearest.cpp).
//
// For each block and layer, the models are counted, so that the layers of a block are known exactly after a removal,
// too, without a look at its other models. The union of a block's layers is stored separately: a search for a layer
// reads four bytes a block.
#pragma once

#include <algorithm>

#include "foundation/large_array.h"

namespace gphys {

/// The number of models in each of the 32 layers, up to 127. Bit-sliced: bit l of a word is a binary digit of the
/// number for layer l, so a model is counted in all of its layers at once.
class alignas(32) LayerCounts {
public:
    void add(uint32_t layers) {
        for (uint32_t& digit : digits_) {
            const uint32_t carry = digit & layers;
            digit ^= layers;
            layers = carry;
        }
    }
    void remove(uint32_t layers) {
        for (uint32_t& digit : digits_) {
            const uint32_t borrow = ~digit & layers;
            digit ^= layers;
            layers = borrow;
        }
    }
    /// Those with a model.
    uint32_t layers() const {
        uint32_t all = 0;
        for (const uint32_t digit : digits_) all |= digit;
        return all;
    }
    /// The number of models in the layers: exact for one layer; of several, not less than that of any.
    uint32_t estimate(uint32_t layers) const {
        uint32_t number = 0;
        for (uint32_t d = 0; d < digits; ++d) number += uint32_t{(digits_[d] & layers) != 0} << d;
        return number;
    }
    bool operator==(const LayerCounts& other) const { return std::equal(digits_, digits_ + digits, other.digits_); }

private:
    static constexpr uint32_t digits = 7;
    uint32_t digits_[digits] = {};  // the lowest digit first
};

class LayerBlocks {
public:
    static constexpr uint32_t block_slots = 64;

    explicit LayerBlocks(Memory* memory) : layers_(memory), counts_(memory) {}

    void reserve(uint32_t slots) {
        layers_.reserve(blocks_for(slots));
        counts_.reserve(blocks_for(slots));
    }
    /// Makes the blocks of slots below `slots` exist. Their memory may then be used without failure.
    void grow(size_t slots) {
        const size_t blocks = blocks_for(slots);
        if (blocks <= layers_.size()) return;
        reserve_more(layers_, blocks - layers_.size());
        reserve_more(counts_, blocks - counts_.size());
        layers_.resize(blocks, 0);
        counts_.resize(blocks, {});
    }
    /// No slot has a model.
    void clear() {
        std::fill(layers_.begin(), layers_.end(), 0);
        std::fill(counts_.begin(), counts_.end(), LayerCounts());
    }
    void add(uint32_t slot, uint32_t layers) {
        counts_[slot / block_slots].add(layers);
        layers_[slot / block_slots] |= layers;
    }
    void remove(uint32_t slot, uint32_t layers) {
        LayerCounts& counts = counts_[slot / block_slots];
        counts.remove(layers);
        layers_[slot / block_slots] = counts.layers();
    }
    void swap(LayerBlocks& other) noexcept {
        layers_.swap(other.layers_);
        counts_.swap(other.counts_);
    }

    uint32_t size() const { return static_cast<uint32_t>(layers_.size()); }
    const LayerCounts& counts(uint32_t block) const { return counts_[block]; }
    /// visit(block) for each block with a model in one of the layers, until it returns false; returns whether it has
    /// not.
    template <class Visit>
    bool for_each(uint32_t layers, Visit&& visit) const {
        constexpr uint32_t at_once = 8;
        const uint32_t* const of_block = layers_.data();
        for (uint32_t first = 0; first < size(); first += at_once) {
            const uint32_t end = std::min(first + at_once, size());
            uint32_t all = 0;
            for (uint32_t block = first; block < end; ++block) all |= of_block[block];
            if ((all & layers) == 0) continue;
            for (uint32_t block = first; block < end; ++block) {
                if ((of_block[block] & layers) != 0 && !visit(block)) return false;
            }
        }
        return true;
    }
    /// Whether these are the models of a block.
    bool agrees(uint32_t block, const LayerCounts& counts) const {
        return counts_[block] == counts && layers_[block] == counts.layers();
    }

private:
    static constexpr size_t blocks_for(size_t slots) { return (slots + block_slots - 1) / block_slots; }

    LargeArray<uint32_t> layers_;  // by block
    LargeArray<LayerCounts> counts_;
};

}  // namespace gphys
