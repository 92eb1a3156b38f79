// Reads and checks gphys_query_filter_desc (query_filters.h).
#include "c_api/query_filters.h"

namespace gphys {
namespace {

constexpr gphys_query_filter_desc default_filter{
    sizeof(gphys_query_filter_desc), GPHYS_ALL_LAYERS, 0, 0, nullptr, 0, 0};
constexpr size_t filter_desc_size = sizeof(gphys_query_filter_desc);  // of release 1.1

gphys_status check(const gphys_query_filter_desc& desc) noexcept {
    if (desc.reserved != 0) return newer_desc();
    constexpr uint32_t known = GPHYS_FILTER_SUBTREE | GPHYS_FILTER_NO_BACK_FACES | GPHYS_FILTER_NO_FRONT_FACES;
    GPHYS_REQUIRE_IN_RANGE((desc.flags & ~known) == 0, "filter.flags", desc.flags, "a combination of GPHYS_FILTER_...");
    GPHYS_REQUIRE(desc.ignored_models || desc.ignored_count == 0, "filter.ignored_models is null");
    return GPHYS_OK;
}

QueryFilter filter_of(const Scene& scene, const gphys_query_filter_desc& desc) {
    QueryFilter filter = scene.query_filter(desc.layers, desc.ignored_model, (desc.flags & GPHYS_FILTER_SUBTREE) != 0,
                                            IgnoredIds(desc.ignored_models, desc.ignored_count));
    filter.faces = {(desc.flags & GPHYS_FILTER_NO_FRONT_FACES) == 0, (desc.flags & GPHYS_FILTER_NO_BACK_FACES) == 0};
    return filter;
}

}  // namespace

gphys_status read_filter(const gphys_scene* scene, const gphys_query_filter_desc* filter, QueryFilter& out) noexcept {
    GPHYS_REQUIRE_POINTERS(scene);
    if (!filter) return GPHYS_OK;
    // A desc of this release is read in place: a copy takes as long as testing a few models.
    gphys_query_filter_desc copy;
    if (filter->struct_size != sizeof *filter) {
        copy = default_filter;
        GPHYS_TRY(read_desc(filter, copy, filter_desc_size));
        filter = &copy;
    }
    GPHYS_TRY(check(*filter));
    out = filter_of(*unwrap(scene), *filter);
    return GPHYS_OK;
}

gphys_status Filters::read(const gphys_scene* scene, const gphys_query_filter_desc* filters, uint32_t stride,
                           uint32_t count) noexcept {
    GPHYS_REQUIRE_POINTERS(scene);
    GPHYS_TRY(check_stride("filter_stride", stride, filter_desc_size, count));
    scene_ = unwrap(scene);
    first_ = reinterpret_cast<const char*>(filters);
    stride_ = filters ? stride : 0;
    return is_one() ? read_filter(scene, filters, one_) : GPHYS_OK;
}

gphys_status Filters::read_desc_of(uint32_t item, gphys_query_filter_desc& desc) const noexcept {
    desc = default_filter;
    GPHYS_TRY(read_desc_element(first_ + item * stride_, "filter_stride", stride_, desc, filter_desc_size));
    return gphys::check(desc);
}

gphys_status Filters::check(uint32_t item) const noexcept {
    gphys_query_filter_desc desc;
    return read_desc_of(item, desc);
}

const QueryFilter& Filters::of(uint32_t item, QueryFilter& storage) const noexcept {
    if (is_one()) return one_;
    gphys_query_filter_desc desc;
    // Valid when it was checked. If another thread has made it invalid since, the query finds nothing.
    if (read_desc_of(item, desc) == GPHYS_OK) {
        storage = filter_of(*scene_, desc);
    } else {
        storage.layers = 0;
    }
    return storage;
}

BatchFilters Filters::of(const uint32_t* items, uint32_t count, QueryFilter* storage) const noexcept {
    if (is_one()) return {&one_, 0};
    for (uint32_t i = 0; i < count; ++i) of(items[i], storage[i]);
    return {storage, 1};
}

}  // namespace gphys

using namespace gphys;

gphys_status gphys_query_filter_desc_init(gphys_query_filter_desc* desc, uint32_t size) {
    return guarded(__func__, [&] { return write_desc(desc, size, default_filter, filter_desc_size); });
}
