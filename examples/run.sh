#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs missing packages, builds the program and answers README's puzzle. Then builds and runs the examples, and
# writes their pictures to examples/figures/.
set -euo pipefail
cd "$(dirname "$0")/.."
. cmake/packages.sh
need $toolchain
bin=build/release
build release -DBANKSHOT_TESTS=OFF -DBANKSHOT_BENCH=OFF -- bankshot
"$bin/bankshot" solve examples/puzzles/first-shot.json --svg examples/figures/first-shot.svg
echo "The picture is examples/figures/first-shot.svg. Now the other examples:"
build release -DBANKSHOT_TESTS=OFF -DBANKSHOT_BENCH=OFF
for puzzle in examples/puzzles/*.json; do
  name=$(basename "$puzzle" .json)
  echo "== $name"
  more=()
  [ "$name" = three-cushion-carom ] && more=(--animate)
  # A puzzle without a shot exits with 1.
  "$bin/bankshot" solve "$puzzle" --svg "examples/figures/$name.svg" "${more[@]}" | tee "examples/puzzles/$name.txt" || [ $? = 1 ]
done
for example in "$bin"/examples/[0-9]*; do
  [ -x "$example" ] || continue
  echo "== $(basename "$example")"
  "$example" "examples/figures/$(basename "$example").svg"
done
echo "== where the two-cushion bank can be played from"
"$bin/bankshot" map examples/puzzles/two-cushion-bank.json --grid 40 20 -o examples/figures/two-cushion-map.svg
echo "== what a corner takes"
"$bin/bankshot" pocket pool-9ft bottom-left -o examples/figures/pocket.svg
echo "== the puzzle book"
"$bin/bankshot" book examples/puzzles/book.jsonl -o examples/figures/book.svg
echo "== the book with other balls"
"$bin/bankshot" book examples/puzzles/balls.jsonl -o examples/figures/balls.svg
echo "Pictures: examples/figures/*.svg"
