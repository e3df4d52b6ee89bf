#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Measures again what README and planners/README.md quote, into tests/bench/results/*.csv.
#   bash tests/bench/run.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
. cmake/packages.sh
need $toolchain catch2 libbenchmark-dev gnuplot-nox
build release -DBANKSHOT_TESTS=ON -DBANKSHOT_BENCH=ON
bin=build/release/tests out=tests/bench/results
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for what in simulate solve mathavan; do
  case $what in
    simulate) filter='^(simulate|locked)' ;;
    solve) filter='^(rolling|ideal|spin)_' ;;
    *) filter="^$what" ;;
  esac
  "$bin/bench/bench" --benchmark_filter="$filter" --benchmark_format=csv --benchmark_repetitions=5 \
    --benchmark_report_aggregates_only=true 2>/dev/null >"$out/$what.csv"
done
# Every puzzle has a shot. A failure is shown (on standard error) and counted; it does not stop the measuring, but
# the script ends with 1.
header=yes failed=0
measure() {
  "$bin/stress" --csv "$@" >"$scratch/measured.csv" || failed=1
  if [ $header = yes ]; then cat "$scratch/measured.csv"; else tail -n +2 "$scratch/measured.csv"; fi
  header=no
}
{
  measure --count 100000 --physics ideal
  measure --count 100000 --physics rolling
  measure --count 1000000 --physics spin
  measure --count 100000 --physics mathavan
} >"$out/stress.csv"
# What is missed is the measurement here too: the families that ctest does not run are not clean yet.
header=yes before=$failed
for physics in spin rolling; do
  for family in $("$bin/stress" --family list | tail -n +5 | cut -d' ' -f1); do
    [ "$physics/$family" = rolling/spin-range ] || measure --count 1000 --physics $physics --family "$family" 2>"build/families-$physics-$family.log"
  done
done >"$out/families.csv"
failed=$before
# Some two hours of one core: the brute force takes 0.1 to 1 s a puzzle.
{
  "$bin/best" --count 20000 --physics spin --free nothing --no-force --worst 0
  "$bin/best" --count 20000 --physics rolling --free nothing --no-force --worst 0 --no-header
  for free in nothing window arrive spin both; do "$bin/best" --count 1000 --seed 2 --free $free --worst 0 --no-header; done
  for free in nothing window arrive; do "$bin/best" --count 1000 --seed 2 --physics rolling --free $free --worst 0 --no-header; done
} >"$out/best.csv"
"$bin/shots" --count 1000000 --seed 1 --truth 10000 --csv >"$out/shots.csv" || failed=1
header=yes
for planner in auto image sweep ceres nlopt-bobyqa nlopt-direct; do
  # What these miss is the measurement, in a column of its own: not every planner looks for parts of pockets.
  before=$failed
  measure --count 2000 --seed 2 --physics rolling --family uniform --planner $planner 2>"build/planners-rolling-$planner.log"
  failed=$before
done >"$out/planners-rolling.csv"
{
  "$bin/bench/bench_planners" --count 300 --header
  for n in 1 5 10; do "$bin/bench/bench_planners" --count 300 --cushions $n --only auto; done
  for n in 1 5 10; do "$bin/bench/bench_planners" --count 300 --cushions $n --only "auto --first"; done
  for n in 3 10; do "$bin/bench/bench_planners" --count 300 --cushions $n --sequence --only auto; done
} >"$out/planners-spin.csv"
# From file to file. CPU times are sums over the threads, in microseconds a puzzle.
batch() {  # SET COUNT THREADS FLAGS
  [ -f "$scratch/$1.jsonl" ] || "$bin/bench/batch_puzzles" --set "$1" --count "$2" >"$scratch/$1.jsonl"
  # shellcheck disable=SC2086  # several flags
  build/release/bankshot batch "$scratch/$1.jsonl" -o "$scratch/shots.jsonl" -j "$3" --quiet --no-timing --cost "$scratch/cost.csv" ${4:-}
  [ $header = yes ] && echo "set,threads,flags,$(head -n 1 "$scratch/cost.csv")"
  header=no
  echo "$1,$3,${4:-},$(tail -n 1 "$scratch/cost.csv")"
}
header=yes
{
  batch rolling 1000000 2 --no-robustness
  batch rolling 1000000 1 --no-robustness
  batch rolling 1000000 2
  batch spin 1000000 2 --no-robustness
} >"$out/batch.csv"
# The report's medians, figures and text; its raw numbers, a few megabytes, stay in build/report.
build/release/bankshot report -o build/report
cp build/report/figures/*.svg examples/figures/
for csv in build/report/*.csv; do
  case $csv in *-shots.csv | *-puzzles.csv) ;; *) cp "$csv" "$out/" ;; esac
done
sed -e 's# \[[^]]*-\(shots\|puzzles\)\.csv\]([^)]*)##g' -e 's|(\([^)(]*\.csv\))|(../tests/bench/results/\1)|g' build/report/report.md >examples/report.md
{
  echo "# $(grep -m1 'model name' /proc/cpuinfo | cut -d: -f2- | xargs), $(nproc) cores, $(c++ --version | head -n1), commit $(git rev-parse --short HEAD)"
} >"$out/machine.txt"
[ $failed = 0 ] || { echo "Some of what was measured failed; see FAILED above" >&2; exit 1; }
