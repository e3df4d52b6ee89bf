#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Repeats the measurements that README and docs/evidence.md quote, into tests/bench/results/*.csv:
# all of them, which takes hours, or the named ones, each a file of that name (`report` writes the files with numbers).
#   bash tests/bench/run.sh [simulate|solve|mathavan|stress|families|balls|play|knock|page|javascript|best|questions|properties|leaves|success|position|runouts|shots|all-shots|planners-rolling|planners-spin|pockets|acceptance|breaks|learn|learn-times|advise|batch|cluster|tunables|python|pooltool|recorded|report ...]
set -euo pipefail
cd "$(dirname "$0")/../.."
. cmake/packages.sh
need $toolchain catch2 libbenchmark-dev gnuplot-nox
build release -DBANKSHOT_TESTS=ON -DBANKSHOT_BENCH=ON
bankshot=build/release/bankshot bin=build/release/tests out=tests/bench/results
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=0

google() {  # FILTER
  "$bin/bench/bench" --benchmark_filter="$1" --benchmark_format=csv --benchmark_repetitions=5 \
    --benchmark_report_aggregates_only=true 2>/dev/null
}
# Every puzzle has a shot. A failure is shown on standard error and counted. It does not stop the measurement, but
# the script ends with 1.
measure() {
  "$bin/stress" --csv "$@" >"$scratch/measured.csv" || failed=1
  if [ $header = yes ]; then cat "$scratch/measured.csv"; else tail -n +2 "$scratch/measured.csv"; fi
  header=no
}
# Here the misses are the measurement, so they are no failures.
look() {  # LOG ...
  local before=$failed
  measure "${@:2}" 2>"build/$1.log"
  failed=$before
}
# Prints the rows of a program with the seed before each.
seeded() {  # SEED PROGRAM ...
  "$bin/$2" --seed "$1" "${@:3}" 2>"build/$2-$1.log" >"$scratch/seeded.csv" || failed=1
  [ $header = no ] || sed '1s/^/seed,/;q' "$scratch/seeded.csv"
  header=no
  sed "1d;s/^/$1,/" "$scratch/seeded.csv"
}
# Measures `batch` from file to file. CPU times are sums over the threads, in microseconds per puzzle.
answer() {  # SET COUNT THREADS FLAGS
  "$bin/bench/batch_puzzles" --set "$1" --count "$2" >"$scratch/puzzles.jsonl"
  # shellcheck disable=SC2086  # several flags
  "$bankshot" batch "$scratch/puzzles.jsonl" -o "$scratch/shots.jsonl" -j "$3" --quiet --no-timing --cost "$scratch/cost.csv" ${4:-}
  [ $header = yes ] && echo "set,threads,flags,$(head -n 1 "$scratch/cost.csv")"
  header=no
  echo "$1,$3,${4:-},$(tail -n 1 "$scratch/cost.csv")"
}

# Runs a script with the interpreter that the module was built for.
python_module() {  # SCRIPT ARG...
  need $python
  build release -DBANKSHOT_PYTHON=ON -- bankshot_python
  PYTHONPATH=build/release/bindings/python${PYTHONPATH:+:$PYTHONPATH} \
    "$(sed -n 's/^_Python3_EXECUTABLE:INTERNAL=//p' build/release/CMakeCache.txt)" "tests/bench/$1" "${@:2}"
}

part() {
  local name more n physics family free planner
  header=yes
  case $1 in
    simulate) google '^(simulate|locked)' ;;
    solve) google '^(rolling|ideal|spin)_' ;;
    mathavan) google '^mathavan' ;;
    stress)
      for physics in ideal rolling mathavan; do measure --count 100000 --physics $physics; done
      for physics in spin stronge; do measure --count 1000000 --physics $physics; done
      measure --count 10000 --physics tilted
      ;;
    families)
      for physics in spin rolling; do
        for family in $("$bin/stress" --family list | tail -n +5 | cut -d' ' -f1); do
          [ "$physics/$family" = rolling/spin-range ] ||
            look "families-$physics-$family" --count 1000 --physics $physics --family "$family"
        done
      done
      ;;
    balls)
      for physics in ideal rolling spin mathavan; do
        n=10000
        [ $physics = mathavan ] && n=100
        # One ball and three cushions, for comparison.
        look "balls-$physics-uniform" --count $n --physics $physics --family uniform --cushions 3
        for family in obstacles kicks pots banks kick-pots kick-banks sent-to-rest sent-past combinations caroms; do
          [ $physics/$family = ideal/sent-to-rest ] || look "balls-$physics-$family" --count $n --physics $physics --family "$family"
        done
      done
      ;;
    best)  # The brute force takes 0.1 to 1 s per puzzle.
      "$bin/best" --count 20000 --physics spin --free nothing --no-force --worst 0
      "$bin/best" --count 20000 --physics rolling --free nothing --no-force --worst 0 --no-header
      for free in nothing window arrive spin both; do "$bin/best" --count 1000 --seed 2 --free $free --worst 0 --no-header; done
      for free in nothing window arrive; do "$bin/best" --count 1000 --seed 2 --physics rolling --free $free --worst 0 --no-header; done
      ;;
    leaves)  # Nobody tuned for these seeds.
      "$bin/leaves" --count 1000 --seed 505 --plays 10000 --csv "$scratch/table" >/dev/null
      cat "$scratch/table"
      "$bin/leaves" --count 1000 --seed 606 --others 3 --plays 10000 --csv "$scratch/table" >/dev/null
      tail -n +2 "$scratch/table"
      ;;
    success)  # Nobody tuned for this seed.
      "$bin/success" --count 200 --seed 90411 --plays 20000 --csv "$scratch/table" >/dev/null
      cat "$scratch/table"
      ;;
    runouts)  # Who thinks of the next ball clears more tables.
      head=1
      match() {  # BALLS NOISE LAYOUTS TIP PLAYER...
        "$bin/runouts" --balls "$1" --noise "$2" --layouts "$3" --tip "$4" --seed 31 -j "$(nproc)" --player "${@:5}" --csv "$scratch/table" >/dev/null
        tail -n +$head "$scratch/table"
        head=2
      }
      for noise in strong weak; do
        for balls in 2 3 4; do match $balls $noise 1000 0 play; done
        match 6 $noise 1000 0 play spin solve
        match 6 $noise 1000 0.0005 play
      done
      match 4 strong 400 0 two-plies
      ;;
    position)  # Brute force by the plain simulator.
      head=1
      for asked in "nearest 200 75 0" "hand 100 74 0" "snooker 200 72 3" "value 200 71 5"; do
        read -r what count seed others <<<"$asked"
        "$bin/position" --ask "$what" --count "$count" --seed "$seed" --others "$others" -j "$(nproc)" --csv "$scratch/table" >/dev/null
        tail -n +$head "$scratch/table"
        head=2
      done
      ;;
    questions)  # Typed as a player would, on layouts that nobody tuned for.
      "$bin/questions" --program "$bankshot" --seed 77 -j "$(nproc)" --csv "$scratch/table" >/dev/null
      cat "$scratch/table"
      ;;
    properties)  # What fails is the measurement.
      "$bin/properties" --count 100 --seed 90210 --max-balls 3 --shrink 0 -j "$(nproc)" --csv "$scratch/table" >/dev/null 2>build/properties.log || true
      cat "$scratch/table"
      ;;
    advise)  # The players of seed 1 served to tune `advise`, those of seed 2 did not.
      seeded 1 advise --repeats 200 --attempts 50 --threads 1 --csv
      seeded 1 advise --repeats 60 --attempts 200 --threads 1 --csv
      seeded 2 advise --repeats 60 --attempts 200 --threads 1 --csv
      ;;
    learn)  # Over 1,000 s of one core. Some tables of seed 1 served to tune `fit`, those of seed 3 did not.
      seeded 1 learn --repeats 53 --shots 30 --threads 1 --csv
      seeded 1 learn --from 100 --repeats 49 --shots 30 --threads 1 --csv
      seeded 3 learn --repeats 50 --shots 30 --threads 1 --csv
      ;;
    learn-times)
      echo shots,fits,cpu_s
      for n in 10 30; do
        seconds=$(TIMEFORMAT=%U; { time "$bin/learn" --repeats 3 --shots $n --threads 1 --seed 5 >/dev/null 2>&1 || true; } 2>&1)
        awk -v n=$n -v s="$seconds" 'BEGIN { printf "%d,3,%.2f\n", n, s / 3 }'
      done
      ;;
    knock) "$bin/knock" --csv || failed=1 ;;
    play)
      for seed in 1 2 3 4 5; do "$bin/play" --layouts 20 --seed $seed --csv 2>build/play-$seed.log || true; done | awk '!seen[$0]++'
      ;;
    shots) "$bin/shots" --count 1000000 --seed 1 --truth 10000 --csv || failed=1 ;;
    all-shots) "$bin/test_plan" "the map misses hardly a shot with three to five cushions" | grep -E '^(cushions|[0-9]+),' ;;
    pockets)
      more=--header
      for physics in spin rolling; do
        for kind in "" --jaws; do
          # shellcheck disable=SC2086  # flags that may be none
          "$bin/bench/pockets" --count 100000 --physics $physics $kind $more 2>"build/pockets-$physics$kind.log" || failed=1
          more=
        done
      done
      ;;
    breaks) "$bin/bench/breaks" --count 2000 ;;
    acceptance)
      echo table,pocket,pockets,speed_m_per_s,angle_deg,clean_mm,drop_mm
      for table in pool-7ft pool-8ft pool-9ft snooker-12ft; do
        for jaws in true false; do
          for pocket in "bottom-left 0|20|35" "bottom-middle 0|30|50"; do
            "$bankshot" pocket "{\"preset\": \"$table\", \"jaws\": $jaws}" ${pocket% *} --speed 1 3 -o "$scratch/window.csv" >"$scratch/text"
            kind=circles
            [ $jaws = true ] && kind=jaws
            awk -F, -v row="$table,${pocket% *},$kind" -v angles="^(${pocket#* })\$" '
              $2 ~ angles { key = $1 "," $2; if (!(key in clean)) order[++n] = key
                            clean[key] += ($4 == "clean") / 2; drop[key] += ($4 == "clean" || $4 == "rattles-in") / 2 }
              END { for (i = 1; i <= n; ++i) print row "," order[i] "," clean[order[i]] "," drop[order[i]] }' "$scratch/window.csv"
          done
        done
      done
      ;;
    page)  # In Chromium.
      need chromium
      bash examples/page.sh build/wasm/bankshot.html
      (cd tests/page && npm ci --silent --no-audit --no-fund && node timing.mjs)
      ;;
    javascript)  # In Node.
      bash bindings/javascript/package.sh build/wasm/npm
      (cd tests/page && npm ci --silent --no-audit --no-fund && node engine_timing.mjs)
      ;;
    planners-rolling)  # Not every planner looks for partial targets.
      for planner in auto image sweep ceres nlopt-bobyqa nlopt-direct; do
        look "planners-rolling-$planner" --count 2000 --seed 2 --physics rolling --family uniform --planner $planner
      done
      ;;
    planners-spin)
      "$bin/bench/bench_planners" --count 300 --header
      for name in auto "auto --first"; do
        for more in "" " with margin and success"; do
          for n in 1 5 10; do "$bin/bench/bench_planners" --count 300 --cushions $n --only "$name$more"; done
          for n in 3 10; do "$bin/bench/bench_planners" --count 300 --cushions $n --sequence --only "$name$more"; done
          for n in 0 1 2 3; do "$bin/bench/bench_planners" --count 300 --cushions $n --pocket --only "$name$more"; done
          [ -z "$more" ] ||
            for n in 0 1 2 3; do "$bin/bench/bench_planners" --count 300 --cushions $n --pocket --centre --only "$name$more"; done
        done
      done
      ;;
    tunables) python3 tests/bench/tunables.py -j "$(nproc)" ;;  # builds the program with every number read at the start
    python) python_module python_calls.py "$bin/bench/one_call" ;;
    pooltool) python_module pooltool_shots.py ;;  # where it can be imported
    recorded) python3 tests/bench/recorded.py "$bankshot" "$RECORDINGS" ;;  # tracked shots; none are in this repository
    batch)
      answer rolling 1000000 2 --no-robustness
      answer rolling 1000000 1 --no-robustness
      answer rolling 200000 2
      answer spin 100000 2 --no-robustness
      answer spin 100000 2
      ;;
    cluster)  # In both orders: mixed, and the easy puzzles before the hard ones.
      bash tests/cluster/puzzles.sh 100000 "$bankshot" >"$scratch/mixed.jsonl"
      { grep '"rolling"' "$scratch/mixed.jsonl"; grep -v '"rolling"' "$scratch/mixed.jsonl"; } >"$scratch/grouped.jsonl"
      python3 tests/bench/cluster.py "$bankshot" "$scratch/mixed.jsonl"
      python3 tests/bench/cluster.py "$bankshot" "$scratch/grouped.jsonl" --order grouped | tail -n +2
      ;;
    *) echo "no part is called $1" >&2 && exit 2 ;;
  esac
}

# Copies the report's medians, figures and text; its raw numbers, a few megabytes, stay in build/report.
report() {
  "$bankshot" report -o build/report
  cp build/report/figures/*.svg examples/figures/
  for csv in build/report/*.csv; do
    case $csv in *-shots.csv | *-puzzles.csv) ;; *) cp "$csv" "$out/" ;; esac
  done
  sed -e 's# \[[^]]*-\(shots\|puzzles\)\.csv\]([^)]*)##g' -e 's|(\([^)(]*\.csv\))|(../tests/bench/results/\1)|g' build/report/report.md >examples/report.md
}

[ $# -gt 0 ] || set -- simulate solve mathavan stress families balls play knock page javascript best questions properties leaves success position runouts shots all-shots planners-rolling planners-spin pockets acceptance learn learn-times advise batch cluster python report
for name; do
  if [ "$name" = report ]; then
    report
  else
    part "$name" >"$scratch/$name.csv"
    mv "$scratch/$name.csv" "$out/"
  fi
done
echo "# $(grep -m1 'model name' /proc/cpuinfo | cut -d: -f2- | xargs), $(nproc) cores, $(c++ --version | head -n1), commit $(git rev-parse --short HEAD)" >"$out/machine.txt"
[ $failed = 0 ] || { echo "Some of what was measured failed; see FAILED above" >&2; exit 1; }
