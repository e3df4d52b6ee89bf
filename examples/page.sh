#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes bankshot.html: the page that `bankshot serve` shows, with the engine inside. It opens from a disk and asks
# nobody. Debian's emscripten builds the engine, in some minutes.
#   bash examples/page.sh [FILE]
set -eu
out=${1:-bankshot.html}
case $out in /*) ;; *) out=$PWD/$out ;; esac
cd "$(dirname "$0")/.."
. cmake/packages.sh
need cmake ninja-build ccache emscripten node-acorn esbuild nlohmann-json3-dev libfmt-dev libcli11-dev libeigen3-dev libceres-dev
build wasm
page=src/app/serve/page
esbuild $page/main.js --bundle --format=esm --charset=utf8 --log-level=warning --outfile=build/wasm/page.js
node src/app/serve/wasm/one_file.mjs $page build/wasm/page.js build/wasm src/app/serve/wasm/worker.js >build/wasm/one_file.html
mv build/wasm/one_file.html "$out"
echo "$out: $(wc -c <"$out") bytes" >&2
