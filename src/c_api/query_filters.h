// Reading the filters of queries: one, one for all items of a batch, or one for each.
#pragma once

#include "c_api/api.h"
#include "scene/scene.h"

namespace gphys {

/// `out` has the defaults, which null stands for.
gphys_status read_filter(const Scene& scene, const gphys_query_filter_desc* filter, QueryFilter& out) noexcept;

/// Of a batch, as the caller has them: those of single items are read when their turn comes.
class Filters {
public:
    /// One for all, with a stride of 0 or null, is read here; others are to be checked, each once.
    gphys_status read(const Scene& scene, const gphys_query_filter_desc* filters, uint32_t stride) noexcept;
    bool is_one() const { return stride_ == 0; }
    gphys_status check(uint32_t item) const noexcept;

    // `room` is for what is read.

    const QueryFilter& of(uint32_t item, QueryFilter& room) const noexcept;
    RayFilters of(const uint32_t* items, uint32_t count, QueryFilter* room) const noexcept;

private:
    gphys_status read_known_of(uint32_t item, gphys_query_filter_desc& known) const noexcept;

    const Scene* scene_ = nullptr;
    const char* first_ = nullptr;
    size_t stride_ = 0;
    QueryFilter one_;
};

}  // namespace gphys
