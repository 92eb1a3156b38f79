#!/usr/bin/env python3
"""The study with Dask: dask_study.py RESULT [--poses N] [--times N] [--side N] [--workers N | --scheduler ADDRESS]

The town is built once and sent to the workers as a snapshot; what moves is sent once for each time. The units go to the
workers as they become free. What a worker was doing when it died is given to another. Records are
written to their place in the result file as they come; a file that was begun is gone on with.
"""
import argparse
import os
import sys
import time

import numpy as np
from distributed import Client, LocalCluster, as_completed

import study


def missing(path, poses, times):
    """The units that the file does not have, and where their records go."""
    size = poses * times * study.RECORD.itemsize
    with open(path, "ab") as file:
        file.truncate(size)
    done = np.fromfile(path, study.RECORD)["done"] == 1
    for unit in study.units(poses, times):
        first = unit[0] * poses + unit[1]
        if not done[first:first + unit[2]].all():
            yield unit, first * study.RECORD.itemsize


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("result")
    parser.add_argument("--poses", type=int, default=100)
    parser.add_argument("--times", type=int, default=20)
    parser.add_argument("--side", type=int, default=64)
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--scheduler", help="of a cluster that runs; without it there is one of this machine")
    parser.add_argument("--kill-one", action="store_true", help="kill a worker on the way, to see that nothing is lost")
    options = parser.parse_args()
    work = list(missing(options.result, options.poses, options.times))

    cluster = options.scheduler or LocalCluster(n_workers=options.workers, threads_per_worker=1, processes=True,
                                                dashboard_address=None)
    with Client(cluster) as client, open(options.result, "r+b") as file:
        client.upload_file(study.__file__)  # the workers need nothing but the gamephys package
        start = time.monotonic()
        town = client.submit(study.town)  # by one worker; the others get what it returns, and another if it dies
        times = sorted({unit[0] for unit, _ in work})
        places = dict(zip(times, client.map(study.traffic, times, retries=3)))
        futures = client.map(study.do, [unit for unit, _ in work], [places[unit[0]] for unit, _ in work],
                             town=town, side=options.side, retries=3, pure=False)
        place = dict(zip((future.key for future in futures), (offset for _, offset in work)))
        victim = None
        for count, (future, records) in enumerate(as_completed(futures, with_results=True), 1):
            file.seek(place[future.key])
            file.write(records)
            future.release()
            if options.kill_one and victim is None and count * 3 >= len(work):
                victim = next(iter(client.run(os.getpid).values()))
                os.kill(victim, 9)
                print(f"killed worker {victim}", file=sys.stderr)
            if count % 8 == 0:
                passed = time.monotonic() - start
                print(f"{100 * count / len(work):5.1f} %, {passed * (len(work) - count) / count:.0f} s to go", file=sys.stderr)
        print(f"{len(work)} units in {time.monotonic() - start:.2f} s")
    if not options.scheduler:
        cluster.close()


if __name__ == "__main__":
    main()
