#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs missing packages, builds, and runs all tests or those of some folders of tests/. A test that takes more than
# 20 minutes is stopped and named, so that one that hangs is known.
#   bash tests/run.sh [PRESET [FOLDER...]]     release (the default), debug, asan-ubsan, lto ...
set -euo pipefail
cd "$(dirname "$0")/.."
. cmake/packages.sh
need $toolchain catch2 libbenchmark-dev gnuplot-nox chromium python3-jsonschema jq $python
preset=${1:-release}
case $preset in asan-ubsan | fuzz) need clang ;; esac
[ $# -gt 0 ] && shift
run_tests() {
  ctest --test-dir "build/$preset" --timeout 1200 --output-on-failure -j "$(nproc)" "$@"
}
if [ $# = 0 ]; then
  build "$preset" -DBANKSHOT_TESTS=ON -DBANKSHOT_PYTHON=ON
  run_tests
else
  build "$preset" -DBANKSHOT_TESTS=ON -DBANKSHOT_PYTHON=ON -- $(printf 'test_%s ' "$@")
  folders=$(IFS='|' && echo "$*")
  run_tests --no-tests=error -R "^($folders):"
fi
