/* Where cloth ends: its edges of one triangle only. */
#include <stdlib.h>

#include "window.h"

uint32_t* cloth_rim(const uint32_t* indices, uint32_t index_count, uint32_t point_count, uint32_t* out_count) {
    /* The ends of the edges that begin at each point, one point after the other. */
    uint32_t* first = calloc(point_count + 2, sizeof *first);
    uint32_t* ends = malloc((index_count + 1) * sizeof *ends);
    uint32_t* rim = malloc((2 * index_count + 1) * sizeof *rim);
    if (!first || !ends || !rim) exit(1);
    for (uint32_t i = 0; i < index_count; ++i) ++first[indices[i] + 2];
    for (uint32_t k = 2; k < point_count + 2; ++k) first[k] += first[k - 1];
    for (uint32_t i = 0; i < index_count; ++i) ends[first[indices[i] + 1]++] = indices[i % 3 < 2 ? i + 1 : i - 2];

    uint32_t count = 0;
    for (uint32_t from = 0; from < point_count; ++from) {
        for (uint32_t e = first[from]; e < first[from + 1]; ++e) {
            const uint32_t to = ends[e];
            uint32_t back = first[to];
            while (back < first[to + 1] && ends[back] != from) ++back;
            if (back < first[to + 1]) continue;
            rim[count++] = from;
            rim[count++] = to;
        }
    }
    free(first);
    free(ends);
    *out_count = count;
    return rim;
}
