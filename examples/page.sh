#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes bankshot.html: the page of `bankshot serve` with the engine inside. It opens from a disk and needs no network.
# Debian's emscripten builds the engine in a few minutes.
#   bash examples/page.sh [FILE]
set -eu
out=${1:-bankshot.html}
case $out in /*) ;; *) out=$PWD/$out ;; esac
cd "$(dirname "$0")/.."
bash bindings/javascript/package.sh build/wasm/npm
wasm=src/app/serve/wasm
esbuild $wasm/page.js --bundle --format=esm --charset=utf8 --log-level=warning --outfile=build/wasm/page.js
node $wasm/one_file.mjs src/app/serve/page build/wasm/page.js build/wasm/npm >build/wasm/one_file.html
mv build/wasm/one_file.html "$out"
echo "$out: $(wc -c <"$out") bytes" >&2
