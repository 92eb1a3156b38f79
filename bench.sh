#!/usr/bin/env bash
# Times the library: ./bench.sh [scene mesh query update] [--peers] [--quick]
# Installs what it needs, builds with the flags that users get, writes build/bench/<suite>.csv with
# a plot beside each and the machine's description. --peers measures Embree, Bullet and FCL in the same
# run; --quick is a few seconds of smaller work.
set -euo pipefail
cd "$(dirname "$0")"

peers=OFF
arguments=()
for argument in "$@"; do
    case $argument in
        --peers) peers=ON ;;
        --quick | scene | mesh | query | update) arguments+=("$argument") ;;
        *)
            echo "usage: ./bench.sh [scene mesh query update] [--peers] [--quick]" >&2
            exit 2
            ;;
    esac
done

source cmake/install_packages.sh
packages=(g++ cmake ninja-build libbenchmark-dev gnuplot-nox)
[ $peers = ON ] && packages+=(pkg-config libembree-dev libbullet-dev libfcl-dev)
install_packages "${packages[@]}"

cmake -S . -B build/release -G Ninja -DCMAKE_BUILD_TYPE=Release -DGAMEPHYS_TESTS=OFF -DGAMEPHYS_EXAMPLES=OFF \
    -DGAMEPHYS_BENCH=ON -DGAMEPHYS_BENCH_PEERS=$peers
cmake --build build/release --target gamephys_bench
mkdir -p build/bench
{
    grep -m1 'model name' /proc/cpuinfo || uname -m
    echo "$(nproc) cores, $(c++ --version | head -n 1), $(date -u +%F)"
} | tee build/bench/machine.txt
build/release/bench/gamephys_bench --out=build/bench "${arguments[@]}"

# One plot a suite: time against n, a line for each implementation and case.
for csv in build/bench/*.csv; do
    gnuplot - <<PLOT
set terminal pngcairo size 1200,800
set output "${csv%.csv}.png"
set datafile separator ","
set logscale xy
set key outside
set xlabel "objects"
set ylabel "ns per operation"
set title "$(basename "${csv%.csv}")"
rows = system("awk -F, 'NR>1 && \$6==\"ns\" {print \$2\"/\"\$3}' $csv | sort -u")
plot for [row in rows] sprintf("< awk -F, -v OFS=, -v r=%s '\$2\"/\"\$3==r {print \$4,\$5}' $csv", row) using 1:2 \
    with linespoints title row noenhanced
PLOT
done
ls build/bench
