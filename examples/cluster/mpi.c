/* mpi RESULT [--poses N] [--times N] [--side N]: the study with MPI. Process 0 builds the town and sends it to all,
 * once, as a snapshot; what moves, each process reads from process 0's memory when it comes to another time. Each
 * process takes the next unit from a counter that all share, and writes its records to their place in the one result
 * file. There is no process that only hands out work, and no order. A file that was begun is continued: what is done in
 * it stays. */
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study.h"

static uint32_t option(int argc, char** argv, const char* name, uint32_t otherwise) {
    for (int i = 2; i + 1 < argc; ++i) {
        if (strcmp(argv[i], name) == 0) return (uint32_t)strtoul(argv[i + 1], NULL, 10);
    }
    return otherwise;
}

static int is_done(MPI_File file, const study* s, uint32_t unit, record* records) {
    MPI_Status status;
    int count;
    MPI_File_read_at(file, (MPI_Offset)unit_first(s, unit) * (MPI_Offset)sizeof *records, records,
                     (int)(unit_size(s, unit) * sizeof *records), MPI_BYTE, &status);
    MPI_Get_count(&status, MPI_BYTE, &count);
    if (count != (int)(unit_size(s, unit) * sizeof *records)) return 0;
    for (uint32_t i = 0; i < unit_size(s, unit); ++i) {
        if (records[i].done != 1) return 0;
    }
    return 1;
}

static void share_town(town* t, int rank) {
    if (rank == 0) town_build(t);
    MPI_Bcast(&t->word_count, 1, MPI_UINT32_T, 0, MPI_COMM_WORLD);
    if (rank != 0) t->words = malloc(t->word_count * sizeof *t->words);
    if (!t->words) MPI_Abort(MPI_COMM_WORLD, 1);
    MPI_Bcast(t->words, (int)t->word_count, MPI_UINT32_T, 0, MPI_COMM_WORLD);
    MPI_Bcast(t->vehicles, VEHICLES, MPI_UINT32_T, 0, MPI_COMM_WORLD);
}

int main(int argc, char** argv) {
    MPI_Init(&argc, &argv);
    int rank, size;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    if (argc < 2) {
        if (rank == 0) fprintf(stderr, "usage: mpi RESULT [--poses N] [--times N] [--side N]\n");
        MPI_Finalize();
        return 2;
    }
    study s = {.poses = option(argc, argv, "--poses", 100),
               .times = option(argc, argv, "--times", 20),
               .side = option(argc, argv, "--side", 64)};
    const uint32_t units = study_units(&s);
    const double start = MPI_Wtime();
    town t = {0, NULL, {0}};
    share_town(&t, rank);
    study_create(&s, &t);
    free(t.words);

    MPI_File file;
    if (MPI_File_open(MPI_COMM_WORLD, argv[1], MPI_MODE_CREATE | MPI_MODE_RDWR, MPI_INFO_NULL, &file) != MPI_SUCCESS) {
        fprintf(stderr, "mpi: %s cannot be written\n", argv[1]);
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    MPI_File_set_size(file, (MPI_Offset)s.poses * s.times * (MPI_Offset)sizeof(record)); /* what is new is 0 */

    uint32_t* next;
    traffic* log; /* of all times, in process 0 */
    MPI_Win window, log_window;
    MPI_Win_allocate(rank == 0 ? sizeof *next : 0, sizeof *next, MPI_INFO_NULL, MPI_COMM_WORLD, &next, &window);
    MPI_Win_allocate(rank == 0 ? (MPI_Aint)(s.times * sizeof *log) : 0, sizeof *log, MPI_INFO_NULL, MPI_COMM_WORLD,
                     &log, &log_window);
    if (rank == 0) {
        *next = 0;
        for (uint32_t time = 0; time < s.times; ++time) traffic_at(time, &log[time]);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Win_lock_all(0, window);
    MPI_Win_lock_all(0, log_window);

    static traffic now;
    record records[BLOCK];
    uint32_t unit = 0, mine = 0, known_time = UINT32_MAX;
    const uint32_t one = 1;
    for (;;) {
        MPI_Fetch_and_op(&one, &unit, MPI_UINT32_T, 0, 0, MPI_SUM, window);
        MPI_Win_flush(0, window);
        if (unit >= units) break;
        if (is_done(file, &s, unit, records)) continue;
        const uint32_t time = unit / study_blocks(&s);
        if (time != known_time) {
            MPI_Get(&now, sizeof now, MPI_BYTE, 0, (MPI_Aint)time, sizeof now, MPI_BYTE, log_window);
            MPI_Win_flush(0, log_window);
            known_time = time;
        }
        study_do(&s, unit, &now, records);
        MPI_File_write_at(file, (MPI_Offset)unit_first(&s, unit) * (MPI_Offset)sizeof *records, records,
                          (int)(unit_size(&s, unit) * sizeof *records), MPI_BYTE, MPI_STATUS_IGNORE);
        ++mine;
        if (rank == 0 && mine % 8 == 0) {
            const double passed = MPI_Wtime() - start;
            fprintf(stderr, "%5.1f %%, %.0f s to go\n", 100.0 * unit / units, passed * (units - unit) / (unit + 1));
        }
    }
    MPI_Win_unlock_all(log_window);
    MPI_Win_unlock_all(window);
    MPI_Win_free(&log_window);
    MPI_Win_free(&window);
    MPI_File_close(&file);
    study_destroy(&s);
    printf("process %d of %d: %u of %u units\n", rank, size, mine, units);
    const double seconds = MPI_Wtime() - start;
    if (rank == 0) printf("%d processes: %.2f s\n", size, seconds);
    MPI_Finalize();
    return 0;
}
