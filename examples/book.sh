#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes examples/puzzles/book.jsonl: 100 puzzles in order of difficulty: 30 easy, 30 medium, 30 hard and 10
# with exactly one shot, each part from the highest success to the lowest. Each line below chooses some
# puzzles; `bankshot book` draws the page.
set -euo pipefail
cd "$(dirname "$0")/.."
bankshot=${BANKSHOT:-build/release/bankshot}
out=${1:-examples/puzzles/book.jsonl}

ell='{"vertices": [[0, 0], [2, 0], [2, 0.9], [1, 0.9], [1, 1.8], [0, 1.8]], "names": ["south", "east", "step", "wall", "north", "west"]}'
hexagon='{"vertices": [[0.5, 0], [1.5, 0], [2, 0.866], [1.5, 1.732], [0.5, 1.732], [0, 0.866]], "pockets": [{"name": "left", "at": [0, 0.866], "radius": 0.07}, {"name": "right", "at": [2, 0.866], "radius": 0.07}]}'
triangle='{"vertices": [[0, 0], [2.2, 0], [1.1, 1.6]], "names": ["floor", "right", "left"], "pockets": [{"name": "well", "at": [1.1, 0.55], "radius": 0.06}]}'
kite='{"vertices": [[0, 0.7], [0.8, 0], [2.4, 0.7], [0.8, 1.4]], "names": ["south-west", "south-east", "north-east", "north-west"]}'
moat='{"length": 2.4, "width": 1.2, "pockets": [{"name": "well", "at": [1.2, 0.6], "radius": 0.07}]}'
slow='{"model": "spin", "sliding_friction": 0.25, "rolling_friction": 0.015}'
lively='{"model": "spin", "cushion": {"restitution": 0.92, "friction": 0.15}}'
mathavan='{"model": "spin", "cushion": {"model": "mathavan2010", "friction": 0.14, "restitution": 0.9}}'

seed=2026
# some COUNT TABLE PHYSICS CUSHIONS TARGET [--unique]
some() {
  seed=$((seed + 1))
  # shellcheck disable=SC2086  # a level is several words
  "$bankshot" generate --count "$1" --seed "$seed" --table "$2" --physics "$3" --cushions "$4" --target "$5" "${@:6}" $level
}
easy() {
  level="--difficulty easy"
  some 3 pool-7ft rolling 0 pocket
  some 3 pool-9ft spin 0 pocket
  some 3 pool-8ft spin 1 pocket
  some 2 pool-7ft spin bottom pocket
  some 3 pool-9ft rolling 1 pocket
  some 2 snooker-12ft spin 0 pocket
  some 2 seed ideal 1-2 pass
  some 2 carom-10ft spin 1 pass
  some 2 carom-10ft rolling 2 pass
  some 2 "$hexagon" ideal 1-2 pocket
  some 2 "$moat" rolling 1 pocket
  some 2 "$ell" rolling 1 pass
  some 2 pool-8ft spin 2 pocket
}
medium() {
  level="--difficulty medium"
  some 3 pool-9ft spin 1-2 pocket
  some 1 pool-8ft rolling top,right pocket
  some 1 pool-7ft rolling left,top pocket
  some 3 pool-7ft spin 2-3 pocket
  some 3 snooker-12ft spin 1-2 pocket
  some 2 snooker-12ft rolling 2 pocket
  some 3 carom-10ft spin 3 pass
  some 2 carom-10ft "$lively" 3 pass
  some 2 "$hexagon" spin 2 pocket
  some 2 "$triangle" rolling 1-3 pocket
  some 2 "$kite" rolling 2-3 pass
  some 2 "$ell" spin 1-2 pass
  some 2 "$moat" spin 2-3 pocket
  some 2 pool-9ft "$mathavan" 1-2 pocket
}
hard() {
  level="--difficulty hard"
  some 3 pool-9ft spin 3 pocket
  some 2 pool-8ft spin 4 pocket
  some 1 pool-9ft spin left,top,right pocket
  some 1 pool-8ft spin bottom,top,right pocket
  some 3 snooker-12ft spin 2-3 pocket
  some 2 snooker-12ft "$slow" 1 stop
  some 3 carom-10ft spin 3 stop
  some 2 carom-10ft "$lively" 4-5 pass
  some 2 seed rolling 2 stop
  some 2 seed ideal 5 pass
  some 2 "$ell" spin 3 pass
  some 2 "$kite" spin 2 stop
  some 2 "$triangle" spin 3 stop
  some 2 pool-7ft rolling 5 pocket
  some 1 pool-9ft "$mathavan" 2 stop
}
unique() {
  level="--unique --difficulty medium"
  some 1 pool-9ft spin 1 pocket
  some 1 pool-8ft rolling 2 pocket
  some 1 snooker-12ft spin 1 pocket
  some 1 pool-9ft rolling left,bottom pocket
  some 1 "$hexagon" spin 2 pocket
  some 1 "$ell" spin 2 pass
  level="--unique --difficulty hard"
  some 1 pool-7ft spin left,top,right pocket
  some 1 pool-9ft spin top,bottom,top,bottom pass
  some 1 carom-10ft spin left,right,left stop
  some 1 "$kite" rolling south-east,north-west,south-west stop
}

# Sorts by success, the highest first.
sorted() {
  while read -r puzzle; do
    success=$("$bankshot" solve --json <<<"{\"aim\": \"centre\", ${puzzle#\{}" | grep -o '"success":[0-9.e+-]*' | head -n 1 | cut -d: -f2)
    printf '%s\t%s\n' "$success" "$puzzle"
  done | LC_ALL=C sort -s -t "$(printf '\t')" -k 1,1gr | cut -f 2
}
for part in easy medium hard unique; do $part | sorted; done |
  awk '{ sub(/"id":"[^"]*"/, sprintf("\"id\":\"book-%03d\"", NR)); print }' >"$out"
echo "$(wc -l <"$out") puzzles: $out" >&2
