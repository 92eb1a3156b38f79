// How a batch is shared among a scene's workers: cut into chunks of fixed size, each item answered
// into its own place. The bits do not depend on who answers what.
#pragma once

#include <algorithm>
#include <atomic>

#include "c_api/api.h"
#include "c_api/query_filters.h"
#include "c_api/shape_input.h"
#include "foundation/compiler.h"
#include "foundation/image_tiles.h"
#include "foundation/results.h"
#include "foundation/strided.h"
#include "scene/scene.h"

namespace gphys {

/// Items that are handed out at once. 256 rays take about 0.1 ms: a thousand times what handing out
/// costs, and a thousandth of a batch that is worth sharing.
constexpr uint32_t batch_chunk = 256;

inline uint32_t chunks_in(uint32_t count) { return count / batch_chunk + (count % batch_chunk != 0); }

/// visit(begin, end) for chunks of 0 .. count - 1, of at least so many: as few as keep all workers busy to the end,
/// as what is neighbouring in memory is best read and written by one.
template <class Visit>
void for_each_chunk(const Workers& workers, uint32_t count, uint32_t smallest, Visit&& visit) {
    const uint32_t size = std::clamp(count / (32 * workers.count()), smallest, 64 * smallest);
    workers.run(count / size + (count % size != 0), [&](uint32_t chunk) {
        const uint32_t begin = chunk * size;
        visit(begin, begin + std::min(size, count - begin));
    });
}

/// answer(i) for each item; it writes the output of item i.
template <class Answer>
void answer_each(const Workers& workers, uint32_t count, Answer&& answer) {
    for_each_chunk(workers, count, batch_chunk, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) answer(i);
    });
}

/// Rays by tiles: cast(rays, items, size) for each, with the items that the rays are of. ray_of(item, ray) is false
/// where there is no ray; fetch(item) fetches what is read and written of one.
template <class RayOf, class Fetch, class Cast>
void cast_by_tiles(const Scene& scene, const ImageTiles& tiles, RayOf&& ray_of, Fetch&& fetch, Cast&& cast) {
    static_assert(ImageTiles::most <= Scene::rays_at_once);
    constexpr uint32_t smallest = batch_chunk / ImageTiles::most;
    for_each_chunk(scene.workers(), tiles.count(), smallest, [&](uint32_t begin, uint32_t end) {
        tiles.for_each(begin, end, fetch, [&](const uint32_t* all, uint32_t all_size) {
            Ray rays[ImageTiles::most];
            uint32_t items[ImageTiles::most], size = 0;
            for (uint32_t k = 0; k < all_size; ++k) {
                items[size] = all[k];
                if (ray_of(all[k], rays[size])) ++size;
            }
            cast(rays, items, size);
        });
    });
}

/// cast(first, count, by) for the rays of a tile, which are of some items: `by` is the layers or their filters.
template <class Cast>
void cast_by(uint32_t layers, const uint32_t*, uint32_t count, const Cast& cast) {
    cast(0, count, layers);
}
template <class Cast>
void cast_by(const Filters& filters, const uint32_t* items, uint32_t count, const Cast& cast) {
    QueryFilter room[most_ray_filters];
    const uint32_t at_once = filters.is_one() ? count : most_ray_filters;
    for (uint32_t first = 0; first < count; first += at_once) {
        const uint32_t some = std::min(at_once, count - first);
        cast(first, some, filters.of(items + first, some, room));
    }
}

/// The first hits of many rays, those of elements that are near one another by their first `floats`; ray_of(element,
/// ray) is false where there is no ray, and no hit. Who is uint32_t, for layers, or Filters.
template <class T, class Who, class RayOf>
void raycast_each(const Scene& scene, const Strided<T>& in, uint32_t floats, uint32_t count, const Who& who,
                  const StridedOut<gphys_hit>& out, RayOf&& ray_of) {
    const ImageTiles tiles(in.template beginnings<float>(), floats, count);
    const auto ray_or_no_hit = [&](uint32_t i, Ray& ray) {
        if (ray_of(in[i], ray)) return true;
        out[i] = no_hit;
        return false;
    };
    cast_by_tiles(scene, tiles, ray_or_no_hit, prefetch_elements(in, out),
                  [&](Ray* rays, const uint32_t* items, uint32_t size) {
                      gphys_hit* hits[ImageTiles::most];
                      for (uint32_t k = 0; k < size; ++k) {
                          hits[k] = &out[items[k]];
                          *hits[k] = no_hit;
                      }
                      cast_by(who, items, size, [&](uint32_t first, uint32_t some, const auto& by) {
                          scene.raycast_many(rays + first, some, by, hits + first);
                      });
                  });
}

/// How many elements of an array there are to check: a stride of 0 repeats one.
inline uint32_t distinct(uint32_t stride, uint32_t count) { return stride == 0 ? std::min(count, 1u) : count; }

/// check(i) for each item. Returns the status of the first that is not GPHYS_OK; that one is
/// checked once more, on this thread, where its message belongs.
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

/// a + b, or the largest number if that is less.
inline uint32_t saturated_sum(uint32_t a, uint32_t b) { return b > UINT32_MAX - a ? UINT32_MAX : a + b; }

/// The lists of items begin .. end - 1 behind one another; ends[i] is where that of item i ends.
template <class T, class Less, class ListAll>
void list_chunk(T* out, uint32_t capacity, uint32_t begin, uint32_t end, uint32_t* ends, ListAll&& list_all) {
    uint32_t total = 0;
    list_all(begin, end, [&](uint32_t i, const auto& add_all) {
        const uint32_t used = std::min(total, capacity);
        Smallest<T, Less> list(capacity == 0 ? nullptr : out + used, capacity - used);
        add_all(list);
        total = saturated_sum(total, list.finish());
        ends[i] = total;
    });
}

/// Many lists behind one another: list_all(begin, end, list_of) makes those of items begin .. end - 1, in
/// order, by list_of(i, add_all) with add_all(list), which adds what there is of item i. How long a list gets is known
/// only when it is there, and queries allocate nothing: so the room that is left is dealt out in equal shares to a wave
/// of chunks, and their lists are moved together afterwards. Where a share was too small, the rest of the wave is
/// listed again, by this thread and in place.
template <class T, class Less, class ListAll>
gphys_status concatenate(const Workers& workers, T* out, uint32_t capacity, uint32_t count, uint32_t* out_offsets,
                         ListAll&& list_all) {
    // Long enough that the wait for the last chunk of a wave is a few per cent of it.
    const uint32_t wave = workers.count() == 1 ? 1 : 16 * workers.count();
    uint32_t* const ends = out_offsets + 1;
    uint32_t total = 0;
    out_offsets[0] = 0;
    for (uint32_t first = 0; first < count;) {
        const uint32_t chunks = std::min(wave, chunks_in(count - first));
        const auto begin_of = [&](uint32_t chunk) { return first + std::min(chunk * batch_chunk, count - first); };
        const uint32_t used = std::min(total, capacity), share = (capacity - used) / chunks;
        workers.run(chunks, [&](uint32_t chunk) {
            list_chunk<T, Less>(out + used + chunk * share, share, begin_of(chunk), begin_of(chunk + 1), ends,
                                list_all);
        });
        bool in_place = false;
        for (uint32_t chunk = 0; chunk < chunks; ++chunk) {
            const uint32_t begin = begin_of(chunk), end = begin_of(chunk + 1), place = std::min(total, capacity);
            in_place = in_place || (ends[end - 1] > share && capacity - place > share);
            if (in_place) {
                list_chunk<T, Less>(out + place, capacity - place, begin, end, ends, list_all);
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
