#!/usr/bin/env bash
# Times the library and others beside it.
#   ./bench.sh                     the quick report, a part of the work in about five minutes: build/bench/report.md.
#                                  The same with --report --quick
#   ./bench.sh --report            the report in full, about an hour: docs/report.md, its figures and the README's table,
#                                  and what was measured in docs/accuracy.md, docs/solver.md and docs/solver_figures.md.
#                                  An interrupted run goes on where it was
#   ./bench.sh SUITE...            of scene mesh query update accuracy batches solver: build/bench/<suite>.csv with a
#                                  plot beside each, the machine's description and ratios.md
#   ./bench.sh energy              energy over a million steps, beside the book's integrators: build/bench/energy.csv and
#                                  the figure docs/images/energy, which is the same on every machine
# and with suites: --peers measures Embree, Bullet, FCL and nanoflann in the same run (a report always does); --quick is
# a few seconds of smaller work. The batches suite fails if a batch of rays takes longer than single calls.
# Installs what it needs and builds with the flags that users get.
set -euo pipefail
cd "$(dirname "$0")"

if [ "${1:-}" = energy ] && [ $# -eq 1 ]; then
    source cmake/install_packages.sh
    install_packages g++ cmake ninja-build libbenchmark-dev python3 python3-matplotlib
    cmake -S . -B build/release -G Ninja -DCMAKE_BUILD_TYPE=Release -DGAMEPHYS_BENCH=ON
    cmake --build build/release --target gamephys_bench_energy
    mkdir -p build/bench
    build/release/bench/gamephys_bench_energy build/bench/energy.csv
    /usr/bin/python3 bench/figures/energy.py build/bench/energy.csv docs/images/energy
    exit
fi

usage="usage: ./bench.sh [--report] [--quick], ./bench.sh energy, or ./bench.sh [scene mesh query update accuracy batches solver] [--peers] [--quick]"
report=
readme=()
peers=OFF
arguments=()
suites=()
solver=OFF
batches=OFF
[ $# -gt 0 ] || set -- --report --quick
for argument in "$@"; do
    case $argument in
        --peers) peers=ON ;;
        --report) report=docs/report.md ;;
        --quick) arguments+=("$argument") ;;
        scene | mesh | query | update | accuracy) suites+=("$argument") ;;
        solver) solver=ON ;;
        batches) batches=ON ;;
        --help | -h)
            sed -n '2,/^set /s/^# //p' "${0##*/}"
            exit
            ;;
        *)
            echo "$usage" >&2
            exit 2
            ;;
    esac
done

if [ -n "$report" ]; then
    if [ ${#suites[@]} -gt 0 ] || [ $peers$solver$batches != OFFOFFOFF ]; then
        echo "$usage" >&2
        exit 2
    fi
    peers=ON
    # What belongs to the repository is written by full runs only.
    if [ ${#arguments[@]} -gt 0 ]; then report=build/bench/report.md; else readme=(README.md); fi
fi

source cmake/install_packages.sh
packages=(g++ cmake ninja-build libbenchmark-dev python3)
if [ -n "$report" ]; then packages+=(python3-matplotlib); else packages+=(gnuplot-nox); fi
peer_packages=(libembree-dev libbullet-dev libfcl-dev libnanoflann-dev)
[ $peers = ON ] && packages+=(pkg-config "${peer_packages[@]}")
install_packages "${packages[@]}"

cmake -S . -B build/release -G Ninja -DCMAKE_BUILD_TYPE=Release -DGAMEPHYS_TESTS=OFF -DGAMEPHYS_EXAMPLES=OFF \
    -DGAMEPHYS_BENCH=ON -DGAMEPHYS_BENCH_PEERS=$peers
cmake --build build/release --target gamephys_bench gamephys_bench_batches gamephys_bench_solver
mkdir -p build/bench
describe_machine() {
    # Virtual machines shorten the name: family and model tell the generation.
    awk -F': *' -v machine="$(uname -m)" -v cores="$(nproc)" '
        /^processor/ && seen++ { exit }
        /^model name/ { name = $2 } /^cpu family/ { family = $2 } /^model\t/ { model = $2 } /^flags/ { flags = $2 " " }
        END {
            set = flags ~ /avx512f / ? ", AVX-512" : flags ~ /avx2 / ? ", AVX2" : ""
            print "Processor: " (name ? name : machine) (family ? " (family " family ", model " model set ")" : "") ", " cores " cores"
        }' /proc/cpuinfo
    echo "Compiler: $(c++ --version | head -n 1)"
    [ $peers = OFF ] || echo "Peers: $(dpkg-query -W -f '${source:Package} ${source:Upstream-Version}, ' "${peer_packages[@]}" | sed 's/, $//')"
    echo "Date: $(date -u +%F)"
    case " ${arguments[*]} " in *" --quick "*) echo "Work: a part, by --quick" ;; esac
}

if [ -n "$report" ]; then
    work=build/bench/report${arguments[0]:-}
    mkdir -p "$work"
    describe_machine | tee "$work/machine.txt"
    python3 bench/run_report.py build/release/bench "$work" "${arguments[@]}"
    /usr/bin/python3 bench/make_report.py "$work" "$report" "$(dirname "$report")/images" "${readme[@]}"
    if [ ${#readme[@]} -gt 0 ]; then
        python3 bench/accuracy.py "$work" docs/accuracy_scores.csv docs/accuracy.md
        python3 bench/report.py "$work" --docs-solver >docs/solver_figures.md
        python3 bench/solver_comparison.py "$work" docs/solver.md
    fi
    echo "the report: $report"
    exit
fi

rm -f build/bench/*.csv
describe_machine | tee build/bench/machine.txt
if [ ${#suites[@]} -gt 0 ] || [ $solver$batches = OFFOFF ]; then
    build/release/bench/gamephys_bench --out=build/bench "${suites[@]}" "${arguments[@]}"
fi

# A plot of each suite, time against n, a line for each implementation and case; but of accuracy, which the report draws.
accuracy=build/bench/accuracy.csv
for csv in build/bench/*.csv; do
    [ -e "$csv" ] || continue # of the solver alone
    [ "$csv" != $accuracy ] || continue
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

# Batches beside single calls: a table.
slower=0
if [ $batches = ON ]; then
    build/release/bench/gamephys_bench_batches --out=build/bench "${arguments[@]}" || slower=1
fi

# Work and precision of solvers: stretch against the time of a frame, a picture a case.
if [ $solver = ON ]; then
    build/release/bench/gamephys_bench_solver --out=build/bench "${arguments[@]}"
    gnuplot - <<PLOT
csv = "build/bench/solver.csv"
set terminal pngcairo size 800,480 noenhanced
set logscale xy
set format y "%.0e"
set key outside
set grid
set xlabel "ms per frame"
do for [case in system("awk -F, 'NR>1 && \$6>0 {print \$2}' ".csv." | uniq")] {
    set output "build/bench/solver_".case.".png"
    set title case
    set ylabel case eq "chain_30" ? "distance from the reference, m" : "largest stretch"
    column = case eq "chain_30" ? 9 : 6
    methods = system("awk -F, -v c=".case." '\$2==c {print \$3}' ".csv." | uniq")
    plot for [m in methods] sprintf("< awk -F, '\$2==\"%s\" && \$3==\"%s\" {print \$5, \$%d}' %s", case, m, column, csv) \
        using 1:2 with linespoints lw 2 title m
}
PLOT
fi

python3 bench/report.py build/bench | tee build/bench/ratios.md
ls build/bench
exit $slower
