#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the commands of a page of docs/ in order: its blocks of bash, python and javascript. Indented blocks are for
# other machines and are skipped. A block of text after a command is its expected output.
#   tests/docs.sh docs/cluster.md            in a temporary folder, with the repository's files beside it
set -euo pipefail
page=$(readlink -f "$1")
root=$(dirname "$(dirname "$page")")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for name in bindings docs examples include; do ln -s "$root/$name" "$folder/$name"; done
awk -v folder="$folder" '
  /^```(bash|python|javascript)$/ { kind = substr($0, 4); n += 1; file = sprintf("%s/block-%02d.%s", folder, n, kind); next }
  /^```text$/ && n { file = sprintf("%s/block-%02d.expected", folder, n); next }
  /^```/ { if (file) close(file); file = ""; next }
  file { print > file }' "$page"
cd "$folder"
found=0
for block in block-*; do
  expected=${block%.*}.expected
  [ "$block" = "$expected" ] && continue
  found=1
  echo "== $(basename "$page"), ${block%.*}"
  case $block in
    *.bash) { echo 'set -eu'; cat "$block"; } | bash ;;
    *.python) python3 "$block" ;;
    *.javascript) mv "$block" "$block.mjs" && node "$block.mjs" ;;
  esac | tee printed
  [ ! -f "$expected" ] || diff "$expected" printed
done
[ "$found" = 1 ] || { echo "$page has no commands" >&2; exit 1; }
