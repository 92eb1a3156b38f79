#!/usr/bin/env bash
# examples/cluster/run.sh [poses times side]: the study with 1, 2 and 4 processes, by Dask and by MPI. All result files
# must be the same, also where a worker was killed on the way. Installs what it needs.
set -euo pipefail
cd "$(dirname "$0")/../.."
source cmake/install_packages.sh
install_packages g++ cmake ninja-build openmpi-bin libopenmpi-dev python3-numpy python3-distributed
here=$PWD/examples/cluster
study=(--poses "${1:-100}" --times "${2:-20}" --side "${3:-64}")

cmake -S . -B build/release -G Ninja -DCMAKE_BUILD_TYPE=Release -DGAMEPHYS_EXAMPLES=ON >/dev/null
cmake --build build/release --target gamephys cluster_mpi
export GAMEPHYS_LIBRARY=$PWD/build/release/libgamephys.so.1 PYTHONPATH=$PWD/bindings/python LD_LIBRARY_PATH=$PWD/build/release
work=$PWD/build/cluster
rm -rf "$work"
mkdir -p "$work"
mpi=(mpirun --oversubscribe)
[ "$(id -u)" -ne 0 ] || mpi+=(--allow-run-as-root)

for count in 1 2 4; do
    echo "== MPI, $count processes"
    "${mpi[@]}" -n $count build/release/examples/cluster_mpi "$work/mpi$count" "${study[@]}" 2>"$work/mpi$count.log"
    echo "== Dask, $count processes"
    /usr/bin/python3 "$here/dask_study.py" "$work/dask$count" "${study[@]}" --workers $count 2>"$work/dask$count.log"
done

echo "== Dask, one of 2 workers killed"
/usr/bin/python3 "$here/dask_study.py" "$work/dask_killed" "${study[@]}" --workers 2 --kill-one 2>"$work/dask_killed.log"
grep 'killed worker' "$work/dask_killed.log"

# MPI ends all processes when one dies; started again, the study goes on where it was.
echo "== MPI, one of 2 processes killed, then started again"
"${mpi[@]}" -n 2 build/release/examples/cluster_mpi "$work/mpi_killed" "${study[@]}" >"$work/mpi_killed.log" 2>&1 &
until [ -s "$work/mpi_killed" ] && victim=$(pgrep -f "cluster_mpi $work/mpi_killed" | tail -n 1) && [ -n "$victim" ]; do sleep 0.02; done
kill -9 "$victim" 2>/dev/null || true
wait $! && echo "it was done before it could be killed" || echo "killed process $victim"
"${mpi[@]}" -n 2 build/release/examples/cluster_mpi "$work/mpi_killed" "${study[@]}" 2>>"$work/mpi_killed.log"

cd "$work"
sha256sum mpi1 mpi2 mpi4 mpi_killed dask1 dask2 dask4 dask_killed
[ "$(sha256sum mpi[124] mpi_killed dask[124] dask_killed | cut -d' ' -f1 | sort -u | wc -l)" -eq 1 ] || {
    echo "the results differ" >&2
    exit 1
}
