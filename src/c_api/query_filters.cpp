#include "c_api/query_filters.h"

#include <algorithm>

namespace gphys {

namespace {

constexpr gphys_query_filter_desc default_filter{
    sizeof(gphys_query_filter_desc), GPHYS_ALL_LAYERS, 0, 0, nullptr, 0, 0};
constexpr size_t filter_desc_size = sizeof(gphys_query_filter_desc);  // of release 1.1

gphys_status check_known(const gphys_query_filter_desc& known) noexcept {
    if (known.reserved != 0) return newer_desc();
    GPHYS_REQUIRE((known.flags & ~uint32_t{GPHYS_FILTER_SUBTREE}) == 0, "filter.flags: has an unknown bit");
    GPHYS_REQUIRE(known.ignored_models || known.ignored_count == 0, "filter.ignored_models is null");
    return GPHYS_OK;
}

QueryFilter filter_of(const Scene& scene, const gphys_query_filter_desc& known) {
    return scene.query_filter(known.layers, known.ignored_model, (known.flags & GPHYS_FILTER_SUBTREE) != 0,
                              IgnoredIds(known.ignored_models, known.ignored_count));
}

}  // namespace

gphys_status read_filter(const Scene& scene, const gphys_query_filter_desc* filter, QueryFilter& out) noexcept {
    if (!filter) return GPHYS_OK;
    // That of a client of this release is read where it is: to copy it costs as much as some models do.
    gphys_query_filter_desc copy;
    if (filter->struct_size != sizeof *filter) {
        copy = default_filter;
        GPHYS_TRY(read_desc(filter, copy, filter_desc_size));
        filter = &copy;
    }
    GPHYS_TRY(check_known(*filter));
    out = filter_of(scene, *filter);
    return GPHYS_OK;
}

gphys_status Filters::read(const Scene& scene, const gphys_query_filter_desc* filters, uint32_t stride) noexcept {
    GPHYS_TRY(check_stride("filter_stride", stride, filter_desc_size));
    scene_ = &scene;
    first_ = reinterpret_cast<const char*>(filters);
    stride_ = filters ? stride : 0;
    return is_one() ? read_filter(scene, filters, one_) : GPHYS_OK;
}

gphys_status Filters::read_known_of(uint32_t item, gphys_query_filter_desc& known) const noexcept {
    known = default_filter;
    GPHYS_TRY(read_desc_element(first_ + item * stride_, stride_, known, filter_desc_size,
                                "filter_stride: below the struct_size of a filter"));
    return check_known(known);
}

gphys_status Filters::check(uint32_t item) const noexcept {
    gphys_query_filter_desc known;
    return read_known_of(item, known);
}

const QueryFilter& Filters::of(uint32_t item, QueryFilter& room) const noexcept {
    if (is_one()) return one_;
    gphys_query_filter_desc known;
    // It has been checked; if the caller has spoiled it since then, nothing is seen.
    if (read_known_of(item, known) == GPHYS_OK) {
        room = filter_of(*scene_, known);
    } else {
        room.layers = 0;
    }
    return room;
}

RayFilters Filters::of(const uint32_t* items, uint32_t count, QueryFilter* room) const noexcept {
    if (is_one()) return {&one_, 0};
    for (uint32_t i = 0; i < count; ++i) of(items[i], room[i]);
    return {room, 1};
}

}  // namespace gphys

using namespace gphys;

gphys_status gphys_query_filter_desc_init(gphys_query_filter_desc* desc, uint32_t size) {
    return guarded([&] { return write_desc(desc, size, default_filter, filter_desc_size); });
}
