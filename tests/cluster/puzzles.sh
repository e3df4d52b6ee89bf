#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Puzzles of mixed difficulty for trying batches in parts, one per line, each with a number of its own. Nine in ten have
# their cushions given and take a tenth of a millisecond or two. The tenth asks for a pocket by 0 to 3 cushions; some of
# these take a hundred times as long. There are 20,000 different puzzles; then they repeat.
#   bash tests/cluster/puzzles.sh COUNT PROGRAM >puzzles.jsonl
set -euo pipefail
count=$1 program=$2
each=$(((count < 20000 ? count : 20000) * 3 / 10 + 1))
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
easy() { "$program" generate --count "$each" --seed "$1" --physics rolling --target stop --cushions "$2"; }
easy 1 top >one
easy 2 top,left >two
easy 3 left,top,right >three
"$program" generate --count $((each / 3 + 1)) --seed 4 --cushions 0-3 >hard
paste -d '\n' one two three | awk '{ print } NR % 9 == 0 && (getline line <"hard") > 0 { print line }' >all
while cat all; do :; done 2>/dev/null | head -n "$count" | awk '{ print "{\"id\":" NR substr($0, index($0, ",")) }'
