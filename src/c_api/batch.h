// How a batch is shared among a scene's workers: in chunks of items. Each item has its own output element, so the
// results do not depend on which thread handles which chunk.
#pragma once

#include <algorithm>
#include <atomic>
#include <new>

#include "c_api/api.h"
#include "c_api/query_filters.h"
#include "c_api/shape_input.h"
#include "foundation/compiler.h"
#include "foundation/image_tiles.h"
#include "foundation/results.h"
#include "foundation/strided.h"
#include "scene/scene.h"

namespace gphys {

/// Items of a chunk. 256 rays take about 0.1 ms. That is a thousand times the cost of handing out a chunk, and a
/// thousandth of a batch that is worth sharing.
constexpr uint32_t batch_chunk = 256;

/// visit(begin, end) for chunks of 0 .. count - 1 of at least `smallest` items. About 32 chunks for each worker balance
/// the load; more would only make threads share cache lines.
template <class Visit>
void for_each_chunk(const Workers& workers, uint32_t count, uint32_t smallest, Visit&& visit) {
    const uint32_t size = std::clamp(count / (32 * workers.count()), smallest, 64 * smallest);
    workers.run(count / size + (count % size != 0), [&](uint32_t chunk) {
        const uint32_t begin = chunk * size;
        visit(begin, begin + std::min(size, count - begin));
    });
}

/// visit(i) for each item; it writes the output of item i.
template <class Visit>
void for_each_item(const Workers& workers, uint32_t count, Visit&& visit) {
    for_each_chunk(workers, count, batch_chunk, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) visit(i);
    });
}

/// cast(rays, items, size) for each tile: its rays and the items they belong to. ray_of(item, ray) returns false if the
/// item has no ray; fetch(item) prefetches its input and output.
template <class RayOf, class Fetch, class Cast>
void cast_by_tiles(const Scene& scene, const ImageTiles& tiles, RayOf&& ray_of, Fetch&& fetch, Cast&& cast) {
    static_assert(ImageTiles::most <= Scene::rays_at_once);
    constexpr uint32_t smallest = batch_chunk / ImageTiles::most;
    for_each_chunk(scene.workers(), tiles.count(), smallest, [&](uint32_t begin, uint32_t end) {
        tiles.for_each(begin, end, fetch, [&](const uint32_t* all, uint32_t all_size) {
            // Those that are not needed are not initialised: that would take longer than one ray.
            union Rays {
                Rays() {}
                Ray of[ImageTiles::most];
            } rays;
            uint32_t items[ImageTiles::most], size = 0;
            for (uint32_t k = 0; k < all_size; ++k) {
                items[size] = all[k];
                if (ray_of(all[k], *new (&rays.of[size]) Ray)) ++size;
            }
            cast(rays.of, items, size);
        });
    });
}

/// query(first, count, filter) for parts of `items`: with layers once, with filters in groups of max_batch_filters.
template <class Query>
void query_by(uint32_t layers, const uint32_t*, uint32_t count, const Query& query) {
    query(0, count, layers);
}
template <class Query>
void query_by(const Filters& filters, const uint32_t* items, uint32_t count, const Query& query) {
    QueryFilter storage[max_batch_filters];
    const uint32_t at_once = filters.is_one() ? count : max_batch_filters;
    for (uint32_t first = 0; first < count; first += at_once) {
        const uint32_t some = std::min(at_once, count - first);
        query(first, some, filters.of(items + first, some, storage));
    }
}

// What differs between the results of many rays, gphys_hit and gphys_distance.
inline void set_missed(gphys_hit& out) { out = no_hit; }
inline void set_missed(gphys_distance& out) { out = no_distance; }
template <class Who>
void cast_many(const Scene& scene, Ray* rays, uint32_t count, const Who& by, gphys_hit* const* out) {
    scene.raycast_many(rays, count, by, out);
}
template <class Who>
void cast_many(const Scene& scene, Ray* rays, uint32_t count, const Who& by, gphys_distance* const* out) {
    scene.raycast_distance_many(rays, count, by, out);
}

/// The first hits of many rays. Tiles group elements that are near one another in their first `floats` floats.
/// ray_of(element, ray) returns false if the element has no ray, which counts as a miss. Filter is uint32_t, for
/// layers, or Filters.
template <class T, class Filter, class Answer, class RayOf>
void raycast_each(const Scene& scene, const Strided<T>& in, uint32_t floats, uint32_t count, const Filter& filter,
                  const StridedOut<Answer>& out, RayOf&& ray_of) {
    const ImageTiles tiles(in.template beginnings<float>(), floats, count);
    const auto ray_or_no_hit = [&](uint32_t i, Ray& ray) {
        if (ray_of(in[i], ray)) return true;
        set_missed(out[i]);
        return false;
    };
    cast_by_tiles(scene, tiles, ray_or_no_hit, prefetch_elements(in, out),
                  [&](Ray* rays, const uint32_t* items, uint32_t size) {
                      Answer* answers[ImageTiles::most];
                      for (uint32_t k = 0; k < size; ++k) {
                          answers[k] = &out[items[k]];
                          set_missed(*answers[k]);
                      }
                      query_by(filter, items, size, [&](uint32_t first, uint32_t some, const auto& by) {
                          cast_many(scene, rays + first, some, by, answers + first);
                      });
                  });
}

/// The number of distinct elements of an array: a stride of 0 repeats one.
inline uint32_t distinct(uint32_t stride, uint32_t count) { return stride == 0 ? std::min(count, 1u) : count; }

/// check(i) for each item. Returns the status of the first item that is not GPHYS_OK. That item is checked again on
/// this thread, because messages are stored by thread.
template <class Check>
gphys_status check_each(const Workers& workers, uint32_t count, Check&& check) {
    std::atomic<uint32_t> first_bad{count};
    for_each_chunk(workers, count, batch_chunk, [&](uint32_t begin, uint32_t end) {
        uint32_t i = begin;
        while (i < end && check(i) == GPHYS_OK) ++i;
        if (i == end) return;
        uint32_t lowest = first_bad.load(std::memory_order_relaxed);
        while (i < lowest && !first_bad.compare_exchange_weak(lowest, i, std::memory_order_relaxed)) {
        }
    });
    const uint32_t bad = first_bad.load(std::memory_order_relaxed);
    return bad == count ? GPHYS_OK : check(bad);
}

/// a + b, or UINT32_MAX if that overflows.
inline uint32_t saturated_sum(uint32_t a, uint32_t b) { return b > UINT32_MAX - a ? UINT32_MAX : a + b; }

/// The lists of items begin .. end - 1, concatenated; ends[i] is the end of the list of item i.
template <class T, class ListAll>
void list_chunk(T* out, uint32_t capacity, uint32_t begin, uint32_t end, uint32_t* ends, ListAll&& list_all) {
    uint32_t total = 0;
    list_all(begin, end, [&](uint32_t i, const auto& list) {
        const uint32_t used = std::min(total, capacity);
        total = saturated_sum(total, list(capacity == 0 ? nullptr : out + used, capacity - used));
        ends[i] = total;
    });
}

/// list(out, capacity) for list_chunk: the smallest of what add_all(Smallest) adds.
template <class T, class Less, class AddAll>
auto smallest_of(const AddAll& add_all) {
    return [&add_all](T* out, uint32_t capacity) {
        Smallest<T, Less> list(out, capacity);
        add_all(list);
        return list.finish();
    };
}

/// Concatenate the lists of all items. list_all(begin, end, list_of) calls list_of(i, list) for its items in order;
/// list(out, capacity) writes the results of item i and returns their number, and may use the rest of `out`. A chunk
/// has `chunk_size` items.
///
/// The length of a list is known only after its query, and queries do not allocate. So each wave of chunks gets equal
/// shares of the remaining output array, and the lists are moved together afterwards. From the first chunk whose share
/// was too small, the rest of the wave is queried again, in place and on this thread.
template <class T, class ListAll>
gphys_status concatenate(const Workers& workers, uint32_t chunk_size, T* out, uint32_t capacity, uint32_t count,
                         uint32_t* out_offsets, ListAll&& list_all) {
    // 16 chunks for each worker: waiting for the last chunk takes a few per cent of a wave.
    const uint32_t wave = workers.count() == 1 ? 1 : 16 * workers.count();
    uint32_t* const ends = out_offsets + 1;
    uint32_t total = 0;
    out_offsets[0] = 0;
    for (uint32_t first = 0; first < count;) {
        const uint32_t left = count - first;
        const uint32_t chunks = std::min(wave, left / chunk_size + (left % chunk_size != 0));
        const auto begin_of = [&](uint32_t chunk) { return first + std::min(chunk * chunk_size, left); };
        const uint32_t used = std::min(total, capacity), share = (capacity - used) / chunks;
        workers.run(chunks, [&](uint32_t chunk) {
            list_chunk(out + used + chunk * share, share, begin_of(chunk), begin_of(chunk + 1), ends, list_all);
        });
        bool in_place = false;
        for (uint32_t chunk = 0; chunk < chunks; ++chunk) {
            const uint32_t begin = begin_of(chunk), end = begin_of(chunk + 1), place = std::min(total, capacity);
            in_place = in_place || (ends[end - 1] > share && capacity - place > share);
            if (in_place) {
                list_chunk(out + place, capacity - place, begin, end, ends, list_all);
            } else if (const uint32_t listed = used + chunk * share; listed != place) {
                std::copy_n(out + listed, std::min(ends[end - 1], share), out + place);
            }
            for (uint32_t i = begin; i < end; ++i) ends[i] = saturated_sum(total, ends[i]);
            total = ends[end - 1];
        }
        first = begin_of(chunks);
    }
    return total > capacity ? GPHYS_INCOMPLETE : GPHYS_OK;
}

}  // namespace gphys
