// Reading what a caller gives as a filter: layers, or gphys_query_filter_desc, one for a query, one for all items of a
// batch, or one for each.
#pragma once

#include <type_traits>

#include "c_api/api.h"
#include "c_api/handles.h"
#include "scene/scene.h"

namespace gphys {

/// The descs of a batch: null, or with a stride of 0 one for all items.
struct FilterArray {
    const gphys_query_filter_desc* descs;
    uint32_t stride;
};

/// The filters of a batch. Filters of single items are read from the caller's array when they are used.
class Filters {
public:
    /// A single filter (null, or stride 0) is read here. Others must be checked, each once, before they are used.
    gphys_status read(const gphys_scene* scene, const gphys_query_filter_desc* filters, uint32_t stride,
                      uint32_t count) noexcept;
    bool is_one() const { return stride_ == 0; }
    gphys_status check(uint32_t item) const noexcept;

    // `storage` receives the filter.

    const QueryFilter& of(uint32_t item, QueryFilter& storage) const noexcept;
    BatchFilters of(const uint32_t* items, uint32_t count, QueryFilter* storage) const noexcept;

private:
    gphys_status read_desc_of(uint32_t item, gphys_query_filter_desc& desc) const noexcept;

    const Scene* scene_ = nullptr;
    const char* first_ = nullptr;
    size_t stride_ = 0;
    QueryFilter one_;
};

/// What a query takes for what its caller gave: layers, a desc (of which null stands for the defaults), or a
/// FilterArray.
template <class Given>
using FilterFrom = std::conditional_t<std::is_same_v<Given, uint32_t>, uint32_t,
                                      std::conditional_t<std::is_pointer_v<Given>, QueryFilter, Filters>>;

/// Fails, too, if the scene is null.
inline gphys_status read_filter(const gphys_scene* scene, uint32_t layers, uint32_t& out) noexcept {
    GPHYS_REQUIRE_POINTERS(scene);
    out = layers;
    return GPHYS_OK;
}
gphys_status read_filter(const gphys_scene* scene, const gphys_query_filter_desc* filter, QueryFilter& out) noexcept;

}  // namespace gphys
