#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes the npm package: a folder for `npm install FOLDER` and `npm pack FOLDER`. Debian's emscripten builds the engine
# in a few minutes.
#   bash bindings/javascript/package.sh [FOLDER]
set -eu
out=${1:-bankshot-js}
case $out in /*) ;; *) out=$PWD/$out ;; esac
cd "$(dirname "$(readlink -f "$0")")/../.."
. cmake/packages.sh
need cmake ninja-build ccache emscripten node-acorn esbuild nlohmann-json3-dev libfmt-dev libcli11-dev libeigen3-dev libceres-dev
build wasm
here=bindings/javascript
mkdir -p "$out"
for name in index worker; do
  esbuild $here/$name.js --bundle --format=esm --charset=utf8 --log-level=warning \
    --alias:bankshot-engine="$PWD/build/wasm/engine.js" --outfile="$out/$name.js"
done
cp build/wasm/engine.wasm "$out/bankshot.wasm"
cp $here/package.json $here/index.d.ts docs/format.md docs/csv.md LICENSE "$out/"
cp docs/javascript.md "$out/README.md"
node $here/types.mjs "$out" >"$out/documents.d.ts"
echo "$out" >&2
