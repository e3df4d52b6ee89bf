#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes examples/puzzles/balls.jsonl: fifty puzzles with other balls, in order of difficulty. There are ten each of
# shots past the balls, shots onto a ball, pots and banks, kick pots, and three-cushion billiards. Each line below
# chooses some puzzles; `bankshot book` draws the page.
set -euo pipefail
cd "$(dirname "$0")/.."
bankshot=${BANKSHOT:-build/release/bankshot}
out=${1:-examples/puzzles/balls.jsonl}

seed=3026
# some COUNT TABLE CUSHIONS TARGET ...
some() {
  seed=$((seed + 1))
  "$bankshot" generate --count "$1" --seed "$seed" --table "$2" --cushions "$3" --target "$4" "${@:5}"
}
past() {
  some 4 pool-9ft 1 pocket --balls 6
  some 3 pool-8ft 2 pocket --balls 8
  some 3 carom-10ft 2-3 stop --balls 5
}
onto() {
  some 4 pool-9ft 1 kick --balls 6
  some 3 pool-7ft 2 kick --balls 7
  some 3 snooker-12ft 1-2 kick --balls 8
}
bank() {
  some 3 pool-9ft 0 pot --balls 5 --difficulty medium
  some 4 pool-9ft 0 pot --balls 4 --then 1
  some 3 pool-8ft 0 pot --balls 3 --then 2
}
kick() {
  some 4 pool-8ft 1 pot --balls 2
  some 3 pool-7ft 2 pot --balls 1
  some 3 pool-9ft 1 pot --balls 2 --then 1
}
three() {
  some 4 carom-10ft 3-6 carom --balls 2 --difficulty medium
  some 6 carom-10ft 3-6 carom --balls 2
}

# Sorts by easy, medium, hard, and only one answer; within each level, the highest success comes first.
sorted() {
  while read -r puzzle; do
    level=$(grep -o '"difficulty":"[a-z]*"' <<<"$puzzle" | sed 's/.*"easy"/1/; s/.*"medium"/2/; s/.*"hard"/3/')
    shots=$("$bankshot" solve --all --json --no-robustness <<<"$puzzle" | grep -o '"miss":' | wc -l)
    [ "$shots" = 1 ] && level=4
    success=$("$bankshot" solve --json <<<"$puzzle" | grep -o '"success":[0-9.e+-]*' | head -n 1 | cut -d: -f2)
    printf '%s\t%s\t%s\n' "$level" "$success" "$puzzle"
  done | LC_ALL=C sort -s -t "$(printf '\t')" -k 1,1n -k 2,2gr | cut -f 3
}
{ past && onto && bank && kick && three; } | sorted |
  awk '{ sub(/"id":"[^"]*"/, sprintf("\"id\":\"balls-%02d\"", NR)); print }' >"$out"
echo "$(wc -l <"$out") puzzles: $out" >&2
